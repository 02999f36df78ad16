"""Check a rendered book: its pages, its links, and that it asks nothing of other hosts."""

import argparse
import json
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from urllib.parse import unquote, urlsplit

import yaml
from bs4 import BeautifulSoup, Tag

ENOUGH_WORDS = 15
NOTEBOOKS = "notebooks/"
ADDRESSES = ("href", "src", "data", "poster", "xlink:href")
SILENT = {"h1", "script", "style", "pre", "code"}
LOADING_RELS = {"stylesheet", "preload", "modulepreload", "prefetch", "preconnect"} | {
    "dns-prefetch",
    "icon",
    "apple-touch-icon",
    "manifest",
}
# What a browser fetches by itself when it opens a page, beside <link>. Links to follow are fine.
LOADING = "script img iframe frame embed source video audio track input object use image base"
REMOTE = re.compile(r"(?:https?:)?//", re.IGNORECASE)
REMOTE_IN_CSS = re.compile(
    r"""(?:@import\s*(?:url\()?|url\()\s*["']?((?:https?:)?//[^"')\s;]+)""", re.IGNORECASE
)
REMOTE_IMPORT = re.compile(
    r"""\b(?:import|export)\b(?:[\w\s{},*$]*\bfrom)?\s*\(?\s*["'`]((?:https?:)?//[^"'`]+)"""
)
# A script inside a page is short: any address in it is taken for a request. Not so the names
# of XML vocabularies, which look like addresses.
REMOTE_IN_SCRIPT = re.compile(r"""["'`]((?:https?:)?//(?!www\.w3\.org/)[^"'`\s]+)["'`]""")
# Parts of a page that read from its address what they are to show.
SETTABLE = ".cx-explorer, .lg-controls"
RENDERER = re.compile(r"(?:tex-|mml-|mathjax|katex)[^/]*\.js(?:\?|$)", re.IGNORECASE)


@dataclass
class Page:
    path: Path

    @cached_property
    def soup(self) -> BeautifulSoup:
        return BeautifulSoup(self.path.read_text(encoding="utf-8"), "html.parser")

    @cached_property
    def anchors(self) -> set[str]:
        named = (str(tag[name]) for tag in self.tags for name in ("id", "name") if name in tag.attrs)
        return {"", "top", *named}

    def knows(self, fragment: str) -> bool:
        """Whether an address may end so: with a place on the page, or with what its controls are set to."""
        state = re.fullmatch(r"\w+=[^&=]+(&\w+=[^&=]+)*", fragment)
        return fragment in self.anchors or bool(state and self.soup.select_one(SETTABLE))

    @cached_property
    def tags(self) -> list[Tag]:
        return self.soup.find_all(True)

    @cached_property
    def body(self) -> Tag:
        """What the page says, without menus."""
        return self.soup.find("article") or self.soup.find("main") or self.soup


