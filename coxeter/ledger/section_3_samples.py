"""Simplices on which Section 3 is tested, with lengths that do not come from `coxeter.simplex`."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, product

from ..affine import triangulation
from ..errors import DegenerateSimplex
from ..exact import RationalMatrix, Surd, sqrt, surd
from ..names import triangulations_up_to
from ..quality import MEASURES
from ..simplex import Simplex, regular_simplex

Point = tuple[Fraction, ...]

NAMES = {
    "aspect ratio": "aspect_ratio",
    "fatness": "fatness",
    "thickness": "thickness",
    "radius ratio": "radius_ratio",
}
"""The four measures: the paper's name, the library's."""


def gram_determinant(points: tuple[Point, ...]) -> Fraction:
    """The Gram determinant of the edges from the first point: the squared volume, times a factorial."""
    edges = [[x - y for x, y in zip(p, points[0], strict=True)] for p in points[1:]]
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
    edges = [_squared(p, q) for p, q in combinations(points, 2)]
    centre = _circumcentre(points)
    antipode = tuple(2 * c - x for c, x in zip(centre, points[0], strict=True))
    diameter = sqrt(_squared(antipode, points[0]))
    radius = sqrt(_squared(centre, points[-1]))
    return Lengths(d, min(heights), inradius, radius, sqrt(max(edges)), volume, diameter)


def _squared(p: Point, q: Point) -> Fraction:
    return sum(((x - y) ** 2 for x, y in zip(p, q, strict=True)), Fraction(0))


def _circumcentre(points: tuple[Point, ...]) -> Point:
    """The solution of the equations 2<c, v - v_0> = |v|² - |v_0|²; as many coordinates as dimensions."""
    rows = [[2 * (x - y) for x, y in zip(p, points[0], strict=True)] for p in points[1:]]
    zero = tuple(Fraction(0) for _ in points[0])
    values = [[_squared(p, zero) - _squared(points[0], zero)] for p in points[1:]]
    solution = RationalMatrix.from_rows(rows).inverse() @ RationalMatrix.from_rows(values)
    return tuple(x for (x,) in solution.rows())


@lru_cache(maxsize=1)
def measured() -> tuple[tuple[Lengths, Simplex], ...]:
    """Simplices of dimension 1 to 5 that fill their space, with their lengths by both routes."""
    known: list[tuple[Point, ...]] = [_points([(0,), (3,)]), _points([(0, 0), (4, 0), (0, 3)])]
    known += [_points(p) for p in ([(0, 0), (3, 0), (1, 1)], [(0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)])]
    known += [random_points(d, d) for d in (2, 3, 4, 5) for _ in range(2)]
    known += [triangulation(name).simplex.vertex_matrix.rows() for name in ("B~3", "C~4", "D~4")]
    return tuple((lengths(p), Simplex(p)) for p in known)


def _points(rows: Sequence[tuple[int, ...]]) -> tuple[Point, ...]:
    return tuple(tuple(Fraction(x) for x in row) for row in rows)


_RANDOM = random.Random(18)


def random_points(d: int, space: int) -> tuple[Point, ...]:
    """The vertices of a d-simplex with small integer coordinates, the same in every run."""
    while True:
        points = tuple(tuple(Fraction(_RANDOM.randint(-3, 3)) for _ in range(space)) for _ in range(d + 1))
        if gram_determinant(points):
            return points


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
        for denominator in (2, 10, 100):
            yield _beside_regular(d, denominator)
    for kind in triangulations_up_to(8):
        yield triangulation(kind).simplex


def _beside_regular(d: int, denominator: int) -> Simplex:
    """The regular simplex, each coordinate moved by less than one over the denominator."""
    moves = random.Random(d * denominator)
    rows = [
        [Fraction(int(i == j)) + Fraction(moves.randint(-2, 2), 5 * denominator) for j in range(d + 1)]
        for i in range(d + 1)
    ]
    return Simplex(rows)


def normalised(measure: str, simplex: Simplex) -> Surd:
    """A measure over its value for the regular simplex, fatness without the power 1/d of the tables."""
    return MEASURES[NAMES[measure]](simplex) / _of_regular(measure, simplex.dimension)


@lru_cache(maxsize=64)
def _of_regular(measure: str, d: int) -> Surd:
    return MEASURES[NAMES[measure]](regular_simplex(d))


@lru_cache(maxsize=4)
def greatest(measure: str) -> Surd:
    """The greatest normalised value that a rival reaches."""
    return max(normalised(measure, simplex) for simplex in rivals())


def squeezed(d: int, t: Fraction) -> Simplex:
    """The regular d-simplex with one height multiplied by t."""
    base = [[Fraction(int(i == j)) for j in range(d + 1)] for i in range(d + 1)]
    foot = [Fraction(0)] + [Fraction(1, d)] * d
    base[0] = [f + t * (x - f) for f, x in zip(foot, base[0], strict=True)]
    return Simplex(base)


@lru_cache(maxsize=1)
def values_towards_zero() -> Mapping[str, bool]:
    """For each measure: do squeezed simplices of dimension 2 to 6 start at 1 and stay within d·t?"""
    steps = [Fraction(1, 10**k) for k in (1, 3)]

    def tends_to_zero(name: str, d: int) -> bool:
        start = normalised(name, squeezed(d, Fraction(1)))
        small = all(0 < normalised(name, squeezed(d, t)) <= d * t for t in steps)
        return start == 1 and small

    return {name: all(tends_to_zero(name, d) for d in range(2, 7)) for name in NAMES}
