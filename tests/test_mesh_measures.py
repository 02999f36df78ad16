"""The measures of mesh people: values, a second route from the vertices alone, angles, formulas in d."""

import itertools
import math
import pickle
from fractions import Fraction

import flint
import oracle
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import simplices

import coxeter
from coxeter import (
    MESH_MEASURES,
    Angle,
    InvalidInput,
    Simplex,
    Surd,
    Unavailable,
    find_measure,
    regular_simplex,
    sqrt,
    symbolic_simplex,
    triangulation,
)
from coxeter.exact import arccos, regular_share
from coxeter.families import Piece
from coxeter.figures import quality_curves
from coxeter.names import MINIMAL_DIMENSION, triangulations_up_to
from coxeter.proofs import Refuted
from coxeter.proofs.edges import (
    mesh_quantity,
    shortest_edge,
    sum_of_inverse_squared_heights,
    sum_of_squared_edges,
)
from coxeter.quality import MEASURES, PAPER_MEASURES, condition, edge_ratio, mean_ratio
from coxeter.tables import measure_table

ANGLES = ("minimal_dihedral_angle", "maximal_dihedral_angle", "minimal_solid_angle")
LENGTHS = [name for name in MESH_MEASURES if name not in ANGLES]
TYPES = triangulations_up_to(8)


def corner(d):
    """The origin and the unit vectors."""
    return Simplex([(0,) * d, *(tuple(int(i == j) for j in range(d)) for i in range(d))])


# -- measures of lengths -----------------------------------------------------------------------------------


def knupp(points):
    """‖S‖² and ‖S⁻¹‖² and det(S)², S = A W⁻¹, with W a Cholesky factor of the Gram matrix of unit edges."""
    d = len(points) - 1
    edges = sympy.Matrix([[sympy.Rational(x.numerator, x.denominator) for x in oracle.minus(p, points[0])]
                          for p in points[1:]])  # fmt: skip
    unit = (sympy.eye(d) + sympy.ones(d, d)) / 2
    w = unit.cholesky().T
    s = (edges * edges.T).cholesky().T * w.inv()
    inverse = s.inv()
    return (
        sympy.nsimplify(sympy.simplify((s.T * s).trace())),
        sympy.nsimplify(sympy.simplify((inverse.T * inverse).trace())),
        sympy.simplify(s.det() ** 2),
    )


@pytest.mark.parametrize(
    "points",
    [
        [(0, 0), (3, 0), (0, 4)],
        [(0, 0), (5, 1), (-2, 3)],
        [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)],
        [(0, 0, 0), (2, 1, 0), (-1, 3, 1), (1, 0, 4)],
    ],
)
def test_mean_ratio_and_condition_are_those_of_the_matrix(points):
    points = [tuple(map(Fraction, p)) for p in points]
    d, simplex = len(points) - 1, Simplex(points)
    norm, inverse, det = knupp(points)
    assert Surd(norm) == 2 * simplex.sum_of_squared_edges / Fraction(d + 1)
    assert Surd(inverse) == simplex.sum_of_inverse_squared_heights / 2
    assert mean_ratio(simplex) ** d == Surd(det) * Surd(d) ** d / Surd(norm) ** d
    assert condition(simplex) == d / sqrt(Surd(norm * inverse))


@given(simplices(max_dimension=4))
@settings(deadline=None)
def test_lengths_by_a_second_route(points):
    simplex = Simplex(points)
    squares = list(oracle.squared_edges([tuple(map(Fraction, p)) for p in points]).values())
    heights = oracle.squared_heights([tuple(map(Fraction, p)) for p in points])
    assert simplex.sum_of_squared_edges == sum(squares)
    assert simplex.sum_of_inverse_squared_heights == sum(1 / h for h in heights)
    assert simplex.shortest_edge**2 == min(squares)
    assert edge_ratio(simplex) ** 2 == min(squares) / max(squares)


@given(simplices(max_dimension=4))
@settings(deadline=None)
def test_no_simplex_is_better_than_the_regular_one(points):
    simplex = Simplex(points)
    regular = len(set(oracle.squared_edges([tuple(map(Fraction, p)) for p in points]).values())) == 1
    for name in LENGTHS:
        value = find_measure(name).normalized(simplex)
        assert 0 < value <= 1
        if name != "edge_ratio" or not regular:
            assert (value == 1) == regular


