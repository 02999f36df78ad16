"""Section 4, end: Theorem 7."""

from __future__ import annotations

from ..affine import triangulation
from ..delaunay import protection
from ..exact import sqrt
from ..names import Type, triangulations_up_to
from ..simplex import Position, Simplex
from .claim import BrokenTool, Constants, Finding, agree, claim
from .section_4_basics import position_of
from .section_4_geometry import circumsphere, mirror_factors
from .section_4_patches import mirror_powers, patch, powers_in_patch
from .vectors import Point
from .vocabulary import EVERY_D, Weight

MIRROR = (
    r"Let $s_k$ be the reflection in the facet opposite to $u_k$, $h_k$ the height and $\lambda_k$ the "
    r"barycentric coordinate of $c$. Then $|s_k(u_k)-c|^2=R^2+4\lambda_kh_k^2$, as the heights over "
    r"the facet are $h_k$, $-h_k$ and $\lambda_kh_k$ and $(1+\lambda_k)^2-(1-\lambda_k)^2=4\lambda_k$.",
)
_FOLDING = (
    *MIRROR,
    r"If all $\lambda_k\ge0$: each vertex $v$ outside the simplex is carried into it by reflections in "
    "facets beyond which it lies, and none of them takes it away from $c$. The last that moves it carries "
    "$s_k(u_k)$ to $u_k$.",
    r"So the nearest other vertices are among the $s_k(u_k)$, and by symmetry all simplices see the same.",
)


@claim("sec4.coxeter-monohedral", "Section 4, before Theorem 7", Weight.RESULT, to_state=["sec4.monohedral"])
def coxeter_monohedral(printed: Constants) -> Finding:
    """Coxeter triangulations are monohedral: their simplices form {classes:words} class."""
    names = [kind.affine for kind in triangulations_up_to(3)]
    classes = {len({_invariants(s) for s in patch(name, 2)}) for name in names}
    return agree(
        printed,
        {"classes": max(classes)},
        EVERY_D,
        "Neighbours are mirror images in their common facet, and any two simplices are joined by a chain of "
        "neighbours: a composition of reflections carries one to the other.",
    )


def _invariants(vertices: frozenset[Point]) -> tuple[object, ...]:
    simplex = Simplex(tuple(vertices))
    return (
        simplex.gram_determinant,
        simplex.squared_circumradius,
        tuple(sorted(simplex.squared_heights)),
        tuple(sorted(simplex.circumcentre_coordinates)),
    )


def _kinds(where: Position) -> list[Type]:
    return [kind for kind in triangulations_up_to(8) if position_of(kind.affine) is where]


def _agrees_with_patch(kind: Type) -> bool:
    """Whether the nearest vertex of a patch is a mirror vertex; counted up to dimension 4."""
    return kind.rank > 4 or min(powers_in_patch(kind.affine)) == min(mirror_powers(triangulation(kind)))


def _deep_in_patch(kind: Type) -> bool:
    """Whether the deepest vertex of a patch, up to dimension 4, is at least as deep as each mirror vertex."""
    return kind.rank > 4 or min(powers_in_patch(kind.affine)) <= min(mirror_powers(triangulation(kind)))


@claim(
    "thm-7.outside",
    "Section 4, Theorem 7, first item",
    Weight.RESULT,
    to_state=["def-20"],
    to_prove=["thm-6"],
)
def theorem_7_outside(printed: Constants) -> Finding:
    """A Coxeter triangulation with a simplex that is not self-centred is {delaunay?|not }Delaunay."""
    kinds = _kinds(Position.OUTSIDE)
    inside = all(min(mirror_powers(triangulation(k))) < 0 and _deep_in_patch(k) for k in kinds)
    return agree(
        printed,
        {"delaunay": not (inside and mirror_factors() == {4})},
        EVERY_D,
        *MIRROR,
        r"If $\lambda_k<0$, the vertex $s_k(u_k)$ of the triangulation lies strictly inside the sphere. (It "
        r"need not be the deepest: in $\tilde D_5$ another vertex lies deeper than all mirror images.)",
        f"Checked with coordinates for {', '.join(k.affine for k in kinds)}.",
    )


