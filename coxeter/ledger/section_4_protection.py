"""Section 4, second part: Lemmas 5 and 6."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import pairwise

from ..affine import triangulation
from ..names import Type, triangulations_up_to
from ..simplex import Position, Simplex
from .claim import BrokenTool, Constants, Finding, agree, claim, repaired
from .section_4_basics import POWER, WALK, position_of
from .section_4_criterion import monohedral_ones_are_delaunay
from .section_4_geometry import boundary_pairs, power_identity_holds
from .section_4_patches import mirror_powers, powers_in_patch
from .section_4_planes import flattening_rows, half_turn_tilings, least_powers, where
from .vocabulary import EVERY_D, Weight

_LEMMA_5_STEPS = ("lem-5.o-is-c", "lem-5.larger-radius", "lem-5.same-ball", "lem-5.protection-zero")


@claim("lem-5", "Section 4, Lemma 5", Weight.RESULT, to_state=["def-19.protected"], to_prove=_LEMMA_5_STEPS)
def lemma_5(printed: Constants) -> Finding:
    """Let a simplex of largest circumradius have its circumcentre on its boundary.

    Then the Delaunay triangulation of R^d to which it belongs is {protected?protected|not protected}.
    """
    pairs = boundary_pairs()
    if not (pairs and power_identity_holds()):
        raise BrokenTool("identity (P) fails")
    larger = all(p.other_sphere.square > p.sphere.square for p in pairs if not p.share_sphere)
    touched = all(p.sphere.power(p.other) == 0 for p in pairs if p.share_sphere)
    flat = [kind for kind in triangulations_up_to(8) if position_of(kind.affine) is Position.BOUNDARY]
    unprotected = all(0 in mirror_powers(triangulation(kind)) for kind in flat)
    return agree(
        printed,
        {"protected": not (larger and touched and unprotected)},
        EVERY_D,
        *POWER,
        r"Let $\tau$ be a facet that contains $c$, so that $z_c=0$ and $R'^2=R^2+z_{c'}^2$ beyond it. As $R$ "
        r"is the largest, $z_{c'}=0$: both simplices have the same sphere.",
        r"The vertex of $\sigma'$ outside $\tau$ is none of $\sigma$, and its distance from the ball is 0. "
        "It does not matter whether $c$ is on a face of lower dimension. For $d=1$ there is no such case.",
        f"The step was tried on {len(pairs)} pairs of simplices; in {len(flat)} Coxeter triangulations a "
        "mirror vertex lies on the sphere.",
    )


@claim(
    "sec4.converse",
    "Section 4, before Lemma 6",
    Weight.PROOF,
    to_state=["lem-5"],
    to_prove=["lem-6", "thm-6"],
)
def converse(printed: Constants) -> Finding:
    """For monohedral triangulations Lemma 6 gives the converse of Lemma 5.

    If a Delaunay one is not protected, its circumcentres lie on the {where}.
    """
    found = {position_of(kind.affine) for kind in triangulations_up_to(8) if _is_unprotected_delaunay(kind)}
    found |= {t.position for t in half_turn_tilings() if t.least_power == 0}
    return agree(
        printed,
        {"where": found.pop().value if len(found) == 1 else "several places"},
        EVERY_D,
        "Delaunay and monohedral, so self-centred (Theorem 6): the circumcentre is inside or on the "
        "boundary. Inside it gives protection (Lemma 6); without protection it is on the boundary.",
    )


def _is_unprotected_delaunay(kind: Type) -> bool:
    return min(mirror_powers(triangulation(kind))) == 0


# -- Lemma 6 ----------------------------------------------------------------------------------------------

BOUND = (
    *WALK,
    r"Let all circumcentres lie at a distance of at least $t>0$ inside all facets, and let all heights be at "
    r"least $h$; both are attained for congruent simplices. Let $v$ be a vertex that is none of $\sigma$.",
    r"Each crossing lowers the power of $v$ by at least $4t\,|z(v)|$, as $z_c\ge t$ and $z_{c'}\le-t$. At "
    r"the crossing into the first simplex with the vertex $v$ its facet does not contain $v$, so $|z(v)|\ge "
    r"h$.",
    r"So $|v-c|^2\ge R^2+4th$, and the protection is at least $\sqrt{R^2+4th}-R>0$.",
)


def _square_of_bound(simplex: Simplex) -> Fraction:
    """The square of 4·t·h."""
    pairs = zip(simplex.circumcentre_coordinates, simplex.squared_heights, strict=True)
    return 16 * min(x * x * h for x, h in pairs) * min(simplex.squared_heights)


@lru_cache(maxsize=1)
def _bound_holds() -> bool:
    """Whether each protected example keeps the bound 4·t·h, and A~ up to dimension 8 attains it."""
    sharp = []
    for d in range(2, 9):
        t = triangulation(("A", d))
        sharp.append(min(mirror_powers(t)) ** 2 == _square_of_bound(t.simplex))
    tilings = [t for t in half_turn_tilings() if t.position is Position.INSIDE]
    kept = [t.least_power > 0 and t.least_power**2 >= _square_of_bound(Simplex(t.triangle)) for t in tilings]
    near = [min(powers_in_patch(f"A~{d}")) == min(mirror_powers(triangulation(("A", d)))) for d in (2, 3, 4)]
    return bool(kept) and all((*sharp, *kept, *near))


@lru_cache(maxsize=1)
def _flattening() -> tuple[Fraction, ...]:
    """The least powers in the rows 0, 4, … 16 of the flattening stack; all its triangles are acute."""
    stacks = [flattening_rows(n) for n in range(0, 20, 4)]
    acute = all(where(row.triangle) is Position.INSIDE for rows in stacks for row in rows)
    return tuple(least_powers(rows, 3) for rows in stacks) if acute else ()


@lru_cache(maxsize=1)
def _harmonic_protections() -> tuple[Fraction, ...]:
    """The line cut at plus and minus the harmonic numbers: the protections of the segments 2 to 6."""
    sums = [sum((Fraction(1, k) for k in range(1, n + 1)), Fraction(0)) for n in range(9)]
    cuts = sorted({*sums, *(-x for x in sums)})
    return tuple(
        min(abs(x - (a + b) / 2) for x in cuts if x not in (a, b)) - (b - a) / 2
        for a, b in pairwise(sums[1:7])
    )


@claim("lem-6.strict", "Section 4, before Lemma 6", Weight.PROOF, to_state=["def-19.protected"])
def strict_inequalities(printed: Constants) -> Finding:
    """Rajan's argument, its inequalities made strict, yields a protection that is not zero."""
    powers = _flattening()
    positive = bool(powers) and min(powers) > 0
    # With ε = 2^-(n + 1) and R >= 1/2 the protection of row n is at most its power, at most 8ε.
    tends_to_zero = all(p <= Fraction(8, 2 ** (n + 1)) for p, n in zip(powers, range(0, 20, 4), strict=True))
    harmonic = _harmonic_protections()
    if not (positive and tends_to_zero and harmonic == tuple(Fraction(1, n + 1) for n in range(2, 7))):
        raise BrokenTool("the stack of flattening rows does not have the properties it should")
    return repaired(
        EVERY_D,
        "strict inequalities give a positive distance for each vertex and each simplex; for a positive "
        "infimum they must hold with a common margin. Congruence gives one: the protection is at least "
        "$\\sqrt{R^2+4th}-R$ (Lemma 6)",
        _strict_in_words(harmonic, powers),
        derivation=(
            r"With $\varepsilon_n=2^{-|n|-1}$ and $n\ge1$ the circumcentre of a triangle of row $n$ lies at "
            r"the height $z=\frac{\varepsilon_n+\varepsilon_n^2}{1+2\varepsilon_n}\le\varepsilon_n$ over its "
            "base, and the apex below the base has the power "
            r"$\varepsilon_{n-1}+\varepsilon_{n-1}^2+(1+2\varepsilon_{n-1})z\le8\varepsilon_n$.",
            r"$\delta=\sqrt{R^2+\operatorname{pow}}-R\le\operatorname{pow}/2R\le\operatorname{pow}$, as "
            r"$R\ge\frac12$.",
            "The triangulation is locally finite and covers the plane; it is not monohedral, so this does "
            "not touch Lemma 6 itself, only the step to it.",
            *BOUND,
        ),
    )


