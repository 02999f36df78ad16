"""Settings of the property tests, and the ledgers on which views are tried.

``pytest`` tries the same examples each time. ``pytest --hypothesis-profile=search`` looks for new ones, and
for the smallest that fails.
"""

import shutil
import time

import pytest
from browse_chromium import ABSENT, find_chromium, one_chromium
from hypothesis import HealthCheck, Phase, settings
from run_notebooks import ROOT
from synthetic import GOOD

from coxeter.ledger.running import run
from coxeter.pages import Judged, Ledger, judge_all
from coxeter.pages.views import Views

COMMON = {"deadline": None, "suppress_health_check": [HealthCheck.too_slow], "database": None}

settings.register_profile(
    "quick", max_examples=30, derandomize=True, phases=[Phase.explicit, Phase.generate], **COMMON
)
settings.register_profile("search", max_examples=1000, derandomize=False, phases=list(Phase), **COMMON)
settings.load_profile("quick")


@pytest.fixture(scope="session")
def ledger() -> Ledger:
    """The paper's; of several test processes the first judges it, the others read what came out."""
    folder = ROOT / "_build" / "ledger"
    lock = folder / "lock"
    folder.mkdir(parents=True, exist_ok=True)
    started = time.time()
    while time.time() - started < 300:
        try:
            lock.mkdir()
        except FileExistsError:
            time.sleep(0.5)
        else:
            break
    try:
        return judge_all(folder)
    finally:
        shutil.rmtree(lock, ignore_errors=True)


@pytest.fixture(scope="session")
def views(ledger: Ledger) -> Views:
    return Views(ledger)


@pytest.fixture(scope="module")
def browser():
    if find_chromium() is None:
        pytest.skip(ABSENT)
    with one_chromium() as started:
        yield started


@pytest.fixture
def small() -> Views:
    """A ledger made up for the tests."""
    return Views(Ledger(tuple(Judged(x, run(x)) for x in GOOD)))
