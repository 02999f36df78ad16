"""Simplices whose copies fill space: Sommerville's tetrahedra, the families of Hill and Goldberg."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import permutations

from ..exact import Exact, sqrt
from .cubes import Cell, N, walk

HALF = Fraction(1, 2)

# -- Sommerville --------------------------------------------------------------------------------------------

BCC: Cell = [tuple(map(Fraction, x)) for x in ((0, 0, 0), (2, 0, 0), (1, 1, 1), (1, 1, -1))]
"""The tetrahedron of A~3: opposite edges AB and CD of length 2, the others of length √3."""


def middle(*points: tuple[N, ...]) -> tuple[N, ...]:
    """The centroid of some points."""
    return tuple(sum(column) / len(points) for column in zip(*points, strict=True))


def sommerville(number: int) -> Iterator[Cell]:
    """The bcc tetrahedron cut into copies of one tetrahedron: into 1, 2, 4 or 4.

    2: by the mirror through AB and the middle of CD. 3: by the mirror through CD and the middle of AB as
    well. 4: joined from its centre.
    """
    a, b, c, d = BCC
    ab, cd = middle(a, b), middle(c, d)
    cuts = {
        1: [BCC],
        2: [[a, b, c, cd], [a, b, d, cd]],
        3: [[x, ab, y, cd] for x in (a, b) for y in (c, d)],
        4: [[*BCC[:k], middle(*BCC), *BCC[k + 1 :]] for k in range(4)],
    }
    yield from cuts[number]


# -- Hill, Hadwiger, Goldberg -------------------------------------------------------------------------------


def hill(d: int, stretch: Fraction) -> Iterator[list[tuple[Exact, ...]]]:
    """K1 on the unit cube stretched along its diagonal, `stretch` being the square of the factor.

    The d steps b_i of a path have equal lengths, and equal inner products with each other. So each
    permutation of the steps is an isometry, and the d! paths from corner to corner of the parallelepiped of
    the b_i are congruent. As a linear map carries K1 to them, they tile it; and its translates tile space.
    """
    for order in permutations(range(d)):
        yield hill_path(d, stretch, order)


def hill_path(d: int, stretch: Fraction, order: tuple[int, ...]) -> list[tuple[Exact, ...]]:
    """One path. The steps are e_i + (λ - 1)/d · (1, …, 1), λ the factor."""
    factor = sqrt(stretch)
    shift = (factor - 1) / d
    along: Exact = shift.as_fraction() if shift.is_rational else shift
    steps = [tuple(along + int(k == i) for k in range(d)) for i in order]
    return walk((Fraction(0),) * d, steps)


def goldberg(family: int, stretch: Fraction) -> Iterator[list[tuple[Exact, ...]]]:
    """Hill's tetrahedron, whole or halved.

    A half-turn exchanges v0 with v3 and v1 with v2. A plane through its axis, that through v1, v2 and the
    middle of v0 v3 (family 2) or that through v0, v3 and the middle of v1 v2 (family 3), is carried to
    itself, so it cuts the tetrahedron into congruent halves. `coxeter.optimality.halves` has them for any d.
    """
    path = hill_path(3, stretch, (0, 1, 2))
    if family == 1:
        yield path
    else:
        k = family - 2
        m = middle(path[k], path[3 - k])
        yield from ([m if i == j else v for i, v in enumerate(path)] for j in (3 - k, k))
