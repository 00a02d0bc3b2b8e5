"""Equilibria, small motions and inverse dynamics against closed forms and identities.

Angles from `down` grow counter-clockwise. Torques and forces are positive in the direction in which their measure
grows.
"""

from __future__ import annotations

import json
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import freebody as fb
from command import freebody
from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import free_symbols
from freebody.model.elements import NonholonomicForm
from freebody.numeric.directional import derivative
from freebody.numeric.reference import Reference
from freebody.study.inverse_dynamics import inverse_dynamics
from freebody.study.settled import settled
from freebody.study.small_motion.equilibrium import equilibria
from freebody.study.small_motion.found import Equilibria, FoundEquilibrium
from freebody.study.small_motion.modes import NaturalModes, modes
from freebody.system.system import System
from thinned import thinned

G = 9.81
ROOT = Path(__file__).parents[1]

PENDULUM = """
parameters: {m: 2 kg, L: 1.3 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {cord: {link: [ground.A, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.A to bob from down}
start: {theta: 40 deg}
"""

ROD = """
parameters: {m: 2 kg, L: 1.2 m, g: 9.81 m/s^2, k: {value: 0 N m, sign: any}, c: {value: 0 N m s, sign: any},
  T: {value: 0 N m, sign: any}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.A, rod.start]}}
loads:
  weight: {gravity: g}
  spring: {law: {measure: theta, force: -k*theta}}
  damper: {law: {measure: theta, force: -c*rate(theta)}}
  motor: {torque: {on: rod, magnitude: T}}
measures: {theta: angle of rod from UP_OR_DOWN}
start: {theta: 0.4}
"""
HANGING, STANDING = ROD.replace("UP_OR_DOWN", "down"), ROD.replace("UP_OR_DOWN", "up")

OSCILLATOR = """
parameters: {m: 2 kg, k: 50 N/m, c: 4 N s/m, F: {value: 0 N, sign: any}}
bodies: {block: {particle: {mass: m}}}
connections: {rail: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads:
  spring: {law: {measure: x, force: -k*x}}
  damper: {law: {measure: x, force: -c*rate(x)}}
  push: {force: {at: block, along: right, magnitude: F}}
start: {x: 0.1 m}
"""

DOUBLE = """
parameters: {m: 0.7 kg, L: 0.4 m, g: 9.81 m/s^2}
bodies: {upper: {particle: {mass: m}}, lower: {particle: {mass: m}}}
connections: {rod1: {link: [ground.O, upper, L]}, rod2: {link: [upper, lower, L]}}
loads: {weight: {gravity: g}}
measures:
  a: angle of line from ground.O to upper from down
  b: angle of line from upper to lower from down
start: {a: 20 deg, b: -10 deg}
"""

ATWOOD = """
parameters: {m1: 3 kg, m2: 2 kg, R: 0.1 m, g: 9.81 m/s^2}
bodies:
  pulley: {disk: {mass: 1 kg, radius: R}}
  left: {particle: {mass: m1}}
  right: {particle: {mass: m2}}
connections:
  axle: {pin: [ground.O, pulley]}
  rope: {string: {from: left, over: [pulley], to: right}}
loads: {weight: {gravity: g}}
measures: {x1: drop of left below ground.O, x2: drop of right below ground.O}
"""

FOUR_BAR = """
parameters: {a: 0.2 m, b: 0.5 m, c: 0.4 m, d: 0.5 m, m1: 1 kg, m2: 2 kg, m3: 3 kg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {mass: m1, length: a}}
  coupler: {rod: {mass: m2, length: b}}
  rocker: {rod: {mass: m3, length: c}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.end]}
  D: {pin: [ground.D, rocker.start]}
loads: {weight: {gravity: g}}
measures: {theta: angle of crank, phi: angle of rocker}
start: {theta: 60 deg}
"""

SLIDER_CRANK = """
parameters: {r: 0.1 m, l: 0.3 m, J: 0.05 kg m^2, m: 3 kg, w: 20 rad/s}
bodies:
  crank: {body: {inertia: J}, points: {end: [r, 0]}}
  rod: {rod: {length: l}}
  piston: {particle: {mass: m}}
connections:
  main: {pin: [ground.O, crank]}
  crankpin: {pin: [crank.end, rod.start]}
  wristpin: {pin: [rod.end, piston]}
  cylinder: {slider: {body: piston, along: right}}
measures: {theta: angle of crank, x: x of piston}
start: {theta: 1}
"""

# masses 2 m and m on massless rods with springs in the joints; a force that follows the second rod
ZIEGLER = """
parameters: {m: 1 kg, L: 1 m, k: 1 N m, P: 2 N}
bodies:
  A: {particle: {mass: 2*m}}
  B: {particle: {mass: m}}
  first: {rod: {length: L}}
  second: {rod: {length: L}}
connections:
  foot: {pin: [ground.O, first.start]}
  knee: {pin: [first.end, second.start]}
  tip: {pin: [second.end, B]}
  mid: {pin: [first.end, A]}
loads:
  spring1: {law: {measure: a, force: -k*a}}
  spring2: {law: {measure: {expression: b - a}, force: -k*(b - a)}}
  follower: {force: {at: B, along: second.left, magnitude: P}}
measures: {a: angle of first, b: angle of second}
"""


def with_values(text: str, values: dict[str, float]) -> System:
    """A model with other numbers in the units of its file."""
    system = System.from_text(text)
    return system.with_parameters(**{n: f"{x!r} {system.parameters[n].unit}" for n, x in values.items()})


def found(text: str, *guesses: dict[str, Any], **values: float) -> Equilibria:
    return equilibria(with_values(text, values), guesses)


def small(text: str, at: Any = "equilibrium", guess: dict[str, Any] | None = None, **values: float) -> NaturalModes:
    return modes(with_values(text, values), at, guess)


def at(found: Equilibria, **values: float) -> FoundEquilibrium:
    """The equilibrium with these values of measures."""
    near = [r for r in found if all(abs(r.measures[n] - x) < 1e-6 for n, x in values.items())]
    assert len(near) == 1, [dict(r.measures) for r in found]
    return near[0]


# Equilibria -------------------------------------------------------------------------------------


def test_a_pendulum_hangs_or_stands() -> None:
    rests = found(PENDULUM)
    assert len(rests) == 2
    hanging, standing = at(rests, theta=0.0), at(rests, theta=math.pi)
    assert (hanging.stability, standing.stability) == ("stable", "unstable")
    assert hanging.reactions["cord.length"] == pytest.approx(2 * G, rel=1e-12)
    assert standing.reactions["cord.length"] == pytest.approx(-2 * G, rel=1e-12)
    assert hanging.eigenvalue == pytest.approx(G / 1.3, rel=1e-10)
    assert standing.eigenvalue == pytest.approx(-G / 1.3, rel=1e-10)
    assert all(r.residual < 1e-12 for r in rests)


