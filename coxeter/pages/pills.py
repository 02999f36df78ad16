"""Verdicts as HTML: a pill with a sign, words and a colour; a box with all there is to say of some claims."""

from __future__ import annotations

import html
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from ..ledger.vocabulary import Verdict
from .corrections import stopped, truth
from .headline import NAMES
from .judged import Judged, gravest
from .markup import folded, link, said
from .naming import Site, name_of
from .wording import statement, to_html, to_plain

CSS_NAMES = {verdict: name for name, verdict in NAMES.items()}
SIGNS = {
    Verdict.HOLDS: "✓",
    Verdict.CORRECTED: "≠",
    Verdict.REPAIRED: "↻",
    Verdict.FAILS: "✗",
    Verdict.TRANSCRIPTION: "◪",
    Verdict.CITED: "❞",
    Verdict.OPEN: "?",
}
"""A sign for each verdict, so that its colour is never all that tells it."""

LABELS = {Verdict.FAILS: "Instead", Verdict.REPAIRED: "Our proof", Verdict.CITED: "Source"}
"""What a correction is in each case, if it is not what to use instead."""


def words(x: Judged, weighed: bool = True) -> str:
    """A verdict with its strength; with its weight too if it does not hold, and that is not left out."""
    parts = [x.verdict.value, str(x.finding.strength)]
    if weighed and x.verdict is not Verdict.HOLDS:
        parts.append(x.claim.weight.value)
    return " · ".join(parts)


def pill(claims: Sequence[Judged], site: Site, weighed: bool = True) -> str:
    """The verdict on some claims, the gravest of all, as a link to its row in the ledger."""
    x = gravest(claims)
    title = html.escape(summary(claims), quote=True)
    name = html.escape(f"{name_of(x.id)}: {words(x)}", quote=True)
    several = f' data-claims="{html.escape(count(claims))}"' if len(claims) > 1 else ""
    return (
        f'<a class="lg-pill lg-{CSS_NAMES[x.verdict]}" href="{site.claim(x.id)}" title="{title}"{several} '
        f'aria-label="{name}">{signed(x.verdict, words(x, weighed))}</a>'
    )


def mark(x: Judged) -> str:
    """The verdict without a link, for where one is already."""
    return plain_pill(x.verdict, words(x))


def plain_pill(verdict: Verdict, told: str) -> str:
    """A verdict in words, with its sign and colour."""
    return f'<span class="lg-pill lg-{CSS_NAMES[verdict]}">{signed(verdict, told)}</span>'


def signed(verdict: Verdict, told: str) -> str:
    """Words after the sign of a verdict."""
    return f'<span class="lg-sign" aria-hidden="true">{SIGNS[verdict]}</span> <span>{told}</span>'


def summary(claims: Sequence[Judged]) -> str:
    """What a pointer that rests on a pill is told: the statement, and the other claims' verdicts."""
    x = gravest(claims)
    told = to_plain(statement(x.claim))
    return told if len(claims) == 1 else f"{count(claims)}. The gravest, {name_of(x.id)}: {told}"


def count(claims: Iterable[Judged]) -> str:
    """Verdicts in words, the most frequent first: ``8 claims: 7 holds · 1 fails``, ``3 claims: all hold``."""
    counts = Counter(x.verdict.value for x in claims)
    total = sum(counts.values())
    if total == 1:
        return f"1 claim: {next(iter(counts))}"
    parts = [f"{n} {verdict}" for verdict, n in counts.most_common()]
    if len(counts) == 1:
        parts = [
            "all "
            + next(iter(counts))
            .replace("holds", "hold")
            .replace("proof ", "proofs ")
            .replace("fails", "fail")
        ]
    return f"{total} claims: {' · '.join(parts)}"


# -- boxes -------------------------------------------------------------------------------------------------


def box(claims: Sequence[Judged], site: Site) -> tuple[str, str]:
    """A box with the verdict on some claims: what to use instead, and what there is to see behind it.

    Its two parts; between them there is room for words about the claims.
    """
    x = gravest(claims)
    inner = entry(x, site, told=False) if len(claims) == 1 else _entries(claims, site)
    head = f'<p class="lg-box-head">{pill(claims, site)}</p>'
    return f'<div class="lg-box lg-{CSS_NAMES[x.verdict]}">{head}', f"{inner}</div>"


def _entries(claims: Sequence[Judged], site: Site) -> str:
    """Claims that are not right as printed, one by one; the others folded."""
    wrong = [y for y in claims if y.is_erratum]
    others = [y for y in claims if not y.is_erratum]
    rows = "".join(f"<li>{line(y, site)}</li>" for y in others)
    also = f"Besides, {count(others)}" if wrong else count(others)
    return "".join(entry(y, site) for y in wrong) + folded(also, rows and f"<ul>{rows}</ul>")


def line(x: Judged, site: Site) -> str:
    """A claim in a line: its name, its statement, its verdict."""
    return f"{link(site.claim(x.id), named(x.id))}: {to_html(statement(x.claim))} {mark(x)}"


def named(id: str) -> str:
    """The name of a claim as HTML."""
    return to_html(name_of(id))


def entry(x: Judged, site: Site, told: bool = True) -> str:
    """The correction of a claim and the reasons; its name and statement too, if they are not above."""
    head = f"<p>{line(x, site)}</p>" if told else ""
    reasons = folded("Why", "".join(reason(x)))
    ways = f"{link(site.claim(x.id), 'ledger', f'{x.id} in the ledger')} · {check(x, site)}"
    return f'<div class="lg-entry">{head}{labelled(x)}{reasons}<p class="lg-links">{ways}</p></div>'


def check(x: Judged, site: Site) -> str:
    """A link to the source of the check."""
    return link(site.code(x.claim), "check", f"the check of {x.id}")


def labelled(x: Judged) -> str:
    """The correction with the word for what it is."""
    text = truth(x)
    return said(LABELS.get(x.verdict, "Use instead"), to_html(stopped(text))) if text else ""


def reason(x: Judged) -> Iterator[str]:
    """What stands behind a verdict: witness, evidence, instances, derivation."""
    finding = x.finding
    for label, text in (
        ("Witness", finding.witness),
        ("Evidence", finding.evidence),
        ("Tested", finding.tested),
    ):
        if text:
            yield said(label, to_html(text))
    if finding.derivation:
        yield "<ol>" + "".join(f"<li>{to_html(step)}</li>" for step in finding.derivation) + "</ol>"
    if finding.proof:
        names = ", ".join(map(repr, finding.proof))
        yield said("Proof for every d", f"<code>coxeter.proofs.prove({names})</code>")
