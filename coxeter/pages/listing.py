"""The whole ledger as HTML: a summary, and a row for each claim, section by section. And as JSON."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator

from ..ledger.reporting import score
from ..ledger.selecting import SECTIONS, families_of, section_of
from ..ledger.vocabulary import Extent, Verdict, Weight
from ..names import FAMILIES
from ..tables.pieces import MATHS
from .judged import FIRMNESS, GRAVITY, Judged, Ledger
from .markup import folded, link, links, row, select, table
from .naming import Site, item_of, name_of_item, names_of_items
from .pills import CSS_NAMES, check, count, labelled, mark, plain_pill, reason
from .wording import statement, to_html

UNNUMBERED = tuple(f"sec{section}" for section in SECTIONS)
HINT = "What is asked stands in the address of the page, which can be kept or sent."
SORTS = ("verdict", "strength", "weight")
"""By what the rows can be sorted; the script takes the order of the values in the field of that name."""

LAZY = "lg-tex"
"""The class of formulas that are set when they come into view: there are thousands of them."""


def by_section(ledger: Iterable[Judged]) -> dict[str, tuple[Judged, ...]]:
    """The claims of each section and appendix; in Section 6 family by family, item by item."""
    groups: dict[str, list[Judged]] = {name: [] for name in SECTIONS}
    for x in ledger:
        groups[section_of(x.claim)].append(x)
    return {name: tuple(sorted(group, key=_place)) for name, group in groups.items() if group}


def _place(x: Judged) -> tuple[int, str]:
    parts = item_of(x.id).split(".")
    if parts[0] != "sec6" or len(parts) < 2:
        return -1, ""
    return FAMILIES.index(parts[1]), parts[2] if len(parts) > 2 else ""


def section_name(section: str) -> str:
    """A section as the page names it."""
    return f"Section {section}" if section.isdigit() else f"Appendix {section}"


# -- summary -----------------------------------------------------------------------------------------------


def summary_table(ledger: Ledger) -> str:
    """Verdicts by strength, and how many mutants were rejected."""
    counts = Counter((x.verdict, x.finding.strength.extent) for x in ledger)
    columns = [extent for extent in Extent if any(e is extent for _, e in counts)]
    rows = "".join(_summary_row(v, columns, counts) for v in Verdict if any(w is v for w, _ in counts))
    sums = row("all", [*(sum(counts[v, e] for v in Verdict) for e in columns), len(ledger)])
    head = ("verdict", *(extent.value for extent in columns), "all")
    made = table(
        "lg-summary", head, f"<tbody>{rows}</tbody><tfoot>{sums}</tfoot>", "Claims by verdict and strength"
    )
    mutants = score(x.result for x in ledger)
    return f"{made}<p>Mutants, statements with one constant moved: <strong>{mutants}</strong>.</p>"


def _summary_row(verdict: Verdict, columns: list[Extent], counts: Counter[tuple[Verdict, Extent]]) -> str:
    line = [counts[verdict, extent] for extent in columns]
    return row(plain_pill(verdict, verdict.value), [*(n or "·" for n in line), sum(line)])


# -- rows --------------------------------------------------------------------------------------------------


def listing(ledger: Ledger, site: Site) -> str:
    """Controls for the page's script, and the rows of all sections, folded."""
    seen: set[str] = set()
    groups = (_group(name, claims, seen, ledger, site) for name, claims in by_section(ledger).items())
    return f"{_controls(ledger)}{''.join(groups)}"


def _controls(ledger: Ledger) -> str:
    """Shown by the script that needs them."""
    families = {name for x in ledger for name in families_of(x.claim)}
    asked = {
        "verdict": [v.value for v in GRAVITY if any(x.verdict is v for x in ledger)],
        "strength": [e.value for e in FIRMNESS if any(x.finding.strength.extent is e for x in ledger)],
        "weight": [w.value for w in Weight if any(x.claim.weight is w for x in ledger)],
        "section": map(section_name, by_section(ledger)),
        "family": [name for name in FAMILIES if name in families],
    }
    selects = "".join(select(name, values) for name, values in asked.items())
    search = '<input type="search" name="words" placeholder="words or an id" autocomplete="off">'
    return (
        f'<form class="lg-controls" role="search" aria-label="Claims" hidden><label>Search {search}</label>'
        f'{selects}{select("sort", SORTS, "paper order")}<button type="reset">Show all</button>'
        f'<output aria-live="polite"></output><p class="lg-quiet">{HINT}</p></form>'
    )


