"""Meshes handed to other libraries, and back: meshio, PyVista, GUDHI. Each is loaded when it is needed."""

from __future__ import annotations

import re
import warnings
from collections import Counter
from collections.abc import Iterable, Mapping
from importlib import import_module
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidInput
from .mesh import Mesh

KINDS = {2: "triangle", 3: "tetra"}
"""What meshio calls the simplices, by dimension."""
Block = tuple[str, Any, Mapping[str, Any]]
"""Cells of one type as another library has them: what it is called there, the cells, their data."""
INSTALL = {"meshio": "coxeter-triangulations[mesh]"}


def library(name: str) -> Any:
    """A library that need not be there; a refusal says how to install it."""
    try:
        return import_module(name)
    except ImportError as error:
        raise InvalidInput(f"this needs {name}: pip install {INSTALL.get(name, name)}") from error


# -- meshio ----------------------------------------------------------------------------------------------


def to_meshio(mesh: Mesh, pad: bool = False) -> Any:
    """The mesh as a `meshio.Mesh`; its cells are triangles or tetrahedra.

    With `pad`, points of the plane get a third coordinate 0.

    >>> to_meshio(Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])).cells_dict["triangle"].tolist()
    [[0, 1, 2]]
    """
    points, kind = (_in_space(mesh) if pad else mesh.points), _kind(mesh)
    cell_data = {name: [values] for name, values in mesh.cell_data.items()}
    return library("meshio").Mesh(points, [(kind, mesh.cells)], dict(mesh.point_data), cell_data)


def from_meshio(found: Any) -> Mesh:
    """The tetrahedra of a `meshio.Mesh`, or else its triangles; a warning says what is left out.

    Of curved ones, such as tetra10, the corners are taken, and a warning says so.
    """
    data = [{name: blocks[i] for name, blocks in found.cell_data.items()} for i in range(len(found.cells))]
    blocks = [(block.type, block.data, x) for block, x in zip(found.cells, data, strict=True)]
    return _chosen(found.points, blocks, found.point_data)


def _chosen(points: ArrayLike, blocks: Iterable[Block], point_data: Mapping[str, Any]) -> Mesh:
    """The simplices of the largest dimension."""
    full = [block for block in blocks if len(block[1])]
    simplicial = [(d, x) for x in full for d, kind in KINDS.items() if re.fullmatch(rf"{kind}\d*", x[0])]
    if not simplicial:
        others = f"; there are {_counted(full)}" if full else ""
        raise InvalidInput(f"there are no triangles or tetrahedra that can be read{others}")
    d = max(k for k, _ in simplicial)
    chosen = [block for k, block in simplicial if k == d]
    if left := [block for block in full if block[0] not in {kind for kind, _, _ in chosen}]:
        warnings.warn(f"only cells of type {KINDS[d]} were taken; left out: {_counted(left)}", stacklevel=4)
    if curved := [block for block in chosen if block[0] != KINDS[d]]:
        warnings.warn(f"only the corners were taken of {_counted(curved)}", stacklevel=4)
    names = [name for name in chosen[0][2] if all(name in data for _, _, data in chosen)]
    cell_data = {name: np.concatenate([np.asarray(data[name]) for _, _, data in chosen]) for name in names}
    cells = np.concatenate([np.asarray(cells)[:, : d + 1] for _, cells, _ in chosen])  # corners come first
    return Mesh(points, cells, point_data, cell_data)


def _counted(blocks: list[Block]) -> str:
    """How many cells there are of each type."""
    counts: Counter[str] = Counter()
    for kind, cells, _ in blocks:
        counts[kind] += len(cells)
    return ", ".join(f"{n} of type {kind}" for kind, n in counts.items())


def _kind(mesh: Mesh) -> str:
    if mesh.dimension not in KINDS or mesh.points.shape[1] > 3:
        raise InvalidInput(
            f"{mesh}: only triangles and tetrahedra in at most three dimensions can be handed over; "
            "write_mesh keeps any others as .npz"
        )
    return KINDS[mesh.dimension]


