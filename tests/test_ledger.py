"""The ledger's machinery, on claims that are made up; and what the real one must have: see the end."""

import json
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import replace
from itertools import pairwise

import pytest
import record_ledger
import synthetic
from distributed import Client, LocalCluster
from synthetic import ANGLE, BLIND, ENDLESS, GOOD, NUMBER, RAISES, TRIPS, ledger_of, make, number

from coxeter import ledger, proofs
from coxeter.errors import CoxeterError, InvalidInput
from coxeter.ledger import inventory
from coxeter.ledger.claim import CLAIMS, BrokenTool, Equivalent, agree, holds, register
from coxeter.ledger.mutants import OTHER_WORDS, mutants
from coxeter.ledger.pools import process_pool
from coxeter.ledger.recorded import differences, record, recorded, write
from coxeter.ledger.reporting import compare, score
from coxeter.ledger.rooms import ROOMS
from coxeter.ledger.running import Result, run, verify
from coxeter.ledger.selecting import families_of, section_of, select
from coxeter.ledger.vocabulary import FINITE
from coxeter.paper import DamagedData
from coxeter.proofs import Refuted


@pytest.fixture
def good(tmp_path):
    """A ledger in which everything is as recorded; the file with the records."""
    with ledger_of(tmp_path, *GOOD) as file:
        yield file


def alter(file, old, new):
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new), encoding="utf-8")
    ledger.recorded._load.cache_clear()


# -- running a claim -------------------------------------------------------------------------------------


def test_a_claim_is_judged_with_its_mutants():
    result = run(ANGLE)
    assert (result.id, result.trouble, result.survivors) == ("def-90", "", ())
    assert result.tried == result.rejected == len(list(mutants(ANGLE.printed))) == 3
    assert 0 < result.seconds < 1


def test_mutants_of_a_corrected_statement_are_those_of_the_correction():
    result = run(NUMBER)
    assert result.finding.correction == "number: printed 4, true 3"
    assert (result.tried, result.rejected) == (3, 3)  # 4 and 2 are wrong; -3 is refused


def test_survivors_of_mutation_are_named():
    result = run(BLIND)
    assert result.survivors == ("n: 2", "n: 0", "n: -1")
    assert (result.tried, result.rejected) == (3, 0)


def test_words_and_quotients_have_mutants_too():
    for words in ("the coweight lattice", "x_4 = 0", "F~4", "u_k", "="):
        assert [x["it"] for _, x in mutants({"it": words})] == [OTHER_WORDS]
    assert [x["it"] for _, x in mutants({"it": "h/L"})] == ["h * L", "-(h/L)"]


def test_a_check_that_raises_is_an_error_not_a_verdict():
    result = run(RAISES)
    assert result.finding is None
    assert result.trouble.startswith("error: ValueError: no idea (synthetic.py, line ")


def test_a_tool_that_does_not_work_is_an_error_that_names_the_claim():
    def check(printed):
        raise BrokenTool("the witness does not check")

    claim = make("thm-95", check)
    with pytest.raises(BrokenTool, match=r"^thm-95: no verdict, for the witness does not check$"):
        claim.judge()
    assert run(claim).finding is None
    assert run(claim).trouble.startswith("error: BrokenTool: thm-95: no verdict, for the witness does not")


@pytest.mark.usefixtures("good")
def test_an_id_is_given_once():
    with pytest.raises(InvalidInput, match="two claims 'def-90'"):
        register(replace(ANGLE, check=number))
    with pytest.raises(InvalidInput, match="two claims 'def-90'"):
        register(ANGLE)
    assert CLAIMS["def-90"] is ANGLE


def test_a_check_that_raises_for_a_mutant_is_an_error_which_names_it():
    assert "KeyError" in run(TRIPS).trouble
    assert "with the mutant n: 2" in run(TRIPS).trouble


def test_a_mutant_that_says_the_same_does_not_count():
    def check(printed):
        if printed["n"] == -1:
            raise Equivalent("only the square matters")
        return agree(printed, {"n": 1}, FINITE)

    result = run(make("x", check, printed={"n": 1}))
    assert (result.tried, result.survivors) == (2, ())


