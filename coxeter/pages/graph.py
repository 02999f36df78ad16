"""The dependency graph as a drawing with links, and as a list for those who do not see it."""

from __future__ import annotations

import html
import math
from collections.abc import Iterable, Iterator

from ..figures.canvas import BLUE, GREEN, INK, PURPLE, SMALL, VERMILLION, Canvas, Pen, Point
from ..figures.legends import Key, arrow_key, legend
from ..figures.svg import write_svg
from ..ledger.inventory import PROPOSITIONS
from ..ledger.vocabulary import Extent, Verdict
from .dependencies import PROVE, Dependencies, name_of_node
from .judged import Ledger, gravest
from .layout import NODE, Layout, column, layout
from .listing import section_name
from .naming import Site
from .pills import SIGNS, count, mark, summary
from .wording import to_html, to_plain, type_plain

TONES = {
    Verdict.HOLDS: GREEN,
    Verdict.CORRECTED: "#E69F00",
    Verdict.REPAIRED: BLUE,
    Verdict.FAILS: VERMILLION,
    Verdict.TRANSCRIPTION: "#8A8A8A",
    Verdict.CITED: PURPLE,
    Verdict.OPEN: "#56B4E9",
}
OUTLINES = {
    Extent.EVERY_D: Pen(width=2.2),
    Extent.FINITE: Pen(width=1.1),
    Extent.UP_TO: Pen(width=1.6, dash=(7, 4)),
    Extent.INSTANCES: Pen(width=1.6, dash=(1.5, 3.5)),
    Extent.LITERATURE: Pen(width=1.6, dash=(7, 3, 1.5, 3)),
}
PAPER = "var(--pst-color-background, #fff)"
"""The ground of the page, on which the items hide the arrows behind them."""
ARROWS = {PROVE: Pen(width=1.3, opacity=0.5), "to_state": Pen(width=1.1, dash=(4, 4), opacity=0.42)}
SHORT = {"thm": "Thm", "claim": "Claim"}
"""Kinds of items that are not short for themselves."""


def drawing(ledger: Ledger, site: Site) -> str:
    """The graph as an SVG element with links."""
    graph = Dependencies(ledger)
    place = layout(graph)
    canvas = Canvas()
    wrapped: list[tuple[int, int, str]] = []
    _bands(canvas, place)
    for sources, targets, kind in gathered(graph):
        start = len(canvas.shapes)
        _arrow(canvas, _place(sources, place, foot=True), _place(targets, place, foot=False), ARROWS[kind])
        opening = f'<g class="lg-edge" data-from="{" ".join(sources)}" data-to="{" ".join(targets)}">'
        wrapped.append((start, len(canvas.shapes), opening))
    for node in graph.members:
        start = len(canvas.shapes)
        _item(canvas, node, graph, place.places[node])
        wrapped.append((start, len(canvas.shapes), _opening(node, graph, site)))
    legend(canvas, list(_keys(graph)), 1000)
    canvas.fit(margin=8)
    return _with_links(canvas, wrapped, graph)


def gathered(graph: Dependencies) -> Iterator[tuple[tuple[str, ...], tuple[str, ...], str]]:
    """The arrows, those from or to a whole column of Section 6 as one."""
    whole: dict[str, tuple[str, ...]] = {}
    for node in graph.members:
        if number := column(node):
            whole[number] = (*whole.get(number, ()), node)
    left = dict(graph.shown)
    for nodes in whole.values():
        for other in graph.members:
            for arrows in ([(other, node) for node in nodes], [(node, other) for node in nodes]):
                kinds = {left.get(arrow) for arrow in arrows}
                if len(kinds) == 1 and (kind := kinds.pop()):
                    for arrow in arrows:
                        del left[arrow]
                    yield (nodes, (other,), kind) if arrows[0][0] == nodes[0] else ((other,), nodes, kind)
    for (a, b), kind in left.items():
        yield (a,), (b,), kind


