"""What claims and items are called in prose, and where on the site they are."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import groupby

from ..ledger.claim import Claim
from ..ledger.inventory import belongs, items

KINDS = {
    "def": "Definition", "thm": "Theorem", "lem": "Lemma", "prop": "Proposition", "cor": "Corollary",
    "rem": "Remark", "eq": "Equation", "tab": "Table", "fig": "Figure",
}  # fmt: skip
NAMED = {
    "claim-c": "Claim of Appendix C",
    "tab-angles": "Table of angles",
    "tab-regular": "Table of the regular simplex",
}


@lru_cache(maxsize=2048)
def item_of(id: str) -> str:
    """The numbered item to which a claim belongs; for others the section, as ``sec1``.

    >>> [item_of(id) for id in ("thm-8.delaunay", "sec6.B.item-5.longest", "sec1.bcc", "sec6.E8.order")]
    ['thm-8', 'sec6.B.item-5', 'sec1', 'sec6.E8']
    """
    for item in items():
        if belongs(id, item):
            return item
    if match := re.match(r"sec6\.[A-G]\d?(?=\.)", id):
        return match[0]
    return id.split(".")[0]


def name_of_item(item: str) -> str:
    """An item in words; types are written as the ledger writes them.

    >>> name_of_item("thm-8"), name_of_item("sec6.B.item-5"), name_of_item("sec1"), name_of_item("eq-3")
    ('Theorem 8', 'B~, item 5', 'Section 1', 'Equation (3)')
    """
    if item in NAMED:
        return NAMED[item]
    if match := re.fullmatch(r"sec6\.([A-G])(\d?)(?:\.item-(\d))?", item):
        return f"{match[1]}~{match[2]}" + (f", item {match[3]}" if match[3] else "")
    if match := re.fullmatch(r"sec(\d)", item):
        return f"Section {match[1]}"
    if "-" not in item:
        return item
    kind, _, number = item.partition("-")
    return f"{KINDS[kind]} ({number})" if kind == "eq" else f"{KINDS[kind]} {number}"


def name_of(id: str) -> str:
    """A claim in words: its item, and which part of it.

    >>> name_of("thm-8.delaunay"), name_of("prop-12"), name_of("tab-6.B.3"), name_of("lem-4.step-2")
    ('Theorem 8: delaunay', 'Proposition 12', 'Table 6: B~3', 'Lemma 4: step 2')
    """
    item = item_of(id)
    rest = id[len(item) + 1 :]
    if item.startswith("tab-"):
        rest = re.sub(r"^([A-G])(\d?)\.", lambda m: f"{m[1]}~{m[2]} ", rest)
        rest = re.sub(r"^([A-G]~) (\d)$", r"\1\2", rest)
    words = rest.replace("self-", "self\N{HYPHEN}").replace("-", " ").replace(".", " ")
    return name_of_item(item) + (f": {words}" if rest else "").replace("\N{HYPHEN}", "-")


def names_of_items(ids: Iterable[str]) -> dict[str, str]:
    """The items of some claims, in words, each with the first of its claims; others by their own names."""
    first: dict[str, str] = {}
    for id in ids:
        item = item_of(id)
        first.setdefault(name_of_item(item) if is_numbered(item) else name_of(id), id)
    return first


def titled(ids: Iterable[str]) -> str:
    """What some claims are about: the numbered items, and how many statements there are without a number.

    >>> titled(["thm-6", "sec4.converse", "sec4.not-self-centred", "sec6.B.item-5"])
    'Theorem 6, B~, item 5, 2 statements of Section 4'
    """
    items = {item_of(id): None for id in ids}
    loose = Counter(item_of(id) for id in ids if not is_numbered(item_of(id)))
    names = list(_counted_on(filter(is_numbered, items)))
    names += [f"{n} statement{'s' if n > 1 else ''} of {name_of_item(item)}" for item, n in loose.items()]
    return ", ".join(names)


def _counted_on(items: Iterable[str]) -> Iterator[str]:
    """The names of items, three and more that follow each other in one.

    >>> list(_counted_on(["lem-9", "eq-1", "eq-2", "eq-3", "fig-12"]))
    ['Lemma 9', 'Equations (1) to (3)', 'Figure 12']
    """

    def run(place: tuple[int, str]) -> tuple[str, int]:
        kind, _, number = place[1].partition("-")
        return (kind, int(number) - place[0]) if number.isdigit() else (place[1], 0)

    for _, places in groupby(enumerate(items), run):
        names = [name_of_item(item) for _, item in places]
        if len(names) > 2:
            kind, _, first = names[0].partition(" ")
            names = [f"{kind}s {first} to {names[-1].removeprefix(kind + ' ')}"]
        yield from names


def is_numbered(item: str) -> bool:
    """Whether it is more than a section."""
    return not item.startswith("sec") or "item" in item


@dataclass(frozen=True)
class Site:
    """Addresses as they are from one page; `root` leads from there to the root of the site."""

    root: str = "../"

    def claim(self, id: str) -> str:
        """The row of the ledger."""
        return f"{self.root}book/ledger.html#claim-{id}"

    def erratum(self, number: int) -> str:
        """The entry of the errata."""
        return f"{self.root}book/errata.html#erratum-{number}"

    def code(self, claim: Claim) -> str:
        """The check's source."""
        module, _, function = claim.code.rpartition(".")
        return f"{self.root}checks/{module}.html#{function}"

    def download(self, name: str) -> str:
        """A file beside the pages."""
        return f"{self.root}downloads/{name}"
