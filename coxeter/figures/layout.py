"""Where the nodes of a Coxeter diagram stand, found from the graph alone.

Nodes of a chain stand on one line. The two leaves of a fork stand above and below it, other arms
point up, and the cycle of A~ is closed by node 0 above the middle.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Literal, NamedTuple

from ..diagrams import main_line
from ..exact import Surd, sqrt
from ..names import Type

if TYPE_CHECKING:
    import networkx as nx

Show = Literal["names", "marks", "heights"]
Index = int | str
Place = tuple[tuple[Fraction, Fraction], str]

LONGEST = 12
"""The largest rank that is drawn with all its nodes."""


class Node(NamedTuple):
    """A node: its number (``"d-1"`` in a family), its mark, its place, and where its label stands.

    ``ratio`` is the height on the facet of node 0 over that on its own: mark times length of the root,
    for which the root of node 0 is the unit.
    """

    number: Index
    mark: int
    place: tuple[Fraction, Fraction]
    side: str
    ratio: Surd | None = None


class Edge(NamedTuple):
    """An edge with its label m. With ``dots`` it stands for a chain of nodes that are not drawn."""

    first: Index
    second: Index
    m: int
    dots: bool


class Diagram(NamedTuple):
    """What a diagram shows. ``line`` is the chain that is drawn as a straight line, from the left."""

    name: str
    affine: bool
    nodes: tuple[Node, ...]
    edges: tuple[Edge, ...]
    line: tuple[Index, ...]
    show: Show


def lay_out(kind: Type, affine: bool, graph: nx.Graph, show: Show) -> Diagram:
    """A diagram with places for its nodes; the middle of a long chain is left out."""
    graph = _shorten(graph, kind.rank)
    line, where = _layout(graph)
    nodes = tuple(Node(k, graph.nodes[k]["mark"], *where[k], _ratio(graph, k)) for k in sorted(graph))
    edges = tuple(Edge(i, j, m, (i, j) in _dots(graph)) for i, j, m in sorted(graph.edges(data="m")))
    return Diagram(kind.affine if affine else kind.finite, affine, nodes, edges, tuple(line), show)


def _ratio(graph: nx.Graph, k: int) -> Surd | None:
    if 0 not in graph:
        return None
    squares = [Fraction(graph.nodes[i]["squared_length"]) for i in (k, 0)]
    return int(graph.nodes[k]["mark"]) * sqrt(squares[0] / squares[1])


def _shorten(graph: nx.Graph, d: int) -> nx.Graph:
    """Leave out the middle of the chain of a long diagram, so that three nodes stay at each free end."""
    if d <= LONGEST:
        return graph
    first = 2 if graph.has_edge(0, 1) and graph.edges[0, 1]["m"] == 4 else 3
    last = d - 3 if graph.has_edge(d - 2, d) else d - 2
    short: nx.Graph = graph.subgraph([k for k in graph if not first < k < last]).copy()
    short.add_edge(first, last, m=3, dots=True)
    return short


def _dots(graph: nx.Graph) -> set[tuple[int, int]]:
    return {(min(i, j), max(i, j)) for i, j, dots in graph.edges(data="dots") if dots}


def _layout(graph: nx.Graph) -> tuple[list[int], dict[int, Place]]:
    """The chain on the line, and for each node its place and the side on which its label stands."""
    forks = _forks(graph)
    rest: nx.Graph = graph.subgraph(set(graph) - {w for leaves in forks for w in leaves})
    line = main_line(rest)
    if rest.number_of_edges() == len(rest) > 2:  # the cycle of A~
        line = [v for v in line if v]
    finite = [v for v in line if v]
    if finite[0] > finite[-1]:
        line.reverse()
    where: dict[int, Place] = {}
    x = Fraction(0)
    where[line[0]] = (x, x), "below"
    for previous, v in pairwise(line):
        x += 2 if graph.edges[previous, v].get("dots") else 1
        where[v] = (x, Fraction(0)), "below"
    for (upper, lower), inner in forks.items():
        left = upper < inner
        x = where[inner][0][0] + Fraction(4, 5) * (-1 if left else 1)
        for leaf, y in ((upper, Fraction(3, 5)), (lower, Fraction(-3, 5))):
            where[leaf] = (x, y), "left" if left else "right"
    for v in line:
        _place_arm(rest, v, where)
    return line, where


def _forks(graph: nx.Graph) -> dict[tuple[int, int], int]:
    """The pairs of leaves k, k + 1 that hang on one node by edges without label, with that node."""
    found = {}
    for k in graph:
        if k + 1 in graph and graph.degree[k] == graph.degree[k + 1] == 1:
            (inner,), (other,) = graph[k], graph[k + 1]
            if inner == other and graph.edges[k, inner]["m"] == graph.edges[k + 1, inner]["m"] == 3:
                found[k, k + 1] = inner
    return found


def _place_arm(graph: nx.Graph, v: int, where: dict[int, Place]) -> None:
    """Place what hangs above a node of the line: an arm, or the node that closes a cycle."""
    x, y = where[v][0]
    for w in graph[v]:
        if w in where:
            continue
        on_line = [where[u][0][0] for u in graph[w] if u in where]
        if len(on_line) == 2:
            span = max(on_line) - min(on_line)
            where[w] = (sum(on_line, Fraction(0)) / 2, max(Fraction(1), span / 6)), "above"
        else:
            where[w] = (x, y + 1), "right"
            _place_arm(graph, w, where)
