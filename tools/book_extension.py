"""What the book needs of Sphinx beyond its settings: formulas offline, and the views of the ledger.

* MathJax comes from the book itself. One file that draws formulas as SVG needs no fonts, hence works offline
  and from file:// too. It is taken from an installed package at build time.
* Roles: ``{badge}`thm-8.delaunay` `` is the verdict on a claim, on several, or on all of an item;
  ``{ledger}`checked` `` is a number.
* Directives: ``{verdict}`` is a box with a verdict and what to use instead; ``{view}`` is any other view.
* The files beside the pages are written at the end.

Titles, source, cards, places, figures and what is mended of the theme have extensions of their own:
`book_titles`, `book_code`, `book_cards`, `book_places`, `book_figures`, `book_theme`.

An unknown claim, number or view is a warning, and a warning fails the build.
"""

import re
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective, SphinxRole

from coxeter.errors import CoxeterError, InvalidInput
from coxeter.pages import headline, judge_all
from coxeter.pages.judged import gravest, sources_key
from coxeter.pages.naming import Site
from coxeter.pages.pills import box, pill, words
from coxeter.pages.views import Views

MATHJAX = "tex-svg-full.js"
PLOTLY = "plotly.min.js"
ASSETS = {
    "lg-controls": ("ledger.js",),
    "lg-errata": ("ledger.js",),
    "lg-graph": ("graph.js",),
    "lg-notes": ("ledger.js",),
    "cx-tilings": ("landing.css",),
    "<table": ("tables.js",),
    "cx-scene": (PLOTLY, "space.js", "space.css"),
    "cx-explorer": (PLOTLY, "explorer.js", "explorer.css"),
    "cx-chooser": ("choosing.js", "explorer.css"),
}
"""Classes of elements, or elements, and the scripts and styles of the pages that have them."""

log = logging.getLogger(__name__)


def setup(app: Sphinx) -> dict[str, Any]:
    app.config.mathjax_path = MATHJAX
    app.add_css_file("ledger.css")
    app.add_role("badge", BadgeRole())
    app.add_role("ledger", NumberRole())
    app.add_directive("verdict", VerdictDirective)
    app.add_directive("view", ViewDirective)
    app.add_node(
        badge,
        html=(show_badge, None),
        latex=(write_badge, None),
        text=(add_badge, None),
        man=(write_badge, None),
        texinfo=(write_badge, None),
    )
    app.connect("builder-inited", add_mathjax)
    app.connect("builder-inited", add_plotly)
    app.connect("env-get-outdated", pages_of_old_ledgers)
    app.connect("html-page-context", add_assets)
    app.connect("html-page-context", mend_back_links)
    app.connect("html-collect-pages", forget_modules_without_source, priority=1)
    app.connect("build-finished", write_files)
    for part in ("book_titles", "book_code", "book_cards", "book_places", "book_figures", "book_theme"):
        app.setup_extension(part)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def add_mathjax(app: Sphinx) -> None:
    package = find_spec("sphinx-mathjax-offline")
    if package is None or package.origin is None:
        raise RuntimeError("sphinx-mathjax-offline is not installed: run make setup")
    component = Path(package.origin).parent / "static" / "mathjax" / MATHJAX
    app.config.html_static_path.append(str(component))


def add_plotly(app: Sphinx) -> None:
    """One copy for all pages, out of the installed package."""
    package = find_spec("plotly")
    if package is None or package.origin is None:
        raise RuntimeError("plotly is not installed: run make setup")
    app.config.html_static_path.append(str(Path(package.origin).parent / "package_data" / PLOTLY))


def forget_modules_without_source(app: Sphinx) -> list[Any]:
    """Sphinx would link `builtins`, the home of a type alias, to a page that it never writes."""
    found = getattr(app.env, "_viewcode_modules", {})
    for name in [name for name, entry in found.items() if not entry]:
        del found[name]
    return []


def mend_back_links(app: Sphinx, pagename: str, _: str, context: dict[str, Any], *__: Any) -> None:
    """Sphinx knows but one name of a module whose members are documented under two, its own and another."""
    if not pagename.startswith("_modules/"):
        return
    module = pagename.removeprefix("_modules/").replace("/", ".")
    known = app.env.get_domain("py").data["objects"]

    def mend(match: re.Match[str]) -> str:
        own, target = f"{module}.{match['name']}", known.get(match["target"])
        wrong = target is None or target.objtype == "module"
        return f"{match['before']}#{own}" if wrong and own in known else match[0]

    block = r'(?P<before>id="(?P<name>[^"]+)">\s*<a class="viewcode-back" href="[^"#]*)#(?P<target>[^"]*)'
    context["body"] = re.sub(block, mend, context.get("body", ""))


