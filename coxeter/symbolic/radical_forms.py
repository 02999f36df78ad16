"""Sums of rational functions times powers: what formulas with roots are brought to.

A form is a sum of terms ``c · b₁^e₁ · b₂^e₂ ⋯``: c is a rational function of d and d!, the bases are primes
and irreducible polynomials that are positive for all d in question, the exponents rational functions of d,
reduced until their constant term is in [0, 1).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from ..errors import InvalidInput, Undecided
from ..exact import Surd
from ..families import evaluate, expression
from .irreducibles import (
    FACTORIAL,
    FIELD,
    Element,
    Polynomial,
    as_integer,
    check_divisor,
    positive_factors,
    whole_part,
)

Key = frozenset[tuple[Polynomial, Element]]
"""The powers of a term: pairs (base, exponent)."""

LARGEST_POWER = 200

_HALF = FIELD(1) / 2
NO_POWERS: Key = frozenset()


@dataclass(frozen=True, eq=False, repr=False)
class Form:
    """A formula in normal form; make one with `radicals.normal_form`.

    Two forms are equal if their terms are; they then have the same value for every integer d from the
    larger of their `low` on.

    Attributes
    ----------
    terms
        The rational coefficient of each product of powers; none is zero.
    low
        The least d for which the form has been justified.
    """

    terms: Mapping[Key, Element]
    low: int = 1

    def __eq__(self, other: object) -> bool:
        return self.terms == other.terms if isinstance(other, Form) else NotImplemented

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __add__(self, other: Form | Fraction | int) -> Form:
        y = _form(other)
        return collect((*self.terms.items(), *y.terms.items()), max(self.low, y.low))

    def __neg__(self) -> Form:
        return Form({key: -c for key, c in self.terms.items()}, self.low)

    def __sub__(self, other: Form | Fraction | int) -> Form:
        return self + -_form(other)

    def __mul__(self, other: Form | Fraction | int) -> Form:
        y = _form(other)
        products = (
            _term(c * e, (*key, *more)) for key, c in self.terms.items() for more, e in y.terms.items()
        )
        return collect(products, max(self.low, y.low))

    def __truediv__(self, other: Form | Fraction | int) -> Form:
        y = _form(other)
        return self * Form(y.terms, max(self.low, y.low)).inverse()

    def inverse(self) -> Form:
        """One over the form; sums are cleared of their square roots one after the other.

        Raises
        ------
        ZeroDivisionError
            If the form vanishes for some integer d >= low.
        Undecided
            If that is not clear, or if there are several terms that differ by other roots than square ones.

        Examples
        --------
        >>> from coxeter.symbolic.radicals import normal_form
        >>> normal_form("1 + sqrt(d + 1)").inverse()
        sqrt(d + 1)/d - 1/d
        """
        if not self.terms:
            raise ZeroDivisionError("the divisor is 0 for every d")
        if len(self.terms) == 1:
            ((key, c),) = self.terms.items()
            check_divisor(c.numer, self.low)
            return collect([_term(1 / c, [(base, -e) for base, e in key])], self.low)
        for conjugate in self.conjugates():
            try:
                return conjugate * (self * conjugate).inverse()
            except ZeroDivisionError as zero:  # of the form or only of its conjugate: that is not clear
                raise Undecided(f"{self} may be 0: {zero}") from None
        raise Undecided(f"no conjugate of {self} is known")

    def conjugates(self) -> Iterator[Form]:
        """The form with the sign of one square root changed, for each root that some of its terms have.

        The product of both is free of that root.
        """
        bases = {base for key in self.terms for base, _ in key}
        for base in sorted(bases, key=str):
            exponents = {key: dict(key).get(base, FIELD(0)) for key in self.terms}
            different = set(exponents.values())
            if len(different) == 2 and different.pop() - (e := different.pop()) in (_HALF, -_HALF):
                yield Form({k: c if exponents[k] == e else -c for k, c in self.terms.items()}, self.low)

    def __pow__(self, exponent: Form | Fraction | int) -> Form:
        """A power: any one of a single term, an integer one of a sum."""
        e = _form(exponent)
        q, low = e.as_rational_function(), max(self.low, e.low)
        n = as_integer(q)
        if n is not None:
            return Form(self.terms, low)._integer_power(n)
        if FACTORIAL.numer in _generators(q):
            raise Undecided(f"the exponent {q} is no rational function of d")
        if len(self.terms) != 1:
            raise Undecided(f"no root of {self} is taken: it is not a single term")
        ((key, c),) = self.terms.items()
        powers = [(base, k * q) for base, k in positive_factors(c, low)]
        return collect([_term(FIELD(1), (*powers, *((base, f * q) for base, f in key)))], low)

    def _integer_power(self, n: int) -> Form:
        _check_size(n)
        if n < 0:
            return self.inverse()._integer_power(-n)
        if len(self.terms) == 1:
            ((key, c),) = self.terms.items()
            return collect([_term(c**n, [(base, n * e) for base, e in key])], self.low)
        result = Form({NO_POWERS: FIELD(1)}, self.low)
        for _ in range(n):
            result *= self
        return result

    def as_rational_function(self) -> Element:
        """The form as an element of the field `FIELD`; raises `Undecided` if it has roots or powers."""
        if self.terms.keys() - {NO_POWERS}:
            raise Undecided(f"{self} is no rational function of d")
        return self.terms.get(NO_POWERS, FIELD(0))

    def at(self, d: int) -> Surd:
        """The exact value in a dimension, d >= low.

        >>> from coxeter.symbolic.radicals import normal_form
        >>> normal_form("sqrt(8*d)").at(3)
        2*sqrt(6)
        """
        if d < self.low:
            raise InvalidInput(f"the form has been justified from d = {self.low} on, not for d = {d}")
        return evaluate(str(self), d=d)

    def __str__(self) -> str:
        terms = sorted((_write(key, c) for key, c in self.terms.items()), key=lambda t: (t[0] == "-", t))
        return " + ".join(terms).replace("+ -", "- ") or "0"

    __repr__ = __str__

    def latex(self) -> str:
        r"""The form in LaTeX.

        >>> from coxeter.symbolic.radicals import normal_form
        >>> print(normal_form("(d + 1)**(1 + 1/d)/2").latex())
        \frac{\left(d + 1\right) \left(d + 1\right)^{\frac{1}{d}}}{2}
        """
        import sympy

        return str(sympy.latex(expression(str(self))))


# -- terms -------------------------------------------------------------------------------------------


def _form(x: Form | Fraction | int) -> Form:
    if isinstance(x, Form):
        return x
    return collect([(NO_POWERS, FIELD(x.numerator) / FIELD(x.denominator))], 1)


def collect(terms: Iterable[tuple[Key, Element]], low: int) -> Form:
    """Add up the terms with the same powers."""
    total: dict[Key, Element] = {}
    for key, c in terms:
        total[key] = total[key] + c if key in total else c
    return Form({key: c for key, c in total.items() if c}, low)


def _term(c: Element, powers: Iterable[tuple[Polynomial, Element]]) -> tuple[Key, Element]:
    """A product of powers with reduced exponents: whole powers go to the coefficient."""
    exponents: dict[Polynomial, Element] = {}
    for base, e in powers:
        exponents[base] = exponents[base] + e if base in exponents else e
    for base, e in exponents.items():
        if n := whole_part(e):
            _check_size(n)
            c *= FIELD(base) ** n
            exponents[base] = e - n
    return frozenset((base, e) for base, e in exponents.items() if e), c


def _check_size(n: int) -> None:
    if abs(n) > LARGEST_POWER:
        raise Undecided(f"the exponent {n} is beyond {LARGEST_POWER}")


def _generators(x: Element) -> set[Polynomial]:
    """The letters that occur in a rational function."""
    monomials = (*x.numer.monoms(), *x.denom.monoms())
    return {g for i, g in enumerate(FIELD.ring.gens) if any(m[i] for m in monomials)}


# -- writing -----------------------------------------------------------------------------------------


def _write(key: Key, c: Element) -> str:
    """A term as text that can be read again; bases with the same exponent share a root."""
    shared: dict[Element, list[str]] = {}
    for base, e in key:
        shared.setdefault(e, []).append(str(base))
    powers = sorted(_write_power(sorted(bases, key=_order), e) for e, bases in shared.items())
    top, bottom = _write_factors(c.numer), _write_factors(c.denom)
    sign = "-" if c.numer.LC < 0 else ""
    text = sign + ("*".join([*top, *powers]) or "1")
    if not bottom:
        return str(c) if not powers and len(c.numer.factor_list()[1]) < 2 else text
    return f"{text}/{bottom[0]}" if len(bottom) == 1 else f"{text}/({'*'.join(bottom)})"


def _write_factors(p: Polynomial) -> list[str]:
    """The factors of a polynomial, without its sign."""
    content, factors = p.factor_list()
    number = [str(abs(content))] if abs(content) != 1 else []
    return number + [_group(str(factor)) + (f"**{k}" if k > 1 else "") for factor, k in factors]


def _write_power(bases: list[str], e: Element) -> str:
    product = bases[0] if len(bases) == 1 else "*".join(map(_group, bases))
    return f"sqrt({product})" if e == _HALF else f"{_group(product)}**{_group(str(e))}"


def _group(text: str) -> str:
    return text if text.isalnum() or text == str(FACTORIAL) else f"({text})"


def _order(text: str) -> tuple[bool, int, str]:
    return not text.isdigit(), len(text), text
