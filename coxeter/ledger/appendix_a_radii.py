"""Appendix A, Lemma 8, and Lemma 9 up to equation (2): radius ratio and aspect ratio."""

from __future__ import annotations

from functools import lru_cache
from itertools import combinations

from ..errors import InvalidInput
from ..exact import Surd, sqrt
from ..simplex import Simplex
from .appendix_a_samples import PYTHAGORAS, Setting, moment, setting_at, settings, shapes
from .appendix_a_support import KLAMKIN, LEMMA_9, identity, value_of_regular
from .claim import Constants, Finding, agree, claim, corrected, holds
from .records import formula_at
from .vocabulary import EVERY_D, Weight
from .wording import amend, told

# -- Lemma 8 -----------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _radii_hold() -> bool:
    """R² ≥ d²r² + |oq|², in the form Σ e_ij/(h_i h_j) ≥ d², for many simplices."""
    return all(_spread_by_heights(s) >= s.dimension**2 for s in shapes())


def _spread_by_heights(s: Simplex) -> Surd:
    edges, h = s.squared_edge_lengths, s.squared_heights
    pairs = combinations(range(s.dimension + 1), 2)
    return sum((edges[i, j] * sqrt(1 / (h[i] * h[j])) for i, j in pairs), Surd(0))


@claim(
    "lem-8",
    "Appendix A, Lemma 8",
    Weight.RESULT,
    to_state=("def-18.radius-ratio",),
    to_prove=("eq-1", "eq-2", "eq-3"),
    printed=formula_at("Appendix A, Lemma 8"),
)
def radius_ratio(printed: Constants) -> Finding:
    r"""No d-simplex has a greater radius ratio than the regular one, which has {value} (Klamkin)."""
    return value_of_regular(
        printed,
        "radius_ratio",
        "1/d",
        *KLAMKIN,
        r"At $p=q$, with $dV=Fr$: $R^2\ge d^2r^2+|o-q|^2$, so $r/R\le 1/d$. The paper cites the lemma; "
        "this proves it, and more.",
        rf"Tried exactly on {len(shapes())} simplices.",
        greatest=_radii_hold(),
    )


# -- Lemma 9 -----------------------------------------------------------------------------------------------


@claim(
    "lem-9",
    "Appendix A, Lemma 9",
    Weight.RESULT,
    to_state=("def-18.aspect-ratio",),
    to_prove=("lem-9.conclusion", "lem-9.chain", "lem-9.regular"),
    printed=formula_at("Appendix A, Lemma 9"),
)
def aspect_ratio(printed: Constants) -> Finding:
    r"""No d-simplex has a greater aspect ratio than the regular one, which has {value}."""
    return value_of_regular(
        printed,
        "aspect_ratio",
        "(d + 1)/(2*d)",
        *KLAMKIN,
        r"Since $(d+1)dV=\sum F_ih_i\ge F\,h$, at $p=q$: $R^2\ge\left(\frac{d}{d+1}h\right)^2+|o-q|^2$, so "
        r"$\frac{h}{2R}\le\frac{d+1}{2d}$.",
        r"Shorter, from Lemma 8: $\frac1r=\sum\frac1{h_i}\le\frac{d+1}{h}$, so "
        r"$h\le(d+1)r\le\frac{d+1}{d}R$.",
        greatest=_heights_hold(),
    )


@lru_cache(maxsize=1)
def _heights_hold() -> bool:
    """d²h² ≤ (d + 1)²R², for many simplices."""
    pairs = ((s.dimension, min(s.squared_heights) / s.squared_circumradius) for s in shapes())
    return all(d**2 * quotient <= (d + 1) ** 2 for d, quotient in pairs)


@claim("eq-1", "Appendix A, equation (1)", Weight.PROOF)
@told
def cauchy_schwarz(printed: Constants) -> Finding:
    r"""For every point p, the product of $\sum F_i$ and $\sum F_i|pv_i|^a$, a = {left_power}, is at least
    the power {right_power} of the sum of the $F_i$ times the {vectors?vectors|lengths} from p to the $v_i$,
    and only the circumcentre gives equality."""
    if all(_first_equation(printed, s) for s in settings()):
        return holds(
            EVERY_D,
            r"Cauchy and Schwarz for the vectors $(\sqrt{F_i})$ and $(\sqrt{F_i}\,|p-v_i|)$; equality "
            "means that they are parallel, that is, that all $|p-v_i|$ agree.",
        )
    t = setting_at(PYTHAGORAS, (1, 1))
    assert not t.products["pq"]  # p is q: the vector sum is zero
    return corrected(
        EVERY_D,
        r"Lengths are meant: $\sum F_i\cdot\sum F_i|pv_i|^2\ge\left(\sum F_i|pv_i|\right)^2$. With vectors "
        "the right side is the square of a vector sum: a true bound, but a weaker one, which is never "
        "attained, and 0 at the point q for which the proof needs it.",
        witness="The triangle with the corners (0,0), (4,0), (0,3) and $p=q=(1,1)$: the vector sum "
        rf"$\sum F_i\,\vec{{pv_i}}$ is 0, the sum of lengths is ${moment(t, 1).latex()}$.",
        constants={"left_power": 2, "right_power": 2, "vectors": False},
        derivation=(
            r"$\sum F_i\,\vec{pv_i}=F\,\vec{pq}$, so that with vectors (1) says "
            r"$F\sum F_i|pv_i|^2\ge F^2|pq|^2$; by (2) the difference is $F^2(R^2-|oq|^2)>0$.",
        ),
    )


