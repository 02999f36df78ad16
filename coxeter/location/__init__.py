"""A Coxeter triangulation laid over R^d: which simplex holds a point, and which are around it.

>>> from coxeter.location import Grid
>>> grid = Grid("A~2", scale=2)
>>> grid.locate([[0.3, 0.4]]).barycentric.round(2).tolist()
[[0.65, 0.21, 0.14]]
"""

from .grid import Grid, Location

__all__ = ["Grid", "Location"]
