"""The reflection subgroup that sorting takes care of, and the walls that it leaves.

Each affine Weyl group contains one of a classical type, in the coordinates of the roots, whose fundamental
simplex holds that of the whole group. Folding by the subgroup is rounding and sorting. Few more walls cut out
the fundamental simplex of the whole group: none for the classical families, one or two for the others.

=========  ==============  ==============================================
family     subgroup        walls left (nodes)
=========  ==============  ==============================================
A B C D    itself          none
E8         D8              1
E7         D6, 6 of 8 c.   0, 1
E6         D5, 5 of 8 c.   0, 1
F4         B4              4
G2         A2              0, 2
=========  ==============  ==============================================

Conway and Sloane, *Sphere Packings, Lattices and Groups*, chapters 4, 20 and 21; Humphreys, *Reflection
Groups and Coxeter Groups*, 4.3 to 4.5.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..affine import CoxeterTriangulation

Ints = NDArray[np.int64]


@dataclass(frozen=True)
class Subgroup:
    """What folding needs to know of a triangulation.

    Attributes
    ----------
    triangulation
        The triangulation.
    kind
        The classical type of the subgroup: ``"A"``, ``"B"``, ``"C"`` or ``"D"``.
    order
        The coordinates that it acts on, from the greatest to the least in the fundamental simplex.
    walls
        The nodes of the walls that are left.
    """

    triangulation: CoxeterTriangulation
    kind: str
    order: tuple[int, ...]
    walls: tuple[int, ...]

    @property
    def classical(self) -> bool:
        """Whether it is the whole group."""
        return not self.walls

    @property
    def ambient(self) -> int:
        """The number of coordinates of a root."""
        return int(self.triangulation.roots.simple_roots.shape[1])

    @cached_property
    def whole(self) -> bool:
        """Whether the subgroup's lattice spans the space, so that rounding alone brings any point near."""
        return self.kind == "A" or len(self.order) == self.triangulation.dimension

    @cached_property
    def left(self) -> tuple[Wall, ...]:
        """The walls that are left."""
        return tuple(map(self.wall, self.walls))

    def wall(self, k: int) -> Wall:
        """The wall of node k."""
        facet = self.triangulation.facets[k]
        scale = lcm(*(x.denominator for x in facet.normal))
        normal = np.array([int(x * scale) for x in facet.normal], dtype=np.int64)
        return Wall(normal, facet.offset * scale, Fraction(2, int(normal @ normal)), scale)

    @cached_property
    def weights(self) -> tuple[Ints, int]:
        """The basis dual to the simple roots times a number, and that number; for E6 and E7, where it is
        needed, roots are coroots."""
        matrix = self.triangulation.roots.fundamental_coweights
        return matrix.numerators.astype(np.int64), matrix.denominator

    @cached_property
    def doubled_coroots(self) -> Ints:
        """Twice the simple coroots, as integers."""
        matrix = self.triangulation.roots.simple_roots
        return (matrix.numerators * 2 // matrix.denominator).astype(np.int64)


@dataclass(frozen=True, eq=False)
class Wall:
    """A wall <x, normal> = offset of the fundamental simplex, in integers.

    They are `scale` times those of the facet, 1 or 2; `factor` is 2 / <normal, normal>.
    """

    normal: Ints
    offset: int
    factor: Fraction
    scale: int

    def level(self, points: NDArray[Any], unit: Any) -> NDArray[Any]:
        """<x, normal> - offset for points (..., m): not negative on the side of the simplex."""
        level = np.full(points.shape[:-1], -self.offset * unit)
        for i in np.flatnonzero(self.normal):  # in order, so that floats round as in the compiled code
            level = level + points[..., i] * self.normal[i]
        return level

    def reflect(self, points: NDArray[Any], unit: Any) -> NDArray[Any]:
        """The mirror images of points (..., m)."""
        level = self.level(points, unit) * self.factor.numerator
        if points.dtype.kind == "f":
            return points - (level / self.factor.denominator)[..., None] * self.normal
        return points - level[..., None] * self.normal // self.factor.denominator


def subgroup(triangulation: CoxeterTriangulation) -> Subgroup:
    """The subgroup for a triangulation.

    >>> from coxeter import triangulation
    >>> subgroup(triangulation("E~8")).order
    (7, 6, 5, 4, 3, 2, 1, 0)
    """
    letter, d = triangulation.type.letter, triangulation.dimension
    if letter in "ABCD":
        return Subgroup(triangulation, letter, tuple(range(d + (letter == "A"))), ())
    kind, order, walls = {
        ("E", 8): ("D", range(7, -1, -1), (1,)),
        ("E", 7): ("D", range(5, -1, -1), (0, 1)),
        ("E", 6): ("D", range(4, -1, -1), (0, 1)),
        ("F", 4): ("B", range(4), (4,)),
        ("G", 2): ("A", (2, 0, 1), (0, 2)),
    }[letter, d]
    return Subgroup(triangulation, kind, tuple(order), walls)
