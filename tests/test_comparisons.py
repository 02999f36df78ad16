"""Other triangulations: their cells fill what they should, exactly, and the classes are all there are."""

import itertools
import math
from fractions import Fraction
from random import Random

import oracle
import pytest

from coxeter import (
    InvalidInput,
    Simplex,
    Unavailable,
    find_measure,
    regular_simplex,
    sqrt,
    thickness,
    triangulation,
)
from coxeter.figures import quality_curves
from coxeter.peers import DEFAULT, PEERS, find_peer
from coxeter.peers.fillers import BCC
from coxeter.quality import MEASURES, MESH_MEASURES, mean_ratio
from coxeter.tables import measure_table

CUBES = [
    (name, d)
    for name in ("K1", "J1", "barycentric", "D1", "five", "sixteen")
    for d in range(2, 6)
    if PEERS[name].exists(d) and (d < 5 or name in ("K1", "D1"))
]


def covering(cells, x):
    """How many cells hold a point, and whether it lies inside each of these."""
    weights = [oracle.barycentric(cell, x) for cell in cells]
    held = [w for w in weights if min(w) >= 0]
    return len(held), all(min(w) > 0 for w in held)


def pairs(cell):
    """The squared edges, in order of size: cells with different lists are not congruent."""
    return sorted(oracle.squared_edges(cell).values())


def random_point(rng, low, high, d):
    return tuple(low + (high - low) * Fraction(rng.randint(1, 10**6), 10**6 + 3) for _ in range(d))


@pytest.mark.parametrize(("name", "d"), CUBES)
def test_the_cells_fill_the_cube_once(name, d):
    """Their volumes add up to that of the cube, they lie in it, and points at random lie in one cell only."""
    cells = list(PEERS[name].cells(d))
    low, high = (-1, 1) if name == "J1" else (0, 1)
    assert all(low <= x <= high for cell in cells for point in cell for x in point)
    volumes = {}
    for cell in cells:
        volumes.setdefault(oracle.squared_volume(cell), Simplex(cell).volume)
    assert all(v * v == square for square, v in volumes.items())
    assert sum(volumes[oracle.squared_volume(cell)] for cell in cells) == (high - low) ** d
    rng = Random(d)
    for _ in range(8):
        held, inside = covering(cells, random_point(rng, low, high, d))
        assert (held, inside) == (1, True)


@pytest.mark.parametrize(("name", "d"), [(name, d) for name, d in CUBES if d < 5])
def test_the_cells_meet_facet_to_facet(name, d):
    """Each facet inside the cube belongs to two cells, each on its boundary to one."""
    cells = [frozenset(cell) for cell in PEERS[name].cells(d)]
    low, high = (-1, 1) if name == "J1" else (0, 1)
    counts = {}
    for cell in cells:
        for point in cell:
            facet = cell - {point}
            counts[facet] = counts.get(facet, 0) + 1
    for facet, count in counts.items():
        outer = any({p[i] for p in facet} in ({low}, {high}) for i in range(d))
        assert count == (1 if outer else 2)


@pytest.mark.parametrize(("name", "d"), [*CUBES, *((f"sommerville-{n}", 3) for n in range(1, 5))])
def test_the_classes_are_all_there_are(name, d):
    """Each cell is congruent to a class: some order of its vertices has the same distances."""
    peer = PEERS[name]
    classes = [[tuple(map(Fraction, v)) for v in simplex.vertices] for simplex in peer.classes(d)]
    shapes = {tuple(pairs(cell)) for cell in classes}
    assert len(shapes) == len(classes)
    assert {tuple(pairs(cell)) for cell in peer.cells(d)} == shapes
    if d == 3:
        for cell in peer.cells(d):
            (model,) = (c for c in classes if pairs(c) == pairs(cell))
            distances = oracle.squared_edges(model)
            assert any(oracle.squared_edges(order) == distances for order in itertools.permutations(cell))


