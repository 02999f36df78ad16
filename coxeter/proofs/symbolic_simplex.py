"""The fundamental simplex of a family with d left open: what it is asked for is a proved formula in d.

>>> from coxeter.quality import mean_ratio, thickness
>>> thickness.of(symbolic_simplex("C~d"))
sqrt(2*d)/(2*d) (d >= 2)
>>> thickness.normalized(symbolic_simplex("A~d"))
2*sqrt(d)/(d + 1) (d odd); 2*sqrt(d + 2)/(d + 2) (d even)
>>> mean_ratio.normalized(symbolic_simplex("B~d")).at(5).decimal(3)
'0.659'
"""

from __future__ import annotations

import re
from functools import lru_cache

from ..errors import InvalidInput
from ..families import ClosedForm, Piece, closed_form
from ..families.forms import LENGTHS
from ..families.mesh_forms import MESH_FORMS, mesh_form
from ..names import MINIMAL_DIMENSION
from ..symbolic.formulas import Formula, formula
from .classical import FAMILIES
from .edges import mesh_quantity
from .measures import quantity, regular_lengths
from .proof import Proof, argument, formulas, join, latex

QUANTITIES = (*LENGTHS, *MESH_FORMS["A"])
SQUARES = tuple(f"squared_{name}" for name in ("longest_edge", "shortest_edge", "circumradius"))


class NotSymbolic(InvalidInput, AttributeError):
    """What has no formula in d here."""


class SymbolicSimplex:
    """The fundamental simplex of A~, B~, C~ or D~, or the regular simplex; see `symbolic_simplex`.

    Its attributes are those that a measure of a `Simplex` may use: ``dimension``, ``minimal_height``,
    ``longest_edge``, ``shortest_edge``, ``inradius``, ``circumradius``, ``volume``, ``sum_of_squared_edges``,
    ``sum_of_inverse_squared_heights``; the squares ``squared_longest_edge``, ``squared_shortest_edge``,
    ``squared_circumradius``; and, but for the regular simplex, ``minimal_dihedral_angle``,
    ``maximal_dihedral_angle``, ``minimal_solid_angle``. Each is a `Formula`, and is proved before it is
    given; those of angles are taken from the literature, and tested by the core.
    """

    def __init__(self, letter: str) -> None:
        self.letter = letter

    def __repr__(self) -> str:
        return f"symbolic_simplex({self.name!r})"

    @property
    def name(self) -> str:
        """``A~d``, or ``regular``."""
        return self.letter if self.letter == "regular" else f"{self.letter}~d"

    @property
    def dimension(self) -> Formula:
        """The formula d."""
        return Formula(self.letter, "dimension", (Piece("d", MINIMAL_DIMENSION.get(self.letter, 1)),))

    @property
    def regular(self) -> SymbolicSimplex:
        """The regular simplex: what measures are normalised by."""
        return SymbolicSimplex("regular")

    def proof(self, name: str) -> Proof:
        """The proof of the formula of a quantity."""
        if name not in self._known():
            who = "the regular simplex" if self.letter == "regular" else self.name
            raise NotSymbolic(f"{who} has no formula in d for {name!r}; it has {', '.join(self._known())}")
        if self.letter == "regular":
            return _of_regular(name)
        return quantity(self.letter, name) if name in LENGTHS else mesh_quantity(self.letter, name)

    def _known(self) -> tuple[str, ...]:
        return (*LENGTHS, *MESH_FORMS[self.letter])

    def _form(self, name: str) -> ClosedForm:
        return (closed_form if name in LENGTHS else mesh_form)(self.letter, name)

    def __getattr__(self, name: str) -> Formula:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in SQUARES:
            length: Formula = getattr(self, name.removeprefix("squared_"))
            return length**2
        self.proof(name)  # raises if there is none, or if it does not hold
        return formula(self._form(name))


@lru_cache(maxsize=16)
def symbolic_simplex(name: str) -> SymbolicSimplex:
    """The fundamental simplex of an infinite family with the letter d, for measures as formulas in d.

    Parameters
    ----------
    name
        ``"A~d"``, ``"B~d"``, ``"C~d"``, ``"D~d"``, or ``"regular"`` for the regular d-simplex with edges √2.

    Raises
    ------
    InvalidInput
        If there is no such family.

    Examples
    --------
    >>> symbolic_simplex("D~d").shortest_edge
    sqrt(2)/2 (d = 4); 1/2 (d >= 5)
    >>> symbolic_simplex("D~d").incentre
    Traceback (most recent call last):
        ...
    coxeter.proofs.symbolic_simplex.NotSymbolic: D~d has no formula in d for 'incentre'; it has \
minimal_height, longest_edge, inradius, circumradius, volume, shortest_edge, sum_of_squared_edges, \
sum_of_inverse_squared_heights, minimal_dihedral_angle, maximal_dihedral_angle, minimal_solid_angle
    """
    match = re.fullmatch(r"([A-D])(?:~|\N{COMBINING TILDE})_?d", str(name))
    letter = match[1] if match else name
    if letter not in (*FAMILIES, "regular") or (not match and letter != "regular"):
        there = ", ".join(f"{x}~d" for x in FAMILIES)
        raise InvalidInput(f"{name!r} is no family with the letter d; there are {there} and regular")
    return SymbolicSimplex(letter)


@lru_cache(maxsize=16)
def _of_regular(name: str) -> Proof:
    """The regular simplex: its lengths are proved, and all its edges, all its heights are equal."""
    lengths = regular_lengths()
    if name in LENGTHS:
        return lengths
    edge, height = (closed_form("regular", x).pieces[0].text for x in ("longest_edge", "minimal_height"))
    count, each = {
        "shortest_edge": ("1", edge),
        "sum_of_squared_edges": ("d*(d + 1)/2", f"({edge})**2"),
        "sum_of_inverse_squared_heights": ("(d + 1)", f"1/({height})**2"),
    }[name]
    claimed = mesh_form("regular", name).pieces[0].text
    return join(
        f"the {name.replace('_', ' ')} of the regular simplex",
        lengths.steps,
        argument("All its edges are equal, and so are all its heights"),
        formulas("so", latex(claimed), f"{count}*({each})", claimed),
    )
