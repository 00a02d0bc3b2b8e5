"""Files as somebody writes them who has read nothing: the numbers of a figure, by the words of a textbook."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.language.expression import evaluate

G = 9.81


def answer(text: str, question: str) -> float:
    value = fb.System.from_text(text).solve(question)["q1"].value
    return float(math.hypot(*value) if isinstance(value, list | tuple) else value)


@pytest.mark.parametrize("excitation", ["10 N * sin(3*t)", "10 N*sin(3 * t)"])
def test_an_oscillator_is_told_by_its_numbers(excitation: str) -> None:
    # X = F0/sqrt((k - m Omega^2)^2 + (c Omega)^2) (Thomson, Theory of Vibration, sec. 3.1)
    text = f"system: a machine\nmass: 2 kg\nstiffness: 50 N/m\ndamping: 4 N s/m\nforce: {excitation}\n"
    assert answer(text, "natural frequency") == pytest.approx(5.0)
    assert answer(text, "damping ratio") == pytest.approx(4 / (2 * 2 * 5))
    assert answer(text, "steady amplitude") == pytest.approx(10 / math.hypot(50 - 18, 12))
    assert fb.System.from_text(text).title == "a machine"


def test_an_oscillator_starts_where_its_numbers_say() -> None:
    # without damping x = x0 cos(w t)
    text = "m: 2 kg\nk: 50 N/m\nx0: 5 cm\n"
    assert answer(text, "x after 1 s") == pytest.approx(0.05 * math.cos(5.0))


def test_a_pendulum_is_told_by_its_numbers() -> None:
    # m v^2/L = T - m g at the bottom, v^2 = 2 g L (1 - cos theta0)
    text = "pendulum: {length: 1 m, mass: 2 kg, angle: 10 deg}\ngravity: 9.81\n"
    assert answer(text, "tension at the bottom") == pytest.approx(2 * G * (3 - 2 * math.cos(math.radians(10))))
    assert answer(text, "natural frequency") == pytest.approx(math.sqrt(G))
    told = "pendulum is a point mass, bob, on a link without mass, cord; theta counts from down"
    assert told in map(str, fb.System.from_text(text).assumptions)


@pytest.mark.parametrize("gravity", ["9.81", "9.81 m/s^2", "g"])
def test_a_block_on_an_incline_needs_no_section(gravity: str) -> None:
    # a = g (sin alpha - mu cos alpha)
    own = "parameters: {g: 9.81 m/s^2}\n" if gravity == "g" else ""
    text = f"{own}incline: {{angle: 30 deg, mu: 0.2}}\nblock: {{mass: 2 kg, on: incline}}\ngravity: {gravity}\n"
    assert answer(text, "acceleration of block") == pytest.approx(G * (0.5 - 0.2 * math.sqrt(0.75)))


def test_masses_on_a_rope_say_their_masses_alone() -> None:
    # a = g (m1 - m2)/(m1 + m2 + M/2)
    text = """
