"""What stands on the picture of a system as on paper: masses, dimensions, velocities at the start, and proportions."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.errors import ModelError
from freebody.language.expression import Expr, evaluate
from freebody.present.pen import full_height
from freebody.present.picture.picture import Picture
from freebody.present.picture.shapes import Ink, Shape
from freebody.present.scene import Scene
from freebody.present.space.bodies import body_pieces
from freebody.present.space.drawing import shells_of
from freebody.study.pictures.free_body import FreeBody
from freebody.study.pictures.instant import start_of
from freebody.study.pictures.picture import free_body, picture

EXAMPLES = Path(__file__).parents[1] / "examples"

BEAM = """
parameters: {m: 20 kg, L: 6 m, a: 2 m, s: 4 m, b: 3 m, P: 1 kN}
ground: {points: {A: [0, 0], C: [0, b]}}
bodies:
  beam: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: 0, points: {P: [a - L/2, 0], Q: [s - L/2, 0]}}
connections:
  A: {pin: [ground.A, beam.start]}
  rope: {link: [ground.C, beam.end]}
loads: {load: {force: {at: beam.P, along: down, magnitude: P}}}
"""

THROWN = """
parameters: {m: 1 kg, v0: 10 m/s, theta: 40 deg, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
start: {x: 0, y: 0, rate(x): v0*cos(theta), rate(y): v0*sin(theta)}
"""

BACK = """
parameters: {m: 1 kg, r: 0.1 m, v0: 3 m/s, w0: 20 rad/s, mu: 0.3, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {sphere: {mass: m, radius: r}}}
connections: {contact: {contact: {between: [ball, floor], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, turn: angle of ball clockwise}
start: {x: 0, rate(x): -v0, rate(turn): -w0}
"""


def example(name: str) -> fb.System:
    return fb.System.load(EXAMPLES / f"{name}.yaml")


def texts(found: Picture) -> set[str]:
    return {word.label.text for word in found.words}


def heads(found: Picture, ink: str) -> list[np.ndarray]:
    """The tips of the arrows of a colour."""
    return [s.points[0] for s in found.shapes if s.fill is not None and s.fill.color == ink and len(s.points) == 4]


def test_a_point_mass_is_called_by_its_mass_and_other_bodies_by_their_names() -> None:
    assert {"m_1", "m_2", "pulley"} <= texts(picture(example("atwood_machine")))
    assert "m_1" in texts(free_body(example("atwood_machine"), "left"))


def test_point_masses_that_share_a_mass_keep_their_names() -> None:
    assert {"A", "B"} <= texts(picture(example("two_masses_three_springs")))


def test_a_length_from_the_end_of_a_rod_is_a_dimension_though_other_points_lie_between() -> None:
    # a - L/2 and -L/2 are a apart whatever L is; the middle lies between the start and Q
    assert {"a", "s", "L", "b"} <= texts(picture(fb.System.from_text(BEAM)))


def test_the_distance_of_fixed_bearings_is_a_dimension() -> None:
    assert "d" in texts(picture(example("four_bar")))


def test_the_angle_at_which_a_ladder_is_put_is_shown() -> None:
    assert "\u03b1" in texts(picture(example("ladder_against_wall")))


def test_a_throw_shows_its_speed_and_its_angle() -> None:
    found = picture(fb.System.from_text(THROWN))
    assert {"v_0", "\u03b8"} <= texts(found)


def test_a_velocity_that_points_back_is_drawn_back_without_a_sign() -> None:
    found = picture(fb.System.from_text(BACK))
    assert {"v_0", "w_0"} <= texts(found)
    wheel = next(s.points for s in found.shapes if s.is_closed and len(s.points) > 40)
    assert min(tip[0] for tip in heads(found, "velocity")) < float(wheel[:, 0].min())


@pytest.mark.parametrize("name", ["disk_rolling_down_incline", "sphere_launched_down_incline", "ball_with_back_spin"])
def test_the_line_that_a_wheel_rolls_on_is_longer_than_the_wheel(name: str) -> None:
    found = picture(example(name))
    round_ones = [s.points for s in found.shapes if s.is_closed and len(s.points) > 40]
    wheel = max(float(np.ptp(points[:, 0])) for points in round_ones)
    lines = [s.points for s in found.shapes if not s.is_closed and len(s.points) == 2]
    longest = max(float(np.hypot(*(points[1] - points[0]))) for points in lines)
    assert longest > 1.7 * wheel


def test_what_hangs_on_a_pulley_is_a_block_that_is_not_lost_beside_it() -> None:
    found = picture(example("atwood_machine"))
    blocks = [s.points for s in found.shapes if s.is_closed and len(s.points) == 4 and s.fill is not None]
    sides = [float(np.ptp(points[:, 0])) for points in blocks if s_is_square(points)]
    wheel = max(float(np.ptp(s.points[:, 0])) for s in found.shapes if s.is_closed and len(s.points) > 40)
    assert len(sides) >= 2
    assert wheel < 8.0 * max(sides)


def s_is_square(points: np.ndarray) -> bool:
    return abs(float(np.ptp(points[:, 0])) - float(np.ptp(points[:, 1]))) < 1e-6


DRAWN = """
space: true
parameters: {L: 1 m}
ground: {points: {O: [0, 0, 0]}}
bodies:
  shaft: {body: {inertia: 1 kg m^2}, points: {C: [L, 0, 0], B: [L, -L, 0], D: [0, 0, L]}}
connections: {bearing: {revolute: {first: ground.O, second: shaft, about: y}}}
measures: {psi: angle of shaft about y}
start: {psi: 0, rate(psi): 2 rad/s}
drawing: {paths: {shaft: [origin, C, B]}}
"""


def test_a_bent_shaft_is_drawn_through_the_points_of_its_path() -> None:
    with_path, without = (Scene.of(fb.System.from_text(text), float_of).figures[0] for text in (DRAWN, no_path(DRAWN)))
    assert [place.at for place in with_path.path] == [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, -1.0, 0.0)]
    bars = [piece for piece in body_pieces(with_path, [], 0.05, is_fixed=False) if not piece.radius]
    star = [piece for piece in body_pieces(without, [], 0.05, is_fixed=False) if not piece.radius]
    assert (len(bars), len(star)) == (2, 3)


def no_path(text: str) -> str:
    return text[: text.index("drawing:")]


def float_of(expr: Expr) -> float:
    return float(evaluate(expr, {"L": 1.0}))


def test_an_angular_velocity_is_a_vector_along_its_axis() -> None:
    found = picture(fb.System.from_text(DRAWN))
    assert "\u03c8\u0307" in texts(found)
    [vector] = [s.points for s in found.shapes if s.stroke is not None and s.stroke.color == "velocity"]
    assert abs(vector[1][0] - vector[0][0]) < 1e-6  # y is up in the picture
    assert vector[1][1] > vector[0][1]


def test_two_shafts_with_forks_and_a_cross_make_a_cardan_joint() -> None:
    scene = Scene.of(example("cardan_joint"), lambda expr: float(evaluate(expr, {"alpha": 0.5236, "I": 0.01})))
    still = np.zeros((1, 3, 3)), np.broadcast_to(np.eye(3), (1, 3, 3, 3))
    shells = shells_of(scene, still)
    names = {form.index: form.name for form in scene.figures}
    assert {names[index] for index in shells.crosses} == {"cross"}
    assert {names[index] for index in shells.forks} == {"drive", "driven"}


def test_gimbals_have_no_cross() -> None:
    system = example("gyroscope_in_gimbals")
    values = dict.fromkeys(system.parameters, 1.0)
    scene = Scene.of(system, lambda expr: float(evaluate(expr, values)))
    n = len(scene.names)
    shells = shells_of(scene, (np.zeros((1, n, 3)), np.broadcast_to(np.eye(3), (1, n, 3, 3))))
    assert not shells.crosses
    assert not shells.forks


def test_labels_and_signs_can_be_changed_and_left_out() -> None:
    text = (EXAMPLES / "atwood_machine.yaml").read_text("utf-8")
    more = "\ndrawing: {labels: {left: A, x1: q}, hide: [right, w, R], scale: {left: 2}}\n"
    before, after = (picture(fb.System.from_text(each)) for each in (text, text + more))
    assert {"A", "q"} <= texts(after)
    assert not texts(after) & {"m_1", "m_2", "x_1", "w", "R"}
    widest = [max(float(np.ptp(s.points[:, 0])) for s in each.shapes if s_is_block(s)) for each in (before, after)]
    assert widest[1] == pytest.approx(2 * widest[0])


def s_is_block(shape: Shape) -> bool:
    return shape.is_closed and len(shape.points) == 4 and s_is_square(shape.points)


@pytest.mark.parametrize(
    ("section", "message"),
    [
        ("{hide: [rigt]}", "there is nothing called rigt to draw"),
        ("{scale: {left: -1}}", "a scale is a number above 0"),
        ("{paths: {left: [A]}}", "two or more points of left"),
        ("{paths: {pulley: [center, rim]}}", "pulley has no point rim"),
        ("{colour: {left: red}}", "drawing has no colour"),
    ],
)
def test_what_cannot_be_drawn_so_is_told(section: str, message: str) -> None:
    text = (EXAMPLES / "atwood_machine.yaml").read_text("utf-8")
    with pytest.raises(fb.ModelError, match=message):
        fb.System.from_text(f"{text}\ndrawing: {section}\n")


def reactions_on(found: Picture) -> set[str]:
    return {word.label.text for word in found.words if word.ink.color == "reaction"}


def test_a_hanging_mass_is_held_by_its_string_alone() -> None:
    assert reactions_on(free_body(example("atwood_machine"), "left")) == {"T_left"}


def test_what_is_pushed_aside_swings_and_needs_no_sideways_force() -> None:
    """Newton's second law to the right: m1 a_x = 1 N."""
    text = (EXAMPLES / "atwood_machine.yaml").read_text("utf-8")
    pushed = text.replace("loads:", "loads:\n  wind: {force: {at: left, along: right, magnitude: 1 N}}", 1)
    with pytest.raises(ModelError, match="put them apart"):  # nothing says where it hangs
        fb.System.from_text(pushed).solve()
    placed = fb.System.from_text(pushed.replace("particle: {mass: m1}", "particle: {mass: m1}, at: [-R, -2 m]", 1))
    assert reactions_on(free_body(placed, "left")) == {"T_left"}
    [answer] = placed.solve("horizontal acceleration of left").answers
    assert answer.value == pytest.approx(1.0 / placed.parameters["m1"].value)


def test_a_law_that_holds_a_point_back_is_drawn_as_a_spring_from_a_wall_and_one_that_drives_it_as_an_arrow() -> None:
    held = {label: scene_of(BLOCK.replace("LAW", law)) for label, law in BLOCK_LAWS.items()}
    assert {label: len(scene.tethers) for label, scene in held.items()} == {
        "spring": 1,
        "damper": 1,
        "drag": 0,
        "motor": 0,
        "pushed away": 0,
    }


def test_springs_and_dampers_given_as_laws_end_at_the_edge_of_their_body_and_bear_their_constants() -> None:
    assert {"k", "c"} <= texts(picture(example("isolated_machine")))
    assert "kx" not in {text.replace(" ", "") for text in texts(picture(example("rack_and_pinion_drive")))}


BLOCK = """
parameters: {k: 1 N/m, c: 1 N s/m, b: 1 N s^2/m^2, F: 1 N, w: 1 rad/s}
bodies: {block: {particle: {mass: 1 kg}}}
connections: {rail: {slider: {body: block, along: right}}}
measures: {x: x of block}
loads: {it: {law: {measure: x, force: LAW}}}
start: {x: 0}
"""
BLOCK_LAWS = {
    "spring": "-k*x",
    "damper": "-c*rate(x)",
    "drag": "-b*rate(x)*abs(rate(x))",
    "motor": "F*sin(w*t) - k*x",
    "pushed away": "k*x",
}


def scene_of(text: str) -> Scene:
    return Scene.of(fb.System.from_text(text), float_of)


def test_a_mass_on_a_spring_in_line_with_its_guide_is_not_pushed_sideways() -> None:
    told = example("mass_on_spring").free_body("block").description.partition(". ")[2]
    assert told.replace("\u2009", " ") == "weight m g, down; load spring F_spring, up."


@pytest.mark.parametrize(
    ("name", "body", "told"),
    [
        ("cart_into_a_buffer", "cart", "F_buffer, to the left"),  # the buffer stands on the right
        ("valve_spring", "valve", "F_spring, down"),  # preloaded from above
    ],
)
def test_springs_that_push_are_drawn_pushing(name: str, body: str, told: str) -> None:
    assert told in example(name).free_body(body).description


NUMBERS = """
parameters: {g: 9.81 m/s^2}
bodies: {block: {particle: {mass: 20 kg}}}
connections: {guide: {slider: {body: block, along: right}}}
loads: {weight: {gravity: g}, push: {force: {at: block, along: right, magnitude: 100 N}}}
"""


def test_a_weight_and_a_force_that_are_numbers_have_units() -> None:
    """`20 g` would be a mass of 20 grams."""
    told = fb.System.from_text(NUMBERS).free_body("block").description.replace("\u2009", " ")
    assert "weight 20 kg g, down" in told
    assert "push 100 N, to the right" in told


@pytest.mark.parametrize(("body", "sense"), [("drum", "down"), ("motor", "up")])
def test_a_belt_whose_runs_are_not_parallel_pulls_across_the_line_of_centres(body: str, sense: str) -> None:
    """With the sine (r2 - r1)/d of the angle between the runs and that line, in symbols of the model."""
    told = example("belt_drive").free_body(body).description.replace("\u2009", " ")
    assert f"(r_2 \u2212 r_1) F_b/0.6 m, {sense}" in told


def test_a_rope_rubs_on_a_drum_that_stands_still_at_its_rim() -> None:
    system = example("capstan")
    body = FreeBody(start_of(system).snapshot, ["drum"])
    (rub,) = (force for force in body.forces() if force.about == "friction force")
    assert rub.at == pytest.approx((-0.1, 0.0))
    assert rub.force == pytest.approx((0.0, 1.0))


def test_bodies_drawn_beside_each_other_have_their_coordinates_where_they_are_drawn() -> None:
    picture = example("two_masses_three_springs").picture()
    arrows = [s.points for s in picture.shapes if s.stroke == Ink("measure") and len(s.points) == 2]
    level = sorted(float(np.ptp(points[:, 0])) for points in arrows if np.ptp(points[:, 0]) > 1.0)
    assert len(level) == 2
    assert level[0] == pytest.approx(level[1])


def test_a_wall_behind_a_spring_is_hatched_once() -> None:
    picture = example("two_masses_three_springs").picture()
    hatched = [s for s in picture.shapes if s.stroke == Ink("muted") and s.width == 0.8 and len(s.points) > 4]
    assert len(hatched) == 3  # two walls and the rail of both


def test_forces_at_the_corners_of_a_body_are_named_by_their_corners() -> None:
    told = example("tetrahedron_on_a_slope").free_body("stone").description
    assert all(f"F_{corner},{axis}" in told.replace(" ", ",") for corner in "ABC" for axis in (1, 2))


@pytest.mark.parametrize(("name", "radius"), [("hoist", "R"), ("ball_off_a_dome", "R"), ("ball_off_a_dome", "r")])
def test_narrow_circles_and_spheres_have_their_radii(name: str, radius: str) -> None:
    assert radius in [word.label.text for word in example(name).picture().words]


def test_a_couple_is_drawn_at_the_point_at_which_it_acts_and_an_angle_of_lengths_has_no_arc() -> None:
    """The angle atan(h/(1 m)) is of one parameter, but no plain one; it was calculated for h = 0 and could not be for
    its inverse."""
    system = fb.System.from_text("""
parameters: {h: 2 m, M: 3 N m}
bodies: {bar: {rod: {length: 4 m}, at: {start: [0, 0]}, angle: atan((1 m)/h), points: {C: [1 m, 0]}}}
connections: {foot: {weld: [ground.A, bar.start]}}
loads: {couple: {torque: {on: bar.C, magnitude: M}}}
""")
    free = FreeBody(start_of(system).snapshot, ["bar"])
    (couple,) = (force for force in free.forces() if force.name == "couple")
    assert np.hypot(*couple.at) == pytest.approx(1.0)  # from the middle of the bar
    assert texts(picture(system))


TWO_LOADS = """
ground: {points: {A: [0, 0], B: [6 m, 0]}}
bodies: {beam: {rod: {length: 6 m}, angle: 0, at: {start: [0, 0]}, points: {C: [0, 0]}}}
connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.end, through: ground.B, along: right}}}
loads:
  left: {distributed: {between: [beam.start, beam.C], along: down, intensity: 2 kN/m}}
  right: {distributed: {between: [beam.C, beam.end], along: down, intensity: 5 kN/m}}
"""


def test_loads_along_a_line_compare_by_their_heights() -> None:
    lines = [s.points for s in picture(fb.System.from_text(TWO_LOADS)).shapes if s.stroke and s.stroke.color == "force"]
    level = [line for line in lines if len(line) > 2 and float(np.ptp(line[:, 1])) < 1e-6]  # over the tails
    (left, low), (right, high) = sorted((float(line[:, 0].mean()), float(line[0, 1])) for line in level)
    assert left < right
    assert low < high


@pytest.mark.parametrize(
    ("own", "full"),
    [((2.0, 2.0), 5.0), ((5.0, 0.0), 5.0), ((-0.1, 0.0), 0.25), ((0.0, 0.0), 1.0)],  # 0.1 stands 2/5 as high as 5
)
def test_a_small_load_is_low_but_seen(own: tuple[float, float], full: float) -> None:
    assert full_height(own, [own, (2.0, 5.0)]) == pytest.approx(full)
