"""The same folding, compiled by Numba, point by point: the same keys, and coordinates that differ in no more
than the last bits of a sum.

Numba is optional; without it NumPy does all the work. Kinds are numbers here: A, B, C, D are 0 to 3.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

SMALL = 40
"""Up to so many coordinates, counting for each those before it is the fastest way to sort."""
WIDTH = 8
"""No exceptional group needs more coordinates."""
GROUP = 16
"""So many points go down a search tree side by side."""


@njit(cache=True, inline="always")
def rank(order: Any, begin: int, sizes: Any, bounds: Any, c: int) -> None:
    """Indices by sizes, the greatest first, as `sorting._rank`: each counts those before it, branchless."""
    for i in range(c):
        size, bound, before = sizes[i], bounds[i], 0
        for j in range(i):
            before += bounds[j] > size
        for j in range(i + 1, c):
            before += sizes[j] >= bound
        order[begin + before] = i


@njit(cache=True, inline="always")
def fold_plain(
    z: Any,
    row: int,
    c: int,
    wide: int,
    rest: Any,
    bits: Any,
    bounds: Any,
    turned: Any,
    at: int,
    shift: Any,
    order: Any,
    x: Any,
) -> None:
    """Floors, the order of what is left, and turning so that the lattice is met; x is the result, sorted.

    Reads c numbers from z[row] on, and writes from number `at` on.
    """
    total = 0
    for i in range(c):
        floor = np.floor(z[row + i])
        rest[i] = z[row + i] - floor
        shift[at + i] = int(floor)
        total += shift[at + i]
    if c <= SMALL:
        for i in range(c):
            bounds[i] = bits[i] + 1
        for i in range(c, wide):
            bits[i] = bounds[i] = -1
        rank(turned, 0, bits, bounds, wide)
    else:
        turned[:c] = np.argsort(-rest[:c], kind="mergesort")
    mean = int(np.ceil(total / c))
    turn = c * mean - total
    for j in range(c):
        i = turned[j + turn - c * (j >= c - turn)]
        lift = (j >= c - turn) - mean
        order[at + j] = i
        x[at + j] = rest[i] - lift
        shift[at + i] += lift


@njit(cache=True, inline="always")
def fold_signed(
    z: Any,
    row: int,
    c: int,
    wide: int,
    kind: int,
    rest: Any,
    sizes: Any,
    bits: Any,
    bounds: Any,
    at: int,
    shift: Any,
    order: Any,
    signs: Any,
    x: Any,
) -> None:
    """Nearest integers, signs, sizes; x is the result, sorted, and so are the signs."""
    odd = 0
    for i in range(c):
        nearest = np.floor((2.0 * z[row + i] + 1.0) / 2.0)
        rest[i] = z[row + i] - nearest
        shift[at + i] = int(nearest)
        odd ^= shift[at + i] & 1
        sizes[i] = abs(rest[i])
    if c == 1:
        order[at] = 0
    elif c <= SMALL:
        for i in range(c):
            bounds[i] = bits[i] + (rest[i] >= 0)
        for i in range(c, wide):
            bits[i] = bounds[i] = -1
        rank(order, at, bits, bounds, wide)
    else:
        for i in range(c):
            bounds[i] = 2 * c - i if rest[i] < 0 else i
        by_ties = np.argsort(bounds[:c], kind="mergesort")
        order[at : at + c] = by_ties[np.argsort(-sizes[by_ties], kind="mergesort")]
    if kind != 2 and odd:
        first = order[at]
        way = -1 if rest[first] < 0 else 1
        shift[at + first] += way
        rest[first] -= way
    flip = 1
    for j in range(c):
        i = order[at + j]
        sign = -1 if rest[i] < 0 else 1
        flip *= sign
        signs[at + j] = sign
        x[at + j] = rest[i] * sign
    if kind == 3 and flip < 0:
        signs[at + c - 1] = -signs[at + c - 1]
        x[at + c - 1] = -x[at + c - 1]


@njit(cache=True)
def locate_classical(
    points: Any, kind: int, lengths: Any, key_unit: int, centre: Any, keys: Any, shares: Any, sizes: Any
) -> None:
    """A~d to D~d. Points of A~d with d coordinates are carried to d + 1 by Helmert's matrix."""
    n, given = points.shape
    m = len(centre)
    z, rest, size_of, x = np.empty(m), np.empty(m), np.empty(m), np.empty(m)
    shift, order, signs = np.empty(m, np.int64), np.empty(m, np.int64), np.empty(m, np.int64)
    bounds, work = np.empty(m, np.int64), np.empty(m, np.int64)
    rest_bits, size_bits = rest.view(np.int64), size_of.view(np.int64)
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
            fold_plain(z, 0, m, m, rest, rest_bits, bounds, work, 0, shift, order, x)
            for j in range(m):
                keys[p, order[j]] = shift[order[j]] * key_unit + centre[j]
            shares[p, 0] = 1.0 - (x[0] - x[m - 1])
            for j in range(1, m):
                shares[p, j] = x[j - 1] - x[j]
            continue
        fold_signed(z, 0, m, m, kind, rest, size_of, size_bits, bounds, 0, shift, order, signs, x)
        for j in range(m):
            keys[p, order[j]] = shift[order[j]] * key_unit + signs[j] * centre[j]
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


