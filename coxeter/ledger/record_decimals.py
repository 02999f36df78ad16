"""Claims made from the paper's data: Tables 3 to 6, cell by cell."""

from __future__ import annotations

import re
from functools import lru_cache, partial

from ..claims import Comparison, Outcome
from ..claims.core import exact_value, family_of
from ..claims.decimals import COLUMNS, compare_decimals
from ..claims.outcomes import compare_decimal, round_like
from ..paper import printed
from .claim import Constants, Finding, agree, claim, corrected, damaged, holds
from .record_formulas import short
from .records import faulty
from .vocabulary import FINITE, Weight


def decimal_claims(table: int) -> None:
    """Enter a claim for a table's heads, each cell that should have a number, each row's dashes and label."""
    place = f"Table {table}"
    heads = next(row.cells for row in printed().rows if row.table == table and not row.letter)
    words = "The columns are those of d = {heads}."
    claim(f"tab-{table}.heads", place, Weight.WORDING, words=words, printed={"heads": heads})(judge_heads)
    for letter in "ABCDEFG":
        for d in COLUMNS:
            if family_of(letter, d):
                _cell_claim(table, letter, d)
        words = f"The row of {letter}~ has dashes where there is no such triangulation, and only there."
        check = partial(judge_dashes, table, letter)
        claim(f"tab-{table}.{letter}.dashes", place, Weight.WORDING, words=words)(check)
    for c in (c for c in _comparisons(table) if "label" in c.quantity):
        claim(
            f"tab-{table}.{c.family}.label",
            place,
            Weight.WORDING,
            words="The row is labelled {label}.",
            printed={"label": c.printed},
        )(partial(judge_label, c))


def _cell_claim(table: int, letter: str, d: int) -> None:
    cell = _cell(table, letter, d)
    measure = short(cell.quantity)
    parity = "" if letter != "A" else "-odd" if d % 2 else "-even"
    claim(
        f"tab-{table}.{letter}.{d}",
        f"Table {table}",
        Weight.RESULT,
        words=f"The normalised {measure.replace('-', ' ')} of {letter}~{d} rounds to {{decimal}}.",
        printed={"decimal": cell.printed} if _is_number(cell.printed) else {},
        to_state=("def-18", "thm-5"),
        to_prove=(f"tab-2.{cell.family}.{measure}{parity}",),
    )(partial(judge_cell, table, letter, d))


def _is_number(text: str) -> bool:
    return re.fullmatch(r"\d+\.\d+", text) is not None


@lru_cache(maxsize=8)
def _comparisons(table: int) -> tuple[Comparison, ...]:
    return compare_decimals(printed(), table)


def _cell(table: int, letter: str, d: int) -> Comparison:
    cells = (c for c in _comparisons(table) if "label" not in c.quantity)
    return next(c for c in cells if c.family[:1] == letter and c.dimensions == (d,))


def judge_heads(constants: Constants) -> Finding:
    """The heads of the columns are the dimensions 2 to 8."""
    return agree(constants, {"heads": tuple(map(str, COLUMNS))}, FINITE)


def judge_dashes(table: int, letter: str, _: Constants) -> Finding:
    """There are dashes in a row where there is no triangulation."""
    absent = [_cell(table, letter, d) for d in COLUMNS if family_of(letter, d) is None]
    wrong = [c for c in absent if c.outcome is not Outcome.AGREES]
    if not wrong:
        return holds(FINITE)
    words = "; ".join(dict.fromkeys(c.note for c in wrong))
    return damaged(FINITE, words, "; ".join(dict.fromkeys(c.evidence for c in wrong)))


def judge_cell(table: int, letter: str, d: int, constants: Constants) -> Finding:
    """The verdict on a cell that should have a number."""
    cell = _cell(table, letter, d)
    exact = exact_value(cell.family, cell.quantity, d)
    text = str(constants.get("decimal", cell.printed))
    if (
        constants.get("column", cell.column) == d
        and _is_number(text)
        and compare_decimal(text, exact) is Outcome.AGREES
    ):
        return holds(FINITE, f"The exact value is ${exact.latex()}$")
    if text != cell.printed or "column" in constants:
        return corrected(FINITE, "")
    true = cell.rounded or round_like("0.000", exact)
    is_moved = cell.column not in (None, d)
    moved = f" in the column of d = {cell.column}" if is_moved else ""
    correction = f"printed {cell.printed or 'nothing'}{moved}; true: {true}"
    witness = f"the exact value is ${exact.latex()}$"
    constants = {"decimal": true} | ({"column": d} if is_moved else {})
    return faulty(FINITE, cell, correction, witness=witness, constants=constants)


def judge_label(c: Comparison, constants: Constants) -> Finding:
    """The label of a row that our copy shows otherwise than the other tables."""
    right = rf"\tilde{{{c.family}}}_{{d}}"
    if constants["label"] == right:
        return holds(FINITE)
    correction = f"printed {constants['label']}; true: {right}"
    return damaged(FINITE, correction, c.evidence, constants={"label": right})
