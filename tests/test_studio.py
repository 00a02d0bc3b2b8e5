"""The studio without a browser: what it reads, changes and finds, who may ask it, and what its workers do."""

from __future__ import annotations

import asyncio
import base64
import gzip
import hashlib
import json
import math
import os
import re
import signal
import socket
import subprocess
import sys
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from email.message import Message
from http.client import HTTPConnection
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from threading import Thread
from time import process_time, sleep
from typing import Any

import pytest

pytest.importorskip("starlette")

from freebody.errors import InputError
from freebody.language.document import Document
from freebody.studio.asking import drawn, exported
from freebody.studio.beforehand import moved_beforehand
from freebody.studio.changing import changes
from freebody.studio.editing import add, edit, suggest
from freebody.studio.folder import Folder
from freebody.studio.kinds import kinds
from freebody.studio.lanes import Lanes, Worker
from freebody.studio.launch import bound_at
from freebody.studio.marking import marks
from freebody.studio.moving import curved, motion
from freebody.studio.reading import read
from freebody.studio.server import LARGEST
from freebody.studio.wire.around import Call, Opening, Reply, SaveRequest
from freebody.studio.wire.motions import MarksRequest, MotionAnswer, MotionRequest, Range, SweepAnswer
from freebody.studio.wire.studies import ExportRequest, PictureRequest, ShareRequest
from freebody.studio.wire.texts import AddRequest, EditRequest, ReadAnswer, ReadRequest, SuggestRequest
from freebody.studio.work import Lane
from freebody.studio.work import done as done_by_worker
from freebody.studio.worker import stand_aside
from freebody.system.system import System

ROOT = Path(__file__).parents[1]
PENDULUM = """# a pendulum
parameters: {L: 1 m, m: 2 kg, g: 9.81 m/s^2}  # what can be moved
bodies:
  rod: {rod: {mass: m, length: L}}  # thin
connections:
  A: {pin: [ground.A, rod.start]}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod}}
start: {theta: -60 deg}
questions:
  - {id: first, find: acceleration of theta}
"""


# a chain of rods: formulas of which no one waits for the end
CHAIN = """bodies:
{bodies}
connections:
{pins}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
questions:
  - {{id: far, find: acceleration of r13}}
""".format(
    bodies="\n".join(f"  r{k}: {{rod: {{mass: {k + 1} kg, length: 0.{k + 1} m}}}}" for k in range(14)),
    pins="\n".join(f"  c{k}: {{pin: [{f'r{k - 1}.end' if k else 'ground.A'}, r{k}.start]}}" for k in range(14)),
)


def done(kind: str, request: dict[str, Any]) -> Reply:
    """As the page gets it."""
    return Reply.model_validate_json(done_by_worker(kind, request).model_dump_json())


# -- reading ----------------------------------------------------------------------------------
def test_everything_that_is_read_stands_where_it_is_said_to_stand() -> None:
    found = read(ReadRequest(text=PENDULUM))
    assert found.is_model
    assert found.moving == ["rod"]
    assert [(q.id, q.text) for q in found.questions] == [("first", "acceleration of theta")]
    for element in found.elements:
        assert PENDULUM[element.name_span.start : element.name_span.end] in (
            element.name,
            "{id: first, find: acceleration of theta}",
        )
        for leaf in element.leaves:
            assert PENDULUM[leaf.span.start : leaf.span.end] == leaf.text
    moved = {p.name: PENDULUM[p.span.start : p.span.end] for p in found.parameters}
    assert moved == {"L": "1 m", "m": "2 kg", "g": "9.81 m/s^2", "theta": "-60 deg"}


def test_places_count_as_a_browser_does() -> None:
    text = PENDULUM.replace("# a pendulum", "# a pendulum \U0001f3a1 ")
    (rod,) = (e for e in read(ReadRequest(text=text)).elements if e.section == "bodies")
    units = text.encode("utf-16-le")
    assert units[2 * rod.name_span.start : 2 * rod.name_span.end].decode("utf-16-le") == "rod"


def test_a_misspelt_word_is_marked_and_its_fix_mends_it() -> None:
    for wrong, right in (("{rod: {mass", "{rodd: {mass"), ("pin: [ground.A, rod.start", "pin: [ground.A, rod.strat")):
        text = PENDULUM.replace(wrong, right)
        (remark,) = read(ReadRequest(text=text)).remarks
        assert remark.severity == "error"
        fix = remark.fixes[0]
        assert remark.span.start <= fix.span.start <= fix.span.end <= remark.span.end
        assert text[: fix.span.start] + fix.text + text[fix.span.end :] == PENDULUM


def test_a_wrong_entry_of_a_list_is_marked_in_its_list_and_no_further() -> None:
    text = PENDULUM.replace("[ground.A, rod.start]", "[ground.A, rod.strat]")
    [remark] = read(ReadRequest(text=text)).remarks
    assert text[remark.span.start : remark.span.end] == "[ground.A, rod.strat]"


def test_a_broken_text_is_marked_where_it_breaks() -> None:
    found = read(ReadRequest(text="bodies: {a: [}\n", language="de"))
    assert not found.is_model
    assert [r.line for r in found.remarks] == [1]
    assert found.remarks[0].span.start == 13


# -- changing ---------------------------------------------------------------------------------
def test_an_edit_keeps_comments_and_order() -> None:
    text = edit(EditRequest(text=PENDULUM, path=["parameters", "L"], value="2 m")).text
    assert text == PENDULUM.replace("L: 1 m", "L: 2 m")
    assert edit(EditRequest(text=text, path=["parameters", "L"], value="1 m")).text == PENDULUM


@pytest.mark.parametrize(
    ("path", "gone", "left"),
    [
        (["parameters", "m"], " m: 2 kg,", ""),
        (["parameters", "g"], ", g: 9.81 m/s^2", ""),
        (["loads", "weight"], "loads: {weight: {gravity: g}}\n", ""),
        (["bodies", "rod", "rod", "length"], ", length: L", ""),
    ],
)
def test_what_is_taken_out_leaves_the_rest_as_it_was(path: list[str | int], gone: str, left: str) -> None:
    assert edit(EditRequest(text=PENDULUM, path=path, value=None)).text == PENDULUM.replace(gone, left)


@pytest.mark.parametrize("before", ["", "# mine\n", "\n# mine"])
def test_the_first_element_of_a_model_can_be_added(before: str) -> None:
    text = add(AddRequest(text=before, section="bodies", name="a", value="{particle: {mass: 1 kg}}")).text
    assert text == f"{before.rstrip()}{before and chr(10)}bodies:\n  a: {{particle: {{mass: 1 kg}}}}\n"
    text = add(AddRequest(text=text, section="loads", name="weight", value="{gravity: 9.81 m/s^2}")).text
    assert read(ReadRequest(text=text)).is_model


def test_a_document_without_a_key_says_the_rest(tmp_path: Path) -> None:
    document = Document.read("a:\n  b: 1 # one\n  # kept\n  c:\n    d: [1,\n      2]\n    e: 3\nf: {g: 1, h: 2}\n")
    for path in (("a", "b"), ("a", "c"), ("a", "c", "d"), ("f", "g"), ("f", "h"), ("f",)):
        found = document.without(path)
        expected: Any = document.data
        inner = expected
        for part in path[:-1]:
            inner = inner[part]
        del inner[path[-1]]
        assert found.data == expected
        assert "# kept" in found.dumps()
    with pytest.raises(InputError):
        document.without(("a", "x"))


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("a: 1\n", "a: 1\nq: [{find: x}]\n"),
        ("q:\n  - one # kept\n  # kept\nb: 1\n", "q:\n  - one # kept\n  - {find: x}\n  # kept\nb: 1\n"),
        ("q: [one, two] # kept\n", "q: [one, two, {find: x}] # kept\n"),
        ("q: []\n", "q: [{find: x}]\n"),
        ("q:\nb: 1\n", "q: [{find: x}]\nb: 1\n"),
    ],
)
def test_an_item_is_added_to_a_list_as_it_stands(before: str, after: str) -> None:
    assert Document.read(before).with_item(("q",), {"find": "x"}).dumps() == after
    with pytest.raises(InputError):
        Document.read("q: 3\n").with_item(("q",), 1)


