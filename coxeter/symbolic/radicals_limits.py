"""How formulas with roots grow with d: c·d^q in the limit, and exact limits."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from ..errors import InvalidInput, Undecided
from ..exact import Surd
from .irreducibles import FACTORIAL, D, Element, Polynomial
from .radical_forms import Form, Key
from .radicals import normal_form

LATE = 10_000
"""A limit depends on large d only, so a formula need make sense from this d on."""


@dataclass(frozen=True)
class Growth:
    """A formula divided by ``coefficient·d**degree`` tends to 1 (a formula that is 0 has coefficient 0)."""

    coefficient: Surd
    degree: Fraction


def limit(text: str) -> Surd:
    """The exact limit of a formula for d → ∞.

    Raises
    ------
    InvalidInput
        If it is no formula in d, or has no limit because it grows like a power of d.
    Undecided
        If its growth is not found; see `growth`.

    Examples
    --------
    >>> limit("sqrt(d)*2*sqrt(d)/(d + 1)"), limit("d**2*(sqrt(1 + 24/(d*(d + 2))) - 1)")
    (2, 12)
    """
    found = growth(text)
    if found.coefficient and found.degree > 0:
        raise InvalidInput(f"{text!r} has no limit: it grows like {found.coefficient}*d**({found.degree})")
    return found.coefficient if found.degree == 0 else Surd(0)


def growth(text: str) -> Growth:
    """The power of d that a formula grows like, and its constant.

    Each term grows like a power: d^(1/d) and 2^(1/d) tend to 1. If the largest terms cancel, the sum is
    multiplied and divided by one that differs in the sign of a square root, where they do not.

    Raises
    ------
    InvalidInput
        If it is no formula in d.
    Undecided
        For factorials and powers such as 2^d and d^d that do not cancel, or if no such sum is found.

    Examples
    --------
    >>> growth("sqrt(1 + 24/(d*(d + 2))) - 1")
    Growth(coefficient=12, degree=Fraction(-2, 1))
    """
    return _growth(normal_form(text, LATE))


def _growth(x: Form) -> Growth:
    if not x:
        return Growth(Surd(0), Fraction(0))
    if top := _largest(x):
        return top
    for conjugate in x.conjugates():
        if below := _largest(conjugate):
            above = _growth(x * conjugate)
            return Growth(above.coefficient / below.coefficient, above.degree - below.degree)
    raise Undecided(f"the largest terms of {x} cancel, and it is not clear what remains")


def _largest(x: Form) -> Growth | None:
    """The growth of a sum if its largest terms do not cancel."""
    try:
        terms = [_term_growth(key, c) for key, c in x.terms.items()]
        degree = max(term.degree for term in terms)
        largest = [term.coefficient for term in terms if term.degree == degree]
        coefficient = sum(largest[1:], largest[0])
    except InvalidInput as refused:  # surds have no sums of higher roots, and no negative ones
        raise Undecided(f"the growth of {x} is not found: {refused}") from None
    return Growth(coefficient, degree) if coefficient else None


def _term_growth(key: Key, c: Element) -> Growth:
    coefficient, degree = Surd(1), Fraction(0)
    for base, e in ((c.numer, 1), (c.denom, -1), *key):
        q = Fraction(e) if isinstance(e, int) else _limit_of_exponent(e)
        leading, n = _leading(base)
        coefficient, degree = coefficient * _power(leading, q), degree + n * q
    return Growth(coefficient, degree)


def _power(n: int, q: Fraction) -> Surd:
    return Surd(n) ** q if n > 0 else Surd(Fraction(n) ** int(q))


def _limit_of_exponent(e: Element) -> Fraction:
    """An exponent q + r with r → 0 at least like 1/d: then d^r → 1."""
    (a, n), (b, m) = _leading(e.numer), _leading(e.denom)
    if n > m:
        raise Undecided(f"a power with the exponent {e} does not grow like a power of d")
    return Fraction(a, b) if n == m else Fraction(0)


def _leading(p: Polynomial) -> tuple[int, int]:
    """The leading coefficient of a polynomial in d, and its degree."""
    if p.degree(FACTORIAL.numer) > 0:
        raise Undecided("a factorial that does not cancel does not grow like a power of d")
    return int(p.LC), int(p.degree(D.numer))
