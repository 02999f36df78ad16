"""The picture of Appendix B: two neighbours and their circles, and a gap in a proof (Figure 13)."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

from ..affine import Vector
from ..errors import InvalidInput
from ..exact import rational, show, sqrt
from ..simplex import Simplex
from .canvas import BLUE, GREEN, INK, LABEL, PURPLE, VERMILLION, Canvas, Pen, Point
from .figure import Figure
from .legends import Key, legend, line_key, point_key
from .marks import sheet, turned
from .placement import clear_place
from .written import words

FACET, APEX = ((0, 0), (4, 0)), (2, -1)
"""The facet τ, and the vertex p of σ opposite to it, as in the chapter on Appendix B."""

_BREADTH, _TALL, _WIDE = 330.0, 310.0, 290.0
_OWN, _OTHER, _CAP = Pen(BLUE, 2.2), Pen(PURPLE, 2.2, (7.0, 5.0)), Pen(VERMILLION, 4.6)
_AXES, _RADII = Pen(INK, 1.2, opacity=0.75), Pen(width=1.3, dash=(4.0, 4.0))


class Neighbours(NamedTuple):
    """What is drawn: the triangles σ and σ' on either side of their common side τ.

    Attributes
    ----------
    facet
        The ends of τ; the second is q.
    apex, other_apex
        The vertex p of σ opposite to τ, and that of σ'.
    middle
        The circumcentre o of τ.
    centre, other_centre
        The circumcentres c and c'.
    squared_radius, squared_other_radius
        R² and R'².
    power
        |p - c'|² - R'²: negative if p lies inside the circle of σ'.
    """

    facet: tuple[Vector, Vector]
    apex: Vector
    other_apex: Vector
    middle: Vector
    centre: Vector
    other_centre: Vector
    squared_radius: Fraction
    squared_other_radius: Fraction
    power: Fraction

    @property
    def delaunay(self) -> bool:
        """Whether p does not lie inside the circle of σ'."""
        return self.power >= 0

    @property
    def cap_below(self) -> bool | None:
        """Whether the part of S outside S' is the one below τ; None if the circles coincide."""
        heights = self.centre[1], self.other_centre[1]
        return None if heights[0] == heights[1] else heights[0] < heights[1]


def lemma_4_circles(apex: object = 6) -> Figure[Neighbours]:
    """The circles of two neighbours, and the cap of one outside the other, as in Figure 13.

    σ has the corners (0, 0), (4, 0) and p = (2, -1), so that τ separates it from its circumcentre c.

    Parameters
    ----------
    apex
        The height over τ of the third corner of σ', a positive rational number. With 4 the circles
        coincide, which the printed proof overlooks; with less p lies inside the circle of σ'.

    Raises
    ------
    InvalidInput
        If the height is not positive.

    Examples
    --------
    >>> lemma_4_circles().data.cap_below, lemma_4_circles(4).data.cap_below
    (True, None)
    """
    height = rational(apex)
    if height <= 0:
        raise InvalidInput(f"the apex at height {height} does not lie beyond the side: give a number > 0")
    own, other = Simplex([*FACET, APEX]), Simplex([*FACET, (2, height)])
    a, q, p = own.vertex_matrix.rows()
    c, d = (tuple(rational(x) for x in s.circumcentre) for s in (own, other))
    power = sum(((x - y) ** 2 for x, y in zip(p, d, strict=True)), Fraction(0)) - other.squared_circumradius
    data = Neighbours(
        (a, q),
        p,
        other.vertex_matrix.row(2),
        tuple((x + y) / 2 for x, y in zip(a, q, strict=True)),
        c,
        d,
        own.squared_circumradius,
        other.squared_circumradius,
        power,
    )
    return Figure("Two neighbours and their circles", _words(data), data, lambda: _draw(data))


def _words(data: Neighbours) -> str:
    corners = [f"{show(data.facet[0])}, q = {show(data.facet[1])}"]
    text = (
        f"The triangle σ with corners {corners[0]}, p = {show(data.apex)} below the side τ, and its "
        f"neighbour σ' above, with the apex {show(data.other_apex)}. On the line ℓ at right angles to τ "
        f"through its midpoint o = {show(data.middle)} lie the circumcentres: c at height {data.centre[1]}, "
        f"above τ and so outside σ, and c' at height {data.other_centre[1]}. "
    )
    radii = f"R = {words(sqrt(data.squared_radius))}, R' = {words(sqrt(data.squared_other_radius))}"
    if data.cap_below is None:
        return f"{text}They coincide, and so do the circles S and S': {radii}. There is no cap."
    side, larger = ("below", "larger") if data.cap_below else ("above", "smaller")
    if data.other_centre[1] ** 2 == data.centre[1] ** 2:
        larger = "as large"
    where = "is" if not data.delaunay else "is not"
    return (
        f"{text}The part of S outside S' is the one {side} τ, and p {where} inside S'. {radii}: the circle "
        f"of σ' is {larger}."
    )


