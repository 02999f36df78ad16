"""Is the vertex set a lattice? Two routes, brute force, and certificates that cannot be forged."""

from dataclasses import replace
from fractions import Fraction
from functools import lru_cache

import oracle
import pytest
import sympy
from sympy import ZZ
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.normalforms import hermite_normal_form

from coxeter import (
    Lattice,
    RationalMatrix,
    Type,
    coroot_lattice,
    coweight_lattice,
    spanned_lattice,
    triangulation,
    triangulations_up_to,
    vertex_cosets,
    vertex_lattice,
)
from coxeter.lattices import LatticeProof

KINDS = triangulations_up_to(8)
SMALL = triangulations_up_to(4)
LARGE = [Type(letter, d) for letter in "ABCD" for d in (15, 24)]
BRUTE = [*triangulations_up_to(3), Type("D", 4)]


def every(kinds=KINDS):
    return pytest.mark.parametrize("kind", kinds, ids=lambda kind: kind.affine)


def key(kind):
    return kind.letter, kind.rank


def is_lattice(kind):
    return kind.letter in "AC" or kind == Type("D", 4)


# -- the answers -----------------------------------------------------------------------------------


@every(KINDS + LARGE)
def test_a_c_and_d4_and_no_other(kind):
    assert (
        bool(vertex_lattice(triangulation(kind)))
        == vertex_lattice(triangulation(kind)).is_lattice
        == is_lattice(kind)
    )


@every(KINDS + LARGE)
def test_every_answer_can_be_checked(kind):
    assert vertex_lattice(triangulation(kind)).check()


@every()
def test_counting_cosets_and_looking_for_a_witness_agree(kind):
    t = triangulation(kind)
    spanned = coroot_lattice(t.roots).index_in(spanned_lattice(t))
    assert (spanned == sum(vertex_cosets(t))) == is_lattice(kind)
    assert spanned >= sum(vertex_cosets(t))


@every([kind for kind in KINDS if is_lattice(kind)])
def test_the_lattice_of_the_proof(kind):
    t = triangulation(kind)
    proof = vertex_lattice(t)
    assert proof.lattice == spanned_lattice(t)
    assert str(sum(proof.cosets)) in str(proof)
    if kind.letter == "A":
        assert proof.lattice == coweight_lattice(t.roots)
    if kind.letter == "C":
        assert proof.lattice == scaled(Lattice(RationalMatrix.identity(kind.rank)), Fraction(1, 2))


@every([kind for kind in KINDS if not is_lattice(kind)])
def test_the_witness_is_the_difference_of_two_vertices(kind):
    t = triangulation(kind)
    witness = vertex_lattice(t)
    points = oracle.vertices(*key(kind))
    assert witness.difference == oracle.minus(points[witness.first], points[witness.second])
    assert not t.is_vertex(witness.difference)
    assert f"u_{witness.first} - u_{witness.second}" in str(witness)


# -- brute force -----------------------------------------------------------------------------------


@lru_cache
def ball(kind, squared_radius):
    origin = (Fraction(0),) * len(oracle.vertices(*key(kind))[0])
    return oracle.vertices_in_ball(*key(kind), origin, squared_radius)


def reach(kind):
    return max(oracle.squared_edges(oracle.vertices(*key(kind))).values())


@every(BRUTE)
def test_brute_force_on_a_ball(kind):
    near, far = ball(kind, reach(kind)), ball(kind, 4 * reach(kind))
    assert oracle.differences_stay(near, far) == is_lattice(kind)


@every(BRUTE)
def test_the_spanned_lattice_is_spanned_by_the_vertices_in_a_ball(kind):
    """The Hermite normal form of all of them, in the coordinates of the simple roots."""
    rows = [oracle.coordinates(*key(kind), x) for x in ball(kind, reach(kind))]
    scale = int(sympy.ilcm(*(x.denominator for row in rows for x in row)))
    columns = DomainMatrix(
        [[int(scale * x) for x in row] for row in rows], (len(rows), kind.rank), ZZ
    ).transpose()
    basis = hermite_normal_form(columns).transpose().to_list()
    vectors = [
        oracle.combine([Fraction(int(x), scale) for x in row], oracle.simple_roots(*key(kind)))
        for row in basis
    ]
    assert spanned_lattice(triangulation(kind)) == Lattice.spanned_by(vectors)


