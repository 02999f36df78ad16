"""Claims made from the paper's data: the printed vertices and centres, one claim each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache, partial

from ..claims.core import dimensions, simplex_of
from ..claims.points import (
    SIGN,
    agrees,
    compare_point,
    compare_points,
    exact_point,
    failures,
    similarity,
    vertex_numbers,
)
from ..claims.runs import Point, coordinates, numbers
from ..errors import CoxeterError
from ..exact import surd
from ..names import MINIMAL_DIMENSION
from ..paper import PrintedPoint, Runs, printed
from .claim import Constants, Finding, claim, corrected, holds
from .records import family_words, faulty, place_id, strength_for, unique
from .vocabulary import Weight


def point_claims(wanted: Callable[[PrintedPoint], bool]) -> None:
    """Enter a claim for each printed point that is wanted."""
    records = [p for p in printed().points if wanted(p)]
    for id, p in zip(unique(map(_id, records)), records, strict=True):
        index = f" $u_{{{p.index}}}$" if p.name == "vertex" else f" {p.index}" if p.index else ""
        name = p.name.replace("_", " ") + index
        where = f" for k from {p.first} to {p.last}" if p.first else ""
        is_vertex = p.name == "vertex" and p.family != "G2"
        claim(
            id,
            p.place,
            Weight.RESULT if p.name in ("vertex", "circumcentre", "incentre") else Weight.PROOF,
            words=f"The {name} of the fundamental simplex of {family_words(p.family)} is ({{point}}){where}.",
            printed={"point": p.runs} | _range(p),
            to_state=("def-16",) if is_vertex else (),
            to_prove=(f"sec6.{p.family}.item-1",) if is_vertex else (),
        )(partial(judge_point, p))


def _id(p: PrintedPoint) -> str:
    index = p.index.replace(" ", "").replace("-", "minus")
    name = "u" if p.name == "vertex" else p.name.replace("_", "-")
    return f"{place_id(p.place, p.family)}.{name}" + (f"-{index}" if index else "")


def _range(p: PrintedPoint) -> dict[str, str]:
    """The constants of a point that stands for several."""
    return {"first": p.first, "last": p.last} if p.first else {}


def completeness_claims(place: str) -> None:
    """Enter a claim for each family whose vertices a place lists: that none is missing."""
    for family in dict.fromkeys(p.family for p in printed().points if p.place == place):
        id = f"{place_id(place, family)}.complete"
        words = f"The list has all vertices of {family_words(family)}."
        claim(id, place, Weight.RESULT, words=words)(partial(judge_list, place, family))


def judge_list(place: str, family: str, _: Constants) -> Finding:
    """The verdict on a list of vertices: whether one is missing."""
    found = compare_points(printed(), lambda p: (p.place, p.family) == (place, family))
    missing = [c for c in found if c.note == "no such vertex is printed"]
    if not missing:
        return holds(strength_for(family))
    words = f"the list lacks {missing[0].quantity}"
    return corrected(strength_for(family), words, witness=str(missing[0].exact))


def judge_point(p: PrintedPoint, constants: Constants) -> Finding:
    """The verdict on a printed point, with any coordinates and range in place of the printed ones."""
    first, last = constants.get("first", ""), constants.get("last", "")
    asked = replace(p, runs=constants["point"], first=first, last=last)
    right = _is_similar(p, asked) if p.family == "G2" else _is_right(asked)
    if right and constants.get("label", p.label) in (None, _true_label(p)):
        return holds(strength_for(p.family), proof=_proof(p))
    as_printed = asked == p and "label" not in constants
    return _finding(p) if as_printed else corrected(strength_for(p.family), "")


def _proof(p: PrintedPoint) -> tuple[str, ...]:
    if p.family not in MINIMAL_DIMENSION:
        return ()
    if p.name.startswith("mirror"):
        return ("second_closest",)
    radius = {"circumcentre": "circumradius", "incentre": "inradius"}.get(p.name)
    return ("quantity", p.family, radius) if radius else ("vertices", p.family)


# -- whether a point is right -----------------------------------------------------------------------------


G2_ORDER = (1, 2, 0)
"""Which of the core's vertices the printed u_0, u_1, u_2 are; they follow each other counterclockwise."""


