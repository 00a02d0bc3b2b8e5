"""What is resisted by its rate comes to rest only as the time grows: J phi'' = -c phi', and phi tends to J0/c."""

from __future__ import annotations

import pytest

import freebody as fb
from posed import is_formula, posed

DOOR = """
parameters: {J: 2 kg m^2, c: 0.5 N m s, J0: 6 N m s}
bodies: {door: {body: {inertia: J, radius: 0.5 m}}}
connections: {H: {pin: [ground.H, door]}}
loads: {f: {torsional_damper: {body: door, damping: c}}, hit: {angular_impulse: {on: door, magnitude: J0}}}
measures: {phi: angle of door}
start: {phi: 0}
"""


@pytest.mark.parametrize("question", ["Through which angle does the door turn?", "change of phi until rate(phi) = 0"])
def test_door_turns_by_the_blow_over_its_damping(question: str) -> None:
    found = is_formula(DOOR, question, "J0/c")
    assert any("tends to" in str(note) for note in found.notes)


def test_time_until_it_rests_has_none() -> None:
    found = posed(DOOR, "time when rate(phi) = 0")
    assert found.expression is None
    assert "does not get there" in str(found.reason)


def test_what_rests_after_a_time_is_no_limit() -> None:
    braked = DOOR.replace("f: {torsional_damper: {body: door, damping: c}}", "f: {torque: {on: door, magnitude: -c}}")
    braked = braked.replace("c: 0.5 N m s", "c: 0.5 N m")
    found = fb.System.from_text(braked).solve("phi when rate(phi) = 0").answers[0]
    assert found.value == pytest.approx(6**2 / (2 * 2 * 0.5))
    assert not any("tends to" in str(note) for note in found.notes)
