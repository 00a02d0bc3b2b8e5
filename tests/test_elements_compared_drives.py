"""Helical gears, equal planets, wedges, motors and drag beside what follows by hand, turned round."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from posed import is_formula

HELICAL = """
space: {{up: z}}
parameters:
  {{T: 20 N m, M: 30 N m, J_1: 2 g m^2, J_2: 90 g m^2, r: 4 cm, z_1: 20, z_2: 60, beta: 17 deg, alpha: 20 deg}}
ground: {{points: {{A: [0, 0, 0], B: {far}}}}}
bodies:
  pinion: {{body: {{mass: 1 kg, inertia: [J_1, J_1, J_1]}}}}
  wheel: {{body: {{mass: 9 kg, inertia: [J_2, J_2, J_2]}}}}
connections:
  shaft: {{revolute: {{first: ground.A, second: pinion, about: {axis}}}}}
  output: {{revolute: {{first: ground.B, second: wheel, about: {axis}}}}}
  mesh:
    helical_gears:
      {{first: pinion, second: wheel, teeth: [z_1, z_2], radius: r, helix_angle: beta, pressure_angle: alpha{hand}}}
loads:
  motor: {{torque: {{on: pinion, about: {axis}, magnitude: T}}}}
  work: {{torque: {{on: wheel, about: {axis}, magnitude: M}}}}
measures: {{phi: angle of pinion about {axis}}}
start: {{phi: 0}}
"""


@pytest.mark.parametrize("left_handed", [False, True])
@pytest.mark.parametrize("axis", ["x", "z"])
def test_helical_gears_load_their_bearings_by_hand_of_teeth_and_side(axis: str, left_handed: bool) -> None:
    """With n to the other wheel and t = a x n a right-handed tooth runs along a + tan(beta) t, and presses the driver
    along -t + tan(beta) a, and off by tan(alpha)/cos(beta)."""
    a, n = (np.eye(3)[0], np.eye(3)[1]) if axis == "x" else (np.eye(3)[2], np.eye(3)[0])
    t, turned = np.cross(a, n), (20 - 30 / 3) / (0.002 + 0.09 / 9)
    force, hand = (20 - 0.002 * turned) / 0.04, -1 if left_handed else 1
    alpha, beta = math.radians(20), math.radians(17)
    on_pinion = force * (-t + hand * math.tan(beta) * a - math.tan(alpha) / math.cos(beta) * n)
    moment = np.cross(0.04 * n, on_pinion)
    far = "[0, 0.16 m, 0]" if axis == "x" else "[0.16 m, 0, 0]"
    hand_of = ", left_handed: true" if left_handed else ""
    system = fb.System.from_text(HELICAL.format(axis=axis, far=far, hand=hand_of))
    for question, vector in (
        ("reaction of shaft on pinion", -on_pinion),
        ("moment of shaft on pinion", -(moment - (moment @ a) * a)),
        ("reaction of output on wheel", on_pinion),
    ):
        assert system.solve(question)["q1"].value == pytest.approx(tuple(vector), abs=1e-12)


PLANETS = """
parameters: {{m: 3 mm, s: 20, p: 25, J_S: 3 g m^2, J_C: 5 g m^2, J_P: 0.4 g m^2, M: 0.3 kg, T: 4 N m, L: 9 N m}}
ground: {{points: {{S: [0, 0]}}}}
bodies:
  sun: {{body: {{inertia: J_S, radius: m*s/2}}}}
  planet: {{body: {{mass: M, inertia: J_P, radius: m*p/2}}, copies: {n}}}
  carrier: {{body: {{inertia: J_C}}, points: {{axle: [m*(s + p)/2, 0]}}}}
  ring: {{ring: {{radius: m*(s + 2*p)/2}}, at: [0, 0], fixed: true}}
connections:
  a: {{pin: [ground.S, sun]}}
  b: {{pin: [ground.S, carrier]}}
  c: {{pin: [carrier.axle, planet]}}
  inner: {{gear_mesh: {{first: sun, second: planet, module: m, teeth: [s, p]}}}}
  outer: {{gear_mesh: {{first: ring, second: planet, internal: true, module: m, teeth: [s + 2*p, p]}}}}
