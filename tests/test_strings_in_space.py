"""Strings in space: over wheels in any plane they do what they do in the plane of x and y, and between axes that are
not parallel they run along the line in which the planes of the wheels meet."""

from __future__ import annotations

import functools
import math
from typing import Any

import numpy as np
import pytest

import freebody as fb
from example_files import FOLDER
from freebody.errors import ModelError
from freebody.narrative.marking.acting import free_bodies
from posed import is_formula

M1, M2, J, R, G = 1.3, 2.1, 0.45, 0.4, 9.81


def answers(text: str) -> dict[str, Any]:
    """The values of all questions, by name."""
    return values_of(fb.System.from_text(text))


def values_of(system: fb.System) -> dict[str, Any]:
    found = {answer.id: answer.value for answer in system.solve().answers}
    assert None not in found.values(), found
    return found


def turned_on(text: str, shift: int) -> str:
    """Axes called otherwise: x, y and z become y, z and x."""
    names = "xyz"[shift:] + "xyz"[:shift]
    return text.replace("<x>", names[0]).replace("<y>", names[1]).replace("<z>", names[2])


def at(shift: int, x: object, y: object, z: object = 0) -> str:
    """Components along the axes that are called otherwise."""
    place = np.roll(np.array([x, y, z], dtype=object), shift)
    return "[" + ", ".join(map(str, place)) + "]"


QUESTIONS = """
questions:
  - {id: acceleration, find: acceleration of s at start}
  - {id: first, find: tension of rope at {first} at start}
  - {id: last, find: tension of rope at b at start}
  - {id: bearing, find: reaction of bearing at start}
"""


def atwood(shift: int) -> str:
    """Two masses on a string over a pulley with inertia, which turns about what z is called."""
    return turned_on(
        f"""
space: {{up: <y>}}
ground: {{points: {{A: {at(shift, 0, 2)}}}}}
bodies:
  pulley: {{body: {{mass: 3 kg, inertia: [{J}, {J}, {J}], radius: {R}}}}}
  a: {{particle: {{mass: {M1}}}}}
  b: {{particle: {{mass: {M2}}}}}
connections:
  bearing: {{revolute: {{first: ground.A, second: pulley, about: <z>}}}}
  rope: {{string: {{from: a, over: [pulley], to: b}}}}
measures: {{s: <y> of b}}
loads: {{weight: {{gravity: {{strength: {G}, along: -<y>}}}}}}
start: {{s: 0}}
"""
        + QUESTIONS.replace("{first}", "a"),
        shift,
    )


@pytest.mark.parametrize("shift", range(3))
def test_atwoods_machine_in_any_plane_falls_as_the_inertia_of_its_pulley_lets_it(shift: int) -> None:
    found = answers(atwood(shift))
    a = (M2 - M1) * G / (M1 + M2 + J / R**2)
    assert found["acceleration"] == pytest.approx(-a, rel=1e-12)
    assert found["first"] == pytest.approx(M1 * (G + a), rel=1e-12)
    assert found["last"] == pytest.approx(M2 * (G - a), rel=1e-12)
    up = np.roll([0.0, 1.0, 0.0], shift)
    assert found["bearing"] == pytest.approx((3 * G + M1 * (G + a) + M2 * (G - a)) * up, rel=1e-12, abs=1e-12)


def boom(shift: int | None) -> str:
    """A boom held by a cable over a pulley to a load: the lead swings. None: the model of the plane."""
    in_plane = shift is None
    k = shift or 0
    rest = """
loads: {weight: {gravity: {strength: 9.81, along: -<y>}}}
start: {theta: 20 deg, s: -0.3}
"""
    if in_plane:
        head = """
ground: {points: {W: [0, 0], P: [1.5, 1]}}
bodies:
  boom: {rod: {mass: 5, length: 1.2}}
  pulley: {body: {mass: 2, inertia: 0.02, radius: 0.1}}
  b: {particle: {mass: 2}}
connections:
  axle: {pin: [ground.W, boom.start]}
  bearing: {pin: [ground.P, pulley]}
  rope: {string: {path: [boom.end, over pulley, b]}}
measures: {theta: angle of boom, s: y of b}
"""
        return (head + rest).replace("along: -<y>", "along: down")
    body = "{mass: 5, inertia: [0.6, 0.6, 0.6]}"  # of the rod: 5 1.2^2/12 = 0.6
    return turned_on(
        f"""
space: {{up: <y>}}
ground: {{points: {{W: [0, 0, 0], P: {at(k, 1.5, 1)}}}}}
bodies:
  boom: {{body: {body}, points: {{start: {at(k, -0.6, 0)}, end: {at(k, 0.6, 0)}}}}}
  pulley: {{body: {{mass: 2, inertia: [0.02, 0.02, 0.02], radius: 0.1}}}}
  b: {{particle: {{mass: 2}}}}
connections:
  axle: {{revolute: {{first: ground.W, second: boom.start, about: <z>}}}}
  bearing: {{revolute: {{first: ground.P, second: pulley, about: <z>}}}}
  rope: {{string: {{path: [boom.end, over pulley, b]}}}}
measures: {{theta: angle of boom about <z>, s: <y> of b}}
"""
        + rest,
        k,
    )


