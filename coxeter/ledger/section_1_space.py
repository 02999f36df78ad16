"""Section 1.2: dimension three, and the body-centred cubic lattice."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import combinations, permutations, product

from ..affine import triangulation
from ..errors import CoxeterError
from ..exact import RationalMatrix, Surd, sqrt
from ..lattices import LatticeProof, vertex_lattice
from ..quality import PAPER_MEASURES
from ..root_lattices import Lattice, coweight_lattice, root_lattice
from ..roots import root_system
from ..simplex import Simplex
from .claim import Constants, Finding, agree, cited, claim
from .instances import all_types
from .vectors import mean
from .vocabulary import FINITE, Weight
from .wording import explained

RESULT, WORDING = Weight.RESULT, Weight.WORDING

BCC = (("1/2", "1/2", "1/2"), ("1/2", "-1/2", "-1/2"), ("-1/2", "1/2", "-1/2"))
"""A basis of the body-centred cubic lattice: half diagonals of the unit cube."""


@claim("sec1.bcc", "Section 1.2", RESULT)
def bcc(printed: Constants) -> Finding:
    """The vertex set of the triangulation of type A~ in dimension {dimension} is the {lattice} lattice."""
    lattice = Lattice.spanned_by(BCC)
    is_bcc = all(
        v in lattice for v in ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    ) and lattice.gram_determinant == Fraction(1, 4)
    vertices = vertex_lattice(triangulation("A~3"))
    basis = RationalMatrix.from_rows([[Fraction(4 * (i == j) - 1, 4) for j in range(4)] for i in range(3)])
    same_products = lattice.basis @ lattice.basis.T == basis @ basis.T
    if not (
        is_bcc and isinstance(vertices, LatticeProof) and same_products and vertices.lattice == Lattice(basis)
    ):
        return agree(printed, {"dimension": 3, "lattice": "another"}, FINITE)
    return agree(
        printed, {"dimension": lattice.rank, "lattice": "body-centred cubic"}, FINITE,
        "The vertex set has the basis $e_i-\\frac14(1,1,1,1)$, i = 1, 2, 3, with the products $\\frac34$ "
        "and $-\\frac14$. So have $\\frac12(1,1,1)$, $\\frac12(1,-1,-1)$, $\\frac12(-1,1,-1)$, a basis of "
        "the body-centred cubic lattice.",
    )  # fmt: skip


@claim("sec1.sommerville", "Section 1.2", WORDING, to_state=["sec1.bcc"])
def sommerville(printed: Constants) -> Finding:
    """The tetrahedron of A~3 is known as Sommerville's of type II, and as the bcc tetrahedron."""
    edges = sorted(
        triangulation("A~3").simplex.squared_edge_lengths[i, j] for i, j in combinations(range(4), 2)
    )
    return cited(
        "Sommerville, 1923, as cited there; the numbering is not the same with all authors.",
        f"Its squared edges are {', '.join(map(str, edges))}, that is, as 3 to 4, four and two of them.",
    )


@claim("sec1.naylor", "Section 1.2", WORDING, to_state=["sec1.sommerville"])
def naylor(printed: Constants) -> Finding:
    """Of the tetrahedra that fill space and are used in meshing, it is the best-conditioned."""
    a, *others = [t.simplex for t in all_types(3) if t.dimension == 3]
    if not all(known(s) < known(a) for known in PAPER_MEASURES for s in others):
        raise CoxeterError("a tetrahedron of another type is better")
    return cited(
        "Naylor, Filling space with tetrahedra, 1999.",
        "It is better, in all four measures, than those of the two other Coxeter triangulations of space.",
    )


@claim("sec1.isosurface", "Section 1.2", WORDING)
def isosurface(printed: Constants) -> Finding:
    """This led to the use of the body-centred cubic lattice in isosurface stuffing."""
    return cited("The paper on isosurface stuffing cited there.")


@lru_cache(maxsize=1)
def _covering() -> dict[str, Fraction]:
    """Squared number of points in a unit of volume, at covering radius 1: bcc, fcc, cubic."""
    a3 = root_system("A3")
    bcc_radius = triangulation("A~3").simplex.squared_circumradius
    fcc_radius = max(
        sum(x * x for x in w) for w in a3.fundamental_coweights.rows()
    )  # the holes are coweights
    return {
        "bcc": bcc_radius**3 / coweight_lattice(a3).gram_determinant,
        "fcc": fcc_radius**3 / root_lattice(a3).gram_determinant,
        "cubic": Fraction(3, 4) ** 3,
    }


