"""The qualities of Hill's simplices, against the product of two steps."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from ..exact import Surd
from ..optimality.fillers import hill
from ..quality import PAPER_MEASURES
from .canvas import BLUE, FAINT, FINE, GREEN, INK, PURPLE, SMALL, VERMILLION, Canvas, Pen, Point
from .figure import Figure
from .legends import legend, line_key

_WIDTH, _HEIGHT, _POINTS = 390.0, 250.0, 96
_PENS = {
    "aspect_ratio": Pen(BLUE, 2.2),
    "fatness": Pen(GREEN, 2.2, (9.0, 6.0)),
    "thickness": Pen(VERMILLION, 2.2, (1.0, 6.0)),
    "radius_ratio": Pen(PURPLE, 2.2, (14.0, 4.0, 2.0, 4.0)),
}


class HillCurves(NamedTuple):
    """What is drawn: the dimension, and for each measure the pairs of w and the normalised value."""

    dimension: int
    curves: dict[str, tuple[tuple[Fraction, Surd], ...]]

    def best(self, measure: str) -> Fraction:
        """The w with the greatest value of those that are drawn."""
        return max(self.curves[measure], key=lambda pair: pair[1])[0]


def hill_curves(d: int) -> Figure[HillCurves]:
    """The normalised measures of Hill's simplices in a dimension, for w between -1/(d - 1) and 1.

    Raises `InvalidInput` if d is no dimension of Hill simplices.

    Examples
    --------
    >>> hill_curves(3).data.best("thickness")
    Fraction(-1, 3)
    """
    hill(d, 0)  # refuses what is no dimension
    low = Fraction(-1, d - 1)
    inner = {low + (1 - low) * Fraction(k, _POINTS) for k in range(1, _POINTS)}
    simplices = {w: hill(d, w) for w in sorted(inner | {Fraction(-1, d), Fraction(0)})}
    curves = {m.name: tuple((w, m.normalized(s)) for w, s in simplices.items()) for m in PAPER_MEASURES}
    data = HillCurves(d, curves)
    title = f"Normalised qualities of Hill simplices of dimension {d}"
    return Figure(title, _words(title, data), data, lambda: _draw(data))


def _words(title: str, data: HillCurves) -> str:
    text = f"{title}, against the product w of two steps of the path. "
    for measure, values in data.curves.items():
        top = max(values, key=lambda pair: pair[1])
        at_zero = next(value for w, value in values if w == 0)
        text += f"{measure.replace('_', ' ')}: greatest, {top[1].decimal(3)}, at w = {top[0]}, "
        text += f"and {at_zero.decimal(3)} at w = 0. "
    return text.strip()


def _draw(data: HillCurves) -> Canvas:
    canvas, low = Canvas(), -1 / (data.dimension - 1)

    def place(w: float, value: float) -> Point:
        return _WIDTH * (w - low) / (1 - low), -_HEIGHT * value

    for value in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0):
        y = place(low, value)[1]
        canvas.lines([((0, y), (_WIDTH, y))], FAINT if value else FINE)
        canvas.label((-9, y), f"{value:g}", SMALL, "end")
    marks = {low: f"-1/{data.dimension - 1}", -1 / data.dimension: f"-1/{data.dimension}", 0.0: "0", 1.0: "1"}
    if data.dimension > 3:
        del marks[low]  # there is no room for both
    for w, text in marks.items():
        x = place(w, 0)[0]
        canvas.lines([((x, 0), (x, 5))], FINE)
        canvas.label((x, 17), text.replace("-", "−"), SMALL)
    x = place(-1 / data.dimension, 0)[0]
    canvas.lines([((x, 0), (x, -_HEIGHT))], Pen(INK, 1.0, (4.0, 4.0), 0.6))
    for measure, values in data.curves.items():
        points = [place(float(w), float(value)) for w, value in values]
        canvas.lines([[place(low, 0), *points, place(1, 0)]], _PENS[measure])  # flat at both ends
    canvas.label((_WIDTH / 2, 40), f"$w$, for $d = {data.dimension}$", SMALL)
    legend(canvas, [line_key(m.replace("_", " "), pen) for m, pen in _PENS.items()], _WIDTH)
    return canvas.fit(margin=6)
