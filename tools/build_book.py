"""Judge the claims, execute the notebooks, then render the book. Any warning is an error."""

import argparse
import hashlib
import shutil
import sys
import time

from jupyter_book.sphinx import build_sphinx
from run_notebooks import ROOT, cache_into, run_all
from sphinx.util.console import nocolor
from stages import Stages

from coxeter.ledger.reporting import score
from coxeter.pages import judge_all

BUILD = ROOT / "_build"


def library_key() -> str:
    """A hash of all that the outputs rest on, beside the notebooks: the library and the lock."""
    digest = hashlib.sha256((ROOT / "requirements.lock").read_bytes())
    for path in sorted((ROOT / "coxeter").rglob("*")):
        if path.is_file() and "__pycache__" not in path.parts:
            digest.update(path.relative_to(ROOT).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def judge() -> bool:
    """Judge all claims, from which the pages are made; say what is amiss, and whether nothing is."""
    results = [x.result for x in judge_all(BUILD / "ledger")]
    troubles = [f"{x.id}: {x.trouble}" for x in results if x.trouble]
    troubles += [f"{x.id}: this mutant is not rejected: {what}" for x in results for what in x.survivors]
    print("\n".join([*troubles, f"  {len(results)} claims; {score(results)}"]), flush=True)
    return not troubles


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--started", type=float, default=time.time(), help="when set-up began")
    parser.add_argument("--reuse", action="store_true", help="keep what is still valid")
    options = parser.parse_args()

    if not options.reuse:
        shutil.rmtree(BUILD, ignore_errors=True)
    if not sys.stdout.isatty():
        nocolor()
    stages = Stages(options.started)
    with stages.stage("claims", "judge them"):
        if not judge():
            return 1
    cache = BUILD / "notebooks" / library_key()
    with stages.stage("notebooks", "execute them"):
        if run_all(cache_into(cache)):
            return 1
    with stages.stage("pages", "render them"):
        status = build_sphinx(
            ROOT,
            BUILD / "html",
            path_config=ROOT / "_config.yml",
            noconfig=True,  # there is no conf.py
            confoverrides={
                "external_toc_path": "_toc.yml",
                "latex_individualpages": False,
                "nb_execution_mode": "cache",
                "nb_execution_cache_path": str(cache),
            },
            warningiserror=True,
            keep_going=True,
        )
    if status:
        print(f"\nThe book was not built: {status}", file=sys.stderr)
        return 1
    page = (BUILD / "html/index.html").relative_to(ROOT)
    print(f"\n{stages.table()}\n\nThe book is ready: open {page}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