def test_a_guess_leads_to_one_equilibrium_only() -> None:
    assert [r.measures["theta"] for r in found(PENDULUM, {"theta": "170 deg"})] == [pytest.approx(math.pi)]
    assert [r.measures["theta"] for r in found(PENDULUM, {"theta": 0.1})] == [pytest.approx(0.0, abs=1e-9)]
    assert len(found(PENDULUM, {"theta": 0.1}, {"theta": "-10 deg"}, {"theta": 3})) == 2


def test_a_guess_of_an_unknown_measure_is_an_input_error() -> None:
    with pytest.raises(InputError, match="Did you mean theta"):
        found(PENDULUM, {"thet": 1})
    with pytest.raises(InputError, match="must be"):
        found(PENDULUM, {"theta": "1 m"})


def test_a_double_pendulum_has_four_equilibria_and_one_is_stable() -> None:
    rests = found(DOUBLE)
    assert len(rests) == 4
    for a in (0.0, math.pi):
        for b in (0.0, math.pi):
            rest = at(rests, a=a, b=b)
            assert rest.stability == ("stable" if a == b == 0 else "unstable")
            assert rest.reactions["rod1.length"] == pytest.approx(math.cos(a) * 2 * 0.7 * G, rel=1e-10)
            assert rest.reactions["rod2.length"] == pytest.approx(math.cos(b) * 0.7 * G, rel=1e-10)


@pytest.mark.parametrize("k", [3.0, 8.0, 11.0])
def test_a_standing_rod_on_a_soft_spring_leans_to_either_side(k: float) -> None:
    weight = 2 * G * 0.6  # m g L/2: the critical stiffness
    rests = found(STANDING, k=k)
    assert k < weight
    assert at(rests, theta=0.0).stability == "unstable"
    leaning = [r for r in rests if 0.01 < abs(r.measures["theta"]) < math.pi]
    for rest in leaning:
        theta = rest.measures["theta"]
        assert k * theta == pytest.approx(weight * math.sin(theta), rel=1e-10)
        assert rest.eigenvalue == pytest.approx((k - weight * math.cos(theta)) / (2 * 1.2**2 / 3), rel=1e-9)
        assert rest.stability == "stable"
    assert sorted(np.sign(r.measures["theta"]) for r in leaning) == [-1, 1]


def test_a_standing_rod_on_a_stiff_spring_stands() -> None:
    rests = found(STANDING, k=13.0)
    assert [r.stability for r in rests] == ["stable"]
    assert rests[0].measures["theta"] == pytest.approx(0.0, abs=1e-9)


def test_at_the_critical_stiffness_the_linearisation_does_not_decide() -> None:
    rests = found(STANDING.replace("k: {value: 0 N m, sign: any}", "k: 11.772 N m"))
    upright = min(rests, key=lambda r: abs(r.measures["theta"]))
    assert abs(upright.measures["theta"]) < 1e-5
    assert upright.stability == "undecided by the linearisation"


def test_unequal_weights_over_a_pulley_do_not_rest() -> None:
    with pytest.raises(CannotAnswer, match=r"no equilibrium on the branch.*x1 keeps accelerating \(at 1\.78364 m/s\^2"):
        found(ATWOOD)


def test_equal_weights_over_a_pulley_rest_anywhere() -> None:
    rests = found(ATWOOD, m1=2.0)
    assert [r.stability for r in rests] == ["neutral"]
    assert set(rests[0].neutral) <= {"x1", "x2"}
    assert rests[0].neutral
    assert rests[0].reactions["axle.y"] == pytest.approx(5 * G, rel=1e-12)


def test_a_block_on_a_smooth_slope_keeps_sliding() -> None:
    text = """
parameters: {m: 1 kg, g: 9.81 m/s^2}
bodies: {block: {particle: {mass: m}}}
connections: {slope: {slider: {body: block, along: -30 deg}}}
loads: {weight: {gravity: g}}
measures: {s: travel of block along -30 deg}
"""
    with pytest.raises(CannotAnswer, match=r"s keeps accelerating \(at 4\.905 m/s\^2"):
        found(text)


def test_a_cylinder_on_a_level_floor_is_neutral_and_on_a_spring_is_not() -> None:
    text = """
parameters: {m: 1 kg, R: 0.2 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {disk: {disk: {mass: m, radius: R}}}
connections: {contact: {rolling: {body: disk, on: floor}}}
loads: {weight: {gravity: g}}
measures: {s: travel of disk along floor}
"""
    rests = found(text)
    assert [r.stability for r in rests] == ["neutral"]
    assert rests[0].neutral == ("s",)
    assert rests[0].reactions["contact.contact"] == pytest.approx(G)
    held = text.replace("loads: {", "loads: {spring: {law: {measure: s, force: -100*s}}, ").replace("100*s", "k*s")
    held = held.replace("m: 1 kg,", "m: 1 kg, k: 100 N/m,")
    assert small(held)[0].frequency == pytest.approx(math.sqrt(100 / 1.5), rel=1e-10)


def four_bar_height(theta: float) -> float:
    """Potential energy of FOUR_BAR by circles that intersect, on the branch with the rocker on the left."""
    a, b, c, d, m1, m2, m3 = 0.2, 0.5, 0.4, 0.5, 1.0, 2.0, 3.0
    B = np.array([a * math.cos(theta), a * math.sin(theta)])
    D = np.array([d, 0.0])
    way = D - B
    e = float(np.hypot(*way))
    along = (e * e + b * b - c * c) / (2 * e)
    up = math.sqrt(b * b - along * along)
    C = B + (along * way + up * np.array([-way[1], way[0]])) / e
    return G * (m1 * B[1] / 2 + m2 * (B[1] + C[1]) / 2 + m3 * C[1] / 2)


def test_a_four_bar_under_gravity_rests_where_its_height_is_stationary() -> None:
    rests = found(FOUR_BAR)
    h = 1e-5
    thetas = np.linspace(0, 2 * math.pi, 2001)
    slopes = [(four_bar_height(t + h) - four_bar_height(t - h)) / (2 * h) for t in thetas]
    assert len(rests) == sum(a * b < 0 for a, b in pairwise(slopes))
    for rest in rests:
        theta = rest.measures["theta"]
        assert (four_bar_height(theta + h) - four_bar_height(theta - h)) / (2 * h) == pytest.approx(0, abs=1e-6)
        bend = four_bar_height(theta + 1e-3) + four_bar_height(theta - 1e-3) - 2 * four_bar_height(theta)
        assert rest.stability == ("stable" if bend > 0 else "unstable")
    assert {r.stability for r in rests} == {"stable", "unstable"}


