"""The dependency graph as a page has it: what to ask of it, and the drawing in a box in which it moves."""

from __future__ import annotations

import html

from ..ledger.vocabulary import Extent, Verdict
from .dependencies import Dependencies, name_of_node
from .graph import drawing
from .judged import Ledger, gravest
from .markup import scroll, select
from .naming import Site
from .wording import to_plain, type_plain

ZOOMS = {"in": ("+", "Zoom in"), "out": ("−", "Zoom out"), "fit": ("Fit", "Show the whole graph")}
HINT = "Drag to move, pinch or turn the wheel with Ctrl to zoom; on the keyboard arrows, + and −, 0 for all."


def graph_page(ledger: Ledger, site: Site) -> str:
    """Controls, which its script shows, and the drawing."""
    return controls(ledger) + scroll(drawing(ledger, site), "The graph")


def controls(ledger: Ledger) -> str:
    """A field to find an item, what to filter by, and buttons to zoom."""
    members = Dependencies(ledger).members
    found = [gravest(claims) for claims in members.values()]
    verdicts = [v.value for v in Verdict if any(x.verdict is v for x in found)]
    strengths = [e.value for e in Extent if any(x.finding.strength.extent is e for x in found)]
    names = "".join(f'<option value="{html.escape(item_name(node))}">' for node in members)
    find = '<input type="search" name="find" list="lg-items" placeholder="Lemma 7" autocomplete="off">'
    buttons = "".join(
        f'<button type="button" data-zoom="{kind}" aria-label="{told}" title="{told}">{sign}</button>'
        for kind, (sign, told) in ZOOMS.items()
    )
    return (
        '<form class="lg-controls lg-graph-controls" role="search" aria-label="Find and filter items" hidden>'
        f'<label>Find an item {find}</label><datalist id="lg-items">{names}</datalist>'
        f"{select('verdict', verdicts)}{select('strength', strengths)}"
        '<button type="reset">Show all</button>'
        f'<span class="lg-zoom" role="group" aria-label="Zoom">{buttons}</span>'
        f'<output aria-live="polite"></output><p class="lg-quiet">{HINT}</p></form>'
    )


def item_name(node: str) -> str:
    """An item in plain letters."""
    return type_plain(to_plain(name_of_node(node)))