@functools.cache
def swung(shift: int | None) -> fb.Simulation:
    return fb.simulate(fb.System.from_text(boom(shift)), 0.3, tolerance=1e-11)


@pytest.mark.parametrize("shift", range(3))
def test_a_lead_that_swings_in_any_plane_moves_and_pulls_as_in_the_plane(shift: int) -> None:
    flat, turned = swung(None), swung(shift)
    for name in ("s", "theta", "rope.boom_to_pulley", "rope.pulley_to_b"):
        for k in (0, -1):
            assert turned.dataset[name].values[k] == pytest.approx(flat.dataset[name].values[k], rel=1e-7), name
    assert abs(flat.dataset["s"].values[-1] + 0.3) > 0.05
    for axis, own in zip("xy", (k % 3 for k in (shift, shift + 1)), strict=True):
        force = turned.dataset[f"bearing.{'xyz'[own]}"].values[-1]
        assert force == pytest.approx(flat.dataset[f"bearing.{axis}"].values[-1], rel=1e-7)


def test_a_winch_in_the_plane_of_x_and_z_lifts_with_what_its_torque_leaves() -> None:
    """M - T_1 R = J_d phi'', (T_2 - T_1) r = -J_p a/r, T_2 - m g = m a, a = R phi''."""
    m, J_d, J_p, R_d, r, M = 50.0, 2.0, 0.3, 0.2, 0.1, 150.0
    found = answers(
        f"""
space: {{up: z}}
ground: {{points: {{W: [0, 0, 0], P: [1, 0, 3]}}}}
bodies:
  drum: {{body: {{mass: 20, inertia: [{J_d}, {J_d}, {J_d}], radius: {R_d}}}}}
  pulley: {{body: {{mass: 2, inertia: [{J_p}, {J_p}, {J_p}], radius: {r}}}}}
  b: {{particle: {{mass: {m}}}, at: [{1 + r}, 0, 0]}}
connections:
  axle: {{revolute: {{first: ground.W, second: drum, about: y}}}}
  bearing: {{revolute: {{first: ground.P, second: pulley, about: y}}}}
  rope: {{string: {{path: [wound on drum at left, over pulley, b]}}}}
measures: {{s: z of b}}
loads:
  weight: {{gravity: {{strength: {G}, along: -z}}}}
  motor: {{torque: {{on: drum, about: y, magnitude: {-M}}}}}
"""
        + QUESTIONS.replace("{first}", "drum")
    )
    a = (M / R_d - m * G) / (m + J_d / R_d**2 + J_p / r**2)
    before, after = (M - J_d * a / R_d) / R_d, m * (G + a)
    assert (found["acceleration"], found["first"], found["last"]) == pytest.approx((a, before, after), rel=1e-10)
    # along the tangent that touches drum and pulley on the left: C_2 - C_1 = l e + (R - r) n, and n is to the left of e
    angle = math.atan2(3.0, 1.0) - math.asin((R_d - r) / math.hypot(1.0, 3.0))
    bearing = before * np.array([math.cos(angle), 0.0, math.sin(angle)]) + np.array([0.0, 0.0, after + 2 * G])
    assert found["bearing"] == pytest.approx(bearing, rel=1e-9, abs=1e-9)


