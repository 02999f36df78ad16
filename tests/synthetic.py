"""A ledger made up for the tests: they must not depend on what the paper's claims come to."""

import os
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from unittest.mock import patch

from coxeter import ledger
from coxeter.errors import InvalidInput
from coxeter.ledger import recorded, rooms
from coxeter.ledger.claim import CLAIMS, Claim, agree, cited, fails, holds, repaired
from coxeter.ledger.vocabulary import EVERY_D, FINITE, INSTANCES, Weight, up_to


def angle(printed):
    return agree(printed, {"angle": 60}, FINITE, "The angle was computed.")


def number(printed):
    if printed["number"] < 0:
        raise InvalidInput("there is no such number")
    return agree(printed, {"number": 3}, up_to(8))


def false(printed):
    wrong = Fraction(1, 2) if printed["radius"] != 1 else 0
    return fails(INSTANCES, f"the triangle with radius {wrong}", f"radius {printed['radius']} at most")


def gap(printed):
    return repaired(EVERY_D, "ours uses the other side", "the square", derivation=("One.", "Two."))


def literature(printed):
    return cited("a book", tested="three triangles")


def blind(printed):
    """Accepts whatever is printed."""
    return holds(FINITE)


def raises(printed):
    raise ValueError("no\nidea")


def trips(printed):
    if printed["n"] != 1:
        raise KeyError("n")
    return holds(FINITE)


def endless(printed):
    if "ENDLESS" in os.environ:  # a file that tells when it has begun
        Path(os.environ["ENDLESS"]).touch()
    while True:
        try:
            sum(range(1000))
        except Exception:  # no check can swallow the alarm
            continue


def make(id, check, weight=Weight.RESULT, place="Section 3, Theorem 90", words="Words.", **more):
    return Claim(id, place, words, weight, check, code=f"coxeter.ledger.section_3.{check.__name__}", **more)


ANGLE = make(
    "def-90", angle, Weight.WORDING, "Section 6, B~, item 4", "It is {angle}.", printed={"angle": 60}
)
NUMBER = make("thm-90.number", number, printed={"number": 4}, to_state=("def-90",))
FALSE = make("thm-90.false", false, printed={"radius": 1}, to_state=("def-90",), to_prove=("lem-90",))
GAP = make("lem-90", gap, Weight.PROOF, "Appendix C, Lemma 90")
CITED = make("thm-9", literature, place="Appendix A, Theorem 9")
GOOD = (ANGLE, NUMBER, FALSE, GAP, CITED)

BLIND = make("thm-91", blind, printed={"n": 1})
RAISES = make("thm-92", raises)
TRIPS = make("thm-93", trips, printed={"n": 1})
ENDLESS = make("thm-94", endless)

ROOM = "made_up"


@contextmanager
def ledger_of(directory: Path, *claims: Claim) -> Iterator[Path]:
    """Let these be all claims, all recorded that can be judged; yields the file with the records."""
    file = directory / "recorded.json"
    with ExitStack() as stack:
        stack.enter_context(patch.object(rooms, "ROOMS", (ROOM,)))
        stack.enter_context(patch.object(recorded, "FILE", file))
        stack.enter_context(patch.dict(CLAIMS, {x.id: x for x in claims}, clear=True))
        stack.enter_context(patch.dict(sys.modules, {f"coxeter.ledger.{ROOM}": ModuleType(ROOM)}))
        stack.enter_context(patch.object(recorded, "ROOMS", (ROOM,)))
        ledger.all_claims.cache_clear()
        stack.callback(ledger.all_claims.cache_clear)
        known = [x for x in claims if x not in (RAISES, TRIPS, ENDLESS)]
        recorded.write(recorded.record(x, x.judge(), ROOM) for x in known)
        yield file
