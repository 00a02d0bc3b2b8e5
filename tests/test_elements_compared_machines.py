"""Screws and worms in motion, cams, telescopes, controllers and braked cars beside what follows by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from posed import is_formula

SCREW = """
space: {{up: z}}
parameters: {{m: 80 kg, T: {torque}, p: 6 mm, r: 12 mm, mu: {mu}, g: 9.81 m/s^2}}
ground: {{points: {{N: [0, 0, 0]}}}}
bodies: {{screw: {{cylinder: {{mass: m, radius: r, length: 100 mm}}}}}}
connections: {{thread: {{screw: {{first: ground.N, second: screw, about: z, pitch: p, friction: mu, radius: r}}}}}}
loads: {{w: {{gravity: g}}, lever: {{torque: {{on: screw, about: z, magnitude: T}}}}}}
measures: {{phi: angle of screw about z}}
start: {{phi: 0, rate(phi): 0}}
"""
LEAD = "atan(p/(2*pi*r))"


def run_up(torque: float, mu: float, way: int) -> float:
    """phi'': N normal to the thread, m z'' = N (cos - way mu sin) - m g, I phi'' = T - r N (sin + way mu cos), with
    z'' = phi'' p/(2 pi)."""
    m, p, r, g = 80.0, 0.006, 0.012, 9.81
    lead = math.atan(p / (2 * math.pi * r))
    arm = r * (math.sin(lead) + way * mu * math.cos(lead)) / (math.cos(lead) - way * mu * math.sin(lead))
    return (torque - arm * m * g) / (m * r * r / 2 + arm * m * p / (2 * math.pi))


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("largest T so that it stays at rest", f"m*g*r*tan({LEAD} + atan(mu))"),
        ("least T so that it stays at rest", f"m*g*r*tan({LEAD} - atan(mu))"),
        ("efficiency of thread", f"tan({LEAD})/tan({LEAD} + atan(mu))"),
    ],
)
def test_a_screw_is_held_raised_and_lowered_by_its_angle_of_friction(question: str, formula: str) -> None:
    is_formula(SCREW.format(torque="1 N m", mu=0.15), question, formula)


@pytest.mark.parametrize(("torque", "mu", "way"), [(4.0, 0.15, 1), (0.01, 0.05, -1)])
def test_a_screw_that_runs_is_slowed_by_its_thread(torque: float, mu: float, way: int) -> None:
    system = fb.System.from_text(SCREW.format(torque=f"{torque} N m", mu=mu))
    assert system.solve("acceleration of phi")["q1"].value == pytest.approx(run_up(torque, mu, way))


def test_a_screw_that_runs_is_derived() -> None:
    """It makes many turns in the time for which an endless phase is looked at, and a rotation vector is singular at
    each: the lines are compared within the first."""
    found = fb.explain(fb.System.from_text(SCREW.format(torque="4 N m", mu=0.15)), "acceleration of phi")
    assert [derivation.reason for derivation in found.derivations] == [""]


CAM = """
parameters: {{m: 0.5 kg, k: 2 kN/m, d: 10 mm, rb: {base}, L: 24 mm, w: 20 rad/s, g: 9.81 m/s^2}}
bodies: {{disk: {{body: {{inertia: 0.01 kg m^2}}}}, rod: {{particle: {{mass: m}}}}}}
connections:
  axle: {{pin: [ground.O, disk]}}
  motor: {{driver: {{measure: phi, follows: w*t}}}}
  guide: {{slider: {{body: rod, along: up}}}}
  cam: {{cam: {{cam: disk, follower: rod, base_radius: rb, lift: "L*(1 - cos(2*phi))/2", along: up, form: {form}}}}}
loads: {{spring: {{force: {{at: rod, along: down, magnitude: k*(d + y - rb)}}}}, weight: {{gravity: g}}}}
measures: {{phi: angle of disk from up, y: height of rod above ground.O}}
"""
PUSH = "(m*g + k*(d + L/2))"  # at phi = 45 deg: r = rb + L/2, r' = L, r'' = 0


@pytest.mark.parametrize(
    ("form", "question", "formula"),
    [
        ("edge", "pressure angle of cam when phi = pi/4", "atan(L/(rb + L/2))"),
        ("edge", "contact force of cam when phi = pi/4", f"{PUSH}*sqrt((rb + L/2)**2 + L**2)/(rb + L/2)"),
        ("edge", "driving torque of motor when phi = pi/4", f"{PUSH}*L"),
        ("edge", "greatest pressure angle of cam", "atan(L/sqrt(rb*(rb + L)))"),  # r'/r, r = rb + L sin(phi)^2
        ("flat", "contact force of cam when phi = pi/4", PUSH),
    ],
)
def test_an_oval_cam_pushes_its_follower(form: str, question: str, formula: str) -> None:
    is_formula(CAM.format(base="40 mm", form=form), question, formula)


def test_a_flat_faced_cam_is_undercut_below_a_base_radius_that_is_told() -> None:
    """rho = r + r'' = rb + L/2 + 3/2 L cos(2 phi), least rb - L."""
    with pytest.raises(fb.ModelError, match=r"at least 0\.024 m"):
        fb.System.from_text(CAM.format(base="20 mm", form="flat"))
    fb.System.from_text(CAM.format(base="24.5 mm", form="flat"))


TELESCOPE = """
parameters: {m: 4 kg, w: 0.5 rad/s, u: 0.2 m/s, L: 1.5 m, g: 9.81 m/s^2, M: 10 kg}
ground: {points: {O: [0, 0]}}
bodies: {tube: {rod: {mass: M, length: L}}, tip: {particle: {mass: m}}}
connections:
  O: {pin: [ground.O, tube.start]}
  turn: {driver: {measure: th, follows: w*t}}
  guide: {slot: {pin: tip, on: tube, along: right}}
  out: {driver: {measure: s, follows: L + u*t}}
