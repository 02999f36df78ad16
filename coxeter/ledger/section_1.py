"""The abstract and Section 1: what is promised, what others did, and what is conjectured."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, islice, permutations, product

from ..affine import CoxeterTriangulation, triangulation
from ..cartan import reflection_group_order, restrict
from ..delaunay import delaunay_verdict, mirror_vertices, protection, vertices_by_distance
from ..errors import CoxeterError
from ..exact import Exact, RationalMatrix, Surd, sqrt
from ..families import closed_form, evaluate
from ..lattices import LatticeProof, vertex_lattice
from ..names import EXCEPTIONAL, FAMILIES, triangulations_up_to
from ..paper import printed as paper
from ..quality import PAPER_MEASURES, radius_ratio
from ..root_lattices import Lattice, coweight_lattice, root_lattice
from ..roots import root_system
from ..simplex import Simplex
from .claim import Constants, Finding, agree, cited, claim, conjecture
from .vocabulary import EVERY_D, FINITE, INSTANCES, LITERATURE, Verdict, Weight

MEASURES = tuple(known.name for known in PAPER_MEASURES)

RESULT, WORDING = Weight.RESULT, Weight.WORDING


@lru_cache(maxsize=8)
def all_types(d: int) -> tuple[CoxeterTriangulation, ...]:
    """All Coxeter triangulations up to a dimension."""
    return tuple(map(triangulation, triangulations_up_to(d)))


def fits(text: object, true: str, values: Mapping[int, Exact]) -> object:
    """A printed formula in d if it has the computed values, else the true one, which must have them."""
    for formula in (text, true):
        if all(evaluate(str(formula), d=d) == value for d, value in values.items()):
            return formula
    raise CoxeterError(f"{true} does not have the computed values")


def quoted(finding: Finding, source: str, tested: str) -> Finding:
    """A statement that is proved elsewhere: cited, if what was computed agrees with it."""
    if finding.verdict is not Verdict.HOLDS:
        return finding
    return replace(cited(source, tested), derivation=finding.derivation)


def explained(finding: Finding, why: str) -> Finding:
    """The finding, with the reason for its correction."""
    if finding.verdict is not Verdict.CORRECTED:
        return finding
    return replace(finding, correction=f"{finding.correction}. {why}")


# -- the abstract -----------------------------------------------------------------------------------------


def _barycentre(t: CoxeterTriangulation) -> tuple[Fraction, ...]:
    weights = RationalMatrix.from_rows([[Fraction(1, t.dimension + 1)] * (t.dimension + 1)])
    return (weights @ t.simplex.vertex_matrix).row(0)


@lru_cache(maxsize=1)
def _folds_back() -> bool:
    """Whether far points are carried into the fundamental simplex, and back again, by its reflections."""
    return all(
        fold.word and min(fold.barycentric) >= 0 and t.unfold(fold.word, fold.point) == point
        for t in all_types(4)
        for point in [tuple(7 * x for x in _barycentre(t))]
        for fold in [t.fold(point)]
    )


@claim("sec1.abstract.one-simplex", "Abstract", RESULT, to_state=["def-1"])
def one_simplex(printed: Constants) -> Finding:
    """A single simplex gives the whole triangulation, by reflecting it in its {generators} facets again and
    again."""
    facets = {t.dimension: len(t.facets) for t in all_types(8)}
    true = {"generators": fits(printed["generators"], "d + 1", facets), "whole_space": _folds_back()}
    return agree(
        printed, true, EVERY_D,
        "A point beyond a facet comes closer to each interior point when it is reflected in that facet. "
        "Its orbit is discrete, so after finitely many such steps it lies in the simplex: the images of "
        "the simplex cover space.",
        "Computed: far points of all types up to d = 4 are carried into the simplex, and back.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _within_band() -> bool:
    """Whether d·κ² lies in [1/2, 8) for all normalised measures of the four families up to d = 16."""
    values = (
        d * closed_form(family, f"normalized_{m}").at(d) ** 2
        for family in "ABCD"
        for m in MEASURES
        for d in range({"B": 3, "D": 4}.get(family, 2), 17)
    )
    return all(2 * x >= 1 and x < 8 for x in values)


_QUALITY = (
    "For every d and every normalised measure $\\hat\\kappa$ of the four families (fatness to the power "
    "1/d) $\\tfrac12\\le d\\,\\hat\\kappa^2<8$, so it is of the exact order $1/\\sqrt d$. By the closed "
    "forms:",
    "$\\tilde A_d$: $d\\hat\\alpha^2=d\\hat\\rho^2=\\frac{6d^2}{(d+1)(d+2)}$; "
    "$d\\hat\\theta^2=\\frac{4d^2}{(d+1)^2}$ or $\\frac{4d}{d+2}$; fatness $\\frac{8d}{(d+1)^{1+2/d}}$ or "
    "$\\frac{8(d+1)^{1-2/d}}{d+2}$, and $1\\le(d+1)^{2/d}\\le3$.",
    "$\\tilde B_d,\\tilde C_d,\\tilde D_d$: $d\\hat\\theta^2=\\frac d{d+1}$; "
    "$d\\hat\\alpha^2=\\frac{2d^3}{(d+1)^2(d+c)}$ with c = 2, 0, 4; fatness $2\\,(c/(d+1))^{1/d}$ with c = "
    "4, 1, 16; the radius ratio likewise. For $\\tilde B_3$ thickness and fatness are $\\frac9{16}$ and "
    "$\\frac32$.",
    "Limits of $\\sqrt d\\,\\hat\\kappa$ for fatness, aspect ratio, thickness, radius ratio: "
    "$2\\sqrt2,\\sqrt6,2,\\sqrt6$ for $\\tilde A$; $\\sqrt2,\\sqrt2,1,\\sqrt2$ for the others.",
    "Computed: the band for all d up to 16, and the decay from d = 64 to d = 1024.",
)


def _exponent(form: str, family: str) -> Fraction | None:
    """The half-integer e for which a closed form behaves like d^e, from d = 64 to d = 1024; else None."""
    low, high = (closed_form(family, form).at(d) for d in (64, 1024))
    if form == "fatness":
        low, high = low.root(64), high.root(1024)
    for twice in range(5):
        scaled = high * 4**twice
        if 2 * low < 3 * scaled and 2 * scaled < 3 * low:
            return Fraction(-twice, 2)
    return None


@lru_cache(maxsize=2)
def _exponents(prefix: str = "normalized_") -> dict[str, Fraction | None]:
    """The exponent of each measure in the four families, None if it is not the same in all."""
    by_measure = {m: {_exponent(prefix + m, family) for family in "ABCD"} for m in MEASURES}
    return {m: found.pop() if len(found) == 1 else None for m, found in by_measure.items()}


def _quality_rate(printed: Constants, **more: object) -> Finding:
    (exponent,) = set(_exponents().values())
    bound = "Theta" if _within_band() else "O"
    return agree(printed, {"bound": bound, "exponent": str(exponent), **more}, EVERY_D, *_QUALITY)


_ONLY_UPPER = (
    "O gives an upper bound, which any bad triangulation satisfies. What is meant, and true, is that "
    "quality is of the exact order: it lies between $\\frac1{\\sqrt{2d}}$ and $\\frac{\\sqrt8}{\\sqrt d}$"
)


@claim("sec1.abstract.quality-rate", "Abstract", WORDING, to_state=["def-1"])
def quality_rate(printed: Constants) -> Finding:
    """The quality of the simplices of all Coxeter triangulations is {bound} of d to the power {exponent},
    times that of the regular simplex."""
    return explained(_quality_rate(printed), f"{_ONLY_UPPER} (fatness being taken to the power 1/d).")


def _protection_rate(printed: Constants, **more: object) -> Finding:
    exponent = _exponent("relative_protection", "A")
    finding = agree(
        printed, {"bound": "Theta", "exponent": str(exponent), **more}, EVERY_D,
        "$\\hat\\delta=\\sqrt{1+x}-1$ with $x=\\frac{24}{d(d+2)}$, as the nearest other vertices are at "
        "squared distance $R^2+\\frac2{d+1}$ from the circumcentre and $R^2=\\frac{d(d+2)}{12(d+1)}$.",
        "R, the greatest distance of a point from the vertices, is the ε of the net that they are.",
        "$\\frac x2-\\frac{x^2}8<\\sqrt{1+x}-1<\\frac x2$ for $x>0$, so $d^2\\,\\hat\\delta\\to12$.",
        "Computed: the formula against the nearest vertices up to d = 12, and its decay from d = 64 to d = "
        "1024.",
    )  # fmt: skip
    return explained(
        finding,
        "A small upper bound is no merit of a protection. What is meant, and true, is the exact order: "
        "$d^2\\,\\hat\\delta\\to12$ for the relative protection $\\hat\\delta=\\delta/R$",
    )


@lru_cache(maxsize=1)
def _formula_is_protection() -> bool:
    form = closed_form("A", "relative_protection")
    return all(protection(t).relative == form.at(t.dimension) for t in all_types(12) if t.type.letter == "A")


@lru_cache(maxsize=1)
def _protected() -> tuple[str, ...]:
    """The families with a protected triangulation up to d = 12."""
    return tuple(sorted({t.type.family for t in all_types(12) if protection(t)}))


@claim("sec1.abstract.protection-rate", "Abstract", WORDING)
def protection_rate(printed: Constants) -> Finding:
    """The protection {bound} of d to the power {exponent} is achieved by this many families: {families}."""
    return _protection_rate(printed, families=len(_protected()) if _formula_is_protection() else 0)


@lru_cache(maxsize=1)
def _a_is_best() -> bool:
    """Whether A~ has the highest normalised measures, each in each dimension up to 8, and the highest
    protection."""
    best = True
    for d in range(2, 9):
        a, *others = [t for t in all_types(8) if t.dimension == d]
        best &= all(known(t.simplex) < known(a.simplex) for known in PAPER_MEASURES for t in others)
        best &= all(protection(t).relative < protection(a).relative for t in others)
    return best


def _comparison(what: str) -> str:
    """What was tried on a conjecture."""
    if not _a_is_best():
        raise CoxeterError("another Coxeter triangulation is better than that of type A")
    tried = {
        "quality": "that of type A is strictly the best for all four measures",
        "protection": "that of type A is the only protected one",
    }
    found = ", and ".join(tried[word] for word in what.split(", "))
    plane = " In the plane its triangles are regular, so none are better." if "quality" in what else ""
    return f"Among Coxeter triangulations up to d = 8 {found}.{plane} Others were not searched."


@claim("sec1.abstract.conjecture", "Abstract", RESULT)
def both_conjectures(printed: Constants) -> Finding:
    """Conjecture: in space of any dimension no triangulation is of better order than d to the power
    {quality_exponent} in quality, and than d to the power {protection_exponent} in protection."""
    (quality,) = set(_exponents().values())
    true = {
        "quality_exponent": str(quality),
        "protection_exponent": str(_exponent("relative_protection", "A")),
    }
    finding = agree(printed, true, EVERY_D)
    return (
        conjecture(_comparison("quality, protection"), INSTANCES)
        if finding.verdict is Verdict.HOLDS
        else finding
    )


# -- 1.1 --------------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _names_of_quotients() -> dict[str, str]:
    simplices = [Simplex([(0, 0), (3, 0), (0, 4)]), Simplex([(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)])]
    quotients = {
        "height_over_edge": [s.minimal_height / s.longest_edge for s in simplices],
        "volume_over_power_of_edge": [s.volume / s.longest_edge**s.dimension for s in simplices],
        "inradius_over_circumradius": [s.inradius / s.circumradius for s in simplices],
    }
    return {
        key: known.name.replace("_", " ")
        for key, values in quotients.items()
        for known in PAPER_MEASURES
        if [known(s) for s in simplices] == values
    }


@claim("sec1.measures", "Section 1.1", WORDING)
def named_measures(printed: Constants) -> Finding:
    """Least height over longest edge is called {height_over_edge}, volume over a power of the longest edge
    {volume_over_power_of_edge}, inradius over circumradius {inradius_over_circumradius}."""
    return agree(printed, _names_of_quotients(), EVERY_D, "As Definition 18 has them; the power is d.")


def _is_cell(t: CoxeterTriangulation, vertices: RationalMatrix) -> bool:
    """Whether no hyperplane of the arrangement cuts a simplex, while each of its facets lies in one."""
    levels = vertices @ t.roots.positive_roots.T
    columns = [[Fraction(int(x), levels.denominator) for x in c] for c in levels.numerators.T]
    uncut = all(max(c) <= math.floor(min(c)) + 1 for c in columns)
    walls = {
        k
        for c in columns
        for wall in (math.floor(min(c)), math.floor(min(c)) + 1)
        if sum(x != wall for x in c) == 1
        for k, x in enumerate(c)
        if x != wall
    }
    return uncut and len(walls) == t.dimension + 1


def _neighbour(t: CoxeterTriangulation, k: int) -> RationalMatrix:
    """The mirror image of the fundamental simplex in facet k, as rows."""
    return RationalMatrix.from_rows([t.facets[k].reflect(v) for v in t.simplex.vertex_matrix.rows()])


@lru_cache(maxsize=1)
def _conditions() -> dict[str, bool]:
    """Whether the triangulations of all types up to d = 5 are what Definition 1 asks for."""
    uncut = all(_is_cell(t, t.simplex.vertex_matrix) for t in all_types(5))
    mirrored = all(_is_cell(t, _neighbour(t, k)) for t in all_types(5) for k in range(t.dimension + 1))
    return {"arrangement": uncut, "mirror_images": mirrored}


@claim("def-1", "Section 1.1, Definition 1", WORDING)
def definition_1(printed: Constants) -> Finding:
    """A Coxeter triangulation is a hyperplane arrangement whose cells are {cells}, any two neighbours being
    mirror images of one another."""
    cells = {"simplices" for t in all_types(5) if t.simplex.dimension == t.dimension}
    return agree(
        printed, {"cells": cells.pop(), **_conditions()}, EVERY_D,
        "A definition. Computed for all types up to d = 5: no hyperplane cuts the fundamental simplex or "
        "one of its mirror images, and each of their facets lies in one.",
        "Both conditions are needed. A sheared $\\tilde A_2$ is an arrangement of triangles, but "
        "neighbours are no mirror images; the triangulation of Figure 3 has mirror images, but is no "
        "arrangement.",
    )  # fmt: skip


@claim("def-1.two-definitions", "Section 1.1, Definition 1 and Section 2.4", WORDING, to_state=["def-1"])
def two_definitions(printed: Constants) -> Finding:
    """The triangulations of Section 2.4, made from root systems, are those of Definition 1."""
    if not all(_conditions().values()):
        raise CoxeterError("a triangulation of Section 2.4 is none of Definition 1")
    finding = cited(
        "Bourbaki, Lie, V, 3 and VI, 2.5; Humphreys, Sections 2.7 and 4.10; for dimensions from 2 on.",
        "All types up to d = 5 satisfy Definition 1.",
    )
    lines = (
        "Let a triangulation satisfy Definition 1. It is determined by one cell, since each neighbour is a "
        "mirror image; the reflection in a wall of a cell maps that cell to its neighbour, so it maps the "
        "triangulation to itself.",
        "Hence all hyperplanes are mirrors of a discrete group generated by reflections, whose fundamental "
        "domain is a simplex; these groups are classified, and from dimension 2 on they are those of "
        "Theorem 4.",
    )
    return replace(finding, derivation=lines)


@claim("sec1.best-known", "Section 1.1", RESULT, to_state=["def-1"])
def best_known(printed: Constants) -> Finding:
    """In arbitrary dimension no triangulations of better quality than Coxeter triangulations are known."""
    return conjecture(_comparison("quality"), INSTANCES)


_DEGREES = {0: 90, 1: 60, 2: 45, 3: 30}
"""4·cos² of the angle between two walls, a product of Cartan integers, and the angle."""


@lru_cache(maxsize=256)
def _angles(t: CoxeterTriangulation) -> frozenset[int]:
    """The dihedral angles of a triangulation in degrees."""
    n, nodes = t.roots.affine_neighbours, range(t.dimension + 1)
    return frozenset(_DEGREES[n[i].get(j, 0) * n[j].get(i, 0)] for i, j in combinations(nodes, 2))


def _angles_of(types: Sequence[CoxeterTriangulation]) -> tuple[int, ...]:
    return tuple(sorted(frozenset().union(*map(_angles, types))))


_BY_FAMILY = (
    "The angles are read off the affine diagrams, which are known for every d: no edge gives 90°, a plain "
    "edge 60°, label 4 gives 45°, label 6 gives 30°. Label 4 occurs in $\\tilde B$, $\\tilde C$, $\\tilde "
    "F_4$ only, label 6 in $\\tilde G_2$ only."
)


@claim("sec1.angles", "Section 1.1", RESULT, to_state=["def-1"], to_prove=["rem-3"])
def angles(printed: Constants) -> Finding:
    """All dihedral angles are among {angles} degrees; only in {exception} there is another, of
    {exceptional_angle} degrees."""
    usual = _angles_of([t for t in all_types(12) if t.roots.type.letter != "G"])
    others = {t.name: _angles(t) - set(usual) for t in all_types(12) if _angles(t) - set(usual)}
    ((name, angles),) = others.items()
    true = {"angles": usual, "exception": name, "exceptional_angle": min(angles)}
    return agree(printed, true, EVERY_D, _BY_FAMILY)


def _alcoves_within(t: CoxeterTriangulation, m: int) -> int:
    """How many alcoves lie in the fundamental simplex, enlarged by a factor."""
    middle = _barycentre(t)
    fresh: list[tuple[int, ...]] = [()]
    seen = {middle}
    while fresh:
        words = [(*word, k) for word in fresh for k in range(t.dimension + 1)]
        fresh = []
        for word in words:
            corners = [t.unfold(word, v) for v in t.simplex.vertex_matrix.rows()]
            inside = {f.level(x) >= (m - 1) * f.offset for f in t.facets for x in corners}
            centre = t.unfold(word, middle)
            if inside == {True} and centre not in seen:
                fresh.append(word)
                seen.add(centre)
    return len(seen)


@lru_cache(maxsize=1)
def _is_self_similar() -> bool:
    """Whether the fundamental simplex, enlarged by m, holds as many alcoves as its volume says."""
    cases = [(t, 2) for t in all_types(3)] + [(t, 3) for t in all_types(2)]
    return all(_alcoves_within(t, m) == m**t.dimension for t, m in cases)


@claim("sec1.self-similar", "Section 1.1", RESULT, to_state=["def-1"])
def self_similar(printed: Constants) -> Finding:
    """Coxeter triangulations are self-similar."""
    return agree(
        printed, {"self_similar": _is_self_similar()}, EVERY_D,
        "Scaled by a whole number m, the hyperplane $\\langle x,r\\rangle=k$ is $\\langle x,r\\rangle=mk$, "
        "another one of the arrangement. So each simplex can be divided into $m^d$ copies of itself, "
        "smaller by the factor m.",
    )  # fmt: skip


@claim("sec1.not-always-lattices", "Sections 1.1 and 1.2", RESULT, to_state=["def-1"])
def not_always_lattices(printed: Constants) -> Finding:
    """The vertex set of a Coxeter triangulation need not be a lattice."""
    witness = next(w for t in all_types(3) if not (w := vertex_lattice(t)).is_lattice)
    always = not (not isinstance(witness, LatticeProof) and witness.check())
    return agree(printed, {"always_lattices": always}, FINITE, f"A witness in the plane: {witness}.")


@lru_cache(maxsize=1)
def _fewest_ambiguous() -> dict[int, Fraction]:
    """d -> the number of cospherical points of a set whose hull can be triangulated in two ways."""
    found = {}
    for d in (2, 3, 4):
        e = [[int(i == j) for j in range(d)] for i in range(d)]
        minus = [[-x for x in e[i]] for i in (0, 1)]
        rest = e[2:]
        first = [Simplex([e[0], minus[0], v, *rest]).volume for v in (e[1], minus[1])]
        second = [Simplex([e[1], minus[1], v, *rest]).volume for v in (e[0], minus[0])]
        if sum(first, Surd(0)) == sum(second, Surd(0)):
            found[d] = Fraction(len([e[0], e[1], *minus, *rest]))
    return found


@claim("sec1.unique-delaunay", "Section 1.1", RESULT)
def unique_delaunay(printed: Constants) -> Finding:
    """The Delaunay triangulation of a set of points is unique if no {cospherical} of them lie on a sphere
    with empty interior."""
    true = fits(printed["cospherical"], "d + 2", _fewest_ambiguous())
    return agree(
        printed, {"cospherical": true}, EVERY_D,
        "Without such points each Delaunay cell has d + 1 vertices: it is a simplex, and nothing is left "
        "to choose.",
        "With them there can be a choice: $\\pm e_1,\\pm e_2,e_3,\\dots,e_d$ lie on a sphere, and their "
        "hull can be cut along the segment from $-e_1$ to $e_1$ or along that from $-e_2$ to $e_2$. "
        "Computed for d = 2, 3, 4.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _spheres_of_a() -> tuple[dict[int, Fraction], bool]:
    """d -> how many vertices of A~_d lie on the circumsphere, and whether the next ones keep the distance
    δ."""
    counts, apart = {}, True
    for t in (t for t in all_types(6) if t.type.letter == "A"):
        squares = [s for s, _ in islice(vertices_by_distance(t), t.dimension + 3)]
        counts[t.dimension] = Fraction(squares.count(squares[0]))
        apart &= sqrt(squares[t.dimension + 1]) - sqrt(squares[0]) == protection(t).absolute
        apart &= squares[t.dimension + 1] == min(m.squared_distance for m in mirror_vertices(t))
    return counts, apart


@claim("sec1.protection", "Section 1.1", WORDING)
def protection_in_words(printed: Constants) -> Finding:
    """Protection asks that beside the {on_the_sphere} vertices of a simplex none lies on its circumsphere,
    and that all others keep at a distance of at least δ from it."""
    on_sphere, apart = _spheres_of_a()
    true = {"on_the_sphere": fits(printed["on_the_sphere"], "d + 1", on_sphere), "others_at_least": apart}
    return agree(
        printed, true, EVERY_D,
        "This is Definition 19: the infimum of the distances from the ball is at least δ.",
        "Computed for $\\tilde A_d$ up to d = 6: the vertices on the circumsphere are those of the "
        "simplex, and the next ones have the distance δ.",
    )  # fmt: skip


@claim("sec1.protection-gives-quality", "Section 1.1", RESULT, to_state=["sec1.protection"])
def protection_gives_quality(printed: Constants) -> Finding:
    """Protected simplices have good quality."""
    if not _a_is_best() or _protected() != ("A",):
        raise CoxeterError("the protected triangulations are not those of type A")
    return cited(
        "Boissonnat, Dyer and Ghosh, The stability of Delaunay triangulations, 2013.",
        "Up to d = 12 the protected Coxeter triangulations are those of type A; up to d = 8 they are the "
        "best for all four measures.",
    )


@claim("sec1.perturbation-algorithms", "Section 1.1", RESULT, to_state=["sec1.protection"])
def perturbation_algorithms(printed: Constants) -> Finding:
    """Known perturbation algorithms turn a net into a protected one, but guarantee only a protection of the
    order of two to the power of minus d squared, times ε."""
    weaker = all(
        closed_form("A", "relative_protection").at(d) > Fraction(1, 2 ** (d * d)) for d in range(2, 25)
    )
    return quoted(
        agree(printed, {"weaker": weaker}, LITERATURE),
        "The two algorithms cited there; the guarantees are theirs, and were not recomputed.",
        "For d from 2 to 24 the relative protection of type A is greater than two to the power of minus d "
        "squared.",
    )


@claim("sec1.A-protection", "Section 1.1", WORDING, to_state=["sec1.protection"])
def protection_of_a(printed: Constants) -> Finding:
    """The triangulation of type A~ is Delaunay, and its protection is {bound} of d to the power {exponent},
    times the radius ε of the net."""
    delaunay = all(bool(delaunay_verdict(t)) for t in all_types(12) if t.type.letter == "A")
    return _protection_rate(printed, delaunay=delaunay and _formula_is_protection())


@claim("sec1.greatest-protection", "Section 1.1", RESULT, to_state=["sec1.A-protection"])
def greatest_protection(printed: Constants) -> Finding:
    """No Delaunay triangulation of general dimension with a greater protection than that of type A~ is
    known."""
    return conjecture(_comparison("protection"), INSTANCES)


# -- 1.2, what others wanted, and did ---------------------------------------------------------------------


@claim("sec1.dobkin.neighbour", "Section 1.2", RESULT, to_state=["def-1"])
def easy_neighbour(printed: Constants) -> Finding:
    """The simplex beyond a facet is easily found: it has {new_vertices} new vertex, a mirror image."""
    true = {
        sum(f.reflect(v) != v for v in t.simplex.vertex_matrix.rows()) for t in all_types(6) for f in t.facets
    }
    return agree(
        printed, {"new_vertices": max(true)}, EVERY_D,
        "The reflection in a facet fixes its d vertices and moves the opposite one. Computed up to d = 6.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _labels() -> dict[int, frozenset[Fraction]]:
    """d -> the labels in every simplex near the fundamental one; an error if two simplices differ."""
    found: dict[int, set[frozenset[Fraction]]] = {}
    for t in all_types(4):
        for word in product(range(t.dimension + 1), repeat=2):
            corners = [t.unfold(word, v) for v in t.simplex.vertex_matrix.rows()]
            folded = [t.fold(v).barycentric for v in corners]
            found.setdefault(t.dimension, set()).add(
                frozenset(Fraction(x.index(Fraction(1))) for x in folded)
            )
    return {d: labels for d, (labels,) in ((d, tuple(sets)) for d, sets in found.items())}


@claim("sec1.dobkin.labels", "Section 1.2", RESULT, to_state=["def-1"])
def labels(printed: Constants) -> Finding:
    """All vertices can be labelled {first} to {last}, so that the vertices of each simplex have different
    labels."""
    last = {d: max(found) for d, found in _labels().items()}
    true = {"first": min(map(min, _labels().values())), "last": fits(printed["last"], "d", last)}
    return agree(
        printed, true, EVERY_D,
        "Each vertex is carried to exactly one $u_k$ by the affine Weyl group, as its orbit meets the "
        "closed simplex once; k is its label. Every simplex is an image of the fundamental one, so it has "
        "all labels.",
        "Computed: the labels of all simplices at most two steps away, for all types up to d = 4.",
    )  # fmt: skip


@claim("sec1.dobkin.congruent", "Section 1.2", RESULT, to_state=["def-1"])
def congruent(printed: Constants) -> Finding:
    """Coxeter triangulations are monohedral: all simplices are congruent."""
    true = all(
        Simplex(_neighbour(t, k).rows()).squared_edge_lengths == t.simplex.squared_edge_lengths
        for t in all_types(3)
        for k in range(t.dimension + 1)
    )
    return agree(printed, {"congruent": true}, EVERY_D, "All simplices are images of one under reflections.")


@claim("sec1.dobkin.isotropic", "Section 1.2", WORDING, to_state=["def-1"])
def isotropic(printed: Constants) -> Finding:
    """The simplices of Coxeter triangulations are isotropic, that is, roughly the same in all directions."""
    squares = [(t, t.simplex.squared_longest_edge / t.simplex.squared_shortest_edge) for t in all_types(12)]
    worst = max(squares, key=lambda pair: pair[1])
    return agree(
        printed, {"isotropic": all(ratio <= 4 * t.dimension for t, ratio in squares)}, EVERY_D,
        "\"Roughly\" sets no bound; this is one: no edge is longer than $2\\sqrt d$ times another. "
        "Squared, the quotient of the longest and the shortest edge is $\\frac{(d+1)^2}{4d}$ or "
        "$\\frac{d+2}4$ in $\\tilde A_d$ (d odd, even), d in $\\tilde C_d$, $\\tilde D_d$ (2 for d = 4) "
        "and $\\tilde B_d$ (4 for d = 3).",
        f"Up to d = 12 it is greatest in {worst[0].name}, where it is {worst[1]}.",
    )  # fmt: skip


def _radius_ratio(t: CoxeterTriangulation) -> Surd:
    return radius_ratio(t.simplex)


@claim("sec1.dobkin.choice", "Section 1.2", RESULT)
def choice(printed: Constants) -> Finding:
    """Comparing the radius ratios of all types, Dobkin and others chose the family {chosen}~."""
    best = {max((t for t in all_types(8) if t.dimension == d), key=_radius_ratio) for d in range(2, 9)}
    (letter,) = {t.type.letter for t in best}
    return quoted(
        agree(printed, {"chosen": letter}, LITERATURE),
        "Dobkin, Levy, Thurston and Wilks, Contour tracing by piecewise linear approximations, 1990.",
        "It has the greatest radius ratio in each dimension from 2 to 8.",
    )


@claim("sec1.permutahedral", "Section 1.2", RESULT)
def permutahedral(printed: Constants) -> Finding:
    """The vertex set of the triangulation of type A~ is the {lattice} lattice."""
    proofs = [vertex_lattice(t) for t in all_types(8) if t.type.letter == "A"]
    dual = all(
        isinstance(p, LatticeProof) and p.lattice == root_lattice(p.triangulation.roots).dual()
        for p in proofs
    )
    cells = all(
        t.roots.weyl_group_order == math.factorial(t.dimension + 1)
        for t in all_types(8)
        if t.type.letter == "A"
    )
    return agree(
        printed, {"lattice": "permutahedral" if dual and cells else "another"}, EVERY_D,
        "All marks are 1, so the vertices of the alcove are the fundamental coweights, and the vertex set "
        "consists of all vectors with integer products with the roots: the dual $A_d^*$ of the root "
        "lattice.",
        "Its Voronoi cell has the $(d+1)!$ circumcentres around a vertex as its corners, an orbit of the "
        "symmetric group: a permutahedron. Computed up to d = 8: the lattice, and the number of simplices "
        "at a vertex.",
    )  # fmt: skip


@claim("sec1.filtering", "Section 1.2", WORDING)
def filtering(printed: Constants) -> Finding:
    """Adams, Baek and Davis filter on the permutahedral lattice, as its simplices are congruent and
    isotropic."""
    return cited(
        "Adams, Baek and Davis, Fast high-dimensional filtering using the permutohedral lattice, 2010."
    )


@claim("sec1.rips", "Section 1.2", WORDING, to_state=["sec1.protection"])
def rips(printed: Constants) -> Finding:
    """A smaller approximation of the Rips filtration was found, mostly because the permutahedral lattice is
    so well protected."""
    return cited("Choudhary and others, as cited there.")


@lru_cache(maxsize=1)
def _nearest_lattice_points() -> tuple[tuple[str, int, int], ...]:
    """For root lattices of one length: the largest number of nearest lattice points to a vertex of the
    alcove."""
    found = []
    for t in all_types(8):
        if t.roots.type.letter in "ADE":
            diagram, nodes = t.roots.affine_neighbours, set(range(t.dimension + 1))
            order = [reflection_group_order(restrict(diagram, nodes - {k})) for k in nodes]
            both = [reflection_group_order(restrict(diagram, nodes - {0, k})) for k in nodes]
            found.append((t.roots.name, t.dimension, max(a // b for a, b in zip(order, both, strict=True))))
    return tuple(found)


@claim("sec1.root-lattice-triangulations", "Section 1.2", WORDING)
def root_lattice_triangulations(printed: Constants) -> Finding:
    """The Delaunay triangulations of root lattices are other ones than Coxeter triangulations."""
    crowded = {name: many for name, d, many in _nearest_lattice_points() if d > 2 and many > d + 1}
    alike = [name for name, d, many in _nearest_lattice_points() if many <= d + 1]
    different = all(name in crowded for name, d, _ in _nearest_lattice_points() if d > 2)
    return agree(
        printed, {"different": different}, EVERY_D,
        "From d = 3 on a vertex $u_k$ of the alcove has more than d + 1 nearest points of the root "
        "lattice, so a Delaunay cell is no simplex. They are an orbit of the group $W_k$ that fixes $u_k$, "
        "and number $|W_k|/|W_k\\cap W|$: $\\binom{d+1}{2}$ for $A_d$ and k = 2, $2^{d-1}$ for $D_d$ and k "
        "= d.",
        f"Computed: {', '.join(f'{name} {many}' for name, many in crowded.items())}.",
        "Other root lattices are $\\mathbb Z^d$ for $B_d$, with cubes, and those of $D_d$, $D_4$, $A_2$ "
        "for $C_d$, $F_4$, $G_2$.",
        f"In the plane both meet ({', '.join(alike)}): the Delaunay triangulation of that root lattice is, "
        "up to scale, a Coxeter triangulation.",
    )  # fmt: skip


# -- 1.2, dimension three ---------------------------------------------------------------------------------


BCC = (("1/2", "1/2", "1/2"), ("1/2", "-1/2", "-1/2"), ("-1/2", "1/2", "-1/2"))
"""A basis of the body-centred cubic lattice: half diagonals of the unit cube."""


@claim("sec1.bcc", "Section 1.2", RESULT)
def bcc(printed: Constants) -> Finding:
    """The vertex set of the triangulation of type A~ in dimension {dimension} is the {lattice} lattice."""
    lattice = Lattice.spanned_by(BCC)
    is_bcc = all(
        v in lattice for v in ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    ) and lattice.gram_determinant == Fraction(1, 4)
    vertices = vertex_lattice(triangulation("A~3"))
    basis = RationalMatrix.from_rows([[Fraction(4 * (i == j) - 1, 4) for j in range(4)] for i in range(3)])
    same_products = lattice.basis @ lattice.basis.T == basis @ basis.T
    if not (
        is_bcc and isinstance(vertices, LatticeProof) and same_products and vertices.lattice == Lattice(basis)
    ):
        return agree(printed, {"dimension": 3, "lattice": "another"}, FINITE)
    return agree(
        printed, {"dimension": lattice.rank, "lattice": "body-centred cubic"}, FINITE,
        "The vertex set has the basis $e_i-\\frac14(1,1,1,1)$, i = 1, 2, 3, with the products $\\frac34$ "
        "and $-\\frac14$. So have $\\frac12(1,1,1)$, $\\frac12(1,-1,-1)$, $\\frac12(-1,1,-1)$, a basis of "
        "the body-centred cubic lattice.",
    )  # fmt: skip


@claim("sec1.sommerville", "Section 1.2", WORDING, to_state=["sec1.bcc"])
def sommerville(printed: Constants) -> Finding:
    """The tetrahedron of A~3 is known as Sommerville's of type II, and as the bcc tetrahedron."""
    edges = sorted(
        triangulation("A~3").simplex.squared_edge_lengths[i, j] for i, j in combinations(range(4), 2)
    )
    return cited(
        "Sommerville, 1923, as cited there; the numbering is not the same with all authors.",
        f"Its squared edges are {', '.join(map(str, edges))}, that is, as 3 to 4, four and two of them.",
    )


