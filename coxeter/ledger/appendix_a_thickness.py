"""Appendix A, Lemma 10 and Figure 12: thickness."""

from __future__ import annotations

from fractions import Fraction

from ..delaunay import is_self_centred
from ..exact import show
from ..families import evaluate
from ..simplex import regular_simplex
from .appendix_a_samples import CORNER, REACH, enclosing_balls, setting_at, settings, shapes
from .appendix_a_spike import EDGE_ONLY, is_least, ratios, section_is_edge, spike, spike_words
from .appendix_a_support import REGULAR, is_regular_value, value_of_regular
from .claim import Constants, Finding, agree, claim, corrected, decide, fails, holds, repaired
from .instances import is_regular
from .records import formula_at
from .vocabulary import EVERY_D, Weight
from .wording import told

LEMMA_10 = "Appendix A, proof of Lemma 10"

TRACES = (
    r"Let $g$ be the barycentre and $M=\sum(v_i-g)(v_i-g)^t$, with eigenvalues $\mu_k>0$. Then "
    r"$\sum_{i<j}|v_i-v_j|^2=(d+1)\sum\mu_k$ and "
    r"$\sum\frac1{h_i^2}=\operatorname{tr}M^{-1}=\sum\frac1{\mu_k}$, since the gradients of the "
    r"barycentric coordinates, of lengths $\frac1{h_i}$, are the pseudo-inverse of the $v_i-g$.",
    r"$\frac{d+1}{h^2}\ge\sum\frac1{h_i^2}=\sum\frac1{\mu_k}\ge\frac{d^2}{\sum\mu_k}$ "
    r"$=\frac{d^2(d+1)}{\sum|v_i-v_j|^2}\ge\frac{2d}{L^2}$, by the harmonic and arithmetic means and since "
    r"there are $\frac{d(d+1)}{2}$ edges.",
)
NEAREST = (
    r"Let $c'$ be the point of the simplex nearest to its circumcentre $c$, and $\varphi$ the face with "
    r"$c'$ in its relative interior. $c-c'$ is orthogonal to $\varphi$, so $c'$ is the circumcentre of "
    r"$\varphi$, with a radius $\varrho$.",
    r"A vertex $p\notin\varphi$ has $(p-c')\cdot(c-c')\le0$, hence $|p-c'|\le\varrho$; so $\varphi$ is no "
    r"vertex. Let $f$ be the foot of $p$ on the affine hull of $\varphi$ and $y=|p-f|$: "
    r"$y^2+|f-c'|^2\le\varrho^2$.",
    r"As $c'$ is a convex combination of the vertices of $\varphi$, one of them, $v$, has "
    r"$(f-c')\cdot(v-c')\le0$, so $|f-v|^2\ge\varrho^2+|f-c'|^2\ge y^2$ and $|p-v|^2\ge2y^2\ge2h_p^2$, for "
    r"the facet opposite to $p$ contains $\varphi$.",
    r"Some $p\notin\varphi$ has a negative barycentric coordinate of $c$, as "
    r"$0<|c-c'|^2=\sum\gamma_i(v_i-c')\cdot(c-c')$: the facet opposite to it contains $\varphi$ and "
    "separates.",
)


# -- Lemma 10 ----------------------------------------------------------------------------------------------


@claim(
    "lem-10",
    "Appendix A, Lemma 10",
    Weight.RESULT,
    to_state=("def-18.thickness",),
    to_prove=("lem-10.not-self-centred", "lem-10.product", "lem-10.regular"),
    printed=formula_at("Appendix A, Lemma 10"),
)
def thickness(printed: Constants) -> Finding:
    r"""No d-simplex has a greater thickness than the regular one, which has {value}."""
    finding = value_of_regular(
        printed,
        "thickness",
        "sqrt((d + 1)/(2*d))",
        *TRACES,
        greatest=all(
            2 * s.dimension * min(s.squared_heights) <= (s.dimension + 1) * s.squared_longest_edge
            for s in shapes()
        ),
    )
    if not finding.verdict.accepts:
        return finding
    return repaired(
        EVERY_D,
        "Either take, in the case of a simplex that is not self-centred, a facet that contains the face "
        "nearest to the circumcentre, in place of any separating facet; or argue without cases, by the "
        "traces of the matrix of the second moments of the vertices and of its inverse.",
        spike_words(),
        derivation=(*TRACES, "The printed argument, mended:", *NEAREST),
    )


