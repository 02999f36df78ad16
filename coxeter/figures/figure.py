"""What a figure is: the data that it shows, a drawing of them, and words for those who cannot see it."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Generic, TypeVar

from ..errors import InvalidInput
from .canvas import Canvas, one_above_another, side_by_side
from .svg import write_svg

Data = TypeVar("Data", covariant=True)

_ROW = (
    "display:flex;flex-wrap:wrap;justify-content:center;align-items:flex-start;gap:1rem 1.75rem;margin:1rem 0"
)


@dataclass(frozen=True, repr=False)
class Figure(Generic[Data]):
    """A figure; a notebook shows it, `save` writes it to a file.

    Attributes
    ----------
    title
        A few words: what is drawn.
    alt
        The alternative text, made from the data.
    data
        The exact values that are plotted.
    parts
        The figures in a row that make up this one, if it is a row. A page that is too narrow for
        the row shows them one below the other.
    rows
        The rows that make up this one, if it has several.
    """

    title: str
    alt: str
    data: Data
    draw: Callable[[], Canvas] = field(compare=False)
    parts: tuple[Figure[object], ...] = ()
    rows: tuple[Figure[object], ...] = ()

    @cached_property
    def svg(self) -> str:
        """The figure as an SVG element, in the colour of the text around it, on no background."""
        return write_svg(self._canvas, self.title, self.alt, fluid=True)

    @cached_property
    def _canvas(self) -> Canvas:
        return self.draw()

    def __repr__(self) -> str:
        return self.alt

    def _repr_html_(self) -> str:
        if self.rows:
            return "\n".join(row._repr_html_() for row in self.rows)
        drawings = "\n".join(part.svg for part in self.parts or (self,))
        return f'<figure style="{_ROW}">\n{drawings}\n</figure>'

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the figure to a file: SVG, PDF or PNG, by the end of its name.

        Raises
        ------
        InvalidInput
            If the name ends in none of these.
        """
        suffix = Path(path).suffix.lower()
        if suffix == ".svg":
            Path(path).write_text(write_svg(self._canvas, self.title, self.alt, fluid=False) + "\n", "utf-8")
        elif suffix in (".pdf", ".png"):
            from .files import save_with_matplotlib

            save_with_matplotlib(self._canvas, path)
        else:
            raise InvalidInput(f"{str(path)!r} does not name a figure: it must end in .svg, .pdf or .png")


def beside(*figures: Figure[Data], title: str = "", alt: str = "") -> Figure[tuple[Data, ...]]:
    """One figure made of several in a row; their titles and texts are joined if none are given.

    >>> from coxeter.figures import coxeter_diagram
    >>> beside(coxeter_diagram("A2"), coxeter_diagram("G2")).title
    'Coxeter diagram of A2; Coxeter diagram of G2'
    """
    if not figures:
        raise InvalidInput("a row needs at least one figure")
    parts: Sequence[Figure[Data]] = figures
    return Figure(
        title or "; ".join(part.title for part in parts),
        alt or " ".join(part.alt for part in parts),
        tuple(part.data for part in parts),
        lambda: side_by_side([part.draw() for part in parts]),
        tuple(parts),
    )


def headed(figure: Figure[Data], name: str) -> Figure[Data]:
    """The figure with its name above it."""

    def draw() -> Canvas:
        canvas = figure.draw()
        left, top, right, _ = canvas.box
        canvas.label(((left + right) / 2, top - 14), name)
        return canvas.fit()

    return replace(figure, draw=draw)


def above(*figures: Figure[Data], title: str = "", alt: str = "") -> Figure[tuple[Data, ...]]:
    """One figure made of several, or of several rows, one above another.

    >>> from coxeter.figures import coxeter_diagram
    >>> above(coxeter_diagram("A2"), coxeter_diagram("G2")).data[1].name
    'G2'
    """
    if not figures:
        raise InvalidInput("a column needs at least one figure")
    rows: Sequence[Figure[Data]] = figures
    return Figure(
        title or "; ".join(row.title for row in rows),
        alt or " ".join(row.alt for row in rows),
        tuple(row.data for row in rows),
        lambda: one_above_another([row.draw() for row in rows]),
        tuple(part for row in rows for part in row.parts or (row,)),
        tuple(rows),
    )
