"""Pictures to turn: their data is exact and fits together, their words and pages say what the data says."""

import json
import math
import re
from dataclasses import FrozenInstanceError
from fractions import Fraction
from itertools import combinations

import pytest
from bs4 import BeautifulSoup

from coxeter import (
    InvalidInput,
    InvalidType,
    Position,
    Simplex,
    affine_reflection,
    delaunay_verdict,
    normalized_qualities,
    protection,
    root_system,
    triangulation,
)
from coxeter.figures import canvas as style
from coxeter.scenes import scene, solid
from coxeter.scenes import star as star_of
from coxeter.scenes.drawing import LABELS, TONES, direction
from coxeter.scenes.page import as_data
from coxeter.scenes.words import equation, number, reflection, rows, told, verdict

NAMES = ("A~3", "B~3", "C~3")
STARS = [(name, k) for name in NAMES for k in range(4)]
AROUND = {  # the groups that fix the vertices: their diagrams are those of the triangulations without a node
    "A~3": ("A3", "A3", "A3", "A3"),
    "B~3": ("B3", "B3", None, "A3"),
    "C~3": ("C3", None, None, "C3"),
}


@pytest.fixture(params=NAMES)
def name(request):
    return request.param


@pytest.fixture(params=STARS, ids=lambda pair: f"{pair[0]} around {pair[1]}")
def star(request):
    return star_of(triangulation(request.param[0]), request.param[1])


@pytest.fixture(scope="module")
def pages():
    return {name: BeautifulSoup(scene(name)._repr_html_(), "html.parser") for name in NAMES}


def volume(points):
    return Simplex(points).volume


def squared_distance(p, q):
    return sum((a - b) ** 2 for a, b in zip(p, q, strict=True))


def inside(simplex, point):
    return min(simplex.barycentric(point)) >= 0


# -- the simplices around a vertex ----------------------------------------------------------------------


def test_all_simplices_around_a_vertex_are_there(name):
    t = triangulation(name)
    for star, group in zip(scene(name).stars, AROUND[name], strict=True):
        if group:
            assert len(star.alcoves) == root_system(group).weyl_group_order
    # what is missing are products of smaller groups: A1 × A1 × A1, and A1 × C2
    assert len(star_of(t, 2).alcoves) == {"A~3": 24, "B~3": 8, "C~3": 16}[name]


def test_simplices_are_distinct_and_share_the_vertex(star):
    corners = [frozenset(alcove.vertices) for alcove in star.alcoves]
    assert len(set(corners)) == len(corners)
    assert all(alcove.vertices[star.label] == star.centre for alcove in star.alcoves)


def test_labels_are_those_of_folding(star):
    t = star_triangulation(star)
    unit = [tuple(Fraction(i == k) for i in range(4)) for k in range(4)]
    for alcove in star.alcoves[::5]:
        assert [t.fold(vertex).barycentric for vertex in alcove.vertices] == unit


def test_words_lead_to_the_simplices(star):
    t = star_triangulation(star)
    first = star.alcoves[0].vertices
    for alcove in star.alcoves:
        word = alcove.word
        assert tuple(t.unfold(word, u) for u in first) == alcove.vertices
        centre = tuple(sum(column) / 4 for column in zip(*alcove.vertices, strict=True))
        assert len(t.fold(centre).word) == len(word), "no shorter word leads there"


def test_each_step_reflects_an_earlier_simplex_in_a_facet(star):
    assert len(star.steps) == len(star.alcoves) - 1
    for i, step in enumerate(star.steps):
        old, new = star.alcoves[step.parent], star.alcoves[i + 1]
        assert step.parent <= i
        assert new.word == (*old.word, step.facet)
        assert {k for k in range(4) if old.vertices[k] != new.vertices[k]} == {step.facet}
        k = int(step.mirror.k)
        images = tuple(affine_reflection(step.mirror.root, k, vertex) for vertex in old.vertices)
        assert images == new.vertices
        assert k == step.mirror.k
        roots = star_triangulation(star).roots.positive_roots.rows()
        assert {step.mirror.root, tuple(-x for x in step.mirror.root)} & set(roots)


def test_walls_run_through_the_facets_of_their_simplex(star):
    for alcove in star.alcoves[::3]:
        for k, wall in enumerate(alcove.walls):
            levels = [sum(map(Fraction.__mul__, wall.root, v)) - wall.k for v in alcove.vertices]
            assert [level == 0 for level in levels] == [i != k for i in range(4)]


def test_simplices_do_not_overlap_and_fill_the_solid(star):
    """Centroids lie in no other simplex, and the mirrors that separate two simplices exist."""
    for a, b in combinations(star.alcoves[:16], 2):
        middles = [tuple(sum(c) / 4 for c in zip(*alcove.vertices, strict=True)) for alcove in (a, b)]
        sides = [
            [sum(map(Fraction.__mul__, mirror.root, m)) > mirror.k for m in middles]
            for mirror in star.mirrors
        ]
        assert any(first != second for first, second in sides)


