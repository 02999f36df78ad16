"""The simplices around a vertex of a triangulation, each reached from an earlier one by a reflection."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache

from ..affine import CoxeterTriangulation, Vector
from ..errors import InvalidInput


@dataclass(frozen=True)
class Mirror:
    """A hyperplane <x, root> = k; of the two roots with opposite signs the one that begins positively."""

    root: Vector
    k: Fraction

    def reflect(self, point: Vector) -> Vector:
        """The mirror image of a point."""
        factor = 2 * (inner(point, self.root) - self.k) / inner(self.root, self.root)
        return tuple(x - factor * r for x, r in zip(point, self.root, strict=True))

    def image(self, other: Mirror) -> Mirror:
        """The mirror image of another hyperplane."""
        on_it = tuple(other.k / inner(other.root, other.root) * x for x in other.root)
        return mirror_through(Mirror(self.root, Fraction(0)).reflect(other.root), self.reflect(on_it))


@dataclass(frozen=True)
class Alcove:
    """A simplex of the triangulation.

    Attributes
    ----------
    word
        k_1 … k_n: the simplex is the image of the fundamental one under s_{k_1} … s_{k_n}, the last
        reflection taken first.
    vertices
        The images of u_0 … u_d in this order: vertex k has the label k.
    walls
        The hyperplanes of its facets, wall k opposite to vertex k.
    """

    word: tuple[int, ...]
    vertices: tuple[Vector, ...]
    walls: tuple[Mirror, ...]

    @property
    def parity(self) -> int:
        """0 if an even number of reflections leads here, 1 if an odd number does."""
        return len(self.word) % 2

    def neighbour(self, facet: int) -> Alcove:
        """The simplex beyond a facet, the mirror image of this one."""
        mirror = self.walls[facet]
        return Alcove(
            (*self.word, facet),
            tuple(map(mirror.reflect, self.vertices)),
            tuple(map(mirror.image, self.walls)),
        )


@dataclass(frozen=True)
class Step:
    """A reflection that adds a simplex to those that are there.

    Attributes
    ----------
    parent
        Which of the earlier simplices is reflected, counted from 0.
    facet
        The facet that it shares with its image; the image's vertex of this label is new to the pair.
    mirror
        The hyperplane of the facet.
    """

    parent: int
    facet: int
    mirror: Mirror


@dataclass(frozen=True)
class Star:
    """The simplices around the vertex u_k of the fundamental simplex, which comes first.

    Step i makes simplex i + 1.

    Attributes
    ----------
    label
        The index k.
    """

    label: int
    alcoves: tuple[Alcove, ...]
    steps: tuple[Step, ...]

    @property
    def centre(self) -> Vector:
        """The vertex that all share."""
        return self.alcoves[0].vertices[self.label]

    @cached_property
    def mirrors(self) -> tuple[Mirror, ...]:
        """The hyperplanes of all steps, each once, in the order of their first use."""
        return tuple(dict.fromkeys(step.mirror for step in self.steps))


@lru_cache(maxsize=32)
def star(triangulation: CoxeterTriangulation, label: int) -> Star:
    """All simplices of a triangulation around the vertex u_label of its fundamental simplex.

    From each, the reflections in its facets at the vertex lead on; simplices that need fewer
    reflections come first.

    >>> from coxeter.affine import triangulation
    >>> around = star(triangulation("C~2"), 1)
    >>> [alcove.word for alcove in around.alcoves]
    [(), (0,), (2,), (0, 2)]
    """
    labels = range(triangulation.dimension + 1)
    if label not in labels:
        raise InvalidInput(f"{label!r} labels no vertex of {triangulation.name}: give 0 to {labels[-1]}")
    alcoves, steps = [fundamental_alcove(triangulation)], list[Step]()
    seen = {frozenset(alcoves[0].vertices)}
    for parent, alcove in enumerate(alcoves):  # the list grows meanwhile, until no new image is found
        for facet in labels:
            image = alcove.neighbour(facet)
            if facet != label and frozenset(image.vertices) not in seen:
                seen.add(frozenset(image.vertices))
                alcoves.append(image)
                steps.append(Step(parent, facet, alcove.walls[facet]))
    return Star(label, tuple(alcoves), tuple(steps))


def fundamental_alcove(triangulation: CoxeterTriangulation) -> Alcove:
    """The fundamental simplex."""
    vertices = triangulation.simplex.vertex_matrix.rows()
    normals = [facet.normal for facet in triangulation.facets]
    walls = [mirror_through(n, vertices[(k + 1) % len(vertices)]) for k, n in enumerate(normals)]
    return Alcove((), vertices, tuple(walls))


def mirror_through(normal: Vector, point: Vector) -> Mirror:
    """The hyperplane with a normal, through a point."""
    sign = 1 if next(x for x in normal if x) > 0 else -1
    root = tuple(sign * x for x in normal)
    return Mirror(root, inner(root, point))


def inner(a: Vector, b: Vector) -> Fraction:
    """The inner product of two vectors."""
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))
