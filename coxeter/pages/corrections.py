"""What is printed, and what is true instead, side by side."""

from __future__ import annotations

import re

from ..ledger.claim import spell
from .judged import Judged
from .wording import shown, statement


def printed(x: Judged) -> str:
    """What is printed, in our words."""
    return statement(x.claim)


def truth(x: Judged) -> str:
    """What is true instead, without repeating what is printed."""
    text = in_words(x.finding.correction)
    if match := re.match(r"printed .*?( in the column of d = \d)?; (?:true: )?(.*)", text, re.DOTALL):
        return match[2] + (f", printed{match[1]}" if match[1] else "")
    for name, value in (x.finding.constants or {}).items():
        words = _words(x, name)
        if isinstance(value, bool):  # the sentence after it says more
            text = re.sub(rf"{re.escape(words)}(?:[.;] |$)", "", text) or text
        told = (
            shown(value) if text.startswith(words) and text.count(": printed ") == 1 else _named(name, value)
        )
        text = text.replace(words, told)
    return re.sub(r"^first: ([^;]*); last: ([^;]*)$", r"from \1 to \2", text)


def stopped(text: str) -> str:
    """A correction with a full stop, if there are words in it.

    >>> stopped("the edges of $L$ are meant"), stopped("1 for d = 3"), stopped("$\\\\sqrt{2}$")
    ('the edges of $L$ are meant.', '1 for d = 3.', '$\\\\sqrt{2}$')
    """
    spoken = re.search(r"[a-z]{2,}", re.sub(r"\$[^$]*\$|\w*\(", "", text))
    return f"{text}." if spoken and text[-1] not in ".!?" else text


def in_words(correction: str) -> str:
    """A correction without the constants that it ends with, for the record, where words say the same.

    >>> in_words("The square is missing. (power: printed 1, true 2)")
    'The square is missing.'
    """
    return re.sub(r"(?<=\S) \(\w[\w ]*: printed .*\)$", "", correction, flags=re.DOTALL)


def _named(name: str, value: object) -> str:
    return f"{name.replace('_', ' ')}: {shown(value)}"


def _words(x: Judged, name: str) -> str:
    """The words of `coxeter.ledger.claim.agree` for a constant that is printed wrong."""
    constants = x.finding.constants or {}
    return (
        f"{name.replace('_', ' ')}: printed {spell(x.claim.printed.get(name))}, true {spell(constants[name])}"
    )
