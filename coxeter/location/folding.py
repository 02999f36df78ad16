"""Folding many points at once into the fundamental simplex: from a point to its simplex in three steps.

1. The coordinates y, in which the subgroup sorts (`subgroups`).
2. Rounding and sorting: into the fundamental simplex of the subgroup (`sorting`).
3. Reflections into one of the few simplices therein (`cells`); for the classical families there is but one.

One code for floats, with unit 1, and for exact integers, in which a unit is any multiple of 12: then the
coordinates of all images are integers too. What folds a point carries the fundamental simplex back onto the
simplex that holds the point.

Points on walls. For the classical families a point belongs to the simplex that holds x + (ε, ε², …) for all
small ε > 0, in the coordinates of the roots. For the others step 2 follows that rule in the coordinates y;
and of the simplices in step 3 a point on their walls belongs to the one that holds x + ε (c - x), where x is
the sorted point, and c the centre of the simplex that all are reflected into.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .cells import Cells
from .sorting import Sorting, sort_parts
from .subgroups import Ints, Subgroup

Points = NDArray[Any]


@dataclass(frozen=True)
class Folded:
    """Points of the subgroup's fundamental simplex as columns, how they came, and how they went on."""

    subgroup: Subgroup
    cells: Cells | None
    points: Points
    sorting: Sorting
    reflected: tuple[Points, Ints] | None

    def undo(self, points: Ints, barycentric: Ints, unit: int) -> Ints:
        """Carry points (j, m) of the fundamental simplex to the simplices that hold the n points: (n, j, m).

        All are integers, times the unit; barycentric coordinates (j, d + 1) are wanted too.
        """
        if self.points.dtype == object:
            points, barycentric = points.astype(object), barycentric.astype(object)
        images, chosen = points[None], None
        if self.cells is not None and self.reflected is not None:
            codes, chosen = np.unique(self.reflected[1], return_inverse=True)
            images = self.cells.images(codes, barycentric, unit)
        result = np.empty((self.points.shape[1], len(points), images.shape[2]), dtype=points.dtype)
        for j in range(len(points)):
            result[:, j] = self.sorting.undo(images[:, j], chosen, unit).T
        if self.cells is None:
            return result
        matrix, denominator = self.subgroup.outward
        return result @ matrix // denominator


def fold(subgroup: Subgroup, cells: Cells | None, y: Points, unit: Any) -> Folded:
    """Fold points, the columns of y (c, n), given in the coordinates of the subgroup times the unit."""
    x, sorting = sort_parts(subgroup, np.ascontiguousarray(y), unit)
    return Folded(subgroup, cells, x, sorting, None if cells is None else cells.fold(x, unit))
