"""Section 2.2: root systems, simple roots, the table of angles, Coxeter diagrams."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np

from ..affine import affine_reflection, triangulation
from ..exact import RationalMatrix, Surd, show, sqrt
from ..names import triangulations_up_to
from ..root_sets import (
    AnglePair,
    angle_table,
    cartan_integer,
    is_crystallographic,
    is_irreducible,
    is_reduced,
    is_root_system,
)
from ..roots import RootSystem, root_system
from .claim import Constants, Finding, agree, claim, damaged, repaired, same
from .section_1 import explained, fits, quoted
from .section_2 import is_stable, systems
from .vocabulary import EVERY_D, FINITE, LITERATURE, Verdict, Weight

RESULT, PROOF, WORDING = Weight.RESULT, Weight.PROOF, Weight.WORDING
CROSS = ((1, 0), (-1, 0), (0, 5), (0, -5))
"""Two orthogonal lines of roots of different length: reducible."""


# -- reflections and root systems -------------------------------------------------------------------------


@claim("sec2.reflection", "Section 2.2", RESULT)
def reflection(printed: Constants) -> Finding:
    """The reflection in the hyperplane orthogonal to r takes from x the product of x and r over that of r
    with itself, times {factor}, times r."""
    r = (1, 2)
    image = affine_reflection(r, 0, r)
    true = {f for f in range(-4, 5) if tuple((1 - f) * x for x in r) == image}
    return agree(
        printed, {"factor": true.pop()}, EVERY_D,
        "With the factor f the image of r is (1 - f)r, which is to be -r; vectors orthogonal to r stay "
        "where they are.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _ambient() -> tuple[tuple[str, int, int], ...]:
    """Type, rank and number of coordinates, where these differ, for the roots of Theorem 3."""
    return tuple(
        (s.name, s.simple_roots.rank(), s.simple_roots.shape[1])
        for s in systems(8)
        if s.simple_roots.rank() != s.simple_roots.shape[1]
    )


def _in_the_span(printed: Constants, name: str, what: str, *derivation: str) -> Finding:
    """A statement that is made of R^d, and true of the span of the roots."""
    witness, rank, space = _ambient()[0]
    finding = agree(printed, {name: "the span of R" if _ambient() else "R^d"}, EVERY_D, *derivation)
    if finding.verdict is Verdict.HOLDS:
        return finding
    others = ", ".join(f"{n} in dimension {m}" for n, _, m in _ambient() if n in ("A2", "E6", "E7", "G2"))
    why = (
        f"{what} not of the space in which Theorem 3 gives the roots of all $A_d$, of $E_6$, $E_7$ and $G_2$"
    )
    found = f"{witness} = {{±(1, -1)}} has rank {rank} in dimension {space}; likewise {others}."
    return replace(explained(finding, why), witness=found)


@claim("def-4", "Section 2.2, Definition 4", WORDING, to_state=["sec2.reflection"])
def root_systems(printed: Constants) -> Finding:
    """A root system does not contain 0, and contains a basis of this space: {spanned}."""
    return _in_the_span(
        printed, "spanned", "It contains a basis of its own span,",
        "Lemma 2, Definitions 9 and 12, Proposition 5 and Corollary 1 are to be read in the same way.",
    )  # fmt: skip


@claim("def-4.closed", "Section 2.2, Definition 4", WORDING, to_state=["sec2.reflection"])
def closed_under_reflections(printed: Constants) -> Finding:
    """The reflection in each root of a root system maps the system to itself."""
    true = all(map(is_stable, systems(8))) and not is_root_system([(1, 0), (0, 1)])
    return agree(
        printed, {"closed": true}, EVERY_D,
        "A definition. It is true of all roots that the simple roots of Theorem 3 generate, up to rank 8, "
        "but not of every set.",
    )  # fmt: skip


@claim("def-4.crystallographic", "Section 2.2, Definition 4", WORDING, to_state=["def-4.closed"])
def crystallographic(printed: Constants) -> Finding:
    """In a crystallographic root system a reflection moves each root by a whole multiple of the root that
    it belongs to."""
    odd = [(3, 0), (-3, 0), (0, 3), (0, -3), (1, 1), (-1, -1), (1, -1), (-1, 1)]
    true = all(is_crystallographic(s.roots) for s in systems(8)) and not is_crystallographic(odd)
    return agree(
        printed, {"whole_multiples": true and is_root_system(odd)}, EVERY_D,
        "A definition. All types of Theorem 3 have the property (computed up to rank 8). Not every root "
        "system has it: the four vectors ±3e_1, ±3e_2 with the four ±e_1±e_2 have not.",
    )  # fmt: skip


@claim("def-4.reduced", "Section 2.2, Definition 4", WORDING, to_state=["def-4.closed"])
def reduced(printed: Constants) -> Finding:
    """In a reduced root system the multiples of a root that are roots are those by {multiples}."""
    true = sorted({m for s in systems(6) for m in _multiples(s)})
    doubles = [(1,), (-1,), (2,), (-2,)]
    if not all(is_reduced(s.roots) for s in systems(8)) or is_reduced(doubles):
        true = []
    return agree(
        printed, {"multiples": tuple(true)}, EVERY_D,
        "A definition. All types of Theorem 3 have the property (computed up to rank 8). Not every root "
        "system has it: ±1, ±2 on the line have not.",
    )  # fmt: skip


def _multiples(system: RootSystem) -> set[int]:
    """The factors between parallel roots."""
    n = system.roots.numerators
    products = n @ n.T
    squares = products.diagonal()
    rows, columns = np.nonzero(products**2 == np.outer(squares, squares))
    return {int(products[i, j] // squares[i]) for i, j in zip(rows, columns, strict=True)}


@claim("def-4.irreducible", "Section 2.2, Definition 4", WORDING, to_state=["def-4.closed"])
def irreducible(printed: Constants) -> Finding:
    """An irreducible root system is no union of two orthogonal parts."""
    true = all(is_irreducible(s.roots) for s in systems(6)) and not is_irreducible(CROSS)
    return agree(
        printed, {"irreducible": true}, EVERY_D,
        "A definition. All types of Theorem 3 have the property, as their diagrams are connected. Two "
        "orthogonal lines of roots have not.",
    )  # fmt: skip


# -- simple roots -----------------------------------------------------------------------------------------


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
    """A positive root is simple if it is no sum of {summands} positive roots."""
    true = min(n for n in range(1, 4) if _leaves_simple_roots(n))
    return agree(
        printed, {"summands": true}, EVERY_D,
        "A definition. For A1, A3, B3, C3, D4, G2 it gives back the simple roots of Theorem 3, which "
        "neither sums of one nor of three positive roots would.",
    )  # fmt: skip


@claim("def-5.halves", "Section 2.2, Definition 5", WORDING, to_state=["def-4"])
def halves(printed: Constants) -> Finding:
    """A vector that is orthogonal to no root splits the roots into {parts} parts, the positive and the
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
def _simple_sets() -> bool:
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
    reflections = []
    for i in range(system.rank):
        m = np.eye(system.rank, dtype=np.int64)
        m[:, i] -= system.cartan_matrix[:, i]
        reflections.append(m)
    fresh = [np.eye(system.rank, dtype=np.int64)]
    seen = {fresh[0].tobytes(): fresh[0]}
    while fresh:
        images = {m.tobytes(): m for x in fresh for g in reflections for m in [x @ g]}
        fresh = [m for key, m in images.items() if key not in seen]
        seen |= images
    return {frozenset(tuple(int(x) for x in row) for row in m) for m in seen.values()}


