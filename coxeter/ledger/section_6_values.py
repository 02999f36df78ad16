"""Section 6: the plan, the heights, the centre and the edges of A~, the determinants of the volumes."""

from __future__ import annotations

from functools import lru_cache

from ..affine import triangulation
from ..claims.core import DEFINITIONS, letters
from ..claims.runs import coordinates
from ..errors import InvalidInput
from ..exact import RationalMatrix, Surd, surd
from ..families import evaluate
from ..paper import printed as formulas
from ..paper import prose
from ..proofs import prove
from ..simplex import Simplex
from .claim import Claim, Constants, Finding, agree, claim, corrected, holds, register
from .records import judge_formula
from .vocabulary import EVERY_D, FINITE, Weight, up_to

LARGEST = 12


@claim("sec6.convention", "Section 6", Weight.WORDING)
def convention(printed: Constants) -> Finding:
    """Powers repeat a coordinate: ({short}) stands for ({long})."""
    written = coordinates(printed["short"], 0, 0)
    return holds(FINITE) if written == printed["long"] else corrected(FINITE, f"it stands for {written}")


def _plan(measure: str) -> None:
    id = f"sec6.plan.{measure.replace('_', '-')}"

    def check(printed: Constants) -> Finding:
        """The definition, for a simplex in two sizes: else L = 1 could hide an error."""
        for family, d in (("A", 3), ("B", 5), ("E7", 7)):
            values = letters(family, d)
            twice = {
                name: x * (2**d if name == "vol" else 2 if name in "hLrR" else 1)
                for name, x in values.items()
            }
            for known in (values, twice):
                if evaluate(printed["formula"], **known) != evaluate(DEFINITIONS[measure], **values):
                    return corrected(FINITE, f"printed {printed['formula']}; true: {DEFINITIONS[measure]}")
        return holds(FINITE)

    words = f"The {measure.replace('_', ' ')} is {{formula}}, as Definition 18 has it."
    register(
        Claim(
            id,
            "Section 6, plan",
            words,
            Weight.WORDING,
            check,
            prose()[id],
            ("def-18",),
            (),
            f"{__name__}._plan",
        )
    )


for _measure in DEFINITIONS:
    _plan(_measure)


@claim("sec6.A.item-3.equal", "Section 6, A~, item 3", Weight.RESULT)
def equal_heights(printed: Constants) -> Finding:
    """All heights of the simplex of A~_d are equal: {equal}."""
    prove("quantity", "A", "minimal_height")
    equal = all(len(set(triangulation(("A", d)).simplex.squared_heights)) == 1 for d in range(2, LARGEST + 1))
    finding = agree(printed, {"equal": equal}, EVERY_D)
    if not finding.verdict.accepts:
        return finding
    return holds(
        EVERY_D,
        "All marks are 1 and all roots have the same length",
        proof=("quantity", "A", "minimal_height"),
    )


@claim("sec6.A.item-4.barycentre", "Section 6, A~, item 4", Weight.RESULT)
def barycentre(printed: Constants) -> Finding:
    """The barycentre of A~_d's simplex is its circumcentre ({circumcentre}) and its incentre ({incentre})."""
    for proof in (("quantity", "A", "circumradius"), ("quantity", "A", "inradius")):
        prove(*proof)
    found = {"circumcentre": True, "incentre": True}
    for d in range(2, LARGEST + 1):
        simplex = triangulation(("A", d)).simplex
        found["circumcentre"] &= simplex.circumcentre == _mean(simplex)
        found["incentre"] &= simplex.incentre == _mean(simplex)
    finding = agree(printed, found, EVERY_D)
    words = "The circumcentre has the level 1/(d + 1) on each wall, so all its barycentric coordinates are 1/(d + 1)"
    return (
        finding
        if not finding.verdict.accepts
        else holds(EVERY_D, words, proof=("position_of_circumcentre", "A"))
    )


def _mean(simplex: Simplex) -> tuple[object, ...]:
    rows = list(simplex.vertex_matrix.rows())
    return tuple(sum(column) / len(rows) for column in zip(*rows, strict=True))


@claim("sec6.A.item-5.maximum", "Section 6, A~, item 5", Weight.PROOF)
def maximum(printed: Constants) -> Finding:
    """The squared edge is greatest for k - j = {odd} if d is odd, and for k - j = {even} if d is even."""
    for parity in ("odd", "even"):
        for d in range(3 if parity == "odd" else 2, LARGEST + 1, 2):
            difference = evaluate(printed[parity], d=d)
            if difference not in longest_differences(d):
                witness = f"for d = {d} the longest edges have k - j in {sorted(longest_differences(d))}, not {difference}"
                return corrected(
                    EVERY_D, "for even d, k - j = d/2 or d/2 + 1: the nearest integers to (d + 1)/2", witness=witness,
                    evidence="the length that is printed for even d is that of these edges",
                    constants={"odd": "(d + 1)/2", "even": "d/2"}, proof=("quantity", "A", "longest_edge"),
                )  # fmt: skip
    return holds(EVERY_D, proof=("quantity", "A", "longest_edge"))


