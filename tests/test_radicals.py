"""Formulas with roots, equal for every d: the definitions, the printed formulas, and mutants of both."""

import ast
import subprocess
import sys
from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from coxeter.claims.core import DEFINITIONS, LETTERS
from coxeter.claims.formulas import compare_formula
from coxeter.claims.outcomes import Outcome
from coxeter.errors import CoxeterError, InvalidInput, Undecided
from coxeter.exact import Surd, sqrt
from coxeter.families import QUANTITIES, closed_form, evaluate
from coxeter.families.forms import MEASURES
from coxeter.paper import printed
from coxeter.symbolic.irreducibles import (
    FACTORIAL,
    FIELD,
    D,
    check_divisor,
    positive_factors,
    signs,
    whole_part,
)
from coxeter.symbolic.radicals import equal_for_every_d, first_difference, normal_form, substitute
from coxeter.symbolic.radicals_limits import Growth, growth, limit

INFINITE = ("A", "B", "C", "D")
TO_INFINITY = [
    (family, quantity, piece)
    for family in (*INFINITE, "regular")
    for quantity in QUANTITIES
    if family != "regular" or quantity != "relative_protection"
    for piece in closed_form(family, quantity).pieces
    if piece.high is None
]


def ranges(family):
    """The finest ranges that closed forms of a family have: those of the longest edge."""
    return closed_form(family, "longest_edge").pieces


def form_on(family, quantity, within):
    """The closed form of a quantity that holds throughout a range."""
    return next(
        piece.text
        for piece in closed_form(family, quantity).pieces
        if piece.covers(within.low) and piece.high in (None, within.high)
    )


def equal_on(a, b, within):
    """Whether two formulas are equal in a range, proved or refuted."""
    if within.high is not None:
        return all(evaluate(a, d=d) == evaluate(b, d=d) for d in range(within.low, within.high + 1))
    return equal_for_every_d(a, b, within.low, within.parity)


def mutants(text):
    """Every number one up and one down, and every plus a minus and the other way round."""
    tree = ast.parse(text, mode="eval")
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant):
            value = node.value
            for node.value in (value + 1, value - 1):
                yield ast.unparse(tree)
            node.value = value
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
            op = node.op
            node.op = ast.Sub() if isinstance(op, ast.Add) else ast.Add()
            yield ast.unparse(tree)
            node.op = op


def differs_somewhere(a, b):
    """The referee: exact values at three d."""
    for d in (6, 9, 13):
        try:
            if evaluate(a, d=d) != evaluate(b, d=d):
                return True
        except (CoxeterError, ZeroDivisionError):
            return True
    return False


# -- the definitions, as identities in d --------------------------------------------------------------


def in_letters(text, family, within):
    """A formula in the letters of Definition 18, with the closed forms of the lengths."""
    letters = {letter: form_on(family, name, within) for name, letter in LETTERS.items()}
    return substitute(text, **letters)


@pytest.mark.parametrize("measure", MEASURES)
@pytest.mark.parametrize("family", [*INFINITE, "regular"])
def test_measures_are_what_their_definitions_say(family, measure):
    for within in ranges(family):
        text = in_letters(DEFINITIONS[measure], family, within)
        assert equal_on(form_on(family, measure, within), text, within)


@pytest.mark.parametrize("measure", MEASURES)
@pytest.mark.parametrize("family", INFINITE)
def test_normalized_measures_are_what_their_definition_says(family, measure):
    for within in ranges(family):
        regular = form_on("regular", measure, within)
        ratio = f"({form_on(family, measure, within)})/({regular})"
        text = f"({ratio})**(1/d)" if measure == "fatness" else ratio
        assert equal_on(form_on(family, f"normalized_{measure}", within), text, within)


@pytest.mark.parametrize(("family", "quantity", "piece"), TO_INFINITY)
def test_mutants_of_closed_forms_are_different(family, quantity, piece):
    tried = 0
    for text in mutants(piece.text):
        if differs_somewhere(text, piece.text):
            assert not equal_for_every_d(text, piece.text, piece.low, piece.parity), text
            tried += 1
    assert tried


@pytest.mark.parametrize("measure", MEASURES)
@pytest.mark.parametrize("family", INFINITE)
def test_mutants_of_the_definitions_are_different(family, measure):
    for within in ranges(family):
        text = form_on(family, measure, within)
        for moved in mutants(in_letters(DEFINITIONS[measure], family, within)):
            if within.high is None and differs_somewhere(moved, text):
                assert not equal_on(text, moved, within), moved


