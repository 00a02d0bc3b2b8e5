"""For which parameters there is an equilibrium, where what holds it has a limit."""

from __future__ import annotations

import pytest

import freebody as fb
from conftest import Agree

BAR = """
freebody: 1
parameters: {m: 2 kg, L: 1 m, T: 5 N m, g: 9.81 m/s^2}
bodies: {bar: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.O, bar.start]}}
loads: {weight: {gravity: g}, motor: {torque: {on: bar, magnitude: T}}}
measures: {phi: {angle of bar from down}}
start: {phi: 0, rate(phi): 0}
"""


def test_bar_rests_under_a_torque_of_at_most_that_of_its_weight_when_level(agrees: Agree) -> None:
    """sin(phi) = T/(m g L/2)."""
    system = fb.System.from_text(BAR)
    agrees(system.solve("range of T for which an equilibrium exists"), "q1", "m*g*L/2")
    agrees(system.solve("for which m is there an equilibrium?"), "q1", "2*T/(g*L)")
    (found,) = system.solve("range of m for which there is no equilibrium").answers
    assert found.value == pytest.approx(2 * 5 / 9.81)
    assert any("m < " in note for note in found.notes)


def test_where_there_always_is_one_that_is_said() -> None:
    (found,) = (
        fb.System.from_text(BAR.replace("T: 5 N m, ", "").replace(", motor: {torque: {on: bar, magnitude: T}}", ""))
        .solve("range of L for which an equilibrium exists")
        .answers
    )
    assert found.expression is None
    assert "whatever the parameters are" in found.reason


COLLAR = """
parameters: {m: 0.4 kg, k: 200 N/m, l0: 0.2 m, W: 15 rad/s}
bodies:
  arm: {rod: {length: 0.6 m}, at: {start: [0, 0]}, angle: 0}
  collar: {particle: {mass: m}, at: [l0, 0]}
connections:
  hub: {pin: [ground.O, arm.start]}
  guide: {slider: {body: collar, on: arm, along: arm.x}}
  motor: {driver: {body: arm, speed: W}}
loads: {spring: {spring: [arm.start, collar], stiffness: k, length: l0}}
measures: {r: {distance from arm.start to collar}}
"""


def test_a_distance_below_zero_is_no_equilibrium_and_no_claim_is_made_that_numbers_do_not_check() -> None:
    """r = k l0/(k - m W^2) is a distance for W < sqrt(k/m) alone; rest beside a drive is not searched in numbers."""
    (found,) = fb.System.from_text(COLLAR).solve("maximum W for which an equilibrium exists").answers
    assert found.expression is None
    assert "whatever the parameters are" not in found.reason
    assert "knows none beside what a drive moves" in found.reason


def test_where_a_divisor_vanishes_is_told_beside_the_claim() -> None:
    """x = F/(k - c), and none for c = k."""
    text = """
parameters: {m: 2 kg, k: 100 N/m, c: {value: 30 N/m, sign: any}, F: 5 N}
bodies: {cart: {particle: {mass: m}}}
connections: {rail: {slider: {body: cart, along: right}}}
measures: {x: {x of cart}}
loads: {push: {force: {at: cart, along: right, magnitude: F - (k - c)*x}}}
start: {x: 0, rate(x): 0}
"""
    (found,) = fb.System.from_text(text).solve("range of c for which an equilibrium exists").answers
    assert found.expression is None
    assert "whatever" not in found.reason
    assert "= 0" in found.reason
