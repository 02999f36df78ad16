"""Root systems, from the simple roots of Theorem 3 up (paper, Sections 2.1 and 2.2).

Nothing but the simple roots is typed in. The highest root is climbed to, the roots are generated
by reflections, and the Gram matrix of the simple roots is inverted along the diagram, which is a
tree, so that the cost grows like the size of the inverse itself.

References: Humphreys, *Reflection Groups and Coxeter Groups*, Chapters 1, 2 and 4; Bourbaki, *Lie*,
VI, §1 and Planches I to IX.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise

import numpy as np

from .cartan import climb, determinant, eliminate, reflection_group_order
from .errors import InvalidInput
from .exact import RationalMatrix, as_vector, show
from .exact.matrices import INT64_SAFE
from .names import Type, parse_root_system
from .root_sets import coroots


def root_system(name: object) -> RootSystem:
    """The crystallographic root system of a given type, with the simple roots of Theorem 3.

    Parameters
    ----------
    name
        Such as ``"B5"``, ``"E6"`` or ``("B", 5)``.

    Raises
    ------
    InvalidType
        If there is no such root system.

    Examples
    --------
    >>> root_system("B3").simple_roots
    RationalMatrix([[1, -1, 0], [0, 1, -1], [0, 0, 1]])
    """
    return RootSystem(parse_root_system(name))


def _simple_roots(kind: Type) -> RationalMatrix:
    """Theorem 3: the simple roots as rows, in the ambient space that the paper uses."""
    d, doubled = kind.rank, kind.letter in "EF"
    s = np.zeros((d, {"A": d + 1, "E": 8, "G": 3}.get(kind.letter, d)), dtype=np.int64)
    if kind.letter in "ABCD":
        chain = d if kind.letter == "A" else d - 1
        index = np.arange(chain)
        s[index, index], s[index, index + 1] = 1, -1
        if kind.letter == "D":
            s[d - 1, d - 2 :] = 1
        elif kind.letter != "A":
            s[d - 1, d - 1] = 2 if kind.letter == "C" else 1
    elif kind.letter == "E":
        s[0] = [1, -1, -1, -1, -1, -1, -1, 1]
        s[1, :2] = 2
        for i in range(2, d):
            s[i, i - 2], s[i, i - 1] = -2, 2
    elif kind.letter == "F":
        s[:] = [[0, 2, -2, 0], [0, 0, 2, -2], [0, 0, 0, 2], [1, -1, -1, -1]]
    else:
        s[:] = [[1, -1, 0], [-2, 1, 1]]
    return RationalMatrix(s, 2 if doubled else 1)


@dataclass(frozen=True)
class RootSystem:
    """A crystallographic, reduced, irreducible root system; make one with `root_system`.

    Lengths are in the scale of the simple roots of Theorem 3.
    """

    type: Type

    @property
    def name(self) -> str:
        """The name, as ``B5``."""
        return self.type.finite

    @property
    def rank(self) -> int:
        """The number of simple roots, the dimension of the space that they span."""
        return self.type.rank

    def __repr__(self) -> str:
        return f"root_system({self.name!r})"

    @cached_property
    def simple_roots(self) -> RationalMatrix:
        """The simple roots s_1 … s_d as rows."""
        return _simple_roots(self.type)

    # -- Gram matrix of the simple roots, sparse because the diagram is a tree -------------------

    @cached_property
    def _products(self) -> dict[int, dict[int, Fraction]]:
        """``_products[i][j]`` is <s_i, s_j>, for the pairs where it is not zero."""
        s = self.simple_roots
        columns: dict[int, list[tuple[int, int]]] = {}
        for i, c in zip(*np.nonzero(s.numerators), strict=True):
            columns.setdefault(int(c), []).append((int(i), int(s.numerators[i, c])))
        total: dict[int, dict[int, int]] = {i: {} for i in range(self.rank)}
        for entries in columns.values():
            for i, x in entries:
                for j, y in entries:
                    total[i][j] = total[i].get(j, 0) + x * y
        square = s.denominator**2
        return {i: {j: Fraction(x, square) for j, x in row.items() if x} for i, row in total.items()}

    @cached_property
    def squared_lengths(self) -> tuple[Fraction, ...]:
        """<s_i, s_i> for each simple root."""
        return tuple(self._products[i][i] for i in range(self.rank))

    @cached_property
    def _neighbours(self) -> dict[int, dict[int, int]]:
        """The non-zero Cartan integers ``n(s_i, s_j)``, j != i, as ``_neighbours[i][j]``."""
        lengths = self.squared_lengths
        return {
            i: {j: int(2 * x / lengths[j]) for j, x in row.items() if j != i}
            for i, row in self._products.items()
        }

    @property
    def cartan_matrix(self) -> np.ndarray:
        """The Cartan integers n(s_i, s_j) = 2<s_i, s_j>/<s_j, s_j>, an integer array (d, d).

        Source: Definition 7; Bourbaki, *Lie*, VI, §1.5.

        >>> root_system("B2").cartan_matrix.tolist()
        [[2, -2], [-1, 2]]
        """
        matrix = 2 * np.eye(self.rank, dtype=np.int64)
        for i, row in self._neighbours.items():
            for j, n in row.items():
                matrix[i, j] = n
        return matrix

    @cached_property
    def gram_determinant(self) -> Fraction:
        """The determinant of the Gram matrix of the simple roots."""
        return self.connection_index * math.prod((x / 2 for x in self.squared_lengths), start=Fraction(1))

    @cached_property
    def connection_index(self) -> int:
        """The index of the root lattice in the weight lattice, the determinant of the Cartan matrix."""
        return determinant(self._neighbours)

    @cached_property
    def inverse_gram(self) -> RationalMatrix:
        """The inverse of the Gram matrix of the simple roots, of shape (d, d).

        Its entry (i, j) is the inner product of the fundamental coweights i and j. It is filled in
        from the root of the diagram's tree outwards: row v is a multiple of its parent's row.
        """
        order, parent, cartan_pivot = eliminate(self._neighbours)
        pivot = {i: x * self.squared_lengths[i] / 2 for i, x in cartan_pivot.items()}
        d = self.rank
        denominator = self.gram_determinant
        scale = math.lcm(*(x.denominator for row in self._products.values() for x in row.values()))
        common = int(denominator * scale**d)  # with it all entries are integers: they are cofactors
        out = np.zeros((d, d), dtype=np.int64)
        nodes = np.array(order)
        for count, i in enumerate(order):
            p, done = parent[i], nodes[:count]
            top = Fraction(common) / pivot[i]
            if count:
                factor = -self._products[i][p] / pivot[i]
                row = out[p]
                if int(np.abs(row).max()) * abs(factor.numerator) >= INT64_SAFE:
                    out = out.astype(object)
                    row = out[p]
                values = row[done] * factor.numerator // factor.denominator
                out[i, done] = values
                out[done, i] = values
                top += factor**2 * int(out[p, p])
            out[i, i] = int(top)
        return RationalMatrix(out, common)

    @cached_property
    def fundamental_coweights(self) -> RationalMatrix:
        """The basis dual to the simple roots, as rows; <w_i, s_j> is 1 if i = j, else 0.

        >>> root_system("C2").fundamental_coweights
        RationalMatrix([[1, 0], [1/2, 1/2]])
        """
        g, s = self.inverse_gram, self.simple_roots
        out = np.zeros(s.shape, dtype=g.numerators.dtype)
        for j, c in zip(*np.nonzero(s.numerators), strict=True):
            out[:, c] += int(s.numerators[j, c]) * g.numerators[:, j]
        return RationalMatrix(out, g.denominator * s.denominator)

    # -- the highest root ---------------------------------------------------------------------------

    @cached_property
    def marks(self) -> tuple[int, ...]:
        """The coefficients m_1 … m_d of the highest root in the simple roots.

        Climbs from a longest simple root by simple reflections that add a positive multiple of a
        simple root, until none does. The end is the dominant longest root, which is unique and is
        the highest root (Humphreys, Section 2.9).

        >>> root_system("E8").marks
        (2, 3, 4, 6, 5, 4, 3, 2)
        """
        start = max(range(self.rank), key=lambda i: self.squared_lengths[i])
        coefficients = climb(self._neighbours, start)
        return tuple(coefficients[i] for i in range(self.rank))

    @cached_property
    def highest_root(self) -> tuple[Fraction, ...]:
        """The highest root, the maximum of the partial order of Definition 6 (Proposition 4)."""
        s = self.simple_roots
        return tuple(
            Fraction(int(x), s.denominator) for x in np.array(self.marks, dtype=np.int64) @ s.numerators
        )

    @cached_property
    def squared_length_of_highest_root(self) -> Fraction:
        """<s~, s~>, that of a longest simple root."""
        return max(self.squared_lengths)

    @cached_property
    def _affine_products(self) -> dict[int, dict[int, Fraction]]:
        """The products <s_i, s_j> that are not zero, now for nodes 0 … d with s_0 = -(highest root)."""
        total: dict[int, dict[int, Fraction]] = {0: {0: self.squared_length_of_highest_root}}
        for i, row in self._products.items():
            total[i + 1] = {j + 1: x for j, x in row.items()}
            product = -sum((self.marks[j] * x for j, x in row.items()), Fraction(0))
            if product:
                total[0][i + 1] = total[i + 1][0] = product
        return total

    @cached_property
    def affine_neighbours(self) -> dict[int, dict[int, int]]:
        """The non-zero Cartan integers n(s_i, s_j), i != j, for nodes 0 … d; s_0 is -(highest root)."""
        products = self._affine_products
        return {
            i: {j: int(2 * x / products[j][j]) for j, x in row.items() if j != i}
            for i, row in products.items()
        }

    # -- all roots ------------------------------------------------------------------------------------

    @cached_property
    def positive_root_coordinates(self) -> np.ndarray:
        """The positive roots in the basis of simple roots, an integer array (N, d), by height.

        Generated upwards from the simple roots: each other positive root is the reflection, in a
        simple root, of a lower positive root (Humphreys, Section 1.6).
        """
        cartan = self.cartan_matrix
        level = np.eye(self.rank, dtype=np.int64)
        seen = {row.tobytes() for row in level}
        found = [level]
        while len(level):
            pairing = level @ cartan
            rows, js = np.nonzero(pairing < 0)
            higher = level[rows]
            higher[np.arange(len(rows)), js] -= pairing[rows, js]
            fresh = {row.tobytes(): row for row in higher if row.tobytes() not in seen}
            seen |= fresh.keys()
            level = np.array(list(fresh.values()), dtype=np.int64).reshape(-1, self.rank)
            found.append(level)
        roots = np.concatenate(found)
        roots = roots[np.lexsort((*-roots.T[::-1], roots.sum(axis=1)))]
        roots.setflags(write=False)
        return roots

    @cached_property
    def positive_roots(self) -> RationalMatrix:
        """The positive roots as rows, by height.

        >>> root_system("B2").positive_roots
        RationalMatrix([[1, -1], [0, 1], [1, 0], [1, 1]])
        """
        s = self.simple_roots
        return RationalMatrix(self.positive_root_coordinates @ s.numerators, s.denominator)

    @cached_property
    def roots(self) -> RationalMatrix:
        """All roots as rows, the positive ones, then their negatives (Definition 3)."""
        half = self.positive_roots
        return RationalMatrix(np.concatenate([half.numerators, -half.numerators]), half.denominator)

    @cached_property
    def coroots(self) -> RationalMatrix:
        """The coroots 2r/<r, r> of all roots, as rows, in the order of `roots` (Definition 10)."""
        return coroots(self.roots)

    @cached_property
    def heights(self) -> tuple[int, ...]:
        """The height of each positive root, the sum of its coordinates."""
        return tuple(int(h) for h in self.positive_root_coordinates.sum(axis=1))

    @property
    def weyl_group_order(self) -> int:
        """The order of the Weyl group; see `reflection_group_order`.

        >>> root_system("E8").weyl_group_order
        696729600
        """
        return reflection_group_order(self._neighbours)

    def exponents(self) -> tuple[int, ...]:
        """The exponents, read off the heights of the positive roots (Humphreys, Section 3.20).

        The number of exponents that are at least h is the number of positive roots of height h. The
        Weyl group has order (product of e + 1): a second route to `weyl_group_order`.

        >>> root_system("F4").exponents()
        (1, 5, 7, 11)
        """
        at_height = [self.heights.count(h) for h in range(1, max(self.heights) + 2)]
        return tuple(h for h, (here, above) in enumerate(pairwise(at_height), 1) for _ in range(here - above))

    def coordinates(self, vector: Sequence[object]) -> tuple[Fraction, ...]:
        """The coordinates of a vector in the basis of simple roots.

        Raises `InvalidInput` if the vector does not lie in their span.

        >>> [str(c) for c in root_system("B2").coordinates((1, 1))]
        ['1', '2']
        """
        x = as_vector(vector, self.simple_roots.shape[1])
        w = self.fundamental_coweights
        row = RationalMatrix.from_rows([x])
        result = (row @ w.T).row(0)
        if RationalMatrix.from_rows([result]) @ self.simple_roots != row:
            raise InvalidInput(f"{show(x)} does not lie in the span of the roots of {self.name}")
        return result

    def precedes(self, r: Sequence[object], s: Sequence[object]) -> bool:
        """Whether r comes before s, or equals it, in the partial order of Definition 6."""
        pairs = zip(self.coordinates(r), self.coordinates(s), strict=True)
        return all(a <= b for a, b in pairs)
