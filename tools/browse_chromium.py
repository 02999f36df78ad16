"""Find the Chromium of this machine, and start it so that it asks nothing of anyone by itself."""

import os
import shutil
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager
from typing import Any

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
ARGUMENTS = [
    "--no-sandbox",  # a container has none to offer
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
    "--disable-gpu",
    "--enable-unsafe-swiftshader",  # the pictures to turn are drawn by software
]
ABSENT = (
    "no Chromium was found: neither $CHROMIUM nor any of " + ", ".join(NAMES) + " on the PATH "
    "(on Debian: apt-get install chromium)"
)


def find_chromium() -> str | None:
    """The path of a Chromium: what $CHROMIUM names, else the first of the usual names on the PATH."""
    asked = os.environ.get("CHROMIUM")
    for name in [asked] if asked else NAMES:
        if path := shutil.which(name):
            return path
    return None


@asynccontextmanager
async def chromium() -> AsyncIterator[Any]:
    """The browser, for many pages at a time."""
    from playwright.async_api import async_playwright

    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=find_chromium(), args=ARGUMENTS)
        try:
            yield browser
        finally:
            await browser.close()


@contextmanager
def one_chromium() -> Iterator[Any]:
    """The browser, for one page after the other."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find_chromium(), args=ARGUMENTS)
        try:
            yield browser
        finally:
            browser.close()
