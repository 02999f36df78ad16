"""How an exact number is written: as plain text that SymPy reads, and as LaTeX."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import flint

from .sums import ONE, Terms


@dataclass(frozen=True)
class Style:
    """The templates of one notation."""

    root: str
    over: str
    times: str
    group: str
    power: str
    group_fractions: bool


PLAIN = Style("sqrt({})", "{}/{}", "*", "({})", "{}**(1/{})", group_fractions=True)
LATEX = Style(
    r"\sqrt{{{}}}",
    r"\frac{{{}}}{{{}}}",
    "",
    r"\left({}\right)",
    r"{}^{{1/{}}}",
    group_fractions=False,
)


def _integer(n: int) -> str:
    return str(flint.fmpz(n))  # Python refuses to print integers of more than 4300 digits


def _write_term(n: int, q: Fraction, style: Style) -> str:
    """One term ``|q|*sqrt(n)``, as ``3*sqrt(2)/8``."""
    top, bottom = abs(q.numerator), q.denominator
    text = _integer(top)
    if n > 1:
        radical = style.root.format(_integer(n))
        text = radical if top == 1 else text + style.times + radical
    return text if bottom == 1 else style.over.format(text, _integer(bottom))


def write_sum(terms: Terms, style: Style) -> str:
    """A sum of square roots, as ``1/2 - sqrt(3)``."""
    if not terms:
        return "0"
    text = "".join((" - " if q < 0 else " + ") + _write_term(n, q, style) for n, q in terms)
    return text[3:] if text.startswith(" + ") else "-" + text[3:]


def write(num: Terms, den: Terms, index: int, style: Style) -> str:
    """The number ``(num/den)**(1/index)``."""
    text = write_sum(num, style)
    if den != ONE:
        bottom = write_sum(den, style)
        if style.group_fractions:
            text = text if len(num) <= 1 and "/" not in text else style.group.format(text)
            bottom = style.group.format(bottom)
        text = style.over.format(text, bottom)
    if index > 1:
        text = style.power.format(text if text.isdigit() else style.group.format(text), index)
    return text