def test_a_correction_that_its_own_check_refuses_is_an_error():
    wrong = make("x", lambda _: replace(holds(FINITE), verdict=ledger.Verdict.CORRECTED, constants={"n": 1}))
    assert "not accepted by its own check" in run(wrong).trouble


def test_out_of_time_is_an_outcome_of_its_own():
    before = signal.getsignal(signal.SIGPROF)
    result = run(ENDLESS, budget=0.1)
    assert result.finding is None
    assert result.trouble == "timeout: not done after 0.1 s"
    assert result.seconds < 5
    assert signal.getitimer(signal.ITIMER_PROF) == (0, 0)
    assert signal.getsignal(signal.SIGPROF) is before


def test_in_a_thread_its_own_time_is_measured_for_want_of_an_alarm():
    def work(printed):
        until = time.thread_time() + 0.05
        while time.thread_time() < until:
            pass
        return holds(FINITE)

    def wait(printed):
        time.sleep(0.05)
        return holds(FINITE)

    with ThreadPoolExecutor(1) as pool:
        slow, waiting = pool.map(lambda check: run(make("x", check), budget=0.01), (work, wait))
    assert slow.finding is None
    assert slow.trouble.startswith("timeout: done after")
    assert waiting.trouble == ""


# -- running many ----------------------------------------------------------------------------------------


@pytest.mark.usefixtures("good")
def test_results_come_in_the_order_asked_for():
    assert [x.id for x in verify()] == [x.id for x in GOOD]
    assert [x.id for x in verify(["thm-9", "def-90"])] == ["thm-9", "def-90"]
    with ThreadPoolExecutor(2) as pool:
        assert [x.id for x in verify(executor=pool)] == [x.id for x in GOOD]


@pytest.mark.usefixtures("good")
def test_an_unknown_id_is_refused_with_the_nearest():
    with pytest.raises(InvalidInput, match=r"'thm-90\.numbr': did you mean thm-90\.number"):
        verify(["thm-90.numbr"])


@pytest.mark.usefixtures("good")
def test_progress_is_told():
    told = []
    verify(progress=lambda done, of: told.append((done, of)))
    assert told == [(n, 5) for n in range(6)]


@pytest.mark.usefixtures("good")
def test_what_an_executor_cannot_do_is_an_error_of_the_claims():
    class Broken(Executor):
        def submit(self, *_):
            future = Future()
            future.set_exception(BrokenProcessPool("a worker died"))
            return future

    class Closed(Executor):
        def submit(self, *_):
            raise RuntimeError("closed")

    for executor, message in ((Broken(), "error: BrokenProcessPool: a worker died"), (Closed(), "closed")):
        results = verify(executor=executor)
        assert len(results) == 5
        assert all(message in x.trouble and x.finding is None for x in results)


def test_a_proof_that_does_not_hold_is_an_error(tmp_path, monkeypatch):
    def prove(*about):
        if about == ("wrong",):
            raise Refuted("for d = 3 it is 4")

    monkeypatch.setattr(proofs, "prove", prove)
    right, wrong = (
        make(id, lambda _, id=id: holds(FINITE, proof=(id,)), printed={}) for id in ("right", "wrong")
    )
    with ledger_of(tmp_path, right, wrong):
        assert [x.trouble.partition(" (")[0] for x in verify()] == ["", "error: Refuted: for d = 3 it is 4"]


def script(tmp_path, body):
    """A program in whose process, and in whose workers, there are made-up claims only."""
    path = tmp_path / "program.py"
    path.write_text(
        "import sys\n"
        f"sys.path.insert(0, {os.path.dirname(synthetic.__file__)!r})\n"
        "from pathlib import Path\n"
        "import synthetic\n"
        f"made_up = synthetic.ledger_of(Path({str(tmp_path)!r}), *synthetic.GOOD, synthetic.ENDLESS)\n"
        "made_up.__enter__()\n"
        f"if __name__ == '__main__':\n    {body}\n",
        encoding="utf-8",
    )
    return [sys.executable, str(path)]


