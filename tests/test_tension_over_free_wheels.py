"""One tension of a string: over wheels without inertia that turn freely, and nowhere else."""

from __future__ import annotations

import pytest

from freebody import System
from posed import posed

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
    first, second = system(mass, more).solve("tension of rope").answers
    assert first.value != pytest.approx(second.value)


HELD_PULLEYS = {
    # a peg that is welded to the ground
    "peg": (
        "B: {particle: {mass: m2}}, p: {disk: {mass: 1 kg, radius: R}}",
        "fix: {weld: [ground.O, p.center]}",
        "[A, over p, B]",
        "1",
    ),
    # a movable pulley whose guide keeps it from turning
    "guided": (
        "fix: {disk: {radius: R}}, p: {disk: {mass: m2, radius: R}, at: [2*R, -1 m]}",
        "axle: {pin: [ground.O, fix.center]}, guide: {slider: {body: p, along: up}}",
        "[A, over fix, under p, ground.C]",
        "2",
    ),
}


@pytest.mark.parametrize("case", HELD_PULLEYS)
def test_over_a_pulley_that_cannot_turn_the_rope_slides(case: str) -> None:
    """It would be held fast if it did not: with n strands on m2, a = n g (n m1 - m2)/(n^2 m1 + m2)."""
    bodies, held, path, strands = HELD_PULLEYS[case]
    model = f"""
parameters: {{m1: 3 kg, m2: 2 kg, g: 9.81 m/s^2, R: 0.1 m}}
ground: {{points: {{O: [0, 0], C: [3*R, 0]}}}}
bodies: {{A: {{particle: {{mass: m1}}}}, {bodies}}}
connections: {{{held}, rope: {{string: {{path: {path}}}}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{x: drop of A}}
start: {{x: 1 m, rate(x): 0}}
"""
    found, n = posed(model, "acceleration of x"), int(strands)
    assert found.value == pytest.approx(n * 9.81 * (n * 3 - 2) / (n**2 * 3 + 2))


@pytest.mark.parametrize("at", ["", ", at: [0.2 m, -1 m]"])
def test_a_wheel_that_is_led_up_and_down_hangs_in_the_rope_that_runs_under_it(at: str) -> None:
    """The weight moves by 2x where the wheel moves by x: a = 2 g (2 m1 - m2)/(4 m1 + m2), wherever the file puts it."""
    [found] = (
        System.from_text(f"""
parameters: {{m1: 3 kg, m2: 2 kg, g: 9.81 m/s^2, R: 0.1 m}}
ground: {{points: {{O: [0, 0], C: [0.3 m, 0]}}}}
bodies: {{A: {{particle: {{mass: m1}}}}, fix: {{disk: {{radius: R}}}}, mov: {{disk: {{radius: R, mass: m2}}{at}}}}}
connections:
  axle: {{pin: [ground.O, fix.center]}}
  guide: {{slider: {{body: mov, along: up}}}}
  rope: {{string: {{path: [A, over fix, under mov, ground.C]}}}}
loads: {{w: {{gravity: g}}}}
measures: {{xA: drop of A}}
start: {{xA: 1 m, rate(xA): 0}}
questions: [acceleration of xA at start]
""")
        .solve()
        .answers
    )
    assert found.value == pytest.approx(2 * 9.81 * (2 * 3 - 2) / (4 * 3 + 2))
