"""Printed statements about facets, heights, edges and inner products, against the core."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from ..affine import Facet
from ..errors import InvalidInput
from ..exact import Exact, Surd, show, sqrt, surd
from ..families import evaluate
from ..lattices import spanned_lattice
from ..paper import Paper, PrintedStatement
from .core import dimensions, simplex_of, triangulation_of
from .outcomes import Comparison, Outcome, spell_range
from .points import SIGN, exact_point, failures
from .runs import Point, coordinates, numbers, spell_runs


@dataclass(frozen=True)
class Finding:
    """Whether a statement holds in one dimension, the exact value and the evidence."""

    holds: bool
    exact: Surd | tuple[Exact, ...] | None = None
    words: str = ""


def compare_statements(paper: Paper, wanted: Callable[[PrintedStatement], bool]) -> tuple[Comparison, ...]:
    """The printed statements that are wanted, each compared with the core in every dimension up to 24.

    >>> from ..paper import printed
    >>> for x in compare_statements(printed(), lambda s: s.family == "B" and s.kind == "distance"):
    ...     print(x.printed, "|", x.note)
    d(u_1, facet 1) = 1/(2*sqrt(2)) | fails for d = 3 … 24; for d = 3 it is sqrt(2)/2
    """
    return tuple(compare_statement(paper, s) for s in paper.statements if wanted(s))


def compare_statement(paper: Paper, s: PrintedStatement) -> Comparison:
    """One printed statement."""
    ds = tuple(d for d in dimensions(s.family) if d >= s.low)
    findings = {d: KINDS[s.kind](s, d) for d in ds}
    fails = tuple(d for d in ds if not findings[d].holds)
    first = fails[0] if fails else ds[0]
    outcome, evidence = Outcome.AGREES, ""
    note = spell_range(ds, fails)
    if fails:
        note += f"; for d = {first} {findings[first].words}"
        outcome, evidence = Outcome.DIFFERS, _evidence(paper, s)
    if s.kind == "space" and not s.text:
        outcome, note = Outcome.TRANSCRIPTION, "our copy has lost it"
        beside = [p for p in paper.points if (p.place, p.family) == (s.place, s.family)]
        if beside and not any(failures(p, p.family) for p in beside):
            evidence = f"the {len(beside)} vertices beside it are exact in this space"
    return Comparison(
        place=s.place,
        family=s.family,
        quantity=s.kind,
        printed=_text(s),
        outcome=outcome,
        dimensions=ds,
        fails_at=fails,
        exact=findings[first].exact,
        note=note,
        evidence=evidence,
    )


def _text(s: PrintedStatement) -> str:
    normal = spell_runs(s.normal)
    point = s.vertex if s.vertex == "c" else f"u_{s.vertex}"
    return {
        "facet": f"facet {s.facet}: <x, {normal}> = {s.text}",
        "distance": f"d({point}, facet {s.facet}) = {s.text}",
        "minimal": f"least heights: from {s.first} to {s.last}",
        "longest": f"longest edge: from u_{s.first} to u_{s.last}",
        "level": f"<s_{{{s.facet}}}, {point}> = {s.text}",
        "product": f"<{normal}, {point}> = {s.text}",
        "space": f"given in R^({s.text})",
        "combination": f"{' + '.join(f'({c})*u_{{{k}}}' for c, k in s.terms)} = {normal}",
        "no vertex": f"{normal} is not a vertex",
    }[s.kind]


def _evidence(paper: Paper, s: PrintedStatement) -> str:
    """What else is printed, or true, that explains a wrong statement."""
    if s.kind == "distance":
        parts = []
        d = dimensions(s.family)[-1]
        same = [k for k, h in enumerate(simplex_of(s.family, d).heights) if h == evaluate(s.text, d=d)]
        if same:
            parts.append(f"it is the height from u_k for k from {same[0]} to {same[-1]} (d = {d})")
        for other in paper.statements:
            key = (other.kind, other.vertex, other.facet, other.text)
            if other is not s and key == (s.kind, s.vertex, s.facet, s.text):
                true = all(_distance(other, d).holds for d in dimensions(other.family))
                parts.append(f"{other.place} has the same sentence" + (", true there" if true else ""))
        return "; ".join(parts)
    if s.kind == "product":
        d = dimensions(s.family)[0]
        value = _product(s, d).exact
        if isinstance(value, Surd) and value == -evaluate(s.text, d=d):
            return "the exact value has the opposite sign"
    return _evidence_on_combination(s) if s.kind == "combination" else ""


def _evidence_on_combination(s: PrintedStatement) -> str:
    """Whether one other coefficient makes it right, up to the sign, or no integers can."""
    d = next(d for d in dimensions(s.family) if d >= s.low)
    wanted = coordinates(s.normal, d, 0)
    if wanted is None:
        return ""
    for i, (coefficient, vertex) in enumerate(s.terms):
        for c in range(-12, 13):
            total = _sum(replace(s, terms=(*s.terms[:i], (str(c), vertex), *s.terms[i + 1 :])), d)
            if total in (wanted, tuple(-x for x in wanted)):
                sign = "" if total == wanted else "minus "
                return f"with {c} in place of {coefficient} for u_{vertex} it is {sign}the vector printed"
    if wanted not in spanned_lattice(triangulation_of(s.family, d)):
        return "the vector is not in the lattice that the vertices span: no integer combination gives it"
    return ""


# -- one kind of statement after the other: what it says in dimension d --------------------------------


def _number(text: str, d: int) -> int:
    (number,) = numbers(text, text, d)
    if not 0 <= number <= d:
        raise InvalidInput(f"there is no node {number} for d = {d}: give 0 to {d}")
    return number


def _facet_at(family: str, index: int, d: int) -> Facet:
    return triangulation_of(family, d).facets[index]


def _facet(s: PrintedStatement, d: int) -> Finding:
    """The printed hyperplane is that of the facet: normal and value are proportional to the core's."""
    indices = numbers(s.first, s.last, d) if s.first else numbers(s.facet, s.facet, d)
    for k in indices:
        facet = _facet_at(s.family, k, d)
        normal = coordinates(s.normal, d, k)
        sign = SIGN.get(s.family, 1)
        exact: tuple[Exact, ...] = (*(sign * x for x in facet.normal), facet.offset)
        if normal is None or len(normal) != len(facet.normal):
            return Finding(False, exact, f"the normal of facet {k} has the wrong length")
        given = (*normal, evaluate(s.text, d=d))
        ratios = {surd(a) / b for a, b in zip(given, exact, strict=True) if b}
        if len(ratios) != 1 or not all(a == 0 for a, b in zip(given, exact, strict=True) if not b):
            return Finding(
                False, exact, f"facet {k} has the normal {show(exact[:-1])} and the value {exact[-1]}"
            )
        if not ratios.pop():
            return Finding(False, exact, "there is no normal")
    return Finding(True)