bodies: {m1: 3 kg, m2: 2 kg}
pulley: {mass: 1 kg, radius: 0.1 m}
rope: [m1, pulley, m2]
gravity: 9.81
"""
    assert answer(text, "acceleration of m1") == pytest.approx(G / 5.5)
    assert answer(text, "tension of rope at m1") == pytest.approx(3 * G * (1 - 1 / 5.5))


COLLISION = """
parameters: {u: -4 m/s}
bodies: {A: {mass: 2 kg, velocity: FIRST}, B: {mass: 1 kg, velocity: SECOND}}
collision: {between: [A, B], e: 0.5}
"""


@pytest.mark.parametrize(
    ("first", "second", "left"), [("3 m/s", "-1 m/s", "A"), ("0 m/s", "4 m/s", "B"), ("u", "0", "B"), ("-u", "0", "A")]
)
@pytest.mark.parametrize("gravity", ["", "gravity: 9.81\n"])
def test_what_collides_on_a_line_says_its_speeds_as_numbers(first: str, second: str, left: str, gravity: str) -> None:
    # momentum is kept, and e (u1 - u2) is how fast they part; half the reduced mass times (1 - e^2)(u1 - u2)^2 is lost
    text = COLLISION.replace("FIRST", first).replace("SECOND", second) + gravity
    one, two = ({"u": -4.0, "-u": 4.0}.get(each) or float(each.split()[0]) for each in (first, second))
    mean = (2 * one + two) / 3
    system = fb.System.from_text(text)
    after = [system.solve(f"velocity of {body} after the impact")["q1"].value[0] for body in "AB"]
    assert after == pytest.approx([mean - 0.5 * (one - two) / 3, mean + 0.5 * 2 * (one - two) / 3])
    assert answer(text, "energy lost in the impact") == pytest.approx(0.5 * 2 / 3 * 0.75 * (one - two) ** 2)
    right = "B" if left == "A" else "A"
    told = f"{left} is on the left of {right}, by gap_{left}_{right} = 1 m"
    assert told in map(str, system.assumptions)


BEAM = """
beam: {length: 6 m}
supports: {A: {x: 0, type: pinned}, B: {x: 6 m, type: roller}}
loads: LOADS
"""


@pytest.mark.parametrize(
    "loads",
    [
        "[{P: 10 kN, x: 2 m}, {w: 2 kN/m, from: 3 m, to: 6 m}, {M: 3 kN m, x: 4 m}]",
        "{one: {force: 10 kN, at: 2 m}, two: {q: 2 kN/m, from: 3 m, to: 6 m}, three: {M: 3 kN m, at: 4 m}}",
    ],
)
def test_loads_of_a_beam_are_known_by_their_units(loads: str) -> None:
    # moments about A: 6 B = 10*2 + 6*4.5 - 3 (a couple counter-clockwise lifts the right end)
    text = BEAM.replace("LOADS", loads)
    assert answer(text, "vertical reaction of B") == pytest.approx((20 + 27 - 3) / 6 * 1e3)
    assert answer(text, "vertical reaction of A") == pytest.approx((16 - 44 / 6) * 1e3)


ARM = """
name: two link arm
parameters: {m1: 2 kg, L1: 0.5 m, m2: 1 kg, L2: 0.4 m, tau: 3 N m}
gravity: 9.81
links: [{name: link1, mass: m1, length: L1}, {name: link2, mass: m2, length: L2}]
joints:
  - {name: shoulder, type: revolute, parent: PARENT, child: link1, torque: tau}
  - {name: elbow, type: revolute, parent: link1, child: link2}
initial: {shoulder: 0 deg, elbow: 90 deg}
"""


@pytest.mark.parametrize("parent", ["ground", "base", "world"])
def test_links_of_a_robot_hang_on_each_other_by_their_ends(parent: str) -> None:
    # M q'' = (tau, 0) - G with the elbow at a right angle (Spong, Robot Modeling and Control, sec. 7.4)
    m1, L1, m2, L2 = 2, 0.5, 1, 0.4
    m11, m12, m22 = m1 * L1**2 / 3 + m2 * (L1**2 + L2**2 / 3), m2 * L2**2 / 3, m2 * L2**2 / 3
    pull = 3 - (m1 / 2 + m2) * G * L1
    found = answer(ARM.replace("PARENT", parent), "angular acceleration of link1")
    assert found == pytest.approx(pull * m22 / (m11 * m22 - m12**2))


def test_a_rod_that_is_pinned_by_its_plain_name_is_held_in_its_middle_and_that_is_told() -> None:
    system = fb.System.from_text(
        "bodies: {bar: {rod: {mass: 1 kg, length: 1 m}}}\nconnections: {hinge: {pin: [ground, bar]}}\n"
    )
    assert "hinge holds bar in its middle; its ends are bar.start, bar.end" in map(str, system.assumptions)


def test_a_place_that_a_joint_gives_may_be_said_as_well() -> None:
    text = """
parameters: {m: 5 kg, M: 900 kg, L: 2 m, F: 1 kN, g: 9.81 m/s^2}
bodies:
  truck: {body: {mass: M}, points: {tower: [0.5 m, 2.5 m]}}
  pole: {rod: {mass: m, length: L}, at: {start: truck.tower}, angle: -90 deg}
