"""Machines with several loops, told as a chain of names: a toggle crusher, a landing gear at rest, a boom on a ram.

By hand: two circles meet for every dyad; virtual power and moments for what rests. Problem families: Norton, Design of
Machinery, ch. 4 and 11; Meriam & Kraige, Statics, ch. 4 and 7.
"""

from __future__ import annotations

import math

import pytest

from conftest import assert_same_function
from freebody.api import System
from freebody.language.expression import Expr
from freebody.language.notation import to_python, to_text
from posed import posed

CRUSHER = """
parameters: {w: 12 rad/s, Q: 40 kN}
ground: {points: {O: [0, 0], S: [-0.45 m, -0.55 m], J: [0.75 m, 0.25 m]}}
bodies:
  crank: {rod: {length: 40 mm}}
  pitman: {rod: {length: 0.65 m}, near: {angle: -90 deg}}
  back: {rod: {length: 0.45 m}, near: {angle: -10 deg}}
  front: {rod: {length: 0.5 m}, near: {angle: 10 deg}}
  jaw: {rod: {length: 1 m}, near: {angle: -105 deg}, points: {T: [0.1 m, 0.05 m], F: [0.3 m, 0]}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, pitman.start]}
  B: {pin: [pitman.end, back.end]}
  B2: {pin: [pitman.end, front.start]}
  S: {pin: [ground.S, back.start]}
  F: {pin: [front.end, jaw.F]}
  J: {pin: [ground.J, jaw.start]}
  motor: {driver: {measure: phi, follows: w*t}}
loads: {stone: {force: {at: jaw.T, along: left, magnitude: Q}}}
measures: {phi: angle of crank, psi: angle of jaw}
"""

Point = tuple[float, float]


def meeting(a: Point, r: float, b: Point, s: float, side: int) -> Point:
    """Where two circles meet, to the left (1) or right (-1) of the line from a to b."""
    d = math.dist(a, b)
    along = (d * d + r * r - s * s) / (2 * d)
    off = side * math.sqrt(r * r - along * along)
    ex, ey = (b[0] - a[0]) / d, (b[1] - a[1]) / d
    return a[0] + along * ex - off * ey, a[1] + along * ey + off * ex


def jaw(phi: float) -> float:
    """The angle of the jaw: the knee by pitman and back plate, the foot of the front plate by plate and jaw."""
    A = 0.04 * math.cos(phi), 0.04 * math.sin(phi)
    knee = meeting(A, 0.65, (-0.45, -0.55), 0.45, 1)
    foot = meeting(knee, 0.5, (0.75, 0.25), 0.8, -1)
    return math.atan2(foot[1] - 0.25, foot[0] - 0.75)


def test_a_loop_of_a_crusher_goes_round_crank_pitman_and_back_plate_alone() -> None:
    found = posed(CRUSHER, "angular velocity of jaw when phi = 70 deg")
    phi, h = math.radians(70), 1e-5
    assert found.chain is not None
    assert found.value == pytest.approx(12 * (jaw(phi + h) - jaw(phi - h)) / (2 * h), rel=1e-6)
    assert next(to_text(step.name) for step in found.chain.named if "θ" in to_text(step.name)) == "θ_pitman"


def test_the_torque_of_a_crusher_is_that_of_the_power_of_the_stone() -> None:
    phi, h = math.radians(70), 1e-5

    def height_of_work(x: float) -> float:  # T along the crushing force
        psi = jaw(x)
        return 0.75 + 0.6 * math.cos(psi) - 0.05 * math.sin(psi)

    torque = 40e3 * (height_of_work(phi + h) - height_of_work(phi - h)) / (2 * h)
    assert posed(CRUSHER, "driving torque of motor when phi = 70 deg").value == pytest.approx(torque, rel=1e-6)


GEAR = """
parameters: {W: 2 kN, F: N}
ground: {points: {A: [0, 0], B: [0.9 m, 0.05 m], S: [0.15 m, 0.35 m]}}
bodies:
  leg: {rod: {length: 1.4 m}, at: {start: [0, 0]}, angle: -70 deg, points: {C: [0.1 m, 0]}}
  lower: {rod: {length: 0.55 m}, near: {angle: 10 deg}}
  upper: {rod: {length: 0.5 m}, near: {angle: 60 deg}}
connections:
  A: {pin: [ground.A, leg.start]}
  C: {pin: [leg.C, lower.start]}
  E: {pin: [lower.end, upper.start]}
  B: {pin: [upper.end, ground.B]}
loads:
  wheel: {force: {at: leg.end, along: down, magnitude: W}}
  ram: {law: {measure: s, force: -F}}
measures: {theta: angle of leg, s: distance from ground.S to lower.center}
"""


