"""Section 6, item 9 of each family: whether the vertex set is a lattice. The proofs are those of Appendix D."""

from __future__ import annotations

from functools import lru_cache

from ..affine import triangulation
from ..claims.core import dimensions
from ..errors import InvalidInput
from ..lattices import NonLatticeWitness, vertex_lattice
from ..names import FAMILIES, MINIMAL_DIMENSION
from ..paper import prose
from .claim import Claim, Constants, Finding, agree, holds, register, repaired
from .section_6_delaunay import name, strength
from .vocabulary import FINITE, Weight

PROPOSITIONS = {"A": 7, "B": 8, "C": 9, "D": 10, "E6": 11, "E7": 12, "E8": 13, "F4": 14}
LARGEST = 8


@lru_cache(maxsize=16)
def is_lattice(family: str, low: int = 0) -> bool:
    """Whether the vertex sets of a family are lattices: all, or none, from a dimension on."""
    found = {
        bool(vertex_lattice(triangulation((family[0], d)))) for d in dimensions(family) if low <= d <= LARGEST
    }
    if len(found) != 1:
        raise InvalidInput(f"the members of {family} differ from d = {low} on")
    return found.pop()


def _lattice(family: str, ending: str = "lattice") -> None:
    id = f"sec6.{family}.item-9.{ending}"

    def check(printed: Constants) -> Finding:
        if ending == "lattice-4":
            return agree(printed, {"lattice": bool(vertex_lattice(triangulation("D~4")))}, FINITE)
        low = printed.get("from", 0)
        if low and bool(vertex_lattice(triangulation((family[0], low - 1)))) == is_lattice(family, low):
            raise InvalidInput("it begins in a smaller dimension")
        finding = agree(printed, {"lattice": is_lattice(family, low)}, strength(family))
        if not finding.verdict.accepts:
            return finding
        if family == "G2":
            return _glance(finding)
        proof = (f"proposition_{PROPOSITIONS[family]}",) if family in MINIMAL_DIMENSION else ()
        return holds(strength(family), proof=proof)

    words = f"The vertex set of {name(family)} is a lattice: {{lattice}}" + (
        ", from d = {from} on."
        if family == "D" and ending == "lattice"
        else "."
        if family != "D"
        else ", for d = 4."
    )
    proved = (f"prop-{PROPOSITIONS[family]}",) if family in PROPOSITIONS else ("fig-1",)
    register(Claim(id, f"Section 6, {name(family)}, item 9", words, Weight.RESULT, check, prose()[id], (), proved,
                   f"{__name__}._lattice"))  # fmt: skip


def _glance(finding: Finding) -> Finding:
    """G~2: a picture is no proof; two vertices whose difference is none are one."""
    witness = vertex_lattice(triangulation("G~2"))
    if not isinstance(witness, NonLatticeWitness):
        raise InvalidInput("the vertex set of G~2 is a lattice")
    return repaired(
        finding.strength, "the difference u_2 - u_1 of two vertices is not a vertex: the roots with integer inner product "
        "with it do not span the plane", "the text says that a picture shows it",
    )  # fmt: skip


for _family in FAMILIES:
    _lattice(_family)
_lattice("D", "lattice-4")
