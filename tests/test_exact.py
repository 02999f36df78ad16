"""Exact numbers against SymPy, mpmath and integer arithmetic."""

import copy
import decimal
import math
import pickle
from fractions import Fraction

import flint
import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import example, given
from hypothesis import strategies as st
from oracle import equal
from strategies import nonzero_fractions, quotients, small_fractions, sums_of_roots

from coxeter import InexactInput, InvalidInput, RationalMatrix, Surd, rational, sqrt, surd

BIG = 1009  # the first prime that trial division does not try
NEAR = sqrt(10**40 + 1) - 10**20  # about 5e-21: all digits cancel at ordinary precision


def high_precision(expression):
    with mpmath.workdps(120):
        return expression.evalf(120)


# -- arithmetic ---------------------------------------------------------------------------------------


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


# -- equality and hashing --------------------------------------------------------------------------------


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


def test_nothing_else_is_equal():
    assert Surd(1) != "1"
    assert Surd(1) != 1.0
    assert Surd(1) is not None


def test_zero_is_false_and_nothing_else():
    assert not sqrt(8) - 2 * sqrt(2)
    assert NEAR


# -- order ---------------------------------------------------------------------------------------------


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


# -- decimals -------------------------------------------------------------------------------------------


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
    "x", [sqrt(2), sqrt(2) / 10**400, 7**900 * sqrt(3), sqrt(99999), Surd("1/3"), Surd(10**20), sqrt(10**60 - 1)]
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


# -- printing and reading ---------------------------------------------------------------------------------


@given(quotients())
def test_print_is_read_back_by_sympy_and_by_the_library(a):
    assert equal(a[0], sympy.sympify(str(a[0])))
    assert surd(str(a[0])) == a[0]


@given(quotients(), st.integers(2, 5))
def test_roots_are_read_back_by_sympy(a, k):
    x = abs(a[0])
    assert equal(x, sympy.sympify(str(x.root(k)), rational=True) ** k)


@pytest.mark.parametrize("x", [Surd(2).root(3), (1 + sqrt(2)).root(3), Surd("2/3").root(5), sqrt(2).root(2)])
def test_roots_are_read_back_by_the_library(x):
    assert surd(str(x)) == x


@given(quotients())
def test_sympy_numbers_are_read(a):
    assert surd(a[1]) == a[0]
    assert surd(a[0].sympy()) == a[0]


@pytest.mark.parametrize(
    ("x", "text", "latex"),
    [
        (Surd(0), "0", "0"),
        (sqrt(3) / 4, "sqrt(3)/4", r"\frac{\sqrt{3}}{4}"),
        (-sqrt(3) / 4, "-sqrt(3)/4", r"-\frac{\sqrt{3}}{4}"),
        (1 - 2 * sqrt(2) / 3, "1 - 2*sqrt(2)/3", r"1 - \frac{2\sqrt{2}}{3}"),
        (1 / (1 + sqrt(2)), "1/(1 + sqrt(2))", r"\frac{1}{1 + \sqrt{2}}"),
        (Surd(2).root(3), "2**(1/3)", r"2^{1/3}"),
        (Surd("1/2").root(3), "(1/2)**(1/3)", r"\left(\frac{1}{2}\right)^{1/3}"),
        (sqrt(72), "6*sqrt(2)", r"6\sqrt{2}"),
    ],
)
def test_what_is_printed(x, text, latex):
    assert str(x) == repr(x) == text
    assert x.latex() == latex


def test_integers_of_any_length_are_printed():
    assert str(Surd(10**5000)) == "1" + "0" * 5000


