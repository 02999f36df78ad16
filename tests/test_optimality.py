"""Affine images and other triangulations of space, each number by a second route, wrong claims refuted."""

from collections import Counter
from fractions import Fraction
from itertools import combinations, pairwise, permutations, product
from math import factorial

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from coxeter import (
    MEASURES,
    InvalidInput,
    RationalMatrix,
    Simplex,
    Surd,
    Undecided,
    measure,
    protection,
    regular_simplex,
    triangulation,
    triangulations_up_to,
)
from coxeter.figures import hill_curves
from coxeter.optimality import (
    A15,
    BCC,
    C15,
    Crystal,
    Verdict,
    affine_image,
    crystal_directions,
    crystal_gradient_rank,
    directions,
    gradient_rank,
    halves,
    hill,
    local_optimality,
    part_around_centre,
)
from coxeter.peers import find_peer
from coxeter.proofs.images import examples, mean_by_sum

PAPER = ("aspect_ratio", "fatness", "thickness", "radius_ratio")
TYPES = [kind.affine for kind in triangulations_up_to(3)]
FOUR = ["A~4", "B~4", "C~4", "D~4", "F~4"]


def kuhn(d):
    return affine_image(("A", d), hill(d, 0))


def image(name, gram):
    """An affine image from the products of its edges."""
    return type(affine_image(name))(triangulation(name), gram)


@st.composite
def images(draw, names=TYPES):
    """An image by a matrix with small entries."""
    t = triangulation(draw(st.sampled_from(names)))
    n = t.simplex.vertex_matrix.shape[1]
    entry = st.integers(-3, 3).map(lambda x: Fraction(x, 4))
    rows = draw(st.lists(st.lists(entry, min_size=n, max_size=n), min_size=n, max_size=n))
    m = RationalMatrix.from_rows([[x + (i == j) for j, x in enumerate(row)] for i, row in enumerate(rows)])
    vertices = (t.simplex.vertex_matrix @ m).rows()
    edges = RationalMatrix.from_rows(
        [[x - y for x, y in zip(v, vertices[0], strict=True)] for v in vertices[1:]]
    )
    assume(edges.rank() == t.dimension)
    return affine_image(t.name, Simplex(vertices)), m


def qualities_by_vertices(t, m):
    """The qualities of an image, from the coordinates of all simplices around the origin."""
    start = frozenset(t.simplex.vertex_matrix.rows())
    seen, new = {start}, [start]
    while new:
        cells = {frozenset(f.reflect(v) for v in cell) for cell in new for f in t.facets[1:]} - seen
        seen |= cells
        new = list(cells)
    moved = [Simplex((RationalMatrix.from_rows(sorted(cell)) @ m).rows()) for cell in seen]
    return len(seen), {name: min(MEASURES[name](s) for s in moved) for name in PAPER}


# -- affine images -----------------------------------------------------------------------------------------


@given(images())
@settings(max_examples=12, deadline=None)
def test_quality_is_that_of_all_simplices_around_a_vertex(pair):
    found, m = pair
    count, qualities = qualities_by_vertices(found.triangulation, m)
    assert count == found.triangulation.roots.weyl_group_order
    assert {name: found.quality(name) for name in PAPER} == qualities


@given(images())
@settings(max_examples=25, deadline=None)
def test_no_image_is_better_than_the_triangulation(pair):
    found, _ = pair
    for name in PAPER:
        value, best = found.quality(name), MEASURES[name](found.triangulation.simplex)
        assert value <= best
        verdict = local_optimality(found, name)
        assert verdict.best == best
        assert verdict.verdict is (Verdict.PROVED if value == best else Verdict.REFUTED)


@given(images(["A~2", "A~3"]))
@settings(max_examples=25, deadline=None)
def test_of_a_only_similar_images_are_as_good(pair):
    found, _ = pair
    similar = found.gram == found.mean.gram
    assert {(found.quality(name) == found.mean.quality(name)) for name in PAPER} == {similar}
    assert (found.relative_protection == found.mean.relative_protection) == similar


@pytest.mark.parametrize("name", [*TYPES, *FOUR])
@pytest.mark.parametrize("of", PAPER)
def test_every_coxeter_triangulation_is_proved_optimal(name, of):
    assert local_optimality(affine_image(name), of).verdict is Verdict.PROVED


