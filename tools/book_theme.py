"""What the book mends of its theme.

* The theme brings each icon twice: as a font, and in a script of half a megabyte that nothing here needs.
* A point or a comma after a formula or a badge stays on its line.
* Formulas are set by a script only on pages that have some, and only when they are about to be seen.
  MathJax's menu, which makes each formula a stop of the Tab key, is left away.
* A search shows lines of the pages it finds; from the file system, where a browser may not read these, only
  their titles.
"""

import re
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

MARKS = ('class="lg-', 'class="math ')
"""Where formulas may be in HTML that is made by views, not by Sphinx, and in the cards of its links."""

LOCAL = 'if (location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;'

ENDED = re.compile(r'(<span class="math [^>]*>[^<]*</span>|<a class="lg-pill (?:(?!</a>).)*</a>)([.,;:!?)]+)')
"""A formula or a badge, and the signs after it."""


def setup(app: Sphinx) -> dict[str, Any]:
    app.config.mathjax3_config = {"options": {"enableMenu": False}, "startup": {"typeset": False}}
    app.connect("doctree-resolved", note_formulas)
    app.connect("html-page-context", keep_signs)
    app.connect("html-page-context", search_titles)
    app.connect("build-finished", leave_icons_to_the_font)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def note_formulas(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Sphinx loads MathJax for pages with formulas of its own; tell it of those in raw HTML."""
    known = app.env.get_domain("math").data["has_equations"]
    if not known.get(docname):
        known[docname] = any(mark in raw.astext() for raw in doctree.findall(nodes.raw) for mark in MARKS)


def keep_signs(app: Sphinx, pagename: str, template: str, context: dict[str, Any], *_: Any) -> None:
    """No sign alone on a line. Formulas are set by `formulas.js`; one that scrolls shows it: `wide.js`."""
    if app.env.get_domain("math").has_equations(pagename):
        app.add_js_file("formulas.js", loading_method="defer")
    if 'class="math ' in (body := context.get("body", "")):
        context["body"] = ENDED.sub(r'<span class="cx-together">\1\2</span>', body)
        app.add_js_file("wide.js", loading_method="defer")


def search_titles(app: Sphinx, pagename: str, *_: Any) -> None:
    if pagename == "search":
        app.add_js_file(None, body=LOCAL)


def leave_icons_to_the_font(app: Sphinx, error: Exception | None) -> None:
    script = Path(app.outdir) / "_static" / "scripts" / "fontawesome.js"
    if error is None and script.is_file():
        script.write_text("/* The style sheet has all icons. */\n", encoding="utf-8")
