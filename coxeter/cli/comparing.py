"""The command ``compare``: all families beside other triangulations, by one measure."""

from __future__ import annotations

import argparse
import warnings
from typing import TYPE_CHECKING

from ..errors import InvalidInput
from ..peers import DEFAULT, PEERS, Peer, find_peer
from ..quality import MEASURES, MESH_MEASURES, find_measure
from ..tables import FORMATS, measure_table
from .common import Answer, checked_digits, integer, words
from .console import say
from .loading import add_load, measures_of

if TYPE_CHECKING:
    from .common import Commands

LARGEST = 200
"""The last dimension of a table."""
MOST_OF_D1 = 40
"""The last in which D1 is compared: it has about d shapes, which beyond take many minutes."""


def add_commands(commands: Commands) -> None:
    """Add the command to a parser."""
    sub = commands.add_parser("compare", help="all families and other triangulations, by one measure")
    measures = ", ".join([*MEASURES, *MESH_MEASURES])
    sub.add_argument(
        "--measure",
        help=f"one of {measures} (default thickness, or the one measure of a file that is loaded)",
    )
    add_load(sub)
    sub.add_argument("--max-dim", type=integer, default=8, help="largest dimension (default 8)")
    sub.add_argument(
        "--with",
        dest="peers",
        default="all",
        help=f"the others, with commas: some of {', '.join(PEERS)}, hill:1/3, goldberg-2:1/4; "
        "or all, or none (default all)",
    )
    sub.add_argument("--digits", type=integer, default=3, help="digits after the point (default 3)")
    sub.add_argument("--format", default="text", help=f"one of {', '.join(FORMATS)} (default text)")
    sub.add_argument("--exact", action="store_true", help="exact values instead of decimals")
    sub.set_defaults(run=_compare)


def _compare(options: argparse.Namespace) -> Answer:
    if options.max_dim < 2:
        raise InvalidInput(f"{options.max_dim} is no dimension to compare up to: give an integer >= 2")
    if options.max_dim > LARGEST:
        raise InvalidInput(f"{options.max_dim} columns are too many for a table: give {LARGEST} or fewer")
    digits = checked_digits(options.digits)
    peers = [peer for peer in _peers(options.peers) if peer.low <= options.max_dim]
    if options.max_dim > MOST_OF_D1 and any(peer.name == "D1" for peer in peers):
        raise InvalidInput(
            f"D1 takes too long beyond dimension {MOST_OF_D1}: give --max-dim {MOST_OF_D1}, or leave it out "
            "by --with K1 or --with none"
        )
    with measures_of(options.load) as loaded, warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        measure = find_measure(options.measure or _chosen(loaded))
        table = measure_table(measure, options.max_dim, peers=peers, best=True)
        text = table.render(options.format, digits, options.exact)
    if options.format == "text":
        return Answer("\n".join([text, "", *words(notes), _notes(peers)]))
    for note in words(notes):
        say(f"coxeter: {note}")
    return Answer(text)


def _chosen(loaded: list[str]) -> str:
    if len(loaded) > 1:
        raise InvalidInput(f"several measures were loaded: choose by --measure one of {', '.join(loaded)}")
    return loaded[0] if loaded else "thickness"


def _peers(text: str) -> list[Peer]:
    if text in ("all", "none"):
        return list(DEFAULT) if text == "all" else []
    return [find_peer(name.strip()) for name in dict.fromkeys(text.split(","))]


def _notes(peers: list[Peer]) -> str:
    notes = [f"{peer.name}: {peer.title}. {peer.source}" for peer in peers]
    first = (
        "1 is the regular simplex; larger is better. *: the largest of the values shown, compared exactly."
    )
    others = ["Of the others, the worst simplex counts; -: there is none, or no method for it.", *notes]
    return "\n".join([first, *(others if peers else ())])