def test_workers_find_what_the_process_itself_finds(tmp_path):
    body = (
        "from coxeter.ledger import verify; from coxeter.ledger.pools import process_pool\n"
        "    ids = [x.id for x in synthetic.GOOD]\n"
        "    with process_pool(2) as pool:\n"
        "        found = verify(ids, pool)\n"
        "    print([x.finding for x in found] == [x.finding for x in verify(ids)])"
    )
    done = subprocess.run(script(tmp_path, body), capture_output=True, text=True, timeout=60, check=False)
    assert (done.stdout, done.stderr) == ("True\n", "")


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_an_interrupt_stops_everything_without_a_traceback(tmp_path, jobs):
    begun = tmp_path / "begun"
    program = subprocess.Popen(
        script(tmp_path, f"from coxeter import cli; sys.exit(cli.main(['verify', '--jobs', '{jobs}']))"),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=os.environ | {"ENDLESS": str(begun)},
    )
    until = time.time() + 30
    while not begun.exists() and time.time() < until:
        time.sleep(0.05)
    program.send_signal(signal.SIGINT)
    out, err = program.communicate(timeout=15)
    assert (program.returncode, out, err) == (130, "", "coxeter: stopped\n")


def test_dask_spreads_the_claims():
    """Its workers judge in threads, and send results as if they were on another machine."""
    ids = list(select(["tab-3"]))
    assert len(ids) > 24  # several batches
    how = {"processes": False, "protocol": "tcp", "dashboard_address": None}
    with (
        LocalCluster(n_workers=2, threads_per_worker=2, **how) as cluster,
        Client(cluster) as client,
    ):
        found = verify(ids, executor=client.get_executor())
    here = verify(ids)
    assert [(x.finding, x.trouble, x.tried) for x in found] == [(x.finding, "", x.tried) for x in here]


# -- the recorded ledger ---------------------------------------------------------------------------------


def test_records_are_read_as_they_were_written(good):
    lines = good.read_text(encoding="utf-8").splitlines()
    assert len(lines) == len(GOOD) + 2
    assert set(json.loads(lines[1].removesuffix(","))) == {
        "id", "room", "verdict", "strength", "weight", "correction", "about",
    }  # fmt: skip
    again = recorded()
    assert list(again) == [x.id for x in GOOD]
    assert [x.line for x in again.values()] == [2, 3, 4, 5, 6]
    write(again.values(), good)
    assert recorded(good) == again


def test_no_records_are_records_too(tmp_path):
    write([], tmp_path / "none.json")
    assert recorded(tmp_path / "none.json") == {}


@pytest.mark.parametrize(
    ("old", "new", "line", "message"),
    [
        ('"holds, corrected"', '"holds, of course"', 3, "'holds, of course' is no verdict"),
        ('"exact up to d = 8"', '"exact up to 8"', 3, "'exact up to 8' is no strength"),
        ('"a proof"', '"a prof"', 5, "'a prof' is no weight"),
        ('"weight": "wording"', '"wait": "wording"', 2, "unknown entry 'wait'"),
        (', "correction": "radius 1 at most"', "", 4, "the entry 'correction' is missing"),
        ('"correction": "radius 1 at most"', '"correction": 1', 4, "cannot be the entry 'correction'"),
        ('"room": "made_up"', '"room": "no_room"', 2, "'no_room' is no room"),
        ('"thm-9"', '"def-90"', 6, "a second record 'def-90', beside that in line 2"),
        ('"proof repaired"', '"proof repaired', 5, ""),
        ("]\n", "", 1, ""),
    ],
)
def test_a_damaged_record_is_named_with_file_and_line(good, old, new, line, message):
    alter(good, old, new)
    where = line if message else r"\d+"  # in broken JSON, that of the reader
    with pytest.raises(DamagedData, match=rf"recorded\.json, line {where}: .*{message}"):
        recorded()


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(DamagedData, match=r"none\.json, line 1: cannot be read"):
        recorded(tmp_path / "none.json")


