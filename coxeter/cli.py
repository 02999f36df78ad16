"""The command line: ``coxeter list``, ``info``, ``simplex`` and ``table``.

Bad input ends with one sentence on the standard error and exit status 2.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Sequence
from typing import NoReturn

from . import __version__
from .affine import CoxeterTriangulation, triangulation
from .errors import CoxeterError, InvalidInput
from .names import triangulations_up_to
from .report import simplex_data, simplex_sheet, to_json, triangulation_data, triangulation_sheet
from .simplex import Simplex
from .tables import FORMATS, TABLES, Table, table


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        self.exit(2, f"coxeter: {message}; see '{self.prog} --help'\n")


def _dimension(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is no integer: give one, such as 8") from None


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="coxeter", description="Coxeter triangulations, computed exactly.")
    parser.add_argument("--version", action="version", version=f"coxeter-triangulations {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    sub = commands.add_parser("list", help="the triangulations up to a dimension")
    sub.add_argument("--max-dim", type=_dimension, default=8, help="largest dimension (default 8)")
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
    sub.add_argument("--max-dim", type=_dimension, default=8, help="largest dimension (default 8)")
    sub.add_argument("--digits", type=_dimension, default=3, help="digits after the point (default 3)")
    sub.add_argument("--format", default="text", help=f"one of {', '.join(FORMATS)} (default text)")
    sub.add_argument("--exact", action="store_true", help="exact values instead of decimals")
    sub.set_defaults(run=_table)
    return parser


def _list(options: argparse.Namespace) -> str:
    if options.max_dim < 2:
        raise InvalidInput(f"{options.max_dim} is no dimension to list up to: give an integer >= 2")
    kinds = triangulations_up_to(options.max_dim)
    rows = tuple(
        (kind.affine, str(kind.rank), str(CoxeterTriangulation(kind).roots.weyl_group_order))
        for kind in kinds
    )
    listing = Table("Coxeter triangulations", ("type", "dimension", "order of the Weyl group"), rows)
    return listing.render("text") + "\n\nA~d, C~d: d >= 2; B~d: d >= 3; D~d: d >= 4; E~6, E~7, E~8, F~4, G~2"


def _info(options: argparse.Namespace) -> str:
    t = triangulation(options.type)
    return to_json(triangulation_data(t)) if options.json else str(triangulation_sheet(t))


def _simplex(options: argparse.Namespace) -> str:
    points = [[x.strip() for x in vertex.split(",")] for vertex in options.vertices.split(";")]
    simplex = Simplex(points)
    return to_json(simplex_data(simplex)) if options.json else str(simplex_sheet(simplex))


def _table(options: argparse.Namespace) -> str:
    return table(options.number, options.max_dim).render(options.format, options.digits, options.exact)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    if given[:1] == ["simplex"]:  # a vertex may start with a minus sign; it is no option
        given = [f" {x}" if re.match(r"-[^-h]", x) else x for x in given]
    try:
        options = _parser().parse_args(given)
        print(options.run(options), flush=True)
    except CoxeterError as error:
        print(f"coxeter: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("coxeter: stopped", file=sys.stderr)
        return 130
    except MemoryError:
        print("coxeter: there is not enough memory for this dimension; try a smaller one", file=sys.stderr)
        return 2
    except BrokenPipeError:  # the reader, such as `head`, has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    return 0


if __name__ == "__main__":
    sys.exit(main())
