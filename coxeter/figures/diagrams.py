"""Coxeter diagrams, finite and affine, of one type or of a whole family (paper, Theorems 2 and 4, Section 6).

Node 0, which stands for minus the highest root, is filled.
"""

from __future__ import annotations

import unicodedata
from itertools import pairwise
from typing import TYPE_CHECKING

from ..diagrams import affine_diagram
from ..diagrams import coxeter_diagram as finite_diagram
from ..errors import InvalidInput, InvalidType
from ..exact import Surd
from ..names import EXCEPTIONAL, MINIMAL_RANK, Type, parse_root_system, parse_triangulation
from ..roots import RootSystem
from .canvas import BOLD, INK, LABEL, SMALL, Canvas, Pen, Point
from .figure import Figure, beside
from .layout import LONGEST, Diagram, Edge, Index, Node, Show, lay_out
from .written import formula, words

if TYPE_CHECKING:
    import networkx as nx

_UNIT, _RADIUS = 46.0, 6.0


def coxeter_diagram(name: object, show: Show = "names") -> Figure[Diagram]:
    """The Coxeter diagram of a root system or of an affine Weyl group.

    Parameters
    ----------
    name
        A root system, as ``"B3"``, or a triangulation, as ``"B~3"``.
    show
        What stands at the nodes: ``"names"``, s_k for the simple roots and, in an affine diagram,
        tau_k for the facets of the fundamental simplex; ``"marks"``, the coefficients of the
        highest root, with 1 for node 0; or, in an affine diagram, ``"heights"``, the ratios of the
        inverse heights of the fundamental simplex, which are marks times lengths of roots.

    Raises
    ------
    InvalidType
        If there is no such root system or triangulation.
    InvalidInput
        If something else is to be shown, or the heights in the diagram of a root system.

    Examples
    --------
    >>> coxeter_diagram("B~4", show="marks")
    Coxeter diagram of B~4: line 2–3–4, and 0–2, 1–2; label 4 on 3–4. Marks: 1 at 0, 1; 2 at 2, 3, 4.
    """
    return _figure(_laid_out(name, show))


def family_diagram(family: str, show: Show = "names", affine: bool = True) -> Figure[Diagram]:
    """The diagram of a family for any dimension d, with dots in the middle of its chain.

    Parameters
    ----------
    family
        One of `coxeter.FAMILIES`; the five single triangulations have no dots.
    show
        As for `coxeter_diagram`.
    affine
        Whether to draw the affine diagram.

    Examples
    --------
    >>> family_diagram("C", show="marks")
    Coxeter diagram of C~d: line 0–1–2–…–(d-2)–(d-1)–d; labels 4 on 0–1, 4 on (d-1)–d. \
Marks: 1 at 0, d; 2 at 1, 2, …, d-2, d-1.
    """
    if family in [f"{letter}{rank}" for letter, ranks in EXCEPTIONAL.items() for rank in ranks]:
        return coxeter_diagram(f"{family[0]}~{family[1]}" if affine else family, show)
    if family not in MINIMAL_RANK:
        raise InvalidType(f"{family!r} is no family; there are A, B, C, D, E6, E7, E8, F4, G2")
    d = LONGEST + 1  # any d from here on gives the same drawing
    sample = _laid_out(f"{family}~{d}" if affine else f"{family}{d}", show)

    def number(k: Index) -> Index:
        if isinstance(k, str) or k < d / 2:
            return k
        return f"d-{d - k}" if k < d else "d"

    nodes = tuple(node._replace(number=number(node.number)) for node in sample.nodes)
    edges = tuple(e._replace(first=number(e.first), second=number(e.second)) for e in sample.edges)
    name = f"{family}~d" if affine else f"{family}d"
    return _figure(Diagram(name, affine, nodes, edges, tuple(map(number, sample.line)), show))


def diagram_pair(name: object, left: Show = "marks") -> Figure[tuple[Diagram, ...]]:
    """A diagram twice, as in Figures 4 to 11: with numbers at the left, with facet names at the right.

    Parameters
    ----------
    name
        As for `coxeter_diagram`, or a family, as ``"B~d"``.
    left
        ``"marks"``, or ``"heights"`` for the ratios of the inverse heights, which the captions of the
        paper announce. Where all roots have one length the two are the same.

    Examples
    --------
    >>> diagram_pair("G~2")
    Coxeter diagram of G~2, twice: line 1–2–0; label 6 on 1–2. Left, marks: 1 at 0; 2 at 2; 3 at 1. \
Right, facets: τ_0 to τ_2.
    """
    text, shown = str(getattr(name, "name", name)), (left, _NAMES)
    if text.endswith("d"):
        figures = [family_diagram(text[0], show, affine="~" in text) for show in shown]
    else:
        figures = [coxeter_diagram(name, show) for show in shown]
    data = figures[0].data
    parts = [_figure(figure.data, caption=True) for figure in figures]
    title = f"Coxeter diagram of {data.name}, twice"
    alt = [f"{title}: {_structure(data)}."]
    alt += [f"{side}, {_at_nodes(part.data)}." for side, part in zip(("Left", "Right"), parts, strict=True)]
    return beside(*parts, title=title, alt=" ".join(alt))


_NAMES: Show = "names"
_SHOWN: tuple[Show, ...] = ("names", "marks", "heights")


def _laid_out(name: object, show: Show) -> Diagram:
    if show not in _SHOWN:
        raise InvalidInput(f"show={show!r}: a diagram shows 'names' or 'marks', an affine one also 'heights'")
    kind, affine, graph = _graph(name)
    if show == "heights" and not affine:
        raise InvalidInput(f"{kind.finite} has no simplex, hence no heights: give a triangulation, as 'B~3'")
    return lay_out(kind, affine, graph, show)