def test_reactions_of_a_resting_mechanism_carry_its_weight() -> None:
    for rest in found(FOUR_BAR):
        # sign of a pin: the force on its second body
        up = rest.reactions["A.y"] + rest.reactions["D.y"]
        assert up == pytest.approx(6 * G, rel=1e-10)
        assert rest.reactions["A.x"] + rest.reactions["D.x"] == pytest.approx(0, abs=1e-9)


def test_two_bars_that_carry_a_pin_are_pressed_as_by_hand() -> None:
    # two bars at 45 degrees in a pin that carries F: each is pressed by F/sqrt(2)
    rests = found("""
parameters: {F: 100 N, a: 1 m}
ground: {points: {A: [-a, 0], B: [a, 0]}}
bodies: {top: {particle: {mass: 1 kg}, at: [0, a]}}
connections: {left: {link: [ground.A, top]}, right: {link: [ground.B, top]}}
loads: {down: {force: {at: top, along: down, magnitude: F}}}
""")
    assert rests.degrees_of_freedom == 0
    assert any("0 degrees of freedom" in note for note in rests.notes)
    assert rests[0].stability == "stable"
    for name in ("left.length", "right.length"):
        assert rests[0].reactions[name] == pytest.approx(-100 / math.sqrt(2), rel=1e-12)


def test_a_truss_has_the_bar_forces_of_the_method_of_joints() -> None:
    # A fixed, B on a roller, apex C above the middle; span 4, height 1.5, load F at C to the right
    rests = found("""
parameters: {F: 60 N, h: 1.5 m, s: 2 m}
ground: {points: {A: [0, 0]}}
bodies:
  B: {particle: {}, at: [2*s, 0]}
  C: {particle: {}, at: [s, h]}
connections:
  AC: {link: [ground.A, C]}
  AB: {link: [ground.A, B]}
  BC: {link: [B, C]}
  roller: {slider: {body: B, along: right}}
loads: {push: {force: {at: C, along: right, magnitude: F}}}
""")
    leg = math.hypot(2, 1.5)
    rest = rests[0]
    # at C: (S_AC - S_BC) 2/leg = F, S_AC + S_BC = 0; at B: S_AB = -S_BC 2/leg
    assert rest.reactions["AC.length"] == pytest.approx(60 * leg / 4, rel=1e-12)
    assert rest.reactions["BC.length"] == pytest.approx(-60 * leg / 4, rel=1e-12)
    assert rest.reactions["AB.length"] == pytest.approx(30, rel=1e-12)
    assert not rest.non_unique


def test_a_beam_on_too_many_pins_has_unique_sums_only() -> None:
    rests = found("""
parameters: {m: 6 kg, L: 2 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {mass: m, length: L}}}
connections: {left: {pin: [ground.A, beam.start]}, right: {pin: [ground.B, beam.end]}}
loads: {weight: {gravity: g}}
""")
    rest = rests[0]
    assert rest.reactions["left.y"] == pytest.approx(3 * G)
    assert rest.reactions["right.y"] == pytest.approx(3 * G)
    assert rest.non_unique == ("left.x", "right.x")
    assert rest.reactions["left.x"] is None
    assert rests.to_plain()["equilibria"][0]["reactions"]["right.x"] is None


def test_a_string_that_would_have_to_push_is_told() -> None:
    text = PENDULUM.replace("cord: {link: [ground.A, bob, L]}", "cord: {string: {from: ground.A, to: bob}}")
    rests = found(
        text.replace("bob: {particle: {mass: m}}", "bob: {particle: {mass: m}, at: [L, 0]}").replace(
            "start: {theta: 40 deg}", ""
        )
    )
    assert not at(rests, theta=0.0).notes
    assert any("would have to push" in note for note in at(rests, theta=math.pi).notes)


def test_a_driver_is_held_at_the_start_unless_it_moves() -> None:
    driven = PENDULUM.replace("bodies: {", "bodies: {cart: {particle: {mass: 1 kg}}, ").replace("ground.A", "cart")
    driven = driven.replace(
        "connections: {",
        "connections: {rail: {slider: {body: cart, along: right}}, drive: {driver: {measure: x, follows: COURSE}}, ",
    )
    driven = driven.replace("measures: {", "measures: {x: x of cart, ").replace(
        "m: 2 kg", "m: 2 kg, A: 0.5 m, w: 3 rad/s"
    )
    rests = found(driven.replace("COURSE", "A*cos(w*t)"))
    assert "drive is held at its value at t = 0" in rests.notes
    assert all(r.measures["x"] == pytest.approx(0.5) for r in rests)
    assert len(rests) == 2
    # at rest nothing drives, though the course bends at t = 0
    assert at(rests, theta=0.0).reactions["drive.drive"] == pytest.approx(0, abs=1e-9)
    with pytest.raises(CannotAnswer, match="because drive moves at t = 0"):
        found(driven.replace("COURSE", "A*sin(w*t)"))


def test_a_follower_force_makes_a_column_flutter_at_zieglers_load() -> None:
    critical = 7 / 2 - math.sqrt(2)  # P L/k; Ziegler, Ingenieur-Archiv 20 (1952)
    for P, stable in ((0.999 * critical, True), (1.001 * critical, False)):
        motion = small(ZIEGLER, guess={"a": 0, "b": 0}, P=P)
        assert all(m.kind == "oscillation" for m in motion) == stable
        assert any(m.growth_rate > 1e-3 for m in motion) != stable
        assert motion.stability == ("undecided by the linearisation" if stable else "unstable")
    damped = ZIEGLER.replace("loads:", "loads:\n  damping: {law: {measure: a, force: -d*rate(a)}}").replace(
        "P: 2 N", "P: 0.5 N, d: 0.1 N m s"
    )
    assert small(damped, guess={"a": 0, "b": 0}).stability == "stable"


# Small motions ----------------------------------------------------------------------------------


def test_pendulums_swing_at_their_textbook_frequencies() -> None:
    assert small(PENDULUM)[0].frequency == pytest.approx(math.sqrt(G / 1.3), rel=1e-12)
    assert small(HANGING)[0].frequency == pytest.approx(math.sqrt(1.5 * G / 1.2), rel=1e-12)
    assert small(HANGING)[0].frequency_hz == pytest.approx(math.sqrt(1.5 * G / 1.2) / math.tau, rel=1e-12)


