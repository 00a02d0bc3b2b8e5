"""Models in space: rotations and their named angles, tensors, frames, questions for vectors, and what is refused."""

from __future__ import annotations

import itertools
import math
import re
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrix
from freebody.numeric.spatial import tensor_of, turned_by
from posed import is_formula

SEED = 5
AXES = ("x", "y", "z", "-x", "-y", "-z")
UNIT = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1), "-x": (-1, 0, 0), "-y": (0, -1, 0), "-z": (0, 0, -1)}


def model(text: str) -> fb.System:
    return fb.System.from_text(text)


def rotation(axis: str, angle: float) -> np.ndarray:
    return matrix(angle * np.array(UNIT[axis], dtype=float))


def named_values(system: fb.System, R: np.ndarray) -> dict[str, float]:
    """The named angles of the only body when it is turned by R."""
    from freebody.numeric.rotation import rotation_vector

    reference = Reference(system)
    q = np.concatenate((np.zeros(3), rotation_vector(R)))
    snapshot = reference.snapshot(q, np.zeros(6))
    return {name: snapshot.value(measure) for name, measure in system.measures.items()}


# -- chains of rotations ------------------------------------------------------------------------
@pytest.mark.parametrize("axes", [a for a in itertools.product(AXES, repeat=3) if a[0][-1] != a[1][-1] != a[2][-1]])
def test_three_named_angles_are_those_of_the_rotation_they_make(axes: tuple[str, str, str]) -> None:
    body = f"{{box: {{mass: 1, size: [1, 2, 3]}}, turned: [a about {axes[0]}, b about {axes[1]}, c about {axes[2]}]}}"
    system = model(f"space: true\nbodies: {{it: {body}}}\n")
    is_euler = axes[0][-1] == axes[2][-1]
    a, b, c = 0.7, (1.1 if is_euler else -0.6), -2.2
    R = rotation(axes[0], a) @ rotation(axes[1], b) @ rotation(axes[2], c)
    found = named_values(system, R)
    assert found == pytest.approx({"a": a, "b": b, "c": c}, abs=1e-12)


@pytest.mark.parametrize(
    ("chain", "values"),
    [
        ("[30 deg about x, q about y, 40 deg about z]", {"q": -0.8}),
        ('"q about [1, 2, 2]"', {"q": 0.9}),
        ("[p about z, 25 deg about x, q about z]", {"p": 0.4, "q": -1.3}),
        ("[50 deg about y, p about -x, q about y, 10 deg about x]", {"p": 0.4, "q": -1.3}),
    ],
)
def test_one_or_two_named_angles_stand_among_known_rotations(chain: str, values: dict[str, float]) -> None:
    system = model(f"space: true\nbodies: {{it: {{box: {{mass: 1, size: [1, 2, 3]}}, turned: {chain}}}}}\n")
    number = Reference(system).number
    R = turned_by(system.bodies["it"].chain, values, number)
    assert named_values(system, R) == pytest.approx(values, abs=1e-12)


def test_the_reference_assembles_the_angles_of_the_start() -> None:
    system = model("""
space: {up: z}
bodies: {top: {cone: {mass: 1 kg, radius: 0.1 m, height: 0.2 m}, turned: [p about z, t about x, s about z]}}
connections: {tip: {spherical: [ground.O, top.apex]}}
start: {p: 20 deg, t: 35 deg, s: -50 deg, rate(t): 2, rate(s): 3, rate(p): -1}
""")
    reference = Reference(system)
    q = reference.assemble()
    v = reference.velocities(q)
    snapshot = reference.snapshot(q, v)
    values = [snapshot.value(m) for m in system.measures.values()]
    rates = [snapshot.rate(m) for m in system.measures.values()]
    assert np.degrees(values) == pytest.approx([20, 35, -50], abs=1e-9)
    assert rates == pytest.approx([-1, 2, 3], abs=1e-9)
    # omega = psi' e_z + theta' e_x' + phi' e_z'', Goldstein sec. 4.9
    p, t = math.radians(20), math.radians(35)
    omega = np.array(
        [
            2 * math.cos(p) + 3 * math.sin(t) * math.sin(p),
            2 * math.sin(p) - 3 * math.sin(t) * math.cos(p),
            -1 + 3 * math.cos(t),
        ]
    )
    assert reference.angular_velocity(q, v, "top") == pytest.approx(omega, abs=1e-9)


