"""Tables 1 to 6 of the paper, and that of the regular simplex, computed anew to any dimension.

A `Table` holds exact values; `Table.render` writes it as text, Markdown, LaTeX, CSV or JSON, its
decimals rounded once.
"""

from __future__ import annotations

import csv
import html
import io
import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING

from .affine import CoxeterTriangulation
from .delaunay import delaunay_verdict, protection
from .errors import InvalidInput
from .exact import Surd
from .lattices import vertex_lattice
from .names import Type, triangulations_up_to
from .quality import (
    Measure,
    aspect_ratio,
    fatness,
    radius_ratio,
    thickness,
)
from .simplex import regular_simplex

if TYPE_CHECKING:
    from .claims import Comparison

Cell = Surd | str | None

FORMATS = ("text", "md", "latex", "csv", "json")


@dataclass(frozen=True)
class Table:
    """A table of exact values.

    Attributes
    ----------
    title
        What is tabulated.
    header
        The column headings; the first is that of the row names.
    rows
        Rows of cells: a row name, then exact numbers, text, or None where there is nothing.
    """

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]

    def render(self, format: str = "text", digits: int = 3, exact: bool = False) -> str:
        """The table in one of the formats ``text``, ``md``, ``latex``, ``csv`` and ``json``.

        Parameters
        ----------
        format
            The format. JSON gives each exact value as an object with ``exact`` and ``decimal``.
        digits
            Digits after the point of the decimals, correctly rounded (a tie to the even digit); numbers
        that would lose all digits are given in scientific notation.
        exact
            Write the exact values instead of decimals.

        Raises
        ------
        InvalidInput
            If there is no such format, or the number of digits is negative.
        """
        if format not in FORMATS:
            raise InvalidInput(f"{format!r} is no format; there are {', '.join(FORMATS)}")
        if digits < 0:
            raise InvalidInput(f"{digits} digits cannot be shown: give a number >= 0")
        if format == "json":
            return self._json(digits)
        write = _writer(digits, exact, latex=format == "latex")
        body = [[write(cell) for cell in row] for row in self.rows]
        return _RENDERERS[format](self, body)

    def _json(self, digits: int) -> str:
        rows = [
            {
                name: {"exact": str(cell), "decimal": cell.decimal(digits)}
                if isinstance(cell, Surd)
                else cell
                for name, cell in zip(self.header, row, strict=True)
            }
            for row in self.rows
        ]
        return json.dumps({"title": self.title, "rows": rows}, indent=1, ensure_ascii=False)

    def __repr__(self) -> str:
        return self.render("text")

    def _repr_html_(self) -> str:
        def cell(value: Cell) -> str:
            exact = f' title="{html.escape(str(value))}"' if isinstance(value, Surd) else ""
            return f"<td{exact}>{_html(_writer(3, False, latex=False)(value))}</td>"

        head = "".join(f"<th>{html.escape(name)}</th>" for name in self.header)
        body = "".join("<tr>" + "".join(map(cell, row)) + "</tr>" for row in self.rows)
        return (
            f'<div class="table-box"><table><caption>{html.escape(self.title)}</caption>'
            f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
        )


def _html(text: str) -> str:
    """Text as HTML, with ``u_1``, ``B~3`` and ``(0^{3}, 1)`` set as one writes them."""
    escaped = html.escape(text)
    if "\\" in escaped:
        return escaped  # LaTeX of the printed text, shown as it is
    raised = re.sub(r"\^(\{[^{}]*\})", r"<sup>\1</sup>", escaped)
    tilde = re.sub(r"\b([A-G])~(\d*)", "\\1\N{COMBINING TILDE}<sub>\\2</sub>", raised)
    return re.sub(r"(?<=\b[usτhλ])_(\w+)", r"<sub>\1</sub>", tilde)


def _writer(digits: int, exact: bool, latex: bool) -> Callable[[Cell], str]:
    def write(cell: Cell) -> str:
        if not isinstance(cell, Surd):
            return cell or ""
        if not exact:
            lost = cell and abs(cell) < Fraction(1, 10**digits)
            return cell.scientific(digits + 1) if lost else cell.decimal(digits)
        return f"${cell.latex()}$" if latex else str(cell)

    return write


