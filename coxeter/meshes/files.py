"""Meshes in files: through meshio in the formats that mesh programs share, or as NPZ in any dimension."""

from __future__ import annotations

import io
import os
import shutil
import warnings
import zipfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidInput
from .interop import from_meshio, library, to_meshio
from .mesh import Mesh


class Format(NamedTuple):
    """What a format can hold, as the tests find by writing and reading.

    Attributes
    ----------
    name
        Meshio's.
    cells
        The dimensions of the cells.
    data
        Which data are kept.
    vectors
        Whether data may have several numbers for a point or a cell.
    narrow
        Whether integers have 32 bits: VTK's reader crashes on a PLY with longer ones.
    flat
        Whether points of the plane stay so; else they get a third coordinate 0.
    options
        What meshio's writer is told.
    buffered
        Whether it is written to memory first: where the disk is full, the HDF5 library may crash.
    mirrored
        Whether its tetrahedra are those of the others in a mirror, which meshio does not know.
    """

    name: str
    cells: tuple[int, ...] = (2, 3)
    data: tuple[str, ...] = ()
    vectors: bool = True
    narrow: bool = False
    flat: bool = False
    options: tuple[tuple[str, Any], ...] = ()
    buffered: bool = False
    mirrored: bool = False


ALL = ("point_data", "cell_data")
NPZ = ".npz"
FORMATS = {
    ".vtu": Format("vtu", data=ALL),
    ".vtk": Format("vtk", data=ALL),
    ".xdmf": Format("xdmf", data=ALL, flat=True, options=(("data_format", "XML"),)),  # else a file beside it
    ".med": Format("med", data=ALL, flat=True, buffered=True, mirrored=True),
    ".msh": Format("gmsh", data=ALL),
    ".off": Format("off", cells=(2,)),
    ".ply": Format("ply", cells=(2,), data=("point_data",), vectors=False, narrow=True),
    ".stl": Format("stl", cells=(2,)),
    ".obj": Format("obj", cells=(2,)),
    ".mesh": Format("medit", flat=True),
    ".meshb": Format("medit", flat=True),
    ".inp": Format("abaqus", flat=True),
    ".avs": Format("avsucd"),
    ".tec": Format("tecplot", data=ALL, vectors=False, flat=True),
    ".vol": Format("netgen", flat=True),
    ".su2": Format("su2", cells=(3,)),
}
"""The formats that are written; all keep points and cells as they are.

CGNS is not among them: VTK cannot read what meshio writes as such.
"""
UNREADABLE = (".svg", ".wkt")
"""Suffixes that meshio knows, and does not read or not in time."""
TETGEN = (".node", ".ele")
"""The two files of which a mesh of TetGen consists."""


# -- reading ---------------------------------------------------------------------------------------------


def read_mesh(path: str | os.PathLike[str]) -> Mesh:
    """The simplices of a mesh file, with their data.

    Of a file with cells of several kinds the tetrahedra are taken, or the triangles if there are none, and of
    curved ones their corners; a warning says what was left out. The arrays of an NPZ file stay on disk until
    they are used.

    Parameters
    ----------
    path
        The file; its suffix says the format: one of `FORMATS`, ``.npz``, or another that meshio reads.

    Raises
    ------
    InvalidInput
        If there is no such file or format, the file cannot be read, or holds no simplices.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     write_mesh(Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]), f"{folder}/one.npz")
    ...     read_mesh(f"{folder}/one.npz")
    Mesh(3 points in R^2, 1 cell of dimension 2)
    """
    path = Path(path)
    if not _asked(path, Path.is_file):
        raise InvalidInput(f"there is no file {path}")
    suffix = _suffix(path)
    if suffix == NPZ:
        return _read_npz(path)
    meshio: Any = library("meshio")
    known = [x for x in meshio.extension_to_filetypes if x not in UNREADABLE]
    if suffix not in known:
        raise InvalidInput(f"{path} has no known suffix: there are {', '.join(sorted([*known, NPZ]))}")
    if suffix in TETGEN:
        _check_tetgen(path)
    with redirect_stdout(io.StringIO()) as said, redirect_stderr(said), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            found = meshio.read(path)
        except (Exception, SystemExit) as error:  # meshio exits where a file is none of its formats
            reason = _reason(error) if isinstance(error, Exception) else " ".join(said.getvalue().split())
            raise InvalidInput(f"{path} cannot be read as {suffix}: {reason}") from error
    try:
        mesh = from_meshio(found)
    except InvalidInput as error:
        raise InvalidInput(f"{path}: {error}") from error
    mesh.cells = _mirrored(mesh, suffix)
    return mesh


