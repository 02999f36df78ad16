"""Section 1.1: Delaunay triangulations and protection."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import islice

from ..delaunay import delaunay_verdict, mirror_vertices, protection, vertices_by_distance
from ..errors import CoxeterError
from ..exact import Surd, sqrt
from ..families import closed_form
from ..simplex import Simplex
from .claim import Constants, Finding, agree, cited, claim, conjecture
from .instances import of_type
from .section_1_rates import (
    a_is_best,
    comparison,
    formula_is_protection,
    judge_protection,
    protected_families,
)
from .vocabulary import EVERY_D, INSTANCES, LITERATURE, Weight
from .wording import fits, quoted

RESULT, WORDING = Weight.RESULT, Weight.WORDING


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
    for t in of_type("A", 6):
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


@claim(
    "sec1.protection-gives-quality",
    "Section 1.1",
    RESULT,
    to_state=["sec1.protection"],
    to_prove=["thm-8.protected"],
)
def protection_gives_quality(printed: Constants) -> Finding:
    """Protected simplices have good quality."""
    if not a_is_best() or protected_families() != ("A",):
        raise CoxeterError("the protected triangulations are not those of type A")
    return cited(
        "Boissonnat, Dyer and Ghosh, The stability of Delaunay triangulations, 2013.",
        "The protected Coxeter triangulations are those of type A, and in every dimension they are the best "
        "for all four measures.",
    )


@claim("sec1.perturbation-algorithms", "Section 1.1", RESULT, to_state=["sec1.protection"])
def perturbation_algorithms(printed: Constants) -> Finding:
    """Known perturbation algorithms turn a net into a protected one, but guarantee only a protection of the
    order of $2^{-d^2}$ times ε."""
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
    """The triangulation of type A~ is Delaunay, and its protection is {bound}(d^({exponent})) times the
    radius ε of the net."""
    delaunay = all(bool(delaunay_verdict(t)) for t in of_type("A", 12))
    return judge_protection(printed, delaunay=delaunay and formula_is_protection())


@claim("sec1.greatest-protection", "Section 1.1", RESULT, to_state=["sec1.A-protection"])
def greatest_protection(printed: Constants) -> Finding:
    """No Delaunay triangulation of general dimension with a greater protection than that of type A~ is
    known."""
    return conjecture(comparison("protection"), INSTANCES)