def _is_similar(p: PrintedPoint, asked: PrintedPoint) -> bool:
    """Whether the triangle with this corner is the core's, up to a similarity that keeps its sense."""
    printed_ones = [q for q in printed().points if (q.place, q.family) == (p.place, "G2")]
    corners = [coordinates((asked if q.index == p.index else q).runs, 2, 0) for q in printed_ones]
    points: list[Point] = [x for x in corners if x is not None and len(x) == 2]
    order, _ = similarity(points, simplex_of("G2", 2).squared_edge_lengths)
    if order != G2_ORDER:
        return False
    (a, b), (c, d), (e, f) = (tuple(map(surd, x)) for x in points)
    return (c - a) * (f - b) > (e - a) * (d - b)


def _is_right(p: PrintedPoint) -> bool:
    if p.family not in MINIMAL_DIMENSION:
        return not failures(p, p.family)
    try:
        return _has_its_range(p) and _is_right_early(p) and _is_right_for_every_d(p)
    except (CoxeterError, KeyError):
        return False


def _has_its_range(p: PrintedPoint) -> bool:
    """Whether a point with an index stands for all vertices that the rest of its list leaves out."""
    if not p.first:
        return True
    low = MINIMAL_DIMENSION[p.family]
    as_printed = next(q for q in printed().points if q.line == p.line)
    return all(set(vertex_numbers(p, d)) == _numbers_left(as_printed, d) for d in range(low, low + 6))


def _is_right_early(p: PrintedPoint) -> bool:
    """Whether a point is right in one small dimension: most wrong ones are not, and this is soon seen."""
    d = MINIMAL_DIMENSION[p.family] + 2
    return all(0 <= k <= d and agrees(p, p.family, d, k) for k in vertex_numbers(p, d))


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
def _is_right_for_every_d(p: PrintedPoint) -> bool:
    """Compare with the vertices that are proved, class of nodes by class of nodes."""
    from ..proofs.classical import FAMILIES, vector
    from ..symbolic.cases import case
    from ..symbolic.runs import runs, same

    if p.name.startswith("mirror"):
        return _is_mirror_vertex(p)
    family = FAMILIES[p.family]
    signed = tuple((f"{SIGN.get(p.family, 1)}*({x})", n) for x, n in p.runs)
    every_d = case(f"{family.first} <= d")
    if p.name in ("circumcentre", "incentre"):
        return same(runs(*signed), getattr(family, p.name), every_d)
    wanted = {d: set(vertex_numbers(p, d)) for d in range(family.first, family.first + 6)}
    if not all(ks <= set(range(d + 1)) for d, ks in wanted.items()):
        return False
    for nodes in family.nodes:
        if not any(ks & set(numbers(nodes.low, nodes.high, d)) for d, ks in wanted.items()):
            continue
        one_of_many = nodes.index == "k" and not p.first
        index = f"({p.index if one_of_many else nodes.index})"
        range_ = every_d if one_of_many else family.range(nodes)
        if not same(vector(signed, index), vector(nodes.vertex, index), range_):
            return False
    return True


def _is_mirror_vertex(p: PrintedPoint) -> bool:
    """The mirror image of u_k in the facet opposite to it, for every d.

    It is u_k - s_k, and for k = 0 the highest root.
    """
    from ..proofs.classical import FAMILIES, root, vertex
    from ..symbolic.cases import case
    from ..symbolic.polynomials import is_zero
    from ..symbolic.runs import runs, same, total_of

    first, rest = FAMILIES["A"].nodes
    shift = f" + ({p.index})/(d + 1)" if p.name == "mirror_shift" else ""
    point = runs(*((f"-(({x}){shift})", n) for x, n in p.runs))
    if not p.first:
        return same(point, root(first), case("2 <= d"))
    range_ = case(f"{p.first} <= k <= {p.last}")
    return is_zero(total_of([point, vertex(rest), root(rest)], range_, lambda x: (x[0] - x[1] + x[2]) ** 2))


# -- what is wrong with it --------------------------------------------------------------------------------


@lru_cache(maxsize=512)
def _finding(p: PrintedPoint) -> Finding:
    comparison = compare_point(printed(), p)
    true = _true_runs(p)
    label = {} if p.label is None else {"label": _true_label(p)}
    constants = {"point": true, **label, **_range(p)} if true else None
    correction = f"printed {comparison.printed}; {comparison.note}"
    return faulty(strength_for(p.family), comparison, correction, constants=constants)


def _true_label(p: PrintedPoint) -> str:
    """What should stand in front of a point."""
    return {"vertex": f"u_{p.index}", "circumcentre": "c", "incentre": "c_in"}.get(p.name, p.name)


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
