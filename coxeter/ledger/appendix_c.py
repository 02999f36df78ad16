"""Appendix C: the protection of A~. `coxeter.proofs.appendix_c` has its statements for every d."""

from __future__ import annotations

from . import appendix_c_lemma_12, appendix_c_lemma_13, appendix_c_claim  # isort: skip  (in the paper's order)

__all__ = ["appendix_c_claim", "appendix_c_lemma_12", "appendix_c_lemma_13"]
