"""Points with rational coordinates, as tuples: what the checks compute with them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

Point = tuple[Fraction, ...]


def point(*coordinates: int | Fraction) -> Point:
    """A point with exact coordinates."""
    return tuple(Fraction(x) for x in coordinates)


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


def mean(points: Sequence[Point]) -> Point:
    """The barycentre of some points."""
    return tuple(sum(column, Fraction(0)) / len(points) for column in zip(*points, strict=True))
