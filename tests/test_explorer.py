"""The explorer and the page on choosing: the numbers, the order of the families, words, what is refused."""

import csv
import gzip
import io
import json
import re
from decimal import Decimal, localcontext
from functools import cache
from importlib.util import find_spec
from itertools import combinations, product
from pathlib import Path

import networkx
import pytest
from bs4 import BeautifulSoup
from run_notebooks import ROOT

import coxeter
from coxeter.claims.core import DEFINITIONS
from coxeter.delaunay import delaunay_verdict, protection
from coxeter.diagrams import classify
from coxeter.errors import InvalidInput
from coxeter.exact import Surd
from coxeter.families import closed_form
from coxeter.lattices import vertex_lattice
from coxeter.names import FAMILIES, MINIMAL_DIMENSION, Type, triangulations_up_to
from coxeter.pages.choosing import CHOICES, best, next_best, offers
from coxeter.pages.explorer_data import explorer_data
from coxeter.pages.misprints import misprints
from coxeter.pages.naming import Site
from coxeter.pages.order_words import PAIRS, crossings, in_dimension, sentence
from coxeter.pages.qualities import (
    MAX_DIM,
    MEASURES,
    as_csv,
    qualities,
    ranking,
    rate,
    readable,
    rounded,
    short,
)
from coxeter.pages.views import Views
from coxeter.paper import printed
from coxeter.proofs import prove
from coxeter.proofs.best import ranking as ranked_by_the_core
from coxeter.proofs.order import leads, order
from coxeter.proofs.rates import constant
from coxeter.quality import find_measure

SITE = Site("../")
CELL = re.compile(r"```\{code-cell\} ipython3\n(?::tags:.*\n)?(.*?)```", re.DOTALL)


@pytest.fixture(scope="module")
def wrong(ledger):
    return misprints(ledger, MAX_DIM)


@pytest.fixture(scope="module")
def text(ledger):
    return Views(ledger).view("explorer", (), SITE)


@pytest.fixture(scope="module")
def figure(text):
    return BeautifulSoup(text, "html.parser")


# -- numbers -------------------------------------------------------------------------------------------------


def test_there_is_every_type_up_to_the_largest_dimension():
    kinds = {kind for _, kind in qualities()}
    assert kinds == set(triangulations_up_to(MAX_DIM))
    assert len(qualities()) == len(MEASURES) * len(kinds)


@pytest.mark.parametrize("measure", MEASURES)
def test_the_values_are_those_of_the_closed_forms(measure):
    for (name, kind), x in qualities().items():
        if name == measure:
            assert x.normalized == closed_form(kind.family, f"normalized_{measure}").at(kind.rank)
            assert x.raw == closed_form(kind.family, measure).at(kind.rank)


def test_the_limits_are_those_that_are_proved():
    for letter, measure in product(MINIMAL_DIMENSION, MEASURES):
        found = rate(letter, measure)
        assert (found.coefficient, found.degree) == (constant(letter, measure), Surd("-1/2"))


@pytest.mark.parametrize("d", range(2, 10))
def test_the_order_of_all_types_is_that_of_the_core(d):
    for measure in MEASURES:
        flat = [kind.affine for equal in ranking(measure, d) for kind in equal]
        assert flat == ranked_by_the_core(measure, d)


def test_readable_numbers_are_the_same_numbers():
    for (measure, kind), x in list(qualities().items())[::7]:
        text = readable(str(x.normalized))
        back = re.sub(r"√(\d+)", r"sqrt(\1)", text).replace("^", "**").replace("·", "*")
        back = re.sub(r"(\d)sqrt", r"\1*sqrt", back)
        assert coxeter.surd(back) == x.normalized, (measure, kind)


def test_decimals_are_rounded_once():
    assert rounded(Surd("1/3")) == "0.333333"
    assert rounded(Surd("1/3") / 10**9) == "3.333333e-10"
    assert rounded(Surd(0)) == "0.000000"


def test_the_file_can_be_read_back():
    rows = list(csv.reader(io.StringIO(as_csv())))
    assert len(rows) == 1 + len(qualities())
    assert ["B~3", "3", "thickness", "sqrt(3)/4", "0.433013", "sqrt(2)/4", "0.353553"] in rows


