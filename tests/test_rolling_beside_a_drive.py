"""What rolls beside a drive: the friction that it takes not to slip as it sets out."""

from __future__ import annotations

import pytest
from tests.conftest import Agree

import freebody as fb

PIPE = """
parameters: {m: 40 kg, M: 3000 kg, R: 0.3 m, A: 0.1 m, W: 6 rad/s, a0: 1.6 m/s^2, mu: 0.3, g: 9.81 m/s^2}
bodies:
  truck: {rectangle: {mass: M, width: 5 m, height: 0.4 m}, at: [0, 0]}
  pipe: {ring: {mass: m, radius: R}, at: [0, 0.2 m + R]}
connections:
  road: {slider: {body: truck, along: right}}
  motor: {driver: {measure: X, follows: a0*t^2/2}}
  bed: {contact: {between: [pipe, truck.top], friction: mu}}
loads: {weight: {gravity: g}}
measures: {X: x of truck, x: x of pipe}
"""


def test_a_pipe_on_a_truck_that_starts_is_taken_along_by_half(agrees: Agree) -> None:
    """Meriam, Dynamics, sec. 6/4: F R = m R^2 alpha and F = m a with a + R alpha = a0, so F = m a0/2 <= mu m g."""
    system = fb.System.from_text(PIPE)
    asked = ["least mu so that the pipe does not slip", "largest a0 so that the pipe does not slip"]
    solution = system.solve(asked)
    agrees(solution, solution.answers[0].id, "a0/(2*g)")
    agrees(solution, solution.answers[1].id, "2*mu*g")


def test_beside_a_drive_whose_forces_change_it_is_not_asked_of_the_first_instant() -> None:
    """A plate that shakes has no acceleration where it starts; any friction would do there."""
    system = fb.System.from_text(PIPE.replace("a0*t^2/2", "A*sin(W*t)"))
    [answer] = system.solve("least mu so that the pipe does not slip").answers
    assert answer.expression is None
    assert "a matter of an instant" in answer.reason


@pytest.mark.parametrize("asked", ["does it hold"])
def test_that_it_rests_is_still_refused(asked: str) -> None:
    """It does not go along with the bed, whatever the friction."""
    [answer] = fb.System.from_text(PIPE).solve(asked).answers
    assert "something is free to move" in answer.reason
