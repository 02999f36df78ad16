"""Triangulations of the plane on which Section 4 is tried: each vertex near a circle is counted."""

from __future__ import annotations

import math
import random
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, product
from typing import NamedTuple

from ..affine import triangulation
from ..simplex import Position, Simplex, position
from .section_4_geometry import circumsphere
from .vectors import Point, mean, minus, mirrored, point, squared_edges

Triangle = tuple[Point, ...]


def where(triangle: Triangle) -> Position:
    """Where the circumcentre of a triangle lies."""
    return position(Simplex(triangle).circumcentre_coordinates)


# -- a tiling by trapezoids: the witness against Lemma 4 --------------------------------------------------

TRAPEZOID = (point(0, 0), point(3, 0), point(2, 2), point(1, 2))
PERIOD = 4


@lru_cache(maxsize=1)
def trapezoid_triangles() -> tuple[Triangle, ...]:
    """The eight triangles of a period: four trapezoids, each cut along the diagonal from its first corner."""
    turned = tuple(point(5 - x, 2 - y) for x, y in TRAPEZOID)
    strip = (TRAPEZOID, turned)
    tiles = (*strip, *(tuple(point(x, PERIOD - y) for x, y in tile) for tile in strip))
    return tuple(half for a, b, c, d in tiles for half in ((a, b, c), (a, c, d)))


@dataclass(frozen=True)
class Examined:
    """What is found about a periodic set of triangles.

    Attributes
    ----------
    fits
        Whether each edge belongs to two triangles, on different sides, and the areas fill a period: they
        then cover the plane once, face to face.
    sides
        How many triangles an edge belongs to.
    inside, on
        For each triangle, how many vertices lie strictly inside its circumcircle, and on it.
    squared_radii, positions
        The squared circumradius and the position of the circumcentre, for each triangle.
    """

    fits: bool
    sides: frozenset[int]
    inside: tuple[int, ...]
    on: tuple[int, ...]
    squared_radii: tuple[Fraction, ...]
    positions: tuple[Position, ...]

    @property
    def delaunay(self) -> bool:
        """Whether it is a Delaunay triangulation of the plane."""
        return self.fits and not any(self.inside)


@lru_cache(maxsize=1)
def trapezoids() -> Examined:
    """The triangulation by halves of trapezoids."""
    triangles = trapezoid_triangles()
    spheres = [circumsphere(t) for t in triangles]
    powers = [[s.power(x) for x in _copies()] for s in spheres]
    return Examined(
        _fits(triangles),
        frozenset(len(v) for v in _edges(triangles).values()),
        tuple(sum(p < 0 for p in row) for row in powers),
        tuple(sum(p == 0 for p in row) for row in powers),
        tuple(s.square for s in spheres),
        tuple(map(where, triangles)),
    )


@lru_cache(maxsize=1)
def _copies() -> tuple[Point, ...]:
    """The vertices within two periods: all that can lie in a circle of radius less than a period."""
    corners = {tuple(x % PERIOD for x in v) for t in trapezoid_triangles() for v in t}
    shifts = [Fraction(PERIOD * k) for k in range(-2, 3)]
    return tuple((x + a, y + b) for x, y in corners for a in shifts for b in shifts)


def _edges(triangles: Iterable[Triangle]) -> dict[tuple[Point, Point], list[int]]:
    """The edges up to the period, with the side on which each triangle at it lies."""
    found: dict[tuple[Point, Point], list[int]] = {}
    for triangle in triangles:
        for a, b in combinations(triangle, 2):
            (apex,) = set(triangle) - {a, b}
            keys = [(tuple(x % PERIOD for x in p), minus(q, p)) for p, q in ((a, b), (b, a))]
            key = min(keys)
            step = key[1]
            side = 1 if step[0] * (apex[1] - a[1]) > step[1] * (apex[0] - a[0]) else -1
            found.setdefault(key, []).append(side)
    return found


def _fits(triangles: tuple[Triangle, ...]) -> bool:
    glued = all(sorted(sides) == [-1, 1] for sides in _edges(triangles).values())
    return glued and sum(Simplex(t).volume for t in triangles) == PERIOD**2


# -- rows of congruent triangles --------------------------------------------------------------------------


@dataclass(frozen=True)
class Row:
    """A row of triangles with base 1, the apex over the point `foot` of the base at the given height."""

    foot: Fraction
    height: Fraction

    @property
    def triangle(self) -> Triangle:
        """The triangle that stands on its base; the others of the row are congruent to it."""
        return point(0, 0), point(1, 0), (self.foot, self.height)


def least_powers(rows: tuple[Row, ...], i: int) -> Fraction:
    """The least power, with respect to the triangles of row i, of the vertices that are not theirs.

    Neighbouring rows are shifted so that apexes meet bases. All vertices that can lie in the circumcircle
    must be in the rows given; columns are taken as far as its diameter reaches.
    """
    offset, level = Fraction(0), Fraction(0)
    lines = [(offset, level)]
    for row in rows:
        offset, level = offset + row.foot, level + row.height
        lines.append((offset, level))
    (x0, y0), (x1, y1) = lines[i], lines[i + 1]
    upright = ((x0, y0), (x0 + 1, y0), (x1, y1))
    hanging = ((x0 + 1, y0), (x1, y1), (x1 + 1, y1))
    return min(_least_power(t, lines) for t in (upright, hanging))


