"""The commands about meshes: ``mesh`` and ``quality``."""

from __future__ import annotations

import argparse
import json
import warnings
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from ..errors import InvalidInput
from ..location import Grid
from ..meshes import Mesh, QualityReport, mesh_qualities, quality_report, read_mesh, write_mesh
from ..meshes.files import FORMATS, NPZ, check_path
from ..meshes.judging import CHUNK
from ..meshes.reporting import MeasureReport
from ..quality import find_measure
from .common import Answer, integer, words
from .console import progress
from .loading import add_load, measures_of

if TYPE_CHECKING:
    from .common import Commands

BAR = 40
"""The longest bar of a histogram."""
FAULTS = {
    "degenerate": " to rounding, left out below",
    "inverted": ", oriented negatively",
    "doubled": ", with the points of one before",
}
"""What may be wrong with cells, and what is said of it."""
MOST_BINS = 1000
"""More bars than this nobody reads."""


def add_commands(commands: Commands) -> None:
    """Add the commands to a parser."""
    sub = commands.add_parser("mesh", help="write the simplices of a triangulation that meet a box or a ball")
    sub.add_argument("type", help="such as 'A~3'")
    where = sub.add_mutually_exclusive_group(required=True)
    where.add_argument(
        "--box", metavar="NUMBERS", help="lower corner, then upper corner: 2d numbers with commas"
    )
    where.add_argument("--ball", metavar="NUMBERS", help="centre, then radius: d + 1 numbers with commas")
    sub.add_argument(
        "--scale", type=_number, default=1.0, help="factor that enlarges the triangulation (default 1)"
    )
    sub.add_argument("--offset", metavar="NUMBERS", help="where vertex u_0 lies: d numbers (default 0)")
    suffixes = ", ".join([*FORMATS, NPZ])
    sub.add_argument("-o", "--output", required=True, metavar="FILE", help=f"one that ends with {suffixes}")
    sub.add_argument("--quality", action="store_true", help="write the measures of each cell too")
    sub.set_defaults(run=_mesh)

    sub = commands.add_parser("quality", help="all measures over the simplices of mesh files")
    sub.add_argument(
        "files", nargs="+", metavar="FILE", help="a mesh, in any format that meshio reads, or NPZ"
    )
    sub.add_argument("--measure", action="append", metavar="NAME", help="only this one; may be repeated")
    add_load(sub)
    sub.add_argument("--raw", action="store_true", help="do not divide by the regular simplex")
    sub.add_argument("--bins", type=integer, default=10, help="bars of the histograms (default 10)")
    sub.add_argument(
        "--chunk", type=integer, default=CHUNK, help=f"cells looked at together (default {CHUNK})"
    )
    sub.add_argument("--json", action="store_true", help="print a list of JSON objects, one for each file")
    sub.set_defaults(run=_quality)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is no number: give one, such as 0.25") from None


def _counting(show: Callable[[float, str], None], n: int, low: float, high: float) -> Callable[[int], None]:
    """Moves a bar from one share to another while n cells are judged."""
    return lambda done: show(low + (high - low) * done / n, f"{done} of {n} cells judged")


def _numbers(option: str, text: str, expected: int, what: str) -> list[float]:
    text = text.strip()
    try:
        numbers = [float(x) for x in text.split(",")]
    except ValueError:
        raise InvalidInput(f"{option} {text!r} are no numbers: give {what}, with commas between") from None
    if len(numbers) != expected:
        raise InvalidInput(f"{option} {text!r} has {_count(len(numbers), 'number')}: give {expected}, {what}")
    return numbers


def _count(n: int, one: str, more: str = "") -> str:
    return f"{n} {one if n == 1 else more or one + 's'}"


# -- mesh ------------------------------------------------------------------------------------------------


def _mesh(options: argparse.Namespace) -> Answer:
    d = Grid(options.type).dimension
    given = options.offset
    offset = None if given is None else _numbers("--offset", given, d, "the coordinates of u_0")
    grid = Grid(options.type, scale=options.scale, offset=offset)
    check_path(options.output, d)
    with progress() as show, warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        if show:
            show(0, "looking for the simplices")
        mesh = _patch(grid, options)
        report = quality_report(mesh, progress=show and _counting(show, len(mesh), 1 / 3, 2 / 3))
        if options.quality:
            mesh.cell_data.update(mesh_qualities(mesh))
        if show:
            show(2 / 3, f"writing {len(mesh)} cells")
        write_mesh(mesh, options.output)
    rows = [f"{x.measure} {_decimal(x.min)}" for x in report.measures]
    lines = [
        f"{options.output}: {_count(len(mesh), 'simplex', 'simplices')}, {_count(len(mesh.points), 'point')}",
        f"least quality, with 1 for the regular simplex: {', '.join(rows)}",
    ]
    if report.degenerate:
        lines.append(f"{report.degenerate} simplices are flat, so large are the coordinates for floats")
    return Answer("\n".join([*lines, *words(notes)]))


