"""The paper's numbers against the core: known outcomes, altered values, damaged data files."""

import ast
import json
import shutil
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

import coxeter.paper
from coxeter import fatness, regular_simplex, sqrt, surd, thickness, triangulation
from coxeter.claims import (
    Comparison,
    Outcome,
    compare_appendices,
    compare_everything,
    compare_section6,
    compare_table,
    compare_theorem8,
    core,
)
from coxeter.claims.formulas import compare_formula
from coxeter.claims.points import compare_point, compare_points
from coxeter.claims.statements import compare_statement
from coxeter.errors import CoxeterError, InvalidInput
from coxeter.names import FAMILIES
from coxeter.paper import load, printed

AGREES, ROUNDED, DIFFERS, TRANSCRIPTION = (
    Outcome.AGREES,
    Outcome.ROUNDED_DIFFERENTLY,
    Outcome.DIFFERS,
    Outcome.TRANSCRIPTION,
)
PAPER = printed()
DATA = Path(coxeter.paper.__file__).parent


def verdict(x: Comparison):
    """All of a comparison that a ledger would notice, but the printed text itself."""
    return x.outcome, x.note, x.evidence, x.fails_at


def mutants(text):
    """A formula made a little larger, and with the next d."""
    yield f"({text})*(1 + 1/1000)" if text != "0" else "1/1000"
    if "d" in text.replace("sqrt", "").replace("factorial", ""):
        yield "".join("(d + 1)" if c == "d" else c for c in text)


@pytest.fixture
def _small_dimensions(monkeypatch):
    """Fewer dimensions, where altering is to be tried often."""
    monkeypatch.setattr(core, "LARGEST", 6)


# -- Tables 3 to 6 -------------------------------------------------------------------------------------

FAULTS = {
    # table: {(letter, column): (outcome, dimension that the cell belongs to)}
    3: {
        ("C", 2): (ROUNDED, 2),
        ("D", 7): (DIFFERS, 7),
        ("E", 5): (TRANSCRIPTION, 6),
        ("E", 6): (TRANSCRIPTION, 7),
        ("E", 7): (TRANSCRIPTION, 8),
        ("E", 8): (TRANSCRIPTION, 5),
        ("F", 4): (TRANSCRIPTION, 5),
        ("F", 8): (TRANSCRIPTION, 4),
        ("G", 8): (TRANSCRIPTION, 8),
    },
    4: {
        ("E", 5): (TRANSCRIPTION, 6),
        ("E", 6): (TRANSCRIPTION, 7),
        ("E", 7): (TRANSCRIPTION, 8),
        ("E", 8): (TRANSCRIPTION, 5),
        ("F", 4): (TRANSCRIPTION, 5),
        ("F", 8): (TRANSCRIPTION, 4),
        ("G", 7): (TRANSCRIPTION, 7),
        ("G", 8): (TRANSCRIPTION, 8),
    },
    5: {
        ("A", 4): (ROUNDED, 4),
        ("B", 3): (DIFFERS, 3),
        ("C", 4): (ROUNDED, 4),
        ("D", 5): (ROUNDED, 5),
        ("E", 5): (DIFFERS, 6),
        ("E", 6): (TRANSCRIPTION, 7),
        ("E", 7): (DIFFERS, 8),
        ("E", 8): (TRANSCRIPTION, 5),
        ("F", 4): (TRANSCRIPTION, 5),
        ("F", 8): (TRANSCRIPTION, 4),
        ("G", 8): (TRANSCRIPTION, 8),
    },
    6: {
        ("B", 3): (DIFFERS, 3),
        ("E", 6): (ROUNDED, 6),
        ("E", 8): (DIFFERS, 8),
        ("G", None): (TRANSCRIPTION, None),  # the label of the row
    },
}


@pytest.mark.parametrize("table", [3, 4, 5, 6])
def test_outcomes_of_the_decimals(table):
    cells = compare_table(table)
    found = {(x.family[0], x.column): (x.outcome, x.dimension) for x in cells if x.outcome is not AGREES}
    assert found == FAULTS[table]
    assert len([x for x in cells if x.column]) == 49
    assert all(x.evidence for x in cells if x.outcome is not AGREES)


def test_every_triangulation_has_its_cell():
    for table in (3, 4, 5, 6):
        numbers = [x for x in compare_table(table) if x.exact is not None]
        named = sorted((x.family[0], x.dimension) for x in numbers)
        assert named == sorted((t.letter, t.rank) for t in coxeter.triangulations_up_to(8))


