"""A~ is better than all affine images of all Coxeter triangulations, in every dimension. Paper: Section 1.4.

The convexity is argued in words, and tried on exact examples; the comparison of the families is decided.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import partial
from itertools import pairwise

from ..exact import RationalMatrix, Surd
from ..names import triangulations_up_to
from ..optimality.images import AffineImage, affine_image, reflections, simplex_of_gram
from ..quality import find_measure
from .appendix_c import relative_protection
from .best import best
from .proof import Proof, ReplayFailed, Step, argument, join, tested

LARGEST = 3
"""The words are tried on examples up to this dimension."""

QUOTIENTS = {
    "aspect_ratio": ("4\\alpha^2 = h^2/R^2", "h", "R"),
    "fatness": ("(d!\\,\\Theta)^{2/d} = \\det(Q)^{1/d}/L^2", "det", "L"),
    "thickness": ("\\theta^2 = h^2/L^2", "h", "L"),
    "radius_ratio": ("\\rho^2 = r^2/R^2", "r", "R"),
    "relative_protection": ("(1 + \\hat\\delta)^2 - 1 = \\pi/R^2", "power", "R"),
}
"""The measures as increasing functions of quotients f/g, which are named here."""

REASONS = {
    "h": "the squared height over a facet is the least $Q(u_k - y)$ of all $y$ in its plane, and $h^2$ the "
    "least of these: concave",
    "r": "$r = 1/\\sum 1/h_k$, so $r^2$ is up to a factor the power mean of the $h_k^2$ with exponent "
    "$-\\frac12$, which is concave and grows with each of them: concave",
    "det": "$\\det(Q)^{1/d}$ is concave, by Minkowski",
    "power": "the power $\\pi$ of a vertex over the sphere of a simplex is linear in Q, as with its "
    "barycentric coordinates $\\mu_i$ it is $-\\sum_{i<j}\\mu_i\\mu_j\\,Q(u_i - u_j)$; the least is concave",
    "L": "each $Q(u_i - u_j)$ is linear in Q, so $L^2$, the greatest, is convex",
    "R": "$R^2$ is the greatest $\\sum_{i<j}\\lambda_i\\lambda_j\\,Q(u_i - u_j)$ of all real $\\lambda$ with "
    "sum 1, as that is $R^2 - Q(c - \\sum\\lambda_i u_i)$: convex",
}


def affine_images(measure: str) -> Proof:
    """A~ has a greater quality than each affine image of a Coxeter triangulation that is not similar to it.

    For ``"relative_protection"``: than each image of A~ itself.

    >>> affine_images("thickness").replay(3) > 0
    True
    """
    protection = measure == "relative_protection"
    name = measure.replace("_", " ")
    whom = r"its own triangulation" if protection else r"all Coxeter triangulations of $\mathbb R^d$"
    return join(
        rf"$\tilde A_d$ has the greatest {name} of all affine images of {whom}, for every $d \geq 2$, and "
        "each other image that is as good is similar to it",
        _quasi_concave(measure),
        _mean(measure),
        _alone(measure),
        relative_protection().steps if protection else best(measure).steps,
    )


def _quasi_concave(measure: str) -> Iterator[Step]:
    quotient, above, below = QUOTIENTS[measure]
    yield argument(
        rf"An affine map with linear part $M$ makes $Q = M^\mathsf{{T}}M$ of the scalar product. In the "
        rf"metric of Q, for a simplex with vertices $u_i$: ${quotient}$, a quotient $f/g$ of functions "
        rf"of Q that are homogeneous of degree 1"
    )
    yield argument(f"$f$: {REASONS[above]}")
    yield argument(f"$g$: {REASONS[below]}")
    if measure == "relative_protection":
        yield argument(
            r"Where some power is negative, the image is not Delaunay, and $\hat\delta = 0$; the others are "
            "a convex cone of forms"
        )
    yield argument(
        r"So if $f \geq s\,g$ for two forms, $s \geq 0$, it holds for their sum. The same is true of "
        r"the quality of the whole image, the least value over its simplices"
    )
    if measure != "relative_protection":
        yield tested(
            "the sum of two forms", r"\kappa(Q + Q') \geq \min(\kappa(Q), \kappa(Q'))", 2 * LARGEST,
            partial(_sums, measure),
        )  # fmt: skip


def _mean(measure: str) -> Iterator[Step]:
    yield argument(
        r"The finite Weyl group W maps the triangulation to itself up to translation, so Q and $Q \circ w$ "
        r"have the same quality, and the mean over W has at least that. It is invariant under W, which is "
        "irreducible: a multiple of the scalar product. So no image is better than the triangulation itself"
    )
    words, formula = (
        "the mean over W, and its quality",
        r"\kappa(\tfrac{1}{|W|}\sum Q \circ w) \geq \kappa(Q)",
    )
    yield tested(words, formula, LARGEST, partial(_means, measure))


def _alone(measure: str) -> Iterator[Step]:
    if measure == "fatness":
        yield argument(
            r"If Q is as good, so are all $Q \circ w$, and equality in Minkowski's inequality makes them "
            "proportional, hence Q a multiple of its mean"
        )
    elif measure == "relative_protection":
        yield argument(
            r"If Q is as good, all inequalities are equalities. For two neighbours $\pi = 2 p_{ij}$, with "
            r"$p_{ij} = -\langle b_i, b_j\rangle$ for the steps $b_i$ of the paths that the simplices "
            r"are. At the mean all are equal, so for each $Q \circ w$ all those of a simplex are; as "
            r"W brings each pair into it, all $p_{ij}$ of Q are equal: a multiple of the scalar product"
        )
    else:
        yield argument(
            r"If an image of $\tilde A_d$ is as good, all inequalities are equalities. All heights of "
            r"$\tilde A_d$ are equal, and r grows with each, so each $h_k^2$ is additive on the forms "
            r"$Q \circ w$: in all their metrics the height, which has the direction of a root, has the "
            r"same foot. So each root is an eigenvector of Q, and "
            r"those that are not orthogonal have the same eigenvalue. The diagram is connected: Q is "
            r"a multiple of the scalar product"
        )


def examples(d: int, count: int) -> list[RationalMatrix]:
    """Gram matrices of edges, without any symmetry.

    >>> examples(2, 1)
    [RationalMatrix([[4, 2], [2, 5]])]
    """

    def edges(n: int) -> RationalMatrix:
        wild = [[(3 * i + 7 * j + n * (i + 2) * (j + 1)) % 5 - 2 for j in range(d)] for i in range(d)]
        return RationalMatrix.from_rows(
            [[x + 4 * (i == j) for j, x in enumerate(r)] for i, r in enumerate(wild)]
        )

    grams = ((m := edges(n)) @ m.T for n in range(9 * count))
    return [gram for gram in grams if gram.rank() == d][:count]


def _sums(measure: str, largest: int) -> int:
    """The measure of one simplex, for sums of forms."""
    count = 0
    for d in range(2, largest + 1):
        for a, b in pairwise(examples(d, 6)):
            grams = (a, b, RationalMatrix(a.numerators + b.numerators))
            first, second, both = (find_measure(measure)(simplex_of_gram(gram)) for gram in grams)
            if both < min(first, second):
                raise ReplayFailed(f"{measure}: the sum of {a} and {b} is worse than both")
            count += 1
    return count


def _means(measure: str, largest: int) -> int:
    """All types for which it is claimed: the mean of the orbit is the one by the trace, and no worse."""
    count = 0
    for kind in triangulations_up_to(largest):
        if measure == "relative_protection" and kind.letter != "A":
            continue
        for gram in examples(kind.rank, 3):
            image = AffineImage(affine_image(kind.affine).triangulation, gram)
            if mean_by_sum(image) != image.mean.gram or _value(measure, image) > _value(measure, image.mean):
                raise ReplayFailed(f"{measure}: the image of {kind.affine} with {gram} is not as is claimed")
            count += 1
    return count


def mean_by_sum(image: AffineImage) -> RationalMatrix:
    """The mean over the group, added up over its orbit: the second route to `AffineImage.mean`."""
    grams = [simplex.edge_gram.rows() for simplex in image.simplices]
    d, n = image.triangulation.dimension, len(grams)
    total = [[sum((g[i][j] for g in grams), Fraction(0)) / n for j in range(d)] for i in range(d)]
    mean = RationalMatrix.from_rows(total)
    if any(s @ mean @ s.T != mean for s in reflections(image.triangulation)):
        raise ReplayFailed(f"the mean of {image!r} is not invariant")
    return mean


def _value(measure: str, image: AffineImage) -> Surd:
    return image.relative_protection if measure == "relative_protection" else image.quality(measure)
