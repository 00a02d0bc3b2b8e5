"""Balls that slide, spin and roll on planes in space, phase by phase in closed form, each worked out by hand.

With u = v + omega x r the slip of the point of contact, r = -R n, and I = 2/5 m R^2, friction -mu N u/|u| gives
u' = -7/2 mu (N/m) u/|u| beside what pulls along the plane: on the level the slip keeps its direction and ends after
2|u|/(7 mu g), the velocity is then 5/7 v - 2/7 omega x r (Coriolis 1835), and 1/7 m u^2 is lost.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrix
from freebody.study.phases.turned_along import TurnedAlong
from freebody.symbolic.spatial.balls import balls

M, R, G = 0.17, 0.028, 9.81
ALPHA = math.radians(20)
SLOPE = "[sin(alpha), cos(alpha), 0]"


def ball(
    velocity: str = "[0, 0, 0]", spin: str = "[0, 0, 0]", normal: str = "up", *, mu: float = 0.2, more: str = ""
) -> fb.System:
    return fb.System.from_text(f"""
space: true
parameters: {{m: {M} kg, R: {R} m, v: 2 m/s, w: 0.5 m/s, alpha: 20 deg, mu: {mu}, g: {G} m/s^2, L: 2 m,
             a: 30 rad/s, b: 15 rad/s, c: 40 rad/s}}
ground: {{planes: {{cloth: {{normal: {normal}}}}}}}
bodies: {{ball: {{sphere: {{mass: m, radius: R}}, velocity: {velocity}, angular_velocity: {spin}}}}}
connections: {{contact: {{contact: {{between: [ball, ground.cloth], friction: mu}}}}}}
loads: {{weight: {{gravity: g}}{more}}}
measures: {{s: x of ball, q: z of ball}}
start: {{s: 0 m, q: 0 m}}
""")


def asked(system: fb.System, question: str) -> fb.Answer:
    [answer] = system.solve(question).answers
    assert answer.expression is not None, answer.reason
    return answer


def test_ball_with_any_spin_runs_along_a_parabola_and_rolls_on() -> None:
    v, omega, r = np.array([2.0, 0.0, 0.5]), np.array([30.0, 15.0, 40.0]), np.array([0.0, -R, 0.0])
    u = v + np.cross(omega, r)
    slip, duration = math.hypot(*u), 2 * math.hypot(*u) / (7 * 0.2 * G)
    system = ball("[v, 0, w]", "[a, b, c]")
    rolls = (5 * v - 2 * np.cross(omega, r)) / 7
    place = v * duration - 0.5 * 0.2 * G * u / slip * duration**2
    assert asked(system, "time when rolling begins").value == pytest.approx(duration, rel=1e-12)
    for k, name in ((0, "s"), (2, "q")):
        found = asked(system, f"velocity of {name} when rolling begins")
        assert found.value == pytest.approx(rolls[k], rel=1e-12)
        assert found.conditions == ("for all positive parameters, 0 < α < 90°",)
        assert asked(system, f"{name} when rolling begins").value == pytest.approx(place[k], rel=1e-12)
        later = place[k] + rolls[k] * (3.0 - duration)
        assert asked(system, f"{name} after 3 s").value == pytest.approx(later, rel=1e-12)
    # what spins about the normal goes on, the rest is as rolling asks: v = R omega x n
    spins = (rolls[2] / R, 15.0, -rolls[0] / R)
    assert asked(system, "angular velocity of ball when rolling begins").value == pytest.approx(spins, rel=1e-12)
    lost = asked(system, "energy lost until rolling begins")
    assert lost.value == pytest.approx(M * slip**2 / 7, rel=1e-12)
    force = -0.2 * M * G * u / slip + np.array([0.0, M * G, 0.0])
    assert asked(system, "reaction of contact at start").value == pytest.approx(tuple(force), rel=1e-12)


def test_ball_without_forward_spin_rolls_on_with_five_sevenths_of_its_speed() -> None:
    found = asked(ball("[v, 0, 0]"), "velocity of s when rolling begins")
    assert found.value == pytest.approx(5 / 7 * 2.0, rel=1e-12)


def test_ball_rolls_down_an_incline_or_slides() -> None:
    """a = 5/7 g sin with friction 2/7 m g sin, while mu >= 2/7 tan; else g (sin - mu cos), R omega' = 5/2 mu g cos."""
    s, c = math.sin(ALPHA), math.cos(ALPHA)
    rolls = ball(normal=SLOPE)
    found = asked(rolls, "acceleration of s at start")
    assert found.value == pytest.approx(5 / 7 * G * s * c, rel=1e-12)  # s is level
    assert any("tan" in condition for condition in found.conditions)
    force = asked(rolls, "reaction of contact at start").value
    expected = M * G * (c * np.array([s, c, 0.0]) - 2 / 7 * s * np.array([c, -s, 0.0]))
    assert force == pytest.approx(tuple(expected), rel=1e-12)
    turns = asked(rolls, "angular acceleration of ball at start").value
    assert turns == pytest.approx((0.0, 0.0, -5 / 7 * G * s / R), rel=1e-12)
    speed = asked(rolls, "velocity of s when s = L").value
    assert speed == pytest.approx(math.sqrt(10 / 7 * G * s * 2.0 / c) * c, rel=1e-12)
    assert asked(rolls, "least mu without slip").value == pytest.approx(2 / 7 * s / c, rel=1e-12)
    slides = ball(normal=SLOPE, mu=0.05)
    assert asked(slides, "acceleration of s at start").value == pytest.approx(G * (s - 0.05 * c) * c, rel=1e-12)
    turns = asked(slides, "angular acceleration of ball at start").value
    assert turns == pytest.approx((0.0, 0.0, -2.5 * 0.05 * G * c / R), rel=1e-12)


