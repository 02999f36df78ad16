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
    """Opens pages of a site, from its server and from the file system."""

    browser: Any
    folder: Path
    base: str

    async def visit(self, page: str, full: bool = True, axe: bool = True, press: bool = False) -> Seen:
        """Everything about a page; of one of many alike, where ``full`` is false, what may differ."""
        seen = Seen(page)
        await self._wide(seen, full, axe, press)
        await self._phone(seen, full)
        return seen

    async def _wide(self, seen: Seen, full: bool, axe: bool, press: bool) -> None:
        """From the server, on a wide screen, in the light; then in the dark."""
        async with Opened(self, seen, self.base, WIDE, "light") as opened:
            seen.seconds = await opened.interactive()
            self._weigh(seen, opened.addresses)
            if full:
                seen.note("formulas", await opened.ask("formulas()"))
                seen.note("alternatives", await opened.ask("alternatives()"))
                seen.note("keyboard", await opened.ask("keyboard()"))
            if press:
                seen.note("keyboard", await press_tab(opened.page))
            if axe:
                await opened.page.evaluate(axe_script())
                await opened.page.evaluate("probe.thin()")
                seen.note("axe light", await opened.ask("axe()"))
                await opened.page.emulate_media(color_scheme="dark")
                await opened.page.evaluate("probe.dark()")
                seen.note("axe dark", await opened.ask("axe", COLOURS))

    async def _phone(self, seen: Seen, full: bool) -> None:
        """From the file system, on a phone, in the dark."""
        async with Opened(self, seen, self.folder.as_uri() + "/", PHONE, "dark") as opened:
            await opened.interactive()
            seen.note("overflow", await opened.ask("overflow()"))
            if full:
                seen.note("formulas", await opened.ask("sampled()"))

    async def time(self, page: str) -> float:
        """Seconds until a page can be used."""
        async with Opened(self, Seen(page), self.base, WIDE, "light") as opened:
            return await opened.interactive()

    def _weigh(self, seen: Seen, addresses: set[str]) -> None:
        local = [address for address in addresses if address.startswith(self.base)]
        files = {file_of(address, self.base, self.folder) for address in local}
        seen.requests = len(addresses)
        seen.kilobytes = sum(weight(path) for path in files if path.name != PLOTTING) / 1000
        if seen.kilobytes > KILOBYTES:
            heavy = sorted(files, key=weight, reverse=True)[:3]
            names = ", ".join(f"{path.name} {weight(path) / 1000:.0f} kB" for path in heavy)
            seen.note("weight", [f"{seen.kilobytes:.0f} kB of at most {KILOBYTES:.0f}: {names}, …"])
        plotted = PLOTTED.search((self.folder / seen.page).read_text(encoding="utf-8"))
        if any(path.name == PLOTTING for path in files) and not plotted:
            seen.note("weight", [f"{PLOTTING} is loaded where nothing is drawn with it"])


class Opened:
    """A page in a window of its own, with an ear for what goes wrong."""

    def __init__(self, visitor: Visitor, seen: Seen, base: str, size: dict[str, int], scheme: str) -> None:
        self.visitor, self.seen, self.base = visitor, seen, base
        self.options = {"viewport": size, "color_scheme": scheme, "reduced_motion": "reduce"}
        self.addresses: set[str] = set()

    async def __aenter__(self) -> "Opened":
        self.context = await self.visitor.browser.new_context(**self.options)
        await self.context.add_init_script(path=PROBE)
        self.page = await self.context.new_page()
        self.page.on("request", lambda request: self._request(request.url))
        self.page.on("requestfailed", lambda request: self._error(f"not loaded: {request.url}"))
        self.page.on("response", lambda it: it.status >= 400 and self._error(f"{it.status}: {it.url}"))
        self.page.on("pageerror", lambda error: self._error(f"script: {error}"))
        self.page.on("console", lambda line: line.type == "error" and self._error(f"console: {line.text}"))
        await self.page.goto(self.base + self.seen.page, wait_until="load")
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.context.close()

    async def interactive(self) -> float:
        return float(await self.page.evaluate("probe.interactive()")) / 1000

    async def ask(self, what: str, argument: object = None) -> list[str]:
        call = f"probe.{what}" if what.endswith(")") else f"x => probe.{what}(x)"
        return list(await self.page.evaluate(call, argument))

    def _request(self, address: str) -> None:
        self.addresses.add(address)
        if not is_local(address, self.base):
            self.seen.note("other hosts", [address])

    def _error(self, text: str) -> None:
        self.seen.note("errors", [text.replace(self.base, "").splitlines()[0][:200]])


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