def test_a_cable_round_a_corner_draws_the_masses_and_half_the_wheels() -> None:
    found = values_of(fb.System.from_text((FOLDER / "cable_round_a_corner.yaml").read_text()))
    m1, m2, half1, half2 = 30.0, 10.0, 4.0, 2.0
    a = m2 * G / (m1 + m2 + half1 + half2)
    behind, between, ahead = m1 * a, (m1 + half1) * a, m2 * (G - a)
    assert between == pytest.approx(ahead - half2 * a, rel=1e-12)
    assert found["acceleration"] == pytest.approx(a, rel=1e-12)
    tensions = [found[key] for key in ("behind", "between", "ahead")]
    assert tensions == pytest.approx([behind, between, ahead], rel=1e-12)
    assert found["axle"] == pytest.approx(np.array([behind, -between, 2 * half1 * G]), rel=1e-12)


def test_a_moving_pulley_that_is_guided_halves_what_it_carries() -> None:
    """4 m a + M a + J (1 + 4)/r^2 a/... with a of the hook: wheels turn by a/r and 2 a/r, the load moves by 2 a."""
    m, M, J_w, r = 2.0, 5.0, 0.02, 0.1
    found = answers(
        f"""
space: {{up: z}}
ground: {{points: {{A: [0, {-2 * r}, 3], P: [0, {r}, 3], G: [0, {-r}, 0]}}}}
bodies:
  hook: {{box: {{mass: {M}, size: [0.1, 0.1, 0.1]}}, near: {{at: [0, {-r}, 1]}}}}
  moving: {{body: {{mass: 1, inertia: [{J_w}, {J_w}, {J_w}], radius: {r}}}}}
  pulley: {{body: {{mass: 1, inertia: [{J_w}, {J_w}, {J_w}], radius: {r}}}}}
  b: {{particle: {{mass: {m}}}}}
connections:
  guide: {{prismatic: {{first: ground.G, second: hook, along: z}}}}
  axle: {{revolute: {{first: hook, second: moving, about: x}}}}
  bearing: {{revolute: {{first: ground.P, second: pulley, about: x}}}}
  rope: {{string: {{path: [ground.A, under moving, over pulley, b]}}}}
measures: {{s: z of hook, z_b: z of b}}
loads: {{weight: {{gravity: {{strength: {G}, along: -z}}}}}}
start: {{s: 1, z_b: 1}}
"""
        + QUESTIONS.replace("{first}", "A")
    )
    a = (2 * m - (M + 1)) * G / (4 * m + M + 1 + J_w * (1 + 4) / r**2)
    last = m * (G - 2 * a)
    middle = last - 2 * J_w * a / r**2
    assert found["acceleration"] == pytest.approx(a, rel=1e-10)
    assert (found["first"], found["last"]) == pytest.approx((middle - J_w * a / r**2, last), rel=1e-10)


def test_what_turns_a_wheel_does_not_act_on_the_carriage_that_bears_it() -> None:
    """Two leads pull back the wheel of a carriage, T_1 and T_2 at r above and below: (T_1 - T_2) r turns the wheel, and
    the rail of the carriage holds no moment."""
    found = answers("""
space: true
ground: {points: {O: [0, 0, 0], Q: [-2, 0.2, 0], L: [0, -0.2, 0]}}
bodies:
  carriage: {body: {mass: 3, inertia: [1, 1, 1]}}
  wheel: {body: {mass: 4, inertia: [0.1, 0.1, 0.1], radius: 0.2}}
  block: {box: {mass: 2, size: [0.1, 0.1, 0.1]}, near: {at: [-1, -0.2, 0]}}
connections:
  rail: {prismatic: {first: ground.O, second: carriage, along: x}}
  axle: {revolute: {first: carriage, second: wheel, about: z}}
  low: {prismatic: {first: ground.L, second: block, along: x}}
  rope: {string: {path: [ground.Q, around wheel, block]}}
loads: {pull: {force: {at: carriage, along: x, magnitude: 60}}}
measures: {s: {travel of carriage along x from ground.O}}
start: {s: 0, rate(s): 0}
questions:
  - {id: first, find: tension of rope at Q at start}
  - {id: last, find: tension of rope at block at start}
  - {id: rail, find: reaction moment of rail at start}
""")
    a = 60 / (4 * 2 + 3 + 4 + 0.1 / 0.2**2)
    assert found["last"] == pytest.approx(2 * 2 * a, rel=1e-12)
    assert found["first"] == pytest.approx(found["last"] + 0.1 * a / 0.2**2, rel=1e-12)
    assert found["rail"] == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)


