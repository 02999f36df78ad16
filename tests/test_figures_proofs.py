"""The proof pictures and the witnesses: what they plot and say is computed in other ways here."""

import math
from fractions import Fraction
from functools import cache
from itertools import combinations, islice, product

import pytest

import coxeter
from coxeter import InexactInput, InvalidInput, Simplex, root_system, triangulation
from coxeter.figures import (
    angle_classes,
    difference_not_a_vertex,
    lemma_4_circles,
    lemma_4_witness,
    lemma_9_distances,
    lemma_10_plane,
    lemma_10_witness,
    paper_figure,
    proposition_1_witness,
    protection_spheres,
    sphere_not_empty,
)
from coxeter.figures import canvas as style
from coxeter.figures.canvas import Disc, Path
from coxeter.figures.space import View, great_circle
from coxeter.figures.written import formula, words

# -- in other ways ----------------------------------------------------------------------------------------


def inner(p, q):
    return sum(a * b for a, b in zip(p, q, strict=True))


def minus(p, q):
    return tuple(a - b for a, b in zip(p, q, strict=True))


def square(p, q):
    return inner(minus(p, q), minus(p, q))


def mirrored(x, normal, offset=0):
    share = 2 * (inner(x, normal) - offset) / Fraction(inner(normal, normal))
    return tuple(a - share * b for a, b in zip(x, normal, strict=True))


def facet_image(t, k):
    """The mirror image of u_k in the facet opposite to it, from the definition of the simplex."""
    u = t.simplex.vertex_matrix.row(k)
    return mirrored(u, t.roots.highest_root, 1) if k == 0 else mirrored(u, t.roots.simple_roots.row(k - 1))


# -- angles -----------------------------------------------------------------------------------------------

COSINES = {0: 1, 30: Fraction(3, 4), 45: Fraction(1, 2), 60: Fraction(1, 4), 90: 0}


@pytest.mark.parametrize(("name", "count"), [("A2", 6), ("B2", 8), ("C2", 8), ("G2", 12)])
def test_angles_lengths_and_integers_are_those_of_the_vectors(name, count):
    data = angle_classes(name).data
    r, roots = data.seen_from, root_system(name).roots.rows()
    assert {s.root for s in data.roots} | {r} == set(roots)
    assert len(data.roots) == count - 1
    assert inner(r, r) == min(inner(s, s) for s in roots)
    for s, angle, ratio, n_sr, n_rs in data.roots:
        degrees, product_ = 180 * angle, inner(r, s)
        assert product_**2 / (inner(r, r) * inner(s, s)) == COSINES[min(degrees, 180 - degrees)]
        assert (product_ < 0) == (degrees > 90)
        assert ratio**2 == inner(s, s) / inner(r, r)
        assert (n_sr, n_rs) == (2 * product_ / inner(r, r), 2 * product_ / inner(s, s))
        x, y = data.window.pixel(s)
        assert abs(math.degrees(math.atan2(-y, x))) == pytest.approx(float(degrees))
    assert [s.angle for s in data.roots] == sorted(s.angle for s in data.roots)
    assert {(row.n_sr, row.n_rs) for row in data.classes} >= {(s.n_sr, s.n_rs) for s in data.roots}


def test_the_words_of_the_angles():
    figure = angle_classes("G2")
    assert "30°: 2 of length √3|r|, n(s, r) = 3, n(r, s) = 1" in figure.alt
    assert "180°: 1 of length |r|, n(s, r) = -2, n(r, s) = -2." in figure.alt
    assert "45°" not in figure.alt
    with pytest.raises(InvalidInput, match="only rank 2"):
        angle_classes("A3")


# -- a sphere that is not empty, and protection -----------------------------------------------------------


def test_a_vertex_lies_inside_the_sphere():
    figure, t = sphere_not_empty(), triangulation("B~3")
    data, section = figure.data
    assert data.simplex == t.simplex.vertex_matrix.rows()
    assert {square(u, data.circumcentre) for u in data.simplex} == {data.squared_circumradius}
    assert data.inside == facet_image(t, data.facet)
    assert t.is_vertex_by_rank(data.inside)
    assert square(data.inside, data.circumcentre) == data.squared_distance < data.squared_circumradius
    assert "distance 1/4 from c" in figure.alt
    assert "R = √5/4" in figure.alt
    assert "1 inside, 2 on the circle" in figure.alt
    assert section.sphere == data