def star_triangulation(star):
    return next(
        triangulation(name)
        for name in NAMES
        if triangulation(name).simplex.vertex_matrix.rows() == star.alcoves[0].vertices
    )


def test_solids(name):
    box = "a solid with 8 faces, all triangles"
    assert [solid(star).name for star in scene(name).stars] == {
        "A~3": ["a rhombic dodecahedron"] * 4,
        "B~3": ["a rhombic dodecahedron", "a rhombic dodecahedron", box, "a cube"],
        "C~3": ["a cube", box, box, "a cube"],
    }[name]


def test_solids_have_the_volume_of_their_simplices():
    """Of each cube the edge is known, of a rhombic dodecahedron too: 16/9 √3 times its cube is the volume."""
    for name, k in STARS:
        star = scene(name).stars[k]
        found = solid(star)
        edge = min(squared_distance(*pair) for face in found.faces for pair in combinations(face, 2))
        square = (len(star.alcoves) * volume(star.alcoves[0].vertices)) ** 2
        if found.name == "a cube":
            assert square == edge**3
        if found.name == "a rhombic dodecahedron":
            assert len(found.faces) == 12
            assert square == Fraction(256 * 3, 81) * edge**3


def test_a_vertex_that_is_none_is_refused():
    with pytest.raises(InvalidInput, match="4 labels no vertex of B~3: give 0 to 3"):
        star_of(triangulation("B~3"), 4)


# -- the scene ------------------------------------------------------------------------------------------


def test_values_are_those_of_the_library(name):
    s, t = scene(name), triangulation(name)
    assert s.vertices == t.simplex.vertex_matrix.rows()
    assert (s.circumcentre, s.circumradius) == (t.simplex.circumcentre, t.simplex.circumradius)
    assert (s.incentre, s.inradius) == (t.simplex.incentre, t.simplex.inradius)
    assert s.delaunay == delaunay_verdict(t).delaunay
    assert s.facets == t.facets
    assert s.dihedral_angles == t.dihedral_angles()


def test_apexes_are_mirror_images_compared_with_the_sphere(name):
    s = scene(name)
    square = squared_distance(s.vertices[0], s.circumcentre)
    for k, apex in enumerate(s.apexes):
        assert apex.point == s.facets[k].reflect(s.vertices[k])
        distance = squared_distance(apex.point, s.circumcentre)
        expected = (
            Position.INSIDE
            if distance < square
            else Position.OUTSIDE
            if distance > square
            else Position.BOUNDARY
        )
        assert (apex.squared_distance, apex.where) == (distance, expected)


def test_the_picture_keeps_distances(name):
    s = scene(name)
    for p, q in combinations(s.vertices, 2):
        assert squared_distance(s.place(p), s.place(q)) == squared_distance(p, q)


def test_a_scene_is_a_value():
    assert scene("B~3") == scene("B̃3") == scene(("B", 3)) == scene(triangulation("B~3"))
    assert scene("B~3") != scene("B~3", around=1)
    with pytest.raises(FrozenInstanceError):
        scene("B~3").around = 2


@pytest.mark.parametrize("name", ["A~2", "B~4", "F~4"])
def test_only_space_is_shown(name):
    message = f"{name} has dimension {name[-1]}: only A~3, B~3 and C~3 can be turned in space"
    with pytest.raises(InvalidInput, match=re.escape(message)):
        scene(name)


@pytest.mark.parametrize("around", [4, -1, "0", 1.5, True])
def test_other_input_is_refused(around):
    with pytest.raises(InvalidInput, match=r"is no vertex of the simplex: give 0, 1, 2 or 3"):
        scene("A~3", around=around)
    with pytest.raises(InvalidType):
        scene("D~3")


# -- what the page says ---------------------------------------------------------------------------------


def test_centres():
    """A~3: one point for both centres, apexes alike. B~3: beyond facet 2. C~3: the midpoint of an edge."""
    a, b, c = map(scene, NAMES)
    assert (a.position, b.position, c.position) == (Position.INSIDE, Position.OUTSIDE, Position.BOUNDARY)
    assert a.incentre == a.circumcentre
    assert len({apex.squared_distance for apex in a.apexes}) == 1
    assert {apex.where for apex in a.apexes} == {Position.OUTSIDE}
    assert [x < 0 for x in b.triangulation.simplex.circumcentre_coordinates] == [False, False, True, False]
    assert [apex.label for apex in b.apexes if apex.where is Position.INSIDE] == [2]
    assert c.triangulation.simplex.circumcentre_coordinates == (Fraction(1, 2), 0, 0, Fraction(1, 2))
    assert [apex.label for apex in c.apexes if apex.where is Position.BOUNDARY] == [1, 2]
    assert not protection(c.triangulation)