def _mirrored(mesh: Mesh, suffix: str) -> NDArray[np.int64]:
    """The cells as a format has them, from ours, and the other way round."""
    mirrored = suffix in FORMATS and FORMATS[suffix].mirrored and mesh.dimension == 3
    return mesh.cells[:, [0, 2, 1, 3]] if mirrored else mesh.cells


def _asked(path: Path, question: Callable[[Path], bool]) -> bool:
    """What the file system says of a path; it may refuse to, as where a folder must not be looked into."""
    try:
        return question(path)
    except OSError as error:
        raise InvalidInput(f"{path} cannot be used: {error.strerror}") from error


def _check_tetgen(path: Path) -> None:
    """Raise `InvalidInput` if one of TetGen's two files has no line, for which meshio would look forever."""
    for part in map(path.with_suffix, TETGEN):
        if _asked(part, Path.is_file) and not any(
            line.strip() and line.strip()[:1] != b"#" for line in part.read_bytes().splitlines()
        ):
            raise InvalidInput(f"{path} cannot be read as {path.suffix}: {part} is empty")


def _reason(error: Exception) -> str:
    """What another library's error says, on one line."""
    return " ".join(f"{type(error).__name__}: {error}".split())


def _suffix(path: Path) -> str:
    """Such as .vtu; or .vol.gz."""
    *_, before, last = ("", "", *path.suffixes)
    return (before + last if last.lower() == ".gz" else last).lower()


def _read_npz(path: Path) -> Mesh:
    try:
        arrays = _mapped(path)
        points, cells = arrays.pop("points"), arrays.pop("cells")
    except KeyError as error:
        raise InvalidInput(f"{path} is no mesh: it has no array {error}") from error
    except (ValueError, OSError, zipfile.BadZipFile) as error:
        raise InvalidInput(f"{path} cannot be read as NPZ: {error}") from error
    data: dict[str, dict[str, NDArray[Any]]] = {"point_data": {}, "cell_data": {}}
    for name, array in arrays.items():
        kind, _, rest = name.partition("/")
        if kind in data:
            data[kind][rest] = array
    try:
        return Mesh(points, cells, **data)
    except InvalidInput as error:
        raise InvalidInput(f"{path} is no mesh: {error}") from error


def _mapped(path: Path) -> dict[str, NDArray[Any]]:
    """The arrays of an NPZ file, mapped into memory where they are not compressed."""
    with zipfile.ZipFile(path) as archive, np.load(path, allow_pickle=False) as loaded:
        infos = {info.filename.removesuffix(".npy"): info for info in archive.infolist()}
        return {name: _map(path, infos[name], loaded) for name in loaded.files}


def _map(path: Path, info: zipfile.ZipInfo, loaded: Any) -> NDArray[Any]:
    array_format = np.lib.format
    with open(path, "rb") as file:
        file.seek(
            info.header_offset + 26
        )  # a local header: 30 bytes, the last four say how long name and rest are
        name, rest = np.frombuffer(file.read(4), "<u2").tolist()
        file.seek(name + rest, os.SEEK_CUR)
        if info.compress_type != zipfile.ZIP_STORED or array_format.read_magic(file) != (1, 0):
            return np.asarray(loaded[info.filename.removesuffix(".npy")])
        shape, by_columns, dtype = array_format.read_array_header_1_0(file)
        if dtype.hasobject:
            raise ValueError("it holds Python objects")
        if 0 in shape:
            return np.empty(shape, dtype)
        return np.memmap(path, dtype, "r", file.tell(), shape, "F" if by_columns else "C")


# -- writing ---------------------------------------------------------------------------------------------


