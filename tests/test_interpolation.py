"""Interpolation and splatting: affine functions, the adjoint, continuity, and bad input."""

from fractions import Fraction

import numpy as np
import pytest

from coxeter import triangulation
from coxeter.errors import InvalidInput
from coxeter.figures.level_lines import level_lines
from coxeter.location import Grid

NAMES = ["A~2", "A~5", "A~12", "B~3", "B~12", "C~2", "C~7", "D~4", "E~6", "E~7", "E~8", "F~4", "G~2"]


@pytest.fixture(params=NAMES)
def grid(request):
    """A grid that is turned, moved and scaled."""
    rng, d = np.random.default_rng(3), triangulation(request.param).dimension
    q, _ = np.linalg.qr(rng.normal(size=(d, d)))
    return Grid(request.param, scale=0.6, rotation=q, offset=rng.normal(size=d))


@pytest.fixture
def points(grid):
    return np.random.default_rng(4).normal(size=(300, grid.dimension)) * 2


def test_affine_functions_are_reproduced(grid, points):
    matrix = np.random.default_rng(5).normal(size=(grid.dimension, 3))
    assert np.allclose(grid.interpolate(points, lambda x: x @ matrix + 7), points @ matrix + 7, atol=1e-11)
    assert np.allclose(grid.interpolate(points, lambda x: x[:, 0]), points[:, 0], atol=1e-11)
    assert np.allclose(grid.interpolate(points, lambda x: np.ones(len(x))), 1, rtol=0, atol=1e-12)


def test_splatting_is_the_adjoint(grid, points):
    rng = np.random.default_rng(6)
    for shape in ((), (2,)):
        found = grid.interpolation(points)
        f, v = rng.normal(size=(len(found.vertices), *shape)), rng.normal(size=(len(points), *shape))
        assert np.isclose((found.of(f) * v).sum(), (f * found.splat(v)).sum(), rtol=1e-11)
        assert found.of(f).shape == v.shape
        vertices, sums = grid.splat(points, v)
        assert (vertices.keys == found.vertices.keys).all()
        assert (sums == found.splat(v)).all()
        assert np.allclose(sums.sum(axis=0), v.sum(axis=0))  # the shares of a point are 1 together


def test_by_the_definition_point_by_point(grid, points):
    """The other route: vertices and barycentric coordinates of each point, nothing shared."""
    located = grid.locate(points)
    direct = (located.barycentric * np.sin(5 * located.vertices).sum(axis=2)).sum(axis=1)
    assert np.allclose(grid.interpolate(points, lambda x: np.sin(5 * x).sum(axis=1)), direct, atol=1e-10)


def test_continuous_across_walls(grid, points):
    """On both sides of a facet, close to a point of it, the values differ as little as the points do."""
    located = grid.locate(points[:50])
    for k in range(grid.dimension + 1):
        facet = np.delete(located.vertices, k, axis=1)
        middle, corner = facet.mean(axis=1), located.vertices[:, k]
        values = grid.interpolate(
            np.concatenate([middle + e * (corner - middle) for e in (1e-7, -1e-7)]),
            lambda x: np.cos(4 * x).sum(axis=1),
        )
        here, beyond = np.split(values, 2)
        assert np.abs(here - beyond).max() < 1e-4
        keys = [grid.locate(middle + e * (corner - middle)).keys for e in (1e-7, -1e-7)]
        assert (keys[0] != keys[1]).any(axis=1).all()


def test_at_vertices_the_function_itself(grid):
    vertices = grid.vertices_in_ball([0.0] * grid.dimension, 0.4 if grid.dimension < 8 else 0.1)
    if len(vertices):
        values = grid.interpolate(vertices.positions, lambda x: np.exp(x).sum(axis=1))
        assert np.allclose(values, np.exp(vertices.positions).sum(axis=1), atol=1e-9)


def test_vertices_are_named_once_with_their_labels(grid, points):
    vertices = grid.interpolation(points).vertices
    keys = list(map(tuple, vertices.keys.tolist()))
    assert keys == sorted(set(keys))
    shares = grid.locate(vertices.positions).barycentric
    assert (shares[np.arange(len(keys)), vertices.labels] > 1 - 1e-9).all()


