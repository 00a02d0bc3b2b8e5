"""Several gears on one shaft, each by its own module and teeth."""

from __future__ import annotations

import pytest

import freebody as fb

TRAIN = """
parameters: {{T: 5 N m, w: 100 rad/s}}
ground: {{points: {{O: [0, 0], P: [0.1 m, 0]}}}}
bodies:
  a: {{gear: {{inertia: 0.001 kg m^2}}}}
  b: {{{b}}}
  c: {{gear: {{inertia: 0.02 kg m^2}}}}
connections:
  A: {{pin: [ground.O, a]}}
  B: {{pin: [ground.P, b]}}
  C: {{pin: [ground.O, c]}}
  one: {{gear_mesh: {{first: a, second: b, module: 2 mm, teeth: [20, 80]}}}}
  two: {{gear_mesh: {{first: b, second: c, module: 2 mm, teeth: [30, 70]}}}}
  motor: {{driver: {{measure: phi, follows: w*t}}}}
loads: {{load: {{torque: {{on: c, magnitude: -T}}}}}}
measures: {{phi: angle of a}}
"""


@pytest.mark.parametrize(
    "b",
    ["gear: {inertia: 0.002 kg m^2}", "gear: {inertia: 0.002 kg m^2, radius: 30 mm}", "body: {inertia: 0.01 g m^2}"],
)
def test_a_shaft_with_two_gears_multiplies_their_ratios(b: str) -> None:
    found = fb.System.from_text(TRAIN.format(b=b)).solve(["driving torque of motor", "tooth force of one"])
    torque = 5 * (20 / 80) * (30 / 70)
    assert [a.value for a in found.answers] == pytest.approx([torque, torque / 0.020], rel=1e-9)


def test_a_radius_that_none_of_its_gears_has_is_refused() -> None:
    with pytest.raises(fb.ModelError, match=r"b has the radius 0.05 m, and module and teeth give 0.08 m"):
        fb.System.from_text(TRAIN.format(b="gear: {inertia: 0.002 kg m^2, radius: 50 mm}"))


def test_a_gear_of_no_size_of_its_own_is_drawn_by_its_pitch_circle() -> None:
    small = fb.System.from_text(TRAIN.format(b="body: {inertia: 1 g m^2}")).draw().tikz()
    given = fb.System.from_text(TRAIN.format(b="body: {inertia: 1 g m^2, radius: 80 mm}")).draw().tikz()
    assert small == given
