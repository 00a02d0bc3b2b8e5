"""Steady motion, extremes over a turn, stability: against closed forms of the textbooks.

GPS: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002. NF: Neimark & Fufaev, Dynamics of Nonholonomic
Systems, 1972. What has no source is derived in its line.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.study.setup import Setup
from freebody.study.steady.turning import TurningAngle
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.routh import hurwitz, oscillating, without_implied
from freebody.symbolic.signed_field import SignedField
from posed import is_formula
from thinned import thinned

Agree = Callable[[fb.Solution, str, str | list[str]], None]
EXAMPLES = Path(__file__).parent.parent / "examples"

TOP = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 1 kg, A: 0.02 kg m^2, C: 0.01 kg m^2, l: 0.1 m}
bodies:
  top:
    body: {mass: m, inertia: [A, A, C]}
    points: {tip: [0, 0, -l]}
    turned: [psi about z, theta about x, phi about z]
connections: {tip: {spherical: [ground.O, top.tip]}}
loads: {weight: {gravity: g}}
start: {theta: 30 deg, rate(phi): 200 rad/s, rate(psi): 0, rate(theta): 0, psi: 0, phi: 0}
"""
# by angles that are regular where the axis is upright
SLEEPING = TOP.replace("psi about z, theta about x,", "a about x, b about y,").replace(
    "theta: 30 deg, rate(phi): 200 rad/s, rate(psi): 0, rate(theta): 0, psi: 0, phi: 0",
    "a: 0, b: 0, phi: 0, rate(phi): 200 rad/s",
)
COIN = """
space: true
parameters: {g: 9.81 m/s^2, m: 1 kg, R: 0.1 m}
ground: {planes: {floor: {normal: up}}}
bodies:
  coin:
    disk: {mass: m, radius: R, axis: z}
    turned: [psi about y, theta about x, phi about z]
connections: {floor: {rolling: [coin, floor]}}
loads: {weight: {gravity: g}}
start: {theta: 20 deg, rate(phi): 20 rad/s, rate(psi): 1 rad/s, rate(theta): 0, psi: 0, phi: 0}
"""
CONICAL = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 1 kg, l: 0.5 m}
bodies:
  bob:
    body: {mass: m, inertia: [0, 0, 0]}
    points: {top: [0, 0, l]}
    turned: [psi about z, theta about x]
connections: {top: {universal: {first: ground.O, second: bob.top, arm: z, second_arm: x}}}
loads: {weight: {gravity: g}}
start: {theta: 30 deg, rate(psi): 5 rad/s}
"""
HINGED_ROD = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 1 kg, L: 0.5 m}
bodies:
  shaft: {body: {inertia: 0.1 kg m^2}, points: {O: [0, 0, 0]}}
  rod: {body: {mass: m, inertia: [m*L^2/12, m*L^2/12, 0]}, points: {top: [0, 0, L/2]}}
connections:
  bearing: {revolute: {first: ground.O, second: shaft, about: z}}
  hinge: {revolute: {first: shaft.O, second: rod.top, about: x}}
loads: {weight: {gravity: g}}
measures: {psi: angle of shaft about z, beta: angle of rod about shaft.x relative to shaft}
start: {beta: 30 deg, rate(psi): 8 rad/s}
"""
HOOP = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 1 kg, R: 0.5 m, Omega: 8 rad/s, d: 0.1 N m s}
bodies:
  hoop: {body: {inertia: 0.1 kg m^2}, points: {O: [0, 0, 0]}}
  bead: {body: {mass: m, inertia: [0, 0, 0]}, points: {c: [0, 0, R]}}
connections:
  bearing: {revolute: {first: ground.O, second: hoop, about: z}}
  hinge: {revolute: {first: hoop.O, second: bead.c, about: x}}
  motor: {driver: {measure: psi, follows: Omega*t}}
loads:
  weight: {gravity: g}
  friction: {torque: {on: bead, reacts_on: hoop, about: hoop.x, magnitude: -d*rate(theta)}}
measures: {psi: angle of hoop about z, theta: angle of bead about hoop.x relative to hoop}
start: {theta: 0}
"""
SLIDER_CRANK = """
parameters: {r: 0.1 m, l: 0.3 m}
ground: {points: {O: [0, 0], P: [0.3 m, 0.4 m]}, lines: {cylinder: {along: right}}}
bodies:
  crank:  {rod: {mass: 1 kg, length: r}}
  rod:    {rod: {mass: 1 kg, length: l}}
  piston: {particle: {mass: 1 kg}}
connections:
  main: {pin: [ground.O, crank.start]}
  crankpin: {pin: [crank.end, rod.start]}
  wristpin: {pin: [rod.end, piston]}
  cylinder: {slider: {body: piston, along: cylinder}}