def _as_text(table: Table, body: list[list[str]]) -> str:
    lines = [list(table.header), *([x or "-" for x in row] for row in body)]
    widths = [max(len(line[i]) for line in lines) for i in range(len(table.header))]
    rule = "  ".join("-" * w for w in widths)
    out = ["  ".join(x.ljust(w) for x, w in zip(line, widths, strict=True)).rstrip() for line in lines]
    return "\n".join([table.title, "", out[0], rule, *out[1:]])


def _as_markdown(table: Table, body: list[list[str]]) -> str:
    lines = [list(table.header), ["---"] * len(table.header), *([x or "–" for x in row] for row in body)]
    return "\n".join(["| " + " | ".join(line) + " |" for line in lines])


def _as_latex(table: Table, body: list[list[str]]) -> str:
    lines = [list(table.header), *([x or "--" for x in row] for row in body)]
    rows = [" & ".join(_tex(x) for x in line) + r" \\" for line in lines]
    columns = "l" + "c" * (len(table.header) - 1)
    top, bottom = rf"\begin{{tabular}}{{{columns}}}", r"\end{tabular}"
    return "\n".join([top, r"\hline", rows[0], r"\hline", *rows[1:], r"\hline", bottom])


def _tex(text: str) -> str:
    return text if text.startswith("$") else text.replace("~", r"\textasciitilde{}").replace("_", r"\_")


