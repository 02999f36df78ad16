"""The common steps of the proofs of Propositions 8 to 14 in words."""

from __future__ import annotations

from .claim import Constants

WORDS = {
    "criterion": "A point of a space of dimension {space} is a vertex of the triangulation if and only if "
    "the positive roots that have an integer inner product with it contain {rank} independent ones.",
    "roots": "The positive roots are exactly",
    "witness": "The sum of multiples of vertices with the pairs (coefficient, index) {terms} is the vector v "
    "with the runs of coordinates {vector}.",
    "integral-roots": "The positive roots that have an integer inner product with v are exactly",
    "span": "The roots listed as having integer inner products with v span a space of dimension {dimension}, "
    "that of",
    "no-vertex": "The vector v with the runs of coordinates {vector} is a vertex: {vertex}.",
}
"""What the steps say; lists follow."""
LISTS = {
    "single": "$e_i$ for i in the range ({single})",
    "single_in": "$e_i$ for i in ({single_in})",
    "double": "$2e_i$ for i in the range ({double})",
    "minus": "$e_i-e_j$ for i < j in the range ({minus})",
    "turned": "$e_j-e_i$ for i < j in the range ({turned})",
    "turned_in": "$e_j-e_i$ for i < j in ({turned_in})",
    "plus": "$e_i+e_j$ for i < j in the range ({plus})",
    "plus_in": "$e_i+e_j$ for i < j in ({plus_in})",
    "both": r"$e_i\pm e_j$ for i < j in the range ({both})",
    "half_signs": r"half the sums of the $\pm e_i$ for i in the range ({half_signs}) with the signed indices "
    "{half_fixed}",
    "half_rest": "in these a number of minus signs that is {half_rest} modulo 2",
    "further": "the vectors with the signed indices {further}",
    "without": "in all of these i and j are not {without}",
}


def in_words(step: str, constants: Constants) -> str:
    """What a step says, with the parts of its list."""
    parts = [text for name, text in LISTS.items() if constants.get(name, ()) != ()]
    return f"{WORDS[step]} {'; '.join(parts)}." if parts else WORDS[step]
