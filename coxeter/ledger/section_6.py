"""Section 6: the nine items of each family. Formulas, points and facets come from the paper's data."""

from __future__ import annotations

from ..affine import triangulation
from ..errors import InvalidInput
from ..exact import sqrt
from ..names import MINIMAL_DIMENSION
from . import section_6_delaunay, section_6_lattices, section_6_values
from .claim import Constants, Finding, agree, claim, corrected, damaged, decide, holds
from .record_points import completeness_claims, point_claims
from .record_statements import statement_claims
from .records import formula_claims
from .vocabulary import EVERY_D, FINITE, Weight

__all__ = ["section_6_delaunay", "section_6_lattices", "section_6_values"]

formula_claims(lambda f: f.place.startswith("Section 6"))
point_claims(lambda p: p.place.startswith("Section 6"))
statement_claims(lambda s: s.place.startswith("Section 6"))
for _name in ("A~", "B~", "C~", "D~", "E~6", "E~7", "E~8", "F~4"):
    completeness_claims(f"Section 6, {_name}, item 2")

FIGURES = {"A": 4, "B": 5, "C": 6, "D": 7, "E6": 8, "E7": 9, "E8": 10, "F4": 11}
"""The figures with the diagrams of the families, as their captions number them."""


def _figure(family: str, item: int) -> None:
    @claim(
        f"sec6.{family}.item-{item}.figure",
        f"Section 6, {family[0]}~{family[1:]}, item {item}",
        Weight.WORDING,
    )
    def check(printed: Constants) -> Finding:
        """The labels that tell the least height are those of Figure {figure}."""
        return agree(
            printed, {"figure": FIGURES[family]}, FINITE, evidence="its caption names the other family"
        )


for _family in FIGURES:
    _figure(_family, 4 if _family == "E8" else 3)


def _picture(family: str) -> None:
    d = int(family[1:] or 6)
    where = "is" if family[1:] else "for d = 6 is"
    low = MINIMAL_DIMENSION.get(family, 0)

    @claim(f"fig-{FIGURES[family]}", f"Figure {FIGURES[family]}", Weight.RESULT, to_prove=(f"sec6.{family}.item-3",))
    def check(printed: Constants) -> Finding:
        """The diagram's labels are proportional to the inverse heights."""
        squares = triangulation((family[0], d)).simplex.squared_heights
        labels = [sqrt(squares[0] / x) for x in squares]
        roots = triangulation((family[0], d)).facets
        marks = triangulation((family[0], d)).marks
        lengths = [sqrt(sum(x * x for x in facet.normal)) for facet in roots]
        if any(x != m * s / lengths[0] for x, m, s in zip(labels, marks, lengths, strict=True)):
            raise InvalidInput("marks times lengths of roots are not the inverse heights")
        return damaged(
            EVERY_D if low else FINITE,
            f"the list of labels, from node 0 on, {where} {', '.join(map(str, labels))}: mark times length of the root",
            "our copy has the caption and not the picture",
        )  # fmt: skip


for _family in FIGURES:
    _picture(_family)


@claim("sec6.E6.item-9.number", "Section 6, E~6, item 9", Weight.WORDING)
def e6_number(printed: Constants) -> Finding:
    """The item about the lattice has the number {number}."""
    return agree(
        printed,
        {"number": 9},
        FINITE,
        evidence="the item before it is number 8 as well, and the plan has nine",
    )


@claim("sec6.E8.order", "Section 6, E~8", Weight.WORDING)
def e8_order(printed: Constants) -> Finding:
    """The centres and radii are item {radii}, the least height is item {height}."""
    return agree(
        printed, {"radii": 4, "height": 3}, FINITE, evidence="the plan and all other families have them so"
    )


@claim("sec6.G2.item-8.hypotenuse", "Section 6, G~2", Weight.WORDING)
def hypotenuse(printed: Constants) -> Finding:
    """The circumcentre of {which} lies on its hypotenuse."""
    from ..delaunay import circumcentre_position
    from ..simplex import Position, Simplex, regular_simplex

    right = Simplex([(0, 0), (1, 0), (0, 1)])
    if circumcentre_position(right) is not Position.BOUNDARY:
        return corrected(EVERY_D, "no triangle has its circumcentre there")
    if printed["which"] == "any right triangle":
        return holds(EVERY_D, "Thales: the hypotenuse of a right triangle is a diameter of its circumcircle")
    inside = circumcentre_position(regular_simplex(2)) is Position.INSIDE
    return decide(not inside, EVERY_D, "printed any triangle; true: any right triangle, such as this one",
                  witness="the regular triangle has its circumcentre inside",
                  constants={"which": "any right triangle"})  # fmt: skip
