"""The views of the ledger: all is there, each thing once, links lead somewhere, files can be read back."""

import csv
import io
import json
import re
import shutil
import subprocess
from collections import Counter
from contextlib import nullcontext
from pathlib import Path
from unittest.mock import patch

import book_code
import book_extension
import networkx as nx
import pytest
from bs4 import BeautifulSoup
from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace, patch_docutils
from synthetic import CITED, FALSE, GOOD, RAISES, ledger_of

from coxeter.errors import InvalidInput
from coxeter.ledger import Verdict, all_claims
from coxeter.ledger.inventory import items
from coxeter.ledger.running import run
from coxeter.pages import Judged, Ledger, headline, judge_all, judged
from coxeter.pages.corrected import sheets
from coxeter.pages.dependencies import Dependencies, node_of
from coxeter.pages.errata import GROUPS
from coxeter.pages.judged import Unjudged, gravest
from coxeter.pages.naming import Site, name_of_item
from coxeter.pages.pills import box, pill
from coxeter.pages.tex import to_latex
from coxeter.pages.views import Views
from coxeter.tables import table

SITE = Site("")


def soup(text: str) -> BeautifulSoup:
    return BeautifulSoup(text, "html.parser")


# -- the ledger as a whole ---------------------------------------------------------------------------------


def test_the_numbers_are_those_of_the_ledger(ledger):
    numbers = headline(ledger)
    assert numbers["checked"] == len(all_claims()) == len(ledger)
    by_verdict = ("holds", "corrected", "repaired", "fails", "damaged", "cited", "open")
    assert sum(numbers[name] for name in by_verdict) == numbers["checked"]
    assert numbers["holds"] == sum(x.verdict is Verdict.HOLDS for x in ledger)
    assert numbers["rejected"] == numbers["mutants"] > 0


def test_results_are_kept_for_the_next_time(tmp_path):
    with ledger_of(tmp_path, *GOOD), patch.object(judged, "process_pool", lambda _: nullcontext()):
        first = judge_all(tmp_path / "kept")
        judge_all.cache_clear()
        with patch.object(judged, "verify", side_effect=AssertionError("judged again")):
            assert [x.result for x in judge_all(tmp_path / "kept")] == [x.result for x in first]


def test_results_with_an_error_are_not_kept(tmp_path):
    with ledger_of(tmp_path, RAISES), patch.object(judged, "process_pool", lambda _: nullcontext()):
        (x,) = judge_all(tmp_path / "kept")
    assert not list((tmp_path / "kept").glob("*"))
    with pytest.raises(Unjudged, match=r"thm-92 has no verdict: error"):
        pill([x], SITE)


def test_the_key_follows_the_sources(tmp_path):
    shutil.copytree(judged.LIBRARY / "paper", tmp_path / "paper")
    shutil.copytree(judged.LIBRARY / "pages", tmp_path / "pages")
    with patch.object(judged, "LIBRARY", tmp_path):
        before = judged.sources_key()
        (tmp_path / "pages" / "new.py").write_text("1")
        assert judged.sources_key() == before
        (tmp_path / "paper" / "decimals.json").write_text("[]")
        assert judged.sources_key() != before


def test_an_item_stands_for_its_claims(small):
    found = small.ledger.find("thm-90, thm-9")
    assert [x.id for x in found] == ["thm-90.number", "thm-90.false", "thm-9"]
    assert gravest(found).id == "thm-90.false"


def test_an_unknown_claim_is_refused_with_the_nearest(small):
    with pytest.raises(InvalidInput, match=r"no claim 'thm-90.numbr': did you mean thm-90.number"):
        small.ledger.find("thm-90.numbr")
    with pytest.raises(InvalidInput, match="no claim is named"):
        small.ledger.find(" , ")


def test_dependencies_are_followed_both_ways(small):
    assert small.ledger.closure(["thm-90.false"]) == ("lem-90",)
    assert small.ledger.closure(["thm-90.false"], ("to_state", "to_prove")) == ("def-90", "lem-90")
    assert small.ledger.dependents(["def-90"]) == ("thm-90.number", "thm-90.false")


# -- pills and boxes ---------------------------------------------------------------------------------------


def test_a_pill_says_in_words_what_its_colour_says(small):
    tag = soup(pill(small.ledger.find("thm-90.false"), Site("../"))).a
    assert "fails · instances · a result people use" in tag.get_text()
    assert tag["href"] == "../book/ledger.html#claim-thm-90.false"
    assert tag["title"] == "Words."
    plain = soup(pill(small.ledger.find("thm-9"), SITE)).get_text()
    assert "cited · literature · a result people use" in plain


