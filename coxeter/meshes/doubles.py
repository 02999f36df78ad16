"""Cells that name the same points as another, found with a key for each cell."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .mesh import Mesh

AT_ONCE = 1 << 23
"""About so many keys are held at a time; of a larger mesh, all cells are looked at several times."""


def doubled_cells(mesh: Mesh, chunk: int) -> NDArray[np.int64]:
    """The numbers of the cells that name the same points as one before them, in any order.

    >>> square = Mesh([[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 2], [1, 2, 3], [2, 0, 1]])
    >>> doubled_cells(square, 10).tolist()
    [2]
    """
    shares = len(mesh) // AT_ONCE + 1
    found = [_doubled(mesh, *_keyed(mesh, chunk, shares, share)) for share in range(shares)]
    return np.sort(np.concatenate(found))


def _doubled(mesh: Mesh, keys: NDArray[np.uint64], numbers: NDArray[np.int64]) -> NDArray[np.int64]:
    order = np.argsort(keys, kind="stable")
    ordered = keys[order]
    # Two that share a key may share their points.
    same = np.flatnonzero(ordered[1:] == ordered[:-1])
    cells = numbers[order[np.union1d(same, same + 1)]]
    _, first = np.unique(np.sort(mesh.cells[cells], axis=1), axis=0, return_index=True)
    return np.delete(cells, first)


def _keyed(mesh: Mesh, chunk: int, shares: int, share: int) -> tuple[NDArray[np.uint64], NDArray[np.int64]]:
    """The keys that leave a given remainder, and the numbers of their cells."""
    keys, numbers = [], []
    for i in range(0, max(len(mesh), 1), chunk):
        of_chunk = _keys(mesh.cells[i : i + chunk])
        ours = np.flatnonzero(of_chunk % np.uint64(shares) == share)
        keys.append(of_chunk[ours])
        numbers.append(ours + i)
    return np.concatenate(keys), np.concatenate(numbers)


def _keys(cells: NDArray[np.int64]) -> NDArray[np.uint64]:
    """A number for each cell, equal for those that name the same points: a sum over the points."""
    x = cells.astype(np.uint64) * np.uint64(0x9E3779B97F4A7C15)
    x = (x ^ (x >> np.uint64(29))) * np.uint64(0xBF58476D1CE4E5B9)
    keys: NDArray[np.uint64] = (x ^ (x >> np.uint64(32))).sum(axis=1, dtype=np.uint64)
    return keys
