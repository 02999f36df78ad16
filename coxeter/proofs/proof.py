"""Proofs for every d: steps that were decided by computation, and that can be replayed on numbers.

A step is made by `identity`, `inequality`, `formulas` or `argument`; the first three exist only if they were
decided. `Refuted` and `coxeter.symbolic.Undecided` are different answers.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import lru_cache

from ..errors import CoxeterError, Undecided
from ..exact import Exact, surd
from ..families import evaluate, expression
from ..symbolic.cases import Case, case
from ..symbolic.polynomials import Rational, is_zero, value

Core = Callable[..., Exact]
"""A value of the exact core, for given letters: the second route."""


class Refuted(CoxeterError):
    """It is false; the message names the smallest numbers for which it fails."""


class ReplayFailed(CoxeterError):
    """A step that was decided for every d does not agree with the core on numbers."""


def _asker() -> str:
    """The function outside this module for which a step is made, by its dotted name."""
    frame = sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__name__") == __name__:
        frame = frame.f_back
    function = frame.f_code.co_qualname.partition(".<locals>")[0]
    return f"{frame.f_globals.get('__name__')}.{function}"


@dataclass(frozen=True)
class Step:
    """A step of a proof.

    Attributes
    ----------
    kind
        ``identity``, ``inequality``, ``formulas`` or ``computed``: decided by computation; ``argument``, said
        in words; ``tested``, seen in some dimensions by the core.
    words
        What the step shows.
    formula
        In LaTeX: what was decided.
    range
        In LaTeX: for which letters.
    reduced
        In LaTeX: the form in which the computation saw that it is true.
    code
        The function that has the step decided.
    """

    kind: str
    words: str
    formula: str = ""
    range: str = ""
    reduced: str = ""
    check: Callable[[int], int] | None = field(default=None, compare=False, repr=False)
    code: str = field(default_factory=_asker, compare=False, repr=False)

    def replay(self, largest: int) -> int:
        """Try the step on all numbers up to a dimension; returns how many there were."""
        return self.check(largest) if self.check else 0

    def _repr_markdown_(self) -> str:
        return _markdown(self)


@dataclass(frozen=True)
class Proof:
    """A statement and the steps that prove it for every d.

    >>> proof = Proof("The sum of 1 … d", (identity("Gauss", "s", "d*(d + 1)/2", "d**2/2 + d/2", "1 <= d"),))
    >>> proof.replay(5)
    5
    """

    statement: str
    steps: tuple[Step, ...]

    @property
    def decided(self) -> int:
        """How many steps were decided by computation."""
        return sum(step.kind not in ("argument", "tested") for step in self.steps)

    def replay(self, largest: int = 12) -> int:
        """Try every step on all numbers up to a dimension, against the exact core.

        Returns the number of instances; raises `ReplayFailed` at the first that disagrees.
        """
        return sum(step.replay(largest) for step in self.steps)

    def _repr_markdown_(self) -> str:
        lines = [f"**To show:** {self.statement}", ""]
        lines += [f"{n}. {_markdown(step)}" for n, step in enumerate(self.steps, 1)]
        count = {kind: sum(step.kind == kind for step in self.steps) for kind in ("argument", "tested")}
        also = f", {count['tested']} tested by the core" if count["tested"] else ""
        words = f"{self.decided} steps decided by computation, {count['argument']} argued in words{also}"
        lines += ["", f"*{words}.* ∎"]
        return "\n".join(lines)


def argument(words: str) -> Step:
    """A step in words, from the steps before it."""
    return Step("argument", words)


def identity(
    words: str,
    name: str,
    left: Rational | str,
    right: str,
    where: str | Case,
    core: Core | None = None,
) -> Step:
    """A value is what a formula says, throughout a range.

    Parameters
    ----------
    name
        The value's name in LaTeX.
    left
        The value, in the parameters of the range or, as text, in its letters.
    right
        The formula.
    core
        The value as the exact core computes it: tried when the step is replayed.

    Raises
    ------
    Refuted
        If it is false; the message names numbers.
    """
    range_ = case(where) if isinstance(where, str) else where
    found = range_(left) if isinstance(left, str) else left
    if not is_zero(found - range_(right)):
        raise Refuted(f"{words}: {_counterexample(found, right, range_)}")

    def check(largest: int) -> int:
        return _replay(words, range_, largest, right, core or _numbers_of(left, range_))

    return Step("identity", words, f"{name} = {latex(right)}", range_.latex(), "", check)


def inequality(
    words: str, name: str, expression_: Rational | str, where: str | Case, strict: bool = False,
    core: Core | None = None,
) -> Step:  # fmt: skip
    """An expression is not negative (with `strict`: positive) throughout a range.

    Raises
    ------
    Refuted
        If it is false for some small numbers.
    Undecided
        If neither that nor the signs of coefficients settle it.
    """
    range_ = case(where) if isinstance(where, str) else where
    found = range_(expression_) if isinstance(expression_, str) else expression_
    plain = Case(range_.text, {}, range_.parameters)
    if not (plain.positive(found) if strict else plain.nonnegative(found)):
        for letters, parameters in range_.instances(12):
            number = value(found, **parameters)
            if number < 0 or (strict and number == 0):
                raise Refuted(f"{words}: for {_spell(letters)} it is {number}")
        raise Undecided(f"{words}: the signs of the coefficients do not show it in the range {range_.text}")

    def check(largest: int) -> int:
        count = 0
        for letters, parameters in range_.instances(largest):
            number = core(**letters) if core else value(found, **parameters)
            if number < 0 or (strict and number == 0):
                raise ReplayFailed(f"{words}: for {_spell(letters)} the core has {number}")
            count += 1
        return count

    sign = ">" if strict else r"\geq"
    reduced = rf"{name} = {_latex_of(found)} {sign} 0 \quad\text{{with }} {range_.substitution()}"
    return Step("inequality", words, f"{name} {sign} 0", range_.latex(), reduced, check)


def formulas(
    words: str, name: str, left: str, right: str, low: int = 1, parity: str = "", core: Core | None = None,
    show: str = "",
) -> Step:  # fmt: skip
    """Two formulas in d, with roots and powers, are the same for every d from `low` on.

    `show` is the left formula in LaTeX, if not the formula itself. Raises `Refuted` or `Undecided`.
    """
    from ..symbolic.radicals import equal_for_every_d, first_difference

    if not equal_for_every_d(left, right, low, parity or None):
        d = first_difference(left, right, low, parity or None) or low
        raise Refuted(f"{words}: for d = {d} it is {evaluate(left, d=d)}, not {evaluate(right, d=d)}")

    def check(largest: int) -> int:
        ds = [d for d in range(low, largest + 1) if parity in ("", "odd" if d % 2 else "even")]
        for d in ds:
            found = core(d=d) if core else evaluate(left, d=d)
            if found != evaluate(right, d=d):
                raise ReplayFailed(f"{words}: for d = {d} the core has {found}")
        return len(ds)

    middle = show or latex(left)
    middle = "" if middle in (name, latex(right)) else f"{middle} = "
    words_range = rf"d \geq {low}" + (rf",\ d \text{{ {parity}}}" if parity else "")
    return Step("formulas", words, f"{name} = {middle}{latex(right)}", words_range, "", check)


def in_dimension(words: str, name: str, left: str, right: str, d: int, core: Core, show: str = "") -> Step:
    """Two formulas in d have the same value in one dimension. Raises `Refuted`."""

    def test(_: int) -> int:
        values = {evaluate(left, d=d), evaluate(right, d=d), surd(core(d=d))}
        if len(values) > 1:
            raise ReplayFailed(f"{words}: for d = {d} there are {', '.join(sorted(map(str, values)))}")
        return 1

    if evaluate(left, d=d) != evaluate(right, d=d):
        raise Refuted(f"{words}: for d = {d} it is {evaluate(left, d=d)}, not {evaluate(right, d=d)}")
    value = evaluate(right, d=d).latex()
    formula = f"{name} = {show} = {value}" if show else f"{name} = {value}"
    return Step("formulas", words, formula, f"d = {d}", "", test)


def tested(words: str, formula: str, largest: int, test: Callable[[int], int]) -> Step:
    """What the core finds in dimensions up to one: no part of the proof, but a second route to what it shows.

    Raises `ReplayFailed` if the core finds the opposite.
    """
    test(largest)
    return Step("tested", words, formula, rf"d \leq {largest}", "", lambda up_to: test(min(up_to, largest)))


def computed(words: str, formula: str, cases: str, test: Callable[[], int]) -> Step:
    """Finitely many cases, all computed by the core. Raises `ReplayFailed` if one fails."""
    test()
    return Step("computed", words, formula, cases, "", lambda _: test())


def _replay(words: str, range_: Case, largest: int, right: str, core: Core) -> int:
    count = 0
    for letters in range_.numbers(largest):
        expected, found = evaluate(right, **letters), core(**letters)
        if expected != found:
            raise ReplayFailed(f"{words}: for {_spell(letters)} the core has {found}, the formula {expected}")
        count += 1
    return count


def _numbers_of(left: Rational | str, range_: Case) -> Core:
    if isinstance(left, str):
        return lambda **letters: evaluate(left, **letters)
    by_letters = {_key(letters): parameters for letters, parameters in range_.instances(12)}
    return lambda **letters: value(left, **by_letters[_key(letters)])


def _key(letters: dict[str, int]) -> tuple[tuple[str, int], ...]:
    return tuple(sorted(letters.items()))


def _counterexample(given: Rational, right: str, range_: Case) -> str:
    for letters, parameters in range_.instances(12):
        found, claimed = value(given, **parameters), evaluate(right, **letters)
        if found != claimed:
            return f"for {_spell(letters)} it is {found}, not {claimed}"
    return f"it is not {right} for all of {range_.text}"


def _spell(letters: dict[str, int]) -> str:
    return ", ".join(f"{name} = {n}" for name, n in letters.items())


@lru_cache(maxsize=1024)
def latex(text: str) -> str:
    """A formula in LaTeX."""
    import sympy

    return str(sympy.latex(expression(text)))


def _latex_of(x: Rational) -> str:
    import sympy

    return str(sympy.latex(x.as_expr().subs("w", sympy.sqrt(2))))


def _markdown(step: Step) -> str:
    text = step.words
    if step.formula:
        text += f": ${step.reduced or step.formula}$"
    if step.range:
        text += f" for ${step.range}$"
    return text + "."


def join(statement: str, *parts: Step | Iterable[Step]) -> Proof:
    """A proof from steps and groups of steps."""
    steps: list[Step] = []
    for part in parts:
        steps += [part] if isinstance(part, Step) else list(part)
    return Proof(statement, tuple(steps))
