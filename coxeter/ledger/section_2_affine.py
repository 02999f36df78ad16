"""Section 2.4: affine reflections, alcoves, Coxeter triangulations and their classification."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, pairwise, permutations, product

import numpy as np

from .. import diagrams
from ..affine import CoxeterTriangulation, affine_reflection, triangulation
from ..errors import InvalidInput
from ..exact import RationalMatrix, sqrt
from ..figures import monohedral_not_coxeter
from ..figures.monohedral import Monohedral
from ..names import triangulations_up_to
from ..paper import printed as paper
from ..root_lattices import coroot_lattice
from ..roots import root_system
from ..simplex import Simplex
from .claim import Constants, Finding, agree, claim, damaged
from .section_1 import all_types, explained, fits, quoted
from .section_2 import family_of, name_of, names_of_trees, systems
from .vocabulary import EVERY_D, FINITE, LITERATURE, Verdict, Weight

RESULT, WORDING = Weight.RESULT, Weight.WORDING

# -- hyperplanes and affine reflections -------------------------------------------------------------------


@claim("def-13", "Section 2.4, Definition 13", WORDING)
def definition_13(printed: Constants) -> Finding:
    """A vector u gives a family of parallel hyperplanes, of the points with product k with u, for each
    integer k."""
    finding = agree(
        printed, {"zero_excluded": not _has_reflection((0, 0)) and _has_reflection((0, 1))}, EVERY_D,
        "For u ≠ 0 they are parallel, at distances 1/|u|.",
    )  # fmt: skip
    why = "u must not be 0: then the points with product 0 are the whole space, and no others exist"
    return explained(finding, why)


def _has_reflection(u: tuple[int, ...]) -> bool:
    try:
        affine_reflection(u, 0, u)
    except InvalidInput:
        return False
    return True


@claim("def-14", "Section 2.4, Definition 14", RESULT, to_state=["def-10", "def-13"])
def definition_14(printed: Constants) -> Finding:
    """The reflection in the hyperplane of r and k takes from x the coroot of r, times the product of x and
    r less k, times {coefficient}."""
    r, k, x = (1, 2), 3, (5, 7)
    moved = affine_reflection(r, k, x)[0] - x[0]
    level = sum(a * b for a, b in zip(r, x, strict=True)) - k
    coroot = Fraction(2 * r[0], sum(a * a for a in r))
    return agree(
        printed, {"coefficient": int(-moved / (level * coroot))}, EVERY_D,
        "$\\langle\\sigma_{r,k}(x),r\\rangle-k=-(\\langle x,r\\rangle-k)$, as r has the product 2 with its "
        "coroot, and points of the hyperplane stay where they are.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _translations() -> tuple[bool, str]:
    """Whether reflections keep the lattice of translations, and which vectors the translations are."""
    kept, which = True, {"roots", "coroots"}
    for s in systems(4):
        x = tuple(Fraction(3 * i + 1) for i in range(s.simple_roots.shape[1]))
        lattice = coroot_lattice(s)
        for r, coroot in zip(s.roots.rows(), s.coroots.rows(), strict=True):
            image = affine_reflection(r, 1, affine_reflection(r, 0, x))
            shift = tuple(a - b for a, b in zip(image, x, strict=True))
            which -= {name for name, v in (("roots", r), ("coroots", coroot)) if v != shift}
            kept &= all(affine_reflection(r, 0, v) in lattice for v in lattice.basis.rows())
    return kept, ", ".join(sorted(which))


@claim("prop-3", "Section 2.4, Proposition 3", RESULT, to_state=["def-11", "def-14"])
def proposition_3(printed: Constants) -> Finding:
    """The translations by integer combinations of the {translations} are a normal subgroup of the affine
    Weyl group, which is their semidirect product with the Weyl group."""
    normal, which = _translations()
    return agree(
        printed, {"normal": normal, "translations": which}, EVERY_D,
        "$\\sigma_{r,k}$ is $\\sigma_r$ followed by the translation by $k\\,r^\\vee$, so translations by "
        "coroots and the Weyl group generate the affine one.",
        "$w\\,t_v\\,w^{-1}=t_{wv}$, and w permutes the coroots: the subgroup is normal. The Weyl group "
        "fixes 0, a translation other than the identity does not.",
        "Computed up to rank 4.",
    )  # fmt: skip


# -- alcoves ----------------------------------------------------------------------------------------------


def _neighbours(t: CoxeterTriangulation) -> list[list[tuple[Fraction, ...]]]:
    """The mirror images of the fundamental simplex in its facets."""
    return [[f.reflect(v) for v in t.simplex.vertex_matrix.rows()] for f in t.facets]


@lru_cache(maxsize=4)
def _congruent(low: int, high: int) -> bool:
    """Whether the neighbours of the fundamental simplex have its edges, for the types of some dimensions."""
    return all(
        Simplex(vertices).squared_edge_lengths == t.simplex.squared_edge_lengths
        for t in all_types(high)
        if t.dimension >= low
        for vertices in _neighbours(t)
    )


@claim("sec2.similar-regions", "Section 2.4", RESULT, to_state=["def-14"])
def similar_regions(printed: Constants) -> Finding:
    """In the plane the open regions between the hyperplanes are similar triangles."""
    return agree(
        printed, {"similar": _congruent(2, 2)}, EVERY_D,
        "They are even congruent: each is a mirror image of its neighbours.",
    )  # fmt: skip


@lru_cache(maxsize=16)
def _levels(t: CoxeterTriangulation) -> tuple[tuple[Fraction, Fraction], ...]:
    """For each positive root its least and its greatest product with a vertex of the fundamental simplex."""
    products = t.simplex.vertex_matrix @ t.roots.positive_roots.T
    columns = zip(products.numerators.min(axis=0), products.numerators.max(axis=0), strict=True)
    return tuple(
        (Fraction(int(a), products.denominator), Fraction(int(b), products.denominator)) for a, b in columns
    )


@claim("def-15.inequalities", "Section 2.4, Definition 15", RESULT, to_state=["def-14"])
def inequalities(printed: Constants) -> Finding:
    """An alcove, a component of what the hyperplanes leave of space, is given by inequalities: for each
    positive root the product lies between an integer and that integer plus {width}."""
    width = max(b - a for t in all_types(6) for a, b in _levels(t))
    return agree(
        printed, {"width": int(width)}, EVERY_D,
        "The product with a root takes no integer value on a component. Conversely a set that is given by "
        "such inequalities is convex and meets no hyperplane; not for all integers it is non-empty.",
        "Computed up to d = 6: on the fundamental simplex the products of a root differ by 1 at most.",
    )  # fmt: skip


@claim("def-15.fundamental", "Section 2.4, after Definition 15", RESULT, to_state=["def-15.inequalities"])
def fundamental_alcove(printed: Constants) -> Finding:
    """The fundamental alcove is where all positive roots have products between {lower} and {upper}."""
    levels = [x for t in all_types(6) for x in _levels(t)]
    return agree(
        printed, {"lower": int(min(a for a, _ in levels)), "upper": int(max(b for _, b in levels))}, EVERY_D,
        "It is not empty: a vector with positive products with the simple roots, made short enough, lies "
        "in it. Computed up to d = 6 at the vertices of the fundamental simplex.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _redundant() -> dict[str, tuple[int, int]]:
    """Type -> how many inequalities define the alcove, and how many of them are needed."""
    return {t.name: (2 * len(t.roots.positive_root_coordinates), len(t.facets)) for t in all_types(8)}


@claim("sec2.redundant", "Section 2.4", WORDING, to_state=["def-15.fundamental"], to_prove=["prop-5"])
def redundant(printed: Constants) -> Finding:
    """Of the inequalities that say what the fundamental alcove is, most can be left out."""
    halves = [name for name, (n, needed) in _redundant().items() if 2 * needed == n]
    return agree(
        printed, {"most": all(2 * needed <= n for n, needed in _redundant().values())}, EVERY_D,
        "Two for each positive root, and d + 1 are needed. There are at least $\\frac{d(d+1)}2$ positive "
        f"roots, so that at most the share $\\frac1d$ is needed: just a half in {', '.join(halves)}, less "
        "in all other types with d ≥ 2.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _has_maximum() -> bool:
    return all(bool((s.positive_root_coordinates <= list(s.marks)).all()) for s in systems(8))


@claim("prop-4", "Section 2.4, Proposition 4", RESULT, to_state=["def-6.order"])
def proposition_4(printed: Constants) -> Finding:
    """The positive roots have a maximum for the partial order, the highest root."""
    return quoted(
        agree(
            printed,
            {"maximum": _has_maximum()},
            LITERATURE,
            "A reducible system has one for each part, and no maximum: irreducibility, which is assumed "
            "throughout, is needed.",
        ),
        "Humphreys, Section 2.9.",
        "In all types up to rank 8 no coefficient of a root exceeds that of the highest one.",
    )


@lru_cache(maxsize=1)
def _walls() -> tuple[dict[int, Fraction], dict[int, Fraction], Fraction]:
    """d -> how many facets there are, how many of them contain 0; the product of the highest root on the
    other."""
    facets, central, levels = {}, {}, set()
    for t in all_types(8):
        u = t.simplex.vertex_matrix
        facets[t.dimension] = Fraction(len(t.facets))
        central[t.dimension] = Fraction(sum(f.level(u.row(0)) == 0 for f in t.facets))
        top = (u @ RationalMatrix.from_rows([[x] for x in t.roots.highest_root])).T.row(0)
        levels |= set(top[1:])
    return facets, central, levels.pop() if len(levels) == 1 else Fraction(0)


@claim("prop-5", "Section 2.4, Proposition 5", RESULT, to_state=["def-15.fundamental"], to_prove=["prop-4"])
def proposition_5(printed: Constants) -> Finding:
    """The fundamental alcove is an open simplex between {hyperplanes} hyperplanes: those of the
    {through_the_origin} simple roots through the origin, and the one where the highest root has the product
    {level}."""
    facets, central, level = _walls()
    true = {
        "hyperplanes": fits(printed["hyperplanes"], "d + 1", facets),
        "through_the_origin": fits(printed["through_the_origin"], "d", central),
        "level": int(level),
    }
    return agree(
        printed, true, EVERY_D,
        "Let x have positive products with the simple roots, and one less than 1 with $\\tilde s=\\sum "
        "m_is_i$. A positive root $r=\\sum c_is_i$ has $0\\le c_i\\le m_i$ by Proposition 4, so "
        "$0<\\langle x,r\\rangle\\le\\langle x,\\tilde s\\rangle<1$: the other inequalities are redundant.",
        "The simple roots are a basis of the span, and all $m_i$ are positive: there it is a simplex, with "
        "the vertices 0 and $\\omega_i/m_i$. Computed up to d = 8.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _folds_to_itself() -> bool:
    """Whether images of a point of the simplex, on a facet or inside, fold back to that very point."""
    for t in all_types(4):
        n = t.dimension + 1
        for weights in ([Fraction(1, n)] * n, [Fraction(2 * i, n * (n - 1)) for i in range(n)]):
            point = tuple(Fraction(x) for x in t.simplex.point(weights))  # type: ignore[arg-type]
            for word in ((0, 1), (1, 0, 2, 0), (2, 1, 0)):
                if t.fold(t.unfold(word, point)).point != point:
                    return False
    return True


@claim("def-16", "Section 2.4, Definition 16", RESULT, to_state=["prop-5"])
def definition_16(printed: Constants) -> Finding:
    """The closure of the fundamental alcove, a full-dimensional simplex with {vertices} vertices, is called
    a fundamental domain."""
    vertices = {t.dimension: Fraction(t.simplex.edge_gram.rank() + 1) for t in all_types(8)}
    true = {"vertices": fits(printed["vertices"], "d + 1", vertices), "fundamental": _folds_to_itself()}
    return agree(
        printed, true, EVERY_D,
        "It meets each orbit of the affine Weyl group, by Proposition 6; and only once. Let w carry x to "
        "y, both in the simplex F. If w is not the identity, a facet of F separates F from wF; y lies in "
        "both, so in that facet, and its reflection s fixes y. Then sw carries x to y, and fewer "
        "hyperplanes separate F from swF. So in the end x = y.",
        "Computed up to d = 4: images of points of the simplex, on its boundary too, are carried back to "
        "those very points.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _volumes_agree() -> bool:
    return all(
        t.simplex.volume * t.roots.weyl_group_order == sqrt(coroot_lattice(t.roots).gram_determinant)
        for t in all_types(8)
    )


@claim("prop-6", "Section 2.4, Proposition 6", RESULT, to_state=["def-15.inequalities"])
def proposition_6(printed: Constants) -> Finding:
    """For any two alcoves just one element of the affine Weyl group carries one to the other."""
    return quoted(
        agree(printed, {"simply_transitive": _volumes_agree()}, LITERATURE),
        "Humphreys, Sections 4.3 (transitive) and 4.5 (simply).",
        "The volume of the alcove times the order of the Weyl group is that of a cell of the coroot "
        "lattice, for all types up to d = 8, as Proposition 3 then demands.",
    )


@claim("sec2.monohedral", "Section 2.4, after Proposition 6", RESULT, to_prove=["prop-6"])
def monohedral(printed: Constants) -> Finding:
    """All alcoves are similar to the fundamental one, and their closures are the simplices of a monohedral
    triangulation."""
    return agree(
        printed, {"congruent": _congruent(2, 3)}, EVERY_D,
        "They are congruent: images of one under reflections. Transitivity is enough.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _face_to_face() -> bool:
    """Whether a simplex and its mirror image in a facet share all vertices of that facet, and no other."""
    return all(
        (f.reflect(v) == v) == (k != f.index)
        for t in all_types(6)
        for f in t.facets
        for k, v in enumerate(t.simplex.vertex_matrix.rows())
    )


@claim("cor-1", "Section 2.4, Corollary 1", RESULT, to_state=["def-14"], to_prove=["prop-5", "prop-6"])
def corollary_1(printed: Constants) -> Finding:
    """The hyperplanes cut space into a triangulation."""
    return agree(
        printed, {"triangulation": _face_to_face()}, EVERY_D,
        "There are finitely many directions of hyperplanes, equally spaced in each: the arrangement is "
        "locally finite. The closed cells of such an arrangement meet in common faces, as a face is where "
        "some of the inequalities are equations.",
        "The cells are simplices, by Propositions 5 and 6. This needs that the roots are irreducible, as "
        "is assumed, and the span of the roots in place of a larger space. Computed up to d = 6.",
    )  # fmt: skip


# -- classification ---------------------------------------------------------------------------------------


@claim("def-17", "Section 2.4, Definition 17", WORDING, to_state=["def-8", "prop-4"])
def definition_17(printed: Constants) -> Finding:
    """From rank {from_rank} on, simple roots and minus the highest root have a diagram with the labels of
    Definition 8."""
    parallel = {
        s.rank
        for s in systems(8)
        for i, row in s.affine_neighbours.items()
        for j, n in row.items()
        if n * s.affine_neighbours[j][i] == 4
    }
    finding = agree(
        printed, {"from_rank": max(parallel) + 1}, EVERY_D,
        "$4\\cos^2\\varphi=4$ for two of these roots means that one is a negative multiple of the other; "
        "as the highest root is a sum with all coefficients positive, that happens only with a single "
        "simple root. Computed up to rank 8.",
    )  # fmt: skip
    why = (
        "For $A_1$ the two roots are opposite and their walls parallel, so that the edge of $\\tilde A_1$ "
        "needs the label ∞, which Definition 8 does not have"
    )
    return explained(finding, why)


@lru_cache(maxsize=1)
def _affine_families() -> tuple[str, ...]:
    """The families of the diagrams that are semidefinite but not definite: trees, and cycles without
    labels."""
    import networkx as nx

    names = {*names_of_trees(5, (3, 4, 6))[0], *names_of_trees(9, (3,))[0]}
    names |= {name_of(nx.cycle_graph(n), affine=True) for n in range(3, 10)}
    return tuple(sorted({family_of(name) for name in names}))


@claim("thm-4", "Section 2.4, Theorem 4", RESULT, to_state=["def-17"], to_prove=["thm-2"])
def theorem_4(printed: Constants) -> Finding:
    """The affine Weyl groups and their diagrams are those of {types}, with a tilde."""
    finding = agree(
        printed, {"types": _affine_families()}, EVERY_D,
        "For d ≥ 2. The roots of the nodes have one relation, $s_0+\\sum m_is_i=0$ with positive "
        "coefficients, so the form is semidefinite and each part of the diagram is definite.",
        "A connected diagram that is not definite contains one of the list, by the proof of Theorem 2; if "
        "it is more than that one, the form is negative somewhere: lower the form 0 of the vector on the "
        "part by an edge that leads out of it, or by a larger label. So the semidefinite ones are those of "
        "the list, and each comes from the root system of its name.",
        "Computed: all trees with labels 3, 4, 6 and up to five nodes, without labels up to nine, and "
        "cycles up to nine.",
    )  # fmt: skip
    table = tuple(sorted({x.family for x in paper().points if x.place == "Table 1"}))
    if finding.verdict is Verdict.HOLDS or printed["types"] != ("F4", "G2") or table != _affine_families():
        return finding
    return damaged(
        EVERY_D, finding.correction,
        f"Table 1 and Section 6 have all of {', '.join(table)}; the list consists of drawings, of which "
        "our copy has kept two.",
        constants=finding.constants, derivation=finding.derivation,
    )  # fmt: skip


def _path_labels(name: str, printed: object) -> tuple[int, ...]:
    """The labels along an affine diagram that is a path; from the end from which they are printed, if from
    either."""
    graph = diagrams.affine_diagram(root_system(name))
    line = diagrams.main_line(graph)
    labels = tuple(graph.edges[a, b]["m"] for a, b in pairwise(line))
    return labels[::-1] if printed == labels[::-1] else labels


@claim("thm-4.F4", "Section 2.4, Theorem 4", RESULT, to_state=["def-17"])
def affine_f4(printed: Constants) -> Finding:
    """The diagram of the triangulation of type F~4 is a path with the labels {labels}."""
    return agree(printed, {"labels": _path_labels("F4", printed["labels"])}, FINITE, "Computed.")


@claim("thm-4.G2", "Section 2.4, Theorem 4", RESULT, to_state=["def-17"])
def affine_g2(printed: Constants) -> Finding:
    """The diagram of the triangulation of type G~2 is a path with the labels {labels}."""
    return agree(printed, {"labels": _path_labels("G2", printed["labels"])}, FINITE, "Computed.")


# -- figures and remarks ----------------------------------------------------------------------------------


@claim("fig-2.plane", "Section 2.4, Figure 2", RESULT, to_prove=["thm-4"])
def figure_2_plane(printed: Constants) -> Finding:
    """There are {triangulations} Coxeter triangulations of the plane."""
    names = [t.name for t in all_types(2)]
    return agree(
        printed,
        {"triangulations": len(names)},
        FINITE,
        f"{', '.join(names)}; $\\tilde B_2$ is $\\tilde C_2$.",
    )


KINDS = ("vertices", "centres of edges", "centres of faces", "centre of the cube")
"""What points with coordinates 0, 1, 2 are in a cube, by the number of their ones."""


@lru_cache(maxsize=1)
def _places() -> tuple[tuple[str, tuple[str, ...]], ...]:
    """The simplices of dimension 3, and at which places of a cube the vertices of a similar copy can lie."""
    found = []
    for t in (t for t in all_types(3) if t.dimension == 3):
        squares = t.simplex.squared_edge_lengths.numerators
        copies = [c for p, q in permutations(GRID, 2) for c in _extended((p, q), squares)]
        least = min(_distance(c[0], c[1]) for c in copies)
        kinds = (sorted({x.count(1) for x in c}) for c in copies if _distance(c[0], c[1]) == least)
        found.append((t.name, tuple(KINDS[k] for k in max(kinds, key=len))))
    return tuple(found)


GRID = tuple(product(range(3), repeat=3))
Place = tuple[int, ...]


def _distance(p: Place, q: Place) -> int:
    return sum((a - b) ** 2 for a, b in zip(p, q, strict=True))


def _extended(chosen: tuple[Place, ...], squares: np.ndarray) -> Iterator[tuple[Place, ...]]:
    """All similar copies, in the grid, of a simplex with given squared edges that begin with some
    vertices."""
    k, scale = len(chosen), _distance(chosen[0], chosen[1])
    if k == len(squares):
        yield chosen
        return
    for x in GRID:
        if all(_distance(x, p) * squares[0, 1] == scale * squares[i, k] for i, p in enumerate(chosen)):
            yield from _extended((*chosen, x), squares)


@claim("fig-2.space", "Section 2.4, Figure 2", RESULT, to_prove=["thm-4"])
def figure_2_space(printed: Constants) -> Finding:
    """The simplices of the {simplices} Coxeter triangulations of space have their vertices at these places
    of a cube: {places}."""
    used = {place for _, places in _places() for place in places}
    true = {"simplices": len(_places()), "places": tuple(place for place in KINDS if place in used)}
    each = [f"{name}: {', '.join(places)}" for name, places in _places()]
    return agree(
        printed, true, FINITE,
        f"Found by trying all similar copies in a cube: {'; '.join(each)}.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _angles() -> dict[Fraction, tuple[str, ...]]:
    """Each dihedral angle as a multiple of π, and where it occurs, up to d = 12."""
    of = {0: Fraction(1, 2), 1: Fraction(1, 3), 2: Fraction(1, 4), 3: Fraction(1, 6)}
    found: dict[Fraction, list[str]] = {}
    for t in map(triangulation, triangulations_up_to(12)):
        n = t.roots.affine_neighbours
        for angle in {
            of[n[i].get(j, 0) * n[j].get(i, 0)] for i, j in combinations(range(t.dimension + 1), 2)
        }:
            found.setdefault(angle, []).append(t.name)
    return {angle: tuple(names) for angle, names in sorted(found.items(), reverse=True)}


@claim("rem-3", "Section 2.4, Remark 3", RESULT, to_state=["def-16"], to_prove=["thm-4"])
def remark_3(printed: Constants) -> Finding:
    """The dihedral angles of the simplices of Coxeter triangulations are among {angles}, times π."""
    attained = "; ".join(f"{angle}: first in {names[0]}" for angle, names in _angles().items())
    return agree(
        printed, {"angles": tuple(map(str, _angles()))}, EVERY_D,
        "They are $\\pi/m$ with the labels m = 2 (no edge), 3, 4, 6 of the affine diagrams, by Theorem 4.",
        f"All are attained, as multiples of π: {attained}. The last one occurs in $\\tilde G_2$ only. "
        "Computed up to d = 12.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _drawn() -> Monohedral:
    return monohedral_not_coxeter().data


@lru_cache(maxsize=1)
def _figure_3() -> dict[str, bool]:
    """What is true of the triangulation in Figure 3, in the part of the plane that is drawn."""
    data = _drawn()
    shapes = {tuple(sorted(_squared(p, q) for p, q in combinations(x, 2))) for x in data.triangles}
    return {
        "congruent": shapes == {data.squared_edges},
        "mirror_images": data.neighbours == data.mirror_images,
        "arrangement": min(data.witness.barycentric) <= 0,
    }


def _squared(p: tuple[Fraction, ...], q: tuple[Fraction, ...]) -> Fraction:
    return sum(((a - b) ** 2 for a, b in zip(p, q, strict=True)), Fraction(0))


@claim("fig-3", "Section 2.4, Figure 3", RESULT, to_state=["def-1"])
def figure_3(printed: Constants) -> Finding:
    """A triangulation of the plane by congruent triangles that are mirror images of their neighbours need
    not be a Coxeter triangulation."""
    data = _drawn()
    angles = ", ".join(f"{180 * angle}°" for angle in data.angles)
    return agree(
        printed, _figure_3(), FINITE,
        f"Each triangle of $\\tilde A_2$ is cut from its centre into three, with the angles {angles}. Of "
        f"{len(data.neighbours)} pairs of neighbours {len(data.mirror_images)} are mirror images.",
        "It is no arrangement: the line through an edge that ends in a centre goes on inside a triangle, "
        f"to the point with the barycentric coordinates {', '.join(map(str, data.witness.barycentric))}.",
    )  # fmt: skip


@claim("rem-4", "Section 2.4, Remark 4", RESULT, to_state=["def-1"], to_prove=["fig-3"])
def remark_4(printed: Constants) -> Finding:
    """Without the condition that Coxeter triangulations are hyperplane arrangements there would be more of
    them."""
    facts = _figure_3()
    more = facts["congruent"] and facts["mirror_images"] and not facts["arrangement"]
    return agree(printed, {"more": more}, FINITE, "The triangulation of Figure 3 is one.")
