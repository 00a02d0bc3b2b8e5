"""One mistake in a file is told once, where it stands, with what to write instead; what follows from it is not."""

from __future__ import annotations

import pytest

import freebody as fb
from freebody.errors import ModelError

MODEL = """
parameters: {m: 2 kg, L: 0.5 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {O: {pin: [ground.O, rod.start]}}
loads: {w: {gravity: g}}
measures: {phi: angle of rod}
start: {phi: 20 deg}
questions: [acceleration of phi]
"""

# what is written otherwise, and what the one message says of it
MISTAKES = {
    "a body by a word that is no name": (
        {"rod: {rod": "my rod: {rod", "rod.start": "my rod.start", "angle of rod": "angle of my rod"},
        "write my_rod",
    ),
    "a body by a letter of another script": (
        {"rod: {rod": "ж: {rod", "rod.start": "ж.start", "angle of rod": "angle of ж"},
        "letters a-z or Greek ones",
    ),
    "a body by a number": (
        {"rod: {rod": "1: {rod", "rod.start": "1.start", "angle of rod": "angle of 1"},
        "begin with a letter",
    ),
    "a parameter that is a function": (
        {"L: 0.5 m": "sin: 0.5 m", "length: L": "length: sin"},
        "'sin' is a function and cannot be a name: write sin_1, say",
    ),
    "a parameter that is a word of Python": (
        {"L: 0.5 m": "None: 0.5 m", "length: L": "length: None"},
        "write None_1",
    ),
    "a parameter pi": ({"L: 0.5 m": "pi: 0.5 m", "length: L": "length: pi"}, "pi is a number; choose another name"),
    "a parameter without a unit": ({"m: 2 kg": "m: 2"}, "write m: 2 kg under parameters"),
    "a measure by the name of a parameter": (
        {"{phi: angle": "{m: angle", "start: {phi": "start: {m", "of phi": "of m"},
        "m is a parameter already",
    ),
    "no bodies": ({"bodies: {rod: {rod: {mass: m, length: L}}}": "bodies:"}, "at least one body"),
    "two masses in one body": ({"mass: m": "mass: [m, m]"}, "expected a text or a number"),
    "a root of a negative number": (
        {"length: L": "length: sqrt(-1)*L"},
        "the inertia of rod: a number of the model has no value here: a root of a negative number",
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_one_mistake_is_told_once(mistake: str) -> None:
    changes, said = MISTAKES[mistake]
    text = MODEL
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    with pytest.raises(ModelError) as caught:
        fb.System.from_text(text).solve()
    assert len(caught.value.problems) == 1, caught.value
    assert said in str(caught.value)
