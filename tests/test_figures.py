"""The figures: what they plot is exact, what they say is what they plot, and a page can hold them."""

import configparser
import math
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from dataclasses import FrozenInstanceError
from fractions import Fraction
from functools import cache
from itertools import combinations, pairwise
from pathlib import Path

import pytest

import coxeter
from coxeter import InvalidInput, InvalidType, Position, Surd, affine_reflection, root_system, triangulation
from coxeter.diagrams import affine_diagram
from coxeter.diagrams import coxeter_diagram as finite_diagram
from coxeter.figures import (
    Figure,
    above,
    angle_classes,
    beside,
    coxeter_diagram,
    cube_simplex,
    diagram_pair,
    difference_not_a_vertex,
    family_diagram,
    lemma_4_circles,
    lemma_4_witness,
    lemma_9_distances,
    lemma_10_plane,
    lemma_10_witness,
    monohedral_not_coxeter,
    paper_figure,
    proposition_1_witness,
    protection_spheres,
    quality_curves,
    sphere_not_empty,
)
from coxeter.figures import canvas as style
from coxeter.figures import plane_triangulation as make_plane_triangulation
from coxeter.figures import root_system_plane as make_root_system_plane
from coxeter.figures.canvas import Canvas, Disc, Label
from coxeter.figures.labels import runs
from coxeter.figures.layout import LONGEST
from coxeter.figures.svg import write_svg
from coxeter.names import parse_root_system, triangulations_up_to

plane_triangulation = cache(make_plane_triangulation)
root_system_plane = cache(make_root_system_plane)

SVG = "{http://www.w3.org/2000/svg}"

MAKERS = {
    "finite diagram": lambda: coxeter_diagram("E7"),
    "affine diagram": lambda: coxeter_diagram("B~4", show="marks"),
    "cycle": lambda: coxeter_diagram("A~12"),
    "long diagram": lambda: coxeter_diagram("D~1000"),
    "family": lambda: family_diagram("C"),
    "pair": lambda: diagram_pair("F~4"),
    "family pair": lambda: diagram_pair("D~d"),
    "A2": lambda: make_root_system_plane("A2"),
    "B2": lambda: make_root_system_plane("B2"),
    "G2": lambda: make_root_system_plane("G2"),
    "dual of A2": lambda: make_root_system_plane("A2", dual=True),
    "dual of C2": lambda: make_root_system_plane("C2", dual=True),
    "dual of G2": lambda: make_root_system_plane("G2", dual=True),
    "A~2": lambda: make_plane_triangulation("A~2"),
    "C~2": lambda: make_plane_triangulation("C~2"),
    "G~2": lambda: make_plane_triangulation("G~2"),
    "A~3": lambda: cube_simplex("A~3"),
    "B~3": lambda: cube_simplex("B~3"),
    "C~3": lambda: cube_simplex("C~3"),
    "monohedral": monohedral_not_coxeter,
    "aspect ratio": lambda: quality_curves("aspect_ratio", 10),
    "fatness": lambda: quality_curves("fatness", 10),
    "thickness": lambda: quality_curves("thickness", 9),
    "radius ratio": lambda: quality_curves("radius_ratio", 8),
    "few dimensions": lambda: quality_curves("radius_ratio", 2),
    "inverse heights": lambda: coxeter_diagram("F~4", show="heights"),
    "family with heights": lambda: diagram_pair("B~d", "heights"),
    "angles of A2": lambda: angle_classes("A2"),
    "angles of B2": lambda: angle_classes("B2"),
    "angles of G2": lambda: angle_classes("G2"),
    "Lemma 9": lemma_9_distances,
    "Lemma 10": lemma_10_plane,
    "witness for Lemma 10": lemma_10_witness,
    "Lemma 4": lemma_4_circles,
    "gap in Lemma 4": lambda: lemma_4_circles(4),
    "not Delaunay neighbours": lambda: lemma_4_circles("5/2"),
    "witness for Lemma 4": lemma_4_witness,
    "witness for Proposition 1": proposition_1_witness,
    "not empty": sphere_not_empty,
    "not a vertex": difference_not_a_vertex,
    "protection of A~2": lambda: protection_spheres("A~2"),
    "protection of A~3": lambda: protection_spheres("A~3"),
    "protection of G~2": lambda: protection_spheres("G~2"),
    "protection of C~3": lambda: protection_spheres("C~3"),
    "Figure 1": lambda: paper_figure(1),
    "Figure 12": lambda: paper_figure(12),
}


