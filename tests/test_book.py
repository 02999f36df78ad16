"""What the book adds to its pages: cards, links to code, folds, titles; a link that leads nowhere fails."""

import io
import json
import re
from pathlib import Path
from unittest.mock import patch

import book_cards
import book_code
import book_extension
import nbformat
import pytest
import run_notebooks
from bs4 import BeautifulSoup
from docutils import nodes
from run_notebooks import find_notebook
from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace, patch_docutils

from coxeter.pages import explain
from coxeter.pages.views import Views
from coxeter.proofs import PROOFS, prove

CHAPTER = """# $\\tilde A_d$, $d \\ge 2$

A sentence of $d$. Another.

(here)=
## On $\\tilde B_3$

First. Second.
"""
INDEX = "# Start\n\n```{toctree}\nbook/ledger\nbook/errata\nbook/page\nnotebooks/one\n```\n"
LISTING = "# Ledger\n\n:::{view} listing\n:::\n"
ERRATA = "# Errata\n\n:::{view} errata results\n:::\n"
PAGE = """# Page

{badge}`thm-90.false` and {doc}`../notebooks/one` and {ref}`here` and [out](https://example.org).
By {eq}`gap` the {term}`protection` is positive; {py:func}`halve` does the rest.

```{math}
:label: gap
R' - R > 0
```

```{glossary}
protection
  How far the *others* stay away. More is better.
```

```{py:function} halve(x: int) -> int
Half of it. Not more.
```

:::{verdict} thm-90
:::
"""


def notebook(output: str) -> str:
    cells = [nbformat.v4.new_markdown_cell(CHAPTER), nbformat.v4.new_code_cell('explain("thm-90", "lem-90")')]
    cells[1].metadata["tags"] = ["hide-output"]
    cells[1].outputs = [
        nbformat.v4.new_output("display_data", data={"text/markdown": output, "text/plain": "…"})
    ]
    return nbformat.writes(
        nbformat.v4.new_notebook(
            cells=cells,
            metadata={"kernelspec": {"name": "python3", "display_name": "P", "language": "python"}},
        )
    )


OUTPUT = "Holds (`lem-90`, decided by `coxeter.proofs.sizes.longest_edge`), unlike `other`, for $d$."


@pytest.fixture
def book(tmp_path, small: Views):
    """Render a small book; gives the folder and the warnings."""

    def render(page: str = PAGE, output: str = OUTPUT) -> tuple[Path, str]:
        files = {"index.md": INDEX, "book/ledger.md": LISTING, "book/errata.md": ERRATA, "book/page.md": page}
        for name, text in {**files, "notebooks/one.ipynb": notebook(output)}.items():
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        warnings = io.StringIO()
        settings = {
            "extensions": ["myst_nb", "book_extension"],
            "nb_execution_mode": "off",
            "nb_render_markdown_format": "myst",
            "source_suffix": {
                ".md": "myst-nb",
                ".ipynb": "myst-nb",
            },  # Sphinx lets apps of one process share the default
            "myst_enable_extensions": ["colon_fence", "dollarmath"],
            "html_theme": "basic",
        }
        folders = (tmp_path, None, tmp_path / "out", tmp_path / "trees")
        with (
            patch.object(book_extension, "views_in", lambda _: small),
            patch_docutils(),
            docutils_namespace(),
        ):
            app = Sphinx(*(x and str(x) for x in folders), "html", settings, None, warnings)
            app.build()
        return tmp_path / "out", re.sub("\x1b\\[[0-9;]*m", "", warnings.getvalue())

    return render


def soup(file: Path) -> BeautifulSoup:
    return BeautifulSoup(file.read_text(encoding="utf-8"), "html.parser")


def cards_in(page: BeautifulSoup) -> dict[str, str]:
    return json.loads(page.find(id="cx-cards").string)


