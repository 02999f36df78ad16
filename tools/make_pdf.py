"""Print the rendered book into one PDF: title page, contents with page numbers, chapters, bookmarks."""

import argparse
import html
import json
import sys
import time
from pathlib import Path
from typing import Any

import pypdf
import yaml
from browse_chromium import ABSENT, find_chromium, one_chromium
from pdf_pages import Book, chapters_of, document

ROOT = Path(__file__).resolve().parent.parent
FIT = Path(__file__).with_name("pdf_fit.js")
WIDTH = 658  # CSS pixels of the 174 mm between the margins of print.css
MATH = {
    "options": {"processHtmlClass": "tex2jax_process|mathjax_process|math|output_area", "enableMenu": False}
}
MATH |= {"svg": {"fontCache": "global"}}
MINUTES = 10
LEVELS = ["part", "chapter", "section"]


def front_page(root: Path) -> str:
    """The title page, from what the project says of itself."""
    citation = yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))
    config = yaml.safe_load((root / "_config.yml").read_text(encoding="utf-8"))
    paper = citation["references"][0]
    authors = ", ".join(f"{one['given-names']} {one['family-names']}" for one in paper["authors"])
    words = {key: html.escape(str(config[key])) for key in ("title", "author", "copyright")}
    return (
        f'<header class="cx-title"><p class="cx-name">{words["title"]}</p>'
        f"<p>An executable twin of the paper <em>{html.escape(paper['title'])}</em><br>"
        f'by {html.escape(authors)}<br>(<a href="https://doi.org/{paper["doi"]}">doi:{paper["doi"]}</a>)</p>'
        f'<p class="cx-by">{words["author"]}, version {citation["version"]}, {words["copyright"]}</p>'
        "</header>"
    )


def pages_of(path: Path) -> dict[str, int]:
    """On which page each place is, that a link in the document leads to."""
    reader = pypdf.PdfReader(path)
    places = reader.named_destinations.items()
    return {name.lstrip("/"): (reader.get_destination_page_number(place) or 0) + 1 for name, place in places}


def print_book(page: Any, path: Path, tagged: bool = True) -> None:
    """Print to A4, with marks for those who have it read to them, which take twice the time."""
    page.pdf(path=path, prefer_css_page_size=True, print_background=True, tagged=tagged)


def make(folder: Path, toc: Path, root: Path, target: Path) -> list[str]:
    """Print the book; what is wrong with it."""
    source = folder.parent / "pdf" / "book.html"
    source.parent.mkdir(exist_ok=True)
    book = Book(folder, chapters_of(toc))
    source.write_text(document(book, front_page(root), json.dumps(MATH)), encoding="utf-8")
    say("put together")
    with one_chromium() as browser:
        page = browser.new_page(viewport={"width": WIDTH, "height": 930}, color_scheme="light")
        page.set_default_timeout(MINUTES * 60_000)
        page.emulate_media(media="print")
        page.goto(source.as_uri())
        page.evaluate("MathJax.startup.promise.then(() => null)")
        say("formulas set")
        page.evaluate(FIT.read_text(encoding="utf-8"))
        clipped = page.evaluate("clipped()")
        say(f"wide things fitted; smallest: {', '.join(page.evaluate('smallest()'))}")
        print_book(page, target, tagged=False)
        say("printed once, for the page numbers")
        numbers, lines = pages_of(target), page.evaluate("lines()")
        lost = page.evaluate("numbers => fill(numbers)", numbers)
        print_book(page, target)
    say("printed")
    add_bookmarks(target, lines, numbers)
    say("bookmarks added")
    return [*(f"sticks out: {x}" for x in clipped), *(f"no page known: {x}" for x in lost), *wrong(target)]


def add_bookmarks(path: Path, lines: list[list[str]], numbers: dict[str, int]) -> None:
    """The lines of the contents, kind, place and words of each, as the reader's side bar shows them.

    Chromium makes bookmarks too, but of headings without their formulas.
    """
    writer = pypdf.PdfWriter(clone_from=path)
    above: dict[int, Any] = {}
    for kind, place, words in lines:
        level = LEVELS.index(kind)
        parent = next((above[i] for i in range(level - 1, -1, -1) if i in above), None)
        fit = pypdf.generic.Fit.fit()
        number = numbers[place] - 1
        item = writer.add_outline_item(
            title=words, page_number=number, parent=parent, fit=fit, is_open=level == 0
        )
        above = {i: old for i, old in above.items() if i < level} | {level: item}
    writer.add_metadata({"/Title": "Coxeter triangulations, computed"})
    writer.page_mode = "/UseOutlines"
    writer.write(path)


def wrong(path: Path) -> list[str]:
    """What is wrong with a PDF: no bookmarks, no pages, links that lead nowhere or into this machine."""
    reader = pypdf.PdfReader(path)
    faults = [] if reader.outline else ["no bookmarks"]
    places = set(reader.named_destinations)
    for number, page in enumerate(reader.pages, start=1):
        for link in page.get("/Annots", ()) or ():
            link = link.get_object()
            action = link.get("/A", {})
            address, place = str(action.get("/URI", "")), link.get("/Dest", action.get("/D"))
            if address and not address.startswith(("https://", "http://", "mailto:")):
                faults.append(f"page {number}: link to {address}")
            elif not address and isinstance(place, str) and place not in places and f"/{place}" not in places:
                faults.append(f"page {number}: link to the missing place {place}")
            elif not address and place is None:
                faults.append(f"page {number}: link to nothing")
    return faults


def say(what: str, begin: float = time.time()) -> None:
    print(f"  {time.time() - begin:6.1f} s  {what}", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("site", type=Path, nargs="?", default=ROOT / "_build/html", help="the rendered book")
    parser.add_argument("--toc", type=Path, default=ROOT / "_toc.yml")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "_build/coxeter-triangulations.pdf")
    options = parser.parse_args()
    if not find_chromium():
        print(f"The PDF was not made: {ABSENT}.", file=sys.stderr)
        return 1
    if not (options.site / "index.html").is_file():
        print(f"There is no rendered book in {options.site}: run make book first.", file=sys.stderr)
        return 1
    faults = make(options.site.resolve(), options.toc, ROOT, options.output)
    for fault in faults:
        print(f"FAULT {fault}")
    pages, size = len(pypdf.PdfReader(options.output).pages), options.output.stat().st_size / 1e6
    print(f"{options.output}: {pages} pages, {size:.1f} MB, {len(faults)} faults")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
