"""Exact numbers in labels and in words: ``2√2/3`` in place of ``2*sqrt(2)/3``."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ..exact.surd import Exact

_ROOT = re.compile(r"\*?sqrt\((\d+)\)")


def words(x: Exact) -> str:
    """A number in words, for alternative texts.

    >>> from coxeter import sqrt
    >>> words(2 * sqrt(2) / 3), words(sqrt(13) / 4 - sqrt(5) / 4)
    ('2√2/3', '√13/4 - √5/4')
    """
    text = _ROOT.sub(r"√\1", str(x))
    if text.startswith("-") and " + " in text:  # the positive part first
        first, _, second = text.partition(" + ")
        text = f"{second} - {first[1:]}"
    return text


def formula(x: Exact) -> str:
    r"""A number for a label, to stand between dollar signs.

    >>> from coxeter import sqrt
    >>> print(formula(2 * sqrt(2)))
    2\sqrt{2}
    """
    return re.sub(r"√(\d+)", r"\\sqrt{\1}", words(x)).replace(" ", "")


def point(x: Sequence[Exact]) -> str:
    """A point in words.

    >>> from fractions import Fraction
    >>> point((Fraction(1, 2), Fraction(0)))
    '(1/2, 0)'
    """
    return f"({', '.join(map(words, x))})"
