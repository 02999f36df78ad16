"""Root systems: each number by two routes that have nothing in common but the simple roots."""

import itertools
import math
from fractions import Fraction

import numpy as np
import oracle
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from strategies import small_fractions
from sympy import ZZ
from sympy.combinatorics import Permutation, PermutationGroup
from sympy.polys.matrices import DomainMatrix

from coxeter import InvalidInput, RationalMatrix, Type, root_system, triangulations_up_to

SMALL = [Type("A", 1), Type("B", 2)]
KINDS = sorted([*SMALL, *triangulations_up_to(8)])
LARGE = [Type(letter, d) for letter in "ABCD" for d in (30, 60)]

ROOTS = {"E6": 72, "E7": 126, "E8": 240, "F4": 48, "G2": 12}
ORDERS = {"E6": 51840, "E7": 2903040, "E8": 696729600, "F4": 1152, "G2": 12}
DETERMINANTS = {"E6": 3, "E7": 2, "E8": 1, "F4": 1, "G2": 1}


def number_of_roots(kind):
    d = kind.rank
    return {"A": d * (d + 1), "B": 2 * d * d, "C": 2 * d * d, "D": 2 * d * (d - 1)}.get(
        kind.family, ROOTS.get(kind.family)
    )


def order(kind):
    d = kind.rank
    signs = {"A": d + 1, "B": 2**d, "C": 2**d, "D": 2 ** (d - 1)}
    return math.factorial(d) * signs[kind.letter] if kind.letter in signs else ORDERS[kind.finite]


def determinant(kind):
    return {"A": kind.rank + 1, "B": 2, "C": 2, "D": 4}.get(kind.family, DETERMINANTS.get(kind.family))


def every(kinds=KINDS):
    return pytest.mark.parametrize("kind", kinds, ids=lambda kind: kind.finite)


def key(kind):
    return kind.letter, kind.rank


# -- simple roots and the Cartan matrix ------------------------------------------------------------


@every()
def test_simple_roots_are_bourbakis(kind):
    assert root_system(kind).simple_roots.rows() == oracle.simple_roots(*key(kind))


@every()
def test_cartan_integers_from_inner_products(kind):
    s = oracle.simple_roots(*key(kind))
    expected = [[2 * oracle.dot(a, b) / oracle.dot(b, b) for b in s] for a in s]
    assert root_system(kind).cartan_matrix.tolist() == expected


@pytest.mark.parametrize(
    ("name", "matrix"),
    [
        ("G2", [[2, -1], [-3, 2]]),
        ("B3", [[2, -1, 0], [-1, 2, -2], [0, -1, 2]]),
        ("C3", [[2, -1, 0], [-1, 2, -1], [0, -2, 2]]),
        ("F4", [[2, -1, 0, 0], [-1, 2, -2, 0], [0, -1, 2, -1], [0, 0, -1, 2]]),
    ],
)
def test_cartan_matrices_as_bourbaki_prints_them(name, matrix):
    assert root_system(name).cartan_matrix.tolist() == matrix


@every(KINDS + LARGE)
def test_connection_index_is_the_determinant(kind):
    system = root_system(kind)
    assert system.connection_index == determinant(kind) == RationalMatrix(system.cartan_matrix).det()


@every(KINDS + LARGE)
def test_inverse_gram_matrix_inverts_the_gram_matrix(kind):
    system = root_system(kind)
    gram = system.simple_roots @ system.simple_roots.T
    assert system.inverse_gram @ gram == RationalMatrix.identity(kind.rank)
    assert system.gram_determinant == gram.det()


@every(KINDS + LARGE)
def test_coweights_are_dual_to_the_simple_roots(kind):
    system = root_system(kind)
    assert system.fundamental_coweights @ system.simple_roots.T == RationalMatrix.identity(kind.rank)


@every()
def test_coweights_lie_in_the_span_of_the_roots(kind):
    extra = oracle.orthogonal_complement(oracle.simple_roots(*key(kind)))
    coweights = root_system(kind).fundamental_coweights.rows()
    assert all(oracle.dot(w, n) == 0 for w in coweights for n in extra)