connections: {road: {slider: {body: truck, along: right}}, hinge: {pin: [truck.tower, pole.start]}}
loads: {w: {gravity: g}, F: {force: {at: truck, along: right, magnitude: F}}}
"""
    # a pole that hangs: M a + m (a + L alpha/2) = F and alpha = -3 a/(2 L), so that it counts as m/4
    assert answer(text, "acceleration of truck") == pytest.approx(1000 / (900 + 5 / 4))
    with pytest.raises(fb.ModelError, match=r"follows from what joins both"):
        fb.System.from_text(text.replace("pin: [truck.tower", "pin: [truck.origin"))


def test_a_boom_is_put_by_its_socket_and_its_end() -> None:
    # 2 T (3/s) = W with s = sqrt(L^2 + 3^2 + 2^2), and the socket takes 2 T L/s
    text = """
space: true
parameters: {W: 6 kN, L: 4 m}
ground: {points: {A: [0, 0, 0], D: [0, 3 m, 2 m], E: [0, 3 m, -2 m]}}
bodies: {boom: {rod: {length: L}, at: {start: A, end: [L, 0, 0]}}}
connections:
  foot: {spherical: [ground.A, boom.start]}
  cable1: {link: [boom.end, ground.D]}
  cable2: {link: [boom.end, ground.E]}
loads: {load: {force: {at: boom.end, along: down, magnitude: W}}}
"""
    assert answer(text, "tension of cable1") == pytest.approx(1e3 * math.sqrt(29))
    assert answer(text, "reaction of foot") == pytest.approx(8e3)


def test_two_places_of_a_body_in_space_are_refused_with_the_one_to_write() -> None:
    """They leave its turn about the line between them open, which only a rod does not have."""
    text = (
        "space: true\nbodies: {b: {box: {size: [4 m, 1 m, 1 m]}, points: {P: [2 m, 0, 0]}, "
        "at: {center: [0, 0, 0], P: [2 m, 0, 0]}}}\n"
    )
    with pytest.raises(fb.ModelError, match=r"in space at puts one point, at: \{P: \[2 m, 0, 0\]\}; joints put"):
        fb.System.from_text(text)


@pytest.mark.parametrize(
    "rod",
    [
        "{rod: {mass: 6 kg, from: [0, 0, 0], to: [2 m, 3 m, -6 m]}}",
        "{rod: {mass: 6 kg}, from: [0, 0, 0], to: [2 m, 3 m, -6 m]}",
        "{from: [0, 0, 0], to: [2 m, 3 m, -6 m], mass: 6 kg}",
        "{rod: {mass: 6 kg, length: 7 m}, at: {start: ground.A, end: B}}",
    ],
)
def test_a_rod_in_space_is_put_by_its_two_ends(rod: str) -> None:
    """2^2 + 3^2 + 6^2 = 7^2."""
    text = f"space: true\nground: {{points: {{A: [0, 0, 0], B: [2 m, 3 m, -6 m]}}}}\nbodies: {{bar: {rod}}}\n"
    motion = fb.System.from_text(text + "measures: {x: x of bar.end, y: y of bar.end, z: z of bar.end}\n").simulate(
        1e-3
    )
    assert [motion[axis][0] for axis in "xyz"] == pytest.approx([2, 3, -6])


@pytest.mark.parametrize(("end", "x"), [("[2 m, 0, 0]", 2), ("[-2 m, 0, 0]", -2)])
def test_a_rod_in_space_along_an_axis(end: str, x: float) -> None:
    text = f"space: true\nbodies: {{bar: {{from: [0, 0, 0], to: {end}, mass: 6 kg}}}}\nmeasures: {{x: x of bar.end}}\n"
    assert fb.System.from_text(text).simulate(1e-3)["x"][0] == pytest.approx(x)


def test_a_rod_in_space_that_a_cable_holds() -> None:
    """Moments about its foot: T 4 m = W 1.5 m."""
    text = """
space: {up: z}
bodies: {rod: {from: [0, 0, 0], to: [0, 3 m, 4 m], mass: 6 kg}}
ground: {points: {O: [0, 0, 0], P: [0, 0, 4 m]}}
connections: {foot: {spherical: [ground.O, rod.start]}, cable: {string: {from: rod.end, to: ground.P}}}
loads: {weight: {gravity: 9.81 m/s^2}}
"""
    assert answer(text, "tension of cable") == pytest.approx(6 * 9.81 * 1.5 / 4)


BEVELS = """
space: true
ground: {points: {A: [90 mm, 0, 0], B: [0, 30 mm, 0]}}
bodies:
  pinion: {gear: {teeth: 15, module: 4 mm, inertia: 0.01 kg m^2AXIS}}
  wheel: {gear: {teeth: 45, module: 4 mm, axis: y, inertia: 0.2 kg m^2}}
