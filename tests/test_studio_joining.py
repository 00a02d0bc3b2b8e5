"""Connections by pointing: where the spots are, and what comes of those that were pointed at."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("starlette")

from freebody.errors import InputError, ModelError
from freebody.language.document import Document
from freebody.studio.joining import join, spots
from freebody.studio.kinds import kinds
from freebody.studio.wire.texts import End, JoinAnswer, JoinRequest, Request
from freebody.system.system import System

MODEL = """bodies:
  rod: {rod: {mass: 1 kg, length: 1 m}}
  wheel: {disk: {mass: 1 kg, radius: 0.2 m}, at: [2 m, 0.2 m]}
ground: {lines: {floor: {through: [0, 0], along: right}}}
connections:
  A: {pin: [ground.origin, rod.start]}  # hinge
measures: {theta: angle of rod}
start: {theta: 30 deg}
"""


def joined(kind: str, *names: str, section: str = "connections") -> JoinAnswer:
    """A name that is empty is the place (1.23456, 2) of the ground."""
    ends = [End(name=name, at=(1.23456, 2.0)) for name in names]
    return join(JoinRequest(text=MODEL, section=section, kind=kind, ends=ends))


def test_spots_are_where_the_start_puts_them() -> None:
    """A rod of length 1 at 30 degrees about the origin."""
    found = {spot.name: spot.at for spot in spots(Request(text=MODEL)).spots}
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    assert found["rod.start"] == pytest.approx((0.0, 0.0))
    assert found["rod.end"] == pytest.approx((c, s))
    assert found["rod"] == pytest.approx((c / 2, s / 2))
    assert found["wheel"] == (2.0, 0.2)
    assert {"floor", "ground.origin"} <= set(found)
    assert "rod.mass_center" not in found  # which is the rod itself


def test_a_place_on_the_ground_is_a_line_where_no_point_will_do() -> None:
    text = "bodies:\n  block: {particle: {mass: 1 kg}}\n"
    ends = [End(name="block"), End(at=(1.0, -0.5))]
    found = join(JoinRequest(text=text, section="connections", kind="contact", ends=ends))
    assert "line: {through: [1 m, -0.5 m], along: right}" in found.text
    assert "between: [block, line]" in found.text
    ends = [End(name="block"), End(name="block")]
    with pytest.raises(ModelError):
        join(JoinRequest(text=text, section="connections", kind="contact", ends=ends))


def test_what_was_pointed_at_is_joined_and_the_rest_of_the_text_stays() -> None:
    found = joined("pin", "rod.end", "wheel.center")
    assert found.text == MODEL.replace("# hinge\n", "# hinge\n  pin: {pin: [rod.end, wheel.center]}\n")
    assert (found.path, found.value) == (["connections", "pin"], "{pin: [rod.end, wheel.center]}")


def test_what_rolls_is_the_body_of_the_spot() -> None:
    assert joined("rolling", "wheel.center", "floor").value == "{rolling: {body: wheel, on: floor}}"


def test_a_place_on_nothing_is_a_new_point_of_the_ground() -> None:
    found = joined("spring", "rod.end", "", section="loads")
    document = Document.read(found.text)
    assert document.data["ground"]["points"] == {"A": ["1.235 m", "2 m"]}
    assert document.data["loads"]["spring"]["spring"]["second"] == "ground.A"
    assert System.from_text(found.text).loads.keys() == {"spring"}


def test_a_point_that_was_the_origin_without_saying_so_stays_there() -> None:
    text = MODEL.replace("ground.origin", "ground.A")
    ends = [End(name="rod.end"), End(at=(1.0, 0.0))]
    found = join(JoinRequest(text=text, section="loads", kind="spring", ends=ends))
    assert Document.read(found.text).data["ground"]["points"] == {"A": [0, 0], "B": ["1 m", "0 m"]}
    after = {spot.name: spot.at for spot in spots(Request(text=found.text)).spots}
    for spot in spots(Request(text=text)).spots:
        assert after[spot.name] == pytest.approx(spot.at, abs=1e-9)


def test_what_cannot_be_joined_is_refused_in_the_words_of_the_reader() -> None:
    with pytest.raises(ModelError, match="rod"):
        joined("gear_mesh", "rod.end", "wheel")
    with pytest.raises(InputError, match="gravity does not join 1 things"):
        joined("gravity", "rod", section="loads")


def test_the_ends_of_a_kind_stand_in_its_smallest_example() -> None:
    known = {kind.kind: [path[1:] for path in kind.ends] for kind in kinds()}
    assert known["pin"] == [[0], [1]]
    assert known["string"] == [["from"], ["over", 0], ["to"]]
    assert known["slider"] == [["body"]]  # along: right names a direction
    assert known["rolling"] == [["body"], ["on"]]
    assert known["driver"] == known["gravity"] == known["rod"] == []
