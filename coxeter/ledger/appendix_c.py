"""Appendix C: the protection of A~. The statements are proved for every d in `coxeter.proofs.appendix_c`."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import product, takewhile

from ..affine import triangulation
from ..delaunay import protection, vertices_by_distance
from ..errors import InvalidInput
from ..exact import Surd
from ..families import closed_form, evaluate
from ..proofs import prove
from ..root_lattices import coweight_lattice
from .claim import Constants, Finding, agree, claim, corrected, holds, same
from .record_points import point_claims
from .records import formula_claims
from .vocabulary import EVERY_D, Weight

formula_claims(lambda f: f.place.startswith("Appendix C"))
point_claims(lambda p: p.place.startswith("Appendix C"))

LARGEST = 6
"""Vertices are enumerated up to this dimension."""


def for_every_d(a: str, b: str, low: int = 2) -> bool:
    """Whether two formulas in d are equal for every d."""
    from ..symbolic.radicals import equal_for_every_d

    return equal_for_every_d(a, b, low)


@claim("lem-12", "Appendix C, Lemma 12", Weight.RESULT, to_state=("def-19",), to_prove=("claim-c", "prop-7"))
def lemma_12(printed: Constants) -> Finding:
    """The relative protection of A~_d is {formula}."""
    true = closed_form("A", "relative_protection").pieces[0].text
    if for_every_d(printed["formula"], true):
        return holds(EVERY_D, proof=("relative_protection",))
    return corrected(EVERY_D, f"printed {printed['formula']}; true: {true}")


@claim("lem-12.coweights", "Appendix C, proof of Lemma 12", Weight.PROOF, to_prove=("prop-7",))
def coweights(printed: Constants) -> Finding:
    """The vertex set of A~_d is {lattice} of a root system of type A_d."""
    for d in range(2, LARGEST + 1):
        t = triangulation(("A", d))
        lattice = coweight_lattice(t.roots)
        if not all(x in lattice for x in t.simplex.vertex_matrix.rows()):
            return corrected(EVERY_D, f"a vertex of A~{d} is no coweight")
    return holds(EVERY_D, proof=("proposition_7",))


@claim("lem-12.basis", "Appendix C, proof of Lemma 12", Weight.WORDING)
def basis(printed: Constants) -> Finding:
    """The points u_k with k from {first} to d are a basis of the coweight lattice."""
    d = 3
    rows = list(triangulation(("A", d)).simplex.vertex_matrix.rows())[printed["first"] :]
    if printed["first"] < 0 or len(rows) < d:
        return corrected(EVERY_D, "too few points for a basis")
    if all(any(row) for row in rows):
        return holds(EVERY_D, "The u_k with k >= 1 are the fundamental coweights", proof=("vertices", "A"))
    return corrected(
        EVERY_D, "k from 1 to d: the text itself sums over these", witness="u_0 = 0 is in no basis",
        evidence="the next sentence has the right range", constants={"first": 1},
    )  # fmt: skip


@lru_cache(maxsize=8)
def sample(d: int) -> tuple[tuple[int, tuple[int, ...]], ...]:
    """Vertices of A~_d as pairs (k, n), with the coordinates n_i + k/(d + 1) and the sum of n equal to -k."""
    found = []
    for n in product(range(-2, 2), repeat=d + 1):
        if 0 <= -sum(n) <= d:
            found.append((-sum(n), n))
    return tuple(found[:: max(1, len(found) // 60)])


def point(k: int, n: tuple[int, ...]) -> tuple[Fraction, ...]:
    """The vertex with integers n and remainder k."""
    return tuple(x + Fraction(k, len(n)) for x in n)


def squared_distance(k: int, n: tuple[int, ...]) -> Fraction:
    """Its squared distance from the circumcentre."""
    d = len(n) - 1
    return sum(((x - Fraction(2 * i - d, 2 * (d + 1))) ** 2 for i, x in enumerate(point(k, n))), Fraction(0))


@claim("lem-12.remainder", "Appendix C, proof of Lemma 12", Weight.PROOF, to_prove=("lem-12.basis",))
def remainder(printed: Constants) -> Finding:
    """The coordinates of d + 1 times a vertex are integers {coordinate}, congruent to one k modulo {modulus}."""
    for d in (2, 3, 4):
        modulus = evaluate(printed["modulus"], d=d)
        if modulus != d + 1:
            return corrected(EVERY_D, f"printed modulus {printed['modulus']}; true: d + 1")
        for k, n in sample(d):
            left = [(d + 1) * x for x in point(k, n)]
            formula = printed["coordinate"].replace("n", "i")
            if left != [evaluate(formula, d=d, i=x, k=k) for x in n]:
                return corrected(EVERY_D, f"for d = {d} they are {left}")
    return holds(EVERY_D, "The coordinates of u_k are k/(d + 1) and that minus 1; sums keep the property")


@claim("lem-12.sum", "Appendix C, proof of Lemma 12", Weight.PROOF, to_prove=("lem-12.remainder",))
def sum_of_n(printed: Constants) -> Finding:
    """As the coordinates add up to 0, the integers n add up to {sum}."""
    for d in (2, 3, 5):
        for k, n in sample(d):
            if sum(n) + k != 0 or evaluate(printed["sum"], k=k) != sum(n):
                return corrected(EVERY_D, f"for d = {d}, k = {k} the sum is {sum(n)}")
    return holds(EVERY_D, r"$\sum (n_i + \frac{k}{d+1}) = \sum n_i + k$")


@claim("lem-12.asymptotic", "Appendix C, proof of Lemma 12", Weight.RESULT, to_prove=("lem-12",))
def asymptotic(printed: Constants) -> Finding:
    """The relative protection is asymptotically {middle}, and {last}."""
    from ..symbolic.radicals_limits import growth

    exact = growth(closed_form("A", "relative_protection").pieces[0].text)
    wrong = [name for name in ("middle", "last") if growth(printed[name]) != exact]
    if wrong:
        return corrected(EVERY_D, f"printed {printed[wrong[0]]}; true: 12/d**2")
    leading = for_every_d(printed["middle"], "12/(d**2 + 2*d)") and for_every_d(printed["last"], "12/d**2")
    return holds(EVERY_D, proof=("protection_rate",)) if leading else corrected(EVERY_D, "a lower term differs")


@claim("lem-13", "Appendix C, Lemma 13", Weight.PROOF, to_prove=("eq-6", "lem-13.parity", "lem-13.reduction"))
def lemma_13(printed: Constants) -> Finding:
    """Squared distances of vertices of A~_d from the circumcentre differ by integer multiples of {unit}, and by no less."""
    for d in (2, 3, 4, 5):
        unit = evaluate(printed["unit"], d=d).as_fraction()
        distances = {squared_distance(k, n) for k, n in sample(d)}
        least = min(distances)
        if any(((x - least) / unit).denominator != 1 for x in distances) or Fraction(2, d + 1) != unit:
            return corrected(EVERY_D, f"printed unit {printed['unit']}; true: 2/(d + 1)")
    return holds(EVERY_D, proof=("lemma_13",))


@claim("lem-13.reduction", "Appendix C, proof of Lemma 13", Weight.WORDING)
def reduction(printed: Constants) -> Finding:
    """It is enough to compare the squared distance of z from c with {second}, the squared distance of its class's vertex."""
    k, n = 1, (-2, 1, 0)
    u = triangulation("A~2").simplex.vertex_matrix.row(1)
    z = point(k, n)
    between = sum((a + b) ** 2 for a, b in zip(z, u, strict=True))
    radius = triangulation("A~2").simplex.squared_circumradius
    if printed["second"] == "d(u_k, c)^2" or between == radius:
        return holds(EVERY_D, "The vertices u_k have the same distance R from c")
    return corrected(
        EVERY_D, "the distance of u_k from c is meant, which is R for each class",
        witness=f"in A~2, z = {z}: the squared distance from u_1 is {between}, that of u_1 from c is {radius}",
        evidence="the sentence before says that u_k is at the distance R from c; only that cancels",
        constants={"second": "d(u_k, c)^2"},
    )  # fmt: skip