@claim("lem-1", "Section 2.2, Lemma 1", RESULT, to_state=["def-5"])
def lemma_1(printed: Constants) -> Finding:
    """For any two sets of simple roots just one element of the Weyl group carries one to the other."""
    return quoted(
        agree(printed, {"simply_transitive": _simple_sets()}, LITERATURE),
        "Humphreys, Section 1.8.",
        "For A1, A2, A3, B2, B3, C3, D4, G2 the images of one set under all group elements are all "
        "different, and as many as there are chambers. Up to rank 8 there are as many chambers as group "
        "elements.",
    )


@claim("sec2.similar-simple-sets", "Section 2.2", RESULT, to_state=["def-5"], to_prove=["lem-1"])
def similar_simple_sets(printed: Constants) -> Finding:
    """All sets of simple roots of a root system are similar."""
    return agree(
        printed, {"similar": _simple_sets()}, EVERY_D,
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
    """The simple roots are a basis of this space: {basis_of}."""
    return _in_the_span(
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
    """Every root is a sum of simple roots with integer coefficients."""
    true = all(c.denominator == 1 for s in systems(4) for r in s.roots.rows() for c in s.coordinates(r))
    return agree(
        printed, {"integers": true}, EVERY_D,
        "A positive root is simple, or a sum of two whose products with t are smaller; there are finitely "
        "many. (That the simple roots are a basis would not be enough.) Computed up to rank 4.",
    )  # fmt: skip


@claim("def-6.signs", "Section 2.2, Definition 6", RESULT, to_state=["def-5", "def-6.integers"])
def signs_of_coefficients(printed: Constants) -> Finding:
    """Positive are just the roots with coefficients of at least {least_coefficient}."""
    least = min(int(s.positive_root_coordinates.min()) for s in systems(8))
    both = {(c > 0) - (c < 0) for s in systems(4) for r in s.roots.rows() for c in s.coordinates(r)}
    return agree(
        printed, {"least_coefficient": least if both == {-1, 0, 1} else None}, EVERY_D,
        "As for the integers. The coefficients of a negative root are the opposite ones. Computed up to "
        "rank 8.",
    )  # fmt: skip


@claim("def-6.order", "Section 2.2, Definition 6", WORDING, to_state=["def-6.integers"])
def partial_order(printed: Constants) -> Finding:
    """Comparing all coefficients gives a partial order of the roots."""
    return agree(
        printed, {"partial_order": all(map(_is_partial_order, ("A2", "B3", "G2")))}, EVERY_D,
        "It is the order of $\\mathbb Z^d$ by coordinates: reflexive, transitive, antisymmetric. It is not "
        "total, as two simple roots cannot be compared. Computed for A2, B3, G2.",
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


# -- Cartan integers --------------------------------------------------------------------------------------


@claim("sec2.sign", "Section 2.2, before Definition 7", WORDING, to_state=["sec2.reflection"])
def sign_of_difference(printed: Constants) -> Finding:
    """The reflection in r moves s by r, times the product of r and s over that of r with itself, times
    {factor}."""
    r, s = (1, 0), (1, 1)
    moved = affine_reflection(r, 0, s)[0] - s[0]
    finding = agree(
        printed, {"factor": int(moved)}, EVERY_D,
        "$\\sigma_r(s)-s=-2\\frac{\\langle r,s\\rangle}{\\langle r,r\\rangle}r$, by the formula for "
        "$\\sigma_r$ that is printed before Definition 4.",
        f"For r = {show(r)}, s = {show(s)} in $B_2$ the image of s is {show(affine_reflection(r, 0, s))}.",
    )  # fmt: skip
    return explained(finding, "A sign is missing: it is minus n(s, r) times r. Nothing depends on it")


@lru_cache(maxsize=1)
def _whole_cartan_integers() -> bool:
    return all(is_crystallographic(s.roots) for s in systems(8))


@claim("def-7", "Section 2.2, Definition 7", RESULT, to_state=["def-4.crystallographic"])
def cartan_integers(printed: Constants) -> Finding:
    """The Cartan integer n(s, r) is the product of r and s, times {factor}, over that of r with itself; it
    is an integer."""
    r, s = (1, 1), (0, 1)
    product_, square = sum(a * b for a, b in zip(r, s, strict=True)), sum(a * a for a in r)
    factor = cartan_integer(s, r) * square / product_
    return agree(
        printed, {"factor": int(factor), "integers": _whole_cartan_integers()}, EVERY_D,
        "$s-\\sigma_r(s)=n(s,r)\\,r$, which is what crystallographic means. Computed up to rank 8.",
    )  # fmt: skip


@claim("sec2.product", "Section 2.2, after Definition 7", RESULT, to_state=["def-7"])
def product_of_cartan_integers(printed: Constants) -> Finding:
    """The square of the cosine of the angle between r and s, times {factor}, is n(s, r) n(r, s)."""
    true = {
        cartan_integer(s, r) * cartan_integer(r, s) / _squared_cosine(r, s)
        for r, s in product(root_system("G2").roots.rows(), repeat=2)
        if _squared_cosine(r, s)
    }
    return agree(
        printed, {"factor": int(true.pop())}, EVERY_D,
        "$n(s,r)\\,n(r,s)=\\frac{2\\langle r,s\\rangle}{\\langle r,r\\rangle}\\cdot\\frac{2\\langle "
        "r,s\\rangle}{\\langle s,s\\rangle}$.",
    )  # fmt: skip


def _squared_cosine(r: tuple[Fraction, ...], s: tuple[Fraction, ...]) -> Fraction:
    rs, rr, ss = (sum(a * b for a, b in zip(x, y, strict=True)) for x, y in ((r, s), (r, r), (s, s)))
    return Fraction(rs) ** 2 / (rr * ss)


@claim("sec2.norms", "Section 2.2, after Definition 7", RESULT, to_state=["def-7"])
def ratio_of_norms(printed: Constants) -> Finding:
    """If r and s are not orthogonal, the length of s over that of r, to the power {power}, is n(s, r) over
    n(r, s)."""
    r, s = root_system("G2").simple_roots.rows()
    ratio = sqrt(sum(x * x for x in s) / sum(x * x for x in r))
    true = {p for p in range(1, 5) if ratio**p == cartan_integer(s, r) / cartan_integer(r, s)}
    return agree(
        printed, {"power": true.pop()}, EVERY_D,
        "Both integers have the numerator $2\\langle r,s\\rangle$; the denominators are the squared lengths.",
    )  # fmt: skip


# -- the table of angles ----------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _angle_rows() -> tuple[AnglePair, ...]:
    """The rows of the table, computed from the roots of rank 2."""
    rows = {row for name in ("A2", "B2", "G2") for row in angle_table(root_system(name).roots)}
    return tuple(sorted(rows, key=lambda row: (-row.product, -row.n_sr)))


def _as_constants(row: AnglePair) -> dict[str, Any]:
    ratio = "undetermined" if row.ratio is None else str(row.ratio)
    return {
        "product": row.product,
        "n_sr": row.n_sr,
        "n_rs": row.n_rs,
        "angle": str(row.angle),
        "ratio": ratio,
    }


def angle_row(number: int, printed: Constants) -> Finding:
    """Judge a row of the table: an entry n(r, s) that belongs to the next row has moved up in our copy."""
    rows = [_as_constants(row) for row in _angle_rows()]
    true = rows[number - 1]
    finding = agree(printed, true, FINITE, "Computed from the roots of $A_2$, $B_2$ and $G_2$.")
    wrong = [name for name in true if not same(printed.get(name), true[name])]
    below = rows[number]["n_rs"] if number < len(rows) else ""
    if wrong != ["n_rs"] or not same(printed.get("n_rs"), below):
        return finding
    here = (
        "The entry has moved to the row above" if below == "" else "What stands here belongs to the next row"
    )
    return damaged(
        FINITE, finding.correction,
        f"{here}: the column lost one entry, and those below it moved up. With the printed ones the "
        "products of the two integers would not be $4\\cos^2\\varphi$.",
        constants=finding.constants, derivation=finding.derivation,
    )  # fmt: skip


def _row_check(number: int) -> Callable[[Constants], Finding]:
    def check(printed: Constants) -> Finding:
        return angle_row(number, printed)

    check.__name__ = "angle_row"
    check.__doc__ = (
        "Two roots with $4\\cos^2\\varphi$ = {product} have n(s, r) = {n_sr} and n(r, s) = {n_rs}, the "
        "angle {angle} times π, and the quotient of lengths |s|/|r| is {ratio}."
    )
    return check


for _number in range(1, 10):
    _place = f"Section 2.2, table of angles, row {_number}"
    claim(f"tab-angles.{_number}", _place, RESULT, to_state=["def-7"], to_prove=["sec2.product"])(
        _row_check(_number)
    )


@claim("tab-angles.column", "Section 2.2, table of angles", WORDING, to_state=["def-7"])
def angle_column(printed: Constants) -> Finding:
    """The column n(r, s) reads {n_rs}."""
    true = tuple(row.n_rs for row in _angle_rows())
    finding = agree(printed, {"n_rs": true}, FINITE)
    lost = [i for i in range(len(true)) if same(printed["n_rs"], true[:i] + true[i + 1 :])]
    if not lost:
        return finding
    return damaged(
        FINITE, finding.correction,
        f"With the entry {true[lost[0]]} put in as number {lost[0] + 1} the printed column is the computed "
        "one: one entry was lost, and those below it moved up by a row. The other columns are right.",
        constants=finding.constants,
    )  # fmt: skip


@claim(
    "tab-angles.complete",
    "Section 2.2, table of angles",
    RESULT,
    to_state=["def-7"],
    to_prove=["sec2.product"],
)
def table_is_complete(printed: Constants) -> Finding:
    """Up to symmetry there are {rows} cases for two roots."""
    integers = [(a, b) for a in range(-4, 5) for b in range(-4, 5) if 0 <= a * b <= 4 and abs(a) >= abs(b)]
    possible = {(a, b) for a, b in integers if bool(a) == bool(b) and (a * b < 4 or a == b)}
    occurring = {(row.n_sr, row.n_rs) for row in _angle_rows()}
    return agree(
        printed, {"rows": len(occurring) if occurring == possible else 0}, FINITE,
        "Two integers with a product from 0 to 4, both zero or neither, with |n(s, r)| ≥ |n(r, s)|. The "
        "product 4 belongs to parallel roots, which are equal or opposite in a reduced system; that "
        "excludes (4, 1) and (-4, -1).",
        "All nine occur in $A_2$, $B_2$, $G_2$.",
    )  # fmt: skip


# -- lengths and angles -----------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _ratios() -> tuple[Surd, ...]:
    """The quotients of lengths, of at least 1, in all types up to rank 8."""
    squares = [set(s.squared_lengths) for s in systems(8)]
    return tuple(sorted({sqrt(max(x) / min(x)) for x in squares} | {Surd(1)}))


@claim(
    "sec2.length-ratios",
    "Section 2.2",
    PROOF,
    to_state=["def-4.irreducible"],
    to_prove=["tab-angles.complete"],
)
def length_ratios(printed: Constants) -> Finding:
    """The quotient of the lengths of any two roots is among {ratios}, as is seen in the table."""
    true = tuple(map(str, _ratios()))
    finding = agree(printed, {"ratios": true}, EVERY_D)
    tests = [is_root_system(CROSS), is_crystallographic(CROSS), is_reduced(CROSS), not is_irreducible(CROSS)]
    if finding.verdict is not Verdict.HOLDS or not all(tests):
        return finding
    return repaired(
        EVERY_D,
        "The images of s under the group span a subspace that the group maps to itself; in an irreducible "
        "system it is the whole span. So some image of s is not orthogonal to r. It has the length of s, "
        "and its row of the table gives the quotient.",
        "For orthogonal roots the table leaves the quotient open. {±(1, 0), ±(0, 5)} is crystallographic "
        "and reduced, and all its pairs are in the table, but there the quotient is 5: that it is "
        "reducible must be used.",
        derivation=(f"Computed up to rank 8: {', '.join(true)}, all of them attained.",),
    )


@claim("sec2.two-lengths", "Section 2.2, with footnote 1", RESULT, to_prove=["sec2.length-ratios"])
def two_lengths(printed: Constants) -> Finding:
    """There are at most {lengths} lengths of roots, as three would have a quotient such as {excluded}."""
    ratios = _ratios()
    most = max(len(set(s.squared_lengths)) for s in systems(8))
    excluded = tuple(str(x) for x in (ratios[-1] * ratios[-2], ratios[-1] / ratios[-2]) if x not in ratios)
    return agree(
        printed, {"lengths": most, "excluded": excluded}, EVERY_D,
        "Let a < b < c be lengths. The quotients b/a and c/b are $\\sqrt2$ or $\\sqrt3$, so c/a is 2, "
        "$\\sqrt6$ or 3, which is no quotient of lengths. The footnote names the mixed case only; the "
        "others are as quick.",
        "Computed up to rank 8.",
    )  # fmt: skip


_SIMPLE = "two different simple roots"


def _of_simple_roots(printed: Constants, name: str, true: tuple[object, ...], more: str) -> Finding:
    """A list that is printed without saying that it is about simple roots."""
    finding = agree(printed, {name: true, "of": _SIMPLE}, EVERY_D, "By Lemma 2, and the table.", more)
    if finding.verdict is Verdict.HOLDS:
        return finding
    r, s = (1, 0), (1, 1)
    return explained(
        finding,
        "The sentence lost its hypothesis: of any two roots it is false, as n(r, s) = "
        f"{cartan_integer(r, s)} for r = {show(r)} and s = {show(s)} in $B_2$, at an angle of 45 degrees",
    )


@lru_cache(maxsize=1)
def _simple_pairs() -> frozenset[tuple[int, int]]:
    """The Cartan integers of two different simple roots, in both orders, all types up to rank 8."""
    found = set()
    for s in systems(8):
        c = s.cartan_matrix
        found |= {(int(c[i, j]), int(c[j, i])) for i, j in product(range(s.rank), repeat=2) if i != j}
    return frozenset(found)


@claim("sec2.simple-integers", "Section 2.2", WORDING, to_state=["def-7"], to_prove=["lem-2.obtuse"])
def cartan_integers_of_simple_roots(printed: Constants) -> Finding:
    """The Cartan integers of {of} are among {values}."""
    true = tuple(sorted({n for n, _ in _simple_pairs()}))
    return _of_simple_roots(printed, "values", true, "All of them occur; computed up to rank 8.")


@claim("sec2.simple-angles", "Section 2.2", WORDING, to_state=["def-7"], to_prove=["sec2.simple-integers"])
def angles_of_simple_roots(printed: Constants) -> Finding:
    """The angle of {of} is among {angles}, times π."""
    by_integers = {row.n_sr * row.n_rs: row.angle for row in _angle_rows() if row.n_sr <= 0}
    true = tuple(str(x) for x in sorted({by_integers[a * b] for a, b in _simple_pairs()}))
    return _of_simple_roots(printed, "angles", true, "All of them occur; computed up to rank 8.")


@claim("sec2.same-angles", "Section 2.2", RESULT, to_prove=["lem-1"])
def same_angles(printed: Constants) -> Finding:
    """All sets of simple roots have the same angles."""
    return agree(printed, {"same": _simple_sets()}, EVERY_D, "By Lemma 1 they are congruent.")


# -- Coxeter diagrams -------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _labels() -> tuple[int, ...]:
    """The labels of pairs of simple roots that are not orthogonal, all types up to rank 8."""
    angles = {a for t in triangulations_up_to(8) for a in triangulation(t).dihedral_angles().values()}
    return tuple(sorted(int(1 / angle) for angle in angles if angle.denominator != 2))


@claim("def-8", "Section 2.2, Definition 8", WORDING, to_state=["sec2.simple-angles", "sec2.same-angles"])
def coxeter_diagram(printed: Constants) -> Finding:
    """Two simple roots that are not orthogonal are joined by an edge with a label among {labels}."""
    finding = agree(
        printed, {"labels": _labels()}, FINITE,
        "$4\\cos^2\\frac\\pi m$ is 0, 1, 2, 3 for m = 2, 3, 4, 6. The label 2 belongs to orthogonal roots, "
        "which are not joined.",
    )  # fmt: skip
    return explained(finding, "The label 2 is never given: it belongs to orthogonal roots")


@claim("def-8.conventions", "Section 2.2, after Definition 8", WORDING, to_state=["def-8"])
def conventions(printed: Constants) -> Finding:
    """An edge with the label {not_drawn} is not drawn, and the label {not_written} is not written."""
    by_product = {0: 2, 1: 3, 2: 4, 3: 6}
    labels = [by_product[a * b] for a, b in (pair for s in systems(8, "ADE") for pair in _pairs(s))]
    true = {"not_drawn": min(labels), "not_written": max(labels)}
    return agree(
        printed, true, EVERY_D,
        "So the diagrams without labels are the graphs of Section 2.1: for $A_d,D_d,E_d$ all labels are 2 "
        "or 3. Computed up to rank 8.",
    )  # fmt: skip


def _pairs(system: RootSystem) -> list[tuple[int, int]]:
    c = system.cartan_matrix
    return [(int(c[i, j]), int(c[j, i])) for i in range(system.rank) for j in range(i)]
