"""What checks have in common: how findings are worded."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import wraps
from typing import Any

from ..errors import CoxeterError
from ..exact import Exact
from ..families import evaluate
from .claim import Check, Constants, Finding, cited, same, spell
from .vocabulary import Verdict


def fits(text: object, true: str, values: Mapping[int, Exact]) -> object:
    """A printed formula in d if it has the computed values, else the true one, which must have them."""
    for formula in (text, true):
        if all(evaluate(str(formula), d=d) == value for d, value in values.items()):
            return formula
    raise CoxeterError(f"{true} does not have the computed values")


def quoted(finding: Finding, source: str, tested: str) -> Finding:
    """A statement that is proved elsewhere: cited, if what was computed agrees with it."""
    if finding.verdict is not Verdict.HOLDS:
        return finding
    return replace(cited(source, tested), derivation=finding.derivation)


def explained(finding: Finding, why: str, **more: Any) -> Finding:
    """The finding, with the reason for its correction."""
    return amend(finding, correction=f"{finding.correction}. {why}", **more)


def amend(finding: Finding, **changes: Any) -> Finding:
    """Other words on a statement that needs a correction."""
    return finding if finding.verdict.accepts else replace(finding, **changes)


def told(check: Check) -> Check:
    """Let each correction end with what is printed and what is true."""

    @wraps(check)
    def judge(printed: Constants) -> Finding:
        return tell(check(printed), printed)

    return judge


def tell(finding: Finding, printed: Constants) -> Finding:
    """A finding whose correction ends with what is printed and what is true."""
    true = finding.constants or {}
    names = dict.fromkeys((*printed, *true)) if true and not finding.verdict.accepts else ()
    words = [
        f"{name.replace('_', ' ')}: printed {_spell(printed.get(name))}, true {_spell(true.get(name))}"
        for name in names
        if not same(printed.get(name), true.get(name))
    ]
    return replace(finding, correction=f"{finding.correction} ({'; '.join(words)})") if words else finding


def _spell(value: Any) -> str:
    return "nothing" if value in (None, (), "") else spell(value)
