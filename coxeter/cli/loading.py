"""Measures of one's own on the command line: a Python file that registers them when it is run."""

from __future__ import annotations

import argparse
import sys
import tokenize
import traceback
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from pathlib import Path

from ..errors import InvalidInput
from ..quality import MEASURES, MESH_MEASURES


def add_load(sub: argparse.ArgumentParser) -> None:
    """Add the option to a command."""
    sub.add_argument(
        "--load", action="append", default=[], metavar="FILE.py",
        help="run a Python file that registers measures by @coxeter.measure; may be repeated",
    )  # fmt: skip


@contextmanager
def measures_of(paths: list[str]) -> Iterator[list[str]]:
    """The names of the measures that some files register; they are forgotten at the end.

    Raises
    ------
    InvalidInput
        If a file cannot be read or run, or registers none.
    """
    before = dict(MEASURES), dict(MESH_MEASURES)
    try:
        yield [name for path in paths for name in _registered_by(Path(path))]
    finally:
        for registry, measures in zip((MEASURES, MESH_MEASURES), before, strict=True):
            registry.clear()
            registry.update(measures)


def _registered_by(path: Path) -> list[str]:
    before = {**MEASURES, **MESH_MEASURES}
    try:
        with tokenize.open(path) as file:
            source = file.read()
    except OSError as error:
        raise InvalidInput(f"--load {path}: {error.strerror}") from error
    except (SyntaxError, UnicodeDecodeError) as error:
        raise InvalidInput(f"{path} cannot be read as Python: {error}") from error
    sys.path.insert(0, str(path.parent))
    try:
        with redirect_stdout(sys.stderr):  # the standard output is for the answer
            exec(compile(source, path, "exec"), {"__name__": path.stem, "__file__": str(path)})
    except (Exception, SystemExit) as error:
        raise InvalidInput(f"{path}{_line(error, path)}: {type(error).__name__}: {_what(error)}") from error
    finally:
        sys.path.remove(str(path.parent))
    if not (added := [name for name in {**MEASURES, **MESH_MEASURES} if name not in before]):
        raise InvalidInput(
            f'{path} registers no measure: put @coxeter.measure("my name") before a function of a simplex'
        )
    return added


def _line(error: BaseException, path: Path) -> str:
    """The last line of the file that an error came through."""
    lines = [x.lineno for x in traceback.extract_tb(error.__traceback__) if x.filename == str(path)]
    if isinstance(error, SyntaxError) and error.filename == str(path):
        lines.append(error.lineno)
    return f", line {lines[-1]}" if lines else ""


def _what(error: BaseException) -> str:
    return " ".join(str(error.msg if isinstance(error, SyntaxError) else error).split())