def test_a_standing_pendulum_falls_at_its_growth_rate() -> None:
    motion = small(PENDULUM, guess={"theta": "179 deg"})
    assert [m.kind for m in motion] == ["growing"]
    assert motion[0].growth_rate == pytest.approx(math.sqrt(G / 1.3), rel=1e-10)
    assert motion[0].frequency is None


def test_two_masses_between_three_springs_swing_together_and_against_each_other() -> None:
    motion = modes(System.load(ROOT / "examples" / "two_masses_three_springs.yaml"))
    assert [m.frequency for m in motion] == pytest.approx([10, math.sqrt(300)], rel=1e-12)
    assert motion[0].shape == pytest.approx({"x1": 1, "x2": 1})
    assert motion[1].shape == pytest.approx({"x1": 1, "x2": -1})
    assert motion[1].bodies["B"] == pytest.approx((-1, 0, 0))


def test_a_double_pendulum_swings_at_two_minus_and_plus_root_two() -> None:
    motion = small(DOUBLE)
    squares = [G / 0.4 * (2 - math.sqrt(2)), G / 0.4 * (2 + math.sqrt(2))]
    assert [m.frequency**2 for m in motion if m.frequency] == pytest.approx(squares, rel=1e-11)
    assert motion[0].shape["a"] == pytest.approx(1 / math.sqrt(2))
    assert motion[1].shape["a"] == pytest.approx(-1 / math.sqrt(2))


def test_a_damped_oscillator_has_its_damping_ratio() -> None:
    (mode,) = small(OSCILLATOR)
    assert mode.frequency == pytest.approx(5, rel=1e-12)
    assert mode.damping_ratio == pytest.approx(0.2, rel=1e-12)
    assert mode.growth_rate == pytest.approx(-1, rel=1e-12)
    assert mode.damped_frequency == pytest.approx(5 * math.sqrt(1 - 0.04), rel=1e-12)


def test_an_overdamped_oscillator_creeps_at_two_rates() -> None:
    motion = small(OSCILLATOR, c=52.0)
    assert [m.kind for m in motion] == ["creeping", "creeping"]
    assert [m.growth_rate for m in motion] == pytest.approx([-1, -25], rel=1e-10)


def test_a_free_chain_has_a_rigid_mode_with_and_without_damping() -> None:
    text = """
parameters: {m: 1 kg, k: 8 N/m, c: {value: C N s/m, sign: any}}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: m}}}
connections: {rail_A: {slider: {body: A, along: right}}, rail_B: {slider: {body: B, along: right}}}
measures: {x1: x of A, x2: x of B}
loads: {coupling: {law: {measure: {expression: x2 - x1}, force: -k*(x2 - x1) - c*(rate(x2) - rate(x1))}}}
"""
    for c in ("0", "0.4"):
        motion = small(text.replace("C N", f"{c} N"))
        assert [m.kind for m in motion] == ["rigid", "oscillation"]
        assert motion[0].frequency == 0.0
        assert motion[0].shape == pytest.approx({"x1": 1, "x2": 1})
        assert motion[1].frequency == pytest.approx(4, rel=1e-10)
        assert motion[1].damping_ratio == pytest.approx(2 * float(c) / (2 * 4), abs=1e-12)
        assert motion.stability == "neutral"


def test_modes_about_a_moving_start_are_those_of_a_bead_on_a_rotor() -> None:
    # in the horizontal plane: m (r'' - w^2 r) = -k (r - l)
    text = """
parameters: {m: 0.5 kg, k: 80 N/m, l: 0.2 m, w: 6 rad/s}
bodies: {rotor: {rod: {mass: 1 kg, length: 1 m}}, bead: {particle: {mass: m}}}
connections:
  axle: {pin: [ground.O, rotor.start]}
  bore: {slot: {pin: bead, on: rotor, along: right, through: rotor.start}}
  drive: {driver: {measure: angle of rotor, follows: w*t}}
loads: {spring: {law: {measure: r, force: -k*(r - l)}}}
measures: {r: distance from ground.O to bead}
start: {r: k*l/(k - m*w^2), rate(r): 0}
"""
    motion = small(text, "start")
    assert motion.coordinates == ("r",)
    assert motion[0].frequency == pytest.approx(math.sqrt(80 / 0.5 - 36), rel=1e-10)
    assert not motion.notes


def test_a_mass_on_a_turntable_has_coriolis_and_centrifugal_terms() -> None:
    # m u'' - 2 m w v' - m w^2 u + k u = 0 and its twin: seen from the table the frequencies are sqrt(k/m) -+ w
    text = """
parameters: {m: 0.5 kg, k: 50 N/m, w: 3 rad/s}
bodies: {table: {disk: {mass: 1 kg, radius: 1 m}}, mass: {particle: {mass: m}}}
connections:
  axle: {pin: [ground.O, table]}
  drive: {driver: {measure: angle of table, follows: w*t}}
loads: {su: {law: {measure: u, force: -k*u}}, sv: {law: {measure: v, force: -k*v}}}
measures: {u: travel of mass along table.right, v: travel of mass along table.up}
start: {u: 0, v: 0, rate(u): 0, rate(v): 0}
"""
    motion = small(text, "start")
    assert motion.coordinates == ("u", "v")
    assert [m.frequency for m in motion] == pytest.approx([10 - 3, 10 + 3], rel=1e-10)
    assert np.allclose(motion.damping, [[0, -2 * 0.5 * 3], [2 * 0.5 * 3, 0]], atol=1e-10)
    assert np.allclose(motion.stiffness, (50 - 0.5 * 9) * np.eye(2), rtol=1e-10)
    # a circle, run through in either sense
    assert all(abs(m.shape["v"]) == pytest.approx(1) and abs(m.shape["v"].real) < 1e-9 for m in motion)


def test_modes_about_a_start_out_of_balance_say_so() -> None:
    motion = small(PENDULUM, "start")
    assert motion[0].frequency == pytest.approx(math.sqrt(G / 1.3 * math.cos(math.radians(40))), rel=1e-11)
    assert "no steady state of theta" in motion.notes[0]


def test_a_brake_that_switches_has_no_linear_law_but_quadratic_drag_has() -> None:
    drag = OSCILLATOR.replace("-c*rate(x)", "-d*rate(x)*abs(rate(x))").replace("c: 4 N s/m", "d: 4 N s^2/m^2")
    assert small(drag)[0].damping_ratio == pytest.approx(0, abs=1e-9)
    brake = OSCILLATOR.replace("-c*rate(x)", "-d*sign(rate(x))").replace("c: 4 N s/m", "d: 4 N")
    with pytest.raises(CannotAnswer, match="not smooth"):
        small(brake)


