"""Statements and corrections: text with formulas and names of types, read once, written as HTML or LaTeX."""

from __future__ import annotations

import re
from typing import Any

from ..families.writing import is_telling, latex
from ..ledger.claim import Claim, Constants, spell
from ..ledger.phrases import fill
from ..tables.pieces import TYPE, in_signs, pieces, polished, run_latex, to_html, type_html

__all__ = ["pieces", "polished", "shown", "statement", "to_html", "to_plain", "type_html", "type_plain"]

# -- statements -------------------------------------------------------------------------------------------


def statement(claim: Claim, constants: Constants | None = None) -> str:
    """The statement with its printed constants, or with others, formulas between dollar signs."""
    values = claim.printed if constants is None else constants

    def put(match: re.Match[str]) -> str:
        name = match[1]
        return shown(values[name]) if name in values else NOTHING if name in PLACES else match[0]

    text = fill(claim.words, values, put)
    return re.sub(r"\b([A-Za-z])\^\(\$?([^$()]+)\$?\)", r"$\1^{\2}$", text)


GREEK = {"Theta": r"\Theta"}
NOTHING, PLACES = "[nothing is printed]", ("formula", "decimal", "point", "text", "label")
"""What stands where our copy has nothing, and the names of the constants for which that happens."""


def shown(value: Any) -> str:
    """A constant as it is shown: formulas and vectors between dollar signs.

    >>> shown("sqrt(d)/2"), shown((("1/2", "k"), ("0", "d - k"))), shown(("A", "F4")), shown(True)
    ('$\\\\frac{\\\\sqrt{d}}{2}$', '$(\\\\frac{1}{2})^{\\\\{k\\\\}}, 0^{\\\\{d - k\\\\}}$', 'A, F4', 'true')
    """
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        if value == "":
            return NOTHING
        if value in GREEK:
            return f"${GREEK[value]}$"
        if re.fullmatch(r"\\tilde\{.*|.*_\{.*", value):
            return f"${value}$"
        return f"${latex(value)}$" if is_telling(value) else value
    if _is_runs(value):
        return f"${runs_latex(value)}$"
    if isinstance(value, tuple) and value and all(isinstance(x, tuple) for x in value):
        return ", ".join(f"({shown(x)})" for x in value)
    return ", ".join(map(shown, value)) if isinstance(value, tuple) else spell(value)


def _is_runs(value: Any) -> bool:
    """Whether a constant is a vector in runs, (coordinate, how often) each."""
    return isinstance(value, tuple) and bool(value) and all(
        isinstance(run, tuple) and len(run) == 2 and all(isinstance(x, str) and latex(x) for x in run)
        for run in value
    )  # fmt: skip


def runs_latex(runs: tuple[tuple[str, str], ...]) -> str:
    """The coordinates of a vector in runs, as the paper writes them."""
    return ", ".join(run_latex(x, n) for x, n in runs)


# -- plain ----------------------------------------------------------------------------------------------


def to_plain(text: str) -> str:
    r"""A text for a title attribute: its formulas in plain signs.

    >>> to_plain(r"For $\tilde A_d$ it is $\frac{\sqrt{d + 1}}{2}$, not $0^{\{d - 1\}}$.")
    'For Ã_d it is √(d + 1)/2, not 0^{d - 1}.'
    """
    parts = text.split("$")
    return type_plain("".join(in_signs(part) if n % 2 else part for n, part in enumerate(parts)))


BELOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def type_plain(text: str) -> str:
    """The names of types in a text, written with one tilde above the letter.

    >>> type_plain("A~, item 7; E~6 and A~_{d}")
    'A\u0303, item 7; E\u0303₆ and A\u0303_d'
    """

    def put(match: re.Match[str]) -> str:
        index = match[2] or match[3] or ""
        between = "_" if index and not index.isdigit() else ""
        return f"{match[1]}\N{COMBINING TILDE}{between}{index.translate(BELOW)}"

    return TYPE.sub(put, text)
