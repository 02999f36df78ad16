"""Graphs, their forms, and the classification, against principal minors and against typed lists."""

import itertools
from functools import lru_cache

import networkx as nx
import oracle
import pytest
import sympy

from coxeter import InvalidInput, Type, root_system, triangulations_up_to
from coxeter.diagrams import (
    INFINITE,
    Definiteness,
    affine_diagram,
    as_text,
    bilinear_form,
    cartan_matrix,
    classify,
    coxeter_diagram,
    definiteness,
    inertia,
)

KINDS = triangulations_up_to(8)
GRAPHS = [g for g in nx.graph_atlas_g() if len(g) and nx.is_connected(g)]
UP_TO_SIX = [g for g in GRAPHS if len(g) <= 6]


def path(*labels):
    """A diagram on a line, from the labels of its edges."""
    graph = nx.path_graph(len(labels) + 1)
    nx.set_edge_attributes(graph, dict(zip(graph.edges, labels, strict=True)), "m")
    return graph


def star(*arms):
    """A centre with arms of given lengths."""
    graph = nx.Graph()
    for i, length in enumerate(arms):
        nx.add_path(graph, [0, *((i, j) for j in range(length))])
    return graph


def fork(n, *labels):
    """A line whose first node is doubled, n nodes in all; the last edges carry the given labels."""
    graph = path(*[3] * (n - 2 - len(labels)), *labels)
    graph.add_edge("twin", 1, m=3)
    return graph


def typed_diagrams(n):
    """Humphreys, Figures 1 and 2 of Chapter 2: all crystallographic diagrams with n nodes, by name."""
    found = {f"A{n}": path(*[3] * (n - 1))}
    if n >= 2:
        found[f"B{n}"] = path(*[3] * (n - 2), 4)
    if n >= 4:
        found[f"D{n}"] = star(1, 1, n - 3)
    found |= {2: {"G2": path(6), "A~1": path(INFINITE)}, 4: {"F4": path(3, 4, 3)}}.get(n, {})
    found |= {6: {"E6": star(1, 2, 2)}, 7: {"E7": star(1, 2, 3)}, 8: {"E8": star(1, 2, 4)}}.get(n, {})
    if n >= 3:
        found[f"A~{n - 1}"] = nx.cycle_graph(n)
        found[f"C~{n - 1}"] = path(4, *[3] * (n - 3), 4)
    if n >= 4:
        found[f"B~{n - 1}"] = fork(n, 4)
    if n >= 5:
        double = star(1, 1, n - 4)
        last = (2, n - 6) if n > 5 else 0
        double.add_edge(last, "twin")
        found[f"D~{n - 1}"] = double
    found |= {3: {"G~2": path(3, 6)}, 5: {"F~4": path(3, 3, 4, 3)}}.get(n, {})
    found |= {7: {"E~6": star(2, 2, 2)}, 8: {"E~7": star(1, 3, 3)}, 9: {"E~8": star(1, 2, 5)}}.get(n, {})
    return found


def same_diagram(a, b):
    return nx.is_isomorphic(a, b, edge_match=lambda x, y: x.get("m", 3) == y.get("m", 3))


def name_in_the_list(graph):
    names = [name for name, typed in typed_diagrams(len(graph)).items() if same_diagram(graph, typed)]
    assert len(names) <= 1
    return names[0] if names else None


# -- forms and definiteness ------------------------------------------------------------------------


def principal_minors(matrix):
    n = len(matrix)
    for k in range(1, n + 1):
        for chosen in itertools.combinations(range(n), k):
            yield oracle.determinant([[matrix[i][j] for j in chosen] for i in chosen])


def definiteness_by_minors(graph):
    """Sylvester's criterion, and its version with all principal minors for the semidefinite case."""
    matrix = (2 * sympy.eye(len(graph)) - sympy.Matrix(nx.to_numpy_array(graph, dtype=int))).tolist()
    matrix = [[int(x) for x in row] for row in matrix]
    leading = [oracle.determinant([row[:k] for row in matrix[:k]]) for k in range(1, len(matrix) + 1)]
    if min(leading) > 0:
        return Definiteness.POSITIVE_DEFINITE
    least = min(leading) if min(leading) < 0 else min(principal_minors(matrix))
    return Definiteness.INDEFINITE if least < 0 else Definiteness.POSITIVE_SEMIDEFINITE


