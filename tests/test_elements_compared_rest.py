"""Bodies that stand on several legs, ladders and tripods in space, beside their balances by hand.

    tripod   the legs (m, at R from the middle, high h) share the head: N = (3 m + M) g/3, and the moment of a leg about
             its upper end gives H h = N R - m g R/2, mu = H/N
    ladder   from the foot to the top (a, b, h), a from the wall, b along it: about the foot N_w = W a/(2 h)
             and, across, H_w = b/a N_w, whatever the wall carries; what the wall carries upwards need not be anything,
             so that mu = b/a as long as the foot needs less, sqrt(a^2 + b^2)/(2 h)
    table    N of three legs from two moments; it slides at F = mu W or tips about two of them

Source: Meriam & Kraige, Statics, sec. 3/4 and 6/3; Hibbeler, Statics, sec. 5.6.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from posed import is_formula, posed


def _leg(k: int) -> str:
    turned = f"[{120 * k} deg about z, -(pi - atan(h/R)) about y]"
    return f"{{rod: {{mass: m, length: sqrt(R^2 + h^2)}}, turned: {turned}}}"


TRIPOD = f"""
space: {{up: z}}
parameters: {{m: 3 kg, M: 20 kg, R: 0.6 m, h: 1.5 m, mu: 0.5, g: 9.81 m/s^2}}
ground: {{planes: {{floor: {{normal: up}}}}}}
bodies:
  head: {{particle: {{mass: M}}, at: [0, 0, h]}}
  a: {_leg(0)}
  b: {_leg(1)}
  c: {_leg(2)}
connections:
  top_a: {{spherical: [a.end, head]}}
  top_b: {{spherical: [b.end, head]}}
  top_c: {{spherical: [c.end, head]}}
  foot_a: {{contact: {{between: [a.start, floor], friction: mu}}}}
  foot_b: {{contact: {{between: [b.start, floor], friction: mu}}}}
  foot_c: {{contact: {{between: [c.start, floor], friction: mu}}}}
loads: {{w: {{gravity: g}}}}
"""


def test_a_tripod_spreads_below_a_friction_that_its_legs_ask_for() -> None:
    is_formula(TRIPOD, "least mu so that it stays at rest", "R*(3*m + 2*M)/(2*h*(3*m + M))", factors=(1.0,))
    assert posed(TRIPOD, "normal force of foot_a").value == pytest.approx(29 * 9.81 / 3)


LADDER = """
space: {up: z}
parameters: {m: 12 kg, a: 1.5 m, b: 0.6 m, h: 4 m, mu: 0.6, g: 9.81 m/s^2}
ground: {planes: {floor: {normal: up}, wall: {normal: [-1, 0, 0]}}}
bodies:
  ladder:
    body: {mass: m, inertia: [1 kg m^2, 1 kg m^2, 1 kg m^2]}
    points: {foot: [-a/2, -b/2, -h/2], top: [a/2, b/2, h/2]}
    turned: 0 deg about z
connections:
  foot: {contact: {between: [ladder.foot, floor], friction: mu}}
  top: {contact: {between: [ladder.top, wall], friction: mu}}
loads: {w: {gravity: g}}
"""


@pytest.mark.parametrize(("aside", "least"), [(0.6, 0.6 / 1.5), (0.1, None)], ids=["wall", "foot too"])
def test_a_ladder_that_leans_aside_needs_the_friction_of_the_wall(aside: float, least: float | None) -> None:
    found = posed(LADDER.replace("b: 0.6 m", f"b: {aside} m"), "least mu so that it stays at rest").value
    assert found == pytest.approx(_least_friction(1.5, aside, 4.0) if least is None else least, rel=1e-9)


def _least_friction(a: float, b: float, h: float) -> float:
    """Of the forces that balance, by what the wall carries upwards, V of the weight: N_w h = a/2 - a V, H_w = b/a N_w.
    The wall needs more with V, the foot less: least where both need the same."""
    optimize = pytest.importorskip("scipy.optimize")

    def needs(V: float) -> tuple[float, float]:
        N = a * (0.5 - V) / h
        return math.hypot(b / a * N, V) / N, math.hypot(N, b / a * N) / (1.0 - V)

    V = optimize.brentq(lambda V: needs(V)[0] - needs(V)[1], 0.0, 0.49, xtol=1e-14)
    return needs(V)[0]


TABLE = """
space: {up: z}
parameters: {M: 20 kg, h: 1.5 m, mu: 0.5, F: 30 N, g: 9.81 m/s^2}
ground: {planes: {floor: {normal: up}}}
bodies:
  table:
    body: {mass: M, inertia: [1 kg m^2, 1 kg m^2, 1 kg m^2]}
    points: {a: [0.7 m, 0.1 m, -h], b: [-0.5 m, 0.4 m, -h], c: [-0.2 m, -0.6 m, -h]}
connections:
  a: {contact: {between: [table.a, floor], friction: mu}}
  b: {contact: {between: [table.b, floor], friction: mu}}
  c: {contact: {between: [table.c, floor], friction: mu}}
loads: {w: {gravity: g}, push: {force: {at: table, along: x, magnitude: F}}}
"""


def test_a_table_that_is_pushed_at_its_middle_tips_where_a_leg_carries_nothing() -> None:
    weight, feet = 20 * 9.81, np.array([[0.7, 0.1], [-0.5, 0.4], [-0.2, -0.6]])
    balance = np.vstack([np.ones(3), feet.T])
    still, pushed = np.linalg.solve(balance, [weight, 0, 0]), np.linalg.solve(balance, [0, 1.5, 0])
    tips = min(-n / p for n, p in zip(still, pushed, strict=True) if p < 0)
    assert tips < 0.5 * weight
    system = fb.System.from_text(TABLE)
    found = system.solve([*(f"normal force of {foot}" for foot in "abc"), "largest F so that it stays at rest"])
    assert [found[f"q{k}"].value for k in (1, 2, 3)] == pytest.approx(still + 30 * pushed)
    assert found["q4"].value == pytest.approx(tips)
    slides = fb.System.from_text(TABLE.replace("mu: 0.5", "mu: 0.3")).solve("largest F so that it stays at rest")
    assert slides["q1"].value == pytest.approx(0.3 * weight)
