"""Proofs for every d: values that print as mathematics and can be replayed on numbers.

>>> proof = prove("quantity", "C", "longest_edge")
>>> proof.replay(8) > 0
True
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from importlib import import_module

from ..errors import InvalidInput
from .proof import Proof, Refuted, ReplayFailed, Step

__all__ = ["PROOFS", "Proof", "Refuted", "ReplayFailed", "Step", "prove"]

PROOFS = {
    "vertices": "simplices",
    "quantity": "measures",
    "regular_measures": "measures",
    "position_of_circumcentre": "delaunay",
    "proposition_7": "lattices",
    "proposition_8": "lattices",
    "proposition_9": "lattices",
    "proposition_10": "lattices",
    "distances": "appendix_c",
    "lemma_13": "appendix_c",
    "second_closest": "appendix_c",
    "relative_protection": "appendix_c",
    "best": "best",
    "rate": "rates",
    "protection_rate": "rates",
    "affine_images": "images",
}
"""The proofs by name, and the modules they are in."""


@lru_cache(maxsize=256)
def prove(name: str, *about: str) -> Proof:
    """A proof by its name and what it is about.

    Raises
    ------
    InvalidInput
        If there is no such proof.
    """
    if name not in PROOFS:
        raise InvalidInput(f"there is no proof {name!r}; there are {', '.join(PROOFS)}")
    function: Callable[..., Proof] = getattr(import_module(f"{__name__}.{PROOFS[name]}"), name)
    return function(*about)
