"""What is drawn of contacts: surfaces, outlines in true size, rings and stops."""

from __future__ import annotations

import json
import re
from pathlib import Path as FilePath

import numpy as np
import pytest

from freebody.errors import InputError
from freebody.numeric.contact.start import assembled_touching
from freebody.numeric.reference import Reference
from freebody.present.animation import write_animation
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, is_within
from freebody.present.marks import ContactTrack
from freebody.present.scene import Scene
from freebody.present.strokes import Path
from freebody.present.surfaces import Plane, clipped
from freebody.study.simulation.simulate import simulate
from freebody.system.system import System

FLOOR = "ground: {lines: {floor: {along: right}}}\n"
BALL_ON_FLOOR = f"""{FLOOR}
bodies: {{b: {{sphere: {{mass: 1 kg, radius: 0.1 m}}}}}}
connections: {{c: {{contact: {{between: [b, floor]}}}}}}
"""


def drawn(text: str, moves: list[tuple[float, float, float]] | None = None) -> Drawing:
    """The drawing of the start of a model, and of all its bodies moved together from there."""
    system = System.from_text(text)
    reference = Reference(system)
    q = assembled_touching(reference)
    start = np.array([reference.pose(q, body.name) for body in system.moving])
    poses = np.array([start + np.array(move) for move in moves or [(0.0, 0.0, 0.0)]])
    return Drawing.of(Scene.of(system, reference.number), poses)


def paths(drawing: Drawing, style: str) -> list[Path]:
    return [s for s in drawing.strokes if isinstance(s, Path) and s.style == style]


def lines(drawing: Drawing, style: str, frame: int = 0) -> list[Array]:
    return [drawing.points(path, frame) for path in paths(drawing, style)]


# -- surfaces ---------------------------------------------------------------------------------
def test_a_floor_is_hatched_below_and_reaches_from_side_to_side() -> None:
    drawing = drawn(
        BALL_ON_FLOOR,
        [(0.0, 0.0, 0.0), (3.0, 0.0, 0.0)],
    )
    (floor,), (hatch,) = lines(drawing, "surface"), lines(drawing, "hatch")
    assert floor[:, 1] == pytest.approx(0.0)
    assert hatch[:, 1].max() == pytest.approx(0.0)
    assert hatch[:, 1].min() < -drawing.symbol / 2
    assert floor[0, 0] < -0.1
    assert floor[-1, 0] > 3.1
    assert drawing.low[0] < floor[0, 0] < floor[-1, 0] < drawing.high[0]


def test_a_ceiling_is_hatched_above() -> None:
    drawing = drawn("""
ground: {lines: {ceiling: {along: right, through: [0, 1 m]}}}
bodies: {b: {sphere: {mass: 1 kg, radius: 0.1 m}, at: [0, 0.5 m], angle: 0}}
connections: {c: {contact: {between: [b, ceiling], below: true}}}
""")
    (ceiling,), (hatch,) = lines(drawing, "surface"), lines(drawing, "hatch")
    assert ceiling[:, 1] == pytest.approx(1.0)
    assert hatch[:, 1].min() == pytest.approx(1.0)


def test_lines_that_enclose_a_ball_meet_at_their_corners() -> None:
    drawing = drawn("""
ground:
  lines:
    floor: {along: right}
    right: {along: up, through: [1 m, 0]}
    top: {along: left, through: [0, 1 m]}
    left: {along: down, through: [-1 m, 0]}
bodies: {b: {sphere: {mass: 1 kg, radius: 0.1 m}, at: [0, 0.5 m], angle: 0}}
connections: {c: {contact: {among: all}}}
""")
    ends = {tuple(np.round(p, 9) + 0.0) for line in lines(drawing, "surface") for p in line}
    assert ends == {(-1.0, 0.0), (1.0, 0.0), (1.0, 1.0), (-1.0, 1.0)}


