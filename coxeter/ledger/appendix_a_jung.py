"""Appendix A, Definition 21 and Theorem 9: minimal enclosing balls and Jung's theorem."""

from __future__ import annotations

from ..families import evaluate
from ..simplex import Simplex, regular_simplex
from .appendix_a_samples import REACH, enclosing_balls, shapes
from .appendix_a_support import REGULAR
from .claim import Constants, Finding, agree, claim, decide
from .vocabulary import EVERY_D, Weight


@claim("def-21", "Appendix A, Definition 21", Weight.WORDING)
def minimal_enclosing_ball(printed: Constants) -> Finding:
    """A bounded set has a ball of least radius among those that contain it, and exactly {balls} of them."""
    found = {len(set(enclosing_balls(s))) for s in shapes()}
    (balls,) = found
    return agree(
        printed,
        {"balls": balls},
        EVERY_D,
        "Existence: the least radius of a ball about x that contains the set is a continuous function of x "
        "and grows without bound as x goes to infinity.",
        r"Uniqueness: if balls of the same radius $R$ about $x\ne y$ contain the set, so does the ball "
        r"about $\frac{x+y}2$ of radius $\sqrt{R^2-|x-y|^2/4}$.",
        f"Tried on the vertices of {len(shapes())} simplices.",
    )


@claim("thm-9", "Appendix A, Theorem 9", Weight.RESULT, to_state=("def-21",))
def jung(printed: Constants) -> Finding:
    r"""The minimal enclosing ball of a compact set of diameter L in $\mathbb R^d$ has at most the radius
    $L\sqrt x$, x = {radicand}; this cannot be improved."""
    good = all(_jung_holds(printed["radicand"], s) for s in shapes())
    return decide(
        good and _is_jung(printed["radicand"]),
        EVERY_D,
        r"the radicand is $\frac{d}{2(d+1)}$",
        r"The centre $m$ of the ball is a convex combination $\sum\lambda_ip_i$ of $n\le d+1$ points of "
        "the set on its boundary; otherwise the ball could be moved and shrunk.",
        r"For each j $\sum_i\lambda_i|p_i-p_j|^2=2R^2$, and the left side is at most $(1-\lambda_j)L^2$; "
        r"added up, $2nR^2\le(n-1)L^2$, and $\frac{n-1}{2n}\le\frac d{2(d+1)}$.",
        "The regular simplex attains the bound. " + REGULAR,
        constants={"radicand": "d/(2*(d + 1))"},
    )


def _jung_holds(radicand: str, s: Simplex) -> bool:
    (ball,) = enclosing_balls(s)
    return ball.squared_radius <= evaluate(radicand, d=s.dimension) * s.squared_longest_edge


def _is_jung(radicand: str) -> bool:
    """Whether the radicand is that of the regular simplex, which contains its circumcentre."""
    every = map(regular_simplex, range(1, REACH + 1))
    return all(
        evaluate(radicand, d=s.dimension) == s.squared_circumradius / s.squared_longest_edge for s in every
    )
