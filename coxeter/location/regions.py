"""What lies in a box or a ball: simplices and vertices.

Why spreading from neighbour to neighbour finds all simplices that meet a compact convex set K. Take two of
them, a point of each in K, and next to these, at most ε away, points inside the two simplices such that the
segment between misses all faces of codimension 2. It runs from neighbour to neighbour, and crosses each facet
at most ε away from K. There are finitely many facets near K, so those that come that near for all ε > 0 meet
K. Each simplex on the way has such a facet, or is one of the two: it meets K.

A larger patch is made of *stars*. Vertex 0 of each simplex is a vector of the coroot lattice L; the simplices
round a vector are those round 0, one for each element of the Weyl group, moved by it. Neighbours have the
same vertex 0, or across facet 0 one that differs by an image of the coroot of the highest root. By what was
shown, steps by these lead to all vectors that are vertex 0 of a simplex that meets K, also if only such
vectors may be entered as are no farther from K than the longest edge at vertex 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from .alcoves import LARGEST_ANSWER, check_count
from .convex import SLACK, Region, balls, meets
from .feasible import Flags, Floats
from .rows import codes, distinct, flood, in_order
from .subgroups import Ints

if TYPE_CHECKING:
    from .grid import Grid

LARGEST_STAR = 60_000
"""Stars of more simplices are not made: then neighbours lead to neighbours, however many there are."""
BLOCK = 1 << 18
"""So many simplices at a time are held in intermediate arrays."""


@dataclass(frozen=True, eq=False)
class Star:
    """The simplices round the origin, and what they share.

    Attributes
    ----------
    keys
        Those of the n simplices.
    points, corners
        Their vertices, each once, times the unit; and which of them a simplex has, shape (n, d + 1).
    normals, sides
        The gradients of their barycentric coordinates in R^d, each once; and which a simplex has.
    """

    keys: Ints
    points: Ints
    corners: Ints
    normals: Floats
    sides: Ints


def star_of(grid: Grid) -> Star:
    """The simplices round the origin."""
    keys = orbit(grid, grid._centre, grid.key_unit)
    points, corners = distinct(grid.corners(keys))
    gram = grid.triangulation._gradient_gram
    gradients, sides = distinct(gram.numerators @ points[corners])
    normals = grid.frame.turned(gradients / (gram.denominator * grid.vertex_unit)) / grid.frame.scale**2
    return Star(keys, points, corners, normals, sides)


def gradients_of(grid: Grid, corners: Floats) -> Floats:
    """The gradients (n, d + 1, d) of the barycentric coordinates of simplices given by their corners.

    As the sum of gradient_k ⊗ corner_k is the identity, gradient_j is that of <gradient_j, gradient_k>
    corner_k.
    """
    gram = grid.triangulation._gradient_gram
    matrix = (gram.numerators / gram.denominator).astype(np.float64) / grid.frame.scale**2
    return np.asarray(matrix @ (corners - corners[:, :1]))


def classes_of(grid: Grid) -> list[Ints]:
    """For each label its vertices, times the unit, up to the coroot lattice: images under the Weyl group."""
    t, unit = grid.triangulation, grid.vertex_unit
    simple, coweights = t.roots.simple_roots, t.roots.fundamental_coweights
    squares = (simple.numerators**2).sum(axis=1) // simple.denominator**2
    weights = coweights.numerators * squares[:, None]

    def coordinates(rows: Ints) -> Ints:
        """In the basis of simple coroots, modulo 1."""
        return np.asarray(rows @ weights.T % (2 * coweights.denominator * unit))

    return [orbit(grid, row, unit, coordinates) for row in grid._corners]


def orbit(grid: Grid, row: Ints, unit: int, same: Callable[[Ints], Ints] | None = None) -> Ints:
    """The images of a row under the Weyl group; of those that are the same, one."""
    walls = [grid._subgroup.wall(k) for k in range(1, grid.dimension + 1)]

    def mirrored(rows: Ints) -> Ints:
        return np.concatenate([wall.reflect(rows, unit) for wall in walls])

    found = flood(row[None], mirrored, same=same)
    assert found is not None
    return found


# -- searching ----------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Search:
    """A grid, and a region in it that is enlarged by what rounding needs."""

    grid: Grid
    region: Region

    def keys(self) -> Ints:
        """The keys of the simplices that meet the region, in lexicographic order."""
        found = self.few()
        if found is None:
            found = self.keys_of(*self.stars())
        return in_order(found)

    def few(self) -> Ints | None:
        """The same in any order, from neighbour to neighbour; None if stars are better."""
        grid, order = self.grid, self.grid.triangulation.roots.weyl_group_order
        check_count(self.at_least(), grid.dimension)
        if order <= LARGEST_STAR:
            return flood(self._middle, self._around, self._meets, limit=order)
        inside = self.region.distance(self._place(grid.corners(self._middle)[0])) == 0
        check_count(max(map(grid.meeting_at, np.flatnonzero(inside).tolist()), default=1), grid.dimension)
        limit = LARGEST_ANSWER // (grid.dimension + 1)
        found = flood(self._middle, self._around, self._meets, limit=limit)
        if found is None:
            check_count(limit + 1, grid.dimension)
        return found

    def at_least(self) -> float:
        """A lower bound for the number of simplices that meet the region.

        A flat piece of dimension k has at most the volume of a k-ball in common with a simplex whose diameter
        is the longest edge, as that is the diameter of the simplex (isodiametric inequality).
        """
        simplex, scale, d = self.grid.triangulation.simplex, self.grid.frame.scale, self.grid.dimension
        largest = balls(d, scale * float(simplex.longest_edge) / 2)
        if volume := float(simplex.volume):  # else it is too small for a float
            largest[-1] = math.log(volume) + d * math.log(scale)
        return math.exp(min((self.region.sections - largest).max(), 690))

    def stars(self) -> tuple[Ints, Ints, Ints]:
        """Vectors of L, and of each simplex that meets the region the number of its vertex 0 and its own."""
        lattice = self.lattice()
        vectors, simplices = zip(*self._blocks(lattice), strict=True)
        return lattice, np.concatenate(vectors), np.concatenate(simplices)

    def keys_of(self, lattice: Ints, vectors: Ints, simplices: Ints) -> Ints:
        """The keys of what `stars` gives."""
        moved = lattice * self.grid.key_unit // self.grid.vertex_unit
        return np.asarray(self.grid._star.keys[simplices] + moved[vectors])

    def lattice(self) -> Ints:
        """Vectors of L, times the unit: all that are vertex 0 of a simplex meeting the region, and more."""
        grid, unit = self.grid, self.grid.vertex_unit
        order = min(grid.triangulation.roots.weyl_group_order, 10**300)
        check_count(self.at_least() / order, grid.dimension, "vertices")  # each is vertex 0 of so many
        steps = orbit(grid, grid._subgroup.wall(0).reflect(0 * grid._centre, unit), unit)
        edges = np.linalg.norm(grid.frame.turned(grid._corners / unit), axis=1)
        wider = self.region.enlarged(float(edges.max()))

        def around(rows: Ints) -> Ints:
            return np.concatenate([rows + step for step in steps])

        def near(rows: Ints) -> Flags:
            return np.asarray(wider.distance(self._place(rows)) == 0)

        found = flood(grid.corners(self._middle)[:, 0], around, near)
        assert found is not None
        return found

    def vertices(self) -> tuple[Ints, Ints]:
        """The vertices in the region, times the unit, in lexicographic order; and their labels."""
        lattice, rows, labels = self.lattice(), [], []
        for k, shifts in enumerate(self.grid._classes):
            unmoved = self.grid.frame.turned(shifts / self.grid.vertex_unit)
            size = max(1, BLOCK // len(shifts))
            for part in (lattice[i : i + size] for i in range(0, len(lattice), size)):
                inside = self.region.distance(self._place(part)[:, None] + unmoved) == 0
                vectors, chosen = np.nonzero(inside)
                rows.append(part[vectors] + shifts[chosen])
                labels.append(np.full(len(chosen), k))
        found = np.concatenate(rows)
        order = np.argsort(codes(found))
        return found[order], np.concatenate(labels)[order]

    @cached_property
    def _middle(self) -> Ints:
        """The key of a simplex that holds the centre."""
        return self.grid.locate(self.region.centre[None]).keys

    def _place(self, rows: Ints) -> Floats:
        """Where vectors (times the unit) lie, seen from the centre of the region."""
        places: Floats = self.grid.frame.outward(rows / self.grid.vertex_unit) - self.region.centre
        return places

    def _around(self, keys: Ints) -> Ints:
        return np.reshape(self.grid.neighbours(keys), (-1, keys.shape[1]))

    def _meets(self, keys: Ints) -> Flags:
        corners = self._place(self.grid.corners(keys))
        return meets(self.region, corners, gradients_of(self.grid, corners))

    def _blocks(self, lattice: Ints) -> Iterator[tuple[Ints, Ints]]:
        """As `meets`, but simplices that share a corner or a gradient look at it once."""
        star, grid, d = self.grid._star, self.grid, self.grid.dimension
        unmoved = grid.frame.turned(star.points / grid.vertex_unit)
        reach, bits = self.region.reach(star.normals), 1 << np.arange(2 * d, dtype=np.uint16)
        size = max(1, BLOCK // len(star.keys))
        for start in range(0, len(lattice), size):
            at = self._place(lattice[start : start + size])
            points = at[:, None] + unmoved
            inside = self.region.distance(points) == 0
            sides = np.concatenate([points > self.region.half, points < -self.region.half], axis=2) @ bits
            highest = reach - at @ star.normals.T
            meet = np.zeros((len(at), len(star.keys)), dtype=np.bool_)
            beyond, common = meet.copy(), np.full(meet.shape, 2 ** (2 * d) - 1, dtype=np.uint16)
            for k in range(d + 1):
                meet |= inside[:, star.corners[:, k]]
                common &= sides[:, star.corners[:, k]]
                beyond |= (highest + (k == 0) < 0)[:, star.sides[:, k]]
            v, s = np.nonzero(~meet & ~beyond & (common == 0))
            corners = at[v, None] + unmoved[star.corners[s]]
            meet[v, s] = self.region.touches(corners, star.normals[star.sides[s]])
            v, s = np.nonzero(meet)
            yield v + start, s


def search(grid: Grid, region: Region) -> Search:
    """A region as it is searched."""
    largest = np.abs(region.centre).max() + region.reach(np.eye(grid.dimension)).max()
    offset = 0.0 if grid.frame.offset is None else np.abs(grid.frame.offset).max()
    return Search(grid, region.enlarged(SLACK * float(max(largest, offset, grid.frame.scale))))