def test_a_line_far_away_does_not_widen_the_picture() -> None:
    drawing = drawn("""
ground: {lines: {floor: {along: right}, wall: {along: up, through: [10 m, 0]}}}
bodies: {b: {sphere: {mass: 1 kg, radius: 0.1 m}, at: [0, 0.2 m], angle: 0}}
connections: {c: {contact: {among: all}}}
""")
    assert (drawing.high - drawing.low).max() < 1.0
    assert len(lines(drawing, "surface")) == 1


def test_particles_and_rods_lie_on_the_floor_and_not_in_it() -> None:
    for shape in ("particle: {mass: 1 kg}", "rod: {mass: 1 kg, length: 1 m}"):
        drawing = drawn(
            f"{FLOOR}bodies: {{b: {{{shape}}}}}\nconnections: {{c: {{contact: {{between: [b, floor]}}}}}}",
            [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0)],
        )
        (floor,) = lines(drawing, "surface")
        (body,) = lines(drawing, "dot" if "particle" in shape else "body")
        assert body[:, 1].min() == pytest.approx(floor[0, 1])


def test_a_line_of_a_moving_body_moves_with_it_and_is_as_long_as_what_lies_on_it() -> None:
    drawing = drawn(
        """
bodies:
  belt: {body: {mass: 1 kg, inertia: 1 kg m^2}, lines: {top: {along: right}}}
  b: {rectangle: {mass: 1 kg, width: 0.3 m, height: 0.2 m}, at: [0, 0.1 m], angle: 0}
connections: {c: {contact: {between: [b, belt.top], touching: true}}}
""",
        [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0)],
    )
    (before,), (after,) = lines(drawing, "surface", 0), lines(drawing, "surface", 1)
    assert after - before == pytest.approx(np.array([(2.0, 0.0), (2.0, 0.0)]))
    assert 0.3 < np.ptp(before[:, 0]) < 0.6


def test_a_face_of_a_wedge_ends_where_the_wedge_does() -> None:
    drawing = drawn("""
bodies:
  wedge:
    polygon: {mass: 2 kg, corners: [[0, 0], [1 m, 0], [0, 0.5 m]]}
    at: [0, 0]
    angle: 0
    points: {T: [0, 0.5 m]}
    lines: {face: {through: wedge.T, along: [1, -0.5]}}
  b: {particle: {mass: 1 kg}, at: [0.4 m, 0.31 m]}
connections: {c: {contact: {between: [b, wedge.face]}}}
""")
    (face,) = lines(drawing, "surface")
    assert face == pytest.approx(np.array([(0.0, 0.5), (1.0, 0.0)]))
    assert not lines(drawing, "hatch")


def test_a_particle_lies_on_the_floor_of_a_cabin_which_is_no_ground() -> None:
    drawing = drawn("""
bodies:
  cabin:
    rectangle: {mass: 9 kg, width: 2 m, height: 2 m}
    at: [0, 1 m]
    lines: {floor: {through: [0, -1 m], along: right}}
  man: {particle: {mass: 1 kg}, near: {at: [0.3 m, 0]}}
connections:
  shaft: {slider: {body: cabin, along: up}}
  feet: {contact: {between: [man, cabin.floor], friction: 0.3, touching: true}}
""")
    (man,) = lines(drawing, "dot")
    assert man[:, 1].min() == pytest.approx(0.0, abs=1e-9)
    assert man[:, 0].mean() == pytest.approx(0.3)
    floors = [line for line in lines(drawing, "surface") if np.ptp(line[:, 1]) < 1e-9]
    assert [float(line[0, 1]) for line in floors] == [pytest.approx(0.0)]
    assert all(np.ptp(hatch[:, 0]) < 2 * drawing.symbol for hatch in lines(drawing, "hatch"))  # of the shaft alone


def test_a_load_on_a_wedge_lies_on_it_beside_a_wall_that_ends_above() -> None:
    drawing = drawn((FilePath(__file__).parents[1] / "examples/wedge_under_load.yaml").read_text(encoding="utf-8"))
    slope, width = float(np.tan(np.radians(12))), 0.4
    (load,) = lines(drawing, "dot")
    face = slope * (width - load[:, 0])
    middle = abs(load[:, 0] - load[:, 0].mean()).max() * slope  # a corner is that much in it
    assert (load[:, 1] > face - 1.1 * middle - 0.2 * drawing.symbol).all()
    (wall,) = [line for line in lines(drawing, "surface") if np.ptp(line[:, 0]) < 1e-9]
    assert wall[:, 0] == pytest.approx(load[:, 0].max())
    assert wall[:, 1].min() == pytest.approx(slope * width / 2)


