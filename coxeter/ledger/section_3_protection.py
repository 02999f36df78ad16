"""Section 3: protection."""

from __future__ import annotations

from functools import lru_cache
from itertools import islice

from ..affine import triangulation
from ..delaunay import protection, vertices_by_distance
from ..exact import Surd, sqrt
from ..families import evaluate
from ..names import triangulations_up_to
from .claim import Constants, Finding, agree, claim, corrected, holds
from .section_4_patches import powers_in_patch
from .section_4_planes import flattening_rows, least_powers
from .vocabulary import EVERY_D, FINITE, INSTANCES, Weight

DELAUNAY = ("A~2", "C~2", "G~2", "A~3", "C~3", "A~4", "C~4", "F~4")
"""The Coxeter triangulations of dimension up to 4 whose spheres are empty."""


@lru_cache(maxsize=16)
def _distances(name: str) -> tuple[Surd, Surd, Surd]:
    """The least distance of another vertex from the ball, by two enumerations, and the circumradius."""
    t = triangulation(name)
    square = t.simplex.squared_circumradius
    (*_, (nearest, _)) = islice(vertices_by_distance(t), t.dimension + 2)
    return sqrt(square + powers_in_patch(name)[0]) - sqrt(square), sqrt(nearest) - sqrt(square), sqrt(square)


@claim("sec3.some-delaunay", "Section 3, before Definition 19", Weight.WORDING)
def some_are_delaunay(printed: Constants) -> Finding:
    """{all?All|Some, but not all,} Coxeter triangulations are Delaunay."""
    empty = [k.affine for k in triangulations_up_to(4) if powers_in_patch(k.affine)[0] >= 0]
    others = [k.affine for k in triangulations_up_to(4) if powers_in_patch(k.affine)[0] < 0]
    lines = f"Up to dimension 4, from patches: {', '.join(empty)} are Delaunay, {', '.join(others)} are not."
    if tuple(empty) != DELAUNAY:
        return corrected(FINITE, f"Delaunay are {', '.join(empty)}")
    return agree(printed, {"all": not others}, FINITE, lines)


@claim("def-19", "Section 3, Definition 19", Weight.RESULT)
def distance(printed: Constants) -> Finding:
    """The protection of a simplex is the infimum of the distances of other vertices from its ball.

    The infimum {attained?is attained, so that it may be called a|need not be attained, so that it is no}
    minimum.
    """
    agree_twice = all(first == second for first, second, _ in map(_distances, DELAUNAY))
    library = all(protection(triangulation(n)).absolute == _distances(n)[0] for n in DELAUNAY)
    return agree(
        printed,
        {"attained": agree_twice and library},
        EVERY_D,
        "A definition. The vertices of a triangulation of space are locally finite, so finitely many lie "
        "closer to the ball than a given one, and the least distance is attained. (Only if the simplex has "
        "all the vertices, as a finite set may, the infimum is over nothing.)",
        "In a Delaunay triangulation no vertex lies inside the ball: $\\delta=\\min|p-c|-R$. For "
        f"{', '.join(DELAUNAY)} two enumerations of vertices agree on it with the library.",
    )


@claim("def-19.protected", "Section 3, Definition 19", Weight.RESULT, to_state=["def-19"])
def protected(printed: Constants) -> Finding:
    """The protection of a triangulation is the infimum over its simplices.

    A protected triangulation is one whose protection is greater than {bound}.
    """
    values = {name: _distances(name)[0] for name in DELAUNAY}
    each_positive = [least_powers(flattening_rows(n), 3) for n in (1, 5, 9)]
    falling = each_positive == sorted(each_positive, reverse=True) and min(each_positive) > 0
    bounds = {0 if value == 0 else 1 for value in values.values() if value >= 0}
    if bounds != {0, 1} or not falling:
        return corrected(INSTANCES, "the examples do not tell protected and unprotected triangulations apart")
    return agree(
        printed,
        {"bound": min(values.values())},
        EVERY_D,
        "A definition; the least value 0 is taken: "
        + ", ".join(f"{n}: {x}" for n, x in values.items())
        + ".",
        "The infimum over the simplices need not be attained: see the rows of triangles at Lemma 6. In a "
        "Coxeter triangulation symmetries carry each simplex to each other, and one is enough.",
    )


@claim("def-19.relative", "Section 3, Definition 19", Weight.RESULT, to_state=["def-19.protected"])
def relative(printed: Constants) -> Finding:
    """The relative protection is the protection over the circumradius: {formula}."""
    for name in DELAUNAY:
        delta, _, radius = _distances(name)
        value = evaluate(printed["formula"], delta=delta, R=radius)
        library = protection(triangulation(name)).relative
        if value != library:
            return corrected(INSTANCES, f"for {name} the formula gives {value}, the ratio is {library}")
    return holds(
        EVERY_D,
        "A definition: $R>0$, and similar triangulations have the same value.",
        "For a triangulation it is the infimum of the ratios, which is the ratio of the infimum where all "
        "circumradii agree.",
    )