def test_a_box_tells_what_to_use_instead_and_folds_the_rest(small):
    before, after = box(small.ledger.find("thm-90"), SITE)
    made = soup(before + after)
    assert "Instead: radius 1 at most" in made.get_text()
    assert "the triangle with radius 1/2" not in "".join(
        text for text in made.find_all(string=True) if not text.find_parent("details")
    )
    assert made.find("a", href="checks/coxeter.ledger.section_3.html#false")


# -- errata ------------------------------------------------------------------------------------------------


def test_every_claim_that_is_not_right_is_in_the_errata_once(ledger, views):
    wrong = [x.id for x in ledger if not x.verdict.accepts or x.verdict is Verdict.REPAIRED]
    assert Counter(x.id for e in views.errata for x in e.members) == Counter(wrong)
    assert [e.number for e in views.errata] == list(range(1, len(views.errata) + 1))


def test_the_paper_is_not_blamed_for_our_copy(views):
    for e in views.errata:
        damaged = {x.verdict is Verdict.TRANSCRIPTION for x in e.members}
        assert damaged == {e.kind == "copy"}


def entry(views, id):
    return {x.id for e in views.errata for x in e.members if id in {y.id for y in e.members}}


def test_one_error_in_several_places_is_one_entry(views):
    formula = "aspect-ratio-expression"
    families = ("A", "B", "C", "D", "E6", "E7", "E8", "F4")
    assert entry(views, f"sec6.A.item-6.{formula}") == {f"sec6.{x}.item-6.{formula}" for x in families}
    assert entry(views, "tab-6.B.3") >= {
        "sec6.B.item-5.longest-edge",
        "sec6.B.item-6.thickness",
        "sec6.B.item-7.fatness",
        "tab-2.B.fatness",
        "tab-2.B.thickness",
        "tab-5.B.3",
    }
    assert "tab-2.E6.fatness" in entry(views, "tab-5.E.6")


def test_different_errors_are_different_entries(views):
    assert entry(views, "tab-3.D.7") == {"tab-3.D.7"}
    assert not entry(views, "tab-5.B.3") & entry(views, "tab-5.E.6")
    assert not entry(views, "sec6.A.item-6.thickness-odd") & entry(views, "sec6.B.item-6.thickness")


def test_the_csv_and_json_errata_can_be_read_back(views):
    rows = list(csv.DictReader(io.StringIO(views.files["errata.csv"])))
    entries = json.loads(views.files["errata.json"])
    assert [row["id"] for row in rows] == [x.id for e in views.errata for x in e.members]
    assert [place["id"] for e in entries for place in e["places"]] == [row["id"] for row in rows]
    (cell,) = (row for row in rows if row["id"] == "tab-6.B.3")
    assert (cell["true"], cell["whose"]) == ("0.433", "paper")
    assert "0.500" in cell["printed"]
    assert all(row["printed"] and row["true"] for row in rows)


def balanced(text: str) -> bool:
    depth = 0
    for brace in re.findall(r"(?<!\\)(?:\\\\)*([{}])", text):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0


def test_the_latex_errata_compile(views, tmp_path):
    text = views.files["errata.tex"]
    assert text.isascii()
    assert "[U+" not in text
    assert all(
        balanced(line) for line in text.split("\n") if line.startswith(("\\printed", "\\true", "\\why"))
    )
    assert all(len(re.findall(r"(?<!\\)\$", line)) % 2 == 0 for line in text.split("\n"))
    assert text.count("\\entry{") == len(views.errata)
    if shutil.which("pdflatex"):
        (tmp_path / "errata.tex").write_text(text)
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "errata.tex"]
        assert subprocess.run(command, cwd=tmp_path, capture_output=True).returncode == 0


@pytest.mark.parametrize("bad", ["\\", "50 % of a_b & c", "x ≤ y′ → ∞", "Λ = {±1}", "#1 ~ ^"])
def test_any_words_become_latex(bad):
    made = to_latex(bad)
    assert made.isascii()
    assert balanced(made)
    assert not re.search(r"(?<!\\)[%&#_]", re.sub(r"\$[^$]*\$", "", made))


@pytest.mark.parametrize("group", GROUPS)
def test_the_page_of_errata_has_each_entry(views, group):
    made = soup(views.view(f"errata {group}", [], SITE))
    expected = [f"erratum-{e.number}" for e in views.errata if e.group == group]
    assert [body["id"] for body in made.find_all("tbody")] == expected != []


# -- the ledger's page -------------------------------------------------------------------------------------


