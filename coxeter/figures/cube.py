"""The fundamental simplices of dimension 3 in a cube (paper, Figure 2, bottom)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, product
from typing import NamedTuple

from ..affine import triangulation
from ..errors import InvalidInput
from ..exact import RationalMatrix, Surd, sqrt
from .canvas import FINE, GREEN, INK, LABEL, SMALL, Canvas, Pen, Point
from .figure import Figure
from .placement import clear_place

Place = tuple[int, int, int]

KINDS = ("vertex", "midpoint of an edge", "centre of a face", "centre of the cube")
"""What a place with coordinates 0, 1, 2 is in the cube, by the number of its ones."""
_UNIT = 115.0
_DEPTH = (Fraction(2, 5), Fraction(7, 25))
"""How far right and up a unit of depth is drawn."""
_HIDDEN, _GUIDE = Pen(INK, 1.1, (4.0, 4.0), 0.5), Pen(INK, 1.0, (1.0, 3.5), 0.6)


class CubeSimplex(NamedTuple):
    """A simplex in a cube.

    Attributes
    ----------
    name
        The triangulation.
    places
        The vertices u_0 … u_3 in coordinates in which the cube is 0 <= x, y, z <= 2.
    kinds
        What each is in the cube, as an index of `KINDS`.
    edge
        The edge of the cube, in the scale of the triangulation.
    share
        The part of the cube's volume that the simplex fills.
    """

    name: str
    places: tuple[Place, ...]
    kinds: tuple[int, ...]
    edge: Surd
    share: Fraction


def cube_simplex(name: object) -> Figure[CubeSimplex]:
    """The fundamental simplex of a triangulation of space, in a cube, as at the bottom of Figure 2.

    The cube is found: the simplex is copied, as small as possible, to vertices, midpoints of edges and
    centres of faces of a cube, and its centre. Of all such copies one with the most different places,
    and of these with the most vertices of the cube, is drawn; the one that the projection shows best.

    Parameters
    ----------
    name
        ``"A~3"``, ``"B~3"`` or ``"C~3"``.

    Raises
    ------
    InvalidInput
        If the dimension is not 3.

    Examples
    --------
    >>> cube_simplex("C~3")
    Fundamental simplex of C~3 in a cube of edge 1: u_0 at a vertex, u_1 at the midpoint of an edge, \
