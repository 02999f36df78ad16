"""Reading exact rational numbers, and refusing inexact ones."""

from __future__ import annotations

import numbers
import re
from fractions import Fraction

import flint

from ..errors import InexactInput, InvalidInput

LARGEST_EXPONENT = 10_000


def rational(value: object) -> Fraction:
    """Read one exact rational: an integer, a fraction, or text such as ``"3/4"`` or ``"0.75"``.

    Raises
    ------
    InexactInput
        For a floating-point number: 0.1 is not one tenth, so it is refused rather than guessed at.
    InvalidInput
        For anything else that is not a rational number.

    Examples
    --------
    >>> rational("3/4") + rational(1)
    Fraction(7, 4)
    """
    if isinstance(value, numbers.Rational) and not isinstance(value, bool):
        return Fraction(int(value.numerator), int(value.denominator))
    if isinstance(value, (flint.fmpz, flint.fmpq)):
        return Fraction(int(value.numerator), int(value.denominator))
    if hasattr(value, "as_fraction"):
        return value.as_fraction()  # type: ignore[no-any-return]  # a surd, if it is rational
    if isinstance(value, str):
        exponent = re.search(r"[eE][+-]?([0-9_]+)", value)
        if exponent and int(exponent[1].replace("_", "") or 0) > LARGEST_EXPONENT:
            raise InvalidInput(f"{value!r} has an exponent larger than {LARGEST_EXPONENT}")
        try:
            return Fraction(value.strip())
        except (ValueError, ZeroDivisionError):
            raise InvalidInput(f"{value!r} is not a rational number such as '3/4'") from None
    if isinstance(value, numbers.Real) and not isinstance(value, bool):
        raise InexactInput(f"{value!r} is inexact: give an integer, a Fraction, or text as '3/4'")
    raise InvalidInput(f"{value!r} is not a rational number: give an integer, a Fraction or text")
