"""The common steps of the proofs of Propositions 8 to 14 in words."""

from __future__ import annotations

from .claim import Constants

WORDS = {
    "criterion": "A point of a space of dimension {space} is a vertex of the triangulation if and only if "
    "the positive roots that have an integer inner product with it contain {rank} independent ones.",
    "roots": "The positive roots are exactly",
    "witness": "The combination {terms:sum} of vertices is the vector v = ({vector}).",
    "integral-roots": "The positive roots that have an integer inner product with v are exactly",
    "span": "The roots listed as having integer inner products with v span a space of dimension {dimension}, "
    "that of",
    "no-vertex": "The vector v = ({vector}) is {vertex?a|no} vertex.",
}
"""What the steps say; lists follow."""
LISTS = {
    "single": "$e_i$ for {single:i}",
    "single_in": "$e_i$ for i = {single_in}",
    "double": "$2e_i$ for {double:i}",
    "minus": "$e_i-e_j$ for {minus:i<j}",
    "turned": "$e_j-e_i$ for {turned:i<j}",
    "turned_in": "$e_j-e_i$ for i < j among {turned_in}",
    "plus": "$e_i+e_j$ for {plus:i<j}",
    "plus_in": "$e_i+e_j$ for i < j among {plus_in}",
    "both": r"$e_i\pm e_j$ for {both:i<j}",
    "half_signs": r"half the sums of {half_fixed:signed} and all $\pm e_i$ for {half_signs:i}",
    "half_rest": r"in these an {half_rest?odd|even} number of the signs $\pm$ is minus",
    "further": "{further:signed}",
    "without": "nowhere is i or j equal to {without}",
}


def in_words(step: str, constants: Constants) -> str:
    """What a step says, with the parts of its list."""
    parts = [text for name, text in LISTS.items() if constants.get(name, ()) != ()]
    return f"{WORDS[step]} {'; '.join(parts)}." if parts else WORDS[step]
