"""Rows of integers as things: told apart, put in order, reached from one another. Exact at any size."""

from __future__ import annotations

import logging
from collections.abc import Callable
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .subgroups import Ints

LOG = logging.getLogger(__name__)
"""It is told, at level INFO, how far a long search is."""
LARGEST = 2**62
"""Codes stay below it, so that they are machine integers."""
FEW = 1000
"""Up to so many rows nobody asks whether some are there twice."""


def codes(rows: NDArray[Any]) -> Ints:
    """A number for each row (n, c), in lexicographic order: equal for equal rows, else different.

    The digits of the number are the columns. Where there is no room for one more, the number so far is
    replaced by its rank.

    >>> import numpy as np
    >>> codes(np.array([[3, 5], [2, 9], [3, 5]])).tolist()
    [5, 4, 5]
    """
    code, size = np.zeros(len(rows), dtype=np.int64), 1
    for column in rows.T if len(rows) else ():
        low, span = column.min(), int(column.max()) - int(column.min()) + 1
        digits = column - low if span < LARGEST else ranks(column)
        span = min(span, len(rows)) if span >= LARGEST else span
        if size * span >= LARGEST:
            code, digits = ranks(code), ranks(digits)
            size = span = len(rows)
        code, size = code * span + digits.astype(np.int64), size * span
    return code


def in_order(rows: NDArray[Any]) -> NDArray[Any]:
    """Rows in lexicographic order."""
    return rows[np.argsort(codes(rows))]


def ranks(values: NDArray[Any]) -> Ints:
    """For each value, how many different ones are smaller."""
    return np.unique(values, return_inverse=True)[1].reshape(-1).astype(np.int64)


def numbered(code: Ints) -> tuple[Ints, Ints]:
    """Different codes in ascending order, and for each of `code` (any shape) the place of its like.

    A table takes the place of sorting where the codes are dense.
    """
    flat = code.reshape(-1)
    low = int(flat.min(initial=LARGEST))
    span = int(flat.max(initial=low)) - low + 1
    if span > 8 * len(flat) + 1024:
        different, places = np.unique(flat, return_inverse=True)
    else:
        there = np.zeros(span, dtype=np.bool_)
        there[flat - low] = True
        different = np.flatnonzero(there) + low
        places = (np.cumsum(there) - 1)[flat - low]
    return different, places.reshape(code.shape)


def distinct(rows: NDArray[Any], leading: int | None = None) -> tuple[NDArray[Any], Ints]:
    """The different ones of many rows (..., c), in lexicographic order, and each row's place among them.

    If so many leading columns fix the others, only they are looked at.
    """
    flat = rows.reshape(-1, rows.shape[-1])
    different, places = numbered(codes(flat[:, :leading]))
    found = np.empty((len(different), flat.shape[1]), dtype=rows.dtype)
    found[places] = flat
    return found, places.reshape(rows.shape[:-1])


def addends(a: Ints, b: Ints) -> tuple[Ints, Ints] | None:
    """Numbers for the rows of two arrays, whose sums are equal exactly when the sums of the rows are.

    They are in lexicographic order, as in `codes`. None where there is no room for them.
    """
    unit = np.gcd.reduce(np.concatenate([a, b]), axis=None) or 1
    a, b = (a - a.min(axis=0)) // unit, (b - b.min(axis=0)) // unit
    spans = [int(span) + 1 for span in a.max(axis=0) + b.max(axis=0)]
    if prod(spans) >= LARGEST:
        return None
    weights = np.array([prod(spans[i + 1 :]) for i in range(len(spans))], dtype=np.int64)
    return a @ weights, b @ weights


def flood(
    start: Ints,
    around: Callable[[Ints], Ints],
    keep: Callable[[Ints], NDArray[np.bool_]] | None = None,
    leading: int | None = None,
    limit: int | None = None,
) -> Ints | None:
    """All that can be reached from some rows by steps, in batches, breadth first; in lexicographic order.

    Parameters
    ----------
    start
        Rows (n, c), all different.
    around
        The rows one step from any of some rows; a step can be taken back.
    keep
        Which rows may be entered; all by default.
    leading
        So many columns tell the rows apart, and are the answer; the others are carried along. All by default.
    limit
        When more than so many have been found, give up and return None.
    """
    found, before, edge = [start[:, :leading]], start[:0, :leading], start
    count, looked, careful = len(start), 0, False
    while len(edge):
        # A step back or aside leads to the last two layers: no others need be looked through.
        names, rows = edge[:, :leading], around(edge)
        old = np.concatenate([before, names])
        first = np.unique(codes(np.concatenate([old, rows[:, :leading]])), return_index=True)[1]
        fresh = rows[first[first >= len(old)] - len(old)]
        edge, before = fresh if keep is None else fresh[keep(fresh)], old if careful else names
        found.append(edge[:, :leading])
        count += len(edge)
        if limit is not None and count > limit:
            return None
        if not careful and count > 2 * looked + FEW:
            # Unless `keep` has changed its mind, as rounding may: then a row entered late leads back.
            LOG.info("%d found so far", count)
            once = distinct(np.concatenate(found))[0]
            careful, looked = len(once) < count, count
            if careful:
                found, before, count = [once], once, len(once)
    return distinct(np.concatenate(found))[0]
