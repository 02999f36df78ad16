"""Patches of Coxeter triangulations, unfolded simplex by simplex: every vertex near one of them."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from ..affine import CoxeterTriangulation, triangulation
from ..exact import RationalMatrix
from ..simplex import Simplex
from .section_4_geometry import circumsphere
from .vectors import Point, along


@lru_cache(maxsize=32)
def patch(name: str, depth: int = 3) -> tuple[frozenset[Point], ...]:
    """The simplices that at most `depth` steps over facets lead to, the fundamental simplex first."""
    t = triangulation(name)
    corners = t.simplex.vertex_matrix.rows()
    known, layer = [frozenset(corners)], [corners]
    seen = {known[0]}
    for _ in range(depth):
        beyond = []
        for vertices in layer:
            for k, image in enumerate(_mirror_images(vertices)):
                moved = (*vertices[:k], image, *vertices[k + 1 :])
                if frozenset(moved) not in seen:
                    seen.add(frozenset(moved))
                    known.append(frozenset(moved))
                    beyond.append(moved)
        layer = beyond
    return tuple(known)


def _mirror_images(vertices: tuple[Point, ...]) -> list[Point]:
    """The mirror image of each vertex in its facet, from the vertices alone.

    The gradient of the coordinate k is Σ_j Γ_kj u_j, and the height vector is h² times that.
    """
    simplex = Simplex(vertices)
    gradients = (simplex.gradient_gram @ RationalMatrix.from_rows(vertices)).rows()
    pairs = zip(vertices, gradients, simplex.squared_heights, strict=True)
    return [along(u, -2 * square, gradient) for u, gradient, square in pairs]


@lru_cache(maxsize=64)
def powers_in_patch(name: str, depth: int = 3) -> tuple[Fraction, ...]:
    """The powers of all other vertices of the patch with respect to the fundamental simplex, ascending."""
    simplices = patch(name, depth)
    own = triangulation(name).simplex.vertex_matrix.rows()
    sphere = circumsphere(own)
    others = {v for s in simplices for v in s} - set(own)
    return tuple(sorted(map(sphere.power, others)))


@lru_cache(maxsize=64)
def mirror_powers(t: CoxeterTriangulation) -> tuple[Fraction, ...]:
    """The powers of the d + 1 mirror images s_k(u_k), computed as points."""
    corners = t.simplex.vertex_matrix.rows()
    sphere = circumsphere(corners)
    return tuple(sphere.power(t.facets[k].reflect(u)) for k, u in enumerate(corners))
