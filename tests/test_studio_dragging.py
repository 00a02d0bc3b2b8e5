"""Bodies that are dragged in the studio, in the plane and in space: where they come to, and what the text says then."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from freebody.errors import CannotAnswer, InputError
from freebody.language.document import Document
from freebody.numeric.contact.start import assembled_touching
from freebody.numeric.reference import Reference
from freebody.studio.dragging import drag
from freebody.studio.wire.texts import DragRequest
from freebody.system.system import System

PENDULUM = """# a pendulum
parameters: {L: 1 m, m: 2 kg, g: 9.81 m/s^2}  # what can be moved
bodies:
  rod: {rod: {mass: m, length: L}}  # thin
connections:
  A: {pin: [ground.A, rod.start]}
loads: {weight: {gravity: g}}
measures: {theta: {angle of rod}}
start: {theta: -60 deg}
questions:
  - {id: first, find: acceleration of theta}
"""


def end_of(text: str, body: str, length: float) -> tuple[float, float]:
    """Of a rod, from its mass centre."""
    reference = Reference(System.from_text(text))
    x, y, angle = reference.pose(reference.assemble(), body)
    return x + length / 2 * math.cos(angle), y + length / 2 * math.sin(angle)


@pytest.mark.parametrize("target", [(0.8, -0.6), (0.3, -3.0), (0.2, 0.1)])
def test_the_end_of_a_pendulum_follows_the_pointer_on_its_circle(target: tuple[float, float]) -> None:
    """The nearest point of a circle of radius L to a point P is L P/|P|."""
    text = drag(DragRequest(text=PENDULUM, body="rod", grabbed=end_of(PENDULUM, "rod", 1.0), to=target)).text
    size = math.hypot(*target)
    assert end_of(text, "rod", 1.0) == pytest.approx((target[0] / size, target[1] / size), abs=2e-3)
    assert text.splitlines()[1] == PENDULUM.splitlines()[1]  # only the start has changed
    assert text.replace(text.splitlines()[8], "start: {theta: -60 deg}") == PENDULUM


def test_a_parameter_of_the_start_is_dragged_in_its_own_unit() -> None:
    text = PENDULUM.replace("theta: -60 deg", "theta: phi").replace(
        "{L: 1 m", "{phi: {value: -60 deg, sign: any}, L: 1 m"
    )
    found = drag(DragRequest(text=text, body="rod", grabbed=end_of(text, "rod", 1.0), to=(0.0, -5.0))).text
    assert Document.read(found).data["parameters"]["phi"]["value"] == "-90 deg"


def test_a_free_body_is_dragged_by_its_place() -> None:
    text = "bodies: {ball: {particle: {mass: 1 kg}, at: [0, 1 m]}}\n"
    found = drag(DragRequest(text=text, body="ball", grabbed=(0, 1), to=(2.5, -0.5))).text
    assert found == "bodies: {ball: {particle: {mass: 1 kg}, at: [2.5, -0.5 m]}}\n"


def test_a_start_by_formulas_is_not_dragged() -> None:
    text = PENDULUM.replace("theta: -60 deg", "theta: -2*phi").replace("{L: 1 m", "{phi: 30 deg, L: 1 m")
    with pytest.raises(CannotAnswer, match="formulas"):
        drag(DragRequest(text=text, body="rod", grabbed=end_of(text, "rod", 1.0), to=(0.0, -5.0)))


BALL_PENDULUM = """# on a ball joint
space: {up: z}
parameters: {L: 1 m, m: 2 kg, g: 9.81 m/s^2}
bodies:
  bob: {body: {mass: m}, points: {top: [0, 0, L]}, turned: [alpha about x, beta about y]}