# -- the order of the families -------------------------------------------------------------------------------


@pytest.mark.parametrize("measure", MEASURES)
def test_what_is_proved_of_the_order_is_what_the_values_say(measure):
    for x, y in combinations(MINIMAL_DIMENSION, 2):
        first = max(MINIMAL_DIMENSION[x], MINIMAL_DIMENSION[y])
        said = {
            d: lead.ahead for lead in leads(measure, x, y) for d in range(lead.first, (lead.last or 64) + 1)
        }
        assert sorted(said) == list(range(first, MAX_DIM + 1))
        for d, ahead in said.items():
            a, b = (qualities()[measure, Type(letter, d)].normalized for letter in (x, y))
            assert ahead == ("" if a == b else x if a > b else y)


@cache
def radius_ratio_by_decimals(letter, d):
    """r/R with sixty digits, from squared heights and the squared circumradius: no surds."""
    s = coxeter.triangulation((letter, d)).simplex
    with localcontext() as context:
        context.prec = 60
        numbers = [Decimal(x.numerator) / Decimal(x.denominator) for x in s.squared_heights]
        square = s.squared_circumradius
        r = 1 / sum(1 / x.sqrt() for x in numbers)
        return r / (Decimal(square.numerator) / Decimal(square.denominator)).sqrt()


@pytest.mark.parametrize(("pair", "at"), [("CD", 6), ("BD", 10)])
def test_the_crossings_by_another_arithmetic(pair, at):
    for d in range(4, 25):
        gap = radius_ratio_by_decimals(pair[0], d) - radius_ratio_by_decimals("D", d)
        assert abs(gap) > Decimal("1e-9")
        assert (gap > 0) == (d >= at)
    assert crossings("radius_ratio", pair) == (at,)


def test_no_other_curves_cross():
    found = {(m, pair) for m, pair in product(MEASURES, PAIRS) if crossings(m, pair)}
    assert found == {("radius_ratio", "CD"), ("radius_ratio", "BD")}


@pytest.mark.parametrize("measure", MEASURES)
def test_the_proof_of_the_order_can_be_replayed(measure):
    assert order(measure).replay(12) > 100


def test_families_and_measures_that_there_are_not():
    with pytest.raises(InvalidInput, match=r"'E' is no family; there are A, B, C, D"):
        leads("thickness", "A", "E")
    with pytest.raises(InvalidInput, match=r"'girth' is not compared; there are aspect_ratio"):
        leads("girth", "A", "B")
    with pytest.raises(InvalidInput, match=r"65 is no dimension of the explorer: give one from 2 to 64"):
        ranking("thickness", 65)
    with pytest.raises(InvalidInput, match=r"'girth' is no quality measure"):
        ranking("girth", 5)


def test_the_order_in_words():
    assert sentence("radius_ratio", "BD") == (
        "B~ and D~ cross between d = 9 and d = 10: D~ is ahead for d = 4 to 9, B~ from d = 10 on."
    )
    assert sentence("fatness", "BC") == "B~ is ahead of C~ in every dimension."
    assert in_dimension("radius_ratio", 2) == "A~2 > C~2 > G~2"


# -- printed values ------------------------------------------------------------------------------------------


def test_each_wrong_value_is_not_the_true_one(wrong):
    for x in wrong:
        kind = Type(x.family[0], x.d)
        quality = qualities()[x.measure, kind]
        assert x.value != (quality.raw if x.raw else quality.normalized)


def test_the_wrong_cells_of_the_tables_found_anew(wrong, ledger):
    """From the cells alone: those that do not round like the exact value, without what our copy has moved."""
    found = set()
    for line in printed().rows:
        for d, cell in zip(range(2, 9), line.cells, strict=False):
            moved = line.letter in "EF"  # our copy has lost dashes of these rows
            if (
                line.letter
                and not moved
                and re.fullmatch(r"0\.\d{3}", cell)
                and d in _dimensions(line.letter)
            ):
                quantity = find_measure(line.quantity.removeprefix("normalized_"))
                true = quantity.normalized(coxeter.triangulation((line.letter, d)).simplex)
                if true.decimal(3) != cell:
                    found.add(f"tab-{line.table}.{line.letter}.{d}")
    cells = {x.claim for x in wrong if re.match(r"tab-[3-6]\.[ABCDG]", x.claim)}
    assert cells == found
    assert all(not ledger[claim].verdict.accepts for claim in cells)


