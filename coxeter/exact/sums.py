"""Sums of square roots: the ring that lengths live in.

A sum is a tuple of pairs ``((n, q), ...)`` and stands for the sum of ``q*sqrt(n)``. No two ``n`` differ
by a rational square; then the roots are linearly independent over the rationals (Besicovitch
1940), so a sum is zero only if it is empty, and refining a ball around any other one ends.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from functools import lru_cache

import flint

Terms = tuple[tuple[int, Fraction], ...]

ONE: Terms = ((1, Fraction(1)),)
SMALL_PRIMES = [p for p in range(2, 1000) if all(p % q for q in range(2, math.isqrt(p) + 1))]


@lru_cache(maxsize=65536)
def _split_square(n: int) -> tuple[int, int]:
    """Write ``n = s*s*t`` with t as small as trial division finds; return ``(s, t)``.

    A large square factor may stay in t. That costs beauty only: square classes are compared by
    whether a product is a square, never by equality of t.
    """
    root = math.isqrt(n)
    if root * root == n:
        return root, 1
    square, rest = 1, n
    for p in SMALL_PRIMES:
        if p * p > rest:
            break
        while rest % (p * p) == 0:
            rest //= p * p
            square *= p
    root = math.isqrt(rest)
    return (square * root, 1) if root * root == rest else (square, rest)


def collect(pairs: Iterable[tuple[int, Fraction]]) -> Terms:
    """Bring a sum of ``q*sqrt(n)`` into normal form: one term for each square class, no zeros."""
    total: dict[int, Fraction] = {}
    for n, q in pairs:
        if not q:
            continue
        square, n = _split_square(n)
        q *= square
        if n not in total:
            for m in total:
                ratio = math.isqrt(n * m)
                if ratio * ratio == n * m:  # sqrt(n) = ratio/m * sqrt(m)
                    n, q = m, q * Fraction(ratio, m)
                    break
        total[n] = total.get(n, Fraction(0)) + q
    return tuple(sorted((n, q) for n, q in total.items() if q))


def plus(a: Terms, b: Terms) -> Terms:
    return collect((*a, *b))


def times(a: Terms, b: Terms) -> Terms:
    return collect((n * m, p * q) for n, p in a for m, q in b)


def ball(terms: Terms) -> flint.arb:
    """A ball around the value of a sum, at Arb's current precision."""
    balls = (flint.arb(flint.fmpq(q.numerator, q.denominator)) * flint.arb(n).sqrt() for n, q in terms)
    return sum(balls, flint.arb(0))


def precisions() -> Iterable[int]:
    precision = 64
    while True:
        yield precision
        precision *= 2


def sign(terms: Terms) -> int:
    """The sign of a sum of square roots: zero only for the empty sum, else decided by refinement."""
    if not terms:
        return 0
    if len({q > 0 for _, q in terms}) == 1:
        return 1 if terms[0][1] > 0 else -1
    for precision in precisions():
        with flint.ctx.workprec(precision):
            value = ball(terms)
            if value > 0:
                return 1
            if value < 0:
                return -1
    raise AssertionError("unreachable")


def negative(a: Terms) -> Terms:
    return tuple((n, -q) for n, q in a)


def power(a: Terms, k: int) -> Terms:
    """The k-th power; a single term is raised at once."""
    if len(a) == 1:
        n, q = a[0]
        return ((n if k % 2 else 1, q**k * n ** (k // 2)),)
    result = ONE
    for _ in range(k):
        result = times(result, a)
    return result


def reduce(num: Terms, den: Terms) -> tuple[Terms, Terms]:
    """Cancel what a numerator and a denominator of several terms share, a sum common to both included."""
    ratio = _ratio(num, den)
    if ratio is not None:
        return ratio, ONE
    common = math.gcd(*(n for n, _ in den))
    if common > 1:
        num, den = _over_root(num, common), _over_root(den, common)
    coefficients = [q for _, q in (*num, *den)]
    integral = math.lcm(*(q.denominator for q in coefficients))
    shared = math.gcd(*(int(q * integral) for q in coefficients))
    content: Terms = ((1, Fraction(integral, shared) * sign(den)),)
    return times(num, content), times(den, content)


def _ratio(num: Terms, den: Terms) -> Terms | None:
    """The quotient, if the numerator is a rational multiple of the denominator."""
    if len(num) != len(den):
        return None if num else ()
    n, q = den[0]
    for m, p in num:
        root = math.isqrt(n * m)
        if root * root == n * m:  # the term in the same square class: sqrt(m) = root/n * sqrt(n)
            ratio: Terms = ((1, p * Fraction(root, n) / q),)
            return ratio if not plus(num, negative(times(ratio, den))) else None
    return None


def _over_root(a: Terms, common: int) -> Terms:
    """A sum divided by the square root of an integer."""
    return collect((n // common, q) if n % common == 0 else (n * common, q / common) for n, q in a)


def prime_factors(n: int) -> list[int]:
    """The primes that divide a positive integer."""
    primes, p = [], 2
    while p * p <= n:
        if n % p == 0:
            primes.append(p)
            while n % p == 0:
                n //= p
        p += 1
    return [*primes, n] if n > 1 else primes


def exact_root(q: Fraction, p: int) -> Fraction | None:
    """The rational p-th root of a positive rational, if there is one."""
    parts = []
    for n in (q.numerator, q.denominator):
        root = int(flint.fmpz(n).root(p))
        if root**p != n:
            return None
        parts.append(root)
    return Fraction(*parts)
