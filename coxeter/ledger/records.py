"""Claims made from the paper's data, one for each printed formula, decimal, point and statement.

The verdict on a formula for an infinite family is reached for every d: by a proof of the closed form, and by
the normal form of both formulas. What a comparison finds beside it, such as where else the same value is printed,
is the evidence.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import lru_cache
from typing import Any

from ..claims import Comparison, Outcome
from ..claims.core import DEFINITIONS, LETTERS, dimensions, exact_value, family_of, letters
from ..claims.decimals import COLUMNS, compare_decimals
from ..claims.formulas import compare_formula
from ..claims.outcomes import compare_decimal, round_like
from ..exact import show
from ..families import ClosedForm, Piece, closed_form, evaluate
from ..names import MINIMAL_DIMENSION
from ..paper import PrintedFormula, printed
from .claim import Claim, Constants, Finding, corrected, damaged, holds, register
from .vocabulary import EVERY_D, FINITE, Strength, Weight

SHORT = {
    "normalized_aspect_ratio": "aspect-ratio",
    "normalized_fatness": "fatness",
    "normalized_thickness": "thickness",
    "normalized_radius_ratio": "radius-ratio",
}
TABLES = {3: "normalized_aspect_ratio", 4: "normalized_radius_ratio", 5: "normalized_fatness",
          6: "normalized_thickness"}  # fmt: skip


def strength_for(family: str) -> Strength:
    """Infinite families are settled for every d, the others by one computation."""
    return EVERY_D if family in MINIMAL_DIMENSION or family == "regular" else FINITE


def place_id(place: str, family: str) -> str:
    """The beginning of the ids of a place.

    >>> place_id("Section 6, E~8, item 3", "E8"), place_id("Table 2", "A"), place_id("Section 6, G~2", "G2")
    ('sec6.E8.item-3', 'tab-2.A', 'sec6.G2.item-6')
    """
    if match := re.fullmatch(r"Section 6, (.)~(\d?), item (\d)", place):
        return f"sec6.{match[1]}{match[2]}.item-{match[3]}"
    if match := re.fullmatch(r"Table (\d)", place):
        return f"tab-{match[1]}.{family}"
    if match := re.fullmatch(r"Appendix ., (?:(end of the )?(proof of ))?(Lemma|Proposition) (\d+)", place):
        item = {"Lemma": "lem", "Proposition": "prop"}[match[3]] + f"-{match[4]}"
        return item + (".end" if match[1] else ".proof" if match[2] else "")
    return {
        "Section 6, G~2": "sec6.G2.item-6",
        "Section 5, table of the regular simplex": "tab-regular",
        "Theorem 8": "thm-8",
        "Appendix C, Claim": "claim-c",
    }[place]


def unique(ids: Iterable[str]) -> list[str]:
    """Number ids that occur more than once: x, x-2, x-3."""
    seen: Counter[str] = Counter()
    found = []
    for id in ids:
        seen[id] += 1
        found.append(id if seen[id] == 1 else f"{id}-{seen[id]}")
    return found


def family_words(family: str) -> str:
    """A family as the statements name it."""
    return "the regular simplex" if family == "regular" else f"{family[0]}~{family[1:] or '_d'}"


# -- formulas --------------------------------------------------------------------------------------------


def formula_claims(wanted: Callable[[PrintedFormula], bool]) -> None:
    """Enter a claim for each printed formula that is wanted."""
    records = [f for f in printed().formulas if wanted(f)]
    for id, f in zip(unique(map(_formula_id, records)), records, strict=True):
        words = f"the {f.quantity.replace('_', ' ')} of {family_words(f.family)}"
        words += f" for {f.parity} d" if f.parity else ""
        constants = {"decimal" if f.decimal else "formula": f.text} if f.text else {}
        stated = f"{words[0].upper()}{words[1:]} is " + ("{decimal}." if f.decimal else "{formula}.")
        weight = Weight.PROOF if ".proof" in id or ".end" in id else Weight.RESULT
        weight = Weight.WORDING if is_expression(f) else weight
        needs = _needs(f, id)
        register(
            Claim(
                id,
                f.place,
                stated,
                weight,
                _formula_check(f),
                constants,
                *needs,
                code=f"{__name__}.judge_formula",
            )
        )


def _formula_id(f: PrintedFormula) -> str:
    what = SHORT.get(f.quantity, f.quantity.replace("_", "-"))
    if is_expression(f):
        what += "-expression"
    if f.place == "Section 6, G~2" and f.quantity == "fatness":
        return "sec6.G2.item-7.fatness"
    base = place_id(f.place, f.family)
    return f"{base}.{what}" + (f"-{f.parity}" if f.parity else "") + ("-decimal" if f.decimal else "")


def _needs(f: PrintedFormula, id: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What a formula needs to be stated and what it is computed from."""
    stated = ("def-18",) if f.quantity in SHORT or f.quantity.removeprefix("normalized_") in (
        "aspect_ratio", "fatness", "thickness", "radius_ratio") else ()  # fmt: skip
    if f.place == "Table 2":
        return (*stated, "thm-5"), (f"sec6.{f.family}",)
    return stated, ()


