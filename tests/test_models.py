"""What a model means where it leaves something unsaid: defaults, reference points, signs, starts."""

from __future__ import annotations

import itertools
import math
import re
from pathlib import Path

import pytest

import freebody as fb
from freebody.language.expression import evaluate
from freebody.study.answering.answer import NOT_VALID
from freebody.study.setup import Setup

EXAMPLES = Path(__file__).parents[1] / "examples"


def value(text: str, question: str) -> float | tuple[float, ...]:
    answer = fb.solve(fb.System.from_text(text), question)["q1"]
    assert answer.expression is not None, answer.reason
    assert answer.value is not None
    return answer.value


def test_spring_without_a_length_is_relaxed_at_the_start() -> None:
    # only gravity turns the rod: m L^2/3 alpha = -m g L/2
    text = """
parameters: {m: 3 kg, L: 1 m, k: 300 N/m, h: 0.3 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], S: [L, -h]}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {O: {pin: [ground.O, rod.start]}}
loads: {w: {gravity: g}, s: {spring: {first: ground.S, second: rod.end, stiffness: k}}}
measures: {theta: angle of rod}
start: {theta: 0, rate(theta): 0}
"""
    answer = fb.solve(fb.System.from_text(text), "angular acceleration of rod at start")["q1"]
    assert answer.to_plain()["expression"] == "-3*g/(2*L)"


def test_slots_that_say_nothing_else_pass_through_the_origin() -> None:
    # the centre moves on a circle of radius L/2 against the turn: H = m L^2/12 theta' - m L^2/4 theta'
    text = """
parameters: {m: 8 kg, L: 4 m, g: 9.81 m/s^2}
bodies: {ladder: {rod: {mass: m, length: L}}}
connections: {floor: {slot: {pin: ladder.start, along: right}}, wall: {slot: {pin: ladder.end, along: up}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of ladder from up}
start: {theta: 20 deg, rate(theta): 1 rad/s}
"""
    assert value(text, "angular momentum about ground.O") == pytest.approx(-8 * 16 / 6)
    assert value(text, "potential energy") == pytest.approx(8 * 9.81 * 2 * math.cos(math.radians(20)))


def test_reaction_on_the_ground_is_opposite_to_that_on_the_body() -> None:
    # tension 4 m g/3 on both sides of the pulley
    text = """
parameters: {m: 1 kg, g: 9.81 m/s^2}
bodies: {p: {disk: {radius: 0.1 m}}, A: {particle: {mass: m}}, B: {particle: {mass: 2*m}}}
connections: {ax: {pin: [ground.P, p]}, rope: {string: {from: A, over: [p], to: B}}}
loads: {w: {gravity: g}}
"""
    assert value(text, "vertical reaction of ax on ground") == pytest.approx(-8 * 9.81 / 3)
    assert value(text, "vertical reaction of ax on p") == pytest.approx(8 * 9.81 / 3)


def test_rim_of_a_body_is_about_its_origin_not_its_mass_centre() -> None:
    # G lies e below the centre of a rolling wheel: (I + m (R - e)^2) theta'' + m g e theta = 0
    m, inertia, R, e, g = 3, 0.05, 0.2, 0.05, 9.81
    text = f"""
parameters: {{m: {m} kg, I: {inertia} kg m^2, R: {R} m, e: {e} m, g: {g} m/s^2}}
ground: {{lines: {{floor: {{along: right}}}}}}
bodies: {{wheel: {{body: {{mass: m, inertia: I, radius: R, center_of_mass: [0, -e]}}}}}}
connections: {{c: {{rolling: {{body: wheel, on: floor}}}}}}
loads: {{w: {{gravity: g}}}}
measures: {{theta: angle of wheel}}
"""
    expected = 2 * math.pi * math.sqrt((inertia + m * (R - e) ** 2) / (m * g * e))
    assert value(text, "period of small oscillations") == pytest.approx(expected)


def test_absolute_value_keeps_its_sign_where_the_measure_is_negative() -> None:
    text = """
parameters: {m: 1 kg, F: 2 N, d: 1 m}
bodies: {b: {particle: {mass: m}}}
connections: {g: {slider: {body: b, along: right}}}
measures: {x: x of b}
start: {x: -0.5 m}
loads: {f: {law: {measure: x, force: F*abs(x)/d}}}
"""
    assert value(text, "acceleration of x") == pytest.approx(1.0)


