"""The root, coroot, weight and coweight lattices of a root system (paper, Section 2.3).

References: Humphreys, Section 2.9; Bourbaki, *Lie*, VI, §1.9; Conway and Sloane, Chapter 4.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from .errors import InvalidInput
from .exact import RationalMatrix, as_vector, show
from .root_sets import coroots
from .roots import RootSystem


@dataclass(frozen=True, eq=False)
class Lattice:
    """All integer combinations of linearly independent rational vectors.

    Parameters
    ----------
    basis
        The basis vectors as rows; `Lattice.spanned_by` reads them and checks their independence.

    Examples
    --------
    >>> square = Lattice(RationalMatrix.identity(2))
    >>> (2, 3) in square, ("1/2", 0) in square
    (True, False)
    """

    basis: RationalMatrix

    @classmethod
    def spanned_by(cls, rows: Iterable[Sequence[object]]) -> Lattice:
        """The lattice with the given basis vectors, exact coordinates in rows.

        Raises `InvalidInput` if they are linearly dependent.
        """
        basis = RationalMatrix.from_rows(list(rows))
        if basis.rank() < basis.shape[0]:
            raise InvalidInput(f"{basis.shape[0]} vectors of rank {basis.rank()} are no basis")
        return cls(basis)

    @property
    def rank(self) -> int:
        """The number of basis vectors."""
        return self.basis.shape[0]

    @cached_property
    def _dual(self) -> RationalMatrix:
        return (self.basis @ self.basis.T).inverse() @ self.basis

    @property
    def gram_determinant(self) -> Fraction:
        """The determinant of the Gram matrix of a basis, the squared volume of a fundamental cell."""
        return (self.basis @ self.basis.T).det()

    def dual(self) -> Lattice:
        """The dual lattice: the vectors of the span with integer products with all of the lattice."""
        return Lattice(self._dual)

    def coordinates(self, vector: Sequence[object]) -> tuple[Fraction, ...]:
        """Coordinates of a vector in the basis; raises `InvalidInput` if it lies outside the span."""
        row = RationalMatrix.from_rows([as_vector(vector, self.basis.shape[1])])
        result = row @ self._dual.T
        if result @ self.basis != row:
            raise InvalidInput(f"{show(row.row(0))} does not lie in the span of the lattice")
        return result.row(0)

    def __contains__(self, vector: Sequence[object]) -> bool:
        try:
            return all(x.denominator == 1 for x in self.coordinates(vector))
        except InvalidInput:
            as_vector(vector, self.basis.shape[1])  # a vector that cannot be read is an error
            return False

    def __le__(self, other: Lattice) -> bool:
        """Whether this lattice is contained in another."""
        same_space = self.basis.shape[1] == other.basis.shape[1]
        return same_space and all(row in other for row in self.basis.rows())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Lattice) and self <= other and other <= self

    __hash__ = None  # type: ignore[assignment]

    def index_in(self, other: Lattice) -> int:
        """The index [other : self] of this lattice in one that contains it.

        >>> Lattice.spanned_by([(2, 0), (0, 3)]).index_in(Lattice.spanned_by([(1, 0), (0, 1)]))
        6

        Raises `InvalidInput` if it is not contained in the other, or of lower rank.
        """
        if self.rank != other.rank or not self <= other:
            raise InvalidInput("the lattice is not contained, with finite index, in the other")
        rows = RationalMatrix.from_rows([other.coordinates(row) for row in self.basis.rows()])
        return abs(int(rows.det()))


def root_lattice(system: RootSystem) -> Lattice:
    """Λ_R: integer combinations of the roots; the simple roots are a basis (Definition 9)."""
    return Lattice(system.simple_roots)


def coroot_lattice(system: RootSystem) -> Lattice:
    """Λ_R∨: integer combinations of the coroots; the simple coroots are a basis (Definition 11)."""
    return Lattice(coroots(system.simple_roots))


def coweight_lattice(system: RootSystem) -> Lattice:
    """The vectors with integer inner product with all roots (Definition 12): dual to the root lattice.

    Its basis are the fundamental coweights.

    >>> from coxeter.roots import root_system
    >>> root_lattice(root_system("A3")).index_in(coweight_lattice(root_system("A3")))
    4
    """
    return Lattice(system.fundamental_coweights)


def weight_lattice(system: RootSystem) -> Lattice:
    """The vectors with integer inner product with all coroots (Definition 12)."""
    return coroot_lattice(system).dual()
