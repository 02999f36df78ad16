"""In sentences: which family is ahead of which, by a measure, and in which dimensions curves cross."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, pairwise

from ..names import EXCEPTIONAL, MINIMAL_DIMENSION
from ..proofs.order import Lead, leads
from .qualities import ranking

PAIRS = tuple("".join(pair) for pair in combinations(MINIMAL_DIMENSION, 2))


def crossings(measure: str, pair: str) -> tuple[int, ...]:
    """The dimensions from which on another family of a pair is ahead than before.

    >>> crossings("radius_ratio", "CD"), crossings("thickness", "BC")
    ((6,), ())
    """
    found = [lead for lead in leads(measure, *pair) if lead.ahead]
    return tuple(b.first for a, b in pairwise(found) if a.ahead != b.ahead)


def sentence(measure: str, pair: str) -> str:
    """Two families in all dimensions.

    >>> sentence("radius_ratio", "CD")
    'C~ and D~ cross between d = 5 and d = 6: D~ is ahead for d = 4 and 5, C~ from d = 6 on.'
    >>> sentence("thickness", "BC")
    'B~ and C~: C~ is ahead for d = 3, they are equal from d = 4 on.'
    >>> sentence("aspect_ratio", "BC"), sentence("thickness", "CD")
    ('C~ is ahead of B~ in every dimension.', 'C~ and D~ are equal in every dimension.')
    """
    x, y = pair[0], pair[1]
    found = leads(measure, x, y)
    if len(found) == 1:
        ahead = found[0].ahead
        if not ahead:
            return f"{x}~ and {y}~ are equal in every dimension."
        return f"{ahead}~ is ahead of {y if ahead == x else x}~ in every dimension."
    cross = " and ".join(f"between d = {d - 1} and d = {d}" for d in crossings(measure, pair))
    head = f"{x}~ and {y}~" + (f" cross {cross}" if cross else "")
    return f"{head}: {', '.join(_parts(found))}."


def _parts(found: tuple[Lead, ...]) -> Iterator[str]:
    said = False
    for lead in found:
        who = f"{lead.ahead}~ " if lead.ahead else "they are equal "
        verb = "" if said or not lead.ahead else "is ahead "
        said = said or bool(lead.ahead)
        yield who + verb + _range(lead)


def _range(lead: Lead) -> str:
    if lead.last is None:
        return f"from d = {lead.first} on"
    if lead.last <= lead.first + 1:
        return f"for d = {' and '.join(map(str, sorted({lead.first, lead.last})))}"
    return f"for d = {lead.first} to {lead.last}"


def pairs_in_order(measure: str) -> list[str]:
    """All pairs of families, those that cross first, then those that are not always in the same order."""
    return sorted(PAIRS, key=lambda pair: (-len(crossings(measure, pair)), -len(leads(measure, *pair))))


def in_dimension(measure: str, d: int) -> str:
    """All types of a dimension, the best first.

    >>> in_dimension("thickness", 4)
    'A~4 > B~4 = C~4 = D~4 > F~4'
    """
    return " > ".join(" = ".join(kind.affine for kind in equal) for equal in ranking(measure, d))


EXCEPTIONAL_DIMENSIONS = tuple(sorted({d for ranks in EXCEPTIONAL.values() for d in ranks}))
"""Where there are types besides the four families."""
