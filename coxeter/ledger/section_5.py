"""Section 5: Theorem 8, the best family, the rates. The cells of the tables are in `tables`."""

from __future__ import annotations

from functools import lru_cache

from ..affine import CoxeterTriangulation, triangulation
from ..claims.core import family_of
from ..claims.decimals import COLUMNS, printed_decimal
from ..delaunay import delaunay_verdict, protection
from ..errors import InvalidInput
from ..exact import sqrt
from ..families import closed_form, evaluate
from ..lattices import vertex_lattice
from ..names import EXCEPTIONAL, MINIMAL_DIMENSION
from ..paper import prose
from ..proofs import prove
from ..simplex import regular_simplex
from .claim import Claim, Constants, Finding, agree, claim, corrected, holds, register, repaired, same
from .records import formula_claims
from .vocabulary import EVERY_D, FINITE, Weight

formula_claims(lambda f: f.place == "Theorem 8")

SECTIONS_6 = tuple(f"sec6.{family}.item-8" for family in ("A", "B", "C", "D", "E6", "E7", "E8", "F4", "G2"))
SINGLE = tuple(f"{letter}{d}" for letter, ranks in EXCEPTIONAL.items() for d in ranks)


@lru_cache(maxsize=1)
def delaunay_families() -> tuple[str, ...]:
    """The infinite families by proof for every d, the others by computation."""
    infinite = tuple(x for x in MINIMAL_DIMENSION if delaunay_verdict(triangulation((x, 5))))
    for letter in MINIMAL_DIMENSION:
        prove("position_of_circumcentre", letter)
    return (*infinite, *(x for x in SINGLE if delaunay_verdict(triangulation((x[0], int(x[1]))))))


@claim("thm-8.delaunay", "Theorem 8", Weight.RESULT, to_state=("def-19",), to_prove=("thm-7", *SECTIONS_6))
def delaunay(printed: Constants) -> Finding:
    """The Delaunay triangulations are those of {families}, and no others."""
    steps = tuple(
        f"{x}~: the level of the circumcentre on the deciding walls, for every d" for x in MINIMAL_DIMENSION
    )
    return agree(printed, {"families": delaunay_families()}, EVERY_D, *steps)


@claim(
    "thm-8.protected",
    "Theorem 8",
    Weight.RESULT,
    to_state=("def-19",),
    to_prove=("thm-7", "lem-12", *SECTIONS_6),
)
def protected(printed: Constants) -> Finding:
    """The triangulations with a positive relative protection are those of {families}, and no others."""
    found = tuple(x for x in delaunay_families() if protection(_member(x)).relative > 0)
    return agree(
        printed, {"families": found}, EVERY_D, "A~: Lemma 12. The others have a circumcentre on a wall"
    )


@claim("thm-8.lattices", "Theorem 8", Weight.RESULT, to_prove=tuple(f"prop-{n}" for n in range(7, 15)))
def lattices(printed: Constants) -> Finding:
    """The vertex sets that are lattices are those of {families}, and no others."""
    for n in (7, 8, 9, 10):
        prove(f"proposition_{n}")
    infinite = tuple(x for x in MINIMAL_DIMENSION if vertex_lattice(triangulation((x, 5))))
    single = tuple(x for x in ("D4", *SINGLE) if vertex_lattice(_member(x)))
    return agree(
        printed,
        {"families": (*infinite, *single)},
        EVERY_D,
        "Propositions 7 to 10 for every d, the rest by cosets",
    )


def _member(family: str) -> CoxeterTriangulation:
    return triangulation((family[0], int(family[1:] or 5)))


@claim("thm-8.protection-rate", "Theorem 8", Weight.RESULT, to_state=("thm-8.relative-protection",))
def protection_rate(printed: Constants) -> Finding:
    """The relative protection of A~_d divided by {constant}·d^({power}) tends to 1."""
    from ..symbolic.radicals_limits import growth

    found = growth(closed_form("A", "relative_protection").pieces[0].text)
    true = {"constant": str(found.coefficient), "power": str(found.degree)}
    finding = agree(printed, true, EVERY_D)
    return finding if not finding.verdict.accepts else holds(EVERY_D, proof=("protection_rate",))


@claim("thm-8.columns", "Theorem 8", Weight.WORDING)
def columns(printed: Constants) -> Finding:
    """Table 2, whose columns are {columns}, presents the four measures and the Delaunay property."""
    missing = {"Fatness", "Aspect Ratio", "Thickness", "Radius Ratio", "Delaunay"} - set(printed["columns"])
    if not missing:
        return holds(FINITE)
    true = (*printed["columns"], *sorted(missing))
    return corrected(
        FINITE, f"Table 2 has no column for: {', '.join(sorted(missing))}; the property stands in item 8 of each family",
        evidence="the theorem lists the Delaunay triangulations itself", constants={"columns": true},
    )  # fmt: skip


