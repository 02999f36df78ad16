"""A plane triangulation whose neighbours are mirror images, but no hyperplane arrangement (Figure 3).

Each triangle of A~2 is cut from its centre into three triangles with angles 120°, 30°, 30°.

No other triangle will do. Go round a corner with angle α: the copies close up after n = 2π/α of
them, and reflecting an odd number of times must map the triangle to itself, so that its two other
angles are equal. Of the solutions of 1/a + 1/b + 1/c = 1/2, only (6, 6, 6), (4, 8, 8), (4, 6, 12) and
(3, 12, 12) obey this: the three Coxeter triangulations, and the one drawn here.

Reference: M. Kirby and R. Umble, "Edge tessellations and stamp folding puzzles", *Mathematics
Magazine* 84 (2011), 283-289.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations
from typing import NamedTuple

from ..affine import Vector, triangulation
from ..exact import Surd, show, sqrt
from ..simplex import Position, Simplex, position
from .canvas import GREEN, INK, VERMILLION, Canvas, Pen, between
from .figure import Figure
from .legends import area_key, legend, line_key
from .plane import Triangle, Window, frame, reflected, triangles_in

_SIZE = 336.0
_EDGES = Pen(INK, 1.1, opacity=0.55)
_FIRST, _CROSSED = (GREEN, 0.4, Pen(GREEN, 2.0)), (VERMILLION, 0.22, None)
_EDGE, _BEYOND = Pen(VERMILLION, 3.0), Pen(VERMILLION, 2.2, (2.0, 5.0))


class Witness(NamedTuple):
    """An edge whose line enters a triangle.

    Attributes
    ----------
    edge
        The edge; its second end is a corner of the triangle.
    triangle
        The triangle that the line enters.
    point
        A point of the line beyond the second end of the edge.
    barycentric
        Its barycentric coordinates in the triangle: all positive, so it lies inside.
    """

    edge: tuple[Vector, Vector]
    triangle: Triangle
    point: Vector
    barycentric: tuple[Fraction, ...]


class Monohedral(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    window
        The part of the plane that is drawn.
    triangles
        The triangles, each with its obtuse corner first; the first is highlighted.
    squared_edges
        Their squared edge lengths, the same for all.
    angles
        Their angles, as multiples of pi.
    neighbours
        The pairs of triangles, by number, that share an edge.
    mirror_images
        Those pairs that are mirror images of each other in the line of that edge.
    witness
        Why it is no hyperplane arrangement.
    """

    window: Window
    triangles: tuple[Triangle, ...]
    squared_edges: tuple[Fraction, ...]
    angles: tuple[Fraction, ...]
    neighbours: tuple[tuple[int, int], ...]
    mirror_images: tuple[tuple[int, int], ...]
    witness: Witness


def monohedral_not_coxeter() -> Figure[Monohedral]:
    """A triangulation by congruent triangles, neighbours being mirror images, that is not Coxeter.

    >>> data = monohedral_not_coxeter().data
    >>> data.neighbours == data.mirror_images, [str(x) for x in data.witness.barycentric]
    (True, ['1/2', '1/4', '1/4'])
    """
    data = _data()
    return Figure("A monohedral triangulation that is not Coxeter", _words(data), data, lambda: _draw(data))


def _data() -> Monohedral:
    t = triangulation("A~2")
    axes = frame(t.roots)
    zero, side = Fraction(0), Fraction(5, 4)
    origin = Window(axes, (zero, zero), (side, side), 1.0)
    centre = t.simplex.point([Fraction(1, 3)] * 3)
    window = Window(axes, origin.project(centre), (side, side), _SIZE / float(2 * side))
    triangles = tuple(piece for triangle, _ in triangles_in(window, t) for piece in _thirds(triangle))
    (edges,) = {_squared_edges(triangle) for triangle in triangles}  # one value: they are congruent
    by_edge: dict[frozenset[Vector], list[int]] = {}
    for i, triangle in enumerate(triangles):
        for pair in combinations(triangle, 2):
            by_edge.setdefault(frozenset(pair), []).append(i)
    neighbours = tuple(sorted((pair[0], pair[1]) for pair in by_edge.values() if len(pair) == 2))
    mirrors = tuple((i, j) for i, j in neighbours if _mirror_images(triangles[i], triangles[j]))
    angles = _angles(triangles[0])
    return Monohedral(window, triangles, edges, angles, neighbours, mirrors, _witness(triangles))


