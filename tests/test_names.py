"""Names of root systems and triangulations: every spelling, every refusal."""

import re

import pytest

from coxeter import CoxeterError, InvalidType, Type, root_system, triangulation, triangulations_up_to

B5 = ["B~5", "B\u03035", "B̃_5", "B~_5", "B̃_{5}", "B5", " B~5 ", ("B", 5), ["B", 5], Type("B", 5)]


@pytest.mark.parametrize("name", B5, ids=repr)
def test_every_spelling_means_the_same_triangulation(name):
    assert triangulation(name).type == Type("B", 5)


@pytest.mark.parametrize("name", ["B5", "B_5", ("B", 5), Type("B", 5)], ids=repr)
def test_every_spelling_means_the_same_root_system(name):
    assert root_system(name).type == Type("B", 5)


def test_precomposed_letters_are_read_too():
    assert triangulation("\N{LATIN CAPITAL LETTER A WITH TILDE}3").type == Type("A", 3)
    assert triangulation("\N{LATIN CAPITAL LETTER E WITH TILDE}6").type == Type("E", 6)


@pytest.mark.parametrize("kind", triangulations_up_to(9), ids=lambda kind: kind.affine)
def test_each_name_is_read_back(kind):
    assert triangulation(kind.affine).type == triangulation(kind.unicode).type == kind
    assert root_system(kind.finite).type == kind


def test_the_list_of_triangulations_by_dimension():
    counts = [len(triangulations_up_to(d)) - len(triangulations_up_to(d - 1)) for d in range(2, 10)]
    assert counts == [3, 3, 5, 4, 5, 5, 5, 4]
    assert triangulations_up_to(1) == []


UNKNOWN = [
    "H~3",
    "E~9",
    "E~5",
    "F~3",
    "G~3",
    "",
    "A",
    "~3",
    "3",
    "A~",
    "A~3.5",
    "A~-3",
    "A~~3",
    "A~x",
    "a~3",
    "A~3 B~3",
]


@pytest.mark.parametrize("name", UNKNOWN)
def test_an_unknown_name_is_told_what_there_is(name):
    with pytest.raises(InvalidType) as caught:
        triangulation(name)
    message = str(caught.value)
    assert repr(name) in message
    for allowed in (
        "A~d (d >= 2)",
        "B~d (d >= 3)",
        "C~d (d >= 2)",
        "D~d (d >= 4)",
        "E~6, E~7, E~8, F~4, G~2",
    ):
        assert allowed in message


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("A~0", "A~d needs d >= 2"),
        ("A~1", "A~d needs d >= 2"),
        ("B~2", "B~d needs d >= 3 (in dimension 2 take C~2)"),
        ("B~1", "B~d needs d >= 3"),
        ("C~1", "C~d needs d >= 2"),
        ("D~3", "D~d needs d >= 4 (in dimension 3 take A~3)"),
        ("D~2", "D~d needs d >= 4"),
    ],
)
def test_a_dimension_too_small_is_told_the_least_one(name, reason):
    with pytest.raises(InvalidType, match=re.escape(reason)) as caught:
        triangulation(name)
    assert repr(name) in str(caught.value)


@pytest.mark.parametrize("name", [None, 5, 5.0, b"B~5", ("B",), ("B", 5, 6), {"B": 5}], ids=repr)
def test_what_is_no_name_at_all_is_told_an_example(name):
    with pytest.raises(InvalidType, match="'B~5'") as caught:
        triangulation(name)
    assert repr(name) in str(caught.value)


@pytest.mark.parametrize("name", [("B", 5.0), ("B", True), ("B", -5), Type("Q", 3), Type("B", 2)], ids=repr)
def test_a_pair_is_checked_like_text(name):
    with pytest.raises(InvalidType):
        triangulation(name)


@pytest.mark.parametrize("name", ["B{5", "B5}", "B_{5"])
def test_a_lonely_brace_is_refused(name):
    with pytest.raises(InvalidType):
        triangulation(name)


@pytest.mark.parametrize("name", ["A0", "B1", "C1", "D3", "E5", "H3", ""])
def test_root_systems_have_their_own_ranges(name):
    with pytest.raises(InvalidType, match=r"root system|needs d >="):
        root_system(name)


def test_a_line_and_a_square_are_root_systems_without_triangulation():
    assert root_system("A1").rank == 1
    assert root_system("B2").rank == 2


def test_a_refused_name_is_a_value_error_of_this_library():
    assert issubclass(InvalidType, CoxeterError)
    assert issubclass(InvalidType, ValueError)


def test_a_type_prints_in_each_form():
    kind = Type("E", 6)
    assert (kind.finite, kind.affine, kind.unicode, kind.latex) == ("E6", "E~6", "E\u03036", r"\tilde{E}_{6}")
    assert (kind.family, Type("D", 7).family) == ("E6", "D")
