"""The Delaunay property and protection of Coxeter triangulations (paper, Section 4 and Appendix C).

Everything follows from one identity. Let s be the reflection in a facet of a simplex, at distance t
from the circumcentre c (negative if c lies beyond the facet), and let h be the height from the
opposite vertex u. Then ``|s(u) - c|² = R² + 4·h·t = R² + 4·λ·h²``, with λ the barycentric coordinate of c.

*If the fundamental simplex contains its circumcentre*, a reflection in one of its facets never
brings a point of the simplex's side closer to c. Each vertex v outside the simplex is carried to one
of its vertices u_k by reflections in facets, each of which brings it closer to c or leaves it at its
distance; the last that moves it is the reflection in facet k, as u_k lies on all other facets. So
the vertices nearest to c outside the simplex are among the d + 1 mirror images s_k(u_k), and
``R'² = R² + 4·min λ_k·h_k²``.  *If it does not*, some λ_k is negative and s_k(u_k) is a vertex of the
triangulation strictly inside the circumsphere: the triangulation is not Delaunay.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from .affine import CoxeterTriangulation, Vector
from .errors import InvalidInput
from .exact import Surd, rational, sqrt
from .simplex import Position, Simplex, position


def circumcentre_position(simplex: Simplex) -> Position:
    """Whether a simplex contains its circumcentre inside, on its boundary, or not (Definition 20).

    A simplex is *self-centred* unless the answer is ``Position.OUTSIDE``.

    >>> circumcentre_position(Simplex([(0, 0), (1, 0), (0, 1)]))
    <Position.BOUNDARY: 'boundary'>
    """
    return position(simplex.circumcentre_coordinates)


def is_self_centred(simplex: Simplex) -> bool:
    """Whether a simplex contains its circumcentre, inside or on its boundary (Definition 20)."""
    return circumcentre_position(simplex) is not Position.OUTSIDE


@dataclass(frozen=True)
class MirrorVertex:
    """The mirror image s_k(u_k) of a vertex in the facet opposite to it: the apex of the neighbour.

    Attributes
    ----------
    facet
        The index k.
    squared_distance
        Its squared distance from the circumcentre.
    """

    triangulation: CoxeterTriangulation
    facet: int
    squared_distance: Fraction

    @property
    def point(self) -> Vector:
        """Its coordinates."""
        t = self.triangulation
        return t.facets[self.facet].reflect(t.simplex.vertex_matrix.row(self.facet))


@dataclass(frozen=True)
class DelaunayVerdict:
    """Whether a Coxeter triangulation is Delaunay, and why (Theorem 7).

    Attributes
    ----------
    delaunay
        Whether no vertex lies strictly inside the circumsphere of a simplex.
    position
        Where the circumcentre lies relative to the fundamental simplex.
    nearest
        The mirror vertices nearest to the circumcentre. They lie strictly inside the circumsphere
        if the triangulation is not Delaunay (other vertices may then lie deeper still), on it if the
        circumcentre lies on the boundary.
    """

    delaunay: bool
    position: Position
    nearest: tuple[MirrorVertex, ...]

    def __bool__(self) -> bool:
        return self.delaunay


def mirror_vertices(triangulation: CoxeterTriangulation) -> tuple[MirrorVertex, ...]:
    """The apexes of the d + 1 neighbours of the fundamental simplex, with their distances."""
    simplex = triangulation.simplex
    square = simplex.squared_circumradius
    pairs = zip(simplex.circumcentre_coordinates, simplex.squared_heights, strict=True)
    return tuple(MirrorVertex(triangulation, k, square + 4 * x * h) for k, (x, h) in enumerate(pairs))


def delaunay_verdict(triangulation: CoxeterTriangulation) -> DelaunayVerdict:
    """Whether a Coxeter triangulation is Delaunay, with the nearest mirror vertices as witness.

    >>> from coxeter.affine import triangulation
    >>> verdict = delaunay_verdict(triangulation("B~3"))
    >>> verdict.delaunay, verdict.nearest[0].point
    (False, (Fraction(1, 2), Fraction(0, 1), Fraction(1, 2)))
    """
    mirrors = mirror_vertices(triangulation)
    least = min(m.squared_distance for m in mirrors)
    where = circumcentre_position(triangulation.simplex)
    nearest = tuple(m for m in mirrors if m.squared_distance == least)
    return DelaunayVerdict(where is not Position.OUTSIDE, where, nearest)


@dataclass(frozen=True)
class Protection:
    """The protection of a Coxeter triangulation (Definition 19).

    Attributes
    ----------
    absolute
        δ: the distance from the circumscribed ball to the nearest other vertex, 0 if that lies in it.
    relative
        δ / R.
    nearest
        The mirror vertices nearest to the circumcentre; if the protection is positive, these are all
        vertices outside the simplex that are nearest.
    """

    absolute: Surd
    relative: Surd
    nearest: tuple[MirrorVertex, ...]

    def __bool__(self) -> bool:
        return bool(self.absolute)


def protection(triangulation: CoxeterTriangulation) -> Protection:
    """The protection of a Coxeter triangulation, from the exact distances of the nearest vertices.

    Definition 19 speaks of Delaunay triangulations; where the triangulation is not Delaunay its
    formula gives 0, as some vertex lies inside the ball.

    >>> from coxeter.affine import triangulation
    >>> protection(triangulation("A~4")).relative
    -1 + sqrt(2)
    """
    verdict = delaunay_verdict(triangulation)
    square = triangulation.simplex.squared_circumradius
    if verdict.position is not Position.INSIDE:
        return Protection(Surd(0), Surd(0), verdict.nearest)
    distance = verdict.nearest[0].squared_distance
    return Protection(sqrt(distance) - sqrt(square), sqrt(distance / square) - 1, verdict.nearest)


def vertices_by_distance(triangulation: CoxeterTriangulation) -> Iterator[tuple[Fraction, Vector]]:
    """All vertices of the triangulation by their distance from the circumcentre, without end.

    Yields pairs (squared distance, vertex), nearest first: an exact enumeration, the second route
    to `protection`. From each vertex it reflects upwards, in the facets beyond which the vertex does
    not lie; as above, each vertex is reached from a nearer one.

    Raises
    ------
    InvalidInput
        If the fundamental simplex is not self-centred: its reflections then may lead inwards.

    Examples
    --------
    >>> from coxeter.affine import triangulation
    >>> from itertools import islice
    >>> [str(square) for square, _ in islice(vertices_by_distance(triangulation("A~2")), 8)]
    ['2/9', '2/9', '2/9', '8/9', '8/9', '8/9', '14/9', '14/9']
    """
    simplex, facets = triangulation.simplex, triangulation.facets
    if not is_self_centred(simplex):
        raise InvalidInput(f"{triangulation.name} is not self-centred: its vertices have no such order")
    centre = [rational(x) for x in simplex.circumcentre]
    heap = [(simplex.squared_circumradius, vertex) for vertex in simplex.vertex_matrix.rows()]
    heapq.heapify(heap)
    seen = {vertex for _, vertex in heap}
    while True:
        square, vertex = heapq.heappop(heap)
        yield square, vertex
        for facet in facets:
            if facet.level(vertex) > 0:
                image = facet.reflect(vertex)
                if image not in seen:
                    seen.add(image)
                    squares = ((a - b) ** 2 for a, b in zip(image, centre, strict=True))
                    heapq.heappush(heap, (sum(squares, Fraction(0)), image))
