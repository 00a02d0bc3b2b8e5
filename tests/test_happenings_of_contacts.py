"""Events of contacts in words: what stops, and what rolls on."""

from __future__ import annotations

import pytest

import freebody as fb
from posed import is_derived, is_formula

BRAKE = """
parameters: {m: 30 kg, R: 0.25 m, a: 0.3 m, b: 0.9 m, mu: 0.35, F: 200 N, w: 40 rad/s}
ground: {points: {O: [0, 0], H: [-a, R]}}
bodies:
  drum: {disk: {mass: m, radius: R}}
  lever: {rod: {length: b}, points: {shoe: [a - b/2, 0]}, at: {start: [-a, R]}, angle: 0}
connections:
  axle: {pin: [ground.O, drum]}
  hinge: {pin: [ground.H, lever.start]}
  brake: {contact: {between: [lever.shoe, drum], friction: mu}}
loads: {hand: {force: {at: lever.end, along: down, magnitude: F}}}
measures: {phi: angle of drum}
start: {phi: 0, rate(phi): w}
"""


def test_a_drum_on_its_axle_stops_where_it_no_longer_slips_on_the_shoe() -> None:
    m, R, a, b, mu, F, w = 30.0, 0.25, 0.3, 0.9, 0.35, 200.0, 40.0
    alpha = mu * F * b / a * R / (m * R * R / 2)  # N = F b/a
    answers = fb.System.from_text(BRAKE).solve(["time until drum stops", "turns of drum until drum stops"]).answers
    assert answers[0].value == pytest.approx(w / alpha, rel=1e-12)
    assert answers[1].value == pytest.approx(w * w / (2 * alpha) / (2 * 3.141592653589793), rel=1e-12)


def test_of_two_wheels_that_rub_on_each_other_none_stops_where_they_no_longer_slip() -> None:
    text = BRAKE.replace("shoe: [a - b/2, 0]", "shoe: [a - b/2, 0.1 m]").replace(
        "  axle:", "  bearing: {pin: [lever.shoe, wheel]}\n  axle:"
    )
    text = text.replace("bodies:", "bodies:\n  wheel: {disk: {mass: 2 kg, radius: 0.1 m}}")
    text = text.replace("between: [lever.shoe, drum]", "between: [wheel, drum]")
    (found,) = fb.System.from_text(text).solve("time until drum stops").answers
    assert "never happens" in found.reason  # it drives the wheel on, and both go round


SPOOL = """
parameters: {m: 3 kg, J: 0.02 kg m^2, R: 0.2 m, r: 0.1 m, F: 10 N, b: 40 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {spool: {body: {mass: m, inertia: J}, at: [0, R]}}
connections: {roll: {rolling: {body: spool, on: floor, radius: R}}}
loads:
  weight: {gravity: g}
  pull: {force: {at: spool, along: b, magnitude: F}}
  moment: {torque: {on: spool, magnitude: F*r}}
"""


def test_what_cannot_slip_rolls_until_it_is_lifted_off() -> None:
    """N = m g - F sin b."""
    for who in ("spool", "it"):
        is_formula(SPOOL, f"largest F so that {who} rolls without slipping", "m*g/sin(b)", (1.0, 1.1))
    told = is_derived(SPOOL, "largest F so that spool rolls without slipping")
    assert "What touches at the start comes apart at once" in told["en"]