@pytest.fixture(scope="module")
def figures():
    return {name: make() for name, make in MAKERS.items()}


@pytest.fixture(params=MAKERS)
def figure(request, figures):
    return figures[request.param]


# -- on a page ------------------------------------------------------------------------------------------


def test_neither_matplotlib_nor_networkx_is_loaded_before_it_is_needed():
    code = "import sys, coxeter, coxeter.figures as f; f.root_system_plane('B2').svg; "
    code += "print({'matplotlib', 'networkx'} & set(sys.modules))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "set()"


def test_svg_is_a_lone_harmless_element(figure):
    root = ET.fromstring(figure.svg)
    assert root.tag == f"{SVG}svg"
    assert {element.tag for element in root.iter()} <= {
        SVG + tag for tag in ("svg", "title", "path", "circle", "text", "tspan")
    }
    assert not [element for element in root.iter() if "id" in element.attrib or "class" in element.attrib]
    assert re.findall(r"https?://[^\"]*", figure.svg) == ["http://www.w3.org/2000/svg"]


def test_svg_has_words_and_scales(figure):
    root = ET.fromstring(figure.svg)
    assert root.get("role") == "img"
    assert root.get("aria-label") == figure.alt
    assert root.find(f"{SVG}title").text == figure.title
    assert root.get("viewBox").split()[2:] == [root.get("width"), root.get("height")]
    assert root.get("style") == f"width:100%;max-width:{root.get('width')}px;height:auto"


def test_colours_follow_the_page_or_come_from_the_palette(figure):
    palette = {"currentColor", "none", style.BLUE, style.VERMILLION, style.GREEN, style.PURPLE}
    for element in ET.fromstring(figure.svg).iter():
        assert {element.get("fill", "none"), element.get("stroke", "none")} <= palette
        if element.tag == f"{SVG}text":
            assert element.get("fill") == "currentColor"


@pytest.mark.parametrize("colour", [style.BLUE, style.VERMILLION, style.GREEN, style.PURPLE])
@pytest.mark.parametrize("ground", ["#ffffff", "#121212"])
def test_the_palette_stands_out_on_white_and_on_near_black(colour, ground):
    def luminance(code):
        parts = [int(code[i : i + 2], 16) / 255 for i in (1, 3, 5)]
        r, g, b = (x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in parts)
        return 0.2126 * r + 0.7152 * g + 0.0722 * b

    dark, light = sorted(map(luminance, (colour, ground)))
    assert (light + 0.05) / (dark + 0.05) >= 3  # WCAG 2.1, 1.4.11


@pytest.mark.parametrize("name", MAKERS)
def test_made_twice_it_is_the_same(name, figures):
    again = MAKERS[name]()
    assert again == figures[name]
    assert again.svg == figures[name].svg


def test_notebooks_keep_the_words(figure):
    assert repr(figure) == figure.alt
    html = figure._repr_html_()
    assert html.count("<svg") == max(len(figure.parts), 1)
    assert html.startswith("<figure ")
    assert html.endswith("</figure>")
    rules = configparser.RawConfigParser()
    rules.read(Path(__file__).parents[1] / "tools" / "nbval_sanitize.cfg", encoding="utf-8")
    for section in rules.sections():
        html = re.sub(rules[section]["regex"], rules[section]["replace"], html)
    assert "<svg" not in html
    for part in figure.parts or (figure,):
        assert f"[figure: {part.title}]" in html


def test_nothing_is_clipped_and_no_labels_meet(figure):
    canvas = figure.draw()
    for left, top, right, bottom in (shape.box for shape in canvas.shapes):
        assert left >= 0
        assert top >= 0
        assert right <= canvas.width
        assert bottom <= canvas.height
    labels = [shape for shape in canvas.shapes if isinstance(shape, Label)]
    for a, b in combinations(labels, 2):
        assert not _meet(a.core, b.core), (a.text, b.text)


