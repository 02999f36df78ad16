"""Appendix B, first part: the proof of Lemma 4.

Names as in the paper: σ with circumsphere S, circumcentre c and circumradius R; its facet τ with the
circumcentre o and a vertex q; σ' beyond it with S', c', R'; p is the vertex of σ opposite to τ, and counts as
below. All steps but one are right where c and c' differ; that they do is the wrong one.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from ..exact import RationalMatrix, show
from ..simplex import Simplex
from .appendix_b_steps import (
    different_spheres,
    every_pair,
    in_the_proof,
    points_of_sphere,
    separated,
    sign,
    step,
    step_with,
)
from .claim import BrokenTool, Constants, Finding, agree, claim, fails, holds
from .section_4_basics import POWER
from .section_4_criterion import trapezoid_refutes
from .section_4_geometry import Pair, circumsphere, height_vector, simplices
from .section_4_planes import trapezoid_triangles, trapezoids
from .vectors import Point, along, inner, minus, squared
from .vocabulary import EVERY_D, FINITE, INSTANCES, Weight

PLACE = "Appendix B, proof of Lemma 4"


@claim("lem-4.separating-facet", PLACE, Weight.PROOF, to_state=["def-20"])
def separating_facet(printed: Constants) -> Finding:
    """If c lies outside σ, the hyperplane of some facet has c strictly on one side and σ on the other."""
    outside = 0
    for vertices in simplices():
        centre = circumsphere(vertices).centre
        levels = [_level_over_facet(vertices, k, centre) for k in range(len(vertices))]
        is_outside = min(Simplex(vertices).circumcentre_coordinates) < 0
        outside += is_outside
        if is_outside != (min(levels) < 0):
            return fails(INSTANCES, f"the simplex {', '.join(map(show, vertices))}", "nothing")
    if not outside:
        raise BrokenTool("every simplex tried contains its circumcentre")
    return holds(
        EVERY_D,
        "A point is outside exactly if one of its barycentric coordinates is negative; that of vertex $k$ is "
        "the height over facet $k$ as a part of the height of vertex $k$.",
        f"Tried on {len(simplices())} simplices of dimension 1 to 6; {outside} do not contain their "
        f"circumcentre.",
    )


def _level_over_facet(vertices: tuple[Point, ...], k: int, x: Point) -> Fraction:
    facet = (*vertices[:k], *vertices[k + 1 :])
    return inner(height_vector(vertices[k], facet), minus(x, facet[0]))


@claim("lem-4.neighbour", PLACE, Weight.PROOF, to_state=["sec4.no-boundary"])
def neighbour(printed: Constants) -> Finding:
    """The number of other simplices that share a given facet with a given simplex is {others}."""
    sides = trapezoids().sides
    return agree(
        printed,
        {"others": max(sides) - 1 if len(sides) == 1 else -1},
        EVERY_D,
        "The triangulation fills $\\mathbb R^d$ and is face to face: beyond each facet there is a simplex, "
        "and two would overlap. In a finite triangulation there may be none: here the argument needs "
        "$\\mathbb R^d$.",
    )


@claim("lem-4.sphere-T", PLACE, Weight.PROOF)
def sphere_t(printed: Constants) -> Finding:
    """If c and c' differ, S and S' meet in the hyperplane of τ, a sphere of dimension d - {codimension}."""
    return step_with(
        printed,
        "codimension",
        different_spheres,
        _codimension_of_t,
        *POWER,
        r"A common point has $0=2(z_{c'}-z_c)z(x)$, so $z(x)=0$: it is in the hyperplane, at the distance "
        r"$\varrho>0$ from $o$; and all these points are common. They form the circumsphere of $\tau$, of "
        "dimension $d-2$.",
        "If $S=S'$ (see `lem-4.centres-differ`) the intersection is $S$, and there is no cap.",
    )


def _codimension_of_t(pair: Pair) -> int:
    """d minus the dimension of T: the vertices of τ span the space of T, of one dimension more than T."""
    on_both = all(pair.sphere.power(v) == pair.other_sphere.power(v) == 0 for v in pair.facet)
    none_off = all(pair.other_sphere.power(x) != 0 for x in points_of_sphere(pair))
    if not (on_both and none_off and pair.middle.square > 0):
        return -1
    edges = [minus(v, pair.facet[0]) for v in pair.facet[1:]]
    return len(pair.apex) - (RationalMatrix.from_rows(edges).rank() - 1)


@claim("lem-4.line", PLACE, Weight.PROOF)
def line(printed: Constants) -> Finding:
    """c and c' lie on the line through o at right angles to τ."""
    return step(
        every_pair,
        _on_one_line,
        "Each has the same distance from all vertices of $\\tau$, and so has its foot on the hyperplane: "
        "that is $o$. If $c=c'$ two points do not determine the line, this one serves.",
    )


