"""What a card says of a claim or an erratum, when a pointer rests on a link that leads there."""

from __future__ import annotations

from .corrections import printed, truth
from .errata import Erratum
from .judged import Judged
from .pills import labelled, mark, named
from .wording import statement, to_html


def card(head: str, *parts: str) -> str:
    """A card: a head, which is HTML, and what is below it.

    >>> card("Title", "", "<p>Words.</p>")
    '<p class="cx-card-head">Title</p><p>Words.</p>'
    """
    first = f'<p class="cx-card-head">{head}</p>' if head else ""
    return first + "".join(parts)


def claim_card(x: Judged) -> str:
    """A claim: its name, its verdict, what it says, and what to use instead."""
    said = f"<p>{to_html(statement(x.claim))}</p>"
    return card(f"<strong>{named(x.id)}</strong> {mark(x)}", said, labelled(x))


def erratum_card(e: Erratum) -> str:
    """An erratum: where, what is printed, what is true."""
    first = e.changes[0][0]
    more = len(e.members) - 1
    also = f'<p class="lg-quiet">and {more} more with the same cause</p>' if more else ""
    return card(
        f"<strong>Erratum {e.number}</strong> {to_html(first.claim.place)} {mark(first)}",
        f"<p><strong>Printed:</strong> {to_html(printed(first))}</p>",
        f"<p><strong>True:</strong> {to_html(truth(first))}</p>" if truth(first) else "",
        also,
    )


def brief(head: str, words: str = "", where: str = "") -> str:
    """A card for anything else, of which there is a line or two to say.

    >>> brief("A", "Some words.")
    '<p class="cx-card-head"><strong>A</strong></p><p>Some words.</p>'
    """
    said = f"<p>{words}</p>" if words else ""
    place = f'<p class="lg-quiet">{where}</p>' if where else ""
    return card(f"<strong>{head}</strong>" if head else "", said, place)
