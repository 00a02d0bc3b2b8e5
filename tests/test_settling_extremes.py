"""The greatest value of a quantity of a rate that settles: the power of a motor over its run-up."""

from __future__ import annotations

import pytest

import freebody as fb

MOTOR = """
parameters: {T_0: 30 N m, omega_0: 40 rad/s, J: 0.2 kg m^2, T_L: LOAD}
bodies: {rotor: {body: {inertia: J, radius: 0.1 m}}}
connections: {axle: {pin: [ground.O, rotor]}}
loads:
  motor: {motor: {on: rotor, stall_torque: T_0, no_load_speed: omega_0}}
  load: {torque: {on: rotor, magnitude: -T_L}}
measures: {phi: {angle of rotor}}
start: {phi: 0, rate(phi): 0}
"""
FALL = """
parameters: {m: 1 kg, c: 2 kg/s, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}, air: {drag: {body: ball, linear: c}}}
connections: {guide: {slider: {body: ball, along: up}}}
measures: {y: y of ball}
start: {y: 0, rate(y): 0}
"""


def asked(text: str, words: str) -> fb.Answer:
    return fb.System.from_text(text).solve(words)["q1"]


def test_greatest_power_of_a_motor_is_at_half_its_no_load_speed() -> None:
    answer = asked(MOTOR.replace("LOAD", "10 N m"), "greatest power of motor")
    # T_0 omega_0/4 where the run-up passes omega_0/2: it ends at omega_0 (1 - T_L/T_0) = 26.7 rad/s
    assert answer.value == pytest.approx(30 * 40 / 4)
    assert answer.evidence is not None
    assert any("T_0 > 2·T_L" in condition for condition in answer.conditions)


def test_motor_under_a_heavy_load_comes_near_to_the_power_of_its_steady_speed() -> None:
    answer = asked(MOTOR.replace("LOAD", "20 N m"), "greatest power of motor")
    # the steady speed is omega_0/3, short of omega_0/2; there the motor gives T_L omega_0/3
    assert answer.value == pytest.approx(20 * 40 / 3)
    assert any("never quite reaches" in str(note) for note in answer.notes)


def test_greatest_power_of_a_motor_is_the_greatest_of_its_powers_at_events() -> None:
    text = MOTOR.replace("LOAD", "10 N m")
    at = [asked(text, f"power of motor when rate(phi) = {rate} rad/s").value for rate in (15, 20, 25)]
    assert at == pytest.approx([30 * w * (1 - w / 40) for w in (15, 20, 25)])
    assert asked(text, "Wie groß ist die größte Leistung des Motors?").value == pytest.approx(max(at))


def test_greatest_speed_of_a_fall_against_the_air_is_that_to_which_it_tends() -> None:
    answer = asked(FALL, "greatest speed of ball")
    assert answer.value == pytest.approx(9.81 / 2)
    # the weight then has the power m g v
    assert asked(FALL, "greatest power of weight").value == pytest.approx(9.81 * 9.81 / 2)
