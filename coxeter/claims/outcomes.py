"""What a comparison of a printed value with the exact one can come to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from enum import Enum
from fractions import Fraction

from ..exact import Exact, Surd


class Outcome(Enum):
    """How a printed value stands to the exact one."""

    AGREES = "agrees"
    ROUNDED_DIFFERENTLY = "rounded differently"
    """Not the correct rounding, but less than one unit of the last digit away from the exact value."""
    DIFFERS = "differs"
    TRANSCRIPTION = "transcription"
    """Our copy is at fault here, not what was published."""


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """A printed value, the exact one, and what came of comparing them.

    Attributes
    ----------
    place
        Where it is printed, as ``"Table 5"`` or ``"Section 6, A~, item 6"``.
    family, quantity
        What it is the value of.
    printed
        The printed text; formulas in the notation of `coxeter.families.evaluate`.
    outcome
        The verdict, reached without any rounding but that of printed decimals.
    dimensions
        The dimensions for which printed and exact values were compared: instances, no proof.
    fails_at
        Those of them in which they differ.
    exact
        The exact value in the first dimension in which they differ, or else in the first of all; None if
        there is nothing that could be printed, as for the fatness of a B~2.
    rounded
        For decimals: the exact value, correctly rounded to as many digits as are printed.
    column
        For Tables 3 to 6: the d at the head of the column in which our copy prints it.
    note
        The verdict in words.
    evidence
        What was found in support of it, all of it by computation.
    """

    place: str
    family: str
    quantity: str
    printed: str
    outcome: Outcome
    dimensions: tuple[int, ...]
    fails_at: tuple[int, ...] = ()
    exact: Surd | tuple[Exact, ...] | None = None
    rounded: str | None = None
    column: int | None = None
    note: str = ""
    evidence: str = field(default="", repr=False)

    @property
    def dimension(self) -> int | None:
        """The dimension, if there is only one."""
        return self.dimensions[0] if len(self.dimensions) == 1 else None


def round_like(printed: str, exact: Surd) -> str:
    """The correct rounding of a number to as many digits as a decimal has.

    >>> round_like("0.666", Surd("2/3")), round_like("9.900e-6", Surd("1/70000"))
    ('0.667', '1.429e-5')
    """
    mantissa, e, _ = printed.partition("e")
    if not e:
        return exact.decimal(len(mantissa.partition(".")[2]))
    mantissa, _, exponent = exact.scientific(len(mantissa.replace(".", ""))).partition("e")
    return f"{mantissa}e{int(exponent)}"


def compare_decimal(printed: str, exact: Surd) -> Outcome:
    """Whether a decimal is the correct rounding of a number, or less than one unit away from it.

    >>> compare_decimal("0.666", Surd("2/3"))
    <Outcome.ROUNDED_DIFFERENTLY: 'rounded differently'>
    """
    if printed == round_like(printed, exact):
        return Outcome.AGREES
    value = Fraction(Decimal(printed))
    close = value - unit(printed) < exact < value + unit(printed)
    return Outcome.ROUNDED_DIFFERENTLY if close else Outcome.DIFFERS


def unit(printed: str) -> Fraction:
    """One unit of a decimal's last digit.

    >>> unit("0.25"), unit("9.9e1")
    (Fraction(1, 100), Fraction(1, 1))
    """
    return Fraction(10) ** int(Decimal(printed).as_tuple().exponent)


def units_off(printed: str, exact: Surd) -> str:
    """By how many units of the last digit a decimal is above or below the correct rounding."""
    steps = (Fraction(Decimal(printed)) - Fraction(Decimal(round_like(printed, exact)))) / unit(printed)
    n, where = abs(int(steps)), "high" if steps > 0 else "low"
    return f"{n} unit{'s' if n > 1 else ''} of the last digit too {where}"


def spell(dimensions: Sequence[int]) -> str:
    """Dimensions in words: ``d = 4 … 24``, ``odd d = 3 … 23``.

    >>> spell([3]), spell([3, 4, 5, 6]), spell([2, 4, 6]), spell([2, 3, 7])
    ('d = 3', 'd = 3 … 6', 'even d = 2 … 6', 'd = 2, 3, 7')
    """
    ds = list(dimensions)
    for step, words in ((1, "d"), (2, "odd d" if ds[0] % 2 else "even d")):
        if len(ds) > 2 and ds == list(range(ds[0], ds[-1] + 1, step)):
            return f"{words} = {ds[0]} … {ds[-1]}"
    return "d = " + ", ".join(map(str, ds))


def spell_range(dimensions: Sequence[int], fails: Sequence[int]) -> str:
    """For which dimensions something holds, and for which it fails.

    >>> spell_range(range(3, 10), (3,)), spell_range((2, 3), ())
    ('holds for d = 4 … 9, fails for d = 3', 'holds for d = 2, 3')
    """
    held = tuple(d for d in dimensions if d not in fails)
    return ", ".join(f"{word} for {spell(ds)}" for word, ds in (("holds", held), ("fails", fails)) if ds)
