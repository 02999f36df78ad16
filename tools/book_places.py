"""Where in the book a claim is treated: each row of the ledger leads to its chapter.

Chapters are read one by one, so each notes its boxes and badges; the links are written when all are known. Of
the places that speak of a claim a box counts more than a badge, and one with few claims more than one with
many.
"""

import re
from typing import Any

import book_extension
from book_cards import LEDGER
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment

CHAPTERS = "notebooks/"
ROW = re.compile(
    r'(<article class="lg-claim" id="claim-([^"]+)".*?<p class="lg-meta">.*?)(?=</p>)', re.DOTALL
)
Place = tuple[bool, int, str, str]


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("doctree-read", note_places)
    app.connect("env-purge-doc", lambda _, env, name: places(env).pop(name, None))
    app.connect("env-merge-info", lambda _, env, names, other: places(env).update(places(other)))
    app.connect("env-updated", lambda app, env: {LEDGER} & env.found_docs)
    app.connect("html-page-context", add_links, priority=800)  # after the cards: these links need none
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def places(env: BuildEnvironment) -> dict[str, dict[str, Place]]:
    """The best place of each claim in each chapter: is it a badge, of how many claims, page and section."""
    found: dict[str, dict[str, Place]] = vars(env).setdefault("claim_places", {})
    return found


def note_places(app: Sphinx, doctree: nodes.document) -> None:
    name = app.env.docname
    if not name.startswith(CHAPTERS):
        return
    found: dict[str, Place] = {}
    for node in doctree.findall(lambda node: isinstance(node, nodes.Element) and "claims" in node.attributes):
        claims = book_extension.views(app.env).ledger.find(node["claims"])
        section = _section(node)
        for x in claims:
            place = (isinstance(node, book_extension.badge), len(claims), name, section)
            found[x.id] = min(place, found.get(x.id, place), key=lambda place: place[:2])
    places(app.env)[name] = found


def _section(node: nodes.Node) -> str:
    while not isinstance(node, nodes.section):
        node = node.parent
    return str(node["ids"][0])


def add_links(app: Sphinx, pagename: str, template: str, context: dict[str, Any], *_: Any) -> None:
    if pagename != LEDGER:
        return
    best: dict[str, Place] = {}
    for found in places(app.env).values():
        for id, place in found.items():
            best[id] = min(place, best.get(id, place), key=lambda place: place[:2])

    def link(row: re.Match[str]) -> str:
        if row[2] not in best:
            return row[0]
        *_, name, section = best[row[2]]
        return (
            f'{row[1]} · <a href="../{name}.html#{section}" aria-label="{row[2]} in its chapter">chapter</a>'
        )

    context["body"] = ROW.sub(link, context["body"])
