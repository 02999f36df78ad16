"""Exact simplices and points on which the steps of Appendix A are tried."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import combinations
from random import Random

from ..errors import DegenerateSimplex, InvalidInput
from ..exact import Surd, sqrt
from ..paper import printed as paper
from ..simplex import Position, Simplex, position, regular_simplex

Weights = tuple[Fraction, ...]
"""Barycentric coordinates of a point, or differences of two: these add up to zero."""

REACH = 24
"""Formulas are compared with the core up to this dimension."""


def printed_formula(place: str) -> str:
    """The formula that is printed for the regular simplex at a place of the paper."""
    found = [f.text for f in paper().formulas if f.place == place]
    if len(found) != 1:
        raise InvalidInput(f"{len(found)} formulas are recorded for {place!r}: there must be one")
    return found[0]


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


def minus(x: Sequence[Fraction], y: Sequence[Fraction]) -> Weights:
    """The difference of two points."""
    return tuple(a - b for a, b in zip(x, y, strict=True))


def face(simplex: Simplex, indices: Sequence[int]) -> Simplex | None:
    """The face with the given vertices; None for a single vertex."""
    return Simplex([simplex.vertices[i] for i in indices]) if len(indices) > 1 else None


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
        n = self.d + 1
        faces = (face(self.simplex, [j for j in range(n) if j != i]) for i in range(n))
        return tuple(tau.volume if tau else Surd(1) for tau in faces)

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


def random_simplices(d: int, count: int, seed: int, size: int = 4) -> list[Simplex]:
    """Simplices with integer coordinates from -size to size, always the same ones."""
    rng = Random(1000 * seed + d)
    found: list[Simplex] = []
    while len(found) < count:
        rows = [[rng.randint(-size, size) for _ in range(d)] for _ in range(d + 1)]
        try:
            found.append(Simplex(rows))
        except DegenerateSimplex:
            continue
    return found


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


@lru_cache(maxsize=512)
def enclosing_balls(simplex: Simplex) -> tuple[Ball, ...]:
    """All balls that contain the vertices and whose centre is the circumcentre of a face, inside that face.

    There is always exactly one, and it is the minimal enclosing ball.
    """
    edges, n = simplex.squared_edge_lengths.rows(), simplex.dimension + 1
    found = []
    for size in range(2, n + 1):
        for indices in combinations(range(n), size):
            tau = face(simplex, indices)
            assert tau is not None
            if min(tau.circumcentre_coordinates) <= 0:
                continue
            centre = spread(indices, tau.circumcentre_coordinates, n)
            apart = (square(edges, minus(centre, unit(n, i))) for i in range(n))
            if max(apart) <= tau.squared_circumradius:
                found.append(Ball(indices, centre, tau.squared_circumradius))
    return tuple(found)


def spread(indices: Sequence[int], weights: Sequence[Fraction], n: int) -> Weights:
    """Barycentric coordinates in a face as coordinates in the simplex."""
    by_index = dict(zip(indices, weights, strict=True))
    return tuple(by_index.get(i, Fraction(0)) for i in range(n))


@lru_cache(maxsize=512)
def nearest_face(simplex: Simplex) -> tuple[int, ...]:
    """The face whose relative interior contains the point of the simplex nearest to its circumcentre."""
    edges, n = simplex.squared_edge_lengths.rows(), simplex.dimension + 1
    centre = simplex.circumcentre_coordinates
    for size in range(2, n + 1):
        for indices in combinations(range(n), size):
            tau = face(simplex, indices)
            assert tau is not None
            if min(tau.circumcentre_coordinates) <= 0:
                continue
            near = spread(indices, tau.circumcentre_coordinates, n)
            away = minus(centre, near)
            if all(_product(edges, minus(unit(n, i), near), away) <= 0 for i in range(n)):
                return indices
    raise AssertionError("the nearest point lies in the relative interior of one face")


def _product(edges: Sequence[Sequence[Fraction]], x: Weights, y: Weights) -> Fraction:
    n = range(len(x))
    return -sum((x[i] * y[j] * edges[i][j] for i in n for j in n), Fraction(0)) / 2
