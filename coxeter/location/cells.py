"""The simplices within the fundamental simplex of the subgroup, and a search tree over their walls.

No wall cuts a simplex, so it has each simplex on one side: a few sides decide which simplex holds a point.
The levels of the walls of a simplex are integer linear forms; those of its neighbours follow by Cartan
integers.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..affine import CoxeterTriangulation
from .sorting import Sorting, sort_parts
from .subgroups import Ints, Subgroup

FINEST = 2.0**46
"""A float is searched for at the nearest multiple of 1 / FINEST: then no sum of a level is rounded, and the
answer does not depend on its order."""


@dataclass(frozen=True, eq=False)
class Cells:
    """The cells, and how to find the one that holds a point.

    Attributes
    ----------
    marks
        The marks of the triangulation.
    forms
        For each cell and each label k the level of wall k in the coordinates y, times `scale`: coefficients,
        and a constant last. Shape (cells, d + 1, width + 1).
    corners
        The vertices of the cells by their labels, times `unit`; shape (cells, d + 1, width).
    scale, unit
        What turns levels and vertices into integers.
    walls
        A form for each node of the tree; the first nodes are the cells themselves, with forms that are zero.
    children
        Where to go from a node if the level is not negative, and if it is. From a cell to itself.
    depth
        So many steps lead from the last node, the root, to a cell.
    """

    marks: Ints
    forms: Ints
    corners: Ints
    scale: int
    unit: int
    walls: Ints
    children: Ints
    depth: int

    def find(self, y: NDArray[Any], unit: Any) -> Ints:
        """The cells that hold points (n, width); points on a wall count to its non-negative side."""
        if y.dtype.kind == "f":
            y, unit = np.rint(y * FINEST), FINEST
        node = np.full(len(y), len(self.walls) - 1)
        for _ in range(self.depth):
            wall = self.walls[node].astype(y.dtype)
            level = (y * wall[:, :-1]).sum(axis=1) + wall[:, -1] * unit
            node = self.children[node, (level < 0).astype(np.int64)]
        return node

    def barycentric(self, y: NDArray[Any], cells: Ints, unit: Any) -> NDArray[Any]:
        """The barycentric coordinates of points (n, width) in their cells, times the unit."""
        columns = []
        for k, mark in enumerate(self.marks):
            form = self.forms[cells, k].astype(y.dtype)
            level = ((y * form[:, :-1]).sum(axis=1) + form[:, -1] * unit) * mark
            columns.append(level / self.scale if y.dtype.kind == "f" else level // self.scale)
        return np.stack(columns, axis=1)

    def images(self, barycentric: Ints, unit: int) -> Ints:
        """Points with given barycentric coordinates (j, d + 1), times the unit, in each of the cells: all are
        integers times the unit again, (cells, j, width)."""
        images: Ints = barycentric @ self.corners // self.unit
        return images


@lru_cache
def cells_of(subgroup: Subgroup) -> Cells:
    """All cells, found by crossing walls as long as that stays within the subgroup's fundamental simplex."""
    marks = np.array(subgroup.triangulation.marks)
    cartan, forms, corners, scale, unit = _first(subgroup)

    def centres(corners: Ints) -> Ints:
        return np.asarray(marks @ corners // marks.sum())

    x, how = sort_parts(subgroup, centres(corners).T, unit)
    forms, corners = _carry(how, forms, corners, unit)
    found = {tuple(x[:, 0].tolist()): (forms[0], corners[0])}
    while len(corners):
        forms, corners = _cross(cartan, marks, forms, corners)
        keys, first = np.unique(centres(corners), axis=0, return_index=True)
        inside = (sort_parts(subgroup, keys.T, unit)[0] == keys.T).all(axis=0)
        fresh = inside & np.array([tuple(key) not in found for key in keys.tolist()])
        forms, corners = forms[first[fresh]], corners[first[fresh]]
        found |= dict(zip(map(tuple, keys[fresh].tolist()), zip(forms, corners, strict=True), strict=True))
    forms, corners = (np.array(x) for x in zip(*found.values(), strict=True))
    return Cells(marks, forms, corners, scale, unit, *_tree(forms, np.array(list(found)), unit))


def _first(subgroup: Subgroup) -> tuple[Ints, Ints, Ints, int, int]:
    """The extended Cartan matrix; forms and corners of the fundamental simplex, and what they are times."""
    t = subgroup.triangulation
    normals = np.array([facet.normal for facet in t.facets], dtype=object)
    outward, below = subgroup.outward
    forms = np.column_stack([normals @ outward.T, [-facet.offset * below for facet in t.facets]]) * 2
    forms = forms.astype(np.int64)  # normals may have halves
    common = np.gcd.reduce(forms, axis=None)
    inward, times = subgroup.inward
    vertices, h = t.simplex.vertex_matrix, sum(t.marks)
    corners = vertices.numerators.astype(np.int64) @ inward * h
    return (
        extended_cartan_matrix(t),
        forms[None] // common,
        corners[None],
        int(2 * below // common),
        vertices.denominator * times * h,
    )


def extended_cartan_matrix(triangulation: CoxeterTriangulation) -> Ints:
    """2 <n_k, n_j> / <n_k, n_k> for the normals of the walls."""
    normals = np.array([facet.normal for facet in triangulation.facets], dtype=object)
    gram = normals @ normals.T
    matrix: Ints = (2 * gram / np.diag(gram)[:, None]).astype(np.int64)
    return matrix


def _carry(how: Sorting, forms: Ints, corners: Ints, unit: int) -> tuple[Ints, Ints]:
    """Forms and corners of one simplex, carried as its centre was by sorting."""
    assert how.signs is not None
    places, shift, signs = (a[:, 0] for a in (how.places, how.shift, how.signs))
    back = np.argsort(places)
    constants = forms[..., -1] + forms[..., :-1] @ shift
    forms = np.concatenate([(forms[..., :-1] * signs)[..., back], constants[..., None]], axis=-1)
    return forms, ((corners - shift * unit) * signs)[..., back]


def _cross(cartan: Ints, marks: Ints, forms: Ints, corners: Ints) -> tuple[Ints, Ints]:
    """All neighbours of simplices: forms and corners, reflected in each wall in turn."""
    count = len(marks)
    forms_ = np.repeat(forms[:, None], count, axis=1)
    corners_ = np.repeat(corners[:, None], count, axis=1)
    for k in range(count):
        forms_[:, k] -= cartan[k][:, None] * forms[:, k][:, None]
        corners_[:, k, k] -= (cartan[k] * marks) @ corners // marks[k]
    return forms_.reshape(-1, *forms.shape[1:]), corners_.reshape(-1, *corners.shape[1:])


def _tree(forms: Ints, centres: Ints, unit: int) -> tuple[Ints, Ints, int]:
    """A search tree: at each node the wall that divides the cells that are left most evenly."""
    count, size = len(forms), forms.shape[2]
    walls = np.unique(forms.reshape(-1, size), axis=0)
    walls = walls[[row[np.flatnonzero(row)[0]] > 0 for row in walls]]  # of each and its negative, one
    beyond = centres @ walls[:, :-1].T + walls[:, -1] * unit < 0
    rows: list[Ints] = [np.zeros(size, dtype=np.int64)] * count
    children = [(k, k) for k in range(count)]

    def grow(left: Ints) -> tuple[int, int]:
        if len(left) == 1:
            return int(left[0]), 0
        side = beyond[left]
        best = int(np.abs(2 * side.sum(axis=0) - len(left)).argmin())
        kept, deep = grow(left[~side[:, best]])
        other, deeper = grow(left[side[:, best]])
        rows.append(walls[best])
        children.append((kept, other))
        return len(rows) - 1, 1 + max(deep, deeper)

    _, depth = grow(np.arange(count))
    return np.array(rows), np.array(children), depth
