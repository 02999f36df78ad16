"""The witness against Lemma 4: a Delaunay triangulation by halves of trapezoids (paper, Section 4)."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations, product
from typing import NamedTuple

from ..affine import Vector
from ..exact import rational, show, sqrt
from ..simplex import Position, Simplex, position
from .canvas import BLUE, GREEN, INK, LABEL, VERMILLION, Canvas, Pen
from .figure import Figure
from .legends import area_key, legend, point_key
from .placement import clear_place
from .plane import Window, squared_distance
from .written import words

TRAPEZOID = ((0, 0), (3, 0), (2, 2), (1, 2))
PERIOD = 4

_SIZE = 330.0
_SIDES, _DIAGONALS = Pen(INK, 1.3, opacity=0.7), Pen(INK, 1.1, (3.0, 4.0), 0.7)
_CIRCLE = Pen(BLUE, 2.4)
_WITH, _WITHOUT = (GREEN, 0.4, Pen(GREEN, 2.2)), (VERMILLION, 0.3, Pen(VERMILLION, 2.2))

Tile = tuple[Vector, Vector, Vector, Vector]


class Trapezoids(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    window
        The part of the plane that is drawn.
    tiles
        The trapezoids that reach into the window, the first first. A diagonal from the first to the
        third corner cuts each into two triangles.
    vertices
        Their corners, as far as in the window.
    centre, squared_radius
        Of the circle through the corners of the first.
    inside
        The vertices inside that circle: none.
    halves
        The two triangles of the first trapezoid, and where the centre lies relative to each.
    """

    window: Window
    tiles: tuple[Tile, ...]
    vertices: tuple[Vector, ...]
    centre: Vector
    squared_radius: Fraction
    inside: tuple[Vector, ...]
    halves: tuple[tuple[tuple[Vector, Vector, Vector], Position], ...]


def lemma_4_witness() -> Figure[Trapezoids]:
    """A Delaunay triangulation with equal circumradii, and a triangle in it that is not self-centred.

    The trapezoid (0, 0), (3, 0), (2, 2), (1, 2), turned by half-turns about its slanted sides and
    reflected in its parallel sides, tiles the plane.

    >>> data = lemma_4_witness().data
    >>> data.inside, [where.value for _, where in data.halves]
    ((), ['inside', 'outside'])
    """
    data = _data()
    return Figure("A Delaunay triangulation against Lemma 4", _words(data), data, lambda: _draw(data))


def _data() -> Trapezoids:
    first, *others = _of_a_period()
    a, b, c, d = first
    halves = tuple(
        (half, position(Simplex(half).circumcentre_coordinates)) for half in ((a, b, c), (a, c, d))
    )
    simplex = Simplex((a, b, c))
    centre = tuple(rational(x) for x in simplex.circumcentre)
    side, zero, one = Fraction(29, 10), Fraction(0), Fraction(1)
    middle = (centre[0], centre[1])
    window = Window(((one, zero), (zero, one)), middle, (side, side), _SIZE / float(2 * side))
    shifts = [(PERIOD * i, PERIOD * j) for i, j in product(range(-2, 3), repeat=2)]
    copies = [_moved(tile, shift) for tile in (first, *others) for shift in shifts]
    tiles = (first, *(tile for tile in copies if tile != first and _reaches(window, tile)))
    vertices = sorted({v for tile in tiles for v in tile if window.contains(v)})
    inside = tuple(v for v in vertices if squared_distance(v, centre) < simplex.squared_circumradius)
    return Trapezoids(window, tiles, tuple(vertices), centre, simplex.squared_circumradius, inside, halves)


def _of_a_period() -> list[Tile]:
    """The trapezoid, its image under a half-turn, and the mirror images of both."""
    turned = tuple((5 - x, 2 - y) for x, y in TRAPEZOID)
    mirrored = [tuple((x, PERIOD - y) for x, y in tile) for tile in (TRAPEZOID, turned)]
    return [_tile(tile) for tile in (TRAPEZOID, turned, *mirrored)]


def _tile(corners: tuple[tuple[int, int], ...]) -> Tile:
    a, b, c, d = ((Fraction(x), Fraction(y)) for x, y in corners)
    return a, b, c, d


def _moved(tile: Tile, shift: tuple[int, int]) -> Tile:
    a, b, c, d = ((x + shift[0], y + shift[1]) for x, y in tile)
    return a, b, c, d


def _reaches(window: Window, tile: Tile) -> bool:
    return len(window.clip([window.pixel(v) for v in tile])) > 2


def _words(data: Trapezoids) -> str:
    good, bad = (", ".join(map(show, half)) for half, _ in data.halves)
    return (
        f"A tiling of the plane by {len(data.tiles)} trapezoids as far as the window shows it, each cut "
        f"along a diagonal. The corners {', '.join(map(show, data.tiles[0]))} of one lie on a circle with "
        f"centre c = {show(data.centre)} and radius {words(sqrt(data.squared_radius))}, and "
        f"{len(data.inside) or 'no'} vertices inside it. The half {good} contains c; the other half, {bad}, "
        "does not. All circles have the same radius, so it is a Delaunay triangulation, and a triangle "
        "with the largest circumradius is not self-centred."
    )


def _draw(data: Trapezoids) -> Canvas:
    canvas, window = Canvas(), data.window
    for (half, where), look in zip(data.halves, (_WITH, _WITHOUT), strict=True):
        assert (where is Position.OUTSIDE) == (look is _WITHOUT)
        canvas.polygons([[window.pixel(v) for v in half]], *look)
    sides = sorted({tuple(sorted(pair)) for tile in data.tiles for pair in combinations(tile, 2)})
    diagonals = {tuple(sorted((tile[0], tile[2]))) for tile in data.tiles}
    crossed = {tuple(sorted((tile[1], tile[3]))) for tile in data.tiles}
    for pen, some in (
        (_SIDES, [s for s in sides if s not in diagonals | crossed]),
        (_DIAGONALS, sorted(diagonals)),
    ):
        pixels = [(window.pixel(p), window.pixel(q)) for p, q in some]
        canvas.lines([part for p, q in pixels for part in window.visible(p, q)], pen)
    centre = window.pixel(data.centre)
    canvas.disc(centre, window.scale * float(sqrt(data.squared_radius)), None, _CIRCLE)
    for vertex in data.vertices:
        canvas.disc(window.pixel(vertex), 4.6 if vertex in data.tiles[0] else 3.0)
    canvas.disc(centre, 5.0, None, _CIRCLE)
    canvas.label(clear_place(canvas, centre, window.pixel(data.tiles[0][1]), (16.0, 20.0)), "$c$", LABEL)
    keys = [
        point_key("empty circle through four vertices", 5.0, None, _CIRCLE),
        area_key("contains $c$", *_WITH),
        area_key("does not contain $c$", *_WITHOUT),
    ]
    legend(canvas, keys, _SIZE)
    return canvas.fit()
