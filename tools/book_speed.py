"""The page *Speed*: what `benchmarks/locate.py` wrote, as sentences, tables and a picture.

``:::{speed} gudhi`` shows a part of ``benchmarks/results.json``; the parts are the functions in `PARTS`. No
number on the page comes from anywhere else.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

from coxeter.figures import Figure
from coxeter.figures.canvas import BLUE, FAINT, FINE, GREEN, PURPLE, SMALL, VERMILLION, Canvas, Pen, Point
from coxeter.figures.legends import legend, line_key
from coxeter.pages import markup
from coxeter.tables.pieces import to_html

RESULTS = Path(__file__).resolve().parents[1] / "benchmarks" / "results.json"
PENS = {"A": Pen(BLUE, 2.2), "B": Pen(VERMILLION, 2.2), "C": Pen(GREEN, 2.2), "D": Pen(PURPLE, 2.2)}
Results = dict[str, Any]


def setup(app: Sphinx) -> dict[str, Any]:
    app.add_directive("speed", SpeedDirective)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


class SpeedDirective(SphinxDirective):
    """One part of the results."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        self.env.note_dependency(str(RESULTS))
        made = PARTS[self.arguments[0]](json.loads(RESULTS.read_text(encoding="utf-8")))
        return [
            nodes.raw("", made, format="html"),
            nodes.raw("", "A table of the book's pages.", format="latex"),
        ]


def machine(found: Results) -> str:
    about, settings = found["machine"], found["settings"]
    names = ", ".join(f"{name} {number}" for name, number in found["versions"].items())
    quick = " It was a quick run, and is rough." if settings["quick"] else ""
    return (
        f"<p>{about['cpu']}, {about['cores']} cores, {about['system']}; {names}; {about['date']}. "
        f"Everything was repeated {settings['repeats']} times, in turn.{quick}</p>"
    )


def against_gudhi(found: Results) -> str:
    rows = [
        (row["d"], *(rate(row, k) for k in ("ours", "numpy", "gudhi")), ratio(row, "gudhi", "ours"),
         ratio(row, "gudhi", "numpy"))
        for row in found["gudhi"]
    ]  # fmt: skip
    head = ("d", "Numba", "NumPy", "GUDHI", "Numba : GUDHI", "NumPy : GUDHI")
    return table("Points a second, beside GUDHI", head, rows)


def families(found: Results) -> str:
    rows = [(r["name"], rate(r, "ours"), rate(r, "A"), ratio(r, "ours", "A")) for r in found["families"]]
    head = ("type", "points a second", "A~ at this d", "time, A~ is 1")
    return table("Points a second, by type", head, rows)


def exponents(found: Results) -> str:
    rows = []
    for family in "ABCD":
        ends = [row for row in found["growth"] if row["family"] == family and row["d"] in (100, 1000)]
        rows.append((f"{family}~", *(f"{exponent(ends, route):.2f}" for route in ("ours", "numpy"))))
    wanted = math.log10(10 * math.log(1000) / math.log(100))
    rows.append(("d log d", f"{wanted:.2f}", f"{wanted:.2f}"))
    return table("Exponents of the dimension", ("family", "Numba", "NumPy"), rows)


def exponent(ends: list[Results], route: str) -> float:
    """The exponent of d between two dimensions."""
    (low, first), (high, last) = ((row["d"], row[route]["median"] / row["points"]) for row in ends)
    return math.log(last / first) / math.log(high / low)


def vertices(found: Results) -> str:
    rows = [
        (r["name"], rate(r, "located"), rate(r, "with_vertices"), ratio(r, "with_vertices", "located"))
        for r in found["vertices"]
    ]
    head = ("type", "points a second", "with vertices", "time, without is 1")
    return table("Points a second, with vertices and without", head, rows)


def patches(found: Results) -> str:
    rows = [
        (r["d"], f"{r['points']:,}", f"{r['cells']:,}",
         rate(r, "ours", "cells"), rate(r, "scipy", "scipy_cells"),
         f"{r['cells'] / r['ours']['median'] / (r['scipy_cells'] / r['scipy']['median']):.1f}")
        for r in found["patches"]
    ]  # fmt: skip
    head = ("d", "points", "simplices", "simplices a second", "SciPy", "ours : SciPy")
    return table("Simplices a second, beside SciPy", head, rows)