@claim("lem-10.separating-facet", LEMMA_10, Weight.PROOF, to_state=("def-20",))
def separating_facet(printed: Constants) -> Finding:
    """If a simplex does not contain its circumcentre, at least {facets} of its facets separates the two."""
    counts = (sum(x < 0 for x in s.circumcentre_coordinates) for s in shapes() if not is_self_centred(s))
    return agree(
        printed,
        {"facets": min(counts)},
        EVERY_D,
        "A point outside has a negative barycentric coordinate: it and the vertex of that number lie on "
        "different sides of the facet opposite to the vertex.",
    )


@claim(
    "lem-10.angle",
    LEMMA_10,
    Weight.PROOF,
    to_state=("lem-10.separating-facet",),
)
@told
def angle(printed: Constants) -> Finding:
    r"""Let a facet, opposite to the vertex p, separate a simplex from its circumcentre, {any_facet?whichever
    such facet it is|and let it contain the face nearest to the circumcentre}. Then the height from p is at
    most {bound} times the longest edge at p, as the angle of this edge with the facet is at most $\pi/4$.
    """
    squared = evaluate(printed["bound"]) ** 2
    counted = [x for x, chosen in ratios() if chosen or printed["any_facet"]]
    if squared != _limit() or evaluate(printed["bound"]) < 0:
        return corrected(
            EVERY_D, r"the bound is $1/\sqrt2$", constants={"bound": "1/sqrt(2)", "any_facet": False}
        )
    plane = (
        "In the plane it is true: the angle at p is obtuse, so that one of the two others is less than "
        r"$\pi/4$; the one at the end of the longer edge is.",
    )
    if max(counted) <= squared:
        return holds(EVERY_D, *NEAREST, *plane)
    assert all(spike(d)[1] == spike(3)[1] for d in range(3, 9))
    assert is_least()
    return fails(
        EVERY_D,
        spike_words(),
        "True of a facet that contains the face whose relative interior has the point nearest to the "
        "circumcentre; there is one that separates. In the plane every facet is such; from dimension 3 on "
        "the statement about any separating facet is false in each dimension.",
        constants={"bound": "1/sqrt(2)", "any_facet": False},
        derivation=(
            "The foot of the height is silently taken to look at the facet from across the facet's "
            r"circumcentre: with the circumcentre $o$ and radius $\varrho$ of the facet and the foot $f$, "
            r"separation gives $h^2+|f-o|^2<\varrho^2$, and a vertex with $|f-v|\ge\varrho$ exists if the "
            "facet contains $o$. Here it does not.",
            "No simplex with coordinates 0, 1, 2 is a counterexample.",
            r"In dimension $d>3$ add the vertices $(1,0,0)+e_4,\dots,(1,0,0)+e_d$: the circumcentre moves "
            r"by $\frac12(e_4+\dots+e_d)$, the facet opposite to p still separates, and $h^2$ and $L^2$ "
            "stay.",
            *plane,
            "For the facet chosen well:",
            *NEAREST,
        ),
    )


def _limit() -> Fraction:
    """h²/L² in the right isosceles triangle, the limit of obtuse ones."""
    s = setting_at(CORNER, (0, 0)).simplex
    return s.squared_heights[0] / s.squared_edge_lengths[0, 1]


