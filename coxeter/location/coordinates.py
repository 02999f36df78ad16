"""Barycentric coordinates in the fundamental simplex, for many points at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .subgroups import Subgroup


def barycentric(subgroup: Subgroup, points: NDArray[Any], unit: Any) -> NDArray[Any]:
    """The barycentric coordinates of folded points (n, m), times the unit, shape (n, d + 1).

    Coordinate k is the level of wall k times the mark m_k. For the classical families the levels are, but at
    the ends of the diagram, differences of neighbouring coordinates.
    """
    letter, d = subgroup.triangulation.type.letter, subgroup.triangulation.dimension
    if letter not in "ABCD":
        marks = subgroup.triangulation.marks
        columns = [_exactly(subgroup, k, points, unit) * m for k, m in enumerate(marks)]
        return np.stack(columns, axis=1)
    result = np.empty((len(points), d + 1), dtype=points.dtype)
    steps = points[:, :-1] - points[:, 1:]
    if letter == "A":
        result[:, 0] = unit - (points[:, 0] - points[:, -1])
        result[:, 1:] = steps
    elif letter == "C":
        result[:, 0] = unit - 2 * points[:, 0]
        result[:, 1:-1] = 2 * steps
        result[:, -1] = 2 * points[:, -1]
    else:
        result[:, 0] = unit - (points[:, 0] + points[:, 1])
        result[:, 1] = steps[:, 0]
        result[:, 2:d] = 2 * steps[:, 1:]
        result[:, -1] = 2 * points[:, -1]
        if letter == "D":
            result[:, -2] = steps[:, -1]
            result[:, -1] = points[:, -2] + points[:, -1]
    return result


def _exactly(subgroup: Subgroup, k: int, points: NDArray[Any], unit: Any) -> NDArray[Any]:
    """The level of wall k; a wall with a normal of halves has twice the level."""
    wall = subgroup.wall(k)
    level = wall.level(points, unit)
    return level if wall.scale == 1 else (level / 2 if points.dtype.kind == "f" else level // 2)
