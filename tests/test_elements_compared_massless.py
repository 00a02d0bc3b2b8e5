"""Gears, pulleys, rockers and shafts without mass, rollers on cams, bodies in contact in space and a coin that goes
round on its rim, beside what follows by hand."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from posed import is_formula

EXAMPLES = Path(__file__).parents[1] / "examples"

IDLE = """
parameters: {J_1: 0.2 kg m^2, J_2: 0.5 kg m^2, T: 6 N m, L: 2 N m, a: 10 cm, r: 4 cm, b: 20 cm}
ground: {points: {A: [0, 0], B: [a + r, 0], C: [a + 2*r + b, 0]}}
bodies: {one: {body: {inertia: J_1, radius: a}}, idle: {SHAPE}, two: {body: {inertia: J_2, radius: b}}}
connections:
  A: {pin: [ground.A, one]}
  B: {pin: [ground.B, idle]}
  C: {pin: [ground.C, two]}
  first: {gear_mesh: [one, idle]}
  second: {gear_mesh: [idle, two]}
loads: {t: {torque: {on: one, magnitude: T}}, l: {torque: {on: two, magnitude: -L}}}
measures: {phi: angle of one, psi: angle of two}
start: {phi: 0, rate(phi): 0}
"""
TURNED = "((T - L*a/b)/(J_1 + J_2*(a/b)^2))"


@pytest.mark.parametrize("shape", ["body: {radius: r}", "disk: {mass: 0, radius: r}"])
def test_an_idle_gear_without_mass_passes_the_force_on(shape: str) -> None:
    model = IDLE.replace("SHAPE", shape)
    is_formula(model, "acceleration of psi", f"{TURNED}*a/b")
    is_formula(model, "tooth force of first", f"(T - J_1*{TURNED})/a")
    is_formula(model, "tooth force of second", f"-(T - J_1*{TURNED})/a")
    (across, along) = fb.System.from_text(model).solve("reaction of B on idle")["q1"].value
    assert across == pytest.approx(0.0, abs=1e-12)
    turned = (6 - 2 / 2) / (0.2 + 0.5 / 4)
    assert abs(along) == pytest.approx(2 * (6 - 0.2 * turned) / 0.1)


PULLEYS = """
parameters: {m_1: 3 kg, m_2: 1 kg, m_3: 2 kg, r: 5 cm, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}}
bodies:
  p: {body: {radius: r}}
  q: {body: {radius: r}}
  a: {particle: {mass: m_1}}
  b: {particle: {mass: m_2}}
  c: {particle: {mass: m_3}}
connections: {A: {pin: [ground.A, p]}, one: {rope: [a, p, q]}, two: {rope: [b, q, c]}}
loads: {w: {gravity: g}}
measures: {y: drop of a}
start: {y: 0, rate(y): 0}
"""
ROCKER = """
parameters: {m_1: 2 kg, m_2: 3 kg, a: 0.4 m, b: 0.3 m, g: 9.81 m/s^2}
bodies:
  rocker: {body: {}, points: {l: [-a, 0], r: [b, 0]}, angle: 0}
  p: {particle: {mass: m_1}}
  q: {particle: {mass: m_2}}
