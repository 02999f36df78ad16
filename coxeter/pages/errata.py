"""The errata: claims that are not right as printed, those with one cause together."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from types import MappingProxyType

from ..ledger.selecting import families_of
from ..ledger.vocabulary import Verdict, Weight
from .corrections import printed, truth
from .judged import Judged, Ledger, gravest

GROUPS = MappingProxyType({
    "results": "Results people use",
    "proofs": "Proofs",
    "wording": "Wording",
    "copy": "Damage of our copy",
})  # fmt: skip
"""The kinds of errata by the names under which a page asks for them."""

POINTING = re.compile(
    r"has the same value|prints its rounding|computes the \w+ with it|as well: one wrong value|uses it"
)
"""Words with which evidence says that another place has the same error."""

CAUSE = re.compile(r"it is (?:what .* would give|.* times the exact point)")
TELLING = 30
"""Texts of at least so many letters do not agree by chance."""


@dataclass(frozen=True, repr=False)
class Erratum:
    """One error, in all places where it shows."""

    number: int
    members: tuple[Judged, ...]
    ledger: Ledger

    @property
    def lead(self) -> Judged:
        """The place where it begins, as far as the ledger tells."""
        return self.members[0]

    @cached_property
    def gravest(self) -> Judged:
        """The member whose verdict stands for all."""
        return gravest(self.members)

    @property
    def group(self) -> str:
        """One of `GROUPS`."""
        return min(map(group_of, self.members), key=list(GROUPS).index)

    @property
    def kind(self) -> str:
        """Whose the error is: the ``paper``'s, or that of our ``copy``."""
        return "copy" if self.group == "copy" else "paper"

    @property
    def weight(self) -> Weight:
        """The greatest weight of a member."""
        return min((x.claim.weight for x in self.members), key=list(Weight).index)

    @property
    def changes(self) -> tuple[tuple[Judged, ...], ...]:
        """The members, those together that say the same with the same correction."""
        found: dict[tuple[str, str], list[Judged]] = {}
        for x in self.members:
            found.setdefault((printed(x), truth(x)), []).append(x)
        return tuple(map(tuple, found.values()))

    @property
    def places(self) -> str:
        """Where it stands; what a place shares with the one before it is not repeated."""
        return shortened(dict.fromkeys(x.claim.place for x in self.members))

    @property
    def direct(self) -> tuple[str, ...]:
        """The claims that need a member, to be stated or proved."""
        ids = {x.id for x in self.members}
        used = {id for x in self.members for id in self.ledger.needed_by[x.id]}
        return tuple(x.id for x in self.ledger if x.id in used - ids)

    @property
    def indirect(self) -> tuple[str, ...]:
        """The claims that need these."""
        all_ = self.ledger.dependents(x.id for x in self.members)
        return tuple(id for id in all_ if id not in self.direct)


def group_of(x: Judged) -> str:
    """In which group a claim belongs. A result with a broken proof is no wrong result."""
    if x.verdict is Verdict.TRANSCRIPTION:
        return "copy"
    if x.verdict is Verdict.REPAIRED or x.claim.weight is Weight.PROOF:
        return "proofs"
    return "results" if x.claim.weight is Weight.RESULT else "wording"


def errata(ledger: Ledger) -> tuple[Erratum, ...]:
    """All errata, group by group, each in the order of the paper."""
    wrong = [x for x in ledger if x.is_erratum]
    together: dict[str, set[str]] = {x.id: {x.id} for x in wrong}
    for a, b in combinations(wrong, 2):
        if together[a.id] is not together[b.id] and same_error(a, b):
            merged = together[a.id] | together[b.id]
            together.update(dict.fromkeys(merged, merged))
    sets = {id(group): group for group in together.values()}.values()
    found = [Erratum(0, _ordered([x for x in wrong if x.id in group], ledger), ledger) for group in sets]
    found.sort(key=lambda e: list(GROUPS).index(e.group))
    return tuple(Erratum(number, e.members, ledger) for number, e in enumerate(found, 1))


