"""How the measures of A~, B~, C~, D~ and the protection of A~ fall with d: exact orders, and constants."""

from __future__ import annotations

from ..exact import Surd
from ..families import closed_form, evaluate
from ..symbolic.radicals_limits import limit
from .measures import SYMBOLS, quantity
from .proof import Proof, Refuted, ReplayFailed, Step, argument, join


def rate(letter: str, measure: str, claimed: Surd | None = None) -> Proof:
    """The limit of √d times a normalised measure: positive, so the measure is of exact order 1/√d."""
    name = f"normalized_{measure}"
    symbol = rf"\hat{SYMBOLS[measure]}" + ("^{1/d}" if measure == "fatness" else "")
    steps = [
        _limit(rf"\sqrt d\,{symbol}", f"sqrt(d)*({piece.text})", piece.parity or "", claimed)
        for piece in closed_form(letter, name).pieces
        if piece.high is None
    ]
    return join(
        rf"the {measure.replace('_', ' ')} of $\tilde {letter}_d$ is of exact order $1/\sqrt d$",
        quantity(letter, name).steps,
        steps,
        argument(
            "The limit is positive: the measure is bounded by constants over $\\sqrt d$ from both sides"
        ),
    )


def constant(letter: str, measure: str) -> Surd:
    """The limit of √d times a normalised measure.

    >>> constant("A", "thickness"), constant("B", "aspect_ratio")
    (2, sqrt(2))
    """
    return limit(f"sqrt(d)*({closed_form(letter, f'normalized_{measure}').pieces[-1].text})")


def protection_rate(claimed: Surd | None = None) -> Proof:
    """The limit of d² times the relative protection of A~."""
    from .appendix_c import relative_protection

    text = closed_form("A", "relative_protection").pieces[0].text
    return join(
        r"the relative protection of $\tilde A_d$ is of exact order $1/d^2$",
        relative_protection().steps,
        _limit(r"d^2\,\hat\delta", f"d**2*({text})", "", claimed),
    )


def _limit(name: str, text: str, parity: str, claimed: Surd | None) -> Step:
    """The limit of a formula, by its leading terms; the replay sees it come nearer."""
    found = limit(text)
    if claimed is not None and found != claimed:
        raise Refuted(f"the limit of {text} is {found}, not {claimed}")

    def test(_: int) -> int:
        ds = [10**n + (parity == "odd") for n in (1, 2, 3)]
        ratios = [evaluate(text, d=d) / found for d in ds]
        gaps = [max(x, 1 / x) for x in ratios]
        if not gaps[0] > gaps[1] > gaps[2] > 1:
            raise ReplayFailed(f"{text} does not approach {found}")
        return len(ds)

    words = "by the leading terms" + (f", {parity} $d$" if parity else "")
    return Step("formulas", words, rf"{name} \longrightarrow {found.latex()}", r"d \to \infty", "", test)
