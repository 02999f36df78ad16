"""The views by the names under which a page asks for them, and the files beside the pages."""

from __future__ import annotations

import html
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial

from ..errors import InvalidInput
from ..scenes import scene
from . import errata_files, landing, listing
from .choosing import CHOICES
from .corrected import Sheet, sheets
from .corrected_page import sheet_html
from .errata import GROUPS, Erratum, errata
from .errata_page import errata_table
from .explorer import explorer
from .graph import drawing, in_words
from .graph_page import graph_page
from .judged import Ledger
from .markup import downloads
from .naming import Site
from .qualities import as_csv
from .trust import rates, trust

_sheets = lru_cache(maxsize=1)(sheets)


def _scene(name: str) -> str:
    return scene(name)._repr_html_()


@dataclass(frozen=True, eq=False, repr=False)
class Views:
    """All that pages show of a ledger, as HTML."""

    ledger: Ledger

    @cached_property
    def errata(self) -> tuple[Erratum, ...]:
        """The errata."""
        return errata(self.ledger)

    def view(self, name: str, lines: Sequence[str], site: Site) -> str:
        """A view by its name, ``summary``, or its name with what it is about, ``errata proofs``.

        Parameters
        ----------
        lines
            What stands in the body of the directive.

        Raises
        ------
        InvalidInput
            If there is no such view; the message says which there are.
        """
        makers = self._makers(lines, site)
        if name not in makers:
            raise InvalidInput(f"there is no view {name!r}; there are {', '.join(makers)}")
        return makers[name]()

    def _makers(self, lines: Sequence[str], site: Site) -> Mapping[str, Callable[[], str]]:
        def group(name: str) -> Callable[[], str]:
            return lambda: errata_table([e for e in self.errata if e.group == name], site)

        def sheet(made: Sheet) -> Callable[[], str]:
            return lambda: sheet_html(made, self.ledger, self.errata, site)

        def choice(make: Callable[[Ledger, Site], str]) -> Callable[[], str]:
            return lambda: make(self.ledger, site)

        return {
            "summary": lambda: listing.summary_table(self.ledger),
            "listing": lambda: listing.listing(self.ledger, site),
            "graph": lambda: graph_page(self.ledger, site),
            "dependencies": lambda: in_words(self.ledger, site),
            "trust": lambda: trust(lines, self.ledger, site),
            "rates": rates,
            "tilings": landing.tilings,
            "numbers": lambda: landing.numbers(self.ledger, site),
            **{f"scene {name}": partial(_scene, name) for name in ("A~3", "B~3", "C~3")},
            "explorer": lambda: explorer(self.ledger, site),
            "files": lambda: self._links(lines, site),
            **{f"choice {name}": choice(make) for name, make in CHOICES.items()},
            **{f"errata {name}": group(name) for name in GROUPS},
            **{f"table {made.number}": sheet(made) for made in _sheets()},
        }

    def _links(self, lines: Sequence[str], site: Site) -> str:
        """Links to files, of which each line has one: its name, a colon, and what to call it."""
        asked = {}
        for line in filter(str.strip, lines):
            name, _, words = line.partition(":")
            if name not in self.files:
                raise InvalidInput(f"there is no file {name!r}; there are {', '.join(self.files)}")
            asked[html.escape(words.strip() or name)] = site.download(name)
        return downloads(asked)

    @cached_property
    def files(self) -> dict[str, str]:
        """The downloads by their names."""
        return {
            "errata.json": errata_files.as_json(self.errata),
            "errata.csv": errata_files.as_csv(self.errata),
            "errata.tex": errata_files.as_latex(self.errata, len(self.ledger)),
            "ledger.json": listing.as_json(self.ledger),
            "qualities.csv": as_csv(),
            "dependencies.svg": drawing(self.ledger, Site("../")) + "\n",
            **{
                f"table-{made.number}.{end}": made.render(format) + "\n"
                for made in _sheets()
                for end, format in (("csv", "csv"), ("json", "json"), ("tex", "latex"))
            },
        }