def _strict_in_words(harmonic: tuple[Fraction, ...], powers: tuple[Fraction, ...]) -> str:
    """The witnesses: all circumcentres strictly inside, protection zero."""
    return (
        "cut the line at $\\pm(1+\\frac12+\\dots+\\frac1n)$ for all $n$: every segment has its midpoint "
        f"inside, and the protection $\\frac1{{n+1}}$ of the $n$-th ({', '.join(map(str, harmonic))}, …) "
        "tends to 0. In the plane, with simplices of bounded size and shape, take rows of isosceles "
        "triangles with base 1 and, in row $n\\in\\mathbb Z$, height $\\frac12+2^{-|n|-1}$, apexes under "
        "bases: every triangle is acute, but the least powers of other vertices in the rows 0, 4, 8, 12, 16 "
        f"are {', '.join(map(str, powers))}: they tend to 0. So the infimum of positive distances, the "
        "protection, is 0"
    )


@claim("lem-6", "Section 4, Lemma 6", Weight.RESULT, to_state=["def-19.protected"], to_prove=["lem-6.strict"])
def lemma_6(printed: Constants) -> Finding:
    """Let a simplex of a monohedral triangulation of R^d have its circumcentre strictly inside. Then the
    triangulation {delaunay?is|need not be} Delaunay, and its protection {protected?is|need not be} positive.
    """
    truth = {"delaunay": monohedral_ones_are_delaunay(), "protected": _bound_holds()}
    found = agree(printed, truth, EVERY_D)
    if not found.verdict.accepts:
        return found
    powers = _flattening()
    return repaired(
        EVERY_D,
        r"with $t>0$ the least distance of the circumcentre from a facet and $h$ the least height, every "
        r"other vertex has $|v-c|^2\ge R^2+4th$; so the protection is at least $\sqrt{R^2+4th}-R$. Equality "
        r"in $\tilde A_d$, where the circumcentre is the incentre",
        "strict inequalities alone do not keep an infimum over infinitely many simplices from 0: for rows of "
        f"acute triangles that flatten out, the least powers fall like {', '.join(map(str, powers))} …",
        derivation=(
            *BOUND,
            r"For $\tilde A_d$ the bound is attained; checked exactly for $2\le d\le8$. Tilings of the plane "
            "by acute triangles keep it.",
        ),
    )
