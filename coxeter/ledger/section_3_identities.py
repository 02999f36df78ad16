"""The identities that the proofs of Theorem 5 stand on, tried on exact simplices."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import combinations

from ..exact import RationalMatrix, Surd, sqrt, surd
from .section_3_samples import Lengths, gram_determinant, measured
from .vectors import Point, mean, minus, squared

RADIUS_RATIO = (
    r"Let $F_i$ be the volume of facet $i$, $F=\sum F_i$, $o$ the circumcentre and $q=\sum\frac{F_i}F v_i$, "
    r"which is the incentre. Then $F_ih_i=dV=Fr$, and $h_i-r\le|q-v_i|$, as it is a component of $v_i-q$.",
    r"$\sum\frac{F_i}F|q-v_i|\ge\frac1F\sum F_i(h_i-r)=\frac{(d+1)dV-dV}F=d\,r$.",
    r"By Cauchy and Schwarz $(dr)^2\le\sum\frac{F_i}F|q-v_i|^2=R^2-|q-o|^2\le R^2$, so $\frac rR\le\frac1d$; "
    r"for the regular simplex $R=d\,r$.",
)
ASPECT_RATIO = (
    *RADIUS_RATIO,
    r"$\frac1r=\sum\frac1{h_i}\le\frac{d+1}h$, so $h\le(d+1)\,r\le\frac{d+1}dR$ and "
    r"$\frac h{2R}\le\frac{d+1}{2d}$; for the regular simplex all heights agree and $R=d\,r$.",
)
_MOMENTS = (
    r"Let $g$ be the barycentre and $M=\sum_i(v_i-g)(v_i-g)^t$ with eigenvalues $\mu_k>0$. "
    r"Then $\sum_{i<j}|v_i-v_j|^2=(d+1)\sum\mu_k$, so $\sum\mu_k\le\frac d2L^2$."
)
THICKNESS = (
    _MOMENTS,
    "The gradients $g_i$ of the barycentric coordinates have length $1/h_i$ and are the columns of "
    r"$M^{-1}W$, where $W$ has the columns $v_i-g$; so $\sum_i "
    r"h_i^{-2}=\operatorname{tr}M^{-1}=\sum\mu_k^{-1}$.",
    r"$\frac{d+1}{h^2}\ge\sum_i h_i^{-2}=\sum\mu_k^{-1}\ge\frac{d^2}{\sum\mu_k}\ge\frac{2d}{L^2}$, so "
    r"$\frac hL\le\sqrt{\frac{d+1}{2d}}$; for the regular simplex all $\mu_k$, heights and edges agree.",
)
FATNESS = (
    _MOMENTS,
    r"$\operatorname{vol}^2=\frac{d+1}{d!^2}\det M$, and $\det M=\prod\mu_k\le(\frac1d\sum\mu_k)^d"
    r"\le(\frac{L^2}2)^d$, so $\Theta\le\frac1{d!}\sqrt{\frac{d+1}{2^d}}$; for the regular simplex all "
    r"agree.",
)


@lru_cache(maxsize=1)
def identities() -> dict[str, bool]:
    """For each measure: do the identities and inequalities of its proof hold on all the simplices?"""
    both = [(sizes, simplex.vertex_matrix.rows()) for sizes, simplex in measured()]
    filling = [(sizes, points) for sizes, points in both if len(points) == len(points[0]) + 1]
    few_roots = [(s, p) for s, p in filling if s.d <= 2 or len(set(_squared_heights(p))) <= 3]
    radii = all(_radii(sizes, points) for sizes, points in few_roots)
    heights = radii and all(1 / sizes.r <= (sizes.d + 1) / sizes.h for sizes, _ in filling)
    moments = [(sizes, points, _moments(points)) for sizes, points in filling]
    traces = all(_traces(points, m) for _, points, m in moments)
    determinants = all(gram_determinant(points) == (sizes.d + 1) * m.det() for sizes, points, m in moments)
    means = all(_means(sizes, m) for sizes, _, m in moments)
    return {
        "radius ratio": radii,
        "aspect ratio": heights,
        "thickness": traces and means,
        "fatness": traces and determinants and means,
    }


def _radii(sizes: Lengths, points: tuple[Point, ...]) -> bool:
    """(d r)² <= Σ w_i |q - v_i|² = R² - |q - o|² <= R², with the weights w_i = r / h_i of the incentre."""
    d = sizes.d
    heights = _heights(points)
    weights = [sizes.r / h for h in heights]
    q = _weighted(weights, points)
    squares = [sum(((x - surd(y)) ** 2 for x, y in zip(q, p, strict=True)), Surd(0)) for p in points]
    average = sum((w * s for w, s in zip(weights, squares, strict=True)), Surd(0))
    reached = all((h - sizes.r) ** 2 <= s for h, s in zip(heights, squares, strict=True))
    return sum(weights, Surd(0)) == 1 and reached and (d * sizes.r) ** 2 <= average <= sizes.R**2


def _heights(points: tuple[Point, ...]) -> list[Surd]:
    return [sqrt(square) for square in _squared_heights(points)]


def _squared_heights(points: tuple[Point, ...]) -> list[Fraction]:
    whole = gram_determinant(points)
    return [whole / gram_determinant((*points[:k], *points[k + 1 :])) for k in range(len(points))]


def _weighted(weights: list[Surd], points: tuple[Point, ...]) -> list[Surd]:
    columns = zip(*points, strict=True)
    return [sum((w * x for w, x in zip(weights, c, strict=True)), Surd(0)) for c in columns]


def _moments(points: tuple[Point, ...]) -> RationalMatrix:
    rows = RationalMatrix.from_rows([minus(p, mean(points)) for p in points])
    return rows.T @ rows


def _traces(points: tuple[Point, ...], m: RationalMatrix) -> bool:
    """Both traces: that of M by the edges, that of its inverse by the heights."""
    edges = sum((squared(p, q) for p, q in combinations(points, 2)), Fraction(0))
    inverse_heights = sum((1 / square for square in _squared_heights(points)), Fraction(0))
    return edges == len(points) * _trace(m) and inverse_heights == _trace(m.inverse())


def _trace(m: RationalMatrix) -> Fraction:
    return sum((m[i, i] for i in range(m.shape[0])), Fraction(0))


def _means(sizes: Lengths, m: RationalMatrix) -> bool:
    """The means of the eigenvalues: harmonic, geometric and arithmetic, and the bound of the last by L."""
    d, arithmetic = sizes.d, _trace(m) / m.shape[0]
    harmonic = m.shape[0] / _trace(m.inverse())
    return harmonic**d <= m.det() <= arithmetic**d and arithmetic <= sizes.L**2 / 2