def ram_and_strut() -> tuple[float, float, float]:
    """The force of the ram, the pull of the upper strut and the size of the reaction at A, by moments."""
    B, S, theta = (0.9, 0.05), (0.15, 0.35), math.radians(-70)

    def pose(x: float) -> tuple[Point, Point, Point]:
        C = 0.8 * math.cos(x), 0.8 * math.sin(x)
        E = meeting(C, 0.55, B, 0.5, -1)
        return C, E, ((C[0] + E[0]) / 2, (C[1] + E[1]) / 2)

    h = 1e-6
    slope = (math.dist(S, pose(theta + h)[2]) - math.dist(S, pose(theta - h)[2])) / (2 * h)
    F = -2000 * 1.4 * math.cos(theta) / slope
    C, E, G = pose(theta)
    s = math.dist(S, G)
    R = -F * (G[0] - S[0]) / s, -F * (G[1] - S[1]) / s
    u = (B[0] - E[0]) / 0.5, (B[1] - E[1]) / 0.5
    T = -((G[0] - C[0]) * R[1] - (G[1] - C[1]) * R[0]) / ((E[0] - C[0]) * u[1] - (E[1] - C[1]) * u[0])
    return F, T, math.hypot(R[0] + T * u[0], R[1] + T * u[1] - 2000)


@pytest.mark.parametrize(
    ("question", "k"),
    [
        ("value of F for which nothing moves", 0),
        ("tension of upper in equilibrium", 1),
        ("axial force of upper", 1),
        ("size of reaction of A in equilibrium", 2),
    ],
)
def test_a_landing_gear_is_held_by_its_ram_in_a_pose_that_loops_give(question: str, k: int) -> None:
    found = posed(GEAR, question)
    assert found.chain is not None
    assert found.value == pytest.approx(ram_and_strut()[k], rel=1e-6)
    assert "s_ram" in [to_text(step.name) for step in found.chain.named]  # and no root of all that it depends on


@pytest.mark.parametrize("question", ["value of F for which nothing moves", "size of reaction of A in equilibrium"])
def test_the_derivation_of_a_pose_says_by_which_principles_its_names_follow(question: str) -> None:
    system = System.from_text(GEAR)
    for language, word in (("en", "virtual power"), ("de", "virtuellen Leistungen")):
        assert word in str(system.explain(question, language=language))


def test_a_rod_that_the_load_alone_presses_is_checked_with_the_ram_that_holds_it() -> None:
    """Moments about the hinge of the body give the strut, whatever the ram does."""
    text = GEAR.replace("ground.S to lower.center", "ground.S to lower.end").replace("leg.end, along", "leg.C, along")
    found = posed(text, "tension of lower in equilibrium")
    B, theta = (0.9, 0.05), math.radians(-70)
    C = 0.8 * math.cos(theta), 0.8 * math.sin(theta)
    E = meeting(C, 0.55, B, 0.5, -1)
    arm = (C[0] * (E[1] - C[1]) - C[1] * (E[0] - C[0])) / 0.55
    assert found.value == pytest.approx(2000 * C[0] / arm, rel=1e-9)


BOOM = """
parameters: {a: m, b: m, L: m, W: N, v: m/s, s0: m}
ground: {points: {O: [0, 0], C: [a, 0]}}
bodies: {boom: {rod: {length: L}, points: {D: [b - L/2, 0]}, near: {angle: 40 deg}}}
connections:
  O: {pin: [ground.O, boom.start]}
  ram: {driver: {measure: s, follows: s0 + v*t}}
loads: {load: {force: {at: boom.end, along: down, magnitude: W}}}
measures: {theta: angle of boom, s: distance from ground.C to boom.D}
"""


def test_an_angle_that_a_ram_leads_to_is_looked_at_where_it_comes() -> None:
    """Of random lengths many have the ram too long for 60 degrees at the start."""
    found = posed(BOOM, "driving force of ram when theta = 60 deg")
    assert isinstance(found.expression, Expr)
    wanted = "W*L*sqrt(a**2 - a*b + b**2)/(a*b*sqrt(3))"
    assert_same_function(to_python(found.expression), wanted, dict.fromkeys(("a", "b", "L", "W"), 1.0))
    assert "√(a² - a·b + b²) > s₀ (θ = 60° is reached)" in found.conditions


COMPRESSOR = """
parameters: {r: 45 mm, l: 160 mm, e: 12 mm, m: 0.8 kg, w: 60 rad/s, F: 900 N}
ground: {points: {O: [0, 0], G: [0, e]}, lines: {bore: {along: right}}}
bodies:
  crank: {rod: {length: r}}
  rod: {rod: {length: l, mass: 0.6 kg}, near: {angle: -5 deg}}
  piston: {particle: {mass: m}, near: {at: [0.2 m, 12 mm]}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  bore: {slider: {body: piston, along: bore, through: ground.G}}
  motor: {driver: {measure: phi, follows: w*t}}
loads: {gas: {force: {at: piston, along: left, magnitude: F}}}
measures: {phi: angle of crank}
"""


def test_the_force_of_a_bearing_is_told_by_its_components_with_what_it_needs_alone() -> None:
    found = posed(COMPRESSOR, "size of reaction of O when phi = 50 deg")
    assert found.value == pytest.approx(764.437, rel=1e-5)  # Newton-Euler in numbers
    assert found.chain is not None
    assert [to_text(x) for x in found.chain.result] == ["√(F_x² + F_y²)"]
    assert not any("as at the start" in str(text) for text in found.conditions)
