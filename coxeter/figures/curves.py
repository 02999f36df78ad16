"""The qualities of all families against the dimension."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from ..affine import CoxeterTriangulation
from ..errors import InvalidInput
from ..names import MINIMAL_DIMENSION, triangulations_up_to
from ..peers import Peer
from ..quality import Measure, Number, find_measure
from .canvas import BLUE, FAINT, FINE, GREEN, INK, PURPLE, SMALL, VERMILLION, Canvas, Pen, Point, between
from .figure import Figure
from .legends import Key, legend
from .placement import clear_place

_LEADER = Pen(INK, 1.0, opacity=0.6)
_WIDTH, _HEIGHT, _INSET = 410.0, 270.0, 20.0
_PENS = {
    "A": Pen(BLUE, 2.2),
    "B": Pen(VERMILLION, 2.2),
    "C": Pen(GREEN, 2.2, (9.0, 6.0)),
    "D": Pen(PURPLE, 2.6, (1.0, 6.0)),
}
"""Where curves coincide, as those of thickness do, one is seen through the gaps of the other."""


_PEER_PENS = tuple(
    Pen(INK, 1.6, dash) for dash in ((8.0, 4.0), (2.0, 4.0), (12.0, 4.0, 2.0, 4.0), (4.0, 8.0))
)


class Curve(NamedTuple):
    """The normalised quality of a family in each of its dimensions; a single triangulation is a point."""

    family: str
    values: tuple[tuple[int, Number], ...]


class Curves(NamedTuple):
    """What is drawn: the measure in words, the curves of the families, and those of other triangulations."""

    measure: str
    curves: tuple[Curve, ...]
    peers: tuple[Curve, ...] = ()


def quality_curves(
    measure: str | Measure[Any], max_dim: int = 10, peers: Sequence[Peer] = ()
) -> Figure[Curves]:
    """The normalised quality of all Coxeter triangulations against the dimension.

    Parameters
    ----------
    measure
        A measure, or its name, as ``"thickness"``.
    max_dim
        The largest dimension, at least 2.
    peers
        Other triangulations, of which the worst simplex counts; they are left out where there is none, or the
        measure has no method for it.

    Raises
    ------
    InvalidInput
        If there is no such measure, or the dimension is less than 2.

    Examples
    --------
    >>> dict(quality_curves("thickness", 3).data.curves)["A"]
    ((2, 1), (3, sqrt(3)/2))
    """
    known = measure if isinstance(measure, Measure) else find_measure(measure)
    if isinstance(max_dim, bool) or not isinstance(max_dim, int) or max_dim < 2:
        raise InvalidInput(f"{max_dim!r} is no dimension to go up to: give an integer >= 2")
    values: dict[str, list[tuple[int, Number]]] = {}
    for kind in triangulations_up_to(max_dim):
        value = known.normalized(CoxeterTriangulation(kind).simplex)
        values.setdefault(kind.family, []).append((kind.rank, value))
    words = known.name.replace("_", " ") + (" to the power 1/d" if known.per_dimension else "")
    others = (Curve(peer.name, tuple(_values_of(peer, known, max_dim))) for peer in peers)
    curves = tuple(Curve(family, tuple(values[family])) for family in sorted(values))
    data = Curves(words, curves, tuple(curve for curve in others if curve.values))
    title = f"Normalised {data.measure} of Coxeter triangulations{' and others' if peers else ''}"
    return Figure(title, _words(title, data), data, lambda: _draw(data))


def _values_of(peer: Peer, measure: Measure[Any], max_dim: int) -> list[tuple[int, Number]]:
    found = [(d, peer.worst_if_known(measure, d)) for d in range(2, max_dim + 1)]
    return [(d, x) for d, x in found if x is not None]


def _words(title: str, data: Curves) -> str:
    text = f"{title}, against the dimension; 1 is the regular simplex. "
    text += "; ".join(_values(family, values) for family, values in (*data.curves, *data.peers)) + "."
    for families, dimensions in _equal(data).items():
        names = ", ".join(f"{family}~" for family in families)
        text += f" Equal, {_range(dimensions[0], dimensions[-1])}: {names}."
    return text


def _values(family: str, values: Sequence[tuple[int, Number]]) -> str:
    """All values of a family in words, or, if they are many, three of them."""
    first, last = values[0][0], values[-1][0]
    if family not in MINIMAL_DIMENSION and len(values) == 1:
        return f"{_name(family)}: {values[0][1].decimal(3)} in dimension {first}"
    if len(values) <= 12:
        return f"{_name(family)}: {', '.join(x.decimal(3) for _, x in values)} in {_range(first, last)}"
    some = (values[0], values[len(values) // 2], values[-1])
    numbers = ", ".join(f"{x.decimal(3)} in dimension {d}" for d, x in some)
    return f"{_name(family)}, {_range(first, last)}: {numbers}"


def _name(family: str) -> str:
    """``A~``, ``E~6``; other triangulations keep their names."""
    if len(family) > 2 or family[0] not in "ABCDEFG" or family == "D1":
        return family
    return f"{family[0]}~{family[1:]}"


def _range(first: int, last: int) -> str:
    return f"dimensions {first} to {last}" if last > first else f"dimension {first}"


def _equal(data: Curves) -> dict[tuple[str, ...], list[int]]:
    """The infinite families whose values are equal, and the dimensions, without a gap, in which they are."""
    at: dict[int, dict[Number, tuple[str, ...]]] = {}
    for family, values in data.curves:
        for d, x in values if family in MINIMAL_DIMENSION else ():
            here = at.setdefault(d, {})
            here[x] = (*here.get(x, ()), family)
    found: dict[tuple[str, ...], list[int]] = {}
    for d in sorted(at):
        for families in at[d].values():
            if len(families) > 1 and (families not in found or found[families][-1] == d - 1):
                found.setdefault(families, []).append(d)
    return found


def _draw(data: Curves) -> Canvas:
    canvas = Canvas()
    everything = [value for curve in (*data.curves, *data.peers) for value in curve.values]
    dimensions = [d for d, _ in everything]
    top = max(1.0, *(float(x) for _, x in everything))
    last = max(*dimensions, 3)

    def place(d: float, value: float) -> Point:
        return _INSET + (_WIDTH - 2 * _INSET) * (d - 2) / (last - 2), -_HEIGHT * value / top

    _draw_axes(canvas, place, last, top)
    canvas.label((-34, place(2, top)[1] - 24), f"normalised {data.measure}", SMALL, "start")
    keys = []
    for family, values in data.curves:
        points = [place(d, float(x)) for d, x in values]
        if family in _PENS:
            keys.append(_draw_curve(canvas, family, points))
    for i, (name, values) in enumerate(data.peers):
        keys.append(_draw_peer(canvas, name, i, [place(d, float(x)) for d, x in values]))
    single = [(family, values[0]) for family, values in data.curves if family not in _PENS]
    _draw_points(canvas, [(family, place(d, float(x))) for family, (d, x) in single])
    legend(canvas, keys, _WIDTH)
    return canvas.fit(margin=6)


def _draw_axes(canvas: Canvas, place: Callable[[float, float], Point], last: int, top: float) -> None:
    """The axes with their ticks, and a line across for each value named."""
    step = _step(top / 5)
    for i in range(int(top / step + 1e-9) + 1):
        y = place(2, i * step)[1]
        canvas.lines([((0, y), (_WIDTH, y))], FINE if i == 0 else FAINT)
        canvas.label((-9, y), f"{i * step:g}", SMALL, "end")
    step = max(1.0, _step((last - 2) / 10))
    for d in [2, *range(int(step), last + 1, int(step))] if step > 1 else range(2, last + 1):
        x = place(d, 0)[0]
        canvas.lines([((x, 0), (x, 5))], FINE)
        canvas.label((x, 17), str(d), SMALL)
    canvas.label((_WIDTH / 2, 37), "dimension $d$", SMALL)


def _step(least: float) -> float:
    """The least of 1, 2, 5 times a power of ten that is not below some number."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(k * power for k in (1, 2, 5, 10) if k * power >= least * (1 - 1e-9))