@pytest.mark.parametrize(("family", "quantity", "piece"), TO_INFINITY)
def test_a_normal_form_keeps_the_values_and_can_be_read_again(family, quantity, piece):
    form = normal_form(piece.text, piece.low)
    for d in range(piece.low, piece.low + 9):
        assert form.at(d) == evaluate(piece.text, d=d)
    assert normal_form(str(form), piece.low) == form
    assert hash(normal_form(str(form), piece.low)) == hash(form)
    assert form.latex()


# -- the printed formulas -----------------------------------------------------------------------------

TRUE = {  # printed, and no quantity of a closed form
    "mirror_distance": "sqrt((d*(d + 2) + 24)/(12*(d + 1)))",
    "protection": "(sqrt(1 + 24/(d*(d + 2))) - 1)*sqrt(d*(d + 2)/(12*(d + 1)))",
}
PRINTED = [
    f
    for f in printed().formulas
    if f.family in (*INFINITE, "regular") and f.text and not f.decimal and f.quantity != "squared_edge"
]


def is_true(f):
    """Whether a printed formula is true for every d of the family, proved or refuted."""
    return all(
        equal_on(
            in_letters(f.text, f.family, within),
            TRUE.get(f.quantity) or form_on(f.family, f.quantity, within),
            within,
        )
        for within in ranges(f.family)
        if f.parity in ("", within.parity)
    )


@pytest.mark.parametrize("f", PRINTED, ids=lambda f: f"{f.place}: {f.text}")
def test_printed_formulas(f):
    assert is_true(f) == (compare_formula(printed(), f).outcome is Outcome.AGREES)


def test_some_printed_formulas_are_false():
    false = {(f.place, f.text) for f in PRINTED if not is_true(f)}
    assert ("Section 6, A~, item 6", "sqrt(2/d)") in false
    assert ("Section 6, B~, item 5", "sqrt(d)/2") in false  # for d = 3
    assert 3 <= len(false) < 20


# -- deciding -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("a", "b", "low"),
    [
        ("sqrt(d + 1)**(1 + 2/d)", "(d + 1)**(1/2 + 1/d)", 1),
        ("(d + 1)**((d + 1)/2)", "sqrt(d + 1)**(d + 1)", 1),
        ("4**(d/2)", "2**d", 1),
        ("2**(1/2 + 1/d)", "(2*4**(1/d))**(1/2)", 1),
        ("1/(sqrt(2) + sqrt(3) + sqrt(6))", "(sqrt(2) + sqrt(3) - sqrt(6))*(2*sqrt(6) + 1)/23", 1),
        ("1/(3*sqrt(2) + 3*sqrt(6))", "(sqrt(6) - sqrt(2))/12", 1),
        ("1/(sqrt(d) + 2)", "(sqrt(d) - 2)*(d**2 - 16)/((d - 4)**2*(d + 4))", 5),
        ("(sqrt(d + 1) - sqrt(d))*(sqrt(d + 1) + sqrt(d))", "1", 1),
        ("factorial(d + 2)/factorial(d - 1)", "d*(d + 1)*(d + 2)", 1),
        ("factorial(4)*factorial(d)**(1/2)", "24*sqrt(factorial(d))", 1),
        ("(factorial(d) + 1)**2 - 1", "factorial(d)**2 + 2*factorial(d)", 1),
        ("sqrt(1 - 1)", "0", 1),
        ("0**0", "1", 1),
    ],
)
def test_equal(a, b, low):
    assert equal_for_every_d(a, b, low)
    assert first_difference(a, b, low) is None
    assert not equal_for_every_d(a, f"{b} + 1/1000", low)


def test_the_first_few_dimensions_may_be_settled_by_evaluation():
    assert equal_for_every_d("1/(sqrt(d) + 2)", "1/(2 + sqrt(d))")  # its conjugate is 0 for d = 4
    assert equal_for_every_d("sqrt((d - 3)**2) - d + 3", "0", low=3)
    assert not equal_for_every_d("sqrt((d - 3)**2) - d + 3", "0", low=2)
    assert first_difference("sqrt((d - 3)**2) - d + 3", "0", low=2) == 2


def test_a_missing_value_is_a_difference_only_on_one_side():
    assert not equal_for_every_d("(d - 3)/(d - 3)", "1", low=2)
    assert first_difference("(d - 3)/(d - 3)", "1", low=2) == 3
    assert equal_for_every_d("(d - 3)/(d - 3)", "1", low=4)
    with pytest.raises(Undecided, match="larger low"):
        equal_for_every_d("1/(d - 3)", "1/(d - 3)", low=2)
    with pytest.raises(ZeroDivisionError, match="d = 3"):
        normal_form("1/(d - 3)", 2)