@pytest.mark.parametrize("name", [*TYPES, "A~4", "D~4"])
@pytest.mark.parametrize("of", PAPER)
def test_a_perturbed_triangulation_is_refuted_with_a_better_witness_close_by(name, of):
    home = triangulation(name)
    (step, *_) = examples(home.dimension, 1)
    rows = zip(home.simplex.edge_gram.rows(), step.rows(), strict=True)
    near = RationalMatrix.from_rows([[100 * x + y for x, y in zip(a, b, strict=True)] for a, b in rows])
    found = local_optimality(image(name, near), of, near="1/10000")
    assert found.verdict is Verdict.REFUTED
    assert found.value < found.witness.quality(of) < found.best
    pairs = zip(found.witness.gram.rows(), near.rows(), strict=True)
    apart = [abs(x - y) for a, b in pairs for x, y in zip(a, b, strict=True)]
    assert max(apart) * 1000 < max(map(max, near.rows()))


@pytest.mark.parametrize("d", [3, 4])
@pytest.mark.parametrize("of", [*PAPER, "relative_protection"])
def test_kuhn_is_not_locally_optimal(d, of):
    found = local_optimality(kuhn(d), of)
    assert found.verdict is Verdict.REFUTED
    better = found.witness.relative_protection if of == "relative_protection" else found.witness.quality(of)
    assert found.value < better < found.best


def test_the_way_to_the_mean_climbs():
    values = [[kuhn(3).towards_mean(Fraction(k, 8)).quality(of) for k in range(9)] for of in PAPER]
    assert all(a < b for row in values for a, b in pairwise(row))


@pytest.mark.parametrize("name", [*TYPES, "A~4", "D~4"])
def test_mean_by_the_trace_is_the_mean_of_the_orbit(name):
    for gram in examples(triangulation(name).dimension, 3):
        assert mean_by_sum(image(name, gram)) == image(name, gram).mean.gram


def test_of_an_unknown_measure_nothing_is_claimed():
    @measure("ratio of edges")
    def ratio(simplex):
        return Surd(simplex.squared_shortest_edge / simplex.squared_longest_edge)

    found = local_optimality(affine_image("A~3"), ratio)
    del MEASURES["ratio of edges"]
    assert (found.verdict, found.witness) == (Verdict.UNDECIDED, None)


@pytest.mark.parametrize("near", ["1/1000", 1])
def test_unprotected_all_around_is_undecided(near):
    far = image("A~2", RationalMatrix.from_rows([[1, 5], [5, 26]]))
    assert far.least_weight < far.relative_protection == 0
    assert local_optimality(far, "relative_protection", near).verdict is Verdict.UNDECIDED


def test_refusals():
    with pytest.raises(InvalidInput, match="dimension 2"):
        affine_image("A~3", regular_simplex(2))
    with pytest.raises(InvalidInput, match="no share"):
        kuhn(3).towards_mean(2)
    with pytest.raises(InvalidInput, match="no share"):
        local_optimality(kuhn(3), "fatness", near=0)
    with pytest.raises(InvalidInput, match="no quality measure"):
        local_optimality(kuhn(3), "beauty")
    with pytest.raises(InvalidInput, match="only images of A~"):
        _ = affine_image("C~3").relative_protection
    with pytest.raises(InvalidInput, match="no coordinates"):
        _ = part_around_centre(hill(3, "-1/3")).vertex_matrix
    with pytest.raises(Undecided, match="too many"):
        affine_image("E~8").quality("thickness")


# -- protection of images ------------------------------------------------------------------------------------