def _meet(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def test_a_figure_cannot_be_changed(figure):
    with pytest.raises(FrozenInstanceError):
        figure.alt = "something else"
    assert isinstance(figure.data, tuple)


@pytest.mark.parametrize("suffix", ["svg", "pdf", "png"])
@pytest.mark.parametrize("name", ["pair", "dual of C2", "thickness"])
def test_saved_twice_the_files_are_the_same(name, suffix, figures, tmp_path):
    contents = []
    for i in (1, 2):
        figures[name].save(tmp_path / f"{i}.{suffix}")
        contents.append((tmp_path / f"{i}.{suffix}").read_bytes())
    assert contents[0] == contents[1]
    assert contents[0].startswith({"svg": b"<svg", "pdf": b"%PDF", "png": b"\x89PNG"}[suffix])
    if suffix == "svg":
        assert b"max-width" not in contents[0]


@pytest.mark.parametrize("name", ["figure", "figure.jpg"])
def test_other_files_are_refused(name, figures):
    with pytest.raises(InvalidInput, match=r"\.svg, \.pdf or \.png"):
        figures["A2"].save(name)


def test_figures_in_a_row():
    row = beside(coxeter_diagram("A2"), coxeter_diagram("B3"))
    assert [data.name for data in row.data] == ["A2", "B3"]
    assert "A2" in row.alt
    assert "B3" in row.alt
    width = sum(part.draw().width for part in row.parts)
    assert row.draw().width > width
    with pytest.raises(InvalidInput, match="at least one"):
        beside()


def test_rows_of_figures():
    rows = beside(coxeter_diagram("A2"), coxeter_diagram("B3")), coxeter_diagram("G2")
    column = above(*rows)
    assert [part.data.name for part in column.parts] == ["A2", "B3", "G2"]
    assert column.data[0][1].name == "B3"
    assert column._repr_html_() == "\n".join(row._repr_html_() for row in rows)
    drawn, (first, second) = column.draw(), [row.draw() for row in rows]
    assert drawn.height > first.height + second.height
    assert drawn.width == max(first.width, second.width)
    with pytest.raises(InvalidInput, match="at least one"):
        above()


def test_labels_are_read():
    (letter, *rest) = runs(r"$\tilde{B}_{3}$, marks")
    assert (*letter[:3], letter.accent) == ("B", True, True, "~")
    assert [(run.letters, run.level, run.math) for run in rest] == [("3", -1, True), (", marks", 0, False)]
    assert [run.letters for run in runs(r"$s_1^{\vee}$")] == ["s", "1", "∨"]
    assert "".join(run.letters for run in runs(r"$\sigma' = 2\sqrt{13}$")) == "σ′ = 2√13"


def test_signs_of_xml_are_escaped():
    canvas = Canvas()
    canvas.label((0, 0), "<x, r> & $k$")
    root = ET.fromstring(write_svg(canvas.fit(), "a < b", 'say "a < b" & c', fluid=True))
    assert "".join(root.find(f"{SVG}text").itertext()) == "<x, r> & k"
    assert root.get("aria-label") == 'say "a < b" & c'


# -- diagrams -------------------------------------------------------------------------------------------

AFFINE = [kind.affine for kind in triangulations_up_to(LONGEST)]
FINITE = [f"{x}{d}" for x, low in (("A", 1), ("B", 2), ("C", 2), ("D", 4)) for d in range(low, LONGEST + 1)]
FINITE += ["E6", "E7", "E8", "F4", "G2"]


def _graph(name):
    system = root_system(name.replace("~", ""))
    return affine_diagram(system) if "~" in name else finite_diagram(system)


def _texts(figure):
    root = ET.fromstring(figure.svg)
    return ["".join(text.itertext()) for text in root.iter(f"{SVG}text")]


@pytest.mark.parametrize("name", AFFINE + FINITE)
def test_diagrams_have_the_nodes_marks_and_edges_of_the_core(name):
    graph, data = _graph(name), coxeter_diagram(name, "marks").data
    assert {node.number: node.mark for node in data.nodes} == dict(graph.nodes(data="mark"))
    assert {(e.first, e.second): e.m for e in data.edges} == {(i, j): m for i, j, m in graph.edges(data="m")}
    assert not any(edge.dots for edge in data.edges)


@pytest.mark.parametrize("name", [*AFFINE, *FINITE, "A~50", "B~50", "C~50", "D~50", "D13"])
@pytest.mark.parametrize("show", ["names", "marks"])
def test_diagrams_are_plane_and_their_labels_are_free(name, show):
    figure = coxeter_diagram(name, show)
    places = {node.number: node.place for node in figure.data.nodes}
    assert len(set(places.values())) == len(places)
    for i, j, *_ in figure.data.edges:
        assert not any(_on_segment(places[k], places[i], places[j]) for k in places if k not in (i, j))
    shapes = figure.draw().shapes
    labels = [shape for shape in shapes if isinstance(shape, Label)]
    discs = [shape for shape in shapes if isinstance(shape, Disc)]
    assert not [(a.text, b.text) for a, b in combinations(labels, 2) if _meet(a.core, b.core)]
    assert not [label.text for label in labels for disc in discs if _meet(label.core, disc.box)]


def _on_segment(x, p, q):
    (a, b), (c, d) = ((x[0] - p[0], x[1] - p[1]), (q[0] - p[0], q[1] - p[1]))
    return a * d == b * c and 0 <= a * c + b * d <= c * c + d * d


@pytest.mark.parametrize("name", ["B~5", "E~6", "F~4", "G~2", "A~3", "D~4"])
def test_diagrams_show_names_or_marks(name):
    t = triangulation(name)
    labels = [str(m) for m in (4, 6) if m in [m for *_, m in _graph(name).edges(data="m")]]
    symbol = list(t.type.affine.replace("~", ""))
    marks = _texts(coxeter_diagram(name, "marks"))
    names = _texts(coxeter_diagram(name, "names"))
    assert sorted(marks) == sorted([*map(str, t.marks), *labels, *symbol])
    assert sorted(names) == sorted([*(f"τ{k}" for k in range(t.dimension + 1)), *labels, *symbol])
    assert "s1" in _texts(coxeter_diagram(name.replace("~", "")))


@pytest.mark.parametrize("name", AFFINE)
def test_ratios_at_the_nodes_are_those_of_the_heights(name):
    squares = triangulation(name).simplex.squared_heights
    figure = coxeter_diagram(name, "heights")
    ratios = {node.number: node.ratio for node in figure.data.nodes}
    assert ratios == {k: coxeter.sqrt(squares[0] / x) for k, x in enumerate(squares)}
    written = {str(x).replace("*", "").replace("sqrt(", "√").replace(")", "") for x in ratios.values()}
    assert written <= set(_texts(figure))


def test_inverse_heights_are_marks_only_where_all_roots_have_one_length():
    assert "Inverse heights: 1 at 0, 1; √2 at 4; 2 at 2, 3." in coxeter_diagram("B~4", "heights").alt
    assert sorted(_texts(coxeter_diagram("C~2", "heights")))[-1] == "√2"
    ratios = [node.ratio for node in coxeter_diagram("E~8", "heights").data.nodes]
    assert ratios == list(triangulation("E~8").marks)
    assert diagram_pair("F~4", "heights").parts[0].title.endswith("inverse heights")
    with pytest.raises(InvalidInput, match="no simplex, hence no heights"):
        coxeter_diagram("B4", show="heights")


@pytest.mark.parametrize("name", ["B~5", "E~8", "A~2", "C~3"])
def test_node_0_is_the_only_filled_one(name):
    for text, count in ((name, 1), (name.replace("~", ""), 0)):
        discs = [shape for shape in coxeter_diagram(text).draw().shapes if isinstance(shape, Disc)]
        assert len([disc for disc in discs if disc.fill]) == count


@pytest.mark.parametrize("name", ["A~13", "B~20", "C~20", "D~40", "A20", "B20", "D13"])
def test_what_a_long_diagram_leaves_out_is_a_plain_chain(name):
    graph, data = _graph(name), coxeter_diagram(name).data
    (dots,) = (edge for edge in data.edges if edge.dots)
    shown = {node.number for node in data.nodes}
    hidden = set(graph) - shown
    assert hidden == set(range(dots.first + 1, dots.second))
    for k in range(dots.first, dots.second):
        assert graph.edges[k, k + 1]["m"] == 3
    assert {graph.nodes[k]["mark"] for k in hidden} == {graph.nodes[dots.first]["mark"]}
    assert all(graph.degree[k] == 2 for k in hidden)
    rest = {(e.first, e.second): e.m for e in data.edges if not e.dots}
    assert rest == {(i, j): m for i, j, m in graph.edges(data="m") if {i, j} <= shown}


@pytest.mark.parametrize("letter", "ABCD")
@pytest.mark.parametrize("affine", [True, False])
@pytest.mark.parametrize("d", [13, 14, 30])
def test_a_family_is_each_of_its_members(letter, affine, d):
    def at(number):
        return number if isinstance(number, int) else d - int(number[2:] or 0)

    family = family_diagram(letter, affine=affine).data
    member = coxeter_diagram(f"{letter}~{d}" if affine else f"{letter}{d}").data
    assert tuple(node._replace(number=at(node.number)) for node in family.nodes) == member.nodes
    moved = tuple(e._replace(first=at(e.first), second=at(e.second)) for e in family.edges)
    assert moved == member.edges


def test_single_families_are_their_members():
    for family in ("E6", "E7", "E8", "F4", "G2"):
        assert family_diagram(family).data.name == family[0] + "~" + family[1]
    assert family_diagram("G2", affine=False).data.name == "G2"


def test_shapes_of_the_diagrams():
    assert coxeter_diagram("D~4").data.line == (2,)
    assert coxeter_diagram("E~8").data.line == (1, 3, 4, 5, 6, 7, 8, 0)
    top = {node.number: node for node in coxeter_diagram("A~5").data.nodes}[0]
    assert top.place == (2, 1)
    assert top.side == "above"
    branch = {node.number: node.place for node in coxeter_diagram("E~6").data.nodes}
    assert (branch[4], branch[2], branch[0]) == ((2, 0), (2, 1), (2, 2))


def test_the_words_of_a_diagram_give_its_numbers():
    words = coxeter_diagram("E~8", "marks").alt
    assert "line 1–3–4–5–6–7–8–0, and 2–4" in words
    assert "Marks: 1 at 0; 2 at 1, 8; 3 at 2, 7; 4 at 3, 6; 5 at 5; 6 at 4." in words
    assert "labels 4 on 0–1, 4 on 1–2" in coxeter_diagram("C~2").alt
    pair = diagram_pair("F~4")
    assert [data.show for data in pair.data] == ["marks", "names"]
    assert "Left, marks: 1 at 0; 2 at 1, 4; 3 at 2; 4 at 3. Right, facets: τ_0 to τ_4." in pair.alt


def test_names_of_diagrams():
    assert coxeter_diagram(triangulation("B~3")) == coxeter_diagram("B\N{COMBINING TILDE}3")
    assert coxeter_diagram(root_system("B3")) == coxeter_diagram(("B", 3))
    with pytest.raises(InvalidType, match="B~d needs d >= 3"):
        coxeter_diagram("B~2")
    with pytest.raises(InvalidType, match="no family"):
        family_diagram("H")
    with pytest.raises(InvalidInput, match="'names' or 'marks'"):
        coxeter_diagram("A3", show="lengths")


# -- root systems of rank 2 -----------------------------------------------------------------------------

RANK_2 = {"A2": 6, "B2": 8, "C2": 8, "G2": 12}


@pytest.mark.parametrize(("name", "count"), RANK_2.items())
@pytest.mark.parametrize("dual", [False, True])
def test_all_roots_are_drawn_where_they_are(name, count, dual):
    system, data = root_system(name), root_system_plane(name, dual).data
    assert len(set(data.vectors)) == len(data.vectors) == count
    assert set(data.vectors) == set((system.coroots if dual else system.roots).rows())
    assert {*data.simple, data.highest} <= set(data.vectors)
    for v in data.vectors:
        assert data.window.contains(v)
        first, second = data.window.project(v)
        assert first * first + second * second == sum(x * x for x in v)
        x, y = data.window.pixel(v)
        assert x == pytest.approx(data.window.scale * float(first))
        assert y == pytest.approx(-data.window.scale * float(second))


@pytest.mark.parametrize("name", RANK_2)
def test_simple_roots_highest_root_and_domain(name):
    system, t = root_system(name), triangulation({"B2": "C~2"}.get(name, f"{name[0]}~2"))
    data, dual = root_system_plane(name).data, root_system_plane(name, dual=True).data
    assert data.simple == system.simple_roots.rows()
    assert data.highest == system.highest_root
    assert data.domain == dual.domain
    assert data.lines == dual.lines
    assert data.window == dual.window
    for r in system.positive_roots.rows():  # the definition of the fundamental domain
        values = [sum(a * b for a, b in zip(r, v, strict=True)) for v in data.domain]
        assert 0 <= min(values) < max(values) <= 1
    if name != "B2":
        assert data.domain == t.simplex.vertex_matrix.rows()


@pytest.mark.parametrize("name", RANK_2)
def test_the_coroot_of_the_highest_root_is_a_mirror_image_of_the_origin(name):
    data, dual = root_system_plane(name).data, root_system_plane(name, dual=True).data
    assert dual.highest == affine_reflection(data.highest, 1, [0] * len(data.highest))


@pytest.mark.parametrize("name", RANK_2)
def test_frames_are_orthonormal(name):
    a, b = root_system_plane(name).data.window.frame
    assert [
        sum((x * y for x, y in zip(u, v, strict=True)), Surd(0)) for u, v in ((a, a), (a, b), (b, b))
    ] == [
        1,
        0,
        1,
    ]


def _crossing(window, roots):
    """Second route: a line crosses the window if corners lie strictly on both sides of it."""
    found = set()
    for root in roots:
        a, b = window.project(root)
        values = [
            a * (window.centre[0] + i * window.half[0]) + b * (window.centre[1] + j * window.half[1])
            for i in (-1, 1)
            for j in (-1, 1)
        ]
        found |= {(root, k) for k in range(-40, 41) if min(values) < k < max(values)}
    return found


@pytest.mark.parametrize("name", RANK_2)
def test_the_hyperplanes_drawn_are_those_that_cross_the_window(name):
    data = root_system_plane(name).data
    assert len(data.lines) == len(set(data.lines))
    assert set(data.lines) == _crossing(data.window, root_system(name).positive_roots.rows())
    walls = {*((s, 0) for s in data.simple), (data.highest, 1)}
    assert walls <= set(data.lines)
    for line in data.lines:
        for p in data.window.segment(line):
            (left, top), (right, bottom) = data.window.corners
            assert min(abs(p[0] - left), abs(p[0] - right), abs(p[1] - top), abs(p[1] - bottom)) < 1e-6


def test_the_words_of_a_root_system_give_its_numbers():
    words = root_system_plane("G2").alt
    assert "12 arrows" in words
    assert "s_1 = (1, -1, 0), s_2 = (-2, 1, 1); highest root (-1, -1, 2)" in words
    assert f"{len(root_system_plane('G2').data.lines)} lines" in words
    assert "s_2^v = (0, 2)" in root_system_plane("B2", dual=True).alt


@pytest.mark.parametrize("name", ["A3", "E8"])
def test_only_rank_2_is_drawn_in_the_plane(name):
    with pytest.raises(InvalidInput, match="only rank 2"):
        root_system_plane(name)


# -- triangulations of the plane ------------------------------------------------------------------------

PLANE = ("A~2", "C~2", "G~2")


@pytest.mark.parametrize("name", PLANE)
def test_vertices_of_all_triangles_are_vertices_of_the_triangulation(name):
    t, data = triangulation(name), plane_triangulation(name).data
    for vertex in {v for triangle in data.triangles for v in triangle}:
        assert t.is_vertex(vertex)
        assert t.is_vertex_by_rank(vertex)
    for triangle in data.triangles:  # vertex k is an image of u_k
        for k, vertex in enumerate(triangle):
            assert t.fold(vertex).barycentric[k] == 1


@pytest.mark.parametrize("name", PLANE)
def test_the_vertices_shown_are_where_the_lines_meet(name):
    data = plane_triangulation(name).data
    assert set(data.lines) == _crossing(data.window, triangulation(name).roots.positive_roots.rows())
    found = set()
    for (r, k), (s, m) in combinations(data.lines, 2):
        rr, rs, ss = (sum(a * b for a, b in zip(u, v, strict=True)) for u, v in ((r, r), (r, s), (s, s)))
        if determinant := rr * ss - rs * rs:
            a, b = (k * ss - m * rs) / determinant, (m * rr - k * rs) / determinant
            found.add(tuple(a * x + b * y for x, y in zip(r, s, strict=True)))
    assert {x for x in found if data.window.contains(x)} == set(data.vertices)


@pytest.mark.parametrize("name", PLANE)
def test_the_triangles_tile_the_window_and_are_shaded_in_turn(name):
    data = plane_triangulation(name).data
    _assert_tiles(data.window, data.triangles)
    shaded = set(data.shaded)
    for p, q in combinations(data.triangles, 2):
        if len(set(p) & set(q)) == 2:
            assert (p in shaded) != (q in shaded)


def _assert_tiles(window, triangles):
    area = 0.0
    for triangle in triangles:
        points = window.clip([window.pixel(v) for v in triangle])
        area += abs(
            sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1], strict=True))
        )
    (left, top), (right, bottom) = window.corners
    assert area / 2 == pytest.approx((right - left) * (bottom - top))


