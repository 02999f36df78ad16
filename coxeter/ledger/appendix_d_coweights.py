"""Appendix D, Lemmas 14 and 15 and Proposition 7: coweights and the vertex set of A~."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import permutations, product
from math import factorial

from ..affine import CoxeterTriangulation, affine_reflection, triangulation
from ..errors import InvalidInput
from ..exact import show
from ..lattices import LatticeProof, vertex_lattice
from ..root_lattices import coweight_lattice, root_lattice
from ..root_sets import cartan_integer
from .claim import Constants, Finding, agree, claim, corrected, decide, holds
from .instances import all_types
from .vectors import Point, inner, rational_point
from .vocabulary import EVERY_D, Weight
from .wording import told

LEMMA_14 = "Appendix D, Lemma 14"
LEMMA_15 = "Appendix D, Lemma 15"
PROPOSITION_7 = "Appendix D, proof of Proposition 7"

# -- Lemma 14 ----------------------------------------------------------------------------------------------


@claim("lem-14", LEMMA_14, Weight.RESULT, to_state=("def-12", "def-16"), to_prove=("lem-14.hyperplanes",))
def coweights_are_vertices(printed: Constants) -> Finding:
    """The coweight lattice of a crystallographic root system is {contained?|not }contained in the vertex set
    of its triangulation."""
    return agree(
        printed,
        {"contained": all(_contains_coweights(t) for t in all_types(8))},
        EVERY_D,
        "A coweight p has integer inner products $n_i$ with the simple roots, so it lies on the "
        "hyperplanes $H_{s_i,n_i}$, whose d normals are independent.",
        "Tried with the fundamental coweights, their sums and negatives, for all types up to dimension 8.",
    )


@lru_cache(maxsize=64)
def _contains_coweights(t: CoxeterTriangulation) -> bool:
    rows = t.roots.fundamental_coweights.rows()
    total = tuple(map(sum, zip(*rows, strict=True)))
    return all(t.is_vertex(x) for x in (*rows, tuple(-x for x in rows[0]), total))


@claim("lem-14.hyperplanes", f"{LEMMA_14}, proof", Weight.WORDING, to_state=("def-13",))
@told
def hyperplanes(printed: Constants) -> Finding:
    r"""If $n_i$ are the inner products of a point with the simple roots $s_i$, the point lies on the d
    hyperplanes of the $s_i$ with the numbers {level}$_i$, and their normals are
    {independent?independent|dependent}."""
    independent = all(t.roots.simple_roots.rank() == t.dimension for t in all_types(8))
    return decide(
        printed["level"] == "n" and printed["independent"] is independent,
        EVERY_D,
        r"The hyperplanes are $H_{s_i,n_i}$; the letter $k_i$ has not been introduced.",
        r"$\langle p,s_i\rangle=n_i$ means $p\in H_{s_i,n_i}$ (Definition 13); simple roots are a basis.",
        constants={"level": "n", "independent": True},
    )


# -- Lemma 15 ----------------------------------------------------------------------------------------------


@claim("lem-15", LEMMA_15, Weight.RESULT, to_state=("def-12", "def-14"), to_prove=("eq-7", "lem-15.integers"))
def coweights_are_stable(printed: Constants) -> Finding:
    """The affine Weyl group {stable?maps|does not map} the coweight lattice to itself."""
    return agree(
        printed,
        {"stable": all(_is_stable(t) for t in all_types(8))},
        EVERY_D,
        r"By (7) the product of $\sigma_{r,k}(x)$ with any root is an integer if those of x are: "
        r"$\langle r^\vee,r'\rangle$ is a Cartan integer. The reflections generate the group.",
        "Tried with the reflections in the facets of the fundamental simplex, which generate the group, "
        "for all types up to dimension 8.",
    )


@lru_cache(maxsize=64)
def _is_stable(t: CoxeterTriangulation) -> bool:
    lattice = coweight_lattice(t.roots)
    points = [*lattice.basis.rows(), (Fraction(0),) * lattice.basis.shape[1]]
    return all(facet.reflect(x) in lattice for facet in t.facets for x in points)


@lru_cache(maxsize=1)
def _reflected() -> tuple[tuple[Fraction, ...], ...]:
    """For roots r, r', points x and integers k: ⟨σ(x), r'⟩, ⟨x, r'⟩ and (⟨x, r⟩ - k)⟨r^∨, r'⟩."""
    found = []
    for name in ("B~3", "C~2", "G~2"):
        roots = triangulation(name).roots.roots
        x = tuple(Fraction(2 * i + 1, 5) for i in range(roots.shape[1]))
        for r, other, k in product(roots.rows(), roots.rows(), (-1, 0, 2)):
            second = (inner(x, r) - k) * 2 * inner(r, other) / inner(r, r)
            found.append((inner(affine_reflection(r, k, x), other), inner(x, other), second))
    return tuple(found)


@claim("eq-7", "Appendix D, equation (7)", Weight.PROOF, to_state=("def-10", "def-14"))
def seventh_equation(printed: Constants) -> Finding:
    r"""$\langle\sigma_{r,k}(x),r'\rangle$ is ${first:times}\langle x,r'\rangle {second:plus} (\langle
    x,r\rangle-k)\langle r^\vee,r'\rangle$."""
    good = all(left == printed["first"] * a + printed["second"] * b for left, a, b in _reflected())
    why = r"The product of $\sigma_{r,k}(x)=x-(\langle x,r\rangle-k)r^\vee$ with $r'$."
    return decide(good, EVERY_D, "the coefficients are 1 and -1", why, constants={"first": 1, "second": -1})


