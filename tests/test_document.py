"""The YAML border: what is read, what is refused, and that a change leaves everything else alone."""

from __future__ import annotations

import math
import os
import re
import subprocess
import sys
import tracemalloc
from collections.abc import Callable
from enum import StrEnum
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import freebody as fb
from freebody import examples_folder
from freebody.errors import InputError, ModelError, Problem
from freebody.language.document import MAX_DEPTH, Document

Within = Callable[[int, Callable[[], object]], None]

CRANK = """\
# A slider-crank.
title: slider crank   # two spaces stay

parameters:
  r:   0.1 m      # crank
  g: {value: 9.81, unit: m/s^2}   # may be changed

bodies:
  crank: {rod: r, mass: 1 kg}
  slider:
    mass: 2 kg
    # the face
    points:
      - [0, 0]
      - [1, 0]    # tip
  marker:

connections:
- pin: [ground.A, crank.start]
- {drop of left below ground.axle}
# the end
"""


def refusal(text: str, file: str | None = None) -> ModelError:
    with pytest.raises(ModelError) as caught:
        Document.read(text, file)
    return caught.value


def spots(text: str) -> list[tuple[int | None, int | None]]:
    return [(problem.line, problem.column) for problem in refusal(text).problems]


# -- values ---------------------------------------------------------------------------------------
def test_a_model_is_read_as_plain_data():
    data = Document.read(CRANK).data
    assert data["parameters"] == {"r": "0.1 m", "g": {"value": 9.81, "unit": "m/s^2"}}
    assert data["bodies"]["slider"]["points"] == [[0, 0], [1, 0]]
    assert data["bodies"]["marker"] is None
    assert data["connections"] == [
        {"pin": ["ground.A", "crank.start"]},
        {"drop of left below ground.axle": None},
    ]


def test_only_plain_python_types_come_out():
    def types(value: Any) -> set[type]:
        if isinstance(value, dict):
            return {type(value)}.union(*(types(x) for pair in value.items() for x in pair))
        if isinstance(value, list):
            return {type(value)}.union(*(types(x) for x in value))
        return {type(value)}

    text = "a: [1, 2.5, true, null, 'q']\nb:\n  c: >-\n    folded\n    text\n  d: {e}\n"
    assert types(Document.read(text).data) == {dict, list, int, float, bool, type(None), str}


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("1", 1),
        ("-12", -12),
        ("+3", 3),
        ("0", 0),
        ("1.5", 1.5),
        ("5.", 5.0),
        (".5", 0.5),
        (".5e3", 500.0),
        ("-1e-3", -0.001),
        ("2E+2", 200.0),
        ("true", True),
        ("False", False),
        ("~", None),
        ("null", None),
        ("", None),
    ],
)
def test_plain_decimal_numbers_and_the_core_words_have_their_value(written: str, value: Any):
    read = Document.read(f"a: {written}\n").data["a"]
    assert (read, type(read)) == (value, type(value))


SWITCHES = ["y", "n", "Y", "on", "off", "On", "yes", "No"]
NUMBER_LIKE = [
    "010",
    "-010",
    "01.5",
    "1_000",
    "0x10",
    "0o17",
    "0b1",
    "1e",
    "1.2.3",
    "3 kg",
    "=",
    "nan",
    "inf",
    "+",
]
TIMES = ["12:30", "1:20:30.5", "2024-01-31", "2024-01-31 10:20:30"]


@pytest.mark.parametrize("written", [*SWITCHES, *NUMBER_LIKE, *TIMES])
def test_everything_else_stays_the_text_that_is_written(written: str):
    assert Document.read(f"a: {written}\nb: [{written}]\n").data == {"a": written, "b": [written]}


@pytest.mark.parametrize("written", ["1", "1.0", "010", "on", "off", "y", "null", "true", ".inf", "<<", "2024-01-31"])
def test_a_key_is_the_text_that_is_written(written: str):
    assert Document.read(f"{written}: 1\n").data == {written: 1}


