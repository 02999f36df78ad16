"""What the paper numbers, and whether the ledger has it all.

The list of numbered items is complete by construction; unnumbered statements were found by reading.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from graphlib import CycleError, TopologicalSorter

from ..names import FAMILIES
from ..paper import prose
from .claim import Claim

NUMBERED = {
    "def": 21,
    "thm": 9,
    "lem": 15,
    "prop": 14,
    "cor": 2,
    "rem": 5,
    "eq": 7,
    "tab": 6,
    "fig": 13,
}
"""How many there are of each kind: definitions, theorems and so on."""

UNNUMBERED = ("claim-c", "tab-angles", "tab-regular")
"""The Claim of Appendix C; the tables of possible angles and of the regular simplex."""

SECTION_6 = {family: tuple(range(1, 10)) for family in FAMILIES} | {"G2": (6, 7, 8, 9)}
"""The numbered items of each family's study. That of G~2 has no numbers; what it says are these items."""

PROPOSITIONS = {
    "lem-7": "sec6.A.item-7",
    "prop-7": "sec6.A.item-9",
    "prop-8": "sec6.B.item-9",
    "prop-9": "sec6.C.item-9",
    "prop-10": "sec6.D.item-9",
    "prop-11": "sec6.E6.item-9",
    "prop-12": "sec6.E7.item-9",
    "prop-13": "sec6.E8.item-9",
    "prop-14": "sec6.F4.item-9",
}
"""Statements with a number of their own that are, at the same time, an item of Section 6."""

FIGURES = {f"fig-{number}": family for number, family in enumerate(FAMILIES[:-1], 4)}
"""The figures that belong to one family's study."""

PLACES = {"tab-1": "2", "thm-8": "5"} | {f"tab-{number}": "5" for number in range(2, 7)}
"""Where items stand whose claims name no section as their place."""


def items() -> tuple[str, ...]:
    """The id of every numbered item.

    >>> len(items()), items()[0], items()[-1]
    (171, 'def-1', 'sec6.G2.item-9')
    """
    numbered = [f"{kind}-{n}" for kind, count in NUMBERED.items() for n in range(1, count + 1)]
    studies = [f"sec6.{family}.item-{n}" for family, numbers in SECTION_6.items() for n in numbers]
    return (*numbered, *UNNUMBERED, *studies)


def belongs(id: str, item: str) -> bool:
    """Whether a claim is, or is a part of, an item.

    >>> belongs("thm-8.delaunay", "thm-8"), belongs("thm-8", "thm-8"), belongs("def-12", "def-1")
    (True, True, False)
    """
    return id == item or id.startswith(f"{item}.")


def missing(claims: Collection[str]) -> tuple[str, ...]:
    """The numbered items without a claim; an item that is a proposition has that proposition's."""
    names: dict[str, list[str]] = {item: [item] for item in items()}
    for name, item in PROPOSITIONS.items():
        names[item].append(name)
    return tuple(
        item for item, ids in names.items() if not any(belongs(id, name) for id in claims for name in ids)
    )


def unknown_dependencies(claims: Mapping[str, Claim]) -> dict[str, tuple[str, ...]]:
    """For each claim that says it depends on claims which do not exist: these."""
    unknown = {
        id: tuple(x for x in dependencies(claim) if not meant(x, claims)) for id, claim in claims.items()
    }
    return {id: names for id, names in unknown.items() if names}


def meant(name: str, claims: Collection[str]) -> tuple[str, ...]:
    """The claims that a dependency names: the one of that id, or else all that are a part of that item."""
    return (name,) if name in claims else tuple(id for id in claims if belongs(id, name))


def dependencies(claim: Claim) -> tuple[str, ...]:
    """What a claim depends on, to be stated or to be proved."""
    return tuple(dict.fromkeys((*claim.to_state, *claim.to_prove)))


def cycles(claims: Mapping[str, Claim]) -> tuple[tuple[str, ...], ...]:
    """Circles of claims that depend on one another; one is opened before the next is looked for."""
    found: list[tuple[str, ...]] = []
    graph = {id: {y for x in dependencies(claim) for y in meant(x, claims)} for id, claim in claims.items()}
    while True:
        try:
            TopologicalSorter(graph).prepare()
        except CycleError as error:
            circle = tuple(error.args[1][::-1])  # each depends on the next
            graph[circle[0]].discard(circle[1])
            found.append(circle)
        else:
            return tuple(found)


def unused_constants(claims: Collection[str]) -> tuple[str, ...]:
    """The records of printed constants that belong to no claim, so that nothing would check them."""
    return tuple(id for id in prose() if id not in claims)


def unfilled(claims: Mapping[str, Claim]) -> dict[str, str]:
    """Statements in which a place for a printed constant is left empty."""
    return {
        id: x.statement for id, x in claims.items() if re.search(r"(?<![\\_^])\{[a-z_]\w*\}", x.statement)
    }