measures: {theta: angle of crank}
start: {theta: 60 deg}
"""
BOX = """
space: true
parameters: {I_x: 1 kg m^2, I_y: 2 kg m^2, I_z: 2.5 kg m^2}
bodies: {box: {body: {mass: 1 kg, inertia: [I_x, I_y, I_z]}}}
"""


def ask(model: str, question: str) -> fb.Solution:
    return fb.System.from_text(model).solve(question)


def the(solution: fb.Solution) -> fb.Answer:
    return solution.answers[0]


# -- steady motion ----------------------------------------------------------------------------
def test_top_precesses_slowly_or_fast(agrees: Agree) -> None:
    # GPS (5.74'): (A' - C) psi'^2 cos(theta) - C phi' psi' + m g l = 0 with A' = A + m l^2 about the tip
    root = "sqrt(C**2*rate(phi)**2 - 4*(A + m*l**2 - C)*cos(theta)*m*g*l)"
    below = "(2*(A + m*l**2 - C)*cos(theta))"
    solution = ask(TOP, "rate of psi in steady motion")
    slow, fast = f"(C*rate(phi) - {root})/{below}", f"(C*rate(phi) + {root})/{below}"
    agrees(solution, the(solution).id, [slow, fast])
    assert any("under the root" in c for c in the(solution).conditions)
    value = the(solution).value
    assert isinstance(value, tuple)
    assert value[0] == pytest.approx(0.4926, rel=1e-3)  # about m g l/(C phi') = 0.4905 for a fast top


def test_spin_of_a_top_follows_from_its_precession(agrees: Agree) -> None:
    solution = ask(TOP, "rate of phi in steady motion")
    agrees(solution, the(solution).id, "((A + m*l**2 - C)*rate(psi)**2*cos(theta) + m*g*l)/(C*rate(psi))")
    assert "every rate is steady where 0 = sin(θ)" in the(solution).notes
    assert the(solution).value is None  # it does not precess at the start


def test_tip_of_a_top_carries_its_weight_in_steady_precession(agrees: Agree) -> None:
    solution = ask(TOP, "size of reaction of tip in steady motion")
    agrees(solution, the(solution).id, "m*sqrt(g**2 + l**2*rate(psi)**4*sin(theta)**2)")
    assert any(c.startswith("steady while 0 = ") for c in the(solution).conditions)
    assert the(solution).value is None  # the start of the model is not steady


def test_nodding_has_no_rate_in_steady_motion(agrees: Agree) -> None:
    solution = ask(TOP, "rate of theta in steady motion")
    agrees(solution, the(solution).id, "0")


def test_coin_rolls_in_a_circle(agrees: Agree) -> None:
    # moments about the contact point, I = m R^2/4 across and m R^2/2 about the axis, theta the lean:
    # 6 R phi' psi' cos = 5 R psi'^2 sin cos + 4 g sin
    solution = ask(COIN, "rate of phi in steady motion")
    expected = "(5*R*rate(psi)**2*sin(theta)*cos(theta) + 4*g*sin(theta))/(6*R*rate(psi)*cos(theta))"
    agrees(solution, the(solution).id, expected)
    both = the(ask(COIN, "rate of psi in steady motion"))
    assert isinstance(both.value, tuple)
    for psi in both.value:  # phi' = 20 at theta = 20 deg
        s, c = np.sin(np.radians(20)), np.cos(np.radians(20))
        assert 6 * 0.1 * 20 * psi * c == pytest.approx(5 * 0.1 * psi**2 * s * c + 4 * 9.81 * s)


def test_what_is_given_is_no_condition_of_the_answer() -> None:
    # at 30 deg: 27 R^2 phi'^2 >= 10 sqrt(3) g R for a real root, and nothing is left to be said of theta
    answer = the(ask(COIN, "rate of psi in steady motion when theta = 30 deg"))
    assert not any("cos(θ)" in c for c in answer.conditions)
    assert any("27·R·φ'² ≥ 10·g·√(3)" in c for c in answer.conditions)


def test_floor_carries_the_weight_of_a_coin_in_steady_motion(agrees: Agree) -> None:
    solution = ask(COIN, "normal force of floor in steady motion")
    agrees(solution, the(solution).id, "m*g")


def test_conical_pendulum(agrees: Agree) -> None:
    solution = ask(CONICAL, "rate of psi in steady motion")
    agrees(solution, the(solution).id, "sqrt(g/(l*cos(theta)))")
    solution = ask(CONICAL, "position of theta in steady motion")
    agrees(solution, the(solution).id, "acos(g/(l*rate(psi)**2))")
    assert any("l·ψ'² ≥ g" in c for c in the(solution).conditions)


def test_rod_on_a_turning_hinge_stands_off(agrees: Agree) -> None:
    # m L^2/3 psi'^2 sin cos = m g L/2 sin
    solution = ask(HINGED_ROD, "rate of psi in steady motion")
    agrees(solution, the(solution).id, "sqrt(3*g/(2*L*cos(beta)))")


def test_rate_at_the_start_comes_with_the_pose_of_the_start(agrees: Agree) -> None:
    solution = ask(HINGED_ROD, "rate of psi in steady motion at start")
    agrees(solution, the(solution).id, "sqrt(3*g/(2*L*cos(pi/6)))")


def test_bead_on_a_driven_hoop_has_no_free_rate(agrees: Agree) -> None:
    solution = ask(HOOP, "theta in steady motion")
    agrees(solution, the(solution).id, ["0", "pi", "acos(g/(R*Omega**2))"])
    solution = ask(HOOP, "rate of psi in steady motion")
    agrees(solution, the(solution).id, "Omega")


def test_a_rate_that_is_left_open_is_refused() -> None:
    two = TOP.replace("  top:\n", "  spare: {body: {inertia: 1 kg m^2}}\n  top:\n", 1).replace(
        "connections: {tip", "connections: {bearing: {revolute: {first: ground.O, second: spare, about: z}}, tip"
    )
    two = two.replace("start: {", "measures: {chi: angle of spare about z}\nstart: {chi: 0, ")
    assert "leaves χ' open" in the(ask(two, "rate of chi in steady motion")).reason


def test_steady_motion_has_no_event() -> None:
    assert "no event" in the(ask(TOP, "rate of psi in steady motion at t = 2 s")).reason
    assert "no event" in the(ask(TOP, "stability of steady motion at t = 2 s")).reason
    assert "no steady motion" in the(ask(TOP, "stability of steady motion when theta = 20 deg")).reason


def test_what_a_steady_motion_keeps_may_be_given(agrees: Agree) -> None:
    # vertical: T cos(beta) = m g; radial: T sin(beta) = m l sin(beta) psi'^2
    given = CONICAL.replace("l: 0.5 m}", "l: 0.5 m, beta: 40 deg, w: 6 rad/s}")
    for question, formula in (
        ("rate of psi in steady motion when theta = beta", "sqrt(g/(l*cos(beta)))"),
        ("size of reaction of top in steady motion when theta = beta", "m*g/cos(beta)"),
        ("speed of bob in steady motion when theta = beta", "sqrt(g*l/cos(beta))*sin(beta)"),
        ("value of l for which rate of psi = w in steady motion when theta = beta", "g/(w**2*cos(beta))"),
    ):
        solution = ask(given, question)
        agrees(solution, the(solution).id, formula)
        assert not any("pose of the motion" in c for c in the(solution).conditions)
    solution = ask(given, "theta in steady motion when rate(psi) = w")
    agrees(solution, the(solution).id, ["0", "pi", "acos(g/(l*w**2))"])
    solution = ask(given, "speed of bob in steady motion when rate(psi) = w")
    agrees(solution, the(solution).id, ["0", "0", "sqrt(l**2*w**4 - g**2)/w"])


def test_a_top_with_a_given_angle_keeps_its_other_rate_open(agrees: Agree) -> None:
    # with theta = 90 deg: C phi' psi' = m g l
    solution = ask(TOP, "rate of psi in steady motion when theta = 90 deg")
    agrees(solution, the(solution).id, "m*g*l/(C*rate(phi))")


def test_a_rate_for_which_a_bead_stands_at_an_angle(agrees: Agree) -> None:
    for question in ("theta = 30 deg in steady motion", "theta in steady motion = 30 deg"):
        solution = ask(HOOP, f"value of Omega for which {question}")
        agrees(solution, the(solution).id, "sqrt(2*g/(sqrt(3)*R))")


def test_what_a_steady_motion_does_not_keep_is_refused() -> None:
    reason = the(ask(CONICAL, "rate of psi in steady motion when rate(theta) = 1 rad/s")).reason
    assert "keeps theta, rate(psi)" in reason


def test_given_angles_are_derived() -> None:
    system = fb.System.from_text(
        CONICAL.replace("l: 0.5 m}", "l: 0.5 m, beta: 40 deg, w: 6 rad/s}")
        + """questions:
