"""Coxeter triangulations: affine reflections, alcoves, the fundamental simplex (paper, Section 2.4).

The hyperplanes <x, r> = k, for all roots r and integers k, cut space into alcoves. The closure of
the alcove 0 < <x, r> < 1 is the *fundamental simplex*; it is bounded by the walls of the simple
roots, <x, s_k> = 0, and by that of the highest root, <x, s~> = 1 (Proposition 5). Its vertices are the
origin and the fundamental coweights divided by the marks.

Reference: Humphreys, Chapter 4.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial

import numpy as np

from .errors import InvalidInput
from .exact import RationalMatrix, as_vector, rational, show
from .exact.matrices import INT64_SAFE
from .names import Type, parse_triangulation
from .roots import RootSystem
from .simplex import Simplex

Vector = tuple[Fraction, ...]


def triangulation(name: object) -> CoxeterTriangulation:
    """The Coxeter triangulation of a given type.

    Parameters
    ----------
    name
        Such as ``"B~5"``, ``"B̃5"`` or ``("B", 5)``.

    Raises
    ------
    InvalidType
        If there is no such triangulation; in particular B~ needs d >= 3, D~ needs d >= 4.

    Examples
    --------
    >>> triangulation("C~2").simplex.vertex_matrix
    RationalMatrix([[0, 0], [1/2, 0], [1/2, 1/2]])
    """
    return CoxeterTriangulation(parse_triangulation(name))


@dataclass(frozen=True)
class Facet:
    """A facet of the fundamental simplex: <x, normal> >= offset on the simplex, equal on the facet.

    Attributes
    ----------
    index
        The facet tau_index lies opposite to the vertex u_index.
    normal
        The inward normal: the simple root, or minus the highest root for facet 0.
    offset
        0, or -1 for facet 0.
    """

    index: int
    normal: Vector
    offset: int

    def level(self, point: Sequence[Fraction]) -> Fraction:
        """<point, normal> - offset: positive inside, zero on the facet, negative beyond it."""
        return _inner(point, self.normal) - self.offset

    def reflect(self, point: Sequence[Fraction]) -> Vector:
        """The mirror image of a point in the hyperplane of the facet."""
        factor = 2 * self.level(point) / _inner(self.normal, self.normal)
        return tuple(x - factor * n for x, n in zip(point, self.normal, strict=True))


@dataclass(frozen=True)
class Folding:
    """The image of a point in the fundamental simplex, and the reflections that carried it there.

    Attributes
    ----------
    point
        The image, in the fundamental simplex.
    barycentric
        Its barycentric coordinates there.
    word
        Indices of the facets in which the point was reflected, in this order.
    """

    point: Vector
    barycentric: Vector
    word: tuple[int, ...]


def affine_reflection(root: Sequence[object], k: int, point: Sequence[object]) -> Vector:
    """The reflection of a point in the hyperplane <x, root> = k (Definition 14).

    >>> affine_reflection((1, 1), 1, (0, 0))
    (Fraction(1, 1), Fraction(1, 1))
    """
    r = as_vector(root, len(root))
    x = as_vector(point, len(r))
    square = _inner(r, r)
    if not square:
        raise InvalidInput("the root is zero: there is no hyperplane to reflect in")
    factor = 2 * (_inner(x, r) - rational(k)) / square
    return tuple(a - factor * b for a, b in zip(x, r, strict=True))


@dataclass(frozen=True)
class CoxeterTriangulation:
    """A Coxeter triangulation of R^d; make one with `triangulation`.

    It is a value, cheap to make; everything else is derived when it is asked for, and kept.
    """

    type: Type

    @property
    def name(self) -> str:
        """The ASCII name, as ``B~5``."""
        return self.type.affine

    @property
    def dimension(self) -> int:
        """The dimension d."""
        return self.type.rank

    def __repr__(self) -> str:
        return f"triangulation({self.name!r})"

    @cached_property
    def roots(self) -> RootSystem:
        """The root system whose hyperplanes make the triangulation."""
        return RootSystem(self.type)

    @cached_property
    def marks(self) -> tuple[int, ...]:
        """1 for node 0, then the marks m_1 … m_d of the highest root."""
        return (1, *self.roots.marks)

    # -- the fundamental simplex --------------------------------------------------------------------

    @cached_property
    def simplex(self) -> Simplex:
        """The fundamental simplex, its vertices u_0 = 0 and u_k = (coweight k) / m_k.

        >>> triangulation("B~3").simplex.circumcentre
        (Fraction(1, 2), Fraction(0, 1), Fraction(1, 4))
        """
        gram, marks = self.roots.inverse_gram, np.array(self.marks[1:], dtype=np.int64)
        determinant = 1 / (self.roots.gram_determinant * math.prod(self.marks) ** 2)
        inverse_marks, common = _inverse(marks)
        edge_gram = _scaled(gram, inverse_marks, inverse_marks, common**2)
        return Simplex.from_gram_pair(
            partial(getattr, self, "_vertices"),
            edge_gram,
            partial(getattr, self, "_gradient_gram"),
            determinant,
        )

    @cached_property
    def _vertices(self) -> RationalMatrix:
        coweights = self.roots.fundamental_coweights
        inverse_marks, common = _inverse(np.array(self.marks[1:], dtype=np.int64))
        rows = np.zeros((self.dimension + 1, coweights.shape[1]), dtype=coweights.numerators.dtype)
        rows[1:] = coweights.numerators * inverse_marks[:, None]
        return _lowest_terms(RationalMatrix(rows, coweights.denominator * common))

    @cached_property
    def _gradient_gram(self) -> RationalMatrix:
        """Inner products of the gradients m_k s_k, for node 0 those of minus the highest root."""
        products = self.roots._affine_products
        scale = math.lcm(*(x.denominator for row in products.values() for x in row.values()))
        full = np.zeros((self.dimension + 1, self.dimension + 1), dtype=np.int64)
        for i, row in products.items():
            for j, x in row.items():
                full[i, j] = int(x * scale) * self.marks[i] * self.marks[j]
        return RationalMatrix(full, scale)

    @cached_property
    def facets(self) -> tuple[Facet, ...]:
        """The facets tau_0 … tau_d with inward normals (Proposition 5)."""
        top = Facet(0, tuple(-x for x in self.roots.highest_root), -1)
        rows = self.roots.simple_roots.rows()
        return (top, *(Facet(k, row, 0) for k, row in enumerate(rows, 1)))

    def dihedral_angle(self, i: int, j: int) -> Fraction:
        """The angle between facets i and j, as a multiple of pi: always 1/m with m in {2, 3, 4, 6}.

        >>> triangulation("G~2").dihedral_angle(1, 2)
        Fraction(1, 6)
        """
        cosine = self.simplex.dihedral_cosine(i, j)
        return Fraction(1, _ORDER_BY_COSINE[(cosine * cosine * 4).as_fraction()])

    def dihedral_angles(self) -> dict[tuple[int, int], Fraction]:
        """All dihedral angles, as multiples of pi, by pairs i < j of facets."""
        n = self.dimension + 1
        return {(i, j): self.dihedral_angle(i, j) for i in range(n) for j in range(i + 1, n)}

    # -- points ---------------------------------------------------------------------------------------

    def levels(self, point: Sequence[object]) -> Vector:
        """<point, normal> - offset for each facet: all are positive inside the fundamental simplex.

        Raises
        ------
        InvalidInput
            If the point has the wrong length or lies outside the span of the roots.
        """
        simple, coweights = self.roots.simple_roots, self.roots.fundamental_coweights
        x = as_vector(point, simple.shape[1])
        row = RationalMatrix.from_rows([x])
        products = row @ simple.T
        if products @ coweights != row:
            raise InvalidInput(f"{show(x)} does not lie in the span of the roots of {self.name}")
        inner = products.row(0)
        return (
            1 - sum((m * y for m, y in zip(self.marks[1:], inner, strict=True)), Fraction(0)),
            *inner,
        )

    def fold(self, point: Sequence[object]) -> Folding:
        """Carry a point into the fundamental simplex by reflections in its facets.

        A reflection in facet k changes only the levels of the nodes joined to k, level j by
        -n(s_j, s_k) times level k. As long as a level is negative its facet is reflected in; each
        step brings the point closer to any interior point, and its orbit is discrete, so this ends.
        There are as many steps as hyperplanes between the point and the simplex: move a point that
        lies far away by a vector of the coroot lattice first.

        Raises
        ------
        InvalidInput
            If the point has the wrong length or lies outside the span of the roots.

        Examples
        --------
        >>> triangulation("C~2").fold((1, 1)).word
        (0, 1, 0)
        """
        level, word = list(self.levels(point)), []
        products = self.roots._affine_products
        beyond = [k for k, x in enumerate(level) if x < 0]
        while beyond:
            k = beyond.pop()
            x = level[k]
            if x >= 0:
                continue
            word.append(k)
            for j, product in products[k].items():
                level[j] -= 2 * product / products[k][k] * x
                if level[j] < 0:
                    beyond.append(j)
        coordinates = tuple(m * x for m, x in zip(self.marks, level, strict=True))
        image = (RationalMatrix.from_rows([coordinates]) @ self._vertices).row(0)
        return Folding(image, coordinates, tuple(word))

    def unfold(self, word: Sequence[int], point: Sequence[Fraction]) -> Vector:
        """Undo the reflections of a word: the inverse of `fold`."""
        x = tuple(point)
        if not set(word) <= set(range(self.dimension + 1)):
            raise InvalidInput(f"{tuple(word)} names no facets: there are 0 to {self.dimension}")
        for k in reversed(word):
            x = self.facets[k].reflect(x)
        return x

    def is_vertex(self, point: Sequence[object]) -> bool:
        """Whether a point is a vertex of the triangulation: whether it folds to one of u_0 … u_d.

        >>> b = triangulation("B~3")
        >>> b.is_vertex(("1/2", "1/2", "1/2")), b.is_vertex((0, 0, "1/2"))
        (True, False)
        """
        return sum(1 for x in self.fold(point).barycentric if x) == 1

    def integral_roots(self, point: Sequence[object]) -> RationalMatrix:
        """The positive roots whose inner product with a point is an integer, as rows."""
        x = as_vector(point, self.roots.simple_roots.shape[1])
        roots = self.roots.positive_roots
        column = RationalMatrix.from_rows([[c] for c in x])
        product = roots @ column
        chosen = (product.numerators[:, 0].astype(object) % product.denominator) == 0
        return RationalMatrix(roots.numerators[chosen], roots.denominator)

    def is_vertex_by_rank(self, point: Sequence[object]) -> bool:
        """Whether d hyperplanes with independent normals meet in a point: the definition of a vertex.

        A second route to `is_vertex`; it scans all roots, so it is slower.
        """
        self.levels(point)  # refuses a point outside the span
        chosen = self.integral_roots(point)
        return bool(len(chosen.numerators)) and chosen.rank() == self.dimension


_ORDER_BY_COSINE = {Fraction(n): m for n, m in ((0, 2), (1, 3), (2, 4), (3, 6))}
"""4·cos²(pi/m) -> m."""


def _inner(a: Sequence[Fraction], b: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True) if x and y), Fraction(0))


def _inverse(marks: np.ndarray) -> tuple[np.ndarray, int]:
    """The inverses of integers, as integers over a common denominator."""
    common = math.lcm(*(int(m) for m in set(marks.tolist())))
    return common // marks, common


def _scaled(a: RationalMatrix, rows: np.ndarray, columns: np.ndarray, over: int) -> RationalMatrix:
    """The matrix with entry (i, j) multiplied by ``rows[i] * columns[j] / over``."""
    n = a.numerators
    if n.dtype != object and int(np.abs(n).max()) * int(rows.max()) * int(columns.max()) >= INT64_SAFE:
        n = n.astype(object)
    return _lowest_terms(RationalMatrix(n * rows[:, None] * columns[None, :], a.denominator * over))


def _lowest_terms(a: RationalMatrix) -> RationalMatrix:
    common = math.gcd(int(np.gcd.reduce(a.numerators, axis=None)), a.denominator)
    return RationalMatrix(a.numerators // common, a.denominator // common)
