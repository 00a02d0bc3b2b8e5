"""Spheres that roll on and inside spheres in space, beside closed forms.

With n from the middle of the bowl to that of the ball, rho = R - r the distance of both and sigma = omega . n, which is
constant, rolling says omega = -(rho/r) n x n' + sigma n, and the moments about the point of contact are

    7/5 rho n x n'' = 2/5 r sigma n' - g n x up.

Steady circling at the angle theta from the vertical, n' = Omega up x n, therefore needs

    7 rho Omega^2 cos(theta) - 2 r sigma Omega - 5 g = 0,    N = m (g cos(theta) + rho Omega^2 sin(theta)^2),

and without spin and theta small Omega is the frequency of small oscillations. On a dome, from rest at the top,
7/10 v^2 = g (R + r) (1 - cos(phi)), and it parts where v^2/(R + r) = g cos(phi): at cos(phi) = 10/17. Source: Routh,
Dynamics of a System of Rigid Bodies, Advanced Part, 1884, sec. 224; Meriam & Kraige, Dynamics, sec. 6/6.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

import freebody as fb
from freebody.narrative.explain import explain
from freebody.study.setup import Setup

Agree = Callable[[fb.Solution, str, str], None]
G, R, r = 9.81, 0.4, 0.05
BOWL = """
freebody: 1
space: {SPACE}
parameters: {m: 0.5 kg, r: 0.05 m, R: 0.4 m, g: 9.81 m/s^2}
bodies:
  bowl: {spherical_shell: {mass: 1 kg, radius: R}, fixed: true}
  ball: {sphere: {mass: m, radius: r}, at: AT}
connections: {contact: {rolling: {body: ball, inside: bowl}}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("up", "at"), [("true", "[0, r - R, 0]"), pytest.param("{up: z}", "[0, 0, r - R]", marks=pytest.mark.slow)]
)
def test_small_oscillations_in_a_bowl_have_a_closed_form(up: str, at: str, agrees: Agree) -> None:
    system = fb.System.from_text(BOWL.replace("{SPACE}", up).replace("AT", at))
    solution = system.solve("period of small oscillations")
    [period] = solution.answers
    assert period.value == pytest.approx(2 * math.pi * math.sqrt(7 * (R - r) / (5 * G)), rel=1e-12)
    agrees(solution, "q1", "2*pi*sqrt(7*(R - r)/(5*g))")


@pytest.mark.parametrize(("theta", "turns"), [(0.5, 7.0), (1.2, 10.0), (1.9, -6.0)])
def test_ball_circles_steadily_in_a_bowl_as_routh_says(theta: float, turns: float) -> None:
    """Also above the equator, where it leans on its spin alone."""
    rho = R - r
    sigma = (7 * rho * turns**2 * math.cos(theta) - 5 * G) / (2 * r * turns)
    up, radial = np.array((0.0, 1.0, 0.0)), np.array((1.0, 0.0, 0.0))
    n = math.sin(theta) * radial - math.cos(theta) * up
    rate = turns * np.cross(up, n)
    omega = -(rho / r) * np.cross(n, rate) + sigma * n
    at, velocity, spin = ([float(x) for x in v] for v in (rho * n, rho * rate, omega))
    start = f"{at}, velocity: {velocity}, angular_velocity: {spin}"
    system = fb.System.from_text(BOWL.replace("{SPACE}", "true").replace("AT", start))
    found = system.simulate(2.0)
    assert found.t_end == 2.0
    places, at_end = found.course.poses[:, 0], 2.0 * turns
    assert np.allclose(places[:, 1], rho * n[1], rtol=0.0, atol=1e-7)
    around = np.array((math.sin(theta) * math.cos(at_end), -math.cos(theta), -math.sin(theta) * math.sin(at_end)))
    assert places[-1] == pytest.approx(rho * around, abs=1e-6)
    normal = 0.5 * (G * math.cos(theta) + rho * (turns * math.sin(theta)) ** 2)
    assert normal_force(system) == pytest.approx(normal, rel=1e-9)


def normal_force(system: fb.System) -> float:
    setup = Setup(system)
    (row,) = (row for row in system.constraint_rows if row.component == "contact")
    start = setup.draws[0].start()
    return row.sign * start.multiplier(row)


