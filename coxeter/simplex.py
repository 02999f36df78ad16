"""One exact simplex, from any vertices (paper, Section 3).

Everything metric about a simplex with vertices u_0 … u_d is in two matrices: the Gram matrix Q of
its edges u_k - u_0, and the Gram matrix Γ of the gradients of its barycentric coordinates, which
point inwards and have length one over the heights. The rows k, k' >= 1 of Γ are the inverse of Q.
For the fundamental simplices of Coxeter triangulations both are known from the root system; for
vertices given by a user Γ is found by inverting Q. What follows below is the same for both.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Sequence
from enum import Enum
from fractions import Fraction
from functools import cached_property, lru_cache, partial

import numpy as np

from .angles import WithAngles
from .errors import DegenerateSimplex, InvalidInput
from .exact import Exact, RationalMatrix, Surd, sqrt
from .exact.matrices import integer_product, narrow
from .exact.points import gram_of_edges, read_points


class Position(Enum):
    """Where a point lies relative to a simplex."""

    INSIDE = "inside"
    BOUNDARY = "boundary"
    OUTSIDE = "outside"


def position(barycentric: Sequence[Fraction]) -> Position:
    """Where the point with given barycentric coordinates lies."""
    least = min(barycentric)
    if least > 0:
        return Position.INSIDE
    return Position.OUTSIDE if least < 0 else Position.BOUNDARY


class Simplex(WithAngles):
    """A d-simplex with exact vertices, in a space of any dimension at least d.

    Parameters
    ----------
    vertices
        d + 1 points of equal length, their coordinates exact: integers, fractions, text such as
        ``"1/2"`` or ``"sqrt(3)/2"``, SymPy numbers. Squared edge lengths must be rational.

    Raises
    ------
    InexactInput
        If a coordinate is a floating-point number.
    DegenerateSimplex
        If the points are affinely dependent.
    InvalidInput
        If their lengths differ, there are fewer than two, or a squared edge length is irrational.

    Examples
    --------
    >>> triangle = Simplex([(0, 0), (1, 0), (1, "sqrt(3)")])
    >>> triangle.circumradius, triangle.inradius, triangle.minimal_height, triangle.volume
    (1, 1/(1 + sqrt(3)), sqrt(3)/2, sqrt(3)/2)
    """

    def __init__(self, vertices: Sequence[Sequence[object]]) -> None:
        points = read_points(vertices)
        self._irrational: tuple[tuple[Exact, ...], ...] = ()
        self._matrix: Callable[[], RationalMatrix] | None = None
        if all(isinstance(x, Fraction) for point in points for x in point):
            v = RationalMatrix.from_rows(points)
            self._matrix = partial(_given, v)
            edges = RationalMatrix(v.numerators[1:] - v.numerators[:1], v.denominator)
            self.edge_gram = edges @ edges.T
        else:
            self._irrational = points
            self.edge_gram = gram_of_edges(points)
        rank = self.edge_gram.rank()
        if rank < len(points) - 1:
            raise DegenerateSimplex(
                f"{len(points)} points whose affine hull has dimension {rank} are no simplex: "
                f"they must be affinely independent"
            )
        self.gram_determinant = self.edge_gram.det()
        self._gradients: Callable[[], RationalMatrix] = partial(_gradients_of, self.edge_gram)

    @classmethod
    def from_gram_pair(
        cls,
        vertices: Callable[[], RationalMatrix],
        edge_gram: RationalMatrix,
        gradient_gram: Callable[[], RationalMatrix],
        gram_determinant: Fraction,
    ) -> Simplex:
        """A simplex whose two Gram matrices are known, so that nothing need be inverted.

        Parameters
        ----------
        vertices
            Called when coordinates are asked for; returns the d + 1 vertices as rows.
        edge_gram
            Inner products of the edges u_k - u_0, shape (d, d).
        gradient_gram
            Called when needed; returns the inner products of the gradients, shape (d + 1, d + 1).
        gram_determinant
            The determinant of `edge_gram`.
        """
        self = object.__new__(cls)
        self.edge_gram, self.gram_determinant = edge_gram, gram_determinant
        self._matrix, self._gradients, self._irrational = vertices, gradient_gram, ()
        return self

    def __repr__(self) -> str:
        return f"<Simplex of dimension {self.dimension}>"

    # -- vertices and edges ------------------------------------------------------------------------

    @property
    def dimension(self) -> int:
        """The dimension d."""
        return self.edge_gram.shape[0]

    @property
    def vertices(self) -> tuple[tuple[Exact, ...], ...]:
        """The vertices u_0 … u_d as tuples of exact numbers."""
        return self._matrix().rows() if self._matrix else self._irrational

    @property
    def vertex_matrix(self) -> RationalMatrix:
        """The vertices as rows of a rational matrix; raises `InvalidInput` if one is irrational."""
        if self._matrix is None:
            raise InvalidInput("the simplex has irrational vertices: use `vertices`")
        return self._matrix()

    @cached_property
    def squared_edge_lengths(self) -> RationalMatrix:
        """The squared distances of all pairs of vertices, of shape (d + 1, d + 1)."""
        q = self.edge_gram.numerators
        full = np.zeros((len(q) + 1, len(q) + 1), dtype=q.dtype)
        full[1:, 1:] = q
        squares = full.diagonal()
        return RationalMatrix(squares[:, None] + squares[None, :] - 2 * full, self.edge_gram.denominator)

    @cached_property
    def squared_longest_edge(self) -> Fraction:
        """The square of the longest edge length."""
        e = self.squared_edge_lengths
        return Fraction(int(e.numerators.max()), e.denominator)

    @cached_property
    def squared_shortest_edge(self) -> Fraction:
        """The square of the shortest edge length."""
        e = self.squared_edge_lengths
        off_diagonal = ~np.eye(self.dimension + 1, dtype=bool)
        return Fraction(int(e.numerators[off_diagonal].min()), e.denominator)

    @property
    def longest_edge(self) -> Surd:
        """L, the length of a longest edge (Definition 18)."""
        return sqrt(self.squared_longest_edge)

    @property
    def shortest_edge(self) -> Surd:
        """The length of a shortest edge."""
        return sqrt(self.squared_shortest_edge)

    @cached_property
    def sum_of_squared_edges(self) -> Fraction:
        """The sum of the squared lengths of all edges."""
        e = self.squared_edge_lengths
        return Fraction(int(e.numerators.sum(dtype=object)), 2 * e.denominator)

    def longest_edges(self) -> tuple[tuple[int, int], ...]:
        """The pairs (i, j), i < j, of vertices that a longest edge joins."""
        e = self.squared_edge_lengths.numerators
        return tuple((int(i), int(j)) for i, j in zip(*np.nonzero(e == e.max()), strict=True) if i < j)

    @cached_property
    def volume(self) -> Surd:
        """The d-dimensional volume, the root of the Gram determinant of the edges, over d!."""
        return sqrt(self.gram_determinant) / math.factorial(self.dimension)

    # -- heights -------------------------------------------------------------------------------------

    @cached_property
    def gradient_gram(self) -> RationalMatrix:
        """Γ, inner products of the gradients of the barycentric coordinates, (d + 1, d + 1).

        The gradient of coordinate k is the inward normal of the facet opposite to vertex k, with
        length one over the height from that vertex.
        """
        return self._gradients()

    @cached_property
    def squared_heights(self) -> tuple[Fraction, ...]:
        """The squared distance from each vertex to the facet opposite to it."""
        g = self.gradient_gram
        return tuple(Fraction(g.denominator, int(x)) for x in g.numerators.diagonal())

    @property
    def heights(self) -> tuple[Surd, ...]:
        """The height from each vertex."""
        return tuple(sqrt(x) for x in self.squared_heights)

    @property
    def minimal_height(self) -> Surd:
        """h, the least height (Definition 18)."""
        return sqrt(min(self.squared_heights))

    @cached_property
    def sum_of_inverse_squared_heights(self) -> Fraction:
        """The sum of one over the squared height from each vertex, the trace of Γ."""
        g = self.gradient_gram
        return Fraction(int(g.numerators.diagonal().sum(dtype=object)), g.denominator)

    # -- centres and radii --------------------------------------------------------------------------

    @cached_property
    def circumcentre_coordinates(self) -> tuple[Fraction, ...]:
        """The barycentric coordinates of the circumcentre; they are rational.

        With ``q_k = |u_k - u_0|²``, coordinate j is ``[j = 0] + ½ Σ_k q_k Γ_kj``.
        """
        g, q = self.gradient_gram, self._squared_from_first()
        sums = integer_product(g.numerators[:, 1:], q)
        scale = 2 * g.denominator * self.edge_gram.denominator
        return tuple(Fraction(int(s), scale) + (j == 0) for j, s in enumerate(sums))

    def _squared_from_first(self) -> np.ndarray:
        return np.asarray(self.edge_gram.numerators.diagonal())

    @cached_property
    def squared_circumradius(self) -> Fraction:
        """The square of the circumradius, ½ Σ_k q_k λ_k with the circumcentre's coordinates λ."""
        pairs = zip(self._squared_from_first(), self.circumcentre_coordinates[1:], strict=True)
        total = sum((int(q) * x for q, x in pairs), Fraction(0))
        return total / (2 * self.edge_gram.denominator)

    @property
    def circumradius(self) -> Surd:
        """R, the radius of the sphere through all vertices."""
        return sqrt(self.squared_circumradius)

    @cached_property
    def circumcentre(self) -> tuple[Exact, ...]:
        """The centre of the sphere through all vertices, in the space of the vertices."""
        return self.point(self.circumcentre_coordinates)

    @cached_property
    def _sum_of_inverse_heights(self) -> Surd:
        counts = Counter(self.squared_heights)
        return sum((k * sqrt(1 / x) for x, k in counts.items()), Surd(0))

    @property
    def inradius(self) -> Surd:
        """r, the radius of the inscribed ball, one over the sum of the inverse heights."""
        return 1 / self._sum_of_inverse_heights

    @cached_property
    def incentre(self) -> tuple[Surd, ...]:
        """The centre of the inscribed ball; vertex k has the weight of one over its height."""
        parts: dict[int, dict[int, Fraction]] = {}  # radicand -> vertex -> rational factor
        for k, square in enumerate(self.squared_heights):
            ((radicand, factor),) = sqrt(1 / square).num
            parts.setdefault(radicand, {})[k] = factor
        total = self._sum_of_inverse_heights
        weights = {n: [w.get(k, Fraction(0)) for k in range(self.dimension + 1)] for n, w in parts.items()}
        points = [[sqrt(n) * x for x in self.point(w)] for n, w in weights.items()]
        return tuple(sum(column, Surd(0)) / total for column in zip(*points, strict=True))

    # -- points -------------------------------------------------------------------------------------

    def point(self, barycentric: Sequence[Fraction]) -> tuple[Exact, ...]:
        """The point with given barycentric coordinates."""
        if len(barycentric) != self.dimension + 1:
            raise InvalidInput(f"{len(barycentric)} coordinates, {self.dimension + 1} are needed")
        if self._matrix is None:
            columns = zip(*self.vertices, strict=True)
            return tuple(sum(w * x for w, x in zip(barycentric, c, strict=True)) for c in columns)
        weights = RationalMatrix.from_rows([barycentric])
        return (weights @ self.vertex_matrix).row(0)

    def barycentric(self, point: Sequence[object]) -> tuple[Fraction, ...]:
        """The barycentric coordinates of a point of the simplex's affine hull.

        Raises `InvalidInput` if the point does not lie there. Rational vertices only.

        >>> [str(x) for x in Simplex([(0, 0), (1, 0), (0, 1)]).barycentric(("1/2", "1/4"))]
        ['1/4', '1/2', '1/4']
        """
        v = self.vertex_matrix
        x = RationalMatrix.from_rows([point])
        if x.shape[1] != v.shape[1]:
            raise InvalidInput(f"the point has {x.shape[1]} coordinates, {v.shape[1]} are needed")
        difference = _minus_first(x, v)
        edges = _minus_first(RationalMatrix(v.numerators[1:], v.denominator), v)
        inner = (difference @ edges.T).numerators
        g = self.gradient_gram
        scale = difference.denominator * edges.denominator * g.denominator
        sums = integer_product(g.numerators[:, 1:], inner[0])
        result = tuple(Fraction(int(s), scale) + (j == 0) for j, s in enumerate(sums))
        if self.point(result) != x.row(0):
            raise InvalidInput("the point does not lie in the affine hull of the simplex")
        return result


