"""``coxeter mesh`` and ``coxeter quality`` as a user meets them."""

import io
import json
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

from coxeter import normalized_qualities, triangulation
from coxeter.cli import main
from coxeter.location import Grid
from coxeter.meshes import Mesh, mesh_qualities, quality_report, read_mesh, write_mesh
from coxeter.quality import MEASURES, MESH_MEASURES


def run(capsys, *arguments):
    status = main([str(x) for x in arguments])
    return status, *capsys.readouterr()


@pytest.fixture
def square(tmp_path):
    """Two right triangles, one that is flat, and a long one."""
    points = [(0, 0), (1, 0), (0, 1), (1, 1), (2, 2), (9, 0)]
    mesh = Mesh(points, [[0, 1, 2], [1, 2, 3], [0, 3, 4], [0, 5, 2]])
    write_mesh(mesh, tmp_path / "square.vtu")
    return tmp_path / "square.vtu"


# -- mesh ------------------------------------------------------------------------------------------------


def test_mesh_writes_what_the_grid_has(capsys, tmp_path):
    path = tmp_path / "out.vtu"
    arguments = ("--box", "-1,0,0,1,1,1", "--scale", "0.5", "--offset", "-.1,.2,0", "--quality", "-o", path)
    status, out, err = run(capsys, "mesh", "B~3", *arguments)
    assert (status, err) == (0, "")
    grid = Grid("B~3", scale=0.5, offset=[-0.1, 0.2, 0])
    expected, found = grid.patch_in_box([-1, 0, 0], [1, 1, 1], oriented=True), read_mesh(path)
    assert np.array_equal(found.points, expected.points)
    assert np.array_equal(found.cells, expected.cells)
    assert f"{len(expected)} simplices, {len(expected.points)} points" in out
    edges = found.corners[:, 1:] - found.corners[:, :1]
    assert (np.linalg.det(edges) > 0).all()
    labels = found.point_data["label"][found.cells]
    assert (np.sort(labels, axis=1) == range(4)).all()
    for name, value in normalized_qualities(triangulation("B~3").simplex).items():
        assert np.allclose(found.cell_data[name], float(value), rtol=1e-9)
        assert f"{name} {float(value):.3f}" in out


def test_mesh_of_a_ball_in_any_dimension(capsys, tmp_path):
    status, out, _ = run(capsys, "mesh", "C~4", "--ball", "0,0,0,0,.5", "-o", tmp_path / "out.npz")
    assert status == 0
    expected = Grid("C~4").patch_in_ball([0, 0, 0, 0], 0.5)
    assert len(read_mesh(tmp_path / "out.npz")) == len(expected)
    assert f"{len(expected)} simplices" in out
    assert "minimal_solid_angle" not in out


def test_mesh_says_what_a_format_does_not_keep(capsys, tmp_path):
    status, out, err = run(capsys, "mesh", "A~2", "--ball", "0,0,1", "-o", tmp_path / "out.off")
    assert (status, err) == (0, "")
    assert ".off does not keep label" in out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("A~3", "--box", "0,0,1,1"), "has 4 numbers: give 6"),
        (("A~3", "--box", "-1,0,0,1,x,1"), "are no numbers"),
        (("A~3", "--box", "1,0,0,0,1,1"), "swap them"),
        (("A~3", "--box", "0,0,0,nan,1,1"), "finite"),
        (("A~3", "--ball", "0,0,1"), "has 3 numbers: give 4"),
        (("A~3", "--ball", "0,0,0,-1"), "radius"),
        (("A~3", "--ball", "0,0,0,1", "--offset", "1,2"), "--offset '1,2'"),
        (("A~3", "--ball", "0,0,0,1", "--scale", "0"), "scale"),
        (("A~3", "--ball", "0,0,0,1", "--scale", "1e-6"), "too many"),
        (("A~3", "--ball", "0,0,0,1", "--scale", "1e300"), "the scale 1e+300 is none: give one from"),
        (("A~3", "--ball", "0,0,0,1e300"), "too many"),
        (("A~3", "--ball", "0,0,0,1", "--offset", ""), "--offset ''"),
        (("H~3", "--ball", "0,0,0,1"), "H~3"),
        (("C~4", "--ball", "0,0,0,0,1"), "write .npz"),
    ],
)
def test_a_mesh_that_cannot_be_is_one_sentence_and_leaves_nothing(capsys, tmp_path, arguments, words):
    status, out, err = run(capsys, "mesh", *arguments, "-o", tmp_path / "out.vtu")
    assert (status, out) == (2, "")
    assert err.startswith("coxeter: ")
    assert err.count("\n") == 1
    assert words in err
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["out.doc", "out", "nowhere/out.vtu"])
def test_a_path_that_cannot_be_is_refused_before_the_work(capsys, tmp_path, monkeypatch, name):
    monkeypatch.setattr(Grid, "patch_in_ball", None)
    status, _, err = run(capsys, "mesh", "A~3", "--ball", "0,0,0,1", "-o", tmp_path / name)
    assert status == 2
    assert "out" in err


