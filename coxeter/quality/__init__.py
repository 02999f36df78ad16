"""The quality measures of a simplex, raw and normalised by the regular simplex (paper, Section 3).

A measure is any function of a simplex that returns an exact number; `measure` adds one. It is then
normalised, tabulated and reported like the paper's four, which `paper` defines. `mesh` adds those that mesh
people use; they are found by `find_measure`.
"""

from .mesh import (
    condition,
    edge_ratio,
    inradius_to_longest_edge,
    maximal_dihedral_angle,
    mean_ratio,
    minimal_dihedral_angle,
    minimal_solid_angle,
)
from .paper import PAPER_MEASURES, aspect_ratio, fatness, radius_ratio, thickness
from .registry import (
    MEASURES,
    MESH_MEASURES,
    Measure,
    Number,
    find_measure,
    measure,
    normalized_qualities,
    qualities,
    root,
)

__all__ = [
    "MEASURES",
    "MESH_MEASURES",
    "PAPER_MEASURES",
    "Measure",
    "Number",
    "aspect_ratio",
    "condition",
    "edge_ratio",
    "fatness",
    "find_measure",
    "inradius_to_longest_edge",
    "maximal_dihedral_angle",
    "mean_ratio",
    "measure",
    "minimal_dihedral_angle",
    "minimal_solid_angle",
    "normalized_qualities",
    "qualities",
    "radius_ratio",
    "root",
    "thickness",
]
