"""The command line as a user meets it: what it prints, and how it refuses."""

import io
import json
import subprocess
import sys

import pytest
import sympy
from synthetic import BLIND, ENDLESS, GOOD, RAISES, ledger_of, make

from coxeter import __version__, proofs, triangulation
from coxeter.cli import main
from coxeter.ledger import recorded, running
from coxeter.ledger.claim import CLAIMS, holds
from coxeter.ledger.vocabulary import EVERY_D
from coxeter.names import triangulations_up_to
from coxeter.proofs.proof import Proof, Step, argument

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


# -- verify and explain, on a ledger made up for the tests -------------------------------------------------


@pytest.fixture
def good(tmp_path):
    with ledger_of(tmp_path, *GOOD) as file:
        yield file


@pytest.mark.usefixtures("good")
def test_verify_sums_up_and_ends_with_0_if_all_is_as_recorded(capsys):
    status, out, err = run(capsys, "verify")
    assert (status, err) == (0, "")
    assert "5 claims in " in out
    assert "6 of 6 mutants rejected, 100 %" in out
    assert out.endswith("Everything came out as recorded.\n")
    assert "thm-90.number" not in out


@pytest.mark.usefixtures("good")
def test_verify_says_of_few_claims_what_came_out_of_each(capsys):
    status, out, _ = run(capsys, "verify", "thm-90", "--section", "3")
    assert status == 0
    assert "thm-90.number  holds, corrected · exact up to d = 8 · a result people use\n" in out
    assert "thm-90.false   fails · instances · a result people use\n" in out
    assert "def-90" not in out


@pytest.mark.parametrize(
    ("claim", "words"),
    [
        (BLIND, ["thm-91: differs", "expected: nothing on record; came out: holds · ", "n: 2"]),
        (RAISES, ["thm-92: error", "error: ValueError: no idea", "(synthetic.py, line "]),
        (ENDLESS, ["thm-94: timeout", "timeout: not done after 0.1 s"]),
    ],
)
@pytest.mark.usefixtures("good")
def test_verify_ends_with_1_and_names_what_is_not_as_recorded(capsys, monkeypatch, claim, words):
    monkeypatch.setattr(running, "BUDGET", 0.1)
    CLAIMS[claim.id] = claim
    status, out, err = run(capsys, "verify")
    assert (status, err) == (1, "")
    assert "1 claim not as recorded:" in out
    for text in words:
        assert text in out
    assert "Traceback" not in out
    assert run(capsys, "verify", "thm-90")[0] == 0  # the others are as recorded


def test_verify_names_expected_and_found(capsys, good):
    text = good.read_text(encoding="utf-8")
    good.write_text(text.replace("radius 1 at most", "radius 2 at most"), encoding="utf-8")
    recorded._load.cache_clear()
    status, out, _ = run(capsys, "verify", "thm-90")
    assert status == 1
    assert "thm-90.false: differs" in out
    assert "correction: expected 'radius 2 at most', came out 'radius 1 at most'" in out


@pytest.mark.usefixtures("good")
@pytest.mark.parametrize("arguments", [("verify",), ("verify", "thm-9")])
def test_verify_notices_a_record_without_a_claim(capsys, arguments):
    del CLAIMS["thm-9"]
    status, out, _ = run(capsys, *arguments)
    assert status == 1
    assert "thm-9: differs" in out
    assert "expected: cited · literature · a result people use; there is no such claim" in out
    assert run(capsys, "verify", "thm-90")[0] == 0


def test_verify_names_survivors(capsys, tmp_path):
    with ledger_of(tmp_path, BLIND):
        status, out, _ = run(capsys, "verify")
    assert status == 1
    assert "0 of 3 mutants rejected, 0 %" in out
    assert "thm-91: mutants survive" in out
    assert "this mutant is not rejected: n: 2" in out


ENTRIES = {
    "id", "place", "statement", "verdict", "strength", "weight", "depends_on", "seconds", "mutants",
    "witness", "correction", "outcome", "expected", "problems",
}  # fmt: skip


@pytest.mark.usefixtures("good")
def test_verify_as_json(capsys):
    CLAIMS["thm-92"] = RAISES
    del CLAIMS["thm-9"]
    status, out, err = run(capsys, "verify", "--json")
    data = {entry["id"]: entry for entry in json.loads(out)}
    assert (status, err) == (1, "")
    assert list(data) == ["def-90", "thm-90.number", "thm-90.false", "lem-90", "thm-92", "thm-9"]
    assert all(entry.keys() == ENTRIES for entry in data.values())
    false = data["thm-90.false"]
    assert isinstance(false.pop("seconds"), float)
    assert false == {
        "id": "thm-90.false",
        "place": "Section 3, Theorem 90",
        "statement": "Words.",
        "verdict": "fails",
        "strength": "instances",
        "weight": "a result people use",
        "depends_on": {"to_state": ["def-90"], "to_prove": ["lem-90"]},
        "mutants": {"tried": 0, "rejected": 0},
        "witness": "the triangle with radius 0",
        "correction": "radius 1 at most",
        "outcome": "as recorded",
        "expected": {
            "verdict": "fails",
            "strength": "instances",
            "weight": "a result people use",
            "correction": "radius 1 at most",
        },
        "problems": [],
    }
    assert data["def-90"]["statement"] == "It is 60."
    assert data["def-90"]["mutants"] == {"tried": 3, "rejected": 3}
    error, lost = data["thm-92"], data["thm-9"]
    assert (error["verdict"], error["strength"], error["outcome"]) == (None, None, "error")
    assert (error["expected"], len(error["problems"])) == (None, 1)
    assert (lost["verdict"], lost["outcome"], lost["expected"]["verdict"]) == (None, "differs", "cited")


