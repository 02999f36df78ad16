"""The command line as a user meets it: what it prints, and how it refuses."""

import json
import subprocess
import sys

import pytest
import sympy

from coxeter import __version__, triangulation
from coxeter.cli import main
from coxeter.names import triangulations_up_to

SMALL = [kind.affine for kind in triangulations_up_to(5)]


def run(capsys, *arguments):
    status = main(arguments)
    return status, *capsys.readouterr()


@pytest.mark.parametrize(
    "arguments",
    [
        ("info", "B~2"),
        ("info", "E~9"),
        ("info", "A~0"),
        ("info", "H~3"),
        ("info", ""),
        ("info", "A~3.5"),
        ("table", "7"),
        ("table", "5", "--max-dim", "1"),
        ("table", "5", "--digits", "-1"),
        ("table", "5", "--format", "pdf"),
        ("list", "--max-dim", "0"),
        ("simplex", "0,0; 1,1; 2,2"),
        ("simplex", "0,0; 1,0; nan,1"),
        ("simplex", "0,0; 1"),
        ("simplex", ""),
    ],
)
def test_bad_input_is_one_sentence_and_status_2(capsys, arguments):
    status, out, err = run(capsys, *arguments)
    assert status == 2
    assert not out
    assert err.startswith("coxeter: ")
    assert err.count("\n") == 1
    assert "Traceback" not in err


@pytest.mark.parametrize("arguments", [("frobnicate",), ("info",), ("table", "5", "--max-dim", "x"), ()])
def test_wrong_usage_is_one_line_and_status_2(capsys, arguments):
    with pytest.raises(SystemExit) as stop:
        main(arguments)
    assert stop.value.code == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    assert "--help" in err


@pytest.mark.parametrize(
    ("name", "hint"), [("B~2", "C~2"), ("D~3", "A~3"), ("E~9", "E~8"), ("A~1", "d >= 2")]
)
def test_a_refused_type_is_named_with_what_to_take(capsys, name, hint):
    _, _, err = run(capsys, "info", name)
    assert repr(name) in err
    assert hint in err


def test_a_float_is_no_exact_coordinate_but_its_decimal_text_is(capsys):
    status, out, _ = run(capsys, "simplex", "0,0; 0.5,0; 0,1", "--json")
    assert status == 0
    assert json.loads(out)["vertices"][1] == ["1/2", "0"]


def test_a_vertex_may_start_with_a_minus_sign(capsys):
    status, out, _ = run(capsys, "simplex", "-1,0; 1,0; 0,sqrt(3)", "--json")
    assert status == 0
    assert json.loads(out)["normalized"]["thickness"]["exact"] == "1"


KEYS = {
    "type", "dimension", "vertices", "marks", "minimal_height", "longest_edge", "inradius", "circumradius",
    "volume", "circumcentre", "quality", "normalized", "delaunay", "protected", "relative_protection",
    "vertex_set_is_lattice",
}  # fmt: skip


@pytest.mark.parametrize("name", SMALL)
def test_json_has_all_keys_and_exact_values_that_sympy_reads(capsys, name):
    status, out, _ = run(capsys, "info", name, "--json")
    data = json.loads(out)
    assert status == 0
    assert data.keys() >= KEYS
    simplex = triangulation(name).simplex
    values = {
        "circumradius": simplex.circumradius,
        "inradius": simplex.inradius,
        "volume": simplex.volume,
    }
    for key, value in values.items():
        assert sympy.simplify(sympy.sympify(data[key]["exact"]) - value.sympy()) == 0
        assert data[key]["decimal"] == float(value)
    for group in ("quality", "normalized"):
        for entry in data[group].values():
            assert abs(float(sympy.sympify(entry["exact"])) - entry["decimal"]) < 1e-12


def test_verdicts_in_json_are_booleans(capsys):
    data = json.loads(run(capsys, "info", "D~4", "--json")[1])
    found = data["delaunay"], data["protected"], data["vertex_set_is_lattice"]
    assert found == (False, False, True)


def test_json_keeps_decimals_that_are_no_floats(capsys):
    out = run(capsys, "info", "A~200", "--json")[1]
    volume = json.loads(out, parse_float=str)["volume"]["decimal"]
    mantissa, exponent = volume.split("e")
    assert int(exponent) < -308
    assert mantissa != "0.0"


def test_the_sheet_shows_every_section(capsys):
    status, out, _ = run(capsys, "info", "B~3")
    assert status == 0
    for heading in (
        "Diagram",
        "marks",
        "Vertices",
        "Facets",
        "Centres",
        "Lengths",
        "Quality",
        "Triangulation",
    ):
        assert heading in out


def test_csv_has_the_ascii_name_first_then_a_column_for_each_dimension(capsys):
    out = run(capsys, "table", "6", "--max-dim", "9", "--digits", "4", "--format", "csv")[1]
    header, *rows = (line.split(",") for line in out.splitlines())
    assert header == ["family", *map(str, range(2, 10))]
    assert [row[0] for row in rows] == ["A~", "B~", "C~", "D~", "E~", "F~", "G~"]
    cells = {(row[0][0], int(d)): cell for row in rows for d, cell in zip(header[1:], row[1:], strict=True)}
    assert {k for k, cell in cells.items() if cell} == {(t.letter, t.rank) for t in triangulations_up_to(9)}


def test_list_names_every_triangulation(capsys):
    out = run(capsys, "list", "--max-dim", "8")[1]
    assert all(kind.affine in out for kind in triangulations_up_to(8))


def test_the_command_is_installed_and_survives_a_closed_pipe():
    command = f"{sys.executable} -m coxeter.cli table 5 --max-dim 40 | head -1"
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert done.stdout.startswith("Table 5")
    assert not done.stderr


def test_version(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["--version"])
    assert stop.value.code == 0
    assert __version__ in capsys.readouterr().out
