"""What another value of a parameter does to a quantity, by the formula of the quantity itself."""

from __future__ import annotations

import math

import pytest

from freebody.api import System
from freebody.errors import ModelError
from freebody.language.notation import to_text

PENDULUM = """
parameters: {m: 0.5 kg, L: 1.2 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {string: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {phi: {angle of line from ground.O to bob from down}}
start: {phi: 40 deg, rate(phi): 0}
"""
BLOCK = """
parameters: {m: 3 kg, theta: 25 deg, mu: 0.3, v0: 4 m/s, g: 9.81 m/s^2}
ground: {lines: {incline: {along: theta}}}
bodies: {block: {particle: {mass: m}}}
connections: {contact: {contact: {between: [block, incline], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: {travel of block along incline}}
start: {x: 0, rate(x): v0}
"""


def value(text: str, find: str) -> float:
    answer = System.from_text(text).solve(find).answers[0]
    assert isinstance(answer.value, float), answer.reason
    return answer.value


@pytest.mark.parametrize(
    ("find", "expected"),
    [
        ("factor of period of small oscillations as L -> 2*L", math.sqrt(2)),
        ("reduction factor of period of small oscillations as L -> 2*L", 1 / math.sqrt(2)),
        ("relative increase of period of small oscillations as L -> 1.21*L", 0.1),
        ("relative decrease of speed of bob when phi = 0 as L -> 0.81*L", 0.1),
        ("factor of period of small oscillations as m -> 2*m", 1.0),
        ("increase of period of small oscillations as L -> 4*L", 2 * math.pi * math.sqrt(1.2 / 9.81)),
        ("decrease of period of small oscillations as L -> L/4", math.pi * math.sqrt(1.2 / 9.81)),
    ],
)
def test_a_pendulum_goes_with_the_root_of_its_length(find: str, expected: float) -> None:
    assert value(PENDULUM, find) == pytest.approx(expected)


def test_a_power_law_has_a_number_as_its_factor() -> None:
    answer = System.from_text(PENDULUM).solve("factor of speed of bob when phi = 0 as L -> 2*L").answers[0]
    assert to_text(answer.expression) == "√(2)"


def test_the_other_value_is_that_of_the_answer_with_it() -> None:
    for find in ("time when block stops", "x when block stops"):
        twice = value(BLOCK.replace("mu: 0.3", "mu: 0.6"), find)
        once = value(BLOCK, find)
        assert value(BLOCK, f"factor of {find} as mu -> 2*mu") == pytest.approx(twice / once)
        assert value(BLOCK, f"increase of {find} as mu -> 2*mu") == pytest.approx(twice - once)


def test_what_grows_without_bound_has_no_factor() -> None:
    answer = System.from_text(PENDULUM).solve("factor of period of small oscillations as L grows").answers[0]
    assert answer.expression is None
    assert "without bound" in str(answer.reason)


def test_what_moves_has_a_factor_at_an_instant_that_is_said() -> None:
    with pytest.raises(ModelError, match="say when phi is meant"):
        System.from_text(PENDULUM).asked("factor of phi as L -> 2*L")
    assert System.from_text(PENDULUM).asked("factor of phi at start as L -> 2*L")
