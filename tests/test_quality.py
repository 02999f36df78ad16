"""The four measures, their normalisation, and measures that a user adds."""

import math
import warnings
from fractions import Fraction
from math import factorial

import pytest
from hypothesis import given
from strategies import simplices

from coxeter import (
    MEASURES,
    CoxeterError,
    InexactInput,
    InvalidInput,
    Simplex,
    Surd,
    aspect_ratio,
    fatness,
    measure,
    normalized_qualities,
    qualities,
    radius_ratio,
    regular_simplex,
    sqrt,
    symbolic_simplex,
    thickness,
    triangulation,
)
from coxeter.quality import find_measure

FOUR = ["aspect_ratio", "fatness", "thickness", "radius_ratio"]


def corner(d):
    """The origin and the unit vectors."""
    return Simplex([(0,) * d, *(tuple(int(i == j) for j in range(d)) for i in range(d))])


def test_the_triangle_of_sides_3_4_5():
    values = qualities(Simplex([(0, 0), (3, 0), (0, 4)]))
    assert values == {
        "aspect_ratio": Fraction(12, 25),
        "fatness": Fraction(6, 25),
        "thickness": Fraction(12, 25),
        "radius_ratio": Fraction(2, 5),
    }


@pytest.mark.parametrize("d", range(2, 13))
def test_the_corner_of_a_cube(d):
    """Height 1/√d, edge √2, circumradius √d/2, inradius 1/(d + √d), volume 1/d!."""
    simplex = corner(d)
    assert aspect_ratio(simplex) == Fraction(1, d)
    assert fatness(simplex) == 1 / (factorial(d) * sqrt(2) ** d)
    assert thickness(simplex) == 1 / sqrt(2 * d)
    assert radius_ratio(simplex) == 2 / (d * sqrt(d) + d)


@pytest.mark.parametrize("d", range(1, 13))
def test_raw_values_of_the_regular_simplex(d):
    values = qualities(regular_simplex(d))
    assert values == {
        "aspect_ratio": Fraction(d + 1, 2 * d),
        "fatness": sqrt(d + 1) / (factorial(d) * sqrt(2) ** d),
        "thickness": sqrt(Fraction(d + 1, 2 * d)),
        "radius_ratio": Fraction(1, d),
    }


@pytest.mark.parametrize("d", [*range(1, 13), 1009])
def test_the_regular_simplex_has_normalized_value_one(d):
    values = normalized_qualities(regular_simplex(d))
    assert values == dict.fromkeys(FOUR, 1)
    assert all(value.is_rational for value in values.values())


def test_normalized_fatness_is_a_power_of_one_over_d():
    simplex = corner(3)
    assert fatness.normalized(simplex) ** 3 == fatness(simplex) / fatness(regular_simplex(3))
    assert thickness.normalized(simplex) == thickness(simplex) / thickness(regular_simplex(3))


@given(simplices(max_dimension=5))
def test_no_simplex_is_better_than_the_regular_one(points):
    """For thickness, with P the Gram matrix of the vertices about their mean and Γ its pseudo-inverse:

    d² <= tr P · tr Γ,  tr P = (sum of squared edges)/(d+1) <= dL²/2,  tr Γ = (sum of 1/h_k²) <= (d+1)/h².
    """
    simplex = Simplex(points)
    edges = simplex.squared_edge_lengths
    regular = len({edges[i, j] for i in range(len(points)) for j in range(i)}) == 1
    for value in normalized_qualities(simplex).values():
        assert 0 < value <= 1
        assert (value == 1) == regular


# -- adding a measure ------------------------------------------------------------------------------


@pytest.fixture
def added():
    """Remove what a test adds."""
    before = dict(MEASURES)
    yield
    MEASURES.clear()
    MEASURES.update(before)


@pytest.mark.usefixtures("added")
def test_an_added_measure_is_reported_with_the_others():
    @measure("edges", r"\eta")
    def edge_ratio(simplex):
        edges = simplex.squared_edge_lengths
        return sqrt(
            min(edges[i, j] for i in range(simplex.dimension + 1) for j in range(i))
            / simplex.squared_longest_edge
        )

    assert list(MEASURES) == [*FOUR, "edges"]
    assert qualities(Simplex([(0, 0), (3, 0), (0, 4)]))["edges"] == Fraction(3, 5)
    assert normalized_qualities(regular_simplex(4))["edges"] == 1
    assert edge_ratio.normalized_symbol == r"\hat{\eta}"
    assert find_measure("edges") is edge_ratio


@pytest.mark.usefixtures("added")
def test_a_measure_per_dimension_is_normalized_by_a_root():
    @measure("volume", per_dimension=True)
    def volume(simplex):
        return simplex.volume

    doubled = Simplex([tuple(2 * x for x in row) for row in regular_simplex(4).vertices])
    assert volume.normalized(doubled) == 2
    assert volume.symbol == r"\text{volume}"
    assert volume.normalized_symbol.endswith("^{1/d}")


