"""Section 6, item 8 of each family: where the circumcentre lies, and what it says about Delaunay."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache, partial

from ..affine import CoxeterTriangulation, triangulation
from ..claims.core import affine_name, dimensions
from ..claims.points import SIGN
from ..delaunay import delaunay_verdict, protection
from ..errors import InvalidInput
from ..exact import rational, show
from ..families import evaluate
from ..names import FAMILIES, MINIMAL_DIMENSION
from ..paper import prose
from .claim import Constants, Finding, agree, claim, corrected, holds
from .records import strength_for
from .vectors import inner
from .vocabulary import Weight

LARGEST = 12


def members(family: str) -> list[CoxeterTriangulation]:
    """The members of a family that are computed."""
    return [triangulation((family[0], d)) for d in dimensions(family) if d <= LARGEST]


def _place(family: str) -> str:
    return f"Section 6, {affine_name(family)}, item 8"


def _proof(family: str) -> tuple[str, ...]:
    return ("position_of_circumcentre", family) if family in MINIMAL_DIMENSION else ()


# -- the verdict ------------------------------------------------------------------------------------------


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


def judge_position(family: str, printed: Constants) -> Finding:
    """Whether the circumcentre lies where it is printed, and what follows."""
    words = "The levels of the circumcentre decide it, by Theorem 7"
    return agree(printed, _truth(family), strength_for(family), words)


for _family in FAMILIES:
    _centre = () if _family == "G2" else (f"sec6.{_family}.item-{3 if _family == 'E8' else 4}",)
    claim(
        f"sec6.{_family}.item-8.delaunay",
        _place(_family),
        Weight.RESULT,
        words=f"The circumcentre of {affine_name(_family)} lies: {{position}}; so the triangulation is "
        "Delaunay: {delaunay}, with non-zero protection: {protected}.",
        to_state=("def-19", "def-20"),
        to_prove=("thm-7", *_centre),
        proof=_proof(_family),
    )(partial(judge_position, _family))


# -- a hyperplane between the circumcentre and the simplex ------------------------------------------------


def judge_separation(family: str, printed: Constants) -> Finding:
    """Whether the printed hyperplane has the circumcentre on one side and the simplex on the other."""
    for t in members(family):
        of_centre, of_vertices = _levels(t, family, printed)
        if of_centre >= 0 or min(of_vertices) < 0:
            return _not_separating(family, t, of_centre)
    return holds(strength_for(family))


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
        strength_for(family),
        f"the wall of $\\tau_{k}$, with normal {show(t.facets[k].normal)}, separates them",
        witness=f"the circumcentre has x_2 = {of_centre}, and no vertex has a negative one",
        evidence="item 3 has the circumcentre with the wrong sign, and this argument uses it",
        constants={"facet": str(k)},
    )


for _family in ("B", "D", "E6", "E7", "E8"):
    _id = f"sec6.{_family}.item-8.separates"
    _wall = "The wall of facet {facet}" if "facet" in prose()[_id] else "The hyperplane {hyperplane}"
    claim(
        _id,
        _place(_family),
        Weight.PROOF,
        words=f"{_wall} separates the circumcentre of {affine_name(_family)} from its simplex.",
        to_prove=(f"sec6.{_family}.item-2",),
        proof=_proof(_family),
    )(partial(judge_separation, _family))


# -- C~ and F~4: the inner products with all normals ------------------------------------------------------


def judge_products(family: str, printed: Constants) -> Finding:
    """Whether no normal has a negative product with c, and all have positive ones with opposite vertices."""
    if printed["all"] is not True:
        if printed["all"] == "all but that of node 0":
            return holds(strength_for(family))
        return corrected(strength_for(family), "for all facets but that of node 0")
    t = members(family)[0]
    if inner(t.facets[0].normal, t.simplex.vertex_matrix.row(0)) > 0:
        return holds(strength_for(family))
    return corrected(
        strength_for(family),
        "for facet 0, whose hyperplane does not pass through 0, the level 1 - <x, highest root> takes the "
        "place of the inner product; all levels of opposite vertices are positive, those of c are positive "
        "or zero, and some are zero: c lies on the boundary",
        witness="u_0 = 0 has inner product 0 with every normal",
        constants={"all": "all but that of node 0"},
    )


for _family in ("C", "F4"):
    claim(
        f"sec6.{_family}.item-8.products",
        _place(_family),
        Weight.PROOF,
        words=f"In {affine_name(_family)}, every normal has a positive inner product with the vertex "
        "opposite, a positive one or zero with the circumcentre, which therefore lies on the boundary: "
        "{all}.",
        to_prove=(f"sec6.{_family}.item-2",),
    )(partial(judge_products, _family))
