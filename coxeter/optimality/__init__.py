"""How good a triangulation of space can be: the open conjectures of Section 1.4, tried on what is known.

`images` has affine images of Coxeter triangulations, and the proof that none is better than the triangulation
itself; `verdicts` says it of a single image; `sharpness` how fast quality falls around it; `fillers` other
simplices that fill space; `crystals` triangulations of space by several kinds of tetrahedra.

>>> from coxeter.optimality import A15, affine_image
>>> A15.quality("fatness") > affine_image("A~3").quality("fatness")
True
"""

from .crystals import A15, BCC, C15, Crystal
from .fillers import halves, hill, part_around_centre
from .images import AffineImage, affine_image
from .sharpness import crystal_directions, crystal_gradient_rank, directions, gradient_rank
from .verdicts import Optimality, Verdict, local_optimality

__all__ = [
    "A15",
    "BCC",
    "C15",
    "AffineImage",
    "Crystal",
    "Optimality",
    "Verdict",
    "affine_image",
    "crystal_directions",
    "crystal_gradient_rank",
    "directions",
    "gradient_rank",
    "halves",
    "hill",
    "local_optimality",
    "part_around_centre",
]
