"""Hover cards: what a link inside the book leads to, kept in the page itself.

Each page gets the cards that its links need, as JSON, and a script shows them; so they work from file:// too.
A link to a page of the book, a claim or an erratum that leads nowhere is a warning, and fails the build.
"""

import ast
import html
import json
import posixpath
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any
from urllib.parse import unquote, urlsplit

import book_extension
from book_code import code_of
from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.util import logging

from coxeter.errors import CoxeterError
from coxeter.pages.cards import brief, claim_card, erratum_card
from coxeter.pages.wording import to_html
from coxeter.tables.pieces import MATHS

LINK = re.compile(r"<a\b([^>]*)>")
HREF = re.compile(r'\bhref="([^"]+)"')
PASSED = re.compile(r'class="[^"]*\b(?:headerlink|viewcode-back|external|lg-number|lg-id)\b')
"""Links that say all there is to say, or lead out of the book."""

LEDGER, ERRATA, CHECKS = "book/ledger", "book/errata", "checks/"
NOWHERE = ("genindex", "py-modindex", "search")
SENTENCE = re.compile(r"(?<![A-Z])[.!?](?=\s|$)")
SILENT = (nodes.image, nodes.raw, nodes.target, nodes.comment, nodes.footnote_reference, nodes.system_message)

log = logging.getLogger(__name__)


def setup(app: Sphinx) -> None:
    app.add_css_file("reading.css")
    app.connect("html-page-context", add_cards, priority=700)  # after all that writes links


def add_cards(app: Sphinx, pagename: str, template: str, context: dict[str, Any], *_: Any) -> None:
    """The cards of a page, after its text."""
    if pagename not in app.env.found_docs or "body" not in context:
        return
    cards = Cards.of(app).needed(pagename, context["body"])
    if cards or pagename == LEDGER:
        app.add_js_file("cards.js", loading_method="defer")
        data = json.dumps(cards, ensure_ascii=False, separators=(",", ":")).replace("</", "<\\/")
        context["body"] += f'<script type="application/json" id="cx-cards">{data}</script>'


def links(body: str) -> Iterator[str]:
    """The addresses to which the links of a page lead, each once."""
    found = (HREF.search(x) for x in LINK.findall(body) if not PASSED.search(x))
    yield from dict.fromkeys(x[1] for x in found if x)


@dataclass(eq=False)
class Cards:
    """The cards of a book, each made when a page first needs it."""

    app: Sphinx
    made: dict[tuple[str, str], str | None] = field(default_factory=dict)
    trees: dict[str, dict[str, nodes.Element | None]] = field(default_factory=dict)

    @classmethod
    def of(cls, app: Sphinx) -> "Cards":
        """The cards of the book that is being made."""
        cards: Cards = vars(app).setdefault("_coxeter_cards", cls(app))
        return cards

    def needed(self, page: str, body: str) -> dict[str, str]:
        """The cards for the links of a page, by their addresses as they are written there."""
        found = {}
        for address in links(body):
            target = self.target(page, html.unescape(address))
            if target is None or (page == LEDGER and target[0].startswith((LEDGER, CHECKS))):
                continue
            if said := self.card(*target, page):
                found[html.unescape(address)] = said
        return found

    def target(self, page: str, address: str) -> tuple[str, str] | None:
        """The page and the place to which an address leads; None if it is none of the book's pages."""
        parts = urlsplit(address)
        path = unquote(parts.path)
        if parts.scheme or parts.netloc or (path and not path.endswith(".html")):
            return None
        name = posixpath.normpath(posixpath.join(posixpath.dirname(page), path))[:-5] if path else page
        if name == page and not parts.fragment:
            return None
        return None if name in NOWHERE or name.startswith("_modules/") else (name, unquote(parts.fragment))

    def card(self, name: str, place: str, page: str) -> str | None:
        key = (name, place)
        if key not in self.made:
            try:
                self.made[key] = self.make(name, place)
            except (CoxeterError, LookupError) as error:
                if name == page:  # a place that is made later, or by the theme; `check_site` looks at these
                    return None
                log.warning("a link to %s.html#%s leads nowhere: %s", name, place, error, location=page)
                self.made[key] = None
        return self.made[key]

    def make(self, name: str, place: str) -> str | None:
        """A card; raises an error if there is no such place."""
        views = book_extension.views(self.app.env)
        if name == LEDGER and place.startswith("claim-"):
            return claim_card(views.ledger.by_id[place.removeprefix("claim-")])
        if name == ERRATA and place.startswith("erratum-"):
            return erratum_card({f"erratum-{e.number}": e for e in views.errata}[place])
        if name.startswith(CHECKS):
            return code_card(name.removeprefix(CHECKS), place)
        if name not in self.app.env.found_docs:
            raise LookupError("there is no such page")
        if place in self.citations:
            return brief("", self.citations[place])
        return self.place_card(name, place)

    @cached_property
    def citations(self) -> dict[str, str]:
        found = self.app.env.domaindata.get("cite", {}).get("citations", ())
        return {x.citation_id: html.escape(x.formatted_entry.text.render_as("text")) for x in found}

    # -- what stands in the pages ------------------------------------------------------------------------

    def places(self, name: str) -> dict[str, nodes.Element | None]:
        """All places of a page; of those within raw HTML no more is known than that they are there."""
        if name not in self.trees:
            tree = self.app.env.get_doctree(name)
            raw = (x.astext() for x in tree.findall(nodes.raw))
            found: dict[str, nodes.Element | None] = dict.fromkeys(
                id for text in raw for id in re.findall(r'\bid="([^"]+)"', text)
            )
            for node in tree.findall(nodes.Element):
                found |= dict.fromkeys(node.get("ids", ()), node)
            self.trees[name] = found
        return self.trees[name]

    def place_card(self, name: str, place: str) -> str | None:
        chapter = html.escape(self.app.env.titles[name].astext(), quote=False)
        if not place:
            top = next(self.app.env.get_doctree(name).findall(nodes.section), None)
            return brief(chapter, first_sentence(top) if top is not None else "")
        if place.startswith("module-"):
            return brief(place.removeprefix("module-"), "", chapter)
        node = self.places(name)[place]
        if node is None:
            return None
        if isinstance(node, nodes.section):
            return brief(inline(node[0]), first_sentence(node), chapter)
        if isinstance(node, addnodes.desc_signature | nodes.term):
            return definition(node)
        caption = next(node.findall(nodes.caption), None)
        return brief("", inline(caption if caption is not None else node), chapter)


