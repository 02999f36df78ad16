"""The measures of A~, B~, C~, D~ and of the regular simplex for every d. Paper: Sections 3, 5 and 6."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache, partial

from ..exact import Exact, Surd
from ..families import Piece, closed_form
from ..names import MINIMAL_DIMENSION
from ..quality import find_measure
from ..simplex import regular_simplex
from ..symbolic.cases import case
from ..symbolic.runs import runs, squared_distance
from .proof import Core, Proof, Step, argument, formulas, identity, in_dimension, join
from .simplices import circumradius, form, inradius, minimal_height, the_simplex
from .sizes import longest_edge, parts, volume

DEFINITIONS = {
    "aspect_ratio": ("({minimal_height})/(2*({circumradius}))", r"\frac{h}{2R}"),
    "fatness": ("({volume})/({longest_edge})**d", r"\frac{\operatorname{vol}}{L^d}"),
    "thickness": ("({minimal_height})/({longest_edge})", r"\frac hL"),
    "radius_ratio": ("({inradius})/({circumradius})", r"\frac rR"),
}
"""Definition 18, as formulas of the lengths and in LaTeX."""

SYMBOLS = {"aspect_ratio": r"\alpha", "fatness": r"\Theta", "thickness": r"\theta", "radius_ratio": r"\rho"}
LENGTHS = {
    "minimal_height": minimal_height,
    "longest_edge": longest_edge,
    "inradius": inradius,
    "circumradius": circumradius,
    "volume": volume,
}


def quantity(letter: str, name: str, claimed: tuple[Piece, ...] | None = None) -> Proof:
    """A quantity of a family for every d, whichever of the library's closed forms it has.

    Raises
    ------
    Refuted
        If a formula that is claimed is wrong; the message names the first d.

    Examples
    --------
    >>> quantity("C", "normalized_thickness").replay(9) > 0
    True
    >>> quantity("C", "thickness", (Piece("1/sqrt(2*d + 1)", 2),))
    Traceback (most recent call last):
        ...
    coxeter.proofs.proof.Refuted: the thickness: for d = 2 it is 1/2, not sqrt(5)/5
    """
    pieces = claimed or closed_form(letter, name).pieces
    if name in LENGTHS:
        return _length(letter, name, pieces)
    measure = name.removeprefix("normalized_")
    lengths = [
        quantity(letter, length).steps for length in LENGTHS if "{" + length in DEFINITIONS[measure][0]
    ]
    regular = [regular_measures().steps] if measure != name else []
    steps = (step for piece in pieces for step in _pieces_of(letter, name, piece))
    return join(
        rf"the {measure.replace('_', ' ')} of $\tilde{{{letter}}}_d$, from its lengths",
        *lengths,
        *regular,
        steps,
    )


def _length(letter: str, name: str, pieces: tuple[Piece, ...]) -> Proof:
    if name == "longest_edge":
        return longest_edge(letter, pieces)
    prove = LENGTHS[name]
    return prove(letter, pieces[-1].text)  # type: ignore[operator, no-any-return]


def _pieces_of(letter: str, name: str, piece: Piece) -> Iterator[Step]:
    """The measure by its definition, then normalised, where a piece and those of the longest edge overlap."""
    measure = name.removeprefix("normalized_")
    words = f"the {measure.replace('_', ' ')}"
    core = partial(_core, letter, name)
    for part in parts(letter, piece):
        text = {length: _at(letter, length, part) for length in LENGTHS}
        defined, symbol, shown = _defined(measure, text, normalized=name != measure)
        if part.high is None:
            yield formulas(words, symbol, defined, part.text, part.low, part.parity or "", core, shown)
        else:
            for d in range(part.low, part.high + 1):
                yield in_dimension(words, symbol, defined, part.text, d, core, shown)


def _defined(measure: str, text: dict[str, str], normalized: bool) -> tuple[str, str, str]:
    """A measure by its definition: the formula, its symbol, and how the definition is written."""
    defined, shown = DEFINITIONS[measure][0].format(**text), DEFINITIONS[measure][1]
    symbol = SYMBOLS[measure]
    if not normalized:
        return defined, symbol, shown
    ratio, quotient = f"({defined})/({form('regular', measure)})", rf"\frac{{{symbol}}}{{{symbol}(\Delta)}}"
    if measure != "fatness":
        return ratio, rf"\hat{symbol}", quotient
    return f"({ratio})**(1/d)", rf"\hat{symbol}^{{1/d}}", rf"\left({quotient}\right)^{{1/d}}"


def _at(letter: str, length: str, part: Piece) -> str:
    """The closed form of a length in a part, which lies within one of its pieces."""
    return next(p.text for p in closed_form(letter, length).pieces if p.meet(part))


@lru_cache(maxsize=512)
def _core(letter: str, name: str, d: int) -> Surd:
    measure = find_measure(name.removeprefix("normalized_"))
    simplex = regular_simplex(d) if letter == "regular" else the_simplex(letter, d)
    return measure.normalized(simplex) if name.startswith("normalized_") else measure(simplex)


@lru_cache(maxsize=1)
def regular_lengths() -> Proof:
    """The regular simplex with the vertices e_0 … e_d: its lengths for every d."""
    vertex = runs(("0", "k"), ("1", "1"), ("0", "d - k"))
    other = runs(("0", "j"), ("1", "1"), ("0", "d - j"))
    centre = runs(("1/(d + 1)", "d + 1"))
    facet = runs(("1/d", "k"), ("0", "1"), ("1/d", "d - k"))
    each, pair = case("0 <= k <= d", 1), case("0 <= j < k <= d", 1)

    def core(name: str) -> Core:
        def value(d: int, **_: int) -> Exact:
            found: Surd = getattr(regular_simplex(d), name)
            return found * found

        return value

    square = {name: f"({form('regular', name)})**2" for name in LENGTHS}
    return join(
        r"the lengths of the regular simplex with the vertices $e_0, \dots, e_d$",
        identity("an edge", r"\|e_j - e_k\|^2", squared_distance(other, vertex, pair), "2", pair,
                 core("longest_edge")),
        identity("the centre is as far from all vertices", "R^2", squared_distance(vertex, centre, each),
                 "d/(d + 1)", each, core("circumradius")),
        identity("the height ends in the centre of the opposite facet", "h^2",
                 squared_distance(vertex, facet, each), "(d + 1)/d", each, core("minimal_height")),
        identity("and the inradius in the same point", "r^2", squared_distance(centre, facet, each),
                 "1/(d*(d + 1))", each, core("inradius")),
        argument(
            r"The edge vectors $e_k - e_0$ have the Gram matrix $I + J$, with the eigenvalues $d + 1$ and, "
            r"$d - 1$ times, 1: its determinant is $d + 1$"
        ),
        formulas("so the volume", r"\operatorname{vol}^2", "(d + 1)/factorial(d)**2", square["volume"], 1, "",
                 core("volume")),
        *(formulas(f"and the {name.replace('_', ' ')}", "x^2", text, square[name], 1)
          for name, text in (("longest_edge", "2"), ("circumradius", "d/(d + 1)"),
                             ("minimal_height", "(d + 1)/d"), ("inradius", "1/(d*(d + 1))"))),
    )  # fmt: skip


@lru_cache(maxsize=1)
def regular_measures() -> Proof:
    """The four measures of the regular simplex for every d: what the others are normalised by."""
    steps = [
        step
        for name in DEFINITIONS
        for step in _pieces_of("regular", name, closed_form("regular", name).pieces[0])
    ]
    return join("the measures of the regular simplex", regular_lengths().steps, steps)


def first_dimension(letter: str) -> int:
    """The first dimension of a family."""
    return MINIMAL_DIMENSION[letter]