def test_decimals_are_judged_by_the_exact_value():
    """Each verdict again, by a second route: integers of the last digit against squares and powers."""
    for table in (3, 4, 5, 6):
        for x in compare_table(table):
            if x.exact is None or not x.printed[:1].isdigit():
                continue
            n = int(x.printed.replace(".", ""))
            low, high = surd(f"{2 * n - 1}/2000"), surd(f"{2 * n + 1}/2000")
            within_half = low <= x.exact <= high
            within_one = surd(f"{n - 1}/1000") < x.exact < surd(f"{n + 1}/1000")
            if within_half:
                assert x.outcome in (AGREES, TRANSCRIPTION)
            else:
                assert x.outcome is (ROUNDED if within_one else DIFFERS)


def altered(row, i, text):
    rows = tuple(
        replace(r, cells=(*r.cells[:i], text, *r.cells[i + 1 :])) if r is row else r for r in PAPER.rows
    )
    return replace(PAPER, rows=rows)


@pytest.mark.parametrize("table", [3, 4, 5, 6])
def test_an_altered_cell_is_noticed(table):
    tried = 0
    for row in (r for r in PAPER.rows if r.table == table and r.letter):
        before = {x.column: verdict(x) for x in compare_table(table) if x.family[0] == row.letter}
        for i, (column, text) in enumerate(zip(range(2, 9), row.cells, strict=True)):
            if text[:1].isdigit():
                n = int(text.replace(".", ""))
                changes = [f"{m // 1000}.{m % 1000:03d}" for m in (n - 1, n + 1)] + ["-", ""]
            else:
                changes = ["0.444", "" if text else "-"]
            for change in changes:
                after = compare_table(table, altered(row, i, change))
                same_row = {x.column: verdict(x) for x in after if x.family[0] == row.letter}
                if change[:1].isdigit() and text[:1].isdigit():
                    assert same_row[column] != before[column], (row.letter, column, text, change)
                assert same_row != before
                tried += 1
    assert tried > 100


def test_altered_labels_and_heads_are_noticed():
    for row in PAPER.rows:
        paper = altered(row, 3, row.cells[3] + "1") if not row.letter else None
        if row.letter:
            rows = tuple(replace(r, label="\\tilde{X}_{d}") if r is row else r for r in PAPER.rows)
            paper = replace(PAPER, rows=rows)
        kind = "label of the row" if row.letter else "head of the column"
        assert any(x.quantity == kind for x in compare_table(row.table, paper))


# -- formulas ------------------------------------------------------------------------------------------


def find(comparisons, **wanted):
    """The comparisons with the given attributes."""
    return [x for x in comparisons if all(getattr(x, name) == value for name, value in wanted.items())]


def test_outcomes_of_table_2():
    table = compare_table(2)
    assert len(table) == 40
    faults = {(x.family, x.quantity): x for x in table if x.outcome is not AGREES}
    assert {key: (x.outcome, x.fails_at) for key, x in faults.items()} == {
        ("A", "normalized_aspect_ratio"): (TRANSCRIPTION, ()),  # a cell for both rows of A~
        ("A", "normalized_radius_ratio"): (TRANSCRIPTION, ()),
        ("B", "normalized_fatness"): (DIFFERS, (3,)),
        ("B", "normalized_thickness"): (DIFFERS, (3,)),
        ("E6", "normalized_fatness"): (DIFFERS, (6,)),
        ("E8", "normalized_thickness"): (DIFFERS, (8,)),
        ("F4", "normalized_fatness"): (DIFFERS, (4,)),
    }
    e6 = faults["E6", "normalized_fatness"]
    assert e6.exact**12 == surd("27/28672")
    assert "E~7's longest edge" in e6.evidence
    assert "prints its rounding 0.528" in e6.evidence
    assert faults["E8", "normalized_thickness"].exact == sqrt(2) / 9
    assert "in place of h/L" in faults["E8", "normalized_thickness"].evidence
    assert faults["F4", "normalized_fatness"].exact ** 8 == surd("1/180")


def test_the_explanations_in_the_evidence_are_true():
    """By hand: which mistakes lead to the printed values of Table 2."""
    e6, e8, f4 = (triangulation(name).simplex for name in ("E~6", "E~8", "F~4"))
    assert (e6.volume / sqrt("3/2") ** 6 / fatness(regular_simplex(6))) ** 12 == surd("64/137781") ** 6
    printed_e8 = e8.minimal_height / (2 * e8.circumradius) / thickness(regular_simplex(8))
    assert printed_e8 == 2 * sqrt(19) / 57
    assert (surd("1/864") / fatness(regular_simplex(4))) ** 2 == surd("1/405")
    assert (f4.volume / fatness(regular_simplex(4))) ** 2 == surd("1/180")


