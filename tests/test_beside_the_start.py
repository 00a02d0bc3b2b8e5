"""Of what the velocities decide it is told what it is at the start, where the parameters give that."""

from __future__ import annotations

import pytest

from freebody import System

BAT = """
freebody: 1
parameters: {m: 1 kg, L: 0.9 m, x: 0.4 m, J: 3 N s}
ground: {points: {O: [0, 0]}}
bodies: {bat: {rod: {mass: m, length: L}, points: {P: [x - L/2, 0]}, angle: -90 deg}}
connections: {hand: {pin: [ground.O, bat.start]}}
loads: {blow: {impulse: {at: bat.P, along: right, magnitude: J}}}
"""

THROWN = """
freebody: 1
parameters: {m: 1 kg, v0: 8 m/s, b: 40 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(b), v0*sin(b)]}}
loads: {weight: {gravity: g}}
"""


def _notes(text: str, question: str) -> list[str]:
    [answer] = System.from_text(text).solve(question).answers
    return list(map(str, answer.notes))


def test_what_a_blow_makes_of_a_velocity_is_told_beside_the_rate() -> None:
    """J x = (m L^2/3) w."""
    [answer] = System.from_text(BAT).solve("angular velocity of bat").answers
    assert str(answer.to_plain()["expression"]) == "rate(theta_bat)"
    assert answer.value == pytest.approx(3.0 * 0.4 / (0.9**2 / 3))
    assert any("just after the blow of the start it is 3·x·J/(m·L²)" in note for note in answer.notes)


def test_a_kinetic_energy_has_its_formula_at_the_start() -> None:
    [answer] = System.from_text(THROWN).solve("kinetic energy of ball").answers
    assert answer.value == pytest.approx(32.0)
    assert any("at the start it is m·v0²/2" in note.replace("₀", "0") for note in answer.notes), answer.notes


@pytest.mark.parametrize("question", ["kinetic energy of ball at start", "acceleration of ball", "height of ball"])
def test_nothing_is_told_beside_what_has_no_velocity_in_it(question: str) -> None:
    assert not any("at the start" in note for note in _notes(THROWN, question))


def test_what_begins_at_rest_has_nothing_to_tell() -> None:
    at_rest = THROWN.replace("v0: 8 m/s", "v0: {value: 0 m/s, sign: any}")
    assert not any("at the start" in n for n in _notes(at_rest, "kinetic energy of ball"))