@claim("sec1.naylor", "Section 1.2", WORDING, to_state=["sec1.sommerville"])
def naylor(printed: Constants) -> Finding:
    """Of the tetrahedra that fill space and are used in meshing, it is the best-conditioned."""
    a, *others = [t.simplex for t in all_types(3) if t.dimension == 3]
    if not all(known(s) < known(a) for known in PAPER_MEASURES for s in others):
        raise CoxeterError("a tetrahedron of another type is better")
    return cited(
        "Naylor, Filling space with tetrahedra, 1999.",
        "It is better, in all four measures, than those of the two other Coxeter triangulations of space.",
    )


@claim("sec1.isosurface", "Section 1.2", WORDING)
def isosurface(printed: Constants) -> Finding:
    """This led to the use of the body-centred cubic lattice in isosurface stuffing."""
    return cited("The paper on isosurface stuffing cited there.")


@lru_cache(maxsize=1)
def _covering() -> dict[str, Fraction]:
    """Squared number of points in a unit of volume, at covering radius 1: bcc, fcc, cubic."""
    a3 = root_system("A3")
    bcc_radius = triangulation("A~3").simplex.squared_circumradius
    fcc_radius = max(
        sum(x * x for x in w) for w in a3.fundamental_coweights.rows()
    )  # the holes are coweights
    return {
        "bcc": bcc_radius**3 / coweight_lattice(a3).gram_determinant,
        "fcc": fcc_radius**3 / root_lattice(a3).gram_determinant,
        "cubic": Fraction(3, 4) ** 3,
    }


