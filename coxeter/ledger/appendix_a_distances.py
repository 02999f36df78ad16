"""Appendix A, Lemma 9 from equation (3) on: distances from vertices and from facets."""

from __future__ import annotations

from ..exact import Surd, sqrt
from ..families import evaluate
from .appendix_a_samples import CORNER, PYTHAGORAS, Setting, moment, setting_at, settings, shapes
from .appendix_a_support import LEMMA_9, is_centre_of_regular, sharp_bound, value_of_regular
from .claim import Constants, Finding, agree, claim, corrected, damaged, decide, holds, repaired
from .instances import regular_value
from .records import formula_at
from .vocabulary import EVERY_D, FINITE, Weight
from .wording import amend, told

# -- equations (3) to (5) ----------------------------------------------------------------------------------


@claim("lem-9.hypotenuse", f"{LEMMA_9}, before (3)", Weight.WORDING, to_state=("fig-12.left",))
@told
def hypotenuse(printed: Constants) -> Finding:
    r"""The distance of p from $v_i$ is {strict?greater than|at least} $h_i-r_i$."""
    gaps = [(s, x - (h - r)) for s in settings() for x, h, r in _legs(s)]
    assert all(gap >= 0 for _, gap in gaps)
    finding = agree(
        printed,
        {"strict": not any(s.where == "inside" and not gap for s, gap in gaps)},
        EVERY_D,
        r"The component of $v_i-p$ at right angles to facet i is $h_i-s_i$, with $s_i=\pm r_i$ the signed "
        "distance; a vector is no shorter than a component, and as long if it has no other.",
        witness=r"The centre of an equilateral triangle: it lies on all heights, and $d(p,v_i)=h_i-r_i$.",
    )
    return amend(
        finding,
        correction="At least $h_i-r_i$: there is equality if p lies on the height, as the centre of a "
        "regular simplex does. The display that follows has the right sign.",
    )


def _legs(s: Setting) -> list[tuple[Surd, Surd, Surd]]:
    return [(sqrt(x), h, r) for x, h, r in zip(s.squares, s.heights, s.unsigned, strict=True)]


@claim("lem-9.sum", f"{LEMMA_9}, before (3)", Weight.PROOF, to_prove=("lem-9.hypotenuse",))
def sum_of_distances(printed: Constants) -> Finding:
    r"""$\sum F_i\,d(p,v_i)$ is at least ${heights:times}\sum F_ih_i {distances:plus} \sum F_ir_i$, for every
    p; this cannot be improved."""

    def gap(s: Setting) -> Surd:
        a, b = printed["heights"], printed["distances"]
        return moment(s, 1) - Surd(a) * s.weigh(s.heights) - Surd(b) * s.weigh(s.unsigned)

    true = {"heights": 1, "distances": -1}
    return sharp_bound(printed, true, gap, r"Multiply $d(p,v_i)\ge h_i-r_i$ by $F_i$ and add.")


@claim("lem-9.facet-volume", f"{LEMMA_9}, before (3)", Weight.PROOF)
def facet_volume(printed: Constants) -> Finding:
    r"""$F_ih_i$ is {factor} times the volume, for each i."""
    good = all(
        f * h == evaluate(printed["factor"], d=s.dimension) * s.volume
        for s in shapes()
        if s.dimension <= 4
        for f, h in zip(Setting(s, ()).facet_volumes, s.heights, strict=True)
    )
    why = r"A simplex is the pyramid over its facet: its volume is $\frac1d F_ih_i$, for $d=1$ with $F_i=1$."
    return decide(good, EVERY_D, "the factor is d", why, constants={"factor": "d"})


@claim("lem-9.subdivision", f"{LEMMA_9}, before (3)", Weight.PROOF, to_prove=("lem-9.facet-volume",))
@told
def subdivision(printed: Constants) -> Finding:
    r"""$\sum F_ir_i=dV$ for every point p: for p {p}."""
    good = [where for where in ("inside", "on the boundary", "outside") if _subdivides(where)]
    s = setting_at(CORNER, (1, 1))
    segment = setting_at(((0,), (1,)), (2,))
    assert all(t.weigh(t.signed) == t.d_volumes for t in settings())
    finding = agree(
        printed,
        {"p": tuple(good)},
        EVERY_D,
        r"Let $\lambda_i$ be the barycentric coordinates of p. Its signed distance from facet i is "
        r"$s_i=\lambda_ih_i$, so $\sum F_is_i=dV\sum\lambda_i=dV$ for every p.",
        r"$r_i=|s_i|$: outside some $s_i$ is negative, and $\sum F_ir_i>dV$.",
        witness=rf"The triangle (0,0), (1,0), (0,1) and $p=(1,1)$: $\sum F_ir_i={s.weigh(s.unsigned)}$, "
        f"$dV={s.d_volumes}$. The segment from 0 to 1 and p = 2: ${segment.weigh(segment.unsigned)}$ and "
        f"${segment.d_volumes}$.",
    )
    return amend(
        finding,
        correction="True for p in the simplex. For every p, if $r_i$ counts as negative where p lies "
        r"beyond facet i. Only $p=q$ is used in the end, and $q=\sum F_iv_i/F$, a mean with positive "
        "weights, lies inside.",
    )


