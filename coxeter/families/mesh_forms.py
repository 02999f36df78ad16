"""More closed forms in d: what the measures of mesh people ask of a fundamental simplex.

They are claims, which `coxeter.proofs.edges` proves. Edges are in the scale of Theorem 3's simple roots.
"""

from __future__ import annotations

from ..errors import InvalidInput
from ..names import MINIMAL_DIMENSION
from . import ClosedForm, Piece

MESH_FORMS: dict[str, dict[str, str | tuple[str, str]]] = {
    "A": {
        "shortest_edge": "sqrt(d/(d + 1))",
        "sum_of_squared_edges": "d*(d + 1)*(d + 2)/12",
        "sum_of_inverse_squared_heights": "2*(d + 1)",
        "minimal_dihedral_angle": "60",
        "maximal_dihedral_angle": ("60", "90"),  # for d = 2 the triangle is equilateral
        "minimal_solid_angle": "1/factorial(d + 1)",
    },
    "B": {
        "shortest_edge": "1/2",
        "sum_of_squared_edges": "1/2 + d*(d + 1)/4 + d*(d - 1)*(d - 2)/24",
        "sum_of_inverse_squared_heights": "8*(d - 1)",
        "minimal_dihedral_angle": "45",
        "maximal_dihedral_angle": "90",
        "minimal_solid_angle": "1/(2**d*factorial(d))",
    },
    "C": {
        "shortest_edge": "1/2",
        "sum_of_squared_edges": "d*(d + 1)*(d + 2)/24",
        "sum_of_inverse_squared_heights": "8*d",
        "minimal_dihedral_angle": "45",
        "maximal_dihedral_angle": "90",
        "minimal_solid_angle": "1/(2**d*factorial(d))",
    },
    "D": {
        "shortest_edge": (
            "1/sqrt(2)",
            "1/2",
        ),  # for d = 4 there is one node with mark 2, so no u_2 beside u_3
        "sum_of_squared_edges": "2 + d + d*(d - 3)/2 + (d - 2)*(d - 3)*(d - 4)/24",
        "sum_of_inverse_squared_heights": "8*(d - 2)",
        "minimal_dihedral_angle": "60",
        "maximal_dihedral_angle": "90",
        "minimal_solid_angle": "1/(2**(d - 1)*factorial(d))",
    },
    "regular": {
        "shortest_edge": "sqrt(2)",
        "sum_of_squared_edges": "d*(d + 1)",
        "sum_of_inverse_squared_heights": "d",
    },
}
"""Family -> quantity -> formula: one, or that in the first dimension and that from the next one on."""


def mesh_form(family: str, quantity: str) -> ClosedForm:
    """The closed form of a quantity that is not among `coxeter.families.QUANTITIES`.

    Raises `InvalidInput` if there is none.

    >>> mesh_form("D", "shortest_edge").at(4), mesh_form("D", "shortest_edge").at(9)
    (sqrt(2)/2, 1/2)
    """
    known = MESH_FORMS.get(family, {})
    if quantity not in known:
        raise InvalidInput(f"{family} has no closed form {quantity!r}; it has {', '.join(known)}")
    text, low = known[quantity], MINIMAL_DIMENSION.get(family, 1)
    if isinstance(text, str):
        return ClosedForm(family, quantity, (Piece(text, low),))
    return ClosedForm(family, quantity, (Piece(text[0], low, low), Piece(text[1], low + 1)))
