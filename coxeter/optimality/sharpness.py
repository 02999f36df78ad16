"""How sharp the optimum at a Coxeter triangulation is: the rank of the gradients.

Near the scalar product the quality is the least of finitely many smooth functions of the form Q. The
gradients of those that attain it, the *active* ones, are permuted by the finite Weyl group W; their sum is
invariant under W and orthogonal to the scalar product, as a measure does not depend on the scale, so it is 0.
Hence in a direction H

* if some active gradient does not vanish on H, one is negative there: quality falls linearly;
* if all vanish on H, quality falls more slowly than linearly, if at all.

So the directions of linear descent are all but a subspace, whose dimension is that of all forms up to scale,
d(d + 1)/2 - 1, less the *rank* of the active gradients. It is the same for a crystal, where besides the form
the atoms can move, if the active gradients add up to zero; that is computed.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations, product

from ..affine import triangulation
from ..errors import InvalidInput, Undecided
from ..exact import RationalMatrix
from ..quality import find_measure
from ..simplex import Simplex
from .crystals import Atom, Crystal
from .images import reflections

Rows = list[list[Fraction]]


def directions(d: int) -> int:
    """The number of independent directions in which a form can move, up to scale.

    >>> directions(3)
    5
    """
    return d * (d + 1) // 2 - 1


def gradient_rank(name: object, measure: str) -> int:
    """The rank of the active gradients of a measure at a Coxeter triangulation.

    If it is ``directions(d)``, quality falls linearly in every direction.

    Raises
    ------
    InvalidInput
        If the measure is none of Definition 18.
    Undecided
        If the gradients are not rational: for the radius ratio, where heights have irrational quotients.

    Examples
    --------
    >>> [gradient_rank("A~3", m) for m in ("thickness", "aspect_ratio", "fatness", "radius_ratio")]
    [5, 5, 2, 2]
    """
    if measure not in _ACTIVE:
        raise InvalidInput(f"{measure!r} has no gradients here; there are {', '.join(_ACTIVE)}")
    t = triangulation(name)
    moves = reflections(t)
    basis: list[RationalMatrix] = []
    waiting = [RationalMatrix.from_rows(rows) for rows in _ACTIVE[measure](t.simplex)]
    while waiting:
        gradient = waiting.pop()
        if _rank([*basis, gradient]) > len(basis):
            basis.append(gradient)
            waiting += [s.T @ gradient @ s for s in moves]
    return len(basis)


def crystal_directions(crystal: Crystal) -> int:
    """The number of independent directions in which a crystal can be deformed, up to similarity.

    All atoms of a period can move, and the period with them.

    >>> from coxeter.optimality import A15
    >>> crystal_directions(A15)
    26
    """
    d = len(crystal.atoms[0])
    return d * (len(crystal.atoms) - 1) + directions(d)


def crystal_gradient_rank(crystal: Crystal, measure: str) -> int:
    """The rank of the active gradients of a measure at a crystal, if these add up to zero.

    If they do, quality falls linearly in each direction on which one of them does not vanish. So if the
    rank is ``crystal_directions(crystal)``, every small deformation makes the least quality worse: the
    crystal is a strict local optimum among those with as many atoms to a period.

    Raises
    ------
    InvalidInput
        If the measure is none of Definition 18.
    Undecided
        If the gradients do not add up to zero, or are not rational.

    Examples
    --------
    >>> from coxeter.optimality import A15
    >>> crystal_gradient_rank(A15, "fatness")
    26
    """
    if measure not in _ACTIVE:
        raise InvalidInput(f"{measure!r} has no gradients here; there are {', '.join(_ACTIVE)}")
    known, least = find_measure(measure), crystal.quality(measure)
    worst = [(cell, s) for cell in crystal.cells if known(s := Simplex(cell)) == least]
    rows = [_moves(crystal, cell, form) for cell, s in worst for form in _ACTIVE[measure](s)]
    if any(map(sum, zip(*rows, strict=True))):
        raise Undecided(f"{crystal.name}: the active gradients of {measure} do not add up to zero")
    return RationalMatrix.from_rows(sorted(set(map(tuple, rows)))).rank()


def _moves(crystal: Crystal, cell: tuple[Atom, ...], form: Rows) -> list[Fraction]:
    """The gradient in the moves of the atoms, and in a linear map of all space, from that in the Gram matrix.

    A Gram matrix EEᵗ of edges changes by dE·Eᵗ + E·dEᵗ, so the gradient in the edges is 2·form·E.
    """
    d = len(cell[0])
    edges = RationalMatrix.from_rows([[a - b for a, b in zip(v, cell[0], strict=True)] for v in cell[1:]])
    apart = list((RationalMatrix.from_rows(form) @ edges).rows())
    forces = [tuple(-sum(column, Fraction(0)) for column in zip(*apart, strict=True)), *apart]
    sites = [tuple(x % crystal.period for x in atom) for atom in crystal.atoms]
    row = [Fraction(0)] * (d * len(sites) + d * d)
    for vertex, force in zip(cell, forces, strict=True):
        at = sites.index(tuple(x % crystal.period for x in vertex))
        for i, f in enumerate(force):
            row[d * at + i] += f
            for j, x in enumerate(vertex):
                row[d * len(sites) + d * i + j] += f * x
    return row


def _rank(forms: list[RationalMatrix]) -> int:
    return RationalMatrix.from_rows([[x for row in form.rows() for x in row] for form in forms]).rank()


# -- gradients of logarithms of squares, as matrices that are paired with a change of the Gram matrix -------


def _square(x: list[Fraction], factor: Fraction) -> Rows:
    return [[factor * a * b for b in x] for a in x]


def _plus(*terms: Rows) -> Rows:
    return [[sum(xs, Fraction(0)) for xs in zip(*rows, strict=True)] for rows in zip(*terms, strict=True)]


def _edge(s: Simplex, i: int, j: int, factor: Fraction) -> Rows:
    """The gradient of the squared length of an edge, times a factor."""
    return _square([Fraction((k == j) - (k == i)) for k in range(1, s.dimension + 1)], factor)


def _height(s: Simplex, k: int) -> Rows:
    """The gradient of the logarithm of a squared height."""
    return _square([s.gradient_gram[k, j] for j in range(1, s.dimension + 1)], s.squared_heights[k])


def _lowest(s: Simplex) -> list[Rows]:
    least = min(s.squared_heights)
    return [_height(s, k) for k, square in enumerate(s.squared_heights) if square == least]


def _longest(s: Simplex) -> list[Rows]:
    """Minus the gradients of the logarithm of the squared longest edge."""
    return [_edge(s, i, j, -1 / s.squared_longest_edge) for i, j in s.longest_edges()]


def _circumradius(s: Simplex) -> Rows:
    """Minus the gradient of the logarithm of R², by the formula in `images` with the circumcentre's λ."""
    x = s.circumcentre_coordinates
    pairs = combinations(range(s.dimension + 1), 2)
    return _plus(*(_edge(s, i, j, -x[i] * x[j] / s.squared_circumradius) for i, j in pairs))


