"""The reference route against closed forms and identities."""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest

from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import Symbol, evaluate, number
from freebody.language.parser import parse
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.measures.geometry import GROUND, ONE, RIGHT, UP, Direction, Point
from freebody.measures.lead import Lead
from freebody.model.elements import Component, NonholonomicForm
from freebody.numeric.jet_geometry import Frame, JetGeometry
from freebody.numeric.jets import JET_FUNCTIONS, Jet
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.trajectory import ReferenceTrajectory
from freebody.system.system import System

G = 9.81


def start_of(text: str, **values: float) -> Snapshot:
    """The start of a model, with some parameters replaced."""
    reference = Reference(System.from_text(text), values)
    q = reference.assemble()
    return reference.snapshot(q, reference.velocities(q))


def reaction(s: Snapshot, name: str) -> float:
    """What people name positive, by the name of the row."""
    row = next(row for row in s.reference.system.constraint_rows if row.name == name)
    return row.sign * s.multiplier(row)


def measured(s: Snapshot, name: str) -> Any:
    return s.reference.system.measures[name]


def energy(s: Snapshot) -> float:
    return s.kinetic_energy + sum(s.potential(push) for push in s.reference.system.applied_loads)


PENDULUM = """
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {cord: {link: [ground.A, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.A to bob from down}
start: {theta: 90 deg}
"""

ROD = """
parameters: {m: 2 kg, L: 1.2 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {hinge: {pin: [ground.A, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod from down}
start: {theta: 0.7, rate(theta): 1.5}
"""

DOUBLE = """
parameters: {m1: 2 kg, m2: 1 kg, L1: 1 m, L2: 0.7 m, g: 9.81 m/s^2}
bodies:
  upper: {rod: {mass: m1, length: L1}}
  lower: {rod: {mass: m2, length: L2}}
connections:
  shoulder: {pin: [ground.A, upper.start]}
  elbow: {pin: [upper.end, lower.start]}
loads: {weight: {gravity: g}}
measures: {a: angle of upper from down, b: angle of lower from down}
start: {a: 60 deg, b: 20 deg, rate(a): 1, rate(b): -2}
"""

ATWOOD = """
parameters: {M: 2 kg, R: 0.3 m, m1: 1 kg, m2: 3 kg, g: 9.81 m/s^2}
bodies:
  pulley: {disk: {mass: M, radius: R}}
  left: {particle: {mass: m1}}
  right: {particle: {mass: m2}}
connections:
  axle: {pin: [ground.axle, pulley.center]}
  rope: {string: {from: left, over: [pulley], to: right, grips: [pulley]}}
loads: {weight: {gravity: g}}
measures: {x1: drop of left below ground.axle, x2: drop of right below ground.axle}
"""

SLIDER_CRANK = """
parameters: {r: 0.1 m, l: 0.3 m, w: 5 rad/s}
bodies:
  crank: {rod: {mass: 1 kg, length: r}, angle: 40 deg}
  rod: {rod: {mass: 2 kg, length: l}}
  block: {particle: {mass: 3 kg}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, rod.start]}
  C: {pin: [rod.end, block]}
  guide: {slot: {pin: block, along: right, through: ground.A}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {x: x of block, phi: angle of crank}
start: {rate(phi): w}
"""

PLANETARY = """
parameters: {m: 1.5 kg, rS: 0.2 m, rP: 0.1 m, IS: 0.05 kg m^2, T: 3 N m}
bodies:
  sun: {disk: {mass: 1 kg, radius: rS, inertia: IS}}
  planet: {disk: {mass: m, radius: rP}, at: [rS + rP, 0]}
  arm: {rod: {length: rS + rP}}
  ring: {ring: {radius: rS + 2*rP}, fixed: true}
connections:
  sun_bearing: {pin: [ground.O, sun]}
  arm_bearing: {pin: [ground.O, arm.start]}
  planet_bearing: {pin: [arm.end, planet]}
  inner: {gear_mesh: [sun, planet]}
  outer: {gear_mesh: {first: ring, second: planet, internal: true}}
loads: {drive: {torque: {on: sun, magnitude: T}}}
measures: {phi: angle of sun}
"""

SKATE = """
parameters: {m: 1 kg, L: 1 m}
bodies: {skate: {rod: {mass: m, length: L}, at: [1 m, 2 m], angle: 0.3, angular_velocity: 3 rad/s}}
measures: {x: x of skate, y: y of skate, theta: angle of skate}
connections: {blade: {velocity_constraint: rate(y)*cos(theta) - rate(x)*sin(theta)}}
"""


# Jets -------------------------------------------------------------------------------------------

FORMULAS = [
    "x*y + x/y - 3*x",
    "x^3/(1 + y^2) - 2^x",
    "sqrt(x*y) + y^(3/2) + x^y",
    "sin(x)*cos(y) + tan(x*y/3)",
    "asin(x/4) + acos(y/5) + atan(x - y)",
    "exp(-x)*log(y) + 1/(x - 4)",
    "sinh(x) - cosh(y)*tanh(x*y)",
    "(x - y)^0 + abs(x - 3)*sign(y) + pi*x^(-2)",
]