def _place(nodes: tuple[str, ...], place: Layout, foot: bool) -> Point:
    """The middle of an item, or where an arrow from or to a whole column ends."""
    if len(nodes) == 1:
        return place.places[nodes[0]]
    x, top, bottom = place.columns[column(nodes[0])]
    return (x, bottom - NODE[1] / 2) if foot else (x, top + NODE[1] / 2 + 2)


def _with_links(canvas: Canvas, wrapped: list[tuple[int, int, str]], graph: Dependencies) -> str:
    """Put the shapes of each item into a link; `write_svg` writes a line for each shape."""
    words = f"{len(graph.members)} numbered items, {len(graph.shown)} arrows; the list below says the same"
    head, title, *shapes, end = write_svg(canvas, "What rests on what", words, fluid=False).split("\n")
    for start, stop, opening in wrapped:
        shapes[start] = opening + shapes[start]
        shapes[stop - 1] += "</a>" if opening.startswith("<a") else "</g>"
    head = head.replace('role="img"', 'role="group" class="lg-graph"')
    return "\n".join([head, title, *shapes, end])


def _opening(node: str, graph: Dependencies, site: Site) -> str:
    claims = graph.members[node]
    x = gravest(claims)
    name = type_plain(to_plain(name_of_node(node)))
    told = f"{name}: {x.verdict.value}. {summary(claims)}"
    data = {
        "node": node,
        "name": f"{name} {short_name(node)}",
        "verdict": x.verdict.value,
        "strength": x.finding.strength.extent.value,
        **({"claims": count(claims)} if len(claims) > 1 else {}),
    }
    about = "".join(f' data-{key}="{html.escape(value)}"' for key, value in data.items())
    return f'<a href="{site.claim(x.id)}"{about} class="lg-node"><title>{html.escape(told)}</title>'


# -- shapes ------------------------------------------------------------------------------------------------


def _bands(canvas: Canvas, place: Layout) -> None:
    for n, (section, (left, top, right, bottom)) in enumerate(place.bands.items()):
        box = [(left, top), (right, top), (right, bottom), (left, bottom)]
        canvas.polygons([box], INK, 0.05 if n % 2 else 0.015)
        canvas.label((left + 8, top + 14), section_name(section), SMALL, "start", 0.75)
    for number, (x, top, bottom) in place.columns.items():
        left, right = x - NODE[0] / 2 - 6, x + NODE[0] / 2 + 6
        box = [(left, top + 3), (right, top + 3), (right, bottom + 5), (left, bottom + 5)]
        canvas.polygons([box], PAPER, 1.0)
        canvas.polygons([box], INK, 0.03, Pen(width=0.8, opacity=0.35))
        canvas.label((x, top + 19), f"item {number}", SMALL - 2, opacity=0.8)
    for node, (_, y) in place.places.items():
        if node.endswith(".item-9"):
            canvas.label((8, y), _family(node), SMALL + 1, "start")


def _family(node: str) -> str:
    name = node.split(".")[1]
    return rf"$\tilde{{{name[0]}}}_{{{name[1:] or 'd'}}}$"


def _item(canvas: Canvas, node: str, graph: Dependencies, at: Point) -> None:
    x = gravest(graph.members[node])
    outline = _rounded(at)
    pen = OUTLINES[x.finding.strength.extent]
    tone = TONES[x.verdict]
    canvas.polygons([outline], PAPER, 1.0)
    canvas.polygons([outline], tone, 0.28, Pen(tone, pen.width, pen.dash))
    canvas.label(at, f"{SIGNS[x.verdict]} {short_name(node)}", SMALL - 1)


def short_name(node: str) -> str:
    """An item in a few letters; in Section 6 its row and column tell the rest.

    >>> short_name("def-8"), short_name("sec6.B.item-5"), short_name("eq-3"), short_name("sec6.A.item-7")
    ('Def 8', '5', 'Eq 3', '7 · Lem 7')
    """
    if node.startswith("sec6"):
        other = next((name for name, item in PROPOSITIONS.items() if item == node), "")
        return node[-1] + (f" · {short_name(other)}" if other else "")
    kind, _, number = node.partition("-")
    if not number.isdigit() and kind == "tab":
        return number.capitalize()
    return f"{SHORT.get(kind, kind.capitalize())} {number.upper() if len(number) == 1 else number}"


