"""Take a picture of every page of the table of contents in four modes: wide and phone, light and dark."""

import argparse
import asyncio
import html
import sys
import time
from pathlib import Path
from typing import Any

from browse_chromium import ABSENT, chromium, find_chromium
from browse_page import PATIENCE, PHONE, PROBE, WIDE
from browse_server import serve
from pdf_pages import Chapter, chapters_of

ROOT = Path(__file__).resolve().parent.parent
SIZES, SCHEMES = {"wide": WIDE, "phone": PHONE}, ("light", "dark")
MODES = [f"{size}-{scheme}" for size in SIZES for scheme in SCHEMES]
TALLEST = 16000  # pixels; Chromium draws no taller picture
SETTLED = 800  # milliseconds until what moves has come to rest
SCROLL = """async () => {
  for (let y = 0; y < document.documentElement.scrollHeight; y += innerHeight) {
    scrollTo({ top: y, behavior: "instant" });
    await new Promise((done) => setTimeout(done, 60));
  }
  scrollTo({ top: 0, behavior: "instant" });
}"""  # what is drawn only when it comes into view is drawn


async def take(browser: Any, base: str, name: str, size: str, target: Path) -> None:
    """Two pictures of a page, light and dark: of the whole page, or of what of it can be drawn."""
    context = await browser.new_context(viewport=SIZES[size], color_scheme="light", reduced_motion="reduce")
    await context.add_init_script(path=PROBE)
    context.set_default_timeout(PATIENCE)
    page = await context.new_page()
    await page.goto(f"{base}{name}.html", wait_until="load")
    await page.evaluate("probe.interactive()")
    await page.evaluate(SCROLL)
    for scheme in SCHEMES:
        await page.emulate_media(color_scheme=scheme)
        theme = f"document.documentElement.dataset.theme = {scheme!r}"
        await page.evaluate(theme)  # as the theme's button does
        await page.wait_for_timeout(SETTLED)
        height = await page.evaluate("document.documentElement.scrollHeight")
        whole = {"x": 0, "y": 0, "width": SIZES[size]["width"], "height": min(height, TALLEST)}
        shot = target / picture(name, f"{size}-{scheme}")
        # A tall picture makes the theme slide its sidebar in anew: not to be caught half-way.
        await page.screenshot(path=shot, full_page=True, clip=whole, animations="disabled")
    await context.close()


def picture(name: str, mode: str) -> str:
    """The file with the picture of a page.

    >>> picture("notebooks/family-A", "phone-dark")
    'notebooks-family-A.phone-dark.png'
    """
    return f"{name.replace('/', '-')}.{mode}.png"


async def take_all(site: Path, chapters: list[Chapter], target: Path, workers: int) -> int:
    """All pictures, some at a time; how many."""
    jobs = [(chapter.name, size) for size in SIZES for chapter in chapters]
    queue = iter(jobs)

    async def work(browser: Any, base: str) -> None:
        for name, size in queue:
            await take(browser, base, name, size, target)

    with serve(site) as base:
        async with chromium() as browser:
            await asyncio.gather(*(work(browser, base) for _ in range(workers)))
    return len(jobs) * len(SCHEMES)


def contact_sheet(chapters: list[Chapter]) -> str:
    """All pictures on one page, a row for each page of the book."""

    def shown(name: str, mode: str) -> str:
        file = picture(name, mode)
        return f'<a href="{file}"><img loading="lazy" src="{file}" alt="{name}, {mode}"></a>'

    names = [html.escape(chapter.name) for chapter in chapters]
    rows = [f"<h2>{name}</h2><div>{''.join(shown(name, mode) for mode in MODES)}</div>" for name in names]
    style = (
        "body {font-family: sans-serif; margin: 1rem} div {display: flex; gap: 1rem} a {flex: 3 1 0}"
        " a:nth-child(n + 3) {flex: 1 1 0}"
        " img {border: 1px solid #999; height: 22rem; object-fit: cover; object-position: top; width: 100%}"
    )
    return (
        '<!doctype html><html lang="en"><meta charset="utf-8"><title>Screenshots</title>'
        f"<style>{style}</style>"
        f"<h1>The pages in four modes</h1>{''.join(rows)}</html>\n"
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("site", type=Path, nargs="?", default=ROOT / "_build/html", help="the rendered book")
    parser.add_argument("--toc", type=Path, default=ROOT / "_toc.yml")
    parser.add_argument("--workers", type=int, default=2, help="how many pages at a time")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "_build/screenshots")
    options = parser.parse_args()
    if not find_chromium():
        print(f"No screenshots were taken: {ABSENT}.", file=sys.stderr)
        return 1
    begin = time.time()
    chapters = chapters_of(options.toc)
    options.output.mkdir(parents=True, exist_ok=True)
    number = asyncio.run(take_all(options.site.resolve(), chapters, options.output, options.workers))
    index = options.output / "index.html"
    index.write_text(contact_sheet(chapters), encoding="utf-8")
    print(f"{number} pictures of {len(chapters)} pages in {time.time() - begin:.0f} s: {index}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
