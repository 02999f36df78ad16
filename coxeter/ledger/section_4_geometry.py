"""Exact configurations for Section 4 and Appendix B: simplices, and pairs of them with a common facet.

Everything rests on one identity. Let two simplices share a facet with circumcentre o, and let z be the
height over its hyperplane. Then ``pow(x) - pow'(x) = 2·(z(c') - z(c))·z(x)`` for every point x, where
``pow(x) = |x - c|² - R²`` and c, c' are the circumcentres.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache

from ..errors import DegenerateSimplex
from ..simplex import Position, Simplex, position
from .vectors import Point, along, inner, minus, point, rational_point, squared


def perpendicular(x: Point, directions: Iterable[Point]) -> Point:
    """The part of a vector that is orthogonal to all the directions."""
    orthogonal: list[Point] = []
    for direction in (*directions, x):
        part = direction
        for e in orthogonal:
            part = along(part, -inner(direction, e) / inner(e, e), e)
        if any(part) or direction is x:
            orthogonal.append(part)
    return orthogonal[-1]


def height_vector(apex: Point, facet: tuple[Point, ...]) -> Point:
    """The vector from the foot of the height to the apex."""
    return perpendicular(minus(apex, facet[0]), [minus(v, facet[0]) for v in facet[1:]])


@dataclass(frozen=True)
class Sphere:
    """A sphere by its centre and its squared radius."""

    centre: Point
    square: Fraction

    def power(self, x: Point) -> Fraction:
        """The power of a point: negative inside, zero on the sphere, positive outside."""
        return squared(x, self.centre) - self.square


def circumsphere(vertices: tuple[Point, ...]) -> Sphere:
    """The sphere through the vertices, its centre in their affine hull; of one point, the point itself."""
    if len(vertices) == 1:
        return Sphere(vertices[0], Fraction(0))
    simplex = Simplex(vertices)
    return Sphere(rational_point(simplex.circumcentre), simplex.squared_circumradius)


@dataclass(frozen=True)
class Pair:
    """Two simplices with a common facet: the first with an apex on one side, the second on the other.

    The first is the simplex σ of the proofs, with the apex p; it counts as the lower one.
    """

    facet: tuple[Point, ...]
    apex: Point
    other: Point

    @cached_property
    def first(self) -> Simplex:
        """σ, its apex the last vertex."""
        return Simplex([*self.facet, self.apex])

    @cached_property
    def second(self) -> Simplex:
        """σ', its apex the last vertex."""
        return Simplex([*self.facet, self.other])

    @cached_property
    def sphere(self) -> Sphere:
        """S."""
        return circumsphere((*self.facet, self.apex))

    @cached_property
    def other_sphere(self) -> Sphere:
        """S'."""
        return circumsphere((*self.facet, self.other))

    @cached_property
    def middle(self) -> Sphere:
        """The circumcentre o of the facet and the square of its circumradius."""
        return circumsphere(self.facet)

    @cached_property
    def normal(self) -> Point:
        """A normal of the facet, upwards: away from p."""
        height = height_vector(self.apex, self.facet)
        return tuple(-x for x in height)

    def level(self, x: Point) -> Fraction:
        """The height of a point over the facet, times the length of the normal; negative at p."""
        return inner(minus(x, self.facet[0]), self.normal)

    @cached_property
    def levels(self) -> tuple[Fraction, Fraction]:
        """The levels of the two circumcentres c and c'."""
        return self.level(self.sphere.centre), self.level(self.other_sphere.centre)

    @cached_property
    def squared_normal(self) -> Fraction:
        """The squared length of the normal: the squared height of p."""
        return inner(self.normal, self.normal)

    @cached_property
    def share_sphere(self) -> bool:
        """Whether S = S'."""
        return self.sphere == self.other_sphere

    @property
    def centre_position(self) -> Position:
        """Where c lies relative to σ."""
        return position(self.first.circumcentre_coordinates)

    def power_drop(self, x: Point) -> Fraction:
        """The right side of the identity: 2 (z(c') - z(c)) z(x)."""
        low, high = self.levels
        return 2 * (high - low) * self.level(x) / self.squared_normal


# -- simplices and pairs, the same in every run -----------------------------------------------------------


def _vertices(rng: random.Random, d: int, count: int) -> tuple[Point, ...]:
    return tuple(point(*(rng.randint(-4, 4) for _ in range(d))) for _ in range(count))


def _on_unit_sphere(rng: random.Random, d: int) -> Point:
    """A rational point of the unit sphere, by the projection from its north pole."""
    y = [Fraction(rng.randint(-4, 4), rng.choice((1, 2))) for _ in range(d - 1)]
    square = sum((x * x for x in y), Fraction(0))
    return point(*(2 * x / (square + 1) for x in y), (square - 1) / (square + 1))