def _distance(s: PrintedStatement, d: int) -> Finding:
    facet = _facet_at(s.family, _number(s.facet, d), d)
    vertex = simplex_of(s.family, d).vertex_matrix.row(_number(s.vertex, d))
    exact = abs(facet.level(vertex)) / sqrt(sum(x * x for x in facet.normal))
    return Finding(exact == evaluate(s.text, d=d), exact, f"it is {exact}")


def _minimal(s: PrintedStatement, d: int) -> Finding:
    squares = simplex_of(s.family, d).squared_heights
    least = [k for k, h in enumerate(squares) if h == min(squares)]
    words = f"it is those from {', '.join(map(str, least))}"
    return Finding(least == list(numbers(s.first, s.last, d)), sqrt(min(squares)), words)


def _longest(s: PrintedStatement, d: int) -> Finding:
    simplex = simplex_of(s.family, d)
    edges = simplex.longest_edges()
    words = "it is " + ", ".join(f"that from u_{i} to u_{j}" for i, j in edges)
    ends = (_number(s.first, d), _number(s.last, d))
    return Finding(ends in edges, simplex.longest_edge, words)


def _level(s: PrintedStatement, d: int) -> Finding:
    facet = _facet_at(s.family, _number(s.facet, d), d)
    simplex = simplex_of(s.family, d)
    point = simplex.circumcentre if s.vertex == "c" else simplex.vertex_matrix.row(_number(s.vertex, d))
    exact = sum((surd(x) * n for x, n in zip(point, facet.normal, strict=True)), Surd(0))
    return Finding(exact == evaluate(s.text, d=d), exact, f"it is {exact}")


def _product(s: PrintedStatement, d: int) -> Finding:
    normal = coordinates(s.normal, d, 0)
    if s.vertex == "c":
        point = exact_point(s.family, "circumcentre", d, 0)
    else:
        point = exact_point(s.family, "vertex", d, _number(s.vertex, d))
    if normal is None or len(normal) != len(point):
        return Finding(False, None, f"the normal needs {len(point)} coordinates")
    exact = sum((surd(x) * n for x, n in zip(point, normal, strict=True)), Surd(0))
    return Finding(exact == evaluate(s.text, d=d), exact, f"it is {exact}")


def _space(s: PrintedStatement, d: int) -> Finding:
    """The dimension of the space; for G~2 the paper draws the triangle in the plane."""
    length = 2 if s.family == "G2" else len(simplex_of(s.family, d).vertex_matrix.row(0))
    return Finding(bool(s.text) and evaluate(s.text, d=d) == length, Surd(length), f"it is {length}")


def _sum(s: PrintedStatement, d: int) -> Point:
    points = [exact_point(s.family, "vertex", d, _number(k, d)) for _, k in s.terms]
    coefficients = [evaluate(c, d=d).as_fraction() for c, _ in s.terms]
    columns = zip(*points, strict=True)
    return tuple(sum(c * x for c, x in zip(coefficients, column, strict=True)) for column in columns)


def _combination(s: PrintedStatement, d: int) -> Finding:
    exact = _sum(s, d)
    return Finding(exact == coordinates(s.normal, d, 0), exact, f"it is {show(exact)}")


def _no_vertex(s: PrintedStatement, d: int) -> Finding:
    point = coordinates(s.normal, d, 0)
    if point is None:
        return Finding(False, None, "there is no such point")
    t = triangulation_of(s.family, d)
    try:
        vertex = t.is_vertex(point)
    except InvalidInput as error:
        return Finding(False, None, f"there is an error: {error}")
    rank = t.integral_roots(point).rank()
    words = f"it is a vertex: the roots with integer inner product with it have rank {rank}"
    return Finding(not vertex, None, words)


KINDS: dict[str, Callable[[PrintedStatement, int], Finding]] = {
    "facet": _facet,
    "distance": _distance,
    "minimal": _minimal,
    "longest": _longest,
    "level": _level,
    "product": _product,
    "space": _space,
    "combination": _combination,
    "no vertex": _no_vertex,
}