- {find: size of reaction of top in steady motion when theta = beta}
- {find: value of l for which rate of psi = w in steady motion when theta = beta}
"""
    )
    assert [d.reason for d in system.explain().derivations] == ["", ""]
    system = fb.System.from_text(HOOP + "questions: [{find: value of Omega for which theta = 30 deg in steady motion}]")
    assert system.explain().derivations[0].reason == ""


def test_a_conical_pendulum_has_its_angles_below_the_horizontal(agrees: Agree) -> None:
    # S cos(beta) = m g with S > 0: whatever holds for all angles does so up to 90 deg only; S > F from acos(m g/F) on
    given = CONICAL.replace("l: 0.5 m}", "l: 0.5 m, beta: 40 deg, F: 12 N}")
    steady = "of top in steady motion when theta = beta"
    assert "every acute angle beta" in the(ask(given, f"range of beta for which size of reaction {steady} > 0")).reason
    solution = ask(given, f"range of beta for which size of reaction {steady} > F")
    agrees(solution, the(solution).id, "acos(m*g/F)")
    assert "this holds for β > acos(g·m/F) and β < π/2" in the(solution).notes
    assert "F > g·m (beta is positive)" in the(solution).conditions


def test_speeds_at_which_a_bead_stands_above_an_angle(agrees: Agree) -> None:
    # cos(theta) = g/(R Omega^2) < cos(30 deg); at the bottom and at the top it may stay at any speed
    solution = ask(HOOP, "range of Omega for which theta in steady motion > 30 deg")
    agrees(solution, the(solution).id, "sqrt(2*g/(sqrt(3)*R))")
    assert "the value 0 does not depend on Omega and is left aside" in the(solution).notes


@pytest.mark.slow
def test_a_range_asks_for_no_number_with_which_there_is_the_motion(agrees: Agree) -> None:
    # at w = 3 rad/s the pendulum hangs down: g/(l w^2) > 1
    given = CONICAL.replace("l: 0.5 m}", "l: 0.5 m, beta: 40 deg, w: 3 rad/s}")
    solution = ask(given, "range of l for which theta in steady motion when rate(psi) = w > beta")
    agrees(solution, the(solution).id, "g/(w**2*cos(beta))")


def test_what_one_of_several_values_needs_is_no_condition_of_the_others(agrees: Agree) -> None:
    given = CONICAL.replace("l: 0.5 m}", "l: 0.5 m, w: 6 rad/s}")
    solution = ask(given, "speed of bob in steady motion when rate(psi) = w")
    assert [c for c in the(solution).conditions if "for [3]" in c] == ["l·w² ≥ g (for [3])"]


GOVERNOR = """
space: {up: z}
parameters: {g: 9.81 m/s^2, m: 1 kg, l: 0.5 m, a: 0.1 m, Omega: 8 rad/s}
bodies:
  hub: {body: {inertia: 0.1 kg m^2}, points: {O: [0, 0, 0], A: [0, a, 0]}}
  bob: {body: {mass: m, inertia: [0, 0, 0]}, points: {top: [0, 0, l]}}
