"""Many simplices as floats, against the exact core; and reports on meshes, against plain NumPy."""

import tracemalloc
from fractions import Fraction
from itertools import combinations

import numpy as np
import oracle
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import simplices

from coxeter import Simplex, measure, regular_simplex, sqrt, triangulation, triangulations_up_to
from coxeter.errors import DegenerateSimplex, InvalidInput, Unavailable
from coxeter.meshes import Mesh, Simplices, mesh_qualities, quality_report
from coxeter.meshes.simplices import POOR
from coxeter.quality import MEASURES, MESH_MEASURES, find_measure, root

ALL = [*MEASURES, *MESH_MEASURES]
LENGTHS = [
    "volume",
    "longest_edge",
    "shortest_edge",
    "squared_longest_edge",
    "squared_shortest_edge",
    "sum_of_squared_edges",
    "minimal_height",
    "inradius",
    "circumradius",
    "squared_circumradius",
    "sum_of_inverse_squared_heights",
]
ANGLES = ["minimal_dihedral_angle", "maximal_dihedral_angle"]


def floats(points):
    return np.array([[float(x) for x in point] for point in points])


def compare(exact, one):
    """All numbers of an array that holds one simplex, with those of the exact simplex."""
    d = exact.dimension
    assert one.dimension == d
    assert not one.degenerate[0]
    for name in LENGTHS + ANGLES * (d > 1):
        value = float(getattr(exact, name))
        assert getattr(one, name).shape == (1,)
        assert getattr(one, name)[0] == pytest.approx(value, rel=1e-9), name
    assert one.heights[:, 0] == pytest.approx([float(x) for x in exact.heights], rel=1e-9)
    squares = [float(x) for x in exact.squared_heights]
    assert one.squared_heights[:, 0] == pytest.approx(squares, rel=1e-9)
    for i, j in combinations(range(d + 1), 2):
        assert one.dihedral_cosine(i, j)[0] == pytest.approx(float(exact.dihedral_cosine(i, j)), abs=1e-9)
        angle = float(exact.dihedral_angle_in_degrees(i, j))
        assert one.dihedral_angle_in_degrees(i, j)[0] == pytest.approx(angle, rel=1e-9, abs=1e-9)
    if d in (2, 3):
        solid = [float(exact.solid_angle(k)) for k in range(d + 1)]
        assert [one.solid_angle(k)[0] for k in range(d + 1)] == pytest.approx(solid, rel=1e-9)
        assert one.minimal_solid_angle[0] == pytest.approx(min(solid), rel=1e-9)


@pytest.mark.parametrize("kind", triangulations_up_to(8), ids=str)
def test_the_families_as_the_exact_core_has_them(kind):
    exact = triangulation(kind).simplex
    compare(exact, Simplices(floats(exact.vertices)[None]))


@given(simplices(max_dimension=5))
def test_random_simplices_as_the_exact_core_has_them(points):
    exact = Simplex(points)
    one = Simplices(floats(points)[None])
    assert one.error[0] < 1e-9
    compare(exact, one)
    edges = [oracle.minus(u, points[0]) for u in points[1:]]
    assert one.negative[0] == (len(edges) == len(points[0]) and oracle.determinant(edges) < 0)


@given(simplices(min_dimension=2, max_dimension=3))
def test_measures_of_arrays_are_the_exact_ones(points):
    exact, one = Simplex(points), Simplices(floats(points)[None])
    for name, values in mesh_qualities(one).items():
        assert values[0] == pytest.approx(float(find_measure(name).normalized(exact)), rel=1e-9), name
    for name, values in mesh_qualities(one, normalised=False).items():
        assert values[0] == pytest.approx(float(find_measure(name)(exact)), rel=1e-9), name
    assert list(mesh_qualities(one)) == ALL


