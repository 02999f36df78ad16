"""Whether an affine image is locally optimal: proved, refuted or undecided (the reason is in `images`)."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from ..errors import InvalidInput
from ..exact import Surd, rational
from ..quality import PAPER_MEASURES, Measure
from .images import AffineImage


class Verdict(Enum):
    """Whether an affine image is locally optimal among all affine images of the same triangulation."""

    PROVED = "locally optimal"
    REFUTED = "not locally optimal"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Optimality:
    """A verdict with its reason.

    Attributes
    ----------
    verdict
        Proved, refuted or undecided.
    value
        The quality of the image.
    best
        That of the Coxeter triangulation itself; None if it says nothing about the verdict.
    witness
        If refuted: a strictly better image close by, on the way to the mean.
    """

    verdict: Verdict
    value: Surd
    best: Surd | None = None
    witness: AffineImage | None = None


def local_optimality(image: AffineImage, measure: str | Measure[Surd], near: object = "1/1000") -> Optimality:
    """Whether an affine image is locally optimal in a measure: proved, refuted by a witness, or undecided.

    By the argument at the head of `images` it is, if and only if it is as good as the Coxeter
    triangulation. If it is not, all images on the way to the mean are better; the witness is at a share
    `near` of the way, and is compared exactly. So it is with ``"relative_protection"``, in type A~, for
    images that are Delaunay. Of other measures than these and the four of Definition 18 it is not known
    whether they are quotients of a concave and a convex function, and the verdict is `Verdict.UNDECIDED`.

    Raises
    ------
    InvalidInput
        If there is no such measure, or the share is not in (0, 1].

    Examples
    --------
    >>> from coxeter import Simplex
    >>> from coxeter.optimality import affine_image
    >>> local_optimality(affine_image("A~3"), "fatness").verdict
    <Verdict.PROVED: 'locally optimal'>
    >>> kuhn = affine_image("A~3", Simplex([(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)]))
    >>> found = local_optimality(kuhn, "fatness")
    >>> found.verdict, found.witness.quality("fatness") > found.value
    (<Verdict.REFUTED: 'not locally optimal'>, True)
    """
    if not 0 < rational(near) <= 1:
        raise InvalidInput(f"{near!r} is no share of the way: give a rational number above 0, up to 1")
    value = _value(image, measure)
    if not _applies(image, measure):
        return Optimality(Verdict.UNDECIDED, value)
    best = _value(image.mean, measure)
    if value == best:
        return Optimality(Verdict.PROVED, value, best)
    witness = image.towards_mean(near)
    if not value < _value(witness, measure) <= best:
        raise ArithmeticError(f"{measure}: the quality does not grow towards the mean of {image!r}")
    return Optimality(Verdict.REFUTED, value, best, witness)


def _applies(image: AffineImage, measure: str | Measure[Surd]) -> bool:
    """Whether the argument reaches the measure."""
    if measure == "relative_protection":
        return image.least_weight >= 0
    return measure in PAPER_MEASURES or measure in {known.name for known in PAPER_MEASURES}


def _value(image: AffineImage, measure: str | Measure[Surd]) -> Surd:
    return image.relative_protection if measure == "relative_protection" else image.quality(measure)
