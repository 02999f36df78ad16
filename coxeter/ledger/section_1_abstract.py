"""The abstract."""

from __future__ import annotations

from functools import lru_cache

from .claim import Constants, Finding, agree, claim, conjecture
from .instances import all_types
from .section_1_rates import (
    bounds_for_all,
    comparison,
    formula_is_protection,
    judge_protection,
    judge_quality,
    protected_families,
    protection_exponent,
    quality_exponent,
)
from .vectors import mean
from .vocabulary import EVERY_D, INSTANCES, Weight
from .wording import explained, fits

RESULT, WORDING = Weight.RESULT, Weight.WORDING


@lru_cache(maxsize=1)
def _folds_back() -> bool:
    """Whether far points are carried into the fundamental simplex, and back again, by its reflections."""
    return all(
        fold.word and min(fold.barycentric) >= 0 and t.unfold(fold.word, fold.point) == point
        for t in all_types(4)
        for point in [tuple(7 * x for x in mean(t.simplex.vertex_matrix.rows()))]
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


@claim("sec1.abstract.quality-rate", "Abstract", WORDING, to_state=["def-1"])
def quality_rate(printed: Constants) -> Finding:
    """The quality of the simplices of every Coxeter triangulation is {bound}(d^({exponent})) times that of
    the regular simplex."""
    return explained(judge_quality(printed), bounds_for_all())


@claim("sec1.abstract.protection-rate", "Abstract", WORDING)
def protection_rate(printed: Constants) -> Finding:
    """A protection of {bound}(d^({exponent})) is achieved by {families:words} family of triangulations."""
    return judge_protection(printed, families=len(protected_families()) if formula_is_protection() else 0)


@claim("sec1.abstract.conjecture", "Abstract", RESULT)
def both_conjectures(printed: Constants) -> Finding:
    """Conjecture: in space of any dimension no triangulation has a quality of better order than
    d^({quality_exponent}), or a protection of better order than d^({protection_exponent})."""
    true = {"quality_exponent": quality_exponent(), "protection_exponent": protection_exponent()}
    finding = agree(printed, true, EVERY_D)
    if not finding.verdict.accepts:
        return finding
    return conjecture(comparison("quality, protection"), INSTANCES)