def test_the_section_shows_the_vertices_and_the_lines_of_its_plane():
    t, section = triangulation("B~3"), sphere_not_empty().data[1]
    quarters = [Fraction(n, 4) for n in range(-4, 9)]
    points = [(x, Fraction(0), z) for x, z in product(quarters, quarters)]
    shown = {p for p in points if section.window.contains(p) and t.is_vertex_by_rank(p)}
    assert set(section.vertices) == shown
    assert {v[1] for v in (section.sphere.inside, section.sphere.circumcentre)} == {0}
    for line in section.lines:  # each is in a mirror, and no line through two vertices of a mirror is missing
        roots = [r for r in t.roots.positive_roots.rows() if (r[0], r[2]) == (line.root[0], line.root[2])]
        assert roots
    for r in t.roots.positive_roots.rows():
        for k in range(-3, 4):
            crosses = {inner(r, (x, 0, z)) > k for x in (-0.19, 1.19) for z in (-0.44, 0.94)}
            trace = ((r[0], Fraction(0), r[2]), k)
            if len(crosses) == 2:
                assert trace in section.lines


def test_pictures_of_spheres_are_to_scale():
    section = sphere_not_empty().parts[1]
    (circle,) = [d for d in section.draw().shapes if isinstance(d, Disc) and d.radius > 50]
    dots = [d for d in section.draw().shapes if isinstance(d, Disc) and d.fill and d.radius < 9]
    distances = sorted(math.dist(d.centre, circle.centre) / circle.radius for d in dots)
    ratio = math.sqrt(section.data.sphere.squared_distance / section.data.sphere.squared_circumradius)
    assert distances[:4] == pytest.approx([ratio, ratio, 1, 1])  # the vertex inside is marked besides
    assert distances[4] > 1.1  # in the legend
    for name in ("A~2", "A~3"):
        figure = protection_spheres(name)
        inner_, outer = sorted(
            d.radius for d in figure.draw().shapes if isinstance(d, Disc) and d.radius > 30
        )
        assert outer / inner_ - 1 == pytest.approx(float(figure.data.relative))


@pytest.mark.parametrize("name", ["A~2", "C~2", "G~2", "A~3", "C~3"])
def test_the_protecting_sphere_goes_through_the_nearest_other_vertices(name):
    t, figure = triangulation(name), protection_spheres(name)
    data, d = figure.data, t.dimension
    assert {square(u, data.circumcentre) for u in data.simplex} == {data.squared_circumradius}
    others = [(q, v) for q, v in islice(coxeter.vertices_by_distance(t), 60) if v not in data.simplex]
    least = others[0][0]
    assert data.squared_distance == least
    assert {v for _, v in data.nearest} <= {v for q, v in others if q == least}
    assert all(v == facet_image(t, k) for k, v in data.nearest)
    if data.absolute:
        assert {v for _, v in data.nearest} == {v for q, v in others if q == least}
    radius = coxeter.sqrt(data.squared_circumradius)
    assert data.absolute == coxeter.sqrt(least) - radius
    assert data.relative == data.absolute / radius
    assert ("protection is 0" in figure.alt) == (name not in ("A~2", "A~3"))
    assert ("circle" if d == 2 else "sphere") in figure.alt


def test_the_words_of_protection():
    assert "δ = √13/4 - √5/4, and δ/R = √65/5 - 1, about 0.612" in protection_spheres("A~3").alt
    assert "δ = √2/3, and δ/R = 1, about 1.000" in protection_spheres("A~2").alt
    with pytest.raises(InvalidInput, match="not Delaunay"):
        protection_spheres("B~3")
    with pytest.raises(InvalidInput, match="dimension 2 or 3"):
        protection_spheres("A~4")


def test_one_of_the_nearest_is_seen_in_true_distance():
    figure = protection_spheres("A~3")
    shapes = figure.draw().shapes
    outer = max((d for d in shapes if isinstance(d, Disc)), key=lambda d: d.radius)
    dots = [d for d in shapes if isinstance(d, Disc) and d.fill == style.PURPLE]
    distances = [math.dist(d.centre, outer.centre) for d in dots]
    assert len(dots) == 4
    assert max(distances) == pytest.approx(outer.radius)


# -- a difference that is no vertex -----------------------------------------------------------------------


