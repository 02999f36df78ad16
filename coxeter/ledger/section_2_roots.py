"""Section 2.2: reflections and root systems."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from ..affine import affine_reflection
from ..root_sets import is_crystallographic, is_irreducible, is_reduced, is_root_system
from ..roots import RootSystem
from .claim import Constants, Finding, agree, claim
from .instances import systems
from .section_2_groups import is_stable
from .vocabulary import EVERY_D, Weight
from .wording import explained

RESULT, WORDING = Weight.RESULT, Weight.WORDING

CROSS = ((1, 0), (-1, 0), (0, 5), (0, -5))
"""Two orthogonal lines of roots of different length: reducible."""


@claim("sec2.reflection", "Section 2.2", RESULT)
def reflection(printed: Constants) -> Finding:
    """The reflection in the hyperplane orthogonal to r takes from x the vector r, multiplied by {factor} and
    by the product of x and r over that of r with itself."""
    r = (1, 2)
    image = affine_reflection(r, 0, r)
    true = {f for f in range(-4, 5) if tuple((1 - f) * x for x in r) == image}
    return agree(
        printed, {"factor": true.pop()}, EVERY_D,
        "With the factor f the image of r is (1 - f)r, which is to be -r; vectors orthogonal to r stay "
        "where they are.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _ambient() -> tuple[tuple[str, int, int], ...]:
    """Type, rank and number of coordinates, where these differ, for the roots of Theorem 3."""
    return tuple(
        (s.name, s.simple_roots.rank(), s.simple_roots.shape[1])
        for s in systems(8)
        if s.simple_roots.rank() != s.simple_roots.shape[1]
    )


def in_the_span(printed: Constants, name: str, what: str, *derivation: str) -> Finding:
    """A statement that is made of R^d, and true of the span of the roots."""
    witness, rank, space = _ambient()[0]
    finding = agree(printed, {name: "the span of R" if _ambient() else "R^d"}, EVERY_D, *derivation)
    others = ", ".join(f"{n} in dimension {m}" for n, _, m in _ambient() if n in ("A2", "E6", "E7", "G2"))
    why = (
        f"{what} not of the space in which Theorem 3 gives the roots of all $A_d$, of $E_6$, $E_7$ and $G_2$"
    )
    found = f"{witness} = {{±(1, -1)}} has rank {rank} in dimension {space}; likewise {others}."
    return explained(finding, why, witness=found)


@claim("def-4", "Section 2.2, Definition 4", WORDING, to_state=["sec2.reflection"])
def root_systems(printed: Constants) -> Finding:
    """A root system does not contain 0, and contains a basis of {spanned}."""
    return in_the_span(
        printed, "spanned", "It contains a basis of its own span,",
        "Lemma 2, Definitions 9 and 12, Proposition 5 and Corollary 1 are to be read in the same way.",
    )  # fmt: skip


@claim("def-4.closed", "Section 2.2, Definition 4", WORDING, to_state=["sec2.reflection"])
def closed_under_reflections(printed: Constants) -> Finding:
    """The reflection in each root of a root system maps the system to itself."""
    true = all(map(is_stable, systems(8))) and not is_root_system([(1, 0), (0, 1)])
    return agree(
        printed, {"closed": true}, EVERY_D,
        "A definition. It is true of all roots that the simple roots of Theorem 3 generate, up to rank 8, "
        "but not of every set.",
    )  # fmt: skip


@claim("def-4.crystallographic", "Section 2.2, Definition 4", WORDING, to_state=["def-4.closed"])
def crystallographic(printed: Constants) -> Finding:
    """In a crystallographic root system a reflection moves each root by a whole multiple of the root that
    it belongs to."""
    odd = [(3, 0), (-3, 0), (0, 3), (0, -3), (1, 1), (-1, -1), (1, -1), (-1, 1)]
    true = all(is_crystallographic(s.roots) for s in systems(8)) and not is_crystallographic(odd)
    return agree(
        printed, {"whole_multiples": true and is_root_system(odd)}, EVERY_D,
        "A definition. All types of Theorem 3 have the property (computed up to rank 8). Not every root "
        "system has it: the four vectors ±3e_1, ±3e_2 with the four ±e_1±e_2 have not.",
    )  # fmt: skip


def _multiples(system: RootSystem) -> set[int]:
    """The factors between parallel roots."""
    n = system.roots.numerators
    products = n @ n.T
    squares = products.diagonal()
    rows, columns = np.nonzero(products**2 == np.outer(squares, squares))
    return {int(products[i, j] // squares[i]) for i, j in zip(rows, columns, strict=True)}


@claim("def-4.reduced", "Section 2.2, Definition 4", WORDING, to_state=["def-4.closed"])
def reduced(printed: Constants) -> Finding:
    """In a reduced root system the multiples of a root that are roots are those by {multiples}."""
    true = sorted({m for s in systems(6) for m in _multiples(s)})
    doubles = [(1,), (-1,), (2,), (-2,)]
    if not all(is_reduced(s.roots) for s in systems(8)) or is_reduced(doubles):
        true = []
    return agree(
        printed, {"multiples": tuple(true)}, EVERY_D,
        "A definition. All types of Theorem 3 have the property (computed up to rank 8). Not every root "
        "system has it: ±1, ±2 on the line have not.",
    )  # fmt: skip


@claim("def-4.irreducible", "Section 2.2, Definition 4", WORDING, to_state=["def-4.closed"])
def irreducible(printed: Constants) -> Finding:
    """An irreducible root system is no union of two orthogonal parts."""
    true = all(is_irreducible(s.roots) for s in systems(6)) and not is_irreducible(CROSS)
    return agree(
        printed, {"irreducible": true}, EVERY_D,
        "A definition. All types of Theorem 3 have the property, as their diagrams are connected. Two "
        "orthogonal lines of roots have not.",
    )  # fmt: skip
