"""Space seen from afar: an exact orthographic view, in which spheres are circles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from math import atan2, cos, fsum, hypot, pi, sin
from operator import mul

from ..affine import Vector
from ..exact.surd import Exact
from .canvas import GREEN, Canvas, Pen, Point
from .plane import orthogonal, unit

_EDGE_ON = 1e-9
HIDDEN_EDGE, SEEN_EDGE = Pen(GREEN, 1.8, (5.0, 4.0)), Pen(GREEN, 2.6)


@dataclass(frozen=True)
class View:
    """A view of space, which may lie in a space of higher dimension.

    Attributes
    ----------
    frame
        Three orthonormal vectors: to the right, upwards, towards the viewer.
    centre
        The point in the middle.
    scale
        Pixels for one unit of length.
    """

    frame: tuple[tuple[Exact, ...], tuple[Exact, ...], tuple[Exact, ...]]
    centre: tuple[Exact, ...]
    scale: float

    @classmethod
    def along(cls, seeds: Sequence[Vector], centre: Sequence[Exact], scale: float) -> View:
        """The view whose frame comes from three independent vectors, made orthonormal in their order.

        >>> from fractions import Fraction
        >>> unit_vectors = [tuple(map(Fraction, v)) for v in ((2, 0, 0), (1, 3, 0), (0, 1, 1))]
        >>> [[float(x) for x in v] for v in View.along(unit_vectors, (0, 0, 0), 1.0).frame]
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        """
        right, up, towards = map(unit, orthogonal(seeds))
        return cls((right, up, towards), tuple(centre), scale)

    @cached_property
    def _decimals(self) -> tuple[list[float], ...]:
        return tuple([float(x) for x in vector] for vector in (*self.frame, self.centre))

    def place(self, x: Sequence[Exact | float]) -> tuple[float, float, float]:
        """Pixels to the right, downwards, and towards the viewer."""
        right, up, towards, centre = self._decimals
        offset = [float(a) - b for a, b in zip(x, centre, strict=True)]
        a, b, c = (self.scale * fsum(map(mul, v, offset)) for v in (right, up, towards))
        return a, -b, c

    def pixel(self, x: Sequence[Exact | float]) -> Point:
        """Where a point is drawn."""
        return self.place(x)[:2]

    def front_facets(self, corners: Sequence[Sequence[Exact]]) -> list[tuple[int, int, int]]:
        """The facets of a tetrahedron that face the viewer, as indices of its corners."""
        at = [self.place(corner) for corner in corners]
        found = []
        for i, j, k in combinations(range(4), 3):
            (opposite,) = {0, 1, 2, 3} - {i, j, k}
            a, b, c = ([x - y for x, y in zip(at[n], at[i], strict=True)] for n in (j, k, opposite))
            area = a[0] * b[1] - a[1] * b[0]
            normal = (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], area)
            inward = fsum(map(mul, normal, c))
            if abs(area) > _EDGE_ON and area * inward < 0:
                found.append((i, j, k))
        return found


def draw_tetrahedron(canvas: Canvas, view: View, corners: Sequence[Sequence[Exact]]) -> None:
    """Draw a tetrahedron, its hidden edges dashed."""
    front, at = view.front_facets(corners), [view.pixel(corner) for corner in corners]
    for count, facet in enumerate(front):
        canvas.polygons([[at[k] for k in facet]], GREEN, 0.24 + 0.13 * count)
    for seen, pen in ((False, HIDDEN_EDGE), (True, SEEN_EDGE)):
        edges = [
            pair for pair in combinations(range(4), 2) if any(set(pair) <= set(f) for f in front) is seen
        ]
        canvas.lines([[at[k] for k in pair] for pair in edges], pen)


def great_circle(
    view: View, radius: float, first: Sequence[Exact], second: Sequence[Exact]
) -> tuple[list[list[Point]], list[list[Point]]]:
    """A circle round the centre, in the plane of two orthogonal vectors: its front, and its back."""
    a, b = (
        [r - c for r, c in zip(view.place(v), view.place([0] * len(v)), strict=True)] for v in (first, second)
    )
    a, b = ([radius * x / hypot(*v) for x in v] for v in (a, b))
    turn = atan2(b[2], a[2])  # from here on a quarter turn on either side is in front
    halves: list[list[list[Point]]] = []
    for start in (turn - pi / 2, turn + pi / 2):
        angles = [start + pi * k / 48 for k in range(49)]
        halves.append([[(a[0] * cos(t) + b[0] * sin(t), a[1] * cos(t) + b[1] * sin(t)) for t in angles]])
    return halves[0], halves[1]