def test_tie_of_a_frame_that_cannot_move() -> None:
    # half the load stands on each foot; moments of one leg about the top
    L, h, m, g, W, theta = 3, 1, 10, 9.81, 500, math.radians(25)
    text = """
parameters: {L: 3 m, h: 1 m, m: 10 kg, g: 9.81 m/s^2, theta: 25 deg, W: 500 N}
bodies:
  l: {rod: {mass: m, length: L}, points: {T: [h, 0]}}
  r: {rod: {mass: m, length: L}, points: {T: [h, 0]}, angle: 115 deg}
connections:
  A: {pin: [ground.A, l.start]}
  C: {pin: [l.end, r.end]}
  B: {slot: {pin: r.start, along: right}}
  tie: {link: [l.T, r.T]}
loads: {w: {gravity: g}, W: {force: {at: l.end, along: down, magnitude: W}}}
measures: {q: angle of l from up clockwise}
start: {q: theta}
"""
    expected = (m * g + W) * L * math.sin(theta) / (2 * (L / 2 - h) * math.cos(theta))
    assert value(text, "tension of tie") == pytest.approx(expected)
    assert value(text, "degrees of freedom") == 0


def test_velocity_ratio_of_a_six_bar_linkage_has_a_closed_form() -> None:
    text = """
ground: {points: {A: [0, 0], D: [4 m, 0], G: [7 m, 0]}}
bodies:
  b1: {rod: {length: 1.5 m}}
  b2: {rod: {length: 4 m}}
  b3: {rod: {length: 3 m}}
  b4: {rod: {length: 3.5 m}, near: {angle: -20 deg}}
  b5: {rod: {length: 2.5 m}, near: {angle: 80 deg}}
connections:
  A: {pin: [ground.A, b1.start]}
  B: {pin: [b1.end, b2.start]}
  C: {pin: [b2.end, b3.end]}
  D: {pin: [ground.D, b3.start]}
  E: {pin: [b3.center, b4.start]}
  F: {pin: [b4.end, b5.end]}
  G: {pin: [ground.G, b5.start]}
measures: {th: angle of b1}
start: {th: 60 deg}
"""
    answer = fb.solve(fb.System.from_text(text), "ratio of angular velocity of b5 to angular velocity of b1")["q1"]
    assert answer.expression is not None
    assert answer.evidence is not None
    assert answer.evidence.worst_relative_difference < 1e-9


def test_an_answer_says_when_the_models_own_numbers_break_its_condition() -> None:
    # F lifts a: the string would have to push, since T = m2 (2 m1 g - F)/(m1 + m2) < 0 for F > 2 m1 g = 19.62 N
    text = """
parameters: {m1: 1 kg, m2: 2 kg, F: FORCE, g: 9.81 m/s^2}
bodies: {p: {disk: {radius: 0.1 m}}, a: {particle: {mass: m1}}, b: {particle: {mass: m2}}}
connections: {ax: {pin: [ground.O, p]}, s: {string: {from: a, over: [p], to: b}}}
loads: {w: {gravity: g}, F: {force: {at: a, along: up, magnitude: F}}}
"""
    for force, is_broken in (("40 N", True), ("19 N", False)):
        answer = fb.solve(fb.System.from_text(text.replace("FORCE", force)), "tension of s at a")["q1"]
        assert any(note.startswith(NOT_VALID) for note in answer.notes) == is_broken


def test_a_fixed_body_is_where_it_is_said_to_be_near_by_both_routes() -> None:
    """A rod of 2 m leans with its end in a horizontal slot 1 m high, at 30 degrees, and a couple of 3 N m turns it: the
    slot bears 3 N m / (2 m cos 30 deg)."""
    text = """
bodies:
  p: {particle: {mass: 1 kg}, near: {at: [1 m, 1 m]}, fixed: true}
  r: {rod: {mass: 2 kg, length: 2 m}, near: {angle: 20 deg}}
connections:
  O: {pin: [ground.origin, r.start]}
  c: {slot: {pin: r.end, along: p.x}}
loads: {M: {torque: {on: r, magnitude: 3 N m}}}
"""
    assert value(text, "reaction of c along up") == pytest.approx(-math.sqrt(3))


def test_a_fixed_body_with_a_velocity_is_refused() -> None:
    text = "bodies: {p: {particle: {mass: 1 kg}, fixed: true, velocity: [%s m/s, 0]}, q: {particle: {mass: 1 kg}}}"
    with pytest.raises(fb.ModelError, match="p is fixed, so it has no velocity"):
        fb.System.from_text(text % "1")
    fb.System.from_text(text % "0")


