"""Reading the data files, and refusing damaged ones by file and line."""

from __future__ import annotations

import ast
import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import MISSING, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from ..names import FAMILIES
from .records import DamagedData, PrintedFormula, PrintedRow, Runs

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

_T = TypeVar("_T", bound="DataclassInstance")


def damaged(file: Path, line: int, what: str) -> DamagedData:
    """The error for a damaged file: where it is damaged, how, and what to do."""
    return DamagedData(f"{file.name}, line {line}: {what}; restore the file from the repository")


def read(file: Path, kind: type[_T]) -> tuple[_T, ...]:
    """The records of a file; `kind` is a dataclass with their entries, and `line` for the line's number."""
    return tuple(_build(file, line, record, kind) for line, record in _records(file))


def read_prose(files: Iterable[Path]) -> dict[str, dict[str, Any]]:
    """The constants of claims by the claim's id: integers, texts, and lists of these as tuples."""
    found: dict[str, dict[str, Any]] = {}
    where: dict[str, str] = {}
    for file in files:
        for line, record in _records(file):
            name = record.pop("id", None)
            if not isinstance(name, str) or not record:
                raise damaged(file, line, "a record needs the entry 'id' and at least one constant")
            if name in found:
                raise damaged(file, line, f"a second record {name!r}, beside that in {where[name]}")
            try:
                found[name] = {key: _constant(value) for key, value in record.items()}
            except TypeError:
                what = f"{name!r} has a constant that is no number, text or list"
                raise damaged(file, line, what) from None
            where[name] = f"{file.name}, line {line}"
    return found


def _constant(value: Any) -> Any:
    if isinstance(value, list):
        return tuple(map(_constant, value))
    if not isinstance(value, str | int):
        raise TypeError
    return value


def _records(file: Path) -> Iterator[tuple[int, dict[str, Any]]]:
    try:
        data = file.read_bytes()
        text = data.decode("utf-8")
        json.loads(text)
    except OSError as error:
        raise damaged(file, 1, f"cannot be read ({error.strerror})") from None
    except UnicodeDecodeError as error:
        raise damaged(file, data[: error.start].count(b"\n") + 1, "not UTF-8 text") from None
    except json.JSONDecodeError as error:
        raise damaged(file, error.lineno, error.msg) from None
    lines = text.rstrip("\n").split("\n")
    if lines[0] != "[" or lines[-1] != "]":
        raise damaged(file, 1, "not a list with one record to a line")
    for number, line in enumerate(lines[1:-1], 2):
        try:
            record = json.loads(line.removesuffix(","))
        except json.JSONDecodeError:
            raise damaged(file, number, "not one record to a line") from None
        if not isinstance(record, dict):
            raise damaged(file, number, "not a record")
        yield number, record


def _build(file: Path, line: int, record: dict[str, Any], kind: type[_T]) -> _T:
    known = {field.name: field for field in fields(kind) if field.name != "line"}
    if unknown := set(record) - set(known):
        raise damaged(file, line, f"unknown entry {min(unknown)!r}")
    missing = [name for name, field in known.items() if field.default is MISSING and name not in record]
    if missing:
        raise damaged(file, line, f"the entry {missing[0]!r} is missing")
    decimal = kind is PrintedFormula and record.get("decimal") is True
    values: dict[str, Any] = {}
    for name, value in record.items():
        check = _decimal if name == "text" and decimal else _CHECKS.get(name, _text)
        try:
            values[name] = check(value)
        except (TypeError, ValueError, SyntaxError):
            raise damaged(file, line, f"{value!r} cannot be the entry {name!r}") from None
    return kind(**values | {"line": line})


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError
    return value


def _decimal(value: Any) -> str:
    float(_text(value))  # only whether it has the form of a number: the claims read it exactly
    return str(value)


def _integer(value: Any) -> int:
    if type(value) is not int:
        raise TypeError
    return value


def _flag(value: Any) -> bool:
    if value is not True and value is not False:
        raise TypeError
    return value


def _one_of(*allowed: str) -> Callable[[Any], str]:
    def check(value: Any) -> str:
        if value not in allowed:
            raise ValueError
        return _text(value)

    return check


_NODES = (
    ast.Expression | ast.Constant | ast.Name | ast.Load | ast.UnaryOp | ast.USub | ast.BinOp | ast.Call
) | (ast.Add | ast.Sub | ast.Mult | ast.Div | ast.Pow)
_LETTERS = {"d", "i", "j", "k", "h", "L", "r", "R", "vol", "c", "sqrt", "factorial"}


def _formula(value: Any) -> str:
    """Text with the form of a formula, or empty; what it is worth is for the claims to say."""
    for node in ast.walk(ast.parse(_text(value), mode="eval")) if value else ():
        if not isinstance(node, _NODES) or (isinstance(node, ast.Name) and node.id not in _LETTERS):
            raise ValueError
        if isinstance(node, ast.Constant) and type(node.value) is not int:
            raise ValueError
    return str(value)


def _texts(value: Any) -> tuple[str, ...]:
    return tuple(map(_text, _list(value)))


def _runs(value: Any) -> Runs:
    runs = []
    for coordinate, count in _list(value):
        if not coordinate or not count:
            raise ValueError
        runs.append((_formula(coordinate), _formula(count)))
    return tuple(runs)


def _list(value: Any) -> Sequence[Any]:
    if not isinstance(value, list):
        raise TypeError
    return value


_KINDS = ("facet", "distance", "minimal", "longest", "level", "product", "space", "combination", "no vertex")
_CHECKS: dict[str, Callable[[Any], Any]] = {
    "table": _integer,
    "decimal": _flag,
    "cells": _texts,
    "runs": _runs,
    "normal": _runs,
    "terms": _runs,
    "low": _integer,
    "letter": _one_of("", *"ABCDEFG"),
    "family": _one_of(*FAMILIES, "regular"),
    "parity": _one_of("odd", "even"),
    "name": _one_of("vertex", "circumcentre", "incentre", "mirror_vertex", "mirror_shift"),
    "kind": _one_of(*_KINDS),
} | dict.fromkeys(("text", "index", "first", "last", "facet", "vertex"), _formula)


def check_tables(file: Path, rows: tuple[PrintedRow, ...]) -> None:
    """Tables 3 to 6 are whole: a head and the rows A to G, with seven cells each."""
    expected = [(table, letter) for table in (3, 4, 5, 6) for letter in ("", *"ABCDEFG")]
    for position, row in enumerate(rows):
        if position >= len(expected) or (row.table, row.letter) != expected[position]:
            raise damaged(file, row.line, f"row {row.letter!r} of Table {row.table} is out of place")
        if len(row.cells) != 7:
            raise damaged(file, row.line, f"{len(row.cells)} cells in place of 7")
    if len(rows) < len(expected):
        table, letter = expected[len(rows)]
        raise damaged(file, rows[-1].line if rows else 1, f"row {letter!r} of Table {table} is missing")
