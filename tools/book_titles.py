"""Titles without TeX, where no script sets formulas: side bar, browser, search, links to the next chapter.

A page without formulas then needs no such script, and a link that is all formula has words for a screen
reader. Headings on a page keep their formulas.
"""

import re
import unicodedata
from collections.abc import Iterator
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

SIGNS = {"ge": "≥", "geq": "≥", "le": "≤", "leq": "≤", "dots": "…", "ldots": "…", "infty": "∞", "to": "→"}
BELOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def setup(app: Sphinx) -> None:
    app.connect("doctree-read", plain_title, priority=900)  # after Sphinx has collected the titles
    app.connect("doctree-resolved", letters_below)
    app.connect("html-page-context", plain_heads)
    app.connect("html-collect-pages", plain_search)


def to_text(tex: str) -> str:
    r"""A short formula in plain letters.

    >>> to_text(r"\tilde A_d"), to_text(r"\tilde{E}_{6}, d \ge 2"), to_text(r"c/\sqrt d")
    ('Ã_d', 'Ẽ₆, d ≥ 2', 'c/√d')
    """
    text = re.sub(r"\\tilde\s*\{?\s*(\w)\}?", lambda m: m[1] + "\N{COMBINING TILDE}", tex)
    text = re.sub(r"\\sqrt\s*", "√", text)
    text = re.sub(r"\\mathbb\s*\{?R\}?", "ℝ", text)
    text = re.sub(r"\\([A-Za-z]+)", lambda m: SIGNS.get(m[1], _greek(m[1])), text)
    text = re.sub(r"_\{?(\d+)\}?", lambda m: m[1].translate(BELOW), text)
    text = re.sub(r"\\.|[{}$]", "", text)
    return unicodedata.normalize("NFC", " ".join(text.split()))


def _greek(name: str) -> str:
    size = "CAPITAL" if name[0].isupper() else "SMALL"
    try:
        return unicodedata.lookup(f"GREEK {size} LETTER {name.upper()}")
    except KeyError:
        return name


def in_plain(text: str) -> str:
    r"""A text in which formulas stand between \( and \), as HTML has them.

    >>> in_plain(r"\(\tilde A_d\), \(d \ge 2\)")
    'Ã_d, d ≥ 2'
    """
    return re.sub(r"\\\((.*?)\\\)", lambda m: to_text(m[1]), text)


def plain_title(app: Sphinx, doctree: nodes.document) -> None:
    """The title by which other pages, the search and the browser know a chapter."""
    for titles in (app.env.titles, app.env.longtitles):
        title = titles.get(app.env.docname)
        if title is not None and list(title.findall(nodes.math)):
            words = "".join(to_text(str(x)) if _is_math(x) else str(x) for x in title.findall(nodes.Text))
            titles[app.env.docname] = nodes.title("", words)
            if link := next(iter(app.env.tocs[app.env.docname].findall(nodes.reference)), None):
                link.children = list(_below(words))


def _below(words: str) -> Iterator[nodes.Node]:
    """Text with its letters below the line, which Unicode has not, as such."""
    for count, part in enumerate(re.split(r"_(\w)", words)):
        if part:
            yield nodes.subscript("", part) if count % 2 else nodes.Text(part)


def letters_below(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """The same in links to chapters."""
    for link in doctree.findall(lambda node: isinstance(node, nodes.inline) and "doc" in node["classes"]):
        if "_" in (words := link.astext()):
            link.children = []
            link.extend(_below(words))


def _is_math(text: nodes.Text) -> bool:
    return isinstance(text.parent, nodes.math)


def plain_heads(app: Sphinx, pagename: str, template: str, context: dict[str, Any], *_: Any) -> None:
    """What the browser is told of a page beside its body, and the links to the pages around it."""
    if title := context.get("title"):
        context["title"] = in_plain(title)
    for page in filter(None, (context.get("prev"), context.get("next"))):
        page["title"] = re.sub(r"_(\w)\b", r"<sub>\1</sub>", page["title"])


def plain_search(app: Sphinx) -> list[tuple[str, dict[str, Any], str]]:
    """The headings that a search shows; Sphinx keeps them as they are written."""
    index = getattr(app.builder, "indexer", None)
    titles = getattr(index, "_titles", {})
    titles.update({page: _heading(words) for page, words in titles.items() if words})
    for page, headings in getattr(index, "_all_titles", {}).items():
        index._all_titles[page] = [(_heading(words), place) for words, place in headings]  # type: ignore[union-attr]
    return []


def _heading(words: str) -> str:
    r"""A heading's text, whose formulas Sphinx joins to the words without a mark; a family loses its d.

    >>> _heading(r"Figure 4 · \tilde A_d"), _heading("B̃_d, d ≥ 3"), _heading("book_titles")
    ('Figure 4 · Ã', 'B̃, d ≥ 3', 'book_titles')
    """
    return re.sub(r"(?<=\u0303)_d\b|(?<=Ã)_d\b", "", to_text(words) if "\\" in words else words)