@claim("lem-15.integers", f"{LEMMA_15}, proof", Weight.PROOF, to_prove=("lem-15.cartan-integer",))
def integers(printed: Constants) -> Finding:
    r"""The numbers $\langle r^\vee,r'\rangle$ are Cartan integers, {integers?so integers|not always
    integers}."""
    found = all(
        (2 * inner(r, other) / inner(r, r)).denominator == 1
        for t in all_types(4)
        for r in t.roots.positive_roots.rows()
        for other in t.roots.simple_roots.rows()
    )
    return agree(
        printed, {"integers": found}, EVERY_D, "The root system is crystallographic (Definitions 4 and 7)."
    )


@claim("lem-15.cartan-integer", f"{LEMMA_15}, proof", Weight.WORDING, to_state=("eq-7", "rem-2"))
@told
def which_cartan_integer(printed: Constants) -> Finding:
    r"""$\langle r^\vee,r'\rangle$ is the Cartan integer n({arguments}) of Definition 7."""
    found = _misread(printed["arguments"])
    if not found:
        return holds(
            EVERY_D, r"$n(r',r)=2\frac{\langle r,r'\rangle}{\langle r,r\rangle}=\langle r^\vee,r'\rangle$."
        )
    r, other, product_of_both, number = found
    return corrected(
        EVERY_D,
        "It is $n(r',r)$: Definition 7 divides by the squared length of the second argument. Both are "
        "integers, so that nothing changes.",
        constants={"arguments": ("r'", "r")},
        witness=f"In $C_2$: r = {show(r)}, r' = {show(other)}: the product is {product_of_both}, n(r, r') "
        f"is {number}.",
        evidence="The interpretation in Remark 2, which is referred to, has the same exchange.",
    )


def _misread(arguments: tuple[str, ...]) -> tuple[Point, Point, Fraction, Fraction] | None:
    """The shortest two roots of C_2 for which the Cartan integer is not the product, with both numbers."""
    if sorted(arguments) != ["r", "r'"]:
        raise InvalidInput("a Cartan integer has the two arguments r and r'")
    positive = triangulation("C~2").roots.positive_roots.rows()
    for r, other in sorted(product(positive, positive), key=lambda pair: sum(inner(x, x) for x in pair)):
        named = {"r": r, "r'": other}
        number = cartan_integer(*(named[name] for name in arguments))
        true = 2 * inner(r, other) / inner(r, r)
        if number != true:
            return r, other, true, number
    return None


# -- Proposition 7 -----------------------------------------------------------------------------------------


INCLUSIONS = (
    "By Lemma 14 coweights are vertices. Conversely a vertex is the image, under an element of the affine "
    "Weyl group, of a vertex of the fundamental simplex, which is a coweight, and Lemma 15 keeps it one."
)