connections:
  bearing: {revolute: {first: ground.O, second: hub, about: z}}
  hinge: {revolute: {first: hub.A, second: bob.top, about: x}}
  motor: {driver: {measure: psi, follows: Omega*t}}
loads: {weight: {gravity: g}}
measures: {psi: angle of hub about z, theta: angle of bob about hub.x relative to hub}
start: {theta: 0}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        # S cos(theta) = m g, S sin(theta) = m Omega^2 (a + l sin(theta)): theta itself has no closed form
        ("value of Omega for which theta = 45 deg in steady motion", "sqrt(g/(a + l/sqrt(2)))"),
        ("value of Omega for which theta = 30 deg in steady motion", "sqrt(g/(sqrt(3)*(a + l/2)))"),
        # inwards, and beyond the axis
        ("value of Omega for which theta = -45 deg in steady motion", "sqrt(g/(l/sqrt(2) - a))"),
        ("value of l for which theta = 45 deg in steady motion", "sqrt(2)*(g/Omega**2 - a)"),
        ("value of a for which theta = 45 deg in steady motion", "g/Omega**2 - l/sqrt(2)"),
    ],
)
def test_an_arm_hinged_off_the_axis_stands_at_an_angle(agrees: Agree, question: str, formula: str) -> None:
    solution = ask(GOVERNOR, question)
    agrees(solution, the(solution).id, formula)


def test_an_arm_that_turns_freely_is_asked_with_its_rate(agrees: Agree) -> None:
    free = GOVERNOR.replace("  motor: {driver: {measure: psi, follows: Omega*t}}\n", "")
    free = free.replace("start: {theta: 0}", "start: {theta: 30 deg, rate(psi): Omega}")
    solution = ask(free, "value of Omega for which theta = 45 deg in steady motion when rate(psi) = Omega")
    agrees(solution, the(solution).id, "sqrt(g/(a + l/sqrt(2)))")


def test_a_parameter_of_the_start_is_none_of_all_steady_motions() -> None:
    # real for (C phi')^2 >= 4 (A + m l^2 - C) cos(theta) m g l only: phi' is a rate here, s what the file starts with
    text = TOP.replace("l: 0.1 m}", "l: 0.1 m, s: 200 rad/s}").replace("rate(phi): 200 rad/s", "rate(phi): s")
    reason = the(ask(text, "range of s for which rate of psi in steady motion when theta = 60 deg > 0")).reason
    assert reason == "that does not depend on s"


def test_options_are_judged_on_both_roots() -> None:
    system = fb.System.from_text(
        CONICAL
        + "questions: [{find: rate of psi in steady motion, options: {a: sqrt(g/(l*cos(theta))), b: sqrt(g/l)}}]"
    )
    assert the(system.solve()).choice == "a"


# -- extremes over a turn ---------------------------------------------------------------------
RATIO = "ratio of angular velocity of driven along bent.z to rate of psi"


@pytest.mark.parametrize("over", thinned(["", " over a turn of psi"], bool))
def test_cardan_joint_runs_unevenly_between_cos_alpha_and_its_inverse(agrees: Agree, over: str) -> None:
    solution = fb.System.load(EXAMPLES / "cardan_joint.yaml").solve(f"extremes of {RATIO}{over}")
    agrees(solution, the(solution).id, ["cos(alpha)", "1/cos(alpha)"])
    assert the(solution).notes == ("least at ψ = 0 and ψ = 180°", "largest at ψ = 90° and ψ = -90°")
    assert the(solution).unit == "1"


PISTON = "extremes of position of piston along right over a turn of theta"


def test_piston_goes_from_one_dead_centre_to_the_other(agrees: Agree) -> None:
    solution = ask(SLIDER_CRANK, PISTON)
    agrees(solution, the(solution).id, ["l - r", "l + r"])
    assert "l > r (a full turn is possible)" in the(solution).conditions


def test_connecting_rod_swings_by_the_arc_sine_of_its_ratio(agrees: Agree) -> None:
    solution = ask(SLIDER_CRANK, "extremes of angle of rod")
    agrees(solution, the(solution).id, ["-asin(r/l)", "asin(r/l)"])
    assert "l > r (a full turn is possible)" in the(solution).conditions


