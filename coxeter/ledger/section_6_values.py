"""Section 6: the plan, the heights, the centre and the edges of A~, the determinants of the volumes."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache, partial

from ..affine import triangulation
from ..claims.core import DEFINITIONS, letters
from ..claims.runs import coordinates
from ..errors import InvalidInput
from ..exact import RationalMatrix, surd
from ..families import evaluate
from ..paper import printed as paper
from .claim import Constants, Finding, agree, claim, corrected, holds
from .record_formulas import doubled, judge_formula
from .vectors import mean
from .vocabulary import EVERY_D, FINITE, Weight, up_to
from .wording import told

LARGEST = 12


@claim("sec6.convention", "Section 6", Weight.WORDING)
def convention(printed: Constants) -> Finding:
    """Powers repeat a coordinate: ({short}) stands for ({long})."""
    written = coordinates(printed["short"], 0, 0)
    return holds(FINITE) if written == printed["long"] else corrected(FINITE, f"it stands for {written}")


def judge_plan(measure: str, printed: Constants) -> Finding:
    """Whether the plan has the definition of a measure, for simplices in two sizes."""
    for family, d in (("A", 3), ("B", 5), ("E7", 7)):
        value = evaluate(DEFINITIONS[measure], **letters(family, d))
        if any(evaluate(printed["formula"], **x) != value for x in (letters(family, d), doubled(family, d))):
            return corrected(FINITE, f"printed {printed['formula']}; true: {DEFINITIONS[measure]}")
    return holds(FINITE)


for _measure in DEFINITIONS:
    claim(
        f"sec6.plan.{_measure.replace('_', '-')}",
        "Section 6, plan",
        Weight.WORDING,
        words=f"The {_measure.replace('_', ' ')} is {{formula}}, as Definition 18 has it.",
        to_state=("def-18",),
    )(partial(judge_plan, _measure))


# -- A~ ---------------------------------------------------------------------------------------------------


@claim(
    "sec6.A.item-3.equal",
    "Section 6, A~, item 3",
    Weight.RESULT,
    proof=("quantity", "A", "minimal_height"),
)
def equal_heights(printed: Constants) -> Finding:
    """The heights of the simplex of A~_d are {equal?all|not all} equal."""
    equal = all(len(set(triangulation(("A", d)).simplex.squared_heights)) == 1 for d in range(2, LARGEST + 1))
    words = "All marks are 1 and all roots have the same length"
    return agree(printed, {"equal": equal}, EVERY_D, words)


@claim(
    "sec6.A.item-4.barycentre",
    "Section 6, A~, item 4",
    Weight.RESULT,
    proof=("position_of_circumcentre", "A"),
)
def barycentre(printed: Constants) -> Finding:
    """The barycentre of A~_d's simplex is {circumcentre?|not }its circumcentre and {incentre?|not }its
    incentre."""
    from ..proofs import prove

    for radius in ("circumradius", "inradius"):
        prove("quantity", "A", radius)
    found = {"circumcentre": True, "incentre": True}
    for d in range(2, LARGEST + 1):
        simplex = triangulation(("A", d)).simplex
        middle = mean(simplex.vertex_matrix.rows())
        found["circumcentre"] &= simplex.circumcentre == middle
        found["incentre"] &= simplex.incentre == middle
    words = (
        "The circumcentre has the level 1/(d + 1) on each wall, so all its barycentric coordinates are "
        "1/(d + 1)"
    )
    return agree(printed, found, EVERY_D, words)


@claim("sec6.A.item-5.maximum", "Section 6, A~, item 5", Weight.PROOF)
@told
def maximum(printed: Constants) -> Finding:
    """The squared edge is greatest for k - j = {odd} if d is odd, and for k - j = {even} if d is even."""
    proof = ("quantity", "A", "longest_edge")
    for parity in ("odd", "even"):
        for d in range(3 if parity == "odd" else 2, LARGEST + 1, 2):
            given, true = evaluate(printed[parity], d=d), longest_differences(d)
            if given not in true:
                return corrected(
                    EVERY_D,
                    "for even d, k - j = d/2 or d/2 + 1: the nearest integers to (d + 1)/2",
                    witness=f"for d = {d} the longest edges have k - j in {sorted(true)}, not {given}",
                    evidence="the length that is printed for even d is that of these edges",
                    constants={"odd": "(d + 1)/2", "even": "d/2"},
                    proof=proof,
                )
    return holds(EVERY_D, proof=proof)


@lru_cache(maxsize=32)
def longest_differences(d: int) -> frozenset[int]:
    """The differences k - j of the longest edges of A~_d."""
    return frozenset(k - j for j, k in triangulation(("A", d)).simplex.longest_edges())


# -- the determinants -------------------------------------------------------------------------------------


def judge_determinant(family: str, low: int, printed: Constants) -> Finding:
    """The value of the determinant. The matrix is triangular, for D~ but for its last row."""
    for d in range(low, LARGEST + 1):
        columns = _columns(family, d, printed["first"], printed["other"])
        value = RationalMatrix.from_rows(columns).det()
        if value != evaluate(printed["value"], d=d):
            return corrected(EVERY_D, f"for d = {d} the determinant is {value}")
        if columns != [list(row) for row in triangulation((family, d)).simplex.vertex_matrix.rows()[1:]]:
            return corrected(EVERY_D, "the columns are not the vertices")
    words = "The matrix is triangular, with the vertices as columns: the product of its diagonal"
    if family == "D":
        words = (
            "The columns are the vertices; expanded along the last row it is two equal triangles, by halves"
        )
    return holds(EVERY_D, words, proof=("quantity", family, "volume"))


def _columns(family: str, d: int, first: str, other: str) -> list[list[Fraction]]:
    """The columns of the matrix: its transpose has the same determinant."""
    corner, entry, zero = evaluate(first).as_fraction(), evaluate(other).as_fraction(), Fraction(0)
    columns = [[entry] * k + [zero] * (d - k) for k in range(1, d + 1)]
    columns[0][0] = corner
    if family == "D":
        columns[d - 2][d - 1] = -entry
    return columns


for _family, _low in (("B", 3), ("C", 2), ("D", 4)):
    claim(
        f"sec6.{_family}.item-7.determinant",
        f"Section 6, {_family}~, item 7",
        Weight.PROOF,
        words="The determinant of the vertices, with the first entry {first} and {other} in all others of "
        "the upper triangle"
        + (", and minus that before the last entry of the last row" if _family == "D" else "")
        + ", is {value}.",
        to_prove=(f"sec6.{_family}.item-2",),
    )(partial(judge_determinant, _family, _low))


@claim("sec6.D.item-7.expansion", "Section 6, D~, item 7", Weight.PROOF)
def expansion(printed: Constants) -> Finding:
    """Expanded along its last row, the determinant of D~ is {factor} times {terms} equal triangular
    determinants."""
    for d in range(4, LARGEST + 1):
        whole = RationalMatrix.from_rows(_columns("D", d, "1", "1/2")).det()
        part = RationalMatrix.from_rows(_columns("B", d - 1, "1", "1/2")).det()
        if surd(whole) != evaluate(printed["factor"]) * printed["terms"] * part:
            return corrected(up_to(LARGEST), f"for d = {d} the determinants are {whole} and {part}")
    return holds(
        EVERY_D, "The last row has the entries -1/2 and 1/2; both minors are the triangle of size d - 1"
    )


# -- G~2, and Lemma 7 -------------------------------------------------------------------------------------


@claim("sec6.G2.item-1.triangle", "Section 6, G~2", Weight.RESULT)
def kisrhombille(printed: Constants) -> Finding:
    """The simplex is a triangle {right?with|without} a right angle; another angle is {angle:pi}."""
    smallest, *_, greatest = sorted(triangulation("G~2").dihedral_angles().values())
    if greatest != Fraction(1, 2):
        raise InvalidInput("the triangle of G~2 has no right angle")
    return agree(printed, {"right": True, "angle": str(smallest)}, FINITE)


FATNESS = {f.parity: f for f in paper().formulas if f.place == "Section 6, A~, item 7" and f.parity}
"""The two formulas that Lemma 7 and item 7 print, by the parity of d."""


@claim(
    "lem-7",
    "Section 6, Lemma 7",
    Weight.RESULT,
    printed={parity: f.text for parity, f in FATNESS.items()},
    to_state=("def-18.fatness",),
    to_prove=("lem-7.base", "sec6.A.item-5"),
)
def lemma_7(printed: Constants) -> Finding:
    """The fatness of A~_d is {odd} for odd d and {even} for even d."""
    for parity, f in FATNESS.items():
        finding = judge_formula(f, {"formula": printed[parity]})
        if not finding.verdict.accepts:
            return finding
    return holds(EVERY_D, proof=("quantity", "A", "fatness"))