def _first_equation(printed: Constants, s: Setting) -> bool:
    """Whether (1) holds, with equality at the circumcentre and nowhere else."""
    left = s.total * moment(s, printed["left_power"])
    if printed["vectors"]:
        if printed["right_power"] != 2:
            raise InvalidInput("only the square of a vector is a number")
        right = s.products["pq"]  # F²|pq|², the square of Σ F_i pv_i
    else:
        right = moment(s, 1) ** printed["right_power"]
    return left == right if s.at_circumcentre else left > right


@claim("eq-1.equality", f"{LEMMA_9}, after (1)", Weight.PROOF, to_state=("eq-1",))
def equality(printed: Constants) -> Finding:
    r"""In (1), read with lengths, the circumcentre {circumcentre?gives|does not give} equality, and other
    points {other_points?do too|do not}."""
    gaps = {s: s.total * moment(s, 2) - moment(s, 1) ** 2 for s in settings()}
    found = {
        "circumcentre": all(not gap for s, gap in gaps.items() if s.at_circumcentre),
        "other_points": any(not gap for s, gap in gaps.items() if not s.at_circumcentre),
    }
    return agree(
        printed,
        found,
        EVERY_D,
        r"Equality in Cauchy and Schwarz means that the vectors $(\sqrt{F_i})$ and $(\sqrt{F_i}\,|p-v_i|)$ "
        "are parallel, hence that p has one distance from all vertices; in the space of the simplex only "
        "the circumcentre has.",
    )


@claim("lem-9.expansion", f"{LEMMA_9}, before (2)", Weight.PROOF)
def expansion(printed: Constants) -> Finding:
    r"""With $q=\sum F_iv_i/F$ and the circumcentre o, $\sum F_i|pv_i|^2$ is F times the sum
    ${radius:times}R^2 {op:plus} |op|^2 {cross:plus}\,op\cdot oq$."""

    def right(s: Setting, c: Constants) -> Surd:
        products = c["op"] * s.products["op"] + c["cross"] * s.products["op.oq"]
        return Surd(s.total**2 * s.squared_circumradius * c["radius"] + products)

    return identity(
        printed,
        {"radius": 1, "op": 1, "cross": -2},
        lambda s, c: s.total * moment(s, 2),
        right,
        r"Expand $|\vec{op}-\vec{ov_i}|^2=|op|^2+R^2-2\,op\cdot ov_i$, multiply by $F_i$ and add; "
        r"$\sum F_i\,\vec{ov_i}=F\,\vec{oq}$.",
    )


@claim("lem-9.polarisation", f"{LEMMA_9}, before (2)", Weight.PROOF)
def polarisation(printed: Constants) -> Finding:
    r"""${factor:times}\,op\cdot oq = {op:times}|op|^2 {oq:plus} |oq|^2 {pq:plus} |pq|^2$."""
    return identity(
        printed,
        {"factor": 2, "op": 1, "oq": 1, "pq": -1},
        lambda s, c: c["factor"] * s.products["op.oq"],
        lambda s, c: sum((c[name] * s.products[name] for name in ("op", "oq", "pq")), Surd(0)),
        r"$|pq|^2=|\vec{oq}-\vec{op}|^2$, expanded.",
    )


@claim("eq-2", "Appendix A, equation (2)", Weight.PROOF, to_prove=("lem-9.expansion", "lem-9.polarisation"))
@told
def second_equation(printed: Constants) -> Finding:
    r"""$\sum F_i\cdot\sum F_i|pv_i|^a$, a = {power}, is $F^2$ times the sum ${radius:times}R^2 {pq:plus}
    |pq|^2 {oq:plus} |oq|^2$."""
    true = {"power": 2, "radius": 1, "pq": 1, "oq": -1}

    def right(s: Setting, c: Constants) -> Surd:
        apart = c["pq"] * s.products["pq"] + c["oq"] * s.products["oq"]
        return Surd(s.total**2 * s.squared_circumradius * c["radius"] + apart)

    finding = identity(
        printed,
        true,
        lambda s, c: s.total * moment(s, c["power"]),
        right,
        r"$F\sum F_i|pv_i|^2=F^2(R^2+|op|^2-2\,op\cdot oq)$, and $2\,op\cdot oq=|op|^2+|oq|^2-|pq|^2$.",
    )
    s = setting_at(PYTHAGORAS, (4, 3))
    return amend(
        finding,
        correction="The square is missing on the left: "
        r"$\sum F_i\cdot\sum F_i|pv_i|^2=F^2(R^2+|pq|^2-|oq|^2)$.",
        witness="The triangle (0,0), (4,0), (0,3) and $p=(4,3)$: the right side is "
        f"${right(s, true).latex()}$, the left one with squared lengths too, with lengths "
        f"${(s.total * moment(s, 1)).latex()}$; with the vectors as printed the left side is no number. On "
        "a line, where vectors are numbers: for the segment from 0 to 1 and p = 1 the sides are "
        f"${_on_a_line()[0]}$ and ${_on_a_line()[1]}$.",
        evidence="The square is missing in (2) and again in the line that combines (1), (2) and (5), and "
        "is there on the left of (1); whether the paper or our copy lost it, we cannot tell.",
    )


def _on_a_line() -> tuple[Surd, Surd]:
    """Both sides of (2) as printed, for the segment from 0 to 1 and p = 1; F_i = 1."""
    s = setting_at(((0,), (1,)), (1,))
    vectors = sum(v[0] - 1 for v in s.simplex.vertices)
    right = s.total**2 * s.squared_circumradius + s.products["pq"] - s.products["oq"]
    return s.total * vectors, right
