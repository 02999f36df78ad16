"""The drawing that stands for a picture to turn: the simplex in its spheres, and a star moved apart."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations

from ..exact import Exact
from ..figures.canvas import (
    BLUE,
    GREEN,
    INK,
    LABEL,
    PURPLE,
    SMALL,
    VERMILLION,
    Canvas,
    Pen,
    Point,
)
from ..figures.placement import clear_place
from ..simplex import Position
from .scene import Scene
from .stars import Star

Place = tuple[float, float, float]

LABELS = (BLUE, VERMILLION, PURPLE, INK)
"""The colours of the vertices u_0 … u_3 and of their images; their signs are disc, square, diamond, cross."""
TONES = ("#5E9CCB", "#E0AA55")
"""The colours of the simplices that an even and an odd number of reflections make."""
APART = 0.45
"""How far the simplices of a star are moved apart, as a part of their distance from its centre."""
_SIZE = 330.0
_LIGHT = (-0.45, 0.65, 0.6)
"""Where the light comes from: to the right, upwards, towards the viewer."""
_ASLANT, _IN_FRONT = 0.1, 0.45
"""Enough of a sine between the mirrors and the line of sight, so that one looks along none; enough of a
cosine between the way to the simplex and the line of sight, so that nothing hides the simplex."""
_RIM = Pen("#1F2A33", 0.8)
_FACES = tuple(combinations(range(4), 3))


def floats(scene: Scene, vector: Sequence[Exact]) -> Place:
    """A point or vector in the picture, in decimals."""
    return _place(map(float, scene.place(vector)))


# -- from where it is seen --------------------------------------------------------------------------------


def direction(scene: Scene) -> Place:
    """The unit vector towards the viewer: from where what matters stands apart the most."""
    corners = [floats(scene, u) for u in scene.vertices]
    near = [floats(scene, apex.point) for apex in scene.apexes if apex.where is not Position.OUTSIDE]
    if scene.position is not Position.BOUNDARY:
        near.append(floats(scene, scene.circumcentre))
    aside = _unit(_minus(_mean(corners), floats(scene, scene.star.centre)))
    mirrors = [_unit(floats(scene, mirror.root)) for mirror in scene.star.mirrors]
    side = -1 if aside[2] < 0 else 1  # from below, if the simplex is below

    def merit(towards: Place) -> tuple[float, ...]:
        in_front = min(_dot(towards, aside), _IN_FRONT)
        aslant = min(abs(_dot(towards, normal)) for normal in mirrors)
        return (
            round(in_front, 9),
            round(min(aslant, _ASLANT), 9),
            round(_clearance(corners, near, towards), 9),
        )

    turns = [
        (math.cos(a) * math.cos(b), math.sin(a) * math.cos(b), math.sin(b))
        for a in (math.radians(5 + 10 * i) for i in range(36))
        for b in (math.radians(side * (14 + 5 * i)) for i in range(4))
    ]
    return max(turns, key=merit)


def _clearance(corners: Sequence[Place], others: Sequence[Place], towards: Place) -> float:
    """The least distance, as seen from there, of a point from another, or from an edge."""
    ends = [_flat(corner, towards) for corner in corners]
    points = ends + [_flat(point, towards) for point in others]
    apart = [math.dist(p, q) for p, q in combinations(points, 2)]
    edges = list(combinations(ends, 2))
    return min(apart + [_distance(p, *edge) for p in points for edge in edges if p not in edge])


def _distance(p: Point, a: Point, b: Point) -> float:
    """The distance of a point from a segment."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)
    t = min(max(t, 0.0), 1.0)
    return math.dist(p, (a[0] + t * dx, a[1] + t * dy))


def _flat(p: Place, towards: Place) -> Point:
    """The point on a sheet across the line of sight: to the right and upwards."""
    right, up = _axes(towards)
    return _dot(p, right), _dot(p, up)


