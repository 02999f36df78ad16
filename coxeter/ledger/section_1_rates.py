"""How fast quality and protection fall with d: what the abstract and Sections 1.1 and 1.4 say of it."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from ..affine import triangulation
from ..delaunay import protection
from ..errors import CoxeterError, InvalidInput
from ..exact import Surd
from ..families import closed_form
from ..names import MINIMAL_DIMENSION
from ..optimality import A15, C15
from ..proofs import prove
from ..proofs.images import affine_images
from ..quality import PAPER_MEASURES, find_measure
from .claim import Constants, Finding, agree
from .instances import all_types, of_type
from .vocabulary import EVERY_D
from .wording import explained

MEASURES = tuple(known.name for known in PAPER_MEASURES)
LARGEST = 16
"""The values of all measures are computed up to this dimension."""


# -- quality ----------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _values() -> dict[tuple[str, str], Surd]:
    """The values d·κ² of all normalised measures of all triangulations up to d = 16, by name and measure."""
    return {
        (t.name, m): find_measure(m).normalized(t.simplex) ** 2 * t.dimension
        for t in all_types(LARGEST)
        for m in MEASURES
    }


@lru_cache(maxsize=1)
def _within_band() -> bool:
    """Whether d·κ² lies in [1/2, 8) for all normalised measures of the four families up to d = 16."""
    return all(2 * x >= 1 and x < 8 for (name, _), x in _values().items() if name[0] in MINIMAL_DIMENSION)


@lru_cache(maxsize=1)
def band_for_every_d() -> bool:
    """The same for every d, for the measures whose squares are rational functions over QQ(√2)."""
    from ..proofs.best import SQUARES
    from ..symbolic.cases import case

    for squares in SQUARES.values():
        for family, found in squares.items():
            range_ = case("4 <= d" if family in "BD" else "2 <= d")
            for square in (found,) if isinstance(found, str) else found:
                if not (range_.nonnegative(f"d*({square}) - 1/2") and range_.positive(f"8 - d*({square})")):
                    return False
    return True


@lru_cache(maxsize=1)
def bounds_for_all() -> str:
    """Between what all Coxeter triangulations lie, in words: the four families lie in the band for every d.

    So the least value d·κ² of all is that of an exceptional type, if that is less than 1/2; and if none is 8
    or more, that is a bound for all.
    """
    (name, m), least = min(_values().items(), key=lambda entry: entry[1])
    if least >= Fraction(1, 2) or max(_values().values()) >= 8:
        raise InvalidInput(
            f"the least value is {least}, of {name}: the band of the four families is not left"
        )
    lower = least.root(2).as_fraction()
    return (
        "O gives an upper bound, which any bad triangulation satisfies. What is meant, and true, is the "
        f"exact order: for all Coxeter triangulations quality lies between $\\frac{{{lower.numerator}}}"
        f"{{{lower.denominator}\\sqrt d}}$, which the {m.replace('_', ' ')} of {name} attains, and "
        "$\\frac{\\sqrt8}{\\sqrt d}$ (fatness being taken to the power 1/d)."
    )


@lru_cache(maxsize=1)
def _quality() -> tuple[str, ...]:
    """How the order of the normalised measures is known."""
    return (
        "For every d and every normalised measure $\\hat\\kappa$ of the four families (fatness to the power "
        "1/d) $\\tfrac12\\le d\\,\\hat\\kappa^2<8$, so it is of the exact order $1/\\sqrt d$. By the closed "
        "forms:",
        "$\\tilde A_d$: $d\\hat\\alpha^2=d\\hat\\rho^2=\\frac{6d^2}{(d+1)(d+2)}$; "
        "$d\\hat\\theta^2=\\frac{4d^2}{(d+1)^2}$ or $\\frac{4d}{d+2}$; fatness $\\frac{8d}{(d+1)^{1+2/d}}$ "
        "or $\\frac{8(d+1)^{1-2/d}}{d+2}$, and $1\\le(d+1)^{2/d}\\le3$.",
        "$\\tilde B_d,\\tilde C_d,\\tilde D_d$: $d\\hat\\theta^2=\\frac d{d+1}$; "
        "$d\\hat\\alpha^2=\\frac{2d^3}{(d+1)^2(d+c)}$ with c = 2, 0, 4; fatness $2\\,(c/(d+1))^{1/d}$ with "
        "c = 4, 1, 16; the radius ratio likewise. For $\\tilde B_3$ thickness and fatness are $\\frac9{16}$ "
        "and $\\frac32$.",
        f"Limits of $\\sqrt d\\,\\hat\\kappa$ for {', '.join(x.replace('_', ' ') for x in MEASURES)}, by the "
        f"leading terms: {'; '.join(_limits(family) for family in MINIMAL_DIMENSION)}.",
        "Decided for every d by the signs of coefficients: the band for aspect ratio, thickness and radius "
        f"ratio. Computed: the band for all d up to {LARGEST}.",
    )


def _limits(family: str) -> str:
    """The limits of the measures of a family times the root of d."""
    from ..proofs.rates import constant

    return f"${', '.join(constant(family, m).latex() for m in MEASURES)}$ for $\\tilde {family}$"


FACTORIAL_BOUNDS = ("(d**d)", "((d/3)**d)")
"""n! lies between these: by induction, as (1 + 1/n)^n < 3."""


def _exponent(form: str, family: str) -> Fraction:
    """The e for which a closed form is of the exact order d^e; fatness is taken to the power 1/d."""
    from ..symbolic.radicals_limits import growth

    found = set()
    for piece in closed_form(family, form).pieces:
        if piece.high is None and form == "fatness":  # a factorial, so between two powers
            bounds = (piece.text.replace("factorial(d)", x) for x in FACTORIAL_BOUNDS)
            found |= {growth(f"({text})**(1/d)").degree for text in bounds}
        elif piece.high is None:
            found.add(growth(piece.text).degree)
    if len(found) != 1:
        raise InvalidInput(f"the {form} of {family}~ is not of one order: {found}")
    return found.pop()


@lru_cache(maxsize=2)
def exponents(prefix: str = "normalized_") -> dict[str, Fraction | None]:
    """The exponent of each measure in the four families, None if it is not the same in all."""
    by_measure = {m: {_exponent(prefix + m, family) for family in MINIMAL_DIMENSION} for m in MEASURES}
    return {m: found.pop() if len(found) == 1 else None for m, found in by_measure.items()}


def quality_exponent() -> str:
    """That of all normalised measures in all four families."""
    (common,) = set(exponents().values())
    return str(common)


def judge_quality(printed: Constants, **more: object) -> Finding:
    """Judge a statement on the order of the normalised measures."""
    true = {
        "bound": "Theta" if _within_band() and band_for_every_d() else "O",
        "exponent": quality_exponent(),
        **more,
    }
    return agree(printed, true, EVERY_D, *_quality())


ONLY_UPPER = (
    "O gives an upper bound, which any bad triangulation satisfies. What is meant, and true, is that "
    "quality is of the exact order: it lies between $\\frac1{\\sqrt{2d}}$ and $\\frac{\\sqrt8}{\\sqrt d}$"
)


# -- protection -------------------------------------------------------------------------------------------


def protection_exponent() -> str:
    """That of the relative protection of A~."""
    return str(_exponent("relative_protection", "A"))


def judge_protection(printed: Constants, **more: object) -> Finding:
    """Judge a statement on the order of the protection of A~."""
    finding = agree(
        printed, {"bound": "Theta", "exponent": protection_exponent(), **more}, EVERY_D,
        "$\\hat\\delta=\\sqrt{1+x}-1$ with $x=\\frac{24}{d(d+2)}$, as the nearest other vertices are at "
        "squared distance $R^2+\\frac2{d+1}$ from the circumcentre and $R^2=\\frac{d(d+2)}{12(d+1)}$.",
        "R, the greatest distance of a point from the vertices, is the ε of the net that they are.",
        "$\\frac x2-\\frac{x^2}8<\\sqrt{1+x}-1<\\frac x2$ for $x>0$, so $d^2\\,\\hat\\delta\\to12$.",
        "Computed: the formula against the nearest vertices up to d = 12. The exponent is that of its "
        "leading terms.",
    )  # fmt: skip
    return explained(
        finding,
        "A small upper bound is no merit of a protection. What is meant, and true, is the exact order: "
        "$d^2\\,\\hat\\delta\\to12$ for the relative protection $\\hat\\delta=\\delta/R$",
    )


@lru_cache(maxsize=1)
def formula_is_protection() -> bool:
    """Whether the closed form is what the core computes for A~ up to d = 12."""
    form = closed_form("A", "relative_protection")
    return all(protection(t).relative == form.at(t.dimension) for t in of_type("A", 12))


@lru_cache(maxsize=1)
def protected_families() -> tuple[str, ...]:
    """The families with a protected triangulation up to d = 12."""
    return tuple(sorted({t.type.family for t in all_types(12) if protection(t)}))


# -- the conjectures --------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def a_is_best() -> bool:
    """Whether A~ has the highest normalised measures, proved for every d, and computed up to d = 8; and the
    highest protection."""
    best = all(prove("best", known.name).replay(2) for known in PAPER_MEASURES)
    for d in range(2, 9):
        a, *others = [t for t in all_types(8) if t.dimension == d]
        best &= all(known(t.simplex) < known(a.simplex) for known in PAPER_MEASURES for t in others)
        best &= all(protection(t).relative < protection(a).relative for t in others)
    return best


@lru_cache(maxsize=1)
def _beyond_in_quality() -> str:
    tries = [affine_images(m.name).replay(2) for m in PAPER_MEASURES]  # raises an error where a proof fails
    home = triangulation("A~3").simplex
    better = {
        m.name.replace("_", " "): [c.name for c in (A15, C15) if c.quality(m) > m(home)]
        for m in PAPER_MEASURES
    }
    found = ", ".join(f"{' and '.join(names)} in {name}" for name, names in better.items() if names)
    if not (all(tries) and found) or all(better.values()):
        raise CoxeterError("a proof was not tried, or crystals are better than A~3 in no measure or in all")
    return (
        "No affine image of a Coxeter triangulation is better than $\\tilde A_d$, for every d. In the plane "
        "its triangles are regular, so none are better. In space crystals are better than $\\tilde A_3$: "
        f"{found}, but none in all measures. That is one dimension, and says nothing of the order in d."
    )


@lru_cache(maxsize=1)
def _beyond_in_protection() -> str:
    if not affine_images("relative_protection").replay(2):
        raise CoxeterError("the proof was not tried")
    return (
        "No affine image of $\\tilde A_d$ is better protected, for every d, and no lattice in the plane "
        "or in space."
    )


def comparison(what: str) -> str:
    """What was tried on a conjecture."""
    if not a_is_best():
        raise CoxeterError("another Coxeter triangulation is better than that of type A")
    tried = {
        "quality": ("that of type A is strictly the best for all four measures", _beyond_in_quality),
        "protection": ("that of type A is the only protected one", _beyond_in_protection),
    }
    among, beyond = zip(*(tried[word] for word in what.split(", ")), strict=True)
    parts = [
        f"Among Coxeter triangulations, in every dimension, {', and '.join(among)}.",
        *(say() for say in beyond),
    ]
    return " ".join([*parts, "Others were not searched."])
