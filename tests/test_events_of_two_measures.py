"""When two measures are alike, or their rates: meetings, equal speeds; each derived by hand here."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from posed import is_derived, is_formula, posed

CLUTCH = """
parameters: {J1: 2 kg m^2, J2: 3 kg m^2, w1: 50 rad/s, M: 20 N m}
ground: {points: {O: [0, 0], P: [1 m, 0]}}
bodies: {a: {body: {mass: 1 kg, inertia: J1}}, b: {body: {mass: 1 kg, inertia: J2}}}
connections: {first: {pin: [ground.O, a.center]}, second: {pin: [ground.P, b.center]}}
loads: {slip: {torque: {on: a, magnitude: -M}}, drive: {torque: {on: b, magnitude: M}}}
measures: {f1: angle of a, f2: angle of b}
start: {f1: 0, f2: 0, rate(f1): w1, rate(f2): 0}
"""
STONES = """
parameters: {h: 40 m, v: 25 m/s, g: 9.81 m/s^2}
bodies: {low: {particle: {mass: 1 kg}}, high: {particle: {mass: 2 kg}}}
connections:
  left: {slider: {body: low, along: up, through: ground.O}}
  right: {slider: {body: high, along: up, through: ground.O}}
loads: {weight: {gravity: g}}
measures: {y1: y of low, y2: y of high}
start: {y1: 0, y2: h, rate(y1): v, rate(y2): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # w1 - M t/J1 = M t/J2: one momentum J1 w1 for both
        (CLUTCH, "time until rate(f1) = rate(f2)", "J1*J2*w1/(M*(J1 + J2))"),
        (CLUTCH, "rate of f1 when velocity of f1 = velocity of f2", "J1*w1/(J1 + J2)"),
        (CLUTCH, "rate of f1 when f1' = f2'", "J1*w1/(J1 + J2)"),
        (CLUTCH, "time until f1 = f2", "2*J1*J2*w1/(M*(J1 + J2))"),
        (CLUTCH, "time until rate(f1) = 2*rate(f2)", "w1/(M/J1 + 2*M/J2)"),
        # both fall alike: they meet after h/v
        (STONES, "time until y1 = y2", "h/v"),
        (STONES, "y1 when y1 = y2", "h - g*h^2/(2*v^2)"),
        (STONES, "time until y2 = y of low", "h/v"),
        (STONES, "value of v for which y1 when y1 = y2 is 0", "sqrt(g*h/2)"),
    ],
)
def test_when_two_measures_are_alike(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


@pytest.mark.parametrize(
    ("model", "question"),
    [(CLUTCH, "time until rate(f1) = rate(f2)"), (CLUTCH, "time until f1 = f2"), (STONES, "y1 when y1 = y2")],
)
def test_it_is_derived_by_the_laws_of_both(model: str, question: str) -> None:
    told = is_derived(model, question)
    assert "give the first t > 0" in told["en"]


def test_what_has_another_dimension_is_refused() -> None:
    with pytest.raises(fb.ModelError, match=r"unit|dimension|expected"):
        fb.System.from_text(STONES).solve("time until y1 = angle of line from low to high")


def test_with_friction_it_ends_as_the_slip_does() -> None:
    # m x1'' = -mu m g, M x2'' = mu m g; at x1' = 2 x2' the momentum m v0 is that of 2 m + M
    plank = """
parameters: {m: 2 kg, M: 6 kg, mu: 0.4, v0: 5 m/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {plank: {body: {mass: M, inertia: 1 kg m^2}, lines: {top: {along: right}}}, block: {particle: {mass: m}}}
connections:
  guide: {slider: {body: plank, along: right, through: ground.O}}
  touch: {contact: {between: [block, plank.top], friction: mu}}
loads: {weight: {gravity: g}}
measures: {x1: x of block, x2: x of plank}
start: {x1: 0, x2: 0, rate(x1): v0, rate(x2): 0}
"""
    is_formula(plank, "time until rate(x1) = rate(x2)", "v0/(mu*g*(1 + m/M))")
    is_formula(plank, "rate of x2 when rate(x1) = 2*rate(x2)", "m*v0/(2*m + M)")


FALLING = """
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {bar: {rod: {mass: m, length: L}}}
ground: {points: {O: [0, 0]}}
connections: {O: {pin: [ground.O, bar.start]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of bar}
start: {theta: 60 deg, rate(theta): 0}
"""


@pytest.mark.parametrize(
    ("condition", "height"),
    [
        ("cos(theta) = 1/3", -math.sqrt(8) / 3),
        ("sin(theta) = 1/2", 0.5),
        ("2*theta = 90 deg", math.sqrt(0.5)),
        ("bar is horizontal", 0.0),
        ("bar is vertical", -1.0),
    ],
)
def test_an_event_may_be_an_equation_of_a_function_of_measures(condition: str, height: float) -> None:
    """omega^2 = 3 g/L (sin 60 deg - sin theta) of a rod that falls about its end, turning clockwise."""
    answer = fb.System.from_text(FALLING).solve(f"angular velocity of bar when {condition}")["q1"]
    assert answer.value == pytest.approx(-math.sqrt(3 * 9.81 * (math.sqrt(0.75) - height)), rel=1e-12)


def test_words_about_a_function_are_not_taken_for_words_about_its_argument() -> None:
    with pytest.raises(fb.ModelError):
        fb.System.from_text(FALLING).solve("angular velocity of bar when it has cos(theta) = 1/3 rad")


THROWN_PAST_A_POINT = """
parameters: {v0: 20 m/s, beta: 60 deg, g: 9.81 m/s^2, h: 1 m}
ground: {points: {O: [0, 0]}}
bodies: {ball: {particle: {mass: 1 kg}, at: [-3*h, -h], velocity: [v0*cos(beta), v0*sin(beta)]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.O to ball}
"""


def test_a_ball_is_seen_under_an_angle_where_it_is_on_that_half_of_the_line() -> None:
    # it rises through the level of O on the left of it, where the angle is -180 deg: v0 sin(beta) t - g t^2/2 = h
    root = "(v0*sin(beta)-sqrt(v0^2*sin(beta)^2-2*g*h))/g"
    is_formula(THROWN_PAST_A_POINT, "time when theta = -180 deg", root)
    found = posed(THROWN_PAST_A_POINT, "time when theta = 0")  # on the right it comes down after a whole turn
    assert found.expression is None


BUFFER = """
parameters: {m1: 2 kg, m2: 3 kg, v0: 4 m/s, k: 800 N/m}
bodies: {a: {particle: {mass: m1}}, b: {particle: {mass: m2}}}
connections: {ga: {slider: {body: a, along: right}}, gb: {slider: {body: b, along: right}}}
measures: {x1: x of a, x2: x of b, gap: x of b from a}
loads: {spring: {law: {measure: gap, force: -k*gap}}}
start: {x1: 0, x2: 0, rate(x1): v0, rate(x2): 0}
"""


@pytest.mark.parametrize("what", ["x1 - x2", "(x1 - x2)"])
@pytest.mark.parametrize("event", ["turns back", "is greatest"])
def test_a_difference_of_two_measures_turns_back(what: str, event: str) -> None:
    """The spring is shortest when both move as their mass centre, v0 m1/(m1 + m2), a quarter of a period on;
    then the first is m2/(m1 + m2) of v0/omega ahead of it, omega^2 = k (m1 + m2)/(m1 m2)."""
    omega, along = math.sqrt(800 * 5 / 6), 4 * 2 / 5
    assert posed(BUFFER, f"velocity of x2 when {what} {event}").value == pytest.approx(along)
    assert posed(BUFFER, f"time when {what} {event}").value == pytest.approx(math.pi / 2 / omega)
    there = along * math.pi / 2 / omega + 3 / 5 * 4 / omega
    assert posed(BUFFER, f"x1 when {what} {event}").value == pytest.approx(there)
