"""What is drawn of a motion: scenes, animations and curves."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from scipy import interpolate

import freebody as fb
from freebody.errors import InputError
from freebody.model.glyphs import Equation, Lead
from freebody.narrative.telling.catalogue import Catalogue
from freebody.numeric.reference import Reference
from freebody.present import video
from freebody.present.animation import film_of, resampled, write_animation
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, Heading, Node, Place, Rope, hull, positions
from freebody.present.guides import Guides
from freebody.present.layout import Layout, headings, sweep
from freebody.present.picture.label import equation
from freebody.present.plots import plot, save
from freebody.present.recording import Recording, Series
from freebody.present.scene import Scene
from freebody.present.stage import Stage, show_of_plane
from freebody.present.strokes import Path as Outline
from freebody.present.strokes import Strand, Stretch
from freebody.system.system import System

EXAMPLES = [
    p
    for p in sorted((Path(__file__).parents[1] / "examples").glob("*.yaml"))
    if "\nspace:" not in p.read_text(encoding="utf-8")
]


def posed(text: str | Path) -> tuple[Scene, Array]:
    """The scene of a model and its start (1, n_bodies, 3)."""
    system = System.load(text) if isinstance(text, Path) else System.from_text(text)
    reference = Reference(system)
    q = reference.assemble()
    return Scene.of(system, reference.number), np.array([[reference.pose(q, body.name) for body in system.moving]])


def motion(text: str, until: float) -> tuple[Scene, Array, Array]:
    """The scene of a model, the times and the poses of its motion."""
    system = System.from_text(text)
    reference = Reference(system)
    q = reference.assemble()
    found = reference.integrate((q, reference.velocities(q)), until)
    poses = [[reference.pose(s.q, body.name) for body in system.moving] for s in found.snapshots]
    return Scene.of(system, reference.number), found.times, np.array(poses)


def example(name: str) -> tuple[Scene, Array]:
    return posed(next(path for path in EXAMPLES if path.stem == name))


def styles(drawing: Drawing) -> list[str]:
    return [stroke.style for stroke in drawing.strokes]


def lines(drawing: Drawing, style: str, frame: int = 0) -> list[Array]:
    """Ground points (n, 2) of the strokes of one style."""
    return [drawing.points(stroke, frame) for stroke in drawing.strokes if stroke.style == style]


def height_over(line: Array, point: Array) -> float:
    """Distance of a point from a line, positive above it."""
    a, b = line[0], line[-1]
    x, y = (b - a) / np.hypot(*(b - a)) * np.sign(b[0] - a[0])
    return float(x * (point - a)[1] - y * (point - a)[0])


# -- scenes -----------------------------------------------------------------------------------
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_body_of_every_example_is_drawn_inside_its_picture(path: Path) -> None:
    scene, poses = posed(path)
    drawing = Drawing.of(scene, poses)
    drawn = {stroke.color for stroke in drawing.strokes if isinstance(stroke, Outline)}
    assert drawn - {-1} == {figure.number for figure in scene.figures}
    points = np.concatenate([drawing.points(stroke, 0) for stroke in drawing.strokes])
    assert np.isfinite(points).all()
    assert (points >= drawing.low).all()
    assert (points <= drawing.high).all()
    said = {equation(sign.text).text for sign in scene.signs if isinstance(sign, Equation)}
    assert {word.text for word in drawing.words} == said


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_pinned_points_and_the_ends_of_links_meet_in_the_picture(path: Path) -> None:
    if any(blow.closing for blow in fb.System.load(path).blows):
        pytest.skip("what closes in mid-motion is apart before")
    scene, poses = posed(path)
    drawing = Drawing.of(scene, poses)
    for first, second in scene.pins:
        a, b = (positions(drawing.poses, place)[0] for place in (first, second))
        assert np.abs(a - b).max() < 1e-6


def test_a_rod_is_a_capsule_and_a_plate_the_hull_of_its_points() -> None:
    four_bar, _ = example("four_bar")
    platform, _ = example("multi_bar_platform")
    crank, plate = four_bar.figures[0], next(f for f in platform.figures if f.name == "B1")
    assert crank.outline == pytest.approx(np.array([(-0.1, 0.0), (0.1, 0.0)]))
    assert len(plate.outline) == 4


def test_the_hull_is_convex_and_runs_counter_clockwise_round_all_points() -> None:
    points = np.random.default_rng(seed=3).normal(size=(60, 2))
    corners = hull(points)
    sides = np.roll(corners, -1, axis=0) - corners
    for point in points:
        away = point - corners
        assert (sides[:, 0] * away[:, 1] - sides[:, 1] * away[:, 0] > -1e-6).all()
    assert hull(np.array([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)])) == pytest.approx(np.array([(0.0, 0.0), (2.0, 2.0)]))


def test_a_spoke_shows_that_a_wheel_turns() -> None:
    scene, _ = example("disk_rolling_down_incline")
    drawing = Drawing.of(scene, np.array([[(0.0, 0.2, 0.0)], [(0.2, 0.2, np.pi / 2)]]))
    (before,), (after,) = lines(drawing, "spoke", 0), lines(drawing, "spoke", 1)
    assert before[-1] - before[0] == pytest.approx((0.2, 0.0))
    assert after[-1] - after[0] == pytest.approx((0.0, 0.2))


def test_a_disk_touches_the_surface_it_rolls_on_all_the_way() -> None:
    scene, times, poses = motion(EXAMPLES_TEXT["incline"], 1.0)
    drawing = Drawing.of(scene, poses)
    for frame in range(len(times)):
        (surface,) = lines(drawing, "surface", frame)
        assert height_over(surface, drawing.poses[frame, 0, :2]) == pytest.approx(0.2)


def test_two_wheels_on_one_road_have_one_line_under_both() -> None:
    text = """
