"""The ledger: every statement of the paper as a claim, with a check that judges it.

A check imports `coxeter.proofs`, `coxeter.symbolic` and NetworkX itself, where it uses them: SymPy takes
longer to load than all else, and many claims are judged without it.

>>> finding = find_claim("def-8").judge()
>>> finding.verdict.value, str(finding.strength)
('holds, corrected', 'every case (finite)')
"""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from functools import lru_cache
from importlib import import_module
from types import MappingProxyType

from ..errors import InvalidInput
from .claim import CLAIMS, Claim, Finding, register
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

ROOMS = (
    "section_1",
    "section_2",
    "section_3",
    "section_4",
    "section_5",
    "tables",
    "section_6",
    "appendix_a",
    "appendix_b",
    "appendix_c",
    "appendix_d",
)
"""The modules with the claims, in the order of the paper."""


@lru_cache(maxsize=1)
def all_claims() -> Mapping[str, Claim]:
    """Every claim by its id, in the order of the paper."""
    for room in ROOMS:
        import_module(f"{__name__}.{room}")
    return MappingProxyType(CLAIMS)


def find_claim(id: str) -> Claim:
    """The claim with an id.

    Raises
    ------
    InvalidInput
        If there is none; the message names the nearest ids.
    """
    claims = all_claims()
    if id in claims:
        return claims[id]
    near = get_close_matches(id, claims, n=3, cutoff=0.4)
    hint = f"did you mean {' or '.join(near)}?" if near else "`coxeter verify --json` lists all ids"
    raise InvalidInput(f"there is no claim {id!r}: {hint}")


from .reporting import Report, compare  # noqa: E402 — these need the functions above
from .running import Result, run_claim, verify  # noqa: E402
from .selecting import select  # noqa: E402
