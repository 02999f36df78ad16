"""The key under a figure: samples with words, in as many rows as they need."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from .canvas import SMALL, Canvas, Pen, Point
from .labels import runs, width

_GAP, _ROW = 22.0, 24.0


class Key(NamedTuple):
    """A sample, drawn from a point to the right, its width, and what it means."""

    words: str
    sample: Callable[[Canvas, Point], None]
    width: float


def arrow_key(words: str, pen: Pen) -> Key:
    """A key for an arrow."""
    return Key(words, lambda canvas, at: canvas.arrow(at, (at[0] + 26, at[1]), pen), 26)


def line_key(words: str, pen: Pen) -> Key:
    """A key for a line."""
    return Key(words, lambda canvas, at: canvas.lines([(at, (at[0] + 26, at[1]))], pen), 26)


def area_key(words: str, fill: str, opacity: float, pen: Pen | None) -> Key:
    """A key for an area."""

    def sample(canvas: Canvas, at: Point) -> None:
        x, y = at
        canvas.polygons([[(x, y + 6), (x + 14, y + 6), (x + 14, y - 6), (x, y - 6)]], fill, opacity, pen)

    return Key(words, sample, 14)


def point_key(words: str, radius: float, fill: str | None, pen: Pen | None) -> Key:
    """A key for a point."""
    return Key(words, lambda canvas, at: canvas.disc((at[0] + 6, at[1]), radius, fill, pen), 12)


def legend(canvas: Canvas, keys: Sequence[Key], breadth: float) -> None:
    """Set keys below everything that is on a canvas, in rows of at most some breadth."""
    left, _, right, bottom = canvas.box
    rows: list[list[Key]] = []
    for key in keys:
        if rows and _breadth([*rows[-1], key]) <= breadth:
            rows[-1].append(key)
        else:
            rows.append([key])
    for i, row in enumerate(rows):
        x, y = (left + right - _breadth(row)) / 2, bottom + 22 + i * _ROW
        for key in row:
            key.sample(canvas, (x, y))
            canvas.label((x + key.width + 7, y), key.words, _size(key), "start")
            x += _breadth([key]) + _GAP


def _breadth(row: Sequence[Key]) -> float:
    return sum(key.width + 7 + width(runs(key.words), _size(key)) for key in row) + _GAP * (len(row) - 1)


def _size(key: Key) -> float:
    return SMALL + 3 if key.words.startswith("$") else SMALL
