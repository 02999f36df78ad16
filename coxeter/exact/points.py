"""Points with exact coordinates, rational or not, as users give them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..errors import CoxeterError, InvalidInput
from .matrices import RationalMatrix
from .rationals import rational
from .reading import surd
from .surd import Exact, Surd


def read_points(vertices: Sequence[Sequence[object]]) -> tuple[tuple[Exact, ...], ...]:
    """Read at least two points with equally many exact coordinates; errors name the vertex."""
    if not _is_list(vertices) or not all(_is_list(row) for row in vertices):
        raise InvalidInput("vertices are points: give a list of lists of coordinates")
    if len(vertices) < 2:
        raise InvalidInput(f"{len(vertices)} vertices make no simplex: give at least two points")
    n = len(vertices[0])
    for i, row in enumerate(vertices):
        if len(row) != n:
            raise InvalidInput(
                f"vertex {i} has {len(row)} coordinates and vertex 0 has {n}: "
                "give all points the same number of coordinates"
            )
    return tuple(tuple(_read(x, i, j) for j, x in enumerate(row)) for i, row in enumerate(vertices))


def _is_list(value: object) -> bool:
    if isinstance(value, np.ndarray):
        return value.ndim > 0
    return isinstance(value, Sequence) and not isinstance(value, str)


def _read(value: object, i: int, j: int) -> Exact:
    try:
        x = surd(value)
    except CoxeterError as error:
        raise type(error)(f"vertex {i}, coordinate {j}: {error}") from None
    return x.as_fraction() if x.is_rational else x


def gram_of_edges(points: tuple[tuple[Exact, ...], ...]) -> RationalMatrix:
    """The inner products of the edges from the first point, which must be rational."""
    edges = [[x - y for x, y in zip(p, points[0], strict=True)] for p in points[1:]]
    rows = [[sum((a * b for a, b in zip(e, f, strict=True)), Surd(0)) for f in edges] for e in edges]
    for i, row in enumerate(rows, 1):
        for j, product in enumerate(row, 1):
            if not surd(product).is_rational:
                raise InvalidInput(
                    f"the edges from vertex 0 to {i} and {j} have inner product {product}: "
                    "all squared edge lengths must be rational"
                )
    return RationalMatrix.from_rows([[rational(x) for x in row] for row in rows])
