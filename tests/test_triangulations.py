"""The fundamental simplices: structured core, generic simplex and oracle must agree on every number."""

import itertools
import math
import pickle
from fractions import Fraction

import oracle
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from oracle import equal
from strategies import small_fractions

from coxeter import (
    InexactInput,
    InvalidInput,
    RationalMatrix,
    Simplex,
    Type,
    affine_reflection,
    coroot_lattice,
    normalized_qualities,
    qualities,
    sqrt,
    surd,
    triangulation,
    triangulations_up_to,
)
from coxeter.diagrams import affine_diagram

KINDS = triangulations_up_to(8)
LARGE = [Type(letter, d) for letter in "ABCD" for d in (30, 61)]
FEW = triangulations_up_to(4)


def every(kinds=KINDS):
    return pytest.mark.parametrize("kind", kinds, ids=lambda kind: kind.affine)


def key(kind):
    return kind.letter, kind.rank


def square(length):
    assert length.sign() > 0
    return (length * length).as_fraction()


# -- against the oracle ----------------------------------------------------------------------------


@every()
def test_vertices_solve_the_equations_of_the_facets(kind):
    assert triangulation(kind).simplex.vertices == oracle.vertices(*key(kind))


@every()
def test_edges(kind):
    simplex, edges = triangulation(kind).simplex, oracle.squared_edges(oracle.vertices(*key(kind)))
    assert all(simplex.squared_edge_lengths[pair] == edges[pair] for pair in edges)
    assert square(simplex.longest_edge) == max(edges.values())


@every()
def test_heights(kind):
    simplex, heights = triangulation(kind).simplex, oracle.squared_heights(oracle.vertices(*key(kind)))
    assert list(simplex.squared_heights) == heights
    assert square(simplex.minimal_height) == min(heights)


@every()
def test_circumscribed_sphere(kind):
    simplex, points = triangulation(kind).simplex, oracle.vertices(*key(kind))
    centre = oracle.circumcentre(points)
    assert simplex.circumcentre == centre
    assert {oracle.squared_distance(centre, p) for p in points} == {square(simplex.circumradius)}


@every()
def test_inscribed_ball(kind):
    simplex, points = triangulation(kind).simplex, oracle.vertices(*key(kind))
    assert equal(simplex.inradius, oracle.inradius(points))
    for ours, theirs in zip(simplex.incentre, oracle.incentre(points), strict=True):
        assert equal(surd(ours), theirs)


@every()
def test_volume(kind):
    assert square(triangulation(kind).simplex.volume) == oracle.squared_volume(oracle.vertices(*key(kind)))


@every()
def test_qualities_from_the_vertices(kind):
    points, values = oracle.vertices(*key(kind)), qualities(triangulation(kind).simplex)
    d = kind.rank
    height, edge = min(oracle.squared_heights(points)), max(oracle.squared_edges(points).values())
    radius = oracle.squared_distance(oracle.circumcentre(points), points[0])
    assert square(values["aspect_ratio"]) == height / (4 * radius)
    assert square(values["thickness"]) == height / edge
    assert square(values["fatness"]) == oracle.squared_volume(points) / edge**d
    assert equal(values["radius_ratio"], oracle.inradius(points) / oracle.root_of(radius))


@every()
def test_normalized_qualities_from_the_vertices(kind):
    """The regular simplex with edge 1 has h² = (d+1)/2d, R² = d/(2(d+1)), V² = (d+1)/(2^d d!²), r/R = 1/d."""
    points, values = oracle.vertices(*key(kind)), normalized_qualities(triangulation(kind).simplex)
    d = kind.rank
    height, edge = min(oracle.squared_heights(points)), max(oracle.squared_edges(points).values())
    radius = oracle.squared_distance(oracle.circumcentre(points), points[0])
    volume = Fraction(d + 1, 2**d * math.factorial(d) ** 2)
    assert square(values["aspect_ratio"]) == height / radius * Fraction(d, d + 1) ** 2
    assert square(values["thickness"]) == height / edge * Fraction(2 * d, d + 1)
    assert values["fatness"] ** (2 * d) == oracle.squared_volume(points) / edge**d / volume
    assert equal(values["radius_ratio"], d * oracle.inradius(points) / oracle.root_of(radius))
    assert all(0 < value < 1 for value in values.values()) or kind == Type("A", 2)


def test_only_the_triangle_a2_is_regular():
    assert set(normalized_qualities(triangulation("A~2").simplex).values()) == {1}


# -- structured against generic --------------------------------------------------------------------


@every(KINDS + LARGE)
def test_the_two_gram_matrices_are_inverse(kind):
    simplex = triangulation(kind).simplex
    block = RationalMatrix(simplex.gradient_gram.numerators[1:, 1:], simplex.gradient_gram.denominator)
    assert simplex.edge_gram @ block == RationalMatrix.identity(kind.rank)


