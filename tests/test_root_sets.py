"""Questions to any finite set of vectors, against their definitions read literally."""

import itertools
from fractions import Fraction

import oracle
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from coxeter import InvalidInput, RationalMatrix, root_system, sqrt, triangulations_up_to
from coxeter.root_sets import (
    angle_table,
    cartan_integer,
    coroots,
    is_crystallographic,
    is_irreducible,
    is_reduced,
    is_root_system,
)

KINDS = triangulations_up_to(6)


def both_signs(*vectors):
    return [*vectors, *(tuple(-x for x in v) for v in vectors)]


def side_by_side(*names):
    """The union of root systems in orthogonal spaces."""
    blocks = [root_system(name).roots.rows() for name in names]
    widths = [len(block[0]) for block in blocks]
    return [
        (0,) * sum(widths[:i]) + row + (0,) * sum(widths[i + 1 :])
        for i, block in enumerate(blocks)
        for row in block
    ]


B2 = both_signs((1, 0), (0, 1), (1, 1), (1, -1))
BC2 = B2 + both_signs((2, 0), (0, 2))
STRETCHED_B2 = both_signs((3, 0), (0, 3), (1, 1), (1, -1))

EXAMPLES = {
    # name: (vectors, root system, crystallographic, reduced, irreducible)
    "nothing": ([], False, True, True, False),
    "one root": ([(1, 0)], False, True, True, True),
    "A1": (both_signs((1, 0)), True, True, True, True),
    "B2": (B2, True, True, True, True),
    "B2 without a root": (B2[1:], False, True, True, True),
    "B2 without a pair": ([v for v in B2 if v[0] * v[1] != 1], False, True, True, True),
    "BC2": (BC2, True, True, False, True),
    "stretched B2": (STRETCHED_B2, True, False, True, True),
    "A1 and A1": (both_signs((1, 0), (0, 3)), True, True, True, False),
    "A2 and G2": (side_by_side("A2", "G2"), True, True, True, False),
    "B3 and C2 and A1": (side_by_side("B3", "C2", "A1"), True, True, True, False),
    "tripled": (both_signs((1, 0), (3, 0)), True, False, False, True),
}


@pytest.mark.parametrize(
    ("vectors", "root", "crystallographic", "reduced", "irreducible"), EXAMPLES.values(), ids=EXAMPLES
)
def test_examples(vectors, root, crystallographic, reduced, irreducible):
    assert is_root_system(vectors) == root
    assert is_crystallographic(vectors) == crystallographic
    assert is_reduced(vectors) == reduced
    assert is_irreducible(vectors) == irreducible


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.finite)
def test_each_root_system_has_all_properties(kind):
    roots = root_system(kind).roots
    assert is_root_system(roots)
    assert is_crystallographic(roots)
    assert is_reduced(roots)
    assert is_irreducible(roots)


@pytest.mark.parametrize("kind", triangulations_up_to(4), ids=lambda kind: kind.finite)
def test_no_pair_of_roots_can_be_left_out(kind):
    roots = root_system(kind).roots.rows()
    for r in root_system(kind).positive_roots.rows():
        assert not is_root_system([s for s in roots if s not in both_signs(r)])


# -- the definitions, read literally ---------------------------------------------------------------

plane = st.tuples(st.integers(-2, 2), st.integers(-2, 2)).filter(any)
some_vectors = st.lists(plane, min_size=1, max_size=6, unique=True)
some_pairs = some_vectors.map(lambda vectors: sorted(set(both_signs(*vectors))))
parts_of_roots = st.sampled_from([B2, BC2, STRETCHED_B2]).flatmap(
    lambda roots: st.lists(st.sampled_from(roots), min_size=1, unique=True)
)
sets = some_vectors | some_pairs | parts_of_roots


@given(sets)
def test_root_system_by_definition(vectors):
    members = {tuple(map(Fraction, v)) for v in vectors}
    assert is_root_system(vectors) == all(oracle.reflect(x, r) in members for x in vectors for r in vectors)


@given(sets)
def test_crystallographic_by_definition(vectors):
    integers = [
        Fraction(2 * oracle.dot(r, s), oracle.dot(r, r)).denominator == 1 for r in vectors for s in vectors
    ]
    assert is_crystallographic(vectors) == all(integers)


@given(sets)
def test_reduced_by_definition(vectors):
    parallel = [(r, s) for r in vectors for s in vectors if r[0] * s[1] == r[1] * s[0]]
    assert is_reduced(vectors) == all(s in both_signs(r) for r, s in parallel)


@given(sets)
def test_irreducible_by_definition(vectors):
    splits = (set(part) for k in range(1, len(vectors)) for part in itertools.combinations(vectors, k))
    reducible = any(all(oracle.dot(r, s) == 0 for r in part for s in set(vectors) - part) for part in splits)
    assert is_irreducible(vectors) == (not reducible)


