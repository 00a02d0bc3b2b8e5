"""What is so at, just before, just after and behind the second impact, and the later ones.

A ball that is dropped from h leaves the floor with e v, e^2 v ... of v = sqrt(2 g h), rises to e^2 h, e^4 h ..., and is
in the air for 2 e v/g, 2 e^2 v/g ... between impacts.
Source: Beer & Johnston, Vector Mechanics: Dynamics, sec. 13.14; Hibbeler, Dynamics, sec. 15.4; Meriam & Kraige 3/12.
"""

from __future__ import annotations

import pytest

from freebody.api import System
from freebody.narrative.sheets.asking import asking
from freebody.narrative.telling.catalogue import Catalogue
from posed import is_derived, is_formula, posed

DROPPED = """
parameters: {m: 0.1 kg, h: 2 m, e: 0.8, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {c: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
start: {y: h, rate(y): 0}
"""
THROWN = (
    DROPPED.replace("at: [0, h]", "at: [0, h], velocity: [u, 0]")
    .replace("e: 0.8", "e: 0.8, u: 3 m/s")
    .replace("start: {y: h, rate(y): 0}\n", "")
    .replace("y: y of ball", "x: x of ball, y: y of ball")
)
# a puck hits another one, which comes back from a wall: of equal masses and e = 1 the first stands until then
ROW = """
parameters: {mA: 2 kg, mB: 3 kg, v: 4 m/s, e: 0.6, f: 0.9, r: 0.1 m, d: 1 m}
ground: {lines: {wall: {along: up, through: [3 m, 0]}}}
bodies:
  A: {disk: {mass: mA, radius: r}, at: [0, 0], velocity: [v, 0]}
  B: {disk: {mass: mB, radius: r}, at: [d, 0]}
connections:
  hit: {contact: {between: [A, B], restitution: e}}
  wall: {contact: {between: [B, wall], restitution: f}}
"""
CASES = {
    "just after": (DROPPED, "speed of ball after the second impact", "e^2*sqrt(2*g*h)"),
    "just before": (DROPPED, "speed of ball just before the third impact", "e^2*sqrt(2*g*h)"),
    "a fourth": (DROPPED, "speed of ball after the fourth impact", "e^4*sqrt(2*g*h)"),
    "when": (DROPPED, "time of the second impact", "sqrt(2*h/g)*(1 + 2*e)"),
    "from one to the next": (DROPPED, "time between the second and the third impact", "2*e^2*sqrt(2*h/g)"),
    "how high": (DROPPED, "height of the ball after the second bounce", "e^4*h"),
    "in German": (DROPPED, "Wie hoch springt der Ball nach dem zweiten Aufprall?", "e^4*h"),
    "the greatest height": (DROPPED, "greatest height of ball after the third impact", "e^6*h"),
    "energy": (DROPPED, "energy lost in the second impact", "m*g*h*e^2*(1 - e^2)"),
    "at a place behind an impact": (
        DROPPED,
        "speed of ball when y = h/10 after the second impact",
        "sqrt(2*g*h*(e^4 - 1/10))",
    ),
    "turned round": (DROPPED, "value of e for which the height after the second bounce is h/4", "sqrt(2)/2"),
    "where": (THROWN, "x at the second impact", "u*sqrt(2*h/g)*(1 + 2*e)"),
    "how fast": (THROWN, "speed of ball after the second impact", "sqrt(u^2 + 2*g*h*e^4)"),
    "another contact": (ROW, "x-component of velocity of B after the second impact", "-f*mA*(1 + e)*v/(mA + mB)"),
    "of one contact": (ROW, "speed of B after the first impact of wall", "f*mA*(1 + e)*v/(mA + mB)"),
}


@pytest.mark.parametrize("name", CASES)
def test_a_later_impact_has_the_formula_of_a_textbook(name: str) -> None:
    model, question, formula = CASES[name]
    is_formula(model, question, formula, factors=(1.0, 1.01, 0.99))


def test_an_event_behind_an_impact_is_not_that_before_it() -> None:
    """Its speed is zero first at the top behind the first impact, h e^2 high, and behind the second h e^4 high."""
    values = [
        posed(DROPPED, f"y when rate(y) = 0{when}").value
        for when in ("", " after the first impact", " after the second impact")
    ]
    assert values == pytest.approx([2 * 0.64, 2 * 0.64, 2 * 0.8**4])


def test_a_sixth_impact_is_not_taken_for_the_first() -> None:
    first, sixth = (posed(DROPPED, f"speed of ball after the {n} impact").value for n in ("first", "sixth"))
    assert sixth == pytest.approx(first * 0.8**5)


def test_it_is_derived_phase_by_phase() -> None:
    told = is_derived(DROPPED, "y when rate(y) = 0 after the second impact")
    assert told["en"].count("The impact takes no time") == 2
    assert "after impact 2" in told["en"]
    assert "nach dem 2. Stoß" in told["de"]
    system = System.from_text(DROPPED + "questions: [speed of ball after the second impact]\n")
    assert "just after impact 2" in Catalogue("en").plain(asking(system, system.questions[0]))
