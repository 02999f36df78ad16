"""The same folding, compiled by Numba, point by point: the same keys, and coordinates that differ in no more
than the last bits of a sum.

Numba is optional; without it `folding` does all the work. Kinds are numbers here: A, B, C, D are 0, 1, 2, 3.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

SMALL = 40
"""Up to so many coordinates, counting for each those before it is the fastest way to sort."""


@njit(cache=True, inline="always")
def rank_plain(order: Any, sizes: Any, n: int) -> None:
    """Indices by sizes, the greatest first, equal ones in order: each counts those before it, branchless."""
    for i in range(n):
        size, before = sizes[i], 0
        for j in range(i):
            before += sizes[j] >= size
        for j in range(i + 1, n):
            before += sizes[j] > size
        order[before] = i


@njit(cache=True, inline="always")
def rank_with_ties(order: Any, sizes: Any, ties: Any, n: int) -> None:
    """The same; equal ones by another number, the least first."""
    for i in range(n):
        size, tie, before = sizes[i], ties[i], 0
        for j in range(n):
            before += (sizes[j] > size) | ((sizes[j] == size) & (ties[j] < tie))
        order[before] = i


@njit(cache=True, inline="always")
def fold_plain(z: Any, m: int, rest: Any, turned: Any, shift: Any, order: Any, x: Any) -> None:
    """Floors, the order of what is left, and turning so that the lattice is met; x is the result, sorted."""
    total = 0
    for i in range(m):
        floor = np.floor(z[i])
        rest[i] = z[i] - floor
        shift[i] = int(floor)
        total += shift[i]
    if m <= SMALL:
        rank_plain(turned, rest, m)
    else:
        turned[:m] = np.argsort(-rest[:m], kind="mergesort")
    turn = (-total) % m
    mean = (total + turn) // m
    for j in range(m):
        i = turned[j + turn - m * (j >= m - turn)]
        lift = (j >= m - turn) - mean
        order[j] = i
        x[j] = rest[i] - lift
        shift[i] += lift


@njit(cache=True, inline="always")
def fold_signed(
    z: Any, d: int, kind: int, rest: Any, sizes: Any, ties: Any, shift: Any, order: Any, x: Any
) -> None:
    """Nearest integers, signs, sizes; x is the result, sorted, and `ties` ends as the signs in this order."""
    odd = 0
    for i in range(d):
        nearest = np.floor((2.0 * z[i] + 1.0) / 2.0)
        rest[i] = z[i] - nearest
        shift[i] = int(nearest)
        odd ^= shift[i] & 1
        sizes[i] = abs(rest[i])
        ties[i] = 2 * d - i if rest[i] < 0 else i
    if d <= SMALL:
        rank_with_ties(order, sizes, ties, d)
    else:
        order[:d] = np.argsort(ties[:d], kind="mergesort")
        order[:d] = order[:d][np.argsort(-sizes[order[:d]], kind="mergesort")]
    if kind != 2 and odd:
        first = order[0]
        way = -1 if rest[first] < 0 else 1
        shift[first] += way
        rest[first] -= way
    flip = 1
    for j in range(d):
        i = order[j]
        sign = -1 if rest[i] < 0 else 1
        flip *= sign
        ties[j] = sign
        x[j] = rest[i] * sign
    if kind == 3 and flip < 0:
        ties[d - 1] = -ties[d - 1]
        x[d - 1] = -x[d - 1]


@njit(cache=True)
def locate_classical(
    points: Any, kind: int, lengths: Any, key_unit: int, centre: Any, keys: Any, shares: Any, sizes: Any
) -> None:
    """A~d to D~d. Points of A~d with d coordinates are carried to d + 1 by Helmert's matrix."""
    n, given = points.shape
    m = len(centre)
    z, rest, size_of, x = np.empty(m), np.empty(m), np.empty(m), np.empty(m)
    shift, order, work = np.empty(m, np.int64), np.empty(m, np.int64), np.empty(m, np.int64)
    for p in range(n):
        if given < m:
            total = 0.0
            z[m - 1] = 0.0
            for k in range(m - 2, -1, -1):
                share = points[p, k] / lengths[k]
                total += share
                z[k + 1] -= share * (k + 1)
                z[k] = total
        else:
            for i in range(m):
                z[i] = points[p, i]
        size = 1.0
        for i in range(m):
            size = max(size, abs(z[i]))
        sizes[p] = size
        if kind == 0:
            fold_plain(z, m, rest, work, shift, order, x)
            for j in range(m):
                keys[p, order[j]] = shift[order[j]] * key_unit + centre[j]
            shares[p, 0] = 1.0 - (x[0] - x[m - 1])
            for j in range(1, m):
                shares[p, j] = x[j - 1] - x[j]
            continue
        fold_signed(z, m, kind, rest, size_of, work, shift, order, x)
        for j in range(m):
            keys[p, order[j]] = shift[order[j]] * key_unit + work[j] * centre[j]
        for j in range(1, m):
            shares[p, j] = 2.0 * (x[j - 1] - x[j])
        shares[p, m] = 2.0 * x[m - 1]
        if kind == 2:
            shares[p, 0] = 1.0 - 2.0 * x[0]
        else:
            shares[p, 0] = 1.0 - (x[0] + x[1])
            shares[p, 1] = x[0] - x[1]
            if kind == 3:
                shares[p, m - 1] = x[m - 2] - x[m - 1]
                shares[p, m] = x[m - 2] + x[m - 1]


