"""A Coxeter triangulation laid over R^d: which simplex holds a point, which fill a region.

>>> from coxeter.location import Grid
>>> grid = Grid("A~2", scale=2)
>>> grid.locate([[0.3, 0.4]]).barycentric.round(2).tolist()
[[0.65, 0.21, 0.14]]
>>> grid.patch_in_ball([0, 0], 3)
Mesh(31 points in R^2, 42 cells of dimension 2)
"""

from .grid import Grid
from .interpolation import Interpolation, Vertices
from .location import Location

__all__ = ["Grid", "Interpolation", "Location", "Vertices"]
