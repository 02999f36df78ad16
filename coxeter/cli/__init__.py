"""The command line, ``coxeter``: all that it can do is in `--help`.

Bad input ends with one sentence on the standard error and exit status 2.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Sequence
from typing import NoReturn

from .. import __version__
from ..errors import CoxeterError
from . import console


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        self.exit(2, f"coxeter: {message}; see '{self.prog} --help'\n")


def _parser() -> argparse.ArgumentParser:
    from . import comparing, ledger, meshes, triangulations  # here, so that an interruption is told in words

    parser = _Parser(prog="coxeter", description="Coxeter triangulations, computed exactly.")
    parser.add_argument("--version", action="version", version=f"coxeter-triangulations {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    triangulations.add_commands(commands)
    comparing.add_commands(commands)
    meshes.add_commands(commands)
    ledger.add_commands(commands)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    if given[:1] == ["simplex"]:  # a vertex may start with a minus sign; it is no option
        given = [f" {x}" if re.match(r"-[^-h]", x) else x for x in given]
    if given[:1] == ["mesh"]:  # so may a corner of a box
        given = [f" {x}" if re.match(r"-[.\d]", x) else x for x in given]
    console.readable()
    try:
        with console.stopped_by_signals():
            options = _parser().parse_args(given)
            answer = options.run(options)
            print(answer.text, flush=True)
    except CoxeterError as error:
        console.say(f"coxeter: {error}")
        return 2
    except KeyboardInterrupt as stop:
        console.say("coxeter: stopped")
        return stop.args[0] if stop.args else 130
    except MemoryError:
        console.say(
            "coxeter: there is not enough memory for this; try a smaller dimension, or fewer simplices"
        )
        return 2
    except BrokenPipeError:  # the reader, such as `head`, has seen enough
        console.abandon_output()
        return 0
    except OSError as error:
        console.say(f"coxeter: {error}")
        console.abandon_output()
        return 2
    return int(answer.status)
