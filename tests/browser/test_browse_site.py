"""The browser finds each fault that is planted, and none on a good page."""

import asyncio
import doctest
import random
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import browse_server
import browse_site
import pytest
import screenshots
from browse_baseline import EXCUSES, Baseline, Excuse
from browse_chromium import ABSENT, find_chromium
from browse_page import Seen
from browse_report import faults, row, table, write
from browse_server import file_of, weight

needs_chromium = pytest.mark.skipif(find_chromium() is None, reason=ABSENT)
GOOD = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A page</title>
<meta name="viewport" content="width=device-width, initial-scale=1"><style>
html {{ background: #fff; color: #111 }} html[data-theme="dark"] {{ background: #111; color: #eee }}
</style></head><body><main><h1>A page</h1><p>Words. <code>\\(not a formula\\)</code> {body}</p></main>
</body></html>"""
TRAP = """<input id="a"><input id="b"><script>b.onblur = () => setTimeout(() => a.focus())</script>
<p class="lg-controls"></p><a href="good.html">1</a> <a href="good.html">2</a>"""
WIDER = '<div class="odd" style="overflow-x: auto"><div style="width: 600px">x</div></div>'
PLANTED = {
    "console": ("<script>console.error('oh')</script>", "errors", "console: oh"),
    "script": ("<script>undefined.x</script>", "errors", "script: "),
    "missing": ('<script src="none.js"></script>', "errors", "404: none.js"),
    "external": ('<img src="http://host.invalid/a.png" alt="a">', "other hosts", "host.invalid"),
    "fetched": ("<script>fetch('//host.invalid/x').catch(() => 0)</script>", "other hosts", "invalid/x"),
    "wide": ('<span style="display: block; width: 600px">x</span>', "overflow", "span"),
    "words": (f"<b>{'x' * 200}</b>", "overflow", "the page is"),
    "scrolls": (WIDER, "overflow", "scrolls sideways"),
    "picture": ('<img src="data:image/gif;base64,R0lGODlhAQABAAAAACw=">', "alternatives", "img"),
    "drawing": ('<svg width="9" height="9"><rect width="9" height="9"/></svg>', "alternatives", "svg"),
    "raw": (r"We have \(x^2\).", "formulas", "not set: We have"),
    "dollars": ("We have $$x^2$$.", "formulas", "not set: We have"),
    "unset": ('<span class="math">x^2</span>', "formulas", "not set: x^2"),
    "merror": (
        '<mjx-container><mjx-merror data-mjx-error="No">x</mjx-merror></mjx-container>',
        "formulas",
        "No",
    ),
    "pale": ("<style>p { color: #ccc }</style>", "axe light", "color-contrast"),
    "dim": ('<style>html[data-theme="dark"] p { color: #333 }</style>', "axe dark", "color-contrast"),
    "nameless": ('<a href="good.html"></a>', "axe light", "link-name"),
    "unreached": ('<button tabindex="-1">Go</button>', "keyboard", "not reached"),
    "unseen": (
        '<style>a { outline: 0 !important }</style><a href="#">on</a>',
        "keyboard",
        "focus not visible",
    ),
    "trap": (TRAP, "keyboard", "Tab comes back"),
    "heavy": ('<img src="heavy.bin" alt="a">', "weight", "heavy.bin"),
    "plotting": ('<script src="plotly.min.js"></script>', "weight", "plotly.min.js is loaded"),
    "hanging": ("<script>setTimeout(() => { while (true) {} }, 50)</script>", "errors", "could not be"),
    "lazy": ('<p class="lg-claim"><span class="lg-tex">x</span></p>', "formulas", "scrolled into view"),
}


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    for name, (body, _, _) in PLANTED.items():
        (folder / f"{name}.html").write_text(GOOD.format(body=body), encoding="utf-8")
    (folder / "good.html").write_text(GOOD.format(body=""), encoding="utf-8")
    (folder / "heavy.bin").write_bytes(random.Random(0).randbytes(1_600_000))
    (folder / "plotly.min.js").write_text("")
    (folder / "_static").mkdir()
    (folder / "_static" / "template.html").write_text("no page")
    return folder


@needs_chromium
def test_each_planted_fault_is_found_and_nothing_on_a_good_page(
    site: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("browse_page.UNSET", 200)
    monkeypatch.setattr("browse_page.PATIENCE", 8000)
    seen = {one.page: one for one in asyncio.run(browse_site.browse(site, workers=2))}
    assert set(seen) == {f"{name}.html" for name in ["good", *PLANTED]}
    assert {kind: found for kind, found in seen["good.html"].found.items() if found} == {}
    missed = {
        name: dict(seen[f"{name}.html"].found)
        for name, (_, kind, words) in PLANTED.items()
        if not any(words in text for text in seen[f"{name}.html"].found[kind])
    }
    assert missed == {}
    assert 0 < seen["good.html"].seconds < 20
    assert seen["heavy.html"].kilobytes > 1500 > seen["plotting.html"].kilobytes


def test_without_a_browser_one_line_says_so(site: Path) -> None:
    command = [sys.executable, browse_site.__file__, str(site)]
    nowhere = {"PATH": "", "CHROMIUM": "no-such-browser"}
    result = subprocess.run(command, capture_output=True, text=True, env=nowhere)
    assert result.returncode == 0
    assert result.stdout == f"SKIPPED the book in a browser: {ABSENT}\n"


def test_a_page_of_many_alike_is_known_by_its_folder(site: Path) -> None:
    assert "_static/template.html" not in browse_site.pages_of(site)
    assert browse_site.presses(site, "trap.html")
    assert not browse_site.presses(site, "good.html")


def seen_with(**found: list[str]) -> Seen:
    seen = Seen("a.html", requests=3, kilobytes=12.4, seconds=1.234)
    for kind, texts in found.items():
        seen.note(kind.replace("_", " "), texts)
    return seen


def test_what_is_excused_is_counted_and_taken_out() -> None:
    seen = seen_with(errors=["theme: x", "ours: y"], axe_dark=["theme: x"])
    excuse = Excuse("errors", "^theme", "why")
    baseline = Baseline([excuse])
    baseline.excuse(seen)
    assert dict(seen.found) == {"errors": ["ours: y"], "axe dark": ["theme: x"]}
    assert baseline.needed[excuse] == 1
    assert "1 of errors, /^theme/: why" in baseline.used()


def test_every_excuse_has_a_reason() -> None:
    assert all(len(excuse.reason.split()) > 4 and excuse.pattern for excuse in EXCUSES)


def test_the_table_has_a_row_for_each_page(tmp_path: Path) -> None:
    seen = seen_with(errors=["x", "x", "y"], overflow=["z"], keyboard=["k"])
    assert row(seen) == ["a.html", "3", "2", "12", "1.23", "0", "0", "1", "1"]
    assert table([seen]).splitlines()[1].split() == row(seen)
    assert faults([seen])[0] == "FAULT a.html: errors: x"
    write(tmp_path, [seen], Baseline([]))
    assert "| a.html | 3 | 2 | 12 | 1.23 |" in (tmp_path / "browser.md").read_text()
    assert '"overflow": [' in (tmp_path / "browser.json").read_text()


@pytest.mark.parametrize("module", [browse_server, screenshots])
def test_the_examples_in_the_tools(module: ModuleType) -> None:
    result = doctest.testmod(module)
    assert result.attempted
    assert not result.failed


def test_addresses_lead_to_files_and_files_have_weights(site: Path) -> None:
    base = "http://127.0.0.1:1/"
    assert file_of(f"{base}heavy.bin?v=1", base, site) == site / "heavy.bin"
    assert file_of(base, base, site) == site / "index.html"
    assert weight(site / "heavy.bin") > 1_500_000
    assert weight(site / "none") == 0