@pytest.mark.parametrize(
    ("entry", "other"),
    [("verdict", "fails"), ("strength", "every d"), ("weight", "a proof"), ("correction", "number: 5")],
)
def test_every_difference_is_told(entry, other):
    expected = record(NUMBER, NUMBER.judge())
    found = replace(expected, **{entry: other})
    assert differences(expected, found) == (
        f"{entry}: expected {getattr(expected, entry)!r}, came out {other!r}",
    )
    assert not differences(expected, replace(expected, room="elsewhere", line=7))


@pytest.mark.usefixtures("good")
def test_an_altered_wrong_printed_value_is_noticed():
    """The verdict stays the same; the correction tells."""
    CLAIMS["thm-90.number"] = replace(NUMBER, printed={"number": 5})
    (entry,) = [x for x in compare(verify()).entries if x.outcome != "as recorded"]
    assert entry.outcome == "differs"
    correction, about = entry.problems
    assert correction == (
        "correction: expected 'number: printed 4, true 3', came out 'number: printed 5, true 3'"
    )
    assert about.startswith("about: expected ")


@pytest.mark.usefixtures("good")
def test_outcomes():
    results = verify()
    assert compare(results).ok
    for claim in (BLIND, RAISES, TRIPS):
        CLAIMS[claim.id] = claim
    del CLAIMS["thm-9"]
    assert {x.id: x.outcome for x in compare(verify()).entries} == {
        "def-90": "as recorded",
        "thm-90.number": "as recorded",
        "thm-90.false": "as recorded",
        "lem-90": "as recorded",
        "thm-91": "differs",  # it is not on record
        "thm-92": "error",
        "thm-93": "error",
        "thm-9": "differs",  # only on record
    }
    assert not compare(verify()).ok


def test_survivors_alone_are_an_outcome(tmp_path):
    with ledger_of(tmp_path, BLIND):
        (entry,) = compare(verify()).entries
    assert entry.outcome == "mutants survive"
    assert entry.problems[0] == "this mutant is not rejected: n: 2"


def test_the_score_is_full_only_if_all_are_rejected():
    def of(tried, survivors):
        return score([Result("x", None, 0.0, tried=tried, survivors=("n",) * survivors)])

    assert of(1234, 0) == "1234 of 1234 mutants rejected, 100 %"
    assert of(100_000, 1) == "99999 of 100000 mutants rejected, 99.9 %"
    assert of(1, 1) == "0 of 1 mutant rejected, 0 %"
    assert score([]) == of(0, 0) == "no mutants to reject"


@pytest.mark.usefixtures("good")
def test_the_summary_counts_verdicts_by_strength():
    CLAIMS[RAISES.id] = RAISES
    lines = str(compare(verify())).splitlines()
    table = [line.split() for line in lines if line.startswith(("holds ", "fails", "cited", "error", "all"))]
    assert ["error", "·", "·", "·", "·", "·", "1", "1"] in table
    assert ["all", "1", "1", "1", "1", "1", "1", "6"] in table
    assert "6 of 6 mutants rejected, 100 %" in lines
    assert "1 claim not as recorded:" in lines


# -- selecting -------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("good")
def test_an_item_stands_for_all_its_claims():
    assert list(select()) == [x.id for x in GOOD]
    assert list(select(["thm-90"])) == ["thm-90.number", "thm-90.false"]
    assert list(select(["thm-9", "lem-90"])) == ["lem-90", "thm-9"]  # in the order of the paper
    assert list(select(["thm-90.false"])) == ["thm-90.false"]


@pytest.mark.usefixtures("good")
def test_sections_and_families():
    assert list(select(section="3")) == ["thm-90.number", "thm-90.false"]
    assert list(select(section="a")) == ["thm-9"]
    assert list(select(family="B")) == ["def-90"]
    assert list(select(["def-90"], section="6", family="B~")) == ["def-90"]


