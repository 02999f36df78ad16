"""Names of root systems and of Coxeter triangulations, and the dimensions in which each exists."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass

from .errors import InvalidType

MINIMAL_RANK = {"A": 1, "B": 2, "C": 2, "D": 4}
MINIMAL_DIMENSION = {"A": 2, "B": 3, "C": 2, "D": 4}
LARGEST_RANK = 100_000
EXCEPTIONAL = {"E": (6, 7, 8), "F": (4,), "G": (2,)}
FAMILIES = ("A", "B", "C", "D", "E6", "E7", "E8", "F4", "G2")
"""The nine families of the paper: four infinite ones and five single triangulations."""


@dataclass(frozen=True, order=True)
class Type:
    """A letter and a rank, such as B and 5.

    >>> Type("B", 5).finite, Type("B", 5).affine, Type("B", 5).unicode
    ('B5', 'B~5', 'B̃5')
    """

    letter: str
    rank: int

    @property
    def finite(self) -> str:
        """The name of the root system, as ``B5``."""
        return f"{self.letter}{self.rank}"

    @property
    def affine(self) -> str:
        """The ASCII name of the triangulation, as ``B~5``."""
        return f"{self.letter}~{self.rank}"

    @property
    def unicode(self) -> str:
        """The name of the triangulation with a combining tilde."""
        return f"{self.letter}\N{COMBINING TILDE}{self.rank}"

    @property
    def latex(self) -> str:
        r"""The name of the triangulation in LaTeX, as ``\tilde{B}_{5}``."""
        return rf"\tilde{{{self.letter}}}_{{{self.rank}}}"

    @property
    def family(self) -> str:
        """The family among the paper's nine, ``B``, or ``E6`` for a single triangulation."""
        return self.letter if self.letter in MINIMAL_RANK else self.finite


def parse_root_system(name: object) -> Type:
    """Read the name of a finite root system: ``"B5"``, ``"E6"`` or ``("B", 5)``.

    >>> parse_root_system("E6")
    Type(letter='E', rank=6)
    """
    return _parse(name, MINIMAL_RANK, "root system", "")


def parse_triangulation(name: object) -> Type:
    """Read the name of a Coxeter triangulation: ``"B~5"``, ``"B̃5"``, ``"B̃_5"`` or ``("B", 5)``.

    >>> parse_triangulation("B~5") == parse_triangulation("B̃_5") == parse_triangulation(("B", 5))
    True
    """
    return _parse(name, MINIMAL_DIMENSION, "Coxeter triangulation", "~")


def _parse(name: object, minimal: dict[str, int], what: str, tilde: str) -> Type:
    if isinstance(name, Type):
        name = (name.letter, name.rank)
    if isinstance(name, (tuple, list)) and len(name) == 2:
        text = f"{name[0]}{name[1]}"
    elif isinstance(name, str):
        text = name
    else:
        raise InvalidType(f"{name!r} does not name a {what}: give text such as 'B{tilde}5'")
    plain = unicodedata.normalize("NFD", text).replace("\N{COMBINING TILDE}", "~").strip()
    allowed = ", ".join(
        [f"{letter}{tilde}d (d >= {low})" for letter, low in minimal.items()]
        + [f"{letter}{tilde}{d}" for letter, ranks in EXCEPTIONAL.items() for d in ranks]
    )
    match = re.fullmatch(r"([A-Z])~?_?(?:([0-9]+)|\{([0-9]+)\})", plain)
    if match is None:
        raise InvalidType(f"{text!r} does not name a {what}; there are {allowed}")
    letter, digits = match[1], match[2] or match[3]
    if len(digits) > len(str(LARGEST_RANK)) or int(digits) > LARGEST_RANK:
        raise InvalidType(
            f"{text!r} is too large to compute with: the dimension may be {LARGEST_RANK} at most"
        )
    rank = int(digits)
    if letter in minimal:
        if rank >= minimal[letter]:
            return Type(letter, rank)
        other = _SAME_IN_SMALL_RANK.get((letter, rank))
        hint = f" (in dimension {rank} take {other}{tilde}{rank})" if other else ""
        raise InvalidType(f"{text!r}: {letter}{tilde}d needs d >= {minimal[letter]}{hint}")
    if rank in EXCEPTIONAL.get(letter, ()):
        return Type(letter, rank)
    raise InvalidType(f"{text!r} does not name a {what}; there are {allowed}")


_SAME_IN_SMALL_RANK = {("B", 2): "C", ("D", 3): "A"}


def triangulations_up_to(dimension: int) -> list[Type]:
    """The types of all Coxeter triangulations of dimension 2 to d, by dimension, then by letter.

    >>> [kind.affine for kind in triangulations_up_to(3)]
    ['A~2', 'C~2', 'G~2', 'A~3', 'B~3', 'C~3']
    """
    return [
        Type(letter, d)
        for d in range(2, dimension + 1)
        for letter in "ABCDEFG"
        if d in EXCEPTIONAL.get(letter, ()) or d >= MINIMAL_DIMENSION.get(letter, d + 1)
    ]