def _formula_check(f: PrintedFormula) -> Callable[[Constants], Finding]:
    def check(constants: Constants) -> Finding:
        return judge_formula(f, constants)

    return check


def judge_formula(f: PrintedFormula, constants: Constants) -> Finding:
    """The verdict on a formula, or on a decimal, with any constants in place of the printed ones."""
    given = constants.get("decimal" if f.decimal else "formula", "")
    asked = replace(f, text=str(given))
    first = constants.get("first")
    if asked.text and (_decimal_is_right(asked) if f.decimal else _formula_is_right(asked, first)):
        return holds(strength_for(f.family), proof=_proof(f))
    return _formula_finding(f) if asked == f and first is None else corrected(strength_for(f.family), "")


def _decimal_is_right(f: PrintedFormula) -> bool:
    (d,) = dimensions(f.family)
    return f.text == round_like(f.text, exact_value(f.family, f.quantity, d))


def _formula_is_right(f: PrintedFormula, first: int | None) -> bool:
    """Whether a formula is right from its first dimension on, and that is the first for which it is."""
    if f.family not in MINIMAL_DIMENSION and f.family != "regular":
        (d,) = dimensions(f.family)
        return _right_at(f, d) and (not is_expression(f) or _keeps_scale(f.text, f.family, d))
    low = MINIMAL_DIMENSION.get(f.family, 1)
    if f.quantity == "squared_edge":
        return first is None and _edges_are_right(f.text)
    if first is not None and (first < low or (first > low and _right_at(f, first - 1))):
        return False
    start = low if first is None else first
    return all(_right_on(f, piece, start) for piece in true_form(f).pieces if _concerns(piece, f, start))


def _value(text: str, family: str, d: int) -> Any:
    return evaluate(text, **letters(family, d))


def is_expression(f: PrintedFormula) -> bool:
    """Whether it names other quantities, as h/L does."""
    return not f.decimal and re.search(r"\b(h|L|r|R|vol)\b", f.text) is not None


def _keeps_scale(text: str, family: str, d: int) -> bool:
    """Whether an expression has the same value for a simplex twice as large: else L = 1 would hide an error."""
    twice = {name: value * (2**d if name == "vol" else 2 if name in LETTERS.values() else 1)
             for name, value in letters(family, d).items()}  # fmt: skip
    return bool(evaluate(text, **twice) == _value(text, family, d))


def _right_at(f: PrintedFormula, d: int) -> bool:
    return bool(_value(f.text, f.family, d) == exact_value(f.family, f.quantity, d))


def _concerns(piece: Piece, f: PrintedFormula, start: int) -> bool:
    parities = {piece.parity, f.parity or None} - {None}
    return len(parities) < 2 and (piece.high is None or piece.high >= start)


def _right_on(f: PrintedFormula, piece: Piece, start: int) -> bool:
    """Whether a formula is right throughout the range of a piece of the closed form."""
    from ..symbolic.radicals import equal_for_every_d

    if piece.high is not None:
        return all(_right_at(f, d) for d in range(max(piece.low, start), piece.high + 1))
    text = with_letters(f.text, f.family, piece)
    parity = piece.parity or f.parity or None
    return equal_for_every_d(text, piece.text, max(piece.low, start), parity)


def with_letters(text: str, family: str, piece: Piece) -> str:
    """A formula in h, L, r, R, vol as one in d, by the closed forms in the range of a piece."""
    from ..symbolic.radicals import substitute

    used = {letter: name for name, letter in LETTERS.items() if re.search(rf"\b{letter}\b", text)}
    forms = {letter: _in_range(closed_form(family, name), piece) for letter, name in used.items()}
    return substitute(text, **forms)


