"""Printing, reading and refusing exact numbers."""

import copy
import decimal
import math
import pickle
from fractions import Fraction

import flint
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from oracle import equal
from strategies import quotients

from coxeter import InexactInput, InvalidInput, Surd, rational, sqrt, surd

# -- printing and reading --------------------------------------------------------------------------


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
        (1 / (1 - sqrt(2)), "-1/(-1 + sqrt(2))", r"\frac{-1}{-1 + \sqrt{2}}"),
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


# -- refusals --------------------------------------------------------------------------------------


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


@pytest.mark.parametrize(
    "value", [True, np.True_, None, 1j, [], (1,), b"1", decimal.Decimal("0.5")], ids=repr
)
@pytest.mark.parametrize("read", [rational, surd, Surd, sqrt])
def test_what_is_no_number_of_ours_is_refused(read, value):
    with pytest.raises((InvalidInput, InexactInput)):
        read(value)


@pytest.mark.parametrize(
    "text", ["", "foo", "nan", "inf", "1/0", "0x10", "3 4", "1/2/3", "√2", "__import__('os')"]
)
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


@pytest.mark.parametrize(
    "value", [sympy.pi, sympy.I, sympy.oo, sympy.nan, sympy.zoo, sympy.Symbol("x")], ids=str
)
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