@pytest.mark.parametrize(("coarse", "fine"), [("A~3", "B~3"), ("B~3", "C~3")])
def test_each_simplex_is_cut_in_two(coarse, fine):
    """Around the origin, where both stars are: every mirror is one of the finer triangulation too."""
    large, small = scene(coarse), scene(fine)
    pieces = [[small.place(v) for v in x.vertices] for k in range(4) for x in small.stars[k].alcoves]
    distinct = {frozenset(piece) for piece in pieces}
    whole = Simplex([large.place(v) for v in large.vertices])
    within = [piece for piece in distinct if all(inside(whole, v) for v in piece)]
    assert len(within) == 2
    assert sum(volume(sorted(piece)) for piece in within) == whole.volume
    roots = {tuple(small.place(root)) for root in small.triangulation.roots.positive_roots.rows()}
    directions = {direction_of(root) for root in roots}
    for root in large.triangulation.roots.positive_roots.rows():
        placed = tuple(large.place(root))
        assert direction_of(placed) in directions
        match = next(r for r in roots if direction_of(r) == direction_of(placed))
        assert (squared_distance(match, (0, 0, 0)) / squared_distance(placed, (0, 0, 0))) in (1, 4)


def direction_of(vector):
    first = next(x for x in vector if x)
    return tuple(Fraction(x) / first for x in vector)


def test_simplices_around_an_edge_of_c_fill_a_cube_on_the_sphere():
    c = scene("C~3")
    around = [a for a in c.star.alcoves if a.vertices[3] == c.vertices[3]]
    corners = {vertex for alcove in around for vertex in alcove.vertices}
    assert len(corners) == 8
    assert {squared_distance(v, c.circumcentre) for v in corners} == {Fraction(3, 16)}
    lengths = sorted(squared_distance(p, q) for p, q in combinations(corners, 2))
    assert lengths == [Fraction(1, 4)] * 12 + [Fraction(1, 2)] * 12 + [Fraction(3, 4)] * 4
    assert len(c.star.alcoves) == 8 * len(around)


def test_corners_of_the_cube_in_b_take_turns():
    star = scene("B~3").stars[3]
    corners = frozenset().union(*solid(star).faces)
    label = {v: k for alcove in star.alcoves for k, v in enumerate(alcove.vertices)}
    assert {label[v] for v in corners} == {0, 1}
    edge = min(squared_distance(p, q) for p, q in combinations(corners, 2))
    for p, q in combinations(corners, 2):
        if squared_distance(p, q) == edge:
            assert {label[p], label[q]} == {0, 1}


def test_a_is_the_best_by_every_measure():
    best = normalized_qualities(triangulation("A~3").simplex)
    for name in ("B~3", "C~3"):
        assert all(
            best[key] > value for key, value in normalized_qualities(triangulation(name).simplex).items()
        )


def test_normals_of_c_have_two_lengths():
    lengths = [squared_distance(facet.normal, (0, 0, 0)) for facet in scene("C~3").facets]
    assert lengths[0] == lengths[3] > lengths[1] == lengths[2]


# -- words ----------------------------------------------------------------------------------------------


def test_words_of_the_verdict():
    assert verdict(scene("A~3")) == (
        "The circumcentre lies inside the simplex: A\u0303₃ is Delaunay. "
        "The apexes of all four neighbours lie outside the circumsphere."
    )
    assert verdict(scene("B~3")) == (
        "The circumcentre lies outside the simplex: B\u0303₃ is not Delaunay. "
        "Of the apexes of the four neighbours, s₂(u₂) lies inside "
        "the circumsphere, s₀(u₀), s₁(u₁) and s₃(u₃) lie outside the circumsphere."
    )
    assert "s₁(u₁) and s₂(u₂) lie on the circumsphere" in verdict(scene("C~3"))


def test_alt_has_the_numbers(name):
    s = scene(name)
    for value in (s.circumradius, s.inradius):
        assert number(value) in s.alt
    assert repr(s) == s.alt
    assert verdict(s) in s.alt


def test_words_of_reflections(star):
    said = [reflection(star, i) for i in range(len(star.steps))]
    assert len(set(said)) == len(said)
    for i, (step, words) in enumerate(zip(star.steps, said, strict=True)):
        assert words.startswith(f"Reflection {i + 1} of {len(said)}: in the mirror {equation(step.mirror)}")


