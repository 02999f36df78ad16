"""The small marks of a geometer: right angles, arcs, distances; all in pixels."""

from __future__ import annotations

import math

from .canvas import FINE, Canvas, Pen, Point, between


def sheet(scale: float, x: float, y: float) -> Point:
    """The pixel of a point of the plane, at a scale."""
    return scale * x, -scale * y


def toward(p: Point, q: Point, distance: float) -> Point:
    """The point at a distance from p in the direction of q."""
    return between(p, q, distance / math.dist(p, q))


def right_angle(canvas: Canvas, corner: Point, p: Point, q: Point, size: float = 9.0) -> None:
    """Mark the right angle at a corner between the directions of p and q."""
    (x, y), a, b = corner, toward(corner, p, size), toward(corner, q, size)
    canvas.lines([(a, (a[0] + b[0] - x, a[1] + b[1] - y), b)], FINE)


def arc(centre: Point, radius: float, start: Point, end: Point) -> list[Point]:
    """The arc of a circle from the direction of one point to that of another, the shorter way."""
    first, last = (math.atan2(p[1] - centre[1], p[0] - centre[0]) for p in (start, end))
    turn = (last - first + math.pi) % (2 * math.pi) - math.pi
    return turned(centre, radius, first, turn)


def turned(centre: Point, radius: float, first: float, turn: float) -> list[Point]:
    """The arc of a circle that begins at an angle and goes on by another, clockwise on the screen."""
    steps = max(2, math.ceil(abs(turn) * radius / 4))
    angles = [first + turn * k / steps for k in range(steps + 1)]
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in angles]


def extent(canvas: Canvas, p: Point, q: Point, pen: Pen = FINE, tick: float = 5.0) -> None:
    """A line from p to q with a bar across at each end: a distance."""
    length = math.dist(p, q)
    x, y = tick * (q[1] - p[1]) / length, -tick * (q[0] - p[0]) / length
    bars = [((a - x, b - y), (a + x, b + y)) for a, b in (p, q)]
    canvas.lines([(p, q), *bars], pen)


def cross(canvas: Canvas, at: Point, size: float, pen: Pen) -> None:
    """A cross: here is no point of what is drawn."""
    (x, y), r = at, size
    canvas.lines([((x - r, y - r), (x + r, y + r)), ((x - r, y + r), (x + r, y - r))], pen)