def along(formula: str, s: complex) -> Any:
    """A formula on the motion x = 1.3 + 0.4 s, y = 0.8 - 0.7 s + 0.3 s^2."""
    names = ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh")
    functions = {name: getattr(cmath, name) for name in names}
    functions |= {
        "number": complex,
        "abs": lambda z: z if z.real > 0 else -z,
        "sign": lambda z: 1 if z.real > 0 else -1,
    }
    return evaluate(parse(formula), {"x": 1.3 + 0.4 * s + 0j, "y": 0.8 - 0.7 * s + 0.3 * s * s + 0j}, functions)


@pytest.mark.parametrize("formula", FORMULAS)
def test_jets_follow_a_motion_to_second_order(formula: str) -> None:
    x = Jet(1.3, np.array([1.0, 0.0]), 0.4)
    y = Jet(0.8, np.array([0.0, 1.0]), -0.7, 0.6)
    jet = evaluate(parse(formula), {"x": x, "y": y}, JET_FUNCTIONS)
    h = 1e-4
    bias = (along(formula, h).real - 2 * along(formula, 0).real + along(formula, -h).real) / h**2
    assert jet.value == pytest.approx(along(formula, 0).real, rel=1e-14)
    assert jet.rate == pytest.approx(along(formula, 1e-30j).imag / 1e-30, rel=1e-13)
    assert jet.bias == pytest.approx(bias, rel=1e-6, abs=1e-6)
    assert jet.rate == pytest.approx(jet.gradient @ np.array([0.4, -0.7]), rel=1e-13)


def test_jets_refuse_what_has_no_derivative() -> None:
    moving = Jet(0.0, np.array([1.0]), 1.0)
    for formula in ("abs(x)", "sqrt(x)", "1/x", "(x - 1)^(1/2)"):
        with pytest.raises((ValueError, ArithmeticError)):
            evaluate(parse(formula), {"x": moving}, JET_FUNCTIONS)


P, Q = Point("a", (number(0.3), number(-0.2))), Point("b", (number(-0.5), number(0.1)))
SLANTED = Direction("b", (number(0.6), number(0.8)))
MEASURES: list[Any] = [
    Angle("a", "b", Symbol("k")),
    Displacement(P, Q, RIGHT),
    Displacement(P, Q, SLANTED),
    Displacement(P, Point("pillar", (ONE, ONE)), Direction("pillar", (ONE, number(0)))),
    Distance(P, Q),
    Bearing(P, Point("dot"), "b", Symbol("k")),
    Lead(P, Q, Symbol("k")),
    Combination(((Symbol("k"), Distance(P, Point("dot"))), (number(2), Angle("b"))), LENGTH),
    Composed(parse("d^2*sin(3*t) + k*d"), (("d", Distance(P, Q)),), LENGTH),
    Component(SLANTED, "y"),
    NonholonomicForm(
        ((Component(SLANTED, "x"), Displacement(P, Q, UP)), (Component(SLANTED, "y"), Angle("a"))), LENGTH
    ),
]


def geometry(q: Any, v: Any, t: float) -> JetGeometry:
    frame = Frame(
        {"a": (0, 1, 2), "dot": (3, 4), "b": (5, 6, 7)},
        {GROUND: (0, 0, 0), "pillar": (1, 2, 0.4)},
        {"k": 0.6},
    )
    return JetGeometry(frame, q, v, t, {})


@pytest.mark.parametrize("measure", MEASURES, ids=lambda m: type(m).__name__)
def test_gradient_rate_and_bias_of_every_measure_agree_with_differences(measure: Any) -> None:
    rng = np.random.default_rng(4)
    q, v, t, h = rng.standard_normal(8) * 2, rng.standard_normal(8), 0.4, 1e-4
    here = geometry(q, v, t).of(measure)
    before, after = (geometry(q + s * v, v, t + s).of(measure) for s in (-h, h))
    if isinstance(measure, NonholonomicForm):
        assert here.bias == pytest.approx((after.rate - before.rate) / (2 * h), rel=1e-6)
        assert here.rate == pytest.approx(here.row(8) @ v)
        return
    assert here.rate == pytest.approx((after.value - before.value) / (2 * h), rel=1e-6, abs=1e-8)
    assert here.bias == pytest.approx((after.rate - before.rate) / (2 * h), rel=1e-6, abs=1e-8)
    for k, e in enumerate(np.eye(8)):
        slope = (geometry(q + h * e, v, t).of(measure).value - geometry(q - h * e, v, t).of(measure).value) / (2 * h)
        assert here.row(8)[k] == pytest.approx(slope, rel=1e-6, abs=1e-8)


