"""The page *Speed*: made from the benchmark's results, which have every line that is wanted."""

import json
import re

import book_speed
import pytest

from coxeter.names import triangulations_up_to

RESULTS = json.loads(book_speed.RESULTS.read_text(encoding="utf-8"))


def test_every_line_is_there():
    assert [row["d"] for row in RESULTS["gudhi"]] == list(range(2, 11))
    wanted = {kind.affine for kind in triangulations_up_to(10) if kind.family != "A"}
    assert {row["name"] for row in RESULTS["families"]} == wanted
    assert {(r["family"], r["d"]) for r in RESULTS["growth"]} >= {(f, d) for f in "ABCD" for d in (100, 1000)}
    assert [row["d"] for row in RESULTS["patches"]] == list(range(2, 7))
    assert RESULTS["file"]["chunks"]["bytes"] >= 0
    assert RESULTS["dask"]["two"]["median"] > 0


@pytest.mark.parametrize("part", book_speed.PARTS)
def test_a_part_shows_the_results(part):
    made = book_speed.PARTS[part](RESULTS)
    assert made.startswith("<")
    assert f"{{speed}} {part}\n" in (book_speed.RESULTS.parents[1] / "book" / "speed.md").read_text()


def test_a_ratio_is_that_of_medians():
    row = {"d": 2, "points": 10, **{k: {"median": v} for k, v in (("ours", 1), ("numpy", 2), ("gudhi", 7))}}
    cells = re.findall(r"<td[^>]*>(.*?)</td>", book_speed.against_gudhi({"gudhi": [row]}))
    assert cells[-2:] == ["7.00", "3.50"]


def test_d_log_d_has_the_exponent_of_d_log_d():
    ends = [{"d": d, "points": 1, "ours": {"median": d**1.5}} for d in (100, 1000)]
    assert book_speed.exponent(ends, "ours") == pytest.approx(1.5)
