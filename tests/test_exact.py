"""Exact numbers against SymPy and integer arithmetic: values, order and decimals."""

import decimal
import math
from fractions import Fraction

import numpy as np
import pytest
import sympy
from hypothesis import example, given
from hypothesis import strategies as st
from oracle import equal
from strategies import nonzero_fractions, quotients, small_fractions, sums_of_roots

from coxeter import Surd, sqrt

BIG = 1009  # the first prime that trial division does not try
NEAR = sqrt(10**40 + 1) - 10**20  # about 5e-21: all digits cancel at ordinary precision


def high_precision(expression):
    return expression.evalf(120)


# -- arithmetic ------------------------------------------------------------------------------------


@given(sums_of_roots(), sums_of_roots())
def test_sums_and_products_agree_with_sympy(a, b):
    assert equal(a[0] + b[0], a[1] + b[1])
    assert equal(a[0] - b[0], a[1] - b[1])
    assert equal(a[0] * b[0], a[1] * b[1])


@given(quotients())
def test_quotients_agree_with_sympy(a):
    assert equal(*a)


@given(quotients(), st.integers(-3, 4))
def test_integer_powers_agree_with_sympy(a, k):
    if a[0] or k >= 0:
        assert equal(a[0] ** k, a[1] ** k)


@given(quotients(), quotients())
def test_two_quotients_can_be_added(a, b):
    assert a[0] + b[0] - b[0] == a[0]


@given(quotients(), st.integers(2, 7))
def test_a_root_raised_to_its_index_is_the_number(a, k):
    x = abs(a[0])
    assert x.root(k) ** k == x
    assert x ** Fraction(1, k) == x.root(k)


@given(quotients(), st.integers(2, 7))
def test_a_root_raised_to_its_index_is_no_root_any_more(a, k):
    assert (abs(a[0]).root(k) ** k).index == 1


@given(nonzero_fractions, st.integers(2, 7), st.integers(1, 7))
def test_powers_of_roots_are_roots_of_powers(q, k, p):
    x = Surd(abs(q))
    assert x.root(k) ** p == (x**p).root(k) == x ** Fraction(p, k)
    assert x.root(k).root(p) == x.root(k * p)
    assert x.root(k) * x.root(p) == (x ** (k + p)).root(k * p)


@given(sums_of_roots())
def test_dividing_by_itself_gives_one(a):
    if a[0]:
        assert a[0] / a[0] == 1
        assert 1 / (1 / a[0]) == a[0]


def test_a_number_does_not_grow_when_nothing_happens_to_it():
    x = 1 / (sqrt(2 * 10007) + sqrt(3 * 10007))
    assert max(n for n, _ in (x * 1).den) <= max(n for n, _ in x.den) <= 3 * 10007


def test_fractions_and_numpy_integers_may_stand_on_either_side():
    root = sqrt(3)
    assert Fraction(1, 2) * root == root / 2 == root * Fraction(1, 2)
    assert np.int64(2) * root == root * np.int64(2) == root + root
    assert 1 - root == -(root - 1)
    assert 3 / root == root


def test_arithmetic_with_a_float_is_refused():
    for operation in (lambda x: x + 0.5, lambda x: 0.5 * x, lambda x: x / 0.5, lambda x: x < 0.5):
        with pytest.raises(TypeError):
            operation(sqrt(2))


@pytest.mark.parametrize("zero", [Surd(0), sqrt(8) - 2 * sqrt(2)])
def test_division_by_zero(zero):
    with pytest.raises(ZeroDivisionError):
        1 / zero


# -- equality and hashing --------------------------------------------------------------------------