def test_a_folder_is_refused_as_a_file_before_the_work(capsys, tmp_path, monkeypatch):
    monkeypatch.setattr(Grid, "patch_in_ball", None)
    (tmp_path / "out.vtu").mkdir()
    status, _, err = run(capsys, "mesh", "A~3", "--ball", "0,0,0,1", "-o", tmp_path / "out.vtu")
    assert status == 2
    assert "out.vtu is a folder: give the name of a file" in err


@pytest.mark.parametrize(
    "arguments", [(), ("--box", "0,0,1,1", "--ball", "0,0,1"), ("--ball", "0,0,1", "--scale", "x")]
)
def test_wrong_usage_of_mesh_is_one_line_and_status_2(capsys, tmp_path, arguments):
    with pytest.raises(SystemExit) as stop:
        main(["mesh", "A~2", *arguments, "-o", str(tmp_path / "out.vtu")])
    assert stop.value.code == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_an_interrupted_mesh_leaves_the_old_file(capsys, tmp_path, monkeypatch):
    def interrupted(*_, **__):
        raise KeyboardInterrupt

    path = tmp_path / "out.vtu"
    path.write_text("the old file")
    monkeypatch.setattr("meshio.write", interrupted)
    status, _, err = run(capsys, "mesh", "A~2", "--ball", "0,0,1", "-o", path)
    assert (status, err) == (130, "coxeter: stopped\n")
    assert [x.read_text() for x in tmp_path.iterdir()] == ["the old file"]


