"""Mechanisms of the literature, each with the numbers of its vector loops, which are solved here by circles and by
differences, or with the formula of its textbook."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import fsolve

import freebody as fb

DEG = math.pi / 180


def value(model: str, question: str) -> float | tuple[float, ...]:
    found = fb.System.from_text(model).solve(question)["q1"].value
    assert isinstance(found, float | tuple), question
    return found


def meeting(a: complex, r: float, b: complex, s: float, side: int) -> complex:
    """Where two circles meet; side 1: on the left of the way from a to b."""
    d = abs(b - a)
    along = (r * r - s * s + d * d) / (2 * d)
    return a + (b - a) / d * complex(along, side * math.sqrt(r * r - along * along))


def slope(f: Callable[[float], complex], x: float, h: float = 1e-5) -> complex:
    """f' by central differences of the fourth order."""
    return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h)


# Peaucellier 1864: an inverter; with O on the circle of B the image P of B is on a line, x = (L^2 - s^2)/(2 a)
PEAUCELLIER = """
parameters: {a: 0.25 m, L: 0.7 m, s: 0.25 m, omega: 2 rad/s}
ground: {points: {O: [0, 0], A: [a, 0]}}
bodies:
  crank: {rod: {length: a}}
  upper: {rod: {length: L}, near: {angle: 45 deg}}
  lower: {rod: {length: L}, near: {angle: 0 deg}}
  BC: {rod: {length: s}, near: {angle: 90 deg}}
  BD: {rod: {length: s}, near: {angle: -45 deg}}
  CP: {rod: {length: s}, near: {angle: -45 deg}}
  DP: {rod: {length: s}, near: {angle: 90 deg}}
connections:
  A: {pin: [ground.A, crank.start]}
  O: {pin: [ground.O, upper.start, lower.start]}
  B: {pin: [crank.end, BC.start, BD.start]}
  C: {pin: [upper.end, BC.end, CP.start]}
  D: {pin: [lower.end, BD.end, DP.start]}
  P: {pin: [CP.end, DP.end]}
measures: {phi: angle of crank, x: x of DP.end, y: y of DP.end}
start: {phi: 40 deg, rate(phi): omega}
"""


def test_peaucelliers_point_runs_along_a_line() -> None:
    """Draws of the lengths for which the rhombus folds over on the way are no counterexamples."""
    line = (0.7**2 - 0.25**2) / (2 * 0.25)
    solution = fb.System.from_text(PEAUCELLIER).solve(
        ["x at start", "velocity of x at start", "velocity of y at start"]
    )
    found = [a.value for a in solution.answers]
    expected = [line, 0.0, line / (2 * math.cos(20 * DEG) ** 2) * 2]  # y = line tan(phi/2)
    assert found == pytest.approx(expected, abs=1e-9)


# Norton, Design of Machinery, sec. 14: the wheel turns by tan psi = r sin phi/(d - r cos phi)
GENEVA = """
parameters: {d: 0.1 m, r: 0.06 m, J: 0.002 kg m^2, omega: 5 rad/s}
ground: {points: {O: [0, 0], W: [d, 0]}}
bodies: {crank: {rod: {length: r}}, wheel: {body: {inertia: J}}}
connections:
  O: {pin: [ground.O, crank.start]}
  W: {pin: [ground.W, wheel]}
  slot: {slot: {pin: crank.end, on: wheel, along: wheel.x}}
  motor: {driver: {measure: phi, follows: 20 deg + omega*t}}
measures: {phi: angle of crank, psi: angle of wheel}
"""


def test_a_geneva_wheel_in_engagement_has_its_speed_acceleration_and_torque() -> None:
    def psi(phi: float) -> complex:
        return -math.atan2(0.06 * math.sin(phi), 0.1 - 0.06 * math.cos(phi))

    speed = 5 * slope(psi, 20 * DEG).real
    acceleration = 25 * slope(lambda x: slope(psi, x, 1e-4), 20 * DEG, 1e-4).real
    assert value(GENEVA, "velocity of psi at start") == pytest.approx(speed, rel=1e-8)
    assert value(GENEVA, "acceleration of psi at start") == pytest.approx(acceleration, rel=1e-6)
    assert value(GENEVA, "driving torque of motor at start") == pytest.approx(
        0.002 * acceleration * speed / 5, rel=1e-6
    )