ground: {lines: {road: {along: 10 deg}}}
bodies:
  car: {rectangle: {mass: 1 kg, width: 4 m, height: 1 m}, points: {R: [-1.2 m, 0], F: [1.3 m, 0]}}
  rear: {disk: {radius: 0.3 m}}
  front: {disk: {radius: 0.3 m}}
connections:
  one: {pin: [car.R, rear]}
  two: {pin: [car.F, front]}
  rolls: {rolling: {body: rear, on: road}}
  also: {rolling: {body: front, on: road}}
"""
    scene, poses = posed(text)
    drawing = Drawing.of(scene, poses)
    (road,) = lines(drawing, "surface")
    for wheel in ("rear", "front"):
        center = poses[0, scene.names.index(wheel), :2]
        assert height_over(road, center) == pytest.approx(0.3, abs=1e-9)
        share = float((center - road[0]) @ (road[-1] - road[0])) / float(np.sum((road[-1] - road[0]) ** 2))
        assert 0.1 < share < 0.9


@pytest.mark.parametrize("name", ["cam_with_roller", "cam_with_flat_follower"])
def test_the_guide_of_a_follower_ends_before_the_axle_of_its_cam(name: str) -> None:
    drawing = Drawing.of(*example(name))
    (guide,) = (line for line in lines(drawing, "surface") if len(line) == 2 and np.ptp(line[:, 0]) < 1e-9)
    assert float(guide[:, 1].min()) > 0.015  # the axle is at the origin, the base circles have 30 mm and 40 mm


def test_a_cart_stands_on_ground_that_is_hatched_below() -> None:
    scene, poses = example("cart_and_pendulum")
    drawing = Drawing.of(scene, poses)
    (surface,), (hatch,) = lines(drawing, "surface"), lines(drawing, "hatch")
    assert surface[:, 1] == pytest.approx(-0.1)
    assert hatch[:, 1].max() == pytest.approx(-0.1)
    assert hatch[:, 1].min() < -0.1


EXAMPLES_TEXT = {
    "incline": """
ground: {lines: {slope: {along: -0.4}}}
bodies: {disk: {disk: {mass: 2 kg, radius: 0.2 m}}}
connections: {contact: {rolling: {body: disk, on: slope}}}
loads: {weight: {gravity: 9.81 m/s^2}}
""",
    "swinging": """
ground: {points: {A: [-1 m, 0], B: [1 m, 0]}}
bodies:
  left: {disk: {mass: 1 kg, radius: 0.2 m}}
  right: {disk: {mass: 1 kg, radius: 0.3 m}}
  a: {particle: {mass: 1 kg}, at: [-1.4 m, -1 m]}
  b: {particle: {mass: 1 kg}, at: [2 m, -1 m]}
connections:
  p: {pin: [ground.A, left]}
  q: {pin: [ground.B, right]}
  rope: {string: {path: [a, over left, over right, b], grips: [], swings: true}}
loads: {weight: {gravity: 9.81 m/s^2}}
""",
    "joints": """
parameters: {s: 1 m, v: 1 m/s}
ground: {points: {A: [0, 0], B: [1 m, 0]}}
bodies:
  beam: {rod: {mass: 1 kg, length: 1 m}}
  arm: {rod: {mass: 1 kg, length: 1 m}, angle: 90 deg}
  bead: {particle: {mass: 1 kg}}
  cam: {particle: {mass: 1 kg}}
connections:
  wall: {weld: [ground.A, beam.start]}
  hinge: {pin: [beam.end, arm.start]}
  runs: {slider: {body: bead, on: arm, along: arm.x}}
  rail: {slider: {body: cam, along: right}}
  moves: {driver: {measure: {x of cam}, follows: s + v*t}}
loads:
  spring: {spring: {first: ground.A, second: arm.end, stiffness: 5 N/m, length: 0.3 m}}
  damper: {damper: {first: ground.A, second: arm.end, damping: 5 N s/m}}
""",
}


def test_the_triangle_of_a_support_hangs_above_what_hangs_and_stands_below_what_stands() -> None:
    pendulum = Drawing.of(*example("simple_pendulum"))
    linkage = Drawing.of(*example("four_bar"))
    (above,) = lines(pendulum, "support")
    below = lines(linkage, "support")
    assert above[:, 1].min() == pytest.approx(0.0)
    assert len(below) == 2
    assert all(triangle[:, 1].max() == pytest.approx(0.0) for triangle in below)


def test_a_weld_a_rail_on_a_body_and_parallel_spring_and_damper_are_drawn() -> None:
    scene, poses = posed(EXAMPLES_TEXT["joints"])
    drawing = Drawing.of(scene, poses)
    assert (len(scene.welds), len(scene.pins)) == (1, 1)
    assert [rail.along.body for rail in scene.rails] == [1, GROUND]  # and the driver guides nothing
    springs = [stroke for stroke in drawing.strokes if isinstance(stroke, Stretch)]
    end = positions(drawing.poses, scene.springs[0].second)[0]
    ends = [p for s in springs for p in (drawing.points(s, 0)[0], drawing.points(s, 0)[-1])]
    assert min(float(np.hypot(*(p - end))) for p in ends) < 1e-9
    left = [s.points[:, 1].mean() for s in springs if len(s.points) > 8]
    right = [s.points[:, 1].mean() for s in springs if len(s.points) == 4]
    assert left[0] < -drawing.symbol / 2 < drawing.symbol / 2 < right[0]


def test_a_ring_is_hollow_and_a_disk_is_not() -> None:
    bowl, _ = example("ball_in_bowl")
    gear, _ = example("planetary_gear")
    assert [f.name for scene in (bowl, gear) for f in scene.figures if f.is_hollow] == ["bowl", "ring"]


def test_a_drum_with_a_hub_shows_both_circles() -> None:
    scene, poses = posed("""
