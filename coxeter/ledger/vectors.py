"""Points with rational coordinates, as tuples: what the checks compute with them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations

from ..exact import Exact, rational

Point = tuple[Fraction, ...]


def point(*coordinates: int | Fraction) -> Point:
    """A point with exact coordinates."""
    return tuple(Fraction(x) for x in coordinates)


def rational_point(coordinates: Iterable[Exact]) -> Point:
    """A point of the core, all of whose coordinates are rational.

    Raises
    ------
    InvalidInput
        If one is irrational.
    """
    return tuple(map(rational, coordinates))


def minus(a: Point, b: Point) -> Point:
    """The vector from b to a."""
    return tuple(x - y for x, y in zip(a, b, strict=True))


def along(a: Point, t: Fraction, direction: Point) -> Point:
    """The point a + t·direction."""
    return tuple(x + t * y for x, y in zip(a, direction, strict=True))


def inner(a: Sequence[Fraction], b: Sequence[Fraction]) -> Fraction:
    """The inner product of two vectors."""
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def squared(a: Point, b: Point) -> Fraction:
    """The squared distance of two points."""
    return inner(minus(a, b), minus(a, b))


def mirrored(x: Point, centre: Point) -> Point:
    """The mirror image of a point in a centre."""
    return along(x, Fraction(2), minus(centre, x))


def squared_edges(points: Iterable[Point]) -> tuple[Fraction, ...]:
    """The squared distances of some points, sorted; those of congruent simplices agree."""
    return tuple(sorted(squared(a, b) for a, b in combinations(points, 2)))


def mean(points: Sequence[Point]) -> Point:
    """The barycentre of some points."""
    return tuple(sum(column, Fraction(0)) / len(points) for column in zip(*points, strict=True))