@pytest.mark.parametrize(
    ("name", "d"),
    [(x, d) for x in MESH_MEASURES for d in (*range(1, 9), 40) if d > 1 or "dihedral" not in x],
)
def test_the_regular_simplex_has_one(name, d):
    assert find_measure(name).normalized(regular_simplex(d)) == 1


@pytest.mark.parametrize("kind", TYPES, ids=lambda kind: kind.affine)
def test_float_route(kind):
    """Knupp's matrix in floats, from the vertices."""
    import numpy as np

    simplex, d = triangulation(kind).simplex, kind.rank
    points = np.array([[float(x) for x in v] for v in simplex.vertices])
    gram = (points[1:] - points[0]) @ (points[1:] - points[0]).T
    eigenvalues = np.linalg.eigvals(gram @ np.linalg.inv((np.eye(d) + 1) / 2)).real  # those of SᵀS
    assert float(mean_ratio(simplex)) == pytest.approx(
        math.prod(eigenvalues ** (1 / d)) * d / sum(eigenvalues)
    )
    assert float(condition(simplex)) == pytest.approx(d / math.sqrt(sum(eigenvalues) * sum(1 / eigenvalues)))


# -- angles ------------------------------------------------------------------------------------------------


def test_known_angles():
    a = triangulation("A~3").simplex
    assert (a.minimal_dihedral_angle, a.maximal_dihedral_angle) == (60, 90)
    assert triangulation("G~2").simplex.minimal_dihedral_angle == 30
    assert regular_simplex(3).minimal_dihedral_angle.decimal(10) == "70.5287793655"
    assert corner(3).solid_angle(0) == Fraction(1, 8)
    assert corner(2).minimal_solid_angle == Fraction(1, 8)
    obtuse = Simplex([(0, 0), (4, 0), (-1, 1)])
    assert obtuse.maximal_dihedral_angle == 135
    assert Simplex([(0,), (1,)]).minimal_solid_angle == Fraction(1, 2)


@pytest.mark.parametrize("kind", TYPES, ids=lambda kind: kind.affine)
def test_solid_angles_are_one_over_the_stabilisers(kind):
    t = triangulation(kind)
    assert t.simplex.minimal_solid_angle == Fraction(1, t.roots.weyl_group_order)
    shares = [t.simplex.solid_angle(k) for k in range(kind.rank + 1)]
    assert min(shares) == t.simplex.minimal_solid_angle
    assert min(map(Fraction, t.dihedral_angles().values())) * 180 == t.simplex.minimal_dihedral_angle
    # the alternating sum of the angle sums of all faces vanishes (Gram); for d = 2: angles add up to 1/2
    if kind.rank == 2:
        assert sum(shares, Angle({})) == Fraction(1, 2)
    if kind.rank == 3:
        faces = [Fraction(1, 2)] * 4
        dihedral = [x / 2 for x in t.dihedral_angles().values()]
        assert sum(faces) - sum(dihedral) + sum(x.as_fraction() for x in shares) == 1


@given(simplices(max_dimension=3).filter(lambda points: len(points) == 4))
@settings(deadline=None, max_examples=30)
def test_gram_relation_of_a_tetrahedron(points):
    """Solid angles minus edge angles plus half the faces is 1: exact, with arccosines."""
    simplex = Simplex(points)
    shares = sum((simplex.solid_angle(k) for k in range(4)), Angle({}))
    dihedral = sum(
        (simplex.dihedral_angle_in_degrees(i, j) for i, j in itertools.combinations(range(4), 2)), Angle({})
    )
    assert shares - dihedral / 360 + 2 == 1


