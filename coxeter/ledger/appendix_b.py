"""Appendix B: the proofs of Lemmas 4 and 5, inference by inference."""

from . import appendix_b_lemma_4, appendix_b_lemma_5

__all__ = ["appendix_b_lemma_4", "appendix_b_lemma_5"]