def test_every_claim_has_its_row_and_every_link_a_target(ledger, views):
    made = soup(views.view("listing", [], SITE))
    rows = [row["id"] for row in made.find_all("article")]
    assert Counter(rows) == Counter(f"claim-{x.id}" for x in ledger)
    places = [tag["id"] for tag in made.find_all(id=True)]
    assert len(places) == len(set(places))
    inside = {str(tag["href"]) for tag in made.find_all("a", href=re.compile("^#"))}
    assert {address[1:] for address in inside} <= set(places)


def test_links_from_other_views_lead_to_rows(ledger, views):
    pages = ["graph", "dependencies", *(f"errata {group}" for group in GROUPS)]
    for name in pages:
        for tag in soup(views.view(name, [], SITE)).find_all("a", href=re.compile("ledger.html#")):
            assert str(tag["href"]).partition("#claim-")[2] in ledger.by_id


def test_the_summary_adds_up(ledger, views):
    made = soup(views.view("summary", [], SITE))
    *rows, sums = ([cell.get_text() for cell in row.find_all("td")] for row in made.find_all("tr")[1:])
    columns = [[int(x.replace("·", "0")) for x in column] for column in zip(*rows, strict=True)]
    assert [sum(column) for column in columns] == [int(x) for x in sums]
    assert int(sums[-1]) == len(ledger)


def test_the_ledger_as_json(ledger, views):
    data = json.loads(views.files["ledger.json"])
    assert [x["id"] for x in data] == [x.id for x in ledger]
    assert all(x["mutants"]["tried"] == x["mutants"]["rejected"] for x in data)


# -- the graph ---------------------------------------------------------------------------------------------


def test_the_graph_has_every_item(ledger, views):
    made = soup(views.view("graph", [], SITE))
    drawn = {str(tag["data-node"]) for tag in made.find_all("a", attrs={"data-node": True})}
    assert drawn == {node_of(item) for item in items()}
    assert all(tag.title.get_text() for tag in made.find_all("a"))


def test_every_numbered_item_is_found_in_the_graph_by_its_number(views):
    made = soup(views.view("graph", [], SITE))
    names = " ".join(node["data-name"] for node in made.find_all("a", class_="lg-node"))
    numbered = [id for id in items() if re.fullmatch(r"(thm|lem|prop|cor|def)-\d+", id)]
    assert [id for id in numbered if not re.search(rf"\b{name_of_item(id)}\b", names)] == []
    find = made.find("input", {"name": "find"})
    assert find["placeholder"] in names


def test_arrows_that_are_left_out_follow_from_those_shown(ledger):
    graph = Dependencies(ledger)
    assert set(graph.shown) < set(graph.arrows)
    shown = nx.transitive_closure(nx.DiGraph(list(graph.shown)))
    assert all(shown.has_edge(*arrow) for arrow in graph.arrows)


def test_every_arrow_is_drawn_once(ledger, views):
    edges = soup(views.view("graph", [], SITE)).find_all("g", class_="lg-edge")
    drawn = Counter((a, b) for e in edges for a in e["data-from"].split() for b in e["data-to"].split())
    assert drawn == Counter(list(Dependencies(ledger).shown))


# -- tables ------------------------------------------------------------------------------------------------


def test_the_corrected_decimals_are_the_exact_ones():
    for sheet in sheets()[2:]:
        exact = list(csv.reader(io.StringIO(table(sheet.number, 8).render("csv"))))
        assert list(csv.reader(io.StringIO(sheet.render("csv")))) == exact


@pytest.mark.parametrize("sheet", sheets(), ids=lambda sheet: sheet.number)
def test_the_changed_cells_are_marked(ledger, views, sheet):
    made = soup(views.view(f"table {sheet.number}", [], SITE))
    marked = {str(tag.a["href"]).removeprefix("#note-") for tag in made.find_all("td", class_="lg-changed")}
    wrong = {x.id for x in sheet.changed(ledger)}
    assert marked == wrong & {entry.claim for row in sheet.rows for entry in row}
    assert {str(tag["id"]).removeprefix("note-") for tag in made.find_all("li")} == wrong


def test_what_is_printed_is_told_on_hovering(views):
    made = soup(views.view("table 6", [], SITE))
    (cell,) = (tag for tag in made.find_all("td") if tag.find("a", href="#note-tab-6.B.3"))
    assert cell.get_text().startswith("0.433")
    assert "printed 0.500" in cell["title"]


