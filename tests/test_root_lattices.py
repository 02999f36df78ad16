"""The four lattices of a root system, and lattices in general."""

from fractions import Fraction

import oracle
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from strategies import small_fractions

from coxeter import (
    InexactInput,
    InvalidInput,
    Lattice,
    RationalMatrix,
    Type,
    coroot_lattice,
    coweight_lattice,
    root_lattice,
    root_system,
    triangulations_up_to,
    weight_lattice,
)

KINDS = [Type("A", 1), Type("B", 2), *triangulations_up_to(8)]
each = pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.finite)
some_kinds = st.sampled_from(triangulations_up_to(4))
quarters = st.builds(Fraction, st.integers(-8, 8), st.sampled_from([1, 2, 3, 4]))


def key(kind):
    return kind.letter, kind.rank


def is_integral(x, rows):
    return all(oracle.dot(x, r).denominator == 1 for r in rows)


def point_in_span(data, kind, entries):
    weights = data.draw(st.tuples(*[entries] * kind.rank))
    return oracle.combine(weights, oracle.simple_roots(*key(kind)))


# -- the four lattices -----------------------------------------------------------------------------


@each
def test_index_of_the_root_lattice_is_the_connection_index(kind):
    system = root_system(kind)
    f = system.connection_index
    assert root_lattice(system).index_in(weight_lattice(system)) == f
    assert coroot_lattice(system).index_in(coweight_lattice(system)) == f


@each
def test_index_squared_is_the_ratio_of_the_gram_determinants(kind):
    system = root_system(kind)
    small, large = root_lattice(system), weight_lattice(system)
    assert small.gram_determinant / large.gram_determinant == small.index_in(large) ** 2


@each
def test_dual_lattices(kind):
    system = root_system(kind)
    assert root_lattice(system).dual() == coweight_lattice(system)
    assert coroot_lattice(system).dual() == weight_lattice(system)
    for lattice in (root_lattice(system), coroot_lattice(system)):
        assert lattice.dual().dual() == lattice


@pytest.mark.parametrize("kind", [k for k in KINDS if k.letter in "ADE"], ids=lambda kind: kind.finite)
def test_roots_of_length_sqrt2_are_their_coroots(kind):
    system = root_system(kind)
    assert root_lattice(system) == coroot_lattice(system)
    assert weight_lattice(system) == coweight_lattice(system)


@pytest.mark.parametrize("d", range(2, 8))
def test_lattices_of_b_and_c(d):
    b, c = root_system(("B", d)), root_system(("C", d))
    cubic = Lattice(RationalMatrix.identity(d))
    assert root_lattice(b) == coroot_lattice(c) == coweight_lattice(b) == weight_lattice(c) == cubic
    assert root_lattice(c) == coroot_lattice(b)
    assert root_lattice(c).index_in(cubic) == 2


@each
def test_every_root_is_in_the_root_lattice_every_coroot_in_the_other(kind):
    system = root_system(kind)
    roots, coroots = root_lattice(system), coroot_lattice(system)
    for r in (*oracle.simple_roots(*key(kind)), oracle.highest_root(*key(kind))):
        assert r in roots
        assert oracle.coroot(r) in coroots
        assert tuple(x / 2 for x in r) not in roots


@given(some_kinds, st.data())
def test_coweights_have_integer_products_with_all_roots(kind, data):
    x = point_in_span(data, kind, quarters)
    assert (x in coweight_lattice(root_system(kind))) == is_integral(x, oracle.roots(*key(kind)))


@given(some_kinds, st.data())
def test_weights_have_integer_products_with_all_coroots(kind, data):
    x = point_in_span(data, kind, quarters)
    coroots = [oracle.coroot(r) for r in oracle.roots(*key(kind))]
    assert (x in weight_lattice(root_system(kind))) == is_integral(x, coroots)


@each
def test_coweights_are_in_the_coweight_lattice_and_half_of_them_are_not(kind):
    system = root_system(kind)
    for w in system.fundamental_coweights.rows():
        assert w in coweight_lattice(system)
        assert tuple(x / 2 for x in w) not in coweight_lattice(system)


