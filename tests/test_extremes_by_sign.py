"""Greatest values of what is negative throughout, and of the power of a drive."""

from __future__ import annotations

import math

from posed import posed

GENEVA = """
parameters: {c: 10 cm, w: 5 rad/s}
ground: {points: {A: [0, 0], B: [c, 0]}}
bodies:
  crank: {rod: {length: c/sqrt(2)}, angle: -45 deg}
  wheel: {body: {mass: 0}, lines: {slot: {along: left}}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [ground.B, wheel]}
  slot: {slot: {pin: crank.end, on: wheel, along: wheel.slot}}
  motor: {driver: {measure: phi, follows: -45 deg + w*t}}
measures: {phi: angle of crank, psi: angle of wheel}
"""
WINCH = """
parameters: {m: 12 kg, R: 0.2 m, phi0: 0.5 rad, Omega: 4 rad/s, M1: 5 kg, g: 9.81 m/s^2}
bodies: {drum: {disk: {mass: m, radius: R}}, load: {particle: {mass: M1}}}
connections:
  axle: {pin: [ground.O, drum]}
  rope: {string: {path: [load, wound on drum at right]}}
  motor: {driver: {measure: phi, follows: phi0*sin(Omega*t)}}
loads: {weight: {gravity: g}}
measures: {phi: angle of drum}
"""


def test_the_greatest_rate_of_what_turns_clockwise_says_how_fast_it_gets() -> None:
    # with the crank on the line of centres the wheel of four slots turns at w/(sqrt(2) - 1)
    answer = posed(GENEVA, "greatest angular velocity of wheel until phi = 40 deg")
    assert any("its size is more, up to 12.071 rad/s" in note for note in answer.notes), answer.notes


def test_what_is_positive_as_well_says_nothing_of_its_sign() -> None:
    answer = posed(GENEVA, "greatest angular acceleration of wheel until phi = 40 deg")
    assert not any("by its sign" in note for note in answer.notes)


def test_the_greatest_power_of_a_drive_is_that_over_its_motion() -> None:
    # P = (R M1 g - R^2 phi0 Omega^2 (m/2 + M1) s) phi0 Omega c, looked at all round the period

    A, B = 0.2 * 5 * 9.81, 0.2**2 * 0.5 * 16 * 11
    most = max((A - B * math.sin(x)) * 0.5 * 4 * math.cos(x) for x in (k * math.tau / 200000 for k in range(200000)))
    value = posed(WINCH, "greatest power of motor").value
    assert isinstance(value, float)
    assert abs(value - most) < 1e-8 * most


def test_the_greatest_tension_over_a_period_needs_the_rope_taut_all_the_time() -> None:
    # the load hangs with g - R phi0 Omega^2 sin(Omega t) on it: taut all round where that is positive at its least
    answer = posed(WINCH, "greatest tension of rope")
    assert answer.conditions == ("g ≥ R·φ₀·Ω² (rope stays taut)",)