def test_distance_from_a_circle_to_a_point_outside(agrees: Agree) -> None:
    solution = ask(SLIDER_CRANK, "extremes of distance from crank.end to ground.P")
    agrees(solution, the(solution).id, ["1/2 - r", "1/2 + r"])


def test_a_tangent_grows_without_bound() -> None:
    question = "extremes of ratio of position of crank.end along up to position of crank.end along right"
    answer = the(ask(SLIDER_CRANK, question))
    assert answer.expression is None
    assert answer.reason.startswith("it grows without bound, or a change point is passed: cos(θ)")


def test_what_has_no_closed_form_is_refused_with_the_equation() -> None:
    answer = the(ask(SLIDER_CRANK, "extremes of velocity of piston along right"))
    assert answer.expression is None
    assert "has no closed form" in answer.reason


def test_a_crank_that_is_too_long_makes_no_full_turn() -> None:
    answer = the(
        ask(SLIDER_CRANK.replace("r: 0.1 m, l: 0.3 m", "r: 0.4 m, l: 0.3 m").replace("60 deg", "20 deg"), PISTON)
    )
    assert answer.reason.startswith("there is no full turn")


def test_what_does_not_move_has_no_extremes() -> None:
    answer = the(ask(SLIDER_CRANK, "extremes of position of piston along up"))
    assert answer.reason == "the quantity is the same in every pose"


@pytest.fixture(scope="module")
def turning() -> TurningAngle:
    model = Setup(fb.System.from_text(SLIDER_CRANK)).model
    return TurningAngle(model, model.coordinates[0])


def test_factors_without_zeros_are_proved_to_have_none(turning: TurningAngle) -> None:
    f = turning.field
    c, s = f.variable(turning.cos), f.variable(turning.sin)
    assert turning.zeros(c**3 + s + 3) == []
    assert turning.notes[-1].startswith("sin(θ) + cos(θ)³ + 3 does not vanish")


def test_factors_with_zeros_that_have_no_form_are_not_passed_over(turning: TurningAngle) -> None:
    f = turning.field
    c, s = f.variable(turning.cos), f.variable(turning.sin)
    with pytest.raises(fb.CannotAnswer, match="no closed form"):
        turning.zeros(3 * c**3 + s + 1)


def test_zeros_of_a_wave(turning: TurningAngle) -> None:
    """3 c + 4 s = 5/2 where the angle is 60 degrees from that with cosine 3/5."""
    f = turning.field
    c, s = f.variable(turning.cos), f.variable(turning.sin)
    found = turning.zeros(6 * c + 8 * s - 5)
    angles = sorted(
        np.degrees(np.arctan2(*(turning.model.samples.at_starts(x)[0] for x in (p.sin, p.cos)))) for p in found
    )
    middle = np.degrees(np.arctan2(4, 3))
    assert angles == pytest.approx([middle - 60, middle + 60])


# -- stability --------------------------------------------------------------------------------
@pytest.mark.parametrize(("axis", "i", "j", "k"), [("x", "y", "z", "x"), ("y", "z", "x", "y"), ("z", "x", "y", "z")])
def test_free_body_wobbles_by_its_moments(agrees: Agree, axis: str, i: str, j: str, k: str) -> None:
    # GPS sec. 5.6
    solution = ask(BOX, f"stability of the spin of box about {axis}")
    agrees(solution, the(solution).id, f"-Omega**2*(I_{k} - I_{i})*(I_{k} - I_{j})/(I_{i}*I_{j})")
    assert the(solution).conditions[0].startswith("stable if ")


def test_spin_about_the_middle_axis_is_unstable() -> None:
    numbers = BOX.replace("[I_x, I_y, I_z]", "[1 kg m^2, 2 kg m^2, 2.5 kg m^2]")
    said = [the(ask(numbers, f"stability of the spin of box about {axis}")).conditions[0] for axis in "xyz"]
    assert said == [
        "stable for all admissible values",
        "unstable for all admissible values",
        "stable for all admissible values",
    ]


def test_spin_of_a_sphere_is_neutral() -> None:
    answer = the(
        ask(
            "space: true\nbodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}}}",
            "stability of the spin of ball about x",
        )
    )
    assert answer.conditions[0].startswith("neutral")


def test_spin_under_a_moment_is_no_free_spin() -> None:
    assert "tip turns top about its mass centre" in the(ask(TOP, "stability of the spin of top about z")).reason


def test_sleeping_top_is_stable_when_it_is_fast_enough() -> None:
    # GPS (5.80): (C omega)^2 > 4 A' m g l, A' about the tip
    answer = the(ask(SLEEPING, "stability of steady motion"))
    assert answer.conditions == ("stable if C²·φ'² > 4·g·m·l·(m·l² + A)",)
    assert answer.verdict == "stable with the given numbers"
    slow = the(ask(SLEEPING.replace("200 rad/s", "20 rad/s"), "stability of steady motion"))
    assert slow.verdict == "not stable with the given numbers"


