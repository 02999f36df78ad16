"""Protection: how far the circumscribed ball is from the next vertices (paper, Appendix C)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations, islice, product
from typing import NamedTuple

from ..affine import CoxeterTriangulation, Vector, triangulation
from ..delaunay import circumcentre_position, protection
from ..errors import InvalidInput
from ..exact import RationalMatrix, Surd, rational, show, sqrt
from ..simplex import Position
from .canvas import BLUE, FAINT, GREEN, INK, LABEL, PURPLE, VERMILLION, Canvas, Pen
from .figure import Figure
from .legends import Key, legend, line_key, point_key
from .marks import extent, toward
from .placement import clear_place
from .plane import Window, frame
from .space import View, draw_tetrahedron
from .written import formula, words

_BREADTH, _RADIUS = 330.0, 128.0
_SPHERE, _PROTECTING, _DISTANCE = Pen(BLUE, 2.2), Pen(PURPLE, 2.2, (7.0, 5.0)), Pen(VERMILLION, 2.6)
_NEIGHBOURS, _NEAREST = Pen(INK, 1.1, opacity=0.5), (5.0, PURPLE, None)


class Protected(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    name
        The triangulation.
    simplex
        The vertices of the fundamental simplex.
    circumcentre, squared_circumradius
        Of its circumscribed sphere.
    nearest
        The other vertices nearest to it, with the numbers k of the facets: they are the images s_k(u_k).
    squared_distance
        Their squared distance from the circumcentre.
    absolute, relative
        The protection: the difference of the two radii, and what part of the circumradius that is.
    """

    name: str
    simplex: tuple[Vector, ...]
    circumcentre: Vector
    squared_circumradius: Fraction
    nearest: tuple[tuple[int, Vector], ...]
    squared_distance: Fraction
    absolute: Surd
    relative: Surd


def protection_spheres(name: object) -> Figure[Protected]:
    """The circumscribed sphere, and the sphere with the same centre through the nearest other vertices.

    Parameters
    ----------
    name
        A Delaunay triangulation of the plane or of space: ``"A~2"``, ``"C~2"``, ``"G~2"``, ``"A~3"``,
        ``"C~3"``. Only A~2 and A~3 are protected; for the others the two spheres are one.

    Raises
    ------
    InvalidInput
        If the dimension is another, or the triangulation is not Delaunay.

    Examples
    --------
    >>> protection_spheres("A~3").data.relative
    -1 + sqrt(65)/5
    """
    t = triangulation(getattr(name, "name", name))
    if t.dimension > 3:
        raise InvalidInput(f"{t.name} has dimension {t.dimension}: give a triangulation of dimension 2 or 3")
    if circumcentre_position(t.simplex) is Position.OUTSIDE:
        raise InvalidInput(f"{t.name} is not Delaunay, hence has no protection; sphere_not_empty() shows it")
    data = _data(t)
    return Figure(f"Protection of {t.name}", _words(data), data, lambda: _draw(data, t))


def _data(t: CoxeterTriangulation) -> Protected:
    simplex, found = t.simplex, protection(t)
    return Protected(
        t.name,
        simplex.vertex_matrix.rows(),
        tuple(rational(x) for x in simplex.circumcentre),
        simplex.squared_circumradius,
        tuple((mirror.facet, mirror.point) for mirror in found.nearest),
        found.nearest[0].squared_distance,
        found.absolute,
        found.relative,
    )


def _words(data: Protected) -> str:
    sphere = "circle" if len(data.simplex) == 3 else "sphere"
    radius, distance = (words(sqrt(x)) for x in (data.squared_circumradius, data.squared_distance))
    nearest = ", ".join(f"s_{k}(u_{k}) = {show(v)}" for k, v in data.nearest)
    many = len(data.nearest) > 1
    text = (
        f"The fundamental simplex of {data.name} in its circumscribed {sphere} with centre c = "
        f"{show(data.circumcentre)} and radius R = {radius}. "
        f"The nearest other {'vertices are' if many else 'vertex is'} {nearest}, "
    )
    if not data.absolute:
        return text + f"on the same {sphere}: the protection is 0."
    return text + (
        f"on the {sphere} with the same centre and radius R' = {distance}. The protection is their "
        f"difference, δ = {words(data.absolute)}, and δ/R = {words(data.relative)}, about "
        f"{data.relative.decimal(3)}."
    )


# -- drawing ------------------------------------------------------------------------------------------------