@pytest.mark.parametrize("f", [abs, lambda s: math.copysign(1.0, s) if s else 0.0, lambda s: abs(s) ** 0.5])
def test_what_has_no_slope_is_refused(f: Any) -> None:
    with pytest.raises(CannotAnswer):
        derivative(lambda s: np.array([f(s)]), np.ones(1))


def test_derivatives_are_accurate_to_rounding() -> None:
    slopes = derivative(lambda s: np.array([math.exp(3 * s), math.sin(2 + s), math.cos(s), s**3]), np.ones(4))
    assert slopes == pytest.approx([3, math.cos(2), 0, 0], rel=1e-12, abs=1e-12)


def test_a_massless_body_that_is_free_has_no_modes_by_name() -> None:
    text = OSCILLATOR.replace("mass: m}", "mass: 0 kg}").replace("m: 2 kg, ", "")
    with pytest.raises(CannotAnswer, match="block can move without inertia"):
        small(text)


MOVING = {
    "double pendulum": (DOUBLE.replace("b: -10 deg", "b: -10 deg, rate(a): 2, rate(b): -3"), ["a", "b"]),
    "four-bar": (FOUR_BAR.replace("theta: 60 deg", "theta: 60 deg, rate(theta): 5"), ["theta"]),
    "slider-crank": (SLIDER_CRANK.replace("theta: 1}", "theta: 1, rate(theta): w}"), ["theta"]),
    "follower force": (ZIEGLER + "start: {a: 0.3, b: -0.4, rate(a): 1, rate(b): 2}\n", ["a", "b"]),
}


@pytest.mark.parametrize("name", MOVING)
def test_the_linear_equations_of_a_moving_state_are_the_slopes_of_the_full_ones(name: str) -> None:
    text, names = MOVING[name]
    system = System.from_text(text)
    motion = modes(system, "start")
    assert motion.coordinates == tuple(names)
    reference = Reference(system)
    q0 = reference.assemble()
    measures = [system.measures[n] for n in names]
    v0 = reference.velocities(q0)
    s0 = reference.snapshot(q0, v0)
    x0 = np.array([*(s0.value(m) for m in measures), *(s0.rate(m) for m in measures)])

    def turning(x: Any) -> Any:
        k = len(names)
        q = reference.pose_near(q0, list(zip(measures, x[:k], strict=True)))
        v = reference.velocities(q, list(zip(measures, x[k:], strict=True)), with_start=False)
        return np.array([reference.snapshot(q, v).acceleration(m) for m in measures])

    h = 2e-3
    slopes = [
        (8 * (turning(x0 + e) - turning(x0 - e)) - (turning(x0 + 2 * e) - turning(x0 - 2 * e))) / (12 * h)
        for e in h * np.eye(len(x0))
    ]
    found = motion.small.A[len(names) :]
    assert np.abs(found - np.array(slopes).T).max() < 1e-7 * np.abs(found).max()


def test_a_skate_rests_anywhere_and_swings_along_its_blade() -> None:
    text = """
parameters: {m: 1 kg, k: 10 N/m}
bodies: {skate: {rod: {mass: m, length: 1 m}, at: [0, 2 m], angle: 0.3}}
measures: {x: x of skate, y: y of skate, theta: angle of skate}
connections: {blade: {velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)}}
loads: {spring: {law: {measure: x, force: -k*x}}}
"""
    rests = found(text)
    assert [r.stability for r in rests] == ["neutral"]
    assert any("blade binds velocities only" in note for note in rests.notes)
    motion = small(text)
    # it drifts in turning, and stays wherever y puts it: the spring is without force on a line of places
    assert [m.kind for m in motion] == ["rigid", "rigid", "oscillation"]
    assert [dict(m.shape) for m in motion][:2] == [{"x": 0, "y": 0, "theta": 1}, {"x": 0, "y": 1, "theta": 0}]
    assert motion[2].frequency == pytest.approx(math.sqrt(10) * math.cos(0.3), rel=1e-10)


def test_what_only_turns_in_space_has_turns_for_a_shape() -> None:
    """A Cardan joint at 30 deg, its fork as it stands: the driven shaft follows by cos 30 deg, and the cross turns with
    the drive about its own pin."""
    system = System.load(ROOT / "examples" / "cardan_joint.yaml")
    (mode,) = modes(system)
    assert {name: [round(x.real, 9) for x in parts] for name, parts in mode.bodies.items()} == {
        "drive": [0, 0, 0, 0, 0, 1],
        "driven": [0, 0, 0, 0, 0, round(math.cos(math.pi / 6), 9)],
        "cross": [0, 0, 0, 0, -0.5, round(math.cos(math.pi / 6), 9)],
    }


def test_modes_of_one_rate_are_told_by_one_coordinate_each() -> None:
    """A mass in the plane between equal springs in x and y, and one that is free: any combination would be a mode."""
    text = """
parameters: {m: 2 kg, k: 50 N/m}
bodies: {bob: {particle: {mass: m}}, puck: {particle: {mass: m}, at: [1 m, 2 m]}}
measures: {x: x of bob, y: y of bob, u: x of puck, v: y of puck}
loads: {along: {law: {measure: x, force: -k*x}}, across: {law: {measure: y, force: -k*y}}}
"""
    motion = small(text)
    assert [m.kind for m in motion] == ["rigid", "rigid", "oscillation", "oscillation"]
    shapes = [{name: round(part.real, 12) for name, part in m.shape.items() if part} for m in motion]
    assert shapes == [{"u": 1}, {"v": 1}, {"x": 1}, {"y": 1}]


def test_an_angle_without_a_value_is_not_told() -> None:
    """A top that stands upright: the axes of psi and phi lie on each other, so neither has a value, and it tips over
    with sqrt(m g l/(A + m l^2)) in every direction."""
    system = System.load(ROOT / "examples" / "spinning_top.yaml")
    motion = modes(system)
    assert "psi" not in motion.measures
    assert "phi" not in motion.measures
    assert [m.kind for m in motion] == ["rigid", "growing", "growing"]
    assert "psi" not in motion[1].shape
    rate = math.sqrt(0.5 * 9.81 * 0.06 / (8e-4 + 0.5 * 0.06**2))
    assert [m.growth_rate for m in motion[1:]] == pytest.approx([rate, rate], rel=1e-9)