def test_symbols_of_the_start_stand_in_the_condition() -> None:
    model = SLEEPING.replace("200 rad/s", "omega").replace("l: 0.1 m}", "l: 0.1 m, omega: 200 rad/s}")
    (condition,) = the(ask(model, "stability of steady motion")).conditions
    assert condition == "stable if C²·ω² > 4·g·m²·l³ + 4·g·m·A·l"


@pytest.mark.parametrize(
    ("rates", "expected", "condition"),
    [
        # NF ch. VI: an upright disk rolls stably if (R phi')^2 > g R/3
        ("rate(phi): 20 rad/s, rate(psi): 0", "4*(g - 3*R*rate(phi)**2)/(5*R)", "stable if 3·R·φ'² > g"),
        # spinning about its diameter: psi'^2 > 4 g/(5 R)
        ("rate(phi): 0, rate(psi): 20 rad/s", "(4*g - 5*R*rate(psi)**2)/(5*R)", "stable if 5·R·ψ'² > 4·g"),
    ],
)
def test_upright_coin_is_stable_when_it_is_fast_enough(
    agrees: Agree, rates: str, expected: str, condition: str
) -> None:
    upright = COIN.replace("theta: 20 deg, rate(phi): 20 rad/s, rate(psi): 1 rad/s", f"theta: 0, {rates}")
    solution = ask(upright, "stability of steady motion")
    agrees(solution, the(solution).id, expected)
    assert the(solution).conditions == (condition,)


def test_conical_pendulum_oscillates_about_its_circle(agrees: Agree) -> None:
    # lambda^2 = -psi'^2 (1 + 3 cos(theta)^2) with psi'^2 = g/(l cos(theta))
    solution = ask(CONICAL, "stability of steady motion")
    agrees(solution, the(solution).id, "-(1 + 3*cos(theta)**2)*g/(l*cos(theta))")
    assert the(solution).conditions == ("stable if cos(θ) > 0",)


def test_precession_of_a_top_is_stable(agrees: Agree) -> None:
    """Nutation about a regular precession, with the spin of GPS (5.74')."""
    solution = ask(TOP.replace("rate(psi): 0", "rate(psi): 3 rad/s"), "stability of steady motion")
    B, w = "(A + m*l**2)", "rate(psi)"
    expected = f"-({B}**2*{w}**4 - 2*{B}*m*g*l*cos(theta)*{w}**2 + (m*g*l)**2)/({B}*{w})**2"
    agrees(solution, the(solution).id, expected)


def test_a_body_that_turns_over_is_not_in_steady_motion() -> None:
    model = BOX.rstrip()[:-2] + ", angular_velocity: {body: [0.01 rad/s, 6 rad/s, 0]}}}\n"
    assert "stability of the spin" in the(ask(model, "stability of steady motion")).reason


def test_damped_bead_rests_at_the_bottom_of_a_slow_hoop() -> None:
    answer = the(ask(HOOP, "stability of steady motion"))
    assert answer.conditions == ("stable if g > R·Ω²",)
    assert answer.verdict == "not stable with the given numbers"


def test_a_start_that_is_not_steady_is_refused() -> None:
    falling = TOP.replace("rate(phi): 200 rad/s", "rate(phi): 0")
    assert "no steady motion" in the(ask(falling, "stability of steady motion")).reason


# -- polynomials ------------------------------------------------------------------------------
def _coefficients(field: Field, roots: list[complex]) -> list[Ratio]:
    numbers = np.real(np.poly(np.array(roots)))[::-1]
    return [field.element(round(x * 1000)) / 1000 for x in numbers]


@pytest.mark.parametrize("seed", range(12))
def test_routh_and_the_roots_agree(seed: int) -> None:
    rng, field = random.Random(seed), SignedField()
    roots: list[complex] = [rng.uniform(-2, 0.7)]
    for _ in range(rng.randint(1, 2)):
        z = complex(rng.uniform(-2, 0.7), rng.uniform(0.1, 2))
        roots += [z, z.conjugate()]
    c = _coefficients(field, roots)
    found = np.roots([float(x.fraction() or 0) for x in reversed(c)])
    column = hurwitz(c)
    assert len(column) == len(c) - 1
    assert all((x.fraction() or 0) > 0 for x in column) == bool(np.all(found.real < 0)), f"seed {seed}"


@pytest.mark.parametrize(
    ("roots", "is_stable"),
    [((-1, -2, -5), True), ((-1, 2, -5), False), ((-1, -1 + 2j, -1 - 2j), False), ((-3, -1), True)],
)
def test_squares_are_real_and_negative(roots: tuple[complex, ...], is_stable: bool) -> None:
    signs = oscillating(_coefficients(SignedField(), list(roots)))
    assert all((x.fraction() or 0) > 0 for x in signs) == is_stable


def test_the_weaker_of_two_conditions_is_left_out() -> None:
    f = SignedField()
    w, k = f.parameter("w"), f.parameter("k", positive=True)
    assert without_implied([w * w - 2 * k, w * w - 4 * k]) == [w * w - 4 * k]


