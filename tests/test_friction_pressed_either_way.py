"""Friction whose normal force may have either sign: the thread of a screw, the two sides of a guide.

Problem families: Meriam & Kraige, Statics, sec. 6/5 (screws); Beer, Johnston & Cornwell, Vector Mechanics for
Engineers: Dynamics, ch. 12 (collars on rods).
"""

from __future__ import annotations

import math

import pytest

from freebody.api import System

SPINDLE = """
space: {{up: z}}
parameters: {{m: 100 kg, J: 0.02 kg m^2, p: 40 mm, r: 15 mm, mu: 0.1, g: 9.81 m/s^2, T: {{value: {T} N m, sign: any}}}}
bodies: {{spindle: {{body: {{mass: m, inertia: J}}}}}}
connections: {{thread: {{screw: {{first: ground.nut, second: spindle, about: z, pitch: p, friction: mu, radius: r}}}}}}
loads: {{weight: {{gravity: g}}, drive: {{torque: {{on: spindle, about: z, magnitude: T}}}}}}
measures: {{x: drop of spindle}}
start: {{x: 0, rate(x): 0}}
"""
COLLAR = """
parameters: {{m: 2 kg, F: {F} N, alpha: 50 deg, mu: 0.2, g: 9.81 m/s^2}}
bodies: {{collar: {{particle: {{mass: m}}}}}}
connections: {{rod: {{slider: {{body: collar, along: right, friction: mu}}}}}}
loads: {{weight: {{gravity: g}}, pull: {{force: {{at: collar, along: alpha, magnitude: F}}}}}}
measures: {{x: x of collar}}
start: {{x: 0, rate(x): 0}}
"""


@pytest.mark.parametrize("torque", [-1.0, -20.0, -60.0])
def test_a_spindle_driven_down_is_pressed_on_the_other_flank_of_its_thread(torque: float) -> None:
    """Let S be what the thread pushes up by, k = 2 pi/p, tan(l) = p/(2 pi r), and F <= mu |S| the friction round the
    axis, that works along it as F tan(l):

        m a = m g - S - F tan(l)        J k a = -T + r (S tan(l) - F)        F = mu S or -mu S, as S is positive or not.

    S has the sign of J k g + T: what is driven down faster than its weight would have it go hangs on the upper flank.
    Both signs of S are tried, and the one taken that comes out.
    """
    m, j, p, r, mu, g = 100.0, 0.02, 0.04, 0.015, 0.1, 9.81
    k, tangent = 2 * math.pi / p, p / (2 * math.pi * r)
    expected = []
    for sign in (1, -1):
        # S from both balances, with a left out
        s = (m * (j * k * g + torque)) / (j * k * (1 + sign * mu * tangent) + m * r * (tangent - sign * mu))
        if s * sign >= 0:
            expected.append(g - s * (1 + sign * mu * tangent) / m)
    (a,) = expected
    answer = System.from_text(SPINDLE.format(T=torque)).solve("acceleration of x").answers[0]
    assert not answer.reason
    assert answer.value == pytest.approx(a, rel=1e-9)
    run = System.from_text(SPINDLE.format(T=torque)).simulate(until=1)
    assert run.dataset["x"].values[-1] == pytest.approx(a / 2, rel=1e-7)


@pytest.mark.parametrize("force", [10.0, 60.0])
def test_a_collar_pulled_up_rubs_on_the_lower_side_of_its_rod(force: float) -> None:
    """x'' = (F cos(alpha) - mu |m g - F sin(alpha)|)/m; the case is told by the sign of m g - F sin(alpha)."""
    m, alpha, mu, g = 2.0, math.radians(50), 0.2, 9.81
    answer = System.from_text(COLLAR.format(F=force)).solve("acceleration of x").answers[0]
    assert not answer.reason
    assert answer.value == pytest.approx((force * math.cos(alpha) - mu * abs(m * g - force * math.sin(alpha))) / m)
    lifts = {"m": m, "F": 40.0, "alpha": alpha, "mu": mu, "g": g}  # m g = F sin(alpha) at F = 25.6 N
    names = {**lifts, "sin": math.sin, "cos": math.cos, "pi": math.pi}
    told = [c["expression"] for c in answer.to_plain()["conditions"]]
    assert all(eval(x, {}, names) for x in told) == (force > 25.6)  # our own text
