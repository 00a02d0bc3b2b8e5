"""What must hold from the start to an event: as conditions on the parameters, and judged on the whole way.

Problem families: Meriam & Kraige, Dynamics, sec. 3/6 and 6/6; Beer & Johnston, Dynamics, ch. 13 and 17.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb

G = 9.81
LOOP = """
parameters: {{m: 1 kg, r: 0.1 m, R: 0.8 m, g: 9.81 m/s^2, v: {v} m/s}}
bodies: {{pipe: {{ring: {{radius: R}}, fixed: true}}, disk: {{disk: {{mass: m, radius: r}}, at: [0, r - R]}}}}
connections: {{contact: {{rolling: {{body: disk, inside: pipe}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{phi: {{angle of line from ground.origin to disk from down}}}}
start: {{phi: 0, rate(phi): v/(R - r)}}
"""
BOB = """
parameters: {{m: 1 kg, L: 1 m, g: 9.81 m/s^2, w: {w} rad/s}}
bodies: {{bob: {{particle: {{mass: m}}, at: [0, -L]}}}}
connections: {{cord: {{string: {{from: ground.O, to: bob, swings: true}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{th: {{angle of line from ground.O to bob from down}}}}
start: {{th: 0, rate(th): w}}
"""
CRANK = """
parameters: {r: 0.1 m, l: 0.4 m, w: 3 rad/s}
bodies: {crank: {rod: {length: r}}, rod: {rod: {length: l}, near: {angle: 0}}, piston: {particle: {}}}
connections:
  main: {pin: [ground.O, crank.start]}
  crankpin: {pin: [crank.end, rod.start]}
  wristpin: {pin: [rod.end, piston]}
  cylinder: {slider: {body: piston, along: right, through: ground.O}}
  motor: {driver: {measure: angle of crank, follows: w*t}}
measures: {x: x of piston, theta: angle of crank}
"""


def asked(text: str, question: str) -> fb.Answer:
    return fb.System.from_text(text).solve(question).answers[0]


def test_a_wheel_comes_to_the_top_of_a_loop_only_where_it_is_pressed_on_all_the_way() -> None:
    """N = m (g cos phi + (R - r) phi'^2) with phi'^2 by energy is least at the top: 3 v^2 >= 11 g (R - r)."""
    least = math.sqrt(11 * G * 0.7 / 3)
    for v, is_so in ((0.95 * least, False), (1.05 * least, True)):
        answer = asked(LOOP.format(v=v), "velocity of phi when phi = 180 deg")
        assert "11·r·g + 3·v² ≥ 11·R·g (contact keeps touching)" in answer.conditions
        assert not any("start to the event" in text for text in answer.conditions)
        told = [note for note in answer.notes if "Not valid for the given numbers" in note]
        assert bool(told) is not is_so
        right = math.sqrt((3 * v * v - 8 * G * 0.7) / 3) / 0.7
        assert answer.value == (pytest.approx(right) if is_so else None)


@pytest.mark.parametrize("degrees", [40, 130, 170])
def test_a_bob_on_a_string_gets_no_further_than_the_string_is_taut(degrees: int) -> None:
    """T = m (L w^2 - 2 g + 3 g cos th) falls all the way up: slack at cos th = (2 g - L w^2)/(3 g), 140 deg."""
    assert math.degrees(math.acos((2 * G - 6.5**2) / (3 * G))) == pytest.approx(140.3, abs=0.1)
    answer = asked(BOB.format(w=6.5), f"velocity of th when th = {degrees} deg")
    right = math.sqrt(6.5**2 - 2 * G * (1 - math.cos(math.radians(degrees))))
    assert answer.value == (pytest.approx(right) if degrees < 140 else None)


def test_a_bob_on_its_way_back_has_been_where_it_turns() -> None:
    """Back at the bottom after a swing beyond the level of the hook the string has been slack; below it has not."""
    for w, is_so in ((4.2, True), (5.0, False)):
        answer = asked(BOB.format(w=w), "velocity of th when th = 0")
        assert (answer.value is not None) is is_so
        if is_so:
            assert answer.value == pytest.approx(-w)


def test_a_loop_needs_to_close_up_to_the_event_only() -> None:
    assert asked(CRANK, "velocity of x when theta = 60 deg").conditions == ("4·l² > 3·r² (can be assembled)",)
    assert asked(CRANK, "x when theta = 90 deg").conditions == ("l ≥ r (can be assembled)",)


@pytest.mark.parametrize(
    "question", ["x when theta = 150 deg", "velocity of x when theta = 120 deg", "x when rate(x) = 0"]
)
def test_a_loop_passes_no_pose_in_which_it_just_closes(question: str) -> None:
    """With l = r the rod stands across the guide at 90 deg, and the piston may stay there or go on."""
    assert asked(CRANK, question).conditions == ("l > r (can be assembled)",)
    answer = asked(CRANK.replace("l: 0.4 m", "l: 0.1 m"), question)
    assert answer.value is None
    assert "Not valid for the given numbers: l > r (can be assembled)" in answer.notes


def test_an_event_of_a_rate_needs_the_loop_to_close_with_room() -> None:
    # the rod is slowest where the crank is upright, if it does not get upright itself: there it turns on with l = r
    text = CRANK.replace("theta: angle of crank", "theta: angle of crank, phi: angle of rod")
    assert "l > r (can be assembled)" in asked(text, "x when rate(phi) = 0").conditions


def test_what_is_but_round_off_of_its_terms_is_zero() -> None:
    """0.1 m + 0.7 m is less than 0.8 m in doubles: as written the rod is as long as the crank."""
    assert 0.8 - 0.1 - 0.7 > 0.0
    text = CRANK.replace("r: 0.1 m, l: 0.4 m", "r1: 0.1 m, r2: 0.7 m, l: 0.8 m").replace(
        "length: r}", "length: r1 + r2}"
    )
    answer = asked(text, "velocity of x when theta = 120 deg")
    assert answer.value is None
    assert any("Not valid for the given numbers: l > r₁ + r₂" in note for note in answer.notes)


def test_the_limit_of_a_damped_oscillation_is_that_of_all_dampings() -> None:
    text = """
parameters: {{m: 2 kg, c: {c} N s/m, k: 50 N/m, F: 7 N}}
bodies: {{b: {{particle: {{mass: m}}}}}}
connections: {{guide: {{slider: {{body: b, along: right}}}}}}
measures: {{x: x of b}}
loads: {{pull: {{law: {{measure: x, force: F - k*x - c*rate(x)}}}}}}
start: {{x: 0.1 m, rate(x): 0}}
"""
    for c in (3, 20, 90):  # below, at and above the critical one
        answer = asked(text.format(c=c), "x as t grows")
        assert answer.value == pytest.approx(7 / 50)
        assert answer.conditions == ("for all positive parameters",)


@pytest.mark.parametrize("drive", ["driven", "free"])
def test_a_loop_closes_at_the_event_where_the_answer_has_no_rod_in_it(drive: str) -> None:
    """A slider-crank with its crank across the guide: the piston moves as the crank pin, -r w, whatever the rod is, if
    it is long enough to get there. Free, with the mass of the piston alone, the energy m x'^2/2 stays."""
    text = """
parameters: {r: 0.1 m, l: 0.3 m, w: 20 rad/s, m: 1 kg, a: 30 deg}
bodies:
  crank: {rod: {mass: 0 kg, length: r}, at: {start: [0, 0]}, angle: a}
  rod: {rod: {mass: 0 kg, length: l}}
  piston: {particle: {mass: m}}
connections:
  bearing: {pin: [ground.O, crank.start]}
  big: {pin: [crank.end, rod.start]}
  small: {pin: [rod.end, piston]}
  bore: {slider: {body: piston, along: right}}
measures: {theta: angle of crank, x: x of piston}
"""
    motor = "  motor: {driver: {measure: theta, follows: a + w*t}}\nmeasures"
    text = text.replace("measures", motor) if drive == "driven" else text + "start: {rate(theta): w}\n"
    found = fb.solve(fb.System.from_text(text), "velocity of x when theta = 90 deg").answers[0]
    assert found.expression is not None, found.reason
    # with l = r the piston comes at -2 r w and stays
    assert any("l > r" in c for c in found.conditions), found.conditions
    s, c = math.sin(math.radians(30)), math.cos(math.radians(30))
    at_start = -20 * 0.1 * s * (1 + 0.1 * c / math.sqrt(0.3**2 - (0.1 * s) ** 2))
    assert found.value == pytest.approx(-2.0 if drive == "driven" else at_start, rel=1e-9)
