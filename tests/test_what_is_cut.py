"""What is asked of the instant in which something is cut, and of the motion that follows: formulas by hand."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.errors import InputError, ModelError

BAR = """
parameters: {m: 6 kg, L: 1.5 m, g: 9.81 m/s^2}
ground: {points: {P: [0, 1 m], Q: [L, 1 m]}}
bodies: {bar: {rod: {mass: m, length: L}, angle: 0, at: {start: [0, 0]}}}
connections:
  left: {string: {from: ground.P, to: bar.start}}
  right: {string: {from: ground.Q, to: bar.end}}
loads: {weight: {gravity: g}}
"""
HINGED = """
parameters: {m: 6 kg, L: 1.5 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], C: [0, L]}}
bodies: {rod: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: 0}}
connections: {hinge: {pin: [ground.O, rod.start]}, string: {string: {from: rod.end, to: ground.C}}}
loads: {weight: {gravity: g}}
"""
BETWEEN_SPRINGS = """
parameters: {m: 2 kg, k: 100 N/m, c: 50 N/m, a: 0.1 m, b: 0.3 m}
bodies: {cart: {particle: {mass: m}, at: [0, 0]}}
ground: {points: {A: [-1 m, 0], B: [1 m, 0]}}
connections: {rail: {slider: {body: cart, along: right}}}
loads:
  first: {spring: [ground.A, cart], stiffness: k, rest_length: 1 m - a}
  second: {spring: [ground.B, cart], stiffness: c, rest_length: 1 m - b}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # the end that is held moves across its string alone: m g L/2 = (J + m L^2/4) alpha
        (BAR, "tension of left just after right is cut", "m*g/4"),
        (BAR, "tension in the left string at the instant the right one is cut", "m*g/4"),
        (BAR, "Seilkraft links unmittelbar nach dem Durchtrennen des rechten Seils", "m*g/4"),
        (BAR, "angular acceleration of the bar when the right string is cut", "-3*g/(2*L)"),
        (HINGED, "angular acceleration of the rod immediately after the string is cut", "-3*g/(2*L)"),
        (HINGED, "vertical reaction of hinge on the rod just after the string is cut", "m*g/4"),
        (HINGED, "angular velocity of the rod when it is vertical after the string is cut", "-sqrt(3*g/L)"),
        (BETWEEN_SPRINGS, "acceleration of cart along right just after second is cut", "-k*a/m"),
    ],
)
def test_it_is_asked_of_the_model_without_it(model: str, question: str, formula: str) -> None:
    system = fb.System.from_text(model)
    (answer,) = system.solve(question).answers
    known = {p.name: p.value for p in system.parameters.values()}
    assert answer.expression is not None
    assert answer.value == pytest.approx(eval(formula, {"sqrt": math.sqrt}, known), rel=1e-9)


def test_that_it_is_cut_is_told() -> None:
    system = fb.System.from_text(BAR)
    assert "right is cut as the motion begins" in str(system.solve("tension of left just after right is cut"))
    assert "right is cut as the motion begins" in str(system.explain("tension of left just after right is cut"))


def test_what_is_cut_transmits_nothing_that_could_be_asked() -> None:
    with pytest.raises(ModelError, match="does not hold in this model"):
        fb.System.from_text(BAR).solve("tension of right just after right is cut")


def test_what_only_the_string_places_starts_nowhere_without_it() -> None:
    text = HINGED.replace("at: {start: [0, 0]}, angle: 0", "near: {angle: 0}").replace(
        "from: rod.end", "length: 2 m, from: rod.end"
    )
    with pytest.raises(InputError, match="without string the file does not say how rod starts"):
        fb.System.from_text(text).solve("angular acceleration of the rod just after the string is cut")


def test_it_is_asked_by_itself() -> None:
    with pytest.raises(InputError, match="ask it by itself"):
        fb.System.from_text(BAR).solve(["tension of left", "tension of left just after right is cut"])


@pytest.mark.parametrize(
    ("model", "question", "why"),
    [
        (BAR, "tension of left just after the weight is removed", "does not hold in this model"),  # no one cuts a field
        (BAR, "tension of left just after rigth is cut", "no rigth that could be cut. Did you mean right"),
        (
            f"{HINGED}measures: {{beta: {{angle of string from down}}}}",
            "angular acceleration of rod just after string is cut",
            "without string the model cannot be read",
        ),
    ],
)
def test_what_cannot_be_cut_is_told(model: str, question: str, why: str) -> None:
    with pytest.raises((InputError, ModelError), match=why):
        fb.System.from_text(model).solve(question)
