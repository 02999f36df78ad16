"""The vertices in a region, straight from lattices.

Reflections in walls through the origin move the coweight m_k u_k by vectors of the coroot lattice L. So all
vertices with label k lie in u_k + L / m_k. Where the mark m_k is 1 there is nothing else in it; elsewhere
folding tells them from the rest.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .alcoves import LARGEST_ANSWER
from .bounds import HIGHEST
from .convex import Region, balls
from .coordinates import barycentric
from .feasible import Floats
from .rows import LOG, codes
from .subgroups import Ints

if TYPE_CHECKING:
    from .grid import Grid
    from .regions import Search

LARGEST_WORK = 2**30
"""So many points of lattices are looked at, at most."""
THINNEST = 2.0**-6
"""Regions are as thick as this, compared with the scale, while lattices are looked through."""
ROUNDING = 1 + 2.0**-10
"""And so much wider, for what rounding does."""
ORDERS = {"E~8": (1, 2, 3, 4, 5, 6, 7, 0), "F~4": (2, 1, 0, 3)}
"""In which Gram and Schmidt make axes of the simple roots, or nearly. For B~ to D~ the last comes first; the
others are as they stand, as `frames` has them."""
BLOCK = 1 << 14
"""So many points at a time are held in intermediate arrays."""


def vertices_in(search: Search) -> tuple[Ints, Ints]:
    """The vertices in a region, times the unit, in lexicographic order; and their labels."""
    grid, region, unit = search.grid, search.region, search.grid.vertex_unit
    marks, most = np.array(grid.triangulation.marks), LARGEST_ANSWER // (grid.dimension + 1)
    wide = region.enlarged(THINNEST * grid.frame.scale)
    scans = [(mark, Scan.of(search, shifts, basis, wide)) for mark, shifts, basis in cosets(grid)]
    search.check(sum(scan.work for _, scan in scans), LARGEST_WORK, "about {} vertices near it")
    found, labels, count = [grid._corners[:0]], [marks[:0]], 0
    for mark, scan in scans:
        for points in scan.points():
            points = points[region.distance(search.place(points)) == 0]
            shares = barycentric(grid._locator.fold(12 * points, 12 * unit), 12 * unit)
            label = shares.argmax(axis=0)
            chosen = (shares.max(axis=0) == 12 * unit) & (marks[label] == mark)
            found.append(points[chosen])
            labels.append(label[chosen])
            count += len(labels[-1])
            LOG.info("%d found so far", count)
            search.check(count, most, "at least {} vertices")
    points = np.concatenate(found)
    order = np.argsort(codes(points))
    return points[order] + search.origin[0], np.concatenate(labels)[order]


def cosets(grid: Grid) -> Iterator[tuple[int, Ints, Ints]]:
    """For each mark m the u_k with m_k = m that differ modulo L / m; and a basis of L / m. Times the unit."""
    roots, unit, marks = grid.triangulation.roots, grid.vertex_unit, np.array(grid.triangulation.marks)
    simple, coweights = roots.simple_roots, roots.fundamental_coweights
    squares = (simple.numerators**2).sum(axis=1)[:, None] // simple.denominator**2
    coroots = 2 * unit * simple.numerators.astype(np.int64) // (simple.denominator * squares)
    duals, times = squares * coweights.numerators.astype(np.int64), 2 * coweights.denominator
    if grid.frame.kind == "identity":
        coroots = coroots[list(ORDERS.get(grid.triangulation.name, range(len(coroots))[::-1]))]
    for mark in np.unique(marks).tolist():
        corners = grid._corners[marks == mark]
        coordinates = corners @ duals.T % (times * unit // mark)  # in the basis of coroots
        yield mark, corners[np.unique(codes(coordinates), return_index=True)[1]], coroots // mark


@dataclass(frozen=True, eq=False)
class Block:
    """Points of a lattice, times the unit, and what is known of them: all coefficients but the first few.

    Their coordinates are those of Gram and Schmidt, of which the last few are known; with the sums of their
    squares.
    """

    free: int
    points: Ints
    coordinates: Floats
    squares: Floats


@dataclass(frozen=True, eq=False)
class Scan:
    """A search for points of a lattice, moved by several shifts, in a region.

    All is stretched until the region has half edges 1; then come the coordinates of Gram and Schmidt, of
    which the last depends on the last coefficient only, the last but one on the last two, and so on. So one
    coefficient after the other is chosen, in all ways that leave the point in the region as far as is known
    (Fincke and Pohst, *Improved methods for calculating vectors of short length in a lattice*, 1985).

    Attributes
    ----------
    start
        The shifts.
    basis, triangle
        The basis as rows, times the unit; and in the coordinates of Gram and Schmidt, as columns.
    reach, radius
        How far the region goes along each coordinate; and the radius of a ball around it.
    """

    start: Block
    basis: Ints
    triangle: Floats
    reach: Floats
    radius: float

    @classmethod
    def of(cls, search: Search, shifts: Ints, basis: Ints, region: Region) -> Scan:
        """For shifts and a basis as rows, times the unit."""
        vectors = search.grid.frame.turned(basis / search.grid.vertex_unit)
        q, triangle = np.linalg.qr((vectors / region.half).T)
        start = Block(len(basis), shifts, search.place(shifts) / region.half @ q, np.zeros(len(shifts)))
        shape = region.stretched
        return cls(start, basis, triangle, ROUNDING * shape.reach(q.T), ROUNDING * shape.radius)

    @property
    def work(self) -> float:
        """About how many points it looks at: by the volume that it looks through, but for thin directions."""
        pivots = np.abs(np.diag(self.triangle))
        wide = 2 * self.reach > pivots
        ball = np.append(0.0, balls(len(pivots), self.radius))[wide.sum()]
        volume = min(np.log(2 * self.reach[wide]).sum(), ball) - np.log(pivots[wide]).sum()
        return len(self.start.points) * math.exp(min(volume, HIGHEST))

    def points(self) -> Iterator[Ints]:
        """Points that may lie in the region, times the unit: depth first, a block at a time."""
        levels = [iter([self.start])]
        while levels:
            block = next(levels[-1], None)
            if block is None:
                levels.pop()
            elif block.free:
                levels.append(self._chosen(block))
            else:
                yield block.points

    def _chosen(self, block: Block) -> Iterator[Block]:
        """One coefficient more, in all ways."""
        k = block.free - 1
        pivot, known = self.triangle[k, k], block.coordinates[:, k]
        room = np.minimum(self.reach[k], np.sqrt(np.maximum(self.radius**2 - block.squares, 0)))
        first = np.ceil(-known / pivot - room / abs(pivot)).astype(np.int64)
        last = np.floor(-known / pivot + room / abs(pivot)).astype(np.int64)
        ends = np.cumsum(np.maximum(last - first + 1, 0))
        for begin in range(0, int(ends[-1]), BLOCK):
            number = np.arange(begin, min(begin + BLOCK, int(ends[-1])))
            row = np.searchsorted(ends, number, side="right")
            coefficient = (last[row] + 1 - ends[row] + number)[:, None]
            coordinates = block.coordinates[row] + coefficient * self.triangle[:, k]
            yield Block(
                k,
                block.points[row] + coefficient * self.basis[k],
                coordinates,
                block.squares[row] + coordinates[:, k] ** 2,
            )
