"""Reading formulas written as text, as exact numbers or as SymPy expressions."""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from ..errors import InvalidInput
from ..exact import Exact, Surd, rational, sqrt, surd

if TYPE_CHECKING:
    import sympy

_OPERATORS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


@dataclass(frozen=True)
class Domain:
    """What numbers, letters, powers and functions in a formula are to mean."""

    number: Callable[[int], Any]
    letter: Callable[[Any], Any]
    power: Callable[[Any, Any], Any]
    functions: Mapping[str, Callable[[Any], Any]]


def _letter(value: object) -> Exact:
    if type(value) is int:
        return Fraction(value)
    x = surd(value)
    return x.as_fraction() if x.is_rational else x


def _power(base: Exact, exponent: Exact) -> Exact:
    e = rational(exponent)
    if isinstance(base, Surd) or e.denominator > 1:
        return surd(base) ** e
    return Fraction(base) ** int(e)


_EXACT = Domain(  # fractions as long as there is no root: they are faster than surds
    number=Fraction,
    letter=_letter,
    power=_power,
    functions={"sqrt": sqrt, "factorial": lambda n: Fraction(math.factorial(int(rational(n))))},
)


def evaluate(text: str, **values: Exact) -> Surd:
    """The exact value of a formula, with numbers for its letters.

    Raises
    ------
    InvalidInput
        If the text is no formula: numbers and letters, ``+ - * / **``, ``sqrt`` and ``factorial``.

    Examples
    --------
    >>> evaluate("sqrt(d + 1)/2", d=3), evaluate("2**(1/2 + 1/d)", d=4)
    (1, 8**(1/4))
    """
    return surd(read(text, _EXACT, values))


def expression(text: str) -> sympy.Expr:
    """A formula as a SymPy expression; its letters stand for positive integers.

    >>> expression("sqrt(d + 1)/2")
    sqrt(d + 1)/2
    """
    import sympy

    symbols = {name: sympy.Symbol(name, integer=True, positive=True) for name in "dijkmt"}
    functions = {"sqrt": sympy.sqrt, "factorial": sympy.factorial}
    return read(text, Domain(sympy.Integer, lambda x: x, operator.pow, functions), symbols)


def read(text: str, domain: Domain, names: Mapping[str, Any]) -> Any:
    """Read a formula in a domain, with what its letters stand for."""

    def visit(node: ast.expr) -> Any:
        match node:
            case ast.Constant(value=n) if type(n) is int:
                return domain.number(n)
            case ast.Name(id=name) if name in names:
                return domain.letter(names[name])
            case ast.UnaryOp(op=ast.USub(), operand=x):
                return -visit(x)
            case ast.BinOp(left=x, op=ast.Pow(), right=y):
                return domain.power(visit(x), visit(y))
            case ast.BinOp(left=x, op=op, right=y) if type(op) in _OPERATORS:
                return _OPERATORS[type(op)](visit(x), visit(y))
            case ast.Call(func=ast.Name(id=name), args=[x], keywords=[]) if name in domain.functions:
                return domain.functions[name](visit(x))
        raise InvalidInput(f"{ast.unparse(node)!r} in the formula {text!r} cannot be read: {_ALLOWED}")

    return visit(_parse(text))


_ALLOWED = "use integers, the formula's own letters, + - * / **, sqrt() and factorial()"


@lru_cache(maxsize=4096)
def _parse(text: str) -> ast.expr:
    try:
        return ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError):
        raise InvalidInput(f"{text!r} is no formula: {_ALLOWED}") from None
