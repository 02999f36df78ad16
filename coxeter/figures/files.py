"""A canvas as a PDF or PNG file, painted with Matplotlib: in black, for paper."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from .canvas import INK, Canvas, Disc, Label, Path, Pen

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_PIXELS_PER_INCH = 72
_SETTINGS: dict[Any, Any] = {
    "mathtext.fontset": "stix",
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "pdf.fonttype": 42,
    "lines.scale_dashes": False,
}


def save_with_matplotlib(canvas: Canvas, path: str | os.PathLike[str]) -> None:
    """Write a PDF or PNG file; the same canvas gives the same bytes."""
    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_SETTINGS)
        sheet = Figure(figsize=(canvas.width / _PIXELS_PER_INCH, canvas.height / _PIXELS_PER_INCH))
        axes = sheet.add_axes((0, 0, 1, 1))
        axes.set_axis_off()
        axes.set_xlim(0, canvas.width)
        axes.set_ylim(canvas.height, 0)
        _paint(axes, canvas)
        dates = {"CreationDate": None} if str(path).lower().endswith(".pdf") else {"Software": None}
        sheet.savefig(path, dpi=3 * _PIXELS_PER_INCH, metadata=dates)


def _paint(axes: Axes, canvas: Canvas) -> None:
    from matplotlib.patches import Circle, PathPatch
    from matplotlib.path import Path as Outline

    for order, shape in enumerate(canvas.shapes):
        if isinstance(shape, Label):
            axes.text(
                *shape.at,
                shape.text,
                size=shape.size,
                ha={"start": "left", "middle": "center", "end": "right"}[shape.anchor],
                va="baseline",
                alpha=shape.opacity,
                zorder=order,
            )
        elif isinstance(shape, Disc):
            axes.add_patch(Circle(shape.centre, shape.radius, zorder=order, **_look(shape)))
        else:
            pieces = [Outline(line, closed=False) for line in shape.lines]
            if shape.closed:
                pieces = [Outline([*line, line[0]], closed=True) for line in shape.lines]
            outline = Outline.make_compound_path(*pieces)
            axes.add_patch(PathPatch(outline, zorder=order, joinstyle="round", **_look(shape)))


def _look(shape: Path | Disc) -> dict[str, Any]:
    """Matplotlib's words for a pen and a fill."""
    pen = shape.pen or Pen(width=0)
    return {
        "facecolor": (_colour(shape.fill), shape.fill_opacity) if shape.fill else "none",
        "edgecolor": (_colour(pen.colour), pen.opacity) if shape.pen else "none",
        "linewidth": pen.width,
        "linestyle": (0, pen.dash) if pen.dash else "solid",
        "capstyle": "round",
    }


def _colour(name: str) -> str:
    return "black" if name == INK else name
