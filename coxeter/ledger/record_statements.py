"""Claims made from the paper's data: facets, and sentences that name a vertex, a facet or an edge.

For the infinite families two routes must agree: symbolic vectors for every d, and the core in small dimensions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any

from ..claims.core import dimensions
from ..claims.outcomes import Outcome
from ..claims.points import SIGN
from ..claims.runs import coordinates, numbers
from ..claims.statements import KINDS, compare_statement
from ..errors import CoxeterError
from ..exact import surd
from ..families import closed_form, evaluate
from ..names import MINIMAL_DIMENSION
from ..paper import PrintedStatement, printed
from .claim import Claim, Constants, Equivalent, Finding, corrected, damaged, holds, register, spell
from .records import family_words, place_id, strength_for, unique
from .vocabulary import Weight

CONSTANTS = {
    "facet": ("normal", "text"),
    "distance": ("vertex", "facet", "text"),
    "minimal": ("first", "last"),
    "longest": (),
    "level": ("facet", "vertex", "text"),
    "product": ("text",),
    "space": ("text",),
}
"""The entries of a record that can be moved; the other ends of a longest edge may well be as good."""

WORDS = {
    "facet": "The facet {facet} of {family} lies in the hyperplane with normal ({normal}) and value {text}.",
    "distance": "From the vertex {vertex} of {family} to the facet {facet} it is {text}.",
    "minimal": "The least heights of {family} are those from the vertices {first} to {last}.",
    "longest": "In {family} the edge from vertex {first} to vertex {last} is a longest one.",
    "level": "The normal of the facet {facet} of {family} and the point {vertex} have the inner product {text}.",
    "product": "The normal ({normal}) and the point {vertex} of {family} have the inner product {text}.",
    "space": "The vertices of {family} are given in a space of dimension {text}.",
}
SECOND_ROUTE = 8
"""Up to this d the core computes what symbolic vectors prove for every d."""


def statement_claims(wanted: Callable[[PrintedStatement], bool]) -> None:
    """Enter a claim for each printed statement that is wanted."""
    records = [s for s in printed().statements if wanted(s) and s.kind in WORDS]
    for id, s in zip(unique(map(_id, records)), records, strict=True):
        entries = {name: getattr(s, name) for name in CONSTANTS[s.kind] if getattr(s, name)}
        fixed = {
            name: getattr(s, name)
            for name in ("facet", "vertex", "first", "last", "normal")
            if name not in entries
        }
        words = WORDS[s.kind].replace("{family}", family_words(s.family))
        for name, value in fixed.items():
            words = words.replace(f"{{{name}}}", spell(value))
        words += f" (k from {s.first} to {s.last})" if s.kind == "facet" and s.first else ""
        weight = Weight.RESULT if s.kind in ("facet", "space") else Weight.PROOF
        code = f"{__name__}.judge_statement"
        register(Claim(id, s.place, words, weight, _check(s), entries, ("def-16",), (), code))


def _id(s: PrintedStatement) -> str:
    what = {"level": "inner-product", "product": "inner-product", "minimal": "least-height"}.get(
        s.kind, s.kind
    )
    what += f"-{s.facet}".replace(" ", "").replace("d-", "dminus") if s.kind == "facet" else ""
    what += f"-{s.vertex}" if s.kind in ("level", "product") else ""
    return f"{place_id(s.place, s.family)}.{what.replace('-d - 2', '-dminus2')}"


def _check(s: PrintedStatement) -> Callable[[Constants], Finding]:
    def check(constants: Constants) -> Finding:
        return judge_statement(s, constants)

    return check


def judge_statement(s: PrintedStatement, constants: Constants) -> Finding:
    """The verdict on a printed statement, with any constants in place of the printed ones."""
    moved = {name: value for name, value in constants.items() if name not in ("low", "right")}
    asked = replace(s, **moved)
    low = int(constants.get("low", s.low))
    if s.kind == "facet" and asked != s and _same_hyperplane(asked, s):
        raise Equivalent("a multiple of an equation says the same")
    if _is_right(asked, low):
        return holds(strength_for(s.family), proof=_proof(s))
    return _finding(s) if asked == s and low == s.low else corrected(strength_for(s.family), "")


def _same_hyperplane(s: PrintedStatement, t: PrintedStatement) -> bool:
    """Whether two equations are multiples of each other."""
    d = max(dimensions(s.family)[0], 5) if s.family in MINIMAL_DIMENSION else dimensions(s.family)[0]
    k = numbers(s.first or s.facet, s.first or s.facet, d)[0]
    one, other = ((*(coordinates(x.normal, d, k) or ()), evaluate(x.text, d=d)) for x in (s, t))
    if len(one) != len(other) or not any(one):
        return False
    return all(
        surd(a) * y == surd(x) * b
        for a, x in zip(one, other, strict=True)
        for b, y in zip(one, other, strict=True)
    )


def _proof(s: PrintedStatement) -> tuple[str, ...]:
    if s.family not in MINIMAL_DIMENSION:
        return ()
    return {
        "facet": ("vertices", s.family),
        "distance": ("quantity", s.family, "minimal_height"),
        "minimal": ("quantity", s.family, "minimal_height"),
        "longest": ("quantity", s.family, "longest_edge"),
        "level": ("position_of_circumcentre", s.family),
    }.get(s.kind, ())


def _is_right(s: PrintedStatement, low: int) -> bool:
    """Whether a statement holds from its first dimension on, and that is the first for which it does."""
    if s.family not in MINIMAL_DIMENSION:
        return _holds_in(s, dimensions(s.family)[0])
    first = max(low, MINIMAL_DIMENSION[s.family])
    if low and (first != low or (first > MINIMAL_DIMENSION[s.family] and _holds_in(s, first - 1))):
        return False
    small = all(_holds_in(s, d) for d in range(first, SECOND_ROUTE + 1))
    try:
        every = _EVERY_D[s.kind](s, first)
    except (CoxeterError, KeyError):
        every = False
    if every and not small:
        raise AssertionError(f"two routes disagree on {s.place}, {s.kind}")
    return every


def _holds_in(s: PrintedStatement, d: int) -> bool:
    try:
        return KINDS[s.kind](s, d).holds
    except (CoxeterError, IndexError, ZeroDivisionError):
        return False


# -- for every d -----------------------------------------------------------------------------------------------


def _vectors(family: str, index: str, first: int) -> tuple[Any, Any, Any]:
    """The root and the vertex of a node, and a range in which they are told."""
    from ..proofs.classical import FAMILIES, vector
    from ..proofs.simplices import node
    from ..symbolic.cases import case

    for nodes in FAMILIES[family].nodes:
        ds = range(first, first + 6)
        if nodes.index == "k" and index == "k":
            return (
                vector(nodes.root, "k"),
                vector(nodes.vertex, "k"),
                case(f"{nodes.low} <= k <= {nodes.high}"),
            )
        if index != "k" and all(
            node(nodes.low, d=d) <= node(index, d=d) <= node(nodes.high, d=d) for d in ds
        ):
            at = f"({index})"
            return vector(nodes.root, at), vector(nodes.vertex, at), case(f"{first} <= d")
    raise KeyError(index)


def _facet(s: PrintedStatement, first: int) -> bool:
    """The normal is a multiple of the root, and so is the value."""
    from ..symbolic.polynomials import is_zero
    from ..symbolic.runs import runs, total_of

    root, _, range_ = _vectors(s.family, s.facet, first)
    if s.first:
        ds = range(first, first + 6)
        others = [
            t for t in printed().statements if (t.place, t.kind) == (s.place, s.kind) and t.line != s.line
        ]
        left = [set(range(d + 1)) - {numbers(t.facet, t.facet, d)[0] for t in others} for d in ds]
        if [set(numbers(s.first, s.last, d)) for d in ds] != left:
            return False
        if s.family != "A" and "k" in s.facet:
            return all(_facet_at(s, index, first) for index in _indices(s, first))
    sign = SIGN.get(s.family, 1)
    for factor in ("1", "-1", "1/2"):
        normal = runs(*((f"({factor})*({sign})*({x})", n) for x, n in s.normal))
        offset = "1" if s.facet == "0" else "0"
        if is_zero(total_of([normal, root], range_, lambda x: (x[0] - x[1]) ** 2)):
            return range_.equal(f"({factor})*({s.text})", offset)
        if s.family == "C" and s.facet == "d":
            twice = runs(*((f"2*({x})", n) for x, n in s.normal))
            return is_zero(total_of([twice, root], range_, lambda x: (x[0] - x[1]) ** 2)) and s.text == "0"
    return False


def _indices(s: PrintedStatement, first: int) -> list[str]:
    """The nodes among those of the family that the statement's range holds."""
    from ..proofs.classical import FAMILIES
    from ..proofs.simplices import node

    def inside(index: str, d: int) -> bool:
        return node(index, d=d) in numbers(s.first, s.last, d)

    nodes = FAMILIES[s.family].nodes
    return [n.index for n in nodes if n.index == "k" or inside(n.index, first + 5)]