@pytest.mark.usefixtures("good")
@pytest.mark.parametrize(
    ("how", "message"),
    [
        ({"ids": ["thm-91"]}, "did you mean"),
        ({"section": "7"}, "1 to 6, or A to D"),
        ({"section": "E"}, "1 to 6, or A to D"),
        ({"family": "H"}, "one of A to G"),
        ({"family": "E9"}, "one of A to G"),
        ({"ids": ["thm-90"], "section": "6"}, "no claim has all"),
        ({"family": "G"}, "no claim has all"),
    ],
)
def test_a_wrong_selection_is_refused(how, message):
    with pytest.raises(InvalidInput, match=message):
        select(**how)


@pytest.mark.parametrize(
    ("id", "place", "families"),
    [
        ("sec6.E8.item-8.sign", "", "E8"),
        ("tab-6.B.3", "", "B"),
        ("tab-6.E.7", "", "E7"),
        ("tab-6.E.5", "", "E6 E7 E8"),
        ("tab-6.C.8", "Table 6, row C~", "C"),
        ("tab-2.G", "", "G2"),
        ("prop-8", "", "B"),
        ("prop-12.step-2", "", "E7"),
        ("lem-7.volume", "", "A"),
        ("fig-11", "", "F4"),
        ("fig-12", "", ""),
        ("claim-c", "Appendix C", ""),
        ("rem-5", "Appendix C, on Ã_d and C~_{d}", "A C"),
        ("lem-3", "Section 4, E~6 and F~4", "E6 F4"),
        ("def-18.A-shaped", "Appendix D, B", ""),
    ],
)
def test_families_by_id_and_place(id, place, families):
    assert families_of(make(id, holds, place=place)) == frozenset(families.split())


@pytest.mark.parametrize(
    ("id", "place", "code", "section"),
    [
        ("def-8", "Section 2.2, Definition 8", "coxeter.ledger.section_5.f", "2"),
        ("lem-12", "Appendix C, Lemma 12", "", "C"),
        ("tab-6.B.3", "Table 6", "coxeter.ledger.section_5_tables.f", "5"),
        ("lem-8", "Lemma 8", "coxeter.ledger.appendix_a.f", "A"),
        ("tab-6.B.3", "Table 6", "coxeter.ledger.records.f", "5"),
        ("tab-1.B.u-1", "Table 1", "coxeter.ledger.records.f", "2"),
        ("def-8", "Somewhere", "coxeter.ledger.f", ""),
    ],
)
def test_the_section_by_place_or_room_or_item(id, place, code, section):
    assert section_of(replace(make(id, holds, place=place), code=code)) == section


# -- the inventory ---------------------------------------------------------------------------------------


def claims_of(*pairs):
    return {id: make(id, holds, to_state=state, to_prove=prove) for id, state, prove in pairs}


def test_the_items_are_complete_by_construction():
    items = inventory.items()
    assert len(items) == len(set(items)) == 92 + 3 + 8 * 9 + 4
    assert {"def-21", "thm-9", "lem-15", "prop-14", "cor-2", "rem-5", "eq-7", "tab-6", "fig-13"} <= set(items)
    assert {"claim-c", "tab-angles", "tab-regular", "sec6.A.item-1", "sec6.F4.item-9"} <= set(items)


def test_an_item_without_a_claim_is_missing():
    every = list(inventory.items())
    assert not inventory.missing(every)
    for item in every:
        assert inventory.missing([x for x in every if x != item]) == (
            () if item in inventory.PROPOSITIONS.values() else (item,)
        )
    parts = [f"{x}.part" for x in every]
    assert not inventory.missing(parts)
    assert "def-1" in inventory.missing([x for x in every if x != "def-1"])  # def-12 is none of its parts
    lost = [x for x in every if x not in ("prop-7", "sec6.A.item-9")]
    assert inventory.missing(lost) == ("prop-7", "sec6.A.item-9")