@pytest.mark.parametrize(
    ("name", "where"), [("A~2", Position.INSIDE), ("C~2", Position.BOUNDARY), ("G~2", Position.BOUNDARY)]
)
def test_the_fundamental_simplex_and_its_centres(name, where):
    data = plane_triangulation(name).data
    assert data.simplex == triangulation(name).simplex.vertex_matrix.rows()
    assert data.simplex in data.triangles
    assert data.simplex not in data.shaded
    for u in data.simplex:
        assert (
            sum((a - b) ** 2 for a, b in zip(u, data.circumcentre, strict=True)) == data.squared_circumradius
        )
    assert data.position is where
    for facet in triangulation(name).facets:
        distance = (
            sum((x * n for x, n in zip(data.incentre, facet.normal, strict=True)), Surd(0)) - facet.offset
        )
        assert distance * distance == data.inradius**2 * sum(n * n for n in facet.normal)


def test_the_words_of_a_triangulation_give_its_numbers():
    words = plane_triangulation("C~2").alt
    assert "u_2 = (1/2, 1/2)" in words
    assert "circumcentre (1/4, 1/4) lies on the boundary" in words
    assert "R² = 1/8" in words
    assert "incentre is the circumcentre" not in words
    assert "incentre is the circumcentre" in plane_triangulation("A~2").alt


