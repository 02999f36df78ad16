"""Tables 1 to 6 of the paper, and that of the regular simplex, computed anew to any dimension.

A `Table` holds exact values; `Table.render` writes it as text, Markdown, LaTeX, CSV or JSON, its
decimals rounded once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from ..affine import CoxeterTriangulation
from ..delaunay import delaunay_verdict, protection
from ..errors import InvalidInput
from ..lattices import vertex_lattice
from ..names import Type, triangulations_up_to
from ..peers import Peer
from ..quality import Measure, Number, aspect_ratio, fatness, radius_ratio, thickness
from ..simplex import regular_simplex
from .table import FORMATS, Cell, Table

if TYPE_CHECKING:
    from ..claims import Comparison

__all__ = [
    "FORMATS",
    "TABLES",
    "Table",
    "measure_table",
    "runs",
    "section6_comparison",
    "table",
    "table_comparison",
]

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


def measure_table(
    measure: Measure[Any], max_dim: int, title: str = "", peers: Sequence[Peer] = (), best: bool = False
) -> Table:
    """A normalised measure of all triangulations: a row for each letter, a column for each dimension.

    Parameters
    ----------
    measure
        The measure.
    max_dim
        The largest dimension shown.
    title
        A title other than that of the measure.
    peers
        Other triangulations, a row each: the value of the worst of their simplices. A cell is empty where
        there is no such triangulation, and where the measure has no method for one of its simplices.
    best
        Whether the largest value of each dimension is marked, decided exactly; several if they are equal.

    Examples
    --------
    >>> from coxeter.peers import find_peer
    >>> print(measure_table(thickness, 4, peers=[find_peer("D1")], best=True).render("csv"))
    family,2,3,4
    A~,1.000,0.866,0.816
    B~,,0.433,0.447
    C~,0.577,0.500,0.447
    D~,,,0.447
    F~,,,0.298
    G~,0.500,,
    D1,0.577,0.500,0.422
    best,A~,A~,A~
    """
    values: dict[str, dict[int, Number]] = {}
    for kind in triangulations_up_to(max_dim):
        row = values.setdefault(f"{kind.letter}~", {})
        row[kind.rank] = measure.normalized(CoxeterTriangulation(kind).simplex)
    columns = range(2, max_dim + 1)
    names = sorted(values)
    for peer in peers:
        found = {d: peer.worst_if_known(measure, d) for d in columns}
        values[peer.name] = {d: value for d, value in found.items() if value is not None}
        names.append(peer.name)
    marked = ((i, d - 1) for d in columns for i in _largest([values[name].get(d) for name in names]))
    return Table(
        title or f"Normalised {measure.name.replace('_', ' ')}",
        ("family", *map(str, columns)),
        tuple((name, *(values[name].get(d) for d in columns)) for name in names),
        frozenset(marked if best else ()),
    )


def _largest(values: Sequence[Any]) -> list[int]:
    """The places of the largest value; None stands for no value."""
    largest = max(x for x in values if x is not None)
    return [i for i, x in enumerate(values) if x is not None and x == largest]


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
    from ..claims import compare_section6  # it needs SymPy, which takes longer to load than all else here

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
    from ..claims import Outcome, compare_table

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