def _on_one_line(pair: Pair) -> bool:
    """Whether c - o and c' - o are multiples of the normal."""
    for centre, level in zip((pair.sphere.centre, pair.other_sphere.centre), pair.levels, strict=True):
        if along(pair.middle.centre, level / pair.squared_normal, pair.normal) != centre:
            return False
    return True


@claim("lem-4.centres-differ", PLACE, Weight.PROOF, to_prove=["lem-4.line"])
def centres_differ(printed: Constants) -> Finding:
    """c and c' are different points: if they agreed, the hyperplane of τ would contain them."""
    equal = [pair for pair in separated() if pair.share_sphere]
    first, second = trapezoid_triangles()[:2]
    spheres = circumsphere(first), circumsphere(second)
    diagonal = (first[0], first[2])
    off = _level_over_facet((*diagonal, first[1]), 2, spheres[0].centre)
    if not (equal and trapezoid_refutes() and spheres[0] == spheres[1] and off):
        raise BrokenTool("the witness does not check")
    return fails(
        FINITE,
        f"the triangles {', '.join(map(show, second))} and {', '.join(map(show, first))}, the "
        f"halves of a trapezoid in the Delaunay triangulation that refutes Lemma 4, have the same "
        f"circumcentre {show(spheres[0].centre)}, which is not on the line of their common side",
        "neighbours have the same circumcentre exactly if they have the same circumsphere, wherever on the "
        "normal of their facet it is; with this case kept, the proof gives $R'\\ge R$, with equality only if "
        "$c'=c$, and Lemma 4′",
        derivation=(
            "Both centres are on the normal through $o$; that they agree does not say where on it.",
            "The conclusion holds if no $d+2$ vertices are on one empty sphere: a common sphere of "
            "neighbours carries $d+2$.",
            f"Among the pairs tried, {len(equal)} of dimension 2 to 5 have $c=c'$ off the hyperplane.",
        ),
    )


@claim("lem-4.circles", PLACE, Weight.PROOF, to_prove=["lem-4.line", "lem-4.centres-differ"])
def circles(printed: Constants) -> Finding:
    """If c and c' differ, a plane through both meets S and S' in circles that cross in {points:words}
    points."""
    return step_with(
        printed,
        "points",
        different_spheres,
        _crossings,
        "A plane through its centre cuts a sphere in a circle of the same radius. The common points lie in "
        "the hyperplane of $\\tau$, hence on a line through $o$, at the distance $\\varrho>0$ from it.",
        "There the radii $x-c$ and $x-c'$ have the same part $x-o\\ne0$ along that line and different parts "
        "across: they are independent, so the circles cross.",
    )


def _crossings(pair: Pair) -> int:
    """How many of the points o ± (q - o) are on both circles, with independent radii."""
    o, spheres = pair.middle.centre, (pair.sphere, pair.other_sphere)
    found = 0
    for factor in (Fraction(1), Fraction(-1)):
        x = along(o, factor, minus(pair.facet[0], o))
        on_both = all(s.power(x) == 0 for s in spheres)
        radii = [minus(x, s.centre) for s in spheres]
        found += on_both and RationalMatrix.from_rows(radii).rank() == 2
    return found


@claim("lem-4.cap-order", PLACE, Weight.PROOF, to_prove=["lem-4.circles"])
def cap_order(printed: Constants) -> Finding:
    """The part of S outside S' is the one below the hyperplane of τ exactly if c lies below c'."""
    return step(
        different_spheres,
        _cap_is_below_iff_c_is,
        *POWER,
        r"For $x$ on $S$, $\operatorname{pow}'(x)=2(z_c-z_{c'})z(x)$: positive below the hyperplane if $c$ "
        "is below $c'$, positive above it if $c$ is above $c'$.",
    )


def _cap_is_below_iff_c_is(pair: Pair) -> bool:
    low, high = pair.levels
    points = list(points_of_sphere(pair))
    on_sphere = all(pair.sphere.power(x) == 0 for x in points)
    outside_below = (sign(pair.other_sphere.power(x)) == -sign(pair.level(x)) for x in points)
    outside_above = (sign(pair.other_sphere.power(x)) == sign(pair.level(x)) for x in points)
    return on_sphere and bool(points) and all(outside_below if low < high else outside_above)


@claim("lem-4.sweep", PLACE, Weight.PROOF, to_prove=["lem-4.cap-order"])
def sweep(printed: Constants) -> Finding:
    """While c' moves down its line, the cap outside S' changes sides {switches} time: where c' passes c."""
    return step_with(
        printed,
        "switches",
        different_spheres,
        _switches,
        r"By (P) the sign of $\operatorname{pow}'$ on each side of the hyperplane is that of $z_c-z_{c'}$, "
        "up to a sign that does not change: constant but for $z_{c'}=z_c$. The limit cases are half-spaces.",
    )


