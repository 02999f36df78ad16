"""Grids: locating points, against the exact folding, against definitions, and with bad input."""

from fractions import Fraction

import numpy as np
import pytest
from askew import turned
from hypothesis import given
from hypothesis import strategies as st

from coxeter import triangulation
from coxeter.errors import InvalidInput
from coxeter.location.compiled import kernels
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
    assert kernels is not None, "Numba is in the lock: without it there is only one way to test"
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


@pytest.mark.parametrize("name", ["B~4", "C~4", "D~4", "F~4", "E~8"])
def test_floats_with_huge_denominators_are_decided_exactly(name):
    """A float next to a wall may have a denominator that no machine integer holds."""
    d = int(name[-1])
    points = np.full((2, d), 0.5)
    points[:, 0] += [1, 2]
    points[:, -1] = [2.0**-1000, -5e-324]
    found = Grid(name).locate(points)
    exact = Grid(name).locate(np.vectorize(Fraction, otypes=[object])(points))
    assert (found.keys == exact.keys).all()
    assert not found.open.any()


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("name", ["B~3", "B~6", "B~70", "C~2", "C~5", "C~70", "D~4", "D~7", "D~70"])
def test_where_only_signs_and_sizes_decide_floats_go_where_fractions_go(name, compiled, monkeypatch):
    """On walls and a bit beside them; nothing has to be decided anew, whatever the number of digits."""
    if not compiled:
        monkeypatch.setattr("coxeter.location.compiled.kernels", None)
    walls = np.concatenate([np.arange(-3, 4) / 2, [0.1, -0.1, 1e9 + 0.5, 0.3]])
    values = np.concatenate([walls, np.nextafter(walls, 9e9), np.nextafter(walls, -9e9), [-0.0, 1e-300]])
    points = np.random.default_rng(7).choice(values, (200, int(name[2:])))
    exact = Grid(name).locate(np.vectorize(Fraction, otypes=[object])(points))
    monkeypatch.setattr("coxeter.location.locating.Locator.exact", None)
    found = Grid(name).locate(points)
    assert (found.keys == exact.keys).all()
    assert not found.open.any()
    assert np.abs(found.barycentric - exact.barycentric.astype(float)).max() < 1e-12


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


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("name", ["A~3", "B~3", "E~6", "E~8"])
@pytest.mark.parametrize("scale", [1, 0.5])
@pytest.mark.filterwarnings("error")
def test_what_overflows_on_the_way_is_refused(name, scale, compiled, monkeypatch):
    if not compiled:
        monkeypatch.setattr("coxeter.location.compiled.kernels", None)
    d = int(name[-1])
    for size in (1e13, 1e300, 1.7e308):
        points = np.where(np.arange(d) % 2, size, -size)[None]
        with pytest.raises(InvalidInput, match="in units of the roots"):
            Grid(name, scale=scale).locate(points)


@pytest.mark.parametrize(
    "points",
    [[[1, 2, 3], [4]], np.ma.array([[1.0, 2.0, 3.0]], mask=[[0, 1, 0]]), [["a", "b", "c"]], [[1j, 0, 0]]],
)
def test_what_is_no_array_of_points_is_refused(points):
    with pytest.raises(InvalidInput):
        Grid("A~3").locate(points)


def test_the_row_of_a_bad_point_is_told_in_whichever_chunk_it_is():
    points = np.zeros((100_000, 3))
    points[70_000, 1] = np.nan
    with pytest.raises(InvalidInput, match="row 70000 "):
        Grid("A~3").locate(points)


@pytest.mark.parametrize(
    "settings",
    [
        {"scale": "x"},
        {"scale": None},
        {"scale": 1j},
        {"scale": [1, 2]},
        {"rotation": [[1], [2, 3]]},
        {"rotation": 1j * np.eye(3)},
        {"offset": "abc"},
        {"offset": [1j, 0, 0]},
        {"offset": [[1], [2, 3]]},
        {"offset": np.ma.array([1.0, 2.0, 3.0], mask=[0, 1, 0])},
    ],
)
def test_settings_that_are_no_numbers_are_refused(settings):
    with pytest.raises(InvalidInput):
        Grid("A~3", **settings)