def test_quoted_numbers_are_text():
    assert Document.read("a: '1'\nb: \".nan\"\nc: 'true'\n").data == {"a": "1", "b": ".nan", "c": "true"}


def test_a_windows_file_with_a_byte_order_mark_is_read():
    document = Document.read("\ufeffa: 1\r\nb:\r\n  c: é\r\n")
    assert document.data == {"a": 1, "b": {"c": "é"}}
    assert document.place(("b", "c")) == (3, 6)


def test_data_is_made_anew_so_that_a_document_cannot_be_changed_through_it():
    document = Document.read("a: {b: [1]}\n")
    document.data["a"]["b"].append(2)
    assert document.data == {"a": {"b": [1]}}


# -- places ---------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("path", "place"),
    [
        (("title",), (2, 8)),
        (("parameters", "r"), (5, 8)),
        (("parameters", "g", "unit"), (6, 26)),
        (("bodies",), (8, 1)),
        (("bodies", "slider"), (10, 3)),
        (("bodies", "slider", "points", 1), (15, 9)),
        (("bodies", "slider", "points", 1, 0), (15, 10)),
        (("bodies", "marker"), (16, 3)),
        (("connections", 0), (19, 3)),
        (("connections", 0, "pin", 1), (19, 19)),
        (("connections", 1, "drop of left below ground.axle"), (20, 4)),
    ],
)
def test_every_value_has_the_place_where_it_is_written(path: tuple[str | int, ...], place: tuple[int, int]):
    assert Document.read(CRANK).place(path) == place


@pytest.mark.parametrize(
    ("path", "parent"),
    [
        (("bodies", "slider", "radius"), ("bodies", "slider")),
        (("bodies", "slider", "points", 9, 0), ("bodies", "slider", "points")),
        (("title", "deeper", 3), ("title",)),
        (("connections", -1), ("connections",)),
    ],
)
def test_a_path_that_does_not_exist_has_the_place_of_its_deepest_parent(path: Any, parent: Any):
    document = Document.read(CRANK)
    assert document.place(path) == document.place(parent)


def test_a_numeric_key_is_found_by_number_and_by_text():
    document = Document.read("a:\n  1: x\n")
    assert document.place(("a", 1)) == document.place(("a", "1")) == (2, 6)


def test_locate_fills_in_line_and_column_and_keeps_those_that_are_known():
    document = Document.read(CRANK)
    located = document.locate(Problem(("bodies", "slider", "mass"), "is negative"))
    assert located == Problem(("bodies", "slider", "mass"), "is negative", 11, 11)
    assert document.locate(Problem(("title",), "x", 7, 7)) == Problem(("title",), "x", 7, 7)


def test_a_model_made_in_python_has_no_places():
    document = Document.from_plain({"a": 1})
    assert document.place(("a",)) is None
    assert document.locate(Problem(("a",), "x")) == Problem(("a",), "x")


# -- refusals -------------------------------------------------------------------------------------
def test_all_refusals_of_a_file_come_in_one_message_with_their_places():
    text = (
        "a: &part {x: 1}\n"
        "b: *part\n"
        "c: !!python/object/apply:os.system [ls]\n"
        "d: [.nan, -.inf, 1e400]\n"
        "a: 2\n"
        "? [p, q]\n"
        ": 3\n"
        "e: !mine 4\n"
        "---\n"
        "f: 5\n"
    )
    error = refusal(text, "crank.yaml")
    assert [(p.line, p.column) for p in error.problems] == [
        (1, 4),
        (2, 4),
        (3, 4),
        (4, 5),
        (4, 11),
        (4, 18),
        (5, 1),
        (6, 3),
        (8, 4),
        (9, 1),
    ]
    lines = str(error).splitlines()
    said = ["'&part'", "write it out twice", "!!python/object/apply:os.system", ".nan is not a finite number"]
    said += [
        "-.inf is not",
        "1e400 is not",
        "the key a stands in line 1 already",
        "plain text",
        "'!mine'",
        "second",
    ]
    for line, words in zip(
        lines,
        said,
        strict=True,
    ):
        assert line.startswith("crank.yaml:")
        assert words in line