DOME = """
space: true
parameters: {r: 0.05 m, R: 0.4 m, phi: 0.01, turn: 25 deg}
bodies:
  dome: {sphere: {mass: 1 kg, radius: R}, FIXED}
  ball:
    sphere: {mass: 0.5 kg, radius: r}
    at: [(R + r)*sin(phi)*cos(turn), (R + r)*cos(phi), (R + r)*sin(phi)*sin(turn)]
connections: {contact: {rolling: {body: ball, on: dome}}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""


def test_ball_parts_from_a_dome_on_which_it_rolls_at_ten_seventeenths() -> None:
    found = fb.System.from_text(DOME.replace("FIXED", "fixed: true")).simulate(3.0)
    (parts,) = (event for event in found.course.events if event.kind == "parts")
    at = int(np.searchsorted(found.course.times, parts.time))
    x, y, z = found.course.poses[at, 0]
    assert y / (R + r) == pytest.approx(10 / 17 * math.cos(0.01), abs=1e-5)
    assert z / x == pytest.approx(math.tan(math.radians(25)), rel=1e-6)


def test_ball_in_a_free_bowl_leaves_the_mass_centre_of_both_where_it_is() -> None:
    """Without weight: each turns the other, and they stay together."""
    model = BOWL.replace("{SPACE}", "true").replace(", fixed: true", "").replace("loads: {weight: {gravity: g}}", "")
    start = "[R - r, 0, 0], velocity: [0, 1.2, 0.5], angular_velocity: [3, 0, 0]"
    system = fb.System.from_text(model.replace("AT", start))
    found = system.simulate(1.0)
    which = [body.name for body in system.moving]
    ball, bowl = (found.course.poses[:, which.index(name)] for name in ("ball", "bowl"))
    assert np.linalg.norm(ball - bowl, axis=1) == pytest.approx(R - r, abs=1e-8)
    drift = np.diff((bowl + 0.5 * ball) / 1.5, axis=0) / np.diff(found.course.times)[:, None]
    assert drift == pytest.approx(np.tile(drift[0], (len(drift), 1)), abs=1e-8)
    assert np.ptp(ball, axis=0).min() > 0.01


ON_A_SPRING = """
space: {up: z}
parameters: {m: 0.5 kg, r: 5 cm, k: 40 N/m, L: 0.3 m, mu: 0.4}
ground: {planes: {floor: {normal: up}}, points: {A: [-L, 0, r]}}
bodies:
  ball:
    sphere: {mass: m, radius: r}
    at: [0, 0, r]
    turned: [yaw about z, pitch about y, roll about x]
    points: {mark: [r, 0, 0]}
connections: {touch: {contact: {between: [ball, floor], friction: mu}}}
loads: {weight: {gravity: 9.81 m/s^2}, spring: {spring: {between: [ground.A, ball], stiffness: k, length: L}}}
start: {yaw: 0, pitch: 0, roll: 0}
"""


def test_marked_ball_that_sticks_to_the_floor_swings_on_a_spring_with_seven_fifths_of_its_mass(agrees: Agree) -> None:
    solution = fb.System.from_text(ON_A_SPRING).solve("period of small oscillations")
    agrees(solution, "q1", "2*pi*sqrt(7*m/(5*k))")
    assert "for motions so small that touch does not slip" in solution.answers[0].notes


@pytest.mark.slow
def test_ball_that_sticks_in_a_bowl_swings_as_one_that_rolls() -> None:
    """In numbers: the frame of the contact makes the formula longer than the other's."""
    model = BOWL.replace("{SPACE}", "true").replace("AT", "[0, r - R, 0]")
    rough = model.replace(
        "rolling: {body: ball, inside: bowl}", "contact: {between: [ball, inside bowl], friction: 0.4}"
    )
    [period] = fb.System.from_text(rough).solve("period of small oscillations").answers
    assert period.value == pytest.approx(2 * math.pi * math.sqrt(7 * (R - r) / (5 * G)), rel=1e-9)
    assert "more than 60000 terms" in str(period.reason)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("language", "principle"), [("en", "roll without slipping"), ("de", "rollen, ohne zu gleiten")]
)
def test_small_swinging_in_a_bowl_is_derived_from_the_constraint_of_rolling(language: str, principle: str) -> None:
    system = fb.System.from_text(BOWL.replace("{SPACE}", "true").replace("AT", "[0, r - R, 0]"))
    told = explain(system, "period of small oscillations", language=language)
    (derivation,) = told.derivations
    assert not derivation.reason
    assert principle in told.to_text()