def _facet_at(s: PrintedStatement, index: str, first: int) -> bool:
    from ..symbolic.polynomials import is_zero
    from ..symbolic.runs import runs, total_of

    root, _, range_ = _vectors(s.family, index, first)
    normal = runs(*((x.replace("k", f"({index})"), n.replace("k", f"({index})")) for x, n in s.normal))
    return is_zero(total_of([normal, root], range_, lambda x: (x[0] - x[1]) ** 2)) and s.text == "0"


def _distance(s: PrintedStatement, first: int) -> bool:
    """Level over the length of the root, squared."""
    from ..symbolic.runs import inner

    root, _, range_ = _vectors(s.family, s.facet, first)
    _, vertex, _ = _vectors(s.family, s.vertex, first)
    level = inner(root, vertex, range_)
    level = 1 - level if s.facet == "0" else level
    return range_.equal_value(
        f"({s.text})**2", level**2 / inner(root, root, range_)
    ) and not s.text.startswith("-")


def _minimal(s: PrintedStatement, first: int) -> bool:
    from ..proofs.simplices import minimal_nodes

    ds = range(first, first + 6)  # the ends are affine in d: two dimensions would do
    return all(list(numbers(s.first, s.last, d)) == minimal_nodes(s.family, d) for d in ds)


def _longest(s: PrintedStatement, first: int) -> bool:
    from ..symbolic.runs import squared_distance

    _, u, range_ = _vectors(s.family, s.first, first)
    _, v, _ = _vectors(s.family, s.last, first)
    piece = closed_form(s.family, "longest_edge").pieces[-1]
    exact = piece.low <= first or _holds_in(s, first)
    return exact and range_.equal_value("d/4", squared_distance(u, v, range_))


