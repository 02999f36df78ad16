"""Appendix B, second part: the proof of Lemma 5, which is complete."""

from __future__ import annotations

from ..simplex import Position, Simplex, position
from .appendix_b_steps import on_the_boundary, step, step_with
from .claim import BrokenTool, Constants, Finding, claim
from .section_4_geometry import Pair
from .vocabulary import Weight

PLACE = "Appendix B, proof of Lemma 5"


@claim("lem-5.o-is-c", PLACE, Weight.PROOF, to_state=["lem-4.line"])
def o_is_c(printed: Constants) -> Finding:
    """If c is on the boundary of σ, it is the circumcentre o of a facet."""
    kinds = {_place_in_facet(pair) for pair in on_the_boundary()}
    if kinds != {Position.INSIDE, Position.BOUNDARY}:
        raise BrokenTool("the circumcentre on a smaller face was not tried")
    return step(
        on_the_boundary,
        lambda pair: pair.middle.centre == pair.sphere.centre and pair.levels[0] == 0,
        "Choose a facet that contains $c$: a point of the boundary is on one. In its hyperplane the point "
        "with the same distance from all its vertices is its circumcentre; it does not matter whether $c$ is "
        "inside the facet or on a smaller face.",
        "(The facet of the proof of Lemma 4 separates $c$ from $\\sigma$; here only in the weak sense.)",
    )


def _place_in_facet(pair: Pair) -> Position:
    return position(Simplex(pair.facet).barycentric(pair.sphere.centre))


def _different_centres() -> tuple[Pair, ...]:
    return tuple(pair for pair in on_the_boundary() if pair.sphere.centre != pair.other_sphere.centre)


def _same_centre() -> tuple[Pair, ...]:
    return tuple(pair for pair in on_the_boundary() if pair.sphere.centre == pair.other_sphere.centre)


@claim("lem-5.larger-radius", PLACE, Weight.PROOF, to_prove=["lem-5.o-is-c", "lem-4.line"])
def larger_radius(printed: Constants) -> Finding:
    """If c and c' differ, R' is greater than R, against the choice of R."""
    return step(
        _different_centres,
        lambda pair: pair.other_sphere.square > pair.sphere.square,
        r"$R=\varrho$ as $c=o$, and $R'^2=\varrho^2+|c'-o|^2$. The Delaunay property is not needed.",
    )


@claim("lem-5.same-ball", PLACE, Weight.PROOF, to_prove=["lem-5.larger-radius"])
def same_ball(printed: Constants) -> Finding:
    """So c and c' coincide, and σ and σ' have the same circumscribed ball."""
    return step(
        _same_centre,
        lambda pair: pair.sphere.square == pair.other_sphere.square and pair.share_sphere,
        "The radius is the distance from the common centre to a common vertex.",
    )


@claim("lem-5.protection-zero", PLACE, Weight.PROOF, to_state=["def-19"], to_prove=["lem-5.same-ball"])
def protection_zero(printed: Constants) -> Finding:
    """The vertex of σ' outside τ is on the ball of σ, so the protection of σ is {protection}."""
    return step_with(
        printed,
        "protection",
        _same_centre,
        _distance_from_ball,
        "It is on the common sphere, and it is no vertex of $\\sigma$, as it lies strictly beyond $\\tau$. "
        "The infimum of the distances is 0, so the triangulation is not protected.",
    )


def _distance_from_ball(pair: Pair) -> int:
    """0 if the other apex is a new vertex on the sphere."""
    new = pair.other not in {*pair.facet, pair.apex} and pair.level(pair.other) > 0
    return 0 if new and pair.sphere.power(pair.other) == 0 else 1