connections: {A: {spherical: [ground.A, bob.top]}}
loads: {weight: {gravity: g}}
start: {alpha: 20 deg, beta: 10 deg}
"""
VIEWS = [((0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), ((0.8, 0.6, 0.0), (-0.36, 0.48, 0.8))]


def center_of(text: str, body: str) -> Any:
    reference = Reference(System.from_text(text))
    return np.array(reference.pose(assembled_touching(reference), body)[:3])


def axes_of(text: str, body: str) -> Any:
    """The columns of its rotation."""
    reference = Reference(System.from_text(text))
    return reference.frame_of(assembled_touching(reference), body)[1]


@pytest.mark.parametrize(("across", "up"), VIEWS)
def test_a_bob_in_space_comes_under_the_pointer_on_its_sphere(across: Any, up: Any) -> None:
    """What is seen of it is where the pointer is; how deep it lies is what the joint leaves: |r| = L."""
    start = center_of(BALL_PENDULUM, "bob")
    picture, move = np.array((across, up)), np.array((0.15, 0.05))
    to = start + picture.T @ move
    request = DragRequest(text=BALL_PENDULUM, body="bob", grabbed=list(start), to=list(to), across=across, up=up)
    text = drag(request).text
    found = center_of(text, "bob")
    assert picture @ (found - start) == pytest.approx(move, abs=2e-3)
    assert np.linalg.norm(found) == pytest.approx(1.0, abs=1e-9)
    changed = [new for old, new in zip(BALL_PENDULUM.splitlines(), text.splitlines(), strict=True) if old != new]
    assert len(changed) == 1
    assert changed[0].startswith("start: {alpha: ")


@pytest.mark.parametrize(("across", "up"), VIEWS)
def test_out_of_reach_a_bob_comes_to_the_rim_that_its_sphere_shows(across: Any, up: Any) -> None:
    """Seen along any direction the sphere of radius L is a disk, of which L P/|P| is nearest to P outside of it."""
    start, picture = center_of(BALL_PENDULUM, "bob"), np.array((across, up))
    pointer = np.array((1.6, -1.2))
    request = DragRequest(
        text=BALL_PENDULUM, body="bob", grabbed=list(start), to=list(picture.T @ pointer), across=across, up=up
    )
    found = picture @ center_of(drag(request).text, "bob")
    assert found == pytest.approx(pointer / np.linalg.norm(pointer), abs=2e-3)


def test_a_free_body_in_space_keeps_its_depth_and_turns_by_what_stands_there() -> None:
    text = (
        "space: true\nbodies: {block: {box: {mass: 1 kg, size: [1, 2, 3]}, at: [0, 1 m, 2 m], "
        'turned: [10 deg about z, 0 deg about x, "20 deg about [0, 1, 0]"]}}\n'
    )
    center = center_of(text, "block")
    request = DragRequest(text=text, body="block", grabbed=list(center), to=[0.5, 3.0, 9.0])
    assert drag(request).text == text.replace("[0, 1 m, 2 m]", "[0.5, 3 m, 2 m]")
    corner = center + axes_of(text, "block") @ np.array((0.5, 1.0, 1.5))
    request = DragRequest(text=text, body="block", grabbed=list(corner), to=[0.9, 3.1, 2.0])
    found = drag(request).text
    moved = center_of(found, "block") + axes_of(found, "block") @ np.array((0.5, 1.0, 1.5))
    assert moved[:2] == pytest.approx([0.9, 3.1], abs=5e-3)
    assert ' deg about [0, 1, 0]"]' in found


def test_a_body_without_a_word_of_its_start_gets_a_place() -> None:
    text = BALL_PENDULUM.replace(", turned: [alpha about x, beta about y]", "").replace(
        "start: {alpha: 20 deg, beta: 10 deg}\n", ""
    )
    start = center_of(text, "bob")
    to = [0.3, -0.2, 0.0]
    found = drag(DragRequest(text=text, body="bob", grabbed=list(start), to=to)).text
    assert center_of(found, "bob")[:2] == pytest.approx(to[:2], abs=2e-3)


def test_a_view_without_two_directions_is_refused() -> None:
    across, up = (1.0, 0.0, 0.0), (2.0, 0.0, 0.0)
    with pytest.raises(InputError, match="direction"):
        drag(DragRequest(text=PENDULUM, body="rod", grabbed=[0, 0], to=[1, 1], across=across, up=up))
