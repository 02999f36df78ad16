"""How fast points are located and patches made, beside GUDHI and SciPy, in one run on one core.

    python benchmarks/locate.py [--quick] [-o results.json]

All that is compared is timed in turn, in seconds of the processor, several times over, and ratios are those
of the medians: so a machine that is busy now and then does not favour either. Only Dask's two workers have
two cores, and are timed by the clock on the wall. The book's page *Speed* is made from the file that is
written.
"""

import os

for name in ("OMP", "OPENBLAS", "MKL", "NUMBA"):
    os.environ[f"{name}_NUM_THREADS"] = "1"

import argparse
import json
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import contextmanager
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import gudhi_peer as gudhi
import numpy as np
from scipy.spatial import Delaunay

from coxeter.location import Grid, compiled
from coxeter.names import triangulations_up_to

CLEARED = 1 << 26
"""So many floats are written after another program has run, as the next to ask for memory would have to wait
until the system has cleared what was left."""
HERE = Path(__file__).resolve().parent
CORES = os.sched_getaffinity(0)
Timed = Callable[[], float]


def clock(work: Callable[[], object], of: Timed = time.process_time) -> Timed:
    """A function that works once, and returns the seconds of the processor."""

    def run() -> float:
        begin = of()
        work()
        return of() - begin

    return run


@contextmanager
def numpy_only():
    """As if Numba were not there."""
    kept, compiled.kernels = compiled.kernels, None
    try:
        yield
    finally:
        compiled.kernels = kept


def locating(grid: Grid, points: np.ndarray, plain: bool = False) -> Timed:
    """Locate all points, in NumPy alone if that is wanted."""

    def work() -> None:
        if plain:
            with numpy_only():
                grid.locate(points)
        else:
            grid.locate(points)

    return clock(work)


def in_turn(repeats: int, *runs: Timed) -> list[dict[str, float]]:
    """The least and the median of the seconds of each, measured one after the other, several times."""
    for run in runs:
        run()  # compiles, and fills what is kept
    seconds = np.array([[run() for run in runs] for _ in range(repeats)])
    return [{"least": float(s.min()), "median": float(np.median(s))} for s in seconds.T]


def points_in(d: int, n: int, seed: int = 0) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=(n, d)) * 10


# -- what is measured ------------------------------------------------------------


def against_gudhi(n: int, repeats: int) -> list[dict]:
    """A~d, with Numba and without, against GUDHI's locate_point."""
    if lacking := gudhi.missing():
        print(f"GUDHI is left out: {lacking} not there")
        return []
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        program = gudhi.compiled(folder)
        for d in range(2, 11):
            grid, points = gudhi.same_grid(program, d, folder), points_in(d, n)
            grid = Grid(f"A~{d}", scale=grid.frame.scale)

            def theirs(points: np.ndarray = points) -> float:
                seconds = float(gudhi.run(program, "time", points, folder).split()[0])
                np.ones(CLEARED)
                return seconds

            ours, plain, peer = in_turn(
                repeats, locating(grid, points), locating(grid, points, plain=True), theirs
            )
            rows.append({"d": d, "points": n, "ours": ours, "numpy": plain, "gudhi": peer})
            show("A~ against GUDHI", rows[-1], "ours", "gudhi")
    return rows


def families(n: int, repeats: int) -> list[dict]:
    """All triangulations with d = 2 ... 10, each against A~d."""
    rows = []
    for kind in triangulations_up_to(10):
        if kind.family != "A":
            d, reference = kind.rank, Grid(f"A~{kind.rank}")
            points, grid = points_in(kind.rank, n), Grid(kind.affine)
            ours, theirs = in_turn(repeats, locating(grid, points), locating(reference, points))
            rows.append({"name": kind.affine, "d": d, "points": n, "ours": ours, "A": theirs})
            show(kind.affine, rows[-1], "A", "ours")
    return rows


