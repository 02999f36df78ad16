"""Why the printed proof of Lemma 10 stops in space: a facet that separates, and an angle of more than π/4."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple

from ..affine import Vector
from ..errors import InvalidInput
from ..exact import rational, show, sqrt
from ..simplex import Simplex
from .canvas import BLUE, FINE, GREEN, LABEL, PURPLE, SMALL, VERMILLION, Canvas, Pen, Point
from .figure import Figure, above, beside
from .legends import legend, line_key, point_key
from .marks import arc, right_angle, sheet, toward
from .placement import clear_place
from .plane import squared_distance
from .space import View, draw_tetrahedron
from .written import words

SPIKE = ((0, 0, 0), (1, 0, 0), (3, 1, 0), (1, 2, 3))
"""Three vertices on the floor, and p."""

_SEEDS = ((4, 1, 0), (8, -32, 170), (10, -40, -8))
"""To the right, upwards, towards the viewer, who looks at the floor a little from below."""
_BREADTH = 330.0
_EDGE, _CIRCLE, _HEIGHT = Pen(GREEN, 2.4), Pen(BLUE, 2.2), Pen(PURPLE, 2.6)
_LONGEST, _REACH, _DASHED = (
    Pen(VERMILLION, 3.0),
    Pen(PURPLE, 2.0, (7.0, 5.0)),
    Pen(width=1.4, dash=(5.0, 4.0)),
)


class Spike(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    floor
        The vertices v_0, v_1, v_2 of the facet τ, which lies in the plane x_3 = 0.
    p
        The vertex opposite to it.
    foot
        The foot f of the height from p.
    circumcentre, share
        The circumcentre c, and its barycentric coordinate at p: negative, so τ separates c from p.
    centre, squared_radius
        The centre o and the square of the radius of the circumscribed circle of τ.
    squared_height
        The square of the height h from p.
    squared_steps, squared_edges
        The squared distances of v_0, v_1, v_2 from the foot, and from p.
    """

    floor: tuple[Vector, ...]
    p: Vector
    foot: Vector
    circumcentre: Vector
    share: Fraction
    centre: Vector
    squared_radius: Fraction
    squared_height: Fraction
    squared_steps: tuple[Fraction, ...]
    squared_edges: tuple[Fraction, ...]

    @property
    def end(self) -> int:
        """The number of the vertex at the other end of the longest edge at p, the first of them."""
        return self.squared_edges.index(max(self.squared_edges))


def lemma_10_witness() -> Figure[Spike]:
    """A tetrahedron with a separating facet that the longest edge meets at an angle of more than π/4.

    In space; the facet from above; the plane of the height and of the longest edge, which is to be
    compared with `lemma_10_plane`.

    >>> data = lemma_10_witness().data
    >>> str(data.squared_height / max(data.squared_edges))
    '9/14'
    """
    data = _data()
    titles = (
        "The witness against a step of Lemma 10",
        "Its floor from above",
        "The plane of height and longest edge",
    )
    parts: list[Figure[Any]] = [
        Figure(titles[0], _words(data), data, lambda: _draw_space(data)),
        Figure(titles[1], _floor_words(data), data, lambda: _draw_floor(data)),
        Figure(titles[2], _plane_words(data), data, lambda: _draw_plane(data)),
    ]
    drawn: Figure[Any] = above(parts[0], beside(*parts[1:]))
    return replace(drawn, data=data)


def _data() -> Spike:
    simplex = Simplex(SPIKE)
    *floor, p = simplex.vertex_matrix.rows()
    centre, base = tuple(rational(x) for x in simplex.circumcentre), Simplex(floor)
    share = simplex.circumcentre_coordinates[3]
    if share >= 0 or any(v[2] for v in floor):
        raise InvalidInput("the facet on the floor is to separate the circumcentre")
    foot = (*p[:2], Fraction(0))
    return Spike(
        tuple(floor),
        p,
        foot,
        centre,
        share,
        tuple(rational(x) for x in base.circumcentre),
        base.squared_circumradius,
        simplex.squared_heights[3],
        tuple(squared_distance(foot, v) for v in floor),
        tuple(squared_distance(p, v) for v in floor),
    )


# -- words --------------------------------------------------------------------------------------------------


def _words(data: Spike) -> str:
    floor = ", ".join(f"v_{k} = {show(v)}" for k, v in enumerate(data.floor))
    return (
        f"The tetrahedron with the floor {floor} and the vertex p = {show(data.p)}. The floor separates p "
        f"from the circumcentre c = {show(data.circumcentre)}, whose barycentric coordinate at p is "
        f"{data.share}. The foot f = {show(data.foot)} of the height from p lies outside the floor."
    )


def _floor_words(data: Spike) -> str:
    steps = ", ".join(f"|f - v_{k}| = {words(sqrt(x))}" for k, x in enumerate(data.squared_steps))
    return (
        f"The floor from above: an obtuse triangle in a circle with centre o = {show(data.centre[:2])} and "
        f"radius {words(sqrt(data.squared_radius))}, and the foot f = {show(data.foot[:2])}. All its "
        f"vertices lie inside the circle round f with radius h = {words(sqrt(data.squared_height))}: "
        f"{steps}."
    )