@claim(
    "thm-7.boundary",
    "Section 4, Theorem 7, second item",
    Weight.RESULT,
    to_state=["def-19.protected"],
    to_prove=["cor-2", "lem-5", "sec4.coxeter-monohedral"],
)
def theorem_7_boundary(printed: Constants) -> Finding:
    """Let a simplex of a Coxeter triangulation have its circumcentre on its boundary.

    Then the triangulation is {delaunay?|not }Delaunay, and its protection is {protection}.
    """
    kinds = _kinds(Position.BOUNDARY)
    least = {min(mirror_powers(triangulation(k))) for k in kinds}
    protections = {protection(triangulation(k)).absolute for k in kinds}
    agrees = all(map(_agrees_with_patch, kinds)) and mirror_factors() == {4}
    return agree(
        printed,
        {
            "delaunay": agrees and least == {0},
            "protection": protections.pop() if len(protections) == 1 else -1,
        },
        EVERY_D,
        *_FOLDING,
        r"All $\lambda_k\ge0$ and one is 0: no vertex is inside the sphere, and one more is on it.",
        f"Checked with coordinates for {', '.join(k.affine for k in kinds)}. With vertices on the sphere "
        "allowed this is a Delaunay triangulation, one of several of its vertex set.",
    )


@claim(
    "thm-7.inside",
    "Section 4, Theorem 7, third item",
    Weight.RESULT,
    to_state=["def-19.protected"],
    to_prove=["lem-6", "sec4.coxeter-monohedral"],
)
def theorem_7_inside(printed: Constants) -> Finding:
    """Let a simplex of a Coxeter triangulation have its circumcentre strictly inside. Then the triangulation
    is {delaunay?|not }Delaunay, and its protection is {protected?not |}zero."""
    kinds = _kinds(Position.INSIDE)
    positive = all(min(mirror_powers(triangulation(k))) > 0 and _agrees_with_patch(k) for k in kinds)
    distances = all(_protection_is(k) for k in kinds)
    works = positive and mirror_factors() == {4}
    return agree(
        printed,
        {"delaunay": works, "protected": works and distances},
        EVERY_D,
        *_FOLDING,
        r"All $\lambda_k>0$: the nearest other vertices are outside the ball, and there are finitely many to "
        r"compare.",
        f"Checked with coordinates for {', '.join(k.affine for k in kinds)}.",
    )


def _protection_is(kind: Type) -> bool:
    """Whether the library's protection is the distance of the nearest mirror vertex from the ball."""
    t = triangulation(kind)
    square = circumsphere(t.simplex.vertex_matrix.rows()).square
    delta = sqrt(square + min(mirror_powers(t))) - sqrt(square)
    return protection(t).absolute == delta > 0


@claim(
    "thm-7",
    "Section 4, Theorem 7",
    Weight.RESULT,
    to_state=["def-20", "def-19.protected"],
    to_prove=["thm-7.outside", "thm-7.boundary", "thm-7.inside", "thm-6", "lem-5", "lem-6"],
)
def theorem_7(printed: Constants) -> Finding:
    """Whether a Coxeter triangulation is Delaunay, and protected, is decided by the place of the
    circumcentre of one simplex, in {cases:words} cases. These follow from Theorem 6, Lemma 5 and Lemma 6, as
    Coxeter triangulations are monohedral."""
    kinds = triangulations_up_to(8)
    small = [k.affine for k in kinds if k.rank <= 3]
    radii = all(len({Simplex(tuple(s)).squared_circumradius for s in patch(name, 2)}) == 1 for name in small)
    if not radii:
        raise BrokenTool("the simplices of a Coxeter triangulation have several circumradii")
    return agree(
        printed,
        {"cases": len({position_of(k.affine) for k in kinds})},
        EVERY_D,
        "Outside: by Theorem 6 not Delaunay. On the boundary: by Corollary 2 Delaunay; all circumradii "
        "agree, so each is the largest, and Lemma 5 applies. Strictly inside: Lemma 6.",
        "The cases exclude each other, there is no fourth, and each occurs.",
        "Each item has a direct proof, by reflections, that needs none of these lemmas.",
    )