def test_the_tangent_of_two_circles_rebuilds_the_line_of_centres() -> None:
    g = geometry(np.arange(8.0) * 0.7, np.ones(8), 0.0)
    from freebody.measures.geometry import Vector

    v, rho = Vector(Jet(-3.0), Jet(-1.0)), Jet(0.8)
    length, angle = g.tangent(v, rho)
    c, s = math.cos(angle.value), math.sin(angle.value)
    assert length.value * c - rho.value * s == pytest.approx(-3.0)
    assert length.value * s + rho.value * c == pytest.approx(-1.0)
    with pytest.raises(CannotAnswer, match="the circles overlap"):
        g.tangent(v, Jet(4.0))


def test_an_angle_of_a_line_goes_on_beyond_a_turn() -> None:
    measure = Bearing(Point(GROUND), Point("dot"))
    q, angles = np.zeros(8), {}
    frame = geometry(q, q, 0.0).frame
    for turn in np.linspace(0.0, 15.0, 31):
        q[3:5] = math.cos(turn), math.sin(turn)
        g = JetGeometry(frame, q, q, 0.0, angles)
        assert g.of(measure).value == pytest.approx(turn)
        angles = g.angles
    assert JetGeometry(frame, q, q, 0.0, {}).of(measure).value == pytest.approx(15.0 - 4 * math.pi)


# Closed forms -----------------------------------------------------------------------------------


def test_a_swinging_rod_has_the_textbook_acceleration_and_pin_reaction() -> None:
    s = start_of(ROD)
    m, L, theta, spin = 2.0, 1.2, 0.7, 1.5
    turning = -1.5 * G / L * math.sin(theta)
    assert s.value(measured(s, "theta")) == pytest.approx(theta)
    assert s.acceleration(measured(s, "theta")) == pytest.approx(turning)
    # the pin carries m (a - g) of the mass centre, which runs on a circle of radius L/2
    inward, forward = m * (spin**2 * L / 2 + G * math.cos(theta)), m * (turning * L / 2 + G * math.sin(theta))
    x = forward * math.cos(theta) - inward * math.sin(theta)
    y = forward * math.sin(theta) + inward * math.cos(theta)
    assert reaction(s, "hinge.x") == pytest.approx(x)
    assert reaction(s, "hinge.y") == pytest.approx(y)


def test_an_atwood_machine_with_a_heavy_pulley_has_two_tensions() -> None:
    s = start_of(ATWOOD)
    a = 2 * G / (3 + 1 + 1)
    assert s.acceleration(measured(s, "x2")) == pytest.approx(a)
    assert s.acceleration(measured(s, "x1")) == pytest.approx(-a)
    assert reaction(s, "rope.left to pulley") == pytest.approx(1 * (G + a))
    assert reaction(s, "rope.pulley to right") == pytest.approx(3 * (G - a))


def test_a_massless_pulley_gives_one_tension() -> None:
    s = start_of(ATWOOD.replace("mass: M, ", ""))
    assert s.acceleration(measured(s, "x2")) == pytest.approx(G / 2)
    assert reaction(s, "rope.left to pulley") == pytest.approx(2 * 3 * G / 4)
    assert reaction(s, "rope.pulley to right") == pytest.approx(2 * 3 * G / 4)


def test_a_disk_rolls_down_an_incline_at_two_thirds_of_g_sine_alpha() -> None:
    s = start_of("""
parameters: {m: 3 kg, R: 0.4 m, alpha: 20 deg, g: 9.81 m/s^2}
ground: {lines: {incline: {angle: -alpha}}}
bodies: {disk: {disk: {mass: m, radius: R}}}
connections: {it: {rolling: {body: disk, on: incline}}}
loads: {weight: {gravity: g}}
measures: {s: travel of disk along incline}
""")
    alpha = math.radians(20)
    assert s.acceleration(measured(s, "s")) == pytest.approx(2 / 3 * G * math.sin(alpha))
    assert reaction(s, "it.contact") == pytest.approx(3 * G * math.cos(alpha))
    assert reaction(s, "it.no slip") == pytest.approx(-3 * G * math.sin(alpha) / 3)


def test_a_planetary_gear_accelerates_as_its_energy_says() -> None:
    s = start_of(PLANETARY)
    m, rS, rP, IS, T = 1.5, 0.2, 0.1, 0.05, 3.0
    IP = m * rP**2 / 2
    expected = 4 * T * rP**2 / (4 * IS * rP**2 + rS**2 * IP + m * rP**2 * rS**2)
    assert s.acceleration(measured(s, "phi")) == pytest.approx(expected, rel=1e-12)


