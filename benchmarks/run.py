"""What the exact core costs, and how the cost grows with the dimension. Prints one table.

    python benchmarks/run.py

Each figure is the least of several runs, every run in a fresh process, so that nothing is cached.
The peer is SymPy's `DomainMatrix` over the rationals with python-flint (see `peer.py`).
"""

import json
import math
import platform
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

HERE = Path(__file__).resolve().parent

MEASURE = """
import json, resource, sys, time
import coxeter
names = {names!r}
begin = time.perf_counter()
for name in names:
    simplex = coxeter.triangulation(name).simplex
    coxeter.qualities(simplex), coxeter.normalized_qualities(simplex)
seconds = time.perf_counter() - begin
print(json.dumps([seconds, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024]))
"""

IMPORT = """
import json, time
import numpy
begin = time.perf_counter()
import coxeter
print(json.dumps([time.perf_counter() - begin, 0]))
"""

PEER = """
import json, sys, time
sys.path.insert(0, {here!r})
import coxeter, peer, sympy
t = coxeter.triangulation({name!r})
roots = t.roots.simple_roots.numerators.tolist()
begin = time.perf_counter()
theirs = peer.qualities(roots, t.roots.marks)
seconds = time.perf_counter() - begin
ours = coxeter.qualities(t.simplex)
assert all(sympy.simplify(theirs[k] / ours[k].sympy() - 1) == 0 for k in theirs), "the numbers differ"
print(json.dumps([seconds, 0]))
"""


def least(code: str, runs: int) -> tuple[float, float]:
    """The least time and memory of several fresh processes."""
    results = []
    for _ in range(runs):
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
        if done.returncode:
            sys.exit(f"benchmark failed:\n{done.stderr}")
        results.append(json.loads(done.stdout))
    return min(t for t, _ in results), min(m for _, m in results)


def measure(names: list[str], runs: int = 3) -> tuple[float, float]:
    return least(MEASURE.format(names=names), runs)


def row(what: str, figure: str, bound: str) -> None:
    print(f"{what:<52}{figure:>14}   {bound}", flush=True)


def main() -> None:
    from coxeter.names import triangulations_up_to

    packages = ", ".join(f"{p} {version(p)}" for p in ("numpy", "python-flint", "sympy"))
    print(f"Python {platform.python_version()}, {packages}\n")
    row("from the simple roots to all measures", "measured", "wanted")
    row("-" * 50, "-" * 12, "-" * 12)
    row("import coxeter, after numpy", f"{least(IMPORT, 7)[0] * 1000:.0f} ms", "<= 150 ms")
    small = [kind.affine for kind in triangulations_up_to(8)]
    row(f"all {len(small)} triangulations with d <= 8", f"{measure(small, 5)[0] * 1000:.0f} ms", "<= 500 ms")
    ours = measure(["B~100"], 5)[0]
    row("B~100", f"{ours * 1000:.0f} ms", "<= 50 ms")
    theirs = least(PEER.format(here=str(HERE), name="B~100"), 1)[0]
    row(
        "B~100 in SymPy with python-flint",
        f"{theirs * 1000:.0f} ms",
        f"ours is {theirs / ours:.0f} times faster",
    )
    for letter in "ABCD":
        quarter, _ = measure([f"{letter}~250"])
        full, memory = measure([f"{letter}~1000"])
        row(f"{letter}~1000", f"{full:.2f} s", "<= 1 s")
        row(f"{letter}~1000, whole process", f"{memory:.0f} MB", "<= 500 MB")
        row(f"{letter}~250 to {letter}~1000: grows like d^", f"{math.log(full / quarter, 4):.2f}", "<= 2.3")


if __name__ == "__main__":
    main()
