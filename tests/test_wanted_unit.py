"""The unit in which a question wants its answer, beside that of the answer itself."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.language.units.conversion import conversion
from freebody.questions.spoken.wanted_unit import without_units

CAR = """
bodies:
  car: {particle: {mass: m}}
connections:
  road: {slider: {body: car, along: right}}
loads:
  engine: {force: {at: car, along: right, magnitude: F}}
measures: {x: position of car along right}
parameters: {m: 900 kg, F: 1800 N}
start: {x: 0, rate(x): 0}
"""


def answer(question: str) -> fb.Answer:
    (found,) = fb.System.from_text(CAR).solve(question).answers
    return found


@pytest.mark.parametrize(
    ("question", "unit", "value"),
    [
        ("how fast is the car after 5 s, in km/h?", "km/h", 36.0),  # 2 m/s^2 * 5 s = 10 m/s
        ("speed of the car after 5 s (km/h)", "km/h", 36.0),
        ("speed of the car after 5 s in kilometres per hour", "km/h", 36.0),
        ("power of the engine after 5 s [kW]", "kW", 18.0),
        ("Wie schnell ist der Wagen nach 5 s in Kilometer pro Stunde?", "km/h", 36.0),
        ("how many kilojoules of kinetic energy has the car after 5 s", "kJ", 45.0),
        ("acceleration of x in m/s²", "m/s^2", 2.0),
    ],
)
def test_the_value_is_told_in_the_unit_that_is_wanted(question: str, unit: str, value: float) -> None:
    found = answer(question)
    assert found.in_unit == unit
    assert found.value_in_unit == pytest.approx(value, rel=1e-9)
    assert found.to_plain()["in"] == {"unit": unit, "value": pytest.approx(value, rel=1e-9)}


def test_the_answer_shows_both_units() -> None:
    assert "10 m/s = 36 km/h" in answer("speed of the car after 5 s in km/h").to_text()


def test_a_unit_that_what_is_asked_has_not_is_refused() -> None:
    with pytest.raises(fb.ModelError, match=r"whose unit is m/s, and kg is no such unit"):
        answer("speed of the car after 5 s in kg")


def test_without_a_wanted_unit_nothing_is_said_of_one() -> None:
    found = answer("speed of the car after 5 s")
    assert found.value_in_unit is None
    assert "in" not in found.to_plain()


@pytest.mark.parametrize(
    ("own", "wanted", "ratio"),
    [
        ("rad/s", "rpm", 60 / (2 * math.pi)),
        ("rad/s", "Hz", 1 / (2 * math.pi)),
        ("rad/s", "1/min", 60 / (2 * math.pi)),
        ("rad/s", "deg/s", 180 / math.pi),
        ("rad", "turn", 1 / (2 * math.pi)),
        ("1/s", "Hz", 1.0),
        ("N m", "kN m", 1e-3),
    ],
)
def test_a_rate_of_an_angle_in_hertz_counts_full_turns(own: str, wanted: str, ratio: float) -> None:
    assert conversion(own, wanted) == pytest.approx(ratio, rel=1e-12)


@pytest.mark.parametrize(
    "question",
    [
        "force in the rod",
        "force in rod",
        "how far has it moved in 2 s",
        "tension in the rope",
        "in what time",
        "force in s",
    ],
)
def test_a_thing_a_time_and_a_name_of_the_model_are_no_unit(question: str) -> None:
    assert without_units(question, {"s", "rod"}) == (question, ())