@pytest.mark.usefixtures("added")
def test_a_measure_may_return_an_integer_but_no_float():
    ours = measure("number of vertices")(lambda simplex: simplex.dimension + 1)
    theirs = measure("inexact")(lambda simplex: 0.5)
    assert isinstance(ours(corner(2)), Surd)
    assert ours(corner(2)) == 3
    with pytest.raises(InexactInput):
        theirs(corner(2))


@pytest.mark.usefixtures("added")
def test_a_measure_that_fails_is_named_with_its_line():
    @measure("broken")
    def broken(simplex):
        return simplex.dimension // 0

    with pytest.raises(
        InvalidInput, match=r"'broken' raised ZeroDivisionError: .* \(.*test_quality.py, line \d"
    ):
        broken(corner(2))


@pytest.mark.usefixtures("added")
def test_a_measure_that_depends_on_size_says_so():
    volume = measure("volume")(lambda simplex: simplex.volume)
    with pytest.warns(UserWarning, match="'volume' depends on the size of a simplex"):
        volume.normalized(corner(3))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        in_the_plane = measure("only in the plane")(lambda simplex: simplex.volume / simplex.longest_edge**2)
        in_the_plane.normalized(corner(2))
        measure("angle")(lambda simplex: simplex.minimal_dihedral_angle).normalized(corner(3))
        for known in MEASURES.values():
            if known.name in FOUR:
                known.normalized(corner(3))
    with pytest.warns(UserWarning, match="only in the plane"):
        in_the_plane.normalized(corner(3))


@pytest.mark.usefixtures("added")
def test_what_cannot_be_normalised_is_refused():
    negative = measure("negative")(lambda simplex: -simplex.inradius / simplex.circumradius)
    gap = measure("gap")(lambda simplex: simplex.maximal_dihedral_angle - simplex.minimal_dihedral_angle)
    less = measure("less", larger_is_better=False)(
        lambda simplex: simplex.shortest_edge / simplex.longest_edge - 1 / sqrt(3)
    )
    with pytest.raises(InvalidInput, match="'negative' is -1/3 of the regular 3-simplex"):
        negative.normalized(corner(3))
    with pytest.raises(InvalidInput, match="'gap' is 0 of the regular 3-simplex"):
        gap.normalized(corner(3))
    assert gap(triangulation("A~3")) == 30
    with pytest.raises(InvalidInput, match="'less' is 0 of this simplex: where smaller is better"):
        less.normalized(Simplex([(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)]))


@pytest.mark.parametrize("name", FOUR)
def test_a_name_is_taken_once(name):
    with pytest.raises(InvalidInput, match=f"there is already a measure '{name}': give another name"):
        measure(name)(abs)


@pytest.mark.usefixtures("added")
def test_a_cell_that_is_run_again_defines_its_measure_anew():
    for share in (1, 2):

        @measure("again")
        def again(simplex, share=share):
            return share * simplex.inradius / simplex.circumradius

    assert find_measure("again")(corner(2)) == again(corner(2)) == 2 * radius_ratio(corner(2))
    with pytest.raises(InvalidInput, match="already a measure 'again'"):

        @measure("again")
        def another(simplex):
            return simplex.inradius


@pytest.mark.parametrize("name", [abs, "", " ", 3])
def test_what_is_no_name_is_refused(name):
    with pytest.raises(InvalidInput, match=r'is no name: put @measure\("my name"\)'):
        measure(name)


@pytest.mark.usefixtures("added")
def test_roots_that_are_not_exact_are_told_those_that_are():
    for function in (
        lambda simplex: simplex.volume ** (1 / simplex.dimension),
        lambda simplex: math.sqrt(simplex.volume),
    ):
        with pytest.raises(CoxeterError, match=r"coxeter\.sqrt and coxeter\.quality\.root"):
            measure("volume root")(function)(corner(3))
    angle = measure("angle", per_dimension=True)(lambda simplex: simplex.minimal_dihedral_angle)
    with pytest.raises(InvalidInput, match=r"the angle .* has no root"):
        angle.normalized(triangulation("C~3"))


@pytest.mark.usefixtures("added")
def test_a_symbolic_simplex_gets_numbers_and_refusals_too():
    simplex = symbolic_simplex("B~d")
    assert measure("two")(lambda simplex: 2).normalized(simplex) == 1
    for value, words in (("good", "gives no exact number"), (0.5, "inexact"), (-1, "is -1 of the regular")):
        with pytest.raises(CoxeterError, match=words):
            measure("mine")(lambda simplex, value=value: value).normalized(simplex)


def test_an_unknown_measure_is_told_those_there_are():
    with pytest.raises(
        InvalidInput, match="'girth' is no quality measure; there are aspect_ratio, fatness, thickness"
    ):
        find_measure("girth")
