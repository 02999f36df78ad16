"""Meshes in files and in other libraries: there and back, opened by others, interrupted, refused."""

import sys
import warnings
from itertools import combinations

import meshio
import numpy as np
import pytest
from scipy.spatial import Delaunay

from coxeter.errors import InvalidInput
from coxeter.meshes import (
    Mesh,
    Simplices,
    from_gudhi,
    from_meshio,
    from_pyvista,
    mesh_qualities,
    quality_report,
    read_mesh,
    to_gudhi,
    to_meshio,
    to_pyvista,
    write_mesh,
)
from coxeter.meshes.files import FORMATS, NPZ
from coxeter.meshes.interop import KINDS


def some_mesh(d=3, m=3, n=60):
    rng = np.random.default_rng(d + m)
    points = rng.normal(size=(n, m)) * 100 + 1000
    cells = Delaunay(points[:, :d]).simplices.astype(np.int64)
    k = len(cells)
    return Mesh(
        points,
        cells,
        {"label": np.arange(n) % 4, "way": rng.normal(size=(n, 3))},
        {"quality": rng.normal(size=k), "number": np.arange(k)},
    )


def written(mesh, path):
    """What is read of a mesh that was written; beside the file nothing may lie."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        write_mesh(mesh, path)
    assert [x.name for x in path.parent.iterdir()] == [path.name]
    return read_mesh(path)


def padded(points):
    return np.hstack([points, np.zeros((len(points), 3 - points.shape[1]))])


CASES = [(suffix, d, m) for suffix, form in FORMATS.items() for d in form.cells for m in range(d, 4)]


@pytest.mark.parametrize(("suffix", "d", "m"), CASES)
def test_there_and_back(tmp_path, suffix, d, m):
    mesh, form = some_mesh(d, m), FORMATS[suffix]
    found = written(mesh, tmp_path / f"mesh{suffix}")
    expected = mesh.points if form.flat else padded(mesh.points)
    if suffix == ".stl":  # it has triangles, not points: these are found again, in another order
        assert np.array_equal(found.corners, expected[mesh.cells])
    else:
        assert np.array_equal(found.points, expected)
        assert np.array_equal(found.cells, mesh.cells)
    for kind in ("point_data", "cell_data"):
        for name, values in getattr(mesh, kind).items():
            if kind in form.data and (form.vectors or values.ndim == 1):
                assert np.allclose(getattr(found, kind)[name], values, rtol=1e-12, atol=0), name
            else:
                assert name not in getattr(found, kind)


@pytest.mark.parametrize(("d", "m"), [(1, 1), (2, 2), (2, 3), (3, 3), (4, 4), (7, 9)])
def test_npz_keeps_any_mesh_and_maps_it(tmp_path, d, m):
    mesh = (
        some_mesh(d, m, 20)
        if d in (2, 3)
        else Mesh(np.random.default_rng(0).normal(size=(20, m)), [range(d + 1)])
    )
    found = written(mesh, tmp_path / "mesh.npz")
    assert isinstance(found.points.base, np.memmap)
    for name in ("points", "cells"):
        assert np.array_equal(getattr(found, name), getattr(mesh, name))
    for kind in ("point_data", "cell_data"):
        assert {x: y.tolist() for x, y in getattr(found, kind).items()} == {
            x: y.tolist() for x, y in getattr(mesh, kind).items()
        }
    np.savez_compressed(tmp_path / "small.npz", points=mesh.points, cells=mesh.cells)
    assert np.array_equal(read_mesh(tmp_path / "small.npz").cells, mesh.cells)


def test_data_that_a_format_does_not_keep_are_named(tmp_path):
    with pytest.warns(UserWarning, match="does not keep way, quality, number"):
        write_mesh(some_mesh(2, 3), tmp_path / "mesh.ply")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        write_mesh(some_mesh(), tmp_path / "mesh.vtu")


# -- opened by others ------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".vtu", ".vtk", ".ply", ".stl", ".obj"])
def test_vtk_reads_it(tmp_path, suffix):
    import pyvista

    mesh, path = some_mesh(2, 3), tmp_path / f"mesh{suffix}"
    written(mesh, path)
    found = pyvista.read(path)
    assert found.n_cells == len(mesh)
    areas = found.compute_cell_sizes().cell_data["Area"]
    tolerance = 1e-12 if suffix in (".vtu", ".vtk") else 1e-3  # else VTK keeps points in single precision
    assert np.allclose(areas, Simplices(mesh.corners).volume, rtol=tolerance)
    if suffix == ".vtu":
        assert np.array_equal(found.point_data["label"], mesh.point_data["label"])
        assert np.array_equal(found.cell_data["quality"], mesh.cell_data["quality"])


@pytest.mark.parametrize("suffix", [".vtu", ".vtk", ".xdmf", ".med", ".msh", ".ply", ".tec"])
@pytest.mark.parametrize("values", [[True, False, True], [1, 2, 2**40], ["a", "b", "c"], [0.5, 1, 2]])
def test_data_of_any_type_are_kept_or_named(tmp_path, suffix, values):
    mesh = Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [[0, 1, 2]], {"mine": values})
    with warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        write_mesh(mesh, tmp_path / f"mesh{suffix}")
    found = read_mesh(tmp_path / f"mesh{suffix}").point_data
    assert np.array_equal(found["mine"], values) if "mine" in found else "mine" in str(notes[0].message)
    assert ("mine" in found) == (values[0] != "a")


def test_gudhi_reads_off(tmp_path):
    import gudhi

    mesh = some_mesh(2, 3)
    written(mesh, tmp_path / "mesh.off")
    points = gudhi.read_points_from_off_file(off_file=str(tmp_path / "mesh.off"))
    assert np.allclose(points, mesh.points, rtol=1e-12)


def test_h5py_reads_med(tmp_path):
    import h5py

    mesh = some_mesh()
    written(mesh, tmp_path / "mesh.med")
    with h5py.File(tmp_path / "mesh.med") as file:
        found = []
        file.visititems(
            lambda name, x: found.append((name, x)) if name.endswith(("COO", "TE4/NOD")) else None
        )
        arrays = {name.rsplit("/", 1)[1]: x[:] for name, x in found}
    assert np.array_equal(arrays["COO"].reshape(3, -1).T, mesh.points)
    assert np.array_equal(arrays["NOD"].reshape(4, -1).T, mesh.cells[:, [0, 2, 1, 3]] + 1)  # as Salome orders
    assert np.array_equal(read_mesh(tmp_path / "mesh.med").cells, mesh.cells)


# -- interrupted -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "error", [KeyboardInterrupt, OSError(28, "No space left on device"), RuntimeError("no")]
)
@pytest.mark.parametrize("suffix", [".vtu", ".xdmf", NPZ])
@pytest.mark.parametrize("old", [True, False])
def test_an_interrupted_export_leaves_the_old_file_or_none(tmp_path, monkeypatch, error, suffix, old):
    path = tmp_path / f"mesh{suffix}"
    if old:
        path.write_text("the old file")

    def half(file, *_, **__):
        if hasattr(file, "write"):
            file.write(b"half of it")
        else:
            file.write_text("half of it")
            file.with_suffix(".h5").write_text("and of its companion")
        raise error

    monkeypatch.setattr("meshio.write", half)
    monkeypatch.setattr("numpy.savez", half)
    with pytest.raises(KeyboardInterrupt if error is KeyboardInterrupt else InvalidInput):
        write_mesh(Mesh(np.eye(3), [[0, 1, 2]]), path)
    assert [(x.name, x.read_text()) for x in tmp_path.iterdir()] == [(path.name, "the old file")] * old


def test_the_new_file_takes_the_place_of_the_old_one_at_the_end(tmp_path):
    path, link = tmp_path / "mesh.vtu", tmp_path / "link.vtu"
    path.write_text("the old file")
    link.symlink_to(path)
    write_mesh(some_mesh(), link)
    assert link.is_symlink()
    assert np.array_equal(read_mesh(path).points, some_mesh().points)


# -- refused ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("mesh", "name", "words"),
    [
        (some_mesh(), "mesh.stl", "holds no 3-simplices"),
        (Mesh(np.eye(5), [range(5)]), "mesh.vtu", r"write \.npz"),
        (Mesh(np.eye(5), [range(3)]), "mesh.vtu", r"in R\^5: write \.npz"),
        (some_mesh(), "mesh", "no known suffix"),
        (some_mesh(), "mesh.doc", r"\.vtu, \.vtk.*\.npz"),
        (some_mesh(), "nowhere/mesh.vtu", "no folder"),
        (Mesh(np.eye(2), [[0, 1]], {"x": [object(), object()]}), "mesh.npz", "Python objects"),
    ],
)
def test_what_cannot_be_written_is_refused(tmp_path, mesh, name, words):
    with pytest.raises(InvalidInput, match=words):
        write_mesh(mesh, tmp_path / name)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("mesh.vtu", None, "there is no file"),
        ("mesh.doc", b"", "no known suffix"),
        ("mesh.svg", b"<svg/>", "no known suffix"),
        ("mesh.vtu", b"<VTKFile", "cannot be read as .vtu"),
        ("mesh.off", b"OFF\n3 1 0\n0 0", "cannot be read as .off"),
        ("mesh.msh", b"nonsense", "cannot be read as .msh"),
        ("mesh.vtu", b"", "cannot be read as .vtu"),
        ("mesh.npz", b"PK nonsense", "cannot be read as NPZ"),
        ("mesh.npz", b"", "cannot be read as NPZ"),
        ("mesh.off", b"OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "no triangles or tetrahedra"),
        ("mesh.off", b"OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n", "finite"),
        ("mesh.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", "there are 3"),
    ],
)
def test_what_cannot_be_read_is_refused(tmp_path, name, content, words, capsys):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    with pytest.raises(InvalidInput, match=words):
        read_mesh(tmp_path / name)
    assert capsys.readouterr() == ("", "")


def test_an_npz_file_of_something_else_is_refused(tmp_path):
    np.savez(tmp_path / "other.npz", points=np.eye(3))
    with pytest.raises(InvalidInput, match="cells"):
        read_mesh(tmp_path / "other.npz")
    np.savez(tmp_path / "objects.npz", points=np.array([None]), cells=np.eye(3))
    with pytest.raises(InvalidInput, match="object"):
        read_mesh(tmp_path / "objects.npz")


@pytest.mark.parametrize(
    ("call", "library", "words"),
    [
        (lambda mesh, path: write_mesh(mesh, path), "meshio", r"pip install coxeter-triangulations\[mesh\]"),
        (lambda mesh, path: to_pyvista(mesh), "pyvista", "pip install pyvista"),
        (lambda mesh, path: to_gudhi(mesh), "gudhi", "pip install gudhi"),
    ],
)
def test_a_library_that_is_missing_is_named(tmp_path, monkeypatch, call, library, words):
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(InvalidInput, match=words):
        call(some_mesh(), tmp_path / "mesh.vtu")


# -- several kinds of cells ------------------------------------------------------------------------------


def test_of_several_kinds_the_simplices_of_largest_dimension_are_taken(tmp_path):
    points = np.random.default_rng(0).normal(size=(8, 3))
    mixed = [
        ("triangle", [[0, 1, 2]]),
        ("tetra", [[0, 1, 2, 3]]),
        ("quad", [[0, 1, 2, 3]]),
        ("tetra", [[4, 5, 6, 7]]),
    ]
    meshio.write(
        tmp_path / "mixed.vtu", meshio.Mesh(points, mixed, cell_data={"x": [[1.0], [2.0], [3.0], [4.0]]})
    )
    with pytest.warns(UserWarning, match="left out: 1 of type triangle, 1 of type quad"):
        found = read_mesh(tmp_path / "mixed.vtu")
    assert found.cells.tolist() == [[0, 1, 2, 3], [4, 5, 6, 7]]
    assert found.cell_data["x"].tolist() == [2, 4]
    meshio.write(tmp_path / "quads.vtu", meshio.Mesh(points, mixed[2:3]))
    with pytest.raises(InvalidInput, match=r"quads.vtu: there are no triangles .*; there are 1 of type quad"):
        read_mesh(tmp_path / "quads.vtu")


@pytest.mark.parametrize(
    ("kind", "d", "name"), [("tetra", 3, "QUADRATIC_TETRA"), ("triangle", 2, "QUADRATIC_TRIANGLE")]
)
def test_of_curved_simplices_the_corners_are_taken(tmp_path, kind, d, name):
    import pyvista

    corners = some_mesh(d)
    pairs = list(combinations(range(d + 1), 2))
    middles = np.concatenate([corners.points[corners.cells[:, pair]].mean(axis=1) for pair in pairs])
    numbers = len(corners.points) + np.arange(len(middles)).reshape(len(pairs), -1).T
    curved, points = np.hstack([corners.cells, numbers]), np.vstack([corners.points, middles])
    block = (f"{kind}{curved.shape[1]}", curved)
    meshio.write(tmp_path / "curved.vtu", meshio.Mesh(points, [block, (kind, corners.cells[:5])]))
    grid = pyvista.UnstructuredGrid({pyvista.CellType[name]: curved}, points)
    words = f"only the corners were taken of {len(curved)} of type {block[0]}$"
    with pytest.warns(UserWarning, match=words):
        found = read_mesh(tmp_path / "curved.vtu")
    with pytest.warns(UserWarning, match=words):
        assert np.array_equal(from_pyvista(grid).cells, corners.cells)
    assert np.array_equal(found.cells, np.vstack([corners.cells, corners.cells[:5]]))
    assert quality_report(found, ["thickness"]).measures[0].min == mesh_qualities(corners)["thickness"].min()


# -- other libraries -------------------------------------------------------------------------------------


def same(a, b):
    """Whether points, cells and data are."""
    assert np.array_equal(padded(a.points), padded(b.points))
    assert np.array_equal(a.cells, b.cells)
    for kind in ("point_data", "cell_data"):
        x, y = getattr(a, kind), getattr(b, kind)
        assert x.keys() == y.keys()
        assert all(np.array_equal(x[name], y[name]) for name in x)


@pytest.mark.parametrize(("d", "m"), [(2, 2), (2, 3), (3, 3)])
def test_meshio_and_pyvista_there_and_back(d, m):
    mesh = some_mesh(d, m)
    same(from_meshio(to_meshio(mesh)), mesh)
    assert list(to_meshio(mesh).cells_dict) == [KINDS[d]]
    same(from_pyvista(to_pyvista(mesh)), mesh)


def test_a_surface_of_pyvista_and_a_mixed_grid():
    import pyvista

    assert from_pyvista(pyvista.Sphere()).dimension == 2
    with pytest.raises(InvalidInput, match="quad"):
        from_pyvista(pyvista.Plane())
    mixed = pyvista.UnstructuredGrid(
        {pyvista.CellType.TETRA: np.array([[0, 1, 2, 3]]), pyvista.CellType.LINE: np.array([[0, 1]])},
        np.random.default_rng(0).normal(size=(4, 3)),
    )
    with pytest.warns(UserWarning, match="1 of type line"):
        assert len(from_pyvista(mixed)) == 1
    parts = pyvista.MultiBlock([to_pyvista(some_mesh()), to_pyvista(some_mesh())])
    assert len(from_pyvista(parts)) == 2 * len(some_mesh())


def test_verdict_finds_the_same():
    """VTK's library of quality measures; where smaller is better, 1 over ours."""
    points = np.random.default_rng(0).normal(size=(200, 4, 3))
    points[Simplices(points).negative, :2] = points[Simplices(points).negative, 1::-1]
    mesh = Mesh(points.reshape(-1, 3), np.arange(800).reshape(-1, 4))
    ours, grid = mesh_qualities(mesh), to_pyvista(mesh)
    for name, value in {
        "shape": ours["mean_ratio"],
        "condition": 1 / ours["condition"],
        "radius_ratio": 1 / ours["radius_ratio"],
        "aspect_ratio": 1 / ours["inradius_to_longest_edge"],
    }.items():
        assert grid.cell_quality(name)[name] == pytest.approx(value, rel=1e-9), name


