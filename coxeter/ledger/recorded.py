"""The recorded ledger: what came of every claim when it was last looked at by a person.

It lies in ``recorded.json``, one record to a line, in the order of the paper; ``tools/record_ledger.py``
writes it. A run is held against it, so that a verdict that changes, for whatever reason, is noticed.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields
from functools import lru_cache
from pathlib import Path

from ..paper.loading import damaged, read
from .claim import Claim, Finding
from .rooms import ROOMS
from .vocabulary import Extent, Verdict, Weight

FILE = Path(__file__).with_name("recorded.json")


@dataclass(frozen=True)
class Record:
    """What is expected of a claim.

    Attributes
    ----------
    room
        The module among `coxeter.ledger.rooms.ROOMS` that has to be imported to find the claim.
    verdict, strength, weight, correction
        In words. A correction says what is printed and what is true, so that a change of either shows.
    about
        A digest of the statement and of its printed constants: the verdict is on these and no others.
    """

    id: str
    room: str
    verdict: str
    strength: str
    weight: str
    correction: str
    about: str = ""
    line: int = 0

    def __str__(self) -> str:
        return f"{self.verdict} · {self.strength} · {self.weight}"


COMPARED = ("verdict", "strength", "weight", "correction", "about")


def record(claim: Claim, finding: Finding, room: str = "") -> Record:
    """What a finding is recorded as."""
    verdict, strength = finding.verdict.value, str(finding.strength)
    return Record(claim.id, room, verdict, strength, claim.weight.value, finding.correction, about(claim))


def about(claim: Claim) -> str:
    """A digest of what a claim says: its statement, and all constants that are printed in it."""
    text = f"{claim.statement} {sorted(claim.printed.items())}"
    return hashlib.sha256(text.encode()).hexdigest()[:12]


def differences(expected: Record, found: Record) -> tuple[str, ...]:
    """In what two records differ, a sentence each.

    >>> old = Record("def-0", "section_1", "holds", "every d", "wording", "")
    >>> differences(old, Record("def-0", "section_1", "fails", "every d", "wording", ""))
    ("verdict: expected 'holds', came out 'fails'",)
    """
    return tuple(
        f"{name}: expected {getattr(expected, name)!r}, came out {getattr(found, name)!r}"
        for name in COMPARED
        if getattr(expected, name) != getattr(found, name)
    )


def recorded(file: Path | None = None) -> Mapping[str, Record]:
    """The recorded ledger by the claims' ids.

    Raises
    ------
    DamagedData
        If the file is missing or damaged; the message names it and the line.
    """
    return _load(file or FILE)


@lru_cache(maxsize=1)
def _load(file: Path) -> Mapping[str, Record]:
    records: dict[str, Record] = {}
    known = {
        "room": list(ROOMS),
        "verdict": [x.value for x in Verdict],
        "strength": [x.value for x in Extent],
        "weight": [x.value for x in Weight],
    }
    for new in read(file, Record):
        if new.id in records:
            what = f"a second record {new.id!r}, beside that in line {records[new.id].line}"
            raise damaged(file, new.line, what)
        for name, values in known.items():
            value: str = getattr(new, name)
            if (re.sub(r"\d+", "N", value) if name == "strength" else value) not in values:
                raise damaged(file, new.line, f"{value!r} is no {name}")
        records[new.id] = new
    return records


def write(records: Iterable[Record], file: Path | None = None) -> None:
    """Record them: one to a line."""
    names = [field.name for field in fields(Record) if field.name != "line"]
    lines = [json.dumps({name: getattr(x, name) for name in names}, ensure_ascii=False) for x in records]
    lines[:-1] = [f"{line}," for line in lines[:-1]]
    (file or FILE).write_text("\n".join(["[", *lines, "]", ""]), encoding="utf-8")
    _load.cache_clear()
