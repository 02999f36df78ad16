"""The ledger: every statement of the paper as a claim, with a check that judges it.

A check imports `coxeter.proofs`, `coxeter.symbolic` and NetworkX itself, where it uses them: SymPy takes
longer to load than all else, and many claims are judged without it.

>>> finding = find_claim("def-8").judge()
>>> finding.verdict.value, str(finding.strength)
('holds, corrected', 'every case (finite)')
"""

from __future__ import annotations

from .claim import Claim, Finding, register
from .reporting import Report, compare
from .rooms import all_claims, find_claim
from .running import Result, run_claim, verify
from .selecting import select
from .vocabulary import Extent, Strength, Verdict, Weight

__all__ = [
    "Claim",
    "Extent",
    "Finding",
    "Report",
    "Result",
    "Strength",
    "Verdict",
    "Weight",
    "all_claims",
    "compare",
    "find_claim",
    "register",
    "run_claim",
    "select",
    "verify",
]