def test_only_the_plane_is_drawn():
    with pytest.raises(InvalidInput, match="rank 3"):
        plane_triangulation("A~3")


# -- simplices in a cube --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "kinds", "share"),
    [("A~3", [1, 1, 2, 2], 12), ("B~3", [0, 0, 2, 3], 24), ("C~3", [0, 1, 2, 3], 48)],
)
def test_the_simplex_in_the_cube_is_the_fundamental_simplex(name, kinds, share):
    data, simplex = cube_simplex(name).data, triangulation(name).simplex
    squares = simplex.squared_edge_lengths
    unit = data.edge**2 / 4
    for i, j in combinations(range(4), 2):
        length = sum((x - y) ** 2 for x, y in zip(data.places[i], data.places[j], strict=True))
        assert unit * length == squares[i, j]
    assert {x for place in data.places for x in place} <= {0, 1, 2}
    assert sorted(data.kinds) == kinds
    assert data.share == Fraction(1, share)
    assert data.share * data.edge**3 == simplex.volume


def test_the_words_of_a_simplex_in_a_cube():
    figure = cube_simplex("B~3")
    assert "u_2 at the centre of a face, u_3 at the centre of the cube" in figure.alt
    assert "1/24 of the cube" in figure.alt
    assert "u0, u1: vertices" in _texts(figure)
    with pytest.raises(InvalidInput, match="dimension 4"):
        cube_simplex("D~4")


