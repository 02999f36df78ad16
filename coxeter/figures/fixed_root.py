"""The witness against Proposition 1: a reflection that fixes a root of A3 (paper, Section 2.1)."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import combinations
from typing import NamedTuple

from ..affine import Vector, affine_reflection
from ..exact import show
from ..roots import root_system
from .canvas import BLUE, GREEN, INK, LABEL, VERMILLION, Canvas, Pen
from .figure import Figure
from .legends import area_key, arrow_key, legend, line_key
from .placement import clear_place
from .plane import squared_distance
from .space import View

_SCALE, _BREADTH = 84.0, 330.0
_SEEDS = ((4, -2, -1, -1), (-1, -5, 13, -7), (1, 5, -2, -4))
"""To the right, upwards, towards the viewer."""
_SOLID, _MIRROR = Pen(INK, 1.2, opacity=0.45), (BLUE, 0.16, Pen(BLUE, 1.6))
_ROOT, _FIXED, _REFLECTED = Pen(INK, 1.6), Pen(GREEN, 3.2), Pen(VERMILLION, 3.2)
_EXCHANGED = Pen(VERMILLION, 1.4, (4.0, 4.0))


class FixedRoot(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    name
        The root system.
    order
        How many elements its Weyl group has.
    roots
        All roots.
    edges
        The pairs of roots at the least distance: the edges of the polytope whose corners they are.
    mirror_root
        The root r in whose mirror, the plane at right angles to it, is reflected.
    fixed
        The roots that the reflection leaves where they are.
    exchanged
        The pairs of roots that it exchanges.
    """

    name: str
    order: int
    roots: tuple[Vector, ...]
    edges: tuple[tuple[Vector, Vector], ...]
    mirror_root: Vector
    fixed: tuple[Vector, ...]
    exchanged: tuple[tuple[Vector, Vector], ...]


def proposition_1_witness() -> Figure[FixedRoot]:
    """The roots of A3, the mirror of e_3 - e_4, and the two roots that lie in it.

    So the Weyl group does not act simply transitively on the roots: its identity is not the only
    element that fixes e_1 - e_2.

    >>> data = proposition_1_witness().data
    >>> len(data.roots), data.order, [[int(x) for x in root] for root in data.fixed]
    (12, 24, [[-1, 1, 0, 0], [1, -1, 0, 0]])
    """
    data = _data()
    return Figure("A reflection that fixes a root of A3", _words(data), data, lambda: _draw(data))


def _data() -> FixedRoot:
    system = root_system("A3")
    roots, mirror = sorted(system.roots.rows()), system.simple_roots.row(2)
    images = {r: affine_reflection(mirror, 0, r) for r in roots}
    least = min(squared_distance(p, q) for p, q in combinations(roots, 2))
    return FixedRoot(
        system.name,
        system.weyl_group_order,
        tuple(roots),
        tuple((p, q) for p, q in combinations(roots, 2) if squared_distance(p, q) == least),
        mirror,
        tuple(r for r in roots if images[r] == r),
        tuple((r, images[r]) for r in roots if r < images[r]),
    )


def _words(data: FixedRoot) -> str:
    fixed = " and ".join(map(show, data.fixed))
    return (
        f"The {len(data.roots)} roots of {data.name}, the corners of a polytope with {len(data.edges)} "
        f"edges, and the mirror at right angles to the root r = {show(data.mirror_root)}. The reflection "
        f"exchanges the ends of {len(data.exchanged)} dashed lines and fixes {fixed}, which lie in the "
        f"mirror. The Weyl group has {data.order} elements for {len(data.roots)} roots."
    )


def _draw(data: FixedRoot) -> Canvas:
    zero = tuple(Fraction(0) for _ in data.mirror_root)
    view = View.along([tuple(map(Fraction, seed)) for seed in _SEEDS], zero, _SCALE)
    canvas, pixel, origin = Canvas(), view.pixel, (0.0, 0.0)
    canvas.lines([(pixel(p), pixel(q)) for p, q in data.edges], _SOLID)
    canvas.polygons([_mirror(data, view)], *_MIRROR)
    canvas.lines([(pixel(p), pixel(q)) for p, q in data.exchanged], _EXCHANGED)
    for root in data.roots:
        pen = _FIXED if root in data.fixed else _REFLECTED if root == data.mirror_root else _ROOT
        canvas.arrow(origin, pixel(root), pen)
    canvas.disc(origin, 3.4)
    canvas.label(clear_place(canvas, pixel(data.mirror_root), origin, (16.0, 20.0)), "$r$", LABEL)
    keys = [
        arrow_key("$r$", _REFLECTED)._replace(words="the root $r$"),
        area_key("its mirror", *_MIRROR),
        arrow_key("fixed roots", _FIXED),
        line_key("exchanged roots", _EXCHANGED),
    ]
    legend(canvas, keys, _BREADTH)
    return canvas.fit()


def _mirror(data: FixedRoot, view: View) -> list[tuple[float, float]]:
    """A square in the mirror with the fixed roots on two of its sides."""
    along = data.fixed[-1]
    middles = [tuple((a + b) / 2 for a, b in zip(p, q, strict=True)) for p, q in data.exchanged]
    across = max(middles, key=lambda m: (squared_distance(m, tuple(Fraction(0) for _ in m)), m))
    scale = math.sqrt(2) / math.sqrt(float(sum(x * x for x in across)))
    corners = []
    for i, j in ((1, 1), (1, -1), (-1, -1), (-1, 1)):
        corners.append(
            [
                1.15 * (i * float(a) + j * scale * float(b)) / math.sqrt(2)
                for a, b in zip(along, across, strict=True)
            ]
        )
    return [view.pixel(corner) for corner in corners]