def test_coordinates_of_the_roots_need_a_plain_grid():
    with pytest.raises(InvalidInput, match="in the coordinates of the roots"):
        Grid("A~3", scale=0.5).locate([[1.0, -1.0, 0.0, 0.0]])


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("name", ["B~3", "B~6", "C~2", "C~5", "D~4", "D~7", "F~4", "E~8"])
def test_pixels_are_decided_as_they_are_exactly(name, compiled, monkeypatch):
    """Points of a few binary digits, most of them on walls: what is not rounded needs no second look."""
    if not compiled:
        monkeypatch.setattr("coxeter.location.compiled.kernels", None)
    d = int(name[-1])
    halves = np.random.default_rng(d).integers(-40, 40, size=(300, d))
    for unit in (1, 2, 4, 2**20):
        points = halves / unit
        found = Grid(name).locate(points)
        exact = Grid(name).locate(np.vectorize(Fraction, otypes=[object])(points))
        assert (found.keys == exact.keys).all()
        assert not found.open.any()
        assert np.abs(found.barycentric - exact.barycentric.astype(float)).max() < 1e-12


@pytest.mark.parametrize("name", ["A~3", "A~6", "E~6", "E~7", "G~2"])
def test_coordinates_of_the_roots_on_walls_are_decided_exactly(name):
    """Integer sums of roots lie on walls, where the coordinates in which E~6 sorts are thirds of integers."""
    grid = Grid(name)
    roots = grid.triangulation.roots.simple_roots
    sums = np.random.default_rng(1).integers(-9, 10, (100, grid.dimension)) @ roots.numerators
    exact = grid.locate(np.vectorize(lambda x: Fraction(int(x), roots.denominator), otypes=[object])(sums))
    assert (grid.locate(sums / roots.denominator).keys == exact.keys).all()


def test_no_digit_is_lost_unseen():
    """Where 64-bit floats round what is given, it is refused; and small integers do not overflow."""
    moved = Grid("C~2", offset=[2.0**60, 0])
    for number in (2**60 + 1, 2**53 + 1, -(2**63)):
        with pytest.raises(InvalidInput, match=r"row 1 .* rounded"):
            moved.locate(np.array([[0, 0], [number, 0]]))
    long = np.array([[np.longdouble(1) - np.finfo(np.longdouble).epsneg, 0.25]])
    with pytest.raises(InvalidInput, match=r"row 0 .* rounded"):
        Grid("C~2").locate(long)
    small = np.array([[np.int8(127), Fraction(1, 3)]], dtype=object)
    plain = np.array([[127, Fraction(1, 3)]], dtype=object)
    assert (Grid("C~2").locate(small).keys == Grid("C~2").locate(plain).keys).all()


def test_a_rotation_typed_with_ten_digits_goes_and_comes_back():
    turn = np.round([[np.cos(1), -np.sin(1)], [np.sin(1), np.cos(1)]], 10)
    grid = Grid("C~2", rotation=turn)
    assert np.abs(grid.frame.rotation @ grid.frame.rotation.T - np.eye(2)).max() < 1e-15
    points = np.random.default_rng(3).normal(size=(50, 2)) * 1e5
    found = grid.locate(points)
    assert np.abs(np.einsum("nk,nkj->nj", found.barycentric, found.vertices) - points).max() < 1e-9
    half_turn = -np.eye(2)
    assert (Grid("C~2", rotation=half_turn).frame.rotation == half_turn).all()


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


# -- exact points, however large ----------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["A~3", "B~3", "C~4", "D~4", "E~6", "E~7", "E~8", "F~4", "G~2"])
@pytest.mark.parametrize("power", [60, 200])
def test_huge_exact_points(name, power):
    """Moved by a huge vector of the coroot lattice, everything is as it was."""
    t, grid = triangulation(name), Grid(name)
    weights = t.roots.fundamental_coweights
    rng = np.random.default_rng(5)
    row = rng.integers(1, 50, t.dimension).astype(object) @ weights.numerators.astype(object)
    point = np.array([[Fraction(int(x), 101 * weights.denominator) for x in row]], dtype=object)
    coroot = grid._subgroup.wall(0).reflect(0 * grid._centre, 12)
    shift = np.array([Fraction(int(x) * 2**power, 12) for x in coroot], dtype=object)
    near, far = grid.locate(point), grid.locate(point + shift)
    assert (near.barycentric == far.barycentric).all()
    assert (far.keys == near.keys + shift * grid.key_unit).all()
    assert (grid.corners(far.keys) == grid.corners(near.keys) + shift * grid.vertex_unit).all()
    assert (grid.neighbours(far.keys) == grid.neighbours(near.keys) + shift * grid.key_unit).all()
    moved = grid.frame.outward(shift.astype(np.float64))
    assert np.abs(far.vertices - moved).max() < 1e-9 * np.abs(moved).max()
    if t.dimension < 6:
        assert len(grid.star(far.keys[0], 1)) == len(grid.star(near.keys[0], 1))


