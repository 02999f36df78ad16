"""Simplices that fill space, in every dimension, beside those of Coxeter triangulations.

* *Hill's simplices*, after Hill (1896, d = 3) and Hadwiger (1951): the steps b_1 … b_d of a path have equal
  lengths, and any two the cosine w. Why they fill space is said in `coxeter.peers.fillers`, where they are
  made. For w = 0 it is Kuhn's simplex, or that of C~d, for w = -1/d that of A~d.
* *Their halves*: read backwards a path is congruent to itself. This exchanges each vertex k with d - k; the
  plane through the midpoint of such a pair and all other vertices cuts the simplex into congruent halves.
  For d = 3 these are Goldberg's families 2 and 3.
* *Their parts around the centre*: joined with the barycentre, the d + 1 facets of A~d's simplex give
  congruent parts, as a rotation of its diagram carries each facet to each other.

The triangulations by Hill simplices of a dimension are affine images of one another, and of A~d's. So no w is
better than -1/d: see `images`. The argument there does not reach the halves, as the cut singles out the
direction of b_1 + … + b_d, which the finite Weyl group moves. No half is as thick or as fat as A~d's simplex,
for every w and d: that is proved in the book's chapter on the conjectures. In other measures they have to be
looked at for each w.
"""

from __future__ import annotations

from fractions import Fraction

from ..errors import InvalidInput
from ..exact import RationalMatrix, rational
from ..peers import find_peer
from ..simplex import Simplex
from .images import simplex_of_gram


def hill(d: int, w: object) -> Simplex:
    """Hill's simplex with the vertices 0, b_1, b_1 + b_2 …: equal lengths, any two steps with the cosine w.

    The steps of K1, stretched along the diagonal by √q, have the products (q - 1)/d, and (q - 1)/d + 1 with
    themselves. So q = 1 + d·w/(1 - w).

    Parameters
    ----------
    d
        The dimension, at least 2.
    w
        An exact number with -1/(d - 1) < w < 1.

    Raises
    ------
    InvalidInput
        If d or w is out of range.

    Examples
    --------
    >>> hill(3, "-1/3").minimal_height / hill(3, "-1/3").longest_edge
    sqrt(2)/2
    """
    if isinstance(d, bool) or not isinstance(d, int) or d < 2:
        raise InvalidInput(f"{d!r} is no dimension of Hill simplices: give an integer >= 2")
    cosine = rational(w)
    if not Fraction(-1, d - 1) < cosine < 1:
        raise InvalidInput(f"w = {w} is out of range: give a number between -1/{d - 1} and 1")
    return find_peer(f"hill:{1 + d * cosine / (1 - cosine)}").classes(d)[0]


def halves(simplex: Simplex) -> dict[tuple[int, int], Simplex]:
    """One of the two halves by each pair of vertices k, d - k, whose midpoint takes the place of the second.

    Raises
    ------
    InvalidInput
        If the two halves are not congruent by the exchange of all k and d - k.

    Examples
    --------
    >>> [half.volume / hill(3, 0).volume for half in halves(hill(3, 0)).values()]
    [1/2, 1/2]
    """
    d, squares = simplex.dimension, simplex.squared_edge_lengths
    if any(squares[i, j] != squares[d - i, d - j] for i in range(d + 1) for j in range(i)):
        raise InvalidInput("read backwards the simplex is another one: its halves are not congruent")
    middle = {
        (k, d - k): [Fraction(int(i in (k, d - k)), 2) for i in range(d + 1)] for k in range((d + 1) // 2)
    }
    return {pair: _with(simplex, pair[1], point) for pair, point in middle.items()}


def part_around_centre(simplex: Simplex) -> Simplex:
    """The part of a simplex between the facet opposite to u_0 and the barycentre.

    Raises
    ------
    InvalidInput
        If the turn of the vertices 0, 1 … d, 0 is no symmetry: the parts are not congruent by it.

    Examples
    --------
    >>> part_around_centre(hill(3, "-1/3")).volume / hill(3, "-1/3").volume
    1/4
    """
    n, squares = simplex.dimension + 1, simplex.squared_edge_lengths
    if any(squares[i, j] != squares[(i + 1) % n, (j + 1) % n] for i in range(n) for j in range(i)):
        raise InvalidInput("turned by one vertex the simplex is another one: its parts are not congruent")
    return _with(simplex, 0, [Fraction(1, n)] * n)


def _with(simplex: Simplex, k: int, point: list[Fraction]) -> Simplex:
    """The simplex with a point, by its barycentric coordinates, in the place of vertex k."""
    d = simplex.dimension
    rows = [[Fraction(int(i == j)) for j in range(d + 1)] for i in range(d + 1)]
    rows[k] = point
    edges = RationalMatrix.from_rows(
        [[x - y for x, y in zip(row, rows[0], strict=True)][1:] for row in rows[1:]]
    )
    return simplex_of_gram(edges @ simplex.edge_gram @ edges.T)
