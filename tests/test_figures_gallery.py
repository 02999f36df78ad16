"""The gallery: every figure has a place, its files, and the Python that makes it; its captions are true."""

import re
from pathlib import Path
from types import SimpleNamespace

import book_figures
import pytest

from coxeter import figures, triangulation
from coxeter.figures.gallery import GALLERY

PAGE = (Path(__file__).parents[1] / "book" / "figures.md").read_text(encoding="utf-8")
SHOWN = re.findall(r"^:::\{drawing\} (\S+)$", PAGE, flags=re.MULTILINE)


def test_the_page_shows_the_gallery_in_order():
    assert list(GALLERY) == SHOWN
    assert list(GALLERY)[:13] == [f"figure-{n}" for n in range(1, 14)]
    for name in SHOWN[:3] + SHOWN[11:13]:
        assert f"### Figure {name.split('-')[1]} · " in PAGE
    for n in range(4, 12):
        assert f"#### Figure {n} · " in PAGE


@pytest.mark.parametrize("name", GALLERY)
def test_the_code_beside_a_figure_makes_it(name):
    made = eval(GALLERY[name].code, vars(figures))
    every = made if isinstance(made, tuple) and not hasattr(made, "svg") else (made,)
    parts = [part for figure in every for part in figure.parts or (figure,)]
    shown = book_figures.drawing(name)
    assert [part.svg for part in parts] == [part.svg for part in shown.parts or (shown,)]


@pytest.mark.parametrize("name", GALLERY)
def test_the_words_say_more_than_the_title(name):
    figure = book_figures.drawing(name)
    assert len(figure.alt) > 60
    assert figure.alt.endswith(".")
    assert len({part.title for part in figure.parts}) == len(figure.parts)


def test_links_to_the_files():
    line = book_figures.links("figure-13", "../")
    assert re.findall(r'href="([^"]*)"', line) == [
        f"../downloads/figure-13.{x}" for x in ("svg", "pdf", "png")
    ]
    assert "PDF of: Two neighbours and their circles" in line
    assert "<code>paper_figure(13)</code>" in line
    assert "&quot;A~2&quot;" in book_figures.links("protection", "")


def test_files_are_painted_once(tmp_path, monkeypatch):
    name = "figure-13"
    monkeypatch.setattr(book_figures, "GALLERY", {name: GALLERY[name]})
    out = tmp_path / "html"
    app = SimpleNamespace(
        outdir=out, builder=SimpleNamespace(format="html"), env=SimpleNamespace(found_docs={"book/figures"})
    )
    (tmp_path / "figures").mkdir()
    (tmp_path / "figures" / "figure-13-old.pdf").write_bytes(b"")
    book_figures.write_figures(app, None)
    written = {path.name: path.read_bytes() for path in (out / "downloads").iterdir()}
    assert set(written) == {f"{name}.svg", f"{name}.pdf", f"{name}.png"}
    assert written[f"{name}.pdf"].startswith(b"%PDF")
    kept = sorted((tmp_path / "figures").iterdir())
    assert len(kept) == 3
    for path in kept:
        path.write_bytes(b"kept")  # is taken as it is the next time
    book_figures.write_figures(app, None)
    assert {path.read_bytes() for path in (out / "downloads").iterdir()} == {b"kept"}


@pytest.mark.parametrize(("error", "docs"), [(ValueError(), {"book/figures"}), (None, {"index"})])
def test_nothing_is_painted_without_the_gallery(error, docs, tmp_path):
    app = SimpleNamespace(
        outdir=tmp_path / "html", builder=SimpleNamespace(format="html"), env=SimpleNamespace(found_docs=docs)
    )
    book_figures.write_figures(app, error)
    assert not list(tmp_path.iterdir())


def _inverse_heights(name):
    return [1 / h for h in triangulation(name).simplex.heights]


def _greatest(values):
    return {k for k, x in enumerate(values) if x == max(values)}


def test_what_the_captions_say_of_heights():
    assert len(set(_inverse_heights("A~7"))) == 1
    assert _greatest(_inverse_heights("B~7")) == {2, 3, 4, 5, 6}
    assert triangulation("B~7").marks[2:] == (2,) * 6
    assert _inverse_heights("C~7") == _inverse_heights("C~7")[::-1]
    assert _greatest(triangulation("D~7").simplex.heights) == {0, 1, 6, 7}
    assert _greatest(_inverse_heights("E~6")) == {4}
    assert _greatest(_inverse_heights("F~4")) == {2}
    assert _greatest(triangulation("F~4").marks) == {3}
    steps = {"E~7": [(0, 1, 3, 4), (7, 6, 5, 4)], "E~8": [(0, 8, 7, 6, 5, 4)]}
    for name, chains in steps.items():
        values = [x / _inverse_heights(name)[0] for x in _inverse_heights(name)]
        for chain in chains:
            assert [values[k] for k in chain] == list(range(1, len(chain) + 1))


def test_what_the_captions_say_of_protection():
    protected = [n for n in ("A~2", "A~3") if figures.protection_spheres(n).data.absolute]
    assert protected == ["A~2", "A~3"]
    assert not any(figures.protection_spheres(n).data.absolute for n in ("C~2", "G~2", "C~3"))
    assert figures.protection_spheres("A~2").data.relative == 1
