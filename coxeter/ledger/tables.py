"""Tables 1 to 6 and the table of the regular simplex, cell by cell."""

from __future__ import annotations

from ..paper import printed
from .claim import Claim, Constants, Finding, agree, register
from .record_points import completeness_claims, point_claims
from .record_statements import statement_claims
from .records import decimal_claims, formula_claims
from .vocabulary import FINITE, Weight

point_claims(lambda p: p.place == "Table 1")
statement_claims(lambda s: s.place == "Table 1")
completeness_claims("Table 1")
formula_claims(lambda f: f.place in ("Table 2", "Section 5, table of the regular simplex"))


def judge_heads(constants: Constants) -> Finding:
    """The heads of the columns are the dimensions 2 to 8."""
    return agree(constants, {"heads": tuple(map(str, range(2, 9)))}, FINITE)


for _table in (3, 4, 5, 6):
    _heads = next(row.cells for row in printed().rows if row.table == _table and not row.letter)
    register(
        Claim(
            f"tab-{_table}.heads",
            f"Table {_table}",
            "The columns are those of d = {heads}.",
            Weight.WORDING,
            judge_heads,
            {"heads": _heads},
            code=f"{__name__}.judge_heads",
        )
    )
    decimal_claims(_table)
