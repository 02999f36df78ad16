"""How an exact number is rounded: once, and correctly, from balls refined until both ends round alike."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, Protocol, TypeVar

import flint

from ..errors import InvalidInput
from .sums import precisions

_T = TypeVar("_T", int, float)


class Real(Protocol):
    """A number that balls enclose."""

    @property
    def is_rational(self) -> bool: ...
    def as_fraction(self) -> Fraction: ...
    def sign(self) -> int: ...
    def ball(self) -> flint.arb: ...
    def __abs__(self) -> Any: ...


def rounded(x: Real, rounding: Callable[[Fraction], _T]) -> _T:
    """A monotone rounding of a number.

    >>> from .surd import sqrt
    >>> rounded(sqrt(2), float), rounded(100 * sqrt(2), round)
    (1.4142135623730951, 141)
    """
    if x.is_rational:
        return rounding(x.as_fraction())
    for precision in precisions():  # an irrational number is no tie, so this ends
        with flint.ctx.workprec(precision):
            ball = x.ball()
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


def _scaled_integer(x: Real, scale: Fraction) -> int:
    """``x * scale`` rounded to the nearest integer, ties (only rationals have them) to even."""
    return rounded(x, lambda q: round(q * scale))


def decimal(x: Real, digits: int) -> str:
    """The decimal with that many digits after the point."""
    if digits < 0:
        raise InvalidInput(f"{digits} digits cannot be shown: give a number >= 0")
    n = _scaled_integer(x, Fraction(10**digits))
    text = str(flint.fmpz(abs(n))).rjust(digits + 1, "0")
    whole, part = (text[:-digits], text[-digits:]) if digits else (text, "")
    return ("-" if n < 0 else "") + whole + ("." + part if part else "")


def scientific(x: Real, digits: int) -> str:
    """The value in scientific notation, with that many digits."""
    if digits < 1:
        raise InvalidInput(f"{digits} digits cannot be shown: give a number >= 1")
    if not x.sign():
        return "0"
    guess, size = _order(abs(x)), abs(x)
    for e in (guess - 1, guess, guess + 1):  # the exponent is the least that leaves enough digits
        n = _scaled_integer(size, Fraction(10) ** (digits - 1 - e))
        if n < 10**digits:
            first, rest = str(flint.fmpz(n))[0], str(flint.fmpz(n))[1:]
            return f"{'-' if x.sign() < 0 else ''}{first}{'.' + rest if rest else ''}e{e:+03d}"
    raise AssertionError("unreachable")


def _order(x: Real) -> int:
    """The exponent of ten of a positive number, or one beside it."""
    for precision in precisions():
        with flint.ctx.workprec(precision):
            logarithm = x.ball().log() / flint.arb(10).log()
            if logarithm.is_finite():
                return math.floor(float(logarithm.mid()))
    raise AssertionError("unreachable")