def test_velocities_that_contain_several_speeds_are_those_of_the_start() -> None:
    """The end of a horizontal rod is in a slot that rises by 30 degrees; its mass centre, 1 m ahead of the end, has the
    velocity (v, 0). The end has (v, -w), which lies along the slot: w = -v tan 30 deg."""
    text = """
parameters: {v: 1 m/s}
ground: {lines: {rail: {along: 30 deg}}}
bodies: {p: {rod: {mass: 2 kg, length: 2 m}, angle: 0, velocity: [v, 0]}}
connections: {c: {slot: {pin: p.start, along: rail}}}
"""
    assert value(text, "angular velocity of p at start") == pytest.approx(-math.tan(math.pi / 6))
    assert value(text, "velocity of p.mass_center at start") == pytest.approx((1.0, 0.0))
    # a formula for every instant has the value of the start in numbers
    assert value(text, "speed of p.start") == pytest.approx(1.0 / math.cos(math.pi / 6))


def test_a_distance_and_an_angle_of_one_point_on_a_guide_are_one_freedom() -> None:
    """Only one of the two can be a coordinate; what the other would assume is no condition of an answer."""
    text = """
ground: {points: {A: [-1 m, 1 m], B: [-1 m, 0]}}
bodies: {p: {disk: {mass: 2 kg, radius: 1 m}}}
connections: {c: {slot: {pin: p, along: right}}}
measures:
  u: distance from ground.B to p
  w: angle of line from ground.A to p
"""
    assert value(text, "degrees of freedom") == 2
    momentum = fb.solve(fb.System.from_text(text), "linear momentum")["q1"].to_plain()
    assert momentum["expression"] == ["2*rate(u)", "0"]
    assert [condition["expression"] for condition in momentum["conditions"]] == ["u > 0"]


@pytest.mark.parametrize("corners", ["[[0, 1], [k, 0], [0, 1]]", "[[0, 0], [k, 2*k], [3*k, 6*k]]"])
def test_a_polygon_on_one_line_has_no_area_whatever_its_parameters_are(corners: str) -> None:
    with pytest.raises(fb.ModelError, match="enclose no area"):
        fb.System.from_text(f"parameters: {{k: m}}\nbodies: {{p: {{polygon: {{mass: 1 kg, corners: {corners}}}}}}}")


def test_equations_of_motion_of_what_cannot_be_assembled_are_refused_in_words() -> None:
    """Three joints and places that do not fit; without numbers the formulas would divide by zero."""
    text = """
space: true
ground: {points: {A: [1 m, 2 m, 0]}}
bodies:
  p:
    body: {mass: 1 kg, inertia: 3 kg m^2}
    at: [2 m, 0, 0.5 m]
    turned: [90 deg about x]
    points: {tip: [0, -1 m, 2 m]}
  r: {polygon: {mass: 0.5 kg, corners: [[0, 0.3], [10, 0], [0, 0.5]]}, at: [2 m, 1 m, 0]}
connections:
  c0: {constant_velocity: {first: p.tip, second: ground.A, about: down, second_axis: down}}
  c1: {planar: {body: r}}
  c2: {planar: {body: p}}
  again: {planar: {body: r, normal: r.x}}
"""
    with pytest.raises(fb.ModelError, match="cannot be assembled"):
        fb.System.from_text(text).equations_of_motion()


def test_a_speed_is_the_size_of_what_may_move_either_way() -> None:
    """A particle at rest on a vertical guide falls: its speed is |x'|, whichever way it goes, for every start."""
    text = """
bodies: {p: {particle: {mass: 1 kg}}}
connections: {c: {slider: {body: p, along: up}}}
loads: {g: {gravity: 9.81 m/s^2}}
"""
    (speed,) = fb.solve(fb.System.from_text(text), "speed of p").answers
    assert speed.to_plain()["expression"] == "abs(rate(c_travel))"
    assert speed.conditions == ("for all values",)
    assert value(text, "speed of p at start") == 0.0
    rubbed = text.replace("up}}}", "up}}, f: {dry_friction: {measure: height of p, force: 1 N}}}")
    assert fb.solve(fb.System.from_text(rubbed), "speed of p")["q1"].to_plain()["expression"] == "abs(rate(c_travel))"


