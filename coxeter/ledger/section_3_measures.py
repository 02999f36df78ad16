"""Section 3: the quality measures and the regular simplex."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache, partial

from ..families import evaluate
from ..quality import MEASURES, PAPER_MEASURES
from ..simplex import Simplex
from .claim import Constants, Finding, agree, claim, corrected, fails, holds
from .instances import all_types, is_regular, of_type
from .section_3_identities import ASPECT_RATIO, FATNESS, RADIUS_RATIO, THICKNESS, identities
from .section_3_samples import NAMES, greatest, measured, normalised, rivals, squeezed, values_towards_zero
from .vocabulary import EVERY_D, INSTANCES, Weight, up_to
from .wording import told

# -- Definition 18 ----------------------------------------------------------------------------------------


def judge_definition(measure: str, printed: Constants) -> Finding:
    """Whether the formula says what the words say; both are evaluated on the same simplices."""
    formula = printed["formula"]
    for sizes, simplex in measured():
        in_words = sizes.in_words()[measure]
        value = evaluate(formula, **sizes.letters())
        if not value == in_words == MEASURES[NAMES[measure]](simplex):
            return corrected(
                INSTANCES,
                f"for one simplex of dimension {sizes.d} the words give {in_words}, the formula {value}",
            )
    return holds(
        EVERY_D,
        "A definition: for a simplex all five lengths are positive, so the quotient exists.",
        "Numerator and denominator scale alike, so that similar simplices have the same value.",
        f"Words, formula and library agree on {len(measured())} simplices of dimension 1 to 5, whose lengths "
        "were found twice: from volumes of facets, and from the Gram matrix.",
    )


@claim("def-18", "Section 3, Definition 18", Weight.RESULT)
def measures(printed: Constants) -> Finding:
    """The {number:words} measures considered are aspect ratio, fatness, thickness and radius ratio."""
    scaled = all(
        normalised(name, Simplex([[3 * x for x in v] for v in simplex.vertex_matrix.rows()]))
        == normalised(name, simplex)
        for name in NAMES
        for _, simplex in measured()[:6]
    )
    if not scaled:
        return fails(INSTANCES, "a measure changes with the size of a simplex", "nothing")
    return agree(
        printed,
        {"number": len(PAPER_MEASURES)},
        EVERY_D,
        "Definitions; each has the same value for similar simplices. The library has the same four.",
    )


for _name, _words in {
    "aspect ratio": "the least height over the diameter of the circumscribed ball",
    "fatness": "the volume over the d-th power of the longest edge",
    "thickness": "the least height over the longest edge",
    "radius ratio": "the radius of the inscribed over that of the circumscribed ball",
}.items():
    claim(
        f"def-18.{_name.replace(' ', '-')}",
        "Section 3, Definition 18",
        Weight.RESULT,
        words=f"The {_name} is {_words}: {{formula}}.",
    )(partial(judge_definition, _name))


# -- Theorem 5 --------------------------------------------------------------------------------------------


PROOFS = {
    "aspect ratio": ("lem-9", ASPECT_RATIO),
    "fatness": ("lem-11", FATNESS),
    "thickness": ("lem-10", THICKNESS),
    "radius ratio": ("lem-8", RADIUS_RATIO),
}
"""For each measure the lemma that the paper uses, and our proof."""


def judge_greatest(measure: str, printed: Constants) -> Finding:
    """No rival exceeds the regular simplex, and each identity of the proof holds on the samples."""
    if not identities()[measure]:
        return fails(INSTANCES, f"an identity in the proof for the {measure} is false", "nothing")
    tried = f"{len(rivals())} simplices that might have refuted it, exactly: the greatest value is 1."
    return agree(printed, {"greatest": greatest(measure)}, EVERY_D, *PROOFS[measure][1], tried)


for _name, (_lemma, _) in PROOFS.items():
    claim(
        f"thm-5.{_name.replace(' ', '-')}",
        "Section 3, Theorem 5",
        Weight.RESULT,
        words=f"The greatest {_name} of a d-simplex is that of the regular one: {{greatest}} when divided by "
        "it.",
        to_state=[f"def-18.{_name.replace(' ', '-')}"],
        to_prove=[_lemma],
    )(partial(judge_greatest, _name))

_THEOREM_5 = tuple(f"thm-5.{name.replace(' ', '-')}" for name in PROOFS)


@claim(
    "thm-5",
    "Section 3, Theorem 5",
    Weight.RESULT,
    to_state=["def-18"],
    to_prove=_THEOREM_5,
)
def theorem_5(printed: Constants) -> Finding:
    """In all {number:words} measures of Definition 18 the regular d-simplex has the greatest value of any
    d-simplex."""
    best = [name for name in NAMES if greatest(name) == 1 and identities()[name]]
    return agree(
        printed,
        {"number": len(best)},
        EVERY_D,
        "Each of the four is proved for every $d$ in its own claim, without anything cited.",
    )


# -- normalisation ----------------------------------------------------------------------------------------


@claim("sec3.normalisation", "Section 3, after Theorem 5", Weight.RESULT, to_prove=_THEOREM_5)
def normalisation(printed: Constants) -> Finding:
    """Dividing a measure by its greatest value is dividing it by its value for the regular simplex.

    The regular simplex then has the value {regular} in each measure.
    """
    at_regular = {normalised(m, squeezed(d, Fraction(1))) for m in NAMES for d in range(1, 7)}
    if len(at_regular) != 1 or max(greatest(m) for m in NAMES) not in at_regular:
        return fails(INSTANCES, "the regular simplex does not have the greatest value", "nothing")
    return agree(
        printed,
        {"regular": at_regular.pop()},
        EVERY_D,
        "By Theorem 5 the greatest value of a measure is that of the regular simplex; as similar simplices "
        "have the same value, it does not matter which regular simplex is taken.",
    )


@lru_cache(maxsize=1)
def _values_taken() -> dict[str, object]:
    """From which d on all values between 0 and 1 are taken, and whether the ends are."""
    segments = {normalised(m, s) for m in NAMES for s in rivals() if s.dimension == 1}
    squeezing_works = all(values_towards_zero().values())
    none_is_zero = all(s.gram_determinant > 0 for s in rivals())  # so volume, heights and inradius are not 0
    regular_reaches_one = all(greatest(m) == 1 for m in NAMES)
    first = 2 if segments == {1} and squeezing_works else 1
    return {"ends": (0, 1), "taken": (not none_is_zero, regular_reaches_one), "from_d": first}


@claim(
    "sec3.range",
    "Section 3, after Theorem 5",
    Weight.WORDING,
    to_state=["sec3.normalisation"],
    to_prove=_THEOREM_5,
)
@told
def range_of_values(printed: Constants) -> Finding:
    """From d = {from_d} on the values of the normalised measures are exactly those between {ends:and},
    {taken:ends}."""
    if not all(values_towards_zero().values()):
        return fails(INSTANCES, "squeezing does not bring a measure near 0", "nothing")
    found = agree(printed, _values_taken(), EVERY_D)
    if found.verdict.accepts:
        return holds(EVERY_D, *_RANGE)
    return corrected(
        EVERY_D,
        "each normalised measure takes exactly the values of the half-open interval $(0,1]$ if $d\\ge2$, and "
        "only the value 1 if $d=1$; 0 is only approached",
        witness="a value 0 needs a height, an inradius or a volume 0: such points are no simplex; "
        "for $d=1$ every segment is regular",
        derivation=_RANGE,
        constants={**printed, **_values_taken()},
    )


_RANGE = (
    "Not above 1: Theorem 5. Not 0: the heights, the inradius and the volume of a simplex are positive.",
    r"All of $(0,1]$ for $d\ge2$: multiply one height of the regular simplex of edge $\sqrt2$ by "
    r"$t\in(0,1]$. The opposite facet is kept, so $L\ge\sqrt2$ and $2R\ge L$; and $h\le t\sqrt{(d+1)/d}$, "
    r"$2r\le h$, $\operatorname{vol}=t\operatorname{vol}(\Delta)$.",
    r"Hence $\hat\theta\le t$, $\hat\Theta\le t$, $\hat\alpha\le t\sqrt{2d/(d+1)}$ and "
    r"$\hat\rho\le t\sqrt{d(d+1)/2}$, all at most $d\,t$. The measures depend continuously on $t$, are 1 at "
    "$t=1$ and tend to 0, so each takes every value between.",
    "For $d=1$ all simplices are similar. The bounds were checked exactly for $d=2,\\dots,6$.",
)


# -- the emphasis on A~ -----------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _what_singles_out_a() -> tuple[tuple[int, ...], bool]:
    """The d up to 8 for which the simplex of A~_d is regular; whether A~_d is best among Coxeter's."""
    regular = tuple(t.dimension for t in of_type("A", 8) if is_regular(t.simplex))
    best = all(
        max((normalised(m, t.simplex), t.type.letter == "A") for t in all_types(8) if t.dimension == d)[1]
        for m in NAMES
        for d in range(2, 9)
    )
    return regular, best


@claim("sec3.emphasis", "Section 3, after Theorem 5", Weight.WORDING, to_state=_THEOREM_5)
@told
def emphasis(printed: Constants) -> Finding:
    """That the literature stresses A~ is justified by Theorem {theorem}."""
    regular, best = _what_singles_out_a()
    theorem = 8 if regular == (2,) and best else 5
    found = agree(printed, {"theorem": theorem}, up_to(8))
    lines = (
        f"For $2\\le d\\le8$ the simplex of A~ is regular for d = {', '.join(map(str, regular))} only: about "
        "the others Theorem 5, on regular simplices, says nothing.",
        "What singles A~ out is that among the Coxeter triangulations of its dimension it is the best in "
        f"each measure; computed for $2\\le d\\le8$: {'yes' if best else 'no'}. That is Theorem 8 with its "
        "tables; Theorem 5 only provides the yardstick.",
    )
    if found.verdict.accepts:
        return holds(up_to(8), *lines)
    return corrected(
        up_to(8),
        "it is the comparison in Theorem 8 that justifies it: Theorem 5 is about the regular simplex, which "
        "is that of A~ only in the plane",
        witness="A~3: its edges have two lengths",
        derivation=lines,
        constants={"theorem": theorem},
    )