def _graph(name: object) -> tuple[Type, bool, nx.Graph]:
    """Read a name; a tilde in it asks for the affine diagram."""
    name = getattr(name, "name", name)
    if isinstance(name, str) and set("~\N{COMBINING TILDE}") & set(unicodedata.normalize("NFD", name)):
        kind = parse_triangulation(name)
        return kind, True, affine_diagram(RootSystem(kind))
    kind = parse_root_system(name)
    return kind, False, finite_diagram(RootSystem(kind))


# -- from places to a drawing, and to words -----------------------------------------------------------


def _figure(data: Diagram, caption: bool = False) -> Figure[Diagram]:
    title = f"Coxeter diagram of {data.name}"
    alt = f"{title}: {_structure(data)}. {_at_nodes(data).capitalize()}."
    if caption:
        title += f", {_shown(data)}"
    return Figure(title, alt, data, lambda: _draw(data, caption))


def _shown(data: Diagram) -> str:
    numbers = {"marks": "marks", "heights": "inverse heights"}
    return numbers.get(data.show, "facets" if data.affine else "simple roots")


def _number(node: Node, data: Diagram) -> int | Surd:
    return node.mark if data.show == "marks" or node.ratio is None else node.ratio


def _word(number: Index) -> str:
    return f"({number})" if "-" in str(number) else str(number)


def _structure(data: Diagram) -> str:
    dots = {frozenset(e[:2]) for e in data.edges if e.dots}
    line = _word(data.line[0]) + "".join(
        ("–…–" if {i, j} in dots else "–") + _word(j) for i, j in pairwise(data.line)
    )
    on_line = [{i, j} for i, j in pairwise(data.line)]
    others = [f"{_word(i)}–{_word(j)}" for i, j, _, _ in data.edges if {i, j} not in on_line]
    labels = [f"{m} on {_word(i)}–{_word(j)}" for i, j, m, _ in data.edges if m != 3]
    parts = [f"line {line}" if len(data.line) > 1 else "", ", ".join(others)]
    text = ", and ".join(filter(None, parts)) if others or len(data.line) > 1 else f"node {line}"
    return text + (f"; label{'s' if len(labels) > 1 else ''} {', '.join(labels)}" if labels else "")


def _at_nodes(data: Diagram) -> str:
    if data.show == "names":
        sign = "τ" if data.affine else "s"
        first, last = (f"{sign}_{data.nodes[i].number}" for i in (0, -1))
        return f"{_shown(data)}: {first} to {last}" if first != last else f"{_shown(data)}: {first}"
    end = next((e.second for e in data.edges if e.dots), None)
    by_value: dict[int | Surd, list[str]] = {}
    for node in data.nodes:
        numbers = by_value.setdefault(_number(node, data), [])
        numbers += ["…"] if node.number == end else []
        numbers.append(str(node.number))
    return f"{_shown(data)}: " + "; ".join(
        f"{words(value)} at {', '.join(by_value[value])}" for value in sorted(by_value)
    )


def _draw(data: Diagram, caption: bool) -> Canvas:
    canvas = Canvas()
    unit = _UNIT if len(data.line) <= 8 else 0.83 * _UNIT
    at = {n.number: (float(n.place[0]) * unit, -float(n.place[1]) * unit) for n in data.nodes}
    for edge in data.edges:
        _draw_edge(canvas, at[edge.first], at[edge.second], edge)
    for node in data.nodes:
        canvas.disc(at[node.number], _RADIUS, INK if node.number == 0 else None, Pen(width=1.8))
        sign = "\\tau" if data.affine else "s"
        text = f"${sign}_{{{node.number}}}$" if data.show == "names" else f"${formula(_number(node, data))}$"
        (x, y), (dx, dy, anchor) = at[node.number], _SIDES[node.side]
        canvas.label((x + dx, y + dy), text, LABEL, anchor)
    left, _, right, bottom = canvas.box
    letter, rank = data.name[0], data.name.lstrip("ABCDEFG~")
    symbol = f"$\\tilde{{{letter}}}_{{{rank}}}$" if data.affine else f"${letter}_{{{rank}}}$"
    if caption:
        canvas.label(((left + right) / 2, bottom + 18), f"{symbol}, {_shown(data)}", SMALL + 2)
    else:
        canvas.label((left - 24, 0), symbol, LABEL + 2, "end")
    return canvas.fit(margin=6)


_SIDES = {
    "below": (0.0, 20.0, "middle"),
    "above": (0.0, -19.0, "middle"),
    "left": (-12.0, 0.0, "end"),
    "right": (12.0, 0.0, "start"),
}


def _draw_edge(canvas: Canvas, start: Point, end: Point, edge: Edge) -> None:
    """An edge from rim to rim, with its label above; an ellipsis leaves out its middle."""
    (x0, y0), (x1, y1) = start, end
    length = ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5

    def along(distance: float) -> Point:
        return x0 + (x1 - x0) * distance / length, y0 + (y1 - y0) * distance / length

    pieces = [(along(_RADIUS), along(length - _RADIUS))]
    if edge.dots:
        pieces = [(along(_RADIUS), along(0.3 * length)), (along(0.7 * length), along(length - _RADIUS))]
        for part in (0.42, 0.5, 0.58):
            canvas.disc(along(part * length), 1.7)
    canvas.lines(pieces, Pen(BOLD.colour, 1.8))
    if edge.m != 3:
        middle = along(length / 2)
        canvas.label((middle[0], middle[1] - 13), f"${edge.m}$", LABEL - 1)