def _group(section: str, claims: tuple[Judged, ...], seen: set[str], ledger: Ledger, site: Site) -> str:
    """The rows of a section; `seen` are the items that have had a heading, here or in another section."""
    parts: list[str] = []
    before = ""
    for x in claims:
        item = item_of(x.id)
        if item != before:
            parts.append(_heading(item, again=item in seen))
            seen.add(item)
        parts.append(_row(x, ledger, site))
        before = item
    name = f'<span class="lg-group-name">{section_name(section)}</span>'
    summary = f'{name} <span class="lg-quiet">{count(claims)}</span>{_bar(claims)}'
    return (
        f'<details class="lg-group" id="section-{section}"><summary>{summary}</summary>'
        f"{''.join(parts)}</details>"
    )


def _heading(item: str, again: bool) -> str:
    """The heading of an item; where it comes again, as a lemma with its proof, it is no place to link to."""
    name = "Without a number" if item in UNNUMBERED else to_html(name_of_item(item))
    place = "" if again else f' id="item-{item}"'
    return f'<h3 class="lg-item"{place}>{name}</h3>'


def _bar(claims: tuple[Judged, ...]) -> str:
    """The shares of the verdicts, for a glance; the words beside it say the same."""
    counts = Counter(x.verdict for x in claims)
    parts = (f'<i class="lg-{CSS_NAMES[v]}" style="flex:{counts[v]}"></i>' for v in Verdict if counts[v])
    return f'<span class="lg-bar" aria-hidden="true">{"".join(parts)}</span>'


def _row(x: Judged, ledger: Ledger, site: Site) -> str:
    result = x.result
    mutants = (
        f"{result.rejected} of {result.tried} mutants rejected" if result.tried else "no constants to move"
    )
    told = " · ".join((to_html(x.claim.place, LAZY), mutants, seconds(result.seconds), check(x, site)))
    data = {
        "verdict": x.verdict.value,
        "strength": x.finding.strength.extent.value,
        "weight": x.claim.weight.value,
        "family": " ".join(sorted(families_of(x.claim))),
    }
    attributes = "".join(f' data-{name}="{value}"' for name, value in data.items() if value)
    return (
        f'<article class="lg-claim" id="claim-{x.id}"{attributes}>'
        f'<p class="lg-head"><a class="lg-id" href="#claim-{x.id}">{x.id}</a> {mark(x)}</p>'
        f'<p class="lg-said">{to_html(statement(x.claim), LAZY)}</p>'
        f'<p class="lg-meta">{told}</p>{"".join(_more(x, ledger))}</article>'
    )


def seconds(x: float) -> str:
    """A time in words.

    >>> seconds(0.0004), seconds(0.0312), seconds(2.2)
    ('under 0.01 s', '0.03 s', '2.20 s')
    """
    return f"{x:.2f} s" if x >= 0.01 else "under 0.01 s"


def _more(x: Judged, ledger: Ledger) -> Iterator[str]:
    """What stands under a row: correction and reasons; what it needs, and what needs it."""
    yield labelled(x).replace(MATHS, LAZY)
    yield folded("Why", "".join(reason(x)).replace(MATHS, LAZY))
    yield folded("Rests on, and carries", "".join(_needs(x, ledger)))


def _needs(x: Judged, ledger: Ledger) -> Iterator[str]:
    for label, kind in (("To be stated it needs", "to_state"), ("To be proved it needs", "to_prove")):
        if names := getattr(x.claim, kind):
            yield f"<p>{label} {', '.join(_link(name, ledger) for name in names)}.</p>"
    if users := ledger.needed_by[x.id]:
        items = {to_html(name, LAZY): f"#claim-{id}" for name, id in names_of_items(users).items()}
        yield f"<p>Needed by {links(items)}.</p>"


def _link(name: str, ledger: Ledger) -> str:
    """A claim that is needed, or an item with all its claims."""
    return link(f"#claim-{name if name in ledger.by_id else ledger.find(name)[0].id}", name)


# -- JSON --------------------------------------------------------------------------------------------------


def as_json(ledger: Ledger) -> str:
    """A list of objects, one for each claim."""
    return json.dumps([_object(x) for x in ledger], indent=1, ensure_ascii=False, default=str) + "\n"


def _object(x: Judged) -> dict[str, object]:
    finding = x.finding
    return {
        "id": x.id,
        "place": x.claim.place,
        "section": section_of(x.claim),
        "statement": statement(x.claim),
        "printed": dict(x.claim.printed),
        "verdict": finding.verdict.value,
        "strength": str(finding.strength),
        "weight": x.claim.weight.value,
        "correction": finding.correction,
        "witness": finding.witness,
        "evidence": finding.evidence,
        "tested": finding.tested,
        "derivation": list(finding.derivation),
        "proof": list(finding.proof),
        "depends_on": {"to_state": list(x.claim.to_state), "to_prove": list(x.claim.to_prove)},
        "mutants": {"tried": x.result.tried, "rejected": x.result.rejected},
        "seconds": round(x.result.seconds, 4),
        "check": x.claim.code,
    }
