"""The pages of the rendered book put together into one, for paper.

Every id gets the name of its page before it, and every link to a page of the book becomes a link within. A
link to a file that is not printed, such as the source of a check, leaves its words behind.
"""

import html
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from posixpath import dirname, normpath
from typing import Any
from urllib.parse import unquote, urlsplit

import yaml
from bs4 import BeautifulSoup, Tag

# What is for hands only, or says again what stands elsewhere.
LEFT_OUT = (
    "script, style, button, .headerlink, .copybtn, .toggle-button, .viewcode-link, .noprint"
    ", .lg-controls, .cx-controls, .lg-claim .lg-meta, .lg-claim details, .lg-card details"
    ", .cell:has(> details.hide)"
)
NAMING = ("id", "for", "aria-labelledby", "aria-describedby", "aria-controls", "headers", "list")
REFERENCE = re.compile(r"url\((['\"]?)#([^)'\"]+)\1\)")
HEADINGS = ("h5", "h4", "h3", "h2", "h1")


@dataclass(frozen=True)
class Chapter:
    """A page of the book, and the part that it opens, if it is the first of one."""

    name: str
    part: str | None = None

    @property
    def prefix(self) -> str:
        return "p-" + re.sub(r"[^\w-]", "-", self.name)


def chapters_of(toc: Path) -> list[Chapter]:
    """The pages that a table of contents names, in order."""
    data = yaml.safe_load(toc.read_text(encoding="utf-8"))
    return [Chapter(data["root"]), *_chapters(data)]


def _chapters(node: dict[str, Any], part: str | None = None) -> Iterator[Chapter]:
    for inner in node.get("parts", []):
        yield from _chapters(inner, inner.get("caption"))
    for key in ("chapters", "sections"):
        for number, entry in enumerate(node.get(key, [])):
            yield Chapter(entry["file"], None if number else part)
            yield from _chapters(entry)


@dataclass
class Book:
    """The rendered pages of a folder, as chapters of one document."""

    folder: Path
    chapters: list[Chapter]

    @cached_property
    def soups(self) -> dict[str, BeautifulSoup]:
        paths = {chapter.name: self.folder / f"{chapter.name}.html" for chapter in self.chapters}
        return {name: BeautifulSoup(path.read_text("utf-8"), "html.parser") for name, path in paths.items()}

    @cached_property
    def bodies(self) -> dict[str, Tag]:
        """What is printed of each page, with its ids and links as they were."""
        found = {name: soup.select_one("article.bd-article") for name, soup in self.soups.items()}
        if empty := [name for name, body in found.items() if body is None]:
            raise ValueError(f"pages without an article: {', '.join(empty)}")
        bodies = {name: body for name, body in found.items() if body is not None}
        for body in bodies.values():
            strip(body)
        return bodies

    @cached_property
    def places(self) -> dict[str, set[str]]:
        return {name: {str(x["id"]) for x in body.find_all(id=True)} for name, body in self.bodies.items()}

    @cached_property
    def styles(self) -> list[str]:
        """The style sheets of all pages, from the folder of the site, each once."""
        links = [
            normpath(f"{dirname(name)}/{urlsplit(str(link['href'])).path}".lstrip("/"))
            for name, soup in self.soups.items()
            for link in soup.find_all("link", rel="stylesheet", href=True)
            if link.get("media") != "print"
        ]
        return list(dict.fromkeys(links))

    def texts(self) -> Iterator[tuple[Chapter, str]]:
        """Each chapter with its HTML, of which all may stand in one document."""
        known = {chapter.name: chapter for chapter in self.chapters}
        for chapter in self.chapters:
            body = self.bodies[chapter.name]
            places = self.places  # before any of them is renamed
            for tag in body.find_all(True):
                self._rename(tag, chapter, known, places)
            for level, name in enumerate(HEADINGS):
                for heading in body.find_all(name):
                    heading.name = f"h{6 - level}"  # a part's title stands above all
            yield chapter, body.decode_contents()

    def _rename(
        self, tag: Tag, chapter: Chapter, known: dict[str, Chapter], places: dict[str, set[str]]
    ) -> None:
        for name in NAMING:
            if tag.has_attr(name):
                words = tag.get_attribute_list(name)
                names = " ".join(str(word) for word in words).split()
                tag[name] = " ".join(f"{chapter.prefix}--{word}" for word in names)
        for name in ("href", "xlink:href", "src", "data"):
            if tag.has_attr(name):
                new = self._link(str(tag[name]), chapter, known, places)
                if new is not None:
                    tag[name] = new
                elif tag.name == "a":
                    del tag[name]
        for name, value in list(tag.attrs.items()):
            if isinstance(value, str) and "url(" in value:
                tag[name] = REFERENCE.sub(rf"url(#{chapter.prefix}--\2)", value)

    def _link(
        self, address: str, chapter: Chapter, known: dict[str, Chapter], places: dict[str, set[str]]
    ) -> str | None:
        """An address as it is within the one document; None if it leads to what is not printed."""
        parts = urlsplit(address)
        if parts.scheme or parts.netloc:
            return address
        path = normpath(f"{dirname(chapter.name)}/{unquote(parts.path)}".lstrip("/")) if parts.path else ""
        name = path.removesuffix(".html") if path else chapter.name
        if name not in known:
            return f"../html/{path}" if path.startswith(("_images/", "_static/")) else None
        place = unquote(parts.fragment)
        if not place and not path:
            return None  # "#" alone leads nowhere
        return f"#{known[name].prefix}" + (f"--{place}" if place in places[name] else "")


