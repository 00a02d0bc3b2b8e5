"""What is drawn of systems in space: views, solids, the order of depth, names, stills and the player page."""

from __future__ import annotations

import json
import math
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import freebody as fb
from freebody.connections.base import Connection
from freebody.errors import InputError, ModelError
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrices, matrix
from freebody.present.corner import round_length
from freebody.present.figures import Array, hull
from freebody.present.names import footprints, names
from freebody.present.picture.arrows import Arrows, acting_at
from freebody.present.picture.forces import ShownForce
from freebody.present.picture.label import name as symbol
from freebody.present.picture.sketch import Sketch
from freebody.present.scene import Scene
from freebody.present.space import solids
from freebody.present.space.animation import write_animation
from freebody.present.space.bodies import body_pieces, reach
from freebody.present.space.drawing import SpatialDrawing
from freebody.present.space.motion import at_times, between, quaternions
from freebody.present.space.order import back_to_front, overlap, seen_ball, seen_solid
from freebody.present.space.painter import paint, painted, shots
from freebody.present.space.solids import Solid
from freebody.present.view import View
from freebody.study.pictures.picture import draw, free_body, picture
from freebody.system.system import System

UP_Z = np.array((0.0, 0.0, 1.0))
TOP = """
title: A <fast> top
space: {up: z}
ground: {points: {O: [0, 0, 0]}, planes: {floor: {normal: up}}}
bodies:
  top:
    cone: {mass: 1 kg, radius: 0.05 m, height: 0.1 m}
    turned: [psi about z, theta about x, phi about z]
connections: {tip: {spherical: [ground.O, top.apex]}}
loads: {weight: {gravity: 9.81 m/s^2}}
start: {theta: 30 deg}
"""
GYRO = """
title: Gyroscope
space: {up: z}
ground: {points: {O: [0, 0, 0]}}
bodies:
  outer: {ring: {mass: 0.5 kg, radius: 0.3 m, axis: y}}
  inner: {ring: {mass: 0.3 kg, radius: 0.24 m, axis: z}}
  rotor: {disk: {mass: 1 kg, radius: 0.15 m, axis: y}}
connections:
  vertical: {revolute: {first: ground.O, second: outer, about: z}}
  cross: {revolute: {first: outer, second: inner, about: x}}
  spin: {revolute: {first: inner, second: rotor, about: y}}
"""
SLIDER_CRANK = """
title: Spatial slider-crank
space: {up: z}
ground: {points: {O: [0, 0, 0.3], S: [0.1, 0, 0]}}
bodies:
  crank:
    box: {mass: 1 kg, size: [0.03 m, 0.02 m, 0.1 m]}
    points: {hub: [0, 0, -0.05], pin: [0, 0, 0.05]}
    near: {at: [0, 0, 0.35]}
  rod: {cylinder: {mass: 0.5 kg, radius: 0.01 m, length: 0.45 m, axis: x}, near: {at: [0.2, 0, 0.2]}}
  slider: {box: {mass: 1 kg, size: [0.08 m, 0.06 m, 0.05 m]}, near: {at: [0.3, 0, 0]}}
connections:
  hinge: {revolute: {first: ground.O, second: crank.hub, about: x}}
  ball: {spherical: [crank.pin, rod.start]}
  cross: {universal: {first: slider, second: rod.end, arm: z, second_arm: y}}
  guide: {prismatic: {first: ground.S, second: slider, along: x}}
loads:
  push: {force: {at: slider, along: left, magnitude: 5 N}}
  motor: {torque: {on: crank, about: x, magnitude: 1 N m}}
"""
FORMS = """
title: All forms
space: true
ground: {points: {A: [0, 1, 0]}}
bodies:
  block: {box: {mass: 1 kg, size: [0.4 m, 0.1 m, 0.3 m]}, at: [0.5, 0.3, 0], points: {hook: [0, 0.05, 0]}}
  shaft: {cylinder: {mass: 1 kg, radius: 0.05 m, length: 0.4 m}, at: [-0.5, 0, 0]}
  top: {cone: {mass: 1 kg, radius: 0.1 m, height: 0.2 m}, at: [0, -0.5, 0]}
  ball: {sphere: {mass: 1 kg, radius: 0.1 m}, at: [1.2, 0, 0]}
  wheel: {disk: {mass: 1 kg, radius: 0.2 m}, at: [0, 0, 1]}
  hoop: {ring: {mass: 1 kg, radius: 0.2 m}, at: [0, 0.7, 1]}
  rod: {rod: {mass: 1 kg, length: 0.5 m}, at: [0, -0.5, 1]}
  sheet: {polygon: {mass: 1 kg, corners: [[0, 0], [0.3, 0], [0, 0.3]]}, at: [-1, 0.5, 0]}
  bob: {particle: {mass: 1 kg}, at: [-1, -0.5, 0]}
  frame: {body: {mass: 1 kg, inertia: [1, 1, 1]}, points: {a: [0.3, 0, 0], b: [0, 0.3, 0]}, at: [1, 0.8, 0]}
  base: {box: {mass: 0, size: [0.2, 0.2, 0.2]}, fixed: true, at: [1.2, -0.6, 0], turned: [30 deg about y]}
loads: {s: {spring: {first: ground.A, second: block.hook, stiffness: 5 N/m}}}
"""
MODELS = {"top": TOP, "gyro": GYRO, "slider-crank": SLIDER_CRANK, "forms": FORMS}