def _switches(pair: Pair) -> int:
    """How often the sign of the power of p changes while c' runs through levels from high to low."""
    level, o = pair.levels[0], pair.middle.centre
    signs = []
    for shift in (100, 10, 1, Fraction(1, 10), Fraction(-1, 10), -1, -10, -100):
        centre = along(o, (level + shift) / pair.squared_normal, pair.normal)
        signs.append(sign(squared(pair.apex, centre) - squared(pair.facet[0], centre)))
    return sum(a != b for a, b in pairwise(signs))


@claim("lem-4.apex-on-cap", PLACE, Weight.PROOF, to_prove=["lem-4.sphere-T", "lem-4.centres-differ"])
def apex_on_cap(printed: Constants) -> Finding:
    """If c and c' differ: p is not inside S', as all is Delaunay, so it is on the cap outside."""
    if any(pair.other_sphere.power(pair.apex) for pair in separated() if pair.share_sphere):
        raise BrokenTool("spheres that agree do not agree")
    return step(
        in_the_proof,
        lambda pair: pair.sphere.power(pair.apex) == 0 < pair.other_sphere.power(pair.apex),
        "$p$ is on $S$ and off the hyperplane that contains $T=S\\cap S'$, so it is not on $S'$; it is not "
        "inside it either. Also with the weak meaning of Delaunay, by which vertices may lie on spheres.",
        "If $S=S'$ it is on $S'$, and there is no cap.",
    )


@claim("lem-4.centre-above", PLACE, Weight.PROOF, to_prove=["lem-4.separating-facet", "lem-4.apex-on-cap"])
def centre_above(printed: Constants) -> Finding:
    """c lies above the hyperplane of τ, as p lies below it."""
    return step(
        in_the_proof,
        lambda pair: pair.level(pair.apex) < 0 < pair.levels[0],
        "The cap is below the hyperplane, so $p$ is; the hyperplane has $\\sigma$ on the side of $p$ and $c$ "
        "on the other, strictly.",
    )


@claim("lem-4.distance-to-o", PLACE, Weight.PROOF, to_prove=["lem-4.cap-order", "lem-4.centre-above"])
def distance_to_o(printed: Constants) -> Finding:
    """c is closer to o than c' is."""
    return step(
        in_the_proof,
        lambda pair: (
            squared(pair.sphere.centre, pair.middle.centre)
            < squared(pair.other_sphere.centre, pair.middle.centre)
        ),
        "On the line, $o$ is in the hyperplane, $c$ above it and $c'$ above $c$.",
    )


@claim("lem-4.radii", PLACE, Weight.PROOF, to_prove=["lem-4.distance-to-o", "lem-4.line"])
def radii(printed: Constants) -> Finding:
    """c is closer to a vertex q of τ than c' is, that is, R < R'."""
    return step(
        in_the_proof,
        lambda pair: _pythagoras(pair) and pair.sphere.square < pair.other_sphere.square,
        "Pythagoras, with the right angle at $o$: $R^2=\\varrho^2+|c-o|^2$ and $R'^2=\\varrho^2+|c'-o|^2$.",
    )


def _pythagoras(pair: Pair) -> bool:
    q, o = pair.facet[-1], pair.middle
    return all(
        sphere.square == squared(sphere.centre, q) == o.square + squared(sphere.centre, o.centre)
        for sphere in (pair.sphere, pair.other_sphere)
    )


@claim("lem-4.contradiction", PLACE, Weight.PROOF, to_prove=["lem-4.radii"])
def contradiction(printed: Constants) -> Finding:
    """If R < R', R is not the largest circumradius: c does not lie outside σ."""
    if not all(pair.sphere.square == pair.other_sphere.square for pair in separated() if pair.share_sphere):
        raise BrokenTool("spheres that agree do not agree")
    return step(
        in_the_proof,
        lambda pair: max(pair.sphere.square, pair.other_sphere.square) != pair.sphere.square,
        "$\\sigma'$ is a simplex of the triangulation, and $R$ was chosen as the largest circumradius of "
        "all.",
        "So the proof is right where $c\\ne c'$. Where they coincide $R'=R$, and nothing is contradicted.",
    )


@claim("fig-13", "Appendix B, Figure 13", Weight.WORDING, to_state=["lem-4.line", "lem-4.circles"])
def figure_13(printed: Constants) -> Finding:
    """The figure shows the plane of the segments from o to c and to q; these span {dimension} dimensions."""
    return step_with(
        printed,
        "dimension",
        in_the_proof,
        _dimension,
        "$c-o$ is a positive multiple of the normal, $q-o$ is not zero and lies in the hyperplane: two "
        "independent directions. The plane contains $c'$; in dimension three and more it need not contain "
        "$p$, and does not have to: $p$ is only used to find the side of the cap.",
    )


def _dimension(pair: Pair) -> int:
    o = pair.middle.centre
    own = [minus(pair.sphere.centre, o), minus(pair.facet[0], o)]
    spans = RationalMatrix.from_rows(own).rank()
    with_other = RationalMatrix.from_rows([*own, minus(pair.other_sphere.centre, o)]).rank()
    return spans if spans == with_other else -1