def test_ball_that_rolls_across_an_incline_runs_along_a_parabola() -> None:
    """It rolls: v = R omega x n. Down the slope 5/7 g sin, across it the speed stays."""
    s, c = math.sin(ALPHA), math.cos(ALPHA)
    # R omega x n = (0, 0, w) with n = (s, c, 0): omega = (w/R) (c, -s, 0)
    system = ball("[0, 0, w]", "[w*cos(alpha)/R, -w*sin(alpha)/R, 0]", SLOPE)
    assert asked(system, "s after 1 s").value == pytest.approx(5 / 14 * G * s * c, rel=1e-12)
    assert asked(system, "q after 1 s").value == pytest.approx(0.5, rel=1e-12)


def test_ball_pushed_up_an_incline_slides_rolls_and_comes_back() -> None:
    """Without spin it is braked by g (sin + mu cos) and spun up until v = R omega."""
    s, c, mu = math.sin(ALPHA), math.cos(ALPHA), 0.2
    system = ball("[-v*cos(alpha), v*sin(alpha), 0]", normal=SLOPE)
    duration = 2.0 / (G * (s + 3.5 * mu * c))
    assert asked(system, "time when rolling begins").value == pytest.approx(duration, rel=1e-12)
    speed = 2.0 - G * (s + mu * c) * duration
    found = asked(system, "velocity of s when rolling begins").value
    assert found == pytest.approx(-speed * c, rel=1e-12)


def test_what_looks_at_the_orientation_of_a_ball_is_told_to() -> None:
    [answer] = ball("[v, 0, 0]", "[a, 0, c]").solve("angular velocity of ball along ball.x when rolling begins").answers
    assert answer.expression is None
    assert "this asks how ball is turned" in answer.reason


