"""All there is to say about a claim: as data, and as text to read."""

from __future__ import annotations

import shutil
import textwrap
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from ..ledger.claim import CLAIMS, Claim, Constants, spell
from ..ledger.inventory import meant
from ..ledger.recorded import recorded
from ..ledger.reporting import Entry, score
from ..ledger.running import run
from ..ledger.vocabulary import Verdict

CORRECTIONS = {Verdict.FAILS: "Instead", Verdict.REPAIRED: "Our proof", Verdict.CITED: "Source"}
"""What the correction is in each case, if not that."""

STEP = ("kind", "words", "formula", "range", "reduced")
"""What is told of a step of a proof."""


@dataclass(frozen=True)
class Explained:
    """A claim with what came of running it, and the claims that depend on it."""

    entry: Entry
    claim: Claim
    stated_with_it: tuple[str, ...]
    proved_with_it: tuple[str, ...]

    @property
    def steps(self) -> list[dict[str, str]]:
        """The steps of the proof, if there is one."""
        from ..proofs import prove  # it needs SymPy, which takes longer to load than all else here

        finding = self.entry.result.finding if self.entry.result else None
        steps = prove(*finding.proof).steps if finding and finding.proof else ()
        return [{name: getattr(step, name) for name in STEP} for step in steps]

    def data(self) -> dict[str, Any]:
        """All of it as JSON-ready data."""
        finding = self.entry.result.finding if self.entry.result else None
        steps = [{name: text for name, text in step.items() if text} for step in self.steps]
        return self.entry.data() | {
            "printed": dict(self.claim.printed),
            "evidence": finding.evidence if finding else "",
            "tested": finding.tested if finding else "",
            "derivation": list(finding.derivation) if finding else [],
            "proof": steps,
            "needed_by": {"to_state": list(self.stated_with_it), "to_prove": list(self.proved_with_it)},
            "code": self.claim.code,
        }


def explained(claim: Claim) -> Explained:
    """Judge a claim, and find what depends on it among the claims that are loaded."""
    entry = Entry(claim.id, claim, run(claim), recorded().get(claim.id))
    stated = tuple(
        id for id, other in CLAIMS.items() if any(claim.id in meant(x, CLAIMS) for x in other.to_state)
    )
    proved = tuple(
        id for id, other in CLAIMS.items() if any(claim.id in meant(x, CLAIMS) for x in other.to_prove)
    )
    return Explained(entry, claim, stated, proved)


def explain(x: Explained) -> str:
    """The text, as wide as the terminal, but for reading no wider than 100 columns."""
    width = min(100, max(40, shutil.get_terminal_size((88, 24)).columns))
    lines = [f"{x.claim.id} · {x.claim.place}"]
    lines.append("=" * min(width, len(lines[0])))
    for heading, paragraphs in _sections(x):
        if paragraphs:
            lines += ["", heading, *(line for text in paragraphs for line in _wrap(text, width))]
    return "\n".join(lines)


def _wrap(text: str, width: int) -> list[str]:
    """A paragraph in lines; how far it is indented stays, and words and formulas are never cut."""
    indent = "  " + " " * (len(text) - len(text.lstrip()))
    hang = "   " if text.lstrip()[:1].isdigit() and ". " in text[:6] else ""
    return textwrap.wrap(
        text.strip(), width, initial_indent=indent, subsequent_indent=indent + hang,
        break_long_words=False, break_on_hyphens=False,
    )  # fmt: skip


def _sections(x: Explained) -> Iterator[tuple[str, list[str]]]:
    result = x.entry.result
    assert result is not None
    finding = result.finding
    yield "Statement", [x.claim.statement]
    yield "Printed", _constants(x.claim.printed)
    if finding is None:
        yield "Verdict", [result.trouble]
    else:
        found = [str(x.entry.found)]
        yield "Verdict", found if x.entry.expected else [*found, "It is not on record."]
        yield "Not as recorded", [*x.entry.problems] if x.entry.expected else []
        yield CORRECTIONS.get(finding.verdict, "Correction"), _some(finding.correction)
        yield "Witness", _some(finding.witness)
        yield "Evidence", _some(finding.evidence)
        yield "Tested", _some(finding.tested)
        yield "Derivation", _numbered([line] for line in finding.derivation)
    yield "Proof", _numbered(map(_step, x.steps))
    yield "Mutants", [score([result])]
    yield "Needs to be stated", _names(x.claim.to_state)
    yield "Needs to be proved", _names(x.claim.to_prove)
    yield "Needed to state", _names(x.stated_with_it)
    yield "Needed to prove", _names(x.proved_with_it)
    yield "Code", _some(x.claim.code)


def _some(text: str) -> list[str]:
    return [text] if text else []


def _names(ids: Iterable[str]) -> list[str]:
    return _some(", ".join(ids))


def _constants(constants: Constants) -> list[str]:
    return [f"{name.replace('_', ' ')}: {spell(value)}" for name, value in constants.items()]


def _step(step: dict[str, str]) -> list[str]:
    """A step in lines: its words, then its formula with the range, then the form that was decided."""
    formula = ",  ".join(filter(None, (step["formula"], step["range"])))
    return [step["words"], *_some(formula), *_some(step["reduced"])]


def _numbered(items: Iterable[list[str]]) -> list[str]:
    """Paragraphs with numbers; the further lines of each stand under its words."""
    lines: list[str] = []
    for number, (first, *rest) in enumerate(items, 1):
        lines += [f"{number}. {first}", *(f"   {line}" for line in rest)]
    return lines
