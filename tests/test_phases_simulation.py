"""Motion in phases: the closed forms and the event-driven simulation are two ways to the same numbers."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.study.phases.result import Phases, phases

FOLDER = Path(__file__).parents[1] / "examples"
EVENTS = ("stops slipping", "slips back", "parts", "starts slipping")


def first_time(found: Phases, values: dict[str, float]) -> float | None:
    """When the first phase ends at these values; None if it does not."""
    sets = found.tree.sets.at({k: np.array([v]) for k, v in values.items()})
    model = found.tree.home.model
    for node in found.tree.roots:
        for edge in node.edges:
            conditions = [*node.conditions, *edge.conditions]
            if all(sets.evaluate(model, c.element)[0] > 0 for c in conditions):
                return None if edge.time is None else float(sets.evaluate(model, edge.time)[0])
    raise AssertionError(f"no case holds at {values}")


@pytest.fixture(scope="module")
def sphere() -> fb.System:
    return fb.System.load(FOLDER / "sphere_launched_down_incline.yaml")


@pytest.fixture(scope="module")
def sphere_phases(sphere: fb.System) -> Phases:
    return phases(sphere)


@pytest.mark.parametrize("theta", [2.0, 15.0, 30.0, 50.0])
@pytest.mark.parametrize("factor", [0.5, 1.01, 1.2, 3.0])
def test_rolling_begins_in_the_simulation_when_the_formula_says(
    sphere: fb.System, sphere_phases: Phases, theta: float, factor: float
) -> None:
    angle = math.radians(theta)
    values = {p.name: p.value for p in sphere.parameters.values() if p.value is not None}
    values |= {"theta": angle, "mu": 2 / 7 * math.tan(angle) * factor}
    time = first_time(sphere_phases, values)
    assert (time is None) == (factor < 1)
    until = 2.0 if time is None else 1.2 * time
    result = fb.simulate(sphere, until, values=values, tolerance=1e-11)
    times = [e.time for e in result.events if e.kind == "stops slipping"]
    if time is None:
        assert times == []
    else:
        assert times == [pytest.approx(time, rel=1e-10)]


@pytest.mark.parametrize("name", ["ball_with_back_spin", "block_on_rough_incline", "billiard_ball"])
def test_the_first_event_of_an_example_is_that_of_its_simulation(name: str) -> None:
    system = fb.System.load(FOLDER / f"{name}.yaml")
    values = {p.name: p.value for p in system.parameters.values() if p.value is not None}
    time = first_time(phases(system), values)
    assert time is not None
    result = fb.simulate(system, 1.2 * time, tolerance=1e-11)
    assert [e.time for e in result.events if e.kind in EVENTS] == [pytest.approx(time, rel=1e-10)]


@pytest.mark.parametrize("name", ["particle_leaving_dome", "ball_leaving_cylinder"])
def test_the_place_of_leaving_is_that_of_the_simulation(name: str) -> None:
    system = fb.System.load(FOLDER / f"{name}.yaml")
    expected = fb.solve(system)["angle"].value
    assert isinstance(expected, float)
    result = fb.simulate(system, 1.5, tolerance=1e-11, events=[f"phi = {expected!r} rad"])
    leaves = next(e.time for e in result.events if e.kind == "parts")
    passes = next(e.time for e in result.events if e.kind != "parts")
    assert leaves == pytest.approx(passes, rel=1e-8)


def test_speed_when_rolling_begins_is_that_of_the_simulation(sphere: fb.System) -> None:
    answers = fb.solve(sphere)
    time, speed = answers["time"].value, answers["speed"].value
    assert isinstance(time, float)
    result = fb.simulate(sphere, time, tolerance=1e-12)
    velocity = result.dataset["body_velocity"].values[-1, 0]
    assert float(np.hypot(*velocity)) == pytest.approx(speed, rel=1e-10)


@pytest.mark.parametrize("a", [2.0, 10.0, 17.0, 31.0, 44.0])
def test_a_value_at_which_a_stop_strikes_is_reached_when_it_strikes(a: float) -> None:
    """The quarter swing of a pendulum to a stop: t is the integral of dphi/sqrt(2 g/L (cos(phi) - cos(phi0)))."""
    text = f"""
