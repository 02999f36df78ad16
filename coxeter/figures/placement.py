"""Where a label stands beside a point, so that nothing runs through it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

from .canvas import FAINT, Canvas, Disc, Label, Path, Point, between

_ENOUGH, _LARGE = 11.0, 12.0
_TURNS = [math.pi * k / 12 for k in (18, 6, 0, 12, *range(24))]  # first below, above, right and left


def clear_place(
    canvas: Canvas, point: Point, away_from: Point, distances: Sequence[float] = (18.0,), half: float = 9.0
) -> Point:
    """A place for a short label near a point, at a distance from all that is drawn but faint lines.

    Parameters
    ----------
    canvas
        What is drawn already, labels included.
    point
        The point.
    away_from
        Of places that are equally free, the farthest from here is taken.
    distances
        How far from the point to look. The first distance with enough room is taken.
    half
        Half the width of the label.
    """
    segments = list(_segments(canvas))

    def merit(place: Point) -> tuple[float, float]:
        letters = [(place[0] + dx, place[1]) for dx in (-half, 0, half)]
        room = min([_distance(x, p, q) for x in letters for p, q in segments] + [_ENOUGH])
        return round(room, 1), round(math.dist(place, away_from), 1)

    best = []
    for r in distances:
        places = [(point[0] + r * math.cos(turn), point[1] - r * math.sin(turn)) for turn in _TURNS]
        best.append(max(places, key=merit))
        if merit(best[-1])[0] >= _ENOUGH:
            return best[-1]
    return max(best, key=merit)


def _segments(canvas: Canvas) -> list[tuple[Point, Point]]:
    """All that a label should not touch, as segments."""
    found: list[tuple[Point, Point]] = []
    for shape in canvas.shapes:
        if isinstance(shape, Path) and shape.pen != FAINT:
            for line in shape.lines:
                closed = (*line, line[0]) if shape.closed else line
                found += pairwise(closed)
        elif isinstance(shape, Disc):
            found += _rim(shape)
        elif isinstance(shape, Label):
            left, top, right, bottom = shape.core
            found += [((left, y), (right, y)) for y in (top, bottom)]
    return found


def _rim(disc: Disc) -> list[tuple[Point, Point]]:
    """The rim of a circle, as segments; of a small disc its centre."""
    (x, y), r = disc.centre, disc.radius
    if r < _LARGE:
        return [(disc.centre, disc.centre)]
    turns = [math.pi * k / 32 for k in range(65)]
    return list(pairwise((x + r * math.cos(t), y + r * math.sin(t)) for t in turns))


def _distance(place: Point, p: Point, q: Point) -> float:
    """The distance of a place from a segment."""
    square = (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2
    if not square:
        return math.dist(place, p)
    t = ((place[0] - p[0]) * (q[0] - p[0]) + (place[1] - p[1]) * (q[1] - p[1])) / square
    return math.dist(place, between(p, q, min(max(t, 0.0), 1.0)))
