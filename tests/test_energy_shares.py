"""Shares of the kinetic energy by König's theorem: T = m v_G^2/2 + I_G omega^2/2."""

from __future__ import annotations

import math

import pytest

import freebody as fb

ROLLING = """
parameters: {{m: 2 kg, R: 0.2 m, alpha: 30 deg, g: 9.81 m/s^2, h: 1 m}}
ground: {{lines: {{slope: {{along: -alpha}}}}}}
bodies: {{body: {{{shape}: {{mass: m, radius: R}}}}}}
connections: {{c: {{rolling: {{body: body, on: slope}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{s: {{travel of body along slope}}}}
start: {{s: 0, rate(s): 0}}
"""


@pytest.mark.parametrize(("shape", "share"), [("disk", 1 / 3), ("sphere", 2 / 7), ("spherical_shell", 2 / 5)])
def test_a_share_of_the_energy_of_what_rolls_is_in_its_rotation(shape: str, share: float) -> None:
    """I/(I + m R^2), from omega = v/R."""
    system = fb.System.from_text(ROLLING.format(shape=shape))
    [answer] = fb.solve(
        system, question="ratio of rotational kinetic energy of body to kinetic energy of body when s = h"
    ).answers
    assert answer.value == pytest.approx(share)


def test_both_shares_are_the_work_of_the_weight() -> None:
    system = fb.System.from_text(ROLLING.format(shape="disk"))
    shares = [
        fb.solve(system, question=f"{kind} kinetic energy when s = h").answers[0].value
        for kind in ("rotational", "translational")
    ]
    work = 2.0 * 9.81 * 1.0 * math.sin(math.radians(30.0))
    assert shares == pytest.approx([work / 3.0, 2.0 * work / 3.0])


def test_a_top_in_space_has_shares_too() -> None:
    """A free body: m v^2/2 and (A p^2 + B q^2 + C r^2)/2 along its principal axes."""
    system = fb.System.from_text(
        """
space: {up: z}
bodies: {body: {body: {mass: 3 kg, inertia: [2 kg m^2, 3 kg m^2, 4 kg m^2]}, velocity: [1 m/s, 2 m/s, 2 m/s],
  angular_velocity: [3 rad/s, 1 rad/s, 2 rad/s]}}
"""
    )
    shares = [
        fb.solve(system, question=f"{kind} kinetic energy of body at start").answers[0].value
        for kind in ("rotational", "translational")
    ]
    assert shares == pytest.approx([(18.0 + 3.0 + 16.0) / 2.0, 3.0 * 9.0 / 2.0])
