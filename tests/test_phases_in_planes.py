"""Motions that slide in a plane in one direction, phase by phase in closed form, each worked out by hand.

While the acceleration of a slip is parallel to it, friction in a plane is that along a line: a puck on a table stops
after |v|/(mu g) on the straight way v |v|/(2 mu g). On a slope its weight is another direction, and the slip turns.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb

G = 9.81


def puck(velocity: str = "", normal: str = "up", *, mu: float = 0.3, loads: str = "") -> fb.System:
    moves = f", velocity: {velocity}" if velocity else ""
    return fb.System.from_text(f"""
space: true
parameters: {{m: 2 kg, v: 3 m/s, w: 2 m/s, alpha: 20 deg, P: 5 N, mu: {mu}, g: 9.81 m/s^2}}
ground: {{planes: {{table: {{normal: {normal}}}}}}}
bodies: {{puck: {{particle: {{mass: m}}{moves}}}}}
connections: {{table: {{contact: {{between: [puck, ground.table], friction: mu}}}}}}
loads: {{weight: {{gravity: g}}{loads}}}
measures: {{x: x of puck, z: z of puck}}
""")


SLOPE = "[sin(alpha), cos(alpha), 0]"


def asked(system: fb.System, question: str) -> fb.Answer:
    [answer] = system.solve(question).answers
    assert answer.expression is not None, answer.reason
    return answer


def test_puck_that_slides_obliquely_stops_on_a_straight_way() -> None:
    system, speed = puck("[v, 0, w]"), math.hypot(3.0, 2.0)
    assert asked(system, "time when puck stops").value == pytest.approx(speed / (0.3 * G), rel=1e-12)
    assert asked(system, "x when puck stops").value == pytest.approx(3.0 * speed / (0.6 * G), rel=1e-12)
    assert asked(system, "z when puck stops").value == pytest.approx(2.0 * speed / (0.6 * G), rel=1e-12)
    assert asked(system, "energy lost until puck stops").value == pytest.approx(0.5 * 2.0 * speed**2, rel=1e-12)
    # the friction is mu m g against the slip, of which both rows have their part
    along = (
        asked(system, "friction force x of table at start").value,
        asked(system, "friction force z of table at start").value,
    )
    assert along == pytest.approx((-0.6 * G * 3.0 / speed, -0.6 * G * 2.0 / speed), rel=1e-12)
    force = asked(system, "reaction of table at start").value
    assert force == pytest.approx((along[0], 2.0 * G, along[1]), rel=1e-12)


def test_puck_pushed_up_a_slope_stays_there_or_slides_back() -> None:
    """Up g (sin + mu cos), held while mu >= tan, else down g (sin - mu cos)."""
    up = "[-v*cos(alpha), v*sin(alpha), 0]"
    s, c = math.sin(math.radians(20)), math.cos(math.radians(20))
    found = asked(puck(up, SLOPE), "time when puck stops")
    assert found.value == pytest.approx(3.0 / (G * (s + 0.3 * c)), rel=1e-12)
    back = asked(puck(up, SLOPE), "velocity of x when x = 0")
    assert back.value == pytest.approx(3.0 * c * math.sqrt((s - 0.3 * c) / (s + 0.3 * c)), rel=1e-12)
    assert any("tan" in condition for condition in back.conditions)


def test_puck_that_friction_cannot_hold_starts_along_the_resultant() -> None:
    """Down the slope m g sin, across it P: the acceleration along their resultant R is R/m - mu g cos."""
    push = ", push: {force: {at: puck, along: [0, 0, 1], magnitude: P}}"
    s, c = 2.0 * G * math.sin(math.radians(20)), math.cos(math.radians(20))
    size = math.hypot(s, 5.0)
    found = asked(puck("", SLOPE, loads=push), "acceleration of z at start")
    assert found.value == pytest.approx((size / 2.0 - 0.3 * G * c) * 5.0 / size, rel=1e-12)
    held = asked(puck("", SLOPE, mu=0.6, loads=push), "acceleration of z at start")
    assert held.value == 0.0


def test_slip_that_turns_is_said_to_and_has_its_numbers() -> None:
    """Pushed across the slope its friction turns towards the line of fall."""
    [answer] = puck("[0, 0, v]", SLOPE).solve("acceleration of x at start").answers
    assert answer.expression is None
    assert "the slip of table turns" in answer.reason
    down = math.sin(math.radians(20)) * math.cos(math.radians(20))
    assert answer.value == pytest.approx(G * down, rel=1e-9)


@pytest.mark.parametrize("language", ["en", "de"])
def test_sliding_in_a_plane_is_derived(language: str) -> None:
    told = str(puck("[v, 0, w]").explain("time when puck stops", language=language))
    assert "no derivation" not in told
    assert "keine Herleitung" not in told