def test_there_are_as_many_connected_graphs_as_there_should_be():
    assert [sum(len(g) == n for g in GRAPHS) for n in range(1, 8)] == [1, 1, 2, 6, 21, 112, 853]


@pytest.mark.parametrize("n", range(1, 7))
def test_definiteness_of_every_connected_graph(n):
    for graph in UP_TO_SIX:
        if len(graph) == n:
            assert definiteness(graph) is definiteness_by_minors(graph)


def test_inertia_is_the_signs_of_the_eigenvalues():
    for graph in UP_TO_SIX:
        x = sympy.Symbol("x")
        matrix = 2 * sympy.eye(len(graph)) - sympy.Matrix(nx.to_numpy_array(graph, dtype=int))
        factors = sympy.Poly(matrix.charpoly(x).as_expr(), x).sqf_list()[1]
        zero = sum(m for f, m in factors if f.eval(0) == 0)
        negative = sum(m * f.count_roots(sup=0) for f, m in factors) - zero
        assert inertia(graph)[1:] == (zero, negative)


def test_a_subdiagram_of_a_finite_diagram_is_finite():
    for graph in UP_TO_SIX:
        if definiteness(graph) is Definiteness.POSITIVE_DEFINITE:
            assert all(
                definiteness(graph.subgraph(set(graph) - {v})) is Definiteness.POSITIVE_DEFINITE
                for v in graph
            )


@pytest.mark.parametrize(("label", "cosine"), [(3, 1), (4, 2), (6, 3), (INFINITE, 4)])
def test_the_form_of_one_edge(label, cosine):
    ((a, b), (c, d)) = bilinear_form(path(label)).to_Matrix().tolist()
    assert (a, d) == (2, 2)
    assert b == c == -sympy.sqrt(cosine)


@pytest.mark.parametrize("kind", [k for k in KINDS if k.letter in "ADE"], ids=lambda kind: kind.finite)
def test_cartan_matrix_of_the_diagram_is_that_of_the_roots(kind):
    system = root_system(kind)
    assert cartan_matrix(coxeter_diagram(system)).tolist() == system.cartan_matrix.tolist()


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.finite)
def test_the_form_of_the_affine_diagram_has_the_marks_in_its_kernel(kind):
    """After scaling by lengths: the sum of the m_i·s_i is zero."""
    graph = affine_diagram(root_system(kind))
    weights = [graph.nodes[v]["mark"] * oracle.root_of(graph.nodes[v]["squared_length"]) for v in graph]
    form = bilinear_form(graph).to_Matrix()
    assert all(sympy.expand(x) == 0 for x in form * sympy.Matrix(weights))


# -- classification --------------------------------------------------------------------------------


@lru_cache
def names(n):
    """The name of each connected graph with n nodes."""
    return [(graph, classify(graph)) for graph in GRAPHS if len(graph) == n]


@pytest.mark.parametrize("n", range(1, 8))
def test_unlabelled_graphs_are_classified_completely(n):
    for graph, name in names(n):
        assert name == name_in_the_list(graph)


@pytest.mark.parametrize("n", range(1, 8))
def test_exactly_a_d_e_are_among_the_unlabelled_graphs(n):
    affine = {
        kind.affine for kind in triangulations_up_to(n - 1) if kind.rank == n - 1 and kind.letter in "ADE"
    }
    finite = {f"A{n}"} | {
        kind.finite for kind in triangulations_up_to(n) if kind.rank == n and kind.letter in "DE"
    }
    assert sorted(name for _, name in names(n) if name) == sorted(affine | finite)