def test_too_few_named_angles_are_told_with_what_to_do() -> None:
    system = model("""
space: true
bodies: {b: {box: {mass: 1 kg, size: [1 m, 2 m, 3 m]}, turned: psi about z}}
questions: [acceleration of psi]
""")
    answer = fb.solve(system)["q1"]
    assert answer.expression is None
    assert "leave 6 degrees of freedom" in answer.reason
    assert "name three angles" in answer.reason


def test_equations_of_motion_say_where_the_named_angles_fail() -> None:
    top = fb.System.load(Path(__file__).parents[1] / "examples" / "spinning_top.yaml")
    assert fb.equations_of_motion(top).singular == ("sin(theta) = 0, where the angles of top are not determined",)


# -- bodies -----------------------------------------------------------------------------------
def tensor(body: str) -> np.ndarray:
    system = model(f"space: true\nbodies: {{it: {body}}}\n")
    return tensor_of(system.bodies["it"], Reference(system).number)


def test_tensors_of_solids_are_integrals_over_their_points() -> None:
    """By random points inside: I = m <|r|^2 1 - r r^T> about the mass centre."""
    rng = np.random.default_rng(SEED)
    n = 400_000
    u = rng.uniform(-1, 1, (n, 3))
    box = u * [0.15, 0.1, 0.05]
    ball = 0.2 * u[np.linalg.norm(u, axis=1) <= 1]
    inside = u[np.hypot(u[:, 0], u[:, 1]) <= 1]
    cylinder = inside * [0.1, 0.1, 0.2]
    height = (inside[:, 2:] + 1) / 2
    cone = np.hstack((0.1 * u[:, :2], (u[:, 2:] + 1) * 0.15))
    cone = cone[np.hypot(cone[:, 0], cone[:, 1]) <= 0.1 * cone[:, 2] / 0.3]
    assert height.min() >= 0
    for text, points in (
        ("{box: {mass: 2, size: [0.3, 0.2, 0.1]}}", box),
        ("{sphere: {mass: 2, radius: 0.2}}", ball),
        ("{cylinder: {mass: 2, radius: 0.1, length: 0.4}}", cylinder),
        ("{cone: {mass: 2, radius: 0.1, height: 0.3}}", cone),
    ):
        r = points - points.mean(axis=0)
        by_points = 2 * (np.eye(3) * (r**2).sum(axis=1).mean() - r.T @ r / len(r))
        assert tensor(text) == pytest.approx(by_points, rel=0.01, abs=1e-4), f"seed {SEED}: {text}"


def test_a_cylinder_lies_along_the_axis_that_is_given() -> None:
    upright = tensor("{cylinder: {mass: 2, radius: 0.1, length: 0.4}}")
    lying = tensor("{cylinder: {mass: 2, radius: 0.1, length: 0.4, axis: [0.6, 0, 0.8]}}")
    R = matrix(np.array([0, math.acos(0.8), 0]))
    assert lying == pytest.approx(R @ upright @ R.T, abs=1e-14)


def test_a_composite_is_the_sum_of_its_parts_moved_and_turned() -> None:
    text = """{composite: {parts: {
      one: {box: {mass: 2, size: [0.3, 0.2, 0.1]}, at: [0.2, 0.1, 0], turned: [30 deg about z, 20 deg about x]},
      two: {sphere: {mass: 3, radius: 0.1}, at: [0, -0.2, 0.3]}}}}"""
    whole = tensor(text)
    R = rotation("z", math.radians(30)) @ rotation("x", math.radians(20))
    parts = [
        (2.0, np.array([0.2, 0.1, 0.0]), R @ tensor("{box: {mass: 2, size: [0.3, 0.2, 0.1]}}") @ R.T),
        (3.0, np.array([0.0, -0.2, 0.3]), tensor("{sphere: {mass: 3, radius: 0.1}}")),
    ]
    middle = sum(m * r for m, r, _own in parts) / 5.0
    arms = [(m, r - middle, own) for m, r, own in parts]
    total = sum(own + m * (d @ d * np.eye(3) - np.outer(d, d)) for m, d, own in arms)
    assert whole == pytest.approx(total, abs=1e-14)