def test_a_spring_pulls_and_its_potential_is_the_work_it_can_do() -> None:
    s = start_of("""
parameters: {k: 5 N/m, k3: 5 N/m^3, l0: 1 m, c: 2 N s/m}
bodies: {ball: {particle: {mass: 2 kg}, at: [3 m, 4 m], velocity: [1 m/s, 0]}}
measures: {x: x of ball}
loads:
  spring: {spring: {first: ground.A, second: ball, stiffness: k, length: l0}}
  relaxed: {spring: {first: ground.A, second: ball, stiffness: k}}
  damper: {damper: {first: ground.A, second: ball, damping: c}}
  cubic: {law: {measure: x, force: -k3*x^3}}
  pull: {force: {at: ball, along: right, magnitude: 3 N}}
""")
    push = {p.load: p for p in s.reference.system.applied_loads}
    assert s.law(push["spring"]) == pytest.approx(-5 * (5 - 1))
    assert s.law(push["relaxed"]) == pytest.approx(0, abs=1e-12)
    assert s.law(push["damper"]) == pytest.approx(-2 * 3 / 5)
    assert s.potential(push["spring"]) == pytest.approx(5 / 2 * (5 - 1) ** 2)  # k (l - l0)^2/2
    assert s.potential(push["relaxed"]) == pytest.approx(0, abs=1e-12)
    assert s.potential(push["cubic"]) == pytest.approx(5 / 4 * 3**4, rel=1e-12)
    assert s.potential(push["pull"]) == pytest.approx(-9)
    with pytest.raises(CannotAnswer, match=r"damper has no potential"):
        s.potential(push["damper"])
    x = (-5 * 4 * 3 / 5 + -2 * 3 / 5 * 3 / 5 - 5 * 27 + 3) / 2
    assert s.acceleration(measured(s, "x")) == pytest.approx(x)


def test_a_law_with_a_pole_at_zero_has_its_potential_from_infinity_or_none() -> None:
    s = start_of("""
bodies: {ball: {particle: {mass: 2 kg}, at: [3 m, 4 m]}}
parameters: {k: 5 N m^2, q: 2 N/m, l: 1 m}
measures: {d: distance from ground.A to ball}
loads:
  attraction: {law: {measure: d, force: -k/d^2}}
  line: {law: {measure: d, force: -k/(l*d)}}
  root: {law: {measure: d, force: q*sqrt(l*d)}}
""")
    attraction, line, root = s.reference.system.applied_loads
    assert s.law(attraction) == pytest.approx(-0.2)
    assert s.potential(attraction) == pytest.approx(-1, rel=1e-12)  # -k/d
    with pytest.raises(CannotAnswer, match="cannot be integrated"):  # a logarithm, which has no end
        s.potential(line)
    assert s.potential(root) == pytest.approx(-2 * 2 / 3 * 5**1.5, rel=1e-10)


def test_a_skate_keeps_its_speed_and_feels_a_side_force() -> None:
    reference = Reference(System.from_text(SKATE))
    q = reference.assemble()
    x, y = reference.system.measures["x"], reference.system.measures["y"]
    v = reference.velocities(q, [(x, 2 * math.cos(0.3)), (y, 2 * math.sin(0.3))])
    s = reference.snapshot(q, v)
    # the blade turns the velocity: a = v omega across it, and no acceleration along it
    assert s.acceleration(x) == pytest.approx(-6 * math.sin(0.3))
    assert s.acceleration(y) == pytest.approx(6 * math.cos(0.3))
    assert reaction(s, "blade.constraint") == pytest.approx(6.0)
    end = reference.integrate(s, 1.0).snapshots[-1]
    assert math.hypot(end.rate(x), end.rate(y)) == pytest.approx(2.0, rel=1e-10)
    # it runs on a circle of radius v/omega
    assert end.value(x) == pytest.approx(1 + 2 / 3 * (math.sin(3.3) - math.sin(0.3)), rel=1e-9)


# Identities -------------------------------------------------------------------------------------


@pytest.mark.parametrize("text", [ROD, DOUBLE, ATWOOD, SLIDER_CRANK, PLANETARY])
def test_reactions_do_no_work_and_balance_every_body(text: str) -> None:
    s = start_of(text)
    system, n = s.reference.system, len(s.q)
    held, pushed = np.zeros(n), np.zeros(n)
    for body in system.moving:
        columns = list(s.reference.columns(body.name))
        for row in system.constraint_rows:
            held[columns] += s.multiplier(row) * np.array(s.gradient(row.measure, body.name))[: len(columns)]
        for push in system.applied_loads:
            pushed[columns] += s.law(push) * np.array(s.gradient(push.measure, body.name))[: len(columns)]
    assert held + pushed == pytest.approx(s.reference.masses * s.accelerations, abs=1e-9)
    assert held @ s.v == pytest.approx(0, abs=1e-9)
    assert s.v @ (s.reference.masses * s.accelerations) == pytest.approx(pushed @ s.v, abs=1e-9)


def test_the_ground_feels_the_opposite_of_what_all_bodies_feel() -> None:
    s = start_of(DOUBLE)
    hinge = next(row for row in s.reference.system.constraint_rows if row.name == "shoulder.x")
    assert s.gradient(hinge.measure, GROUND)[:2] == pytest.approx((-1.0, 0.0))
    assert s.gradient(hinge.measure, "upper")[:2] == pytest.approx((1.0, 0.0))
    follower = NonholonomicForm(
        (
            (
                Component(Direction("upper", (ONE, number(0))), "x"),
                Displacement(Point("lower"), Point(GROUND), RIGHT),
            ),
            (
                Component(Direction("upper", (ONE, number(0))), "y"),
                Displacement(Point("lower"), Point(GROUND), UP),
            ),
        ),
        LENGTH,
    )
    x, y, _ = s.reference.pose(s.q, "lower")
    fx, fy, moment = s.gradient(follower, GROUND)
    ex, ey, _ = s.gradient(follower, "lower")
    assert (fx, fy) == pytest.approx((-ex, -ey))
    assert moment == pytest.approx(-(x * ey - y * ex))


