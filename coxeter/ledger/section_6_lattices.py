"""Section 6, item 9 of each family: whether the vertex set is a lattice. The proofs are in Appendix D."""

from __future__ import annotations

from functools import lru_cache, partial

from ..affine import triangulation
from ..claims.core import affine_name, dimensions
from ..errors import InvalidInput
from ..lattices import NonLatticeWitness, vertex_lattice
from ..names import FAMILIES, MINIMAL_DIMENSION
from .claim import Constants, Finding, agree, claim, repaired
from .records import strength_for
from .vocabulary import FINITE, Weight

PROPOSITIONS = {family: number for number, family in enumerate(FAMILIES[:-1], 7)}
"""Which family's vertex set a proposition is about; none is about G~2."""
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


def judge_family(family: str, printed: Constants) -> Finding:
    """Whether the vertex sets of a family are lattices as printed, from the printed dimension on."""
    low = printed.get("from", 0)
    if low and bool(vertex_lattice(triangulation((family[0], low - 1)))) == is_lattice(family, low):
        raise InvalidInput("it begins in a smaller dimension")
    finding = agree(printed, {"lattice": is_lattice(family, low)}, strength_for(family))
    return _glance(finding) if family == "G2" and finding.verdict.accepts else finding


def _glance(finding: Finding) -> Finding:
    """G~2: a picture is no proof; two vertices whose difference is none are one."""
    witness = vertex_lattice(triangulation("G~2"))
    if not isinstance(witness, NonLatticeWitness):
        raise InvalidInput("the vertex set of G~2 is a lattice")
    return repaired(
        finding.strength,
        "the difference u_2 - u_1 of two vertices is not a vertex: the roots with integer inner product with "
        "it do not span the plane",
        "the text says that a picture shows it",
    )


for _family in FAMILIES:
    claim(
        f"sec6.{_family}.item-9.lattice",
        f"Section 6, {affine_name(_family)}, item 9",
        Weight.RESULT,
        words=f"The vertex set of {affine_name(_family)} is {{lattice?a|not a}} lattice"
        + (" from d = {from} on." if _family == "D" else "."),
        to_prove=(f"prop-{PROPOSITIONS[_family]}",) if _family in PROPOSITIONS else ("fig-1",),
        proof=(f"proposition_{PROPOSITIONS[_family]}",) if _family in MINIMAL_DIMENSION else (),
    )(partial(judge_family, _family))


@claim("sec6.D.item-9.lattice-4", "Section 6, D~, item 9", Weight.RESULT, to_prove=("prop-10",))
def judge_d4(printed: Constants) -> Finding:
    """The vertex set of D~ is {lattice?a|not a} lattice for d = 4."""
    return agree(printed, {"lattice": bool(vertex_lattice(triangulation("D~4")))}, FINITE)