u_2 at the centre of a face, u_3 at the centre of the cube. It fills 1/48 of the cube.
    """
    t = triangulation(getattr(name, "name", name))
    if t.dimension != 3:
        raise InvalidInput(f"{t.name} has dimension {t.dimension}: a cube holds simplices of dimension 3")
    squares = t.simplex.squared_edge_lengths
    copies = list(_copies(squares))
    least = min(_square(c[0], c[1]) for c in copies)
    places = max((c for c in copies if _square(c[0], c[1]) == least), key=_merit)
    edges = RationalMatrix.from_rows([[x - y for x, y in zip(p, places[0], strict=True)] for p in places[1:]])
    data = CubeSimplex(
        t.name,
        places,
        tuple(place.count(1) for place in places),
        2 * sqrt(squares[0, 1] / least),
        abs(edges.det()) / 48,
    )
    return Figure(f"Fundamental simplex of {t.name} in a cube", _words(data), data, lambda: _draw(data))


def _copies(squares: RationalMatrix) -> Iterator[tuple[Place, ...]]:
    """All similar copies of a simplex with vertices in {0, 1, 2}³, given its squared edges."""
    grid: list[Place] = list(product(range(3), range(3), range(3)))

    def extend(chosen: tuple[Place, ...]) -> Iterator[tuple[Place, ...]]:
        k = len(chosen)
        if k == 4:
            yield chosen
            return
        scale = _square(chosen[0], chosen[1]) / squares[0, 1]
        for place in grid:
            if all(_square(place, p) == scale * squares[i, k] for i, p in enumerate(chosen)):
                yield from extend((*chosen, place))

    for p, q in product(grid, repeat=2):
        if p != q:
            yield from extend((p, q))


def _square(p: Place, q: Place) -> Fraction:
    return Fraction(sum((x - y) ** 2 for x, y in zip(p, q, strict=True)))


# -- the projection -----------------------------------------------------------------------------------


def _flat(place: Place) -> tuple[Fraction, Fraction]:
    """The oblique projection: the second coordinate is depth."""
    x, y, z = place
    return x + _DEPTH[0] * y, z + _DEPTH[1] * y


def _area(a: Place, b: Place, c: Place) -> Fraction:
    """Twice the area of a projected triangle, with its sign."""
    (ax, ay), (bx, by), (cx, cy) = map(_flat, (a, b, c))
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


def _merit(places: tuple[Place, ...]) -> tuple[object, ...]:
    """How many kinds of places, how many vertices, the least area of a projected facet, how far in front."""
    kinds = [place.count(1) for place in places]
    least = min(abs(_area(*facet)) for facet in combinations(places, 3))
    return len(set(kinds)), kinds.count(0), least, -sum(y for _, y, _ in places), places


def _towards(normal: Place) -> Fraction:
    """The inner product with the direction to the viewer."""
    return normal[0] * _DEPTH[0] - normal[1] + normal[2] * _DEPTH[1]


def _front_facets(places: tuple[Place, ...]) -> list[tuple[int, int, int]]:
    """The facets of a simplex that face the viewer."""
    found = []
    for i, j, k in combinations(range(4), 3):
        (opposite,) = {0, 1, 2, 3} - {i, j, k}
        p = places[i]
        a, b, c = (tuple(x - y for x, y in zip(places[n], p, strict=True)) for n in (j, k, opposite))
        normal = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
        inward = sum(x * y for x, y in zip(normal, c, strict=True))
        if (_towards(normal) > 0) == (inward < 0) and _towards(normal):
            found.append((i, j, k))
    return found


# -- words and drawing ----------------------------------------------------------------------------------


def _words(data: CubeSimplex) -> str:
    where = ("a vertex", "the midpoint of an edge", "the centre of a face", "the centre of the cube")
    corners = ", ".join(f"u_{k} at {where[kind]}" for k, kind in enumerate(data.kinds))
    return (
        f"Fundamental simplex of {data.name} in a cube of edge {data.edge}: {corners}. "
        f"It fills {data.share} of the cube."
    )


def _pixel(place: Place) -> Point:
    x, y = _flat(place)
    return float(x) * _UNIT, -float(y) * _UNIT


def _draw(data: CubeSimplex) -> Canvas:
    canvas = Canvas()
    _draw_cube(canvas, data)
    front = _front_facets(data.places)
    at = [_pixel(place) for place in data.places]
    for i, facet in enumerate(front):
        canvas.polygons([[at[k] for k in facet]], GREEN, 0.3 + 0.16 * i)
    edges = {pair: any(set(pair) <= set(facet) for facet in front) for pair in combinations(range(4), 2)}
    canvas.lines([[at[k] for k in pair] for pair, seen in edges.items() if not seen], Pen(GREEN, 2.0, (5, 4)))
    canvas.lines([[at[k] for k in pair] for pair, seen in edges.items() if seen], Pen(GREEN, 2.6))
    middle = (sum(x for x, _ in at) / 4, sum(y for _, y in at) / 4)
    for k, point in enumerate(at):
        canvas.disc(point, 4.0)
        canvas.label(clear_place(canvas, point, middle, (20.0,)), f"$u_{{{k}}}$", LABEL)
    _caption(canvas, data)
    return canvas.fit()


def _draw_cube(canvas: Canvas, data: CubeSimplex) -> None:
    """The edges of the cube, those behind it dashed, and guides to where the vertices of the simplex lie."""
    corners: list[Place] = list(product((0, 2), (0, 2), (0, 2)))
    edges = [(p, q) for p, q in combinations(corners, 2) if _square(p, q) == 4]
    behind = (0, 2, 0)
    canvas.lines([_pixels(e) for e in edges if behind in e], _HIDDEN)
    canvas.lines([_pixels(e) for e in edges if behind not in e], FINE)
    guides = set()
    for place in data.places:
        if place.count(1) == 2:
            (axis,) = (i for i in range(3) if place[i] != 1)
            face = [p for p in corners if p[axis] == place[axis]]
            guides |= {pair for pair in combinations(face, 2) if _square(*pair) == 8}
    canvas.lines([_pixels(pair) for pair in sorted(guides)], _GUIDE)


def _pixels(pair: tuple[Place, Place]) -> tuple[Point, Point]:
    return _pixel(pair[0]), _pixel(pair[1])


def _caption(canvas: Canvas, data: CubeSimplex) -> None:
    left, _, right, bottom = canvas.box
    rows: dict[int, list[int]] = {}
    for k, kind in enumerate(data.kinds):
        rows.setdefault(kind, []).append(k)
    for i, (kind, ks) in enumerate(sorted(rows.items())):
        names = ", ".join(f"$u_{{{k}}}$" for k in ks)
        plural = {0: "vertices", 1: "midpoints of edges", 2: "centres of faces"}
        what = plural[kind] if len(ks) > 1 else KINDS[kind]
        canvas.label(((left + right) / 2, bottom + 20 + 22 * i), f"{names}: {what}", SMALL)