def posed(text: str) -> tuple[Scene, Array, Array]:
    """The scene of a model, and the centres (1, n, 3) and axes (1, n, 3, 3) at its start."""
    system = System.from_text(text)
    reference = Reference(system)
    q = reference.assemble()
    frames = [reference.frame_of(q, body.name) for body in system.moving]
    centers, axes = np.array([[center for center, _R in frames]]), np.array([[R for _center, R in frames]])
    return Scene.of(system, reference.number), centers, axes


def drawn(text: str) -> SpatialDrawing:
    return SpatialDrawing.of(*posed(text))


def spun(text: str, rate: float, duration: float = 1.0, n: int = 51) -> tuple[Scene, Array, Array, Array]:
    """All bodies of a model turning about the vertical through the origin [rad/s]."""
    scene, centers, axes = posed(text)
    times = np.linspace(0.0, duration, n)
    turns = np.array([matrix(scene.up * rate * t) for t in times])
    return scene, times, np.einsum("tij,nj->tni", turns, centers[0]), np.einsum("tij,njk->tnik", turns, axes[0])


def looks(drawing: SpatialDrawing, body: str = "") -> list[str]:
    """How the pieces of a drawing look, or those that turn with one body."""
    index = {form.name: form.index for form in drawing.scene.figures}
    return [piece.look for piece in drawing.pieces if not body or piece.turn == index[body]]


# -- views ------------------------------------------------------------------------------------
def test_the_vertical_is_vertical_on_paper_from_everywhere() -> None:
    for azimuth in (-200.0, 0.0, 30.0, 75.0):
        for elevation in (-60.0, 0.0, 20.0, 80.0):
            x, y, _depth = View.of(UP_Z, (azimuth, elevation)).seen(np.array((0.0, 0.0, 2.0)))
            assert x == pytest.approx(0.0, abs=1e-12)
            assert y == pytest.approx(2 * math.cos(math.radians(elevation)))


def test_from_the_front_x_is_to_the_right_and_z_towards_the_viewer_where_y_is_up() -> None:
    view = View.of(np.array((0.0, 1.0, 0.0)), (0.0, 0.0))
    assert view.seen(np.array((1.0, 2.0, 3.0))) == pytest.approx((1.0, 2.0, 3.0))


def test_from_the_front_y_is_to_the_right_and_x_towards_the_viewer_where_z_is_up() -> None:
    assert View.of(UP_Z, (0.0, 0.0)).seen(np.array((3.0, 1.0, 2.0))) == pytest.approx((1.0, 2.0, 3.0))


def test_a_view_keeps_lengths_across_the_line_of_sight() -> None:
    view = View.of(UP_Z, (37.0, 21.0))
    assert view.axes @ view.axes.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(view.axes) == pytest.approx(1.0)


def test_in_perspective_what_is_nearer_is_larger_and_the_middle_stays() -> None:
    view = View.of(UP_Z, (0.0, 0.0), np.zeros(3), 4.0)
    near, far = (view.seen(np.array((x, 1.0, 1.0))) for x in (1.0, -1.0))
    assert near[:2] == pytest.approx((4 / 3, 4 / 3))
    assert far[:2] == pytest.approx((4 / 5, 4 / 5))
    assert view.seen(np.array((0.0, 1.0, 1.0)))[:2] == pytest.approx((1.0, 1.0))


def test_planes_stay_planes_in_perspective() -> None:
    rng = np.random.default_rng(4)
    e, f = rng.standard_normal((2, 3))
    points = View.of(UP_Z, (30.0, 20.0), np.zeros(3), 9.0).seen(rng.uniform(-1, 1, (8, 2)) @ np.array((e, f)) + 0.3)
    assert np.linalg.svd(points - points.mean(axis=0))[1][2] == pytest.approx(0.0, abs=1e-12)


# -- solids -----------------------------------------------------------------------------------
CONVEX: dict[str, Solid] = {
    "box": solids.box(1.0, 2.0, 3.0),
    "prism": solids.prism(1.0, -1.0, 1.0),
    "marked prism": solids.marked(solids.prism(1.0, -1.0, 1.0), 16),
    "cone": solids.cone(1.0, 2.0),
    "marked cone": solids.marked_cone(1.0, 2.0),
    "part of a band": solids.band(1.0, 0.1, 0.05)[3],
    "part of a tube": solids.tube(np.array([(0.0, 0.0, 0.0), (1.0, 1.0, 0.5)]), 0.1)[0],
}


@pytest.mark.parametrize("name", CONVEX)
def test_faces_look_outwards_and_close_the_solid(name: str) -> None:
    solid = CONVEX[name]
    normals = solid.normals(solid.points)
    middle = solid.points[sorted({k for face in solid.faces for k in face})].mean(axis=0)
    for face, normal in zip(solid.faces, normals, strict=True):
        assert normal @ (solid.points[face[0]] - middle) > 0
        assert ((solid.points - solid.points[face[0]]) @ normal <= 1e-9).all()
    assert normals.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-9)