@pytest.mark.parametrize("sheet", sheets(), ids=lambda sheet: sheet.number)
def test_the_downloads_of_a_table_agree(views, sheet):
    rows = list(csv.reader(io.StringIO(views.files[f"table-{sheet.number}.csv"])))
    data = json.loads(views.files[f"table-{sheet.number}.json"])["rows"]
    assert [list(row.values()) for row in data] == rows[1:]
    assert views.files[f"table-{sheet.number}.tex"].count(r"\\") >= len(rows)


# -- what to rely on ---------------------------------------------------------------------------------------


def test_what_is_only_cited_is_named(tmp_path):
    leaning = FALSE.__class__(**{**FALSE.__dict__, "id": "thm-95", "to_prove": ("thm-9",)})
    made = Views(Ledger(tuple(Judged(x, run(x)) for x in (CITED, leaning))))
    text = soup(made.view("trust", ["A title: thm-95"], SITE)).get_text()
    assert "radius 1 at most" in text
    assert "Rests on 1 claims" in text
    assert "Only cited, or tested on instances: Theorem 95, Theorem 9" in text


def test_a_card_without_a_title_is_refused(small):
    with pytest.raises(InvalidInput, match="has no colon"):
        small.view("trust", ["thm-90"], SITE)


def test_an_unknown_view_or_file_is_refused(small):
    with pytest.raises(InvalidInput, match="there is no view 'eratta'; there are summary"):
        small.view("eratta", [], SITE)
    with pytest.raises(InvalidInput, match=r"there is no file 'x\.csv'"):
        small.view("files", ["x.csv: X"], SITE)


# -- in Sphinx ---------------------------------------------------------------------------------------------

PAGE = """# Title {badge}`thm-90`

{badge}`thm-90.false` and {ledger}`checked`.

:::{verdict} lem-90
Some words.
:::

:::{view} summary
:::
"""


def build(tmp_path: Path, small: Views, text: str, builder: str = "html") -> tuple[str, str]:
    """The page that comes out, and the warnings."""
    source = tmp_path / "source"
    (source / "deep").mkdir(parents=True)
    (source / "index.md").write_text("# Start\n\n```{toctree}\ndeep/page\n```\n")
    (source / "deep" / "page.md").write_text(text)
    warnings = io.StringIO()
    settings = {
        "extensions": ["myst_parser", "book_extension"],
        "source_suffix": {".md": "markdown"},  # Sphinx lets apps of one process share the default
        "myst_enable_extensions": ["colon_fence"],
        "html_theme": "basic",
    }
    folders = (source, None, tmp_path / "out", tmp_path / "trees")
    with (
        patch.object(book_extension, "views_in", lambda _: small),
        patch.object(book_code, "pages_of_code", lambda _: []),
        patch_docutils(),
        docutils_namespace(),
    ):
        app = Sphinx(*(x and str(x) for x in folders), builder, settings, None, warnings)
        app.build()
    suffix = {"html": "html", "text": "txt"}[builder]
    return (tmp_path / "out" / "deep" / f"page.{suffix}").read_text(), warnings.getvalue()


def test_roles_and_directives_in_a_page(tmp_path, small):
    page, warnings = build(tmp_path, small, PAGE)
    made = soup(page)
    assert warnings == ""
    address = "../book/ledger.html#claim-thm-90.false"
    assert [tag["href"] for tag in made.select("p > a.lg-pill")][:1] == [address]
    assert f"{len(small.ledger)}." in made.get_text()
    words = made.select_one(".lg-box").get_text()
    assert "Some words." in words
    assert "ours uses the other side" in words
    assert made.select_one("table.lg-summary")
    assert not soup((tmp_path / "out" / "index.html").read_text()).select("li a a")
    assert (tmp_path / "out" / "downloads" / "errata.json").exists()


def test_other_formats_have_words(tmp_path, small):
    page, warnings = build(tmp_path, small, PAGE, "text")
    assert warnings == ""
    assert "[fails · instances · a result people use]" in page
    assert "<" not in page


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{badge}`thm-90.numbr`", "did you mean thm-90.number"),
        ("{ledger}`chekced`", "there is no number 'chekced' of the ledger"),
        (":::{verdict} lem-99\n:::", "there is no claim 'lem-99'"),
        (":::{view} tabel 3\n:::", "there is no view 'tabel 3'"),
        (":::{view} trust\nA title: lem-99\n:::", "there is no claim 'lem-99'"),
    ],
)
def test_what_is_unknown_is_a_warning_with_its_place(tmp_path, small, text, message):
    _, warnings = build(tmp_path, small, f"# Title\n\n{text}\n")
    assert message in warnings
    assert "page.md:3" in warnings