@njit(cache=True)
def locate_in_cells(
    points: Any,
    parts: Any,
    walls: Any,
    children: Any,
    forms: Any,
    centres: Any,
    outward: Any,
    below: int,
    key_unit: int,
    finest: float,
    keys: Any,
    shares: Any,
    sizes: Any,
) -> None:
    """E6, E7, E8, F4, G2: sorting by the parts of the subgroup, then down the tree to the cell."""
    n, c = points.shape
    m, size, cells = keys.shape[1], shares.shape[1], len(forms)
    x, fine, rest, size_of = np.empty(c), np.empty(c), np.empty(c), np.empty(c)
    shift, order, signs = np.empty(c, np.int64), np.empty(c, np.int64), np.empty(c, np.int64)
    key = np.empty(c, np.int64)
    for p in range(n):
        sizes[p] = 1.0
        for i in range(c):
            sizes[p] = max(sizes[p], abs(points[p, i]))
        for kind, start, stop in parts:
            y, s, o, w = points[p, start:stop], shift[start:stop], order[start:stop], signs[start:stop]
            if kind == 0:
                fold_plain(y, stop - start, rest, w, s, o, x[start:stop])
                w[:] = 1
            else:
                fold_signed(y, stop - start, kind, rest, size_of, w, s, o, x[start:stop])
            o += start
        for i in range(c):
            fine[i] = np.rint(x[i] * finest)
        node = len(walls) - 1
        while node >= cells:
            level = walls[node, c] * finest
            for i in range(c):
                level += fine[i] * walls[node, i]
            node = children[node, int(level < 0)]
        for k in range(size):
            shares[p, k] = forms[node, c, k]
        for i in range(c):
            for k in range(size):
                shares[p, k] += x[i] * forms[node, i, k]
        for j in range(c):
            key[order[j]] = shift[order[j]] * key_unit + signs[j] * centres[node, j]
        for i in range(m):
            total = 0
            for j in range(c):
                total += key[j] * outward[j, i]
            keys[p, i] = total if below == 1 else int(np.rint(total / below))


@njit(cache=True)
def settle(shares: Any, sizes: Any, factor: float, near: Any) -> None:
    """Barycentric coordinates without what rounding left below zero; which points are too close to tell."""
    n, m = shares.shape
    for p in range(n):
        least, total = 1.0, 0.0
        for k in range(m):
            least = min(least, shares[p, k])
            shares[p, k] = max(shares[p, k], 0.0)
            total += shares[p, k]
        near[p] = least <= sizes[p] * factor
        for k in range(m):
            shares[p, k] /= total