def test_momentum_of_a_double_pendulum_changes_by_the_outer_forces() -> None:
    s = start_of(DOUBLE)
    (ax, ay, _), (bx, by, _) = s.accelerations[:3], s.accelerations[3:]
    assert 2 * ax + 1 * bx == pytest.approx(reaction(s, "shoulder.x"))
    assert 2 * ay + 1 * by == pytest.approx(reaction(s, "shoulder.y") - 3 * G)
    # angular momentum about the hinge: only the weights have a moment
    masses, inertias = (2.0, 1.0), (2.0 / 12, 1.0 * 0.49 / 12)
    total = moment = 0.0
    for k, name in enumerate(("upper", "lower")):
        x, y, _ = s.reference.pose(s.q, name)
        cx, cy, turning = s.accelerations[3 * k : 3 * k + 3]
        total += masses[k] * (x * cy - y * cx) + inertias[k] * turning
        moment -= masses[k] * G * x
    assert total == pytest.approx(moment)


# Assembly ---------------------------------------------------------------------------------------


def test_a_slider_crank_closes_where_the_law_of_cosines_says() -> None:
    s = start_of(SLIDER_CRANK)
    phi, r, w = math.radians(40), 0.1, 5.0
    root = math.sqrt(0.3**2 - (r * math.sin(phi)) ** 2)
    assert s.value(measured(s, "x")) == pytest.approx(r * math.cos(phi) + root, abs=1e-12)
    speed = -r * w * math.sin(phi) - (r**2 * w * math.sin(phi) * math.cos(phi)) / root
    assert s.rate(measured(s, "x")) == pytest.approx(speed, rel=1e-12)


def test_a_loop_closes_even_if_nothing_says_where_its_bodies_are() -> None:
    s = start_of(SLIDER_CRANK.replace(", angle: 40 deg", ""))
    assert s.kinetic_energy > 0


@pytest.mark.parametrize("loop", ["", "  last: {pin: [b59.end, ground.wall]}\n"], ids=["open", "closed"])
def test_a_long_chain_is_assembled_even_if_nothing_says_where_its_bodies_are(loop: str) -> None:
    n = 60
    joints = [f"  p{i}: {{pin: [{f'b{i - 1}.end' if i else 'ground.O'}, b{i}.start]}}\n" for i in range(n)]
    s = start_of(
        "ground: {points: {O: [0, 0], wall: [10 m, 2 m]}}\nbodies:\n"
        + "".join(f"  b{i}: {{rod: {{mass: 1 kg, length: 1 m}}}}\n" for i in range(n))
        + "connections:\n"
        + "".join(joints)
        + loop
    )
    gaps = [s.value(row.measure) for row in s.reference.system.constraint_rows]
    assert max(map(abs, gaps)) < 1e-9


def test_a_loop_that_cannot_close_is_named_with_its_gap() -> None:
    with pytest.raises(CannotAnswer, match=r"at best ([ABC]|guide|the given place of block|angle of crank) is off"):
        start_of(SLIDER_CRANK.replace("3 kg}", "3 kg}, at: [1.4 m, 0]"))
    with pytest.raises(CannotAnswer, match=r"off by .* m\b"):
        start_of("""
bodies: {bob: {particle: {mass: 1 kg}, at: [0, -2 m]}}
connections: {cord: {link: [ground.A, bob, 1 m]}}
""")


def test_the_start_may_be_given_by_measures_beyond_half_a_turn() -> None:
    s = start_of(PENDULUM.replace("90 deg", "3.5"))
    assert s.value(measured(s, "theta")) == pytest.approx(3.5)


def test_coinciding_points_are_parted_the_same_way_every_time() -> None:
    text = PENDULUM.replace("start: {theta: 90 deg}", "")
    first, second = start_of(text), start_of(text)
    assert math.hypot(*first.q) == pytest.approx(1.0)
    assert (first.q == second.q).all()


def test_a_start_is_the_nearest_pose_by_the_masses_to_what_is_guessed() -> None:
    """Two blocks on guides at right angles, joined by a link of 1 m and guessed to be at (a, 0) and (0, b). The least
    of m1 (x - a)^2 + m2 (y - b)^2 with x^2 + y^2 = 1 has m1 (x - a)/x = m2 (y - b)/y."""
    a, b, m1, m2 = 0.9, 0.2, 1.0, 7.0
    text = f"""
bodies:
  p: {{particle: {{mass: {m1} kg}}, near: {{at: [{a} m, 0]}}}}
  q: {{particle: {{mass: {m2} kg}}, near: {{at: [0, {b} m]}}}}
connections:
  h: {{slider: {{body: p, along: right}}}}
  v: {{slider: {{body: q, along: up}}}}
  l: {{link: {{first: p, second: q, length: 1 m}}}}
"""
    reference = Reference(System.from_text(text))
    q = reference.assemble()
    x, y = q[reference.columns("p")[0]], q[reference.columns("q")[1]]
    assert math.hypot(x, y) == pytest.approx(1.0, abs=1e-12)
    assert m1 * (x - a) / x == pytest.approx(m2 * (y - b) / y, rel=1e-9)


