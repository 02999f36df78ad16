"""The thirteen figures of the paper by their numbers."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from ..errors import InvalidInput
from .appendix_a import lemma_9_distances, lemma_10_plane
from .appendix_b import lemma_4_circles
from .cube import cube_simplex
from .diagrams import diagram_pair
from .figure import Figure, above, beside, headed
from .monohedral import monohedral_not_coxeter
from .root_systems import root_system_plane
from .triangulations import plane_triangulation

DIAGRAMS = ("A~d", "B~d", "C~d", "D~d", "E~6", "E~7", "E~8", "F~4")
"""The triangulations whose diagrams Figures 4 to 11 show; that of G~2 is not shown."""


def paper_figure(number: int) -> Figure[Any]:
    """A figure of the paper, by its number.

    Parameters
    ----------
    number
        From 1 to 13.

    Raises
    ------
    InvalidInput
        If there is no such figure.

    Examples
    --------
    >>> print(paper_figure(11).title)
    Coxeter diagram of F~4, twice
    """
    if isinstance(number, bool) or not isinstance(number, int) or number not in _MAKERS:
        raise InvalidInput(f"{number!r} is no figure of the paper: give a number from 1 to {len(_MAKERS)}")
    return _MAKERS[number]()


def _figure_1() -> Figure[Any]:
    """Each root system with its coroots beside it."""
    rows = [
        beside(
            headed(root_system_plane(name), f"${name[0]}_2$"),
            headed(root_system_plane(name, dual=True), rf"${name[0]}_2^{{\vee}}$"),
        )
        for name in ("A2", "B2", "G2")
    ]
    return above(*rows, title="The root systems of rank 2 and their coroots")


def _figure_2() -> Figure[Any]:
    """The triangulations of the plane, then the simplices of space, two in a row."""
    plane: list[Figure[Any]] = [plane_triangulation(name) for name in ("A~2", "C~2", "G~2")]
    space: list[Figure[Any]] = [cube_simplex(name) for name in ("A~3", "B~3", "C~3")]
    every = [headed(x, rf"$\tilde{{{x.data.name[0]}}}_{x.data.name[-1]}$") for x in (*plane, *space)]
    rows = [beside(*every[k : k + 2]) for k in (0, 2, 4)]
    return above(*rows, title="The Coxeter triangulations of the plane and the simplices of those of space")


def _figure_12() -> Figure[Any]:
    left: Figure[Any] = lemma_9_distances()
    right: Figure[Any] = lemma_10_plane()
    return beside(left, right)


_MAKERS: dict[int, Callable[[], Figure[Any]]] = {
    1: _figure_1,
    2: _figure_2,
    3: monohedral_not_coxeter,
    **{number: partial(diagram_pair, name, "heights") for number, name in enumerate(DIAGRAMS, 4)},
    12: _figure_12,
    13: lemma_4_circles,
}

NUMBERS = tuple(_MAKERS)
"""The numbers of the figures: 1 to 13."""
