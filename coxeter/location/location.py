"""What locating points answers."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from ..meshes.judging import is_lazy
from .lazy import vertices_lazily
from .subgroups import Ints

if TYPE_CHECKING:
    from .feasible import Flags
    from .grid import Floats, Grid


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
    open: Flags

    def __len__(self) -> int:
        return len(self.keys)

    @cached_property
    def vertices(self) -> Floats:
        """The vertices of the simplices, shape (n, d + 1, d), by their labels."""
        if is_lazy(self.keys):
            lazy: Floats = vertices_lazily(self.grid, self.keys)
            return lazy
        return self.grid.vertices(self.keys)
