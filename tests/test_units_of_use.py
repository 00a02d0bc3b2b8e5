"""Parameters with neither a number nor a unit have the unit with which they are used, in whatever order."""

from __future__ import annotations

import itertools

import pytest

import freebody as fb
from freebody.language.notation import to_python

SYMBOLS = ("m", "L", "g", "k", "v0", "F")
UNITS = {"m": "kg", "L": "m", "g": "m/s^2", "k": "N/m", "v0": "m/s", "F": "N"}
ROD = """
parameters: {PARAMETERS}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {pin: {pin: [ground.O, rod.start]}}
measures: {theta: {angle of rod from down}}
start: {theta: 0, rate(theta): v0/L}
loads:
  pull: {force: {at: rod.end, along: right, magnitude: 2*F + k*L/3}}
  weight: {gravity: g}
  spring: {spring: {first: ground.Q, second: rod.end, stiffness: k, length: L}}
  push: {force: {at: rod.center, along: rod.y, magnitude: F/2}}
ground: {points: {O: [0, 0], Q: [L, 0]}}
questions: [acceleration of theta at start, kinetic energy at start]
"""


def _answers(parameters: str) -> list[str]:
    system = fb.System.from_text(ROD.replace("PARAMETERS", parameters))
    return [to_python(answer.expression) for answer in system.solve().answers]


def test_symbols_without_units_are_those_with_the_units_of_their_use() -> None:
    for order in itertools.islice(itertools.permutations(SYMBOLS), 0, None, 181):
        given = _answers(", ".join(f"{name}: {UNITS[name]}" for name in order))
        assert _answers(", ".join(f"{name}: " for name in order)) == given


def test_a_unit_of_use_is_shown_as_if_it_were_given() -> None:
    text = ROD.replace("PARAMETERS", ", ".join(f"{name}: " for name in SYMBOLS))
    parameters = fb.System.from_text(text).parameters
    given = fb.System.from_text(ROD.replace("PARAMETERS", ", ".join(f"{n}: {u}" for n, u in UNITS.items()))).parameters
    assert {name: p.dimension for name, p in parameters.items()} == {n: p.dimension for n, p in given.items()}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (  # used as two things
            "parameters: {m: }\nbodies: {rod: {rod: {mass: m, length: m}}}",
            "m must be a length (m), but is given in kg",
        ),
        (  # a number without a unit may be of any
            "parameters: {m: 2}\nbodies: {rod: {rod: {mass: m, length: 1 m}}}",
            "m must be a mass (kg), but has no unit: write m: 2 kg under parameters",
        ),
        (  # two in one product
            "parameters: {a: , b: }\nbodies: {rod: {rod: {mass: a*b, length: 1 m}}}",
            "a*b must be a mass (kg), but has no unit",
        ),
    ],
)
def test_what_use_does_not_tell_is_asked_for(text: str, said: str) -> None:
    with pytest.raises(fb.ModelError) as told:
        fb.System.from_text(f"{text}\nquestions: [kinetic energy]\n")
    assert [said in problem.message for problem in told.value.problems] == [True]
