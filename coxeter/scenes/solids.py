"""The solid that the simplices around a vertex fill: its faces, found exactly, and its name."""

from __future__ import annotations

from collections import Counter, defaultdict
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations

from ..affine import Vector
from .stars import Star, inner

_PLURAL = {"square": "squares", "rectangle": "rectangles", "rhombus": "rhombi", "triangle": "triangles"}


@dataclass(frozen=True)
class Solid:
    """A convex solid in space.

    Attributes
    ----------
    faces
        The corners of each face, in no order.
    """

    faces: tuple[frozenset[Vector], ...]

    @property
    def kinds(self) -> Counter[str]:
        """How many faces there are of each kind."""
        return Counter(map(_kind, self.faces))

    @property
    def name(self) -> str:
        """Its name, or its faces: "a cube", "a solid with 8 faces, all triangles"."""
        kinds = self.kinds
        if kinds == {"square": 6}:
            return "a cube"
        if kinds == {"rhombus": 12} and all(_is_of_rhombic_dodecahedron(face) for face in self.faces):
            return "a rhombic dodecahedron"
        if len(kinds) == 1:
            (kind,) = kinds
            return f"a solid with {len(self.faces)} faces, all {_PLURAL.get(kind, 'alike')}"
        listed = [f"{count} {_PLURAL.get(kind, 'other')}" for kind, count in sorted(kinds.items())]
        return f"a solid with {len(self.faces)} faces, {' and '.join(listed)}"


def solid(star: Star) -> Solid:
    """The solid that the simplices around a vertex fill.

    It is convex, as each of its faces lies in a mirror: the simplices around a vertex are those on
    their side of all mirrors that miss the vertex. So a point of its boundary is a corner if three
    faces meet there.

    >>> from coxeter.affine import triangulation
    >>> from coxeter.scenes.stars import star
    >>> solid(star(triangulation("C~3"), 0)).name
    'a cube'
    """
    planes = defaultdict(set)
    for alcove in star.alcoves:
        outer = [vertex for k, vertex in enumerate(alcove.vertices) if k != star.label]
        planes[alcove.walls[star.label]].update(outer)
    count = Counter(point for points in planes.values() for point in points)
    return Solid(tuple(frozenset(p for p in points if count[p] >= 3) for points in planes.values()))


def _square(p: Vector, q: Vector) -> Fraction:
    difference = tuple(x - y for x, y in zip(p, q, strict=True))
    return inner(difference, difference)


def _lengths(face: frozenset[Vector]) -> list[Fraction]:
    """The squared distances of its corners, in order."""
    return sorted(_square(p, q) for p, q in combinations(face, 2))


def _kind(face: frozenset[Vector]) -> str:
    if len(face) == 3:
        return "triangle"
    counts = sorted(Counter(_lengths(face)).values()) if len(face) == 4 else []
    return {(2, 4): "square", (1, 1, 4): "rhombus", (2, 2, 2): "rectangle"}.get(tuple(counts), "other")


def _is_of_rhombic_dodecahedron(face: frozenset[Vector]) -> bool:
    """Whether a rhombus has diagonals that are as 1 to √2."""
    counts = Counter(_lengths(face))
    short, long = sorted(length for length, count in counts.items() if count == 1)
    return long == 2 * short
