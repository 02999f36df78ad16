"""Locating points that are Dask arrays: block by block, where and when Dask likes.

Dask is not needed for anything else, and imported by whoever made such an array.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidInput

if TYPE_CHECKING:
    from .grid import Grid


def locate_lazily(grid: Grid, points: Any) -> tuple[Any, Any, Any]:
    """Keys, barycentric coordinates and what is open, as Dask arrays in blocks of the same rows.

    Raises
    ------
    InvalidInput
        If the shape is wrong; what is wrong with a number is told when its block is computed.
    """
    if points.ndim != 2 or points.shape[1] != grid.dimension or points.dtype.kind != "f":
        raise InvalidInput(
            f"a Dask array of {points.dtype}, shape {points.shape}: expected floats, (n, {grid.dimension})"
        )
    columns = len(grid._centre)
    record = np.dtype(
        [("keys", "i8", (columns,)), ("barycentric", "f8", (grid.dimension + 1,)), ("open", "?")]
    )
    rows = points.rechunk({1: -1})
    found = rows.map_blocks(_located, grid, record, dtype=record, drop_axis=1, meta=np.empty(0, record))
    return found["keys"], found["barycentric"], found["open"]


def _located(points: NDArray[Any], grid: Grid, record: np.dtype[Any]) -> NDArray[Any]:
    """One block: all three answers in one array, so that a point is located once."""
    found, rows = grid.locate(points), np.empty(len(points), record)
    rows["keys"], rows["barycentric"], rows["open"] = found.keys, found.barycentric, found.open
    return rows


def vertices_lazily(grid: Grid, keys: Any) -> Any:
    """The vertices of simplices whose keys are a Dask array."""
    size = (grid.dimension + 1, grid.dimension)
    return keys.map_blocks(
        grid.vertices, dtype=float, chunks=(keys.chunks[0], *((k,) for k in size)), new_axis=2,
        meta=np.empty((0, *size)),
    )  # fmt: skip