@pytest.mark.parametrize("number", [".nan", ".NaN", ".inf", "-.Inf", "+.INF", "1e400", "-1e999", "9" * 400, "9" * 5000])
def test_a_number_that_is_not_finite_is_refused(number: str):
    error = refusal(f"a:\n  b: [1, {number}]\n")
    assert "is not a finite number" in str(error)
    assert error.problems[0] == Problem(("a", "b", 1), error.problems[0].message, 2, 10)
    assert len(str(error)) < 80


def test_tags_are_refused_in_every_form():
    for tag in ("!", "!mine", "!!str", "!!python/name:os.system", "!<tag:x>", "!e!other"):
        assert "tag" in str(refusal(f"a: {tag} x\n"))
        assert "tag" in str(refusal(f"{tag} a: x\n"))


def test_aliases_are_refused_also_as_keys_and_where_their_anchor_is_missing():
    assert spots("*a : 1\nb: [*c]\n") == [(1, 1), (2, 5)]


def test_a_merge_key_brings_nothing_in():
    assert Document.read("a: 1\n<<: {b: 2}\n").data == {"a": 1, "<<": {"b": 2}}


def test_keys_that_name_the_same_text_are_duplicates():
    error = refusal("m: {1: a, '1': b, 1: c}\n")
    assert [p.message for p in error.problems] == [
        "the key 1 stands in line 1 already; keep one of the two, or give one of them another name"
    ] * 2
    assert error.problems[0].path == ("m", "1")


@pytest.mark.parametrize("text", [": x\n", "? {a: 1}\n: x\n", "[a]: x\n", "a: {[b]: c}\n"])
def test_a_key_that_is_not_plain_text_is_refused(text: str):
    assert "a key must be plain text" in str(refusal(text))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "the file is empty"),
        ("# only this\n", "the file is empty"),
        ("---\n", "the file is empty"),
        ("- a\n- b\n", "the file is a list"),
        ("just words\n", "the file is a single text"),
        ("3\n", "the file is the single value 3"),
        ("mass:3\n", "a space is missing after the colon in 'mass:3'"),
    ],
)
def test_a_top_level_that_is_no_mapping_is_refused(text: str, words: str):
    assert words in str(refusal(text))


def test_thirty_levels_are_read_and_one_more_is_refused():
    deepest = "[" * (MAX_DEPTH - 1) + "1" + "]" * (MAX_DEPTH - 1)
    assert Document.read(f"a: {deepest}\n").data["a"]
    assert "more than 30 deep" in str(refusal(f"a: [{deepest}]\n"))


@pytest.mark.parametrize("directive", ["%YAML 1.1", "%YAML 1.3", "%YAML 9.9", "%TAG ! x", "%WHAT"])
def test_a_directive_cannot_change_the_meaning_of_a_file(directive: str):
    assert "must not begin with '%" in str(refusal(f"# first\n{directive}\n---\na: on\n"))
    assert "must not begin with '%" in str(refusal(f"a: on\n...\n{directive}\n---\nb: 1\n"))


def test_half_a_character_is_refused():
    assert spots('a: "\\ud800"\n') == [(1, 4)]


