"""A simplicial mesh: points, and cells that name them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidInput


class Mesh:
    """A mesh of d-simplices in R^m, with m at least d.

    Parameters
    ----------
    points
        Floats (n, m), a row for each point.
    cells
        Integers (k, d + 1): the rows of `points` at which a simplex has its vertices.
    point_data, cell_data
        Arrays of n, or of k, rows by name.

    Raises
    ------
    InvalidInput
        If a shape is wrong, a number is not finite, or a cell names no point.

    Examples
    --------
    >>> square = Mesh([[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 2], [1, 2, 3]])
    >>> square.corners.shape
    (2, 3, 2)
    """

    def __init__(
        self,
        points: ArrayLike,
        cells: ArrayLike,
        point_data: Mapping[str, ArrayLike] | None = None,
        cell_data: Mapping[str, ArrayLike] | None = None,
    ) -> None:
        self.points: NDArray[np.float64] = _real(points)
        self.cells: NDArray[np.int64] = _integers(cells)
        if self.points.ndim != 2:
            raise InvalidInput(f"points of shape {self.points.shape}: expected (n, m), a row for each point")
        if not _finite(self.points):
            row = int(np.flatnonzero(~np.isfinite(self.points).all(axis=1))[0])
            raise InvalidInput(f"point {row} is {self.points[row].tolist()}: all coordinates must be finite")
        if self.cells.ndim != 2 or not 2 <= self.cells.shape[1] <= self.points.shape[1] + 1:
            raise InvalidInput(
                f"cells of shape {self.cells.shape}: expected (k, d + 1), where d is at least 1 and at most "
                f"the points' {self.points.shape[-1]} coordinates"
            )
        if self.cells.size and not 0 <= self.cells.min() <= self.cells.max() < len(self.points):
            least, most, n = self.cells.min(), self.cells.max(), len(self.points)
            raise InvalidInput(f"the cells name points {least} to {most}: there are {n}, numbered from 0")
        self.point_data = _data(point_data, len(self.points), "point")
        self.cell_data = _data(cell_data, len(self.cells), "cell")

    def __repr__(self) -> str:
        n, m = self.points.shape
        cells = f"{len(self)} cell" + "s" * (len(self) != 1)
        return f"Mesh({n} points in R^{m}, {cells} of dimension {self.dimension})"

    def __len__(self) -> int:
        return len(self.cells)

    @property
    def dimension(self) -> int:
        """The dimension d of the cells."""
        return int(self.cells.shape[1]) - 1

    @property
    def corners(self) -> NDArray[np.float64]:
        """The vertices of the cells, shape (k, d + 1, m)."""
        corners: NDArray[np.float64] = self.points[self.cells]
        return corners


def _real(points: ArrayLike) -> NDArray[np.float64]:
    try:
        if np.iscomplexobj(points):
            raise TypeError("they are complex")
        return np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise InvalidInput(f"points must be rows of real numbers: {error}") from None


def _finite(points: NDArray[np.float64]) -> bool:
    """Whether all numbers are; without an array of flags as long as they are."""
    return bool(np.isfinite([points.min(initial=0), points.max(initial=0)]).all())


def _integers(cells: ArrayLike) -> NDArray[np.int64]:
    array = np.asarray(cells)
    if array.dtype.kind not in "iu" and array.size:
        raise InvalidInput(f"cells of type {array.dtype} were given: they name points by integers")
    return array.astype(np.int64, copy=False)


def _data(given: Mapping[str, ArrayLike] | None, n: int, what: str) -> dict[str, NDArray[Any]]:
    arrays = {name: np.asarray(values) for name, values in (given or {}).items()}
    for name, values in arrays.items():
        if values.shape[:1] != (n,):
            raise InvalidInput(f"{name!r} has shape {values.shape}: expected a row for each of {n} {what}s")
    return arrays
