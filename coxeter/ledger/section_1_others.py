"""Section 1.2: what others wanted of triangulations, and did with these."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import lru_cache
from itertools import product

from ..cartan import reflection_group_order, restrict
from ..lattices import LatticeProof, vertex_lattice
from ..quality import radius_ratio
from ..root_lattices import root_lattice
from .claim import Constants, Finding, agree, cited, claim
from .instances import all_types, neighbours_are_congruent, of_type
from .vocabulary import EVERY_D, LITERATURE, Weight
from .wording import explained, fits, quoted

RESULT, WORDING = Weight.RESULT, Weight.WORDING


@claim("sec1.dobkin.neighbour", "Section 1.2", RESULT, to_state=["def-1"])
def easy_neighbour(printed: Constants) -> Finding:
    """The simplex beyond a facet is easily found: it has {new_vertices:words} new vertex, a mirror image."""
    true = {
        sum(f.reflect(v) != v for v in t.simplex.vertex_matrix.rows()) for t in all_types(6) for f in t.facets
    }
    return agree(
        printed, {"new_vertices": max(true)}, EVERY_D,
        "The reflection in a facet fixes its d vertices and moves the opposite one. Computed up to d = 6.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _labels() -> dict[int, frozenset[Fraction]]:
    """d -> the labels in every simplex near the fundamental one; an error if two simplices differ."""
    found: dict[int, set[frozenset[Fraction]]] = {}
    for t in all_types(4):
        for word in product(range(t.dimension + 1), repeat=2):
            corners = [t.unfold(word, v) for v in t.simplex.vertex_matrix.rows()]
            folded = [t.fold(v).barycentric for v in corners]
            found.setdefault(t.dimension, set()).add(
                frozenset(Fraction(x.index(Fraction(1))) for x in folded)
            )
    return {d: labels for d, (labels,) in ((d, tuple(sets)) for d, sets in found.items())}


@claim("sec1.dobkin.labels", "Section 1.2", RESULT, to_state=["def-1"])
def labels(printed: Constants) -> Finding:
    """All vertices can be labelled {first} to {last}, so that the vertices of each simplex have different
    labels."""
    last = {d: max(found) for d, found in _labels().items()}
    true = {"first": min(map(min, _labels().values())), "last": fits(printed["last"], "d", last)}
    return agree(
        printed, true, EVERY_D,
        "Each vertex is carried to exactly one $u_k$ by the affine Weyl group, as its orbit meets the "
        "closed simplex once; k is its label. Every simplex is an image of the fundamental one, so it has "
        "all labels.",
        "Computed: the labels of all simplices at most two steps away, for all types up to d = 4.",
    )  # fmt: skip


@claim("sec1.dobkin.congruent", "Section 1.2", RESULT, to_state=["def-1"])
def congruent(printed: Constants) -> Finding:
    """Coxeter triangulations are monohedral: all simplices are congruent."""
    true = neighbours_are_congruent(3)
    return agree(printed, {"congruent": true}, EVERY_D, "All simplices are images of one under reflections.")


@claim("sec1.dobkin.isotropic", "Section 1.2", WORDING, to_state=["def-1"])
def isotropic(printed: Constants) -> Finding:
    """The simplices of Coxeter triangulations are isotropic, that is, roughly the same in all directions."""
    squares = [(t, t.simplex.squared_longest_edge / t.simplex.squared_shortest_edge) for t in all_types(12)]
    worst = max(squares, key=lambda pair: pair[1])
    return agree(
        printed, {"isotropic": all(ratio <= 4 * t.dimension for t, ratio in squares)}, EVERY_D,
        "\"Roughly\" sets no bound; this is one: no edge is longer than $2\\sqrt d$ times another. "
        "Squared, the quotient of the longest and the shortest edge is $\\frac{(d+1)^2}{4d}$ or "
        "$\\frac{d+2}4$ in $\\tilde A_d$ (d odd, even), d in $\\tilde C_d$, $\\tilde D_d$ (2 for d = 4) "
        "and $\\tilde B_d$ (4 for d = 3).",
        f"Up to d = 12 it is greatest in {worst[0].name}, where it is {worst[1]}.",
    )  # fmt: skip


@claim("sec1.dobkin.choice", "Section 1.2", RESULT)
def choice(printed: Constants) -> Finding:
    """Comparing the radius ratios of all types, Dobkin and others chose the family {chosen}~."""
    quality = {t: radius_ratio(t.simplex) for t in all_types(8)}
    best = (max((t for t in quality if t.dimension == d), key=quality.__getitem__) for d in range(2, 9))
    (letter,) = {t.type.letter for t in best}
    return quoted(
        agree(printed, {"chosen": letter}, LITERATURE),
        "Dobkin, Levy, Thurston and Wilks, Contour tracing by piecewise linear approximations, 1990.",
        "It has the greatest radius ratio in each dimension from 2 to 8.",
    )


@claim("sec1.permutahedral", "Section 1.2", RESULT)
def permutahedral(printed: Constants) -> Finding:
    """The vertex set of the triangulation of type A~ is the {lattice} lattice."""
    proofs = [vertex_lattice(t) for t in of_type("A", 8)]
    dual = all(
        isinstance(p, LatticeProof) and p.lattice == root_lattice(p.triangulation.roots).dual()
        for p in proofs
    )
    cells = all(t.roots.weyl_group_order == math.factorial(t.dimension + 1) for t in of_type("A", 8))
    return agree(
        printed, {"lattice": "permutahedral" if dual and cells else "another"}, EVERY_D,
        "All marks are 1, so the vertices of the alcove are the fundamental coweights, and the vertex set "
        "consists of all vectors with integer products with the roots: the dual $A_d^*$ of the root "
        "lattice.",
        "Its Voronoi cell has the $(d+1)!$ circumcentres around a vertex as its corners, an orbit of the "
        "symmetric group: a permutahedron. Computed up to d = 8: the lattice, and the number of simplices "
        "at a vertex.",
    )  # fmt: skip


@claim("sec1.filtering", "Section 1.2", WORDING)
def filtering(printed: Constants) -> Finding:
    """Adams, Baek and Davis filter on the permutahedral lattice, as its simplices are congruent and
    isotropic."""
    return cited(
        "Adams, Baek and Davis, Fast high-dimensional filtering using the permutohedral lattice, 2010."
    )


@claim("sec1.rips", "Section 1.2", WORDING, to_state=["sec1.protection"])
def rips(printed: Constants) -> Finding:
    """A smaller approximation of the Rips filtration was found, mostly because the permutahedral lattice is
    so well protected."""
    return cited("Choudhary and others, as cited there.")


@lru_cache(maxsize=1)
def _nearest_lattice_points() -> tuple[tuple[str, int, int], ...]:
    """For root lattices of one length: the largest number of nearest lattice points to a vertex of the
    alcove."""
    found = []
    for t in of_type("ADE", 8):
        diagram, nodes = t.roots.affine_neighbours, set(range(t.dimension + 1))
        order = [reflection_group_order(restrict(diagram, nodes - {k})) for k in nodes]
        both = [reflection_group_order(restrict(diagram, nodes - {0, k})) for k in nodes]
        found.append((t.roots.name, t.dimension, max(a // b for a, b in zip(order, both, strict=True))))
    return tuple(found)


@claim("sec1.root-lattice-triangulations", "Section 1.2", WORDING)
def root_lattice_triangulations(printed: Constants) -> Finding:
    """From d = {from_d} on the Delaunay triangulations of root lattices are other ones than Coxeter
    triangulations."""
    crowded = {name: many for name, d, many in _nearest_lattice_points() if many > d + 1}
    alike = {name: d for name, d, many in _nearest_lattice_points() if many <= d + 1}
    finding = agree(
        printed, {"from_d": max(alike.values()) + 1}, EVERY_D,
        "From d = 3 on a vertex $u_k$ of the alcove has more than d + 1 nearest points of the root "
        "lattice, so some Delaunay cell is no simplex. They are an orbit of the group $W_k$ fixing $u_k$, "
        "and number $|W_k|/|W_k\\cap W|$: $\\binom{d+1}{2}$ for $A_d$ and k = 2, $2^{d-1}$ for $D_d$ and k "
        "= d.",
        f"Computed: {', '.join(f'{name} {many}' for name, many in crowded.items())}.",
        "Other root lattices are $\\mathbb Z^d$ for $B_d$, with cubes, and those of $D_d$, $D_4$, $A_2$ "
        "for $C_d$, $F_4$, $G_2$.",
        witness=f"The Delaunay triangulation of the root lattice {', '.join(alike)} is that by regular "
        "triangles, up to scale the Coxeter triangulation A~2.",
    )  # fmt: skip
    return explained(
        finding,
        r"In the plane one is a Coxeter triangulation. From $d=3$ on the reason is another than the one that "
        r"is given, as the vertices of $\tilde A_d$ do form a lattice: the cells are not all simplices",
    )
