"""What all commands share."""

from __future__ import annotations

import argparse
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
