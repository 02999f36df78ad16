"""Closed forms in d for the nine families, apart from the computation that they are checked against.

A form is stored as text, the way it would be written by hand. `evaluate` reads it as an exact number,
`expression` as a SymPy expression; nothing else here loads SymPy.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..errors import InvalidInput
from ..exact import Surd
from ..names import MINIMAL_DIMENSION
from .forms import FORMS, LENGTHS, MEASURES, NORMALIZED
from .reading import evaluate, expression
from .writing import latex

if TYPE_CHECKING:
    import sympy

__all__ = ["QUANTITIES", "ClosedForm", "Piece", "closed_form", "evaluate", "expression", "latex"]

QUANTITIES = (*LENGTHS, "relative_protection", *MEASURES, *NORMALIZED)
"""The names under which `closed_form` knows the quantities of a fundamental simplex."""


@dataclass(frozen=True)
class Piece:
    """A formula and the dimensions for which it holds.

    Attributes
    ----------
    text
        The formula, as SymPy also reads it.
    low, high
        The first dimension and the last, or None if there is no last.
    parity
        ``"odd"``, ``"even"``, or None for both.
    """

    text: str
    low: int
    high: int | None = None
    parity: str | None = None

    def covers(self, d: int) -> bool:
        """Whether the formula holds in dimension d."""
        in_range = self.low <= d and (self.high is None or d <= self.high)
        return in_range and self.parity in (None, "odd" if d % 2 else "even")

    def meet(self, other: Piece) -> Piece | None:
        """The formula where another one is defined as well; None if that is nowhere.

        >>> Piece("d", 3, None, "odd").meet(Piece("1", 2, 5))
        Piece(text='d', low=3, high=5, parity='odd')
        """
        parities = {x.parity for x in (self, other) if x.parity}
        high = min((h for h in (self.high, other.high) if h is not None), default=None)
        low = max(self.low, other.low)
        if len(parities) > 1 or (high is not None and high < low):
            return None
        return Piece(self.text, low, high, parities.pop() if parities else None)

    @property
    def expression(self) -> sympy.Expr:
        """The formula as a SymPy expression in the positive integer d."""
        return expression(self.text)

    @property
    def condition(self) -> str:
        r"""The range in LaTeX, as ``d \geq 4`` or ``d \text{ odd}``."""
        if self.high == self.low:
            return f"d = {self.low}"
        if self.parity:
            return rf"d \text{{ {self.parity}}}"
        return rf"d \geq {self.low}" if self.high is None else rf"{self.low} \leq d \leq {self.high}"


@dataclass(frozen=True)
class ClosedForm:
    """A quantity of a family, for every d of the family; get one with `closed_form`."""

    family: str
    quantity: str
    pieces: tuple[Piece, ...]

    def at(self, d: int) -> Surd:
        """The exact value in dimension d; raises `InvalidInput` if the family has no such member.

        >>> closed_form("B", "longest_edge").at(3), closed_form("B", "longest_edge").at(9)
        (1, 3/2)
        """
        for piece in self.pieces:
            if piece.covers(d):
                return evaluate(piece.text, d=d)
        first, last = min(piece.low for piece in self.pieces), self.pieces[-1].high
        allowed = f"d = {first}" if first == last else f"d >= {first}"
        raise InvalidInput(f"there is no closed form of family {self.family} for d = {d}: give {allowed}")

    def latex(self) -> str:
        r"""The form as LaTeX, with its cases.

        >>> print(closed_form("B", "longest_edge").latex())
        \begin{cases}1 & d = 3 \\ \frac{\sqrt{d}}{2} & d \geq 4\end{cases}
        """
        formulas = [str(latex(piece.text)) for piece in self.pieces]
        if len(formulas) == 1:
            return formulas[0]
        cases = (f"{f} & {p.condition}" for f, p in zip(formulas, self.pieces, strict=True))
        return r"\begin{cases}" + r" \\ ".join(cases) + r"\end{cases}"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"


def closed_form(family: str, quantity: str) -> ClosedForm:
    """The closed form in d of a quantity of a family.

    Parameters
    ----------
    family
        One of A, B, C, D, E6, E7, E8, F4, G2; or ``"regular"``, the regular d-simplex with edges √2,
        which has no protection and whose normalised measures are 1.
    quantity
        One of `QUANTITIES`. Relative protection is 0 where a triangulation is not protected or not
        Delaunay.

    Raises
    ------
    InvalidInput
        If there is no such family or quantity.

    Examples
    --------
    >>> closed_form("A", "relative_protection").pieces
    (Piece(text='sqrt(1 + 24/(d*(d + 2))) - 1', low=2, high=None, parity=None),)
    """
    if family not in FORMS:
        raise InvalidInput(f"{family!r} is no family with closed forms; there are {', '.join(FORMS)}")
    if quantity not in FORMS[family]:
        raise InvalidInput(f"{family} has no closed form {quantity!r}; it has {', '.join(FORMS[family])}")
    text = FORMS[family][quantity]
    if family in MINIMAL_DIMENSION or family == "regular":
        low, high = MINIMAL_DIMENSION.get(family, 1), None
    else:
        low = high = int(family[1:])
    if isinstance(text, str):
        return ClosedForm(family, quantity, (Piece(text, low, high),))
    if family == "A":
        odd, even = text
        return ClosedForm(family, quantity, (Piece(odd, 3, None, "odd"), Piece(even, 2, None, "even")))
    exception, general = text  # in the lowest dimension, and from the next one on
    return ClosedForm(family, quantity, (Piece(exception, low, low), Piece(general, low + 1)))