@given(simplices(max_dimension=3).filter(lambda points: len(points) == 4))
@settings(deadline=None, max_examples=30)
def test_solid_angles_by_the_tangent(points):
    """tan(Ω/2) = |det(a, b, c)| / (abc + (a·b)c + …), Van Oosterom and Strackee, in floats."""
    import numpy as np

    v = np.array([[float(x) for x in p] for p in points])
    if v.shape[1] != 3:
        return
    for k in range(4):
        a, b, c = (v[i] - v[k] for i in range(4) if i != k)
        na, nb, nc = (np.linalg.norm(x) for x in (a, b, c))
        bottom = na * nb * nc + a @ b * nc + b @ c * na + c @ a * nb
        omega = 2 * math.atan2(abs(np.linalg.det([a, b, c])), bottom)
        assert float(Simplex(points).solid_angle(k)) == pytest.approx(omega / (4 * math.pi), abs=1e-9)


def test_solid_angles_that_no_method_finds():
    with pytest.raises(Unavailable, match="from d = 4 on it is known for"):
        corner(5).minimal_solid_angle  # noqa: B018
    with pytest.raises(InvalidInput, match="4 is no vertex"):
        corner(3).solid_angle(4)
    assert corner(4).minimal_solid_angle == triangulation("D~4").simplex.minimal_solid_angle  # the same shape
    kuhn = Simplex([(1,) * k + (0,) * (6 - k) for k in range(7)])  # C~6 in another place and size
    assert kuhn.minimal_solid_angle == triangulation("C~6").simplex.minimal_solid_angle


@pytest.mark.parametrize("d", [2, 3])
def test_the_integral_for_the_regular_simplex_agrees_with_the_closed_form(d):
    from coxeter.exact import angle_sums

    with flint.ctx.workprec(128):
        ball = angle_sums.regular_ball(d, 128)
        assert ball.overlaps(regular_share(d).ball())
        assert ball.rad() < 1e-25


@pytest.mark.parametrize(("d", "digits"), [(4, "0.0097846884"), (5, "0.0019220437"), (8, "0.0000083688")])
def negative_orthant(d, correlation):
    """The probability that d normal variables, equally correlated, are all negative.

    Its derivative by the correlation is that of two of them being zero, times the same for the other d - 2:
    Plackett's identity, which on the sphere is Schläfli's.
    """
    import numpy as np

    if d < 2:
        return np.full_like(correlation, 0.5**d)
    nodes, weights = np.polynomial.legendre.leggauss(16)
    t = correlation[..., None] * (nodes + 1) / 2
    pair = math.comb(d, 2) / (2 * math.pi * np.sqrt(1 - t**2))
    return 0.5**d + correlation / 2 * (pair * negative_orthant(d - 2, t / (1 + 2 * t)) @ weights)


@pytest.mark.parametrize("d", range(2, 10))
def test_regular_shares(d):
    """One integral over a variable in the complex plane, and d/2 real ones, one inside the other."""
    import numpy as np

    probability = negative_orthant(d, np.asarray(-1 / d))
    assert float(regular_share(d)) == pytest.approx(float(probability), rel=1e-9)


def test_the_shares_of_small_regular_simplices_fall():
    shares = [regular_share(d) for d in range(1, 13)]
    assert all(b < a for a, b in itertools.pairwise(shares))
    assert len({hash(x) for x in shares}) == len(shares)


# -- exact angles --------------------------------------------------------------------------------------------

cosines = st.builds(
    lambda p, q, sign: sign * sqrt(Fraction(p, p + q)),
    st.integers(0, 30), st.integers(1, 30), st.sampled_from([1, -1]),
)  # fmt: skip


@given(st.lists(st.tuples(cosines, st.fractions(-3, 3, max_denominator=6)), min_size=1, max_size=3))
@settings(deadline=None, max_examples=60)
def test_sums_of_arccosines_agree_with_floats(terms):
    total = sum((arccos(c) * q for c, q in terms), Angle({}))
    expected = sum(math.acos(float(c)) / math.pi * float(q) for c, q in terms)
    assert float(total) == pytest.approx(expected, abs=1e-9)
    assert total - total == 0
    assert total + 1 > total
    assert total == total + 0
    assert total.sign() == (0 if abs(expected) < 1e-12 else math.copysign(1, expected))
    assert pickle.loads(pickle.dumps(total)) == total


