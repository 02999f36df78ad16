"""The scripts of the book in a browser, on small pages from file://; skipped where there is no browser."""

import csv
import io
import json
import re
import shutil
import subprocess
from collections import Counter
from pathlib import Path

import plotly
import pytest
from run_notebooks import ROOT

from coxeter import Surd, triangulation
from coxeter.exact import sqrt
from coxeter.pages.cards import claim_card
from coxeter.pages.judged import FIRMNESS, GRAVITY
from coxeter.pages.naming import Site
from coxeter.scenes import scene
from coxeter.tables import Table, table

STATIC = ROOT / "book" / "_static"
SITE = Site("")


@pytest.fixture
def show(browser, tmp_path):
    """Open a page with some HTML and some scripts; an error in a script fails the test."""
    errors, pages = [], []

    def open_(body: str, *scripts: str, place: str = "", cards: dict | None = None):
        tags = "".join(f'<script defer src="{(STATIC / name).as_uri()}"></script>' for name in scripts)
        styles = "".join(
            f'<link rel="stylesheet" href="{(STATIC / x).as_uri()}">' for x in ("ledger.css", "reading.css")
        )
        data = "" if cards is None else json.dumps(cards).replace("</", "<\\/")
        body += f'<script type="application/json" id="cx-cards">{data}</script>' if cards is not None else ""
        file = tmp_path / "page.html"
        head = f'<meta charset="utf-8">{styles}{tags}'
        article = f'<article class="bd-article">{body}</article>'
        file.write_text(f"<!doctype html><html><head>{head}</head><body>{article}</body></html>")
        page = browser.new_page(viewport={"width": 1200, "height": 800})
        page.on("pageerror", lambda error: errors.append(str(error)))
        page.goto(file.as_uri() + place)
        pages.append(page)
        return page

    yield open_
    for page in pages:
        page.close()
    assert errors == []


# -- tables ------------------------------------------------------------------------------------------------


def download(page, words: str) -> str:
    with page.expect_download() as waiting:
        page.get_by_role("button", name=words, exact=True).click()
    return Path(waiting.value.path()).read_text(encoding="utf-8").rstrip("\n")


def test_the_downloads_of_a_table_are_those_of_the_library(show):
    made = table(5, max_dim=6)
    page = show(made._repr_html_(), "tables.js")
    assert download(page, "CSV") == made.render("csv")
    assert json.loads(download(page, "JSON")) == json.loads(made.render("json"))
    page.get_by_role("button", name="Exact values").click()
    assert download(page, "CSV") == made.render("csv", exact=True)
    assert download(page, "LaTeX") == made.render("latex", exact=True)


def test_exact_values_are_set_as_the_library_sets_them(show):
    values = {triangulation(name).simplex.circumradius for name in ("A~4", "B~5", "E~7")}
    values |= {
        Surd(0),
        Surd(-3),
        Surd(2) / 7,
        sqrt(2) - sqrt(3) / 5,
        4 / (3 + 3 * sqrt(2)),
        -1 + sqrt(65) / 5,
    }
    values |= {
        (1 + sqrt(2)) / (3 - sqrt(5)),
        (Surd(27) / 28672).root(12),
        Surd(2).root(3),
        (1 + sqrt(2)).root(4),
    }
    rows = tuple((str(n), x) for n, x in enumerate(sorted(values)))
    page = show(Table("Values", ("n", "x"), rows)._repr_html_(), "tables.js")
    page.get_by_role("button", name="Exact values").click()
    shown = page.locator("td[title]").all_text_contents()
    assert shown == [f"\\({x.latex()}\\)" for _, x in rows]
    page.get_by_role("button", name="Exact values").click()
    assert page.locator("td[title]").first.inner_text() == rows[0][1].decimal(3)


def test_any_table_becomes_latex_that_compiles(show, tmp_path):
    rows = (
        ("B~3", "u_1 = (0^{3}, 1/2) & 50 % of #1"),
        ("τ_0", "d ≥ 2 … ∞, x < y | {~^\\}"),
        ("日", "[1] – “a”"),
    )
    page = show(Table("Odd & ends", ("name", "a_b"), rows)._repr_html_(), "tables.js")
    text = download(page, "LaTeX")
    assert r"$\tilde{B}_{3}$" in text.replace("$$", "")
    assert "[U+65e5]" in text
    outside = re.sub(r"\$[^$]*\$", "", text.split("\\hline", 1)[1])
    assert not re.search(r"(?<!\\)[%#_^]|\|", outside)
    assert len(re.findall(r"(?<!\\)\$", text)) % 2 == 0
    read = list(csv.reader(io.StringIO(download(page, "CSV"))))
    assert read[1] == list(rows[0])
    if shutil.which("pdflatex"):
        whole = (
            f"\\documentclass{{article}}\\usepackage{{latexsym}}\\begin{{document}}{text}\\end{{document}}"
        )
        (tmp_path / "x.tex").write_text(whole)
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "x.tex"]
        assert subprocess.run(command, cwd=tmp_path, capture_output=True).returncode == 0


