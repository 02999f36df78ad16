"""Claims made from the paper's data: the printed formulas, and the decimals outside Tables 3 to 6."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache, partial
from typing import Any

from ..claims import Comparison, Outcome
from ..claims.core import DEFINITIONS, LETTERS, dimensions, exact_value, letters
from ..claims.formulas import compare_formula
from ..claims.outcomes import round_like
from ..exact import Surd
from ..families import ClosedForm, Piece, closed_form, evaluate
from ..names import MINIMAL_DIMENSION
from ..paper import PrintedFormula, printed
from .claim import Constants, Finding, claim, corrected, holds
from .records import family_words, faulty, place_id, strength_for, unique
from .vocabulary import Weight


def formula_claims(wanted: Callable[[PrintedFormula], bool]) -> None:
    """Enter a claim for each printed formula that is wanted."""
    records = [f for f in printed().formulas if wanted(f)]
    for id, f in zip(unique(map(_id, records)), records, strict=True):
        quantity = f.quantity.replace("_", " ").replace("normalized", "normalised")
        words = f"the {quantity} of {family_words(f.family)}"
        words += f" for {f.parity} d" if f.parity else ""
        in_a_proof = ".proof" in id or ".end" in id
        kind = _kind(f)
        to_state, to_prove = _needs(f)
        claim(
            id,
            f.place,
            Weight.WORDING if is_expression(f) else Weight.PROOF if in_a_proof else Weight.RESULT,
            words=f"{words[0].upper()}{words[1:]} is {{{kind}}}.",
            printed={kind: f.text} if f.text else {},
            to_state=to_state,
            to_prove=to_prove,
        )(partial(judge_formula, f))


def _kind(f: PrintedFormula) -> str:
    """The name of its constant."""
    return "decimal" if f.decimal else "formula"


def short(quantity: str) -> str:
    """A quantity in ids: those of Table 2 are all normalised."""
    return quantity.removeprefix("normalized_").replace("_", "-")


def _id(f: PrintedFormula) -> str:
    if f.place == "Section 6, G~2" and f.quantity == "fatness":
        return "sec6.G2.item-7.fatness"
    what = short(f.quantity) + ("-expression" if is_expression(f) else "")
    ending = (f"-{f.parity}" if f.parity else "") + ("-decimal" if f.decimal else "")
    return f"{place_id(f.place, f.family)}.{what}{ending}"


def _needs(f: PrintedFormula) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What a formula needs to be stated and what it is computed from."""
    stated = ("def-18",) if f.quantity.removeprefix("normalized_") in DEFINITIONS else ()
    if f.place == "Table 2":
        return (*stated, "thm-5"), (f"sec6.{f.family}",)
    return stated, ()


def judge_formula(f: PrintedFormula, constants: Constants) -> Finding:
    """The verdict on a formula, or on a decimal, with any constants in place of the printed ones."""
    asked = replace(f, text=str(constants.get(_kind(f), "")))
    first = constants.get("first")
    if asked.text and (_decimal_is_right(asked) if f.decimal else _formula_is_right(asked, first)):
        return holds(strength_for(f.family), proof=_proof(f))
    return _finding(f) if asked == f and first is None else corrected(strength_for(f.family), "")


def _proof(f: PrintedFormula) -> tuple[str, ...]:
    if f.quantity == "relative_protection" or f.quantity in PROTECTED:
        return ("relative_protection",)
    if f.family == "regular":
        return ("regular_measures",)
    if f.family in MINIMAL_DIMENSION:
        return ("quantity", f.family, "longest_edge" if f.quantity == "squared_edge" else f.quantity)
    return ()


# -- whether a formula is right ---------------------------------------------------------------------------


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


def is_expression(f: PrintedFormula) -> bool:
    """Whether it names other quantities, as h/L does."""
    return not f.decimal and re.search(r"\b(h|L|r|R|vol)\b", f.text) is not None


