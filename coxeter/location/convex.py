"""Boxes and balls, and which simplices meet them.

A region is closed. Simplices that touch it count, and so do those that rounding cannot tell from such: before
anything is decided, the region is enlarged by `SLACK` times the largest coordinate at hand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import gammaln

from ..errors import InvalidInput
from .feasible import TINY, Flags, Floats, feasible
from .subgroups import Ints

SLACK = 2.0**-44
"""How much a region is enlarged, relative to the largest coordinate: 512 times the rounding of a float."""


THIN = 2.0**-10
"""Extents of a box, compared with a simplex, that are looked at only where the others do not decide."""
LONGEST = 1e150
"""Longer chords are taken to be so long: then what is made of them stays a float."""
MOST_SIGNS = 7
"""Signs that are varied to find long diagonals."""


class Region(Protocol):
    """A closed convex region that is symmetric about its centre. Points are given relative to that."""

    @property
    def centre(self) -> Floats:
        """Its centre."""

    @property
    def half(self) -> Floats:
        """Half the edges of the least box around it."""

    @property
    def radius(self) -> float:
        """The radius of the least ball around it."""

    @property
    def stretched(self) -> Region:
        """Of the same kind, with half the edges 1."""

    @property
    def sections(self) -> Floats:
        """The logarithms of the volumes of flat pieces of it, of dimension 1 to d; the last is all of it."""

    @property
    def chords(self) -> Floats:
        """Differences (n, d) of some of its points that are far apart."""

    def volume_within(self, by: float) -> float:
        """The logarithm of the volume of all that lies within a positive distance."""

    def scaled(self, by: float) -> Region:
        """Made larger or smaller, about its centre."""

    def enlarged(self, by: float) -> Region:
        """A region of the same kind that holds all that lies within a distance."""

    def reach(self, directions: Floats) -> Floats:
        """The maxima of <x, direction> over the region, for directions (..., d)."""

    def distance(self, points: Floats) -> Floats:
        """How far points (..., d) are from the region: 0 inside."""

    def touches(self, corners: Floats, gradients: Floats) -> Flags:
        """Which simplices meet it, by their corners and the gradients of their barycentric coordinates."""


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
        return cls(low / 2 + high / 2, high / 2 - low / 2)

    @property
    def radius(self) -> float:
        """Half a diagonal."""
        return float(np.linalg.norm(self.half))

    @property
    def stretched(self) -> Box:
        """A cube."""
        return Box(self.centre, np.ones_like(self.half))

    @property
    def sections(self) -> Floats:
        """The logarithms of the volumes of its largest faces, of dimension 1 to d."""
        with np.errstate(divide="ignore"):
            return np.cumsum(np.log(2) + np.log(np.sort(self.half)[::-1]))

    @property
    def chords(self) -> Floats:
        """Its edges and diagonals; of the latter some, in many dimensions."""
        d = len(self.half)
        signs = np.ones((2 ** min(d - 1, MOST_SIGNS), d))
        signs[:, 1 : MOST_SIGNS + 1] = list(product([1, -1], repeat=min(d - 1, MOST_SIGNS)))
        ways = np.concatenate([np.eye(d), signs])
        return np.where(ways, 2 * np.minimum(self.half, LONGEST) * ways, 0)

    def volume_within(self, by: float) -> float:
        """The logarithm of its volume with all that lies within a distance, by Steiner's formula."""
        d = len(self.half)
        pieces = np.concatenate([[0.0], np.full(d, -np.inf)])  # of the faces at a vertex, by dimension
        with np.errstate(divide="ignore"):
            for length in np.log(2) + np.log(self.half):
                pieces[1:] = np.logaddexp(pieces[1:], pieces[:-1] + length)
        return float(np.logaddexp.reduce(pieces + np.concatenate([[0.0], balls(d, by)])[::-1]))

    def scaled(self, by: float) -> Box:
        """Made larger or smaller, about its centre."""
        return Box(self.centre, self.half * by)

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
        """Which simplices have a point in common with the box: a linear program for each, all at once.

        Rounding may lead astray. So a simplex is left out only if there is seen to be a plane between.
        """
        unit = np.abs(corners - corners[:, :1]).max(initial=0) or 1.0
        thick = np.flatnonzero(self.half > THIN * unit)
        result = np.ones(len(corners), dtype=np.bool_)
        if len(thick) == len(self.half):
            return ~self._apart(corners, self._by_corners(corners, unit))
        sure, normals = self._by_levels(corners, gradients, thick)
        result[:] = sure | ~self._apart(corners, normals)
        rest = np.flatnonzero(result & ~sure)
        result[rest] = ~self._apart(corners[rest], self._by_corners(corners[rest], unit))
        return result

    def _apart(self, corners: Floats, normals: Floats) -> Flags:
        """Between which simplices and the box there is a plane with the given normal."""
        across = np.einsum("nkd,nd->nk", corners, normals)
        return np.asarray(np.maximum(across.min(axis=1), -across.max(axis=1)) > self.reach(normals))

    def _by_levels(self, corners: Floats, gradients: Floats, thick: Ints) -> tuple[Flags, Floats]:
        """Which simplices meet the box if it has no extent but in a few coordinates; or normals of planes.

        The variables are these coordinates, where box and simplex have them in common; and the barycentric
        ones, which must not be negative.
        """
        low, high = np.maximum(corners.min(axis=1), -self.half), np.minimum(corners.max(axis=1), self.half)
        start = np.zeros_like(low)
        start[:, thick] = low[:, thick]
        levels = 1 + np.einsum("nkd,nkd->nk", gradients, start[:, None] - corners)
        if not len(thick):
            return np.asarray((levels >= 0).all(axis=1)), np.zeros_like(low)
        span = np.maximum(high - low, 0)[:, thick]
        unit = span.max(initial=0) or 1.0
        lower = np.concatenate([-levels, np.zeros_like(span)], axis=1)
        upper = np.concatenate([np.full_like(levels, np.inf), span / unit], axis=1)
        result, reasons = feasible(gradients[:, :, thick] * unit, lower, upper)
        return result, np.einsum("nk,nkd->nd", reasons[:, : levels.shape[1]], gradients)

    def _by_corners(self, corners: Floats, unit: float) -> Floats:
        """Normals of planes between, or zeros. The variables are shares of the corners."""
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
        return feasible(table, lower, upper)[1][:, :d]


