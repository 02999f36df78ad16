"""What there is to say of the common steps of the proofs of Propositions 8 to 14."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

RANK = (
    "A vertex lies on the $d$ hyperplanes of the facets of a simplex that meet in it; their normals are "
    "independent roots. Conversely a point where hyperplanes with $d$ independent normals meet is a face "
    "of the arrangement, so a vertex (Corollary 1). A point lies on a hyperplane $H_{r,k}$ if and only if "
    "its inner product with $r$ is the integer $k$.",
)

_SPACE = (
    "The point has to lie in the space that the roots span, whose dimension is the rank; the vectors to "
    "which the criterion is applied do."
)

NOTES: dict[str, Mapping[str, Any]] = {
    "prop-11.criterion": {"correction": _SPACE, "constants": {"rank": 6, "space": 6}},
    "prop-12.criterion": {"correction": _SPACE, "constants": {"rank": 7, "space": 7}},
    "prop-11.witness": {
        "constants": {
            "terms": (("-2", "1"), ("3", "2"), ("3", "3"), ("-2", "4")),
            "vector": (("0", "1"), ("3/2", "1"), ("5/6", "3"), ("0", "3")),
        },
    },
    "prop-12.roots": {
        "correction": "The root $e_8-e_7$ is missing.",
        "constants": {
            "turned": (1, 6),
            "plus": (1, 6),
            "half_fixed": (8, -7),
            "half_signs": (1, 6),
            "half_rest": 1,
            "further": ((8, -7),),
        },
        "evidence": "It is the highest root of $E_7$, and facet 0 of the triangulation is printed with it, "
        "up to the sign, in Section 6.",
    },
    "prop-12.witness": {
        "correction": "With $-u_1$ in place of $-6u_1$ the combination is $-e_2$, which serves as well as "
        "$e_2$, as the vertex set is symmetric about the origin; with all signs changed it is $e_2$.",
        "constants": {
            "terms": (("-1", "1"), ("2", "2"), ("3", "3"), ("-4", "4")),
            "vector": (("0", "1"), ("-1", "1"), ("0", "6")),
        },
        "evidence": "The last coordinates of $u_1,\\dots,u_4$ agree, so the coefficients must add up to 0. "
        "The sign is due to the printed simplex, which is the mirror image in the origin of that of the "
        "simple roots in Theorem 3.",
    },
    "prop-12.integral-roots": {
        "correction": "The root $e_8-e_7$, which is orthogonal to $e_2$, is missing.",
        "constants": {"turned": (1, 6), "plus": (1, 6), "further": ((8, -7),)},
    },
    "prop-12.no-vertex": {
        "correction": "The vector is a vertex, and proves nothing. The difference $u_2-u_1$ is none.",
    },
    "prop-13.roots": {
        "correction": r"The roots $e_8\pm e_i$ are missing: the indices i < j run to 8.",
        "constants": {
            "turned": (1, 8),
            "plus": (1, 8),
            "half_fixed": (8,),
            "half_signs": (1, 7),
            "half_rest": 0,
            "further": (),
        },
        "evidence": "The highest root $e_7+e_8$, with which facet 0 is printed in Section 6, is among the "
        "missing.",
    },
    "prop-13.integral-roots": {
        "correction": r"The roots $e_8\pm e_i$ are missing.",
        "constants": {"turned": (1, 8), "plus": (1, 8)},
    },
    "prop-13.no-vertex": {
        "correction": "The vector is a vertex, an image of $u_1=e_8$, and proves nothing. The difference "
        "$u_2-u_1$ is none.",
    },
}
"""Corrections by the id of the claim, and the constants with which it holds."""

_SIGNED = (
    "Reflections in the simple roots permute the coordinates and change their signs{}; the images of {} are "
    "{}. Positive is the one of each pair whose first coordinate other than 0 is positive."
)

DERIVATIONS: dict[str, tuple[str, ...]] = {
    "prop-8.roots": (
        _SIGNED.format("", "$e_d$ and $e_1-e_2$", r"the $\pm e_i$ and $\pm e_i\pm e_j$, each once"),
        r"That makes $d+2\binom d2=d^2$ positive roots.",
    ),
    "prop-9.roots": (
        _SIGNED.format("", "$2e_d$ and $e_1-e_2$", r"the $\pm 2e_i$ and $\pm e_i\pm e_j$, each once"),
        r"That makes $d+2\binom d2=d^2$ positive roots.",
    ),
    "prop-10.roots": (
        _SIGNED.format(", an even number of them at a time", "$e_1-e_2$", r"the $\pm e_i\pm e_j$, each once"),
        r"That makes $2\binom d2=d(d-1)$ positive roots.",
    ),
    "prop-8.witness": (
        r"$u_d$ and $u_{d-1}$, with $d-1\ge2$, begin with $d$ and $d-1$ coordinates $\frac12$.",
    ),
    "prop-10.witness": (r"$u_3=(\frac12^{\{3\}},0^{\{d-3\}})$ as $3\le d-2$, and $u_2$ likewise.",),
    "prop-8.integral-roots": (
        r"$\langle\frac12e_d,r\rangle=\frac12r_d$ is an integer if and only if $r_d$ is even; as $r_d$ is "
        "0, 1 or -1 for every root, the roots are those without $e_d$.",
    ),
    "prop-10.integral-roots": (
        r"$\langle\frac12e_3,r\rangle=\frac12r_3$ is an integer if and only if $r_3$ is even; as $r_3$ is "
        "0, 1 or -1 for every root, the roots are those without $e_3$.",
    ),
    "prop-8.span": (r"All lie in the space of the $e_i$ with $i\ne d$, and the $e_i$ are among them.",),
    "prop-10.span": (
        r"All lie in the space of the $e_i$ with $i\ne3$, and $2e_i=(e_i+e_j)+(e_i-e_j)$ up to the order "
        "of i and j.",
    ),
    "prop-8.no-vertex": (r"The rank is $d-1$ for every d, by the list and its span.",),
    "prop-10.no-vertex": (r"The rank is $d-1$ for every d, by the list and its span.",),
}
"""How it is known for every d."""
