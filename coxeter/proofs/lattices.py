"""Which vertex sets are lattices, for every d: Propositions 7 to 10.

Lemmas used: a vertex is a point in which walls with d independent normals meet; and the affine Weyl group
carries every vertex to one of the fundamental simplex.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..exact import Exact
from ..lattices import vertex_lattice
from ..symbolic.cases import case
from ..symbolic.runs import inner, runs, square, total_of
from .classical import FAMILIES, vector
from .proof import Proof, ReplayFailed, Step, argument, identity, join, tested
from .simplices import the_triangulation

PLUS = (("0", "j - 1"), ("1", "1"), ("0", "k - j - 1"), ("1", "1"), ("0", "d - k"))
MINUS = (("0", "j - 1"), ("1", "1"), ("0", "k - j - 1"), ("-1", "1"), ("0", "d - k"))
SHORT = (("0", "k - 1"), ("1", "1"), ("0", "d - k"))
LONG = (("0", "k - 1"), ("2", "1"), ("0", "d - k"))
"""The positive roots of B, C and D: e_j + e_k, e_j - e_k, e_k, 2·e_k."""


def roots_are_all(letter: str) -> Iterator[Step]:
    """The listed roots are all: their number is the core's for each d that is tried."""

    def count(d: int) -> int:
        return {"A": d * (d + 1) // 2, "B": d * d, "C": d * d, "D": d * (d - 1)}[letter]

    def test(largest: int) -> int:
        ds = range(FAMILIES[letter].first, largest + 1)
        for d in ds:
            if len(the_triangulation(letter, d).roots.positive_roots.rows()) != count(d):
                raise ReplayFailed(f"{letter}{d} has another number of positive roots than {count(d)}")
        return len(ds)

    words = {
        "A": "The Weyl group permutes the coordinates, so the roots are all $e_i - e_j$",
        "B": "The Weyl group permutes the coordinates and changes signs, so the roots are all "
        r"$\pm e_i \pm e_j$ and $\pm e_i$",
        "C": "The Weyl group permutes the coordinates and changes signs, so the roots are all "
        r"$\pm e_i \pm e_j$ and $\pm 2e_i$",
        "D": "The Weyl group permutes the coordinates and changes an even number of signs, so the roots are "
        r"all $\pm e_i \pm e_j$",
    }[letter]
    number = {"A": "d(d+1)/2", "B": "d^2", "C": "d^2", "D": "d(d-1)"}[letter]
    yield argument(words)
    yield tested("the number of positive roots", rf"|R^+| = {number}", 12, test)


def proposition_7() -> Proof:
    """The vertex set of A~ is the coweight lattice."""
    return join(
        r"the vertex set of $\tilde A_d$ is the coweight lattice, for every $d \geq 2$",
        roots_are_all("A"),
        _products_with_roots_of_a(),
        argument(
            "So the vertices of the simplex lie in the coweight lattice. The lattice is stable under the "
            "affine Weyl group (Lemma 15), which carries them to all vertices: all lie in it"
        ),
        argument("Conversely each of its points is a vertex (Lemma 14)"),
        _replay_lattices("A", True),
    )


def _products_with_roots_of_a() -> Iterator[Step]:
    """The products of the vertices of the simplex with the roots are 0 and 1."""
    root = runs(*((x, n.replace("d - k", "d + 1 - k")) for x, n in MINUS))
    vertex = vector(FAMILIES["A"].nodes[1].vertex, "m")

    def core(d: int, j: int, k: int, m: int) -> Exact:
        u = the_triangulation("A", d).simplex.vertex_matrix.row(m)
        return u[j - 1] - u[k - 1]

    chains = {
        "before": "1 <= m < j < k <= d + 1",
        "between": "1 <= j <= m < k <= d + 1",
        "after": "1 <= j < k <= m <= d",
    }
    for words, chain in chains.items():
        range_ = case(chain, 2)
        yield identity(
            f"the vertex $u_m$ and the root $e_j - e_k$, with $m$ {words} them",
            r"\langle u_m, e_j - e_k\rangle", inner(vertex, root, range_),
            "1" if words == "between" else "0", range_, core,
        )  # fmt: skip


def proposition_8() -> Proof:
    """No vertex set of B~ is a lattice: e_d/2 = u_d - u_(d-1) is not a vertex."""
    whole = case("3 <= d", 3)
    *_, several, end = FAMILIES["B"].nodes
    points = [vector(end.vertex, "d"), vector(several.vertex, "(d - 1)"), runs(("0", "d - 1"), ("1/2", "1"))]
    difference = total_of(points, whole, lambda x: (x[0] - x[1] - x[2]) ** 2)
    return join(
        r"the vertex set of $\tilde B_d$ is no lattice, for every $d \geq 3$",
        roots_are_all("B"),
        _half_unit_vectors("B"),
        identity(
            r"$u_d - u_{d-1}$ is $\tfrac12 e_d$", r"\|u_d - u_{d-1} - \tfrac12 e_d\|^2",
            difference, "0", whole,
        ),
        argument("So the vertex set is not closed under subtraction"),
        _replay_lattices("B", False),
    )  # fmt: skip


def proposition_9() -> Proof:
    """The vertex set of C~ is (Z/2)^d."""
    each, pairs = case("1 <= k <= d", 2), case("1 <= j < k <= d", 2)
    return join(
        r"the vertex set of $\tilde C_d$ is $(\tfrac12\mathbb{Z})^d$, for every $d \geq 2$",
        roots_are_all("C"),
        argument(
            r"The vertices of the simplex have coordinates 0 and $\tfrac12$. A reflection adds to a point "
            r"$x$ an integer minus $\langle x, r\rangle$, times the coroot $r^\vee$"
        ),
        identity(
            "a long root is twice its coroot", r"\langle 2e_k, 2e_k\rangle", square(runs(*LONG), each), "4",
            each,
        ),
        (
            identity(
                "the others are their own coroots", rf"\langle e_j {sign} e_k, e_j {sign} e_k\rangle",
                square(runs(*root), pairs), "2", pairs,
            )
            for sign, root in (("+", PLUS), ("-", MINUS))
        ),
        argument(
            r"So coroots are integer vectors, and for $x \in (\tfrac12\mathbb{Z})^d$ the products with "
            r"$e_j \pm e_k$ are in $\tfrac12\mathbb{Z}$, those with $2e_k$ integers: reflections keep "
            r"$(\tfrac12\mathbb{Z})^d$"
        ),
        argument(
            r"Conversely the $d$ independent roots $2e_k$ have integer product with each of its points, so "
            "each is a vertex"
        ),
        _replay_lattices("C", True),
    )  # fmt: skip


def proposition_10() -> Proof:
    """No vertex set of D~ is a lattice from d = 5 on: e_3/2 = u_3 - u_2 is not a vertex."""
    return join(
        r"the vertex set of $\tilde D_d$ is no lattice, for every $d \geq 5$",
        roots_are_all("D"),
        _half_unit_vectors("D"),
        argument(
            r"For $d \geq 5$ the vertices $u_2$ and $u_3$ are $(\tfrac12^{\{2\}}, 0^{\{d-2\}})$ and "
            r"$(\tfrac12^{\{3\}}, 0^{\{d-3\}})$: their difference is $\tfrac12 e_3$, and the vertex set is "
            "not closed under subtraction"
        ),
        _replay_lattices("D", False, 5),
    )


def _half_unit_vectors(letter: str) -> Iterator[Step]:
    """The points e_m/2 are not vertices: roots with a coordinate m have products that are no integers."""
    point = runs(("0", "m - 1"), ("1/2", "1"), ("0", "d - m"))
    for sign, pairs in (("+", PLUS), ("-", MINUS)):
        for chain in ("m < j < k", "j < m < k", "j < k < m", "m == j < k", "j < m == k"):
            range_ = case(f"1 <= {chain} <= d", 3)
            expected = "0" if "==" not in chain else "-1/2" if (sign, chain) == ("-", "j < m == k") else "1/2"
            yield identity(
                r"the point $\tfrac12 e_m$ and a root", rf"\langle\tfrac12 e_m, e_j {sign} e_k\rangle",
                inner(point, runs(*pairs), range_), expected, range_,
            )  # fmt: skip
    if letter == "B":
        for chain in ("m < k", "k < m", "m == k"):
            range_ = case(f"1 <= {chain} <= d", 3)
            yield identity(
                r"the point $\tfrac12 e_m$ and a short root", r"\langle\tfrac12 e_m, e_k\rangle",
                inner(point, runs(*SHORT), range_), "1/2" if "==" in chain else "0", range_,
            )  # fmt: skip
    yield argument(
        "So the roots with integer product lie in the hyperplane $x_m = 0$: no $d$ of them are independent, "
        "and the point is not a vertex"
    )


def _replay_lattices(letter: str, lattice: bool, first: int = 0) -> Step:
    low = first or FAMILIES[letter].first

    def test(largest: int) -> int:
        ds = range(low, min(largest, 8) + 1)
        for d in ds:
            if bool(vertex_lattice(the_triangulation(letter, d))) is not lattice:
                raise ReplayFailed(f"the core finds the opposite for {letter}~{d}")
        return len(ds)

    words = "the core's count of cosets agrees"
    return tested(words, r"V = \Lambda" if lattice else r"V \neq \Lambda", 8, test)