# Bedford & Fowler, Statics: virtual power of a knee of two equal bars, F L cos(a) da = 2 Q L sin(a) da
TOGGLE = """
parameters: {L: 0.4 m, alpha: 12 deg, F: 500 N, m: 10 kg, Q: 1000 N}
ground: {points: {O: [0, 0]}}
bodies:
  upper: {rod: {length: L}, near: {angle: -80 deg}}
  lower: {rod: {length: L}, near: {angle: -100 deg}}
  ram: {particle: {mass: m}}
connections:
  O: {pin: [ground.O, upper.start]}
  knee: {pin: [upper.end, lower.start]}
  foot: {pin: [lower.end, ram]}
  guide: {slider: {body: ram, along: down, through: ground.O}}
loads:
  push: {force: {at: upper.end, along: left, magnitude: F}}
  work: {force: {at: ram, along: up, magnitude: Q}}
measures: {theta: angle of upper from down, y: drop of ram below ground.O}
start: {theta: alpha}
"""


def test_a_toggle_press_balances_by_virtual_power() -> None:
    force = 500 / (2 * math.tan(12 * DEG))
    assert value(TOGGLE, "value of Q for which acceleration of y at start = 0") == pytest.approx(force, rel=1e-9)
    assert value(TOGGLE, "normal force of guide at start") == pytest.approx(250.0, rel=1e-9)


# Beer & Johnston, ch. 10: n stages lift W by n L sin(theta) while the foot moves L cos(theta): F = n W/tan(theta)
SCISSOR = """
parameters: {L: 1 m, W: 2 kN, theta0: 35 deg, F: 1 kN}
ground: {points: {A: [0, 0]}}
bodies:
  a1: {rod: {length: L}, near: {angle: 35 deg}}
  b1: {rod: {length: L}, near: {angle: 145 deg}}
  a2: {rod: {length: L}, near: {angle: 35 deg}}
  b2: {rod: {length: L}, near: {angle: 145 deg}}
  table: {rectangle: {mass: 20 kg, width: L, height: 5 cm}, points: {l: [-L/2, 0]}}
connections:
  A: {pin: [ground.A, a1.start]}
  B: {slot: {pin: b1.start, along: right, through: ground.A}}
  M1: {pin: [a1.center, b1.center]}
  R1: {pin: [a1.end, b2.start]}
  L1: {pin: [b1.end, a2.start]}
  M2: {pin: [a2.center, b2.center]}
  T: {pin: [table.l, b2.end]}
  U: {slot: {pin: a2.end, on: table, along: table.x, through: table.l}}
loads:
  load: {force: {at: table, along: down, magnitude: W}}
  actuator: {force: {at: b1.start, along: left, magnitude: F}}
measures: {theta: angle of a1, h: height of table above ground.A}
start: {theta: theta0}
"""


def test_a_scissor_lift_needs_more_force_the_lower_it_is() -> None:
    assert value(SCISSOR, "degrees of freedom") == 1
    force = 2 * 2000 / math.tan(35 * DEG)
    assert value(SCISSOR, "value of F for which acceleration of h at start = 0") == pytest.approx(force, rel=1e-9)
    assert value(SCISSOR, "ratio of velocity of h to rate of theta at start") == pytest.approx(2 * math.cos(35 * DEG))


# Hunt, Kinematic Geometry: the disk of an Oldham coupling goes round the circle over the offset twice in a turn
OLDHAM = """
parameters: {e: 20 mm, J: 0.01 kg m^2, m: 2 kg, omega: 10 rad/s}
ground: {points: {A: [0, 0], B: [e, 0]}}
bodies:
  first: {body: {inertia: J}}
  second: {body: {inertia: J}, angle: 30 deg}
  floating: {disk: {mass: m, radius: 40 mm}, angle: 30 deg}
connections:
  A: {pin: [ground.A, first]}
  B: {pin: [ground.B, second]}
  one: {slider: {body: floating, on: first, along: first.x}}
  two: {slider: {body: floating, on: second, along: second.y}}
  motor: {driver: {measure: phi, follows: 30 deg + omega*t}}
measures: {phi: angle of first}
"""