def definition(node: nodes.Element) -> str:
    """An object of the library or a word of a glossary: its name, and the first sentence about it."""
    name = f"<code>{signature(node)}</code>" if isinstance(node, addnodes.desc_signature) else inline(node)
    about = next(iter(node.parent.findall(nodes.paragraph)), None)
    return brief(name, cut(about) if about is not None else "")


def signature(node: nodes.Element) -> str:
    """A signature as a line; Sphinx keeps names of types twice, for the case that they lead nowhere."""
    only = node.deepcopy()
    for other in [x for x in only.findall(addnodes.pending_xref_condition) if x["condition"] == "*"]:
        other.parent.remove(other)
    return html.escape(" ".join(only.astext().replace("[source]", "").split()), quote=False)


def code_card(module: str, function: str) -> str | None:
    """A function that decided something: its name, and the first line of what is said of it."""
    for node in ast.walk(ast.parse(code_of(module))):
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name == function:
            said = (ast.get_docstring(node) or "").partition("\n")[0]
            words = "" if "{" in said else to_html(said.rstrip(":"))
            return brief(f"<code>{module}.{function}</code>", words, "source code")
    return None


def first_sentence(section: nodes.Element) -> str:
    """The first sentence of a section, before any section in it."""
    for child in section.children:
        if isinstance(child, nodes.section):
            break
        if isinstance(child, nodes.paragraph):
            return cut(child)
    return ""


def cut(paragraph: nodes.Element) -> str:
    """The first sentence of a paragraph."""
    made = ""
    for child in paragraph.children:
        if isinstance(child, nodes.Text) and (end := SENTENCE.search(child)):
            return made + html.escape(str(child)[: end.end()], quote=False)
        made += inline(child)
    return made


def inline(node: nodes.Node) -> str:
    """A piece of text as HTML, without links; formulas as the page's script for formulas knows them."""
    if isinstance(node, nodes.Text):
        return html.escape(str(node), quote=False)
    if isinstance(node, nodes.math | nodes.math_block):
        return rf'<span class="{MATHS}">\({html.escape(node.astext(), quote=False)}\)</span>'
    if isinstance(node, (*SILENT, book_extension.badge)):
        return ""
    inner = "".join(map(inline, node.children))
    tag = {nodes.literal: "code", nodes.emphasis: "em", nodes.strong: "strong"}.get(type(node))
    return f"<{tag}>{inner}</{tag}>" if tag and inner else inner
