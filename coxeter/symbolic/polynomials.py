"""Rational functions in d and indices, over the rationals with √2 adjoined.

They are elements of SymPy's field of fractions QQ(w, d, k, …); w stands for √2, and numerators are
reduced by w² = 2 before they are looked at.
"""

from __future__ import annotations

import ast
from fractions import Fraction
from functools import lru_cache
from typing import Any

from sympy import QQ
from sympy.polys.fields import field

from ..errors import InvalidInput
from ..exact import Surd, sqrt
from ..families.reading import Domain, read

LETTERS = ("d", "k", "j", "m", "t", "i", "a", "b", "c", "e")
"""The dimension, indices, the number of a coordinate, and the non-negative parameters of a range."""

FIELD, *_GENERATORS = field(",".join(("w", *LETTERS)), QQ)
W = _GENERATORS[0]
SYMBOLS = dict(zip(LETTERS, _GENERATORS[1:], strict=True))

Rational = Any
"""An element of `FIELD`."""


@lru_cache(maxsize=4096)
def rational_function(text: str) -> Rational:
    """Read a formula: the letters, integers, ``+ - * /``, integer powers and ``sqrt(2)``.

    >>> rational_function("(d + 1)**2/(d + 1)")
    d + 1
    """
    return read(text, _DOMAIN, SYMBOLS)


@lru_cache(maxsize=4096)
def divisors(text: str) -> tuple[str, ...]:
    """What a formula divides by, numbers left out: it makes sense only where none of them vanishes.

    >>> divisors("d/(d + 1) - (k/2)**-1")
    ('d + 1', 'k / 2')
    """
    nodes = [node for node in ast.walk(ast.parse(text.strip(), mode="eval")) if isinstance(node, ast.BinOp)]
    below = [node.right for node in nodes if isinstance(node.op, ast.Div)]
    below += [x.left for x in nodes if isinstance(x.op, ast.Pow) and isinstance(x.right, ast.UnaryOp)]
    return tuple(ast.unparse(node) for node in below if not isinstance(node, ast.Constant))


def letters_of(x: Rational) -> set[str]:
    """The letters that occur in a rational function.

    >>> sorted(letters_of(rational_function("k/(d + 1)")))
    ['d', 'k']
    """
    return {
        letter
        for polynomial in (x.numer, x.denom)
        for exponents in coefficients(polynomial)
        for letter, exponent in zip(LETTERS, exponents, strict=True)
        if exponent
    }


def _power(base: Rational, exponent: Rational) -> Rational:
    if exponent.denom != 1 or not exponent.numer.is_ground:
        raise InvalidInput(f"the exponent {exponent} is no integer: a rational function has no such power")
    return base ** int(exponent.numer.LC if exponent else 0)


def _sqrt(x: Rational) -> Rational:
    if x != 2:
        raise InvalidInput(f"sqrt({x}) is no rational function over QQ(sqrt(2))")
    return W


_DOMAIN = Domain(number=lambda n: FIELD(n), letter=lambda x: x, power=_power, functions={"sqrt": _sqrt})


def reduced(polynomial: Any) -> Any:
    """A polynomial with w² replaced by 2."""
    return polynomial.rem(W.numer**2 - 2)


def is_zero(x: Rational) -> bool:
    """Whether a rational function vanishes identically.

    >>> is_zero(rational_function("sqrt(2)**2 - 2"))
    True
    """
    return bool(reduced(x.numer) == 0)


@lru_cache(maxsize=4096)
def coefficients(polynomial: Any) -> dict[tuple[int, ...], tuple[Fraction, Fraction]]:
    """The coefficients p + q·√2 of a polynomial, as pairs (p, q), by the exponents of the letters."""
    found: dict[tuple[int, ...], tuple[Fraction, Fraction]] = {}
    for (w, *exponents), coefficient in reduced(polynomial).terms():
        p, q = found.get(tuple(exponents), (Fraction(0), Fraction(0)))
        value = Fraction(int(coefficient.numerator), int(coefficient.denominator))
        found[tuple(exponents)] = (p, q + value) if w else (p + value, q)
    return found


def sign_of(p: Fraction, q: Fraction) -> int:
    """The sign of p + q·√2.

    >>> sign_of(Fraction(3), Fraction(-2)), sign_of(Fraction(-7), Fraction(5))
    (1, 1)
    """
    signs = {(p > 0) - (p < 0), (q > 0) - (q < 0)} - {0}
    if len(signs) < 2:
        return signs.pop() if signs else 0
    return (1 if p > 0 else -1) * (1 if p * p > 2 * q * q else -1)


def value(x: Rational, **letters: int) -> Surd:
    """The number that a rational function takes for given letters.

    >>> value(rational_function("1/(d + sqrt(2))"), d=1)
    1/(1 + sqrt(2))
    """

    def number(polynomial: Any) -> tuple[Fraction, Fraction]:
        rational = irrational = Fraction(0)
        for exponents, (p, q) in coefficients(polynomial).items():
            product = 1
            for letter, exponent in zip(LETTERS, exponents, strict=True):
                product *= letters[letter] ** exponent if exponent else 1
            rational, irrational = rational + p * product, irrational + q * product
        return rational, irrational

    (a, b), (p, q) = number(x.numer), number(x.denom)
    if not b and not q:
        return Surd(a / p)
    return (a + b * sqrt(2)) / (p + q * sqrt(2))
