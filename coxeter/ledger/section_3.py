"""Section 3: the quality measures, the regular simplex, and protection."""

from . import section_3_measures, section_3_protection

__all__ = ["section_3_measures", "section_3_protection"]