def test_fractions_with_huge_denominators(name):
    """Units too large for machine integers, in every step of folding: as the core folds."""
    t, grid = triangulation(name), Grid(name)
    weights = t.roots.fundamental_coweights
    factors = np.random.default_rng(8).integers(-(2**62), 2**62, (6, t.dimension)).astype(object)
    rows = factors @ weights.numerators.astype(object)
    points = np.array([[Fraction(int(x), 3**39 * weights.denominator) for x in row] for row in rows])
    found = grid.locate(points)
    for point, shares in zip(points, found.barycentric, strict=True):
        assert tuple(shares) == t.fold(point).barycentric
    near = np.array([[2.0**-70] * grid.dimension])  # a float so close to a wall is decided as a fraction
    assert np.isclose(grid.locate(near).barycentric.sum(), 1)


def test_keys_may_be_any_integers():
    grid = Grid("B~3")
    keys = grid.locate(some_points("B~3", 5)).keys
    expected = grid.vertices(keys)
    for other in (keys.tolist(), keys.astype(np.int32), keys.astype(object), keys[::-1][::-1]):
        assert (grid.vertices(other) == expected).all()
    assert grid.vertices(np.empty((0, 3), dtype=np.int64)).shape == (0, 4, 3)
    with pytest.raises(InvalidInput, match="rows of 3 integers"):
        grid.vertices(keys * 1.0)
    with pytest.raises(InvalidInput, match="no key"):
        grid.vertices(keys.astype(object) + 2**70 + 1)


def test_many_chunks_of_keys_are_one_answer(monkeypatch):
    grid = Grid("F~4")
    keys = grid.locate(some_points("F~4", 300)).keys
    whole = grid.vertices(keys)
    monkeypatch.setattr("coxeter.location.alcoves.NUMBERS", 64)
    assert (grid.vertices(keys) == whole).all()


def test_the_first_coordinates_fix_the_others(name):
    """Where roots have more than d coordinates; patches tell vertices apart by the first d."""
    simple = triangulation(name).roots.simple_roots
    assert np.linalg.matrix_rank(simple.numerators[:, : triangulation(name).dimension].astype(float)) == len(
        simple.numerators
    )


# -- by the inequalities of the roots -----------------------------------------------------------------------


def test_a_point_lies_between_the_mirrors_of_its_simplex(name):
    """The definition: no mirror <x, r> = k separates a point from the centre of its simplex."""
    t, grid = triangulation(name), Grid(name)
    roots = t.roots.positive_roots.numerators / t.roots.positive_roots.denominator
    for spread in (3.0, 1e6):
        points = some_points(name, 100, spread, seed=6)
        found = grid.locate(points)
        inner = grid.frame.inward(points) @ roots.T
        centres = (found.keys / grid.key_unit) @ roots.T
        low = np.floor(centres)
        assert (centres - low > 1e-9).all()
        assert (inner >= low - 1e-7).all()
        assert (inner <= low + 1 + 1e-7).all()


def test_near_a_wall_on_the_right_side_of_it(name):
    """A little off the middle of a facet the point lies in the simplex, or in the neighbour."""
    grid = Grid(name)
    found = grid.locate(some_points(name, 20, 50.0, seed=7))
    across = grid.neighbours(found.keys)
    for k in range(grid.dimension + 1):
        middle = np.delete(found.vertices, k, axis=1).mean(axis=1)
        way = found.vertices[:, k] - middle
        assert (grid.locate(middle + 1e-9 * way).keys == found.keys).all()
        assert (grid.locate(middle - 1e-9 * way).keys == across[:, k]).all()