# -- monohedral, but not Coxeter ------------------------------------------------------------------------


@pytest.fixture(scope="module")
def monohedral():
    return monohedral_not_coxeter().data


def test_neighbours_are_mirror_images(monohedral):
    triangles = monohedral.triangles
    assert len({frozenset(t) for t in triangles}) == len(triangles)
    shared = {
        (i, j)
        for (i, a), (j, b) in combinations(enumerate(triangles), 2)
        if len(set(a) & set(b)) == 2  # second route to the neighbours
    }
    assert shared == set(monohedral.neighbours) == set(monohedral.mirror_images)
    for i, j in monohedral.mirror_images:
        (apex,), (image,) = set(triangles[i]) - set(triangles[j]), set(triangles[j]) - set(triangles[i])
        for x in set(triangles[i]) & set(triangles[j]):  # both ends of the edge are as far from each
            assert _squared(x, apex) == _squared(x, image)


def _squared(p, q):
    return sum((a - b) ** 2 for a, b in zip(p, q, strict=True))


def test_the_triangles_are_congruent_and_tile(monohedral):
    _assert_tiles(monohedral.window, monohedral.triangles)
    for triangle in monohedral.triangles:
        assert sorted(_squared(p, q) for p, q in combinations(triangle, 2)) == list(monohedral.squared_edges)
    assert monohedral.angles == (Fraction(2, 3), Fraction(1, 6), Fraction(1, 6))
    a, b, c = monohedral.squared_edges
    assert c - a - b == a  # the law of cosines for 120°, with a = b


