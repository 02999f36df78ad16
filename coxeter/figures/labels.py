"""Labels in a little TeX, such as ``$\\tilde{B}_{3}$, marks``: read into runs of letters, and measured.

Matplotlib sets such a label by itself. For SVG it becomes text with shifted runs, so that it stays
text: it can be searched, copied and read aloud, and it scales with the page.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

_SIGNS = {"tau": "τ", "vee": "∨", "cdots": "⋯", "circ": "°", "leq": "≤", "sigma": "σ", "theta": "θ"}
_SIGNS |= {"delta": "δ", "ell": "ℓ", "pi": "π", "varrho": "ϱ", "varphi": "φ"}
_SAME = {"-": "\N{MINUS SIGN}", "'": "\N{PRIME}"}
"""How a sign of the keyboard is set in a formula."""
_TOKEN = re.compile(
    r"\\(?P<accent>tilde|hat)\{(?P<letter>.)\}|\\sqrt\{(?P<root>\d+)\}|\\(?P<sign>[a-z]+) ?|(?P<other>.)",
    re.DOTALL,
)
_SCRIPT = re.compile(r"(?P<shift>[_^])(?:\{(?P<group>[^{}]*)\}|(?P<one>\\[a-z]+|.))")
SCRIPT_SIZE = 0.7
"""The size of a subscript or superscript, relative to the line."""


class Run(NamedTuple):
    """Letters that are set alike.

    Attributes
    ----------
    letters
        The letters, in Unicode.
    math
        Whether they belong to a formula.
    italic
        Whether they are slanted, as variables are.
    level
        0 on the line, 1 for a superscript, -1 for a subscript.
    accent
        ``"~"`` or ``"^"`` above the one letter of this run. It is drawn as a line: few fonts can
        set a tilde above each letter.
    """

    letters: str
    math: bool
    italic: bool
    level: int
    accent: str = ""


def runs(label: str) -> tuple[Run, ...]:
    """The runs of a label; what stands between dollar signs is a formula.

    >>> [(run.letters, run.level) for run in runs(r"$\\tau_{d-1}$")]
    [('τ', 0), ('d', -1), ('−1', -1)]
    """
    found: list[Run] = []
    for count, part in enumerate(label.split("$")):
        if count % 2 == 0:
            found += [Run(part, False, False, 0)] if part else []
        else:
            found += _formula(part)
    return tuple(found)


def _formula(text: str) -> list[Run]:
    found, end = [], 0
    for match in _SCRIPT.finditer(text):
        found += _letters(text[end : match.start()], 0)
        found += _letters(match["group"] or match["one"], 1 if match["shift"] == "^" else -1)
        end = match.end()
    return found + _letters(text[end:], 0)


def _letters(text: str, level: int) -> list[Run]:
    found: list[Run] = []
    for match in _TOKEN.finditer(text):
        if match["accent"]:
            found.append(Run(match["letter"], True, True, level, {"tilde": "~", "hat": "^"}[match["accent"]]))
            continue
        letters = _SIGNS[match["sign"]] if match["sign"] else match["other"] or f"√{match['root']}"
        letters = _SAME.get(letters, letters)
        italic = letters.isalpha()
        if found and found[-1].italic == italic and not found[-1].accent:
            found[-1] = found[-1]._replace(letters=found[-1].letters + letters)
        else:
            found.append(Run(letters, True, italic, level))
    return found


def width(parts: Sequence[Run], size: float) -> float:
    """About how wide the runs of a label are, in fonts of the usual width."""
    return sum(_width(run) * size for run in parts)


def _width(run: Run) -> float:
    scale = SCRIPT_SIZE if run.level else 1.0
    if run.math:
        return scale * sum(0.64 if c.isupper() or c in "⋯−=<≤∨" else 0.5 for c in run.letters)
    return scale * sum(
        0.3 if c in " .,:;()|'ijlt" else 0.7 if c.isupper() or c in "mw" else 0.56 for c in run.letters
    )