@claim("sec1.bcc-covering", "Section 1.2", RESULT, to_state=["sec1.bcc"])
def bcc_covering(printed: Constants) -> Finding:
    """The body-centred cubic lattice ({sparsest}) gives a sparse covering."""
    densities = _covering()
    return agree(
        printed, {"sparsest": min(densities, key=lambda name: densities[name])}, FINITE,
        "Points in a unit of volume, squared, at covering radius 1: "
        + ", ".join(f"{name} {value}" for name, value in densities.items()) + ".",
        "It is the sparsest lattice covering of space at all (Bambah, 1954).",
    )  # fmt: skip


def _least_norm(lattice: Lattice) -> Fraction:
    """The least squared length of a vector of a lattice of rank 3 with a basis of short vectors."""
    combinations_ = RationalMatrix.from_rows([c for c in product(range(-2, 3), repeat=3) if any(c)])
    return min(sum((x * x for x in row), Fraction(0)) for row in (combinations_ @ lattice.basis).rows())


@lru_cache(maxsize=1)
def _shares_of_samples() -> tuple[Surd, Surd]:
    """The samples that bcc needs, as a share of those of the cubic lattice: for a band limit, and for a
    covering."""
    reciprocal = coweight_lattice(root_system("A3")).dual()
    band = reciprocal.gram_determinant / _least_norm(reciprocal) ** 3  # 1 for the cubic lattice
    densities = _covering()
    return sqrt(band), sqrt(densities["bcc"] / densities["cubic"])


