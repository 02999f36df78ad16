"""Functions that are linear on each simplex: their values at points, and the adjoint, which is splatting.

Both are a sparse matrix with d + 1 entries in a row, the barycentric coordinates of a point: times the values
at the vertices, and transposed. So are the slicing and the splatting of the permutohedral lattice, which is
A~ (Adams, Baek and Davis, *Fast High-Dimensional Filtering Using the Permutohedral Lattice*, 2010).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.sparse import csr_array

from ..errors import InvalidInput
from ..meshes.judging import is_lazy
from .rows import distinct
from .subgroups import Ints

if TYPE_CHECKING:
    from .grid import Grid

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Vertices:
    """Vertices of a grid, each once.

    Attributes
    ----------
    grid
        Whose.
    keys
        For each a row of integers, equal exactly when the vertices are: in the coordinates of the roots,
        times `Grid.vertex_unit`. They are in lexicographic order.
    labels
        The labels, 0 to d.
    """

    grid: Grid
    keys: Ints
    labels: Ints

    def __len__(self) -> int:
        return len(self.keys)

    @cached_property
    def positions(self) -> Floats:
        """Where they lie, shape (n, d)."""
        points: Floats = (self.keys / self.grid.vertex_unit).astype(np.float64)
        return self.grid.frame.outward(points)


Function = Callable[[Floats], ArrayLike]


@dataclass(frozen=True, eq=False)
class Interpolation:
    """What n points make of values at vertices; `Grid.interpolation` gives one.

    Attributes
    ----------
    vertices
        Those of the simplices that hold the points.
    matrix
        Sparse, shape (points, vertices): the barycentric coordinates of a point are a row.
    """

    vertices: Vertices
    matrix: csr_array

    def of(self, f: Function | ArrayLike) -> Floats:
        """The values at the points of the function that is linear on each simplex, and f at the vertices.

        Parameters
        ----------
        f
            A function that takes the vertices' positions (v, d) to values (v,) or (v, c); or these values, in
            the order of `vertices`.

        Raises
        ------
        InvalidInput
            If there is not a value for each vertex.
        """
        values = f(self.vertices.positions.copy()) if callable(f) else f
        return np.asarray(self.matrix @ _rows(values, len(self.vertices), "vertices"))

    def splat(self, values: ArrayLike) -> Floats:
        """For each vertex the sum of the points' values (n,) or (n, c), times their barycentric coordinates.

        It is the adjoint of `of`: <of(f), values> = <f, splat(values)>.
        """
        return np.asarray(self.matrix.T @ _rows(values, self.matrix.shape[0], "points"))


def vertices_of(grid: Grid, keys: Ints) -> tuple[Vertices, Ints]:
    """The vertices of simplices, each once; and for each simplex the places of its own, by labels.

    The first d coordinates of a root's span fix the others.
    """
    rows, corners = distinct(grid.corners(keys), grid.dimension)
    labels = np.empty(len(rows), dtype=np.int64)
    labels[corners] = np.arange(grid.dimension + 1)
    return Vertices(grid, rows, labels), corners


def interpolation_at(grid: Grid, points: ArrayLike) -> Interpolation:
    """The vertices of the simplices that hold points, and their shares."""
    if is_lazy(points):
        raise InvalidInput("points are a Dask array: interpolate block by block, with its map_blocks")
    found = grid.locate(points)
    n, c = found.barycentric.shape
    keys, which = distinct(found.keys, grid.dimension)
    vertices, corners = vertices_of(grid, keys)
    shares = found.barycentric.astype(np.float64).reshape(-1)
    entries = (shares, corners[which].reshape(-1), np.arange(n + 1) * c)
    return Interpolation(vertices, csr_array(entries, shape=(n, len(vertices))))


def _rows(values: Any, n: int, what: str) -> Floats:
    try:
        if np.ma.is_masked(values) or np.iscomplexobj(values):
            raise TypeError
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InvalidInput(
            f"values must be real numbers without a mask, a row for each of {n} {what}"
        ) from None
    if array.ndim not in (1, 2) or len(array) != n:
        raise InvalidInput(f"values of shape {array.shape} were given: expected a row for each of {n} {what}")
    return array
