"""Every check of the rendered site passes on a good site, and can fail on a bad one."""

import subprocess
import sys
from pathlib import Path

import check_site
import pytest

WORDS = "Every number of this page has just been computed, exactly, from the simple roots alone. "
INDEX = f"""<!doctype html><html><head>
<link rel="stylesheet" href="_static/style.css?v=1">
<script src="_static/tex-svg.js?v=1"></script>
</head><body><article>
<h1>Book</h1>
<p>{WORDS * 2}</p>
<p><a href="pages/next.html#part">next</a> <a href="https://example.org/">elsewhere</a></p>
<p><span class="math">\\(x\\)</span></p>
<img src="_static/a.png" alt="a triangle">
<svg role="img"><title>the diagram of B3</title></svg>
<svg aria-hidden="true"></svg>
</article></body></html>"""
NEXT = f"""<!doctype html><html><body><main>
<h1>Next</h1><p id="part">{WORDS * 2}</p><a href="../index.html">back</a>
</main></body></html>"""
CHAPTER = f"""<!doctype html><html><body>
<a href="../_sources/notebooks/one.ipynb" class="btn">.ipynb</a>
<main><h1>One</h1><p>{WORDS * 2}</p></main>
</body></html>"""
FILES = {
    "_toc.yml": "root: index\nparts:\n- chapters:\n  - file: pages/next\n  - file: notebooks/one\n",
    "html/notebooks/one.html": CHAPTER,
    "html/_sources/notebooks/one.ipynb": '{"cells": [{"cell_type": "markdown"}]}',
    "html/index.html": INDEX,
    "html/pages/next.html": NEXT,
    "html/_static/style.css": "@import 'more.css'; p { background: url(data:image/png;base64,) }",
    "html/_static/tex-svg.js": "// see https://example.org/",
    "html/_static/a.png": "",
}


@pytest.fixture
def site(tmp_path: Path) -> check_site.Site:
    for name, text in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return check_site.Site(tmp_path / "html", tmp_path / "_toc.yml")


def faults(site: check_site.Site) -> str:
    site.check()
    return "\n".join(site.faults)


def test_a_good_site_has_no_faults(site: check_site.Site) -> None:
    assert faults(site) == ""
    assert site.checked["pages of the table of contents"] == 3
    assert all(site.checked.values())


@pytest.mark.parametrize("remote", ["https://cdn.example.org/x", "//cdn.example.org/x"])
@pytest.mark.parametrize(
    "markup",
    [
        '<script src="{}"></script>',
        '<link rel="stylesheet" href="{}">',
        '<link rel="preload" href="{}">',
        '<link rel="shortcut icon" href="{}">',
        '<link rel="preconnect" href="{}">',
        '<img src="{}" alt="a triangle">',
        '<img src="_static/a.png" srcset="_static/a.png 1x, {} 2x" alt="a triangle">',
        '<iframe src="{}"></iframe>',
        '<object data="{}"></object>',
        '<svg aria-hidden="true"><use xlink:href="{}"></use></svg>',
        '<p style="background: url({})"></p>',
        "<style>@import '{}';</style>",
        '<style>@font-face {{ src: url("{}") }}</style>',
        '<script type="module">import x from "{}"</script>',
        '<script>const URL_OF_LIBRARY = "{}"</script>',
    ],
)
def test_requests_to_other_hosts_are_found(site: check_site.Site, markup: str, remote: str) -> None:
    page = site.folder / "index.html"
    page.write_text(INDEX.replace("</article>", markup.format(remote) + "</article>"))
    assert f"request to another host: {remote}" in faults(site)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("style.css", "@import url(https://cdn.example.org/x.css);"),
        ("style.css", "@font-face { src: url('//cdn.example.org/x.woff') }"),
        ("tex-svg.js", 'import * as x from "https://cdn.example.org/x.js"'),
        ("tex-svg.js", 'export {x} from "https://cdn.example.org/x.js"'),
        ("tex-svg.js", 'import "https://cdn.example.org/x.js"'),
        ("tex-svg.js", 'import("https://cdn.example.org/x.js")'),
    ],
)
def test_remote_assets_are_found(site: check_site.Site, name: str, text: str) -> None:
    (site.folder / "_static" / name).write_text(text)
    assert f"_static/{name}: request to another host" in faults(site)


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("pages/next.html#part", "pages/none.html", "broken link to pages/none.html"),
        ("next.html#part", "next.html#none", "#none: no such place there"),
        ("pages/next.html#part", "#none", "broken link to #none: no such place there"),
        ("_static/a.png", "_static/b.png", "broken link to _static/b.png"),
        ("style.css", "none.css", "broken link to _static/none.css"),
        ("tex-svg.js", "other.js", "no local renderer"),
        ("_static/tex-svg.js", "https://example.org/tex-svg.js", "no local renderer"),
        ('alt="a triangle"', "", "no alternative text"),
        ('alt="a triangle"', 'alt=" "', "no alternative text"),
        ('alt="a triangle"', 'alt="_static/a.png"', "no alternative text"),
        ("<title>the diagram of B3</title>", "", "a drawing without title"),
        ("the diagram of B3", " ", "a drawing without title"),
        (WORDS * 2, "Short.", "words of text"),
    ],
)
def test_a_spoilt_page_is_found(site: check_site.Site, old: str, new: str, fault: str) -> None:
    assert old in INDEX
    (site.folder / "index.html").write_text(INDEX.replace(old, new))
    assert fault in faults(site)


def test_a_missing_page_is_found(site: check_site.Site) -> None:
    (site.folder / "pages" / "next.html").unlink()
    assert "pages/next.html: in the table of contents, but not built" in faults(site)


def test_a_heading_alone_is_an_empty_page(site: check_site.Site) -> None:
    page = site.folder / "pages" / "next.html"
    page.write_text(f'<main id="part"><h1>{WORDS * 2}</h1></main>')
    assert "pages/next.html: fewer than" in faults(site)


@pytest.mark.parametrize(
    ("name", "old", "new", "fault"),
    [
        ("notebooks/one.html", "one.ipynb", "other.ipynb", "no link to download one.ipynb"),
        ("_sources/notebooks/one.ipynb", '[{"cell_type": "markdown"}]', "[]", "one.ipynb is no notebook"),
    ],
)
def test_a_notebook_that_cannot_be_had_is_found(
    site: check_site.Site, name: str, old: str, new: str, fault: str
) -> None:
    path = site.folder / name
    path.write_text(path.read_text().replace(old, new))
    assert fault in faults(site)


@pytest.mark.parametrize("spoil", [False, True])
def test_the_command_says_what_it_checked(site: check_site.Site, spoil: bool) -> None:
    if spoil:
        (site.folder / "pages" / "next.html").unlink()
    command = [sys.executable, check_site.__file__, str(site.folder), "--toc", str(site.toc)]
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == spoil
    assert "3 pages of the table of contents" in result.stdout
    assert ("FAULT pages/next.html" in result.stdout) == spoil


@pytest.mark.parametrize(
    ("link", "part", "good"),
    [
        ("#measure=thickness&max=9", '<figure class="cx-explorer"></figure>', True),
        ("#measure=thickness&max=9", "", False),  # nothing on the page reads it
        ("#measure=", '<form class="lg-controls"></form>', False),
    ],
)
def test_an_address_may_say_what_controls_are_set_to(
    site: check_site.Site, link: str, part: str, good: bool
) -> None:
    page = site.folder / "pages/next.html"
    page.write_text(NEXT.replace("</main>", f'<a href="{link}">set</a>{part}</main>'), encoding="utf-8")
    assert ("no such place" in faults(site)) is not good
