"""Claims: a statement of the paper in our own words, its printed constants, and a check that judges it."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

from ..errors import CoxeterError, InvalidInput
from ..exact import surd
from ..families import evaluate
from ..paper import prose
from .phrases import fill
from .vocabulary import LITERATURE, Strength, Verdict, Weight

Constants = Mapping[str, Any]
"""The constants of a statement by name: integers, formulas, decimals, words, and tuples of these."""


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What a check found.

    Attributes
    ----------
    verdict, strength
        The verdict, and how strongly it is known; neither is ever given alone.
    correction
        What to use instead; for a repaired proof, how ours goes.
    witness
        The smallest exact configuration that breaks the statement, or the step of its proof.
    evidence
        Why the fault is the paper's, or our copy's.
    constants
        The constants with which the statement holds, if they are not the printed ones.
    tested
        For what is cited or open: the instances that were tested.
    derivation
        How the verdict was reached, a line a step; LaTeX between dollar signs.
    proof
        The proof for every d that stands behind it, as the arguments of `coxeter.proofs.prove`.
    """

    verdict: Verdict
    strength: Strength
    correction: str = ""
    witness: str = ""
    evidence: str = ""
    tested: str = ""
    derivation: tuple[str, ...] = ()
    constants: Constants | None = None
    proof: tuple[str, ...] = ()


Check = Callable[[Constants], Finding]


@dataclass(frozen=True)
class Claim:
    """An atomic statement of the paper.

    Attributes
    ----------
    id
        Permanent, as ``thm-8.delaunay``, ``prop-12``, ``tab-6.B.3`` or ``sec6.E8.item-8.sign``.
    place
        Where it stands in the paper.
    words
        The statement in our own words; the printed constants stand in it as ``{name}``, or as `phrases` says.
    weight
        What it is to a reader: a result, (a step of) a proof, or wording.
    check
        Judges the statement with any constants put in the place of the printed ones.
    printed
        The constants that are printed.
    to_state, to_prove
        The claims that it needs to be said, and those that the paper's argument for it uses.
    code
        The name of the check, as ``coxeter.ledger.section_1_space.bcc_samples``.
    """

    id: str
    place: str
    words: str
    weight: Weight
    check: Check
    printed: Constants = field(default_factory=dict)
    to_state: tuple[str, ...] = ()
    to_prove: tuple[str, ...] = ()
    code: str = ""

    @property
    def statement(self) -> str:
        """The statement with its printed constants."""
        return self.state(self.printed)

    def state(self, constants: Constants) -> str:
        """The statement with other constants."""
        lost = dict.fromkeys(("formula", "decimal", "text"), "(lost in our copy)")
        known = {**lost, **constants}
        return fill(self.words, known, lambda m: spell(known.get(m[1], m[0])))

    def judge(self, constants: Constants | None = None) -> Finding:
        """The verdict on the statement, as printed or with other constants.

        Raises
        ------
        BrokenTool
            If what the check computes with does not work; the message names the claim.
        """
        try:
            return self.check(self.printed if constants is None else constants)
        except BrokenTool as error:
            raise BrokenTool(f"{self.id}: no verdict, for {error}") from error


CLAIMS: dict[str, Claim] = {}
"""All claims that have been loaded, by id; `coxeter.ledger.all_claims` loads every one."""


def claim(
    id: str,
    place: str,
    weight: Weight,
    *,
    words: str = "",
    printed: Constants | None = None,
    to_state: Iterable[str] = (),
    to_prove: Iterable[str] = (),
    proof: tuple[str, ...] = (),
) -> Callable[[Check], Check]:
    """Make a check a claim. The printed constants are those that `paper/prose` has for its id.

    Parameters
    ----------
    words
        The statement, if it is not the docstring of the check.
    printed
        Further constants, which are recorded elsewhere.
    proof
        The proof that stands behind the finding whenever the check accepts the statement.
    """

    def decorate(check: Check) -> Check:
        text = " ".join((words or inspect.getdoc(check) or "").split())
        constants = {**prose().get(id, {}), **(printed or {})}
        judge = _with_proof(check, proof) if proof else check
        needs = tuple(to_state), tuple(to_prove)
        register(Claim(id, place, text, weight, judge, constants, *needs, _code(check)))
        return check

    return decorate


def _code(check: Check) -> str:
    """Where the check is written down: the function at the top of its module."""
    function = inspect.unwrap(check)
    if isinstance(function, partial):
        function = function.func
    return f"{function.__module__}.{function.__qualname__.partition('.')[0]}"


def _with_proof(check: Check, proof: tuple[str, ...]) -> Check:
    def judge(constants: Constants) -> Finding:
        finding = check(constants)
        return replace(finding, proof=proof) if finding.verdict.accepts else finding

    return judge


