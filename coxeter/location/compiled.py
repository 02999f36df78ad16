"""Whether Numba is there, and how its code is called."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from .cells import FINEST

if TYPE_CHECKING:
    from .locating import Found, Locator

kernels: Any
try:
    from . import kernels
except ImportError:  # no Numba: the same answers from NumPy alone
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
        kernels.locate_in_cells(points, *_tables(locator), locator.key_unit, FINEST, *out)
    return sizes


@lru_cache(maxsize=8)
def _tables(locator: Locator) -> tuple[Any, ...]:
    """What `locate_in_cells` needs to know."""
    subgroup, cells = locator.subgroup, locator.cells
    assert cells is not None
    parts = [("ABCD".index(p.kind), p.start, p.columns.stop - p.start) for p in subgroup.parts]
    forms = np.moveaxis(cells.forms * cells.marks[:, None], 1, 2)[:, :, 1:] / cells.scale
    (outward, below), wide = subgroup.outward, kernels.WIDTH
    missing = wide - subgroup.width
    forms = np.pad(forms, [(0, 0), (0, 0), (0, wide - forms.shape[2])])
    return (
        np.array(parts),
        np.insert(cells.walls.astype(np.float64), [subgroup.width] * missing, 0, axis=1),
        cells.children,
        cells.depth,
        np.insert(forms, [subgroup.width] * missing, 0, axis=1),
        cells.images(locator.shares_of_centre[None], locator.key_unit)[:, 0],
        np.pad(outward, [(0, wide - n) for n in outward.shape]),
        below,
    )