# -- syntax ---------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        ("a:\n\tb: 1\n", (2, 1), "tab found; YAML allows spaces only"),
        ("a:\t1\n", (1, 3), "tab found; YAML allows spaces only"),
        ("bodies:\n  rod:3\n  b: 2\n", (2, 3), "a space is missing after the colon in 'rod:3'"),
        ("a: 1\nb:3\nc: 2\n", (2, 1), "a space is missing after the colon in 'b:3'"),
        ("a: 1\nb\nc: 2\n", (2, 1), "'b' has no colon"),
        ("a: b: c\n", (1, 5), "a second colon in one line"),
        ("a: 1\n  b: 2\n", (2, 1), "as if it continued line 1"),
        ("a: [1, 2\nb: 3\n", (1, 4), "the bracket [ that opens here is not closed"),
        ("a: {x: 1\n", (1, 4), "the bracket { that opens here is not closed"),
        ("a: ['x' 1]\n", (1, 4), "a comma is missing before line 1, column 9"),
        ("a: }\n", (1, 4), "closes a bracket that is not open"),
        ("a: [1, , 2]\n", (1, 8), "a value is missing before ,"),
        ("a: 'x\nb: 1\n", (1, 4), "the quote that opens here is not closed"),
        ('a: "x\nb: 1\n', (1, 4), "the quote that opens here is not closed"),
        ("a: 'it's'\n", (1, 8), "text after a closed quote"),
        ('a: "\\q"\n', (1, 6), "a backslash in double quotes"),
        ("a:\n    b: 1\n  c: 2\n", (3, 3), "align it with its neighbours"),
        ("a: 1\n- b\n", (2, 1), "align it with its neighbours"),
        ("a: - b\n", (1, 4), "begin a list on its own line"),
        ("a: @x\n", (1, 4), "must not begin with @"),
        ("a: *\n", (1, 4), "must not begin with & or *"),
        ("a: 1\nb: \x07\n", (2, 4), "U+0007 is not allowed"),
        ("a: |9x\n b\n", (1, 6), "begins on the next line"),
    ],
)
def test_a_syntax_error_is_said_in_plain_words_at_its_place(text: str, place: tuple[int, int], words: str):
    error = refusal(text)
    assert words in str(error)
    assert [(p.line, p.column) for p in error.problems] == [place]


def test_an_escape_beyond_all_characters_is_refused():
    assert "stands for no character" in str(refusal('a: "\\U0011FFFF"\n'))


def test_what_was_refused_before_a_syntax_error_is_listed_with_it():
    assert spots("a: .nan\nb: *c\nd: [1\n") == [(1, 4), (2, 4), (3, 4)]


# -- hostile files --------------------------------------------------------------------------------
HOSTILE = {
    "billion laughs": "a0: &a0 [x, x]\n" + "".join(f"a{i}: &a{i} [*a{i - 1}, *a{i - 1}]\n" for i in range(1, 60)),
    "100,000 brackets in a line": "a: " + "[" * 100_000,
    "100,000 braces in a line": "a: " + "{" * 100_000,
    "100,000 brackets in lines": "a:\n" + " [\n" * 100_000,
    "9,000 brackets in a line": "a: " + "[" * 9_000,
    "100,000 nested lists": "a:\n  " + "- " * 4_900,
    "1,300 nested mappings": "".join(" " * depth + "a:\n" for depth in range(1_300)),
    "a line of 1 MB": "a: " + "x" * 999_990,
    "a quoted line of 1 MB": "a: '" + "x" * 999_990 + "'",
    "250,000 values": "a:\n" + "- 1\n" * 249_000,
    "a number of 9,000 digits": "a: " + "9" * 9_000,
    "more than 1 MB": "# comment\n" * 110_000,
}


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_refused_at_once(name: str, within: Within):
    within(20_000_000, lambda: refusal(HOSTILE[name]))


def test_hostile_files_stay_under_100_megabytes():
    tracemalloc.start()
    try:
        for text in HOSTILE.values():
            refusal(text)
        assert tracemalloc.get_traced_memory()[1] < 100e6
    finally:
        tracemalloc.stop()


MARKS = ["&x ", "*x ", "!t ", "# c", "|\n", ">", "\\", "\t", "---\n", "...\n", "%YAML 1.3\n", "@", "|2", "<<"]
CHARACTERS = ["\r\n", "\r", "\x85", "\u2028", "\ufeff", "é", "😀", "\x00", "\ud800", "\\U0011ffff", "\\ud800"]
ODD_PIECES = [*MARKS, *CHARACTERS, "1", "010", ".inf", "~", "on", "12:30"]
_PIECES = st.sampled_from(
    ["a", "b", ": ", ":", " ", "\n", "\n  ", "- ", "? ", "[", "]", "{", "}", ", ", "'", '"', *ODD_PIECES]
)


