"""The corrected tables as HTML: each changed cell marked, what is printed and why one click away."""

from __future__ import annotations

import html

from .corrected import Entry, Sheet
from .corrections import printed, truth
from .errata import Erratum
from .judged import Judged, Ledger
from .markup import downloads, folded, link, table
from .naming import Site
from .pills import CSS_NAMES, SIGNS, mark, named
from .wording import to_html, to_plain, type_html

FILES = {"CSV": "csv", "JSON": "json", "LaTeX": "tex"}


def sheet_html(sheet: Sheet, ledger: Ledger, errata: tuple[Erratum, ...], site: Site) -> str:
    """A table, its downloads, and the list of what was changed."""
    notes = {x.id: x for x in sheet.changed(ledger)}
    before = (None, *sheet.rows)
    rows = "".join(_row(row, last, notes) for last, row in zip(before, sheet.rows, strict=False))
    files = {words: site.download(f"table-{sheet.number}.{end}") for words, end in FILES.items()}
    return (
        table(f"lg-sheet lg-sheet-{sheet.number}", map(_head, sheet.header), rows, f"Table {sheet.number}")
        + downloads(files)
        + _notes(notes, errata, site)
    )


def _head(name: str) -> str:
    return html.escape(name).replace("^(1/d)", "<sup>1/d</sup>")


def _row(row: tuple[Entry, ...], before: tuple[Entry, ...] | None, notes: dict[str, Judged]) -> str:
    """A row; the name of a type stands in the first of its rows only."""
    first, *rest = row
    cells = "".join(_cell(entry, notes.get(entry.claim)) for entry in rest)
    if before is not None and before[0] == first:
        return f'<tr><th scope="row"></th>{cells}</tr>'
    return f'<tr class="lg-first"><th scope="row">{_name(first)}</th>{cells}</tr>'


def _name(entry: Entry) -> str:
    """The name of a type, with a condition if there is one."""
    type_, _, _ = entry.tex.partition(",")
    return type_html(type_) + "".join(entry.plain.partition(",")[1:])


def _cell(entry: Entry, note: Judged | None) -> str:
    text = to_html(entry.latex) if entry.latex else '<span class="lg-quiet">–</span>'
    if note is None:
        return f"<td>{text}</td>"
    sign = f'<sup class="lg-sign" aria-hidden="true">{SIGNS[note.verdict]}</sup>'
    why = link(f"#note-{note.id}", sign, "what is printed here, and why it was changed")
    told = html.escape(_hover(note), quote=True)
    return f'<td class="lg-changed lg-{CSS_NAMES[note.verdict]}" title="{told}">{text}{why}</td>'


def _hover(x: Judged) -> str:
    """What is printed, and the reason."""
    reason = x.finding.evidence or x.finding.witness
    return to_plain(f"{x.verdict.value}. {x.finding.correction}" + (f" ({reason})" if reason else ""))


def _notes(notes: dict[str, Judged], errata: tuple[Erratum, ...], site: Site) -> str:
    if not notes:
        return '<p class="lg-quiet">Everything is as printed.</p>'
    entries = {x.id: e for e in errata for x in e.members}
    rows = "".join(_note(x, entries[x.id], site) for x in notes.values())
    ours = sum(entries[id].kind == "copy" for id in notes)
    printed_wrong, copied_wrong = (number or "nothing" for number in (len(notes) - ours, ours))
    words = f"What was changed: {printed_wrong} in print, {copied_wrong} only in our copy"
    return folded(words, f"<ul>{rows}</ul>", "lg-notes")


def _note(x: Judged, e: Erratum, site: Site) -> str:
    told = {
        "Printed": printed(x),
        "True": truth(x),
        "Evidence": x.finding.evidence,
        "Witness": x.finding.witness,
    }
    parts = " ".join(f"<em>{name}:</em> {_ended(to_html(text))}" for name, text in told.items() if text)
    ways = f"{link(site.erratum(e.number), f'erratum {e.number}')} · {link(site.claim(x.id), 'ledger')}"
    return f'<li id="note-{x.id}">{mark(x)} <strong>{named(x.id)}.</strong> {parts} {ways}</li>'


def _ended(text: str) -> str:
    return text if text.endswith(".") else f"{text}."
