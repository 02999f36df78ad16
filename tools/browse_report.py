"""The table of what a browser saw on each page."""

import json
from pathlib import Path

from browse_baseline import Baseline
from browse_page import Seen

COLUMNS = ("page", "requests", "errors", "kB", "s", "axe light", "axe dark", "overflow", "other")
COUNTED = ("errors", "axe light", "axe dark", "overflow")


def row(seen: Seen) -> list[str]:
    """The numbers of a page, in the order of the columns."""
    number = {kind: len(seen.found.get(kind, ())) for kind in seen.found}
    rest = sum(count for kind, count in number.items() if kind not in COUNTED)
    axe = [number.get(kind, 0) for kind in ("axe light", "axe dark")]
    numbers = [seen.requests, number.get("errors", 0), f"{seen.kilobytes:.0f}", f"{seen.seconds:.2f}"]
    return [seen.page, *map(str, [*numbers, *axe, number.get("overflow", 0), rest])]


def table(seen: list[Seen]) -> str:
    rows = [list(COLUMNS), *map(row, seen)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = [[f"{cell:<{w}}" if not i else f"{cell:>{w}}" for i, (cell, w) in enumerate(zip(r, widths, strict=True))] for r in rows]
    return "\n".join("  ".join(line) for line in lines)


def faults(seen: list[Seen]) -> list[str]:
    return [f"FAULT {one.page}: {kind}: {text}" for one in seen for kind, texts in one.found.items() for text in texts]


def write(folder: Path, seen: list[Seen], baseline: Baseline) -> None:
    """For machines, and for a note."""
    data = [
        {"page": x.page, "requests": x.requests, "kilobytes": round(x.kilobytes, 1), "seconds": round(x.seconds, 2)}
        | {"found": {kind: texts for kind, texts in x.found.items() if texts}}
        for x in seen
    ]
    (folder / "browser.json").write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    rows = [COLUMNS, ["---"] * len(COLUMNS), *map(row, seen)]
    text = "\n".join(f"| {' | '.join(cells)} |" for cells in rows)
    (folder / "browser.md").write_text(f"{text}\n\n{baseline.used()}\n", encoding="utf-8")