def test_a_tensor_about_another_point_is_moved_to_the_mass_centre() -> None:
    about_centre = np.diag([0.4, 0.5, 0.6])
    r = np.array([0.1, -0.2, 0.3])  # of the mass centre from the origin
    about_origin = about_centre + 2.0 * (r @ r * np.eye(3) - np.outer(r, r))
    rows = ", ".join(str(list(row)) for row in about_origin.tolist())
    found = tensor(f"{{body: {{mass: 2, center_of_mass: [0.1, -0.2, 0.3], inertia: [{rows}], about: origin}}}}")
    assert found == pytest.approx(about_centre, abs=1e-14)


# -- frames and vectors -----------------------------------------------------------------------
def test_vectors_are_answered_along_the_axes_of_a_body_or_a_frame(agrees: object) -> None:
    system = model("""
space: true
parameters: {w: 2 rad/s, r: 0.5 m, b: 30 deg}
frames: {tilted: {on: arm, turned: b about x}}
bodies: {arm: {body: {mass: 1 kg, inertia: [1, 1, 1]}, points: {P: [r, 0, 0]}}}
connections:
  hinge: {revolute: {first: ground.O, second: arm, about: y}}
  motor: {driver: {measure: psi, follows: w*t}}
measures: {psi: angle of arm about y}
""")
    agrees(fb.solve(system, "velocity of arm.P in arm"), "q1", ["0", "0", "-r*w"])  # type: ignore[operator]
    agrees(fb.solve(system, "velocity of arm.P"), "q1", ["-r*w*sin(w*t)", "0", "-r*w*cos(w*t)"])  # type: ignore[operator]
    # e_z of arm = -sin(b) e_y'... : its components along the tilted axes are (0, sin b, cos b)
    agrees(fb.solve(system, "velocity of arm.P in tilted"), "q1", ["0", "-r*w*sin(b)", "-r*w*cos(b)"])  # type: ignore[operator]
    agrees(fb.solve(system, "angular velocity of arm along tilted.y"), "q1", "w*cos(b)")  # type: ignore[operator]
    agrees(fb.solve(system, "acceleration of arm.P along arm.x"), "q1", "-r*w**2")  # type: ignore[operator]
    agrees(fb.solve(system, "size of angular velocity of arm"), "q1", "w")  # type: ignore[operator]


def test_a_closed_loop_that_is_too_long_for_formulas_is_answered_in_numbers() -> None:
    linkage = fb.System.load(Path(__file__).parents[1] / "examples" / "spherical_four_bar.yaml")
    solution = fb.solve(linkage, "angular velocity of rocker along far.z")
    (answer,) = solution.answers
    assert answer.expression is None
    assert answer.reason
    # by the cosine rule on the sphere, differentiated numerically
    a, b, c, d = (math.radians(x) for x in (30, 75, 70, 80))

    def rocker(psi: float, side: int) -> float:
        tip = np.array([math.sin(a) * math.cos(psi), math.sin(a) * math.sin(psi), math.cos(a)])
        R = matrix(np.array([0, d, 0]))
        e = R.T @ tip  # sin(c) (e_x cos phi + e_y sin phi) + cos(c) e_z = cos(b)
        size, angle = math.hypot(e[0], e[1]), math.atan2(e[1], e[0])
        return angle + side * math.acos((math.cos(b) - math.cos(c) * e[2]) / (math.sin(c) * size))

    psi = math.radians(40)
    rates = [2.0 * (rocker(psi + 1e-6, side) - rocker(psi - 1e-6, side)) / 2e-6 for side in (1, -1)]
    assert isinstance(answer.value, float)
    assert min(abs(answer.value - rate) for rate in rates) < 1e-6  # one of the two ways to assemble it


def test_draw_writes_a_picture_of_the_start(tmp_path: Path) -> None:
    top = fb.System.load(Path(__file__).parents[1] / "examples" / "spinning_top.yaml")
    path = top.draw(tmp_path / "top.svg", view=(10, 40), perspective=True)
    assert "<title" in path.read_text(encoding="utf-8")
    plane = fb.System.load(Path(__file__).parents[1] / "examples" / "slider_crank.yaml")
    assert plane.draw(tmp_path / "crank.png").stat().st_size > 5_000
    with pytest.raises(fb.InputError, match="for models in space"):
        plane.draw(tmp_path / "crank.png", perspective=True)
    with pytest.raises(fb.InputError, match=r"\.svg, \.png, \.pdf"):
        top.draw(tmp_path / "top.bmp")


