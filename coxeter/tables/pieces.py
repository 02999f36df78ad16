"""Text with formulas and names of types in it: taken apart, and written as HTML."""

from __future__ import annotations

import html
import re
from collections.abc import Iterator
from typing import NamedTuple

from ..families.writing import is_telling, latex

MATHS = "math notranslate nohighlight"
"""The classes by which the book's script for formulas knows them."""

TYPE = re.compile(r"\b([A-G])~_?(?:\{(\w+)\}|(\w+)\b)?(?!\w)")
SET = re.compile(r"\\tilde\{([A-G])\}(?:_\{(\w+)\})?")
SPACE = re.compile(r"\bR\^(?:\{([^{}]+)\}|(\w))")
INDEX = re.compile(r"([A-Za-zλμσντρφ])_(?:\{([^{}]+)\}|(\w))(?![\w^])")
REPEATED = re.compile(r"(?:\((-?\d+(?:/\d+)?)\)|(-?\d+(?:/\d+)?))\^\{([^{}]+)\}")
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
        return Piece("math", run_latex(match[1] or match[2], match[3])), match.end()
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


def run_latex(x: str, n: str) -> str:
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
    return html.escape(polished(piece.text), quote=False)


def polished(words: str) -> str:
    """Words with the signs of print, for those of a keyboard and of a program.

    >>> polished("<x, r> >= -1: the aspect_ratio")
    '⟨x, r⟩ ≥ \u22121: the aspect ratio'
    """
    if words == " - ":  # between two formulas
        return " \u2212 "
    text = re.sub(r"<(?=[\w(])", "⟨", words).replace(">=", "≥").replace("<=", "≤")
    text = re.sub(r"(?<=[\w)}])>|(?<=^)>(?=$)", "⟩", text)
    text = re.sub(r"(?<![\w\u2212-])-(?=\d)|(?<=[(, ])-$", "\u2212", text)
    return re.sub(r"\b([a-z]{2,})_([a-z]{2,})\b", r"\1 \2", text)


def type_html(name: str) -> str:
    r"""The name of a type, from its LaTeX, without the weight of a formula.

    >>> type_html(r"\tilde{B}_{3}")
    '<span class="lg-type">B\u0303<sub>3</sub></span>'
    """
    letter, _, index = name.partition("_")
    below = f"<sub>{html.escape(index.strip('{}'))}</sub>" if index else ""
    return f'<span class="lg-type">{letter[7]}\N{COMBINING TILDE}{below}</span>'
