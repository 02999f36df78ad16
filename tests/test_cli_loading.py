"""Measures of one's own on the command line, in processes of their own."""

import json
import subprocess
import sys

import numpy as np
import pytest

from coxeter.cli import main
from coxeter.location import Grid
from coxeter.meshes import write_mesh
from coxeter.quality import MEASURES

EDGES = """
from itertools import combinations
from math import prod
import coxeter
from coxeter.quality import root

print("this is no part of the answer")

@coxeter.measure("volume_to_edges")
def volume_to_edges(simplex):
    d = simplex.dimension
    pairs = list(combinations(range(d + 1), 2))
    edges = prod(simplex.squared_edge_lengths[i, j] for i, j in pairs)
    return root(simplex.volume**2, d) / root(edges, len(pairs))
"""
TWO = """
import coxeter

@coxeter.measure("angle_ratio")
def angle_ratio(simplex):
    return simplex.minimal_dihedral_angle / simplex.maximal_dihedral_angle

@coxeter.measure("size")
def size(simplex):
    return simplex.inradius
"""
HEAD = "import coxeter\n@coxeter.measure('mine')\ndef mine(simplex):\n    "


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with a mesh of regular triangles in it, and us there."""
    monkeypatch.chdir(tmp_path)
    write_mesh(Grid("A~2").patch_in_ball([0, 0], 1), "mesh.npz")
    return tmp_path


def coxeter(*arguments):
    command = [sys.executable, "-m", "coxeter.cli", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    return done.returncode, done.stdout, done.stderr


def test_a_surd_is_compared_and_judged(folder):
    (folder / "edges.py").write_text(EDGES)
    status, out, err = coxeter(
        "compare", "--load", "edges.py", "--max-dim", "3", "--format", "json", "--exact"
    )
    assert (status, err) == (0, "this is no part of the answer\n")
    data = json.loads(out)
    assert data["title"] == "Normalised volume to edges"
    rows = {row["family"]: row for row in data["rows"]}
    assert rows["A~"]["2"]["exact"] == "1"
    assert rows["A~"]["3"]["exact"] == "(8/9)**(1/3)"
    status, out, _ = coxeter("quality", "mesh.npz", "--load", "edges.py", "--json")
    (measure,) = [x for x in json.loads(out)[0]["measures"] if x["measure"] == "volume_to_edges"]
    assert np.allclose([measure["min"], measure["max"]], 1, rtol=1e-12)


def test_of_several_one_is_chosen_and_size_is_told(folder):
    (folder / "two.py").write_text(TWO)
    assert "choose by --measure one of angle_ratio, size" in coxeter("compare", "--load", "two.py")[2]
    arguments = ("--load", "two.py", "--max-dim", "3", "--with", "none", "--measure")
    status, out, err = coxeter("compare", *arguments, "angle_ratio")
    assert (status, err) == (0, "")
    assert "0.667*" in out
    assert "size" not in out
    assert coxeter("compare", *arguments, "size")[1].count("depends on the size of a simplex") == 1
    assert "depends on the size" in coxeter("compare", *arguments, "size", "--format", "csv")[2]
    out = coxeter("quality", "mesh.npz", "--load", "two.py", "--measure", "size")[1]
    assert out.count("depends on the size of a simplex") == 1
    raw = coxeter("quality", "mesh.npz", "--load", "two.py", "--measure", "size", "--raw")[1]
    assert "depends" not in raw


@pytest.mark.parametrize(
    ("source", "words"),
    [
        (None, "--load mine.py: No such file"),
        ("x = 1", 'mine.py registers no measure: put @coxeter.measure("my name")'),
        ("x = 1\n\ny = 1 / 0", "mine.py, line 3: ZeroDivisionError: division by zero"),
        ("import coxeter\ndef f(:", "mine.py, line 2: SyntaxError"),
        ("import sys\nsys.exit(3)", "mine.py, line 2: SystemExit: 3"),
        ("import coxeter\ncoxeter.measure('thickness')(abs)", "line 2: InvalidInput: there is already a"),
        (b"\xff\xfe", "mine.py cannot be read as Python"),
        (
            HEAD + "x = 0\n    return 1 / x",
            "'mine' raised ZeroDivisionError: division by zero (mine.py, line 5)",
        ),
        (HEAD + "return 0.5", "the measure 'mine' gives no exact number: 0.5 is inexact"),
        (HEAD + "return 'beauty'", "the measure 'mine' gives no exact number: 'beauty'"),
        (HEAD + "return None", "the measure 'mine' gives no exact number: None"),
        (HEAD + "return 0", "the measure 'mine' is 0 of the regular 2-simplex"),
        (HEAD + "return -simplex.inradius", "of the regular 2-simplex: to be normalised it must be positive"),
    ],
)
@pytest.mark.parametrize(
    "command", [("compare", "--max-dim", "3"), ("quality", "mesh.npz", "--measure", "mine")]
)
def test_what_is_wrong_with_a_file_is_one_sentence(folder, capsys, command, source, words):
    if source is not None:
        (folder / "mine.py").write_bytes(source if isinstance(source, bytes) else source.encode())
    before = list(MEASURES)
    status = main([*command, "--load", "mine.py"])
    out, err = capsys.readouterr()
    assert (status, out) == (2, "")
    assert err.startswith("coxeter: ")
    assert err.count("\n") == 1
    assert words in err
    assert list(MEASURES) == before


def test_a_file_may_import_its_neighbours(folder):
    (folder / "there").mkdir()
    (folder / "there" / "constants.py").write_text("two = 2")
    (folder / "there" / "mine.py").write_text(
        f"from constants import two\n{HEAD}return two * simplex.dimension"
    )
    assert coxeter("compare", "--load", "there/mine.py", "--max-dim", "2")[0] == 0
    assert not (folder / "there" / "mine.pyc").exists()