def test_a_table_without_a_head_has_rows_only(show):
    rows = "".join(f"<tr><td>\\({letter}\\)</td><td>≈ 0.7</td></tr>" for letter in "Rrh")
    page = show(f"<h2>Facts</h2><table><tbody>{rows}</tbody></table>", "tables.js")
    assert download(page, "CSV") == "R,≈ 0.7\nr,≈ 0.7\nh,≈ 0.7"
    expected = {"title": "Table", "rows": [["R", "≈ 0.7"], ["r", "≈ 0.7"], ["h", "≈ 0.7"]]}
    assert json.loads(download(page, "JSON")) == expected
    assert download(page, "LaTeX").count("\\hline") == 2
    assert not page.get_by_role("button", name="Exact values").count()


@pytest.mark.parametrize("number", [1, 2, 3])
def test_what_a_glance_takes_in_has_no_downloads(show, number):
    rows = (("R", "1/2"), ("r", "1/3"), ("h", "1/4"))[:number]
    page = show(Table("Few", ("what", "value"), rows)._repr_html_(), "tables.js")
    assert page.get_by_role("button", name="CSV").count() == (number > 2)
    assert page.locator(".cx-table-tools").count() == (number > 2)
    page = show(Table("Few", ("what", "value"), (("R", sqrt(2)),) * number)._repr_html_(), "tables.js")
    assert page.get_by_role("button").all_inner_texts()[-1] == "Exact values"


def test_numbers_are_numbers_in_a_download(show):
    rows = "".join(f"<tr><td>{words}</td></tr>" for words in ("27,215,450", "−1", "1,2", "Ã<br>or C̃"))
    table = f"<table><thead><tr><th>n</th></tr></thead>{rows}</table>"
    page = show(f'<h2>Other</h2><div class="lg-scroll" aria-label="Speed of A~">{table}</div>', "tables.js")
    assert download(page, "CSV").splitlines() == ["n", "27215450", "-1", '"1,2"', "A~ or C~"]
    assert json.loads(download(page, "JSON"))["title"] == "Speed of A~"
    assert "27,215,450" in (tex := download(page, "LaTeX"))
    assert r"$\tilde{A}$ or $\tilde{C}$" in tex


def test_greek_letters_and_low_digits_have_names_in_latex(show):
    rows = "".join(f"<tr><td>{words}</td></tr>" for words in (r"\(τ_0\)", "u₁₂ = 90°", "⟨x, y⟩"))
    text = download(show(f"<table>{rows}</table>", "tables.js"), "LaTeX")
    assert r"${\tau}_0$" in text
    assert r"u$_1_2$ = 90$^\circ$" in text
    assert text.isascii()


# -- formulas ----------------------------------------------------------------------------------------------

MATHJAX = """<script>window.MathJax = { startup: { promise: Promise.resolve() } };
MathJax.typeset = (found) => found.forEach((x) => {
  x.innerHTML = x.innerHTML.replace(/\\\\\\((.*?)\\\\\\)/g, "<mjx-container>$1</mjx-container>");
});</script>"""
FORMULA = '<span class="math">\\(x\\)</span>'
FAR = '<div style="height: 9000px"></div>'


def unset(page):
    return page.locator(".lg-tex").count()


def test_formulas_far_away_are_set_later(show):
    page = show(f"{MATHJAX}<p>{FORMULA}</p>{FAR}<p id='low'>{FORMULA}</p>", "formulas.js")
    assert page.locator("mjx-container").count() == unset(page) == 1
    page.wait_for_function("!document.querySelector('.lg-tex')")
    assert page.locator(".math > mjx-container").count() == 2


def test_formulas_are_set_when_they_are_scrolled_to(show):
    far = f'{FAR}<p id="low"><span class="lg-tex">\\(y\\)</span></p>'
    page = show(MATHJAX + far, "formulas.js")
    page.wait_for_timeout(1500)
    assert unset(page) == 1
    page.evaluate("low.scrollIntoView()")
    page.wait_for_selector("#low mjx-container")


