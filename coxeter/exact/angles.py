"""Angles, exactly: quotients of rational combinations of arccosines over π.

An angle of a simplex is the arccosine of a root, and a solid angle of a triangle or a tetrahedron a sum of
such angles. `Angle` is that form. The solid angle of the regular d-simplex has none from d = 4 on; it is
known by an integral, which ball arithmetic encloses (`regular_share`).
"""

from __future__ import annotations

import numbers
from fractions import Fraction
from functools import total_ordering

import flint

from ..errors import InvalidInput, Undecided
from .angle_sums import LARGEST_PRECISION, ONE, Sum, ball, multiple, plus, precisions, sign, simplified, times
from .rounding import decimal, rounded, scientific
from .surd import Surd

RATIONAL = {
    Fraction(four): Fraction(*over_pi)
    for four, over_pi in {0: (1, 2), 1: (1, 3), 2: (1, 4), 3: (1, 6), 4: (0, 1)}.items()
}
"""4·cos² -> the angle over π, cos >= 0: with a rational cos² no other angle is rational (Niven)."""


@total_ordering
class Angle:
    """A quotient of two sums of rational multiples of 1 and of arccosines over π; make one with `arccos`.

    Sums, rational multiples and quotients are exact. Signs and comparisons are decided: a sum of arccosines
    vanishes only if the product of the complex numbers at these angles is 1.

    Raises
    ------
    Undecided
        If two quotients agree to more than a thousand digits, and nothing shows that they are equal.

    Examples
    --------
    >>> third, regular = arccos(Surd("1/2")), arccos(Surd("1/3"))
    >>> third, 180 * regular, third < regular, (180 * regular).decimal(3)
    (1/3, 180*acos(1/3)/pi, True, '70.529')
    >>> from coxeter.exact import sqrt
    >>> arccos(Surd("1/3")) + 2 * arccos(sqrt("1/3"))  # 70.529° + 2·54.736°
    1
    """

    __slots__ = ("den", "num")
    num: Sum
    den: Sum

    def __init__(self, num: Sum, den: Sum = ONE) -> None:
        num, den = simplified(num), simplified(den)
        if not den:
            raise ZeroDivisionError("division of an angle by zero")
        if factor := multiple(num, den):
            num, den = {None: factor}, ONE
        elif den.keys() == {None}:
            num, den = {a: q / den[None] for a, q in num.items()}, ONE
        object.__setattr__(self, "num", num)
        object.__setattr__(self, "den", den)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("an Angle is immutable")

    def __reduce__(self) -> tuple[object, ...]:
        return (Angle, (dict(self.num), dict(self.den)))

    # -- what it is -----------------------------------------------------------------------------

    @property
    def is_rational(self) -> bool:
        """Whether the value is known to be rational."""
        return self.num.keys() <= {None} and self.den.keys() == {None}

    def as_fraction(self) -> Fraction:
        """The value as a `Fraction`; raises `InvalidInput` if it is not known to be rational."""
        if not self.is_rational:
            raise InvalidInput(f"{self} is not known to be rational")
        return self.num.get(None, Fraction(0))

    def sign(self) -> int:
        """-1, 0 or 1, decided."""
        return sign(self.num) * sign(self.den)

    def ball(self) -> flint.arb:
        """A ball that holds the value, as small as the precision that is set allows."""
        return ball(self.num) / ball(self.den)

    # -- arithmetic -----------------------------------------------------------------------------

    def __add__(self, other: object) -> Angle:
        y = _operand(other)
        if y is None:
            return NotImplemented
        if self.den != y.den:
            raise InvalidInput(f"cannot add {self} and {y}: their denominators differ")
        return Angle(plus(self.num, y.num), self.den)

    __radd__ = __add__

    def __neg__(self) -> Angle:
        return self * -1

    def __sub__(self, other: object) -> Angle:
        y = _operand(other)
        return NotImplemented if y is None else self + (-y)

    def __rsub__(self, other: object) -> Angle:
        return (-self) + other

    def __mul__(self, other: object) -> Angle:
        y = _operand(other)
        if y is None:
            return NotImplemented
        if y.is_rational:
            return Angle(times(self.num, y.as_fraction()), self.den)
        if self.is_rational:
            return y * self
        raise InvalidInput(f"cannot multiply {self} and {y}: only rational multiples are exact")

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Angle:
        y = _operand(other)
        if y is None:
            return NotImplemented
        if y.is_rational:
            return self * (1 / y.as_fraction())
        if self.is_rational:
            return Angle(times(y.den, self.as_fraction()), y.num)
        if self.den != ONE or y.den != ONE:
            raise InvalidInput(f"cannot divide {self} by {y}: one of them is a quotient already")
        return Angle(self.num, y.num)

    def __rtruediv__(self, other: object) -> Angle:
        y = _operand(other)
        return NotImplemented if y is None else y / self

    # -- comparison -----------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        y = _operand(other)
        return NotImplemented if y is None else _compare(self, y) == 0

    def __lt__(self, other: object) -> bool:
        y = _operand(other)
        return NotImplemented if y is None else _compare(self, y) < 0

    def __hash__(self) -> int:
        return hash(self.as_fraction() if self.is_rational else self.scientific(17))

    def __bool__(self) -> bool:
        return self.sign() != 0

    # -- decimals and text ----------------------------------------------------------------------

    def __float__(self) -> float:
        return rounded(self, float)

    def decimal(self, digits: int = 3) -> str:
        """The correctly rounded decimal with that many digits after the point."""
        return decimal(self, digits)

    def scientific(self, digits: int = 17) -> str:
        """The value in scientific notation, correctly rounded."""
        return scientific(self, digits)

    def __abs__(self) -> Angle:
        return -self if self.sign() < 0 else self

    def __repr__(self) -> str:
        top = _write(self.num, _ACOS, _SHARE, "*", "{}")
        return top if self.den == ONE else f"({top})/({_write(self.den, _ACOS, _SHARE, '*', '{}')})"

    def latex(self) -> str:
        r"""The value as LaTeX.

        >>> arccos(Surd("1/3")).latex()
        '\\frac{1}{\\pi}\\arccos\\left(\\frac{1}{3}\\right)'
        """
        style = (r"\frac{{1}}{{\pi}}\arccos\left({}\right)", r"\omega_{{{}}}", r"\cdot ", "latex")
        top = _write(self.num, *style)
        return top if self.den == ONE else rf"\frac{{{top}}}{{{_write(self.den, *style)}}}"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"


