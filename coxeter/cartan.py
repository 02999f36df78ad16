"""Diagrams as sparse tables of Cartan integers, and what can be read off them node by node.

``neighbours[i][j]`` is the Cartan integer n(s_i, s_j) = 2<s_i, s_j>/<s_j, s_j>, for the pairs i != j
where it is not zero. A connected diagram whose form is positive definite is a tree, so Gaussian elimination
from its leaves inwards has no fill-in: everything here costs as much as the diagram has nodes.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterable
from fractions import Fraction

Neighbours = dict[int, dict[int, int]]


def restrict(neighbours: Neighbours, nodes: Iterable[int]) -> Neighbours:
    """The part of a diagram on some of its nodes."""
    kept = set(nodes)
    return {i: {j: n for j, n in neighbours[i].items() if j in kept} for i in kept}


def walk(neighbours: Neighbours, start: int) -> tuple[list[int], dict[int, int]]:
    """The nodes that can be reached from one, each after the neighbour it is reached from, its parent."""
    order, parent = [start], {start: start}
    for i in order:
        for j in neighbours[i]:
            if j not in parent:
                parent[j] = i
                order.append(j)
    return order, parent


def components(neighbours: Neighbours) -> list[Neighbours]:
    """The connected components of a diagram."""
    left, found = set(neighbours), []
    while left:
        part, _ = walk(neighbours, min(left))
        left -= set(part)
        found.append({i: neighbours[i] for i in part})
    return found


def eliminate(neighbours: Neighbours) -> tuple[list[int], dict[int, int], dict[int, Fraction]]:
    """Gaussian elimination of the Cartan matrix of a tree, from the leaves inwards.

    Returns the nodes from the root of the tree outwards, each node's parent (the root's is itself),
    and the pivots.
    """
    order, parent = walk(neighbours, min(neighbours))
    pivot = dict.fromkeys(order, Fraction(2))
    for i in reversed(order[1:]):
        p = parent[i]
        pivot[p] -= neighbours[i][p] * neighbours[p][i] / pivot[i]
    return order, parent, pivot


def determinant(neighbours: Neighbours) -> int:
    """The determinant of the Cartan matrix of a tree."""
    return int(math.prod(eliminate(neighbours)[2].values(), start=Fraction(1)))


def longest(neighbours: Neighbours) -> int:
    """A node whose simple root is among the longest: ``|s_i|²/|s_j|² = n(s_i, s_j)/n(s_j, s_i)``."""
    order, parent = walk(neighbours, min(neighbours))
    length = {order[0]: Fraction(1)}
    for i in order[1:]:
        p = parent[i]
        length[i] = length[p] * neighbours[i][p] / neighbours[p][i]
    return max(order, key=lambda i: (length[i], -i))


def climb(neighbours: dict[int, dict[int, int]], start: int) -> dict[int, int]:
    """The dominant root above a simple root, as coefficients in the simple roots.

    Parameters
    ----------
    neighbours
        ``neighbours[i][j]`` is the Cartan integer n(s_i, s_j), for the pairs i != j where it is not 0.
    start
        The simple root to start from. Simple reflections that add a positive multiple of a simple
        root are applied until none does.
    """
    coefficients = dict.fromkeys(neighbours, 0)
    coefficients[start] = 1
    pairing = {start: 2} | neighbours[start]  # j -> n(r, s_j) for the current root r
    todo = deque(pairing)
    while todo:
        j = todo.popleft()
        step = -pairing.get(j, 0)
        if step <= 0:
            continue
        coefficients[j] += step
        for k, n in ({j: 2} | neighbours[j]).items():
            pairing[k] = pairing.get(k, 0) + step * n
            todo.append(k)
    return coefficients


def reflection_group_order(neighbours: Neighbours) -> int:
    """The order of the finite reflection group of a diagram.

    For each component it is n! · f · (product of the marks of the highest root), with n the number of
    nodes and f the determinant of the Cartan matrix. Source: Bourbaki, *Lie*, VI, §2.4, Proposition 7;
    Humphreys, Section 4.9.

    >>> reflection_group_order({1: {2: -1}, 2: {1: -1}, 3: {}})
    12
    """
    return math.prod(
        math.factorial(len(part)) * determinant(part) * math.prod(climb(part, longest(part)).values())
        for part in components(neighbours)
    )
