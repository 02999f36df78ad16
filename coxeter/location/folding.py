"""Folding many points at once into the fundamental simplex, by rounding and sorting.

One code for floats, with unit 1, and for exact integers, in which a unit is any multiple of 12: then the
coordinates of all images are integers too. Each step is kept, so that it can be undone on other points: what
folds a point carries the fundamental simplex back onto the simplex that holds the point.

Points on walls. For the classical families a point belongs to the simplex that holds x + (ε, ε², …) for all
small ε > 0, in the coordinates of the roots. For the others the step by the subgroup follows that rule, and a
wall that is left is not crossed by a point on it.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .subgroups import Subgroup, Wall

Points = NDArray[Any]
ROUNDS = 1000
"""More than any point needs that a lattice vector has brought near."""
ROUNDING = 2.0**-40
"""So far beyond a wall a float is still taken to lie on it; else folding might go to and fro."""


@dataclass(frozen=True)
class Sorting:
    """x -> signs · (x - shift), sorted: position j of the result comes from coordinate index[:, j]."""

    columns: tuple[int, ...]
    index: NDArray[np.intp]
    shift: Points
    signs: NDArray[np.int64] | None

    def undo(self, points: Points, unit: Any) -> Points:
        """Carry points (n, j, m) back."""
        picked = points[:, :, self.columns]
        if self.signs is not None:
            picked = picked * self.signs[:, None, :]
        back = np.empty_like(picked)
        where = np.broadcast_to(self.index[:, None, :], picked.shape)
        np.put_along_axis(back, where, picked, axis=2)
        result = points.copy()
        result[:, :, self.columns] = back + self.shift[:, None, :] * unit
        return result


@dataclass(frozen=True)
class Mirror:
    """The reflection of some points in a wall."""

    chosen: NDArray[np.intp]
    wall: Wall

    def undo(self, points: Points, unit: Any) -> Points:
        """Carry points (n, j, m) back."""
        result = points.copy()
        result[self.chosen] = self.wall.reflect(points[self.chosen], unit)
        return result


@dataclass(frozen=True)
class Shift:
    """A translation, another for each point, by half of a vector of integers."""

    vectors: Points

    def undo(self, points: Points, unit: Any) -> Points:
        """Carry points (n, j, m) back."""
        moved: Points = points + self.vectors[:, None, :] * unit // 2
        return moved


@dataclass
class Folded:
    """Points of the fundamental simplex, and the way that they came."""

    points: Points
    unit: Any
    steps: list[Sorting | Mirror | Shift] = field(default_factory=list)

    def undo(self, points: Points, unit: int) -> Points:
        """Carry points (n, j, m) of the fundamental simplex to the simplices that hold the n points.

        They are integers, coordinates times the unit, whatever the points that were folded are.
        """
        if self.points.dtype == object:
            points = points.astype(object)
        for step in reversed(self.steps):
            points = step.undo(points, unit)
        return points


def fold(subgroup: Subgroup, points: Points, unit: Any) -> Folded:
    """Fold points (n, m), given in the coordinates of the roots times the unit."""
    folded = Folded(points, unit)
    if not subgroup.whole:
        _bring_near(subgroup, folded)
    _sort(subgroup, folded)
    active = np.arange(len(points))
    for _ in range(ROUNDS):
        active = _cross(subgroup, folded, active)
        if not len(active):
            return folded
        _sort_some(subgroup, folded, active)
    raise AssertionError(f"folding into {subgroup.triangulation.name} does not end")


# -- the subgroup -------------------------------------------------------------------------------------------


def _sort(subgroup: Subgroup, folded: Folded) -> None:
    y = folded.points[:, subgroup.order]
    sort = _sort_plain if subgroup.kind == "A" else _sort_signed
    x, index, shift, signs = sort(y, folded.unit, subgroup.kind)
    folded.steps.append(Sorting(subgroup.order, index, shift, signs))
    folded.points = folded.points.copy()
    folded.points[:, subgroup.order] = x


def _sort_some(subgroup: Subgroup, folded: Folded, active: NDArray[np.intp]) -> None:
    """The same for some points; the others stay where they are."""
    n, c = len(folded.points), len(subgroup.order)
    part = Folded(folded.points[active], folded.unit)
    _sort(subgroup, part)
    (step,) = part.steps
    assert isinstance(step, Sorting)
    index = np.broadcast_to(np.arange(c), (n, c)).copy()
    shift = np.zeros((n, c), dtype=step.shift.dtype)
    signs = np.ones((n, c), dtype=np.int64)
    index[active], shift[active] = step.index, step.shift
    if step.signs is not None:
        signs[active] = step.signs
    folded.steps.append(Sorting(subgroup.order, index, shift, signs))
    folded.points[active] = part.points


def _sort_plain(y: Points, unit: Any, _: str) -> tuple[Points, NDArray[np.intp], Points, None]:
    """The affine symmetric group: floors, the order of what is left, and turning until the lattice is met."""
    c = y.shape[1]
    shift = _floor(y, unit)
    rest = y - shift * unit
    index = np.argsort(-rest, axis=1, kind="stable")
    turn = (-shift.sum(axis=1) % c).astype(np.intp)[:, None]
    places = np.arange(c)
    index = np.take_along_axis(index, (places + turn) % c, axis=1)
    lifted = np.take_along_axis(shift, index, axis=1) + (places >= c - turn)
    mean = lifted.sum(axis=1)[:, None] // c
    np.put_along_axis(shift, index, lifted - mean, axis=1)
    x = np.take_along_axis(rest, index, axis=1) - ((places >= c - turn) - mean) * unit
    return x, index, _whole(shift), None


def _sort_signed(
    y: Points, unit: Any, kind: str
) -> tuple[Points, NDArray[np.intp], Points, NDArray[np.int64]]:
    """Signed permutations: nearest integers, signs, sizes; for B and D the integers get an even sum."""
    c = y.shape[1]
    shift = _floor(2 * y + unit, 2 * unit)
    rest = y - shift * unit
    negative = rest < 0
    places = np.arange(c)
    index = np.lexsort((np.where(negative, 2 * c - places, places), -np.abs(rest)), axis=1)
    rest, signs = np.take_along_axis(rest, index, axis=1), np.take_along_axis(negative, index, axis=1)
    signs = 1 - 2 * signs.astype(np.int64)
    if kind != "C":
        odd = np.flatnonzero(shift.sum(axis=1) % 2)
        first, way = index[odd, 0], signs[odd, 0]
        shift[odd, first] += way
        rest[odd, 0] -= way * unit
        signs[odd, 0] = -way
    if kind == "D":
        signs[:, -1] *= np.prod(signs, axis=1)
    return rest * signs, index, _whole(shift), signs


# -- what the subgroup leaves -------------------------------------------------------------------------------


def _bring_near(subgroup: Subgroup, folded: Folded) -> None:
    """Take away a vector of the coroot lattice, so that few reflections are left."""
    weights, scale = subgroup.weights
    counts = _floor(2 * (folded.points @ weights.T) + scale * folded.unit, 2 * scale * folded.unit)
    step = Shift(_whole(counts @ subgroup.doubled_coroots))
    folded.steps.append(step)
    folded.points = folded.points - step.vectors * (
        folded.unit / 2 if _is_float(folded.points) else folded.unit // 2
    )


def _cross(subgroup: Subgroup, folded: Folded, active: NDArray[np.intp]) -> NDArray[np.intp]:
    """Reflect those of the points that are beyond a wall; returns which they are."""
    least = -ROUNDING if _is_float(folded.points) else 0
    crossed = [np.empty(0, dtype=np.intp)]
    for wall in subgroup.left:
        chosen = active[wall.level(folded.points[active], folded.unit) < least]
        if len(chosen):
            step = Mirror(chosen, wall)
            folded.points[chosen] = wall.reflect(folded.points[chosen], folded.unit)
            folded.steps.append(step)
            crossed.append(chosen)
    return np.unique(np.concatenate(crossed))


def _is_float(points: Points) -> bool:
    return points.dtype.kind == "f"


def _floor(points: Points, unit: Any) -> Points:
    floors: Points = np.floor(points / unit) if _is_float(points) else points // unit
    return floors


def _whole(numbers: Points) -> Points:
    return numbers.astype(np.int64) if _is_float(numbers) else numbers