bodies: {spool: {disk: {mass: 1 kg, radius: 0.3 m}}}
connections: {rope: {string: {from: ground.A, to: wound on spool radius 0.1 m at right}}}
""")
    assert scene.figures[0].hubs == pytest.approx((0.1,))
    rims = [np.ptp(rim, axis=0)[0] for rim in lines(Drawing.of(scene, poses), "rim")]
    assert rims == pytest.approx([0.2])


def test_a_massless_link_is_a_line_between_its_points_and_gears_have_none() -> None:
    scene, poses = example("double_pendulum")
    drawing = Drawing.of(scene, poses)
    (upper, lower) = lines(drawing, "link")
    assert upper == pytest.approx(np.array([(0.0, 0.0), poses[0, 0, :2]]))
    assert lower == pytest.approx(poses[0, :, :2])
    assert "link" not in styles(Drawing.of(*example("planetary_gear")))


def test_measures_without_a_sign_are_left_out() -> None:
    scene, poses = posed("""
parameters: {k: 3 N/m}
bodies: {bead: {particle: {mass: 1 kg}}}
measures: {x: x of bead, y: y of bead}
connections: {it: {constraint: x - 2*y}, skate: {velocity_constraint: rate(x) - rate(y)}}
loads: {pull: {law: {measure: x, force: k*x}}}
""")
    assert styles(Drawing.of(scene, poses)) == ["dot"]


# -- strings ----------------------------------------------------------------------------------
def test_a_drawn_string_keeps_its_length_while_everything_swings() -> None:
    scene, times, poses = motion(EXAMPLES_TEXT["swinging"], 0.8)
    drawing = Drawing.of(scene, poses)
    assert np.ptp(poses[:, 2:, 0], axis=0).min() > 0.05  # it does swing
    (strand,) = [stroke for stroke in drawing.strokes if isinstance(stroke, Strand)]
    lengths = []
    for frame in range(len(times)):
        sides = np.diff(drawing.points(strand, frame), axis=0)
        lengths.append(np.hypot(sides[:, 0], sides[:, 1]).sum())
    assert np.ptp(lengths) < 2e-3
    assert drawing.moved == ()


@pytest.mark.parametrize("arms", [(0.3, 0.5), (0.3, -0.5), (-0.2, 0.4), (0.0, 0.5), (-0.3, 0.0)])
def test_a_lead_touches_both_circles_and_runs_at_right_angles_to_their_radii(arms: tuple[float, float]) -> None:
    a, b = Place(GROUND, 0.2, -0.1), Place(GROUND, 1.9, 0.8)
    rope = Rope((Node(a, arms[0]), Node(b, arms[1])), (Lead(None),))
    angle = float(headings(rope, np.zeros((1, 0, 3)))[0, 0])
    normal = np.array((-np.sin(angle), np.cos(angle)))
    start, end = np.array(a.xy) - arms[0] * normal, np.array(b.xy) - arms[1] * normal
    assert (end - start) @ normal == pytest.approx(0.0, abs=1e-12)
    assert (end - start) @ (np.cos(angle), np.sin(angle)) > 0


def test_a_string_runs_round_a_pulley_in_the_sense_of_its_arm() -> None:
    up, down = np.pi / 2, -np.pi / 2
    assert float(sweep(-0.1, up, down)) == pytest.approx(-np.pi)
    assert float(sweep(0.1, down, up)) == pytest.approx(np.pi)
    assert float(sweep(0.1, 0.0, -0.01)) == 0.0


def test_weights_hang_straight_below_the_rim_of_their_pulley() -> None:
    scene, poses = example("atwood_machine")
    drawing = Drawing.of(scene, poses)
    assert drawing.moved == ("left", "right")
    assert drawing.poses[0, 1:, 0] == pytest.approx([-0.1, 0.1])
    assert (drawing.poses[0, 1:, 1] < -0.1).all()
    (string,) = lines(drawing, "string")
    assert string[0] == pytest.approx(drawing.poses[0, 1, :2])
    assert string[-1] == pytest.approx(drawing.poses[0, 2, :2])
    assert string[:, 1].max() == pytest.approx(0.1, abs=1e-3)


def test_pulleys_that_hang_on_strings_carry_their_weights_with_them() -> None:
    scene, poses = example("compound_atwood")
    drawing = Drawing.of(scene, poses)
    lower, a, b, c = (drawing.poses[0, scene.names.index(name), 0] for name in ("lower", "A", "B", "C"))
    assert (a, lower) == pytest.approx((-0.1, 0.1))
    assert (b, c) == pytest.approx((0.05, 0.15))


def test_a_block_on_an_incline_is_drawn_where_its_string_runs_along_the_incline() -> None:
    scene, poses = example("incline_with_pulley")
    drawing = Drawing.of(scene, poses)
    (string,) = lines(drawing, "string")
    surface = lines(drawing, "surface")[0]
    assert height_over(surface, string[0]) == pytest.approx(height_over(surface, string[1]))
    assert height_over(surface, string[0]) > 0


def test_round_off_of_a_particle_at_rest_is_no_size_of_its_picture() -> None:
    scene, poses = example("block_pushed_on_incline")
    way = np.repeat(poses, 3, axis=0)
    assert Layout.of(scene, way + 1e-15 * np.arange(3.0)[:, None, None]).symbol == Layout.of(scene, way).symbol


def test_bodies_are_moved_by_the_same_amount_at_all_times() -> None:
    scene, poses = example("atwood_machine")
    way = np.repeat(poses, 5, axis=0)
    way[:, 1, 1] -= np.linspace(0.0, 1.0, 5)
    way[:, 2, 1] += np.linspace(0.0, 1.0, 5)
    shifts = Layout.of(scene, way).poses - way
    assert np.ptp(shifts, axis=0).max() < 1e-12
    assert (Layout.of(scene, way).poses[:, 1:, 1] < -0.1).all()


@pytest.mark.parametrize(("crossed", "sides"), [(False, 1), (True, -1)])
def test_an_open_belt_runs_on_one_side_of_both_pulleys_and_a_crossed_one_changes_sides(
    crossed: bool, sides: int
) -> None:
    scene, poses = posed(f"""
