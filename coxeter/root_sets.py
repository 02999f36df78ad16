"""Questions that can be asked of any finite set of vectors (paper, Section 2.2).

Is it a root system (Definition 4)? Crystallographic, reduced, irreducible? Which angles and lengths
occur (Definition 7 and the table after it)? Vectors are the rows of a rational matrix; nothing is
assumed about where they come from.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from .errors import InvalidInput
from .exact import RationalMatrix, Surd, as_vector, sqrt
from .exact.matrices import integer_product, narrow


def coroots(roots: RationalMatrix) -> RationalMatrix:
    """The vectors 2r/<r, r> for the rows r of a matrix (Definition 10).

    >>> coroots(RationalMatrix.from_rows([[0, 2], [1, 1]]))
    RationalMatrix([[0, 1], [1, 1]])
    """
    n = _without_zero(roots).numerators.astype(object)
    squares = [int(x) for x in (n**2).sum(axis=1)]
    common = math.lcm(*squares)
    factors = [2 * roots.denominator * (common // x) for x in squares]
    content = math.gcd(common, *factors)
    scaled = n * np.array([f // content for f in factors], dtype=object)[:, None]
    return RationalMatrix(narrow(scaled), common // content)


def vectors(rows: RationalMatrix | Iterable[Sequence[object]]) -> RationalMatrix:
    """Read a finite set of vectors given as rows; a `RationalMatrix` is returned as it is."""
    return rows if isinstance(rows, RationalMatrix) else RationalMatrix.from_rows(list(rows))


def _without_zero(rows: RationalMatrix) -> RationalMatrix:
    if not rows.numerators.any(axis=1).all():
        raise InvalidInput("one of the vectors is zero: it has no direction to reflect in")
    return rows


def _gram(rows: RationalMatrix) -> np.ndarray:
    """Inner products, up to the common factor ``denominator**2``."""
    return integer_product(rows.numerators, rows.numerators.T)


def is_root_system(rows: RationalMatrix | Iterable[Sequence[object]]) -> bool:
    """Whether a finite set of vectors satisfies Definition 4.

    No vector is zero, and the reflection in each maps the set to itself. The space is taken to be
    the span of the set, so that the roots of A_d in R^(d+1) qualify.

    >>> is_root_system([(1, 0), (-1, 0)]), is_root_system([(1, 0)])
    (True, False)
    """
    r = vectors(rows)
    gram, n = _gram(r), r.numerators.astype(object)
    members = {tuple(row) for row in n}
    if not len(n) or not gram.diagonal().all():
        return False
    return all(
        all(c % s == 0 for c in row) and tuple(c // s for c in row) in members
        for i, s in enumerate(int(x) for x in gram.diagonal())
        for row in s * n - 2 * np.outer(gram[i].astype(object), n[i])
    )


def is_crystallographic(rows: RationalMatrix | Iterable[Sequence[object]]) -> bool:
    """Whether 2<r, s>/<r, r> is an integer for all r, s of the set (Definition 4).

    >>> is_crystallographic([(1, 0), (-1, 0), (0, 3), (0, -3)])
    True
    >>> is_crystallographic([(3, 0), (-3, 0), (0, 3), (0, -3), (1, 1), (-1, -1), (1, -1), (-1, 1)])
    False
    """
    gram = _gram(_without_zero(vectors(rows)))
    return not ((2 * gram) % gram.diagonal()[:, None]).any()


def is_reduced(rows: RationalMatrix | Iterable[Sequence[object]]) -> bool:
    """Whether the only multiples of a vector within the set are itself and its negative.

    >>> is_reduced([(1, 0), (-1, 0)]), is_reduced([(1, 0), (-1, 0), (2, 0), (-2, 0)])
    (True, False)
    """
    gram = _gram(vectors(rows)).astype(object)
    squares = gram.diagonal()
    parallel = gram**2 == np.outer(squares, squares)
    return bool((squares[:, None] == squares[None, :])[parallel].all())


def is_irreducible(rows: RationalMatrix | Iterable[Sequence[object]]) -> bool:
    """Whether the set is not the union of two non-empty sets orthogonal to one another.

    >>> is_irreducible([(1, 0), (-1, 0), (0, 1), (0, -1)])
    False
    """
    import networkx as nx

    gram = _gram(vectors(rows))
    return bool(len(gram)) and nx.is_connected(nx.from_numpy_array(gram != 0))


def cartan_integer(s: Sequence[object], r: Sequence[object]) -> Fraction:
    """The number n(s, r) = 2<r, s>/<r, r> of Definition 7; an integer for crystallographic roots.

    It is divided by the squared length of the *second* argument. Remark 2 of the paper divides by
    that of the first; with Definition 7, the interpretation there reads n(s, r) = <s, r^v>.

    >>> cartan_integer((0, 1), (1, 1)), cartan_integer((1, 1), (0, 1))
    (Fraction(1, 1), Fraction(2, 1))
    """
    x, y = as_vector(s, len(s)), as_vector(r, len(s))
    square = sum(c * c for c in y)
    if not square:
        raise InvalidInput("the second vector is zero: no Cartan integer is defined")
    return 2 * sum((a * b for a, b in zip(x, y, strict=True)), Fraction(0)) / square


@dataclass(frozen=True, order=True)
class AnglePair:
    """How two roots r and s with ``|s| >= |r|`` can lie: one row of the table after Definition 7.

    Attributes
    ----------
    product
        4·cos² of the angle, which is n(s, r)·n(r, s).
    n_sr, n_rs
        The Cartan integers n(s, r) and n(r, s).
    angle
        The angle as a multiple of pi.
    ratio
        ``|s|/|r|``, or None where orthogonality leaves it open.
    """

    product: int
    n_sr: int
    n_rs: int
    angle: Fraction
    ratio: Surd | None


_ANGLES = {
    0: Fraction(1, 2),
    1: Fraction(1, 3),
    2: Fraction(1, 4),
    3: Fraction(1, 6),
    4: Fraction(0),
}


def angle_table(rows: RationalMatrix | Iterable[Sequence[object]]) -> tuple[AnglePair, ...]:
    """All relations of angle and length between two roots of a crystallographic root system.

    Raises `InvalidInput` if the vectors are not crystallographic.

    >>> for row in angle_table([(1, 0), (-1, 0), (0, 1), (0, -1)]):
    ...     print(row.product, row.n_sr, row.n_rs, row.angle, row.ratio)
    0 0 0 1/2 None
    4 -2 -2 1 1
    4 2 2 0 1
    """
    r = vectors(rows)
    if not is_crystallographic(r):
        raise InvalidInput("the vectors are not crystallographic: some 2<r, s>/<r, r> is no integer")
    gram = _gram(r)
    found = set()
    for i, j in zip(*np.nonzero(gram.diagonal()[:, None] <= gram.diagonal()[None, :]), strict=True):
        n_sr = int(2 * gram[i, j] // gram[i, i])  # r is row i, s is row j, the longer one
        n_rs = int(2 * gram[i, j] // gram[j, j])
        angle = _ANGLES[n_sr * n_rs]
        ratio = sqrt(Fraction(n_sr, n_rs)) if n_rs else None
        found.add(AnglePair(n_sr * n_rs, n_sr, n_rs, 1 - angle if n_sr < 0 else angle, ratio))
    return tuple(sorted(found, key=lambda row: (row.product, row.n_sr)))
