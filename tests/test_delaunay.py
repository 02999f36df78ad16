"""The Delaunay property and protection, against all vertices in a ball."""

from collections import defaultdict
from fractions import Fraction
from functools import lru_cache
from itertools import islice, product, takewhile

import oracle
import pytest

from coxeter import (
    InvalidInput,
    Position,
    Type,
    circumcentre_position,
    delaunay_verdict,
    is_self_centred,
    mirror_vertices,
    protection,
    regular_simplex,
    sqrt,
    triangulation,
    triangulations_up_to,
    vertices_by_distance,
)

KINDS = triangulations_up_to(8)
SMALL = triangulations_up_to(4)
DELAUNAY = {"A", "C", "F4", "G2"}


def every(kinds):
    return pytest.mark.parametrize("kind", kinds, ids=lambda kind: kind.affine)


def key(kind):
    return kind.letter, kind.rank


@lru_cache
def ball(kind):
    """R², the vertices near the circumcentre by squared distance, and those of the fundamental simplex.

    The ball is large enough to hold all mirror images of the simplex in its facets, so that no vertex
    outside the ball can be nearest.
    """
    points = oracle.vertices(*key(kind))
    centre = oracle.circumcentre(points)
    square = oracle.squared_distance(centre, points[0])
    images = [oracle.reflect(p, *facet) for p in points for facet in oracle.facet_equations(*key(kind))]
    reach = max(oracle.squared_distance(centre, x) for x in images)
    rings = defaultdict(set)
    for x in oracle.vertices_in_ball(*key(kind), centre, reach):
        rings[oracle.squared_distance(x, centre)].add(x)
    return square, rings, set(points)


# -- the Delaunay property -------------------------------------------------------------------------


@every(SMALL)
def test_delaunay_means_that_no_vertex_lies_inside_the_circumsphere(kind):
    square, rings, _ = ball(kind)
    assert delaunay_verdict(triangulation(kind)).delaunay == (min(rings) == square)


@every(SMALL)
def test_the_nearest_mirror_vertices_are_vertices_where_they_should_be(kind):
    square, rings, own = ball(kind)
    verdict = delaunay_verdict(triangulation(kind))
    for witness in verdict.nearest:
        assert witness.point in rings[witness.squared_distance] - own
        assert (witness.squared_distance < square) == (not verdict.delaunay)


@every(KINDS)
def test_mirror_vertices_are_mirror_images(kind):
    t = triangulation(kind)
    points = oracle.vertices(*key(kind))
    centre = oracle.circumcentre(points)
    mirrors = mirror_vertices(t)
    assert [m.facet for m in mirrors] == list(range(kind.rank + 1))
    for m, (normal, k) in zip(mirrors, oracle.facet_equations(*key(kind)), strict=True):
        assert m.point == oracle.reflect(points[m.facet], normal, k)
        assert m.squared_distance == oracle.squared_distance(m.point, centre)


@every(KINDS)
def test_witnesses_against_delaunay_are_vertices_strictly_inside(kind):
    t = triangulation(kind)
    verdict = delaunay_verdict(t)
    assert verdict.nearest
    for witness in verdict.nearest:
        assert t.is_vertex_by_rank(witness.point)
        inside = (
            oracle.squared_distance(witness.point, t.simplex.circumcentre) < t.simplex.squared_circumradius
        )
        assert inside == (not verdict.delaunay)


@pytest.mark.parametrize("name", ["B~3", "B~4", "B~5", "D~4", "D~5"])
def test_the_deepest_vertex_is_found_by_folding_the_centre(name):
    """Against all half-integer points; in D~5 no mirror image is the deepest."""
    t = triangulation(name)
    centre, d = t.simplex.circumcentre, t.dimension

    def square(x, c):
        return sum((a - b) ** 2 for a, b in zip(x, c, strict=True))

    halves = product([Fraction(k, 2) for k in range(-1, 3)], repeat=d)
    inside = [x for x in halves if square(x, centre) < t.simplex.squared_circumradius]
    deepest = min(square(x, centre) for x in inside if t.is_vertex_by_rank(x))
    home = t.fold(centre).point
    assert deepest == min(square(u, home) for u in t.simplex.vertices)
    mirror = min(v.squared_distance for v in mirror_vertices(t))
    assert deepest < mirror if name == "D~5" else deepest == mirror


@every([*KINDS, *(Type(letter, d) for letter in "ABCD" for d in (15, 30))])
def test_delaunay_are_a_c_f4_and_g2(kind):
    t = triangulation(kind)
    assert bool(delaunay_verdict(t)) == is_self_centred(t.simplex) == (kind.family in DELAUNAY)