@given(simplices(min_dimension=2, max_dimension=4), st.integers(0, 55))
def test_the_error_is_no_larger_than_its_bound(points, bits):
    """Simplices are flattened more and more; the floats are taken as exact."""
    flat = floats(points)
    flat[:, 0] = np.ldexp(flat[:, 0], -bits) + flat[:, 1]
    one = Simplices(flat[None])
    try:
        exact = Simplex([[Fraction(x) for x in row] for row in flat.tolist()])
    except DegenerateSimplex:
        assert one.degenerate[0]
        assert np.isnan(one.volume[0])
        return
    assert one.degenerate[0] == (one.error[0] > POOR)
    if not one.degenerate[0]:
        for name in ("volume", "minimal_height", "inradius", "circumradius"):
            off = abs(Fraction(float(getattr(one, name)[0])) / Fraction(float(getattr(exact, name))) - 1)
            assert off <= one.error[0], name


def test_a_sliver_that_squares_would_lose():
    """Four points nearly on a circle: the Gram determinant is below rounding, the height is not."""
    h = 2.0**-30
    corners = [(1, 0, 0), (-1, 0, 0), (0, 1, h), (0, -1, h)]
    exact, one = Simplex([[Fraction(x) for x in p] for p in corners]), Simplices([corners])
    assert one.minimal_height[0] == pytest.approx(float(exact.minimal_height), rel=1e-12)
    assert one.minimal_dihedral_angle[0] == pytest.approx(float(exact.minimal_dihedral_angle), rel=1e-6)


@pytest.mark.parametrize(
    "corners",
    [
        [(0, 0), (1, 1), (2, 2)],
        [(0, 0), (0, 0), (0, 0)],
        [(0.1, 0.1), (0.2, 0.2), (0.7, 0.7)],
        [(1, 1), (1, 1), (0, 5)],
        [(0, 0, 0), (1, 2, 3), (3, 2, 1), (4, 4, 4)],
    ],
)
def test_degenerate_simplices_have_no_numbers(corners):
    d = len(corners) - 1
    both = Simplices([corners, np.eye(d + 1)[:, :d][:, : len(corners[0])]])
    assert both.degenerate.tolist() == [True, False]
    for name in [*LENGTHS, *ANGLES, "minimal_solid_angle"]:
        assert np.isnan(getattr(both, name)).tolist() == [True, False], name
    assert all(np.isnan(values).tolist() == [True, False] for values in mesh_qualities(both).values())


def test_triangles_in_space_are_those_of_the_plane():
    rng = np.random.default_rng(0)
    q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    flat = rng.normal(size=(50, 3, 2))
    turned = np.concatenate([flat, np.zeros((50, 3, 1))], axis=2) @ q + 1
    a, b = mesh_qualities(Simplices(flat)), mesh_qualities(turned)
    assert all(np.allclose(a[name], b[name], rtol=1e-10) for name in a)


@pytest.mark.parametrize("factor", [1e-100, 1e100])
def test_very_small_and_very_large_simplices(factor):
    corners = np.random.default_rng(1).normal(size=(20, 4, 3))
    here, there = mesh_qualities(corners), mesh_qualities(corners * 2.0 ** int(np.log2(factor) / 2))
    assert all(np.allclose(here[name], there[name], rtol=1e-12) for name in here)
    for beyond in (factor, factor**2, factor**3):
        with pytest.raises(InvalidInput, match="scale all"):
            Simplices(corners * beyond)


@pytest.mark.parametrize(
    "corners",
    [
        np.zeros((2, 3)),
        np.zeros((1, 5, 3)),
        np.zeros((1, 1, 3)),
        [[(0, 0), (1, 0), (0, np.nan)]],
        [[(0,), (np.inf,)]],
    ],
)
def test_what_is_no_array_of_simplices_is_refused(corners):
    with pytest.raises(InvalidInput):
        Simplices(corners)


def test_none_at_all():
    report = quality_report(Mesh(np.zeros((0, 3)), np.zeros((0, 4), dtype=int)))
    assert (report.cells, report.degenerate) == (0, 0)
    assert all(x.min is None and x.worst is None and not x.counts for x in report.measures)


# -- measures of one's own -------------------------------------------------------------------------------


def test_a_measure_of_ones_own():
    @measure("in over sum")
    def in_over_sum(simplex):
        return simplex.inradius / sqrt(simplex.sum_of_squared_edges)

    exact = triangulation("B~3").simplex
    one = Simplices(floats(exact.vertices)[None])
    expected = float(in_over_sum.normalized(exact))
    assert mesh_qualities(one)["in over sum"][0] == pytest.approx(expected, rel=1e-12)
    assert mesh_qualities(one, [in_over_sum])["in over sum"][0] == pytest.approx(expected, rel=1e-12)