def test_a_start_has_no_nearest_pose_where_the_ends_of_a_line_would_meet() -> None:
    """The line from q to p is level and leads to the left. q is guessed at the origin, 1 m above p; it may come as near
    to p as it likes, and where both meet the line has no direction: the first pose that is found stays."""
    text = """
bodies: {p: {particle: {mass: 1 kg}, at: [0, -1 m]}, q: {particle: {mass: 1 kg}}}
connections: {c: {driver: {measure: angle of line from q to p from left, follows: 0}}}
"""
    reference = Reference(System.from_text(text))
    pose = reference.assemble()
    q = pose[list(reference.columns("q"))]
    assert q[1] == pytest.approx(-1.0, abs=1e-9)
    assert q[0] > 0.1


def test_a_further_pose_keeps_what_the_start_held() -> None:
    s = start_of(ATWOOD)
    x1, x2 = measured(s, "x1"), measured(s, "x2")
    q = s.reference.pose_near(s.q, [(x1, 0.25)])
    moved = s.reference.snapshot(q, 0 * q)
    assert moved.value(x2) == pytest.approx(-0.25)
    assert abs(s.reference.pose(q, "pulley")[2]) == pytest.approx(0.25 / 0.3)


def test_wanted_values_replace_those_of_the_start() -> None:
    s = start_of(DOUBLE)
    a, b = measured(s, "a"), measured(s, "b")
    q = s.reference.assemble([(a, 0.1)])
    v = s.reference.velocities(q, [(b, 3.0)])
    moved = s.reference.snapshot(q, v)
    assert (moved.value(a), moved.value(b)) == pytest.approx((0.1, math.radians(20)))
    assert (moved.rate(a), moved.rate(b)) == pytest.approx((1.0, 3.0))


def test_wandering_holds_what_is_held_and_changes_the_rest() -> None:
    s = start_of(SLIDER_CRANK)
    q, v = s.reference.wander(s.q, np.random.default_rng(3), 0.2)
    there = s.reference.snapshot(q, v)
    for row in s.reference.system.constraint_rows:
        assert there.value(row.measure) == pytest.approx(0, abs=1e-12)
        assert there.rate(row.measure) == pytest.approx(0, abs=1e-12)
    assert there.rate(measured(s, "phi")) != pytest.approx(s.rate(measured(s, "phi")))


def test_contradicting_velocities_are_named() -> None:
    with pytest.raises(CannotAnswer, match=r"velocity of skate|blade"):
        start_of(SKATE.replace("angular_velocity: 3 rad/s", "velocity: [2 m/s, 1 m/s]"))


def test_a_driver_prescribes_velocity_and_acceleration() -> None:
    s = start_of("""
parameters: {w: 2 rad/s^2}
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections:
  p: {pin: [ground.A, rod.start]}
  motor: {driver: {measure: angle of rod, follows: 0.3 + w*t^2/2}}
measures: {theta: angle of rod}
loads: {weight: {gravity: 9.81 m/s^2}}
""")
    theta = measured(s, "theta")
    assert (s.value(theta), s.rate(theta), s.acceleration(theta)) == pytest.approx((0.3, 0.0, 2.0))
    assert reaction(s, "motor.drive") == pytest.approx(2 / 3 + G / 2 * math.cos(0.3))
    later = s.reference.integrate(s, 1.0).snapshots[-1]
    assert (later.value(theta), later.rate(theta)) == pytest.approx((1.3, 2.0), rel=1e-12)


# Refusals ---------------------------------------------------------------------------------------


def test_missing_numbers_are_named() -> None:
    system = System.from_text(ROD.replace("m: 2 kg, L: 1.2 m", "m: kg, L: m"))
    with pytest.raises(CannotAnswer, match="m, L"):
        Reference(system, {})
    assert Reference(system, {"m": 1.0, "L": 2.0}).masses[2] == pytest.approx(1 / 3)
    with pytest.raises(InputError, match="no parameter n"):
        Reference(system, {"m": 1.0, "L": 2.0, "n": 3.0})


def test_a_redundant_pin_still_moves_but_its_reaction_is_refused_by_name() -> None:
    s = start_of(ROD.replace("connections: {", "connections: {axle: {pin: [ground.A, rod.start]}, "))
    assert s.acceleration(measured(s, "theta")) == pytest.approx(-1.5 * G / 1.2 * math.sin(0.7))
    with pytest.raises(CannotAnswer, match=r"hinge\.x is not unique: axle, hinge"):
        reaction(s, "hinge.x")


