"""Triangulations of space by several kinds of tetrahedra, with the atoms of alloys as vertices.

Space has no triangulation by regular tetrahedra. But the atoms of some alloys, the Frank-Kasper phases, lie
so that all holes between them are nearly regular tetrahedra. The cells are found by SciPy's Delaunay
triangulation, and then certified exactly:

* no atom lies in the closed circumscribed ball of a tetrahedron, but its vertices: so it is a Delaunay cell;
* Delaunay cells overlap nowhere, so they fill space if the volumes of those in a period add up to the
  period's.

Source: Eppstein, Sullivan and Üngör, Tiling space and slabs with acute tetrahedra, 2004, on these crystals as
triangulations; Conway and Torquato, Packing, tiling, and covering with tetrahedra, 2006, on them as tilings.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import combinations, permutations, product

import numpy as np

from ..errors import InvalidInput
from ..exact import Surd, rational, sqrt
from ..quality import Measure, find_measure
from ..simplex import Simplex

Atom = tuple[int, ...]
_FCC = ((0, 0, 0), (0, 4, 4), (4, 0, 4), (4, 4, 0))


@dataclass(frozen=True)
class Crystal:
    """Points of R^d that repeat with an integer period along each axis.

    Attributes
    ----------
    name
        What crystallographers call it.
    period
        The period.
    atoms
        Integer points, one of each class up to the period; their length is the dimension.

    Raises
    ------
    InvalidInput
        If the period is no positive integer, or the atoms are no integer points of one dimension.

    Examples
    --------
    >>> len(BCC.cells), BCC.quality("thickness")
    (12, sqrt(2)/2)
    """

    name: str
    period: int
    atoms: tuple[Atom, ...] = field(repr=False)

    def __post_init__(self) -> None:
        if type(self.period) is not int or self.period < 1:
            raise InvalidInput(f"{self.period!r} is no period of a crystal: give a positive integer")
        entries = {type(x) for atom in self.atoms for x in atom}
        if entries != {int} or len({len(atom) for atom in self.atoms}) != 1:
            raise InvalidInput(
                f"{self.atoms!r} are no atoms: give points of one dimension with integer entries"
            )

    @cached_property
    def cells(self) -> tuple[tuple[Atom, ...], ...]:
        """The Delaunay cells up to translation, certified; those whose centre of mass lies in the period.

        Raises
        ------
        InvalidInput
            If some Delaunay cell is no simplex: then too many points lie on one sphere.
        """
        from scipy.spatial import Delaunay

        points = self._around(2)
        candidates = points[Delaunay(points).simplices]
        d = points.shape[1]
        middle = candidates.sum(axis=1)
        chosen = candidates[((middle >= 0) & (middle < self.period * (d + 1))).all(axis=1)]
        edges = (chosen[:, 1:] - chosen[:, :1]).tolist()
        volumes = [abs(_determinant(e)) for e in edges]
        cells = tuple(tuple(tuple(map(int, v)) for v in cell) for cell in chosen)
        fills = sum(volumes) == math.factorial(d) * self.period**d and 0 not in volumes
        if not fills or any(self._power(cell) <= 0 for cell in cells):
            raise InvalidInput(f"{self.name}: its Delaunay cells are not all simplices: move the points")
        return cells

    @cached_property
    def kinds(self) -> dict[Simplex, int]:
        """Its simplices up to congruence, with the number of each in a period."""
        count = Counter(_shape(cell) for cell in self.cells)
        shown = {_shape(cell): cell for cell in self.cells}
        return {Simplex(shown[shape]): n for shape, n in sorted(count.items())}

    def quality(self, measure: str | Measure[Surd]) -> Surd:
        """The least value of a measure over all simplices."""
        known: Measure[Surd] = measure if isinstance(measure, Measure) else find_measure(measure)
        return min(known(simplex) for simplex in self.kinds)

    @property
    def relative_protection(self) -> Surd:
        """The relative protection of Definition 19.

        >>> BCC.relative_protection
        -1 + sqrt(65)/5
        """
        return (
            sqrt(1 + min(self._power(cell) / Simplex(cell).squared_circumradius for cell in self.cells)) - 1
        )

    def _around(self, periods: int) -> np.ndarray:
        """The atoms of the period at the origin, and of so many on each side of it."""
        shifts = product(range(-periods, periods + 1), repeat=len(self.atoms[0]))
        moves = self.period * np.array(list(shifts), dtype=np.int64)
        first = np.array(self.atoms, dtype=np.int64) % self.period
        return (first[None] + moves[:, None]).reshape(-1, moves.shape[1])

    def _power(self, cell: Sequence[Atom]) -> Fraction:
        """The least power of another atom over the circumscribed sphere: squared distance from c less R².

        The atoms of two periods on each side are looked at. They are all that lie in the cube of the points
        with entries between -2 and 2 periods; so it is enough if the nearest that is found is nearer to the
        centre than the sides of that cube. Products may be large: they are Python's integers.
        """
        simplex = Simplex(cell)
        square, common = simplex.squared_circumradius, math.lcm(*(x.denominator for x in _centre(simplex)))
        centre = np.array([int(x * common) for x in _centre(simplex)], dtype=object)
        squares = ((common * self._around(2).astype(object) - centre) ** 2).sum(axis=1)
        on_cell = common**2 * square
        others = np.sort(squares)[len(cell) :]  # its own vertices come first, unless another atom is as near
        reach = (2 * self.period * common - int(np.abs(centre).max())) ** 2
        if 2 * self.period * common <= np.abs(centre).max() or others[0] >= reach:
            raise InvalidInput(f"{self.name}: a ball reaches beyond two periods: give more atoms to a period")
        return Fraction(int(others[0]) - int(on_cell), common**2)


def _centre(simplex: Simplex) -> list[Fraction]:
    return [rational(x) for x in simplex.circumcentre]


def _determinant(rows: list[list[int]]) -> int:
    if len(rows) == 1:
        return rows[0][0]
    minors = ([row[:k] + row[k + 1 :] for row in rows[1:]] for k in range(len(rows)))
    return sum((-1) ** k * rows[0][k] * _determinant(minor) for k, minor in enumerate(minors))


def _shape(cell: Sequence[Atom]) -> tuple[int, ...]:
    """The squared edge lengths, in the order that makes them least: the same for congruent cells."""
    square = {(p, q): sum((x - y) ** 2 for x, y in zip(p, q, strict=True)) for p, q in permutations(cell, 2)}
    return min(tuple(square[pair] for pair in combinations(order, 2)) for order in permutations(cell))


BCC = Crystal("bcc", 2, ((0, 0, 0), (1, 1, 1)))
"""Body-centred cubic, the vertices of A~3: here the cells are all congruent."""

A15 = Crystal(
    "A15", 4,
    ((0, 0, 0), (2, 2, 2), (1, 2, 0), (3, 2, 0), (0, 1, 2), (0, 3, 2), (2, 0, 1), (2, 0, 3)),
)  # fmt: skip
"""Cr3Si: the corners and the centre of a cube, and two points on each of its faces."""

C15 = Crystal(
    "C15", 8,
    tuple(
        tuple((x + y) % 8 for x, y in zip(shift, atom, strict=True))
        for shift in _FCC
        for atom in ((1, 1, 1), (7, 7, 7), (4, 4, 4), (4, 2, 2), (2, 4, 2), (2, 2, 4))
    ),
)  # fmt: skip
"""MgCu2: a diamond of magnesium, and tetrahedra of copper in the gaps."""
