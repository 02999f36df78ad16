"""The kinds of records: rows of decimals, formulas, points, statements."""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import CoxeterError

Runs = tuple[tuple[str, str], ...]
"""Coordinates as pairs (value, how many times), both as formulas."""


class DamagedData(CoxeterError):
    """A data file of the paper cannot be read; the message names the file and the line."""


@dataclass(frozen=True)
class PrintedRow:
    """A row of one of Tables 3 to 6.

    Attributes
    ----------
    table, quantity
        The table's number and what it lists.
    letter
        The family's letter, from the row's place in the table; empty for the head of the table.
    label
        The row's label as printed, in LaTeX.
    cells
        The text of each cell; ``"-"`` and empty cells included.
    """

    table: int
    quantity: str
    letter: str
    label: str
    cells: tuple[str, ...]
    line: int = 0


@dataclass(frozen=True)
class PrintedFormula:
    """A printed formula or number for a quantity of a family.

    Attributes
    ----------
    text
        The formula; empty where our copy has an empty cell.
    parity
        ``"odd"`` or ``"even"`` if it is printed for such d only.
    decimal
        Whether the text is a decimal number, so rounded, such as ``"9.900e-6"``.
    """

    place: str
    family: str
    quantity: str
    text: str
    parity: str = ""
    decimal: bool = False
    line: int = 0


@dataclass(frozen=True)
class PrintedPoint:
    """A printed vertex or centre.

    Attributes
    ----------
    name
        ``vertex``, ``circumcentre``, ``incentre``, ``mirror_vertex`` or ``mirror_shift``.
    index
        The number of the vertex, a formula in d, or ``"k"``, which then runs from `first` to `last`.
    runs
        The coordinates, read to the letter.
    label
        The label in front of it, if our copy does not show the one expected.
    raw
        The LaTeX of our copy, where it is too damaged for the runs to show it.
    """

    place: str
    family: str
    name: str
    runs: Runs
    index: str = ""
    first: str = ""
    last: str = ""
    label: str | None = None
    raw: str = ""
    line: int = 0


@dataclass(frozen=True)
class PrintedStatement:
    """A printed statement with numbers that is neither a formula nor a point.

    Attributes
    ----------
    kind
        ``facet``: the hyperplane with that normal and the value `text` contains facet `facet`;
        ``distance``: from vertex `vertex` to facet `facet` it is `text`;
        ``minimal``: the least heights are those from the vertices `first` to `last`;
        ``longest``: the edge from vertex `first` to vertex `last` is a longest one;
        ``level``: the inner product of facet `facet`'s inward normal and a vertex, or c, is `text`;
        ``product``: the same for a given normal;
        ``space``: the vertices are given in the space of dimension `text`;
        ``combination``: the vector `normal` is the sum of the vertices, with the coefficients, in `terms`;
        ``no vertex``: the point `normal` is not a vertex of the triangulation.
    low
        The first d for which it is stated, if that is not the family's first.
    """

    place: str
    family: str
    kind: str
    text: str = ""
    facet: str = ""
    vertex: str = ""
    first: str = ""
    last: str = ""
    normal: Runs = ()
    terms: Runs = ()
    low: int = 0
    line: int = 0


@dataclass(frozen=True)
class Paper:
    """All that is recorded of the paper."""

    rows: tuple[PrintedRow, ...]
    formulas: tuple[PrintedFormula, ...]
    points: tuple[PrintedPoint, ...]
    statements: tuple[PrintedStatement, ...]
