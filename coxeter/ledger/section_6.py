"""Section 6: the nine items of each family. Formulas, points and facets come from the paper's data."""

from __future__ import annotations

from functools import partial

from ..affine import triangulation
from ..claims.core import affine_name, triangulation_of
from ..claims.points import SIGN, exact_point
from ..delaunay import circumcentre_position
from ..errors import InvalidInput
from ..exact import sqrt
from ..names import FAMILIES, MINIMAL_DIMENSION
from ..paper import printed as paper
from ..simplex import Position, Simplex, regular_simplex
from . import section_6_delaunay, section_6_lattices, section_6_values
from .claim import Constants, Finding, agree, claim, corrected, damaged, decide, holds
from .record_formulas import formula_claims
from .record_points import completeness_claims, point_claims
from .record_statements import statement_claims
from .vectors import inner, rational_point
from .vocabulary import EVERY_D, FINITE, Weight

__all__ = ["section_6_delaunay", "section_6_lattices", "section_6_values"]

FIGURES = {family: number for number, family in enumerate(FAMILIES[:-1], 4)}
"""The figures with the diagrams of the families, as their captions number them; G~2 has none."""

formula_claims(lambda f: f.place.startswith("Section 6"))
point_claims(lambda p: p.place.startswith("Section 6"))
statement_claims(lambda s: s.place.startswith("Section 6"))
for _family in FIGURES:
    completeness_claims(f"Section 6, {affine_name(_family)}, item 2")


# -- the figures ------------------------------------------------------------------------------------------


def judge_figure(family: str, printed: Constants) -> Finding:
    """Whether the figure that is referred to is that of the family."""
    evidence = "its caption names the other family"
    return agree(printed, {"figure": FIGURES[family]}, FINITE, evidence=evidence)


for _family in FIGURES:
    _item = 4 if _family == "E8" else 3
    claim(
        f"sec6.{_family}.item-{_item}.figure",
        f"Section 6, {affine_name(_family)}, item {_item}",
        Weight.WORDING,
        words="The labels that tell the least height are those of Figure {figure}.",
    )(partial(judge_figure, _family))


def judge_picture(family: str, _: Constants) -> Finding:
    """What the labels are that our copy does not show: marks times lengths of roots, as inverse heights."""
    d = int(family[1:] or 6)
    t = triangulation((family[0], d))
    squares = t.simplex.squared_heights
    labels = [sqrt(squares[0] / x) for x in squares]
    lengths = [sqrt(sum(x * x for x in facet.normal)) for facet in t.facets]
    if any(x != m * s / lengths[0] for x, m, s in zip(labels, t.marks, lengths, strict=True)):
        raise InvalidInput("marks times lengths of roots are not the inverse heights")
    where = "is" if family[1:] else f"for d = {d} is"
    return damaged(
        EVERY_D if family in MINIMAL_DIMENSION else FINITE,
        f"the list of labels, from node 0 on, {where} {', '.join(map(str, labels))}: "
        "mark times length of the root",
        "our copy has the caption and not the picture",
    )


for _family, _number in FIGURES.items():
    claim(
        f"fig-{_number}",
        f"Figure {_number}",
        Weight.RESULT,
        words="The diagram's labels are proportional to the inverse heights.",
        to_prove=(f"sec6.{_family}.item-3",),
    )(partial(judge_picture, _family))


# -- numbers of items, and G~2 ----------------------------------------------------------------------------


@claim("sec6.E6.item-9.number", "Section 6, E~6, item 9", Weight.WORDING)
def e6_number(printed: Constants) -> Finding:
    """The item about the lattice has the number {number}."""
    evidence = "the item before it is number 8 as well, and the plan has nine"
    return agree(printed, {"number": 9}, FINITE, evidence=evidence)


@claim("sec6.E8.order", "Section 6, E~8", Weight.WORDING)
def e8_order(printed: Constants) -> Finding:
    """The centres and radii are item {radii}, the least height is item {height}."""
    evidence = "the plan and all other families have them so"
    return agree(printed, {"radii": 4, "height": 3}, FINITE, evidence=evidence)


@claim("sec6.G2.item-8.hypotenuse", "Section 6, G~2", Weight.WORDING)
def hypotenuse(printed: Constants) -> Finding:
    """The circumcentre of {which} lies on its hypotenuse."""
    right = Simplex([(0, 0), (1, 0), (0, 1)])
    if circumcentre_position(right) is not Position.BOUNDARY:
        return corrected(EVERY_D, "no triangle has its circumcentre there")
    if printed["which"] == "any right triangle":
        return holds(EVERY_D, "Thales: the hypotenuse of a right triangle is a diameter of its circumcircle")
    return decide(
        circumcentre_position(regular_simplex(2)) is not Position.INSIDE,
        EVERY_D,
        f"printed {printed['which']}; true: any right triangle, such as this one",
        witness="the regular triangle has its circumcentre inside",
        constants={"which": "any right triangle"},
    )


@claim("sec6.plan.roots", "Section 6, plan, item 1", Weight.WORDING, to_state=("thm-3", "def-16"))
def from_theorem_3(printed: Constants) -> Finding:
    """The simplices of {families} are the fundamental simplices of the simple roots of Theorem 3."""
    true = tuple(affine_name(x) for x in FAMILIES if SIGN.get(x, 1) == 1 and x != "G2")
    u = rational_point(exact_point("E7", "vertex", 7, 1))
    product = inner(u, triangulation_of("E7", 7).roots.simple_roots.row(0))
    return agree(
        printed, {"families": true}, FINITE,
        "For A~ and E~7 the printed vertices are the negatives of those of the roots, so the simplex is the "
        "mirror image in the origin; for G~2 it is a similar triangle in the plane.",
        witness=f"for E~7 the printed u_1 has the inner product {product} with the simple root s_1",
        evidence="the printed facets and vertices of each family agree with each other; no length, angle or "
        "measure depends on it",
    )  # fmt: skip


@claim("sec6.same-plan", "Section 6", Weight.WORDING)
def same_plan(printed: Constants) -> Finding:
    """The cases that follow the plan of nine items are {families}."""
    places = {s.place for s in paper().statements if ", item 3" in s.place or ", item 4" in s.place}
    names = map(affine_name, FAMILIES)
    found = tuple(x for x in names if any(p.startswith(f"Section 6, {x},") for p in places))
    return agree(
        printed, {"families": found}, FINITE,
        "The case of G~2 has no items and no figure of its own; of a diagram, our copy shows a trace in the "
        "heading.",
    )  # fmt: skip


def judge_figure_of_proposition(family: str, printed: Constants) -> Finding:
    """Whether the figure beside a proposition is that of its family."""
    evidence = (
        "it is the figure of the next family; whether the reference or its place is at fault cannot be told"
    )
    return agree(printed, {"figure": FIGURES[family]}, FINITE, evidence=evidence)


for _number, _family in ((11, "E6"), (12, "E7")):
    claim(
        f"prop-{_number}.figure",
        f"Section 6, Proposition {_number}",
        Weight.WORDING,
        words="The figure that belongs to the proposition is Figure {figure}.",
    )(partial(judge_figure_of_proposition, _family))
