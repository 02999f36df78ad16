"""Section 6, item 8 of each family: where the circumcentre lies, and what it says about Delaunay."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from ..affine import CoxeterTriangulation, triangulation
from ..claims.core import dimensions
from ..claims.points import SIGN
from ..delaunay import delaunay_verdict, protection
from ..errors import InvalidInput
from ..exact import rational, show
from ..families import evaluate
from ..names import FAMILIES, MINIMAL_DIMENSION
from ..paper import prose
from .claim import Claim, Constants, Finding, agree, corrected, holds, register
from .vocabulary import EVERY_D, FINITE, Strength, Weight

LARGEST = 12


def strength(family: str) -> Strength:
    """For every d by proof, or by one computation."""
    return EVERY_D if family in MINIMAL_DIMENSION else FINITE


def members(family: str) -> list[CoxeterTriangulation]:
    """The members of a family that are computed."""
    return [triangulation((family[0], d)) for d in dimensions(family) if d <= LARGEST]


def name(family: str) -> str:
    """A~, E~6, …"""
    return f"{family[0]}~{family[1:]}"


@lru_cache(maxsize=16)
def _truth(family: str) -> dict[str, object]:
    verdicts = {
        (v.position.value, v.delaunay, protection(t).relative > 0)
        for t in members(family)
        for v in (delaunay_verdict(t),)
    }
    if len(verdicts) != 1:
        raise InvalidInput(f"the members of {family} differ: {verdicts}")
    position, is_delaunay, protected = verdicts.pop()
    return {"position": position, "delaunay": is_delaunay, "protected": protected}


def _delaunay(family: str) -> None:
    id = f"sec6.{family}.item-8.delaunay"

    def check(printed: Constants) -> Finding:
        finding = agree(printed, _truth(family), strength(family))
        if not finding.verdict.accepts:
            return finding
        proof = ("position_of_circumcentre", family) if family in MINIMAL_DIMENSION else ()
        return holds(strength(family), "The levels of the circumcentre decide it, by Theorem 7", proof=proof)

    centre = () if family == "G2" else (f"sec6.{family}.item-{3 if family == 'E8' else 4}",)
    words = (
        f"The circumcentre of {name(family)} lies: {{position}}; so the triangulation is Delaunay: {{delaunay}}, with "
        "non-zero protection: {protected}."
    )
    register(Claim(id, f"Section 6, {name(family)}, item 8", words, Weight.RESULT, check, prose()[id], ("def-19", "def-20"),
                   ("thm-7", *centre), f"{__name__}._delaunay"))  # fmt: skip


def _separates(family: str) -> None:
    """A hyperplane through the origin between the circumcentre and the simplex."""
    id = f"sec6.{family}.item-8.separates"

    def check(printed: Constants) -> Finding:
        for t in members(family):
            of_centre, of_vertices = _levels(t, family, printed)
            if of_centre >= 0 or min(of_vertices) < 0:
                return _not_separating(family, t, of_centre)
        proof = ("position_of_circumcentre", family) if family in MINIMAL_DIMENSION else ()
        return holds(strength(family), proof=proof)

    wall = "The wall of facet {facet}" if "facet" in prose()[id] else "The hyperplane {hyperplane}"
    words = f"{wall} separates the circumcentre of {name(family)} from its simplex."
    register(Claim(id, f"Section 6, {name(family)}, item 8", words, Weight.PROOF, check, prose()[id], (),
                   (f"sec6.{family}.item-2",), f"{__name__}._separates"))  # fmt: skip


def _levels(t: CoxeterTriangulation, family: str, printed: Constants) -> tuple[Fraction, list[Fraction]]:
    """The levels of the circumcentre and of the vertices on a wall, or on x_k = 0."""
    centre, *vertices = [t.simplex.circumcentre, *t.simplex.vertex_matrix.rows()]
    points = [tuple(map(rational, x)) for x in (centre, *vertices)]
    if "facet" in printed:
        number = int(evaluate(printed["facet"], d=t.dimension).as_fraction())
        if not 0 <= number <= t.dimension:
            raise InvalidInput(f"{t.name} has no facet {number}: give 0 to {t.dimension}")
        levels = [t.facets[number].level(x) for x in points]
    else:
        k = int(printed["hyperplane"].removeprefix("x_").partition(" ")[0])
        levels = [SIGN.get(family, 1) * x[k - 1] for x in points]
    return levels[0], levels[1:]


def _not_separating(family: str, t: CoxeterTriangulation, of_centre: Fraction) -> Finding:
    """Which wall does separate, instead."""
    coordinates = t.simplex.circumcentre_coordinates
    k = min(range(t.dimension + 1), key=lambda k: coordinates[k])
    return corrected(
        strength(family), f"the wall of $\tau_{k}$, with normal {show(t.facets[k].normal)}, separates them",
        witness=f"the circumcentre has x_2 = {of_centre}, and no vertex has a negative one",
        evidence="item 3 has the circumcentre with the wrong sign, and this argument uses it",
        constants={"facet": str(k)},
    )  # fmt: skip


def _products_with_roots(family: str) -> None:
    """C~ and F~4: the inner products with all normals, of the vertices opposite and of the circumcentre."""
    id = f"sec6.{family}.item-8.products"

    def check(printed: Constants) -> Finding:
        if printed["all"] is not True:
            return holds(strength(family)) if printed["all"] == "all but that of node 0" else corrected(
                strength(family), "for all facets but that of node 0")  # fmt: skip
        t = members(family)[0]
        origin = t.simplex.vertex_matrix.row(0)
        if sum(a * b for a, b in zip(t.facets[0].normal, origin, strict=True)) > 0:
            return holds(strength(family))
        return corrected(
            strength(family), "for facet 0, whose hyperplane does not pass through 0, the level 1 - <x, highest root> "
            "takes the place of the inner product; all levels of opposite vertices are positive, those of c are positive or "
            "zero, and some are zero: c lies on the boundary",
            witness="u_0 = 0 has inner product 0 with every normal", constants={"all": "all but that of node 0"},
        )  # fmt: skip

    words = (
        f"In {name(family)}, every normal has a positive inner product with the vertex opposite, a positive one or zero with "
        "the circumcentre, which therefore lies on the boundary: {all}."
    )
    register(Claim(id, f"Section 6, {name(family)}, item 8", words, Weight.PROOF, check, prose()[id], (),
                   (f"sec6.{family}.item-2",), f"{__name__}._products_with_roots"))  # fmt: skip


for _family in FAMILIES:
    _delaunay(_family)
for _family in ("B", "D", "E6", "E7", "E8"):
    _separates(_family)
for _family in ("C", "F4"):
    _products_with_roots(_family)
