"""The pictures of Appendix A: distances for Lemma 9, an obtuse triangle for Lemma 10 (Figure 12)."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from ..affine import Vector
from ..errors import InvalidInput
from ..exact import Surd, rational, show, sqrt
from ..simplex import Position, Simplex, position
from .canvas import BLUE, FINE, GREEN, LABEL, PURPLE, SMALL, VERMILLION, Canvas, Pen, Point
from .figure import Figure
from .legends import area_key, legend, line_key, point_key
from .marks import arc, extent, right_angle, sheet, toward
from .plane import squared_distance
from .written import words

TRIANGLE = ((0, 0), (14, 0), (5, 12))
"""The triangle with sides 13, 14, 15: all its distances are rational."""
INSIDE = (8, 3)
OBTUSE = ((0, 0), (8, 0), (3, 3))
"""A triangle with an obtuse angle at its last vertex."""

_SIMPLEX, _DASHED = Pen(GREEN, 2.4), Pen(dash=(5.0, 4.0), width=1.4)
_LEG, _CONE = (VERMILLION, 0.3, Pen(VERMILLION, 2.0)), (BLUE, 0.22, None)
_CIRCLE, _LONGEST, _HEIGHT = Pen(BLUE, 2.2), Pen(VERMILLION, 3.0), Pen(PURPLE, 2.6)
_FACET = Pen(GREEN, 4.2)


class Distances(NamedTuple):
    """What is drawn for Lemma 9.

    Attributes
    ----------
    simplex
        The vertices v_0, v_1, v_2.
    p
        A point inside.
    heights
        The heights h_0, h_1, h_2.
    distances
        The distances r_0, r_1, r_2 of p from the sides.
    facets
        The lengths F_0, F_1, F_2 of the sides.
    to_vertices
        The distances of p from the vertices.
    """

    simplex: tuple[Vector, ...]
    p: Vector
    heights: tuple[Surd, ...]
    distances: tuple[Surd, ...]
    facets: tuple[Surd, ...]
    to_vertices: tuple[Surd, ...]


def lemma_9_distances() -> Figure[Distances]:
    """The distances in the proof of Lemma 9, as on the left of Figure 12.

    >>> [str(x) for x in lemma_9_distances().data.distances]
    ['3', '81/13', '3']
    """
    simplex = Simplex(TRIANGLE)
    shares = simplex.barycentric(INSIDE)
    if position(shares) is not Position.INSIDE:
        raise InvalidInput(f"{show(INSIDE)} does not lie inside the triangle")
    points, p = simplex.vertex_matrix.rows(), _vector(INSIDE)
    data = Distances(
        points,
        p,
        simplex.heights,
        tuple(x * h for x, h in zip(shares, simplex.heights, strict=True)),
        tuple(2 * simplex.volume / h for h in simplex.heights),
        tuple(sqrt(squared_distance(p, v)) for v in points),
    )
    return Figure(
        "The distances in the proof of Lemma 9", _distances_in_words(data), data, lambda: _draw_9(data)
    )


def _vector(x: tuple[int, ...]) -> Vector:
    return tuple(Fraction(c) for c in x)


def _distances_in_words(data: Distances) -> str:
    i = len(data.simplex) - 1
    total = sum((f * r for f, r in zip(data.facets, data.distances, strict=True)), Surd(0))
    leg = data.heights[i] - data.distances[i]
    return (
        f"The triangle {', '.join(f'v_{k} = {show(v)}' for k, v in enumerate(data.simplex))}, and p = "
        f"{show(data.p)} inside it, joined to the vertices. For i = {i}: the height from v_i is h_i = "
        f"{data.heights[i]}, p is at distance r_i = {data.distances[i]} from the opposite side, of length "
        f"F_i = {data.facets[i]}. The segment from p to v_i, of length {words(data.to_vertices[i])}, is the "
        f"hypotenuse of a right triangle with the leg h_i - r_i = {leg}. Together p and the side i make a "
        f"triangle with the height r_i; the sum of all F_i r_i is {total}, twice the area."
    )


def _draw_9(data: Distances) -> Canvas:
    canvas, scale = Canvas(), 22.0
    corners = [sheet(scale, float(x), float(y)) for x, y in data.simplex]
    (a, b, top), p = corners, sheet(scale, *map(float, data.p))
    foot, below, elbow = (top[0], 0.0), (p[0], 0.0), (top[0], p[1])
    canvas.polygons([(a, b, p)], *_CONE)
    canvas.polygons([(top, elbow, p)], *_LEG)
    canvas.polygons([corners], GREEN, 0.14, _SIMPLEX)
    canvas.lines([(p, a), (p, b)], _DASHED)
    canvas.lines([(elbow, foot), (p, below)], FINE)
    right_angle(canvas, foot, top, b)
    right_angle(canvas, below, p, b)
    right_angle(canvas, elbow, top, p)
    left = a[0] - 18
    extent(canvas, (left, 0.0), (left, top[1]))
    for point in (*corners, p):
        canvas.disc(point, 4.0)
    canvas.label((left - 14, top[1] / 2), "$h_{i}$", LABEL)
    canvas.label((top[0], top[1] - 18), "$v_{i}$", LABEL)
    canvas.label((top[0] - 12, (top[1] + elbow[1]) / 2 + 22), "$h_{i}-r_{i}$", LABEL, "end")
    canvas.label((p[0] + 14, p[1] - 14), "$p$", LABEL)
    canvas.label((p[0] + 16, p[1] / 2 + 6), "$r_{i}$", LABEL)
    canvas.label((b[0] / 2 - 40, 18), "$F_{i}$", LABEL)
    legend(
        canvas, [area_key("right triangle", *_LEG), area_key("triangle of $p$ and side $i$", *_CONE)], 330.0
    )
    return canvas.fit()


# -- Lemma 10 -----------------------------------------------------------------------------------------------


class Obtuse(NamedTuple):
    """What is drawn for Lemma 10.

    Attributes
    ----------
    facet
        The ends of the side τ, the end of the longest edge at p first.
    p
        The vertex opposite to it.
    foot
        The foot of the height from p.
    circumcentre, squared_circumradius
        Of the triangle; τ separates the circumcentre from p.
    squared_height, squared_longest
        The squares of the height h and of the longest edge L at p.
    """

    facet: tuple[Vector, Vector]
    p: Vector
    foot: Vector
    circumcentre: Vector
    squared_circumradius: Fraction
    squared_height: Fraction
    squared_longest: Fraction


def lemma_10_plane() -> Figure[Obtuse]:
    """An obtuse triangle, its height and its longest edge at p, as on the right of Figure 12.

    >>> data = lemma_10_plane().data
    >>> str(data.squared_height / data.squared_longest)
    '9/34'
    """
    simplex = Simplex(OBTUSE)
    a, b, p = simplex.vertex_matrix.rows()
    if simplex.circumcentre_coordinates[2] >= 0 or a[1] or b[1]:
        raise InvalidInput("the last vertex is to be opposite to a level side that separates the centre")
    end, other = sorted((a, b), key=lambda v: -squared_distance(v, p))
    data = Obtuse(
        (end, other),
        p,
        (p[0], Fraction(0)),
        tuple(rational(x) for x in simplex.circumcentre),
        simplex.squared_circumradius,
        simplex.squared_heights[2],
        squared_distance(end, p),
    )
    title = "The height and the longest edge in the proof of Lemma 10"
    return Figure(title, _obtuse_words(data), data, lambda: _draw_10(data))


def _obtuse_words(data: Obtuse) -> str:
    return (
        f"The triangle {show(data.facet[0])}, {show(data.facet[1])}, p = {show(data.p)}, obtuse at p. Its "
        f"circumcentre c = {show(data.circumcentre)} lies beyond the side τ opposite to p. The height from "
        f"p has h = {words(sqrt(data.squared_height))}, the longest edge at p L = "
        f"{words(sqrt(data.squared_longest))}: h²/L² = {data.squared_height / data.squared_longest}, less "
        "than 1/2, so the angle between the edge and τ is less than π/4."
    )


def _draw_10(data: Obtuse) -> Canvas:
    canvas, scale = Canvas(), 33.0

    def pixel(x: Vector) -> Point:
        return sheet(scale, *map(float, x))

    end, other, p, foot, centre = map(pixel, (*data.facet, data.p, data.foot, data.circumcentre))
    canvas.disc(centre, scale * float(sqrt(data.squared_circumradius)), None, _CIRCLE)
    canvas.polygons([(end, other, p)], GREEN, 0.3, _SIMPLEX)
    diagonal = toward(end, (end[0] + (1 if other[0] > end[0] else -1), end[1] - 1), 148)
    canvas.lines([(end, diagonal)], _DASHED)
    canvas.lines([(end, other)], _FACET)
    canvas.lines([(p, foot)], _HEIGHT)
    canvas.lines([(p, end)], _LONGEST)
    right_angle(canvas, foot, p, end)
    canvas.lines([arc(end, 66.0, other, p)], Pen(VERMILLION, 1.6))
    canvas.lines([arc(end, 96.0, other, diagonal)], _DASHED)
    for point in (end, other, p):
        canvas.disc(point, 4.0)
    canvas.disc(centre, 5.0, None, _CIRCLE)
    canvas.label((p[0], p[1] - 18), "$p$", LABEL)
    canvas.label((p[0] - 13, (p[1] + foot[1]) / 2 + 4), "$h$", LABEL)
    canvas.label(((2 * p[0] + end[0]) / 3 + 6, (2 * p[1] + end[1]) / 3 - 16), "$L$", LABEL)
    canvas.label(((2 * end[0] + other[0]) / 3, 19), "$\\tau$", LABEL)
    canvas.label((centre[0] + 16, centre[1]), "$c$", LABEL)
    canvas.label((diagonal[0], diagonal[1] - 11), "$\\pi/4$", SMALL + 2)
    keys = [
        point_key("circumcircle, centre", 5.0, None, _CIRCLE),
        line_key("height", _HEIGHT),
        line_key("longest edge at $p$", _LONGEST),
    ]
    legend(canvas, keys, 330.0)
    return canvas.fit()
