"""How much was checked, and what came out: the numbers that prose may show."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from ..ledger.vocabulary import Extent, Verdict, Weight
from .judged import Ledger


def headline(ledger: Ledger) -> Mapping[str, int]:
    """The numbers by name.

    ``checked`` is the number of claims. ``holds``, ``corrected``, ``repaired``, ``fails``, ``damaged``,
    ``cited`` and ``open`` are the claims by verdict; ``wrong`` are those that are false as printed, by the
    paper's own fault, and ``wrong-results`` those of them that people use. ``every-d`` and ``finite`` are the
    claims that are settled in all cases. So many ``mutants`` were tried, and so many ``rejected``.
    """
    verdicts = Counter(x.verdict for x in ledger)
    extents = Counter(x.finding.strength.extent for x in ledger)
    wrong = [x for x in ledger if x.verdict in (Verdict.CORRECTED, Verdict.FAILS)]
    return {
        "checked": len(ledger),
        **{name: verdicts[verdict] for name, verdict in NAMES.items()},
        "wrong": len(wrong),
        "wrong-results": sum(x.claim.weight is Weight.RESULT for x in wrong),
        "every-d": extents[Extent.EVERY_D],
        "finite": extents[Extent.FINITE],
        "mutants": sum(x.result.tried for x in ledger),
        "rejected": sum(x.result.rejected for x in ledger),
    }


NAMES = {
    "holds": Verdict.HOLDS,
    "corrected": Verdict.CORRECTED,
    "repaired": Verdict.REPAIRED,
    "fails": Verdict.FAILS,
    "damaged": Verdict.TRANSCRIPTION,
    "cited": Verdict.CITED,
    "open": Verdict.OPEN,
}
"""A word for each verdict that can stand in an address or a style sheet."""
