"""Whether Numba is there, and how its code is called."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np

from .folding import ROUNDING

if TYPE_CHECKING:
    from .locating import Locator

kernels: Any
try:
    from . import kernels
except ImportError:  # no Numba: the same answers from NumPy alone
    kernels = None


def fold_compiled(locator: Locator, points: Any, lengths: Any) -> tuple[Any, Any, Any] | None:
    """Keys, barycentric coordinates and sizes of points, by the compiled code; None where there is none.

    Parameters
    ----------
    points
        In the coordinates of the roots; or, if lengths are given, points of R^d that Helmert's matrix carries
        there.
    lengths
        Those of the rows of Helmert's matrix, or None.
    """
    if kernels is None:
        return None
    n, m, d = len(points), len(locator.centre), locator.subgroup.triangulation.dimension
    points = np.ascontiguousarray(points)
    keys, shares, sizes = np.empty((n, m), np.int64), np.empty((n, d + 1)), np.empty(n)
    if locator.subgroup.classical:
        kind = "ABCD".index(locator.subgroup.kind)
        lengths = np.empty(0) if lengths is None else lengths
        kernels.locate_classical(points, kind, lengths, locator.key_unit, locator.centre, keys, shares, sizes)
    else:
        left = kernels.locate_by_mirrors(
            points, *_walls(locator), locator.key_unit, locator.centre, keys, shares, sizes, ROUNDING
        )
        if left:
            raise AssertionError(f"{left} points need more steps than there is room for")
    return keys, shares, sizes


@lru_cache(maxsize=8)
def _walls(locator: Locator) -> tuple[Any, ...]:
    """What `locate_by_mirrors` needs to know of the walls."""
    subgroup, triangulation = locator.subgroup, locator.subgroup.triangulation
    walls = [subgroup.wall(k) for k in range(triangulation.dimension + 1)]
    none = np.empty((0, subgroup.ambient), np.int64)
    weights, scale = (none, 1) if subgroup.whole else subgroup.weights
    return (
        "ABCD".index(subgroup.kind),
        np.array(subgroup.order),
        np.array([wall.normal for wall in walls]),
        np.array([wall.offset for wall in walls]),
        np.array([wall.factor.numerator for wall in walls]),
        np.array([wall.factor.denominator for wall in walls]),
        np.array(subgroup.walls),
        weights,
        scale,
        none if subgroup.whole else subgroup.doubled_coroots,
        np.array([m / wall.scale for m, wall in zip(triangulation.marks, walls, strict=True)]),
    )


def settle_compiled(shares: Any, sizes: Any, factor: float) -> Any:
    """As `locating.settle`, in place; returns what is open."""
    near = np.empty(len(shares), dtype=np.bool_)
    kernels.settle(shares, sizes, factor, near)
    return near
