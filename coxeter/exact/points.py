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
    rows = [
        list(v) if isinstance(v, (Sequence, np.ndarray)) and not isinstance(v, str) else v for v in vertices
    ]
    if any(not isinstance(row, list) for row in rows):
        raise InvalidInput("vertices are points: give a list of lists of coordinates")
    lengths = {len(row) for row in rows}
    if len(rows) < 2 or len(lengths) != 1:
        raise InvalidInput(
            f"{len(rows)} vertices with {sorted(lengths)} coordinates: "
            "give at least two points, all with the same number of coordinates"
        )
    return tuple(tuple(_read(x, i, j) for j, x in enumerate(row)) for i, row in enumerate(rows))


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
