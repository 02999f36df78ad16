"""What the theme itself does amiss, and what is let pass for a reason. All else that is found is a fault."""

import re
from collections import Counter
from dataclasses import dataclass, field

from browse_page import Seen


@dataclass(frozen=True)
class Excuse:
    """Findings of a kind whose words match a pattern, and why they are let pass."""

    kind: str
    pattern: str
    reason: str


EXCUSES = [
    Excuse(
        "errors",
        r"^console: Got invalid theme mode: \. Resetting to auto\.$",
        "the theme says so on a reader's first visit, and means that it follows the reader's system",
    ),
    Excuse(
        "axe",
        r"^aria-required-children: \.citation-list ",
        "Sphinx gives a list of references the role of a list, but its entries no role",
    ),
]


@dataclass
class Baseline:
    """The excuses, and how often each was needed."""

    excuses: list[Excuse] = field(default_factory=lambda: EXCUSES)
    needed: Counter[Excuse] = field(default_factory=Counter)

    def excuse(self, seen: Seen) -> None:
        """Take from what was seen on a page all that is known."""
        for kind, findings in seen.found.items():
            seen.found[kind] = [text for text in findings if not self._known(kind, text)]

    def _known(self, kind: str, text: str) -> bool:
        for excuse in self.excuses:
            if kind.startswith(excuse.kind) and re.search(excuse.pattern, text):
                self.needed[excuse] += 1
                return True
        return False

    def used(self) -> str:
        lines = [f"  {self.needed[it]:5} of {it.kind}, /{it.pattern}/: {it.reason}" for it in self.excuses]
        return "\n".join(["Let pass:", *lines]) if lines else ""
