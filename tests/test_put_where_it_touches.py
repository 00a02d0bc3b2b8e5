"""Where a model puts what touches: in formulas it touches for all parameters, and does not fall through what it is on.

Hand-derived: on the level a ball slides for 2 v/(7 mu g) and rolls on with 5/7 v (Coriolis 1835).
"""

from __future__ import annotations

import math

import pytest

import freebody as fb

MU, G, V, R = 0.2, 9.81, 7.0, 0.1


def asked(system: fb.System, question: str) -> fb.Answer:
    [answer] = system.solve(question).answers
    assert answer.expression is not None, answer.reason
    return answer


def ball(at: str, *, space: bool) -> fb.System:
    floor = "planes: {floor: {normal: up}}" if space else "lines: {floor: {along: right}}"
    velocity = "[v, 0, 0]" if space else "[v, 0]"
    return fb.System.from_text(f"""
space: {str(space).lower()}
parameters: {{m: 1 kg, r: {R} m, v: {V} m/s, mu: {MU}, g: {G} m/s^2}}
ground: {{{floor}}}
bodies: {{ball: {{sphere: {{mass: m, radius: r}}, at: {at}, velocity: {velocity}}}}}
connections: {{c: {{contact: {{between: [ball, ground.floor], friction: mu}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{s: x of ball}}
""")


@pytest.mark.parametrize(("at", "space"), [("[0, r, 0]", True), ("[0, 0.1 m, 0]", True), ("[0, 0.1 m]", False)])
def test_ball_that_is_put_on_the_floor_slides_and_then_rolls(at: str, space: bool) -> None:
    system = ball(at, space=space)
    rolls = asked(system, "velocity of s when rolling begins")
    assert rolls.conditions == ("for all positive parameters",)
    assert rolls.value == pytest.approx(5 * V / 7, rel=1e-12)
    assert asked(system, "time when rolling begins").value == pytest.approx(2 * V / (7 * MU * G), rel=1e-12)
    assert asked(system, "normal force of c at start").value == pytest.approx(G, rel=1e-12)
    assert ("touches at the start" in " ".join(rolls.notes)) == ("0.1" in at)


def test_ball_that_is_put_above_the_floor_by_numbers_falls_first() -> None:
    falls = asked(ball("[0, 0.3 m]", space=False), "time when ball hits the floor")
    assert falls.value == pytest.approx(math.sqrt(2 * (0.3 - R) / G), rel=1e-12)


@pytest.mark.parametrize(
    "shape", ["cylinder: {mass: m, radius: h/2, length: 0.3 m, axis: z}", "sphere: {mass: m, radius: h/2}"]
)
def test_what_lies_on_a_smooth_floor_in_space_stays_on_it(shape: str) -> None:
    system = fb.System.from_text(f"""
space: true
parameters: {{m: 1 kg, h: 0.2 m, v: 7 m/s, g: {G} m/s^2}}
ground: {{planes: {{floor: {{normal: up}}}}}}
bodies: {{b: {{{shape}, at: [0, h/2, 0], velocity: [v, 0, 0]}}}}
connections: {{c: {{contact: {{between: [b, ground.floor]}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{s: x of b}}
""")
    assert asked(system, "normal force of c").value == pytest.approx(G, rel=1e-12)
    assert asked(system, "height of b at t = 1 s").value == pytest.approx(0.1, rel=1e-12)