@given(st.lists(_PIECES, max_size=30).map("".join))
@settings(max_examples=300, deadline=None)
def test_any_text_is_read_or_refused_with_a_model_error(text: str):
    try:
        document = Document.read(text)
    except ModelError:
        return
    assert document.dumps() == text
    assert Document.from_plain(document.data).data == document.data


# -- files ----------------------------------------------------------------------------------------
def loading(path: Path) -> str:
    with pytest.raises(ModelError) as caught:
        Document.load(path)
    assert str(caught.value).startswith(f"{path}: ") or f"{path}:" in str(caught.value)
    return str(caught.value)


def test_a_file_is_loaded_and_named_in_messages(tmp_path: Path):
    path = tmp_path / "crank.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: \xc3\xa9\r\n")
    document = Document.load(path)
    assert document.data == {"a": "é"}
    assert document.file == str(path)
    assert document.dumps() == "a: é\r\n"
    path.write_text("a: .nan\n")
    assert loading(path) == f"{path}:1:4: a: .nan is not a finite number"


def test_a_missing_file_is_met_with_the_name_that_is_like_it(tmp_path: Path):
    (tmp_path / "slider_crank.yaml").write_text("a: 1\n")
    (tmp_path / "slider_crank.txt").write_text("a: 1\n")
    assert f"Did you mean {tmp_path / 'slider_crank.yaml'}?" in loading(tmp_path / "slidercrank.yaml")
    assert "Did you mean" in loading(tmp_path / "slider_crank")
    assert "That folder has: slider_crank.yaml." in loading(tmp_path / "zzz.yaml")
    assert f"There is no folder {tmp_path / 'nowhere'} either" in loading(tmp_path / "nowhere" / "a.yaml")


def test_a_folder_is_no_model_file(tmp_path: Path):
    (tmp_path / "a.yaml").write_text("a: 1\n")
    message = loading(tmp_path)
    assert "is a folder" in message
    assert "a.yaml" in message


def test_a_file_that_is_not_utf_8_is_refused_with_its_line(tmp_path: Path):
    path = tmp_path / "latin.yaml"
    path.write_bytes(b"a: 1\nb: caf\xe9\n")
    assert loading(path).startswith(f"{path}:2: is not UTF-8")


def test_a_file_larger_than_1_mb_is_refused_unread(tmp_path: Path, within: Within):
    path = tmp_path / "big.yaml"
    with path.open("wb") as stream:
        stream.truncate(3_000_000_000)
    assert "larger than 1 MB" in loading(path)
    within(1000, lambda: loading(path))


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_a_pipe_is_no_model_file(tmp_path: Path):
    os.mkfifo(tmp_path / "pipe.yaml")
    assert "is not a regular file" in loading(tmp_path / "pipe.yaml")


# -- changing -------------------------------------------------------------------------------------
def test_an_unchanged_document_gives_its_text_back_exactly():
    assert Document.read(CRANK).dumps() == CRANK