def _in_space(mesh: Mesh) -> NDArray[np.float64]:
    """The points with three coordinates."""
    n, m = mesh.points.shape
    return np.hstack([mesh.points, np.zeros((n, 3 - m))])


# -- PyVista ---------------------------------------------------------------------------------------------


def to_pyvista(mesh: Mesh) -> Any:
    """The mesh as a `pyvista.UnstructuredGrid`, with its data."""
    pyvista, kind = library("pyvista"), _kind(mesh)
    code = {"triangle": pyvista.CellType.TRIANGLE, "tetra": pyvista.CellType.TETRA}[kind]
    grid = pyvista.UnstructuredGrid({code: mesh.cells}, _in_space(mesh))
    for name, values in mesh.point_data.items():
        grid.point_data[name] = values
    for name, values in mesh.cell_data.items():
        grid.cell_data[name] = values
    return grid


def from_pyvista(dataset: Any) -> Mesh:
    """The tetrahedra of a PyVista dataset, or else its triangles; warnings as those of `from_meshio`."""
    pyvista = library("pyvista")
    several = isinstance(dataset, pyvista.MultiBlock)  # as the readers of some formats return it
    grid = dataset.combine() if several else dataset.cast_to_unstructured_grid()
    types = pyvista.CellType
    names = {
        int(types.TRIANGLE): "triangle", int(types.QUADRATIC_TRIANGLE): "triangle6",
        int(types.TETRA): "tetra", int(types.QUADRATIC_TETRA): "tetra10",
    }  # fmt: skip
    blocks = []
    for code in np.unique(grid.celltypes).tolist():
        rows = np.flatnonzero(grid.celltypes == code)
        kind = names.get(code, types(code).name.lower())
        cells = grid.cells_dict[code] if code in names else rows
        blocks.append((kind, cells, {name: np.asarray(x)[rows] for name, x in grid.cell_data.items()}))
    return _chosen(grid.points, blocks, {name: np.asarray(x) for name, x in grid.point_data.items()})


# -- GUDHI -----------------------------------------------------------------------------------------------


def to_gudhi(mesh: Mesh, filtration: ArrayLike | None = None) -> Any:
    """The cells and all their faces as a `gudhi.SimplexTree`; vertices are numbered as the points are.

    Parameters
    ----------
    mesh
        Of any dimension.
    filtration
        A number for each point: a face enters with the last of its vertices. By default all enter at 0.

    Examples
    --------
    >>> tree = to_gudhi(Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]), [3, 1, 2])
    >>> tree.num_simplices(), tree.filtration([1, 2])
    (7, 2.0)
    """
    tree = library("gudhi").SimplexTree()
    if filtration is None:
        tree.insert_batch(mesh.cells.T, np.zeros(len(mesh)))
        return tree
    values = np.asarray(filtration, dtype=np.float64)
    if values.shape != (len(mesh.points),) or not np.isfinite(values).all():
        raise InvalidInput(
            f"a filtration of shape {values.shape}: expected a finite number for each of "
            f"{len(mesh.points)} points"
        )
    for size in range(1, mesh.dimension + 2):
        for columns in combinations(range(mesh.dimension + 1), size):
            faces = mesh.cells[:, columns]
            tree.insert_batch(faces.T, values[faces].max(axis=1))
    return tree


def from_gudhi(tree: Any, points: ArrayLike) -> Mesh:
    """The simplices of the largest dimension of a `gudhi.SimplexTree`, whose vertices number points (n, m).

    Raises
    ------
    InvalidInput
        If there are no simplices of a positive dimension, or there are vertices without a point.
    """
    d = tree.dimension()
    if d < 1:
        raise InvalidInput("the simplex tree has no edges: there are no cells in it")
    return Mesh(points, [simplex for simplex, _ in tree.get_simplices() if len(simplex) == d + 1])