# -- all roots -------------------------------------------------------------------------------------


@every()
def test_roots_are_those_generated_by_reflections(kind):
    rows = root_system(kind).roots.rows()
    assert set(rows) == oracle.roots(*key(kind))
    assert len(rows) == len(set(rows)) == number_of_roots(kind)


@every([Type("A", 20), Type("B", 20), Type("C", 20), Type("D", 20)])
def test_the_number_of_roots_in_larger_rank(kind):
    assert root_system(kind).roots.shape[0] == number_of_roots(kind)


@every()
def test_positive_roots_are_ordered_by_height(kind):
    system = root_system(kind)
    level = oracle.level_vector(*key(kind))
    rows = system.positive_roots.rows()
    assert set(rows) == oracle.positive_roots(*key(kind))
    assert list(system.heights) == [oracle.dot(level, r) for r in rows] == sorted(system.heights)


@every()
def test_coordinates_rebuild_the_positive_roots(kind):
    system = root_system(kind)
    for row, root in zip(system.positive_root_coordinates, system.positive_roots.rows(), strict=True):
        assert oracle.combine([int(c) for c in row], oracle.simple_roots(*key(kind))) == root


@every()
def test_coroots_of_coroots_are_roots(kind):
    roots = root_system(kind).roots
    assert set(root_system(kind).coroots.rows()) == {oracle.coroot(r) for r in roots.rows()}
    assert {oracle.coroot(r) for r in root_system(kind).coroots.rows()} == set(roots.rows())


@pytest.mark.parametrize("d", range(2, 8))
def test_b_and_c_are_dual(d):
    b, c = root_system(("B", d)), root_system(("C", d))
    assert set(b.coroots.rows()) == set(c.roots.rows())
    assert set(c.coroots.rows()) == set(b.roots.rows())


# -- the highest root ------------------------------------------------------------------------------


@every()
def test_climbing_ends_at_the_root_of_greatest_height(kind):
    system = root_system(kind)
    assert system.highest_root == oracle.highest_root(*key(kind))
    assert system.marks == oracle.coordinates(*key(kind), oracle.highest_root(*key(kind)))


@every(KINDS + LARGE)
def test_marks_span_the_null_space_of_the_affine_cartan_matrix(kind):
    neighbours = root_system(kind).affine_neighbours
    n = kind.rank + 1
    rows = [[2 if i == j else neighbours[i].get(j, 0) for i in range(n)] for j in range(n)]
    (null,) = DomainMatrix(rows, (n, n), ZZ).convert_to(sympy.QQ).nullspace().to_list()
    assert (1, *root_system(kind).marks) == tuple(x / null[0] for x in null)


@every()
def test_every_root_precedes_the_highest(kind):
    system = root_system(kind)
    top = system.highest_root
    assert all(system.precedes(r, top) for r in system.roots.rows())
    assert not any(system.precedes(top, r) for r in system.roots.rows() if r != top)


def test_the_order_of_roots_is_partial():
    system = root_system("A2")
    r, s = system.simple_roots.rows()
    assert not system.precedes(r, s)
    assert not system.precedes(s, r)
    assert system.precedes(r, r)


@every()
def test_the_highest_root_is_as_long_as_any(kind):
    system = root_system(kind)
    lengths = {oracle.dot(r, r) for r in oracle.roots(*key(kind))}
    assert system.squared_length_of_highest_root == max(lengths)
    assert set(system.squared_lengths) == lengths


# -- the Weyl group --------------------------------------------------------------------------------


@every(KINDS + LARGE)
def test_order_of_the_weyl_group_is_the_known_one(kind):
    assert root_system(kind).weyl_group_order == order(kind)


@every(KINDS + [Type(letter, 20) for letter in "ABCD"])
def test_order_from_the_exponents(kind):
    exponents = root_system(kind).exponents()
    assert math.prod(e + 1 for e in exponents) == order(kind)
    assert 2 * sum(exponents) == number_of_roots(kind)
    assert len(exponents) == kind.rank


