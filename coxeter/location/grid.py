"""A Coxeter triangulation laid over R^d at some scale: which simplex holds a point, and what is around it."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidInput
from ..meshes import Mesh
from ..meshes.judging import is_lazy
from .alcoves import Alcoves
from .convex import Ball, Box
from .interpolation import Function, Interpolation, Vertices, interpolation_at
from .lazy import locate_lazily
from .locating import (
    NUMBERS,
    Found,
    as_floats,
    floats_over_common_denominator,
    is_short,
    over_common_denominator,
    read,
)
from .location import Location
from .patches import patch_in, patch_of
from .regions import search
from .stars import Star, star_of
from .subgroups import Ints
from .vertices import vertices_in

Floats = NDArray[np.float64]


class Grid(Alcoves):
    """A Coxeter triangulation laid over R^d.

    Parameters
    ----------
    name
        The triangulation, as ``"B~5"``.
    scale
        The factor by which all is enlarged; positive.
    rotation
        An orthogonal matrix (d, d), also with a reflection, that is applied before the offset; none by
        default.
    offset
        Where vertex u_0 of the fundamental simplex lies, d numbers; 0 by default. It is kept, as the others
        are, in floats of 64 bits.

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

    # -- points ----------------------------------------------------------------------------------------------

    def locate(self, points: ArrayLike) -> Location:
        """The simplex that holds each of many points.

        Rounding and sorting bring a point into the fundamental simplex: about d log d steps a point for the
        classical families.

        Parameters
        ----------
        points
            An array (n, d) of floats, or a Dask array of them, for which the answer consists of Dask arrays;
            or exact numbers (integers, fractions) in the coordinates of the roots, for which the answer is
            exact, if the grid has neither scale, rotation nor offset.

        Raises
        ------
        InvalidInput
            If the shape is wrong, or a number is not finite, has more digits than a float of 64 bits, or is
            so large that floats no longer tell the simplices apart.
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
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows on the way is refused by its size
            for i in range(0, n, rows):
                self._locate_some(as_floats(array[i : i + rows], i), found[i : i + rows])
        return Location(self, found.keys, found.barycentric, found.open)

    def locate_chunks(self, points: ArrayLike, chunk: int = 1 << 16) -> Iterator[Location]:
        """Locate more points than fit in memory: one answer after the other, in order.

        What is held at a time is what `locate` needs for a chunk: input, keys and barycentric coordinates,
        about 24 (d + 1) bytes a point, and a fixed amount for intermediate results.

        Parameters
        ----------
        points
            As for `locate`; a file opened by ``np.load(..., mmap_mode="r")`` is read chunk by chunk.
        chunk
            How many points at a time.

        Raises
        ------
        InvalidInput
            As `locate`, once the chunk's turn comes, with rows counted within it; or if the chunk is not
            positive.

        Examples
        --------
        >>> grid = Grid("A~2")
        >>> [len(found) for found in grid.locate_chunks(np.zeros((5, 2)), chunk=2)]
        [2, 2, 1]
        """
        if not isinstance(chunk, (int, np.integer)) or chunk < 1:
            raise InvalidInput(f"chunks of {chunk} points were asked for: give a positive integer")
        rows = np.atleast_1d(points)
        return (self.locate(rows[i : i + chunk]) for i in range(0, len(rows), chunk))

    def _locate_some(self, points: Floats, found: Found) -> None:
        """Locate as many points as the cache holds."""
        frame = self.frame
        if points.shape[1] != self.dimension:
            self._in_span(points)
            self._locator.rounded(self._subgroup.into(points), None, found)
        elif frame.kind == "helmert":
            return self._locator.rounded(frame.aligned(points), frame.lengths, found)
        elif frame.kind == "basis":
            self._locator.rounded(frame.aligned(points) @ self._from_basis, None, found)
        else:
            self._locator.rounded(self._subgroup.into(frame.inward(points)), None, found)
        if frame.standard or points.shape[1] != self.dimension:
            self._close(found, points)

    @cached_property
    def _from_basis(self) -> Floats:
        return np.asarray(self._subgroup.into(self.frame._basis))

    def _exactly(self, array: NDArray[Any]) -> Location:
        d, m = self.dimension, self._subgroup.ambient
        if array.shape[1] == d and not self.frame.standard:
            raise InvalidInput(
                f"exact points need the coordinates of the roots, {m} of them, in a grid without scale, "
                f"rotation and offset; {array.shape[1]} were given: give floats instead"
            )
        numerators, denominator = over_common_denominator(array)
        self._in_span(numerators)
        keys, shares, unit = self._locator.exact(numerators, denominator)
        fractions = np.frompyfunc(lambda x: Fraction(int(x), unit), 1, 1)(shares)
        return Location(self, keys, np.asarray(fractions, dtype=object), np.zeros(len(keys), dtype=bool))

    def _in_span(self, z: NDArray[Any]) -> None:
        """Refuse points outside the span of the roots."""
        roots = self.triangulation.roots
        simple, weights = roots.simple_roots, roots.fundamental_coweights
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
        if self._subgroup.parts[0].kind != "A" and self._subgroup.classical:
            found.open[:] = False  # nothing was rounded: see `sorting`
        elif self._subgroup.dyadic:
            found.open[found.open] = ~is_short(z[found.open])
        rows = np.flatnonzero(found.open)
        if len(rows):
            keys, shares, unit = self._locator.exact(*floats_over_common_denominator(z[rows]))
            found.keys[rows], found.barycentric[rows], found.open[rows] = keys, shares / unit, False

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
        (32, 8)
        """
        return search(self, Box.between(lower, upper, self.dimension)).keys()

    def alcoves_in_ball(self, centre: ArrayLike, radius: float) -> Ints:
        """The keys of all simplices that meet a ball, those that touch it too, as in `alcoves_in_box`."""
        return search(self, Ball.around(centre, radius, self.dimension)).keys()

    def vertices_in_box(self, lower: ArrayLike, upper: ArrayLike) -> Vertices:
        """The vertices in a box, those on its boundary too: keys, labels, positions.

        They are found as points of lattices, coordinate by coordinate, without the simplices around. Rounding
        does as in `alcoves_in_box`, and what is refused is the same.

        Examples
        --------
        >>> Grid("C~2").vertices_in_box([0, 0], [0.5, 0.5]).labels.tolist()
        [0, 1, 1, 2]
        """
        return Vertices(self, *vertices_in(search(self, Box.between(lower, upper, self.dimension))))

    def vertices_in_ball(self, centre: ArrayLike, radius: float) -> Vertices:
        """The vertices in a ball, those on its boundary too, as in `vertices_in_box`."""
        return Vertices(self, *vertices_in(search(self, Ball.around(centre, radius, self.dimension))))

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
