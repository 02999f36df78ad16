"""From the fundamental simplex of the subgroup to one of the whole group's: a fixed sequence of reflections.

Walls cut it into few simplices, the cells, of which one is the goal. A point is reflected in a wall of the
goal if it lies beyond, wall after wall, in an order that leads there from everywhere: as a sorting network
compares pair after pair. All that changes are the levels of the wall and of its neighbours in the diagram,
by Cartan integers.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from ..affine import CoxeterTriangulation
from .sorting import Points, sort_parts
from .subgroups import Ints, Subgroup

ROUTES: dict[str, tuple[tuple[int, ...], tuple[int, ...]]] = {
    "E~8": (
        (1, 3, 4, 2, 5, 4, 3, 6, 5, 4, 7, 6, 5, 8, 7),
        (0, 2, 7, 5, 8, 6, 7, 4, 5, 6, 1, 3, 4, 5, 2, 4, 3, 1, 6),
    ),
    "E~7": ((1, 3, 4, 2, 5, 4, 6, 5, 7), (7, 0, 3, 5, 4, 2, 1, 3, 6, 5, 4, 3, 5, 1, 6)),
    "E~6": ((2, 4, 3, 1, 5, 6), (0, 1, 6, 4, 2, 3, 5, 4, 2, 3, 5)),
    "F~4": ((), (4, 3)),
    "G~2": ((1,), (1,)),
}
"""The walls to cross from the fundamental simplex to the goal, for E one in the middle; and those to reflect
in. They come from a search; that they lead there from every cell, and none is idle, is tested."""


@dataclass(frozen=True, eq=False)
class Cells:
    """The cell that is the goal, and the way there.

    Attributes
    ----------
    marks, cartan
        The marks of the triangulation, and its extended Cartan matrix.
    forms
        For each label k the level of wall k in the coordinates y, times `scale`: coefficients, and a constant
        last. Shape (d + 1, width + 1).
    corners
        The vertices by their labels, times `unit`; shape (d + 1, width).
    scale, unit
        What turns levels and vertices into integers.
    mirrors
        The walls to reflect in, one after the other.
    """

    marks: Ints
    cartan: Ints
    forms: Ints
    corners: Ints
    scale: int
    unit: int
    mirrors: tuple[int, ...]

    def fold(self, x: Points, unit: Any) -> tuple[Points, Ints]:
        """Reflect points (width, n) of the subgroup's simplex into the goal.

        Returns the levels (d + 1, n) times the unit and the scale, and for each point, bit by bit, in which
        of the walls it was reflected.
        """
        forms = self.forms.astype(x.dtype)
        levels: Points = np.repeat(forms[:, -1:] * unit, x.shape[1], axis=1)
        for column, row in zip(forms[:, :-1].T, x, strict=True):  # not by BLAS: always in this order
            levels += np.multiply.outer(column, row)
        codes = np.zeros(x.shape[1], dtype=np.int64)
        for step, k in enumerate(self.mirrors):
            codes += (levels[k] < 0).astype(np.int64) << step
            beyond = np.minimum(levels[k], 0)
            for j in np.flatnonzero(self.cartan[k]):
                levels[j] -= self.cartan[k, j] * beyond
        return levels, codes

    def barycentric(self, levels: Points) -> Points:
        """The barycentric coordinates of points with given levels, as `fold` returns them; times the unit."""
        marks = self.marks[:, None]
        return levels * (marks / self.scale) if levels.dtype.kind == "f" else levels * marks // self.scale

    def images(self, codes: Ints, barycentric: Ints, unit: int) -> Ints:
        """Points with given barycentric coordinates (j, d + 1), times the unit, carried back from the goal.

        For each of some codes; all are integers times the unit again, (codes, j, width).
        """
        corners = np.array([_corners_at(self, code) for code in codes.tolist()], dtype=np.int64)
        images: Ints = barycentric @ corners.reshape(-1, *self.corners.shape) // self.unit
        return images


@lru_cache(maxsize=1 << 10)
def _corners_at(cells: Cells, code: int) -> Ints:
    """The vertices of the cell from which a code leads to the goal: back from there, crossing its walls."""
    path = [k for step, k in enumerate(cells.mirrors) if code >> step & 1]
    return _across(cells.cartan, cells.marks, cells.corners, path)


def _across(cartan: Ints, marks: Ints, corners: Ints, path: Iterable[int]) -> Ints:
    """The vertices of the simplex that is reached by crossing wall after wall."""
    corners = corners.copy()
    for k in path:
        corners[k] -= cartan[k] * marks @ corners // marks[k]
    return corners


@lru_cache
def cells_of(subgroup: Subgroup) -> Cells:
    """The goal, reached from the fundamental simplex by crossing walls."""
    t = subgroup.triangulation
    marks, cartan = np.array(t.marks), extended_cartan_matrix(t)
    forms, scale = _forms(subgroup)
    corners, unit = _corners(subgroup)
    forms, corners = _into_simplex(subgroup, forms, corners, unit)
    path, mirrors = ROUTES[t.name]
    for k in path:
        forms = forms - np.multiply.outer(cartan[k], forms[k])
    return Cells(marks, cartan, forms, _across(cartan, marks, corners, path), scale, unit, mirrors)


def _forms(subgroup: Subgroup) -> tuple[Ints, int]:
    """The walls of the fundamental simplex in the coordinates y: integers, and what they are times."""
    facets, (outward, below) = subgroup.triangulation.facets, subgroup.outward
    normals = np.array([facet.normal for facet in facets], dtype=object)
    forms = np.column_stack([normals @ outward.T, [-facet.offset * below for facet in facets]]) * 2
    forms = forms.astype(np.int64)  # normals may have halves
    common = np.gcd.reduce(forms, axis=None)
    return forms // common, int(2 * below // common)


def _corners(subgroup: Subgroup) -> tuple[Ints, int]:
    """Its vertices in the coordinates y: integers, as their weighted mean is, and what they are times."""
    t, (inward, times) = subgroup.triangulation, subgroup.inward
    vertices, h = t.simplex.vertex_matrix, sum(t.marks)
    return vertices.numerators.astype(np.int64) @ inward * h, vertices.denominator * times * h


def extended_cartan_matrix(triangulation: CoxeterTriangulation) -> Ints:
    """2 <n_k, n_j> / <n_k, n_k> for the normals of the walls."""
    normals = np.array([facet.normal for facet in triangulation.facets], dtype=object)
    gram = normals @ normals.T
    matrix: Ints = (2 * gram / np.diag(gram)[:, None]).astype(np.int64)
    return matrix


def _into_simplex(subgroup: Subgroup, forms: Ints, corners: Ints, unit: int) -> tuple[Ints, Ints]:
    """Forms and corners, carried as sorting carries their centre into the subgroup's simplex."""
    marks = np.array(subgroup.triangulation.marks)
    _, how = sort_parts(subgroup, (marks @ corners // marks.sum())[:, None], unit)
    assert how.signs is not None
    places, shift, signs = (a[:, 0] for a in (how.places, how.shift, how.signs))
    back = np.argsort(places)
    constants = forms[:, -1] + forms[:, :-1] @ shift
    forms = np.column_stack([(forms[:, :-1] * signs)[:, back], constants])
    return forms, ((corners - shift * unit) * signs)[:, back]
