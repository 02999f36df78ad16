"""Printed vertices and centres against the core's.

The paper's A~ and E~7 simplices are the negatives of those of Theorem 3's roots, and its G~2 is a plane
triangle in another scale and with its vertices in another order: it is compared up to similarity.

Coordinates in our copy are sometimes damaged: a repetition count has slipped into a fraction or is
lost, a vertex stands in another family's row. Then the point cannot be what was meant, as it has the
wrong number of coordinates, or its family already has that vertex; and what was meant can be told, by
the one count that makes it right, by the other place that prints the vertex, or by the row that lacks it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import permutations

from ..delaunay import mirror_vertices
from ..exact import RationalMatrix, Surd, show, surd
from ..families import evaluate
from ..names import FAMILIES, MINIMAL_DIMENSION
from ..paper import Paper, PrintedPoint
from .core import affine_name, dimensions, simplex_of, triangulation_of
from .outcomes import Comparison, Outcome, spell
from .runs import Point, coordinates, numbers, spell_runs

SIGN = {"A": -1, "E7": -1}
"""Families whose printed coordinates are the negatives of the core's."""


def compare_points(paper: Paper, wanted: Callable[[PrintedPoint], bool]) -> tuple[Comparison, ...]:
    """The printed points that are wanted, and the vertices that are missing beside them.

    >>> from ..paper import printed
    >>> for x in compare_points(printed(), lambda p: p.family == "E8" and p.name == "circumcentre"):
    ...     print(x.outcome.value, "|", x.note)
    differs | the point is (1/12, 1/12, 0, 0, 0, 0, 0, 1/2); our copy shows 7 coordinates in place of 8
    """
    points = [point for point in paper.points if wanted(point)]
    sections = [
        (f"Section 6, {affine_name(family)}, item 2", family) for family in FAMILIES if family != "G2"
    ]
    lists = [*(("Table 1", family) for family in FAMILIES), *sections]
    missing = (_missing(paper, *x) for x in lists if wanted(PrintedPoint(*x, name="vertex", runs=())))
    return (*(compare_point(paper, point) for point in points), *(x for found in missing for x in found))


def vertex_numbers(point: PrintedPoint, d: int) -> range:
    """The numbers of the vertices that a printed point stands for in dimension d; 0 for a centre."""
    if point.first:
        return numbers(point.first, point.last, d)
    index = point.index or "0"
    return numbers(index, index, d)


@lru_cache(maxsize=4096)
def exact_point(family: str, name: str, d: int, k: int) -> Point:
    """The vertex or centre as the core has it, with the signs that the paper uses."""
    simplex = simplex_of(family, d)
    point: Point
    if name == "vertex":
        point = simplex.vertex_matrix.row(k)
    elif name.startswith("mirror"):
        point = mirror_vertices(triangulation_of(family, d))[k].point
    else:
        point = simplex.circumcentre if name == "circumcentre" else simplex.incentre
    return tuple(SIGN.get(family, 1) * x for x in point)


def _printed_point(point: PrintedPoint, d: int, k: int) -> Point | None:
    x = coordinates(point.runs, d, k)
    if x is not None and point.name == "mirror_shift":  # the integers n in the coordinates n + k/(d + 1)
        return tuple(n + Fraction(k, d + 1) for n in x)
    return x


def agrees(point: PrintedPoint, family: str, d: int, k: int) -> bool:
    """Whether a printed point is that of the family, for one d and k."""
    return _printed_point(point, d, k) == exact_point(family, point.name, d, k)


def failures(point: PrintedPoint, family: str) -> tuple[tuple[int, int], ...]:
    """The pairs (d, k) for which a printed point is not that of the family."""
    return _failures(point, family, tuple(_pairs(point, family)))


@lru_cache(maxsize=1024)
def _failures(
    point: PrintedPoint, family: str, pairs: tuple[tuple[int, int], ...]
) -> tuple[tuple[int, int], ...]:
    return tuple((d, k) for d, k in pairs if not agrees(point, family, d, k))


def _pairs(point: PrintedPoint, family: str) -> Iterator[tuple[int, int]]:
    return ((d, k) for d in dimensions(family) for k in vertex_numbers(point, d))


