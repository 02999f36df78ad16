"""Coordinates written as runs, with counts and values that are formulas."""

from __future__ import annotations

import re

from ..errors import InvalidInput
from ..exact import Exact, Surd, show
from ..families import evaluate
from ..paper import Runs

Point = tuple[Exact, ...]


def numbers(first: str, last: str, d: int) -> range:
    """The values of an index that runs from one formula in d to another."""
    return range(int(evaluate(first, d=d).as_fraction()), int(evaluate(last, d=d).as_fraction()) + 1)


def coordinates(runs: Runs, d: int, k: int) -> Point | None:
    """Write out runs of equal coordinates; None if a count is negative or a formula has no value.

    >>> coordinates((("1/2", "k"), ("0", "d - k")), 3, 2)
    (Fraction(1, 2), Fraction(1, 2), Fraction(0, 1))
    """
    point: list[Exact] = []
    try:
        for text, count in runs:
            n = int(evaluate(count, d=d, k=k).as_fraction())
            if n < 0:
                return None
            if "i" in text:
                start = len(point) + 1
                point += [_plain(evaluate(text, d=d, k=k, i=i)) for i in range(start, start + n)]
            else:
                point += [_plain(evaluate(text, d=d, k=k))] * n
    except (InvalidInput, ZeroDivisionError):
        return None
    return tuple(point)


def _plain(x: Surd) -> Exact:
    """A fraction if possible: fractions are compared faster."""
    return x.as_fraction() if x.is_rational else x


def spell_runs(runs: Runs) -> str:
    """Runs as text: ``(1/2^{k}, 0^{d - k})``."""
    plain = [value if re.fullmatch(r"[\w/-]+", value) else f"({value})" for value, _ in runs]
    counts = ["" if count == "1" else f"^{{{count}}}" for _, count in runs]
    return show([value + count for value, count in zip(plain, counts, strict=True)])