connections: {O: {pin: [ground.O, rocker.origin]}, l: {pin: [rocker.l, p]}, r: {pin: [rocker.r, q]}}
loads: {w: {gravity: g}}
measures: {phi: angle of rocker}
start: {phi: 0, rate(phi): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # the pulley that hangs carries twice the force of its rope: it counts as 4 m_2 m_3/(m_2 + m_3)
        (PULLEYS, "acceleration of y", "g*(m_1*(m_2 + m_3) - 4*m_2*m_3)/(m_1*(m_2 + m_3) + 4*m_2*m_3)"),
        (PULLEYS, "tension of one", "8*g*m_1*m_2*m_3/(m_1*(m_2 + m_3) + 4*m_2*m_3)"),
        (ROCKER, "acceleration of phi at start", "(m_1*a - m_2*b)*g/(m_1*a^2 + m_2*b^2)"),
    ],
)
def test_what_has_no_mass_carries_and_passes_on(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


@pytest.mark.parametrize(
    ("middle", "inertia"), [("inertia: I", math.cos(math.radians(25)) ** 2), ("", 0.0)], ids=["heavy", "light"]
)
def test_the_shaft_between_two_cardan_joints_may_have_no_mass(middle: str, inertia: float) -> None:
    """T/(2 I + I_m cos(alpha)^2): at psi = 0 it turns by cos(alpha) of the others."""
    text = (EXAMPLES / "cardan_shaft_with_two_joints.yaml").read_text("utf-8").partition("questions:")[0]
    text = text.replace("middle: {body: {inertia: I}", f"middle: {{body: {{{middle}}}")
    text += "loads: {t: {torque: {on: drive, about: z, magnitude: 3 N m}}}\n"
    found = fb.System.from_text(text).solve("acceleration of psi at start")["q1"].value
    assert found == pytest.approx(3 / (0.01 * (2 + inertia)))


CAM = """
parameters: {{m: 0.5 kg, k: 3 kN/m, d: 5 mm, rb: 20 mm, L: {lift} mm, rr: {roller} mm, w: 20 rad/s}}
bodies: {{disk: {{body: {{inertia: 0.01 kg m^2}}}}, rod: {{particle: {{mass: m}}}}}}
connections:
  axle: {{pin: [ground.O, disk]}}
  motor: {{driver: {{measure: phi, follows: w*t}}}}
  guide: {{slider: {{body: rod, along: up}}}}
  cam:
    cam:
      {{cam: disk, follower: rod, base_radius: rb, lift: "L*(1 - cos(3*phi))/2", along: up, form: roller,
       roller_radius: rr}}
loads: {{spring: {{force: {{at: rod, along: down, magnitude: k*(d + y - rb - rr)}}}}}}
measures: {{phi: angle of disk from up, y: height of rod above ground.O}}
"""
PITCH = "(rb + rr + L/2)"  # radius of the pitch curve at phi = 30 deg, with the slope 3/2 L


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("pressure angle of cam when phi = pi/6", f"atan(3/2*L/{PITCH})"),
        ("contact force of cam when phi = pi/6", f"k*(d + L/2)*sqrt({PITCH}^2 + (3/2*L)^2)/{PITCH}"),
        # at the top y'' = -9/2 L w^2: the spring loses the roller beyond the speed at which that takes all its force
        ("contact force of cam when phi = pi/3", "k*(d + L) - 9/2*m*L*w^2"),
        ("value of w for which contact force of cam when phi = pi/3 = 0", "sqrt(2*k*(d + L)/(9*L*m))"),
    ],
)
def test_a_spring_keeps_a_roller_on_its_cam(question: str, formula: str) -> None:
    is_formula(CAM.format(lift=10, roller=3), question, formula)


def sharpest(lift: float, roller: float) -> float:
    """The least radius of curvature of the pitch curve [mm] where it bulges."""
    phi = np.linspace(0.0, 2.0 * math.pi / 3.0, 2001)
    r = 20.0 + roller + lift * (1.0 - np.cos(3.0 * phi)) / 2.0
    slope, bend = 1.5 * lift * np.sin(3.0 * phi), 4.5 * lift * np.cos(3.0 * phi)
    return float(1.0 / ((r * r + 2.0 * slope**2 - r * bend) / (r * r + slope**2) ** 1.5).max())


def test_a_roller_that_is_larger_than_the_curvature_undercuts_its_cam() -> None:
    """(r^2 + r'^2)^(3/2)/(r^2 + 2 r'^2 - r r'') of the pitch curve is not less than the roller."""
    lift = 40.0
    sizes = np.arange(1.0, 60.0, 0.5)
    largest = max(x for x in sizes if sharpest(lift, x) > x)
    fb.System.from_text(CAM.format(lift=lift, roller=largest))
    with pytest.raises(fb.ModelError):
        fb.System.from_text(CAM.format(lift=lift, roller=largest + 1.0))