def labelled(graph):
    """All ways to write 3, 4 or 6 on the edges, up to symmetry."""
    found = []
    for labels in itertools.product((3, 4, 6), repeat=graph.number_of_edges()):
        copy = nx.Graph(graph)
        nx.set_edge_attributes(copy, dict(zip(copy.edges, labels, strict=True)), "m")
        if not any(same_diagram(copy, other) for other in found):
            found.append(copy)
    return found


SHAPES = [
    *(g for g in GRAPHS if len(g) <= 3),
    nx.path_graph(4),
    nx.star_graph(3),
    nx.cycle_graph(4),
    nx.path_graph(5),
]


@pytest.mark.parametrize("shape", SHAPES, ids=lambda g: f"{len(g)} nodes, {g.number_of_edges()} edges")
def test_labelled_graphs_are_classified_completely(shape):
    for graph in labelled(shape):
        assert classify(graph) == name_in_the_list(graph)


@pytest.mark.parametrize("n", range(1, 11))
def test_each_typed_diagram_gets_its_name(n):
    for name, graph in typed_diagrams(n).items():
        assert classify(graph) == name


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.finite)
def test_diagrams_of_root_systems_get_their_own_name(kind):
    finite = Type("B", kind.rank) if kind.letter == "C" else kind
    assert classify(coxeter_diagram(root_system(kind))) == finite.finite
    assert classify(affine_diagram(root_system(kind))) == kind.affine


def test_two_parallel_walls():
    assert classify(path(INFINITE)) == "A~1"
    assert classify(path(INFINITE, 3)) is None


def test_a_graph_in_pieces_is_not_classified():
    with pytest.raises(InvalidInput, match="classify its components one by one"):
        classify(nx.Graph([(1, 2), (3, 4)]))
    with pytest.raises(InvalidInput, match="empty"):
        classify(nx.Graph())


@pytest.mark.parametrize("label", [0.5, 1, 2, 5, 7, None])
def test_other_labels_are_refused(label):
    with pytest.raises(InvalidInput, match=f"label {label}; crystallographic labels are 3, 4, 6, infinity"):
        definiteness(path(label))


@pytest.mark.parametrize("question", [cartan_matrix, bilinear_form, definiteness, classify])
def test_loops_are_refused(question):
    with pytest.raises(InvalidInput, match="loop"):
        question(nx.Graph([(1, 2), (2, 2)]))


@pytest.mark.parametrize(
    "graph", [nx.DiGraph([(1, 2)]), nx.MultiGraph([(1, 2), (1, 2)])], ids=["directed", "multiple"]
)
@pytest.mark.parametrize("question", [cartan_matrix, bilinear_form, definiteness, classify])
def test_directed_graphs_and_multiple_edges_are_refused(question, graph):
    with pytest.raises(InvalidInput):
        question(graph)


# -- drawing ---------------------------------------------------------------------------------------

DRAWINGS = {
    "A~2": """
.-------.
|       |
0---1---2""",
    "B~4": """
    0
    |
1---2---3-[4]-4""",
    "C~3": """
0-[4]-1---2-[4]-3""",
    "D~4": """
    0
    |
1---2---4
    |
    3""",
    "E~6": """
        0
        |
        2
        |
1---3---4---5---6""",
    "F~4": """
0---1---2-[4]-3---4""",
    "G~2": """
0---2-[6]-1""",
}


@pytest.mark.parametrize("name", DRAWINGS)
def test_drawings(name):
    assert as_text(affine_diagram(root_system(name.replace("~", "")))) == DRAWINGS[name][1:]


@pytest.mark.parametrize("kind", [*KINDS, Type("A", 12), Type("D", 12)], ids=lambda kind: kind.affine)
def test_a_drawing_shows_each_node_once(kind):
    graph = affine_diagram(root_system(kind))
    text = as_text(graph)
    for mark in "-|.[]":
        text = text.replace("[4]", " ").replace("[6]", " ").replace(mark, " ")
    assert sorted(map(int, text.split())) == sorted(graph)


def test_marks_can_be_drawn_instead_of_numbers():
    assert as_text(affine_diagram(root_system("G2")), "mark") == "1---2-[6]-3"