@claim("sec1.bcc-covering", "Section 1.2", RESULT, to_state=["sec1.bcc"])
def bcc_covering(printed: Constants) -> Finding:
    """The body-centred cubic lattice ({sparsest}) gives a sparse covering."""
    densities = _covering()
    return agree(
        printed, {"sparsest": min(densities, key=lambda name: densities[name])}, FINITE,
        "Points in a unit of volume, squared, at covering radius 1: "
        + ", ".join(f"{name} {value}" for name, value in densities.items()) + ".",
        "It is the sparsest lattice covering of space at all (Bambah, 1954).",
    )  # fmt: skip


def _least_norm(lattice: Lattice) -> Fraction:
    """The least squared length of a vector of a lattice of rank 3 with a basis of short vectors."""
    combinations_ = RationalMatrix.from_rows([c for c in product(range(-2, 3), repeat=3) if any(c)])
    return min(sum((x * x for x in row), Fraction(0)) for row in (combinations_ @ lattice.basis).rows())


@lru_cache(maxsize=1)
def _shares_of_samples() -> tuple[Surd, Surd]:
    """The samples that bcc needs, as a share of those of the cubic lattice: for a band limit, and for a
    covering."""
    reciprocal = coweight_lattice(root_system("A3")).dual()
    band = reciprocal.gram_determinant / _least_norm(reciprocal) ** 3  # 1 for the cubic lattice
    densities = _covering()
    return sqrt(band), sqrt(densities["bcc"] / densities["cubic"])


@claim("sec1.bcc-samples", "Section 1.2", WORDING, to_state=["sec1.bcc", "sec1.bcc-covering"])
def bcc_samples(printed: Constants) -> Finding:
    """Sampling on the body-centred cubic lattice needs about {percent} % fewer samples than on the cubic
    one; the reason given is its {reason}."""
    shares = _shares_of_samples()
    band, cover = ((100 - 100 * x).decimal(1) for x in shares)
    true = {"percent": band, "reason": "its reciprocal lattice is a dense packing"}
    finding = agree(
        printed, true, FINITE,
        "A signal whose spectrum lies in a ball needs a lattice whose reciprocal packs such balls. At "
        "least distance 1 the cell of the reciprocal lattice has volume 1 for the cubic lattice and "
        f"${shares[0].latex()}$ for the body-centred one, whose reciprocal is face-centred: "
        f"$1-{shares[0].latex()}$, that is {band} % fewer.",
        f"Coverings of equal radius: $1-{shares[1].latex()}$, that is {cover} % fewer points.",
    )  # fmt: skip
    return explained(
        finding,
        f"The number {band} % belongs to signals with a spectrum in a ball, and comes from the densest "
        "lattice packing, by the reciprocal, face-centred lattice. A comparison of coverings of equal "
        f"radius would give {cover} %",
    )


@lru_cache(maxsize=1)
def _division() -> tuple[int, frozenset[Surd]]:
    """The number of pieces, and the scales at which each is a copy; an error if they do not fill the
    whole."""
    whole = triangulation("A~3").simplex
    v = whole.vertex_matrix.rows()
    middle = {(i, j): mean((v[i], v[j])) for i, j in permutations(range(4), 2)}
    (p, q), (r, s) = whole.longest_edges()
    ring = [middle[p, r], middle[r, q], middle[q, s], middle[s, p]]
    axis = [middle[p, q], middle[r, s]]
    corners = [[v[i], *(middle[i, j] for j in range(4) if j != i)] for i in range(4)]
    pieces = [Simplex(x) for x in (*corners, *([*axis, ring[i - 1], ring[i]] for i in range(4)))]
    if sum((x.volume for x in pieces), Surd(0)) != whole.volume:
        raise CoxeterError("the pieces do not fill the tetrahedron")
    scales = [scale for x in pieces if (scale := _scale(x, whole)) is not None]
    return len(scales), frozenset(scales)


def _scale(piece: Simplex, whole: Simplex) -> Surd | None:
    """The factor by which a simplex is a smaller copy of another, or None."""
    square = piece.squared_longest_edge / whole.squared_longest_edge
    a, b = piece.squared_edge_lengths, whole.squared_edge_lengths
    pairs = list(combinations(range(4), 2))
    copies = (all(a[o[i], o[j]] == square * b[i, j] for i, j in pairs) for o in permutations(range(4)))
    return sqrt(square) if any(copies) else None


@claim("sec1.bcc-division", "Section 1.2", RESULT, to_state=["sec1.sommerville"])
def bcc_division(printed: Constants) -> Finding:
    """The tetrahedron of A~3 can be divided into {pieces:words} copies of itself, scaled by {scale}."""
    pieces, scales = _division()
    (scale,) = scales
    return agree(
        printed, {"pieces": pieces, "scale": str(scale)}, FINITE,
        "Cut off the four corners at the midpoints of the edges. The octahedron that is left is cut into "
        "four around its diagonal between the midpoints of the two longest edges. All eight pieces are "
        "similar to the whole, and their volumes add up to it.",
    )  # fmt: skip
