"""Open one page of the book in a browser, as readers do, and note what they would run into."""

import re
from collections import defaultdict
from dataclasses import dataclass, field
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from browse_server import file_of, is_local, weight

PROBE = Path(__file__).with_name("browse_probe.js")
WIDE, PHONE = {"width": 1366, "height": 900}, {"width": 375, "height": 812}
SECONDS, KILOBYTES = 3.0, 1500.0
PLOTTING = "plotly.min.js"
PLOTTED = re.compile(r'class="[^"]*\bcx-(?:scene|explorer)\b')
COLOURS = ["color-contrast", "link-in-text-block"]  # the rules whose verdict differs in the dark
TABS = 90  # how often Tab is pressed at most
PATIENCE = 240_000  # milliseconds that a page may take, with all that is asked of it
UNSET = 15_000  # milliseconds that a formula in view may take


@dataclass
class Seen:
    """What was seen on a page: its findings by kind, and its numbers."""

    page: str
    found: dict[str, list[str]] = field(default_factory=lambda: defaultdict(list))
    requests: int = 0
    kilobytes: float = 0.0
    seconds: float = 0.0

    def note(self, kind: str, findings: list[str]) -> None:
        known = self.found[kind]
        known += [text for text in dict.fromkeys(findings) if text not in known]


@cache
def axe_script() -> str:
    package = find_spec("axe_playwright_python")
    if package is None or package.origin is None:
        raise RuntimeError("axe-playwright-python is not installed: run make setup")
    return (Path(package.origin).parent / "axe.min.js").read_text(encoding="utf-8")


@dataclass
class Visitor:
    """Opens pages of a site, one after the other, in two windows: a wide one and a phone's."""

    folder: Path
    wide: "Window"
    phone: "Window"

    async def visit(self, page: str, full: bool = True, axe: bool = True, press: bool = False) -> Seen:
        """Everything about a page; of one of many alike, where ``full`` is false, what may differ."""
        seen = Seen(page)
        await self._wide(seen, full, press)
        if axe:
            await self._axe(seen)
        await self._phone(seen, full)
        return seen

    async def _wide(self, seen: Seen, full: bool, press: bool) -> None:
        """From the server, on a wide screen, in the light."""
        window = self.wide
        seen.seconds = await window.open(seen)
        self._weigh(seen)
        if full:
            await window.page.evaluate("dispatchEvent(new Event('beforeprint'))")  # all that is open is set
            seen.note("formulas", await window.ask("formulas()"))
            seen.note("alternatives", await window.ask("alternatives()"))
            seen.note("keyboard", await window.ask("keyboard()"))
        if press:
            seen.note("keyboard", await press_tab(window.page))

    async def _axe(self, seen: Seen) -> None:
        """In the light; then what may differ in the dark."""
        window = self.wide
        await window.page.evaluate(axe_script())
        await window.page.evaluate("probe.thin()")
        seen.note("axe light", await window.ask("axe()"))
        await window.page.emulate_media(color_scheme="dark")
        await window.page.evaluate("probe.thinner(), probe.dark()")
        seen.note("axe dark", await window.ask("axe", COLOURS))
        await window.page.emulate_media(color_scheme="light")

    async def _phone(self, seen: Seen, full: bool) -> None:
        """From the file system, on a phone, in the dark."""
        await self.phone.open(seen)
        if full:
            seen.note("formulas", await self.phone.ask("sampled", UNSET))
            await self.phone.page.evaluate("probe.unfold()")
        seen.note("overflow", await self.phone.ask("overflow()"))

    async def time(self, page: str) -> float:
        """Seconds until a page can be used."""
        return await self.wide.open(Seen(page))

    def _weigh(self, seen: Seen) -> None:
        window = self.wide
        local = [address for address in window.addresses if address.startswith(window.base)]
        files = {file_of(address, window.base, self.folder) for address in local}
        seen.requests = len(window.addresses)
        seen.kilobytes = sum(weight(path) for path in files if path.name != PLOTTING) / 1000
        if seen.kilobytes > KILOBYTES:
            heavy = sorted(files, key=weight, reverse=True)[:3]
            names = ", ".join(f"{path.name} {weight(path) / 1000:.0f} kB" for path in heavy)
            seen.note("weight", [f"{seen.kilobytes:.0f} kB of at most {KILOBYTES:.0f}: {names}, …"])
        plotted = PLOTTED.search((self.folder / seen.page).read_text(encoding="utf-8"))
        if any(path.name == PLOTTING for path in files) and not plotted:
            seen.note("weight", [f"{PLOTTING} is loaded where nothing is drawn with it"])


