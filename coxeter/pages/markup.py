"""Small pieces of HTML that several views are made of."""

from __future__ import annotations

import html
from collections.abc import Iterable, Mapping


def scroll(inner: str, label: str) -> str:
    """A box in which something wide can be scrolled, by keyboard too."""
    return (
        f'<div class="lg-scroll" tabindex="0" role="region" aria-label="{html.escape(label)}">{inner}</div>'
    )


def table(kind: str, head: Iterable[str], bodies: str, label: str) -> str:
    """A table in a box, with its bodies, and a foot if there is one, as HTML."""
    cells = "".join(f'<th scope="col">{name}</th>' for name in head)
    return scroll(f'<table class="{kind}"><thead><tr>{cells}</tr></thead>{bodies}</table>', label)


def row(name: str, cells: Iterable[object], kind: str = "") -> str:
    """A row with its name; all of it is HTML."""
    inner = "".join(f"<td>{cell}</td>" for cell in cells)
    return f'<tr{f" class={kind}" if kind else ""}><th scope="row">{name}</th>{inner}</tr>'


def link(address: str, words: str, label: str = "") -> str:
    """A link; a label says what words as short as "check" do not."""
    told = f' aria-label="{html.escape(label, quote=True)}"' if label else ""
    return f'<a href="{address}"{told}>{words}</a>'


def links(names: Mapping[str, str]) -> str:
    """Links, by their words, with commas between."""
    return ", ".join(link(address, words) for words, address in names.items())


def downloads(files: Mapping[str, str]) -> str:
    """A line of links to files, by their words."""
    each = " · ".join(f'<a href="{address}" download>{words}</a>' for words, address in files.items())
    return f'<p class="lg-links">Download: {each}</p>'


def folded(summary: str, inner: str, kind: str = "") -> str:
    """Something to unfold; nothing if there is nothing in it."""
    return (
        f"<details{kind and f' class={kind}'}><summary>{summary}</summary>{inner}</details>" if inner else ""
    )


def said(label: str, text: str) -> str:
    """A paragraph that begins with a word in bold."""
    return f"<p><strong>{label}:</strong> {text}</p>"


def select(name: str, values: Iterable[str], first: str = "any") -> str:
    """A field of a form with something to choose from; nothing is chosen at first."""
    options = "".join(f"<option>{html.escape(value)}</option>" for value in values)
    choice = f'<select name="{name}"><option value="">{first}</option>{options}</select>'
    return f"<label>{name.capitalize()} {choice}</label>"
