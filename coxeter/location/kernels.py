"""The same folding, compiled by Numba: the same keys, and coordinates that differ in no more than the last
bits of a sum.

Points go side by side, a block at a time, one coordinate after the other: so the innermost loops run over
points, and become vector instructions. An index that is computed is made unsigned: one that might be negative
would count from the end, and be asked for it in every loop. Numba is optional; without it NumPy does all the
work. Kinds are numbers here: A, B, C, D are 0 to 3.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import config, njit

if getattr(config, "DISABLE_JIT", False):
    raise ImportError("Numba is turned off")
BLOCK = 64
"""So many points go side by side; in the last block those that are missing are 0."""
SMALL = 64
"""Up to so many coordinates, counting for each those before it is the fastest way to sort."""
WIDTH = 8
"""No exceptional group needs more coordinates; for fewer there are zeros."""
HUGE = 2.0**42
"""Points with greater coordinates are refused by who reads their sizes; till then they are 0."""
compiled = njit(cache=True, error_model="numpy")
"""Nothing is divided by 0, and where that has to be checked there are no vector instructions."""


# -- sorting -------------------------------------------------------------------------------------------------


@compiled
def count_before(bits: Any, bounds: Any, c: int, place: Any) -> None:
    """How many of c coordinates come before each, as in `sorting`: one comparison for each pair."""
    for i in range(c):
        for q in range(BLOCK):
            place[i, q] = 0
        for j in range(i):
            for q in range(BLOCK):
                first = 1 if bounds[j, q] > bits[i, q] else 0
                place[i, q] += first
                place[j, q] += 1 - first


@compiled
def sort_each(rest: Any, c: int, count: int, signed: bool, place: Any) -> None:
    """The same for many coordinates, point by point."""
    for q in range(count):
        column, ties = rest[:c, q].copy(), np.arange(c)
        if signed:
            below = np.flatnonzero(column < 0)
            ties = np.concatenate((np.flatnonzero(column >= 0), below[::-1]))
            column = np.abs(column)
        order = ties[np.argsort(-column[ties], kind="mergesort")]
        for j in range(c):
            place[order[j], q] = j


# -- folding -------------------------------------------------------------------------------------------------


@compiled
def fold_plain(z: Any, c: int, count: int, rest: Any, bounds: Any, sums: Any, shift: Any, place: Any) -> None:
    """Floors, the order of what is left, and turning so that the lattice is met.

    Of c rows z it writes the vector of the lattice, what is left, and its place in the order.
    """
    bits = rest.view(np.int64)
    for q in range(BLOCK):
        sums[0, q] = 0.0
    for i in range(c):
        for q in range(BLOCK):
            floor = np.floor(z[i, q])
            rest[i, q] = z[i, q] - floor
            shift[i, q] = floor
            sums[0, q] += floor
    if c <= SMALL:
        for i in range(c):
            for q in range(BLOCK):
                bounds[i, q] = bits[i, q] + 1
        count_before(bits, bounds, c, place)
    else:
        sort_each(rest, c, count, False, place)
    for q in range(BLOCK):
        sums[1, q] = np.ceil(sums[0, q] / c)
        bounds[0, q] = int(c * sums[1, q] - sums[0, q])
    for i in range(c):
        for q in range(BLOCK):
            place[i, q] -= bounds[0, q]
            lift = (1.0 if place[i, q] < 0 else 0.0) - sums[1, q]
            place[i, q] += c if place[i, q] < 0 else 0
            rest[i, q] -= lift
            shift[i, q] += lift


@compiled
def fold_signed(
    z: Any, c: int, count: int, kind: int, rest: Any, sizes: Any, bounds: Any, sums: Any, shift: Any,
    place: Any, signs: Any,
) -> None:  # fmt: skip
    """Nearest integers, signs, sizes: as `fold_plain`, and the signs, which what is left has lost."""
    bits = sizes.view(np.int64)
    for q in range(BLOCK):
        sums[0, q] = 0.0
    for i in range(c):
        for q in range(BLOCK):
            nearest = np.floor(z[i, q])
            nearest += 1.0 if z[i, q] - nearest >= 0.5 else 0.0
            rest[i, q] = z[i, q] - nearest
            sizes[i, q] = abs(rest[i, q])
            shift[i, q] = nearest
            sums[0, q] += nearest
    if c <= SMALL:
        for i in range(c):
            for q in range(BLOCK):
                bounds[i, q] = bits[i, q] + (1 if rest[i, q] >= 0.0 else 0)
        count_before(bits, bounds, c, place)
    else:
        sort_each(rest, c, count, True, place)
    for q in range(BLOCK):
        odd = sums[0, q] - 2.0 * np.floor(sums[0, q] / 2.0)
        sums[0, q] = 0.0 if kind == 2 else odd
        sums[1, q] = 1.0
    for i in range(c):
        for q in range(BLOCK):
            way = sums[0, q] if rest[i, q] >= 0.0 else -sums[0, q]
            way = way if place[i, q] == 0 else 0.0
            shift[i, q] += way
            rest[i, q] -= way
            signs[i, q] = -1.0 if rest[i, q] < 0.0 else 1.0
            rest[i, q] = abs(rest[i, q])
            sums[1, q] *= signs[i, q]
    if kind == 3:
        for i in range(c):
            for q in range(BLOCK):
                flip = sums[1, q] if place[i, q] == c - 1 else 1.0
                signs[i, q] *= flip
                rest[i, q] *= flip


# -- locating ------------------------------------------------------------------------------------------------


@compiled
def load(points: Any, begin: int, count: int, lengths: Any, z: Any, sums: Any, sizes: Any) -> None:
    """A block of points as columns, and the greatest size of a coordinate.

    If there are lengths, Helmert's matrix carries the points from d coordinates to the d + 1 of A~d.
    """
    d = points.shape[1]
    for k in range(d):
        for q in range(count):
            z[k, q] = points[begin + q, k]
        for q in range(count, BLOCK):
            z[k, q] = 0.0
    m = d
    if len(lengths):
        m = d + 1
        for q in range(BLOCK):
            sums[0, q] = z[m - 1, q] = 0.0
        for k in range(d - 1, -1, -1):
            for q in range(BLOCK):
                share = z[k, q] / lengths[k]
                sums[0, q] += share
                z[k + 1, q] -= share * (k + 1)
                z[k, q] = sums[0, q]
    for q in range(BLOCK):
        sums[0, q], sums[1, q] = 0.0, 1.0
    for k in range(m):
        for q in range(BLOCK):
            sums[0, q] += 0.0 * z[k, q]  # not 0 if one is not finite
            sums[1, q] = max(sums[1, q], abs(z[k, q]))
    for q in range(BLOCK):
        sums[1, q] = sums[1, q] if sums[0, q] == 0.0 else np.inf
    for k in range(m):
        for q in range(BLOCK):
            z[k, q] = z[k, q] if sums[1, q] < HUGE else 0.0
    for q in range(count):
        sizes[begin + q] = sums[1, q]


@compiled
def store(columns: Any, begin: int, count: int, rows: Any) -> None:
    """A block of columns as rows."""
    for q in range(count):
        for k in range(rows.shape[1]):
            rows[begin + q, k] = columns[k, q]


@compiled
def settle(
    levels: Any, labels: int, begin: int, count: int, factor: float, sizes: Any, sums: Any, near: Any
) -> None:
    """Barycentric coordinates without what rounding left below zero; which points are too close to tell."""
    for q in range(BLOCK):
        sums[0, q], sums[1, q] = 1.0, 0.0
    for k in range(labels):
        for q in range(BLOCK):
            sums[0, q] = min(sums[0, q], levels[k, q])
            levels[k, q] = max(levels[k, q], 0.0)
            sums[1, q] += levels[k, q]
    for k in range(labels):
        for q in range(BLOCK):
            levels[k, q] /= sums[1, q]
    for q in range(count):
        near[begin + q] = sums[0, q] <= sizes[begin + q] * factor


@compiled
def levels_of(x: Any, m: int, kind: int, levels: Any) -> None:
    """Barycentric coordinates, from those of the roots in order: as in `coordinates`."""
    for j in range(1, m):
        for q in range(BLOCK):
            step = x[j - 1, q] - x[j, q]
            levels[j, q] = step if kind == 0 else 2.0 * step
    for q in range(BLOCK):
        if kind == 0:
            levels[0, q] = 1.0 - (x[0, q] - x[m - 1, q])
        else:
            levels[m, q] = 2.0 * x[m - 1, q]
        if kind == 2:
            levels[0, q] = 1.0 - 2.0 * x[0, q]
        if kind % 2 == 1:
            levels[0, q], levels[1, q] = 1.0 - (x[0, q] + x[1, q]), x[0, q] - x[1, q]
        if kind == 3:
            levels[m - 1, q], levels[m, q] = x[m - 2, q] - x[m - 1, q], x[m - 2, q] + x[m - 1, q]


@compiled
def workspace(c: int, width: int) -> tuple[Any, ...]:
    """What c coordinates of a block are folded in; one by one, as slices of one array might overlap."""
    z, rest, size_of = np.empty((c, BLOCK)), np.empty((c, BLOCK)), np.empty((c, BLOCK))
    bounds, sums, shift = np.empty((c, BLOCK), np.int64), np.empty((2, BLOCK)), np.empty((c, BLOCK))
    place, signs, x = np.empty((c, BLOCK), np.int64), np.ones((c, BLOCK)), np.zeros((width, BLOCK))
    return z, rest, size_of, bounds, sums, shift, place, signs, x


@compiled
def locate_classical(
    points: Any, kind: int, lengths: Any, key_unit: int, centre: Any, factor: float, keys: Any, shares: Any,
    near: Any, sizes: Any,
) -> None:  # fmt: skip
    """A~d to D~d."""
    m, labels = len(centre), shares.shape[1]
    z, rest, size_of, bounds, sums, shift, place, signs, x = workspace(m, m)
    levels = np.empty((labels, BLOCK))
    for begin in range(0, len(points), BLOCK):
        count = min(BLOCK, len(points) - begin)
        load(points, begin, count, lengths, z, sums, sizes)
        if kind == 0:
            fold_plain(z, m, count, rest, bounds, sums, shift, place)
        else:
            fold_signed(z, m, count, kind, rest, size_of, bounds, sums, shift, place, signs)
        for i in range(m):
            for q in range(count):
                j = np.uint64(place[i, q])
                x[j, q] = rest[i, q]
                bounds[i, q] = int(shift[i, q]) * key_unit + int(signs[i, q]) * centre[j]
        store(bounds, begin, count, keys)
        levels_of(x, m, kind, levels)
        settle(levels, labels, begin, count, factor, sizes, sums, near)
        store(levels, begin, count, shares)


@compiled
def product(rows: Any, matrix: Any, images: Any) -> None:
    """The product of a matrix and WIDTH rows; its last column holds constants."""
    for i in range(len(matrix)):
        a, b, c, d = matrix[i, 0], matrix[i, 1], matrix[i, 2], matrix[i, 3]
        e, f, g, h, one = matrix[i, 4], matrix[i, 5], matrix[i, 6], matrix[i, 7], matrix[i, 8]
        for q in range(BLOCK):
            first = one + a * rows[0, q] + b * rows[1, q] + c * rows[2, q] + d * rows[3, q]
            images[i, q] = first + e * rows[4, q] + f * rows[5, q] + g * rows[6, q] + h * rows[7, q]


@compiled
def reflect(levels: Any, steps: Any, factors: Any, beyond: Any, level: Any, back: bool) -> None:
    """In wall after wall those points that lie beyond it, or on the way back those that did (1, else 0).

    That changes the levels of the wall and of up to three neighbours.
    """
    for i in range(len(steps)):
        s = np.uint64(len(steps) - 1 - i if back else i)
        k = steps[s, 0]
        if not back:
            for q in range(BLOCK):
                beyond[s, q] = 1.0 if levels[k, q] < 0.0 else 0.0
        for q in range(BLOCK):
            level[q] = levels[k, q] * beyond[s, q]
            levels[k, q] -= 2.0 * level[q]
        for n in range(3):
            neighbour, factor = steps[s, n + 1], factors[s, n]
            if factor != 0.0:
                for q in range(BLOCK):
                    levels[neighbour, q] += factor * level[q]


@compiled
def locate_in_cells(
    points: Any, parts: Any, forms: Any, weights: Any, steps: Any, factors: Any, corners: Any, outward: Any,
    below: int, key_unit: int, centre: float, factor: float, keys: Any, shares: Any, near: Any, sizes: Any,
) -> None:  # fmt: skip
    """E6, E7, E8, F4, G2: sorting by the parts of the subgroup, then reflections."""
    c, labels, m = points.shape[1], shares.shape[1], keys.shape[1]
    z, rest, size_of, bounds, sums, shift, place, signs, x = workspace(c, WIDTH)
    levels, level, nothing = np.zeros((WIDTH + 1, BLOCK)), np.empty(BLOCK), np.empty(0)
    beyond = np.empty((len(steps), BLOCK))
    images, back = np.zeros((WIDTH, BLOCK), np.int64), np.empty((m, BLOCK), np.int64)
    for begin in range(0, len(points), BLOCK):
        count = min(BLOCK, len(points) - begin)
        load(points, begin, count, nothing, z, sums, sizes)
        for part in range(len(parts)):
            kind, start, w = parts[part]
            y, to, at, sign = z[start:], shift[start:], place[start:], signs[start:]
            if kind == 0:
                fold_plain(y, w, count, rest, bounds, sums, to, at)
            else:
                fold_signed(y, w, count, kind, rest, size_of, bounds, sums, to, at, sign)
            for i in range(w):
                for q in range(BLOCK):
                    at[i, q] += start
                    x[np.uint64(at[i, q]), q] = rest[i, q]
        product(x, forms, levels)
        reflect(levels, steps, factors, beyond, level, False)
        for k in range(labels):
            for q in range(BLOCK):
                levels[k, q] *= weights[k]
        settle(levels, labels, begin, count, factor, sizes, sums, near)
        store(levels, begin, count, shares)
        levels[:labels] = centre
        reflect(levels, steps, factors, beyond, level, True)
        product(levels[1:], corners, rest)  # level 0 follows from the others
        for i in range(c):
            for q in range(BLOCK):
                image = signs[i, q] * rest[np.uint64(place[i, q]), q]
                images[i, q] = int(shift[i, q]) * key_unit + int(np.rint(image))
        product(images, outward, back)
        if below != 1:
            for i in range(m):
                for q in range(BLOCK):
                    back[i, q] = int(np.rint(back[i, q] * (1.0 / below)))
        store(back, begin, count, keys)