def growth(numbers: int, repeats: int) -> list[dict]:
    """Seconds a point for d = 10 ... 1000; the same amount of numbers in each."""
    rows = []
    for letter in "ABCD":
        for d in (10, 30, 100, 300, 1000):
            grid, points = Grid(f"{letter}~{d}"), points_in(d, max(50, numbers // d))
            fast, plain = in_turn(repeats, locating(grid, points), locating(grid, points, plain=True))
            rows.append({"family": letter, "d": d, "points": len(points), "ours": fast, "numpy": plain})
            show(f"{letter}~{d}", rows[-1], "numpy", "ours")
    return rows


def vertices(n: int, repeats: int) -> list[dict]:
    """Locating, and locating with the vertices of all simplices."""
    rows = []
    for name in ("A~2", "A~5", "A~10", "E~8"):
        grid = Grid(name)
        points = points_in(grid.dimension, n)
        alone, together = in_turn(
            repeats, locating(grid, points), clock(lambda g=grid, p=points: g.locate(p).vertices)
        )
        rows.append({"name": name, "points": n, "located": alone, "with_vertices": together})
        show(name, rows[-1], "with_vertices", "located")
    return rows


def patches(cells: int, repeats: int) -> list[dict]:
    """The patch of A~d round a box, against SciPy's Delaunay triangulation of the same points."""
    rows = []
    for d in range(2, 7):
        grid = Grid(f"A~{d}")
        corners = grid.locate(np.full((1, d), 0.01)).vertices[0]
        volume = abs(np.linalg.det(corners[1:] - corners[0])) / np.prod(np.arange(1.0, d + 1))
        wanted = cells / 10 ** max(0, d - 4)  # those that touch the box come in addition, and are the most
        lower, upper = np.zeros(d), np.full(d, (wanted * volume) ** (1 / d))
        mesh = grid.patch_in_box(lower, upper)
        ours, theirs = in_turn(
            repeats,
            clock(lambda g=grid, a=lower, b=upper: g.patch_in_box(a, b)),
            clock(lambda p=mesh.points: Delaunay(p)),
        )
        found = len(Delaunay(mesh.points).simplices)
        row = {"d": d, "points": len(mesh.points), "cells": len(mesh.cells), "scipy_cells": found}
        rows.append(row | {"ours": ours, "scipy": theirs})
        show(f"patch in R^{d}", rows[-1], "ours", "scipy")
    return rows


FILE = """
import sys, time, tracemalloc
import numpy as np
from coxeter.location import Grid
name, file, chunk, whole = sys.argv[1:]
grid, points = Grid(name), np.load(file, mmap_mode="r")
grid.locate(points[:100])
tracemalloc.start()
begin = time.perf_counter()
parts = [grid.locate(points)] if whole == "True" else grid.locate_chunks(points, int(chunk))
located = sum(len(found) for found in parts)
print(located, time.perf_counter() - begin, tracemalloc.get_traced_memory()[1])
"""


def from_file(n: int, chunk: int = 1 << 16) -> dict:
    """A file of points, in chunks: the most memory that is held at a time for what is computed."""
    name, d = "A~3", 3
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "points.npy"
        points = np.lib.format.open_memmap(file, mode="w+", dtype=np.float64, shape=(n, d))
        for i in range(0, n, 1 << 20):
            points[i : i + (1 << 20)] = points_in(d, min(1 << 20, n - i), seed=i)
        points.flush()
        size = file.stat().st_size
        row = {"name": name, "points": n, "chunk": chunk, "file_bytes": size, "bytes_a_point": 24 * (d + 1)}
        for how, whole in (("chunks", False), ("whole", True)):
            command = [sys.executable, "-c", FILE, name, str(file), str(chunk), str(whole)]
            out = subprocess.run(command, capture_output=True, text=True, check=True).stdout
            located, seconds, grown = out.split()
            assert int(located) == n
            row[how] = {"seconds": float(seconds), "bytes": int(grown)}
    print("file", row)
    return row


def on_dask(n: int, repeats: int, block: int = 1 << 16) -> dict:
    """A Dask array on two workers, processes of their own, against the same blocks on one."""
    try:
        import dask.array as da
        from distributed import Client, LocalCluster
    except ImportError:
        print("Dask is left out: it is not there")
        return {}
    grid = Grid("E~8")
    points = da.random.default_rng(0).normal(size=(n, 8), chunks=(block, 8)) * 10
    located = grid.locate(points)
    answer = da.stack([located.keys.sum(), located.open.sum()])
    os.sched_setaffinity(0, CORES)
    seconds, found = {}, {}
    for workers in (1, 2):
        with (
            LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster,
            Client(cluster),
        ):
            (seconds[workers],) = in_turn(repeats, clock(answer.compute, time.perf_counter))
            found[workers] = answer.compute().tolist()
    assert found[1] == found[2]
    row = {"name": "E~8", "points": n, "block": block, "one": seconds[1], "two": seconds[2]}
    row |= {"cores": len(CORES)}
    show("Dask", row, "one", "two")
    return row


# -- the run ------------------------------------------------------------


def show(what: str, row: dict, slow: str, fast: str) -> None:
    """A line on the way."""
    seconds = "  ".join(
        f"{k} {v['least']:.3f}/{v['median']:.3f} s" for k, v in row.items() if isinstance(v, dict)
    )
    ratio = row[slow]["median"] / row[fast]["median"]
    print(f"{what:<18} d={row.get('d', ''):<5} {seconds}   {slow}/{fast} {ratio:.2f}", flush=True)


def machine() -> dict:
    """What it ran on, without names."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        cpu = next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        cpu = platform.machine()
    return {
        "cpu": cpu,
        "cores": len(CORES),
        "system": platform.system(),
        "date": f"{datetime.now(UTC):%Y-%m-%d}",
    }


def versions() -> dict:
    """Of all that took part."""
    found = {"Python": platform.python_version()}
    for name in ("numpy", "numba", "scipy", "dask"):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not there"
    if not gudhi.missing():
        found |= gudhi.versions()
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer points and repeats: a minute, rough")
    parser.add_argument("-o", "--output", type=Path, help="where to write the results, as JSON")
    options = parser.parse_args()
    quick = options.quick
    n, repeats = (20_000, 3) if quick else (1_000_000, 7)
    os.sched_setaffinity(0, {max(CORES)})
    begin = time.perf_counter()
    results = {
        "machine": machine(),
        "versions": versions(),
        "settings": {"repeats": repeats, "quick": quick},
        "gudhi": against_gudhi(n, repeats),
        "families": families(n, repeats),
        "growth": growth(20_000 if quick else 1_000_000, repeats),
        "vertices": vertices(n // 10, repeats),
        "patches": patches(1_000 if quick else 20_000, 3),
        "file": from_file(n * 4),
        "dask": on_dask(n, 3),
    }
    print(f"{time.perf_counter() - begin:.0f} s")
    if options.output:
        options.output.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
