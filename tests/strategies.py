"""Random exact numbers and simplices for the property tests."""

from __future__ import annotations

from fractions import Fraction

import oracle
import sympy
from hypothesis import assume
from hypothesis import strategies as st

from coxeter import Surd, sqrt

small_fractions = st.builds(Fraction, st.integers(-60, 60), st.sampled_from([1, 2, 3, 4, 5, 7, 12]))
coordinates = st.integers(-24, 24).map(lambda n: Fraction(n, 6))
nonzero_fractions = small_fractions.filter(bool)
radicands = st.sampled_from([1, 2, 3, 5, 6, 8, 12, 15, 45, 10007, 3 * 1009**2])


def rational(x: Fraction) -> sympy.Rational:
    """The same fraction in SymPy."""
    return sympy.Rational(x.numerator, x.denominator)


@st.composite
def sums_of_roots(draw, max_terms: int = 3):
    """A sum of rational multiples of square roots, as a surd and as a SymPy expression."""
    terms = draw(st.lists(st.tuples(small_fractions, radicands), min_size=1, max_size=max_terms))
    ours = sum((q * sqrt(n) for q, n in terms), Surd(0))
    theirs = sympy.Add(*(rational(q) * sympy.sqrt(n) for q, n in terms))
    return ours, theirs


@st.composite
def quotients(draw):
    """A quotient of sums of roots, in both forms."""
    (a, x), (b, y) = draw(sums_of_roots()), draw(sums_of_roots())
    assume(sympy.expand(y) != 0)
    return a / b, x / y


@st.composite
def simplices(draw, min_dimension: int = 1, max_dimension: int = 4):
    """The vertices of a simplex with small rational coordinates, maybe in a larger space."""
    d = draw(st.integers(min_dimension, max_dimension))
    ambient = d + draw(st.integers(0, 1))
    point = st.tuples(*[coordinates] * ambient)
    points = draw(st.lists(point, min_size=d + 1, max_size=d + 1, unique=True))
    assume(oracle.squared_volume(points) > 0)
    return points


@st.composite
def rotations(draw, n: int):
    """A rational orthogonal matrix of determinant 1: (I - A)(I + A)^-1 with A skew-symmetric (Cayley)."""
    a = sympy.zeros(n, n)
    for i in range(n):
        for j in range(i):
            a[i, j] = rational(draw(coordinates) / 2)
            a[j, i] = -a[i, j]
    one = sympy.eye(n)
    matrix = (one - a) * (one + a).inv()
    return [[Fraction(int(x.p), int(x.q)) for x in matrix.row(i)] for i in range(n)]
