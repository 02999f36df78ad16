"""The numbers of the explorer: the four measures of all types up to a dimension, exact and rounded once."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import groupby
from typing import NamedTuple

from ..affine import CoxeterTriangulation
from ..errors import InvalidInput, Undecided
from ..exact import Surd
from ..families import closed_form
from ..names import MINIMAL_DIMENSION, Type, triangulations_up_to
from ..quality import PAPER_MEASURES, find_measure
from ..symbolic.radicals_limits import Growth, growth

MAX_DIM = 64
"""The largest dimension of the explorer."""

MEASURES = tuple(known.name for known in PAPER_MEASURES)
SHOWN = 40
"""An exact value of more characters is given by the formula in d that it comes from."""


class Quality(NamedTuple):
    """A measure of a type: divided by that of the regular simplex, fatness also to the power 1/d; and raw."""

    normalized: Surd
    raw: Surd


@lru_cache(maxsize=1)
def qualities() -> Mapping[tuple[str, Type], Quality]:
    """Each measure of each type up to dimension `MAX_DIM`, from the fundamental simplices.

    >>> qualities()["thickness", Type("B", 3)].normalized
    sqrt(3)/4
    """
    return {
        (known.name, kind): Quality(known.normalized(simplex), known(simplex))
        for kind in triangulations_up_to(MAX_DIM)
        for simplex in (CoxeterTriangulation(kind).simplex,)
        for known in PAPER_MEASURES
    }


def types_in(d: int) -> list[Type]:
    """The types of one dimension."""
    return [kind for kind in triangulations_up_to(d) if kind.rank == d]


def ranking(measure: str, d: int) -> list[list[Type]]:
    """The types of a dimension, the best first; those of equal value together. Decided exactly.

    >>> [[kind.affine for kind in equal] for equal in ranking("thickness", 4)]
    [['A~4'], ['B~4', 'C~4', 'D~4'], ['F~4']]
    """
    find_measure(measure)
    if not 2 <= d <= MAX_DIM:
        raise InvalidInput(f"{d} is no dimension of the explorer: give one from 2 to {MAX_DIM}")

    def value(kind: Type) -> Surd:
        return qualities()[measure, kind].normalized

    best_first = sorted(types_in(d), key=value, reverse=True)
    return [list(equal) for _, equal in groupby(best_first, key=value)]


@lru_cache(maxsize=64)
def rate(letter: str, measure: str, raw: bool = False) -> Growth | None:
    """The power of d that a measure falls with in a family, and its constant; None if it is no power.

    >>> rate("C", "radius_ratio", raw=True)
    Growth(coefficient=sqrt(2), degree=Fraction(-3, 2))
    >>> rate("A", "fatness", raw=True) is None
    True
    """
    form = closed_form(letter, measure if raw else f"normalized_{measure}")
    try:
        found = {growth(piece.text) for piece in form.pieces if piece.high is None}
    except Undecided:
        return None
    (only,) = found  # the same for odd and for even d
    return only


# -- how numbers are written ---------------------------------------------------------------------------------


def readable(text: str) -> str:
    """A formula of the library without signs that only a computer needs.

    >>> readable("2*sqrt(22)/(2 + 21*sqrt(2))"), readable("2**(1/2 + 1/d)/(sqrt(d)*(d + 1)**(1/(2*d)))")
    ('2√22/(2 + 21√2)', '2^(1/2 + 1/d)/(√d·(d + 1)^(1/(2d)))')
    """
    text = re.sub(r"sqrt\((\w+)\)", r"√\1", text).replace("sqrt(", "√(")
    text = re.sub(r"factorial\((\w+)\)", r"\1!", text).replace("**", "^")
    text = re.sub(r"(?<![\w!^/])(\d+)\*(?=[d√(])", r"\1", text)
    return text.replace("*", "·")


def short(kind: Type, measure: str, raw: bool = False) -> str:
    """The exact value if it is short, else the formula in d that it comes from.

    >>> short(Type("B", 5), "thickness"), short(Type("D", 34), "fatness")
    ('√6/6', '2^(1/2 + 2/d)/(√d·(d + 1)^(1/(2d))) for d = 34')
    """
    quality = qualities()[measure, kind]
    text = readable(str(quality.raw if raw else quality.normalized))
    if len(text) <= SHOWN or kind.letter not in MINIMAL_DIMENSION:
        return text
    form = closed_form(kind.family, measure if raw else f"normalized_{measure}")
    formula = next(piece.text for piece in form.pieces if piece.covers(kind.rank))
    return f"{readable(formula)} for d = {kind.rank}"


def rounded(x: Surd) -> str:
    """Six digits after the point, or seven that count if the number is small; rounded once.

    >>> from coxeter.exact import sqrt
    >>> rounded(sqrt(3) / 2), rounded(sqrt(3) / 10**20)
    ('0.866025', '1.732051e-20')
    """
    return x.decimal(6) if x == 0 or abs(x) > Surd("1/100") else x.scientific(7)


def scaled(x: Surd, found: Growth, d: int) -> Surd:
    """A value divided by the power of d that it falls with."""
    return x * Surd(d) ** -found.degree


# -- the file ------------------------------------------------------------------------------------------------


def as_csv() -> str:
    """All values, exact and rounded."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(("type", "d", "measure", "normalised", "decimal", "not normalised", "decimal"))
    writer.writerows(_rows())
    return out.getvalue()


def _rows() -> Iterator[tuple[str, ...]]:
    for (measure, kind), x in qualities().items():
        values = (str(x.normalized), rounded(x.normalized), str(x.raw), rounded(x.raw))
        yield (kind.affine, str(kind.rank), measure, *values)
