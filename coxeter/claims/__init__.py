"""What the paper prints, held against what the core computes.

Every verdict is exact; decimals are compared with the correctly rounded exact value. For the infinite
families the comparison is made in every dimension up to 24: these are instances, not a proof.

>>> for x in compare_section6("D"):
...     if x.outcome is Outcome.DIFFERS and x.quantity == "level":
...         print(x.place, "|", x.printed, "|", x.note)
Section 6, D~, item 8 | <s_{d - 2}, c> = -1/4 | holds for d = 5 … 24, fails for d = 4; for d = 4 it is -1/2
"""

from __future__ import annotations

from collections.abc import Callable

from ..errors import InvalidInput
from ..names import FAMILIES
from ..paper import Paper, printed
from .core import affine_name
from .decimals import compare_decimals
from .formulas import compare_formulas
from .outcomes import Comparison, Outcome
from .points import compare_points
from .statements import compare_statements

__all__ = [
    "Comparison",
    "Outcome",
    "compare_appendices",
    "compare_everything",
    "compare_section6",
    "compare_table",
    "compare_theorem8",
]


def compare_table(table: int | str, paper: Paper | None = None) -> tuple[Comparison, ...]:
    """A table of the paper against the core.

    Parameters
    ----------
    table
        1 for the vertices, 2 for the formulas, 3 to 6 for the decimals, cell by cell; ``"regular"`` for
        the unnumbered table of the regular simplex.
    paper
        What the paper prints, if not the data of the library.

    Raises
    ------
    InvalidInput
        If there is no such table.

    Examples
    --------
    >>> from collections import Counter
    >>> sorted(Counter(x.outcome.value for x in compare_table(6)).items())
    [('agrees', 46), ('differs', 2), ('rounded differently', 1), ('transcription', 1)]
    """
    paper = paper or printed()
    if table in (3, 4, 5, 6):
        return compare_decimals(paper, int(table))
    if table in (1, 2):
        return _at(paper, lambda place: place == f"Table {table}")
    if table == "regular":
        return _at(paper, lambda place: "table of the regular simplex" in place)
    raise InvalidInput(f"there is no table {table!r} to compare: give 1 to 6 or 'regular'")


def compare_section6(family: str, paper: Paper | None = None) -> tuple[Comparison, ...]:
    """All that Section 6 prints of a family against the core: formulas, vertices, centres, statements.

    Raises `InvalidInput` if there is no such family.
    """
    if family not in FAMILIES:
        raise InvalidInput(f"{family!r} is no family of Section 6; there are {', '.join(FAMILIES)}")
    section = f"Section 6, {affine_name(family)}"
    return _at(paper or printed(), lambda place: place.partition(", item")[0] == section)


def compare_theorem8(paper: Paper | None = None) -> tuple[Comparison, ...]:
    """The relative protection of the A~ family, wherever it is printed."""
    return compare_formulas(paper or printed(), lambda f: f.quantity == "relative_protection")


def compare_appendices(paper: Paper | None = None) -> tuple[Comparison, ...]:
    """Formulas and points that the appendices print."""
    return _at(paper or printed(), lambda place: place.startswith("Appendix"))


def compare_everything(paper: Paper | None = None) -> tuple[Comparison, ...]:
    """All comparisons, in the order of the data files."""
    paper = paper or printed()
    decimals = (x for table in (3, 4, 5, 6) for x in compare_decimals(paper, table))
    return (*decimals, *_at(paper, _anywhere))


def _anywhere(place: str) -> bool:
    return True


def _at(paper: Paper, here: Callable[[str], bool]) -> tuple[Comparison, ...]:
    return (
        *compare_formulas(paper, lambda f: here(f.place)),
        *compare_points(paper, lambda p: here(p.place)),
        *compare_statements(paper, lambda s: here(s.place)),
    )