def test_a_line_is_cut_by_planes_on_both_sides_or_lies_behind_them() -> None:
    start, along = np.array([0.0, 0.0]), np.array([1.0, 0.0])
    right, left = np.array([1.0, 0.0]), np.array([-1.0, 0.0])
    assert clipped(start, along, [Plane(right, -2.0), Plane(left, -3.0)]) == (-2.0, 3.0)
    assert clipped(start, along, [Plane(right, 2.0), Plane(left, -1.0)]) is None
    assert clipped(start, along, [Plane(np.array([0.0, 1.0]), 1.0)]) is None


# -- bodies -----------------------------------------------------------------------------------
def test_a_polygon_is_drawn_as_its_corners_and_not_as_the_hull_of_its_points() -> None:
    drawing = drawn(f"""{FLOOR}
bodies:
  p:
    polygon: {{mass: 1 kg, corners: [[1 m, 1 m], [2 m, 1 m], [1.5 m, 2 m]]}}
    points: {{hook: [3 m, 2 m]}}
    at: [0, 0]
    angle: 0
connections: {{c: {{contact: {{between: [p, floor]}}}}}}
loads: {{k: {{spring: {{first: ground.origin, second: p.hook, stiffness: 1 N/m, length: 1 m}}}}}}
""")
    (shape,), (arm,) = lines(drawing, "body"), lines(drawing, "rim")
    assert shape == pytest.approx(np.array([(1.0, 1.0), (2.0, 1.0), (1.5, 2.0)]))
    assert arm[-1] == pytest.approx((3.0, 2.0))


def test_a_point_is_within_a_polygon_or_on_its_edge() -> None:
    square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    assert is_within(square, (0.5, 0.5))
    assert is_within(square[::-1], (1.0, 0.5))
    assert not is_within(square, (1.1, 0.5))


def test_a_fixed_ring_is_hatched_outside_and_a_hoop_on_a_floor_has_its_wall_inside() -> None:
    bowl = drawn("""
bodies: {bowl: {ring: {radius: 1 m}, fixed: true}, b: {sphere: {mass: 1 kg, radius: 0.1 m}, at: [0, 0.3 m], angle: 0}}
connections: {c: {contact: {between: [b, inside bowl]}}}
""")
    (rim,), (hatch,) = lines(bowl, "surface"), lines(bowl, "hatch")
    assert np.hypot(*rim.T) == pytest.approx(1.0)
    assert np.hypot(*hatch.T).min() == pytest.approx(1.0)
    hoop = drawn(BALL_ON_FLOOR.replace("sphere", "ring"))
    assert min(rim[:, 1].min() for rim in lines(hoop, "rim")) == pytest.approx(0.0, abs=1e-9)


def test_a_ring_that_is_touched_on_both_sides_is_a_line() -> None:
    drawing = drawn(f"""{FLOOR}
bodies:
  hoop: {{ring: {{mass: 1 kg, radius: 1 m}}, at: [0, 1 m], angle: 0}}
  b: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: [0, 0.5 m], angle: 0}}
connections: {{f: {{contact: {{between: [hoop, floor]}}}}, c: {{contact: {{between: [b, inside hoop]}}}}}}
""")
    (hoop,) = lines(drawing, "hoop")
    assert hoop[:, 1].min() == pytest.approx(0.0, abs=1e-9)
    assert not lines(drawing, "body ring")


