"""Running the checks: one after the other, or spread over any `concurrent.futures` executor."""

from __future__ import annotations

import signal
import threading
import time
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future, as_completed
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from ..errors import CoxeterError
from .claim import CLAIMS, Claim, Equivalent, Finding
from .mutants import mutants
from .rooms import all_claims, find_claim

BUDGET = 20.0
"""Seconds of computing that a claim may take, its mutants included; waiting for a busy machine is free."""


@dataclass(frozen=True)
class Result:
    """What came of running a claim.

    Attributes
    ----------
    finding
        None if the check raised an error or ran out of time.
    trouble
        ``"error"`` or ``"timeout"``, and what happened; empty if all went well.
    seconds
        How long was computed; in a thread beside others, by this thread alone.
    tried, survivors
        How many mutants were judged, and those that the check did not reject.
    """

    id: str
    finding: Finding | None
    seconds: float
    trouble: str = ""
    tried: int = 0
    survivors: tuple[str, ...] = ()

    @property
    def rejected(self) -> int:
        """How many mutants were rejected."""
        return self.tried - len(self.survivors)


class _OutOfTime(BaseException):
    """Raised by the alarm; not an Exception, so that no check can swallow it."""


def run_claim(id: str, budget: float | None = None) -> Result:
    """Judge a claim and its mutants; the budget of seconds is `BUDGET`, if none is given.

    >>> run_claim("def-8").trouble
    ''
    """
    return run(find_claim(id), budget)


def run(claim: Claim, budget: float | None = None) -> Result:
    """Judge a claim that is at hand, and its mutants. Whatever the check raises is told, not raised."""
    budget = BUDGET if budget is None else budget
    # Where no alarm can be set, other threads may be at work too: they must not count.
    clock = time.process_time if _can_be_interrupted() else time.thread_time
    started = clock()
    finding, tried, survivors, trouble = None, 0, [], ""
    try:
        with _alarm(budget):
            finding = claim.judge()
            if finding.proof:
                _prove(finding.proof)
            for what, mutant_finding in _judge_mutants(claim, finding):
                tried += 1
                if mutant_finding is not None and mutant_finding.verdict.accepts:
                    survivors.append(what)
    except _OutOfTime:
        finding, trouble = None, f"timeout: not done after {budget:g} s"
    except Exception as error:
        finding, trouble = None, f"error: {_spell(error)}"
    seconds = clock() - started
    if not trouble and seconds > budget:
        finding, trouble = None, f"timeout: done after {seconds:.1f} s, allowed are {budget:g} s"
    return Result(claim.id, finding, seconds, trouble, tried, tuple(survivors))


def _prove(about: tuple[str, ...]) -> None:
    """Decide the steps of a proof; raises `Refuted` if one does not hold."""
    from ..proofs import prove  # it needs SymPy, which takes longer to load than all else here

    prove(*about)


def _spell(error: Exception) -> str:
    """An error in one line: what, by which mutant, and where."""
    where = traceback.extract_tb(error.__traceback__)[-1]
    notes = [*getattr(error, "__notes__", ()), f"{Path(where.filename).name}, line {where.lineno}"]
    return f"{type(error).__name__}: {' '.join(str(error).split())} ({', '.join(notes)})"


def _judge_mutants(claim: Claim, finding: Finding) -> Iterator[tuple[str, Finding | None]]:
    """Mutants of the statement that stands: as printed, or with the constants of the correction."""
    constants = claim.printed if finding.verdict.accepts else finding.constants
    if constants is None:
        return
    if not finding.verdict.accepts and not claim.judge(constants).verdict.accepts:
        raise CoxeterError(f"the correction of {claim.id} is not accepted by its own check")
    for what, moved in mutants(constants):
        try:
            yield what, claim.judge(moved)
        except Equivalent:
            continue
        except (CoxeterError, ZeroDivisionError):
            yield what, None  # the mutant says nothing at all
        except Exception as error:
            error.add_note(f"with the mutant {what}")
            raise


def run_claims(ids: Sequence[str]) -> list[Result]:
    """Judge several claims one after the other: what a worker is given, perhaps on another machine."""
    return [run_claim(id) for id in ids]


def verify(
    ids: Iterable[str] | None = None,
    executor: Executor | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> tuple[Result, ...]:
    """Judge claims and their mutants.

    Parameters
    ----------
    ids
        Which claims; default all.
    executor
        Any `concurrent.futures.Executor`, such as a process pool or that of a Dask client. What it cannot
        do, for want of a worker or otherwise, is an error of the claims concerned.
    progress
        Called with the number of claims that are done, and of all.

    Raises
    ------
    InvalidInput
        If there is no claim with one of the ids.
    """
    asked = all_claims() if ids is None else ids
    claims = {id: CLAIMS[id] if id in CLAIMS else find_claim(id) for id in asked}
    results: dict[str, Result] = {}
    if progress:
        progress(0, len(claims))
    for batch in _serially(claims.values()) if executor is None else _spread(list(claims), executor):
        results.update((result.id, result) for result in batch)
        if progress:
            progress(len(results), len(claims))
    return tuple(results[id] for id in claims)


def _serially(claims: Iterable[Claim]) -> Iterator[list[Result]]:
    return ([run(claim)] for claim in claims)


def _spread(ids: Sequence[str], executor: Executor) -> Iterator[list[Result]]:
    futures: dict[Future[list[Result]], list[str]] = {}
    try:
        for batch in _batches(ids):
            try:
                futures[executor.submit(run_claims, batch)] = batch
            except RuntimeError as error:  # so says an executor that has broken down
                yield _lost(batch, error)
        for future in as_completed(futures):
            try:
                yield future.result()
            except Exception as error:  # a worker that died, or could not be reached
                yield _lost(futures[future], error)
    finally:
        for future in futures:
            future.cancel()


def _lost(ids: Iterable[str], error: Exception) -> list[Result]:
    return [Result(id, None, 0.0, f"error: {_spell(error)}") for id in ids]


def _batches(ids: Sequence[str], size: int = 12) -> list[list[str]]:
    """Claims that share computations stand beside each other: they go to one worker."""
    return [list(ids[i : i + size]) for i in range(0, len(ids), size)]


def _can_be_interrupted() -> bool:
    return threading.current_thread() is threading.main_thread() and hasattr(signal, "setitimer")


@contextmanager
def _alarm(budget: float) -> Iterator[None]:
    """Interrupt what takes longer than the budget; only a main thread can be interrupted."""
    if not _can_be_interrupted():
        yield
        return

    def ring(*_: object) -> None:
        raise _OutOfTime

    before = signal.signal(signal.SIGPROF, ring)
    signal.setitimer(signal.ITIMER_PROF, budget)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
