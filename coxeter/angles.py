"""Dihedral and solid angles of a simplex, from the Gram matrix of the gradients of its coordinates.

Dihedral angles are in degrees, solid angles shares of the whole sphere, so that 1/8 is the corner of a cube.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from fractions import Fraction
from functools import cached_property

import numpy as np

from .cartan import reflection_group_order
from .errors import InvalidInput, Unavailable
from .exact import Angle, RationalMatrix, Surd, arccos, regular_share, sqrt

SUBMULTIPLES = {0: 2, 1: 3, 2: 4, 3: 6}
"""4·cos²(π/m) -> m."""


class WithAngles(ABC):
    """The angles of anything that knows `gradient_gram`."""

    @property
    @abstractmethod
    def gradient_gram(self) -> RationalMatrix:
        """The inner products of the gradients of the barycentric coordinates."""

    def dihedral_cosine(self, i: int, j: int) -> Surd:
        """The cosine of the dihedral angle between the facets opposite to vertices i and j.

        >>> from coxeter.simplex import Simplex
        >>> Simplex([(0, 0), (1, 0), (0, 1)]).dihedral_cosine(0, 1)
        sqrt(2)/2
        """
        d = self.gradient_gram.shape[0] - 1
        if i == j or not {i, j} <= set(range(d + 1)):
            raise InvalidInput(f"{i} and {j} are not two facets: give two of 0 to {d}")
        g = self.gradient_gram
        return -g[i, j] / sqrt(g[i, i] * g[j, j])

    def dihedral_angle_in_degrees(self, i: int, j: int) -> Angle:
        """The angle between the facets opposite to vertices i and j, in degrees.

        >>> from coxeter.simplex import regular_simplex
        >>> regular_simplex(3).dihedral_angle_in_degrees(0, 1)
        180*acos(1/3)/pi
        """
        return 180 * arccos(self.dihedral_cosine(i, j))

    @cached_property
    def minimal_dihedral_angle(self) -> Angle:
        """The smallest dihedral angle, in degrees; of a segment, which has none, 0.

        >>> from coxeter.simplex import Simplex
        >>> Simplex([(0, 0), (1, 0), (0, 1)]).minimal_dihedral_angle
        45
        """
        return _in_degrees(max(self._signed_squares))

    @cached_property
    def maximal_dihedral_angle(self) -> Angle:
        """The largest dihedral angle, in degrees; of a segment, which has none, 0.

        >>> from coxeter.simplex import Simplex
        >>> Simplex([(0, 0), (1, 0), (0, 1)]).maximal_dihedral_angle
        90
        """
        return _in_degrees(min(self._signed_squares))

    @cached_property
    def _signed_squares(self) -> frozenset[Fraction]:
        """cos·|cos| of all dihedral angles: as the cosine decides, so does this, and it is rational.

        Zeros are not looked at one by one: a fundamental simplex of large dimension has little else.
        """
        g = self.gradient_gram.numerators
        rows, columns = np.nonzero(np.triu(g, 1))
        triples = {(int(g[i, j]), int(g[i, i]) * int(g[j, j])) for i, j in zip(rows, columns, strict=True)}
        d = len(g) - 1
        zero = [Fraction(0)] if len(rows) < d * (d + 1) // 2 else []
        return frozenset([*zero, *(Fraction(-x * abs(x), y) for x, y in triples)])

    @cached_property
    def minimal_solid_angle(self) -> Angle:
        """The smallest solid angle at a vertex, as a share of the whole sphere; see `solid_angle`.

        >>> from coxeter.simplex import Simplex
        >>> Simplex([(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)]).minimal_solid_angle
        1/48
        """
        if self._labels is not None:
            return Angle({None: Fraction(1, max(map(self.stabiliser_order, self._special())))})
        return min(self.solid_angle(k) for k in range(self.gradient_gram.shape[0]))

    def solid_angle(self, k: int) -> Angle:
        """The solid angle at vertex k, as a share of the whole sphere.

        * If all dihedral angles are submultiples of π, the reflections in the facets generate a group for
          which the simplex is a fundamental domain. Then it is 1 over the order of the stabiliser of vertex
          k, in every dimension (Coxeter 1934; Humphreys, Section 4.8).
        * For d = 2 it is the angle over 2π, for d = 3 the spherical excess, (sum of the three dihedral
          angles at the vertex - π)/4π.
        * That of the regular simplex is known for every d, see `coxeter.exact.regular_share`.

        Raises
        ------
        InvalidInput
            If there is no such vertex.
        Unavailable
            For any other simplex with d >= 4: then there is no closed form of this kind.

        Examples
        --------
        >>> from coxeter.simplex import Simplex
        >>> corner = Simplex([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
        >>> corner.solid_angle(0), corner.solid_angle(1)
        (1/8, -1/8 + acos(sqrt(3)/3)/(2*pi))
        """
        d = self.gradient_gram.shape[0] - 1
        if k not in range(d + 1):
            raise InvalidInput(f"{k} is no vertex: give one of 0 to {d}")
        if self._labels is not None:
            return Angle({None: Fraction(1, self.stabiliser_order(k))})
        if self._signed_squares == {Fraction(1, d * d)}:
            return regular_share(d)
        if d > 3:
            raise Unavailable(
                f"the solid angle at vertex {k} has no closed form here: from d = 4 on it is known for "
                "fundamental simplices of reflection groups and for the regular simplex"
            )
        others = [i for i in range(d + 1) if i != k]
        angles = [arccos(self.dihedral_cosine(i, j)) for i in others for j in others if i < j]
        return angles[0] / 2 if d == 2 else (sum(angles, Angle({})) - 1) / 4

    # -- the reflection group, if there is one ------------------------------------------------------

    @cached_property
    def _labels(self) -> dict[tuple[int, int], int] | None:
        """The pairs of facets at angles π/m with m > 2, and m; None if some angle is no such part of π."""
        if not all(4 * x in SUBMULTIPLES for x in self._signed_squares):
            return None
        g = self.gradient_gram.numerators
        rows, columns = np.nonzero(np.triu(g, 1))
        found = {}
        for i, j in zip(rows.tolist(), columns.tolist(), strict=True):
            found[i, j] = SUBMULTIPLES[4 * int(g[i, j]) ** 2 // (int(g[i, i]) * int(g[j, j]))]
        return found

    def _special(self) -> list[int]:
        """Vertices among which one has the largest stabiliser, the finite group: ends of the diagram.

        That of A~ is a cycle, without ends; there all vertices are alike (Humphreys, Section 2.5).
        """
        joined = Counter(i for pair in self._labels or {} for i in pair)
        return [i for i, n in joined.items() if n == 1] or [0]

    def stabiliser_order(self, k: int) -> int:
        """The order of the group that the reflections in all facets but facet k generate.

        Raises
        ------
        Unavailable
            If some dihedral angle is no submultiple of π, so that there need be no such group.

        Examples
        --------
        >>> from coxeter import triangulation
        >>> [triangulation("C~3").simplex.stabiliser_order(k) for k in range(4)]
        [48, 16, 16, 48]
        """
        if self._labels is None:
            raise Unavailable("some dihedral angle is no submultiple of π: the reflections may make no group")
        d = self.gradient_gram.shape[0] - 1
        diagram: dict[int, dict[int, int]] = {i: {} for i in range(d + 1) if i != k}
        for (i, j), m in self._labels.items():
            if k not in (i, j):
                diagram[i][j], diagram[j][i] = -1, -{3: 1, 4: 2, 6: 3}[m]
        return reflection_group_order(diagram)


def _in_degrees(signed_square: Fraction) -> Angle:
    cosine = sqrt(abs(signed_square))
    return 180 * arccos(cosine if signed_square >= 0 else -cosine)
