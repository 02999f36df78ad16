"""Section 4, first part: self-centred simplices and the Delaunay property, up to Theorem 6."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from ..affine import triangulation
from ..exact import show
from ..names import triangulations_up_to
from ..simplex import Position, Simplex, position
from .claim import BrokenTool, Constants, Finding, agree, claim, fails, repaired
from .section_4_basics import OBTUSE, POWER, SMALL, SMALLEST, WALK, position_of, show_all
from .section_4_geometry import circumsphere, mirror_factors, power_identity_holds
from .section_4_patches import mirror_powers, patch, powers_in_patch
from .section_4_periodic import largest_cells
from .section_4_planes import (
    TRAPEZOID,
    cut_from_the_centres,
    growing_radii,
    half_turn_tilings,
    random_rows,
    trapezoid_triangles,
    trapezoids,
)
from .vocabulary import EVERY_D, FINITE, Weight

LEMMA_4_PRIME = (
    *POWER,
    r"Lemma 4′: if $\sigma$ has the largest circumradius $R$, some simplex with the circumsphere of $\sigma$ "
    "contains $c$. Go straight from a general point inside $\\sigma$ to $c$.",
    r"Where the way leaves a simplex with this sphere before $c$, $z_c<0$. Its apex $p$ has "
    r"$\operatorname{pow}(p)=0\le\operatorname{pow}'(p)$ and $z(p)>0$, so $z_{c'}\le z_c<0$ by (P), "
    r"$R'^2-R^2=z_{c'}^2-z_c^2\ge0$, and as $R$ is the largest $z_{c'}=z_c$: the next has the same sphere.",
    "The way meets finitely many simplices, and the last contains $c$.",
)


# -- self-centred simplices make a Delaunay triangulation -------------------------------------------------


@lru_cache(maxsize=1)
def self_centred_are_delaunay() -> bool:
    """Whether circles and spheres are empty in every example whose simplices are all self-centred."""
    rows = all(empty for _, centred, empty in random_rows() if centred)
    told_apart = any(not empty for _, _, empty in random_rows())
    return rows and told_apart and monohedral_ones_are_delaunay()


@lru_cache(maxsize=1)
def monohedral_ones_are_delaunay() -> bool:
    """The same for monohedral examples."""
    tilings = all(t.least_power >= 0 for t in half_turn_tilings() if t.position is not Position.OUTSIDE)
    coxeter = all(
        powers_in_patch(name)[0] >= 0 for name in SMALL if position_of(name) is not Position.OUTSIDE
    )
    return tilings and coxeter


@claim("lem-3", "Section 4, Lemma 3", Weight.RESULT, to_state=["def-20"])
def rajan(printed: Constants) -> Finding:
    """A triangulation of R^d by self-centred simplices only {delaunay?is|need not be} Delaunay."""
    if not power_identity_holds():
        raise BrokenTool("identity (P) fails")
    return agree(
        printed,
        {"delaunay": self_centred_are_delaunay()},
        EVERY_D,
        "The paper cites it; here is a proof for locally finite triangulations.",
        *WALK,
        "Every vertex near was counted for stacks of rows of different triangles, tilings by half-turns and "
        "patches of Coxeter triangulations.",
    )


@claim(
    "sec4.one-simplex",
    "Section 4, before Corollary 2",
    Weight.RESULT,
    to_state=["sec4.monohedral"],
    to_prove=["lem-3"],
)
def one_simplex(printed: Constants) -> Finding:
    """To see that a monohedral triangulation is Delaunay, it is enough to find {number:words} self-centred
    simplex in it."""
    positions = [
        {position(Simplex(tuple(s)).circumcentre_coordinates) for s in patch(n, 2)} for n in SMALLEST
    ]
    enough = all(len(kinds) == 1 for kinds in positions) and monohedral_ones_are_delaunay()
    return agree(
        printed,
        {"number": 1 if enough else 2},
        EVERY_D,
        "A congruence carries circumcentres to circumcentres: with one simplex all are self-centred. Lemma "
        "3.",
        "One is needed: there are Coxeter triangulations that are not self-centred, and they are not "
        "Delaunay.",
    )


@claim(
    "cor-2",
    "Section 4, Corollary 2",
    Weight.RESULT,
    to_state=["def-20", "sec4.monohedral"],
    to_prove=["lem-3"],
)
def corollary_2(printed: Constants) -> Finding:
    """A monohedral triangulation of R^d with a self-centred simplex {delaunay?is|need not be} Delaunay."""
    return agree(
        printed,
        {"delaunay": monohedral_ones_are_delaunay()},
        EVERY_D,
        "All simplices are congruent to the one that is self-centred, so all are: Lemma 3.",
        *WALK,
    )


# -- the converse -----------------------------------------------------------------------------------------


def trapezoid_refutes() -> bool:
    """Whether halves of trapezoids are a Delaunay triangulation of one radius, not all self-centred."""
    found = trapezoids()
    return found.delaunay and len(set(found.squared_radii)) == 1 and Position.OUTSIDE in found.positions


def trapezoid_in_words() -> str:
    """The witness against Lemma 4."""
    found = trapezoids()
    half = trapezoid_triangles()[found.positions.index(Position.OUTSIDE)]
    sphere = circumsphere(half)
    return (
        f"the trapezoid {show_all(TRAPEZOID)}, turned by half-turns about its slanted sides and reflected "
        "in its parallel sides, tiles the plane; the vertices are its corners and their translates by "
        f"multiples of 4. Its corners lie on the empty circle with centre {show(sphere.centre)} and "
        f"$R^2={sphere.square}$. A diagonal of each trapezoid makes it a Delaunay triangulation with all "
        f"circumradii equal; the half {show_all(half)} does not contain the centre"
    )


_LEMMA_4_STEPS = (
    "lem-4.separating-facet",
    "lem-4.neighbour",
    "lem-4.sphere-T",
    "lem-4.line",
    "lem-4.centres-differ",
    "lem-4.circles",
    "lem-4.cap-order",
    "lem-4.sweep",
    "lem-4.apex-on-cap",
    "lem-4.centre-above",
    "lem-4.distance-to-o",
    "lem-4.radii",
    "lem-4.contradiction",
)


@claim("lem-4", "Section 4, Lemma 4", Weight.RESULT, to_state=["def-20"], to_prove=_LEMMA_4_STEPS)
def lemma_4(printed: Constants) -> Finding:
    """In a Delaunay triangulation of R^d every simplex with the largest circumradius is self-centred."""
    cells = largest_cells()
    if not (trapezoid_refutes() and all(cell.contains_centre for cell in cells) and power_identity_holds()):
        raise BrokenTool("the witness, or an instance of Lemma 4′, does not check")
    growing = growing_radii()
    if not (list(growing) == sorted(set(growing)) and growing[-1] < Fraction(25, 64)):
        raise BrokenTool("the radii of the growing rows do not grow")
    crossed = sum(min(cell.lowest_coordinates) < 0 for cell in cells)
    return fails(
        FINITE,
        trapezoid_in_words(),
        "Lemma 4′: if a simplex has the largest circumradius of a Delaunay triangulation of $\\mathbb R^d$, "
        "its circumcentre lies in a simplex with the same circumscribed sphere. So it is self-centred if no "
        "$d+2$ vertices lie on an empty sphere, or if all simplices are congruent",
        derivation=(
            "All eight triangles of a period were examined: each edge is in two of them, the areas fill the "
            "period, no vertex lies inside a circle.",
            "The same happens in every $d\\ge2$: multiply the triangles by a grid of unit cubes and cut the "
            "prisms in the order of their vertices; all spheres are empty and equal, and no part of a prism "
            "over the second half contains its centre. For $d=1$ every segment contains its midpoint.",
            "A largest circumradius, which the lemma presumes, need not exist: rows of isosceles triangles "
            f"of base 1 and heights $1-2^{{-|n|-1}}$ have the squared radii {', '.join(map(str, growing))} "
            "…, below 25/64.",
            *LEMMA_4_PRIME,
            f"Lemma 4′ was tried on the {len(cells)} largest empty circles of periodic sets of points at "
            f"random; {crossed} of them hold triangles that refute Lemma 4 too.",
        ),
    )


@claim("sec4.finite-sets", "Section 4, after Lemma 4", Weight.WORDING, to_state=["lem-4"])
def finite_sets(printed: Constants) -> Finding:
    """Lemma 4 {extends?extends|does not extend} to Delaunay triangulations of finite sets of points."""
    extends = position(Simplex(OBTUSE).circumcentre_coordinates) is not Position.OUTSIDE
    return agree(
        printed,
        {"extends": extends},
        FINITE,
        f"The obtuse triangle {show_all(OBTUSE)} is the Delaunay triangulation of its corners; its "
        "circumradius is the largest, and it is not self-centred. (Nor does Lemma 4 hold for infinite sets.)",
    )


@claim("sec4.same-circumradius", "Section 4, after Lemma 4", Weight.PROOF, to_state=["sec4.monohedral"])
def same_circumradius(printed: Constants) -> Finding:
    """The number of different circumradii in a monohedral triangulation is {number}, so that every simplex
    has the largest circumradius."""
    radii = [{Simplex(tuple(s)).squared_circumradius for s in patch(name, 2)} for name in SMALLEST]
    return agree(
        printed,
        {"number": max(map(len, radii))},
        EVERY_D,
        "A congruence keeps the distances from the circumcentre to the vertices.",
    )


@claim(
    "sec4.not-self-centred",
    "Section 4, before Theorem 6",
    Weight.PROOF,
    to_state=["def-20", "sec4.monohedral"],
    to_prove=["sec4.same-circumradius", "lem-4"],
)
def not_self_centred(printed: Constants) -> Finding:
    """A monohedral triangulation {possible?can|cannot} be Delaunay unless its simplices are self-centred."""
    found = agree(printed, {"possible": not _others_are_not_delaunay()}, EVERY_D)
    return _with_lemma_4_prime() if found.verdict.accepts else found


@lru_cache(maxsize=1)
def _others_are_not_delaunay() -> bool:
    """Whether each monohedral example that is not self-centred has a vertex inside a sphere."""
    _, thirds, power = cut_from_the_centres()
    outside = [t.least_power for t in half_turn_tilings() if t.position is Position.OUTSIDE]
    outside += [power] if thirds is Position.OUTSIDE else []
    outside += [
        min(mirror_powers(triangulation(kind)))
        for kind in triangulations_up_to(8)
        if position_of(kind.affine) is Position.OUTSIDE
    ]
    return bool(outside) and max(outside) < 0


def _with_lemma_4_prime(*more: str) -> Finding:
    if not (trapezoid_refutes() and power_identity_holds()):
        raise BrokenTool("the witness against Lemma 4 does not check")
    return repaired(
        EVERY_D,
        "in place of Lemma 4 take Lemma 4′: in a monohedral Delaunay triangulation every circumradius is the "
        "largest, so some simplex, with the same sphere, contains its circumcentre; all are congruent to it",
        f"Lemma 4, on which the argument rests, is false: {trapezoid_in_words()}",
        derivation=(*LEMMA_4_PRIME, *more),
    )


@claim(
    "thm-6",
    "Section 4, Theorem 6",
    Weight.RESULT,
    to_state=["def-20", "sec4.monohedral"],
    to_prove=["cor-2", "sec4.not-self-centred"],
)
def theorem_6(printed: Constants) -> Finding:
    """{agree?A|Not every} monohedral triangulation is Delaunay exactly if its simplices are self-centred."""
    both = monohedral_ones_are_delaunay() and _others_are_not_delaunay() and mirror_factors() == {4}
    found = agree(printed, {"agree": both}, EVERY_D)
    if not found.verdict.accepts:
        return found
    return _with_lemma_4_prime(
        "That is: if it is Delaunay, all are self-centred. The converse is Corollary 2."
    )
