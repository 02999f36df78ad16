"""Groups of reflections as integer matrices."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from ..roots import RootSystem


def reflection_matrix(cartan: np.ndarray, i: int, coefficient: int = 1) -> np.ndarray:
    """The matrix of x -> x - coefficient·<x, e_i>e_i."""
    matrix = np.eye(len(cartan), dtype=np.int64)
    matrix[i] -= coefficient * cartan[i]
    return matrix


def simple_reflections(cartan: np.ndarray) -> list[np.ndarray]:
    """The reflections in all e_i."""
    return [reflection_matrix(cartan, i) for i in range(len(cartan))]


def generated(generators: Sequence[np.ndarray]) -> list[np.ndarray]:
    """The elements of the group that some matrices generate, which must be finite, by multiplying out."""
    one = np.eye(len(generators[0]), dtype=np.int64)
    found = {one.tobytes(): one}
    fresh = [one]
    while fresh:
        products = {m.tobytes(): m for g in generators for x in fresh for m in [g @ x]}
        fresh = [m for key, m in products.items() if key not in found]
        found |= products
    return list(found.values())


@lru_cache(maxsize=64)
def is_stable(system: RootSystem) -> bool:
    """Whether the reflection in each root maps the set of roots to itself."""
    n = system.roots.numerators
    place = 31 ** np.arange(n.shape[1])  # tells rows with entries up to 15 apart; lengths do not change
    codes = n @ place
    for r in n:
        twice, square = 2 * (n @ r), int(r @ r)
        if (twice % square).any() or not np.isin((n - np.outer(twice // square, r)) @ place, codes).all():
            return False
    return True