@every(KINDS)
def test_where_the_circumcentre_lies(kind):
    t = triangulation(kind)
    levels = t.levels(t.simplex.circumcentre)
    expected = (
        Position.INSIDE if min(levels) > 0 else Position.BOUNDARY if min(levels) == 0 else Position.OUTSIDE
    )
    assert circumcentre_position(t.simplex) is delaunay_verdict(t).position is expected
    assert (expected is Position.INSIDE) == (kind.letter == "A")


def test_a_regular_simplex_contains_its_circumcentre():
    assert circumcentre_position(regular_simplex(5)) is Position.INSIDE


# -- protection ------------------------------------------------------------------------------------


@every(SMALL)
def test_protection_is_the_gap_to_the_next_vertex(kind):
    square, rings, own = ball(kind)
    others = {r: ring - own for r, ring in rings.items() if ring - own}
    nearest = min(others)
    result = protection(triangulation(kind))
    if nearest <= square:
        assert result.absolute == result.relative == 0
        assert not result
    else:
        assert result.absolute == sqrt(nearest) - sqrt(square)
        assert result.relative == sqrt(nearest / square) - 1
        assert {m.point for m in result.nearest} == others[nearest]
        assert result


@every(KINDS)
def test_protected_is_a_and_nothing_else(kind):
    assert bool(protection(triangulation(kind))) == (kind.letter == "A")


@pytest.mark.parametrize("d", range(2, 31))
def test_protection_of_a_in_closed_form(d):
    """R² = d(d+2)/12(d+1), and the next vertices are at R² + 2/(d+1)."""
    result = protection(triangulation(("A", d)))
    assert result.relative == sqrt(1 + Fraction(24, d * (d + 2))) - 1
    assert result.absolute == sqrt(Fraction(d * (d + 2) + 24, 12 * (d + 1))) - sqrt(
        Fraction(d * (d + 2), 12 * (d + 1))
    )
    assert len(result.nearest) == d + 1


def nearest_in_the_lattice(d, keep=2):
    """The least squared distances of the vertices of A~d from the circumcentre, with their numbers.

    The vertices are the points n - (j/(d+1), …) with n an integer vector of sum j, 0 <= j <= d, and the
    circumcentre is ±(d/2 - i)/(d+1). Its coordinates are below 1/2, so only n_i in -2 … 3 come near. One
    coordinate after the other, keep the least values for each partial sum.
    """
    n = d + 1
    centre = [Fraction(2 * i - d, 2 * n) for i in range(n)]
    total = defaultdict(int)
    for j in range(n):
        sums = {0: {Fraction(0): 1}}
        for c in centre:
            grown = defaultdict(lambda: defaultdict(int))
            for partial, values in sums.items():
                for k in range(-2, 4):
                    for value, count in values.items():
                        grown[partial + k][value + (k - Fraction(j, n) - c) ** 2] += count
            sums = {p: dict(sorted(values.items())[:keep]) for p, values in grown.items() if abs(p) <= 2 * n}
        for value, count in sums[j].items():
            total[value] += count
    return sorted(total.items())[:keep]


@pytest.mark.parametrize("d", [2, 3, 4, 5, 6, 7, 12])
def test_protection_of_a_from_the_nearest_lattice_points(d):
    t = triangulation(("A", d))
    result = protection(t)
    (square, own), (next_square, others) = nearest_in_the_lattice(d)
    assert (square, next_square) == (t.simplex.squared_circumradius, result.nearest[0].squared_distance)
    assert own == others == len(result.nearest) == d + 1


# -- the enumeration -------------------------------------------------------------------------------


@every([kind for kind in SMALL if kind.family in DELAUNAY])
def test_vertices_by_distance_are_all_vertices_by_distance(kind):
    _, rings, _ = ball(kind)
    listed = list(takewhile(lambda pair: pair[0] <= max(rings), vertices_by_distance(triangulation(kind))))
    assert [square for square, _ in listed] == sorted(square for square, _ in listed)
    assert len(listed) == len(set(listed)) == sum(map(len, rings.values()))
    assert set(listed) == {(square, x) for square, ring in rings.items() for x in ring}


@pytest.mark.parametrize("d", range(2, 8))
def test_protection_of_a_by_enumeration(d):
    t = triangulation(("A", d))
    listed = list(islice(vertices_by_distance(t), 2 * d + 3))
    assert {x for _, x in listed[: d + 1]} == set(t.simplex.vertices)
    assert {square for square, _ in listed[d + 1 : 2 * d + 2]} == {protection(t).nearest[0].squared_distance}
    assert {x for _, x in listed[d + 1 : 2 * d + 2]} == {m.point for m in protection(t).nearest}
    assert listed[-1][0] > listed[-2][0]


def test_there_is_no_such_order_if_the_centre_is_outside():
    with pytest.raises(InvalidInput, match="B~3 is not self-centred"):
        next(vertices_by_distance(triangulation("B~3")))
