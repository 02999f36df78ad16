"""Any simplex: against the oracle, and under all that must not matter."""

import copy
import itertools
import pickle
from fractions import Fraction
from math import factorial

import numpy as np
import oracle
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import equal
from strategies import nonzero_fractions, rotations, simplices, small_fractions

from coxeter import (
    DegenerateSimplex,
    InexactInput,
    InvalidInput,
    Position,
    Simplex,
    qualities,
    regular_simplex,
    sqrt,
    surd,
)
from coxeter.simplex import position

TRIANGLE = [(0, 0), (1, 0), (0, 1)]


def squares(simplex):
    """All that is measured in squared lengths."""
    return (
        sorted(simplex.squared_edge_lengths[i, j] for i, j in pairs(simplex)),
        sorted(simplex.squared_heights),
        [simplex.squared_longest_edge, simplex.squared_circumradius],
    )


def pairs(simplex):
    return itertools.combinations(range(simplex.dimension + 1), 2)


# -- against the oracle ----------------------------------------------------------------------------


@given(simplices())
def test_edges_and_heights(points):
    simplex = Simplex(points)
    edges = oracle.squared_edges(points)
    assert all(
        simplex.squared_edge_lengths[i, j] == simplex.squared_edge_lengths[j, i] == edges[i, j]
        for i, j in edges
    )
    assert simplex.squared_longest_edge == max(edges.values())
    assert set(simplex.longest_edges()) == {pair for pair in edges if edges[pair] == max(edges.values())}
    assert list(simplex.squared_heights) == oracle.squared_heights(points)


@given(simplices())
def test_circumscribed_sphere(points):
    simplex, centre = Simplex(points), oracle.circumcentre(points)
    assert simplex.circumcentre == centre
    assert simplex.squared_circumradius == oracle.squared_distance(centre, points[-1])
    assert simplex.circumcentre_coordinates == oracle.barycentric(points, centre)


@given(simplices())
def test_volume(points):
    assert simplex_square(Simplex(points).volume) == oracle.squared_volume(points)


def simplex_square(length):
    assert length.sign() > 0
    return (length * length).as_fraction()


@given(simplices())
def test_lengths_are_the_positive_roots_of_their_squares(points):
    simplex = Simplex(points)
    assert [simplex_square(h) for h in simplex.heights] == list(simplex.squared_heights)
    assert simplex_square(simplex.minimal_height) == min(simplex.squared_heights)
    assert simplex_square(simplex.longest_edge) == simplex.squared_longest_edge
    assert simplex_square(simplex.circumradius) == simplex.squared_circumradius


@settings(max_examples=20)
@given(simplices(max_dimension=3))
def test_inscribed_ball(points):
    simplex = Simplex(points)
    assert equal(simplex.inradius, oracle.inradius(points))
    for ours, theirs in zip(simplex.incentre, oracle.incentre(points), strict=True):
        assert equal(surd(ours), theirs)


@given(simplices(min_dimension=2))
def test_dihedral_angles(points):
    """The inward normal of a facet points from the foot of the perpendicular to the vertex."""
    normals = [oracle.minus(x, oracle.foot(oracle.without(points, k), x)) for k, x in enumerate(points)]
    simplex = Simplex(points)
    for i, j in pairs(simplex):
        product = oracle.dot(normals[i], normals[j])
        square = product**2 / oracle.dot(normals[i], normals[i]) / oracle.dot(normals[j], normals[j])
        cosine = simplex.dihedral_cosine(i, j)
        assert (cosine * cosine).as_fraction() == square
        assert cosine.sign() == (product < 0) - (product > 0)


@given(simplices(), st.data())
def test_barycentric_coordinates(points, data):
    free = data.draw(st.tuples(*[small_fractions] * (len(points) - 1)))
    weights = (1 - sum(free), *free)
    point = oracle.combine(weights, points)
    simplex = Simplex(points)
    assert simplex.point(weights) == point
    assert simplex.barycentric(point) == weights == oracle.barycentric(points, point)


@given(simplices())
def test_the_circumcentre_is_placed_by_its_signs(points):
    least = min(oracle.barycentric(points, oracle.circumcentre(points)))
    expected = Position.INSIDE if least > 0 else Position.BOUNDARY if least == 0 else Position.OUTSIDE
    assert position(Simplex(points).circumcentre_coordinates) is expected


@pytest.mark.parametrize(
    ("apex", "place"), [((1, 2), Position.INSIDE), ((1, 1), Position.BOUNDARY), ((5, 1), Position.OUTSIDE)]
)
def test_the_circumcentre_of_an_acute_a_right_and_an_obtuse_triangle(apex, place):
    assert position(Simplex([(0, 0), (2, 0), apex]).circumcentre_coordinates) is place


