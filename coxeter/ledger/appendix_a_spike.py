"""The simplices on which the printed proof of Lemma 10 breaks."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import combinations

import numpy as np

from ..exact import show
from ..simplex import Simplex
from .appendix_a_samples import SPIKE, nearest_face, shapes, square, unit
from .vectors import minus

EDGE_ONLY = ((0, 0, 0), (1, 1, 0), (2, 1, 0), (1, 0, 1))
"""The plane through its longest edge at the last vertex and the height from there meets it in that edge."""


@lru_cache(maxsize=1)
def ratios() -> tuple[tuple[Fraction, bool], ...]:
    """h²/L² for each separating facet of the samples, and whether the facet contains the nearest face.

    h is the height of the opposite vertex p, and L the longest edge at p.
    """
    every = (*shapes(), Simplex(EDGE_ONLY), spike(4)[0], spike(5)[0])
    return tuple(
        (height_to_edge(s, p), p not in nearest_face(s))
        for s in every
        for p, x in enumerate(s.circumcentre_coordinates)
        if x < 0
    )


def height_to_edge(s: Simplex, p: int) -> Fraction:
    """h²/L² for the height h from vertex p and the longest edge L at p."""
    edges = s.squared_edge_lengths
    return s.squared_heights[p] / max(edges[p, j] for j in range(s.dimension + 1))


@lru_cache(maxsize=16)
def spike(d: int) -> tuple[Simplex, Fraction]:
    """The counterexample in dimension d, and h²/L² for its vertex 3, whose opposite facet separates.

    Beyond dimension 3 further vertices stand beside the vertex (1, 0, 0).
    """
    beside = [(1, 0, 0, *(int(i == k) for i in range(3, d))) for k in range(3, d)]
    s = Simplex([*((*v, *[0] * (d - 3)) for v in SPIKE), *beside])
    assert s.circumcentre_coordinates[3] < 0
    return s, height_to_edge(s, 3)


def spike_words() -> str:
    """The counterexample in space, in words."""
    s, ratio = spike(3)
    assert ratio > Fraction(1, 2)
    centre = show(s.circumcentre_coordinates)
    return (
        f"The simplex {', '.join(map(show, SPIKE))}, with p = {show(SPIKE[3])}: the circumcentre has the "
        f"barycentric coordinates {centre}, so the facet opposite to p separates. There "
        f"$h^2={s.squared_heights[3]}$, and the longest edge at p has $L^2={s.squared_edge_lengths[3, 0]}$: "
        rf"$h^2/L^2={ratio}>\frac12$, the angle is more than $\pi/4$."
    )


@lru_cache(maxsize=1)
def is_least() -> bool:
    """Whether no simplex with the coordinates 0, 1, 2 is a counterexample; all are tried."""
    points = np.array([(x, y, z) for x in range(3) for y in range(3) for z in range(3)], dtype=np.int64)
    triples = points[np.array(list(combinations(range(len(points)), 3)))]
    normal = np.cross(triples[:, 1] - triples[:, 0], triples[:, 2] - triples[:, 0])
    keep = normal.any(axis=1)
    return not any(_exceeds(p, triples[keep], normal[keep]) for p in points)


def _exceeds(p: np.ndarray, floors: np.ndarray, normal: np.ndarray) -> bool:
    """Whether some floor separates its simplex with apex p from the circumcentre, and 2h² > L²."""
    start, b, c = floors[:, 0], floors[:, 1] - floors[:, 0], floors[:, 2] - floors[:, 0]
    area = (normal**2).sum(axis=1)
    weights = (b**2).sum(axis=1)[:, None] * c - (c**2).sum(axis=1)[:, None] * b
    centre = np.cross(weights, normal)  # the circumcentre of the floor, times 2·area, from `start`
    assert ((centre * b).sum(axis=1) == area * (b**2).sum(axis=1)).all()
    x = p - start
    level = (x * normal).sum(axis=1)
    # |x|² = 2⟨x, circumcentre⟩ gives the circumcentre's level, up to a positive factor
    beyond = (x**2).sum(axis=1) * area < (x * centre).sum(axis=1)
    longest = ((p - floors) ** 2).sum(axis=2).max(axis=1)
    return bool((beyond & (level != 0) & (2 * level**2 > longest * area)).any())


def section_is_edge() -> bool:
    """Whether the plane meets `EDGE_ONLY` in an edge alone.

    With the foot f and the end v of the edge, f - v is the sum of the f_i (v_i - v) over the two other
    vertices of the floor; if these two f_i differ in sign, the line through v and f meets the floor in v.
    """
    s = Simplex(EDGE_ONLY)
    edges = s.squared_edge_lengths
    assert s.circumcentre_coordinates[3] < 0
    assert 3 not in nearest_face(s)
    end = max(range(3), key=lambda j: edges[3, j])
    gradients = s.gradient_gram
    foot = tuple(x - gradients[3, j] / gradients[3, 3] for j, x in enumerate(unit(4, 3)))
    assert square(edges.rows(), minus(foot, unit(4, 3))) == s.squared_heights[3]
    first, second = (foot[j] for j in range(3) if j != end)
    return first * second < 0