def test_an_end_that_may_leave_the_plane_of_its_wheel_is_refused() -> None:
    text = atwood(0).replace(f"a: {{particle: {{mass: {M1}}}}}", f"a: {{particle: {{mass: {M1}}}, at: [1, 0, 0.2]}}")
    with pytest.raises(ModelError, match="nothing keeps a in the plane of pulley"):
        fb.System.from_text(text)


def test_wheels_whose_planes_do_not_meet_in_the_tangent_are_told_where_they_belong() -> None:
    text = (FOLDER / "cable_round_a_corner.yaml").read_text().replace("B: [r1, b, -r2]", "B: [0, b, -r2]")
    with pytest.raises(ModelError, match=r"put upright_wheel .* along the axis of upright_wheel \(now 0 m\)"):
        fb.System.from_text(text)


def test_a_wheel_whose_axis_tilts_carries_no_string() -> None:
    text = """
space: true
bodies:
  frame: {body: {mass: 1, inertia: [1, 1, 1]}}
  pulley: {body: {mass: 1, inertia: [1, 1, 1], radius: 0.1}}
  b: {particle: {mass: 1}}
connections:
  hinge: {revolute: {first: ground.A, second: frame, about: x}}
  bearing: {revolute: {first: frame, second: pulley, about: z}}
  rope: {string: {from: ground.B, over: [pulley], to: b}}
ground: {points: {A: [0, 0, 0], B: [-1, 0, 0]}}
"""
    with pytest.raises(ModelError, match="the axis of pulley does not keep its direction"):
        fb.System.from_text(text)


def test_a_cable_pulls_at_a_wheel_where_it_leaves_it() -> None:
    """At the rim, C + s R e x n: on the level wheel at -y, where it comes, and at x, where it leaves."""
    system = fb.System.from_text((FOLDER / "cable_round_a_corner.yaml").read_text())
    acting = free_bodies(system, ("level_wheel",)).outside
    places = {tuple(np.round(force.at, 9).tolist()) for force in acting if force.source == "cable"}
    assert places == {(0.0, -0.5, 0.0), (0.5, 0.0, 0.0)}


@pytest.mark.parametrize("cable", ["string: {from: boom.end, to: ground.X}", "link: [boom.end, ground.X]"])
def test_a_cable_without_a_length_has_that_of_the_figure_as_a_formula(cable: str) -> None:
    """2 T h/sqrt(b^2 + c^2 + h^2) = W: the vertical balance of the boom's end on two cables."""
    system = f"""
space: true
parameters: {{b: 6 m, c: 3 m, h: 4 m, W: 5 kN}}
ground: {{points: {{A: [0, 0, 0], C: [0, c, h], D: [0, -c, h]}}}}
bodies: {{boom: {{rod: {{length: b}}, at: [b/2, 0, 0]}}}}
connections:
  foot: {{spherical: [ground.A, boom.start]}}
  one: {{{cable.replace("X", "C")}}}
  two: {{{cable.replace("X", "D")}}}
loads: {{load: {{force: {{at: boom.end, along: [0, 0, -1], magnitude: W}}}}}}
"""
    is_formula(system, "tension of one", "W*sqrt(b^2 + c^2 + h^2)/(2*h)")
    is_formula(system, "value of h for which tension of one = W", "sqrt((b^2 + c^2)/3)")


def test_what_hangs_hangs_straight_down_where_gravity_is_given_on_a_fixed_body() -> None:
    """m2 g = (m1 + m2 + M1/2 + M2/2) a for the example, whichever fixed body the direction of gravity is named on."""
    text = (FOLDER / "cable_round_a_corner.yaml").read_text()
    text = text.replace("along: -z}", "along: lab.y}")
    text = text.replace(
        "bodies:\n", "bodies:\n  lab: {body: {}, fixed: true, at: [1 m, 0, 0], turned: [-90 deg about x]}\n", 1
    )
    found = values_of(fb.System.from_text(text))
    assert found["acceleration"] == pytest.approx(10 * G / (30 + 10 + 4 + 2), rel=1e-9)
