"""Which simplices meet a box or a ball.

Why spreading from neighbour to neighbour finds all simplices that meet a compact convex set K. Take two of
them, a point of each in K, and next to these, at most ε away, points inside the two simplices such that the
segment between misses all faces of codimension 2. It runs from neighbour to neighbour, and crosses each facet
at most ε away from K. There are finitely many facets near K, so those that come that near for all ε > 0 meet
K. Each simplex on the way has such a facet, or is one of the two: it meets K. So only those facets need be
crossed whose walls meet K. The search starts from many points of K at once: so few steps do, also in a box
that is long and thin.

A larger patch is made of *stars*. Vertex 0 of each simplex is a vector of the coroot lattice L; the simplices
round a vector are those round 0, one for each element of the Weyl group, moved by it. Neighbours have the
same vertex 0, or across facet 0 one that differs by an image of the coroot of the highest root. By what was
shown, steps by these lead to all vectors that are vertex 0 of a simplex that meets K, also if only such
vectors may be entered as are no farther from K than the longest edge at vertex 0.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from .alcoves import LARGEST_ANSWER, check_count
from .bounds import at_least, quick, vectors_near
from .convex import SLACK, Region, meets
from .feasible import Flags, Floats
from .rows import codes, distinct, flood
from .stars import orbit
from .subgroups import Ints

if TYPE_CHECKING:
    from .grid import Grid

LARGEST_STAR = 3_000_000
"""Stars of more simplices are not made: then neighbours lead to neighbours, however many there are."""
LARGEST_SEARCH = 2**34
"""From neighbour to neighbour, no more simplices than this, over (d + 1)^3, are found."""
SPARSE = 128
"""Where of the stars' simplices one in so many times d meets the region, or fewer, neighbours are faster."""
SAMPLE = 1 << 14
"""By about so many simplices it is estimated how many more there are."""
BLOCK = 1 << 18
"""So many simplices, or numbers, at a time are held in intermediate arrays."""
SEEDS = 1 << 14
"""A search starts from so many points at most,"""
APART = 8
"""and they are so many longest edges apart, at least."""