loads: {{drive: {{torque: {{on: sun, magnitude: T}}}}, load: {{torque: {{on: carrier, magnitude: -L}}}}}}
measures: {{psi: angle of carrier}}
start: {{psi: 0, rate(psi): 7 rad/s}}
"""


@pytest.mark.parametrize("n", [2, 5])
def test_equal_planets_share_the_load_and_count_their_inertia(n: int) -> None:
    """i = 2 (s + p)/s, the planets turn by -(s + p)/p: all inertia by that of the carrier."""
    i, turn = "(2*(s + p)/s)", "((s + p)/p)"
    inertia = f"(J_C + J_S*{i}**2 + {n}*(M*(m*(s + p)/2)**2 + J_P*{turn}**2))"
    turned = f"((T*{i} - L)/{inertia})"
    model = PLANETS.format(n=n)
    is_formula(model, "acceleration of psi", turned)
    is_formula(model, "tooth force of inner", f"(T - J_S*{i}*{turned})/({n}*m*s/2)")
    is_formula(model, "kinetic energy at start", f"{inertia}*49/2")


WEDGE = """
parameters: {{W: 650 N, M: 3 kg, L: 30 cm, alpha: {angle} deg, mu: 0.15, nu: 0.3, rho: 0.1, F: 100 N, g: 9.81 m/s^2}}
ground: {{lines: {{floor: {{along: right}}, wall: {{along: down, through: [-L/2, 0]}}}}}}
bodies:
  wedge: {{polygon: {{mass: M, corners: [[0, 0], [-L, 0], [0, L*tan(alpha)]]}}, at: [0, 0], angle: 0}}
  load: {{particle: {{mass: W/g}}, at: [-L/2, L*tan(alpha)/2]}}
connections:
  floor: {{contact: {{between: [wedge, ground.floor], friction: mu, touching: true}}}}
  face: {{contact: {{between: [load, wedge], friction: nu, touching: true}}}}
  wall: {{contact: {{between: [load, ground.wall], friction: rho, touching: true}}}}
loads: {{w: {{gravity: g}}, drive: {{force: {{at: wedge.corner1, along: left, magnitude: F}}}}}}
"""


def at_limit(angle: float, way: int) -> float:
    """The force to drive it in (way 1) or at which it slips out (-1), all contacts at their limits: the face presses
    with N (n + way nu t), n = (-sin, cos), t = (-cos, -sin); the wall with R."""
    a = math.radians(angle)
    x, y = -math.sin(a) - way * 0.3 * math.cos(a), math.cos(a) - way * 0.3 * math.sin(a)
    normal = 650 / (y + way * 0.1 * x)  # R = -N x, N y - way rho R = W
    return -normal * x + way * 0.15 * (normal * y + 3 * 9.81)


def test_a_wedge_turned_round_is_driven_in_and_slips_out_at_the_limits_of_all_its_faces() -> None:
    flat, steep = (fb.System.from_text(WEDGE.format(angle=angle)) for angle in (9, 40))
    assert flat.solve("largest F so that it stays at rest")["q1"].value == pytest.approx(at_limit(9, 1))
    assert steep.solve("least F so that it stays at rest")["q1"].value == pytest.approx(at_limit(40, -1))
    # drawn out, the flat one takes the load along, off the wall: mu (W + M g)
    least = flat.solve("least F so that it stays at rest")["q1"].value
    assert least == pytest.approx(-0.15 * (650 + 3 * 9.81))


def test_a_steep_wedge_tips_before_it_slides_in() -> None:
    """X h = Y L/2 + M g L/3 about its far edge, h = L tan(alpha)/2; Y = W + rho X, F = X + mu (Y + M g)."""
    height = 0.15 * math.tan(math.radians(40))
    x = (650 * 0.15 + 3 * 9.81 * 0.1) / (height - 0.1 * 0.15)
    force = x + 0.15 * (650 + 0.1 * x + 3 * 9.81)
    found = fb.System.from_text(WEDGE.format(angle=40)).solve("largest F so that it stays at rest")["q1"].value
    assert found == pytest.approx(force)


MOTOR = """
parameters: {{T_0: 12 N m, W: 600 rpm, J: 300 kg cm^2, J_2: 0.09 kg m^2, T_L: 2 N m}}
bodies: {{frame: {{body: {{inertia: J_2, radius: 0.2 m}}}}, rotor: {{body: {{inertia: J, radius: 0.1 m}}}}}}
connections: {{a: {{pin: [ground.O, frame]}}, b: {{pin: [frame.origin, rotor.origin]}}}}
loads:
  motor: {{motor: {{on: rotor{reacts}, stall_torque: -T_0, no_load_speed: -W}}}}
  load: {{torque: {{on: rotor, magnitude: T_L}}}}