def test_equations_hold_on_the_facets(star):
    """The words are read back, and hold for the vertices on the mirror and for no other."""
    for step in star.steps[:12]:
        old = star.alcoves[step.parent]
        left, right = equation(step.mirror).replace("−", "-").split(" = ")
        terms = re.findall(r"([+-]?) ?(\d*)x([₁-₄])", left)
        for k, vertex in enumerate(old.vertices):
            value = sum(
                (-1 if sign == "-" else 1) * int(factor or 1) * vertex["₁₂₃₄".index(i)]
                for sign, factor, i in terms
            )
            assert (value == Fraction(right)) == (k != step.facet)


def test_each_control_has_words(name):
    assert set(told(scene(name))) == {
        "simplex", "circumsphere", "circumcentre", "incentre", "normals", "mirrors", "apexes",
    }  # fmt: skip


# -- the drawing ----------------------------------------------------------------------------------------


def test_labels_have_four_colours_and_the_viewer_looks_along_no_mirror(name):
    assert len(set(LABELS)) == 4
    assert not set(LABELS) & {style.GREEN, *TONES}
    towards = direction(scene(name))
    assert math.isclose(math.hypot(*towards), 1)
    s = scene(name)
    for mirror in s.star.mirrors:
        n = [float(x) for x in s.place(mirror.root)]
        assert abs(sum(map(float.__mul__, n, towards))) > 0.1 * math.hypot(*n)


def test_the_drawing_can_be_saved(name, tmp_path):
    s = scene(name)
    for end in ("svg", "pdf", "png"):
        s.figure.save(tmp_path / f"scene.{end}")
        assert (tmp_path / f"scene.{end}").stat().st_size > 4000


@pytest.mark.parametrize(("name", "k"), STARS)
def test_each_star_can_be_drawn_first(name, k):
    s = scene(name, around=k)
    assert as_data(s)["around"] == k
    assert f"simplices around {'u₀u₁u₂u₃'[2 * k : 2 * k + 2]}, moved apart" in s.figure.parts[1].svg


def test_the_star_is_drawn_whole(name):
    """Of a simplex one to three faces look towards the viewer."""
    s = scene(name)
    faces = len(s.figure.parts[1].draw().shapes)
    assert len(s.star.alcoves) <= faces <= 3 * len(s.star.alcoves)


# -- the page -------------------------------------------------------------------------------------------


def test_the_element_is_small_and_has_all_parts(name, pages):
    html = scene(name)._repr_html_()
    assert len(html.encode()) < 100_000
    assert not re.search(r"https?://(?!www\.w3\.org/2000/svg)", html)
    page = pages[name]
    (figure,) = page.find_all("figure", class_="cx-scene")
    drawings = figure.select(".cx-still svg[role=img]")
    assert len(drawings) == 2
    assert all(drawing["aria-label"] and drawing.title.string for drawing in drawings)
    assert not [element for element in figure.find_all() if element.has_attr("id")]


def test_the_table_has_every_number(name, pages):
    table = pages[name].select_one(".cx-numbers table")
    cells = [[cell.get_text() for cell in row.find_all(["th", "td"])] for row in table.select("tbody tr")]
    expected = [[row.what, row.exact, row.remark] for row in rows(scene(name))]
    assert cells == [[re.sub(r"([A-G])~(\d)", "\\1\u0303\\2", x) for x in row] for row in expected]


def test_the_reflections_are_listed(name, pages):
    s = scene(name)
    items = [item.get_text() for item in pages[name].select(".cx-steps li")]
    assert items == [reflection(s.star, i) for i in range(len(s.star.steps))]


def test_the_data_is_json_and_agrees(name, pages):
    data = json.loads(pages[name].select_one("script[type='application/json']").string)
    s = scene(name)
    assert data == json.loads(json.dumps(as_data(s)))
    for shown, star in zip(data["stars"], s.stars, strict=True):
        for i, alcove in zip(shown["alcoves"], star.alcoves, strict=True):
            for n, vertex in zip(data["alcoves"][i], alcove.vertices, strict=True):
                assert data["points"][n] == [round(float(x), 6) for x in s.place(vertex)]
        for (parent, facet, mirror), step in zip(shown["steps"], star.steps, strict=True):
            assert (parent, facet) == (step.parent, step.facet)
            *normal, k = data["mirrors"][mirror]
            old = data["alcoves"][shown["alcoves"][parent]]
            on_it = (
                [abs(math.sumprod(normal, data["points"][n]) - k) < 1e-5 for n in old]
                if hasattr(math, "sumprod")
                else None
            )
            assert on_it in (None, [i != facet for i in range(4)])
        assert shown["odd"] == [alcove.parity for alcove in star.alcoves]
    assert data["circumradius"] == round(float(s.circumradius), 6)
    assert max(len(str(x).partition(".")[2]) for point in data["points"] for x in point) <= 6


def test_a_page_can_ask_for_the_view():
    from coxeter.pages.views import _scene

    assert _scene("A~3") == scene("A~3")._repr_html_()
