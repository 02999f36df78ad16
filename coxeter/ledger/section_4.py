"""Section 4: when a monohedral triangulation is Delaunay, and when it is protected."""

from . import section_4_basics, section_4_criterion, section_4_protection, section_4_theorem_7

__all__ = ["section_4_basics", "section_4_criterion", "section_4_protection", "section_4_theorem_7"]