def test_the_regular_simplex_agrees():
    assert [x.outcome for x in compare_table("regular")] == [AGREES] * 4


def test_theorem_8_agrees_in_every_dimension_compared():
    found = compare_theorem8()
    assert len(found) == 4
    assert {x.outcome for x in found} == {AGREES}
    assert all(x.dimensions == tuple(range(2, 25)) for x in found)


FAULTS_OF_SECTION_6 = {
    "A": {("aspect_ratio", "h/R"), ("thickness", "sqrt(2/d)")},
    "B": {
        ("aspect_ratio", "h/R"),
        ("longest_edge", "sqrt(d)/2"),
        ("thickness", "1/sqrt(2*d)"),
        ("fatness", "2/(d**(d/2)*factorial(d))"),
        ("distance", "d(u_1, facet 1) = 1/(2*sqrt(2))"),
        ("longest", "longest edge: from u_0 to u_d"),
    },
    "C": {("aspect_ratio", "h/R")},
    "D": {("aspect_ratio", "h/R"), ("level", "<s_{d - 2}, c> = -1/4")},
    "E6": {("aspect_ratio", "h/R"), ("fatness", "sqrt(3)/174960"), ("fatness", "9.900e-6")},
    "E7": {("aspect_ratio", "h/R")},
    "E8": {
        ("aspect_ratio", "h/R"),
        ("circumcentre", r"\left(-\frac{1^{12}}{12}, 0^{5}, \frac{1}{2}\right)"),
        ("product", "<(0, 1, 0^{6}), c> = -1/12"),
    },
    "F4": {("aspect_ratio", "h/R")},
    "G2": set(),
}


@pytest.mark.parametrize("family", FAMILIES)
def test_outcomes_of_section_6(family):
    found = compare_section6(family)
    assert {(x.quantity, x.printed) for x in found if x.outcome is DIFFERS} == FAULTS_OF_SECTION_6[family]
    for x in find(found, printed="h/R"):
        assert x.fails_at == x.dimensions
        assert "2 times the exact value" in x.evidence
    assert not find(found, outcome=ROUNDED)


def test_exact_values_beside_wrong_ones():
    (theta,) = find(compare_section6("A"), printed="sqrt(2/d)")
    assert theta.fails_at == tuple(range(3, 25, 2))
    assert theta.exact == sqrt("1/2")
    (edge,) = find(compare_section6("B"), quantity="longest_edge")
    assert edge.fails_at == (3,)
    assert edge.exact == 1
    assert edge.evidence.count("computes the") == 2
    (distance,) = find(compare_section6("B"), quantity="distance")
    assert distance.exact == 1 / sqrt(2)
    assert distance.fails_at == distance.dimensions
    (centre,) = find(compare_section6("E8"), quantity="circumcentre")
    assert centre.exact == triangulation("E~8").simplex.circumcentre
    assert "coordinates 1, 2 have the wrong sign" in centre.evidence
    (product,) = find(compare_section6("E8"), quantity="product")
    assert product.exact == surd("1/12")
    (decimal,) = find(compare_section6("E6"), printed="9.900e-6")
    assert decimal.rounded == "1.410e-5"


def test_outcomes_of_the_appendices():
    wrong = [(x.family, x.quantity) for x in compare_appendices() if x.outcome is not AGREES]
    assert wrong == [
        ("regular", "aspect_ratio"),
        ("A", "mirror vertex k"),
        ("A", "mirror vertex 0"),
        ("E6", "combination"),
        ("E7", "combination"),
        ("E7", "no vertex"),
        ("E8", "no vertex"),
    ]


def test_the_witnesses_of_propositions_11_to_13():
    """By the definition of a vertex: 7 and 8 independent roots have integer inner product with e_2."""
    e2 = (0, 1, 0, 0, 0, 0, 0, 0)
    assert triangulation("E~7").is_vertex_by_rank(e2)
    assert triangulation("E~8").is_vertex_by_rank(e2)
    three_halves = (0, "3/2", 0, 0, 0, 0, 0, 0)
    assert three_halves not in coxeter.spanned_lattice(triangulation("E~6"))
    for name in ("E~6", "E~7", "E~8"):  # the propositions hold all the same
        assert not coxeter.vertex_lattice(triangulation(name))


