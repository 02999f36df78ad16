"""The data of the quality explorer: what its script draws, and says of each point."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ..names import FAMILIES, MINIMAL_DIMENSION, Type
from ..quality import find_measure
from .misprints import Misprint
from .naming import Site, name_of
from .order_words import crossings, pairs_in_order
from .qualities import MAX_DIM, MEASURES, Quality, qualities, ranking, rate, readable, rounded, scaled, short
from .wording import BELOW

SINGLE = tuple(x for x in FAMILIES if x not in MINIMAL_DIMENSION)
"""The types that belong to no infinite family."""


def words(measure: str) -> str:
    """A normalised measure as it is called: fatness with its power.

    >>> words("fatness"), words("aspect_ratio")
    ('fatness to the power 1/d', 'aspect ratio')
    """
    known = find_measure(measure)
    return known.name.replace("_", " ") + (" to the power 1/d" if known.per_dimension else "")


def explorer_data(wrong: Iterable[Misprint], site: Site) -> dict[str, Any]:
    """Values as exact text and as decimals rounded once, limits, crossings, wrong printed values."""
    return {
        "max": MAX_DIM,
        "families": {
            letter: {"name": called(letter), "first": low} for letter, low in MINIMAL_DIMENSION.items()
        },
        "single": {family: {"name": called(family), "d": int(family[1:])} for family in SINGLE},
        "measures": {measure: _measure_data(measure) for measure in MEASURES},
        "printed": _printed_data(wrong, site),
    }


def called(family: str) -> str:
    """A family as readers know it, with the tilde above the letter."""
    return f"{family[0]}\N{COMBINING TILDE}{family[1:].translate(BELOW)}"


def _measure_data(measure: str) -> dict[str, Any]:
    pairs = pairs_in_order(measure)
    return {
        "name": find_measure(measure).name.replace("_", " "),
        "title": words(measure),
        "rank": {str(d): _ranked(measure, d) for d in range(2, MAX_DIM + 1)},
        "cross": [[pair, d] for pair in pairs for d in crossings(measure, pair)],
        "normalised": _scale_data(measure, False),
        "raw": _scale_data(measure, True),
    }


def _ranked(measure: str, d: int) -> str:
    return ">".join("=".join(kind.family for kind in equal) for equal in ranking(measure, d))


def _scale_data(measure: str, raw: bool) -> dict[str, Any]:
    """Values, and the limits of the curves, of a measure that is normalised or raw."""
    values: dict[str, list[list[str]]] = {}
    for (name, kind), quality in qualities().items():
        if name == measure:
            values.setdefault(kind.family, []).append(_entry(measure, kind, quality, raw))
    found = {letter: rate(letter, measure, raw) for letter in MINIMAL_DIMENSION}
    limits = {
        letter: [readable(str(growth.coefficient)), rounded(growth.coefficient), str(-growth.degree)]
        for letter, growth in found.items()
        if growth
    }
    return {"values": values, "limits": limits}


def _entry(measure: str, kind: Type, quality: Quality, raw: bool) -> list[str]:
    """Exact value, decimal, decimal times the power of d, and the exact value in full if it is long."""
    x = quality.raw if raw else quality.normalized
    growth = rate(kind.letter if kind.letter in MINIMAL_DIMENSION else "A", measure, raw)
    told, full = short(kind, measure, raw), readable(str(x))
    entry = [told, rounded(x), rounded(scaled(x, growth, kind.rank)) if growth else ""]
    return entry if told == full else [*entry, full]


def _printed_data(wrong: Iterable[Misprint], site: Site) -> list[list[Any]]:
    return [
        [x.measure, "raw" if x.raw else "normalised", x.family, x.d, readable(x.printed), rounded(x.value),
         name_of(x.claim).replace("~", "\N{COMBINING TILDE}"), site.claim(x.claim)]
        for x in wrong
    ]  # fmt: skip
