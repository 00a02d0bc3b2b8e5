"""A formula in which nothing open stands has its value, also where it belongs to a motion of several phases."""

from __future__ import annotations

import math

import pytest

import freebody as fb

CLUTCH = """
parameters: {J: 0.8 kg m^2, I: 0.5 kg m^2, T: 20 N m, w0: 120 rad/s}
ground: {points: [O, Q]}
bodies: {flywheel: {disk: {inertia: J}, angular_velocity: w0}, shaft: {disk: {inertia: I}}}
connections:
  one: {pin: [ground.O, flywheel]}
  two: {pin: [ground.Q, shaft]}
  clutch: {brake: {between: [flywheel, shaft], torque: T}}
"""


def test_what_a_clutch_does_has_numbers_where_only_places_and_radii_are_open() -> None:
    asked = ["time when slipping ends", "angular velocity of shaft when slipping ends"]
    time, speed = fb.System.from_text(CLUTCH).solve(asked).answers
    # the difference of the speeds falls at T/J + T/I, and the angular momentum is kept
    assert time.value == pytest.approx(120 / (20 * (1 / 0.8 + 1 / 0.5)), rel=1e-12)
    assert speed.value == pytest.approx(0.8 * 120 / 1.3, rel=1e-12)
    assert time.missing == ()


def test_only_what_stands_in_a_formula_is_missing_for_its_value() -> None:
    text = """
parameters: {m: , g: , P: , beta: 20 deg, mu: 0.3}
ground: {lines: {plank: {along: beta}}}
bodies: {crate: {particle: {mass: m}}}
connections: {touch: {contact: {between: [crate, plank], friction: mu}}}
loads: {weight: {gravity: g}, push: {force: {at: crate, along: plank, magnitude: P}}}
"""
    held, pressed = (
        fb.System.from_text(text).solve(["range of P that keeps it at rest", "normal force of touch"]).answers
    )
    assert held.missing == pressed.missing == ("m", "g")


CRANE = """
parameters: {M: N m, m: 800 kg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], D: [3 m, 4 m]}}
bodies:
  boom: {rod: {length: 12 m}, angle: 70 deg}
  stay: {rod: {length: 10 m}}
  jib: {body: {}, points: {P: [0, 0], Q: [4 m, 0], T: [-6 m, 0]}, near: {angle: 160 deg, at: [4 m, 11 m]}}
  load: {particle: {mass: m}}
connections:
  A: {pin: [ground.A, boom.start]}
  D: {pin: [ground.D, stay.start]}
  B: {pin: [boom.end, jib.P]}
  C: {pin: [stay.end, jib.Q]}
  T: {pin: [jib.T, load]}
loads:
  weight: {gravity: g}
  luff: {torque: {on: boom, magnitude: M}}
measures: {theta: angle of boom}
start: {theta: 70 deg, rate(theta): 0.02 rad/s}
"""


def test_velocities_in_a_loop_have_values_whatever_torque_is_open() -> None:
    """The loop closed by Newton's method; its rates by the velocities of both ends of the jib, w_jib and w_stay:
    w k x AB + w_jib k x BC = w_stay k x DC."""
    w, theta = 0.02, math.radians(70)
    B = 12 * math.cos(theta), 12 * math.sin(theta)
    jib = 2.0
    for _ in range(40):  # |C - D| = 10
        x, y = B[0] + 4 * math.cos(jib) - 3, B[1] + 4 * math.sin(jib) - 4
        jib -= (x**2 + y**2 - 100) / (8 * (y * math.cos(jib) - x * math.sin(jib)))
    BC = 4 * math.cos(jib), 4 * math.sin(jib)
    # along DC both ends of the stay are at rest
    turn = -w * (B[0] * y - B[1] * x) / (BC[0] * y - BC[1] * x)
    crane = fb.System.from_text(CRANE)
    asked = ["angular velocity of jib at start", "velocity of load at start"]
    spin, velocity = crane.solve(asked).answers
    assert spin.value == pytest.approx(turn)
    assert velocity.value == pytest.approx((-w * B[1] + 1.5 * turn * BC[1], w * B[0] - 1.5 * turn * BC[0]))


def test_a_rate_in_a_loop_has_no_value_where_a_length_of_the_loop_is_open() -> None:
    text = """
parameters: {r: 0.1 m, l: m}
bodies: {crank: {rod: {length: r}}, rod: {rod: {length: l}}, piston: {particle: {mass: 1 kg}}}
connections:
  O: {pin: [ground.origin, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  guide: {slider: {body: piston, along: right}}
measures: {phi: angle of crank}
start: {phi: 40 deg, rate(phi): 2 rad/s}
"""
    found = fb.System.from_text(text).solve("angular velocity of rod at start").answers[0]
    assert found.expression is not None
    assert (found.value, found.missing) == (None, ("l",))