@claim("sec1.bcc-samples", "Section 1.2", WORDING, to_state=["sec1.bcc", "sec1.bcc-covering"])
def bcc_samples(printed: Constants) -> Finding:
    """Sampling on the body-centred cubic lattice needs about {percent} % fewer samples than on the cubic
    one, because of this property of the lattice: {reason}."""
    shares = _shares_of_samples()
    band, cover = ((100 - 100 * x).decimal(1) for x in shares)
    true = {"percent": band, "reason": "its reciprocal lattice is a dense packing"}
    finding = agree(
        printed, true, FINITE,
        "A signal whose spectrum lies in a ball needs a lattice whose reciprocal packs such balls. At "
        "least distance 1 the cell of the reciprocal lattice has volume 1 for the cubic lattice and "
        f"${shares[0].latex()}$ for the body-centred one, whose reciprocal is face-centred: "
        f"$1-{shares[0].latex()}$, that is {band} % fewer.",
        f"Coverings of equal radius: $1-{shares[1].latex()}$, that is {cover} % fewer points.",
    )  # fmt: skip
    return explained(
        finding,
        f"The number {band} % belongs to signals with a spectrum in a ball, and comes from the densest "
        "lattice packing, by the reciprocal, face-centred lattice. A comparison of coverings of equal "
        f"radius would give {cover} %",
    )


