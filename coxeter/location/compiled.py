"""Whether Numba is there, and how its code is called.

With ``NUMBA_DISABLE_JIT=1`` in the environment it is as if it were not there.
"""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from .cells import Cells
    from .locating import Found, Locator
    from .subgroups import Ints

kernels: Any
try:
    from . import kernels
except ImportError:  # Numba is not there, or turned off: the same answers from NumPy alone
    kernels = None

NO_LENGTHS = np.empty(0)


def locate_compiled(locator: Locator, points: Any, lengths: Any, factor: float, found: Found) -> Any:
    """Write what is found by the compiled code; returns the sizes of the points.

    Where there is no Numba it returns None.

    Parameters
    ----------
    points
        In the coordinates of the subgroup; or, if lengths are given, points of R^d that Helmert's matrix
        carries there.
    lengths
        Those of the rows of Helmert's matrix, or None.
    factor
        What times a size is too close to a wall to tell.
    found
        Where to write.
    """
    if kernels is None:
        return None
    sizes = np.empty(len(points))
    points = np.ascontiguousarray(points)
    out = factor, found.keys, found.barycentric, found.open, sizes
    if locator.cells is None:
        kind = "ABCD".index(locator.subgroup.parts[0].kind)
        given = NO_LENGTHS if lengths is None else lengths
        kernels.locate_classical(points, kind, given, locator.key_unit, locator.centre, *out)
    else:
        kernels.locate_in_cells(points, *_tables(locator), *out)
    return sizes


@lru_cache(maxsize=8)
def _tables(locator: Locator) -> tuple[Any, ...]:
    """What `locate_in_cells` needs to know."""
    subgroup, cells, unit = locator.subgroup, locator.cells, locator.key_unit
    assert cells is not None
    first, *others = cells.corners * cells.marks[:, None]
    matrix, below = subgroup.outward
    return (
        np.array([("ABCD".index(p.kind), p.start, p.columns.stop - p.start) for p in subgroup.parts]),
        _widened(cells.forms[:, :-1], cells.forms[:, -1]).astype(np.float64),
        cells.marks / cells.scale,
        *_steps(cells),
        _widened(np.transpose(others - first * cells.marks[1:, None]), first * unit) / cells.unit,
        _widened(matrix.T, np.zeros(matrix.shape[1], dtype=np.int64)),
        below,
        unit,
        unit / cells.marks.sum(),
    )


def _widened(matrix: Ints, constants: Ints) -> Ints:
    """Filled up with columns of zeros, and one of constants last."""
    missing = kernels.WIDTH - matrix.shape[1]
    return np.ascontiguousarray(np.column_stack([np.pad(matrix, [(0, 0), (0, missing)]), constants]))


def _steps(cells: Cells) -> tuple[NDArray[np.uint64], NDArray[np.float64]]:
    """Wall after wall to reflect in, with its up to three neighbours, and what their levels change by."""
    steps = np.zeros((len(cells.mirrors), 4), dtype=np.uint64)
    factors = np.zeros((len(cells.mirrors), 3))
    for s, k in enumerate(cells.mirrors):
        steps[s, 0] = k
        for n, j in enumerate(np.flatnonzero(cells.cartan[k] < 0)):
            steps[s, n + 1], factors[s, n] = j, -cells.cartan[k, j]
    return steps, factors