def _least_power(triangle: Triangle, lines: list[tuple[Fraction, Fraction]]) -> Fraction:
    sphere = circumsphere(triangle)
    columns = range(
        -math.isqrt(math.ceil(4 * sphere.square)) - 2, math.isqrt(math.ceil(4 * sphere.square)) + 3
    )
    near = [(sphere.centre[0] - x) // 1 for x, _ in lines]
    points = {(x + m + k, y) for (x, y), m in zip(lines, near, strict=True) for k in columns}
    return min(sphere.power(p) for p in points - set(triangle))


@lru_cache(maxsize=1)
def random_rows() -> tuple[tuple[tuple[Row, ...], bool, bool], ...]:
    """Stacks of rows: the stack, whether all triangles are self-centred, whether circles are empty.

    The circles of the middle row are judged: no diameter exceeds 2, so none reaches beyond the stack. In the
    last stacks three flat rows are put in the middle.
    """
    rng, found = random.Random(3), []
    feet = [Fraction(n, 10) for n in (1, 2, 3, 5)]
    for turn in range(10):
        rows: list[Row] = []
        while len(rows) < 11:
            row = Row(rng.choice(feet), Fraction(rng.randint(4, 12), 10))
            if where(row.triangle) is not Position.OUTSIDE:
                rows.append(row)
        if turn >= 8:
            rows[4:7] = [Row(feet[turn - 6], Fraction(2, 5))] * 3
        centred = all(where(r.triangle) is not Position.OUTSIDE for r in rows)
        found.append((tuple(rows), centred, least_powers(tuple(rows), 5) >= 0))
    return tuple(found)


def flattening_rows(n: int) -> tuple[Row, ...]:
    """Rows n - 3 … n + 3 of the stack whose row k has isosceles triangles of height 1/2 + 2^-(|k| + 1)."""
    half = Fraction(1, 2)
    return tuple(Row(half, half + Fraction(1, 2 ** (abs(k) + 1))) for k in range(n - 3, n + 4))


@lru_cache(maxsize=1)
def growing_radii() -> tuple[Fraction, ...]:
    """The squared circumradii in the rows 0 to 4 of a stack of heights 1 - 2^-(|k| + 1)."""
    rows = [Row(Fraction(1, 2), 1 - Fraction(1, 2 ** (k + 1))) for k in range(5)]
    return tuple(circumsphere(row.triangle).square for row in rows)


# -- one triangle and its half-turns ----------------------------------------------------------------------


class Tiling(NamedTuple):
    """A triangle that tiles the plane by half-turns about the midpoints of its sides.

    Attributes
    ----------
    triangle, position
        The triangle, and where its circumcentre lies.
    least_power
        The least power of a vertex of the triangulation that is not one of its own.
    """

    triangle: Triangle
    position: Position
    least_power: Fraction


@lru_cache(maxsize=1)
def half_turn_tilings() -> tuple[Tiling, ...]:
    """Tilings by triangles with small integer corners, of all three positions of the circumcentre.

    All triangles of a tiling are congruent and have the same surroundings, so one circle is enough. A vertex
    m·a + n·b in the circle, or nearest to it, has barycentric coordinates below 2 + 4R/h in size.
    """
    found = []
    for side, x, y in product((2, 3), range(-1, 4), (1, 2, 3)):
        triangle = (point(0, 0), point(side, 0), point(x, y))
        sphere, simplex = circumsphere(triangle), Simplex(triangle)
        reach = 3 + math.isqrt(math.ceil(16 * sphere.square / min(simplex.squared_heights)))
        steps = range(-reach, reach + 1)
        points = {(m * side + n * x, n * y) for m, n in product(steps, steps)} - {(0, 0), (side, 0), (x, y)}
        nearest = min(_scaled_power(p, sphere.centre) for p in points)
        scale = math.lcm(*(c.denominator for c in sphere.centre)) ** 2
        found.append(Tiling(triangle, where(triangle), Fraction(nearest, scale) - sphere.square))
    return tuple(found)


def _scaled_power(p: tuple[int, int], centre: Point) -> int:
    """The squared distance in integers, times the square of the common denominator of the centre."""
    common = math.lcm(*(c.denominator for c in centre))
    return sum((x * common - int(c * common)) ** 2 for x, c in zip(p, centre, strict=True))


@lru_cache(maxsize=1)
def cut_from_the_centres() -> tuple[frozenset[tuple[Fraction, ...]], Position, Fraction]:
    """The triangles of A~2 cut from their centres into three, a monohedral triangulation.

    The squared edges of the three parts and of their mirror images in the sides (one value: congruent), where
    a part has its circumcentre, and the power of the apex beyond its long side.
    """
    simplex = triangulation("A~2").simplex
    corners = simplex.vertex_matrix.rows()
    centre = mean(corners)
    kinds, powers = set(), set()
    for p, q in combinations(corners, 2):
        beyond = mirrored(centre, mean((p, q)))
        kinds |= {squared_edges((centre, p, q)), squared_edges((beyond, p, q))}
        powers.add(circumsphere((centre, p, q)).power(beyond))
    (power,) = powers
    return frozenset(kinds), where((centre, *corners[:2])), power
