"""How an exact number is rounded: once, and correctly, from balls refined until both ends round alike."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, TypeVar

import flint

from ..errors import InvalidInput
from . import sums
from .sums import precisions

if TYPE_CHECKING:
    from .surd import Surd

_T = TypeVar("_T", int, float)


def enclosure(x: Surd) -> flint.arb:
    """A ball that holds the number, as small as the precision that is set allows."""
    ball = sums.ball(x.num) / sums.ball(x.den)
    return ball if x.index == 1 else ball.root(x.index)


def rounded(x: Surd, rounding: Callable[[Fraction], _T]) -> _T:
    """A monotone rounding of a number.

    >>> from .surd import sqrt
    >>> rounded(sqrt(2), float), rounded(100 * sqrt(2), round)
    (1.4142135623730951, 141)
    """
    if x.is_rational:
        return rounding(x.as_fraction())
    for precision in precisions():  # an irrational number is no tie, so this ends
        with flint.ctx.workprec(precision):
            ball = enclosure(x)
            if not ball.is_finite():
                continue  # the denominator is not yet told from zero
            low, high = (rounding(_fraction(end)) for end in (ball.lower(), ball.upper()))
            if low == high:
                return low
    raise AssertionError("unreachable")


def _fraction(ball: flint.arb) -> Fraction:
    """The exact value of a ball of radius zero."""
    mantissa, exponent = (int(part) for part in ball.mid().man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent


def _scaled_integer(x: Surd, scale: Fraction) -> int:
    """``x * scale`` rounded to the nearest integer, ties (only rationals have them) to even."""
    return rounded(x, lambda q: round(q * scale))


def decimal(x: Surd, digits: int) -> str:
    """The decimal with that many digits after the point."""
    if digits < 0:
        raise InvalidInput(f"{digits} digits cannot be shown: give a number >= 0")
    n = _scaled_integer(x, Fraction(10**digits))
    text = str(flint.fmpz(abs(n))).rjust(digits + 1, "0")
    whole, part = (text[:-digits], text[-digits:]) if digits else (text, "")
    return ("-" if n < 0 else "") + whole + ("." + part if part else "")


def scientific(x: Surd, digits: int) -> str:
    """The value in scientific notation, with that many digits."""
    if digits < 1:
        raise InvalidInput(f"{digits} digits cannot be shown: give a number >= 1")
    if not x:
        return "0"
    guess, size = _order(abs(x)), abs(x)
    for e in (guess - 1, guess, guess + 1):  # the exponent is the least that leaves enough digits
        n = _scaled_integer(size, Fraction(10) ** (digits - 1 - e))
        if n < 10**digits:
            first, rest = str(flint.fmpz(n))[0], str(flint.fmpz(n))[1:]
            return f"{'-' if x.sign() < 0 else ''}{first}{'.' + rest if rest else ''}e{e:+03d}"
    raise AssertionError("unreachable")


def _order(x: Surd) -> int:
    """The exponent of ten of a positive number, or one beside it."""
    for precision in precisions():
        with flint.ctx.workprec(precision):
            logarithm = enclosure(x).log() / flint.arb(10).log()
            if logarithm.is_finite():
                return math.floor(float(logarithm.mid()))
    raise AssertionError("unreachable")