def test_a_body_that_moves_without_inertia_is_named() -> None:
    with pytest.raises(CannotAnswer, match="idler can move without inertia"):
        _ = start_of(ROD.replace("bodies: {", "bodies: {idler: {disk: {radius: L}}, ")).accelerations


def test_no_value_is_not_a_number() -> None:
    s = start_of("""
bodies: {ball: {particle: {mass: 1 kg}, at: [-1 m, 0]}}
measures: {x: x of ball}
parameters: {k: 1 N/m, l: 1 m}
loads: {odd: {law: {measure: x, force: k*sqrt(l*x)}}}
""")
    with pytest.raises(CannotAnswer, match="odd has no value here"):
        _ = s.accelerations
    with pytest.raises(CannotAnswer, match="no real root"):
        s.sqrt(-1.0)
    with pytest.raises(CannotAnswer, match="not finite"):
        s.reference.snapshot(s.q * np.nan, s.v)


# Motions ----------------------------------------------------------------------------------------


def test_a_pendulum_from_the_horizontal_has_the_elliptic_period() -> None:
    s = start_of(PENDULUM)
    theta = measured(s, "theta")
    half = s.reference.integrate(s, 3.0, lambda now: now.rate(theta))
    assert half.event_time is not None
    assert 2 * half.event_time == pytest.approx(2.36784194757624, abs=1e-9)
    quarter = s.reference.integrate(s, 3.0, lambda now: now.value(theta))
    assert quarter.event is not None
    assert quarter.event_time == pytest.approx(2.36784194757624 / 4, abs=1e-10)
    assert reaction(quarter.event, "cord.length") == pytest.approx(3 * 2 * G, rel=1e-9)
    with pytest.raises(CannotAnswer, match="does not happen"):
        s.reference.integrate(s, 0.5, lambda now: now.value(theta))


@pytest.mark.parametrize(("text", "until"), [(DOUBLE, 3.0), (SLIDER_CRANK, 1.0), (PENDULUM, 4.0)])
def test_motions_keep_their_energy_and_their_constraints(text: str, until: float) -> None:
    s = start_of(text)
    motion = s.reference.integrate(s, until)
    assert motion.times[-1] == pytest.approx(until, abs=1e-12)
    for now in motion.snapshots:
        assert energy(now) == pytest.approx(energy(s), abs=2e-8)
        for row in s.reference.system.constraint_rows:
            target = 0.0 if row.target is None else now.scalar(row.target)
            assert now.value(row.measure) == pytest.approx(target, abs=1e-10)
            assert now.rate(row.measure) == pytest.approx(0.0, abs=1e-10)


def test_a_square_four_bar_runs_through_its_singular_poses() -> None:
    s = start_of("""
ground: {points: {A: [0, 0], B: [1 m, 0]}}
bodies:
  left: {rod: {mass: 1 kg, length: 1 m}, angle: 90 deg}
  right: {rod: {mass: 1 kg, length: 1 m}, angle: 90 deg}
  top: {rod: {mass: 1 kg, length: 1 m}}
connections:
  A: {pin: [ground.A, left.start]}
  B: {pin: [ground.B, right.start]}
  C: {pin: [left.end, top.start]}
  D: {pin: [top.end, right.end]}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {phi: angle of left, psi: angle of top}
start: {rate(phi): -1}
""")
    motion = s.reference.integrate(s, 1.5)
    assert motion.values(measured(s, "phi"))[-1] < -math.pi / 2  # past the line in which all rods lie
    assert motion.values(measured(s, "psi")) == pytest.approx(np.zeros(len(motion.times)), abs=1e-8)
    assert energy(motion.snapshots[-1]) == pytest.approx(energy(s), abs=1e-8)


def test_a_rolling_disk_keeps_the_arc_it_has_rolled() -> None:
    s = start_of("""
bodies:
  drum: {disk: {mass: 1 kg, radius: 0.5 m}, fixed: true, at: [0, 0]}
  disk: {disk: {mass: 2 kg, radius: 0.25 m}, at: [0, -0.75 m], angular_velocity: 9 rad/s}
connections: {it: {rolling: {body: disk, on: drum}}}
measures: {way: angle of line from drum to disk, theta: angle of disk}
""")
    way, theta = measured(s, "way"), measured(s, "theta")
    motion = s.reference.integrate(s, 5.0)
    # without loads it runs on evenly: (R + r) way' = r theta'
    assert motion.values(way)[-1] - motion.values(way)[0] == pytest.approx(5 * 9 / 3, rel=1e-9)
    assert motion.values(theta)[-1] == pytest.approx(45.0, rel=1e-9)


def test_the_same_motion_twice_is_the_same_to_the_last_bit() -> None:
    first, second = (start_of(DOUBLE) for _ in range(2))
    a, b = first.reference.integrate(first, 0.5), second.reference.integrate(second, 0.5)
    assert isinstance(a, ReferenceTrajectory)
    assert (a.q == b.q).all()
    assert (a.v == b.v).all()


