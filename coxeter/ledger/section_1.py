"""The abstract and Section 1: what is promised, what others did, and what is conjectured."""

from __future__ import annotations

from . import (  # isort: skip  (in the order of the paper)
    section_1_abstract,
    section_1_definition,
    section_1_delaunay,
    section_1_others,
    section_1_space,
    section_1_contribution,
)

__all__ = [
    "section_1_abstract",
    "section_1_contribution",
    "section_1_definition",
    "section_1_delaunay",
    "section_1_others",
    "section_1_space",
]