def test_it_is_no_arrangement(monohedral):
    (start, end), triangle, point, barycentric = monohedral.witness
    assert any({start, end} <= set(t) for t in monohedral.triangles)
    assert triangle in monohedral.triangles
    assert point == tuple(q + (q - p) / 4 for p, q in zip(start, end, strict=True))
    columns = zip(*triangle, strict=True)
    assert tuple(sum(w * x for w, x in zip(barycentric, c, strict=True)) for c in columns) == point
    assert min(barycentric) > 0
    assert sum(barycentric) == 1


def test_no_other_triangle_will_do():
    """The angles 2π/a, 2π/b, 2π/c; a corner with an odd number of copies needs the other two equal."""
    found = [
        (a, b, c)
        for a in range(3, 7)
        for b in range(a, 13)
        for c in range(b, 43)
        if Fraction(1, a) + Fraction(1, b) + Fraction(1, c) == Fraction(1, 2)
        and (a % 2 == 0 or b == c)
        and (b % 2 == 0 or a == c)
        and (c % 2 == 0 or a == b)
    ]
    assert found == [(3, 12, 12), (4, 6, 12), (4, 8, 8), (6, 6, 6)]


# -- curves ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("measure", coxeter.MEASURES)
def test_curves_are_the_normalised_qualities(measure):
    data = quality_curves(measure, 9).data
    values = {(curve.family, d): x for curve in data.curves for d, x in curve.values}
    kinds = {(kind.family, kind.rank): kind for kind in triangulations_up_to(9)}
    assert set(values) == set(kinds)
    for key, kind in kinds.items():
        assert values[key] == coxeter.MEASURES[measure].normalized(triangulation(kind).simplex)


