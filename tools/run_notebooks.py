"""Execute notebooks, two at a time, and store their outputs in the files or in a cache.

What is stored depends on nothing but the code: no times, no versions, no machine.
"""

import argparse
import difflib
import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from os import cpu_count
from pathlib import Path

import nbformat
from jupyter_cache import get_cache
from jupyter_cache.base import CacheBundleIn
from nbclient import NotebookClient

ROOT = Path(__file__).resolve().parent.parent
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
TIMEOUT = 300  # seconds for one cell


def execute(path: Path) -> nbformat.NotebookNode:
    """The notebook with fresh outputs."""
    notebook = nbformat.read(path, as_version=4)
    NotebookClient(
        notebook,
        timeout=TIMEOUT,
        kernel_name="python3",
        record_timing=False,
        extra_arguments=["--log-level=ERROR"],
        resources={"metadata": {"path": str(path.parent)}},
    ).execute()
    return notebook


def store(path: Path) -> str:
    """Execute a notebook and write it back."""
    notebook = execute(path)
    notebook.metadata = {"kernelspec": KERNEL, "language_info": {"name": "python"}}
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
    nbformat.write(notebook, path)
    return "stored"


def cache_into(folder: Path) -> Callable[[Path], str]:
    """How to execute a notebook into the cache that the book reads, unless it is there."""
    get_cache(folder).list_cache_records()  # makes the database before the threads share it

    def cache(path: Path) -> str:
        found = get_cache(folder)
        try:
            found.match_cache_notebook(nbformat.read(path, as_version=4))
            return "unchanged"
        except KeyError:
            bundle = CacheBundleIn(execute(path), str(path))
            found.cache_notebook_bundle(bundle, check_validity=False, overwrite=True)
            return "executed"

    return cache


def all_notebooks() -> list[Path]:
    return sorted((ROOT / "notebooks").glob("*.ipynb"))


def find_notebook(name: str) -> Path:
    """The notebook of a name.

    >>> find_notebook("section-1").name, find_notebook("notebooks/section-1.ipynb").name
    ('section-1.ipynb', 'section-1.ipynb')
    """
    known = {path.stem: path for path in all_notebooks()}
    stem = Path(name).name.removesuffix(".ipynb")
    if stem not in known:
        near = difflib.get_close_matches(stem, known, n=1)
        meant = f"did you mean {near[0]!r}? " if near else ""
        raise argparse.ArgumentTypeError(f"no notebook {name!r}: {meant}there are {', '.join(known)}")
    return known[stem]


def run_all(work: Callable[[Path], str], paths: Sequence[Path] = ()) -> list[Path]:
    """Do the work on some notebooks, or on all, saying how each went, and return those that failed."""
    paths = paths or all_notebooks()
    failed = []
    begin = time.time()
    with ThreadPoolExecutor(cpu_count()) as pool:
        running = {pool.submit(work, path): path for path in paths}
        for done, future in enumerate(as_completed(running), start=1):
            path = running[future]
            try:
                verdict = future.result()
            except Exception as error:  # in a cell, in its kernel or in the file
                failed.append(path)
                verdict = f"FAILED\n{error}"
            elapsed = time.time() - begin
            print(f"  {done:2}/{len(paths)}  {elapsed:6.1f} s  {path.name}: {verdict}", flush=True)
    return failed


def main(words: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="Execute notebooks and store their outputs in the files.")
    parser.add_argument(
        "notebooks", nargs="*", type=find_notebook, metavar="NAME", help="as family-A; all by default"
    )
    return bool(run_all(store, parser.parse_args(words).notebooks))


if __name__ == "__main__":
    sys.exit(main())