def _thirds(triangle: Triangle) -> list[Triangle]:
    """The triangles from the centre of a triangle to its edges."""
    a, b, c = triangle
    centre = tuple(sum(x, Fraction(0)) / 3 for x in zip(a, b, c, strict=True))
    return [(centre, p, q) for p, q in ((a, b), (b, c), (c, a))]


def _squared_edges(triangle: Triangle) -> tuple[Fraction, ...]:
    pairs = combinations(triangle, 2)
    return tuple(
        sorted(sum(((x - y) ** 2 for x, y in zip(p, q, strict=True)), Fraction(0)) for p, q in pairs)
    )


def _angles(triangle: Triangle) -> tuple[Fraction, ...]:
    """The angles at the three corners, as multiples of pi, read off their exact cosines."""
    known = {Surd(-1) / 2: Fraction(2, 3), sqrt(3) / 2: Fraction(1, 6)}
    simplex = Simplex(triangle)
    return tuple(known[simplex.dihedral_cosine(i, j)] for i, j in ((1, 2), (0, 2), (0, 1)))


def _mirror_images(first: Triangle, second: Triangle) -> bool:
    """Whether two triangles with a common edge are mirror images in its line."""
    (k,) = (k for k in range(3) if first[k] not in second)
    return set(reflected(first, k)) == set(second)


def _witness(triangles: tuple[Triangle, ...]) -> Witness:
    """The edge from the third corner to the centre, continued into the first triangle's neighbour."""
    centre, p, q = crossed = triangles[1]
    (start,) = set(triangles[0]) - set(crossed)
    point = tuple(c + (c - x) / 4 for c, x in zip(centre, start, strict=True))
    coordinates = Simplex([centre, p, q]).barycentric(point)
    if position(coordinates) is not Position.INSIDE:
        raise AssertionError(f"{show(point)} does not lie inside the triangle")
    return Witness((start, centre), crossed, point, coordinates)


def _words(data: Monohedral) -> str:
    angles = ", ".join(f"{180 * angle}°" for angle in data.angles)
    witness = data.witness
    return (
        "A monohedral triangulation that is not Coxeter: the triangles of A~2 are cut from their centres "
        f"into triangles with angles {angles} and squared edges {', '.join(map(str, data.squared_edges))}. "
        f"{len(data.mirror_images)} of {len(data.neighbours)} pairs of neighbours drawn are mirror images in "
        f"their common edge. But the line of the edge from {show(witness.edge[0])} to "
        f"{show(witness.edge[1])} goes on to {show(witness.point)}, inside a triangle, where its barycentric "
        f"coordinates are {show(witness.barycentric)}."
    )


def _draw(data: Monohedral) -> Canvas:
    canvas, window = Canvas(), data.window
    edges = sorted({tuple(sorted(pair)) for triangle in data.triangles for pair in combinations(triangle, 2)})
    pixels = [(window.pixel(p), window.pixel(q)) for p, q in edges]
    canvas.lines([part for p, q in pixels for part in window.visible(p, q)], _EDGES)
    canvas.polygons([[window.pixel(v) for v in data.triangles[0]]], *_FIRST)
    canvas.polygons([[window.pixel(v) for v in data.witness.triangle]], *_CROSSED)
    start, centre = (window.pixel(v) for v in data.witness.edge)
    canvas.lines([(start, centre)], _EDGE)
    canvas.lines([(centre, between(start, centre, 1.5))], _BEYOND)
    for point in (start, centre):
        canvas.disc(point, 3.4)
    keys = [
        area_key("one of the triangles", *_FIRST),
        line_key("one of the edges", _EDGE),
        line_key("its line", _BEYOND),
        area_key("the triangle that it enters", *_CROSSED),
    ]
    legend(canvas, keys, _SIZE)
    return canvas.fit()