def _subdivides(where: str) -> bool:
    return all(s.weigh(s.unsigned) == s.d_volumes for s in settings() if s.where == where)


@claim(
    "eq-3",
    "Appendix A, equation (3)",
    Weight.PROOF,
    to_prove=("lem-9.sum", "lem-9.facet-volume", "lem-9.subdivision"),
)
def third_equation(printed: Constants) -> Finding:
    r"""$\sum F_i\,d(p,v_i)$ is at least {bound} times the volume, for every p; this cannot be improved."""
    true = {"bound": "d**2"}

    def gap(s: Setting) -> Surd:
        return moment(s, 1) - evaluate(printed["bound"], d=s.d) * s.simplex.volume

    finding = sharp_bound(printed, true, gap, "")
    if not finding.verdict.accepts:
        return finding
    s = setting_at(CORNER, (1, 1))
    steps = s.weigh(s.heights) - s.weigh(s.unsigned)
    return repaired(
        EVERY_D,
        r"Count the distances from the facets with their signs, $s_i=\lambda_ih_i$: $d(p,v_i)\ge h_i-s_i$ "
        r"and $\sum F_is_i=dV$ hold for every p, and give $\sum F_id(p,v_i)\ge(d+1)dV-dV=d^2V$.",
        "The triangle (0,0), (1,0), (0,1) and $p=(1,1)$: the printed steps give the bound "
        rf"$\sum F_ih_i-\sum F_ir_i={steps}$ in place of $d^2V={s.d * s.d_volumes}$.",
        derivation=(r"$\sum F_is_i=dV\sum\lambda_i=dV$, with the barycentric coordinates $\lambda_i$ of p.",),
    )


@claim("eq-4", "Appendix A, equation (4)", Weight.PROOF, to_prove=("lem-9.facet-volume",))
def fourth_equation(printed: Constants) -> Finding:
    r"""{factor} times the volume is $\sum F_ih_i$, which is at least F times the least height."""
    every = [s for s in settings() if s.at_circumcentre]
    good = all(
        s.weigh(s.heights) == evaluate(printed["factor"], d=s.d) * s.simplex.volume
        and s.weigh(s.heights) >= s.total * s.simplex.minimal_height
        for s in every
    )
    why = r"$d+1$ facets with $F_ih_i=dV$ each, and $h_i\ge h(\sigma)$."
    return decide(good, EVERY_D, "the factor is d(d+1)", why, constants={"factor": "(d + 1)*d"})


@claim("eq-5", "Appendix A, equation (5)", Weight.PROOF, to_prove=("eq-3", "eq-4"))
def fifth_equation(printed: Constants) -> Finding:
    r"""$\sum F_i\,d(p,v_i)$ is at least {factor} times F times the least height; this cannot be improved."""

    def gap(s: Setting) -> Surd:
        return moment(s, 1) - evaluate(printed["factor"], d=s.d) * s.total * s.simplex.minimal_height

    why = r"$d^2V=\frac{d}{d+1}\cdot(d+1)dV\ge\frac{d}{d+1}F\,h(\sigma)$."
    return sharp_bound(printed, {"factor": "d/(d + 1)"}, gap, why)


@claim("lem-9.numbers", f"{LEMMA_9}, equations (3) to (5)", Weight.WORDING)
@told
def numbers(printed: Constants) -> Finding:
    """The equations that carry a number are {tagged}; those that are referred to are {cited}."""
    if printed["tagged"] == printed["cited"]:
        return holds(FINITE)
    missing = [n for n in printed["cited"] if n not in printed["tagged"]]
    return damaged(
        FINITE,
        f"The displays after (2) are to carry the numbers {', '.join(map(str, missing))}: the bound $d^2V$ "
        r"is (3), that of $F\,h(\sigma)$ is (4), and the one that combines them is (5).",
        f"Numbers run on in Appendices C and D with (6) and (7), so {len(missing)} are lost here; the text "
        "combines (3) and (4) to what it then calls (5).",
        constants={"tagged": printed["cited"], "cited": printed["cited"]},
    )


# -- the conclusion ----------------------------------------------------------------------------------------


