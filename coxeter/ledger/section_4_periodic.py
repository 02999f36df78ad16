"""Periodic sets of points in the plane, chosen at random, and the largest of their empty circles."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import combinations

import numpy as np

from ..simplex import Simplex
from .section_4_geometry import Sphere, circumsphere
from .vectors import Point, point

PERIOD = 6


@dataclass(frozen=True)
class Cell:
    """The vertices on an empty circle."""

    sphere: Sphere
    vertices: tuple[Point, ...]

    @property
    def lowest_coordinates(self) -> tuple[Fraction, ...]:
        """For each three of the vertices the least barycentric coordinate of the centre."""
        triples = combinations(self.vertices, 3)
        return tuple(min(Simplex(t).barycentric(self.sphere.centre)) for t in triples)

    @property
    def contains_centre(self) -> bool:
        """Whether the centre lies in the convex hull, which is in that of some three vertices."""
        return max(self.lowest_coordinates) >= 0


@lru_cache(maxsize=1)
def largest_cells() -> tuple[Cell, ...]:
    """For some sets of four points and their translates by multiples of 6: the largest empty circles.

    The radius of an empty circle is at most 6 / √2, as each square of side 6 holds a translate of each
    point: two periods on each side are enough.
    """
    rng, found = random.Random(44), []
    for _ in range(7):
        base = sorted({(rng.randrange(PERIOD), rng.randrange(PERIOD)) for _ in range(4)})
        found += _largest(np.array(base))
    return tuple(found)


def _largest(base: np.ndarray) -> list[Cell]:
    shifts = PERIOD * np.array([(a, b) for a in range(-2, 3) for b in range(-2, 3)])
    points = (base[:, None, :] + shifts[None, :, :]).reshape(-1, 2)
    cells: dict[Sphere, Cell] = {}
    for triangle in (t for p in base for t in _empty_triangles(p, points)):
        sphere = circumsphere(triangle)
        if sphere not in cells:
            vertices = (point(int(x), int(y)) for x, y in points)
            cells[sphere] = Cell(sphere, tuple(v for v in vertices if not sphere.power(v)))
    greatest = max(sphere.square for sphere in cells)
    return [cell for sphere, cell in cells.items() if sphere.square == greatest]


def _empty_triangles(p: np.ndarray, points: np.ndarray) -> Iterator[tuple[Point, ...]]:
    """Triangles with a corner p whose circle is empty, by the integer determinant for circles."""
    moved = points - p
    squares = (moved**2).sum(axis=1)
    near = moved[(squares > 0) & (squares <= 2 * PERIOD**2)].tolist()
    for (a, b), (c, d) in combinations(near, 2):
        cross = a * d - b * c
        if cross:
            first, second = a * a + b * b, c * c + d * d
            u, v = first * d - second * b, second * a - first * c  # the centre is (u, v) / 2·cross
            powers = (cross * squares - moved[:, 0] * u - moved[:, 1] * v) * (1 if cross > 0 else -1)
            if powers.min() >= 0:
                x, y = (int(t) for t in p)
                yield point(x, y), point(x + a, y + b), point(x + c, y + d)
