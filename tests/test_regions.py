"""Boxes, balls and patches: against brute force in exact arithmetic, against SciPy, and with bad input."""

from fractions import Fraction
from itertools import combinations, product
from math import factorial

import numpy as np
import pytest
from askew import rows, turned
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog
from scipy.spatial import Delaunay, cKDTree

from coxeter import triangulation
from coxeter.errors import InvalidInput
from coxeter.location import Grid
from coxeter.location.bounds import at_least
from coxeter.location.convex import Ball, Box
from coxeter.location.regions import search
from coxeter.location.rows import addends, codes, distinct, numbered

FLAT = ["B~3", "C~2", "C~3"]
"""Their roots have d coordinates, so that boxes of R^d can be compared with exact vertices."""
TURNED = ["A~2", "A~3", "B~3", "C~3", "G~2", "D~4", "F~4"]


# -- brute force --------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def around():
    """Exact simplices of a grid within a few steps of the origin, by their keys."""
    made = {}

    def simplices(name, reach=2):
        if name not in made:
            grid = Grid(name)
            star = grid.star(grid._centre, 0)
            # The coroot lattice: Z^d for C~, the vectors with an even sum for B~.
            shifts = map(np.array, product(range(-reach, reach + 1), repeat=grid.dimension))
            near = [s for s in shifts if name[0] == "C" or s.sum() % 2 == 0]
            keys = np.concatenate([star + s * grid.key_unit for s in near])
            made[name] = {
                tuple(key): [[Fraction(x, grid.vertex_unit) for x in corner] for corner in corners]
                for key, corners in zip(keys.tolist(), grid.corners(keys).tolist(), strict=True)
            }
        return made[name]

    return simplices


def clipped(points, k, bound, sign):
    """Points whose hull is what a half-space leaves of the hull of others."""
    inside = [p for p in points if sign * (p[k] - bound) <= 0]
    outside = [p for p in points if sign * (p[k] - bound) > 0]
    cut = [
        tuple(a + (b - a) * (bound - p[k]) / (q[k] - p[k]) for a, b in zip(p, q, strict=True))
        for p in inside
        for q in outside
    ]
    return list(set(map(tuple, inside)) | set(cut))


def meets_exactly(simplex, lower, upper):
    points = simplex
    for k in range(len(lower)):
        points = clipped(clipped(points, k, upper[k], 1), k, lower[k], -1)
        if not points:
            return False
    return True


def squared_distance(simplex, centre):
    """The least over all faces of the distance to their spans, if the nearest point lies on the face."""
    corners = np.array(simplex, dtype=np.float64) - np.array(centre, dtype=np.float64)
    best = np.inf
    for size in range(1, len(corners) + 1):
        for face in combinations(range(len(corners)), size):
            first, edges = corners[face[0]], corners[list(face[1:])] - corners[face[0]]
            shares = np.linalg.lstsq(edges.T, -first, rcond=None)[0] if size > 1 else np.empty(0)
            if (shares >= -1e-12).all() and shares.sum() <= 1 + 1e-12:
                best = min(best, float(((first + shares @ edges) ** 2).sum()))
    return best


eighths = st.integers(-9, 9).map(lambda n: Fraction(n, 8))


@given(st.lists(st.tuples(eighths, eighths), min_size=3, max_size=3), st.sampled_from(FLAT))
def test_a_box_meets_what_it_meets_exactly(around, corners, name):
    """Among the boxes are many that touch simplices in a vertex or an edge, and some without an inside."""
    grid = Grid(name)
    lower, upper = zip(*map(sorted, corners[: grid.dimension]), strict=True)
    # Vertex 0 of what meets the box has coordinates up to 9/8 + 1: the simplices around are enough.
    expected = {key for key, simplex in around(name).items() if meets_exactly(simplex, lower, upper)}
    assert rows(grid.alcoves_in_box([float(x) for x in lower], [float(x) for x in upper])) == expected


