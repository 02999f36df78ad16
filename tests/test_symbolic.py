"""Symbolic vectors and ranges, against numbers."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from coxeter.errors import InvalidInput, Undecided
from coxeter.exact import Surd, sqrt
from coxeter.symbolic.cases import case
from coxeter.symbolic.polynomials import is_zero, rational_function, sign_of, value
from coxeter.symbolic.runs import inner, runs, same, segments, squared_distance, total

HALVES = runs(("1/2", "k"), ("0", "d - k"))
RAMP = runs(("i/(d + 1)", "d"))
MIXED = runs(("1", "1"), ("k - i", "k - 1"), ("sqrt(2)", "d - k"))
VECTORS = {"halves": HALVES, "ramp": RAMP, "mixed": MIXED}


@pytest.mark.parametrize("x", VECTORS)
@pytest.mark.parametrize("y", VECTORS)
def test_inner_products_are_those_of_the_numbers(x, y):
    a, b = VECTORS[x], VECTORS[y]
    where = case("1 <= k <= d")
    product, distance = inner(a, b, where), squared_distance(a, b, where)
    for letters, parameters in where.instances(6):
        pairs = list(zip(a.numbers(**letters), b.numbers(**letters), strict=True))
        assert value(product, **parameters) == sum((u * v for u, v in pairs), Surd(0))
        assert value(distance, **parameters) == sum(((u - v) ** 2 for u, v in pairs), Surd(0))
        assert value(total(a, where), **parameters) == sum((u for u, _ in pairs), Surd(0))


def test_the_same_vector_written_otherwise():
    where = case("2 <= d")
    split = runs(("1/2", "1"), ("(d - i)/(2*(d - 1))", "d - 2"), ("0", "1"))
    assert same(split, runs(("(d - i)/(2*(d - 1))", "d")), where)
    assert not same(split, runs(("(d - i)/(2*d)", "d")), where)
    assert not same(split, runs(("0", "d - 1")), where)


def test_the_order_of_two_ends_may_be_open():
    with pytest.raises(Undecided):
        inner(runs(("1", "k"), ("0", "d - k")), runs(("1", "j"), ("0", "d - j")), case("0 <= k <= d", j="e"))


def test_lengths_must_not_be_negative_nor_differ():
    with pytest.raises(Undecided, match="negative length"):
        segments([runs(("1", "k - 2"), ("0", "d - k + 2"))], case("1 <= k <= d"))
    with pytest.raises(Undecided, match="different lengths"):
        inner(runs(("1", "d")), runs(("1", "d + 1")), case("1 <= d"))


@pytest.mark.parametrize(
    ("text", "expression", "sign"),
    [
        ("2 <= k <= d", "d - k", 1),
        ("2 <= k <= d", "k*(d + 1 - k)/(d + 1) - 1/2", 1),
        ("1 <= j < k <= d", "j - k", -1),
        ("3 <= d", "0", 0),
        ("3 <= d", "(d - 1)*sqrt(2) - 2", 1),
        ("2 <= d", "1 - d*sqrt(2)", -1),
    ],
)
def test_signs(text, expression, sign):
    assert case(text).sign(expression) == sign


@pytest.mark.parametrize(("text", "expression"), [("2 <= d", "d - 3"), ("1 <= k <= d", "d - 2*k")])
def test_a_sign_that_changes_is_undecided(text, expression):
    where = case(text)
    with pytest.raises(Undecided):
        where.sign(expression)
    assert not where.nonnegative(expression)
    assert not where.positive(expression)


def test_nonnegative_is_not_positive():
    where = case("2 <= k <= d")
    assert where.nonnegative("d - k")
    assert not where.positive("d - k")
    with pytest.raises(Undecided):
        where.sign("0", strict=True)


def test_ranges_list_their_numbers():
    found = {(x["j"], x["k"], x["d"]) for x in case("1 <= j < k <= d - 1").numbers(5)}
    assert found == {(j, k, d) for d in range(6) for k in range(d) for j in range(1, k)}
    assert [x["d"] for x in case("2 <= d", 4).numbers(6)] == [4, 5, 6]
    assert [(x["m"], x["d"]) for x in case("1 <= m", d="2*m + 1").numbers(7)] == [(1, 3), (2, 5), (3, 7)]
    assert list(case("4 == d").numbers(9)) == [{"d": 4}]


@pytest.mark.parametrize("text", ["2 <= 2*k <= d", "2 <= k <= k", "1 <= k + x"])
def test_what_is_no_chain_is_refused(text):
    with pytest.raises(InvalidInput, match="is no new letter"):
        case(text)


@pytest.mark.parametrize("text", ["sqrt(3)", "2**d", "x + 1"])
def test_what_is_no_rational_function_is_refused(text):
    with pytest.raises(InvalidInput):
        rational_function(text)


def test_the_square_of_the_root_of_two():
    assert is_zero(rational_function("(1 + sqrt(2))*(sqrt(2) - 1) - 1"))
    assert value(rational_function("(d + sqrt(2))/(1 + sqrt(2))"), d=1) == 1


@given(st.fractions(-20, 20), st.fractions(-20, 20))
def test_signs_in_the_field_of_the_root_of_two(p, q):
    x = Surd(p) + q * sqrt(2)
    assert sign_of(p, q) == (x > 0) - (x < 0)


def test_letters_that_a_range_does_not_bind_are_refused():
    with pytest.raises(InvalidInput, match="does not bind j"):
        case("2 <= d").sign("j")
    with pytest.raises(InvalidInput, match="is no number to begin with"):
        case("k <= d")
    with pytest.raises(InvalidInput, match="need not be an integer"):
        case("1 <= m", d="m/2")


@pytest.mark.parametrize(
    ("text", "formula"), [("2 <= d", "(d - 3)/(d - 3)"), ("2 <= d", "1/(sqrt(2)**2 - 2)")]
)
def test_a_divisor_that_may_vanish_is_undecided(text, formula):
    with pytest.raises((Undecided, ZeroDivisionError)):
        case(text).equal(formula, "1")


@pytest.mark.parametrize(("value_", "length"), [("1/i", "d"), ("i**5", "d"), ("1", "d/2")])
def test_sums_without_a_closed_form_are_undecided(value_, length):
    with pytest.raises(Undecided):
        total(runs((value_, length)), case("2 <= d"))
