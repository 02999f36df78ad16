"""The steps that the proofs of Propositions 8 to 14 have in common.

Each proof says when a point is a vertex, lists the positive roots, names a vector v that is a combination of
vertices, lists the roots that have an integer inner product with it, and finds that they span too little.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache, partial
from itertools import combinations
from typing import Any

from ..affine import CoxeterTriangulation
from ..exact import RationalMatrix, show
from ..lattices import spanned_lattice
from ..paper import prose
from ..root_lattices import Lattice
from .appendix_d_cases import Case, combination, dimensions, number, spelled, statement, witness
from .appendix_d_notes import DERIVATIONS, NOTES, RANK
from .appendix_d_roots import Roots, integral_roots, listed, positive_roots, rank
from .appendix_d_words import in_words
from .claim import Constants, Finding, claim, corrected, fails, holds
from .vectors import Point, minus
from .vocabulary import EVERY_D, FINITE, Strength, Weight
from .wording import told


def _strength(case: Case) -> Strength:
    return EVERY_D if case.infinite else FINITE


def judged(id: str, case: Case, good: bool, **more: Any) -> Finding:
    """The finding of a step: as printed, or with what the notes say of it."""
    lines = (*more.pop("derivation", ()), *DERIVATIONS.get(id, ()))
    if good:
        return holds(_strength(case), *lines)
    note = {"correction": "the constants differ", **more, **NOTES.get(id, {})}
    return corrected(_strength(case), note.pop("correction"), derivation=lines, **note)


# -- when a point is a vertex ------------------------------------------------------------------------------


def criterion(case: Case, printed: Constants) -> Finding:
    """Points with `rank` independent roots of integer inner product are the vertices."""
    good = all(
        (found >= number(printed["rank"], d)) == vertex
        for d in case.dimensions[:4]
        for found, vertex in _samples(case.at(d))
    )
    spaces = all(number(printed["space"], d) == d for d in case.dimensions)
    if good and spaces:
        return holds(EVERY_D, *RANK)
    note = {
        "correction": "the rank and the space have the dimension d",
        **NOTES.get(f"{case.id}.criterion", {}),
    }
    if good and number(printed["space"], 0) == _space(case.first):
        note["witness"] = _beside(case)
    return corrected(EVERY_D, note.pop("correction"), derivation=RANK, **note)


@lru_cache(maxsize=64)
def _samples(t: CoxeterTriangulation) -> tuple[tuple[int, bool], ...]:
    """For some points the rank of the roots with integer products, and whether they fold to a vertex."""
    u = t.simplex.vertex_matrix.rows()
    pairs = list(combinations(range(len(u)), 2))[:12]
    differences = [minus(u[j], u[i]) for i, j in pairs]
    halves = [tuple(x / 2 for x in row) for row in u[1:4]]
    images = [t.facets[k].reflect(row) for k, row in enumerate(u)]
    points = (*u, *differences, *halves, *images)
    return tuple((t.integral_roots(x).rank(), t.is_vertex(x)) for x in points)


def _beside(case: Case) -> str:
    """A point outside the span of the roots that is orthogonal to all of them."""
    t = case.first
    for i, j in combinations(range(_space(t)), 2):
        for sign in (1, -1):
            point = tuple(Fraction((k == i) + sign * (k == j)) for k in range(_space(t)))
            products = (t.roots.simple_roots @ RationalMatrix.from_rows([point]).T).numerators
            if not products.any():
                return (
                    f"{show(point)} is orthogonal to all roots, so all inner products are integers; it does "
                    "not lie in the space of the triangulation."
                )
    raise AssertionError("no such point has two coordinates")


# -- lists of roots ----------------------------------------------------------------------------------------


def roots(case: Case, printed: Constants) -> Finding:
    """The printed list is that of all positive roots."""
    id = f"{case.id}.roots"
    for d in case.dimensions:
        t = case.at(d)
        given, true = listed(printed, d, _space(t)), positive_roots(t)
        if given != true:
            return judged(id, case, False, witness=_compare(given, true))
    return judged(id, case, True)


def integral(case: Case, printed: Constants) -> Finding:
    """The printed list is that of all positive roots with an integer inner product with v."""
    id = f"{case.id}.integral-roots"
    for d in dimensions(case):
        t = case.at(d)
        given, true = listed(printed, d, _space(t)), integral_roots(t, witness(case, d))
        if given != true:
            return judged(id, case, False, witness=_compare(given, true))
    return judged(id, case, True)


def _space(t: CoxeterTriangulation) -> int:
    return int(t.roots.simple_roots.shape[1])


def _compare(given: Roots, true: Roots) -> str:
    """How two lists differ."""
    missing, surplus = sorted(true - given), sorted(given - true)
    words = [f"The list has {len(given & true)} of {len(true)} roots"]
    for what, vectors in (("missing", missing), ("too many", surplus)):
        if vectors:
            words.append(f"{what}: {', '.join(map(_show, vectors[:2]))}{', …' if len(vectors) > 2 else ''}")
    return "; ".join(words) + "."


def _show(twice: tuple[int, ...]) -> str:
    return show(tuple(Fraction(x, 2) for x in twice))


def span(case: Case, printed: Constants) -> Finding:
    """The roots of the printed list span the space of the given vectors, which has that dimension."""
    id = f"{case.id}.span"
    list_of_roots = prose()[f"{case.id}.integral-roots"]
    for d in dimensions(case):
        n = _space(case.at(d))
        given, space = listed(list_of_roots, d, n), listed(printed, d, n)
        ranks = {rank(given), rank(space), rank(given | space), len(space)}
        if ranks != {number(printed["dimension"], d)}:
            return judged(id, case, False)
    return judged(id, case, True)


# -- the witness -------------------------------------------------------------------------------------------


def combined(case: Case, printed: Constants) -> Finding:
    """The combination of vertices is the vector."""
    id = f"{case.id}.witness"
    for d in dimensions(case):
        true = combination(case, printed["terms"], d)
        if true != spelled(printed["vector"], d):
            return _wrong_witness(case, id, printed, true)
    return judged(id, case, True)


def _wrong_witness(case: Case, id: str, printed: Constants, true: Point) -> Finding:
    """The combination is another vector; is the printed one perhaps no combination of vertices at all?"""
    t, v = case.first, spelled(printed["vector"], case.dimensions[0])
    finding = judged(id, case, False, witness=f"The combination is {show(true)}.")
    if v != witness(case, t.dimension) or v in spanned_lattice(t):
        return finding
    vertices = Lattice(RationalMatrix.from_rows(t.simplex.vertex_matrix.rows()[1:]))
    return fails(
        _strength(case),
        f"{finding.witness} And {show(v)} is no integer combination of vertices, those of other simplices "
        "included.",
        f"This vector, {show(true)}, will do: it is a combination of vertices and no vertex, as the roots "
        f"with integer inner products have rank {t.integral_roots(true).rank()}.",
        constants=finding.constants,
        evidence=f"With respect to the vertices {show(v)} has the coefficients "
        f"{show(vertices.coordinates(v))}.",
    )


def no_vertex(case: Case, printed: Constants) -> Finding:
    """Whether v, the vector of the proof, is a vertex."""
    id = f"{case.id}.no-vertex"
    every = [(case.at(d), spelled(printed["vector"], d)) for d in dimensions(case)]
    if [v for _, v in every] != [witness(case, d) for d in dimensions(case)]:
        return judged(id, case, False, correction="the vector is another one than that of the proof")
    found = {t.is_vertex(v) for t, v in every}
    assert found == {t.is_vertex_by_rank(v) for t, v in every}
    if found == {printed["vertex"]}:
        return judged(id, case, True, derivation=(_ranks(case),))
    true = {**printed, "vertex": not printed["vertex"]}
    if id not in NOTES:
        return judged(id, case, False, constants=true)
    note: dict[str, Any] = dict(NOTES[id])
    instead = note.pop("correction")
    return fails(_strength(case), _ranks(case), instead, constants=true, **note)


def _ranks(case: Case) -> str:
    """The rank of the roots with integer products, in words."""
    d = dimensions(case)[0]
    t = case.at(d)
    whole = integral_roots(t, witness(case, d))
    name = f"${t.type.latex}$"
    return (
        f"{len(whole)} positive roots of {name} have integer inner products with {show(witness(case, d))}; "
        f"their rank is {rank(whole)}, a vertex needs {d}."
    )


# -- the claims --------------------------------------------------------------------------------------------

NOT_A_LATTICE = ("criterion", "roots", "witness", "integral-roots", "span", "no-vertex")
"""The steps of a proof that a vertex set is no lattice."""
CHECKS = {
    "criterion": criterion,
    "roots": roots,
    "witness": combined,
    "integral-roots": integral,
    "span": span,
    "no-vertex": no_vertex,
}
NEEDS = {
    "span": ("integral-roots",),
    "integral-roots": ("roots", "witness"),
    "no-vertex": ("criterion", "integral-roots", "span", "witness"),
}


def _vectors(case: Case, step: str) -> Constants:
    """What is recorded with the statements of the paper, not with its prose."""
    if step == "witness":
        s = statement(case, "combination")
        return {"terms": s.terms, "vector": s.normal}
    return {"vector": statement(case, "no vertex").normal} if step == "no-vertex" else {}


def _needs(case: Case, step: str) -> tuple[str, ...]:
    """The steps that a step uses, as far as the proof has them."""
    ids = (f"{case.id}.{name}" for name in NEEDS.get(step, ()))
    return tuple(id for id in ids if id in prose() or id.endswith("witness"))


def register_steps(case: Case, steps: tuple[str, ...]) -> None:
    """Enter the steps of a proof as claims."""
    for step in steps:
        id, vectors = f"{case.id}.{step}", _vectors(case, step)
        claim(
            id,
            case.place,
            Weight.PROOF,
            words=in_words(step, {**vectors, **prose().get(id, {})}),
            printed=vectors,
            to_state=("def-14", "def-16") if step == "criterion" else (),
            to_prove=("cor-1",) if step == "criterion" else _needs(case, step),
        )(told(partial(CHECKS[step], case)))
