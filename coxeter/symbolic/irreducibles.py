"""Rational functions of d and d!, taken apart into positive factors that cannot be split further.

ZZ[d, d!] has unique factorisation: its irreducible elements are the prime numbers and the irreducible
polynomials without a common divisor of their coefficients. Which of them are positive is decided for every
integer d >= low at once: substitute d = n + a and d! = n! + b; where the coefficients are all of one sign,
so are the values for all a, b >= 0, and before such an n there are only finitely many d to look at.
"""

from __future__ import annotations

from functools import lru_cache
from math import factorial
from typing import Any

from sympy import QQ, ZZ, Symbol, factorint
from sympy.polys.fields import field

from ..errors import Undecided

FIELD, D, FACTORIAL = field([Symbol("d"), Symbol("factorial(d)")], ZZ)
RATIONAL_RING = FIELD.to_ring().clone(domain=QQ)

Element = Any
"""A rational function: an element of `FIELD`."""
Polynomial = Any
"""An element of ZZ[d, d!]."""

STEPS = 64
"""So many dimensions are looked at one by one before a sign is given up as undecided."""
LARGEST_PRIME = 10**6
"""So far trial division goes; a larger rest stays in one piece, as if it were prime."""


@lru_cache(maxsize=4096)
def signs(p: Polynomial, low: int) -> tuple[int, ...]:
    """The signs of a polynomial for d = low, low + 1, …; the last of them is that for all larger d.

    Raises
    ------
    Undecided
        If the sign has not settled after `STEPS` dimensions.

    Examples
    --------
    >>> signs((D - 3).numer, 1), signs((D**2 - D + 1).numer, 1)
    ((-1, -1, 0, 1), (1,))
    """
    found = []
    for n in range(low, low + STEPS):
        moves = [(D.numer, D.numer + n), (FACTORIAL.numer, FACTORIAL.numer + factorial(n))]
        moved = p.compose(moves)
        value = moved.coeff(1)
        found.append((value > 0) - (value < 0))
        if not p or (value and len({c > 0 for c in moved.coeffs()}) == 1):
            return tuple(found)
    raise Undecided(f"the sign of {p} for d >= {low} is not clear")


def check_divisor(p: Polynomial, low: int) -> None:
    """Make sure that a polynomial does not vanish for any integer d >= low.

    Raises
    ------
    ZeroDivisionError
        If it does; the message names the least such d.
    Undecided
        If that is not clear.
    """
    found = signs(p, low)
    if 0 in found:
        raise ZeroDivisionError(f"the divisor {p} is 0 for d = {low + found.index(0)}")


@lru_cache(maxsize=4096)
def positive_factors(x: Element, low: int) -> tuple[tuple[Polynomial, int], ...]:
    """The irreducible factors of a positive rational function with their exponents.

    Raises
    ------
    Undecided
        Unless each factor is positive, or negative, for all integers d >= low, and so their product.

    Examples
    --------
    >>> positive_factors(12*D/(2*D + 2), 1)
    ((2, 1), (3, 1), (d, 1), (d + 1, -1))
    """
    powers: dict[Polynomial, int] = {}
    sign = 1
    for polynomial, direction in ((x.numer, 1), (x.denom, -1)):
        content, factors = polynomial.factor_list()
        sign *= 1 if content > 0 else -1
        primes = factorint(abs(int(content)), limit=LARGEST_PRIME)
        for prime, k in primes.items():
            powers[FIELD.ring(prime)] = direction * k
        for factor, k in factors:
            settled = set(signs(factor, low))
            if len(settled) > 1 or settled == {0}:
                raise Undecided(f"{factor} is not of one sign for all d >= {low}, so no root is taken of it")
            (s,) = settled
            powers[factor * s] = direction * k
            sign *= s**k
    if sign < 0:
        raise Undecided(f"{x} is negative, so no root is taken of it")
    return tuple(powers.items())


def as_integer(x: Element) -> int | None:
    """The integer that a constant rational function is, or None.

    >>> as_integer((D + 3) - D), as_integer(D), as_integer(FIELD(1) / 2)
    (3, None, None)
    """
    return int(x.numer.coeff(1)) if x.denom == 1 and x.numer.is_ground else None


@lru_cache(maxsize=4096)
def whole_part(exponent: Element) -> int:
    """The integer to split off: that below the constant term of the polynomial part.

    >>> whole_part((3 * D + 2) / (2 * D)), whole_part(D / 2 - 1)
    (1, -1)
    """
    numer, denom = (part.set_ring(RATIONAL_RING) for part in (exponent.numer, exponent.denom))
    constant = numer.div(denom)[0].coeff(1)
    return int(constant.numerator // constant.denominator)