# -- the ledger -------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def views_in(folder: Path) -> Views:
    """The views of the ledger whose results are kept in a folder."""
    return Views(judge_all(folder))


def views(env: BuildEnvironment) -> Views:
    return views_in(Path(env.app.outdir).parent / "ledger")


def site_from(docname: str) -> Site:
    return Site("../" * docname.count("/"))


def pages_of_old_ledgers(app: Sphinx, env: BuildEnvironment, *_: Any) -> list[str]:
    """All pages, if they were made when the library was another."""
    key = sources_key(left_out=())
    before = vars(env).get("ledger_key")
    vars(env)["ledger_key"] = key  # kept with the environment from one build to the next
    return [] if before in (None, key) else sorted(env.found_docs)


class badge(nodes.Inline, nodes.Element):
    """A verdict on claims in a line of text."""


class BadgeRole(SphinxRole):
    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        try:
            views(self.env).ledger.find(self.text)
        except CoxeterError as error:
            log.warning("%s", error, location=self.get_location())
            return [nodes.literal(self.rawtext, self.text)], []
        return [badge(self.rawtext, ids=[], claims=self.text)], []


def show_badge(translator: Any, node: badge) -> None:
    """As a pill; a table of contents, whose entries are links, goes without."""
    if not isinstance(node.parent, nodes.reference):
        builder = translator.builder
        site = site_from(getattr(builder, "current_docname", ""))
        translator.body.append(pill(views(builder.env).ledger.find(node["claims"]), site))
    raise nodes.SkipNode


def in_words(translator: Any, node: badge) -> str:
    return f"[{words(gravest(views(translator.builder.env).ledger.find(node['claims'])))}]"


def write_badge(translator: Any, node: badge) -> None:
    translator.body.append(in_words(translator, node))
    raise nodes.SkipNode


def add_badge(translator: Any, node: badge) -> None:
    translator.add_text(in_words(translator, node))
    raise nodes.SkipNode


class NumberRole(SphinxRole):
    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        try:
            numbers = headline(views(self.env).ledger)
            if self.text not in numbers:
                known = ", ".join(numbers)
                raise InvalidInput(f"there is no number {self.text!r} of the ledger; there are {known}")
        except CoxeterError as error:
            log.warning("%s", error, location=self.get_location())
            return [nodes.literal(self.rawtext, self.text)], []
        return [nodes.Text(str(numbers[self.text]))], []


class VerdictDirective(SphinxDirective):
    """A box: ``:::{verdict} thm-8``. What is written in it stands between the verdict and the reasons."""

    required_arguments = 1
    final_argument_whitespace = True
    has_content = True

    def run(self) -> list[nodes.Node]:
        try:
            claims = views(self.env).ledger.find(self.arguments[0])
        except CoxeterError as error:
            log.warning("%s", error, location=self.get_location())
            return []
        said = self.parse_content_to_nodes() if self.content else []
        before, after = box(claims, site_from(self.env.docname))
        opening = in_both(before, words(gravest(claims)))
        opening[0]["claims"] = self.arguments[0]  # for `book_places`
        return [*opening, *said, nodes.raw("", after, format="html")]


class ViewDirective(SphinxDirective):
    """Any other view: ``:::{view} errata proofs``."""

    required_arguments = 1
    final_argument_whitespace = True
    has_content = True

    def run(self) -> list[nodes.Node]:
        name = " ".join(self.arguments[0].split())
        try:
            made = views(self.env).view(name, list(self.content), site_from(self.env.docname))
        except CoxeterError as error:
            log.warning("%s", error, location=self.get_location())
            return []
        return [*in_both(made, f"This is shown in the book's pages: {name}.")]


def in_both(made: str, otherwise: str) -> list[nodes.raw]:
    """HTML, and words for all other formats."""
    return [nodes.raw("", made, format="html"), nodes.raw("", otherwise, format="latex text man texinfo")]


# -- pages and files beside the chapters --------------------------------------------------------------------


def add_assets(app: Sphinx, pagename: str, template: str, context: dict[str, Any], *_: Any) -> None:
    body = context.get("body", "")
    for name in dict.fromkeys(file for mark, files in ASSETS.items() if mark in body for file in files):
        if name.endswith(".css"):
            app.add_css_file(name)
        else:
            app.add_js_file(name, loading_method="defer")


def write_files(app: Sphinx, error: Exception | None) -> None:
    if error is None and app.builder.format == "html":
        folder = Path(app.outdir) / "downloads"
        folder.mkdir(exist_ok=True)
        for name, text in views(app.env).files.items():
            (folder / name).write_text(text, encoding="utf-8")
