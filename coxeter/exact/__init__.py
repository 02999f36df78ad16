"""Exact arithmetic: rationals, surds, and integer matrices over a common denominator."""

from .matrices import RationalMatrix, dot
from .rationals import rational
from .reading import surd
from .surd import Exact, Surd, sqrt
from .vectors import as_vector, show

__all__ = [
    "Exact",
    "RationalMatrix",
    "Surd",
    "as_vector",
    "dot",
    "rational",
    "show",
    "sqrt",
    "surd",
]