def large(found: Results) -> str:
    file, mega = found["file"], 1e6
    held = {how: f"{file[how]['bytes'] / mega:.0f} MB" for how in ("chunks", "whole")}
    took = {how: f"{file[how]['seconds']:.1f} s" for how in ("chunks", "whole")}
    said = (
        f"<p>{to_html(file['name'])}, {file['points']:,} points in a file of "
        f"{file['file_bytes'] / mega:.0f} MB. In chunks of {file['chunk']:,} it took {took['chunks']} and at "
        f"most {held['chunks']} at a time; the points of a chunk and their answers are "
        f"{file['chunk'] * file['bytes_a_point'] / mega:.0f} MB of these. "
        f"All at once it took {took['whole']} and {held['whole']}.</p>"
    )
    if dask := found["dask"]:
        said += (
            f"<p>With Dask, {to_html(dask['name'])}, {dask['points']:,} points in blocks of "
            f"{dask['block']:,}, on {dask['cores']} cores: one worker {dask['one']['median']:.2f} s, "
            f"two workers {dask['two']['median']:.2f} s, "
            f"{ratio(dask, 'one', 'two')} times as fast.</p>"
        )
    return said


def curves(found: Results) -> str:
    return growth_curves(found["growth"])._repr_html_()


def growth_curves(rows: list[Results]) -> Figure[Any]:
    """Time a point against the dimension, both logarithmic; Numba's are drawn through, NumPy's dashed."""
    data = {
        (family, route): [
            (r["d"], 1e6 * r[route]["median"] / r["points"]) for r in rows if r["family"] == family
        ]
        for family in "ABCD"
        for route in ("ours", "numpy")
    }
    words = "; ".join(
        f"{f}~, {'Numba' if route == 'ours' else 'NumPy'}: "
        + ", ".join(f"{y:.3g} at d={d}" for d, y in points)
        for (f, route), points in data.items()
    )
    title = "Microseconds a point against the dimension"
    return Figure(title, f"{title}. {words}.", data, lambda: _draw(data))


def _draw(data: dict[tuple[str, str], list[tuple[int, float]]]) -> Canvas:
    canvas, width, height = Canvas(), 410.0, 290.0
    values = [math.log10(y) for points in data.values() for _, y in points]
    low, high = math.floor(min(values)), math.ceil(max(values))

    def place(d: float, y: float) -> Point:
        return width * (math.log10(d) - 1) / 2, -height * (math.log10(y) - low) / (high - low)

    for power in range(low, high + 1):
        y = place(10, 10.0**power)[1]
        canvas.lines([((0, y), (width, y))], FINE if power == low else FAINT)
        canvas.label((-9, y), f"{10.0**power:g}", SMALL, "end")
    for d in (10, 30, 100, 300, 1000):
        canvas.label((place(d, 10.0**low)[0], 17), str(d), SMALL)
    canvas.label((width / 2, 37), "dimension $d$", SMALL)
    canvas.label((-34, -height - 24), "microseconds a point", SMALL, "start")
    for (family, route), points in data.items():
        pen = PENS[family] if route == "ours" else Pen(PENS[family].colour, 1.6, (6.0, 5.0))
        canvas.lines([[place(*point) for point in points]], pen)
    keys = [line_key(f"$\\tilde{{{family}}}_{{d}}$", pen) for family, pen in PENS.items()]
    legend(canvas, [*keys, line_key("NumPy alone", Pen(BLUE, 1.6, (6.0, 5.0)))], width)
    return canvas.fit(margin=6)


def rate(row: Results, which: str, what: str = "points") -> str:
    """So many a second."""
    return f"{row[what] / row[which]['median']:,.0f}"


def ratio(row: Results, over: str, under: str) -> str:
    return f"{row[over]['median'] / row[under]['median']:.2f}"


def table(label: str, names: Iterable[str], rows: Iterable[tuple[object, ...]]) -> str:
    body = "".join(markup.row(to_html(str(first)), cells) for first, *cells in rows)
    return markup.table("lg-sheet cx-numbers", map(to_html, names), f"<tbody>{body}</tbody>", label)


PARTS: dict[str, Callable[[Results], str]] = {
    "machine": machine, "gudhi": against_gudhi, "families": families, "curves": curves,
    "exponents": exponents, "vertices": vertices, "patches": patches, "large": large,
}  # fmt: skip
