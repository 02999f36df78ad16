"""What a peer is, and those that are known by name."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any

from ..errors import CoxeterError, InvalidInput, Unavailable
from ..exact import rational
from ..quality import Measure
from ..simplex import Simplex
from . import cubes, fillers

Cells = Callable[[int], Iterator[Any]]


@dataclass(frozen=True)
class Peer:
    """A triangulation, or a tiling by simplices, in the dimensions in which it exists.

    Attributes
    ----------
    name
        Such as ``"D1"``.
    title
        What it is, in words.
    source
        Where it comes from.
    low, high
        The first dimension and the last, or None if there is no last.
    cells
        All its simplices in one tile, as lists of vertices.
    shapes
        One list of vertices for each shape.
    """

    name: str
    title: str
    source: str
    low: int
    high: int | None
    cells: Cells
    shapes: Callable[[int], Sequence[Any]]

    def exists(self, d: int) -> bool:
        """Whether it exists in dimension d."""
        return self.low <= d and (self.high is None or d <= self.high)

    def classes(self, d: int) -> tuple[Simplex, ...]:
        """One simplex for each congruence class; raises `InvalidInput` if there is none in dimension d.

        >>> find_peer("D1").classes(3)[1].volume
        1/3
        """
        if not self.exists(d):
            allowed = f"d = {self.low}" if self.low == self.high else f"{self.low} <= d"
            allowed += f" <= {self.high}" if self.high and self.low != self.high else ""
            raise InvalidInput(f"{self.name} has no dimension {d}: give {allowed}")
        return _classes(self, d)

    def worst(self, measure: Measure[Any], d: int) -> Any:
        """The normalised measure of the worst of its simplices.

        Raises
        ------
        Unavailable
            If the measure has no method for one of them.

        Examples
        --------
        >>> from coxeter.quality import thickness
        >>> find_peer("five").worst(thickness, 3)
        1/2
        """
        return min(measure.normalized(simplex) for simplex in self.classes(d))

    def worst_if_known(self, measure: Measure[Any], d: int) -> Any:
        """The same, or None where it does not exist or no method finds it."""
        try:
            return self.worst(measure, d) if self.exists(d) else None
        except Unavailable:
            return None


@lru_cache(maxsize=512)
def _classes(peer: Peer, d: int) -> tuple[Simplex, ...]:
    return tuple(Simplex(vertices) for vertices in peer.shapes(d))


def _fixed(cells: Callable[..., Iterator[Any]], *given: Any) -> tuple[Cells, Callable[[int], Sequence[Any]]]:
    """The cells of a tiling of space by one tetrahedron, and its shape."""
    return (lambda d: cells(*given)), (lambda d: [next(iter(cells(*given)))])


_KUHN = "H. Freudenthal, Ann. of Math. 43 (1942); H. W. Kuhn, IBM J. Res. Dev. 4 (1960)"
_SOMMERVILLE = "D. M. Y. Sommerville, Proc. Edinburgh Math. Soc. 41 (1923)"
_GOLDBERG = "M. Goldberg, J. Combin. Theory A 16 (1974)"

_ALL = (
    Peer("K1", "Freudenthal and Kuhn: d! paths in a cube; the simplices have the shape of C~d",
         _KUHN, 2, None, cubes.kuhn, cubes.path),
    Peer("J1", "Tucker and Todd's union jack: paths from the centre of a cube; the shape of C~d",
         "M. J. Todd, The Computation of Fixed Points (1976)", 2, None, cubes.union_jack, cubes.path),
    Peer("barycentric", "the barycentric subdivision of the cube; the shape of C~d",
         "classical", 2, None, cubes.barycentric, partial(cubes.path, length=fillers.HALF)),
    Peer("D1", "Dang's subdivision of the cube into fewer simplices, of d shapes; for d = 3 it is five",
         "C. Dang, Math. Oper. Res. 16 (1991)", 2, None, cubes.dang, cubes.dang_classes),
    Peer("five", "the cube cut into five: four corners and a regular tetrahedron",
         "classical", 3, 3, cubes.corners, cubes.corners_classes),
    Peer("sixteen", "the 4-cube cut into 16: eight corners, and a 16-cell cut along a diagonal",
         "P. S. Mara, J. Combin. Theory A 20 (1976)", 4, 4, cubes.corners, cubes.corners_classes),
    *(Peer(f"sommerville-{n}", words, _SOMMERVILLE, 3, 3, *_fixed(fillers.sommerville, n))
      for n, words in ((1, "the bcc tetrahedron, that of A~3"), (2, "half of it: the tetrahedron of B~3"),
                       (3, "a quarter of it: the tetrahedron of C~3"),
                       (4, "a quarter of it, joined from the centre"))),
)  # fmt: skip
PEERS: dict[str, Peer] = {peer.name: peer for peer in _ALL}
"""The triangulations to compare with, by name."""
DEFAULT = tuple(_ALL)

_FAMILIES = ("hill", "goldberg-1", "goldberg-2", "goldberg-3")


def find_peer(name: str) -> Peer:
    """The triangulation with a given name.

    Parameters
    ----------
    name
        One of `PEERS`; or a member of a family with one parameter q > 0: ``"hill:q"`` in every dimension,
        ``"goldberg-1:q"`` to ``"goldberg-3:q"`` for d = 3. A path of d steps in a cube that is stretched
        along its diagonal, q being the square of the factor: q = 1 is K1, q = 1/(d+1) is A~d.

    Raises
    ------
    InvalidInput
        If there is no such name, or the parameter is no positive rational number.

    Examples
    --------
    >>> from coxeter.quality import thickness
    >>> find_peer("hill:1/4").worst(thickness, 3), find_peer("hill:1").worst(thickness, 3)
    (sqrt(3)/2, 1/2)
    """
    family, colon, text = name.partition(":")
    if name in PEERS:
        return PEERS[name]
    if family not in _FAMILIES or not colon:
        there = ", ".join([*PEERS, *(f"{x}:q" for x in _FAMILIES)])
        raise InvalidInput(f"{name!r} is no triangulation to compare with; there are {there}, q as 1/3")
    try:
        q = rational(text)
    except CoxeterError as error:
        raise InvalidInput(f"{name!r}: {error}: give it as {family}:1/3") from None
    if q <= 0:
        raise InvalidInput(f"{name!r} stretches by the root of {q}: give a positive number, as {family}:1/3")
    return _member(family, q)


@lru_cache(maxsize=256)
def _member(family: str, q: Fraction) -> Peer:
    if family == "hill":

        def shape(d: int) -> list[Any]:
            return [fillers.hill_path(d, q, tuple(range(d)))]

        words = f"Hill and Hadwiger: K1 stretched along the diagonal by the root of {q}"
        source = "M. J. M. Hill, Proc. LMS 27 (1896); H. Hadwiger, Gaz. Mat. 12 (1951)"
        return Peer(f"hill:{q}", words, source, 2, None, lambda d: fillers.hill(d, q), shape)
    number = int(family[-1])
    words = f"Goldberg's family {number}, stretched by the root of {q}"
    return Peer(f"{family}:{q}", words, _GOLDBERG, 3, 3, *_fixed(fillers.goldberg, number, q))
