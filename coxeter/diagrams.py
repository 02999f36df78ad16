"""Graphs, their forms and their definiteness; Coxeter diagrams and their classification.

Paper, Sections 2.1, 2.2 and 2.4. Diagrams are `networkx` graphs whose edges carry the label ``m``
of Definition 8 (3 where none is written). NetworkX and SymPy are loaded when they are needed.

Reference: Humphreys, Sections 2.1 to 2.7.
"""

from __future__ import annotations

from enum import Enum
from functools import lru_cache
from itertools import pairwise
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import InvalidInput
from .names import EXCEPTIONAL, MINIMAL_DIMENSION, MINIMAL_RANK, Type
from .roots import RootSystem

if TYPE_CHECKING:
    import networkx as nx
    from sympy.polys.matrices import DomainMatrix

INFINITE = 0
"""The label of an edge between parallel walls, m = infinity, written 0."""

_LABELS = {3: 1, 4: 2, 6: 3, INFINITE: 4}
"""4·cos²(pi/m) for the labels of crystallographic diagrams."""


class Definiteness(Enum):
    """What a symmetric bilinear form is."""

    POSITIVE_DEFINITE = "positive definite"
    POSITIVE_SEMIDEFINITE = "positive semidefinite"
    INDEFINITE = "indefinite"


def cartan_matrix(graph: nx.Graph) -> np.ndarray:
    """The Cartan matrix 2I - A of a graph without loops, in the order of its nodes (Definition 2).

    >>> import networkx as nx
    >>> cartan_matrix(nx.path_graph(3)).tolist()
    [[2, -1, 0], [-1, 2, -1], [0, -1, 2]]
    """
    import networkx as nx

    _without_loops(graph)
    adjacency = np.asarray(nx.to_numpy_array(graph, weight=None, dtype=np.int64))
    return np.asarray(2 * np.eye(len(graph), dtype=np.int64) - adjacency)


def _without_loops(graph: nx.Graph) -> None:
    if graph.is_directed() or graph.is_multigraph():
        raise InvalidInput("the graph is directed or has multiple edges: give a networkx.Graph")
    if any(graph.has_edge(v, v) for v in graph):
        raise InvalidInput("the graph has a loop: its form is defined for graphs without loops")


def bilinear_form(graph: nx.Graph) -> DomainMatrix:
    """The symmetric form of a Coxeter diagram, 2 on the diagonal and -2·cos(pi/m) on its edges.

    For a diagram without labels it is the Cartan matrix of Definition 2. It is a SymPy
    `DomainMatrix` over the integers, or over Q(√2, √3) where a label asks for it.

    Raises
    ------
    InvalidInput
        If a label is none of 3, 4, 6 or infinity (`INFINITE`).
    """
    import sympy
    from sympy.polys.matrices import DomainMatrix

    _without_loops(graph)
    index = {node: i for i, node in enumerate(graph)}
    rows = (2 * sympy.eye(len(graph))).tolist()
    for u, v, m in graph.edges(data="m", default=3):
        if m not in _LABELS:
            raise InvalidInput(
                f"the edge {u}-{v} has label {m}; crystallographic labels are 3, 4, 6, infinity"
            )
        rows[index[u]][index[v]] = rows[index[v]][index[u]] = -sympy.sqrt(_LABELS[m])
    plain = all(m in (3, INFINITE) for _, _, m in graph.edges(data="m", default=3))
    domain = sympy.ZZ if plain else sympy.QQ.algebraic_field(sympy.sqrt(2), sympy.sqrt(3))
    return DomainMatrix.from_list_sympy(len(graph), len(graph), rows).convert_to(domain)


