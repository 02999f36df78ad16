"""Appendix A, Lemma 11, and a search for a simplex better than the regular one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import lru_cache
from math import factorial, isqrt, prod
from random import Random

from .. import quality
from ..errors import DegenerateSimplex
from ..exact import Surd, sqrt
from ..families import evaluate
from ..simplex import Simplex, regular_simplex
from .appendix_a_samples import REACH, facet, shapes
from .appendix_a_support import value_of_regular
from .claim import Constants, Finding, agree, claim, decide
from .instances import is_regular, near_regular, random_simplices, regular_value
from .records import formula_at
from .vocabulary import EVERY_D, INSTANCES, Weight
from .wording import told

LEMMA_11 = "Appendix A, proof of Lemma 11"


@lru_cache(maxsize=256)
def flag(s: Simplex) -> tuple[Simplex, ...]:
    """Faces σ_1 ⊂ … ⊂ σ_d: each lies below the least height of the next."""
    if s.dimension == 1:
        return (s,)
    top = s.squared_heights.index(min(s.squared_heights))
    return (*flag(facet(s, top)), s)


@claim(
    "lem-11",
    "Appendix A, Lemma 11",
    Weight.RESULT,
    to_state=("def-18.fatness",),
    to_prove=("lem-11.bound", "lem-11.thickness", "lem-11.product", "lem-11.regular"),
    printed=formula_at("Appendix A, Lemma 11"),
)
def fatness(printed: Constants) -> Finding:
    r"""No d-simplex is fatter than the regular one, which has the fatness {value}."""
    return value_of_regular(
        printed,
        "fatness",
        "sqrt((d + 1)/2**d)/factorial(d)",
        r"The faces $\sigma_1\subset\dots\subset\sigma_d$, each below the least height of the next, give "
        r"$\Theta=\frac1{d!}\prod\frac{h(\sigma_i)}{L}\le\frac1{d!}\prod\theta(\sigma_i)$, and Lemma 10 "
        "bounds each factor.",
        "A second proof, without Lemma 10: with the matrix $M$ of the second moments "
        r"$V^2=\frac{(d+1)\det M}{d!^2}$, and "
        r"$\det M\le\left(\frac{\operatorname{tr}M}{d}\right)^d\le\left(\frac{L^2}{2}\right)^d$, as "
        r"$(d+1)\operatorname{tr}M$ is the sum of the squares of the $\frac{d(d+1)}2$ edges.",
        greatest=all(_is_thin(s) for s in shapes()),
    )


def _is_thin(s: Simplex) -> bool:
    d = s.dimension
    return bool(2**d * s.gram_determinant <= (d + 1) * s.squared_longest_edge**d)


@claim("lem-11.faces", LEMMA_11, Weight.PROOF)
def faces(printed: Constants) -> Finding:
    r"""There are faces $\sigma_i$ of the dimensions {first}, ..., {last}, each contained in the next and
    below its least height, the next after the last being the simplex."""
    good = all(_is_flag(printed, s) for s in shapes() if s.dimension > 1)
    return decide(
        good,
        EVERY_D,
        r"the dimensions are $1,\dots,d-1$",
        "From the top down: the facet opposite to a vertex of least height, in it again such a facet, and "
        "so on; for d = 1 there is nothing to choose.",
        constants={"first": "1", "last": "d - 1"},
    )


def _is_flag(c: Constants, s: Simplex) -> bool:
    dimensions = [tau.dimension for tau in flag(s)[:-1]]
    first, last = (evaluate(c[name], d=s.dimension) for name in ("first", "last"))
    return dimensions[0] == first and dimensions[-1] == last


@claim("lem-11.volume", LEMMA_11, Weight.PROOF, to_state=("lem-11.faces",))
def volume(printed: Constants) -> Finding:
    r"""The volume is {factor} times the product of the least heights of the faces $\sigma_i$ from i =
    {first} on."""
    good = all(_volume_of_flag(printed, s) == s.volume for s in shapes())
    return decide(
        good,
        EVERY_D,
        r"$V=\frac1{d!}\prod_{i=1}^dh(\sigma_i)$",
        r"$V(\sigma_{i+1})=\frac1{i+1}h(\sigma_{i+1})V(\sigma_i)$, and $V(\sigma_1)=h(\sigma_1)$: a "
        "segment is its own height. So the formula holds for d = 1 too.",
        constants={"factor": "1/factorial(d)", "first": 1},
    )


def _volume_of_flag(c: Constants, s: Simplex) -> Surd:
    squares = [min(tau.squared_heights) for tau in flag(s) if tau.dimension >= c["first"]]
    complete = 1 <= c["first"] == min(tau.dimension for tau in flag(s))
    return evaluate(c["factor"], d=s.dimension) * sqrt(prod(squares)) * int(complete)


@claim("lem-11.edges", LEMMA_11, Weight.WORDING)
@told
def edges(printed: Constants) -> Finding:
    r"""For each i the edges of the face of dimension {inner} are among those of the face of dimension
    {outer}, which gives $L(\sigma_i)\le L(\sigma_d)$."""
    true = {"inner": "i", "outer": "d"}
    good = all(
        evaluate(printed["inner"], i=i, d=s.dimension) == i
        and evaluate(printed["outer"], d=s.dimension) == s.dimension
        for s in shapes()
        for i in range(1, s.dimension + 1)
    )
    assert all(tau.squared_longest_edge <= s.squared_longest_edge for s in shapes() for tau in flag(s))
    return decide(
        good,
        EVERY_D,
        r"The edges of $\sigma_i$ are among those of $\sigma_d$: the index is d where i is meant, and "
        r"$\sigma$ is $\sigma_d$.",
        r"As printed the sentence compares $\sigma_d$ with itself; the inequality after it, "
        r"$L(\sigma_i)\le L(\sigma_d)$, is right.",
        constants=true,
    )


@claim("lem-11.bound", LEMMA_11, Weight.PROOF, to_prove=("lem-11.volume", "lem-11.edges"))
def bound(printed: Constants) -> Finding:
    r"""The fatness is at most {factor} times the product of the thicknesses of the faces $\sigma_i$; for the
    regular simplex there is equality."""
    good = all(_bound_holds(printed["factor"], s) for s in shapes())
    return decide(
        good,
        EVERY_D,
        r"the factor is $\frac1{d!}$",
        r"$\frac{V}{L(\sigma_d)^d}=\frac1{d!}\prod\frac{h(\sigma_i)}{L(\sigma_d)}\le\frac1{d!}\prod\frac{h(\sigma_i)}{L(\sigma_i)}$.",
        constants={"factor": "1/factorial(d)"},
    )


def _bound_holds(factor: str, s: Simplex) -> bool:
    right: Surd = evaluate(factor, d=s.dimension) * prod(map(quality.thickness, flag(s)))
    left: Surd = quality.fatness(s)
    return left == right if is_regular(s) else left <= right


@claim("lem-11.thickness", LEMMA_11, Weight.PROOF, to_prove=("lem-10",))
def each_thickness(printed: Constants) -> Finding:
    r"""By Lemma 10 the thickness of $\sigma_i$ is at most {bound}, for each i; this cannot be improved."""
    sharp = all(
        evaluate(printed["bound"], i=i) == quality.thickness(regular_simplex(i)) for i in range(1, REACH + 1)
    )
    good = sharp and all(
        quality.thickness(tau) <= evaluate(printed["bound"], i=tau.dimension)
        for s in shapes()
        for tau in flag(s)
    )
    return decide(
        good,
        EVERY_D,
        r"the bound is $\sqrt{\frac{i+1}{2i}}$",
        r"Lemma 10 in dimension i; for i = 1 both sides are 1.",
        constants={"bound": "sqrt((i + 1)/(2*i))"},
    )


@claim("lem-11.product", LEMMA_11, Weight.PROOF)
def product(printed: Constants) -> Finding:
    r"""The product of {factor} for i = 1, ..., d is {product}."""
    true = {"factor": "sqrt((i + 1)/(2*i))", "product": "sqrt((d + 1)/2**d)"}
    good, total = True, Surd(1)
    for d in range(1, REACH + 1):
        total *= evaluate(printed["factor"], i=d)
        good = good and total == evaluate(printed["product"], d=d)
        good = good and evaluate(printed["factor"], i=d) == evaluate(true["factor"], i=d)
    return decide(
        good,
        EVERY_D,
        r"$\prod_{i=1}^d\sqrt{\frac{i+1}{2i}}=\sqrt{\frac{d+1}{2^d}}$",
        r"$\prod_{i=1}^d\frac{i+1}{i}=d+1$: each numerator cancels the next denominator.",
        constants=true,
    )


@claim(
    "lem-11.regular",
    f"{LEMMA_11}, last line",
    Weight.PROOF,
    printed=formula_at("Appendix A, end of the proof of Lemma 11"),
)
def regular_fatness(printed: Constants) -> Finding:
    r"""The fatness of the regular simplex is {value}, by a simple computation."""
    why = r"All faces of a regular simplex are regular, so every inequality of the proof is an equality."
    return value_of_regular(printed, "fatness", "sqrt((d + 1)/2**d)/factorial(d)", why)


# -- an attempt to refute Theorem 5 ------------------------------------------------------------------------

Rows = list[list[int]]


@claim("sec3.searched", "Section 3, Theorem 5", Weight.RESULT, to_state=("thm-5",))
def search(printed: Constants) -> Finding:
    """No simplex that a search found exceeds the regular one in one of the measures {measures}."""
    number, beaten = _search()
    survived = tuple(m.name for m in quality.PAPER_MEASURES if m.name not in beaten)
    return agree(
        printed,
        {"measures": tuple(sorted(survived))},
        INSTANCES,
        f"{number} simplices with integer coordinates, in dimensions 2 to 6, compared exactly: drawn at "
        "random, drawn near the regular simplex, and reached by climbing, step by step, in each measure.",
        "An attempt to refute; Lemmas 8 to 11 prove the theorem.",
    )


@lru_cache(maxsize=1)
def _search() -> tuple[int, frozenset[str]]:
    """How many simplices were tried, and the measures in which one of them exceeds the regular simplex."""
    number, beaten = 0, set()
    for d in range(2, 7):
        for s in (*random_simplices(d, 10, seed=3, size=3), *near_regular(d, 6, 12), *_climbed(d)):
            number += 1
            beaten |= {name for name, exceeds in EXCEEDS.items() if exceeds(s)}
    return number, frozenset(beaten)


def _climbed(d: int, steps: int = 14) -> Iterator[Simplex]:
    """From a random simplex by steps of one coordinate, whenever they improve a measure."""
    for name, score in SCORES.items():
        rng = Random(f"{name} {d}")
        rows = [[rng.randint(-5, 5) for _ in range(d)] for _ in range(d + 1)]
        best = Fraction(0)
        for _ in range(steps):
            tried = [list(row) for row in rows]
            tried[rng.randrange(d + 1)][rng.randrange(d)] += rng.choice((-2, -1, 1, 2))
            try:
                s = Simplex(tried)
            except DegenerateSimplex:
                continue
            yield s
            if (value := score(s)) > best:
                rows, best = tried, value


def _squared_regular(name: str, d: int) -> Fraction:
    return (regular_value(name, d) ** 2).as_fraction()


SCORES: dict[str, Callable[[Simplex], Fraction]] = {
    "aspect_ratio": lambda s: min(s.squared_heights) / (4 * s.squared_circumradius),
    "fatness": lambda s: (
        s.gram_determinant / factorial(s.dimension) ** 2 / s.squared_longest_edge**s.dimension
    ),
    "thickness": lambda s: min(s.squared_heights) / s.squared_longest_edge,
}
"""Squares of the measures: they are rational."""


def _exceeds_by_square(name: str) -> Callable[[Simplex], bool]:
    return lambda s: SCORES[name](s) > _squared_regular(name, s.dimension)


def _exceeds_in_radius_ratio(s: Simplex) -> bool:
    """r/R > 1/d; R·Σ 1/h_i ≥ d is proved from rational lower bounds of the roots, if these suffice."""
    d, scale = s.dimension, 10**8
    squares = (s.squared_circumradius / x for x in s.squared_heights)
    low = sum(isqrt(x.numerator * scale**2 // x.denominator) for x in squares)
    return low < d * scale and s.inradius * d > s.circumradius


EXCEEDS = {**{name: _exceeds_by_square(name) for name in SCORES}, "radius_ratio": _exceeds_in_radius_ratio}
"""Whether a simplex exceeds the regular one in a measure, decided exactly."""
