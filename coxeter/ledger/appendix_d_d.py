"""Appendix D, Proposition 10: the family D~."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import product

from ..errors import InvalidInput
from ..exact import show
from ..lattices import LatticeProof
from ..root_lattices import Lattice
from .appendix_d_cases import CASES, answer, fraction, range_of
from .appendix_d_steps import NOT_A_LATTICE, register_steps
from .claim import Constants, Finding, claim, corrected, decide, fails, holds, repaired
from .vectors import Point
from .vocabulary import EVERY_D, FINITE, Weight
from .wording import told

D = CASES[10]
PART_1 = f"{D.place}, part 1"


@lru_cache(maxsize=1)
def corners() -> tuple[Point, ...]:
    """The points of Λ with coordinates 0 or 1/2: Λ consists of them and their translates by integers."""
    cube = product((Fraction(0), Fraction(1, 2)), repeat=4)
    return tuple(x for x in cube if sum(x).denominator == 1)


FAILING = (Fraction(1, 2), Fraction(0), Fraction(0), Fraction(1, 2))
"""A point of Λ, of least length among those with which the four printed roots have a product that is no
integer."""


@claim("prop-10", "Section 6, Proposition 10", Weight.RESULT, to_prove=("prop-10.a", "prop-10.b"))
def vertices_of_every_d(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde D_d$ is a lattice for d = {lattice}, and for no other d."""
    if [d for d in D.dimensions if answer(D, d).is_lattice] != [printed["lattice"]]:
        return corrected(EVERY_D, r"It is for $d=4$ alone.")
    return repaired(
        EVERY_D,
        r"For $d=4$ the four roots have to be chosen for each point; the proof for $d\ge5$ is right.",
        f"The point {show(FAILING)} of Λ, which shows that four fixed roots will not do.",
    )


@claim(
    "prop-10.a",
    "Section 6, Proposition 10 (a)",
    Weight.RESULT,
    to_prove=("prop-10.inclusion", "prop-10.converse"),
)
def vertices_of_d4(printed: Constants) -> Finding:
    r"""For d = {d} the vertex set of $\tilde D_d$ is {lattice?a|not a} lattice."""
    lattices = {d for d in D.dimensions if answer(D, d).is_lattice}
    if not (printed["lattice"] and lattices == {printed["d"]}):
        return corrected(EVERY_D, r"$\tilde D_4$ is, and no other.")
    x = FAILING
    return repaired(
        FINITE,
        r"A point of $\Lambda$ has an even number of coordinates that are not integers. If there are none "
        "or four, all inner products with roots are integers; if there are two, at the places i and j, "
        r"those with $e_i\pm e_j$ and $e_k\pm e_l$ are, where k and l are the other places. In each case "
        "there are four independent roots.",
        rf"The point {show(x)} of Λ: none of $e_1\pm e_2$, $e_3\pm e_4$ has an integer inner product with "
        "it. It is a vertex, by other roots.",
        derivation=(f"A second proof, by counting: {answer(D, 4)}.",),
    )


register_steps(D, NOT_A_LATTICE[:2])