ground: {{points: {{A: [0, 0], B: [1 m, 0]}}}}
bodies: {{a: {{disk: {{mass: 1 kg, radius: 0.1 m}}}}, b: {{disk: {{mass: 1 kg, radius: 0.2 m}}}}}}
connections: {{p: {{pin: [ground.A, a]}}, q: {{pin: [ground.B, b]}},
  belt: {{belt: {{first: a, second: b, crossed: {str(crossed).lower()}}}}}}}
""")
    (belt,) = Layout.of(scene, poses).ropes
    first, second, last = belt.nodes
    assert belt.is_closed
    assert first == last
    assert (abs(first.arm), second.arm / first.arm) == pytest.approx((0.1, sides * 2.0))


def test_gears_that_mesh_have_no_belt_round_them() -> None:
    assert Layout.of(*example("planetary_gear")).ropes == ()


def test_a_rack_is_drawn_with_its_edge_at_the_pinion() -> None:
    scene, poses = example("rack_and_pinion_drive")
    rack = Layout.of(scene, poses).poses[0, 1]
    assert rack[1] + 0.025 == pytest.approx(-0.05)


@pytest.mark.parametrize("alpha", [0.0, 0.4])
def test_a_tooth_of_the_pinion_stands_in_a_gap_of_the_rack_and_both_have_one_pitch(alpha: float) -> None:
    scene, poses = posed(f"""
bodies:
  pinion: {{body: {{inertia: 0.02 kg m^2, radius: 0.05 m}}}}
  rack: {{rectangle: {{mass: 5 kg, width: 0.4 m, height: 0.03 m}}, angle: {alpha} rad}}
connections:
  axle: {{pin: [ground.O, pinion]}}
  guide: {{slider: {{body: rack, along: {alpha} rad}}}}
  teeth: {{rack_and_pinion: {{pinion: pinion, rack: rack}}}}
