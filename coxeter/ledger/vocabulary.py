"""The words of a verdict: what came out, how strongly it is known, and how much it matters."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Verdict(Enum):
    """What a check can come to."""

    HOLDS = "holds"
    """True as printed."""
    CORRECTED = "holds, corrected"
    """True after a stated correction: a constant, a range, a sign, a hypothesis, a misprint."""
    REPAIRED = "proof repaired"
    """The statement is true and the printed argument does not prove it; ours does."""
    FAILS = "fails"
    """False as printed."""
    TRANSCRIPTION = "transcription"
    """Our copy is damaged here; what was published cannot be blamed."""
    CITED = "cited"
    """Proved elsewhere; instances are tested."""
    OPEN = "open"
    """A conjecture: neither proved nor refuted, here or elsewhere."""

    @property
    def accepts(self) -> bool:
        """Whether the statement stands as it is printed; every mutant must get a verdict that does not."""
        return self in (Verdict.HOLDS, Verdict.REPAIRED, Verdict.CITED, Verdict.OPEN)


class Weight(Enum):
    """What a statement is to a reader."""

    RESULT = "a result people use"
    PROOF = "a proof"
    WORDING = "wording"


class Extent(Enum):
    """How far a check reaches."""

    EVERY_D = "every d"
    FINITE = "every case (finite)"
    UP_TO = "exact up to d = N"
    INSTANCES = "instances"
    LITERATURE = "literature"


@dataclass(frozen=True)
class Strength:
    """How strongly a verdict is known.

    >>> print(EVERY_D, "|", up_to(24))
    every d | exact up to d = 24
    """

    extent: Extent
    reach: int = 0

    def __str__(self) -> str:
        return self.extent.value.replace("N", str(self.reach)) if self.reach else self.extent.value


EVERY_D = Strength(Extent.EVERY_D)
"""A proof for every dimension, or every case of an infinite family."""
FINITE = Strength(Extent.FINITE)
"""All cases were computed, and there are finitely many."""
INSTANCES = Strength(Extent.INSTANCES)
"""Some cases were computed."""
LITERATURE = Strength(Extent.LITERATURE)
"""Somebody else's proof."""


def up_to(d: int) -> Strength:
    """Every dimension up to d was computed, exactly."""
    return Strength(Extent.UP_TO, d)
