"""The data of the paper's sentences: read by claim, and refused by file and line when damaged."""

import pytest

from coxeter.paper import DamagedData, load_prose, prose

GOOD = '[\n{"id": "def-1", "n": 3, "words": ["a", ["b", 2]]},\n{"id": "def-2", "angle": "pi/2"}\n]\n'


def write(directory, **files):
    for name, text in files.items():
        (directory / f"{name}.json").write_text(text, encoding="utf-8")
    return directory


def test_all_files_are_read_and_lists_become_tuples(tmp_path):
    found = load_prose(write(tmp_path, a=GOOD, b='[\n{"id": "thm-1", "low": true}\n]\n'))
    assert found == {
        "def-1": {"n": 3, "words": ("a", ("b", 2))},
        "def-2": {"angle": "pi/2"},
        "thm-1": {"low": True},
    }


def test_the_papers_sentences_are_undamaged():
    assert "def-8" in prose()


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ('{"id": "def-2", "n": 1}', r"a second record 'def-2', beside that in a\.json, line 3"),
        ('{"id": "thm-1"}', "at least one constant"),
        ('{"n": 1}', "the entry 'id'"),
        ('{"id": 7, "n": 1}', "the entry 'id'"),
        ('{"id": "thm-1", "n": 1.5}', "no number, text or list"),
        ('{"id": "thm-1", "n": {"m": 1}}', "no number, text or list"),
        ('{"id": "thm-1", "n": null}', "no number, text or list"),
        ('["thm-1"]', "not a record"),
        ('{"id": "thm-1", "n": 1', "Expecting"),
    ],
)
def test_damage_is_named_with_file_and_line(tmp_path, line, message):
    write(tmp_path, a=GOOD, b=f'[\n{{"id": "thm-2", "n": 1}},\n{line}\n]\n')
    with pytest.raises(DamagedData, match=rf"b\.json, line [34]: .*{message}"):
        load_prose(tmp_path)


def test_a_second_record_in_the_same_file_is_refused(tmp_path):
    twice = '[\n{"id": "def-1", "n": 3},\n{"id": "def-1", "n": 3}\n]\n'
    with pytest.raises(DamagedData, match=r"a\.json, line 3: a second record 'def-1'"):
        load_prose(write(tmp_path, a=twice))