# -- Cartan integers and angles --------------------------------------------------------------------

TABLE = [
    # product, n(s, r), n(r, s), angle/pi, |s|/|r|: Bourbaki, Lie, VI, §1.3
    (0, 0, 0, "1/2", None),
    (1, -1, -1, "2/3", 1),
    (1, 1, 1, "1/3", 1),
    (2, -2, -1, "3/4", sqrt(2)),
    (2, 2, 1, "1/4", sqrt(2)),
    (3, -3, -1, "5/6", sqrt(3)),
    (3, 3, 1, "1/6", sqrt(3)),
    (4, -4, -1, "1", 2),
    (4, -2, -2, "1", 1),
    (4, 2, 2, "0", 1),
    (4, 4, 1, "0", 2),
]
ROWS = [(p, a, b, Fraction(angle), ratio) for p, a, b, angle, ratio in TABLE]


def rows_of(vectors):
    return [(row.product, row.n_sr, row.n_rs, row.angle, row.ratio) for row in angle_table(vectors)]


@pytest.mark.parametrize(
    ("vectors", "products"),
    [
        (both_signs((1, 0), (0, 2)), {0, 4}),
        (root_system("A2").roots, {1, 4}),
        (root_system("D4").roots, {0, 1, 4}),
        (root_system("B2").roots, {0, 2, 4}),
        (root_system("F4").roots, {0, 1, 2, 4}),
        (root_system("G2").roots, {0, 1, 3, 4}),
    ],
    ids=["A1xA1", "A2", "D4", "B2", "F4", "G2"],
)
def test_angles_are_rows_of_the_one_table(vectors, products):
    assert rows_of(vectors) == [row for row in ROWS if row[0] in products and 4 not in map(abs, row[1:3])]


def test_only_a_set_that_is_not_reduced_has_a_cartan_integer_of_four():
    assert rows_of(BC2) == [row for row in ROWS if row[0] in {0, 2, 4}]


@pytest.mark.parametrize(("product", "n_sr", "n_rs", "angle", "ratio"), ROWS)
def test_the_rows_of_the_table_are_consistent(product, n_sr, n_rs, angle, ratio):
    cosine = sympy.cos(sympy.pi * sympy.Rational(angle.numerator, angle.denominator))
    assert 4 * cosine**2 == product == n_sr * n_rs
    assert sympy.sign(cosine) == sympy.sign(n_sr)
    if ratio is not None:
        assert ratio * ratio == Fraction(n_sr, n_rs)


@pytest.mark.parametrize("name", ["B3", "F4", "G2"])
def test_cartan_integer_is_divided_by_the_second_length(name):
    system = root_system(name)
    rows = system.simple_roots.rows()
    assert [[cartan_integer(s, r) for r in rows] for s in rows] == system.cartan_matrix.tolist()


def test_angles_need_crystallographic_vectors():
    with pytest.raises(InvalidInput, match="not crystallographic"):
        angle_table(STRETCHED_B2)


def test_a_zero_vector_defines_no_cartan_integer():
    with pytest.raises(InvalidInput, match="zero"):
        cartan_integer((1, 0), (0, 0))


# -- edges of the range ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "question", [is_crystallographic, angle_table, lambda v: coroots(RationalMatrix.from_rows(v))]
)
def test_a_zero_vector_is_refused(question):
    with pytest.raises(InvalidInput, match="zero"):
        question([(0, 0), (1, 0)])


def test_a_set_with_the_zero_vector_is_no_root_system():
    assert not is_root_system([(0, 0)])
    assert not is_root_system([*B2, (0, 0)])


@pytest.mark.parametrize("n", [2**20, 2**30, 2**31, 2**40, 2**62, 2**70])
def test_coroots_do_not_overflow(n):
    rows = [(n, 1), (1, n - 1), (0, 3)]
    assert coroots(RationalMatrix.from_rows(rows)).rows() == tuple(
        oracle.coroot(tuple(map(Fraction, r))) for r in rows
    )


@pytest.mark.parametrize("n", [2**20, 2**31, 2**40, 2**70])
def test_no_question_overflows(n):
    stretched = [tuple(n * x for x in v) for v in B2]
    assert is_root_system(stretched)
    assert is_crystallographic(stretched)
    assert is_reduced(stretched)
    assert is_irreducible(stretched)
    assert angle_table(stretched) == angle_table(B2)
    assert not is_reduced([*stretched, (n + 1, 0)])


def test_vectors_of_different_lengths_are_refused():
    with pytest.raises(InvalidInput, match="different lengths"):
        is_root_system([(1, 0), (1,)])