@pytest.mark.usefixtures("_small_dimensions")
def test_an_altered_formula_is_noticed():
    for f in PAPER.formulas:
        before = verdict(compare_formula(PAPER, f))
        if f.decimal:
            texts = [f.text.replace(f.text[4], str((int(f.text[4]) + 1) % 10), 1)]
        else:
            texts = list(mutants(f.text)) if f.text else ["1/2"]
        for text in texts:
            g = replace(f, text=text)
            paper = replace(PAPER, formulas=tuple(g if x is f else x for x in PAPER.formulas))
            assert verdict(compare_formula(paper, g)) != before, (f.place, f.quantity, text)


# -- points and statements -----------------------------------------------------------------------------


def test_outcomes_of_table_1():
    table = compare_table(1)
    faults = {(x.family, x.quantity): x for x in table if x.outcome is not AGREES}
    assert set(faults) == {("D", "vertex 1"), ("E6", "vertex 3"), ("E8", "space")}
    assert {x.outcome for x in faults.values()} == {TRANSCRIPTION}
    assert "row lacks it" in faults["D", "vertex 1"].evidence
    assert "Section 6, E~6, item 2 prints it right" in faults["E6", "vertex 3"].evidence


def test_damaged_points_of_section_6():
    found = {
        (family, x.quantity): x.outcome
        for family in FAMILIES
        for x in compare_section6(family)
        if x.outcome is TRANSCRIPTION
    }
    damaged = [("E7", f"vertex {k}") for k in (3, 4, 5, 6)] + [("E8", "vertex 3"), ("E8", "vertex 5")]
    assert sorted(found) == damaged


def without(point):
    return replace(PAPER, points=tuple(p for p in PAPER.points if p is not point))


@pytest.mark.usefixtures("_small_dimensions")
def test_a_missing_vertex_is_noticed():
    for point in PAPER.points:
        if point.name == "vertex" and point.family != "G2" and not point.place.startswith("Appendix"):
            found = compare_points(without(point), lambda p, place=point.place: p.place == place)
            lost = {x.family for x in found if x.note == "no such vertex is printed"}
            # one of the two that Table 1 prints as vertex 1 of C~ is that of D~, and equals that of B~
            stray = point.place == "Table 1" and point.index == "1" and point.family in "BC"
            assert lost == {"D" if stray else point.family}, point


@pytest.mark.usefixtures("_small_dimensions")
def test_an_altered_point_is_noticed():
    for point in PAPER.points:
        if (point.place, point.family, point.index) == ("Table 1", "C", "1"):
            continue  # a vertex of D~ in the row of C~: see the next test
        before = verdict(compare_point(PAPER, point))
        for i, (value, count) in enumerate(point.runs):
            for run in ((f"{value} + 1/1000", count), (value, f"{count} + 1")):
                changed = replace(point, runs=(*point.runs[:i], run, *point.runs[i + 1 :]))
                points = tuple(changed if p is point else p for p in PAPER.points)
                assert verdict(compare_point(replace(PAPER, points=points), changed)) != before, (point, run)


@pytest.mark.usefixtures("_small_dimensions")
def test_an_altered_stray_vertex_is_noticed():
    (stray,) = [p for p in PAPER.points if (p.place, p.family, p.index) == ("Table 1", "C", "1")]
    changed = replace(stray, runs=(("2", "1"), ("0", "d - 1")))
    paper = replace(PAPER, points=tuple(changed if p is stray else p for p in PAPER.points))
    found = compare_table(1, paper)
    assert find(found, family="C", quantity="vertex 1")[0].outcome is DIFFERS
    assert find(found, family="D", quantity="vertex 1")[0].note == "no such vertex is printed"


@pytest.mark.usefixtures("_small_dimensions")
def test_an_altered_statement_is_noticed():
    for s in PAPER.statements:
        before = verdict(compare_statement(PAPER, s))
        changes = []
        if s.text and not (s.kind == "facet" and s.text == "0"):
            changes += [{"text": text} for text in mutants(s.text)]
        if s.kind == "facet":
            # not a coordinate that only makes the normal longer: the hyperplane would stay the same
            values = [value for value, _ in s.normal]
            i = values.index("0") if "0" in values else len(values) - 1
            normal = [(f"{x} + 1/1000", n) if j == i else (x, n) for j, (x, n) in enumerate(s.normal)]
            changes.append({"normal": tuple(normal)})
            changes.append({"text": "1/2"} if s.text == "0" else {"text": f"-({s.text})"})
        if s.kind == "minimal":
            changes += [{"first": f"{s.first} + 1"}, {"last": f"{s.last} - 1"}]
        if s.kind == "longest":  # in D~ the edge to u_(d-1) is as long as that to u_d
            changes.append({"last": f"{s.last} - 2"})
        if s.kind == "combination":
            changes.append({"terms": ((f"{s.terms[0][0]} + 1", s.terms[0][1]), *s.terms[1:])})
        if s.kind == "no vertex":  # the origin is one, a point with coordinates in thousandths is none
            zero = before[0] is AGREES
            changes.append({"normal": tuple(("0" if zero else f"{x} + 1/1000", n) for x, n in s.normal)})
        assert changes or not s.text
        for change in changes:
            changed = replace(s, **change)
            statements = tuple(changed if x is s else x for x in PAPER.statements)
            after = verdict(compare_statement(replace(PAPER, statements=statements), changed))
            assert after != before, (s, change)


