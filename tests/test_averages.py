"""Averages over a time, and over the angle of a turn, asked in one's own words."""

from __future__ import annotations

from math import pi

import pytest

import freebody as fb

LIFTED = fb.System.from_text("""
parameters: {m: 500 kg, F: 6 kN, g: 9.81 m/s^2}
bodies: {load: {particle: {mass: m}}}
connections: {guide: {slider: {body: load, along: up, through: ground.O}}}
loads: {weight: {gravity: g}, rope: {force: {at: load, along: up, magnitude: F}}}
measures: {z: height of load}
start: {z: 0, rate(z): 0}
""")
BRAKED = fb.System.from_text("""
parameters: {m: 1200 kg, v0: 5 m/s, mu: 0.6, g: 9.81 m/s^2}
ground: {lines: {road: {along: right}}}
bodies: {car: {particle: {mass: m}, at: [0, 0], velocity: [v0, 0]}}
connections: {road: {contact: {between: [car, road], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of car}
""")
DAMPED = fb.System.from_text("""
parameters: {e: 0.1 m, c: 20 N s/m, m: 2 kg, Omega: 20 rad/s}
bodies: {crank: {rod: {length: e}}, yoke: {particle: {mass: m}}}
connections:
  O: {pin: [ground.O, crank.start]}
  guide: {slider: {body: yoke, along: right, through: ground.O}}
  pin: {slot: {pin: crank.end, through: yoke, along: up}}
  motor: {driver: {measure: phi, follows: Omega*t}}
loads: {drag: {damper: {from: ground.wall, to: yoke, damping: c}}}
ground: {points: {O: [0, 0], wall: [-1 m, 0]}}
measures: {phi: angle of crank}
""")
RISE = 6000 / 500 - 9.81


def value(system: fb.System, said: str) -> float:
    (answer,) = system.solve(said).answers
    return answer.value


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("mean power of the rope in the first 3 s", 6000 * RISE * 3 / 2),  # F v(3 s)/2
        ("What is the average power of the rope while the load rises 5 m?", 6000 * (RISE * 5 / 2) ** 0.5),
        ("mittlere Leistung des Seils in den ersten 3 s", 6000 * RISE * 3 / 2),
        ("mean speed of the load during the first 2 s", RISE),
    ],
    ids=["power", "power up to a height", "power in German", "speed"],
)
def test_average_of_what_is_lifted_evenly_faster(said: str, expected: float) -> None:
    assert value(LIFTED, said) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("average speed until the car stops", 2.5),
        ("Durchschnittsgeschwindigkeit des Autos bis es steht", (2.5, 0.0)),
    ],
    ids=["speed", "velocity in German"],
)
def test_average_of_what_is_braked_evenly(said: str, expected: float) -> None:
    assert value(BRAKED, said) == pytest.approx(expected, rel=1e-9)


def test_average_torque_over_a_turn_is_the_work_of_a_damper_over_the_angle() -> None:
    """v = e Omega sin(phi), c v^2 over a turn: pi c e^2 Omega."""
    work = pi * 20 * 0.1**2 * 20
    assert value(DAMPED, "mean driving torque over a turn") == pytest.approx(work / (2 * pi), rel=1e-6)
    assert value(DAMPED, "average power of the motor during one revolution") == pytest.approx(
        work * 20 / (2 * pi), rel=1e-6
    )
    assert value(DAMPED, "average speed of the yoke over a turn") == pytest.approx(4 * 0.1 * 20 / (2 * pi), rel=1e-6)
