"""From where a picture of space is drawn, and the dimensions that it shows from there."""

from __future__ import annotations

import math
import re
from collections import Counter
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.present.picture.picture import Picture
from freebody.present.scene import Scene
from freebody.present.space.solids import tube
from freebody.present.space.viewpoint import best_angles
from freebody.present.view import AZIMUTH, ELEVATION
from freebody.study.pictures.instant import start_of
from freebody.study.pictures.picture_in_space import poses_of

EXAMPLES = Path(__file__).parents[1] / "examples"
SHAFT = """
space: true
parameters: {L: 0.5 m, R: 0.2 m, beta: 30 deg, gamma: {value: ANGLE, sign: any}}
ground: {points: {O: [0, R*cos(beta) + L*sin(beta), 0]}, planes: {floor: {normal: up}}}
bodies:
  shaft: {body: {inertia: 1 kg m^2}, points: {B: [L*cos(beta), -L*sin(beta), 0]},
    lines: {arm: {through: shaft.B, along: [cos(beta), -sin(beta), 0]}}, turned: [gamma about y]}
  disk: {disk: {mass: 2 kg, radius: R, axis: [cos(beta), -sin(beta), 0]}}
connections:
  bearing: {revolute: {first: ground.O, second: shaft, about: y}}
  spindle: {revolute: {first: shaft.B, second: disk, about: shaft.arm, second_axis: disk.axis}}
LOADS
"""


def load(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


def angles(system: fb.System) -> tuple[float, float]:
    found = start_of(system, at_rest=True)
    return best_angles(Scene.of(system, found.snapshot.reference.number), *poses_of(found))


def labels(picture: Picture) -> Counter[str]:
    return Counter(word.label.text for word in picture.words)


def test_axes_in_one_plane_are_seen_along_its_normal() -> None:
    assert angles(load("disk_on_angled_shaft")) == (0.0, 0.0)
    assert angles(load("tilted_disk_on_shaft")) == (0.0, 0.0)


@pytest.mark.parametrize("turn", [20.0, -35.0])
def test_the_side_turns_with_the_plane_of_the_axes(turn: float) -> None:
    """The arm in the plane of y and of x turned about y by gamma; the viewer at the azimuth gamma looks along z' ."""
    system = fb.System.from_text(SHAFT.replace("ANGLE", f"{turn} deg").replace("LOADS", ""))
    azimuth, elevation = angles(system)
    assert azimuth == pytest.approx(turn, abs=1e-4)
    assert elevation == 0.0


@pytest.mark.parametrize("name", ["cardan_joint", "gyroscope_in_gimbals", "rolling_coin", "bennett_linkage"])
def test_axes_in_no_plane_are_seen_from_above(name: str) -> None:
    assert angles(load(name)) == (AZIMUTH, ELEVATION)


def test_couples_are_arcs_only_from_elsewhere() -> None:
    loads = "loads: {T: {torque: {on: shaft, about: y, magnitude: 1 N m}}}"
    system = fb.System.from_text(SHAFT.replace("ANGLE", "0 deg").replace("LOADS", loads))
    assert angles(system) == (AZIMUTH, ELEVATION)


def test_the_angled_shaft_has_its_lengths_its_radius_and_its_bend() -> None:
    found = labels(load("disk_on_angled_shaft").picture())
    assert found["L"] == 2  # both arms
    assert all(found[symbol] == 1 for symbol in ("R", "β", "O", "C", "B"))


def test_the_angle_between_two_shafts_is_drawn_at_their_joint() -> None:
    assert labels(load("cardan_joint").picture())["α"] == 1
    # from along the axis of the bend it is seen best, from within its plane not at all
    assert labels(load("cardan_joint").picture(view=(90.0, 0.0)))["α"] == 1
    assert labels(load("cardan_joint").picture(view=(0.0, 0.0)))["α"] == 0


def test_what_is_hidden_has_no_dimension() -> None:
    text = (EXAMPLES / "disk_on_angled_shaft.yaml").read_text() + "  hide: [beta, R]\n"
    found = labels(fb.System.from_text(text).picture())
    assert not found["β"]
    assert not found["R"]


def test_a_floor_that_is_seen_from_its_edge_is_hatched() -> None:
    side, above = (load("disk_on_angled_shaft").picture(view=v).svg() for v in ((0.0, 0.0), (30.0, 20.0)))
    longest = [max(len(re.findall(r"[ML]", way)) for way in re.findall(r'd="([^"]*)"', svg)) for svg in (side, above)]
    assert longest[0] > longest[1]  # all strokes are one line


def test_the_parts_of_a_bent_bar_meet_in_the_planes_that_halve_its_angles() -> None:
    turn = np.linspace(0.0, math.pi, 7)[:, None]
    way = np.hstack((np.cos(turn), np.sin(turn), np.zeros_like(turn)))
    parts = tube(way, 0.2, 12)
    for one, other in pairwise(parts):
        last, first = one.points[12:], other.points[:12]
        apart = np.linalg.norm(last[:, None] - first[None], axis=2).min(axis=1)
        assert apart.max() < 0.2 * (1.0 - math.cos(math.pi / 12)) + 1e-9  # rims of the same circle, turned in it


def test_a_plane_from_which_a_part_of_a_body_sticks_out_is_not_that_of_the_drawing() -> None:
    """Both axes are in the plane of y and z, the balls of the dumb-bell at both sides of it."""
    system = fb.System.from_text("""
space: true
bodies:
  shaft: {cylinder: {length: 0.6 m, radius: 0.02 m}}
  bell:
    composite:
      parts: [{particle: {mass: 1 kg}, at: [0.2 m, 0, 0]}, {particle: {mass: 1 kg}, at: [-0.2 m, 0, 0]}]
connections:
  bearing: {revolute: {first: ground, second: shaft, about: up}}
  weld: {weld: [shaft, bell]}
""")
    assert angles(system) == (AZIMUTH, ELEVATION)
