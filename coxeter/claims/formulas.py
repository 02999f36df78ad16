"""Printed formulas and numbers: Table 2, the regular simplex, Section 6, Theorem 8, the appendices.

Each is compared with the core, exactly, in every dimension up to 24 for which it is printed. Where it
differs, three questions are answered by computation, to tell an error of the paper from damage of our
copy: Is there a mistake that explains the value? Where else is the same quantity printed, and is it
the same value there? Do values that follow from it repeat the error?
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import combinations

from ..errors import InvalidInput
from ..exact import Surd
from ..families import evaluate
from ..paper import Paper, PrintedFormula
from .core import DEFINITIONS, LETTERS, dimensions, exact_value, letters, normalize, simplex_of
from .decimals import printed_decimal
from .outcomes import Comparison, Outcome, compare_decimal, round_like, spell, spell_range, units_off

EXPLANATIONS = (
    # family, quantity, what would give the printed value, and its formula
    ("A", "thickness", "the longest edge sqrt(d)/2 of B~, C~, D~ in place of A~'s", "h/(sqrt(d)/2)"),
    ("B", "longest_edge", "the edge from u_0 to u_d in place of the longest", "edge"),
    ("B", "thickness", "the edge from u_0 to u_d in place of the longest", "h/edge"),
    ("B", "fatness", "the edge from u_0 to u_d in place of the longest", "vol/edge**d"),
    ("E6", "fatness", "E~7's longest edge sqrt(3/2) in place of 2/sqrt(3)", "vol/sqrt(3/2)**d"),
    ("E8", "normalized_thickness", "h/(2R) in place of h/L", "h/(2*R)/regular_thickness"),
    ("F4", "fatness", "the volume 1/864 in place of 1/576", "1/864/L**d"),
    ("regular", "aspect_ratio", "R/h in place of h/(2R)", "R/h"),
)
"""Mistakes that would lead to a printed value. Each is tried; only those that reproduce it are named."""


def compare_formulas(paper: Paper, wanted: Callable[[PrintedFormula], bool]) -> tuple[Comparison, ...]:
    """The printed formulas that are wanted, each compared with the core.

    >>> from ..paper import printed
    >>> wrong = compare_formulas(printed(), lambda f: f.family == "A" and f.text == "sqrt(2/d)")[0]
    >>> wrong.place, wrong.outcome.value, wrong.dimension, wrong.exact
    ('Section 6, A~, item 6', 'differs', None, sqrt(2)/2)
    >>> wrong.note
    'fails for odd d = 3 … 23; for d = 3 the value is sqrt(2)/2, printed is sqrt(6)/3'
    """
    return tuple(compare_formula(paper, f) for f in paper.formulas if wanted(f))


def compare_formula(paper: Paper, f: PrintedFormula) -> Comparison:
    """One printed formula or number."""
    if f.decimal:
        return _compare_number(paper, f)
    if not f.text:
        return _compare_merged(paper, f)
    if f.quantity == "squared_edge":
        return _compare_edges(f)
    ds = dimensions(f.family, f.parity)
    exact = {d: exact_value(f.family, f.quantity, d) for d in ds}
    fails = tuple(d for d in ds if _value(f, d) != exact[d])
    first = fails[0] if fails else ds[0]
    note = spell_range(ds, fails)
    if fails:
        note += f"; for d = {first} the value is {exact[first]}, printed is {_value(f, first)}"
    evidence = "; ".join(_evidence(paper, f, fails)) if fails else ""
    return _in_dimensions(f, ds, fails, note, exact[first], evidence)


def _in_dimensions(
    f: PrintedFormula,
    ds: tuple[int, ...],
    fails: tuple[int, ...],
    note: str,
    exact: Surd | None = None,
    evidence: str = "",
) -> Comparison:
    """A formula that agrees in all dimensions but those where it fails."""
    return Comparison(
        place=f.place,
        family=f.family,
        quantity=f.quantity,
        printed=f.text,
        outcome=Outcome.DIFFERS if fails else Outcome.AGREES,
        dimensions=ds,
        fails_at=fails,
        exact=exact,
        note=note,
        evidence=evidence,
    )


def _value(f: PrintedFormula, d: int) -> Surd | None:
    """What a printed formula is worth in dimension d; None if it has no value there."""
    return _evaluate(f.text, letters(f.family, d))


def _evaluate(text: str, values: Mapping[str, Surd | int]) -> Surd | None:
    try:
        return evaluate(text, **values)
    except (InvalidInput, ZeroDivisionError):
        return None


def _compare_number(paper: Paper, f: PrintedFormula) -> Comparison:
    """A decimal number printed for a single triangulation."""
    (d,) = dimensions(f.family)
    exact = exact_value(f.family, f.quantity, d)
    outcome = compare_decimal(f.text, exact)
    evidence = []
    if outcome is not Outcome.AGREES:
        evidence = [units_off(f.text, exact), *_explained(f, (d,))]
        for other in paper.formulas:
            if (other.family, other.quantity, other.place) == (f.family, f.quantity, f.place):
                value = None if other.decimal or _is_definition(other) else _value(other, d)
                if value is not None and round_like(f.text, value) == f.text:
                    evidence.append(f"{other.text}, printed beside it, rounds to it")
    return Comparison(
        place=f.place,
        family=f.family,
        quantity=f.quantity,
        printed=f.text,
        outcome=outcome,
        dimensions=(d,),
        fails_at=() if outcome is Outcome.AGREES else (d,),
        exact=exact,
        rounded=round_like(f.text, exact),
        note=f"correctly rounded the value is {round_like(f.text, exact)}",
        evidence="; ".join(evidence),
    )


def _compare_merged(paper: Paper, f: PrintedFormula) -> Comparison:
    """An empty cell: perhaps the formula above it was meant for both rows."""
    ds = dimensions(f.family, f.parity)
    key = (f.place, f.family, f.quantity)
    above = [g for g in paper.formulas if (g.place, g.family, g.quantity) == key and g.text]
    holds = [g for g in above if all(_value(g, d) == exact_value(f.family, f.quantity, d) for d in ds)]
    evidence = f"{holds[0].text}, in the row above, is exact for {spell(ds)} as well" if holds else ""
    return Comparison(
        place=f.place,
        family=f.family,
        quantity=f.quantity,
        printed="",
        outcome=Outcome.TRANSCRIPTION if holds else Outcome.DIFFERS,
        dimensions=ds,
        fails_at=() if holds else ds,
        exact=exact_value(f.family, f.quantity, ds[0]),
        note="a cell for two rows, shown in the upper one" if holds else "there is nothing in the cell",
        evidence=evidence,
    )


def _compare_edges(f: PrintedFormula) -> Comparison:
    """The squared lengths of all edges, as a formula in j < k."""
    ds = dimensions(f.family)

    def holds(d: int) -> bool:
        squares = simplex_of(f.family, d).squared_edge_lengths
        pairs = combinations(range(d + 1), 2)
        return all(_evaluate(f.text, {"d": d, "j": j, "k": k}) == squares[j, k] for j, k in pairs)

    fails = tuple(d for d in ds if not holds(d))
    note = f"fails for some edge, {spell(fails)}" if fails else f"holds for all edges, {spell(ds)}"
    return _in_dimensions(f, ds, fails, note)


# -- evidence ----------------------------------------------------------------------------------------


def _is_definition(f: PrintedFormula) -> bool:
    """Whether it names other quantities, as h/L does."""
    return any(letter in f.text for letter in ("h", "L", "R", "vol"))


def _evidence(paper: Paper, f: PrintedFormula, fails: tuple[int, ...]) -> Iterator[str]:
    yield from _factor(f, fails)
    if not _is_definition(f):
        yield from _explained(f, fails)
    yield from _elsewhere(paper, f, fails[0])
    yield from _followers(paper, f, fails[0])


def _factor(f: PrintedFormula, fails: tuple[int, ...]) -> Iterator[str]:
    """A constant factor, if there is one."""
    ratios = set()
    for d in fails:
        value, exact = _value(f, d), exact_value(f.family, f.quantity, d)
        if value is None or not exact or f.quantity == "normalized_fatness":
            return
        ratios.add(value / exact)
    if len(ratios) == 1 and (ratio := ratios.pop()).is_rational:
        yield f"it is {ratio} times the exact value"


def _explained(f: PrintedFormula, fails: tuple[int, ...]) -> Iterator[str]:
    """Mistakes that give the printed value wherever it differs."""
    for family, quantity, words, text in EXPLANATIONS:
        asked = family == f.family and quantity.removeprefix("normalized_") in f.quantity
        if asked and all(_reproduces(f, quantity, text, d) for d in fails):
            yield f"it is what {words} would give"


def _reproduces(f: PrintedFormula, quantity: str, text: str, d: int) -> bool:
    value = evaluate(text, **letters(f.family, d))
    if f.decimal:
        return round_like(f.text, value) == f.text
    if f.quantity.startswith("normalized_") and quantity in DEFINITIONS:
        value = normalize(f.family, quantity, d, value)[1]  # type: ignore[index]  # it is a measure
    return _value(f, d) == value


def _elsewhere(paper: Paper, f: PrintedFormula, d: int) -> Iterator[str]:
    """Other places that print the same quantity, raw or normalised, and what stands there."""
    own = _value(f, d)
    if own is None:
        return
    name, value = normalize(f.family, f.quantity, d, own) or (f.quantity, own)
    exact = exact_value(f.family, name, d)
    for other in paper.formulas:
        if other is f or other.family != f.family or other.decimal or _is_definition(other):
            continue
        their = _value(other, d) if other.text and d in dimensions(f.family, other.parity) else None
        if their is None:
            continue
        their_name, theirs = normalize(other.family, other.quantity, d, their) or (other.quantity, their)
        if their_name == name:
            verdict = "has the same value" if theirs == value else "has another wrong value"
            yield f"{other.place} ({other.text}) {'has the exact value' if theirs == exact else verdict}"
    if cell := printed_decimal(paper, f.family, name, d):
        table, text = cell
        if text == round_like(text, value):
            yield f"Table {table} prints its rounding {text} for d = {d}"
        elif text == round_like(text, exact):
            yield f"Table {table} prints the rounding {text} of the exact value for d = {d}"
        else:
            yield f"Table {table} prints {text} for d = {d}"


def _followers(paper: Paper, f: PrintedFormula, d: int) -> Iterator[str]:
    """Measures in the same section that are computed from a wrong length."""
    own = _value(f, d)
    if f.quantity not in LETTERS or own is None:
        return
    section = f.place.rpartition(",")[0]
    wrong = {**letters(f.family, d), LETTERS[f.quantity]: own}
    for other in paper.formulas:
        if other.place.startswith(section) and other.quantity in DEFINITIONS and not other.decimal:
            value = _value(other, d)
            follows = value == _evaluate(DEFINITIONS[other.quantity], wrong)
            if follows and value != exact_value(f.family, other.quantity, d):
                yield f"{other.place} computes the {other.quantity.replace('_', ' ')} with it"
