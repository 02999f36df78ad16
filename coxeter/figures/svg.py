"""A canvas as SVG: no identifiers, no style sheet, nothing that could touch the page around it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from xml.sax.saxutils import escape, quoteattr

from .canvas import Canvas, Disc, Label, Path, Pen, Point, Shape
from .labels import SCRIPT_SIZE, Run, runs, width

NAMESPACE = "http://www.w3.org/2000/svg"
WORDS = "Arial, 'Liberation Sans', Helvetica, sans-serif"
_AMONG_WORDS = 1.15  # letters with serifs look smaller than those without
FORMULAS = "'STIX Two Text', 'Times New Roman', 'Liberation Serif', serif"


def write_svg(canvas: Canvas, title: str, description: str, fluid: bool) -> str:
    """The canvas as an SVG element.

    Parameters
    ----------
    canvas
        What is drawn.
    title
        A few words, shown when a pointer rests on the figure.
    description
        The alternative text.
    fluid
        Whether the figure shrinks with a narrow page; if not, it has its own size.
    """
    w, h = _number(canvas.width), _number(canvas.height)
    style = f' style="width:100%;max-width:{w}px;height:auto"' if fluid else ""
    head = (
        f'<svg xmlns="{NAMESPACE}" viewBox="0 0 {w} {h}" width="{w}" height="{h}"{style} role="img" '
        f'aria-label={quoteattr(description)} font-family={quoteattr(WORDS)} fill="none" '
        f'stroke-linejoin="round" stroke-linecap="round">'
    )
    return "\n".join([head, f"<title>{escape(title)}</title>", *map(_shape, canvas.shapes), "</svg>"])


def _number(x: float) -> str:
    text = f"{x:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _point(point: Point) -> str:
    return f"{_number(point[0])} {_number(point[1])}"


def _shape(shape: Shape) -> str:
    if isinstance(shape, Label):
        return _label(shape)
    if isinstance(shape, Disc):
        x, y = shape.centre
        where = f'<circle cx="{_number(x)}" cy="{_number(y)}" r="{_number(shape.radius)}"'
    else:
        where = f'<path d="{_outline(shape)}"'
    return f"{where}{_pen(shape.pen)}{_fill(shape)}/>"


def _outline(path: Path) -> str:
    end = "Z" if path.closed else ""
    return "".join("M" + "L".join(map(_point, line)) + end for line in path.lines)


def _pen(pen: Pen | None) -> str:
    if pen is None:
        return ""
    text = f' stroke="{pen.colour}" stroke-width="{_number(pen.width)}"'
    if pen.dash:
        text += f' stroke-dasharray="{" ".join(map(_number, pen.dash))}"'
    return text + (f' stroke-opacity="{_number(pen.opacity)}"' if pen.opacity < 1 else "")


def _fill(shape: Path | Disc) -> str:
    if shape.fill is None:
        return ""
    opacity = f' fill-opacity="{_number(shape.fill_opacity)}"' if shape.fill_opacity < 1 else ""
    return f' fill="{shape.fill}"{opacity}'


def _label(label: Label) -> str:
    """The label as text; a letter with an accent has a place of its own, so that both meet in any font."""
    parts, written = runs(label.text), []
    if not any(run.accent for run in parts):
        return _text(label, label.at[0], parts, label.anchor)
    x = label.box[0]
    for accented, group in groupby(parts, key=lambda run: bool(run.accent)):
        for piece in ([run] for run in group) if accented else [list(group)]:
            advance = width(piece, label.size)
            if accented:
                middle = x + advance / 2
                written += [_text(label, middle, piece, "middle"), _accent(label, middle, piece[0])]
            else:
                written.append(_text(label, x, piece, "start"))
            x += advance
    return "".join(written)


def _text(label: Label, x: float, parts: Sequence[Run], anchor: str) -> str:
    where = f'x="{_number(x)}" y="{_number(label.at[1])}" font-size="{_number(label.size)}"'
    where += "" if anchor == "start" else f' text-anchor="{anchor}"'
    opacity = f' fill-opacity="{_number(label.opacity)}"' if label.opacity < 1 else ""
    return f'<text {where} fill="currentColor"{opacity}>{"".join(_spans(parts, label.size))}</text>'


def _accent(label: Label, x: float, run: Run) -> str:
    """A tilde or a hat above a slanted letter."""
    em, tall = label.size, run.letters.isupper()
    x, y = x + (0.13 if tall else 0.05) * em, label.at[1] - (0.82 if tall else 0.6) * em
    command, steps = _ACCENTS[run.accent]
    d = f"M{_point((x - 0.2 * em, y + 0.04 * em))}{command}"
    d += " ".join(_point((em * dx, em * dy)) for dx, dy in steps)
    return f'<path d="{d}" stroke="currentColor" stroke-width="{_number(0.07 * em)}"/>'


_ACCENTS = {
    "~": ("c", ((0.1, -0.22), (0.3, 0.14), (0.4, -0.08))),
    "^": ("l", ((0.2, -0.12), (0.2, 0.12))),
}
"""Accents as SVG path commands, from their left ends on."""


def _spans(parts: Sequence[Run], size: float) -> Iterator[str]:
    """The runs, each moved up or down from where the last one ended."""
    height = {0: 0.0, 1: 0.36 * size, -1: -0.24 * size}
    level, among_words = 0, 1.0 if all(run.math for run in parts) else _AMONG_WORDS
    for previous, run in zip([None, *parts], parts, strict=False):
        attributes = f' font-family="{FORMULAS}"' if run.math else ""
        attributes += ' font-style="italic"' if run.italic else ""
        scale = (SCRIPT_SIZE if run.level else 1.0) * (among_words if run.math else 1.0)
        if scale != 1:
            attributes += f' font-size="{_number(scale * size)}"'
        if previous and previous.level * run.level < 0:  # one above the other
            attributes += f' dx="{_number(-width([previous], size))}"'
        if run.level != level:
            attributes += f' dy="{_number(height[level] - height[run.level])}"'
            level = run.level
        yield f"<tspan{attributes}>{escape(run.letters)}</tspan>" if attributes else escape(run.letters)
