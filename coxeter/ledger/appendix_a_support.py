"""What the claims of Appendix A share: the regular simplex, and how its bounds and identities are judged."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache, wraps
from types import MappingProxyType
from typing import Any

from ..exact import Surd
from ..families import evaluate, expression
from ..quality import find_measure
from ..simplex import regular_simplex
from .appendix_a_samples import REACH, Setting, printed_formula, settings
from .claim import CLAIMS, Check, Constants, Finding, corrected, decide, holds, same, spell
from .vocabulary import EVERY_D

LEMMA_9 = "Appendix A, proof of Lemma 9"

REGULAR = (
    "In the regular simplex with edges of length $L$ the barycentre is circumcentre and incentre, and there "
    r"$R^2=\frac{d}{2(d+1)}L^2$, $h^2=\frac{d+1}{2d}L^2$, $r=\frac{h}{d+1}$, "
    r"$V^2=\frac{d+1}{2^d\,d!^2}L^{2d}$."
)
KLAMKIN = (
    r"Let $F_i$ be the volume of the facet opposite to $v_i$, $F=\sum F_i$, $V$ the volume and "
    r"$q=\sum F_iv_i/F$, which is the incentre.",
    "For any point $p$ with distances $s_i$ from the facets, negative beyond a facet, "
    r"$|p-v_i|\ge h_i-s_i$; with $F_ih_i=dV$ and $\sum F_is_i=dV$ this gives "
    r"$\sum F_i|p-v_i|\ge(d+1)dV-dV=d^2V$.",
    r"By Cauchy and Schwarz $(\sum F_i|p-v_i|)^2\le F\sum F_i|p-v_i|^2=F^2(R^2+|p-q|^2-|o-q|^2)$, with $o$ "
    "the circumcentre.",
)


def from_formula(place: str, name: str = "value") -> Callable[[Check], Check]:
    """The claim's constant is recorded with the formulas of the paper, not with its prose."""

    def decorate(check: Check) -> Check:
        code = f"{check.__module__}.{check.__name__}"
        for id, known in CLAIMS.items():
            if known.code == code:
                constants = MappingProxyType({**known.printed, name: printed_formula(place)})
                CLAIMS[id] = replace(known, printed=constants)
        return check

    return decorate


@lru_cache(maxsize=256)
def regular_value(measure: str, d: int) -> Surd:
    """A measure of the regular simplex."""
    return find_measure(measure)(regular_simplex(d))


def is_regular_value(text: str, measure: str) -> bool:
    """Whether a formula gives a measure of the regular simplex for every d that is tried."""
    return all(evaluate(text, d=d) == regular_value(measure, d) for d in range(1, REACH + 1))


def value_of_regular(
    printed: Constants, measure: str, true: str, *derivation: str, greatest: bool = True
) -> Finding:
    """Whether the printed formula is the measure of the regular simplex, and no sample exceeds it."""
    good = greatest and is_regular_value(printed["value"], measure)
    words = f"the value is ${latex(true)}$"
    constants = {**printed, "value": true}
    return decide(good, EVERY_D, words, REGULAR, *derivation, constants=constants)


def latex(formula: str) -> str:
    """A formula as LaTeX."""
    import sympy

    return str(sympy.latex(expression(formula)))


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


def amend(finding: Finding, **changes: Any) -> Finding:
    """More words on a statement that needs a correction."""
    return finding if finding.verdict.accepts else replace(finding, **changes)


Side = Callable[[Setting, Constants], Surd]


def identity(printed: Constants, true: Constants, left: Side, right: Side, derivation: str) -> Finding:
    """Whether two expressions agree at every sample; they do with the true coefficients."""
    if all(left(s, printed) == right(s, printed) for s in settings()):
        return holds(EVERY_D, derivation, f"Tried exactly at {len(settings())} points.")
    words = ", ".join(f"{name} = {value}" for name, value in true.items())
    return corrected(EVERY_D, words, constants={**printed, **true}, derivation=(derivation,))


def sharp_bound(printed: Constants, true: Constants, gap: Callable[[Setting], Surd], why: str) -> Finding:
    """Whether an expression is nowhere negative, and zero at the centres of regular simplices."""
    good = all(gap(s) >= 0 and (gap(s) == 0 or not is_centre_of_regular(s)) for s in settings())
    sharp = r"Equality at the centre of a regular simplex shows that no constant can be improved."
    words = ", ".join(f"{name.replace('_', ' ')}: {value}" for name, value in true.items())
    return decide(good, EVERY_D, words, why, sharp, constants={**printed, **true})


def is_centre_of_regular(s: Setting) -> bool:
    lengths = {x for i, row in enumerate(s.edges) for x in row[:i]}
    return s.at_circumcentre and len(lengths) == 1