def test_a_body_on_a_table_is_not_drawn_aside_for_its_string() -> None:
    drawing = drawn("""
ground: {points: {P: [1 m, 0]}, lines: {top: {along: right}}}
bodies:
  pulley: {disk: {mass: 1 kg, radius: 0.05 m}}
  box: {rectangle: {mass: 1 kg, width: 0.2 m, height: 0.1 m}, points: {hook: [0.1 m, 0]}}
  load: {particle: {mass: 1 kg}}
connections:
  p: {pin: [ground.P, pulley]}
  c: {contact: {between: [box, top]}}
  rope: {string: {path: [box.hook, over pulley, load]}}
""")
    assert "box" not in drawing.moved


# -- stops ------------------------------------------------------------------------------------
def test_stops_stand_where_the_edge_of_a_body_meets_them_with_hatching_behind() -> None:
    drawing = drawn(
        """
bodies: {cart: {rectangle: {mass: 1 kg, width: 0.2 m, height: 0.1 m}, at: [0, 0], angle: 0}}
measures: {x: x of cart}
connections: {s: {stop: {measure: x, min: -0.5 m, max: 0.7 m}}, far: {stop: {measure: x, max: 100 m}}}
""",
        [(0.0, 0.0, 0.0), (0.5, 0.0, 0.0)],
    )
    low, high = lines(drawing, "surface")
    assert (low[0, 0], high[0, 0]) == pytest.approx((-0.6, 0.8))
    behind, beyond = lines(drawing, "hatch")
    assert behind[:, 0].max() == pytest.approx(-0.6)
    assert beyond[:, 0].min() == pytest.approx(0.8)


def test_a_stop_of_a_pinned_rod_lies_along_the_rod_at_its_limit() -> None:
    drawing = drawn("""
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {p: {pin: [ground.origin, rod.start]}, s: {stop: {measure: angle of rod, max: 90 deg}}}
""")
    walls = [p for p in paths(drawing, "surface") if p.place.body == GROUND and np.ptp(p.points[:, 1]) > 0.1]
    (wall,) = [drawing.points(p, 0) for p in walls]
    assert wall[:, 0] == pytest.approx(-0.3 * 2 * drawing.symbol)
    assert (wall[:, 1] > 0.4).all()
    assert lines(drawing, "hatch")[0][:, 0].min() < wall[0, 0]


# -- marks ------------------------------------------------------------------------------------
LAUNCHED = f"""{FLOOR}
bodies: {{b: {{sphere: {{mass: 1 kg, radius: 0.1 m}}}}}}
connections: {{c: {{contact: {{between: [b, floor], friction: 0.2}}}}}}
measures: {{x: x of b}}
start: {{x: 0, rate(x): 1 m/s}}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
"""


def tracked(text: str, until: float) -> tuple[Drawing, Array]:
    """The drawing of a motion with its marks, and its times."""
    result = simulate(System.from_text(text), until)
    number = result.simulator.reference.number
    track = ContactTrack.of(result.system, number, result.course.contact)
    return Drawing.of(Scene.of(result.system, number), result.course.poses[:, :-1], track), result.course.times


def marks(drawing: Drawing, frame: int) -> dict[str, list[Array]]:
    """The middles of the marks of an instant, by style."""
    found: dict[str, list[Array]] = {}
    for stroke in drawing.shown(frame)[len(drawing.strokes) :]:
        found.setdefault(stroke.style, []).append(drawing.points(stroke, frame).mean(axis=0))
    return found


def test_the_mark_under_a_ball_changes_when_it_begins_to_roll() -> None:
    drawing, times = tracked(LAUNCHED, 0.3)
    rolls = 2 / (7 * 0.2 * 9.81)
    for frame, t in enumerate(times):
        ((style, (middle,)),) = marks(drawing, frame).items()
        if abs(t - rolls) > 1e-3:
            assert style == ("slips" if t < rolls else "sticks")
        assert middle == pytest.approx((drawing.poses[frame, 0, 0], 0.0), abs=1e-9)


def test_no_mark_shows_where_nothing_touches() -> None:
    ball = "b: {sphere: {mass: 1 kg, radius: 0.1 m}"
    drawing, times = tracked(LAUNCHED.replace(ball, f"{ball}, at: [0, 1 m], angle: 0").replace("x: 0, ", ""), 1.0)
    assert marks(drawing, 0) == {}
    assert marks(drawing, len(times) - 1) != {}


