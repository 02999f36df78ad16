"""What the claims of Appendix A share: the regular simplex, and how its bounds and identities are judged."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

from ..exact import Surd
from ..families import evaluate
from .appendix_a_samples import REACH, Setting, settings
from .claim import Constants, Finding, corrected, decide, holds
from .instances import is_regular, regular_value
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


def is_regular_value(text: str, measure: str) -> bool:
    """Whether a formula gives a measure of the regular simplex for every d that is tried."""
    return all(evaluate(text, d=d) == regular_value(measure, d) for d in range(1, REACH + 1))


def value_of_regular(
    printed: Constants, measure: str, true: str, *derivation: str, greatest: bool = True
) -> Finding:
    """Whether the printed formula is the measure of the regular simplex, and no sample exceeds it."""
    good = greatest and is_regular_value(printed["value"], measure)
    constants = {**printed, "value": true}
    return decide(good, EVERY_D, _in_words(true), REGULAR, *derivation, constants=constants)


@lru_cache(maxsize=16)
def _in_words(value: str) -> str:
    from ..proofs.proof import latex

    return f"the value is ${latex(value)}$"


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
    """Whether the simplex is regular and the point its centre."""
    return s.at_circumcentre and is_regular(s.simplex)