# -- curves, each with a colour and a marker of its own ----------------------------------------------------


def _draw_curve(canvas: Canvas, family: str, points: Sequence[Point]) -> Key:
    pen = _PENS[family]
    canvas.lines([points] if len(points) > 1 else [], pen)
    marked = points[:: math.ceil(len(points) / 16)]

    def sample(canvas: Canvas, at: Point) -> None:
        canvas.lines([(at, (at[0] + 36, at[1]))], pen)
        _mark(canvas, family, [(at[0] + 18, at[1])])

    _mark(canvas, family, marked)
    return Key(f"$\\tilde{{{family}}}_{{d}}$", sample, 36)


def _draw_peer(canvas: Canvas, name: str, number: int, points: Sequence[Point]) -> Key:
    """A thin line in ink, dashed in its own way, and open marks; a mark alone where there is one dimension."""
    pen, shape = _PEER_PENS[number % len(_PEER_PENS)], [*_MARKERS.values()][number % len(_MARKERS)]

    def mark(canvas: Canvas, points: Sequence[Point]) -> None:
        outlines = [[(x + dx, y + dy) for dx, dy in shape] for x, y in points]
        canvas.polygons(outlines, INK, 0.0, Pen(INK, 1.6))

    def sample(canvas: Canvas, at: Point) -> None:
        if len(points) > 1:
            canvas.lines([(at, (at[0] + 36, at[1]))], pen)
        mark(canvas, [(at[0] + 18, at[1])])

    canvas.lines([points] if len(points) > 1 else [], pen)
    mark(canvas, points[:: math.ceil(len(points) / 16)])
    return Key(name, sample, 36)


_MARKERS: dict[str, tuple[Point, ...]] = {
    "B": ((-5, -5), (5, -5), (5, 5), (-5, 5)),
    "C": ((0, -5.4), (5.4, 0), (0, 5.4), (-5.4, 0)),
    "D": ((0, -4.4), (3.8, 2.4), (-3.8, 2.4)),
}


def _mark(canvas: Canvas, family: str, points: Sequence[Point]) -> None:
    colour = _PENS[family].colour
    if family == "A":
        for point in points:
            canvas.disc(point, 4.8, colour)
    else:
        canvas.polygons([[(x + dx, y + dy) for dx, dy in _MARKERS[family]] for x, y in points], colour, 1.0)


def _draw_points(canvas: Canvas, named: Sequence[tuple[str, Point]]) -> None:
    """Crosses for the single triangulations, then their names where there is room."""
    for _, (x, y) in named:
        canvas.lines([((x - 5, y - 5), (x + 5, y + 5)), ((x - 5, y + 5), (x + 5, y - 5))], Pen(INK, 2.4))
    for family, point in named:
        place = clear_place(canvas, point, (point[0], -2 * _HEIGHT), (18.0, 24.0, 32.0, 42.0, 54.0, 68.0))
        if math.dist(point, place) > 24:
            canvas.lines([(between(place, point, 0.3), between(point, place, 0.2))], _LEADER)
        canvas.label(place, f"$\\tilde{{{family[0]}}}_{{{family[1]}}}$", SMALL + 2)
