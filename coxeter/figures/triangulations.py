"""Triangulations of the plane: the three Coxeter triangulations, and one that is none (Figures 2 and 3)."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from ..affine import CoxeterTriangulation, Vector, triangulation
from ..delaunay import circumcentre_position
from ..exact import Surd, show
from ..exact.surd import Exact
from ..simplex import Position
from .canvas import BLUE, FAINT, GREEN, INK, LABEL, VERMILLION, Canvas, Pen, Point
from .figure import Figure
from .legends import legend, point_key
from .plane import Line, Triangle, Window, frame, triangles_in

_SIZE = 336.0
_SHADE = 0.07


class Plane(NamedTuple):
    """What is drawn of a Coxeter triangulation of the plane.

    Attributes
    ----------
    name
        The triangulation.
    window
        The part of the plane that is drawn.
    lines
        The lines that cross the window.
    triangles
        The triangles that reach into the window; vertex k of each is an image of u_k.
    shaded
        Those an odd number of reflections away from the fundamental simplex.
    vertices
        The vertices of the triangulation in the window.
    simplex
        The vertices u_0, u_1, u_2 of the fundamental simplex.
    circumcentre, squared_circumradius, position
        The centre of its circumscribed circle, the square of the radius, and where the centre lies.
    incentre, inradius
        The centre and the radius of its inscribed circle.
    """

    name: str
    window: Window
    lines: tuple[Line, ...]
    triangles: tuple[Triangle, ...]
    shaded: tuple[Triangle, ...]
    vertices: tuple[Vector, ...]
    simplex: Triangle
    circumcentre: tuple[Exact, ...]
    squared_circumradius: Fraction
    position: Position
    incentre: tuple[Surd, ...]
    inradius: Surd


def plane_triangulation(name: object) -> Figure[Plane]:
    """A Coxeter triangulation of the plane with its fundamental simplex, as at the top of Figure 2.

    Neighbouring triangles are mirror images of each other; every other one is shaded.

    Parameters
    ----------
    name
        ``"A~2"``, ``"C~2"`` or ``"G~2"``.

    Raises
    ------
    InvalidInput
        If the dimension is not 2.

    Examples
    --------
    >>> plane_triangulation("C~2").data.position
    <Position.BOUNDARY: 'boundary'>
    """
    data = _plane(triangulation(getattr(name, "name", name)))
    return Figure(f"Coxeter triangulation {data.name}", _words(data), data, lambda: _draw(data))


def _plane(t: CoxeterTriangulation) -> Plane:
    axes, simplex = frame(t.roots), t.simplex
    window = _window_around(axes, simplex.circumcentre, simplex.circumradius * 3)
    triangles = triangles_in(window, t)
    corners = sorted({v for triangle, _ in triangles for v in triangle})
    u, v, w = simplex.vertex_matrix.rows()
    return Plane(
        t.name,
        window,
        window.lines(t.roots.positive_roots.rows()),
        tuple(triangle for triangle, _ in triangles),
        tuple(triangle for triangle, parity in triangles if parity),
        tuple(corner for corner in corners if window.contains(corner)),
        (u, v, w),
        simplex.circumcentre,
        simplex.squared_circumradius,
        circumcentre_position(simplex),
        simplex.incentre,
        simplex.inradius,
    )


def _window_around(
    axes: tuple[tuple[Exact, ...], tuple[Exact, ...]], centre: tuple[Exact, ...], half: Surd
) -> Window:
    """A square window, its half side rounded to a rational number."""
    zero, one = Fraction(0), Fraction(1)
    middle = Window(axes, (zero, zero), (one, one), 1.0).project(centre)
    side = Fraction(half.decimal(3))
    return Window(axes, middle, (side, side), _SIZE / float(2 * side))


def _words(data: Plane) -> str:
    where = {"inside": "inside", "boundary": "on the boundary", "outside": "outside"}[data.position.value]
    return (
        f"Coxeter triangulation {data.name}: {len(data.lines)} lines cut the window into triangles that are "
        "mirror images of their neighbours, every other one shaded. The fundamental simplex has the vertices "
        f"{', '.join(f'u_{k} = {show(u)}' for k, u in enumerate(data.simplex))}. Its circumcentre "
        f"{show(data.circumcentre)} lies {where}, at distance R with R² = {data.squared_circumradius} from "
        f"the vertices; its inradius is {data.inradius}."
        + (" Its incentre is the circumcentre." if data.incentre == data.circumcentre else "")
    )


def _draw(data: Plane) -> Canvas:
    canvas, window = Canvas(), data.window
    shaded = [window.clip([window.pixel(v) for v in triangle]) for triangle in data.shaded]
    canvas.polygons([outline for outline in shaded if len(outline) > 2], INK, _SHADE)
    canvas.lines([window.segment(line) for line in data.lines], FAINT)
    corners = [window.pixel(u) for u in data.simplex]
    canvas.polygons([corners], GREEN, 0.4, Pen(GREEN, 2.4))
    centre = window.pixel(data.circumcentre)
    canvas.disc(centre, window.scale * float(data.squared_circumradius) ** 0.5, None, _CIRCLE)
    for vertex in data.vertices:
        canvas.disc(window.pixel(vertex), 3.6 if vertex in data.simplex else 2.2)
    canvas.disc(centre, *_CIRCUMCENTRE)
    canvas.disc(window.pixel(data.incentre), *_INCENTRE)
    for k, corner in enumerate(corners):
        canvas.label(_away(corner, centre, 18), f"$u_{{{k}}}$", LABEL)
    keys = [point_key("circumcircle and circumcentre", *_CIRCUMCENTRE), point_key("incentre", *_INCENTRE)]
    legend(canvas, keys, _SIZE)
    return canvas.fit()


_CIRCLE = Pen(BLUE, 2.2)
_CIRCUMCENTRE = (5.5, None, _CIRCLE)
_INCENTRE = (3.0, VERMILLION, None)


def _away(point: Point, centre: Point, distance: float) -> Point:
    dx, dy = point[0] - centre[0], point[1] - centre[1]
    length = (dx * dx + dy * dy) ** 0.5
    return point[0] + dx * distance / length, point[1] + dy * distance / length
