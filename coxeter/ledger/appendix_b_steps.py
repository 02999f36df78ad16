"""What the steps of both proofs share: findings, and the pairs on which they are tried."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import lru_cache

from ..exact import show
from ..simplex import Position
from .claim import BrokenTool, Constants, Finding, agree, fails, holds
from .section_4_geometry import Pair, any_pairs, boundary_pairs, separated_pairs
from .vectors import Point, along, inner, minus, mirrored
from .vocabulary import EVERY_D, INSTANCES

Pairs = Callable[[], tuple[Pair, ...]]


def step(hypotheses: Pairs, true: Callable[[Pair], bool], *proof: str) -> Finding:
    """The step holds for every d by its proof; it is tried on the pairs, of which there must be some."""
    pairs = hypotheses()
    if not pairs:
        raise BrokenTool("no pair satisfies the hypotheses")
    for pair in pairs:
        if not true(pair):
            return fails(INSTANCES, f"the pair {show_pair(pair)}", "nothing")
    return holds(EVERY_D, *proof, tried(pairs))


def step_with(
    printed: Constants, name: str, hypotheses: Pairs, value: Callable[[Pair], int], *proof: str
) -> Finding:
    """The same for a step with a constant, which must have the same value for all pairs."""
    values = _values(hypotheses, value)
    if len(values) != 1:
        raise BrokenTool(f"the {name} has {len(values)} values")
    return agree(printed, {name: min(values)}, EVERY_D, *proof, tried(hypotheses()))


@lru_cache(maxsize=32)
def _values(hypotheses: Pairs, value: Callable[[Pair], int]) -> frozenset[int]:
    return frozenset(map(value, hypotheses()))


def tried(pairs: tuple[Pair, ...]) -> str:
    """On how many pairs a step was tried."""
    dimensions = sorted({len(pair.apex) for pair in pairs})
    return f"Tried on {len(pairs)} pairs of simplices, of dimension {dimensions[0]} to {dimensions[-1]}."


def show_pair(pair: Pair) -> str:
    """The vertices of a pair."""
    facet = ", ".join(map(show, pair.facet))
    return f"facet {facet}, apexes {show(pair.apex)} and {show(pair.other)}"


# -- the hypotheses of the steps --------------------------------------------------------------------------


@lru_cache(maxsize=1)
def every_pair() -> tuple[Pair, ...]:
    """All pairs, those that share their sphere included."""
    return (*any_pairs(), *separated_pairs(), *boundary_pairs())


@lru_cache(maxsize=1)
def separated() -> tuple[Pair, ...]:
    """Pairs whose facet separates c from σ, strictly."""
    own = (pair for pair in any_pairs() if pair.levels[0] > 0)
    return (*separated_pairs(), *own)


@lru_cache(maxsize=1)
def different_spheres() -> tuple[Pair, ...]:
    """Pairs of dimension at least 2 with different centres."""
    return tuple(p for p in every_pair() if not p.share_sphere and len(p.apex) > 1)


@lru_cache(maxsize=1)
def in_the_proof() -> tuple[Pair, ...]:
    """Separated pairs with different centres and no vertex of either inside the other's sphere."""
    return tuple(p for p in separated() if not p.share_sphere and p.other_sphere.power(p.apex) >= 0)


@lru_cache(maxsize=1)
def on_the_boundary() -> tuple[Pair, ...]:
    """Pairs whose facet contains c: in its interior, or on a smaller face."""
    return tuple(p for p in boundary_pairs() if p.centre_position is Position.BOUNDARY)


def points_of_sphere(pair: Pair) -> Iterable[Point]:
    """Points of S off the hyperplane of the facet: p, two antipodes, and the second hits of lines."""
    centre, q = pair.sphere.centre, pair.facet[0]
    antipodes = [mirrored(v, centre) for v in (q, pair.apex)]
    hits = [_second_hit(pair, v, minus(pair.other, v)) for v in (q, pair.facet[-1])]
    return [x for x in (pair.apex, *antipodes, *hits) if pair.level(x)]


def _second_hit(pair: Pair, v: Point, direction: Point) -> Point:
    """Where the line from a point of S in a direction meets S again."""
    t = -2 * inner(minus(v, pair.sphere.centre), direction) / inner(direction, direction)
    return along(v, t, direction)


def sign(x: Fraction) -> int:
    """The sign of a number."""
    return (x > 0) - (x < 0)
