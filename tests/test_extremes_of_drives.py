"""What varies with the phase of a drive has its extremes over one period; each is derived by hand here."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from freebody.language.expression import Symbol
from freebody.language.parser import parse
from freebody.study.answering.named_formulas import Chain, NamedFormula
from freebody.study.steady.extremes_in_names import ChainOverTurn
from posed import is_derived, is_formula, posed

EXAMPLES = Path(__file__).parents[1] / "examples"

TABLE = """
parameters: {m: 2 kg, A: 0.03 m, W: 15 rad/s, g: 9.81 m/s^2}
bodies: {table: {particle: {mass: m}}}
connections:
  guide: {slider: {body: table, along: up, through: ground.O}}
  shaker: {driver: {measure: y of table, follows: A*cos(W*t)}}
loads: {weight: {gravity: g}}
measures: {y: y of table}
"""
ARM = """
parameters: {m: 2 kg, L: 0.8 m, W: 3 rad/s, b: 30 deg}
bodies: {arm: {rod: {length: L, mass: m}}}
connections: {hinge: {pin: [ground.O, arm.start]}, drive: {driver: {measure: phi, follows: b*sin(W*t)}}}
measures: {phi: angle of arm}
"""
ELLIPSE = """
parameters: {m: 2 kg, a: 0.1 m, b: 0.05 m, W: 4 rad/s}
bodies: {p: {particle: {mass: m}}}
connections:
  across: {driver: {measure: x of p, follows: a*cos(W*t)}}
  upward: {driver: {measure: y of p, follows: b*sin(W*t)}}
measures: {x: x of p, y: y of p}
"""
EIGHT = ELLIPSE.replace("b*sin(W*t)", "b*sin(2*W*t)")


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (TABLE, "greatest y", "A"),
        (TABLE, "greatest velocity of y", "A*W"),
        (TABLE, "greatest |velocity of table|", "A*W"),
        (TABLE, "least acceleration of y", "-A*W^2"),
        # F = m (g + y''), y'' = -A W^2 cos(W t)
        (TABLE, "greatest force of shaker", "m*(g + A*W^2)"),
        (TABLE, "least force of shaker", "m*(g - A*W^2)"),
        (TABLE, "value of W for which least force of shaker = 0", "sqrt(g/A)"),
        # the end: at the turn L b W^2 along the path, in the middle L (b W)^2 to the hinge; b < 1
        (ARM, "greatest |velocity of arm.end|", "L*b*W"),
        (ARM, "greatest |acceleration of arm.end|", "L*b*W^2"),
        (ELLIPSE, "greatest |velocity of p|", "a*W"),
        (ELLIPSE, "least |velocity of p|", "b*W"),
        # v^2 = W^2 (a^2 s^2 + 4 b^2 (1 - 2 s^2)^2), convex in s^2: greatest at an end
        (EIGHT, "greatest |velocity of p|", "W*sqrt(a^2 + 4*b^2)"),
    ],
)
def test_extremes_over_the_period_of_a_drive(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_they_are_derived_by_the_phase() -> None:
    told = is_derived(TABLE, "greatest force of shaker")
    assert "with the phase W·t" in told["en"]
    assert "mit der Phase W·t" in told["de"]
    is_derived(EIGHT, "greatest |velocity of p|")
    is_derived(TABLE, "greatest y")


def test_without_a_closed_form_there_is_the_number() -> None:
    answer = posed(ARM, "least y of arm.end")  # L sin(b sin(W t))
    assert answer.expression is None
    assert answer.value == pytest.approx(-0.8 * math.sin(math.pi / 6))


WHITWORTH = """
parameters: {r: 100 mm, f: 40 mm, w: 5 rad/s, J: 0.2 kg m^2, M: 15 N m}
ground: {points: {O: [0, 0], P: [0, -f]}}
bodies:
  crank: {rod: {length: r}}
  lever: {body: {inertia: J}, at: [0, -f]}
connections:
  O: {pin: [ground.O, crank.start]}
  P: {pin: [ground.P, lever]}
  block: {slot: {pin: crank.end, along: lever.x}}
  motor: {driver: {measure: phi, follows: w*t}}
loads: {load: {torque: {on: lever, magnitude: -M}}}
measures: {phi: angle of crank, psi: angle of lever}
"""


def _whitworth(phi: float) -> tuple[float, float]:
    """Torque of the drive and force on the block, with psi' = w (r^2 + r f sin phi)/n, n = r^2 + 2 r f sin phi + f^2:
    T = (J psi'' + M) psi'/w, N = (J psi'' + M)/sqrt(n)."""
    r, f, w, inertia, load = 0.1, 0.04, 5.0, 0.2, 15.0
    n = r * r + 2 * r * f * math.sin(phi) + f * f
    rate = w * (r * r + r * f * math.sin(phi)) / n
    second = w * w * r * f * math.cos(phi) * (f * f - r * r) / n**2
    return (inertia * second + load) * rate / w, (inertia * second + load) / math.sqrt(n)


@pytest.mark.parametrize(
    ("question", "which"),
    [("greatest driving torque of motor over a turn of phi", 0), ("greatest normal force of block", 1)],
)
def test_an_extreme_without_a_place_in_closed_form_is_a_chain_at_an_angle_in_numbers(question: str, which: int) -> None:
    """Of a force that pushes to either side the size is meant."""
    found = posed(WHITWORTH, question)
    wanted = max(abs(_whitworth(math.tau * k / 100_000)[which]) for k in range(100_000))
    assert isinstance(found.value, float)
    assert math.isclose(found.value, wanted, rel_tol=1e-8)
    assert found.chain is not None
    known = {"r": 0.1, "f": 0.04, "w": 5.0, "J": 0.2, "M": 15.0}
    assert math.isclose(found.chain.numbers(known)[0], wanted, rel_tol=1e-8)
    assert math.isclose(abs(_whitworth(found.chain.values(known)["phi"])[which]), wanted, rel_tol=1e-8)
    assert "by interval arithmetic no other pose has more" in found.notes


def test_what_an_interval_may_hold_is_no_proof_of_the_greatest_value() -> None:
    """cos(2 phi) + sin(phi)/4 is greatest where sin(phi) = 1/16, with 1 + 1/128; a little less is not shown."""
    steps = (NamedFormula(Symbol("x"), parse("2*atan(sin(phi)/(1 + cos(phi)))")),)
    turn = ChainOverTurn(Chain(steps, (parse("cos(2*x) + a*sin(phi)"),)), "phi", {"a": 0.25}, 1)
    angle, value = turn.best()
    assert math.isclose(math.sin(angle), 1 / 16, rel_tol=1e-9)
    assert math.isclose(value, 1 + 1 / 128, rel_tol=1e-12)
    assert turn.is_proved(value)
    assert not turn.is_proved(value - 1e-6)


def test_what_is_most_beside_a_jump_is_no_pose_at_which_the_slope_vanishes() -> None:
    """The piston slows down most as it comes to the outer dead point, a = r w^2 (1 + r/l); beyond it, it speeds up."""
    system = fb.System.load(EXAMPLES / "driven_slider_crank.yaml")
    [answer] = fb.solve(system, question="greatest -tangential acceleration of piston").answers
    assert answer.value is None or answer.value == pytest.approx(0.05 * 30**2 * (1 + 0.05 / 0.2), rel=1e-3)
