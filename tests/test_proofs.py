"""Proofs for every d: they replay on the exact core, and wrong formulas are refuted."""

from dataclasses import replace

import pytest

from coxeter.errors import InvalidInput, Undecided
from coxeter.exact import Surd
from coxeter.families import Piece, closed_form
from coxeter.ledger.mutants import mutants
from coxeter.proofs import PROOFS, Refuted, ReplayFailed, prove
from coxeter.proofs.appendix_c import relative_protection
from coxeter.proofs.best import LEAD, SQUARES, ranking
from coxeter.proofs.classical import FAMILIES
from coxeter.proofs.measures import DEFINITIONS, LENGTHS, quantity
from coxeter.proofs.proof import Proof, argument, formulas, identity, inequality
from coxeter.proofs.rates import rate
from coxeter.proofs.simplices import circumradius, inradius, level
from coxeter.symbolic.runs import runs

QUANTITIES = (*LENGTHS, *DEFINITIONS, *(f"normalized_{name}" for name in DEFINITIONS))
ABOUT = {
    "vertices": [(x,) for x in "ABCD"],
    "quantity": [(x, name) for x in "ABCD" for name in QUANTITIES],
    "position_of_circumcentre": [(x,) for x in "ABCD"],
    "best": [(name,) for name in DEFINITIONS],
    "rate": [(x, name) for x in "ABCD" for name in DEFINITIONS],
    "affine_images": [(name,) for name in (*DEFINITIONS, "relative_protection")],
}
ALL = [(name, *about) for name in PROOFS for about in ABOUT.get(name, [()])]


@pytest.mark.parametrize("names", ALL, ids=" ".join)
def test_every_proof_replays_on_the_core(names):
    proof = prove(*names)
    assert proof.decided > 0
    assert proof.replay(12) >= proof.decided
    assert all(step.check for step in proof.steps if step.kind != "argument")


@pytest.mark.parametrize("names", ALL, ids=" ".join)
def test_every_proof_prints_as_mathematics(names):
    text = prove(*names)._repr_markdown_()
    assert text.count("$") % 2 == 0
    assert text.startswith("**To show:**")
    assert "decided by computation" in text


def pieces(letter, name):
    return [(letter, name, piece) for piece in closed_form(letter, name).pieces if piece.high is None]


EVERY_PIECE = [x for letter in "ABCD" for name in QUANTITIES for x in pieces(letter, name)]


@pytest.mark.parametrize(("letter", "name", "piece"), EVERY_PIECE, ids=str)
def test_wrong_formulas_are_refuted(letter, name, piece):
    moved = [text for _, constants in mutants({"f": piece.text}) for text in [constants["f"]]]
    assert moved
    for text in moved[:6]:
        wrong = (Piece(text, piece.low, None, piece.parity),)
        with pytest.raises((Refuted, Undecided, InvalidInput, ZeroDivisionError)):
            quantity(letter, name, wrong)


def test_a_refutation_names_the_first_number():
    with pytest.raises(Refuted, match="d = 3 it is 1/2, not 3/4"):
        formulas("the value", "x", "1/2", "d/4", 3)
    with pytest.raises(Refuted, match="k = 1, d = 1 it is 1, not 2"):
        identity("the value", "x", "k", "k + d", "1 <= k <= d")
    with pytest.raises(Refuted, match="d = 2"):
        inequality("the value", "x", "d - 3", "2 <= d")


def test_undecided_is_not_refuted():
    # it is true, and the signs of its coefficients do not show it
    with pytest.raises(Undecided):
        inequality("a square", "x", "(d - 3)**2", "0 <= d")


def test_a_wrong_vertex_and_wrong_centres_are_refuted():
    family = FAMILIES["B"]
    pair = next(p for p in family.pairs() if p.same and p.k == "k")
    with pytest.raises(Refuted):
        level(family, pair, runs(("1/2", "k + 1"), ("0", "d - k - 1")))
    with pytest.raises(Refuted):
        circumradius("D", centre=runs(("1/4", "d")))
    with pytest.raises(Refuted):
        inradius("C", centre=runs(("1/4", "d")))
    with pytest.raises(Refuted):
        relative_protection("sqrt(1 + 25/(d*(d + 2))) - 1")
    with pytest.raises(Refuted):
        rate("A", "thickness", Surd(3))


