"""Section 2.2: simple roots."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import product

import numpy as np

from ..exact import RationalMatrix
from ..roots import RootSystem, root_system
from .claim import Constants, Finding, agree, claim, repaired
from .instances import systems
from .section_2_groups import generated, is_stable, simple_reflections
from .section_2_roots import in_the_span
from .vocabulary import EVERY_D, LITERATURE, Weight
from .wording import fits, quoted

RESULT, WORDING = Weight.RESULT, Weight.WORDING


def _sums(system: RootSystem, summands: int) -> set[tuple[int, ...]]:
    """The sums of so many positive roots, in coordinates with respect to the simple roots."""
    positive = system.positive_root_coordinates
    sums = {(0,) * system.rank}
    for _ in range(summands):
        sums = {tuple(int(x) for x in np.add(a, b)) for a in sums for b in positive}
    return sums


@lru_cache(maxsize=8)
def _leaves_simple_roots(summands: int) -> bool:
    """Whether the positive roots that are no such sums are the simple roots of Theorem 3."""
    for name in ("A1", "A3", "B3", "C3", "D4", "G2"):
        system = root_system(name)
        rows = {tuple(int(x) for x in row) for row in system.positive_root_coordinates}
        unit = {tuple(int(i == j) for j in range(system.rank)) for i in range(system.rank)}
        if summands < 1 or rows - _sums(system, summands) != unit:
            return False
    return True


@claim("def-5", "Section 2.2, Definition 5", WORDING, to_state=["def-5.halves"])
def simple_roots(printed: Constants) -> Finding:
    """A positive root is simple if it is no sum of {summands:words} positive roots."""
    true = min(n for n in range(1, 4) if _leaves_simple_roots(n))
    return agree(
        printed, {"summands": true}, EVERY_D,
        "A definition. For A1, A3, B3, C3, D4, G2 it gives back the simple roots of Theorem 3, which "
        "neither sums of one nor of three positive roots would.",
    )  # fmt: skip


@claim("def-5.halves", "Section 2.2, Definition 5", WORDING, to_state=["def-4"])
def halves(printed: Constants) -> Finding:
    """A vector that is orthogonal to no root splits the roots into {parts:words} parts, the positive and the
    negative ones."""
    signs = set()
    for s in systems(6):
        t = [sum(w) + 0 for w in zip(*s.fundamental_coweights.rows(), strict=True)]
        products = (s.roots @ RationalMatrix.from_rows([[x] for x in t])).numerators[:, 0]
        signs |= {int(x) for x in np.sign(products)}
    return agree(
        printed, {"parts": len(signs)}, EVERY_D,
        "The sign of the product with the vector; each part is the negative of the other. Computed with "
        "the sum of the fundamental coweights, up to rank 6.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def simple_sets() -> bool:
    """Whether there are as many sets of simple roots, and chambers, as group elements."""
    for name in ("A1", "A2", "A3", "B2", "B3", "C3", "D4", "G2"):
        system = root_system(name)
        order = system.weyl_group_order
        chambers = int(np.prod([1 + e for e in system.exponents()]))
        if not (len(_images_of_simple_roots(system)) == chambers == order):
            return False
    return all(
        s.weyl_group_order == np.prod([1 + e for e in s.exponents()], dtype=object) for s in systems(8)
    )


def _images_of_simple_roots(system: RootSystem) -> set[frozenset[tuple[int, ...]]]:
    """All images of the set of simple roots under the group, in coordinates with respect to the simple
    roots."""
    group = generated(simple_reflections(system.cartan_matrix.T))
    return {frozenset(tuple(int(x) for x in column) for column in m.T) for m in group}


@claim("lem-1", "Section 2.2, Lemma 1", RESULT, to_state=["def-5"])
def lemma_1(printed: Constants) -> Finding:
    """For any two sets of simple roots exactly one element of the Weyl group carries one to the other."""
    return quoted(
        agree(printed, {"simply_transitive": simple_sets()}, LITERATURE),
        "Humphreys, Section 1.8.",
        "For A1, A2, A3, B2, B3, C3, D4, G2 the images of one set under all group elements are all "
        "different, and as many as there are chambers. Up to rank 8 there are as many chambers as group "
        "elements.",
    )


@claim("sec2.similar-simple-sets", "Section 2.2", RESULT, to_state=["def-5"], to_prove=["lem-1"])
def similar_simple_sets(printed: Constants) -> Finding:
    """All sets of simple roots of a root system are similar."""
    return agree(
        printed, {"similar": simple_sets()}, EVERY_D,
        "They are even congruent: by Lemma 1 each is the image of the other under a product of reflections.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _products_of_simple_roots() -> frozenset[Fraction]:
    """The inner products of two different simple roots, all types up to rank 8."""
    grams = [(s.rank, s.simple_roots @ s.simple_roots.T) for s in systems(8)]
    return frozenset(g[i, j] for d, g in grams for i in range(d) for j in range(i))


@claim("lem-2.obtuse", "Section 2.2, Lemma 2", RESULT, to_state=["def-5"])
def simple_roots_are_obtuse(printed: Constants) -> Finding:
    """The inner product of two different simple roots is at most {greatest_product}."""
    return agree(
        printed, {"greatest_product": int(max(_products_of_simple_roots()))}, EVERY_D,
        "If $\\langle r,s\\rangle>0$ then n(r, s) or n(s, r) is 1, since their product is less than 4; so "
        "r - s is a root. If it is positive, r = (r - s) + s is no simple root, else s = (s - r) + r is "
        "none.",
        "The bound is attained. Computed up to rank 8.",
    )  # fmt: skip


@claim("lem-2.basis", "Section 2.2, Lemma 2", WORDING, to_state=["def-4", "def-5"])
def simple_roots_are_a_basis(printed: Constants) -> Finding:
    """The simple roots are a basis of {basis_of}."""
    return in_the_span(
        printed, "basis_of", "They are a basis of the span of the roots,",
        "Vectors on one side of a hyperplane with products ≤ 0 are linearly independent (Humphreys, "
        "Section 1.3), and each positive root is simple or a sum of two with a smaller product with t.",
    )  # fmt: skip


@claim("lem-2.generated", "Section 2.2, Lemma 2", RESULT, to_state=["def-5"])
def generated_by_simple_reflections(printed: Constants) -> Finding:
    """The Weyl group is generated by the reflections in the simple roots, {reflections} of them."""
    ranks = {s.rank: Fraction(len(s.simple_roots.rows())) for s in systems(8) if is_stable(s)}
    return quoted(
        agree(printed, {"reflections": fits(printed["reflections"], "d", ranks)}, LITERATURE),
        "Humphreys, Section 1.5.",
        "Up to rank 8 all roots are images of simple ones under products of simple reflections, so that "
        "their reflections are such products too.",
    )


@claim("def-6.integers", "Section 2.2, Definition 6", RESULT, to_state=["def-5"])
def whole_coefficients(printed: Constants) -> Finding:
    """As the simple roots are a basis, every root is a sum of them with integer coefficients."""
    true = all(c.denominator == 1 for s in systems(4) for r in s.roots.rows() for c in s.coordinates(r))
    finding = agree(printed, {"integers": true}, EVERY_D)
    if not finding.verdict.accepts:
        return finding
    return repaired(
        EVERY_D,
        "a positive root is simple, or a sum of two positive roots whose products with t are smaller; "
        "there are finitely many, so it is a sum of simple roots",
        "that they are a basis gives real coefficients only: (1, 0) and (1, 2) are a basis of the plane, and "
        "(1, 1) is half their sum",
        derivation=("Computed up to rank 4: all coefficients are integers.",),
    )


@claim("def-6.signs", "Section 2.2, Definition 6", RESULT, to_state=["def-5", "def-6.integers"])
def signs_of_coefficients(printed: Constants) -> Finding:
    """The positive roots are exactly those all of whose coefficients are at least {least_coefficient}."""
    least = min(int(s.positive_root_coordinates.min()) for s in systems(8))
    both = {(c > 0) - (c < 0) for s in systems(4) for r in s.roots.rows() for c in s.coordinates(r)}
    return agree(
        printed, {"least_coefficient": least if both == {-1, 0, 1} else None}, EVERY_D,
        "As for the integers. The coefficients of a negative root are the opposite ones. Computed up to "
        "rank 8.",
    )  # fmt: skip


def _is_partial_order(name: str) -> bool:
    system = root_system(name)
    below = {(r, s): system.precedes(r, s) for r, s in product(system.positive_roots.rows(), repeat=2)}
    roots = system.positive_roots.rows()
    reflexive = all(below[r, r] for r in roots)
    antisymmetric = not any(below[r, s] and below[s, r] for r in roots for s in roots if r != s)
    transitive = all(below[r, t] or not (below[r, s] and below[s, t]) for r, s, t in product(roots, repeat=3))
    total = all(below[r, s] or below[s, r] for r in roots for s in roots)
    return reflexive and antisymmetric and transitive and not total


@claim("def-6.order", "Section 2.2, Definition 6", WORDING, to_state=["def-6.integers"])
def partial_order(printed: Constants) -> Finding:
    """Comparing all coefficients gives a partial order of the roots."""
    return agree(
        printed, {"partial_order": all(map(_is_partial_order, ("A2", "B3", "G2")))}, EVERY_D,
        "It is the order of $\\mathbb Z^d$ by coordinates: reflexive, transitive, antisymmetric. It is not "
        "total, as two simple roots cannot be compared. Computed for A2, B3, G2.",
    )  # fmt: skip