@pytest.mark.parametrize("name", ["K1", "J1", "barycentric"])
@pytest.mark.parametrize("d", range(2, 9))
def test_three_have_the_shape_of_c(name, d):
    (simplex,) = PEERS[name].classes(d)
    ours = triangulation(("C", d)).simplex
    factor = simplex.squared_longest_edge / ours.squared_longest_edge
    n = d + 1
    assert all(
        simplex.squared_edge_lengths[i, j] == factor * ours.squared_edge_lengths[i, j]
        for i in range(n)
        for j in range(n)
    )


def test_d1_and_five_are_mirror_images_for_three_dimensions():
    """Exchanging 0 and 1 in the last coordinate carries one into the other."""
    moved = {frozenset((*p[:2], 1 - p[2]) for p in cell) for cell in PEERS["D1"].cells(3)}
    five = {frozenset(cell) for cell in PEERS["five"].cells(3)}
    assert five in (moved, set(map(frozenset, PEERS["D1"].cells(3))))


def test_d1_has_d_shapes_and_fewer_simplices():
    for d in range(2, 7):
        assert len(PEERS["D1"].classes(d)) == (d if d > 3 else d - 1)
        cells = sum(1 for _ in PEERS["D1"].cells(d))
        assert cells == 1 + sum(math.perm(d, k) for k in range(d - 1))
        assert cells <= math.factorial(d)


# -- fillers of space ----------------------------------------------------------------------------------


@pytest.mark.parametrize("number", range(1, 5))
def test_sommerville_tetrahedra_fill_the_bcc_tetrahedron(number):
    """That one fills space: it has the shape of A~3. The copies share its volume, and do not overlap."""
    cells = list(PEERS[f"sommerville-{number}"].cells(3))
    assert len(cells) == (1, 2, 4, 4)[number - 1]
    assert {oracle.squared_volume(c) * len(cells) ** 2 for c in cells} == {oracle.squared_volume(BCC)}
    rng = Random(number)
    for _ in range(20):
        weights = [Fraction(rng.randint(1, 10**6)) for _ in range(4)]
        x = oracle.combine([w / sum(weights) for w in weights], BCC)
        assert covering(cells, x) == (1, True)
    shapes = {1: "A~3", 2: "B~3", 3: "C~3"}
    if number in shapes:
        ours, theirs = triangulation(shapes[number]).simplex, PEERS[f"sommerville-{number}"].classes(3)[0]
        for name in (*MEASURES, *MESH_MEASURES):
            assert find_measure(name)(ours) == find_measure(name)(theirs)


@pytest.mark.parametrize("q", ["1", "4", "1/4", "9/16", "25"])
@pytest.mark.parametrize("d", [2, 3, 4])
def test_hill_simplices_fill_a_parallelepiped(d, q):
    """The d! copies are congruent, vertex by vertex, and together have the volume √q."""
    peer = find_peer(f"hill:{q}")
    cells = [[tuple(map(Fraction, p)) for p in cell] for cell in peer.cells(d)]
    assert len(cells) == math.factorial(d)
    assert len({tuple(oracle.squared_edges(cell).items()) for cell in cells}) == 1
    assert {oracle.squared_volume(c) * math.factorial(d) ** 2 for c in cells} == {Fraction(q)}
    steps = [oracle.minus(b, a) for a, b in itertools.pairwise(cells[0])]
    rng = Random(d)
    for _ in range(8):
        x = oracle.combine([Fraction(rng.randint(1, 10**6), 10**6 + 3) for _ in range(d)], steps)
        assert covering(cells, x) == (1, True)


@pytest.mark.parametrize("d", range(2, 8))
def test_a_and_k1_belong_to_hill(d):
    for name in (*MEASURES, *MESH_MEASURES):
        measure = find_measure(name)
        ours = measure.normalized(triangulation(("A", d)))
        assert find_peer(f"hill:1/{d + 1}").worst(measure, d) == ours
        assert find_peer("hill:1").worst(measure, d) == PEERS["K1"].worst(measure, d)