def test_what_only_stays_where_rolling_binds_velocities_does_not_drift() -> None:
    """The skate with a spring on its angle as well: it stays wherever y puts it, and swings in two ways."""
    motion = small("""
parameters: {m: 1 kg, k: 10 N/m, c: 2 N m}
bodies: {skate: {rod: {mass: m, length: 1 m}, at: [0, 2 m], angle: 0.3}}
measures: {x: x of skate, y: y of skate, theta: angle of skate}
connections: {blade: {velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)}}
loads: {spring: {law: {measure: x, force: -k*x}}, twist: {law: {measure: theta, force: -c*(theta - 0.3)}}}
""")
    assert [m.kind for m in motion] == ["rigid", "oscillation", "oscillation"]
    assert dict(motion[0].shape) == {"x": 0, "y": 1, "theta": 0}
    slow, fast = math.sqrt(10) * math.cos(0.3), math.sqrt(2 * 12)
    assert [m.frequency for m in motion[1:]] == pytest.approx([slow, fast], rel=1e-9)


def test_a_soft_spring_rests_far_below_and_a_stiff_one_where_it_hangs() -> None:
    for k in (0.01, 1.0, 1e9):
        system = System.load(ROOT / "examples" / "mass_on_spring.yaml").with_parameters(k=f"{k!r} N/m")
        motion = modes(system)
        assert motion.measures["y"] == pytest.approx(0.5 + 2 * G / k, rel=1e-12)
        assert motion[0].frequency == pytest.approx(math.sqrt(k / 2), rel=1e-9)


def test_a_rest_where_a_buffer_is_just_relaxed_hides_no_other() -> None:
    """Its loads have a kink there, so no linearisation decides; the others are judged as ever."""
    text = (ROOT / "examples" / "cart_into_a_buffer.yaml").read_text()
    free, relaxed = equilibria(System.from_text(text.replace("rate(x): v0", "rate(x): 0 m/s")))
    assert (free.measures["x"], free.stability) == (0.0, "neutral")
    assert relaxed.measures["x"] == pytest.approx(3.6 + 0.6, rel=1e-9)
    assert relaxed.stability == "undecided by the linearisation"
    assert any("not smooth in this pose" in note for note in relaxed.notes)


EXAMPLES = sorted((ROOT / "examples").glob("*.yaml"))
SOME = EXAMPLES[::6]  # their small motions are compared by the goldens as well


@pytest.mark.parametrize("path", thinned(EXAMPLES, SOME.__contains__), ids=lambda path: path.stem)
def test_every_example_has_equilibria_or_a_reason_and_small_motions(path: Path) -> None:
    system = System.load(path)
    if system.dry_friction:
        with pytest.raises(CannotAnswer, match="freebody statics"):
            equilibria(system)
        return
    system = settled(system)
    reference = Reference(system)
    q = reference.assemble()
    at_rest = reference.snapshot(q, np.zeros_like(q)).accelerations
    is_driven = any(row.target is not None and "t" in free_symbols(row.target) for row in system.constraint_rows)
    try:
        assert all(rest.residual < 1e-9 for rest in equilibria(system))
    except CannotAnswer:
        assert is_driven or np.abs(at_rest).max() > 0.1
    is_turning = system.space and reference.velocities(q).any()
    n_places = len(q) - sum(not isinstance(row.measure, NonholonomicForm) for row in system.constraint_rows)
    if is_turning and len(system.measures) < n_places:  # too few to tell the pose
        with pytest.raises(CannotAnswer, match="name angles or places"):
            modes(system, "start")
        return
    if path.stem == "car_on_a_surveyed_track":  # it starts on a point of its curve, whose third derivative jumps there
        with pytest.raises(CannotAnswer, match="not smooth in this pose"):
            modes(system, "start")
        return
    motion = modes(system, "start")
    if is_turning:  # round-off splits the zeros of what keeps turning
        assert np.isfinite(motion.small.A).all()
        return
    n_creeping = sum(mode.kind == "creeping" for mode in motion)
    if n_creeping:  # one of the two rates that a resisted coordinate has
        rates = np.linalg.eigvals(motion.small.A)
        assert all(np.abs(rates - mode.rate).min() < 1e-9 for mode in motion)
        assert len(motion.coordinates) <= len(motion) <= len(motion.coordinates) + n_creeping
        return
    n_states = len(system.states)  # rates of coordinates of their own, which vibrate with no mode
    assert len(motion.coordinates) - n_states <= len(motion) <= len(motion.coordinates)


# State-space models -----------------------------------------------------------------------------


def test_the_state_space_model_of_an_oscillator_is_the_textbook_one() -> None:
    A, B, C, D = small(OSCILLATOR).state_space(inputs=["push", "F"], outputs=["x", "rate(x)", "rate(rate(x))"])
    assert np.allclose(A, [[0, 1], [-25, -2]], rtol=1e-12, atol=1e-12)
    assert np.allclose(B, [[0, 0], [0.5, 0.5]], rtol=1e-12, atol=1e-12)
    assert np.allclose(C, [[1, 0], [0, 1], [-25, -2]], rtol=1e-12, atol=1e-12)
    assert np.allclose(D, [[0, 0], [0, 0], [0.5, 0.5]], rtol=1e-12, atol=1e-12)


def test_a_linear_model_answers_a_small_torque_as_the_full_one_does() -> None:
    from scipy.linalg import expm

    hanging = HANGING.replace("start: {theta: 0.4}", "start: {theta: 0}")
    system = with_values(hanging, {"c": 1.5})
    A, B, C, _D = modes(system).state_space(inputs=["motor"], outputs=["theta"])
    torque = 1e-4
    reference = Reference(with_values(hanging, {"c": 1.5, "T": torque}))
    q = reference.assemble()
    motion = reference.integrate((q, reference.velocities(q)), 1.0)
    theta = motion.values(system.measures["theta"])
    steady = np.linalg.solve(A, B[:, 0]) * torque
    linear = [float((C @ (expm(A * t) @ steady - steady))[0]) for t in motion.times]
    assert np.abs(theta - linear).max() < 1e-6 * np.abs(theta).max()


def test_other_loads_are_scaled_by_their_input_and_parameters_differentiated() -> None:
    motion = small(OSCILLATOR.replace("force: -k*x", "force: -k*x + p*n").replace("F: {", "p: 3 N/m, n: 2 m, F: {"))
    assert motion.measures["x"] == pytest.approx(6 / 50)
    _A, B, _C, _D = motion.state_space(inputs=["spring", "p", "k"])
    # at rest the whole law is zero; d(force)/dp = n, d(force)/dk = -x
    assert B[1] == pytest.approx([0, 2 / 2, -6 / 50 / 2], abs=1e-10)


