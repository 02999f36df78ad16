"""Regions that are long, thin, degenerate, far out, of many dimensions, or too large: answered or refused."""

import logging
from fractions import Fraction

import numpy as np
import pytest
from askew import rows, turned
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from coxeter import triangulation
from coxeter.errors import InvalidInput
from coxeter.location import Grid, convex, regions
from coxeter.location.bounds import at_least
from coxeter.location.convex import Ball, Box
from coxeter.location.interpolation import vertices_of
from coxeter.location.regions import search
from coxeter.location.rows import flood

LOW = ["A~2", "A~3", "A~4", "B~3", "B~4", "C~2", "C~3", "C~4", "D~4", "F~4", "G~2"]


# -- degenerate boxes ---------------------------------------------------------------------------------------


def outside(corners, lower, upper):
    """How much a box must grow on all sides to meet a simplex; less than 0 if it may shrink."""
    d, wider = len(lower), -np.ones((len(lower), 1))
    limits = np.block([[corners.T, wider], [-corners.T, wider]])
    answer = linprog(
        np.append(np.zeros(d + 1), 1.0),
        limits,
        np.concatenate([upper, -np.asarray(lower)]),
        np.append(np.ones(d + 1), 0.0)[None],
        [1.0],
        [(0, None)] * (d + 1) + [(None, None)],
    )
    return answer.fun


fractions = st.sampled_from([Fraction(*x) for x in [(0, 1), (1, 2), (1, 3), (-1, 2), (2, 3), (1, 4), (1, 6)]])