connections:
  a: {revolute: {first: ground.A, second: pinion, about: x}}
  b: {revolute: {first: ground.B, second: wheel, about: y}}
  mesh: {bevel_gears: [pinion, wheel]}
measures: {phi: angle of pinion about x}
loads: {M: {torque: {on: pinion, about: x, magnitude: 3 N m}}}
"""


@pytest.mark.parametrize("axis", [", axis: x", ""])
def test_bevel_gears_have_the_teeth_and_the_radius_of_their_wheels(axis: str) -> None:
    # the wheel counts (15/45)^2 times at the pinion, and the tooth force is (M - I phi'')/r with r = 30 mm
    text = BEVELS.replace("AXIS", axis)
    turning = 3 / (0.01 + 0.2 / 9)
    assert answer(text, "acceleration of phi") == pytest.approx(turning)
    assert answer(text, "tooth force of mesh") == pytest.approx((3 - 0.01 * turning) / 0.03)
    told = [str(each) for each in fb.System.from_text(text).assumptions]
    assert ("pinion has the axis of its bearing, x" in told) is (axis == "")


def test_bevel_gears_by_teeth_alone_are_a_model_in_space() -> None:
    text = """
gears: {pinion: {type: bevel, teeth: 15, module: 4 mm}, wheel: {type: bevel, teeth: 45, module: 4 mm}}
mesh: [pinion, wheel]
pinion_speed: 1200 rpm
"""
    assert answer(text, "angular velocity of wheel") == pytest.approx(1200 * math.pi / 30 / 3)
    told = "the axes of pinion and wheel meet at a right angle, along x and y"
    assert told in map(str, fb.System.from_text(text).assumptions)


@pytest.mark.parametrize(("x", "v", "side"), [("-1 m", "v", "right"), ("d", "-v", "left")])
def test_a_wall_that_nobody_declares_is_where_the_ball_is_not(x: str, v: str, side: str) -> None:
    text = f"""
parameters: {{m: 2 kg, v: 3 m/s, d: 1 m, e: 0.8}}
bodies: {{ball: {{disk: {{mass: m, radius: 0.1 m}}, at: [{x}, 0], velocity: [{v}, 0]}}}}
connections: {{hit: {{contact: {{between: [ball, wall], restitution: e}}}}}}
"""
    after = fb.System.from_text(text).solve("velocity of ball after the impact")["q1"].value
    assert after[0] == pytest.approx(-2.4 if side == "right" else 2.4)
    told = f"wall goes upright through the origin and is solid on the {side}"
    assert told in map(str, fb.System.from_text(text).assumptions)


@pytest.mark.parametrize("load", ["s: {spring: {at: bar.end, k: 800 N/m}}", "d: {damper: {at: bar.end, c: 25 N s/m}}"])
def test_a_spring_at_one_point_is_told_that_it_has_two(load: str) -> None:
    text = f"bodies: {{bar: {{rod: {{mass: 3 kg, length: 1.2 m}}}}}}\nloads: {{{load}}}\n"
    with pytest.raises(fb.ModelError, match=r"acts between two points, .* \{from: \[0\.6 m, -0\.3 m\], to: b"):
        fb.System.from_text(text)
    cured = text.replace("at: bar.end", "from: [0.6 m, -0.3 m], to: bar.end")
    assert not fb.System.from_text(cured).warnings


def test_a_rope_round_a_point_mass_is_told_of_the_pulley() -> None:
    text = """
ground: {points: {T: [4 m, 3 m]}, lines: {incline: {along: 30 deg}}}
bodies: {A: {particle: {mass: 20 kg}}, B: {particle: {mass: 8 kg}}}
connections: {c: {contact: [A, incline]}, rope: {string: {path: [ground.T, around A, over ground.T, B]}}}
"""
    with pytest.raises(fb.ModelError, match=r"A is a point and has no radius; .* axle: \{pin: \[A, pulley\]"):
        fb.System.from_text(text)


def test_a_rope_that_runs_twice_to_a_block_on_an_incline_is_a_tackle() -> None:
    # 2 T - m_A g (sin alpha + mu cos alpha) = m_A a, m_B g - T = 2 m_B a
    text = """