def _draw(data: Protected, t: CoxeterTriangulation) -> Canvas:
    canvas = Canvas()
    outer = float(sqrt(data.squared_distance))
    scale = _RADIUS / outer
    if t.dimension == 2:
        axes, half = frame(t.roots), Fraction(round(1.15 * outer * 1000), 1000)
        middle = Window(axes, (Fraction(0), Fraction(0)), (half, half), scale).project(data.circumcentre)
        window = Window(axes, middle, (half, half), scale)
        canvas.lines([window.segment(x) for x in window.lines(t.roots.positive_roots.rows())], FAINT)
        pixel = window.pixel
        corners = [pixel(u) for u in data.simplex]
        canvas.polygons([corners], GREEN, 0.4, Pen(GREEN, 2.4))
    else:
        view = _view(data, scale)
        pixel = view.pixel
        beyond = [(pixel(v), pixel(u)) for k, v in data.nearest for i, u in enumerate(data.simplex) if i != k]
        canvas.lines(beyond, _NEIGHBOURS)
        draw_tetrahedron(canvas, view, data.simplex)
    radius = scale * float(sqrt(data.squared_circumradius))
    canvas.disc((0.0, 0.0), radius, BLUE, _SPHERE, 0.07)
    if data.absolute:
        canvas.disc((0.0, 0.0), _RADIUS, None, _PROTECTING)
    at = {k: pixel(u) for k, u in enumerate(data.simplex)}
    for point in at.values():
        canvas.disc(point, 4.0)
    for _, v in data.nearest:
        canvas.disc(pixel(v), *_NEAREST)
    canvas.disc((0.0, 0.0), 4.5, None, _SPHERE)
    if data.absolute:
        tip = pixel(data.nearest[0][1])
        extent(canvas, tip, toward((0.0, 0.0), tip, radius), _DISTANCE)
    for k, v in data.nearest if t.dimension == 2 else data.nearest[:1]:
        place = clear_place(canvas, pixel(v), (0.0, 0.0), (26.0, 32.0, 38.0), 22.0)
        canvas.label(place, f"$s_{{{k}}}(u_{{{k}}})$", LABEL)
    for k, point in at.items():
        canvas.label(clear_place(canvas, point, (0.0, 0.0), (18.0, 22.0)), f"$u_{{{k}}}$", LABEL)
    canvas.label(clear_place(canvas, (0.0, 0.0), (0.0, 0.0), (17.0, 21.0)), "$c$", LABEL)
    legend(canvas, _keys(data), _BREADTH)
    return canvas.fit()


def _view(data: Protected, scale: float) -> View:
    """A view with one of the nearest vertices at the right end, that shows all points apart."""
    centre = data.circumcentre
    right = _minus(data.nearest[0][1], centre)
    edges = [_minus(u, centre) for u in data.simplex]
    seeds = []
    for weights in product(range(-2, 3), repeat=3):
        up = _combined(weights, edges)
        behind = (x for x in edges if RationalMatrix.from_rows([right, up, x]).rank() == 3)
        seeds += [(right, up, third) for third in islice(behind, 1)]
    return max((View.along(x, centre, scale) for x in seeds), key=lambda view: _merit(view, data))


def _combined(weights: Sequence[int], vectors: Sequence[Vector]) -> Vector:
    columns = zip(*vectors[: len(weights)], strict=True)
    return tuple(sum((w * x for w, x in zip(weights, c, strict=True)), Fraction(0)) for c in columns)


def _minus(x: Vector, y: Vector) -> Vector:
    return tuple(a - b for a, b in zip(x, y, strict=True))


def _merit(view: View, data: Protected) -> float:
    """The least distance of two points that are drawn, or of a nearest vertex and the inner sphere."""
    nearest = [view.pixel(v) for _, v in data.nearest]
    points = [view.pixel(u) for u in data.simplex] + nearest + [(0.0, 0.0)]
    apart = min(math.dist(p, q) for p, q in combinations(points, 2))
    radius = view.scale * float(sqrt(data.squared_circumradius)) if data.absolute else 0.0
    return round(min(apart, *(math.hypot(*p) - radius for p in nearest)), 3)


def _keys(data: Protected) -> list[Key]:
    radius, distance = (formula(sqrt(x)) for x in (data.squared_circumradius, data.squared_distance))
    keys = [point_key(f"circumscribed, $R = {radius}$", 5.5, None, _SPHERE)]
    if not data.absolute:
        return [*keys, point_key("nearest other vertices", *_NEAREST)]
    return [
        *keys,
        line_key(f"through the nearest, $R' = {distance}$", _PROTECTING),
        line_key(f"protection $\\delta  = {formula(data.absolute)}$", _DISTANCE),
    ]
