"""A~ is the best family in every dimension, by each of the four measures. Paper: Section 5.

Squares are compared, as rational functions of d over QQ(√2); for fatness 2d-th powers, with an induction.
"""

from __future__ import annotations

from ..affine import triangulation
from ..families import Piece, closed_form
from ..names import EXCEPTIONAL, MINIMAL_DIMENSION
from ..quality import find_measure
from ..symbolic.cases import case
from .measures import DEFINITIONS
from .proof import Proof, ReplayFailed, Step, argument, formulas, identity, inequality, join, tested

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
    steps = _by_induction() if measure == "fatness" else _by_squares(measure)
    return join(
        rf"$\tilde A_d$ has the greatest {measure.replace('_', ' ')} of all Coxeter triangulations of $\mathbb{{R}}^d$, "
        r"for every $d \geq 2$",
        steps,
        tested("and the exceptional types, one by one", r"\hat\kappa(\tilde A_d) > \hat\kappa(\tilde X_d)",
               r"X \in \{E_6, E_7, E_8, F_4, G_2\}", lambda _: _exceptional(measure)),
    )  # fmt: skip


def _by_squares(measure: str) -> list[Step]:
    name = f"normalized_{measure}"
    squares = SQUARES[measure]
    steps = []
    for piece in closed_form("A", name).pieces:
        for parity, square in zip(("odd", "even"), squares["A"], strict=True):
            if piece.parity in (None, parity):
                steps.append(_square("A", piece, square, parity))
    for letter in "BCD":
        piece = closed_form(letter, name).pieces[-1]
        steps.append(_square(letter, piece, str(squares[letter]), piece.parity or ""))
        low = MINIMAL_DIMENSION[letter]
        for parity, square in dict(zip(("odd", "even"), squares["A"], strict=True)).items():
            steps.append(inequality(
                rf"$\tilde A_d$ against $\tilde {letter}_d$, {parity} $d$",
                rf"\hat\kappa(\tilde A_d)^2 - \hat\kappa(\tilde {letter}_d)^2",
                f"{square} - {squares[letter]}", case(f"{low} <= d", low), strict=True,
            ))  # fmt: skip
    return steps + ([_b3(measure)] if measure == "thickness" else [])


def _square(letter: str, piece: Piece, square: str, parity: str) -> Step:
    return formulas(
        rf"the square for $\tilde {letter}_d$",
        r"\hat\kappa^2",
        f"({piece.text})**2",
        square,
        piece.low,
        parity,
    )


def _b3(measure: str) -> Step:
    """B~3 has a formula of its own."""

    def test(_: int) -> int:
        a, b = (find_measure(measure).normalized(triangulation(name).simplex) for name in ("A~3", "B~3"))
        if a <= b:
            raise ReplayFailed(f"{measure}: A~3 has {a}, B~3 has {b}")
        return 1

    test(3)
    return tested("the exceptional value of $\\tilde B_3$", r"\hat\kappa(\tilde A_3) > \hat\kappa(\tilde B_3)",
                  "d = 3", test)  # fmt: skip


def _by_induction() -> list[Step]:
    odd, even = closed_form("A", "normalized_fatness").pieces
    steps = [
        formulas(r"odd $d$", r"\hat\Theta(\tilde A_d)^2", f"({odd.text})**(2*d)", "2**(3*d)/(d + 1)**(d + 2)", 3,
                 "odd"),
        formulas(r"even $d$", r"\hat\Theta(\tilde A_d)^2", f"({even.text})**(2*d)",
                 "2**(3*d)/(d + 1)**(d + 2)*((d + 1)**2/(d*(d + 2)))**d", 2, "even"),
        inequality("for even $d$ the last factor is at least 1", r"(d+1)^2 - d(d+2)", "(d + 1)**2 - d*(d + 2)",
                   "2 <= d", strict=True),
        argument(
            r"By the binomial theorem $(1 + \tfrac1d)^d \leq \sum \tfrac{1}{i!} < 1 + 1 + \tfrac12 + \tfrac14 + "
            r"\dots = 3$"
        ),
    ]  # fmt: skip
    for letter, (factor, low, power) in LEAD.items():
        text = closed_form(letter, "normalized_fatness").pieces[-1].text
        steps += [
            formulas(rf"$\tilde {letter}_d$", rf"\hat\Theta(\tilde {letter}_d)^2", f"({text})**(2*d)",
                     f"{factor}*2**d/(d**d*(d + 1))", low),
            formulas("the quotient", rf"\frac{{\hat\Theta(\tilde A_d)^2}}{{\hat\Theta(\tilde {letter}_d)^2}} \geq q",
                     f"2**(3*d)/(d + 1)**(d + 2)/({factor}*2**d/(d**d*(d + 1)))",
                     f"4**(d - {power})*(d/(d + 1))**d/(d + 1)", low),
            argument(rf"So the quotient is greater than $f(d) = 4^{{d - {power}}} / (3(d+1))$"),
            inequality("it is more than 1 for the first $d$", f"f({low}) - 1",
                       f"4**({low} - {power})/(3*({low} + 1)) - 1", f"{low} == d", strict=True),
            inequality("and grows", r"\frac{f(d+1)}{f(d)} - 1", "4*(d + 1)/(d + 2) - 1", f"{low} <= d", strict=True),
        ]  # fmt: skip
    return [*steps, _b3("fatness")]


def _exceptional(measure: str) -> int:
    count = 0
    for letter, ranks in EXCEPTIONAL.items():
        for d in ranks:
            a, x = (
                find_measure(measure).normalized(triangulation((name, d)).simplex) for name in ("A", letter)
            )
            if a <= x:
                raise ReplayFailed(f"{measure}: A~{d} has {a}, {letter}~{d} has {x}")
            count += 1
    return count


def ranking(measure: str, d: int) -> list[str]:
    """The triangulations of a dimension, the best first."""
    from ..names import triangulations_up_to

    types = [kind for kind in triangulations_up_to(d) if kind.rank == d]
    value = find_measure(measure).normalized
    return [
        k.affine for k in sorted(types, key=lambda k: value(triangulation(k.affine).simplex), reverse=True)
    ]


MEASURES = tuple(DEFINITIONS)
__all__ = ["LEAD", "MEASURES", "SQUARES", "best", "identity", "ranking"]
