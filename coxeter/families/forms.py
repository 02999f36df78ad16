r"""The closed forms themselves, as text.

Lengths are in the scale of Theorem 3's simple roots. Where the forms come from: the height from vertex
k is 1/(m_k·|s_k|), with m_k the mark and s_k the simple root of node k (for node 0: 1 and the highest
root). Hence  h = 1/max m_k|s_k|,  r = 1/Σ m_k|s_k|,  vol = 1/(d!·Π m_k·√(det of the Gram matrix)).
R is the distance of the origin from the circumcentre, L the longest of the edges  |u_j - u_k|.

=========  =======================================  ========================  ====================
family     marks 1, m_1 … m_d                       squared lengths, node 0…  Gram determinant
=========  =======================================  ========================  ====================
A~         all 1                                    all 2                     d + 1
B~         1, 1, then 2 (d - 1 times)               2, but 1 for node d       1
C~         1, then 2 (d - 1 times), 1               4, then 2, 4 for node d   4
D~         1, 1, then 2 (d - 3 times), 1, 1         all 2                     4
E~6        1, 1, 2, 2, 3, 2, 1                      all 2                     3
E~7        1, 2, 2, 3, 4, 3, 2, 1                   all 2                     2
E~8        1, 2, 3, 4, 6, 5, 4, 3, 2                all 2                     1
F~4        1, 2, 3, 4, 2                            2, 2, 2, 1, 1             1/4
G~2        1, 3, 2                                  6, 2, 6                   3
=========  =======================================  ========================  ====================
"""

from __future__ import annotations

from ..names import FAMILIES
from .reading import evaluate

LENGTHS = ("minimal_height", "longest_edge", "inradius", "circumradius", "volume")
MEASURES = ("aspect_ratio", "fatness", "thickness", "radius_ratio")
NORMALIZED = tuple(f"normalized_{name}" for name in MEASURES)

Text = str | tuple[str, str]
FORMS: dict[str, dict[str, Text]] = {}
"""Family -> quantity -> formula: one, for A~ those for odd and even d, for B~ those for d = 3 and d >= 4."""

