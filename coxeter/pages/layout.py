"""Where the items stand in the drawing: a band for each section, what is needed above what needs it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from ..figures.canvas import Point
from ..names import FAMILIES
from .dependencies import Dependencies

ORDER = (("1",), ("2",), ("3",), ("A", "4", "B"), ("6",), ("D", "C"), ("5",))
"""Sections so that most arrows lead downwards, some beside each other: appendices near what they prove."""

SHARES = {"A": 0.46, "4": 0.4, "B": 0.14, "D": 0.5, "C": 0.5}
BREADTH, MARGIN = 1080.0, 56.0
NODE, GAP, ROW, HEAD = (86.0, 24.0), 12.0, 50.0, 36.0
SWEEPS = 6

Span = tuple[float, float]
Row = list[str]


@dataclass(frozen=True)
class Layout:
    """Middles of the items, boxes of the sections (left, top, right, bottom), columns of Section 6."""

    places: Mapping[str, Point]
    bands: Mapping[str, tuple[float, float, float, float]]
    columns: Mapping[str, tuple[float, float, float]]
    """By the number of the item: its middle, the top of its head and the foot of its last item."""


def layout(graph: Dependencies) -> Layout:
    """Rows of items: by section, within it by depth, within a row by the middle of their neighbours."""
    rows = {section: _rows(graph, section) for sections in ORDER for section in sections}
    _untangle([(row, span(section)) for section in rows for row in rows[section]], graph)
    places: dict[str, Point] = {}
    bands: dict[str, tuple[float, float, float, float]] = {}
    top = 0.0
    for sections in ORDER:
        tallest = max(len(rows[section]) for section in sections)
        step = ROW if sections != ("6",) else 0.74 * ROW
        head = HEAD if sections != ("6",) else 1.6 * HEAD
        bottom = top + head + tallest * step
        for section in sections:
            left, right = span(section)
            bands[section] = (left if left > MARGIN else 0.0, top, right, bottom)
            for n, row in enumerate(rows[section]):
                y = top + head + (n + 0.3) * step
                places |= {node: (x, y) for node, x in zip(row, _across(row, span(section)), strict=True)}
        top = bottom
    return Layout(places, bands, _columns(places, bands["6"][1] + 0.6 * HEAD))


def column(node: str) -> str:
    """The number of the item of Section 6; empty for others."""
    return node[-1] if node.startswith("sec6") else ""


def _columns(places: Mapping[str, Point], top: float) -> dict[str, tuple[float, float, float]]:
    found: dict[str, tuple[float, float, float]] = {}
    for node, (x, y) in places.items():
        if number := column(node):
            found[number] = (x, top, max(y + NODE[1] / 2, found.get(number, (x, top, 0.0))[2]))
    return found


def span(section: str) -> Span:
    """From where to where the band of a section has its items."""
    left = MARGIN
    for sections in ORDER:
        if section in sections:
            for other in sections[: sections.index(section)]:
                left += SHARES[other] * (BREADTH - MARGIN)
    return left, left + SHARES.get(section, 1.0) * (BREADTH - MARGIN)


def _rows(graph: Dependencies, section: str) -> list[Row]:
    nodes = [node for node in graph.members if graph.section(node) == section]
    if section == "6":
        studies = [[n for n in nodes if n.startswith(f"sec6.{family}.")] for family in FAMILIES]
        return [row for row in studies if row] + list(
            _cut([n for n in nodes if not column(n)], span(section))
        )
    depths = graph.depths(nodes)
    layers = [
        [n for n in nodes if depths[n] == depth] for depth in range(max(depths.values(), default=-1) + 1)
    ]
    return [row for layer in layers for row in _cut(layer, span(section))]


def _cut(row: Row, between: Span) -> Iterator[Row]:
    """A long row in parts of about the same length."""
    most = int((between[1] - between[0] + GAP) // (NODE[0] + GAP))
    parts = -(-len(row) // most)
    for n in range(parts):
        yield row[n * len(row) // parts : (n + 1) * len(row) // parts]


def _across(row: Row, between: Span) -> list[float]:
    """The middles of the items of a row; those of Section 6 stand in columns."""
    left, right = between
    if row and column(row[0]):
        return [left + (right - left) * (int(column(node)) - 0.5) / 9 for node in row]
    step = min((right - left) / max(len(row), 1), 1.6 * (NODE[0] + GAP))
    first = left + (right - left - step * len(row)) / 2
    return [first + step * (n + 0.5) for n in range(len(row))]


def _places(row: Row, between: Span) -> Iterator[tuple[str, float]]:
    return zip(row, _across(row, between), strict=True)


def _untangle(rows: list[tuple[Row, Span]], graph: Dependencies) -> None:
    """Sort each row by the mean place of its items' neighbours, down and up again."""
    neighbours: dict[str, list[str]] = {node: [] for node in graph.members}
    for a, b in graph.shown:
        neighbours[a].append(b)
        neighbours[b].append(a)
    for sweep in range(SWEEPS):
        for row, _ in rows if sweep % 2 == 0 else rows[::-1]:
            x = {node: at for other, where in rows for node, at in _places(other, where)}
            wanted = {node: _mean((x[n] for n in neighbours[node]), x[node]) for node in row}
            if not column(row[0]):
                row.sort(key=wanted.__getitem__)


def _mean(values: Iterable[float], default: float) -> float:
    found = list(values)
    return sum(found) / len(found) if found else default
