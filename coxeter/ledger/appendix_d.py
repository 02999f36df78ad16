"""Appendix D: the volume of A~, and which vertex sets are lattices."""

from __future__ import annotations

from . import (  # isort: skip  (in the order of the paper)
    appendix_d_volume,
    appendix_d_coweights,
    appendix_d_b_c,
    appendix_d_d,
    appendix_d_exceptional,
)

__all__ = [
    "appendix_d_b_c",
    "appendix_d_coweights",
    "appendix_d_d",
    "appendix_d_exceptional",
    "appendix_d_volume",
]
