"""Tables 1 to 6 as they should be, each cell with the claim about what is printed in it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ..affine import triangulation
from ..claims.points import SIGN
from ..exact import Surd
from ..families import Piece, closed_form, latex
from ..names import FAMILIES, MINIMAL_DIMENSION
from ..paper import printed
from ..proofs.classical import FAMILIES as CLASSICAL
from ..proofs.classical import Pairs
from ..tables import Table, table
from .judged import Judged, Ledger
from .wording import runs_latex

DIMENSIONS = tuple(range(2, 9))
"""The columns of Tables 3 to 6, as in the paper."""

MEASURES = {
    "fatness": "fatness^(1/d)",
    "aspect-ratio": "aspect ratio",
    "thickness": "thickness",
    "radius-ratio": "radius ratio",
}
"""The columns of Table 2, in the order of the paper."""

Runs = tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Entry:
    """What should stand in a cell, in plain text and in LaTeX, and the claim about what is printed there."""

    plain: str
    tex: str = ""
    claim: str = ""

    @property
    def latex(self) -> str:
        """The LaTeX of the cell: a formula between dollar signs, or words."""
        return f"${self.tex}$" if self.tex else self.plain


@dataclass(frozen=True)
class Sheet:
    """A table of the paper, corrected."""

    number: int
    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[Entry, ...], ...]

    def render(self, format: str) -> str:
        """The table as ``csv``, ``json`` or ``latex``."""
        cells = [[x.latex if format == "latex" else x.plain for x in row] for row in self.rows]
        return Table(self.title, self.header, tuple(map(tuple, cells))).render(format)

    def changed(self, ledger: Ledger) -> tuple[Judged, ...]:
        """The claims about this table that are not right as printed, in the order of the paper."""
        return tuple(x for x in ledger if x.id.startswith(f"tab-{self.number}.") and x.is_erratum)


def sheets() -> tuple[Sheet, ...]:
    """All six."""
    return (_vertices(), _forms(), *map(_decimals, (3, 4, 5, 6)))


def family_tex(family: str) -> str:
    r"""The name of a family, as ``\tilde{B}_{d}``."""
    return rf"\tilde{{{family[0]}}}_{{{family[1:] or 'd'}}}"


# -- Table 1 -----------------------------------------------------------------------------------------------


def _vertices() -> Sheet:
    rows = tuple(row for family in FAMILIES for row in _vertices_of(family))
    return Sheet(1, "Table 1: vertices of the fundamental simplices", ("type", "vertex", "coordinates"), rows)


def _vertices_of(family: str) -> Iterator[tuple[Entry, ...]]:
    name = Entry(f"{family[0]}~{family[1:]}", family_tex(family))
    for index, where, coordinates in _points(family):
        plain = ", ".join(_power(x, n) for x, n in coordinates)
        claim = f"tab-1.{family}.u-{index.replace(' ', '').replace('-', 'minus')}"
        vertex = Entry(
            f"u_{index}{where}",
            f"u_{{{index}}}" + (rf",\ {where.strip(', ')}".replace("<=", r"\leq") if where else ""),
        )
        yield name, vertex, Entry(f"({plain})", rf"\left({runs_latex(coordinates)}\right)", claim)


def _power(x: str, n: str) -> str:
    return x if n == "1" else f"{x if x.isalnum() else f'({x})'}^{{{n}}}"


def _points(family: str) -> Iterator[tuple[str, str, Runs]]:
    """Index, range and coordinates: proved for every d, or computed; those of G~2 as the paper has them."""
    sign = SIGN.get(family, 1)
    if family in CLASSICAL:
        for nodes in CLASSICAL[family].nodes:
            where = f", {nodes.low} <= k <= {nodes.high}" if nodes.index == "k" else ""
            yield nodes.index, where, _signed(nodes.vertex, sign)
    elif family == "G2":
        for p in printed().points:
            if (p.place, p.family) == ("Table 1", family):
                yield p.index, "", tuple((str(x), str(n)) for x, n in p.runs)
    else:
        matrix = triangulation((family[0], int(family[1:]))).simplex.vertex_matrix
        for k, row in enumerate(matrix.rows()):
            yield str(k), "", _gathered(str(sign * x) for x in row)


def _signed(pairs: Pairs, sign: int) -> Runs:
    if sign == 1:
        return pairs
    return tuple((x[1:] if x.startswith("-") else x if x == "0" else f"-{x}", n) for x, n in pairs)


def _gathered(coordinates: Iterable[str]) -> Runs:
    found: list[tuple[str, int]] = []
    for x in coordinates:
        if found and found[-1][0] == x:
            found[-1] = (x, found[-1][1] + 1)
        else:
            found.append((x, 1))
    return tuple((x, str(n)) for x, n in found)


# -- Table 2 -----------------------------------------------------------------------------------------------


def _forms() -> Sheet:
    header = ("type", *MEASURES.values(), "Delaunay", "lattice", "protection")
    rows = [
        _forms_of(family, parity)
        for family in FAMILIES
        for parity in (("odd", "even") if family == "A" else ("",))
    ]
    return Sheet(
        2,
        "Table 2: normalised quality, Delaunay property, lattices, relative protection",
        header,
        tuple(rows),
    )


def _forms_of(family: str, parity: str) -> tuple[Entry, ...]:
    name = f"{family[0]}~{family[1:]}" + (f", d {parity}" if parity else "")
    tex = family_tex(family) + (rf",\ d \text{{ {parity}}}" if parity else "")
    cells = [Entry(name, tex)]
    for measure in MEASURES:
        pieces = closed_form(family, f"normalized_{measure.replace('-', '_')}").pieces
        fitting = tuple(p for p in pieces if not parity or p.parity in (None, parity))
        claim = f"tab-2.{family}.{measure}" + (f"-{parity}" if parity else "")
        cells.append(Entry(_plain(fitting), _cases(fitting), claim))
    form = closed_form(family, "relative_protection").pieces[0].text
    answers = {name: _answers(family, name) for name in ("Delaunay", "lattice")}
    return (*cells, Entry(answers["Delaunay"]), Entry(answers["lattice"]), Entry(form, str(latex(form))))


def _plain(pieces: tuple[Piece, ...]) -> str:
    if len(pieces) == 1:
        return pieces[0].text
    return "; ".join(
        f"{p.text} for d = {p.low}" if p.high == p.low else f"{p.text} for d >= {p.low}" for p in pieces
    )


def _cases(pieces: tuple[Piece, ...]) -> str:
    if len(pieces) == 1:
        return str(latex(pieces[0].text))
    cases = r" \\ ".join(rf"{latex(p.text)} & {p.condition}" for p in pieces)
    return rf"\begin{{cases}}{cases}\end{{cases}}"


def _answers(family: str, column: str) -> str:
    """Whether the members of a family have a property; in which dimensions, if they differ."""
    summary = table(2, max_dim=8)
    at = summary.header.index(column)
    found = {str(row[0]): row[at] == "yes" for row in summary.rows if _is_member(str(row[0]), family)}
    if len(set(found.values())) == 1:
        return "yes" if next(iter(found.values())) else "no"
    return "d = " + ", ".join(name[2:] for name, answer in found.items() if answer) + " only"


def _is_member(name: str, family: str) -> bool:
    return name[0] == family if family in MINIMAL_DIMENSION else name.replace("~", "") == family


# -- Tables 3 to 6 -----------------------------------------------------------------------------------------


def _decimals(number: int) -> Sheet:
    exact = table(number, max_dim=DIMENSIONS[-1])
    rows = tuple(_decimal_row(number, str(row[0]), row[1:]) for row in exact.rows)
    return Sheet(number, exact.title, exact.header, rows)


def _decimal_row(number: int, name: str, cells: Iterable[object]) -> tuple[Entry, ...]:
    entries = [Entry(name, rf"\tilde{{{name[0]}}}_{{d}}")]
    for d, cell in zip(DIMENSIONS, cells, strict=True):
        text = cell.decimal(3) if isinstance(cell, Surd) else ""
        entries.append(Entry(text, "", f"tab-{number}.{name[0]}.{d}" if text else ""))
    return tuple(entries)


__all__ = ["DIMENSIONS", "MEASURES", "Entry", "Sheet", "family_tex", "sheets"]
