"""The triangulations, root systems and simplices on which statements are tried."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from random import Random

from ..affine import CoxeterTriangulation, triangulation
from ..errors import DegenerateSimplex
from ..exact import Surd
from ..names import EXCEPTIONAL, MINIMAL_RANK, triangulations_up_to
from ..quality import find_measure
from ..roots import RootSystem, root_system
from ..simplex import Simplex, regular_simplex
from .vectors import Point


@lru_cache(maxsize=8)
def all_types(d: int) -> tuple[CoxeterTriangulation, ...]:
    """All Coxeter triangulations up to a dimension."""
    return tuple(map(triangulation, triangulations_up_to(d)))


def of_type(letters: str, d: int) -> list[CoxeterTriangulation]:
    """Those of the types with given letters."""
    return [t for t in all_types(d) if t.type.letter in letters]


@lru_cache(maxsize=16)
def systems(rank: int, letters: str = "ABCDEFG") -> tuple[RootSystem, ...]:
    """The root systems up to a rank, of the types with given letters."""
    return tuple(
        root_system((x, r))
        for r in range(1, rank + 1)
        for x in letters
        if r in EXCEPTIONAL.get(x, ()) or r >= MINIMAL_RANK.get(x, rank + 1)
    )


def neighbours(t: CoxeterTriangulation) -> list[list[Point]]:
    """The mirror images of the fundamental simplex in its facets."""
    return [[f.reflect(v) for v in t.simplex.vertex_matrix.rows()] for f in t.facets]


@lru_cache(maxsize=4)
def neighbours_are_congruent(d: int) -> bool:
    """Whether these have the edges of the fundamental simplex, for all types up to a dimension."""
    return all(
        Simplex(vertices).squared_edge_lengths == t.simplex.squared_edge_lengths
        for t in all_types(d)
        for vertices in neighbours(t)
    )


_ANGLES = {0: Fraction(1, 2), 1: Fraction(1, 3), 2: Fraction(1, 4), 3: Fraction(1, 6)}
"""4·cos² of the angle between two walls, a product of Cartan integers, and the angle over π."""


@lru_cache(maxsize=256)
def dihedral_angles(t: CoxeterTriangulation) -> frozenset[Fraction]:
    """The dihedral angles over π, read off the affine diagram."""
    n, nodes = t.roots.affine_neighbours, range(t.dimension + 1)
    return frozenset(_ANGLES[n[i].get(j, 0) * n[j].get(i, 0)] for i, j in combinations(nodes, 2))


def random_simplices(d: int, count: int, seed: int, size: int = 4) -> list[Simplex]:
    """Simplices with integer coordinates from -size to size, the same in every run."""
    rng = Random(1000 * seed + d)
    found: list[Simplex] = []
    while len(found) < count:
        rows = [[rng.randint(-size, size) for _ in range(d)] for _ in range(d + 1)]
        try:
            found.append(Simplex(rows))
        except DegenerateSimplex:
            continue
    return found


def near_regular(d: int, count: int, size: int) -> list[Simplex]:
    """The unit vectors, enlarged, each coordinate moved by at most one; the same in every run."""
    rng = Random(1000 * size + d)
    n = range(d + 1)
    drawn = ([[size * (i == j) + rng.randint(-1, 1) for j in n] for i in n] for _ in range(count))
    return [Simplex(rows) for rows in drawn]


def is_regular(simplex: Simplex) -> bool:
    """Whether all edges are equally long."""
    return simplex.squared_longest_edge == simplex.squared_shortest_edge


@lru_cache(maxsize=256)
def regular_value(measure: str, d: int) -> Surd:
    """A measure of the regular simplex."""
    value: Surd = find_measure(measure)(regular_simplex(d))
    return value