@given(some_kinds, st.data())
def test_the_lattices_are_stable_under_reflections(kind, data):
    system = root_system(kind)
    for lattice in (
        root_lattice(system),
        coroot_lattice(system),
        weight_lattice(system),
        coweight_lattice(system),
    ):
        weights = data.draw(st.tuples(*[st.integers(-3, 3)] * kind.rank))
        x = oracle.combine(weights, lattice.basis.rows())
        assert all(oracle.reflect(x, s) in lattice for s in oracle.simple_roots(*key(kind)))


# -- lattices in general ---------------------------------------------------------------------------

bases = st.lists(st.tuples(*[small_fractions] * 3), min_size=1, max_size=3)


def lattice_of(rows):
    gram = [[oracle.dot(x, y) for y in rows] for x in rows]
    assume(oracle.determinant(gram) != 0)
    return Lattice.spanned_by(rows)


@given(bases, st.data())
def test_coordinates_are_the_integers_a_vector_was_made_with(rows, data):
    lattice = lattice_of(rows)
    weights = data.draw(st.tuples(*[st.integers(-9, 9)] * len(rows)))
    x = oracle.combine(weights, rows)
    assert lattice.coordinates(x) == weights
    assert x in lattice


@given(bases)
def test_the_dual_of_the_dual_is_the_lattice(rows):
    assert lattice_of(rows).dual().dual() == lattice_of(rows)


@given(bases, st.lists(st.lists(st.integers(-4, 4), min_size=3, max_size=3), min_size=3, max_size=3))
def test_the_index_is_the_determinant_of_the_change_of_basis(rows, change):
    assume(len(rows) == 3 and oracle.determinant(change) != 0)
    large = lattice_of(rows)
    small = Lattice.spanned_by([oracle.combine(row, rows) for row in change])
    assert small.index_in(large) == abs(oracle.determinant(change))
    assert small <= large
    assert (large <= small) == (small == large) == (abs(oracle.determinant(change)) == 1)


def test_a_lattice_does_not_depend_on_its_basis():
    assert Lattice.spanned_by([(1, 0), (0, 1)]) == Lattice.spanned_by([(1, 5), (1, 6)])
    assert Lattice.spanned_by([(1, 0), (0, 1)]) != Lattice.spanned_by([(1, 0), (0, 2)])


def test_lattices_of_different_spaces_are_not_equal():
    assert Lattice.spanned_by([(1, 0)]) != Lattice.spanned_by([(1, 0, 0)])
    assert Lattice.spanned_by([(1, 0)]) != Lattice.spanned_by([(1, 0), (0, 1)])
    assert Lattice.spanned_by([(1, 0)]) != 3


def test_a_lattice_of_lower_rank_has_no_index():
    with pytest.raises(InvalidInput, match="not contained, with finite index"):
        Lattice.spanned_by([(1, 0)]).index_in(Lattice.spanned_by([(1, 0), (0, 1)]))


def test_a_lattice_that_is_not_contained_has_no_index():
    with pytest.raises(InvalidInput, match="not contained"):
        Lattice.spanned_by([(1, 0), (0, 1)]).index_in(Lattice.spanned_by([(2, 0), (0, 1)]))


def test_dependent_vectors_are_no_basis():
    with pytest.raises(InvalidInput, match="3 vectors of rank 2 are no basis"):
        Lattice.spanned_by([(1, 0, 0), (0, 1, 0), (1, 1, 0)])


def test_a_vector_outside_the_span_is_not_in_the_lattice():
    lattice = Lattice.spanned_by([(1, 1, 0)])
    assert (1, 0, 0) not in lattice
    with pytest.raises(InvalidInput, match="does not lie in the span"):
        lattice.coordinates((1, 0, 0))


def test_a_vector_that_cannot_be_read_is_an_error_not_a_no():
    lattice = Lattice.spanned_by([(1, 0), (0, 1)])
    with pytest.raises(InexactInput):
        (0.5, 0) in lattice  # noqa: B015
    with pytest.raises(InvalidInput, match="3 coordinates, 2 are needed"):
        (1, 0, 0) in lattice  # noqa: B015


def test_membership_of_halves():
    d4 = root_lattice(root_system("D4"))
    half = (Fraction(1, 2),) * 4
    assert half not in d4
    assert half in weight_lattice(root_system("D4"))
    assert (1, 0, 0, 0) not in d4
    assert (1, 1, 0, 0) in d4