FORMS["A"] = {
    "minimal_height": "1/sqrt(2)",
    "longest_edge": ("sqrt(d + 1)/2", "sqrt(d*(d + 2)/(d + 1))/2"),  # from u_0 to u_k, k = ⌈d/2⌉
    "inradius": "1/(sqrt(2)*(d + 1))",
    "circumradius": "sqrt(d*(d + 2)/(12*(d + 1)))",
    "volume": "1/(sqrt(d + 1)*factorial(d))",
    # the nearest other vertices are at squared distance R² + 4·h²/(d + 1) = R² + 2/(d + 1)
    "relative_protection": "sqrt(1 + 24/(d*(d + 2))) - 1",
    "aspect_ratio": "sqrt(3*(d + 1)/(2*d*(d + 2)))",
    "fatness": (
        "2**d/((d + 1)**((d + 1)/2)*factorial(d))",
        "2**d*(d + 1)**((d - 1)/2)/((d*(d + 2))**(d/2)*factorial(d))",
    ),
    "thickness": ("sqrt(2/(d + 1))", "sqrt(2*(d + 1)/(d*(d + 2)))"),
    "radius_ratio": "sqrt(6/(d*(d + 1)*(d + 2)))",
    "normalized_aspect_ratio": "sqrt(6*d/((d + 1)*(d + 2)))",
    "normalized_fatness": (
        "2**(3/2)/(d + 1)**(1/2 + 1/d)",
        "2**(3/2)*(d + 1)**(1/2 - 1/d)/sqrt(d*(d + 2))",
    ),
    "normalized_thickness": ("2*sqrt(d)/(d + 1)", "2/sqrt(d + 2)"),
    "normalized_radius_ratio": "sqrt(6*d/((d + 1)*(d + 2)))",
}
FORMS["B"] = {
    "minimal_height": "1/(2*sqrt(2))",
    "longest_edge": ("1", "sqrt(d)/2"),  # for d = 3 the edge from u_0 to u_1 is longer than that to u_d
    "inradius": "1/(2*(1 + (d - 1)*sqrt(2)))",
    "circumradius": "sqrt(d + 2)/4",
    "volume": "1/(2**(d - 1)*factorial(d))",
    "relative_protection": "0",
    "aspect_ratio": "1/sqrt(2*(d + 2))",
    "fatness": ("1/24", "2/(d**(d/2)*factorial(d))"),
    "thickness": ("1/(2*sqrt(2))", "1/sqrt(2*d)"),
    "radius_ratio": "2/(sqrt(d + 2)*(1 + (d - 1)*sqrt(2)))",
    "normalized_aspect_ratio": "sqrt(2)*d/((d + 1)*sqrt(d + 2))",
    "normalized_fatness": ("1/sqrt(2)", "2**(1/2 + 1/d)/(sqrt(d)*(d + 1)**(1/(2*d)))"),
    "normalized_thickness": ("sqrt(3)/4", "1/sqrt(d + 1)"),
    "normalized_radius_ratio": "2*d/(sqrt(d + 2)*(1 + (d - 1)*sqrt(2)))",
}
FORMS["C"] = {
    "minimal_height": "1/(2*sqrt(2))",
    "longest_edge": "sqrt(d)/2",
    "inradius": "1/(2*(2 + (d - 1)*sqrt(2)))",
    "circumradius": "sqrt(d)/4",
    "volume": "1/(2**d*factorial(d))",
    "relative_protection": "0",
    "aspect_ratio": "1/sqrt(2*d)",
    "fatness": "1/(d**(d/2)*factorial(d))",
    "thickness": "1/sqrt(2*d)",
    "radius_ratio": "2/(sqrt(d)*(2 + (d - 1)*sqrt(2)))",
    "normalized_aspect_ratio": "sqrt(2*d)/(d + 1)",
    "normalized_fatness": "sqrt(2)/(sqrt(d)*(d + 1)**(1/(2*d)))",
    "normalized_thickness": "1/sqrt(d + 1)",
    "normalized_radius_ratio": "2*sqrt(d)/(2 + (d - 1)*sqrt(2))",
}
FORMS["D"] = {
    "minimal_height": "1/(2*sqrt(2))",
    "longest_edge": "sqrt(d)/2",
    "inradius": "1/(2*sqrt(2)*(d - 1))",
    "circumradius": "sqrt(d + 4)/4",
    "volume": "1/(2**(d - 2)*factorial(d))",
    "relative_protection": "0",
    "aspect_ratio": "1/sqrt(2*(d + 4))",
    "fatness": "4/(d**(d/2)*factorial(d))",
    "thickness": "1/sqrt(2*d)",
    "radius_ratio": "sqrt(2)/((d - 1)*sqrt(d + 4))",
    "normalized_aspect_ratio": "sqrt(2)*d/((d + 1)*sqrt(d + 4))",
    "normalized_fatness": "2**(1/2 + 2/d)/(sqrt(d)*(d + 1)**(1/(2*d)))",
    "normalized_thickness": "1/sqrt(d + 1)",
    "normalized_radius_ratio": "sqrt(2)*d/((d - 1)*sqrt(d + 4))",
}
FORMS["regular"] = {
    "minimal_height": "sqrt((d + 1)/d)",
    "longest_edge": "sqrt(2)",
    "inradius": "1/sqrt(d*(d + 1))",
    "circumradius": "sqrt(d/(d + 1))",
    "volume": "sqrt(d + 1)/factorial(d)",
    "aspect_ratio": "(d + 1)/(2*d)",
    "fatness": "sqrt((d + 1)/2**d)/factorial(d)",
    "thickness": "sqrt((d + 1)/(2*d))",
    "radius_ratio": "1/d",
    **dict.fromkeys(NORMALIZED, "1"),
}


def _single(d: int, h: str, longest: str, r: str, circumradius: str, volume: str) -> dict[str, Text]:
    """The forms of a single triangulation: the measures follow from the lengths by Definition 18."""
    texts = dict(zip(LENGTHS, (h, longest, r, circumradius, volume), strict=True))
    height, edge, inradius, radius, vol = (evaluate(text) for text in texts.values())
    raw = (height / (2 * radius), vol / edge**d, height / edge, inradius / radius)
    regular = {name: evaluate(str(FORMS["regular"][name]), d=d) for name in MEASURES}
    ratio = {name: x / regular[name] for name, x in zip(MEASURES, raw, strict=True)}
    ratio["fatness"] = ratio["fatness"].root(d)
    measures = dict(zip((*MEASURES, *NORMALIZED), map(str, (*raw, *ratio.values())), strict=True))
    return {**texts, "relative_protection": "0", **measures}


FORMS["E6"] = _single(6, "sqrt(2)/6", "2/sqrt(3)", "1/(12*sqrt(2))", "1/sqrt(2)", "sqrt(3)/51840")
FORMS["E7"] = _single(7, "sqrt(2)/8", "sqrt(3/2)", "1/(18*sqrt(2))", "sqrt(26)/8", "sqrt(2)/2903040")
FORMS["E8"] = _single(8, "sqrt(2)/12", "1", "1/(30*sqrt(2))", "sqrt(38)/12", "1/696729600")
FORMS["F4"] = _single(4, "sqrt(2)/6", "1", "1/(6 + 6*sqrt(2))", "1/2", "1/576")
FORMS["G2"] = _single(2, "1/(2*sqrt(6))", "sqrt(2)/3", "1/(3*sqrt(2) + 3*sqrt(6))", "sqrt(2)/6", "sqrt(3)/36")
FORMS = {family: FORMS[family] for family in (*FAMILIES, "regular")}
