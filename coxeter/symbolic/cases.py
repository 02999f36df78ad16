"""Ranges of d and of indices, parametrised by non-negative integers.

In the range 2 <= k <= d, say, k = 2 + a and d = k + b for some a, b >= 0. In a, b every question of sign
is settled by a look at the coefficients: where all of a polynomial's are non-negative, so is the polynomial.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from math import prod
from typing import Any

from ..errors import InvalidInput, Undecided
from .polynomials import (
    FIELD,
    LETTERS,
    SYMBOLS,
    Rational,
    coefficients,
    divisors,
    is_zero,
    letters_of,
    rational_function,
    sign_of,
)

PARAMETERS = ("a", "b", "c", "e")


@dataclass(frozen=True)
class Case:
    """A range of letters; make one with `case`.

    Attributes
    ----------
    text
        The chain of inequalities.
    values
        Each letter as a polynomial in the parameters.
    parameters
        The parameters that occur: non-negative integers, otherwise free.
    smallest
        The smallest d for which numbers are tried: what holds may make sense from there on only.
    """

    text: str
    values: Mapping[str, Rational] = field(compare=False)
    parameters: tuple[str, ...] = field(compare=False)
    smallest: int = 0

    def __call__(self, x: Rational | str | int) -> Rational:
        """A rational function in the parameters.

        Raises
        ------
        InvalidInput
            If it has a letter that the range does not bind.
        Undecided
            If a formula divides by something that may vanish in the range.
        """
        if isinstance(x, str):
            for divisor in divisors(x):
                self.sign(divisor, strict=True)
            x = rational_function(x)
        x = FIELD(x)
        bound = {*self.values, *self.parameters, "i"}
        if loose := sorted(letters_of(x) - bound):
            raise InvalidInput(
                f"the range {self.text!r} does not bind {', '.join(loose)}: add it to the chain"
            )
        moves = [(SYMBOLS[letter].numer, value.numer) for letter, value in self.values.items()]
        return FIELD(x.numer.compose(moves)) / FIELD(x.denom.compose(moves))

    def equal(self, x: Rational | str | int, y: Rational | str | int) -> bool:
        """Whether two rational functions are the same throughout the range."""
        return is_zero(self(x) - self(y))

    def equal_value(self, text: str, value: Rational) -> bool:
        """Whether a formula has a value that is given in the parameters."""
        return is_zero(self(text) - value)

    def sign(self, x: Rational | str | int, strict: bool = False) -> int:
        """1, 0 or -1 if x >= 0, x = 0 or x <= 0 throughout the range; with `strict`, > and <.

        Raises
        ------
        Undecided
            If the coefficients do not show it; then it may be true or false.

        Examples
        --------
        >>> case("2 <= k <= d").sign("(d - k + 1)*(k - 1)", strict=True)
        1
        """
        reduced = self(x)
        over = _sign(reduced.denom, True)
        return _sign(reduced.numer, strict) * over

    def nonnegative(self, x: Rational | str | int) -> bool:
        """Whether it is certain that x >= 0 throughout the range."""
        try:
            return self.sign(x) >= 0
        except Undecided:
            return False

    def positive(self, x: Rational | str | int) -> bool:
        """Whether it is certain that x > 0 throughout the range."""
        try:
            return self.sign(x, strict=True) > 0
        except Undecided:
            return False

    def numbers(self, largest: int) -> Iterator[dict[str, int]]:
        """All values of the letters in the range, as far as d goes.

        >>> list(case("2 <= k <= d").numbers(3))
        [{'k': 2, 'd': 2}, {'k': 2, 'd': 3}, {'k': 3, 'd': 3}]
        """
        return (letters for letters, _ in self.instances(largest))

    def instances(self, largest: int) -> Iterator[tuple[dict[str, int], dict[str, int]]]:
        """The same, each with the values of the parameters."""
        plans = {name: _plan(x, self.parameters) for name, x in self.values.items()}
        weights = {exponents: c for c, exponents in plans.get("d", [])}
        units = [tuple(int(i == j) for j in range(len(self.parameters))) for i in range(len(self.parameters))]
        constant = weights.get((0,) * len(self.parameters), 0)
        for numbers in _numbers([weights.get(unit, 0) for unit in units], largest - constant, largest):
            letters = {name: _whole(plan, numbers) for name, plan in plans.items()}
            if letters.get("d", largest) >= self.smallest:
                yield letters, dict(zip(self.parameters, numbers, strict=True))

    def latex(self) -> str:
        r"""The chain in LaTeX: ``2 \leq k < j \leq d``."""
        return re.sub(r"==", "=", self.text.replace("<=", r"\leq"))

    def substitution(self) -> str:
        """The letters by their parameters, in LaTeX."""
        return r",\; ".join(f"{name} = {value.as_expr()}" for name, value in self.values.items())


@lru_cache(maxsize=1024)
def case(text: str, smallest: int = 0, **more: str) -> Case:
    """A range from a chain of inequalities, from a number upwards; each later link brings a new letter.

    Parameters
    ----------
    text
        Such as ``"2 <= j < k <= d - 1"`` or ``"4 <= k == d"``.
    smallest
        The smallest d for which numbers are tried.
    more
        Further letters by the ones in the chain, as ``d="2*m + 1"``, or by the parameters c and e.

    Raises
    ------
    InvalidInput
        If the text is no such chain.
    """
    first, *links = re.split(r"(<=|<|==)", text)
    if not re.fullmatch(r"\s*-?\d+\s*", first):
        raise InvalidInput(f"{first.strip()!r} in {text!r} is no number to begin with: write '2 <= k <= d'")
    reached = rational_function(first)
    values: dict[str, Rational] = {}
    parameters: list[str] = []
    for relation, link in zip(links[::2], links[1::2], strict=True):
        match = re.fullmatch(r"\s*([a-z])\s*(?:([+-])\s*(\d+))?\s*", link)
        if match is None or match[1] in values:
            raise InvalidInput(f"{link.strip()!r} in {text!r} is no new letter with a number: write 'k - 1'")
        if relation != "==":
            parameters.append(PARAMETERS[len(parameters)])
            reached = reached + SYMBOLS[parameters[-1]] + (relation == "<")
        shift = int(match[3] or 0) * (-1 if match[2] == "-" else 1)
        values[match[1]] = reached - shift
    given = Case(text, dict(values), tuple(parameters), smallest)
    for letter, formula in more.items():
        values[letter] = Case(text, given.values, (*parameters, *PARAMETERS))(formula)
        if values[letter].denom != 1 or any(
            p.denominator > 1 for p, _ in coefficients(values[letter].numer).values()
        ):
            raise InvalidInput(
                f"{letter} = {formula} need not be an integer: give the other letters by this one"
            )
        parameters += [name for name in PARAMETERS if name in formula and name not in parameters]
    words = "".join(f", {letter} = {formula}" for letter, formula in more.items())
    return Case(text + words, values, tuple(parameters), smallest)


def _sign(polynomial: Any, strict: bool) -> int:
    """The sign that all coefficients share; `strict` asks for the constant one not to vanish."""
    signs = {monomial: sign_of(p, q) for monomial, (p, q) in coefficients(polynomial).items()}
    found = set(signs.values()) - {0}
    if not found:
        if strict:
            raise Undecided("the expression vanishes, so it is neither positive nor negative")
        return 0
    constant = signs.get((0,) * len(LETTERS), 0)
    if len(found) == 2 or (strict and not constant):
        raise Undecided(f"the coefficients of {polynomial} do not decide its sign: split the range")
    return found.pop()


Plan = list[tuple[int, tuple[int, ...]]]


def _plan(value: Rational, parameters: tuple[str, ...]) -> Plan:
    """An integer polynomial as pairs (coefficient, exponents of the parameters)."""
    where = [LETTERS.index(name) for name in parameters]
    terms = coefficients(value.numer).items()
    return [(int(p), tuple(exponents[i] for i in where)) for exponents, (p, _) in terms]


def _numbers(weights: Sequence[int], budget: int, largest: int) -> Iterator[tuple[int, ...]]:
    """All tuples of numbers >= 0 with a weighted sum within the budget; without weight, up to the largest."""
    if not weights:
        yield ()
        return
    weight = weights[0]
    for n in range((budget // weight if weight else largest) + 1):
        yield from ((n, *rest) for rest in _numbers(weights[1:], budget - n * weight, largest))


def _whole(plan: Plan, numbers: tuple[int, ...]) -> int:
    return sum(c * prod(n**e for n, e in zip(numbers, exponents, strict=True) if e) for c, exponents in plan)
