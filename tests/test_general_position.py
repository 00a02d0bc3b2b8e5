"""Figures show angles open where the start does not matter, and the start where it does."""

from __future__ import annotations

from pathlib import Path

import pytest

from freebody import System
from freebody.study.pictures.general_position import general_position

EXAMPLES = Path(__file__).parent.parent / "examples"
PENDULUM = """
parameters: {{m: 1 kg, l: 1 m, g: 9.81 m/s^2}}
bodies: {{bob: {{particle: {{mass: m}}}}}}
connections: {{rod: {{link: [ground.O, bob, l]}}}}
loads: {{weight: {{gravity: g}}}}
measures: {{theta: {{angle of line from ground.O to bob from down}}}}
start: {{theta: {start}{rate}}}
questions: {{it: {question}}}
"""


def pendulum(question: str, start: str = "0", rate: str = "") -> System:
    return System.from_text(PENDULUM.format(question=question, start=start, rate=rate))


def test_a_pendulum_asked_about_at_any_instant_is_drawn_aside() -> None:
    found = general_position(pendulum("acceleration of theta"))
    assert found is not None
    reference = found.snapshot.reference
    (x, y, _angle) = reference.pose(found.snapshot.q, "bob")
    assert x == pytest.approx(0.4226, abs=1e-3)  # l sin 25 deg
    assert x**2 + y**2 == pytest.approx(1.0)  # and the rod is as long as it is


@pytest.mark.parametrize(
    "system",
    [
        pendulum("tension of rod at start"),
        pendulum("acceleration of theta", start="10 deg"),
        pendulum("acceleration of theta", rate=", rate(theta): 2 rad/s"),
        pendulum("time when theta = 0.1", rate=", rate(theta): 2 rad/s"),
    ],
    ids=["start", "open already", "moves", "event"],
)
def test_a_start_that_matters_is_drawn_as_it_is(system: System) -> None:
    assert general_position(system) is None


def test_both_angles_of_a_double_pendulum_can_be_told_apart() -> None:
    system = System.load(EXAMPLES / "double_pendulum.yaml")
    found = general_position(system)
    assert found is not None
    first, second = (float(found.snapshot.value(system.measures[name])) for name in ("theta1", "theta2"))
    assert first == pytest.approx(0.4363, abs=1e-3)
    assert second == pytest.approx(0.7854, abs=1e-3)
