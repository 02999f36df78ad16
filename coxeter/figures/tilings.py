"""The Coxeter triangulations of the plane as ornaments: a tiling, and one tile of it in colour."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from ..affine import triangulation
from ..exact import show
from .canvas import FAINT, GREEN, INK, Canvas, Pen
from .figure import Figure
from .plane import Line, Triangle, Window, frame, triangles_in

_WIDTH, _HEIGHT = 300, 210
_AREA = Fraction(1, 26)
"""The part of the window that the fundamental simplex fills: about as many tiles in each picture."""
_SHADE = 0.1


class Tiling(NamedTuple):
    """What is drawn: a window on a triangulation, its lines, the shaded triangles and the one in colour."""

    name: str
    window: Window
    lines: tuple[Line, ...]
    shaded: tuple[Triangle, ...]
    simplex: Triangle


def tiling(name: object) -> Figure[Tiling]:
    """A Coxeter triangulation of the plane, as a tiling by mirror images of one triangle.

    Every other triangle is shaded. `plane_triangulation` shows more of it: vertices, circles, centres.

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
    >>> len(tiling("C~2").data.simplex)
    3
    """
    t = triangulation(getattr(name, "name", name))
    axes, simplex = frame(t.roots), t.simplex
    scale = (float(_AREA) * _WIDTH * _HEIGHT / float(simplex.volume)) ** 0.5
    half = (
        Fraction(_WIDTH / 2 / scale).limit_denominator(999),
        Fraction(_HEIGHT / 2 / scale).limit_denominator(999),
    )
    origin = Window(axes, (Fraction(0), Fraction(0)), half, scale)
    window = Window(axes, origin.project(simplex.incentre), half, scale)
    u, v, w = simplex.vertex_matrix.rows()
    data = Tiling(
        t.name,
        window,
        window.lines(t.roots.positive_roots.rows()),
        tuple(triangle for triangle, parity in triangles_in(window, t) if parity),
        (u, v, w),
    )
    return Figure(f"The plane cut by {data.name}", _words(data), data, lambda: _draw(data))


def _words(data: Tiling) -> str:
    return (
        f"The tiling {data.name}: {len(data.lines)} lines cut the window into triangles, every other one "
        "shaded, each the mirror image of its neighbours. One is in colour, with the vertices "
        f"{', '.join(map(show, data.simplex))}."
    )


def _draw(data: Tiling) -> Canvas:
    canvas, window = Canvas(), data.window
    outlines = (window.clip([window.pixel(v) for v in triangle]) for triangle in data.shaded)
    canvas.polygons([outline for outline in outlines if len(outline) > 2], INK, _SHADE)
    canvas.lines([window.segment(line) for line in data.lines], FAINT)
    canvas.polygons([[window.pixel(u) for u in data.simplex]], GREEN, 0.55, Pen(GREEN, 2.6))
    return canvas.fit(margin=1)
