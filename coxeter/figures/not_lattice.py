"""A difference of two vertices that is no vertex: the vertex set is no lattice (paper, Section 6, item 9)."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from ..affine import CoxeterTriangulation, Vector, triangulation
from ..errors import InvalidInput
from ..exact import show
from ..lattices import NonLatticeWitness, vertex_lattice
from .canvas import BLUE, FAINT, GREEN, INK, LABEL, PURPLE, VERMILLION, Canvas, Pen
from .figure import Figure
from .legends import Key, arrow_key, legend, point_key
from .marks import cross
from .placement import clear_place
from .plane import Frame, Line, Triangle, Window, frame, triangles_in

_SIZE = 330.0
_DIFFERENCE, _GUIDE, _MISSED = Pen(BLUE, 2.8), Pen(INK, 1.2, (4.0, 4.0), 0.8), Pen(VERMILLION, 3.4)
_KINDS = ((4.4, INK, None), (4.0, PURPLE, None), (4.4, None, Pen(GREEN, 2.2)))


class NotLattice(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    name
        The triangulation.
    window
        The part of the plane that is drawn.
    lines
        The lines that cross the window.
    simplex
        The vertices of the fundamental simplex.
    vertices
        The vertices in the window, with the numbers k of the u_k of which they are images.
    first, second
        The numbers i and j of the two vertices.
    difference
        u_i - u_j, which is no vertex.
    barycentric
        Its coordinates after it was folded into the fundamental simplex: more than one is positive.
    through
        How many of the lines go through it; a vertex has two at least.
    """

    name: str
    window: Window
    lines: tuple[Line, ...]
    simplex: Triangle
    vertices: tuple[tuple[Vector, int], ...]
    first: int
    second: int
    difference: Vector
    barycentric: Vector
    through: int


def difference_not_a_vertex(name: object = "G~2") -> Figure[NotLattice]:
    """Two vertices of a triangulation of the plane whose difference is not a vertex.

    Parameters
    ----------
    name
        ``"G~2"``: the vertices of the other triangulations of the plane form lattices.

    Raises
    ------
    InvalidInput
        If the vertices form a lattice, or the dimension is not 2.

    Examples
    --------
    >>> difference_not_a_vertex().data.through
    1
    """
    t = triangulation(getattr(name, "name", name))
    axes = frame(t.roots)  # refuses all but the plane
    witness = vertex_lattice(t)
    if not isinstance(witness, NonLatticeWitness):
        raise InvalidInput(f"{witness}: the difference of two of its vertices is always a vertex")
    data = _data(t, axes, witness)
    return Figure(f"Vertices of {t.name} whose difference is none", _words(data), data, lambda: _draw(data))


def _data(t: CoxeterTriangulation, axes: Frame, witness: NonLatticeWitness) -> NotLattice:
    zero, side = Fraction(0), t.simplex.longest_edge.decimal(3)
    half = Fraction(side) * Fraction(17, 10)
    window = Window(axes, (zero, zero), (half, half), _SIZE / float(2 * half))
    corners = {v for triangle, _ in triangles_in(window, t) for v in triangle}
    shown = sorted(v for v in corners if window.contains(v))
    u, v, w = t.simplex.vertex_matrix.rows()
    return NotLattice(
        t.name,
        window,
        window.lines(t.roots.positive_roots.rows()),
        (u, v, w),
        tuple((x, t.fold(x).barycentric.index(1)) for x in shown),
        witness.first,
        witness.second,
        witness.difference,
        witness.folding.barycentric,
        len(t.integral_roots(witness.difference).numerators),
    )


def _words(data: NotLattice) -> str:
    i, j = data.first, data.second
    counts = [f"{sum(kind == k for _, kind in data.vertices)} like u_{k}" for k in range(3)]
    lines = {0: "none of the lines passes", 1: "only one of the lines passes"}[data.through]
    return (
        f"The lines of {data.name} and the vertices in the window: {', '.join(counts)}. The arrow from "
        f"u_{j} = {show(data.simplex[j])} to u_{i} = {show(data.simplex[i])}, drawn from the vertex u_0 = "
        f"{show(data.simplex[0])}, ends at u_{i} - u_{j} = {show(data.difference)}, and {lines} through "
        f"that point: it is no vertex. So the vertices of {data.name} do not form a lattice."
    )


def _draw(data: NotLattice) -> Canvas:
    canvas, window = Canvas(), data.window
    canvas.lines([window.segment(line) for line in data.lines], FAINT)
    corners = [window.pixel(u) for u in data.simplex]
    canvas.polygons([corners], GREEN, 0.3)
    origin, start, end = corners[0], corners[data.second], corners[data.first]
    tip = window.pixel(data.difference)
    canvas.lines([(start, origin), (end, tip)], _GUIDE)
    for vertex, kind in data.vertices:
        canvas.disc(window.pixel(vertex), *_KINDS[kind])
    canvas.arrow(start, end, _DIFFERENCE)
    canvas.arrow(origin, tip, _DIFFERENCE)
    cross(canvas, tip, 7.0, _MISSED)
    for k, corner in enumerate(corners):
        canvas.label(clear_place(canvas, corner, tip, (17.0, 21.0, 25.0)), f"$u_{{{k}}}$", LABEL)
    legend(canvas, _keys(data), _SIZE)
    return canvas.fit()


def _keys(data: NotLattice) -> list[Key]:
    i, j = data.first, data.second
    points = [point_key(f"images of $u_{{{k}}}$", *look) for k, look in enumerate(_KINDS)]
    missed = Key("no vertex", lambda canvas, at: cross(canvas, (at[0] + 6, at[1]), 6.0, _MISSED), 12)
    return [*points, arrow_key(f"the vector $u_{{{i}}}-u_{{{j}}}$", _DIFFERENCE), missed]