def _axes(towards: Place) -> tuple[Place, Place]:
    """The unit vectors to the right and upwards on such a sheet."""
    x, y, z = towards
    r = math.hypot(x, y)
    return (-y / r, x / r, 0.0), (-x * z / r, -y * z / r, r)


def _dot(a: Place, b: Place) -> float:
    return math.fsum(x * y for x, y in zip(a, b, strict=True))


def _minus(a: Place, b: Place) -> Place:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _mean(points: Sequence[Place]) -> Place:
    return _place(math.fsum(column) / len(points) for column in zip(*points, strict=True))


def _place(coordinates: Iterable[float]) -> Place:
    x, y, z = coordinates
    return x, y, z


def _unit(a: Place) -> Place:
    length = math.hypot(*a)
    return a[0] / length, a[1] / length, a[2] / length


def _cross(a: Place, b: Place) -> Place:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


# -- the drawing ---------------------------------------------------------------------------------------------


def draw_simplex(scene: Scene) -> Canvas:
    """The fundamental simplex, its circumsphere, its insphere, and the apexes in the circumscribed ball."""
    canvas, towards = Canvas(), direction(scene)
    centre, radius = floats(scene, scene.circumcentre), float(scene.circumradius)
    scale = 0.47 * _SIZE / radius

    def pixel(p: Place) -> Point:
        x, y = _flat(_minus(p, centre), towards)
        return scale * x, -scale * y

    _sphere(canvas, pixel(centre), scale * radius, towards, Pen(BLUE, 1.8))
    corners = [floats(scene, u) for u in scene.vertices]
    hidden = _hidden_edges(corners, towards)
    shown = [face for face in _FACES if _dot(_outward(corners, face), towards) > 0]
    canvas.polygons([[pixel(corners[k]) for k in face] for face in shown], GREEN, 0.28)
    edges = list(combinations(range(4), 2))
    for seen, pen in ((False, Pen(GREEN, 1.8, (5.0, 4.0))), (True, Pen(GREEN, 2.6))):
        ends = [[pixel(corners[k]) for k in pair] for pair in edges if (pair not in hidden) is seen]
        canvas.lines(ends, pen)
    inside = pixel(floats(scene, scene.incentre))
    canvas.disc(inside, scale * float(scene.inradius), VERMILLION, Pen(VERMILLION, 1.2), 0.25)
    canvas.disc(inside, 2.6, VERMILLION)
    canvas.disc(pixel(centre), 5.0, None, Pen(BLUE, 2.2))
    near = [apex for apex in scene.apexes if apex.where is not Position.OUTSIDE]
    for apex in near:
        _sign(canvas, pixel(floats(scene, apex.point)), apex.label, 5.0)
        canvas.disc(pixel(floats(scene, apex.point)), 9.5, None, Pen(INK, 1.3))
    flat = [pixel(corner) for corner in corners]
    for k, at in enumerate(flat):
        _sign(canvas, at, k, 5.5)
    middle = (sum(x for x, _ in flat) / 4, sum(y for _, y in flat) / 4)
    for k, at in enumerate(flat):
        canvas.label(clear_place(canvas, at, middle, (19.0, 23.0)), f"$u_{{{k}}}$", LABEL)
    for apex in near:
        at, k = pixel(floats(scene, apex.point)), apex.label
        canvas.label(clear_place(canvas, at, middle, (30.0, 36.0)), f"$s_{{{k}}}(u_{{{k}}})$", SMALL + 1)
    return canvas.fit()


def _sphere(canvas: Canvas, centre: Point, radius: float, towards: Place, pen: Pen) -> None:
    """A sphere: its outline, and its equator, dashed where it lies behind."""
    canvas.disc(centre, radius, BLUE, pen, 0.06)
    low = radius * towards[2]
    for front in (True, False):
        turns = [math.pi * (i / 24 + (1 if front else 0)) for i in range(25)]
        line = [(centre[0] + radius * math.cos(t), centre[1] - low * math.sin(t)) for t in turns]
        canvas.lines([line], Pen(BLUE, 1.0, () if front else (4.0, 4.0), 0.75))


