"""Tables 1 to 6 and the table of the regular simplex, cell by cell."""

from __future__ import annotations

from .record_decimals import decimal_claims
from .record_formulas import formula_claims
from .record_points import completeness_claims, point_claims
from .record_statements import statement_claims

point_claims(lambda p: p.place == "Table 1")
statement_claims(lambda s: s.place == "Table 1")
completeness_claims("Table 1")
formula_claims(lambda f: f.place in ("Table 2", "Section 5, table of the regular simplex"))
for _table in (3, 4, 5, 6):
    decimal_claims(_table)
