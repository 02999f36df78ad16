"""Sections 2.2 and 2.3: the classification of root systems, their simple roots, and their lattices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from itertools import product
from typing import Any

from .. import diagrams
from ..affine import affine_reflection, triangulation
from ..errors import CoxeterError, InvalidInput
from ..exact import RationalMatrix, show
from ..figures import root_system_plane
from ..names import FAMILIES, triangulations_up_to
from ..root_lattices import coroot_lattice, coweight_lattice, root_lattice, weight_lattice
from ..root_sets import cartan_integer, coroots, is_irreducible, is_reduced, is_root_system
from ..roots import RootSystem, root_system
from .claim import Constants, Finding, agree, claim, damaged
from .section_1 import explained, fits
from .section_2 import family_of, name_of, names_of_trees, systems
from .vocabulary import EVERY_D, FINITE, Verdict, Weight

RESULT, WORDING = Weight.RESULT, Weight.WORDING

# -- classification ---------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _families() -> tuple[str, ...]:
    """The families of the definite trees, with labels up to five nodes, without labels up to nine."""
    names = {*names_of_trees(5, (3, 4, 6))[1], *names_of_trees(9, (3,))[1]}
    return tuple(sorted({family_of(name) for name in names}))


@claim("thm-2", "Section 2.2, Theorem 2", RESULT, to_state=["def-8"], to_prove=["sec2.definite-graphs"])
def theorem_2(printed: Constants) -> Finding:
    """The Coxeter diagrams of crystallographic, reduced, irreducible root systems are those of {types},
    $B_d$ standing for $C_d$ too."""
    finding = agree(
        printed, {"types": _families()}, EVERY_D,
        "The form with $-2\\cos\\frac\\pi m$ for an edge with label m is that of the simple roots, scaled "
        "to length $\\sqrt2$: it is positive definite. As for graphs without labels, no diagram can "
        "contain, with labels at least as large, one that has a vector with coordinates $\\ge0$ and form 0.",
        "The affine diagrams have such vectors, the marks times the lengths. $\\tilde A$ excludes cycles; "
        "$\\tilde G_2$ any other edge beside a label 6; $\\tilde C$ two labels 4; $\\tilde B$ a label 4 "
        "and a branch. What is left with a label 4 is a path. If the edge is not at its end, $\\tilde F_4$ "
        "leaves only the path 3, 4, 3. Without labels: Section 2.1.",
        "All these occur, by Theorem 3. Computed: all trees with labels 3, 4, 6 and up to five nodes.",
    )  # fmt: skip
    if finding.verdict is Verdict.HOLDS or printed["types"] != tuple(x for x in _families() if x != "F4"):
        return finding
    return damaged(
        EVERY_D, "$F_4$ belongs on the list.",
        "Theorem 3 has the simple roots of $F_4$, Theorem 4 and Section 6 have $\\tilde F_4$; between the "
        "drawings of $B_d$ and $G_2$ our copy has an empty line.",
        constants=finding.constants, derivation=finding.derivation,
    )  # fmt: skip


@claim("thm-2.drawings", "Section 2.2, Theorem 2", RESULT, to_state=["def-8"])
def drawings(printed: Constants) -> Finding:
    """The diagram of $B_d$ is a path with the label {B} at one end, that of $G_2$ an edge with the label
    {G2}."""
    ends = set()
    for system in systems(8, "B"):
        graph = diagrams.coxeter_diagram(system)
        labels = [graph.edges[i, i + 1]["m"] for i in range(1, system.rank)]
        ends.add(labels[-1] if labels[:-1] == [3] * (system.rank - 2) else 0)
    (edge,) = diagrams.coxeter_diagram(root_system("G2")).edges(data="m")
    return agree(printed, {"B": ends.pop(), "G2": edge[2]}, EVERY_D, "Computed up to rank 8.")


@claim("thm-2.dual", "Section 2.2, after Theorem 2", RESULT, to_state=["def-10", "thm-3.C"])
def dual_of_b(printed: Constants) -> Finding:
    """The root system $C_d$ is the dual of $B_d$, with the same diagram and the same Weyl group."""
    pairs = [(root_system(("B", d)), root_system(("C", d))) for d in range(2, 9)]
    dual = all(set(b.coroots.rows()) == set(c.roots.rows()) for b, c in pairs)
    simple = all(coroots(b.simple_roots) == c.simple_roots for b, c in pairs)
    same = all(name_of(diagrams.coxeter_diagram(c), affine=False) == b.name for b, c in pairs)
    return agree(
        printed, {"dual": dual, "same_group": dual and simple and same}, EVERY_D,
        "The coroot of $e_d$ is $2e_d$, and the other simple roots are their own coroots. A root and its "
        "coroot have the same reflection. Computed up to rank 8.",
    )  # fmt: skip


# -- Theorem 3 --------------------------------------------------------------------------------------------


def _text(x: Fraction) -> int | str:
    return int(x) if x.denominator == 1 else str(x)


@lru_cache(maxsize=16)
def _simple_roots(family: str) -> dict[str, Any]:
    """The simple roots in the form in which they are printed, after a test that they are of their type."""
    members = [s for s in systems(12) if s.type.family == family]
    for system in members:
        lengths = system.squared_lengths
        name = name_of(diagrams.coxeter_diagram(system), affine=False)
        gram = system.simple_roots @ system.simple_roots.T
        acute = any(gram[i, j] > 0 for i in range(system.rank) for j in range(i))
        last_is_long = lengths[-1] == max(lengths) and len(set(lengths)) > 1
        expected = family if family != "C" else "B"
        if acute or family_of(name) not in (expected, "A" if system.rank == 1 else expected):
            raise CoxeterError(f"the simple roots of {system.name} are not of their type")
        if family in "BC" and last_is_long != (family == "C"):
            raise CoxeterError(f"the simple roots of {system.name} have the lengths of another type")
    if family not in "ABCD":
        (system,) = members
        return {f"s{k}": tuple(map(_text, row)) for k, row in enumerate(system.simple_roots.rows(), 1)}
    return _pattern(family, members)


def _pattern(family: str, members: list[RootSystem]) -> dict[str, Any]:
    """The pattern $s_k=ae_k+be_{k+1}$, and the last root, that all members of a family follow."""
    chains, lasts, spaces = set(), set(), {}
    for s in (s for s in members if s.rank > 1):
        rows = s.simple_roots.rows()
        spaces[s.rank] = Fraction(s.simple_roots.shape[1])
        for k, row in enumerate(rows if family == "A" else rows[:-1]):
            chains.add(tuple(map(_text, row[k : k + 2])) if sum(map(bool, row)) == 2 else ())
        lasts.add(tuple(map(_text, rows[-1][-2:])) if not any(rows[-1][:-2]) else ())
    found: dict[str, Any] = {"chain": chains.pop() if len(chains) == 1 else ()}
    if family != "A":
        found["last"] = lasts.pop() if len(lasts) == 1 else ()
    return found | {
        "space": fits("d + 1" if family == "A" else "d", "d + 1" if family == "A" else "d", spaces)
    }


def simple_root_set(family: str, printed: Constants) -> Finding:
    """Judge the simple roots of one type in Theorem 3."""
    if family in "ABCD":
        line = (
            "Roots that follow each other in the path have the product -1, others of the path 0, for every "
            "d. The last root has a product with the last of the path only; for $D_d$ with the last but "
            "one. Tested as to their diagram up to d = 12."
        )
        return agree(printed, _simple_roots(family), EVERY_D, line)
    line = "Their products and lengths give the diagram of the type. Compared with those that Section 6 uses."
    return agree(printed, _simple_roots(family), FINITE, line)


def _set_check(family: str) -> Callable[[Constants], Finding]:
    def check(printed: Constants) -> Finding:
        return simple_root_set(family, printed)

    check.__name__ = "simple_root_set"
    if family in "ABCD":
        last = "" if family == "A" else ", and the last one has the last two coordinates ({last})"
        check.__doc__ = (
            f"$\\mathbf {family}_d$ has simple roots in dimension {{space}}: $s_k$ has the coordinates "
            f"({{chain}}) at k and k + 1, else 0{last}."
        )
    else:
        rows = "; ".join(f"$s_{k}$ = ({{s{k}}})" for k in range(1, int(family[1:]) + 1))
        check.__doc__ = f"$\\mathbf{{{family[0]}}}_{family[1:]}$ has the simple roots {rows}."
    return check


for _family in FAMILIES:
    _place = f"Section 2.2, Theorem 3, {_family}"
    claim(f"thm-3.{_family}", _place, RESULT, to_state=["def-5"])(_set_check(_family))


@lru_cache(maxsize=1)
def _complete() -> tuple[str, ...]:
    """The families, with a second one where long and short roots can be exchanged, and not by a reversal."""
    second = []
    for name in ("B4", "F4", "G2"):
        lengths = root_system(name).squared_lengths
        exchanged = tuple(max(lengths) if x == min(lengths) else min(lengths) for x in lengths)
        second += [name] if exchanged[::-1] != lengths else []
    return tuple(sorted({*_families(), *("C" for name in second if name == "B4")}))


@claim("thm-3", "Section 2.2, Theorem 3", RESULT, to_state=["def-5"], to_prove=["thm-2"])
def theorem_3(printed: Constants) -> Finding:
    """Up to scale, rotation and order the sets of simple roots are those of {types}."""
    for family in printed["types"]:
        if family in FAMILIES:
            _simple_roots(family)
    return agree(
        printed, {"types": _complete()}, EVERY_D,
        "A set of simple roots is known, up to scale and isometry, from the diagram and the lengths: an "
        "edge with label 3 joins equal lengths, with label 4 and 6 lengths in the ratio $\\sqrt2$ and "
        "$\\sqrt3$. Without labels nothing is left to choose. With one, either side of the edge can be "
        "long: for $F_4$, $G_2$ (and $B_2$) a reversal of the path exchanges both, for $B_d$ the two "
        "choices are $B_d$ and $C_d$.",
        "In small ranks some coincide: $B_2$ and $C_2$, $A_3$ and what would be $D_3$.",
    )  # fmt: skip


# -- lattices ---------------------------------------------------------------------------------------------


@claim("def-9", "Section 2.3, Definition 9", RESULT, to_state=["def-4"], to_prove=["def-6.integers"])
def definition_9(printed: Constants) -> Finding:
    """The integer combinations of the roots are a lattice."""
    true = all(r in root_lattice(s) for s in systems(4) for r in s.roots.rows())
    return agree(
        printed, {"lattice": true}, EVERY_D,
        "They are those of the simple roots, which are linearly independent. Without the crystallographic "
        "property they may be dense: in the system of ten roots of a pentagon, with the golden ratio.",
        "Computed: all roots lie in the lattice of the simple ones, up to rank 4.",
    )  # fmt: skip


@claim("def-9.lattice", "Section 2.3, after Definition 9", RESULT, to_state=["def-9"])
def lattice_properties(printed: Constants) -> Finding:
    """The root lattice is a group, contains a basis of a space of dimension {rank}, and meets bounded
    regions in finitely many points."""
    ranks = {s.rank: Fraction(s.simple_roots.rank()) for s in systems(8)}
    discrete = all(root_lattice(s).gram_determinant > 0 for s in systems(8))
    return agree(
        printed, {"rank": fits(printed["rank"], "d", ranks), "discrete": discrete}, EVERY_D,
        "The space is the span of the roots, as in Definition 4. A basis makes the lattice an image of "
        "$\\mathbb Z^d$ under an invertible map.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _coroot_factor() -> set[Fraction]:
    """The factors f for which <s, f·r/<r, r>> is the Cartan integer n(s, r), over all roots of G2."""
    found = set()
    for r, s in product(root_system("G2").roots.rows(), repeat=2):
        inner = sum((a * b for a, b in zip(r, s, strict=True)), Fraction(0))
        if inner:
            found.add(cartan_integer(s, r) * sum(a * a for a in r) / inner)
    return found


@claim("def-10", "Section 2.3, Definition 10", WORDING, to_state=["def-4"])
def definition_10(printed: Constants) -> Finding:
    """The coroot of a root r is r over its product with itself, times {factor}."""
    (factor,) = _coroot_factor()
    return agree(
        printed, {"factor": int(factor)}, EVERY_D,
        "A definition. With this factor the product of s with the coroot of r is the Cartan integer n(s, r).",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _dual_systems() -> bool:
    duals = [s.coroots for s in systems(4)]
    return all(is_root_system(x) and is_reduced(x) and is_irreducible(x) for x in duals)


@claim("def-10.root-system", "Section 2.3, Definition 10", RESULT, to_state=["def-10"])
def dual_root_system(printed: Constants) -> Finding:
    """The coroots form a root system."""
    return agree(
        printed, {"root_system": _dual_systems()}, EVERY_D,
        "r and its coroot have the same reflection, which keeps lengths, so "
        "$\\sigma_r(s^\\vee)=(\\sigma_rs)^\\vee$. The Cartan integers are those of the roots with r and s "
        "exchanged. Parallel and orthogonal pairs stay so.",
        "Computed up to rank 4: they are reduced and irreducible too.",
    )  # fmt: skip


@claim("fig-1", "Section 2.3, Figure 1", RESULT, to_state=["def-4", "def-14"], to_prove=["thm-2"])
def figure_1(printed: Constants) -> Finding:
    """There are {systems} root systems in the plane; the hyperplanes cut it into figures with
    {alcove_sides} sides."""
    pairs = {frozenset((a, b)) for a in range(-3, 0) for b in range(-3, 0) if a * b < 4}
    rank_2 = [s for s in systems(2) if s.rank == 2]
    found = {frozenset((int(s.cartan_matrix[0, 1]), int(s.cartan_matrix[1, 0]))) for s in rank_2}
    sides = {len(triangulation(k).facets) for k in triangulations_up_to(2)}
    return agree(
        printed, {"systems": len(pairs & found) if pairs == found else 0, "alcove_sides": max(sides)}, FINITE,
        "Two simple roots have negative Cartan integers with product 1, 2 or 3: $A_2$, $B_2$ (the same as "
        "$C_2$), $G_2$.",
        "In each the fundamental domain is the triangle between the walls of the simple roots and that of "
        "the highest root.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _dual_figures() -> bool:
    """Whether the drawings of the coroots are on the same lines, and show the dual root systems."""
    same = True
    for name, dual in (("A2", "A2"), ("B2", "C2"), ("G2", "")):
        above, below = root_system_plane(name).data, root_system_plane(name, dual=True).data
        same &= above.lines == below.lines and above.domain == below.domain and is_root_system(below.vectors)
        same &= set(below.vectors) == set(root_system(name).coroots.rows())
        same &= not dual or set(below.vectors) == set(root_system(dual).roots.rows())
    return same


@claim("fig-1.dual", "Section 2.3, Figure 1", RESULT, to_state=["def-10", "fig-1"])
def figure_1_dual(printed: Constants) -> Finding:
    """The dual root systems are drawn on the same hyperplanes."""
    return agree(
        printed, {"same_hyperplanes": _dual_figures()}, FINITE,
        "$A_2$ is its own dual, that of $B_2$ is $C_2$, that of $G_2$ is $G_2$ turned and scaled. "
        "Computed: the lines, and the arrows.",
    )  # fmt: skip


@claim("rem-2", "Section 2.3, Remark 2", WORDING, to_state=["def-7", "def-10"])
def remark_2(printed: Constants) -> Finding:
    """The Cartan integer n(r, s) of Definition 7 is the product of one of r and s with the coroot of the
    other: the coroot is that of argument number {argument}."""
    r, s = (1, 0), (1, 1)
    with_coroot = [
        _product_with_coroot(s, r),
        _product_with_coroot(r, s),
    ]  # of the first, of the second argument
    true = [number for number, value in enumerate(with_coroot, 1) if value == cartan_integer(r, s)]
    finding = agree(
        printed, {"argument": true[0]}, EVERY_D,
        "Definition 7 divides by the squared length of the second argument, so $n(r,s)=\\langle "
        "r,s^\\vee\\rangle$.",
    )  # fmt: skip
    if finding.verdict is Verdict.HOLDS:
        return finding
    why = "Remark 2 exchanges the arguments; with Definition 7 it is $n(s,r)=\\langle r^\\vee,s\\rangle$"
    witness = (
        f"In $B_2$, r = {show(r)} and s = {show(s)}: by Definition 7 n(r, s) is {cartan_integer(r, s)}, by "
        f"the remark it would be {with_coroot[0]}."
    )
    return replace(explained(finding, why), witness=witness)


def _product_with_coroot(x: tuple[int, ...], r: tuple[int, ...]) -> Fraction:
    """<x, r^v>, from the reflection in r: x - σ(x) = <x, r^v>·r."""
    image = affine_reflection(r, 0, x)
    k = next(i for i, c in enumerate(r) if c)
    return (x[k] - image[k]) / r[k]


@claim("def-11", "Section 2.3, Definition 11", RESULT, to_state=["def-10", "def-9"])
def definition_11(printed: Constants) -> Finding:
    """The integer combinations of the coroots are a lattice of rank {basis}."""
    ranks = {
        s.rank: Fraction(coroot_lattice(s).rank)
        for s in systems(5)
        if all(r in coroot_lattice(s) for r in s.coroots.rows())
    }
    return agree(
        printed, {"basis": fits(printed["basis"], "d", ranks)}, EVERY_D,
        "The root lattice of the dual system, with the coroots of the simple roots as a basis. Computed up "
        "to rank 5.",
    )  # fmt: skip


@claim("def-12", "Section 2.3, Definition 12", WORDING, to_state=["def-9", "def-11"])
def definition_12(printed: Constants) -> Finding:
    """The points of this space, {space}, that have integer products with all coroots, or with all roots,
    are a lattice."""
    a1 = root_system("A1")
    outside = [(Fraction(1), Fraction(1)), (Fraction(1, 3), Fraction(1, 3))]
    integral = all(
        sum(a * b for a, b in zip(x, r, strict=True)).denominator == 1
        for x in outside
        for r in a1.coroots.rows()
    )
    none = integral and not any(_in_span(a1, x) for x in outside)
    finding = agree(
        printed, {"space": "the span of R" if none else "R^d"}, EVERY_D,
        "In the span they are the dual lattices of the coroot lattice and of the root lattice. Outside it "
        "all multiples of a vector orthogonal to the span qualify.",
    )  # fmt: skip
    if finding.verdict is Verdict.HOLDS:
        return finding
    why = "The points must lie in the span of the roots; in the larger spaces of Theorem 3 this is no lattice"
    return replace(
        explained(finding, why),
        witness="For $A_1$ = {±(1, -1)} in dimension 2 all (t, t), t real, have the product 0 with both.",
    )


def _in_span(system: RootSystem, x: tuple[Fraction, ...]) -> bool:
    try:
        system.coordinates(x)
    except InvalidInput:
        return False
    return True


@lru_cache(maxsize=1)
def _integral_sets() -> dict[str, str]:
    """Which vectors the weights, and the coweights, have integer products with, but not so all points of
    the other."""
    found: dict[str, set[str]] = {"weights": {"roots", "coroots"}, "coweights": {"roots", "coroots"}}
    for s in systems(5):
        for name, lattice in (("weights", weight_lattice(s)), ("coweights", coweight_lattice(s))):
            for what, vectors in (("roots", s.roots), ("coroots", s.coroots)):
                if (lattice.basis @ vectors.T).denominator != 1 and not _is_whole(lattice.basis @ vectors.T):
                    found[name].discard(what)
    return {name: values.pop() if len(values) == 1 else "neither" for name, values in found.items()}


def _is_whole(matrix: RationalMatrix) -> bool:
    return not (matrix.numerators.astype(object) % matrix.denominator).any()


@claim("def-12.weights", "Section 2.3, Definition 12", WORDING, to_state=["def-12"])
def weights(printed: Constants) -> Finding:
    """Weights are the points with integer products with all {weights}, coweights those with all
    {coweights}."""
    return agree(
        printed, _integral_sets(), EVERY_D,
        "A definition; the two lattices are dual to the coroot lattice and the root lattice. Computed up "
        "to rank 5: in each case the other set of vectors would not do.",
    )  # fmt: skip


@claim("sec2.coweights", "Section 2.3, after Definition 12", RESULT, to_state=["def-12"])
def coweights_are_vertices(printed: Constants) -> Finding:
    """The coweights have to do with the vertices of the Coxeter triangulation: all of them are vertices."""
    true = all(
        triangulation(k).is_vertex(w)
        for k in triangulations_up_to(5)
        for w in root_system((k.letter, k.rank)).fundamental_coweights.rows()
    )
    return agree(
        printed, {"vertices": true}, EVERY_D,
        "A coweight has integer products with all roots, so a hyperplane of each family passes through it. "
        "Conversely the vertices of the alcove are 0 and the fundamental coweights over the marks. "
        "Computed up to d = 5.",
    )  # fmt: skip