def inertia(graph: nx.Graph) -> tuple[int, int, int]:
    """The numbers of positive, zero and negative eigenvalues of the form of a diagram, exactly.

    The characteristic polynomial of a symmetric matrix has real roots only, so Descartes' rule of
    signs counts the positive ones exactly.

    >>> import networkx as nx
    >>> inertia(nx.path_graph(4)), inertia(nx.cycle_graph(4)), inertia(nx.complete_graph(4))
    ((4, 0, 0), (3, 1, 0), (3, 0, 1))
    """
    if not len(graph):
        return 0, 0, 0
    form = bilinear_form(graph)
    signs = [_sign(form.domain, c) for c in form.charpoly()]
    zero = len(signs) - 1 - max(i for i, s in enumerate(signs) if s)
    nonzero = [s for s in signs if s]
    positive = sum(a != b for a, b in pairwise(nonzero))
    return positive, zero, len(graph) - positive - zero


def _sign(domain: Any, value: Any) -> int:
    from .exact import surd

    return surd(domain.to_sympy(value)).sign()


def definiteness(graph: nx.Graph) -> Definiteness:
    """Whether the form of a diagram is positive definite, semidefinite or indefinite, exactly.

    >>> import networkx as nx
    >>> definiteness(nx.star_graph(4))
    <Definiteness.POSITIVE_SEMIDEFINITE: 'positive semidefinite'>
    """
    _, zero, negative = inertia(graph)
    if negative:
        return Definiteness.INDEFINITE
    return Definiteness.POSITIVE_SEMIDEFINITE if zero else Definiteness.POSITIVE_DEFINITE


# -- the diagrams of root systems -------------------------------------------------------------------

_LABEL_OF = {value: label for label, value in _LABELS.items()}


def coxeter_diagram(system: RootSystem) -> nx.Graph:
    """The Coxeter diagram of a root system (Definition 8).

    Nodes are 1 … d, one for each simple root, with its mark as ``mark`` and its squared length as
    ``squared_length``; an edge carries ``m``, where pi/m is the angle between the two walls.

    >>> from coxeter.roots import root_system
    >>> sorted(coxeter_diagram(root_system("B3")).edges(data="m"))
    [(1, 2, 3), (2, 3, 4)]
    """
    graph = affine_diagram(system)
    graph.remove_node(0)
    graph.graph["name"] = system.name
    return graph


def affine_diagram(system: RootSystem) -> nx.Graph:
    """The Coxeter diagram of the affine Weyl group (Definition 17): node 0 is minus the highest root.

    >>> from coxeter.roots import root_system
    >>> sorted(affine_diagram(root_system("C2")).edges(data="m"))
    [(0, 1, 4), (1, 2, 4)]
    """
    import networkx as nx

    graph: nx.Graph = nx.Graph(name=system.type.affine)
    products = system._affine_products
    for i, mark in enumerate((1, *system.marks)):
        graph.add_node(i, mark=mark, squared_length=products[i][i])
    for i, row in products.items():
        for j, x in row.items():
            if i < j:
                graph.add_edge(i, j, m=_LABEL_OF[int(4 * x * x / (products[i][i] * products[j][j]))])
    return graph


# -- classification -----------------------------------------------------------------------------------


@lru_cache(maxsize=256)
def _candidates(nodes: int, affine: bool) -> tuple[tuple[str, nx.Graph], ...]:
    """The connected finite, or affine, diagrams with a given number of nodes, with their names."""
    rank = nodes - 1 if affine else nodes
    low = MINIMAL_DIMENSION if affine else MINIMAL_RANK
    letters = [x for x in "ABCD" if rank >= low[x]] + [x for x, r in EXCEPTIONAL.items() if rank in r]
    if not affine and "C" in letters:
        letters.remove("C")  # B_d and C_d share their diagram
    draw = affine_diagram if affine else coxeter_diagram
    name = attrgetter("affine" if affine else "finite")
    kinds = [Type(x, rank) for x in letters]
    return tuple((name(kind), draw(RootSystem(kind))) for kind in kinds)