@claim("lem-13.indices", "Appendix C, proof of Lemma 13", Weight.WORDING)
def indices(printed: Constants) -> Finding:
    """The integers n_i of the two points have the indices {first} to {last}."""
    return agree(
        printed, {"first": 0, "last": "d"}, EVERY_D,
        evidence="the formula just before has n_0 … n_d, and n_0 is eliminated below",
    ) if not _is(printed["last"], "d") or printed["first"] else holds(EVERY_D)  # fmt: skip


def _is(a: str, b: str) -> bool:
    return same(a, b) or a == b


@claim("lem-13.difference", "Appendix C, proof of Lemma 13", Weight.PROOF)
def difference(printed: Constants) -> Finding:
    """The difference of squared distances is the sum over i of (n - m) times {term}, for integers n and m of one class k."""
    from ..symbolic.polynomials import is_zero, rational_function

    # coordinate by coordinate, with j and t for n and m: no use is made of the sums
    term = printed["term"].replace("n", "j").replace("m", "t")
    ours = "(j + (k + d/2 - i)/(d + 1))**2 - (t + (k + d/2 - i)/(d + 1))**2"
    if is_zero(rational_function(f"(j - t)*({term}) - ({ours})")):
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
    """The difference is the sum over i >= 1 of (n - m)({even}), s the sum of all n + m, plus {coefficient} times the sum of (n - m)({rest})."""
    for d in (2, 3, 4):
        members = sample(d)
        coefficient = evaluate(printed["coefficient"], d=d)
        for k, n in members[:6]:
            for m in [m for other, m in members if other == k][:6]:
                s = sum(n[1:]) + sum(m[1:])
                first = sum(((a - b) * _even(printed["even"], a, b, s) for a, b in zip(n[1:], m[1:], strict=True)), Surd(0))
                pairs = enumerate(zip(n[1:], m[1:], strict=True), 1)
                rest = sum(((a - b) * evaluate(printed["rest"], d=d, k=k, i=i) for i, (a, b) in pairs), Surd(0))
                exact = squared_distance(k, n) - squared_distance(k, m)
                if first + coefficient * rest != exact:
                    return corrected(EVERY_D, f"for d = {d}, n = {n}, m = {m} the difference is {exact}")
    return holds(EVERY_D, "Put n_0 = -k - s/2 … into the difference and collect the terms with 1/(d + 1)")


