"""A~ against GUDHI: the same simplices for the same points."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "benchmarks"))
import gudhi_peer as gudhi

pytestmark = pytest.mark.skipif(bool(gudhi.missing()), reason=f"{gudhi.missing()} not there")
sys.path.pop(0)


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    return gudhi.compiled(tmp_path_factory.mktemp("gudhi"))


@pytest.mark.parametrize("d", [2, 3, 5, 8, 12])
@pytest.mark.parametrize("where", ["here", "far", "near walls"])
def test_the_same_simplices(program, tmp_path, d, where):
    rng = np.random.default_rng(d)
    grid = gudhi.same_grid(program, d, tmp_path)
    points = rng.normal(size=(400, d)) * (1e6 if where == "far" else 10)
    if where == "near walls":  # GUDHI takes what is nearer than 1e-9 to lie on a wall
        shares = rng.dirichlet(np.ones(d + 1), 400)
        shares[np.arange(400), rng.integers(0, d + 1, 400)] = 1e-7
        shares /= shares.sum(axis=1, keepdims=True)
        points = np.einsum("nk,nkd->nd", shares, grid.locate(points).vertices)
    ours, theirs = grid.locate(points), gudhi.vertices(program, points, tmp_path)
    assert not ours.open.any()
    apart = np.linalg.norm(ours.vertices[:, :, None] - theirs[:, None], axis=-1)
    assert apart.min(axis=1).max() < 1e-8 * max(1, np.abs(points).max())
    assert apart.min(axis=2).max() < 1e-8 * max(1, np.abs(points).max())