def test_inputs_that_are_none_are_refused_by_name() -> None:
    motion = small(PENDULUM)
    with pytest.raises(CannotAnswer, match="L changes the connections"):
        motion.state_space(inputs=["L"])
    with pytest.raises(InputError, match="Did you mean weight"):
        motion.state_space(inputs=["weigth"])
    with pytest.raises(InputError, match="no measure phi"):
        motion.state_space(outputs=["phi"])


def test_outputs_are_measures_their_rates_and_accelerations() -> None:
    motion = small(DOUBLE)
    A, _B, C, _D = motion.state_space(outputs=["a", "rate(b)", "rate(rate(b))"])
    states = list(motion.states)
    assert states == ["a", "b", "rate(a)", "rate(b)"]
    assert np.allclose(C[0], [1, 0, 0, 0])
    assert np.allclose(C[1], [0, 0, 0, 1])
    assert np.allclose(C[2], A[3])


# Inverse dynamics -------------------------------------------------------------------------------


def test_a_swinging_rod_needs_the_torque_of_its_inertia_and_its_weight() -> None:
    system = System.from_text(HANGING.replace("T: {", "w: 2 rad/s, T: {"))
    t = np.linspace(0, 5, 41)
    theta, spin, turning = 3 * np.sin(2 * t), 6 * np.cos(2 * t), -12 * np.sin(2 * t)
    torque = 2 * 1.2**2 / 3 * turning + 2 * G * 0.6 * np.sin(theta)

    def course(s: float) -> tuple[float, float, float]:
        return 3 * math.sin(2 * s), 6 * math.cos(2 * s), -12 * math.sin(2 * s)

    for given in ("3*sin(w*t)", course, (theta, spin, turning)):
        result = inverse_dynamics(system, {"theta": given}, t)
        assert np.abs(result.forces["theta"] - torque).max() < 1e-10
        assert np.abs(result.powers["theta"] - torque * spin).max() < 1e-9
        assert np.allclose(result.values["theta"], theta, atol=1e-12)
        # the pin carries m (a - g) of the mass centre
        inward = 2 * (spin**2 * 0.6 + G * np.cos(theta))
        forward = 2 * (turning * 0.6 + G * np.sin(theta))
        assert np.allclose(result.reactions["hinge.y"], inward * np.cos(theta) + forward * np.sin(theta))
    assert result.unit("theta") == "N m"
    assert result.poses["rod"].shape == (41, 3)


def test_a_slider_crank_is_driven_by_the_torque_of_virtual_power() -> None:
    # massless rod: T = J theta'' + m x'(theta) (x'(theta) theta'' + x''(theta) theta'^2)
    t = np.linspace(0, 1.5, 31)
    system = System.from_text(SLIDER_CRANK)
    result = inverse_dynamics(system, {"theta": "1 + 2*sin(w*t)"}, t)
    theta, spin, turning = 1 + 2 * np.sin(20 * t), 40 * np.cos(20 * t), -800 * np.sin(20 * t)
    s, c, r, l = np.sin(theta), np.cos(theta), 0.1, 0.3  # noqa: E741
    root = np.sqrt(l**2 - r**2 * s**2)
    x1 = -r * s - r**2 * s * c / root
    x2 = -r * c - r**2 * (c**2 - s**2) / root - r**4 * s**2 * c**2 / root**3
    torque = 0.05 * turning + 3 * x1 * (x1 * turning + x2 * spin**2)
    assert np.abs(result.forces["theta"] - torque).max() < 1e-9 * np.abs(torque).max()
    assert np.allclose(result.values["x"], r * c + root, atol=1e-11)


def test_the_drivers_of_a_model_show_their_torque_without_a_motion() -> None:
    driven = SLIDER_CRANK.replace("connections:", "connections:\n  motor: {driver: {measure: theta, follows: 1 + w*t}}")
    t = np.linspace(0, 0.5, 11)
    alone = inverse_dynamics(System.from_text(driven), None, t)
    told = inverse_dynamics(System.from_text(SLIDER_CRANK), {"theta": "1 + w*t"}, t)
    assert np.allclose(alone.forces["motor"], told.forces["theta"], rtol=1e-10, atol=1e-9)
    assert "motor.drive" not in alone.reactions
    # the power of the driver is the change of the kinetic energy: T = m x'^2/2 + J w^2/2
    change = 3 * alone.rates["x"] * alone.accelerations["x"]
    assert np.allclose(alone.powers["motor"], change, rtol=1e-9, atol=1e-9)


def test_what_is_left_free_or_prescribed_twice_is_named() -> None:
    system = System.from_text(DOUBLE)
    with pytest.raises(CannotAnswer, match=r"prescribes 1 of 2 degrees of freedom and leaves b free"):
        inverse_dynamics(system, {"a": "0"}, [0.0])
    crank = System.from_text(SLIDER_CRANK)
    with pytest.raises(CannotAnswer, match=r"x is prescribed twice: theta determine"):
        inverse_dynamics(crank, {"theta": "1", "x": "0.3 m"}, [0.0])
    with pytest.raises(InputError, match="no measure phi"):
        inverse_dynamics(crank, {"phi": "1"}, [0.0])
    with pytest.raises(InputError, match="each later"):
        inverse_dynamics(crank, {"theta": "1"}, [1.0, 0.5])


def test_a_mechanism_that_cannot_follow_says_when() -> None:
    crank = System.from_text(SLIDER_CRANK)
    with pytest.raises(CannotAnswer, match=r"cannot follow the motion beyond t = 0\.\d+ s"):
        inverse_dynamics(crank, {"x": lambda t: (0.35 + 0.1 * t, 0.1, 0.0)}, np.linspace(0, 2, 21))


def test_reactions_that_are_not_unique_are_marked_in_time() -> None:
    text = """
parameters: {m: 2 kg, L: 1 m, w: 1 1/s}
bodies: {a: {rod: {mass: m, length: L}, angle: 90 deg}, b: {rod: {mass: m, length: L}, angle: 90 deg},
  c: {rod: {mass: m, length: L}, angle: 90 deg}, bar: {rod: {mass: m, length: 2*L}, at: {start: [0, L]}}}
ground: {points: {A: [0, 0], B: [L, 0], C: [2*L, 0]}}
connections:
  A: {pin: [ground.A, a.start]}
  B: {pin: [ground.B, b.start]}
  C: {pin: [ground.C, c.start]}
  a: {pin: [a.end, bar.start]}
  b: {pin: [b.end, bar.center]}
  c: {pin: [c.end, bar.end]}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {theta: angle of a}
start: {theta: 90 deg}
"""
    result = inverse_dynamics(System.from_text(text), {"theta": "pi/2 + 0.3*sin(w*t)"}, np.linspace(0, 1, 5))
    assert {"b.x", "b.y"} <= set(result.non_unique)
    assert "theta" not in result.non_unique
    theta = result.values["theta"]
    J, turning = 2 / 3, result.accelerations["theta"]
    # three bars turn, the platform moves on a circle: (3 J + m L^2) theta'' + (3 m/2 + m) g L cos theta
    torque = (3 * J + 2) * turning + (3 + 2) * G * np.cos(theta)
    assert np.allclose(result.forces["theta"], torque, rtol=1e-10, atol=1e-10)
    assert result.to_plain()["reactions"]["b.y"][0] is None


