"""Where the paper sends its readers: sections of a book that do not have what is quoted from them."""

from __future__ import annotations

from functools import partial

from .claim import Constants, Finding, agree, claim
from .vocabulary import LITERATURE, Weight

HUMPHREYS = {
    "thm-1.source": (
        "Section 2.1, Theorem 1",
        "6.4",
        "1.3 is on positive and simple systems; 6.4 on finite Coxeter groups",
    ),
    "prop-1.source": (
        "Section 2.1, Proposition 1",
        "",
        "1.8 has simple transitivity on sets of simple roots, which is Lemma 1",
    ),
    "sec2.graphs-source": (
        "Section 2.1, after Proposition 1",
        "2.7",
        "2.4 has the list of graphs, 2.7 the classification",
    ),
    "prop-6.source": ("Section 2.4, Proposition 6", "4.5", "4.3 has transitivity, 4.5 that it is simple"),
}
"""For each reference: its place, the right section (empty if there is none), and what these sections have."""


def judge_source(right: str, reason: str, printed: Constants) -> Finding:
    """Whether the section that is quoted has the statement, by the book's table of contents."""
    return agree(
        printed, {"section": right or "none"}, LITERATURE, evidence=f"{reason} (from the book's contents)"
    )


for _id, (_place, _right, _reason) in HUMPHREYS.items():
    claim(
        _id, _place, Weight.WORDING, words="The statement is found in Section {section} of Humphreys' book."
    )(partial(judge_source, _right, _reason))