def _dimensions(letter):
    return range(MINIMAL_DIMENSION[letter], 9) if letter in MINIMAL_DIMENSION else (2,)


def test_the_printed_thickness_of_a_is_wrong_in_every_odd_dimension(wrong):
    ds = [x.d for x in wrong if x.claim == "sec6.A.item-6.thickness-odd"]
    assert ds == list(range(3, MAX_DIM + 1, 2))


def test_fewer_dimensions_have_fewer_wrong_values(ledger, wrong):
    assert set(misprints(ledger, 3)) == {x for x in wrong if x.d <= 3}


# -- the figure ----------------------------------------------------------------------------------------------


def test_the_data_say_what_the_library_says(wrong):
    data = explorer_data(wrong, SITE)
    for measure in MEASURES:
        for scale, raw in (("normalised", False), ("raw", True)):
            values = data["measures"][measure][scale]["values"]
            assert set(values) == set(FAMILIES)
            for family, rows in values.items():
                first = MINIMAL_DIMENSION.get(family) or int(family[1:])
                for d, entry in enumerate(rows, first):
                    kind = Type(family[0], d)
                    x = getattr(qualities()[measure, kind], "raw" if raw else "normalized")
                    assert entry[0] == short(kind, measure, raw)
                    assert entry[1] == rounded(x)
                    assert entry[-1] == readable(str(x)) if len(entry) == 4 else entry[0] == readable(str(x))
                    assert len(entry[0]) < 80


def test_times_the_root_of_d_is_exact_before_it_is_rounded():
    data = explorer_data((), SITE)["measures"]["thickness"]["normalised"]
    assert data["values"]["A"][2][2] == (coxeter.sqrt(4) * coxeter.sqrt("4/6")).decimal(6)
    assert data["limits"]["B"] == ["1", "1.000000", "1/2"]
    assert explorer_data((), SITE)["measures"]["fatness"]["raw"]["limits"] == {}


def test_the_figure_says_everything_without_its_script(figure, wrong):
    assert len(figure.select(".cx-drawings svg title")) == len(MEASURES)
    assert all(
        "hidden" in figure.select_one(part).attrs for part in (".cx-controls", ".cx-reader", ".cx-plot")
    )
    assert len(figure.select(".cx-orders li[data-families]")) == len(MEASURES) * (len(PAIRS) + 5)
    told = figure.select(".cx-wrong li")
    assert {li.a["href"] for li in told} == {SITE.claim(x.claim) for x in wrong}
    tables = figure.select("details.cx-numbers table")
    assert len(tables) == 2 * len(MEASURES)
    assert all(len(one.select("tbody tr")) == MAX_DIM - 1 for one in tables)
    assert "0.433013" in tables[MEASURES.index("thickness")].get_text()


def test_every_control_has_a_name(figure):
    for control in figure.select("input, select"):
        assert control.find_parent("label").get_text(strip=True)
    assert [x.get_text() for x in figure.select("legend")] == ["Families", "Show"]


def test_the_data_are_readable_and_light(figure, text):
    data = figure.select_one("script.cx-data").string
    assert json.loads(data)["max"] == MAX_DIM
    assert "</" not in data
    assert len(gzip.compress(text.encode())) < 150_000


def test_the_views_are_known_by_name(ledger):
    views = Views(ledger)
    assert all(views.view(f"choice {name}", (), SITE) for name in CHOICES)
    assert views.files["qualities.csv"] == as_csv()
    with pytest.raises(InvalidInput, match=r"no view 'choice wisely'; there are .*choice families"):
        views.view("choice wisely", (), SITE)


def test_the_views_that_the_page_links_exist():
    text = (ROOT / "book" / "explorer.md").read_text(encoding="utf-8")
    links = re.findall(r'href="#([^"]+)"', text)
    assert len(links) >= 3
    for link in links:
        asked = dict(part.split("=") for part in link.split("&"))
        assert asked["measure"] in MEASURES
        assert set(asked["families"].split(",")) <= {*MINIMAL_DIMENSION, "X"}
        assert 3 <= int(asked["max"]) <= MAX_DIM


