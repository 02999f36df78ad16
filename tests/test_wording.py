"""What readers see in words: statements, tables, titles; and that the LaTeX of tables is sound."""

import re

import pytest

from coxeter.claims import Outcome, compare_points
from coxeter.families import closed_form, latex
from coxeter.ledger import all_claims
from coxeter.ledger.phrases import FORMS, PLACE, fill
from coxeter.names import FAMILIES
from coxeter.pages.corrected import sheets
from coxeter.pages.naming import titled
from coxeter.pages.wording import statement, to_plain
from coxeter.paper import printed
from coxeter.report import Facts
from coxeter.tables import Table, table
from coxeter.tables.pieces import in_signs, to_html

CLAIMS = all_claims()
MACHINE = re.compile(
    r"\bIt is (true|false) that\b|: (true|false)\b|\((true|false)\)|\{\w+[?:]|run of coordinates|, on this:"
)
COMMANDS = {
    "begin", "end", "hline", "frac", "sqrt", "tilde", "left", "right", "geq", "leq", "text", "cdot", "mathbb",
    "{", "}", "\\", ",", "_", " ",
}  # fmt: skip


@pytest.mark.parametrize("id", CLAIMS)
def test_statements_are_sentences(id):
    for text in (statement(CLAIMS[id]), CLAIMS[id].statement):
        assert not MACHINE.search(text), text
        assert text[0].isupper() or text[0] in "$(cn", text
        assert text.rstrip().endswith((".", "].")), text


def test_a_choice_follows_the_constant():
    claim = CLAIMS["prop-8"]
    assert statement(claim).endswith("is not a lattice.")
    assert statement(claim, {**claim.printed, "lattice": True}).endswith("is a lattice.")
    assert fill("{a:words} of {b}", {"a": 3, "b": 1}, lambda m: "b") == "three of b"
    assert fill("$x^{a}$ {lost:words}", {"a": 3}, lambda m: "?") == "$x^{a}$ ?"


def test_every_form_in_a_statement_is_known():
    for claim in CLAIMS.values():
        for match in PLACE.finditer(claim.words):
            form = match[4]
            assert form is None or form in FORMS or re.fullmatch(r"i(<j)?", form), claim.words


def test_titles_have_no_tex():
    for claim in CLAIMS.values():
        told = to_plain(statement(claim))
        assert not re.search(r"[\\$]|frac", told), told
    assert in_signs(r"2^{1/2 + 1/d}") == "2^(1/2 + 1/d)"


def test_only_what_is_not_exact_is_about():
    assert str(Facts(a="1/2", b="1/3", c="sqrt(2)", d=7)).split("\n") == [
        "a = 1/2 = 0.5", "b = 1/3 ≈ 0.333333", "c = sqrt(2) ≈ 1.414214", "d = 7"
    ]  # fmt: skip


def test_tables_show_formulas_and_words():
    shown = Table("T", ("m", "aspect_ratio"), (("<x, (1, -1^{3})> >= -1", "sqrt(14)/14"),))._repr_html_()
    told = ("⟨x, (1, ", "⟩ ≥ \u22121", "aspect ratio", r"\(\frac{\sqrt{14}}{14}\)", 'data-text="sqrt(14)/14"')
    assert all(part in shown for part in told)
    assert "\\(" not in Table("T", ("a",), ((r"\left(0 \end{array}",),))._repr_html_()  # broken in our copy
    assert to_html("u_2 - u_1").count("\u2212") == 1


def test_one_form_everywhere():
    form = closed_form("C", "normalized_fatness")
    assert form.latex() == latex(form.pieces[0].text)


def test_a_point_in_the_wrong_row_says_in_which():
    vertices = compare_points(printed(), lambda point: point.place == "Table 1")
    (found,) = [x for x in vertices if "in the row of" in x.note]
    assert found.outcome is Outcome.TRANSCRIPTION
    assert found.note == "our copy has it in the row of C~, it belongs to D~"


def test_folds_name_items_and_count_the_rest():
    assert titled(["thm-8.delaunay", "sec5.order"]) == "Theorem 8, 1 statement of Section 5"


# -- LaTeX ---------------------------------------------------------------------------------------------------


def sound(text):
    """Braces and formulas are closed, all commands known, each row has as many cells as there are columns."""
    depth = 0
    for token in re.findall(r"\\(?:[A-Za-z]+|.)|[{}]", text, re.DOTALL):
        depth += (token == "{") - (token == "}")
        assert depth >= 0, text
        assert token in "{}" or token[1:] in COMMANDS, token
    assert (depth, text.replace(r"\$", "").count("$") % 2) == (0, 0)
    assert re.findall(r"\\begin\{(\w+)\}", text).count("tabular") == 1
    columns = re.search(r"\\begin\{tabular\}\{([lcr]+)\}", text)[1]
    inner = re.sub(r"\\begin\{cases\}.*?\\end\{cases\}", "", text)
    rows = [line for line in inner.split("\n") if line.endswith(r"\\")]
    assert {row.count("&") for row in rows} == {len(columns) - 1}, rows
    return True


@pytest.mark.parametrize("number", [*range(1, 7), "regular"])
@pytest.mark.parametrize("exact", [False, True])
def test_tables_are_sound_latex(number, exact):
    assert sound(table(number, max_dim=9).render("latex", exact=exact))


@pytest.mark.parametrize("sheet", sheets(), ids=lambda x: str(x.number))
def test_corrected_tables_are_sound_latex(sheet):
    assert sound(sheet.render("latex"))


@pytest.mark.parametrize("family", FAMILIES)
def test_closed_forms_are_sound_latex(family):
    for measure in ("fatness", "radius_ratio"):
        text = closed_form(family, f"normalized_{measure}").latex()
        assert sound("\n".join((r"\begin{tabular}{l}", rf"${text}$ \\", r"\end{tabular}")))


def test_damaged_latex_is_noticed():
    with pytest.raises(AssertionError):
        sound(r"\begin{tabular}{lc}" + "\n" + r"a \\" + "\n" + r"\end{tabular}")