def test_formulas_are_left_until_their_fold_is_opened(show):
    inner = f'<span class="lg-tex">\\(d\\)</span><div class="tex2jax_process"><p>\\(y\\)</p>{FORMULA}</div>'
    page = show(f"{MATHJAX}<details><summary>How</summary>{inner}</details>", "formulas.js")
    page.wait_for_timeout(1500)
    assert page.locator("mjx-container").count() == 0
    page.get_by_text("How").click()
    page.wait_for_function("!document.querySelector('.lg-tex')")
    assert page.locator("mjx-container").count() == 3
    assert page.locator(".tex2jax_process, .math").count() == 3


def test_before_printing_all_formulas_that_are_open_are_set(show):
    page = show(
        f"{MATHJAX}<div hidden>{FORMULA}</div>{FAR}<details open><summary>a</summary>{FORMULA}</details>"
        f"<details><summary>{FORMULA}</summary><b>{FORMULA}</b></details>",
        "formulas.js",
    )
    assert unset(page) == 4
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert page.locator("details b .lg-tex").count() == unset(page) == 1


# -- pictures to turn ---------------------------------------------------------------------------------------

CAMERA = "(({eye}) => [eye.x, eye.y, eye.z])(document.querySelector('.cx-stage').layout.scene.camera)"
REACH = """(() => {
  const { data, layout } = document.querySelector(".cx-stage");
  const axes = ["x", "y", "z"];
  const middle = axes.map((x) => (layout.scene[`${x}axis`].range[0] + layout.scene[`${x}axis`].range[1]) / 2);
  const points = data.flatMap((trace) => trace.x.flat().map((_, i) => axes.map((x) => trace[x].flat()[i])));
  const far = (point) => Math.hypot(...point.map((x, i) => x - middle[i]));
  return layout.scene.aspectratio.x * Math.max(...points.filter(([x]) => x !== null).map(far));
})()"""


@pytest.fixture
def picture(show):
    library = Path(plotly.__file__).parent / "package_data" / "plotly.min.js"
    page = show(f'<script src="{library.as_uri()}"></script>{scene("B~3")._repr_html_()}', "space.js")
    page.wait_for_selector(".cx-stage .annotation-text", state="attached")
    return page


def test_names_stand_in_front_of_a_picture(picture):
    names = picture.locator(".cx-stage .annotation-text").all_text_contents()
    assert names == ["u₀", "u₁", "u₂", "u₃", "s₂(u₂)", "c"]


def test_a_picture_turns_past_its_pole(picture):
    heights = [picture.evaluate(CAMERA)[2]]
    for _ in range(6):
        for _ in range(4):
            picture.get_by_role("button", name="Turn upwards").click()
        picture.wait_for_timeout(300)
        heights.append(picture.evaluate(CAMERA)[2])
    assert min(heights) < -2.4  # near the pole, and then on
    assert abs(heights[-1] + heights[0]) < 1e-6  # half a turn
    stage = picture.locator(".cx-stage").bounding_box()
    x, y = stage["x"] + stage["width"] / 2, stage["y"] + stage["height"] / 2
    before = picture.evaluate(CAMERA)
    picture.mouse.move(x, y)
    picture.mouse.down()
    picture.mouse.move(x + 80, y, steps=4)
    picture.mouse.up()
    picture.wait_for_function(f"Math.abs({CAMERA}[0] - {before[0]}) > 0.1")
    assert abs(sum(t * t for t in picture.evaluate(CAMERA)) - sum(t * t for t in before)) < 1e-6


def test_all_that_is_shown_fits_into_the_picture(picture):
    """In units of the range of the axes, what is drawn reaches as far, whatever it is."""
    first = picture.evaluate(REACH)
    for control in ("Next", "All"):
        picture.get_by_role("button", name=control).click()
        picture.wait_for_timeout(900)
        assert picture.evaluate(REACH) <= first + 1e-6


# -- the graph ---------------------------------------------------------------------------------------------


@pytest.fixture
def graph(show, views, ledger):
    cards = {SITE.claim(x.id): claim_card(x) for x in ledger}
    return show(views.view("graph", [], SITE), "graph.js", "cards.js", cards=cards)


