"""Bodies that nobody has put begin where they touch, also where they part there, or are thrown onto it, at once."""

from __future__ import annotations

import math

import pytest

import freebody as fb

THROWN = """
parameters: {m: 0.2 kg, R: 0.04 m, v: 4 m/s, e: 0.8, alpha: 25 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: DIRECTION}}}
bodies: {ball: {sphere: {mass: m, radius: R}, velocity: [0, SPEED]}}
connections: {hit: {contact: {between: [ball, floor], restitution: e}}}
loads: {w: {gravity: g}}
measures: {x: x of ball, y: y of ball}
"""


def _thrown(direction: str = "right", speed: str = "-v") -> fb.System:
    return fb.System.from_text(THROWN.replace("DIRECTION", direction).replace("SPEED", speed))


@pytest.mark.parametrize(("speed", "rise"), [("-v", 0.8 * 4), ("v", 4.0)])
def test_what_is_thrown_from_a_floor_rises_from_its_radius(speed: str, rise: float) -> None:
    start, greatest = _thrown(speed=speed).solve(["y at start", "greatest y"]).answers
    assert start.value == pytest.approx(0.04, rel=1e-12)
    assert greatest.value == pytest.approx(0.04 + rise**2 / (2 * 9.81), rel=1e-9)


def test_what_is_thrown_onto_a_slope_begins_at_its_radius_across_it() -> None:
    x, y = _thrown("alpha").solve(["x at start", "y at start"]).answers
    alpha = math.radians(25)
    assert (x.value, y.value) == pytest.approx((-0.04 * math.sin(alpha), 0.04 * math.cos(alpha)), rel=1e-9)


def test_the_formula_of_the_first_flight_is_that_of_the_simulation() -> None:
    system = _thrown()
    (lands,) = system.solve("time when y = R").answers
    hits = [event.time for event in system.simulate(1.0).events if event.time > 0]
    assert lands.value == pytest.approx(2 * 0.8 * 4 / 9.81, rel=1e-9)
    assert hits[0] == pytest.approx(lands.value, rel=1e-7)
