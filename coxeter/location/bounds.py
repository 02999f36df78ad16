"""How many simplices meet a region at least, and about how many lattice vectors lie near: told beforehand."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from scipy.special import gammaln

from ..cartan import reflection_group_order
from .alcoves import LARGEST_ANSWER
from .convex import Region, balls
from .feasible import Flags, Floats

if TYPE_CHECKING:
    from .grid import Grid

MOST_ROOTS = 500
"""Where there are more positive roots than this, walls between two points are not counted."""
HIGHEST = 690.0
"""The exponential of what is greater is no float."""


def at_least(grid: Grid, region: Region, slack: float) -> float:
    """A lower bound for the number of simplices that meet a region, which has been enlarged by the slack.

    Reflections in walls that hold all of the region fix it. So on each side of these walls there are as many
    simplices, and they fill the region without the others.
    """
    along = quick(grid, region)
    if along > LARGEST_ANSWER:
        return along
    return max(along * float(_round_all(grid, region, slack)), float(_round_a_point(grid, region)))


def quick(grid: Grid, region: Region) -> float:
    """The same by what is the fastest to know."""
    return max(_by_volume(grid, region), _by_walls(grid, region))


def vectors_near(grid: Grid, region: Region) -> float:
    """About how many vectors of the coroot lattice are no farther from a region than the longest edge there.

    It is the volume of the region with all that lies so near, over that of a cell of the lattice, which the
    simplices round a vector fill.
    """
    edges = np.linalg.norm(grid._corners / grid.vertex_unit, axis=1) * grid.frame.scale
    order = grid.triangulation.roots.weyl_group_order
    return math.exp(min(region.volume_within(float(edges.max())) - math.log(order) - _volume(grid), HIGHEST))


def _by_volume(grid: Grid, region: Region) -> float:
    """By what one simplex can hold of a flat piece of the region.

    A piece of dimension k has at most the volume of a k-ball in common with a simplex whose diameter is the
    longest edge, as that is the diameter of the simplex (isodiametric inequality).
    """
    simplex, scale, d = grid.triangulation.simplex, grid.frame.scale, grid.dimension
    largest = balls(d, scale * float(simplex.longest_edge) / 2)
    largest[-1] = _volume(grid)
    return math.exp(min(float((region.sections - largest).max()), HIGHEST))


def _volume(grid: Grid) -> float:
    """The logarithm of the volume of a simplex."""
    square, d = grid.triangulation.simplex.gram_determinant, grid.dimension
    root = (math.log(square.numerator) - math.log(square.denominator)) / 2
    return root - float(gammaln(d + 1)) + d * math.log(grid.frame.scale)


def _by_walls(grid: Grid, region: Region) -> float:
    """By how many walls are between two of its points: a way from neighbour to neighbour crosses all."""
    t, d = grid.triangulation, grid.dimension
    if d * sum(t.marks) > 2 * MOST_ROOTS:
        return 1.0
    roots = t.roots.positive_roots
    levels = grid.frame.turned(roots.numerators / roots.denominator) / grid.frame.scale**2
    with np.errstate(over="ignore"):
        heights = np.abs(region.chords @ levels.T)
        return 1 + float(np.floor(heights * (1 - 2.0**-40)).sum(axis=1).max())


def _round_all(grid: Grid, region: Region, slack: float) -> int:
    """The order of the group of those reflections that fix the region but for what rounding does."""
    d = grid.dimension
    levels, gradients, _ = _seen(grid, region, np.sin(np.arange(1, d + 1)) / (2 * math.sqrt(d)))
    reach = region.enlarged(-slack).reach(gradients)
    return _group_order(grid, np.abs(levels) + reach <= slack / 16 * np.linalg.norm(gradients, axis=1))


def _round_a_point(grid: Grid, region: Region) -> int:
    """The order of the stabiliser of some point of the region, in a simplex that holds the centre.

    The walls that are the nearest, compared with how far the region reaches towards them, are made to meet;
    as many as do so within the region.
    """
    levels, gradients, corners = _seen(grid, region, np.zeros(grid.dimension))
    inside = np.flatnonzero(region.distance(corners) == 0)
    best = max(map(grid.meeting_at, inside.tolist()), default=1)
    far = np.abs(levels) / region.reach(gradients)
    for wall in np.sort(far[far <= 1])[::-1]:
        shares = np.where(far <= wall, 0.0, np.maximum(levels, 0))
        if (total := shares.sum()) and region.distance(shares @ corners / total) == 0:
            return max(best, _group_order(grid, far <= wall))
    return best


def _seen(grid: Grid, region: Region, where: Floats) -> tuple[Floats, Floats, Floats]:
    """For a point of the region its barycentric coordinates in a simplex that holds it, their gradients, and
    the corners as seen from the centre."""
    shift = where * region.half
    corners = grid.vertices(grid.locate((region.centre + shift)[None]).keys)[0] - region.centre
    gram = grid.triangulation._gradient_gram
    matrix = (gram.numerators / gram.denominator).astype(np.float64) / grid.frame.scale**2
    gradients: Floats = matrix @ (corners - corners[:1])
    return 1 + ((shift - corners) * gradients).sum(axis=1), gradients, corners


def _group_order(grid: Grid, walls: Flags) -> int:
    """The order of the group that the reflections in some facets of a simplex generate, not in all."""
    chosen, cartan = np.flatnonzero(walls).tolist(), grid._cartan
    if len(chosen) > grid.dimension:
        return 1
    return reflection_group_order(
        {i: {j: int(cartan[i, j]) for j in chosen if j != i and cartan[i, j]} for i in chosen}
    )
