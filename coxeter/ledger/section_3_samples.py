"""Simplices on which Section 3 is tested, with lengths that do not come from `coxeter.simplex`."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, product

from ..affine import triangulation
from ..errors import DegenerateSimplex
from ..exact import RationalMatrix, Surd, sqrt, surd
from ..quality import MEASURES
from ..simplex import Simplex, regular_simplex
from .instances import all_types, near_regular, random_simplices, regular_value
from .vectors import Point, along, inner, mean, minus, mirrored, point, squared

NAMES = {
    "aspect ratio": "aspect_ratio",
    "fatness": "fatness",
    "thickness": "thickness",
    "radius ratio": "radius_ratio",
}
"""The four measures: the paper's name, the library's."""


def gram_determinant(points: tuple[Point, ...]) -> Fraction:
    """The Gram determinant of the edges from the first point: the squared volume, times a factorial."""
    edges = [minus(p, points[0]) for p in points[1:]]
    if not edges:
        return Fraction(1)
    matrix = RationalMatrix.from_rows(edges)
    return (matrix @ matrix.T).det()


@dataclass(frozen=True)
class Lengths:
    """The lengths of Definition 18, each from the vertices by its own definition."""

    d: int
    h: Surd
    r: Surd
    R: Surd
    L: Surd
    vol: Surd
    diameter: Surd

    def letters(self) -> dict[str, Surd]:
        """What the letters of a formula stand for."""
        return {"d": surd(self.d), "h": self.h, "r": self.r, "R": self.R, "L": self.L, "vol": self.vol}

    def in_words(self) -> dict[str, Surd]:
        """The four measures as the definition says them in words."""
        fatness = self.vol
        for _ in range(self.d):
            fatness = fatness / self.L
        return {
            "aspect ratio": self.h / self.diameter,
            "fatness": fatness,
            "thickness": self.h / self.L,
            "radius ratio": self.r / self.R,
        }


def lengths(points: tuple[Point, ...]) -> Lengths:
    """Heights and inradius from the volumes of the facets, the ball from a vertex and its antipode."""
    d = len(points) - 1
    volume = sqrt(gram_determinant(points)) / math.factorial(d)
    facets = [
        sqrt(gram_determinant((*points[:k], *points[k + 1 :]))) / math.factorial(d - 1) for k in range(d + 1)
    ]
    heights = [d * volume / facet for facet in facets]
    inradius = d * volume / sum(facets, Surd(0))
    edges = [squared(p, q) for p, q in combinations(points, 2)]
    centre = _circumcentre(points)
    diameter = sqrt(squared(mirrored(points[0], centre), points[0]))
    radius = sqrt(squared(centre, points[-1]))
    return Lengths(d, min(heights), inradius, radius, sqrt(max(edges)), volume, diameter)


def _circumcentre(points: tuple[Point, ...]) -> Point:
    """The solution of the equations 2<c, v - v_0> = |v|² - |v_0|²; as many coordinates as dimensions."""
    rows = [[2 * x for x in minus(p, points[0])] for p in points[1:]]
    values = [[inner(p, p) - inner(points[0], points[0])] for p in points[1:]]
    solution = RationalMatrix.from_rows(rows).inverse() @ RationalMatrix.from_rows(values)
    return tuple(x for (x,) in solution.rows())


@lru_cache(maxsize=1)
def measured() -> tuple[tuple[Lengths, Simplex], ...]:
    """Simplices of dimension 1 to 5 that fill their space, with their lengths by both routes."""
    known: list[tuple[Point, ...]] = [
        (point(0), point(3)),
        (point(0, 0), point(4, 0), point(0, 3)),
        (point(0, 0), point(3, 0), point(1, 1)),
        (point(0, 0, 0), point(1, 1, 0), point(1, 0, 1), point(0, 1, 1)),
    ]
    drawn = [s for d in (2, 3, 4, 5) for s in random_simplices(d, 2, seed=18, size=3)]
    drawn += [triangulation(name).simplex for name in ("B~3", "C~4", "D~4")]
    known += [s.vertex_matrix.rows() for s in drawn]
    return tuple((lengths(p), Simplex(p)) for p in known)


@lru_cache(maxsize=1)
def rivals() -> tuple[Simplex, ...]:
    """Simplices that might beat the regular one: in a grid, in cubes, close to it, and Coxeter's."""
    return tuple(_rivals())


def _rivals() -> Iterator[Simplex]:
    cube = list(product((0, 1), repeat=3))
    for corners in (*combinations(product(range(3), repeat=2), 3), *combinations(cube, 4)):
        with suppress(DegenerateSimplex):
            yield Simplex(corners)
    for d in range(1, 8):
        yield regular_simplex(d)
        for size in (5, 25, 250):
            yield from near_regular(d, 1, size)
    for t in all_types(8):
        yield t.simplex


def normalised(measure: str, simplex: Simplex) -> Surd:
    """A measure over its value for the regular simplex, fatness without the power 1/d of the tables."""
    return MEASURES[NAMES[measure]](simplex) / regular_value(NAMES[measure], simplex.dimension)


@lru_cache(maxsize=4)
def greatest(measure: str) -> Surd:
    """The greatest normalised value that a rival reaches."""
    return max(normalised(measure, simplex) for simplex in rivals())


def squeezed(d: int, t: Fraction) -> Simplex:
    """The regular d-simplex with one height multiplied by t."""
    apex, *base = (point(*(int(i == j) for j in range(d + 1))) for i in range(d + 1))
    foot = mean(base)
    return Simplex([along(foot, t, minus(apex, foot)), *base])


@lru_cache(maxsize=1)
def values_towards_zero() -> Mapping[str, bool]:
    """For each measure: do squeezed simplices of dimension 2 to 6 start at 1 and stay within d·t?"""
    steps = [Fraction(1, 10**k) for k in (1, 3)]

    def tends_to_zero(name: str, d: int) -> bool:
        start = normalised(name, squeezed(d, Fraction(1)))
        small = all(0 < normalised(name, squeezed(d, t)) <= d * t for t in steps)
        return start == 1 and small

    return {name: all(tends_to_zero(name, d) for d in range(2, 7)) for name in NAMES}
