"""The errata as HTML: a table with the short form, the details of each entry folded under it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ..ledger.vocabulary import Verdict
from .corrections import printed, stopped, truth
from .errata import Erratum
from .judged import Judged, gravest
from .markup import folded, link, links, said, table
from .naming import Site, names_of_items
from .pills import check, labelled, named, plain_pill, words
from .wording import to_html

HEADS = ("Where", "Printed", "True", "Whose", "Weight")
WHOSE = {"paper": "paper", "copy": "our copy"}


def errata_table(entries: Iterable[Erratum], site: Site) -> str:
    """The entries as a table."""
    return table("lg-errata", HEADS, "".join(_body(e, site) for e in entries), "Errata")


def _body(e: Erratum, site: Site) -> str:
    first = e.changes[0][0]
    more = len(e.changes) - 1
    also = f' <span class="lg-quiet">and {more} more, below</span>' if more else ""
    number = f'<a class="lg-number" href="#erratum-{e.number}">{e.number}</a>'
    cells = (
        f"{number} {to_html(e.places)}",
        to_html(printed(first)) + also,
        to_html(_true(first)),
        WHOSE[e.kind],
        e.weight.name.lower(),
    )
    row = "".join(f'<td data-label="{name}">{cell}</td>' for name, cell in zip(HEADS, cells, strict=True))
    details = f'<td colspan="{len(HEADS)}">{_details(e, site)}</td>'
    return f'<tbody id="erratum-{e.number}"><tr>{row}</tr><tr class="lg-more">{details}</tr></tbody>'


def _true(x: Judged) -> str:
    """What is true, as a sentence: of a statement whose proof alone is mended, the proof."""
    text = stopped(truth(x))
    if re.match(r"[a-z]{2,} ", text):
        text = text[0].upper() + text[1:]
    return f"The statement stands. Our proof: {text}" if x.verdict is Verdict.REPAIRED else text


def _details(e: Erratum, site: Site) -> str:
    parts = "".join(_change(members, site, told=len(e.changes) > 1) for members in e.changes)
    opener = '<span class="lg-opener">Why, and what it touches</span>'
    x = gravest(e.members)
    verdict = plain_pill(x.verdict, words(x, weighed=False))
    summary = f"{verdict} {opener}"  # without a link: it opens what is folded
    return folded(summary, f"{parts}{''.join(_reasons(e))}{_touched(e, site)}")


def _change(members: tuple[Judged, ...], site: Site, told: bool) -> str:
    """A change, and the claims that need it; if it is the only one, the row above has told it."""
    where = ", ".join(f"{link(site.claim(x.id), named(x.id))} ({check(x, site)})" for x in members)
    if not told:
        return f'<p class="lg-links">{where}</p>'
    return f'<div class="lg-entry"><p>{where}: {to_html(printed(members[0]))}</p>{labelled(members[0])}</div>'


def _reasons(e: Erratum) -> Iterator[str]:
    """Witnesses and evidence, each once."""
    for label, name in (("Witness", "witness"), ("Evidence", "evidence"), ("Tested", "tested")):
        texts = dict.fromkeys(getattr(x.finding, name) for x in e.members)
        yield from (said(label, to_html(text)) for text in texts if text)


def _touched(e: Erratum, site: Site) -> str:
    if not e.direct:
        return "<p><strong>Touches</strong> nothing else in the ledger.</p>"
    direct = names_of_items(e.direct)
    further = {name: id for name, id in names_of_items(e.indirect).items() if name not in direct}
    text = f"<p><strong>Used by</strong> {_names(direct, site)}.</p>"
    if further:
        text += f'<p class="lg-quiet">And through these by {_names(further, site)}.</p>'
    return text


def _names(names: dict[str, str], site: Site) -> str:
    return links({to_html(name): site.claim(id) for name, id in names.items()})