@njit(cache=True, fastmath={"reassoc", "contract"})
def find_cells(x: Any, count: int, walls: Any, children: Any, depth: int, finest: float, nodes: Any) -> None:
    """Down the tree with several points side by side, which hides how long each step takes.

    The sums are exact, so that their order may be changed.
    """
    for q in range(count):
        nodes[q] = len(walls) - 1
    for _ in range(depth):
        for q in range(count):
            node = nodes[q]
            level = walls[node, WIDTH] * finest
            for i in range(WIDTH):
                level += x[q * WIDTH + i] * walls[node, i]
            nodes[q] = children[node, int(level < 0)]


@njit(cache=True)
def locate_in_cells(
    points: Any,
    parts: Any,
    walls: Any,
    children: Any,
    depth: int,
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
    """E6, E7, E8, F4, G2: sorting by the parts of the subgroup, then down the tree to the cell.

    Tables are filled up with zeros to a fixed width, so that the innermost loops are unrolled.
    """
    n, c = points.shape
    m, labels = keys.shape[1], shares.shape[1]
    x, fine, nodes = np.zeros(GROUP * WIDTH), np.empty(GROUP * WIDTH), np.empty(GROUP, np.int64)
    order, signs = np.empty((GROUP + 1) * WIDTH, np.int64), np.ones(GROUP * WIDTH, np.int64)
    shift, work, bounds = (
        np.empty(GROUP * WIDTH, np.int64),
        np.empty(WIDTH, np.int64),
        np.empty(WIDTH, np.int64),
    )
    rest, size_of, level = np.empty(WIDTH), np.empty(WIDTH), np.empty(WIDTH + 1)
    rest_bits, size_bits = rest.view(np.int64), size_of.view(np.int64)
    key, image, z = np.zeros(WIDTH, np.int64), np.empty(WIDTH, np.int64), points.ravel()
    for begin in range(0, n, GROUP):
        count = min(GROUP, n - begin)
        for q in range(count):
            p, at = begin + q, q * WIDTH
            size = 1.0
            for i in range(c):
                size = max(size, abs(points[p, i]))
            sizes[p] = size
            for part in range(len(parts)):
                kind, start, w = parts[part, 0], parts[part, 1], parts[part, 2]
                row, to = p * c + start, at + start
                if kind == 0:
                    fold_plain(z, row, w, WIDTH, rest, rest_bits, bounds, work, to, shift, order, x)
                else:
                    fold_signed(
                        z, row, w, WIDTH, kind, rest, size_of, size_bits, bounds, to, shift, order, signs, x
                    )
                for j in range(to, to + w):
                    order[j] += start
        for i in range(len(x)):
            fine[i] = np.rint(x[i] * finest)
        find_cells(fine, count, walls, children, depth, finest, nodes)
        for q in range(count):
            p, at, cell = begin + q, q * WIDTH, nodes[q]
            for k in range(WIDTH + 1):
                level[k] = forms[cell, WIDTH, k]
            for i in range(c):
                for k in range(WIDTH + 1):
                    level[k] += x[at + i] * forms[cell, i, k]
            for k in range(labels):
                shares[p, k] = level[k]
            for j in range(c):
                i = order[at + j]
                key[i] = shift[at + i] * key_unit + signs[at + j] * centres[cell, j]
            for i in range(WIDTH):
                image[i] = 0
            for j in range(c):
                for i in range(WIDTH):
                    image[i] += key[j] * outward[j, i]
            for i in range(m):
                keys[p, i] = image[i] if below == 1 else int(np.rint(image[i] / below))


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
