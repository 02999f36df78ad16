"""The book as one PDF: pages put together, links turned inward, numbers in the contents, faults found."""

from pathlib import Path

import make_pdf
import pypdf
import pytest
from browse_chromium import ABSENT, find_chromium
from bs4 import BeautifulSoup
from pdf_pages import Book, Chapter, chapters_of, document
from pypdf.generic import ArrayObject, DictionaryObject, NameObject, TextStringObject

ROOT = Path(make_pdf.__file__).parent.parent
TOC = """root: index
parts:
- caption: One & only
  chapters:
  - file: a/one
  - file: a/two
    sections:
    - file: a/three
"""
PAGE = """<html><head><link rel="stylesheet" href="{up}_static/style.css?v=1"></head><body>
<nav id="same">menu</nav><article class="bd-article"><section id="top">
<h1>{title}<a class="headerlink" href="#top">#</a></h1>{body}</section></article></body></html>"""
ONE = """<section id="same"><h2>Same</h2>
<a id="in" href="two.html#same">there</a> <a href="#same">here</a> <a href="two.html">two</a>
<a href="two.html#gone">gone</a> <a class="out" href="../checks/x.html#f">check</a> <a href="#">nowhere</a>
<a href="https://example.org/">elsewhere</a>
<details><summary>Why</summary>folded</details> <span class="lg-tex">\\(x\\)</span> <button>press</button>
<svg><defs><clipPath id="clip"></clipPath></defs><g clip-path="url(#clip)"><use xlink:href="#clip"/></g></svg>
<noscript><b>still</b></noscript><div class="cell"><details class="hide">output</details></div>
</section>"""
WIDE = f"<table><tr>{''.join(f'<td>number{i}</td>' for i in range(40))}</tr></table>"


@pytest.fixture
def site(tmp_path: Path) -> Path:
    folder = tmp_path / "html"
    (folder / "a").mkdir(parents=True)
    (folder / "_static").mkdir()
    (folder / "_static" / "style.css").write_text("")
    (folder / "_static" / "print.css").write_text((ROOT / "book/_static/print.css").read_text())
    (folder / "_static" / "tex-svg-full.js").write_text("MathJax.startup = {promise: Promise.resolve()}")
    bodies = {
        "index": "",
        "a/one": ONE,
        "a/two": f'<section id="same"><h2>Same</h2>{WIDE}</section>',
        "a/three": "<p>3</p>",
    }
    for name, body in bodies.items():
        text = PAGE.format(up="../" * name.count("/"), title=f"Page {name}", body=body)
        (folder / f"{name}.html").write_text(text)
    (tmp_path / "_toc.yml").write_text(TOC)
    return folder


def put_together(site: Path) -> BeautifulSoup:
    text = document(Book(site, chapters_of(site.parent / "_toc.yml")), "<header>front</header>", "{}")
    return BeautifulSoup(text, "html.parser")


def test_the_chapters_of_a_table_of_contents(site: Path) -> None:
    found = chapters_of(site.parent / "_toc.yml")
    assert found == [Chapter("index"), Chapter("a/one", "One & only"), Chapter("a/two"), Chapter("a/three")]


def test_no_id_stands_twice(site: Path) -> None:
    ids = [tag["id"] for tag in put_together(site).find_all(id=True)]
    assert len(ids) == len(set(ids))
    assert {"p-a-one--same", "p-a-two--same", "p-a-one", "p-a-one--part"} <= set(ids)


def test_links_lead_within_or_to_other_hosts_or_are_no_links(site: Path) -> None:
    soup = put_together(site)
    links = {tag.get_text(): tag.get("href") for tag in soup.select("#p-a-one a")}
    assert links == {
        "there": "#p-a-two--same",
        "here": "#p-a-one--same",
        "two": "#p-a-two",
        "gone": "#p-a-two",
        "check": None,
        "nowhere": None,
        "elsewhere": "https://example.org/",
    }
    ids = {tag["id"] for tag in soup.find_all(id=True)}
    inner = [str(tag["href"]) for tag in soup.select("a[href]") if str(tag["href"]).startswith("#")]
    assert all(address[1:] in ids for address in inner)


def test_what_is_for_hands_is_left_out_and_what_is_folded_is_open(site: Path) -> None:
    chapter = put_together(site).select_one("#p-a-one")
    assert chapter is not None
    assert not chapter.select("button, .headerlink, noscript, .cell")
    assert chapter.select_one("b") is not None
    assert [tag.has_attr("open") for tag in chapter.select("details")] == [True]
    assert chapter.select_one("span.math") is not None


def test_parts_of_drawings_are_found_again(site: Path) -> None:
    chapter = put_together(site).select_one("#p-a-one")
    assert chapter is not None
    assert 'clip-path="url(#p-a-one--clip)"' in str(chapter)
    assert 'xlink:href="#p-a-one--clip"' in str(chapter)


def test_the_contents_name_every_part_chapter_and_section(site: Path) -> None:
    lines = put_together(site).select(".cx-contents p")
    found = [(tag["class"][0], tag.select_one(".cx-number")["data-place"]) for tag in lines]
    assert found == [
        ("cx-chapter", "p-index"),
        ("cx-part", "p-a-one--part"),
        ("cx-chapter", "p-a-one"),
        ("cx-section", "p-a-one--same"),
        ("cx-chapter", "p-a-two"),
        ("cx-section", "p-a-two--same"),
        ("cx-chapter", "p-a-three"),
    ]


def test_the_title_page_says_whose_paper_it_is() -> None:
    front = make_pdf.front_page(ROOT)
    assert "Wintraecken" in front
    assert "https://doi.org/10.1007" in front


@pytest.mark.skipif(find_chromium() is None, reason=ABSENT)
def test_a_book_is_printed(site: Path, tmp_path: Path) -> None:
    target = tmp_path / "book.pdf"
    assert make_pdf.make(site, tmp_path / "_toc.yml", ROOT, target) == []
    reader = pypdf.PdfReader(target)
    assert len(reader.pages) == 6  # title, contents, four chapters
    numbers = [int(word) for word in reader.pages[1].extract_text().split() if word.isdigit()]
    assert numbers[:8] == [2, 3, 4, 4, 4, 5, 5, 6]  # the page's own number first
    titles = [item.title for item in reader.outline if not isinstance(item, list)]
    assert titles == ["Page index", "One & only"]
    width = float(reader.pages[0].mediabox.width)
    assert abs(width - 595) < 2  # A4
    assert "number39" in reader.pages[4].extract_text()


def test_a_faulty_pdf_is_found_out(tmp_path: Path) -> None:
    writer = pypdf.PdfWriter()
    page = writer.add_blank_page(100, 100)
    name, words = NameObject, TextStringObject
    leads = [
        {name("/A"): DictionaryObject({name("/URI"): words("file:///x.html")})},
        {name("/Dest"): words("none")},
        {},
    ]
    links = [DictionaryObject({name("/Subtype"): name("/Link")} | lead) for lead in leads]
    page[name("/Annots")] = ArrayObject(links)
    writer.write(tmp_path / "bad.pdf")
    assert make_pdf.wrong(tmp_path / "bad.pdf") == [
        "no bookmarks",
        "page 1: link to file:///x.html",
        "page 1: link to the missing place none",
        "page 1: link to nothing",
    ]
