"""`BODY stops`: it is at rest against the ground, whatever else sticks or slips meanwhile."""

from __future__ import annotations

import math

import pytest

import freebody as fb

# a block that slides on a rough table pulls up a weight: both stop together
HANGING = """
parameters: {m: 2 kg, M: 0.4 kg, mu: 0.5, v0: 2 m/s, g: 9.81 m/s^2}
ground:
  lines: {table: {along: right}}
  points: {edge: [1 m, 0]}
bodies:
  block: {particle: {mass: m}, at: [0, 0]}
  weight: {particle: {mass: M}}
connections:
  table: {slider: {body: block, along: right, friction: mu}}
  rope: {string: [block, ground.edge, weight]}
loads: {gravity: {gravity: g}}
measures: {x: x of block, y: drop of weight below ground.edge}
start: {x: 0, rate(x): v0}
"""


def seconds(text: str, question: str) -> float:
    (found,) = fb.System.from_text(text).solve(question).answers
    assert isinstance(found.value, float), found.reason
    return found.value


def test_a_weight_on_a_rope_stops_when_the_block_that_pulls_it_sticks() -> None:
    v0, m, big, mu, g = 2.0, 2.0, 0.4, 0.5, 9.81
    at = v0 * (m + big) / (g * (m * mu - big))  # (m + M) a = mu m g - M g
    assert seconds(HANGING, "time when block stops") == pytest.approx(at, rel=1e-9)
    assert seconds(HANGING, "time when weight stops") == pytest.approx(at, rel=1e-9)


def test_a_vehicle_on_a_wheel_that_locks_stops_although_its_axle_rubs_nowhere() -> None:
    system = fb.System.load("examples/wheel_that_locks.yaml")
    (found,) = system.solve("braking distance").answers
    assert found.value == pytest.approx(20.0**2 / (2 * 0.8 * 9.81), rel=1e-9)  # it slides: v0^2/(2 mu g)


def test_what_stops_relative_to_a_driven_truck_is_no_stop_of_the_truck() -> None:
    system = fb.System.load("examples/can_on_a_truck.yaml")
    (asked,) = system.asked("time when truck stops")
    assert asked.understood == "time when rate(x) = 0"


SHOE = """
parameters: {J: 5 kg m^2, R: 0.4 m, mu: 0.35, F: 200 N, a: 0.3 m, b: 1 m, n: 300 rpm}
ground: {points: {O: [0, 0], P: [-a, R]}}
bodies:
  wheel: {flywheel: {inertia: J, radius: R}, angular_velocity: n}
  lever: {rod: {length: b}, at: {start: [-a, R]}, angle: 0}
connections:
  bearing: {pin: [O, wheel]}
  hinge: {pin: [P, lever.start]}
  shoe: {contact: {between: [wheel, lever], friction: mu}}
loads: {hand: {force: {at: lever.end, along: down, magnitude: F}}}
"""


def test_a_wheel_stops_under_the_shoe_of_a_hinged_lever() -> None:
    """N a = F b about the hinge, so J dw/dt = -mu R F b/a, and J n^2/2 becomes heat."""
    j, r, mu, f, a, b, n = 5.0, 0.4, 0.35, 200.0, 0.3, 1.0, 10 * math.pi
    assert seconds(SHOE, "time until wheel stops") == pytest.approx(j * a * n / (r * mu * f * b), rel=1e-9)
    assert seconds(SHOE, "energy lost until wheel stops") == pytest.approx(j * n**2 / 2, rel=1e-9)


def test_a_wheel_does_not_stop_under_a_shoe_that_may_slide_along_with_it() -> None:
    """Where the friction no longer slips both may go on together: only a shoe that is hinged stays where it is."""
    guided = SHOE.replace("hinge: {pin: [P, lever.start]}", "guide: {slider: {body: lever, along: right}}")
    assert guided != SHOE
    with pytest.raises(fb.ModelError, match="cannot read the condition 'wheel stops'"):
        fb.System.from_text(guided).solve("time until wheel stops")