@pytest.mark.parametrize("joint", ["prismatic: {first: p, second: q, along: y", "weld: {first: p, second: q"])
def test_axes_of_a_joint_point_the_same_way_and_not_against_each_other(joint: str) -> None:
    """Two bodies that stand parallel in the file: the rows of the joint, which are right angles, hold there too."""
    turned = ", second_axis: [0, -1, 0]}" if "prismatic" in joint else ", turned: [180 deg about x]}"
    text = f"""
space: true
bodies: {{p: {{sphere: {{mass: 1 kg, radius: 1 m}}}}, q: {{sphere: {{mass: 1 kg, radius: 1 m}}}}}}
connections: {{c: {{{joint}{turned}}}}}
"""
    reference = Reference(fb.System.from_text(text))
    q = reference.assemble()
    p, second = (matrix(q[list(reference.columns(body)[3:])]) @ reference.frame.principal[body].T for body in "pq")
    assert p[:, 1] @ second[:, 1] == pytest.approx(-1.0)


def test_a_plane_in_which_a_body_lies_on_its_side(agrees: object) -> None:
    """The axis x of p is the normal z of the plane, and y and z are its x and y at the start: what slides along y of p
    has the place c1_x + s cos(phi)."""
    text = """
space: true
bodies: {p: {sphere: {mass: 3 kg, radius: 1 m}}, q: {sphere: {mass: 3 kg, radius: 1 m}}}
connections:
  c1: {planar: {body: p, second_axis: x}}
  c0: {prismatic: {first: p, second: q, along: y}}
"""
    expected = "rate(c1_x) + rate(c0_travel)*cos(phi_c1) - c0_travel*rate(phi_c1)*sin(phi_c1)"
    agrees(fb.solve(model(text), "velocity of q along right"), "q1", expected)  # type: ignore[operator]


def test_a_planar_joint_across_another_axis_does_not_make_a_body_one_of_the_plane() -> None:
    text = """
space: true
bodies: {p: {sphere: {mass: 3 kg, radius: 1 m}}}
connections: {c1: {planar: {body: p, normal: x}}, c0: {pin: [ground.origin, p]}}
"""
    with pytest.raises(fb.ModelError, match="pin is a connection of the plane"):
        fb.System.from_text(text)


@pytest.mark.parametrize(
    ("kind", "instead"),
    [
        ("slider: {body: collar, along: [1, 2, -2]}", "a straight guide is prismatic: {first: ground.A"),
        ("slider: {body: collar, along: [1, 2, -2]}", "of a particle or of one point of a body point_on_line"),
        ("slot: {pin: collar, along: x}", "the guide of a point is point_on_line"),
        ("pin: [ground.A, collar]", "a hinge is revolute"),
        ("rolling: {body: collar, on: drum, crossed: true}", "the rim of a disk or a ring on planes and spheres"),
    ],
)
def test_a_guide_of_the_plane_is_told_what_it_is_called_in_space(kind: str, instead: str) -> None:
    text = f"""
space: {{up: z}}
ground: {{points: {{A: [0, 0, 3]}}}}
bodies:
  collar: {{{"disk: {mass: 2, radius: 1, axis: y}" if "rolling" in kind else "particle: {mass: 2}"}}}
  drum: {{cylinder: {{mass: 50, radius: 1, length: 3, axis: x}}, fixed: true, at: [0, 0, 0]}}
connections: {{rod: {{{kind}}}}}
"""
    with pytest.raises(fb.ModelError, match="is a connection of the plane: in space .*" + re.escape(instead)):
        fb.System.from_text(text)


def test_a_collar_slides_down_a_straight_rod_between_two_points_of_space() -> None:
    """A rod that falls by 2 on a length of 3: (2/3) g along it, (4/9) g down, and m g sqrt(5)/3 across."""
    text = """
space: {up: z}
ground: {points: {A: [0, 0, 3]}}
bodies: {collar: {particle: {mass: 2}}}
connections: {rod: {point_on_line: {point: collar, through: ground.A, along: [1, 2, -2]}}}
loads: {weight: {gravity: {strength: 9.81, along: -z}}}
measures: {h: z of collar}
start: {h: 3, rate(h): 0}
"""
    system = fb.System.from_text(text)
    assert system.solve("acceleration of h").answers[0].value == pytest.approx(-4 / 9 * 9.81, rel=1e-12)
    force = system.solve("reaction of rod").answers[0].value
    assert math.hypot(*force) == pytest.approx(2 * 9.81 * math.sqrt(5) / 3, rel=1e-12)