def test_what_can_be_added_can_be_added() -> None:
    """Every kind, under a name that is free, as it stands in its example."""
    offered = kinds()
    assert {each.section for each in offered} == {"bodies", "connections", "loads"}
    for each in offered:
        request = AddRequest(
            text=PENDULUM, section=each.section, name="rod" if each.section == "bodies" else "A", value=each.value
        )
        document = Document.read(add(request).text)
        (name,) = set(document.data[each.section]) - set(Document.read(PENDULUM).data[each.section])
        assert each.kind in document.data[each.section][name]
    (pin,) = (each for each in offered if each.kind == "pin")
    text = add(AddRequest(text=PENDULUM, section="connections", name="A", value=pin.value)).text
    assert System.from_text(text).connections.keys() == {"A", "A2"}


def test_a_question_is_understood_while_it_is_typed() -> None:
    found = suggest(SuggestRequest(text=PENDULUM, question="how fast does the rod turn?"))
    assert found.understood == "angular velocity of rod"
    unclear = suggest(SuggestRequest(text=PENDULUM, question="blah of rod"))
    assert unclear.message
    assert "acceleration of rod" in [each.question for each in unclear.suggestions]


def test_what_can_be_asked_is_said_in_the_language_of_the_page_and_asked_in_that_of_the_grammar() -> None:
    found = suggest(SuggestRequest(text=PENDULUM, question="", language="de"))
    said = {each.question: each.said for each in found.suggestions}
    assert said["angular acceleration of theta"] == "Winkelbeschleunigung von theta"
    assert all(said[question] != question for question in said)
    understood = suggest(SuggestRequest(text=PENDULUM, question="Wie schnell dreht sich der Stab?", language="de"))
    assert understood.understood == "Winkelgeschwindigkeit von rod"
    assert [q.text for q in read(ReadRequest(text=PENDULUM, language="de")).questions] == ["Beschleunigung von theta"]


def test_the_ends_of_a_contact_are_said_in_german() -> None:
    """The two directions of friction, and the edges of a box."""
    from freebody.studio.telling import told

    assert told("friction force 2 of bed at crate left-bottom", "de") == "Reibkraft 2 von bed an crate left-bottom"
    assert told("tipping moment z of bed at crate", "de") == "Kippmoment z von bed an crate"


def test_a_planet_with_less_than_half_a_tooth_is_read() -> None:
    text = (ROOT / "examples" / "planetary_gear_with_three_planets.yaml").read_text(encoding="utf-8")
    few = re.sub(r"z_P: [\d.]+", "z_P: 0.3", text)
    assert few != text
    assert read(ReadRequest(text=few)).elements


# -- motion and studies -----------------------------------------------------------------------
def test_a_motion_has_its_curves_and_what_the_player_draws() -> None:
    request = MotionRequest(text=PENDULUM, until=1.0, frames=51)
    found, measured = motion(request), curved(request)
    assert found.is_complete
    assert (found.player["n_frames"], found.start, found.end) == (51, 0.0, 1.0)
    lines = {line.name: line.values for line in measured.lines}
    assert lines["theta"][0] == pytest.approx(-math.pi / 3)
    energy = [lines["kinetic_energy"][k] + lines["potential_energy"][k] for k in range(len(measured.times))]  # type: ignore[operator]
    assert energy == pytest.approx([energy[0]] * len(energy), abs=1e-5)
    for answer in (found, measured):
        json.dumps(answer.model_dump(), allow_nan=False)


def overlaid(text: str, *show: str, until: float = 2.0) -> dict[str, Any]:
    """By the kind of what is drawn, and the whole answer under no name."""
    reply = done_by_worker("overlays", {"text": text, "until": until, "show": list(show)})
    assert reply.status == "done", reply.message
    answer: Any = reply.answer
    return {"": answer, **{each.kind: each for each in (*answer.arrows, *answer.spots, *answer.cones)}}


def test_what_is_drawn_over_a_simple_pendulum_is_its_closed_form() -> None:
    """With theta from the vertical: v = L theta' across the rod, a = L theta'' across and L theta'^2 along it, and
    T = m g cos(theta) + m L theta'^2, where L theta'^2 = 2 g (cos(theta) - cos(theta_0))."""
    text = (ROOT / "examples" / "simple_pendulum.yaml").read_text(encoding="utf-8")
    found = overlaid(text, "velocity", "acceleration", "reaction", "load", "mass-centres", "instant-centres")
    g, times = 9.81, found["velocity"].times
    bob = list(zip(*found["mass-centres"].at[:2], strict=True))
    assert found["mass-centres"].times == times
    for (x, y), v, a in zip(
        bob,
        zip(*found["velocity"].vector[:2], strict=True),
        zip(*found["acceleration"].vector[:2], strict=True),
        strict=True,
    ):
        squared = 2.0 * g * (-y - 0.5)  # (L theta')^2 with cos(theta) = -y
        assert v[0] ** 2 + v[1] ** 2 == pytest.approx(squared, abs=1e-5)
        assert v[0] * x + v[1] * y == pytest.approx(0.0, abs=1e-5)
        assert a == pytest.approx((-squared * x + g * x * y, -squared * y - g * x * x), abs=1e-4)
    tension, weight = found["reaction"], found["load"]
    where = dict(zip(times, bob, strict=True))
    for t, rx, ry in zip(tension.times, *tension.vector[:2], strict=True):
        x, y = where[t]
        size = -g * y + 2.0 * g * (-y - 0.5)
        assert (rx, ry) == pytest.approx((-size * x, -size * y), abs=1e-4)
    assert (tension.body, tension.owner, tension.label) == ("bob", "rod", "T")
    assert weight.vector == [[0.0], [-9.81], [0.0]]
    assert found[""].scales["force"].largest == pytest.approx(2.0 * g, abs=1e-2)  # at the lowest point
    assert (tension.of, weight.of) == ("rod.length", "weight.bob")


def test_arrows_that_could_hardly_be_seen_beside_the_largest_are_drawn_by_the_root_of_their_size() -> None:
    """Weights of 9.81 N and 0.0981 N; of two equal ones all arrows are as long as they are large."""
    bodies = "bodies: {{a: {{particle: {{mass: 1 kg}}, at: [0, 0]}}, b: {{particle: {{mass: {m} kg}}, at: [1 m, 0]}}}}"
    text = bodies + "\nloads: {{weight: {{gravity: 9.81 m/s^2}}}}\n"
    scales = [overlaid(text.format(m=m), "load", until=0.1)[""].scales["force"] for m in (0.01, 1.0)]
    assert [scale.by_root for scale in scales] == [True, False]
    assert scales[0].largest == pytest.approx(9.81)


def test_a_motion_that_passes_by_looks_like_the_accurate_one() -> None:
    """To less than a thousandth of the length of the rod, 1 m."""
    own, passing = (
        done_by_worker("motion", {"text": PENDULUM, "until": 2.0, "frames": 61, "is_passing": passing}).answer
        for passing in (False, True)
    )
    assert own is not None
    assert passing is not None
    for column, other in zip(own.player["columns"], passing.player["columns"], strict=True):
        assert other == pytest.approx(column, abs=1e-3)


def test_words_of_curves_are_those_of_the_language() -> None:
    lines = done_by_worker("curves", {"text": PENDULUM, "until": 0.1, "frames": 3, "language": "de"}).answer.lines
    labels = {line.name: line.label for line in lines}
    assert labels["kinetic_energy"] == "kinetic_energy: kinetische Energie"
    assert labels["theta_rate"] == "theta_rate: Rate von theta"


def test_points_of_turning_bodies_move_as_they_turn() -> None:
    """The end of a rod on a pin moves twice as fast as its middle, and what is pinned stands still; in space, about a
    fixed axis, too."""
    found = overlaid(PENDULUM, "velocity")[""].arrows
    by_name = {arrow.label: arrow for arrow in found}
    middle, end, pinned = (by_name[name].vector for name in ("rod", "rod.end", "rod.start"))
    assert [2.0 * v for v in middle[0]] == pytest.approx(end[0], abs=1e-5)
    assert [2.0 * v for v in middle[1]] == pytest.approx(end[1], abs=1e-5)
    assert max(abs(v) for column in pinned for v in column) < 1e-6


