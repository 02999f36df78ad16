"""Claims as a reader of a notebook sees them: statement, verdict, and how it is known, step by step."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from ..ledger import all_claims, find_claim
from ..ledger.claim import Claim, Finding
from ..ledger.inventory import belongs
from ..ledger.vocabulary import Verdict
from ..proofs import Proof, prove
from .corrections import in_words
from .wording import pieces, polished, statement

HEADINGS = {
    Verdict.FAILS: "Instead",
    Verdict.REPAIRED: "Our proof",
    Verdict.CITED: "Source",
}
"""What the correction is in each case, if not that."""

WAYS = {
    "identity": "identity",
    "inequality": "inequality",
    "formulas": "formulas compared",
    "computed": "every case computed",
    "argument": "argument",
    "tested": "tested",
}
"""How a step of a proof is known, by its kind."""

MANY = 12
"""So many claims that simply hold are written out; of more only the ids are given."""


@dataclass(frozen=True)
class Explanation:
    """The claims of an item with what came of judging them; a notebook shows it as text with formulas."""

    claims: tuple[Claim, ...]
    findings: tuple[Finding, ...]

    @property
    def proofs(self) -> tuple[Proof, ...]:
        """The proofs for every d that stand behind the findings, each once."""
        return tuple(prove(*names) for names in dict.fromkeys(f.proof for f in self.findings if f.proof))

    def replay(self, largest: int = 12) -> int:
        """Try all steps on numbers up to a dimension; returns how many instances there were."""
        return sum(proof.replay(largest) for proof in self.proofs)

    def __repr__(self) -> str:
        pairs = zip(self.claims, self.findings, strict=True)
        return "\n".join(f"{claim.id}: {f.verdict.value} · {f.strength}" for claim, f in pairs)

    def _repr_markdown_(self) -> str:
        pairs = list(zip(self.claims, self.findings, strict=True))
        plain = [(c, f) for c, f in pairs if f.verdict is Verdict.HOLDS and len(f.derivation) < 2]
        few = len(plain) <= MANY
        parts = [_claim(c, f) for c, f in pairs if few or (c, f) not in plain]
        parts += [] if few else [_plainly(plain)]
        shown: set[str] = set()
        parts += [text for proof in self.proofs if (text := _proof(proof, shown))]
        return "\n\n".join(parts)


def explain(*ids: str) -> Explanation:
    """Judge claims and show how their verdicts are known.

    Parameters
    ----------
    ids
        Ids of claims, or of items: ``sec6.B.item-3`` stands for all claims of that item, ``lem-9`` for
        the lemma and the steps of its proof.

    Raises
    ------
    InvalidInput
        If there is no such claim or item.

    Examples
    --------
    >>> explain("sec6.C.item-5")
    sec6.C.item-5.longest-edge: holds · every d
    sec6.C.item-5.longest: holds · every d
    """
    claims = all_claims()
    wanted = {x: None for id in ids for x in [x for x in claims if belongs(x, id)] or _unknown(id)}
    return Explanation(tuple(claims[id] for id in wanted), tuple(claims[id].judge() for id in wanted))


def _unknown(id: str) -> tuple[str, ...]:
    return (find_claim(id).id,)  # raises, and names the nearest


def _claim(claim: Claim, finding: Finding) -> str:
    verdict = f"*{finding.verdict.value} · {finding.strength}*"
    lines = [f"**{_text(statement(claim))}** — {verdict} (`{claim.id}`, decided by `{claim.code}`)"]
    for heading, text in (
        (HEADINGS.get(finding.verdict, "Correction"), in_words(finding.correction)),
        ("Witness", finding.witness),
        ("Evidence", finding.evidence),
        ("Tested", finding.tested),
    ):
        if text:
            lines.append(f"{heading}: {_text(text)}")
    lines += [f"{number}. {_text(step)}" for number, step in enumerate(finding.derivation, 1)]
    return "\n\n".join(lines[:1]) + "".join(f"\n\n{line}" for line in lines[1:])


def _plainly(pairs: list[tuple[Claim, Finding]]) -> str:
    """Many claims that hold, by their ids alone."""
    ids = ", ".join(f"`{claim.id}`" for claim, _ in pairs)
    return f"**{len(pairs)} more hold as printed:** {ids}"


def _proof(proof: Proof, shown: set[str]) -> str:
    """A proof without the steps that an earlier one has shown."""
    steps = list(_new_steps(proof, shown))
    if not steps:
        return ""
    lines = [f"**Proof for every d:** {proof.statement}", ""]
    return "\n".join([*lines, *(f"{number}. {step}" for number, step in enumerate(steps, 1)), "", "∎"])


def _new_steps(proof: Proof, shown: set[str]) -> Iterator[str]:
    for step in proof.steps:
        text = step._repr_markdown_()
        if text not in shown:
            shown.add(text)
            yield f"{text} — *{WAYS[step.kind]}*, `{step.code}`"


def _text(words: str) -> str:
    """Plain text as Markdown: formulas and names of types between dollar signs, all else taken literally."""
    return "".join(
        re.sub(r"([*_\\<>`\[\]#])", r"\\\1", polished(x.text)) if x.kind == "words" else f"${x.text}$"
        for x in pieces(words)
    )
