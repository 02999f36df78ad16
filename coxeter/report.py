"""Everything about one simplex or one triangulation, as a sheet to read and as data.

An exact value is written as ``{"exact": "sqrt(3)/4", "decimal": 0.4330127018922193}``; SymPy reads
the first, the second is rounded once. Decimals beyond the range of floating-point numbers keep
their digits in JSON.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from .affine import CoxeterTriangulation
from .delaunay import circumcentre_position, delaunay_verdict, protection
from .diagrams import affine_diagram, as_text
from .exact import Surd, surd
from .lattices import NonLatticeWitness, vertex_lattice
from .quality import MEASURES
from .simplex import Simplex
from .tables import runs


def exact(value: object) -> dict[str, Any]:
    """An exact value as an object with its exact form and its decimal.

    >>> exact(Fraction(1, 4))
    {'exact': '1/4', 'decimal': 0.25}
    """
    x = surd(value)
    fits = not x or Fraction(1, 10**300) < abs(x) < 10**300
    return {"exact": str(x), "decimal": float(x) if fits else _BEYOND + x.scientific()}


_BEYOND = "beyond float: "


def to_json(data: dict[str, Any]) -> str:
    """JSON text; decimals beyond the range of floats are written as numbers all the same."""
    return re.sub(f'"{_BEYOND}([^"]*)"', r"\1", json.dumps(data, indent=1, ensure_ascii=False))


def simplex_data(simplex: Simplex) -> dict[str, Any]:
    """All measurements of a simplex, as JSON-ready data with exact values."""
    return {
        "dimension": simplex.dimension,
        "vertices": [[str(x) for x in vertex] for vertex in simplex.vertices],
        "minimal_height": exact(simplex.minimal_height),
        "longest_edge": exact(simplex.longest_edge),
        "inradius": exact(simplex.inradius),
        "circumradius": exact(simplex.circumradius),
        "volume": exact(simplex.volume),
        "circumcentre": [exact(x) for x in simplex.circumcentre],
        "incentre": [exact(x) for x in simplex.incentre],
        "circumcentre_position": circumcentre_position(simplex).value,
        "quality": {name: exact(m(simplex)) for name, m in MEASURES.items()},
        "normalized": {name: exact(m.normalized(simplex)) for name, m in MEASURES.items()},
    }


def triangulation_data(triangulation: CoxeterTriangulation) -> dict[str, Any]:
    """All results for a Coxeter triangulation, as JSON-ready data with exact values.

    Lengths are in the scale of Theorem 3's simple roots. ``marks`` are those of nodes 1 … d.

    >>> from coxeter.affine import triangulation
    >>> data = triangulation_data(triangulation("C~2"))
    >>> data["circumradius"], data["delaunay"], data["protected"]
    ({'exact': 'sqrt(2)/4', 'decimal': 0.3535533905932738}, True, False)
    """
    system, guarded = triangulation.roots, protection(triangulation)
    lattice = vertex_lattice(triangulation)
    return {
        "type": triangulation.name,
        "marks": list(system.marks),
        "weyl_group_order": system.weyl_group_order,
        "facets": [{"normal": [str(x) for x in f.normal], "offset": f.offset} for f in triangulation.facets],
        **simplex_data(triangulation.simplex),
        "delaunay": delaunay_verdict(triangulation).delaunay,
        "protected": bool(guarded),
        "protection": exact(guarded.absolute),
        "relative_protection": exact(guarded.relative),
        "vertex_set_is_lattice": lattice.is_lattice,
        "lattice_reason": str(lattice),
    }


MINUS = "\N{MINUS SIGN}"


class Facts:
    """Named exact values, for a notebook to show: typeset exactly, with decimals beside.

    Parameters
    ----------
    values
        A mapping from names (LaTeX) to exact numbers; keywords serve for plain names.

    Examples
    --------
    >>> Facts({"h": surd("sqrt(2)/4")}, L=1)
    h = sqrt(2)/4 ≈ 0.353553
    L = 1
    """

    def __init__(self, values: Mapping[str, object] | None = None, /, **named: object) -> None:
        self.values = {name: surd(x) for name, x in {**(values or {}), **named}.items()}

    def __repr__(self) -> str:
        return "\n".join(f"{name} = {x}{_approximately(x)}" for name, x in self.values.items())

    def _repr_html_(self) -> str:
        rows = "".join(
            rf"<tr><td>\({name}\)</td><td>\({x.latex()}\)</td><td>{_printed(x)}</td></tr>"
            for name, x in self.values.items()
        )
        table = f'<table class="facts"><tbody>{rows}</tbody></table>'
        return f'<div class="table-box tex2jax_process">{table}</div>'


def _printed(x: Surd) -> str:
    return _approximately(x).replace("-", MINUS)


def _approximately(x: Surd) -> str:
    if not x.is_rational:
        return f" ≈ {_short(x)}"
    fraction, decimal = x.as_fraction(), _short(x)
    if fraction.denominator == 1:
        return ""
    return f" = {decimal.rstrip('0')}" if Fraction(decimal) == fraction else f" ≈ {decimal}"


@dataclass(frozen=True)
class Sheet:
    """A sheet to read: headed sections of lines. ``print`` it, or let a notebook show it."""

    title: str
    sections: tuple[tuple[str, tuple[str, ...]], ...]

    def __repr__(self) -> str:
        parts = [self.title, "=" * len(self.title)]
        for heading, lines in self.sections:
            parts += ["", heading, *("  " + line for line in lines)]
        return "\n".join(parts)


def simplex_sheet(simplex: Simplex, title: str = "Simplex") -> Sheet:
    """A readable sheet of all measurements of a simplex."""
    vertices = tuple(f"u_{k} = {runs(v)}" for k, v in enumerate(simplex.vertices))
    return Sheet(
        f"{title}, dimension {simplex.dimension}", (("Vertices", vertices), *_metric_sections(simplex))
    )


def triangulation_sheet(triangulation: CoxeterTriangulation) -> Sheet:
    """A readable sheet of everything about a Coxeter triangulation."""
    simplex, system = triangulation.simplex, triangulation.roots
    diagram = affine_diagram(system)
    return Sheet(
        f"Coxeter triangulation {triangulation.name}, dimension {triangulation.dimension}",
        (
            ("Diagram (nodes)", tuple(as_text(diagram).splitlines())),
            ("Diagram (marks)", tuple(as_text(diagram, "mark").splitlines())),
            (
                "Root system",
                (
                    f"{len(system.positive_root_coordinates) * 2} roots",
                    f"Weyl group of order {system.weyl_group_order}",
                ),
            ),
            ("Vertices", tuple(f"u_{k} = {runs(v)}" for k, v in enumerate(simplex.vertices))),
            (
                "Facets",
                tuple(f"tau_{f.index}: <x, {runs(f.normal)}> >= {f.offset}" for f in triangulation.facets),
            ),
            *_metric_sections(simplex),
            ("Triangulation", _verdict_lines(triangulation)),
        ),
    )


def _metric_sections(simplex: Simplex) -> Sequence[tuple[str, tuple[str, ...]]]:
    lengths = {
        "minimal height": simplex.minimal_height,
        "longest edge": simplex.longest_edge,
        "inradius": simplex.inradius,
        "circumradius": simplex.circumradius,
        "volume": simplex.volume,
    }
    heading = f"{'':16}{'raw':>12}  {'normalised':>10}  exact (raw; normalised)"
    measures = [
        f"{name.replace('_', ' '):16}{_short(m(simplex)):>12}  {_short(m.normalized(simplex)):>10}"
        f"  {m(simplex)}; {m.normalized(simplex)}"
        for name, m in MEASURES.items()
    ]
    return (
        ("Centres", (f"circumcentre {runs(simplex.circumcentre)}", f"incentre {runs(simplex.incentre)}")),
        ("Lengths and volume", tuple(f"{name:16}{_short(x):>12}  {x}" for name, x in lengths.items())),
        ("Quality", (heading, *measures)),
    )


def _short(x: Surd) -> str:
    return x.decimal(6) if abs(x) >= Fraction(1, 1000) or not x else x.scientific(7)


def _verdict_lines(triangulation: CoxeterTriangulation) -> tuple[str, ...]:
    verdict, guarded = delaunay_verdict(triangulation), protection(triangulation)
    lattice = vertex_lattice(triangulation)
    where = {"inside": "inside the simplex", "boundary": "on its boundary", "outside": "outside it"}
    found = "is no lattice" if isinstance(lattice, NonLatticeWitness) else "is a lattice"
    return (
        f"Delaunay: {'yes' if verdict else 'no'}; the circumcentre lies {where[verdict.position.value]}",
        f"relative protection: {_short(guarded.relative)}  {guarded.relative}",
        f"the vertex set {found}: {lattice}",
    )