def test_friction_cones_say_what_is_used_of_them() -> None:
    """A block that slides up a slope uses mu_k / mu_s of what its cone allows."""
    text = (ROOT / "examples" / "block_on_rough_incline.yaml").read_text(encoding="utf-8")
    cone = overlaid(text, "friction-cones", until=0.1)["friction-cones"]
    assert math.tan(cone.half) == pytest.approx(0.3, rel=1e-9)
    assert cone.used[1] == pytest.approx(math.atan(0.3), rel=1e-5)
    assert [c[0] for c in cone.axis] == pytest.approx((-math.sin(math.radians(25)), math.cos(math.radians(25)), 0.0))


def test_friction_cones_of_forces_that_are_not_unique_are_drawn_and_nothing_is_said_to_be_used_of_them() -> None:
    """A ladder that both walls hold by dry friction: what presses is not unique, and where the cones are is known."""
    text = (ROOT / "examples" / "ladder_rough_wall.yaml").read_text(encoding="utf-8")
    answer = overlaid(text, "friction-cones", "reaction", until=0.1)[""]
    found = {tuple(c[0] for c in cone.axis): cone for cone in answer.cones}
    assert set(found) == {(0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)}  # up from the floor, and away from the wall
    for cone, end in zip(found.values(), (-2.0, 2.0), strict=True):
        assert math.tan(cone.half) == pytest.approx(0.4, rel=1e-9)
        assert cone.at[0][0] == pytest.approx(end)
        assert set(cone.used) == {None}
    assert not answer.arrows
    assert answer.messages == [
        "not drawn where they are not unique: reactions of floor, wall",
        "what is used of the friction cones of floor, wall is not unique",
    ]


def test_an_overlay_that_there_is_not_says_why() -> None:
    answer = overlaid(PENDULUM, "friction-cones")[""]
    assert not answer.cones
    assert "dry friction" in answer.messages[0]


def test_symbols_say_what_they_speak_of() -> None:
    text = (ROOT / "examples" / "simple_pendulum.yaml").read_text(encoding="utf-8")
    reply = done("study", {"text": text, "name": "solve", "options": {"question": "tension"}})
    assert reply.answer is not None
    found = {m["symbol"]: (m["bodies"], m["owner"]) for m in reply.answer["meanings"]}
    assert found["T"] == (["bob"], "rod")
    assert found["\u03b8"] == (["bob"], "")
    assert found["m"] == (["bob"], "")
    assert found["g"] == (["bob"], "weight")
    drawn = done("picture", {"text": text, "free": ["bob"]})
    assert drawn.answer is not None
    assert drawn.answer["meanings"] == reply.answer["meanings"]


def test_curves_are_those_of_the_motion_that_is_asked_about() -> None:
    """Whatever was followed before them."""
    requests = [
        MotionRequest(text=PENDULUM.replace("L: 1 m", f"L: {length} m"), until=until, frames=frames)
        for length, until, frames in ((1, 1.0, 51), (2, 1.0, 51), (2, 0.5, 51), (2, 0.5, 26))
    ]
    alone = [curved(request) for request in requests]
    assert len({answer.model_dump_json() for answer in alone}) == len(requests)
    for request, answer in zip(requests, alone, strict=True):
        motion(request)
        assert curved(request) == answer


@pytest.mark.parametrize(("is_passing", "most"), [(False, 0.1), (True, 0.08)])
def test_ten_bodies_follow_a_slider_with_little_work(is_passing: bool, most: float) -> None:
    """By the processor time of the worker [s], the least of some, and by what is sent."""
    n = 10
    bodies = "".join(f"  r{k}: {{rod: {{mass: 1 kg, length: 0.1 m}}}}\n" for k in range(n))
    pins = "".join(f"  c{k}: {{pin: [{f'r{k - 1}.end' if k else 'ground.A'}, r{k}.start]}}\n" for k in range(n))
    angles = ", ".join(f"a{k}: {{angle of r{k}}}" for k in range(n))
    loads = "loads: {weight: {gravity: 9.81 m/s^2}}"
    times: list[float] = []
    sent = 0
    for i in range(12):
        start = ", ".join(f"a{k}: {-60 + 3 * k + 0.1 * i} deg" for k in range(n))
        text = f"bodies:\n{bodies}connections:\n{pins}{loads}\nmeasures: {{{angles}}}\nstart: {{{start}}}\n"
        before = process_time()
        reply = done_by_worker("motion", {"text": text, "until": 3, "frames": 61, "is_passing": is_passing})
        told = reply.model_dump_json()
        times.append(process_time() - before)
        sent = max(sent, len(told))
    assert min(times) < most
    assert sent < 50_000


@pytest.mark.parametrize(
    ("kind", "request_", "words"),
    [
        ("study", {"name": "solve"}, "acceleration of theta"),
        ("study", {"name": "explain", "language": "de"}, "Drall"),
        ("count", {"name": "mobility"}, "mobility"),
    ],
)
def test_studies_are_parts_of_a_page(kind: str, request_: dict[str, Any], words: str) -> None:
    reply = done(kind, {"text": PENDULUM, **request_})
    assert reply.status == "done", reply.message
    assert words in reply.answer["html"]
    assert ".freebody-report" not in reply.answer["html"]  # the page has that style once
    assert "<script" not in reply.answer["html"]


@pytest.mark.parametrize(
    ("kind", "request_"),
    [
        ("study", {"name": "draw", "options": {"path": "/tmp/x.svg"}}),
        ("study", {"name": "over_a_turn", "options": {"csv": "/tmp/x.csv"}}),
        ("study", {"name": "solve", "options": {"question": "blah"}}),
        ("study", {"name": "__init__"}),
        ("study", {"name": "solve", "more": 1}),
        ("motion", {"until": -1}),
        ("picture", {"free": ["nobody"]}),
    ],
)
def test_what_makes_no_sense_is_refused_in_words(kind: str, request_: dict[str, Any]) -> None:
    reply = done(kind, {"text": PENDULUM, **request_})
    assert (reply.status, reply.answer) == ("refused", None)
    assert reply.message


def test_a_typed_answer_is_judged_and_hints_come_in_their_order() -> None:
    """theta'' of a rod that turns about its end, from the horizontal: -3 g cos(theta)/(2 L)."""
    told = [done("judge", {"text": PENDULUM, "question": "first", "answer": a}).answer for a in _ANSWERS]
    assert [t["plain"]["verdict"] for t in told] == ["correct", "incorrect", "unreadable"]
    assert [t["is_right"] for t in told] == [True, False, False]
    assert [t["is_attempt"] for t in told] == [True, True, False]
    help_ = done("hints", {"text": PENDULUM, "question": "first"}).answer
    assert len(help_["hints"]) > 1


def test_a_question_of_a_quiz_is_asked_with_its_options() -> None:
    text = (ROOT / "examples" / "atwood_machine.yaml").read_text(encoding="utf-8")
    posed = done("posed", {"text": text, "question": "acceleration"}).answer
    assert posed["options"] == list("abcde")
    assert all(f"({letter})" in posed["html"] for letter in posed["options"])
    assert done("posed", {"text": PENDULUM, "question": "first"}).answer["options"] == []


def test_a_force_and_its_reaction_have_one_mark_and_their_symbol_speaks_of_it() -> None:
    """The tension of the string acts on the mass and on the pulley."""
    text = (ROOT / "examples" / "atwood_machine.yaml").read_text(encoding="utf-8")
    answers = [done("picture", {"text": text, "free": [body]}).answer for body in ("left", "pulley")]
    pictures = [base64.b64decode(answer["content"]).decode() for answer in answers]
    [tension] = [meaning for meaning in answers[0]["meanings"] if meaning["symbol"] == "Tleft"]
    [force] = tension["forces"]
    assert all(f'data-of="force {force}"' in picture for picture in pictures)
    assert ['data-of="body left"' in picture for picture in pictures] == [True, False]