@claim("thm-8.unnormalised", "Theorem 8", Weight.WORDING)
def unnormalised(printed: Constants) -> Finding:
    """Section 6 has a table of the values without normalisation."""
    if printed["table"]:
        return holds(FINITE)
    return corrected(
        FINITE, "Section 6 gives these values one by one, in items 6 and 7 of each family, and in no table",
        evidence="our copy has all other tables", constants={"table": True},
    )  # fmt: skip


@claim("sec5.fatness-power", "Section 5", Weight.WORDING, to_state=("def-18.fatness",))
def fatness_power(printed: Constants) -> Finding:
    """The normalised fatness is given to the power {power}."""
    given, ratio = closed_form("C", "normalized_fatness"), closed_form("C", "fatness")
    regular = closed_form("regular", "fatness")
    ds = range(2, 9)
    right = [
        given.at(d) == (ratio.at(d) / regular.at(d)) ** evaluate(printed["power"], d=d).as_fraction()
        for d in ds
    ]
    return holds(FINITE) if all(right) else corrected(FINITE, f"printed {printed['power']}; true: 1/d")


@claim("sec5.regular-does-not-tile", "Section 5", Weight.WORDING)
def regular_does_not_tile(printed: Constants) -> Finding:
    """The regular simplex does not tile space in every dimension."""
    cosine = regular_simplex(3).dihedral_cosine(0, 1)
    between = (sqrt(5) - 1) / 4 < cosine < sqrt(1) / 2  # cos of a fifth and of a sixth of the full angle
    return agree(
        printed, {"monohedral": not between}, FINITE, f"Five tetrahedra leave a gap at an edge: {cosine}"
    )


@claim("sec5.glance", "Section 5", Weight.RESULT, to_state=("tab-3", "tab-4", "tab-5", "tab-6"))
def glance(printed: Constants) -> Finding:
    """In Tables 3 to 6, for d from {first} to {last}, no entry exceeds that of {family}~."""
    if (printed["first"], printed["last"]) != (COLUMNS[0], COLUMNS[-1]):
        raise InvalidInput("the tables have no such columns")
    from ..paper import printed as paper

    for quantity in (
        "normalized_aspect_ratio",
        "normalized_radius_ratio",
        "normalized_fatness",
        "normalized_thickness",
    ):
        for d in COLUMNS:
            cells = {x: printed_decimal(paper(), x, quantity, d) for x in "ABCDEFG" if family_of(x, d)}
            best = cells.get(printed["family"])
            if best is None or any(cell and cell[1] > best[1] for cell in cells.values()):
                return corrected(FINITE, f"for d = {d} another family has a greater {quantity}")
    return holds(FINITE)


def _best(measure: str) -> None:
    name = measure.replace("_", "-")

    def check(printed: Constants) -> Finding:
        first = MINIMAL_DIMENSION["A"]
        if printed["from"] != first:
            return corrected(EVERY_D, f"from d = {first} on")
        return repaired(
            EVERY_D, "by comparison of the closed forms for every d", "the tables end with d = 8; a glance at them shows "
            "nothing for larger d", proof=("best", measure),
        )  # fmt: skip

    register(Claim(
        f"sec5.best.{name}", "Section 5", f"A~ has the greatest {measure.replace('_', ' ')} of all Coxeter triangulations in "
        "every dimension from {from} on, which the tables show at a glance.", Weight.RESULT, check,
        prose()[f"sec5.best.{name}"], ("def-18",), ("sec5.glance", "tab-2"), f"{__name__}._best",
    ))  # fmt: skip


def _rate(letter: str) -> None:
    def check(printed: Constants) -> Finding:
        from ..symbolic.radicals_limits import growth

        measures = ("aspect_ratio", "fatness", "thickness", "radius_ratio")
        found = {m: growth(closed_form(letter, f"normalized_{m}").pieces[-1].text) for m in measures}
        wrong = [m for m, g in found.items() if not same(str(g.degree), printed["power"])]
        if wrong:
            return corrected(EVERY_D, f"printed power {printed['power']}; true: {found[wrong[0]].degree}")
        for m in measures:
            prove("rate", letter, m)
        limits = "; ".join(
            f"{m.replace('_', ' ')}: $\\sqrt d\\,\\hat q \\to {g.coefficient.latex()}$"
            for m, g in found.items()
        )
        return holds(EVERY_D, f"The limits of the normalised measures times $\\sqrt d$ are positive: {limits}",
                     proof=("rate", letter, "thickness"))  # fmt: skip

    register(Claim(
        f"sec5.rate.{letter}", "Section 5", f"All normalised measures of {letter}~_d are of the order d^({{power}}).",
        Weight.RESULT, check, prose()[f"sec5.rate.{letter}"], ("def-18",), (f"tab-2.{letter}",), f"{__name__}._rate",
    ))  # fmt: skip


for _measure in ("aspect_ratio", "fatness", "thickness", "radius_ratio"):
    _best(_measure)
for _letter in MINIMAL_DIMENSION:
    _rate(_letter)