def protection_by_search(found, reach=3):
    """The relative protection from all vertices near the simplices around the origin."""
    d, b = found.triangulation.dimension, found.superbase
    gram = RationalMatrix(b.numerators[1:, 1:], b.denominator)
    points = list(product(range(-reach, reach + 1), repeat=d))
    least = []
    for s in all_orders(d):
        v = [tuple(int(j in s[:k]) - int(0 in s[:k]) for j in range(1, d + 1)) for k in range(d + 1)]
        edges = RationalMatrix.from_rows([[x - y for x, y in zip(p, v[0], strict=True)] for p in v[1:]])
        simplex = Simplex.from_gram_pair(None, edges @ gram @ edges.T, None, None)
        inverse = simplex.edge_gram.inverse()
        weights = RationalMatrix.from_rows([[simplex.edge_gram[i, i] / 2 for i in range(d)]]) @ inverse
        centre = (weights @ edges).row(0)
        far = {p: norm(gram, [x - y for x, y in zip(p, centre, strict=True)]) for p in points}
        square = far[v[0]]
        least.append(min(x for p, x in far.items() if p not in v) / square)
    return min(least)


def all_orders(d):
    return [(0, *order) for order in permutations(range(1, d + 1))]


def norm(gram, x):
    row = RationalMatrix.from_rows([x])
    return (row @ gram @ row.T)[0, 0]


@pytest.mark.parametrize("d", [2, 3])
def test_relative_protection_is_that_of_all_vertices_nearby(d):
    tried = 0
    for gram in examples(d, 12):
        found = image(("A", d), gram).towards_mean("3/5")
        if found.relative_protection:
            tried += 1
            assert (found.relative_protection + 1) ** 2 == protection_by_search(found)
    assert tried >= 2


@pytest.mark.parametrize("d", range(2, 7))
def test_relative_protection_of_a_itself(d):
    assert affine_image(("A", d)).relative_protection == protection(triangulation(("A", d))).relative


@given(st.lists(st.integers(1, 9), min_size=10, max_size=10), st.sampled_from([2, 3]))
@settings(max_examples=15, deadline=None)
def test_powers_of_an_image_from_its_weights(weights, d):
    """Random obtuse superbases, against the search; a negative weight takes protection away."""

    def from_weights(p):
        b = [[sum(p[i]) if i == j else -p[i][j] for j in range(d + 1)] for i in range(d + 1)]
        sums = RationalMatrix.from_rows([[int(1 <= j <= i) for j in range(d + 1)] for i in range(1, d + 1)])
        return image(("A", d), sums @ RationalMatrix.from_rows(b) @ sums.T)

    p = [[0] * (d + 1) for _ in range(d + 1)]
    for (i, j), x in zip(combinations(range(d + 1), 2), weights, strict=False):
        p[i][j] = p[j][i] = Fraction(x)
    assert (from_weights(p).relative_protection + 1) ** 2 == protection_by_search(from_weights(p))
    p[0][1] = p[1][0] = Fraction(-1, 9)
    assert from_weights(p).relative_protection == 0
    assert protection_by_search(from_weights(p)) < 1


# -- sharpness -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("d", range(2, 7))
def test_ranks_of_a(d):
    whole = directions(d)
    assert gradient_rank(("A", d), "thickness") == whole
    assert gradient_rank(("A", d), "aspect_ratio") == whole
    assert gradient_rank(("A", d), "fatness") == (whole if d % 2 == 0 else whole - d)
    assert gradient_rank(("A", d), "radius_ratio") == whole - d


def test_rank_tells_linear_from_slower_descent():
    """In A~3 the form p_01 + t, p_23 - t, say, is missed by no gradient; moving weight to one vertex is."""
    home = affine_image("A~3")
    b = home.superbase

    def loss(weights, of, t):
        p = [[b[i, j] * (1 + t * weights(i, j)) if i != j else 0 for j in range(4)] for i in range(4)]
        rows = [[-sum(p[i]) if i == j else p[i][j] for j in range(4)] for i in range(4)]
        sums = RationalMatrix.from_rows([[int(1 <= j <= i) for j in range(4)] for i in range(1, 4)])
        moved = image("A~3", sums @ RationalMatrix.from_rows(rows) @ sums.T)
        return float(home.quality(of)) - float(moved.quality(of))

    def to_vertex(i, j):
        return int(0 in (i, j)) - int(0 not in (i, j))

    def to_pair(i, j):
        return int({i, j} in ({0, 1}, {2, 3})) - int({i, j} in ({0, 2}, {1, 3}))

    small, smaller = Fraction(1, 1000), Fraction(1, 10000)
    for of, weights, order in [
        ("thickness", to_vertex, 1),
        ("fatness", to_vertex, 2),
        ("radius_ratio", to_vertex, 2),
        ("fatness", to_pair, 1),
        ("radius_ratio", to_pair, 1),
    ]:
        assert loss(weights, of, small) / loss(weights, of, smaller) == pytest.approx(10**order, rel=0.05)


