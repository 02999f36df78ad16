"""Text with formulas and names of types in it: taken apart, and written as HTML."""

from __future__ import annotations

import html
import re
import unicodedata
from collections.abc import Iterator
from typing import NamedTuple

from ..families.writing import is_telling, latex

MATHS = "math notranslate nohighlight"
"""The classes by which the book's script for formulas knows them."""

TYPE = re.compile(r"\b([A-G])~_?(?:\{(\w+)\}|(\w+)\b)?(?!\w)")
SET = re.compile(r"\\tilde\{([A-G])\}(?:_\{(\w+)\})?")
SPACE = re.compile(r"\bR\^(?:\{([^{}]+)\}|(\w))")
INDEX = re.compile(r"([A-Za-zλμσντρφ])_(?:\{([^{}]+)\}|(\w))(²?)(?![\w^])")
REPEATED = re.compile(r"(?:\(((?:[^(),]|\([^(),]*\))+)\)|(-?\d+(?:/\d+)?))\^\{([^{}]+)\}")
POWER = re.compile(r"(?<=[a-z]{2})\^\((\w+/\w+)\)")
"""A power of a word, as in ``fatness^(1/d)``."""
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
    >>> list(pieces("fatness^(1/d)"))
    [Piece(kind='words', text='fatness'), Piece(kind='math', text='{}^{1/d}')]
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
    if match := POWER.match(text, position):
        return Piece("math", f"{{}}^{{{match[1]}}}"), match.end()
    if position and (text[position - 1].isalnum() or text[position - 1] in "_^~"):
        return None
    if match := TYPE.match(text, position) or SET.match(text, position):
        index = match[2] or match[match.re.groups] or ""
        return Piece("type", rf"\tilde{{{match[1]}}}" + (f"_{{{index}}}" if index else "")), match.end()
    if match := SPACE.match(text, position):
        return Piece("math", rf"\mathbb{{R}}^{{{match[1] or match[2]}}}"), match.end()
    if match := INDEX.match(text, position):
        return Piece("math", f"{match[1]}_{{{match[2] or match[3]}}}{'^2' * len(match[4])}"), match.end()
    if (match := REPEATED.match(text, position)) and latex(match[1] or match[2]):
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


SIGNS = {
    "le": " ≤ ", "leq": " ≤ ", "ge": " ≥ ", "geq": " ≥ ", "ne": " ≠ ", "cdot": "·", "pm": "±",
    "sum": "Σ", "infty": "∞",
    "to": "→", "langle": "⟨", "rangle": "⟩", "vee": "∨", "dots": "…", "ldots": "…", "in": "∈", "times": "×",
    "hat": "", "left": "", "right": "", "operatorname": "", "mathbf": "", "text": "", "quad": " ", "rm": "",
    "mathbb": "", "vec": "", "bigl": "", "bigr": "", "notin": "∉",
}  # fmt: skip


def in_signs(tex: str) -> str:
    r"""A formula in plain signs, where nothing sets formulas.

    >>> in_signs(r"\frac{d + 1}{2d}"), in_signs(r"1\le i<j\le d"), in_signs(r"\sqrt2\,\pi")
    ('(d + 1)/(2d)', '1 ≤ i<j ≤ d', '√2π')
    """
    text = re.sub(r"\\(?:[td])frac", r"\\frac", tex).replace(r"\{", "\ue000").replace(r"\}", "\ue001")
    text = re.sub(r"\\tilde\s*\{?\s*(\w)\}?", "\\1\N{COMBINING TILDE}", text)
    text = re.sub(r"\\frac\s*(\d)(\d)", r"\1/\2", re.sub(r"\\[,;:! ]", "", text))
    text = re.sub(r"\\(?:operatorname|mathbf|mathbb|text|rm)\s*\{(\w+)\}", r"\1", text)
    text = re.sub(r"\\frac\s*(\w)\s*(?=\{)", r"\\frac{\1}", text)
    text = re.sub(r"(\\frac\{[^{}]*\})\s*(\w)", r"\1{\2}", text)
    for _ in range(6):  # from the inside
        text = re.sub(r"\\sqrt\s*\{([^{}]*)\}", lambda m: "√" + _grouped(m[1]), text)
        text = re.sub(
            r"\\frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}", lambda m: f"{_grouped(m[1])}/{_grouped(m[2])}", text
        )
        text = re.sub(r"([_^])\{([^{}]*)\}", lambda m: m[1] + _grouped(m[2]), text)
    text = re.sub(r"\\([A-Za-z]+)\s?", lambda m: SIGNS.get(m[1], _letter(m[1])), text).replace("√√", "√")
    text = re.sub(r"(?<![_^])\{([^{}]*)\}", r"\1", text).replace("\ue000", "{").replace("\ue001", "}")
    return unicodedata.normalize("NFC", re.sub(r"\^\((\{[^{}]*\})\)", r"^\1", " ".join(text.split())))


def _grouped(text: str) -> str:
    return text if re.fullmatch(r"-?\w|-?\d+|√(\w+|\([^()]*\))|\(.*\)|\w+!", text) else f"({text})"


def _letter(name: str) -> str:
    size = "CAPITAL" if name[0].isupper() else "SMALL"
    try:
        return unicodedata.lookup(f"GREEK {size} LETTER {name.removeprefix('var').upper()}")
    except KeyError:
        return "√" if name == "sqrt" else name


def polished(words: str) -> str:
    """Words with the signs of print, for those of a keyboard and of a program.

    >>> polished("<x, r> >= -1: the aspect_ratio")
    '⟨x, r⟩ ≥ \u22121: the aspect ratio'
    >>> polished("Rajan's c', for k - j")
    'Rajan\u2019s c\u2032, for k \u2212 j'
    """
    if words == " - ":  # between two formulas
        return " \u2212 "
    text = re.sub(r"<(?=[\w(])", "⟨", words).replace(">=", "≥").replace("<=", "≤")
    text = re.sub(r"(?<=[\w)}])>|(?<=^)>(?=$)", "⟩", text)
    text = re.sub(r"(?<![\w\u2212-])-(?=\d)|(?<=[(, ])-$", "\u2212", text)
    text = re.sub(r"(?<=\b\w) - (?=[\w(])", " \u2212 ", text)
    text = re.sub(r"(?<!['\w])([A-Za-z])'(?!\w)", "\\1\u2032", re.sub(r"(?:(?<=\w)|^)'s\b", "\u2019s", text))
    return re.sub(r"\b([a-z]{2,})_([a-z]{2,})\b", r"\1 \2", text)


def type_html(name: str) -> str:
    r"""The name of a type, from its LaTeX, without the weight of a formula.

    >>> type_html(r"\tilde{B}_{3}")
    '<span class="lg-type">B\u0303<sub>3</sub></span>'
    """
    letter, _, index = name.partition("_")
    below = f"<sub>{html.escape(index.strip('{}'))}</sub>" if index else ""
    return f'<span class="lg-type">{letter[7]}\N{COMBINING TILDE}{below}</span>'