@dataclass
class Site:
    """A rendered book. Each check counts what it looked at and notes what it found wrong."""

    folder: Path
    toc: Path
    checked: Counter[str] = field(default_factory=Counter)
    faults: list[str] = field(default_factory=list)

    @cached_property
    def pages(self) -> dict[Path, Page]:
        folder = self.folder.resolve()
        paths = sorted(folder.rglob("*.html"))
        # What lies in _static is no page: themes keep their templates there.
        return {path: Page(path) for path in paths if folder / "_static" not in path.parents}

    def fault(self, where: Path, what: str) -> None:
        self.faults.append(f"{where.relative_to(self.folder.resolve())}: {what}")

    def check(self) -> None:
        self.check_contents()
        self.check_downloads()
        for page in self.pages.values():
            self.check_links(page)
            self.check_requests(page)
            self.check_formulas(page)
            self.check_alternatives(page)
        self.check_assets()

    def check_contents(self) -> None:
        """Every page of the table of contents exists and says something."""
        for name in toc_files(yaml.safe_load(self.toc.read_text(encoding="utf-8"))):
            self.checked["pages of the table of contents"] += 1
            path = self.folder.resolve() / f"{name}.html"
            if path not in self.pages:
                self.faults.append(f"{name}.html: in the table of contents, but not built")
            elif len(plain_words(self.pages[path].body)) < ENOUGH_WORDS:
                self.fault(path, f"fewer than {ENOUGH_WORDS} words of text")

    def check_downloads(self) -> None:
        """Every chapter that is a notebook gives it away, whole: see its button *download*."""
        for name in toc_files(yaml.safe_load(self.toc.read_text(encoding="utf-8"))):
            page = self.pages.get(self.folder.resolve() / f"{name}.html")
            if page is None or not name.startswith(NOTEBOOKS):
                continue
            self.checked["notebooks to download"] += 1
            file = f"{name.rpartition('/')[2]}.ipynb"
            link = page.soup.find("a", href=re.compile(rf"(?:^|/){re.escape(file)}$"))
            path = (page.path.parent / unquote(str(link["href"]))).resolve() if link else None
            if path is None:
                self.fault(page.path, f"no link to download {file}")
            elif not (path.is_file() and json.loads(path.read_text(encoding="utf-8")).get("cells")):
                self.fault(page.path, f"what is downloaded as {file} is no notebook")

    def check_links(self, page: Page) -> None:
        """Every local address leads to a file, and its fragment to a place in it."""
        for tag in page.tags:
            for name in ADDRESSES:
                address = str(tag.attrs.get(name, "")).strip()
                parts = urlsplit(address)
                if not address or parts.scheme or parts.netloc:
                    continue
                self.checked["internal links"] += 1
                target = (page.path.parent / unquote(parts.path)).resolve()
                if not parts.path:
                    target = page.path
                if target.is_dir():
                    target /= "index.html"
                if not target.is_file():
                    self.fault(page.path, f"broken link to {address}")
                elif target in self.pages and not self.pages[target].knows(unquote(parts.fragment)):
                    self.fault(page.path, f"broken link to {address}: no such place there")

    def check_requests(self, page: Page) -> None:
        """Nothing that the browser loads by itself comes from another host."""
        for address in requests_of(page.soup):
            self.checked["requests made by pages"] += 1
            if REMOTE.match(address):
                self.fault(page.path, f"request to another host: {address}")

    def check_formulas(self, page: Page) -> None:
        """A page with formulas loads a renderer that is part of the site."""
        if not page.soup.select_one(".math") and not re.search(r"\\[(\[]", " ".join(plain_words(page.body))):
            return
        self.checked["pages with formulas"] += 1
        for script in page.soup.find_all("script", src=RENDERER):
            address = urlsplit(str(script["src"]))
            if not address.netloc and (page.path.parent / unquote(address.path)).is_file():
                return
        self.fault(page.path, "formulas, but no local renderer for them")

    def check_alternatives(self, page: Page) -> None:
        """Every picture can be read by those who cannot see it."""
        for image in page.soup.find_all("img"):
            self.checked["pictures"] += 1
            words = str(image.get("alt", "")).strip()
            if not words or re.search(r"\.(?:svg|png|jpe?g|gif|webp)$", words):
                self.fault(page.path, f"no alternative text: {image.get('src')}"[:150])
        for drawing in page.body.find_all("svg"):
            if drawing.get("aria-hidden") == "true" or drawing.find_parent("svg"):
                continue  # an ornament, or a part of a drawing
            self.checked["pictures"] += 1
            title = drawing.find("title")
            if not (title and title.get_text(strip=True)) and not drawing.get("aria-label"):
                self.fault(page.path, f"a drawing without title: {drawing}"[:150])

    def check_assets(self) -> None:
        """No style sheet and no script of the site loads from another host."""
        for suffix, pattern in ((".css", REMOTE_IN_CSS), (".js", REMOTE_IMPORT)):
            for path in sorted(self.folder.resolve().rglob(f"*{suffix}")):
                self.checked[f"{suffix} files"] += 1
                for address in pattern.findall(path.read_text(encoding="utf-8")):
                    self.fault(path, f"request to another host: {address}")


def toc_files(node: object) -> Iterator[str]:
    """The pages that a table of contents names, at every depth."""
    if isinstance(node, list):
        for child in node:
            yield from toc_files(child)
    elif isinstance(node, dict):
        yield from (node[key] for key in ("root", "file") if key in node)
        for key in ("parts", "chapters", "sections", "subtrees", "entries"):
            yield from toc_files(node.get(key))


def plain_words(body: Tag) -> list[str]:
    """The words of a page, without its title and its code."""
    return " ".join(_texts(body)).split()


def _texts(node: Tag) -> Iterator[str]:
    """What a page says, down to whatever says something else."""
    for child in node.children:
        if not isinstance(child, Tag):
            yield str(child)
        elif child.name not in SILENT:
            yield from _texts(child)


def requests_of(soup: BeautifulSoup) -> Iterator[str]:
    """The addresses that a browser loads when it opens the page."""
    for link in soup.find_all("link", href=True):
        if LOADING_RELS & {rel.lower() for rel in link.get_attribute_list("rel") if rel}:
            yield str(link["href"])
    for tag in soup.find_all(LOADING.split()):
        for name in ("src", "href", "xlink:href", "data", "poster"):
            if tag.has_attr(name):
                yield str(tag[name])
    for tag in soup.find_all(srcset=True):
        yield from (part.split()[0] for part in str(tag["srcset"]).split(",") if part.strip())
    for tag in soup.find_all(style=True):
        yield from REMOTE_IN_CSS.findall(str(tag["style"]))
    for style in soup.find_all("style"):
        yield from REMOTE_IN_CSS.findall(style.get_text())
    for script in soup.find_all("script", src=False):
        if "json" not in str(script.get("type", "")):
            yield from REMOTE_IN_SCRIPT.findall(script.get_text())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("site", type=Path, help="the folder of the rendered book")
    parser.add_argument("--toc", type=Path, default=Path("_toc.yml"))
    options = parser.parse_args()
    site = Site(options.site, options.toc)
    site.check()
    for what, number in site.checked.items():
        print(f"  {number:6} {what}")
    for fault in site.faults:
        print(f"FAULT {fault}")
    print(f"{len(site.pages)} pages, {len(site.faults)} faults")
    return bool(site.faults or not site.pages)


if __name__ == "__main__":
    sys.exit(main())
