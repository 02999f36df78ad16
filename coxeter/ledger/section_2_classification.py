"""Section 2.2: the root systems by their diagrams, and their simple roots."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache, partial
from typing import Any

from .. import diagrams
from ..errors import CoxeterError
from ..names import FAMILIES
from ..root_sets import coroots
from ..roots import RootSystem, root_system
from .claim import Constants, Finding, agree, claim, damaged
from .instances import systems
from .section_2_trees import family_of, name_of, names_of_trees
from .vocabulary import EVERY_D, FINITE, Verdict, Weight
from .wording import fits

RESULT = Weight.RESULT


# -- Theorem 2 --------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def families_of_definite_trees() -> tuple[str, ...]:
    """The families of the definite trees, with labels up to five nodes, without labels up to nine."""
    names = {*names_of_trees(5, (3, 4, 6))[1], *names_of_trees(9, (3,))[1]}
    return tuple(sorted({family_of(name) for name in names}))


@claim("thm-2", "Section 2.2, Theorem 2", RESULT, to_state=["def-8"], to_prove=["sec2.definite-graphs"])
def theorem_2(printed: Constants) -> Finding:
    """The Coxeter diagrams of crystallographic, reduced, irreducible root systems are those of {types}; the
    diagram of $B_d$ stands for $C_d$ too."""
    finding = agree(
        printed, {"types": families_of_definite_trees()}, EVERY_D,
        "The form with $-2\\cos\\frac\\pi m$ for an edge with label m is that of the simple roots, scaled "
        "to length $\\sqrt2$: it is positive definite. As for graphs without labels, no diagram can "
        "contain, with labels at least as large, one that has a vector with coordinates $\\ge0$ and form 0.",
        "The affine diagrams have such vectors, the marks times the lengths. $\\tilde A$ excludes cycles; "
        "$\\tilde G_2$ any other edge beside a label 6; $\\tilde C$ two labels 4; $\\tilde B$ a label 4 "
        "and a branch. What is left with a label 4 is a path. If the edge is not at its end, $\\tilde F_4$ "
        "leaves only the path 3, 4, 3. Without labels: Section 2.1.",
        "All these occur, by Theorem 3. Computed: all trees with labels 3, 4, 6 and up to five nodes.",
    )  # fmt: skip
    if finding.verdict is Verdict.HOLDS or printed["types"] != tuple(
        x for x in families_of_definite_trees() if x != "F4"
    ):
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
    return agree(
        printed, {"B": ends.pop(), "G2": edge[2]}, EVERY_D,
        "By Theorem 3: of the roots $e_k-e_{k+1}$ and $e_d$ only neighbours have a product other than 0, and "
        r"it is $-1$. The lengths are $\sqrt2$, and 1 for the last: so the cosines are $-\frac12$, label 3, "
        r"and at the end $-\frac1{\sqrt2}$, label 4. For $G_2$ the product is $-3$ and the lengths are "
        r"$\sqrt2$, $\sqrt6$: the cosine is $-\frac{\sqrt3}2$, label 6.",
        "Computed up to rank 8.",
    )  # fmt: skip


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
    space = "d + 1" if family == "A" else "d"
    return found | {"space": fits(space, space, spaces)}


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


def _words(family: str) -> str:
    """What Theorem 3 says of one type."""
    if family in "ABCD":
        last = "" if family == "A" else ", and the last one has the last two coordinates ({last})"
        return (
            f"$\\mathbf {family}_d$ has simple roots in dimension {{space}}: $s_k$ has the coordinates "
            f"({{chain}}) at k and k + 1, else 0{last}."
        )
    rows = "; ".join(f"$s_{k}$ = ({{s{k}}})" for k in range(1, int(family[1:]) + 1))
    return f"$\\mathbf{{{family[0]}}}_{family[1:]}$ has the simple roots {rows}."


for _family in FAMILIES:
    _place = f"Section 2.2, Theorem 3, {_family}"
    _check = partial(simple_root_set, _family)
    claim(f"thm-3.{_family}", _place, RESULT, words=_words(_family), to_state=["def-5"])(_check)


@lru_cache(maxsize=1)
def _complete() -> tuple[str, ...]:
    """The families, with a second one where long and short roots can be exchanged, and not by a reversal."""
    second = []
    for name in ("B4", "F4", "G2"):
        lengths = root_system(name).squared_lengths
        exchanged = tuple(max(lengths) if x == min(lengths) else min(lengths) for x in lengths)
        second += [name] if exchanged[::-1] != lengths else []
    return tuple(sorted({*families_of_definite_trees(), *("C" for name in second if name == "B4")}))


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