@pytest.mark.parametrize("d", [2, 3, 5])
def test_a_simplex_tree_has_all_faces_and_leads_back(d):
    mesh = some_mesh(d, d, 30)
    tree = to_gudhi(mesh)
    assert tree.dimension() == d
    back = from_gudhi(tree, mesh.points)
    assert {frozenset(x) for x in back.cells.tolist()} == {frozenset(x) for x in mesh.cells.tolist()}
    faces = sum((-1) ** (len(simplex) - 1) for simplex, _ in tree.get_simplices())
    assert faces == 1  # a Delaunay triangulation fills a ball


def test_a_face_enters_with_the_last_of_its_vertices():
    mesh = some_mesh(3, 3, 20)
    values = np.random.default_rng(0).normal(size=20)
    tree = to_gudhi(mesh, values)
    assert all(value == max(values[simplex]) for simplex, value in tree.get_simplices())
    for wrong in (values[1:], values * np.nan):
        with pytest.raises(InvalidInput, match="filtration"):
            to_gudhi(mesh, wrong)


def test_what_other_libraries_do_not_have_is_refused():
    four = Mesh(np.eye(5)[:, :4], [range(5)])
    for to in (to_meshio, to_pyvista):
        with pytest.raises(InvalidInput, match="triangles and tetrahedra"):
            to(four)
    import gudhi

    assert to_gudhi(four).num_simplices() == 31
    with pytest.raises(InvalidInput, match="no edges"):
        from_gudhi(gudhi.SimplexTree(), np.eye(2))
    with pytest.raises(InvalidInput, match="name points"):
        from_gudhi(to_gudhi(four), np.eye(4))


def test_a_report_of_a_mapped_file_is_that_of_the_mesh(tmp_path):
    mesh = Mesh(np.random.default_rng(0).normal(size=(9, 4)), [range(5), range(4, 9)])
    write_mesh(mesh, tmp_path / "mesh.npz")
    assert quality_report(read_mesh(tmp_path / "mesh.npz")) == quality_report(mesh)
