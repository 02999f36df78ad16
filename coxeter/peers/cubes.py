"""Subdivisions of the cube, cell by cell. Reflecting a cube in its facets carries each over all of space.

A cell is a list of d + 1 vertices. The generators of all cells are for checks in small dimensions; the
classes have one cell for each shape, and cost little in any dimension.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import accumulate, permutations, product
from typing import TypeVar

from ..exact import Exact

N = TypeVar("N", Fraction, Exact)
Point = tuple[Fraction, ...]
Cell = list[Point]


def unit(d: int, i: int, length: Fraction | int = 1) -> Point:
    """The i-th unit vector, stretched."""
    return tuple(Fraction(length) if k == i else Fraction(0) for k in range(d))


def walk(start: tuple[N, ...], steps: Sequence[tuple[N, ...]]) -> list[tuple[N, ...]]:
    """The points that one passes from a start, step by step."""
    return list(accumulate(steps, _plus, initial=start))


def _plus(x: tuple[N, ...], y: tuple[N, ...]) -> tuple[N, ...]:
    return tuple(a + b for a, b in zip(x, y, strict=True))


def _all(d: int, value: Fraction | int) -> Point:
    return (Fraction(value),) * d


# -- paths: K1, J1, barycentric ---------------------------------------------------------------------------


def kuhn(d: int) -> Iterator[Cell]:
    """K1: the d! monotone paths from 0 to (1, …, 1) along the edges of the unit cube."""
    for order in permutations(range(d)):
        yield walk(_all(d, 0), [unit(d, i) for i in order])


def union_jack(d: int) -> Iterator[Cell]:
    """J1 on the cube [-1, 1]^d: the paths from its centre to its corners along the axes."""
    for signs in product((1, -1), repeat=d):
        for order in permutations(range(d)):
            yield walk(_all(d, 0), [unit(d, i, signs[i]) for i in order])


def barycentric(d: int) -> Iterator[Cell]:
    """The barycentric subdivision of the unit cube: a corner, the centres of larger and larger faces."""
    for corner in product((0, 1), repeat=d):
        for order in permutations(range(d)):
            steps = [unit(d, i, Fraction(1 - 2 * corner[i], 2)) for i in order]
            yield walk(tuple(map(Fraction, corner)), steps)


def path(d: int, length: Fraction = Fraction(1)) -> list[Cell]:
    """The one shape of these three: a path of d orthogonal steps of equal length."""
    return [walk(_all(d, 0), [unit(d, i, length) for i in range(d)])]


# -- D1 ---------------------------------------------------------------------------------------------------


def dang(d: int) -> Iterator[Cell]:
    """D1 on the unit cube: the corner at 0, and the simplices of `_descent` for all orders of the steps.

    Source: Dang 1991, with vertices y + s_i e_i and descents from y + s, here for y = 0 and s = (1, …, 1).
    """
    yield _descent(d, None)
    for steps in range(d - 1):
        for order in permutations(range(d), steps):
            yield _descent(d, order)


def dang_classes(d: int) -> list[Cell]:
    """D1 has d shapes, but for d = 2 and 3 one less: there the longest descent ends in a corner too."""
    longest = d - 2 if d > 3 else d - 3
    return [_descent(d, None), *(_descent(d, tuple(range(steps))) for steps in range(longest + 1))]


def _descent(d: int, order: tuple[int, ...] | None) -> Cell:
    """From (1, …, 1) down along some axes; then the unit vectors of the other axes.

    Without an order: 0 and all unit vectors.
    """
    if order is None:
        return [_all(d, 0), *(unit(d, i) for i in range(d))]
    down = walk(_all(d, 1), [unit(d, i, -1) for i in order])
    return [*down, *(unit(d, i) for i in range(d) if i not in order)]


# -- corners cut off ----------------------------------------------------------------------------------------


def corners(d: int) -> Iterator[Cell]:
    """Every other corner of the unit cube cut off; for d = 4 the rest, a 16-cell, cut along a diagonal."""
    for corner in product((0, 1), repeat=d):
        if sum(corner) % 2:
            x = tuple(map(Fraction, corner))
            yield [x, *(_plus(x, unit(d, i, 1 - 2 * corner[i])) for i in range(d))]
    even = [tuple(map(Fraction, x)) for x in product((0, 1), repeat=d) if not sum(x) % 2]
    if d == 3:
        yield even
    else:
        opposite = [(x, tuple(1 - a for a in x)) for x in even if not x[0]]
        for choice in product(*opposite[1:]):
            yield [*opposite[0], *choice]


def corners_classes(d: int) -> list[Cell]:
    """What is left in the middle, and the corner."""
    cells = list(corners(d))
    return [cells[-1], cells[0]]