def test_edges_of_one_kind_follow_each_other_round_the_rim() -> None:
    rim = [edge for edge in solids.prism(1.0, 0.0, 1.0, 16).edges if edge.kind == "crease"]
    assert len(rim) == 32
    assert sum(a.end == b.start for a, b in pairwise(rim)) == 30


def test_a_basis_is_right_handed() -> None:
    rng = np.random.default_rng(1)
    for axis in rng.standard_normal((20, 3)):
        frame = solids.basis(axis)
        assert frame @ frame.T == pytest.approx(np.eye(3), abs=1e-12)
        assert np.cross(frame[0], frame[1]) == pytest.approx(axis / np.linalg.norm(axis))


@pytest.mark.parametrize(("value", "length"), [(0.3, 0.2), (0.5, 0.5), (99.0, 50.0), (1e-3, 1e-3)])
def test_lengths_of_scales_are_round(value: float, length: float) -> None:
    assert round_length(value) == pytest.approx(length)


# -- depth ------------------------------------------------------------------------------------
def solid_seen(solid: Solid, at: tuple[float, float, float], turn: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Any:
    points = solid.points @ matrix(np.array(turn)).T + np.array(at)
    return seen_solid(points, solid.normals(points), points[[face[0] for face in solid.faces]])


def test_the_common_part_of_two_squares() -> None:
    square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
    moved = [(x + 1, y + 1) for x, y in square]
    assert hull(np.array(overlap(square, moved))).tolist() == [[1, 1], [2, 1], [2, 2], [1, 2]]
    assert overlap(square, [(x + 5, y) for x, y in square]) == []


def test_a_long_plate_that_is_farther_in_the_middle_but_nearer_where_it_overlaps_is_in_front() -> None:
    # the middle of the plate is behind the ball; its near end, which covers the ball, is in front of it
    plate = solid_seen(solids.box(10.0, 1.0, 0.1), (-4.0, 0.0, -3.0), (0.0, -math.radians(45), 0.0))
    ball = seen_ball(np.array((-1.2, 0.0, -1.2)), 0.2)
    assert plate.depth < ball.depth
    assert back_to_front([plate, ball]) == [1, 0]
    below = seen_ball(np.array((-1.2, 0.0, 1.2)), 0.2)
    assert back_to_front([below, plate]) == [1, 0]


def test_what_overlaps_is_drawn_from_the_back_to_the_front() -> None:
    """Separate boxes stacked at random depths: the order is that of depth for each pair that overlaps on paper."""
    rng = np.random.default_rng(7)
    depths = rng.permutation(np.arange(12.0)) * 3
    pieces = [
        solid_seen(solids.box(2.0, 1.0, 1.5), (*rng.uniform(-2, 2, 2), z), tuple(rng.uniform(-1, 1, 3))) for z in depths
    ]
    order = back_to_front(pieces)
    assert sorted(order) == list(range(12))
    for place, k in enumerate(order):
        for j in order[place + 1 :]:
            if len(overlap(pieces[k].corners, pieces[j].corners)) > 2:
                assert depths[k] < depths[j]


def test_pieces_in_a_circle_are_all_drawn_once() -> None:
    """Three bars, each over the next: there is no right order, but none is lost."""
    bars = []
    for k in range(3):
        turn = matrix(np.array((0.0, 0.0, 2 * math.pi * k / 3)))
        points = (solids.box(6.0, 0.4, 0.1).points @ matrix(np.array((0.0, 0.3, 0.0))).T + (0.0, 1.0, 0.0)) @ turn.T
        solid = solids.box(6.0, 0.4, 0.1)
        bars.append(seen_solid(points, solid.normals(points), points[[face[0] for face in solid.faces]]))
    assert sorted(back_to_front(bars)) == [0, 1, 2]


def test_the_far_half_of_a_ring_is_behind_the_rotor_and_the_near_half_before_it() -> None:
    drawing = drawn(GYRO)
    index = {form.name: form.index for form in drawing.scene.figures}
    taken = shots(drawing, 0, drawing.view((30.0, 20.0)))
    rotor = next(k for k, shot in enumerate(taken) if shot.piece.look == "body")
    assert taken[rotor].piece.turn == index["rotor"]
    outline = taken[rotor].seen.corners
    ring = [(k, s) for k, s in enumerate(taken) if s.piece.look == "hoop" and s.piece.turn == index["inner"]]
    over = [(k, s) for k, s in ring if len(overlap(outline, s.seen.corners)) > 2]
    assert {k > rotor for k, _shot in over} == {True, False}
    for k, shot in over:
        assert (shot.seen.depth > 0) == (k > rotor)


def test_a_floor_is_behind_what_stands_on_it_and_before_it_from_below() -> None:
    drawing = drawn(TOP)
    assert shots(drawing, 0, drawing.view((30.0, 20.0)))[0].piece.look == "plane"
    assert shots(drawing, 0, drawing.view((30.0, -20.0)))[-1].piece.look == "plane"


def test_hidden_edges_of_a_box_are_weak_and_dashed() -> None:
    drawing = drawn(FORMS)
    box = next(p for p in drawing.pieces if p.look == "body" and len(p.solid.points) == 8)
    shot = next(s for s in shots(drawing, 0, drawing.view((30.0, 20.0))) if s.piece is box)
    marks = [mark for mark in paint(shot) if not mark.is_area]
    dashed = [mark for mark in marks if mark.dashes]
    assert sum(len(mark.points) - 1 for mark in dashed) == 3  # three edges meet in the hidden corner
    assert sum(len(mark.points) - 1 for mark in marks if not mark.dashes) == 9
    assert all(mark.stroke is not None and mark.stroke.alpha < 0.5 for mark in dashed)


# -- what is drawn ----------------------------------------------------------------------------
@pytest.mark.parametrize("name", MODELS)
def test_every_body_is_drawn(name: str) -> None:
    drawing = drawn(MODELS[name])
    for form in drawing.scene.figures:
        assert {"body", "hoop", "dot", "fixed body"} & set(looks(drawing, form.name)), form.name


@pytest.mark.parametrize("kind", sorted(k for k, c in Connection.kinds.items() if "space:" in c.example))
def test_the_example_of_every_connection_in_space_can_be_drawn(kind: str) -> None:
    try:
        drawing = drawn(Connection.kinds[kind].example)
    except ModelError:
        pytest.skip("its example is not complete")
    taken = shots(drawing, 0, drawing.view())
    assert len(taken) == len(drawing.pieces)
    assert all(np.isfinite(mark.points).all() for shot in taken for mark in paint(shot))


def test_joints_have_their_signs() -> None:
    drawing = drawn(SLIDER_CRANK)
    kinds = looks(drawing)
    assert kinds.count("rail") > 10
    assert kinds.count("stand") == 3  # of the hinge, and at both ends of the rail
    assert "force" in kinds
    balls = [p for p in drawing.pieces if p.look == "joint" and p.radius]
    assert len(balls) == 2  # the ball, and the middle of the cross
    assert len([p for p in drawing.pieces if p.look == "joint" and not p.radius]) == 2 + 4  # an axle, four arms


def test_an_axle_comes_out_of_the_bodies_that_it_joins() -> None:
    scene, centers, axes = posed(SLIDER_CRANK)
    drawing = SpatialDrawing.of(scene, centers, axes)
    crank = next(form for form in scene.figures if form.name == "crank")
    pieces = [p for p in drawing.pieces if p.look == "joint" and p.turn == crank.index and not p.radius]
    x = np.concatenate([p.placed(drawing.poses, 0)[0][:, 0] for p in pieces])
    assert x.min() < -0.015 - 0.5 * drawing.symbol  # the crank is 0.03 m thick
    assert x.max() > 0.015 + 0.5 * drawing.symbol


def test_what_hangs_in_a_yoke_without_extent_has_an_axle_that_reaches_it() -> None:
    text = (Path(__file__).parents[1] / "examples" / "conical_pendulum.yaml").read_text(encoding="utf-8")
    drawing = drawn(text)
    bob = next(form for form in drawing.scene.figures if form.name == "bob")
    top = drawing.poses.place(bob.points["top"], 0)
    axle = [p for p in drawing.pieces if p.look == "joint" and p.turn == bob.index]
    points = np.concatenate([p.placed(drawing.poses, 0)[0] for p in axle])
    assert np.linalg.norm(points - top, axis=1).min() < drawing.symbol


def test_the_axle_of_a_ring_is_at_its_rim_not_in_its_middle() -> None:
    drawing = drawn(GYRO)
    outer = next(form for form in drawing.scene.figures if form.name == "outer")
    axle = [p for p in drawing.pieces if p.look == "joint" and p.turn == outer.index]
    heights = np.abs(np.concatenate([p.placed(drawing.poses, 0)[0][:, 2] for p in axle]))
    assert heights.min() > 0.29


def test_nothing_stands_where_a_plane_holds_it() -> None:
    assert "stand" not in looks(drawn(TOP))
    assert "stand" in looks(drawn(TOP.replace(", planes: {floor: {normal: up}}", "")))


def test_a_torque_turns_right_handed_about_its_axis() -> None:
    drawing = drawn(SLIDER_CRANK)
    crank = next(form for form in drawing.scene.figures if form.name == "crank")
    arc = [p for p in drawing.pieces if p.look == "force" and p.place.body == crank.index]
    middles = np.array([p.placed(drawing.poses, 0)[0].mean(axis=0) for p in arc])[:-1]
    radii = middles - middles[:, :] @ np.diag((1.0, 0.0, 0.0)) - (0.0, 0.0, 0.3)
    turns = np.cross(radii[:-1], radii[1:])
    assert (turns[:, 0] > 0).all()


def test_a_spring_follows_its_ends() -> None:
    scene, centers, axes = posed(FORMS)
    moved = np.concatenate((centers, centers + np.array((0.0, -0.4, 0.0))))
    drawing = SpatialDrawing.of(scene, moved, np.concatenate((axes, axes)))
    spring = next(p for p in drawing.pieces if p.look == "spring")
    for frame, hook in ((0, (0.5, 0.35, 0.0)), (1, (0.5, -0.05, 0.0))):
        _points, (line,) = spring.placed(drawing.poses, frame)
        assert line[0] == pytest.approx((0.0, 1.0, 0.0))
        assert line[-1] == pytest.approx(hook)


def test_symbols_grow_with_the_system() -> None:
    small, large = drawn(TOP), drawn(TOP.replace("0.05 m", "0.5 m").replace("0.1 m", "1 m"))
    assert large.symbol == pytest.approx(10 * small.symbol)
    assert 0.01 < small.symbol / small.size < 0.03


# -- names ------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("angles", [(30.0, 20.0), (-60.0, 5.0), (100.0, 60.0)])
def test_names_stand_in_the_picture_and_not_on_each_other(name: str, angles: tuple[float, float]) -> None:
    drawing = drawn(MODELS[name])
    view = drawing.view(angles)
    low, high = drawing.bounds(view)
    letter = float((high - low).max()) / 70
    frame = low - 6 * letter, high + 6 * letter
    inks = footprints(painted(drawing, 0, view), letter)
    bodies = {form.index: form.name for form in drawing.scene.figures}
    found = names(inks, bodies, (0.56 * letter, letter), frame)
    assert [label.text for label in found] == list(bodies.values())
    for k, label in enumerate(found):
        assert (label.at - label.half >= frame[0]).all()
        assert (label.at + label.half <= frame[1]).all()
        assert not any(label.overlaps(other.at, other.half) for other in found[k + 1 :])


# -- files ------------------------------------------------------------------------------------
@pytest.mark.parametrize(("suffix", "start"), [(".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")])
@pytest.mark.parametrize("dark", [False, True])
def test_a_picture_is_written_by_its_suffix(tmp_path: Path, suffix: str, start: bytes, dark: bool) -> None:
    path = draw(System.from_text(TOP), tmp_path / f"top{suffix}", dark=dark)
    assert path.read_bytes().startswith(start)


def test_an_svg_is_well_formed_and_says_what_it_shows(tmp_path: Path) -> None:
    path = draw(System.from_text(SLIDER_CRANK.replace("Spatial slider-crank", "Crank <1> & rod")), tmp_path / "a.svg")
    root = ET.parse(path).getroot()
    space = "{http://www.w3.org/2000/svg}"
    title, desc = root.find(f"{space}title"), root.find(f"{space}desc")
    assert title is not None
    assert title.text == "Crank <1> & rod"
    assert desc is not None
    assert desc.text is not None
    assert all(name in desc.text for name in ("crank", "rod", "slider"))
    assert root.get("aria-labelledby") == f"{title.get('id')} {desc.get('id')}"


def test_another_view_and_perspective_give_other_pictures(tmp_path: Path) -> None:
    pictures = {
        draw(System.from_text(GYRO), tmp_path / f"{k}.png", **options).read_bytes()
        for k, options in enumerate([{}, {"view": (70.0, 10.0)}, {"perspective": True}, {"dark": True}])
    }
    assert len(pictures) == 4


def test_dark_paper_is_dark(tmp_path: Path) -> None:
    for dark in (False, True):
        path = draw(System.from_text(TOP), tmp_path / "a.png", dark=dark)
        corner = np.asarray(Image.open(path).convert("L"))[5, 5]
        assert corner < 50 if dark else corner > 200


@pytest.mark.parametrize(("name", "message"), [("a.docx", ".svg, .png, .pdf"), ("no/a.png", "cannot be written")])
def test_a_picture_that_cannot_be_written_says_why(tmp_path: Path, name: str, message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)):
        draw(System.from_text(TOP), tmp_path / name)