def test_the_difference_is_no_vertex():
    figure, t = difference_not_a_vertex(), triangulation("G~2")
    data = figure.data
    u = t.simplex.vertex_matrix.rows()
    assert data.simplex == u
    assert data.difference == minus(u[data.first], u[data.second])
    assert not t.is_vertex_by_rank(data.difference)
    whole = [r for r in t.roots.positive_roots.rows() if inner(r, data.difference).denominator == 1]
    assert len(whole) == data.through < 2
    assert data.window.contains(data.difference)
    for vertex, k in data.vertices:
        assert t.is_vertex_by_rank(vertex)
        assert t.fold(vertex).point == u[k]
    assert "u_2 - u_1 = (-1/6, 1/6, 0), and only one of the lines passes through that point" in figure.alt


def test_all_vertices_in_the_window_are_shown():
    data = difference_not_a_vertex().data
    found = set()
    for (r, k), (s, m) in combinations(data.lines, 2):
        rr, rs, ss = inner(r, r), inner(r, s), inner(s, s)
        if determinant := rr * ss - rs * rs:
            a, b = (k * ss - m * rs) / determinant, (m * rr - k * rs) / determinant
            found.add(tuple(a * x + b * y for x, y in zip(r, s, strict=True)))
    assert {x for x in found if data.window.contains(x)} == {v for v, _ in data.vertices}


@pytest.mark.parametrize(("name", "why"), [("A~2", "lattice"), ("C~2", "lattice"), ("B~3", "rank 3")])
def test_lattices_have_no_such_difference(name, why):
    with pytest.raises(InvalidInput, match=why):
        difference_not_a_vertex(name)


# -- Appendix A -------------------------------------------------------------------------------------------


def test_the_distances_of_lemma_9():
    figure = lemma_9_distances()
    data = figure.data
    v, p = data.simplex, data.p
    area2 = (v[1][0] - v[0][0]) * (v[2][1] - v[0][1]) - (v[1][1] - v[0][1]) * (v[2][0] - v[0][0])
    for i, (h, r, f, to) in enumerate(
        zip(data.heights, data.distances, data.facets, data.to_vertices, strict=True)
    ):
        a, b = (v[k] for k in range(3) if k != i)
        side = minus(b, a)
        assert f * f == square(a, b)
        assert f * h == area2
        cross = side[0] * (p[1] - a[1]) - side[1] * (p[0] - a[0])
        assert f * r == abs(cross)
        feet = Fraction(inner(minus(v[i], p), side)) / inner(side, side)  # along the side
        assert to * to == square(p, v[i]) == (h - r) ** 2 + feet * feet * inner(side, side)
    assert sum(f * r for f, r in zip(data.facets, data.distances, strict=True)) == area2 == 168
    assert "the sum of all F_i r_i is 168, twice the area" in figure.alt
    assert "h_i - r_i = 9" in figure.alt


def test_the_obtuse_triangle_of_lemma_10():
    figure = lemma_10_plane()
    data = figure.data
    (end, other), p = data.facet, data.p
    assert inner(minus(end, p), minus(other, p)) < 0  # obtuse at p
    assert {square(x, data.circumcentre) for x in (end, other, p)} == {data.squared_circumradius}
    assert data.circumcentre[1] < 0 < p[1]
    assert data.foot == (p[0], 0)
    assert data.squared_longest == square(end, p) > square(other, p)
    assert 2 * data.squared_height < data.squared_longest
    assert "h²/L² = 9/34, less than 1/2" in figure.alt


def test_the_witness_against_any_separating_facet():
    figure = lemma_10_witness()
    data, corners = figure.data, (*figure.data.floor, figure.data.p)
    assert len({square(x, data.circumcentre) for x in corners}) == 1
    assert data.circumcentre[2] < 0 < data.p[2]
    assert {square(x, data.centre) for x in data.floor} == {data.squared_radius}
    assert data.share == Simplex(corners).circumcentre_coordinates[3] < 0
    assert data.squared_steps == tuple(square(data.foot, v) for v in data.floor)
    assert data.squared_edges == tuple(square(data.p, v) for v in data.floor)
    assert all(step < data.squared_height for step in data.squared_steps)
    assert 2 * data.squared_height > max(data.squared_edges)
    assert "h²/L² = 9/14, more than 1/2" in figure.alt
    assert figure.parts[1].alt.startswith("The floor from above: an obtuse triangle")
    others = [v for k, v in enumerate(data.floor) if k != data.end]
    end = data.floor[data.end]
    ray = minus(data.foot, end)
    sides = [ray[0] * (v[1] - end[1]) - ray[1] * (v[0] - end[0]) for v in others]
    assert sides[0] * sides[1] > 0  # so the line through v and f meets the floor in v only


