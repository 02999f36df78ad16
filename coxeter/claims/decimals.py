"""Tables 3 to 6, cell by cell.

Before the cells of a row are compared they are brought back to their columns. A row that ends in empty
cells has lost as many cells elsewhere, and what followed them has moved to the left. Where it belongs
is decided without a look at the numbers, by which triangulations exist: numbers stand where there is
one, dashes where there is none.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import combinations

from ..errors import InvalidInput
from ..exact import Surd
from ..families import evaluate
from ..paper import Paper, PrintedRow
from .core import exact_value, family_of
from .outcomes import Comparison, Outcome, compare_decimal, round_like, units_off

COLUMNS = tuple(range(2, 9))
"""The dimensions at the heads of the columns."""


def compare_decimals(paper: Paper, table: int) -> tuple[Comparison, ...]:
    """All cells of one of Tables 3 to 6; labels and heads only if they are not the expected ones.

    >>> from ..paper import printed
    >>> cell = compare_decimals(printed(), 3)[14]
    >>> cell.printed, cell.exact, cell.rounded, cell.outcome.value
    ('0.666', 2/3, '0.667', 'rounded differently')
    """
    rows = [row for row in paper.rows if row.table == table]
    return tuple(comparison for row in rows for comparison in _compare_row(paper, row))


def printed_decimal(paper: Paper, family: str, quantity: str, d: int) -> tuple[int, str] | None:
    """The table and the text of the cell that belongs to a triangulation; None if there is no number."""
    for row in paper.rows:
        if row.quantity == quantity and row.letter == family[0] and d in COLUMNS:
            for _, slot, text in _align(row):
                if slot == d and _is_number(text):
                    return row.table, text
    return None


def _is_number(text: str) -> bool:
    return re.fullmatch(r"\d+\.\d+", text) is not None


def _align(row: PrintedRow) -> list[tuple[int, int, str]]:
    """For each cell the column it is printed in, the column it belongs in, and its text.

    The empty cells at the end stand for those that were lost.
    """
    kept = len(row.cells)
    while kept and not row.cells[kept - 1]:
        kept -= 1
    exists = [family_of(row.letter, d) is not None for d in COLUMNS]

    def cost(slots: tuple[int, ...]) -> tuple[int, int]:
        wrong = sum((row.cells[i] == "-") == exists[slot] for i, slot in enumerate(slots))
        return wrong, sum(slots)

    best = min(combinations(range(len(COLUMNS)), kept), key=cost)
    lost = [slot for slot in range(len(COLUMNS)) if slot not in best]
    slots = (*best, *lost)
    return [
        (column, COLUMNS[slot], text) for column, slot, text in zip(COLUMNS, slots, row.cells, strict=True)
    ]


def _compare_row(paper: Paper, row: PrintedRow) -> Iterator[Comparison]:
    place = f"Table {row.table}"
    if not row.letter:
        for d, text in zip(COLUMNS, row.cells, strict=True):
            if text != str(d):
                yield Comparison(
                    place=place,
                    family="",
                    quantity="head of the column",
                    printed=text,
                    column=d,
                    outcome=Outcome.DIFFERS,
                    dimensions=(d,),
                    note=f"this column is that of d = {d}",
                )
        return
    expected = rf"\tilde{{{row.letter}}}_{{d}}"
    if row.label != expected:
        others = [r.table for r in paper.rows if r.letter == row.letter and r.label == expected]
        yield Comparison(
            place=place,
            family=row.letter,
            quantity="label of the row",
            printed=row.label,
            outcome=Outcome.TRANSCRIPTION if others else Outcome.DIFFERS,
            dimensions=(),
            note=f"the label of the row is {expected}",
            evidence=f"the same row is labelled {expected} in Tables {', '.join(map(str, others))}",
        )
    for column, d, text in _align(row):
        yield _compare_cell(paper, row, column, d, text)


def _compare_cell(paper: Paper, row: PrintedRow, column: int, d: int, text: str) -> Comparison:
    family = family_of(row.letter, d)
    exact = exact_value(family, row.quantity, d) if family else None
    if text == "-" or exact is None:
        outcome, note, evidence = _compare_absent(row, column, d, text, exact)
    elif not text:
        outcome = Outcome.TRANSCRIPTION
        note = f"our copy has lost the cell of {row.letter}~{d}"
        evidence = f"{_shortness(row)}; {_elsewhere(paper, row, d)}"
    elif not _is_number(text):
        outcome, note, evidence = Outcome.DIFFERS, "not a decimal number", ""
    else:
        outcome, note, evidence = _compare_number(paper, row, column, d, text, exact)
    digits = text if _is_number(text) else "0.000"
    return Comparison(
        place=f"Table {row.table}",
        family=family or row.letter,
        quantity=row.quantity,
        printed=text,
        outcome=outcome,
        dimensions=(d,),
        exact=exact,
        column=column,
        note=note,
        evidence=evidence,
        fails_at=() if outcome is Outcome.AGREES else (d,),
        rounded=None if exact is None else round_like(digits, exact),
    )


def _compare_absent(
    row: PrintedRow, column: int, d: int, text: str, exact: Surd | None
) -> tuple[Outcome, str, str]:
    """A cell that belongs where there is no triangulation, or a dash where there is one."""
    name = f"{row.letter}~{d}"
    if exact is not None:
        return Outcome.DIFFERS, f"there is a triangulation {name}", ""
    if text == "-" and (column == d or family_of(row.letter, column) is None):
        return Outcome.AGREES, f"there is no triangulation {name}", ""
    if text == "-":
        note = f"our copy shows it in the column of d = {column}; it belongs to {name}, which does not exist"
        return Outcome.TRANSCRIPTION, note, f"{_shortness(row)}, and {row.letter}~{column} exists"
    if not text:
        return Outcome.TRANSCRIPTION, "our copy has lost one of the row's dashes", _shortness(row)
    return Outcome.DIFFERS, f"there is no triangulation {name}", ""


def _compare_number(
    paper: Paper, row: PrintedRow, column: int, d: int, text: str, exact: Surd
) -> tuple[Outcome, str, str]:
    outcome = compare_decimal(text, exact)
    evidence = "" if outcome is Outcome.AGREES else _source(paper, row, d, text, exact)
    note = {
        Outcome.AGREES: "correctly rounded",
        Outcome.ROUNDED_DIFFERENTLY: f"correctly rounded it is {round_like(text, exact)}",
        Outcome.DIFFERS: f"the value is {round_like(text, exact)}",
    }[outcome]
    if column == d:
        return outcome, note, evidence
    moved = f"our copy shows it in the column of d = {column}, it belongs to {row.letter}~{d}"
    here = family_of(row.letter, column)
    there = f"there is no {row.letter}~{column}"
    if here:
        rounded = round_like(text, exact_value(here, row.quantity, column))
        there = f"the value of {row.letter}~{column} rounds to {rounded}"
    shift = f"{_shortness(row)}; {there}; the value of {row.letter}~{d} rounds to {round_like(text, exact)}"
    if outcome is Outcome.AGREES:
        return Outcome.TRANSCRIPTION, moved, shift
    return outcome, f"{note}; besides, {moved}", f"{evidence}; {shift}"


def _source(paper: Paper, row: PrintedRow, d: int, text: str, exact: Surd) -> str:
    """Whether the formula of Table 2, as printed, gives a decimal that is not the correct rounding."""
    value = table2_value(paper, f"{family_of(row.letter, d)}", row.quantity, d)
    off = units_off(text, exact)
    if value is None:
        return off
    given = round_like(text, value)
    if value == exact:
        return f"{off}; the formula that Table 2 prints is exact here, so the slip is this decimal's alone"
    if given == text:
        return f"{off}; the formula that Table 2 prints gives {text} as well: one wrong value in two places"
    return f"{off}; the formula that Table 2 prints gives {given}, neither this nor the exact value"


def table2_value(paper: Paper, family: str, quantity: str, d: int) -> Surd | None:
    """The value of the formula that Table 2 prints."""
    parity = "odd" if d % 2 else "even"
    for f in paper.formulas:
        same = (f.place, f.family, f.quantity) == ("Table 2", family, quantity)
        if same and f.text and f.parity in ("", parity):
            try:
                return evaluate(f.text, d=d)
            except (InvalidInput, ZeroDivisionError):
                return None
    return None


def _shortness(row: PrintedRow) -> str:
    kept = [text for text in row.cells if text]
    return f"the row has {len(kept)} cells for {len(row.cells)} columns"


def _elsewhere(paper: Paper, row: PrintedRow, d: int) -> str:
    """Where the same row has a number for the same dimension."""
    others = [r for r in paper.rows if r.letter == row.letter and r.table != row.table]
    tables = [r.table for r in others if any(c == d == s and _is_number(t) for c, s, t in _align(r))]
    if not tables:
        return "no other table has it"
    return f"the same row has a number in this column in Table {', '.join(map(str, tables))}"
