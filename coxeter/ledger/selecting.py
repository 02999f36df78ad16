"""Choosing claims: by id or the beginning of one, by section, by family."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from importlib import import_module

from ..errors import InvalidInput
from ..names import FAMILIES, MINIMAL_DIMENSION
from .claim import CLAIMS, Claim
from .inventory import FIGURES, PLACES, PROPOSITIONS, belongs
from .recorded import Record, recorded
from .rooms import all_claims, find_claim

SECTIONS = ("1", "2", "3", "4", "5", "6", "A", "B", "C", "D")


def select(
    ids: Sequence[str] = (), section: str | None = None, family: str | None = None
) -> dict[str, Claim]:
    """The claims with all of what is asked for, in the order of the paper.

    Parameters
    ----------
    ids
        Ids, or items: ``thm-8`` stands for itself and everything that begins with ``thm-8.``. Default: all.
    section
        ``1`` to ``6``, or the letter of an appendix.
    family
        ``A``, …, ``G``, or one type, such as ``E6``.

    Raises
    ------
    InvalidInput
        If there is no such claim, section or family, or no claim has all that is asked for.

    >>> "def-8" in select(["def-8"])
    True
    """
    sections, families = _section(section), _family(family)
    claims = {
        id: claim
        for id, claim in _load(ids).items()
        if _asked(id, ids)
        and (not sections or section_of(claim) in sections)
        and (not families or families_of(claim) & families)
    }
    if not claims and (sections or families):
        raise InvalidInput("no claim has all that is asked for: leave out an id, --section or --family")
    return claims


def expected(
    ids: Sequence[str], claims: Iterable[str], section: str | None = None, family: str | None = None
) -> dict[str, Record]:
    """What is recorded of the claims that were selected, and of what was asked for that has no claim.

    A record does not say to which section and family it belongs: then only claims are looked at.
    """
    chosen, narrowed = set(claims), section is not None or family is not None
    return {
        id: record
        for id, record in recorded().items()
        if id in chosen or (not narrowed and _asked(id, ids) and id not in CLAIMS)
    }


def _asked(id: str, ids: Iterable[str]) -> bool:
    return not ids or any(belongs(id, item) for item in ids)


def _load(ids: Sequence[str]) -> Mapping[str, Claim]:
    """Claims among which all those asked for are; where the record says in which rooms, only those."""
    rooms = {x.room for x in recorded().values() if ids and _asked(x.id, ids)}
    for room in sorted(rooms):
        import_module(f"{__package__}.{room}")
    if ids and all(any(belongs(id, item) for id in CLAIMS) for item in ids):
        return CLAIMS
    claims = all_claims()
    for item in ids:
        if not any(belongs(id, item) for id in (*claims, *recorded())):
            find_claim(item)  # says what there is instead
    return claims


def section_of(claim: Claim) -> str:
    """The section or appendix in which a claim stands: by its place, its check's module or its item."""
    for text in (claim.place, claim.code):
        if match := re.search(r"(?:section|appendix)[ _]([1-6A-D])\b", text.replace("_", " "), re.IGNORECASE):
            return match[1].upper()
    return next((section for item, section in PLACES.items() if belongs(claim.id, item)), "")


def families_of(claim: Claim) -> frozenset[str]:
    """The families of which a claim speaks, by its id and its place.

    A letter that stands for several types, as in ``tab-6.E``, means all of them.
    """
    words = [claim.id]
    words += [PROPOSITIONS[name] for name in PROPOSITIONS if belongs(claim.id, name)]
    words += [f"of.{family}" for name, family in FIGURES.items() if belongs(claim.id, name)]
    found = [match for word in words for match in re.findall(r"\.([A-G])\.?(\d?)(?=\.|$|~)", word)]
    place = unicodedata.normalize("NFD", claim.place).replace("\N{COMBINING TILDE}", "~")
    found += re.findall(r"\b([A-G])~_?\{?(\d?)", place)
    return frozenset(name for letter, digit in found for name in _types(letter, digit))


def _types(letter: str, digit: str) -> list[str]:
    if letter in MINIMAL_DIMENSION:
        return [letter]
    types = [name for name in FAMILIES if name[0] == letter]
    return [name for name in types if name[1:] == digit] or types


def _section(asked: str | None) -> tuple[str, ...]:
    if asked is None:
        return ()
    if asked.upper() not in SECTIONS:
        raise InvalidInput(f"there is no section {asked!r}: give 1 to 6, or A to D for an appendix")
    return (asked.upper(),)


def _family(asked: str | None) -> frozenset[str]:
    if asked is None:
        return frozenset()
    found = [name for name in FAMILIES if asked.upper().replace("~", "") in (name, name[0])]
    if not found:
        raise InvalidInput(
            f"there is no family {asked!r}: give one of A to G, or one of {', '.join(FAMILIES)}"
        )
    return frozenset(found)
