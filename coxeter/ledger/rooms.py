"""The modules with the claims, and finding a claim in them."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from functools import lru_cache
from importlib import import_module
from types import MappingProxyType

from ..errors import InvalidInput
from .claim import CLAIMS, Claim

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
        import_module(f"{__package__}.{room}")
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
