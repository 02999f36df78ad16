"""The quality measures of a simplex, raw and normalised by the regular simplex (paper, Section 3).

A measure is any function of a `Simplex` that returns an exact number; `measure` adds one. It is then
normalised, tabulated and reported like the paper's four.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

from .errors import InvalidInput
from .exact import Surd, surd
from .simplex import Simplex, regular_simplex


@dataclass(frozen=True)
class Measure:
    """A quality measure.

    Attributes
    ----------
    name
        Such as ``"thickness"``.
    symbol
        LaTeX for the raw measure, as ``\\theta``.
    of
        The function from a simplex to an exact number.
    per_dimension
        Whether the normalised value is taken to the power 1/d, as fatness is in Table 2.
    """

    name: str
    symbol: str
    of: Callable[[Simplex], Surd]
    per_dimension: bool = False

    def __call__(self, simplex: Simplex) -> Surd:
        """The raw measure of a simplex, or of the fundamental simplex of a triangulation."""
        return surd(self.of(_simplex_of(simplex)))

    def normalized(self, simplex: Simplex) -> Surd:
        """The measure divided by that of the regular simplex; to the power 1/d if `per_dimension`.

        >>> fatness.normalized(regular_simplex(5))
        1
        """
        d = _simplex_of(simplex).dimension
        ratio = self(simplex) / _of_regular_simplex(self, d)
        return ratio.root(d) if self.per_dimension else ratio

    @property
    def normalized_symbol(self) -> str:
        """LaTeX for the normalised measure."""
        power = "^{1/d}" if self.per_dimension else ""
        return rf"\hat{{{self.symbol}}}{power}"


def _simplex_of(value: object) -> Simplex:
    simplex = getattr(value, "simplex", value)
    if not isinstance(simplex, Simplex):
        raise InvalidInput(f"{value!r} is neither a simplex nor a triangulation")
    return simplex


@lru_cache(maxsize=512)
def _of_regular_simplex(measure: Measure, d: int) -> Surd:
    return measure(regular_simplex(d))


MEASURES: dict[str, Measure] = {}
"""The measures known by name, in the order in which they were added."""


def measure(
    name: str, symbol: str = "", per_dimension: bool = False
) -> Callable[[Callable[[Simplex], Surd]], Measure]:
    """Decorator: add a quality measure.

    Parameters
    ----------
    name
        A new name.
    symbol
        LaTeX for it; the name is used if none is given.
    per_dimension
        Whether normalised values are taken to the power 1/d; for measures that, as a volume does,
        scale with the d-th power of a length.

    Raises
    ------
    InvalidInput
        If the name is taken.

    Examples
    --------
    >>> @measure("edge ratio")
    ... def edge_ratio(simplex):
    ...     e = simplex.squared_edge_lengths
    ...     shortest = min(e[i, j] for i in range(len(e.rows())) for j in range(i))
    ...     return sqrt(shortest / simplex.squared_longest_edge)
    >>> from coxeter.exact import sqrt
    >>> edge_ratio(Simplex([(0, 0), (3, 0), (0, 4)]))
    3/5
    >>> del MEASURES["edge ratio"]
    """
    if name in MEASURES:
        raise InvalidInput(f"there is already a measure {name!r}: give another name")

    def add(function: Callable[[Simplex], Surd]) -> Measure:
        MEASURES[name] = Measure(name, symbol or rf"\text{{{name}}}", function, per_dimension)
        return MEASURES[name]

    return add


def find_measure(name: str) -> Measure:
    """The measure with a given name; raises `InvalidInput`, naming those there are."""
    try:
        return MEASURES[name]
    except KeyError:
        raise InvalidInput(f"{name!r} is no quality measure; there are {', '.join(MEASURES)}") from None


@measure("aspect_ratio", r"\alpha")
def aspect_ratio(simplex: Simplex) -> Surd:
    """α = h / 2R: minimal height over the diameter of the circumscribed ball (Definition 18).

    >>> aspect_ratio(regular_simplex(2))
    3/4
    """
    return simplex.minimal_height / (2 * simplex.circumradius)


@measure("fatness", r"\Theta", per_dimension=True)
def fatness(simplex: Simplex) -> Surd:
    """Θ = vol / L^d: volume over the longest edge to the power d (Definition 18).

    >>> fatness(regular_simplex(2))
    sqrt(3)/4
    """
    return simplex.volume / simplex.longest_edge**simplex.dimension


@measure("thickness", r"\theta")
def thickness(simplex: Simplex) -> Surd:
    """θ = h / L: minimal height over the longest edge (Definition 18).

    >>> thickness(regular_simplex(2))
    sqrt(3)/2
    """
    return simplex.minimal_height / simplex.longest_edge


@measure("radius_ratio", r"\rho")
def radius_ratio(simplex: Simplex) -> Surd:
    """ρ = r / R: inradius over circumradius (Definition 18).

    >>> radius_ratio(regular_simplex(2))
    1/2
    """
    return simplex.inradius / simplex.circumradius


PAPER_MEASURES = (aspect_ratio, fatness, thickness, radius_ratio)
"""The four measures of Definition 18."""

__test__ = {known.name: known.of.__doc__ for known in PAPER_MEASURES}  # their examples are run too


def qualities(simplex: Simplex) -> dict[str, Surd]:
    """All known measures of a simplex, raw."""
    return {name: known(simplex) for name, known in MEASURES.items()}


def normalized_qualities(simplex: Simplex) -> dict[str, Surd]:
    """All known measures of a simplex, normalised by the regular simplex."""
    return {name: known.normalized(simplex) for name, known in MEASURES.items()}
