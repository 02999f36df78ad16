"""Properties of what `locate` answers: all triangulations up to d = 12, wherever they lie."""

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coxeter import triangulation
from coxeter.location.cells import ROUTES, cells_of
from coxeter.location.grid import Grid
from coxeter.location.sorting import sort_parts
from coxeter.location.subgroups import subgroup
from coxeter.names import triangulations_up_to

NAMES = [kind.affine for kind in triangulations_up_to(12)]
EXCEPTIONAL = sorted(ROUTES)
FAR = 1e9
"""In units of the roots; there floats are 2^-23 apart, and coordinates are told to within a few of that."""


@pytest.fixture(params=NAMES)
def name(request):
    return request.param


@pytest.fixture(params=["Numba", "NumPy"])
def library(request, monkeypatch):
    if request.param == "NumPy":
        monkeypatch.setattr("coxeter.location.compiled.kernels", None)


def laid(name, rng):
    """A grid with a random scale, rotation and offset."""
    d = triangulation(name).dimension
    rotation, _ = np.linalg.qr(rng.normal(size=(d, d)))
    return Grid(name, scale=10 ** rng.uniform(-3, 3), rotation=rotation, offset=rng.normal(size=d))


def roots_of(name):
    return triangulation(name).roots.positive_roots


def check(grid, points, far=0.0):
    """Barycentric coordinates, the mean of the vertices, and no mirror between a point and its key."""
    found, near = grid.locate(points), 1e-9 + 1e-14 * far
    assert (found.barycentric >= 0).all()
    assert np.abs(found.barycentric.sum(axis=1) - 1).max() < 1e-12
    mean = np.einsum("nk,nkd->nd", found.barycentric, found.vertices)
    assert np.abs(mean - points).max() < near * grid.frame.scale
    roots = roots_of(grid.triangulation.name)
    inner = grid.frame.inward(points) @ roots.numerators.T / roots.denominator
    centres = found.keys @ roots.numerators.T / (roots.denominator * grid.key_unit)
    low = np.floor(centres)
    assert (centres - low > 1e-3).all()
    assert (inner > low - near).all()
    assert (inner < low + 1 + near).all()
    return found


@pytest.mark.usefixtures("library")
def test_a_point_lies_in_its_simplex(name):
    rng = np.random.default_rng(len(name) + 11)
    grid = laid(name, rng)
    for far in (0.0, 1e3, FAR):
        around = rng.normal(size=grid.dimension)
        points = rng.normal(size=(60, grid.dimension)) * 3 + around / np.linalg.norm(around) * far
        found = check(grid, points * grid.frame.scale, far)
        assert not found.open.any() or far == FAR


@settings(max_examples=40, deadline=None)
@given(st.sampled_from(NAMES), st.integers(0, 2**32), st.floats(0, 9).map(lambda x: 10**x - 1))
def test_a_point_lies_in_its_simplex_wherever_that_is(name, seed, far):
    rng = np.random.default_rng(seed)
    grid = laid(name, rng)
    check(grid, (rng.normal(size=(20, grid.dimension)) + rng.choice([-far, far])) * grid.frame.scale, 9 * far)


def test_keys_are_equal_exactly_when_simplices_are(name):
    """Most of many points in a few simplices: as many keys as sets of vertices."""
    rng = np.random.default_rng(5)
    grid = laid(name, rng)
    spread = rng.normal(size=(300, grid.dimension)) * 0.1 / grid.dimension
    found = grid.locate((spread + rng.normal(size=grid.dimension) * 9) * grid.frame.scale)
    simplices = [tuple(map(tuple, corners)) for corners in grid.corners(found.keys).tolist()]
    pairs = set(zip(map(tuple, found.keys.tolist()), simplices, strict=True))
    assert 1 < len(pairs) < 300
    assert len(pairs) == len({key for key, _ in pairs}) == len({frozenset(corners) for _, corners in pairs})


def test_by_the_inequalities_of_the_roots_exactly(name):
    """Fractions, many of them on walls, near the origin and 10^9 away: k <= <x, r> <= k + 1 for each root."""
    t, grid, rng = triangulation(name), Grid(name), np.random.default_rng(6)
    weights, roots = t.roots.fundamental_coweights, roots_of(name)
    for far, denominator in ((0, 1), (0, 6), (10**9, 4), (10**9, 10**9)):
        factors = far + rng.integers(-9 * denominator, 9 * denominator, (9, t.dimension)).astype(object)
        rows = factors @ weights.numerators.astype(object)
        points = np.vectorize(Fraction, otypes=[object])(rows, weights.denominator * denominator)
        found = grid.locate(points)
        inner = points @ roots.numerators.T.astype(object)
        centres = found.keys.astype(object) @ roots.numerators.T.astype(object)
        low, below = centres // (roots.denominator * grid.key_unit), roots.denominator
        assert (centres != low * (below * grid.key_unit)).all()
        assert (low * below <= inner).all()
        assert (inner <= (low + 1) * below).all()
        assert (found.barycentric.sum(axis=1) == 1).all()
        assert (found.barycentric >= 0).all()