@lru_cache(maxsize=1)
def _division() -> tuple[int, frozenset[Surd]]:
    """The number of pieces, and the scales at which each is a copy; an error if they do not fill the
    whole."""
    whole = triangulation("A~3").simplex
    v = whole.vertex_matrix.rows()
    middle = {
        (i, j): tuple((a + b) / 2 for a, b in zip(v[i], v[j], strict=True))
        for i, j in permutations(range(4), 2)
    }
    (p, q), (r, s) = whole.longest_edges()
    ring = [middle[p, r], middle[r, q], middle[q, s], middle[s, p]]
    axis = [middle[p, q], middle[r, s]]
    corners = [[v[i], *(middle[i, j] for j in range(4) if j != i)] for i in range(4)]
    pieces = [Simplex(x) for x in (*corners, *([*axis, ring[i - 1], ring[i]] for i in range(4)))]
    if sum((x.volume for x in pieces), Surd(0)) != whole.volume:
        raise CoxeterError("the pieces do not fill the tetrahedron")
    scales = {scale for x in pieces for scale in [_scale(x, whole)] if scale is not None}
    return sum(_scale(x, whole) is not None for x in pieces), frozenset(scales)


def _scale(piece: Simplex, whole: Simplex) -> Surd | None:
    """The factor by which a simplex is a smaller copy of another, or None."""
    square = piece.squared_longest_edge / whole.squared_longest_edge
    a, b = piece.squared_edge_lengths, whole.squared_edge_lengths
    pairs = list(combinations(range(4), 2))
    copies = (all(a[o[i], o[j]] == square * b[i, j] for i, j in pairs) for o in permutations(range(4)))
    return sqrt(square) if any(copies) else None


