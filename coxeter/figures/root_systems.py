"""The root systems of rank 2 among their hyperplanes (paper, Figure 1)."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from ..affine import CoxeterTriangulation, Vector
from ..exact import RationalMatrix, show
from ..names import Type
from ..root_sets import coroots
from ..roots import RootSystem, root_system
from .canvas import BLUE, FAINT, GREEN, LABEL, VERMILLION, Canvas, Pen, Point
from .figure import Figure
from .legends import area_key, arrow_key, legend
from .plane import Line, Triangle, Window, frame

_SIZE = 336.0
_ROOT, _SIMPLE, _HIGHEST = Pen(width=1.7), Pen(VERMILLION, 3.2), Pen(BLUE, 3.2)
_DOMAIN = (GREEN, 0.45, Pen(GREEN, 1.6))


class Roots(NamedTuple):
    """What is drawn: roots, or coroots, among the lines <x, r> = k of the roots r.

    Attributes
    ----------
    name, dual
        The root system, and whether its coroots are drawn.
    window
        The part of the plane that is drawn.
    lines
        The lines that cross the window.
    vectors
        All roots, or all coroots.
    simple, highest
        The simple roots and the highest root, or their coroots.
    domain
        The vertices of the fundamental domain.
    """

    name: str
    dual: bool
    window: Window
    lines: tuple[Line, ...]
    vectors: tuple[Vector, ...]
    simple: tuple[Vector, ...]
    highest: Vector
    domain: Triangle


def root_system_plane(name: object, dual: bool = False) -> Figure[Roots]:
    """A root system of rank 2, its affine hyperplanes and its fundamental domain, as in Figure 1.

    Parameters
    ----------
    name
        ``"A2"``, ``"B2"``, ``"C2"`` or ``"G2"``.
    dual
        Draw the coroots instead, on the hyperplanes of the roots. The coroot of the highest root
        ends in the mirror image of the origin in the wall <x, highest root> = 1.

    Raises
    ------
    InvalidInput
        If the rank is not 2.

    Examples
    --------
    >>> root_system_plane("B2").data.highest
    (Fraction(1, 1), Fraction(1, 1))
    """
    system = root_system(getattr(name, "name", name))
    window = _window(system)
    vectors, simple, highest = (
        system.roots,
        system.simple_roots,
        RationalMatrix.from_rows([system.highest_root]),
    )
    if dual:
        vectors, simple, highest = coroots(vectors), coroots(simple), coroots(highest)
    u, v, w = CoxeterTriangulation(Type(system.type.letter, 2)).simplex.vertex_matrix.rows()
    data = Roots(
        system.name,
        dual,
        window,
        window.lines(system.positive_roots.rows()),
        vectors.rows(),
        simple.rows(),
        highest.row(0),
        (u, v, w),
    )
    return Figure(_title(data), _words(data), data, lambda: _draw(data))


def _window(system: RootSystem) -> Window:
    """A square window that holds all roots and all coroots, so that both can be compared."""
    axes = frame(system)
    probe = Window(axes, (Fraction(0), Fraction(0)), (Fraction(1), Fraction(1)), 1.0)
    both = [*system.roots.rows(), *system.coroots.rows()]
    largest = max(abs(c) for vector in both for c in probe.project(vector))
    half = Fraction((largest * Fraction(6, 5)).decimal(1))
    return Window(axes, probe.centre, (half, half), _SIZE / float(2 * half))


def _title(data: Roots) -> str:
    return f"The coroots of {data.name}" if data.dual else f"Root system {data.name}"


def _words(data: Roots) -> str:
    what = "coroots" if data.dual else "roots"
    simple = ", ".join(f"s_{k} = {show(s)}" for k, s in enumerate(data.simple, 1))
    if data.dual:
        simple = simple.replace(" =", "^v =")
    top = "the coroot of the highest root is" if data.dual else "highest root"
    return (
        f"{_title(data)}: {len(data.vectors)} arrows from the origin, over the {len(data.lines)} lines "
        "<x, r> = k, r a root and k an integer, that cross the window. "
        f"Simple {what} {simple}; {top} {show(data.highest)}. "
        f"The fundamental domain has the vertices {', '.join(map(show, data.domain))}."
    )


def _draw(data: Roots) -> Canvas:
    canvas, window = Canvas(), data.window
    canvas.lines([window.segment(line) for line in data.lines], FAINT)
    corners = [window.pixel(v) for v in data.domain]
    canvas.polygons([corners], *_DOMAIN)
    origin = corners[0]
    marked = {**dict.fromkeys(data.simple, _SIMPLE), data.highest: _HIGHEST}
    for vector in sorted(data.vectors, key=lambda v: v in marked):
        canvas.arrow(origin, window.pixel(vector), marked.get(vector, _ROOT))
    canvas.disc(origin, 3.4)
    dual = r"^{\vee}" if data.dual else ""
    for text, vector in (
        *((f"$s_{{{k}}}{dual}$", s) for k, s in enumerate(data.simple, 1)),
        (rf"$\tilde{{s}}{dual}$", data.highest),
    ):
        canvas.label(_beyond(window.pixel(vector), 15), text, LABEL + 1)
    what, top = ("coroots", "coroot of the highest root") if data.dual else ("roots", "highest root")
    domain = area_key("fundamental domain", *_DOMAIN)
    legend(canvas, [arrow_key(f"simple {what}", _SIMPLE), domain, arrow_key(top, _HIGHEST)], _SIZE)
    return canvas.fit()


def _beyond(tip: Point, distance: float) -> Point:
    length = (tip[0] ** 2 + tip[1] ** 2) ** 0.5
    return tip[0] * (1 + distance / length), tip[1] * (1 + distance / length)
