"""Statements and corrections: text with formulas and names of types, read once, written as HTML or LaTeX."""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from ..ledger.claim import Claim, Constants, spell
from ..ledger.phrases import fill
from .formulas import is_telling, latex
from .markup import MATHS

TYPE = re.compile(r"\b([A-G])~_?(?:\{(\w+)\}|(\w+)\b)?(?!\w)")
SET = re.compile(r"\\tilde\{([A-G])\}(?:_\{(\w+)\})?")
SPACE = re.compile(r"\bR\^(?:\{([^{}]+)\}|(\w))")
INDEX = re.compile(r"([A-Za-zλμσντρφ])_(?:\{([^{}]+)\}|(\w))(?![\w^])")
REPEATED = re.compile(r"(-?\d+(?:/\d+)?)\^\{([^{}]+)\}")
RUN = re.compile(r"(?<![\w$])[-(\w][\w+\-*/().]*(?: [+\-*/] ?[\w+\-*/().]+)*")
"""Where a formula in the library's notation may stand in a sentence."""


class Piece(NamedTuple):
    """A piece of a text: ``words``, ``math`` in LaTeX, or ``type``, the LaTeX of its name."""

    kind: str
    text: str


def pieces(text: str) -> Iterator[Piece]:
    """The pieces of a text.

    >>> for piece in pieces(r"For A~3 it is $\\sqrt2$, not sqrt(3)/2."):
    ...     print(f"{piece.kind}: '{piece.text}'")
    words: 'For '
    type: '\\tilde{A}_{3}'
    words: ' it is '
    math: '\\sqrt2'
    words: ', not '
    math: '\\frac{\\sqrt{3}}{2}'
    words: '.'
    """
    parts = text.split("$")
    if len(parts) % 2 == 0:  # a dollar that is none
        parts[-2:] = ["$".join(parts[-2:])]
    for count, part in enumerate(parts):
        if count % 2:
            yield Piece("math", part)
        elif part:
            yield from _plain(part)


def _plain(text: str) -> Iterator[Piece]:
    """Words, with the names of types and the formulas among them."""
    position, words = 0, ""
    while position < len(text):
        found = _at(text, position)
        if found is None:
            words += text[position]
            position += 1
            continue
        piece, position = found
        if words:
            yield Piece("words", words)
            words = ""
        yield piece
    if words:
        yield Piece("words", words)


def _at(text: str, position: int) -> tuple[Piece, int] | None:
    """What stands at a position, if it is more than words, and where it ends."""
    if position and (text[position - 1].isalnum() or text[position - 1] in "_^~"):
        return None
    if match := TYPE.match(text, position) or SET.match(text, position):
        index = match[2] or match[match.re.groups] or ""
        return Piece("type", rf"\tilde{{{match[1]}}}" + (f"_{{{index}}}" if index else "")), match.end()
    if match := SPACE.match(text, position):
        return Piece("math", rf"\mathbb{{R}}^{{{match[1] or match[2]}}}"), match.end()
    if match := INDEX.match(text, position):
        return Piece("math", f"{match[1]}_{{{match[2] or match[3]}}}"), match.end()
    if match := REPEATED.match(text, position):
        return Piece("math", _run_latex(match[1], match[2])), match.end()
    if (match := RUN.match(text, position)) and (formula := _formula(match[0])):
        return Piece("math", str(latex(formula))), position + len(formula)
    return None


def _formula(run: str) -> str:
    """The longest beginning of a run of letters that is a formula; empty if there is none."""
    ends = {len(run), *(match.start() for match in re.finditer(r"[ .)]|(?<=\))", run))}
    for end in sorted(ends, reverse=True):
        text = run[:end].rstrip(" .+-*/(")
        if text and is_telling(text) and not re.fullmatch(r"\d+-\d+", text):
            return "" if text[0] == "(" and latex(text[1:-1]) else text  # parentheses around it stay words
    return ""


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
    return ", ".join(_run_latex(x, n) for x, n in runs)


def _run_latex(x: str, n: str) -> str:
    coordinate = str(latex(x))
    if n == "1":
        return coordinate
    base = coordinate if coordinate.isalnum() else f"({coordinate})"
    return rf"{base}^{{\{{{latex(n)}\}}}}"


# -- HTML -------------------------------------------------------------------------------------------------


def to_html(text: str, maths: str = MATHS) -> str:
    """A text as HTML; the class of a formula tells the book's script for formulas to set it."""
    return "".join(_html(piece, maths) for piece in pieces(text))


def _html(piece: Piece, maths: str) -> str:
    if piece.kind == "math":
        return rf'<span class="{maths}">\({html.escape(piece.text)}\)</span>'
    if piece.kind == "type":
        return type_html(piece.text)
    return html.escape(piece.text, quote=False)


def type_html(name: str) -> str:
    r"""The name of a type, from its LaTeX, without the weight of a formula.

    >>> type_html(r"\tilde{B}_{3}")
    '<span class="lg-type">B\u0303<sub>3</sub></span>'
    """
    letter, _, index = name.partition("_")
    below = f"<sub>{html.escape(index.strip('{}'))}</sub>" if index else ""
    return f'<span class="lg-type">{letter[7]}\N{COMBINING TILDE}{below}</span>'


def to_plain(text: str) -> str:
    """A text for a title attribute: as it was written, without dollar signs."""
    return text.replace("$", "")


def type_plain(text: str) -> str:
    """The names of types in a text, written with one tilde above the letter.

    >>> type_plain("A~, item 7; E~6 and A~_{d}")
    'A\u0303, item 7; E\u03036 and A\u0303_d'
    """

    def put(match: re.Match[str]) -> str:
        index = match[2] or match[3] or ""
        between = "_" if index and not index.isdigit() else ""
        return f"{match[1]}\N{COMBINING TILDE}{between}{index}"

    return TYPE.sub(put, text)
