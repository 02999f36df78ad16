"""Rational matrices, kept as integers over one common denominator.

Entries are NumPy ``int64`` as long as a bound shows that nothing overflows, Python integers
otherwise. Inverse, determinant and rank come from FLINT.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import flint
import numpy as np

from ..errors import InexactInput, InvalidInput
from .rationals import rational

INT64_SAFE = 2**60
"""Below this, sums and differences of up to eight entries fit into ``int64`` too."""


def narrow(numerators: np.ndarray) -> np.ndarray:
    """Store integers as ``int64`` if they are small enough for sums and differences to fit."""
    if numerators.dtype != object:
        return numerators
    return numerators.astype(np.int64) if _magnitude(numerators) < INT64_SAFE else numerators


def _magnitude(a: np.ndarray) -> int:
    return max(int(a.max()), -int(a.min())) if a.size else 0


def integer_product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The product of integer arrays, exact whatever the size of the entries."""
    native = a.dtype != object and b.dtype != object
    if native and _magnitude(a) * _magnitude(b) * a.shape[-1] < INT64_SAFE:
        return np.asarray(a @ b)
    return narrow(np.asarray(a.astype(object) @ b.astype(object)))


def dot(a: Iterable[int], b: Iterable[int]) -> int:
    """An inner product of integers in Python's unbounded arithmetic."""
    return sum(int(x) * int(y) for x, y in zip(a, b, strict=True))


@dataclass(frozen=True, eq=False)
class RationalMatrix:
    """A matrix of rational numbers: ``numerators / denominator``.

    Parameters
    ----------
    numerators
        Integer array of shape (m, n).
    denominator
        A positive integer.

    Examples
    --------
    >>> m = RationalMatrix.from_rows([["1/2", 0], [1, "1/3"]])
    >>> m
    RationalMatrix([[1/2, 0], [1, 1/3]])
    >>> m.inverse() @ m == RationalMatrix.identity(2), m.det()
    (True, Fraction(1, 6))
    """

    numerators: np.ndarray
    denominator: int = 1

    def __post_init__(self) -> None:
        if self.numerators.dtype.kind not in "iuO":
            raise InexactInput(f"an array of {self.numerators.dtype} is inexact: give integers")
        if isinstance(self.denominator, bool) or not self.denominator > 0:
            raise InvalidInput(f"{self.denominator} is no denominator: give a positive integer")
        kept = self.numerators
        if kept.dtype not in (np.int64, object):
            kept = kept.astype(object if kept.dtype == np.uint64 else np.int64)
        kept = kept.view()
        kept.setflags(write=False)  # what is computed once is shared by all who ask
        object.__setattr__(self, "numerators", kept)

    def __reduce__(self) -> tuple[Any, ...]:
        return RationalMatrix, (self.numerators, self.denominator)  # without FLINT's copy

    @classmethod
    def from_rows(cls, rows: Sequence[Sequence[object]]) -> RationalMatrix:
        """Read a matrix from rows of exact rationals, all of one length."""
        entries = [[rational(x) for x in row] for row in rows]
        if len({len(row) for row in entries}) > 1:
            raise InvalidInput(f"rows have different lengths: {sorted({len(row) for row in entries})}")
        denominator = math.lcm(*(x.denominator for row in entries for x in row))
        shape = (len(entries), len(entries[0]) if entries else 0)
        flat = [x.numerator * (denominator // x.denominator) for row in entries for x in row]
        return cls(narrow(np.array(flat, dtype=object).reshape(shape)), denominator)

    @classmethod
    def identity(cls, n: int) -> RationalMatrix:
        """The unit matrix of size n."""
        return cls(np.eye(n, dtype=np.int64))

    @property
    def shape(self) -> tuple[int, int]:
        """Number of rows and of columns."""
        return self.numerators.shape[0], self.numerators.shape[1]

    @property
    def T(self) -> RationalMatrix:
        """The transposed matrix."""
        return RationalMatrix(self.numerators.T, self.denominator)

    def __getitem__(self, index: tuple[int, int]) -> Fraction:
        return Fraction(int(self.numerators[index]), self.denominator)

    def row(self, i: int) -> tuple[Fraction, ...]:
        """Row i as fractions."""
        return tuple(Fraction(int(n), self.denominator) for n in self.numerators[i])

    def rows(self) -> tuple[tuple[Fraction, ...], ...]:
        """All rows as fractions."""
        return tuple(self.row(i) for i in range(self.shape[0]))

    def __matmul__(self, other: RationalMatrix) -> RationalMatrix:
        product = integer_product(self.numerators, other.numerators)
        return RationalMatrix(product, self.denominator * other.denominator)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, RationalMatrix) or self.shape != other.shape:
            return False
        a, b = self.numerators.astype(object), other.numerators.astype(object)
        return bool((a * other.denominator == b * self.denominator).all())

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        rows = ("[" + ", ".join(map(str, row)) + "]" for row in self.rows())
        return f"RationalMatrix([{', '.join(rows)}])"

    def _repr_latex_(self) -> str | None:
        if max(self.shape) > 12:
            return None  # too large to typeset; the plain form is shown
        entries = [[_latex(x) for x in row] for row in self.rows()]
        body = r" \\ ".join(" & ".join(row) for row in entries)
        return rf"$\begin{{pmatrix}} {body} \end{{pmatrix}}$"

    @cached_property
    def _flint(self) -> flint.fmpz_mat:
        return flint.fmpz_mat(*self.shape, [int(n) for n in self.numerators.ravel()])

    def det(self) -> Fraction:
        """The determinant of a square matrix."""
        return Fraction(int(self._flint.det()), self.denominator ** self.shape[0])

    def rank(self) -> int:
        """The rank."""
        return int(self._flint.rank())

    def inverse(self) -> RationalMatrix:
        """The inverse; raises `ZeroDivisionError` if there is none."""
        numerators, denominator = flint.fmpq_mat(self._flint).inv().numer_denom()
        entries = np.array([int(n) for n in numerators.entries()], dtype=object).reshape(self.shape)
        sign = -1 if denominator < 0 else 1
        return RationalMatrix(narrow(entries * (sign * self.denominator)), abs(int(denominator)))


def _latex(x: Fraction) -> str:
    if x.denominator == 1:
        return str(x)
    sign = "-" if x < 0 else ""
    return rf"{sign}\tfrac{{{abs(x.numerator)}}}{{{x.denominator}}}"