# -- motions ----------------------------------------------------------------------------------
def test_quaternions_are_continuous_and_give_their_matrices_back() -> None:
    turns = np.array([[matrix(np.array((0.0, 0.0, a)))] for a in np.linspace(0, 12, 80)])
    q = quaternions(turns)
    assert matrices(q) == pytest.approx(turns, abs=1e-12)
    assert (np.abs(np.diff(q, axis=0)) < 0.1).all()


def test_between_two_rotations_the_turning_is_even() -> None:
    p, q = quaternions(np.array([[np.eye(3)], [matrix(np.array((0.0, 1.2, 0.0)))]]))
    for share in (0.0, 0.25, 0.5, 1.0):
        found = matrices(between(p, q, np.array([share])))[0]
        assert found == pytest.approx(matrix(np.array((0.0, 1.2 * share, 0.0))), abs=1e-12)
    assert between(p, -q, np.array([0.5])) == pytest.approx(between(p, q, np.array([0.5])))


def test_a_motion_at_other_times_goes_through_the_given_poses() -> None:
    _scene, times, centers, axes = spun(TOP, 2.0, n=11)
    shown, places, q = at_times(times, centers, quaternions(axes), 41)
    assert shown[::4] == pytest.approx(times)
    assert places[::4] == pytest.approx(centers, abs=1e-12)
    assert matrices(q)[::4] == pytest.approx(axes, abs=1e-9)