@pytest.mark.parametrize(
    ("path", "value", "old", "new"),
    [
        (("parameters", "r"), "0.2 m", "r:   0.1 m      # crank", "r:   0.2 m      # crank"),
        (("parameters", "r"), 3, "r:   0.1 m ", "r:   3 "),
        (("parameters", "g", "value"), 1.62, "{value: 9.81,", "{value: 1.62,"),
        (("title",), "a: b # c", "title: slider crank ", 'title: "a: b # c" '),
        (("title",), None, "title: slider crank ", "title: null "),
        (("bodies", "slider", "points", 1), [2, "a, b"], "- [1, 0]    # tip", '- [2, "a, b"]    # tip'),
        (("bodies", "slider", "points", 1, 0), True, "- [1, 0]    # tip", "- [true, 0]    # tip"),
        (("bodies", "marker"), {"mass": 1}, "  marker:\n", "  marker: {mass: 1}\n"),
        (("bodies", "marker", "mass"), 1, "  marker:\n", "  marker: {mass: 1}\n"),
        (("bodies", "crank", "radius"), "2 m", "mass: 1 kg}", "mass: 1 kg, radius: 2 m}"),
        (("bodies", "slider", "mass"), "on", "mass: 2 kg\n", "mass: on\n"),
        (("bodies", "slider", "radius"), "010", "# tip\n", "# tip\n    radius: 010\n"),
        (("bodies", "wheel", "mass"), 1, "  marker:\n", "  marker:\n  wheel: {mass: 1}\n"),
        (("connections", 1, "drop of left below ground.axle"), 2, "ground.axle}", "ground.axle: 2}"),
        (("connections", 0, "pin"), "x", "pin: [ground.A, crank.start]", "pin: x"),
        (
            ("bodies", "slider", "points"),
            [],
            "    points:\n      - [0, 0]\n      - [1, 0]  ",
            "    points: []  ",
        ),
        (
            ("connections",),
            1,
            CRANK[CRANK.index("connections:") : CRANK.index("# the end")],
            "connections: 1\n",
        ),
    ],
)
def test_a_change_replaces_one_value_and_nothing_else(path: Any, value: Any, old: str, new: str):
    assert CRANK.count(old) == 1
    before = Document.read(CRANK)
    after = before.with_value(path, value)
    assert after.dumps() == CRANK.replace(old, new)
    assert before.dumps() == CRANK
    found: Any = after.data
    for part in path:
        found = found[part]
    assert found == value


def test_a_new_section_is_added_after_the_last_one():
    document = Document.read("a: 1\nb: |\n  text\n\n# the end\n").with_value(("loads", "g", "at"), [1, 2])
    assert document.dumps() == "a: 1\nb: |\n  text\nloads: {g: {at: [1, 2]}}\n\n# the end\n"


def test_a_change_keeps_the_line_ends_of_a_windows_file():
    document = Document.read("a:\r\n  b: 1 # one\r\nc: 2\r\n").with_value(("a", "d"), 3).with_value(("c",), "x")
    assert document.dumps() == "a:\r\n  b: 1 # one\r\n  d: 3\r\nc: x\r\n"


def test_keys_are_added_to_a_mapping_without_braces_and_to_an_empty_item():
    document = Document.read("a: [b: 1]\nc:\n- \n- {}\n")
    changed = document.with_value(("a", 0, "d"), 2).with_value(("c", 0, "e"), 3).with_value(("c", 1, "f"), 4)
    assert changed.dumps() == "a: [{b: 1, d: 2}]\nc:\n- {e: 3} \n- {f: 4}\n"


def test_comments_before_a_replaced_list_stay():
    document = Document.read("a:\n# why\n- 1\n- 2\nb: 3\n").with_value(("a",), [4])
    assert document.dumps() == "a:\n# why\n  [4]\nb: 3\n"


def test_the_place_of_a_value_follows_a_change():
    document = Document.read(CRANK).with_value(("bodies", "slider", "radius"), 1)
    assert document.place(("bodies", "marker")) == (17, 3)
    assert Document.from_plain({"a": 1}).with_value(("a",), 2).place(("a",)) is None


@pytest.mark.parametrize(
    ("path", "words"),
    [
        ((), "name the value to change"),
        (("title", "x"), "title.x cannot be set: title is a single text"),
        (("connections", 7), "connections is a list without 7"),
        (("connections", "x"), "connections is a list without x"),
    ],
)
def test_a_change_that_leads_nowhere_is_refused(path: Any, words: str):
    with pytest.raises(InputError, match=re.escape(words)):
        Document.read(CRANK).with_value(path, 1)


def test_a_change_that_the_text_cannot_take_is_refused_rather_than_guessed():
    with pytest.raises(InputError, match="cannot be changed in place"):
        Document.read("? a\n").with_value(("a",), 1)


