"""A Coxeter triangulation laid over R^d at some scale: which simplex holds a point, and what is around it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..affine import CoxeterTriangulation, triangulation
from ..errors import InvalidInput
from ..meshes import Mesh
from .cells import cells_of, extended_cartan_matrix
from .convex import Ball, Box
from .frames import Frame, frame_of
from .interpolation import Function, Interpolation, Vertices, interpolation_at
from .lazy import is_lazy, locate_lazily, vertices_lazily
from .locating import NUMBERS, Found, Locator, as_floats, over_common_denominator, read
from .patches import patch_in, patch_of
from .regions import Star, classes_of, search, star_of
from .rows import flood, in_order
from .subgroups import Ints, Subgroup, subgroup

Floats = NDArray[np.float64]
LARGEST_KEY = 2**50
"""From here on keys are Python's integers: what is made of them might not fit in 64 bits."""


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
        if is_lazy(self.keys):
            return vertices_lazily(self.grid, self.keys)  # type: ignore[no-any-return]
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

    def __reduce__(self) -> tuple[Any, ...]:
        """A grid is sent to another process as what it was made from; what is computed of it is not."""
        frame = self.frame
        return type(self), (self.triangulation.name, frame.scale, frame.rotation, frame.offset)

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
    def vertex_unit(self) -> int:
        """What vertices, in the coordinates of the roots, are multiplied by to be integers."""
        return 12 * lcm(*self.triangulation.marks, self.triangulation.simplex.vertex_matrix.denominator)

    @cached_property
    def _corners(self) -> Ints:
        """The vertices of the fundamental simplex, times their unit."""
        matrix = self.triangulation.simplex.vertex_matrix
        return matrix.numerators.astype(np.int64) * (self.vertex_unit // matrix.denominator)

    # -- points ----------------------------------------------------------------------------------------------

    def locate(self, points: ArrayLike) -> Location:
        """The simplex that holds each of many points.

        Rounding and sorting bring a point into the fundamental simplex: about d log d steps a point for the
        classical families.

        Parameters
        ----------
        points
            An array (n, d) of floats, or a Dask array of them, for which the answer consists of Dask arrays; or
            exact numbers (integers, fractions) in the coordinates of the roots,
            for which the answer is exact, if the grid has neither scale, rotation nor offset.

        Raises
        ------
        InvalidInput
            If the shape is wrong, a number is not finite, or so large that floats no longer tell the
            simplices apart.
        """
        if is_lazy(points):
            return Location(self, *locate_lazily(self, points))
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

    def locate_chunks(self, points: ArrayLike, chunk: int = 1 << 16) -> Iterator[Location]:
        """Locate more points than fit in memory: one answer after the other, in order.

        What is held at a time is what `locate` needs for a chunk: input, keys and barycentric coordinates, about
        24 (d + 1) bytes a point, and a fixed amount for intermediate results.

        Parameters
        ----------
        points
            As for `locate`; a file opened by ``np.load(..., mmap_mode="r")`` is read chunk by chunk.
        chunk
            How many points at a time.

        Raises
        ------
        InvalidInput
            As `locate`, once the chunk's turn comes, with rows counted within it; or if the chunk is not positive.

        Examples
        --------
        >>> grid = Grid("A~2")
        >>> [len(found) for found in grid.locate_chunks(np.zeros((5, 2)), chunk=2)]
        [2, 2, 1]
        """
        if chunk < 1:
            raise InvalidInput(f"chunks of {chunk} points were asked for: give a positive number")
        rows = points if isinstance(points, np.ndarray) else np.asarray(points)
        return (self.locate(rows[i : i + chunk]) for i in range(0, len(rows), chunk))

    def _locate_some(self, points: Floats, found: Found) -> None:
        """Locate as many points as the cache holds."""
        frame = self.frame
        if points.shape[1] != self.dimension:
            self._in_span(points)
            self._locator.rounded(self._subgroup.into(points), None, found)
        elif frame.kind == "helmert":
            return self._locator.rounded(frame.aligned(points), frame.lengths, found)
        else:
            self._locator.rounded(self._subgroup.into(frame.inward(points)), None, found)
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
        cells = None if self._subgroup.classical else cells_of(self._subgroup)
        return Locator(self._subgroup, cells, self._centre, self.key_unit)

    # -- simplices -------------------------------------------------------------------------------------------

    def vertices(self, keys: ArrayLike) -> Floats:
        """The vertices (n, d + 1, d) of simplices given by their keys, by labels."""
        return self.frame.outward((self.corners(keys) / self.vertex_unit).astype(np.float64))

    def corners(self, keys: ArrayLike) -> Ints:
        """The vertices in the coordinates of the roots, exactly: integers, times `vertex_unit`."""
        shares = np.eye(self.dimension + 1, dtype=np.int64) * self.vertex_unit
        return self._images(keys, self._corners, shares, self.vertex_unit)

    def neighbours(self, keys: ArrayLike) -> Ints:
        """The keys (n, d + 1, ·) of the simplices across the facets; number k shares all vertices but one."""
        walls = map(self._subgroup.wall, range(self.dimension + 1))
        images = np.array([wall.reflect(self._centre, self.key_unit) for wall in walls])
        shares = (1 - extended_cartan_matrix(self.triangulation)) * self._locator.shares_of_centre
        return self._images(keys, images, shares, self.key_unit)

    def star(self, key: Sequence[int], label: int) -> Ints:
        """The keys of all simplices that share the vertex with a label of one of them, in lexicographic order."""
        others = [k for k in range(self.dimension + 1) if k != label]

        def around(keys: Ints) -> Ints:
            return self.neighbours(keys)[:, others].reshape(-1, keys.shape[1])

        found = flood(self._read([key]), around)
        assert found is not None
        return in_order(found)

    def _images(self, keys: ArrayLike, points: Ints, shares: Ints, unit: int) -> Ints:
        """Points (j, m) of the fundamental simplex, with their barycentric coordinates, carried to others."""
        known = self._read(keys)
        images, rows = (
            np.empty((len(known), *points.shape), dtype=known.dtype),
            max(1, NUMBERS // points.size),
        )
        for start in range(0, len(known), rows):
            part = known[start : start + rows]
            folded = self._locator.fold(part, self.key_unit)
            if len(wrong := np.flatnonzero((self._locator.keys(folded) != part).any(axis=1))):
                raise InvalidInput(
                    f"{part[wrong[0]].tolist()} is no key of a simplex of {self.triangulation.name}"
                )
            images[start : start + rows] = folded.undo(points, shares, unit)
        return images

    def _read(self, keys: ArrayLike) -> NDArray[Any]:
        """Keys as machine integers, or if they are too large for what follows as Python's."""
        array = np.asarray(keys)
        if array.ndim != 2 or array.shape[1] != len(self._centre) or not _whole(array):
            raise InvalidInput(f"keys of {self.triangulation.name} are rows of {len(self._centre)} integers")
        largest = max(-int(array.min(initial=0)), int(array.max(initial=0)))
        return array.astype(np.int64 if largest < LARGEST_KEY else object)

    # -- regions ---------------------------------------------------------------------------------------------

    def alcoves_in_box(self, lower: ArrayLike, upper: ArrayLike) -> Ints:
        """The keys of all simplices that meet a box, those that touch it too.

        Parameters
        ----------
        lower, upper
            The least and the greatest coordinates, d each, in R^d; equal ones are allowed.

        Returns
        -------
        keys
            In lexicographic order. None that meets the box is missing; none is farther from it than rounding
            can tell, 2^-43 times the largest coordinate of box, scale and offset.

        Raises
        ------
        InvalidInput
            If a coordinate is missing or not finite, or the box holds more than fits in memory.

        Examples
        --------
        >>> grid = Grid("C~2")
        >>> len(grid.alcoves_in_box([0, 0], [1, 1])), len(grid.alcoves_in_box([0.1, 0.1], [0.9, 0.9]))
        (20, 8)
        """
        return search(self, Box.between(lower, upper, self.dimension)).keys()

    def alcoves_in_ball(self, centre: ArrayLike, radius: float) -> Ints:
        """The keys of all simplices that meet a ball, those that touch it too, as in `alcoves_in_box`."""
        return search(self, Ball.around(centre, radius, self.dimension)).keys()

    def vertices_in_box(self, lower: ArrayLike, upper: ArrayLike) -> Vertices:
        """The vertices in a box, those on its boundary too: keys, labels, positions.

        >>> Grid("C~2").vertices_in_box([0, 0], [0.5, 0.5]).labels.tolist()
        [0, 1, 1, 2]
        """
        return Vertices(self, *search(self, Box.between(lower, upper, self.dimension)).vertices())

    def vertices_in_ball(self, centre: ArrayLike, radius: float) -> Vertices:
        """The vertices in a ball, those on its boundary too, as in `vertices_in_box`."""
        return Vertices(self, *search(self, Ball.around(centre, radius, self.dimension)).vertices())

    def patch(self, keys: ArrayLike, oriented: bool = False) -> Mesh:
        """The mesh of some simplices.

        Parameters
        ----------
        keys
            Those of the simplices, in the order of the cells.
        oriented
            Column k of the cells holds the vertices with label k: so neighbours have opposite orientations.
            With True all get a positive determinant: in half of the rows the last two vertices change places.

        Returns
        -------
        mesh
            Its points are different, in the lexicographic order of their coordinates as those of the roots;
            ``point_data["label"]`` has their labels.

        Examples
        --------
        >>> grid = Grid("A~2")
        >>> grid.patch(grid.star(grid.locate([[0.3, 0.4]]).keys[0], 0))
        Mesh(7 points in R^2, 6 cells of dimension 2)
        """
        return patch_of(self, self._read(keys), oriented)

    def patch_in_box(self, lower: ArrayLike, upper: ArrayLike, oriented: bool = False) -> Mesh:
        """The mesh of all simplices that meet a box: the `patch` of `alcoves_in_box`, made faster."""
        return patch_in(search(self, Box.between(lower, upper, self.dimension)), oriented)

    def patch_in_ball(self, centre: ArrayLike, radius: float, oriented: bool = False) -> Mesh:
        """The mesh of all simplices that meet a ball: the `patch` of `alcoves_in_ball`, made faster."""
        return patch_in(search(self, Ball.around(centre, radius, self.dimension)), oriented)

    @cached_property
    def _star(self) -> Star:
        return star_of(self)

    @cached_property
    def _classes(self) -> list[Ints]:
        return classes_of(self)

    # -- functions -------------------------------------------------------------------------------------------

    def interpolation(self, points: ArrayLike) -> Interpolation:
        """What points need to interpolate, and to splat: the vertices around, and their shares.

        >>> grid = Grid("A~2")
        >>> found = grid.interpolation([[0.3, 0.4], [0.1, 0.1]])
        >>> found.of(lambda x: x[:, 0] + 2 * x[:, 1]).round(12).tolist()
        [1.1, 0.3]
        >>> float(found.splat([1, 1]).sum().round(12))
        2.0
        """
        return interpolation_at(self, points)

    def interpolate(self, points: ArrayLike, f: Function) -> Floats:
        """The values at points (n, d) of the function that is linear on each simplex, and f at the vertices.

        Parameters
        ----------
        points
            As for `locate`.
        f
            Takes positions (v, d), each vertex once, to values (v,) or (v, c).

        Examples
        --------
        >>> Grid("A~2").interpolate([[0.3, 0.4]], lambda x: 2 * x).round(12).tolist()
        [[0.6, 0.8]]
        """
        return self.interpolation(points).of(f)

    def splat(self, points: ArrayLike, values: ArrayLike) -> tuple[Vertices, Floats]:
        """Share out values at points (n,) or (n, c) to the vertices around: the adjoint of `interpolate`.

        Returns
        -------
        vertices
            Those of the simplices that hold a point.
        sums
            For each the sum of the values times the points' barycentric coordinates.

        Examples
        --------
        >>> vertices, sums = Grid("C~2").splat([[0.25, 0.0]], [8])
        >>> dict(zip(vertices.labels.tolist(), sums.tolist()))
        {0: 4.0, 1: 4.0, 2: 0.0}
        """
        found = self.interpolation(points)
        return found.vertices, found.splat(values)


def _whole(array: NDArray[Any]) -> bool:
    """Whether there is nothing but integers in an array."""
    return array.dtype.kind in "iu" or (
        array.dtype == object and all(isinstance(x, (int, np.integer)) for x in array.flat)
    )