_ACOS, _SHARE = "acos({})/pi", "regular_share({})"


def arccos(cosine: Surd) -> Angle:
    """The arccosine of a number with a rational square, over π.

    Raises
    ------
    InvalidInput
        If the number is no cosine, or its square is irrational.

    Examples
    --------
    >>> from coxeter.exact import sqrt
    >>> arccos(-sqrt(2) / 2), arccos(Surd("-1/3"))
    (3/4, 1 - acos(1/3)/pi)
    """
    square = cosine * cosine
    if not square.is_rational or square > 1:
        raise InvalidInput(f"{cosine} is no cosine of an angle here: give a root of a rational, at most 1")
    if cosine.sign() < 0:
        return 1 - arccos(-cosine)
    if (found := RATIONAL.get(4 * square.as_fraction())) is not None:
        return Angle({None: found})
    return Angle({cosine: Fraction(1)})


def regular_share(d: int) -> Angle:
    """The solid angle at a vertex of the regular d-simplex, as a share of the whole sphere.

    For d = 2 and 3 it is a sum of dihedral angles. From d = 4 on it is
    ``√((d+1)/2π) ∫ Φ(is)^d e^(-(d+1)s²/2) ds``, Φ the normal distribution: the probability that d normal
    variables with all correlations -1/d are positive. Source: C. A. Rogers, *Proc. LMS* 8 (1958), in the form
    for negative correlations.

    >>> regular_share(3), regular_share(4).decimal(6)
    (-1/4 + 3*acos(1/3)/(4*pi), '0.009785')
    """
    if d == 1:
        return Angle({None: Fraction(1, 2)})
    if d == 2:
        return Angle({None: Fraction(1, 6)})
    if d == 3:
        return (3 * arccos(Surd(Fraction(1, 3))) - 1) / 4
    return Angle({d: Fraction(1)})


def _operand(value: object) -> Angle | None:
    if isinstance(value, Angle):
        return value
    if isinstance(value, Surd) and value.is_rational:
        return Angle({None: value.as_fraction()})
    if isinstance(value, numbers.Rational) and not isinstance(value, bool):
        return Angle({None: Fraction(value)})
    return None


def _compare(x: Angle, y: Angle) -> int:
    """The sign of the difference, by cross multiplication where that is exact."""
    if x.den == y.den:
        return sign(simplified(plus(x.num, times(y.num, Fraction(-1))))) * sign(x.den)
    for a, b in ((x.num, y.num), (x.num, x.den), (y.num, y.den)):
        if all(part.keys() <= {None} for part in (a, b)):  # then the products across are rational multiples
            cross = plus(_product(x.num, y.den), times(_product(y.num, x.den), Fraction(-1)))
            return sign(simplified(cross)) * sign(x.den) * sign(y.den)
    for precision in precisions():
        with flint.ctx.workprec(precision):
            difference = x.ball() - y.ball()
            if difference > 0 or difference < 0:
                return 1 if difference > 0 else -1
    raise Undecided(f"{x} and {y} agree to {LARGEST_PRECISION} bits, and nothing shows that they are equal")


def _product(a: Sum, b: Sum) -> Sum:
    """The product of two sums of which one is rational."""
    rational, other = (a, b) if a.keys() <= {None} else (b, a)
    return times(other, rational.get(None, Fraction(0)))


def _write(a: Sum, acos: str, share: str, times: str, number: str) -> str:
    parts = []
    for x, q in sorted(a.items(), key=lambda item: (item[0] is not None, str(item[0]))):
        size = _number(abs(q), number)
        if x is None:
            text = size
        else:
            name = (
                acos.format(x.latex() if number == "latex" else x) if isinstance(x, Surd) else share.format(x)
            )
            text = _scaled(name, abs(q), size, times, number)
        parts.append((" - " if q < 0 else " + ") + text)
    joined = "".join(parts) or " + 0"
    return joined[3:] if joined.startswith(" + ") else "-" + joined[3:]


def _scaled(name: str, q: Fraction, size: str, times: str, number: str) -> str:
    if q == 1:
        return name
    if number == "latex":
        return size + times + name
    top = name if q.numerator == 1 else f"{q.numerator}*{name}"
    if q.denominator == 1:
        return top
    return top.replace("/pi", f"/({q.denominator}*pi)") if top.endswith("/pi") else f"{top}/{q.denominator}"


def _number(q: Fraction, number: str) -> str:
    return Surd(q).latex() if number == "latex" else str(q)
