"""Exact arithmetic: rationals, surds, and integer matrices over a common denominator."""

from .angles import Angle, arccos, regular_share
from .matrices import RationalMatrix, dot
from .rationals import rational
from .reading import surd
from .surd import Exact, Surd, sqrt
from .vectors import as_vector, show

__all__ = [
    "Angle",
    "Exact",
    "RationalMatrix",
    "Surd",
    "arccos",
    "as_vector",
    "dot",
    "rational",
    "regular_share",
    "show",
    "sqrt",
    "surd",
]
