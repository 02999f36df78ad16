r"""Formulas in the library's notation, such as ``sqrt(3)/174960``, as LaTeX: as written, not simplified.

>>> latex("2**(1/2 + 1/d)/(sqrt(d)*sqrt(d + 1)**(1/d))")
'\\frac{2^{1/2 + 1/d}}{\\sqrt{d}\\,\\sqrt{d + 1}^{1/d}}'
>>> latex("sparse covering") is None
True
"""

from __future__ import annotations

import ast
import re
from functools import lru_cache

LETTERS = {name: name for name in "dijkmnrthLR"} | {"vol": r"\operatorname{vol}", "e": "e"}
_SUM, _PRODUCT, _POWER, _ATOM = range(1, 5)


@lru_cache(maxsize=4096)
def latex(text: str) -> str | None:
    """A formula as LaTeX; None if the text is none."""
    if number := re.fullmatch(r"(-?\d+\.\d+)e(-?\d+)", text.strip()):
        return rf"{number[1]} \cdot 10^{{{number[2]}}}"
    try:
        tree = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError):
        return None
    try:
        return _write(tree)[0]
    except KeyError:
        return None


def _write(node: ast.expr, small: bool = False) -> tuple[str, int]:
    """A tree as LaTeX, and how tightly its parts hold together; small ones have slanted fractions."""
    match node:
        case ast.Constant(value=n) if type(n) is int or type(n) is float:
            return str(n), _ATOM
        case ast.Name(id=name):
            return LETTERS[name], _ATOM
        case ast.UnaryOp(op=ast.USub(), operand=x):
            return "-" + _within(x, _PRODUCT, small), _SUM
        case ast.BinOp(left=x, op=ast.Add() | ast.Sub() as op, right=y):
            sign = "+" if isinstance(op, ast.Add) else "-"
            return f"{_within(x, _SUM, small)} {sign} {_within(y, _PRODUCT, small)}", _SUM
        case ast.BinOp(left=x, op=ast.Mult(), right=y):
            return _product(_within(x, _PRODUCT, small), _within(y, _PRODUCT, small)), _PRODUCT
        case ast.BinOp(left=x, op=ast.Div(), right=y) if small:
            return f"{_within(x, _PRODUCT, small)}/{_within(y, _POWER, small)}", _PRODUCT
        case ast.BinOp(left=ast.UnaryOp(op=ast.USub(), operand=x), op=ast.Div(), right=y):
            return rf"-\frac{{{_write(x)[0]}}}{{{_write(y)[0]}}}", _SUM
        case ast.BinOp(left=x, op=ast.Div(), right=y):
            return rf"\frac{{{_write(x)[0]}}}{{{_write(y)[0]}}}", _PRODUCT
        case ast.BinOp(left=x, op=ast.Pow(), right=y):
            return f"{_within(x, _ATOM, small)}^{{{_write(y, small=True)[0]}}}", _POWER
        case ast.Call(func=ast.Name(id="sqrt"), args=[x], keywords=[]):
            return rf"\sqrt{{{_write(x)[0]}}}", _ATOM
        case ast.Call(func=ast.Name(id="factorial"), args=[x], keywords=[]):
            return f"{_within(x, _ATOM, small)}!", _POWER
    raise KeyError("this is no formula")


def _within(node: ast.expr, least: int, small: bool) -> str:
    text, tightness = _write(node, small)
    if tightness >= least:
        return text
    return f"({text})" if small or r"\frac" not in text else rf"\left({text}\right)"


def _product(x: str, y: str) -> str:
    if y[:1].isdigit():
        return rf"{x} \cdot {y}"
    return x + (r"\," if y.startswith("\\") or x.endswith("}") else "") + y


def is_telling(text: str) -> bool:
    """Whether a text is a formula that gains from being typeset: more than a word, a letter or a number."""
    if re.fullmatch(r"-?\d+", text):
        return False
    return re.search(r"sqrt|\*|/|\d\s*[+-]|[+-]\s*\d|^-", text) is not None and latex(text) is not None