def _level(s: PrintedStatement, first: int) -> bool:
    from ..proofs.classical import FAMILIES
    from ..symbolic.runs import inner

    root, _, range_ = _vectors(s.family, s.facet, first)
    point = FAMILIES[s.family].circumcentre if s.vertex == "c" else _vectors(s.family, s.vertex, first)[1]
    return bool(range_.equal_value(s.text, inner(root, point, range_)))


def _space(s: PrintedStatement, first: int) -> bool:
    _, vertex, range_ = _vectors(s.family, "0", first)
    return bool(s.text) and range_.equal(s.text, vertex.length)


_EVERY_D: dict[str, Callable[[PrintedStatement, int], bool]] = {
    "facet": _facet,
    "distance": _distance,
    "minimal": _minimal,
    "longest": _longest,
    "level": _level,
    "space": _space,
}


@lru_cache(maxsize=256)
def _finding(s: PrintedStatement) -> Finding:
    comparison = compare_statement(printed(), s)
    strength = strength_for(s.family)
    correction = f"printed {comparison.printed}; {comparison.note}"
    more: dict[str, Any] = {"constants": _true_constants(s, comparison.fails_at, comparison.exact)}
    if comparison.outcome is Outcome.TRANSCRIPTION:
        return damaged(strength, correction, comparison.evidence, **more)
    return corrected(strength, correction, evidence=comparison.evidence, **more)


def _true_constants(s: PrintedStatement, fails_at: tuple[int, ...], exact: Any) -> Constants:
    """What to put instead: another value, or a later first dimension."""
    printed_now: dict[str, Any] = {name: getattr(s, name) for name in CONSTANTS[s.kind] if getattr(s, name)}
    ds = dimensions(s.family)
    if len(ds) > 1 and 0 < len(fails_at) < len(ds) and fails_at == ds[: len(fails_at)]:
        return {**printed_now, "low": fails_at[-1] + 1}
    if s.kind == "distance" and s.family == "B":
        return {**printed_now, "vertex": "2", "facet": "2"}
    return {**printed_now, "text": str(exact)}