def test_an_oldham_coupling_passes_on_an_even_turn_and_its_disk_runs_on_a_circle() -> None:
    assert value(OLDHAM, "ratio of angular velocity of second to angular velocity of first") == 1
    assert value(OLDHAM, "speed of floating at start") == pytest.approx(0.02 * 10, rel=1e-9)
    assert value(OLDHAM, "size of acceleration of floating at start") == pytest.approx(0.01 * 20**2, rel=1e-9)
    force = 2 * 0.01 * 20**2 * math.cos(60 * DEG)  # the part across the slot of the first
    assert value(OLDHAM, "size of reaction of A at start") == pytest.approx(force, rel=1e-9)


# Craig, Introduction to Robotics, sec. 6.7, with uniform rods and a load at the hand
SCARA = """
parameters: {L1: 0.4 m, L2: 0.3 m, m1: 5 kg, m2: 3 kg, m: 2 kg, w1: 2 rad/s, w2: 1 rad/s, a1: 3 rad/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  upper: {rod: {mass: m1, length: L1}}
  fore: {rod: {mass: m2, length: L2}}
  load: {particle: {mass: m}}
connections:
  shoulder: {pin: [ground.O, upper.start]}
  elbow: {pin: [upper.end, fore.start]}
  hand: {pin: [fore.end, load]}
  d1: {driver: {measure: q1, follows: 20 deg + w1*t + a1*t^2/2}}
  d2: {driver: {measure: q2, follows: 50 deg + w2*t}}
measures: {q1: angle of upper, q2: angle of fore relative to upper}
"""


def test_the_drives_of_two_arms_have_the_torques_of_their_equations() -> None:
    inertia = 3 * 0.3**2 / 3 + 2 * 0.3**2
    coupling = (3 / 2 + 2) * 0.4 * 0.3
    c, s = math.cos(50 * DEG), math.sin(50 * DEG)
    m11 = 5 * 0.4**2 / 3 + (3 + 2) * 0.4**2 + inertia + 2 * coupling * c
    first = m11 * 3 - coupling * s * (2 * 2 * 1 + 1)
    second = (inertia + coupling * c) * 3 + coupling * s * 2**2
    assert value(SCARA, "driving torque of d1 at start") == pytest.approx(first, rel=1e-9)
    assert value(SCARA, "driving torque of d2 at start") == pytest.approx(second, rel=1e-9)


STEPHENSON = """
ground: {points: {A: [0, 0], D: [0.5 m, 0], G: [0.75 m, 0.35 m]}}
bodies:
  crank: {rod: {mass: 1 kg, length: 0.15 m}}
  coupler:
    body: {mass: 2 kg, inertia: 0.03 kg m^2}
    points: {B: [0, 0], C: [0.4 m, 0], P: [0.3 m, 0.25 m]}
    near: {angle: 30 deg}
  rocker: {rod: {mass: 1 kg, length: 0.35 m}, near: {angle: 100 deg}}
  link: {rod: {mass: 1 kg, length: 0.4 m}, near: {angle: 20 deg}}
  out: {rod: {mass: 1 kg, length: 0.3 m}, near: {angle: 90 deg}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.B]}
  C: {pin: [coupler.C, rocker.end]}
  D: {pin: [ground.D, rocker.start]}
  P: {pin: [coupler.P, link.start]}
  F: {pin: [link.end, out.end]}
  G: {pin: [ground.G, out.start]}
  motor: {driver: {measure: phi, follows: 50 deg + (4 rad/s)*t}}
measures: {phi: angle of crank}
"""