@pytest.mark.parametrize("inside", [False, True])
def test_a_mark_on_a_circle_lies_between_the_centres_or_beyond_the_inner_one(inside: bool) -> None:
    drawing, _times = tracked(
        f"""
bodies:
  big: {{ring: {{mass: 1 kg, radius: 1 m}}, fixed: true}}
  b: {{sphere: {{mass: 1 kg, radius: 0.1 m}}, at: [0, {"-0.9 m" if inside else "1.1 m"}], angle: 0}}
connections: {{c: {{contact: {{between: [b, {"inside big" if inside else "big"}], friction: 0.2}}}}}}
loads: {{weight: {{gravity: 9.81 m/s^2}}}}
""",
        0.01,
    )
    assert marks(drawing, 0)["sticks"][0] == pytest.approx((0.0, -1.0 if inside else 1.0), abs=1e-6)


def test_a_page_says_what_the_marks_mean_and_when_they_show(tmp_path: FilePath) -> None:
    result = simulate(System.from_text(LAUNCHED), 0.3)
    number, course = result.simulator.reference.number, result.course
    track = ContactTrack.of(result.system, number, course.contact)
    scene, poses = Scene.of(result.system, number), course.poses[:, :-1]
    path = write_animation(scene, course.times, poses, tmp_path / "a.html", title="x", contacts=track)
    text = path.read_text(encoding="utf-8")
    assert "a full dot sticks, an empty one slips" in text
    found = re.search(r'id="data">([^<>]*)</script>', text)
    assert found is not None
    data = json.loads(found[1])
    sticks, slips = data["marks"]
    assert (sticks["style"], slips["style"]) == ("sticks", "slips")
    assert slips["frames"] == [0, sticks["frames"][0]]
    assert sticks["frames"][1] == data["n_frames"]


def test_contacts_of_another_motion_are_refused(tmp_path: FilePath) -> None:
    drawing, times = tracked(LAUNCHED, 0.3)
    assert drawing.contacts is not None
    short = ContactTrack(drawing.contacts.meetings, drawing.contacts.states[:-1])
    with pytest.raises(InputError, match="contacts for its"):
        write_animation(drawing.scene, times, drawing.poses, tmp_path / "a.html", title="x", contacts=short)


def _lines(text: str, style: str) -> list[Array]:
    drawing = drawn(text)
    return [
        drawing.points(stroke, 0) for stroke in drawing.strokes if isinstance(stroke, Path) and stroke.style == style
    ]


def _example(name: str) -> str:
    return (FilePath(__file__).parents[1] / "examples" / f"{name}.yaml").read_text(encoding="utf-8")


def test_a_table_is_drawn_below_all_of_a_chain_that_lies_on_it() -> None:
    top, side = _lines(_example("chain_on_rough_table"), "surface")
    assert top[:, 0].min() < -(2 - 0.6)  # [m] as much lies there at first
    assert np.ptp(top[:, 1]) == 0
    assert -0.1 < top[0, 1] < 0
    assert np.ptp(side[:, 0]) == pytest.approx(0, abs=1e-12)
    assert side[:, 0].max() < 0


def test_what_hangs_on_both_sides_of_a_peg_lies_on_no_table() -> None:
    system = System.from_text("""
bodies: {chain: {rope: {mass: 1 kg, length: 2 m}}}
connections: {peg: {heavy_rope: {rope: chain, over: [ground.origin], leads: [up, down]}}}
loads: {weight: {gravity: 9.81 m/s^2}}
measures: {x: {drop of chain}}
start: {x: 1.1 m}
""")
    scene = Scene.of(system, Reference(system).number)
    assert [scene.lies(rope) for rope in scene.ropes] == [False]


def test_a_string_is_bent_over_a_peg() -> None:
    pegs = [points.mean(axis=0) for points in _lines(_example("collar_pulled_over_a_pulley"), "joint")]
    assert [peg for peg in pegs if np.hypot(*(peg - (0, 1))) < 0.05]
