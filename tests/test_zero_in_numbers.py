"""A work that is zero is said to be zero, though it is added up from numbers; one that is small is not.

Two freedoms whose motion has no closed form: a rod that swings with a disk on its end that a torque spins.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import freebody as fb
from freebody.api import System
from freebody.study.answering.answer import Answer
from freebody.study.setup import Setup
from freebody.tolerances import ROUND_OFF

EXAMPLES = Path(__file__).parents[1] / "examples"

SWING = """
parameters: {m: 2 kg, L: 1 m, w: 3 rad/s, g: 9.81 m/s^2, M: 3 N*m, F: 20 N}
ground: {points: {O: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}}, d: {disk: {mass: m, radius: 0.2 m}}}
connections: {A: {pin: [ground.O, rod.start]}, B: {pin: [rod.end, d.center]}}
loads:
  weight: {gravity: g}
  torque: {torque: {on: d, magnitude: M}}
  pull: {force: {at: rod.end, along: rod.x, magnitude: F}}
measures: {th: {angle of rod from down}, ps: angle of d}
start: {th: 0, rate(th): w, ps: 0, rate(ps): 0}
"""


def asked(text: str, question: str) -> Answer:
    return fb.System.from_text(text).solve(question).answers[0]


@pytest.mark.parametrize(
    "question",
    [
        "work of weight until th = 0",  # what it gives on the way down it took on the way up
        "work of pull until th = 30 deg",  # at right angles to the way
        "work of pull until th = 0",
    ],
)
def test_nothing_is_said_as_zero(question: str) -> None:
    answer = asked(SWING, question)
    assert answer.expression is None
    assert answer.value == 0.0


def test_a_small_work_is_no_zero() -> None:
    """A force of 1e-9 N along the way, beside others of 20 N; and a hundredth of a degree of the whole way."""
    small = SWING.replace("F: 20 N", "F: 1e-9 N").replace("along: rod.x", "along: rod.y")
    value = asked(small, "work of pull until th = 30 deg").value
    assert value == pytest.approx(1e-9 * math.pi / 6, rel=1e-6)
    rise = 1.5 * (1.0 - math.cos(math.radians(0.01)))
    value = asked(SWING, "work of weight until th = 0.01 deg").value
    assert value == pytest.approx(-2.0 * 9.81 * rise, rel=1e-5)


def test_what_cancels_in_doubles_is_no_zero_where_balls_prove_it() -> None:
    """sqrt(a^2 + 1e-13 m^2) - a is 5e-14 m^2/a, below the round-off that counts for zero beside a loop; a nested root
    that is zero exactly, sqrt(2 a b + a^2 + b^2) - a - b with b = sqrt(a^2 + 1), stays one."""
    model = Setup(System.load(EXAMPLES / "four_bar.yaml")).model
    f, a = model.field, next(iter(model.parameters.values()))
    assert model.samples.has_loops
    small = f.sqrt(a * a + f.one / 10**13) - a
    value, size = f.numerator_and_size(small, model.samples.numbers(model.samples.points[-1]))
    assert abs(value) < ROUND_OFF * size
    assert not model.samples.vanishes(small)
    b = f.sqrt(a * a + 1)
    nothing = f.sqrt(2 * a * b + 2 * a * a + 1) - a - b
    assert not nothing.is_zero()  # the field does not see through nested roots
    assert model.samples.vanishes(nothing)


@pytest.mark.parametrize(
    ("question", "formula"),
    [
        ("mass of wire", 3.0),
        ("moment of inertia of wire about p", 3 * 0.4**2),
        ("radius of gyration of wire about p", 0.4),
    ],
)
@pytest.mark.parametrize("turned", ["0", "10 deg"])
def test_a_mass_that_hangs_at_rest_is_not_taken_for_round_off(question: str, formula: float, turned: str) -> None:
    """Its acceleration is 1e-17, the square root of which is no time by which a force makes a mass."""
    hung = f"""
parameters: {{m: 3 kg, R: 0.4 m, g: 9.81 m/s^2}}
bodies: {{wire: {{half_ring: {{mass: m, radius: R}}}}}}
ground: {{points: {{O: [0, 0]}}}}
connections: {{p: {{pin: [ground.O, wire.center]}}}}
loads: {{w: {{gravity: g}}}}
measures: {{th: angle of wire from down}}
start: {{th: {turned}, rate(th): 0}}
"""
    assert asked(hung, question).value == pytest.approx(formula)