def test_parity():
    assert first_difference("d", "d + (d - 3)*(d - 5)", 3, "odd") == 7
    assert first_difference("d", "d + (d - 3)*(d - 5)", 3, "even") == 4
    assert first_difference("(-1)**d", "1", 2) == 3
    assert first_difference("(-1)**d", "1", 2, "even") is None
    with pytest.raises(Undecided):  # true, but not decided
        equal_for_every_d("(-1)**d", "1", 2, "even")
    with pytest.raises(InvalidInput, match="parity"):
        equal_for_every_d("d", "d + 1", 2, "neither")


def test_late_differences_are_not_equalities():
    product = "*".join(f"(d - {n})" for n in range(1, 60))
    with pytest.raises(Undecided, match="no d shows"):
        equal_for_every_d(f"d + {product}", "d")


@pytest.mark.parametrize(
    "text",
    [
        "sqrt(1 + sqrt(d))",
        "(1 + sqrt(2))**(1/d)",
        "sqrt(1 - d)",
        "sqrt(d - 3)",
        "(-8)**(1/3)",
        "2**sqrt(d)",
        "2**factorial(d)",
        "2**1000000000",
        "factorial(2*d)",
        "factorial(d/2)",
        "factorial(-1)",
        "1/(2**d + 1)",
        "sqrt(d**2 - 100*d + 1)",
        "sqrt((d - 1000)**2)",
        "sqrt(factorial(d) - d)",
    ],
)
def test_undecided(text):
    with pytest.raises(Undecided):
        normal_form(text)


@pytest.mark.parametrize("text", ["k + 1", "d +", "1.5", "exec(d)", "h/L", ""])
def test_refused(text):
    for question in (
        lambda: normal_form(text),
        lambda: equal_for_every_d("d", text),
        lambda: first_difference(text, "d"),
        lambda: limit(text),
    ):
        with pytest.raises(InvalidInput):
            question()


def test_refused_dimensions():
    for low in (0, -1, "3", 2.0):
        with pytest.raises(InvalidInput, match="dimension to begin with"):
            normal_form("d", low)
    with pytest.raises(InvalidInput, match="from d = 4 on"):
        normal_form("1/(d - 3)", 4).at(3)


def test_arithmetic_of_forms():
    x, y = normal_form("sqrt(d)"), normal_form("sqrt(2)")
    assert (x + y) * (x - y) == normal_form("d - 2")
    assert x + 1 - 1 == x
    assert x / y * 2 == normal_form("sqrt(2*d)")
    assert x ** Fraction(1, 2) == normal_form("d**(1/4)")
    assert x**-2 == normal_form("1/d")
    assert (x / normal_form("d + 1", 7)).low == 7
    assert x != "sqrt(d)"
    assert (bool(x), bool(x - x)) == (True, False)
    assert (str(x - x), str(-x)) == ("0", "-sqrt(d)")
    with pytest.raises(ZeroDivisionError):
        x / (y - y)


# -- parts --------------------------------------------------------------------------------------------


def test_signs_and_factors():
    assert signs((D - D**2).numer, 1) == (0, -1)
    assert signs(FIELD(0).numer, 1) == (0,)
    assert signs((FACTORIAL + D - 8).numer, 3) == (1,)
    with pytest.raises(Undecided):
        signs((D - 1000).numer, 1)
    with pytest.raises(ZeroDivisionError, match="d = 5"):
        check_divisor((D**2 - 25).numer, 2)
    assert positive_factors(2 * FACTORIAL + 2 * D, 3) == ((2, 1), ((FACTORIAL + D).numer, 1))
    product = FIELD(1)
    for base, k in positive_factors((48 - 12 * D) / (6 - 2 * D**2), 5):
        product *= FIELD(base) ** k
    assert product == (48 - 12 * D) / (6 - 2 * D**2)


@given(st.integers(-9, 9), st.integers(1, 9), st.integers(-5, 5), st.integers(-5, 5))
def test_the_constant_part_of_an_exponent_is_reduced(p, q, a, b):
    e = FIELD(p) / q + a * D + FIELD(b) / (D + 1)
    assert whole_part(e) == p // q


LEAVES = st.sampled_from(["d", "1", "2", "3", "6", "d + 1", "d*(d + 2)", "factorial(d)", "1/d", "2/3"])
EXPONENTS = st.sampled_from(
    ["2", "-1", "1/2", "3/2", "-1/2", "d", "1/d", "d/2", "(d + 1)/2", "1/2 + 1/d", "0"]
)
PRODUCTS = st.recursive(
    LEAVES,
    lambda x: st.one_of(
        st.builds("({})*({})".format, x, x),
        st.builds("({})/({})".format, x, x),
        st.builds("sqrt({})".format, x),
        st.builds("({})**({})".format, x, EXPONENTS),
    ),
    max_leaves=5,
)
ROOTS = st.sampled_from(["sqrt(2)", "sqrt(d)", "sqrt(d + 1)", "sqrt(6*d)", "d", "1", "1/3", "d/(d + 2)"])
SUMS = st.recursive(
    ROOTS,
    lambda x: st.one_of(
        st.builds("({}) + ({})".format, x, x),
        st.builds("({}) - ({})".format, x, x),
        st.builds("({})*({})".format, x, x),
        st.builds("({})/({})".format, x, x),
    ),
    max_leaves=6,
)


