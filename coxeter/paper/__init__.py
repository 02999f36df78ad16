"""What our copy of the paper prints, as data: tables, formulas, points and statements with numbers.

Nothing is computed or judged here, and nothing is repaired: a cell that our copy shows in the wrong column
stands in the wrong column. The data lie in JSON files beside this module, one record to a line:

* ``decimals.json`` — the rows of Tables 3 to 6, cell by cell;
* ``formulas.json`` — Table 2, the table of the regular simplex, the values of Section 6, Theorem 8 and the
  appendices. A formula's letters are d, the indices j and k, and h, L, r, R, vol for the lengths;
* ``points.json`` — vertices and centres, as runs of equal coordinates: ``[["1/2", "k"], ["0", "d - k"]]``.
  In a coordinate that changes along its run, i is the number of the coordinate, counted from 1;
* ``statements.json`` — facets, and sentences that name a vertex, a facet or an edge;
* ``prose/*.json`` — for each claim of the ledger that has any, the constants that are printed in it.

>>> print(printed().rows[1].label, printed().rows[1].cells)
\\tilde{A}_{d} ('1.000', '0.949', '0.894', '0.845', '0.802', '0.764', '0.730')
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from .loading import check_tables, read, read_prose
from .records import (
    DamagedData,
    Paper,
    PrintedFormula,
    PrintedPoint,
    PrintedRow,
    PrintedStatement,
    Runs,
)

__all__ = [
    "DamagedData",
    "Paper",
    "PrintedFormula",
    "PrintedPoint",
    "PrintedRow",
    "PrintedStatement",
    "Runs",
    "load",
    "load_prose",
    "printed",
    "prose",
]


@lru_cache(maxsize=1)
def printed() -> Paper:
    """What our copy of the paper prints."""
    return load(Path(__file__).parent)


def load(directory: Path) -> Paper:
    """Read the data files in a directory.

    Raises
    ------
    DamagedData
        If a file is missing or damaged; the message names the file and the line.
    """
    rows = read(directory / "decimals.json", PrintedRow)
    check_tables(directory / "decimals.json", rows)
    return Paper(
        rows,
        read(directory / "formulas.json", PrintedFormula),
        read(directory / "points.json", PrintedPoint),
        read(directory / "statements.json", PrintedStatement),
    )


@lru_cache(maxsize=1)
def prose() -> Mapping[str, Mapping[str, Any]]:
    """The constants in the paper's sentences, by the id of the claim that is made with them."""
    return load_prose(Path(__file__).parent / "prose")


def load_prose(directory: Path) -> Mapping[str, Mapping[str, Any]]:
    """Read the constants of sentences; raises `DamagedData`, which names the file and the line."""
    return read_prose(sorted(directory.glob("*.json")))
