"""What a picture to turn shows: exact values, all derived from the triangulation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

from ..affine import CoxeterTriangulation, Facet, Vector, triangulation
from ..delaunay import circumcentre_position, delaunay_verdict, mirror_vertices
from ..errors import InvalidInput
from ..exact import Exact, Surd
from ..figures import Figure, beside
from ..simplex import Position
from .stars import Star, star

_HALF = Fraction(1, 2)
_UNIT = tuple(tuple(Fraction(i == j) for j in range(3)) for i in range(3))
_OF_FOUR = tuple(
    tuple(_HALF * sign for sign in signs) for signs in ((1, 1, -1, -1), (1, -1, 1, -1), (1, -1, -1, 1))
)
"""An orthonormal frame of the space x_1 + x_2 + x_3 + x_4 = 0."""


class Apex(NamedTuple):
    """The vertex of a neighbour that is not a vertex of the fundamental simplex.

    Attributes
    ----------
    label
        k, if the neighbour lies beyond facet k; then it is s_k(u_k).
    point
        Its coordinates.
    squared_distance
        Its squared distance from the circumcentre.
    where
        Where it lies relative to the circumscribed ball: inside, on its boundary, outside.
    """

    label: int
    point: Vector
    squared_distance: Fraction
    where: Position


@dataclass(frozen=True, repr=False)
class Scene:
    """A picture to turn of a triangulation of space; make one with `scene`.

    Attributes
    ----------
    triangulation
        What is shown.
    around
        The index of the vertex of the fundamental simplex whose star is shown first.
    """

    triangulation: CoxeterTriangulation
    around: int

    # -- the fundamental simplex ----------------------------------------------------------------------

    @property
    def name(self) -> str:
        """The name of the triangulation."""
        return self.triangulation.name

    @property
    def vertices(self) -> tuple[Vector, ...]:
        """The vertices u_0 … u_3 of the fundamental simplex."""
        return self.triangulation.simplex.vertex_matrix.rows()

    @property
    def circumcentre(self) -> tuple[Exact, ...]:
        """The centre of the sphere through the vertices."""
        return self.triangulation.simplex.circumcentre

    @property
    def circumradius(self) -> Surd:
        """The radius of the sphere through the vertices."""
        return self.triangulation.simplex.circumradius

    @property
    def incentre(self) -> tuple[Surd, ...]:
        """The centre of the sphere that touches the facets."""
        return self.triangulation.simplex.incentre

    @property
    def inradius(self) -> Surd:
        """The radius of the sphere that touches the facets."""
        return self.triangulation.simplex.inradius

    @property
    def facets(self) -> tuple[Facet, ...]:
        """The facets with their inward normals."""
        return self.triangulation.facets

    @property
    def dihedral_angles(self) -> dict[tuple[int, int], Fraction]:
        """The angles between facets, as multiples of pi."""
        return self.triangulation.dihedral_angles()

    # -- the triangulation around it -------------------------------------------------------------------

    @property
    def position(self) -> Position:
        """Where the circumcentre lies relative to the simplex."""
        return circumcentre_position(self.triangulation.simplex)

    @cached_property
    def delaunay(self) -> bool:
        """Whether the triangulation is Delaunay."""
        return delaunay_verdict(self.triangulation).delaunay

    @cached_property
    def apexes(self) -> tuple[Apex, ...]:
        """The apexes of the four neighbours, and whether they lie in the circumscribed ball."""
        square = self.triangulation.simplex.squared_circumradius
        return tuple(
            Apex(m.facet, m.point, m.squared_distance, _compared(m.squared_distance, square))
            for m in mirror_vertices(self.triangulation)
        )

    @cached_property
    def stars(self) -> tuple[Star, ...]:
        """The simplices around each of the vertices u_0 … u_3."""
        return tuple(star(self.triangulation, k) for k in range(4))

    @property
    def star(self) -> Star:
        """The simplices that are shown first."""
        return self.stars[self.around]

    # -- the picture -----------------------------------------------------------------------------------

    @property
    def frame(self) -> tuple[Vector, ...]:
        """Three orthonormal vectors: the axes of the picture."""
        return _UNIT if len(self.vertices[0]) == 3 else _OF_FOUR

    def place(self, vector: Sequence[Exact]) -> tuple[Exact, ...]:
        """The coordinates of a point or vector in the picture.

        >>> [str(x) for x in scene("A~3").place(scene("A~3").vertices[1])]
        ['1/2', '1/2', '1/2']
        """
        zero: Exact = Fraction(0)
        return tuple(sum((a * x for a, x in zip(axis, vector, strict=True)), zero) for axis in self.frame)

    @property
    def title(self) -> str:
        """A few words: what is shown."""
        return f"Fundamental simplex of {self.name}, and the simplices around its vertices"

    @cached_property
    def alt(self) -> str:
        """The alternative text, made from the data."""
        from .words import summary

        return summary(self)

    @cached_property
    def figure(self) -> Figure[tuple[Scene, ...]]:
        """The two drawings that stand for the picture on paper; they can be saved."""
        from .drawing import draw_simplex, draw_star
        from .words import of_simplex, of_star

        apart = f"Simplices of {self.name} around a vertex"
        spheres = f"Fundamental simplex of {self.name} with its spheres"
        return beside(
            Figure(spheres, of_simplex(self), self, lambda: draw_simplex(self)),
            Figure(apart, of_star(self.star), self, lambda: draw_star(self)),
            title=self.title,
            alt=self.alt,
        )

    def __repr__(self) -> str:
        return self.alt

    def _repr_html_(self) -> str:
        from .page import figure_html

        return figure_html(self)


def scene(name: object, around: int = 0) -> Scene:
    """A picture to turn: the fundamental simplex of a triangulation of space, and what lies around it.

    Parameters
    ----------
    name
        ``"A~3"``, ``"B~3"`` or ``"C~3"``.
    around
        Which vertex of the fundamental simplex the shown patch surrounds, 0 to 3.

    Raises
    ------
    InvalidInput
        If the dimension is not 3, or there is no such vertex.

    Examples
    --------
    >>> c = scene("C~3")
    >>> len(c.star.alcoves), c.position
    (48, <Position.BOUNDARY: 'boundary'>)
    """
    t = triangulation(getattr(name, "name", name))
    if t.dimension != 3:
        raise InvalidInput(
            f"{t.name} has dimension {t.dimension}: only A~3, B~3 and C~3 can be turned in space"
        )
    if isinstance(around, bool) or around not in range(4):
        raise InvalidInput(f"{around!r} is no vertex of the simplex: give 0, 1, 2 or 3")
    return Scene(t, int(around))


def _compared(square: Fraction, other: Fraction) -> Position:
    if square == other:
        return Position.BOUNDARY
    return Position.INSIDE if square < other else Position.OUTSIDE