def test_the_angle_of_a_body_on_one_hinge_is_that_of_the_hinge() -> None:
    """The angle of an x axis in the plane of x and y says nothing of a table that turns about y."""
    table = """
space: true
parameters: {W: 2 rad/s, J: 3 kg m^2}
bodies: {table: {body: {mass: 1 kg, inertia: [2 kg m^2, J, 2 kg m^2]}}}
connections:
  axle: {revolute: {first: ground.O, second: table.center, about: AXIS}}
  motor: {driver: {measure: angle of table, follows: W*t^2/(2 s)}}
questions: [driving torque of motor]
"""
    for axis in ("up", "z", "[1, 1, 0]"):
        found = fb.solve(fb.System.from_text(table.replace("AXIS", axis))).answers[0]
        inertia = {"up": 3.0, "z": 2.0, "[1, 1, 0]": 2.5}[axis]
        assert found.value == pytest.approx(2.0 * inertia), axis


@pytest.mark.parametrize(
    "weld",
    [
        "[ground.A, mast.start]",
        "[mast.start, ground.A]",
        "{first: ground.A, second: mast.start, turned: [-90 deg about y]}",
    ],
)
def test_a_mast_is_welded_as_it_stands_and_its_clamp_holds_the_moment_about_the_foot(weld: str) -> None:
    # a force P at the height L, a load that rises to q: M = P L + (q L/2)(2 L/3) about -x
    system = fb.System.from_text(f"""
space: true
parameters: {{L: 2 m, P: 30 N, q: 60 N/m, m: 3 kg, g: 9.81 m/s^2}}
bodies: {{mast: {{rod: {{mass: m, length: L}}, turned: [-90 deg about y]}}}}
connections: {{foot: {{weld: {weld}}}}}
loads:
  weight: {{gravity: {{strength: g, along: [0, 0, -1]}}}}
  pull: {{force: {{at: mast.end, along: y, magnitude: P}}}}
  wind: {{distributed: {{between: [mast.start, mast.end], along: y, intensity: [0, q]}}}}
""")
    asked = ("moment of foot on mast", "moment of foot on mast about mast.end", "axial force of mast at center")
    at_foot, at_end, axial = (system.solve(question).answers[0] for question in asked)
    assert at_foot.value == pytest.approx((30 * 2 + 60 * 4 / 3, 0.0, 0.0), abs=1e-9)
    assert at_end.value == pytest.approx((-60 * 4 / 6, 0.0, 0.0), abs=1e-9)
    assert axial.value == pytest.approx(-3 * 9.81 / 2, rel=1e-9)


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_a_shaft_in_two_ball_bearings_turns_about_any_axis(axis: str) -> None:
    """A rod that is welded to it at the angle beta: T = m L^2/24 W^2 sin(beta)^2, and no torque."""
    lead = {"x": "[{}, 0, 0]", "y": "[0, {}, 0]", "z": "[0, 0, {}]"}[axis]
    turned = {"x": "beta about z", "y": "90 deg - beta about z", "z": "beta - 90 deg about y"}[axis]
    text = f"""
space: true
parameters: {{m: 3 kg, L: 0.6 m, beta: 35 deg, a: 0.2 m, b: 0.3 m, W: 40 rad/s}}
ground: {{points: {{A: [0, 0, 0]}}}}
bodies:
  shaft: {{body: {{}}, points: {{A: {lead.format("-a")}, B: {lead.format("b")}}}, at: {lead.format("a")}}}
  rod: {{rod: {{mass: m, length: L}}}}
connections:
  A: {{spherical: [ground.A, shaft.A]}}
  B: {{point_on_line: {{point: shaft.B, through: ground.A, along: {axis}}}}}
  hub: {{weld: {{first: shaft, second: rod, turned: {turned}}}}}
  motor: {{driver: {{measure: phi, follows: W*t}}}}
measures: {{phi: angle of shaft about {axis}}}
"""
    is_formula(text, "kinetic energy", "m*L^2*W^2*sin(beta)^2/24")
    is_formula(text, "size of reaction of B", "m*L^2*W^2*sin(beta)*cos(beta)/(12*(a + b))")
