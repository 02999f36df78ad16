"""What came out, held against the recorded ledger: as data, and as a summary to read."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from .claim import CLAIMS, Claim
from .recorded import Record, differences, record, recorded
from .rooms import all_claims
from .running import Result
from .vocabulary import Extent, Verdict

AS_RECORDED, DIFFERS, SURVIVORS = "as recorded", "differs", "mutants survive"


@dataclass(frozen=True)
class Entry:
    """A claim, what came of running it, and what the recorded ledger expects.

    Attributes
    ----------
    claim, result
        None if there is no such claim, only a record of it.
    expected
        None if the claim is not recorded.
    """

    id: str
    claim: Claim | None
    result: Result | None
    expected: Record | None

    @property
    def found(self) -> Record | None:
        """What would be recorded now; None if there is no finding."""
        if self.claim is None or self.result is None or self.result.finding is None:
            return None
        return record(self.claim, self.result.finding)

    @property
    def outcome(self) -> str:
        """One of ``as recorded``, ``differs``, ``mutants survive``, ``error`` and ``timeout``."""
        if self.result and self.result.trouble:
            return self.result.trouble.partition(":")[0]
        if self.expected is None or self.found is None or differences(self.expected, self.found):
            return DIFFERS
        return SURVIVORS if self.result and self.result.survivors else AS_RECORDED

    @property
    def problems(self) -> tuple[str, ...]:
        """What is not as it should be, a sentence each: what was expected, and what came out."""
        if self.result is None:
            return (f"expected: {self.expected}; there is no such claim",)
        problems: list[str] = []
        if self.found is None:
            problems.append(f"expected: {self.expected or 'nothing on record'}; {self.result.trouble}")
        elif self.expected is None:
            problems.append(f"expected: nothing on record; came out: {self.found}")
        else:
            problems.extend(differences(self.expected, self.found))
        problems.extend(f"this mutant is not rejected: {what}" for what in self.result.survivors)
        return tuple(problems)

    def data(self) -> dict[str, Any]:
        """The entry as JSON-ready data; without a finding, verdict and strength are None."""
        claim, result = self.claim, self.result
        finding = result.finding if result else None
        return {
            "id": self.id,
            "place": claim.place if claim else "",
            "statement": claim.statement if claim else "",
            "verdict": finding.verdict.value if finding else None,
            "strength": str(finding.strength) if finding else None,
            "weight": claim.weight.value if claim else None,
            "depends_on": {
                "to_state": list(claim.to_state) if claim else [],
                "to_prove": list(claim.to_prove) if claim else [],
            },
            "seconds": round(result.seconds, 4) if result else 0.0,
            "mutants": {
                "tried": result.tried if result else 0,
                "rejected": result.rejected if result else 0,
            },
            "witness": finding.witness if finding else "",
            "correction": finding.correction if finding else "",
            "outcome": self.outcome,
            "expected": _words(self.expected),
            "problems": list(self.problems),
        }


def _words(record: Record | None) -> dict[str, str] | None:
    if record is None:
        return None
    return {name: getattr(record, name) for name in ("verdict", "strength", "weight", "correction")}


@dataclass(frozen=True)
class Report:
    """All that came out of a run. ``print`` it for a summary."""

    entries: tuple[Entry, ...]
    seconds: float | None = None

    @property
    def ok(self) -> bool:
        """Whether everything is as recorded, and every mutant is rejected."""
        return all(entry.outcome == AS_RECORDED for entry in self.entries)

    @property
    def results(self) -> tuple[Result, ...]:
        """The results of those claims that there are."""
        return tuple(entry.result for entry in self.entries if entry.result)

    def data(self) -> list[dict[str, Any]]:
        """The entries as JSON-ready data."""
        return [entry.data() for entry in self.entries]

    def lines(self) -> list[str]:
        """A line for each claim: what came out."""
        width = max((len(entry.id) for entry in self.entries), default=0)
        return [f"{entry.id.ljust(width)}  {entry.found or entry.outcome}" for entry in self.entries]

    def __str__(self) -> str:
        time = "" if self.seconds is None else f" in {self.seconds:.1f} s"
        parts = [
            _count(len(self.results), "claim") + time,
            "",
            *_table(self.results),
            "",
            score(self.results),
        ]
        bad = [entry for entry in self.entries if entry.outcome != AS_RECORDED]
        if not bad:
            return "\n".join([*parts, "Everything came out as recorded."])
        parts += ["", f"{_count(len(bad), 'claim')} not as recorded:"]
        for entry in bad:
            parts += [f"  {entry.id}: {entry.outcome}", *(f"      {what}" for what in entry.problems)]
        return "\n".join(parts)


def compare(
    results: Iterable[Result], records: Mapping[str, Record] | None = None, seconds: float | None = None
) -> Report:
    """Hold results against the recorded ledger.

    Parameters
    ----------
    records
        What is expected; default what is recorded of these claims, and all records that have no claim.
    seconds
        How long the run took, to be told in the summary.
    """
    results = tuple(results)
    if records is None:
        there, ran = all_claims(), {result.id for result in results}
        records = {id: x for id, x in recorded().items() if id in ran or id not in there}
    entries = [Entry(x.id, CLAIMS[x.id], x, records.get(x.id)) for x in results]
    lost = [Entry(id, None, None, x) for id, x in records.items() if id not in CLAIMS]
    return Report((*entries, *lost), seconds)


def score(results: Iterable[Result]) -> str:
    """The mutation score in words; 100 % only if all were rejected.

    >>> score([Result("a", None, 0.0, tried=2000), Result("b", None, 0.0, tried=1, survivors=("n: 2",))])
    '2000 of 2001 mutants rejected, 99.9 %'
    """
    pairs = [(result.rejected, result.tried) for result in results]
    rejected, tried = (sum(column) for column in zip(*pairs, strict=True)) if pairs else (0, 0)
    if not tried:
        return "no mutants to reject"
    thousandths = 1000 * rejected // tried
    percent = f"{thousandths // 10}" + (f".{thousandths % 10}" if thousandths % 10 else "")
    return f"{rejected} of {_count(tried, 'mutant')} rejected, {percent} %"


def _table(results: Iterable[Result]) -> list[str]:
    """Verdicts by strength; a claim without a finding counts in the row of its trouble."""
    counts: Counter[tuple[str, str]] = Counter()
    for result in results:
        if result.finding:
            counts[result.finding.verdict.value, result.finding.strength.extent.value] += 1
        else:
            counts[result.trouble.partition(":")[0], ""] += 1
    rows = [
        x for x in (*(v.value for v in Verdict), "error", "timeout") if any(x == row for row, _ in counts)
    ]
    columns = [x for x in (*(e.value for e in Extent), "") if any(x == column for _, column in counts)]
    cells = [["", *(x or "(none)" for x in columns), "all"]]
    for row in rows:
        line = [counts[row, column] for column in columns]
        cells.append([row, *(str(n or "·") for n in line), str(sum(line))])
    sums = [sum(counts[row, column] for row in rows) for column in columns]
    cells.append(["all", *map(str, sums), str(sum(sums))])
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    return [
        "  ".join([line[0].ljust(widths[0]), *map(str.rjust, line[1:], widths[1:])]).rstrip()
        for line in cells
    ]


def _count(n: int, what: str) -> str:
    return f"{n} {what}" if n == 1 else f"{n} {what}s"
