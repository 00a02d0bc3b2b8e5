"""Random scenes of things that touch: every outcome is a typed one, and what it says obeys the laws of contact."""

from __future__ import annotations

import math

import numpy as np
import pytest

import freebody as fb
from contact_scenes import Scene, Thing, box_of_lines, depth, faults, random_scene
from freebody.errors import CannotAnswer
from freebody.numeric.engine.course import Status
from thinned import thinned

KNOWN = (Status.FINISHED, Status.TOO_LONG, Status.CHATTER, Status.INCONSISTENT)
MOST_STEPS = 5000  # scenes of two things take some 50, of six some 400


def checked(scene: Scene, seed: int, until: float) -> Status | None:
    """Runs a scene; its status, None if it cannot begin. Fails naming the seed and all that is wrong."""
    print(f"seed {seed}")
    try:
        result = scene.system().simulate(until, every=until / 200, max_steps=MOST_STEPS)
    except CannotAnswer:
        return None
    wrong = faults(scene, result)
    assert not wrong, f"seed {seed}: {'; '.join(wrong)}\n{scene.text()}"
    assert result.status in KNOWN, f"seed {seed}: {result.status} {result.message}"
    return result.status


# -- the yardstick ----------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("first", "second", "at", "expected"),
    [
        ("disk", "disk", (0.25, 0.0), -0.05),
        ("disk", "disk", (0.15, 0.0), 0.05),
        ("disk", "box", (0.35, 0.0), -0.05),
        ("disk", "box", (0.28, 0.0), 0.02),
        ("disk", "box", (0.2 + 0.1, 0.1 + 0.1), -0.1 * (math.sqrt(2) - 1)),
        ("box", "box", (0.39, 0.05), 0.01),
        ("box", "box", (0.45, 0.0), -0.05),
        ("rod", "box", (0.41, 0.0), -0.01),
    ],
)
def test_the_depth_of_penetration_is_that_of_the_outlines(
    first: str, second: str, at: tuple[float, float], expected: float
) -> None:
    shapes = {
        "disk": Thing("a", "", radius=0.1),
        "box": Thing("a", "", corners=((-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1))),
        "rod": Thing("a", "", corners=((-0.2, 0.0), (0.2, 0.0))),
    }
    scene = Scene((shapes[first], shapes[second]), (), "")
    poses = np.array([[*at, 0.0], [0.0, 0.0, 0.0]])
    assert depth(scene, poses) == pytest.approx(expected, abs=1e-12)


# -- random scenes ----------------------------------------------------------------------------
@pytest.mark.parametrize("seed", thinned(range(24), lambda seed: seed < 8))
def test_two_things_thrown_at_each_other(seed: int) -> None:
    assert checked(random_scene(seed, 2), seed, 2.0) is Status.FINISHED


@pytest.mark.parametrize("seed", thinned(range(100, 110), lambda seed: seed < 104))
def test_four_things_thrown_at_each_other(seed: int) -> None:
    assert checked(random_scene(seed, 4), seed, 1.5) is Status.FINISHED


@pytest.mark.parametrize(
    ("n", "seed", "what"),
    [
        (2, 22, "a ball leaves the end of an edge"),
        (2, 37, "a corner rises by less than can be seen and falls again"),
        (2, 43, "a turning polygon cuts through an edge between two looks"),
        (3, 559, "a particle against a corner"),
        (3, 1042, "a slip rate of round-off with the wrong sign"),
        (4, 101, "a particle on a rod, which has two sides"),
        (4, 404, "a contact that pushes nothing, which no other row keeps closed"),
        (4, 470, "a wedged ball: a gap of places that rows hold more than once stays, while that of motion vanishes"),
        (4, 135, "a ball passes near a corner within one step"),
        (5, 431, "a mode begins again in which a contact carried nothing the time before"),
        (6, 204, "a gap is pushed below zero where another one is closed"),
    ],
)
def test_scenes_that_are_hard_for_a_reason(n: int, seed: int, what: str) -> None:
    print(what)
    assert checked(random_scene(seed, n), seed, 2.0) is Status.FINISHED


def test_more_modes_than_can_be_tried_are_walked_through() -> None:
    """After some sixty events round-off decides how this heap lies; it rests, or three sliding contacts jam in it."""
    assert checked(random_scene(215, 6), 215, 2.0) in (Status.FINISHED, Status.INCONSISTENT)


@pytest.mark.parametrize("seed", thinned(range(10), lambda seed: seed < 4))
def test_eight_discs_in_a_box_of_lines(seed: int) -> None:
    assert checked(random_scene(300 + seed, 8, "disk sphere"), 300 + seed, 1.0) is Status.FINISHED


@pytest.mark.parametrize("n", [2, 3])
def test_a_stack_of_boxes_of_one_size_rests_flush(n: int) -> None:
    corners = ((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1))
    shape = "rectangle: {mass: 1 kg, width: 0.2 m, height: 0.2 m}"
    things = tuple(Thing(f"b{k}", shape, corners=corners, at=(0.0, 0.1 + 0.2 * k)) for k in range(n))
    scene = Scene(things, box_of_lines(4.0), "friction: 0.5, restitution: 0.2")
    result = scene.system().simulate(5.0)
    assert result.status is Status.FINISHED
    assert result.events == ()
    assert not faults(scene, result)
    assert np.abs(result.course.poses - result.course.poses[0]).max() < 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(400, 480))
def test_many_more_scenes_of_two_to_five_things(seed: int) -> None:
    assert checked(random_scene(seed, 2 + seed % 4), seed, 2.0) is Status.FINISHED


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(200, 220))
@pytest.mark.parametrize("n", [6, 10])
def test_scenes_of_many_things(n: int, seed: int) -> None:
    checked(random_scene(seed, n), seed, 1.5)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(8))
def test_fifty_places_of_discs_and_boxes_in_a_box(seed: int) -> None:
    checked(random_scene(900 + seed, 8, "disk box"), 900 + seed, 2.0)


def test_a_scene_that_begins_inside_something_is_refused_by_name() -> None:
    corners = ((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1))
    shape = "rectangle: {mass: 1 kg, width: 0.2 m, height: 0.2 m}"
    things = (Thing("a", shape, corners=corners, at=(0.0, 0.1)), Thing("b", shape, corners=corners, at=(0.15, 0.1)))
    with pytest.raises(CannotAnswer, match=r"inside"):
        fb.System.from_text(Scene(things, box_of_lines(4.0), "friction: 0.5").text()).simulate(1.0)