def _as_csv(table: Table, body: list[list[str]]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([table.header, *body])
    return out.getvalue().rstrip("\n")


_RENDERERS: dict[str, Callable[[Table, list[list[str]]], str]] = {
    "text": _as_text,
    "md": _as_markdown,
    "latex": _as_latex,
    "csv": _as_csv,
}

TABLES = ("1", "2", "3", "4", "5", "6", "regular")


def table(number: object, max_dim: int = 8) -> Table:
    """One of the paper's tables, from exact values, up to a dimension.

    Parameters
    ----------
    number
        1 to 6, or ``"regular"`` for the unnumbered table of the regular simplex.
    max_dim
        The largest dimension shown, at least 2.

    Raises
    ------
    InvalidInput
        If there is no such table, or the dimension is less than 2.

    Examples
    --------
    >>> print(table(6, max_dim=4).render("csv"))
    family,2,3,4
    A~,1.000,0.866,0.816
    B~,,0.433,0.447
    C~,0.577,0.500,0.447
    D~,,,0.447
    F~,,,0.298
    G~,0.500,,
    """
    if str(number) not in TABLES:
        raise InvalidInput(f"there is no table {number}; there are {', '.join(TABLES)}")
    if isinstance(max_dim, bool) or not isinstance(max_dim, int) or max_dim < 2:
        raise InvalidInput(f"{max_dim} is no dimension to tabulate up to: give an integer >= 2")
    return _MAKERS[str(number)](max_dim)


def measure_table(measure: Measure, max_dim: int, title: str = "") -> Table:
    """A normalised measure of all triangulations: a row for each letter, a column for each dimension."""
    values: dict[str, dict[int, Surd]] = {}
    for kind in triangulations_up_to(max_dim):
        row = values.setdefault(kind.letter, {})
        row[kind.rank] = measure.normalized(CoxeterTriangulation(kind).simplex)
    columns = range(2, max_dim + 1)
    return Table(
        title or f"Normalised {measure.name.replace('_', ' ')}",
        ("family", *map(str, columns)),
        tuple((f"{letter}~", *(values[letter].get(d) for d in columns)) for letter in sorted(values)),
    )


def _vertices(max_dim: int) -> Table:
    def row(kind: Type) -> tuple[Cell, ...]:
        matrix = CoxeterTriangulation(kind).simplex.vertex_matrix
        return (kind.affine, "; ".join(f"u_{k} = {runs(v)}" for k, v in enumerate(matrix.rows())))

    kinds = triangulations_up_to(max_dim)
    return Table(
        "Table 1: vertices of the fundamental simplices", ("type", "vertices"), tuple(map(row, kinds))
    )


def runs(vector: tuple[object, ...]) -> str:
    """A vector as the paper writes it, with repeated coordinates as powers.

    >>> runs(("1/2", "1/2", 0, 0, 0))
    '((1/2)^{2}, 0^{3})'
    """
    parts: list[tuple[str, int]] = []
    for text in map(str, vector):
        if parts and parts[-1][0] == text:
            parts[-1] = (text, parts[-1][1] + 1)
        else:
            parts.append((text, 1))

    def write(text: str, n: int) -> str:
        if n == 1:
            return text
        return f"{text}^{{{n}}}" if text.isdigit() else f"({text})^{{{n}}}"

    return "(" + ", ".join(write(text, n) for text, n in parts) + ")"


def _summary(max_dim: int) -> Table:
    def row(kind: Type) -> tuple[Cell, ...]:
        t = CoxeterTriangulation(kind)
        verdict, lattice = delaunay_verdict(t), vertex_lattice(t)
        qualities = [m.normalized(t.simplex) for m in (fatness, aspect_ratio, thickness, radius_ratio)]
        return (kind.affine, *qualities, _yes(verdict), protection(t).relative, _yes(lattice))

    return Table(
        "Table 2: normalised quality, Delaunay property, relative protection, vertex set a lattice",
        (
            "type",
            "fatness^(1/d)",
            "aspect ratio",
            "thickness",
            "radius ratio",
            "Delaunay",
            "protection",
            "lattice",
        ),
        tuple(row(kind) for kind in triangulations_up_to(max_dim)),
    )


def _yes(truth: object) -> str:
    return "yes" if truth else "no"


def _regular(max_dim: int) -> Table:
    measures = (fatness, aspect_ratio, thickness, radius_ratio)
    return Table(
        "The regular simplex, not normalised",
        ("d", *(m.name.replace("_", " ") for m in measures)),
        tuple((str(d), *(m(regular_simplex(d)) for m in measures)) for d in range(2, max_dim + 1)),
    )


@cache
def _section6(family: str) -> tuple[Comparison, ...]:
    from .claims import compare_section6  # it needs SymPy, which takes longer to load than all else here

    return compare_section6(family)


def section6_comparison(family: str, item: int) -> Table:
    """What one item of a family's part of Section 6 prints, held against the exact values.

    Parameters
    ----------
    family
        One of ``A``, ``B``, ``C``, ``D``, ``E6``, ``E7``, ``E8``, ``F4``, ``G2``.
    item
        1 to 9.
    """
    shown = [x for x in _section6(family) if x.place.endswith(f"item {item}")]
    return Table(
        f"Item {item}, as printed",
        ("quantity", "printed", "outcome", "found"),
        tuple((x.quantity.replace("_", " "), x.printed, x.outcome.value, x.note) for x in shown),
    )


def table_comparison(number: int, transcription: bool = False) -> Table:
    """The cells of Table 1 to 6 whose printed value is wrong, with the evidence.

    Parameters
    ----------
    number
        The number of the table.
    transcription
        Show the cells in which our copy is damaged instead.
    """
    from .claims import Outcome, compare_table

    outcomes = (Outcome.TRANSCRIPTION,) if transcription else (Outcome.DIFFERS, Outcome.ROUNDED_DIFFERENTLY)
    shown = [x for x in compare_table(number) if x.outcome in outcomes]
    return Table(
        f"Table {number}: {'damage of our copy' if transcription else 'wrong in print'}",
        ("type", "d", "quantity", "printed", "found", "evidence"),
        tuple(
            (
                x.family,
                str(x.dimension or ""),
                x.quantity.removeprefix("normalized_").replace("_", " "),
                x.printed,
                x.note,
                x.evidence,
            )
            for x in shown
        ),
    )


_MAKERS: dict[str, Callable[[int], Table]] = {
    "1": _vertices,
    "2": _summary,
    "3": lambda n: measure_table(aspect_ratio, n, "Table 3: normalised aspect ratio"),
    "4": lambda n: measure_table(radius_ratio, n, "Table 4: normalised radius ratio"),
    "5": lambda n: measure_table(fatness, n, "Table 5: normalised fatness, to the power 1/d"),
    "6": lambda n: measure_table(thickness, n, "Table 6: normalised thickness"),
    "regular": _regular,
}