@lru_cache(maxsize=32)
def longest_differences(d: int) -> frozenset[int]:
    """The differences k - j of the longest edges of A~_d."""
    return frozenset(k - j for j, k in triangulation(("A", d)).simplex.longest_edges())


def _determinant(family: str, low: int) -> None:
    id = f"sec6.{family}.item-7.determinant"

    def check(printed: Constants) -> Finding:
        """The matrix is triangular, for D~ but for its last row."""
        for d in range(low, LARGEST + 1):
            value = _edge_matrix(family, d, printed["first"], printed["other"]).det()
            if value != evaluate(printed["value"], d=d):
                return corrected(EVERY_D, f"for d = {d} the determinant is {value}")
            if [tuple(column) for column in _columns(family, d, printed)] != _vertices(family, d):
                return corrected(EVERY_D, "the columns are not the vertices")
        return holds(EVERY_D, "The matrix is triangular, with the vertices as columns: the product of its diagonal",
                     proof=("quantity", family, "volume"))  # fmt: skip

    words = (
        "The determinant of the vertices, with the first entry {first} and {other} in all others of the upper triangle, is "
        "{value}."
    )
    place = f"Section 6, {family}~, item 7"
    register(
        Claim(
            id,
            place,
            words,
            Weight.PROOF,
            check,
            prose()[id],
            (),
            (f"sec6.{family}.item-2",),
            f"{__name__}._determinant",
        )
    )


def _edge_matrix(family: str, d: int, first: str, other: str) -> RationalMatrix:
    columns = _columns(family, d, {"first": first, "other": other})
    return RationalMatrix.from_rows([list(row) for row in zip(*columns, strict=True)])


def _columns(family: str, d: int, printed: Constants) -> list[list[Surd | int]]:
    first, other = (evaluate(printed[name]).as_fraction() for name in ("first", "other"))
    columns = [[other] * k + [0] * (d - k) for k in range(1, d + 1)]
    columns[0][0] = first
    if family == "D":
        columns[d - 2][d - 1] = -other
    return columns  # type: ignore[return-value]


def _vertices(family: str, d: int) -> list[tuple[object, ...]]:
    return [tuple(row) for row in list(triangulation((family, d)).simplex.vertex_matrix.rows())[1:]]


for _family, _low in (("B", 3), ("C", 2), ("D", 4)):
    _determinant(_family, _low)


@claim("sec6.D.item-7.expansion", "Section 6, D~, item 7", Weight.PROOF)
def expansion(printed: Constants) -> Finding:
    """Expanded along its last row, the determinant of D~ is {factor} times {terms} equal triangular determinants."""
    for d in range(4, LARGEST + 1):
        whole = _edge_matrix("D", d, "1", "1/2").det()
        part = _edge_matrix("B", d - 1, "1", "1/2").det()
        if surd(whole) != evaluate(printed["factor"]) * printed["terms"] * part:
            return corrected(up_to(LARGEST), f"for d = {d} the determinants are {whole} and {part}")
    return holds(
        EVERY_D, "The last row has the entries -1/2 and 1/2; both minors are the triangle of size d - 1"
    )


@claim("sec6.G2.item-1.triangle", "Section 6, G~2", Weight.RESULT)
def kisrhombille(printed: Constants) -> Finding:
    """The simplex is a triangle with a right angle ({right}) and the angle {angle}·π."""
    angles = sorted(triangulation("G~2").dihedral_angles().values())
    smallest = str(angles[0])
    if surd(angles[-1]) * 2 != 1:
        raise InvalidInput("the triangle of G~2 has no right angle")
    return agree(printed, {"right": True, "angle": smallest}, FINITE)


def _lemma_7() -> None:
    """The fatness of A~: two formulas, which item 7 prints."""
    records = {f.parity: f for f in formulas().formulas if f.place == "Section 6, A~, item 7" and f.parity}

    def check(printed: Constants) -> Finding:
        found = [judge_formula(f, {"formula": printed[parity]}) for parity, f in records.items()]
        wrong = [finding for finding in found if not finding.verdict.accepts]
        return wrong[0] if wrong else holds(EVERY_D, proof=("quantity", "A", "fatness"))

    words = "The fatness of A~_d is {odd} for odd d and {even} for even d."
    constants = {parity: f.text for parity, f in records.items()}
    register(Claim("lem-7", "Section 6, Lemma 7", words, Weight.RESULT, check, constants, ("def-18.fatness",),
                   ("lem-7.base", "sec6.A.item-5"), f"{__name__}._lemma_7"))  # fmt: skip


_lemma_7()
