"""Exact real numbers: quotients of sums of square roots, and their roots.

Every length, radius, volume and quality of a simplex with rational squared edges is of the form
``(sum of q_i*sqrt(n_i) / sum of p_j*sqrt(m_j)) ** (1/k)``. `Surd` is that form and no more. Signs
are decided by ball arithmetic (Arb, through python-flint) refined until it separates, equality
algebraically; no floating-point number takes part.
"""

from __future__ import annotations

import math
import numbers
from fractions import Fraction
from functools import total_ordering
from typing import TYPE_CHECKING, Any, Union

import flint

from ..errors import InvalidInput
from . import sums
from .rationals import rational
from .rounding import decimal, rounded, scientific
from .sums import ONE, Terms, collect, negative, plus, precisions, times
from .writing import LATEX, PLAIN, write

if TYPE_CHECKING:
    import sympy

Exact = Union[int, Fraction, "Surd"]


@total_ordering
class Surd:
    """An exact real number ``(sum q_i*sqrt(n_i) / sum p_j*sqrt(m_j)) ** (1/index)``.

    Arithmetic with integers, fractions and other surds is exact, and so are comparisons; `float`
    and `decimal` round correctly, once. ``str`` prints a form that SymPy can read.

    Parameters
    ----------
    value
        A rational number, or another surd.

    Raises
    ------
    InexactInput, InvalidInput
        If the value is a float, or no rational number.

    Examples
    --------
    >>> x = sqrt(3) / 4
    >>> x, x * x, x < Surd("0.4331"), float(x)
    (sqrt(3)/4, 3/16, True, 0.4330127018922193)
    >>> 1 / (1 + sqrt(2))
    1/(1 + sqrt(2))
    >>> 1 / (1 + sqrt(2)) == sqrt(2) - 1
    True
    """

    __slots__ = ("den", "index", "num")
    num: Terms
    den: Terms
    index: int

    def __new__(cls, value: object = 0) -> Surd:
        if isinstance(value, Surd):
            return value
        q = rational(value)
        return cls._make(((1, q),) if q else (), ONE)

    @classmethod
    def _make(cls, num: Terms, den: Terms, index: int = 1) -> Surd:
        """Build the number in normal form: a single-term denominator is divided out."""
        if not den:
            raise ZeroDivisionError("division of a surd by zero")
        if len(den) == 1:
            n, q = den[0]
            num, den = times(num, ((n, 1 / (q * n)),)), ONE
        elif den != ONE:
            num, den = sums.reduce(num, den)
        if index > 1 and den == ONE and len(num) == 1:
            n, q = num[0]
            return cls._radical(q * q * n, 2 * index)
        self = object.__new__(cls)
        object.__setattr__(self, "num", num)
        object.__setattr__(self, "den", den)
        object.__setattr__(self, "index", index if num else 1)
        return self

    @classmethod
    def _radical(cls, q: Fraction, index: int) -> Surd:
        """``q ** (1/index)`` for a positive rational, with the least possible index."""
        for p in sums.prime_factors(index):
            while index % p == 0 and (root := sums.exact_root(q, p)) is not None:
                q, index = root, index // p
        if index <= 2:
            return sqrt(q) if index == 2 else cls(q)
        self = object.__new__(cls)
        object.__setattr__(self, "num", ((1, q),))
        object.__setattr__(self, "den", ONE)
        object.__setattr__(self, "index", index)
        return self

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a Surd is immutable")

    def __reduce__(self) -> tuple[Any, ...]:
        return (_rebuild, (self.num, self.den, self.index))

    # -- what it is -----------------------------------------------------------------------------

    @property
    def is_rational(self) -> bool:
        """Whether the number is rational."""
        return self.index == 1 and self.den == ONE and all(n == 1 for n, _ in self.num)

    def as_fraction(self) -> Fraction:
        """The number as a `Fraction`; raises `InvalidInput` if it is irrational."""
        if not self.is_rational:
            raise InvalidInput(f"{self} is irrational")
        return self.num[0][1] / self.den[0][1] if self.num else Fraction(0)

    def sign(self) -> int:
        """-1, 0 or 1, decided exactly."""
        return sums.sign(self.num) * sums.sign(self.den)

    def ball(self) -> flint.arb:
        """A ball that holds the number, as small as the precision that is set allows."""
        ball = sums.ball(self.num) / sums.ball(self.den)
        return ball if self.index == 1 else ball.root(self.index)

    # -- arithmetic -----------------------------------------------------------------------------

    def _plain(self, operation: str) -> Surd:
        if self.index > 1:
            raise InvalidInput(f"cannot {operation} {self}: only square roots can be added")
        return self

    def __add__(self, other: object) -> Surd:
        y = _operand(other)
        if y is None:
            return NotImplemented
        if not self.num or not y.num:
            return y if not self.num else self
        a, b = self._plain("add"), y._plain("add")
        if a.den == b.den:
            return Surd._make(plus(a.num, b.num), a.den)
        return Surd._make(plus(times(a.num, b.den), times(b.num, a.den)), times(a.den, b.den))

    __radd__ = __add__

    def __neg__(self) -> Surd:
        return Surd._make(negative(self._plain("negate").num), self.den)

    def __sub__(self, other: object) -> Surd:
        y = _operand(other)
        return NotImplemented if y is None else self + (-y)

    def __rsub__(self, other: object) -> Surd:
        return (-self) + other

    def __mul__(self, other: object) -> Surd:
        y = _operand(other)
        if y is None:
            return NotImplemented
        index = math.lcm(self.index, y.index)
        a, b = self._raised(index), y._raised(index)
        return Surd._make(times(a.num, b.num), times(a.den, b.den), index)

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Surd:
        y = _operand(other)
        return NotImplemented if y is None else self * y._inverse()

    def __rtruediv__(self, other: object) -> Surd:
        return self._inverse() * other

    def _inverse(self) -> Surd:
        return Surd._make(self.den, self.num, self.index)

    def _raised(self, index: int) -> Surd:
        """The plain surd whose ``index``-th root this number is."""
        if index > 1 and self.sign() < 0:
            raise InvalidInput(f"{self} is negative: it has no real root of index {index}")
        return _power(_rebuild(self.num, self.den, 1), index // self.index)

    def __pow__(self, exponent: object) -> Surd:
        if not isinstance(exponent, (int, Fraction)):
            return NotImplemented
        p, k = Fraction(exponent).as_integer_ratio()
        base = self if p >= 0 else self._inverse()
        plain = _rebuild(base.num, base.den, 1)
        power = Fraction(abs(p), k * self.index)
        return _power(plain, power.numerator).root(power.denominator)

    def root(self, index: int) -> Surd:
        """The real root of a non-negative number: ``x.root(3)`` is the cube root of x."""
        if not isinstance(index, int) or isinstance(index, bool) or index < 1:
            raise InvalidInput(f"{index!r} is no index of a root: give an integer >= 1")
        if index == 1 or not self.num:
            return self
        if self.sign() < 0:
            raise InvalidInput(f"{self} is negative: it has no real root of index {index}")
        return Surd._make(self.num, self.den, self.index * index)

    def __abs__(self) -> Surd:
        return -self if self.sign() < 0 else self

    # -- comparison -----------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        y = _operand(other)
        if y is None:
            return NotImplemented
        if self.sign() != y.sign():
            return False
        index = math.lcm(self.index, y.index)
        a, b = self._raised(index), y._raised(index)
        return plus(times(a.num, b.den), negative(times(b.num, a.den))) == ()

    def __lt__(self, other: object) -> bool:
        y = _operand(other)
        if y is None:
            return NotImplemented
        if self == y:
            return False
        for precision in precisions():
            with flint.ctx.workprec(precision):
                difference = self.ball() - y.ball()
                if difference < 0:
                    return True
                if difference > 0:
                    return False
        raise AssertionError("unreachable")

    def __hash__(self) -> int:
        return hash(self.as_fraction()) if self.is_rational else hash(self.scientific())

    def __bool__(self) -> bool:
        return bool(self.num)

    # -- decimals: rounded once, at the edge ------------------------------------------------------

    def __float__(self) -> float:
        return rounded(self, float)

    def decimal(self, digits: int = 3) -> str:
        """The correctly rounded decimal with that many digits after the point.

        >>> sqrt(2).decimal(5), Surd("2/3").decimal()
        ('1.41421', '0.667')
        """
        return decimal(self, digits)

    def scientific(self, digits: int = 17) -> str:
        """The value in scientific notation, correctly rounded: for numbers beyond float's range.

        >>> (sqrt(2) / 10**400).scientific(6)
        '1.41421e-400'
        """
        return scientific(self, digits)

    # -- printing -------------------------------------------------------------------------------

    def __repr__(self) -> str:
        return write(self.num, self.den, self.index, PLAIN)

    def latex(self) -> str:
        r"""The number as LaTeX.

        >>> (sqrt(3) / 4).latex()
        '\\frac{\\sqrt{3}}{4}'
        """
        return write(self.num, self.den, self.index, LATEX)

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"

    def _sympy_(self) -> sympy.Expr:
        return self.sympy()  # what SymPy asks for when the two are mixed

    def sympy(self) -> sympy.Expr:
        """The number as a SymPy expression."""
        import sympy

        def value(terms: Terms) -> sympy.Expr:
            return sympy.Add(*(sympy.Rational(q.numerator, q.denominator) * sympy.sqrt(n) for n, q in terms))

        return (value(self.num) / value(self.den)) ** sympy.Rational(1, self.index)


def sqrt(value: object) -> Surd:
    """The exact square root of a non-negative rational number or surd.

    >>> sqrt("8/9")
    2*sqrt(2)/3
    """
    if hasattr(value, "root") and not getattr(value, "is_rational", False):  # so too of a formula
        root: Surd = value.root(2)
        return root
    q = rational(value)
    if q < 0:
        raise InvalidInput(f"{q} is negative: it has no real square root")
    return Surd._make(collect([(q.numerator * q.denominator, Fraction(1, q.denominator))]), ONE)


def _operand(value: object) -> Surd | None:
    if isinstance(value, Surd):
        return value
    if isinstance(value, numbers.Rational) and not isinstance(value, bool):
        return Surd(value)
    return None


def _power(x: Surd, k: int) -> Surd:
    """The k-th power of a plain surd, k >= 0."""
    return Surd._make(sums.power(x.num, k), sums.power(x.den, k))


def _rebuild(num: Terms, den: Terms, index: int) -> Surd:
    return Surd._make(num, den, index)