EQUAL = [
    (1 / (1 + sqrt(2)), sqrt(2) - 1),
    ((sqrt(2) + sqrt(3)) ** 2, 5 + 2 * sqrt(6)),
    ((1 + sqrt(2)).root(2) ** 2, 1 + sqrt(2)),
    ((3 + 2 * sqrt(2)).root(2), 1 + sqrt(2)),
    ((7 + 5 * sqrt(2)).root(3), 1 + sqrt(2)),
    (sqrt(2 * BIG**2), BIG * sqrt(2)),
    (sqrt(2 * BIG**2) / sqrt(2), Surd(BIG)),
    (sqrt(2 * BIG**2 * 1013**2) - 1013 * sqrt(2 * BIG**2), Surd(0)),
    (1 / (1 + sqrt(3 * BIG**2)), (sqrt(3) * BIG - 1) / (3 * BIG**2 - 1)),
    ((4 + 4 * sqrt(2)) / (9 + 9 * sqrt(2)), Surd("4/9")),
    (((4 + 4 * sqrt(2)) / (9 + 9 * sqrt(2))).root(2), Surd("2/3")),
    ((sqrt(3) + sqrt(2) * BIG) / (sqrt(3) + sqrt(2 * BIG**2)), Surd(1)),
    (Surd(8).root(3), Surd(2)),
    (Surd(4).root(4), sqrt(2)),
    ((Surd(1) / 3**BIG).root(BIG), Surd("1/3")),
]


@pytest.mark.parametrize(("a", "b"), EQUAL, ids=range(len(EQUAL)))
def test_equal_numbers_are_equal_however_they_were_built(a, b):
    assert a == b
    assert not a < b
    assert a <= b


@pytest.mark.parametrize(("a", "b"), EQUAL, ids=range(len(EQUAL)))
def test_equal_numbers_have_equal_hashes(a, b):
    assert hash(a) == hash(b)


@pytest.mark.parametrize(("a", "b"), EQUAL, ids=range(len(EQUAL)))
def test_equal_numbers_are_both_rational_or_both_not(a, b):
    assert a.is_rational == b.is_rational
    if a.is_rational:
        assert a.as_fraction() == b.as_fraction()


@given(quotients(), quotients())
def test_equality_is_sympys(a, b):
    assert (a[0] == b[0]) == equal(a[0], b[1])


@given(small_fractions)
def test_a_rational_surd_equals_and_hashes_like_its_fraction(q):
    assert Surd(q) == q
    assert hash(Surd(q)) == hash(q)
    assert Surd(q).as_fraction() == q


@pytest.mark.parametrize("x", [sqrt(2) * 10**400, sqrt(2) / 10**400, Surd(10**400), 1 / NEAR])
def test_any_number_can_be_hashed(x):
    assert hash(x) == hash(2 * x / 2)


def test_a_number_beside_another_is_not_equal_to_it():
    close = Fraction(math.isqrt(2 * 10**100), 10**50)
    assert sqrt(2) != close
    assert sqrt(2) > close


def test_a_negative_number_is_not_the_root_of_its_square():
    x = 1 + sqrt(2)
    assert -x != (x * x).root(2) == x
    assert -x < (x * x).root(2)


def test_nothing_else_is_equal():
    assert Surd(1) != "1"
    assert Surd(1) != 1.0
    assert Surd(1) is not None


def test_zero_is_false_and_nothing_else():
    assert not sqrt(8) - 2 * sqrt(2)
    assert NEAR


# -- order -----------------------------------------------------------------------------------------


@given(quotients(), quotients())
def test_order_agrees_with_high_precision(a, b):
    difference = high_precision(a[1] - b[1])
    if equal(a[0], b[1]):
        assert a[0] == b[0]
    else:
        assert (a[0] < b[0]) == (difference < 0)
        assert (a[0] > b[0]) == (difference > 0)


@given(quotients())
def test_the_sign_agrees_with_high_precision(a):
    zero = equal(a[0], 0)
    assert a[0].sign() == (0 if zero else int(sympy.sign(high_precision(a[1]))))


@pytest.mark.parametrize("n", [10, 100, 1000])
def test_the_sign_of_a_tiny_difference(n):
    tiny = sqrt(100**n + 1) - 10**n
    assert tiny.sign() == 1
    assert (-tiny).sign() == -1
    assert 0 < tiny < Fraction(1, 10**n)


# -- decimals --------------------------------------------------------------------------------------


def is_nearest(x, candidate, spacing):
    """Whether an irrational number lies within half a step of a candidate, exactly."""
    half = Fraction(spacing) / 2
    return Fraction(candidate) - half < x < Fraction(candidate) + half