@pytest.mark.parametrize("value", [math.nan, math.inf, 10**400, Fraction(1, 2), object(), {1.5: 2}, "\ud800"])
def test_a_value_that_is_not_plain_is_refused_with_its_path(value: Any):
    with pytest.raises(ModelError) as caught:
        Document.read(CRANK).with_value(("parameters", "r"), [1, value])
    assert caught.value.problems[0].path == ("parameters", "r", 1)
    with pytest.raises(ModelError):
        Document.from_plain({"a": value})


# -- models made in Python ------------------------------------------------------------------------
def test_a_model_made_in_python_is_written_as_a_person_would():
    data = {
        "title": "crank",
        "about": "Two\nlines.\n",
        "parameters": {"r": "0.1 m", "n": 3},
        "bodies": {"crank": {"rod": "r", "points": {"tip": ["r", 0]}}, "marker": None},
        "connections": [{"pin": ["ground.A", "crank.start"]}, "x"],
    }
    document = Document.from_plain(data)
    assert document.data == data
    assert document.dumps() == (
        "title: crank\n"
        "about: |\n"
        "  Two\n"
        "  lines.\n"
        "parameters: {r: 0.1 m, n: 3}\n"
        "bodies:\n"
        "  crank:\n"
        "    rod: r\n"
        "    points: {tip: [r, 0]}\n"
        "  marker:\n"
        "connections:\n"
        "  - {pin: [ground.A, crank.start]}\n"
        "  - x\n"
    )


def test_number_types_of_numpy_and_text_enumerations_become_plain():
    class Side(StrEnum):
        LEFT = "left"

    data = Document.from_plain({"a": np.float64(1.5), "b": np.int64(2), "c": Side.LEFT, 1: (1, 2)}).data
    assert data == {"a": 1.5, "b": 2, "c": "left", "1": [1, 2]}
    assert [type(v) for v in data.values()] == [float, int, str, list]


def test_all_that_is_not_plain_in_a_model_is_listed_without_places():
    with pytest.raises(ModelError) as caught:
        Document.from_plain({"a": math.nan, "b": {"c": object()}, None: 1, 2: 3, "2": 4})
    assert [p.path for p in caught.value.problems] == [("a",), ("b", "c"), (), ()]
    assert all(p.line is None for p in caught.value.problems)


def test_a_model_that_contains_itself_is_refused():
    data: dict[str, Any] = {}
    data["a"] = data
    with pytest.raises(ModelError, match="more than 30 deep"):
        Document.from_plain(data)


_SCALARS = (
    st.none()
    | st.booleans()
    | st.integers(-(10**20), 10**20)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(max_size=30)
    | st.sampled_from(["", "010", ".5e3", "1e400", ".inf", "- a", "a: b", "a #b", "-3 m", "on", "~", "\n", "a\n", " a"])
)
_DATA = st.dictionaries(
    st.text(max_size=12) | st.sampled_from(["1", "on", "null", "a: b", "?", "-", "<<"]),
    st.recursive(
        _SCALARS,
        lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=6), inner, max_size=4),
        max_leaves=12,
    ),
    max_size=5,
)


@given(_DATA)
@settings(max_examples=300, deadline=None)
def test_plain_data_comes_back_from_its_text_unchanged(data: dict[str, Any]):
    document = Document.from_plain(data)
    assert repr(document.data) == repr(data)
    assert repr(Document.read(document.dumps()).data) == repr(data)


@given(_DATA)
@settings(max_examples=200, deadline=None)
def test_any_value_can_be_written_into_a_file(value: dict[str, Any]):
    for path in (("title",), ("bodies", "slider", "points", 0), ("bodies", "crank", "new"), ("new", "one")):
        found: Any = Document.read(CRANK).with_value(path, value).data
        for part in path:
            found = found[part]
        assert repr(found) == repr(value)


# -- speed ----------------------------------------------------------------------------------------
def test_a_file_of_60_lines_is_read_in_few_calls(within: Within):
    text = "bodies:\n" + "".join(f"  part{i}: {{mass: 3 kg, at: [1, 2], rod of x}} # c\n" for i in range(60))
    within(400_000, lambda: Document.read(text))