def test_the_lengths_of_all_roots_are_among_the_steps():
    """The highest root is a dominant root that is as long as any: this needs them."""
    names = [step.formula for step in prove("vertices", "B").steps]
    assert r"\|s_{d}\|^2 = 1" in names
    assert r"\langle\tilde s, \tilde s\rangle = 2" in names


def test_both_kinds_of_short_coroots_are_steps():
    names = " ".join(step.formula for step in prove("proposition_9").steps)
    assert all(f"e_j {sign} e_k, e_j {sign} e_k" in names for sign in "+-")


def test_the_replay_of_the_longest_edge_sees_no_smaller_dimension():
    steps = [x for x in prove("quantity", "B", "longest_edge").steps if x.words.startswith("the edge from")]
    assert len(steps) > 3
    assert all(step.replay(3) == 0 < step.replay(6) for step in steps)


def test_a_replay_notices_a_core_that_disagrees():
    step = identity("d", "d", "d", "d", "2 <= d", lambda d: Surd(d + (d == 7)))
    assert step.replay(6) == 5
    with pytest.raises(ReplayFailed, match="d = 7 the core has 8, the formula 7"):
        step.replay(8)
    step = inequality("d", "d", "d - 2", "2 <= d", core=lambda d: Surd(5 - d))
    with pytest.raises(ReplayFailed, match="d = 6"):
        step.replay(9)


def test_the_squares_that_are_compared_are_all_there():
    assert set(SQUARES) == set(DEFINITIONS) - {"fatness"}
    assert all(set(squares) == set("ABCD") for squares in SQUARES.values())
    assert set(LEAD) == set("BCD")


@pytest.mark.parametrize("d", range(2, 13))
@pytest.mark.parametrize("measure", DEFINITIONS)
def test_the_best_family_by_computation(measure, d):
    assert ranking(measure, d)[0] == f"A~{d}"


def test_proofs_are_found_by_name():
    assert prove("lemma_13") is prove("lemma_13")
    with pytest.raises(InvalidInput, match="there is no proof 'lemma'"):
        prove("lemma")


def test_words_alone_decide_nothing():
    proof = Proof("something", (argument("Obviously"),))
    assert (proof.decided, proof.replay()) == (0, 0)
    assert "0 steps decided by computation, 1 argued in words" in proof._repr_markdown_()


@pytest.mark.parametrize("name", QUANTITIES)
@pytest.mark.parametrize("letter", "AB")
def test_a_formula_in_the_wrong_range_is_refuted(letter, name):
    """Right for odd d, claimed for all; right from d = 4 on, claimed from d = 3."""
    first, *others = closed_form(letter, name).pieces
    for piece in others:
        for wrong in (Piece(piece.text, 3), Piece(first.text, 3), replace(first, text=piece.text)):
            with pytest.raises((Refuted, InvalidInput)):
                quantity(letter, name, (wrong,))


@pytest.mark.parametrize(
    ("letter", "name", "claimed"),
    [
        ("B", "thickness", (Piece("1/sqrt(2*d)", 3),)),
        ("B", "minimal_height", (Piece("7", 3, 3), Piece("1/(2*sqrt(2))", 4))),
        ("A", "thickness", (Piece("sqrt(2/(d + 1))", 2),)),
    ],
)
def test_a_formula_that_fails_in_one_dimension_is_refuted(letter, name, claimed):
    with pytest.raises(Refuted, match=r"for d = \d"):
        quantity(letter, name, claimed)


@pytest.mark.parametrize(
    "claimed",
    [
        (Piece("sqrt(2/(d + 1))", 3, None, "odd"),),
        (Piece("17", 2, 3),),
        (Piece("17", 1, 1), *closed_form("A", "thickness").pieces),
        (Piece("17", 2, 2), *closed_form("A", "thickness").pieces),
    ],
)
def test_formulas_must_cover_the_family(claimed):
    with pytest.raises((InvalidInput, StopIteration), match=r"there must be one formula|there is no"):
        quantity("A", "thickness", claimed)


def test_centres_must_lie_in_the_hyperplane_of_the_simplex():
    shifted = runs(("(d/2 + 1 - i)/(d + 1) + 1", "d + 1"))
    with pytest.raises(Refuted, match="add up to 0"):
        circumradius("A", "sqrt(d*(d + 2)/(12*(d + 1)) + d + 1)", shifted)
    with pytest.raises(Refuted, match="add up to 0"):
        inradius("A", None, shifted)
