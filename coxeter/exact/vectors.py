"""Vectors with exact rational coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from ..errors import InvalidInput
from .rationals import rational


def as_vector(vector: Sequence[object], length: int) -> tuple[Fraction, ...]:
    """Read a vector of exact rationals and check its length."""
    x = tuple(rational(c) for c in vector)
    if len(x) != length:
        raise InvalidInput(f"{show(x)} has {len(x)} coordinates, {length} are needed")
    return x


def show(vector: Sequence[object]) -> str:
    """A vector as text: ``(1/2, 0, 0)``."""
    return "(" + ", ".join(map(str, vector)) + ")"
