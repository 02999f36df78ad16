"""Grids: locating points, against the exact folding, against definitions, and with bad input."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from coxeter import triangulation
from coxeter.errors import InvalidInput
from coxeter.location.grid import Grid

NAMES = [
    "A~2",
    "A~3",
    "A~5",
    "A~12",
    "B~3",
    "B~4",
    "B~7",
    "B~12",
    "C~2",
    "C~3",
    "C~6",
    "C~12",
    "D~4",
    "D~5",
    "D~8",
    "D~12",
    "E~6",
    "E~7",
    "E~8",
    "F~4",
    "G~2",
]


@pytest.fixture(params=NAMES)
def name(request):
    return request.param


def some_points(name, n=200, spread=6.0, seed=0):
    return np.random.default_rng(seed).normal(size=(n, triangulation(name).dimension)) * spread


def turned(name):
    rng = np.random.default_rng(1)
    d = triangulation(name).dimension
    q, _ = np.linalg.qr(rng.normal(size=(d, d)))
    return Grid(name, scale=0.37, rotation=q, offset=rng.normal(size=d))


@pytest.mark.parametrize("make", [Grid, turned])
def test_a_point_is_the_mean_of_its_simplex(name, make):
    grid, points = make(name), some_points(name)
    found = grid.locate(points)
    assert (found.barycentric >= 0).all()
    assert np.allclose(found.barycentric.sum(axis=1), 1, rtol=0, atol=1e-12)
    mean = np.einsum("nk,nkd->nd", found.barycentric, found.vertices)
    assert np.abs(mean - points).max() < 1e-10
    assert not found.open.any()


def test_compiled_or_not_the_answer_is_the_same(name, monkeypatch):
    pytest.importorskip("numba", reason="without Numba there is only one way")
    grid, points = Grid(name), some_points(name, 2000, 30.0)
    a = grid.locate(points)
    monkeypatch.setattr("coxeter.location.compiled.kernels", None)
    b = grid.locate(points)
    assert (a.keys == b.keys).all()
    assert (a.open == b.open).all()
    assert np.abs(a.barycentric - b.barycentric).max() < 1e-14


def test_exactly_as_the_triangulation_folds(name):
    """Exact points of the span, among them many on walls: barycentric coordinates by the core, one by one."""
    t, grid = triangulation(name), Grid(name)
    rng = np.random.default_rng(2)
    coweights = t.roots.fundamental_coweights
    for denominator in (1, 2, 3, 8):
        factors = rng.integers(-20, 20, (8, t.dimension)).astype(object)
        rows = factors @ coweights.numerators.astype(object)
        unit = coweights.denominator * denominator
        points = np.array([[Fraction(int(x), unit) for x in row] for row in rows], dtype=object)
        found = grid.locate(points)
        for point, shares in zip(points, found.barycentric, strict=True):
            assert tuple(shares) == t.fold(point).barycentric
        corners = grid.corners(found.keys)
        unit = grid.vertex_unit
        for point, shares, simplex in zip(points, found.barycentric, corners, strict=True):
            mean = [
                sum(s * Fraction(int(v), unit) for s, v in zip(shares, column, strict=True))
                for column in simplex.T
            ]
            assert mean == list(point)


def test_corners_are_images_of_the_vertices_with_their_labels(name):
    t, grid = triangulation(name), Grid(name)
    keys = grid.locate(some_points(name, 4)).keys
    for simplex in grid.corners(keys):
        for label, corner in enumerate(simplex):
            image = t.fold([Fraction(int(x), grid.vertex_unit) for x in corner])
            assert image.barycentric[label] == 1


def test_keys_are_equal_exactly_when_simplices_are(name):
    grid = Grid(name)
    points = some_points(name, 1, 9.0) + np.random.default_rng(3).normal(size=(600, grid.dimension)) * 0.05
    keys = grid.locate(points).keys
    corners = [tuple(map(tuple, simplex)) for simplex in grid.corners(keys).tolist()]
    pairs = set(zip(map(tuple, keys.tolist()), corners, strict=True))
    assert len(pairs) == len({key for key, _ in pairs}) == len({simplex for _, simplex in pairs})


def test_neighbours_share_a_facet_and_lead_back(name):
    grid = Grid(name)
    keys = grid.locate(some_points(name, 10)).keys
    around, corners = grid.neighbours(keys), grid.corners(keys)
    for k in range(grid.dimension + 1):
        theirs = grid.corners(around[:, k])
        others = [j for j in range(grid.dimension + 1) if j != k]
        assert (theirs[:, others] == corners[:, others]).all()
        assert (theirs[:, k] != corners[:, k]).any(axis=1).all()
        assert (grid.neighbours(around[:, k])[:, k] == keys).all()


@pytest.mark.parametrize("name", ["A~2", "C~2", "G~2", "A~3", "B~3", "C~3", "D~4", "F~4"])
def test_the_star_of_a_special_vertex_is_the_weyl_group(name):
    grid = Grid(name)
    key = grid.locate(some_points(name, 1)).keys[0]
    star = grid.star(key, 0)
    assert len(star) == triangulation(name).roots.weyl_group_order
    corners = grid.corners(star)
    assert (corners[:, 0] == corners[0, 0]).all()


@given(st.lists(st.integers(-64, 64), min_size=4, max_size=4), st.sampled_from(["B~4", "C~4", "D~4", "F~4"]))
def test_floats_on_walls_are_decided_exactly(numerators, name):
    point = [Fraction(n, 16) for n in numerators]
    exact = Grid(name).locate(np.array([point], dtype=object))
    found = Grid(name).locate(np.array([[float(x) for x in point]]))
    assert (found.keys == exact.keys).all()
    assert not found.open.any()


def test_what_rounding_leaves_open_is_told():
    """The origin is a vertex, but in the plane's own coordinates of A~2 no neighbour of it is exact."""
    found = Grid("A~2").locate([[0.0, 0.0], [0.3, 0.2]])
    assert found.open.tolist() == [True, False]


