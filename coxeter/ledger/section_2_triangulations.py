"""Section 2.4: which Coxeter triangulations there are, with the figures and remarks."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise, permutations, product

import numpy as np

from .. import diagrams
from ..figures import monohedral_not_coxeter
from ..figures.monohedral import Monohedral
from ..paper import printed as paper
from ..roots import root_system
from .claim import Constants, Finding, agree, claim, damaged
from .instances import all_types, dihedral_angles, systems
from .section_2_trees import family_of, name_of, names_of_trees
from .vectors import squared_edges
from .vocabulary import EVERY_D, FINITE, Verdict, Weight
from .wording import explained

RESULT, WORDING = Weight.RESULT, Weight.WORDING


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
    """There are {triangulations:words} Coxeter triangulations of the plane."""
    names = [t.name for t in all_types(2)]
    return agree(
        printed,
        {"triangulations": len(names)},
        FINITE,
        f"{', '.join(names)}; $\\tilde B_2$ is $\\tilde C_2$.",
    )


KINDS = ("vertices", "centres of edges", "centres of faces", "centre of the cube")
"""What points with coordinates 0, 1, 2 are in a cube, by the number of their ones."""

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


@claim("fig-2.space", "Section 2.4, Figure 2", RESULT, to_prove=["thm-4"])
def figure_2_space(printed: Constants) -> Finding:
    """The simplices of the {simplices:words} Coxeter triangulations of space have their vertices at the
    following places of a cube: {places}."""
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
    found: dict[Fraction, list[str]] = {}
    for t in all_types(12):
        for angle in dihedral_angles(t):
            found.setdefault(angle, []).append(t.name)
    return {angle: tuple(names) for angle, names in sorted(found.items(), reverse=True)}


@claim("rem-3", "Section 2.4, Remark 3", RESULT, to_state=["def-16"], to_prove=["thm-4"])
def remark_3(printed: Constants) -> Finding:
    """The dihedral angles of the simplices of Coxeter triangulations are among {angles:pi}."""
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
    shapes = {squared_edges(x) for x in data.triangles}
    return {
        "congruent": shapes == {data.squared_edges},
        "mirror_images": data.neighbours == data.mirror_images,
        "arrangement": min(data.witness.barycentric) <= 0,
    }


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
