"""The fundamental simplices of A~, B~, C~, D~ for every d: vertices, heights, centres.

Every function takes the formula that is claimed, so a wrong one is refuted; the formulas of
`coxeter.families` are the defaults. Paper: Section 6, items 1 to 4.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

import sympy

from ..affine import CoxeterTriangulation, triangulation
from ..exact import Exact, Surd
from ..families import closed_form, evaluate
from ..simplex import Simplex
from ..symbolic.cases import case
from ..symbolic.polynomials import Rational
from ..symbolic.runs import RunVector, inner, squared_distance, total
from .classical import FAMILIES, Classical, Nodes, Pair, root, vector, vertex
from .proof import Proof, Step, argument, formulas, identity, inequality, join, latex


def the_simplex(letter: str, d: int) -> Simplex:
    """The fundamental simplex, from the exact core."""
    return the_triangulation(letter, d).simplex


@lru_cache(maxsize=128)
def the_triangulation(letter: str, d: int) -> CoxeterTriangulation:
    """A member of a family, from the exact core."""
    return triangulation((letter, d))


def node(name: str, **letters: int) -> int:
    """The number of a node that is called ``0``, ``k``, ``d - 1`` or the like."""
    return int(evaluate(name, **letters).as_fraction())


# -- vertices and facets (items 1 and 2, Table 1) -----------------------------------------------------


@lru_cache(maxsize=8)
def vertices(letter: str) -> Proof:
    """The points u_0 … u_d are the vertices: each lies on all walls but one."""
    family = FAMILIES[letter]
    return join(
        rf"for every $d \geq {family.first}$ the walls $\langle x, s_j\rangle = 0$ and "
        rf"$\langle x, \tilde s\rangle = 1$ of $\tilde{{{letter}}}_d$ meet in $u_0, \dots, u_d$",
        _dominant(family),
        roots_squared(letter),
        argument(
            r"The root $\tilde s$ has a non-negative product with each simple root, and no simple root is "
            "longer. Each root is the image of a simple one under the Weyl group, so none is longer: a "
            "dominant long root is the highest root"
        ),
        (level(family, pair) for pair in family.pairs()),
        argument(
            r"So $\langle u_k, \tilde s\rangle = 1$: with $u_k$ dual to $m_k s_k$ the coefficients of "
            r"$\tilde s$ are the marks $m_k$"
        ),
        argument("And u_k lies on all walls but the one of node k, and on the inner side of that one"),
    )


def _dominant(family: Classical) -> Iterator[Step]:
    """The products of the highest root with the simple roots: none is negative."""
    for nodes in family.nodes[1:]:
        for where in _CUTS[family.letter] if nodes.index == "k" else (nodes.index,):
            index = "k" if "<=" in where else where
            range_ = case(where if "<=" in where else f"{family.first} <= d", family.first)

            def core(index: str = index, **letters: int) -> Exact:
                t = the_triangulation(family.letter, letters["d"])
                pairs = zip(t.roots.highest_root, t.facets[node(index, **letters)].normal, strict=True)
                return sum(x * y for x, y in pairs)

            product = inner(root(family.nodes[0]), vector(nodes.root, f"({index})"), range_)
            words = f"the highest root and the simple root of node ${index}$"
            yield inequality(words, rf"\langle\tilde s, s_{{{index}}}\rangle", product, range_, core=core)


_CUTS = {
    "A": ("1", "2 <= k <= d - 1", "d"),
    "B": ("2", "3 <= k <= d - 1"),
    "C": ("1", "2 <= k <= d - 1"),
    "D": ("2", "3 <= k <= d - 2"),
}
"""Where the coordinates of a simple root pass those at which the highest root changes."""


def level(family: Classical, pair: Pair, point: RunVector | None = None) -> Step:
    """The level of u_k on wall j: 1/m_k if j = k, else 0. Another point may be put in place of u_k."""
    j, k = pair.j, pair.k
    value = inner(point or pair.vertices()[1], pair.root(), pair.range)
    if j == "0":
        value = 1 - value
    expected = f"1/{pair.first.mark}" if pair.same else "0"
    name = rf"\langle u_{{{k}}}, s_{{{j}}}\rangle" if j != "0" else rf"1 - \langle u_{{{k}}}, \tilde s\rangle"

    def core(**letters: int) -> Exact:
        t = the_triangulation(family.letter, letters["d"])
        return t.facets[node(j, **letters)].level(t.simplex.vertex_matrix.row(node(k, **letters)))

    return identity(
        f"the vertex $u_{{{k}}}$ and the wall of node ${j}$", name, value, expected, pair.range, core
    )


# -- heights, inradius (items 3 and 4) ----------------------------------------------------------------


def roots_squared(letter: str) -> Iterator[Step]:
    """The squared lengths of the roots."""
    family = FAMILIES[letter]
    for nodes in family.nodes:
        range_ = family.range(nodes)
        name = r"\langle\tilde s, \tilde s\rangle" if nodes.index == "0" else rf"\|s_{{{nodes.index}}}\|^2"

        def core(nodes: Nodes = nodes, **letters: int) -> Exact:
            normal = the_triangulation(letter, letters["d"]).facets[node(nodes.index, **letters)].normal
            return sum(x * x for x in normal)

        square = inner(root(nodes), root(nodes), range_)
        yield identity(f"the root of node ${nodes.index}$", name, square, str(nodes.square), range_, core)


def heights(letter: str) -> Iterator[Step]:
    """The squared heights: the level of a vertex on the wall opposite to it, over the length of the root."""
    family = FAMILIES[letter]
    for nodes in family.nodes:
        range_, index = family.range(nodes), nodes.index

        def core(index: str = index, **letters: int) -> Exact:
            return the_simplex(letter, letters["d"]).squared_heights[node(index, **letters)]

        product = inner(vertex(nodes), root(nodes), range_)
        above = 1 - product if index == "0" else product
        value = above**2 / inner(root(nodes), root(nodes), range_)
        height = f"1/({nodes.mark}**2*{nodes.square})"
        u, s = f"u_{{{index}}}", f"s_{{{index}}}"
        name = rf"h_{{{index}}}^2 = \frac{{\langle {u}, {s}\rangle^2}}{{\|{s}\|^2}}"
        name = r"h_0^2 = \frac{1}{\|\tilde s\|^2}" if index == "0" else name
        yield identity(f"the height from $u_{{{index}}}$", name, value, height, range_, core)


def minimal_height(letter: str, claimed: str | None = None) -> Proof:
    """The least height, and the nodes at which it is attained."""
    family = FAMILIES[letter]
    claimed = claimed or form(letter, "minimal_height")
    least = max(nodes.mark**2 * nodes.square for nodes in family.nodes)
    at = [_span(nodes) for nodes in family.nodes if nodes.mark**2 * nodes.square == least]
    return join(
        rf"the least height of $\tilde{{{letter}}}_d$ is $h$, for every $d \geq {family.first}$",
        roots_squared(letter),
        heights(letter),
        argument(f"The largest product $m_k\\|s_k\\|$ is $\\sqrt{{{least}}}$, at the nodes {', '.join(at)}"),
        formulas("the least height", "h", f"1/sqrt({least})", claimed, family.first,
                 core=lambda d: the_simplex(letter, d).minimal_height),
    )  # fmt: skip


def minimal_nodes(letter: str, d: int) -> list[int]:
    """The nodes with the least height, by the marks and lengths of the family."""
    family = FAMILIES[letter]
    least = max(nodes.mark**2 * nodes.square for nodes in family.nodes)
    spans = [(node(n.low, d=d), node(n.high, d=d)) for n in family.nodes if n.mark**2 * n.square == least]
    return [k for low, high in spans for k in range(low, high + 1)]


def _span(nodes: Nodes) -> str:
    return f"${nodes.low}$" if nodes.low == nodes.high else f"${nodes.low}, \\dots, {nodes.high}$"


def inradius(letter: str, claimed: str | None = None, centre: RunVector | None = None) -> Proof:
    """The incentre has the same distance r from all walls."""
    family = FAMILIES[letter]
    claimed = claimed or form(letter, "inradius")
    point = centre or family.incentre
    return join(
        rf"$r = {latex(claimed)}$ is the inradius of $\tilde{{{letter}}}_d$, $d \geq {family.first}$",
        _in_the_hyperplane(family, point),
        (_incentre_level(family, nodes, claimed, point) for nodes in family.nodes),
        argument("So the point lies inside, at the distance $r$ from every wall: it is the incentre"),
    )


def _in_the_hyperplane(family: Classical, point: RunVector) -> Iterator[Step]:
    """A~ lies in the hyperplane in which the coordinates add up to 0: so must its centres."""
    if family.letter == "A":
        range_ = family.range(family.nodes[0])
        yield identity(
            "the coordinates of the centre add up to 0", r"\sum c_i", total(point, range_), "0", range_
        )


_LENGTH = {1: "1", 2: "sqrt(2)", 4: "2"}


def _incentre_level(family: Classical, nodes: Nodes, r: str, centre: RunVector) -> Step:
    range_ = family.range(nodes)
    value = inner(centre, root(nodes), range_)
    value = 1 - value if nodes.index == "0" else value

    def core(**letters: int) -> Exact:
        simplex = the_simplex(family.letter, letters["d"])
        t = the_triangulation(family.letter, letters["d"])
        facet = t.facets[node(nodes.index, **letters)]
        pairs = zip(simplex.incentre, facet.normal, strict=True)
        return sum((n * x for x, n in pairs), Surd(0)) - facet.offset

    name = rf"\langle c_\mathrm{{in}}, s_{{{nodes.index}}}\rangle"
    name = name if nodes.index != "0" else r"1 - \langle c_\mathrm{in}, \tilde s\rangle"
    return identity(
        f"the level of the incentre on the wall of node ${nodes.index}$ is $r$ times the length of the root",
        name, value, f"{_LENGTH[nodes.square]}*({r})", range_, core,
    )  # fmt: skip


# -- circumradius (item 4) ----------------------------------------------------------------------------


def circumradius(letter: str, claimed: str | None = None, centre: RunVector | None = None) -> Proof:
    """The circumcentre has the same distance R from all vertices."""
    family = FAMILIES[letter]
    claimed = claimed or form(letter, "circumradius")
    point = centre or family.circumcentre
    start = family.range(family.nodes[0])
    square = in_d(squared_distance(vertex(family.nodes[0]), point, start), family.first)
    return join(
        rf"$R = {latex(claimed)}$ is the circumradius of $\tilde{{{letter}}}_d$, $d \geq {family.first}$",
        _in_the_hyperplane(family, point),
        (_vertex_distance(family, nodes, square, point) for nodes in family.nodes),
        formulas("so the circumradius", "R", f"sqrt({square})", claimed, family.first,
                 core=lambda d: the_simplex(letter, d).circumradius),
    )  # fmt: skip


def in_d(value: Rational, first: int) -> str:
    """A rational function of the parameter in d = first + a, as a formula in d."""
    return str(sympy.factor(value.as_expr().subs({"a": sympy.Symbol("d") - first, "w": sympy.sqrt(2)})))


def _vertex_distance(family: Classical, nodes: Nodes, square: str, centre: RunVector) -> Step:
    range_ = family.range(nodes)

    def core(**letters: int) -> Exact:
        simplex = the_simplex(family.letter, letters["d"])
        pairs = zip(
            simplex.circumcentre, simplex.vertex_matrix.row(node(nodes.index, **letters)), strict=True
        )
        return sum((x - y) ** 2 for x, y in pairs)

    value = squared_distance(vertex(nodes), centre, range_)
    return identity(
        f"from the centre to $u_{{{nodes.index}}}$",
        rf"\|u_{{{nodes.index}}} - c\|^2",
        value,
        square,
        range_,
        core,
    )


def form(letter: str, quantity: str) -> str:
    """The closed form of the library, for the general d."""
    return closed_form(letter, quantity).pieces[-1].text