LADDER = """
space: {{up: z}}
parameters: {{m: 12 kg, L: 5 m, alpha: 62 deg, mu: 0.5, g: 9.81 m/s^2}}
ground: {{planes: {{floor: {{normal: up}}, wall: {{normal: {wall}}}}}}}
bodies: {{ladder: {{rod: {{mass: m, length: L}}, turned: [{turned}]}}}}
connections:
  foot: {{contact: {{between: [ladder.start, ground.floor], friction: mu}}}}
  top: {{contact: {{between: [ladder.end, ground.wall]}}}}
loads: {{w: {{gravity: g}}}}
"""


@pytest.mark.parametrize(
    ("wall", "turned"), [("[-1, 0, 0]", "-alpha about y"), ("[0, 1, 0]", "-90 deg about z, -alpha about y")]
)
def test_a_ladder_in_space_stands_at_a_wall_as_in_the_plane(wall: str, turned: str) -> None:
    model = LADDER.format(wall=wall, turned=turned)
    is_formula(model, "least mu so that it stays at rest", "1/(2*tan(alpha))", factors=(1.0,))
    is_formula(model, "least alpha so that it stays at rest", "atan(1/(2*mu))", factors=(1.0,))
    force = fb.System.from_text(model).solve("normal force of top")["q1"].value
    assert force == pytest.approx(12 * 9.81 / (2 * math.tan(math.radians(62))))


BALL = """
space: {up: z}
parameters: {m: 2 kg, R: 10 cm, mu: 0.3, g: 9.81 m/s^2, v: 3 m/s, w: 20 rad/s}
ground: {planes: {floor: {normal: up}}}
bodies: {ball: {sphere: {mass: m, radius: R}, at: [0, 0, R], velocity: [v, 0, 0], angular_velocity: [-w, 0, 0]}}
connections: {c: {contact: {between: [ball, floor], friction: mu}}}
loads: {wt: {gravity: g}}
"""


def test_a_ball_with_side_spin_rolls_when_its_slip_is_used_up() -> None:
    """u = v + omega x (-R z) keeps its direction, u' = -7/2 mu g; at the end v - 2/7 u."""
    motion = fb.System.from_text(BALL).simulate(until=1, tolerance=1e-10)
    slip = np.array([3.0, 0.0, 0.0]) + np.cross([-20.0, 0.0, 0.0], [0.0, 0.0, -0.1])
    [event] = motion.events
    assert event.time == pytest.approx(np.linalg.norm(slip) / (3.5 * 0.3 * 9.81), rel=1e-9)
    velocity = np.asarray(motion.dataset["body_velocity"])[-1, 0]
    assert velocity == pytest.approx(np.array([3.0, 0.0, 0.0]) - 2 / 7 * slip, abs=1e-9)


def coin(text: str, until: float) -> tuple[np.ndarray, np.ndarray]:
    """sin(alpha), and omega^2 R/(4 g sin(alpha))."""
    data = fb.System.from_text(text).simulate(until=until, tolerance=1e-10).dataset
    lean = np.asarray(data["height"]) / 0.012
    spin = np.asarray(data["body_angular_velocity_in_body"])[:, 0]
    return lean, (spin**2).sum(axis=1) * 0.012 / (4 * 9.81 * lean)


def test_a_coin_goes_round_on_its_rim_by_the_relation_of_precession_and_lean() -> None:
    """Omega^2 sin(alpha) = 4 g/R and omega = Omega sin(alpha) along a diameter (Moffatt, Nature 404 (2000) 833): steady
    without losses, and kept on the whole while the losses let it sink."""
    text = (EXAMPLES / "coin_coming_to_rest.yaml").read_text("utf-8")
    lean, ratio = coin(text.replace(", rolling_resistance: 0.1 mm", ""), 0.2)
    assert lean == pytest.approx(math.sin(math.radians(25)), rel=1e-7)
    assert ratio == pytest.approx(1.0, rel=1e-7)
    lean, ratio = coin(text, 0.5)
    assert lean[-1] < 0.85 * lean[0]
    assert float(ratio.mean()) == pytest.approx(1.0, abs=0.05)