def test_unknown_dependencies_are_found():
    claims = claims_of(("a", ["b", "c"], []), ("b", [], ["d", "c"]), ("c", [], []))
    assert inventory.unknown_dependencies(claims) == {"b": ("d",)}


def test_a_dependency_on_an_item_means_all_its_claims():
    claims = claims_of(("def-1.a", [], []), ("def-1.b", ["c"], []), ("c", ["def-1"], []), ("def-12", [], []))
    assert inventory.meant("def-1", claims) == ("def-1.a", "def-1.b")
    assert not inventory.unknown_dependencies(claims)
    assert len(inventory.cycles(claims)) == 1


def test_circles_are_found():
    claims = claims_of(
        ("a", ["b"], []), ("b", [], ["c"]), ("c", ["a"], []), ("d", ["a"], ["d"]), ("e", [], [])
    )
    circles = inventory.cycles(claims)
    assert len(circles) == 2
    for circle in circles:
        assert circle[0] == circle[-1]
        for one, needed in pairwise(circle):
            assert needed in inventory.dependencies(claims[one])
    assert not inventory.cycles(claims_of(("a", ["b", "c"], []), ("b", ["c"], ["c"]), ("c", [], [])))


def test_a_place_without_its_constant_is_found():
    claims = {
        "a": make("a", holds, words="It is {n} in $x_{k}$ and {m}.", printed={"n": 1}),
        "b": make("b", holds, words="It is {n}.", printed={"n": 1}),
    }
    assert list(inventory.unfilled(claims)) == ["a"]


# -- recording -------------------------------------------------------------------------------------------


def test_recording_shows_what_changes(good, capsys):
    alter(good, '"correction": "radius 1 at most"', '"correction": "radius 2 at most"')
    CLAIMS["lem-91"] = replace(synthetic.GAP, id="lem-91")
    del CLAIMS["thm-9"]
    assert record_ledger.main(["--jobs", "1", "--file", str(good)]) == 0
    out = capsys.readouterr().out
    assert "gone: thm-9: cited · literature" in out
    assert "new: lem-91: proof repaired" in out
    assert "thm-90.false: correction: expected 'radius 2 at most', came out 'radius 1 at most'" in out
    assert "5 claims; 6 of 6 mutants rejected, 100 %; 3 changes" in out
    assert [(x.id, x.room) for x in recorded(good).values()] == [(id, synthetic.ROOM) for id in CLAIMS]
    assert compare(verify()).ok


@pytest.mark.parametrize("bad", [RAISES, BLIND])
def test_nothing_is_recorded_while_there_are_troubles(good, capsys, bad):
    CLAIMS[bad.id] = bad
    before = good.read_bytes()
    arguments = ["--jobs", "1", "--file", str(good)]
    assert record_ledger.main(arguments) == 1
    assert good.read_bytes() == before
    assert "Not recorded" in capsys.readouterr().err
    assert record_ledger.main([*arguments, "--force"]) == 0
    assert (bad.id in recorded(good)) == (bad is BLIND)


def test_a_damaged_file_can_be_recorded_anew(good):
    good.write_text("[\n", encoding="utf-8")
    ledger.recorded._load.cache_clear()
    assert record_ledger.main(["--jobs", "1", "--file", str(good)]) == 0
    assert len(recorded(good)) == len(GOOD)


# -- single checks ---------------------------------------------------------------------------------------


def test_a_damaged_label_must_become_the_right_one():
    claim = ledger.find_claim("sec6.E7.item-2.u-6")
    right = claim.judge().constants
    assert right["label"] == "u_6"
    assert claim.judge(right).verdict.accepts
    for label in ("u_5", "6", "", OTHER_WORDS):
        assert not claim.judge({**right, "label": label}).verdict.accepts


def test_a_moved_cell_must_come_to_its_column():
    claims = [
        x for id, x in ledger.all_claims().items() if id.startswith(("tab-3", "tab-4", "tab-5", "tab-6"))
    ]
    moved = [(x, found) for x in claims if "column" in (found := x.judge().constants or {})]
    assert moved
    for claim, right in moved:
        assert right["column"] == int(claim.id.rpartition(".")[2])
        assert claim.judge(right).verdict.accepts
        for column in (right["column"] + 1, right["column"] - 1, "yes"):
            assert not claim.judge({**right, "column": column}).verdict.accepts


