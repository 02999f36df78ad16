"""Section 2.2: Cartan integers, and the table of the angles of two roots."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache, partial
from itertools import product
from typing import Any

from ..affine import affine_reflection
from ..exact import show, sqrt
from ..root_sets import AnglePair, angle_table, cartan_integer, is_crystallographic
from ..roots import root_system
from .claim import Constants, Finding, agree, claim, damaged, same
from .instances import systems
from .vectors import inner, point
from .vocabulary import EVERY_D, FINITE, Weight
from .wording import explained

RESULT, WORDING = Weight.RESULT, Weight.WORDING


# -- Cartan integers --------------------------------------------------------------------------------------


@claim("sec2.sign", "Section 2.2, before Definition 7", WORDING, to_state=["sec2.reflection"])
def sign_of_difference(printed: Constants) -> Finding:
    """The reflection in r adds to s the root r, multiplied by {factor} and by the product of r and s over
    that of r with itself."""
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
    r, s = point(1, 1), point(0, 1)
    factor = cartan_integer(s, r) * inner(r, r) / inner(r, s)
    return agree(
        printed, {"factor": int(factor), "integers": _whole_cartan_integers()}, EVERY_D,
        "$s-\\sigma_r(s)=n(s,r)\\,r$, which is what crystallographic means. Computed up to rank 8.",
    )  # fmt: skip


def _squared_cosine(r: tuple[Fraction, ...], s: tuple[Fraction, ...]) -> Fraction:
    return inner(r, s) ** 2 / (inner(r, r) * inner(s, s))


@claim("sec2.product", "Section 2.2, after Definition 7", RESULT, to_state=["def-7"])
def product_of_cartan_integers(printed: Constants) -> Finding:
    """For the angle $\\varphi$ between r and s, {factor} times $\\cos^2\\varphi$ is n(s, r) n(r, s)."""
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


@claim("sec2.norms", "Section 2.2, after Definition 7", RESULT, to_state=["def-7"])
def ratio_of_norms(printed: Constants) -> Finding:
    """If r and s are not orthogonal, the length of s over that of r, to the power {power}, is n(s, r) over
    n(r, s)."""
    r, s = root_system("G2").simple_roots.rows()
    ratio = sqrt(inner(s, s) / inner(r, r))
    true = {p for p in range(1, 5) if ratio**p == cartan_integer(s, r) / cartan_integer(r, s)}
    return agree(
        printed, {"power": true.pop()}, EVERY_D,
        "Both integers have the numerator $2\\langle r,s\\rangle$; the denominators are the squared lengths.",
    )  # fmt: skip


# -- the table of angles ----------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def angle_rows() -> tuple[AnglePair, ...]:
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
    rows = [_as_constants(row) for row in angle_rows()]
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


for _number in range(1, 10):
    claim(
        f"tab-angles.{_number}",
        f"Section 2.2, table of angles, row {_number}",
        RESULT,
        words="Two roots with $4\\cos^2\\varphi$ = {product} have n(s, r) = {n_sr} and n(r, s) = {n_rs}; "
        "their angle is {angle:pi}, and the quotient |s|/|r| of their lengths is {ratio}.",
        to_state=["def-7"],
        to_prove=["sec2.product"],
    )(partial(angle_row, _number))


@claim("tab-angles.column", "Section 2.2, table of angles", WORDING, to_state=["def-7"])
def angle_column(printed: Constants) -> Finding:
    """The column n(r, s) reads {n_rs}."""
    true = tuple(row.n_rs for row in angle_rows())
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
    """Up to symmetry there are {rows:words} cases for two roots."""
    integers = [(a, b) for a in range(-4, 5) for b in range(-4, 5) if 0 <= a * b <= 4 and abs(a) >= abs(b)]
    possible = {(a, b) for a, b in integers if bool(a) == bool(b) and (a * b < 4 or a == b)}
    occurring = {(row.n_sr, row.n_rs) for row in angle_rows()}
    return agree(
        printed, {"rows": len(occurring) if occurring == possible else 0}, FINITE,
        "Two integers with a product from 0 to 4, both zero or neither, with |n(s, r)| ≥ |n(r, s)|. The "
        "product 4 belongs to parallel roots, which are equal or opposite in a reduced system; that "
        "excludes (4, 1) and (-4, -1).",
        "All nine occur in $A_2$, $B_2$, $G_2$.",
    )  # fmt: skip