@claim("prop-10.lattice", PART_1, Weight.PROOF, to_prove=("prop-10.inclusion", "prop-10.converse"))
def lattice_of_d4(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde D_4$ consists of the vectors whose coordinates are multiples of {step} and
    whose coordinates add up to a multiple of {sum}."""
    found = answer(D, 4)
    assert isinstance(found, LatticeProof)
    good = found.lattice == _lattice(fraction(printed["step"]), printed["sum"])
    assert [x for x in product((Fraction(0), Fraction(1, 2)), repeat=4) if D.at(4).is_vertex_by_rank(x)] == [
        *corners()
    ]
    return decide(
        good,
        FINITE,
        r"multiples of $\frac12$ that add up to an integer",
        "Whether a point is a vertex depends on its coordinates modulo 1 alone; of the 16 points with "
        "coordinates 0 and 1/2 those that add up to an integer are vertices, and the vertices of the "
        "fundamental simplex are among them.",
        constants={"step": "1/2", "sum": 1},
    )


def _lattice(step: Fraction, total: int) -> Lattice:
    if step <= 0 or total <= 0 or (total / step).denominator != 1:
        raise InvalidInput("no lattice of this form")
    rows = [[step * ((i == j) - (j == 3)) for j in range(4)] for i in range(3)]
    return Lattice.spanned_by([*rows, [0, 0, 0, total]])


@claim("prop-10.products", PART_1, Weight.PROOF, to_state=("prop-10.roots",))
def products_of_d4(printed: Constants) -> Finding:
    r"""The inner products of the roots with points of $(\frac12\mathbb Z)^4$ are multiples of {step}, the
    greatest such number, and the coordinates of the dual roots multiples of {coroot}, again the greatest."""
    roots = D.at(4).roots
    products = {abs(x) / 2 for row in roots.roots.rows() for x in row if x}
    coordinates = {abs(x) for row in roots.coroots.rows() for x in row if x}
    good = products == {fraction(printed["step"])} and coordinates == {printed["coroot"]}
    why = r"All roots are $\pm e_i\pm e_j$ and are their own dual roots."
    return decide(good, FINITE, r"$\frac12$ and 1", why, constants={"step": "1/2", "coroot": 1})


@claim("prop-10.half-sums", PART_1, Weight.PROOF, to_state=("prop-10.roots",))
def half_sums(printed: Constants) -> Finding:
    r"""For the positive roots r the coordinates of $\frac12r$ add up to an integer, one of {sums}."""
    found = {sum(row) / 2 for row in D.at(4).roots.positive_roots.rows()}
    good = found == {Fraction(x) for x in printed["sums"]}
    return decide(good, FINITE, "0 or 1", r"$\frac12(e_i\pm e_j)$.", constants={"sums": (0, 1)})


@claim(
    "prop-10.inclusion",
    PART_1,
    Weight.PROOF,
    to_prove=("prop-6", "prop-10.products", "prop-10.half-sums"),
)
def inclusion_of_d4(printed: Constants) -> Finding:
    r"""The affine Weyl group maps Λ, the points whose coordinates are multiples of {step} and add up to a
    multiple of {sum}, to itself, and the vertices of the fundamental simplex lie in Λ; no smaller such set
    does."""
    given = _lattice(fraction(printed["step"]), printed["sum"])
    t = D.at(4)
    stable = all(f.reflect(x) in given for f in t.facets for x in ((Fraction(0),) * 4, *given.basis.rows()))
    inside = all(row in given for row in t.simplex.vertex_matrix.rows())
    least = all(row in _lattice(Fraction(1, 2), 1) for row in given.basis.rows())
    return decide(
        stable and inside and least,
        FINITE,
        r"multiples of $\frac12$ that add up to an integer",
        r"$\sigma_{r,k}(x)=x-2(\langle x,r\rangle-k)\cdot\frac12r$, and $2(\langle x,r\rangle-k)$ is an "
        "integer: the sum of the coordinates changes by an integer.",
        constants={"step": "1/2", "sum": 1},
    )


@claim("prop-10.converse", PART_1, Weight.PROOF, to_prove=("prop-10.criterion",))
@told
def converse_of_d4(printed: Constants) -> Finding:
    r"""Every point of Λ has integer inner products with the four roots $e_i\pm e_j$, $e_k\pm e_l$, for one
    of the pairings (i, j, k, l) = {pairings}."""
    pairings = printed["pairings"]
    for p in pairings:
        if sorted(p) != [1, 2, 3, 4] or p[0] > p[1] or p[2] > p[3]:
            raise InvalidInput(f"{p} does not pair the four coordinates")
    if all(any(_serves(p, x) for p in pairings) for x in corners()):
        return holds(
            FINITE,
            "Inner products modulo 1 depend on the coordinates modulo 1: the eight points of Λ with "
            "coordinates 0 and 1/2 decide. Each of the three pairings is needed.",
        )
    x = FAILING
    assert x in corners()
    pairs = (((1, 2), 1), ((1, 2), -1), ((3, 4), 1), ((3, 4), -1))
    found = [x[i - 1] + sign * x[j - 1] for (i, j), sign in pairs]
    assert D.at(4).is_vertex(x)
    return fails(
        FINITE,
        f"The point {show(x)} of Λ has the inner products {show(found)} with $e_1+e_2$, $e_1-e_2$, "
        "$e_3+e_4$, $e_3-e_4$.",
        "True if the four roots may depend on the point: the coordinates that are not integers, two if "
        "there are not none or four, are paired. So every point of Λ is a vertex all the same.",
        constants={"pairings": ((1, 2, 3, 4), (1, 3, 2, 4), (1, 4, 2, 3))},
    )


def _serves(pairing: tuple[int, ...], x: Point) -> bool:
    a, b, c, d = (x[n - 1] for n in pairing)
    return all(y.denominator == 1 for y in (a + b, a - b, c + d, c - d))


# -- part 2 ------------------------------------------------------------------------------------------------


@claim(
    "prop-10.b",
    "Section 6, Proposition 10 (b)",
    Weight.RESULT,
    to_prove=("prop-10.no-vertex",),
    proof=("proposition_10",),
)
def vertices_of_d(printed: Constants) -> Finding:
    r"""From d = {first} on the vertex set of $\tilde D_d$ is {lattice?a|not a} lattice."""
    return decide(
        range_of(printed, 10, 5, lattice=False),
        EVERY_D,
        r"For no $d\ge5$ it is a lattice.",
        r"$u_3-u_2=\frac12e_3$, as $3\le d-2$. A root has an integer product with it only if its third "
        "coordinate is 0, as these coordinates are 0, 1 or -1; so the rank of such roots is $d-1$, and the "
        "difference is no vertex.",
    )


register_steps(D, NOT_A_LATTICE[2:])