def _outward(corners: Sequence[Place], face: Sequence[int]) -> Place:
    """The outward unit normal of a face."""
    a, b, c = (corners[k] for k in face)
    normal = _unit(_cross(_minus(b, a), _minus(c, a)))
    inward = _dot(normal, _minus(_mean(corners), a)) > 0
    return (-normal[0], -normal[1], -normal[2]) if inward else normal


def _hidden_edges(corners: Sequence[Place], towards: Place) -> set[tuple[int, ...]]:
    """The edges both of whose faces are turned away."""
    away = [face for face in _FACES if _dot(_outward(corners, face), towards) <= 0]
    return {pair for pair in combinations(range(4), 2) if sum(set(pair) <= set(face) for face in away) == 2}


def draw_star(scene: Scene) -> Canvas:
    """The simplices around a vertex, moved apart; those in front hide those behind."""
    canvas, towards = Canvas(), direction(scene)
    centre = floats(scene, scene.star.centre)
    pieces = list(_pieces(scene, scene.star))
    reach = max(math.dist(corner, centre) for corners, _ in pieces for corner in corners)

    def pixel(p: Place) -> Point:
        x, y = _flat(_minus(p, centre), towards)
        return 0.5 * _SIZE / reach * x, -0.5 * _SIZE / reach * y

    columns = zip(*_axes(towards), towards, strict=True)
    light = _unit(_place(_dot(column, _LIGHT) for column in columns))
    for corners, tone in sorted(pieces, key=lambda piece: _dot(_mean(piece[0]), towards)):
        for face in _FACES:
            normal = _outward(corners, face)
            if _dot(normal, towards) > 0:
                canvas.polygons(
                    [[pixel(corners[k]) for k in face]], _lit(tone, _dot(normal, light)), 1.0, _RIM
                )
    return canvas.fit()


def _pieces(scene: Scene, star: Star) -> Iterator[tuple[list[Place], str]]:
    """The corners and the colour of each simplex, moved away from the centre."""
    centre = floats(scene, star.centre)
    for i, alcove in enumerate(star.alcoves):
        corners = [floats(scene, vertex) for vertex in alcove.vertices]
        shift = [APART * x for x in _minus(_mean(corners), centre)]
        moved = [(x + shift[0], y + shift[1], z + shift[2]) for x, y, z in corners]
        yield moved, GREEN if i == 0 else TONES[alcove.parity]


def _lit(tone: str, cosine: float) -> str:
    """A colour as a face shows it whose normal has that angle with the light."""
    light = 0.82 + 0.27 * cosine
    parts = [int(tone[i : i + 2], 16) for i in (1, 3, 5)]
    mixed = [part * light if light < 1 else part + (255 - part) * (light - 1) for part in parts]
    return "#" + "".join(f"{round(part):02X}" for part in mixed)


# -- the signs of the vertices ------------------------------------------------------------------------------


def _sign(canvas: Canvas, at: Point, label: int, r: float) -> None:
    """The sign of a vertex: a disc, a square, a diamond or a cross, by its label."""
    if label == 0:
        canvas.disc(at, r, LABELS[0])
    elif label == 3:
        ends = ((r, 0.0), (0.0, r))
        lines = [[(at[0] - dx, at[1] - dy), (at[0] + dx, at[1] + dy)] for dx, dy in ends]
        canvas.lines(lines, Pen(LABELS[3], 0.62 * r))
    else:
        corners = ((-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9))
        if label == 2:
            corners = ((0, -1.25), (1.25, 0), (0, 1.25), (-1.25, 0))
        outline = [(at[0] + r * dx, at[1] + r * dy) for dx, dy in corners]
        canvas.polygons([outline], LABELS[label], 1.0)
