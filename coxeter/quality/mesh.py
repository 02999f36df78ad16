"""The measures that mesh people use.

Knupp's two compare a simplex with the regular one by the matrix S = A W⁻¹: the columns of A are its edges
from one vertex, those of W the edges of the regular simplex with edges 1. In the Frobenius norm

    ‖S‖² = 2/(d+1) · (sum of the squared edges),    ‖S⁻¹‖² = ½ · (sum of 1 over the squared heights),

as WᵀW = (I + J)/2, and the inverse of AᵀA bordered to row sums 0 has the inverse squared heights as its
diagonal. So both are functions of lengths, whatever the order of the vertices.

Sources: P. M. Knupp, *Algebraic mesh quality metrics*, SIAM J. Sci. Comput. 23 (2001); A. Liu and B. Joe,
*Relationship between tetrahedron shape measures*, BIT 34 (1994); J. R. Shewchuk, *What is a good
linear finite element?* (2002).
"""

from __future__ import annotations

import math
from typing import Any

from .registry import MESH_MEASURES, measure, root


@measure("edge_ratio", r"\epsilon", among=MESH_MEASURES)
def edge_ratio(simplex: Any) -> Any:
    """The shortest edge over the longest. Larger is better.

    ``ε = l_min / l_max``.

    >>> from coxeter import Simplex
    >>> edge_ratio(Simplex([(0, 0), (3, 0), (0, 4)]))
    3/5
    """
    return simplex.shortest_edge / simplex.longest_edge


@measure("inradius_to_longest_edge", r"\iota", among=MESH_MEASURES)
def inradius_to_longest_edge(simplex: Any) -> Any:
    """The inradius over the longest edge. Larger is better.

    ``ι = r / L``; finite element error bounds have its inverse.

    >>> from coxeter import Simplex
    >>> inradius_to_longest_edge(Simplex([(0, 0), (3, 0), (0, 4)]))
    1/5
    """
    return simplex.inradius / simplex.longest_edge


@measure("mean_ratio", r"\eta", among=MESH_MEASURES)
def mean_ratio(simplex: Any) -> Any:
    """The geometric mean of the eigenvalues of SᵀS over the arithmetic mean. Larger is better.

    So it is at most 1, and 1 for the regular simplex alone:
    ``η = d·det(S)^(2/d) / ‖S‖² = d(d+1)·((d!·vol)²/(d+1))^(1/d) / Σ l²``. Source: Liu and Joe 1994 for d = 3;
    Knupp 2001.

    >>> from coxeter import Simplex
    >>> mean_ratio(Simplex([(0, 0), (1, 0), (0, 1)]))
    sqrt(3)/2
    """
    d = simplex.dimension
    squared = (factorial(d) * simplex.volume) ** 2 / (d + 1)
    return d * (d + 1) * root(squared, d) / simplex.sum_of_squared_edges


@measure("condition", r"\kappa^{-1}", among=MESH_MEASURES)
def condition(simplex: Any) -> Any:
    """One over the condition number of S in the Frobenius norm, times d. Larger is better.

    So it is at most 1, and 1 for the regular simplex alone:
    ``1/κ = d / (‖S‖·‖S⁻¹‖) = d / √(Σ l² · Σ h⁻² / (d+1))``. Source: Knupp 2001.

    >>> from coxeter import Simplex
    >>> condition(Simplex([(0, 0), (1, 0), (0, 1)]))
    sqrt(3)/2
    """
    d = simplex.dimension
    product = simplex.sum_of_squared_edges * simplex.sum_of_inverse_squared_heights
    return d / root(product / (d + 1), 2)


@measure("minimal_dihedral_angle", r"\beta_{\min}", among=MESH_MEASURES)
def minimal_dihedral_angle(simplex: Any) -> Any:
    """The smallest angle between two facets, in degrees. Larger is better.

    >>> from coxeter import triangulation
    >>> minimal_dihedral_angle(triangulation("A~3"))
    60
    """
    return simplex.minimal_dihedral_angle


@measure("maximal_dihedral_angle", r"\beta_{\max}", larger_is_better=False, among=MESH_MEASURES)
def maximal_dihedral_angle(simplex: Any) -> Any:
    """The largest angle between two facets, in degrees. Smaller is better (Shewchuk 2002).

    >>> from coxeter import regular_simplex
    >>> maximal_dihedral_angle(regular_simplex(3)).decimal(3)
    '70.529'
    """
    return simplex.maximal_dihedral_angle


@measure("minimal_solid_angle", r"\sigma_{\min}", among=MESH_MEASURES)
def minimal_solid_angle(simplex: Any) -> Any:
    """The smallest solid angle at a vertex, as a share of the whole sphere. Larger is better.

    Source: Liu and Joe 1994, for d = 3. For d = 2 it is the smallest angle over a full turn. In which cases
    it is known from d = 4 on is said at `Simplex.solid_angle`.

    >>> from coxeter import triangulation
    >>> minimal_solid_angle(triangulation("B~3"))
    1/48
    """
    return simplex.minimal_solid_angle


def factorial(d: Any) -> Any:
    """d!, also of a formula."""
    return d.factorial() if hasattr(d, "factorial") else math.factorial(d)


__test__ = {name: known.of.__doc__ for name, known in MESH_MEASURES.items()}  # their examples are run too
