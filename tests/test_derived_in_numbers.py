"""What a derivation says where its equations have no solution in closed form."""

from __future__ import annotations

import freebody as fb

MODEL = """
parameters: {m: 2 kg, L: 1 m, k: 30 N m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {p: {pin: [ground.O, rod.start]}}
loads: {w: {gravity: g}, t: {torque: {on: rod, magnitude: -k*th}}}
measures: {th: angle of rod}
questions: [th at equilibrium, reaction of p at equilibrium, period of small oscillations]
"""


def test_nothing_is_said_to_be_found_in_equations_that_are_solved_in_numbers() -> None:
    found = fb.explain(fb.System.from_text(MODEL))
    told = " ".join(found.to_text().split())
    assert "This was found in" not in told
    assert told.count("The equations above are solved in numbers instead") == len(found.derivations) == 3