def _volume(s: Simplex) -> Rows:
    """The gradient of the logarithm of vol^(2/d)."""
    d = s.dimension
    return [[s.gradient_gram[i, j] / d for j in range(1, d + 1)] for i in range(1, d + 1)]


def _inradius(s: Simplex) -> Rows:
    """The gradient of the logarithm of r² = 1/(Σ 1/h_k)²: those of the h_k², weighed by r/h_k."""
    weights = [s.inradius / h for h in s.heights]
    if not all(w.is_rational for w in weights):
        raise Undecided(
            "the gradient of the inradius is not rational, as the heights have irrational quotients"
        )
    parts = ((w.as_fraction(), _height(s, k)) for k, w in enumerate(weights))
    return _plus(*([[w * x for x in row] for row in rows] for w, rows in parts))


_ACTIVE = {
    "thickness": lambda s: [_plus(a, b) for a, b in product(_lowest(s), _longest(s))],
    "aspect_ratio": lambda s: [_plus(a, _circumradius(s)) for a in _lowest(s)],
    "fatness": lambda s: [_plus(_volume(s), b) for b in _longest(s)],
    "radius_ratio": lambda s: [_plus(_inradius(s), _circumradius(s))],
}
"""The active gradients at the fundamental simplex; the group carries them to all others."""