@given(simplices())
def test_the_gradients_are_dual_to_the_edges(points):
    simplex = Simplex(points)
    d = simplex.dimension
    gradients = simplex.gradient_gram
    for i in range(1, d + 1):
        assert [
            sum(simplex.edge_gram[i - 1, k] * gradients[k + 1, j] for k in range(d)) for j in range(d + 1)
        ] == [(j == i) - (j == 0) for j in range(d + 1)]


# -- what must not matter --------------------------------------------------------------------------


@given(simplices(), st.data())
def test_the_order_of_the_vertices_does_not_matter(points, data):
    order = data.draw(st.permutations(range(len(points))))
    simplex, shuffled = Simplex(points), Simplex([points[i] for i in order])
    assert squares(simplex) == squares(shuffled)
    assert shuffled.squared_heights == tuple(simplex.squared_heights[i] for i in order)
    assert (simplex.volume, simplex.inradius) == (shuffled.volume, shuffled.inradius)
    assert (simplex.circumcentre, simplex.incentre) == (shuffled.circumcentre, shuffled.incentre)


@given(simplices(), st.data())
def test_a_translation_moves_only_the_centres(points, data):
    step = data.draw(st.tuples(*[small_fractions] * len(points[0])))
    moved = [tuple(a + b for a, b in zip(p, step, strict=True)) for p in points]
    simplex, image = Simplex(points), Simplex(moved)
    assert squares(simplex) == squares(image)
    assert (simplex.volume, simplex.inradius) == (image.volume, image.inradius)
    assert image.circumcentre == tuple(a + b for a, b in zip(simplex.circumcentre, step, strict=True))
    assert image.incentre == tuple(a + b for a, b in zip(simplex.incentre, step, strict=True))


@settings(max_examples=25)
@given(simplices(min_dimension=2, max_dimension=3), st.data())
def test_a_rotation_turns_only_the_centres(points, data):
    turn = data.draw(rotations(len(points[0])))
    simplex = Simplex(points)
    image = Simplex([oracle_turn(turn, p) for p in points])
    assert squares(simplex) == squares(image)
    assert (simplex.volume, simplex.inradius) == (image.volume, image.inradius)
    assert image.circumcentre == oracle_turn(turn, simplex.circumcentre)
    assert image.incentre == oracle_turn(turn, simplex.incentre)


def oracle_turn(matrix, x):
    return tuple(sum((a * b for a, b in zip(row, x, strict=True)), Fraction(0)) for row in matrix)


@given(simplices(), nonzero_fractions)
def test_scaling_scales_lengths_and_keeps_qualities(points, scale):
    simplex, image = Simplex(points), Simplex([tuple(scale * x for x in p) for p in points])
    assert image.squared_circumradius == scale**2 * simplex.squared_circumradius
    assert image.inradius == abs(scale) * simplex.inradius
    assert image.volume == abs(scale) ** simplex.dimension * simplex.volume
    assert qualities(image) == qualities(simplex)


@given(simplices(max_dimension=3), st.sampled_from([2, 3, "1/2", "5/3"]))
def test_scaling_by_a_square_root_takes_the_other_way_through_the_code(points, square):
    factor = sqrt(square)
    simplex, image = Simplex(points), Simplex([tuple(factor * x for x in p) for p in points])
    assert image.squared_circumradius == surd(square) * simplex.squared_circumradius
    assert image.inradius == factor * simplex.inradius
    assert image.volume == factor**simplex.dimension * simplex.volume
    assert image.circumcentre == tuple(factor * x for x in simplex.circumcentre)
    assert image.incentre == tuple(factor * x for x in simplex.incentre)
    assert qualities(image) == qualities(simplex)


@given(simplices())
def test_more_coordinates_do_not_matter(points):
    simplex, image = Simplex(points), Simplex([(7, *p, 0) for p in points])
    assert squares(simplex) == squares(image)
    assert image.circumcentre == (7, *simplex.circumcentre, 0)


# -- known simplices -------------------------------------------------------------------------------


def test_the_triangle_of_sides_3_4_5():
    triangle = Simplex([(0, 0), (3, 0), (0, 4)])
    assert triangle.heights == (Fraction(12, 5), 3, 4)
    assert (triangle.inradius, triangle.circumradius, triangle.volume) == (1, Fraction(5, 2), 6)
    assert triangle.incentre == (1, 1)
    assert [triangle.dihedral_cosine(i, j) for i, j in pairs(triangle)] == [Fraction(4, 5), Fraction(3, 5), 0]
    assert triangle.longest_edges() == ((1, 2),)