def test_points_are_drawn_at_their_values():
    figure = quality_curves("thickness", 6)
    discs = [shape for shape in figure.draw().shapes if isinstance(shape, Disc) and shape.fill == style.BLUE]
    values = [float(x) for _, x in dict(figure.data.curves)["A"]]
    heights = [disc.centre[1] for disc in discs][: len(values)]
    for y, x in zip(heights, values, strict=True):
        assert y - heights[0] == pytest.approx(270 * (values[0] - x))
    steps = {round(q.centre[0] - p.centre[0], 6) for p, q in pairwise(discs[: len(values)])}
    assert len(steps) == 1


def test_the_words_of_the_curves_give_their_numbers():
    words = quality_curves("thickness", 6).alt
    for kind in triangulations_up_to(6):
        assert coxeter.thickness.normalized(triangulation(kind).simplex).decimal(3) in words
    assert "Equal, dimensions 4 to 6: B~, C~, D~." in words
    assert "to the power 1/d" in quality_curves("fatness", 3).alt
    many = quality_curves("aspect_ratio", 20).alt
    assert coxeter.aspect_ratio.normalized(triangulation("D~20").simplex).decimal(3) in many


def test_a_measure_of_ones_own_is_drawn():
    best = coxeter.Measure("edges", "e", lambda simplex: 1 / Surd(simplex.dimension + 1) + simplex.dimension)
    figure = quality_curves(best, 4)
    assert figure.title == "Normalised edges of Coxeter triangulations"
    assert math.isfinite(figure.draw().height)


@pytest.mark.parametrize("dimension", [1, 0, -3, 2.0, True, "4"])
def test_dimensions_of_curves(dimension):
    with pytest.raises(InvalidInput, match="integer >= 2"):
        quality_curves("thickness", dimension)


def test_unknown_measures_are_refused():
    with pytest.raises(InvalidInput, match="no quality measure"):
        quality_curves("beauty")


def test_kinds_can_be_given_as_types():
    assert plane_triangulation(("A", 2)) == plane_triangulation(triangulation("A~2"))
    assert root_system_plane(parse_root_system("A2")) == root_system_plane("A2")
    assert isinstance(root_system_plane("A2"), Figure)
