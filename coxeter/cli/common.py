"""What all commands share."""

from __future__ import annotations

import argparse
import warnings
from typing import TYPE_CHECKING, Any, NamedTuple

from ..errors import InvalidInput

if TYPE_CHECKING:
    Commands = argparse._SubParsersAction[Any]

MOST_DIGITS = 1000
"""More digits than this nobody reads, and many of them take long."""


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


def checked_digits(number: int) -> int:
    """A number of digits that can be shown."""
    if not 0 <= number <= MOST_DIGITS:
        raise InvalidInput(f"{number} digits cannot be shown: give 0 to {MOST_DIGITS}")
    return number


def words(notes: list[warnings.WarningMessage]) -> list[str]:
    """What the library says by warnings, each once."""
    return list(dict.fromkeys(str(note.message) for note in notes if note.category is UserWarning))
