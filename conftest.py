"""Shared by all tests, the examples in docstrings and prose included."""

from collections.abc import Iterator

import pytest

from coxeter.quality import MEASURES


@pytest.fixture(autouse=True)
def _measures_as_found() -> Iterator[None]:
    """A test or example may add a quality measure; the next one starts without it."""
    before = dict(MEASURES)
    yield
    MEASURES.clear()
    MEASURES.update(before)