@pytest.mark.parametrize("d", range(1, 13))
def test_the_regular_simplex_in_closed_form(d):
    simplex = regular_simplex(d)
    assert simplex.squared_longest_edge == 2
    assert simplex.squared_heights == (Fraction(d + 1, d),) * (d + 1)
    assert simplex.squared_circumradius == Fraction(d, d + 1)
    assert simplex.volume == sqrt(d + 1) / factorial(d)
    assert simplex.inradius == 1 / sqrt(d * (d + 1))
    assert simplex.incentre == simplex.circumcentre == (Fraction(1, d + 1),) * (d + 1)


@pytest.mark.parametrize("d", [*range(1, 13), 40])
def test_the_regular_simplex_is_the_one_with_its_vertices(d):
    structured, generic = regular_simplex(d), Simplex(regular_simplex(d).vertices)
    assert structured.edge_gram == generic.edge_gram
    assert structured.gradient_gram == generic.gradient_gram
    assert structured.gram_determinant == generic.gram_determinant
    assert structured.circumcentre == generic.circumcentre
    assert structured.vertex_matrix == generic.vertex_matrix


@pytest.mark.parametrize("d", range(2, 6))
def test_dihedral_angles_of_the_regular_simplex(d):
    assert {regular_simplex(d).dihedral_cosine(i, j) for i, j in pairs(regular_simplex(d))} == {
        Fraction(1, d)
    }


TETRAHEDRON = [
    (0, 0, 0),
    (1, 0, 0),
    ("1/2", "sqrt(3)/2", 0),
    ("1/2", sympy.sqrt(3) / 6, sqrt(6) / 3),
]


def test_the_regular_tetrahedron_with_irrational_coordinates():
    simplex, regular = Simplex(TETRAHEDRON), regular_simplex(3)
    assert set(simplex.squared_heights) == {Fraction(2, 3)}
    assert simplex.volume == sqrt(2) / 12
    assert simplex.circumcentre == simplex.incentre == (Fraction(1, 2), sqrt(3) / 6, sqrt(6) / 12)
    assert qualities(simplex) == qualities(regular)


def test_irrational_vertices_are_kept_as_given():
    simplex = Simplex(TETRAHEDRON)
    assert simplex.vertices[3] == (Fraction(1, 2), sqrt(3) / 6, sqrt(6) / 3)
    with pytest.raises(InvalidInput, match="irrational vertices"):
        simplex.vertex_matrix  # noqa: B018


def test_irrational_vertices_with_rational_edges():
    moved = [(f"sqrt(2) + {x}", f"sqrt(3) - {y}") for x, y in [(0, 0), (3, 0), (0, 4)]]
    assert squares(Simplex(moved)) == squares(Simplex([(0, 0), (3, 0), (0, 4)]))


LARGE = [2**20, 2**30, 2**31 - 1, 2**31, 2**32, 2**62 - 1, 2**62, 2**63, 2**70]


SHAPES = {
    "flat": lambda n: [(0, 0), (n, 0), (-n, 1)],
    "right": lambda n: [(-n, -n), (n, -n), (n, n)],
    "thin": lambda n: [(0, 0), (n, 1), (1, -n)],
}


@pytest.mark.parametrize("n", LARGE)
@pytest.mark.parametrize("shape", SHAPES)
def test_large_coordinates_do_not_overflow(shape, n):
    points = SHAPES[shape](n)
    simplex = Simplex(points)
    points = [tuple(map(Fraction, p)) for p in points]
    assert simplex.squared_longest_edge == max(oracle.squared_edges(points).values())
    assert list(simplex.squared_heights) == oracle.squared_heights(points)
    assert simplex.circumcentre == oracle.circumcentre(points)
    assert simplex.squared_circumradius == oracle.squared_distance(simplex.circumcentre, points[0])
    assert simplex_square(simplex.volume) == oracle.squared_volume(points)


@pytest.mark.parametrize("dtype", [np.int8, np.uint8, np.int64, object])
def test_integer_arrays_are_read(dtype):
    points = [(100, 0), (0, 100), (1, 1)]
    assert squares(Simplex(np.array(points, dtype=dtype))) == squares(Simplex(points))


def test_coordinates_of_all_kinds_are_read():
    mixed = [(0, Fraction(0)), ("1", sympy.Integer(0)), (np.int64(0), sqrt(1))]
    assert squares(Simplex(mixed)) == squares(Simplex(TRIANGLE))


@pytest.mark.parametrize(
    "points", [TRIANGLE, [(0, 0), ("sqrt(2)", 0), (0, "sqrt(2)")]], ids=["rational", "irrational"]
)
@pytest.mark.parametrize(
    "sent", [copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))], ids=["copied", "pickled"]
)
def test_a_simplex_can_be_sent_elsewhere_after_it_was_used(points, sent):
    simplex = Simplex(points)
    used = (simplex.volume, simplex.gradient_gram, simplex.circumcentre)
    image = sent(simplex)
    assert (image.volume, image.gradient_gram, image.circumcentre) == used
    assert image.vertices == simplex.vertices


