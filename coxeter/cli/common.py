"""What all commands share."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    Commands = argparse._SubParsersAction[Any]


class Answer(NamedTuple):
    """What a command prints, and its exit status."""

    text: str
    status: int = 0


def integer(text: str) -> int:
    """An option that is an integer."""
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is no integer: give one, such as 8") from None


@contextmanager
def progress() -> Iterator[Callable[[float, str], None] | None]:
    """A bar on the standard error, if that is a terminal; it goes when the work is done.

    It is told which share is done, and in words what of what.
    """
    if not sys.stderr.isatty():
        yield None
        return
    started = time.perf_counter()

    def show(share: float, words: str) -> None:
        full = int(30 * share)
        bar = "█" * full + "░" * (30 - full)
        seconds = time.perf_counter() - started
        print(f"\r{bar} {words}, {seconds:.0f} s", end="\x1b[K", file=sys.stderr, flush=True)

    try:
        yield show
    finally:
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)
