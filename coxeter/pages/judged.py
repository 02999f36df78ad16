"""Every claim with what came of judging it, and how the claims hang together."""

from __future__ import annotations

import hashlib
import pickle
import platform
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property, lru_cache
from importlib.metadata import version
from pathlib import Path
from typing import NamedTuple

from ..errors import CoxeterError, InvalidInput
from ..ledger import all_claims, verify
from ..ledger.claim import Claim, Finding
from ..ledger.inventory import PROPOSITIONS, belongs, items
from ..ledger.pools import cpus, process_pool
from ..ledger.running import Result
from ..ledger.vocabulary import Extent, Verdict, Weight

LIBRARY = Path(__file__).parent.parent
VIEWS = ("pages", "cli", "report.py")
"""What is made from verdicts, and has no part in them."""

GRAVITY = (
    Verdict.FAILS,
    Verdict.CORRECTED,
    Verdict.REPAIRED,
    Verdict.TRANSCRIPTION,
    Verdict.OPEN,
    Verdict.CITED,
    Verdict.HOLDS,
)
"""Verdicts, the gravest first."""

FIRMNESS = (Extent.INSTANCES, Extent.LITERATURE, Extent.UP_TO, Extent.FINITE, Extent.EVERY_D)
"""Strengths, the weakest first."""


class Unjudged(CoxeterError):
    """A check raised an error or ran out of time, so that there is nothing to show."""


class Judged(NamedTuple):
    """A claim, and what was found."""

    claim: Claim
    result: Result

    @property
    def id(self) -> str:
        """The id of the claim."""
        return self.claim.id

    @property
    def finding(self) -> Finding:
        """What the check found.

        Raises
        ------
        Unjudged
            If it found nothing, for want of time or by an error.
        """
        if self.result.finding is None:
            raise Unjudged(f"{self.id} has no verdict: {self.result.trouble}")
        return self.result.finding

    @property
    def verdict(self) -> Verdict:
        """The verdict."""
        return self.finding.verdict

    @property
    def is_erratum(self) -> bool:
        """Whether something that is printed should be otherwise, be it in our copy only."""
        return not self.verdict.accepts or self.verdict is Verdict.REPAIRED

    @property
    def gravity(self) -> tuple[int, int, int]:
        """By this the gravest comes first: by verdict, then by weight, then by want of strength."""
        strength = FIRMNESS.index(self.finding.strength.extent)
        return GRAVITY.index(self.verdict), list(Weight).index(self.claim.weight), strength


@dataclass(frozen=True, eq=False, repr=False)
class Ledger:
    """All claims that were judged, in the order of the paper."""

    all: tuple[Judged, ...]

    @cached_property
    def by_id(self) -> dict[str, Judged]:
        """Each claim by its id."""
        return {x.id: x for x in self.all}

    def __iter__(self) -> Iterator[Judged]:
        return iter(self.all)

    def __len__(self) -> int:
        return len(self.all)

    def __getitem__(self, id: str) -> Judged:
        return self.by_id[id]

    def find(self, asked: str) -> tuple[Judged, ...]:
        """The claims that are asked for: ids and items, separated by commas.

        An item such as ``thm-8`` stands for itself and all claims below it; ``lem-9!`` is that claim alone.

        Raises
        ------
        InvalidInput
            If an id is that of no claim and no item; the message names the nearest.
        """
        found: dict[str, Judged] = {}
        for name in filter(None, (part.strip() for part in asked.split(","))):
            if name.removesuffix("!") in self.by_id and name.endswith("!"):
                found[name[:-1]] = self.by_id[name[:-1]]
                continue
            names = {name, *(a for a, b in PROPOSITIONS.items() if b == name), PROPOSITIONS.get(name, name)}
            here = {x.id: x for x in self.all if any(belongs(x.id, n) for n in names)}
            if not here:
                raise InvalidInput(self._unknown(name))
            found |= here
        if not found:
            raise InvalidInput(
                "no claim is named: give an id such as thm-8.delaunay, or an item such as thm-8"
            )
        return tuple(found.values())

    def _unknown(self, name: str) -> str:
        near = get_close_matches(name, {*self.by_id, *items()}, n=2, cutoff=0.4)
        return f"there is no claim {name!r}" + (f": did you mean {' or '.join(near)}?" if near else "")

    def needs(self, x: Judged, kinds: Collection[str] = ("to_state", "to_prove")) -> tuple[str, ...]:
        """The claims that one needs; a name of an item stands for all claims below it."""
        named = (name for kind in kinds for name in getattr(x.claim, kind))
        return tuple(dict.fromkeys(id for name in named for id in self._exactly(name) if id != x.id))

    def _exactly(self, name: str) -> tuple[str, ...]:
        return (name,) if name in self.by_id else tuple(id for id in self.by_id if belongs(id, name))

    @cached_property
    def needed_by(self) -> dict[str, tuple[str, ...]]:
        """For each claim, those that need it, to be stated or proved."""
        found: dict[str, list[str]] = {x.id: [] for x in self.all}
        for x in self.all:
            for id in self.needs(x):
                found[id].append(x.id)
        return {id: tuple(names) for id, names in found.items()}

    def dependents(self, ids: Iterable[str]) -> tuple[str, ...]:
        """All claims that rest on some others, directly or through others; without these."""
        return self._closure(ids, self.needed_by.__getitem__)

    def closure(self, ids: Iterable[str], kinds: Collection[str] = ("to_prove",)) -> tuple[str, ...]:
        """All claims on which some others rest, directly or through others; without these."""
        return self._closure(ids, lambda id: self.needs(self.by_id[id], kinds))

    def _closure(self, ids: Iterable[str], step: Callable[[str], Iterable[str]]) -> tuple[str, ...]:
        given = set(ids)
        seen, waiting = set(given), list(given)
        while waiting:
            new = [id for id in step(waiting.pop()) if id not in seen]
            seen.update(new)
            waiting.extend(new)
        return tuple(id for id in self.by_id if id in seen - given)


def gravest(claims: Iterable[Judged]) -> Judged:
    """The claim whose verdict stands for all of them: the gravest, and of equals the least known."""
    return min(claims, key=lambda x: x.gravity)


@lru_cache(maxsize=4)
def judge_all(folder: Path | None = None) -> Ledger:
    """Judge all claims on all processors, or read what came out when the same library judged them last.

    Parameters
    ----------
    folder
        Where the results are kept; by default nowhere.
    """
    claims = all_claims()
    file = folder / f"{sources_key()}.pickle" if folder else None
    if file and file.exists():
        results: tuple[Result, ...] = pickle.loads(file.read_bytes())
    else:
        with process_pool(cpus()) as pool:
            results = verify(executor=pool)
        if file and not any(x.trouble for x in results):
            _keep(file, pickle.dumps(results))
    return Ledger(tuple(Judged(claims[x.id], x) for x in results))


def _keep(file: Path, data: bytes) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    part = file.with_suffix(".part")
    part.write_bytes(data)
    part.replace(file)  # at once: another process may be reading


def sources_key(left_out: Collection[str] = VIEWS) -> str:
    """A hash of all that verdicts depend on: the library with its data, and what it computes with."""
    versions = [platform.python_version(), *map(version, ("numpy", "sympy", "networkx", "python-flint"))]
    digest = hashlib.sha256(" ".join(versions).encode())
    for path in sorted(LIBRARY.rglob("*")):
        name = path.relative_to(LIBRARY)
        if path.is_file() and path.suffix in (".py", ".json") and name.parts[0] not in left_out:
            digest.update(name.as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()[:16]
