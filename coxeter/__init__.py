"""Coxeter triangulations, computed exactly from the simple roots up.

>>> import coxeter
>>> t = coxeter.triangulation("A~3")
>>> coxeter.thickness(t.simplex), coxeter.thickness.normalized(t.simplex)
(sqrt(2)/2, sqrt(3)/2)

The distribution is called ``coxeter-triangulations``; the package ``coxeter`` on the package index is
another project.
"""

from typing import TYPE_CHECKING, Any

from .affine import CoxeterTriangulation, affine_reflection, triangulation
from .delaunay import (
    circumcentre_position,
    delaunay_verdict,
    is_self_centred,
    mirror_vertices,
    protection,
    vertices_by_distance,
)
from .errors import (
    CoxeterError,
    DegenerateSimplex,
    InexactInput,
    InvalidInput,
    InvalidType,
    Unavailable,
    Undecided,
)
from .exact import Angle, RationalMatrix, Surd, rational, sqrt, surd
from .lattices import spanned_lattice, vertex_cosets, vertex_lattice
from .names import FAMILIES, Type, triangulations_up_to
from .quality import (
    MEASURES,
    MESH_MEASURES,
    Measure,
    aspect_ratio,
    fatness,
    find_measure,
    measure,
    normalized_qualities,
    qualities,
    radius_ratio,
    thickness,
)
from .root_lattices import Lattice, coroot_lattice, coweight_lattice, root_lattice, weight_lattice
from .roots import RootSystem, root_system
from .simplex import Position, Simplex, regular_simplex

if TYPE_CHECKING:
    from .proofs.symbolic_simplex import symbolic_simplex

__version__ = "0.1.0"

__all__ = [
    "FAMILIES",
    "MEASURES",
    "MESH_MEASURES",
    "Angle",
    "CoxeterError",
    "CoxeterTriangulation",
    "DegenerateSimplex",
    "InexactInput",
    "InvalidInput",
    "InvalidType",
    "Lattice",
    "Measure",
    "Position",
    "RationalMatrix",
    "RootSystem",
    "Simplex",
    "Surd",
    "Type",
    "Unavailable",
    "Undecided",
    "affine_reflection",
    "aspect_ratio",
    "circumcentre_position",
    "coroot_lattice",
    "coweight_lattice",
    "delaunay_verdict",
    "fatness",
    "find_measure",
    "is_self_centred",
    "measure",
    "mirror_vertices",
    "normalized_qualities",
    "protection",
    "qualities",
    "radius_ratio",
    "rational",
    "regular_simplex",
    "root_lattice",
    "root_system",
    "spanned_lattice",
    "sqrt",
    "surd",
    "symbolic_simplex",
    "thickness",
    "triangulation",
    "triangulations_up_to",
    "vertex_cosets",
    "vertex_lattice",
    "vertices_by_distance",
    "weight_lattice",
]


def __getattr__(name: str) -> Any:
    """`symbolic_simplex`, when it is asked for: it needs SymPy, which takes long to load."""
    if name == "symbolic_simplex":
        from .proofs.symbolic_simplex import symbolic_simplex

        return symbolic_simplex
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
