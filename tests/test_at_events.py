"""What is calculated from quantities at different events of one motion."""

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.errors import ModelError
from freebody.language.expression import Expr
from freebody.language.notation import to_python

FALL = """
parameters: {m: 1 kg, g: 9.81 m/s^2, h: 20 m, b: 5 m}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {y: height of ball}
start: {y: h, rate(y): 0}
"""
INCLINE = """
parameters: {m: 2 kg, M: 1 kg, R: 0.1 m, g: 9.81 m/s^2, alpha: 20 deg, d: 1 m}
ground: {lines: {slope: {along: -alpha}}}
bodies:
  disk: {disk: {mass: m, radius: R}}
connections: {roll: {rolling: {body: disk, on: ground.slope}}}
loads: {weight: {gravity: g}}
measures: {s: displacement of disk along -alpha}
start: {s: 0, rate(s): 0}
"""


def formula(model: str, asked: str) -> str:
    found = fb.System.from_text(model).solve(asked)["q1"].expression
    assert isinstance(found, Expr)
    return to_python(found)


@pytest.mark.parametrize(
    "asked",
    ["(time when y = 0) - (time when y = b)", "time between y = b and y = 0", "time from when y = b until when y = 0"],
)
def test_the_last_part_of_a_fall_takes_the_difference_of_two_times(asked: str) -> None:
    """h - y = g t^2/2 at both places."""
    expected = "sqrt(2*h/g) - sqrt(2*(h - b)/g)"
    assert_same_function(formula(FALL, asked), expected, {"h": 20.0, "b": 5.0, "g": 9.81})


def test_places_of_events_may_be_calculated() -> None:
    """sqrt(2 (3/4) h/g) - sqrt(2 (1/4) h/g) = (sqrt(3) - 1) sqrt(h/(2 g))."""
    assert_same_function(
        formula(FALL, "time between y = 3*h/4 and y = h/4"), "(sqrt(3) - 1)*sqrt(h/(2*g))", {"g": 9.81}
    )


def test_the_time_for_the_second_metre_of_a_rolling_disk() -> None:
    """s = a t^2/2 with a = (2/3) g sin(alpha)."""
    expected = "(sqrt(2) - 1)*sqrt(2*d/(2*g*sin(alpha)/3))"
    assert_same_function(
        formula(INCLINE, "time between s = d and s = 2*d"), expected, {"alpha": 0.35, "d": 1.0, "g": 9.81}
    )


def test_what_is_gained_between_two_places() -> None:
    """v_1^2 - v_2^2 = 2 g b, and the condition of the place above is kept."""
    found = fb.System.from_text(FALL).solve("(speed of ball when y = 0)^2 - (speed of ball when y = b)^2")["q1"]
    assert isinstance(found.expression, Expr)
    assert_same_function(to_python(found.expression), "2*g*b", {"g": 9.81})
    assert any("h > b" in str(condition) for condition in found.conditions)


def test_what_is_not_said_of_one_quantity_is_asked_for() -> None:
    with pytest.raises(ModelError, match="say of each quantity"):
        fb.System.from_text(FALL).solve("(velocity of y) + (speed of ball when y = 0) + (speed of ball when y = b)")


def test_one_event_has_no_time_between_it_and_itself() -> None:
    """Where it comes twice, as what is thrown up, the time between is not zero, and each is the first one."""
    with pytest.raises(ModelError, match="meant twice"):
        fb.System.from_text(FALL).solve("time between y = b and y = b")


def test_sizes_and_the_start_belong_to_their_own_quantity() -> None:
    """v^2 = v_0^2 + 2 g (h - y) of what is thrown to the side; energies by that of the start."""
    thrown = FALL.replace("measures: {", "measures: {x: x of ball, ").replace(
        "start: {", "start: {x: 0, rate(x): 4 m/s, "
    )
    found = fb.System.from_text(thrown).solve("|velocity of ball when y = 0| - |velocity of ball when y = b|")["q1"]
    assert found.value == pytest.approx((16 + 2 * 9.81 * 20) ** 0.5 - (16 + 2 * 9.81 * 15) ** 0.5)
    asked = "kinetic energy of ball when y = 0 - kinetic energy of ball when y = b + kinetic energy of ball at start"
    assert fb.System.from_text(thrown).solve(asked)["q1"].value == pytest.approx(9.81 * 5 + 8)
