"""The simplices round a vertex, and what else is made of a few things by a finite group of reflections.

The group permutes vertices, normals, and so on: few things. What is made of them, as a simplex of vertices,
is a row of their numbers. The rows follow coset by coset, each a permutation of another: none is looked up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from .feasible import Floats
from .rows import codes, distinct, flood
from .subgroups import Ints

if TYPE_CHECKING:
    from .alcoves import Alcoves
    from .grid import Grid

Mirror = Callable[[Ints], Ints]


@dataclass(frozen=True, eq=False)
class Star:
    """The simplices round the origin, and what they share.

    Attributes
    ----------
    keys
        Those of the n simplices.
    points, corners
        Their vertices, each once, times the unit; and which of them a simplex has, shape (n, d + 1).
    normals, sides
        The gradients of their barycentric coordinates in R^d, each once; and which a simplex has.
    """

    keys: Ints
    points: Ints
    corners: Ints
    normals: Floats
    sides: Ints


def star_of(grid: Grid) -> Star:
    """The simplices round the origin."""
    gram, count = grid.triangulation._gradient_gram, grid.dimension + 1
    mirrors = mirrors_of(grid, grid._corners)[1:]
    points, corner, moves = permuted(grid._corners, mirrors)
    gradients, side, turns = permuted(gram.numerators.astype(np.int64) @ grid._corners, mirrors)
    both = [np.concatenate([a, b + len(points)]) for a, b in zip(moves, turns, strict=True)]
    rows = images(np.concatenate([corner, side + len(points)]), both, corner[1:])
    corners = np.asfortranarray(rows[:, :count])  # they are looked at by labels
    sides = np.asfortranarray(rows[:, count:] - len(points))
    normals = grid.frame.turned(gradients / (gram.denominator * grid.vertex_unit)) / grid.frame.scale**2
    return Star(keys_of(grid, points, corners, 0 * points[0]), points, corners, normals, sides)


def star_round(grid: Alcoves, corners: Ints, label: int) -> Ints:
    """The keys of the simplices round a vertex of one, given by its corners; in lexicographic order.

    The mirrors before one fix all corners but those across from them: so its own will do as a witness.
    """
    others = [k for k in range(len(corners)) if k != label]
    seen = (corners - corners[label]).astype(np.int64)
    mirrors = mirrors_of(grid, seen)
    points, corner, moves = permuted(seen, [mirrors[k] for k in others])
    there = corners[label] * grid.key_unit
    whole = there // grid.vertex_unit  # perhaps too large for int64, unlike what is left
    rest = (there - whole * grid.vertex_unit).astype(np.int64)
    keys = keys_of(grid, points, images(corner, moves, corner[others]), rest)
    return np.asarray(keys[np.argsort(codes(keys))] + whole)


def keys_of(grid: Alcoves, points: Ints, corners: Ints, rest: Ints) -> Ints:
    """The centres of simplices with given corners among the points, seen from a vertex; and its fractions."""
    shares = points * (12 * np.array(grid.triangulation.marks))[:, None, None]
    total = np.broadcast_to(rest, (len(corners), len(rest))).copy()
    for k, share in enumerate(shares):
        total += share[corners[:, k]]
    return np.asarray(total // grid.vertex_unit)


# -- groups -------------------------------------------------------------------------------------------------


def mirrors_of(grid: Alcoves, corners: Ints) -> list[Mirror]:
    """The reflections in hyperplanes through the origin that are parallel to the facets of a simplex."""
    gradients = grid.triangulation._gradient_gram.numerators.astype(np.int64) @ corners
    normals = gradients // np.gcd.reduce(gradients, axis=1)[:, None]
    return [partial(_reflect, normal) for normal in normals]


def _reflect(normal: Ints, rows: Ints) -> Ints:
    """The mirror images; the normal has no divisor, so that they are integers if 2 <x, n> / <n, n> are."""
    return np.asarray(rows - (2 * (rows @ normal) // (normal @ normal))[:, None] * normal)


def reached(start: Ints, around: Mirror) -> Ints:
    """All that some rows lead to."""
    found = flood(start, around)
    assert found is not None
    return found


def orbit(row: Ints, mirrors: Iterable[Mirror]) -> Ints:
    """The images of a row under the group that some mirrors generate, in lexicographic order."""
    mirrors = list(mirrors)
    return reached(row[None], lambda rows: np.concatenate([mirror(rows) for mirror in mirrors]))


def permuted(rows: Ints, mirrors: list[Mirror]) -> tuple[Ints, Ints, list[Ints]]:
    """The images of rows under a group, each once; the numbers of the rows, and how each mirror permutes."""
    found = reached(rows, lambda rows: np.concatenate([mirror(rows) for mirror in mirrors]))
    moves = [np.argsort(np.argsort(codes(mirror(found)))) for mirror in mirrors]
    start = distinct(np.concatenate([found, rows]))[1][len(found) :]
    return found, start, moves


def images(row: Ints, moves: list[Ints], witnesses: Ints) -> Ints:
    """The images of a row of numbers under a group, each as often as there are elements that lead to it.

    Parameters
    ----------
    row
        Numbers of things.
    moves
        How mirrors that generate the group permute the things.
    witnesses
        For each mirror a thing that it moves, and that in the group of all mirrors so far only the group of
        those before fixes. So its images stand for cosets.
    """
    rows = row[None]
    for k, witness in enumerate(witnesses.tolist(), 1):
        cosets, todo = {witness: rows}, [witness]
        for thing in todo:  # which grows
            for move in moves[:k]:
                if (image := int(move[thing])) not in cosets:
                    cosets[image] = move[cosets[thing]]
                    todo.append(image)
        rows = np.concatenate(list(cosets.values()))
    return rows