""")
    guides = Guides(scene, Layout.of(scene, poses).poses, 0.01)
    pinion, rack = (next(f for f in scene.figures if f.name == name) for name in ("pinion", "rack"))
    wheel = guides.edge(pinion, 0.05)
    down = np.array((np.sin(alpha), -np.cos(alpha)))
    tip = wheel[(wheel @ down) > 0.05 * 0.98].mean(axis=0)
    assert tip / np.hypot(*tip) == pytest.approx(down, abs=1e-9)
    (teeth,) = (stroke for stroke in guides.strokes() if isinstance(stroke, Outline) and stroke.color == rack.number)
    feet = teeth.points[(teeth.points[:, 1] < 1e-9)][1:-1, 0]  # of the teeth, along the rack
    along = float(-guides.poses[0, rack.index, :2] @ (np.cos(alpha), np.sin(alpha)))  # the pinion is at the origin
    pitch = 2 * np.pi * 0.05 / (len(wheel) / 4)
    assert np.diff(feet[::2]) == pytest.approx(pitch)
    nearest = float(np.abs(feet - along).min())
    assert nearest == pytest.approx(0.16 * pitch, rel=1e-6)  # half of a gap


def test_the_direction_of_a_lead_fixed_in_a_body_turns_with_it() -> None:
    node = Node(Place(0, 0.0, 0.0), 0.0)
    rope = Rope((node, node), (Lead(Heading(0, 0.0, 1.0)),))
    assert headings(rope, np.array([[(0.0, 0.0, 0.3)]]))[0, 0] == pytest.approx(0.3 + np.pi / 2)


# -- stills and animations --------------------------------------------------------------------
@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_names_of_a_film_stand_on_its_paper_and_not_on_each_other(path: Path) -> None:
    scene, poses = posed(path)
    stage = Stage.of(show_of_plane(Drawing.of(scene, poses)), 6.4, title="a film")
    texts = {text.get_text(): text for text in stage.paint(0) if hasattr(text, "get_text")}
    called = [figure.name for figure in scene.figures]
    assert {*called, "x", "y", "+"} <= set(texts)
    stage.figure.canvas.draw()
    boxes = [texts[name].get_window_extent() for name in called]
    low, high = np.zeros(2), 100.0 * stage.figure.get_size_inches()
    for k, box in enumerate(boxes):
        assert (box.min >= low).all()
        assert (box.max <= high).all()
        assert not any(box.overlaps(other) for other in boxes[k + 1 :])


def test_a_film_is_told_in_its_language() -> None:
    scene, poses = posed(EXAMPLES[0])
    poses = np.concatenate([poses[:1], poses[:1]])
    film = film_of(scene, np.array([0.0, 0.5]), poses, title="ein Film")
    figure, stages = replace(film, tell=Catalogue("de").said).stages(2)
    told: list[str] = []
    for _ in stages:
        told = [text.get_text() for text in (*figure.texts, *figure.axes[0].texts)]
    assert "t = 0,50 s" in told
    (note,) = (text for text in told if text.startswith("Achsen"))
    assert re.fullmatch(r"Achsen \d+(,\d+)? m lang", note)


def test_resampling_goes_through_the_given_poses_and_never_beyond_them() -> None:
    times = np.array([0.0, 0.3, 0.5, 1.0])
    poses = np.array([1.0, 0.0, 0.0, 0.5]).reshape(4, 1, 1) * np.ones((4, 2, 3))
    shown, frames = resampled(times, poses, 101)
    assert np.diff(shown) == pytest.approx(0.01)
    assert frames[[0, 30, 50, 100]] == pytest.approx(poses)
    assert frames.min() >= 0.0


def test_a_motion_that_is_looked_at_where_it_is_given_is_not_changed() -> None:
    """Also with further times between, as events have: the curve goes through what is given."""
    rng = np.random.default_rng(7)
    times = np.union1d(np.linspace(0.0, 2.7, 28), [0.33, 1.234])
    poses = rng.normal(size=(len(times), 2, 3))
    shown, frames = resampled(times, poses, 28)
    assert np.array_equal(frames, poses[np.isin(times, shown)])
    curved = interpolate.PchipInterpolator(times, poses)(shown)
    assert frames == pytest.approx(curved, rel=1e-12, abs=1e-12)


def page_data(text: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="data">([^<>]*)</script>', text)
    assert found is not None
    return json.loads(found[1])


def swinging_page(tmp_path: Path, **options: Any) -> str:
    scene, times, poses = motion(EXAMPLES_TEXT["swinging"], 0.3)
    path = write_animation(scene, times, poses, tmp_path / "page.html", **({"title": "A page"} | options))
    return path.read_text(encoding="utf-8")


def test_a_page_holds_the_motion_to_five_digits(tmp_path: Path) -> None:
    scene, times, poses = motion(EXAMPLES_TEXT["incline"], 0.5)
    path = write_animation(scene, times, poses, tmp_path / "page.html", title="Rolling")
    data = page_data(path.read_text(encoding="utf-8"))
    shown = data["t0"] + data["dt"] * np.arange(data["n_frames"])
    assert (shown[0], shown[-1]) == pytest.approx((times[0], times[-1]))
    size = max(np.subtract(data["bounds"][2:], data["bounds"][:2]))
    assert len(data["columns"]) == 3
    for k, column in enumerate(data["columns"]):
        assert len(column) == data["n_frames"]
        assert column[-1] == pytest.approx(poses[-1, 0, k], abs=1e-5 * size if k < 2 else 1e-4)


def test_a_page_needs_nothing_from_elsewhere(tmp_path: Path) -> None:
    text = swinging_page(tmp_path)
    assert "default-src 'none'" in text
    assert not re.search(r"https?:|//cdn|\bsrc=|\bhref=|@import|url\(|fetch\(|XMLHttp", text)
    assert len(text) < 200_000


def test_everything_that_the_script_of_a_page_asks_for_is_on_the_page(tmp_path: Path) -> None:
    text = swinging_page(tmp_path)
    data = page_data(text)
    asked = set(re.findall(r'(?:byId|getElementById)\("(\w+)"\)', text))
    assert asked == set(re.findall(r'\bid="(\w+)"', text)) - {"stage"}
    assert {stroke["shape"] for stroke in data["strokes"]} <= set(re.findall(r"^  (\w+)\(stroke, f\)", text, re.M))
    assert {stroke["style"] for stroke in data["strokes"]} <= set(data["styles"])
    assert {key for style in data["styles"].values() for key in (style["stroke"], style["fill"])} <= {
        *data["themes"]["dark"],
        "body",
        "",
    }
    for control in ('aria-label="Time"', 'role="img"', "prefers-color-scheme", "prefers-reduced-motion", "ArrowLeft"):
        assert control in text


@pytest.mark.skipif(shutil.which("node") is None, reason="no node to run the script of the page")
@pytest.mark.parametrize("name", ["belt_drive", "hoist", "stick_slip_oscillator", "two_masses_three_springs"])
def test_the_script_draws_strokes_where_the_picture_has_them(name: str, tmp_path: Path) -> None:
    scene, poses = example(name)
    path = write_animation(scene, np.array([0.0]), poses, tmp_path / "a.html", title=name)
    text = path.read_text(encoding="utf-8")
    script = text[text.index("// -- places at a frame") : text.index("// -- drawing")]
    code = f"""
const data = {json.dumps(page_data(text))}, last = data.n_frames - 1;
{script}
look(...data.angles);
console.log(JSON.stringify(data.strokes.map((stroke) => flat(stroke, 0).points)));
"""
    (tmp_path / "a.js").write_text(code, encoding="utf-8")
    printed = subprocess.run(["node", str(tmp_path / "a.js")], check=True, capture_output=True, text=True).stdout
    drawing = Drawing.of(scene, poses)
    size = float((drawing.high - drawing.low).max())
    for stroke, found in zip(drawing.strokes, json.loads(printed), strict=True):
        points, seen = drawing.points(stroke, 0), np.array(found)
        assert seen[:, 2] == pytest.approx(0.0, abs=1e-12)
        if isinstance(stroke, Strand):  # the script takes other points of its arcs
            points, seen = points[[0, -1]], seen[[0, -1]]
        assert seen[:, :2] == pytest.approx(points, abs=1e-4 * size)


def test_titles_and_names_cannot_break_out_of_a_page(tmp_path: Path) -> None:
    title = """</script><script>alert("1 & 2")</script> {{data}} '"""
    text = swinging_page(tmp_path, title=title)
    assert "<script>alert" not in text
    assert "&lt;/script&gt;&lt;script&gt;alert(&quot;1 &amp; 2&quot;)&lt;/script&gt; {{data}}" in text
    assert text.count("</script>") == 2
    assert page_data(text)["n_frames"] > 1