HALF_WAY = """
import sys, time, meshio
from coxeter.cli import main
def half(path, *_, **__):
    path.write_text("half of it")
    time.sleep(60)
meshio.write = half
sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.parametrize("sign", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_command_that_is_stopped_leaves_nothing_but_the_old_file(tmp_path, sign):
    path = tmp_path / "out.vtu"
    path.write_text("the old file")
    command = [sys.executable, "-c", HALF_WAY, "mesh", "A~2", "--ball", "0,0,1", "-o", str(path)]
    running = subprocess.Popen(command, stderr=subprocess.PIPE)
    while running.poll() is None and not list(tmp_path.glob(".*/out.vtu")):
        time.sleep(0.01)
    running.send_signal(sign)
    assert running.communicate()[1] == b"coxeter: stopped\n"
    assert running.returncode == 128 + sign
    assert [x.read_text() for x in tmp_path.iterdir()] == ["the old file"]


def test_the_bar_is_shown_on_a_terminal_only(capsys, tmp_path, monkeypatch, square):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    for arguments in (
        ["mesh", "A~2", "--ball", "0,0,1", "-o", str(tmp_path / "out.vtu")],
        ["quality", str(square)],
    ):
        assert run(capsys, *arguments)[2] == ""
        with monkeypatch.context() as patch:
            patch.setattr(sys, "stderr", Terminal())
            assert main(arguments) == 0
            shown = sys.stderr.getvalue()
        assert "cells judged" in shown
        assert "\n" not in shown
        assert shown.endswith("\r\x1b[K")


# -- quality ---------------------------------------------------------------------------------------------


def test_quality_tells_of_each_file(capsys, square, tmp_path):
    write_mesh(Mesh(np.eye(5), [range(5)]), tmp_path / "regular.npz")
    status, out, err = run(capsys, "quality", square, tmp_path / "regular.npz")
    assert (status, err) == (0, "")
    first, second = out.split("\n\n" + str(tmp_path))
    faults = "1 degenerate to rounding, left out below: 2\n1 inverted, oriented negatively: 1\nnone doubled"
    for text in ("4 triangles", faults, *MEASURES, *MESH_MEASURES):
        assert text in first
    values = mesh_qualities(read_mesh(square))
    row = next(line for line in first.splitlines() if line.startswith("thickness "))
    assert row.split()[1] == f"{np.nanmin(values['thickness']):.3f}"
    assert row.split()[-1] == "3"
    assert "1 simplex of dimension 4" in second
    assert "minimal_solid_angle is left out: " in second
    assert "none degenerate, none doubled" in second


def test_quality_draws_a_histogram(capsys, square):
    out = run(capsys, "quality", square, "--measure", "thickness", "--bins", "5")[1]
    heading, *bars = out.rstrip().splitlines()[-4:]
    assert heading == "thickness"
    assert [line.split()[-1] for line in bars] == ["1", "0", "2"]
    assert [line.count("█") for line in bars] == [20, 0, 40]
    assert bars[0].split()[:3] == ["0.000", "…", "0.200"]


@pytest.mark.parametrize("chunk", ["1", "3", "100"])
def test_quality_as_data_is_what_the_library_says(capsys, square, chunk):
    out = run(capsys, "quality", square, "--json", "--bins", "4", "--chunk", chunk)[1]
    (found,) = json.loads(out)
    assert found.pop("file") == str(square)
    assert found.pop("notes") == []
    expected = quality_report(read_mesh(square), bins=4).data()
    for a, b in zip(found.pop("measures"), expected.pop("measures"), strict=True):
        assert a.pop("mean") == pytest.approx(b.pop("mean"), rel=1e-12)
        assert a == b
    assert found == expected


def test_raw_values(capsys, square):
    out = run(capsys, "quality", square, "--raw", "--measure", "maximal_dihedral_angle", "--json")[1]
    (measure,) = json.loads(out)[0]["measures"]
    assert measure["max"] == pytest.approx(90)


def test_quality_says_what_was_left_out(capsys, tmp_path):
    import meshio

    cells = [("triangle", [[0, 1, 2]]), ("tetra", [[0, 1, 2, 3]])]
    meshio.write(tmp_path / "mixed.vtu", meshio.Mesh(np.eye(4)[:, :3], cells))
    assert "left out: 1 of type triangle" in run(capsys, "quality", tmp_path / "mixed.vtu")[1]
    (data,) = json.loads(run(capsys, "quality", tmp_path / "mixed.vtu", "--json")[1])
    assert "left out: 1 of type triangle" in data["notes"][0]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("nothing.vtu",), "there is no file"),
        (("square.vtu", "--measure", "beauty"), "beauty"),
        (("square.vtu", "--bins", "0"), "bins is 0"),
        (("square.vtu", "--chunk", "-1"), "chunk is -1"),
    ],
)
def test_a_quality_that_cannot_be_told_is_one_sentence(capsys, square, monkeypatch, arguments, words):
    monkeypatch.chdir(square.parent)
    status, out, err = run(capsys, "quality", *arguments)
    assert (status, out) == (2, "")
    assert err.count("\n") == 1
    assert words in err


def test_an_unknown_measure_is_refused_before_the_work(capsys, square, monkeypatch):
    monkeypatch.setattr("coxeter.cli.meshes.read_mesh", None)
    assert "'beauty' is no quality measure" in run(capsys, "quality", square, "--measure", "beauty")[2]


def test_one_is_singular_and_bars_are_for_reading(capsys, tmp_path):
    write_mesh(Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]]), tmp_path / "one.vtu")
    assert "1 tetrahedron\n" in run(capsys, "quality", tmp_path / "one.vtu")[1]
    status, _, err = run(capsys, "quality", tmp_path / "one.vtu", "--bins", "100000000000")
    assert status == 2
    assert "too many to read" in err


def test_a_bad_npz_is_named(capsys, tmp_path):
    np.savez(tmp_path / "bad.npz", points=np.full((3, 2), np.nan), cells=[[0, 1, 2]])
    status, _, err = run(capsys, "quality", tmp_path / "bad.npz")
    assert status == 2
    assert "bad.npz is no mesh: point 0 is" in err


# -- what the shell may do -------------------------------------------------------------------------------


def shell(folder, command):
    command = command.replace("coxeter", f"{sys.executable} -m coxeter.cli")
    done = subprocess.run(["sh", "-c", command], cwd=folder, capture_output=True, text=True, timeout=120)
    return done.returncode, done.stdout, done.stderr


MESH = "coxeter mesh A~2 --ball 0,0,1 -o out.vtu"


def test_closed_and_full_outputs(tmp_path):
    for closing in ("2>&-", ">&-", "2>&- >&-"):
        assert shell(tmp_path, f"{MESH} {closing}")[0] == 0
        (tmp_path / "out.vtu").unlink()
    assert shell(tmp_path, "coxeter quality nothing.vtu 2>&-")[0] == 2
    status, _, err = shell(tmp_path, "coxeter list > /dev/full")
    assert (status, err.count("\n")) == (2, 1)
    assert "No space left" in err


def test_letters_that_the_output_does_not_know(square):
    out = shell(square.parent, "PYTHONIOENCODING=ascii coxeter quality square.vtu --measure fatness")[1]
    assert "..." in out
    assert "####" in out


@pytest.mark.parametrize("suffix", [".vtu", ".med", ".npz"])
def test_a_full_disk_leaves_the_old_file(tmp_path, suffix):
    (tmp_path / f"out{suffix}").write_text("the old file")
    command = f"ulimit -f 1; coxeter mesh A~3 --ball 0,0,0,3 -o out{suffix}"
    status, _, err = shell(tmp_path, f"export PYTHONDONTWRITEBYTECODE=1; {command}")
    assert (status, err.count("\n")) == (2, 1)
    assert "cannot be written: OSError" in err
    assert [x.read_text() for x in tmp_path.iterdir()] == ["the old file"]


def test_what_may_not_be_written_is_refused(capsys, tmp_path, monkeypatch):
    path = tmp_path / "out.vtu"
    path.write_text("the old file")
    path.chmod(0o600)
    assert run(capsys, *MESH.split()[1:-1], path)[0] == 0
    assert path.stat().st_mode & 0o777 == 0o600
    monkeypatch.setattr("os.access", lambda where, _: str(where) != str(path))
    assert "write-protected" in run(capsys, *MESH.split()[1:-1], path)[2]
    monkeypatch.setattr("os.access", lambda where, _: False)
    assert "nothing may be written to the folder" in run(capsys, *MESH.split()[1:-1], path)[2]
    assert "too long" in run(capsys, *MESH.split()[1:-1], tmp_path / f"{'a' * 300}.vtu")[2]


def test_an_empty_file_of_tetgen_is_no_endless_search(capsys, tmp_path):
    (tmp_path / "mesh.node").write_text("1 3 0 0\n0 0 0 0\n")
    (tmp_path / "mesh.ele").write_text("# nothing\n")
    status, _, err = run(capsys, "quality", tmp_path / "mesh.ele")
    assert status == 2
    assert "mesh.ele is empty" in err
