"""The measures of A~, B~, C~, D~ and of the regular simplex for every d. Paper: Sections 3, 5 and 6."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache, partial

from ..errors import InvalidInput
from ..exact import Exact, Surd
from ..families import Piece, closed_form
from ..families.forms import LENGTHS
from ..names import MINIMAL_DIMENSION
from ..quality import find_measure
from ..simplex import regular_simplex
from ..symbolic.cases import Case, case
from ..symbolic.polynomials import Rational
from ..symbolic.runs import runs, squared_distance, total, total_of
from .proof import Proof, Step, argument, formulas, identity, in_dimension, join
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
BY_ONE_FORMULA: dict[str, Callable[[str, str], Proof]] = {
    "minimal_height": minimal_height,
    "inradius": inradius,
    "circumradius": circumradius,
    "volume": volume,
}
"""The lengths, and the volume, whose general formula is proved at once; the longest edge has several."""


@lru_cache(maxsize=256)
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
    _cover(letter, name, pieces)
    if name in LENGTHS:
        return _length(letter, name, pieces)
    measure = name.removeprefix("normalized_")
    lengths = [
        quantity(letter, length).steps for length in LENGTHS if "{" + length in DEFINITIONS[measure][0]
    ]
    regular = [regular_measures().steps] if measure != name else []
    steps = (step for piece in pieces for step in _pieces_of(letter, name, piece))
    normalised = "normalised " if name != measure else ""
    return join(
        rf"the {normalised}{measure.replace('_', ' ')} of $\tilde{{{letter}}}_d$, from its lengths",
        *lengths,
        *regular,
        steps,
    )


def _cover(letter: str, name: str, pieces: tuple[Piece, ...]) -> None:
    """Refuse formulas that leave a dimension out, give it two values, or begin before the family does."""
    first = MINIMAL_DIMENSION[letter]
    last = max(piece.high or piece.low for piece in pieces) + 2  # from here on only the parity of d matters
    for d in range(first, max(last, first) + 2):
        if sum(piece.covers(d) for piece in pieces) != 1:
            raise InvalidInput(f"{name} of {letter}~: there must be one formula for d = {d}")
    if min(piece.low for piece in pieces) < first:
        raise InvalidInput(f"{name} of {letter}~: there is no {letter}~ with d < {first}")


def _length(letter: str, name: str, pieces: tuple[Piece, ...]) -> Proof:
    if name == "longest_edge":
        return longest_edge(letter, pieces)
    general = next(piece for piece in pieces if piece.high is None)
    proof = BY_ONE_FORMULA[name](letter, general.text)
    words = f"the {name.replace('_', ' ')}"
    others = [
        in_dimension(words, "x", form(letter, name), piece.text, d, partial(_length_of, letter, name))
        for piece in pieces
        if piece.high is not None
        for d in range(piece.low, piece.high + 1)
    ]
    return Proof(proof.statement, (*proof.steps, *others))


def _length_of(letter: str, name: str, d: int) -> Surd:
    value: Surd = getattr(the_simplex(letter, d), name)
    return value


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
    value: Surd = measure.normalized(simplex) if name.startswith("normalized_") else measure(simplex)
    return value


@lru_cache(maxsize=1)
def regular_lengths() -> Proof:
    """The regular simplex with the vertices e_0 … e_d: its lengths for every d."""
    squares = {name: f"({form('regular', name)})**2" for name in LENGTHS}
    found = {"longest_edge": "2", "circumradius": "d/(d + 1)", "minimal_height": "(d + 1)/d"}
    found["inradius"] = "1/(d*(d + 1))"
    return join(
        r"the lengths of the regular simplex with the vertices $e_0, \dots, e_d$",
        _regular_edges(),
        *(_regular_centres(where) for where in (case("1 <= d", 1, k="0"), case("1 <= k <= d", 1))),
        argument(
            r"The edge vectors $e_k - e_0$ have the Gram matrix $I + J$, with the eigenvalues $d + 1$ and, "
            r"$d - 1$ times, 1: its determinant is $d + 1$"
        ),
        formulas("so the volume", r"\operatorname{vol}^2", "(d + 1)/factorial(d)**2", squares["volume"],
                 core=partial(_regular_square, "volume")),
        *(formulas(f"the square of the {name.replace('_', ' ')}", _SQUARES[name], text, squares[name])
          for name, text in found.items()),
    )  # fmt: skip


_SQUARES = {"longest_edge": "L^2", "circumradius": "R^2", "minimal_height": "h^2", "inradius": "r^2"}
_E_K = runs(("0", "k"), ("1", "1"), ("0", "d - k"))
_E_J = runs(("0", "j"), ("1", "1"), ("0", "d - j"))
_CENTRE = runs(("1/(d + 1)", "d + 1"))
_FOOT = runs(("1/d", "k"), ("0", "1"), ("1/d", "d - k"))


def _regular_square(name: str, d: int, **_: int) -> Exact:
    length: Surd = getattr(regular_simplex(d), name)
    return length * length


def _regular_edges() -> Iterator[Step]:
    """The edges, and the foot of a height: the centre of the opposite facet."""
    for where in (case("0 <= j < k <= d", 1), case("0 <= k < j <= d", 1)):
        yield identity("an edge", r"\|e_j - e_k\|^2", squared_distance(_E_J, _E_K, where), "2", where,
                       partial(_regular_square, "longest_edge"))  # fmt: skip
        product = total_of([_E_K, _FOOT, _E_J], where, _height_times)
        yield identity(
            "from $e_k$ to the centre $f$ of the other vertices: all these have the same product with it",
            r"\langle e_k - f, e_j\rangle", product, "-1/d", where,
        )  # fmt: skip


def _regular_centres(where: Case) -> Iterator[Step]:
    """The centre and the foot of the height from e_k: they lie in the hyperplane of the vertices."""
    yield identity("the centre", r"\sum c_i", total(_CENTRE, where), "1", where)
    yield identity("the foot of a height", r"\sum f_i", total(_FOOT, where), "1", where)
    for words, points, name, value in (
        ("the centre is as far from all vertices", (_E_K, _CENTRE), "circumradius", "d/(d + 1)"),
        ("the height", (_E_K, _FOOT), "minimal_height", "(d + 1)/d"),
        ("the inradius ends in the same foot", (_CENTRE, _FOOT), "inradius", "1/(d*(d + 1))"),
    ):
        square = squared_distance(*points, where)
        yield identity(words, _SQUARES[name], square, value, where, partial(_regular_square, name))


def _height_times(x: tuple[Rational, ...]) -> Rational:
    return (x[0] - x[1]) * x[2]


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