def test_no_name_can_end_the_data_of_a_page(tmp_path: Path) -> None:
    scene, poses = example("simple_pendulum")
    named = replace(scene, names=("</script>",), figures=(replace(scene.figures[0], name="<!--</script>"),))
    path = write_animation(named, np.array([0.0]), poses, tmp_path / "a.html", title="x")
    data = page_data(path.read_text(encoding="utf-8"))
    assert data["names"] == ["</script>"]
    assert data["labels"][0]["text"] == "<!--</script>"


def test_a_page_says_which_bodies_are_drawn_aside(tmp_path: Path) -> None:
    scene, poses = example("atwood_machine")
    path = write_animation(scene, np.array([0.0]), poses, tmp_path / "one.html", title="Start")
    text = path.read_text(encoding="utf-8")
    assert "Drawn aside by a constant amount, because the model does not say where: left, right." in text
    assert page_data(text)["n_frames"] == 1


def test_a_gif_shows_half_a_second_at_half_speed_for_one_second(tmp_path: Path) -> None:
    scene, poses = example("four_bar")
    way = np.repeat(poses, 2, axis=0)
    way[1, 0, 0] += 0.1  # some motion, so that no two frames are the same
    path = write_animation(scene, np.array([0.0, 0.5]), way, tmp_path / "a.gif", title="$x$", speed=0.5)
    with Image.open(path) as gif:
        assert gif.n_frames == 26  # type: ignore[attr-defined]
        assert gif.info["duration"] == 40
        assert min(gif.size) > 200


def test_an_mp4_without_ffmpeg_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(video.shutil, "which", lambda _name: None)
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    scene, poses = example("four_bar")
    assert not video.has_ffmpeg()
    with pytest.raises(InputError, match=re.escape('pip install "freebody[video]"')):
        write_animation(scene, np.array([0.0]), poses, tmp_path / "a.mp4", title="x")


def test_an_mp4_is_written_where_there_is_an_ffmpeg(tmp_path: Path) -> None:
    try:
        video.ffmpeg()
    except InputError:
        pytest.skip("no ffmpeg here")
    scene, poses = example("four_bar")
    times = np.array([0.0, 0.2])
    path = write_animation(scene, times, np.repeat(poses, 2, axis=0), tmp_path / "a.mp4", title="x")
    assert path.read_bytes()[4:8] == b"ftyp"


@pytest.mark.parametrize(
    ("name", "change", "message"),
    [
        ("a.avi", {}, "a.avi: an animation is written as .html, .gif, .mp4"),
        ("no/such/folder.html", {}, "folder.html cannot be written: No such file or directory"),
        ("a.html", {"speed": 0.0}, "positive number"),
        ("a.html", {"times": np.array([0.0, 1.0, 0.5])}, "ascend"),
        ("a.html", {"times": np.array([0.0, np.nan, 2.0])}, "finite"),
        ("a.html", {"times": np.array([0.0, 1.0])}, "3 moving bodies"),
        ("a.html", {"times": np.array([]), "poses": np.zeros((0, 3, 3))}, "3 moving bodies"),
    ],
)
def test_an_animation_that_cannot_be_written_says_why(
    tmp_path: Path, name: str, change: dict[str, Any], message: str
) -> None:
    scene, poses = example("four_bar")
    given: dict[str, Any] = {"times": np.arange(3.0), "poses": np.repeat(poses, 3, axis=0), "title": "x"} | change
    with pytest.raises(InputError, match=re.escape(message)):
        write_animation(scene, path=tmp_path / name, **given)


def test_of_a_repeated_time_the_last_pose_is_shown(tmp_path: Path) -> None:
    scene, poses = example("simple_pendulum")
    way = np.repeat(poses, 3, axis=0)
    way[:, 0, 0] = [0.0, 0.2, 0.4]
    path = write_animation(scene, np.array([0.0, 1.0, 1.0]), way, tmp_path / "a.html", title="x")
    column = page_data(path.read_text(encoding="utf-8"))["columns"][0]
    assert column == pytest.approx(np.linspace(0.0, 0.4, len(column)), abs=1e-4)


# -- curves -----------------------------------------------------------------------------------
def recording(measures: list[str]) -> Recording:
    """Two bodies, a measure and a reaction over one second."""
    t = np.linspace(0.0, 1.0, 11)

    def of(dimensions: tuple[str, ...], values: Array, units: str, words: str) -> Series:
        return Series(dimensions, values, {"units": units, "long_name": words})

    return Recording(
        t,
        {
            "body_position": of(
                ("time", "body", "axis"), np.arange(44.0).reshape(11, 2, 2), "m", "position of the mass centre"
            ),
            "body_angle": of(("time", "body"), np.stack([t, -t], axis=1), "rad", "angle"),
            "theta": of(("time",), np.sin(t), "rad", "angle of crank"),
            "theta_rate": of(("time",), np.cos(t), "rad/s", "rate of theta"),
            "main.x": of(("time",), 5 * t, "N", "x force of main on crank"),
        },
        {"body": ["crank", "rod"], "axis": ["x", "y"]},
        {"measures": measures},
    )