def test_relations_between_arccosines_are_seen():
    third = arccos(Surd(Fraction(1, 3)))
    assert third + 2 * arccos(sqrt(Fraction(1, 3))) == 1
    assert arccos(Surd(Fraction(-7, 9))) == 2 * third
    assert arccos(Surd(Fraction(3, 5))) + arccos(Surd(Fraction(4, 5))) == Fraction(1, 2)
    assert (arccos(Surd(Fraction(3, 5))) * 180 + arccos(Surd(Fraction(4, 5))) * 180).as_fraction() == 90
    assert not arccos(Surd(Fraction(3, 5))).is_rational


def test_what_angles_refuse():
    x = arccos(Surd(Fraction(1, 3)))
    for action in (
        lambda: arccos(Surd(2)),
        lambda: arccos(sqrt(2) - 1),
        lambda: x * x,
        lambda: 1 / x / (1 / (x + 1)),
        lambda: 1 / x + x,
        x.as_fraction,
    ):
        with pytest.raises(InvalidInput):
            action()
    with pytest.raises(ZeroDivisionError):
        x / (x - x)
    with pytest.raises(AttributeError):
        x.num = {}
    with pytest.raises(TypeError):
        x + 0.5
    assert x != "a third"


def test_quotients_of_angles():
    x, y = arccos(Surd(Fraction(1, 3))), arccos(Surd(Fraction(1, 4)))
    assert x / y < 1 < y / x
    assert 1 / (1 / x) == x
    assert (3 * x) / x == 3
    assert arccos(Surd(Fraction(-7, 9))) / x == 2
    assert arccos(Surd(Fraction(-7, 9))) / x == 2
    assert Fraction(1, 2) / x < Fraction(2, 3) / x
    assert Fraction(1, 2) / x > Fraction(1, 2) / y
    assert sympy.N(sympy.sympify(str(x / y))) == pytest.approx(float(x / y))
    assert "arccos" in (x / y).latex()


# -- the registry --------------------------------------------------------------------------------------------


def test_the_default_stays_the_four_of_the_paper():
    assert tuple(MEASURES.values()) == PAPER_MEASURES
    assert set(coxeter.qualities(corner(3))) == {m.name for m in PAPER_MEASURES}
    with pytest.raises(InvalidInput, match="already a measure 'edge_ratio'"):
        coxeter.measure("edge_ratio")(abs)
    with pytest.raises(InvalidInput, match=r"there are aspect_ratio, .*, minimal_solid_angle"):
        find_measure("girth")


def test_smaller_may_be_better():
    measure = find_measure("maximal_dihedral_angle")
    assert not measure.larger_is_better
    assert all(find_measure(name).larger_is_better for name in MESH_MEASURES if name != measure.name)
    assert measure.normalized(corner(3)) == regular_simplex(3).maximal_dihedral_angle / 90
    assert measure.normalized(corner(3)) < 1


@pytest.mark.parametrize("name", MESH_MEASURES)
def test_every_measure_is_tabulated_and_drawn(name):
    measure = find_measure(name)
    table = measure_table(measure, 5)
    assert {row[0] for row in table.rows} == {"A~", "B~", "C~", "D~", "F~", "G~"}
    for format in ("text", "md", "latex", "csv", "json"):
        assert table.render(format)
        assert table.render(format, exact=True)
    assert table.rows[0][1] == 1
    assert math.isfinite(quality_curves(name, 5).draw().height)


def test_the_dimension_may_be_large():
    simplex = triangulation("B~400").simplex
    assert edge_ratio(simplex) == Fraction(1, 20)
    assert simplex.minimal_dihedral_angle == 45
    assert simplex.minimal_solid_angle == Fraction(1, 2**400 * math.factorial(400))


# -- formulas in d -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("letter", MINIMAL_DIMENSION)
@pytest.mark.parametrize("name", [*MEASURES, *LENGTHS])
def test_formulas_agree_with_the_core(letter, name):
    measure, shape = find_measure(name), symbolic_simplex(f"{letter}~d")
    raw, normalized = measure.of(shape), measure.normalized(shape)
    assert raw == measure(shape)
    for d in range(MINIMAL_DIMENSION[letter], 14):
        simplex = triangulation((letter, d)).simplex
        assert raw.at(d) == measure(simplex)
        assert normalized.at(d) == measure.normalized(simplex)
    assert "d" in raw.latex()
    with pytest.raises(InvalidInput, match=f"for d = {MINIMAL_DIMENSION[letter] - 1}"):
        raw.at(MINIMAL_DIMENSION[letter] - 1)


