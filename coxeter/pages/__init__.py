"""What the book shows of the ledger: badges, errata, dependencies, corrected tables, numbers for prose.

All of it is made from `Ledger`, which holds every claim with what came of judging it; nothing is typed by
hand.
"""

from .explanation import Explanation, explain
from .headline import headline
from .judged import Judged, Ledger, judge_all

__all__ = ["Explanation", "Judged", "Ledger", "explain", "headline", "judge_all"]
