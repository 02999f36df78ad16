"""Reading exact real numbers, also from text and from SymPy."""

from __future__ import annotations

import ast
import math
import numbers
import operator
from fractions import Fraction
from typing import Any

from ..errors import CoxeterError, InexactInput, InvalidInput
from .rationals import LARGEST_EXPONENT, rational
from .surd import Surd, sqrt

_LARGEST_SIZE = 200_000  # bits
_OPERATIONS: dict[type, Any] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


def surd(value: object) -> Surd:
    """Read any exact number: what `rational` reads, a surd, a SymPy number, or text with roots.

    Raises
    ------
    InexactInput
        For a floating-point number.
    InvalidInput
        For anything else that is not built from rationals and roots.

    Examples
    --------
    >>> surd("sqrt(3)/4"), surd("-1/2"), surd("2**(1/3)")
    (sqrt(3)/4, -1/2, 2**(1/3))
    """
    if isinstance(value, Surd):
        return value
    if isinstance(value, str) and ("sqrt" in value or "**" in value):
        return _from_text(value)
    if hasattr(value, "as_coeff_Mul") and not isinstance(value, numbers.Rational):
        try:
            return _from_sympy(value)
        except ZeroDivisionError:
            raise InvalidInput(f"{value} is not a number built from rationals and roots") from None
    return Surd(rational(value))


def _from_text(text: str) -> Surd:
    try:
        return _evaluate(ast.parse(text.strip(), mode="eval").body, text.strip())
    except (CoxeterError, ArithmeticError, SyntaxError, ValueError, RecursionError, MemoryError):
        raise InvalidInput(f"{text!r} is not a number built from rationals and roots") from None


def _evaluate(node: ast.expr, text: str) -> Surd:
    """The value of a sum, product, quotient, power or square root; anything else is refused."""
    match node:
        case ast.Constant(int() | float()) if not isinstance(node.value, bool):
            return Surd(rational(ast.get_source_segment(text, node) or ""))
        case ast.UnaryOp(ast.USub(), operand):
            return -_evaluate(operand, text)
        case ast.Call(ast.Name("sqrt"), [argument], []):
            return sqrt(_evaluate(argument, text))
        case ast.BinOp(base, ast.Pow(), exponent):
            power, x = _evaluate(exponent, text).as_fraction(), _evaluate(base, text)
            size = abs(power.numerator) * max(len(str(x)), 1) * 4
            if size <= _LARGEST_SIZE and power.denominator <= LARGEST_EXPONENT:
                return x**power
        case ast.BinOp(left, operation, right) if type(operation) in _OPERATIONS:
            result: Surd = _OPERATIONS[type(operation)](_evaluate(left, text), _evaluate(right, text))
            return result
    raise InvalidInput(f"{ast.unparse(node)} cannot be read")


def _from_sympy(expr: Any) -> Surd:
    """Convert a SymPy number built from rationals, sums, products and roots."""
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
