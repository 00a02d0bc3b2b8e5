"""Cars whose wheels have inertia: each wheel rolls, slips either way or lifts off, and only what holds gets formulas.

While all wheels roll, a car of the mass m on two axles of the inertia I each goes by

    (m + 2 I/r^2) x'' = T/r,    F_rear = T/r - I x''/r^2,    F_front = -I x''/r^2,

and the moments about its mass centre, with the spin of the wheels, give the axle loads. Families: Meriam & Kraige,
Dynamics, sec. 6/2 and 6/4; Mitschke & Wallentowitz, Dynamik der Kraftfahrzeuge, ch. A.
"""

from __future__ import annotations

from math import cos, radians, sin

import numpy as np
import pytest

import freebody as fb
from freebody.language.expression import evaluate
from freebody.study.phases.foreseen import Foresight
from freebody.study.phases.home import Home
from freebody.study.phases.in_plane import slips_of
from freebody.study.phases.nodes import PhaseStart
from freebody.study.phases.placed import Placed

M, J, R, A, B, H, G = 1200.0, 1.5, 0.3, 1.2, 1.4, 0.5, 9.81
CAR = """
parameters: {{mu: 0.8, T: {T} N m, g: 9.81 m/s^2}}
ground: {{lines: {{road: {{along: right}}}}}}
bodies:
  car: {{body: {{mass: 1200 kg, inertia: 1500 kg m^2}}, points: {{rear: [-1.4, -0.2], front: [1.2, -0.2]}},
    at: [0, 0.5], angle: 0}}
  front: {{body: {{inertia: 1.5 kg m^2, radius: 0.3 m}}, at: [1.2, 0.3], angle: 0}}
  rear: {{body: {{inertia: 1.5 kg m^2, radius: 0.3 m}}, at: [-1.4, 0.3], angle: 0}}
connections:
  front_axle: {{pin: [car.front, front]}}
  rear_axle: {{pin: [car.rear, rear]}}
  front_tyre: {{contact: {{between: [front, ground.road], friction: mu, touching: true}}}}
  rear_tyre: {{contact: {{between: [rear, ground.road], friction: mu, touching: true}}}}
  {brakes}
loads: {{weight: {{gravity: g}}{drive}}}
measures: {{x: x of car, phi: angle of front, psi: angle of rear}}
start: {{x: 0, rate(x): {v}, phi: 0, rate(phi): {spin}, psi: 0, rate(psi): {spin}}}
"""
DRIVE = ", drive: {torque: {on: rear, magnitude: -T, reacts_on: car}}"
BRAKES = """front_brake: {brake: {between: [front, car], torque: T}}
  rear_brake: {brake: {between: [rear, car], torque: T}}"""


def driven(torque: float) -> fb.System:
    return fb.System.from_text(CAR.format(T=torque, brakes="", drive=DRIVE, v=0, spin=0))


def axle_loads(acceleration: float) -> tuple[float, float]:
    """Front and rear: N_f + N_r = m g, N_f a - N_r b + (F_f + F_r) h + 2 I x''/r = 0, the wheels spin backwards."""
    front = (M * G * B - M * acceleration * H - 2 * J * acceleration / R) / (A + B)
    return front, M * G - front


@pytest.mark.parametrize(
    ("mu", "torque", "closed", "slip"),
    [(0.8, 900.0, 2, 0), (0.8, 2500.0, 2, 1), (3.2, 11000.0, 1, 0)],
    ids=["rolls", "spins its wheels", "lifts its front"],
)
def test_numbers_name_the_one_combination_that_holds(mu: float, torque: float, closed: int, slip: int) -> None:
    """Of 16 combinations of two wheels. N_f = 0 at x'' (m h + 2 I/r) = m g b, which takes a road of mu > b/h."""
    system = driven(torque).with_parameters(mu=mu)
    home = Home(system)
    slips = slips_of(home, home.rubbing(home.closed), lambda measure: home.at_start(home.home.state.rate(measure)))
    instant = PhaseStart(Placed(), home.closed, slips.sizes, began=home.home.model.field.zero)
    left = np.zeros(home.sets.n, dtype=bool)
    left[home.indices] = True
    mode = next(Foresight(home).modes(instant, left))
    assert len(mode.closed) == closed
    [state] = [state for name, state in mode.states.items() if name.startswith("rear_tyre")]
    assert abs(state) == slip


