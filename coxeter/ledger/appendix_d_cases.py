"""The propositions of Section 6 on vertex sets, their witnesses as printed, and the exact answers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

from ..affine import CoxeterTriangulation, triangulation
from ..claims.points import SIGN
from ..claims.runs import coordinates
from ..errors import InvalidInput
from ..families import evaluate
from ..lattices import LatticeProof, NonLatticeWitness, vertex_lattice
from ..paper import PrintedStatement
from ..paper import printed as paper
from .claim import Constants
from .vectors import Point, along, point, rational_point


@dataclass(frozen=True)
class Case:
    """A proposition of Section 6 on the vertex set of a family, with the dimensions that are tried."""

    proposition: int
    letter: str
    dimensions: tuple[int, ...]

    @property
    def place(self) -> str:
        """Where its proof stands."""
        return f"Appendix D, proof of Proposition {self.proposition}"

    @property
    def id(self) -> str:
        """The id of the proposition."""
        return f"prop-{self.proposition}"

    @property
    def infinite(self) -> bool:
        """Whether the family is infinite."""
        return len(self.dimensions) > 1

    def at(self, d: int) -> CoxeterTriangulation:
        """The triangulation in dimension d."""
        return _triangulation(self.letter, d)

    @property
    def first(self) -> CoxeterTriangulation:
        """The first one."""
        return self.at(self.dimensions[0])


@lru_cache(maxsize=64)
def _triangulation(letter: str, d: int) -> CoxeterTriangulation:
    return triangulation((letter, d))


CASES = {
    case.proposition: case
    for case in (
        Case(8, "B", tuple(range(3, 13))),
        Case(9, "C", tuple(range(2, 13))),
        Case(10, "D", tuple(range(4, 13))),
        Case(11, "E", (6,)),
        Case(12, "E", (7,)),
        Case(13, "E", (8,)),
        Case(14, "F", (4,)),
    )
}


def fraction(x: object, d: int = 0, k: int = 0) -> Fraction:
    """A printed number, or a formula in d and k."""
    return evaluate(str(x), d=d, k=k).as_fraction()


def number(x: object, d: int) -> int:
    """An index or a count, a number or a formula in d."""
    value = fraction(x, d)
    if value.denominator != 1:
        raise InvalidInput(f"{x} is no integer for d = {d}")
    return int(value)


# -- the witnesses -----------------------------------------------------------------------------------------


def statement(case: Case, kind: str) -> PrintedStatement:
    """The statement of a kind that is recorded for the proof of a proposition."""
    found = [s for s in paper().statements if s.place == case.place and s.kind == kind]
    if len(found) != 1:
        raise InvalidInput(
            f"{len(found)} statements {kind!r} are recorded for {case.place}: there must be one"
        )
    return found[0]


def dimensions(case: Case) -> tuple[int, ...]:
    """The dimensions in which the proof has a witness."""
    return tuple(d for d in case.dimensions if d >= statement(case, "combination").low)


@lru_cache(maxsize=64)
def witness(case: Case, d: int) -> Point:
    """The vector v of a proof, as it is printed."""
    return spelled(statement(case, "combination").normal, d)


def spelled(runs: Sequence[tuple[str, str]], d: int) -> Point:
    """A vector written as runs of equal coordinates."""
    found = coordinates(tuple(runs), d, 0)
    if found is None:
        raise InvalidInput(f"{runs} is no vector for d = {d}")
    return rational_point(found)


def combination(case: Case, terms: Sequence[tuple[str, str]], d: int) -> Point:
    """The sum of multiples of the vertices, which have the signs of the paper."""
    t = case.at(d)
    rows = t.simplex.vertex_matrix.rows()
    total = point(*[0] * len(rows[0]))
    for coefficient, index in terms:
        k = number(index, d)
        if not 0 <= k <= d:
            raise InvalidInput(f"there is no vertex u_{k}")
        factor = number(coefficient, d) * SIGN.get(t.type.family, 1)
        total = along(total, Fraction(factor), rows[k])
    return total


# -- the answers -------------------------------------------------------------------------------------------


@lru_cache(maxsize=64)
def answer(case: Case, d: int) -> LatticeProof | NonLatticeWitness:
    """Whether the vertex set is a lattice, by a certificate that has been checked."""
    found = vertex_lattice(case.at(d))
    assert found.check()
    return found


def range_of(printed: Constants, proposition: int, low: int, lattice: bool) -> bool:
    """Whether the statement is about all d from `low` on, and its answer right for those that are tried."""
    case = CASES[proposition]
    dimensions = [d for d in case.dimensions if d >= low]
    right = all(answer(case, d).is_lattice is lattice for d in dimensions)
    return right and printed["first"] == low and printed["lattice"] is lattice


def smallest(case: Case) -> str:
    """Two vertices whose difference is no vertex."""
    found = answer(case, case.first.dimension)
    assert isinstance(found, NonLatticeWitness)
    whole = case.first.integral_roots(found.difference).rank()
    return (
        f"{found}: the roots with integer inner products with the difference have rank {whole}, a vertex "
        f"needs {case.first.dimension}."
    )
