"""Mutants: the same statement with one constant moved. A check that accepts one is no check."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import Any

from ..errors import CoxeterError
from ..families import evaluate
from .claim import Constants

SAMPLES = tuple(
    {"d": d, "k": k, "j": j, "i": i} for d, k, j, i in ((5, 2, 1, 3), (8, 3, 2, 4), (11, 5, 3, 7))
)
"""Where two formulas are compared, to tell a mutant from another way to write the same."""


OTHER_WORDS = "something else"
"""What takes the place of words."""


def mutants(constants: Constants) -> Iterator[tuple[str, Constants]]:
    """Each constant moved: integers by one and in sign, formulas in each number and sign, tuples cut.

    A quotient becomes a product, and words give way to others. Yields pairs (what was changed, constants).

    >>> [what for what, _ in mutants({"angle": 60, "side": "sqrt(2)/2"})]
    ['angle: 61', 'angle: 59', 'angle: -60', 'side: sqrt(2) * 2', 'side: sqrt(2) / 3', 'side: sqrt(2) / 1', \
'side: sqrt(3) / 2', 'side: sqrt(1) / 2', 'side: -(sqrt(2)/2)']
    """
    for name, value in constants.items():
        for moved in _move(value):
            yield f"{name}: {moved}", {**constants, name: moved}


def _move(value: Any, nested: bool = False) -> Iterator[Any]:
    if isinstance(value, bool):
        yield not value
    elif isinstance(value, int):
        yield from (value + 1, value - 1, *([-value] if value else []))
    elif isinstance(value, str):
        yield from _move_text(value)
    elif isinstance(value, tuple):
        for i, part in enumerate(value):
            rest = (*value[:i], *value[i + 1 :])
            if rest and not nested:  # a tuple in a tuple is a record, and keeps its length
                yield rest
            yield from ((*value[:i], moved, *value[i + 1 :]) for moved in _move(part, nested=True))


def _move_text(text: str) -> Iterator[str]:
    if re.fullmatch(r"-?\d+\.\d+(e-?\d+)?", text):
        mantissa, e, exponent = text.partition("e")
        last = int(mantissa[-1])
        for digit in {last + 1, last - 1} & set(range(10)):
            yield mantissa[:-1] + str(digit) + e + exponent
        return
    if not re.search(r"\d|\bd\b|\bk\b|/", text):
        yield OTHER_WORDS
        return
    try:
        tree = ast.parse(text, mode="eval")
    except SyntaxError:
        yield OTHER_WORDS
        return
    yield from (moved for moved in (*_move_tree(tree), f"-({text})") if not _equal(moved, text))


def _move_tree(tree: ast.Expression) -> Iterator[str]:
    """Every number of a formula one up and one down, every plus a minus and the other way round, every
    quotient a product."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and type(node.value) is int:
            value = node.value
            for other in (value + 1, value - 1):
                node.value = other
                yield ast.unparse(tree)
            node.value = value
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
            op = node.op
            node.op = ast.Sub() if isinstance(op, ast.Add) else ast.Add()
            yield ast.unparse(tree)
            node.op = op
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
            node.op = ast.Mult()
            yield ast.unparse(tree)
            node.op = ast.Div()


def _equal(a: str, b: str) -> bool:
    """Whether two formulas have the same values wherever both have one."""
    for letters in SAMPLES:
        try:
            if evaluate(a, **letters) != evaluate(b, **letters):
                return False
        except (CoxeterError, ZeroDivisionError):
            return False
    return True