# The command line -------------------------------------------------------------------------------


def test_the_commands_print_documents_with_the_documented_keys() -> None:
    document = json.loads(freebody("equilibrium", "examples/simple_pendulum.yaml", "--json").stdout)
    assert document["degrees_of_freedom"] == 1
    first = document["equilibria"][0]
    assert first["measures"]["theta"] == {"value": pytest.approx(0, abs=1e-12), "unit": "rad"}
    assert first["stability"] == "stable"
    assert set(first["poses"]) == {"bob"}
    assert first["reactions"]["rod.length"] == pytest.approx(G)
    document = json.loads(freebody("modes", "examples/double_pendulum.yaml", "--json").stdout)
    mode = document["modes"][0]
    assert set(mode) >= {"frequency", "frequency_hz", "damping_ratio", "growth_rate", "shape", "kind"}
    assert mode["shape"]["theta2"] == 1
    assert len(document["state_matrix"]) == 4


def test_the_commands_answer_with_their_exit_codes() -> None:
    done = freebody("equilibrium", "examples/double_pendulum.yaml", "--guess", "theta1=179 deg, theta2=0.1")
    assert done.returncode == 0
    assert "unstable" in done.stdout
    assert "180°" in done.stdout
    done = freebody("modes", "examples/two_masses_three_springs.yaml")
    assert done.returncode == 0
    assert "ω = 17.321 rad/s" in done.stdout
    done = freebody("equilibrium", "examples/yo_yo.yaml")
    assert done.returncode == 1
    assert "y keeps accelerating" in done.stderr
    for wrong in (
        ["equilibrium", "examples/simple_pendulum.yaml", "--guess", "theta"],
        ["modes", "x.yaml"],
        ["modes", "examples/simple_pendulum.yaml", "--at", "rest"],
    ):
        assert freebody(*wrong).returncode == 2


def test_a_parameter_without_a_value_is_asked_for() -> None:
    with pytest.raises(CannotAnswer, match="numbers need a value for m"):
        equilibria(System.from_text(PENDULUM.replace("m: 2 kg", "m: kg")))


def test_loads_that_only_die_away_balance_nowhere() -> None:
    """On y = h exp(-x/b) the slope is nowhere zero: Newton's steps go on by b, and lose a factor e each."""
    sled = System.from_text("""
parameters: {m: 60 kg, h: 12 m, b: 15 m, g: 9.81 m/s^2}
bodies: {sled: {particle: {mass: m}, near: {at: [0, h]}}}
connections: {snow: {curved_rail: {point: sled, y: h*exp(-x/b)}}}
loads: {weight: {gravity: g}}
measures: {x: {x of sled}}
start: {x: 0}
""")
    with pytest.raises(CannotAnswer, match="there is no equilibrium"):
        equilibria(sled)


@pytest.mark.parametrize("n", [2, 4, 6])
def test_a_flat_minimum_of_a_high_order_is_found(n: int) -> None:
    """The steps to the zero of x^(n - 1) shrink by (n - 2)/(n - 1) each."""
    bowl = System.from_text(f"""
parameters: {{m: 1 kg, a: 1 m, g: 9.81 m/s^2}}
bodies: {{bead: {{particle: {{mass: m}}, near: {{at: [0.7 m, 0]}}}}}}
connections: {{wire: {{curved_rail: {{point: bead, y: a*(x/a)^{n}}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: {{x of bead}}}}
start: {{x: 0.7 m}}
""")
    assert abs(equilibria(bowl)[0].measures["x"]) < 1e-2


def test_a_repulsion_that_only_dies_away_balances_nowhere() -> None:
    """F = c/x^3: each of Newton's steps is x/3, longer than the one before."""
    apart = System.from_text("""
parameters: {m: 1 kg, c: 2 N m^3, a: 1 m}
bodies: {p: {particle: {mass: m}, at: [a, 0]}}
connections: {rail: {slider: {body: p, along: right}}}
loads: {push: {force: {at: p, along: right, magnitude: c/x^3}}}
measures: {x: {x of p}}
start: {x: a}
""")
    with pytest.raises(CannotAnswer, match="there is no equilibrium"):
        equilibria(apart)


# -- balance without friction ----------------------------------------------------------------------
@pytest.mark.parametrize("asked", ["range of x that keeps it at rest", "value of x for which nothing moves"])
def test_where_somebody_has_to_sit_on_a_seesaw_is_where_the_moments_balance(asked: str) -> None:
    system = fb.System.from_text("""
parameters: {L: 4 m, M: 20 kg, m1: 30 kg, m2: 40 kg, g: 9.81 m/s^2, x: m}
bodies:
  plank: {rod: {mass: M, length: L}, angle: 0, at: [0, 0], points: {P: [x, 0]}}
  left: {particle: {mass: m1}}
  right: {particle: {mass: m2}}
connections:
  pivot: {pin: [ground.O, plank]}
  seat1: {weld: [plank.start, left]}
  seat2: {weld: [plank.P, right]}
loads: {weight: {gravity: g}}
""")
    (answer,) = system.solve(asked).answers
    assert answer.value == pytest.approx(1.5)
    assert answer.expression is not None
    assert answer.evidence is not None


def test_a_lever_has_one_length_at_which_it_balances() -> None:
    # F b = m g a, whatever the angle of the lever
    system = fb.System.from_text("""
parameters: {a: 0.2 m, b: 1 m, m: 30 kg, F: 100 N, g: 9.81 m/s^2}
bodies:
  lever: {body: {inertia: 1 kg m^2}, angle: 20 deg, points: {A: [-a, 0], B: [b, 0]}}
  load: {particle: {mass: m}}
connections: {pivot: {pin: [ground.O, lever]}, hook: {weld: [lever.A, load]}}
loads: {weight: {gravity: g}, hand: {force: {at: lever.B, along: down, magnitude: F}}}
""")
    (answer,) = system.solve("range of b that keeps it at rest").answers
    assert answer.value == pytest.approx(30 * 9.81 * 0.2 / 100)
