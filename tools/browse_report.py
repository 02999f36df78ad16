"""The table of what a browser saw on each page."""

import json
from pathlib import Path

from browse_baseline import Baseline
from browse_page import Seen

COLUMNS = ("page", "requests", "errors", "kB", "s", "axe light", "axe dark", "overflow", "other")
SHOWN = 5  # faults of a kind on a page
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
    lines = [[f"{name:<{widths[0]}}", *map(str.rjust, numbers, widths[1:])] for name, *numbers in rows]
    return "\n".join("  ".join(line) for line in lines)


def faults(seen: list[Seen]) -> list[str]:
    """A line for each fault; of a kind that a page has often, the first ones and how many more."""
    lines = []
    for one in seen:
        for kind, texts in one.found.items():
            lines += [f"FAULT {one.page}: {kind}: {text}" for text in texts[:SHOWN]]
            if len(texts) > SHOWN:
                lines.append(f"FAULT {one.page}: {kind}: and {len(texts) - SHOWN} more")
    return lines


def write(folder: Path, seen: list[Seen], baseline: Baseline) -> None:
    """For machines, and for a note."""
    data = [
        {
            "page": x.page,
            "requests": x.requests,
            "kilobytes": round(x.kilobytes, 1),
            "seconds": round(x.seconds, 2),
        }
        | {"found": {kind: texts for kind, texts in x.found.items() if texts}}
        for x in seen
    ]
    (folder / "browser.json").write_text(
        json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8"
    )
    rows = [COLUMNS, ["---"] * len(COLUMNS), *map(row, seen)]
    text = "\n".join(f"| {' | '.join(cells)} |" for cells in rows)
    (folder / "browser.md").write_text(f"{text}\n\n{baseline.used()}\n", encoding="utf-8")
