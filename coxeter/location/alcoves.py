"""The simplices of a triangulation laid over R^d, by their keys: vertices, neighbours, stars."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from math import lcm
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..affine import CoxeterTriangulation, triangulation
from ..errors import InvalidInput
from .cells import cells_of
from .frames import Frame, frame_of
from .locating import NUMBERS, Locator
from .stars import star_round
from .subgroups import Ints, Subgroup, subgroup

Floats = NDArray[np.float64]
LARGEST_ANSWER = 2**28
"""More simplices or vertices than this, over d + 1, are not looked for: they would not fit in memory."""
LARGEST_SCALE = 1e100
"""Squares and products of lengths stay floats."""
LARGEST_KEY = 2**50
"""From here on keys are Python's integers: what is made of them might not fit in 64 bits."""


class Alcoves:
    """The simplices of a `Grid`; it takes the same parameters."""

    def __init__(
        self,
        name: object,
        scale: float = 1,
        rotation: ArrayLike | None = None,
        offset: ArrayLike | None = None,
    ) -> None:
        self.triangulation: CoxeterTriangulation = triangulation(getattr(name, "name", name))
        self.frame: Frame = frame_of(self.triangulation, scale, rotation, offset)
        if not 1 / LARGEST_SCALE <= self.frame.scale <= LARGEST_SCALE:
            least, most = 1 / LARGEST_SCALE, LARGEST_SCALE
            raise InvalidInput(f"the scale {self.frame.scale:g} is none: give one from {least:g} to {most:g}")

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

    @cached_property
    def _cartan(self) -> Ints:
        """2 <n_k, n_j> / <n_k, n_k> for the normals n_k of the walls: gradients are normals times marks."""
        gram, marks = self.triangulation._gradient_gram.numerators, np.array(self.triangulation.marks)
        squares = gram.diagonal()[:, None] * marks
        return np.asarray(2 * gram * marks[:, None] // squares, dtype=np.int64)

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
        shares = (1 - self._cartan) * self._locator.shares_of_centre
        return self._images(keys, images, shares, self.key_unit)

    def star(self, key: Sequence[int], label: int) -> Ints:
        """The keys of all simplices that share a vertex of one of them, given by its label; in order."""
        if not isinstance(label, (int, np.integer)) or label not in range(self.dimension + 1):
            raise InvalidInput(f"{label!r} is no label: give an integer from 0 to {self.dimension}")
        check_count(self.meeting_at(label), LARGEST_ANSWER // (self.dimension + 1))
        return star_round(self, self.corners([key])[0], int(label))

    def meeting_at(self, label: int) -> int:
        """How many simplices share a vertex with that label: the order of its stabiliser."""
        return self.triangulation.simplex.stabiliser_order(label)

    @cached_property
    def _locator(self) -> Locator:
        cells = None if self._subgroup.classical else cells_of(self._subgroup)
        return Locator(self._subgroup, cells, self._centre, self.key_unit)

    def _images(self, keys: ArrayLike, points: Ints, shares: Ints, unit: int) -> Ints:
        """Points (j, m) of the fundamental simplex, with barycentric coordinates, carried to others."""
        known, rows = self._read(keys), max(1, NUMBERS // points.size)
        images = np.empty((len(known), *points.shape), dtype=known.dtype)
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


def check_count(count: float, most: float, words: str = "at least {} simplices", why: str = "") -> None:
    """Refuse to look for more than fits in memory, by a bound for the count or an estimate."""
    if count > most:
        told = words.format(f"{min(count, 10**300):.3g}")
        raise InvalidInput(f"there are {told}{why}: too many to hold; ask for fewer")


def _whole(array: NDArray[Any]) -> bool:
    """Whether there is nothing but integers in an array."""
    return array.dtype.kind in "iu" or (
        array.dtype == object and all(isinstance(x, (int, np.integer)) for x in array.flat)
    )
