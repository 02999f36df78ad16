"""From an array of points to the simplices that hold them: exactly where that can be, else with a bound."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidInput
from .cells import Cells
from .compiled import locate_compiled
from .coordinates import barycentric
from .folding import Folded, fold
from .frames import Frame, from_helmert
from .subgroups import Ints, Subgroup

Floats = NDArray[np.float64]
LARGEST = 2.0**40
"""Coordinates up to which floats are taken: 12 bits are left below the unit."""
NUMBERS = 1 << 15
"""So many numbers at a time are held in intermediate arrays, which then stay in the cache."""


@dataclass(frozen=True)
class Found:
    """Keys, barycentric coordinates, and whether rounding leaves the answer open."""

    keys: Ints
    barycentric: NDArray[Any]
    open: NDArray[np.bool_]

    def __getitem__(self, rows: slice) -> Found:
        """A view of some rows."""
        return Found(self.keys[rows], self.barycentric[rows], self.open[rows])


@dataclass(frozen=True, eq=False)
class Locator:
    """Locates points given in the coordinates y of the subgroup."""

    subgroup: Subgroup
    cells: Cells | None
    centre: Ints
    key_unit: int

    @property
    def shares_of_centre(self) -> Ints:
        """The barycentric coordinates m_k / h, times the unit of keys."""
        marks = np.array(self.subgroup.triangulation.marks)
        return np.asarray(marks * (self.key_unit // marks.sum()))

    def rounded(self, y: Floats, lengths: Floats | None, found: Found) -> None:
        """For floats (n, c); or (n, d), in Helmert's coordinates of A~d, if his lengths are given."""
        factor = len(self.centre) * max(self.subgroup.triangulation.marks) * 2.0**-48
        sizes = locate_compiled(self, y, lengths, factor, found)
        if sizes is not None:
            return check_size(sizes)
        columns = np.ascontiguousarray(y.T)
        if lengths is not None:
            columns = from_helmert(columns, lengths)
        sizes = np.abs(columns).max(axis=0, initial=1.0)
        check_size(sizes)
        folded = fold(self.subgroup, self.cells, columns, 1.0)
        found.barycentric[:], found.open[:] = settle(barycentric(folded, 1.0), sizes * factor)
        found.keys[:] = self.keys(folded)

    def keys(self, folded: Folded) -> Ints:
        """The images of the centre."""
        images: Ints = folded.undo(self.centre[None], self.shares_of_centre[None], self.key_unit)[:, 0]
        return images

    def fold(self, z: NDArray[Any], unit: int) -> Folded:
        """Integers (n, m) in the coordinates of the roots, folded."""
        return fold(self.subgroup, self.cells, self.subgroup.into(z).T, unit)

    def exact(self, numerators: NDArray[Any], denominator: int) -> tuple[Ints, NDArray[Any], int]:
        """For integers (n, m) over a common denominator, in the coordinates of the roots: the keys, the
        barycentric coordinates as integers, and what these are over."""
        unit = 12 * denominator
        folded = self.fold(12 * numerators, unit)
        return self.keys(folded), barycentric(folded, unit).T, unit