@claim("lem-10.not-self-centred", LEMMA_10, Weight.PROOF, to_prove=("lem-10.angle",))
def not_self_centred(printed: Constants) -> Finding:
    r"""A simplex that is not self-centred has thickness at most {height_to_edge}, the bound of h/L, which is
    at most {bound}."""
    true = {"height_to_edge": "1/sqrt(2)", "bound": "sqrt((d + 1)/(2*d))"}
    first = evaluate(printed["height_to_edge"])
    counted = (s for s in shapes() if not is_self_centred(s))
    good = (
        first**2 == _limit()
        and first > 0
        and all(min(s.squared_heights) <= first**2 * s.squared_longest_edge for s in counted)
        and is_regular_value(printed["bound"], "thickness")
        and all(first <= evaluate(printed["bound"], d=d) for d in range(1, REACH + 1))
    )
    if not good:
        return corrected(EVERY_D, r"$\theta\le\frac{1}{\sqrt2}\le\sqrt{\frac{d+1}{2d}}$", constants=true)
    return repaired(
        EVERY_D,
        "Take a separating facet that contains the face nearest to the circumcentre; the printed argument "
        "takes any.",
        spike_words() + " (Its least height is another one; its thickness does not exceed the bound.)",
        derivation=(
            *NEAREST,
            r"$\theta=\frac{h(\sigma)}{L(\sigma)}\le\frac{h_p}{L_p}\le\frac1{\sqrt2}$, since "
            r"$h(\sigma)\le h_p$ and $L_p\le L(\sigma)$; and $\frac{d+1}{2d}=\frac12+\frac1{2d}$.",
        ),
    )


@claim("lem-10.self-centred", LEMMA_10, Weight.PROOF, to_state=("def-20", "def-21"))
def self_centred(printed: Constants) -> Finding:
    """If a simplex is self-centred, its circumradius {self_centred?is|need not be} the radius of its minimal
    enclosing ball; otherwise it {otherwise?is that too|is not}."""
    equal = {s: enclosing_balls(s)[0].squared_radius == s.squared_circumradius for s in shapes()}
    found = {
        "self_centred": all(x for s, x in equal.items() if is_self_centred(s)),
        "otherwise": any(x for s, x in equal.items() if not is_self_centred(s)),
    }
    return agree(
        printed,
        found,
        EVERY_D,
        r"If $c=\sum\lambda_iv_i$ with $\lambda_i\ge0$, then for every point x "
        r"$\sum\lambda_i|x-v_i|^2=R^2+|x-c|^2$, so some vertex is at least $R$ from x: no smaller ball "
        "contains the vertices.",
        "If c lies outside, move it towards its nearest point of the simplex: all distances from vertices "
        "shrink.",
    )


@claim("lem-10.product", LEMMA_10, Weight.PROOF, to_prove=("lem-9", "thm-9", "lem-10.self-centred"))
def product(printed: Constants) -> Finding:
    r"""For a self-centred simplex $\theta=\frac h{2R}\cdot\frac{2R}L$ is at most {aspect_ratio} times
    {jung}, which is {product}."""
    true = {
        "aspect_ratio": "(d + 1)/(2*d)",
        "jung": "2*sqrt(d/(2*(d + 1)))",
        "product": "sqrt((d + 1)/(2*d))",
    }
    good = all(_product_holds(printed, d) for d in range(1, REACH + 1))
    return decide(
        good,
        EVERY_D,
        r"$\frac{d+1}{2d}\cdot2\sqrt{\frac{d}{2(d+1)}}=\sqrt{\frac{d+1}{2d}}$",
        r"Squared, $\frac{(d+1)^2}{4d^2}\cdot\frac{4d}{2(d+1)}=\frac{d+1}{2d}$.",
        constants=true,
    )


def _product_holds(c: Constants, d: int) -> bool:
    """The factors are those of Lemma 9 and of Jung's theorem, and the product is theirs."""
    s = regular_simplex(d)
    first, second, result = (evaluate(c[name], d=d) for name in ("aspect_ratio", "jung", "product"))
    lemma_9 = s.minimal_height / (2 * s.circumradius)
    return first == lemma_9 and second == 2 * s.circumradius / s.longest_edge and first * second == result


