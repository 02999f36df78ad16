"""What the core computes, under the names and letters that the printed formulas use."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType

from .. import delaunay, quality
from ..affine import CoxeterTriangulation, triangulation
from ..exact import Surd, sqrt
from ..names import EXCEPTIONAL, MINIMAL_DIMENSION, parse_triangulation
from ..simplex import Simplex, regular_simplex

LARGEST = 24
"""Printed formulas are compared for every d up to this one."""


def dimensions(family: str, parity: str = "") -> tuple[int, ...]:
    """The dimensions in which printed values for a family are compared.

    >>> dimensions("A", "even")[:3], dimensions("E7")
    ((2, 4, 6), (7,))
    """
    if family not in MINIMAL_DIMENSION and family != "regular":
        return (int(family[1:]),)
    every = range(MINIMAL_DIMENSION.get(family, 1), LARGEST + 1)
    return tuple(d for d in every if parity in ("", "odd" if d % 2 else "even"))


def family_of(letter: str, d: int) -> str | None:
    """The family of the triangulation with a letter and a dimension; None if there is none.

    >>> family_of("E", 7), family_of("E", 5), family_of("B", 3)
    ('E7', None, 'B')
    """
    exists = d in EXCEPTIONAL.get(letter, ()) or d >= MINIMAL_DIMENSION.get(letter, d + 1)
    return parse_triangulation((letter, d)).family if exists else None


def affine_name(family: str) -> str:
    """The name of a family as the places have it: ``A~``, ``E~6``."""
    return f"{family[0]}~{family[1:]}"


@lru_cache(maxsize=256)
def triangulation_of(family: str, d: int) -> CoxeterTriangulation:
    """The member of a family in dimension d."""
    return triangulation((family[0], d))


def simplex_of(family: str, d: int) -> Simplex:
    """Its fundamental simplex; for the family ``regular`` the regular simplex."""
    return regular_simplex(d) if family == "regular" else triangulation_of(family, d).simplex


@lru_cache(maxsize=4096)
def exact_value(family: str, quantity: str, d: int) -> Surd:
    """A quantity of a member of a family, computed by the core.

    >>> exact_value("B", "longest_edge", 3), exact_value("E8", "normalized_thickness", 8)
    (1, sqrt(2)/9)
    """
    if quantity == "relative_protection":
        return delaunay.protection(triangulation_of(family, d)).relative
    if quantity == "protection":
        return delaunay.protection(triangulation_of(family, d)).absolute
    if quantity == "mirror_distance":
        mirrors = delaunay.mirror_vertices(triangulation_of(family, d))
        return sqrt(min(m.squared_distance for m in mirrors))
    simplex = simplex_of(family, d)
    if quantity.startswith("normalized_"):
        value: Surd = quality.find_measure(quantity.removeprefix("normalized_")).normalized(simplex)
        return value
    if quantity in quality.MEASURES:
        return quality.MEASURES[quantity](simplex)
    value = getattr(simplex, quantity)
    return value


LETTERS = {
    "minimal_height": "h",
    "longest_edge": "L",
    "inradius": "r",
    "circumradius": "R",
    "volume": "vol",
}
DEFINITIONS = {
    "aspect_ratio": "h/(2*R)",
    "fatness": "vol/L**d",
    "thickness": "h/L",
    "radius_ratio": "r/R",
}
"""Definition 18 in these letters."""


@lru_cache(maxsize=256)
def letters(family: str, d: int) -> Mapping[str, Surd]:
    """The values of the letters in formulas: d, h, L, r, R and vol.

    Also ``edge`` for the length of the edge from vertex 0 to vertex d, and for each measure its value
    for the regular simplex, as ``regular_thickness``.
    """
    squares = simplex_of(family, d).squared_edge_lengths
    values = {
        "d": Surd(d),
        "edge": sqrt(squares[0, d]),
        **{letter: exact_value(family, name, d) for name, letter in LETTERS.items()},
        **{f"regular_{name}": exact_value("regular", name, d) for name in DEFINITIONS},
    }
    return MappingProxyType(values)


def normalize(family: str, quantity: str, d: int, value: Surd) -> tuple[str, Surd] | None:
    """The normalised measure that a value stands for, and its value; None if it is no measure."""
    if quantity.startswith("normalized_"):
        return quantity, value
    if quantity not in DEFINITIONS or family == "regular":
        return None
    ratio = value / exact_value("regular", quantity, d)
    return f"normalized_{quantity}", ratio.root(d) if quantity == "fatness" else ratio
