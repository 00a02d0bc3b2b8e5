"""Steady motions whose place has no closed form, and precession of a top whose axis lies exactly level.

By hand: a bob of mass m on a rod of length L that goes round with Omega at the angle theta from down has
m L^2 Omega^2 sin cos = m g L sin + M(theta), where M is what a spring turns it back with. For a top with C, A about its
tip and the axis at theta, A' = A + m l^2: (C - A') cos psi'^2 + C phi' psi' - m g l = 0. Problem families: Meriam &
Kraige, Dynamics, sec. 7/11; Beer & Johnston, Dynamics, ch. 12 (governors); Goldstein, Poole & Safko, sec. 5.7.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from posed import posed

BOB = """
space: {{up: z}}
parameters: {{m: 0.4 kg, L: 1.2 m, k: {k}, g: 9.81 m/s^2, beta: 50 deg, Omega: {rate}, th0: 20 deg}}
bodies:
  yoke: {{body: {{}}, turned: [psi about z]}}
  bob: {{body: {{mass: m}}, points: {{top: [0, 0, L]}}, turned: [theta about y], frame: yoke}}
connections:
  swivel: {{revolute: {{first: ground.O, second: yoke, about: z}}}}
  hinge: {{revolute: {{first: yoke, second: bob.top, about: y}}}}
loads: {{weight: {{gravity: g}}, spring: {{law: {{measure: theta, force: {law}}}}}}}
start: {{psi: 0, theta: beta, rate(theta): 0, rate(psi): Omega}}
"""
TURNED_BACK = BOB.format(k="3 N m", rate="4 rad/s", law="-k*(theta - th0)")
# a governor's spring in the horizontal, without load at the radius L sin th0: quartic in the tangent of half the angle
GOVERNOR = BOB.format(k="30 N/m", rate="14 rad/s", law="-k*L^2*(sin(theta) - sin(th0))*cos(theta)")
TOP = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 0.5 kg, l: 0.06 m, A: 8e-4 kg m^2, C: 5e-4 kg m^2, w: 200 rad/s, b: 90 deg}
bodies:
  top:
    body: {mass: m, inertia: [A, A, C]}
    points: {tip: [0, 0, -l]}
    turned: [psi about z, theta about x, phi about z]
connections: {tip: {spherical: [ground.O, top.tip]}}
loads: {weight: {gravity: g}}
start: {psi: 0, theta: b, phi: 0, rate(psi): 0, rate(theta): 0, rate(phi): w}
"""


def _zeros(moment: str, m: float, L: float, rate: float) -> list[float]:
    """By a fine look at signs, refined by bisection."""

    def f(theta: float) -> float:
        spring = {
            "turned back": 3.0 * (theta - math.radians(20)),
            "governor": 30 * L**2 * (math.sin(theta) - math.sin(math.radians(20))) * math.cos(theta),
        }[moment]
        return m * L**2 * rate**2 * math.sin(theta) * math.cos(theta) - m * 9.81 * L * math.sin(theta) - spring

    places, found = np.linspace(-math.pi, math.pi, 100001), list[float]()
    for a, b in pairwise(places):
        if f(a) * f(b) < 0:
            low, high = float(a), float(b)
            for _ in range(60):
                middle = (low + high) / 2
                low, high = (middle, high) if f(low) * f(middle) > 0 else (low, middle)
            found.append(low)
    return found


@pytest.mark.parametrize(("model", "moment", "rate"), [(TURNED_BACK, "turned back", 4.0), (GOVERNOR, "governor", 14.0)])
def test_all_places_of_a_turn_are_found_and_counted(model: str, moment: str, rate: float) -> None:
    found = posed(model, "theta in steady motion when rate(psi) = Omega")
    wanted = _zeros(moment, 0.4, 1.2, rate)
    assert found.expression is None
    assert "0 = " in found.reason  # the condition in full
    values = found.value if isinstance(found.value, tuple) else (found.value,)
    assert values == pytest.approx(tuple(wanted), abs=1e-12)
    count = "exactly one solution" if len(wanted) == 1 else f"{len(wanted)} solutions"
    assert f"by interval arithmetic it has {count}" in found.reason


def test_a_level_axis_precesses_with_one_rate() -> None:
    level = posed(TOP, "rate of psi in steady motion when theta = 90 deg")
    assert level.value == pytest.approx(9.81 * 0.5 * 0.06 / (5e-4 * 200))
    leaning = posed(TOP, "rate of psi in steady motion when theta = b")
    assert leaning.evidence is not None
    assert any("one such rate alone" in note for note in leaning.notes)
    assert any("Not valid" in note for note in leaning.notes)  # cos(b) = 0 with the numbers of the file
    upright = posed(TOP.replace("b: 90 deg", "b: 60 deg"), "rate of psi in steady motion when theta = b")
    a, b, c = (5e-4 - 8e-4 - 0.5 * 0.06**2) * 0.5, 5e-4 * 200, -0.5 * 9.81 * 0.06
    assert isinstance(upright.value, tuple)
    assert sorted(upright.value) == pytest.approx(sorted(np.roots([a, b, c]).real.tolist()))