def as_permutations(kind):
    """The simple reflections as permutations of the roots."""
    roots = sorted(oracle.roots(*key(kind)))
    index = {r: i for i, r in enumerate(roots)}
    return [[index[oracle.reflect(r, s)] for r in roots] for s in oracle.simple_roots(*key(kind))]


@every(SMALL + triangulations_up_to(4))
def test_order_by_listing_the_group(kind):
    generators = [tuple(p) for p in as_permutations(kind)]
    identity = tuple(range(len(generators[0])))
    group, new = {identity}, {identity}
    while new:
        new = {tuple(p[i] for i in g) for g in new for p in generators} - group
        group |= new
    assert root_system(kind).weyl_group_order == len(group)


@every([kind for kind in KINDS if kind.rank >= 5 and kind.letter in "ABDE"])
def test_order_by_schreier_and_sims(kind):
    group = PermutationGroup([Permutation(p) for p in as_permutations(kind)])
    assert root_system(kind).weyl_group_order == group.order()


@every()
def test_exponents_from_the_eigenvalues_of_a_coxeter_element(kind):
    """They are exp(2πi·e/h); those of order m are all the zeros of the m-th cyclotomic polynomial."""
    cartan, d = root_system(kind).cartan_matrix, kind.rank
    element = DomainMatrix.eye(d, ZZ)
    for j in range(d):
        reflection = np.eye(d, dtype=int)
        reflection[:, j] -= cartan[:, j]
        element = element * DomainMatrix(reflection.tolist(), (d, d), ZZ)
    exponents = root_system(kind).exponents()
    h = number_of_roots(kind) // d
    orders = [h // math.gcd(h, e) for e in exponents]
    x = sympy.Symbol("x")
    expected = math.prod(
        sympy.cyclotomic_poly(m, x) ** (orders.count(m) // sympy.totient(m)) for m in set(orders)
    )
    assert sympy.Poly(element.charpoly(), x) == sympy.Poly(expected, x)


# -- coordinates -----------------------------------------------------------------------------------


@given(st.sampled_from(KINDS), st.data())
def test_coordinates_of_a_combination_of_simple_roots(kind, data):
    weights = data.draw(st.tuples(*[small_fractions] * kind.rank))
    x = oracle.combine(weights, oracle.simple_roots(*key(kind)))
    assert root_system(kind).coordinates(x) == weights


@pytest.mark.parametrize(("name", "vector"), [("A2", (1, 0, 0)), ("G2", (1, 1, 1)), ("E6", (0,) * 7 + (1,))])
def test_a_vector_outside_the_span_has_no_coordinates(name, vector):
    with pytest.raises(InvalidInput, match=f"does not lie in the span of the roots of {name}"):
        root_system(name).coordinates(vector)


def test_a_vector_of_the_wrong_length_is_refused():
    with pytest.raises(InvalidInput, match=r"\(1, 0\) has 2 coordinates, 3 are needed"):
        root_system("B3").coordinates((1, 0))


# -- values ----------------------------------------------------------------------------------------


def test_a_root_system_is_a_value():
    assert root_system("B3") == root_system(("B", 3)) != root_system("C3")
    assert hash(root_system("B3")) == hash(root_system(("B", 3)))
    assert repr(root_system("B3")) == "root_system('B3')"


@pytest.mark.parametrize("attribute", ["roots", "positive_roots", "simple_roots", "inverse_gram", "coroots"])
def test_what_is_kept_cannot_be_changed(attribute):
    system = root_system("B3")
    with pytest.raises(ValueError, match="read-only"):
        getattr(system, attribute).numerators[0, 0] = 99


def test_two_simple_roots_meet_at_an_obtuse_angle():
    for kind in KINDS:
        rows = root_system(kind).simple_roots.rows()
        assert all(oracle.dot(r, s) <= 0 for r, s in itertools.combinations(rows, 2))


def test_lengths_are_fractions():
    assert root_system("F4").squared_lengths == (2, 2, 1, 1)
    assert all(type(x) is Fraction for x in root_system("F4").squared_lengths)