def test_each_row_of_the_ledger_leads_to_its_chapter(book):
    chapter = (
        "\n## Both\n\n{badge}`lem-90` {badge}`thm-90.false`\n\n## The lemma\n\n:::{verdict} lem-90\n:::\n"
    )
    with patch(f"{__name__}.CHAPTER", CHAPTER + chapter):
        out, warnings = book()
    assert warnings == ""
    page = soup(out / "book" / "ledger.html")

    def leads(id: str) -> list[str]:
        row = page.find(id=f"claim-{id}")
        return [str(a["href"]) for a in row.select(".lg-meta a") if a.get_text() == "chapter"]

    assert leads("lem-90") == ["../notebooks/one.html#the-lemma"]
    assert leads("thm-90.false") == ["../notebooks/one.html#both"]
    assert sum(len(leads(row["id"].removeprefix("claim-"))) for row in page.select(".lg-claim")) == 2


def test_each_page_has_the_cards_of_its_links(book):
    out, warnings = book()
    assert warnings == ""
    page = soup(out / "book" / "page.html")
    cards = cards_in(page)
    inside = {a["href"] for a in page.select(".body a.internal, .body a.lg-pill")}
    assert inside <= set(cards)
    assert not any("example.org" in address for address in cards)
    claim = cards["../book/ledger.html#claim-thm-90.false"]
    assert "Theorem 90" in claim
    assert "radius 1 at most" in claim
    assert cards["../notebooks/one.html"].count("A sentence of") == 1
    assert "Another" not in cards["../notebooks/one.html"]
    (section,) = (text for address, text in cards.items() if "one.html#" in address)
    assert "First." in section
    assert "Second" not in section
    assert "\\(\\tilde B_3\\)" in section
    assert any(
        script["src"].startswith("../_static/cards.js") for script in page.find_all("script", src=True)
    )


def test_equations_words_and_functions_have_cards(book):
    out, warnings = book()
    assert warnings == ""
    cards = cards_in(soup(out / "book" / "page.html"))
    assert "\\(R' - R &gt; 0\\)" in cards["#equation-gap"]
    assert cards["#term-protection"].endswith("<p>How far the <em>others</em> stay away.</p>")
    function = BeautifulSoup(cards["#halve"], "html.parser").get_text(" ")
    assert function == "halve(x: int) -> int Half of it."


def test_the_ledger_leaves_its_own_claims_to_the_script(book):
    out, _ = book()
    assert cards_in(soup(out / "book" / "ledger.html")) == {}


@pytest.mark.parametrize(
    ("link", "message"),
    [
        ("[x](ledger.md#claim-thm-99)", "thm-99"),
        ('<a href="ledger.html#claim-thm-99">x</a>', "book/ledger.html#claim-thm-99 leads nowhere"),
        ('<a href="errata.html#erratum-99">x</a>', "book/errata.html#erratum-99 leads nowhere"),
        ('<a href="../notebooks/one.html#there">x</a>', "notebooks/one.html#there leads nowhere"),
        ('<a href="two.html">x</a>', "book/two.html# leads nowhere"),
    ],
)
def test_a_link_that_leads_nowhere_is_a_warning(book, link, message):
    _, warnings = book(f"# Page\n\n{link}\n")
    assert message in warnings


def test_names_in_outputs_lead_to_claims_and_code(book):
    out, _ = book()
    output = soup(out / "notebooks" / "one.html").select_one(".cell_output")
    assert [a["href"] for a in output.find_all("a")] == [
        "../book/ledger.html#claim-lem-90",
        "../checks/coxeter.proofs.sizes.html#longest_edge",
    ]
    assert output.find_all("a")[1]["title"] == "coxeter.proofs.sizes.longest_edge"
    code = soup(out / "checks" / "coxeter.proofs.sizes.html")
    line = code.find(id="longest_edge").next_siblings
    assert "def longest_edge" in "".join(x.get_text() for x in list(line)[:6])


def test_a_name_without_a_page_is_a_warning(book):
    _, warnings = book(output="Decided by `coxeter.proofs.sizes.no_such`.")
    assert "an output names coxeter.proofs.sizes.no_such, which has no page" in warnings


