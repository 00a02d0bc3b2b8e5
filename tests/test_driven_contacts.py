"""A lever that rests on an eccentric: a drive alone leads both, by a contact that may open.

With X = a + e cos(phi), Y = e sin(phi) - R from the hinge to the centre of the disk, X sin(th) - Y cos(th) = R, and
D = X cos(th) + Y sin(th) is the arm of the normal force: N D = m g L cos(th)/2 + m L^2 th''/3. At phi = 90 deg

    D th'  = e w sin(th),    D th'' = -e w^2 cos(th) + 2 e w th' cos(th) - th'^2 (Y cos(th) - X sin(th)).
"""

from __future__ import annotations

from math import atan, cos, pi, sin, sqrt

import pytest

import freebody as fb

ECCENTRIC = """
parameters: {a: 0.3 m, L: 0.6 m, R: 0.1 m, e: 0.03 m, m: 2 kg, w: 5 rad/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], A: [-a, R]}}
bodies:
  disk: {disk: {radius: R}, points: {Q: [-e, 0]}}
  lever: {rod: {mass: m, length: L}, at: {start: [-a, R]}, angle: 0}
connections:
  O: {pin: [ground.O, disk.Q]}
  A: {pin: [ground.A, lever.start]}
  touch: {contact: [disk, lever]}
  motor: {driver: {measure: phi, follows: w*t}}
loads: {weight: {gravity: g}}
measures: {phi: angle of disk, th: angle of lever}
"""


def _expected() -> dict[str, float]:
    a, L, R, e, m, w, g = 0.3, 0.6, 0.1, 0.03, 2.0, 5.0, 9.81
    th = 2 * atan((sqrt(a * a - 2 * R * e + e * e) - a) / (e - 2 * R))
    s, c, X, Y = sin(th), cos(th), a, e - R
    arm = X * c + Y * s
    rate = e * w * s / arm
    second = (-e * w * w * c + 2 * e * w * rate * c - rate**2 * (Y * c - X * s)) / arm
    normal = (m * g * L * c / 2 + m * L**2 * second / 3) / arm
    return {"th": th, "velocity of th": rate, "acceleration of th": second, "normal force of touch": normal}


@pytest.mark.parametrize("quantity", [*_expected()])
def test_lever_on_an_eccentric_is_told_by_its_loop(quantity: str) -> None:
    found = fb.System.from_text(ECCENTRIC).solve(f"{quantity} when phi = 90 deg").answers[0]
    assert found.expression is not None
    assert found.value == pytest.approx(_expected()[quantity], rel=1e-9)


def test_torque_of_the_drive_is_the_moment_of_the_normal_force() -> None:
    """N acts along the normal of the lever through the centre of the disk, e above the axle: M = N e sin(th)."""
    found = fb.System.from_text(ECCENTRIC).solve("driving torque of motor when phi = 90 deg").answers[0]
    told = _expected()
    assert found.value == pytest.approx(told["normal force of touch"] * 0.03 * sin(told["th"]))
    assert 0 < told["th"] < pi / 2
