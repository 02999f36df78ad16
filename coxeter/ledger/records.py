"""What the claims made from the paper's data share: one for each printed formula, decimal, point, statement.

Formulas and points of the infinite families are judged for every d: by a proof of the closed form, and by the
normal form of both formulas. What a comparison finds beside it, such as where else the same value is
printed, is the evidence.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from typing import Any

from ..claims import Comparison, Outcome
from ..errors import InvalidInput
from ..names import MINIMAL_DIMENSION
from ..paper import printed
from .claim import Finding, corrected, damaged
from .vocabulary import EVERY_D, FINITE, Strength


def strength_for(family: str) -> Strength:
    """Infinite families are settled for every d, the others by one computation."""
    return EVERY_D if family in MINIMAL_DIMENSION or family == "regular" else FINITE


def family_words(family: str) -> str:
    """A family as the statements name it."""
    return "the regular simplex" if family == "regular" else f"{family[0]}~{family[1:] or '_d'}"


PLACES = {
    "Section 6, G~2": "sec6.G2.item-6",
    "Section 5, table of the regular simplex": "tab-regular",
    "Theorem 8": "thm-8",
    "Appendix C, Claim": "claim-c",
}


def place_id(place: str, family: str) -> str:
    """The beginning of the ids of a place.

    >>> place_id("Section 6, E~8, item 3", "E8"), place_id("Table 2", "A"), place_id("Section 6, G~2", "G2")
    ('sec6.E8.item-3', 'tab-2.A', 'sec6.G2.item-6')
    """
    if match := re.fullmatch(r"Section 6, (.)~(\d?), item (\d)", place):
        return f"sec6.{match[1]}{match[2]}.item-{match[3]}"
    if match := re.fullmatch(r"Table (\d)", place):
        return f"tab-{match[1]}.{family}"
    if match := re.fullmatch(r"Appendix ., (end of the )?(proof of )?(Lemma|Proposition) (\d+)", place):
        item = {"Lemma": "lem", "Proposition": "prop"}[match[3]] + f"-{match[4]}"
        return item + (".end" if match[1] else ".proof" if match[2] else "")
    return PLACES[place]


def formula_at(place: str, name: str = "value") -> dict[str, str]:
    """The constant of a sentence whose formula is recorded with those of the paper, not with its prose."""
    found = [f.text for f in printed().formulas if f.place == place]
    if len(found) != 1:
        raise InvalidInput(f"{len(found)} formulas are recorded for {place!r}: there must be one")
    return {name: found[0]}


def unique(ids: Iterable[str]) -> list[str]:
    """Number ids that occur more than once: x, x-2, x-3."""
    seen: Counter[str] = Counter()
    found = []
    for id in ids:
        seen[id] += 1
        found.append(id if seen[id] == 1 else f"{id}-{seen[id]}")
    return found


def without_end(text: str, strength: Strength) -> str:
    """A comparison tells up to which d it has looked; what is settled for every d has no such end.

    >>> without_end("holds for d = 4 … 24, fails for odd d = 3 … 23", EVERY_D)
    'holds for every d >= 4, fails for every odd d >= 3'
    """
    if strength is not EVERY_D:
        return text
    return re.sub(r"\b(odd |even |)d = (\d+) … \d\d\b", r"every \1d >= \2", text)


def faulty(strength: Strength, comparison: Comparison, correction: str, **more: Any) -> Finding:
    """What is printed is wrong, be it our copy's fault or the paper's; `more` are entries of the finding."""
    correction, evidence = (without_end(x, strength) for x in (correction, comparison.evidence))
    more = {name: without_end(x, strength) if isinstance(x, str) else x for name, x in more.items()}
    if comparison.outcome is Outcome.TRANSCRIPTION:
        return damaged(strength, correction, evidence, **more)
    return corrected(strength, correction, evidence=evidence, **more)
