"""A~ is the best family in every dimension, by each of the four measures. Paper: Section 5.

Squares are compared, as rational functions of d over QQ(√2); for fatness 2d-th powers, with an induction.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..affine import triangulation
from ..exact import Surd
from ..families import Piece, closed_form
from ..names import EXCEPTIONAL, MINIMAL_DIMENSION, triangulations_up_to
from ..quality import find_measure
from ..symbolic.cases import case
from .proof import Proof, ReplayFailed, Step, argument, computed, formulas, inequality, join

SQUARES = {
    "aspect_ratio": {
        "A": ("6*d/((d + 1)*(d + 2))",) * 2,
        "B": "2*d**2/((d + 1)**2*(d + 2))",
        "C": "2*d/(d + 1)**2",
        "D": "2*d**2/((d + 1)**2*(d + 4))",
    },
    "thickness": {
        "A": ("4*d/(d + 1)**2", "4/(d + 2)"),
        "B": "1/(d + 1)",
        "C": "1/(d + 1)",
        "D": "1/(d + 1)",
    },
    "radius_ratio": {
        "A": ("6*d/((d + 1)*(d + 2))",) * 2,
        "B": "4*d**2/((d + 2)*(1 + (d - 1)*sqrt(2))**2)",
        "C": "4*d/(2 + (d - 1)*sqrt(2))**2",
        "D": "2*d**2/((d - 1)**2*(d + 4))",
    },
}
"""The squares of the normalised measures; for A~ for odd and for even d."""

LEAD = {"B": ("4", 3, "1"), "C": ("1", 2, "0"), "D": ("16", 4, "2")}
"""For the fatness of a family: its factor beside that of C~, the first d, and its power of 4."""


def best(measure: str) -> Proof:
    """A~ has a greater normalised value than each other family, in every dimension."""
    name = measure.replace("_", " ")
    return join(
        rf"$\tilde A_d$ has the greatest {name} of all Coxeter triangulations of $\mathbb{{R}}^d$, "
        r"for every $d \geq 2$",
        _by_induction() if measure == "fatness" else _by_squares(measure),
        computed(
            "and the exceptional types, one by one", r"\hat\kappa(\tilde A_d) > \hat\kappa(\tilde X_d)",
            r"X \in \{E_6, E_7, E_8, F_4, G_2\}",
            lambda: sum(_is_beaten(x, d, measure) for x, ranks in EXCEPTIONAL.items() for d in ranks),
        ),
    )  # fmt: skip


def _by_squares(measure: str) -> Iterator[Step]:
    name = f"normalized_{measure}"
    squares = SQUARES[measure]
    by_parity = tuple(zip(("odd", "even"), squares["A"], strict=True))
    for piece in closed_form("A", name).pieces:
        for parity, square in by_parity:
            if piece.parity in (None, parity):
                yield _square("A", piece, square, parity)
    for letter in "BCD":
        piece, its_square = closed_form(letter, name).pieces[-1], str(squares[letter])
        yield _square(letter, piece, its_square, piece.parity or "")
        low = MINIMAL_DIMENSION[letter]
        for parity, square in by_parity:
            yield inequality(
                rf"$\tilde A_d$ against $\tilde {letter}_d$, {parity} $d$",
                rf"\hat\kappa(\tilde A_d)^2 - \hat\kappa(\tilde {letter}_d)^2",
                f"{square} - {its_square}", case(f"{low} <= d", low), strict=True,
            )  # fmt: skip
    if measure == "thickness":
        yield _b3(measure)


def _square(letter: str, piece: Piece, square: str, parity: str) -> Step:
    words = rf"the square for $\tilde {letter}_d$"
    return formulas(words, r"\hat\kappa^2", f"({piece.text})**2", square, piece.low, parity)


def _by_induction() -> Iterator[Step]:
    odd, even = closed_form("A", "normalized_fatness").pieces
    of_a, power = r"\hat\Theta(\tilde A_d)^2", "2**(3*d)/(d + 1)**(d + 2)"
    more = "((d + 1)**2/(d*(d + 2)))**d"
    yield formulas("odd $d$", of_a, f"({odd.text})**(2*d)", power, 3, "odd")
    yield formulas("even $d$", of_a, f"({even.text})**(2*d)", f"{power}*{more}", 2, "even")
    yield inequality(
        "for even $d$ the last factor is at least 1", "(d+1)^2 - d(d+2)", "(d + 1)**2 - d*(d + 2)",
        "2 <= d", strict=True,
    )  # fmt: skip
    yield argument(
        r"By the binomial theorem $(1 + \tfrac1d)^d \leq \sum \tfrac{1}{i!} < 1 + 1 + \tfrac12 + \tfrac14 + "
        r"\dots = 3$"
    )
    for letter, (factor, low, shift) in LEAD.items():
        text = closed_form(letter, "normalized_fatness").pieces[-1].text
        other, square = rf"\hat\Theta(\tilde {letter}_d)^2", f"{factor}*2**d/(d**d*(d + 1))"
        yield formulas(rf"$\tilde {letter}_d$", other, f"({text})**(2*d)", square, low)
        yield formulas(
            "the quotient", rf"\frac{{{of_a}}}{{{other}}} \geq q", f"{power}/({square})",
            f"4**(d - {shift})*(d/(d + 1))**d/(d + 1)", low,
        )  # fmt: skip
        yield argument(rf"So the quotient is greater than $f(d) = 4^{{d - {shift}}} / (3(d+1))$")
        yield inequality(
            "it is more than 1 for the first $d$", f"f({low}) - 1",
            f"4**({low} - {shift})/(3*({low} + 1)) - 1", f"{low} == d", strict=True,
        )  # fmt: skip
        quotient = "4*(d + 1)/(d + 2)"
        yield formulas(
            "its growth", r"\frac{f(d+1)}{f(d)}",
            f"(4**(d + 1 - {shift})/(3*(d + 2)))/(4**(d - {shift})/(3*(d + 1)))", quotient, low,
        )  # fmt: skip
        yield inequality(
            "is more than 1", r"\frac{f(d+1)}{f(d)} - 1", f"{quotient} - 1", f"{low} <= d", strict=True,
        )  # fmt: skip
    yield _b3("fatness")


def _b3(measure: str) -> Step:
    """B~3 has a formula of its own."""
    _is_beaten("B", 3, measure)
    formula = r"\hat\kappa(\tilde A_3) > \hat\kappa(\tilde B_3)"
    words = r"the exceptional value of $\tilde B_3$"
    return computed(words, formula, "d = 3", lambda: _is_beaten("B", 3, measure))


def _is_beaten(letter: str, d: int, measure: str) -> int:
    """1, as A~ has a greater value in this dimension; else an error."""
    a, x = (_value(measure, (name, d)) for name in ("A", letter))
    if a <= x:
        raise ReplayFailed(f"{measure}: A~{d} has {a}, {letter}~{d} has {x}")
    return 1


def _value(measure: str, name: object) -> Surd:
    value: Surd = find_measure(measure).normalized(triangulation(name).simplex)
    return value


def ranking(measure: str, d: int) -> list[str]:
    """The triangulations of a dimension, the best first."""
    types = [kind.affine for kind in triangulations_up_to(d) if kind.rank == d]
    return sorted(types, key=lambda name: _value(measure, name), reverse=True)
