"""Equality, for every d, of formulas with roots, powers and factorials.

A formula is brought to a normal form: a sum of terms, each a rational function of d and d! times powers of
primes and irreducible polynomials that are positive for all d in question. Each step is an identity between
real numbers, so formulas with the same normal form are equal for every d. Different normal forms do not
prove a difference: for that a dimension is shown.
"""

from __future__ import annotations

import math
import re
from contextlib import suppress
from fractions import Fraction
from functools import lru_cache
from typing import Any

from ..errors import InvalidInput, Undecided
from ..exact import Surd
from ..families import evaluate
from ..families.reading import Domain, read
from .irreducibles import FACTORIAL, FIELD, D, Element, as_integer
from .radical_forms import LARGEST_POWER, NO_POWERS, Form, collect

LARGEST_SHIFT = 12
"""So many dimensions at the beginning may be settled by evaluation, where no normal form holds for them."""
SEARCHED = 41
"""Dimensions in which two formulas are compared before the search for a difference is given up."""


@lru_cache(maxsize=4096, typed=True)
def normal_form(text: str, low: int = 1) -> Form:
    """The normal form of a formula in d, for all integers d >= low.

    Parameters
    ----------
    text
        Integers and d, ``+ - * / **``, ``sqrt`` and ``factorial``; exponents may contain d.
    low
        The least d, at least 1.

    Raises
    ------
    InvalidInput
        If the text is no such formula.
    ZeroDivisionError
        If it divides by what is 0 for some integer d >= low.
    Undecided
        If it has no normal form: a root of a sum of roots, say, or of what may be negative.

    Examples
    --------
    >>> normal_form("sqrt(d**3 + 2*d**2 + d)/sqrt(2)")
    (d + 1)*sqrt(2*d)/2
    >>> normal_form("(d + 1)**((d + 1)/2)") == normal_form("sqrt(d + 1)*sqrt((d + 1)**d)")
    True
    """
    if type(low) is not int or low < 1:
        raise InvalidInput(f"{low!r} is no dimension to begin with: give an integer >= 1")

    def form(x: Element | int) -> Form:
        return collect([(NO_POWERS, FIELD(x))], low)

    functions = {"sqrt": _root, "factorial": lambda x: form(_factorial(x))}
    domain = Domain(number=form, letter=form, power=lambda x, e: x**e, functions=functions)
    result: Form = read(text, domain, {"d": D})
    return result


def equal_for_every_d(a: str, b: str, low: int = 1, parity: str | None = None) -> bool:
    """Whether two formulas have the same value for every integer d >= low, of a parity if one is given.

    True is a proof: their normal forms are equal, but for at most a few d at the beginning, for which they
    have been evaluated. False is one too: `first_difference` names a d. Formulas are different where just
    one of them divides by zero.

    Raises
    ------
    InvalidInput
        If a text is no formula, or the parity is neither ``"odd"`` nor ``"even"``.
    Undecided
        If neither is proved, or if both divide by zero for some d.

    Examples
    --------
    >>> equal_for_every_d("sqrt(d + 1)**(1 + 2/d)", "(d + 1)**(1/2 + 1/d)")
    True
    >>> equal_for_every_d("sqrt(2/d)", "sqrt(2/(d + 1))", low=3, parity="odd")
    False
    """
    start = _equal_from(a, b, low)
    if start is not None:
        answers = [_same(a, b, d) for d in _dimensions(low, parity) if d < start]
        if all(answers):
            return True
        if False in answers:
            return False
        raise Undecided(f"for d < {start} some value of {a} or {b} is missing: give a larger low")
    if first_difference(a, b, low, parity) is not None:
        return False
    raise Undecided(f"the normal forms of {a} and {b} are not equal, but no d shows a difference")


def first_difference(a: str, b: str, low: int = 1, parity: str | None = None) -> int | None:
    """The least d from low to low + 40 for which two formulas differ; None if there is none.

    Values that cannot be computed exactly are passed over. Raises `InvalidInput` as `equal_for_every_d`.

    >>> first_difference("sqrt(d)/2", "1", low=3), first_difference("d**2 - 16", "d - 4", low=4)
    (3, 5)
    """
    for text in (a, b):
        with suppress(Undecided, ZeroDivisionError):
            normal_form(text, low)  # refuses what cannot be read
    return next((d for d in _dimensions(low, parity) if _same(a, b, d) is False), None)


def substitute(text: str, **letters: str) -> str:
    """A formula with formulas for some of its letters.

    >>> substitute("h/(2*R)", h="1/sqrt(2)", R="sqrt(d)/4")
    '(1/sqrt(2))/(2*(sqrt(d)/4))'
    """
    return re.sub(r"\b[A-Za-z_]\w*\b", lambda m: f"({letters[m[0]]})" if m[0] in letters else m[0], text)


def _equal_from(a: str, b: str, low: int) -> int | None:
    """The first d, near low, from which on both have a normal form, if that is the same one."""
    for start in range(low, low + LARGEST_SHIFT):
        with suppress(Undecided, ZeroDivisionError):
            return start if normal_form(a, start) == normal_form(b, start) else None
    return None


def _dimensions(low: int, parity: str | None) -> range:
    if parity not in ("odd", "even", "", None):
        raise InvalidInput(f"{parity!r} is no parity: give 'odd' or 'even'")
    wrong = parity and (low % 2 == 1) != (parity == "odd")
    return range(low + bool(wrong), low + SEARCHED, 2 if parity else 1)


def _same(a: str, b: str, d: int) -> bool | None:
    """Whether two formulas have the same value for one d; None if that is not known."""
    values: list[Surd | None] = []
    for text in (a, b):
        try:
            values.append(evaluate(text, d=d))
        except ZeroDivisionError:
            values.append(None)
        except ValueError:  # a root of a negative number, or a sum that surds do not have
            return None
    return None if values == [None, None] else None not in values and values[0] == values[1]


# -- functions ---------------------------------------------------------------------------------------


def _root(x: Form) -> Form:
    return x ** Fraction(1, 2) if x else x


def _factorial(x: Form) -> Element:
    """d!, also (d + n)! for a small integer n, and that of an integer."""
    q = x.as_rational_function()
    n, shift = as_integer(q), as_integer(q - D)
    if n is not None and 0 <= n <= LARGEST_POWER:
        return FIELD(math.factorial(n))
    if shift is None or abs(shift) > LARGEST_POWER or x.low + shift < 0:
        raise Undecided(f"factorial({q}) is not reduced to factorial(d)")
    above: Any = math.prod((D + i for i in range(1, shift + 1)), start=FIELD(1))
    below: Any = math.prod((D - i for i in range(-shift)), start=FIELD(1))
    return FACTORIAL * above / below