@claim("sec1.bcc-division", "Section 1.2", RESULT, to_state=["sec1.sommerville"])
def bcc_division(printed: Constants) -> Finding:
    """The tetrahedron of A~3 can be divided into {pieces} copies of itself, scaled by {scale}."""
    pieces, scales = _division()
    (scale,) = scales
    return agree(
        printed, {"pieces": pieces, "scale": str(scale)}, FINITE,
        "Cut off the four corners at the midpoints of the edges. The octahedron that is left is cut into "
        "four around its diagonal between the midpoints of the two longest edges. All eight pieces are "
        "similar to the whole, and their volumes add up to it.",
    )  # fmt: skip


# -- 1.3 --------------------------------------------------------------------------------------------------


@claim("sec1.contribution.explicit", "Section 1.3", WORDING)
def explicit_expressions(printed: Constants) -> Finding:
    """Section 5 has explicit expressions of the measures of all Coxeter triangulations, in all dimensions."""
    cells = {(x.family, x.quantity) for x in paper().formulas if x.place == "Table 2" and x.text}
    everything = {(family, f"normalized_{m}") for family in FAMILIES for m in MEASURES}
    return agree(
        printed, {"all_families": cells >= everything}, FINITE,
        f"Table 2 has an expression for each of the {len(FAMILIES)} families and {len(MEASURES)} measures. "
        "Whether they are right is judged there.",
    )  # fmt: skip


