"""Section 2.3: the lattices of roots, coroots, weights and coweights."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import product

from ..affine import affine_reflection
from ..errors import InvalidInput
from ..exact import RationalMatrix, show
from ..figures import root_system_plane
from ..root_lattices import coroot_lattice, coweight_lattice, root_lattice, weight_lattice
from ..root_sets import cartan_integer, is_irreducible, is_reduced, is_root_system
from ..roots import RootSystem, root_system
from .claim import Constants, Finding, agree, claim
from .instances import all_types, systems
from .vectors import inner, point
from .vocabulary import EVERY_D, FINITE, Weight
from .wording import explained, fits

RESULT, WORDING = Weight.RESULT, Weight.WORDING


@claim("def-9", "Section 2.3, Definition 9", RESULT, to_state=["def-4"], to_prove=["def-6.integers"])
def definition_9(printed: Constants) -> Finding:
    """The integer combinations of the roots are a lattice."""
    true = all(r in root_lattice(s) for s in systems(4) for r in s.roots.rows())
    return agree(
        printed, {"lattice": true}, EVERY_D,
        "They are those of the simple roots, which are linearly independent. Without the crystallographic "
        "property they may be dense: in the system of ten roots of a pentagon, with the golden ratio.",
        "Computed: all roots lie in the lattice of the simple ones, up to rank 4.",
    )  # fmt: skip


@claim("def-9.lattice", "Section 2.3, after Definition 9", RESULT, to_state=["def-9"])
def lattice_properties(printed: Constants) -> Finding:
    """The root lattice is a group, contains a basis of a space of dimension {rank}, and meets bounded
    regions in finitely many points."""
    ranks = {s.rank: Fraction(s.simple_roots.rank()) for s in systems(8)}
    discrete = all(root_lattice(s).gram_determinant > 0 for s in systems(8))
    return agree(
        printed, {"rank": fits(printed["rank"], "d", ranks), "discrete": discrete}, EVERY_D,
        "The space is the span of the roots, as in Definition 4. A basis makes the lattice an image of "
        "$\\mathbb Z^d$ under an invertible map.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _coroot_factor() -> set[Fraction]:
    """The factors f for which <s, f·r/<r, r>> is the Cartan integer n(s, r), over all roots of G2."""
    found = set()
    for r, s in product(root_system("G2").roots.rows(), repeat=2):
        if inner(r, s):
            found.add(cartan_integer(s, r) * inner(r, r) / inner(r, s))
    return found


@claim("def-10", "Section 2.3, Definition 10", WORDING, to_state=["def-4"])
def definition_10(printed: Constants) -> Finding:
    """The coroot of a root r is r over its product with itself, times {factor}."""
    (factor,) = _coroot_factor()
    return agree(
        printed, {"factor": int(factor)}, EVERY_D,
        "A definition. With this factor the product of s with the coroot of r is the Cartan integer n(s, r).",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _dual_systems() -> bool:
    duals = [s.coroots for s in systems(4)]
    return all(is_root_system(x) and is_reduced(x) and is_irreducible(x) for x in duals)


@claim("def-10.root-system", "Section 2.3, Definition 10", RESULT, to_state=["def-10"])
def dual_root_system(printed: Constants) -> Finding:
    """The coroots form a root system."""
    return agree(
        printed, {"root_system": _dual_systems()}, EVERY_D,
        "r and its coroot have the same reflection, which keeps lengths, so "
        "$\\sigma_r(s^\\vee)=(\\sigma_rs)^\\vee$. The Cartan integers are those of the roots with r and s "
        "exchanged. Parallel and orthogonal pairs stay so.",
        "Computed up to rank 4: they are reduced and irreducible too.",
    )  # fmt: skip


@claim("fig-1", "Section 2.3, Figure 1", RESULT, to_state=["def-4", "def-14"], to_prove=["thm-2"])
def figure_1(printed: Constants) -> Finding:
    """There are {systems:words} root systems in the plane; the hyperplanes cut it into figures with
    {alcove_sides:words} sides."""
    pairs = {frozenset((a, b)) for a in range(-3, 0) for b in range(-3, 0) if a * b < 4}
    rank_2 = [s for s in systems(2) if s.rank == 2]
    found = {frozenset((int(s.cartan_matrix[0, 1]), int(s.cartan_matrix[1, 0]))) for s in rank_2}
    sides = {len(t.facets) for t in all_types(2)}
    return agree(
        printed, {"systems": len(pairs & found) if pairs == found else 0, "alcove_sides": max(sides)}, FINITE,
        "Two simple roots have negative Cartan integers with product 1, 2 or 3: $A_2$, $B_2$ (the same as "
        "$C_2$), $G_2$.",
        "In each the fundamental domain is the triangle between the walls of the simple roots and that of "
        "the highest root.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _dual_figures() -> bool:
    """Whether the drawings of the coroots are on the same lines, and show the dual root systems."""
    same = True
    for name, dual in (("A2", "A2"), ("B2", "C2"), ("G2", "")):
        above, below = root_system_plane(name).data, root_system_plane(name, dual=True).data
        same &= above.lines == below.lines and above.domain == below.domain and is_root_system(below.vectors)
        same &= set(below.vectors) == set(root_system(name).coroots.rows())
        same &= not dual or set(below.vectors) == set(root_system(dual).roots.rows())
    return same


@claim("fig-1.dual", "Section 2.3, Figure 1", RESULT, to_state=["def-10", "fig-1"])
def figure_1_dual(printed: Constants) -> Finding:
    """The dual root systems are drawn on the same hyperplanes."""
    return agree(
        printed, {"same_hyperplanes": _dual_figures()}, FINITE,
        "$A_2$ is its own dual, that of $B_2$ is $C_2$, that of $G_2$ is $G_2$ turned and scaled. "
        "Computed: the lines, and the arrows.",
    )  # fmt: skip


def _product_with_coroot(x: tuple[int, ...], r: tuple[int, ...]) -> Fraction:
    """<x, r^v>, from the reflection in r: x - σ(x) = <x, r^v>·r."""
    image = affine_reflection(r, 0, x)
    k = next(i for i, c in enumerate(r) if c)
    return (x[k] - image[k]) / r[k]


@claim("rem-2", "Section 2.3, Remark 2", WORDING, to_state=["def-7", "def-10"])
def remark_2(printed: Constants) -> Finding:
    """The Cartan integer n(r, s) of Definition 7 is the product of one of its arguments with the coroot of
    the other; the coroot is that of argument number {argument}."""
    r, s = (1, 0), (1, 1)
    with_coroot = [_product_with_coroot(s, r), _product_with_coroot(r, s)]  # of the first, of the second
    true = [number for number, value in enumerate(with_coroot, 1) if value == cartan_integer(r, s)]
    finding = agree(
        printed, {"argument": true[0]}, EVERY_D,
        "Definition 7 divides by the squared length of the second argument, so $n(r,s)=\\langle "
        "r,s^\\vee\\rangle$.",
    )  # fmt: skip
    why = "Remark 2 exchanges the arguments; with Definition 7 it is $n(s,r)=\\langle r^\\vee,s\\rangle$"
    witness = (
        f"In $B_2$, r = {show(r)} and s = {show(s)}: by Definition 7 n(r, s) is {cartan_integer(r, s)}, by "
        f"the remark it would be {with_coroot[0]}."
    )
    return explained(finding, why, witness=witness)


@claim("def-11", "Section 2.3, Definition 11", RESULT, to_state=["def-10", "def-9"])
def definition_11(printed: Constants) -> Finding:
    """The integer combinations of the coroots are a lattice of rank {basis}."""
    ranks = {
        s.rank: Fraction(coroot_lattice(s).rank)
        for s in systems(5)
        if all(r in coroot_lattice(s) for r in s.coroots.rows())
    }
    return agree(
        printed, {"basis": fits(printed["basis"], "d", ranks)}, EVERY_D,
        "The root lattice of the dual system, with the coroots of the simple roots as a basis. Computed up "
        "to rank 5.",
    )  # fmt: skip


def _in_span(system: RootSystem, x: tuple[Fraction, ...]) -> bool:
    try:
        system.coordinates(x)
    except InvalidInput:
        return False
    return True


@claim("def-12", "Section 2.3, Definition 12", WORDING, to_state=["def-9", "def-11"])
def definition_12(printed: Constants) -> Finding:
    """The points of {space} that have integer products with all coroots, or with all roots, are a lattice."""
    a1 = root_system("A1")
    outside = [point(1, 1), point(Fraction(1, 3), Fraction(1, 3))]
    integral = all(inner(x, r).denominator == 1 for x in outside for r in a1.coroots.rows())
    none = integral and not any(_in_span(a1, x) for x in outside)
    finding = agree(
        printed, {"space": "the span of R" if none else "R^d"}, EVERY_D,
        "In the span they are the dual lattices of the coroot lattice and of the root lattice. Outside it "
        "all multiples of a vector orthogonal to the span qualify.",
    )  # fmt: skip
    why = "The points must lie in the span of the roots; in the larger spaces of Theorem 3 this is no lattice"
    return explained(
        finding,
        why,
        witness="For $A_1$ = {±(1, -1)} in dimension 2 all (t, t), t real, have the product 0 with both.",
    )


@lru_cache(maxsize=1)
def _integral_sets() -> dict[str, str]:
    """Which vectors the weights, and the coweights, have integer products with, but not so all points of
    the other."""
    found: dict[str, set[str]] = {"weights": {"roots", "coroots"}, "coweights": {"roots", "coroots"}}
    for s in systems(5):
        for name, lattice in (("weights", weight_lattice(s)), ("coweights", coweight_lattice(s))):
            for what, vectors in (("roots", s.roots), ("coroots", s.coroots)):
                if (lattice.basis @ vectors.T).denominator != 1 and not _is_whole(lattice.basis @ vectors.T):
                    found[name].discard(what)
    return {name: values.pop() if len(values) == 1 else "neither" for name, values in found.items()}


def _is_whole(matrix: RationalMatrix) -> bool:
    return not (matrix.numerators.astype(object) % matrix.denominator).any()


@claim("def-12.weights", "Section 2.3, Definition 12", WORDING, to_state=["def-12"])
def weights(printed: Constants) -> Finding:
    """Weights are the points with integer products with all {weights}, coweights those with all
    {coweights}."""
    return agree(
        printed, _integral_sets(), EVERY_D,
        "A definition; the two lattices are dual to the coroot lattice and the root lattice. Computed up "
        "to rank 5: in each case the other set of vectors would not do.",
    )  # fmt: skip


@claim("sec2.coweights", "Section 2.3, after Definition 12", RESULT, to_state=["def-12"])
def coweights_are_vertices(printed: Constants) -> Finding:
    """The coweights have to do with the vertices of the Coxeter triangulation: all of them are vertices."""
    true = all(t.is_vertex(w) for t in all_types(5) for w in t.roots.fundamental_coweights.rows())
    return agree(
        printed, {"vertices": true}, EVERY_D,
        "A coweight has integer products with all roots, so a hyperplane of each family passes through it. "
        "Conversely the vertices of the alcove are 0 and the fundamental coweights over the marks. "
        "Computed up to d = 5.",
    )  # fmt: skip