def page_of(path: Path) -> tuple[str, dict[str, Any]]:
    text = path.read_text(encoding="utf-8")
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)
    assert found
    return text, json.loads(found[1])


def test_the_player_needs_no_network_and_says_what_it_shows(tmp_path: Path) -> None:
    text, data = page_of(write_animation(*spun(TOP, 2.0), tmp_path / "a.html", title="A <fast> top"))
    assert "://" not in text.replace("http://www.w3.org", "")
    assert "default-src 'none'" in text
    assert "<title>A &lt;fast&gt; top</title>" in text
    assert 'role="img" aria-label="Animation of A &lt;fast&gt; top' in text
    assert "arrow keys" in text
    assert "{{" not in text
    assert data["names"] == ["top"]


def test_the_player_gets_all_pieces_and_the_poses_as_quaternions(tmp_path: Path) -> None:
    scene, times, centers, axes = spun(SLIDER_CRANK, 2.0)
    _text, data = page_of(write_animation(scene, times, centers, axes, tmp_path / "a.html", title="crank"))
    assert len(data["columns"]) == 7 * 3
    assert len(data["columns"][0]) == data["n_frames"] > 100
    last = [column[-1] for column in data["columns"][7:14]]  # of the rod
    assert last[:3] == pytest.approx(centers[-1, 1], abs=1e-4)
    assert matrices(np.array(last[3:])) == pytest.approx(axes[-1, 1], abs=1e-4)
    assert {label["text"] for label in data["labels"]} == {"crank", "rod", "slider"}
    assert {piece["look"] for piece in data["pieces"]} <= set(data["looks"])
    assert len(data["pieces"]) == len(SpatialDrawing.of(scene, centers, axes).pieces)


