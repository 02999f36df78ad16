"""The figures that the book's gallery shows, by the names of their files."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

from .angles import angle_classes
from .appendix_b import lemma_4_circles
from .curves import quality_curves
from .empty_sphere import sphere_not_empty
from .figure import Figure, above, beside
from .fixed_root import proposition_1_witness
from .not_lattice import difference_not_a_vertex
from .of_paper import NUMBERS, paper_figure
from .protection import protection_spheres
from .spike import lemma_10_witness
from .trapezoids import lemma_4_witness


class Entry(NamedTuple):
    """A figure of the gallery: how one makes it, in Python, and a function that does."""

    code: str
    make: Callable[[], Figure[Any]]


def _angles() -> Figure[Any]:
    return above(beside(angle_classes("A2"), angle_classes("B2")), beside(angle_classes("G2")))


def _protection() -> Figure[Any]:
    return beside(protection_spheres("A~2"), protection_spheres("A~3"))


GALLERY: dict[str, Entry] = {
    **{
        f"figure-{number}": Entry(f"paper_figure({number})", partial(paper_figure, number))
        for number in NUMBERS
    },
    "angle-classes": Entry('angle_classes("A2"), angle_classes("B2"), angle_classes("G2")', _angles),
    "a-reflection-fixes-a-root": Entry("proposition_1_witness()", proposition_1_witness),
    "protection": Entry('protection_spheres("A~2"), protection_spheres("A~3")', _protection),
    "a-sphere-not-empty": Entry("sphere_not_empty()", sphere_not_empty),
    "lemma-4-witness": Entry("lemma_4_witness()", lemma_4_witness),
    "lemma-4-gap": Entry("lemma_4_circles(4)", partial(lemma_4_circles, 4)),
    "lemma-10-witness": Entry("lemma_10_witness()", lemma_10_witness),
    "a-difference-not-a-vertex": Entry("difference_not_a_vertex()", difference_not_a_vertex),
    "thickness": Entry('quality_curves("thickness", 24)', partial(quality_curves, "thickness", 24)),
}
"""By name, in the order of the gallery."""
