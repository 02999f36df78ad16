"""``coxeter compare`` as a user meets it."""

import csv
import io
import json
import time

import pytest

from coxeter import find_measure, triangulation
from coxeter.cli import main
from coxeter.peers import PEERS
from coxeter.quality import MEASURES, MESH_MEASURES


def run(capsys, *arguments):
    status = main(("compare", *arguments))
    return status, *capsys.readouterr()


@pytest.mark.parametrize("measure", [*MEASURES, *MESH_MEASURES])
def test_every_measure(capsys, measure):
    status, out, err = run(capsys, "--measure", measure, "--max-dim", "4", "--format", "csv", "--digits", "6")
    assert (status, err) == (0, "")
    rows = {row[0]: row for row in csv.reader(io.StringIO(out))}
    assert rows["family"] == ["family", "2", "3", "4"]
    known = find_measure(measure)
    assert rows["B~"][2] == known.normalized(triangulation("B~3")).decimal(6)
    assert rows["D1"][2] == PEERS["D1"].worst(known, 3).decimal(6)
    best = rows["best"][1:]
    for column, names in enumerate(best, 1):
        winners = names.split(" = ")
        values = {
            name: float(row[column]) for name, row in rows.items() if name in {"A~", *PEERS} and row[column]
        }
        assert all(values.get(name, 1) >= max(values.values()) for name in winners if name in values)


def test_text_explains_itself(capsys):
    status, out, _ = run(capsys, "--measure", "thickness", "--max-dim", "3", "--with", "D1, five,hill:1/4")
    assert status == 0
    assert out.startswith("Normalised thickness\n")
    for words in ("1 is the regular simplex", "0.866*", "D1: Dang", "five: ", "hill:1/4: Hill and Hadwiger"):
        assert words in out
    assert "J1" not in out
    assert "Of the others" not in run(capsys, "--with", "none")[1]


def test_exact_and_json(capsys):
    assert "sqrt(3)/2*" in run(capsys, "--max-dim", "3", "--exact")[1]
    data = json.loads(run(capsys, "--max-dim", "3", "--format", "json", "--with", "K1")[1])
    rows = {row["family"]: row for row in data["rows"]}
    assert rows["A~"]["3"] == {"exact": "sqrt(3)/2", "decimal": "0.866", "best": True}
    assert "best" not in rows["K1"]["3"]


def test_twenty_dimensions_take_seconds(capsys):
    started = time.process_time()
    status, out, _ = run(capsys, "--measure", "minimal_solid_angle", "--max-dim", "20")
    assert status == 0
    assert "20" in out.splitlines()[2]
    assert time.process_time() - started < 20  # about 5 on a quiet machine


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--measure", "beauty"), "'beauty' is no quality measure; there are aspect_ratio"),
        (("--max-dim", "1"), "give an integer >= 2"),
        (("--with", "K2"), "'K2' is no triangulation to compare with; there are K1"),
        (("--with", "hill:-1"), "give a positive number"),
        (("--with", "hill:a"), "hill"),
        (("--with", ""), "is no triangulation to compare with"),
        (("--format", "pdf"), "'pdf' is no format"),
        (("--digits", "-1"), "digits"),
        (("--digits", "100000"), "100000 digits cannot be shown: give 0 to 1000"),
        (("--max-dim", "41"), "leave it out by --with K1"),
    ],
)
def test_bad_input_is_one_sentence_and_status_2(capsys, arguments, words):
    status, out, err = run(capsys, *arguments)
    assert (status, out) == (2, "")
    assert err.startswith("coxeter: ")
    assert err.count("\n") == 1
    assert words in err


def test_too_wide_a_table_is_refused(capsys):
    status, out, err = run(capsys, "--max-dim", "1000000")
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert "200 or fewer" in err
