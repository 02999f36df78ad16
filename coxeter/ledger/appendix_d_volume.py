"""Appendix D, the proof of Lemma 7: the volume of the simplex of A~."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from ..affine import triangulation
from ..exact import RationalMatrix, Surd, sqrt
from ..families import evaluate
from ..simplex import Simplex
from .appendix_d_cases import fraction
from .claim import Constants, Finding, claim, damaged, decide, holds
from .records import formula_at
from .vectors import Point, minus
from .vocabulary import EVERY_D, FINITE, Weight
from .wording import told

PLACE = "Appendix D, proof of Lemma 7"
DIMENSIONS = range(2, 13)
ENTRIES = {"a": "-(d + 1 - k)/(d + 1)", "b": "k/(d + 1)"}


@lru_cache(maxsize=16)
def columns(d: int) -> tuple[Point, ...]:
    """The vertices u_1 … u_d, with the signs of the paper, and the apex (1, …, 1)."""
    rows = triangulation(("A", d)).simplex.vertex_matrix.rows()[1:]
    return (*(tuple(-x for x in row) for row in rows), (Fraction(1),) * (d + 1))


@lru_cache(maxsize=16)
def pyramid_volume(d: int) -> Surd:
    """The volume of the simplex and the apex, from the Gram determinant of its edges."""
    return Simplex([(0,) * (d + 1), *columns(d)]).volume


@claim("lem-7.orthogonal", PLACE, Weight.PROOF)
def orthogonal(printed: Constants) -> Finding:
    r"""The edge from $u_0$ to the apex (1, ..., 1) is orthogonal to the simplex: its inner products with
    $u_1,\dots,u_d$ are {product}."""
    found = {sum(u) for d in DIMENSIONS for u in columns(d)[:-1]}
    return decide(
        found == {printed["product"]},
        EVERY_D,
        "they are 0",
        r"$u_k$ has k coordinates $-\frac{d+1-k}{d+1}$ and $d+1-k$ coordinates $\frac k{d+1}$; their sum "
        "is 0.",
        constants={"product": 0},
    )


@claim("lem-7.matrix", PLACE, Weight.PROOF)
def matrix(printed: Constants) -> Finding:
    r"""The entry in row i and column k of the matrix of the vertices is $a_k$ = {a} for i up to k and $b_k$
    = {b} below; its last column is {apex}."""
    good = all(_column(printed, d, k) == u for d in DIMENSIONS for k, u in enumerate(columns(d), 1))
    why = r"Column k is $u_k$, with k coordinates $a_k$ and $d+1-k$ coordinates $b_k$; the last is the apex."
    return decide(good, EVERY_D, "the vertices have other coordinates", why, constants={**ENTRIES, "apex": 1})


def _column(c: Constants, d: int, k: int) -> Point:
    if k == d + 1:
        return (Fraction(c["apex"]),) * (d + 1)
    return (fraction(c["a"], d, k),) * k + (fraction(c["b"], d, k),) * (d + 1 - k)


@claim("lem-7.rows", PLACE, Weight.PROOF, to_state=("lem-7.matrix",))
def rows(printed: Constants) -> Finding:
    r"""Subtracting the last row from the others leaves $a_k-b_k$ = ({a}) - ({b}) = {difference} on and above
    the diagonal, 0 below it and in the last column; the last row and column can then be left out of the
    determinant."""
    good = all(
        fraction(printed["a"], d, k) - fraction(printed["b"], d, k)
        == fraction(printed["difference"], d, k)
        == -1
        for d in DIMENSIONS
        for k in range(1, d + 1)
    )
    return decide(
        good and all(map(_is_triangular, DIMENSIONS)),
        EVERY_D,
        r"$a_k-b_k=-1$",
        r"$-\frac{d+1-k}{d+1}-\frac{k}{d+1}=-1$. In column k the last row has $b_k$, as the others below "
        "the diagonal; in the last column all entries are 1. Expanded along that column only its last "
        "entry counts.",
        constants={**ENTRIES, "difference": "-1"},
    )


def _is_triangular(d: int) -> bool:
    """Whether that is what the exact matrix becomes, and the two determinants agree."""
    whole = RationalMatrix.from_rows(columns(d)).T
    left = [minus(row, whole.row(d)) for row in whole.rows()[:-1]]
    shape = all(x == (-1 if i <= k < d else 0) for i, row in enumerate(left) for k, x in enumerate(row))
    return shape and whole.det() == RationalMatrix.from_rows([row[:-1] for row in left]).det()


@claim("lem-7.pyramid", PLACE, Weight.PROOF, to_prove=("lem-7.matrix", "lem-7.rows"))
def pyramid(printed: Constants) -> Finding:
    r"""The simplex and the apex make a simplex of volume {factor} times the modulus of the determinant; the
    determinant is the product of the d numbers $a_k-b_k$, and the volume is {volume}."""
    good = True
    for d in DIMENSIONS:
        determinant = RationalMatrix.from_rows(columns(d)).det()
        volume = evaluate(printed["factor"], d=d) * abs(determinant)
        good = good and determinant == (-1) ** d and volume == pyramid_volume(d)
        good = good and volume == evaluate(printed["volume"], d=d)
    return decide(
        good,
        EVERY_D,
        r"both are $\frac1{(d+1)!}$",
        r"The determinant of the triangular matrix is $(-1)^d$.",
        constants={"factor": "1/factorial(d + 1)", "volume": "1/factorial(d + 1)"},
    )


@claim("lem-7.norm", PLACE, Weight.WORDING)
@told
def norm(printed: Constants) -> Finding:
    """The height of the apex is the norm of the vector {vector:run}, in which one coordinate is repeated."""
    true = ("1", "d + 1")
    if printed["vector"] == true:
        return holds(
            EVERY_D,
            r"$|(1^{\{d+1\}})|=\sqrt{d+1}$ is the distance of the apex from $u_0=0$, the foot of the height.",
        )
    return damaged(
        FINITE,
        r"It is the norm of $(1^{\{d+1\}})$.",
        "Our copy shows the exponent d + 1 without what it belongs to; the apex is introduced as "
        r"$(1^{\{d+1\}})$ at the beginning of the proof, and the next expression has its norm $\sqrt{d+1}$ "
        "in the same place.",
        constants={"vector": true},
    )


@claim(
    "lem-7.base",
    PLACE,
    Weight.PROOF,
    to_prove=("lem-7.orthogonal", "lem-7.pyramid", "lem-7.norm"),
    printed=formula_at(PLACE, "volume"),
)
def base(printed: Constants) -> Finding:
    r"""The volume of the simplex is {factor} times that of the pyramid, divided by {height}; that makes
    {volume}."""
    good = all(_is_base(printed, d) for d in DIMENSIONS)
    true = {"factor": "d + 1", "height": "sqrt(d + 1)", "volume": "1/(sqrt(d + 1)*factorial(d))"}
    return decide(
        good,
        EVERY_D,
        r"$\frac{d+1}{\sqrt{d+1}(d+1)!}=\frac1{\sqrt{d+1}\,d!}$",
        r"A simplex of dimension $d+1$ has the volume $\frac1{d+1}$ times base times height; the height "
        r"stands over $u_0$ and is $\sqrt{d+1}$.",
        "Compared with the Gram determinant of the edges for d = 2, ..., 12.",
        constants=true,
    )


def _is_base(c: Constants, d: int) -> bool:
    factor, height, volume = (evaluate(c[name], d=d) for name in ("factor", "height", "volume"))
    exact = triangulation(("A", d)).simplex.volume
    return (
        factor == d + 1 and height == sqrt(d + 1) and factor * pyramid_volume(d) / height == volume == exact
    )
