"""Simplicial meshes as arrays: their points, their cells, and what is known of either.

>>> from coxeter.meshes import Mesh
>>> Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])
Mesh(3 points in R^2, 1 cell of dimension 2)
"""

from .mesh import Mesh

__all__ = ["Mesh"]
