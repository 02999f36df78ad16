"""The closed forms against the exact core, and mutants of them, which must be rejected."""

import re
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from math import prod

import pytest

import coxeter
from coxeter import normalized_qualities, qualities, regular_simplex, surd, triangulation
from coxeter.errors import InvalidInput
from coxeter.families import QUANTITIES, ClosedForm, closed_form, evaluate, expression
from coxeter.names import FAMILIES, MINIMAL_DIMENSION

LARGE = (50, 101, 200)


def dimensions(family, large=LARGE):
    """The dimensions of a family up to 24, and a few larger ones."""
    if family in MINIMAL_DIMENSION:
        return (*range(MINIMAL_DIMENSION[family], 25), *large)
    return (int(family[1:]),)


def core(family, d):
    """All quantities as the core computes them from the simple roots."""
    t = triangulation((family[0], d)) if family != "regular" else None
    simplex = t.simplex if t else regular_simplex(d)
    values = {
        "minimal_height": simplex.minimal_height,
        "longest_edge": simplex.longest_edge,
        "inradius": simplex.inradius,
        "circumradius": simplex.circumradius,
        "volume": simplex.volume,
        **qualities(simplex),
        **{f"normalized_{name}": x for name, x in normalized_qualities(simplex).items()},
    }
    if t:
        values["relative_protection"] = coxeter.protection(t).relative
    return values


CORE = {(family, d): core(family, d) for family in FAMILIES for d in dimensions(family, (50,))}


def holds(form: ClosedForm, large=()) -> bool:
    """Whether a form has the core's value in every dimension up to 24 (and in `large`)."""
    ds = dimensions(form.family, large)
    return all(form.at(d) == CORE[form.family, d][form.quantity] for d in ds)


@pytest.mark.parametrize("family", FAMILIES)
def test_closed_forms_equal_the_core(family):
    for d in dimensions(family):
        values = CORE.get((family, d)) or core(family, d)
        assert set(values) == set(QUANTITIES)
        for quantity in QUANTITIES:
            assert closed_form(family, quantity).at(d) == values[quantity], (family, quantity, d)


@pytest.mark.parametrize("d", [1, 2, 3, 4, 7, 24, 101])
def test_closed_forms_of_the_regular_simplex(d):
    for quantity, value in core("regular", d).items():
        assert closed_form("regular", quantity).at(d) == value


@pytest.mark.parametrize("quantity", QUANTITIES)
@pytest.mark.parametrize("family", FAMILIES)
def test_mutants_are_rejected(family, quantity):
    form = closed_form(family, quantity)
    assert holds(form)
    tried = 0
    for i, piece in enumerate(form.pieces):
        texts = [f"({piece.text})*(1 + 1/1000)" if piece.text != "0" else "1/1000"]
        if re.search(r"\bd\b", piece.text):
            texts.append(re.sub(r"\bd\b", "(d + 1)", piece.text))
        for text in texts:
            pieces = (*form.pieces[:i], replace(piece, text=text), *form.pieces[i + 1 :])
            assert not holds(replace(form, pieces=pieces)), text
            tried += 1
    assert tried >= len(form.pieces)


def test_mutants_of_a_range_are_rejected():
    for quantity in ("longest_edge", "thickness", "fatness", "normalized_thickness"):
        form = closed_form("B", quantity)
        general = replace(form.pieces[1], low=3)
        assert not holds(replace(form, pieces=(general,)))  # the general formula fails for d = 3
        # for d = 4 the edges to u_1 and u_d are equally long, so the mutant goes on to d = 5
        exception = replace(form.pieces[0], high=5)
        assert not holds(replace(form, pieces=(exception, form.pieces[1])))
    for quantity in ("longest_edge", "thickness", "fatness", "normalized_fatness"):
        odd, even = closed_form("A", quantity).pieces
        for piece in (odd, even):
            anywhere = replace(piece, low=2, parity=None)
            assert not holds(ClosedForm("A", quantity, (anywhere,)))


@pytest.mark.parametrize("family", FAMILIES)
def test_sympy_expressions_have_the_same_values(family):
    for quantity in QUANTITIES:
        for piece in closed_form(family, quantity).pieces:
            d = piece.low + 4 if piece.high is None else piece.low
            symbol = expression("d")
            assert surd(piece.expression.subs(symbol, d)) == evaluate(piece.text, d=d)


@pytest.mark.parametrize(
    ("family", "marks", "lengths", "determinant"),
    [
        ("A", lambda d: [1] * (d + 1), lambda d: [2] * (d + 1), lambda d: d + 1),
        ("B", lambda d: [1, 1] + [2] * (d - 1), lambda d: [2] * d + [1], lambda d: 1),
        ("C", lambda d: [1] + [2] * (d - 1) + [1], lambda d: [4] + [2] * (d - 1) + [4], lambda d: 4),
        ("D", lambda d: [1, 1] + [2] * (d - 3) + [1, 1], lambda d: [2] * (d + 1), lambda d: 4),
        ("E6", lambda d: [1, 1, 2, 2, 3, 2, 1], lambda d: [2] * 7, lambda d: 3),
        ("E7", lambda d: [1, 2, 2, 3, 4, 3, 2, 1], lambda d: [2] * 8, lambda d: 2),
        ("E8", lambda d: [1, 2, 3, 4, 6, 5, 4, 3, 2], lambda d: [2] * 9, lambda d: 1),
        ("F4", lambda d: [1, 2, 3, 4, 2], lambda d: [2, 2, 2, 1, 1], lambda d: Fraction(1, 4)),
        ("G2", lambda d: [1, 3, 2], lambda d: [6, 2, 6], lambda d: 3),
    ],
)
def test_where_the_forms_come_from(family, marks, lengths, determinant):
    """The table at the head of the forms: marks, squared lengths and Gram determinants, and what follows."""
    for d in dimensions(family, ()):
        t = triangulation((family[0], d))
        m, squares = marks(d), lengths(d)
        assert list(t.marks) == m
        assert [t.roots.squared_length_of_highest_root, *t.roots.squared_lengths] == squares
        assert t.roots.gram_determinant == determinant(d)
        inverse_heights = [x * coxeter.sqrt(s) for x, s in zip(m, squares, strict=True)]
        assert closed_form(family, "minimal_height").at(d) == 1 / max(inverse_heights)
        assert closed_form(family, "inradius").at(d) == 1 / sum(inverse_heights[1:], inverse_heights[0])
        volume = 1 / (prod(range(1, d + 1)) * prod(m) * coxeter.sqrt(determinant(d)))
        assert closed_form(family, "volume").at(d) == volume


def test_refused():
    with pytest.raises(InvalidInput, match="no family"):
        closed_form("H3", "volume")
    with pytest.raises(InvalidInput, match="no closed form"):
        closed_form("regular", "relative_protection")
    with pytest.raises(InvalidInput, match="d >= 2"):
        closed_form("A", "longest_edge").at(1)
    with pytest.raises(InvalidInput, match="d = 6"):
        closed_form("E6", "volume").at(7)
    for text in ("d +", "d.real", "exec(d)", "1.5*d", "x + 1", "sqrt(1, 2)", "'d'", "-d**"):
        with pytest.raises(InvalidInput):
            evaluate(text, d=3)


def test_latex():
    assert closed_form("C", "longest_edge").latex() == r"\frac{\sqrt{d}}{2}"
    assert r"d \text{ odd}" in closed_form("A", "fatness").latex()


def test_sympy_is_not_loaded():
    code = "import sys, coxeter.families as f; f.closed_form('A', 'fatness').at(9)"
    code += "; print('sympy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"
