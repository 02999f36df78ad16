"""Claims made from the paper's data: the printed vertices and centres, one claim each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any

from ..claims.core import dimensions, simplex_of
from ..claims.outcomes import Outcome
from ..claims.points import (
    SIGN,
    compare_point,
    compare_points,
    exact_point,
    failures,
    similarity,
    vertex_numbers,
)
from ..claims.runs import coordinates
from ..exact import surd
from ..errors import CoxeterError
from ..names import MINIMAL_DIMENSION
from ..paper import PrintedPoint, Runs, printed
from .claim import Claim, Constants, Finding, corrected, damaged, holds, register
from .records import family_words, place_id, strength_for, unique
from .vocabulary import Weight


def point_claims(wanted: Callable[[PrintedPoint], bool]) -> None:
    """Enter a claim for each printed point that is wanted."""
    records = [p for p in printed().points if wanted(p)]
    for id, p in zip(unique(map(_id, records)), records, strict=True):
        name = p.name.replace("_", " ") + (f" {p.index}" if p.index else "")
        where = f" for k from {p.first} to {p.last}" if p.first else ""
        words = f"The {name} of the fundamental simplex of {family_words(p.family)} is ({{point}}){where}."
        constants = {"point": p.runs} | ({"first": p.first, "last": p.last} if p.first else {})
        weight = Weight.RESULT if p.name in ("vertex", "circumcentre", "incentre") else Weight.PROOF
        needs = (
            (("def-16",), (f"sec6.{p.family}.item-1",))
            if p.name == "vertex" and p.family != "G2"
            else ((), ())
        )
        register(
            Claim(id, p.place, words, weight, _check(p), constants, *needs, code=f"{__name__}.judge_point")
        )


def completeness_claims(place: str) -> None:
    """Enter a claim for each family whose vertices a place lists: that none is missing."""
    for family in dict.fromkeys(p.family for p in printed().points if p.place == place):
        words = f"The list has all vertices of {family_words(family)}."
        check = _complete_check(place, family)
        code = f"{__name__}.judge_point"
        register(Claim(f"{place_id(place, family)}.complete", place, words, Weight.RESULT, check, code=code))


def _complete_check(place: str, family: str) -> Callable[[Constants], Finding]:
    def check(_: Constants) -> Finding:
        found = compare_points(printed(), lambda p: (p.place, p.family) == (place, family))
        missing = [c for c in found if c.note == "no such vertex is printed"]
        if missing:
            return corrected(
                strength_for(family), f"the list lacks {missing[0].quantity}", witness=str(missing[0].exact)
            )
        return holds(strength_for(family))

    return check


def _id(p: PrintedPoint) -> str:
    index = p.index.replace(" ", "").replace("-", "minus") if p.index else ""
    name = "u-" + index if p.name == "vertex" else p.name.replace("_", "-") + (f"-{index}" if index else "")
    return f"{place_id(p.place, p.family)}.{name}"


def _check(p: PrintedPoint) -> Callable[[Constants], Finding]:
    def check(constants: Constants) -> Finding:
        return judge_point(p, constants)

    return check


def judge_point(p: PrintedPoint, constants: Constants) -> Finding:
    """The verdict on a printed point, with any coordinates and range in place of the printed ones."""
    asked = replace(
        p, runs=constants["point"], first=constants.get("first", ""), last=constants.get("last", "")
    )
    right = _is_similar(p, asked) if p.family == "G2" else _is_right(asked)
    if right and (p.label is None or constants.get("label") or asked != p):
        return holds(strength_for(p.family), proof=_proof(p))
    return _finding(p) if asked == p else corrected(strength_for(p.family), "")


def _proof(p: PrintedPoint) -> tuple[str, ...]:
    if p.family not in MINIMAL_DIMENSION:
        return ()
    if p.name.startswith("mirror"):
        return ("second_closest",)
    by_name = {
        "circumcentre": ("quantity", p.family, "circumradius"),
        "incentre": ("quantity", p.family, "inradius"),
    }
    return by_name.get(p.name, ("vertices", p.family))


G2_ORDER = (1, 2, 0)
"""Which of the core's vertices the printed u_0, u_1, u_2 are; they follow each other counterclockwise."""


def _is_similar(p: PrintedPoint, asked: PrintedPoint) -> bool:
    """Whether the triangle with this corner is the core's, up to a similarity that keeps its sense."""
    corners = [
        asked if q.index == p.index else q for q in printed().points if (q.place, q.family) == (p.place, "G2")
    ]
    points = [x for x in (coordinates(q.runs, 2, 0) for q in corners) if x is not None and len(x) == 2]
    order, _ = similarity(points, simplex_of("G2", 2).squared_edge_lengths)
    if order != G2_ORDER:
        return False
    (a, b), (c, d), (e, f) = (tuple(map(surd, x)) for x in points)
    return (c - a) * (f - b) > (e - a) * (d - b)


def _is_right(p: PrintedPoint) -> bool:
    if p.family not in MINIMAL_DIMENSION:
        return not failures(p, p.family)
    try:
        return _has_its_range(p) and _is_right_for_every_d(p)
    except (CoxeterError, KeyError):
        return False