def _even(text: str, n: int, m: int, s: int) -> Surd:
    return evaluate(text.replace("n", "j").replace("m", "t").replace("s", "i"), j=n, t=m, i=s)


@claim("lem-13.parity", "Appendix C, proof of Lemma 13", Weight.PROOF)
def parity(printed: Constants) -> Finding:
    """The first part is even: the sum of a_i(a_i + sum of a_j) is, modulo 2, {middle}, which vanishes."""
    cases = [a for d in (1, 2, 3) for a in product((0, 1), repeat=d)]
    even = all(sum(x * (x + sum(a)) for x in a) % 2 == 0 for a in cases)
    if not even:
        return corrected(EVERY_D, "the first part is odd somewhere")
    formulas = {
        "2*sum over i of sum over j != i of a_i*a_j": lambda a: 2 * sum(a[i] * a[j] for i in range(len(a)) for j in range(len(a)) if i != j),
        "sum of a_i^2 + (sum of a_i)^2": lambda a: sum(x * x for x in a) + sum(a) ** 2,
    }
    if printed["middle"] not in formulas:
        raise InvalidInput(f"{printed['middle']!r} is none of the expressions that are compared")
    integral = [a for a in cases if sum(x * (x + sum(a)) for x in a) != formulas[printed["middle"]](a)]
    if not integral:
        return holds(EVERY_D, "s² and s have the same parity, for s the sum of the a_i; and so have a_i² and a_i")
    return corrected(
        EVERY_D, "as an identity of integers it is the sum of the a_i² plus the square of their sum; both have the parity of "
        "the sum, so together they are even", witness=f"for a = {integral[0]} the sides are not equal as integers",
        evidence="modulo 2 both sides vanish, so the conclusion stands; the sum over j begins at 0, where there is no a_0",
        constants={"middle": "sum of a_i^2 + (sum of a_i)^2"},
    )  # fmt: skip


@lru_cache(maxsize=8)
def second_closest(d: int) -> tuple[Fraction, int]:
    """The second smallest squared distance of a vertex of A~_d from c, and how many vertices have it."""
    t = triangulation(("A", d))
    nearest = protection(t).nearest[0].squared_distance
    found = list(takewhile(lambda x: x[0] <= nearest, vertices_by_distance(t)))
    return nearest, sum(square == nearest for square, _ in found)


@claim("claim-c", "Appendix C, Claim", Weight.RESULT, to_prove=("lem-13", "thm-7", "claim-c.gap", "claim-c.closest"))
def claim_c(printed: Constants) -> Finding:
    """In each remainder class {count} vertex is second closest to c, at the squared distance {distance}."""
    prove("second_closest")
    for d in range(2, LARGEST + 1):
        square, count = second_closest(d)
        if square != evaluate(printed["distance"], d=d) or count != evaluate(printed["count"]) * (d + 1):
            return corrected(EVERY_D, f"for d = {d} there are {count} vertices at the squared distance {square}")
    return holds(EVERY_D, proof=("second_closest",))


@claim("claim-c.closest", "Appendix C, Claim", Weight.RESULT, to_prove=("thm-7",))
def closest(printed: Constants) -> Finding:
    """In each remainder class the vertex closest to c is {points}, and no other."""
    for d in range(2, LARGEST + 1):
        t = triangulation(("A", d))
        radius = t.simplex.squared_circumradius
        near = [x for _, x in takewhile(lambda x: x[0] <= radius, vertices_by_distance(t))]
        if sorted(near) != sorted(t.simplex.vertex_matrix.rows()):
            return corrected(EVERY_D, f"for d = {d} other vertices are as close")
    return holds(EVERY_D, proof=("second_closest",))


@claim("claim-c.gap", "Appendix C, proof of the Claim", Weight.PROOF, to_prove=("lem-13",))
def gap(printed: Constants) -> Finding:
    """The least positive difference of squared distances is {gap}."""
    for d in range(2, LARGEST + 1):
        radius = triangulation(("A", d)).simplex.squared_circumradius
        if second_closest(d)[0] - radius != evaluate(printed["gap"], d=d):
            return corrected(EVERY_D, f"printed {printed['gap']}; true: 2/(d + 1)")
    return holds(EVERY_D, "Lemma 13 says that it is no less, the points of the Claim that it is attained", proof=("second_closest",))


@claim("rem-5", "Appendix C, Remark 5", Weight.RESULT, to_state=("claim-c",))
def remark_5(printed: Constants) -> Finding:
    """There are no other second closest points than the {points} of the Claim."""
    for d in range(2, LARGEST + 1):
        if second_closest(d)[1] != evaluate(printed["points"], d=d):
            return corrected(EVERY_D, f"for d = {d} there are {second_closest(d)[1]}")
    return holds(EVERY_D, "The paper leaves it out; the proof finds the distances of all vertices", proof=("second_closest",))