def regular_simplex(d: int) -> Simplex:
    """The regular d-simplex with edges of length √2: the unit vectors of R^(d+1).

    >>> regular_simplex(3).volume, regular_simplex(3).circumradius
    (1/3, sqrt(3)/2)
    """
    if not isinstance(d, (int, np.integer)) or d < 1:
        raise InvalidInput(f"{d!r} is no dimension: give an integer >= 1")
    return _regular_simplex(int(d))


@lru_cache(maxsize=8)
def _regular_simplex(d: int) -> Simplex:
    edges = RationalMatrix(np.ones((d, d), dtype=np.int64) + np.eye(d, dtype=np.int64))
    gradients = RationalMatrix((d + 1) * np.eye(d + 1, dtype=np.int64) - 1, d + 1)
    vertices = partial(RationalMatrix.identity, d + 1)
    return Simplex.from_gram_pair(vertices, edges, partial(_given, gradients), Fraction(d + 1))


def _given(matrix: RationalMatrix) -> RationalMatrix:
    return matrix


def _gradients_of(edge_gram: RationalMatrix) -> RationalMatrix:
    """Border the inverse Gram matrix of the edges: the gradients sum to zero."""
    inverse = edge_gram.inverse()
    y = inverse.numerators.astype(object)
    full = np.empty((len(y) + 1, len(y) + 1), dtype=object)
    full[1:, 1:] = y
    full[0, 1:] = full[1:, 0] = -y.sum(axis=0)
    full[0, 0] = y.sum()
    return RationalMatrix(narrow(full), inverse.denominator)


def _minus_first(rows: RationalMatrix, vertices: RationalMatrix) -> RationalMatrix:
    common = math.lcm(rows.denominator, vertices.denominator)
    a = rows.numerators.astype(object) * (common // rows.denominator)
    b = vertices.numerators[:1].astype(object) * (common // vertices.denominator)
    return RationalMatrix(narrow(a - b), common)