def test_where_smaller_is_better_the_worst_cell_is_the_largest():
    @measure("long over high", larger_is_better=False)
    def long_over_high(simplex):
        return simplex.longest_edge / simplex.minimal_height

    corners = np.array([[(0, 0), (1, 0), (0, 1)], [(0, 0), (9, 0), (0, 1)], [(0, 0), (2, 0), (0, 1)]])
    for normalised in (True, False):
        report = quality_report(corners, [long_over_high], normalised)
        assert report.measures[0].worst == 1
    assert report.measures[0].max == pytest.approx(82 / 9)


@pytest.mark.parametrize(
    "function",
    [
        lambda simplex: sqrt(min(simplex.squared_heights)),
        lambda simplex: np.min([simplex.squared_edge_lengths[0, 1]]) / simplex.squared_longest_edge,
        lambda simplex: np.max(simplex.squared_heights) / simplex.squared_longest_edge,
        lambda simplex: sqrt(
            simplex.inradius if isinstance(simplex, Simplex) else np.array(simplex.inradius)
        ),
        lambda simplex: simplex.inradius if simplex.maximal_dihedral_angle > 70 else 1,
        lambda simplex: simplex.inradius[0] if hasattr(simplex, "corners") else simplex.inradius,
        lambda simplex: simplex.inradius / (2 if simplex.dimension > 1 else 1) * len(simplex.vertices),
        lambda simplex: simplex.minimal_height * simplex.gram_determinant,
    ],
)
def test_a_measure_that_arrays_cannot_have_is_refused_and_left_out(function):
    measure("mine")(function)
    with pytest.raises(InvalidInput, match="mine"):
        mesh_qualities(np.eye(3)[None], ["mine"])
    report = quality_report(np.eye(3)[None])
    assert "mine" in report.left_out
    assert [x.measure for x in report.measures] == ALL


def test_what_a_simplex_and_an_array_of_them_both_know():
    """Measures as one writes them, with a least, a choice and a constant: one by one, and all at once."""

    def sine(simplex):  # of the angle nearest to 0 or 180 degrees
        cosines = [simplex.dihedral_cosine(i, j) for i, j in combinations(range(simplex.dimension + 1), 2)]
        return root(1 - np.maximum.reduce([x**2 for x in cosines]), 2)

    def mean_angle(simplex):
        pairs = combinations(range(simplex.dimension + 1), 2)
        return sum(simplex.dihedral_angle_in_degrees(i, j) for i, j in pairs) / 6

    def heights(simplex):
        return sum(simplex.heights) / simplex.longest_edge

    def squares(simplex):
        return np.minimum.reduce(list(simplex.squared_heights)) / simplex.squared_circumradius

    def chosen(simplex):
        good = simplex.minimal_dihedral_angle > 50
        return np.where(good, simplex.inradius, simplex.minimal_height) / simplex.circumradius

    functions = (sine, mean_angle, heights, squares, chosen, lambda simplex: simplex.dimension)
    shapes = [triangulation(kind).simplex for kind in ("B~3", "C~3")]
    many = np.array([floats(x.vertices) for x in shapes])
    for i, function in enumerate(functions):
        known = measure(f"number {i}")(function)
        expected = [float(known.normalized(x)) for x in shapes]
        assert mesh_qualities(many, [known])[known.name] == pytest.approx(expected, rel=1e-9)


def test_an_error_that_comes_later_is_told_too():
    @measure("late")
    def late(simplex):
        if isinstance(simplex, Simplices) and len(simplex) > 2:
            raise RuntimeError("too many")
        return simplex.inradius / simplex.circumradius

    with pytest.raises(InvalidInput, match=r"'late' cannot be .* RuntimeError: too many \(.*line"):
        quality_report(np.eye(3)[[[0, 1, 2]] * 3], [late])


