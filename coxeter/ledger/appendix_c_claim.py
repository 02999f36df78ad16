"""Appendix C, the Claim and Remark 5: the vertices that are second closest to the circumcentre."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import takewhile

from ..affine import CoxeterTriangulation, triangulation
from ..delaunay import protection, vertices_by_distance
from ..families import evaluate
from .appendix_c_vertices import LARGEST
from .claim import Constants, Finding, claim, corrected, holds
from .instances import of_type
from .vectors import Point
from .vocabulary import EVERY_D, Weight


def vertices_within(t: CoxeterTriangulation, bound: Fraction) -> list[tuple[Fraction, Point]]:
    """The vertices up to a squared distance from c, with these distances."""
    return list(takewhile(lambda found: found[0] <= bound, vertices_by_distance(t)))


@lru_cache(maxsize=8)
def second_closest(d: int) -> tuple[Fraction, int]:
    """The second smallest squared distance of a vertex of A~_d from c, and how many vertices have it."""
    t = triangulation(("A", d))
    nearest = protection(t).nearest[0].squared_distance
    return nearest, sum(square == nearest for square, _ in vertices_within(t, nearest))


@claim(
    "claim-c",
    "Appendix C, Claim",
    Weight.RESULT,
    to_prove=("lem-13", "thm-7", "claim-c.gap", "claim-c.closest"),
    proof=("second_closest",),
)
def claim_c(printed: Constants) -> Finding:
    """In each remainder class {count} vertex is second closest to c, at the squared distance {distance}."""
    for d in range(2, LARGEST + 1):
        square, count = second_closest(d)
        if square != evaluate(printed["distance"], d=d) or count != evaluate(printed["count"]) * (d + 1):
            words = f"for d = {d} there are {count} vertices at the squared distance {square}"
            return corrected(EVERY_D, words)
    return holds(EVERY_D)


@claim(
    "claim-c.closest",
    "Appendix C, Claim",
    Weight.RESULT,
    to_prove=("thm-7",),
    proof=("second_closest",),
)
def closest(printed: Constants) -> Finding:
    """In each remainder class the vertex closest to c is {points}, and no other."""
    if printed["points"] != "u_k":
        return corrected(EVERY_D, f"printed {printed['points']}; true: u_k")
    for t in of_type("A", LARGEST):
        near = [x for _, x in vertices_within(t, t.simplex.squared_circumradius)]
        if sorted(near) != sorted(t.simplex.vertex_matrix.rows()):
            return corrected(EVERY_D, f"for d = {t.dimension} other vertices are as close")
    return holds(EVERY_D)


@claim(
    "claim-c.gap",
    "Appendix C, proof of the Claim",
    Weight.PROOF,
    to_prove=("lem-13",),
    proof=("second_closest",),
)
def gap(printed: Constants) -> Finding:
    """The least positive difference of squared distances is {gap}."""
    for t in of_type("A", LARGEST):
        found = second_closest(t.dimension)[0] - t.simplex.squared_circumradius
        if found != evaluate(printed["gap"], d=t.dimension):
            return corrected(EVERY_D, f"printed {printed['gap']}; true: 2/(d + 1)")
    return holds(EVERY_D, "Lemma 13 says that it is no less, the points of the Claim that it is attained")


@claim("rem-5", "Appendix C, Remark 5", Weight.RESULT, to_state=("claim-c",), proof=("second_closest",))
def remark_5(printed: Constants) -> Finding:
    """There are no other second closest points than the {points} of the Claim."""
    for d in range(2, LARGEST + 1):
        if second_closest(d)[1] != evaluate(printed["points"], d=d):
            return corrected(EVERY_D, f"for d = {d} there are {second_closest(d)[1]}")
    return holds(EVERY_D, "The paper leaves it out; the proof finds the distances of all vertices")
