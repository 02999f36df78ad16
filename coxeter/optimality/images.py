"""Affine images of Coxeter triangulations: none is better than the triangulation itself (paper, Section 1.4).

Let a linear map M act on a triangulation T. All lengths in the image are given by the quadratic form Q = MᵀM:
an edge e has the squared length Q(e). For a simplex with vertices u_i of T, in the metric of Q,

* the squared length of an edge is linear in Q, so that of the *longest* is convex, of the *shortest* concave;
* a squared height is the least Q(u_k - y) of all y in the plane of the opposite facet: it is *concave*;
* ``R² = max Σ_{i<j} λ_i λ_j Q(u_i - u_j)`` over all real λ with sum 1, as the sum is R² - Q(c - Σ λ_i u_i)
  with the circumcentre c: it is *convex*;
* r² is a power mean of the squared heights, with exponent -1/2: it is *concave*;
* vol^(2/d) is, up to a factor, det(Q)^(1/d): it is *concave*, by Minkowski.

All of these are homogeneous of degree 1. So the square of each measure of Definition 18 (fatness: its power
2/d) is a quotient f/g of a concave and a convex function, and if f >= s·g holds for two forms and s >= 0, it
holds for their sum. The same is then true of the least value over all simplices of the image, which is its
*quality*.

Let W be the finite Weyl group. It maps T to itself, up to a translation, so that Q and Q∘w give the same
simplices, and the same quality. Hence the mean of all Q∘w is at least as good as Q. It is invariant under W,
which is irreducible, so it is a multiple of the scalar product: a scaled copy of T.  *No affine image of a
Coxeter triangulation is of better quality than itself, in any of the four measures and in any dimension.*
Moreover, if the quality at Q is less than at the mean, all other forms on the segment from Q to the mean are
better than Q: a local optimum is a global one, and an image that is worse is not even locally optimal: see
`verdicts`.

The power of a vertex over the sphere of a simplex is linear in Q, so relative protection, too, grows with a
quotient of that kind, as long as no power is negative: that is, among the images that are Delaunay.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import pairwise, permutations

from ..affine import CoxeterTriangulation, triangulation
from ..errors import InvalidInput, Undecided
from ..exact import RationalMatrix, Surd, rational, sqrt
from ..quality import Measure, find_measure
from ..simplex import Simplex, _gradients_of

Gram = tuple[tuple[Fraction, ...], ...]

MOST_SIMPLICES = 50_000
"""Finite Weyl groups beyond this order are not gone through."""


@dataclass(frozen=True, eq=False)
class AffineImage:
    """The image of a Coxeter triangulation under an affine map; make one with `affine_image`.

    Attributes
    ----------
    triangulation
        The Coxeter triangulation.
    gram
        The inner products of the edges from u_0 in the image of the fundamental simplex, of shape (d, d).
    """

    triangulation: CoxeterTriangulation
    gram: RationalMatrix

    def __repr__(self) -> str:
        return f"<affine image of {self.triangulation.name}>"

    @cached_property
    def simplices(self) -> tuple[Simplex, ...]:
        """The simplices of the image up to translation, one for each Gram matrix of their edges.

        Raises `Undecided` if the finite Weyl group has more than `MOST_SIMPLICES` elements.
        """
        return tuple(simplex_of_gram(gram) for gram in self._grams)

    @cached_property
    def _grams(self) -> tuple[RationalMatrix, ...]:
        order = self.triangulation.roots.weyl_group_order
        if order > MOST_SIMPLICES:
            raise Undecided(f"{order} simplices are too many to look at all: give a smaller dimension")
        moves = reflections(self.triangulation)
        found, new = {self.gram.rows(): self.gram}, [self.gram]
        while new:
            images = (s @ gram @ s.T for gram in new for s in moves)
            fresh = {gram.rows(): gram for gram in images if gram.rows() not in found}
            found |= fresh
            new = list(fresh.values())
        return tuple(found.values())

    def quality(self, measure: str | Measure[Surd]) -> Surd:
        """The least value of a measure over all simplices.

        >>> from coxeter.simplex import Simplex
        >>> kuhn = affine_image("A~3", Simplex([(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)]))
        >>> kuhn.quality("thickness"), affine_image("A~3").quality("thickness")
        (sqrt(6)/6, sqrt(2)/2)
        """
        known: Measure[Surd] = measure if isinstance(measure, Measure) else find_measure(measure)
        return min(known(simplex) for simplex in self.simplices)

    @property
    def mean(self) -> AffineImage:
        """The mean over the finite Weyl group: the Coxeter triangulation itself, scaled.

        A form that the group leaves alone is a multiple of the scalar product; the trace says of which.
        """
        home = self.triangulation.simplex.edge_gram
        product = home.inverse() @ self.gram
        trace = Fraction(int(product.numerators.trace()), product.denominator)
        return AffineImage(self.triangulation, _times(trace / self.triangulation.dimension, home))

    def towards_mean(self, t: object) -> AffineImage:
        """The image at a share t, from 0 to 1, of the way to the mean, on a segment of Gram matrices."""
        share = rational(t)
        if not 0 <= share <= 1:
            raise InvalidInput(f"{t!r} is no share of the way: give a rational number from 0 to 1")
        rows = zip(_times(1 - share, self.gram).rows(), _times(share, self.mean.gram).rows(), strict=True)
        sums = [[x + y for x, y in zip(a, b, strict=True)] for a, b in rows]
        return AffineImage(self.triangulation, RationalMatrix.from_rows(sums))

    @property
    def superbase(self) -> RationalMatrix:
        """For type A~: the products <b_i, b_j> of the d + 1 vectors with sum 0 that join u_0, u_1 … u_d, u_0.

        >>> affine_image("A~2").superbase
        RationalMatrix([[2/3, -1/3, -1/3], [-1/3, 2/3, -1/3], [-1/3, -1/3, 2/3]])
        """
        if self.triangulation.type.letter != "A":
            raise InvalidInput(f"{self.triangulation.name} has no superbase: only images of A~ have")
        d = self.triangulation.dimension
        rows = [[(k == i) - (k == i - 1) for k in range(d)] for i in range(d)]
        b = RationalMatrix.from_rows([[-(k == d - 1) for k in range(d)], *rows])
        return b @ self.gram @ b.T

    @property
    def least_weight(self) -> Fraction:
        """For type A~: the least -<b_i, b_j> of two vectors of the superbase.

        The image is Delaunay if it is not negative, and protected if it is positive.

        >>> from coxeter.simplex import Simplex
        >>> affine_image("A~2", Simplex([(0, 0), (1, 0), (1, 1)])).least_weight
        Fraction(0, 1)
        """
        b = self.superbase.rows()
        return min(-row[j] for i, row in enumerate(b) for j in range(i))

    @property
    def relative_protection(self) -> Surd:
        """For type A~: the relative protection of Definition 19; 0 if the image is not Delaunay.

        Let b_0 … b_d be the superbase, p_ij = -<b_i, b_j>. A simplex has the vertices v_k = b_π(0) + … +
        b_π(k-1) for an order π of 0 … d. Let y_i be the coordinates of a vertex x of the triangulation, that
        is x = Σ y_i b_i with integers y_i. Then Q(x) = Σ_{i<j} p_ij (y_i - y_j)², and for the simplex of the
        order 0 … d, say, the power of x over the sphere is ``Σ_{i<j} p_ij z(z - 1)``, z = y_i - y_j: both
        sides are quadratic in x with the same leading part, and vanish at all v_k. As z(z - 1) is 0 or at
        least 2, the triangulation is Delaunay if no p_ij is negative. If z is 0 or 1 for the pairs (0, 1),
        (1, 2) … (d - 1, d) and (0, d), all z are, and x is a vertex of the simplex. So the power is at least
        twice the least p_ij of these pairs; the apexes of the neighbours attain it.

        >>> affine_image("A~4").relative_protection
        -1 + sqrt(2)
        """
        if self.least_weight <= 0:
            return Surd(0)
        p = [[-x for x in row] for row in self.superbase.rows()]
        n = len(p)
        ratios = (
            2 * min(p[i][j] for i, j in pairwise((0, *order, 0))) / self._of_order(order).squared_circumradius
            for order in permutations(range(1, n))
            if order[0] < order[-1]  # the reverse order gives the same simplex, turned
        )
        return sqrt(1 + min(ratios)) - 1

    def _of_order(self, order: tuple[int, ...]) -> Simplex:
        """The simplex b_0, b_0 + b_i, … without the last sum, which is 0."""
        n, steps = len(order) + 1, (0, *order)[:-1]
        rows = [[int(i in steps[:k]) for i in range(n)] for k in range(1, n)]
        sums = RationalMatrix.from_rows(rows)
        return simplex_of_gram(sums @ self.superbase @ sums.T)


def affine_image(name: object, simplex: Simplex | None = None) -> AffineImage:
    """The image under the affine map that carries the fundamental simplex to a given one, vertex by vertex.

    Parameters
    ----------
    name
        The triangulation, such as ``"A~3"``.
    simplex
        The image of the fundamental simplex, its vertices in the order u_0 … u_d; without it nothing moves.

    Raises
    ------
    InvalidInput
        If the simplex has another dimension than the triangulation.

    Examples
    --------
    >>> affine_image("A~2", Simplex([(0, 0), (1, 0), (1, 1)])).mean.gram
    RationalMatrix([[4/3, 2/3], [2/3, 4/3]])
    """
    home = triangulation(name)
    if simplex is not None and simplex.dimension != home.dimension:
        raise InvalidInput(
            f"a simplex of dimension {simplex.dimension} is no image of {home.name}'s: "
            f"give {home.dimension + 1} vertices"
        )
    return AffineImage(home, (simplex or home.simplex).edge_gram)


def reflections(t: CoxeterTriangulation) -> tuple[RationalMatrix, ...]:
    """The simple reflections s as matrices S, with the coordinates of s(u_1) … s(u_d) in u_1 … u_d as rows.

    They carry a Gram matrix G of the edges to S·G·Sᵀ, that of the simplex on the other side of a facet.
    """
    d, found = t.dimension, []
    for facet in t.facets[1:]:
        rows = [[Fraction(int(i == j)) for j in range(d)] for i in range(d)]
        moved = facet.reflect(t.simplex.vertex_matrix.row(facet.index))
        rows[facet.index - 1] = list(t.simplex.barycentric(moved)[1:])
        found.append(RationalMatrix.from_rows(rows))
    return tuple(found)


def simplex_of_gram(gram: RationalMatrix) -> Simplex:
    """The simplex with given products of the edges from u_0; it has lengths, but no coordinates.

    >>> simplex_of_gram(RationalMatrix.identity(2)).circumradius
    sqrt(2)/2
    """
    return Simplex.from_gram_pair(_no_vertices, gram, partial(_gradients_of, gram), gram.det())


def _no_vertices() -> RationalMatrix:
    raise InvalidInput("the simplex is known by its lengths only: it has no coordinates")


def _times(factor: Fraction, a: RationalMatrix) -> RationalMatrix:
    return RationalMatrix.from_rows([[factor * x for x in row] for row in a.rows()])
