"""Run the project's checks one after the other; fail at the end if any of them failed."""

import argparse
import os
import shlex
import subprocess
import sys
import time
from pathlib import Path

from stages import Stages

CHECKS = {
    "format": "ruff format --check .",
    "lint": "ruff check .",
    "types": "mypy",
    "imports": "lint-imports",
    "ledger": "coxeter verify",
    "tests": "pytest -n 2",
    "notebooks": "pytest -n 2 --dist loadfile --nbval notebooks"
    " --nbval-sanitize-with tools/nbval_sanitize.cfg",
    "book": "python tools/build_book.py",
    "site": "python tools/check_site.py _build/html",
    "browser": "python tools/browse_site.py _build/html --factor 2",  # a shared machine is slower
}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("checks", nargs="*", help=f"some of {', '.join(CHECKS)}; default: all")
    parser.add_argument("--started", type=float, default=time.time(), help="when set-up began")
    options = parser.parse_args()

    # The tools are those beside this Python, whatever else is on the machine.
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environment = os.environ | {"PATH": path, "PYTHONUNBUFFERED": "1"}
    stages = Stages(options.started)
    failed = []
    for name in options.checks or CHECKS:
        with stages.stage(name, CHECKS[name]):
            if subprocess.run(shlex.split(CHECKS[name]), env=environment).returncode:
                failed.append(name)
    print(f"\n{stages.table()}\n")
    print(f"FAILED: {', '.join(failed)}" if failed else "All checks passed.")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