def test_a_body_is_a_ball_only_where_nothing_is_fixed_off_its_centre() -> None:
    pulled = """
space: true
parameters: {m: 1 kg, R: 0.1 m, k: 10 N/m, g: 9.81 m/s^2}
ground: {points: {wall: [1 m, 0.1 m, 0]}, planes: {floor: {normal: up}}}
bodies: {ball: {sphere: {mass: m, radius: R}, points: {PLACE}}}
connections: {contact: {contact: {between: [ball, ground.floor], friction: 0.3}}}
loads: {weight: {gravity: g}, spring: {spring: {first: WHERE, second: ground.wall, stiffness: k, length: 0.5 m}}}
"""
    rim = fb.System.from_text(pulled.replace("PLACE", "rim: [R, 0, 0]").replace("WHERE", "ball.rim"))
    assert balls(rim) == frozenset()
    assert balls(ball()) == {"ball"}


def test_balls_turn_as_their_angular_velocity_says() -> None:
    """By a constant one about its axis; by one that grows along an axis by its integral."""
    reference = Reference(
        ball(), {"m": M, "R": R, "v": 0, "w": 0, "alpha": 0, "mu": 0.2, "g": G, "L": 1, "a": 0, "b": 0, "c": 0}
    )
    along = TurnedAlong(reference, ["ball"])
    axis, q = np.array([0.6, 0.0, 0.8]), np.zeros(6)
    for steady, growing, angle in ((20.0, 0.0, 20.0), (0.0, 30.0, 15.0)):

        def state(t: float, a: float = steady, b: float = growing) -> np.ndarray:
            return np.concatenate([q, q[:3], (a + b * t) * axis])

        turns = along.on(along.at_first(), state, 0.0, 1.0)
        found, _v = along.turned(q, q, turns)
        assert matrix(found[3:]) == pytest.approx(matrix(angle * axis), abs=1e-9)


@pytest.mark.parametrize("language", ["en", "de"])
@pytest.mark.parametrize(
    "question", ["time when rolling begins", "velocity of q when rolling begins", "energy lost until rolling begins"]
)
def test_balls_are_derived(language: str, question: str) -> None:
    told = str(ball("[v, 0, w]", "[a, b, c]").explain(question, language=language))
    assert "no derivation" not in told
    assert "keine Herleitung" not in told


@pytest.mark.parametrize("question", ["acceleration of s at start", "velocity of s when s = L"])
def test_rolling_on_an_incline_is_derived_with_both_parts_of_friction(question: str) -> None:
    told = str(ball(normal=SLOPE).explain(question))
    assert "no derivation" not in told
    assert "2⋅m⋅g⋅sin(α)" in told or "2⋅tan(α)" in told


@pytest.mark.parametrize("velocity", ["[v, 0, 0]", "[0, 0, v]", "[v, 0, w]"])
def test_turns_until_a_ball_rolls_are_counted_about_its_own_axis(velocity: str) -> None:
    # omega grows evenly to 5/7 v/R in the time 2 v/(7 mu g): 5 v^2/(98 pi mu g R) turns, whichever way it goes
    speed = math.hypot(*(2.0 if x == "v" else 0.5 if x == "w" else 0.0 for x in velocity.strip("[]").split(", ")))
    answer = asked(ball(velocity), "turns of ball until rolling begins")
    assert answer.value == pytest.approx(5 * speed**2 / (98 * math.pi * 0.2 * G * R), rel=1e-12)


def test_turns_of_a_wheel_about_a_bearing_in_space() -> None:
    # phi = w t + T t^2/(2 J)
    system = fb.System.from_text("""
space: true
parameters: {J: 0.2 kg m^2, T: 3 N m, w: 4 rad/s, t1: 2 s}
bodies: {wheel: {body: {mass: 1 kg, inertia: J}}}
connections: {c: {revolute: {first: ground.O, second: wheel, about: x}}}
loads: {m: {torque: {on: wheel, about: x, magnitude: T}}}
measures: {th: angle of wheel about x}
start: {th: 0, rate(th): w}
""")
    assert asked(system, "turns of wheel at t = t1").value == pytest.approx((8 + 30) / (2 * math.pi), rel=1e-12)


def test_turns_of_a_ball_whose_spin_turns_its_axis_are_refused() -> None:
    [answer] = ball("[v, 0, w]", "[a, b, c]").solve("turns of ball until rolling begins").answers
    assert "axis keeps its direction" in answer.reason