@claim("lem-10.jung-attained", LEMMA_10, Weight.PROOF, to_state=("thm-9",))
def jung_attained(printed: Constants) -> Finding:
    r"""For the regular simplex Jung's theorem is an equality: there $R_{\rm enc}/L$ = {ratio}."""
    every = filter(is_regular, shapes())
    good = all(
        evaluate(printed["ratio"], d=d) == regular_simplex(d).circumradius / regular_simplex(d).longest_edge
        for d in range(1, REACH + 1)
    )
    contained = all(enclosing_balls(s)[0].squared_radius == s.squared_circumradius for s in every)
    return decide(
        good and contained,
        EVERY_D,
        r"the ratio is $\sqrt{\frac{d}{2(d+1)}}$",
        REGULAR,
        "It contains its circumcentre, so its circumscribed ball is the minimal enclosing one.",
        constants={"ratio": "sqrt(d/(2*(d + 1)))"},
    )


@claim("lem-10.regular", LEMMA_10, Weight.PROOF, to_prove=("lem-10.jung-attained", "lem-9.regular"))
def regular_thickness(printed: Constants) -> Finding:
    r"""The thickness of the regular simplex is {value}."""
    why = r"$\theta^2=\frac{h^2}{L^2}=\frac{d+1}{2d}$."
    return value_of_regular(printed, "thickness", "sqrt((d + 1)/(2*d))", why)


# -- Figure 12 ---------------------------------------------------------------------------------------------


@claim("fig-12.left", "Appendix A, Figure 12, left", Weight.PROOF)
def right_triangle(printed: Constants) -> Finding:
    r"""The segment from p to $v_i$ is the hypotenuse of a right triangle, one leg of which is
    ${height:times}h_i {distance:plus} r_i$ for p in the simplex, and the other the distance of the feet on
    facet i."""
    inside = [s for s in settings() if s.where != "outside"]
    good = all(
        x == (printed["height"] * h + printed["distance"] * r) ** 2 + feet
        for s in inside
        for x, h, r, feet in zip(s.squares, s.heights, s.unsigned, s.feet, strict=True)
    )
    return decide(
        good and printed["height"] > 0,
        EVERY_D,
        r"the leg is $h_i-r_i$",
        "Split $v_i-p$ into its components along the normal of facet i and along the facet; the first is "
        "$h_i-r_i$.",
        constants={"height": 1, "distance": -1},
    )


@claim("fig-12.right", "Appendix A, Figure 12, right", Weight.WORDING, to_prove=("lem-10.angle",))
@told
def section(printed: Constants) -> Finding:
    r"""The plane through the longest edge at p and the height from p meets a simplex that is not
    self-centred in an obtuse triangle, whose angle at the other end of that edge is less than {angle:pi}, in
    the plane{in_space? and in space| only}."""
    true = {"angle": "1/4", "in_space": False}
    if evaluate(printed["angle"]) != ANGLES[_limit()]:
        return corrected(EVERY_D, r"the angle is less than $\pi/4$", constants=true)
    if not printed["in_space"]:
        return holds(
            EVERY_D,
            "In the plane the section is the triangle itself, obtuse at p; of its other angles, which add "
            r"up to less than $\pi/2$, the one at the end of the longer side at p is the smaller.",
        )
    assert section_is_edge()
    return corrected(
        EVERY_D,
        "The drawing shows the plane, and some simplices in space. In general the section need not be a "
        r"triangle, and the angle may exceed $\pi/4$ unless the facet contains the face nearest to the "
        "circumcentre.",
        constants=true,
        witness=f"The simplex {', '.join(map(show, EDGE_ONLY))}, with p = {show(EDGE_ONLY[3])}: the plane "
        "through its longest edge at p and its height meets the simplex in this edge only. For the angle: "
        f"{spike_words()}",
    )


ANGLES = {Fraction(1, 4): Fraction(1, 6), Fraction(1, 2): Fraction(1, 4), Fraction(3, 4): Fraction(1, 3)}
"""The square of the sine -> the angle as a multiple of π."""