@given(st.one_of(PRODUCTS, SUMS), st.integers(3, 6))
def test_random_formulas_keep_their_values(text, d):
    try:
        form = normal_form(text, 3)
    except (Undecided, ZeroDivisionError):
        assume(False)
    assert form.at(d) == evaluate(text, d=d)
    assert normal_form(str(form), 3) == form


@given(SUMS, SUMS, SUMS)
def test_ring_axioms(a, b, c):
    try:
        x, y, z = (normal_form(text, 3) for text in (a, b, c))
    except (Undecided, ZeroDivisionError):
        assume(False)
    assert x * (y + z) == y * x + z * x
    assert (x + y) + z == y + (z + x)
    assert x - x == z * 0


@given(SUMS)
def test_inverses(text):
    try:
        x = normal_form(text, 3)
        inverse = x.inverse()
    except (Undecided, ZeroDivisionError):
        assume(False)
    assert x * inverse == normal_form("1")


@given(PRODUCTS, st.integers(1, 3))
def test_random_formulas_are_told_apart(text, factor):
    try:
        normal_form(text, 3)
    except (Undecided, ZeroDivisionError):
        assume(False)
    assert equal_for_every_d(f"({text})*{factor}", f"({text})*{factor}*d/d", 3)
    assert not equal_for_every_d(text, f"({text})*(1 + {factor}/1000)", 3)


# -- limits -------------------------------------------------------------------------------------------

OTHERS = {"fatness": sqrt(2), "aspect_ratio": sqrt(2), "thickness": Surd(1), "radius_ratio": sqrt(2)}
SCALED = {  # sqrt(d) times the normalised measure
    "A": {"fatness": 2 * sqrt(2), "aspect_ratio": sqrt(6), "thickness": Surd(2), "radius_ratio": sqrt(6)},
    "B": OTHERS,
    "C": OTHERS,
    "D": OTHERS,
}


@pytest.mark.parametrize("family", INFINITE)
def test_rates(family):
    for measure, expected in SCALED[family].items():
        for piece in closed_form(family, f"normalized_{measure}").pieces:
            if piece.high is None:
                assert limit(f"sqrt(d)*({piece.text})") == expected
                assert growth(piece.text) == Growth(expected, Fraction(-1, 2))
                value = evaluate(f"sqrt(d)*({piece.text})", d=10_000 + (piece.parity == "odd"))
                assert abs(float(value) - float(expected)) < 0.01  # the second route


def test_the_rate_of_protection():
    for f in PRINTED:
        if f.quantity == "relative_protection":
            assert limit(f"d**2*({f.text})") == 12
    assert growth(TRUE["protection"]) == Growth(2 * sqrt(3), Fraction(-3, 2))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("0", 0),
        ("1/d", 0),
        ("(3*d**2 + 1)/(2*d**2 - 7)", "3/2"),
        ("2**(1/d)*d**(1/d)", 1),
        ("(d + 1)**(1/3 + 1/d)/(8*d)**(1/3)", "1/2"),
        ("sqrt(d)*(sqrt(d + 1) - sqrt(d))", "1/2"),
        ("sqrt(d**2 + d) - d", "1/2"),
        ("d*(sqrt(d + 2) - 2*sqrt(d + 1) + sqrt(d))", 0),
        ("d*sqrt(d)*(sqrt(d + 2) - 2*sqrt(d + 1) + sqrt(d))", "-1/4"),
        ("factorial(d)/factorial(d - 1)/(d + 1)", 1),
        ("2**d/(2**(d + 1))", "1/2"),
        ("sqrt(3) - d**(-1/4)", "sqrt(3)"),
        ("(-2*d + 1)**3/d**3", -8),
    ],
)
def test_limits(text, expected):
    assert limit(text) == (evaluate(expected) if isinstance(expected, str) else expected)


def test_limits_that_are_not():
    for text in ("d", "sqrt(d) - 1/d", "-d**(1/3)"):
        with pytest.raises(InvalidInput, match="no limit"):
            limit(text)
    for text in (
        "2**d",
        "1/factorial(d)",
        "d**(d/2)",
        "(1 + 1/d)**d",
        "2**(1/3) + 1",
        "2**(1/3) - 2**(1/d + 1/3)",
    ):
        with pytest.raises(Undecided):
            limit(text)


def test_the_library_does_not_load_sympy():
    code = "import sys, coxeter; print('sympy' in sys.modules, 'coxeter.symbolic.radicals' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "False"]