ON_A_TURNING_ROD = """
parameters: {m: 1 kg, k: 100 N/m, w: {w} rad/s, r0: 0.2 m}
bodies: {rod: {rod: {length: 2 m}}, collar: {particle: {mass: m}, near: {at: [r0, 0]}}}
connections:
  axle: {pin: [ground.O, rod.center]}
  slot: {slot: {pin: collar, along: rod.x, on: rod}}
  motor: {driver: {measure: angle of rod, follows: w*t}}
loads: {s: {spring: {first: ground.O, second: collar, stiffness: k, length: 0}}}
measures: {r: {travel of collar along rod.x from rod.center}}
start: {r: r0, rate(r): 0}
questions: [natural frequency, velocity of r when r = {r}, time when r = {r}]
"""


def test_a_collar_on_a_turning_rod_swings_by_the_stiffness_that_turning_leaves(agrees: Agree) -> None:
    """m r'' = (m w^2 - k) r: r = r0 cos(sqrt(k/m - w^2) t), the numeric linearisation taken with the rod turning."""
    solution = fb.System.from_text(ON_A_TURNING_ROD.replace("{w}", "5").replace("{r}", "0")).solve()
    agrees(solution, "q1", "sqrt(k/m - w**2)")
    agrees(solution, "q2", "-r0*sqrt(k/m - w**2)")
    agrees(solution, "q3", "pi/(2*sqrt(k/m - w**2))")
    for answer in solution.answers:
        assert any(c.startswith("k > m·w²") for c in answer.conditions)


def test_a_collar_on_a_fast_rod_runs_away(agrees: Agree) -> None:
    """r = r0 cosh(sqrt(w^2 - k/m) t)."""
    solution = fb.System.from_text(ON_A_TURNING_ROD.replace("{w}", "12").replace("{r}", "1 m")).solve()
    assert solution["q1"].reason == "it does not oscillate at the model's own values: that needs k > m·w²"
    agrees(solution, "q2", "sqrt((w**2 - k/m)*(1 - r0**2))")
    agrees(solution, "q3", "log((1 + sqrt(1 - r0**2))/r0)/sqrt(w**2 - k/m)")


def test_small_motions_on_a_turning_table_are_gyroscopic() -> None:
    """x'' - 2 w y' + (k/m - w^2) x = 0 and the same for y: sqrt(k/m) -+ w, which M and K alone do not give."""
    system = fb.System.from_text("""
parameters: {m: 1 kg, k: 100 N/m, w: 5 rad/s}
bodies: {table: {disk: {radius: 1 m}}, a: {particle: {mass: m}, near: {at: [0.1 m, 0]}}}
connections:
  axle: {pin: [ground.O, table.center]}
  motor: {driver: {measure: angle of table, follows: w*t}}
loads: {s: {spring: {first: table.center, second: a, stiffness: k, length: 0}}}
measures:
  x: {travel of a along table.x from table.center}
  y: {travel of a along table.y from table.center}
start: {x: 0, y: 0, rate(x): 0, rate(y): 0}
questions: [natural frequencies]
""")
    answer = system.solve()["q1"]
    assert answer.expression is None
    assert answer.value is None
    assert "gyroscopic" in answer.reason
    assert [mode.frequency for mode in system.modes("start")] == pytest.approx([5.0, 15.0])


DRIVEN = """
parameters: {r: 0.1 m, l: 0.4 m, w: 20 rad/s}
ground: {lines: {cylinder: {along: right}}}
bodies: {crank: {rod: {length: r}}, rod: {rod: {length: l}}, piston: {particle: {mass: 2 kg}}}
connections:
  main: {pin: [ground.O, crank.start]}
  crankpin: {pin: [crank.end, rod.start]}
  wristpin: {pin: [rod.end, piston]}
  cylinder: {slider: {body: piston, along: cylinder}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: {angle of crank}, phi: {angle of rod clockwise}, x: {x of piston}}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [  # sin(phi) = r sin(theta)/l, x = r cos(theta) + l cos(phi)
        ("stroke of x over a turn of theta", "2*r"),
        pytest.param("stroke of x", "2*r", marks=pytest.mark.slow),
        ("extremes of phi over a turn of theta", ["-asin(r/l)", "asin(r/l)"]),
        ("time ratio of x over a turn of theta", "1"),
    ],
)
def test_poses_of_a_turn_do_not_ask_how_it_is_driven(agrees: Agree, question: str, formula: str | list[str]) -> None:
    solution = ask(DRIVEN, question)
    agrees(solution, the(solution).id, formula)
    assert any("l > r" in c for c in the(solution).conditions)


def test_the_stroke_of_a_driven_crank_is_derived() -> None:
    system = fb.System.from_text(DRIVEN + "questions: [{find: stroke of x over a turn of theta}]")
    assert system.explain().derivations[0].reason == ""


def test_a_drive_that_swings_makes_no_turn() -> None:
    swinging = DRIVEN.replace("follows: w*t", "follows: sin(w*t)")
    assert "varies with time" in the(ask(swinging, "stroke of x")).reason


YOKE = """
parameters: {r: 0.06 m, w: 25 rad/s}
bodies: {crank: {rod: {length: r}}, yoke: {body: {mass: 2.5 kg}}}
connections:
  O: {pin: [ground.O, crank.start]}
  guide: {slider: {body: yoke, along: right}}
  slot: {slot: {pin: crank.end, along: yoke.y, on: yoke}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: {angle of crank}, x: x of yoke}