def _has_its_range(p: PrintedPoint) -> bool:
    """Whether a point with an index stands for all vertices that the rest of its list leaves out."""
    low = MINIMAL_DIMENSION[p.family]
    same = [q for q in printed().points if q.line == p.line][0]
    return not p.first or all(
        set(vertex_numbers(p, d)) == _numbers_left(same, d) for d in range(low, low + 6)
    )


@lru_cache(maxsize=512)
def _is_right_for_every_d(p: PrintedPoint) -> bool:
    """Compare with the vertices that are proved, class of nodes by class of nodes."""
    from ..proofs.classical import FAMILIES, vertex
    from ..symbolic.cases import case
    from ..symbolic.runs import RunVector, runs, same

    family = FAMILIES[p.family]
    sign = SIGN.get(p.family, 1)

    def given(index: str) -> RunVector:
        pairs = [(x.replace("k", f"({index})"), n.replace("k", f"({index})")) for x, n in p.runs]
        return runs(*((f"{sign}*({x})", n) for x, n in pairs))

    if p.name in ("circumcentre", "incentre"):
        return same(given("0"), getattr(family, p.name), case(f"{family.first} <= d"))
    if p.name.startswith("mirror"):
        return _is_mirror_vertex(p)
    ds = range(family.first, family.first + 6)
    wanted = {d: set(vertex_numbers(p, d)) for d in ds}
    if not all(wanted[d] <= set(range(d + 1)) for d in ds):
        return False
    for nodes in family.nodes:
        held = {d: {k for k in range(d + 1) if _node_in(nodes, k, d)} & wanted[d] for d in ds}
        if not any(held.values()):
            continue
        if nodes.index == "k" and not p.first:  # one vertex of a class
            whole = case(f"{family.first} <= d")
            if not same(
                given(p.index),
                runs(*((x.replace("k", p.index), n.replace("k", p.index)) for x, n in nodes.vertex)),
                whole,
            ):
                return False
        elif not same(given(nodes.index), vertex(nodes), family.range(nodes)):
            return False
    return True


def _node_in(nodes: Any, k: int, d: int) -> bool:
    from ..proofs.simplices import node

    return node(nodes.low, d=d) <= k <= node(nodes.high, d=d)


def _is_mirror_vertex(p: PrintedPoint) -> bool:
    """The mirror image of u_k in the facet opposite to it, for every d: u_k - s_k, and for k = 0 the highest root."""
    from ..proofs.classical import FAMILIES, root, vertex
    from ..symbolic.cases import case
    from ..symbolic.polynomials import is_zero
    from ..symbolic.runs import runs, total_of

    first, rest = FAMILIES["A"].nodes
    shift = f" + ({p.index})/(d + 1)" if p.name == "mirror_shift" else ""
    point = runs(*((f"-(({x}){shift})", n) for x, n in p.runs))
    if not p.first:
        whole = case("2 <= d")
        return is_zero(total_of([point, root(first)], whole, lambda x: (x[0] - x[1]) ** 2))
    range_ = case(f"{p.first} <= k <= {p.last}")
    return is_zero(total_of([point, vertex(rest), root(rest)], range_, lambda x: (x[0] - x[1] + x[2]) ** 2))


@lru_cache(maxsize=64)
def _numbers_left(p: PrintedPoint, d: int) -> frozenset[int]:
    """The vertices that the other points of a list leave for this one."""
    others = [q for q in printed().points if (q.place, q.name) == (p.place, p.name) and q.line != p.line]
    meant = [q for q in others if _meant_family(q) == p.family]
    return frozenset(range(d + 1)) - {k for q in meant for k in vertex_numbers(q, d)}


@lru_cache(maxsize=256)
def _meant_family(p: PrintedPoint) -> str:
    return compare_point(printed(), p).family


@lru_cache(maxsize=512)
def _finding(p: PrintedPoint) -> Finding:
    comparison = compare_point(printed(), p)
    strength = strength_for(p.family)
    true = _true_runs(p)
    correction = f"printed {comparison.printed}; {comparison.note}"
    constants: Constants = {"point": true, "label": "right"} if true else None  # type: ignore[assignment]
    if constants and p.first:
        constants = {**constants, "first": p.first, "last": p.last}
    if comparison.outcome is Outcome.TRANSCRIPTION:
        return damaged(strength, correction, comparison.evidence, constants=constants)
    return corrected(strength, correction, evidence=comparison.evidence, constants=constants)


def _true_runs(p: PrintedPoint) -> Runs | None:
    """The right coordinates as runs; None if the point belongs to another family."""
    if p.name == "mirror_vertex":
        return tuple((f"({x})/(d + 1)", n) for x, n in p.runs)
    if p.label is not None:
        return p.runs
    if len(dimensions(p.family)) > 1:
        return None
    exact = exact_point(p.family, p.name, dimensions(p.family)[0], vertex_numbers(p, 8)[0])
    return tuple((str(x), "1") for x in exact)