def _first(point: PrintedPoint, family: str) -> tuple[int, int]:
    return next(_pairs(point, family), (dimensions(family)[0], 0))


def _name(point: PrintedPoint) -> str:
    return f"{point.name.replace('_', ' ')}{' ' + point.index if point.index else ''}"


def compare_point(paper: Paper, point: PrintedPoint) -> Comparison:
    """One printed point."""
    if point.family == "G2":
        return _compare_triangle(paper, point)
    family, outcome, evidence = point.family, Outcome.AGREES, ""
    wrong = failures(point, family)
    d, k = wrong[0] if wrong else _first(point, family)
    exact = exact_point(family, point.name, d, k)
    note = f"exact for {spell(dimensions(family))}"
    if wrong:
        outcome, note, evidence = _fault(point, d, k, exact)
        family, cause = _cause(paper, point)
        if cause:
            outcome, evidence = Outcome.TRANSCRIPTION, cause
        if family != point.family:  # it stands in the wrong row
            wrong, exact = (), exact_point(family, point.name, *_first(point, family))
            rows = affine_name(point.family), affine_name(family)
            note = "our copy has it in the row of {}, it belongs to {}".format(*rows)
    elif point.label is not None:
        outcome, note = Outcome.TRANSCRIPTION, f"our copy labels it {point.label!r}"
        evidence = f"by its place it is {_name(point)}, and it is exact as that"
    return Comparison(
        place=point.place,
        family=family,
        quantity=_name(point),
        printed=point.raw or spell_runs(point.runs),
        outcome=outcome,
        dimensions=dimensions(family),
        fails_at=tuple(sorted({d for d, _ in wrong})),
        exact=exact,
        note=note,
        evidence=evidence,
    )


def _fault(point: PrintedPoint, d: int, k: int, exact: Point) -> tuple[Outcome, str, str]:
    """What is wrong with a printed point, at the first d and k for which it is wrong."""
    x = _printed_point(point, d, k)
    if x is not None and len(x) != len(exact):
        note = f"the point is {show(exact)}; our copy shows {len(x)} coordinates in place of {len(exact)}"
        return Outcome.DIFFERS, note, _mended(point, len(exact) - len(x), up_to_signs=True)
    where = f"d = {d}" + (f", k = {k}" if point.first else "")
    note = f"for {where} the point is {show(exact)}, printed is {show(x or ('nothing',))}"
    multiples = [text for text in _MULTIPLES if _is_multiple(point, text)]
    return Outcome.DIFFERS, note, f"it is {multiples[0]} times the exact point" if multiples else ""


_MULTIPLES = ("-1", "2", "1/2", "d + 1", "1/(d + 1)")


def _is_multiple(point: PrintedPoint, factor: str) -> bool:
    """Whether a printed point is a multiple of the exact one wherever they differ."""
    for d, k in failures(point, point.family):
        exact, times = exact_point(point.family, point.name, d, k), evaluate(factor, d=d).as_fraction()
        if _printed_point(point, d, k) != tuple(times * x for x in exact):
            return False
    return True


def _cause(paper: Paper, point: PrintedPoint) -> tuple[str, str]:
    """The family that a point is meant for, and how our copy has come to show it so, if that is found."""
    family, d = point.family, dimensions(point.family)[0]
    x = coordinates(point.runs, d, 0)
    if len(dimensions(family)) == 1 and x is not None:
        wanted = len(exact_point(family, point.name, d, 0))
        if len(x) != wanted:
            if mended := _mended(point, wanted - len(x)):
                return family, mended
            for other in paper.points:
                same = (other.family, other.name, other.index) == (family, point.name, point.index)
                left = iter(other.runs)  # the runs that our copy still shows are some of these, in order
                if same and not failures(other, family) and all(run in left for run in point.runs):
                    return family, f"{other.place} prints it right: {spell_runs(other.runs)}"
        return family, ""
    for other_family in MINIMAL_DIMENSION:
        beside = [p for p in paper.points if (p.place, p.family) == (point.place, other_family)]
        lacks = beside and not any(_covers(p, point) for p in beside)
        if lacks and point.name == "vertex" and not failures(point, other_family):
            name = affine_name(other_family)
            twice = f"the row of {affine_name(family)} has vertex {point.index} twice"
            return other_family, f"it is exact for {name}, whose row lacks it; {twice}"
    return family, ""


