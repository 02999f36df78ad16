"""Labelled graphs whose form is positive definite or semidefinite, and their names."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from .. import diagrams
from ..errors import CoxeterError
from ..exact import RationalMatrix
from ..names import triangulations_up_to
from .instances import systems

if TYPE_CHECKING:
    import networkx as nx


@lru_cache(maxsize=1)
def small_graphs() -> tuple[nx.Graph, ...]:
    """All connected graphs with up to five nodes."""
    import networkx as nx

    return tuple(g for g in nx.graph_atlas_g() if 0 < len(g) <= 5 and nx.is_connected(g))


def is_definite(cartan: np.ndarray) -> bool:
    """Whether a symmetric integer matrix is positive definite: its leading minors are positive."""
    return all(RationalMatrix(cartan[:k, :k]).det() > 0 for k in range(1, len(cartan) + 1))


def sign_of_form(tree: nx.Graph) -> int:
    """1 if the form of a labelled tree is positive definite, 0 if only semidefinite, -1 if it is indefinite.

    Elimination from the leaves inwards needs only 4·cos²(pi/m) for the labels m. If a pivot within the tree
    is not positive, then the form has a negative direction, as the tree is connected.
    """
    import networkx as nx

    pivot = dict.fromkeys(tree, Fraction(2))
    for parent, child in reversed(list(nx.dfs_edges(tree, 0))):
        if pivot[child] <= 0:
            return -1
        pivot[parent] -= {3: 1, 4: 2, 6: 3}[tree.edges[parent, child].get("m", 3)] / pivot[child]
    return (pivot[0] > 0) - (pivot[0] < 0)


def family_of(name: str) -> str:
    """The family of a type: ``B~5`` and ``B5`` are in B."""
    plain = name.replace("~", "")
    return plain[0] if plain[0] in "ABCD" else plain


@lru_cache(maxsize=32)
def _known(nodes: int, affine: bool) -> tuple[tuple[str, nx.Graph], ...]:
    """The diagrams of Theorem 2, or 4, with a number of nodes; $B_d$ stands for $C_d$ too."""
    rank = nodes - affine
    names = [s for s in systems(rank) if s.rank == rank and (affine or s.type.letter != "C")]
    if affine:
        kinds = triangulations_up_to(rank)
        return tuple((s.type.affine, diagrams.affine_diagram(s)) for s in names if s.type in kinds)
    return tuple((s.name, diagrams.coxeter_diagram(s)) for s in names)


def name_of(graph: nx.Graph, affine: bool) -> str:
    """The name of a diagram on the list of Theorem 2, or 4; an error if it is not there."""
    import networkx as nx

    match = nx.algorithms.isomorphism.categorical_edge_match("m", 3)
    for name, known in _known(len(graph), affine):
        if nx.is_isomorphic(graph, known, edge_match=match):
            return name
    raise CoxeterError(f"the lists miss a diagram: {sorted(graph.edges(data='m'))}")


@lru_cache(maxsize=2)
def names_of_trees(nodes: int, labels: tuple[int, ...]) -> dict[int, tuple[str, ...]]:
    """The names of all trees up to a number of nodes, with labels, by the sign of the form, if it is not
    -1."""
    import networkx as nx

    found: dict[int, set[str]] = {1: {"A1"}, 0: set()}
    for tree in (t for n in range(2, nodes + 1) for t in nx.nonisomorphic_trees(n)):
        for chosen in product(labels, repeat=len(tree) - 1):
            nx.set_edge_attributes(tree, dict(zip(tree.edges, chosen, strict=True)), "m")
            if (sign := sign_of_form(tree)) >= 0:
                found[sign].add(name_of(tree, affine=not sign))
    return {sign: tuple(sorted(names)) for sign, names in found.items()}
