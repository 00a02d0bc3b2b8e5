"""Places of zero shear force, rates that are negative throughout, and turns that are counted."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from posed import is_formula, posed

BEAM = """
parameters: {L: 6 m, q: 2 kN/m, F: 3 kN, a: 2 m}
beam: {length: L}
supports: [{type: pin, at: 0}, {type: roller, at: L}]
loads: [{type: distributed, from: 0, to: L, value: q}, {type: point, at: a, value: F}]
"""
# a load so great that the shear force goes through zero where it acts
UNDER_IT = BEAM.replace("F: 3 kN", "F: 30 kN")

ROTOR = """
parameters: {m: 2 kg, L: 0.8 m, w0: 12 rad/s, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {O: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {phi: angle of rod from up}
start: {phi: 0, rate(phi): -w0}
"""

MOTOR = """
parameters: {I: 0.05 kg m^2, M: 15 N m, w1: 60 rad/s}
bodies: {motor: {body: {inertia: I, radius: 0.1 m}}}
connections: {A: {pin: [ground.A, motor]}}
loads: {drive: {torque: {on: motor, magnitude: M}}}
measures: {phi: angle of motor}
start: {phi: 0, rate(phi): 0}
"""


def test_shear_force_is_zero_where_the_rest_of_the_load_is_carried() -> None:
    """A = q L/2 + F (L - a)/L, and A - F - q x = 0."""
    assert is_formula(BEAM, "place of zero shear force of beam", "L/2 - F*a/(L*q)")


def test_shear_force_goes_through_zero_under_a_great_load() -> None:
    assert is_formula(UNDER_IT, "Where is the shear force zero?", "a")


def test_shear_force_without_a_change_of_sign_is_told() -> None:
    cantilever = BEAM.replace(
        "supports: [{type: pin, at: 0}, {type: roller, at: L}]", "supports: [{type: fixed, at: 0}]"
    )
    found = fb.System.from_text(cantilever).solve("place of zero shear force of beam").answers[0]
    assert "nowhere" in str(found.reason)


OVERHANG = """
parameters: {a: 4 m, b: 1.5 m, q: 600 N/m, P: 800 N}
beam: {length: a + b}
supports: [{type: pin, at: 0}, {type: roller, at: a}]
loads: [{type: distributed, from: 0, to: a, value: q}, {type: point, at: a + b, value: P}]
"""


def test_bending_moment_is_zero_between_supports_of_a_beam_with_an_overhang() -> None:
    """A = q a/2 - P b/a, and A x = q x^2/2; it is zero at both ends as well, which is not meant."""
    assert is_formula(OVERHANG, "place of zero bending moment", "a - 2*P*b/(q*a)").value == pytest.approx(3.0)


def test_bending_moment_that_goes_through_zero_twice_or_never_is_told() -> None:
    both = OVERHANG.replace("type: pin, at: 0", "type: pin, at: 1 m")
    assert "twice" in str(posed(both, "place of zero bending moment").reason)
    never = OVERHANG.replace("P: 800 N", "P: -800 N")
    assert "nowhere" in str(posed(never, "place of zero bending moment").reason)


def test_greatest_angular_velocity_of_what_turns_clockwise_is_its_size() -> None:
    """m L^2 w^2/6 + m g L cos(phi)/2 keeps its value, so that w^2 grows by 6 g/L down to the lowest place."""
    found = is_formula(ROTOR, "greatest angular velocity of rod", "sqrt(w0^2 + 6*g/L)")
    assert found.value == pytest.approx(math.sqrt(144 + 6 * 9.81 / 0.8))


def test_turns_are_counted_once() -> None:
    found = fb.System.from_text(MOTOR).solve("How many turns has the motor made until it has w1?").answers[0]
    assert found.value == pytest.approx(60**2 * 0.05 / (2 * 15) / (2 * math.pi))
    assert not found.in_unit