def test_the_same_whatever_the_array():
    grid, points = Grid("D~5"), some_points("D~5", 50)
    keys = grid.locate(points).keys
    locked = points.copy()
    locked.setflags(write=False)
    for other in (locked, points.tolist(), np.asfortranarray(points), points[::-1][::-1]):
        assert (grid.locate(other).keys == keys).all()
    assert len(grid.locate(np.empty((0, 5)))) == len(grid.locate([])) == 0
    assert grid.locate(np.float32(points)).keys.shape == keys.shape


def test_many_chunks_are_one_answer(monkeypatch):
    grid, points = Grid("B~4"), some_points("B~4", 1000)
    whole = grid.locate(points).keys
    monkeypatch.setattr("coxeter.location.grid.NUMBERS", 64)
    assert (grid.locate(points).keys == whole).all()


@pytest.mark.parametrize(
    ("points", "told"),
    [
        ([[0.0, float("nan"), 0.0]], "row 0 .* finite"),
        ([[0.0, 0.0, 0.0], [float("inf"), 0, 0]], "row 1 .* finite"),
        ([0.0, 0.0, 0.0], "expected"),
        ([[0.0, 0.0]], "expected"),
        ([[1e13, 0.0, 0.0]], "do not tell simplices apart"),
        ([["a", "b", "c"]], "floats, integers or fractions"),
        ([[1j, 0, 0]], "floats, integers or fractions"),
        ([[True, False, True]], "floats, integers or fractions"),
        (np.array([[Fraction(1), 0.5, 0]], dtype=object), "0.5 is neither"),
    ],
)
def test_bad_points_are_refused(points, told):
    with pytest.raises(InvalidInput, match=told):
        Grid("B~3").locate(points)


@pytest.mark.parametrize(
    "settings",
    [
        {"scale": 0},
        {"scale": -1},
        {"scale": float("nan")},
        {"rotation": np.ones((3, 3))},
        {"rotation": np.eye(2)},
        {"offset": [0, 0]},
        {"offset": [0, 0, float("inf")]},
    ],
)
def test_bad_settings_are_refused(settings):
    with pytest.raises(InvalidInput):
        Grid("B~3", **settings)


def test_points_outside_the_span_are_refused():
    with pytest.raises(InvalidInput, match="span"):
        Grid("A~3").locate([[1.0, 0.0, 0.0, 0.0]])
    with pytest.raises(InvalidInput, match="span"):
        Grid("G~2").locate(np.array([[1, 0, 0]], dtype=object))


def test_no_key_is_made_up():
    grid = Grid("C~3")
    with pytest.raises(InvalidInput, match="no key"):
        grid.vertices(np.array([[1, 2, 3]]))
    with pytest.raises(InvalidInput, match="rows of 3"):
        grid.vertices(np.array([[1, 2]]))


def test_exact_points_need_a_plain_grid():
    with pytest.raises(InvalidInput, match="coordinates of the roots"):
        Grid("B~3", scale=2).locate(np.array([[Fraction(1, 2), 0, 0]], dtype=object))


def test_very_large_dimension():
    for name in ("A~1000", "C~1000"):
        grid = Grid(name)
        found = grid.locate(np.random.default_rng(4).normal(size=(3, 1000)))
        assert np.allclose(found.barycentric.sum(axis=1), 1)
