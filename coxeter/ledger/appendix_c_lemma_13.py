"""Appendix C, Lemma 13: by how much squared distances from the circumcentre differ."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import lru_cache
from itertools import permutations, product
from math import gcd, lcm

from ..affine import triangulation
from ..errors import InvalidInput
from ..exact import Surd, show
from ..families import evaluate
from .appendix_c_vertices import point, sample, squared_distance
from .claim import Constants, Finding, agree, claim, corrected, holds
from .vocabulary import EVERY_D, Weight
from .wording import fits, told


@lru_cache(maxsize=1)
def _units() -> dict[int, Fraction]:
    """For some d the greatest number of which all differences of squared distances are multiples."""
    found = {}
    for d in (2, 3, 4, 5):
        first, *others = sorted({squared_distance(k, n) for k, n in sample(d)})
        differences = [x - first for x in others]
        denominator = lcm(*(x.denominator for x in differences))
        found[d] = Fraction(gcd(*(int(x * denominator) for x in differences)), denominator)
    return found


@claim(
    "lem-13",
    "Appendix C, Lemma 13",
    Weight.PROOF,
    to_prove=("eq-6", "lem-13.parity", "lem-13.reduction"),
    proof=("lemma_13",),
)
def lemma_13(printed: Constants) -> Finding:
    """Squared distances of vertices of A~_d from the circumcentre differ by integer multiples of {unit}, and
    by no less."""
    return agree(printed, {"unit": fits(printed["unit"], "2/(d + 1)", _units())}, EVERY_D)


@claim("lem-13.reduction", "Appendix C, proof of Lemma 13", Weight.WORDING)
@told
def reduction(printed: Constants) -> Finding:
    """It is enough to compare the squared distance of z from c with that of {second}, the vertex of z's
    class."""
    simplex = triangulation("A~2").simplex
    z, u = point(1, (-2, 1, 0)), simplex.vertex_matrix.row(1)
    between = sum((a + b) ** 2 for a, b in zip(z, u, strict=True))  # the core's u is minus the paper's
    radius = simplex.squared_circumradius
    if printed["second"] == "u_k from c" or between == radius:
        return holds(EVERY_D, "The vertices u_k have the same distance R from c")
    return corrected(
        EVERY_D,
        "the distance of u_k from c is meant, which is R for each class",
        witness=f"in A~2, z = {show(z)}: the squared distance from u_1 is {between}, that of u_1 from c is "
        f"{radius}",
        evidence="the sentence before says that u_k is at the distance R from c; only that cancels",
        constants={"second": "u_k from c"},
    )


@claim("lem-13.indices", "Appendix C, proof of Lemma 13", Weight.WORDING)
def indices(printed: Constants) -> Finding:
    """The integers n_i of the two points have the indices {first} to {last}."""
    evidence = "the formula just before has n_0 … n_d, and n_0 is eliminated below"
    return agree(printed, {"first": 0, "last": "d"}, EVERY_D, evidence=evidence)


def _readable(formula: str) -> str:
    """With j and t for n and m, which formulas do not know."""
    return formula.replace("n", "j").replace("m", "t")


@claim("lem-13.difference", "Appendix C, proof of Lemma 13", Weight.PROOF)
def difference(printed: Constants) -> Finding:
    """The difference of squared distances is the sum over i of (n - m) times {term}, for integers n and m of
    one class k."""
    from ..symbolic.polynomials import is_zero, rational_function

    # coordinate by coordinate: no use is made of the sums
    ours = "(j + (k + d/2 - i)/(d + 1))**2 - (t + (k + d/2 - i)/(d + 1))**2"
    if is_zero(rational_function(f"(j - t)*({_readable(printed['term'])}) - ({ours})")):
        return holds(EVERY_D, "It is an identity for each coordinate")
    return corrected(EVERY_D, f"printed {printed['term']}; true: n + m + (2*k + d - 2*i)/(d + 1)")


@claim("lem-13.elimination", "Appendix C, proof of Lemma 13", Weight.PROOF, to_prove=("lem-12.sum",))
def elimination(printed: Constants) -> Finding:
    """n_0 is {first} minus the other n, and n_0 + m_0 is {sum} minus the sum of the others."""
    for d in (2, 4):
        for k, n in sample(d):
            if n[0] != evaluate(printed["first"], k=k) - sum(n[1:]):
                return corrected(EVERY_D, f"n_0 is -k minus the others, as for k = {k}")
            if 2 * n[0] != evaluate(printed["sum"], k=k) - 2 * sum(n[1:]):
                return corrected(EVERY_D, f"the sum is -2k minus the others, as for k = {k}")
    return holds(EVERY_D)


@claim("eq-6", "Appendix C, equation (6)", Weight.PROOF, to_prove=("lem-13.difference", "lem-13.elimination"))
def equation_6(printed: Constants) -> Finding:
    """The difference is the sum over i >= 1 of (n - m)({even}), s the sum of all n + m, plus {coefficient}
    times the sum of (n - m)({rest})."""
    for d in (2, 3, 4):
        members = sample(d)
        for k, n in members[:6]:
            for m in [m for other, m in members if other == k][:6]:
                exact = squared_distance(k, n) - squared_distance(k, m)
                if _right_side(printed, k, n, m) != exact:
                    return corrected(EVERY_D, f"for d = {d}, n = {n}, m = {m} the difference is {exact}")
    return holds(EVERY_D, "Put n_0 = -k - s/2 … into the difference and collect the terms with 1/(d + 1)")


def _right_side(printed: Constants, k: int, n: tuple[int, ...], m: tuple[int, ...]) -> Surd:
    d, s = len(n) - 1, sum(n[1:]) + sum(m[1:])
    coefficient = evaluate(printed["coefficient"], d=d)
    even = _readable(printed["even"]).replace("s", "i")
    total = Surd(0)
    for i, (a, b) in enumerate(zip(n[1:], m[1:], strict=True), 1):
        rest = evaluate(printed["rest"], d=d, k=k, i=i)
        total += (a - b) * (evaluate(even, j=a, t=b, i=s) + coefficient * rest)
    return total


@claim("lem-13.parity", "Appendix C, proof of Lemma 13", Weight.PROOF)
def parity(printed: Constants) -> Finding:
    r"""The first part is even: modulo 2, $\sum_i a_i(a_i + \sum_j a_j)$ is {middle}, which vanishes."""
    first_part = {a: sum(x * (x + sum(a)) for x in a) for d in (1, 2, 3) for a in product((0, 1), repeat=d)}
    if any(x % 2 for x in first_part.values()):
        return corrected(EVERY_D, "the first part is odd somewhere")
    if printed["middle"] not in MIDDLE:
        raise InvalidInput(f"{printed['middle']!r} is none of the expressions that are compared")
    middle = MIDDLE[printed["middle"]]
    a = next((a for a, x in first_part.items() if x != middle(a)), None)
    if a is None:
        words = "s² and s have the same parity, for s the sum of the a_i; and so have a_i² and a_i"
        return holds(EVERY_D, words)
    return corrected(
        EVERY_D,
        "as integers, it is the sum of the a_i² plus the square of the sum of the a_i; both have the parity "
        "of the sum of the a_i, so together they are even",
        witness=f"for a = ({', '.join(map(str, a))}) the left side is {first_part[a]}, the right {middle(a)}",
        evidence="modulo 2 both sides vanish, so the conclusion stands; the sum over j begins at 0, where "
        "there is no a_0",
        constants={"middle": "the sum of the a_i² plus the square of the sum of the a_i"},
    )


MIDDLE: dict[str, Callable[[tuple[int, ...]], int]] = {
    "twice the sum of a_i a_j over i ≠ j": lambda a: 2 * sum(x * y for x, y in permutations(a, 2)),
    "the sum of the a_i² plus the square of the sum of the a_i": lambda a: (
        sum(x * x for x in a) + sum(a) ** 2
    ),
}
"""What the middle may be."""
