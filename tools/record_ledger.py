"""Judge every claim, and record what came out in coxeter/ledger/recorded.json.

Nothing is recorded while a check raises an error, runs out of time or lets a mutant pass. What changes is
shown: read it, for from then on `coxeter verify` expects it.
"""

import argparse
import sys
from collections.abc import Mapping, Sequence
from importlib import import_module
from pathlib import Path

from coxeter import ledger
from coxeter.errors import CoxeterError
from coxeter.ledger import rooms
from coxeter.ledger.claim import CLAIMS
from coxeter.ledger.pools import cpus, process_pool
from coxeter.ledger.recorded import FILE, Record, differences, record, recorded, write
from coxeter.ledger.reporting import score


def where_found() -> dict[str, str]:
    """The room in which each claim is found: import it, and the claim is there."""
    found: dict[str, str] = {}
    for room in rooms.ROOMS:
        import_module(f"{ledger.__name__}.{room}")
        for id in CLAIMS:
            found.setdefault(id, room)
    return found


def changes(old: Mapping[str, Record], new: Mapping[str, Record]) -> list[str]:
    """What the new record says otherwise than the old, a line each."""
    lines = [f"gone: {id}: {x}" for id, x in old.items() if id not in new]
    lines += [f"new: {id}: {x}" for id, x in new.items() if id not in old]
    return lines + [f"{id}: {what}" for id in new if id in old for what in differences(old[id], new[id])]


def _old(file: Path) -> Mapping[str, Record]:
    try:
        return recorded(file)
    except CoxeterError as error:
        print(f"the old record is left out of account: {error}", file=sys.stderr)
        return {}


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--jobs", type=int, default=cpus(), help="processes (default: all there are)")
    parser.add_argument("--force", action="store_true", help="record all the same what could be judged")
    parser.add_argument("--file", type=Path, default=FILE, help="where to (default: the recorded ledger)")
    options = parser.parse_args(arguments)

    where, claims = where_found(), ledger.all_claims()
    if options.jobs > 1:
        with process_pool(options.jobs) as pool:
            results = ledger.verify(executor=pool)
    else:
        results = ledger.verify()
    bad = [f"{x.id}: {x.trouble}" for x in results if x.trouble]
    bad += [f"{x.id}: this mutant is not rejected: {what}" for x in results for what in x.survivors]
    new = {x.id: record(claims[x.id], x.finding, where[x.id]) for x in results if x.finding}

    changed = changes(_old(options.file), new)
    print("\n".join([*changed, *bad, f"{len(results)} claims; {score(results)}; {len(changed)} changes"]))
    if bad and not options.force:
        print(f"Not recorded, because of {len(bad)} troubles; mend them, or give --force.", file=sys.stderr)
        return 1
    write(new.values(), options.file)
    print(f"Recorded in {options.file}.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