@claim("sec1.contribution.dobkin-table", "Section 1.3", WORDING)
def dobkin_table(printed: Constants) -> Finding:
    """Dobkin and others had a table of the radius ratios up to dimension {last}."""
    last = max(rank for ranks in EXCEPTIONAL.values() for rank in ranks)
    return quoted(
        agree(printed, {"last": last}, LITERATURE),
        "Dobkin, Levy, Thurston and Wilks, Contour tracing by piecewise linear approximations, 1990.",
        f"Dimension {last} is the last with a triangulation that belongs to no infinite family.",
    )


# -- 1.4 --------------------------------------------------------------------------------------------------


@claim("sec1.rate-of-families", "Section 1.4", WORDING, to_state=["def-1"])
def rate_of_families(printed: Constants) -> Finding:
    """The measures of Definition 18 behave, in the four families, as {bound} of d to the power {exponent}."""
    raw, all_equal = _exponents(""), set(_exponents().values())
    finding = _quality_rate(printed, normalised=len(all_equal) == 1 and len(set(raw.values())) > 1)
    powers = ", ".join(f"{m.replace('_', ' ')} {e}" for m, e in raw.items())
    return explained(
        finding,
        f"{_ONLY_UPPER}, for the normalised measures. Those of Definition 18, which are not normalised, "
        f"decay with the exponents {powers} (fatness to the power 1/d).",
    )