@pytest.mark.parametrize("hyperplane", ["something else", "x_0 = 0", "x_9 = 0", "x_4 = 1", "x_4", "4"])
def test_what_is_no_hyperplane_is_refused(hyperplane):
    with pytest.raises(InvalidInput, match="is no hyperplane: give x_k = 0, with k from 1 to 8"):
        ledger.find_claim("sec6.E6.item-8.separates").judge({"hyperplane": hyperplane})


def test_what_does_not_separate_is_told_for_any_family():
    found = ledger.find_claim("sec6.E6.item-8.separates").judge({"hyperplane": "x_5 = 0"})
    assert (
        found.witness
        == "for E~6, the coordinate x_5: the value of c is 1/3, those of the vertices go from 0 to 1"
    )
    assert found.constants == {"facet": "4"}
    assert not found.evidence  # the centre of E~6 is printed right
    assert (
        ledger.find_claim("sec6.D.item-8.separates")
        .judge({"facet": "0"})
        .witness.startswith("for D~4, the level")
    )


# -- the real ledger: it fails here as long as something is missing --------------------------------------


def test_every_numbered_item_has_a_claim():
    missing = inventory.missing(ledger.all_claims())
    assert not missing


def test_dependencies_exist_and_run_in_no_circle():
    unknown = inventory.unknown_dependencies(ledger.all_claims())
    assert not unknown
    circles = inventory.cycles(ledger.all_claims())
    assert not circles


def test_all_printed_constants_are_used():
    unused = inventory.unused_constants(ledger.all_claims())
    assert not unused
    unfilled = inventory.unfilled(ledger.all_claims())
    assert not unfilled


def test_every_claim_has_a_section():
    astray = [id for id, claim in ledger.all_claims().items() if not section_of(claim)]
    assert not astray


def test_every_claim_is_recorded():
    assert set(recorded()) == set(ledger.all_claims())


@pytest.mark.parametrize("room", ROOMS)
def test_the_record_says_where_to_find_a_claim(room):
    """For a few claims, not every room is imported."""
    ids = [x.id for x in recorded().values() if x.room == room]
    assert ids
    program = (
        "import sys, json; from coxeter.ledger import select\n"
        "found = [x for x in select(json.loads(sys.argv[1]))]\n"
        "print(json.dumps([found, [x for x in sys.modules if x.startswith('coxeter.ledger.')]]))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, json.dumps(ids)], capture_output=True, text=True, check=True
    )
    found, modules = json.loads(done.stdout)
    assert set(found) >= set(ids)
    assert f"coxeter.ledger.{room}" in modules
    assert len({f"coxeter.ledger.{name}" for name in ROOMS} & set(modules)) < len(ROOMS)


@pytest.mark.parametrize("room", ROOMS)
def test_an_altered_printed_constant_is_noticed(room):
    """Each printed number, sign, range, word: what comes out is not what is recorded, even if it was wrong.

    The digest is that of the claim as it is, so the verdict, its strength or the correction must tell.
    """
    unnoticed = []
    ids = [x.id for x in recorded().values() if x.room == room]
    for claim in (claim for id, claim in ledger.all_claims().items() if id in ids):
        expected = record(claim, claim.judge())
        for what, constants in mutants(claim.printed):
            try:
                found = record(claim, claim.judge(constants))
            except (CoxeterError, ZeroDivisionError):  # an outcome of its own
                continue
            if not differences(expected, found):
                unnoticed.append(f"{claim.id}: {what}")
    assert ids
    assert not unnoticed


def test_processes_find_the_same():
    ids = list(select(["lem-4", "thm-5"]))
    with process_pool(2) as pool:
        found = verify(ids, pool)
    assert [(x.finding, x.trouble) for x in found] == [(x.finding, x.trouble) for x in verify(ids)]
