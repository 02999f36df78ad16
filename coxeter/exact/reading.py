"""Reading exact real numbers, also from text and from SymPy."""

from __future__ import annotations

import math
import numbers
import re
from fractions import Fraction
from typing import Any

from ..errors import InexactInput, InvalidInput
from .rationals import rational
from .surd import Surd


def surd(value: object) -> Surd:
    """Read any exact number: what `rational` reads, a surd, a SymPy number, or text with ``sqrt``.

    >>> surd("sqrt(3)/4"), surd("-1/2")
    (sqrt(3)/4, -1/2)
    """
    if isinstance(value, Surd):
        return value
    if isinstance(value, str) and "sqrt" in value:
        if not re.fullmatch(r"[\d\s+*/()\-.]*(?:sqrt[\d\s+*/()\-.]*)+", value):
            raise InvalidInput(f"{value!r} is not a number built from rationals and sqrt")
        import sympy

        try:
            value = sympy.sympify(value, rational=True)
        except (sympy.SympifyError, TypeError):
            raise InvalidInput(f"{value!r} is not a number built from rationals and sqrt") from None
    if hasattr(value, "as_coeff_Mul") and not isinstance(value, numbers.Rational):
        return _from_sympy(value)
    return Surd(rational(value))


def _from_sympy(expr: Any) -> Surd:
    """Convert a SymPy number built from rationals, sums, products and square roots."""
    if expr.is_Float:
        raise InexactInput(f"{expr} is inexact: give an integer, a Fraction, or text as '3/4'")
    if expr.is_Rational:
        return Surd(Fraction(int(expr.p), int(expr.q)))
    if expr.is_Add or expr.is_Mul:
        parts = [_from_sympy(part) for part in expr.args]
        return sum(parts[1:], parts[0]) if expr.is_Add else math.prod(parts[1:], start=parts[0])
    if expr.is_Pow and expr.exp.is_Rational:
        return _from_sympy(expr.base) ** Fraction(int(expr.exp.p), int(expr.exp.q))
    raise InvalidInput(f"{expr} is not a number built from rationals and roots")