def _plane_words(data: Spike) -> str:
    k = data.end
    longest = data.squared_edges[k]
    return (
        f"The plane through p, f and v_{k}: a right triangle with the legs h = "
        f"{words(sqrt(data.squared_height))} and |f - v_{k}| = {words(sqrt(data.squared_steps[k]))} and the "
        f"hypotenuse L = {words(sqrt(longest))}. h²/L² = {data.squared_height / longest}, more than 1/2, so "
        f"the angle at v_{k} is more than π/4. The plane meets the tetrahedron in this edge only."
    )


# -- drawings -----------------------------------------------------------------------------------------------


def _draw_space(data: Spike) -> Canvas:
    canvas = Canvas()
    seeds = [tuple(map(Fraction, v)) for v in _SEEDS]
    view = View.along(seeds, data.floor[0], 62.0)
    corners = (*data.floor, data.p)
    at = [view.pixel(x) for x in corners]
    foot, centre, p = view.pixel(data.foot), view.pixel(data.circumcentre), at[3]
    draw_tetrahedron(canvas, view, corners)
    canvas.lines([(foot, point) for point in at[:3]], _DASHED)
    canvas.lines([(p, foot)], _HEIGHT)
    canvas.lines([(p, at[data.end])], _LONGEST)
    for point in (*at, foot):
        canvas.disc(point, 4.0)
    canvas.disc(centre, 5.0, None, _CIRCLE)
    names = {"$p$": p, "$f$": foot, "$c$": centre, **{f"$v_{{{k}}}$": at[k] for k in range(3)}}
    middle = (sum(x for x, _ in at) / 4, sum(y for _, y in at) / 4)
    for name, point in names.items():
        canvas.label(clear_place(canvas, point, middle, (18.0, 22.0, 26.0)), name, LABEL)
    keys = [line_key("height", _HEIGHT), line_key("longest edge at $p$", _LONGEST)]
    legend(canvas, [*keys, point_key("circumcentre", 5.0, None, _CIRCLE)], _BREADTH)
    return canvas.fit(least_width=240.0)


def _draw_floor(data: Spike) -> Canvas:
    canvas, scale = Canvas(), 42.0

    def pixel(x: Vector) -> Point:
        return sheet(scale, float(x[0]), float(x[1]))

    at = [pixel(v) for v in data.floor]
    foot, centre = pixel(data.foot), pixel(data.centre)
    canvas.disc(centre, scale * float(sqrt(data.squared_radius)), None, _CIRCLE)
    canvas.disc(foot, scale * float(sqrt(data.squared_height)), PURPLE, _REACH, 0.08)
    canvas.polygons([at], GREEN, 0.35, _EDGE)
    canvas.lines([(foot, point) for point in at], _DASHED)
    for point in (*at, foot):
        canvas.disc(point, 4.0)
    canvas.disc(centre, 5.0, None, _CIRCLE)
    names = {"$f$": foot, "$o$": centre, **{f"$v_{{{k}}}$": at[k] for k in range(3)}}
    for name, point in names.items():
        canvas.label(clear_place(canvas, point, foot, (17.0, 20.0, 24.0)), name, LABEL)
    keys = [point_key("circumcircle of the floor, centre", 5.0, None, _CIRCLE)]
    legend(canvas, [*keys, line_key("at the distance $h$ from $f$", _REACH)], _BREADTH)
    return canvas.fit()


def _draw_plane(data: Spike) -> Canvas:
    canvas, scale = Canvas(), 76.0
    step, height = (scale * float(sqrt(x)) for x in (data.squared_steps[data.end], data.squared_height))
    end, foot, p = (0.0, 0.0), (step, 0.0), (step, -height)
    diagonal = toward(end, (1.0, -1.0), 132.0)
    canvas.lines([((-40.0, 0.0), (step + 30, 0.0))], FINE)
    canvas.lines([(end, diagonal)], _DASHED)
    canvas.lines([arc(end, 96.0, foot, diagonal)], _DASHED)
    canvas.lines([arc(end, 66.0, foot, p)], Pen(VERMILLION, 1.6))
    canvas.lines([(p, foot)], _HEIGHT)
    canvas.lines([(p, end)], _LONGEST)
    right_angle(canvas, foot, p, end)
    for point in (end, foot, p):
        canvas.disc(point, 4.0)
    canvas.label((p[0], p[1] - 18), "$p$", LABEL)
    canvas.label((step, 20), "$f$", LABEL)
    canvas.label((0, 20), f"$v_{{{data.end}}}$", LABEL)
    canvas.label((step + 16, -height / 2), "$h$", LABEL)
    canvas.label((step / 2 - 18, -height / 2 - 8), "$L$", LABEL)
    canvas.label((diagonal[0] + 6, diagonal[1] - 14), "$\\pi/4$", SMALL + 2)
    legend(canvas, [line_key("height", _HEIGHT), line_key("longest edge at $p$", _LONGEST)], _BREADTH)
    return canvas.fit(least_width=240.0)