def register(new: Claim) -> None:
    """Enter a claim under its id, which must be new."""
    if new.id in CLAIMS:
        raise InvalidInput(f"there are two claims {new.id!r}: give one of them another id")
    CLAIMS[new.id] = new


class BrokenTool(RuntimeError):
    """Raised by a check whose own tools do not work: an error, and no verdict on the paper."""


class Equivalent(CoxeterError):
    """Raised by a check for constants that say the same in other words: such a mutant is none."""


# -- findings ---------------------------------------------------------------------------------------------


def holds(strength: Strength, *derivation: str, proof: tuple[str, ...] = ()) -> Finding:
    """The statement is true as printed."""
    return Finding(verdict=Verdict.HOLDS, strength=strength, derivation=derivation, proof=proof)


def corrected(strength: Strength, correction: str, **more: Any) -> Finding:
    """The statement is true after a correction; `more` are further entries of the finding."""
    return Finding(verdict=Verdict.CORRECTED, strength=strength, correction=correction, **more)


def repaired(strength: Strength, correction: str, witness: str, **more: Any) -> Finding:
    """The statement is true; the printed argument breaks at the witness, ours is in the correction."""
    return Finding(
        verdict=Verdict.REPAIRED, strength=strength, correction=correction, witness=witness, **more
    )


def fails(strength: Strength, witness: str, instead: str, **more: Any) -> Finding:
    """The statement is false; `instead` is the strongest true one that we can prove."""
    return Finding(verdict=Verdict.FAILS, strength=strength, witness=witness, correction=instead, **more)


def damaged(strength: Strength, correction: str, evidence: str, **more: Any) -> Finding:
    """Our copy is damaged here."""
    return Finding(
        verdict=Verdict.TRANSCRIPTION, strength=strength, correction=correction, evidence=evidence, **more
    )


def cited(source: str, tested: str = "", strength: Strength = LITERATURE) -> Finding:
    """The statement is proved in the source; instances were tested."""
    return Finding(verdict=Verdict.CITED, strength=strength, correction=source, tested=tested)


def conjecture(tested: str, strength: Strength) -> Finding:
    """Nobody knows; `tested` says what was tried."""
    return Finding(verdict=Verdict.OPEN, strength=strength, tested=tested)


def agree(printed: Constants, true: Constants, strength: Strength, *derivation: str, **more: Any) -> Finding:
    """The statement is true as printed if its constants are the true ones, else after putting these.

    >>> agree({"angle": 60}, {"angle": 45}, LITERATURE).correction
    'angle: printed 60, true 45'
    """
    wrong = [name for name in true if not same(printed.get(name), true[name])]
    if not wrong:
        return holds(strength, *derivation)
    words = [f"{name.replace('_', ' ')}: printed {spell(printed.get(name))}, true {spell(true[name])}"
             for name in wrong]  # fmt: skip
    constants = {**printed, **true}
    return corrected(strength, "; ".join(words), derivation=derivation, constants=constants, **more)


def decide(holds_true: bool, strength: Strength, correction: str, *derivation: str, **more: Any) -> Finding:
    """The statement is true as printed, or after a correction."""
    if holds_true:
        return holds(strength, *derivation)
    return corrected(strength, correction, derivation=derivation, **more)


def same(a: Any, b: Any) -> bool:
    """Whether two constants mean the same: formulas are compared as numbers.

    >>> same("2/4", "1/2"), same(("1", 2), (1, 2)), same("A~", "B~")
    (True, True, False)
    """
    if a in (None, ()) and b in (None, ()):
        return True
    if isinstance(a, tuple) and isinstance(b, tuple):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, bool) or isinstance(b, bool) or a is None or b is None:
        return a is b
    if str(a) == str(b):
        return True
    try:
        return bool(_number(a) == _number(b))
    except (CoxeterError, ZeroDivisionError):
        return False


def _number(x: Any) -> Any:
    return evaluate(x) if isinstance(x, str) else surd(x)


def spell(x: Any) -> str:
    """A constant as text.

    >>> spell(("1", "sqrt(2)"))
    '1, sqrt(2)'
    """
    if isinstance(x, bool):
        return str(x).lower()
    if isinstance(x, tuple) and x and all(isinstance(y, tuple) and len(y) == 2 for y in x):
        return ", ".join(spell(value) if count == "1" else f"{value}^{{{count}}}" for value, count in x)
    if isinstance(x, tuple):
        return ", ".join(f"({spell(y)})" if isinstance(y, tuple) else spell(y) for y in x)
    return str(x)
