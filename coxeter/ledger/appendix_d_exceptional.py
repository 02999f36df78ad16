"""Appendix D, Propositions 11 to 14: the vertex sets of E~6, E~7, E~8 and F~4."""

from __future__ import annotations

from ..exact import show
from .appendix_d_cases import CASES, Case, answer, smallest, witness
from .appendix_d_roots import integral_roots, listed, rank
from .appendix_d_steps import NOT_A_LATTICE, register_steps
from .claim import Constants, Finding, claim, corrected, decide, repaired
from .vocabulary import FINITE, Weight


@claim(
    "prop-11", "Section 6, Proposition 11", Weight.RESULT, to_prove=("prop-11.witness", "prop-11.no-vertex")
)
def vertices_of_e6(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde E_6$ is {lattice?a|not a} lattice."""
    return _exceptional(
        CASES[11],
        printed,
        r"The vector $\frac32e_2$ is not the printed combination, nor any integer combination of vertices, "
        "so that it says nothing that it is no vertex.",
    )


register_steps(CASES[11], NOT_A_LATTICE)


@claim("prop-12", "Section 6, Proposition 12", Weight.RESULT, to_prove=("prop-12.no-vertex",))
def vertices_of_e7(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde E_7$ is {lattice?a|not a} lattice."""
    return _exceptional(
        CASES[12],
        printed,
        "The printed witness $e_2$ is a vertex: the root $e_8-e_7$, missing from the list of positive "
        "roots, is orthogonal to it, and with it the rank is 7.",
    )


register_steps(CASES[12], NOT_A_LATTICE)


@claim("prop-13", "Section 6, Proposition 13", Weight.RESULT, to_prove=("prop-13.no-vertex",))
def vertices_of_e8(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde E_8$ is {lattice?a|not a} lattice."""
    return _exceptional(
        CASES[13],
        printed,
        r"The printed witness $e_2$ is a vertex: the roots $e_8\pm e_i$, missing from the list of positive "
        "roots, have integer inner products with it, and with them the rank is 8.",
    )


register_steps(CASES[13], NOT_A_LATTICE)


def _exceptional(case: Case, printed: Constants, fault: str) -> Finding:
    found = answer(case, case.first.dimension)
    if printed["lattice"] is not found.is_lattice:
        return corrected(FINITE, f"lattice: {found.is_lattice}")
    return repaired(
        FINITE, f"A difference of two vertices of one simplex is a witness. {smallest(case)}", fault
    )


@claim(
    "prop-14", "Section 6, Proposition 14", Weight.RESULT, to_prove=("prop-14.no-vertex", "prop-14.relation")
)
def vertices_of_f4(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde F_4$ is {lattice?a|not a} lattice."""
    found = answer(CASES[14], 4)
    good = printed["lattice"] is found.is_lattice
    return decide(
        good, FINITE, "it is no lattice", f"A smaller witness than the printed one: {smallest(CASES[14])}"
    )


register_steps(CASES[14], tuple(step for step in NOT_A_LATTICE if step != "span"))


@claim("prop-14.relation", CASES[14].place, Weight.PROOF, to_prove=("prop-14.integral-roots",))
def relation(printed: Constants) -> Finding:
    """Half of {left:signed} is half of {right:signed}, plus {root:signed}; so the roots with integer inner
    products with v are dependent, and their rank is {rank}."""
    whole = integral_roots(CASES[14].first, witness(CASES[14], 4))
    left, right = ({"half_fixed": printed[name], "half_signs": (1, 0)} for name in ("left", "right"))
    (one,), (other,) = (listed(constants, 4, 4) for constants in (left, right))
    (root,) = listed({"further": (printed["root"],)}, 4, 4)
    related = one == tuple(a + b for a, b in zip(other, root, strict=True))
    good = related and {one, other, root} <= whole and printed["rank"] == rank(whole)
    return decide(
        good,
        FINITE,
        "the relation or the rank is another one",
        f"{len(whole)} roots of rank {rank(whole)}, fewer than 4 independent ones: "
        f"{show(witness(CASES[14], 4))} is no vertex.",
    )
