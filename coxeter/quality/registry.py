"""What a measure is, and those that are known by name."""

from __future__ import annotations

import traceback
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any, Generic, TypeVar, cast

from ..errors import CoxeterError, InexactInput, InvalidInput
from ..exact import Angle, Surd, surd
from ..simplex import Simplex, regular_simplex

Number = Surd | Angle
ROOTS = "; roots that stay exact are coxeter.sqrt and coxeter.quality.root"
V = TypeVar("V")


@dataclass(frozen=True)
class Measure(Generic[V]):
    """A quality measure.

    Attributes
    ----------
    name
        Such as ``"thickness"``.
    symbol
        LaTeX for the raw measure, as ``\\theta``.
    of
        The function from a simplex to an exact number, of whatever has the attributes that it asks for: a
        `Simplex`; arrays of many simplices; a `coxeter.proofs.symbolic_simplex`, for a formula in d.
    per_dimension
        Whether the normalised value is taken to the power 1/d, as fatness is in Table 2.
    larger_is_better
        Whether a simplex is the better the larger the raw value; if not, normalising turns it round.
    """

    name: str
    symbol: str
    of: Callable[[Any], Any]
    per_dimension: bool = False
    larger_is_better: bool = True

    def __call__(self, simplex: object) -> V:
        """The raw measure of a simplex, or of the fundamental simplex of a triangulation.

        Raises
        ------
        InvalidInput
            If the function raises an error, or returns no exact number; `InexactInput` for a float.
        """
        shape = _simplex_of(simplex)
        try:
            value: Any = self.of(shape)
        except (CoxeterError, MemoryError):
            raise
        except Exception as error:
            how = ROOTS if isinstance(error, TypeError) else ""
            raise InvalidInput(f"the measure {self.name!r} raised {told(error, self.of)}{how}") from error
        if getattr(value, "shape", None) == ():  # as numpy.where returns it
            value = value.item()
        if isinstance(value, Angle) or hasattr(value, "quantity"):  # or a formula in d
            return cast("V", value)
        try:
            return cast("V", surd(value))
        except CoxeterError as error:
            how = ROOTS if isinstance(error, InexactInput) else ""
            raise type(error)(f"the measure {self.name!r} gives no exact number: {error}{how}") from error

    def normalized(self, simplex: object) -> V:
        """The measure divided by that of the regular simplex; to the power 1/d if `per_dimension`.

        If smaller raw values are better, it is that of the regular simplex divided by the measure. So larger
        normalised values are better for every measure, and the regular simplex has 1. Of a measure that
        depends on the size of a simplex a warning says so.

        Raises
        ------
        InvalidInput
            If the measure is not positive of the regular simplex; or of this one, where smaller is better.

        Examples
        --------
        >>> from coxeter.quality import fatness
        >>> fatness.normalized(regular_simplex(5))
        1
        """
        shape = _simplex_of(simplex)
        value: Any = self(shape)
        if isinstance(shape, Simplex):
            regular: Any = self.norm(shape.dimension)
            if not self.larger_is_better and value <= 0:
                raise InvalidInput(
                    f"the measure {self.name!r} is {value} of this simplex: where smaller is better, values "
                    "must be positive to be normalised"
                )
        else:
            self.norm(4)  # all families have this dimension; refuses what cannot be normalised
            regular = self(shape.regular)
        ratio = value / regular if self.larger_is_better else regular / value
        result: V = root(ratio, shape.dimension) if self.per_dimension else ratio
        return result

    def norm(self, d: int) -> V:
        """The measure of the regular d-simplex with edges √2, by which others are divided.

        Raises
        ------
        InvalidInput
            If it is not positive: then dividing by it would turn the order round, or is impossible.

        Examples
        --------
        >>> from coxeter.quality import fatness
        >>> fatness.norm(2)
        sqrt(3)/4
        """
        value: Any = _of_regular(self, d)
        if value <= 0:
            raise InvalidInput(
                f"the measure {self.name!r} is {value} of the regular {d}-simplex: to be normalised it must "
                "be positive there"
            )
        if _depends_on_size(self, min(d, ENOUGH)):
            warnings.warn(
                f"the measure {self.name!r} depends on the size of a simplex, so normalised values compare "
                "sizes too: divide by a power of a length, such as longest_edge",
                stacklevel=3,
            )
        return cast("V", value)

    @property
    def normalized_symbol(self) -> str:
        """LaTeX for the normalised measure."""
        power = "^{1/d}" if self.per_dimension else ""
        return rf"\hat{{{self.symbol}}}{power}"