@pytest.mark.parametrize("q", ["1", "1/4", "1/3", "7"])
@pytest.mark.parametrize("family", [1, 2, 3])
def test_goldberg_tetrahedra(family, q):
    """The halves are congruent, and half of Hill's."""
    cells = [Simplex(cell) for cell in find_peer(f"goldberg-{family}:{q}").cells(3)]
    (whole,) = find_peer(f"hill:{q}").classes(3)
    assert len(cells) == (1 if family == 1 else 2)
    assert all(cell.volume * len(cells) == whole.volume for cell in cells)
    matrices = [sorted(cell.squared_edge_lengths[i, j] for i in range(4) for j in range(i)) for cell in cells]
    assert all(m == matrices[0] for m in matrices)
    heights = [sorted(cell.squared_heights) for cell in cells]
    assert all(h == heights[0] for h in heights)


def test_the_worst_simplex_counts():
    peer = PEERS["five"]
    middle, corner = peer.classes(3)
    assert thickness.normalized(middle) == 1
    assert peer.worst(thickness, 3) == thickness.normalized(corner) < 1
    measure = find_measure("maximal_dihedral_angle")
    assert peer.worst(measure, 3) == regular_simplex(3).maximal_dihedral_angle / 90


# -- tables, curves, names -----------------------------------------------------------------------------------


def test_a_table_marks_the_best():
    table = measure_table(mean_ratio, 4, peers=DEFAULT, best=True)
    names = [row[0] for row in table.rows]
    assert names[-len(DEFAULT) :] == [peer.name for peer in DEFAULT]
    assert table.render("csv").splitlines()[-1] == "best,A~,A~ = sommerville-1,A~"
    stars = [line.split()[0] for line in table.render("text").splitlines() if "*" in line]
    assert stars == ["A~", "sommerville-1"]
    assert table.render("json").count('"best": true') == 4
    for row in table.rows:
        if row[0] in PEERS:
            for d, cell in enumerate(row[1:], 2):
                assert (cell is None) != PEERS[row[0]].exists(d)


def test_cells_without_a_method_stay_empty():
    table = measure_table(find_measure("minimal_solid_angle"), 6, peers=[PEERS["D1"], PEERS["K1"]])
    rows = {row[0]: row[1:] for row in table.rows}
    assert [x is None for x in rows["D1"]] == [False, False, True, True, True]
    assert rows["K1"] == rows["C~"]
    with pytest.raises(Unavailable):
        PEERS["D1"].worst(find_measure("minimal_solid_angle"), 6)


def test_d1_beside_c_and_a_as_the_page_says():
    for d in range(2, 13):
        a, c = (mean_ratio.normalized(triangulation((letter, d))) for letter in "AC")
        d1 = PEERS["D1"].worst(mean_ratio, d)
        assert a > d1
        assert d1 == c if d == 2 else d1 > c
        if d <= 8:
            assert PEERS["D1"].worst(thickness, d) <= thickness.normalized(triangulation(("C", d)))


def test_curves_take_others_too():
    figure = quality_curves("condition", 6, peers=[PEERS["D1"], PEERS["five"], PEERS["sixteen"]])
    assert [curve.family for curve in figure.data.peers] == ["D1", "five", "sixteen"]
    assert dict(figure.data.peers[0].values)[3] == PEERS["D1"].worst(find_measure("condition"), 3)
    assert "D1: " in figure.alt
    assert "five: 0.816 in dimension 3" in figure.alt
    assert math.isfinite(figure.draw().height)
    assert not quality_curves("condition", 2, peers=[PEERS["five"]]).data.peers


@pytest.mark.parametrize(
    "name", ["K2", "hill", "hill:", "hill:-1", "hill:0", "hill:x", "goldberg-4:1", "K1:2", ""]
)
def test_names_that_there_are_not(name):
    with pytest.raises(InvalidInput):
        find_peer(name)


def test_dimensions_that_there_are_not():
    with pytest.raises(InvalidInput, match="five has no dimension 4: give d = 3"):
        PEERS["five"].classes(4)
    with pytest.raises(InvalidInput, match="D1 has no dimension 1: give 2 <= d"):
        PEERS["D1"].classes(1)
    assert find_peer("hill:1/3") is find_peer("hill:2/6")
    assert find_peer("hill:2").classes(3)[0].volume == sqrt(2) / 6