ground: {lines: {incline: {along: 30 deg}}}
bodies: {A: {particle: {mass: 20 kg}}, B: {particle: {mass: 8 kg}}, top: {disk: {radius: 0.1 m}}}
connections:
  guide: {slider: {body: A, along: incline, friction: 0.2}}
  axle: {pin: [ground.T, top]}
  rope: {string: {from: B, over: [top], to: A, falls: 2}}
measures: {y: drop of B}
gravity: 9.81
"""
    lift = 2 * 8 * G - 20 * G * (0.5 + 0.2 * math.sqrt(0.75))
    assert answer(text, "acceleration of y") == pytest.approx(2 * lift / (20 + 4 * 8))


LINE = "bodies: {b: {particle: {mass: 1 kg}, at: [1 m, 2 m]}}\n"


@pytest.mark.parametrize(
    ("said", "line"),
    [
        ("ground: {floor: horizontal}", "floor: {along: right}"),
        ("ground: {floor: y = 1 m}", "floor: {along: right, through: [0, 1 m]}"),
        ("ground: {floor: {y: 1 m}}", "floor: {along: right, through: [0, 1 m]}"),
        ("ground: {floor: 1 m}", "floor: {along: right, through: [0, 1 m]}"),
        ("ground: {slope: 30 deg}", "slope: {angle: 30 deg}"),
        ("slope: 30 deg", "slope: {angle: 30 deg}"),
        ("parameters: {beta: 30 deg}\nground: {slope: beta}", "slope: {angle: beta}"),
    ],
)
def test_a_line_of_the_ground_by_how_it_lies(said: str, line: str) -> None:
    plain = f"ground: {{lines: {{{line}}}}}"
    plain = f"parameters: {{beta: 30 deg}}\n{plain}" if "beta" in said else plain
    read, meant = (fb.System.from_text(f"{LINE}{each}\n") for each in (said, plain))
    assert read.bodies["ground"] == meant.bodies["ground"]


def test_an_upright_line_says_on_which_side_it_is_solid() -> None:
    """It was offered as a level one."""
    with pytest.raises(fb.ModelError, match=r"solid: right, through: \[2 m, 0\]") as refused:
        fb.System.from_text(f"{LINE}ground: {{wall: x = 2 m}}\n")
    assert len(refused.value.problems) == 1
    with pytest.raises(fb.ModelError, match=r"slope: \{angle: 30 deg\}"):
        fb.System.from_text(f"{LINE}ground: {{slope: 30}}\n")


def test_a_wall_that_is_upright_and_no_more_is_raised_beside_the_body() -> None:
    text = "connections: {c: {contact: [b, wall]}}\n"
    read, meant = (fb.System.from_text(LINE + text + each) for each in ("ground: {wall: vertical}\n", ""))
    assert read.bodies["ground"] == meant.bodies["ground"]


def test_a_beam_with_a_mass_has_a_weight() -> None:
    text = "beam: {length: 6 m, mass: 60 kg}\nsupports: {A: 0 m, B: 6 m}\n"
    assert answer(text, "reaction at B") == pytest.approx(30 * G)
    assert "gravity acts downwards, g = 9.81 m/s^2" in map(str, fb.System.from_text(text).assumptions)
    assert answer(f"{text}gravity: 1.62 m/s^2\n", "reaction at B") == pytest.approx(30 * 1.62)


def test_loads_of_a_beam_are_told_in_words() -> None:
    # about A: 6 B = 5*4 - 1*2 + 2*3*1.5 + 1*3*4.5
    loads = "{F: 5 kN at 4 m, G: 1 kN up at 2 m, q: 2 kN/m from 0 to 3 m, p: 1 kN/m down from 3 m to 6 m}"
    text = f"beam: {{length: 6 m}}\nsupports: {{A: 0 m, B: 6 m}}\nloads: {loads}\n"
    assert answer(text, "reaction at B") == pytest.approx((20 - 2 + 9 + 13.5) / 6 * 1e3)


@pytest.mark.parametrize("loads", ["{F: 5 kN at 8 m}", "[{P: 5 kN, x: -1 m}]", "[{w: 1 kN/m, from: 3 m, to: 7 m}]"])
def test_a_load_beside_the_beam_is_told(loads: str) -> None:
    text = f"beam: {{length: 6 m}}\nsupports: {{A: 0 m, B: 6 m}}\nloads: {loads}\n"
    with pytest.raises(fb.ModelError, match="not on beam: places count from its left end, from 0 to 6 m") as raised:
        fb.System.from_text(text)
    assert [problem.line for problem in raised.value.problems] == [3]


@pytest.mark.parametrize(
    ("body", "held", "inertia"),
    [
        ("{disk: {mass: m, radius: R}}", "{rolling: {body: wheel, on: floor}}", 1.5),
        ("{ring: {mass: m, radius: R}}", "{rolling: {body: wheel, on: floor}}", 2.0),
        ("{disk: {mass: m, radius: R}}", "{contact: {body: wheel, on: floor, mu: 0.4}}", 1.5),
        ("{rectangle: {mass: m, width: 0.4 m, height: 0.2 m}}", "{contact: {body: wheel, on: floor}}", 1.0),
    ],
)
def test_a_spring_to_a_wall_lies_level(body: str, held: str, inertia: float) -> None:
    """T = 2 pi sqrt((m + J/R^2)/k) of what rolls, as the spring is at the height of its middle."""
    text = (
        "parameters: {m: 4 kg, R: 0.2 m, k: 100 N/m, g: 9.81 m/s^2}\n"
        f"bodies: {{wheel: {body}}}\nconnections: {{roll: {held}}}\n"
        "loads: {s: {spring: {from: wall, to: wheel.center, k: k}}, w: {gravity: g}}\n"
    )
    assert answer(text, "period of small oscillations") == pytest.approx(2 * math.pi * math.sqrt(inertia * 4 / 100))


def test_a_pulley_that_only_its_rope_names_is_light() -> None:
    # a = g (m2 - m1 sin a - mu m1 cos a)/(m1 + m2), here with mu = 0; and of an Atwood machine g (m1 - m2)/(m1 + m2)
    text = (
        "title: a pulley\nparameters: {m1: 5 kg, m2: 4 kg, alpha: 30 deg}\n"
        "ground: {lines: {incline: {along: alpha}}}\n"
        "bodies: {block: {mass: m1, on: incline}, weight: {mass: m2}}\n"
        "rope: {from: block, over: pulley, to: weight}\ngravity: 9.81 m/s^2\n"
    )
    assert answer(text, "acceleration of weight") == pytest.approx(G * (4 - 2.5) / 9)
    assert "pulley is no body of the file: it is a disk without mass" in map(str, fb.System.from_text(text).assumptions)
    atwood = "bodies: {A: {mass: 3 kg}, B: {mass: 2 kg}}\nrope: {from: A, over: pulley, to: B}\ngravity: 9.81 m/s^2\n"
    assert answer(atwood, "tension of rope") == pytest.approx(2 * 3 * 2 * G / 5)


def test_a_rope_over_a_point_of_the_ground_stays_there() -> None:
    text = (
        "ground: {points: {pulley: [1 m, 2 m]}}\nbodies: {A: {mass: 3 kg}, B: {mass: 2 kg}}\n"
        "rope: {from: A, over: ground.pulley, to: B}\ngravity: 9.81 m/s^2\n"
    )
    assert "pulley" not in fb.System.from_text(text).bodies


def test_a_carrier_is_as_long_as_its_gears_need_to_mesh() -> None:
    # Willis: omega_carrier = omega_sun z_sun/(z_sun + z_ring); r_sun + r_planet = (20 + 30) m/2
    text = (
        "bodies: {sun: {gear: {teeth: 20, module: 2 mm}}, planet: {gear: {teeth: 30}}, carrier: {rod: },"
        " ring: {gear: {teeth: 80}, fixed: true}}\n"
        "connections: {a: {pin: [ground.O, sun]}, b: {pin: [ground.O, carrier.start]}, c: {pin: [carrier.end, planet]},"
        " d: {gear_mesh: [sun, planet]}, e: {gear_mesh: {first: ring, second: planet, internal: true}},"
        " drive: {driver: {on: sun, speed: 1500 rpm}}}\n"
    )
    assert answer(text, "angular velocity of carrier") == pytest.approx(1500 * math.pi / 30 * 20 / 100)
    system = fb.System.from_text(text)
    assert system.parameters.keys() == set()
    assert all(warning.kind == "elbow open" for warning in system.warnings)  # which way it points does not matter
    _start, end = (system.bodies["carrier"].points[name][0] for name in ("start", "end"))
    assert float(str(evaluate(end, {}))) == pytest.approx(0.025)


def test_a_damper_on_a_flywheel_brakes_it() -> None:
    # J w' = M - c w: w = M/c (1 - exp(-c t/J)), so M/(10 c) after J/c log(10/9)
    text = (
        "parameters: {J: 0.5 kg m^2, M: 10 N m, c: 0.1 N m s}\nbodies: {flywheel: {disk: {inertia: J}}}\n"
        "connections: {bearing: {pin: [ground, flywheel]}}\n"
        "loads: {motor: {torque: {on: flywheel, magnitude: M}}, drag: {torsional_damper: {on: flywheel, c: c}}}\n"
    )
    for question in ("time until the flywheel turns at 10 rad/s", "when does the flywheel run at 10 rad/s?"):
        assert answer(text, question) == pytest.approx(5 * math.log(10 / 9))


def test_a_flywheel_whose_speed_is_asked_turns_where_it_is() -> None:
    text = (
        "bodies: {flywheel: {disk: {mass: 2 kg, radius: 1 m}, pivot: O}}\n"
        "loads: {motor: {torque: {on: flywheel, magnitude: 3 N m}}}\n"
    )
    (found,) = fb.System.from_text(text).solve("speed of flywheel after 2 s").answers
    assert found.value == 0.0
    assert "its mass centre stands still: ask for the angular velocity of flywheel" in map(str, found.notes)
    thrown = "bodies: {d: {disk: {mass: 2 kg, radius: 1 m}, velocity: [0, 5 m/s]}}\nloads: {w: {gravity: 9.81 m/s^2}}\n"
    (top,) = fb.System.from_text(f"{thrown}measures: {{y: height of d}}\n").solve("speed of d when rate(y) = 0").answers
    assert not any("stands still" in str(note) for note in top.notes)  # there alone


def test_the_place_of_the_greatest_moment_has_a_unit() -> None:
    text = "beam: {length: 6 m}\nsupports: {A: 0, B: 4 m}\nloads: {F: 2 kN at 6 m}\n"
    (found,) = fb.System.from_text(text).solve("greatest bending moment").answers
    assert "at 4 m from beam.start" in map(str, found.notes)


@pytest.mark.parametrize("said", ["point: rod.end", "at: rod.end", "body: rod, point: end", "on: ground, pin: rod.end"])
def test_a_slider_of_a_point_leaves_its_body_free_to_turn(said: str) -> None:
    # a ladder, of which the lower end is rod.end: theta'' = 3 g cos(theta)/(2 L), towards level
    text = (
        "bodies: {rod: {rod: {mass: 2 kg, length: 1 m}, angle: -30 deg}}\n"
        "connections:\n  A: {slider: {point: rod.start, along: up}}\n"
        f"  B: {{slider: {{{said}, along: right}}}}\n"
        "loads: {weight: {gravity: 9.81 m/s^2}}\nmeasures: {theta: angle of rod}\n"
    )
    found = answer(text, "angular acceleration of rod at start")
    assert found == pytest.approx(1.5 * 9.81 * math.cos(math.radians(30)))


def test_parts_of_a_composite_body_are_called_without_a_word_for_them() -> None:
    # a clock: I = m L^2/3 + M (R^2/2 + (L + R)^2) about the axle, and m L/2 + M (L + R) below it
    text = (
        "bodies:\n  clock: {composite: {rod: {rod: {mass: 3 kg, length: 1.2 m}, at: [0, -0.6 m], angle: -90 deg}, "
        "bob: {disk: {mass: 5 kg, radius: 0.15 m}, at: [0, -1.35 m]}}}\n"
        "connections: {O: {pin: [ground, clock.origin]}}\nloads: {weight: {gravity: 9.81 m/s^2}}\n"
    )
    inertia = 3 * 1.2**2 / 3 + 5 * (0.15**2 / 2 + 1.35**2)
    period = 2 * math.pi * math.sqrt(inertia / (9.81 * (3 * 0.6 + 5 * 1.35)))
    assert answer(text, "period of small oscillations") == pytest.approx(period)
