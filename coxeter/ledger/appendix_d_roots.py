"""Lists of roots as Appendix D prints them, and the exact ones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import lru_cache
from itertools import combinations, product

from ..affine import CoxeterTriangulation
from ..errors import InvalidInput
from ..exact import RationalMatrix
from .appendix_d_cases import number
from .claim import Constants
from .vectors import Point

Twice = tuple[int, ...]
"""A vector with integer or half-integer coordinates, doubled."""
Roots = frozenset[Twice]


# -- the exact lists ---------------------------------------------------------------------------------------


@lru_cache(maxsize=64)
def positive_roots(t: CoxeterTriangulation) -> Roots:
    """All positive roots."""
    return _doubled(t.roots.positive_roots)


@lru_cache(maxsize=64)
def integral_roots(t: CoxeterTriangulation, v: Point) -> Roots:
    """The positive roots with an integer inner product with v."""
    return _doubled(t.integral_roots(v))


def _doubled(rows: RationalMatrix) -> Roots:
    factor = 2 // rows.denominator
    return frozenset(tuple(factor * int(x) for x in row) for row in rows.numerators)


def rank(roots: Roots) -> int:
    """The dimension of the space that roots span."""
    return RationalMatrix.from_rows(sorted(roots)).rank() if roots else 0


# -- the printed lists -------------------------------------------------------------------------------------


def listed(printed: Constants, d: int, n: int) -> Roots:
    """The vectors of a printed list, in n coordinates.

    ``single``, ``double``, ``minus``, ``turned`` and ``plus`` stand for e_i, 2e_i and, with i < j, e_i - e_j,
    e_j - e_i and e_i + e_j, where i and j are from the first to the last index given, but not in ``without``;
    ``single_in``, ``turned_in`` and ``plus_in`` give all indices one by one. ``half_signs`` is a range of
    indices that get all signs in half a sum with the signed indices ``half_fixed``; the number of minus signs
    among the former is ``half_rest`` modulo 2, if that is given. ``further`` has vectors, as signed indices.
    """
    found: set[Twice] = set()
    for name, entries in printed.items():
        if name in _CLASSES:
            first, last = entries if len(entries) == 2 else (1, 0)
            indices = set(range(number(first, d), number(last, d) + 1)) - set(printed.get("without", ()))
            found |= _class(name, sorted(indices), n)
        elif name.removesuffix("_in") in _CLASSES:
            if min(entries) < 1:
                raise InvalidInput(f"{min(entries)} is no index")
            found |= _class(name.removesuffix("_in"), sorted(entries), n)
    if "half_signs" in printed:
        found |= _halves(printed, n)
    return frozenset(found | {_vector(signed, n, 2) for signed in printed.get("further", ())})


_CLASSES: dict[str, Callable[..., list[tuple[int, ...]]]] = {
    "single": lambda i: [(i,)],
    "double": lambda i: [(i, i)],
    "minus": lambda i, j: [(i, -j)],
    "turned": lambda i, j: [(-i, j)],
    "plus": lambda i, j: [(i, j)],
    "both": lambda i, j: [(i, j), (i, -j)],
}
"""From an index, or two with i < j, to vectors as signed indices."""


def _class(name: str, indices: Sequence[int], n: int) -> set[Twice]:
    make, size = _CLASSES[name], 1 if name in ("single", "double") else 2
    return {_vector(signed, n, 2) for chosen in combinations(indices, size) for signed in make(*chosen)}


def _halves(printed: Constants, n: int) -> set[Twice]:
    first, last = printed["half_signs"] if len(printed["half_signs"]) == 2 else (1, 0)
    indices, rest = range(first, last + 1), printed.get("half_rest")
    if rest not in (None, 0, 1):
        raise InvalidInput(f"{rest} is no remainder modulo 2")
    return {
        _vector((*printed["half_fixed"], *(s * i for s, i in zip(signs, indices, strict=True))), n, 1)
        for signs in product((1, -1), repeat=len(indices))
        if rest is None or (signs.count(-1) - rest) % 2 == 0
    }


def _vector(signed: Sequence[int], n: int, size: int) -> Twice:
    out = [0] * n
    for i in signed:
        if not 1 <= abs(i) <= n:
            raise InvalidInput(f"there is no e_{abs(i)}: there are {n} coordinates")
        out[abs(i) - 1] += size if i > 0 else -size
    return tuple(out)
