"""Grids that stand askew, and sets of keys, for the tests of regions."""

import numpy as np

from coxeter import triangulation
from coxeter.location import Grid


def turned(name, seed=1, scale=0.7):
    rng, d = np.random.default_rng(seed), triangulation(name).dimension
    rotation, _ = np.linalg.qr(rng.normal(size=(d, d)))
    return Grid(name, scale=scale, rotation=rotation, offset=rng.normal(size=d))


def rows(keys):
    return set(map(tuple, keys.tolist()))
