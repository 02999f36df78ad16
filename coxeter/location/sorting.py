"""Rounding and sorting: folding by the classical affine Weyl groups, for many points at once.

Points are columns of an array (c, n), so that each step runs along whole rows: floats, with unit 1, or exact
integers times a unit.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .subgroups import Subgroup

Points = NDArray[Any]
SMALL = 40
"""Up to so many coordinates, counting for each those before it is the fastest way to sort."""


@dataclass(frozen=True)
class Sorting:
    """y -> signs · (y - shift), sorted: coordinate i goes to position places[i]. Arrays (c, n)."""

    places: NDArray[np.intp]
    shift: Points
    signs: Points | None

    def undo(self, images: Points, chosen: NDArray[np.intp] | None, unit: Any) -> Points:
        """Carry one of the points (·, c) back, for each column the chosen one."""
        where = self.places if chosen is None else self.places + chosen * len(self.places)
        back: Points = np.take(images, where)
        if self.signs is not None:
            back = back * self.signs
        return np.asarray(back + self.shift * unit)


def sort(kind: str, y: Points, unit: Any) -> tuple[Points, Sorting]:
    """Fold points into the fundamental simplex of A~, B~, C~ or D~."""
    x, places, shift, signs = _plain(y, unit) if kind == "A" else _signed(y, unit, kind)
    result = np.empty(x.size, dtype=x.dtype)
    result[places * x.shape[1] + np.arange(x.shape[1])] = x
    if shift.dtype.kind == "f":
        shift, signs = shift.astype(np.int64), None if signs is None else signs.astype(np.int64)
    return result.reshape(x.shape), Sorting(places, shift, signs)


def sort_parts(subgroup: Subgroup, y: Points, unit: Any) -> tuple[Points, Sorting]:
    """The same for each part of a subgroup, at once."""
    parts = [(part.start, *sort(part.kind, y[part.columns], unit)) for part in subgroup.parts]
    if subgroup.classical:
        return parts[0][1], parts[0][2]
    x, places, shift = (
        np.concatenate(arrays)
        for arrays in zip(*((x, how.places + start, how.shift) for start, x, how in parts), strict=True)
    )
    signs = [np.ones_like(how.places) if how.signs is None else how.signs for _, _, how in parts]
    return x, Sorting(places, shift, np.concatenate(signs))


def _plain(y: Points, unit: Any) -> tuple[Points, NDArray[np.intp], Points, None]:
    """The affine symmetric group: floors, the order of what is left, and turning until the lattice is met."""
    c = len(y)
    shift = _floor(y, unit)
    rest = y - shift * unit
    sizes = _as_integers(rest)
    places = _rank(sizes, sizes + 1)
    total = shift.sum(axis=0)
    mean = -_floor(-total, c)
    turned = (places - (c * mean - total)).astype(np.intp)
    wrapped = turned < 0
    lift = wrapped - mean
    places = turned + c * wrapped
    return rest - lift * unit, places, shift + lift, None


def _signed(y: Points, unit: Any, kind: str) -> tuple[Points, NDArray[np.intp], Points, Points]:
    """Signed permutations: nearest integers, signs, sizes; for B and D the integers get an even sum.

    No float is rounded but where 1 is added last, and that leaves order and signs as they are: a float minus
    the nearest integer is a float (Sterbenz). So floats on walls and beside them go where fractions go.
    """
    shift = _floor(y, unit)
    shift = shift + (2 * (y - shift * unit) >= unit)
    rest = y - shift * unit
    signs = 1 - 2 * (rest < 0).astype(y.dtype)
    sizes = _as_integers(np.abs(rest))
    places = _rank(sizes, sizes + (rest >= 0))
    if kind != "C":
        way = (places == 0) * signs * (shift.sum(axis=0) % 2)
        shift = shift + way
        rest = rest - way * unit
        signs = np.where(way == 0, signs, -way)
    if kind == "D":
        signs = np.where(places == len(y) - 1, signs * np.prod(signs, axis=0), signs)
    return rest * signs, places.astype(np.intp), shift, signs


def _rank(sizes: Points, bounds: Points) -> NDArray[np.integer[Any]]:
    """How many come before each: i before a later j if bounds[i] > sizes[j]; bounds are sizes, or one more.

    So equal sizes keep their order where bounds are one more, and change it where not.
    """
    c, n = sizes.shape
    if c > SMALL:
        ties = np.where(bounds > sizes, 0, 2 * c) + np.arange(c)[:, None] * np.where(bounds > sizes, 1, -1)
        order = np.lexsort((ties.T, -sizes.T), axis=1)
        places = np.empty((n, c), dtype=np.intp)
        np.put_along_axis(places, order, np.broadcast_to(np.arange(c), (n, c)), axis=1)
        return places.T
    before = np.zeros((c, n), dtype=np.int8)
    for i in range(c - 1):
        first = (bounds[i] > sizes[i + 1 :]).view(np.int8)
        before[i + 1 :] += first
        before[i] += c - 1 - i - first.sum(axis=0, dtype=np.int8)
    return before


def _as_integers(sizes: Points) -> Points:
    """Numbers that are not negative, as integers in the same order: the bits of a float are."""
    return sizes.view(np.int64) if sizes.dtype.kind == "f" else sizes


def _floor(points: Points, unit: Any) -> Points:
    floors: Points = np.floor(points / unit) if points.dtype.kind == "f" else points // unit
    return floors
