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
