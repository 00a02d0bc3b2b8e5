"""Dry friction of guides in space: mu times the resultant of the forces across the guide.

Problem families: Meriam & Kraige, Dynamics, ch. 3 (collars on rods); Beer, Johnston & Cornwell, Vector Mechanics for
Engineers, ch. 12 (bodies on turning rods). The formulas are derived by hand in each test.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from freebody.api import System

GUIDES = {
    "point_on_line": ("particle: {mass: m}", "point: collar, through: ground.A"),
    "prismatic": ("box: {mass: m, size: [0.3 m, 0.2 m, 0.1 m]}", "first: ground.A, second: collar"),
}


def collar(along: str, mu: float = 0.2, side: float = 0.0, speed: float = 0.0, on: str = "point_on_line") -> System:
    shape, ends = GUIDES[on]
    return System.from_text(f"""
space: {{up: z}}
parameters: {{m: 2 kg, mu: {mu}, F: {{value: {side} N, sign: any}}, g: 9.81 m/s^2}}
bodies: {{collar: {{{shape}}}}}
connections: {{rod: {{{on}: {{{ends}, along: {along}, friction: mu}}}}}}
loads: {{weight: {{gravity: g}}, side: {{force: {{at: collar, along: y, magnitude: F}}}}}}
measures: {{s: "travel of collar along {along} from ground.A"}}
start: {{s: 0, rate(s): {speed} m/s}}
""")


def balanced(along: tuple[float, ...], mu: float, side: float, way: float) -> float:
    """The acceleration along a unit vector e of a mass that slides in the sense `way`, with W the loads:
    W . e/m - mu |W - (W . e) e| way/m."""
    e = np.array(along) / np.linalg.norm(along)
    load = np.array([0.0, side, -2.0 * 9.81])
    across = load - (load @ e) * e
    return float(load @ e - way * mu * np.linalg.norm(across)) / 2.0


@pytest.mark.parametrize("on", GUIDES)
@pytest.mark.parametrize(("along", "side"), [((1, 2, -2), 0.0), ((3, 0, -4), 5.0), ((1, 2, -2), 7.0)])
def test_a_collar_slides_against_mu_times_the_resultant_across_its_rod(
    along: tuple[int, ...], side: float, on: str
) -> None:
    expected = balanced(along, 0.2, side, 1.0)
    assert expected > 0.0
    model = collar(str(list(along)), side=side, on=on)
    answer = model.solve("acceleration of s").answers[0]
    assert not answer.reason
    assert answer.value == pytest.approx(expected, rel=1e-9)
    run = model.simulate(until=1)
    assert run.dataset["s"].values[-1] == pytest.approx(expected / 2, rel=1e-7)


def test_a_collar_sent_up_a_skew_rod_stops_and_stays_where_friction_holds_it() -> None:
    """Upwards a = -(g/3)(2 + sqrt(5) mu); it stays for mu >= 2/sqrt(5)."""
    model = collar("[1, 2, -2]", mu=1.0, speed=-3.0)
    run = model.simulate(until=2)
    a = 9.81 * (2 + math.sqrt(5)) / 3
    assert run.dataset["s"].values[-1] == pytest.approx(-9.0 / (2 * a), rel=1e-8)
    least = collar("[1, 2, -2]", mu=1.0).solve("least mu so that it stays at rest").answers[0]
    assert least.value == pytest.approx(2 / math.sqrt(5), rel=1e-9)


def test_the_derivation_puts_both_components_into_the_law_of_friction() -> None:
    told = str(collar("[3, 0, -4]", side=5.0).explain("acceleration of s"))
    law = told.partition("Law of friction")[2]
    assert "F_rod_1  + F_rod_2" in law
    assert "no derivation" not in told


def test_a_rod_pendulum_on_a_dry_pin_is_held_back_by_the_force_that_its_friction_changes() -> None:
    """At rest level, let go with a speed w: with T = mu a N against the turn,

        m L^2/3 alpha = -m g L/2 -+ T,   N = m |(-w^2 L/2, g + alpha L/2)|,

    solved by repetition, since T changes N by a small share only."""
    text = """
parameters: {m: 1 kg, L: 1 m, a: 0.02 m, mu: 0.3, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {axle: {pin: {first: ground.A, second: rod.start, friction: mu, radius: a}}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod}}
start: {theta: 0, rate(theta): -1 rad/s}
"""
    alpha = 0.0
    for _ in range(100):
        torque = 0.3 * 0.02 * math.hypot(0.5, 9.81 + alpha / 2)
        alpha = 3 * (torque - 9.81 / 2)
    answer = System.from_text(text).solve("acceleration of theta at start").answers[0]
    assert answer.value == pytest.approx(alpha, rel=1e-12)
