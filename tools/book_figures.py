"""The book's gallery: figures by name, with captions of their own and with files to take away.

``:::{drawing} figure-3`` shows a figure of `coxeter.figures.gallery`; what is written in it is the caption.
The files, SVG, PDF and PNG, are written at the end, next to the other downloads; they are kept from one build
to the next, as painting them takes a while.
"""

import hashlib
import html
import shutil
from functools import cache
from inspect import getsource
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

from coxeter.figures import Figure, canvas, files
from coxeter.figures.gallery import GALLERY

PAGE = "book/figures"
SUFFIXES = ("svg", "pdf", "png")

log = logging.getLogger(__name__)


def setup(app: Sphinx) -> dict[str, Any]:
    app.add_directive("drawing", DrawingDirective)
    app.connect("build-finished", write_figures)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


@cache
def drawing(name: str) -> Figure[Any]:
    return GALLERY[name].make()


class DrawingDirective(SphinxDirective):
    """A figure, its caption, links to its files, and how to make it."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        name = self.arguments[0]
        if name not in GALLERY:
            known = ", ".join(GALLERY)
            log.warning("there is no figure %r; there are %s", name, known, location=self.get_location())
            return []
        shown, below = drawing(name), links(name, "../" * self.env.docname.count("/"))
        return [
            nodes.raw("", shown._repr_html_(), format="html"),
            nodes.raw("", shown.alt, format="latex text man texinfo"),
            *self.parse_content_to_nodes(),
            nodes.raw("", below, format="html"),
        ]


def links(name: str, root: str) -> str:
    """A line of links to the files of a figure, and the Python that makes it."""
    title = html.escape(drawing(name).title, quote=True)
    each = " · ".join(
        f'<a href="{root}downloads/{name}.{suffix}" download aria-label="{suffix.upper()} of: {title}">'
        f"{suffix.upper()}</a>"
        for suffix in SUFFIXES
    )
    return (
        f'<p class="lg-links">Download: {each}. In Python: <code>{html.escape(GALLERY[name].code)}</code></p>'
    )


def write_figures(app: Sphinx, error: Exception | None) -> None:
    """Write the files of all figures of the gallery, if the book has it."""
    if error is not None or app.builder.format != "html" or PAGE not in app.env.found_docs:
        return
    folder, kept = Path(app.outdir) / "downloads", Path(app.outdir).parent / "figures"
    for path in (folder, kept):
        path.mkdir(parents=True, exist_ok=True)
    painter = getsource(files) + getsource(canvas)
    current = set()
    for name in GALLERY:
        figure = drawing(name)
        digest = hashlib.sha256((figure._repr_html_() + painter).encode()).hexdigest()[:16]
        for suffix in SUFFIXES:
            copy = kept / f"{name}-{digest}.{suffix}"
            if not copy.exists():
                figure.save(copy)
            shutil.copyfile(copy, folder / f"{name}.{suffix}")
            current.add(copy)
    for old in set(kept.iterdir()) - current:
        old.unlink()