# -- drawing ------------------------------------------------------------------------------------------------


def _draw(data: Neighbours) -> Canvas:
    canvas = Canvas()
    scale = _scale(data)

    def pixel(x: Vector) -> Point:
        return sheet(scale, float(x[0]), float(x[1]))

    a, q, p, top, o, c, d = map(
        pixel, (*data.facet, data.apex, data.other_apex, data.middle, data.centre, data.other_centre)
    )
    radii = [scale * float(sqrt(x)) for x in (data.squared_radius, data.squared_other_radius)]
    canvas.polygons([(a, q, top)], PURPLE, 0.14, Pen(PURPLE, 1.4))
    canvas.polygons([(a, q, p)], GREEN, 0.4, Pen(GREEN, 2.4))
    canvas.disc(c, radii[0], None, _OWN)
    canvas.disc(d, radii[1], None, _OTHER)
    if data.cap_below is not None:
        canvas.lines([_cap(a, q, c, radii[0], data.cap_below)], _CAP)
    left, upper, right, lower = canvas.box
    canvas.lines([((left - 14, 0.0), (right + 14, 0.0)), ((o[0], upper - 14), (o[0], lower + 10))], _AXES)
    same = data.cap_below is None
    canvas.lines([(c, q)] if same else [(c, q), (d, q)], _RADII)
    for point in (a, q, p, top, o):
        canvas.disc(point, 4.0)
    canvas.disc(d, 5.0, None, Pen(PURPLE, 2.2))
    canvas.disc(c, 5.0, None, _OWN)
    _labels(canvas, data, {"q": q, "p": p, "o": o, "c": c, "d": d}, (right, upper), scale)
    legend(canvas, _keys(data), _BREADTH)
    return canvas.fit()


def _scale(data: Neighbours) -> float:
    """So that both circles fit."""
    radii = [float(sqrt(x)) for x in (data.squared_radius, data.squared_other_radius)]
    centres = [float(x) for x in (data.centre[1], data.other_centre[1])]
    tall = max(c + r for c, r in zip(centres, radii, strict=True)) - min(
        c - r for c, r in zip(centres, radii, strict=True)
    )
    return min(_TALL / tall, _WIDE / (2 * max(radii)))


def _cap(a: Point, q: Point, c: Point, radius: float, below: bool) -> list[Point]:
    """The arc of a circle from a to q, below or above the chord."""
    first, last = (math.atan2(point[1] - c[1], point[0] - c[0]) for point in (a, q))
    turn = (last - first) % (2 * math.pi)
    return turned(c, radius, first, turn - 2 * math.pi if below else turn)


def _labels(
    canvas: Canvas, data: Neighbours, at: dict[str, Point], rim: tuple[float, float], scale: float
) -> None:
    same = data.cap_below is None
    right, upper = rim
    canvas.label((right + 14, -13), "$H_{\\tau}$", LABEL, "end")
    canvas.label((at["o"][0] + 12, upper - 8), "$\\ell$", LABEL)
    canvas.label((at["o"][0] - 0.9 * scale, 0.36 * scale), "$\\sigma$", LABEL)
    canvas.label((at["o"][0] - scale, -0.5 * scale), "$\\sigma'$", LABEL)
    names = {"q": "$q$", "p": "$p$", "o": "$o$", "c": "$c, c'$" if same else "$c$", "d": "$c'$"}
    for key, name in names.items():
        if key != "d" or not same:
            half = 14.0 if key == "c" and same else 9.0
            place = clear_place(canvas, at[key], (right, 2 * upper), (17.0, 21.0, 26.0, 34.0, 40.0), half)
            canvas.label(place, name, LABEL)


def _keys(data: Neighbours) -> list[Key]:
    own, other = (words(sqrt(x)) for x in (data.squared_radius, data.squared_other_radius))
    if data.cap_below is None:
        return [point_key(f"$S = S'$, with $R = R' = {own}$", 5.0, None, _OWN)]
    keys = [line_key(f"$S$, $R = {own}$", _OWN), line_key(f"$S'$, $R' = {other}$", _OTHER)]
    return [*keys, line_key("cap of $S$ outside $S'$", _CAP)]