@pytest.mark.usefixtures("library")
@pytest.mark.parametrize("name", [n for n in NAMES if Grid(n).frame.standard])
def test_what_is_not_open_is_as_fractions_say(name):
    """Where the coordinates are those of the roots, floats far away or next to a wall are decided exactly."""
    grid, rng = Grid(name), np.random.default_rng(7)
    found = grid.locate(rng.normal(size=(6, grid.dimension)) * 9)
    facets = [np.delete(found.vertices, k, axis=1) for k in range(grid.dimension + 1)]
    on = np.concatenate(facets).mean(axis=1)
    for points in (on, on + 1e-15, on + FAR, rng.normal(size=(20, grid.dimension)) * FAR):
        floats = grid.locate(points)
        exact = grid.locate(np.vectorize(Fraction, otypes=[object])(points))
        assert (floats.keys == exact.keys).all()
        assert not floats.open.any()


@pytest.mark.usefixtures("library")
def test_beside_a_wall_on_the_right_side_or_told_to_be_open(name):
    """Off the middle of a facet by 10^-9; and by less than floats tell, where the grid lies far away."""
    rng = np.random.default_rng(8)
    grid = laid(name, rng)
    for far, off in ((0.0, 1e-9), (FAR, 1e-9), (FAR, 1e-3)):
        found = grid.locate((rng.normal(size=(5, grid.dimension)) + far) * grid.frame.scale)
        across = grid.neighbours(found.keys)
        for k in range(grid.dimension + 1):
            middle = np.delete(found.vertices, k, axis=1).mean(axis=1)
            way = off * (found.vertices[:, k] - middle)
            for points, keys in ((middle + way, found.keys), (middle - way, across[:, k])):
                again = grid.locate(points)
                assert ((again.keys == keys).all(axis=1) | again.open).all()
                assert not again.open.any() or far == FAR


# -- the exceptional types ----------------------------------------------------------------------------------


def in_simplex(name, n):
    """Points of the subgroup's simplex, as columns."""
    group = subgroup(triangulation(name))
    return sort_parts(group, np.random.default_rng(9).normal(size=(group.width, n)) * 9, 1.0)[0]


@pytest.mark.parametrize(("name", "count"), [("E~8", 270), ("E~7", 126), ("E~6", 72), ("F~4", 3), ("G~2", 2)])
def test_every_cell_is_led_to_the_goal(name, count):
    """As many ways as there are cells: |W| / |W'| times the index of the coroot lattices."""
    cells = cells_of(subgroup(triangulation(name)))
    levels, codes = cells.fold(in_simplex(name, 20_000), 1.0)
    assert levels.min() > -1e-12
    assert len(np.unique(codes)) == count


@pytest.mark.parametrize("name", EXCEPTIONAL)
def test_no_reflection_is_idle(name):
    cells, x = cells_of(subgroup(triangulation(name))), in_simplex(name, 20_000)
    for step in range(len(cells.mirrors)):
        fewer = replace(cells, mirrors=cells.mirrors[:step] + cells.mirrors[step + 1 :])
        assert fewer.fold(x, 1.0)[0].min() < -1e-3


@pytest.mark.parametrize("name", EXCEPTIONAL)
def test_on_walls_the_cell_towards_the_goal(name):
    """The rule that is stated: x goes where x + ε (c - x) goes. Exactly, for corners and middles of edges."""
    cells = cells_of(subgroup(triangulation(name)))
    _, codes = cells.fold(in_simplex(name, 20_000), 1.0)
    labels, unit = np.eye(len(cells.marks), dtype=np.int64) * 1000 * cells.marks.prod() * 24, 1000
    unit *= int(cells.marks.prod()) * 24
    pairs = (labels[:, None] + labels)[np.triu_indices(len(labels))] // 2
    x = cells.images(np.unique(codes), pairs, unit).reshape(-1, cells.corners.shape[1]).T
    centre = cells.marks @ cells.corners * unit // (cells.marks.sum() * cells.unit)
    levels, codes = cells.fold(x, unit)
    assert levels.min() == 0
    moved, others = cells.fold(x + (centre[:, None] - x) // 1000, unit)
    assert (codes == others).all()
    assert moved.min() > 0
