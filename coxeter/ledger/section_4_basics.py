"""Section 4, introduction: the setting, and what the later parts share.

A *triangulation* of space is face to face and locally finite; it is *Delaunay* if no vertex lies strictly
inside a circumsphere. Vertices on the sphere are allowed: else Theorem 7 would contradict itself.
"""

from __future__ import annotations

from functools import lru_cache

from ..affine import triangulation
from ..exact import show
from ..names import triangulations_up_to
from ..simplex import Position, Simplex, position
from .claim import BrokenTool, Constants, Finding, agree, claim, holds
from .section_4_geometry import circumsphere, height_vector, simplices
from .section_4_patches import patch, powers_in_patch
from .section_4_planes import cut_from_the_centres, trapezoid_triangles, trapezoids
from .vectors import Point, inner, minus, point, squared_edges
from .vocabulary import EVERY_D, FINITE, Weight

SMALL = tuple(kind.affine for kind in triangulations_up_to(4))
SMALLEST = tuple(kind.affine for kind in triangulations_up_to(3))
OBTUSE = (point(0, 0), point(3, 0), point(1, 1))
"""A triangle that is the whole Delaunay triangulation of its corners."""

POWER = (
    r"Let $\sigma,\sigma'$ share a facet $\tau$ with circumcentre $o$ and circumradius $\varrho$. Write "
    r"$\operatorname{pow}(x)=|x-c|^2-R^2$, and $z$ for heights over $\tau$, positive on the side of "
    r"$\sigma$.",
    r"(P) $\operatorname{pow}(x)-\operatorname{pow}'(x)=2(z_{c'}-z_c)\,z(x)$ and $R'^2-R^2=z_{c'}^2-z_c^2$, "
    "as both centres lie on the normal through $o$, so "
    r"$\operatorname{pow}(x)=|x-o|^2-\varrho^2-2z_c\,z(x)$.",
)
WALK = (
    *POWER,
    "Go straight from a point inside $\\sigma$ to a vertex $v$; almost every starting point avoids all faces "
    "of dimension up to $d-2$ before $v$. By local finiteness the way meets finitely many simplices.",
    r"At each crossing $z(v)\le0$; the two simplices are self-centred, so $z_c\ge0\ge z_{c'}$, and by (P) "
    r"the power of $v$ does not grow. It ends at 0, in a simplex with the vertex $v$, so it was $\ge0$ for "
    r"$\sigma$.",
)


# -- the setting ------------------------------------------------------------------------------------------


@claim("sec4.no-boundary", "Section 4, introduction", Weight.WORDING)
def no_boundary(printed: Constants) -> Finding:
    """The triangulations meant are infinite and have no boundary: each facet belongs to {sides:words}
    simplices."""
    coxeter = {len(k) for name in SMALLEST for k in _simplices_at_inner_facets(name)}
    found = coxeter | trapezoids().sides
    sides = found.pop() if len(found) == 1 else tuple(sorted(found))
    return agree(
        printed,
        {"sides": sides},
        EVERY_D,
        "They fill $\\mathbb R^d$, and finitely many simplices fill a bounded set. A facet with a simplex on "
        "one side only would bound the union there; two on the same side would overlap.",
        "A monohedral one is locally finite: a ball has room for finitely many bodies of one volume and "
        "diameter.",
    )


def _simplices_at_inner_facets(name: str) -> list[list[int]]:
    """For each facet of a simplex whose neighbours are all in the patch: the simplices at it."""
    all_simplices, inner_simplices = patch(name, 3), patch(name, 2)
    facets = {s - {v} for s in inner_simplices for v in s}
    return [[i for i, s in enumerate(all_simplices) if facet <= s] for facet in facets]


