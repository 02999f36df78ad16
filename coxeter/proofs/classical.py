"""The four infinite families with symbolic d: simple roots, marks, vertices, centres.

The simple roots are those of Theorem 3; all else is a claim about them that `coxeter.proofs` proves. The
nodes 0 … d of a diagram fall into classes in which one formula does for all; only one class of a family has
more than one node, and its vectors have the index k.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from ..symbolic.cases import Case, case
from ..symbolic.runs import RunVector, runs

Pairs = tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Nodes:
    """The nodes from `low` to `high`, formulas in d.

    Attributes
    ----------
    root, vertex
        The simple root (for node 0 the highest root) and the vertex u_k, as runs.
    mark, square
        The mark of the node, and the squared length of its root.
    """

    low: str
    high: str
    root: Pairs
    vertex: Pairs
    mark: int
    square: int

    @property
    def index(self) -> str:
        """How the node is called: k, or its own name if there is but one."""
        return self.low if self.low == self.high else "k"


@dataclass(frozen=True)
class Pair:
    """Node j beside node k, in a range that tells their order."""

    j: str
    k: str
    first: Nodes
    second: Nodes
    range: Case

    @property
    def same(self) -> bool:
        """Whether they are one node."""
        return self.j == self.k

    def root(self) -> RunVector:
        """The root of node j."""
        return vector(self.first.root, self.j)

    def vertices(self) -> tuple[RunVector, RunVector]:
        """The vertices u_j and u_k."""
        return vector(self.first.vertex, self.j), vector(self.second.vertex, self.k)


@dataclass(frozen=True)
class Classical:
    """A family: its first d, its nodes by class, and the centres of its fundamental simplex."""

    letter: str
    first: int
    nodes: tuple[Nodes, ...]
    circumcentre: RunVector
    incentre: RunVector

    def range(self, nodes: Nodes) -> Case:
        """The range of d and of the index k."""
        chain = f"{nodes.low} <= k <= {nodes.high}" if nodes.index == "k" else f"{self.first} <= d"
        return case(chain, self.first)

    def pairs(self) -> Iterator[Pair]:
        """All pairs of nodes, class by class; within a class j < k, j = k and j > k."""
        for first in self.nodes:
            for second in self.nodes:
                if first is not second:
                    yield self._pair(first, second)
                elif first.index != "k":
                    yield Pair(first.index, first.index, first, first, self.range(first))
                else:
                    yield from self._within(first)

    def _pair(self, first: Nodes, second: Nodes) -> Pair:
        if first.index == "k":
            chain = case(f"{first.low} <= j <= {first.high}", self.first)
            return Pair("j", second.index, first, second, chain)
        return Pair(first.index, second.index, first, second, self.range(second))

    def _within(self, nodes: Nodes) -> Iterator[Pair]:
        for chain in ("j < k", "k", "k < j"):
            j = "k" if chain == "k" else "j"
            yield Pair(j, "k", nodes, nodes, case(f"{nodes.low} <= {chain} <= {nodes.high}", self.first))


def vector(pairs: Pairs, index: str) -> RunVector:
    """Runs with a name for their index."""
    return runs(*((x.replace("k", index), n.replace("k", index)) for x, n in pairs))


def vertex(nodes: Nodes) -> RunVector:
    """The vertex u_k of a class of nodes."""
    return vector(nodes.vertex, "k")


def root(nodes: Nodes) -> RunVector:
    """The root s_k of a class of nodes."""
    return vector(nodes.root, "k")


_ZERO: Pairs = (("0", "d"),)
_FIRST: Pairs = (("1", "1"), ("0", "d - 1"))
_HALVES: Pairs = (("1/2", "k"), ("0", "d - k"))
_ALL_HALVES: Pairs = (("1/2", "d"),)
_TOP: Pairs = (("1", "2"), ("0", "d - 2"))
_STEP: Pairs = (("0", "k - 1"), ("1", "1"), ("-1", "1"), ("0", "d - k - 1"))
_FIRST_STEP: Pairs = (("1", "1"), ("-1", "1"), ("0", "d - 2"))
_LAST_STEP: Pairs = (("0", "d - 2"), ("1", "1"), ("-1", "1"))

_A_CENTRE = runs(("(d/2 + 1 - i)/(d + 1)", "d + 1"))

FAMILIES = {
    "A": Classical(
        "A",
        2,
        (
            Nodes("0", "0", (("1", "1"), ("0", "d - 1"), ("-1", "1")), (("0", "d + 1"),), 1, 2),
            Nodes(
                "1",
                "d",
                (("0", "k - 1"), ("1", "1"), ("-1", "1"), ("0", "d - k")),
                (("(d + 1 - k)/(d + 1)", "k"), ("-k/(d + 1)", "d + 1 - k")),
                1,
                2,
            ),
        ),
        _A_CENTRE,
        _A_CENTRE,
    ),
    "B": Classical(
        "B",
        3,
        (
            Nodes("0", "0", _TOP, _ZERO, 1, 2),
            Nodes("1", "1", _FIRST_STEP, _FIRST, 1, 2),
            Nodes("2", "d - 1", _STEP, _HALVES, 2, 2),
            Nodes("d", "d", (("0", "d - 1"), ("1", "1")), _ALL_HALVES, 2, 1),
        ),
        runs(("1/2", "1"), ("0", "1"), ("1/4", "d - 2")),
        runs(("(1 + (d - i)*sqrt(2))/(2*(1 + (d - 1)*sqrt(2)))", "d")),
    ),
    "C": Classical(
        "C",
        2,
        (
            Nodes("0", "0", (("2", "1"), ("0", "d - 1")), _ZERO, 1, 4),
            Nodes("1", "d - 1", _STEP, _HALVES, 2, 2),
            Nodes("d", "d", (("0", "d - 1"), ("2", "1")), _ALL_HALVES, 1, 4),
        ),
        runs(("1/4", "d")),
        runs(("(1 + (d - i)*sqrt(2))/(2*(2 + (d - 1)*sqrt(2)))", "d")),
    ),
    "D": Classical(
        "D",
        4,
        (
            Nodes("0", "0", _TOP, _ZERO, 1, 2),
            Nodes("1", "1", _FIRST_STEP, _FIRST, 1, 2),
            Nodes("2", "d - 2", _STEP, _HALVES, 2, 2),
            Nodes("d - 1", "d - 1", _LAST_STEP, (("1/2", "d - 1"), ("-1/2", "1")), 1, 2),
            Nodes("d", "d", (("0", "d - 2"), ("1", "2")), _ALL_HALVES, 1, 2),
        ),
        runs(("1/2", "1"), ("0", "1"), ("1/4", "d - 4"), ("1/2", "1"), ("0", "1")),
        runs(("(d - i)/(2*(d - 1))", "d")),
    ),
}
"""By letter."""