def _ordered(members: list[Judged], ledger: Ledger) -> tuple[Judged, ...]:
    """What others rest on first, else the gravest verdict first, else in the order of the paper."""
    ids = [x.id for x in members]

    def key(x: Judged) -> tuple[int, tuple[int, ...], str]:
        below = ledger.closure([x.id], ("to_state", "to_prove"))
        in_section_6 = x.id if x.id.startswith("sec6") else ""  # there the order is that of the items
        return sum(id in below for id in ids), x.gravity[:2], in_section_6

    return tuple(sorted(members, key=key))


def shortened(places: Iterable[str]) -> str:
    """Places in words.

    >>> shortened(["Section 6, B~, item 5", "Section 6, B~, item 6", "Section 6, C~, item 5", "Table 2"])
    'Section 6, B~, item 5; item 6; C~, item 5; Table 2'
    """
    words, before = [], [""]
    for place in places:
        parts = place.split(", ")
        shared = next((n for n, (a, b) in enumerate(zip(parts, before, strict=False)) if a != b), 0)
        words.append(", ".join(parts[shared:]))
        before = parts
    return "; ".join(words)


# -- one cause ---------------------------------------------------------------------------------------------


def same_error(a: Judged, b: Judged) -> bool:
    """Whether the findings tell that two claims are wrong for one reason."""
    if (a.verdict is Verdict.TRANSCRIPTION) != (b.verdict is Verdict.TRANSCRIPTION):
        return False
    if a.verdict is Verdict.TRANSCRIPTION:
        same_place = "." in a.id and a.id.rpartition(".")[0] == b.id.rpartition(".")[0]
        return same_place or (a.claim.words, a.finding.evidence) == (b.claim.words, b.finding.evidence)
    return (
        _one_extends(a.id, b.id)
        or _same_words(a, b)
        or _same_cause(a, b)
        or _points_at(a, b)
        or _points_at(b, a)
    )


def _one_extends(a: str, b: str) -> bool:
    """As ``item-7.fatness`` and ``item-7.fatness-decimal``: two ways to give one value."""
    return a.startswith(f"{b}-") or b.startswith(f"{a}-")


def _same_words(a: Judged, b: Judged) -> bool:
    """The same correction of the same thing; or a witness or correction too long to agree by chance."""
    one, other = a.finding, b.finding
    last = {x.id.rpartition(".")[2] for x in (a, b)}
    if one.correction == other.correction and (len(last) == 1 and not "".join(last).isdigit()):
        return True
    pairs = ((one.correction, other.correction), (one.witness, other.witness))
    return any(x == y and len(x) >= TELLING for x, y in pairs)


def _same_cause(a: Judged, b: Judged) -> bool:
    causes = [{m[0] for m in map(CAUSE.search, clauses(x.finding.evidence)) if m} for x in (a, b)]
    return bool(causes[0] & causes[1]) and families_of(a.claim) == families_of(b.claim)


def _points_at(a: Judged, b: Judged) -> bool:
    """Whether the evidence for one says that the place of the other has the same error."""
    if not families_of(a.claim) & families_of(b.claim):
        return False
    pointing = (clause for clause in clauses(a.finding.evidence) if POINTING.search(clause))
    return any(_names(clause, a, b) for clause in pointing)


def _names(clause: str, a: Judged, b: Judged) -> bool:
    """Whether a clause names the place of a claim, and its quantity if there is more than one there."""
    place = b.claim.place
    if clause.startswith("Table ") or "Table 2 prints" in clause:  # a cell, or the formula above a cell
        return place in clause and (_cell_of(a, b) or _cell_of(b, a))
    if "uses it" in clause:
        item = re.search(r"\bitem \d\b", clause)
        return item is not None and place.endswith(item[0])
    quantities = {x.id.rpartition(".")[2] for x in (a, b)}
    said = re.search(r"computes the (\w+) with it", clause)
    return place in clause and ((said[1] in quantities) if said else len(quantities) == 1)


def _cell_of(formula: Judged, cell: Judged) -> bool:
    """Whether one of Tables 3 to 6 gives the decimal of a formula of Table 2 or Section 6."""
    needed = set(cell.claim.to_prove)
    measure = formula.id.rpartition(".")[2]
    return formula.id in needed or any(id.rpartition(".")[2] == measure for id in needed)


def clauses(evidence: str) -> Iterator[str]:
    """The parts of an evidence, which stand between semicolons."""
    return (part.strip() for part in evidence.split(";"))
