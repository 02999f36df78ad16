"""Section 6, item 8 of each family: where the circumcentre lies, and what it says about Delaunay."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache, partial

from ..affine import CoxeterTriangulation, triangulation
from ..claims.core import affine_name, dimensions
from ..claims.outcomes import Outcome
from ..claims.points import SIGN, compare_points
from ..delaunay import delaunay_verdict, protection
from ..errors import InvalidInput
from ..exact import show
from ..families import evaluate
from ..names import FAMILIES, MINIMAL_DIMENSION
from ..paper import printed as paper
from ..paper import prose
from .claim import Constants, Finding, agree, claim, corrected, holds
from .records import strength_for
from .vectors import inner, rational_point
from .vocabulary import Weight
from .wording import explained

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
        words=f"The circumcentre of the simplex of {affine_name(_family)} lies {{position:where}}; so the "
        "triangulation is {delaunay?|not }Delaunay, and {protected?|not }protected.",
        to_state=("def-19", "def-20"),
        to_prove=("thm-7", *_centre),
        proof=_proof(_family),
    )(partial(judge_position, _family))


# -- a hyperplane between the circumcentre and the simplex ------------------------------------------------


def judge_separation(family: str, printed: Constants) -> Finding:
    """Whether the printed hyperplane has the circumcentre on one side and the simplex on the other."""
    for t in members(family):
        wall, of_centre, of_vertices = _levels(t, family, printed)
        if of_centre >= 0 or min(of_vertices) < 0:
            span = f"those of the vertices go from {min(of_vertices)} to {max(of_vertices)}"
            return _not_separating(family, t, f"for {t.name}, {wall}: the value of c is {of_centre}, {span}")
    return holds(strength_for(family))


def _levels(t: CoxeterTriangulation, family: str, printed: Constants) -> tuple[str, Fraction, list[Fraction]]:
    """What is looked at, a wall or x_k = 0, and the values that c and the vertices have there."""
    centre, *vertices = [t.simplex.circumcentre, *t.simplex.vertex_matrix.rows()]
    points = list(map(rational_point, (centre, *vertices)))
    if "facet" in printed:
        number = int(evaluate(printed["facet"], d=t.dimension).as_fraction())
        if not 0 <= number <= t.dimension:
            raise InvalidInput(f"{t.name} has no facet {number}: give 0 to {t.dimension}")
        wall, levels = f"the level on the wall of facet {number}", [t.facets[number].level(x) for x in points]
    else:
        k = _coordinate(printed["hyperplane"], len(centre))
        wall, levels = f"the coordinate x_{k}", [SIGN.get(family, 1) * x[k - 1] for x in points]
    return wall, levels[0], levels[1:]


def _coordinate(hyperplane: str, last: int) -> int:
    """The k of a hyperplane x_k = 0."""
    match = re.fullmatch(r"x_(\d+) = 0", hyperplane)
    if not match or not 1 <= int(match[1]) <= last:
        raise InvalidInput(f"{hyperplane!r} is no hyperplane: give x_k = 0, with k from 1 to {last}")
    return int(match[1])


def _not_separating(family: str, t: CoxeterTriangulation, witness: str) -> Finding:
    """Which wall does separate, instead; and whether the centre that is printed led to the mistake."""
    coordinates = t.simplex.circumcentre_coordinates
    k = min(range(t.dimension + 1), key=lambda k: coordinates[k])
    centres = compare_points(paper(), lambda p: (p.family, p.name) == (family, "circumcentre"))
    wrong = [c for c in centres if c.outcome is not Outcome.AGREES]
    return corrected(
        strength_for(family),
        f"the wall of $\\tau_{k}$, with normal {show(t.facets[k].normal)}, separates them",
        witness=witness,
        evidence="; ".join(f"the argument uses the circumcentre of {c.place}: {c.evidence}" for c in wrong),
        constants={"facet": str(k)} if len(members(family)) == 1 else None,
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


EVERY_NORMAL = "every normal"


@lru_cache(maxsize=2)
def _normals(family: str) -> str:
    """Which normals have a positive product with the opposite vertex and no negative one with c.

    Instead of the products the levels are the sign of it that c lies on the boundary: those of c are not
    negative, and some vanish.
    """
    without = set()
    for t in members(family):
        c, vertices = rational_point(t.simplex.circumcentre), t.simplex.vertex_matrix.rows()
        good = [inner(f.normal, u) > 0 and inner(f.normal, c) >= 0
                for f, u in zip(t.facets, vertices, strict=True)]  # fmt: skip
        without.add(tuple(k for k, is_good in enumerate(good) if not is_good))
        if min(t.simplex.circumcentre_coordinates) != 0:
            raise InvalidInput(f"the circumcentre of {t.name} does not lie on the boundary")
    if len(without) != 1:
        raise InvalidInput(f"the members of {family} differ: {without}")
    (nodes,) = without
    return f"{EVERY_NORMAL} but that of node {', '.join(map(str, nodes))}" if nodes else EVERY_NORMAL


def judge_products(family: str, printed: Constants) -> Finding:
    """Whether the normals that are printed have such products, and no others."""
    found = agree(
        printed, {"normals": _normals(family)}, strength_for(family),
        "For $k\\geq1$ the vertex $u_k$ is dual to $m_ks_k$, so $\\langle s_k,u_k\\rangle=1/m_k$; the "
        "products with c are its levels on the walls through 0",
        witness="u_0 = 0 has inner product 0 with every normal", proof=_proof(family),
    )  # fmt: skip
    return explained(
        found,
        "For facet 0, whose hyperplane does not pass through 0, the level 1 - <x, highest root> "
        "takes the place of the inner product; all levels of opposite vertices are positive, those of c are "
        "positive or zero, and some are zero: c lies on the boundary",
    )


for _family in ("C", "F4"):
    claim(
        f"sec6.{_family}.item-8.products",
        _place(_family),
        Weight.PROOF,
        words=f"In {affine_name(_family)}, {{normals}} has a positive inner product with the vertex "
        "opposite, and a positive one or zero with the circumcentre, which therefore lies on the boundary.",
        to_prove=(f"sec6.{_family}.item-2",),
        proof=_proof(_family),
    )(partial(judge_products, _family))
