"""Where a grid lies: from the coordinates of R^d to those of the roots, and back."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..affine import CoxeterTriangulation
from ..errors import InvalidInput

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Frame:
    """x = offset + scale · rotation · E(z), with an isometry E from the span of the roots onto R^d.

    E is the identity where roots have d coordinates. For A~d, whose roots have d + 1 coordinates with sum 0,
    it is Helmert's matrix, which costs about d steps; for E6, E7 and G2 an orthonormal basis, by the QR
    decomposition of the simple roots.
    """

    triangulation: CoxeterTriangulation
    scale: float
    rotation: Floats | None
    offset: Floats | None

    @property
    def words(self) -> str:
        """What differs from the standard, as arguments."""
        parts = [f"scale={self.scale:g}"] if self.scale != 1 else []
        parts += [name + "=..." for name in ("rotation", "offset") if getattr(self, name) is not None]
        return "".join(f", {part}" for part in parts)

    @property
    def standard(self) -> bool:
        """Whether the coordinates of R^d are those of the roots."""
        return self.plain and self.kind == "identity"

    @property
    def plain(self) -> bool:
        """Whether there is neither scale, rotation nor offset."""
        return self.scale == 1 and self.rotation is None and self.offset is None

    @cached_property
    def kind(self) -> str:
        """``identity``, ``helmert`` or ``basis``."""
        t = self.triangulation
        if t.type.letter == "A":
            return "helmert"
        return "identity" if t.type.letter in "BCDF" or t.name == "E~8" else "basis"

    @cached_property
    def lengths(self) -> Floats:
        """The lengths sqrt(k (k + 1)) of the rows of Helmert's matrix."""
        k = np.arange(1.0, self.triangulation.dimension + 1)
        return np.sqrt(k * (k + 1))

    @cached_property
    def _basis(self) -> Floats:
        """An orthonormal basis of the span of the roots, as rows."""
        matrix = self.triangulation.roots.simple_roots
        q, r = np.linalg.qr((matrix.numerators / matrix.denominator).T)
        rows: Floats = (q * np.sign(np.diag(r))).T
        return rows

    def aligned(self, points: Floats) -> Floats:
        """Points (n, d) without offset, rotation and scale."""
        if self.offset is not None:
            points = points - self.offset
        if self.rotation is not None:
            points = points @ self.rotation
        if self.scale != 1:
            points = points / self.scale
        return points

    def inward(self, points: Floats) -> Floats:
        """Points (n, d) in the coordinates of the roots."""
        points = self.aligned(points)
        if self.kind == "identity":
            return points
        return from_helmert(points.T, self.lengths).T if self.kind == "helmert" else points @ self._basis

    def outward(self, points: Floats) -> Floats:
        """Points (..., m) in the coordinates of the roots back to R^d."""
        points = self.turned(points)
        return points if self.offset is None else points + self.offset

    def turned(self, points: Floats) -> Floats:
        """The same for vectors: without the offset."""
        if self.kind == "helmert":
            points = to_helmert(points, self.lengths)
        elif self.kind == "basis":
            points = points @ self._basis.T
        points = points * self.scale
        if self.rotation is not None:
            points = points @ self.rotation.T
        return points


def from_helmert(columns: Floats, lengths: Floats) -> Floats:
    """Points of R^d, as columns, in the d + 1 coordinates of the roots of A~d."""
    shares = columns / lengths[:, None]
    z = np.zeros((len(columns) + 1, columns.shape[1]))
    for k in range(len(shares) - 1, -1, -1):
        np.add(z[k + 1], shares[k], out=z[k])
    z[1:] -= shares * np.arange(1.0, len(z))[:, None]
    return z


def to_helmert(z: Floats, lengths: Floats) -> Floats:
    """And back."""
    d = z.shape[-1] - 1
    return np.asarray((np.cumsum(z[..., :-1], axis=-1) - np.arange(1.0, d + 1) * z[..., 1:]) / lengths)


def frame_of(
    triangulation: CoxeterTriangulation, scale: float, rotation: ArrayLike | None, offset: ArrayLike | None
) -> Frame:
    """A frame, once its parts are found to be sound.

    Raises
    ------
    InvalidInput
        If the scale is not a positive number, the matrix not orthogonal, or a shape wrong.
    """
    d = triangulation.dimension
    factor = float(_numbers(scale, (), f"{scale!r} is no scale: give a positive number"))
    if factor <= 0:
        raise InvalidInput(f"{scale!r} is no scale: give a positive number")
    matrix = vector = None
    if rotation is not None:
        told = f"the rotation is no orthogonal matrix of shape ({d}, {d})"
        matrix = _numbers(rotation, (d, d), told)
        if not np.allclose(matrix @ matrix.T, np.eye(d), rtol=0, atol=1e-9):
            raise InvalidInput(told)
        matrix = _orthogonal(matrix)
    if offset is not None:
        vector = _numbers(offset, (d,), f"the offset must be {d} finite numbers")
    return Frame(triangulation, factor, matrix, vector)


def _orthogonal(matrix: Floats) -> Floats:
    """The nearest orthogonal matrix, to the last bits.

    What was typed with ten digits would lead one way and back another. One step of Newton's, from so near,
    squares the error; what is exact stays as it is.
    """
    correction: Floats = matrix @ (matrix.T @ matrix - np.eye(len(matrix))) / 2
    return matrix - correction


def _numbers(given: ArrayLike, shape: tuple[int, ...], told: str) -> Floats:
    """Finite real numbers without a mask, in an array of a shape; or a refusal in given words."""
    try:
        array = np.array(given)
        real = array.dtype.kind in "fiuO" and not np.ma.is_masked(given)
        numbers = array.astype(np.float64) if real else np.empty(0)
    except (TypeError, ValueError, OverflowError):
        raise InvalidInput(told) from None
    if array.shape != shape or numbers.shape != shape or not np.isfinite(numbers).all():
        raise InvalidInput(told)
    return numbers
