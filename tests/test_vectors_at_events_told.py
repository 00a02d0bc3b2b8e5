"""A vector at an event is derived by its components, and what is a number has its unit."""

from __future__ import annotations

import re

import freebody as fb

THROWN = """
parameters: {m: 1 kg, v: 10 m/s, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 20 m, rate(x): v, rate(y): 0}
"""
ROD = """
parameters: {m: 2 kg, l: 1 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: l}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod}
start: {theta: 0}
"""


def told(text: str, question: str) -> str:
    """The page, of which the derivation ends where the solver does: else it is refused."""
    explanation = fb.System.from_text(f"{text}questions: [{question}]\n").explain()
    (derivation,) = explanation.derivations
    assert not derivation.reason
    return explanation.to_text()


def test_a_velocity_at_a_time() -> None:
    """Of a throw (v, -g t)."""
    page = told(THROWN, "velocity of ball after 1.5 s")
    assert "-3⋅g" in page
    assert re.search(r"t = ─ s\b", page)


def test_a_velocity_at_a_place() -> None:
    """Fallen by h = 15 m: v_y = -sqrt(2 g h)."""
    page = told(THROWN, "velocity of ball when y = 5 m")
    assert "y = 5 m" in page
    assert "-╲╱30⋅g" in page


def test_a_reaction_and_an_acceleration_at_a_place() -> None:
    """Of a rod that has fallen from the level: 0 across, m g + m (l/2) 3 g/l = 5 m g/2 upwards; its end then has
    l omega^2 = 3 g towards the hinge."""
    page = told(ROD, "reaction of hinge when theta = -90 deg")
    assert "5⋅m⋅g" in page
    assert "3⋅g" in told(ROD, "acceleration of rod.end when theta = -90 deg")
