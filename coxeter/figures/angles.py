"""How the other roots lie as seen from a short one: the table of angles after Definition 7, as a picture."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

from ..affine import Vector
from ..exact import Surd, show, sqrt
from ..root_sets import AnglePair, angle_table, cartan_integer
from ..roots import RootSystem, root_system
from .canvas import BLUE, FAINT, PURPLE, SMALL, VERMILLION, Canvas, Pen, Point
from .figure import Figure
from .legends import arrow_key, legend
from .marks import turned
from .plane import Window, orthonormal, plane_roots
from .written import formula, words

_LONGEST, _WIDTH = 118.0, 330.0
_INTEGERS = "the Cartan integers $n(s, r)$, $n(r, s)$"
_FROM, _SAME, _LONGER = Pen(VERMILLION, 3.2), Pen(BLUE, 2.2), Pen(PURPLE, 2.6)


class Seen(NamedTuple):
    """A root s as seen from the root r.

    Attributes
    ----------
    root
        The root s.
    angle
        The angle between r and s, as a multiple of pi.
    ratio
        The quotient of lengths |s|/|r|.
    n_sr, n_rs
        The Cartan integers n(s, r) and n(r, s).
    """

    root: Vector
    angle: Fraction
    ratio: Surd
    n_sr: int
    n_rs: int


class AngleClasses(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    name
        The root system.
    window
        The plane, with r to the right.
    seen_from
        The root r, a simple root of least length.
    roots
        All other roots, by angle.
    classes
        The rows of the table of angles that occur: relations of angle and length.
    """

    name: str
    window: Window
    seen_from: Vector
    roots: tuple[Seen, ...]
    classes: tuple[AnglePair, ...]


def angle_classes(name: object) -> Figure[AngleClasses]:
    """All roots as one short root r sees them: at which angle, how long, with which Cartan integers.

    Parameters
    ----------
    name
        ``"A2"``, ``"B2"``, ``"C2"`` or ``"G2"``.

    Raises
    ------
    InvalidInput
        If the rank is not 2.

    Examples
    --------
    >>> [(str(s.angle), s.ratio) for s in angle_classes("A2").data.roots]
    [('1/3', 1), ('1/3', 1), ('2/3', 1), ('2/3', 1), ('1', 1)]
    """
    system = root_system(getattr(name, "name", name))
    r, other = _short_and_other(system)
    table = angle_table(system.roots)
    angles = {(row.n_sr, row.n_rs): row.angle for row in table}
    seen = []
    for s in system.roots.rows():
        if s != r:
            n_sr, n_rs = int(cartan_integer(s, r)), int(cartan_integer(r, s))
            seen.append(Seen(s, angles[n_sr, n_rs], sqrt(_square(s) / _square(r)), n_sr, n_rs))
    longest = max(sqrt(_square(s)) for s in system.roots.rows())
    zero, half = Fraction(0), Fraction(longest.decimal(1))
    window = Window(orthonormal(r, other), (zero, zero), (half, half), _LONGEST / float(longest))
    ordered = tuple(sorted(seen, key=lambda s: (s.angle, s.ratio, s.root)))
    data = AngleClasses(system.name, window, r, ordered, table)
    return Figure(f"The roots of {data.name} as seen from one", _words(data), data, lambda: _draw(data))


def _short_and_other(system: RootSystem) -> tuple[Vector, Vector]:
    r, other = sorted(plane_roots(system), key=_square)
    return r, other


def _square(x: Vector) -> Fraction:
    return sum((c * c for c in x), Fraction(0))


def _words(data: AngleClasses) -> str:
    kinds: dict[tuple[Fraction, Surd, int, int], int] = {}
    for s in data.roots:
        kinds[s[1:]] = kinds.get(s[1:], 0) + 1
    listed = [
        f"{180 * angle}°: {count} of length {'' if ratio == 1 else words(ratio)}|r|, "
        f"n(s, r) = {n_sr}, n(r, s) = {n_rs}"
        for (angle, ratio, n_sr, n_rs), count in kinds.items()
    ]
    return (
        f"The roots s of {data.name} as seen from the short root r = {show(data.seen_from)}, by their angle "
        f"with r. {'; '.join(listed)}."
    )


def _draw(data: AngleClasses) -> Canvas:
    canvas, window, origin = Canvas(), data.window, (0.0, 0.0)
    short = math.dist(origin, window.pixel(data.seen_from))
    lengths = sorted({s.ratio for s in data.roots})
    for ratio in lengths:
        canvas.lines([turned(origin, short * float(ratio), 0.0, 2 * math.pi)], FAINT)
    for s in data.roots:
        canvas.arrow(origin, window.pixel(s.root), _SAME if s.ratio == 1 else _LONGER)
    canvas.arrow(origin, window.pixel(data.seen_from), _FROM)
    canvas.disc(origin, 3.4)
    canvas.label(_beyond(window.pixel(data.seen_from), 14), "$r$", SMALL + 5)
    for s in data.roots:
        x, y = _beyond(window.pixel(s.root), 25)
        canvas.label((x, y - 8), f"${180 * s.angle}\\circ$", SMALL + 2)
        canvas.label((x, y + 9), f"${s.n_sr}$, ${s.n_rs}$", SMALL - 1)
    keys = [arrow_key("$|s| = |r|$", _SAME)]
    keys += [arrow_key(f"$|s| = {formula(x)}|r|$", _LONGER) for x in lengths[1:]]
    legend(canvas, keys, _WIDTH)
    left, _, right, bottom = canvas.box
    for row, text in ((14, "At each root: its angle with $r$, and"), (34, _INTEGERS)):
        canvas.label(((left + right) / 2, bottom + row), text, SMALL)
    return canvas.fit(least_width=_WIDTH)


def _beyond(tip: Point, distance: float) -> Point:
    length = math.hypot(*tip)
    return tip[0] * (1 + distance / length), tip[1] * (1 + distance / length)
