"""A table of exact values, and how it is written."""

from __future__ import annotations

import csv
import html
import io
import json
import re
from collections.abc import Callable
from dataclasses import dataclass

from ..errors import InvalidInput
from ..exact import Angle, Surd
from .pieces import MATHS, to_html

Cell = Surd | Angle | str | None

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
    marked
        The places (row, column) of cells that are marked as the best of their columns: with a star, in JSON
        with a key ``best``, in CSV by a last row that names them.
    """

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    marked: frozenset[tuple[int, int]] = frozenset()

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
        if format == "csv":
            body += self._best()
        else:
            body = [
                [f"{x}*" if self._is_marked(i, j) else x for j, x in enumerate(r)] for i, r in enumerate(body)
            ]
        return _RENDERERS[format](self, body)

    def _is_marked(self, i: int, j: int) -> bool:
        return (i, j) in self.marked

    def _best(self) -> list[list[str]]:
        """A row with the names of the rows that are marked, column by column."""
        names = [str(row[0]) for row in self.rows]
        columns = range(1, len(self.header) if self.marked else 0)
        best = [" = ".join(x for i, x in enumerate(names) if (i, j) in self.marked) for j in columns]
        return [["best", *best]] if best else []

    def _json(self, digits: int) -> str:
        rows = [
            {
                name: {"exact": str(cell), "decimal": cell.decimal(digits)}
                | ({"best": True} if self._is_marked(i, j) else {})
                if isinstance(cell, (Surd, Angle))
                else cell
                for j, (name, cell) in enumerate(zip(self.header, row, strict=True))
            }
            for i, row in enumerate(self.rows)
        ]
        return json.dumps({"title": self.title, "rows": rows}, indent=1, ensure_ascii=False)

    def __repr__(self) -> str:
        return self.render("text")

    def _repr_html_(self) -> str:
        def cell(value: Cell, marked: bool) -> str:
            star = "*" if marked else ""
            if isinstance(value, (Surd, Angle)):
                text = _writer(3, False, latex=False)(value)
                return f'<td title="{html.escape(str(value))}">{text}{star}</td>'
            inner = _html(value or "")
            plain = f' data-text="{html.escape(value or "")}"' if MATHS in inner else ""
            return f"<td{plain}>{inner}{star}</td>"

        head = "".join(f"<th>{_html(name)}</th>" for name in self.header)
        cells = [[cell(x, self._is_marked(i, j)) for j, x in enumerate(r)] for i, r in enumerate(self.rows)]
        body = "".join(f"<tr>{''.join(row)}</tr>" for row in cells)
        return (
            f'<div class="table-box"><table><caption>{html.escape(self.title)}</caption>'
            f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
        )


def _html(text: str) -> str:
    """Text as HTML, with ``u_1``, ``B~3``, ``sqrt(3)/2`` and ``(0^{3}, 1)`` set as one writes them."""
    if text.startswith("\\"):  # LaTeX of the printed text, which our copy may have broken
        broken = re.search(r"\\(begin|end)\b|&|\\\\", text) or text.count("{") != text.count("}")
        return html.escape(text) if broken else to_html(f"${text}$")
    return to_html(text).replace("^(1/d)", "<sup>1/d</sup>")


def _writer(digits: int, exact: bool, latex: bool) -> Callable[[Cell], str]:
    def write(cell: Cell) -> str:
        if not isinstance(cell, (Surd, Angle)):
            return cell or ""
        if not exact:
            decimal = cell.decimal(digits)
            return cell.scientific(digits + 1) if cell and not decimal.strip("-0.") else decimal
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
    """Text as LaTeX: names of types, and vectors with powers, are formulas."""
    if text.startswith("$"):
        return text
    if name := re.fullmatch(r"([A-G])~(\d*)", text):
        return rf"$\tilde{{{name[1]}}}_{{{name[2]}}}$" if name[2] else rf"$\tilde{{{name[1]}}}$"
    if "^{" in text:
        return "$" + re.sub(r"_(\w+)", r"_{\1}", text) + "$"
    return text.replace("^(1/d)", "$^{1/d}$").replace("_", r"\_")


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
