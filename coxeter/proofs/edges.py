"""The shortest edge, the sums of squared edges and of inverse squared heights of A~, B~, C~, D~ for every d.

The squared edge between two nodes is a formula in d, j and k for each pair of classes of nodes; summed over
the nodes of the classes it is a finite sum of polynomials. Every step is decided; claims may be given.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache, partial

from ..exact import Exact, Surd
from ..families import Piece
from ..families.mesh_forms import mesh_form
from ..symbolic.cases import case
from ..symbolic.polynomials import Rational, rational_function
from ..symbolic.runs import squared_distance, sum_over
from . import proof
from .classical import FAMILIES, Classical, Pair, vector, vertex
from .proof import Proof, Step, argument, formulas, identity, in_dimension, inequality, join
from .simplices import heights, node, roots_squared, the_simplex

HALVES = (("1/2", "k"), ("0", "d - k"))
SHORTEST = {"A": ("0", "1", 2), "B": ("2", "3", 3), "C": ("0", "1", 2), "D": ("2", "3", 5)}
"""Two nodes that a shortest edge joins, and from which d on."""


def edge(letter: str, j: str, k: str) -> str:
    """The squared edge from u_j to u_k, where j comes before k."""
    ends = ("d - 1", "d") if letter == "D" else ()
    if letter == "A":
        return f"(({k}) - ({j}))*(d + 1 - ({k}) + ({j}))/(d + 1)"
    if letter in "BD" and (j, k) == ("0", "1"):
        return "1"
    if letter in "BD" and j in ("0", "1"):
        return "d/4" if k in ends else f"({k})/4"
    if j in ends:
        return "1"
    return f"(d - ({j}))/4" if k in ends else f"(({k}) - ({j}))/4"


def pairs(family: Classical) -> Iterator[Pair]:
    """The pairs of nodes with j before k, class by class."""
    for pair in family.pairs():
        first, second = family.nodes.index(pair.first), family.nodes.index(pair.second)
        if first < second or (first == second and "j < k" in pair.range.text):
            yield pair


def edges(letter: str) -> Iterator[Step]:
    """The squared edges, class by class."""
    for pair in pairs(FAMILIES[letter]):

        def core(pair: Pair = pair, **letters: int) -> Exact:
            j, k = node(pair.j, **letters), node(pair.k, **letters)
            return the_simplex(letter, letters["d"]).squared_edge_lengths[j, k]

        value = squared_distance(*pair.vertices(), pair.range)
        name = rf"\|u_{{{pair.k}}} - u_{{{pair.j}}}\|^2"
        words = f"the edge from $u_{{{pair.j}}}$ to $u_{{{pair.k}}}$"
        yield identity(words, name, value, edge(letter, pair.j, pair.k), pair.range, core)


def sum_of_squared_edges(letter: str, claimed: str | None = None) -> Proof:
    """The sum of all squared edges.

    >>> sum_of_squared_edges("C", "d*(d + 1)*(d + 2)/23")
    Traceback (most recent call last):
        ...
    coxeter.proofs.proof.Refuted: so the sum of all: for d = 2 it is 1, not 24/23
    """
    family = FAMILIES[letter]
    claimed = claimed or mesh_form(letter, "sum_of_squared_edges").pieces[-1].text
    whole = case(f"{family.first} <= d", family.first)
    total = sum((_class_sum(letter, pair) for pair in pairs(family)), rational_function("0"))
    return join(
        rf"the squared edges of $\tilde{{{letter}}}_d$ add up to this, for every $d \geq {family.first}$",
        edges(letter),
        argument("Each is summed over the nodes of its classes, as a polynomial in j and in k"),
        identity("so the sum of all", r"\sum_{j<k} \|u_k - u_j\|^2", whole(total), claimed, whole,
                 lambda d: the_simplex(letter, d).sum_of_squared_edges),
    )  # fmt: skip


def _class_sum(letter: str, pair: Pair) -> Rational:
    x = rational_function(edge(letter, pair.j, pair.k))
    if pair.first is pair.second:
        x = sum_over(x, "j", pair.first.low, "k - 1")
    elif pair.j == "j":
        x = sum_over(x, "j", pair.first.low, pair.first.high)
    return sum_over(x, "k", pair.second.low, pair.second.high) if pair.k == "k" else x


def sum_of_inverse_squared_heights(letter: str, claimed: str | None = None) -> Proof:
    """The sum of 1/h_k² = m_k²·|s_k|² over all nodes."""
    family = FAMILIES[letter]
    claimed = claimed or mesh_form(letter, "sum_of_inverse_squared_heights").pieces[-1].text
    parts = (f"({n.high} - ({n.low}) + 1)*{n.mark**2 * n.square}" for n in family.nodes)
    whole = case(f"{family.first} <= d", family.first)
    return join(
        rf"the inverse squared heights of $\tilde{{{letter}}}_d$ add up to this, $d \geq {family.first}$",
        roots_squared(letter),
        heights(letter),
        identity("so their sum, class by class", r"\sum_k h_k^{-2}", " + ".join(parts), claimed, whole,
                 lambda d: the_simplex(letter, d).sum_of_inverse_squared_heights),
    )  # fmt: skip


def shortest_edge(letter: str, claimed: tuple[Piece, ...] | None = None) -> Proof:
    """No edge is shorter, and one is as short."""
    family, pieces = FAMILIES[letter], claimed or mesh_form(letter, "shortest_edge").pieces
    general, first = pieces[-1], SHORTEST[letter][2]
    square = "d/(d + 1)" if letter == "A" else "1/4"
    core = partial(_shortest_edge, letter)
    return join(
        rf"the shortest edge of $\tilde{{{letter}}}_d$, for every $d \geq {family.first}$",
        edges(letter),
        (_no_shorter(letter, pair, square) for pair in pairs(family)),
        _attained(letter, square),
        formulas("so the shortest edge", "l", f"sqrt({square})", general.text, first, core=core),
        (in_dimension("the shortest edge, computed", "l", str(core(d)), piece.text, d, core)
         for piece in pieces[:-1] for d in range(piece.low, (piece.high or piece.low) + 1)),
    )  # fmt: skip


def _shortest_edge(letter: str, d: int) -> Surd:
    return the_simplex(letter, d).shortest_edge


def _no_shorter(letter: str, pair: Pair, square: str) -> Step:
    value = f"{edge(letter, pair.j, pair.k)} - {square}"
    words = f"the edge from $u_{{{pair.j}}}$ to $u_{{{pair.k}}}$ is no shorter"
    name = rf"\|u_{{{pair.k}}} - u_{{{pair.j}}}\|^2 - l^2"
    return inequality(words, name, value, pair.range)


def _attained(letter: str, square: str) -> Step:
    j, k, first = SHORTEST[letter]
    family, whole = FAMILIES[letter], case(f"{first} <= d", first)
    if letter in "AC":
        ends = vertex(family.nodes[0]), vector(family.nodes[1].vertex, f"({k})")
    else:
        ends = vector(HALVES, f"({j})"), vector(HALVES, f"({k})")
    words = f"the edge from $u_{j}$ to $u_{k}$ is as short"
    return identity(words, rf"\|u_{k} - u_{j}\|^2", squared_distance(*ends, whole), square, whole,
                    lambda d: the_simplex(letter, d).squared_edge_lengths[int(j), int(k)])  # fmt: skip


# -- angles -------------------------------------------------------------------------------------------------


def angle(letter: str, name: str) -> Proof:
    """An extreme dihedral angle, or the smallest solid angle: from the literature, and tested by the core."""
    form = mesh_form(letter, name)

    def test(largest: int) -> int:
        dimensions = range(FAMILIES[letter].first, largest + 1)
        for d in dimensions:
            if form.at(d) != getattr(the_simplex(letter, d), name).as_fraction():
                raise proof.ReplayFailed(f"the {name} of {letter}~{d} is not {form.at(d)}")
        return len(dimensions)

    words = {
        "minimal_solid_angle": "The smallest solid angle is 1 over the order of the finite Weyl group, "
        "which is the largest stabiliser of a vertex; its order: Humphreys, Section 2.11",
    }.get(name, "The dihedral angles are read off the diagram: Humphreys, Section 2.5")
    return join(f"the {name.replace('_', ' ')}", argument(words),
                proof.tested("the core finds the same", form.latex(), 12, test))  # fmt: skip


@lru_cache(maxsize=64)
def mesh_quantity(letter: str, name: str) -> Proof:
    """The proof of one of the closed forms in `coxeter.families.mesh_forms`.

    >>> mesh_quantity("D", "sum_of_squared_edges").replay(7) > 0
    True
    """
    if name.endswith("angle"):
        return angle(letter, name)
    makers: dict[str, Callable[[str], Proof]] = {
        "shortest_edge": shortest_edge,
        "sum_of_squared_edges": sum_of_squared_edges,
        "sum_of_inverse_squared_heights": sum_of_inverse_squared_heights,
    }
    return makers[name](letter)
