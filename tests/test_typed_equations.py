"""Typed equations of motion: right if they hold on every motion of the model."""

from __future__ import annotations

from functools import cache
from itertools import takewhile
from pathlib import Path

import pytest

import freebody as fb

EXAMPLES = Path(__file__).parents[1] / "examples"
NEWTON = "m1 g - T1 = m1 x1''; T2 - m2 g = m2 x1''; (T1 - T2) R = 1/2 M R^2 x1''/R"
CART = "(M+m) x'' + m L/2 (θ'' cos θ - θ'² sin θ) = F"
ROD = "m L/2 x'' cos θ + m L²/3 θ'' + m g L/2 sin θ = 0"


@cache
def system(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


@pytest.mark.parametrize(
    ("example", "equations", "verdict", "words"),
    [
        ("simple_pendulum", "θ'' = -g/L sin θ", "correct", ""),
        ("simple_pendulum", r"mL^2\ddot\theta + mgL\sin\theta = 0", "correct", ""),
        ("simple_pendulum", "m L² θ'' - m g L sin θ = 0", "incorrect", "-m·g·L·sin(θ) has the wrong sign"),
        ("simple_pendulum", "m L² θ'' + m g L cos θ = 0", "incorrect", "does not hold"),
        ("simple_pendulum", "m L² θ'' + 2 m g L sin θ = 0", "incorrect", "a factor 2 too many"),
        ("simple_pendulum", "m L θ'' + m g L sin θ = 0", "incorrect", "unlike units"),
        ("simple_pendulum", "θ' = θ'", "incorrect", "says nothing"),
        ("simple_pendulum", "1/2 m L² θ'² - m g L cos θ = -m g L", "undecided", "one start only"),
        ("simple_pendulum", "θ''", "unreadable", "not one equation"),
        ("atwood_machine", NEWTON, "correct", "determines it"),
        ("atwood_machine", "; ".join(reversed(NEWTON.split(";"))), "correct", "determines it"),
        ("atwood_machine", NEWTON.replace("1/2 M", "M"), "incorrect", "does not hold"),
        ("atwood_machine", NEWTON.replace("T2 - m2 g", "T2 + m2 g"), "incorrect", "does not hold"),
        ("atwood_machine", "m1 g - T1 = m1 x1''; T2 - m2 g = m2 x1''; T1 = T2", "incorrect", "1, 2 and 3"),
        ("atwood_machine", "m1 g - T1 = m1 x1''", "incorrect", "x₁'' is not determined"),
        ("atwood_machine", "(m1+m2+M/2) x1'' = (m1-m2) g", "correct", ""),
        ("cart_and_pendulum", f"{CART}; {ROD}", "correct", "determines it"),
        ("cart_and_pendulum", f"{ROD}\n{CART}", "correct", "determines it"),
        ("cart_and_pendulum", CART, "incorrect", "θ'' is not determined"),
        ("cart_and_pendulum", f"{CART}; {ROD}; {ROD}", "correct", "equation 3 follows"),
        ("cart_and_pendulum", f"{CART.replace('- θ', '+ θ')}; {ROD}", "incorrect", "wrong sign"),
    ],
)
def test_equations_are_right_if_they_hold_on_every_motion(
    example: str, equations: str, verdict: str, words: str
) -> None:
    found = system(example).check("equations of motion", equations)
    assert found.verdict == verdict
    assert words in f"{found.reason} {found.mistake}"


@pytest.mark.parametrize(
    "example", ["simple_pendulum", "cart_and_pendulum", "double_pendulum", "two_masses_three_springs"]
)
def test_the_equations_of_the_program_are_right_and_one_alone_is_not_enough(example: str) -> None:
    lines = [line.strip() for line in str(system(example).equations_of_motion()).splitlines()]
    equations = list(takewhile(bool, lines[lines.index("Equations of motion") + 1 :]))
    assert system(example).check("equations of motion", "; ".join(equations)).verdict == "correct"
    if len(equations) > 1:
        assert "needed" in system(example).check("equations of motion", equations[0]).reason