@claim("lem-9.chain", f"{LEMMA_9}, after (5)", Weight.PROOF, to_prove=("eq-1", "eq-2", "eq-5"))
@told
def chain(printed: Constants) -> Finding:
    r"""From (1), (2) and (5): $F^2(R^2+|pq|^2-|oq|^2)$ is $F\sum F_i|pv_i|^a$, a = {power}, which is at
    least the square of $\sum F_i\,pv_i$ with the {vectors?vectors|lengths} $pv_i$, which is at least the
    square of {factor} times $F\,h(\sigma)$."""
    true = {"power": 2, "vectors": False, "factor": "d/(d + 1)"}
    if all(_chain_holds(printed, s) for s in settings()):
        return holds(EVERY_D, r"(2), then (1), then (5), with lengths.")
    s = setting_at(PYTHAGORAS, (1, 1))
    bound = (evaluate("d/(d + 1)", d=2) * s.total * s.simplex.minimal_height) ** 2
    assert not s.products["pq"]  # p is q: the vector sum is zero
    return corrected(
        EVERY_D,
        "With lengths and the square: "
        r"$F\sum F_i|pv_i|^2\ge(\sum F_i|pv_i|)^2\ge\left(\frac{d}{d+1}Fh\right)^2$.",
        constants=true,
        witness="The triangle (0,0), (4,0), (0,3) and $p=q=(1,1)$: with vectors the third term is 0, and "
        f"the last is ${bound.latex()}$.",
        evidence="Vector arrows stand in (1), (2) and here, lengths d(p, v_i) in (3) and (5), which are "
        "combined.",
    )


def _chain_holds(c: Constants, s: Setting) -> bool:
    first = s.total**2 * s.squared_circumradius + s.products["pq"] - s.products["oq"]
    second = s.total * moment(s, c["power"])
    third = s.products["pq"] if c["vectors"] else moment(s, 1) ** 2
    fourth = (evaluate(c["factor"], d=s.d) * s.total * s.simplex.minimal_height) ** 2
    sharp = third == fourth or not is_centre_of_regular(s)
    return first == second and second >= third >= fourth and sharp and evaluate(c["factor"], d=s.d) > 0


@claim("lem-9.conclusion", f"{LEMMA_9}, conclusion", Weight.PROOF, to_prove=("lem-9.chain",))
def conclusion(printed: Constants) -> Finding:
    r"""At p = q: $R^2$ is at least the square of {factor} times h, plus ${oq:times}|oq|^2$, so that the
    aspect ratio is at most {aspect_ratio}; neither can be improved."""
    true = {"factor": "d/(d + 1)", "oq": 1, "aspect_ratio": "(d + 1)/(2*d)"}
    every = [s for s in settings() if s.at_circumcentre]
    good = all(_conclusion_holds(printed, s) for s in every)
    return decide(
        good,
        EVERY_D,
        r"$R^2\ge\left(\frac{d}{d+1}h\right)^2+|oq|^2$ and $\alpha\le\frac{d+1}{2d}$",
        r"The chain at $p=q$, divided by $F^2$; then $|oq|^2\ge0$ is left out and $\frac{h}{2R}$ isolated.",
        "Regular simplices show that the first factor is best possible, thin triangles, where $|oq|/R$ "
        "tends to 1 and $h/R$ to 0, that the coefficient of $|oq|^2$ is.",
        constants=true,
    )


def _conclusion_holds(c: Constants, s: Setting) -> bool:
    factor, ratio = evaluate(c["factor"], d=s.d), evaluate(c["aspect_ratio"], d=s.d)
    h, f = s.simplex.minimal_height, s.total
    gap = f**2 * s.squared_circumradius - (factor * h * f) ** 2 - c["oq"] * s.products["oq"]
    sharp = gap == 0 or not is_centre_of_regular(s)
    return c["oq"] >= 1 and gap >= 0 and sharp and 2 * ratio * factor == 1


@claim(
    "lem-9.regular",
    f"{LEMMA_9}, last line",
    Weight.PROOF,
    printed=formula_at("Appendix A, end of the proof of Lemma 9"),
)
@told
def regular_aspect_ratio(printed: Constants) -> Finding:
    r"""The aspect ratio of the regular simplex is {value}, by a simple computation."""
    finding = value_of_regular(
        printed,
        "aspect_ratio",
        "(d + 1)/(2*d)",
        r"$\alpha^2=\frac{h^2}{4R^2}=\frac{(d+1)^2}{4d^2}$.",
        r"The printed value is never right: $\frac{d}{d+1}=\frac{d+1}{2d}$ means $2d^2=(d+1)^2$, which no "
        "integer solves; it is $R/h$.",
    )
    return amend(
        finding,
        witness="d = 2: the aspect ratio of the equilateral triangle is "
        f"{regular_value('aspect_ratio', 2)}, printed is {evaluate(printed['value'], d=2)}.",
        evidence="Lemma 9 itself and the table of the regular simplex in Section 5 print the right value.",
    )