def test_the_module_needs_nothing_heavy():
    code = "import sys, freebody.language.document; print(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = {name.partition(".")[0] for name in run.stdout.split()}
    assert not loaded & {"numpy", "scipy", "numba", "pydantic", "pint", "matplotlib", "xarray", "flint", "rich"}


def read_or_refused(read: Callable[[str], Document], text: str) -> Any:
    try:
        return read(text)._root
    except ModelError as error:
        return [str(problem) for problem in error.problems]


PIECES = st.lists(
    st.sampled_from([*"0123456789+-.*/ ,:#[]{}()'\"\n%&!|?", " m", "e3", ".inf", "°", "- ", ": "]), max_size=4
)


@settings(max_examples=400, deadline=None)
@given(
    st.sampled_from([name for name, _title in examples_folder.listed_examples()]),
    st.integers(0, 10**6),
    st.integers(0, 3),
    PIECES,
)
def test_a_text_that_is_read_again_after_a_change_is_read_as_if_for_the_first_time(
    name: str, at: int, n: int, pieces: list[str]
):
    text = examples_folder.folder().joinpath(f"{name}.yaml").read_text(encoding="utf-8")
    numbers = [found.start() for found in re.finditer(r"\d", text)]
    start = numbers[at % len(numbers)] if at % 3 else at % len(text)
    changed = text[:start] + "".join(pieces) + text[start + n :]
    known = Document.read(text)
    assert read_or_refused(known.reread, changed) == read_or_refused(Document.read, changed)


def test_a_number_that_has_changed_is_all_that_is_read_again(monkeypatch: pytest.MonkeyPatch):
    known = Document.read("a: {b: 1 m, c: [2, 3]}  # d\ne: {f: 4}\ng:\n")
    changed = "a: {b: 0.125 mm, c: [2, 3]}  # d\ne: {f: 4}\ng:\n"
    expected = Document.read(changed)._root
    monkeypatch.setattr("freebody.language.document.composer.compose", None)
    found = known.reread(changed)
    assert found._root == expected
    assert found.data == {"a": {"b": "0.125 mm", "c": [2, 3]}, "e": {"f": 4}, "g": None}
    assert found.place(("a", "c", 1)) == (1, 25)


def test_another_value_of_a_parameter_is_all_that_is_read_again(monkeypatch: pytest.MonkeyPatch):
    known = Document.read("a: {b: 1 m, c: [2, 3]}  # d\ne: {f: 4}\n")
    monkeypatch.setattr("freebody.language.document.composer.compose", None)
    found = known.with_value(("a", "b"), "0.125 mm")
    assert found.dumps() == "a: {b: 0.125 mm, c: [2, 3]}  # d\ne: {f: 4}\n"
    assert found.data == {"a": {"b": "0.125 mm", "c": [2, 3]}, "e": {"f": 4}}
    assert found.with_value(("e", "f"), 55).place(("e", "f")) == (2, 8)


def test_a_text_that_was_read_is_not_composed_again(monkeypatch: pytest.MonkeyPatch):
    text = "only: [here, 1, 2 m]\n"
    first = Document.read(text, "a.yaml")
    monkeypatch.setattr("freebody.language.document.composer._Composer", None)
    assert Document.read(text, "a.yaml")._root is first._root
    with pytest.raises(TypeError):  # messages of another file would name it
        Document.read(text, "b.yaml")


def test_a_question_is_asked_without_composing_the_model(monkeypatch: pytest.MonkeyPatch):
    system = fb.System.load(str(examples_folder.folder().joinpath("planetary_gear.yaml")))
    monkeypatch.setattr("freebody.language.document.composer._Composer", None)
    monkeypatch.setattr("freebody.language.document.composer._kept", None)
    (found,) = system.asked(system.questions[0].text)
    assert found.quantity == system.questions[0].quantity
    with pytest.raises(fb.ModelError, match="no connection nothing") as refused:
        system.asked("tension of nothing")
    assert [problem.line for problem in refused.value.problems] == [None]
