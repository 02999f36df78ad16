"""What a terminal, a pipe or a shell may do to a command: stop it, close it, or not know our letters."""

from __future__ import annotations

import codecs
import os
import shutil
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

PLAIN = {"█": "#", "░": "-", "…": "...", "·": "*", "≤": "<=", "≥": ">=", "–": "-"}
"""What stands for a sign that the output cannot show; for any other it is a question mark."""


def _plain(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    text = error.object[error.start : error.end]
    return "".join(PLAIN.get(sign, "?") for sign in text), error.end


codecs.register_error("coxeter.plain", _plain)


@contextmanager
def stopped_by_signals() -> Iterator[None]:
    """A command that is terminated, or whose terminal is closed, tidies up as an interrupted one does.

    Then the exception's argument is the exit status, 128 and the number of the signal. A signal that is
    ignored, as under `nohup`, stays so.
    """
    names = ("SIGTERM", "SIGHUP")  # the second is unknown on Windows
    signals = [getattr(signal, name) for name in names if hasattr(signal, name)]
    if threading.current_thread() is not threading.main_thread():  # only there may signals be handled
        signals = []
    before = {number: signal.getsignal(number) for number in signals}
    for number in signals:
        if before[number] is not signal.SIG_IGN:
            signal.signal(number, _stop)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _stop(number: int, _: FrameType | None) -> None:
    raise KeyboardInterrupt(128 + number)


def say(text: str) -> None:
    """A line on the standard error, if there is one."""
    if sys.stderr:
        print(text, file=sys.stderr, flush=True)


def readable() -> None:
    """Let signs that the output cannot encode be written plainly."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="coxeter.plain")


def abandon_output() -> None:
    """After an error, write no more to the standard output, also not at the end."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@contextmanager
def progress() -> Iterator[Callable[[float, str], None] | None]:
    """A bar on the standard error, if that is a terminal; it goes when the work is done.

    It is told which share is done, and in words what of what.
    """
    if not sys.stderr or not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        yield None
        return
    started = time.perf_counter()

    def show(share: float, words: str) -> None:
        full = int(30 * share)
        line = f"{'█' * full}{'░' * (30 - full)} {words}, {time.perf_counter() - started:.0f} s"
        columns = shutil.get_terminal_size().columns
        print(f"\r{line[: columns - 1]}", end="\x1b[K", file=sys.stderr, flush=True)

    try:
        yield show
    finally:
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)
