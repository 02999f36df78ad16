"""Section 2: graphs and what they generate; the parts on roots, lattices and affine groups follow."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from importlib import import_module
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from .. import diagrams
from ..affine import affine_reflection
from ..errors import CoxeterError, InvalidInput
from ..exact import RationalMatrix, Surd, sqrt
from ..names import EXCEPTIONAL, MINIMAL_RANK, triangulations_up_to
from ..roots import RootSystem, root_system
from .claim import Constants, Finding, agree, cited, claim, fails
from .section_1 import explained, fits, quoted
from .vocabulary import EVERY_D, LITERATURE, Weight

if TYPE_CHECKING:
    import networkx as nx

RESULT, WORDING = Weight.RESULT, Weight.WORDING


@lru_cache(maxsize=16)
def systems(rank: int, letters: str = "ABCDEFG") -> tuple[RootSystem, ...]:
    """The root systems up to a rank, of the types with given letters."""
    return tuple(
        root_system((x, r))
        for r in range(1, rank + 1)
        for x in letters
        if r in EXCEPTIONAL.get(x, ()) or r >= MINIMAL_RANK.get(x, rank + 1)
    )


@lru_cache(maxsize=1)
def _small_graphs() -> tuple[nx.Graph, ...]:
    """All connected graphs with up to five nodes."""
    import networkx as nx

    return tuple(g for g in nx.graph_atlas_g() if 0 < len(g) <= 5 and nx.is_connected(g))


def _is_definite(cartan: np.ndarray) -> bool:
    """Whether a symmetric integer matrix is positive definite: its leading minors are positive."""
    return all(RationalMatrix(cartan[:k, :k]).det() > 0 for k in range(1, len(cartan) + 1))


def _sigma(cartan: np.ndarray, i: int, coefficient: int = 1) -> np.ndarray:
    """The matrix of x -> x - coefficient·<x, e_i>e_i."""
    matrix = np.eye(len(cartan), dtype=np.int64)
    matrix[i] -= coefficient * cartan[i]
    return matrix


def family_of(name: str) -> str:
    """The family of a type: ``B~5`` and ``B5`` are in B."""
    plain = name.replace("~", "")
    return plain[0] if plain[0] in "ABCD" else plain


@lru_cache(maxsize=64)
def is_stable(system: RootSystem) -> bool:
    """Whether the reflection in each root maps the set of roots to itself."""
    n = system.roots.numerators
    place = 31 ** np.arange(n.shape[1])  # tells rows with entries up to 15 apart; lengths do not change
    codes = n @ place
    for r in n:
        twice, square = 2 * (n @ r), int(r @ r)
        if (twice % square).any() or not np.isin((n - np.outer(twice // square, r)) @ place, codes).all():
            return False
    return True


def sign_of_form(tree: nx.Graph) -> int:
    """1 if the form of a labelled tree is positive definite, 0 if only semidefinite, -1 if it is indefinite.

    Elimination from the leaves inwards needs only 4·cos²(pi/m) for the labels m. If a pivot within the tree
    is not positive, then the form has a negative direction, as the tree is connected.
    """
    import networkx as nx

    pivot = dict.fromkeys(tree, Fraction(2))
    for parent, child in reversed(list(nx.dfs_edges(tree, 0))):
        if pivot[child] <= 0:
            return -1
        pivot[parent] -= {3: 1, 4: 2, 6: 3}[tree.edges[parent, child].get("m", 3)] / pivot[child]
    return (pivot[0] > 0) - (pivot[0] < 0)


@lru_cache(maxsize=32)
def _known(nodes: int, affine: bool) -> tuple[tuple[str, nx.Graph], ...]:
    """The diagrams of Theorem 2, or 4, with a number of nodes; $B_d$ stands for $C_d$ too."""
    rank = nodes - affine
    names = [s for s in systems(rank) if s.rank == rank and (affine or s.type.letter != "C")]
    if affine:
        kinds = triangulations_up_to(rank)
        return tuple((s.type.affine, diagrams.affine_diagram(s)) for s in names if s.type in kinds)
    return tuple((s.name, diagrams.coxeter_diagram(s)) for s in names)


def name_of(graph: nx.Graph, affine: bool) -> str:
    """The name of a diagram on the list of Theorem 2, or 4; an error if it is not there."""
    import networkx as nx

    match = nx.algorithms.isomorphism.categorical_edge_match("m", 3)
    for name, known in _known(len(graph), affine):
        if nx.is_isomorphic(graph, known, edge_match=match):
            return name
    raise CoxeterError(f"the lists miss a diagram: {sorted(graph.edges(data='m'))}")


@lru_cache(maxsize=2)
def names_of_trees(nodes: int, labels: tuple[int, ...]) -> dict[int, tuple[str, ...]]:
    """The names of all trees up to a number of nodes, with labels, by the sign of the form, if it is not
    -1."""
    import networkx as nx

    found: dict[int, set[str]] = {1: {"A1"}, 0: set()}
    for tree in (t for n in range(2, nodes + 1) for t in nx.nonisomorphic_trees(n)):
        for chosen in product(labels, repeat=len(tree) - 1):
            nx.set_edge_attributes(tree, dict(zip(tree.edges, chosen, strict=True)), "m")
            if (sign := sign_of_form(tree)) >= 0:
                found[sign].add(name_of(tree, affine=not sign))
    return {sign: tuple(sorted(names)) for sign, names in found.items()}


# -- 2.1, graphs and Cartan matrices ----------------------------------------------------------------------


@claim("sec2.adjacency", "Section 2.1", WORDING)
def adjacency(printed: Constants) -> Finding:
    """The symmetric matrix of a graph with {joined} for nodes that are joined and {not_joined} for others
    is called its {name}."""
    import networkx as nx

    path = nx.path_graph(3)
    entries = nx.to_numpy_array(path, dtype=np.int64)
    incidence = (len(path), path.number_of_edges())
    name = "incidence matrix" if incidence == entries.shape else "adjacency matrix"
    finding = agree(
        printed, {"name": name, "joined": int(entries[0, 1]), "not_joined": int(entries[0, 2])}, EVERY_D,
        f"For a path of three nodes it is of shape {entries.shape}; the incidence matrix, with a row for "
        f"each node and a column for each edge, is of shape {incidence}.",
    )  # fmt: skip
    return explained(finding, "An incidence matrix has a column for each edge; nothing else is affected")


@claim("def-2", "Section 2.1, Definition 2", WORDING, to_state=["sec2.adjacency"])
def cartan_matrix_of_graph(printed: Constants) -> Finding:
    """The Cartan matrix of a graph has {diagonal} on the diagonal, {joined} for joined nodes, and else 0."""
    found: dict[str, set[Fraction]] = {"diagonal": set(), "joined": set()}
    for system in systems(8, "ADE"):
        gram = system.simple_roots @ system.simple_roots.T
        graph = diagrams.coxeter_diagram(system)
        found["diagonal"] |= {gram[i, i] for i in range(system.rank)}
        found["joined"] |= {gram[i - 1, j - 1] for i, j in graph.edges}
    true = {name: int(values.pop()) for name, values in found.items() if len(values) == 1}
    return agree(
        printed, true, EVERY_D,
        "A definition: $C=2I-A$. The simple roots of $A_d,D_d,E_6,E_7,E_8$ in Theorem 3 have these inner "
        "products; computed up to rank 8.",
    )  # fmt: skip


@claim("def-2.form", "Section 2.1", WORDING, to_state=["def-2"])
def form_of_graph(printed: Constants) -> Finding:
    """Cartan matrices of graphs are symmetric, so each gives a symmetric bilinear form."""
    true = all((c == c.T).all() for c in map(diagrams.cartan_matrix, _small_graphs()))
    return agree(
        printed, {"symmetric": bool(true)}, EVERY_D, "A node is joined to its neighbours, and they to it."
    )


@claim("sec2.non-euclidean", "Section 2, introduction", WORDING, to_state=["def-2.form"])
def non_euclidean(printed: Constants) -> Finding:
    """A positive definite Cartan matrix defines an inner product other than the standard one."""
    standard = any(
        (diagrams.cartan_matrix(g) == np.eye(len(g), dtype=np.int64)).all() for g in _small_graphs()
    )
    return agree(
        printed, {"standard": bool(standard)}, EVERY_D,
        "$\\langle e_i,e_i\\rangle_C=2$. (\"Non-Euclidean\" is meant so; with an inner product the space "
        "is a Euclidean one, as Proposition 2 says.)",
    )  # fmt: skip


@claim("sec2.sigma", "Section 2.1", RESULT, to_state=["def-2.form"])
def sigma(printed: Constants) -> Finding:
    """The map that takes away from x its product with $e_i$, times {coefficient}, times $e_i$, is the
    reflection in the hyperplane orthogonal to $e_i$, if the form is positive definite."""
    true = {c for c in range(-3, 4) if c and _is_reflection(c)}
    return agree(
        printed, {"coefficient": min(true)}, EVERY_D,
        "$\\sigma_i(e_i)=e_i-2e_i=-e_i$ as $c_{ii}=2$, and $\\sigma_i$ fixes all x with $\\langle "
        "x,e_i\\rangle_C=0$.",
        "Computed for the connected graphs with up to five nodes: it keeps the form, and its square is the "
        "identity.",
    )  # fmt: skip


@lru_cache(maxsize=8)
def _is_reflection(coefficient: int) -> bool:
    """Whether the maps with a coefficient keep the forms of all small definite graphs, and are
    involutions."""
    for c in filter(_is_definite, map(diagrams.cartan_matrix, _small_graphs())):
        for i in range(len(c)):
            m = _sigma(c, i, coefficient)
            if (m.T @ c @ m != c).any() or (m @ m != np.eye(len(c), dtype=np.int64)).any():
                return False
    return True


@claim("def-3", "Section 2.1, Definition 3", WORDING, to_state=["sec2.sigma"])
def weyl_group_of_graph(printed: Constants) -> Finding:
    """The Weyl group of a graph is generated by the invertible maps $\\sigma_i$; the roots are the images
    of the $e_i$."""
    true = all(
        (_sigma(c, i) @ _sigma(c, i) == np.eye(len(c), dtype=np.int64)).all()
        for c in map(diagrams.cartan_matrix, _small_graphs())
        for i in range(len(c))
    )
    return agree(
        printed, {"invertible": bool(true)}, EVERY_D,
        "A definition. Each $\\sigma_i$ is its own inverse, for any graph, definite or not, since "
        "$c_{ii}=2$.",
    )  # fmt: skip


def _roots_of(cartan: np.ndarray, limit: int) -> set[tuple[int, ...]]:
    """The roots of a graph, or the first of them, more than the limit."""
    fresh = {tuple(int(x) for x in row) for row in np.eye(len(cartan), dtype=np.int64)}
    found = set(fresh)
    while fresh and len(found) <= limit:
        images = ((i, r, int(cartan[i] @ r)) for r in fresh for i in range(len(cartan)))
        fresh = {(*r[:i], r[i] - x, *r[i + 1 :]) for i, r, x in images} - found
        found |= fresh
    return found


def _group_order(cartan: np.ndarray) -> int:
    """The order of the Weyl group of a graph with positive definite form, by multiplying out."""
    generators = [_sigma(cartan, i) for i in range(len(cartan))]
    fresh = [np.eye(len(cartan), dtype=np.int64)]
    seen = {fresh[0].tobytes()}
    while fresh:
        products = {m.tobytes(): m for g in generators for x in fresh for m in [g @ x]}
        fresh = [m for key, m in products.items() if key not in seen]
        seen |= products.keys()
    return len(seen)


@lru_cache(maxsize=1)
def _theorem_1() -> bool:
    """Whether definite graphs with up to five nodes have finitely many roots and a finite group, and others
    not."""
    for cartan in map(diagrams.cartan_matrix, _small_graphs()):
        definite, roots = _is_definite(cartan), _roots_of(cartan, 200)
        if definite != (len(roots) <= 200) or (definite and not _group_order(cartan)):
            return False
    return True


@claim("thm-1", "Section 2.1, Theorem 1", RESULT, to_state=["def-2.form", "def-3"])
def theorem_1(printed: Constants) -> Finding:
    """For a connected graph it is the same that the form is positive definite, that there are finitely many
    roots, and that the Weyl group is finite."""
    return quoted(
        agree(
            printed, {"equivalent": _theorem_1()}, LITERATURE,
            "Roots and group are finite together: the roots are the images of d vectors, and as they "
            "contain a basis the group acts faithfully on them. A finite group keeps an inner product; "
            "that it is the form itself, up to a factor, and the converse, is Theorem 6.4 of Humphreys "
            "(the paper names Section 1.3).",
        ),
        "Humphreys, Section 6.4.",
        f"All {len(_small_graphs())} connected graphs with up to five nodes: the definite ones have at "
        "most 40 roots and a group that was multiplied out, the others more than 200 roots.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _orders() -> tuple[tuple[str, int, int], ...]:
    """Type, order of the group and number of roots, for graphs with a positive definite form."""
    return tuple(
        (s.name, s.weyl_group_order, 2 * len(s.positive_root_coordinates)) for s in systems(8, "ADE")
    )


@claim("prop-1", "Section 2.1, Proposition 1", RESULT, to_state=["def-3"])
def proposition_1(printed: Constants) -> Finding:
    """For a graph with positive definite form the Weyl group acts simply transitively on this:
    {acts_simply_transitively_on}."""
    root, mirror = (1, -1, 0, 0), (0, 0, 1, -1)
    fixed = affine_reflection(mirror, 0, root) == tuple(map(Fraction, root))
    agreeing = [name for name, order, count in _orders() if order == count]
    name, order, count = next(row for row in _orders() if row[1] != row[2])
    true, said = "sets of simple roots", printed["acts_simply_transitively_on"]
    if said == true:
        return cited("Humphreys, Section 1.8.", "See Lemma 1.")
    if said != "roots" or not fixed:
        raise InvalidInput(f"it is not known how the group acts on {said}: give 'roots' or {true!r}")
    return fails(
        EVERY_D,
        f"In {name} the group has {order} elements and there are {count} roots: the reflection in "
        "$e_3-e_4$ fixes the root $e_1-e_2$.",
        "The group acts simply transitively on the sets of simple roots, which is what the source proves "
        "(Lemma 1). On the roots it acts transitively, and simply transitively only for "
        f"{' and '.join(agreeing)}.",
        constants={"acts_simply_transitively_on": true},
        derivation=(
            "Transitive: $\\sigma_i\\sigma_j(e_i)=e_j$ for joined nodes, and the graph is connected.",
            "Simply transitive would mean that only the identity fixes a root. But $\\sigma_i$ fixes $e_j$ "
            "for two nodes that are not joined, and a connected graph without two such nodes has all nodes "
            "joined, hence one or two of them: three make a triangle, which is not definite.",
            "Orders and numbers of roots: "
            + ", ".join(f"{n} {a} and {b}" for n, a, b in _orders()[:4])
            + ", …",
        ),
    )


@lru_cache(maxsize=1)
def _definite_families() -> tuple[str, ...]:
    """The families of the definite trees with up to nine nodes; every graph with a cycle must be
    indefinite."""
    import networkx as nx

    for g in _small_graphs():
        if not nx.is_tree(g) and _is_definite(diagrams.cartan_matrix(g)):
            raise CoxeterError("a graph with a cycle has a positive definite form")
    return tuple(sorted({family_of(name) for name in names_of_trees(9, (3,))[1]}))


@claim("sec2.definite-graphs", "Section 2.1", RESULT, to_state=["def-2.form"])
def definite_graphs(printed: Constants) -> Finding:
    """The connected graphs with a positive definite form are those of the families {types}."""
    return agree(
        printed, {"types": _definite_families()}, EVERY_D,
        "If x has coordinates $\\ge0$ and form 0 on a graph, then on each connected graph that contains it "
        "the form of x is at most 0, as more edges only lower it. Such x exist for a cycle (all 1), for a "
        "node with four neighbours (2, and 1 four times), for a path with two more nodes at each end (2 "
        "along the path, 1 at the four ends): $\\tilde A$, $\\tilde D$. So a definite graph is a tree with "
        "at most one node of degree three, or a path.",
        "Let its arms have p ≤ q ≤ r nodes. Likewise $\\tilde E_6$, $\\tilde E_7$, $\\tilde E_8$ exclude "
        "(2, 2, 2), (1, 3, 3) and (1, 2, 5), so it is (1, 1, r), that is $D_d$, or (1, 2, r) with r ≤ 4. "
        "These are definite, by the determinants of their Cartan matrices, d + 1 for $A_d$, 4 for $D_d$, 9 "
        "- d for $E_d$.",
        "Computed: all trees with up to nine nodes, all connected graphs with up to five.",
    )  # fmt: skip


# -- vectors with given products --------------------------------------------------------------------------


def _vectors(cartan: np.ndarray) -> list[list[Surd]] | None:
    """Vectors with the matrix as their inner products, by elimination; None if it is not positive
    definite."""
    rows: list[list[Fraction]] = []
    squares: list[Fraction] = []
    for i in range(len(cartan)):
        row: list[Fraction] = []
        for j in range(i):
            known = sum((a * b * c for a, b, c in zip(row, rows[j], squares, strict=False)), Fraction(0))
            row.append((int(cartan[i, j]) - known) / squares[j])
        rest = int(cartan[i, i]) - sum((a * a * c for a, c in zip(row, squares, strict=True)), Fraction(0))
        if rest <= 0:
            return None
        rows.append([*row, Fraction(1)])
        squares.append(rest)
    size = len(cartan)
    return [
        [x * sqrt(c) for x, c in zip(row, squares, strict=False)] + [Surd(0)] * (size - len(row))
        for row in rows
    ]


@lru_cache(maxsize=1)
def _realised() -> dict[int, Fraction]:
    """d -> the dimension that vectors with the products of a Cartan matrix span."""
    found = {}
    for system in systems(5, "ADE"):
        cartan = system.cartan_matrix
        vectors = _vectors(cartan)
        for i, j in product(range(system.rank), repeat=2):
            if vectors is None or sum(
                (a * b for a, b in zip(vectors[i], vectors[j], strict=True)), Surd(0)
            ) != int(cartan[i, j]):
                raise CoxeterError(f"elimination does not find the vectors of {system.name}")
        found[system.rank] = Fraction(RationalMatrix(cartan).rank())
    return found


@claim("sec2.independent", "Section 2.2", RESULT, to_state=["def-2"])
def independent(printed: Constants) -> Finding:
    """Vectors whose inner products are a positive definite Cartan matrix are linearly independent."""
    true = all(
        RationalMatrix(s.cartan_matrix).det() != 0 and s.simple_roots.rank() == s.rank
        for s in systems(8, "ADE")
    )
    return agree(
        printed, {"independent": true}, EVERY_D,
        "A relation between the vectors would be one between the columns of the matrix of their products, "
        "which is invertible.",
    )  # fmt: skip


@claim("prop-2", "Section 2.2, Proposition 2", RESULT, to_state=["def-2"])
def proposition_2(printed: Constants) -> Finding:
    """Vectors whose inner products are a given positive definite Cartan matrix exist in a space of
    dimension {space}."""
    return agree(
        printed, {"space": fits(printed["space"], "d", _realised())}, EVERY_D,
        "Gaussian elimination of a positive definite matrix gives $C=LDL^t$ with a lower triangular L and "
        "a diagonal D > 0. The rows of $L\\sqrt D$ are such vectors; as C has rank d, no smaller space has "
        "any.",
        "Computed for $A_d$ and $D_d$ up to d = 5, and the products multiplied out.",
    )  # fmt: skip


@claim("rem-1", "Section 2.2, Remark 1", WORDING, to_state=["prop-2"])
def remark_1(printed: Constants) -> Finding:
    """The choice of the vectors is not unique, and nicer ones exist in a larger space."""
    a2 = root_system("A2")
    determinant = RationalMatrix(a2.cartan_matrix).det()
    rational_in_plane = sqrt(determinant).is_rational
    gram = a2.simple_roots @ a2.simple_roots.T
    opposite = RationalMatrix(-a2.simple_roots.numerators, a2.simple_roots.denominator)
    integral = a2.simple_roots.denominator == 1 and gram == RationalMatrix(a2.cartan_matrix)
    unique = opposite @ opposite.T != gram
    return agree(
        printed, {"unique": unique, "nicer_in_larger_space": integral and not rational_in_plane}, EVERY_D,
        "Each rotation of the vectors is another choice.",
        "For $A_2$: two vectors of the plane with rational coordinates would have a rational determinant, "
        f"with square {determinant}. In space $e_1-e_2$, $e_2-e_3$ have whole coordinates.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _stable_families() -> tuple[str, ...]:
    found = {s.type.family: True for s in systems(8, "ADE")}
    for s in systems(8, "ADE"):
        found[s.type.family] &= is_stable(s)
    return tuple(sorted(family for family, stable in found.items() if stable))


@claim("sec2.stable", "Section 2.2", RESULT, to_state=["def-3", "prop-2"])
def stable(printed: Constants) -> Finding:
    """The root sets of the diagrams {types} are mapped to themselves by the reflections in their roots,
    which generate a finite group."""
    return agree(
        printed, {"types": _stable_families()}, EVERY_D,
        "For a root $r=w(e_i)$ the reflection in r is $w\\sigma_iw^{-1}$, an element of the group, and the "
        "roots are orbits of the group. A finite set that spans has finitely many symmetries.",
        "Computed up to rank 8.",
    )  # fmt: skip


for _part in ("roots", "lattices", "affine"):  # in the order of the paper
    import_module(f"{__name__}_{_part}")