def _is_simplex(vertices: tuple[Point, ...]) -> bool:
    try:
        return len(vertices) == 1 or bool(Simplex(vertices).dimension)
    except DegenerateSimplex:
        return False


def _pairs_with(facet: tuple[Point, ...], apex: Point, others: Iterable[Point]) -> Iterator[Pair]:
    """The pairs with those of the points that lie beyond the facet."""
    if _is_simplex((*facet, apex)):
        for other in others:
            pair = Pair(facet, apex, other)
            if pair.level(other) > 0:
                yield pair


@lru_cache(maxsize=1)
def simplices() -> tuple[tuple[Point, ...], ...]:
    """Simplices of dimension 1 to 6 with small integer vertices."""
    rng, found = random.Random(4), []
    for d in range(1, 7):
        many = (_vertices(rng, d, d + 1) for _ in range(40))
        found += [v for v in many if _is_simplex(v)][:8]
    return tuple(found)


@lru_cache(maxsize=1)
def any_pairs() -> tuple[Pair, ...]:
    """Pairs of dimension 1 to 5 with small integer vertices."""
    rng, found = random.Random(5), []
    for d in range(1, 6):
        for _ in range(12):
            facet, (apex, *others) = _vertices(rng, d, d), _vertices(rng, d, 3)
            found += list(_pairs_with(facet, apex, others))
    return tuple(found)


@lru_cache(maxsize=1)
def separated_pairs() -> tuple[Pair, ...]:
    """Pairs in which the facet separates c from σ, of dimension 2 to 5; some share their sphere.

    S is the unit sphere: rational points on it are plenty, and so are neighbours with their apex on it.
    """
    rng, found = random.Random(6), []
    for d in range(2, 6):
        for _ in range(7 - d):
            vertices = tuple(_on_unit_sphere(rng, d) for _ in range(d + 1))
            if not _is_simplex(vertices):
                continue
            coordinates = Simplex(vertices).circumcentre_coordinates
            for k in (k for k, x in enumerate(coordinates) if x < 0):
                others = [*_vertices(rng, d, 1), _on_unit_sphere(rng, d)]
                others += [tuple(x * 3 / 4 for x in _on_unit_sphere(rng, d)) for _ in range(2)]
                found += list(_pairs_with((*vertices[:k], *vertices[k + 1 :]), vertices[k], others))
    return tuple(found)


@lru_cache(maxsize=1)
def boundary_pairs() -> tuple[Pair, ...]:
    """Pairs whose facet contains c, of dimension 2 to 5: inside the facet, or on an edge of it.

    S is the unit sphere, the facet lies in the hyperplane x_d = 0.
    """
    rng, found = random.Random(7), []
    for d in range(2, 6):
        for turn in range(12):
            equator = [(*_on_unit_sphere(rng, d - 1), Fraction(0)) for _ in range(d)]
            if turn % 2 or d == 2:
                equator[1] = tuple(-x for x in equator[0])
            facet = tuple(equator)
            if not _is_simplex(facet) or min(Simplex(facet).barycentric(point(*[0] * d))) < 0:
                continue
            apex, *above = (_on_unit_sphere(rng, d) for _ in range(3))
            above = [(*x[:-1], -x[-1] if x[-1] * apex[-1] > 0 else x[-1]) for x in above]
            found += list(_pairs_with(facet, apex, [*above, *_vertices(rng, d, 2)]))
    return tuple(found)


@lru_cache(maxsize=1)
def power_identity_holds() -> bool:
    """Whether the identity of this module holds for many pairs, at both apexes and at a point elsewhere."""
    for pair in (*any_pairs(), *separated_pairs()[::3], *boundary_pairs()[::3]):
        far = along(pair.apex, Fraction(7, 3), minus(pair.other, pair.facet[0]))
        for x in (pair.apex, pair.other, far):
            if pair.sphere.power(x) - pair.other_sphere.power(x) != pair.power_drop(x):
                return False
    return True


@lru_cache(maxsize=1)
def mirror_factors() -> frozenset[Fraction]:
    """All values of (|s_k(u_k) - c|² - R²) / (λ_k h_k²), with the mirror images computed as points."""
    found = set()
    for vertices in simplices():
        sphere, coordinates = circumsphere(vertices), Simplex(vertices).circumcentre_coordinates
        for k, (u, x) in enumerate(zip(vertices, coordinates, strict=True)):
            height = height_vector(u, (*vertices[:k], *vertices[k + 1 :]))
            power = sphere.power(along(u, Fraction(-2), height))
            if x:
                found.add(power / (x * inner(height, height)))
            elif power:
                return frozenset()
    return frozenset(found)