def test_c2_may_be_stretched_along_a_leg_but_not_along_a_hypotenuse():
    """The first costs nothing to first order, the second does."""
    vertices = triangulation("C~2").simplex.vertex_matrix
    home = float(affine_image("C~2").quality("thickness"))

    def loss(rows):
        moved = affine_image("C~2", Simplex((vertices @ RationalMatrix.from_rows(rows)).rows()))
        return (home - float(moved.quality("thickness"))) * 1000

    t = Fraction(1, 1000)
    along_leg, along_hypotenuse = [[1 + t, 0], [0, 1]], [[1 + t, t], [t, 1 + t]]
    assert loss(along_leg) < 0.001
    assert loss(along_hypotenuse) > 0.9


def test_ranks_that_are_refused():
    with pytest.raises(InvalidInput, match="no gradients"):
        gradient_rank("A~3", "beauty")
    with pytest.raises(Undecided, match="not rational"):
        gradient_rank("C~3", "radius_ratio")


# -- other simplices that fill space -----------------------------------------------------------------------


def shape(simplex):
    squares = simplex.squared_edge_lengths
    return [squares[i, j] / squares[0, 1] for i, j in combinations(range(simplex.dimension + 1), 2)]


@pytest.mark.parametrize("d", range(2, 8))
def test_hill_simplices_of_two_families(d):
    assert shape(hill(d, Fraction(-1, d))) == shape(triangulation(("A", d)).simplex)
    assert shape(hill(d, 0)) == shape(triangulation(("C", d)).simplex)


@pytest.mark.parametrize("d", [2, 3, 4, 5])
def test_no_hill_simplex_and_none_of_its_halves_is_better(d):
    a = hill(d, Fraction(-1, d))
    for w in (Fraction(-1, d - 1) + Fraction(d * k, 20 * (d - 1)) for k in range(1, 20)):
        here = hill(d, w)
        for of in PAPER:
            known = MEASURES[of]
            assert known(here) < known(a) or w == Fraction(-1, d)
            assert all(known(half) < known(a) for half in halves(here).values())


@given(st.integers(2, 7), st.fractions(0, 1, max_denominator=60))
def test_no_half_is_as_thick_or_as_fat_for_any_cosine(d, share):
    """The steps of the proof in the chapter on the conjectures, and what follows from them."""
    assume(0 < share < 1)
    w = (share * d - 1) / (d - 1)
    whole, a = hill(d, w), hill(d, Fraction(-1, d))
    steps = [s * (1 + (s - 1) * w) for s in range(d + 1)]
    for (i, k), half in halves(whole).items():
        heights = list(whole.squared_heights)
        assert half.squared_heights[k] * 4 == heights[k] == heights[i]
        assert all(half.squared_heights[j] == heights[j] for j in range(d + 1) if j not in (i, k))
        assert all(heights[j] * 2 == (1 - w) * whole.squared_edge_lengths[0, 1] for j in range(1, d))
        short = half.squared_longest_edge < whole.squared_longest_edge
        assert not short or (i == 0 and steps[d] > steps[d - 1])
        assert half.squared_longest_edge >= steps[d - 1] * whole.squared_edge_lengths[0, 1] or i
        for of in ("thickness", "fatness"):
            assert MEASURES[of](half) < MEASURES[of](a)


RANKS = {
    (BCC, "fatness"): (5, 8), (BCC, "aspect_ratio"): (8, 8), (BCC, "thickness"): (8, 8),
    (A15, "fatness"): (26, 26), (A15, "aspect_ratio"): (13, 26), (A15, "thickness"): (24, 26),
    (C15, "fatness"): (74, 74), (C15, "aspect_ratio"): (74, 74), (C15, "thickness"): (74, 74),
}  # fmt: skip


@pytest.mark.parametrize(("crystal", "of"), RANKS, ids=lambda x: getattr(x, "name", x))
def test_where_crystals_are_peaks(crystal, of):
    assert (crystal_gradient_rank(crystal, of), crystal_directions(crystal)) == RANKS[crystal, of]


