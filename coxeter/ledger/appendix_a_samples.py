"""Exact simplices and points on which the steps of Appendix A are tried."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import combinations

from ..exact import Surd, sqrt
from ..simplex import Position, Simplex, position, regular_simplex
from .instances import random_simplices
from .vectors import minus

Weights = tuple[Fraction, ...]
"""Barycentric coordinates of a point, or differences of two: these add up to zero."""

REACH = 24
"""Formulas are compared with the core up to this dimension."""


# -- distances in barycentric coordinates -------------------------------------------------------------------


def inner(edges: Sequence[Sequence[Fraction]], x: Sequence[Surd], y: Sequence[Surd]) -> Surd:
    """The inner product of two vectors Σ x_i v_i and Σ y_i v_i, where the x_i and the y_i add up to 0."""
    n = range(len(x))
    total = sum((x[i] * y[j] * edges[i][j] for i in n for j in n if i != j), Surd(0))
    return -total / 2


def square(edges: Sequence[Sequence[Fraction]], x: Sequence[Fraction]) -> Fraction:
    """The squared length of Σ x_i v_i, where the x_i add up to 0."""
    pairs = combinations(range(len(x)), 2)
    return -sum((x[i] * x[j] * edges[i][j] for i, j in pairs if x[i] and x[j]), Fraction(0))


def unit(n: int, i: int) -> Weights:
    """The barycentric coordinates of vertex i of n."""
    return tuple(Fraction(i == j) for j in range(n))


def face(simplex: Simplex, indices: Sequence[int]) -> Simplex:
    """The face with the given vertices, two or more."""
    return Simplex([simplex.vertices[i] for i in indices])


def facet(simplex: Simplex, i: int) -> Simplex:
    """The facet opposite to vertex i, of a simplex of dimension at least 2."""
    return face(simplex, [j for j in range(simplex.dimension + 1) if j != i])


@dataclass(frozen=True)
class Setting:
    """A simplex and a point p of its affine hull, in the letters of the proof of Lemma 9."""

    simplex: Simplex
    p: Weights

    @cached_property
    def edges(self) -> tuple[Weights, ...]:
        """Squared distances of the vertices."""
        return self.simplex.squared_edge_lengths.rows()

    @property
    def d(self) -> int:
        """The dimension."""
        return self.simplex.dimension

    @property
    def where(self) -> str:
        """Where p lies: inside, on the boundary, outside."""
        name = position(self.p)
        return "on the boundary" if name is Position.BOUNDARY else name.value

    @cached_property
    def at_circumcentre(self) -> bool:
        """Whether p is the circumcentre."""
        return self.p == self.simplex.circumcentre_coordinates

    @cached_property
    def facet_volumes(self) -> tuple[Surd, ...]:
        """F_i, each from its own vertices; 1 for a point."""
        if self.d == 1:
            return Surd(1), Surd(1)
        return tuple(facet(self.simplex, i).volume for i in range(self.d + 1))

    @cached_property
    def total(self) -> Surd:
        """F, the sum of the F_i."""
        return sum(self.facet_volumes, Surd(0))

    @cached_property
    def squares(self) -> Weights:
        """The squared distances of p from the vertices."""
        return tuple(square(self.edges, minus(self.p, unit(self.d + 1, i))) for i in range(self.d + 1))

    @cached_property
    def heights(self) -> tuple[Surd, ...]:
        """h_i."""
        return self.simplex.heights

    @cached_property
    def signed(self) -> tuple[Surd, ...]:
        """The distances of p from the facets, negative where p lies beyond the facet."""
        return tuple(h * x for h, x in zip(self.heights, self.p, strict=True))

    @cached_property
    def unsigned(self) -> tuple[Surd, ...]:
        """r_i: the distances of p from the hyperplanes of the facets."""
        return tuple(map(abs, self.signed))

    @cached_property
    def feet(self) -> Weights:
        """The squared distances of the feet of p and of vertex i on facet i."""
        gradients = self.simplex.gradient_gram
        feet = []
        for i in range(self.d + 1):
            apart = minus(self.p, unit(self.d + 1, i))
            foot = [x - apart[i] * gradients[i, j] / gradients[i, i] for j, x in enumerate(apart)]
            feet.append(square(self.edges, foot))
        return tuple(feet)

    def weigh(self, values: Sequence[Surd | Fraction]) -> Surd:
        """Σ F_i x_i."""
        return sum((f * x for f, x in zip(self.facet_volumes, values, strict=True)), Surd(0))

    @cached_property
    def op(self) -> Weights:
        """The vector from the circumcentre to p, in barycentric coordinates."""
        return minus(self.p, self.simplex.circumcentre_coordinates)

    @cached_property
    def f_oq(self) -> tuple[Surd, ...]:
        """F times the vector from the circumcentre to q."""
        return self._to_q(self.simplex.circumcentre_coordinates)

    @cached_property
    def f_pq(self) -> tuple[Surd, ...]:
        """F times the vector from p to q."""
        return self._to_q(self.p)

    def _to_q(self, start: Weights) -> tuple[Surd, ...]:
        return tuple(f - self.total * x for f, x in zip(self.facet_volumes, start, strict=True))

    @cached_property
    def products(self) -> dict[str, Surd]:
        """F²|op|², F²|oq|², F²|pq|² and F²·op·oq."""
        op = [self.total * x for x in self.op]
        pairs = {"op": (op, op), "oq": (self.f_oq,) * 2, "pq": (self.f_pq,) * 2, "op.oq": (op, self.f_oq)}
        return {name: inner(self.edges, x, y) for name, (x, y) in pairs.items()}

    @property
    def squared_circumradius(self) -> Fraction:
        """R²."""
        return self.simplex.squared_circumradius

    @property
    def d_volumes(self) -> Surd:
        """d times the volume."""
        return self.d * self.simplex.volume


@lru_cache(maxsize=1024)
def moment(setting: Setting, power: int) -> Surd:
    """Σ F_i |p v_i|^power."""
    return setting.weigh([sqrt(x) ** power for x in setting.squares])


# -- the samples -------------------------------------------------------------------------------------------

CORNER = ((0, 0), (1, 0), (0, 1))
"""The right triangle with legs of length 1."""
PYTHAGORAS = ((0, 0), (4, 0), (0, 3))
"""The triangle with sides 3, 4, 5."""
SPIKE = ((0, 0, 0), (1, 0, 0), (3, 1, 0), (1, 2, 3))
"""Its floor separates it from its circumcentre, and the height over it is greater than 1/√2 of an edge."""


@lru_cache(maxsize=16)
def setting_at(vertices: tuple[tuple[int, ...], ...], p: tuple[int, ...]) -> Setting:
    """A simplex and a point, by their coordinates."""
    simplex = Simplex(vertices)
    return Setting(simplex, simplex.barycentric(p))


@lru_cache(maxsize=1)
def simplices() -> tuple[Simplex, ...]:
    """Some simplices of dimension 1 to 3, right, obtuse and regular ones among them."""
    corner = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
    given = (((0,), (1,)), CORNER, PYTHAGORAS, ((0, 0), (4, 0), (-5, 12)), corner)
    return (*map(Simplex, given), regular_simplex(2), regular_simplex(3))


@lru_cache(maxsize=1)
def settings() -> tuple[Setting, ...]:
    """These simplices, each with points inside, on the boundary and outside; vertices, centres."""
    return tuple(Setting(s, p) for s in simplices() for p in _points(s))


def _points(s: Simplex) -> list[Weights]:
    n = s.dimension + 1
    centroid = (Fraction(1, n),) * n
    outside = (Fraction(-1), *[Fraction(2, n - 1)] * (n - 1))
    uneven = tuple(Fraction(2 * i + 1, n * n) for i in range(n))
    middle = tuple(Fraction(i > 0, n - 1) for i in range(n))
    return list(dict.fromkeys([s.circumcentre_coordinates, centroid, unit(n, 0), outside, uneven, middle]))


@lru_cache(maxsize=1)
def shapes() -> tuple[Simplex, ...]:
    """More simplices, of dimension 1 to 5, for statements without a point."""
    counts = {2: 10, 3: 10, 4: 6, 5: 3}
    drawn = (s for d, count in counts.items() for s in random_simplices(d, count, seed=1))
    return (*simplices(), Simplex(SPIKE), regular_simplex(4), *drawn)


# -- balls and faces ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Ball:
    """The minimal enclosing ball of the vertices: the face that carries it, its centre and radius."""

    carrier: tuple[int, ...]
    centre: Weights
    squared_radius: Fraction


def _balls_of_faces(simplex: Simplex) -> Iterator[Ball]:
    """The balls through the vertices of a face, about its circumcentre, for faces that have it inside."""
    n = simplex.dimension + 1
    for indices in (x for size in range(2, n + 1) for x in combinations(range(n), size)):
        tau = face(simplex, indices)
        if min(tau.circumcentre_coordinates) > 0:
            weights = dict(zip(indices, tau.circumcentre_coordinates, strict=True))
            centre = tuple(weights.get(i, Fraction(0)) for i in range(n))
            yield Ball(indices, centre, tau.squared_circumradius)


@lru_cache(maxsize=512)
def enclosing_balls(simplex: Simplex) -> tuple[Ball, ...]:
    """Those of these balls that contain all vertices: always one, the minimal enclosing ball."""
    edges, n = simplex.squared_edge_lengths.rows(), simplex.dimension + 1

    def encloses(ball: Ball) -> bool:
        apart = (square(edges, minus(ball.centre, unit(n, i))) for i in range(n))
        return max(apart) <= ball.squared_radius

    return tuple(filter(encloses, _balls_of_faces(simplex)))


@lru_cache(maxsize=512)
def nearest_face(simplex: Simplex) -> tuple[int, ...]:
    """The face whose relative interior contains the point of the simplex nearest to its circumcentre."""
    edges, n = simplex.squared_edge_lengths.rows(), simplex.dimension + 1
    for ball in _balls_of_faces(simplex):
        away = minus(simplex.circumcentre_coordinates, ball.centre)
        if all(_product(edges, minus(unit(n, i), ball.centre), away) <= 0 for i in range(n)):
            return ball.carrier
    raise AssertionError("the nearest point lies in the relative interior of one face")


def _product(edges: Sequence[Sequence[Fraction]], x: Weights, y: Weights) -> Fraction:
    n = range(len(x))
    return -sum((x[i] * y[j] * edges[i][j] for i in n for j in n), Fraction(0)) / 2
