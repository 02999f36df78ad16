"""From what the book says to the code that decided it: pages of source, links in outputs, folds with names.

* Every module with a check, and every module of the proofs, has a page with a place for each function.
* In the output of a cell, the id of a claim leads to the ledger, the dotted name of a function to its source.
  In Jupyter, where there are no such pages, both are plain names.
* What ``explain(…)`` shows is folded under "How this is known" and what it is about.
"""

import ast
import html
import pkgutil
import re
from collections.abc import Iterator
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import book_extension
from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util import logging

import coxeter.proofs
from coxeter.errors import CoxeterError
from coxeter.pages.judged import Ledger
from coxeter.pages.listing import LAZY
from coxeter.pages.naming import titled
from coxeter.pages.wording import type_plain
from coxeter.tables.pieces import MATHS

EXPLAIN = re.compile(r"\bexplain\(([^()]*)\)")
DOTTED = re.compile(r"coxeter(?:\.\w+)+")
FOLD = re.compile(r'<details class="admonition hide .*?</details>', re.DOTALL)
UNNAMED = '<summary aria-label="Toggle hidden content">'
"""So the notebooks' extension writes it; the label would hide the words from a screen reader."""

log = logging.getLogger(__name__)


def setup(app: Sphinx) -> None:
    app.connect("doctree-read", name_folds)
    app.connect("doctree-resolved", link_outputs)
    app.connect("html-page-context", say_folds)
    app.connect("html-collect-pages", pages_of_code)


# -- pages of source ---------------------------------------------------------------------------------------


@lru_cache(maxsize=4)
def places(ledger: Ledger) -> dict[str, set[str]]:
    """The modules that have a page, and the functions in them to which something may lead."""
    found = {name: set(functions_of(name)) for name in modules_of_proofs()}
    for x in ledger:
        module, _, function = x.claim.code.rpartition(".")
        found.setdefault(module, set()).add(function)
    return found


def modules_of_proofs() -> list[str]:
    return [f"coxeter.proofs.{x.name}" for x in pkgutil.iter_modules(coxeter.proofs.__path__)]


def functions_of(module: str) -> Iterator[str]:
    """The functions and classes that stand at a module's outermost level."""
    tree = ast.parse(code_of(module))
    return (x.name for x in tree.body if isinstance(x, ast.FunctionDef | ast.ClassDef))


def code_of(module: str) -> str:
    spec = find_spec(module)
    assert spec is not None, module
    return Path(str(spec.origin)).read_text(encoding="utf-8")


def pages_of_code(app: Sphinx) -> Iterator[tuple[str, dict[str, Any], str]]:
    """The source of every check and every proof, a page for each module."""
    if app.builder.format != "html":
        return
    for module, names in sorted(places(book_extension.views(app.env).ledger).items()):
        body = f"<h1>Source of {html.escape(module)}</h1>{source(app, module, names)}"
        yield f"checks/{module}", {"title": module, "body": body}, "page.html"


def source(app: Sphinx, name: str, functions: set[str]) -> str:
    """A module's source, highlighted, with the functions marked."""
    code = code_of(name)
    lines = app.builder.highlighter.highlight_block(code, "python").split("\n")  # type: ignore[attr-defined]
    for function in sorted(functions):
        line = first_line(code, function)
        lines[line] = f'<span class="lg-target" id="{function}"></span>{lines[line]}'
    return "\n".join(lines)


def first_line(code: str, name: str) -> int:
    """Where a function begins, at any depth; if it is made in another way, where its name stands first."""
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name == name:
            return min([node.lineno, *(x.lineno for x in node.decorator_list)]) - 1
    found = re.search(rf"\b{re.escape(name)}\b", code)
    return code.count("\n", 0, found.start()) if found else 0


# -- links in outputs --------------------------------------------------------------------------------------


def link_outputs(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    if app.builder.format != "html":
        return
    outputs = [x for x in doctree.findall(nodes.container) if x.get("nb_element") == "cell_code_output"]
    names = [x for output in outputs for x in output.findall(nodes.literal)]
    for name in names if outputs else ():
        link = reference(name.astext(), book_extension.views(app.env).ledger, docname)
        if link is not None and not isinstance(name.parent, nodes.reference):
            name.replace_self(link)


def reference(name: str, ledger: Ledger, docname: str) -> nodes.reference | None:
    """A link from the name of a claim or of a function, if it is one.

    A function's page is there if its module has one; that it is not is a warning.
    """
    site = book_extension.site_from(docname)
    if name in ledger.by_id:
        return _link(name, site.claim(name))
    if not DOTTED.fullmatch(name):
        return None
    module, _, function = name.rpartition(".")
    function = function.partition(".")[0]
    if function not in places(ledger).get(module, ()):
        log.warning("an output names %s, which has no page", name, location=docname)
        return None
    return _link(function, f"{site.root}checks/{module}.html#{function}", told=name)


def _link(words: str, address: str, told: str = "") -> nodes.reference:
    link = nodes.reference("", "", nodes.literal(words, words), refuri=address, internal=True)
    if told:
        link["reftitle"] = told
    return link


# -- folds -------------------------------------------------------------------------------------------------


def name_folds(app: Sphinx, doctree: nodes.document) -> None:
    """Folded reasons are called what they are, and say what they are about."""
    for cell in doctree.findall(nodes.container):
        if cell.get("nb_element") != "cell_code" or not cell.get("hide_mode") or not cell.children:
            continue
        if found := EXPLAIN.search(cell.children[0].astext()):
            ids = re.findall(r"""["']([^"']+)["']""", found[1])
            cell["prompt_show"] = cell["prompt_hide"] = f"How this is known: {_about(app, ids)}"


def _about(app: Sphinx, ids: list[str]) -> str:
    """What some claims and items are called, and how many claims there are."""
    try:
        claims = book_extension.views(app.env).ledger.find(", ".join(ids))
    except CoxeterError as error:
        log.warning("%s", error, location=app.env.docname)
        return ", ".join(ids)
    return f"{type_plain(titled(ids))} ({len(claims)} claim{'s' if len(claims) > 1 else ''})"


def say_folds(app: Sphinx, pagename: str, template: str, context: dict[str, Any], *_: Any) -> None:
    """The words of a fold are heard, and its formulas are set when it is opened."""
    if UNNAMED in context.get("body", ""):
        body = context["body"].replace(UNNAMED, "<summary>")
        context["body"] = FOLD.sub(lambda fold: fold[0].replace(f'class="{MATHS}"', f'class="{LAZY}"'), body)