def test_the_simplex_is_that_of_the_ledger():
    from coxeter.ledger.appendix_a_samples import SPIKE

    data = lemma_10_witness().data
    assert (*data.floor, data.p) == tuple(tuple(map(Fraction, v)) for v in SPIKE)


# -- Appendix B -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("apex", [1, 2, "5/2", 3, 4, 5, 6, 8, Fraction(40, 3)])
def test_the_circles_of_neighbours(apex):
    figure = lemma_4_circles(apex)
    data, y = figure.data, Fraction(apex)
    a, q = data.facet
    assert {square(x, data.centre) for x in (a, q, data.apex)} == {data.squared_radius}
    assert {square(x, data.other_centre) for x in (a, q, data.other_apex)} == {data.squared_other_radius}
    assert data.other_apex == (2, y)
    assert data.centre[1] > 0 > data.apex[1]  # outside, beyond the common side
    assert data.power == square(data.apex, data.other_centre) - data.squared_other_radius
    heights = data.centre[1], data.other_centre[1]
    assert data.power == 2 * (heights[1] - heights[0]) * -data.apex[1]  # identity (P)
    assert data.delaunay == (y >= 4)
    assert data.cap_below == (None if y == 4 else y > 4)
    assert ("no cap" in figure.alt) == (y == 4)
    assert ("p is inside S'" in figure.alt) == (y < 4)
    larger = "larger" if data.squared_other_radius > data.squared_radius else "smaller"
    equal = data.squared_other_radius == data.squared_radius
    assert equal or f"the circle of σ' is {larger}" in figure.alt


@pytest.mark.parametrize("apex", [2, 6])
def test_the_cap_lies_outside_the_other_circle(apex):
    shapes = lemma_4_circles(apex).draw().shapes
    own, other = [s for s in shapes if isinstance(s, Disc) and s.radius > 20]
    (cap,) = [s for s in shapes if isinstance(s, Path) and s.pen and s.pen.colour == style.VERMILLION][:1]
    for point in cap.lines[0]:
        assert math.dist(point, own.centre) == pytest.approx(own.radius)
        assert math.dist(point, other.centre) >= other.radius - 1e-6


def test_where_no_neighbour_can_be():
    for apex in (0, -1):
        with pytest.raises(InvalidInput, match="give a number > 0"):
            lemma_4_circles(apex)
    with pytest.raises(InexactInput):
        lemma_4_circles(0.5)


def test_the_trapezoids_are_those_of_the_ledger_and_tile_the_window():
    from coxeter.ledger.section_4_planes import PERIOD, TRAPEZOID, trapezoid_triangles

    figure = lemma_4_witness()
    data = figure.data
    assert data.tiles[0] == TRAPEZOID
    known = {tuple(sorted((x % PERIOD, y % PERIOD) for x, y in t)) for t in trapezoid_triangles()}
    halves = [half for a, b, c, d in data.tiles for half in ((a, b, c), (a, c, d))]
    assert {tuple(sorted((x % PERIOD, y % PERIOD) for x, y in t)) for t in halves} == known
    area = 0.0
    for tile in data.tiles:
        points = data.window.clip([data.window.pixel(v) for v in tile])
        area += abs(
            sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1], strict=True))
        )
    (left, top), (right, bottom) = data.window.corners
    assert area / 2 == pytest.approx((right - left) * (bottom - top))
    assert {Simplex(half).squared_circumradius for half in halves} == {data.squared_radius}


def test_the_circle_is_empty_and_its_centre_lies_in_one_half_only():
    figure = lemma_4_witness()
    data = figure.data
    lattice = [(x + 4 * i, y + 4 * j) for x, y in data.tiles[0] for i, j in product(range(-2, 3), repeat=2)]
    assert set(data.vertices) == {v for v in lattice if data.window.contains(v)}
    squares = sorted(square(v, data.centre) for v in lattice)
    assert squares[:5] == [data.squared_radius] * 4 + [squares[4]]
    assert squares[4] > data.squared_radius
    assert data.inside == ()
    assert "no vertices inside it" in figure.alt
    for (a, b, c), where in data.halves:
        turns = [
            (q[0] - p[0]) * (data.centre[1] - p[1]) - (q[1] - p[1]) * (data.centre[0] - p[0])
            for p, q in ((a, b), (b, c), (c, a))
        ]
        assert (min(turns) > 0) == (where.value == "inside")