@pytest.mark.slow
def test_a_car_with_wheels_of_inertia_speeds_up_and_its_axle_loads_shift() -> None:
    acceleration, front, rear, friction = (
        driven(900.0)
        .solve(
            [
                "acceleration of x at start",
                "normal force of front_tyre at start",
                "normal force of rear_tyre at start",
                "friction force of rear_tyre at start",
            ]
        )
        .answers
    )
    x = 900.0 / R / (M + 2 * J / R**2)
    assert acceleration.value == pytest.approx(x, rel=1e-12)
    assert (front.value, rear.value) == pytest.approx(axle_loads(x), rel=1e-12)
    assert friction.value == pytest.approx(900.0 / R - J * x / R**2, rel=1e-12)
    # more torque than the road can give back: N_r grows with mu N_r = m x'' + I x''/r^2, the front wheels roll
    [case] = [
        case for case in acceleration.cases if "rear_tyre slides" in case.what and "front_tyre rolls" in case.what
    ]
    slips = float(evaluate(case.expression, {"mu": 0.8, "T": 2500.0, "g": G}))  # type: ignore[arg-type]
    motion = driven(2500.0).simulate(0.01)
    assert motion.series["x"][1][-1] / 0.01 == pytest.approx(slips, rel=1e-6)


@pytest.mark.slow
def test_a_car_stops_by_its_brakes_while_its_wheels_roll() -> None:
    """(m + 2 I/r^2) x'' = -2 T/r up to the stop, where the brakes hold at once."""
    system = fb.System.from_text(CAR.format(T=800.0, brakes=BRAKES, drive="", v=20, spin=-20.0 / R))
    deceleration, way = system.solve(["acceleration of x at start", "x when rate(x) = 0"]).answers
    a = 2 * 800.0 / R / (M + 2 * J / R**2)
    assert deceleration.value == pytest.approx(-a, rel=1e-12)
    assert way.value == pytest.approx(20.0**2 / (2 * a), rel=1e-12)


PARKED = """
parameters: {m: 1200 kg, I: 1500 kg m^2, r: 0.3 m, a: 1.2 m, b: 1.4 m, h: 0.5 m, mu: 0.8, T: 2500 N m, alpha: 10 deg,
  g: 9.81 m/s^2}
ground: {lines: {road: {along: alpha}}}
bodies:
  car: {body: {mass: m, inertia: I}, points: {rear: [-b, r - h], front: [a, r - h]}, angle: alpha}
  front: {body: {inertia: 1.5 kg m^2, radius: r}}
  rear: {body: {inertia: 1.5 kg m^2, radius: r}}
connections:
  front_axle: {pin: [car.front, front]}
  rear_axle: {pin: [car.rear, rear]}
  front_tyre: {contact: {between: [front, ground.road], friction: mu, touching: true}}
  rear_tyre: {contact: {between: [rear, ground.road], friction: mu, touching: true}}
  fb: {brake: {between: [front, car], torque: T}}
  rb: {brake: {between: [rear, car], torque: T}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.slow
def test_a_car_parked_on_both_brakes_has_the_axle_loads_of_rest_and_no_unique_friction() -> None:
    m, a, b, h, alpha = 1200.0, 1.2, 1.4, 0.5, radians(10)
    system = fb.System.from_text(PARKED)
    load, rub = system.solve(["normal force of front_tyre", "friction force of front_tyre"]).answers
    assert load.value == pytest.approx(m * 9.81 * (b * cos(alpha) - h * sin(alpha)) / (a + b), rel=1e-12)
    assert "while it stays at rest" in load.notes
    # a formula of another case does not stand on top
    assert rub.expression is None
    assert rub.value is None
    assert "not unique" in str(rub.reason)
