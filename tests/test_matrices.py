"""Rational matrices against SymPy, with entries on both sides of the limits of int64."""

import copy
import pickle
from fractions import Fraction

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from strategies import small_fractions

from coxeter import InexactInput, InvalidInput, RationalMatrix, rational

one_to_five = st.integers(1, 5)


def square_matrices(entries, sizes=one_to_five):
    return sizes.flatmap(
        lambda n: st.lists(st.lists(entries, min_size=n, max_size=n), min_size=n, max_size=n)
    )


huge = st.integers(2**61, 2**63 + 2**10) | st.integers(-(2**63) - 2**10, -(2**61)) | st.integers(-9, 9)
entries = small_fractions | huge


def in_sympy(rows):
    return sympy.Matrix(
        [[sympy.Rational(x.numerator, x.denominator) for x in map(Fraction, row)] for row in rows]
    )


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


@pytest.mark.parametrize(
    "sent", [copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))], ids=["copied", "pickled"]
)
def test_a_matrix_can_be_sent_elsewhere_after_it_was_used(sent):
    matrix = RationalMatrix.from_rows([[2, "1/3"], [0, 2**70]])
    inverse = matrix.inverse()
    assert sent(matrix) == matrix
    assert sent(matrix).inverse() == inverse