# -- Proposition 1 ----------------------------------------------------------------------------------------


def test_a_reflection_fixes_a_root():
    figure = proposition_1_witness()
    data = figure.data
    roots = {x for x in product((-1, 0, 1), repeat=4) if sorted(x) == [-1, 0, 0, 1]}
    assert set(data.roots) == roots
    assert data.mirror_root == (0, 0, 1, -1)
    assert set(data.fixed) == {(1, -1, 0, 0), (-1, 1, 0, 0)} == {r for r in roots if r[2] == r[3] == 0}
    for p, q in data.exchanged:
        assert q == (p[0], p[1], p[3], p[2]) != p  # it exchanges the last two coordinates
    assert {x for pair in data.exchanged for x in pair} | set(data.fixed) == roots
    assert len(data.edges) == 24
    assert data.order == math.factorial(4) > len(roots)
    assert "24 elements for 12 roots" in figure.alt


# -- the paper's figures, and what they are made with -----------------------------------------------------

paper = cache(paper_figure)


def test_there_are_thirteen_figures():
    titles = [paper(n).title for n in range(1, 14)]
    assert len(set(titles)) == 13
    assert titles[2] == "A monohedral triangulation that is not Coxeter"
    names = [title.split()[3].rstrip(",") for title in titles[3:11]]
    assert names == ["A~d", "B~d", "C~d", "D~d", "E~6", "E~7", "E~8", "F~4"]
    assert [len(paper(n).parts) for n in (1, 2, 5, 12)] == [6, 6, 2, 2]
    assert paper(13) == lemma_4_circles(6)


@pytest.mark.parametrize("number", range(4, 12))
def test_the_diagrams_show_the_ratios_of_the_inverse_heights(number):
    left, right = paper(number).data
    name = left.name.replace("d", "20")
    squares = triangulation(name).simplex.squared_heights
    for node in left.nodes:
        k = node.number if isinstance(node.number, int) else 20 - int(node.number[2:] or 0)
        assert node.ratio**2 == squares[0] / squares[k]
    assert (left.show, right.show) == ("heights", "names")


@pytest.mark.parametrize("number", [0, 14, -1, 1.0, "1", True, None])
def test_no_other_figures(number):
    with pytest.raises(InvalidInput, match="a number from 1 to 13"):
        paper_figure(number)


def test_numbers_are_written():
    root = coxeter.sqrt
    values = [root(2), 3 * root(2) / 4, root(13) / 4 - root(5) / 4, Fraction(1, 2), 2]
    assert [words(x) for x in values] == ["√2", "3√2/4", "√13/4 - √5/4", "1/2", "2"]
    assert formula(3 * root(2)) == r"3\sqrt{2}"


def test_views_are_orthonormal_and_see_what_is_in_front():
    seeds = [tuple(map(Fraction, v)) for v in ((2, -1, 0), (-1, -2, 5), (-1, -2, -1))]
    view = View.along(seeds, (0, 0, 0), 10.0)
    for (i, v), (j, w) in product(enumerate(view.frame), repeat=2):
        assert sum((a * b for a, b in zip(v, w, strict=True)), coxeter.surd(0)) == int(i == j)
    upright = View.along([(1, 0, 0), (0, 1, 0), (0, 0, 1)], (0, 0, 0), 1.0)
    base = [(0, 0, 0), (3, 0, 0), (0, 3, 0)]
    assert upright.place((1, 2, 3)) == (1, -2, 3)
    assert upright.front_facets([*base, (1, 1, 2)]) == [(0, 1, 3), (0, 2, 3), (1, 2, 3)]
    assert upright.front_facets([*base, (1, 1, -2)]) == [(0, 1, 2)]


def test_great_circles_end_on_the_outline():
    seeds = [tuple(map(Fraction, v)) for v in ((2, -1, 0), (-1, -2, 5), (-1, -2, -1))]
    view = View.along(seeds, (0, 0, 0), 10.0)
    front, back = great_circle(view, 50.0, (1, 0, 0), (0, 0, 1))
    for half in (front, back):
        (points,) = half
        assert [math.hypot(*points[k]) for k in (0, -1)] == pytest.approx([50, 50])
        assert all(math.hypot(*p) <= 50 + 1e-9 for p in points)
    middle = view.place((1, 0, 1)), view.place((-1, 0, -1))
    ahead = max(middle, key=lambda x: x[2])
    x, y = front[0][24]
    assert x * ahead[0] + y * ahead[1] > 0