def _in_range(form: ClosedForm, piece: Piece) -> str:
    return next(p.text for p in form.pieces if p.high is None and p.parity in (None, piece.parity))


def true_form(f: PrintedFormula) -> ClosedForm:
    """The closed form of what a printed formula is about."""
    if f.quantity == "protection":
        relative, radius = (
            closed_form("A", name).pieces[0] for name in ("relative_protection", "circumradius")
        )
        return ClosedForm("A", f.quantity, (Piece(f"({relative.text})*({radius.text})", 2),))
    if f.quantity == "mirror_distance":
        relative, radius = (
            closed_form("A", name).pieces[0] for name in ("relative_protection", "circumradius")
        )
        return ClosedForm("A", f.quantity, (Piece(f"(1 + {relative.text})*({radius.text})", 2),))
    return closed_form(f.family, f.quantity)


def _edges_are_right(text: str) -> bool:
    """The squared edges of A~ for every d and all j < k."""
    from ..proofs.classical import FAMILIES, vertex
    from ..symbolic.cases import case
    from ..symbolic.runs import runs, squared_distance

    nodes = FAMILIES["A"].nodes[1]
    inside, outside = case("1 <= j < k <= d"), case("1 <= k <= d")
    first = runs(*((x.replace("k", "j"), n.replace("k", "j")) for x, n in nodes.vertex))
    origin = runs(("0", "d + 1"))
    return inside.equal_value(text, squared_distance(first, vertex(nodes), inside)) and outside.equal_value(
        re.sub(r"\bj\b", "0", text), squared_distance(origin, vertex(nodes), outside)
    )


def _proof(f: PrintedFormula) -> tuple[str, ...]:
    if f.quantity in ("relative_protection", "protection", "mirror_distance"):
        return ("relative_protection",)
    if f.family == "regular":
        return ("regular_measures",)
    if f.family in MINIMAL_DIMENSION:
        return ("quantity", f.family, "longest_edge" if f.quantity == "squared_edge" else f.quantity)
    return ()


@lru_cache(maxsize=512)
def _formula_finding(f: PrintedFormula) -> Finding:
    """What is wrong with the formula that is printed, what is right, and what speaks for it."""
    comparison = compare_formula(printed(), f)
    strength = strength_for(f.family)
    truth, constants = _truth(f, comparison)
    correction = f"printed {f.text or 'nothing'}; true: {truth}"
    if comparison.outcome is Outcome.TRANSCRIPTION:
        return damaged(strength, correction, comparison.evidence, constants=constants)
    return corrected(
        strength, correction, witness=comparison.note, evidence=comparison.evidence, constants=constants,
        proof=_proof(f),
    )  # fmt: skip


def _truth(f: PrintedFormula, comparison: Comparison) -> tuple[str, Constants]:
    """The right formula, and the constants with which the statement holds."""
    if f.decimal:
        return str(comparison.rounded), {"decimal": comparison.rounded}
    if is_expression(f) and f.quantity in DEFINITIONS:
        return DEFINITIONS[f.quantity], {"formula": DEFINITIONS[f.quantity]}
    if len(dimensions(f.family)) == 1:
        return str(comparison.exact), {"formula": str(comparison.exact)}
    pieces = true_form(f).pieces
    if f.family == "B" and len(pieces) == 2:
        lowest, general = pieces
        words = f"{lowest.text} for d = {lowest.low}, {general.text} from d = {general.low} on"
        return words, {"formula": general.text, "first": general.low}
    text = next(p.text for p in pieces if p.parity in (None, f.parity or None))
    return text, {"formula": text}


# -- Tables 3 to 6 ---------------------------------------------------------------------------------------


