"""Sections 1.3 and 1.4: what the paper contributes."""

from __future__ import annotations

from fractions import Fraction

from ..names import EXCEPTIONAL, FAMILIES
from ..paper import printed as paper
from .claim import Constants, Finding, agree, claim, conjecture
from .instances import of_type
from .section_1_definition import BY_FAMILY, angles_of
from .section_1_rates import MEASURES, ONLY_UPPER, comparison, exponents, judge_protection, judge_quality
from .vocabulary import EVERY_D, FINITE, INSTANCES, LITERATURE, Weight
from .wording import explained, quoted

RESULT, WORDING = Weight.RESULT, Weight.WORDING


# -- 1.3 --------------------------------------------------------------------------------------------------


@claim("sec1.contribution.explicit", "Section 1.3", WORDING)
def explicit_expressions(printed: Constants) -> Finding:
    """Section 5 has explicit expressions of the measures of all Coxeter triangulations, in all dimensions."""
    cells = {(x.family, x.quantity) for x in paper().formulas if x.place == "Table 2" and x.text}
    everything = {(family, f"normalized_{m}") for family in FAMILIES for m in MEASURES}
    return agree(
        printed, {"all_families": cells >= everything}, FINITE,
        f"Table 2 has an expression for each of the {len(FAMILIES)} families and {len(MEASURES)} measures. "
        "Whether they are right is judged there.",
    )  # fmt: skip


@claim("sec1.contribution.dobkin-table", "Section 1.3", WORDING)
def dobkin_table(printed: Constants) -> Finding:
    """Dobkin and others had a table of the radius ratios up to dimension {last}."""
    last = max(rank for ranks in EXCEPTIONAL.values() for rank in ranks)
    return quoted(
        agree(printed, {"last": last}, LITERATURE),
        "Dobkin, Levy, Thurston and Wilks, Contour tracing by piecewise linear approximations, 1990.",
        f"Dimension {last} is the last with a triangulation that belongs to no infinite family.",
    )


# -- 1.4 --------------------------------------------------------------------------------------------------


@claim("sec1.rate-of-families", "Section 1.4", WORDING, to_state=["def-1"])
def rate_of_families(printed: Constants) -> Finding:
    """In the four families the measures of Definition 18 behave as {bound}(d^({exponent}))."""
    raw, all_equal = exponents(""), set(exponents().values())
    finding = judge_quality(printed, normalised=len(all_equal) == 1 and len(set(raw.values())) > 1)
    powers = ", ".join(f"{m.replace('_', ' ')} {e}" for m, e in raw.items())
    return explained(
        finding,
        f"{ONLY_UPPER}, for the normalised measures. Those of Definition 18, which are not normalised, "
        f"decay with the exponents {powers} (fatness to the power 1/d).",
    )


@claim("sec1.conjecture-quality", "Section 1.4", RESULT, to_state=["sec1.rate-of-families"])
def quality_conjecture(printed: Constants) -> Finding:
    """Conjecture: no triangulation that fills space has simplices of better quality, in order of d."""
    return conjecture(comparison("quality"), INSTANCES)


@claim("sec1.relative-protection", "Section 1.4", WORDING, to_state=["sec1.protection"])
def relative_protection(printed: Constants) -> Finding:
    """The relative protection of the triangulation of type A~ is {bound}(d^({exponent}))."""
    return judge_protection(printed)


@claim("sec1.conjecture-protection", "Section 1.4", RESULT, to_state=["sec1.relative-protection"])
def protection_conjecture(printed: Constants) -> Finding:
    """Conjecture: no triangulation that fills space has a better relative protection, in order of d."""
    return conjecture(comparison("protection"), INSTANCES)


@claim("sec1.angles-of-families", "Section 1.4", RESULT, to_state=["def-1"], to_prove=["rem-3"])
def angles_of_families(printed: Constants) -> Finding:
    """In the four infinite families the dihedral angles are {angles} degrees."""
    true = angles_of(of_type("ABCD", 12))
    return agree(
        printed, {"angles": true}, EVERY_D, BY_FAMILY,
        "It is the list of what occurs in the four families together: $\\tilde A_2$ has 60° only, $\\tilde "
        "C_2$ has 45° and 90°, $\\tilde A_d$ from d = 3 on and $\\tilde D_d$ have 60° and 90°.",
    )  # fmt: skip


@claim("sec1.circumcentre", "Section 1.4", RESULT)
def circumcentre(printed: Constants) -> Finding:
    """The circumcentre of the simplices of type A~ lies very far inside."""
    central = all(
        set(t.simplex.circumcentre_coordinates) == {Fraction(1, t.dimension + 1)} for t in of_type("A", 24)
    )
    return agree(
        printed, {"inside": central}, EVERY_D,
        "It is the barycentre, and the centre of the inscribed ball: all barycentric coordinates are "
        "$\\frac1{d+1}$. No point has a greater least coordinate. Computed up to d = 24.",
        "The rotation of the affine diagram, a cycle, is a symmetry of the simplex that permutes its "
        "vertices cyclically; it fixes the circumcentre, and the barycentre alone is fixed by it.",
    )  # fmt: skip
