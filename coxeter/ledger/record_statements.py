"""Claims made from the paper's data: facets, and sentences that name a vertex, a facet or an edge.

For the infinite families two routes must agree: symbolic vectors for every d, and the core in small
dimensions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache, partial
from typing import TYPE_CHECKING, Any

from ..claims.core import dimensions
from ..claims.points import SIGN
from ..claims.runs import coordinates, numbers
from ..claims.statements import KINDS, compare_statement
from ..errors import CoxeterError
from ..exact import surd
from ..families import closed_form, evaluate
from ..names import MINIMAL_DIMENSION
from ..paper import PrintedStatement, printed
from .claim import Constants, Equivalent, Finding, claim, corrected, holds, spell
from .records import family_words, faulty, place_id, strength_for, unique
from .vocabulary import Weight

if TYPE_CHECKING:
    from ..symbolic.cases import Case
    from ..symbolic.runs import RunVector

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
    "facet": "Facet {facet} of {family} lies in the hyperplane of the points whose product with the normal "
    "({normal}) is {text}.",
    "distance": "The distance from vertex {vertex} of {family} to facet {facet} is {text}.",
    "minimal": "The least heights of {family} are those from the vertices {first} to {last}.",
    "longest": "In {family} the edge from vertex {first} to vertex {last} is a longest one.",
    "level": "The normal of the facet {facet} of {family} and the point {vertex} have the inner product "
    "{text}.",
    "product": "The normal ({normal}) and the point {vertex} of {family} have the inner product {text}.",
    "space": "The vertices of {family} are given in a space of dimension {text}.",
}
ONE_HEIGHT = "The least height of {family} is that from vertex {first}."
SECOND_ROUTE = 8
"""Up to this d the core computes what symbolic vectors prove for every d."""


def statement_claims(wanted: Callable[[PrintedStatement], bool]) -> None:
    """Enter a claim for each printed statement that is wanted."""
    records = [s for s in printed().statements if wanted(s) and s.kind in WORDS]
    for id, s in zip(unique(map(_id, records)), records, strict=True):
        claim(
            id,
            s.place,
            Weight.RESULT if s.kind in ("facet", "space") else Weight.PROOF,
            words=_words(s),
            printed=_constants(s),
            to_state=("def-16",),
        )(partial(judge_statement, s))


def _id(s: PrintedStatement) -> str:
    what = {"level": "inner-product", "product": "inner-product", "minimal": "least-height"}
    about = s.facet if s.kind == "facet" else s.vertex if s.kind in ("level", "product") else ""
    index = about.replace(" ", "").replace("d-", "dminus")
    ending = f"-{index}" if index else ""
    return f"{place_id(s.place, s.family)}.{what.get(s.kind, s.kind)}{ending}"


def _words(s: PrintedStatement) -> str:
    """The statement; what can be moved remains to be filled in."""
    one = s.kind == "minimal" and s.first == s.last
    words = (ONE_HEIGHT if one else WORDS[s.kind]).replace("{family}", family_words(s.family))
    for name in {"facet", "vertex", "first", "last", "normal"} - _constants(s).keys():
        words = words.replace(f"{{{name}}}", spell(getattr(s, name)))
    return words[:-1] + (f" for k from {s.first} to {s.last}." if s.kind == "facet" and s.first else ".")


def _constants(s: PrintedStatement) -> dict[str, Any]:
    return {name: getattr(s, name) for name in CONSTANTS[s.kind] if getattr(s, name)}


def judge_statement(s: PrintedStatement, constants: Constants) -> Finding:
    """The verdict on a printed statement, with any constants in place of the printed ones."""
    asked = replace(s, **{name: value for name, value in constants.items() if name != "low"})
    low = int(constants.get("low", s.low))
    if s.kind == "facet" and asked != s and _same_hyperplane(asked, s):
        raise Equivalent("a multiple of an equation says the same")
    if _is_right(asked, low):
        return holds(strength_for(s.family), proof=_proof(s))
    return _finding(s) if asked == s and low == s.low else corrected(strength_for(s.family), "")


def _same_hyperplane(s: PrintedStatement, t: PrintedStatement) -> bool:
    """Whether two equations are multiples of each other."""
    d = max(dimensions(s.family)[0], 5) if s.family in MINIMAL_DIMENSION else dimensions(s.family)[0]
    k = _number(s.first or s.facet, d)
    one, other = ((*(coordinates(x.normal, d, k) or ()), evaluate(x.text, d=d)) for x in (s, t))
    if len(one) != len(other) or not any(one):
        return False
    pairs = [(surd(a), surd(b)) for a, b in zip(one, other, strict=True)]
    return all(a * y == x * b for a, b in pairs for x, y in pairs)


def _number(index: str, d: int) -> int:
    return numbers(index, index, d)[0]


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


# -- what is wrong with a statement -----------------------------------------------------------------------


@lru_cache(maxsize=256)
def _finding(s: PrintedStatement) -> Finding:
    comparison = compare_statement(printed(), s)
    constants = _constants(s) | _instead(s, comparison.fails_at, comparison.exact)
    correction = f"printed {comparison.printed}; {comparison.note}"
    return faulty(strength_for(s.family), comparison, correction, constants=constants)


def _instead(s: PrintedStatement, fails_at: tuple[int, ...], exact: object) -> dict[str, Any]:
    """What to put instead: another value, or a later first dimension."""
    ds = dimensions(s.family)
    if len(ds) > 1 and 0 < len(fails_at) < len(ds) and fails_at == ds[: len(fails_at)]:
        return {"low": fails_at[-1] + 1}
    if s.kind == "distance" and s.family == "B":
        return {"vertex": "2", "facet": "2"}
    return {"text": str(exact)}


# -- whether a statement is right -------------------------------------------------------------------------


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


def _from(first: int) -> range:
    """So many dimensions tell formulas for indices apart: they are affine in d, and two would do."""
    return range(first, first + 6)


def _vectors(family: str, index: str, first: int) -> tuple[RunVector, RunVector, Case]:
    """The root and the vertex of a node, and a range in which they are told."""
    from ..proofs.classical import FAMILIES, vector
    from ..symbolic.cases import case

    for nodes in FAMILIES[family].nodes:
        whole_class = index == nodes.index == "k"
        if whole_class or (index != "k" and _lies_in(index, nodes.low, nodes.high, first)):
            range_ = case(f"{nodes.low} <= k <= {nodes.high}" if whole_class else f"{first} <= d")
            return vector(nodes.root, f"({index})"), vector(nodes.vertex, f"({index})"), range_
    raise KeyError(index)


def _lies_in(index: str, low: str, high: str, first: int) -> bool:
    return all(_number(index, d) in numbers(low, high, d) for d in _from(first))


MULTIPLES = ("1", "-1", "2", "1/2")
"""What a printed normal may have to be multiplied by to be the root."""


def _facet(s: PrintedStatement, first: int) -> bool:
    """The normal is a multiple of the root, and so is the value."""
    from ..proofs.classical import FAMILIES
    from ..symbolic.runs import runs, same

    if s.first and not _has_its_range(s, first):
        return False
    if s.first and s.family != "A" and "k" in s.facet:  # several classes of nodes
        last = _from(first)[-1]
        indices = [nodes.index for nodes in FAMILIES[s.family].nodes]
        held = [x for x in indices if x == "k" or _number(x, last) in numbers(s.first, s.last, last)]
        return s.text == "0" and all(_is_normal(s, index, first) for index in held)
    root, _, range_ = _vectors(s.family, s.facet, first)
    for factor in MULTIPLES:
        normal = runs(*((f"({factor})*({SIGN.get(s.family, 1)})*({x})", n) for x, n in s.normal))
        if same(normal, root, range_):
            return range_.equal(f"({factor})*({s.text})", "1" if s.facet == "0" else "0")
    return False


def _has_its_range(s: PrintedStatement, first: int) -> bool:
    """Whether a facet with an index stands for all that the others beside it leave."""
    beside = [t for t in printed().statements if (t.place, t.kind) == (s.place, s.kind) and t.line != s.line]
    return all(
        set(numbers(s.first, s.last, d)) == set(range(d + 1)) - {_number(t.facet, d) for t in beside}
        for d in _from(first)
    )


def _is_normal(s: PrintedStatement, index: str, first: int) -> bool:
    from ..proofs.classical import vector
    from ..symbolic.runs import same

    root, _, range_ = _vectors(s.family, index, first)
    return same(vector(s.normal, f"({index})"), root, range_)


def _distance(s: PrintedStatement, first: int) -> bool:
    """Level over the length of the root, squared."""
    from ..symbolic.runs import inner

    root, _, range_ = _vectors(s.family, s.facet, first)
    _, vertex, _ = _vectors(s.family, s.vertex, first)
    level = inner(root, vertex, range_)
    level = 1 - level if s.facet == "0" else level
    square = level**2 / inner(root, root, range_)
    return not s.text.startswith("-") and range_.equal_value(f"({s.text})**2", square)


def _minimal(s: PrintedStatement, first: int) -> bool:
    from ..proofs.simplices import minimal_nodes

    return all(list(numbers(s.first, s.last, d)) == minimal_nodes(s.family, d) for d in _from(first))


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
    return range_.equal_value(s.text, inner(root, point, range_))


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
"""Whether a statement holds for every d from a first one on, by its kind."""
