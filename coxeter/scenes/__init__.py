"""Pictures to turn: a triangulation of space, its fundamental simplex, and the simplices around a vertex.

In the book a reader turns the picture and takes it apart. A plain notebook, a page without scripts and
a sheet of paper show a drawing in its place. The numbers stand below it as text in all of them.

>>> from coxeter.scenes import scene
>>> scene("B~3").delaunay
False
"""

from .scene import Apex, Scene, scene
from .solids import Solid, solid
from .stars import Alcove, Mirror, Star, Step, star

__all__ = ["Alcove", "Apex", "Mirror", "Scene", "Solid", "Star", "Step", "scene", "solid", "star"]
