"""The plane of a root system of rank 2: exact coordinates in it, and what a window on it shows."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from operator import mul
from typing import NamedTuple

from ..affine import CoxeterTriangulation, Vector
from ..errors import InvalidInput
from ..exact import Surd, sqrt
from ..exact.surd import Exact
from ..roots import RootSystem
from .canvas import Point, between, overlap

Triangle = tuple[Vector, Vector, Vector]
Frame = tuple[tuple[Exact, ...], tuple[Exact, ...]]


class Line(NamedTuple):
    """The line <x, root> = k."""

    root: Vector
    k: int


@dataclass(frozen=True)
class Window:
    """A rectangle of the plane, seen at some scale.

    Attributes
    ----------
    frame
        Two orthonormal vectors, to the right and upwards.
    centre
        The coordinates of the window's centre in the frame.
    half
        Half its width and half its height.
    scale
        Pixels for one unit of length.
    """

    frame: Frame
    centre: tuple[Exact, Exact]
    half: tuple[Fraction, Fraction]
    scale: float

    def project(self, x: Sequence[Exact]) -> tuple[Surd, Surd]:
        """The coordinates of a point in the frame."""
        first, second = (_inner(x, vector) for vector in self.frame)
        return first, second

    @cached_property
    def _floats(self) -> tuple[tuple[list[float], float], ...]:
        """The frame and the centre in decimals, for drawing."""
        pairs = zip(self.frame, self.centre, strict=True)
        return tuple(([float(x) for x in vector], float(c)) for vector, c in pairs)

    def pixel(self, x: Sequence[Exact]) -> Point:
        """Where a point is drawn."""
        decimals = [float(c) for c in x]
        first, second = (math.fsum(map(mul, v, decimals)) - c for v, c in self._floats)
        return self.scale * first, -self.scale * second

    def sides(self, x: Sequence[Exact]) -> tuple[bool, ...]:
        """Whether a point lies strictly inside of the left, right, lower and upper side."""
        triples = zip(self.project(x), self.centre, self.half, strict=True)
        return tuple(side for a, c, h in triples for side in (a > c - h, a < c + h))

    def contains(self, x: Sequence[Exact]) -> bool:
        """Whether the window shows a point, at its rim too."""
        triples = zip(self.project(x), self.centre, self.half, strict=True)
        return all(abs(a - c) <= h for a, c, h in triples)

    @property
    def corners(self) -> tuple[Point, Point]:
        """The upper left and the lower right corner, in pixels."""
        x, y = (self.scale * float(h) for h in self.half)
        return (-x, -y), (x, y)

    def lines(self, roots: Sequence[Vector]) -> tuple[Line, ...]:
        """The lines <x, r> = k, for the given roots and all integers k, that cross the window."""
        found = []
        for root in roots:
            a, b = self.project(root)
            middle, spread = (
                a * self.centre[0] + b * self.centre[1],
                abs(a) * self.half[0] + abs(b) * self.half[1],
            )
            k = int(float(middle - spread)) - 1
            while k < middle + spread:
                found += [Line(root, k)] if k > middle - spread else []
                k += 1
        return tuple(found)

    def segment(self, line: Line) -> tuple[Point, Point]:
        """The part of a line that the window shows, in pixels."""
        a, b = (float(x) for x in self.project(line.root))
        shift = (line.k - a * float(self.centre[0]) - b * float(self.centre[1])) / (a * a + b * b)
        (x, y), far = (
            (self.scale * shift * a, -self.scale * shift * b),
            4 * self.corners[1][0] / math.hypot(a, b),
        )
        return self.visible((x - far * b, y - far * a), (x + far * b, y + far * a))[0]

    def visible(self, p: Point, q: Point) -> list[tuple[Point, Point]]:
        """The part of a segment, in pixels, that lies in the window, if any."""
        (left, top), (right, bottom) = self.corners
        inside = overlap(p, q, (left, top, right, bottom))
        return [(between(p, q, inside[0]), between(p, q, inside[1]))] if inside else []

    def clip(self, outline: Sequence[Point]) -> list[Point]:
        """The part of a convex polygon, in pixels, that lies in the window (Sutherland and Hodgman)."""
        points = list(outline)
        for axis in (0, 1):
            for corner, sign in zip(self.corners, (1, -1), strict=True):
                inside = [sign * (p[axis] - corner[axis]) for p in points]
                clipped: list[Point] = []
                for i, (p, h) in enumerate(zip(points, inside, strict=True)):
                    q, g = points[i - 1], inside[i - 1]
                    if g * h < 0:
                        clipped.append(between(q, p, g / (g - h)))
                    if h >= 0:
                        clipped.append(p)
                points = clipped
        return points


def frame(system: RootSystem) -> Frame:
    """An orthonormal frame of the plane of a root system of rank 2.

    The unit vectors if the roots have two coordinates; else the first simple root points to the
    right and the second upwards.

    >>> from coxeter.roots import root_system
    >>> frame(root_system("A2"))[0]
    (sqrt(2)/2, -sqrt(2)/2, 0)
    """
    s, t = plane_roots(system)
    if len(s) == 2:
        return (Fraction(1), Fraction(0)), (Fraction(0), Fraction(1))
    return orthonormal(s, t)


def plane_roots(system: RootSystem) -> tuple[Vector, Vector]:
    """The two simple roots of a root system of the plane; raises `InvalidInput` for any other."""
    if system.rank != 2:
        raise InvalidInput(f"{system.name} has rank {system.rank}: only rank 2 can be drawn in the plane")
    s, t = system.simple_roots.rows()
    return s, t


def orthonormal(s: Vector, t: Vector) -> Frame:
    """An orthonormal frame of the plane of two vectors: the first to the right, the second upwards."""
    first, second = map(unit, orthogonal((s, t)))
    return first, second


def orthogonal(vectors: Sequence[Vector]) -> list[Vector]:
    """Independent vectors, each made orthogonal to those before it (Gram and Schmidt)."""
    found: list[Vector] = []
    for vector in vectors:
        for u in found:
            share = _rational(vector, u) / _rational(u, u)
            vector = tuple(x - share * y for x, y in zip(vector, u, strict=True))
        found.append(vector)
    return found


def unit(vector: Vector) -> tuple[Exact, ...]:
    """A vector over its length."""
    return tuple(x / sqrt(_rational(vector, vector)) for x in vector)


def triangles_in(window: Window, triangulation: CoxeterTriangulation) -> tuple[tuple[Triangle, int], ...]:
    """The triangles that are on no side beyond a window, each with the parity of its distance to the first.

    Neighbours are found by reflection, from the fundamental simplex on. Vertex k of each triangle is
    an image of u_k.
    """
    u, v, w = triangulation.simplex.vertex_matrix.rows()
    todo, found = deque([((u, v, w), 0)]), {frozenset((u, v, w)): ((u, v, w), 0)}
    sides = cache(window.sides)
    while todo:
        triangle, parity = todo.popleft()
        for k in range(3):
            image = reflected(triangle, k)
            if frozenset(image) not in found and all(map(any, zip(*map(sides, image), strict=True))):
                found[frozenset(image)] = (image, 1 - parity)
                todo.append((image, 1 - parity))
    return tuple(found.values())


def reflected(triangle: Triangle, k: int) -> Triangle:
    """A triangle with vertex k replaced by its mirror image in the line through the other two."""
    p, q = (triangle[i] for i in range(3) if i != k)
    edge = tuple(b - a for a, b in zip(p, q, strict=True))
    offset = tuple(b - a for a, b in zip(p, triangle[k], strict=True))
    share = _rational(offset, edge) / _rational(edge, edge)
    image = tuple(2 * (a + share * e) - x for a, e, x in zip(p, edge, triangle[k], strict=True))
    vertices = [image if i == k else triangle[i] for i in range(3)]
    return vertices[0], vertices[1], vertices[2]


def squared_distance(p: Vector, q: Vector) -> Fraction:
    """The square of the distance of two points."""
    return sum(((a - b) ** 2 for a, b in zip(p, q, strict=True)), Fraction(0))


def _rational(a: Sequence[Fraction], b: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def _inner(a: Sequence[Exact], b: Sequence[Exact]) -> Surd:
    return Surd(0) + sum((x * y for x, y in zip(a, b, strict=True) if x and y), Surd(0))
