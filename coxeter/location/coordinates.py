"""Barycentric coordinates in the fundamental simplex, for many points at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .folding import Folded


def barycentric(folded: Folded, unit: Any) -> NDArray[Any]:
    """The barycentric coordinates of folded points, times the unit, shape (d + 1, n).

    Coordinate k is the level of wall k times the mark m_k. For the classical families the levels are, but at
    the ends of the diagram, differences of neighbouring coordinates.
    """
    x = folded.points
    if folded.cells is not None and folded.reflected is not None:
        return folded.cells.barycentric(folded.reflected[0])
    letter, d = folded.subgroup.parts[0].kind, folded.subgroup.triangulation.dimension
    result = np.empty((d + 1, x.shape[1]), dtype=x.dtype)
    steps = x[:-1] - x[1:]
    if letter == "A":
        result[0] = unit - (x[0] - x[-1])
        result[1:] = steps
    elif letter == "C":
        result[0] = unit - 2 * x[0]
        result[1:-1] = 2 * steps
        result[-1] = 2 * x[-1]
    else:
        result[0] = unit - (x[0] + x[1])
        result[1] = steps[0]
        result[2:d] = 2 * steps[1:]
        result[-1] = 2 * x[-1]
        if letter == "D":
            result[-2] = steps[-1]
            result[-1] = x[-2] + x[-1]
    return result