def _rounded(at: Point, radius: float = 6.0) -> list[Point]:
    """A box with round corners around a point."""
    (x, y), (w, h) = at, NODE
    corners = ((1, 1, 0), (-1, 1, 90), (-1, -1, 180), (1, -1, 270))
    return [
        (
            x + sx * (w / 2 - radius) + radius * math.cos(math.radians(start + turn)),
            y + sy * (h / 2 - radius) + radius * math.sin(math.radians(start + turn)),
        )
        for sx, sy, start in corners
        for turn in (0, 30, 60, 90)
    ]


def _arrow(canvas: Canvas, a: Point, b: Point, pen: Pen) -> None:
    """From the lower edge of an item to the upper edge of another; beside or below it, from side to side."""
    (w, h) = NODE
    if abs(a[1] - b[1]) < h:
        side = math.copysign(1, b[0] - a[0])
        start, end = (a[0] + side * w / 2, a[1]), (b[0] - side * w / 2, b[1])
        if abs(b[0] - a[0]) > 1.8 * w:  # over the items between
            start, end = (a[0] + side * w / 4, a[1] - h / 2), (b[0] - side * w / 4, b[1] - h / 2)
            rise = 10 + 0.012 * abs(b[0] - a[0])
            points = [_between(start, end, t, -4 * rise * t * (1 - t)) for t in _STEPS]
        else:
            points = [start, end]
    else:
        down = math.copysign(1, b[1] - a[1])
        start, end = (a[0], a[1] + down * h / 2), (b[0], b[1] - down * h / 2)
        points = [
            (start[0] + (end[0] - start[0]) * _ease(t), start[1] + (end[1] - start[1]) * t) for t in _STEPS
        ]
    canvas.lines([points[:-1]], pen)
    canvas.arrow(points[-2], points[-1], Pen(pen.colour, pen.width, (), pen.opacity))


_STEPS = [n / 12 for n in range(13)]


def _ease(t: float) -> float:
    return t * t * (3 - 2 * t)


def _between(p: Point, q: Point, t: float, lift: float) -> Point:
    return p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]) + lift


def _keys(graph: Dependencies) -> Iterator[Key]:
    found = [gravest(claims) for claims in graph.members.values()]
    for verdict, tone in TONES.items():
        if any(x.verdict is verdict for x in found):
            yield _box_key(f"{SIGNS[verdict]} {verdict.value}", tone, Pen(tone, 1.1))
    for extent, pen in OUTLINES.items():
        if any(x.finding.strength.extent is extent for x in found):
            yield _box_key(extent.value, INK, pen, 0.06)
    yield arrow_key("needed to prove", Pen(width=1.3))
    yield arrow_key("needed to state", Pen(width=1.1, dash=(4, 4)))


def _box_key(words: str, fill: str, pen: Pen, opacity: float = 0.28) -> Key:
    def sample(canvas: Canvas, at: Point) -> None:
        x, y = at
        canvas.polygons([[(x, y + 7), (x + 24, y + 7), (x + 24, y - 7), (x, y - 7)]], fill, opacity, pen)

    return Key(words, sample, 24)


# -- words -------------------------------------------------------------------------------------------------


def in_words(ledger: Ledger, site: Site) -> str:
    """Every item with all that it needs, as a list."""
    graph = Dependencies(ledger)
    rows = "".join(f"<li>{_in_words(node, graph, site)}</li>" for node in graph.members)
    return f'<ul class="lg-list">{rows}</ul>'


def _in_words(node: str, graph: Dependencies, site: Site) -> str:
    x = gravest(graph.members[node])
    text = f'<a href="{site.claim(x.id)}">{to_html(name_of_node(node))}</a> {mark(x)}'
    for kind, words in ((PROVE, "in the paper proved with"), ("to_state", "stated with")):
        needed = [a for (a, b), k in graph.arrows.items() if b == node and k == kind]
        if needed:
            text += f"<br>{words} {_names(needed)}"
    return text


def _names(nodes: Iterable[str]) -> str:
    return "; ".join(to_html(name_of_node(node)) for node in nodes)
