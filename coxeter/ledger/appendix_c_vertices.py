"""The vertices of A~ as Appendix C writes them, by integers n_i and a remainder k."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import product

from .vectors import Point

LARGEST = 6
"""Vertices are enumerated up to this dimension."""


@lru_cache(maxsize=8)
def sample(d: int) -> tuple[tuple[int, tuple[int, ...]], ...]:
    """Vertices of A~_d as pairs (k, n), with the coordinates n_i + k/(d + 1) and the sum of n equal to -k."""
    found = [(-sum(n), n) for n in product(range(-2, 2), repeat=d + 1) if 0 <= -sum(n) <= d]
    return tuple(found[:: max(1, len(found) // 60)])


def point(k: int, n: tuple[int, ...]) -> Point:
    """The vertex with integers n and remainder k."""
    return tuple(x + Fraction(k, len(n)) for x in n)


def squared_distance(k: int, n: tuple[int, ...]) -> Fraction:
    """Its squared distance from the circumcentre."""
    d = len(n) - 1
    return sum(((x - Fraction(2 * i - d, 2 * (d + 1))) ** 2 for i, x in enumerate(point(k, n))), Fraction(0))
