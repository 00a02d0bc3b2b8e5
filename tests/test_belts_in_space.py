"""Belts and chains in space do in any plane what they do in the plane of x and y."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.errors import ModelError

QUESTIONS = """
questions:
  - {id: turning, find: acceleration of phi at start}
  - {id: force, find: BAND force of band at start}
  - {id: bearing, find: reaction of q at start}
  - {id: length, find: length of band}
"""


def values_of(text: str) -> dict[str, Any]:
    found = {answer.id: answer.value for answer in fb.System.from_text(text).solve().answers}
    assert None not in found.values(), found
    return found


def drive(band: str, shift: int | None) -> str:
    """A motor turns a drum; None: the model of the plane, else with z called x, y or z."""
    kind = band.split(":", maxsplit=1)[0].strip("{")
    end = QUESTIONS.replace("BAND", kind)
    if shift is None:
        return f"""
ground: {{points: {{A: [0, 0], B: [0.6, 0.8]}}}}
bodies:
  motor: {{disk: {{mass: 2, radius: 0.1}}}}
  drum: {{disk: {{mass: 3, radius: 0.2}}, at: [0.6, 0.8]}}
connections: {{p: {{pin: [ground.A, motor]}}, q: {{pin: [ground.B, drum]}}, band: {band}}}
loads: {{drive: {{torque: {{on: motor, magnitude: 5}}}}}}
measures: {{phi: angle of drum}}
{end}"""
    axis = "zxy"[shift]
    place = "[" + ", ".join(map(str, np.roll([0.6, 0.8, 0.0], shift))) + "]"
    return f"""
space: true
ground: {{points: {{A: [0, 0, 0], B: {place}}}}}
bodies:
  motor: {{disk: {{mass: 2, radius: 0.1, axis: {axis}}}}}
  drum: {{disk: {{mass: 3, radius: 0.2, axis: {axis}}}}}
connections:
  p: {{revolute: {{first: ground.A, second: motor, about: {axis}}}}}
  q: {{revolute: {{first: ground.B, second: drum, about: {axis}}}}}
  band: {band}
loads: {{drive: {{torque: {{on: motor, about: {axis}, magnitude: 5}}}}}}
measures: {{phi: angle of drum about {axis}}}
start: {{phi: 0, rate(phi): 0}}
{end}"""


@pytest.mark.parametrize("shift", range(3))
@pytest.mark.parametrize(
    "band",
    [
        "{belt: {first: motor, second: drum, pretension: 300 N}}",
        "{belt: {first: motor, second: drum, crossed: true, pretension: 300 N}}",
        "{chain: {first: motor, second: drum, pitch: 0.02, teeth: [31, 63]}}",
    ],
)
def test_a_belt_in_any_plane_turns_and_pulls_as_in_the_plane(band: str, shift: int) -> None:
    flat, spatial = values_of(drive(band, None)), values_of(drive(band, shift))
    for name in ("turning", "force", "length"):
        assert spatial[name] == pytest.approx(flat[name], rel=1e-10), name
    pulled = np.roll([*flat["bearing"], 0.0], shift)
    assert spatial["bearing"] == pytest.approx(pulled, rel=1e-10, abs=1e-12)
    if "chain" not in band:  # F r_1 = M - I_1 phi_1'', F r_2 = I_2 phi_2''
        assert abs(spatial["turning"]) == pytest.approx(2 * 5 / (0.1 * 0.2 * (2 + 3)), rel=1e-10)


def test_a_belt_carried_by_an_arm_that_slews_keeps_the_first_pulley_from_turning_by_the_ratio() -> None:
    """Both axes are upright on an arm that turns about z with w; the first pulley stands on the ground beside it, so
    that on the arm it turns by -w t, and the second by -w t r_1/r_2: against the ground it turns with w (1 - r_1/r_2).
    """
    text = """
space: true
parameters: {w: 2 rad/s}
bodies:
  sun: {disk: {mass: 1, radius: 0.1, axis: z}}
  arm: {body: {mass: 1, inertia: [1, 1, 1]}, points: {end: [0.7, 0, 0]}}
  planet: {disk: {mass: 1, radius: 0.4, axis: z}}
connections:
  held: {weld: [ground, sun]}
  p: {revolute: {first: sun, second: arm, about: z}}
  q: {revolute: {first: arm.end, second: planet, about: z}}
  band: {belt: [sun, planet]}
  motor: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of arm about z, psi: angle of planet about z}
questions: [{id: rate, find: rate of psi at start}]
"""
    assert values_of(text)["rate"] == pytest.approx(2 * (1 - 0.1 / 0.4), rel=1e-12)


def test_pulleys_beside_each_other_carry_no_belt() -> None:
    text = drive("{belt: [motor, drum]}", 0).replace("B: [0.6, 0.8, 0.0]", "B: [0.6, 0.8, 0.05]")
    with pytest.raises(ModelError, match=r"drum is 0\.05 m beside the plane of motor"):
        fb.System.from_text(text)
    with pytest.raises(ModelError, match="a belt needs parallel axes"):
        fb.System.from_text(
            drive("{belt: [motor, drum]}", 0).replace("second: drum, about: z", "second: drum, about: x")
        )