def test_a_measure_at_a_dead_point_is_no_coordinate_though_it_is_named_first() -> None:
    text = """
parameters: {r: 1 m, L: 3 m}
bodies:
  crank: {rod: {mass: 1 kg, length: r}}
  rod: {rod: {mass: 1 kg, length: L}}
  piston: {particle: {mass: 2 kg}}
connections:
  O: {pin: [ground.origin, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  guide: {slider: {body: piston, along: right}}
measures: {x: x of piston, phi: angle of crank}
start: {phi: 0, rate(phi): 2}
"""
    answer = fb.solve(fb.System.from_text(text), "velocity of piston along right at start")
    assert answer.coordinates == ("phi",)
    assert answer["q1"].value == 0.0
    # x'' = -r w^2 (1 + r/L) at the outer dead point, where gravity is left out
    assert value(text, "acceleration of piston along right at start") == pytest.approx(-4.0 * (1 + 1 / 3))


def test_the_order_of_bodies_in_space_changes_no_formula() -> None:
    text = (EXAMPLES / "tilted_disk_on_shaft.yaml").read_text(encoding="utf-8")
    lines = text.splitlines(keepends=True)
    k = next(k for k, line in enumerate(lines) if line.startswith("  shaft:"))
    assert lines[k + 1].startswith("  disk:")
    swapped = "".join([*lines[:k], lines[k + 1], lines[k], *lines[k + 2 :]])
    first, second = (fb.System.from_text(t).solve().to_plain()["answers"] for t in (text, swapped))
    assert [a["expression"] for a in first] == [a["expression"] for a in second]


@pytest.mark.parametrize("name", ["wall", "a_wall", "zz"])
def test_what_a_wall_is_called_does_not_decide_whether_a_ladder_is_told_to_hold(name: str) -> None:
    text = (EXAMPLES / "ladder_rough_wall.yaml").read_text(encoding="utf-8")
    answer = fb.solve(fb.System.from_text(re.sub(r"\bwall\b", name, text)), "does it hold")["q1"]
    assert answer.to_plain()["expression"] == "mu**2*cos(alpha) + 2*mu*sin(alpha) - cos(alpha)"


def test_slopes_of_a_line_come_in_the_order_of_its_ends() -> None:
    """Not in that of a set of names, which is another one in every process."""
    names = [f"p{k}" for k in range(12)]
    bodies = "\n".join(f"  {n}: {{particle: {{mass: 1 kg}}, at: [{k} m, {k * k} m]}}" for k, n in enumerate(names))
    links = "\n".join(f"  c{k}: {{link: [{a}, {b}]}}" for k, (a, b) in enumerate(itertools.pairwise(names)))
    system = fb.System.from_text(f"bodies:\n{bodies}\nconnections:\n{links}\n")
    model = Setup(system, 2).model
    # d|b - a| by b before that by a: as the difference of their places is written
    orders = [[body for body, slot in model.gradient(row.measure) if slot == "x"] for row in system.constraint_rows]
    assert orders == [[b, a] for a, b in itertools.pairwise(names)]


def test_a_speed_and_the_size_of_a_reaction_are_derived_as_they_are_answered() -> None:
    """A bob that swings back: at the lowest point theta' is negative, and the speed L |theta'| is not."""
    system = fb.System.from_text("""
parameters: {m: kg, L: m, g: 9.81 m/s^2, theta0: 60 deg}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: {first: ground.origin, second: bob, length: L}}}
loads: {w: {gravity: g}}
measures: {theta: angle of line from ground.origin to bob from down}
start: {theta: theta0, rate(theta): 0}
questions: [speed of bob, speed of bob when theta = 0, size of reaction of rod]
""")
    told = system.explain().to_text()
    assert "There is no derivation" not in told
    assert "│θ'│" in told


@pytest.mark.parametrize(
    ("solid", "along"), [("down", "right"), ("up", "left"), ("left", "down"), ("right", "up"), ("-60 deg", "30 deg")]
)
def test_a_line_is_given_by_its_solid_side_as_by_its_direction(solid: str, along: str) -> None:
    """The solid side lies a quarter turn clockwise from the way the line points."""

    def free_side(line: str) -> list[float]:
        text = f"ground: {{lines: {{wall: {{{line}}}}}}}\nbodies: {{b: {{particle: {{mass: 1 kg}}}}}}"
        wall = fb.System.from_text(text).bodies["ground"].lines["wall"]
        return [evaluate(component, {}) for component in wall.direction.normal().components]

    assert free_side(f"solid: {solid}") == pytest.approx(free_side(f"along: {along}"), abs=1e-15)