def write_mesh(mesh: Mesh, path: str | os.PathLike[str]) -> None:
    """Write a mesh; the old file stays until the new one is complete.

    A format that does not keep the mesh's data says so by a warning. Points of the plane get a third
    coordinate 0 where a format needs it.

    Parameters
    ----------
    mesh
        Of triangles or tetrahedra in at most three dimensions; for NPZ of any simplices.
    path
        Where; its suffix says the format: ``.npz``, or one of `FORMATS`.

    Raises
    ------
    InvalidInput
        If the suffix is unknown, the format cannot hold the mesh, or the file cannot be written.
    """
    path = Path(os.path.realpath(path))
    check_path(path, mesh.dimension, mesh.points.shape[1])
    suffix = _suffix(path)
    if suffix == NPZ:
        with _replacing(path) as new:
            _write_npz(mesh, new)
        return
    form = FORMATS[suffix]
    kept = {kind: _kept(getattr(mesh, kind), form, kind) for kind in ALL}
    if lost := [name for kind in ALL for name in getattr(mesh, kind) if name not in kept[kind]]:
        warnings.warn(f"{suffix} does not keep {', '.join(lost)}; .vtu would", stacklevel=2)
    full = to_meshio(Mesh(mesh.points, _mirrored(mesh, suffix), **kept), pad=not form.flat)
    meshio: Any = library("meshio")
    with _replacing(path) as new, redirect_stdout(io.StringIO()) as said, redirect_stderr(said):
        target: Any = io.BytesIO() if form.buffered else new
        meshio.write(target, full, file_format=form.name, **dict(form.options))
        if form.buffered:
            new.write_bytes(target.getbuffer())


def check_path(path: str | os.PathLike[str], d: int, m: int | None = None) -> None:
    """Raise `InvalidInput` if no mesh of d-simplices in R^m can be written there."""
    path, m = Path(path), m or d
    suffix = _suffix(path)
    if suffix != NPZ and suffix not in FORMATS:
        raise InvalidInput(f"{path.name!r} has no known suffix: there are {', '.join([*FORMATS, NPZ])}")
    fit = [x for x, form in FORMATS.items() if d in form.cells and d <= m <= 3] + [NPZ]
    if suffix not in fit:
        raise InvalidInput(f"{suffix} holds no {d}-simplices in R^{m}: write {', '.join(fit)}")
    if _asked(path, Path.is_dir):
        raise InvalidInput(f"{path} is a folder: give the name of a file")
    if not (folder := path.resolve().parent).is_dir():
        raise InvalidInput(f"there is no folder {folder} to write {path.name} to")
    if not os.access(folder, os.W_OK | os.X_OK):
        raise InvalidInput(f"nothing may be written to the folder {folder}: give another one")
    if path.exists() and not os.access(path, os.W_OK):
        raise InvalidInput(f"{path} is write-protected: give another name")
    if suffix != NPZ:
        library("meshio")


def _kept(data: dict[str, NDArray[Any]], form: Format, kind: str) -> dict[str, NDArray[Any]]:
    """Those data that a format keeps."""
    return {
        name: _fitted(x, form)
        for name, x in data.items()
        if kind in form.data and x.dtype.kind in "biuf" and (form.vectors or x.ndim == 1)
    }


def _fitted(x: NDArray[Any], form: Format) -> NDArray[Any]:
    """The same as integers of a type that every writer knows, or else as floats."""
    whole = x.astype(np.int32 if form.narrow else np.int64) if x.dtype.kind in "biu" else None
    return whole if whole is not None and np.array_equal(whole, x) else x.astype(np.float64)


def _write_npz(mesh: Mesh, path: Path) -> None:
    arrays = {f"{kind}/{name}": x for kind in ALL for name, x in getattr(mesh, kind).items()}
    for name, array in arrays.items():
        if array.dtype.hasobject:
            raise InvalidInput(f"{name} holds Python objects: NPZ holds numbers and text")
    with open(path, "wb") as file:
        np.savez(file, points=mesh.points, cells=mesh.cells, **arrays)


@contextmanager
def _replacing(path: Path) -> Iterator[Path]:
    """A path to write to, which takes the place of another when all is written, on disk, and only then.

    It lies in a folder of its own beside the other, so that nothing is left of a writer that stops half-way.
    The new file has the permissions of the old one.
    """
    try:
        with TemporaryDirectory(prefix=".coxeter-", dir=path.parent) as folder:
            new = Path(folder) / path.name
            yield new
            with open(new, "rb+") as file:
                os.fsync(file.fileno())
            if path.exists():
                shutil.copymode(path, new)
            os.replace(new, path)
    except InvalidInput:
        raise
    except Exception as error:
        raise InvalidInput(f"{path} cannot be written: {_reason(error)}") from error
