"""All cells of a mesh, judged by the registered measures."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import CoxeterError, InvalidInput, Unavailable
from ..quality import MEASURES, MESH_MEASURES, Measure, find_measure
from ..quality.registry import told
from ..simplex import Simplex, regular_simplex
from .mesh import Mesh
from .simplices import Simplices

Floats = NDArray[np.float64]
CHUNK = 1 << 14
"""So many cells at a time, unless another number is given."""
HOW = (
    "write it as a formula in what `Simplices` knows, with numpy.minimum.reduce for min, numpy.where for if, "
    "and coxeter.quality.root"
)
Cells = Mesh | Simplices | Any
"""A mesh; simplices; or their corners, an array (n, d + 1, m), which may be of Dask."""


@dataclass(frozen=True)
class Judge:
    """A measure for many simplices of one dimension, divided by `regular`, to the power `power`."""

    name: str
    of: Callable[[Any], Any]
    larger_is_better: bool
    regular: float = 1.0
    power: float = 1.0

    def __call__(self, simplices: Simplices) -> Floats:
        """The values, shape (n,): NaN for a degenerate simplex."""
        try:
            with np.errstate(all="ignore"):  # what is no number is NaN, and counted
                values = (np.asarray(self.of(simplices), dtype=np.float64) / self.regular) ** self.power
        except (Unavailable, MemoryError):
            raise
        except Exception as error:
            raise InvalidInput(
                f"the measure {self.name!r} cannot be had of many simplices at once, as it raised "
                f"{told(error, self.of)}; {HOW}"
            ) from error
        if values.shape not in ((), (n := len(simplices),)):
            raise InvalidInput(f"{self.name!r} of {n} simplices has shape {values.shape}: expected ({n},)")
        return np.where(simplices.degenerate, np.nan, values)


def judges(
    measures: Iterable[str | Measure[Any]] | None, d: int, normalised: bool = True
) -> tuple[list[Judge], dict[str, str]]:
    """The measures made ready for many d-simplices, and why others are left out.

    None stands for all that are registered and can be had of arrays. One that is asked for and cannot be had
    is refused. Each is tried on two simplices at once, the regular one and a larger one along the edges of a
    cube, and has to give their exact values.
    """
    ready, left_out = [], {}
    for given in [*MEASURES, *MESH_MEASURES] if measures is None else measures:
        measure = find_measure(given) if isinstance(given, str) else given
        try:
            ready.append(_judge(measure, d, normalised))
        except CoxeterError as error:
            if measures is not None:
                raise
            left_out[measure.name] = str(error)
    return ready, left_out


def _judge(measure: Measure[Any], d: int, normalised: bool) -> Judge:
    raw = Judge(measure.name, measure.of, measure.larger_is_better)
    path = np.tri(d + 1, d, -1, dtype=np.int64) * 3
    regular = float(measure.norm(d) if normalised else measure(regular_simplex(d)))
    both = Simplices([np.eye(d + 1), np.pad(path, ((0, 0), (0, 1)))])
    for found, exact in zip(raw(both), (regular, float(measure(Simplex(path.tolist())))), strict=True):
        if not abs(found - exact) <= 1e-9 * abs(exact) + 1e-12:  # so a difference may vanish but for rounding
            raise InvalidInput(
                f"the measure {measure.name!r} is {exact:g} of a simplex, but {found:g} of the same in an "
                f"array of two; {HOW}"
            )
    if not normalised:
        return raw
    power = (1 / d if measure.per_dimension else 1.0) * (1 if measure.larger_is_better else -1)
    return Judge(measure.name, measure.of, True, regular, power)


def mesh_qualities(
    mesh: Cells, measures: Iterable[str | Measure[Any]] | None = None, normalised: bool = True
) -> dict[str, Any]:
    """The measures of all cells, by name: arrays (n,), with NaN for degenerate cells.

    Parameters
    ----------
    mesh
        A mesh, simplices, or corners (n, d + 1, m). From a Dask array come Dask arrays.
    measures
        Names, or measures; all that can be had by default.
    normalised
        Whether to divide by the regular simplex, as `Measure.normalized` does: then larger is better.

    Raises
    ------
    InvalidInput
        If there is no such measure, or it cannot be had of arrays.
    Unavailable
        If there is no method for it in this dimension.

    Examples
    --------
    >>> square = Mesh([[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 2], [1, 2, 3]])
    >>> mesh_qualities(square, ["thickness"])["thickness"].round(6).tolist()
    [0.57735, 0.57735]
    """
    if is_lazy(mesh):
        rows: Any = whole_rows(mesh)
        ready, _ = judges(measures, rows.shape[1] - 1, normalised)
        columns = rows.map_blocks(
            _columns, ready, dtype=np.float64, drop_axis=[1, 2], new_axis=[1],
            chunks=(rows.chunks[0], (len(ready),)), meta=np.empty((0, 0)),
        )  # fmt: skip
        return {judge.name: columns[:, i] for i, judge in enumerate(ready)}
    whole = mesh if isinstance(mesh, Mesh) else as_simplices(mesh)
    ready, _ = judges(measures, whole.dimension, normalised)
    parts = [[judge(part) for judge in ready] for part in in_chunks(whole, CHUNK)]
    return {judge.name: np.concatenate(values) for judge, *values in zip(ready, *parts, strict=True)}


def in_chunks(mesh: Mesh | Simplices, chunk: int) -> Iterator[Simplices]:
    """Some cells at a time; of none, none once."""
    for i in range(0, max(len(mesh), 1), chunk):
        rows = slice(i, i + chunk)
        yield Simplices(mesh.points[mesh.cells[rows]] if isinstance(mesh, Mesh) else mesh.corners[rows])


def _columns(corners: Floats, ready: list[Judge]) -> Floats:
    simplices = Simplices(corners)
    return np.stack([judge(simplices) for judge in ready], axis=1)


def as_simplices(mesh: Cells) -> Simplices:
    """The cells of a mesh, or what is given as corners."""
    if isinstance(mesh, Simplices):
        return mesh
    return Simplices(mesh.corners if isinstance(mesh, Mesh) else np.asarray(mesh))


def is_lazy(mesh: Any) -> bool:
    """Whether it is an array of Dask."""
    return hasattr(mesh, "dask") and hasattr(mesh, "rechunk")


def whole_rows(corners: Any) -> Any:
    """An array of Dask whose blocks hold whole simplices."""
    if corners.ndim != 3:
        raise InvalidInput(f"corners of shape {corners.shape}: expected (n, d + 1, m)")
    return corners.rechunk({1: -1, 2: -1})