def _covers(one: PrintedPoint, other: PrintedPoint) -> bool:
    """Whether one printed vertex stands for all those that another stands for."""
    d = dimensions(one.family)[-1]
    return one.name == other.name and set(vertex_numbers(other, d)) <= set(vertex_numbers(one, d))


def _mended(point: PrintedPoint, lacking: int, up_to_signs: bool = False) -> str:
    """Whether a point becomes exact when one count is changed so that it has enough coordinates."""
    d, k = _first(point, point.family)
    exact = exact_point(point.family, point.name, d, k)
    for i, (value, count) in enumerate(point.runs):
        if not count.isdigit():
            continue
        runs = (*point.runs[:i], (value, f"{int(count) + lacking}"), *point.runs[i + 1 :])
        x = coordinates(runs, d, k)
        if x == exact:
            return f"with one count put right it is exact: {spell_runs(runs)}"
        if up_to_signs and x and [abs(a) for a in x] == [abs(b) for b in exact]:
            wrong = [str(j) for j, (a, b) in enumerate(zip(x, exact, strict=True), 1) if a != b]
            signs = f"coordinates {', '.join(wrong)} have the wrong sign"
            return f"with one count put right it is {spell_runs(runs)}, and {signs}"
    return ""


def _missing(paper: Paper, place: str, family: str) -> Iterator[Comparison]:
    """The first vertex of a simplex that a place should print and does not."""
    beside = [p for p in paper.points if (p.place, p.name) == (place, "vertex")]
    own = [p for p in beside if p.family == family]
    strays = [p for p in beside if p.family not in (family, "G2") and failures(p, p.family)]
    own += [p for p in strays if _cause(paper, p)[0] == family]
    for d in dimensions(family):
        found = {k for p in own for k in vertex_numbers(p, d)}
        if lost := sorted(set(range(d + 1)) - found):
            yield Comparison(
                place=place,
                family=family,
                quantity=f"vertex {lost[0]}",
                printed="",
                outcome=Outcome.DIFFERS,
                dimensions=(d,),
                fails_at=(d,),
                exact=exact_point(family, "vertex", d, lost[0]),
                note="no such vertex is printed",
            )
            return


def _compare_triangle(paper: Paper, point: PrintedPoint) -> Comparison:
    """G~2: the printed triangle is similar to the core's, with its vertices in some order."""
    corners = [coordinates(p.runs, 2, 0) for p in paper.points if p.place == point.place and p.family == "G2"]
    exact = simplex_of("G2", 2).squared_edge_lengths
    order, scale = similarity([c for c in corners if c is not None], exact)
    note = "the three printed points are not similar to the triangle of the roots"
    if order:
        named = ", ".join(f"u_{i} is the core's u_{j}" for i, j in enumerate(order))
        note = f"similar to the triangle of the roots, with squared lengths {scale} times as large: {named}"
    return Comparison(
        place=point.place,
        family="G2",
        quantity=_name(point),
        printed=spell_runs(point.runs),
        outcome=Outcome.AGREES if order else Outcome.DIFFERS,
        dimensions=(2,),
        fails_at=() if order else (2,),
        note=note,
    )


def similarity(corners: list[Point], exact: RationalMatrix) -> tuple[tuple[int, ...], Surd | None]:
    """The order of the core's vertices, and the factor of squared lengths, that make triangles similar."""
    pairs = ((0, 1), (0, 2), (1, 2))
    if len(corners) != 3 or len({len(c) for c in corners}) != 1:
        return (), None
    squares = {
        (i, j): sum(((surd(a) - b) ** 2 for a, b in zip(corners[i], corners[j], strict=True)), Surd(0))
        for i, j in pairs
    }
    for order in permutations(range(3)):
        factors = {squares[i, j] / exact[order[i], order[j]] for i, j in pairs}
        if len(factors) == 1:
            return order, factors.pop()
    return (), None
