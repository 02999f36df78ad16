"""The figures of the paper, drawn from computed data.

Each function returns a `Figure`: a drawing that follows the page's light or dark theme, words for
those who cannot see it, and the exact values that are plotted. To add a figure, write down its values
as a named tuple, a function that draws them on a `Canvas`, and one that puts them into words.

>>> from coxeter.figures import coxeter_diagram
>>> coxeter_diagram("E~6").data.line
(1, 3, 4, 5, 6)
"""

from .angles import angle_classes
from .appendix_a import lemma_9_distances, lemma_10_plane
from .appendix_b import lemma_4_circles
from .cube import cube_simplex
from .curves import quality_curves
from .diagrams import coxeter_diagram, diagram_pair, family_diagram
from .empty_sphere import sphere_not_empty
from .figure import Figure, above, beside
from .fixed_root import proposition_1_witness
from .hill import hill_curves
from .monohedral import monohedral_not_coxeter
from .not_lattice import difference_not_a_vertex
from .of_paper import paper_figure
from .protection import protection_spheres
from .root_systems import root_system_plane
from .spike import lemma_10_witness
from .tilings import tiling
from .trapezoids import lemma_4_witness
from .triangulations import plane_triangulation

__all__ = [
    "Figure",
    "above",
    "angle_classes",
    "beside",
    "coxeter_diagram",
    "cube_simplex",
    "diagram_pair",
    "difference_not_a_vertex",
    "family_diagram",
    "hill_curves",
    "lemma_4_circles",
    "lemma_4_witness",
    "lemma_9_distances",
    "lemma_10_plane",
    "lemma_10_witness",
    "monohedral_not_coxeter",
    "paper_figure",
    "plane_triangulation",
    "proposition_1_witness",
    "protection_spheres",
    "quality_curves",
    "root_system_plane",
    "sphere_not_empty",
    "tiling",
]
