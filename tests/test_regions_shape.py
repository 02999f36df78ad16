"""The shape of patches and stars, turned at random: manifolds, Euler characteristics, volumes."""

from itertools import combinations
from math import factorial

import numpy as np
import pytest
from askew import turned
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from coxeter import triangulation
from coxeter.location import Grid

LOW = ["A~2", "A~3", "A~4", "B~3", "B~4", "C~2", "C~3", "C~4", "D~4", "F~4", "G~2"]
HIGH = ["A~5", "A~6", "B~5", "B~6", "C~5", "C~6", "D~5", "D~6", "E~6"]


def at_any_scale(name, seed):
    return turned(name, seed, scale=10.0 ** np.random.default_rng(seed).uniform(-3, 3))


def faces(cells, size):
    """All faces with so many vertices, each once, and how many cells have it."""
    rows = np.concatenate([cells[:, list(which)] for which in combinations(range(cells.shape[1]), size)])
    return np.unique(np.sort(rows, axis=1), axis=0, return_counts=True)


def euler(cells):
    return sum((-1) ** (k - 1) * len(faces(cells, k)[0]) for k in range(1, cells.shape[1] + 1))


def pieces(cells):
    """How many parts there are, if one may go across facets only."""
    rows = np.concatenate([np.delete(np.sort(cells, axis=1), k, axis=1) for k in range(cells.shape[1])])
    facet = np.unique(rows, axis=0, return_inverse=True)[1].reshape(-1)
    owner = np.tile(np.arange(len(cells)), cells.shape[1])
    joined = coo_array((np.ones(len(owner)), (owner, facet)), shape=(len(cells), facet.max() + 1)).tocsr()
    return connected_components(joined @ joined.T)[0]


def volumes(mesh):
    edges = mesh.corners[:, 1:] - mesh.corners[:, :1]
    return np.linalg.det(edges) / factorial(edges.shape[1])


def check(grid, mesh):
    """A pseudo-manifold in one piece without holes, of equal simplices."""
    counts = faces(mesh.cells, grid.dimension)[1]
    assert set(counts.tolist()) <= {1, 2}
    assert pieces(mesh.cells) == 1
    assert euler(mesh.cells) == 1
    expected = float(triangulation(grid.triangulation.name).simplex.volume) * grid.frame.scale**grid.dimension
    size = max(np.abs(mesh.points).max() / grid.frame.scale, 1)
    assert np.allclose(np.abs(volumes(mesh)), expected, rtol=1e-11 * size, atol=0)
    assert (np.bincount(mesh.cells.ravel()) > 0).all()


@pytest.mark.parametrize("name", LOW)
@given(data=st.data())
@settings(max_examples=6, deadline=None)
def test_a_patch_of_a_convex_region_is_a_manifold_without_holes(name, data):
    seed = data.draw(st.integers(0, 10**6))
    grid, rng, d = at_any_scale(name, seed), np.random.default_rng(seed), triangulation(name).dimension
    scale = grid.frame.scale * (4 if d < 4 else 1)
    lower = rng.normal(size=d) * scale
    sizes = np.where(rng.random(d) < 0.4, 0, rng.random(d)) * scale
    check(grid, grid.patch_in_box(lower, lower + sizes))
    check(grid, grid.patch_in_ball(lower, sizes[0] / 2))


@pytest.mark.parametrize("name", HIGH)
def test_in_more_dimensions_too(name):
    grid, d = at_any_scale(name, 1), triangulation(name).dimension
    lower = np.random.default_rng(2).normal(size=d) * grid.frame.scale
    check(grid, grid.patch_in_box(lower, lower + 0.05 * grid.frame.scale))


@pytest.mark.parametrize("name", LOW)
def test_stars_are_balls_and_links_are_spheres(name):
    grid, d = at_any_scale(name, 3), triangulation(name).dimension
    key = grid.locate(np.random.default_rng(4).normal(size=(1, d)) * 9 * grid.frame.scale).keys[0]
    for label in range(d + 1):
        keys = grid.star(key, label)
        assert len(keys) == grid.meeting_at(label)
        mesh = grid.patch(keys)
        check(grid, mesh)
        assert len(np.unique(mesh.cells[:, label])) == 1
        link = np.delete(mesh.cells, label, axis=1)
        assert euler(link) == 1 + (-1) ** (d - 1)
        assert set(faces(link, d - 1)[1].tolist()) == {2}
        assert pieces(link) == 1
        # And the simplices fill the angle round the vertex: what is across from it is the boundary.
        boundary, counts = faces(mesh.cells, d)
        assert (boundary[counts == 1] == np.unique(np.sort(link, axis=1), axis=0)).all()


@pytest.mark.parametrize("name", ["A~3", "C~3", "D~5", "E~6", "E~7"])
def test_a_star_is_closed_under_its_mirrors_and_complete(name):
    """The other route: neighbours of neighbours, all across facets at the vertex, are in the star."""
    grid, d = Grid(name), triangulation(name).dimension
    key = grid.locate(np.random.default_rng(5).normal(size=(1, d)) + 1e6).keys[0]
    label = min(range(d + 1), key=grid.meeting_at)
    star = grid.star(key, label)
    assert star.tolist() == sorted(star.tolist())
    found = set(map(tuple, star.tolist()))
    assert tuple(key.tolist()) in found
    assert len(found) == len(star) == grid.meeting_at(label)
    around = np.delete(grid.neighbours(star), label, axis=1)
    assert set(map(tuple, around.reshape(-1, star.shape[1]).tolist())) == found


def test_oriented_patches_have_positive_volumes():
    for name in ("A~3", "B~4", "G~2"):
        grid = at_any_scale(name, 6)
        mesh = grid.patch_in_ball([0.3] * grid.dimension, 0.4 * grid.frame.scale, oriented=True)
        assert (volumes(mesh) > 0).all()