def test_quaternions_are_as_good_as_axes(tmp_path: Path) -> None:
    scene, times, centers, axes = spun(TOP, 2.0)
    first = write_animation(scene, times, centers, axes, tmp_path / "a.html", title="top")
    second = write_animation(scene, times, centers, quaternions(axes), tmp_path / "b.html", title="top")
    columns = [page_of(path)[1]["columns"] for path in (first, second)]
    assert np.array(columns[0]) == pytest.approx(np.array(columns[1]), abs=1e-4)


def test_a_fast_body_gets_enough_frames_to_turn_the_right_way(tmp_path: Path) -> None:
    slow = page_of(write_animation(*spun(TOP, 2.0), tmp_path / "a.html", title="top"))[1]
    fast = page_of(write_animation(*spun(TOP, 200.0, n=1001), tmp_path / "b.html", title="top"))[1]
    assert slow["n_frames"] < 150
    assert 200.0 * fast["dt"] < 0.8


def test_the_player_starts_with_the_given_view(tmp_path: Path) -> None:
    options: dict[str, Any] = {"title": "top", "view": (70.0, 15.0), "perspective": True}
    _text, data = page_of(write_animation(*spun(TOP, 2.0), tmp_path / "a.html", **options))
    assert data["angles"] == [70.0, 15.0]
    assert data["distance"] > 0


@pytest.mark.skipif(shutil.which("node") is None, reason="no node to run the script of the page")
def test_the_script_orders_pieces_as_the_painter_does(tmp_path: Path) -> None:
    scene, times, centers, axes = spun(GYRO, 1.0)
    path = write_animation(scene, times, centers, axes, tmp_path / "a.html", title="gyro")
    text, data = page_of(path)
    script = text[text.index("// -- places at a frame") : text.index("// -- drawing")]
    code = f"""
const data = {json.dumps(data)}, last = data.n_frames - 1;
{script}
look(...data.angles);
const poses = Array.from({{ length: {len(scene.names)} + data.fixed.length }}, (_, body) => pose(body, 0));
const all = data.pieces.map((piece, k) => Object.assign(shot(piece, poses), {{ k }}));
console.log(JSON.stringify(backToFront(all).map((s) => [s.k, s.depth])));
"""
    (tmp_path / "a.js").write_text(code, encoding="utf-8")
    printed = subprocess.run(["node", str(tmp_path / "a.js")], check=True, capture_output=True, text=True).stdout
    drawing = SpatialDrawing.of(scene, centers[:1], axes[:1])
    taken = shots(drawing, 0, drawing.view())
    number = {id(piece): k for k, piece in enumerate(drawing.pieces)}
    depths = dict(json.loads(printed))
    rank = {k: place for place, k in enumerate(depths)}
    assert {number[id(s.piece)]: s.seen.depth for s in taken} == pytest.approx(depths, abs=1e-3)
    pairs = [(s, t) for k, s in enumerate(taken) for t in taken[k + 1 :] if s.piece.turn != t.piece.turn]
    over = [(s, t) for s, t in pairs if len(overlap(s.seen.corners, t.seen.corners)) > 2]
    assert len(over) > 50
    assert all(rank[number[id(s.piece)]] < rank[number[id(t.piece)]] for s, t in over)


@pytest.mark.parametrize(("suffix", "start"), [(".gif", b"GIF89a"), (".mp4", b"")])
def test_films_are_written(tmp_path: Path, suffix: str, start: bytes) -> None:
    if suffix == ".mp4":
        pytest.importorskip("imageio_ffmpeg")
    path = write_animation(*spun(TOP, 2.0, 0.2), tmp_path / f"a{suffix}", title="top")
    assert path.read_bytes().startswith(start)
    assert path.stat().st_size > 1000


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"speed": 0.0}, "speed"),
        ({"times": np.array([0.0, -1.0])}, "ascend"),
        ({"times": np.zeros(0)}, "needs times"),
        ({"centers": np.zeros((2, 3, 3))}, "(2, 1, 3)"),
        ({"centers": np.full((2, 1, 3), np.nan)}, "finite"),
    ],
)
def test_motions_that_do_not_fit_are_refused(tmp_path: Path, change: dict[str, Any], message: str) -> None:
    scene, centers, axes = posed(TOP)
    given: dict[str, Any] = {
        "times": np.array([0.0, 1.0]),
        "centers": np.repeat(centers, 2, axis=0),
        "axes": np.repeat(axes, 2, axis=0),
        "speed": 1.0,
        **change,
    }
    with pytest.raises(InputError, match=re.escape(message)):
        write_animation(scene, path=tmp_path / "a.html", title="top", **given)