def test_forces_on_a_body_cut_free_are_judged() -> None:
    def verdict(answer: str) -> str:
        reply = done("judge", {"text": PENDULUM, "free": ["rod"], "answer": answer})
        return str(reply.answer["plain"]["verdict"])

    assert verdict("m g down at G; A_x right at start; A_y up at start") == "correct"
    assert verdict("m g down at G") == "incorrect"


_ANSWERS = ("-3*g*cos(theta)/(2*L)", "-g*cos(theta)/L", "((")


# -- the folder -------------------------------------------------------------------------------
@pytest.mark.parametrize(
    "name",
    [
        "../model.yaml",
        "/etc/passwd",
        "a/b.yaml",
        "..\\x.yaml",
        ".hidden.yaml",
        "model.py",
        "link.yaml",
        "model.yaml\0",
        "C:x.yaml",
        "",
        "folder.yaml",
    ],
)
def test_nothing_outside_the_folder_is_reached(name: str, tmp_path: Path) -> None:
    inside = tmp_path / "inside"
    inside.mkdir()
    (inside / "folder.yaml").mkdir()
    (tmp_path / "model.yaml").write_text(PENDULUM, encoding="utf-8")
    (inside / "link.yaml").symlink_to(tmp_path / "model.yaml")
    folder = Folder.of(inside)
    assert folder.names() == []
    with pytest.raises(InputError):
        folder.opened(name)
    with pytest.raises(InputError):
        folder.save(SaveRequest(name=name, text="x", version="", overwrite=True))
    assert (tmp_path / "model.yaml").read_text(encoding="utf-8") == PENDULUM


def test_a_file_that_has_changed_meanwhile_is_not_overwritten(tmp_path: Path) -> None:
    file = tmp_path / "model.yaml"
    file.write_text("a: 1\n", encoding="utf-8")
    folder = Folder.of(file)
    opened = folder.first_opened()
    file.write_text("a: 2\n", encoding="utf-8")
    request = SaveRequest(name="model.yaml", text="a: 3\n", version=opened.version)
    assert folder.save(request).is_changed
    assert file.read_text(encoding="utf-8") == "a: 2\n"
    saved = folder.save(request.model_copy(update={"overwrite": True}))
    assert not saved.is_changed
    assert folder.opened("model.yaml").version == saved.version


# -- where something changes along a slider ---------------------------------------------------
def marked(name: str, ranges: dict[str, tuple[float, float, str]]) -> dict[str, dict[float, list[str]]]:
    text = (ROOT / "examples" / f"{name}.yaml").read_text(encoding="utf-8")
    asked = [Range(name=each, low=low, high=high, unit=unit) for each, (low, high, unit) in ranges.items()]
    found = marks(MarksRequest(text=text, ranges=asked)).marks
    return {each: {mark.at: mark.words for mark in found if mark.name == each} for each in ranges}


@pytest.mark.slow
def test_a_slider_is_marked_where_a_block_tips_and_no_longer_slides() -> None:
    """Pushed at the height d, a block of the width b slides where F = mu m g; then it tips where mu d = b/2, by the
    moment about its front edge. Here m = 20 kg, F = 20 N, b = 0.6 m, d = 0.5 m, mu = 0.35."""
    ranges = {"mu": (0.01, 0.7, ""), "F": (1.0, 300.0, "N"), "d": (0.01, 3.0, "m"), "b": (10.0, 1000.0, "mm")}
    found = marked("block_tips_or_slides", ranges)
    slips, tips = 20.0 / (20.0 * 9.81), 0.6 / (2.0 * 0.5)
    assert sorted(found["mu"]) == pytest.approx([slips, tips], rel=1e-9)
    assert sorted(found["F"]) == pytest.approx([0.35 * 20.0 * 9.81], rel=1e-9)
    assert sorted(found["d"]) == pytest.approx([0.6 / (2.0 * 0.35)], rel=1e-9)
    assert sorted(found["b"]) == pytest.approx([1000.0 * 2.0 * 0.5 * 0.35], rel=1e-9)
    assert any("block.bottom_right does not slip" in words for words in found["F"][min(found["F"])])


@pytest.mark.slow
def test_a_slider_in_degrees_is_marked_at_the_angle_of_friction() -> None:
    """Where a block on a slope comes back: mu < tan(theta); the end of a range is no change."""
    ranges = {"theta": (1.0, 90.0, "deg"), "mu": (0.01, 0.6, ""), "m": (1.0, 9.0, "kg")}
    found = marked("block_on_rough_incline", ranges)
    assert sorted(found["theta"]) == pytest.approx([math.degrees(math.atan(0.3))], rel=1e-9)
    assert sorted(found["mu"]) == pytest.approx([math.tan(math.radians(25.0))], rel=1e-9)
    assert found["m"] == {}


def test_a_slider_is_marked_where_a_ball_reaches_the_floor_within_the_time_that_is_shown() -> None:
    """Dropped from h it is there at t = sqrt(2 h/g), so within 1 s from h = g (1 s)^2/2."""
    text = (
        "parameters: {h: 1 m}\nground: {lines: {floor: {along: right}}}\n"
        "bodies: {ball: {particle: {mass: 1 kg}, at: [0, h]}}\n"
        "connections: {contact: {contact: {between: [ball, floor], restitution: 0}}}\n"
        "loads: {weight: {gravity: 9.81 m/s^2}}\n"
    )
    ranges = [Range(name="h", low=1.0, high=10.0, unit="m")]
    found = changes(MarksRequest(text=text, ranges=ranges, until=1.0, language="de")).marks
    assert {mark.name for mark in found} == {"h"}
    assert found[0].at == pytest.approx(9.81 / 2.0, abs=1e-3 * 9.0)
    assert any("innerhalb von 1 s" in word for word in found[0].words)


@pytest.mark.parametrize("parameters", ["", "parameters: {m: 1 kg}\n"], ids=["without parameters", "beside parameters"])
def test_the_slider_of_a_start_is_marked_as_that_of_a_parameter_is(parameters: str) -> None:
    """Dropped from h it is at the floor within 0.4 s from h = g (0.4 s)^2/2 on. No parameter of the file is varied."""
    text = parameters + (
        "ground: {lines: {floor: {along: right}}}\nbodies: {ball: {particle: {mass: 1 kg}}}\n"
        "connections: {c: {contact: {between: [ball, floor], restitution: 0, touching: false}}}\n"
        "loads: {w: {gravity: 9.81 m/s^2}}\nmeasures: {h: {height of ball}}\nstart: {h: 1 m}\n"
    )
    ranges = [Range(name="h", low=0.5, high=2.0, unit="m")]
    found = changes(MarksRequest(text=text, ranges=ranges, until=0.4)).marks
    assert {mark.name for mark in found} == {"h"}
    assert found[0].at == pytest.approx(9.81 * 0.4**2 / 2.0, abs=1e-3 * 1.5)


def test_where_a_linkage_cannot_be_assembled_its_slider_is_marked() -> None:
    """Two rods of the lengths L and 1 m between points 3 m apart: from L = 2 m on, and up to 4 m."""
    text = (
        "parameters: {L: 2.5 m}\nground: {points: {A: [0, 0], B: [3 m, 0]}}\n"
        "bodies: {a: {rod: {mass: 1 kg, length: L}}, b: {rod: {mass: 1 kg, length: 1 m}}}\n"
        "connections: {A: {pin: [ground.A, a.start]}, C: {pin: [a.end, b.end]}, B: {pin: [ground.B, b.start]}}\n"
        "loads: {weight: {gravity: 9.81 m/s^2}}\nquestions: [{find: time when angle of a = 10 rad}]\n"
    )
    ranges = [Range(name="L", low=1.0, high=3.5, unit="m")]
    found = changes(MarksRequest(text=text, ranges=ranges, until=0.1)).marks
    [mark] = [mark for mark in found if "the motion cannot begin" in mark.words]
    assert mark.at == pytest.approx(2.0, abs=1e-3 * 2.5)