def check_float(x):
    value = float(x)
    above, below = math.nextafter(value, math.inf), math.nextafter(value, -math.inf)
    assert (Fraction(value) + Fraction(below)) / 2 <= x <= (Fraction(value) + Fraction(above)) / 2


@given(quotients())
@example((NEAR, None))
@example((1 / NEAR, None))
@example((1 / (1 + NEAR), None))
@example((1 / NEAR.root(3), None))
def test_float_is_the_nearest_double(a):
    check_float(a[0])


@given(small_fractions)
def test_the_float_of_a_fraction_is_pythons(q):
    assert float(Surd(q)) == float(q)


@given(st.integers(1, 10**6), st.integers(0, 30))
def test_decimals_of_a_square_root_from_integer_square_roots(n, digits):
    expected = (math.isqrt(4 * n * 100**digits) + 1) // 2  # floor(x + 1/2)
    text = sqrt(n).decimal(digits)
    assert int(text.replace(".", "")) == expected
    assert len(text.partition(".")[2]) == digits


@given(quotients(), st.integers(0, 12))
def test_a_decimal_is_within_half_a_unit_of_its_last_place(a, digits):
    if not a[0].is_rational:
        assert is_nearest(a[0], Fraction(a[0].decimal(digits)), Fraction(1, 10**digits))


@given(small_fractions, st.integers(0, 5))
def test_the_decimal_of_a_fraction_is_that_of_the_decimal_module(q, digits):
    unit = decimal.Decimal(1).scaleb(-digits)
    with decimal.localcontext(prec=60):
        scaled = decimal.Decimal(q.numerator) / decimal.Decimal(q.denominator)
        assert decimal.Decimal(Surd(q).decimal(digits)) == scaled.quantize(unit, decimal.ROUND_HALF_EVEN)


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        ("1/2", 0, "0"),
        ("3/2", 0, "2"),
        ("-1/2", 0, "0"),
        ("-5/2", 0, "-2"),
        ("1/8", 2, "0.12"),
        ("3/8", 2, "0.38"),
        ("-1/8", 2, "-0.12"),
        ("-1/1000", 2, "0.00"),
        ("9995/10000", 3, "1.000"),
        ("12", 3, "12.000"),
    ],
)
def test_ties_go_to_the_even_digit(value, digits, text):
    assert Surd(value).decimal(digits) == text


@pytest.mark.parametrize(
    "quarter",
    [
        (1 + sqrt(2)) / (4 + 4 * sqrt(2)),
        (sqrt(3) + sqrt(2) * BIG) / (4 * sqrt(3) + 4 * sqrt(2 * BIG**2)),
        ((1 + sqrt(2)) / (16 + 16 * sqrt(2))).root(2),
        (Surd(1) / 4**BIG).root(BIG),
    ],
    ids=range(4),
)
def test_a_tie_that_hides_in_surds_is_found(quarter):
    assert quarter.is_rational  # else the next line would refine a ball for ever
    assert quarter.decimal(1) == "0.2"


@pytest.mark.parametrize(
    "x",
    [sqrt(2), sqrt(2) / 10**400, 7**900 * sqrt(3), sqrt(99999), Surd("1/3"), Surd(10**20), sqrt(10**60 - 1)],
)
@pytest.mark.parametrize("digits", [2, 3, 17, 30])
def test_scientific_notation_agrees_with_the_decimal_module(x, digits):
    q = (x * x).as_fraction()
    with decimal.localcontext(prec=1000, Emin=-9999, Emax=9999):
        value = (decimal.Decimal(q.numerator) / decimal.Decimal(q.denominator)).sqrt()
        assert decimal.Decimal(x.scientific(digits)) == decimal.Decimal(f"{value:.{digits - 1}e}")


def test_scientific_notation_of_special_values():
    assert Surd(0).scientific() == "0"
    assert (-sqrt(2)).scientific(3) == "-1.41e+00"
    assert Surd("9.999").scientific(3) == "1.00e+01"
    assert NEAR.scientific(5) == "5.0000e-21"
    assert float(sqrt(2).scientific(1)) == 1.0