# -- choosing ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "kind", [Type(x, d) for x in "ABCD" for d in (11, 16)] + [Type("D", 4), Type("F", 4)]
)
def test_what_a_type_offers_is_what_the_library_finds(kind):
    t = coxeter.triangulation(kind)
    found = offers(kind)
    assert found["delaunay"] == delaunay_verdict(t).delaunay
    assert found["protected"] == (protection(t).relative > 0)
    assert found["lattice"] == vertex_lattice(t).is_lattice
    assert found["plain"] == (len(t.simplex.vertices[0]) == kind.rank)


@pytest.mark.parametrize("measure", MEASURES)
def test_the_next_best_family_stays_so(measure):
    letters, start = next_best(measure)
    for d in range(start, MAX_DIM + 1):
        assert "".join(sorted(kind.family for kind in ranking(measure, d)[1])) == letters
    assert start == 2 or {kind.family for kind in ranking(measure, start - 1)[1]} != set(letters)


def test_the_best_that_offers_what_is_needed():
    assert [kind.affine for kind in best("fatness", 3, "plain")] == ["B~3"]
    assert [kind.affine for kind in best("fatness", 3, "plain", "delaunay")] == ["C~3"]
    assert best("fatness", 5, "plain", "protected") == []
    assert all(best(m, d)[0].letter == "A" for m in MEASURES for d in (2, 7, 64))


def test_the_tables_on_choosing(ledger):
    families = BeautifulSoup(CHOICES["families"](ledger, SITE), "html.parser")
    rows = {tr.th.get_text(): [td.get_text() for td in tr.select("td")] for tr in families.select("tbody tr")}
    assert rows["D\N{COMBINING TILDE}d"][:4] == ["no", "no", "only D\N{COMBINING TILDE}4", "yes"]
    assert rows["A\N{COMBINING TILDE}d"][:4] == ["yes", "yes", "yes", "no"]
    last = BeautifulSoup(CHOICES["dimensions"](ledger, SITE), "html.parser").select("tbody tr")[-1]
    assert "then C\N{COMBINING TILDE}d from d = 6 on" in last.get_text()
    cost = BeautifulSoup(CHOICES["cost"](ledger, SITE), "html.parser").get_text()
    assert (coxeter.sqrt(3) / 3).decimal(3) in cost


def test_the_form_has_the_exact_order(ledger):
    form = BeautifulSoup(CHOICES["form"](ledger, SITE), "html.parser")
    data = json.loads(form.select_one("script.cx-data").string)
    assert set(data["offers"]) == set(offers(Type("A", 3)))
    types, exact, decimal = data["orders"]["thickness"]["4"][1]
    assert (types, exact, decimal) == (
        ["B̃<sub>4</sub>", "C̃<sub>4</sub>", "D̃<sub>4</sub>"],
        "√5/5",
        "0.447214",
    )
    assert data["types"]["4"]["D̃<sub>4</sub>"] == ["lattice", "plain"]


def test_points_are_located_as_the_page_says():
    cells = CELL.findall((ROOT / "book" / "which.md").read_text(encoding="utf-8"))
    names: dict = {}
    for cell in cells[:-1]:
        exec(cell, names)
    *before, last = cells[-1].strip().split("\n")
    exec("\n".join(before), names)
    assert eval(last, names) == (True, True)
    assert all(all(names["trials"](f"A~{d}", names["fold_A"], 20)) for d in (2, 3, 4))
    assert not all(names["trials"]("D~4", names["fold_C"], 20))


def test_the_vertices_of_c_are_the_points_with_halves():
    t = coxeter.triangulation("C~3")
    halves = [Surd(n).as_fraction() / 2 for n in range(-2, 3)]
    assert all(t.is_vertex(x) for x in product(halves, repeat=3))
    assert not t.is_vertex(("1/4", 0, 0))


# -- from the book to code -----------------------------------------------------------------------------------