def test_counts():
    everything = compare_everything()
    assert Counter(x.outcome for x in everything)[DIFFERS] == 37
    places = {x.place for x in everything}
    for record in (*PAPER.formulas, *PAPER.points, *PAPER.statements):
        assert record.place in places
    sizes = (PAPER.rows, PAPER.formulas, PAPER.points, PAPER.statements)
    assert tuple(map(len, sizes)) == (32, 174, 105, 88)


def test_refused():
    with pytest.raises(InvalidInput, match="no table 7"):
        compare_table(7)
    with pytest.raises(InvalidInput, match="no family"):
        compare_section6("H3")


# -- the data files --------------------------------------------------------------------------------------


def damage(tmp_path, file, number, change):
    """A copy of the data files with one line changed."""
    for source in DATA.glob("*.json"):
        shutil.copy(source, tmp_path)
    path = tmp_path / file
    lines = path.read_text(encoding="utf-8").split("\n")
    lines[number - 1] = change(lines[number - 1])
    path.write_text("\n".join(lines), encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(
    ("file", "line", "change"),
    [
        ("decimals.json", 5, lambda text: text[:-4]),
        ("decimals.json", 6, lambda text: text.replace('"0.400", ', "")),
        ("decimals.json", 12, lambda text: text.replace('"letter": "B"', '"letter": "C"')),
        ("decimals.json", 3, lambda text: text.replace('"table": 3', '"table": "3"')),
        ("formulas.json", 10, lambda text: text.replace("sqrt(d + 1)", "sqrt(d + 1")),
        ("formulas.json", 10, lambda text: text.replace("sqrt(d + 1)", "__import__(1)")),
        ("formulas.json", 10, lambda text: text.replace("(d + 1)", "(d + 1.0)")),
        ("formulas.json", 10, lambda text: text.replace('"family": "B"', '"family": "H3"')),
        ("formulas.json", 30, lambda text: text.replace('"quantity"', '"quality"')),
        ("formulas.json", 30, lambda text: text.replace('"text"', '"txt"')),
        ("points.json", 3, lambda text: text.replace('"k"]', "7]")),
        ("points.json", 3, lambda text: text.replace('"runs"', '"family"')),
        ("points.json", 4, lambda text: "  17,"),
        ("statements.json", 20, lambda text: text.replace('"facet"', '"fact"', 1)),
        ("statements.json", 20, lambda text: text + text),
    ],
)
def test_a_damaged_file_is_named_with_its_line(tmp_path, file, line, change):
    before = (DATA / file).read_text(encoding="utf-8").split("\n")[line - 1]
    assert change(before) != before
    with pytest.raises(CoxeterError, match=rf"{file}, line {line}\b"):
        load(damage(tmp_path, file, line, change))


def test_a_lost_row_or_file_is_named(tmp_path):
    directory = damage(tmp_path, "decimals.json", 10, lambda text: "")
    with pytest.raises(CoxeterError, match=r"decimals\.json, line 10"):
        load(directory)
    (directory / "points.json").unlink()
    shutil.copy(DATA / "decimals.json", directory)
    with pytest.raises(CoxeterError, match=r"points.json, line 1: cannot be read"):
        load(directory)
    (directory / "points.json").write_bytes(b"[\n\xff\n]\n")
    with pytest.raises(CoxeterError, match=r"points.json, line 2: not UTF-8"):
        load(directory)


def test_an_undamaged_copy_is_read(tmp_path):
    for source in DATA.glob("*.json"):
        shutil.copy(source, tmp_path)
        assert isinstance(json.loads(source.read_text(encoding="utf-8")), list)
    assert load(tmp_path) == PAPER


def test_the_paper_imports_no_mathematics():
    for path in DATA.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.level == 2:
                assert node.module in ("errors", "names")
            modules = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            assert not {"numpy", "sympy", "flint", "coxeter"} & set(modules)
