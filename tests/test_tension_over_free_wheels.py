"""One tension of a string: over wheels without inertia that turn freely, and nowhere else."""

from __future__ import annotations

import pytest

from freebody import ModelError, System

MODEL = """
parameters: {{m1: 2 kg, m2: 3 kg, R: 0.1 m, g: 9.81 m/s^2}}
ground: {{points: {{axle: [0, 2 m]}}}}
bodies:
  pulley: {{disk: {{mass: {mass}, radius: R}}}}
  left: {{particle: {{mass: m1}}, at: [-R, 0]}}
  right: {{particle: {{mass: m2}}, at: [R, 0]}}
connections:
  pin: {{pin: [ground.axle, pulley]}}
  rope: {{string: {{from: left, over: [pulley], to: right}}}}
loads: {{weight: {{gravity: g}}{more}}}
measures: {{x1: drop of left below ground.axle}}
"""


def system(mass: str = "0", more: str = "") -> System:
    return System.from_text(MODEL.format(mass=mass, more=more))


def test_a_rope_over_a_pulley_without_inertia_has_one_tension() -> None:
    """T = 2 m1 m2 g/(m1 + m2), as of each part by itself."""
    found = system()
    answer = found.solve("tension of rope").answers[0]
    assert answer.value == pytest.approx(2 * 2 * 3 * 9.81 / 5)
    assert any("the same throughout: pulley turns freely" in note for note in answer.notes)
    for part in ("at left", "at right"):
        other = found.solve(f"tension of rope {part}").answers[0]
        assert other.expression == answer.expression
        assert not any("the same throughout" in note for note in other.notes)


@pytest.mark.parametrize(
    ("mass", "more"),
    [("1 kg", ""), ("0", ", motor: {torque: {on: pulley, magnitude: 1 N m}}")],
    ids=["inertia", "torque"],
)
def test_over_a_pulley_that_takes_a_moment_it_has_two(mass: str, more: str) -> None:
    with pytest.raises(ModelError, match="several values of tension"):
        system(mass, more).solve("tension of rope")
