"""The commands about triangulations: ``list``, ``info``, ``simplex`` and ``table``."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from ..affine import CoxeterTriangulation, triangulation
from ..errors import InvalidInput
from ..names import triangulations_up_to
from ..report import simplex_data, simplex_sheet, to_json, triangulation_data, triangulation_sheet
from ..simplex import Simplex
from ..tables import FORMATS, TABLES, Table, table
from .common import Answer, checked_digits, integer

if TYPE_CHECKING:
    from .common import Commands


def add_commands(commands: Commands) -> None:
    """Add the commands to a parser."""
    sub = commands.add_parser("list", help="the triangulations up to a dimension")
    sub.add_argument("--max-dim", type=integer, default=8, help="largest dimension (default 8)")
    sub.set_defaults(run=_list)

    sub = commands.add_parser("info", help="everything about one triangulation")
    sub.add_argument("type", help="such as 'B~3'")
    sub.add_argument("--json", action="store_true", help="print one JSON object")
    sub.set_defaults(run=_info)

    sub = commands.add_parser("simplex", help="everything about a simplex of your own")
    sub.add_argument("vertices", help="exact vertices, such as '0,0; 1,0; 1/2,sqrt(3)/2'")
    sub.add_argument("--json", action="store_true", help="print one JSON object")
    sub.set_defaults(run=_simplex)

    sub = commands.add_parser("table", help="a table of the paper, to any dimension")
    sub.add_argument("number", help=f"one of {', '.join(TABLES)}")
    sub.add_argument("--max-dim", type=integer, default=8, help="largest dimension (default 8)")
    sub.add_argument("--digits", type=integer, default=3, help="digits after the point (default 3)")
    sub.add_argument("--format", default="text", help=f"one of {', '.join(FORMATS)} (default text)")
    sub.add_argument("--exact", action="store_true", help="exact values instead of decimals")
    sub.set_defaults(run=_table)


def _list(options: argparse.Namespace) -> Answer:
    if options.max_dim < 2:
        raise InvalidInput(f"{options.max_dim} is no dimension to list up to: give an integer >= 2")
    kinds = triangulations_up_to(options.max_dim)
    rows = tuple(
        (kind.affine, str(kind.rank), str(CoxeterTriangulation(kind).roots.weyl_group_order))
        for kind in kinds
    )
    listing = Table("Coxeter triangulations", ("type", "dimension", "order of the Weyl group"), rows)
    where = "A~d, C~d: d >= 2; B~d: d >= 3; D~d: d >= 4; E~6, E~7, E~8, F~4, G~2"
    return Answer(f"{listing.render('text')}\n\n{where}")


def _info(options: argparse.Namespace) -> Answer:
    t = triangulation(options.type)
    return Answer(to_json(triangulation_data(t)) if options.json else str(triangulation_sheet(t)))


def _simplex(options: argparse.Namespace) -> Answer:
    points = [[x.strip() for x in vertex.split(",")] for vertex in options.vertices.split(";")]
    simplex = Simplex(points)
    return Answer(to_json(simplex_data(simplex)) if options.json else str(simplex_sheet(simplex)))


def _table(options: argparse.Namespace) -> Answer:
    digits = checked_digits(options.digits)
    return Answer(table(options.number, options.max_dim).render(options.format, digits, options.exact))