@dataclass(frozen=True, eq=False)
class Ball:
    """A ball."""

    centre: Floats
    radius: float

    @classmethod
    def around(cls, centre: ArrayLike, radius: float, d: int) -> Ball:
        """The ball of a radius, 0 or more, about a centre."""
        try:
            size = float(radius)
        except (TypeError, ValueError, OverflowError):
            size = math.nan
        if not (math.isfinite(size) and size >= 0):
            raise InvalidInput(f"{radius!r} is no radius: give a number that is 0 or more")
        return cls(_vector(centre, d, "the centre"), size)

    @property
    def half(self) -> Floats:
        """The radius, for each coordinate."""
        return np.full(len(self.centre), self.radius)

    @property
    def stretched(self) -> Ball:
        """The unit ball."""
        return Ball(self.centre, 1.0)

    @property
    def sections(self) -> Floats:
        """The logarithms of the volumes of balls of dimension 1 to d."""
        return balls(len(self.centre), self.radius)

    @property
    def chords(self) -> Floats:
        """Diameters."""
        return 2 * min(self.radius, LONGEST) * np.eye(len(self.centre))

    def volume_within(self, by: float) -> float:
        """The logarithm of the volume with all that lies within a distance."""
        return float(balls(len(self.centre), self.radius + by)[-1])

    def scaled(self, by: float) -> Ball:
        """Made larger or smaller, about its centre."""
        return Ball(self.centre, self.radius * by)

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

        The point of a simplex that is nearest to the centre is the centre plus the sum of l_j gradient_j,
        with l_j >= 0, and l_j = 0 unless barycentric coordinate j is 0 there. No angle between facets is
        obtuse: the inner products of different gradients are not positive. So the l_j are found without a
        step back. Take those facets that the centre is beyond, go to where they meet, add those that the new
        point is beyond, and so on, d times at most (Chandrasekaran, *Opsearch* 7, 1970, on Z-matrices).
        """
        # First, as it is cheap: is there a plane between, orthogonal to the way to the mean of the corners?
        means = corners.mean(axis=1)
        least = np.einsum("nkd,nd->nk", corners, means).min(axis=1)
        near = np.flatnonzero(least <= self.radius * np.linalg.norm(means, axis=1))
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


def balls(d: int, radius: float) -> Floats:
    """The logarithms of the volumes π^(k/2) r^k / (k/2)! of balls of dimension k = 1 to d."""
    half = np.arange(1, d + 1) / 2
    length = 2 * math.log(radius) if radius else -math.inf
    return np.asarray(half * (math.log(math.pi) + length) - gammaln(half + 1))


def _vector(given: ArrayLike, d: int, what: str) -> Floats:
    try:
        if np.ma.is_masked(given):
            raise TypeError
        vector = np.array(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InvalidInput(f"{what} is {given!r}: expected {d} numbers that floats can hold") from None
    if vector.shape != (d,) or not np.isfinite(vector).all():
        raise InvalidInput(f"{what} is {np.asarray(given).tolist()}: expected {d} finite numbers")
    return vector
