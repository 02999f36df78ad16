"""Section 2: graphs and what they generate, root systems, lattices, and affine Weyl groups."""

from __future__ import annotations

from . import (  # isort: skip  (in the order of the paper)
    section_2_graphs,
    section_2_vectors,
    section_2_roots,
    section_2_simple_roots,
    section_2_angles,
    section_2_diagrams,
    section_2_classification,
    section_2_lattices,
    section_2_affine,
    section_2_triangulations,
    sources,
)

__all__ = [
    "section_2_affine",
    "section_2_angles",
    "section_2_classification",
    "section_2_diagrams",
    "section_2_graphs",
    "section_2_lattices",
    "section_2_roots",
    "section_2_simple_roots",
    "section_2_triangulations",
    "section_2_vectors",
    "sources",
]
