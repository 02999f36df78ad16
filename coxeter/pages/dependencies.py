"""What rests on what among the numbered items: statements without a number are passed through."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

import networkx as nx

from ..ledger.inventory import PROPOSITIONS, items
from ..ledger.selecting import section_of
from .judged import Judged, Ledger
from .naming import item_of, name_of_item

PROVE, STATE = "to_prove", "to_state"


@dataclass(frozen=True)
class Dependencies:
    """The numbered items as a graph, with an arrow from what is needed to what needs it."""

    ledger: Ledger

    @cached_property
    def members(self) -> dict[str, tuple[Judged, ...]]:
        """The claims of each item; a proposition that is an item of Section 6 is that item."""
        found: dict[str, list[Judged]] = {node_of(item): [] for item in items()}
        for x in self.ledger:
            if (node := node_of(item_of(x.id))) in found:
                found[node].append(x)
        return {node: tuple(claims) for node, claims in found.items() if claims}

    def section(self, node: str) -> str:
        """The section in which an item stands first."""
        return "6" if node.startswith("sec6") else section_of(self.members[node][0].claim)

    @cached_property
    def arrows(self) -> dict[tuple[str, str], str]:
        """Each pair of items of which the second needs the first, and for what; proving outweighs stating."""
        found: dict[tuple[str, str], str] = {}
        for node, claims in self.members.items():
            for kind in (STATE, PROVE):
                for x in claims:
                    for needed in self._nodes(self.ledger.needs(x, (kind,)), set()):
                        if needed != node:
                            found[needed, node] = kind
        return found

    def _nodes(self, ids: Iterable[str], seen: set[str]) -> Iterator[str]:
        """The items of some claims; for claims without a number, the items that these need."""
        for id in ids:
            if id in seen:
                continue
            seen.add(id)
            if (node := node_of(item_of(id))) in self.members:
                yield node
            else:
                yield from self._nodes(self.ledger.needs(self.ledger[id]), seen)

    @cached_property
    def shown(self) -> dict[tuple[str, str], str]:
        """The arrows without those that follow from others."""
        forward = nx.DiGraph(list(self.arrows))
        backward = []
        while not nx.is_directed_acyclic_graph(forward):
            a, b = max(nx.find_cycle(forward), key=lambda edge: self._order[edge[0]] - self._order[edge[1]])
            forward.remove_edge(a, b)
            backward.append((a, b))
        kept = {*nx.transitive_reduction(forward).edges, *backward}
        return {arrow: kind for arrow, kind in self.arrows.items() if arrow in kept}

    @cached_property
    def _order(self) -> dict[str, int]:
        return {node: n for n, node in enumerate(self.members)}

    def depths(self, nodes: Iterable[str]) -> dict[str, int]:
        """How long the longest chain of arrows within some items is that ends in each of them."""
        graph = nx.DiGraph()
        graph.add_nodes_from(nodes)
        graph.add_edges_from(arrow for arrow in self.shown if set(arrow) <= set(graph))
        while not nx.is_directed_acyclic_graph(graph):
            graph.remove_edge(*nx.find_cycle(graph)[-1][:2])
        return {
            node: depth for depth, layer in enumerate(nx.topological_generations(graph)) for node in layer
        }


def node_of(item: str) -> str:
    """The item that stands for an item: some propositions are items of Section 6."""
    return PROPOSITIONS.get(item, item)


def name_of_node(node: str) -> str:
    """An item with the number that it may have beside.

    >>> name_of_node("lem-8"), name_of_node("sec6.A.item-7")
    ('Lemma 8', 'A~, item 7 (Lemma 7)')
    """
    other = next((name for name, item in PROPOSITIONS.items() if item == node), "")
    return name_of_item(node) + (f" ({name_of_item(other)})" if other else "")