def test_another_suffix_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=re.escape(".html, .gif, .mp4")):
        write_animation(*spun(TOP, 2.0), tmp_path / "a.avi", title="top")


# -- bodies without extent --------------------------------------------------------------------
GIMBALS = """
title: Gimbals by their inertia
space: true
bodies:
  outer: {body: {inertia: 1e-3 kg m^2}}
  inner: {body: {inertia: 1e-3 kg m^2}}
  rotor: {body: {inertia: 1e-3 kg m^2}}
connections:
  vertical: {revolute: {first: ground.O, second: outer, about: y}}
  horizontal: {revolute: {first: outer, second: inner, about: x}}
  spin: {revolute: {first: inner, second: rotor, about: z}}
"""


def test_bodies_without_extent_are_arcs_between_the_axes_of_their_joints() -> None:
    drawing = drawn(GIMBALS)
    assert not drawing.has_lengths
    index = {form.name: form.index for form in drawing.scene.figures}
    for name, axes in (("outer", np.array([(0, 1, 0), (1, 0, 0)])), ("inner", np.array([(1, 0, 0), (0, 0, 1)]))):
        parts = [p for p in drawing.pieces if p.turn == index[name] and p.look == "hoop"]
        middles = np.array([p.solid.points.mean(axis=0) for p in parts])
        assert np.linalg.norm(middles, axis=1) == pytest.approx(np.ones(len(parts)), abs=0.01)
        assert middles[[0, -1]] == pytest.approx(axes, abs=0.05)
    assert "body" in looks(drawing, "rotor")


def test_axles_of_bodies_without_extent_are_where_the_arcs_end() -> None:
    drawing = drawn(GIMBALS)
    axles = [p.placed(drawing.poses, 0)[0].mean(axis=0) for p in drawing.pieces if p.look == "joint"]
    assert np.array(axles) == pytest.approx(np.array([(0, 1, 0), (1, 0, 0), (0, 0, 1)]), abs=0.05)


def test_axes_of_the_ground_that_are_close_come_to_lie_on_both_sides() -> None:
    two = """
space: true
bodies: {left: {body: {inertia: 1 kg m^2}}, right: {body: {inertia: 1 kg m^2}}}
connections:
  a: {revolute: {first: ground.O, second: left, about: x}}
  b: {revolute: {first: ground.O, second: right, about: x}}
"""
    drawing = drawn(two)
    axles = [p.placed(drawing.poses, 0)[0][:, 0].mean() for p in drawing.pieces if p.look == "joint"]
    assert sorted(np.sign(axles)) == [-1.0, 1.0]


SPATIAL = [p for p in sorted((Path(__file__).parents[1] / "examples").glob("*.yaml")) if "\nspace:" in p.read_text()]


@pytest.mark.parametrize("path", SPATIAL, ids=lambda path: path.stem)
def test_every_example_in_space_can_be_drawn(path: Path) -> None:
    drawing = drawn(path.read_text(encoding="utf-8"))
    taken = shots(drawing, 0, drawing.view())
    assert all(np.isfinite(mark.points).all() for shot in taken for mark in paint(shot))
    assert {form.index for form in drawing.scene.figures} <= {piece.turn for piece in drawing.pieces}


def test_a_ball_without_a_radius_is_drawn_as_a_point(tmp_path: Path) -> None:
    text = "space: true\nbodies: {p: {sphere: {mass: 1 kg, radius: 0}}, q: {box: {mass: 1 kg, size: [1 m, 1 m, 1 m]}}}"
    file, picture = tmp_path / "m.yaml", tmp_path / "m.svg"
    file.write_text(text, encoding="utf-8")
    subprocess.run([sys.executable, "-m", "freebody", "draw", str(file), "-o", str(picture)], check=True)
    assert "<svg" in picture.read_text(encoding="utf-8")


# -- the plane is the view along z ------------------------------------------------------------
def test_forces_and_couples_seen_along_z_are_those_of_the_plane() -> None:
    def drawn(
        force: tuple[float, ...], moment: tuple[float, ...], center: tuple[float, ...]
    ) -> list[tuple[float, ...]]:
        sketch = Sketch(100.0, np.zeros(2))
        loads = [
            ShownForce("F", symbol("F"), "b", center, force, (0.0,) * len(moment)),
            ShownForce("M", symbol("M"), "b", center, (0.0,) * len(force), moment),
        ]
        Arrows(sketch, acting_at(sketch, {"b": np.array(center)})).draw(loads)
        return [tuple(shape.points.ravel().round(9).tolist()) for shape in sketch.shapes]

    flat = drawn((0.6, 0.8), (-2.0,), (0.1, 0.2))
    assert flat == drawn((0.6, 0.8, 0.0), (0.0, 0.0, -2.0), (0.1, 0.2, 0.0))
    assert len(flat) == 4  # a shaft and an arc, each with its head