@every(SMALL)
def test_cosets_by_listing_the_orbits(kind):
    """Two points are in one coset if their coordinates in the simple coroots differ by integers."""
    simple = oracle.simple_roots(*key(kind))
    scales = [oracle.dot(s, s) / 2 for s in simple]
    counts = []
    for u in oracle.vertices(*key(kind)):
        images = oracle.orbit([u], simple)
        counts.append(
            len(
                {
                    tuple(c * f % 1 for c, f in zip(oracle.coordinates(*key(kind), x), scales, strict=True))
                    for x in images
                }
            )
        )
    assert vertex_cosets(triangulation(kind)) == tuple(counts)


@every()
def test_every_vertex_of_the_simplex_is_in_the_spanned_lattice(kind):
    t = triangulation(kind)
    lattice = spanned_lattice(t)
    for x in oracle.vertices(*key(kind)):
        assert x in lattice
        assert all(oracle.reflect(x, s) in lattice for s in oracle.simple_roots(*key(kind)))
    assert coroot_lattice(t.roots) <= lattice


# -- certificates cannot be forged -----------------------------------------------------------------


def scaled(lattice, factor):
    return Lattice.spanned_by([tuple(factor * x for x in row) for row in lattice.basis.rows()])


@pytest.mark.parametrize("name", ["A~3", "C~3", "D~4"])
def test_a_proof_with_another_lattice_is_rejected(name):
    proof = vertex_lattice(triangulation(name))
    for factor in (2, Fraction(1, 2), Fraction(2, 3)):
        assert not replace(proof, lattice=scaled(proof.lattice, factor)).check()
    assert not replace(proof, lattice=coroot_lattice(proof.triangulation.roots)).check()


@pytest.mark.parametrize("name", ["A~3", "C~3", "D~4"])
def test_a_proof_with_another_lattice_of_the_right_index_is_rejected(name):
    proof = vertex_lattice(triangulation(name))
    first, *rest = coroot_lattice(proof.triangulation.roots).basis.rows()
    index = sum(proof.cosets)
    other = Lattice.spanned_by([tuple(x / index for x in first), *rest])
    assert not replace(proof, lattice=other).check()


def test_a_lattice_of_the_right_index_that_the_reflections_move_is_rejected():
    """The vertices of the triangle G~2 span a lattice of index 1 + 2 + 3, but not all vertices lie in it."""
    t = triangulation("G~2")
    lattice = Lattice.spanned_by(t.simplex.vertices[1:])
    assert coroot_lattice(t.roots).index_in(lattice) == sum(vertex_cosets(t))
    assert not LatticeProof(t, lattice, vertex_cosets(t)).check()


@pytest.mark.parametrize("name", ["A~3", "C~3", "D~4"])
def test_a_proof_with_other_counts_is_rejected(name):
    proof = vertex_lattice(triangulation(name))
    first, *rest = proof.cosets
    assert not replace(proof, cosets=(first + 1, *rest)).check()
    assert not replace(proof, cosets=(first + 1, rest[0] - 1, *rest[1:])).check()
    assert not replace(proof, cosets=(sum(proof.cosets),)).check()


@pytest.mark.parametrize("name", ["B~3", "G~2", "D~5", "F~4"])
def test_a_proof_of_what_is_false_is_rejected(name):
    t = triangulation(name)
    lattice = spanned_lattice(t)
    index = coroot_lattice(t.roots).index_in(lattice)
    invented = (index - t.dimension,) + (1,) * t.dimension
    assert not LatticeProof(t, lattice, invented).check()
    assert not LatticeProof(t, lattice, vertex_cosets(t)).check()


@pytest.mark.parametrize("name", ["B~3", "G~2", "E~6"])
def test_a_witness_with_other_vertices_is_rejected(name):
    witness = vertex_lattice(triangulation(name))
    assert not replace(witness, first=witness.second, second=witness.first).check()
    assert not replace(witness, second=witness.first).check()


@pytest.mark.parametrize("name", ["B~3", "G~2", "E~6"])
def test_a_witness_with_another_folding_is_rejected(name):
    witness = vertex_lattice(triangulation(name))
    folding = witness.folding
    elsewhere = tuple(x + 1 for x in folding.point)
    assert not replace(witness, folding=replace(folding, word=())).check()
    assert not replace(witness, folding=replace(folding, point=elsewhere)).check()
    assert not replace(witness, folding=replace(folding, word=(99,))).check()


def test_a_witness_against_a_lattice_is_rejected():
    t = triangulation("C~3")
    witness = replace(vertex_lattice(triangulation("B~3")), triangulation=t)
    difference = witness.difference
    assert not replace(witness, folding=t.fold(difference)).check()