def test_a_number_is_a_value():
    x = sqrt(2) / (1 + sqrt(3))
    assert pickle.loads(pickle.dumps(x)) == copy.deepcopy(x) == x
    with pytest.raises(AttributeError, match="immutable"):
        x.index = 2


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (3, 3),
        (Fraction(3, 4), Fraction(3, 4)),
        (" 3/4 ", Fraction(3, 4)),
        ("-0.75", Fraction(-3, 4)),
        (np.int64(-7), -7),
        (sympy.Rational(2, 3), Fraction(2, 3)),
        (flint.fmpq(2, 3), Fraction(2, 3)),
        (flint.fmpz(5), 5),
        (sqrt("4/9"), Fraction(2, 3)),
    ],
    ids=repr,
)
def test_rationals_are_read(value, expected):
    result = rational(value)
    assert type(result) is Fraction
    assert result == expected
    assert surd(value) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sqrt(3)/4", sqrt(3) / 4),
        ("-sqrt(1/2)", -sqrt(2) / 2),
        ("sqrt(0.5)", sqrt(2) / 2),
        ("1/(1 + sqrt(2))", sqrt(2) - 1),
        ("sqrt(2)*sqrt(3) - 2", sqrt(6) - 2),
        ("sqrt(1 + sqrt(2))", (1 + sqrt(2)).root(2)),
    ],
)
def test_text_with_roots_is_read(text, expected):
    assert surd(text) == expected


# -- refusals ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "value",
    [0.5, 1.0, math.nan, math.inf, np.float64(0.5), np.float32(0.5), sympy.Float(0.5)],
    ids=repr,
)
@pytest.mark.parametrize("read", [rational, surd, Surd, sqrt])
def test_floats_are_refused_not_guessed_at(read, value):
    with pytest.raises(InexactInput, match="is inexact: give an integer, a Fraction"):
        read(value)


def test_a_float_within_a_sympy_number_is_found():
    with pytest.raises(InexactInput):
        surd(sympy.sqrt(2) + sympy.Float(0.5))


@pytest.mark.parametrize("value", [True, np.True_, None, 1j, [], (1,), b"1", decimal.Decimal("0.5")], ids=repr)
@pytest.mark.parametrize("read", [rational, surd, Surd, sqrt])
def test_what_is_no_number_of_ours_is_refused(read, value):
    with pytest.raises((InvalidInput, InexactInput)):
        read(value)


@pytest.mark.parametrize("text", ["", "foo", "nan", "inf", "1/0", "0x10", "3 4", "1/2/3", "√2", "__import__('os')"])
@pytest.mark.parametrize("read", [rational, surd])
def test_nonsense_is_refused_and_quoted(read, text):
    with pytest.raises(InvalidInput, match="is not a") as caught:
        read(text)
    assert repr(text) in str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        "sqrt",
        "sqrt()",
        "sqrt(2",
        "-sqrt",
        "sqrt.sqrt(2)",
        "sqrt(())",
        "sqrt(2)()",
        "sqrt(2)sqrt(3)",
        "sqrt(2) 3",
        "sqrt(x)",
        "sqrt(-2)",
        "1/sqrt(0)",
        "sqrt(2)/0",
        "sqrt(2)**sqrt(2)",
        "sqrt(2)//3",
    ],
)
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_nonsense_with_roots_is_refused_and_quoted(text):
    with pytest.raises(InvalidInput) as caught:
        surd(text)
    assert repr(text) in str(caught.value)


@pytest.mark.parametrize("value", [sympy.pi, sympy.I, sympy.oo, sympy.nan, sympy.zoo, sympy.Symbol("x")], ids=str)
def test_sympy_numbers_of_another_kind_are_refused(value):
    with pytest.raises(InvalidInput):
        surd(value)


@pytest.mark.parametrize("negative", [-1, Fraction(-1, 9), Surd(-3), 1 - sqrt(2)], ids=str)
def test_negative_numbers_have_no_root(negative):
    with pytest.raises(InvalidInput, match="is negative: it has no real"):
        sqrt(negative)
    with pytest.raises(InvalidInput, match="is negative: it has no real"):
        surd(negative).root(3)


@pytest.mark.parametrize("index", [0, -1, 2.0, Fraction(1, 2), "2"], ids=repr)
def test_an_index_that_is_no_positive_integer_is_refused(index):
    with pytest.raises(InvalidInput):
        sqrt(2).root(index)


def test_a_negative_number_of_digits_is_refused():
    with pytest.raises(InvalidInput):
        Surd(123).decimal(-1)
    with pytest.raises(InvalidInput):
        sqrt(2).scientific(0)


def test_cube_roots_cannot_be_added():
    with pytest.raises(InvalidInput, match=r"cannot add 2\*\*\(1/3\)"):
        Surd(2).root(3) + 1