def test_what_is_folded_says_what_it_is(book):
    out, _ = book()
    summary = soup(out / "notebooks" / "one.html").select_one("details.hide summary")
    assert "How this is known: Theorem 90, Lemma 90 (3 claims)" in summary.get_text()
    assert not summary.has_attr("aria-label")
    assert [x.get_text() for x in summary.parent.select(".lg-tex")] == ["\\(d\\)"]
    assert not summary.parent.select(".math")


def test_titles_are_plain_where_no_script_sets_formulas(book):
    out, _ = book()
    page = soup(out / "notebooks" / "one.html")
    assert page.title.get_text().startswith("Ã_d, d ≥ 2")
    assert "\\tilde A_d" in page.h1.get_text()
    index = (out / "searchindex.js").read_text(encoding="utf-8")
    found = json.loads(index.removeprefix("Search.setIndex(").removesuffix(")"))
    assert "Ã, d ≥ 2" in found["titles"]
    assert not [title for title in [*found["titles"], *found["alltitles"]] if "\\" in title or "<" in title]
    (link,) = soup(out / "book" / "page.html").select(".body a[href*='notebooks/one']:has(sub)")
    assert (link.get_text(), link.sub.get_text()) == ("Ãd, d ≥ 2", "d")


def test_a_search_from_the_file_system_reads_no_other_page(book, browser):
    out, _ = book()
    page = browser.new_page()
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{(out / 'search.html').as_uri()}?q=sentence")
    page.wait_for_selector("#search-results li a")
    page.wait_for_timeout(300)
    page.close()
    assert errors == []


# -- the parts ---------------------------------------------------------------------------------------------


def test_every_step_of_a_proof_names_code_that_has_a_page(ledger):
    about = {
        "quantity": ("A", "fatness"),
        "best": ("thickness",),
        "rate": ("A", "thickness"),
        "vertices": ("B",),
    }
    proofs = [
        prove(name, *about.get(name, ())) for name in (*about, "lemma_13", "proposition_10", "distances")
    ]
    assert all(name in PROOFS for name in about)
    steps = [step for proof in proofs for step in proof.steps]
    places = book_code.places(ledger)
    for step in steps:
        module, _, function = step.code.rpartition(".")
        assert function in places[module]


def test_what_explains_a_claim_names_the_claims_and_the_code(ledger):
    text = explain("sec6.C.item-5")._repr_markdown_()
    assert "`coxeter.ledger.record_formulas.judge_formula`" in text
    assert "*inequality*, `coxeter.proofs.sizes._no_longer`" in text
    named = set(re.findall(r"`([^`]+)`", text))
    assert all(book_code.reference(name, ledger, "notebooks/x") is not None for name in named)


def test_the_first_sentence_is_cut_between_words_only():
    paragraph = nodes.paragraph(
        "", "", nodes.Text("With 0.5 & more, "), nodes.literal("", "a. b"), nodes.Text(". Then.")
    )
    assert book_cards.cut(paragraph) == "With 0.5 &amp; more, <code>a. b</code>."


def test_pages_of_source_have_every_check(ledger):
    places = book_code.places(ledger)
    assert all(x.claim.code.rpartition(".")[2] in places[x.claim.code.rpartition(".")[0]] for x in ledger)
    assert {"longest_edge", "_longest"} <= places["coxeter.proofs.sizes"]


def test_notebooks_are_named(capsys):
    assert find_notebook("family-A") == find_notebook("notebooks/family-A.ipynb")
    for words, told in ((["--help"], "all by default"), (["famly-A"], "did you mean 'family-A'?")):
        with pytest.raises(SystemExit) as stop:
            run_notebooks.main(words)
        assert bool(stop.value.code) is (words != ["--help"])
        assert told in "".join(capsys.readouterr())


def test_only_the_named_notebooks_are_run(monkeypatch):
    ran = []
    monkeypatch.setattr(run_notebooks, "store", lambda path: ran.append(path.stem) or "stored")
    assert run_notebooks.main(["family-B", "section-2.ipynb"]) == 0
    assert sorted(ran) == ["family-B", "section-2"]
    ran.clear()
    assert run_notebooks.main([]) == 0
    assert len(ran) == len(run_notebooks.all_notebooks()) > 10