def panels(figure: Any) -> dict[str, list[str]]:
    """The labels of the curves by the label of their panel."""
    return {axes.get_ylabel(): [text.get_text() for text in axes.get_legend().get_texts()] for axes in figure.axes}


def test_curves_of_one_unit_share_a_panel() -> None:
    figure = plot(recording([]), ["theta", "crank.angle", "main.x", "rod.y"])
    assert panels(figure) == {
        "[rad]": ["theta: angle of crank", "crank.angle"],
        "x force of main on crank [N]": ["main.x: x force of main on crank"],
        "rod.y [m]": ["rod.y"],
    }


def test_a_component_of_a_body_is_taken_from_its_body_and_axis() -> None:
    figure: Any = plot(recording([]), ["rod.y"])
    assert figure.axes[0].lines[0].get_ydata() == pytest.approx(np.arange(3.0, 44.0, 4.0))


def test_a_variable_of_all_bodies_makes_one_curve_for_each() -> None:
    assert panels(plot(recording([]), ["body_position"])) == {"[m]": ["crank.x", "rod.x", "crank.y", "rod.y"]}


def test_without_names_the_measures_are_shown_or_else_all_bodies() -> None:
    assert panels(plot(recording(["theta"]))) == {"angle of crank [rad]": ["theta: angle of crank"]}
    assert panels(plot(recording([]))) == {
        "[rad]": ["crank.angle", "rod.angle"],
        "[m]": ["crank.x", "rod.x", "crank.y", "rod.y"],
    }


def test_events_are_lines_through_all_panels_with_their_names_above() -> None:
    figure: Any = plot(recording([]), ["theta", "main.x"], events=[("slip", 0.25), ("impact", 0.5)])
    for axes in figure.axes:
        assert [line.get_xdata()[0] for line in axes.lines[1:]] == [0.25, 0.5]
    assert [text.get_text() for text in figure.axes[0].texts] == ["slip", "impact"]


def test_all_misspelt_names_are_told_at_once() -> None:
    with pytest.raises(InputError) as told:
        plot(recording([]), ["thta", "crank.angel", "theta"])
    assert "there is no curve thta. Did you mean theta?" in str(told.value)
    assert "there is no curve crank.angel. Did you mean crank.angle?" in str(told.value)


def test_curves_are_told_apart_by_colour_and_by_dashes_on_both_papers() -> None:
    for dark in (False, True):
        figure: Any = plot(recording([]), ["body_position"], dark=dark)
        drawn = figure.axes[0].lines
        assert len({line.get_color() for line in drawn}) == 4
        assert len({str(line._dash_pattern) for line in drawn}) == 4
        paper = np.mean(figure.get_facecolor()[:3])
        assert paper < 0.2 if dark else paper > 0.8


@pytest.mark.parametrize(("suffix", "start"), [(".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")])
def test_a_plot_is_written_by_its_suffix(tmp_path: Path, suffix: str, start: bytes) -> None:
    path = save(plot(recording(["theta"])), tmp_path / f"curves{suffix}")
    assert path.read_bytes().startswith(start)


@pytest.mark.parametrize(("name", "message"), [("a.docx", ".png, .svg, .pdf"), ("no/a.png", "cannot be written")])
def test_a_plot_that_cannot_be_written_says_why(tmp_path: Path, name: str, message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)):
        save(plot(recording(["theta"])), tmp_path / name)


def test_names_with_dollar_signs_are_no_mathematics(tmp_path: Path) -> None:
    data = recording(["theta"])
    theta = replace(data.series["theta"], attributes={"units": "rad", "long_name": r"$\frac{ costs $5"})
    data = replace(data, series={**data.series, "theta": theta})
    save(plot(data, events=[("$x_", 0.5)]), tmp_path / "a.png")


def test_pictures_do_without_pyplot_and_importing_them_without_matplotlib(tmp_path: Path) -> None:
    code = """
import sys
import numpy as np
from freebody.present import animation, plots
from freebody.present.scene import Scene
assert "matplotlib" not in sys.modules
animation.write_animation(Scene("", (), (), ()), np.zeros(1), np.zeros((1, 0, 3)), sys.argv[1], title="nothing")
assert "matplotlib.figure" in sys.modules
assert "matplotlib.pyplot" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", code, str(tmp_path / "a.gif")], check=True)


def test_a_cam_is_a_filled_body_as_large_as_its_edge_with_a_hub_about_its_pin() -> None:
    """Its edge is r = 40 mm from the pin where it does not lift, and r + h = 60 mm where it lifts most."""
    drawn = fb.System.load(Path(__file__).parents[1] / "examples" / "cam_with_roller.yaml").picture()
    own = [s for s in drawn.shapes if s.fill is not None and s.fill.body == 0 and s.is_closed]
    (edge,) = [s for s in own if float(np.ptp(s.points[:, 0])) > 100.0]
    hub = [s for s in drawn.shapes if s.stroke is not None and s.stroke.body == 0 and s.fill is None and s.is_closed]
    assert len(hub) == 1
    pin = hub[0].points[:-1].mean(axis=0)
    away = np.hypot(*(edge.points - pin).T)
    assert away.max() / away.min() == pytest.approx(60.0 / 40.0, rel=1e-2)
    assert np.hypot(*(hub[0].points - pin).T).max() < 0.5 * away.min()


VEHICLE = """
parameters: {{m: 1 kg, a: 1 m, b: 2 m, h: 0.5 m, g: 9.81 m/s^2}}
bodies: {{car: {{rectangle: {{mass: m, width: 4 m, height: 0.8 m}}, points: {{rear: [-b, {at}], front: [a, {at}]}}}}}}
connections:
  rear: {{slot: {{pin: car.rear, along: {along}}}}}
  front: {{slot: {{pin: car.front, along: {along}}}}}
