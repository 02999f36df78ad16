"""What the book mends of its theme.

* The theme brings each icon twice: as a font, and in a script of half a megabyte that nothing here needs.
* Formulas are set by a script only on pages that have some; MathJax's menu, which makes each formula a stop
  of the Tab key, is left away.
"""

from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx

MARKS = ('class="lg-', 'class="math ')
"""Where formulas may be in HTML that is made by views, not by Sphinx, and in the cards of its links."""


def setup(app: Sphinx) -> dict[str, Any]:
    app.config.mathjax3_config = {"options": {"enableMenu": False}}
    app.connect("doctree-resolved", note_formulas)
    app.connect("build-finished", leave_icons_to_the_font)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def note_formulas(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Sphinx loads MathJax for pages with formulas of its own; tell it of those in raw HTML."""
    known = app.env.get_domain("math").data["has_equations"]
    if not known.get(docname):
        known[docname] = any(mark in raw.astext() for raw in doctree.findall(nodes.raw) for mark in MARKS)


def leave_icons_to_the_font(app: Sphinx, error: Exception | None) -> None:
    script = Path(app.outdir) / "_static" / "scripts" / "fontawesome.js"
    if error is None and script.is_file():
        script.write_text("/* The style sheet has all icons. */\n", encoding="utf-8")
