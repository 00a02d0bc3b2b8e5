"""Extremes of a motion are calculated with: differences from the start, sizes, ratios; each derived by hand here."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

import freebody as fb
from posed import is_derived, is_formula, posed

HUNG = """
parameters: {m: 2 kg, k: 80 N/m, g: 9.81 m/s^2, v: SPEED}
bodies: {ball: {particle: {mass: m}}}
connections: {guide: {slider: {body: ball, along: up, through: ground.O}}}
loads: {w: {gravity: g}, s: {law: {measure: y, force: -k*y}}}
measures: {y: y of ball}
start: {y: 0, rate(y): v}
"""
PENDULUM = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2, theta_0: 60 deg}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down}
start: {theta: theta_0, rate(theta): 0}
"""
ON_SPRING = """
parameters: {m: 1 kg, k: 200 N/m, v0: 1 m/s}
bodies: {b: {particle: {mass: m}}}
connections: {g: {slider: {body: b, along: right}}}
loads: {s: {law: {measure: y, force: -k*y}}}
measures: {y: {x of b}}
start: {y: 0, rate(y): v0}
"""
DROP, REACH = 2 * 9.81 / 80, math.hypot(2 * 9.81 / 80, math.sqrt(2 / 80) * 1.5)  # m g/k; sqrt((m g/k)^2 + m v^2/k)


@pytest.mark.parametrize(
    ("model", "question", "by_hand"),
    [
        # about the equilibrium -m g/k the ball swings by REACH
        (HUNG.replace("SPEED", "1.5 m/s"), "(greatest y) - (y at start)", REACH - DROP),
        (HUNG.replace("SPEED", "1.5 m/s"), "(greatest y) - (least y)", 2 * REACH),
        (HUNG.replace("SPEED", "1.5 m/s"), "greatest change of y", REACH + DROP),  # downwards
        (HUNG.replace("rate(y): v", "rate(y): 0").replace(", v: SPEED", ""), "greatest change of y", 2 * DROP),
        (HUNG.replace("SPEED", "1.5 m/s"), "k*(greatest y)/m", 80 * (REACH - DROP) / 2),
        # theta'' = -(g/L) sin theta; tension m g (3 cos theta - 2 cos theta_0)
        (PENDULUM, "greatest |acceleration of theta|", 9.81 / 0.5 * math.sin(math.pi / 3)),
        (PENDULUM, "(greatest |acceleration of theta|)*L/g", math.sin(math.pi / 3)),
        (PENDULUM, "(greatest tension of rod)/(tension of rod at start)", 4.0),
        (PENDULUM, "|least theta|", math.pi / 3),
        (PENDULUM, "größte Änderung von theta", 2 * math.pi / 3),
    ],
)
def test_extremes_are_calculated_with(model: str, question: str, by_hand: float) -> None:
    (answer,) = fb.System.from_text(model).solve(question).answers
    assert answer.expression is not None
    assert answer.evidence is not None
    assert answer.value == pytest.approx(by_hand)


@pytest.mark.parametrize(
    ("model", "question"),
    [
        (HUNG.replace("SPEED", "1.5 m/s"), "greatest change of y"),
        (PENDULUM, "(greatest tension of rod)/(tension of rod at start)"),
    ],
)
def test_each_of_them_is_derived_and_then_put_together(model: str, question: str) -> None:
    told = is_derived(model, question)
    assert "what is asked becomes" in told["en"]
    assert "wird das Gesuchte zu" in told["de"]


def test_an_extreme_that_a_law_of_motion_tells_is_derived_by_its_first_turn() -> None:
    # m y'' = -m g - b y': with k = b/m it turns at t = log(1 + k v/g)/k, at v/k - g log(1 + k v/g)/k^2
    resisted = HUNG.replace("SPEED", "1.5 m/s").replace("force: -k*y", "force: -k*rate(y)").replace("N/m,", "N s/m,")
    (answer,) = fb.System.from_text(resisted).solve("greatest y").answers
    assert answer.value == pytest.approx(1.5 / 40 - 9.81 * math.log(1 + 40 * 1.5 / 9.81) / 40**2)
    assert "y' = 0" in is_derived(resisted, "greatest y")["en"]


def test_what_is_meant_at_no_instant_is_asked_for_one() -> None:
    with pytest.raises(fb.FreebodyError, match="when it is meant"):
        fb.System.from_text(PENDULUM).solve("(greatest theta) - (tension of rod)*m/m")


def test_without_a_greatest_value_there_is_no_greatest_change() -> None:
    text = HUNG.replace("SPEED", "1.5 m/s").replace(", s: {law: {measure: y, force: -k*y}}", "")
    (answer,) = fb.System.from_text(text).solve("greatest change of y").answers  # it falls on and on
    assert answer.value is None
    assert answer.reason


@pytest.mark.parametrize("said", ["greatest y", "(greatest y)", "((greatest y))"])
def test_brackets_around_one_quantity_change_nothing(said: str) -> None:
    """v0 = A sqrt(k/m), so k = m v0^2/A^2."""
    is_formula(ON_SPRING, f"value of k for which {said} = 0.1 m", "100*m*v0^2")


FALLING_ROD = """
parameters: {m: 2 kg, L: 1.5 m, theta_0: 20 deg, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {foot: {pin: [ground.F, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from rod.start to rod.end from up clockwise}
start: {theta: theta_0, rate(theta): 0}
"""


def _pushed(theta: float) -> tuple[float, float]:
    """A rod falls about its foot, over m g: H = 3 sin (3 cos - 2 cos_0)/4, V = (1 + 9 cos^2 - 6 cos_0 cos)/4."""
    c, c0 = math.cos(theta), math.cos(math.radians(20))
    return 3 * math.sin(theta) * (3 * c - 2 * c0) / 4, (1 + 9 * c * c - 6 * c0 * c) / 4


def _less(h: float, v: float) -> float:
    return (v - h) * 2 * 9.81


def _over(h: float, v: float) -> float:
    return abs(h) / v


@pytest.mark.parametrize(
    ("question", "by_hand"),
    [
        ("greatest vertical reaction of foot - horizontal reaction of foot until theta = 60 deg", _less),
        ("greatest |horizontal reaction of foot|/vertical reaction of foot until theta = 60 deg", _over),
    ],
)
def test_the_extreme_until_an_event_is_one_of_all_that_is_calculated(
    question: str, by_hand: Callable[[float, float], float]
) -> None:
    """The first quantity had its extreme in all of the motion, and the other its value at the event."""
    angles = [math.radians(20 + 40 * k / 4000) for k in range(4001)]
    most = max(by_hand(*_pushed(theta)) for theta in angles)
    assert posed(FALLING_ROD, question).value == pytest.approx(most, rel=1e-6)


@pytest.mark.parametrize(("when", "theta"), [("at start", 20), ("when theta = 30 deg", 30)])
@pytest.mark.parametrize("bottom", ["vertical reaction of foot", "|vertical reaction of foot|"])
def test_a_ratio_of_sizes_is_meant_at_one_instant(when: str, theta: float, bottom: str) -> None:
    h, v = _pushed(math.radians(theta))
    answer = posed(FALLING_ROD, f"ratio of |horizontal reaction of foot| to {bottom} {when}")
    assert answer.value == pytest.approx(h / v)
