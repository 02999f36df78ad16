"""The first page: its pictures and its numbers."""

import re

import pytest

from coxeter import triangulation
from coxeter.errors import InvalidInput
from coxeter.exact import Surd
from coxeter.figures import tiling
from coxeter.pages import landing
from coxeter.pages.headline import headline
from coxeter.pages.naming import Site


@pytest.mark.parametrize("name", ["A~2", "C~2", "G~2"])
def test_a_tiling_shows_the_triangulation(name):
    data, t = tiling(name).data, triangulation(name)
    assert data.simplex == tuple(t.simplex.vertices)
    roots = set(t.roots.positive_roots.rows())
    assert {line.root for line in data.lines} == roots  # the window is wide enough for each direction
    for triangle in data.shaded:
        assert data.simplex != triangle
        folded = [t.fold(v) for v in triangle]
        assert [f.point for f in folded] == list(data.simplex)  # vertex k is an image of u_k


@pytest.mark.parametrize("name", ["A~2", "C~2", "G~2"])
def test_tilings_show_tiles_of_one_size(name):
    window = tiling(name).data.window
    share = triangulation(name).simplex.volume / (4 * window.half[0] * window.half[1])
    assert Surd(1) / 27 < share < Surd(1) / 25


def test_only_the_plane_is_tiled():
    with pytest.raises(InvalidInput, match="rank 3"):
        tiling("A~3")


def test_the_row_has_all_three_with_their_names():
    made = landing.tilings()
    assert made.count("<svg") == made.count("<figcaption>") == 3
    assert re.findall(r"<figcaption>.*?([ACG])", made) == ["A", "C", "G"]


def test_the_numbers_are_those_of_the_ledger(ledger):
    made = landing.numbers(ledger, Site(""))
    found = headline(ledger)
    shown = [int(x) for x in re.findall(r"<strong>(\d+)</strong>", made)]
    assert shown == [found["checked"], found["every-d"], found["wrong"], found["open"]]