@given(st.lists(st.tuples(*[st.integers(-3, 3)] * 3), min_size=8, max_size=8))
def test_no_small_move_of_its_atoms_makes_a15_fatter(moves):
    """A second route to the full rank: the moved crystal, judged exactly."""
    assume(len(set(moves)) > 1)
    atoms = [
        tuple(100 * x + m for x, m in zip(atom, move, strict=True))
        for atom, move in zip(A15.atoms, moves, strict=True)
    ]
    moved = Crystal("A15, moved", 400, tuple(atoms))
    assert moved.quality("fatness") < A15.quality("fatness")


def test_ranks_of_crystals_that_are_refused():
    with pytest.raises(InvalidInput, match="no gradients"):
        crystal_gradient_rank(A15, "evenness")
    others = [tuple(10 * x for x in atom) for atom in A15.atoms[1:]]
    askew = Crystal("A15, moved", 40, ((1, 0, 0), *others))
    for crystal, of in ((askew, "fatness"), (C15, "radius_ratio")):
        with pytest.raises(Undecided):
            crystal_gradient_rank(crystal, of)


def test_the_best_half_is_not_that_of_a():
    """The mean over the finite Weyl group says nothing of halves."""
    known, (ours,) = MEASURES["thickness"], halves(hill(2, "-1/2")).values()
    assert any(known(half) > known(ours) for w in ("-1/4", 0, "1/4") for half in halves(hill(2, w)).values())


@pytest.mark.parametrize("d", [2, 3, 4])
def test_a_hill_triangulation_is_an_affine_image_with_congruent_simplices(d):
    found = affine_image(("A", d), hill(d, "1/5"))
    lengths = {tuple(sorted(map(tuple, map(sorted, s.squared_edge_lengths.rows())))) for s in found.simplices}
    assert len(lengths) == 1


@pytest.mark.parametrize("d", [2, 3, 4, 5])
def test_parts_have_their_share_of_the_volume(d):
    a = hill(d, Fraction(-1, d))
    assert part_around_centre(a).volume * (d + 1) == a.volume
    assert all(half.volume * 2 == a.volume for half in halves(a).values())
    assert len(halves(a)) == (d + 1) // 2


@pytest.mark.parametrize(("w", "q"), [("-1/3", "1/4"), (0, "1"), ("1/3", "5/2")])
def test_halves_in_space_are_the_families_of_goldberg(w, q):
    def lengths(simplex):
        return Counter(simplex.squared_edge_lengths[i, j] for i, j in combinations(range(4), 2))

    found = halves(hill(3, w))
    for family, pair in ((2, (0, 3)), (3, (1, 2))):
        half, theirs = found[pair], find_peer(f"goldberg-{family}:{q}").classes(3)[0]
        assert lengths(half) == lengths(theirs)
        assert half.squared_circumradius == theirs.squared_circumradius


@pytest.mark.parametrize("d", [2, 3, 5])
def test_hill_curves_have_their_greatest_value_at_a(d):
    figure = hill_curves(d)
    assert {figure.data.best(of) for of in PAPER} == {Fraction(-1, d)}
    assert figure.alt.count(f"at w = -1/{d}") == 4
    assert figure.svg.count("<path") >= 4
    for wrong in (1, "3"):
        with pytest.raises(InvalidInput, match="no dimension"):
            hill_curves(wrong)


def test_fillers_that_are_refused():
    for d, w in [(1, 0), (3, 1), (3, "-1/2"), ("3", 0)]:
        with pytest.raises(InvalidInput):
            hill(d, w)
    with pytest.raises(InvalidInput, match="backwards"):
        halves(Simplex([(0, 0), (1, 0), (0, 2)]))
    with pytest.raises(InvalidInput, match="turned"):
        part_around_centre(hill(3, 0))