# -- refusals --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "value",
    [0.5, float("nan"), np.float64(1), sympy.Float("0.5")],
    ids=repr,
)
def test_an_inexact_coordinate_is_named(value):
    with pytest.raises(InexactInput, match=r"^vertex 1, coordinate 0: .* is inexact: give an integer"):
        Simplex([(0, 0), (value, 0), (0, 1)])


@pytest.mark.parametrize(
    "value",
    ["foo", "", "1/0", "sqrt(x)", "sqrt(-1)", None, True, 1j, sympy.pi, sympy.Symbol("x"), [1]],
    ids=repr,
)
def test_a_coordinate_that_is_no_number_is_named(value):
    with pytest.raises(InvalidInput, match=r"^vertex 2, coordinate 1: "):
        Simplex([(0, 0), (1, 0), (0, value)])


def test_a_whole_array_of_floats_is_refused():
    with pytest.raises(InexactInput, match=r"^vertex 0, coordinate 0: "):
        Simplex(np.zeros((3, 2)))


@pytest.mark.parametrize(
    ("points", "dimensions"),
    [
        ([(0, 0), (1, 1), (2, 2)], 1),
        ([(0, 0), (0, 0)], 0),
        ([(0, 0), (1, 0), (0, 1), (1, 1)], 2),
        ([(0, 0), ("sqrt(2)", "sqrt(2)"), ("2*sqrt(2)", "2*sqrt(2)")], 1),
        ([(1, 0, 0), (0, 1, 0), (0, 0, 1), ("1/3", "1/3", "1/3")], 2),
    ],
)
def test_dependent_points_are_told_the_dimension_they_span(points, dimensions):
    with pytest.raises(
        DegenerateSimplex, match=f"^{len(points)} points .* dimension {dimensions} .*independent"
    ):
        Simplex(points)


def test_a_vertex_of_another_length_is_named():
    with pytest.raises(InvalidInput, match=r"vertex 1 .*same number of coordinates"):
        Simplex([(0, 0), (1,), (0, 1)])


@pytest.mark.parametrize("points", [[], [(0, 0)]])
def test_one_point_is_too_few(points):
    with pytest.raises(InvalidInput, match="at least two points"):
        Simplex(points)


@pytest.mark.parametrize("points", [5, None, "abc", [1, 2, 3], ["ab", "cd"], [{0, 1}, {2, 3}]], ids=repr)
def test_what_is_no_list_of_points_is_refused(points):
    with pytest.raises(InvalidInput, match="vertices are points: give a list of lists"):
        Simplex(points)


def test_an_irrational_squared_edge_is_named():
    with pytest.raises(InvalidInput, match=r"vertex 0 to 1 and 1 have inner product 3 - 2\*sqrt\(2\)"):
        Simplex([("sqrt(2)", 0), (1, 0), (0, 1)])


@pytest.mark.parametrize("d", [0, -1, 2.0, "3", None, Fraction(3)], ids=repr)
def test_a_dimension_is_a_positive_integer(d):
    with pytest.raises(InvalidInput, match="is no dimension: give an integer >= 1"):
        regular_simplex(d)


@pytest.mark.parametrize(("i", "j"), [(0, 0), (2, -1), (0, 3), (-4, 0)])
def test_an_angle_is_between_two_facets_that_exist(i, j):
    with pytest.raises(InvalidInput):
        Simplex(TRIANGLE).dihedral_cosine(i, j)


def test_a_point_off_the_affine_hull_has_no_barycentric_coordinates():
    with pytest.raises(InvalidInput, match="does not lie in the affine hull"):
        Simplex([(0, 0, 0), (1, 0, 0)]).barycentric((0, 1, 0))
    with pytest.raises(InvalidInput, match="3 coordinates, 2 are needed"):
        Simplex(TRIANGLE).barycentric((0, 1, 0))
    with pytest.raises(InexactInput):
        Simplex(TRIANGLE).barycentric((0.5, 0))


@pytest.mark.parametrize("simplex", [Simplex(TRIANGLE), Simplex([(0, 0), ("sqrt(2)", 0), (0, "sqrt(2)")])])
def test_as_many_weights_as_vertices_are_needed(simplex):
    with pytest.raises(InvalidInput):
        simplex.point((1, 2))


def test_what_all_callers_share_cannot_be_changed():
    with pytest.raises(ValueError, match="read-only"):
        regular_simplex(3).edge_gram.numerators[0, 0] = 99
    with pytest.raises(ValueError, match="read-only"):
        regular_simplex(3).gradient_gram.numerators[0, 0] = 99
