"""Section 5: Theorem 8, the best family, the rates. The cells of the tables are in `tables`."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache, partial

from ..affine import CoxeterTriangulation, triangulation
from ..claims.core import DEFINITIONS, affine_name, dimensions, exact_value, family_of
from ..claims.decimals import COLUMNS, printed_decimal
from ..delaunay import delaunay_verdict, protection
from ..errors import InvalidInput
from ..exact import sqrt
from ..families import closed_form, evaluate
from ..lattices import vertex_lattice
from ..names import EXCEPTIONAL, FAMILIES, MINIMAL_DIMENSION
from ..paper import PrintedFormula
from ..paper import printed as paper
from ..simplex import regular_simplex
from .claim import Constants, Finding, agree, claim, corrected, holds, repaired, same
from .record_formulas import formula_claims
from .vocabulary import EVERY_D, FINITE, Weight
from .wording import amend, told

formula_claims(lambda f: f.place == "Theorem 8")

SECTIONS_6 = tuple(f"sec6.{family}.item-8" for family in FAMILIES)
SINGLE = tuple(f"{letter}{d}" for letter, ranks in EXCEPTIONAL.items() for d in ranks)


# -- Theorem 8 --------------------------------------------------------------------------------------------


def _member(family: str) -> CoxeterTriangulation:
    return triangulation((family[0], int(family[1:] or 5)))


def _named(families: Iterable[str]) -> tuple[str, ...]:
    """Families as the statements name them."""
    return tuple(map(affine_name, families))


@lru_cache(maxsize=1)
def delaunay_families() -> tuple[str, ...]:
    """The infinite families by proof for every d, the others by computation."""
    from ..proofs import prove

    for letter in MINIMAL_DIMENSION:
        prove("position_of_circumcentre", letter)
    return tuple(x for x in (*MINIMAL_DIMENSION, *SINGLE) if delaunay_verdict(_member(x)))


@claim("thm-8.delaunay", "Theorem 8", Weight.RESULT, to_state=("def-19",), to_prove=("thm-7", *SECTIONS_6))
def delaunay(printed: Constants) -> Finding:
    """The Delaunay triangulations are those of {families}, and no others."""
    steps = tuple(
        f"{x}~: the level of the circumcentre on the deciding walls, for every d" for x in MINIMAL_DIMENSION
    )
    return agree(printed, {"families": _named(delaunay_families())}, EVERY_D, *steps)


@claim(
    "thm-8.protected",
    "Theorem 8",
    Weight.RESULT,
    to_state=("def-19",),
    to_prove=("thm-7", "lem-12", *SECTIONS_6),
)
def protected(printed: Constants) -> Finding:
    """The triangulations with a positive relative protection are those of {families}, and no others."""
    found = tuple(x for x in delaunay_families() if protection(_member(x)).relative > 0)
    on_a_wall = _named(tuple(x for x in delaunay_families() if x not in found))
    return agree(
        printed,
        {"families": _named(found)},
        EVERY_D,
        f"A~: Lemma 12. In {', '.join(on_a_wall)} the circumcentre lies on a wall, so the protection is 0; "
        "all others are not Delaunay (Theorem 7).",
    )


@claim("thm-8.lattices", "Theorem 8", Weight.RESULT, to_prove=tuple(f"prop-{n}" for n in range(7, 15)))
def lattices(printed: Constants) -> Finding:
    """The vertex sets that are lattices are those of {families}, and no others."""
    from ..proofs import prove

    for n in (7, 8, 9, 10):
        prove(f"proposition_{n}")
    found = tuple(x for x in (*MINIMAL_DIMENSION, "D4", *SINGLE) if vertex_lattice(_member(x)))
    words = "Propositions 7 to 10 for every d, the rest by cosets"
    return agree(printed, {"families": _named(found)}, EVERY_D, words)


@claim(
    "thm-8.protection-rate",
    "Theorem 8",
    Weight.RESULT,
    to_state=("thm-8.relative-protection",),
    proof=("protection_rate",),
)
def protection_rate(printed: Constants) -> Finding:
    """The relative protection of A~_d divided by {constant}·d^({power}) tends to 1."""
    from ..symbolic.radicals_limits import growth

    found = growth(closed_form("A", "relative_protection").pieces[0].text)
    return agree(printed, {"constant": str(found.coefficient), "power": str(found.degree)}, EVERY_D)


@claim("thm-8.columns", "Theorem 8", Weight.WORDING)
def columns(printed: Constants) -> Finding:
    """Table 2, whose columns are {columns}, presents the four measures and the Delaunay property."""
    missing = sorted(
        {"Fatness", "Aspect Ratio", "Thickness", "Radius Ratio", "Delaunay"} - set(printed["columns"])
    )
    if not missing:
        return holds(FINITE)
    return corrected(
        FINITE,
        f"Table 2 has no column for {', '.join(missing)}; the property stands in item 8 of each family",
        evidence="a shade or another mark in its cells would be lost in our copy, so whether the paper or "
        "the copy is at fault cannot be told; the theorem lists the Delaunay triangulations itself",
        constants={"columns": (*printed["columns"], *missing)},
    )


@lru_cache(maxsize=1)
def _unnormalised() -> tuple[bool, list[str]]:
    """Whether a printed table has values without normalisation, and in which items of Section 6 they are."""
    places = {f.place for f in paper().formulas if f.quantity in DEFINITIONS and f.family in FAMILIES}
    places |= {f"Table {row.table}" for row in paper().rows if row.quantity in DEFINITIONS}
    items = {match[1] for place in places if (match := re.match(r"Section 6, .*, item (\d)", place))}
    return any(place.startswith("Table ") for place in places), sorted(items)


@claim("thm-8.unnormalised", "Theorem 8", Weight.WORDING)
def unnormalised(printed: Constants) -> Finding:
    """Section 6 {table?has|does not have} a table of the values without normalisation."""
    has_table, items = _unnormalised()
    return amend(
        agree(printed, {"table": has_table}, FINITE),
        correction=f"Section 6 gives these values one by one, in items {' and '.join(items)} of each family, "
        "and in no table",
        evidence="our copy has all numbered tables and that of the regular simplex; that this one alone was "
        "lost is not likely, but cannot be excluded",
    )


# -- the tables at a glance -------------------------------------------------------------------------------


TABLES = {"above": "Section 5, table of the regular simplex", "2": "Table 2"}
"""What may be called the table: that just above, or one by its number."""


@lru_cache(maxsize=2)
def _is_normalised(place: str) -> bool:
    """Whether more of the values of a table are right as normalised ones than as they are by definition."""
    score = 0
    for f in (f for f in paper().formulas if f.place == place and f.text):
        measure, d = f.quantity.removeprefix("normalized_"), _late(f)
        value = evaluate(f.text, d=d)
        score += (value == exact_value(f.family, f"normalized_{measure}", d)) - (
            value == exact_value(f.family, measure, d)
        )
    return score > 0


def _late(f: PrintedFormula) -> int:
    """The last dimension up to 8 for which a formula is printed: not one of the exceptional first."""
    return max(d for d in dimensions(f.family, f.parity) if d <= COLUMNS[-1])


@claim("sec5.table-above", "Section 5", Weight.WORDING, to_state=("tab-regular",))
@told
def table_above(printed: Constants) -> Finding:
    """The values in the table {which} are normalised by the regular simplex."""
    (normalised,) = (name for name, place in TABLES.items() if _is_normalised(place))
    return amend(
        agree(printed, {"which": normalised}, FINITE),
        correction=f"the table just above is that of the regular simplex itself; Table {normalised} is meant",
        witness=f"its aspect ratio for d = 4 is {closed_form('regular', 'aspect_ratio').at(4)}, not 1",
    )


@claim("sec5.order", "Section 5", Weight.WORDING)
def order(printed: Constants) -> Finding:
    """All normalised measures of the four families behave as {bound}(1/sqrt(d))."""
    from ..proofs.rates import constant

    if not all(constant(letter, measure) > 0 for letter in MINIMAL_DIMENSION for measure in DEFINITIONS):
        raise InvalidInput("a limit is not positive")
    return agree(
        printed, {"bound": "Theta"}, EVERY_D,
        "O is an upper bound only, which any bad triangulation satisfies; the limits of the measures times "
        "the root of d are positive.",
    )  # fmt: skip


@claim("sec5.fatness-power", "Section 5", Weight.WORDING, to_state=("def-18.fatness",))
def fatness_power(printed: Constants) -> Finding:
    """The normalised fatness is given to the power {power}."""
    given, ratio = closed_form("C", "normalized_fatness"), closed_form("C", "fatness")
    regular = closed_form("regular", "fatness")
    for d in range(2, 9):
        power = evaluate(printed["power"], d=d).as_fraction()
        if given.at(d) != (ratio.at(d) / regular.at(d)) ** power:
            return corrected(FINITE, f"printed {printed['power']}; true: 1/d")
    return holds(FINITE)


@claim("sec5.regular-does-not-tile", "Section 5", Weight.WORDING)
def regular_does_not_tile(printed: Constants) -> Finding:
    """The regular simplex does not tile space in every dimension."""
    cosine = regular_simplex(3).dihedral_cosine(0, 1)
    between = (sqrt(5) - 1) / 4 < cosine < sqrt(1) / 2  # cos of a fifth and of a sixth of the full angle
    words = (
        f"Not for d = 3: the dihedral angle of the regular tetrahedron has the cosine {cosine}, so it is "
        "less than a fifth and more than a sixth of the full angle: at an edge five leave a gap, six overlap."
    )
    return agree(printed, {"monohedral": not between}, FINITE, words)


@claim("sec5.glance", "Section 5", Weight.RESULT, to_state=("tab-3", "tab-4", "tab-5", "tab-6"))
def glance(printed: Constants) -> Finding:
    """In Tables 3 to 6, for d from {first} to {last}, no entry exceeds that of {family}~."""
    if (printed["first"], printed["last"]) != (COLUMNS[0], COLUMNS[-1]):
        raise InvalidInput("the tables have no such columns")
    for quantity in (f"normalized_{measure}" for measure in DEFINITIONS):
        for d in COLUMNS:
            cells = {x: printed_decimal(paper(), x, quantity, d) for x in "ABCDEFG" if family_of(x, d)}
            best = cells.get(printed["family"])
            if best is None or any(cell and cell[1] > best[1] for cell in cells.values()):
                return corrected(FINITE, f"for d = {d} another family has a greater {quantity}")
    return holds(FINITE)


def judge_best(measure: str, printed: Constants) -> Finding:
    """Whether A~ is the best family, by a measure, from the printed dimension on."""
    first = MINIMAL_DIMENSION["A"]
    if printed["from"] != first:
        return corrected(EVERY_D, f"from d = {first} on")
    return repaired(
        EVERY_D,
        "by comparison of the closed forms for every d",
        "the tables end with d = 8; a glance at them shows nothing for larger d",
        proof=("best", measure),
    )


for _measure in DEFINITIONS:
    claim(
        f"sec5.best.{_measure.replace('_', '-')}",
        "Section 5",
        Weight.RESULT,
        words=f"A~ has the greatest {_measure.replace('_', ' ')} of all Coxeter triangulations in every "
        "dimension from {from} on, which the tables show at a glance.",
        to_state=("def-18",),
        to_prove=("sec5.glance", "tab-2"),
    )(partial(judge_best, _measure))


# -- the rates --------------------------------------------------------------------------------------------


def judge_rate(letter: str, printed: Constants) -> Finding:
    """Whether the normalised measures of a family are of the printed order."""
    from ..proofs import prove
    from ..symbolic.radicals_limits import growth

    found = {m: growth(closed_form(letter, f"normalized_{m}").pieces[-1].text) for m in DEFINITIONS}
    for g in found.values():
        if not same(str(g.degree), printed["power"]):
            return corrected(EVERY_D, f"printed power {printed['power']}; true: {g.degree}")
    for m in DEFINITIONS:
        prove("rate", letter, m)
    limits = "; ".join(
        f"{m.replace('_', ' ')}: $\\sqrt d\\,\\hat q \\to {g.coefficient.latex()}$" for m, g in found.items()
    )
    words = f"The limits of the normalised measures times $\\sqrt d$ are positive: {limits}"
    return holds(EVERY_D, words, proof=("rate", letter, "thickness"))


for _letter in MINIMAL_DIMENSION:
    claim(
        f"sec5.rate.{_letter}",
        "Section 5",
        Weight.RESULT,
        words=f"All normalised measures of {_letter}~_d are of the order d^({{power}}).",
        to_state=("def-18",),
        to_prove=(f"tab-2.{_letter}",),
    )(partial(judge_rate, _letter))