def test_a_stephenson_six_bar_has_the_speeds_of_its_loops_and_the_torque_of_its_power() -> None:
    def pose(phi: float) -> tuple[complex, ...]:
        """Joints B, C, P, F."""
        b = 0.15 * np.exp(1j * phi)
        c = meeting(b, 0.4, 0.5 + 0j, 0.35, 1)
        p = b + (0.3 + 0.25j) * (c - b) / 0.4
        return b, c, p, meeting(p, 0.4, 0.75 + 0.35j, 0.3, 1)

    def out(phi: float) -> complex:
        return float(np.angle(pose(phi)[3] - (0.75 + 0.35j)))

    def energy(phi: float) -> complex:
        """At 1 rad/s of the crank; a rod has that of its ends: m (a^2 + a b + b^2)/6."""
        v = [slope(lambda x, k=k: pose(x)[k], phi, 1e-4) for k in range(4)]

        def rod(x: complex, y: complex) -> float:
            return (abs(x) ** 2 + (x * y.conjugate()).real + abs(y) ** 2) / 6

        b, c, _p, _f = pose(phi)
        turn = ((v[1] - v[0]) / (1j * (c - b))).real
        body = abs(v[0]) ** 2 + 0.03 * turn**2 / 2  # the mass centre is at B
        return rod(0, v[0]) + body + rod(0, v[1]) + rod(v[2], v[3]) + rod(0, v[3])

    at = 50 * DEG
    system = fb.System.from_text(STEPHENSON)
    asked = [
        "angular velocity of out at start",
        "angular acceleration of out at start",
        "driving torque of motor at start",
    ]
    found = [a.value for a in system.solve(asked).answers]
    speed = 4 * slope(out, at).real
    acceleration = 16 * slope(lambda x: slope(out, x, 1e-4), at, 1e-4).real
    torque = 16 * slope(energy, at, 1e-3).real
    assert found == pytest.approx([speed, acceleration, torque], rel=1e-5)


# Jansen's numbers, in centimetres
JANSEN = """
ground: {points: {O: [0, 0], B: [-38 cm, -7.8 cm]}}
bodies:
  crank: {rod: {length: 15 cm}}
  j: {rod: {length: 50 cm}, near: {angle: 150 deg}}
  k: {rod: {length: 61.9 cm}, near: {angle: 225 deg}}
  upper:
    body: {mass: 1 kg, inertia: 0.1 kg m^2}
    points: {B: [0, 0], C: [0, 41.5 cm], D: [-40.1 cm, 0]}
    near: {at: [-38 cm, -7.8 cm]}
  c: {rod: {length: 39.3 cm}, near: {angle: -90 deg}}
  f: {rod: {length: 39.4 cm}, near: {angle: -90 deg}}
  foot:
    body: {mass: 1 kg, inertia: 0.1 kg m^2}
    points: {G: [0, 0], H: [36.7 cm, 0], F: [0, -49 cm]}
    near: {angle: 0 deg}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, j.start, k.start]}
  B: {pin: [ground.B, upper.B, c.start]}
  C: {pin: [j.end, upper.C]}
  D: {pin: [upper.D, f.start]}
  E: {pin: [k.end, c.end, foot.H]}
  G: {pin: [f.end, foot.G]}
measures: {phi: angle of crank, x: x of foot.F}
start: {phi: 30 deg, rate(phi): 2 rad/s}
"""


def jansen(phi: float) -> complex:
    """The foot by circles, the legs' triangles with right angles."""
    a, pivot = 0.15 * np.exp(1j * phi), -0.38 - 0.078j
    c = meeting(pivot, 0.415, a, 0.5, 1)
    d = pivot + 0.401j * (c - pivot) / 0.415
    e = meeting(pivot, 0.393, a, 0.619, -1)
    g = meeting(d, 0.394, e, 0.367, -1)
    return complex(g + 0.49 * (e - g) / 0.367 * -1j)


def test_the_foot_of_jansens_leg_is_where_its_circles_meet() -> None:
    """Three dyads, one after the other."""
    place = jansen(30 * DEG)
    assert value(JANSEN, "position of foot.F at start") == pytest.approx((place.real, place.imag), rel=1e-9)
    assert value(JANSEN, "velocity of x at start") == pytest.approx(2 * slope(jansen, 30 * DEG).real, rel=1e-7)


def test_circles_meet_where_the_equations_say() -> None:
    """The oracle by another route."""
    found = meeting(0.1 + 0.2j, 0.5, 0.7 - 0.1j, 0.4, 1)

    def gaps(x: np.ndarray) -> list[float]:
        z = complex(*x)
        return [abs(z - (0.1 + 0.2j)) - 0.5, abs(z - (0.7 - 0.1j)) - 0.4]

    assert complex(*fsolve(gaps, [found.real + 0.01, found.imag + 0.01])) == pytest.approx(found, abs=1e-9)
