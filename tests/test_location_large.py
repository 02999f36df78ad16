"""More points than memory: in chunks from a file, on Dask arrays; and what grids are sent as."""

import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

from coxeter.errors import InvalidInput
from coxeter.location import Grid

GRIDS = [Grid("A~3"), Grid("E~6", scale=0.5, offset=[0.1] * 6), Grid("D~4", rotation=np.eye(4)[::-1])]


def points_for(grid, n=1000):
    return np.random.default_rng(0).normal(size=(n, grid.dimension)) * 5


@pytest.mark.parametrize("grid", GRIDS, ids=repr)
def test_a_file_is_read_in_chunks(grid, tmp_path):
    points = points_for(grid)
    np.save(tmp_path / "points.npy", points)
    mapped = np.load(tmp_path / "points.npy", mmap_mode="r")
    parts, whole = list(grid.locate_chunks(mapped, chunk=300)), grid.locate(points)
    assert [len(part) for part in parts] == [300, 300, 300, 100]
    assert (np.concatenate([part.keys for part in parts]) == whole.keys).all()
    assert (np.concatenate([part.barycentric for part in parts]) == whole.barycentric).all()


@pytest.mark.parametrize("chunk", [0, -1, 2.5, "2", None])
def test_chunks_are_positive_integers(chunk):
    with pytest.raises(InvalidInput, match="positive integer"):
        Grid("A~2").locate_chunks([[0, 0]], chunk=chunk)


@pytest.mark.parametrize("points", [None, 3.0, [0.0, 0.0]])
def test_chunks_of_what_is_no_array_of_points_are_refused(points):
    with pytest.raises(InvalidInput, match="expected"):
        list(Grid("A~2").locate_chunks(points))


@pytest.mark.parametrize("grid", GRIDS, ids=repr)
def test_a_grid_is_sent_as_what_it_was_made_from(grid):
    points = points_for(grid, 50)
    before = grid.locate(points)
    sent = pickle.dumps(grid)
    assert len(sent) < 1000
    assert (pickle.loads(sent).locate(points).keys == before.keys).all()


@pytest.mark.parametrize("grid", GRIDS, ids=repr)
def test_dask_arrays_are_located_as_they_are(grid):
    import dask.array as da

    points = points_for(grid)
    found, here = grid.locate(da.from_array(points, chunks=(300, 2))), grid.locate(points)
    for name in ("keys", "barycentric", "open"):
        lazy = getattr(found, name)
        assert isinstance(lazy, da.Array)
        assert lazy.shape == getattr(here, name).shape
        assert (lazy.compute(scheduler="synchronous") == getattr(here, name)).all()
    assert found.vertices.shape == here.vertices.shape
    assert (found.vertices.compute(scheduler="synchronous") == here.vertices).all()


def test_two_workers_locate():
    import dask.array as da
    import distributed

    grid = GRIDS[0]
    points = points_for(grid)
    how = {"processes": False, "protocol": "tcp", "dashboard_address": None}
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, **how) as cluster,
        distributed.Client(cluster),
    ):
        keys = grid.locate(da.from_array(points, chunks=(100, 3))).keys.compute()
    assert (keys == grid.locate(points).keys).all()


def test_numba_is_turned_off_as_its_manual_says():
    code = "from coxeter.location import Grid, compiled; assert compiled.kernels is None; print(Grid('A~2'))"
    told = subprocess.check_output([sys.executable, "-c", code], env=os.environ | {"NUMBA_DISABLE_JIT": "1"})
    assert told == b"Grid('A~2')\n"


def test_a_dask_array_of_the_wrong_shape_is_refused():
    import dask.array as da

    with pytest.raises(InvalidInput, match="Dask array"):
        Grid("A~3").locate(da.zeros((5, 2)))
    with pytest.raises(InvalidInput, match="finite"):
        Grid("A~3").locate(da.full((5, 3), np.nan)).keys.compute(scheduler="synchronous")