@pytest.mark.parametrize("letter", MINIMAL_DIMENSION)
@pytest.mark.parametrize("name", ANGLES)
def test_angles_in_d(letter, name):
    raw = find_measure(name).of(symbolic_simplex(f"{letter}~d"))
    for d in range(MINIMAL_DIMENSION[letter], 14):
        assert raw.at(d) == find_measure(name)(triangulation((letter, d)))
    with pytest.raises(InvalidInput, match="the regular simplex has no formula in d"):
        find_measure(name).normalized(symbolic_simplex(f"{letter}~d"))


@pytest.mark.parametrize("letter", MINIMAL_DIMENSION)
@pytest.mark.parametrize(
    "name", ["shortest_edge", "sum_of_squared_edges", "sum_of_inverse_squared_heights", *ANGLES]
)
def test_the_proofs_replay(letter, name):
    proof = mesh_quantity(letter, name)
    assert proof.replay(10) >= 7
    assert proof.decided or name in ANGLES


@pytest.mark.parametrize("letter", MINIMAL_DIMENSION)
def test_wrong_formulas_are_refuted(letter):
    with pytest.raises(Refuted):
        sum_of_squared_edges(letter, "d*(d + 1)*(d + 2)/13")
    with pytest.raises(Refuted):
        sum_of_inverse_squared_heights(letter, "8*d + 1")
    with pytest.raises(Refuted):
        shortest_edge(letter, (Piece("1/3", MINIMAL_DIMENSION[letter]),))


@pytest.mark.parametrize("d", range(1, 12))
def test_the_regular_simplex_in_d(d):
    for name in ("shortest_edge", "sum_of_squared_edges", "sum_of_inverse_squared_heights", "inradius"):
        assert getattr(symbolic_simplex("regular"), name).at(d) == getattr(regular_simplex(d), name)
    assert symbolic_simplex("regular").proof("shortest_edge").replay(6)


def test_a_measure_of_ones_own_in_letters():
    def ours(simplex):
        return sqrt(simplex.squared_shortest_edge / simplex.squared_longest_edge) + simplex.inradius / (
            simplex.dimension + 1
        )

    formula = ours(symbolic_simplex("A~d"))
    assert [piece.parity for piece in formula.pieces] == ["odd", "even"]
    for d in range(2, 12):
        assert formula.at(d) == ours(triangulation(("A", d)).simplex)


def test_formulas_are_equal_or_not():
    a, c = symbolic_simplex("A~d"), symbolic_simplex("C~d")
    assert find_measure("edge_ratio").of(a) == find_measure("thickness").normalized(a)
    assert find_measure("edge_ratio").of(c) != find_measure("thickness").normalized(c)
    assert 1 - (1 - c.volume) == c.volume
    negative = -c.volume
    assert -negative + 0 == c.volume
    assert 2**c.dimension == Surd(2) ** 1 * 2 ** (c.dimension - 1)
    assert bool(c.volume)


@pytest.mark.parametrize(
    ("action", "words"),
    [
        (lambda x: x.incentre, "has no formula in d for 'incentre'"),
        (lambda x: x.squared_heights, "has no formula in d for 'squared_heights'"),
        (lambda x: min(x.inradius, x.volume), "may depend on d"),
        (lambda x: math.sqrt(x.volume), "is a formula in d and no number"),
        (lambda x: range(x.dimension), "is a formula in d and no number"),
        (lambda x: x.volume * 0.5, "neither an exact number nor a formula"),
        (lambda x: symbolic_simplex("E~d"), "no family with the letter d"),
        (lambda x: symbolic_simplex("B~5"), "no family with the letter d"),
        (lambda x: symbolic_simplex("A"), "no family with the letter d"),
    ],
)
def test_what_letters_do_not_allow(action, words):
    with pytest.raises(InvalidInput, match=words):
        action(symbolic_simplex("B~d"))