@claim("sec1.conjecture-quality", "Section 1.4", RESULT, to_state=["sec1.rate-of-families"])
def quality_conjecture(printed: Constants) -> Finding:
    """Conjecture: no triangulation that fills space has simplices of better quality, in order of d."""
    return conjecture(_comparison("quality"), INSTANCES)


@claim("sec1.relative-protection", "Section 1.4", WORDING, to_state=["sec1.protection"])
def relative_protection(printed: Constants) -> Finding:
    """The relative protection of the triangulation of type A~ is {bound} of d to the power {exponent}."""
    return _protection_rate(printed)


@claim("sec1.conjecture-protection", "Section 1.4", RESULT, to_state=["sec1.relative-protection"])
def protection_conjecture(printed: Constants) -> Finding:
    """Conjecture: no triangulation that fills space has a better relative protection, in order of d."""
    return conjecture(_comparison("protection"), INSTANCES)


@claim("sec1.angles-of-families", "Section 1.4", RESULT, to_state=["def-1"], to_prove=["rem-3"])
def angles_of_families(printed: Constants) -> Finding:
    """In the four infinite families the dihedral angles are {angles} degrees."""
    true = _angles_of([t for t in all_types(12) if t.roots.type.letter in "ABCD"])
    return agree(
        printed, {"angles": true}, EVERY_D, _BY_FAMILY,
        "It is the list of what occurs in the four families together: $\\tilde A_2$ has 60° only, $\\tilde "
        "C_2$ has 45° and 90°, $\\tilde A_d$ from d = 3 on and $\\tilde D_d$ have 60° and 90°.",
    )  # fmt: skip


@claim("sec1.circumcentre", "Section 1.4", RESULT)
def circumcentre(printed: Constants) -> Finding:
    """The circumcentre of the simplices of type A~ lies very far inside."""
    central = all(
        set(t.simplex.circumcentre_coordinates) == {Fraction(1, t.dimension + 1)}
        for t in all_types(24)
        if t.type.letter == "A"
    )
    return agree(
        printed, {"inside": central}, EVERY_D,
        "It is the barycentre, and the centre of the inscribed ball: all barycentric coordinates are "
        "$\\frac1{d+1}$. No point has a greater least coordinate. Computed up to d = 24.",
        "The rotation of the affine diagram, a cycle, is a symmetry of the simplex that permutes its "
        "vertices cyclically; it fixes the circumcentre, and the barycentre alone is fixed by it.",
    )  # fmt: skip
