"""The same exact numbers from a general computer-algebra system: SymPy's `DomainMatrix`.

With python-flint installed its rational matrices are compiled. It is given the simple roots and even
the marks, and computes what `coxeter` computes for one triangulation: vertices, heights, radii,
longest edge, volume and the four measures.
"""

import math

import sympy
from sympy.polys.matrices import DomainMatrix


def qualities(simple_roots: list[list[int]], marks: tuple[int, ...]) -> dict[str, sympy.Expr]:
    """The four measures of the fundamental simplex."""
    d = len(simple_roots)
    s = DomainMatrix(simple_roots, (d, len(simple_roots[0])), sympy.ZZ).convert_to(sympy.QQ)
    coweights = (s * s.transpose()).inv() * s
    scale = DomainMatrix.diag([sympy.QQ(1, m) for m in marks], sympy.QQ)
    vertices = scale * coweights
    gram = vertices * vertices.transpose()
    inverse = gram.inv()
    q, y = gram.to_list(), inverse.to_list()
    inverse_squares = [sum(sum(row) for row in y), *(y[k][k] for k in range(d))]
    squares = [q[k][k] for k in range(d)]
    edges = [q[i][i] + q[j][j] - 2 * q[i][j] for i in range(d) for j in range(i)]
    centre = [sum(a * b for a, b in zip(row, squares, strict=True)) / 2 for row in y]
    circumradius = sympy.sqrt(to_sympy(sum(a * b for a, b in zip(centre, squares, strict=True)) / 2))
    height = sympy.sqrt(1 / to_sympy(max(inverse_squares)))
    edge = sympy.sqrt(to_sympy(max(squares + edges)))
    inradius = 1 / sum(sympy.sqrt(to_sympy(x)) for x in inverse_squares)
    volume = sympy.sqrt(to_sympy(gram.det())) / math.factorial(d)
    return {
        "aspect_ratio": height / (2 * circumradius),
        "fatness": volume / edge**d,
        "thickness": height / edge,
        "radius_ratio": inradius / circumradius,
    }


def to_sympy(x: object) -> sympy.Expr:
    return sympy.QQ.to_sympy(x)
