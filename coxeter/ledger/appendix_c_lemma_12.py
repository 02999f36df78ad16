"""Appendix C, Lemma 12: the relative protection of A~; its formulas and points are in the paper's data."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..claims.points import exact_point
from ..errors import InvalidInput
from ..exact import rational
from ..families import closed_form, evaluate
from ..root_lattices import Lattice, coweight_lattice
from .appendix_c_vertices import LARGEST, point, sample
from .claim import BrokenTool, Constants, Finding, claim, corrected, holds, same
from .instances import of_type
from .record_formulas import formula_claims
from .record_points import point_claims
from .vocabulary import EVERY_D, Weight
from .wording import told

formula_claims(lambda f: f.place.startswith("Appendix C"))
point_claims(lambda p: p.place.startswith("Appendix C"))


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
    if printed["lattice"] != "the coweight lattice":
        return corrected(EVERY_D, f"printed {printed['lattice']}; true: the coweight lattice")
    for t in of_type("A", LARGEST):
        lattice = coweight_lattice(t.roots)
        if not all(x in lattice for x in t.simplex.vertex_matrix.rows()):
            return corrected(EVERY_D, f"a vertex of {t.name} is no coweight")
    return holds(EVERY_D, proof=("proposition_7",))


@claim("lem-12.basis", "Appendix C, proof of Lemma 12", Weight.WORDING)
@told
def basis(printed: Constants) -> Finding:
    """The points u_k with k from {first} to d are a basis of the coweight lattice."""
    first = printed["first"]
    for t in of_type("A", LARGEST):
        if not 0 <= first <= t.dimension:
            raise InvalidInput(f"{t.name} has no vertex {first}: give 0 to {t.dimension}")
        points = t.simplex.vertex_matrix.rows()[first:]
        if not _is_basis(points, coweight_lattice(t.roots)):
            zero = [k for k, u in enumerate(points, first) if not any(u)]
            return corrected(
                EVERY_D,
                "k from 1 to d: the text itself sums over these",
                witness=f"u_{zero[0]} = 0 is in no basis" if zero else f"{t.name} has rank {t.dimension}",
                evidence="the next sentence has the right range",
                constants={"first": 1},
            )
    return holds(EVERY_D, "The u_k with k >= 1 are the fundamental coweights", proof=("vertices", "A"))


def _is_basis(points: Iterable[Sequence[object]], lattice: Lattice) -> bool:
    try:
        return Lattice.spanned_by(points) == lattice
    except InvalidInput:  # they are dependent
        return False


@claim("lem-12.remainder", "Appendix C, proof of Lemma 12", Weight.PROOF, to_prove=("lem-12.basis",))
def remainder(printed: Constants) -> Finding:
    """The coordinates of {times} times a vertex are integers {coordinate}, congruent to one k modulo
    {modulus}: it is a remainder-k point."""
    without_factor = same(printed["times"], "1")
    formula = printed["coordinate"].replace("n", "i")
    for d in (2, 3, 4):
        if not without_factor and evaluate(printed["times"], d=d) != d + 1:
            return corrected(EVERY_D, f"printed {printed['times']} times the vertex; true: d + 1 times")
        if evaluate(printed["modulus"], d=d) != d + 1:
            return corrected(EVERY_D, f"printed modulus {printed['modulus']}; true: d + 1")
        for k, n in sample(d):
            left = [(d + 1) * x for x in point(k, n)]
            if left != [evaluate(formula, d=d, i=x, k=k) for x in n]:
                return corrected(EVERY_D, f"for d = {d} they are {left}")
    if without_factor:
        return corrected(
            EVERY_D, "the coordinates of d + 1 times the point are meant (times: printed 1, true d + 1)",
            witness=f"the coordinates of u_1 in A~2 are {_broken_coordinates()}: no integers",
            evidence="the sentence before has the factor", constants={**printed, "times": "d + 1"},
        )  # fmt: skip
    return holds(EVERY_D, "The coordinates of u_k are k/(d + 1) and that minus 1; sums keep the property")


def _broken_coordinates() -> str:
    """The coordinates of the paper's u_1 in A~2."""
    coordinates = exact_point("A", "vertex", 2, 1)
    if all(rational(x).denominator == 1 for x in coordinates):
        raise BrokenTool("the vertex u_1 of A~2 has integer coordinates")
    return ", ".join(map(str, coordinates))


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
    if for_every_d(printed["middle"], "12/(d**2 + 2*d)") and for_every_d(printed["last"], "12/d**2"):
        return holds(EVERY_D, proof=("protection_rate",))
    return corrected(EVERY_D, "a lower term differs")
