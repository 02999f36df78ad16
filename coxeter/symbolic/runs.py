"""Vectors as the paper writes them, (1/2^{k}, 0^{d-k}), with symbolic k and d: exact sums along them.

Paper: the convention of Section 6. Where two vectors change their values is compared within a range of the
letters; between two such places an inner product is the sum of a polynomial in the number of the
coordinate, and that has a closed form.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ..errors import Undecided
from ..exact import Surd
from .cases import Case
from .polynomials import (
    FIELD,
    SYMBOLS,
    Rational,
    coefficients,
    is_zero,
    letters_of,
    rational_function,
    value,
)

Values = tuple[Rational, ...]
NUMBER = SYMBOLS["i"]
"""The number of a coordinate."""


@dataclass(frozen=True)
class RunVector:
    """Coordinates as runs (value, how many times); a value may contain i, its coordinate's number from 1.

    >>> runs(("1/2", "k"), ("0", "d - k"))
    (1/2^{k}, 0^{d - k})
    """

    runs: tuple[tuple[Rational, Rational], ...]

    def __repr__(self) -> str:
        return "(" + ", ".join(f"{x}^{{{n}}}" for x, n in self.runs) + ")"

    @property
    def length(self) -> Rational:
        """The number of coordinates."""
        return sum((n for _, n in self.runs), FIELD(0))

    def numbers(self, **letters: int) -> list[Surd]:
        """The coordinates, for given letters."""
        found: list[Surd] = []
        for x, n in self.runs:
            count = int(value(n, **letters).as_fraction())
            found += [value(x, i=i, **letters) for i in range(len(found) + 1, len(found) + count + 1)]
        return found

    def latex(self) -> str:
        r"""In LaTeX, as the paper would write it."""
        import sympy

        parts = []
        for x, n in self.runs:
            text = sympy.latex(x.as_expr().subs("w", sympy.sqrt(2)))
            parts.append(text if n == 1 else f"{{{text}}}^{{\\{{{sympy.latex(n.as_expr())}\\}}}}")
        return r"\left(" + ",\\, ".join(parts) + r"\right)"


def runs(*pairs: tuple[str, str]) -> RunVector:
    """A vector from pairs (value, how many times), as text."""
    return RunVector(tuple((rational_function(x), rational_function(n)) for x, n in pairs))


def inner(x: RunVector, y: RunVector, case: Case) -> Rational:
    """The inner product of two vectors throughout a range, in the range's parameters.

    Raises
    ------
    Undecided
        If the range does not say which of two runs ends first, or that a run has no negative length.

    Examples
    --------
    >>> from .cases import case
    >>> inner(runs(("1/2", "k"), ("0", "d - k")), runs(("1", "d")), case("0 <= k <= d"))
    a/2
    """
    return total_of([x, y], case, lambda values: values[0] * values[1])


def square(x: RunVector, case: Case) -> Rational:
    """The squared length of a vector."""
    return inner(x, x, case)


def squared_distance(x: RunVector, y: RunVector, case: Case) -> Rational:
    """The squared distance of two points."""
    return total_of([x, y], case, lambda values: (values[0] - values[1]) ** 2)


def total(x: RunVector, case: Case) -> Rational:
    """The sum of the coordinates."""
    return total_of([x], case, lambda values: values[0])


def same(x: RunVector, y: RunVector, case: Case) -> bool:
    """Whether two vectors agree throughout a range."""
    return case.equal(x.length, y.length) and is_zero(squared_distance(x, y, case))


def segments(vectors: Sequence[RunVector], case: Case) -> list[tuple[Rational, Rational, Values]]:
    """The pieces on which all vectors have one formula: (last coordinate before, last coordinate, values)."""
    tracks = []
    for vector in vectors:
        reached, track = FIELD(0), []
        for x, n in vector.runs:
            length = case(n)
            if not Case(case.text, {}, case.parameters).nonnegative(length):
                raise Undecided(f"the run {x}^{{{n}}} may have negative length for {case.text}")
            if length.denom != 1 or any(q for _, q in coefficients(length.numer).values()):
                raise Undecided(f"the run {x}^{{{n}}} need not have an integer length for {case.text}")
            reached = reached + length
            track.append((reached, case(x)))
        tracks.append(track)
    ends = {track[-1][0] for track in tracks}
    if len(ends) != 1:
        raise Undecided(f"the vectors have different lengths for {case.text}: {sorted(map(str, ends))}")
    pieces, start = [], FIELD(0)
    while tracks[0]:
        end = _least([track[0][0] for track in tracks], case)
        pieces.append((start, end, tuple(track[0][1] for track in tracks)))
        start = end
        tracks = [track[1:] if track[0][0] == end else track for track in tracks]
        if len({bool(track) for track in tracks}) == 2:  # a run of length 0 at the end
            tracks = [track or [(start, FIELD(0))] for track in tracks]
            if not all(track[0][0] == start for track in tracks):
                raise Undecided(f"the vectors end at different places for {case.text}")
            break
    return pieces


def case_sign(case: Case, x: Rational) -> int:
    """The sign of something that is given in the parameters already."""
    return Case(case.text, {}, case.parameters).sign(x)


def _least(ends: Sequence[Rational], case: Case) -> Rational:
    least = ends[0]
    for end in ends[1:]:
        if case_sign(case, end - least) < 0:
            least = end
    return least


def total_of(vectors: Sequence[RunVector], case: Case, summand: Callable[[Values], Rational]) -> Rational:
    """The sum over all coordinates of an expression in those of several vectors."""
    result = FIELD(0)
    for start, end, values in segments(vectors, case):
        result = result + _sum(summand(values), start, end)
    return result


def sum_over(x: Rational, letter: str, low: Rational | str, high: Rational | str) -> Rational:
    """The sum of a rational function over a letter from `low` to `high`; with low = high + 1 it is 0.

    >>> sum_over(rational_function("k/2"), "k", "2", "d")
    (d**2 + d - 2)/4
    """
    moves = [(SYMBOLS[letter].numer, NUMBER.numer)]
    moved = FIELD(x.numer.compose(moves)) / FIELD(x.denom.compose(moves))
    start, end = (rational_function(end) if isinstance(end, str) else end for end in (low, high))
    return _sum(moved, start - 1, end)


def _sum(x: Rational, start: Rational, end: Rational) -> Rational:
    """The sum of x over i = start + 1 … end: a polynomial in i, summed power by power."""
    powers: dict[int, Rational] = {}
    position = x.field.gens.index(NUMBER)
    if "i" in letters_of(FIELD(x.denom)) or max((m[position] for m in x.numer.monoms()), default=0) > 4:
        raise Undecided(f"there is no closed form here for the sum of {x} over i")
    for monomial, coefficient in x.numer.terms():
        rest = tuple(0 if n == position else e for n, e in enumerate(monomial))
        term = FIELD(x.numer.ring({rest: coefficient})) / FIELD(x.denom)
        powers[monomial[position]] = powers.get(monomial[position], FIELD(0)) + term
    return sum((c * (_POWER_SUMS[n](end) - _POWER_SUMS[n](start)) for n, c in powers.items()), FIELD(0))


_POWER_SUMS: dict[int, Callable[[Rational], Rational]] = {
    0: lambda q: q,
    1: lambda q: q * (q + 1) / 2,
    2: lambda q: q * (q + 1) * (2 * q + 1) / 6,
    3: lambda q: (q * (q + 1) / 2) ** 2,
    4: lambda q: q * (q + 1) * (2 * q + 1) * (3 * q**2 + 3 * q - 1) / 30,
}
