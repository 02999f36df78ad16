r"""How a printed constant is put into a statement: as ``{name}``, or in another form.

``{name?words|other words}`` gives the first words if the constant is true, else the others; a form may be

=============  =====================  =============================================
``{n:words}``  a small number         *three*
``{n:times}``  a factor               nothing for 1, a minus for -1
``{n:plus}``   a later factor         ``+ ``, ``- 2``
``{x:pi}``     a multiple of π        $\frac{5\pi}{6}$
``{x:and}``    some constants         *0 and 1*
``{x:where}``  a position             *on its boundary*
``{x:ends}``   whether ends belong    *without the first*
``{x:sum}``    (factor, index)        $2u_1 - u_k$
``{x:signed}`` indices with signs     $e_1 - e_2$
``{x:run}``    (coordinate, count)    $(1^{\{d + 1\}})$
``{x:i<j}``    the ends of a range    $1\le i<j\le d$
=============  =====================  =============================================
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from typing import Any

PLACE = re.compile(r"(?<![\\_^])\{(\w+)(?:\?([^{}|]*)\|([^{}|]*)|:([\w<]+))?\}")
NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")
WHERE = {"inside": "inside it", "boundary": "on its boundary", "outside": "outside it"}
ENDS = ("without its ends", "without the first end", "without the last end", "with both ends")


def fill(words: str, constants: Mapping[str, Any], put: Callable[[re.Match[str]], str]) -> str:
    """Words with their constants: `put` writes those that stand alone in their braces.

    >>> fill("It is {good?true|false} for {ends:i}.", {"good": False, "ends": (1, "d")}, lambda match: "")
    'It is false for $1\\\\le i\\\\le d$.'
    """

    def at(match: re.Match[str]) -> str:
        name, yes, no, form = match.groups()
        if name not in constants or (form is None and yes is None):
            return put(match)
        return FORMS.get(form, _range(form))(constants[name]) if form else yes if constants[name] else no

    return PLACE.sub(at, words)


def says(words: str, name: str) -> bool:
    """Whether a constant has a place in the words."""
    return any(match[1] == name for match in PLACE.finditer(words))


def _times(factor: Any) -> str:
    return {"1": "", "-1": "-"}.get(str(factor), str(factor))


def _plus(factor: Any) -> str:
    sign, size = ("-", str(factor)[1:]) if str(factor).startswith("-") else ("+", str(factor))
    return f"{sign} " if size == "1" else f"{sign} {size}"


def _pi(value: Any) -> str:
    r"""Multiples of π.

    >>> _pi(("0", "1", "5/6"))
    '$0$, $\\pi$, $\\frac{5\\pi}{6}$'
    """
    if isinstance(value, tuple):
        return ", ".join(map(_pi, value))
    x = Fraction(value)
    over = rf"{_times(x.numerator)}\pi" if x else "0"
    return f"${over}$" if x.denominator == 1 else rf"$\frac{{{over}}}{{{x.denominator}}}$"


def _sum(terms: Iterable[tuple[Any, str]]) -> str:
    """A sum of multiples.

    >>> _sum([("1", "u_d"), ("-1", "u_1"), ("3", "u_2")])
    '$u_d - u_1 + 3u_2$'
    """
    (factor, first), *rest = terms
    return f"${_times(factor)}{first}{''.join(f' {_plus(n)}{of}' for n, of in rest)}$"


def _signed(indices: tuple[Any, ...]) -> str:
    if isinstance(indices[0], tuple):
        return ", ".join(map(_signed, indices))
    return _sum((1 if int(i) > 0 else -1, f"e_{{{abs(int(i))}}}") for i in indices)


def _range(letters: str | None) -> Callable[[Any], str]:
    def write(ends: Any) -> str:
        low, high = ends
        return f"${letters} = {low}$" if low == high else rf"${low}\le {letters}\le {high}$"

    return write


FORMS: dict[str | None, Callable[[Any], str]] = {
    "words": lambda n: NUMBERS[n] if isinstance(n, int) and 0 <= n < len(NUMBERS) else str(n),
    "times": _times,
    "plus": _plus,
    "pi": _pi,
    "and": lambda values: " and ".join(", ".join(map(str, values)).replace("_", " ").rsplit(", ", 1)),
    "where": lambda place: WHERE.get(place, str(place)),
    "ends": lambda belong: ENDS[2 * bool(belong[0]) + bool(belong[1])],
    "sum": lambda terms: _sum((n, f"u_{{{index}}}") for n, index in terms),
    "signed": _signed,
    "run": lambda run: rf"$({run[0] or '?'}^{{\{{{run[1]}\}}}})$",
}
