"""What a figure is drawn on: a short list of lines, discs and labels, in pixels, y downwards.

The style of all figures is here too: the colours, the widths of lines, the sizes of labels.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from .labels import runs, width

Point = tuple[float, float]
Box = tuple[float, float, float, float]

INK = "currentColor"
"""The colour of the text around the figure, so that the figure follows a light or a dark theme."""
BLUE, VERMILLION, GREEN, PURPLE = "#0072B2", "#D55E00", "#009E73", "#C4689B"
"""The tones of Okabe and Ito that stand out, at least 3 to 1, on white and on near-black."""

LABEL, SMALL = 18.0, 14.0
"""Sizes of labels: those of a formula, and those of words."""


@dataclass(frozen=True)
class Pen:
    """How a line is drawn: its colour, its width and dashes in pixels, its opacity."""

    colour: str = INK
    width: float = 1.6
    dash: tuple[float, ...] = ()
    opacity: float = 1.0


FINE, FAINT, BOLD = Pen(width=1.2), Pen(width=1.1, opacity=0.38), Pen(width=2.4)
"""Three pens in ink: for thin lines, for the background, which leaves room for labels, for what matters."""


@dataclass(frozen=True)
class Path:
    """Broken lines, drawn alike; closed ones may be filled."""

    lines: tuple[tuple[Point, ...], ...]
    pen: Pen | None = None
    closed: bool = False
    fill: str | None = None
    fill_opacity: float = 1.0

    def moved(self, dx: float, dy: float) -> Path:
        """The same, moved."""
        return replace(self, lines=tuple(tuple((x + dx, y + dy) for x, y in line) for line in self.lines))

    def around(self, boxes: Sequence[Box]) -> Path:
        """The same without what lies in some boxes; for open lines."""
        pieces = [(p, q) for line in self.lines for p, q in pairwise(line)]
        for box in boxes:
            pieces = [piece for p, q in pieces for piece in _outside(p, q, box)]
        return replace(self, lines=tuple(pieces))

    @property
    def box(self) -> Box:
        """The least box around it, as (left, top, right, bottom)."""
        xs, ys = zip(*(point for line in self.lines for point in line), strict=True)
        margin = self.pen.width / 2 if self.pen else 0.0
        return min(xs) - margin, min(ys) - margin, max(xs) + margin, max(ys) + margin


def overlap(p: Point, q: Point, box: Box) -> tuple[float, float] | None:
    """From where to where, between 0 and 1, a segment runs in a box; None if it does not enter."""
    low, high = 0.0, 1.0
    for start, end, least, most in zip(p, q, box[:2], box[2:], strict=True):
        if start != end:
            ends = sorted(((least - start) / (end - start), (most - start) / (end - start)))
            low, high = max(low, ends[0]), min(high, ends[1])
        elif not least < start < most:
            return None
    return (low, high) if low < high else None


def between(p: Point, q: Point, t: float) -> Point:
    """The point at a share t of the way from p to q."""
    return p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])


def _outside(p: Point, q: Point, box: Box) -> list[tuple[Point, Point]]:
    """The parts of a segment outside a box."""
    inside = overlap(p, q, box)
    if inside is None:
        return [(p, q)]
    low, high = inside
    return [(p, between(p, q, low))] * (low > 0) + [(between(p, q, high), q)] * (high < 1)


@dataclass(frozen=True)
class Disc:
    """A circle, perhaps filled."""

    centre: Point
    radius: float
    pen: Pen | None = None
    fill: str | None = None
    fill_opacity: float = 1.0

    def moved(self, dx: float, dy: float) -> Disc:
        """The same, moved."""
        return replace(self, centre=(self.centre[0] + dx, self.centre[1] + dy))

    @property
    def box(self) -> Box:
        """The least box around it."""
        (x, y), r = self.centre, self.radius + (self.pen.width / 2 if self.pen else 0.0)
        return x - r, y - r, x + r, y + r


@dataclass(frozen=True)
class Label:
    """A label at the middle, the start or the end of its base line."""

    at: Point
    text: str
    size: float = LABEL
    anchor: str = "middle"
    opacity: float = 1.0

    def moved(self, dx: float, dy: float) -> Label:
        """The same, moved."""
        return replace(self, at=(self.at[0] + dx, self.at[1] + dy))

    @property
    def box(self) -> Box:
        """A box that holds it, in a font of average width."""
        (x, y), w = self.at, width(runs(self.text), self.size)
        left = x - {"start": 0.0, "middle": w / 2, "end": w}[self.anchor]
        return left, y - 0.95 * self.size, left + w, y + 0.3 * self.size

    @property
    def core(self) -> Box:
        """The box of its letters, without what is above and below most of them."""
        left, _, right, _ = self.box
        return left - 1, self.at[1] - 0.7 * self.size, right + 1, self.at[1] + 0.2 * self.size


Shape = Path | Disc | Label


@dataclass
class Canvas:
    """Shapes in the order in which they are drawn; make them with the methods, then `fit` the canvas."""

    shapes: list[Shape] = field(default_factory=list)
    width: float = 0.0
    height: float = 0.0

    def lines(self, segments: Iterable[Sequence[Point]], pen: Pen = FINE) -> None:
        """Draw broken lines."""
        if parts := tuple(tuple(points) for points in segments):
            self.shapes.append(Path(parts, pen))

    def polygons(
        self, outlines: Iterable[Sequence[Point]], fill: str, opacity: float, pen: Pen | None = None
    ) -> None:
        """Fill polygons, and draw their outlines if a pen is given."""
        if parts := tuple(tuple(points) for points in outlines):
            self.shapes.append(Path(parts, pen, True, fill, opacity))

    def disc(
        self, at: Point, radius: float, fill: str | None = INK, pen: Pen | None = None, opacity: float = 1.0
    ) -> None:
        """Draw a disc, or a circle if nothing fills it."""
        self.shapes.append(Disc(at, radius, pen, fill, opacity))

    def arrow(self, start: Point, end: Point, pen: Pen) -> None:
        """Draw an arrow with a filled head."""
        length = math.dist(start, end)
        ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
        head = min(5.0 + 2.4 * pen.width, 0.6 * length)
        x, y, half = end[0] - head * ux, end[1] - head * uy, 0.38 * head
        neck = (end[0] - 0.8 * head * ux, end[1] - 0.8 * head * uy)
        self.lines([(start, neck)], pen)
        outline = (end, (x - half * uy, y + half * ux), (x + half * uy, y - half * ux))
        self.polygons([outline], pen.colour, pen.opacity)

    def label(
        self, at: Point, text: str, size: float = LABEL, anchor: str = "middle", opacity: float = 1.0
    ) -> None:
        """Set a label whose middle line, not its base line, runs through a point."""
        self.shapes.append(Label((at[0], at[1] + 0.34 * size), text, size, anchor, opacity))

    @property
    def box(self) -> Box:
        """The least box around all shapes."""
        lefts, tops, rights, bottoms = zip(*(shape.box for shape in self.shapes), strict=True)
        return min(lefts), min(tops), max(rights), max(bottoms)

    def fit(self, margin: float = 4.0, least_width: float = 0.0) -> Canvas:
        """Give the canvas its size, so that it just holds all shapes; cut faint lines under labels."""
        clear = [shape.core for shape in self.shapes if isinstance(shape, Label)]
        self.shapes = [
            shape.around(clear) if isinstance(shape, Path) and shape.pen == FAINT else shape
            for shape in self.shapes
        ]
        left, top, right, bottom = self.box
        self.width = float(math.ceil(max(right - left + 2 * margin, least_width)))
        self.height = float(math.ceil(bottom - top + 2 * margin))
        dx, dy = (self.width - left - right) / 2, margin - top
        self.shapes = [shape.moved(dx, dy) for shape in self.shapes]
        return self


def side_by_side(canvases: Sequence[Canvas], gap: float = 28.0) -> Canvas:
    """One canvas with several others in a row, from the left."""
    shapes: list[Shape] = []
    x = 0.0
    for canvas in canvases:
        shapes += [shape.moved(x, 0) for shape in canvas.shapes]
        x += canvas.width + gap
    return Canvas(shapes, x - gap, max(c.height for c in canvases))


def one_above_another(canvases: Sequence[Canvas], gap: float = 30.0) -> Canvas:
    """One canvas with several others in a column, from the top, their middles on one line."""
    shapes: list[Shape] = []
    breadth, y = max(c.width for c in canvases), 0.0
    for canvas in canvases:
        shapes += [shape.moved((breadth - canvas.width) / 2, y) for shape in canvas.shapes]
        y += canvas.height + gap
    return Canvas(shapes, breadth, y - gap)
