"""Appendix D, Propositions 8 and 9: the vertex sets of B~ and C~."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import gcd

from ..exact import RationalMatrix
from ..lattices import LatticeProof
from .appendix_d_cases import CASES, answer, fraction, range_of
from .appendix_d_steps import NOT_A_LATTICE, register_steps
from .claim import Constants, Finding, claim, decide
from .vocabulary import EVERY_D, Weight

# -- Proposition 8 -------------------------------------------------------------------------------------------


@claim(
    "prop-8",
    "Section 6, Proposition 8",
    Weight.RESULT,
    to_prove=("prop-8.no-vertex",),
    proof=("proposition_8",),
)
def vertices_of_b(printed: Constants) -> Finding:
    r"""From d = {first} on the vertex set of $\tilde B_d$ is {lattice?a|not a} lattice."""
    return decide(
        range_of(printed, 8, 3, lattice=False),
        EVERY_D,
        r"For no $d\ge3$ it is a lattice.",
        r"$u_d-u_{d-1}=\frac12e_d$. A root has an integer product with it only if its last coordinate is "
        "0, as these coordinates are 0, 1 or -1; so the rank of such roots is $d-1$, and the difference is "
        "no vertex.",
    )


register_steps(CASES[8], NOT_A_LATTICE)


# -- Proposition 9 -----------------------------------------------------------------------------------------


INCLUSIONS = (
    r"Coroots have integer coordinates and x has inner products in $\frac12\mathbb Z$ with roots, so that "
    r"reflections keep $(\frac12\mathbb Z)^d$; it contains the vertices of the fundamental simplex.",
    r"Conversely the $2e_i$ are d independent roots with integer products with all of it.",
)


@claim(
    "prop-9",
    "Section 6, Proposition 9",
    Weight.RESULT,
    to_prove=("prop-9.inclusion", "prop-9.converse"),
    proof=("proposition_9",),
)
def vertices_of_c(printed: Constants) -> Finding:
    r"""From d = {first} on the vertex set of $\tilde C_d$ is {lattice?a|not a} lattice."""
    return decide(
        range_of(printed, 9, 2, lattice=True),
        EVERY_D,
        r"For every $d\ge2$ it is a lattice.",
        r"It is $(\frac12\mathbb Z)^d$:",
        *INCLUSIONS,
        r"A second proof, by counting cosets of the coroot lattice $\mathbb Z^d$: $(\frac12\mathbb Z)^d$ "
        r"has $2^d$, and the orbit of $u_k$ has $|W|/|W_k|=\binom dk$.",
    )


register_steps(CASES[9], ("criterion", "roots"))


def _content(rows: Iterable[tuple[Fraction, ...]]) -> Fraction:
    """The positive number whose integer multiples are the sums of multiples of the given numbers."""
    entries = RationalMatrix.from_rows(list(rows))
    return Fraction(gcd(*map(int, entries.numerators.ravel())), entries.denominator)


@claim(
    "prop-9.lattice",
    CASES[9].place,
    Weight.PROOF,
    to_prove=("prop-9.inclusion", "prop-9.converse"),
    proof=("proposition_9",),
)
def halves(printed: Constants) -> Finding:
    r"""The vertex set of $\tilde C_d$ is $(c\mathbb Z)^d$ with c = {step}."""
    good = all(_is_grid(fraction(printed["step"]), d) for d in CASES[9].dimensions)
    return decide(
        good,
        EVERY_D,
        r"it is $(\frac12\mathbb Z)^d$",
        *INCLUSIONS,
        constants={"step": "1/2"},
    )


def _is_grid(step: Fraction, d: int) -> bool:
    basis = answer(CASES[9], d)
    assert isinstance(basis, LatticeProof)
    rows = basis.lattice.basis.rows()
    generators = [tuple(step * (i == j) for j in range(d)) for i in range(d)]
    fits = step > 0 and all((x / step).denominator == 1 for row in rows for x in row)
    return fits and all(g in basis.lattice for g in generators)


@claim("prop-9.products", CASES[9].place, Weight.PROOF, to_state=("prop-9.roots",))
def products_of_c(printed: Constants) -> Finding:
    r"""The inner products of the roots with the points of $(\frac12\mathbb Z)^d$ are the multiples of
    {step}."""
    good = all(
        _content([tuple(x / 2 for x in row) for row in CASES[9].at(d).roots.positive_roots.rows()])
        == fraction(printed["step"])
        for d in CASES[9].dimensions
    )
    why = r"Roots have integer coordinates; $\langle\frac12e_1,e_1-e_2\rangle=\frac12$."
    return decide(good, EVERY_D, r"the multiples of $\frac12$", why, constants={"step": "1/2"})


@claim("prop-9.coroots", CASES[9].place, Weight.PROOF, to_state=("prop-9.roots",))
def coroots_of_c(printed: Constants) -> Finding:
    r"""The coordinates of the dual roots are integer multiples of {step}, and it is the greatest such
    number."""
    good = all(_content(CASES[9].at(d).roots.coroots.rows()) == printed["step"] for d in CASES[9].dimensions)
    why = r"$(2e_i)^\vee=e_i$ and $(e_i\pm e_j)^\vee=e_i\pm e_j$."
    return decide(good, EVERY_D, "the step is 1", why, constants={"step": 1})


@claim(
    "prop-9.inclusion",
    CASES[9].place,
    Weight.PROOF,
    to_prove=("prop-6", "prop-9.products", "prop-9.coroots"),
)
def inclusion_of_c(printed: Constants) -> Finding:
    r"""The coordinates of the vertices of the fundamental simplex are multiples of {step}, and it is the
    greatest such number; the affine Weyl group maps the points with such coordinates to such points."""
    step = fraction(printed["step"])
    good = all(
        _content(CASES[9].at(d).simplex.vertex_matrix.rows()) == step and _is_stable(step, d)
        for d in CASES[9].dimensions
    )
    return decide(
        good,
        EVERY_D,
        r"the step is $\frac12$",
        r"$u_k=(\frac12^{\{k\}},0^{\{d-k\}})$; $\sigma_{r,k}(x)=x-(\langle x,r\rangle-k)r^\vee$ subtracts "
        r"a multiple by $\frac12\mathbb Z$ of a vector with integer coordinates, and these reflections "
        "generate the group.",
        constants={"step": "1/2"},
    )


def _is_stable(step: Fraction, d: int) -> bool:
    """Whether the reflections in the facets map 0 and the vectors step·e_i to multiples of the step."""
    points = [tuple(step * (i == j) for j in range(d)) for i in range(d + 1)]
    images = (facet.reflect(x) for facet in CASES[9].at(d).facets for x in points)
    return all((x / step).denominator == 1 for image in images for x in image)


@claim("prop-9.converse", CASES[9].place, Weight.PROOF, to_prove=("prop-9.criterion",))
def converse_of_c(printed: Constants) -> Finding:
    r"""The d vectors ${coefficient:times}e_i$ are independent positive roots that have integer inner
    products with all points of $(\frac12\mathbb Z)^d$."""
    factor = printed["coefficient"]
    good = factor > 0 and factor % 2 == 0
    for d in CASES[9].dimensions:
        roots = set(CASES[9].at(d).roots.positive_roots.rows())
        good = good and all(tuple(Fraction(factor * (i == j)) for j in range(d)) in roots for i in range(d))
    why = r"$\langle x,2e_i\rangle=2x_i$."
    return decide(good, EVERY_D, "the coefficient is 2", why, constants={"coefficient": 2})
