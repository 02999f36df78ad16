"""Section 2.2: lengths and angles of roots, and Coxeter diagrams."""

from __future__ import annotations

from functools import lru_cache
from itertools import permutations

from ..exact import Surd, show, sqrt
from ..root_sets import cartan_integer, is_crystallographic, is_irreducible, is_reduced, is_root_system
from .claim import Constants, Finding, agree, claim, repaired
from .instances import all_types, dihedral_angles, systems
from .section_2_angles import angle_rows
from .section_2_roots import CROSS
from .section_2_simple_roots import simple_sets
from .vocabulary import EVERY_D, FINITE, Verdict, Weight
from .wording import explained

RESULT, PROOF, WORDING = Weight.RESULT, Weight.PROOF, Weight.WORDING


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
    """Roots have at most {lengths:words} different lengths, as three would have a quotient such as
    {excluded}."""
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
    r, s = (1, 0), (1, 1)
    return explained(
        finding,
        "The sentence lost its hypothesis: of any two roots it is false, as n(r, s) = "
        f"{cartan_integer(r, s)} for r = {show(r)} and s = {show(s)} in $B_2$, at an angle of 45 degrees",
    )


@lru_cache(maxsize=2)
def _simple_pairs(letters: str = "ABCDEFG") -> frozenset[tuple[int, int]]:
    """The Cartan integers of two different simple roots, in both orders, all types up to rank 8."""
    tables = ((s.cartan_matrix, permutations(range(s.rank), 2)) for s in systems(8, letters))
    return frozenset((int(c[i, j]), int(c[j, i])) for c, pairs in tables for i, j in pairs)


@claim("sec2.simple-integers", "Section 2.2", WORDING, to_state=["def-7"], to_prove=["lem-2.obtuse"])
def cartan_integers_of_simple_roots(printed: Constants) -> Finding:
    """The Cartan integers of {of} are among {values}."""
    true = tuple(sorted({n for n, _ in _simple_pairs()}))
    return _of_simple_roots(printed, "values", true, "All of them occur; computed up to rank 8.")


@claim("sec2.simple-angles", "Section 2.2", WORDING, to_state=["def-7"], to_prove=["sec2.simple-integers"])
def angles_of_simple_roots(printed: Constants) -> Finding:
    """The angle of {of} is one of {angles:pi}."""
    by_integers = {row.n_sr * row.n_rs: row.angle for row in angle_rows() if row.n_sr <= 0}
    true = tuple(str(x) for x in sorted({by_integers[a * b] for a, b in _simple_pairs()}))
    return _of_simple_roots(printed, "angles", true, "All of them occur; computed up to rank 8.")


@claim("sec2.same-angles", "Section 2.2", RESULT, to_prove=["lem-1"])
def same_angles(printed: Constants) -> Finding:
    """All sets of simple roots have the same angles."""
    return agree(printed, {"same": simple_sets()}, EVERY_D, "By Lemma 1 they are congruent.")


# -- Coxeter diagrams -------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _labels() -> tuple[int, ...]:
    """The labels of pairs of simple roots that are not orthogonal, all types up to rank 8."""
    angles = {angle for t in all_types(8) for angle in dihedral_angles(t)}
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
    labels = {by_product[a * b] for a, b in _simple_pairs("ADE")}
    true = {"not_drawn": min(labels), "not_written": max(labels)}
    return agree(
        printed, true, EVERY_D,
        "So the diagrams without labels are the graphs of Section 2.1: for $A_d,D_d,E_d$ all labels are 2 "
        "or 3. Computed up to rank 8.",
    )  # fmt: skip