def test_an_irrational_number_is_no_fraction():
    with pytest.raises(InvalidInput, match=r"sqrt\(2\) is irrational"):
        rational(sqrt(2))


# -- rational matrices --------------------------------------------------------------------------------------


def square_matrices(entries, sizes=st.integers(1, 5)):
    return sizes.flatmap(lambda n: st.lists(st.lists(entries, min_size=n, max_size=n), min_size=n, max_size=n))


huge = st.integers(2**61, 2**63 + 2**10) | st.integers(-(2**63) - 2**10, -(2**61)) | st.integers(-9, 9)
entries = small_fractions | huge


def in_sympy(rows):
    return sympy.Matrix([[sympy.Rational(x.numerator, x.denominator) for x in map(Fraction, row)] for row in rows])


def same(ours, theirs):
    return in_sympy(ours.rows()) == theirs


@given(square_matrices(entries))
def test_determinant_and_rank_are_sympys(rows):
    ours, theirs = RationalMatrix.from_rows(rows), in_sympy(rows)
    assert rational(theirs.det()) == ours.det()
    assert theirs.rank() == ours.rank()


@given(square_matrices(entries))
def test_the_inverse_is_sympys(rows):
    ours, theirs = RationalMatrix.from_rows(rows), in_sympy(rows)
    if theirs.det():
        assert same(ours.inverse(), theirs.inv())
    else:
        with pytest.raises(ZeroDivisionError):
            ours.inverse()


@given(square_matrices(entries, st.just(3)), square_matrices(entries, st.just(3)))
def test_the_product_is_sympys(a, b):
    ours, theirs = RationalMatrix.from_rows(a), RationalMatrix.from_rows(b)
    assert same(ours @ theirs, in_sympy(a) * in_sympy(b))
    assert same(ours.T @ theirs, in_sympy(a).T * in_sympy(b))


@given(square_matrices(entries))
def test_a_matrix_reads_back_what_was_written(rows):
    matrix = RationalMatrix.from_rows(rows)
    assert [list(row) for row in matrix.rows()] == [[Fraction(x) for x in row] for row in rows]
    assert matrix == RationalMatrix.from_rows(matrix.rows())
    assert matrix[0, -1] == rows[0][-1]


def test_matrices_are_equal_by_value():
    assert RationalMatrix(np.array([[2, 4]]), 2) == RationalMatrix(np.array([[1, 2]]))
    assert RationalMatrix(np.array([[1, 2]])) != RationalMatrix(np.array([[1], [2]]))
    assert RationalMatrix.identity(2) != RationalMatrix.from_rows([[1, 0], [0, "1/2"]])


@pytest.mark.parametrize("n", [2**31 - 1, 2**31, 2**31 + 1, 2**62 - 1, 2**62, 2**62 + 1, 2**63 - 1, 2**63])
def test_nothing_overflows_near_the_limits_of_int64(n):
    row = RationalMatrix.from_rows([[n, -n]])
    assert (row @ row.T)[0, 0] == 2 * n * n
    assert (row.T @ row)[0, 1] == -n * n
    assert row.T[1, 0] == -n


@pytest.mark.parametrize("dtype", [np.int8, np.uint8, np.int32, np.uint64])
def test_arrays_of_other_integers_do_not_overflow(dtype):
    n = np.iinfo(dtype).max
    matrix = RationalMatrix(np.array([[n]], dtype=dtype))
    assert (matrix @ matrix)[0, 0] == int(n) ** 2


def test_a_matrix_of_floats_is_refused():
    with pytest.raises(InexactInput):
        RationalMatrix(np.array([[0.5]]))
    with pytest.raises(InexactInput):
        RationalMatrix.from_rows([[0.5]])


@pytest.mark.parametrize("denominator", [0, -1])
def test_a_denominator_is_positive(denominator):
    with pytest.raises(InvalidInput):
        RationalMatrix(np.array([[1]]), denominator)


def test_rows_of_different_lengths_are_refused():
    with pytest.raises(InvalidInput, match=r"different lengths: \[1, 2\]"):
        RationalMatrix.from_rows([[1, 2], [3]])
