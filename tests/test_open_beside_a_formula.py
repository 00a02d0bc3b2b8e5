"""A formula in which nothing open stands has its value, also where it belongs to a motion of several phases."""

from __future__ import annotations

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