def test_a_slider_is_marked_where_the_model_stops_allowing_its_value() -> None:
    text = (
        "ground: {lines: {floor: {along: right}}}\nparameters: {e: 0.8}\n"
        "bodies: {ball: {particle: {mass: 1 kg}, at: [0, 1 m]}}\n"
        "connections: {c: {contact: {between: [ball, floor], restitution: e}}}\nloads: {w: {gravity: 9.81 m/s^2}}\n"
    )
    [mark] = changes(MarksRequest(text=text, ranges=[Range(name="e", low=0.5, high=1.5, unit="")], until=0.5)).marks
    assert mark.words == ["the model does not allow the value"]
    assert mark.at == pytest.approx(1.0, abs=1e-3)


# -- the server -------------------------------------------------------------------------------
@dataclass
class Server:
    """A studio that runs: where, and by which token."""

    port: int
    token: str

    def get(self, path: str, **headers: str) -> tuple[int, Message, bytes]:
        return self.sent("GET", path, None, headers)

    def post(self, path: str, body: object, **headers: str) -> tuple[int, Message, bytes]:
        content = body if isinstance(body, bytes) else json.dumps(body).encode()
        own = {"Authorization": f"Bearer {self.token}", "Content-Type": "application/json"}
        return self.sent(
            "POST", path, content, own | {name.replace("_", "-"): value for name, value in headers.items()}
        )

    def sent(
        self, method: str, path: str, content: bytes | None, headers: dict[str, str]
    ) -> tuple[int, Message, bytes]:
        connection = HTTPConnection("127.0.0.1", self.port, timeout=120)
        try:
            connection.request(method, path, content, headers)
            response = connection.getresponse()
            return response.status, response.headers, response.read()
        finally:
            connection.close()


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    file = tmp_path_factory.mktemp("studio") / "pendulum.yaml"
    file.write_text(PENDULUM, encoding="utf-8")
    command = [sys.executable, "-m", "freebody", "studio", str(file), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/#token=([\w-]{20,})\n", process.stdout.readline())
        assert found is not None
        yield Server(int(found[1]), found[2])
        process.terminate()


def test_a_worker_answers_over_the_server(server: Server) -> None:
    call = {"kind": "read", "topic": "read", "request": {"text": PENDULUM}}
    reply = json.loads(server.post("/api/ask", call)[2])
    assert (reply["status"], reply["answer"]["is_model"]) == ("done", True)
    opening = json.loads(server.post("/api/open", {})[2])
    assert (opening["file"]["text"], opening["files"]) == (PENDULUM, ["pendulum.yaml"])


def test_a_name_that_no_model_file_has_is_refused_in_the_language_of_the_page(server: Server) -> None:
    request = {"name": "../{.yaml", "text": PENDULUM, "version": "", "language": "de"}
    status, _headers, content = server.post("/api/save", request)
    answer = json.loads(content)
    assert (status, answer["version"]) == (200, "")
    assert answer["message"].startswith("../{.yaml: eine Modelldatei heißt")


@pytest.mark.parametrize(
    ("changes", "status"),
    [
        ({"Authorization": "Bearer wrong"}, 401),
        ({"Authorization": ""}, 401),
        ({"Host": "evil.example:8000"}, 403),
        ({"Host": "127.0.0.1:1"}, 403),
        ({"Origin": "http://evil.example"}, 403),
        ({"Origin": "null"}, 403),
        ({"Content_Type": "text/plain"}, 415),
    ],
)
def test_who_is_not_the_page_is_refused(server: Server, changes: dict[str, str], status: int) -> None:
    assert server.post("/api/open", {}, **changes)[0] == status
    assert server.get("/api/open", Authorization=f"Bearer {server.token}")[0] == 405


@pytest.mark.parametrize(
    ("content", "status"),
    [
        (b"[", 400),
        (b"[]", 400),
        (b'{"kind": "eval", "topic": "x", "request": {}}', 400),
        (b"\xff", 400),
    ],
)
def test_what_cannot_be_read_is_refused(server: Server, content: bytes, status: int) -> None:
    assert server.post("/api/ask", content)[0] == status


def test_a_request_that_is_too_large_is_refused_before_it_is_read(server: Server) -> None:
    assert server.post("/api/ask", b"", Content_Length=str(LARGEST + 1))[0] == 413


def test_what_can_be_added_and_written_is_learned(server: Server) -> None:
    call = {"kind": "learn", "topic": "learn", "request": {}}
    answer = json.loads(server.post("/api/ask", call)[2])["answer"]
    assert {kind["section"] for kind in answer["kinds"]} == {"bodies", "connections", "loads"}
    assert "bodies" in answer["written"]["properties"]


def test_no_part_of_an_answer_waits_for_another() -> None:
    """asyncio sends them at once (TCP_NODELAY) where a socket says that it is one of TCP."""
    with bound_at(0) as bound:
        assert bound.proto == socket.IPPROTO_TCP


def test_what_a_window_asked_for_that_is_gone_holds_nobody_up(server: Server) -> None:
    """A study of minutes, behind which another window waits."""
    request = {"text": CHAIN, "name": "explain", "options": {"question": "far"}}
    body = json.dumps({"kind": "study", "topic": "study.first", "request": request}).encode()
    gone = HTTPConnection("127.0.0.1", server.port, timeout=120)
    own = {"Authorization": f"Bearer {server.token}", "Content-Type": "application/json"}
    gone.request("POST", "/api/ask", body, own)
    assert json.loads(gone.getresponse().read())["status"] == "later"
    gone.request("POST", "/api/later", json.dumps({"window": "first"}).encode(), own)
    assert "study.first" in json.loads(server.post("/api/busy", {})[2])
    sleep(0.2)  # until the request has been heard
    gone.close()
    request = {"text": PENDULUM, "name": "solve"}
    status, _, content = server.post("/api/ask", {"kind": "study", "topic": "study", "request": request})
    assert (status, json.loads(content)["status"]) == (200, "done")


def test_a_study_of_minutes_holds_no_connection(server: Server) -> None:
    request = {"text": CHAIN, "name": "explain", "options": {"question": "far"}}
    call = {"kind": "study", "topic": "study.one", "request": request}
    promised = json.loads(server.post("/api/ask", call)[2])
    assert promised["status"] == "later"
    server.post("/api/cancel", {"topic": "study.one"})
    replies = json.loads(server.post("/api/later", {"window": "one"})[2])
    assert {number: reply["status"] for number, reply in replies.items()} == {promised["message"]: "cancelled"}


def test_the_page_comes_with_its_policy_and_nothing_else_is_given_away(server: Server) -> None:
    status, headers, content = server.get("/")
    assert (status, b"<div id" in content) == (200, True)
    assert "script-src 'self'" in headers["Content-Security-Policy"]
    assert "unsafe-eval" not in headers["Content-Security-Policy"]
    assert headers["X-Content-Type-Options"] == "nosniff"
    for name in ("studio.js", "studio.css", "look.css"):
        assert server.get(f"/{name}")[0] == 200
    for name in (
        "server.py",
        "..%2fserver.py",
        "%2e%2e/work.py",
        "page",
        "sources.sha256",
        "studio.js/x",
        "../work.py",
    ):
        assert server.get(f"/{name}")[0] == 404
    assert server.get("/", Host="evil.example")[0] == 403


# -- the workers ------------------------------------------------------------------------------
def call_of(topic: str, kind: str = "read") -> Call:
    return Call(kind=kind, topic=topic, request={"text": PENDULUM})


async def status_of(worker: Worker, call: Call) -> str:
    return Reply.model_validate_json(await worker.ask(call)).status


def test_the_latest_of_a_topic_is_done_and_a_dead_worker_is_a_message() -> None:
    async def run() -> None:
        worker = Worker(Lane("test", 30))
        first = asyncio.create_task(status_of(worker, call_of("a")))
        await asyncio.sleep(0)
        waiting = [asyncio.create_task(status_of(worker, call_of(topic))) for topic in ("b", "b", "c")]
        await asyncio.sleep(0)
        worker.cancel("c")
        windows = [asyncio.create_task(status_of(worker, call_of(topic))) for topic in ("a.one", "a.two")]
        assert await asyncio.gather(first, *waiting) == ["done", "replaced", "done", "cancelled"]
        assert await asyncio.gather(*windows) == ["done", "done"]  # each has its own topics
        process = (await worker.begun()).process
        dying = asyncio.create_task(status_of(worker, call_of("a")))
        await asyncio.sleep(0)
        process.kill()
        assert await dying in ("crashed", "done")
        assert await status_of(worker, call_of("a")) == "done"
        await worker.end()

    asyncio.run(run())


@pytest.mark.skipif(not hasattr(signal, "SIGUSR1"), reason="Windows has no such signal")
def test_a_study_stands_aside_while_something_is_moved_by_hand_and_goes_on_by_itself() -> None:
    """The processor is then there for the picture; a worker that cannot pause yet is not ended by being told to."""
    child = (
        "import signal, time; from freebody.studio import worker\n"
        "worker.ASIDE = 1.5; worker.deaf_to_standing_aside(); signal.raise_signal(signal.SIGUSR1)\n"
        "signal.signal(signal.SIGUSR1, worker._StandingAside()); n, end = 0, time.monotonic() + 20\n"
        "while time.monotonic() < end: n += 1; print(n, flush=True)"
    )
    with subprocess.Popen([sys.executable, "-c", child], stdout=subprocess.PIPE) as study:
        assert study.stdout is not None
        assert study.stdout.readline() == b"1\n"
        for _ in range(3):  # told again while it stands aside
            stand_aside(study.pid)
            sleep(0.1)
        drain = Thread(target=lambda: counts.extend(study.stdout or []), daemon=True)
        counts: list[bytes] = []
        drain.start()  # what it had written before
        sleep(0.1)
        n_aside = len(counts)
        sleep(0.1)
        assert len(counts) == n_aside
        while len(counts) == n_aside and study.poll() is None:
            sleep(0.02)
        study.kill()
    assert len(counts) > n_aside


def test_a_motion_that_passes_by_waits_for_no_accurate_one() -> None:
    """Of many rods, which takes a while."""
    rods = "".join(f"  r{k}: {{rod: {{mass: 1 kg, length: 0.1 m}}}}\n" for k in range(60))
    pins = "".join(f"  c{k}: {{pin: [{f'r{k - 1}.end' if k else 'ground.A'}, r{k}.start]}}\n" for k in range(60))
    angles = "measures: {" + ", ".join(f"a{k}: {{angle of r{k}}}" for k in range(60)) + "}\n"
    start = "start: {" + ", ".join(f"a{k}: {k} deg" for k in range(60)) + "}\n"
    many = f"bodies:\n{rods}connections:\n{pins}loads: {{weight: {{gravity: 9.81 m/s^2}}}}\n{angles}{start}"

    async def moved() -> None:
        lanes = Lanes()
        try:
            passing = Call(kind="motion", topic="b", request={"text": PENDULUM, "until": 1, "is_passing": True})
            assert Reply.model_validate_json(await lanes.ask(passing)).status == "done"  # its process is there
            accurate = Call(kind="motion", topic="a", request={"text": many, "until": 100})
            slow = asyncio.create_task(lanes.ask(accurate))
            await asyncio.sleep(0)
            assert Reply.model_validate_json(await lanes.ask(passing)).status == "done"
            assert not slow.done()
            lanes.cancel("a")
            await slow
        finally:
            await lanes.end()

    asyncio.run(moved())


@pytest.mark.skipif(os.name != "posix", reason="sockets are given to a process otherwise there")
def test_a_worker_whose_server_is_gone_ends_and_says_nothing() -> None:
    """Also one that has just found an answer: the terminal is somebody else's by then."""
    own, its = socket.socketpair()
    socket_of_it = f"socket.socket(fileno={its.fileno()})"
    code = f"import socket; from freebody.studio.worker import work; work({socket_of_it}, 'reading', 0, ())"
    command = [sys.executable, "-c", code]
    with subprocess.Popen(command, stderr=subprocess.PIPE, pass_fds=[its.fileno()], text=True) as worker:
        its.close()
        request = {"text": PENDULUM, "language": "de"}
        call = json.dumps({"kind": "read", "request": request}).encode() + b"\n"
        own.sendall(call)
        assert own.recv(1)  # it works
        own.sendall(call)
        own.close()
        assert worker.communicate(timeout=60)[1] == ""
    assert worker.returncode == 0


def test_no_answer_waits_for_a_file_that_takes_its_time() -> None:
    request = {"text": CHAIN, "name": "explain", "options": {"question": "far"}}

    async def asked() -> None:
        lanes = Lanes()
        try:
            slow = asyncio.create_task(lanes.ask(Call(kind="export", topic="file", request=request)))
            await asyncio.sleep(0)
            answer = Call(kind="study", topic="answer", request={"text": PENDULUM, "name": "solve"})
            assert Reply.model_validate_json(await asyncio.wait_for(lanes.ask(answer), 60)).status == "done"
            assert not slow.done()
            lanes.cancel("file")
            assert Reply.model_validate_json(await slow).status == "cancelled"
        finally:
            await lanes.end()

    asyncio.run(asked())


def test_whatever_goes_wrong_with_a_worker_is_a_message_and_the_next_request_is_answered(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Such as an answer that is longer than what is read at once."""

    async def run() -> None:
        worker = Worker(Lane("test", 30))
        with monkeypatch.context() as patched:
            patched.setattr("freebody.studio.lanes._LONGEST", 64)
            assert await asyncio.wait_for(status_of(worker, call_of("a")), 30) == "crashed"
        assert await asyncio.wait_for(status_of(worker, call_of("a")), 30) == "done"
        await worker.end()

    asyncio.run(run())


def test_a_hand_that_moves_something_lets_all_others_stand_aside(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[str] = []
    monkeypatch.setattr(Worker, "stand_aside", lambda worker: told.append(worker.lane.name))

    async def moved() -> None:
        lanes = Lanes()
        try:
            await lanes.ask(Call(kind="motion", topic="a", request={"text": "", "until": 1, "is_passing": True}))
            assert set(told) == set(lanes.workers)
            told.clear()
            await lanes.ask(Call(kind="read", topic="b", request={"text": ""}))
            assert not told
        finally:
            await lanes.end()

    asyncio.run(moved())


def test_what_the_page_will_ask_first_is_found_before_it_asks(tmp_path: Path) -> None:
    """Its answers are those of the calls themselves, and the workers do them once."""
    file = tmp_path / "pendulum.yaml"
    file.write_text(PENDULUM, encoding="utf-8")
    foreseen = Folder.of(file).foreseen()
    assert [call.kind for call in foreseen] == ["read", "motion"]
    assert foreseen[1].request["until"] == Opening.model_fields["until"].default

    async def run() -> None:
        lanes = Lanes()
        done: list[str] = []

        class Counted(Worker):
            async def ask(self, call: Call) -> bytes:
                done.append(call.kind)
                return await super().ask(call)

        lanes.workers.update({name: Counted(worker.lane) for name, worker in lanes.workers.items()})
        lanes.begin(foreseen)
        again = [await lanes.ask(call.model_copy(deep=True)) for call in (*foreseen, *foreseen)]
        assert (again[:2], done) == (again[2:], ["read", "motion"])
        for call, reply in zip(foreseen, again, strict=False):
            assert Reply.model_validate_json(reply).model_dump() == done_by_worker(call.kind, call.request).model_dump(
                mode="json"
            )
        other = foreseen[1].model_copy(update={"request": {**foreseen[1].request, "until": 0.5}})
        assert MotionAnswer.model_validate(Reply.model_validate_json(await lanes.ask(other)).answer).end == 0.5
        assert done == ["read", "motion", "motion"]
        await lanes.end()

    asyncio.run(run())


@pytest.mark.parametrize("is_started", [True, False])
@pytest.mark.parametrize(("end", "status"), [(Worker.cancel, "cancelled"), (Worker.leave, "replaced")])
def test_nothing_waits_for_what_is_cancelled_or_left(
    end: Callable[[Worker, str], None], status: str, is_started: bool
) -> None:
    """Neither behind a study that is being made, nor behind one whose process was still on its way."""

    async def run() -> None:
        worker = Worker(Lane("test", 600))
        if is_started:
            assert await status_of(worker, call_of("first")) == "done"
        request = {"text": CHAIN, "name": "explain", "options": {"question": "far"}}
        slow = asyncio.create_task(status_of(worker, Call(kind="study", topic="slow", request=request)))
        await asyncio.sleep(0)
        next_one = asyncio.create_task(status_of(worker, call_of("next")))
        await asyncio.sleep(1 if is_started else 0)
        end(worker, "slow")
        assert await asyncio.wait_for(asyncio.gather(slow, next_one), 60) == [status, "done"]
        assert worker.running is not None
        await worker.end()

    asyncio.run(run())


def test_a_worker_is_ended_while_it_starts() -> None:
    async def run() -> None:
        worker = Worker(Lane("test", 30))
        worker.begin()
        asked = asyncio.create_task(status_of(worker, call_of("a")))
        await asyncio.sleep(0)
        worker.cancel("a")
        assert await asked == "cancelled"
        assert await status_of(worker, call_of("b")) == "done"
        await worker.end()
        assert worker.running is None

    asyncio.run(run())


def test_the_first_picture_imports_nothing_that_it_does_not_need() -> None:
    """A motion that is looked at where it is given, also one with events: splines, optimisers, formulas and languages
    take longer to import than it takes to be found, so do kinds that the model does not name."""
    code = (
        "import sys\n"
        "from freebody.studio import grown, work\n"
        "text = open(sys.argv[1], encoding='utf-8').read()\n"
        "assert work.done('read', {'text': text}).status == 'done'\n"
        "assert work.done('motion', {'text': text, 'until': 2.7}).status == 'done'\n"
        "slow = {'scipy', 'matplotlib', 'pint', 'xarray', 'flint', 'freebody.symbolic', 'freebody.narrative.telling'}\n"
        "slow |= {'freebody.connections.cam', 'freebody.loads.drag', 'freebody.present.space.painter'}\n"
        "slow |= {'freebody.questions.spoken.understanding'}\n"
        "print(*sorted(slow & set(sys.modules)))\n"
        "from freebody.questions.base import FORMS\n"
        "print(sum('pattern' in vars(form) for form in FORMS) < 30)\n"
    )
    command = [sys.executable, "-c", code, str(ROOT / "examples" / "bouncing_ball.yaml")]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout == "\nTrue\n"


def test_the_server_reads_no_model() -> None:
    """Its imports go on beside those of the workers, on the cores that these need for the first picture."""
    code = (
        "import sys\n"
        "import freebody.studio.server\n"
        "slow = {'numpy', 'ruamel.yaml', 'freebody.studio.wire.texts', 'freebody.studio.wire.motions'}\n"
        "slow |= {'freebody.studio.wire.studies', 'freebody.system.system', 'freebody.questions.base'}\n"
        "print(*sorted(slow & set(sys.modules)))\n"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "\n"


def test_work_that_takes_too_long_is_ended() -> None:
    async def run() -> None:
        worker = Worker(Lane("test", 0.01))
        assert await status_of(worker, call_of("a")) == "too long"
        await worker.end()

    asyncio.run(run())


@pytest.mark.skipif(sys.platform == "win32", reason="memory is limited on POSIX alone")
def test_a_worker_without_memory_says_so() -> None:
    code = (
        "from freebody.studio import worker, work\n"
        "worker.MEMORY = 3 << 30\n"
        "worker._limit_memory()\n"
        "work.Work.run = lambda self, request: bytearray(8 << 30)\n"
        "print(work.done('read', {'text': ''}).status)\n"
    )
    found = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    )
    assert found.stdout == "crashed\n", found.stderr


# -- what is written and built ----------------------------------------------------------------
def test_the_types_of_the_page_are_current() -> None:
    sys.path.insert(0, str(ROOT / "tools"))
    import write_studio_types

    assert write_studio_types.TARGET.read_text(encoding="utf-8") == write_studio_types.written(), (
        "run python tools/write_studio_types.py"
    )


def sources_digest() -> str:
    """As `studio/vite.config.ts` finds it."""
    folder = ROOT / "studio"
    names = ["index.html", "package.json", "package-lock.json", "vite.config.ts", "svelte.config.js", "tsconfig.json"]
    paths = [folder / name for name in names] + [p for p in (folder / "src").rglob("*") if p.is_file()]
    paths.append(ROOT / "src" / "freebody" / "present" / "player.js")
    digest = hashlib.sha256()
    for name, path in sorted((path.relative_to(ROOT).as_posix(), path) for path in paths):
        digest.update(f"{name}\n".encode())
        digest.update(path.read_text(encoding="utf-8").replace("\r\n", "\n").encode())
    return digest.hexdigest()


def test_the_built_page_is_current_and_small() -> None:
    page = files("freebody.studio").joinpath("page")
    assert page.joinpath("sources.sha256").read_text().strip() == sources_digest(), "run npm run build in studio/"
    sizes = [len(gzip.compress(page.joinpath(name).read_bytes())) for name in ("studio.js", "studio.css", "index.html")]
    assert sum(sizes) < 400_000
    assert "MIT" in page.joinpath("LICENSES.txt").read_text(encoding="utf-8")


def test_the_lock_file_names_no_registry() -> None:
    assert "resolved" not in (ROOT / "studio" / "package-lock.json").read_text(encoding="utf-8")


# -- a sweep ----------------------------------------------------------------------------------
def test_a_sweep_of_a_question_is_its_formula_and_a_case_that_the_model_excludes_is_a_gap() -> None:
    """Of a rod on a pin, theta'' = -3 g/(2 L) cos(theta); lengths are positive."""
    reply = done("sweep", {"text": PENDULUM, "name": "L", "low": "-50 cm", "high": "200 cm", "n": 6, "find": "first"})
    found = SweepAnswer.model_validate(reply.answer)
    assert (found.unit, found.values) == ("cm", [-50, 0, 50, 100, 150, 200])
    (line,) = found.lines
    assert (found.about, line.name, line.unit) == ("acceleration of theta", "first", "rad/s^2")
    assert line.values[:2] == [None, None]
    assert line.values[2:] == pytest.approx([-1.5 * 9.81 / L * 0.5 for L in (0.5, 1, 1.5, 2)], rel=1e-6)
    assert found.statuses == ["not admissible"] * 2 + ["formula"] * 4
    (missing,) = found.missing
    assert (missing.status, missing.count, missing.first) == ("not admissible", 2, -50)
    assert missing.why == "L = -0.5; the model says that it is positive"


@pytest.mark.parametrize(("record", "sign"), [("maximum of theta_rate", 1), ("minimum of theta_rate", -1)])
def test_a_sweep_of_a_motion_records_its_greatest_and_least_value(record: str, sign: int) -> None:
    """A rod that falls from the angle theta is fastest where it hangs: L omega^2 = 3 g (1 + sin(theta))."""
    given = {
        "text": PENDULUM,
        "name": "theta",
        "low": "-60 deg",
        "high": "-30 deg",
        "n": 3,
        "record": record,
        "until": 3.0,
    }
    found = SweepAnswer.model_validate(done("sweep", given).answer)
    assert (found.unit, found.values, found.missing) == ("deg", [-60, -45, -30], [])
    expected = [sign * math.sqrt(3 * 9.81 * (1 + math.sin(math.radians(angle)))) for angle in found.values]
    assert found.lines[0].values == pytest.approx(expected, rel=1e-5)
    assert record.split(" of ")[1] in curved(MotionRequest(text=PENDULUM, until=0.1, frames=3)).recordable


def test_a_sweep_tells_which_linkages_cannot_be_assembled() -> None:
    """The crank is driven by 3 N m alone, so its energy is 3 N m times its angle; a ground link that is longer than
    the others can reach is a gap."""
    text = (ROOT / "examples" / "four_bar.yaml").read_text(encoding="utf-8")
    given = {"text": text, "name": "d", "low": "0.3 m", "high": "1.5 m", "n": 5, "until": 0.1, "language": "de"}
    energy, angle = (
        SweepAnswer.model_validate(done("sweep", {**given, "record": f"final {name}"}).answer)
        for name in ("kinetic_energy", "theta")
    )
    turned = [None if x is None else 3.0 * (x - math.pi / 3) for x in angle.lines[0].values]
    assert energy.lines[0].values == [None if x is None else pytest.approx(x, rel=1e-5) for x in turned]
    assert [x is None for x in turned] == [False, False, False, True, True]
    (missing,) = energy.missing
    assert (missing.status, missing.count, missing.first) == ("nicht zusammensetzbar", 2, 1.2)
    assert missing.why.startswith("der Anfang lässt sich nicht zusammenfügen")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"low": "1 kg", "find": "first"}, "L hat die Einheit m"),
        ({"low": "long", "find": "first"}, "„long“ ist keine Größe"),
        ({"n": 1, "find": "first"}, "n: "),
        ({"record": "final colour"}, "lässt sich nicht aufzeichnen"),
    ],
)
def test_a_sweep_that_cannot_be_read_is_refused_in_words(given: dict[str, Any], words: str) -> None:
    request = {"text": PENDULUM, "language": "de", "name": "L", "low": "1 m", "high": "2 m", "n": 3, **given}
    reply = done("sweep", request)
    assert reply.status == "refused"
    assert words in reply.message


# -- files ----------------------------------------------------------------------------------
@pytest.mark.parametrize("name", ["html", "tex", "md", "ipynb", "txt"])
def test_a_report_is_one_file_in_which_all_is_found_that_it_names(name: Any) -> None:
    """Browsers put what they are given side by side, so that figures in folders would not be found."""
    request = ExportRequest(text=PENDULUM, name="explain", format=name)
    (file,) = exported(request).files
    content = base64.b64decode(file.content)
    assert file.name == ("explain.md.zip" if name == "md" else f"explain.{name}")
    if name != "md":
        return
    assert content == base64.b64decode(exported(request).files[0].content)
    with zipfile.ZipFile(BytesIO(content)) as packed:
        named = re.findall(r"\]\(([^)#]+\.svg)\)", packed.read("explain.md").decode())
        assert named
        assert sorted(packed.namelist()) == sorted(["explain.md", *named])
        assert all(packed.read(figure).startswith(b"<svg") for figure in named)


def test_values_in_a_german_picture_have_a_decimal_comma() -> None:
    """A weight of 2 kg: 19.6 N."""
    request = {"text": PENDULUM, "free": ["rod"], "at": 0.1, "show": ["force"]}
    for language, value in (("de", "= 19,6 N"), ("en", "= 19.6 N")):
        assert value in base64.b64decode(drawn(PictureRequest(language=language, **request)).content).decode()


# -- a page to share --------------------------------------------------------------------------
def test_motions_found_beforehand_are_those_of_the_texts_that_the_sliders_stand_for() -> None:
    request = ShareRequest(text=PENDULUM, until=1.0, frames=31, vary=["L=0.5..2 m:3", "theta=-90, -30 deg"])
    own = motion(MotionRequest(text=PENDULUM, until=1.0, frames=31)).model_dump(mode="json")
    moved = moved_beforehand(System.from_text(PENDULUM), request, own)
    length, angle = moved.sliders
    assert (length.values, length.own) == (["0.5 m", "1 m", "1.25 m", "2 m"], 1)
    assert (angle.values, angle.own) == (["-90 deg", "-60 deg", "-30 deg"], 1)
    assert len(moved.replies) == len(moved.curves) == 12
    assert "themes" not in moved.replies[0].answer["player"]
    for k, at in enumerate(length.values):
        for n, start in enumerate(angle.values):
            text = PENDULUM.replace("L: 1 m", f"L: {at}").replace("theta: -60 deg", f"theta: {start}")
            expected = motion(MotionRequest(text=text, until=1.0, frames=31)).model_dump(mode="json")
            found = moved.replies[3 * k + n].answer
            assert {**own["player"], **found["player"]} == expected["player"]
            assert (found["start"], found["end"]) == (expected["start"], expected["end"]) == (0.0, 1.0)
            curves = curved(MotionRequest(text=text, until=1.0, frames=31)).model_dump(mode="json")
            assert moved.curves[3 * k + n].answer == curves


def test_answers_follow_the_sliders_by_the_formula() -> None:
    """Of a rod on a pin, theta'' = -3 g/(2 L) cos(theta)."""
    text = PENDULUM
    request = ShareRequest(text=text, until=0.2, frames=11, vary=["L=0.5..2 m:3", "theta=-90, -30 deg"])
    own = motion(MotionRequest(text=text, until=0.2, frames=11)).model_dump(mode="json")
    (answer,) = moved_beforehand(System.from_text(text), request, own).answers
    lengths, angles = (0.5, 1.0, 1.25, 2.0), (-90, -60, -30)
    expected = [-1.5 * 9.81 / L * math.cos(math.radians(a)) for L in lengths for a in angles]
    found = [float(value.removesuffix(" rad/s^2")) for value in answer.values]
    assert found == pytest.approx(expected, rel=1e-4, abs=1e-12)


@pytest.mark.parametrize(
    ("vary", "words"),
    [
        (["L=0.5..2 m:30", "m=1..2 kg:30"], "at most 600"),
        (["Q=1..2"], "Q is no parameter"),
        (["L=1..2 kg"], "L is in m"),
        (["theta'=0..1 rad/s"], "no value in the file"),
    ],
)
def test_sliders_that_make_no_sense_are_refused_in_words(vary: list[str], words: str) -> None:
    reply = done("share", {"text": PENDULUM, "until": 1.0, "frames": 11, "vary": vary})
    assert reply.status == "refused"
    assert words in reply.message


def test_a_case_without_a_motion_says_why() -> None:
    text = (ROOT / "examples" / "four_bar.yaml").read_text(encoding="utf-8")
    own = motion(MotionRequest(text=text, until=0.1, frames=3)).model_dump(mode="json")
    request = ShareRequest(text=text, until=0.1, frames=3, vary=["d=0.5, 5 m"])
    first, second = moved_beforehand(System.from_text(text), request, own).replies
    assert (first.status, second.status) == ("done", "refused")
    assert second.message


def test_models_of_the_folder_and_of_the_gallery_find_what_stands_beside_them(tmp_path: Path) -> None:
    """A table in the folder; that of an example before it is saved; and saved with it, but never over another."""
    example = (ROOT / "examples" / "car_on_a_surveyed_track.yaml").read_text(encoding="utf-8")
    (tmp_path / "own.csv").write_text("x [m], y [m]\n0, 2\n1, 1\n2, 0\n", encoding="utf-8")
    texts = [example.replace("surveyed_track.csv", "own.csv"), example, example.replace("surveyed_track", "nothing")]
    calls = [Call(kind="read", topic="abc"[k], request={"text": text}) for k, text in enumerate(texts)]

    async def run() -> list[ReadAnswer]:
        lanes = Lanes(tmp_path, ROOT / "examples")
        replies = [Reply.model_validate_json(await lanes.ask(call)) for call in calls]
        await lanes.end()
        return [ReadAnswer.model_validate(reply.answer) for reply in replies]

    own, bundled, lacking = asyncio.run(run())
    assert (own.is_model, bundled.is_model, lacking.is_model) == (True, True, False)
    assert "there is no file nothing.csv" in lacking.remarks[0].message
    folder = Folder.of(tmp_path)
    folder.save(SaveRequest(name="car.yaml", text=example, version=""))
    table = tmp_path / "surveyed_track.csv"
    assert table.read_bytes() == (ROOT / "examples" / "surveyed_track.csv").read_bytes()
    table.write_text("mine", encoding="utf-8")
    folder.save(SaveRequest(name="again.yaml", text=example, version=""))
    assert table.read_text(encoding="utf-8") == "mine"
