"""Where the circumcentre lies, for every d: item 8 of A~, B~, C~, D~."""

from __future__ import annotations

from ..exact import Exact
from ..symbolic.cases import case
from ..symbolic.runs import inner, runs
from .classical import FAMILIES, Pairs
from .proof import Proof, Step, argument, identity, join
from .simplices import circumradius, node, the_triangulation

_A, _B, _C, _D = (FAMILIES[letter] for letter in "ABCD")

LEVELS: dict[str, tuple[tuple[str, Pairs, str, str], ...]] = {
    "A": (
        ("0", _A.nodes[0].root, "2 <= d", "1/(d + 1)"),
        ("k", _A.nodes[1].root, "1 <= k <= d", "1/(d + 1)"),
    ),
    "B": (("2", (("0", "1"), ("1", "1"), ("-1", "1"), ("0", "d - 3")), "3 <= d", "-1/4"),),
    "C": (
        ("0", _C.nodes[0].root, "2 <= d", "1/2"),
        ("k", _C.nodes[1].root, "1 <= k <= d - 1", "0"),
        ("d", _C.nodes[2].root, "2 <= d", "1/2"),
    ),
    "D": (
        ("d - 2", (("0", "d - 3"), ("1", "1"), ("-1", "1"), ("0", "1")), "5 <= d", "-1/4"),
        ("2", (("0", "1"), ("1", "1"), ("-1", "1"), ("0", "1")), "4 == d", "-1/2"),
    ),
}
"""For each family the walls that decide: node, its root, range, and the level of the circumcentre."""

CONCLUSIONS = {
    "A": "All levels are positive: the circumcentre lies inside. By Theorem 7 the triangulation is Delaunay, "
    "with non-zero protection",
    "B": "The simplex has non-negative level on this wall, so the wall separates it from the circumcentre. "
    "By Theorem 7 the triangulation is not Delaunay",
    "C": "No level is negative and some vanish: the circumcentre lies on the boundary. By Theorem 7 the "
    "triangulation is Delaunay and not protected",
}
CONCLUSIONS["D"] = CONCLUSIONS["B"]


def position_of_circumcentre(letter: str) -> Proof:
    """Item 8: where the circumcentre lies, and what follows."""
    family = FAMILIES[letter]
    return join(
        rf"whether $\tilde{{{letter}}}_d$ is Delaunay, for every $d \geq {family.first}$",
        circumradius(letter).steps,
        (circumcentre_level(letter, *row) for row in LEVELS[letter]),
        argument(CONCLUSIONS[letter]),
    )


def circumcentre_level(letter: str, index: str, root: Pairs, where: str, expected: str) -> Step:
    """The level of the circumcentre on the wall of a node."""
    family = FAMILIES[letter]
    range_ = case(where, family.first)
    value = inner(family.circumcentre, runs(*root), range_)
    value = 1 - value if index == "0" else value
    name = rf"\langle c, s_{{{index}}}\rangle" if index != "0" else r"1 - \langle c, \tilde s\rangle"

    def core(**letters: int) -> Exact:
        t = the_triangulation(letter, letters["d"])
        facet = t.facets[node(index, **letters)]
        pairs = zip(t.simplex.circumcentre, facet.normal, strict=True)
        return sum(x * y for x, y in pairs) - facet.offset

    return identity(f"the level of $c$ on the wall of node ${index}$", name, value, expected, range_, core)
