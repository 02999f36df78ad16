"""Which triangulation to use: what each type offers, tables by dimension, and a form that answers."""

from __future__ import annotations

import html
import json
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from itertools import combinations
from typing import Any

from ..affine import CoxeterTriangulation
from ..delaunay import delaunay_verdict, protection
from ..exact import Surd
from ..lattices import vertex_lattice
from ..names import EXCEPTIONAL, MINIMAL_DIMENSION, Type
from ..proofs.order import leads
from .explorer_data import called, words
from .judged import Ledger
from .markup import row, table
from .naming import Site
from .qualities import MAX_DIM, MEASURES, qualities, ranking, rate, rounded, short, types_in
from .wording import to_html

DIMENSIONS = (*range(2, 11), 16, 32, MAX_DIM)
"""The rows of the table by dimension."""

ALIKE_FROM = 10
"""From this dimension on, the members of a family offer the same: Theorem 8, proved for every d."""

SPACES = ", ".join(f"tab-1.{letter}.space" for letter in MINIMAL_DIMENSION)
OFFERS = {
    "delaunay": ("Delaunay", "no vertex lies inside the sphere around a simplex", "thm-8.delaunay"),
    "protected": ("protected", "no other vertex lies on that sphere either", "thm-8.protected"),
    "lattice": ("a lattice", "sums and differences of vertices are vertices", "thm-8.lattices"),
    "plain": ("d coordinates", "the vertices are given in $R^d$, by rational coordinates", SPACES),
}  # fmt: skip
"""What may be asked for: how it is called, what it means, and the claim that it rests on."""


@lru_cache(maxsize=512)
def offers(kind: Type) -> Mapping[str, bool]:
    """What a type offers, computed; in high dimensions by a smaller member of its family.

    >>> [name for name, there in offers(Type("C", 40)).items() if there]
    ['delaunay', 'lattice', 'plain']
    """
    if kind.rank > ALIKE_FROM:
        return offers(Type(kind.letter, ALIKE_FROM))
    t = CoxeterTriangulation(kind)
    return {
        "delaunay": bool(delaunay_verdict(t)),
        "protected": bool(protection(t)),
        "lattice": bool(vertex_lattice(t)),
        "plain": t.simplex.vertex_matrix.numerators.shape[1] == t.dimension,
    }


def best(measure: str, d: int, *needed: str) -> list[Type]:
    """The types of the greatest value among those that offer what is needed; none if there is none.

    >>> [kind.affine for kind in best("radius_ratio", 5, "plain")]
    ['D~5']
    """
    for equal in ranking(measure, d):
        if fitting := [kind for kind in equal if all(offers(kind)[name] for name in needed)]:
            return fitting
    return []


# -- tables --------------------------------------------------------------------------------------------------


def _families(ledger: Ledger, site: Site) -> str:
    """The four families for every d, then the single types."""
    head = ("type", *(html.escape(told) for told, _, _ in OFFERS.values()), *map(_measure_head, MEASURES))
    infinite = "".join(
        row(to_html(f"{letter}~_d"), (*_answers(letter), *(_limit(letter, m) for m in MEASURES)))
        for letter in MINIMAL_DIMENSION
    )
    single = "".join(
        row(_named(kind), (*_signs(kind), *(_value(kind, m) for m in MEASURES)))
        for letter, ranks in EXCEPTIONAL.items()
        for kind in (Type(letter, d) for d in ranks)
    )
    return table("lg-sheet cx-small", head, f"<tbody>{infinite}{single}</tbody>", "What each type offers")


def _measure_head(measure: str) -> str:
    return words(measure).replace("to the power 1/d", "<sup>1/d</sup>").replace(" <sup>", "<sup>")


def _answers(letter: str) -> Iterator[str]:
    """Yes or no for a family; where its members differ, those that are yes."""
    members = [Type(letter, d) for d in range(MINIMAL_DIMENSION[letter], ALIKE_FROM + 1)]
    for name in OFFERS:
        found = [kind for kind in members if offers(kind)[name]]
        if len(found) in (0, len(members)):
            yield _yes(bool(found))
        else:
            yield f"only {', '.join(map(_named, found))}"


def _signs(kind: Type) -> Iterator[str]:
    return (_yes(there) for there in offers(kind).values())


def _yes(there: bool) -> str:
    return "yes" if there else '<span class="lg-quiet">no</span>'


def _limit(letter: str, measure: str) -> str:
    found = rate(letter, measure)
    assert found is not None  # of a normalised measure
    return to_html(rf"$\approx\frac{{{found.coefficient.latex()}}}{{\sqrt d}}$")


def _value(kind: Type, measure: str) -> str:
    return qualities()[measure, kind].normalized.decimal(3)


def _named(kind: Type) -> str:
    return to_html(kind.affine)


def _dimensions(ledger: Ledger, site: Site) -> str:
    """By dimension: the best type by each measure, the next, and who offers what."""
    asked = {name: OFFERS[name][0] for name in ("delaunay", "lattice")}
    head = ("d", *map(_measure_head, MEASURES), *map(html.escape, asked.values()))
    rows = "".join(
        row(str(d), (*(_podium(m, d) for m in MEASURES), *(_having(d, name) for name in asked)))
        for d in DIMENSIONS
    )
    return table(
        "lg-sheet cx-small cx-dimensions",
        head,
        f"<tbody>{rows}{_for_every_d()}</tbody>",
        "The best type by dimension",
    )


def _podium(measure: str, d: int) -> str:
    """The best and the next."""
    first, second, *_ = ranking(measure, d)
    return f"{_step(measure, first)}<br><small>then {_step(measure, second)}</small>"


def _step(measure: str, equal: list[Type]) -> str:
    return f"{', '.join(map(_named, equal))} {_value(equal[0], measure)}"


