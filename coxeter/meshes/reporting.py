"""The qualities of all cells of a mesh, summed up; in chunks, so that a mesh of any size has its report.

A chunk becomes a `Tally`, and tallies add up. Values are counted by themselves rounded to 14 binary digits:
that keeps quantiles and histograms to a relative 2^-14, in memory that does not grow with the mesh.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, field
from functools import reduce
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidInput
from ..quality import Measure
from .doubles import doubled_cells
from .interop import library
from .judging import CHUNK, Cells, Floats, Judge, as_simplices, in_chunks, is_lazy, judges, whole_rows
from .mesh import Mesh
from .simplices import Simplices

DIGITS = 14
"""Binary digits that are kept of a value to be counted."""
QUANTILES = (0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99)
NAMED = 10
"""So many degenerate, inverted and doubled cells are named."""


@dataclass(frozen=True)
class Spread:
    """The values of one measure in some cells."""

    values: Floats
    counts: NDArray[np.int64]
    total: float
    least: float
    greatest: float
    lowest: int
    highest: int
    undefined: int

    @classmethod
    def of(cls, values: Floats) -> Spread:
        """That of an array, in which what is not finite is undefined."""
        cells = np.flatnonzero(np.isfinite(values))
        known = values[cells]
        if not len(known):
            return cls(np.empty(0), np.empty(0, np.int64), 0.0, np.inf, -np.inf, -1, -1, len(values))
        mantissas, exponents = np.frexp(known)
        rounded = np.ldexp(np.rint(mantissas * 2.0**DIGITS), exponents - DIGITS)
        different, counts = np.unique(rounded, return_counts=True)
        least, greatest = float(known.min()), float(known.max())
        lowest, highest = int(cells[known.argmin()]), int(cells[known.argmax()])
        undefined = len(values) - len(known)
        return cls(different, counts, float(known.sum()), least, greatest, lowest, highest, undefined)

    def add(self, other: Spread, offset: int) -> Spread:
        """That of these cells and of others, which are numbered from `offset`."""
        values = np.union1d(self.values, other.values)
        counts = np.zeros(len(values), dtype=np.int64)
        for part in (self, other):
            counts[np.searchsorted(values, part.values)] += part.counts
        lowest = other.lowest + offset if other.least < self.least else self.lowest
        highest = other.highest + offset if other.greatest > self.greatest else self.highest
        return Spread(
            values, counts, self.total + other.total, min(self.least, other.least),
            max(self.greatest, other.greatest), lowest, highest, self.undefined + other.undefined,
        )  # fmt: skip

    def quantile(self, share: float) -> float:
        """The least value that so large a share of the cells does not exceed."""
        below = np.cumsum(self.counts)
        value = self.values[np.searchsorted(below, share * below[-1])]
        return float(np.clip(value, self.least, self.greatest))


class Some(NamedTuple):
    """How many cells, and the numbers of the first of them."""

    number: int
    first: list[int]

    @classmethod
    def of(cls, cells: NDArray[np.int64]) -> Some:
        """Those with the given numbers."""
        return cls(len(cells), cells[:NAMED].tolist())

    def add(self, other: Some, offset: int) -> Some:
        """These and others, which are numbered from `offset`."""
        first = [*self.first, *(k + offset for k in other.first)]
        return Some(self.number + other.number, first[:NAMED])


@dataclass(frozen=True)
class Tally:
    """What is kept of some cells."""

    cells: int
    degenerate: Some
    inverted: Some
    error: float
    spreads: dict[str, Spread]

    @classmethod
    def of(cls, simplices: Simplices, ready: list[Judge]) -> Tally:
        """That of simplices."""
        flat = simplices.degenerate
        error = simplices.error[~flat].max(initial=0)
        spreads = {judge.name: Spread.of(judge(simplices)) for judge in ready}
        degenerate, inverted = (Some.of(np.flatnonzero(x)) for x in (flat, simplices.negative & ~flat))
        return cls(len(simplices), degenerate, inverted, float(error), spreads)

    def __add__(self, other: Tally) -> Tally:
        n = self.cells
        spreads = {x: spread.add(other.spreads[x], n) for x, spread in self.spreads.items()}
        degenerate = self.degenerate.add(other.degenerate, n)
        inverted = self.inverted.add(other.inverted, n)
        return Tally(n + other.cells, degenerate, inverted, max(self.error, other.error), spreads)


@dataclass(frozen=True)
class MeasureReport:
    """How one measure is distributed over the cells that are not degenerate.

    Attributes
    ----------
    undefined
        How many of these cells the measure gives no number.
    worst
        The number of the cell with the least value, or the greatest where smaller is better; None if there
        is none.
    quantiles, median
        To a relative 2^-14; by shares, as ``"0.05"``.
    edges, counts
        The histogram: `counts[i]` cells from `edges[i]` to `edges[i + 1]`.
    """

    measure: str
    undefined: int
    min: float | None = None
    mean: float | None = None
    median: float | None = None
    max: float | None = None
    worst: int | None = None
    quantiles: dict[str, float] = field(default_factory=dict)
    edges: list[float] = field(default_factory=list)
    counts: list[int] = field(default_factory=list)


@dataclass(frozen=True)
class QualityReport:
    """What `quality_report` finds.

    Attributes
    ----------
    cells, dimension
        How many there are, and of which dimension.
    degenerate
        How many are so flat that floats do not tell their measures; `degenerate_cells` names the first.
    inverted
        How many others are oriented negatively, as `Simplices.negative` says; `inverted_cells` names the
        first. None where there is no orientation, as of triangles in space. But where all points of a `Mesh`
        have the same third coordinate, they count as points of the plane.
    doubled
        How many name the same points as a cell before them; `doubled_cells` names the first. None where
        corners were given, not a `Mesh`.
    error
        A bound for the relative rounding error of heights, radii and volumes of all other cells.
    measures
        A `MeasureReport` for each measure.
    left_out
        Why other measures are not there, by name.
    """

    cells: int
    dimension: int
    degenerate: int
    degenerate_cells: list[int]
    inverted: int | None
    inverted_cells: list[int]
    doubled: int | None
    doubled_cells: list[int]
    error: float
    measures: list[MeasureReport]
    left_out: dict[str, str]

    def data(self) -> dict[str, Any]:
        """All of it as JSON-ready data."""
        return asdict(self)


def quality_report(
    mesh: Cells,
    measures: Iterable[str | Measure[Any]] | None = None,
    normalised: bool = True,
    bins: int = 10,
    chunk: int = CHUNK,
    progress: Callable[[int], None] | None = None,
) -> QualityReport:
    """How the measures are distributed over the cells of a mesh.

    Beside the mesh it takes memory for one chunk: less than 150·(d + 1)(m + 1) bytes a cell of it, and for
    each measure some hundred kilobytes for the values that occur. Then, to find doubled cells, it takes 40
    bytes for each cell of the mesh, about 2^23 of them at a time, and more for those that are doubled. A Dask
    array of corners is worked on where its blocks are, a block at a time on each worker.

    Parameters
    ----------
    mesh
        A mesh, simplices, or corners (n, d + 1, m), which may be an array of Dask.
    measures
        Names, or measures; all that can be had by default.
    normalised
        Whether to divide by the regular simplex, as `Measure.normalized` does: then larger is better.
    bins
        Bars of the histograms. They reach from 0 to 1 if all values lie there, else from the least to the
        greatest.
    chunk
        How many cells are looked at together.
    progress
        Is told how many cells are done, after each chunk.

    Raises
    ------
    InvalidInput
        If there is no such measure, or a number is not positive.

    Examples
    --------
    >>> square = Mesh([[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 2], [1, 2, 3]])
    >>> report = quality_report(square, ["thickness"], bins=4)
    >>> report.cells, report.degenerate, report.measures[0].counts
    (2, 0, [0, 0, 2, 0])
    """
    for name, number in {"bins": bins, "chunk": chunk}.items():
        if number < 1:
            raise InvalidInput(f"{name} is {number}: give a number >= 1")
    if is_lazy(mesh):
        rows = whole_rows(mesh)
        d, m = rows.shape[1] - 1, rows.shape[2]
        ready, left_out = judges(measures, d, normalised)
        parts: Iterable[Tally] = _on_workers(rows, ready)
    else:
        whole = _flat(mesh) if isinstance(mesh, Mesh) else as_simplices(mesh)
        d, m = whole.dimension, (whole.points if isinstance(whole, Mesh) else whole.corners).shape[-1]
        ready, left_out = judges(measures, d, normalised)
        parts = _in_chunks(whole, ready, chunk, progress)
    tally = reduce(Tally.__add__, parts)
    reports = [
        _measure_report(judge, tally.spreads[judge.name], tally.degenerate.number, bins, normalised)
        for judge in ready
    ]
    unknown: tuple[int | None, list[int]] = (None, [])
    inverted = tally.inverted if d == m else unknown
    doubled = Some.of(doubled_cells(mesh, chunk)) if isinstance(mesh, Mesh) else unknown
    return QualityReport(
        tally.cells, d, *tally.degenerate, *inverted, *doubled, tally.error, reports, left_out
    )  # fmt: skip


def _flat(mesh: Mesh) -> Mesh:
    """The same without the coordinates after the d-th, if each of them is the same for all points."""
    beyond = mesh.points[:, mesh.dimension :]
    if not beyond.size or (beyond.min(axis=0) != beyond.max(axis=0)).any():
        return mesh
    return Mesh(mesh.points[:, : mesh.dimension], mesh.cells)


def _in_chunks(
    mesh: Mesh | Simplices, ready: list[Judge], chunk: int, progress: Callable[[int], None] | None
) -> Iterator[Tally]:
    done = 0
    for part in in_chunks(mesh, chunk):
        yield Tally.of(part, ready)
        done += len(part)
        if progress:
            progress(done)


def _on_workers(corners: Any, ready: list[Judge]) -> Iterable[Tally]:
    dask = library("dask")
    tallies: Iterable[Tally] = dask.compute(
        *(dask.delayed(_tally)(block, ready) for block in corners.to_delayed().ravel())
    )
    return tallies


def _tally(corners: Floats, ready: list[Judge]) -> Tally:
    return Tally.of(Simplices(corners), ready)


def _measure_report(judge: Judge, x: Spread, degenerate: int, bins: int, normalised: bool) -> MeasureReport:
    undefined = x.undefined - degenerate
    if not len(x.values):
        return MeasureReport(judge.name, undefined)
    unit = normalised and x.values[0] >= 0 and x.values[-1] <= 1
    counts, edges = np.histogram(x.values, bins, (0, 1) if unit else None, weights=x.counts)
    quantiles = {str(share): x.quantile(share) for share in QUANTILES}
    mean = x.total / int(x.counts.sum())
    worst = x.lowest if judge.larger_is_better else x.highest
    return MeasureReport(
        judge.name, undefined, x.least, mean, x.quantile(0.5), x.greatest, worst,
        quantiles, edges.tolist(), counts.astype(int).tolist(),
    )  # fmt: skip