loads: {{weight: {{gravity: g}}}}
"""
WHEELS = "drawing: {wheels: {car.rear: 0.3 m, car.front: 0.3 m}}"


@pytest.mark.parametrize("along", ["right", "left"])
def test_wheels_that_a_model_states_touch_the_road_at_their_points_in_place_of_slots(along: str) -> None:
    system = fb.System.from_text(VEHICLE.format(at="-h", along=along) + WHEELS)
    scene = Scene.of(system, Reference(system).number)
    assert not scene.rails
    for roller, (x, y) in zip(scene.rollers, ((-2.0, -0.5), (1.0, -0.5)), strict=True):
        assert (roller.center.x, roller.center.y - roller.radius) == pytest.approx((x, y))
    for track in scene.tracks:  # the road is straight below: the wheel on the left of its direction, or on its right
        assert track.radius * track.along.x == pytest.approx(0.3)
    looks = [stroke.style for stroke in Drawing.of(scene, np.zeros((1, 1, 3))).strokes]
    assert looks.count("roller") == 2
    assert "slot" not in looks


def test_slots_of_the_ground_are_no_wheels_unless_the_model_says_so() -> None:
    system = fb.System.from_text(VEHICLE.format(at="-h", along="right"))
    scene = Scene.of(system, Reference(system).number)
    assert len(scene.rails) == 2
    assert not scene.rollers


def test_wheels_stand_on_the_line_that_their_points_touch() -> None:
    """On a slope the road of a car is that of its contacts: a wheel touches it, its centre a radius above it."""
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "steepest_road.yaml")
    scene = Scene.of(system, Reference(system).number)
    assert [(r.center.body, r.radius) for r in scene.rollers] == [(0, pytest.approx(0.3))] * 2
    alpha = np.radians(15.0)
    pose = np.array([[[-0.5 * np.sin(alpha), 0.5 * np.cos(alpha), alpha]]])
    for roller in scene.rollers:
        x, y = positions(pose, roller.center)[0]
        assert y * np.cos(alpha) - x * np.sin(alpha) == pytest.approx(roller.radius)


@pytest.mark.parametrize(
    ("wheels", "told"),
    [
        ("{car.rear: 0}", "the radius of a wheel is above 0"),
        ("{ground.O: 0.3 m}", "a wheel is at a point of a body that moves"),
        ("{car.rear: 3 s}", "length"),
        ("[car.rear]", "wheels is a mapping by name"),
        ("{car.reer: 0.3 m}", "Did you mean"),
    ],
)
def test_wheels_that_cannot_be_drawn_are_a_mistake_of_the_model(wheels: str, told: str) -> None:
    with pytest.raises(fb.ModelError, match=told):
        fb.System.from_text(VEHICLE.format(at="-h", along="right") + f"drawing: {{wheels: {wheels}}}")


def test_an_elastic_string_that_is_slack_is_drawn_in_waves_and_a_taut_one_straight() -> None:
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "bungee_jump.yaml")
    relaxed = system.parameters["L"].value
    scene = Scene.of(system, Reference(system).number)
    assert relaxed is not None
    for share, is_slack in ((0.5, True), (0.99, True), (1.0, False), (1.2, False)):
        drawn = Drawing.of(scene, np.array([[[0.0, -share * relaxed, 0.0]]]))
        (string,) = (stroke for stroke in drawn.strokes if isinstance(stroke, Strand))
        points = drawn.points(string, 0)
        assert (float(np.abs(points[:, 0]).max()) > 1e-6) is is_slack
        assert np.allclose(points[[0, -1]], ((0.0, 0.0), (0.0, -share * relaxed)), atol=1e-9)
        if share == 0.99:  # its waves are as long as the string
            assert float(np.hypot(*np.diff(points, axis=0).T).sum()) == pytest.approx(relaxed, rel=1e-3)


def test_an_elastic_string_whose_ends_are_together_hangs_in_a_loop() -> None:
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "bungee_jump.yaml")
    drawn = Drawing.of(Scene.of(system, Reference(system).number), np.zeros((1, 1, 3)))
    (string,) = (stroke for stroke in drawn.strokes if isinstance(stroke, Strand))
    points = drawn.points(string, 0)
    assert np.allclose(points[[0, -1]], 0.0, atol=1e-9)
    assert points[:, 1].max() < 1e-9
    assert points[:, 1].min() < -4 * drawn.symbol
    assert points[:, 0].min() == pytest.approx(-points[:, 0].max())


def test_the_line_of_a_floor_lies_over_its_hatching() -> None:
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "ball_with_back_spin.yaml")
    drawn = Drawing.of(Scene.of(system, Reference(system).number), np.zeros((1, 1, 3)))
    styles = [stroke.style for stroke in drawn.strokes]
    assert styles.index("hatch") + 1 == styles.index("surface")


def test_the_motion_at_the_start_is_drawn_at_the_start_only() -> None:
    system = fb.System.load(Path(__file__).parents[1] / "examples" / "block_on_an_elastic_string.yaml")
    said = [{word.label.text for word in system.picture(at=at).words} for at in (None, 0.0, 0.3)]
    assert ["v_0" in words for words in said] == [True, True, False]
