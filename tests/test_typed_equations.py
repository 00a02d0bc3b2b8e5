"""Typed equations of motion: right if they hold on every motion of the model."""

from __future__ import annotations

import json
from functools import cache
from itertools import takewhile
from pathlib import Path

import pytest

import freebody as fb
from command import freebody
from freebody.narrative.marking.working import CheckedWorking

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


NAMED = {2: "forces", 3: "forces", 4: "kinematics", 5: "moments", 6: "algebra", 7: "algebra"}
SOLUTION = """Newton for both masses, Euler for the pulley
m1 g - T1 = m1 x1''
m2 g - T2 = m2 x2''
x2'' = -x1''
(T1 - T2) R = 1/2 M R^2 x1''/R
(m1 + m2 + M/2) x1'' = (m1 - m2) g
x1'' = (m1 - m2) g/(m1 + m2 + M/2)
"""


def worked(tmp_path: Path, text: str) -> CheckedWorking:
    (tmp_path / "solution.txt").write_text(text, encoding="utf-8")
    found = system("atwood_machine").check(working=tmp_path / "solution.txt")
    assert isinstance(found, CheckedWorking)
    return found


def test_every_line_of_a_right_solution_holds_by_its_principle(tmp_path: Path) -> None:
    found = worked(tmp_path, SOLUTION)
    assert found.verdict == "correct"
    assert found.first_wrong is None
    assert {line.n: line.found.principle for line in found.lines[1:]} == NAMED


def test_the_first_wrong_line_is_named_and_what_follows_from_it_is_carried_forward(tmp_path: Path) -> None:
    found = worked(tmp_path, SOLUTION.replace("1/2 M", "M").replace("M/2", "M"))
    assert found.first_wrong == 5
    assert [line.found.verdict for line in found.lines[4:]] == ["wrong", "carried_forward", "carried_forward"]
    assert "equations 2, 3 and 5" in found.lines[4].found.reason


def test_a_slip_of_algebra_in_a_right_solution_is_the_line_itself(tmp_path: Path) -> None:
    found = worked(tmp_path, SOLUTION.replace("g/(m1 + m2 + M/2)", "g/(m1 - m2 + M/2)"))
    assert found.first_wrong == 7
    assert "equation 7" in found.lines[6].found.reason


def test_a_constraint_with_the_wrong_sign_is_found(tmp_path: Path) -> None:
    assert worked(tmp_path, SOLUTION.replace("x2'' = -x1''", "x2'' = x1''")).first_wrong == 4


def test_working_on_the_command_line(tmp_path: Path) -> None:
    path = tmp_path / "solution.txt"
    path.write_text(SOLUTION.replace("m1 g - T1", "m1 g + T1"), encoding="utf-8")
    done = freebody("check", str(EXAMPLES / "atwood_machine.yaml"), "--working", str(path), "--json")
    assert done.returncode == 1
    assert json.loads(done.stdout)["first_wrong"] is not None
    assert freebody("check", str(EXAMPLES / "atwood_machine.yaml")).returncode == 2


@pytest.mark.parametrize(
    "example", ["simple_pendulum", "cart_and_pendulum", "double_pendulum", "two_masses_three_springs"]
)
def test_the_equations_of_the_program_are_right_and_one_alone_is_not_enough(example: str) -> None:
    lines = [line.strip() for line in str(system(example).equations_of_motion()).splitlines()]
    equations = list(takewhile(bool, lines[lines.index("Equations of motion") + 1 :]))
    assert system(example).check("equations of motion", "; ".join(equations)).verdict == "correct"
    if len(equations) > 1:
        assert "needed" in system(example).check("equations of motion", equations[0]).reason