def test_a_measure_that_is_wrong_of_arrays_is_found_out():
    @measure("biased")
    def biased(simplex):
        return simplex.minimal_height * (2 if hasattr(simplex, "corners") else 1)

    with pytest.raises(InvalidInput, match="of the same in an array"):
        mesh_qualities(np.eye(3)[None], [biased])


def test_solid_angles_beyond_tetrahedra_are_not_available():
    corners = np.eye(5)[None]
    with pytest.raises(Unavailable, match="4-simplices"):
        mesh_qualities(corners, ["minimal_solid_angle"])
    assert "minimal_solid_angle" not in mesh_qualities(corners)
    assert list(quality_report(corners).left_out) == ["minimal_solid_angle"]


def test_the_regular_simplex_has_1():
    for d in (2, 3, 6):
        exact = floats(regular_simplex(d).vertices)[None]
        assert all(values[0] == pytest.approx(1, rel=1e-12) for values in mesh_qualities(exact).values())


# -- reports ---------------------------------------------------------------------------------------------


def random_mesh(n=1000, d=3, seed=0):
    rng = np.random.default_rng(seed)
    cells = rng.integers(0, 100, size=(n, d + 1))
    cells[::97] = 5  # degenerate
    return Mesh(rng.normal(size=(100, d)), cells)


@pytest.mark.parametrize("chunk", [1, 7, 1000, 10**6])
def test_a_report_is_what_numpy_says(chunk):
    mesh = random_mesh(200 if chunk == 1 else 1000)
    values = mesh_qualities(mesh)
    report = quality_report(mesh, bins=6, chunk=chunk)
    flat = np.flatnonzero(Simplices(mesh.corners).degenerate)
    assert report.cells == len(mesh)
    assert report.degenerate == len(flat)
    assert report.degenerate_cells == flat[:10].tolist()
    assert {0, 97} <= set(flat.tolist())
    for x in report.measures:
        known = values[x.measure][~np.isnan(values[x.measure])]
        assert x.undefined == 0
        assert (x.min, x.max) == (known.min(), known.max())
        assert x.worst == np.nanargmin(values[x.measure])
        assert x.mean == pytest.approx(known.mean(), rel=1e-12)
        assert x.median == x.quantiles["0.5"]
        for share, value in x.quantiles.items():
            exact = np.quantile(known, float(share), method="inverted_cdf")
            assert value == pytest.approx(exact, rel=2.0**-13)
        assert np.allclose(x.edges, np.linspace(0, 1, 7))
        assert sum(x.counts) == len(known)
        assert np.abs(np.array(x.counts) - np.histogram(known, 6, (0, 1))[0]).max() <= 1


@pytest.mark.parametrize(("d", "m"), [(2, 2), (3, 3), (4, 4), (2, 3)])
@pytest.mark.parametrize("at_once", [7, 10**6])
def test_inverted_and_doubled_cells_are_counted_and_named(monkeypatch, d, m, at_once):
    monkeypatch.setattr("coxeter.meshes.doubles.AT_ONCE", at_once)
    rng = np.random.default_rng(d)
    points, cells = rng.normal(size=(8, m)), rng.integers(0, 8, size=(300, d + 1))
    report = quality_report(Mesh(points, cells), ["thickness"], chunk=64)
    sorted_cells = np.sort(cells, axis=1).tolist()
    doubled = [i for i, cell in enumerate(sorted_cells) if cell in sorted_cells[:i]]
    assert (report.doubled, report.doubled_cells) == (len(doubled), doubled[:10])
    assert len(doubled) > 20
    if d == m:
        edges = points[cells[:, 1:]] - points[cells[:, :1]]
        inverted = np.flatnonzero(
            (np.linalg.det(edges) < 0) & [len(set(cell)) == d + 1 for cell in sorted_cells]
        )
        assert (report.inverted, report.inverted_cells) == (len(inverted), inverted[:10].tolist())
    else:
        assert (report.inverted, report.inverted_cells) == (None, [])


def test_keys_that_collide_convict_no_cell(monkeypatch):
    monkeypatch.setattr("coxeter.meshes.doubles._keys", lambda cells: np.zeros(len(cells), np.uint64))
    mesh = Mesh(np.eye(4)[:, :2], [[0, 1, 2], [1, 2, 3], [2, 0, 1], [0, 1, 3]])
    assert quality_report(mesh, ["thickness"]).doubled_cells == [2]