class Window:
    """A window of the browser, with an ear for what goes wrong. Each page is loaded anew."""

    def __init__(self, base: str) -> None:
        self.base = base
        self.seen = Seen("")
        self.addresses: set[str] = set()

    @classmethod
    async def new(cls, browser: Any, base: str, size: dict[str, int], scheme: str) -> "Window":
        window = cls(base)
        context = await browser.new_context(viewport=size, color_scheme=scheme, reduced_motion="reduce")
        await context.add_init_script(path=PROBE)
        context.set_default_timeout(PATIENCE)
        window.page = page = await context.new_page()
        session = await context.new_cdp_session(page)
        await session.send("Network.enable")
        await session.send("Network.setCacheDisabled", {"cacheDisabled": True})
        page.on("request", lambda request: window._request(request.url))
        page.on("requestfailed", lambda request: window._error(f"not loaded: {request.url}"))
        page.on("response", lambda it: it.status >= 400 and window._error(f"{it.status}: {it.url}"))
        page.on("pageerror", lambda error: window._error(f"script: {error}"))
        page.on("console", lambda line: line.type == "error" and window._error(f"console: {line.text}"))
        return window

    async def open(self, seen: Seen) -> float:
        """Open a page; the seconds until its formulas are set and it waits for the reader."""
        await self.page.goto("about:blank")
        self.seen, self.addresses = seen, set()
        await self.page.goto(self.base + seen.page, wait_until="load")
        return float(await self.page.evaluate("probe.interactive()")) / 1000

    async def ask(self, what: str, argument: object = None) -> list[str]:
        call = f"probe.{what}" if what.endswith(")") else f"x => probe.{what}(x)"
        return list(await self.page.evaluate(call, argument))

    def _request(self, address: str) -> None:
        if address != "about:blank":
            self.addresses.add(address)
        if not is_local(address, self.base):
            self.seen.note("other hosts", [address])

    def _error(self, text: str) -> None:
        self.seen.note("errors", [text.replace(self.base, "").splitlines()[0][:200]])


async def visitor(browser: Any, folder: Path, base: str) -> Visitor:
    """One who opens the pages of a folder, that is served at an address."""
    wide = await Window.new(browser, base, WIDE, "light")
    return Visitor(folder, wide, await Window.new(browser, folder.as_uri() + "/", PHONE, "dark"))


async def press_tab(page: Any) -> list[str]:
    """Walk through a page with the Tab key: every stop is seen, and the walk does not stick."""
    expected = await page.evaluate("probe.tabbable()")
    stops: list[str] = []
    found = []
    for _ in range(min(expected, TABS)):
        await page.keyboard.press("Tab")
        stop = await page.evaluate("probe.focused()")
        if stop is None:
            break  # the page's end
        mark, place, visible = stop
        if mark in stops:
            found.append(f"Tab comes back to {place} after {len(stops)} stops of {expected}")
            break
        stops.append(mark)
        if not visible:
            found.append(f"Tab stops at what is not to be seen: {place}")
    if len(stops) < min(expected, TABS) * 0.8 and not found:
        found.append(f"Tab reaches {len(stops)} places of {expected}")
    return found