@claim("sec4.monohedral", "Section 4, introduction", Weight.WORDING)
def monohedral(printed: Constants) -> Finding:
    """A triangulation is monohedral if its d-simplices are congruent. The number of their congruence classes
    is {classes}."""
    kinds = {name: {squared_edges(s) for s in patch(name, 2)} for name in SMALLEST}
    thirds, _, _ = cut_from_the_centres()
    classes = {len(kind) for kind in kinds.values()} | {len(thirds)}
    several = len({squared_edges(t) for t in trapezoid_triangles()})
    if several < 2:
        raise BrokenTool("no triangulation with two classes was found")
    return agree(
        printed,
        {"classes": classes.pop() if len(classes) == 1 else 0},
        EVERY_D,
        "A definition. Coxeter triangulations and the triangles of A~2 cut from their centres have one "
        f"class, the halves of trapezoids used against Lemma 4 have {several}, with the same circumradius.",
    )


@claim(
    "sec4.finite-inapplicable",
    "Section 4, introduction",
    Weight.WORDING,
    to_state=["lem-4", "lem-5", "thm-6"],
)
def finite_inapplicable(printed: Constants) -> Finding:
    """With finitely many vertices, the greater part of what the section proves fails or says nothing.

    Its seven results are Lemmas 3 to 6, Corollary 2 and Theorems 6 and 7.
    """
    alone = position(Simplex(OBTUSE).circumcentre_coordinates) is Position.OUTSIDE
    large, small = (point(0, 0), point(4, 0), point(2, 2)), (point(4, 0), point(2, 2), point(4, 2))
    spheres = [circumsphere(large), circumsphere(small)]
    on_boundary = position(Simplex(large).circumcentre_coordinates) is Position.BOUNDARY
    guarded = spheres[0].power(small[2]) > 0 and spheres[1].power(large[0]) > 0
    if not (alone and on_boundary and guarded and spheres[0].square > spheres[1].square):
        raise BrokenTool("a finite witness does not have the properties it should")
    return holds(
        FINITE,
        f"The triangle {show_all(OBTUSE)} alone is Delaunay, monohedral and not self-centred: against Lemma "
        "4 and Theorem 6.",
        f"The triangles {show_all(large)} and {show_all(small)} are Delaunay; the larger circle has its "
        "centre on the boundary, and both triangles are protected: against Lemma 5. Theorem 7 is about "
        "infinite triangulations.",
        "That makes four of seven. For convex domains the walks that prove Lemma 3, Corollary 2 and Lemma 6 "
        "work.",
    )


def show_all(vertices: tuple[Point, ...]) -> str:
    """Points as text, without a word between them."""
    return "".join(map(show, vertices))


@claim("def-20", "Section 4, Definition 20", Weight.RESULT)
def self_centred(printed: Constants) -> Finding:
    """A simplex is self-centred if its circumcentre lies in it, where its boundary {boundary?counts|does not
    count}."""
    if not _coordinates_are_heights():
        raise BrokenTool("barycentric coordinates and heights of a circumcentre differ")
    flat = [kind for kind in SMALL if position_of(kind) is Position.BOUNDARY]
    counts = all(powers_in_patch(kind)[0] >= 0 for kind in flat)
    return agree(
        printed,
        {"boundary": counts},
        EVERY_D,
        "A definition; the signs of the barycentric coordinates of the circumcentre, which are its heights "
        "over the facets as parts of the simplex's, decide.",
        f"The boundary has to count for Theorem 6: {', '.join(flat)} are Delaunay with the centre on it.",
    )


@lru_cache(maxsize=1)
def _coordinates_are_heights() -> bool:
    """Whether barycentric coordinates of circumcentres are heights over facets, as parts of the whole."""
    for vertices in simplices():
        centre, coordinates = circumsphere(vertices).centre, Simplex(vertices).circumcentre_coordinates
        for k, x in enumerate(coordinates):
            facet = (*vertices[:k], *vertices[k + 1 :])
            height = height_vector(vertices[k], facet)
            if x * inner(height, height) != inner(height, minus(centre, facet[0])):
                return False
    return True


def position_of(name: str) -> Position:
    """Where the circumcentre of a Coxeter triangulation's simplices lies."""
    return position(triangulation(name).simplex.circumcentre_coordinates)