def test_the_same_whatever_the_array():
    grid, x = Grid("C~3"), np.random.default_rng(7).normal(size=(60, 3))
    values = grid.interpolate(x, np.sin).tolist()
    locked = x.copy()
    locked.setflags(write=False)
    for other in (locked, x.tolist(), np.asfortranarray(x), np.repeat(x, 2, axis=0)[::2]):
        assert grid.interpolate(other, np.sin).tolist() == values
    assert grid.interpolate([[1, 2, 3]], np.asarray).tolist() == [[1, 2, 3]]
    exact = np.array([[Fraction(1, 3), Fraction(1, 7), Fraction(0)]], dtype=object)
    assert np.allclose(grid.interpolate(exact, np.asarray), [[1 / 3, 1 / 7, 0]])


def test_no_points_give_no_values():
    grid = Grid("A~3")
    found = grid.interpolation(np.empty((0, 3)))
    assert len(found.vertices) == 0
    assert found.of(np.empty(0)).shape == found.splat([]).shape == (0,)


def test_a_function_may_change_what_it_is_given():
    found = Grid("A~3").interpolation(np.random.default_rng(7).normal(size=(9, 3)))
    before = found.vertices.positions.copy()

    def doubled(x):
        x *= 2
        return x

    assert (found.of(doubled) == found.of(2 * before)).all()
    assert (found.vertices.positions == before).all()


def test_dask_arrays_are_interpolated_block_by_block():
    import dask.array as da

    grid, points = Grid("A~3"), np.random.default_rng(8).normal(size=(90, 3))
    lazy = da.from_array(points, chunks=(30, 3))
    with pytest.raises(InvalidInput, match="block by block, with its map_blocks"):
        grid.interpolate(lazy, np.sin)
    blocks = lazy.map_blocks(grid.interpolate, np.sin, meta=points[:0])
    assert np.allclose(blocks.compute(scheduler="synchronous"), grid.interpolate(points, np.sin))


@pytest.mark.parametrize(
    ("f", "told"),
    [
        (lambda x: x[:-1], "a row for each of 3 vertices"),
        (lambda x: 5.0, "a row for each of 3 vertices"),
        ([1, 2, 3, 4], "a row for each of 3 vertices"),
        (["a", "b", "c"], "must be real numbers"),
        (lambda x: np.zeros((3, 1, 1)), "a row for each"),
        ([1j, 2, 3], "must be real numbers"),
    ],
)
def test_bad_values_are_refused(f, told):
    with pytest.raises(InvalidInput, match=told):
        Grid("C~2").interpolate([[0.3, 0.1]], f)


def test_bad_points_and_sums_are_refused():
    grid = Grid("C~2")
    with pytest.raises(InvalidInput, match="finite"):
        grid.interpolate([[0.3, float("nan")]], np.sin)
    with pytest.raises(InvalidInput, match="a row for each of 1 points"):
        grid.splat([[0.3, 0.1]], [1, 2])
    masked = np.ma.masked_array([1.0], [True])
    for values in ([1j], np.array([1j]), masked, [10**400]):
        with pytest.raises(InvalidInput, match="real numbers without a mask, a row for each of 1 points"):
            grid.splat([[0.3, 0.1]], values)
    with pytest.raises(InvalidInput, match="real numbers without a mask, a row for each of 3 vertices"):
        grid.interpolate([[0.3, 0.1]], lambda x: x[:, 0] * 1j)
    with pytest.raises(InvalidInput, match="do not tell simplices apart"):
        grid.splat([[1e13, 0.1]], [1])


def test_level_lines_lie_where_the_interpolated_function_has_the_level():
    grid = Grid("G~2", scale=0.4)

    def f(x):
        return np.sin(2 * x[:, 0]) + x[:, 1] ** 2

    figure = level_lines(grid, f, [0.2, 0.1], 1.1, [0.2, 0.7])
    assert figure.svg.startswith("<svg")
    for level, segments in figure.data.lines.items():
        assert len(segments) > 5
        points = np.concatenate([segments.mean(axis=1), 0.7 * segments[:, 0] + 0.3 * segments[:, 1]])
        assert np.allclose(grid.interpolate(points, f), level, atol=1e-9)
    with pytest.raises(InvalidInput, match="plane"):
        level_lines(Grid("A~3"), f, [0, 0, 0], 1, [0])