def strip(body: Tag) -> None:
    """Leave out what is for hands only; open what is folded; show what stands there for want of scripts."""
    for tag in body.select(LEFT_OUT):
        if not tag.decomposed:
            tag.decompose()
    for tag in body.select("noscript, summary > p.expanded"):
        if tag.name == "noscript":
            tag.unwrap()
        else:
            tag.decompose()
    for tag in body.select("details"):
        tag["open"] = ""
    for tag in body.select(".lg-tex"):
        tag["class"] = ["math", "notranslate", "nohighlight"]


def title_of(text: str) -> str:
    """The title of a chapter, as HTML."""
    heading = BeautifulSoup(text, "html.parser").find("h2")
    return heading.decode_contents() if isinstance(heading, Tag) else ""


def sections_of(text: str) -> list[tuple[str, str]]:
    """The places of a chapter's sections and their titles, as HTML."""
    soup = BeautifulSoup(text, "html.parser")
    found = []
    for heading in soup.find_all("h3"):
        section = heading.find_parent("section", id=True)
        if isinstance(section, Tag) and section.find("h3") is heading:
            found.append((str(section["id"]), heading.decode_contents()))
    return found


def document(book: Book, front: str, math: str) -> str:
    """The whole document: title page, contents, chapters."""
    chapters, contents = [], []
    for chapter, text in book.texts():
        if chapter.part:
            part = html.escape(chapter.part)
            chapters.append(f'<h1 class="cx-part" id="{chapter.prefix}--part">{part}</h1>')
            contents.append(line("part", f"{chapter.prefix}--part", part))
        contents.append(line("chapter", chapter.prefix, title_of(text)))
        contents += [line("section", place, title) for place, title in sections_of(text)]
        chapters.append(f'<article class="bd-article cx-chapter" id="{chapter.prefix}">{text}</article>')
    styles = [f'<link rel="stylesheet" href="../html/{name}">' for name in book.styles]
    return f"""<!doctype html>
<html lang="en" data-theme="light" data-mode="light" data-content_root="../html/"><head><meta charset="utf-8">
<title>Coxeter triangulations, computed</title>
{chr(10).join(styles)}
<link rel="stylesheet" href="../html/_static/print.css">
<script>window.MathJax = {math};</script>
<script defer src="../html/_static/tex-svg-full.js"></script>
</head><body class="cx-book"><main class="bd-main">
{front}
<nav class="cx-contents"><h1>Contents</h1>{"".join(contents)}</nav>
{chr(10).join(chapters)}
</main></body></html>
"""


def line(kind: str, place: str, title: str) -> str:
    """A line of the contents; its number is filled in when the pages are known."""
    words = re.sub(r"</?a\b[^>]*>", "", title)
    number = f'<span class="cx-number" data-place="{place}">000</span>'
    return f'<p class="cx-{kind}"><a href="#{place}"><span>{words}</span></a><i></i>{number}</p>'
