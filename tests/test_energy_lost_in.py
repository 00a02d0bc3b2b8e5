"""The energy that is lost in one connection, where others and loads take some too."""

from __future__ import annotations

import math

import pytest

import freebody as fb

WHEEL = """
parameters: {J: 0.2 kg m^2, w: 30 rad/s, T: 2 N m, c: 0.02 N m s}
bodies: {wheel: {body: {inertia: J}, points: {O: [0, 0]}}}
connections: {h: {pin: [ground.O, wheel.O]}, brake: {brake: {between: [wheel, ground], torque: T}}}
loads: {air: {law: {measure: theta, force: -c*rate(theta)}}}
measures: {theta: angle of wheel}
start: {theta: 0, rate(theta): w}
"""
BOUNCE = """
parameters: {m: 1 kg, mu: 0.2, v: 4 m/s, e: 0.5, d: 1 m, g: 9.81 m/s^2}
ground: {points: {W: [d, 0]}, lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections:
  rub: {contact: {between: [block, floor], friction: mu}}
  wall: {stop: {measure: x, max: d, restitution: e}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
start: {x: 0, rate(x): v}
"""


def asked(text: str, question: str) -> fb.Answer:
    return fb.System.from_text(text).solve(question).answers[0]


@pytest.mark.parametrize(
    "question",
    [
        "energy lost in brake until rate(theta) = 0",
        "energy dissipated in the brake until wheel stops",
        "How much energy is lost in the brake until it stops?",
    ],
)
def test_a_brake_takes_its_torque_times_the_angle_and_the_air_the_rest(question: str) -> None:
    # J w' = -T - c w: the wheel turns by J/c (w0 - T/c log(1 + c w0/T)) until it stops
    turned = 0.2 / 0.02 * (30 - 2 / 0.02 * math.log(1 + 0.02 * 30 / 2))
    assert asked(WHEEL, question).value == pytest.approx(2 * turned)


def test_a_law_that_vanishes_at_rest_takes_energy_as_a_damper_does() -> None:
    """The brake and the air together take all of J w^2/2."""
    assert asked(WHEEL, "energy lost until rate(theta) = 0").value == pytest.approx(0.2 * 30**2 / 2)


FALLING = """
parameters: {m: 80 kg, c: 20 kg/m, g: 9.81 m/s^2}
bodies: {jumper: {particle: {mass: m}}}
connections: {line: {slider: {body: jumper, along: down, through: ground.O}}}
ground: {points: {O: [0, 0]}}
loads: {weight: {gravity: g}, air: AIR}
measures: {s: drop of jumper below ground.O}
start: {s: 0, rate(s): 0}
"""


@pytest.mark.parametrize(
    "air", ["{law: {measure: s, force: -c*rate(s)^2}}", "{force: {on: jumper, along: up, magnitude: c*rate(s)^2}}"]
)
def test_the_air_takes_what_a_falling_body_lacks(air: str) -> None:
    """m g s - m v^2/2 with v^2 = m g/c (1 - exp(-2 c s/m))."""
    answer = asked(FALLING.replace("AIR", air), "energy lost when s = 10 m")
    gained = 80**2 * 9.81 / (2 * 20) * (1 - math.exp(-2 * 20 * 10 / 80))
    assert answer.value == pytest.approx(80 * 9.81 * 10 - gained)


def test_a_motor_whose_torque_falls_with_its_speed_is_no_loss() -> None:
    text = """
parameters: {J: 2 kg m^2, M0: 10 N m, c: 0.1 N m s}
ground: {points: {O: [0, 0]}}
bodies: {wheel: {body: {inertia: J}}}
connections: {O: {pin: [ground.O, wheel]}}
measures: {phi: angle of wheel}
loads: {motor: {torque: {on: wheel, magnitude: M0 - c*rate(phi)}}}
start: {phi: 0, rate(phi): 0}
"""
    answer = asked(text, "energy lost until t = 10 s")
    assert answer.value == 0
    assert any("energy lost in motor" in note for note in answer.notes)


def test_a_brake_does_the_work_that_it_takes_and_a_pin_none() -> None:
    turned = 0.2 / 0.02 * (30 - 2 / 0.02 * math.log(1 + 0.02 * 30 / 2))
    assert asked(WHEEL, "work of brake until rate(theta) = 0").value == pytest.approx(-2 * turned)
    answer = asked(WHEEL, "work of h until rate(theta) = 0")
    assert answer.value is None
    assert "h is no load" in answer.reason


def test_a_floor_and_a_wall_take_their_own_shares() -> None:
    # mu m g on every metre, and (1 - e^2) of the energy with which the block comes to the wall
    rub, wall, both = (
        asked(BOUNCE, f"energy lost{where} until block stops").value for where in (" in rub", " in wall", "")
    )
    at_wall = 4**2 / 2 - 0.2 * 9.81 * 1
    assert wall == pytest.approx(0.75 * at_wall)
    assert rub == pytest.approx(0.2 * 9.81 * 1 + 0.25 * at_wall)
    assert both == pytest.approx(8)


def test_an_unknown_name_is_refused_with_those_there_are() -> None:
    with pytest.raises(fb.ModelError, match="there is no connection or load clutch"):
        asked(WHEEL, "energy lost in clutch until rate(theta) = 0")


def test_nothing_is_lost_where_the_event_is_the_start() -> None:
    rest = WHEEL.replace("w: 30 rad/s", "w: {value: 0 rad/s, sign: nonnegative}")
    for where in ("", " in brake"):
        answer = asked(rest, f"energy lost{where} until wheel stops")
        assert answer.value in (0.0, None), where


@pytest.mark.parametrize(("law", "why"), [("-c*rate(s) - k*s", "stores energy and takes it"), ("c*rate(s)", "")])
def test_a_law_that_stores_or_drives_is_no_loss(law: str, why: str) -> None:
    text = FALLING.replace("AIR", f"{{law: {{measure: s, force: {law}}}}}")
    text = text.replace("c: 20 kg/m", "c: 20 kg/s, k: 50 N/m")
    answer = asked(text, "energy lost until t = 1 s")
    assert why in answer.reason
    assert answer.value == (None if why else 0.0)