parameters: {{m: 1 kg, L: 1 m, phi0: 60 deg, a: {a} deg, g: 9.81 m/s^2}}
bodies: {{bob: {{particle: {{mass: m}}}}}}
connections:
  rod: {{link: {{first: ground.origin, second: bob, length: L}}}}
  stop: {{stop: {{measure: phi, min: a, restitution: 0.5}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{phi: {{angle of line from ground.origin to bob from down}}}}
start: {{phi: phi0}}
questions: [time when phi = a]
"""
    turn, end = math.radians(60.0), math.radians(a)
    # phi = turn - s^2 takes the root at the turning point out of the integral
    s = np.polynomial.legendre.leggauss(40)
    top = math.sqrt(turn - end)
    nodes, weights = 0.5 * top * (s[0] + 1.0), 0.5 * top * s[1]
    phi = turn - nodes**2
    expected = float(weights @ (2.0 * nodes / np.sqrt(2.0 * 9.81 * (np.cos(phi) - math.cos(turn)))))
    assert fb.System.from_text(text).solve()["q1"].value == pytest.approx(expected, rel=1e-8)


def numbers_of(text: str, *questions: str) -> list[float]:
    asked = ", ".join(questions)
    answers = fb.System.from_text(f"{text}questions: [{asked}]").solve().answers
    assert all(answer.expression is None for answer in answers)
    return [answer.value for answer in answers]  # type: ignore[misc]


def test_without_a_closed_form_all_quantities_have_numbers_where_contacts_are() -> None:
    """A pendulum in air that is stopped: its speed says what the force in the rod, the powers and the energies are."""
    text = """
parameters: {m: 1 kg, L: 1 m, phi0: 60 deg, a: 10 deg, c: 0.3 kg/s, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections:
  rod: {link: {first: ground.origin, second: bob, length: L}}
  stop: {stop: {measure: phi, min: a, restitution: 0.5}}
loads: {weight: {gravity: g}, air: {law: {measure: phi, force: -c*L*L*rate(phi)}}}
measures: {phi: {angle of line from ground.origin to bob from down}}
start: {phi: phi0}
"""
    at = ("velocity of phi", "tension of rod", "kinetic energy", "power of weight", "acceleration of phi")
    rate, tension, kinetic, power, acceleration = numbers_of(text, *(f"{what} when phi = a" for what in at))
    a, g = math.radians(10.0), 9.81
    assert -math.sqrt(2 * g * (math.cos(a) - 0.5)) < rate < 0.0
    assert tension == pytest.approx(rate**2 + g * math.cos(a))
    assert kinetic == pytest.approx(rate**2 / 2)
    assert power == pytest.approx(-g * math.sin(a) * rate)
    assert acceleration == pytest.approx(-g * math.sin(a) - 0.3 * rate)


def test_without_a_closed_form_friction_has_its_number() -> None:
    """A block that slides into thinner air of quadratic resistance: mu m g against its way, and the heat of both."""
    text = """
parameters: {m: 2 kg, c: 0.5 kg/m, mu: 0.2, v0: 4 m/s, d: 0.5 m, l: 3 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {block: {particle: {mass: m}}}
connections: {contact: {contact: {between: [block, floor], friction: mu}}}
loads: {weight: {gravity: g}, air: {law: {measure: x, force: -c*rate(x)*abs(rate(x))/(1 + x/l)}}}
measures: {x: x of block}
start: {x: 0, rate(x): v0}
"""
    friction, normal, rate, acceleration, power = numbers_of(
        text,
        "friction force of contact when x = d",
        "normal force of contact when x = d",
        "velocity of x when x = d",
        "acceleration of x when x = d",
        "power of contact when x = d",
    )
    assert power == pytest.approx(-0.2 * 2.0 * 9.81 * rate)
    assert abs(friction) == pytest.approx(0.2 * 2.0 * 9.81)
    assert normal == pytest.approx(2.0 * 9.81)
    # v dv/dx = -mu g - c v^2/(m s) with s = 1 + x/l, so that v^2 = C s^-p - 2 mu g l s/(p + 1), p = 2 c l/m
    s, p, slope = 1 + 0.5 / 3, 2 * 0.5 * 3 / 2.0, 2 * 0.2 * 9.81 * 3 / (2 * 0.5 * 3 / 2.0 + 1)
    assert rate == pytest.approx(math.sqrt((16.0 + slope) * s**-p - slope * s))
    assert acceleration == pytest.approx(-0.2 * 9.81 - 0.5 * rate**2 / (2.0 * s))