def test_joined_points_and_springs_have_their_names_in_space_too() -> None:
    system = System.from_text("""
space: true
parameters: {k: 10 N/m, m: 1 kg}
ground: {points: {O: [0, 0, 0]}}
bodies: {p: {particle: {mass: m}, at: [1 m, 0, 0]}}
loads: {s: {spring: {first: ground.O, second: p, stiffness: k}}}
""")
    said = {word.label.text for word in picture(system).words}
    assert {"k", "O", "p"} <= said


def test_a_particle_alone_is_a_dot_on_its_plane_and_cut_free() -> None:
    """It has no size that signs could be measured by: neither its dot nor the arrow on it fills the picture."""
    system = System.from_text("""
space: true
parameters: {P: 12 N}
ground: {planes: {table: {normal: up}}}
bodies: {block: {particle: {mass: 4 kg}}}
connections: {table: {contact: {between: [block, ground.table], friction: 0.6}}}
loads: {weight: {gravity: 9.81 m/s^2}, pull: {force: {at: block, along: [0, 0, 1], magnitude: P}}}
""")
    for found in (picture(system), free_body(system, "block")):
        dot = next(shape for shape in found.shapes if shape.is_area and len(shape.points) > 20)
        assert 6.0 < float(np.ptp(dot.points[:, 0])) < 30.0  # points of some 300 on paper


THROWN = """
space: true
parameters: {m: 1 kg, R: 0.1 m, v: 2 m/s, w: 60 rad/s}
bodies:
  ball: {sphere: {mass: m, radius: R}, at: [0, 0, 0], velocity: [-v, 0, 0], angular_velocity: [0, w, -w]}
  other: {sphere: {mass: m, radius: R}, at: [1 m, 0, 0]}
"""


def test_velocities_and_spins_at_the_start_are_arrows_from_the_edges_of_their_bodies() -> None:
    drawn = fb.System.from_text(THROWN).picture(view=(0.0, 0.0))
    green = [s for s in drawn.shapes if "velocity" in {ink.color for ink in (s.stroke, s.fill) if ink is not None}]
    shafts, heads = [s.points for s in green if len(s.points) == 2], [s for s in green if s.fill is not None]
    assert len(shafts) == 2
    assert len(heads) == 3  # an angular velocity has two
    ways = [(shaft[1] - shaft[0]) / float(np.hypot(*(shaft[1] - shaft[0]))) for shaft in shafts]
    # seen along -z: x to the right and y up, so that the spin (0, w, -w) is seen as an arrow upwards
    assert np.allclose(ways, ((-1.0, 0.0), (0.0, 1.0)), atol=1e-9)
    starts = [shaft[0] for shaft in shafts]
    rims = [s.points for s in drawn.shapes if s.stroke is not None and s.stroke.body == 0 and len(s.points) > 40]
    low, high = np.concatenate(rims).min(axis=0), np.concatenate(rims).max(axis=0)
    assert starts[0][0] < low[0]
    assert starts[1][1] > high[1]
    # its size sqrt(2) w is no parameter and has a symbol of its own
    assert {"v", "ω_ball"} <= {word.label.text for word in drawn.words}


def test_a_rod_pulls_at_its_own_end_of_a_body() -> None:
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "spatial_slider_crank.yaml")
    alone, with_rod = (free_body(system, "block"), free_body(system, "crank"))
    assert "T" in {word.label.text for word in with_rod.words}
    wide, tall = with_rod.corners[1] - with_rod.corners[0]
    assert max(wide, tall) < 2 * float(np.ptp(alone.corners, axis=0).max())  # nothing acts far from it


DUMB_BELL = """
space: true
parameters: {m: 2 kg, L: 0.4 m}
bodies:
  shaft: {cylinder: {length: 0.6 m, radius: 0.02 m}}
  bell:
    composite:
      parts:
        - {sphere: {radius: 0.06 m, mass: m}, at: [L/2, 0, 0]}
        - {sphere: {radius: 0.03 m, mass: 2*m}, at: [-L/2, 0, 0]}
connections:
  bearing: {revolute: {first: ground, second: shaft, about: up}}
  weld: {weld: [shaft, bell]}
"""


def test_the_parts_of_a_composite_body_are_drawn_as_the_solids_that_they_are() -> None:
    """The mass centre is at -L/6 from the middle."""
    system = fb.System.from_text(DUMB_BELL)
    scene = Scene.of(system, Reference(system).number)
    (bell,) = (form for form in scene.figures if form.name == "bell")
    pieces = list(body_pieces(bell, (), 0.01, is_fixed=False))
    balls = sorted((piece.place.x, piece.radius) for piece in pieces if piece.radius)
    assert balls == [pytest.approx((-0.4 / 3, 0.03)), pytest.approx((0.8 / 3, 0.06))]
    (bar,) = (piece for piece in pieces if not piece.radius)
    ends = bar.solid.points[:, 0]
    assert (ends.min(), ends.max()) == pytest.approx((-0.4 / 3, 0.8 / 3))
    assert reach(bell) == pytest.approx(0.8 / 3 + 0.06)
