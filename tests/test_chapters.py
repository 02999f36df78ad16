"""The chapters: each opens, ends and folds in the same way, and together they speak of every claim."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

import nbformat
import pytest

from coxeter.errors import InvalidInput
from coxeter.ledger import all_claims, find_claim, run_claim
from coxeter.ledger.inventory import belongs
from coxeter.pages import Judged, Ledger

FOLDER = Path(__file__).resolve().parent.parent / "notebooks"
PATHS = sorted(FOLDER.glob("*.ipynb"))
INSTALL = """\
# Where the library is missing (Colab, Binder, an empty environment), install it from the repository.
import importlib.util
import os

repository = os.environ.get("COXETER_REPOSITORY", "..")
if not importlib.util.find_spec("coxeter"):
    %pip install --quiet {repository}"""
LONGEST = 8  # code lines that a cell may have, if it is not folded

chapters = pytest.mark.parametrize("path", PATHS, ids=lambda path: path.stem)


@lru_cache
def cells(path: Path) -> tuple[nbformat.NotebookNode, ...]:
    return tuple(nbformat.read(path, as_version=4).cells)


def prose(path: Path) -> list[str]:
    return [cell.source for cell in cells(path) if cell.cell_type == "markdown"]


def code(path: Path) -> list[nbformat.NotebookNode]:
    return [cell for cell in cells(path) if cell.cell_type == "code"]


def tags(cell: nbformat.NotebookNode) -> list[str]:
    return list(cell.metadata.get("tags", []))


def headings(path: Path) -> list[str]:
    return re.findall(r"^#+ .*$", "\n".join(prose(path)), flags=re.MULTILINE)


def spoken_of(path: Path) -> set[str]:
    """The ids in the boxes of a chapter, and in its cells that explain."""
    boxes = re.findall(r"^:::+\{verdict\} (.*)$", "\n".join(prose(path)), flags=re.MULTILINE)
    shown = [cell.source for cell in code(path) if cell.source.startswith("explain(")]
    return {x.strip() for box in boxes for x in box.split(",")} | {
        x for source in shown for x in re.findall(r'"([^"]+)"', source)
    }


def test_there_are_chapters() -> None:
    assert len(PATHS) >= 18


@chapters
def test_first_code_cell_installs_what_is_missing(path: Path) -> None:
    first = code(path)[0]
    assert (first.source, tags(first)) == (INSTALL, ["remove-cell"])


@chapters
def test_opens_with_a_title_and_with_what_came_out(path: Path) -> None:
    title, _, opening = prose(path)[0].partition("\n")
    assert cells(path)[0].cell_type == "markdown"
    assert re.match(r"# \S.* · \S", title)
    assert "What came out" in opening
    assert len(opening) > 200


@chapters
def test_ends_with_what_was_learnt_and_what_to_try(path: Path) -> None:
    last = [x for x in headings(path) if x.startswith("## ")]
    assert "## What we learnt" in last
    assert "## Try next" in last[last.index("## What we learnt") :]


@chapters
def test_headings_are_divided_by_a_dot(path: Path) -> None:
    assert [x for x in headings(path) if " — " in x or " – " in x] == []


@chapters
def test_cells_are_short(path: Path) -> None:
    lengths = {
        cell.id: sum(bool(line.strip()) for line in cell.source.splitlines())
        for cell in code(path)
        if not {"hide-cell", "hide-input"} & set(tags(cell))
    }
    assert {id: n for id, n in lengths.items() if n > LONGEST} == {}


@chapters
def test_fences_are_closed(path: Path) -> None:
    for source in prose(path):
        depth = 0
        for line in source.splitlines():
            if line.startswith(":::"):
                depth += 1 if re.match(r":::+\{", line) else -1
            assert depth >= 0, source
        assert depth == 0, source


def test_every_claim_has_its_place_in_a_chapter() -> None:
    ids = set().union(*map(spoken_of, PATHS))
    assert [claim for claim in all_claims() if not any(belongs(claim, id) for id in ids)] == []


@chapters
def test_what_a_chapter_speaks_of_is_claimed(path: Path) -> None:
    claims = all_claims()
    assert [id for id in spoken_of(path) if not any(belongs(claim, id) for claim in claims)] == []


def test_a_badge_can_speak_of_one_claim_alone() -> None:
    ids = ("lem-9", "lem-9.chain")
    ledger = Ledger(tuple(Judged(find_claim(id), run_claim(id)) for id in ids))
    assert [x.id for x in ledger.find("lem-9")] == ["lem-9", "lem-9.chain"]
    assert [x.id for x in ledger.find("lem-9!")] == ["lem-9"]
    with pytest.raises(InvalidInput, match="no claim 'lem-90!'"):
        ledger.find("lem-90!")