@every(KINDS + LARGE)
def test_the_gradients_add_up_to_zero(kind):
    assert not triangulation(kind).simplex.gradient_gram.numerators.sum(axis=0).any()


@every(KINDS + LARGE)
def test_the_simplex_rebuilt_from_its_vertices_is_the_same(kind):
    structured = triangulation(kind).simplex
    generic = Simplex(structured.vertices)
    assert structured.edge_gram == generic.edge_gram
    assert structured.gradient_gram == generic.gradient_gram
    assert structured.gram_determinant == generic.gram_determinant
    assert structured.circumcentre == generic.circumcentre
    assert structured.incentre == generic.incentre
    assert normalized_qualities(structured) == normalized_qualities(generic)


@every(KINDS + LARGE)
def test_volume_from_the_order_of_the_weyl_group(kind):
    """|W| simplices fill a fundamental cell of the coroot lattice."""
    t = triangulation(kind)
    assert t.roots.weyl_group_order * t.simplex.volume == sqrt(coroot_lattice(t.roots).gram_determinant)


@pytest.mark.parametrize("n", [1, 2, 12, 13, 40])
@pytest.mark.parametrize("letter", "ABCD")
def test_heights_are_inverse_to_marks_and_lengths(letter, n):
    t = triangulation((letter, n + 3))
    lengths = [t.roots.squared_length_of_highest_root, *t.roots.squared_lengths]
    assert t.simplex.squared_heights == tuple(1 / (m * m * x) for m, x in zip(t.marks, lengths, strict=True))


# -- facets, alcoves, angles -----------------------------------------------------------------------


@every()
def test_facets_point_inwards(kind):
    t = triangulation(kind)
    points = oracle.vertices(*key(kind))
    for facet in t.facets:
        levels = [facet.level(p) for p in points]
        assert levels.pop(facet.index) > 0
        assert not any(levels)
    assert [facet.index for facet in t.facets] == list(range(kind.rank + 1))


@every()
def test_no_hyperplane_cuts_the_fundamental_simplex(kind):
    points = triangulation(kind).simplex.vertices
    for root in oracle.positive_roots(*key(kind)):
        assert all(0 <= oracle.dot(p, root) <= 1 for p in points)


@every()
def test_dihedral_angles_from_the_normals(kind):
    t = triangulation(kind)
    normals = [tuple(-x for x in oracle.highest_root(*key(kind))), *oracle.simple_roots(*key(kind))]
    for (i, j), angle in t.dihedral_angles().items():
        r, s = normals[i], normals[j]
        cosine = sympy.cos(sympy.pi * sympy.Rational(angle.numerator, angle.denominator))
        assert cosine**2 == sympy.Rational(
            *(oracle.dot(r, s) ** 2 / oracle.dot(r, r) / oracle.dot(s, s)).as_integer_ratio()
        )
        assert angle <= Fraction(1, 2)
        assert oracle.dot(r, s) <= 0


@every()
def test_dihedral_angles_are_the_labels_of_the_diagram(kind):
    t = triangulation(kind)
    graph = affine_diagram(t.roots)
    for (i, j), angle in t.dihedral_angles().items():
        label = graph.edges[i, j]["m"] if graph.has_edge(i, j) else 2
        assert angle == Fraction(1, label)


@given(st.sampled_from(FEW), st.integers(-3, 3), st.data())
def test_an_affine_reflection(kind, k, data):
    root = data.draw(st.sampled_from(sorted(oracle.roots(*key(kind)))))
    x = data.draw(st.tuples(*[small_fractions] * len(root)))
    image = affine_reflection(root, k, x)
    assert image == oracle.reflect(x, root, k)
    assert affine_reflection(root, k, image) == x
    assert oracle.dot(x, root) + oracle.dot(image, root) == 2 * k


def test_an_affine_reflection_needs_a_root_and_exact_numbers():
    with pytest.raises(InvalidInput, match="the root is zero"):
        affine_reflection((0, 0), 1, (1, 1))
    with pytest.raises(InexactInput):
        affine_reflection((1, 0), 1, (0.5, 1))
    with pytest.raises(InexactInput):
        affine_reflection((1, 0), 0.5, (1, 1))


# -- points ----------------------------------------------------------------------------------------

some_kinds = st.sampled_from(triangulations_up_to(6))


def points_of(data, kind, entries):
    """A random point of the span, from its inner products with the simple roots."""
    weights = data.draw(st.tuples(*[entries] * kind.rank))
    return oracle.combine(weights, triangulation(kind).roots.fundamental_coweights.rows())


@given(some_kinds, st.data())
def test_folding_ends_in_the_fundamental_simplex_and_can_be_undone(kind, data):
    x, t = points_of(data, kind, small_fractions), triangulation(kind)
    folding = t.fold(x)
    assert min(folding.barycentric) >= 0
    assert sum(folding.barycentric) == 1
    assert folding.point == oracle.combine(folding.barycentric, oracle.vertices(*key(kind)))
    assert t.unfold(folding.word, folding.point) == x


