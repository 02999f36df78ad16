"""Rational combinations of 1, of arccosines over π, and of solid angles of regular simplices: their signs."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import lru_cache

import flint

from ..errors import Undecided
from .surd import Surd, sqrt

Atom = Surd | int | None
"""A cosine stands for its angle over π, d for the solid angle of the regular d-simplex, None for 1."""
Sum = Mapping[Atom, Fraction]

LARGEST_PRECISION = 2**12
ONE: Sum = {None: Fraction(1)}


def plus(a: Sum, b: Sum) -> Sum:
    return {x: q for x in {**a, **b} if (q := a.get(x, Fraction(0)) + b.get(x, Fraction(0)))}


def times(a: Sum, q: Fraction) -> Sum:
    return {x: p * q for x, p in a.items() if q}


def multiple(a: Sum, b: Sum) -> Fraction | None:
    """The factor, if a sum is a rational multiple of another one."""
    if a.keys() != b.keys():
        return None
    factors = {a[x] / b[x] for x in a}
    return factors.pop() if len(factors) == 1 else None


def simplified(a: Sum) -> Sum:
    """Zeros left out, and several arccosines replaced by a rational number if that is what they add up to.

    Their total is a rational multiple of π only if the product z of the numbers at these angles is a root of
    unity. It lies in a field of square roots, and there the roots of unity are those with z^24 = 1.
    """
    a = {x: q for x, q in a.items() if q}
    cosines: dict[Atom, Fraction] = {x: q for x, q in a.items() if isinstance(x, Surd)}
    if len(cosines) < 2:
        return a
    unit = Fraction(
        math.gcd(*(q.numerator for q in cosines.values())),
        math.lcm(*(q.denominator for q in cosines.values())),
    )
    with flint.ctx.workprec(128):
        twelfths = ball(times(cosines, 12 / unit)).unique_fmpz()
    if twelfths is None:  # the ball, which is small, holds no integer: so the total is none of these
        return a
    real, imaginary = _product((x, int(24 * q / unit)) for x, q in cosines.items())
    if real != 1 or imaginary:
        return a
    total = int(twelfths) * unit / 12
    rest = {x: q for x, q in a.items() if x not in cosines}
    return plus(rest, {None: total})


def _product(powers: Iterable[tuple[Atom, int]]) -> tuple[Surd, Surd]:
    """The product of powers of cos + i·sin, as real and imaginary part."""
    real, imaginary = Surd(1), Surd(0)
    for cosine, n in powers:
        assert isinstance(cosine, Surd)
        c, s = cosine, sqrt(1 - cosine * cosine) * (1 if n > 0 else -1)
        for bit in bin(abs(n))[:1:-1]:
            if bit == "1":
                real, imaginary = real * c - imaginary * s, real * s + imaginary * c
            c, s = c * c - s * s, 2 * c * s
    return real, imaginary


def ball(a: Sum) -> flint.arb:
    return sum((_atom(x) * flint.arb(flint.fmpq(q.numerator, q.denominator)) for x, q in a.items()), _ZERO)


_ZERO = flint.arb(0)


def _atom(x: Atom) -> flint.arb:
    if x is None:
        return flint.arb(1)
    if isinstance(x, int):
        return regular_ball(x, flint.ctx.prec)
    return x.ball().acos() / flint.arb.pi()


def precisions() -> Iterator[int]:
    precision = 64
    while precision <= LARGEST_PRECISION:
        yield precision
        precision *= 2


def sign(a: Sum) -> int:
    """The sign of a simplified sum: of one that is empty it is 0; a rational value is seen as such before."""
    if not a:
        return 0
    for precision in precisions():
        with flint.ctx.workprec(precision):
            value = ball(a)
            if value > 0 or value < 0:
                return 1 if value > 0 else -1
    raise Undecided(
        f"a sum of {len(a)} angles is 0 to {LARGEST_PRECISION} bits, and nothing shows that it is 0"
    )


@lru_cache(maxsize=256)
def regular_ball(d: int, precision: int) -> flint.arb:
    """The integral up to T, with a bound for the rest: |Φ(is)| e^(-s²/2) < 1 for all s."""
    with flint.ctx.workprec(precision + 4 * d + 32):  # the integrand oscillates: leading digits cancel
        working = flint.ctx.prec
        end = flint.arb(math.isqrt(2 * working) + 2)
        root, i = flint.acb(2).sqrt(), flint.acb(0, 1)

        def integrand(s: flint.acb, _: bool) -> flint.acb:
            return (flint.acb("0.5") + i * (s / root).erfi() / 2) ** d * (-(d + 1) * s * s / 2).exp()

        small = flint.arb(2) ** (-working)
        value = flint.acb.integral(integrand, flint.acb(0), flint.acb(end), rel_tol=small, abs_tol=small).real
        tail = (-(end**2) / 2).exp() / end
        return 2 * ((d + 1) / (2 * flint.arb.pi())).sqrt() * (value + flint.arb(0, tail.upper()))
