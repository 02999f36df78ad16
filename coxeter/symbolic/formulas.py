"""Formulas in d with cases, to calculate with: what a measure of a symbolic simplex is made of."""

from __future__ import annotations

import numbers
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any, NoReturn

from ..errors import InvalidInput, Undecided
from ..exact import Surd
from ..families import ClosedForm, Piece, evaluate
from .radicals import equal_for_every_d, normal_form


@dataclass(frozen=True, eq=False, repr=False)
class Formula(ClosedForm):
    """A closed form that adds, multiplies, divides and has powers; `at` gives its value, `latex` prints it.

    Where cases meet, the result has as many. Each is brought to normal form, if it has one.

    Raises
    ------
    InvalidInput
        For what is no exact number and no formula of the same family, and for comparisons by size.

    Examples
    --------
    >>> from coxeter.families import closed_form
    >>> h, longest = (formula(closed_form("B", name)) for name in ("minimal_height", "longest_edge"))
    >>> h / longest
    sqrt(2)/4 (d = 3); sqrt(2*d)/(2*d) (d >= 4)
    >>> (h / longest).at(8), h / longest == longest / h
    (1/4, False)
    """

    def __repr__(self) -> str:
        return "; ".join(f"{piece.text} ({_range(piece)})" for piece in self.pieces)

    __str__ = __repr__

    def _repr_latex_(self) -> str:
        one = rf" \quad ({self.pieces[0].condition})" if len(self.pieces) == 1 else ""
        return f"${self.latex()}{one}$"

    def __add__(self, other: object) -> Formula:
        return self._with(other, "({0}) + ({1})")

    def __radd__(self, other: object) -> Formula:
        return self._with(other, "({1}) + ({0})")

    def __sub__(self, other: object) -> Formula:
        return self._with(other, "({0}) - ({1})")

    def __rsub__(self, other: object) -> Formula:
        return self._with(other, "({1}) - ({0})")

    def __mul__(self, other: object) -> Formula:
        return self._with(other, "({0})*({1})")

    __rmul__ = __mul__

    def __truediv__(self, other: object) -> Formula:
        return self._with(other, "({0})/({1})")

    def __rtruediv__(self, other: object) -> Formula:
        return self._with(other, "({1})/({0})")

    def __pow__(self, other: object) -> Formula:
        return self._with(other, "({0})**({1})")

    def __rpow__(self, other: object) -> Formula:
        return self._with(other, "({1})**({0})")

    def __neg__(self) -> Formula:
        return self._with(-1, "({0})*({1})")

    def root(self, index: object) -> Formula:
        """The root of an index, which may be a formula too: ``x.root(d)``."""
        return self._with(index, "({0})**(1/({1}))")

    def factorial(self) -> Formula:
        """The factorial, of d or of d plus an integer."""
        return self._with(0, "factorial({0})")

    def __eq__(self, other: object) -> bool:
        """Whether two formulas have the same value for every d of the family: decided; see `radicals`."""
        parts = [(p, q) for p in self.pieces for q in self._pieces_of(other) if p.meet(q)]
        return all(_equal(p, q) for p, q in parts)

    __hash__ = ClosedForm.__hash__

    def _compare(self, other: object) -> NoReturn:
        raise InvalidInput(
            f"{self} is a formula in d; which of two is larger may depend on d: compare values, as x.at(5)"
        )

    __lt__ = __le__ = __gt__ = __ge__ = _compare

    def _number(self) -> NoReturn:
        raise InvalidInput(
            f"{self} is a formula in d and no number: use + - * / **, coxeter.sqrt and "
            "coxeter.quality.root, or a value, as x.at(5)"
        )

    __float__ = __index__ = _number

    def __bool__(self) -> bool:
        return self != 0

    def _with(self, other: object, template: str) -> Formula:
        pieces = []
        for p in self.pieces:
            for q in self._pieces_of(other):
                if part := p.meet(q):
                    pieces.append(_normal(replace(part, text=template.format(p.text, q.text))))
        return Formula(self.family, "", tuple(pieces))

    def _pieces_of(self, other: object) -> tuple[Piece, ...]:
        if isinstance(other, ClosedForm):
            return other.pieces
        if isinstance(other, (Surd, numbers.Rational)) and not isinstance(other, bool):
            return (Piece(str(other), 1),)
        raise InvalidInput(
            f"{other!r} is neither an exact number nor a formula in d: give an integer, a Fraction or a Surd"
        )


def formula(form: ClosedForm) -> Formula:
    """A closed form, to calculate with."""
    return Formula(form.family, form.quantity, tuple(map(_normal, form.pieces)))


def _normal(piece: Piece) -> Piece:
    """The value, if there is but one dimension; else the normal form, if there is one."""
    if piece.high == piece.low:
        return replace(piece, text=str(evaluate(piece.text, d=piece.low)))
    with suppress(Undecided):
        return replace(piece, text=str(normal_form(piece.text, piece.low)))
    return piece


def _equal(p: Piece, q: Piece) -> bool:
    part: Any = p.meet(q)
    if part.high is None:
        return equal_for_every_d(p.text, q.text, part.low, part.parity)
    dimensions = (d for d in range(part.low, part.high + 1) if part.covers(d))
    return all(evaluate(p.text, d=d) == evaluate(q.text, d=d) for d in dimensions)


def _range(piece: Piece) -> str:
    if piece.high == piece.low:
        return f"d = {piece.low}"
    if piece.parity:
        return f"d {piece.parity}"
    return f"d >= {piece.low}" if piece.high is None else f"{piece.low} <= d <= {piece.high}"