def root(x: Any, k: Any) -> Any:
    """The k-th root of an exact number, of a formula in d, or of an array of floats.

    >>> root(Fraction(1, 4), 2)
    1/2
    """
    if isinstance(x, (int, Fraction)):
        return surd(x).root(k)
    if isinstance(x, Angle):
        raise InvalidInput(f"the angle {x} has no root: leave per_dimension, and roots of angles, out")
    return x.root(k) if hasattr(x, "root") else x ** (1 / k)


def _simplex_of(value: object) -> Any:
    shape = getattr(value, "simplex", value)
    if not isinstance(shape, Simplex) and not hasattr(shape, "regular"):
        raise InvalidInput(f"{value!r} is neither a simplex nor a triangulation")
    return shape


@lru_cache(maxsize=512)
def _of_regular(measure: Measure[V], d: int) -> V:
    return measure(regular_simplex(d))


ENOUGH = 12
"""In a larger dimension no measure is tried on simplices of two sizes."""


@lru_cache(maxsize=512)
def _depends_on_size(measure: Measure[V], d: int) -> bool:
    """Whether it has another value of the regular simplex twice as large; angles have not."""
    value = _of_regular(measure, d)
    twice = Simplex([[2 * x for x in u] for u in regular_simplex(d).vertices])
    return not isinstance(value, Angle) and bool(measure(twice) != value)


def told(error: Exception, function: Any) -> str:
    """An error in words, with the last line of the function's file that it came through.

    >>> told(ZeroDivisionError("division by zero"), abs)
    'ZeroDivisionError: division by zero'
    """
    file = getattr(getattr(function, "__code__", None), "co_filename", None)
    lines = [x for x in traceback.extract_tb(error.__traceback__) if x.filename == file]
    place = f" ({file}, line {lines[-1].lineno})" if lines else ""
    return " ".join(f"{type(error).__name__}: {error}".split()) + place


MEASURES: dict[str, Measure[Surd]] = {}
"""The paper's measures and those that users add, by name, in the order in which they were added.

These are shown where all measures are."""

MESH_MEASURES: dict[str, Measure[Any]] = {}
"""The measures that mesh people use, by name: shown where one is asked for."""


def measure(
    name: str,
    symbol: str = "",
    per_dimension: bool = False,
    larger_is_better: bool = True,
    among: dict[str, Measure[Any]] = MEASURES,
) -> Callable[[Callable[[Any], Any]], Measure[Any]]:
    """Decorator: add a quality measure.

    Parameters
    ----------
    name
        A new name. Where its function is defined again, as by a cell of a notebook that is run twice, the new
        function takes the place of the old one.
    symbol
        LaTeX for it; the name is used if none is given.
    per_dimension
        Whether normalised values are taken to the power 1/d; for measures that, as a volume does,
        scale with the d-th power of a length.
    larger_is_better
        Whether larger raw values are better.
    among
        The registry: `MEASURES` or `MESH_MEASURES`.

    Raises
    ------
    InvalidInput
        If the name is no text, or taken.

    Examples
    --------
    >>> @measure("second over first")
    ... def second_over_first(simplex):
    ...     short, longer, *_ = sorted(simplex.squared_heights)
    ...     return sqrt(short / longer)
    >>> from coxeter.exact import sqrt
    >>> second_over_first(Simplex([(0, 0), (3, 0), (0, 4)]))
    4/5
    >>> del MEASURES["second over first"]
    """
    if not isinstance(name, str) or not name.strip():
        raise InvalidInput(f'{name!r} is no name: put @measure("my name") before a function of a simplex')

    def add(function: Callable[[Any], Any]) -> Measure[Any]:
        if (old := MEASURES.get(name) or MESH_MEASURES.get(name)) and _place(old.of) != _place(function):
            raise InvalidInput(f"there is already a measure {name!r}: give another name")
        among[name] = Measure(name, symbol or rf"\text{{{name}}}", function, per_dimension, larger_is_better)
        return among[name]

    return add


def _place(function: Any) -> tuple[Any, Any]:
    """Where a function is defined; what bears no name is its own place."""
    return getattr(function, "__module__", None), getattr(function, "__qualname__", function)


def find_measure(name: str) -> Measure[Any]:
    """The measure with a given name; raises `InvalidInput`, naming those there are."""
    known: dict[str, Measure[Any]] = {**MEASURES, **MESH_MEASURES}
    if name not in known:
        raise InvalidInput(f"{name!r} is no quality measure; there are {', '.join(known)}")
    return known[name]


def qualities(simplex: Simplex) -> dict[str, Surd]:
    """The measures in `MEASURES` of a simplex, raw."""
    return {name: known(simplex) for name, known in MEASURES.items()}


def normalized_qualities(simplex: Simplex) -> dict[str, Surd]:
    """The measures in `MEASURES` of a simplex, normalised by the regular simplex."""
    return {name: known.normalized(simplex) for name, known in MEASURES.items()}
