"""Section 2.4: affine reflections and alcoves."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from ..affine import CoxeterTriangulation, affine_reflection
from ..errors import InvalidInput
from ..exact import RationalMatrix, sqrt
from ..root_lattices import coroot_lattice
from .claim import Constants, Finding, agree, claim
from .instances import all_types, neighbours_are_congruent, systems
from .vectors import inner, minus, point, rational_point
from .vocabulary import EVERY_D, LITERATURE, Weight
from .wording import explained, fits, quoted

RESULT, WORDING = Weight.RESULT, Weight.WORDING


# -- hyperplanes and affine reflections -------------------------------------------------------------------


def _has_reflection(u: tuple[int, ...]) -> bool:
    try:
        affine_reflection(u, 0, u)
    except InvalidInput:
        return False
    return True


@claim("def-13", "Section 2.4, Definition 13", WORDING)
def definition_13(printed: Constants) -> Finding:
    """A vector u gives a family of parallel hyperplanes, of the points with product k with u, for each
    integer k."""
    finding = agree(
        printed, {"zero_excluded": not _has_reflection((0, 0)) and _has_reflection((0, 1))}, EVERY_D,
        "For u ≠ 0 they are parallel, at distances 1/|u|.",
    )  # fmt: skip
    why = "u must not be 0: then the points with product 0 are the whole space, and no others exist"
    return explained(finding, why)


@claim("def-14", "Section 2.4, Definition 14", RESULT, to_state=["def-10", "def-13"])
def definition_14(printed: Constants) -> Finding:
    """The reflection in the hyperplane of r and k takes from x the coroot of r, multiplied by {coefficient}
    and by the product of x and r less k."""
    r, k, x = point(1, 2), 3, point(5, 7)
    moved = affine_reflection(r, k, x)[0] - x[0]
    level, coroot = inner(r, x) - k, 2 * r[0] / inner(r, r)
    return agree(
        printed, {"coefficient": int(-moved / (level * coroot))}, EVERY_D,
        "$\\langle\\sigma_{r,k}(x),r\\rangle-k=-(\\langle x,r\\rangle-k)$, as r has the product 2 with its "
        "coroot, and points of the hyperplane stay where they are.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _translations() -> tuple[bool, str]:
    """Whether reflections keep the lattice of translations, and which vectors the translations are."""
    kept, which = True, {"roots", "coroots"}
    for s in systems(4):
        x = tuple(Fraction(3 * i + 1) for i in range(s.simple_roots.shape[1]))
        lattice = coroot_lattice(s)
        for r, coroot in zip(s.roots.rows(), s.coroots.rows(), strict=True):
            image = affine_reflection(r, 1, affine_reflection(r, 0, x))
            shift = minus(image, x)
            which -= {name for name, v in (("roots", r), ("coroots", coroot)) if v != shift}
            kept &= all(affine_reflection(r, 0, v) in lattice for v in lattice.basis.rows())
    return kept, ", ".join(sorted(which))


@claim("prop-3", "Section 2.4, Proposition 3", RESULT, to_state=["def-11", "def-14"])
def proposition_3(printed: Constants) -> Finding:
    """The translations by integer combinations of the {translations} are a normal subgroup of the affine
    Weyl group, which is their semidirect product with the Weyl group."""
    normal, which = _translations()
    return agree(
        printed, {"normal": normal, "translations": which}, EVERY_D,
        "$\\sigma_{r,k}$ is $\\sigma_r$ followed by the translation by $k\\,r^\\vee$, so translations by "
        "coroots and the Weyl group generate the affine one.",
        "$w\\,t_v\\,w^{-1}=t_{wv}$, and w permutes the coroots: the subgroup is normal. The Weyl group "
        "fixes 0, a translation other than the identity does not.",
        "Computed up to rank 4.",
    )  # fmt: skip


# -- alcoves ----------------------------------------------------------------------------------------------


@claim("sec2.similar-regions", "Section 2.4", RESULT, to_state=["def-14"])
def similar_regions(printed: Constants) -> Finding:
    """In the plane the open regions between the hyperplanes are similar triangles."""
    return agree(
        printed, {"similar": neighbours_are_congruent(2)}, EVERY_D,
        "They are even congruent: each is a mirror image of its neighbours.",
    )  # fmt: skip


@lru_cache(maxsize=16)
def _levels(t: CoxeterTriangulation) -> tuple[tuple[Fraction, Fraction], ...]:
    """For each positive root its least and its greatest product with a vertex of the fundamental simplex."""
    products = t.simplex.vertex_matrix @ t.roots.positive_roots.T
    columns = zip(products.numerators.min(axis=0), products.numerators.max(axis=0), strict=True)
    return tuple(
        (Fraction(int(a), products.denominator), Fraction(int(b), products.denominator)) for a, b in columns
    )


@claim("def-15.inequalities", "Section 2.4, Definition 15", RESULT, to_state=["def-14"])
def inequalities(printed: Constants) -> Finding:
    """An alcove, a component of what the hyperplanes leave of space, is given by inequalities: for each
    positive root the product lies between an integer and that integer plus {width}."""
    width = max(b - a for t in all_types(6) for a, b in _levels(t))
    return agree(
        printed, {"width": int(width)}, EVERY_D,
        "The product with a root takes no integer value on a component. Conversely a set that is given by "
        "such inequalities is convex and meets no hyperplane; not for all integers it is non-empty.",
        "Computed up to d = 6: on the fundamental simplex the products of a root differ by 1 at most.",
    )  # fmt: skip


@claim("def-15.fundamental", "Section 2.4, after Definition 15", RESULT, to_state=["def-15.inequalities"])
def fundamental_alcove(printed: Constants) -> Finding:
    """The fundamental alcove is where all positive roots have products between {lower} and {upper}."""
    levels = [x for t in all_types(6) for x in _levels(t)]
    return agree(
        printed, {"lower": int(min(a for a, _ in levels)), "upper": int(max(b for _, b in levels))}, EVERY_D,
        "It is not empty: a vector with positive products with the simple roots, made short enough, lies "
        "in it. Computed up to d = 6 at the vertices of the fundamental simplex.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _redundant() -> dict[str, tuple[int, int]]:
    """Type -> how many inequalities define the alcove, and how many of them are needed."""
    return {t.name: (2 * len(t.roots.positive_root_coordinates), len(t.facets)) for t in all_types(8)}


@claim("sec2.redundant", "Section 2.4", WORDING, to_state=["def-15.fundamental"], to_prove=["prop-5"])
def redundant(printed: Constants) -> Finding:
    """Of the inequalities that say what the fundamental alcove is, most can be left out: {strict?more than|at
    least} half of them, in every type."""
    halves = [f"{name}, where {k} of {n} are needed" for name, (n, k) in _redundant().items() if 2 * k >= n]
    finding = agree(
        printed, {"strict": not halves}, EVERY_D,
        "Two for each positive root, and d + 1 are needed. There are at least $\\frac{d(d+1)}2$ positive "
        "roots, so that at most the share $\\frac1d$ is needed: at most a half, and a half in A~2 alone.",
        witness="; ".join(halves),
    )  # fmt: skip
    return explained(finding, "In A~2 just a half can be left out, in all other types most")


@lru_cache(maxsize=1)
def _has_maximum() -> bool:
    return all(bool((s.positive_root_coordinates <= list(s.marks)).all()) for s in systems(8))


@claim("prop-4", "Section 2.4, Proposition 4", RESULT, to_state=["def-6.order"])
def proposition_4(printed: Constants) -> Finding:
    """The positive roots have a maximum for the partial order, the highest root."""
    return quoted(
        agree(
            printed,
            {"maximum": _has_maximum()},
            LITERATURE,
            "A reducible system has one for each part, and no maximum: irreducibility, which is assumed "
            "throughout, is needed.",
        ),
        "Humphreys, Section 2.9.",
        "In all types up to rank 8 no coefficient of a root exceeds that of the highest one.",
    )


@lru_cache(maxsize=1)
def _walls() -> tuple[dict[int, Fraction], dict[int, Fraction], Fraction]:
    """d -> how many facets there are, how many of them contain 0; the product of the highest root on the
    other."""
    facets, central, levels = {}, {}, set()
    for t in all_types(8):
        u = t.simplex.vertex_matrix
        facets[t.dimension] = Fraction(len(t.facets))
        central[t.dimension] = Fraction(sum(f.level(u.row(0)) == 0 for f in t.facets))
        top = (u @ RationalMatrix.from_rows([[x] for x in t.roots.highest_root])).T.row(0)
        levels |= set(top[1:])
    return facets, central, levels.pop() if len(levels) == 1 else Fraction(0)


@claim("prop-5", "Section 2.4, Proposition 5", RESULT, to_state=["def-15.fundamental"], to_prove=["prop-4"])
def proposition_5(printed: Constants) -> Finding:
    """The fundamental alcove is an open simplex between {hyperplanes} hyperplanes: those of the
    {through_the_origin} simple roots through the origin, and the one where the highest root has the product
    {level}."""
    facets, central, level = _walls()
    true = {
        "hyperplanes": fits(printed["hyperplanes"], "d + 1", facets),
        "through_the_origin": fits(printed["through_the_origin"], "d", central),
        "level": int(level),
    }
    return agree(
        printed, true, EVERY_D,
        "Let x have positive products with the simple roots, and one less than 1 with $\\tilde s=\\sum "
        "m_is_i$. A positive root $r=\\sum c_is_i$ has $0\\le c_i\\le m_i$ by Proposition 4, so "
        "$0<\\langle x,r\\rangle\\le\\langle x,\\tilde s\\rangle<1$: the other inequalities are redundant.",
        "The simple roots are a basis of the span, and all $m_i$ are positive: there it is a simplex, with "
        "the vertices 0 and $\\omega_i/m_i$. Computed up to d = 8.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _folds_to_itself() -> bool:
    """Whether images of a point of the simplex, on a facet or inside, fold back to that very point."""
    for t in all_types(4):
        n = t.dimension + 1
        for weights in ([Fraction(1, n)] * n, [Fraction(2 * i, n * (n - 1)) for i in range(n)]):
            point = rational_point(t.simplex.point(weights))
            for word in ((0, 1), (1, 0, 2, 0), (2, 1, 0)):
                if t.fold(t.unfold(word, point)).point != point:
                    return False
    return True


@claim("def-16", "Section 2.4, Definition 16", RESULT, to_state=["prop-5"])
def definition_16(printed: Constants) -> Finding:
    """The closure of the fundamental alcove, a full-dimensional simplex with {vertices} vertices, is called
    a fundamental domain."""
    vertices = {t.dimension: Fraction(t.simplex.edge_gram.rank() + 1) for t in all_types(8)}
    true = {"vertices": fits(printed["vertices"], "d + 1", vertices), "fundamental": _folds_to_itself()}
    return agree(
        printed, true, EVERY_D,
        "It meets each orbit of the affine Weyl group, by Proposition 6; and only once. Let w carry x to "
        "y, both in the simplex F. If w is not the identity, a facet of F separates F from wF; y lies in "
        "both, so in that facet, and its reflection s fixes y. Then sw carries x to y, and fewer "
        "hyperplanes separate F from swF. So in the end x = y.",
        "Computed up to d = 4: images of points of the simplex, on its boundary too, are carried back to "
        "those very points.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _volumes_agree() -> bool:
    return all(
        t.simplex.volume * t.roots.weyl_group_order == sqrt(coroot_lattice(t.roots).gram_determinant)
        for t in all_types(8)
    )


@claim("prop-6", "Section 2.4, Proposition 6", RESULT, to_state=["def-15.inequalities"])
def proposition_6(printed: Constants) -> Finding:
    """For any two alcoves exactly one element of the affine Weyl group carries one to the other."""
    return quoted(
        agree(printed, {"simply_transitive": _volumes_agree()}, LITERATURE),
        "Humphreys, Sections 4.3 (transitive) and 4.5 (simply).",
        "The volume of the alcove times the order of the Weyl group is that of a cell of the coroot "
        "lattice, for all types up to d = 8, as Proposition 3 then demands.",
    )


@claim("sec2.monohedral", "Section 2.4, after Proposition 6", RESULT, to_prove=["prop-6"])
def monohedral(printed: Constants) -> Finding:
    """All alcoves are similar to the fundamental one, and their closures are the simplices of a monohedral
    triangulation."""
    return agree(
        printed, {"congruent": neighbours_are_congruent(3)}, EVERY_D,
        "They are congruent: images of one under reflections. Transitivity is enough.",
    )  # fmt: skip


@lru_cache(maxsize=1)
def _face_to_face() -> bool:
    """Whether a simplex and its mirror image in a facet share all vertices of that facet, and no other."""
    return all(
        (f.reflect(v) == v) == (k != f.index)
        for t in all_types(6)
        for f in t.facets
        for k, v in enumerate(t.simplex.vertex_matrix.rows())
    )


@claim("cor-1", "Section 2.4, Corollary 1", RESULT, to_state=["def-14"], to_prove=["prop-5", "prop-6"])
def corollary_1(printed: Constants) -> Finding:
    """The hyperplanes cut space into a triangulation."""
    return agree(
        printed, {"triangulation": _face_to_face()}, EVERY_D,
        "There are finitely many directions of hyperplanes, equally spaced in each: the arrangement is "
        "locally finite. The closed cells of such an arrangement meet in common faces, as a face is where "
        "some of the inequalities are equations.",
        "The cells are simplices, by Propositions 5 and 6. This needs that the roots are irreducible, as "
        "is assumed, and the span of the roots in place of a larger space. Computed up to d = 6.",
    )  # fmt: skip
