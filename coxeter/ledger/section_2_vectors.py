"""Section 2.2, beginning: vectors with given inner products."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import product

import numpy as np

from ..errors import CoxeterError
from ..exact import RationalMatrix, Surd, sqrt
from ..roots import root_system
from .claim import Constants, Finding, agree, claim
from .instances import systems
from .section_2_groups import is_stable
from .vocabulary import EVERY_D, Weight
from .wording import fits

RESULT, WORDING = Weight.RESULT, Weight.WORDING


def _vectors(cartan: np.ndarray) -> list[list[Surd]] | None:
    """Vectors with the matrix as their inner products, by elimination; None if it is not positive
    definite."""
    rows: list[list[Fraction]] = []
    squares: list[Fraction] = []
    for i in range(len(cartan)):
        row: list[Fraction] = []
        for j in range(i):
            known = sum((a * b * c for a, b, c in zip(row, rows[j], squares, strict=False)), Fraction(0))
            row.append((int(cartan[i, j]) - known) / squares[j])
        rest = int(cartan[i, i]) - sum((a * a * c for a, c in zip(row, squares, strict=True)), Fraction(0))
        if rest <= 0:
            return None
        rows.append([*row, Fraction(1)])
        squares.append(rest)
    size = len(cartan)
    return [
        [x * sqrt(c) for x, c in zip(row, squares, strict=False)] + [Surd(0)] * (size - len(row))
        for row in rows
    ]


@lru_cache(maxsize=1)
def _realised() -> dict[int, Fraction]:
    """d -> the dimension that vectors with the products of a Cartan matrix span."""
    found = {}
    for system in systems(5, "ADE"):
        cartan = system.cartan_matrix
        vectors = _vectors(cartan)
        for i, j in product(range(system.rank), repeat=2):
            if vectors is None or sum(
                (a * b for a, b in zip(vectors[i], vectors[j], strict=True)), Surd(0)
            ) != int(cartan[i, j]):
                raise CoxeterError(f"elimination does not find the vectors of {system.name}")
        found[system.rank] = Fraction(RationalMatrix(cartan).rank())
    return found


@claim("sec2.independent", "Section 2.2", RESULT, to_state=["def-2"])
def independent(printed: Constants) -> Finding:
    """Vectors whose inner products are a positive definite Cartan matrix are linearly independent."""
    true = all(
        RationalMatrix(s.cartan_matrix).det() != 0 and s.simple_roots.rank() == s.rank
        for s in systems(8, "ADE")
    )
    return agree(
        printed, {"independent": true}, EVERY_D,
        "A relation between the vectors would be one between the columns of the matrix of their products, "
        "which is invertible.",
    )  # fmt: skip


@claim("prop-2", "Section 2.2, Proposition 2", RESULT, to_state=["def-2"])
def proposition_2(printed: Constants) -> Finding:
    """Vectors whose inner products are a given positive definite Cartan matrix exist in a space of
    dimension {space}."""
    return agree(
        printed, {"space": fits(printed["space"], "d", _realised())}, EVERY_D,
        "Gaussian elimination of a positive definite matrix gives $C=LDL^t$ with a lower triangular L and "
        "a diagonal D > 0. The rows of $L\\sqrt D$ are such vectors; as C has rank d, no smaller space has "
        "any.",
        "Computed for $A_d$ and $D_d$ up to d = 5, and the products multiplied out.",
    )  # fmt: skip


@claim("rem-1", "Section 2.2, Remark 1", WORDING, to_state=["prop-2"])
def remark_1(printed: Constants) -> Finding:
    """The choice of the vectors is not unique, and nicer ones exist in a larger space."""
    a2 = root_system("A2")
    determinant = RationalMatrix(a2.cartan_matrix).det()
    rational_in_plane = sqrt(determinant).is_rational
    gram = a2.simple_roots @ a2.simple_roots.T
    opposite = RationalMatrix(-a2.simple_roots.numerators, a2.simple_roots.denominator)
    integral = a2.simple_roots.denominator == 1 and gram == RationalMatrix(a2.cartan_matrix)
    unique = opposite @ opposite.T != gram
    return agree(
        printed, {"unique": unique, "nicer_in_larger_space": integral and not rational_in_plane}, EVERY_D,
        "Each rotation of the vectors is another choice.",
        "For $A_2$: two vectors of the plane with rational coordinates would have a rational determinant, "
        f"with square {determinant}. In space $e_1-e_2$, $e_2-e_3$ have whole coordinates.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _stable_families() -> tuple[str, ...]:
    found = {s.type.family: True for s in systems(8, "ADE")}
    for s in systems(8, "ADE"):
        found[s.type.family] &= is_stable(s)
    return tuple(sorted(family for family, stable in found.items() if stable))


@claim("sec2.stable", "Section 2.2", RESULT, to_state=["def-3", "prop-2"])
def stable(printed: Constants) -> Finding:
    """The root sets of the diagrams {types} are mapped to themselves by the reflections in their roots,
    which generate a finite group."""
    return agree(
        printed, {"types": _stable_families()}, EVERY_D,
        "For a root $r=w(e_i)$ the reflection in r is $w\\sigma_iw^{-1}$, an element of the group, and the "
        "roots are orbits of the group. A finite set that spans has finitely many symmetries.",
        "Computed up to rank 8.",
    )  # fmt: skip
