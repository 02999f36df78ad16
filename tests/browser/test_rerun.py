"""The notebooks run wherever they lie, and Binder is told how to install what they need."""

import re
import tomllib
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("name", ["section-3", "family-G2"])
def test_a_notebook_runs_in_any_folder(name: str, tmp_path: Path) -> None:
    notebook = nbformat.read(ROOT / "notebooks" / f"{name}.ipynb", as_version=4)
    NotebookClient(
        notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}
    ).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert outputs
    assert not [output for output in outputs if output.output_type == "error"]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_no_cell_names_a_file_beside_it(path: Path) -> None:
    cells = [cell.source for cell in nbformat.read(path, as_version=4).cells if cell.cell_type == "code"]
    assert not re.findall(r"""(?:open|Path|read_\w+)\(\s*["'](?!/|https?:)[^"']*["']""", "\n".join(cells))
    assert not re.findall(r"sys\.path|os\.chdir|^%cd", "\n".join(cells), re.MULTILINE)


def test_binder_installs_this_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    lines = (ROOT / "binder" / "requirements.txt").read_text().split()
    local = [re.fullmatch(r"(\.[^\[]*)(?:\[(.*)\])?", line) for line in lines]
    found = [match for match in local if match]
    assert found, "nothing of this repository is installed"
    for match in found:
        assert (ROOT / match[1] / "pyproject.toml").is_file()  # Binder runs pip in the repository's root
        assert {*filter(None, (match[2] or "").split(","))} <= set(project["optional-dependencies"])


def test_binder_has_a_python_that_is_new_enough() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    asked = (ROOT / "binder" / "runtime.txt").read_text().strip()
    least = project["requires-python"].removeprefix(">=")
    version = asked.removeprefix("python-")
    assert [*map(int, version.split("."))] >= [*map(int, least.split("."))]