# Small motions ----------------------------------------------------------------------------------


def test_a_pendulum_swings_at_the_root_of_g_over_its_reduced_length() -> None:
    s = start_of(ROD.replace("theta: 0.7, rate(theta): 1.5", "theta: 0"))
    assert s.reference.frequencies(s.q) == pytest.approx([math.sqrt(1.5 * G / 1.2)], rel=1e-7)


def test_an_upside_down_pendulum_is_refused_and_so_is_one_that_falls() -> None:
    s = start_of(ROD.replace("theta: 0.7, rate(theta): 1.5", "theta: 180 deg"))
    with pytest.raises(CannotAnswer, match="unstable"):
        s.reference.frequencies(s.q)
    s = start_of(ROD)
    with pytest.raises(CannotAnswer, match="no equilibrium: the loads set rod in motion"):
        s.reference.frequencies(s.q)


def test_a_double_pendulum_has_the_textbook_frequencies() -> None:
    s = start_of("""
bodies: {a: {particle: {mass: 1 kg}}, b: {particle: {mass: 1 kg}}}
connections: {upper: {link: [ground.A, a, 1 m]}, lower: {link: [a, b, 1 m]}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {p: angle of line from ground.A to a from down, q: angle of line from a to b from down}
start: {p: 0, q: 0}
""")
    expected = [math.sqrt(G * (2 - math.sqrt(2))), math.sqrt(G * (2 + math.sqrt(2)))]
    assert s.reference.frequencies(s.q) == pytest.approx(expected, rel=1e-7)


def test_a_free_chain_of_springs_has_one_rigid_motion() -> None:
    s = start_of("""
parameters: {k: 50 N/m, m: 2 kg}
bodies:
  a: {particle: {mass: m}, at: [0, 0]}
  b: {particle: {mass: m}, at: [1 m, 0]}
  c: {particle: {mass: m}, at: [2 m, 0]}
connections:
  p: {slot: {pin: a, along: right}}
  q: {slot: {pin: b, along: right}}
  r: {slot: {pin: c, along: right}}
loads:
  one: {spring: {first: a, second: b, stiffness: k, length: 1 m}}
  two: {spring: {first: b, second: c, stiffness: k}}
""")
    assert s.reference.frequencies(s.q) == pytest.approx([0.0, 5.0, 5.0 * math.sqrt(3)], rel=1e-8)


# -- starts that are only guessed -----------------------------------------------------------------
GUESSED = """
bodies:
  p: {rectangle: {mass: 3 kg, width: 0.4 m, height: 1 m}, near: {at: [0, 2 m], angle: 180 deg}}
  q: {disk: {mass: 10 kg, radius: 0.1 m}, angular_velocity: 2 rad/s, points: {rim: [1 m, 0]}}%s
connections:
  c: {link: {first: p, second: q.rim}}%s
measures: {u: drop of q}
start: {rate(u): 1 m/s}
"""
FRAME = "\n  frame: {body: {}}", "\n  w: {weld: [p, frame]}"


def test_a_massless_frame_pulls_at_no_guess_and_weighs_nothing_in_the_velocities_of_least_energy() -> None:
    plain, framed = (Reference(System.from_text(GUESSED % more)) for more in (("", ""), FRAME))
    q, more_q = plain.assemble(), framed.assemble()
    assert q[:3] == pytest.approx([0.0, 2.0, math.pi], abs=1e-12)
    assert more_q[:6] == pytest.approx(q, abs=1e-12)
    v, more_v = plain.velocities(q), framed.velocities(more_q)
    assert np.abs(v).max() > 0.1
    assert more_v[:6] == pytest.approx(v, abs=1e-12)


_UNDESCRIBED = """
ground: {points: {A: [3 m, 2 m]}}
bodies:
  p: {rod: {mass: 2 kg, length: 1 m}, points: {tip: [0.4 m, 0.1 m]}}
connections:
  pin: {pin: [ground.A, p.tip]}
"""


@pytest.mark.parametrize(
    ("more", "joined"),
    [
        ("  far: {particle: {mass: 3 kg}, at: [100 m, 70 m]}", "  guide: {slider: {body: far, along: right}}"),
        ("  frame: {body: {}}", "  weld: {weld: [p, frame.origin]}"),
        ("  frame: {body: {}}", "  weld: {weld: [frame.origin, p.tip]}"),
        ("  frame: {body: {}}\n  next: {body: {}}", "  weld: {weld: [p, frame.origin]}\n  hinge: {pin: [frame, next]}"),
    ],
)
def test_what_is_not_described_hangs_on_no_other_part_and_on_nothing_that_is_carried(more: str, joined: str) -> None:
    alone, among = (
        Reference(System.from_text(t))
        for t in (_UNDESCRIBED, _UNDESCRIBED.replace("connections:", f"{more}\nconnections:\n{joined}"))
    )
    assert np.allclose(among.assemble()[list(among.columns("p"))], alone.assemble(), rtol=0, atol=1e-14)
