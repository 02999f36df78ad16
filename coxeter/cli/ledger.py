"""The commands about the paper's statements: ``verify`` and ``explain``."""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable
from contextlib import nullcontext
from typing import TYPE_CHECKING

from ..errors import InvalidInput
from ..ledger import all_claims
from ..ledger.pools import cpus, process_pool
from ..ledger.reporting import compare
from ..ledger.running import verify
from ..ledger.selecting import expected, select
from .common import Answer, integer
from .console import progress
from .explaining import explain, explained

if TYPE_CHECKING:
    from .common import Commands

FEW = 30
"""So many claims are judged sooner than a pool of processes is started."""


def add_commands(commands: Commands) -> None:
    """Add the commands to a parser."""
    ids = "a claim, such as prop-12, or all of an item, such as thm-8"
    sub = commands.add_parser(
        "verify",
        help="judge the paper's statements, and hold the verdicts against the recorded ones",
        epilog="Exit status: 0 if every verdict is as recorded and every mutant rejected, 1 if not.",
    )
    sub.add_argument("ids", nargs="*", metavar="ID", help=f"{ids}; default: everything")
    sub.add_argument("--section", help="1 to 6, or A to D for an appendix")
    sub.add_argument("--family", help="A to G, or one type, such as E6")
    sub.add_argument("--jobs", type=integer, help="processes (default: one; for many claims, all there are)")
    sub.add_argument("--json", action="store_true", help="print a list of JSON objects")
    sub.set_defaults(run=_verify)

    sub = commands.add_parser("explain", help="everything about a statement of the paper")
    sub.add_argument("ids", nargs="+", metavar="ID", help=ids)
    sub.add_argument("--json", action="store_true", help="print a list of JSON objects")
    sub.set_defaults(run=_explain)


def _verify(options: argparse.Namespace) -> Answer:
    started = time.perf_counter()
    claims = select(options.ids, options.section, options.family)
    jobs = _jobs(options.jobs, len(claims))
    with progress() as show, process_pool(jobs) if jobs > 1 else nullcontext() as executor:
        results = verify(claims, executor, show and _counting(show))
    records = expected(options.ids, claims, options.section, options.family)
    report = compare(results, records, time.perf_counter() - started)
    status = 0 if report.ok else 1
    if options.json:
        return Answer(_to_json(report.data()), status)
    chosen = options.ids or options.section or options.family
    return Answer("\n".join([*report.lines(), "", str(report)] if chosen else [str(report)]), status)


def _counting(show: Callable[[float, str], None]) -> Callable[[int, int], None]:
    return lambda done, of: show(done / max(of, 1), f"{done} of {of} claims")


def _jobs(asked: int | None, claims: int) -> int:
    if asked is None:
        return cpus() if claims > FEW else 1
    if asked < 1:
        raise InvalidInput(f"{asked} jobs can do nothing: give --jobs a number >= 1")
    return asked


def _explain(options: argparse.Namespace) -> Answer:
    all_claims()  # any of them may depend on what is asked for
    claims = sorted(
        select(options.ids).values(), key=lambda claim: claim.id not in options.ids
    )  # itself first
    entries = [explained(claim) for claim in claims]
    if options.json:
        return Answer(_to_json([entry.data() for entry in entries]))
    return Answer("\n\n".join(map(explain, entries)))


def _to_json(data: object) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False)
