"""How a point moves seen from a body that turns, and the acceleration of Coriolis: by hand, and by their identity."""

from __future__ import annotations

from math import atan2, cos, sin
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.errors import ModelError

QUICK_RETURN = """
parameters: {d: 0.3 m, r: 0.1 m, w: 10 rad/s}
ground: {points: {C: [0, 0], O: [0, d]}}
bodies: {crank: {rod: {length: r}}, arm: {rod: {length: 0.6 m}, near: {angle: 70 deg}}}
connections:
  main: {pin: [ground.O, crank.start]}
  pivot: {pin: [ground.C, arm.start]}
  block: {slot: {pin: crank.end, through: arm.start, along: arm.x}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: {angle of crank}}
"""
BEAD = """
parameters: {w: 2 rad/s, v: 1 m/s, a: 0.2 m}
bodies: {arm: {rod: {mass: 1 kg, length: 1 m}}, bead: {particle: {mass: 1 kg}}}
connections:
  hub: {pin: [ground.O, arm.start]}
  guide: {slider: {body: bead, on: arm, along: arm.x, through: arm.start}}
  turning: {driver: {measure: phi, follows: w*t}}
  moving: {driver: {measure: r, follows: a + v*t}}
measures: {r: {distance from arm.start to bead}, phi: {angle of arm}}
"""
CRANE = (Path(__file__).parents[1] / "examples" / "slewing_crane.yaml").read_text()


def values(text: str, question: str) -> np.ndarray:
    """(2,) or (3,)"""
    (answer,) = fb.System.from_text(text).solve(question).answers
    assert answer.expression is not None, answer.reason
    return np.array(answer.value)


def test_the_block_of_a_quick_return_slides_and_is_turned() -> None:
    """At theta = 0 the block is at (r, d), v = (0, w r); along the arm at atan(d/r) that is w r sin, across it w r cos,
    so the arm turns with w r cos/l = 1/s, and the Coriolis acceleration is twice the product."""
    angle, away = atan2(0.3, 0.1), np.hypot(0.3, 0.1)
    slides, turns = sin(angle), cos(angle) / away
    along, across = np.array([cos(angle), sin(angle)]), np.array([-sin(angle), cos(angle)])
    assert values(QUICK_RETURN, "velocity of crank.end relative to arm at start") == pytest.approx(slides * along)
    assert values(QUICK_RETURN, "Coriolis acceleration of the block at the start") == pytest.approx(
        2 * turns * slides * across
    )
    assert values(QUICK_RETURN, "magnitude of the Coriolis acceleration at the start") == pytest.approx(
        2 * turns * slides
    )


def test_the_accelerations_add_up() -> None:
    """a_P = a_A - w^2 r + alpha x r + a_C + a_rel about the fixed pivot of the arm."""
    at = " when theta = 40 deg"
    whole = values(QUICK_RETURN, f"acceleration of crank.end{at}")
    turns, alpha = (values(QUICK_RETURN, f"angular {what} of arm{at}") for what in ("velocity", "acceleration"))
    place = np.array([0.1 * cos(np.radians(40)), 0.3 + 0.1 * sin(np.radians(40))])
    seen = values(QUICK_RETURN, f"acceleration of crank.end relative to arm{at}")
    coriolis = values(QUICK_RETURN, f"Coriolis acceleration of crank.end relative to arm{at}")
    led = alpha * np.array([-place[1], place[0]]) - turns**2 * place
    assert whole == pytest.approx(led + coriolis + seen, rel=1e-9)


@pytest.mark.parametrize(
    ("question", "value"),
    [
        ("speed of bead relative to arm", 1.0),
        ("size of acceleration of bead relative to arm", 0.0),
        ("magnitude of the Coriolis acceleration of the bead", 2 * 2.0 * 1.0),
    ],
)
def test_a_bead_led_outwards_on_a_turning_arm(question: str, value: float) -> None:
    assert values(BEAD, question) == pytest.approx(value)


def test_the_trolley_of_a_slewing_crane() -> None:
    """It runs out along the jib with v, and w turns it: 2 w v across the jib."""
    assert values(CRANE, "Coriolis acceleration of trolley relative to jib at start") == pytest.approx(
        [0, 2 * 0.1 * 0.5, 0]
    )
    assert values(CRANE, "velocity of trolley relative to jib at start") == pytest.approx([0.5, 0, 0])


@pytest.mark.parametrize(
    ("question", "why"),
    [
        ("velocity of arm.end relative to arm", "rests in it"),
        ("Coriolis acceleration of arm.end relative to bead", "no body that turns"),
        ("Coriolis acceleration of arm.end", "say relative to which body"),
    ],
)
def test_what_is_not_seen_from_there(question: str, why: str) -> None:
    with pytest.raises(ModelError, match=why):
        fb.System.from_text(BEAD).solve(question)


@pytest.mark.parametrize(
    ("language", "term"), [("en", "acceleration is 2·𝝎 × 𝒗_rel"), ("de", "Coriolisbeschleunigung ist 2·𝝎 × 𝒗_rel")]
)
def test_it_is_derived_from_the_composition_of_motions(language: str, term: str) -> None:
    worked = fb.System.from_text(BEAD).explain("Coriolis acceleration of the bead", language=language)
    assert worked.is_complete
    assert term in " ".join(worked.to_text().split())