@given(some_kinds, st.data())
def test_folding_reflects_once_for_each_hyperplane_in_between(kind, data):
    x = points_of(data, kind, small_fractions)
    products = [oracle.dot(x, r) for r in oracle.positive_roots(*key(kind))]
    between = sum(max(0, math.ceil(-v), math.ceil(v) - 1) for v in products)
    assert len(triangulation(kind).fold(x).word) == between


@given(some_kinds, st.data())
def test_points_of_one_orbit_fold_to_one_point(kind, data):
    x, t = points_of(data, kind, small_fractions), triangulation(kind)
    root = data.draw(st.sampled_from(sorted(oracle.roots(*key(kind)))))
    image = oracle.reflect(x, root, data.draw(st.integers(-2, 2)))
    assert t.fold(image).point == t.fold(x).point


@given(some_kinds, st.sampled_from([1, 2, 3, 4, 6]), st.data())
def test_vertices_by_folding_and_by_definition(kind, denominator, data):
    numerators = st.integers(-2 * denominator, 2 * denominator)
    x = points_of(data, kind, numerators.map(lambda n: Fraction(n, denominator)))
    t = triangulation(kind)
    assert t.is_vertex(x) == t.is_vertex_by_rank(x)


@given(some_kinds, st.data())
def test_images_of_vertices_are_vertices_and_midpoints_of_edges_are_not(kind, data):
    t = triangulation(kind)
    u, v = data.draw(st.permutations(oracle.vertices(*key(kind))))[:2]
    word = data.draw(st.lists(st.integers(0, kind.rank), max_size=12))
    image, other = t.unfold(word, u), t.unfold(word, v)
    middle = tuple((a + b) / 2 for a, b in zip(image, other, strict=True))
    assert t.is_vertex(image)
    assert t.is_vertex_by_rank(image)
    assert not t.is_vertex(middle)
    assert not t.is_vertex_by_rank(middle)


@every(triangulations_up_to(3))
def test_vertices_among_the_points_of_a_fine_grid(kind):
    t = triangulation(kind)
    ball = oracle.vertices_in_ball(*key(kind), (Fraction(0),) * len(t.simplex.vertices[0]), Fraction(3, 2))
    rows = t.roots.fundamental_coweights.rows()
    grid = [
        oracle.combine([Fraction(n, 3) for n in ns], rows)
        for ns in itertools.product(range(-3, 4), repeat=kind.rank)
    ]
    grid += [
        oracle.combine([Fraction(n, 2) for n in ns], rows)
        for ns in itertools.product(range(-2, 3), repeat=kind.rank)
    ]
    near = [x for x in grid if oracle.dot(x, x) <= Fraction(3, 2)]
    assert near
    assert all(t.is_vertex(x) == (x in ball) for x in near)
    assert all(t.is_vertex(x) for x in ball)


@pytest.mark.parametrize("method", ["levels", "fold", "is_vertex", "is_vertex_by_rank"])
@pytest.mark.parametrize(
    ("name", "point"), [("A~2", (1, 0, 0)), ("G~2", (1, 1, 1)), ("E~6", (0,) * 7 + (1,))]
)
def test_a_point_outside_the_span_is_refused(method, name, point):
    with pytest.raises(InvalidInput, match=f"does not lie in the span of the roots of {name}"):
        getattr(triangulation(name), method)(point)


@pytest.mark.parametrize("method", ["levels", "fold", "is_vertex", "is_vertex_by_rank", "integral_roots"])
def test_a_point_that_cannot_be_read_is_refused(method):
    question = getattr(triangulation("B~3"), method)
    with pytest.raises(InvalidInput, match="2 coordinates, 3 are needed"):
        question((1, 0))
    with pytest.raises(InexactInput):
        question((0.5, 0, 0))


def test_integral_roots_are_those_with_integer_products():
    t = triangulation("F~4")
    x = (Fraction(1, 2), Fraction(1, 2), 0, 0)
    expected = {r for r in oracle.positive_roots("F", 4) if oracle.dot(r, x).denominator == 1}
    assert set(t.integral_roots(x).rows()) == expected


# -- values ----------------------------------------------------------------------------------------


def test_a_triangulation_can_be_sent_elsewhere_after_it_was_used():
    t = triangulation("B~3")
    copy = pickle.loads(pickle.dumps((t, t.simplex)))
    assert copy[0] == t
    assert copy[1].volume == t.simplex.volume


def test_a_triangulation_is_a_value():
    assert triangulation("B~3") == triangulation(("B", 3)) != triangulation("C~3")
    assert hash(triangulation("B~3")) == hash(triangulation("B3"))
    assert repr(triangulation("B~3")) == "triangulation('B~3')"
    assert (triangulation("B~3").name, triangulation("B~3").dimension, triangulation("B~3").marks) == (
        "B~3",
        3,
        (1, 1, 2, 2),
    )
