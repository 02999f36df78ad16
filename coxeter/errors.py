"""The library's exceptions: one small tree under `CoxeterError`.

*Refused* input and an *undecided* question are different things, so they are different types:
an `Undecided` is never to be read as "false".
"""


class CoxeterError(Exception):
    """Base of every error that this library raises on purpose."""


class InvalidType(CoxeterError, ValueError):
    """The name is not that of a root system or of a Coxeter triangulation."""


class InvalidInput(CoxeterError, ValueError):
    """A value is out of range or an array has the wrong shape."""


class InexactInput(CoxeterError, TypeError):
    """A floating-point number was given where only exact numbers can be used."""


class DegenerateSimplex(InvalidInput):
    """The points given as vertices are affinely dependent."""


class Undecided(CoxeterError):
    """The method at hand can neither prove nor refute the statement."""


class Unavailable(CoxeterError):
    """There is such a value, but no method here finds it."""