start: {theta: 0}
"""


@pytest.mark.parametrize(
    ("question", "formula"),
    [  # x = r cos(theta)
        ("extremes of velocity of x over a turn of theta", ["-r*w", "r*w"]),
        ("extremes of acceleration of x over a turn of theta", ["-r*w**2", "r*w**2"]),
        ("stroke of velocity of x over a turn of theta", "2*r*w"),
    ],
)
def test_rates_over_a_turn_are_those_of_its_drive(agrees: Agree, question: str, formula: str | list[str]) -> None:
    solution = ask(YOKE, question)
    agrees(solution, the(solution).id, formula)


def test_extremes_without_a_formula_have_numbers() -> None:
    # at the dead points -r w^2 (1 + r/l) and r w^2 (1 - r/l), which are the extremes for l > 3.6 r or so
    answer = the(ask(DRIVEN, "extremes of acceleration of x over a turn of theta"))
    assert answer.expression is None
    assert answer.value == pytest.approx((-50.0, 30.0), rel=1e-9)
    # the largest speed by its own condition: dx/dtheta = -r sin - r^2 sin cos/(l cos phi) is least
    speeds = [
        0.1 * math.sin(a) + 0.01 * math.sin(a) * math.cos(a) / math.sqrt(0.16 - 0.01 * math.sin(a) ** 2)
        for a in (k * math.pi / 200_000 for k in range(200_000))
    ]
    answer = the(ask(DRIVEN, "extremes of velocity of x over a turn of theta"))
    assert answer.value == pytest.approx((-20 * max(speeds), 20 * max(speeds)), rel=1e-8)


def test_extremes_of_what_never_moves_are_refused_in_words() -> None:
    text = """
parameters: {m: 1 kg}
bodies: {p: {particle: {mass: m}}}
connections: {c: {pin: [ground.A, p]}}
ground: {points: {A: [0, 0]}}
"""
    [answer] = fb.solve(fb.System.from_text(text), question="extremes of reaction of c on p").answers
    assert str(answer.to_plain()["reason"]) == "the quantity is the same in every pose"


CAROUSEL = """
space: {up: z}
parameters: {m: 70 kg, a: 4 m, l: 5 m, W: 1.1 rad/s, J: 2000 kg m^2, th: 35 deg, g: 9.81 m/s^2}
bodies:
  disc: {body: {inertia: [J, J, J]}, points: {H: [a, 0, 0]}}
  chain: {body: {}, at: [a, 0, 0], points: {seat: [0, 0, -l]}}
  rider: {particle: {mass: m}}
connections:
  axle: {revolute: {first: ground.O, second: disc, about: z}}
  motor: {driver: {measure: psi, follows: W*t}}
  hinge: {revolute: {first: disc.H, second: chain, about: y}}
  seat: {spherical: [chain.seat, rider]}
loads: {weight: {gravity: g}}
measures: {psi: angle of disc about z, theta: angle of chain about -disc.y relative to disc}
start: {theta: 30 deg}
"""


def test_a_place_that_a_drive_does_not_make_steady_is_told_with_what_it_takes() -> None:
    """Beside a drive with the rate W the angle is no free choice: W^2 (a + l sin th) = g tan th."""
    answer = the(ask(CAROUSEL, "size of reaction of seat in steady motion when theta = th"))
    assert "the given place is steady only where 0 = a·W²·cos(th) + l·W²·cos(th)·sin(th) - g·sin(th)" in answer.reason


HINGED_TO_A_SHAFT = """
space: {up: y}
parameters: {m: 2 kg, L: 0.5 m, W: 8 rad/s, g: 9.81 m/s^2}
bodies:
  shaft: {body: {}}
  rod: {rod: {mass: m, length: L}}
connections:
  axis: {revolute: {first: ground.O, second: shaft, about: y}}
  hinge: {revolute: {first: shaft.origin, second: rod.start, about: z}}
  motor: {driver: {measure: psi, follows: W*t}}
loads: {weight: {gravity: g}}
measures: {psi: angle of shaft about y, th: angle of rod about z relative to shaft}
"""


def test_all_places_are_told_where_one_of_them_has_no_opposite_value() -> None:
    """0 = cos(th) (2 L W^2 sin(th) + 3 g): of the upright ones the opposite is steady, too."""
    answer = the(ask(HINGED_TO_A_SHAFT, "th in steady motion"))
    inclined = math.asin(3 * 9.81 / (2 * 0.5 * 64))
    assert sorted(answer.value) == pytest.approx([-math.pi / 2, -inclined, math.pi / 2, math.pi + inclined])


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("frequency of small oscillations about steady motion", "sqrt(W**2 - 9*g**2/(4*L**2*W**2))"),
        ("range of W for which the steady motion is stable", "sqrt(3*g/(2*L))"),
        # the weight, and m W^2 L/2 cos(th) of the mass centre
        ("size of reaction of hinge in steady motion", "m*sqrt(g**2 + (L*W**2/2)**2 - (3*g/4)**2)"),
    ],
)
def test_what_a_drive_turns_swings_out_to_its_steady_place(question: str, formula: str) -> None:
    is_formula(HINGED_TO_A_SHAFT, question, formula)
