"""GUDHI's point location in C++: compiled from `gudhi_locate.cpp` where its headers and a compiler are."""

import shutil
import subprocess
from pathlib import Path

import numpy as np

from coxeter.location import Grid

SOURCE = Path(__file__).with_name("gudhi_locate.cpp")
INCLUDES = [Path("/usr/include"), Path("/usr/local/include")]


def missing() -> str:
    """What is missing to compile it, if anything."""
    wanted = {"gudhi/Coxeter_triangulation.h": "GUDHI's headers", "eigen3/Eigen/Core": "Eigen's headers"}
    lacks = [what for name, what in wanted.items() if not any((at / name).exists() for at in INCLUDES)]
    if not shutil.which("g++"):
        lacks.append("g++")
    return " and ".join(lacks)


def compiled(folder: Path) -> Path:
    """The program, optimised, in a folder."""
    program = folder / "gudhi_locate"
    includes = [f"-I{at / 'eigen3'}" for at in INCLUDES]
    subprocess.run(["g++", "-O3", "-DNDEBUG", "-std=c++17", *includes, SOURCE, "-o", program], check=True)
    return program


def run(program: Path, what: str, points: np.ndarray, folder: Path) -> bytes:
    """Run it on points: ``time`` or ``vertices``."""
    file = folder / f"points-{points.shape[0]}-{points.shape[1]}"
    if not file.exists() or what != "time":
        points.tofile(file)
    n, d = points.shape
    return subprocess.run([program, what, str(d), str(n), file], capture_output=True, check=True).stdout


def vertices(program: Path, points: np.ndarray, folder: Path) -> np.ndarray:
    """The vertices (n, d + 1, d) of the simplices that hold points, after GUDHI."""
    n, d = points.shape
    return np.frombuffer(run(program, "vertices", points, folder)).reshape(n, d + 1, d)


def same_grid(program: Path, d: int, folder: Path) -> Grid:
    """Our grid that has the same simplices.

    GUDHI lists the vertices of a simplex in the cyclic order of their labels, so the isometry that carries
    one of our simplices to one of theirs carries all simplices to theirs. Their edges are sqrt(2) times
    ours.
    """
    theirs = vertices(program, np.full((1, d), 0.1234) ** np.arange(1, d + 1), folder)[0]
    ours = Grid(f"A~{d}").locate(np.full((1, d), 0.01)).vertices[0] * np.sqrt(2)
    linear = np.linalg.solve(ours[1:] - ours[0], theirs[1:] - theirs[0]).T
    return Grid(f"A~{d}", scale=float(np.sqrt(2)), rotation=linear)


def versions() -> dict[str, str]:
    """Of the compiler and of GUDHI, as its headers or the system's packages tell."""
    compiler = subprocess.run(
        ["g++", "-dumpfullversion"], capture_output=True, text=True, check=True
    ).stdout.strip()
    asked = subprocess.run(
        ["dpkg-query", "-W", "-f=${Version}", "libgudhi-dev"], capture_output=True, text=True
    )
    return {"g++": f"{compiler} -O3", "GUDHI": asked.stdout.strip() or "unknown"}