def test_a_plane_in_space_has_an_orientation_and_a_surface_has_none():
    flat = np.array([[0, 0, 5], [1, 0, 5], [0, 1, 5], [1, 1, 5]])
    cells = [[0, 1, 2], [1, 2, 3]]
    assert quality_report(Mesh(flat, cells), ["thickness"]).inverted_cells == [1]
    assert quality_report(flat[cells], ["thickness"]).doubled is None
    flat[0, 2] = 6
    assert quality_report(Mesh(flat, cells), ["thickness"]).inverted is None


def test_a_histogram_reaches_beyond_1_where_values_do():
    x = quality_report(random_mesh(), ["minimal_dihedral_angle"], normalised=False, bins=3).measures[0]
    assert x.edges[0] == pytest.approx(x.min, rel=1e-3)
    assert x.edges[-1] == pytest.approx(x.max, rel=1e-3)


def test_what_a_measure_leaves_undefined_is_counted():
    @measure("height over excess")
    def height_over_excess(simplex):
        return simplex.minimal_height / (2 - simplex.longest_edge)

    corners = [[(0, 0), (1, 0), (0, 1)], [(0, 0), (2, 0), (1, 1)], [(0, 0), (2, 0), (1, float(sqrt(3)))]]
    report = quality_report(corners, [height_over_excess], normalised=False)
    assert report.measures[0].undefined == 2
    assert report.measures[0].worst == 0


def test_a_measure_without_a_value_of_the_regular_simplex_is_refused():
    @measure("over difference")
    def over_difference(simplex):
        return 1 / (simplex.longest_edge - simplex.shortest_edge)

    with pytest.raises(InvalidInput, match="over difference"):
        mesh_qualities(np.eye(3)[None], [over_difference])
    with pytest.raises(InvalidInput, match="is 0"):
        mesh_qualities([[(0,), (1,)]], ["minimal_dihedral_angle"])


@pytest.mark.parametrize("wrong", [{"bins": 0}, {"chunk": 0}, {"measures": ["beauty"]}])
def test_a_report_that_cannot_be_is_refused(wrong):
    with pytest.raises(InvalidInput):
        quality_report(random_mesh(), **wrong)


def test_memory_is_bounded_by_the_chunk():
    """Twenty chunks take no more than one does, with the bound that the documentation gives."""
    mesh, chunk = random_mesh(40_000), 2000
    quality_report(random_mesh())  # loads what it needs
    tracemalloc.start()
    quality_report(mesh, chunk=chunk)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    values = 11 * 2**20  # those that occur: at most 2^13 to a power of two, 16 bytes each
    assert peak < 150 * 4 * 4 * chunk + values
    assert peak < 150 * 4 * 4 * len(mesh) / 2


def test_dask_says_the_same_on_two_workers():
    import dask.array as dask_array
    import distributed

    mesh = random_mesh()
    lazy = dask_array.from_array(mesh.corners, chunks=(300, 2, 3))
    expected = quality_report(mesh)
    with distributed.Client(n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None):
        found = quality_report(lazy)
        arrays = {name: x.compute() for name, x in mesh_qualities(lazy, ["thickness", "fatness"]).items()}
    for a, b in zip(found.measures, expected.measures, strict=True):
        assert a.mean == pytest.approx(b.mean, rel=1e-12)
        assert {**vars(a), "mean": 0} == {**vars(b), "mean": 0}
    names = ("cells", "degenerate_cells", "inverted", "inverted_cells")
    assert all(getattr(found, name) == getattr(expected, name) for name in names)
    assert found.doubled is None
    for name, values in mesh_qualities(mesh, ["thickness", "fatness"]).items():
        assert np.array_equal(values, arrays[name], equal_nan=True)


@pytest.mark.parametrize(
    "points", [[[0, 0], [1j, 0], [0, 1]], [["a", 0], [1, 0], [0, 1]], [[0], [1, 2], [0, 1]]]
)
def test_points_that_are_no_real_numbers_are_refused(points):
    with pytest.raises(InvalidInput, match="rows of real numbers"):
        Mesh(points, [[0, 1, 2]])