def settle(shares: Floats, bounds: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """Barycentric coordinates (n, d + 1), from columns, without what rounding left below zero; which
    points are too close to tell."""
    near = shares.min(axis=0, initial=1.0) <= bounds
    shares = np.maximum(shares, 0.0)
    return (shares / shares.sum(axis=0)).T, near


# -- reading ------------------------------------------------------------------------------------------------


def read(points: ArrayLike, frame: Frame, columns: tuple[int, int]) -> NDArray[Any]:
    """Points as a float array (n, d), or as an object array of exact numbers.

    Raises
    ------
    InvalidInput
        If the shape is wrong, or something is no finite number.
    """
    if isinstance(points, np.ma.MaskedArray):
        raise InvalidInput("points with a mask were given: leave out those that are masked")
    try:
        array = np.asarray(points)
    except (TypeError, ValueError):
        raise InvalidInput("points are no array: give rows of equal length, one for each point") from None
    d, m = columns
    if array.size == 0 and array.ndim < 2:
        array = np.empty((0, d))
    if array.ndim != 2 or array.shape[1] not in columns:
        also = f" (or {m}, in the coordinates of the roots)" if m != d else ""
        raise InvalidInput(
            f"points of shape {array.shape} were given: expected (n, {d}){also}, a row for each point"
        )
    if array.shape[1] != d and not frame.plain:
        raise InvalidInput(
            f"points of shape {array.shape} were given, in the coordinates of the roots: in a grid with "
            f"a scale, rotation or offset expected (n, {d})"
        )
    if array.dtype.kind == "O":
        return _exact(array)
    if array.dtype.kind in "iu":
        return array.astype(object) if frame.standard or array.shape[1] != d else array
    if array.dtype.kind != "f":
        raise InvalidInput(f"an array of {array.dtype} was given: points are floats, integers or fractions")
    return array


def as_floats(array: NDArray[Any], first: int = 0) -> Floats:
    """Some rows, from the number of the first on, as finite floats of 64 bits.

    Raises
    ------
    InvalidInput
        If a number is not finite, or has too many digits.
    """
    floats = array.astype(np.float64, copy=False)
    if not np.isfinite(floats).all():
        row = int(np.flatnonzero(~np.isfinite(floats).all(axis=1))[0])
        raise InvalidInput(f"row {first + row} is {floats[row].tolist()}: all coordinates must be finite")
    if array.dtype.itemsize >= 8 and array.dtype != np.float64:
        rounded = np.abs(floats) >= 2.0**53 if array.dtype.kind in "iu" else floats != array
        if rounded.any():
            row = int(np.flatnonzero(rounded.any(axis=1))[0])
            raise InvalidInput(
                f"row {first + row} is {array[row].tolist()}: as floats of 64 bits these would be rounded"
            )
    return floats


def _exact(array: NDArray[Any]) -> NDArray[Any]:
    for x in array.flat:
        if isinstance(x, bool) or not isinstance(x, (int, Fraction, np.integer)):
            raise InvalidInput(f"{x!r} is neither an integer nor a fraction: mixed arrays are not read")
    return array


def over_common_denominator(array: NDArray[Any]) -> tuple[NDArray[Any], int]:
    """Exact numbers as integers over one denominator; int64 where they fit with room to spare."""
    denominator = lcm(1, *{int(x.denominator) for x in array.flat})
    scaled = np.frompyfunc(lambda x: int(x.numerator) * (denominator // int(x.denominator)), 1, 1)
    return _short(scaled(array), denominator), denominator


def floats_over_common_denominator(z: Floats) -> tuple[NDArray[Any], int]:
    """The same for floats, which are integers times powers of two."""
    mantissas, exponents = np.frexp(z)
    low = min(int(exponents.min(initial=0)) - 53, 0)
    numerators = (mantissas * 2.0**53).astype(np.int64).astype(object) << (exponents - 53 - low).astype(
        object
    )
    return _short(numerators, 2**-low), 2**-low


def _short(numerators: NDArray[Any], denominator: int) -> NDArray[Any]:
    """Integers as machine integers, if these have room to spare."""
    largest = max((abs(x) for x in numerators.flat), default=0)
    return np.asarray(numerators, dtype=np.int64 if max(largest, denominator) < 2**40 else object)


def check_size(sizes: Floats) -> None:
    """Refuse coordinates so large that floats no longer tell simplices apart."""
    largest = float(sizes.max(initial=0.0))
    if not largest <= LARGEST:
        raise InvalidInput(
            f"a coordinate is {largest:g} in units of the roots: floats do not tell simplices apart there; "
            f"give exact numbers, or stay below {LARGEST:g}"
        )


def is_short(z: Floats) -> NDArray[np.bool_]:
    """Which rows have so few binary digits that nothing on their way is rounded: pixels, and half pixels."""
    digits = z * 2.0**20
    return np.asarray(((digits == np.rint(digits)) & (np.abs(z) < 2.0**20)).all(axis=1))