@pytest.mark.parametrize("name", FLAT)
@pytest.mark.parametrize(("centre", "radius"), [(0, 0.5), (0.25, 0.5), (0.5, 0), (0.375, 0.25), (0, 1)])
def test_a_ball_meets_what_it_meets_exactly(around, name, centre, radius):
    grid = Grid(name)
    middle = [centre] * grid.dimension
    expected = {
        key for key, simplex in around(name).items() if squared_distance(simplex, middle) <= radius**2 + 1e-13
    }
    assert rows(grid.alcoves_in_ball(middle, radius)) == expected


# -- other routes -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", TURNED)
@pytest.mark.parametrize("shape", ["box", "ball"])
def test_stars_and_neighbours_lead_to_the_same(name, shape):
    grid, d = turned(name), triangulation(name).dimension
    rng = np.random.default_rng(5)
    for size in (0.05, 0.4):
        lower = rng.normal(size=d)
        region = Box.between(lower, lower + size * rng.uniform(size=d), d)
        if shape == "ball":
            region = Ball.around(lower, size / 2, d)
        found = search(grid, region)
        spread = found.spread(10**9)
        assert rows(spread) == rows(found.keys_of(*found.stars())) == rows(found.keys())


@pytest.mark.parametrize("name", TURNED)
def test_points_of_the_region_lie_in_what_is_found_and_nothing_is_too_much(name):
    grid, d = turned(name), triangulation(name).dimension
    size = 1.0 if d < 4 else 0.4
    lower = np.full(d, 0.3)
    points = np.random.default_rng(6).uniform(size=(2000, d))
    box, ball = grid.alcoves_in_box(lower, lower + size), grid.alcoves_in_ball(lower, size / 2)
    assert rows(grid.locate(lower + size * points).keys) <= rows(box)
    directions = np.random.default_rng(7).normal(size=(2000, d))
    directions *= size / 2 * points[:, :1] / np.linalg.norm(directions, axis=1)[:, None]
    assert rows(grid.locate(lower + directions).keys) <= rows(ball)
    step = max(1, len(box) // 150)
    for corners in grid.vertices(box[::step]):
        limits = [corners.T, -corners.T]
        answer = linprog(
            np.zeros(d + 1),
            np.concatenate(limits),
            np.concatenate([lower + size, -lower]) + 1e-9,
            np.ones((1, d + 1)),
            [1.0],
        )
        assert answer.status == 0
    for corners in grid.vertices(ball[:: max(1, len(ball) // 150)]):
        assert squared_distance(corners, lower) <= (size / 2 + 1e-9) ** 2


@pytest.mark.parametrize("name", TURNED)
def test_volumes_bound_the_box(name):
    """Simplices inside the box, and all that meet it, have less and more than its volume: 1."""
    grid, d = turned(name), triangulation(name).dimension
    keys = grid.alcoves_in_box(np.full(d, -0.2), np.full(d, 0.8))
    corners = grid.vertices(keys)
    volumes = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / factorial(d)
    inside = ((corners > -0.2) & (corners < 0.8)).all(axis=(1, 2))
    assert volumes[inside].sum() < 1 < volumes.sum()
    assert np.allclose(volumes, float(triangulation(name).simplex.volume) * 0.7**d)


@pytest.mark.parametrize("d", [2, 3, 4, 5])
def test_a_cube_holds_as_many_as_are_in_it(d):
    """C~: half of the unit cube's edges long, d! simplices make a cube."""
    keys = Grid(f"C~{d}").alcoves_in_box(np.full(d, 1e-6), np.full(d, 1 - 1e-6))
    assert len(keys) == 2**d * factorial(d)


@pytest.mark.parametrize("name", ["A~12", "B~9", "C~8", "D~12", "E~6", "E~7", "E~8"])
def test_small_regions_in_many_dimensions(name):
    grid, d = Grid(name), triangulation(name).dimension
    centre = np.random.default_rng(8).normal(size=d)
    here = grid.locate(centre[None]).keys
    assert rows(grid.alcoves_in_ball(centre, 0)) == rows(grid.alcoves_in_box(centre, centre)) == rows(here)
    found = grid.alcoves_in_ball(centre, 0.02)
    assert rows(here) <= rows(found) <= rows(grid.alcoves_in_box(centre - 0.02, centre + 0.02))
    assert all(squared_distance(c, centre) <= 0.02**2 + 1e-12 for c in grid.vertices(found[:2]))


@pytest.mark.parametrize("name", ["B~3", "C~3", "D~4"])
def test_a_ball_of_no_radius_at_a_vertex_holds_its_star(name):
    grid = Grid(name)
    origin = np.zeros(grid.dimension)
    assert len(grid.alcoves_in_ball(origin, 0)) == triangulation(name).roots.weyl_group_order
    assert (grid.alcoves_in_box(origin, origin) == grid.star(grid._centre, 0)).all()


# -- vertices -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*TURNED, "A~4", "C~4", "E~6"])
def test_vertices_are_those_of_the_simplices_around(name):
    grid, d = turned(name), triangulation(name).dimension
    centre, radius = np.full(d, 0.1), 0.8 if d < 6 else 0.45
    keys = grid.alcoves_in_ball(centre, radius)
    corners = grid.corners(keys)
    inside = np.linalg.norm(grid.vertices(keys) - centre, axis=2) <= radius
    expected = {(*corners[i, k].tolist(), k) for i, k in np.argwhere(inside)}
    found = grid.vertices_in_ball(centre, radius)
    listed = [(*key, label) for key, label in zip(found.keys.tolist(), found.labels.tolist(), strict=True)]
    assert listed == sorted(expected)
    assert np.linalg.norm(found.positions - centre, axis=1).max(initial=0) <= radius


def test_vertices_on_the_boundary_count():
    assert len(Grid("C~3").vertices_in_box([0, 0, 0], [1, 1, 1])) == 27
    found = Grid("B~4").vertices_in_ball([0] * 4, 1)
    lengths = np.linalg.norm(found.positions, axis=1)
    assert (lengths == 1).sum() == 8 + 16  # those of ±e_i, and of (±1/2, ..., ±1/2)
    assert len(found) == 1 + 24 + 32 + 24


# -- patches ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", TURNED)
def test_a_patch_is_the_mesh_of_its_simplices(name):
    grid, d = turned(name), triangulation(name).dimension
    lower = np.full(d, -0.3)
    keys = grid.alcoves_in_box(lower, lower + 1)
    mesh, slow = grid.patch_in_box(lower, lower + 1), grid.patch(keys)
    assert np.abs(mesh.corners - grid.vertices(keys)).max() < 1e-12
    assert (mesh.cells == slow.cells).all()
    assert (mesh.points == slow.points).all()
    labels = mesh.point_data["label"]
    assert (labels == slow.point_data["label"]).all()
    assert (labels[mesh.cells] == np.arange(d + 1)).all()
    nearest, _ = cKDTree(mesh.points).query(mesh.points, k=2)
    assert nearest[:, 1].min() > 0.1  # no point twice
    assert sorted(set(mesh.cells.flat)) == list(range(len(mesh.points)))


@pytest.mark.parametrize("name", TURNED)
def test_orientation(name):
    """By labels neighbours have opposite orientations; if asked for, all have the same."""
    grid = turned(name)
    key = grid.locate(np.zeros((1, grid.dimension))).keys
    keys = np.concatenate([key, grid.neighbours(key)[0]])

    def signs(mesh):
        return np.sign(np.linalg.det(mesh.corners[:, 1:] - mesh.corners[:, :1]))

    plain, oriented = grid.patch(keys), grid.patch(keys, oriented=True)
    assert (signs(plain)[1:] == -signs(plain)[0]).all()
    assert (signs(oriented) == 1).all()
    assert (np.sort(plain.cells) == np.sort(oriented.cells)).all()


@pytest.mark.parametrize("name", ["A~2", "A~3", "A~4"])
def test_in_a_protected_family_qhull_finds_the_same(name):
    mesh = Grid(name).patch_in_box([-1.2] * int(name[2:]), [0.9] * int(name[2:]))
    theirs = rows(np.sort(Delaunay(mesh.points).simplices))
    assert rows(np.sort(mesh.cells)) <= theirs


@pytest.mark.parametrize("name", ["A~2", "A~3", "C~2", "C~3", "C~4", "F~4", "G~2"])
def test_circumballs_are_empty(name):
    """Where Qhull has a choice, among cospherical points, what it must respect is compared."""
    grid = turned(name)
    mesh = grid.patch_in_ball([0.0] * grid.dimension, 0.7)
    edges = mesh.corners[:, 1:] - mesh.corners[:, :1]
    centres = np.linalg.solve(edges, (edges**2).sum(axis=2)[..., None] / 2)[..., 0]
    radii = np.linalg.norm(centres, axis=1)
    nearest, _ = cKDTree(mesh.points).query(centres + mesh.corners[:, 0])
    assert nearest.min() > radii.max() - 1e-9


def test_a_patch_of_nothing_is_empty():
    mesh = Grid("A~3").patch(np.empty((0, 4), dtype=np.int64))
    assert mesh.points.shape == (0, 3)
    assert mesh.cells.shape == (0, 4)


# -- far out, and refusals ----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["A~3", "C~3", "G~2"])
def test_far_from_the_origin_as_near(name):
    """A patch and the same, moved by a vector of the coroot lattice, have the same cells."""
    grid = Grid(name)
    coroots = grid.triangulation.roots.coroots
    shift = coroots.numerators[0].astype(np.int64) // coroots.denominator * 2**20
    moved = grid.frame.outward(shift.astype(float))
    lower = np.full(grid.dimension, 0.123)
    near = grid.alcoves_in_box(lower, lower + 1)
    far = grid.alcoves_in_box(lower + moved, lower + 1 + moved)
    assert rows(near + shift * grid.key_unit) == rows(far)


def test_the_order_is_that_of_the_keys():
    for keys in (Grid("C~3").alcoves_in_box([0] * 3, [2] * 3), Grid("A~6").alcoves_in_ball([0.1] * 6, 0.1)):
        assert keys.tolist() == sorted(keys.tolist())


@pytest.mark.parametrize(
    ("lower", "upper", "told"),
    [
        ([0, 0], [1, 1, 1], "lower corner is .* expected 3"),
        ([0, 0, 0], [1, float("nan"), 1], "upper corner is .* finite"),
        ([0, 2, 0], [1, 1, 1], "coordinate 1 .* swap"),
        ([0, 0, 0], ["a", 1, 1], "expected 3 numbers"),
        ([0, 0, 0], [1e5, 1e5, 1e5], "too many to hold"),
        ([1e13, 0, 0], [1e13, 1, 1], "do not tell simplices apart"),
        ([0, 0, 0], [1e11, 0, 0], "too many to hold"),
        ([0, 0, 0], [1e6, 1e6, 0], "too many to hold"),
        ([-1.7e308] * 3, [1.7e308] * 3, "too many to hold"),
        ([0, 0, 0], [10**400] * 3, "floats can hold"),
    ],
)
def test_bad_boxes_are_refused(lower, upper, told):
    for ask in (Grid("B~3").alcoves_in_box, Grid("B~3").vertices_in_box, Grid("B~3").patch_in_box):
        with pytest.raises(InvalidInput, match=told):
            ask(lower, upper)


@pytest.mark.parametrize(
    ("centre", "radius", "told"),
    [
        ([0, 0, 0], -1, "no radius"),
        ([0, 0, 0], float("inf"), "no radius"),
        ([0, 0], 1, "expected 3"),
        ([0, 0, 0], 1e4, "too many to hold"),
        ([0, 0, 0], 1e300, "too many to hold"),
        ([0, 0, 0], 10**400, "no radius"),
        ([0, 0, 0], "x", "no radius"),
        ([0, 0, 0], None, "no radius"),
    ],
)
def test_bad_balls_are_refused(centre, radius, told):
    for ask in (Grid("B~3").alcoves_in_ball, Grid("B~3").vertices_in_ball, Grid("B~3").patch_in_ball):
        with pytest.raises(InvalidInput, match=told):
            ask(centre, radius)


def test_more_simplices_at_a_vertex_than_memory_holds_are_refused_at_once():
    grid = Grid("E~8")
    for ask in (
        lambda: grid.alcoves_in_box([0] * 8, [0] * 8),
        lambda: grid.alcoves_in_ball([0] * 8, 0.1),
        lambda: grid.star(grid.locate([[0.0] * 8]).keys[0], 0),
    ):
        with pytest.raises(InvalidInput, match=r"at least 6\.97e\+08 simplices: too many"):
            ask()
    assert len(grid.vertices_in_ball([0] * 8, 0)) == 1


@pytest.mark.parametrize("label", [3, -1, "1", 1.5, 1.0, None])
def test_what_is_no_label_has_no_star(label):
    grid = Grid("C~2")
    with pytest.raises(InvalidInput, match="no label: give an integer from 0 to 2"):
        grid.star(grid.locate([[0.3, 0.1]]).keys[0], label)


@pytest.mark.parametrize("name", ["A~2", "B~3", "D~4", "F~4", "G~2"])
@given(data=st.data())
@settings(max_examples=4, deadline=None)
def test_the_lower_bound_for_the_number_of_simplices_is_one(name, data):
    grid = Grid(name, scale=data.draw(st.sampled_from([0.7, 3.0])))
    d = grid.dimension
    lower = np.array(data.draw(st.lists(st.floats(-1, 1), min_size=d, max_size=d)))
    sizes = np.array(data.draw(st.lists(st.sampled_from([0, 0.1, 1, 2]), min_size=d, max_size=d)))
    found = search(grid, Box.between(lower, lower + sizes, d))
    assert at_least(grid, found.region, found.slack) <= len(found.keys())
    found = search(grid, Ball.around(lower, sizes[0], d))
    assert at_least(grid, found.region, found.slack) <= len(found.keys())


@pytest.mark.parametrize(("name", "d"), [("A~10", 10), ("A~40", 40)])
def test_a_point_in_many_dimensions_lies_in_one_simplex(name, d):
    point = np.random.default_rng(5).uniform(size=d)
    assert len(Grid(name).alcoves_in_box(point, point)) == 1


# -- rows ---------------------------------------------------------------------------------------------------

numbers = st.one_of(st.integers(-3, 3), st.integers(-(10**30), 10**30))


@given(st.lists(st.tuples(numbers, numbers, numbers), min_size=1, max_size=12))
def test_codes_order_rows_of_any_size(given_rows):
    array = np.array(given_rows, dtype=object)
    code = codes(array).tolist()
    for (a, row), (b, other) in combinations(zip(code, given_rows, strict=True), 2):
        assert ((a > b) - (a < b)) == ((row > other) - (row < other))
    different, places = distinct(array)
    assert different.tolist() == [list(row) for row in sorted(set(given_rows))]
    assert (different[places] == array).all()


def test_dense_and_sparse_codes_are_numbered_alike():
    code = np.random.default_rng(9).integers(0, 50, 200)
    dense, sparse = numbered(code), numbered(code * 10**6)
    assert (dense[0] * 10**6 == sparse[0]).all()
    assert (dense[1] == sparse[1]).all()


def test_sums_of_addends_are_equal_as_sums_of_rows_are():
    rng = np.random.default_rng(10)
    a, b = 6 * rng.integers(-2, 3, (30, 3)), 6 * rng.integers(-2, 3, (20, 3))
    left, right = addends(a, b)
    sums, total = (a[:, None] + b).reshape(-1, 3), (left[:, None] + right).reshape(-1)
    assert (distinct(sums)[1] == numbered(total)[1]).all()
    assert addends(a * 2**40, b * 2**39 + 1) is None