def test_the_examples_in_the_table_are_true():
    text = (ROOT / "book" / "to-code.md").read_text(encoding="utf-8")
    examples = re.findall(r"^\| [^|]+ \| [^|]+ \| `([^`|]+)` is `([^`|]+)` \|$", text, re.MULTILINE)
    assert len(examples) >= 14
    t = coxeter.triangulation("B~3")
    names = {
        "coxeter": coxeter, "t": t, "s": t.simplex, "classify": classify, "networkx": networkx,
        "prove": prove, "ranking": ranked_by_the_core, "constant": constant, "closed_form": closed_form,
    }  # fmt: skip
    for call, said in examples:
        found = eval(call, names)
        assert repr(found) == said or str(found) == said, call


def test_all_definitions_have_curves():
    assert set(MEASURES) == set(DEFINITIONS)


# -- in a browser --------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def page(browser, text, ledger, tmp_path_factory):
    """The figure and the form, with nothing of the site around them."""
    folder = tmp_path_factory.mktemp("explorer")
    static = ROOT / "book" / "_static"
    plotly = Path(find_spec("plotly").origin).parent / "package_data" / "plotly.min.js"
    scripts = "".join(f'<script defer src="{x.as_uri()}"></script>' for x in
                      (plotly, static / "explorer.js", static / "choosing.js"))  # fmt: skip
    form = CHOICES["form"](ledger, SITE)
    style = f'<link rel="stylesheet" href="{(static / "explorer.css").as_uri()}">'
    (folder / "page.html").write_text(f'<meta charset="utf-8">{style}{scripts}<body>{text}{form}', "utf-8")
    opened = browser.new_page(viewport={"width": 375, "height": 812})
    opened.errors = []
    opened.on("pageerror", lambda error: opened.errors.append(str(error)))
    opened.goto((folder / "page.html").as_uri() + "#measure=radius_ratio&families=B,C,D&max=12")
    yield opened
    assert opened.errors == []


def summary(page, words):
    page.wait_for_function(
        "words => document.querySelector('.cx-summary').textContent.includes(words)", arg=words
    )
    return page.inner_text(".cx-summary")


def test_the_address_chooses_the_view(page):
    told = summary(page, "d = 2 to 12")
    assert "Normalised radius ratio" in told
    for d in (6, 10):
        assert f"cross between d = {d - 1} and d = {d}" in told
    greatest = "C for d = 2 to 3; D for d = 4 to 5; C for d = 6 to 12"
    assert greatest in told.replace("\N{COMBINING TILDE}", "")
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_controls_and_keys_change_the_view_and_the_address(page):
    page.select_option("select[name=measure]", "thickness")
    page.focus("[name=max]")
    page.keyboard.press("ArrowLeft")
    assert "Wrong printed values: 2" in summary(page, "d = 2 to 11")
    assert page.evaluate("location.hash").startswith("#measure=thickness&families=B,C,D&max=11")
    page.focus("[name=d]")
    page.keyboard.press("Home")
    page.keyboard.press("ArrowRight")
    assert "√3/4" in page.inner_text(".cx-values")
    link = page.locator(".cx-values a", has_text="0.500")
    assert link.get_attribute("href").endswith("book/ledger.html#claim-tab-6.B.3")
    assert (
        page.get_attribute("[name=d]", "aria-valuetext").replace("\N{COMBINING TILDE}", "") == "d = 3: C > B"
    )


def test_what_is_asked_for_in_vain(page):
    page.select_option("select[name=measure]", "fatness")
    page.check("[name=raw]")
    assert "no limit curve" in summary(page, "not normalised")
    assert page.is_disabled("[name=scaled]")
    page.evaluate("location.hash = '#measure=girth&families=Z&max=999&d=x'")
    assert "d = 2 to 64" in summary(page, "Normalised radius ratio")


def test_the_form_answers(page):
    def answer(words):
        page.wait_for_function(
            "words => document.querySelector('.cx-answer').innerText.includes(words)", arg=words
        )
        return page.inner_text(".cx-answer").replace("\N{COMBINING TILDE}", "")

    assert answer("3√14/14").startswith("A6")
    page.check("[name=need][value=plain]")
    assert answer("Without these needs").startswith("C6")
    page.check("[name=need][value=protected]")
    assert "dimension 6 offers all of this: protected and d coordinates" in answer("None")
    page.fill(".cx-chooser [name=d]", "65")
    assert answer("Give") == "Give a dimension from 2 to 64."
