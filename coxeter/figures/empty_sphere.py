"""A circumscribed sphere with a vertex inside: B~3 is not Delaunay (paper, Theorem 7)."""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import NamedTuple

from ..affine import CoxeterTriangulation, Vector, triangulation
from ..delaunay import delaunay_verdict
from ..exact import rational, show, sqrt
from .canvas import BLUE, FAINT, GREEN, INK, LABEL, SMALL, VERMILLION, Canvas, Pen
from .figure import Figure, beside
from .legends import Key, legend, line_key, point_key
from .placement import clear_place
from .plane import Line, Window
from .space import View, draw_tetrahedron, great_circle
from .written import words

_SIZE = 320.0
_SPHERE, _EQUATOR = Pen(BLUE, 2.2), Pen(BLUE, 1.6, (2.0, 4.0))
_INSIDE, _NEIGHBOUR = (6.0, VERMILLION, None), Pen(INK, 1.3, opacity=0.7)
_SEEDS = ((2, -1, 0), (-1, -2, 5), (-1, -2, -1))
"""To the right, upwards, towards the viewer, who is in front of the mirror x_2 = 0 and a little below."""


class NotEmpty(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    name
        The triangulation.
    simplex
        The vertices u_0 … u_3 of the fundamental simplex.
    circumcentre, squared_circumradius
        Of its circumscribed sphere.
    facet
        The number k of the facet in which u_k is reflected.
    inside
        The mirror image s_k(u_k), a vertex of the triangulation.
    squared_distance
        Its squared distance from the circumcentre, less than the squared circumradius.
    """

    name: str
    simplex: tuple[Vector, ...]
    circumcentre: Vector
    squared_circumradius: Fraction
    facet: int
    inside: Vector
    squared_distance: Fraction


class Section(NamedTuple):
    """The section with the mirror plane x_2 = 0, which holds u_0, u_1, the centre and the vertex inside.

    Attributes
    ----------
    sphere
        What is shown in space.
    window
        The part of the plane that is drawn.
    lines
        The lines in which the other mirrors meet the plane, as far as they cross the window.
    vertices
        The vertices of the triangulation in the window.
    """

    sphere: NotEmpty
    window: Window
    lines: tuple[Line, ...]
    vertices: tuple[Vector, ...]


def sphere_not_empty() -> Figure[tuple[NotEmpty | Section, ...]]:
    """The circumscribed sphere of the fundamental simplex of B~3, in space and cut by a mirror plane.

    The image of u_2 in the facet opposite to it lies inside: the triangulation is not Delaunay.

    >>> in_space, section = sphere_not_empty().data
    >>> str(in_space.squared_distance), str(in_space.squared_circumradius)
    ('1/16', '5/16')
    """
    t = triangulation("B~3")
    data = _not_empty(t)
    section = _section(t, data)
    in_space: Figure[NotEmpty | Section] = Figure(
        "A circumscribed sphere of B~3 that is not empty", _words(data), data, lambda: _draw(data)
    )
    title = "The section of that sphere with a mirror plane"
    cut: Figure[NotEmpty | Section] = Figure(
        title, _section_words(title, section), section, lambda: _draw_section(section)
    )
    return beside(in_space, cut)


def _not_empty(t: CoxeterTriangulation) -> NotEmpty:
    simplex, (mirror, *_) = t.simplex, delaunay_verdict(t).nearest
    return NotEmpty(
        t.name,
        simplex.vertex_matrix.rows(),
        tuple(rational(x) for x in simplex.circumcentre),
        simplex.squared_circumradius,
        mirror.facet,
        mirror.point,
        mirror.squared_distance,
    )


def _section(t: CoxeterTriangulation, data: NotEmpty) -> Section:
    zero, one, half = Fraction(0), Fraction(1), Fraction(1, 2)
    side = Fraction(7, 10)
    x, _, z = data.circumcentre
    window = Window(((one, zero, zero), (zero, zero, one)), (x, z), (side, side), _SIZE / float(2 * side))
    roots = [r for r in t.roots.positive_roots.rows() if r[0] or r[2]]
    traces = {(a, zero, c): None for a, _, c in roots}
    steps = [k * half for k in range(-2, 4)]
    points = ((a, zero, b) for a, b in product(steps, steps))
    vertices = tuple(p for p in points if window.contains(p) and t.is_vertex(p))
    return Section(data, window, window.lines(list(traces)), vertices)


def _words(data: NotEmpty) -> str:
    corners = ", ".join(f"u_{k} = {show(u)}" for k, u in enumerate(data.simplex))
    k = data.facet
    return (
        f"The fundamental simplex of {data.name}, {corners}, in its circumscribed sphere with centre c = "
        f"{show(data.circumcentre)} and R = {words(sqrt(data.squared_circumradius))}. The mirror image "
        f"s_{k}(u_{k}) = {show(data.inside)}, a vertex of the triangulation too, lies inside the sphere, at "
        f"distance {words(sqrt(data.squared_distance))} from c. So {data.name} is not Delaunay."
    )


def _section_words(title: str, section: Section) -> str:
    data, k = section.sphere, section.sphere.facet
    where = {-1: "inside", 0: "on", 1: "outside"}
    found: dict[str, int] = {}
    for v in section.vertices:
        square = sum(((a - b) ** 2 for a, b in zip(v, data.circumcentre, strict=True)), Fraction(0))
        name = where[(square > data.squared_circumradius) - (square < data.squared_circumradius)]
        found[name] = found.get(name, 0) + 1
    counts = ", ".join(f"{found[name]} {name}" for name in where.values() if name in found)
    return (
        f"{title}, x_2 = 0. A circle of radius R = {words(sqrt(data.squared_circumradius))} with centre c; "
        f"u_0 and u_1 lie on it, s_{k}(u_{k}) = {show(data.inside)} inside. Of the vertices of {data.name} "
        f"in the window are {counts} the circle."
    )


def _draw(data: NotEmpty) -> Canvas:
    seeds = [tuple(map(Fraction, seed)) for seed in _SEEDS]
    radius = float(sqrt(data.squared_circumradius))
    view = View.along(seeds, data.circumcentre, 0.45 * _SIZE / radius)
    canvas, pixel = Canvas(), view.pixel
    canvas.disc(pixel(data.circumcentre), view.scale * radius, BLUE, opacity=0.07)
    front, back = great_circle(view, view.scale * radius, (1, 0, 0), (0, 0, 1))
    canvas.lines(back, _EQUATOR)
    others = [u for k, u in enumerate(data.simplex) if k != data.facet]
    canvas.lines([(pixel(u), pixel(data.inside)) for u in others], _NEIGHBOUR)
    draw_tetrahedron(canvas, view, data.simplex)
    canvas.lines(front, Pen(BLUE, 1.6))
    canvas.disc(pixel(data.circumcentre), view.scale * radius, None, _SPHERE)
    canvas.disc(pixel(data.circumcentre), 5.0, None, _SPHERE)
    canvas.disc(pixel(data.inside), *_INSIDE)
    for u in data.simplex:
        canvas.disc(pixel(u), 4.0)
    _label_points(canvas, data, {k: pixel(u) for k, u in enumerate(data.simplex)}, pixel(data.inside))
    _keys(canvas, data, line_key("its section with the plane $x_{2} = 0$", Pen(BLUE, 1.6)))
    return canvas.fit()


def _label_points(
    canvas: Canvas, data: NotEmpty, at: dict[int, tuple[float, float]], inside: tuple[float, float]
) -> None:
    k, middle = data.facet, (0.0, 0.0)
    place = clear_place(canvas, inside, middle, (24.0, 30.0, 36.0), 22.0)
    canvas.label(place, f"$s_{{{k}}}(u_{{{k}}})$", LABEL)
    for i, point in at.items():
        canvas.label(clear_place(canvas, point, middle, (18.0, 22.0, 26.0)), f"$u_{{{i}}}$", LABEL)
    canvas.label(clear_place(canvas, middle, inside, (17.0, 21.0)), "$c$", LABEL)


def _keys(canvas: Canvas, data: NotEmpty, *more: Key) -> None:
    k = data.facet
    keys = [
        point_key("circumscribed sphere and its centre", 5.5, None, _SPHERE),
        *more,
        point_key(f"the vertex $s_{{{k}}}(u_{{{k}}})$, inside", *_INSIDE),
    ]
    legend(canvas, keys, _SIZE)


def _draw_section(section: Section) -> Canvas:
    canvas, window, data = Canvas(), section.window, section.sphere
    canvas.lines([window.segment(line) for line in section.lines], FAINT)
    centre = window.pixel(data.circumcentre)
    radius = window.scale * float(sqrt(data.squared_circumradius))
    canvas.disc(centre, radius, BLUE, _SPHERE, 0.07)
    shown = {k: window.pixel(u) for k, u in enumerate(data.simplex) if u in section.vertices}
    canvas.lines([tuple(shown.values())], Pen(GREEN, 2.6))
    for vertex in section.vertices:
        canvas.disc(window.pixel(vertex), 4.0 if vertex in data.simplex else 2.6)
    canvas.disc(centre, 5.0, None, _SPHERE)
    canvas.disc(window.pixel(data.inside), *_INSIDE)
    _label_points(canvas, data, shown, window.pixel(data.inside))
    legend(
        canvas,
        [line_key("edge of the simplex", Pen(GREEN, 2.6)), point_key("vertices", 2.6, INK, None)],
        _SIZE,
    )
    left, _, right, bottom = canvas.box
    inside = f"$|s_{{{data.facet}}}(u_{{{data.facet}}})-c|^{{2}} = {data.squared_distance}$"
    canvas.label(
        ((left + right) / 2, bottom + 14), f"$R^{{2}} = {data.squared_circumradius}$,  {inside}", SMALL + 2
    )
    return canvas.fit()
