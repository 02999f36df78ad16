"""Where a printed value of a measure is not the true one: type by type, dimension by dimension."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import NamedTuple

from ..exact import Surd
from ..families import closed_form, evaluate
from ..ledger.vocabulary import Verdict
from ..names import MINIMAL_DIMENSION
from ..quality import PAPER_MEASURES
from .judged import Judged

TABLES = {"3": "aspect_ratio", "4": "radius_ratio", "5": "fatness", "6": "thickness"}
_NAMES = "|".join(known.name.replace("_", "-") for known in PAPER_MEASURES)
_CELL = re.compile(r"tab-([3-6])\.([A-G])\.(\d)")
_FORMULA = re.compile(
    rf"(?P<place>tab-2|sec6)\.(?P<family>[A-G]\d?)\.(item-[67]\.)?(?P<measure>{_NAMES})"
    r"(-(?P<parity>odd|even))?(-decimal)?"
)


class Misprint(NamedTuple):
    """A printed value that is not the true one, and the claim about it.

    Attributes
    ----------
    family
        One of the nine, as ``B`` or ``E6``.
    raw
        Whether the value is not divided by that of the regular simplex.
    printed, value
        What is printed, and what it is worth in this dimension.
    """

    measure: str
    raw: bool
    family: str
    d: int
    printed: str
    value: Surd
    claim: str


def misprints(ledger: Iterable[Judged], max_dim: int) -> tuple[Misprint, ...]:
    """All of them up to a dimension; what only our copy of the paper has lost or moved is none."""
    return tuple(
        found
        for x in ledger
        if not x.verdict.accepts and x.verdict is not Verdict.TRANSCRIPTION
        for found in _of(x, max_dim)
        if found.d <= max_dim
    )


def _of(x: Judged, max_dim: int) -> Iterator[Misprint]:
    if not x.claim.printed:
        return
    if match := _CELL.fullmatch(x.id):
        table, letter, d = match.groups()
        family = letter if letter in MINIMAL_DIMENSION else letter + d
        text = str(x.claim.printed["decimal"])
        yield Misprint(TABLES[table], False, family, int(d), text, Surd(Fraction(text)), x.id)
    elif match := _FORMULA.fullmatch(x.id):
        measure, raw = match["measure"].replace("-", "_"), match["place"] == "sec6"
        form = closed_form(match["family"], measure if raw else f"normalized_{measure}")
        for d in _dimensions(match["family"], match["parity"], max_dim):
            text, value = _printed(x, d)
            if value != form.at(d):
                yield Misprint(measure, raw, match["family"], d, text, value, x.id)


def _printed(x: Judged, d: int) -> tuple[str, Surd]:
    """What is printed, a formula or a decimal, and its value."""
    if "decimal" in x.claim.printed:
        text = str(x.claim.printed["decimal"])
        return text, Surd(Fraction(text))
    text = str(x.claim.printed["formula"])
    return text, evaluate(text, d=d)


def _dimensions(family: str, parity: str | None, max_dim: int) -> Iterator[int]:
    if family not in MINIMAL_DIMENSION:
        yield int(family[1:])
        return
    for d in range(MINIMAL_DIMENSION[family], max_dim + 1):
        if parity in (None, "odd" if d % 2 else "even"):
            yield d
