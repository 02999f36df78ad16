"""The figures of the paper, drawn from computed data.

Each function returns a `Figure`: a drawing that follows the page's light or dark theme, words for
those who cannot see it, and the exact values that are plotted. To add a figure, write down its values
as a named tuple, a function that draws them on a `Canvas`, and one that puts them into words.

>>> from coxeter.figures import coxeter_diagram
>>> coxeter_diagram("E~6").data.line
(1, 3, 4, 5, 6)
"""

from .cube import cube_simplex
from .curves import quality_curves
from .diagrams import coxeter_diagram, diagram_pair, family_diagram
from .figure import Figure, beside
from .monohedral import monohedral_not_coxeter
from .root_systems import root_system_plane
from .tilings import tiling
from .triangulations import plane_triangulation

__all__ = [
    "Figure",
    "beside",
    "coxeter_diagram",
    "cube_simplex",
    "diagram_pair",
    "family_diagram",
    "monohedral_not_coxeter",
    "plane_triangulation",
    "quality_curves",
    "root_system_plane",
    "tiling",
]
