"""The main results as they are true, with all that they rest on, and what of that is only cited."""

from __future__ import annotations

from collections.abc import Sequence

from ..errors import InvalidInput
from ..ledger.phrases import says
from ..ledger.vocabulary import Extent, Verdict
from ..proofs.rates import constant
from .corrections import truth
from .judged import Judged, Ledger
from .markup import folded, links, row, table
from .naming import Site, name_of, names_of_items
from .pills import pill
from .wording import statement, to_html

UNPROVED = (Verdict.CITED, Verdict.OPEN)
"""What we have not proved ourselves, by the verdict."""

MEASURES = ("fatness", "aspect_ratio", "thickness", "radius_ratio")
TESTED = (Extent.INSTANCES, Extent.LITERATURE)
"""And by the strength, whatever the verdict."""


def trust(lines: Sequence[str], ledger: Ledger, site: Site) -> str:
    """A card for each line, which is a title, a colon, and the ids of claims or items.

    Raises
    ------
    InvalidInput
        If a line has no colon, or names a claim that there is not.
    """
    return (
        f'<div class="lg-cards">{"".join(_card(line, ledger, site) for line in lines if line.strip())}</div>'
    )


def _card(line: str, ledger: Ledger, site: Site) -> str:
    title, colon, asked = line.partition(":")
    if not colon:
        raise InvalidInput(f"{line!r} has no colon: give a title, a colon, and ids")
    claims = [x for id in asked.split(",") for x in _asked(id.strip(), ledger)]
    rows = "".join(f"<li>{_row(x, site)}</li>" for x in claims)
    inner = f"<h3>{to_html(title)}</h3><ul>{rows}</ul>{_rests(claims, ledger, site)}"
    return f'<section class="lg-card">{inner}</section>'


def _row(x: Judged, site: Site) -> str:
    return f"{to_html(corrected_statement(x))} {pill([x], site, weighed=False)}"


def _asked(id: str, ledger: Ledger) -> Sequence[Judged]:
    """A claim alone, even if its item has others; or all of an item."""
    return [ledger[id]] if id in ledger.by_id else ledger.find(id)


def corrected_statement(x: Judged) -> str:
    """The statement in the form in which it is true."""
    if x.verdict.accepts:
        return statement(x.claim)
    constants = x.finding.constants or {}
    moved = [name for name in constants if constants[name] != x.claim.printed.get(name)]
    if x.verdict is not Verdict.FAILS and moved and all(says(x.claim.words, name) for name in moved):
        return statement(x.claim, constants)
    return f"{truth(x)} (printed: {statement(x.claim)})"


def unproved(claims: Sequence[Judged]) -> tuple[Judged, ...]:
    """Those that rest on somebody else's proof, or on instances."""
    return tuple(x for x in claims if x.verdict in UNPROVED or x.finding.strength.extent in TESTED)


def _rests(claims: Sequence[Judged], ledger: Ledger, site: Site) -> str:
    below = tuple(ledger[id] for id in ledger.closure(x.id for x in claims))
    cited = unproved([*claims, *below])
    only = (
        f"Only cited, or tested on instances: {_names(cited, site, each=True)}."
        if cited
        else "Nothing of it is only cited."
    )
    if not below:
        return f'<p class="lg-quiet">Proved by itself. {only}</p>'
    rests = folded(f"Rests on {len(below)} claims", f"<p>{_names(below, site)}.</p>")
    return f'{rests}<p class="lg-quiet">{only}</p>'


def _names(claims: Sequence[Judged], site: Site, each: bool = False) -> str:
    ids = [x.id for x in claims]
    names = {name_of(id): id for id in ids} if each else names_of_items(ids)
    return links({to_html(name): site.claim(id) for name, id in names.items()})


# -- rates -------------------------------------------------------------------------------------------------


def rates() -> str:
    """The limits of √d times each normalised measure in the four families, proved."""
    head = ("type", *(measure.replace("_", " ") for measure in MEASURES))
    rows = "".join(
        row(to_html(f"{letter}~_d"), (to_html(f"${constant(letter, m).latex()}$") for m in MEASURES))
        for letter in "ABCD"
    )
    return table("lg-sheet", head, f"<tbody>{rows}</tbody>", "Limits")