loads: {weight: {gravity: g}}
measures: {th: angle of tube, s: distance from ground.O to tip}
"""


@pytest.mark.parametrize(
    ("question", "value"),
    [
        ("driving torque of turn at t = 2 s", 2 * 4 * 1.9 * 0.2 * 0.5 + (4 * 1.9 + 10 * 0.75) * 9.81 * math.cos(1.0)),
        ("driving force of out at t = 2 s", 4 * (9.81 * math.sin(1.0) - 1.9 * 0.25)),
        ("size of acceleration of tip at t = 2 s", math.hypot(1.9 * 0.25, 2 * 0.2 * 0.5)),
    ],
)
def test_a_telescope_needs_the_torque_of_coriolis(question: str, value: float) -> None:
    """2 m s s' theta' and the weights; s'' - s theta'^2 along it."""
    assert fb.System.from_text(TELESCOPE).solve(question)["q1"].value == pytest.approx(value)


PID = """
parameters: {m: 2 kg, c: 3 N s/m, kp: 60 N/m, kd: 14 N s/m, ki: 40 N/(m s), r: 0.5 m}
ground: {lines: {rail: {along: right}}}
bodies: {car: {particle: {mass: m}}}
connections: {rail: {slider: {body: car, along: rail}}}
loads:
  drag: {law: {measure: x, force: -c*rate(x)}}
  control: {force: {at: car, along: right, magnitude: kp*(r - x) - kd*rate(x) - ki*z}}
states: {z: x - r}
measures: {x: x of car}
start: {x: 0, rate(x): 0}
"""


def test_a_position_controller_answers_a_step_as_its_transfer_function_does() -> None:
    """X/r = (kp s + ki)/(m s^3 + (c + kd) s^2 + kp s + ki); scipy.signal is the second way."""
    signal = pytest.importorskip("scipy.signal")
    system = fb.System.from_text(PID)
    data = system.simulate(until=3, tolerance=1e-10).dataset
    times = np.asarray(data["time"])
    _, wanted = signal.step(([60, 40], [2, 17, 60, 40]), T=np.linspace(0, float(times[-1]), 20001))
    at = np.interp(times, np.linspace(0, float(times[-1]), 20001), wanted)
    assert np.asarray(data["x"]) == pytest.approx(0.5 * at, abs=1e-7)
    is_formula(PID, "largest ki so that the steady motion is stable", "kp*(c + kd)/m")


CAR = """
parameters: {{m: 1200 kg, a: 1.1 m, b: 1.5 m, h: 0.55 m, mu: 0.8, beta: 10 deg, g: 9.81 m/s^2}}
ground: {{lines: {{road: {{along: beta}}}}}}
bodies: {{car: {{body: {{mass: m, inertia: 1500 kg m^2}}, points: {{front: [a, -h], rear: [-b, -h]}}}}}}
connections:
  f: {{contact: {{between: [car.front, road]{front}}}}}
  r: {{contact: {{between: [car.rear, road]{rear}}}}}
loads: {{w: {{gravity: g}}}}
measures: {{x: travel of car along road}}
start: {{x: 0, rate(x): 20 m/s}}
"""


@pytest.mark.parametrize(
    ("braked", "share"),
    [
        ("rear", "mu*a/(a + b + mu*h)"),
        ("front", "mu*b/(a + b - mu*h)"),
        ("both", "mu"),
    ],
)
def test_a_car_brakes_uphill_by_the_wheels_that_lock(braked: str, share: str) -> None:
    """Moments about the other axle: the load that shifts forward is m |x''| h/(a + b)."""
    rub = ", friction: mu"
    model = CAR.format(front=rub * (braked != "rear"), rear=rub * (braked != "front"))
    found = fb.System.from_text(model).solve("acceleration of x")["q1"].value
    numbers = {"mu": 0.8, "a": 1.1, "b": 1.5, "h": 0.55}
    part = eval(share, {"__builtins__": {}}, numbers)
    slope = math.radians(10)
    assert found == pytest.approx(-9.81 * (math.sin(slope) + part * math.cos(slope)))
