"""The quality explorer: a figure that a script brings to life, and that says everything without it.

Its parts: the controls, hidden until the script runs; curves drawn beforehand; the values in one dimension;
sentences on the order of the families and on wrong printed values, of which the script shows those that fit;
the numbers as tables; and the data.
"""

from __future__ import annotations

import html
import json
from collections.abc import Iterable, Iterator

from ..figures import quality_curves
from ..names import MINIMAL_DIMENSION, Type
from .corrections import printed, truth
from .explorer_data import SINGLE, called, explorer_data, words
from .judged import Ledger
from .markup import downloads, folded, link, row, table
from .misprints import Misprint, misprints
from .naming import Site
from .order_words import EXCEPTIONAL_DIMENSIONS, in_dimension, pairs_in_order, sentence
from .pills import mark, named
from .qualities import MAX_DIM, MEASURES, qualities, rounded
from .wording import to_html

DRAWN = 24
"""The curves that are drawn beforehand go to this dimension."""


def explorer(ledger: Ledger, site: Site) -> str:
    """The figure."""
    wrong = misprints(ledger, MAX_DIM)
    data = json.dumps(explorer_data(wrong, site), ensure_ascii=False, separators=(",", ":"))
    safe = data.replace("</", r"<\/")  # the end of a tag would end the script
    return (
        '<figure class="cx-explorer" aria-label="Quality explorer">'
        f'{_controls()}<output class="cx-summary"></output>{_plot()}{_reader()}{_drawings()}'
        f"{_orders()}{_misprints(wrong, ledger, site)}{_tables()}"
        f"{downloads({'all values, exact (CSV)': site.download('qualities.csv')})}"
        f'<script type="application/json" class="cx-data">{safe}</script></figure>'
    )


# -- parts ---------------------------------------------------------------------------------------------------


def _controls() -> str:
    options = "".join(f'<option value="{name}">{name.replace("_", " ")}</option>' for name in MEASURES)
    families = "".join(
        _box("family", letter, _swatch(letter) + called(letter)) for letter in MINIMAL_DIMENSION
    )
    toggles = {
        "limits": "limit curves",
        "printed": "wrong printed values",
        "scaled": '<span class="cx-scale-words">times √d</span>',
        "log": "logarithmic axes",
        "raw": "not normalised",
    }
    boxes = "".join(_box(name, "1", told) for name, told in toggles.items())
    return (
        '<form class="cx-controls" hidden>'
        f'<label class="cx-field">Measure <select name="measure">{options}</select></label>'
        '<label class="cx-field">Dimensions 2 to <output name="top"></output>'
        f'<input type="range" name="max" min="3" max="{MAX_DIM}" step="1"></label>'
        f"<fieldset><legend>Families</legend>{families}"
        f"{_box('family', 'X', _swatch('X') + ', '.join(map(called, SINGLE)))}</fieldset>"
        f"<fieldset><legend>Show</legend>{boxes}</fieldset></form>"
    )


def _box(name: str, value: str, told: str) -> str:
    return f'<label class="cx-box"><input type="checkbox" name="{name}" value="{value}"> {told}</label>'


def _swatch(family: str) -> str:
    return f'<i class="cx-swatch cx-{family}" aria-hidden="true"></i>'


def _plot() -> str:
    return '<div class="cx-plot" hidden></div>'


def _reader() -> str:
    """The values in one dimension, which a slider chooses."""
    return (
        '<div class="cx-reader" hidden><label class="cx-field">Values in dimension '
        f'<output name="at"></output><input type="range" name="d" min="2" max="{MAX_DIM}" step="1"></label>'
        '<div class="cx-values" tabindex="0" role="region" aria-label="Values in one dimension"></div></div>'
    )


def _drawings() -> str:
    drawn = "".join(f"<div>{quality_curves(measure, DRAWN).svg}</div>" for measure in MEASURES)
    return f'<div class="cx-drawings">{drawn}</div>'


def _orders() -> str:
    parts = "".join(_order(measure) for measure in MEASURES)
    preface = (
        '<p class="lg-quiet">By the greater value, in all dimensions in which both exist. Normalised or not, '
        "the order is the same.</p>"
    )
    return f'<section class="cx-orders"><h2>Which is ahead</h2>{preface}{parts}</section>'


def _order(measure: str) -> str:
    pairs = "".join(
        f'<li data-families="{pair}">{to_html(sentence(measure, pair))}</li>'
        for pair in pairs_in_order(measure)
    )
    single = "".join(
        f'<li data-families="X">{to_html(in_dimension(measure, d))}</li>' for d in EXCEPTIONAL_DIMENSIONS
    )
    return (
        f'<div data-measure="{measure}"><h3>By {words(measure)}</h3><ul>{pairs}</ul>'
        f'<ul class="cx-single">{single}</ul></div>'
    )


def _misprints(wrong: Iterable[Misprint], ledger: Ledger, site: Site) -> str:
    """A line for each claim about a value that is printed wrong."""
    by_claim: dict[str, Misprint] = {}
    for x in wrong:
        by_claim.setdefault(x.claim, x)
    rows = "".join(_misprint(x, ledger, site) for x in by_claim.values())
    return (
        '<section class="cx-wrong"><h2>What is printed otherwise</h2>'
        '<p class="lg-quiet cx-none" hidden>Nothing of what is shown is printed wrong.</p>'
        f"<ul>{rows}</ul></section>"
    )


def _misprint(x: Misprint, ledger: Ledger, site: Site) -> str:
    judged = ledger[x.claim]
    family = x.family if x.family in MINIMAL_DIMENSION else "X"
    told = f"{to_html(printed(judged))} True: {to_html(truth(judged))}."
    return (
        f'<li data-measure="{x.measure}" data-scale="{"raw" if x.raw else "normalised"}" '
        f'data-families="{family}">{link(site.claim(x.claim), named(x.claim))}: {told} {mark(judged)}</li>'
    )


def _tables() -> str:
    parts = "".join(_numbers(measure, raw) for raw in (False, True) for measure in MEASURES)
    return f'<div class="cx-tables">{parts}</div>'


def _numbers(measure: str, raw: bool) -> str:
    if raw:
        name = f"Numbers: {measure.replace('_', ' ')}, not normalised"
        return folded(name, _table(measure, raw), '"cx-numbers cx-raw"')
    return folded(f"Numbers: {words(measure)}, normalised", _table(measure, raw), "cx-numbers")


def _table(measure: str, raw: bool) -> str:
    rows = "".join(row(str(d), _cells(measure, raw, d)) for d in range(2, MAX_DIM + 1))
    head = ("d", *(f'<span class="lg-type">{called(x)}</span>' for x in MINIMAL_DIMENSION), "others")
    label = f"{'Raw' if raw else 'Normalised'} {measure.replace('_', ' ')}"
    return table("lg-sheet", head, f"<tbody>{rows}</tbody>", label)


def _cells(measure: str, raw: bool, d: int) -> Iterator[str]:
    def value(kind: Type) -> str:
        quality = qualities()[measure, kind]
        return rounded(quality.raw if raw else quality.normalized)

    for letter, low in MINIMAL_DIMENSION.items():
        yield value(Type(letter, d)) if d >= low else "–"
    single = (Type(family[0], d) for family in SINGLE if int(family[1:]) == d)
    yield html.escape("; ".join(f"{kind.unicode} {value(kind)}" for kind in single))