# -- crystals ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("crystal", "cells", "kinds"), [(BCC, 12, 1), (A15, 46, 3), (C15, 136, 3)])
def test_crystals_are_triangulations(crystal, cells, kinds):
    assert (len(crystal.cells), len(crystal.kinds)) == (cells, kinds)
    volume = sum((n * s.volume for s, n in crystal.kinds.items()), Surd(0))
    assert volume == crystal.period**3
    facets = Counter(
        facet
        for cell in crystal.cells
        for facet in (up_to_translation(f, crystal.period) for f in combinations(cell, 3))
    )
    assert set(facets.values()) == {2}


def up_to_translation(points, period):
    """Points moved by periods so that their centre of mass, times three, lies in the first one."""
    moves = [sum(x) // (len(points) * period) * period for x in zip(*points, strict=True)]
    return frozenset(tuple(x - m for x, m in zip(p, moves, strict=True)) for p in points)


def test_bcc_is_a3():
    a = triangulation("A~3")
    assert {of: BCC.quality(of) for of in PAPER} == {of: MEASURES[of](a.simplex) for of in PAPER}
    assert BCC.relative_protection == protection(a).relative


def test_what_the_crystals_show():
    """The comparison with A~3: fatness, thickness, aspect ratio, radius ratio, protection."""

    def sign(crystal, of):
        return (crystal.quality(of) - BCC.quality(of)).sign()

    assert [sign(A15, of) for of in PAPER] == [-1, 1, 0, 0]
    assert [sign(C15, of) for of in PAPER] == [-1, 1, 0, 1]
    assert A15.relative_protection < C15.relative_protection < BCC.relative_protection


@pytest.mark.parametrize("crystal", [A15, C15])
def test_values_of_crystals_by_floats(crystal):
    cells = np.array(crystal.cells, dtype=float)
    volumes = np.abs(np.linalg.det(cells[:, 1:] - cells[:, :1])) / factorial(3)
    longest = np.linalg.norm(cells[:, :, None] - cells[:, None], axis=3).max(axis=(1, 2))
    assert float(crystal.quality("fatness")) == pytest.approx((volumes / longest**3).min())


def test_spheres_with_too_many_atoms_are_refused():
    fcc = Crystal("face-centred cubic", 2, ((0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 0)))
    with pytest.raises(InvalidInput, match="not all simplices"):
        _ = fcc.cells
    with pytest.raises(InvalidInput, match="not all simplices"):
        _ = Crystal("A15 without an atom", 4, A15.atoms[1:]).cells


def test_large_periods_are_exact():
    """Products beyond 64 bits: an atom is moved by a few parts in a hundred thousand."""
    scale = 10**5
    _, *others = (tuple(scale * x for x in atom) for atom in A15.atoms)
    near = Crystal("A15, nearly", 4 * scale, ((1, 2, 3), *others))
    assert len(near.cells) == len(A15.cells)
    assert 0 < float(A15.relative_protection) - float(near.relative_protection) < 1e-4


def test_atoms_may_be_given_in_any_period():
    far = Crystal("A15", 4, tuple(tuple(x + 40 * (x % 2) - 8 for x in atom) for atom in A15.atoms))
    assert list(far.kinds.values()) == list(A15.kinds.values())
    assert far.relative_protection == A15.relative_protection


@pytest.mark.parametrize(("crystal", "acute"), [(BCC, False), (A15, True), (C15, True)])
def test_tetrahedra_of_the_alloys_are_acute(crystal, acute):
    """As Eppstein, Sullivan and Üngör have it; those of A~3 have right angles."""
    cosines = [s.dihedral_cosine(i, j).sign() for s in crystal.kinds for i, j in combinations(range(4), 2)]
    assert (min(cosines) > 0) == acute


def test_crystals_that_are_refused():
    for period, atoms in [(0, ((0, 0, 0),)), (2, ()), (2, ((0, 0), (1, 1, 1))), (2, ((0.5, 0, 0),))]:
        with pytest.raises(InvalidInput):
            Crystal("bad", period, atoms)
    with pytest.raises(InvalidInput, match="not all simplices"):
        _ = Crystal("cubic", 1, ((0, 0, 0),)).cells


def test_a_moved_atom_changes_what_is_found():
    moved = Crystal(
        "A15, moved", 40, (*(tuple(10 * x for x in atom) for atom in A15.atoms[:-1]), (20, 1, 30))
    )
    assert moved.quality("fatness") < A15.quality("fatness")