def _for_every_d() -> str:
    """The last row: what is proved of the best type and the next."""
    families = {name: [x for x in MINIMAL_DIMENSION if offers(Type(x, MAX_DIM))[name]] for name in OFFERS}
    having = (
        ", ".join(to_html(f"{letter}~_d") for letter in families[name]) for name in ("delaunay", "lattice")
    )
    return row("every d", (*map(_best_two, MEASURES), *having), "cx-every")


def _best_two(measure: str) -> str:
    letters, start = next_best(measure)
    then = ", ".join(to_html(f"{letter}~_d") for letter in letters)
    return f"{to_html('A~_d')}<br><small>then {then} from d = {start} on</small>"


def next_best(measure: str) -> tuple[str, int]:
    """The families next to A~ by a measure, and from which dimension on, for ever.

    >>> next_best("radius_ratio"), next_best("thickness")
    (('C', 6), ('BCD', 4))
    """
    ahead = {pair: leads(measure, *pair)[-1] for pair in combinations("BCD", 2)}
    top = {x for x in "BCD" if all(lead.ahead in (x, "") for pair, lead in ahead.items() if x in pair)}
    settled = max(lead.first for lead in ahead.values())
    start = settled
    while start > 2 and _next(measure, start - 1) == top:
        start -= 1
    late = [d for d in range(settled, max(EXCEPTIONAL["E"]) + 1) if _next(measure, d) != top]
    return "".join(sorted(top)), max([start, *(d + 1 for d in late)])


def _next(measure: str, d: int) -> set[str]:
    return {kind.family for kind in ranking(measure, d)[1]}


def _having(d: int, name: str) -> str:
    return ", ".join(_named(kind) for kind in types_in(d) if offers(kind)[name]) or "none"


def _cost(ledger: Ledger, site: Site) -> str:
    """What the best type in R^d has of the value of the best of all, by measure and dimension."""
    shown = (3, 4, 8, 16, MAX_DIM)
    rows = "".join(
        row(_measure_head(m), (*(_share(m, d) for d in shown), _share_in_the_limit(m))) for m in MEASURES
    )
    head = ("measure", *(f"d = {d}" for d in shown), to_html(r"limit for $d \to \infty$"))
    return table("lg-sheet cx-small", head, f"<tbody>{rows}</tbody>", "What d coordinates cost")


def _share(measure: str, d: int) -> str:
    values = qualities()
    kinds = best(measure, d, "plain")
    share = values[measure, kinds[0]].normalized / values[measure, best(measure, d)[0]].normalized
    return f"{share.decimal(3)} {', '.join(map(_named, kinds))}"


def _share_in_the_limit(measure: str) -> str:
    found = {letter: rate(letter, measure) for letter in MINIMAL_DIMENSION}
    limits = {letter: growth.coefficient for letter, growth in found.items() if growth}
    others: list[Surd] = [limits[letter] for letter in "BCD"]
    share = max(others) / max(limits.values())
    return f"{to_html(f'${share.latex()}$')} ≈ {share.decimal(3)}"


# -- the form ------------------------------------------------------------------------------------------------


def _form(ledger: Ledger, site: Site) -> str:
    options = "".join(f'<option value="{m}">{words(m)}</option>' for m in MEASURES)
    boxes = "".join(
        f'<label class="cx-box"><input type="checkbox" name="need" value="{name}"> '
        f'<span>{html.escape(told)} <span class="lg-quiet">({to_html(meaning)})</span></span></label>'
        for name, (told, meaning, _) in OFFERS.items()
    )
    data = json.dumps(_data(ledger, site), ensure_ascii=False, separators=(",", ":")).replace("</", r"<\/")
    return (
        '<div class="cx-chooser"><form class="cx-controls" hidden><label class="cx-field">Dimension '
        f'<input type="number" name="d" min="2" max="{MAX_DIM}" value="6" inputmode="numeric"></label>'
        f'<label class="cx-field">What matters most <select name="measure">{options}</select></label>'
        f"<fieldset><legend>Needed</legend>{boxes}</fieldset></form>"
        '<div class="cx-answer" role="status" hidden></div>'
        '<p class="cx-otherwise">The tables below answer without scripts.</p>'
        f'<script type="application/json" class="cx-data">{data}</script></div>'
    )


def _data(ledger: Ledger, site: Site) -> dict[str, Any]:
    """For each dimension its types, what they offer, and for each measure their exact order and values."""
    return {
        "max": MAX_DIM,
        "measures": {m: words(m) for m in MEASURES},
        "offers": {
            name: [told, site.claim(ledger.find(claim)[0].id)] for name, (told, _, claim) in OFFERS.items()
        },
        "types": {str(d): {_id(kind): _letters(kind) for kind in types_in(d)} for d in range(2, MAX_DIM + 1)},
        "orders": {m: {str(d): _order(m, d) for d in range(2, MAX_DIM + 1)} for m in MEASURES},
        "best": {m: site.claim(f"sec5.best.{m.replace('_', '-')}") for m in MEASURES},
    }


def _id(kind: Type) -> str:
    return called(kind.letter) + f"<sub>{kind.rank}</sub>"


def _letters(kind: Type) -> list[str]:
    return [name for name, there in offers(kind).items() if there]


def _order(measure: str, d: int) -> list[list[Any]]:
    """The best first: the types of equal value, the exact value, its decimal."""
    return [
        [list(map(_id, equal)), short(equal[0], measure), rounded(qualities()[measure, equal[0]].normalized)]
        for equal in ranking(measure, d)
    ]


CHOICES: Mapping[str, Callable[[Ledger, Site], str]] = {
    "form": _form,
    "families": _families,
    "dimensions": _dimensions,
    "cost": _cost,
}
"""The views of the page, by name."""
