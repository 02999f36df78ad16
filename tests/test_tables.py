"""Tables: every format says the same, cells are correctly rounded, and refusals are typed."""

import csv
import io
import json
import re
from decimal import ROUND_HALF_EVEN, Decimal

import pytest
import sympy

from coxeter import InvalidInput, Surd, triangulation
from coxeter.quality import aspect_ratio, fatness, radius_ratio, thickness
from coxeter.tables import FORMATS, TABLES, Table, runs, table

MEASURE = {"3": aspect_ratio, "4": radius_ratio, "5": fatness, "6": thickness}


@pytest.mark.parametrize("number", TABLES)
@pytest.mark.parametrize("format", FORMATS)
@pytest.mark.parametrize("exact", [False, True])
def test_every_table_renders_in_every_format(number, format, exact):
    made = table(number, max_dim=4)
    text = made.render(format, exact=exact)
    tex = {str(row[0]): re.sub(r"^([A-G])~\d*$", r"\\tilde{\1}", str(row[0])) for row in made.rows}
    assert all(name in text or form in text for name, form in tex.items())


@pytest.mark.parametrize("number", MEASURE)
@pytest.mark.parametrize("digits", [1, 3, 8])
def test_cells_are_correctly_rounded(number, digits):
    step = Decimal(1).scaleb(-digits)
    for row in table(number, max_dim=8).rows:
        for d, cell in enumerate(row[1:], 2):
            if cell is None:
                continue
            value = MEASURE[number].normalized(triangulation((row[0][0], d)).simplex).sympy()
            expected = Decimal(str(sympy.N(value, 60))).quantize(step, ROUND_HALF_EVEN)
            assert Decimal(cell.decimal(digits)) == expected


def test_csv_and_json_and_exact_agree():
    made = table(5, max_dim=6)
    rows = list(csv.reader(io.StringIO(made.render("csv", digits=6))))
    surds = list(csv.reader(io.StringIO(made.render("csv", exact=True))))
    objects = json.loads(made.render("json", digits=6))["rows"]
    for row, exact, data in zip(rows[1:], surds[1:], objects, strict=True):
        for name, cell, form in zip(rows[0][1:], row[1:], exact[1:], strict=True):
            entry = data[name] or {"decimal": "", "exact": ""}
            assert (entry["decimal"], entry["exact"]) == (cell, form)


def test_table_2_tells_delaunay_protection_and_lattice():
    rows = {row[0]: row[5:] for row in table(2, max_dim=8).rows}
    assert {name for name, (delaunay, _, _) in rows.items() if delaunay == "yes"} == {
        name for name in rows if name[0] in "ACFG"
    }
    assert {name for name, (_, relative, _) in rows.items() if relative} == {n for n in rows if n[0] == "A"}
    assert {name for name, (_, _, lattice) in rows.items() if lattice == "yes"} == {
        name for name in rows if name[0] in "AC" or name == "D~4"
    }


@pytest.mark.parametrize(
    ("number", "options"),
    [(7, {}), ("", {}), (5, {"max_dim": 1}), (5, {"max_dim": "8"}), (5, {"max_dim": 2.5})],
)
def test_refused_tables(number, options):
    with pytest.raises(InvalidInput, match=r"give|there are"):
        table(number, **options)


def test_refused_rendering():
    made = Table("t", ("a",), ((Surd(1),),))
    with pytest.raises(InvalidInput, match="csv"):
        made.render("pdf")
    with pytest.raises(InvalidInput, match="-2"):
        made.render(digits=-2)


def test_cells_are_escaped_in_html():
    assert "<b>" not in Table("<b>", ("<b>",), (("<b>",),))._repr_html_()


def test_runs():
    assert runs((1, 1, 0, 1)) == "(1^{2}, 0, 1)"
