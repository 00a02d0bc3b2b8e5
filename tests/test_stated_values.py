"""Values of parameters that a question states: the answer is that of the file with these values."""

from __future__ import annotations

from pathlib import Path

import pytest

import freebody as fb
from freebody.errors import ModelError
from freebody.questions.spoken.unchosen import unchosen_things

EXAMPLES = Path(__file__).parents[1] / "examples"

# a question that states values, the same without them, the values, and what is understood
STATED = [
    ("block_pushed_on_incline", "friction force of incline with F = 60 N", "friction force of incline", {"F": "60 N"}),
    (
        "block_pushed_on_incline",
        "How big is the friction force on the block when the push is 60 N?",
        "friction force of incline",
        {"F": "60 N"},
    ),
    (
        "band_brake",
        "Which force F is needed to hold a torque of 60 Nm?",
        "range of F that keeps it at rest",
        {"T": "60 N m"},
    ),
    (
        "band_brake",
        "Welche Kraft F am Hebel braucht man, um ein Moment von 60 Nm zu halten?",
        "range of F that keeps it at rest",
        {"T": "60 N m"},
    ),
    (
        "cart_and_pendulum",
        "If I push the cart with 5 N, how fast does it accelerate at first?",
        "acceleration of x at start",
        {"F": "5 N"},
    ),
    (
        "cart_and_pendulum",
        "Beschleunigung von x mit einer Zugkraft von 2,5 N",
        "acceleration of x",
        {"F": "2.5 N"},
    ),
    (
        "atwood_machine",
        "tension of rope at left with m1 = 4 kg and m2 = 1 kg",
        "tension of rope at left",
        {"m1": "4 kg", "m2": "1 kg"},
    ),
    ("yo_yo", "Wie groß ist die Fadenkraft, wenn m um 20 % erhöht wird?", "tension of string", {"m": "0.12 kg"}),
    ("yo_yo", "tension of the string if the mass is doubled", "tension of string", {"m": "0.2 kg"}),
    ("yo_yo", "Fadenkraft, wenn m auf 0,3 kg erhöht wird", "tension of string", {"m": "0.3 kg"}),
    (
        "isolated_machine",
        "How much does the machine move up and down at 90 rad/s?",
        "steady amplitude of y",
        {"Omega": "90 rad/s"},
    ),
]


@pytest.mark.parametrize(("name", "question", "plain", "values"), STATED)
def test_a_question_that_states_values_is_asked_of_the_file_with_them(
    name: str, question: str, plain: str, values: dict[str, str]
) -> None:
    system = fb.System.load(EXAMPLES / f"{name}.yaml")
    own, (asked,) = system.asked_with(question)
    assert asked.understood.partition(" with ")[0] == plain
    assert all(f"{parameter} = {value}" in asked.understood for parameter, value in values.items())
    assert own.parameters == system.with_parameters(**values).parameters
    [here] = fb.solve(system, question).answers
    [there] = fb.solve(system.with_parameters(**values), plain).answers
    assert here.value == there.value
    assert here.value != fb.solve(system, plain).answers[0].value


def test_a_value_of_the_file_is_no_other_one() -> None:
    system = fb.System.load(EXAMPLES / "band_brake.yaml")
    own, (asked,) = system.asked_with("Which force F is needed to hold a torque of 40 Nm?")
    assert own is system
    assert " with " not in asked.understood


@pytest.mark.parametrize(
    ("name", "question"),
    [
        ("band_brake", "force on the hinge with a length of 3 m"),  # a or L or R
        ("band_brake", "force on the hinge with F = 3 m"),
        ("band_brake", "how blue is it with F = 3 N"),
        ("block_pushed_on_incline", "friction force on the block with a pulley mass of 3 kg"),  # m is its own
        ("cart_and_pendulum", "acceleration of the cart with a friction force of 5 N"),  # F is no friction
        ("cart_and_pendulum", "acceleration of the cart with 5 N of friction"),
        ("cart_and_pendulum", "Beschleunigung des Wagens mit einer Reibkraft von 5 N"),
        ("block_pushed_on_incline", "friction force on the block with a normal force of 50 N"),
        ("cart_and_pendulum", "acceleration of the cart with a spring force of 5 N"),
        ("cart_and_pendulum", "Beschleunigung des Wagens mit einer Federkraft von 5 N"),
        ("cart_and_pendulum", "Beschleunigung des Wagens mit einer Trägheitskraft von 5 N"),
        ("cart_and_pendulum", "acceleration of the cart with a braking force of 5 N"),
        ("yo_yo", "Wie ändert sich die Fadenkraft, wenn die Masse verdoppelt wird?"),
        ("band_brake", "force on the hinge with a rope force of 5 N"),
    ],
)
def test_what_cannot_be_read_with_a_value_either_is_refused(name: str, question: str) -> None:
    with pytest.raises(ModelError):
        fb.System.load(EXAMPLES / f"{name}.yaml").asked_with(question)


def test_a_value_that_the_file_does_not_allow_is_told() -> None:
    system = fb.System.load(EXAMPLES / "car_with_a_trailer.yaml")
    with pytest.raises(ModelError, match="F = 0 N is not positive"):
        fb.solve(system, "reaction of hitch with F = 0")


def test_what_springs_and_strings_exert_is_chosen_by_nobody_and_what_motors_exert_is() -> None:
    things = unchosen_things()
    assert {"spring", "damper", "gravity", "weight", "rope", "belt", "bearing", "drag"} <= things
    assert {"force", "torque", "motor", "brake", "clutch", "drive"}.isdisjoint(things)
