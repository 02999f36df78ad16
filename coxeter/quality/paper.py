"""The four measures of Definition 18."""

from __future__ import annotations

from ..exact import Surd
from ..simplex import Simplex
from .registry import measure


@measure("aspect_ratio", r"\alpha")
def aspect_ratio(simplex: Simplex) -> Surd:
    """α = h / 2R: minimal height over the diameter of the circumscribed ball (Definition 18).

    >>> from coxeter import regular_simplex
    >>> aspect_ratio(regular_simplex(2))
    3/4
    """
    return simplex.minimal_height / (2 * simplex.circumradius)


@measure("fatness", r"\Theta", per_dimension=True)
def fatness(simplex: Simplex) -> Surd:
    """Θ = vol / L^d: volume over the longest edge to the power d (Definition 18).

    >>> from coxeter import regular_simplex
    >>> fatness(regular_simplex(2))
    sqrt(3)/4
    """
    return simplex.volume / simplex.longest_edge**simplex.dimension


@measure("thickness", r"\theta")
def thickness(simplex: Simplex) -> Surd:
    """θ = h / L: minimal height over the longest edge (Definition 18).

    >>> from coxeter import regular_simplex
    >>> thickness(regular_simplex(2))
    sqrt(3)/2
    """
    return simplex.minimal_height / simplex.longest_edge


@measure("radius_ratio", r"\rho")
def radius_ratio(simplex: Simplex) -> Surd:
    """ρ = r / R: inradius over circumradius (Definition 18).

    >>> from coxeter import regular_simplex
    >>> radius_ratio(regular_simplex(2))
    1/2
    """
    return simplex.inradius / simplex.circumradius


PAPER_MEASURES = (aspect_ratio, fatness, thickness, radius_ratio)
"""The four measures of Definition 18."""

__test__ = {known.name: known.of.__doc__ for known in PAPER_MEASURES}  # their examples are run too
