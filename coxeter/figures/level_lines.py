"""Level lines of a function that is linear on each triangle of a patch."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidInput
from ..location import Grid
from ..location.interpolation import Function
from ..meshes import Mesh
from .canvas import BLUE, FAINT, INK, VERMILLION, Canvas, Pen
from .figure import Figure

_RADIUS = 165.0
_SHADES = 6


class Levels(NamedTuple):
    """What is drawn.

    Attributes
    ----------
    mesh
        The triangles that meet the disc.
    values
        Those of the function at the points of the mesh.
    lines
        For each level the segments (n, 2, 2) on which the interpolated function has that value.
    """

    mesh: Mesh
    values: NDArray[np.float64]
    lines: dict[float, NDArray[np.float64]]


def level_lines(
    grid: Grid, f: Function, centre: ArrayLike, radius: float, levels: ArrayLike
) -> Figure[Levels]:
    """The triangles that meet a disc, bluer where a function is greater, and its level lines in the patch.

    Parameters
    ----------
    grid
        Of the plane.
    f
        Takes points (n, 2) to values (n,).
    centre, radius
        The disc.
    levels
        The values whose lines are drawn.

    Raises
    ------
    InvalidInput
        If the grid is not in the plane.

    Examples
    --------
    >>> figure = level_lines(Grid("A~2"), lambda x: x[:, 0], [0, 0], 2, [0.5])
    >>> bool(abs(figure.data.lines[0.5][..., 0] - 0.5).max() < 1e-12)
    True
    """
    if grid.dimension != 2:
        raise InvalidInput(f"{grid} has dimension {grid.dimension}: only grids of the plane are drawn")
    mesh = grid.patch_in_ball(centre, radius)
    values = np.asarray(f(mesh.points), dtype=np.float64)
    lines = {float(level): _line(mesh.corners, values[mesh.cells] - level) for level in np.ravel(levels)}
    name = grid.triangulation.name
    alt = (
        f"A disc covered by the {len(mesh)} triangles of {name} that meet it, bluer where a function is "
        f"greater. {len(lines)} level lines of the function, straight in each triangle, run on without a gap."
    )
    data = Levels(mesh, values, lines)
    return Figure(
        f"Level lines on {name}", alt, data, lambda: _draw(data, np.asarray(centre, dtype=np.float64), radius)
    )


def _line(corners: NDArray[np.float64], heights: NDArray[np.float64]) -> NDArray[np.float64]:
    """Where linear functions with these values at the corners of triangles are zero: segments (n, 2, 2)."""
    above = heights > 0
    crossed = above.any(axis=1) & ~above.all(axis=1)
    corners, heights, above = corners[crossed], heights[crossed], above[crossed]
    # The corner that is alone on its side comes first; the line meets the two edges from there.
    alone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), above.argmin(axis=1))
    order = (alone[:, None] + np.arange(3)) % 3
    n = np.arange(len(order))[:, None]
    corners, heights = corners[n, order], heights[n, order]
    share = heights[:, :1] / (heights[:, :1] - heights[:, 1:])
    segments: NDArray[np.float64] = corners[:, :1] + share[..., None] * (corners[:, 1:] - corners[:, :1])
    return segments


def _draw(data: Levels, centre: NDArray[np.float64], radius: float) -> Canvas:
    canvas = Canvas()
    scale = _RADIUS / radius

    def pixels(points: NDArray[np.float64]) -> list[tuple[tuple[float, float], ...]]:
        moved = (points - centre) * [scale, -scale]
        return [tuple((x, y) for x, y in line) for line in moved.tolist()]

    means = data.values[data.mesh.cells].mean(axis=1)
    low, span = means.min(), max(float(np.ptp(means)), math.ulp(1.0))
    shade = np.minimum((means - low) / span * _SHADES, _SHADES - 1).astype(int)
    for k in range(_SHADES):
        outlines = pixels(data.mesh.corners[shade == k])
        canvas.polygons(outlines, BLUE, 0.06 + 0.07 * k)
    pairs = np.unique(np.sort(data.mesh.cells[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)), axis=0)
    canvas.lines(pixels(data.mesh.points[pairs]), FAINT)
    for segments in data.lines.values():
        canvas.lines(pixels(segments), Pen(VERMILLION, 2.2))
    canvas.disc((0.0, 0.0), _RADIUS, None, Pen(INK, 1.4, (5.0, 4.0)))
    return canvas.fit()