def test_the_graph_fades_what_is_not_asked_for(graph):
    verdicts = Counter(graph.locator(".lg-node").evaluate_all("all => all.map(x => x.dataset.verdict)"))
    for verdict, number in verdicts.items():
        graph.select_option("[name=verdict]", verdict)
        assert graph.locator(".lg-node:not(.lg-faded)").count() == number
        assert graph.locator("output").inner_text().startswith(f"{number} of ")
    graph.select_option("[name=strength]", "every d")
    clear = graph.locator(".lg-node:not(.lg-faded)")
    assert set(clear.evaluate_all("all => all.map(x => x.dataset.strength)")) <= {"every d"}
    graph.get_by_role("button", name="Show all").click()
    graph.wait_for_function("!document.querySelector('.lg-faded')")


def test_an_item_is_found_by_its_name(graph):
    graph.fill("[name=find]", "Lemma 1")
    assert graph.locator(".lg-node:not(.lg-faded)").evaluate_all("all => all.map(x => x.dataset.node)") == [
        "lem-1"
    ]
    graph.keyboard.press("Enter")
    assert graph.evaluate("document.activeElement.dataset.node") == "lem-1"
    graph.fill("[name=find]", "no such thing")
    assert graph.locator("output").inner_text().startswith("0 of ")


def test_the_graph_is_zoomed_by_buttons_keys_and_wheel(graph):
    def width():
        return graph.locator("svg.lg-graph").evaluate("x => x.getBoundingClientRect().width")

    first = width()
    graph.get_by_role("button", name="Zoom in").click()
    assert width() > first
    graph.locator(".lg-zooming").focus()
    graph.keyboard.press("-")
    assert width() == pytest.approx(first)
    graph.keyboard.press("0")
    box = graph.locator(".lg-zooming").bounding_box()
    shown = graph.locator("svg.lg-graph").bounding_box()
    assert shown["height"] <= box["height"] + 1
    assert shown["width"] <= box["width"] + 1
    graph.mouse.move(box["x"] + 200, box["y"] + 200)
    graph.keyboard.down("Control")
    graph.mouse.wheel(0, -100)
    graph.keyboard.up("Control")
    graph.wait_for_function(
        f"document.querySelector('svg.lg-graph').getBoundingClientRect().width > {shown['width']}"
    )


def test_a_drag_moves_the_graph_and_follows_no_link(graph):
    for _ in range(3):
        graph.get_by_role("button", name="Zoom in").click()
    graph.evaluate("document.querySelector('.lg-zooming').scrollTo(200, 200)")
    node = graph.locator(".lg-node").nth(30)
    graph.evaluate("x => x.scrollIntoView({block: 'center', inline: 'center'})", node.element_handle())
    before = graph.evaluate("document.querySelector('.lg-zooming').scrollTop")
    place = node.bounding_box()
    graph.mouse.move(place["x"] + 10, place["y"] + 10)
    graph.mouse.down()
    graph.mouse.move(place["x"] - 30, place["y"] - 40, steps=4)
    graph.mouse.up()
    assert graph.evaluate("document.querySelector('.lg-zooming').scrollTop") == pytest.approx(
        before + 50, abs=2
    )
    assert graph.url.endswith("page.html")


# -- cards -------------------------------------------------------------------------------------------------


def test_a_node_shows_its_card_to_pointer_and_keyboard(graph, ledger):
    node = graph.locator('.lg-node[data-node="lem-10"]')
    node.hover()
    card = graph.locator("#cx-card")
    card.wait_for(state="visible")
    assert "Lemma 10" in card.inner_text()
    assert "The gravest of" in card.inner_text()
    assert node.get_attribute("aria-describedby") == "cx-card"
    assert node.locator("title").count() == 0
    graph.keyboard.press("Escape")
    assert not card.is_visible()
    assert node.get_attribute("aria-describedby") is None
    graph.fill("[name=find]", "Lemma 1")
    graph.keyboard.press("Enter")
    card.wait_for(state="visible")
    assert "Lemma 1" in card.inner_text()


def test_a_card_goes_along_when_the_keyboard_scrolls(show):
    body = '<p style="height:3000px"><a href="y.html">here</a></p><a href="x.html">there</a>'
    page = show(body, "cards.js", cards={"x.html": "<p>words</p>"})
    page.keyboard.press("Tab")
    page.keyboard.press("Tab")
    page.wait_for_timeout(300)
    card, link = page.locator("#cx-card"), page.get_by_text("there").bounding_box()
    assert abs(card.bounding_box()["y"] - link["y"]) < 100
    page.evaluate("scrollTo(0, 0)")
    page.wait_for_timeout(300)
    assert not card.is_visible()