@dataclass(frozen=True, eq=False)
class Search:
    """A grid, and a region in it that is enlarged by the slack, for what rounding does.

    Rows, in the coordinates of the roots times the unit, are seen from a lattice vector in the middle of the
    region: so they are small, and the floats made of them as good far out as near the origin.
    """

    grid: Grid
    region: Region
    slack: float

    def keys(self) -> Ints:
        """The keys of the simplices that meet the region, in lexicographic order."""
        found = self.few()
        if found is None:
            found = self.keys_of(*self.stars())
            found = found[np.argsort(codes(found))]
        return found

    def few(self) -> Ints | None:
        """The same, from neighbour to neighbour; None if stars are better."""
        order = min(self.grid.triangulation.roots.weyl_group_order, 10**300)
        limit, least = self._limit, at_least(self.grid, self.region, self.slack)
        most = vectors_near(self.grid, self.region) * order
        self.check(least, limit)
        if least <= SAMPLE and most > limit and (found := self.spread(SAMPLE)) is not None:
            return found
        if most > limit:
            self.check(self.estimate() / 2, limit, "about {} simplices")
        if order <= LARGEST_STAR:
            limit = int(min(limit, max(most / (SPARSE * self.grid.dimension), BLOCK / 64)))
            return self.spread(limit) if least <= limit else None
        found = self.spread(limit)
        if found is None:
            self.check(limit + 1, limit)
        return found

    def estimate(self) -> float:
        """About how many simplices meet the region, rather less: by how fast a part that grows meets more."""
        part, counts = 1.0, [1]
        while part > 2.0**-1000 and quick(self.grid, self._part(part).region) > 8:
            part /= 2
        while part < 1 and (found := self._part(part).spread(SAMPLE)) is not None:
            counts.append(len(found))
            part *= 2
        if part == 1:
            return 1.0
        growth = math.log2(counts[-1] / counts[-2]) if len(counts) > 2 else 0.0
        return float(counts[-1] * 2.0 ** min(growth * (1 - math.log2(part)), 1000.0))

    def _part(self, part: float) -> Search:
        """The region made smaller about its centre."""
        return Search(
            self.grid, self.region.enlarged(-self.slack).scaled(part).enlarged(self.slack), self.slack
        )

    def stars(self) -> tuple[Ints, Ints, Ints]:
        """Vectors of L, and of each simplex that meets the region the number of its vertex 0 and its own."""
        lattice = self.lattice()
        vectors, simplices = zip(*self._blocks(lattice), strict=True)
        return lattice + self.origin[0], np.concatenate(vectors), np.concatenate(simplices)

    def keys_of(self, lattice: Ints, vectors: Ints, simplices: Ints) -> Ints:
        """The keys of what `stars` gives."""
        moved = lattice * self.grid.key_unit // self.grid.vertex_unit
        return np.asarray(self.grid._star.keys[simplices] + moved[vectors])

    def lattice(self) -> Ints:
        """Vectors of L, seen from the middle: all that are vertex 0 of a simplex in question, and more."""
        grid, unit = self.grid, self.grid.vertex_unit
        most = LARGEST_ANSWER // (grid.dimension + 1)
        self.check(vectors_near(grid, self.region), most, "about {} vertices with label 0 near it")
        walls = [grid._subgroup.wall(k) for k in range(grid.dimension + 1)]
        step = walls[0].reflect(0 * grid._centre, unit)
        steps = orbit(step, [partial(wall.reflect, unit=unit) for wall in walls[1:]])
        longest = np.linalg.norm(grid.frame.turned(grid._corners / unit), axis=1).max()

        def around(rows: Ints) -> Ints:
            return np.reshape(rows[:, None] + steps, (-1, rows.shape[1]))

        def near(rows: Ints) -> Flags:
            return np.asarray(self.region.distance(self.place(rows)) <= longest * (1 + SLACK))

        start = distinct(grid.corners(self._seeds)[:, 0] - self.origin[0])[0]
        found = flood(start.astype(np.int64), around, near)
        assert found is not None
        return found

    def spread(self, limit: int) -> Ints | None:
        """From neighbour to neighbour, unless they are too many. A row has a key and the corners."""
        keys, (vector, moved) = self._seeds, self.origin
        corners = (self.grid.corners(keys) - vector).reshape(len(keys), -1)
        rows = np.concatenate([keys - moved, corners], axis=1).astype(np.int64)
        found = flood(rows, self._across, self._meets, keys.shape[1], limit)
        return None if found is None else found + moved

    # -- the parts of a search ----------------------------------------------------------------------------

    @cached_property
    def _seeds(self) -> Ints:
        """The keys of simplices that hold points of the region, about evenly spread."""
        half, centre = self.region.half, self.region.centre
        step = APART * self.grid.frame.scale * float(self.grid.triangulation.simplex.longest_edge)
        while np.prod(np.ceil(2 * half / step)) > SEEDS:
            step *= 1.25
        points = np.zeros((1, len(half)))
        for k, n in enumerate(np.ceil(2 * half / step).astype(int)):
            if n > 1:
                points = np.repeat(points, n, axis=0)
                points[:, k] = np.tile(half[k] * np.arange(1 - n, n, 2) / n, len(points) // n)
        points = points[self.region.distance(points) == 0]
        return distinct(self.grid.locate(np.concatenate([centre[None], centre + points])).keys)[0]

    @cached_property
    def origin(self) -> tuple[Ints, Ints]:
        """A vector of L near the centre of the region, times the unit of vertices, and times that of keys."""
        grid = self.grid
        vector = grid.corners(grid.locate(self.region.centre[None]).keys)[0, 0]
        return vector, vector * grid.key_unit // grid.vertex_unit

    @cached_property
    def _shift(self) -> Floats:
        """Where that vector lies, seen from the centre of the region."""
        vector = (self.origin[0] / self.grid.vertex_unit).astype(np.float64)
        return np.asarray(self.grid.frame.outward(vector) - self.region.centre)

    def place(self, rows: Ints) -> Floats:
        """Where vectors (times the unit, seen from the one in the middle) lie, seen from the centre."""
        return np.asarray(self.grid.frame.turned(rows / self.grid.vertex_unit) + self._shift)

    @property
    def _limit(self) -> int:
        """So many simplices fit in memory, also while they are looked for, with corners and neighbours."""
        size = self.grid.dimension + 1
        return min(LARGEST_ANSWER // size, LARGEST_SEARCH // size**3)

    def check(self, count: float, most: float, words: str = "at least {} simplices") -> None:
        """Refuse to look for more than fits in memory."""
        largest, scale = self.slack / SLACK, self.grid.frame.scale
        why = f" (rounding leaves {self.slack:.2g} open at coordinates up to {largest:.3g})"
        check_count(count, most, words, why if self.slack > scale / 16 else "")

    @cached_property
    def _mirrors(self) -> tuple[Floats, Floats]:
        """For facet j coefficients of the corners, whose sum is twice the height of corner j as a vector; and
        what makes it the gradient of barycentric coordinate j."""
        gram, scale = self.grid.triangulation._gradient_gram, self.grid.frame.scale
        squares = gram.numerators.diagonal()
        factors = squares / gram.denominator / (2 * self.grid.vertex_unit * scale**2)
        return (2 * gram.numerators / squares[:, None]).astype(np.float64), factors.astype(np.float64)

    def _shape(self, corners: Ints) -> tuple[Floats, Floats, Floats]:
        """Where corners (n, d + 1, m) lie, the heights, doubled, and the gradients."""
        matrix, factors = self._mirrors
        heights = np.rint(matrix @ (corners - corners[:, :1]))
        return self.place(corners), heights, self.grid.frame.turned(heights) * factors[:, None]

    def _meets(self, rows: Ints) -> Flags:
        d, m = self.grid.dimension, len(self.grid._centre)
        size, result = max(1, BLOCK // rows.shape[1]), np.zeros(len(rows), dtype=np.bool_)
        for start in range(0, len(rows), size):
            part = rows[start : start + size, m:].reshape(-1, d + 1, m)
            corners, _, gradients = self._shape(part)
            result[start : start + size] = meets(self.region, corners, gradients)
        return result

    def _across(self, rows: Ints) -> Ints:
        """The simplices across those facets whose walls meet the region."""
        d, m, grid = self.grid.dimension, len(self.grid._centre), self.grid
        size, found, marks = max(1, BLOCK // rows.shape[1]), [rows[:0]], np.array(grid.triangulation.marks)
        for part in (rows[i : i + size] for i in range(0, len(rows), size)):
            place, heights, gradients = self._shape(part[:, m:].reshape(-1, d + 1, m))
            levels = np.abs(1 - (gradients * place).sum(axis=2))
            n, j = np.nonzero(levels <= self.region.reach(gradients))
            new, step = part[n], heights[n, j].astype(np.int64)
            new[:, :m] -= 12 * marks[j, None] * step // grid.vertex_unit
            new[:, m:].reshape(-1, d + 1, m)[np.arange(len(n)), j] -= step
            found.append(new)
        return np.concatenate(found)

    def _blocks(self, lattice: Ints) -> Iterator[tuple[Ints, Ints]]:
        """As `meets`, but simplices that share a corner or a gradient look at it once."""
        star, grid, d = self.grid._star, self.grid, self.grid.dimension
        unmoved = grid.frame.turned(star.points / grid.vertex_unit)
        reach, bits = self.region.reach(star.normals), 1 << np.arange(2 * d, dtype=np.uint16)
        size = max(1, BLOCK // len(star.keys))
        for start in range(0, len(lattice), size):
            at = self.place(lattice[start : start + size])
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
    slack = SLACK * float(max(largest, offset, grid.frame.scale))
    return Search(grid, region.enlarged(slack), slack)
