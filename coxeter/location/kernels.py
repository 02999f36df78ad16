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
STEPS = 64
"""Room for so many rounds of sorting and reflecting; more are never needed near the fundamental simplex."""


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
def locate_by_mirrors(
    points: Any,
    kind: int,
    columns: Any,
    normals: Any,
    offsets: Any,
    factors: Any,
    divisors: Any,
    left: Any,
    weights: Any,
    weight_scale: int,
    doubled: Any,
    marks: Any,
    key_unit: int,
    centre: Any,
    keys: Any,
    shares: Any,
    sizes: Any,
    rounding: float,
) -> int:
    """E6, E7, E8, F4, G2: sorting by the subgroup, and reflections in the walls that are left, in turn.

    `normals` and `offsets` are those of all walls, doubled where they have halves; a reflection subtracts
    level times factor over divisor. Returns the number of points for which there was no room for all steps.
    """
    n, m = points.shape
    c, d = len(columns), len(marks) - 1
    z, y, x = np.empty(m), np.empty(c), np.empty(c)
    rest, size_of = np.empty(c), np.empty(c)
    work = np.empty(c, np.int64)
    orders, shifts = np.empty((STEPS, c), np.int64), np.empty((STEPS, c), np.int64)
    signs, walls = np.empty((STEPS, c), np.int64), np.empty(STEPS, np.int64)
    near, key, held = np.zeros(m, np.int64), np.empty(m, np.int64), np.empty(c, np.int64)
    missing = 0
    for p in range(n):
        size = 1.0
        for i in range(m):
            z[i] = points[p, i]
            size = max(size, abs(z[i]))
            near[i] = 0
        sizes[p] = size
        for k in range(len(weights)):
            count = 0.0
            for i in range(m):
                count += z[i] * weights[k, i]
            whole = int(np.floor((2.0 * count + weight_scale) / (2.0 * weight_scale)))
            for i in range(m):
                near[i] += whole * doubled[k, i]
        for i in range(m):
            z[i] -= near[i] * 0.5
        steps = 0
        while steps < STEPS:
            for j in range(c):
                y[j] = z[columns[j]]
            if kind == 0:
                fold_plain(y, c, rest, work, shifts[steps], orders[steps], x)
                signs[steps, :] = 1
            else:
                fold_signed(y, c, kind, rest, size_of, work, shifts[steps], orders[steps], x)
                signs[steps, :] = work
            for j in range(c):
                z[columns[j]] = x[j]
            crossed = -1
            for k in left:
                level = -1.0 * offsets[k]
                for i in range(m):
                    if normals[k, i] != 0:
                        level = level + z[i] * normals[k, i]
                if level < -rounding:
                    crossed = k
                    amount = level * factors[k] / divisors[k]
                    for i in range(m):
                        z[i] = z[i] - amount * normals[k, i]
                    break
            walls[steps] = crossed
            steps += 1
            if crossed < 0:
                break
        missing += walls[steps - 1] >= 0
        for k in range(d + 1):
            level = -1.0 * offsets[k]
            for i in range(m):
                if normals[k, i] != 0:
                    level = level + z[i] * normals[k, i]
            shares[p, k] = level * marks[k]
        for i in range(m):
            key[i] = centre[i]
        for step in range(steps - 1, -1, -1):
            k = walls[step]
            if k >= 0:
                level_ = -offsets[k] * key_unit
                for i in range(m):
                    level_ += key[i] * normals[k, i]
                level_ *= factors[k]
                for i in range(m):
                    key[i] -= level_ * normals[k, i] // divisors[k]
            for j in range(c):
                held[orders[step, j]] = signs[step, j] * key[columns[j]]
            for j in range(c):
                key[columns[j]] = held[j] + shifts[step, j] * key_unit
        for i in range(m):
            keys[p, i] = key[i] + near[i] * key_unit // 2
    return missing


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
