"""Simplicial meshes as arrays: their points, their cells, and what is known of either.

>>> from coxeter.meshes import Mesh
>>> Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])
Mesh(3 points in R^2, 1 cell of dimension 2)
"""

from .files import read_mesh, write_mesh
from .interop import from_gudhi, from_meshio, from_pyvista, to_gudhi, to_meshio, to_pyvista
from .judging import mesh_qualities
from .mesh import Mesh
from .reporting import QualityReport, quality_report
from .simplices import Simplices

__all__ = [
    "Mesh",
    "QualityReport",
    "Simplices",
    "from_gudhi",
    "from_meshio",
    "from_pyvista",
    "mesh_qualities",
    "quality_report",
    "read_mesh",
    "to_gudhi",
    "to_meshio",
    "to_pyvista",
    "write_mesh",
]