def decimal_claims(table: int) -> None:
    """Enter a claim for each cell of Tables 3 to 6 that should have a number, and for each row's dashes and label."""
    place, code = f"Table {table}", f"{__name__}.judge_cell"
    what = TABLES[table].removeprefix("normalized_").replace("_", " ")
    for letter in "ABCDEFG":
        for d in COLUMNS:
            if family := family_of(letter, d):
                cell = _cell(table, letter, d)
                constants = {"decimal": cell.printed} if _is_number(cell.printed) else {}
                words = f"The normalised {what} of {letter}~{d} rounds to {{decimal}}."
                check = _cell_check(table, letter, d)
                needs = ("def-18", "thm-5"), (f"tab-2.{family}.{SHORT[TABLES[table]]}" + _parity(letter, d),)
                register(
                    Claim(
                        f"tab-{table}.{letter}.{d}",
                        place,
                        words,
                        Weight.RESULT,
                        check,
                        constants,
                        *needs,
                        code,
                    )
                )
        words = f"The row of {letter}~ has dashes where there is no such triangulation, and only there."
        register(
            Claim(
                f"tab-{table}.{letter}.dashes",
                place,
                words,
                Weight.WORDING,
                _dash_check(table, letter),
                code=code,
            )
        )
    for c in _cells(table):
        if "label" in c.quantity:
            register(Claim(f"tab-{table}.{c.family}.label", place, "The row is labelled {label}.", Weight.WORDING,
                           _label_check(c), {"label": c.printed}, code=code))  # fmt: skip


def _parity(letter: str, d: int) -> str:
    return "" if letter != "A" else "-odd" if d % 2 else "-even"


def _is_number(text: str) -> bool:
    return re.fullmatch(r"\d+\.\d+", text) is not None


def _cell(table: int, letter: str, d: int) -> Comparison:
    return next(
        c
        for c in _cells(table)
        if c.family[:1] == letter and c.dimensions == (d,) and "label" not in c.quantity
    )


def _dash_check(table: int, letter: str) -> Callable[[Constants], Finding]:
    def check(_: Constants) -> Finding:
        absent = [_cell(table, letter, d) for d in COLUMNS if family_of(letter, d) is None]
        wrong = [c for c in absent if c.outcome is not Outcome.AGREES]
        if not wrong:
            return holds(FINITE)
        words = "; ".join(dict.fromkeys(c.note for c in wrong))
        return damaged(FINITE, words, "; ".join(dict.fromkeys(c.evidence for c in wrong)))

    return check


def _row(letter: str, d: int) -> str:
    return str(family_of(letter, d)) if family_of(letter, d) else letter


@lru_cache(maxsize=8)
def _cells(table: int) -> tuple[Comparison, ...]:
    return compare_decimals(printed(), table)


def _cell_check(table: int, letter: str, d: int) -> Callable[[Constants], Finding]:
    def check(constants: Constants) -> Finding:
        return judge_cell(table, letter, d, constants)

    return check


def judge_cell(table: int, letter: str, d: int, constants: Constants) -> Finding:
    """The verdict on a cell of Tables 3 to 6: a decimal, a dash, or nothing."""
    cell = _cell(table, letter, d)
    exact = exact_value(_row(letter, d), TABLES[table], d)
    text = str(constants.get("decimal", cell.printed))
    if (
        _is_number(text)
        and compare_decimal(text, exact) is Outcome.AGREES
        and (
            text != cell.printed
            or cell.outcome is Outcome.AGREES
            or cell.rounded == text
            and constants.get("placed")
        )
    ):
        return holds(FINITE, f"The exact value is ${exact.latex()}$")
    if text != cell.printed:
        return corrected(FINITE, "")
    true = cell.rounded or round_like("0.000", exact)
    moved = f" in the column of d = {cell.column}" if cell.column not in (None, d) else ""
    correction = f"printed {cell.printed or 'nothing'}{moved}; true: {true}"
    more = {
        "witness": f"the exact value is {show_exact(exact)}",
        "constants": {"decimal": true, "placed": "yes"},
    }
    if cell.outcome is Outcome.TRANSCRIPTION:
        return damaged(FINITE, correction, cell.evidence, **more)
    return corrected(FINITE, correction, evidence=cell.evidence, **more)


def show_exact(x: Any) -> str:
    """An exact value in LaTeX between dollar signs."""
    return show(x) if isinstance(x, tuple) else f"${x.latex()}$"


def _label_check(c: Comparison) -> Callable[[Constants], Finding]:
    def check(constants: Constants) -> Finding:
        right = rf"\tilde{{{c.family}}}_{{d}}"
        if constants["label"] == right:
            return holds(FINITE)
        more = {"constants": {"label": right}}
        return damaged(FINITE, f"printed {constants['label']}; true: {right}", c.evidence, **more)

    return check