@pytest.mark.usefixtures("good")
@pytest.mark.parametrize(
    ("arguments", "hint"),
    [
        (("verify", "thm-90.numbers"), "did you mean thm-90.number"),
        (("verify", "thm-90", "lem-9"), "did you mean lem-90"),
        (("verify", "--section", "7"), "1 to 6, or A to D"),
        (("verify", "--family", "H"), "A to G"),
        (("verify", "thm-90", "--family", "B"), "leave out"),
        (("verify", "--jobs", "0"), ">= 1"),
        (("verify", "--jobs", "-2"), ">= 1"),
        (("explain", "def-9"), "did you mean def-90"),
    ],
)
def test_a_wrong_choice_of_claims_is_one_sentence_and_status_2(capsys, arguments, hint):
    status, out, err = run(capsys, *arguments)
    assert (status, out) == (2, "")
    assert err.startswith("coxeter: ")
    assert err.count("\n") == 1
    assert hint in err


@pytest.mark.parametrize("arguments", [("verify", "--jobs", "many"), ("verify", "--fast"), ("explain",)])
def test_wrong_usage_of_verify_and_explain_is_one_line_and_status_2(capsys, arguments):
    with pytest.raises(SystemExit) as stop:
        main(arguments)
    assert stop.value.code == 2
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("arguments", [("verify",), ("explain", "def-90")])
def test_a_damaged_record_is_named_with_its_line(capsys, good, arguments):
    lines = good.read_text(encoding="utf-8").split("\n")
    lines[3] = lines[3][:-5]
    good.write_text("\n".join(lines), encoding="utf-8")
    recorded._load.cache_clear()
    status, out, err = run(capsys, *arguments)
    assert (status, out) == (2, "")
    assert "recorded.json, line 4" in err


@pytest.mark.usefixtures("good")
def test_progress_is_shown_on_a_terminal_only(monkeypatch, capsys):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    assert run(capsys, "verify")[2] == ""
    monkeypatch.setattr(sys, "stderr", Terminal())
    assert main(["verify"]) == 0
    shown = sys.stderr.getvalue()
    assert "0 of 5 claims" in shown
    assert "5 of 5 claims" in shown
    assert "\n" not in shown
    assert shown.endswith("\r\x1b[K")


@pytest.mark.usefixtures("good")
@pytest.mark.parametrize("columns", ["80", "100", "300"])
def test_explain_tells_all_and_is_readable(capsys, monkeypatch, columns):
    monkeypatch.setenv("COLUMNS", columns)
    long = make("thm-95", lambda _: holds(EVERY_D, "A long line. " * 20), words="Many words. " * 20)
    CLAIMS["thm-95"] = long
    status, out, err = run(capsys, "explain", "thm-90", "lem-90", "thm-95")
    assert (status, err) == (0, "")
    assert max(map(len, out.splitlines())) <= min(int(columns), 100)
    for text in (
        "thm-90.false · Section 3, Theorem 90\n====",
        "Statement\n  Words.\n",
        "Printed\n  number: 4\n",
        "Verdict\n  fails · instances · a result people use\n",
        "Instead\n  radius 1 at most\n",
        "Correction\n  number: printed 4, true 3\n",
        "Witness\n  the triangle with radius 0\n",
        "Derivation\n  1. One.\n  2. Two.\n",
        "Our proof\n  ours uses the other side\n",
        "Mutants\n  3 of 3 mutants rejected, 100 %\n",
        "Needs to be stated\n  def-90\n",
        "Needs to be proved\n  lem-90\n",
        "Needed to prove\n  thm-90.false\n",
        "Code\n  coxeter.ledger.section_3.false",
        "It is not on record.",
    ):
        assert text in out


def test_explain_shows_a_proof_step_by_step(capsys, tmp_path, monkeypatch):
    step = Step("identity", "The sums agree", "x = y", "d \\geq 2", "x - y = 0")
    proof = Proof("All sums agree", (step, argument("So do the others")))
    monkeypatch.setattr(proofs, "prove", lambda *_: proof)
    finding = holds(EVERY_D, proof=("sums", "B"))
    with ledger_of(tmp_path, make("thm-96", lambda _: finding)):
        out = run(capsys, "explain", "thm-96")[1]
        (data,) = json.loads(run(capsys, "explain", "thm-96", "--json")[1])
    assert "Proof\n  1. The sums agree\n     x = y,  d \\geq 2\n     x - y = 0\n  2. So do" in out
    assert data["proof"] == [
        {
            "kind": "identity",
            "words": "The sums agree",
            "formula": "x = y",
            "range": "d \\geq 2",
            "reduced": "x - y = 0",
        },
        {"kind": "argument", "words": "So do the others"},
    ]


@pytest.mark.usefixtures("good")
def test_explain_as_json(capsys):
    CLAIMS["thm-92"] = RAISES
    status, out, _ = run(capsys, "explain", "lem-90", "thm-92", "--json")
    lemma, error = json.loads(out)
    assert status == 0
    assert lemma.keys() == ENTRIES | {
        "printed", "evidence", "tested", "derivation", "proof", "needed_by", "code",
    }  # fmt: skip
    assert lemma["needed_by"] == {"to_state": [], "to_prove": ["thm-90.false"]}
    assert lemma["derivation"] == ["One.", "Two."]
    assert error["outcome"] == "error"


@pytest.mark.usefixtures("good")
def test_explain_shows_an_error_as_such(capsys):
    CLAIMS["thm-92"] = RAISES
    status, out, err = run(capsys, "explain", "thm-92")
    assert (status, err) == (0, "")
    assert "Verdict\n  error: ValueError: no idea" in out


def test_the_command_starts_without_the_heavy_libraries():
    program = "import sys, coxeter.cli; print({'sympy', 'matplotlib', 'networkx'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"