measures: {{phi: angle of rotor, psi: angle of frame}}
start: {{phi: 0, rate(phi): 0, psi: 0, rate(psi): 0}}
"""


def test_a_motor_that_runs_backwards_comes_near_to_the_speed_of_its_load() -> None:
    model = MOTOR.format(reacts="")
    is_formula(model, "terminal velocity of phi", "-W*(1 - T_L/T_0)")
    is_formula(model, "time when rate(phi) = -W/3", "J*W/T_0*log((T_0 - T_L)/(T_0 - T_L - T_0/3))", factors=(1.0,))


def test_a_motor_turns_what_carries_it_the_other_way() -> None:
    """u = phi' - psi': u' = -a (u - u_s) with a = T_0/W (1/J + 1/J_2); J phi' + J_2 psi' = T_L t."""
    system = fb.System.from_text(MOTOR.format(reacts=", reacts_on: frame"))
    rate = 12 / (20 * math.pi) * (1 / 0.03 + 1 / 0.09)
    steady = (-12 * (1 / 0.03 + 1 / 0.09) + 2 / 0.03) / rate
    data = system.simulate(until=0.5, tolerance=1e-11).dataset
    phi, psi = (float(np.asarray(data[name])[-1]) for name in ("phi", "psi"))
    assert phi - psi == pytest.approx(steady * (0.5 - (1 - math.exp(-rate * 0.5)) / rate), rel=1e-9)
    assert 0.03 * phi + 0.09 * psi == pytest.approx(2 * 0.5**2 / 2, rel=1e-9)


FALL = """
parameters: {{m: 400 g, c: 0.3 kg/s, k: 20 g/m, v: 12 m/s, H: 5 m, g: 9.81 m/s^2}}
bodies: {{ball: {{particle: {{mass: m}}}}}}
connections: {{guide: {{slider: {{body: ball, along: up}}}}}}
loads: {{w: {{gravity: g}}, air: {{drag: {{body: ball, {law}}}}}}}
measures: {{y: height of ball}}
start: {{y: {y}, rate(y): {rate}}}
"""


@pytest.mark.parametrize(
    ("law", "y", "rate", "question", "formula"),
    [
        ("quadratic: k", "0", "v", "greatest y", "m/(2*k)*log(1 + k*v^2/(m*g))"),
        ("quadratic: k", "0", "v", "time when rate(y) = 0", "sqrt(m/(k*g))*atan(v*sqrt(k/(m*g)))"),
        ("quadratic: k", "H", "0", "velocity of y when y = 0", "-sqrt(m*g/k*(1 - exp(-2*k*H/m)))"),
        ("quadratic: k", "H", "0", "terminal velocity of y", "-sqrt(m*g/k)"),
        ("linear: c", "0", "v", "greatest y", "m*v/c - m^2*g/c^2*log(1 + c*v/(m*g))"),
        ("linear: c", "0", "v", "terminal velocity of y", "-m*g/c"),
    ],
)
def test_a_ball_rises_and_falls_against_the_air(law: str, y: str, rate: str, question: str, formula: str) -> None:
    is_formula(FALL.format(law=law, y=y, rate=rate), question, formula)


THROW = """
parameters: {m: 400 g, c: 0.3 kg/s, v: 12 m/s, beta: 50 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {w: {gravity: g}, air: {drag: {body: ball, linear: c}}}
measures: {x: x of ball, y: height of ball}
start: {x: 0, y: 0, rate(x): v*cos(beta), rate(y): v*sin(beta)}
"""


def test_a_throw_against_linear_drag_has_its_range() -> None:
    """y = (m/c) (v sin + m g/c) (1 - e^(-c t/m)) - m g t/c vanishes; Newton's method."""
    m, c, g, up = 0.4, 0.3, 9.81, 12 * math.sin(math.radians(50))
    t = 2 * up / g
    for _ in range(60):
        fading = math.exp(-c * t / m)
        t -= (m / c * (up + m * g / c) * (1 - fading) - m * g * t / c) / ((up + m * g / c) * fading - m * g / c)
    reach = m / c * 12 * math.cos(math.radians(50)) * (1 - math.exp(-c * t / m))
    system = fb.System.from_text(THROW)
    assert system.solve("time when y = 0")["q1"].value == pytest.approx(t)
    assert system.solve("x when y = 0")["q1"].value == pytest.approx(reach)
    is_formula(THROW, "greatest y", "m*v*sin(beta)/c - m^2*g/c^2*log(1 + c*v*sin(beta)/(m*g))")
