"""Vehicles that brake and drive by their wheels. Source: Mitschke & Wallentowitz, Dynamik der Kraftfahrzeuge;
Meriam & Kraige, Dynamics, sec. 6/2."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb

EXAMPLES = Path(__file__).parents[1] / "examples"
M, A, B, H, MU, V0, G = 1200.0, 1.2, 1.4, 0.5, 0.8, 20.0, 9.81


def car(*locked: str) -> fb.System:
    """A car that slides on its locked wheels and rolls freely on the others."""
    rub = {end: ", friction: mu" if end in locked else "" for end in ("rear", "front")}
    return fb.System.from_text(f"""
parameters: {{m: 1200 kg, a: 1.2 m, b: 1.4 m, h: 0.5 m, mu: 0.8, v0: 20 m/s, g: 9.81 m/s^2}}
ground: {{lines: {{road: {{along: right}}}}}}
bodies:
  car: {{rectangle: {{mass: m, width: 3.8 m, height: 0.8 m}}, points: {{rear: [-b, -h], front: [a, -h]}}, at: [0, h],
    angle: 0}}
connections:
  rear: {{contact: {{between: [car.rear, ground.road], touching: true{rub["rear"]}}}}}
  front: {{contact: {{between: [car.front, ground.road], touching: true{rub["front"]}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: {{x of car}}}}
start: {{x: 0, rate(x): v0}}
""")


@pytest.mark.parametrize(
    ("locked", "deceleration"),
    [
        # N_r (a + b) = m g a - m z g h, m z g = mu N_r; N_f (a + b) = m g b + m z g h; both together mu m g
        (("rear",), MU * A / (A + B + MU * H)),
        (("front",), MU * B / (A + B - MU * H)),
        (("rear", "front"), MU),
    ],
    ids=["rear", "front", "all"],
)
def test_way_of_a_car_until_it_stands_on_its_locked_wheels(locked: tuple[str, ...], deceleration: float) -> None:
    (way,) = car(*locked).solve("x when rate(x) = 0").answers
    assert way.expression is not None
    assert way.value == pytest.approx(V0**2 / (2 * deceleration * G), rel=1e-12)


def test_which_axle_locks_first_changes_with_the_share_of_the_rear_brakes() -> None:
    """At the ideal share for z = mu both lock at once, with mu g; with more at the rear wheels these lock first."""
    system = fb.System.load(EXAMPLES / "brake_force_distribution.yaml")
    ideal = (A - H * MU) / (A + B)
    for share in (ideal - 0.05, ideal, ideal + 0.05):
        solution = system.with_parameters(p=share).solve()
        rear, front = float(solution["rear_locks"].value), float(solution["front_locks"].value)  # type: ignore[arg-type]
        if share == ideal:
            assert (rear, front) == (pytest.approx(MU), pytest.approx(MU))
        else:
            assert (rear < front) == (share > ideal)
            assert min(rear, front) < MU


def test_wheel_rolls_up_to_a_torque_that_its_inertia_raises() -> None:
    """-x'' = r T/(m r^2 + I), and the road has to brake m with that: m r T/(m r^2 + I) <= mu m g."""
    system = fb.System.load(EXAMPLES / "wheel_that_locks.yaml")
    (torque,) = system.solve("range of T for which road does not slip").answers
    assert torque.expression is not None
    assert torque.value == pytest.approx(0.8 * 9.81 * (300 * 0.09 + 1) / 0.3, rel=1e-12)


def test_motorcycle_lifts_its_rear_wheel_from_a_grip_on() -> None:
    system = fb.System.load(EXAMPLES / "motorcycle_brakes.yaml")
    (grip,) = system.solve("value of mu for which normal force of rear = 0").answers
    assert grip.value == pytest.approx(0.7 / 0.65, rel=1e-12)


def test_derivation_of_the_grip_goes_up_to_the_wheel_that_lifts_off() -> None:
    """N_r (a + b - mu h) = m g (a - mu h). Behind a/h the wheel is in the air, where the force rests at zero."""
    system = fb.System.load(EXAMPLES / "motorcycle_brakes.yaml")
    told = str(system.explain("value of mu for which normal force of rear = 0"))
    assert "defect" not in told
    assert "Solving (4)" in told


def driven(*wheels: str, along: str, angle: str, force: str) -> fb.System:
    """A car seen by its driver, whose driven wheels grip and whose other wheels roll."""
    rub = {end: ", friction: mu" if end in wheels else "" for end in ("rear", "front")}
    return fb.System.from_text(f"""
parameters: {{m: 1200 kg, a: 1.2 m, b: 1.4 m, h: 0.5 m, mu: 0.8, alpha: 10 deg, A: 1 m/s^2, g: 9.81 m/s^2}}
ground: {{lines: {{road: {{along: {along}}}}}}}
bodies:
  car: {{rectangle: {{mass: m, width: 3.8 m, height: 0.8 m}}, points: {{rear: [-b, -h], front: [a, -h]}},
    at: [-h*sin({angle}), h*cos({angle})], angle: {angle}}}
connections:
  rear: {{contact: {{between: [car.rear, ground.road], touching: true{rub["rear"]}}}}}
  front: {{contact: {{between: [car.front, ground.road], touching: true{rub["front"]}}}}}
loads: {{weight: {{gravity: g}}{force}}}
""")


@pytest.mark.parametrize(
    ("wheels", "grip"),
    [
        # with z = A/g on the level, or tan(alpha) of a slope: mu N >= m g z, N_r (a + b) = m g (a + z h)
        (("rear",), MU * A / (A + B - MU * H)),
        (("front",), MU * B / (A + B + MU * H)),
        (("rear", "front"), MU),
    ],
    ids=["rear", "front", "all"],
)
def test_greatest_acceleration_and_steepest_slope_have_the_same_grip(wheels: tuple[str, ...], grip: float) -> None:
    """Seen from the car weight and inertia force are as on a slope. The front lifts off at z = b/h, which is more."""
    inertia = ", inertia: {force: {at: car, along: left, magnitude: m*A}}"
    level, slope = (
        driven(*wheels, along="right", angle="0", force=inertia),
        driven(*wheels, along="alpha", angle="alpha", force=""),
    )
    (fastest,) = level.solve("largest A so that it stays at rest").answers
    assert fastest.value == pytest.approx(grip * G, rel=1e-12)
    (steepest,) = slope.solve("largest alpha so that it stays at rest").answers
    assert steepest.value == pytest.approx(math.atan(grip), rel=1e-12)
