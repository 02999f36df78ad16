"""A Coxeter triangulation laid over R^d at some scale: which simplex holds a point, and what is around it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..affine import CoxeterTriangulation, triangulation
from ..errors import InvalidInput
from .cells import cells_of, extended_cartan_matrix
from .folding import Folded, fold
from .frames import Frame, frame_of
from .locating import NUMBERS, Found, Locator, as_floats, over_common_denominator, read
from .subgroups import Ints, Subgroup, subgroup

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Location:
    """Which simplices hold some points.

    Attributes
    ----------
    grid
        Where.
    keys
        For each point a row of integers, equal for two points exactly when the simplices are; ``tuple(row)``
        can be hashed. The row is the simplex's centre of weights m_0, ..., m_d in the coordinates of the
        roots, times `Grid.key_unit`.
    barycentric
        Barycentric coordinates, shape (n, d + 1): column k belongs to the vertex with label k. Floats that
        are not negative and sum to one, or exact fractions if the points were exact.
    open
        For each point, whether rounding leaves the answer open: the point is so close to a wall that it may
        lie in a neighbour.
    """

    grid: Grid
    keys: Ints
    barycentric: NDArray[Any]
    open: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.keys)

    @cached_property
    def vertices(self) -> Floats:
        """The vertices of the simplices, shape (n, d + 1, d), by their labels."""
        return self.grid.vertices(self.keys)


class Grid:
    """A Coxeter triangulation laid over R^d.

    Parameters
    ----------
    name
        The triangulation, as ``"B~5"``.
    scale
        The factor by which all is enlarged; positive.
    rotation
        An orthogonal matrix (d, d) that is applied before the offset; none by default.
    offset
        Where vertex u_0 of the fundamental simplex lies, d numbers; 0 by default.

    Raises
    ------
    InvalidInput
        If there is no such triangulation, the scale is not positive, or the matrix is not orthogonal.

    Examples
    --------
    >>> grid = Grid("C~2")
    >>> found = grid.locate([[0.3, 0.1], [0.1, 0.3]])
    >>> found.barycentric.round(3).tolist()
    [[0.4, 0.4, 0.2], [0.4, 0.4, 0.2]]
    >>> found.vertices[1].tolist()
    [[0.0, 0.0], [0.0, 0.5], [0.5, 0.5]]
    """

    def __init__(
        self,
        name: object,
        scale: float = 1,
        rotation: ArrayLike | None = None,
        offset: ArrayLike | None = None,
    ) -> None:
        self.triangulation: CoxeterTriangulation = triangulation(getattr(name, "name", name))
        self.frame: Frame = frame_of(self.triangulation, scale, rotation, offset)
        self.compiled = True

    def __repr__(self) -> str:
        return f"Grid({self.triangulation.name!r}{self.frame.words})"

    @property
    def dimension(self) -> int:
        """The dimension d."""
        return self.triangulation.dimension

    # -- numbers of the fundamental simplex ----------------------------------------------------------------

    @cached_property
    def _subgroup(self) -> Subgroup:
        return subgroup(self.triangulation)

    @cached_property
    def key_unit(self) -> int:
        """What keys are multiplied by to be integers: a multiple of 12, and of the Coxeter number."""
        return 12 * sum(self.triangulation.marks)

    @cached_property
    def _centre(self) -> Ints:
        """The centre of weights m_k of the fundamental simplex, times the unit: it has the levels 1 / h."""
        t = self.triangulation
        total = t.roots.fundamental_coweights
        centre: Ints = 12 * total.numerators.astype(np.int64).sum(axis=0) // total.denominator
        return centre

    @cached_property
    def _vertex_unit(self) -> int:
        """Turns the images of the vertices, coweights over marks, into integers."""
        return 12 * lcm(*self.triangulation.marks, self.triangulation.simplex.vertex_matrix.denominator)

    @cached_property
    def _corners(self) -> Ints:
        """The vertices of the fundamental simplex, times their unit."""
        matrix = self.triangulation.simplex.vertex_matrix
        return matrix.numerators.astype(np.int64) * (self._vertex_unit // matrix.denominator)

    # -- points ----------------------------------------------------------------------------------------------

    def locate(self, points: ArrayLike) -> Location:
        """The simplex that holds each of many points.

        Rounding and sorting bring a point into the fundamental simplex: about d log d steps a point for the
        classical families.

        Parameters
        ----------
        points
            An array (n, d) of floats; or exact numbers (integers, fractions) in the coordinates of the roots,
            for which the answer is exact, if the grid has neither scale, rotation nor offset.

        Raises
        ------
        InvalidInput
            If the shape is wrong, a number is not finite, or so large that floats no longer tell the
            simplices apart.
        """
        array = read(points, self.frame, (self.dimension, self._subgroup.ambient))
        if array.dtype == object:
            return self._exactly(array)
        n, rows = len(array), max(1, NUMBERS // array.shape[1])
        found = Found(
            np.empty((n, self._subgroup.ambient), np.int64),
            np.empty((n, self.dimension + 1)),
            np.empty(n, bool),
        )
        for i in range(0, n, rows):
            self._locate_some(as_floats(array[i : i + rows]), found[i : i + rows])
        return Location(self, found.keys, found.barycentric, found.open)

    def _locate_some(self, points: Floats, found: Found) -> None:
        """Locate as many points as the cache holds."""
        frame, compiled = self.frame, self.compiled
        if points.shape[1] != self.dimension:
            self._in_span(points)
            self._locator.rounded(self._subgroup.into(points), None, compiled, found)
        elif frame.kind == "helmert":
            return self._locator.rounded(frame.aligned(points), frame.lengths, compiled, found)
        else:
            self._locator.rounded(self._subgroup.into(frame.inward(points)), None, compiled, found)
        if frame.standard or points.shape[1] != self.dimension:
            self._close(found, points)

    def _exactly(self, array: NDArray[Any]) -> Location:
        d, m = self.dimension, self._subgroup.ambient
        if array.shape[1] == d and not self.frame.standard:
            raise InvalidInput(
                f"exact points need the coordinates of the roots, {m} of them, in a grid without scale, "
                f"rotation and offset; {array.shape[1]} were given: give floats instead"
            )
        numerators, denominator = over_common_denominator(array)
        self._in_span(numerators)
        found = self._locator.exact(numerators, denominator)
        return Location(self, found.keys, found.barycentric, found.open)

    def _in_span(self, z: NDArray[Any]) -> None:
        """Refuse points outside the span of the roots."""
        simple, weights = (
            self.triangulation.roots.simple_roots,
            self.triangulation.roots.fundamental_coweights,
        )
        if z.shape[1] == self.dimension:
            return
        left, right = simple.numerators.astype(z.dtype), weights.numerators.astype(z.dtype)
        scale = simple.denominator * weights.denominator
        beyond = np.abs((z @ left.T) @ right - z * scale).max(axis=1, initial=0)
        allowed = 1e-9 * scale * (1 + np.abs(z).max(axis=1, initial=0)) if z.dtype.kind == "f" else 0
        if len(rows := np.flatnonzero(beyond > allowed)):
            raise InvalidInput(
                f"row {rows[0]} is {z[rows[0]].tolist()}: it does not lie in the span of the roots of "
                f"{self.triangulation.name}"
            )

    def _close(self, found: Found, z: Floats) -> None:
        """Decide what is open exactly: a float is a fraction."""
        rows = np.flatnonzero(found.open)
        if len(rows):
            as_fraction = np.frompyfunc(lambda x: Fraction(float(x)), 1, 1)
            numerators, denominator = over_common_denominator(as_fraction(z[rows]))
            better = self._locator.exact(numerators, denominator)
            found.keys[rows] = better.keys
            found.barycentric[rows] = better.barycentric.astype(np.float64)
            found.open[rows] = False

    @cached_property
    def _locator(self) -> Locator:
        subgroup = self._subgroup
        return Locator(
            subgroup, None if subgroup.classical else cells_of(subgroup), self._centre, self.key_unit
        )

    def vertices(self, keys: Ints) -> Floats:
        """The vertices (n, d + 1, d) of simplices given by their keys, by labels."""
        return self.frame.outward(self.corners(keys) / self._vertex_unit)

    def corners(self, keys: Ints) -> Ints:
        """The vertices in the coordinates of the roots, exactly: integers, times `_vertex_unit`."""
        shares = np.eye(self.dimension + 1, dtype=np.int64) * self._vertex_unit
        return self._folded(keys).undo(self._corners, shares, self._vertex_unit)

    def neighbours(self, keys: Ints) -> Ints:
        """The keys (n, d + 1, ·) of the simplices across the facets; number k shares all vertices but one."""
        images = [
            self._subgroup.wall(k).reflect(self._centre, self.key_unit) for k in range(self.dimension + 1)
        ]
        return self._folded(keys).undo(np.array(images), self._shares_of_neighbours, self.key_unit)

    @cached_property
    def _shares_of_neighbours(self) -> Ints:
        """The barycentric coordinates of the centres of the neighbours of the fundamental simplex."""
        cartan = extended_cartan_matrix(self.triangulation)
        marks = np.array(self.triangulation.marks)
        return (1 - cartan) * marks * (self.key_unit // marks.sum())

    def _folded(self, keys: Ints) -> Folded:
        """How keys fold onto that of the fundamental simplex, or a refusal."""
        keys = np.asarray(keys)
        if keys.ndim != 2 or keys.shape[1] != len(self._centre) or keys.dtype.kind != "i":
            raise InvalidInput(f"keys of {self.triangulation.name} are rows of {len(self._centre)} integers")
        locator = self._locator
        folded = fold(self._subgroup, locator.cells, self._subgroup.into(keys).T, self.key_unit)
        if len(wrong := np.flatnonzero((locator.keys(folded) != keys).any(axis=1))):
            raise InvalidInput(
                f"{keys[wrong[0]].tolist()} is no key of a simplex of {self.triangulation.name}"
            )
        return folded

    def star(self, key: Sequence[int], label: int) -> Ints:
        """The keys of all simplices that share the vertex with a label of one of them."""
        found = {tuple(int(x) for x in key)}
        edge = np.array(sorted(found), dtype=np.int64)
        others = [k for k in range(self.dimension + 1) if k != label]
        while len(edge):
            around = self.neighbours(edge)[:, others].reshape(-1, edge.shape[1])
            fresh = {tuple(row) for row in around.tolist()} - found
            found |= fresh
            edge = np.array(sorted(fresh), dtype=np.int64)
        return np.array(sorted(found), dtype=np.int64)