def test_a_card_stays_within_the_window(show):
    long = "words " * 80
    body = '<p style="height:700px"></p><p style="text-align:right"><a href="x.html">there</a></p>'
    page = show(body, "cards.js", cards={"x.html": f"<p>{long}</p>"})
    page.get_by_role("link").hover()
    card = page.locator("#cx-card")
    card.wait_for(state="visible")
    box = card.bounding_box()
    assert box["x"] >= 0
    assert box["y"] >= 0
    assert box["x"] + box["width"] <= 1200
    assert box["y"] + box["height"] <= 800
    card.hover()  # a pointer may rest on the card
    page.wait_for_timeout(400)
    assert card.is_visible()
    page.mouse.move(5, 5)
    card.wait_for(state="hidden")


def test_a_link_without_a_card_shows_none(show):
    page = show('<a href="y.html" title="Why">there</a>', "cards.js", cards={"x.html": "<p>x</p>"})
    page.get_by_role("link").hover()
    page.wait_for_timeout(500)
    assert not page.locator("#cx-card").is_visible()
    assert page.get_by_role("link").get_attribute("title") == "Why"


# -- the ledger --------------------------------------------------------------------------------------------


@pytest.fixture
def listing(show, views):
    return lambda place="": show(
        views.view("listing", [], SITE), "ledger.js", "cards.js", place=place, cards={}
    )


def shown(page) -> list[str]:
    return page.locator(".lg-claim:not([hidden])").evaluate_all("all => all.map(x => x.id.slice(6))")


def test_a_view_of_the_ledger_can_be_linked(listing, ledger):
    page = listing("#verdict=fails&q=the")
    expected = {x.id for x in ledger if x.verdict.value == "fails"}
    assert set(shown(page)) <= expected
    page.fill("[name=words]", "")
    page.wait_for_function("location.hash === '#verdict=fails'")
    assert set(shown(page)) == expected
    assert page.locator("output").inner_text() == f"{len(expected)} of {len(ledger)} claims"
    page.get_by_role("button", name="Show all").click()
    page.wait_for_function("location.hash === ''")
    assert len(shown(page)) == len(ledger)


def test_the_ledger_is_sorted_and_put_back(listing, ledger):
    page = listing()
    printed = shown(page)
    page.select_option("[name=sort]", "verdict")
    page.wait_for_function("location.hash === '#sort=verdict'")
    ranks = [GRAVITY.index(ledger[id].verdict) for id in shown(page)]
    assert ranks == sorted(ranks)
    page.select_option("[name=sort]", "strength")
    page.wait_for_function("location.hash === '#sort=strength'")
    ranks = [FIRMNESS.index(ledger[id].finding.strength.extent) for id in shown(page)]
    assert ranks == sorted(ranks)
    page.select_option("[name=sort]", "")
    page.wait_for_function("location.hash === ''")
    assert shown(page) == printed


def test_the_ledger_is_filtered_by_section_and_family(listing):
    page = listing("#section=Section+6&family=E6")
    found = shown(page)
    assert found
    assert all("E6" in id or not re.match(r"sec6\.[A-G]", id) for id in found)
    assert any(id.startswith("sec6.E6.") for id in found)


@pytest.mark.parametrize("typed", ["B~3", "b\u03033", "B\u0303₃", r"\tilde B_3", r"\tilde{B}_{3}"])
def test_a_type_is_found_however_it_is_written(listing, ledger, typed):
    page = listing()
    page.fill("[name=words]", typed)
    page.wait_for_function("location.hash")
    found = shown(page)
    assert 0 < len(found) < len(ledger)
    assert "tab-6.B.3" in found
    page.fill("[name=words]", "B~3")
    page.wait_for_timeout(400)
    assert shown(page) == found


def test_a_link_to_a_claim_opens_its_section_and_keeps_the_address(listing):
    page = listing("#claim-lem-7")
    assert page.locator("#claim-lem-7").is_visible()
    page.wait_for_timeout(300)
    assert page.url.endswith("#claim-lem-7")


def test_a_claim_in_the_same_page_is_told_by_its_row(listing):
    page = listing("#claim-lem-7")
    row = page.locator("#claim-lem-7")
    row.locator("summary", has_text="Rests on").click()
    link = row.locator("a[href^='#claim-']:not(.lg-id)").first
    target = link.get_attribute("href").removeprefix("#claim-")
    link.hover()
    page.locator("#cx-card").wait_for(state="visible")
    assert target in page.locator("#cx-card").inner_text()