def doubled(family: str, d: int) -> dict[str, Surd]:
    """The letters of formulas for a simplex twice as large: with one size alone L = 1 would hide an error."""
    factors = dict.fromkeys(LETTERS.values(), 2) | {"vol": 2**d}
    return {name: value * factors.get(name, 1) for name, value in letters(family, d).items()}


def _keeps_scale(text: str, family: str, d: int) -> bool:
    return bool(evaluate(text, **doubled(family, d)) == evaluate(text, **letters(family, d)))


def _right_at(f: PrintedFormula, d: int) -> bool:
    return bool(evaluate(f.text, **letters(f.family, d)) == exact_value(f.family, f.quantity, d))


def _concerns(piece: Piece, f: PrintedFormula, start: int) -> bool:
    parities = {piece.parity, f.parity or None} - {None}
    return len(parities) < 2 and (piece.high is None or piece.high >= start)


def _right_on(f: PrintedFormula, piece: Piece, start: int) -> bool:
    """Whether a formula is right throughout the range of a piece of the closed form."""
    from ..symbolic.radicals import equal_for_every_d

    low = max(piece.low, start)
    if piece.high is not None:
        return all(_right_at(f, d) for d in range(low, piece.high + 1))
    parity = piece.parity or f.parity or None
    return equal_for_every_d(_in_d(f.text, f.family, piece), piece.text, low, parity)


def _in_d(text: str, family: str, piece: Piece) -> str:
    """A formula in h, L, r, R, vol as one in d, by the closed forms in the range of a piece."""
    from ..symbolic.radicals import substitute

    used = {letter: name for name, letter in LETTERS.items() if re.search(rf"\b{letter}\b", text)}
    forms = {letter: _in_range(closed_form(family, name), piece) for letter, name in used.items()}
    return substitute(text, **forms)


def _in_range(form: ClosedForm, piece: Piece) -> str:
    return next(p.text for p in form.pieces if p.high is None and p.parity in (None, piece.parity))


PROTECTED = {"protection": "({relative})*({radius})", "mirror_distance": "(1 + {relative})*({radius})"}
"""Quantities of A~ that follow from its relative protection and its circumradius."""


def true_form(f: PrintedFormula) -> ClosedForm:
    """The closed form of what a printed formula is about."""
    if f.quantity not in PROTECTED:
        return closed_form(f.family, f.quantity)
    relative, radius = (
        closed_form("A", name).pieces[0].text for name in ("relative_protection", "circumradius")
    )
    text = PROTECTED[f.quantity].format(relative=relative, radius=radius)
    return ClosedForm("A", f.quantity, (Piece(text, 2),))


def _edges_are_right(text: str) -> bool:
    """The squared edges of A~ for every d and all j < k."""
    from ..proofs.classical import FAMILIES, vector
    from ..symbolic.cases import case
    from ..symbolic.runs import runs, squared_distance

    pairs = FAMILIES["A"].nodes[1].vertex
    inside, outside = case("1 <= j < k <= d"), case("1 <= k <= d")
    between = squared_distance(vector(pairs, "j"), vector(pairs, "k"), inside)
    from_origin = squared_distance(runs(("0", "d + 1")), vector(pairs, "k"), outside)
    at_origin = re.sub(r"\bj\b", "0", text)
    return inside.equal_value(text, between) and outside.equal_value(at_origin, from_origin)


# -- what is wrong with it --------------------------------------------------------------------------------


@lru_cache(maxsize=512)
def _finding(f: PrintedFormula) -> Finding:
    """What is wrong with the formula that is printed, what is right, and what speaks for it."""
    comparison = compare_formula(printed(), f)
    truth, constants = _truth(f, comparison)
    more: dict[str, Any] = {"witness": comparison.note, "proof": _proof(f)}
    if comparison.outcome is Outcome.TRANSCRIPTION:
        more = {}
    correction = f"printed {f.text or 'nothing'}; true: {truth}"
    return faulty(strength_for(f.family), comparison, correction, constants=constants, **more)


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
