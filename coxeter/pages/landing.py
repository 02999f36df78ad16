"""What the first page shows: the three tilings of the plane, and how much was checked."""

from __future__ import annotations

from ..figures import tiling
from ..names import triangulations_up_to
from .headline import headline
from .judged import Ledger
from .naming import Site
from .wording import to_html


def tilings() -> str:
    """The Coxeter triangulations of the plane, in one row on every page, however narrow."""
    each = (
        f"<figure>{tiling(kind).svg}<figcaption>{to_html(kind.affine)}</figcaption></figure>"
        for kind in triangulations_up_to(2)
    )
    return f'<div class="cx-tilings">{"".join(each)}</div>'


def numbers(ledger: Ledger, site: Site) -> str:
    """Four numbers, each a link to the page that shows what it counts."""
    found = headline(ledger)
    tiles = (
        (found["checked"], "statements examined", "book/ledger.html"),
        (found["every-d"], "settled for every dimension", "book/trust.html"),
        (found["wrong"], "corrected: not true as printed", "book/errata.html"),
        (found["open"], "open", "book/ledger.html"),
    )
    each = (
        f'<li><a href="{site.root}{page}"><strong>{number}</strong> <span>{words}</span></a></li>'
        for number, words, page in tiles
    )
    return f'<ul class="cx-numbers">{"".join(each)}</ul>'
