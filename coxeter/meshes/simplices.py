"""Many simplices at once, as floats: what `Simplex` knows of one exactly, and how far rounding goes.

The edges u_k - u_0 of a simplex are the columns of Q·R. The rows of the inverse of R, and minus their sum,
are the gradients of the barycentric coordinates in the basis Q; everything metric comes from R and from them.
No Gram matrix is formed, which would square the condition number and lose flat simplices.
"""

from __future__ import annotations

import math
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidInput, Unavailable

Floats = NDArray[np.float64]
UNIT = 2.0**-53
"""The rounding unit of floats."""
POOR = 2.0**-10
"""A simplex of which less is known than to this relative error counts as degenerate."""


class Values(np.ndarray[Any, np.dtype[np.float64]]):
    """Floats that have roots as exact numbers have, so that one measure serves both."""

    def root(self, n: int) -> Values:
        """The n-th root.

        >>> np.array([4.0, 9.0]).view(Values).root(2).tolist()
        [2.0, 3.0]
        """
        return (self ** (1 / n)).view(Values)


class Simplices:
    """n simplices of dimension d in R^m, whose numbers are arrays of n: with the names that a `Simplex` has.

    Every number is that of the given floats to a relative `error`: lengths, heights, radii and volumes
    (angles to that many radians). A simplex so flat that the error may exceed 2^-10 is *degenerate*: as an
    exact `Simplex` would be refused, its numbers are NaN, all of them.

    Parameters
    ----------
    corners
        Floats (n, d + 1, m), the vertices of each.

    Raises
    ------
    InvalidInput
        If the shape is wrong, a number is not finite, or so large or small that powers leave the range of
        floats.

    Examples
    --------
    >>> two = Simplices([[(0, 0), (3, 0), (0, 4)], [(0, 0), (1, 1), (2, 2)]])
    >>> two.volume.tolist(), two.inradius.round(12).tolist(), two.degenerate.tolist()
    ([6.0, nan], [1.0, nan], [False, True])
    """

    def __init__(self, corners: ArrayLike) -> None:
        self.corners: Floats = np.asarray(corners, dtype=np.float64)
        shape = self.corners.shape
        if len(shape) != 3 or not 2 <= shape[1] <= shape[2] + 1:
            raise InvalidInput(f"corners of shape {shape}: expected (n, d + 1, m), where d is from 1 to m")
        if not np.isfinite(self.corners).all():
            raise InvalidInput("some corners are not finite: NaN and infinity are no coordinates")
        with np.errstate(over="ignore"):
            sizes = np.abs(self._edges).max(axis=(1, 2), initial=0)
        reach = 2.0 ** (900 / max(self.dimension, 2))
        if len(far := sizes[(sizes != 0) & ~((1 / reach <= sizes) & (sizes <= reach))]):
            raise InvalidInput(
                f"a simplex has edges of about {far[0]:g}, whose powers leave the range of floats: scale all"
            )

    def __len__(self) -> int:
        return len(self.corners)

    def __repr__(self) -> str:
        return f"<{len(self)} simplices of dimension {self.dimension}>"

    @property
    def dimension(self) -> int:
        """The dimension d."""
        return int(self.corners.shape[1]) - 1

    # -- the two matrices --------------------------------------------------------------------------------

    @property
    def _edges(self) -> Floats:
        """The matrices with columns u_k - u_0, (n, m, d)."""
        return (self.corners[:, 1:] - self.corners[:, :1]).swapaxes(1, 2)

    @cached_property
    def _factors(self) -> tuple[Floats, Floats, Floats]:
        """R and its inverse, of simplices brought to a size of about 1; and by which powers of two."""
        edges = self._edges
        exponents = np.frexp(np.abs(edges).max(axis=(1, 2), initial=0))[1]
        r: Floats = np.asarray(np.linalg.qr(np.ldexp(edges, -exponents[:, None, None]), mode="r"))
        flat = np.abs(np.diagonal(r, axis1=1, axis2=2)).min(axis=1) < UNIT
        r[flat] = 0
        inverse = np.linalg.inv(np.where(flat[:, None, None], np.eye(self.dimension), r))
        return r, inverse, np.ldexp(1.0, exponents)

    @cached_property
    def error(self) -> Floats:
        """A bound for the relative error: ``16·d·m·κ·2^-53``, ``κ = |R|·|R^-1|`` in the norm of Frobenius.

        The edges are rounded once, Householder's QR is that of edges moved by about d·m units of rounding,
        and each number changes by at most some κ times as much. Infinite where R is singular.
        """
        r, inverse, _ = self._factors
        size = np.linalg.norm(r, axis=(1, 2))
        kappa = np.where(size > 0, size * np.linalg.norm(inverse, axis=(1, 2)), np.inf)
        bound: Floats = 16 * self.dimension * self.corners.shape[2] * kappa * UNIT
        return bound

    @cached_property
    def degenerate(self) -> NDArray[np.bool_]:
        """Which are so flat that rounding leaves no more than three digits of their heights."""
        flat: NDArray[np.bool_] = self.error > POOR
        return flat

    @cached_property
    def negative(self) -> NDArray[np.bool_]:
        """Which are oriented negatively, ``det(u_1 - u_0, ..., u_d - u_0) < 0``.

        That is none where m > d, as then there is no sign; of degenerate ones rounding decides.

        >>> Simplices([[(0, 0), (1, 0), (0, 1)], [(0, 0), (0, 1), (1, 0)]]).negative.tolist()
        [False, True]
        """
        square = self.corners.shape[2] == self.dimension
        return np.asarray(np.linalg.slogdet(self._edges)[0] < 0 if square else np.zeros(len(self), bool))

    def _known(self, values: Any) -> Values:
        """An array, whose last axis is that of the simplices, with NaN for degenerate ones."""
        masked = np.array(values, dtype=np.float64)
        masked[..., self.degenerate] = np.nan
        return masked.view(Values)

    @cached_property
    def _gradients(self) -> Floats:
        """Those of the barycentric coordinates times the power of two, in the basis Q: (n, d + 1, d)."""
        inverse = self._factors[1]
        return np.concatenate([-inverse.sum(axis=1, keepdims=True), inverse], axis=1)

    # -- edges -------------------------------------------------------------------------------------------

    @cached_property
    def _squared_edges(self) -> Floats:
        """Of all pairs i < j, shape (n, d (d + 1) / 2)."""
        pairs = combinations(range(self.dimension + 1), 2)
        return np.stack([_squares(self.corners[:, i] - self.corners[:, j]) for i, j in pairs], axis=1)

    @property
    def squared_edge_lengths(self) -> Values:
        """The squared distance of vertices i and j at [i, j], shape (d + 1, d + 1, n)."""
        points = self.corners.swapaxes(0, 1)
        return self._known(_squares(points[:, None] - points))

    @property
    def squared_longest_edge(self) -> Values:
        """L², shape (n,)."""
        return self._known(self._squared_edges.max(axis=1))

    @property
    def squared_shortest_edge(self) -> Values:
        """The square of the shortest edge length, shape (n,)."""
        return self._known(self._squared_edges.min(axis=1))

    @property
    def longest_edge(self) -> Values:
        """L, shape (n,)."""
        return self.squared_longest_edge.root(2)

    @property
    def shortest_edge(self) -> Values:
        """The shortest edge length, shape (n,)."""
        return self.squared_shortest_edge.root(2)

    @property
    def sum_of_squared_edges(self) -> Values:
        """The sum of the squared lengths of all edges, shape (n,)."""
        return self._known(self._squared_edges.sum(axis=1))

    # -- volume, heights, radii --------------------------------------------------------------------------

    @cached_property
    def volume(self) -> Values:
        """The d-dimensional volume, ``|det R| / d!``, shape (n,)."""
        r, _, size = self._factors
        shares = np.abs(np.diagonal(r, axis1=1, axis2=2)) * size[:, None] / np.arange(1, self.dimension + 1)
        return self._known(shares.prod(axis=1))

    @cached_property
    def heights(self) -> Values:
        """The height from each vertex, shape (d + 1, n): one over the length of the gradient."""
        return self._known(self._factors[2] / np.sqrt(_squares(self._gradients)).T)

    @property
    def squared_heights(self) -> Values:
        """The squares of the heights, shape (d + 1, n)."""
        return self._known(self.heights**2)

    @property
    def minimal_height(self) -> Values:
        """h, the least height, shape (n,)."""
        return self._known(self.heights.min(axis=0))

    @property
    def sum_of_inverse_squared_heights(self) -> Values:
        """Σ 1 / h_k², shape (n,)."""
        return self._known((self.heights**-2.0).sum(axis=0))

    @property
    def inradius(self) -> Values:
        """r, one over the sum of the inverse heights, shape (n,)."""
        return self._known(1 / (1 / self.heights).sum(axis=0))

    @cached_property
    def circumradius(self) -> Values:
        """R, shape (n,): the centre is half of R^-T applied to the squared lengths of the columns of R."""
        r, inverse, size = self._factors
        centre = np.einsum("nkj,nk->nj", inverse, (r * r).sum(axis=1)) / 2
        return self._known(np.sqrt(_squares(centre)) * size)

    @property
    def squared_circumradius(self) -> Values:
        """R², shape (n,)."""
        return self._known(self.circumradius**2)

    # -- angles ------------------------------------------------------------------------------------------

    @cached_property
    def _normals(self) -> Floats:
        """The inward unit normals of the facets, (n, d + 1, d)."""
        return self._gradients / np.sqrt(_squares(self._gradients))[:, :, None]

    def dihedral_cosine(self, i: int, j: int) -> Values:
        """The cosine of the angle between the facets opposite to vertices i and j, shape (n,)."""
        return self._known(-(self._normals[:, i] * self._normals[:, j]).sum(axis=1))

    def dihedral_angle_in_degrees(self, i: int, j: int) -> Values:
        """That angle; from the sum and the difference of two normals, so it is sound near 0 and 180 too."""
        a, b = self._normals[:, i], self._normals[:, j]
        return self._known(np.degrees(2 * np.arctan2(np.sqrt(_squares(a + b)), np.sqrt(_squares(a - b)))))

    @cached_property
    def _dihedral_angles(self) -> Floats:
        """Of all pairs i < j, shape (d (d + 1) / 2, n)."""
        pairs = combinations(range(self.dimension + 1), 2)
        return np.stack([self.dihedral_angle_in_degrees(i, j) for i, j in pairs])

    @property
    def minimal_dihedral_angle(self) -> Values:
        """The smallest dihedral angle in degrees, shape (n,); of segments, which have none, 0."""
        return self._known(self._dihedral_angles.min(axis=0))

    @property
    def maximal_dihedral_angle(self) -> Values:
        """The largest dihedral angle in degrees, shape (n,); of segments, which have none, 0."""
        return self._known(self._dihedral_angles.max(axis=0))

    def solid_angle(self, k: int) -> Values:
        """The solid angle at vertex k, as a share of the whole sphere, shape (n,); for d = 2 and 3.

        For d = 3 by ``tan(Ω/2) = |det(a, b, c)| / (|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|)`` with the
        edges a, b, c at the vertex (van Oosterom, Strackee 1983).
        """
        if self.dimension == 2:
            return self._known(self.dihedral_angle_in_degrees(*{0, 1, 2} - {k}) / 360)
        if self.dimension != 3:
            raise Unavailable(
                f"solid angles of {self.dimension}-simplices have no closed form in floats here: those of "
                "triangles and tetrahedra have"
            )
        r, _, size = self._factors
        corners = np.concatenate([np.zeros_like(r[:, :, :1]), r], axis=2).swapaxes(1, 2)
        edges = np.delete(corners, k, 1) - corners[:, k : k + 1]
        return self._known(_solid_angle(edges, 6 * self.volume / size**3) / (4 * math.pi))

    @cached_property
    def minimal_solid_angle(self) -> Values:
        """The smallest solid angle at a vertex, shape (n,); for d = 2 and 3."""
        return self._known(np.min([self.solid_angle(k) for k in range(self.dimension + 1)], axis=0))


def _solid_angle(edges: Floats, determinant: Floats) -> Floats:
    """The angle that three edges (n, 3, 3) span, in steradians."""
    a, b, c = np.sqrt(_squares(edges)).T
    (_, ab, ca), (_, _, bc), _ = (edges @ edges.swapaxes(1, 2)).transpose(1, 2, 0)
    return np.asarray(2 * np.arctan2(determinant, a * b * c + ab * c + bc * a + ca * b))


def _squares(vectors: Floats) -> Floats:
    """|x|² along the last axis."""
    return np.asarray(np.einsum("...i,...i->...", vectors, vectors))
