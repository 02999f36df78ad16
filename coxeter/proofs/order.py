"""Which of two families has the greater value of a measure, in every dimension. Paper: Section 5, Table 2.

In one dimension the normalised and the raw values stand in the same order. Squares are compared, as rational
functions of d over QQ(√2); for fatness 2d-th powers, whose quotients are constant.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

from ..errors import InvalidInput, Undecided
from ..exact import Surd
from ..families import closed_form
from ..names import MINIMAL_DIMENSION
from ..symbolic.cases import case
from .best import LEAD, SQUARES, best
from .proof import Proof, Refuted, ReplayFailed, Step, computed, formulas, inequality, join

LATEST = 16
"""The order of two families settles before this dimension, or is not found."""


class Lead(NamedTuple):
    """A stretch of dimensions in which one family is ahead; none is where the two are equal.

    `last` is None if the stretch has no end.
    """

    first: int
    last: int | None
    ahead: str


def leads(measure: str, x: str, y: str) -> tuple[Lead, ...]:
    """Which of two families is ahead, in every dimension in which both exist: proved, not sampled.

    Raises
    ------
    InvalidInput
        If there is no such measure or family.

    Examples
    --------
    >>> leads("radius_ratio", "C", "D")
    (Lead(first=4, last=5, ahead='D'), Lead(first=6, last=None, ahead='C'))
    >>> leads("thickness", "B", "C")
    (Lead(first=3, last=3, ahead='C'), Lead(first=4, last=None, ahead=''))
    """
    for letter in (x, y):
        if letter not in MINIMAL_DIMENSION:
            raise InvalidInput(f"{letter!r} is no family; there are {', '.join(MINIMAL_DIMENSION)}")
    if measure not in (*SQUARES, "fatness"):
        raise InvalidInput(f"{measure!r} is not compared; there are {', '.join((*SQUARES, 'fatness'))}")
    return _leads(measure, *sorted((x, y))) if x != y else ()


@lru_cache(maxsize=64)
def _leads(measure: str, x: str, y: str) -> tuple[Lead, ...]:
    first = max(MINIMAL_DIMENSION[x], MINIMAL_DIMENSION[y])
    if x == "A":
        best(measure)
        return (Lead(first, None, "A"),)
    start, ahead, _ = _settled(measure, x, y)
    found = [Lead(start, None, ahead)]
    for d in range(start - 1, first - 1, -1):
        here, after = _ahead(measure, x, y, d), found[0]
        found[:1] = [after._replace(first=d)] if here == after.ahead else [Lead(d, d, here), after]
    return tuple(found)


def order(measure: str) -> Proof:
    """The order of the four families by a measure, in every dimension.

    >>> order("aspect_ratio").replay(8) > 0
    True
    """
    return join(
        rf"the order of $\tilde A_d$, $\tilde B_d$, $\tilde C_d$, $\tilde D_d$ by {measure.replace('_', ' ')}"
        r" in every dimension",
        best(measure).steps,
        *(_steps(measure, x, y) for x, y in combinations("BCD", 2)),
    )


def _steps(measure: str, x: str, y: str) -> Iterator[Step]:
    start, _, step = _settled(measure, x, y)
    for lead in leads(measure, x, y):
        stop = min(start, (lead.last or start) + 1)
        if lead.first < stop:
            yield _computed(measure, x, y, lead, range(lead.first, stop))
    yield step


def _computed(measure: str, x: str, y: str, lead: Lead, ds: range) -> Step:
    other = y if lead.ahead in (x, "") else x
    sign = ">" if lead.ahead else "="
    formula = rf"\hat\kappa(\tilde {lead.ahead or x}_d) {sign} \hat\kappa(\tilde {other}_d)"

    def test() -> int:
        for d in ds:
            if _ahead(measure, x, y, d) != lead.ahead:
                raise ReplayFailed(f"{measure}: {lead.ahead}~ is not ahead for d = {d}")
        return len(ds)

    words = rf"$\tilde {x}_d$ and $\tilde {y}_d$ in the first dimensions"
    return computed(words, formula, f"d = {', '.join(map(str, ds))}", test)


# -- from some dimension on -------------------------------------------------------------------------------


@lru_cache(maxsize=64)
def _settled(measure: str, x: str, y: str) -> tuple[int, str, Step]:
    """From which dimension on the order is the same for ever, which family is ahead, and the step."""
    low = max(closed_form(letter, f"normalized_{measure}").pieces[-1].low for letter in (x, y))
    if measure == "fatness":
        return _by_powers(x, y, low)
    a, b = (str(SQUARES[measure][letter]) for letter in (x, y))
    name = rf"\hat\kappa(\tilde {x}_d)^2 - \hat\kappa(\tilde {y}_d)^2"
    if case(f"{low} <= d", low).equal(a, b):
        words = rf"$\tilde {x}_d$ and $\tilde {y}_d$ are equal"
        return low, "", formulas(words, r"\hat\kappa^2", a, b, low)
    for start in range(low, LATEST):
        for ahead, other, difference in ((x, y, f"{a} - {b}"), (y, x, f"{b} - {a}")):
            try:
                where = case(f"{start} <= d", start)
                words = rf"$\tilde {ahead}_d$ is ahead of $\tilde {other}_d$"
                shown = name if ahead == x else rf"\hat\kappa(\tilde {y}_d)^2 - \hat\kappa(\tilde {x}_d)^2"
                return start, ahead, inequality(words, shown, difference, where, strict=True)
            except (Refuted, Undecided):
                continue
    raise Undecided(f"{measure}: the order of {x}~ and {y}~ does not settle before d = {LATEST}")


def _by_powers(x: str, y: str, low: int) -> tuple[int, str, Step]:
    """The 2d-th powers differ by a constant factor."""
    a, b = (LEAD[letter][0] for letter in (x, y))
    texts = (closed_form(letter, "normalized_fatness").pieces[-1].text for letter in (x, y))
    quotient = "/".join(f"({text})**(2*d)" for text in texts)
    name = rf"\left(\frac{{\hat\kappa(\tilde {x}_d)}}{{\hat\kappa(\tilde {y}_d)}}\right)^{{2d}}"
    words = rf"the quotient of $\tilde {x}_d$ and $\tilde {y}_d$"
    ahead = x if Surd(int(a)) > int(b) else y
    return low, ahead, formulas(words, name, quotient, f"{a}/{b}", low)


def _ahead(measure: str, x: str, y: str, d: int) -> str:
    """The family with the greater value in one dimension; empty if they are equal."""
    a, b = (closed_form(letter, f"normalized_{measure}").at(d) for letter in (x, y))
    return "" if a == b else x if a > b else y
