"""Appendix A: the regular simplex is best."""

from __future__ import annotations

from . import (  # isort: skip  (in the order of the paper)
    appendix_a_radii,
    appendix_a_distances,
    appendix_a_jung,
    appendix_a_thickness,
    appendix_a_fatness,
)

__all__ = [
    "appendix_a_distances",
    "appendix_a_fatness",
    "appendix_a_jung",
    "appendix_a_radii",
    "appendix_a_thickness",
]