@pytest.mark.parametrize("name", LOW)
@given(data=st.data())
@settings(max_examples=3, deadline=None)
def test_boxes_on_walls_miss_no_simplex(name, data):
    """What is found touches the box, and no neighbour of it does that is not found."""
    grid, d = Grid(name), triangulation(name).dimension
    lower = np.array(data.draw(st.lists(fractions, min_size=d, max_size=d)), dtype=float)
    thick = np.array(data.draw(st.lists(st.booleans(), min_size=d, max_size=d)))
    upper = lower + 0.25 * thick * (1 if d < 4 else 0.5)
    keys = grid.alcoves_in_box(lower, upper)
    found = rows(keys)
    beyond = np.array(sorted(rows(grid.neighbours(keys).reshape(-1, keys.shape[1])) - found))
    for some, touching in ((keys, True), (beyond, False)):
        for corners in grid.vertices(some[:: len(some) // 25 + 1]):
            assert (outside(corners, lower, upper) < 1e-11) == touching


@pytest.mark.parametrize("name", LOW)
def test_a_point_lies_in_as_many_simplices_as_its_stabiliser_has_elements(name):
    """The other route: the reflections in walls through a point, applied to a generic point beside it."""
    grid, d = Grid(name), triangulation(name).dimension
    key = grid.locate(np.random.default_rng(1).normal(size=(1, d)) * 5).keys
    roots = grid.triangulation.roots.positive_roots
    normals = roots.numerators / roots.denominator
    for shares in (np.eye(d + 1)[0], np.eye(d + 1)[1] / 2 + np.eye(d + 1)[2] / 2, np.ones(d + 1) / (d + 1)):
        point = shares @ grid.corners(key)[0] / grid.vertex_unit
        through = normals[np.abs(normals @ point - np.rint(normals @ point)) < 1e-9]
        images = [np.random.default_rng(2).normal(size=len(point))]
        for image in images:
            for n in through:
                other = image - 2 * (image @ n) / (n @ n) * n
                if min(np.abs(other - x).max() for x in images) > 1e-9:
                    images.append(other)
            if len(images) > 100:
                break
        where = grid.frame.outward(point)
        count = len(grid.alcoves_in_box(where, where))
        assert count == len(grid.alcoves_in_ball(where, 0))
        assert count == len(images) if len(images) <= 100 else count > 100


@pytest.mark.parametrize("name", ["C~3", "A~3", "F~4"])
def test_nothing_is_lost_if_the_linear_programs_go_astray(name, monkeypatch):
    """A simplex is left out only if a plane between is seen, whatever the simplex method says."""
    grid, d = turned(name), triangulation(name).dimension
    sound = rows(grid.alcoves_in_box([0.1] * d, [0.3] * d))

    def astray(table, lower, upper):
        n, r, c = table.shape
        return np.zeros(n, dtype=bool), np.random.default_rng(3).normal(size=(n, r + c))

    monkeypatch.setattr(convex, "feasible", astray)
    assert sound <= rows(grid.alcoves_in_box([0.1] * d, [0.3] * d))


def test_rows_that_are_refused_at_one_time_and_entered_at_another_are_found_once():
    rng = np.random.default_rng(4)
    steps = np.array([[0, 1], [1, 0], [0, -1], [-1, 0]])

    def around(found):
        return (found[:, None] + steps).reshape(-1, 2)

    def fickle(found):
        return (np.abs(found).max(axis=1) <= 60) & (rng.random(len(found)) < 0.8)

    found = flood(np.zeros((1, 2), dtype=np.int64), around, fickle)
    assert len(rows(found)) == len(found) > 121**2 / 2
    assert found.tolist() == sorted(found.tolist())


def test_what_is_carried_along_is_not_part_of_the_answer():
    step = np.array([1, 3])
    found = flood(
        np.array([[0, 7]]),
        lambda rows: np.concatenate([rows + step, rows - step]),
        lambda rows: rows[:, 0] ** 2 < 9,
        leading=1,
    )
    assert found is not None
    assert found.tolist() == [[-2], [-1], [0], [1], [2]]


# -- long and thin ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["A~2", "C~3", "D~4", "E~6", "A~8"])
def test_from_many_points_and_from_one_the_same_is_found(name, monkeypatch):
    d = triangulation(name).dimension
    for grid in (Grid(name), turned(name)):
        upper = np.zeros(d)
        upper[0] = 60.0 if d < 4 else 20.0 if d < 8 else 26.0
        lower = 0 * upper + 0.123
        if grid.frame.rotation is None and d < 6:
            lower[:] = 0
        many = search(grid, Box.between(lower, lower + upper, d))
        assert len(many._seeds) > 2
        keys = many.keys()
        monkeypatch.setattr(regions, "SEEDS", 1)
        one = search(grid, Box.between(lower, lower + upper, d))
        assert len(one._seeds) == 1
        assert (one.keys() == keys).all()
        monkeypatch.undo()


@pytest.mark.parametrize("name", [*LOW, "A~6", "B~5", "C~5", "D~5", "E~6"])
@given(data=st.data())
@settings(max_examples=4, deadline=None)
def test_vertices_by_lattices_are_those_of_the_simplices(name, data):
    """In boxes that may be thin, on walls or not, turned or not."""
    d = triangulation(name).dimension
    grid = Grid(name) if data.draw(st.booleans()) else turned(name)
    size = data.draw(st.sampled_from([0.0, 0.25, 0.5] if d > 4 else [0.0, 0.5, 1.2]))
    thick = np.array(data.draw(st.lists(st.booleans(), min_size=d, max_size=d)))
    start = grid.vertices(grid.locate(np.full((1, d), 3.21)).keys)[0, data.draw(st.integers(0, d))]
    lower, upper = start, start + size * thick
    found = grid.vertices_in_box(lower, upper)
    every = vertices_of(grid, grid.alcoves_in_box(lower, upper))[0]
    inside = ((every.positions > lower - 1e-11) & (every.positions < upper + 1e-11)).all(axis=1)
    assert len(found) > 0
    assert (found.keys == every.keys[inside]).all()
    assert (found.labels == every.labels[inside]).all()


@pytest.mark.parametrize("name", ["A~40", "B~40", "C~40", "D~40"])
def test_one_vertex_of_very_many_dimensions(name):
    for grid in (Grid(name), turned(name)):
        where = grid.vertices(grid.locate(np.full((1, 40), 0.3)).keys)[0, 7]
        found = grid.vertices_in_ball(where, 0.01)
        assert found.labels.tolist() == [7]
        assert np.abs(found.positions - where).max() < 1e-12
        assert len(grid.vertices_in_box(where + 0.01, where + 0.02)) == 0


def test_the_shells_of_e8():
    """Round the origin lie orbits of vertices, as many as their stabilisers E8, E6 + A1, E7 have cosets."""
    grid = Grid("E~8")
    found, corners = grid.vertices_in_ball([0.0] * 8, 0.85), grid.triangulation.simplex.vertices
    near = [k for k, u in enumerate(corners) if sum(x * x for x in u) < Fraction(85, 100) ** 2]
    counts = {int(k): int((found.labels == k).sum()) for k in np.unique(found.labels)}
    assert list(counts) == near == [0, 7, 8]
    assert counts == {0: 1, 7: 696729600 // (51840 * 2), 8: 696729600 // 2903040}


def test_a_line_of_many_simplices(caplog):
    with caplog.at_level(logging.INFO):
        keys = Grid("C~2", scale=1e-3).alcoves_in_box([0, 0], [100, 0])
    assert len(keys) == 8 * 10**5 + 8
    assert any("found so far" in note.message for note in caplog.records)


# -- many dimensions ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["C~60", "A~100", "D~200"])
def test_a_generic_point_lies_in_one_simplex(name):
    point = np.random.default_rng(5).uniform(size=triangulation(name).dimension)
    assert len(Grid(name).alcoves_in_box(point, point)) == 1


def test_a_point_on_few_walls_lies_in_few_simplices():
    point, grid = np.random.default_rng(6).uniform(0.1, 0.4, size=60), Grid("C~60")
    point[1], point[3], point[4], point[6] = point[0], point[2], point[2], 0
    assert len(grid.alcoves_in_box(point, point)) == 2 * 6 * 2
    assert len(grid.alcoves_in_ball(point, 0)) == 2 * 6 * 2


def test_a_point_on_many_walls_is_refused():
    point, grid = np.random.default_rng(7).uniform(size=60).round(1), Grid("C~60")
    for ask in (lambda: grid.alcoves_in_box(point, point), lambda: grid.alcoves_in_ball(point, 0)):
        with pytest.raises(InvalidInput, match=r"at least \S+ simplices: too many to hold"):
            ask()


# -- too much -----------------------------------------------------------------------------------------------


GENERIC = np.sqrt([2, 3, 5, 7, 11, 13, 17, 19]).tolist()


@pytest.mark.parametrize(
    ("name", "kind", "lower", "upper", "told"),
    [
        ("B~3", "vertices", [0, 0, 0], [1e9, 0, 0], "about .* vertices"),
        ("C~2", "alcoves", [0, 0], [1e8, 0], "at least 4e.08 simplices"),
        ("E~8", "alcoves", [0] * 8, [1e4] + [0] * 7, "at least .* simplices"),
        ("E~8", "alcoves", GENERIC, [2e3] * 2 + GENERIC[2:], "about .* simplices"),
        ("E~8", "vertices", [0] * 8, [3] * 8, "about .* vertices"),
    ],
)
def test_too_much_is_refused_in_one_sentence(name, kind, lower, upper, told):
    with pytest.raises(InvalidInput, match=told + r".*too many to hold; ask for fewer$"):
        getattr(Grid(name), kind + "_in_box")(lower, upper)


def test_a_wide_plate_may_hold_no_vertex():
    assert len(Grid("E~8").vertices_in_box(GENERIC, [200.0] * 2 + GENERIC[2:])) == 0


def test_it_is_told_if_rounding_makes_a_point_large():
    with pytest.raises(InvalidInput, match=r"rounding leaves 5.7e-05 open at coordinates up to 1e\+09"):
        Grid("E~6", scale=1e-6, offset=[1e9] * 6).alcoves_in_box([1e9] * 6, [1e9] * 6)


@pytest.mark.parametrize(("name", "size"), [("B~3", 60), ("D~4", 30), ("E~6", 6), ("A~8", 4)])
def test_the_estimate_is_near(name, size, monkeypatch):
    monkeypatch.setattr(regions, "SAMPLE", 1000)
    grid, d = turned(name), triangulation(name).dimension
    found = search(grid, Box.between([0.1] * d, [size] * 2 + [0.1] * (d - 2), d))
    assert 0.1 < found.estimate() / len(found.keys()) < 1.5


@pytest.mark.parametrize("name", LOW)
@given(data=st.data())
@settings(max_examples=4, deadline=None)
def test_the_lower_bound_holds_on_walls_too(name, data):
    grid, d = Grid(name), triangulation(name).dimension
    lower = np.array(data.draw(st.lists(fractions, min_size=d, max_size=d)), dtype=float)
    sizes = np.array(data.draw(st.lists(st.sampled_from([0, 0, 0.5]), min_size=d, max_size=d)))
    for region in (Box.between(lower, lower + sizes, d), Ball.around(lower, sizes[0], d)):
        found = search(grid, region)
        assert at_least(grid, found.region, found.slack) <= len(found.keys())