def classify(graph: nx.Graph) -> str | None:
    """The name of a connected Coxeter diagram, finite (``"B3"``) or affine (``"B~3"``), or None.

    None means that the form is indefinite: the group is neither a Weyl group nor an affine one.
    B_d and C_d have one diagram, reported as B_d. Sources: Theorems 2 and 4; Humphreys, 2.4 to 2.7.

    Raises
    ------
    InvalidInput
        If the graph is empty or not connected.

    Examples
    --------
    >>> import networkx as nx
    >>> classify(nx.path_graph(5)), classify(nx.cycle_graph(5)), classify(nx.complete_graph(5))
    ('A5', 'A~4', None)
    """
    import networkx as nx

    _without_loops(graph)
    if not len(graph) or not nx.is_connected(graph):
        raise InvalidInput("the graph is empty or not connected: classify its components one by one")
    kind = definiteness(graph)
    if kind is Definiteness.INDEFINITE:
        return None
    same_label = nx.algorithms.isomorphism.categorical_edge_match("m", 3)
    for name, candidate in _candidates(len(graph), kind is Definiteness.POSITIVE_SEMIDEFINITE):
        if nx.is_isomorphic(graph, candidate, edge_match=same_label):
            return name
    if len(graph) == 2:  # two parallel walls: the line, cut into segments
        return "A~1"
    raise AssertionError(f"the classification misses a diagram: {sorted(graph.edges(data='m'))}")


def main_line(graph: nx.Graph) -> list[int]:
    """The nodes of a longest path through a diagram that is a tree, or once round a cycle."""
    import networkx as nx

    if not nx.is_tree(graph):
        return [edge[0] for edge in nx.find_cycle(graph, source=min(graph))]
    far = max(nx.single_source_shortest_path_length(graph, min(graph)).items(), key=lambda x: x[1])[0]
    lengths = nx.single_source_shortest_path_length(graph, far)
    path: list[int] = nx.shortest_path(graph, far, max(lengths, key=lambda v: (lengths[v], v)))
    return path if path[0] <= path[-1] else path[::-1]


def as_text(graph: nx.Graph, attribute: str | None = None) -> str:
    """A diagram drawn with letters: the longest path on one line, its arms above and below.

    Nodes show their numbers, or the attribute asked for (``"mark"``).

    >>> from coxeter.roots import root_system
    >>> print(as_text(affine_diagram(root_system("B4"))))
        0
        |
    1---2---3-[4]-4
    """
    show = {v: str(graph.nodes[v][attribute] if attribute else v) for v in graph}
    line = main_line(graph)
    closed = len(line) > 2 and graph.has_edge(line[0], line[-1])
    bottom, column = "", {}
    for previous, v in zip([None, *line], line, strict=False):
        if previous is not None:
            m = graph.edges[previous, v].get("m", 3)
            bottom += {3: "---", INFINITE: "-[oo]-"}.get(m, f"-[{m}]-")
        column[v] = len(bottom)
        bottom += show[v]
    rows = [bottom]
    if closed:
        end = len(bottom) - 1
        rows = ["." + "-" * max(end - 1, 1) + ".", "|" + " " * max(end - 1, 1) + "|", bottom]
    seen = set(line)
    above: list[list[tuple[int, str]]] = []
    below: list[list[tuple[int, str]]] = []
    for v in line:
        arms = [w for w in graph[v] if w not in seen]
        for side, arm in zip((above, below), arms, strict=False):  # only D~4 has two arms at a node
            level = 0
            while arm is not None:
                side += [[] for _ in range(level + 2 - len(side))]
                side[level].append((column[v], "|"))
                side[level + 1].append((column[v], show[arm]))
                seen.add(arm)
                arm = next((w for w in graph[arm] if w not in seen), None)
                level += 2
    return "\n".join([*map(_place, reversed(above)), *rows, *map(_place, below)])


def _place(items: list[tuple[int, str]]) -> str:
    line = ""
    for column, text in sorted(items):
        line = line.ljust(column) + text
    return line