def _patch(grid: Grid, options: argparse.Namespace) -> Mesh:
    d = grid.dimension
    if options.box is not None:
        numbers = _numbers(
            "--box", options.box, 2 * d, f"{d} of the lower corner and {d} of the upper corner"
        )
        return grid.patch_in_box(numbers[:d], numbers[d:], oriented=True)
    *centre, radius = _numbers("--ball", options.ball, d + 1, f"{d} of the centre and the radius")
    return grid.patch_in_ball(centre, radius, oriented=True)


# -- quality ---------------------------------------------------------------------------------------------


def _quality(options: argparse.Namespace) -> Answer:
    with measures_of(options.load):
        for name in options.measure or ():
            find_measure(name)  # before a long file is read
        reports = [(name, *_judged(name, options)) for name in options.files]
    if options.json:
        data = [{"file": name, "notes": notes, **report.data()} for name, report, notes in reports]
        return Answer(json.dumps(data, indent=1, ensure_ascii=False))
    return Answer("\n\n".join("\n".join(_sheet(*x, not options.raw)) for x in reports))


def _judged(name: str, options: argparse.Namespace) -> tuple[QualityReport, list[str]]:
    if options.bins > MOST_BINS:
        raise InvalidInput(f"{options.bins} bars are too many to read: give {MOST_BINS} or fewer")
    with progress() as show, warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        if show:
            show(0, f"reading {name}")
        mesh = read_mesh(name)
        tell = show and _counting(show, len(mesh), 0, 1)
        try:
            report = quality_report(mesh, options.measure, not options.raw, options.bins, options.chunk, tell)
        except InvalidInput as error:
            raise InvalidInput(f"{name}: {error}") from error
    return report, words(notes)


def _sheet(name: str, report: QualityReport, notes: list[str], normalised: bool) -> Iterator[str]:
    d = report.dimension
    kinds = {2: ("triangle", "triangles"), 3: ("tetrahedron", "tetrahedra")}
    kind = kinds.get(d, (f"simplex of dimension {d}", f"simplices of dimension {d}"))
    yield f"{name}: {_count(report.cells, *kind)}"
    yield from notes
    none = []
    for name, what in FAULTS.items():
        number, first = getattr(report, name), getattr(report, f"{name}_cells")
        if number:
            more = ", ..." if number > len(first) else ""
            yield f"{number} {name}{what}: {', '.join(map(str, first))}{more}"
        elif number == 0:
            none.append(f"none {name}")
    if none:
        yield ", ".join(none)
    if report.cells > report.degenerate:
        yield f"rounding of lengths, heights and volumes: at most {report.error:.1g} of them"
    yield "1 is the regular simplex; larger is better" if normalised else "raw values"
    yield ""
    yield from _table(report.measures)
    for name, why in report.left_out.items():
        yield f"{name} is left out: {why}"
    for x in report.measures:
        if x.counts:
            yield from ("", x.measure, *_histogram(x))


def _table(measures: list[MeasureReport]) -> Iterator[str]:
    header = ["measure", "min", "5%", "median", "mean", "95%", "max", "worst cell"]
    rows = [header]
    for x in measures:
        numbers = (x.min, x.quantiles.get("0.05"), x.median, x.mean, x.quantiles.get("0.95"), x.max)
        undefined = f" ({x.undefined} without a value)" if x.undefined else ""
        rows.append(
            [x.measure, *map(_decimal, numbers), ("-" if x.worst is None else str(x.worst)) + undefined]
        )
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()


def _histogram(x: MeasureReport) -> Iterator[str]:
    """The bars from the first to the last that is not empty."""
    filled = [i for i, n in enumerate(x.counts) if n]
    most = max(x.counts)
    for i in range(filled[0], filled[-1] + 1):
        bar = "█" * -(-BAR * x.counts[i] // most)
        ends = f"{_decimal(x.edges[i]):>9} … {_decimal(x.edges[i + 1]):<9}"
        yield " ".join(filter(None, (ends, bar, str(x.counts[i]))))


def _decimal(value: Any) -> str:
    """Three digits after the point; of a number that would lose all, or is too long, its first three."""
    if value is None:
        return "-"
    return f"{value:.3f}" if value == 0 or 0.0005 <= abs(value) < 1e5 else f"{value:.2e}"
