"""Open every page of the rendered book in a headless Chromium, and say what a reader would run into.

From a server on this machine and from the file system; on a wide screen and on a phone; in light and dark.
Chapters and prose get every check. Pages of source code, all of one make, get those whose answer may differ.
"""

import argparse
import asyncio
import sys
import time
from pathlib import Path

import browse_page
from browse_baseline import Baseline
from browse_chromium import ABSENT, chromium, find_chromium
from browse_page import SECONDS, Seen, Visitor, visitor
from browse_report import faults, table, write
from browse_server import serve
from playwright.async_api import Error as PlaywrightError

ALIKE = ("_modules/", "checks/")
AXED = 10  # of the pages alike, every so many-th is given to axe
PRESSED = ("index.html", "notebooks/section-3.html", "search.html", "cx-", "lg-controls", "lg-graph")


def pages_of(folder: Path) -> list[str]:
    """All pages of a site, the largest first, so that no worker ends late; templates are no pages."""
    paths = [path for path in folder.rglob("*.html") if folder / "_static" not in path.parents]
    sized = sorted(paths, key=lambda path: path.stat().st_size, reverse=True)
    return [path.relative_to(folder).as_posix() for path in sized]


def presses(folder: Path, page: str) -> bool:
    """Whether Tab is really pressed: where there is much to operate, and on a page of each other make."""
    body = (folder / page).read_text(encoding="utf-8")
    return page in PRESSED or any(f'class="{mark}' in body for mark in PRESSED)


async def browse(folder: Path, workers: int, only: list[str] | None = None) -> list[Seen]:
    """What is seen on every page of a folder, in the order of their names."""
    names = only or pages_of(folder)
    alike = [name for name in sorted(names) if name.startswith(ALIKE)]
    seen: list[Seen] = []
    queue = iter(names)

    async def work(one: Visitor) -> None:
        for name in queue:
            full = name not in alike
            axe = full or alike.index(name) % AXED == 0
            begin = time.time()
            visit = one.visit(name, full, axe, full and presses(folder, name))
            try:
                seen.append(await asyncio.wait_for(visit, browse_page.PATIENCE / 1000))
            except (TimeoutError, PlaywrightError) as error:  # it hangs, or takes its window with it
                seen.append(Seen(name))
                seen[-1].note("errors", [f"could not be looked at: {type(error).__name__} {error}"])
                one = await visitor(one.wide.page.context.browser, folder, one.wide.base)
            print(f"  {len(seen):3}/{len(names)}  {time.time() - begin:5.1f} s  {name}", flush=True)

    with serve(folder) as base:
        async with chromium() as browser:
            visitors = [await visitor(browser, folder, base) for _ in range(workers)]
            await asyncio.gather(*map(work, visitors))
            await measure_again(await visitor(browser, folder, base), seen)
    return sorted(seen, key=lambda one: one.page)


async def measure_again(visitor: Visitor, seen: list[Seen]) -> None:
    """Two pages at a time slow each other down: one that seemed slow is timed once more, alone."""
    for one in seen:
        if one.seconds > SECONDS:
            one.seconds = min(one.seconds, await visitor.time(one.page))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("site", type=Path, help="the folder of the rendered book")
    parser.add_argument("pages", nargs="*", help="some pages only, as notebooks/section-1.html")
    parser.add_argument("--workers", type=int, default=2, help="how many pages at a time")
    parser.add_argument("--factor", type=float, default=1.0, help="patience with a slow or busy machine")
    parser.add_argument("--report", type=Path, help="where to write browser.json and .md; beside the site")
    options = parser.parse_args()
    if not find_chromium():
        print(f"SKIPPED the book in a browser: {ABSENT}")
        return 0
    begin = time.time()
    folder = options.site.resolve()
    seen = asyncio.run(browse(folder, options.workers, options.pages))
    baseline = Baseline()
    for one in seen:
        if one.seconds > SECONDS * options.factor:
            one.note("time", [f"{one.seconds:.1f} s of at most {SECONDS * options.factor:g}"])
        baseline.excuse(one)
    print(table(seen))
    print(baseline.used())
    found = faults(seen)
    print("\n".join(found))
    write(options.report or folder.parent, seen, baseline)
    print(f"{len(seen)} pages, {len(found)} faults, {time.time() - begin:.0f} s")
    return bool(found or not seen)


if __name__ == "__main__":
    sys.exit(main())