@lru_cache(maxsize=16)
def _lattice_of_a(d: int) -> LatticeProof | None:
    found = vertex_lattice(triangulation(("A", d)))
    assert found.check()
    return found if isinstance(found, LatticeProof) else None


@claim(
    "prop-7",
    "Section 6, Proposition 7",
    Weight.RESULT,
    to_prove=("prop-7.coweights",),
    proof=("proposition_7",),
)
def vertices_of_a(printed: Constants) -> Finding:
    r"""From d = {first} on the vertex set of $\tilde A_d$ is {lattice?a|not a} lattice."""
    found = {bool(_lattice_of_a(d)) for d in range(2, 13)}
    return decide(
        printed["first"] == 2 and found == {printed["lattice"]},
        EVERY_D,
        r"It is a lattice for every $d\ge2$.",
        "It is the coweight lattice:",
        INCLUSIONS,
        "A second proof, by counting cosets of the coroot lattice: the coweight lattice has $d+1$, and "
        "each of the $d+1$ vertices of the fundamental simplex has one orbit of $|W|/|W_k|=1$ coset.",
    )


@claim(
    "prop-7.coweights",
    PROPOSITION_7,
    Weight.PROOF,
    to_prove=("lem-14", "lem-15", "prop-6", "prop-7.vertices"),
)
def coweights_of_a(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde A_d$ is {coweight_lattice?|not }the coweight lattice."""
    found = (_lattice_of_a(d) for d in range(2, 13))
    equal = all(x and x.lattice == coweight_lattice(x.triangulation.roots) for x in found)
    return agree(
        printed,
        {"coweight_lattice": equal},
        EVERY_D,
        INCLUSIONS,
    )


@claim("prop-7.vertices", PROPOSITION_7, Weight.PROOF)
def vertices_are_coweights(printed: Constants) -> Finding:
    r"""The vertices of the fundamental simplex of $\tilde A_d$ {integral?have|do not have} integer inner
    products with all roots."""
    systems = [triangulation(("A", d)) for d in range(2, 13)]
    integral = all(
        t.integral_roots(u).shape[0] == t.roots.positive_roots.shape[0]
        for t in systems
        for u in t.simplex.vertex_matrix.rows()
    )
    return agree(
        printed,
        {"integral": integral},
        EVERY_D,
        r"Two coordinates of $u_k$ differ by 0 or $\pm\left(\frac k{d+1}+\frac{d+1-k}{d+1}\right)=\pm1$, "
        "and the roots are the differences $e_i-e_j$.",
    )


@claim("prop-7.permutahedral", PROPOSITION_7, Weight.WORDING, to_prove=("prop-7.coweights", "thm-7"))
def permutahedral(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde A_d$ is {dual?|not }the dual of the root lattice, and its Voronoi cells are
    {permutohedra?|not }permutohedra: it is the permutohedral lattice."""
    systems = [triangulation(("A", d)) for d in range(2, 6)]
    dual = all(root_lattice(t.roots).dual() == coweight_lattice(t.roots) for t in systems)
    return agree(
        printed,
        {"dual": dual, "permutohedra": all(map(_cells_are_permutohedra, systems))},
        EVERY_D,
        r"Coweights are defined as dual to the roots. $\tilde A_d$ is Delaunay, so the cell of 0 is the "
        "hull of the circumcentres of the simplices at 0. These are the images of the fundamental one "
        "under the Weyl group, which permutes the coordinates; its circumcentre has the coordinates "
        r"$\frac{d-2i}{2(d+1)}$, up to the sign, in arithmetic progression.",
    )


def _cells_are_permutohedra(t: CoxeterTriangulation) -> bool:
    """The coordinates of the circumcentre are in arithmetic progression, and the group permutes all of
    them."""
    centre = rational_point(t.simplex.circumcentre)
    steps = {abs(b - a) for a, b in zip(sorted(centre), sorted(centre)[1:], strict=False)}
    orders = {tuple(p) for p in permutations(range(t.dimension + 1))}
    return len(steps) == 1 and len(orders) == t.roots.weyl_group_order == factorial(t.dimension + 1)
