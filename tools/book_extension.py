"""What the book needs of Sphinx beyond its settings: MathJax from the book itself.

One file that draws formulas as SVG needs no fonts, hence works offline and from file:// too. It
is taken from an installed package at build time.
"""

from importlib.util import find_spec
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

MATHJAX = "tex-svg-full.js"


def setup(app: Sphinx) -> dict[str, Any]:
    app.config.mathjax_path = MATHJAX
    app.set_html_assets_policy("always")  # every side bar has formulas, in the chapters' titles
    app.connect("builder-inited", add_mathjax)
    app.connect("html-collect-pages", forget_modules_without_source, priority=1)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def add_mathjax(app: Sphinx) -> None:
    package = find_spec("sphinx-mathjax-offline")
    if package is None or package.origin is None:
        raise RuntimeError("sphinx-mathjax-offline is not installed: run make setup")
    component = Path(package.origin).parent / "static" / "mathjax" / MATHJAX
    app.config.html_static_path.append(str(component))


def forget_modules_without_source(app: Sphinx) -> list[Any]:
    """Sphinx would link `builtins`, the home of a type alias, to a page that it never writes."""
    found = getattr(app.env, "_viewcode_modules", {})
    for name in [name for name, entry in found.items() if not entry]:
        del found[name]
    return []
