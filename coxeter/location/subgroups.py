"""The reflection subgroup that rounding and sorting take care of.

Each affine Weyl group contains one of classical type and full rank: strike out a node of the extended
diagram, and what is left is made of classical diagrams (Borel and de Siebenthal). In the coordinates y of
their roots folding is rounding and sorting. The fundamental simplex of the subgroup is cut into few
simplices of the whole group, `cells`: |W| / |W'| times the index of the coroot lattices.

=======  ==============  ================  =====
family   subgroup        node struck out   cells
=======  ==============  ================  =====
A B C D  itself          none              1
E8       D8              1                 270
E7       D6 + A1         1                 126
E6       A5 + A1         2                 72
F4       B4              4                 3
G2       A2              1                 2
=======  ==============  ================  =====

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
from ..affine import triangulation as classical

Ints = NDArray[np.int64]

PARTS: dict[str, tuple[tuple[str, tuple[int, ...]], ...]] = {
    "E~8": (("D", (0, 8, 7, 6, 5, 4, 3, 2)),),
    "E~7": (("D", (7, 6, 5, 4, 3, 2)), ("C", (0,))),
    "E~6": (("A", (1, 3, 4, 5, 6)), ("C", (0,))),
    "F~4": (("B", (0, 1, 2, 3)),),
    "G~2": (("A", (0, 2)),),
}
"""The classical diagrams that are left: their types, and their nodes in the order of the simple roots."""


@dataclass(frozen=True)
class Part:
    """A classical factor: its type, its nodes, and the columns of y that it acts on."""

    kind: str
    nodes: tuple[int, ...]
    start: int

    @property
    def columns(self) -> slice:
        """As a slice."""
        return slice(self.start, self.start + len(self.nodes) + (self.kind == "A"))


@dataclass(frozen=True)
class Subgroup:
    """What folding needs to know of a triangulation: its name, and the factors of the subgroup."""

    triangulation: CoxeterTriangulation
    parts: tuple[Part, ...]

    @property
    def classical(self) -> bool:
        """Whether it is the whole group; then y are the coordinates of the roots themselves."""
        return self.triangulation.name not in PARTS

    @property
    def ambient(self) -> int:
        """The number of coordinates of a root."""
        return int(self.triangulation.roots.simple_roots.shape[1])

    @cached_property
    def width(self) -> int:
        """The number of coordinates y."""
        return int(self.parts[-1].columns.stop)

    def wall(self, k: int) -> Wall:
        """The wall of node k."""
        facet = self.triangulation.facets[k]
        scale = lcm(*(x.denominator for x in facet.normal))
        normal = np.array([int(x * scale) for x in facet.normal], dtype=np.int64)
        return Wall(normal, facet.offset * scale, Fraction(2, int(normal @ normal)), scale)

    @cached_property
    def dyadic(self) -> bool:
        """Whether the coordinates y of a point have no more binary digits than its own, but for a few."""
        return self.classical or self.inward[1].bit_count() == 1

    # -- the change of coordinates, as integers over a denominator: none for the classical families --------

    @cached_property
    def inward(self) -> tuple[Ints, int]:
        """y = z · matrix: the sum of <z, root> · coweight over the simple roots of the parts."""
        return _over(sum(np.multiply.outer(z, w) for z, _, _, w in self._bases))

    @cached_property
    def outward(self) -> tuple[Ints, int]:
        """z = y · matrix: the sum of <y, root> · coweight, with roots in y and coweights in z."""
        return _over(sum(np.multiply.outer(y, w) for _, w, y, _ in self._bases))

    def into(self, z: NDArray[Any]) -> NDArray[Any]:
        """Points (n, m) in the coordinates y; exact ones must be multiples of 12."""
        if self.classical:
            return z
        matrix, denominator = self.inward
        return z @ (matrix / denominator) if z.dtype.kind == "f" else z @ matrix // denominator

    @cached_property
    def _bases(self) -> list[tuple[NDArray[Any], ...]]:
        """For each simple root of the subgroup: it and its coweight in the coordinates z, and both in y."""
        t, found = self.triangulation, []
        corners = _fractions(t.simplex.vertex_matrix)
        (left,) = set(range(t.dimension + 1)) - {k for part in self.parts for k in part.nodes}
        for part in self.parts:
            roots = _roots_of(part.kind, len(part.nodes))
            for k, root, weight in zip(part.nodes, *roots, strict=True):
                places = [np.full(self.width, Fraction(0)) for _ in range(2)]
                places[0][part.columns], places[1][part.columns] = root, weight
                coweight = (corners[k] - corners[left]) * t.marks[k]
                found.append((np.array(t.facets[k].normal, dtype=object), coweight, *places))
        return found


def _roots_of(kind: str, rank: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """Simple roots and fundamental coweights; by hand for A1, which sorts a single number as C1 does."""
    if rank == 1:
        return np.array([[2]]), np.array([[Fraction(1, 2)]])
    roots = classical(f"{kind}~{rank}").roots
    return _fractions(roots.simple_roots), _fractions(roots.fundamental_coweights)


def _fractions(matrix: Any) -> NDArray[Any]:
    return np.asarray(np.asarray(matrix.numerators, dtype=object) * Fraction(1, matrix.denominator))


def _over(matrix: Any) -> tuple[Ints, int]:
    """Fractions as integers over the least denominator."""
    denominator = lcm(*(x.denominator for x in matrix.flat))
    return (matrix * denominator).astype(np.int64), denominator


@dataclass(frozen=True, eq=False)
class Wall:
    """A wall <z, normal> = offset of the fundamental simplex, in integers.

    They are `scale` times those of the facet, 1 or 2; `factor` is 2 / <normal, normal>.
    """

    normal: Ints
    offset: int
    factor: Fraction
    scale: int

    def reflect(self, points: Ints, unit: int) -> Ints:
        """The mirror images of points (..., m), given as integers over a unit."""
        levels = (points @ self.normal - self.offset * unit) * self.factor.numerator
        images: Ints = points - levels[..., None] * self.normal // self.factor.denominator
        return images


def subgroup(triangulation: CoxeterTriangulation) -> Subgroup:
    """The subgroup for a triangulation.

    >>> from coxeter import triangulation
    >>> [part.kind for part in subgroup(triangulation("E~7")).parts]
    ['D', 'C']
    """
    itself = ((triangulation.type.letter, tuple(range(1, triangulation.dimension + 1))),)
    parts: list[Part] = []
    for kind, nodes in PARTS.get(triangulation.name, itself):
        parts.append(Part(kind, nodes, parts[-1].columns.stop if parts else 0))
    return Subgroup(triangulation, tuple(parts))
