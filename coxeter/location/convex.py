"""Boxes and balls, and which simplices meet them.

A region is closed. Simplices that touch it count, and so do those that rounding cannot tell from such: before
anything is decided, the region is enlarged by `SLACK` times the largest coordinate at hand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidInput

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
SLACK = 2.0**-44
"""How much a region is enlarged, relative to the largest coordinate: 512 times the rounding of a float."""
TINY = 2.0**-46
"""What counts as zero among barycentric coordinates, and among coordinates in units of a simplex."""
HEURISTIC = 5
"""So many pivots per variable the steepest is taken; then that of Bland, which leads to an end."""


class Region(Protocol):
    """A closed convex region that is symmetric about its centre. Points are given relative to that."""

    @property
    def centre(self) -> Floats:
        """Its centre."""

    @property
    def half(self) -> Floats:
        """Half the edges of the least box around it."""

    @property
    def volume(self) -> float:
        """Its volume."""

    def enlarged(self, by: float) -> Region:
        """The same, with all that lies within a distance."""

    def reach(self, directions: Floats) -> Floats:
        """The maxima of <x, direction> over the region, for directions (..., d)."""

    def distance(self, points: Floats) -> Floats:
        """How far points (..., d) are from the region: 0 inside."""

    def touches(self, corners: Floats, gradients: Floats) -> Flags:
        """Which simplices meet the region: their corners and the gradients of their barycentric coordinates."""


@dataclass(frozen=True, eq=False)
class Box:
    """A box by its middle and half its edges."""

    centre: Floats
    half: Floats

    @classmethod
    def between(cls, lower: ArrayLike, upper: ArrayLike, d: int) -> Box:
        """The box of all x with lower <= x <= upper in each coordinate."""
        low, high = _vector(lower, d, "the lower corner"), _vector(upper, d, "the upper corner")
        if (low > high).any():
            k = int(np.flatnonzero(low > high)[0])
            raise InvalidInput(f"coordinate {k} of the box runs from {low[k]:g} to {high[k]:g}: swap them")
        return cls((low + high) / 2, (high - low) / 2)

    @property
    def volume(self) -> float:
        """The product of its edges."""
        return float(np.prod(2 * self.half))

    def enlarged(self, by: float) -> Box:
        """A larger box."""
        return Box(self.centre, self.half + by)

    def reach(self, directions: Floats) -> Floats:
        """The maxima of <x, direction>."""
        return np.asarray(np.abs(directions) @ self.half)

    def distance(self, points: Floats) -> Floats:
        """How far points are from the box."""
        return np.asarray(np.linalg.norm(np.maximum(np.abs(points) - self.half, 0), axis=-1))

    def touches(self, corners: Floats, gradients: Floats) -> Flags:
        """Which simplices have a point in common with the box: a linear program for each, all at once."""
        unit = np.abs(corners - corners[:, :1]).max(initial=0) or 1.0
        start = self.distance(corners).argmin(axis=1)
        rows = np.arange(len(corners))[:, None]
        others = (start[:, None] + np.arange(1, corners.shape[1])) % corners.shape[1]
        first = corners[rows[:, 0], start] / unit
        edges = corners[rows, others] / unit - first[:, None]
        # x - first = sum of t_k edge_k and -sum of t_k, with bounds for all of them
        table = np.concatenate([edges.transpose(0, 2, 1), -np.ones_like(edges[:, :1])], axis=1)
        n, d = first.shape
        half = self.half / unit
        lower = np.concatenate([-half - first, np.full((n, 1), -1.0), np.zeros((n, d))], axis=1)
        upper = np.concatenate([half - first, np.full((n, d + 1), np.inf)], axis=1)
        return _feasible(table, lower, upper)


@dataclass(frozen=True, eq=False)
class Ball:
    """A ball."""

    centre: Floats
    radius: float

    @classmethod
    def around(cls, centre: ArrayLike, radius: float, d: int) -> Ball:
        """The ball of a radius, 0 or more, about a centre."""
        size = float(radius)
        if not (math.isfinite(size) and size >= 0):
            raise InvalidInput(f"{radius!r} is no radius: give a number that is 0 or more")
        return cls(_vector(centre, d, "the centre"), size)

    @property
    def half(self) -> Floats:
        """The radius, for each coordinate."""
        return np.full(len(self.centre), self.radius)

    @property
    def volume(self) -> float:
        """The volume of a ball."""
        d = len(self.centre)
        return float(math.pi ** (d / 2) / math.gamma(d / 2 + 1) * self.radius**d)

    def enlarged(self, by: float) -> Ball:
        """A larger ball."""
        return Ball(self.centre, self.radius + by)

    def reach(self, directions: Floats) -> Floats:
        """The maxima of <x, direction>."""
        return np.asarray(self.radius * np.linalg.norm(directions, axis=-1))

    def distance(self, points: Floats) -> Floats:
        """How far points are from the ball."""
        return np.asarray(np.maximum(np.linalg.norm(points, axis=-1) - self.radius, 0))

    def touches(self, corners: Floats, gradients: Floats) -> Flags:
        """Which simplices are no farther from the centre than the radius.

        The point of a simplex that is nearest to the centre is the centre plus the sum of l_j gradient_j, with
        l_j >= 0, and l_j = 0 unless barycentric coordinate j is 0 there. No angle between facets is obtuse, so
        the inner products of different gradients are not positive, and the l_j are found without a step back:
        take those facets that the centre is beyond, go to where they meet, add those that the new point is
        beyond, and so on, d times at most (Chandrasekaran, *Opsearch* 7, 1970, on M-matrices).
        """
        means = corners.mean(axis=1)
        least = np.einsum("nkd,nd->nk", corners, means).min(axis=1)
        near = np.flatnonzero(least <= self.radius * np.linalg.norm(means, axis=1))  # cheap, and rarely in vain
        corners, gradients = corners[near], gradients[near]
        levels = 1 - np.einsum("nkd,nkd->nk", gradients, corners)  # the barycentric coordinates of the centre
        products = gradients @ gradients.transpose(0, 2, 1)
        beyond, multipliers = levels < -TINY, np.zeros_like(levels)
        waiting = np.flatnonzero(beyond.any(axis=1))
        while len(waiting):
            b, g, level = beyond[waiting], products[waiting], levels[waiting]
            system = np.where(b[:, :, None] & b[:, None, :], g, np.eye(b.shape[1]))
            found = np.linalg.solve(system, np.where(b, -level, 0)[..., None])
            multipliers[waiting] = found[..., 0]
            more = ((g @ found)[..., 0] + level < -TINY) & ~b
            beyond[waiting] |= more
            waiting = waiting[more.any(axis=1)]
        result = np.zeros(len(least), dtype=np.bool_)
        result[near] = -np.einsum("nk,nk->n", multipliers, levels) <= self.radius**2
        return result


def meets(region: Region, corners: Floats, gradients: Floats) -> Flags:
    """Which simplices meet a region; corners and gradients have the shape (n, d + 1, d).

    Most are settled by a corner inside, a facet with the region beyond it, or the box around the region.
    """
    result: Flags = (region.distance(corners) == 0).any(axis=1)
    highest = 1 - np.einsum("nkd,nkd->nk", gradients, corners) + region.reach(gradients)
    near = (corners.min(axis=1) <= region.half) & (corners.max(axis=1) >= -region.half)
    unsettled = np.flatnonzero(~result & (highest >= 0).all(axis=1) & near.all(axis=1))
    result[unsettled] = region.touches(corners[unsettled], gradients[unsettled])
    return result


def _feasible(table: Floats, lower: Floats, upper: Floats) -> Flags:
    """Whether there are t with lower <= (table · t, t) <= upper, for many small systems at once.

    The simplex method of Dutertre and de Moura (*A fast linear-arithmetic solver for DPLL(T)*, 2006). All t
    start at their lower bounds, 0. Of the dependent variables one that is out of bounds is exchanged for an
    independent one that can make up for it; if there is none, there is no solution.
    """
    n, r, c = table.shape
    left, right = np.tile(np.arange(r), (n, 1)), np.tile(np.arange(r, r + c), (n, 1))
    values, at_upper = np.zeros((n, r)), np.zeros((n, c), dtype=np.bool_)
    result, active = np.zeros(n, dtype=np.bool_), np.arange(n)
    for step in range(1000 * (r + c)):
        here, bland = np.arange(len(active)), step > HEURISTIC * (r + c)
        lack = np.take_along_axis(lower, left, 1) - values
        excess = values - np.take_along_axis(upper, left, 1)
        wrong = np.maximum(lack, excess)
        row = np.where(wrong > TINY, -left if bland else wrong, -np.inf).argmax(axis=1)
        done = wrong[here, row] <= TINY
        result[active[done]] = True
        # An independent variable lies at one of its bounds; it can move away from it, not beyond.
        rising = lack[here, row] > 0
        gain = np.where(at_upper ^ rising[:, None], 1, -1) * table[here, row]
        column = np.where(gain > TINY, -right if bland else gain, -np.inf).argmax(axis=1)
        go = np.flatnonzero(~done & (gain[here, column] > TINY))
        if not len(go):
            return result
        state = (table, lower, upper, values, left, right, at_upper, active, row, column, rising)
        table, lower, upper, values, left, right, at_upper, active, row, column, rising = (x[go] for x in state)
        here, need = here[: len(go)], np.where(rising, lack[go, row], -excess[go, row])
        line, entries = table[here, row], table[here, :, column]
        pivot = line[here, column]
        line = -line / pivot[:, None]
        line[here, column] = 1 / pivot
        table[here, :, column] = 0
        table += entries[:, :, None] * line[:, None, :]
        table[here, row] = line
        entering, leaving = right[here, column], left[here, row]
        bound = np.where(at_upper[here, column], upper[here, entering], lower[here, entering])
        values += entries * (need / pivot)[:, None]
        values[here, row] = bound + need / pivot
        left[here, row], right[here, column], at_upper[here, column] = entering, leaving, ~rising
    raise AssertionError("the simplex method does not end")


def _vector(given: ArrayLike, d: int, what: str) -> Floats:
    try:
        vector = np.array(given, dtype=np.float64)
    except (TypeError, ValueError):
        raise InvalidInput(f"{what} is {given!r}: expected {d} numbers") from None
    if vector.shape != (d,) or not np.isfinite(vector).all():
        raise InvalidInput(f"{what} is {np.asarray(given).tolist()}: expected {d} finite numbers")
    return vector
