"""Patches of a triangulation as meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..meshes import Mesh
from .interpolation import Vertices, vertices_of
from .regions import Search
from .rows import addends, codes, in_order, numbered
from .subgroups import Ints

if TYPE_CHECKING:
    from .grid import Grid


def patch_of(grid: Grid, keys: Ints, oriented: bool = False) -> Mesh:
    """The mesh of simplices given by their keys."""
    return _mesh(*vertices_of(grid, keys), oriented)


def patch_in(found: Search, oriented: bool = False) -> Mesh:
    """The mesh of the simplices that meet a region.

    In stars, the number of a vertex is that of vertex 0 plus one that belongs to the star. So vertices are
    told apart, exactly, without being looked at.
    """
    grid, few = found.grid, found.few()
    if few is not None:
        return patch_of(grid, few, oriented)
    lattice, vectors, simplices = found.stars()
    keys = found.keys_of(lattice, vectors, simplices)
    star, d = grid._star, grid.dimension
    numbers = addends(lattice[:, :d], star.points[:, :d])
    if numbers is None:
        return patch_of(grid, in_order(keys), oriented)
    order = np.argsort(codes(keys))
    vectors, simplices = vectors[order], simplices[order]
    own = np.ascontiguousarray(numbers[1][star.corners])  # by simplices, as they are picked
    different, cells = numbered(numbers[0][vectors, None] + own[simplices])
    owner = np.empty(len(different), dtype=np.int64)
    owner[cells] = np.arange(cells.size).reshape(cells.shape)
    cell, labels = np.divmod(owner, d + 1)
    points = lattice[vectors[cell]] + star.points[star.corners[simplices[cell], labels]]
    return _mesh(Vertices(grid, points, labels), cells, oriented)


def _mesh(vertices: Vertices, cells: Ints, oriented: bool) -> Mesh:
    points = vertices.positions
    if oriented:
        edges = points[cells[:, 1:]] - points[cells[:, :1]]
        turned = np.flatnonzero(np.linalg.det(edges) < 0)
        cells[turned, -2:] = cells[turned, :-3:-1]
    return Mesh(points, cells, {"label": vertices.labels})
