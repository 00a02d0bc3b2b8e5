"""Files as people write them first: what can mean only one thing is read as that, and problems are told where they
stand in the file."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

import freebody as fb
from posed import posed

BASE = """
parameters: {m: 2 kg, L: 1 m, R: 0.1 m, k: 50 N/m, mu: 0.3, g: 9.81 m/s^2, w: 3 rad/s}
ground: {points: {A: [0, 0], B: [2 m, 0]}, lines: {floor: {along: right}}}
bodies: {rod: {rod: {mass: m, length: L}}, block: {particle: {mass: m}},
  drum: {disk: {radius: R}, fixed: true, at: [1 m, 3 m]}}
"""
SAME = {
    "a load called by its kind": ("loads: {gravity: g}", "loads: {gravity: {gravity: g}}"),
    "a load called by a word for its kind": ("loads: {weight: g}", "loads: {weight: {weight: g}}"),
    "a spring called spring": (
        "loads: {spring: {from: ground.A, to: block, k: k}}",
        "loads: {spring: {spring: {from: ground.A, to: block, k: k}}}",
    ),
    "a load beside the sections": ("gravity: g", "loads: {gravity: {gravity: g}}"),
    "what belongs to a kind beside it": (
        "connections: {c: {contact: [rod.end, floor], mu: mu}}",
        "connections: {c: {contact: {between: [rod.end, floor], friction: mu}}}",
    ),
    "a force and what belongs to it side by side": (
        "loads: {F: {force: 5 N, on: block, direction: right}}",
        "loads: {F: {force: {at: block, along: right, magnitude: 5 N}}}",
    ),
    "a force in words": (
        "loads: {F: 5 N down at rod.end}",
        "loads: {F: {force: {at: rod.end, along: down, magnitude: 5 N}}}",
    ),
    "a force in German words": (
        "loads: {F: m*g an rod.end nach unten}",
        "loads: {F: {force: {at: rod.end, along: down, magnitude: m*g}}}",
    ),
    "a force by its components": (
        "loads: {F: {on: block, force: [3 N, 4 N]}}",
        "loads: {F: {force: {at: block, along: [(3 N)/(1 N), (4 N)/(1 N)], magnitude: sqrt((3 N)^2 + (4 N)^2)}}}",
    ),
    "a force with one component": (
        "loads: {F: {force: {at: rod.end, vector: [0, -20 kN]}}}",
        "loads: {F: {force: {at: rod.end, along: up, magnitude: -20 kN}}}",
    ),
    "two coefficients beside each other": (
        "connections: {c: {contact: [rod.end, floor], mu_s: 0.4, mu_k: mu}}",
        "connections: {c: {contact: {between: [rod.end, floor], friction: {static: 0.4, kinetic: mu}}}}",
    ),
    "contacts in a list of their own": (
        "contacts:\n- {between: [rod.end, floor], static_friction: 0.4, kinetic_friction: mu}",
        "connections: {contact: {contact: {between: [rod.end, floor], friction: {static: 0.4, kinetic: mu}}}}",
    ),
    "a rope by its turns": (
        "connections: {r: {string: {from: ground.A, over: drum, to: block, friction: mu, turns: 2, slip: true}}}",
        "connections: {r: {string: {from: ground.A, over: [drum], to: block, friction: mu, wrap: "
        "(2)*2*pi, grips: []}}}",
    ),
    "joints and drives in lists": (
        "joints:\n- {name: O, type: revolute, bodies: [world, rod.start]}\ndrives:\n- {body: rod, omega: w}",
        "connections: {O: {pin: [ground, rod.start]}, drive: {driver: {body: rod, speed: w}}}",
    ),
    "a guide by its name in space": (
        "connections: {g: {type: prismatic, body: block, direction: right}}",
        "connections: {g: {slider: {body: block, along: right}}}",
    ),
    "the start of an angle by the body": (
        "connections: {O: {pin: [ground.A, rod.start]}}\nstart: {rod.angle: 30 deg}",
        "connections: {O: {pin: [ground.A, rod.start]}}\nstart: {angle of rod: 30 deg}",
    ),
    "the direction of a guide": (
        "connections: {g: {slider: {body: block, along: 30 deg}}}\nmeasures: {s: travel of block along g}",
        "connections: {g: {slider: {body: block, along: 30 deg}}}\nmeasures: {s: travel of block along 30 deg}",
    ),
    "a kind as a field": (
        "connections: {p: {type: pin, between: [ground.A, rod.start]}}",
        "connections: {p: {pin: {between: [ground.A, rod.start]}}}",
    ),
    "a spring among the connections": (
        "connections: {s: {spring: [ground.A, block], k: k}}",
        "loads: {s: {spring: {first: ground.A, second: block, stiffness: k}}}",
    ),
    "a joint among the loads": (
        "loads: {p: {pin: [ground.A, rod.start]}}",
        "connections: {p: {pin: [ground.A, rod.start]}}",
    ),
    "a list of connections": (
        "connections:\n- pin: [ground.A, rod.start]\n- {slider: block, along: right}",
        "connections: {pin: {pin: [ground.A, rod.start]}, slider: {slider: {body: block, along: right}}}",
    ),
    "a list with two of a kind": (
        "loads: [{gravity: g}, {spring: [ground.A, block], k: k}, {spring: [ground.B, block], k: k}]",
        "loads: {gravity: {gravity: g}, spring_1: {spring: {first: ground.A, second: block, stiffness: k}}, spring_2: "
        "{spring: {first: ground.B, second: block, stiffness: k}}}",
    ),
    "a list whose items have names": (
        "connections: [{name: p, type: pin, between: [ground.A, rod.start]}]",
        "connections: {p: {pin: {between: [ground.A, rod.start]}}}",
    ),
    "sections by other names": (
        "joints: {p: {pin: [ground.A, rod.start]}}\nforces: {F: {force: {at: rod.end, down: 5 N}}}",
        "connections: {p: {pin: [ground.A, rod.start]}}\nloads: {F: {force: {at: rod.end, down: 5 N}}}",
    ),
    "two sections that are one": (
        "joints: {p: {pin: [ground.A, rod.start]}}\nsupports: {s: {roller: {at: rod.end, on: floor}}}",
        "connections: {p: {pin: [ground.A, rod.start]}, s: {roller: {at: rod.end, on: floor}}}",
    ),
    "when something closes": (
        "connections: {hit: {weld: [block, rod.end], when: at start}}",
        "connections: {hit: {weld: [block, rod.end], closes: at start}}",
    ),
    "a list and a motor beside it": (
        "joints: [{pin: [ground.A, rod.start]}]\nmotor: {rod: w}",
        "connections: {pin: {pin: [ground.A, rod.start]}, motor: {driver: {body: rod, speed: w}}}",
    ),
    "a load of so much per length": (
        "loads: {q: {distributed: 3 N/m, on: rod}}",
        "loads: {q: {distributed: {between: [rod.start, rod.end], intensity: 3 N/m}}}",
    ),
    "one question in place of a list": ("questions: acceleration of block", "questions: [acceleration of block]"),
    "one question": ("find: acceleration of block", "questions: [acceleration of block]"),
    "where a joint is, beside the ground": (
        "connections: {p: {pin: [ground, rod.start], at: A}}",
        "connections: {p: {pin: [ground.A, rod.start]}}",
    ),
    "where a joint is, beside the body": (
        "connections: {p: {type: pin, body: block, at: {x: 0, y: 1 m}}}",
        "connections: {p: {pin: [[0, 1 m], block]}}",
    ),
    "a point by its body": (
        "loads: {s: {spring: {from: {body: rod, point: end}, to: {x: 0, y: 1 m}, k: k}}}",
        "loads: {s: {spring: {from: rod.end, to: [0, 1 m], k: k}}}",
    ),
    "a point beside its body": (
        "loads: {F: {force: 5 N, on: rod, at: end, direction: down}}",
        "loads: {F: {force: {at: rod.end, along: down, magnitude: 5 N}}}",
    ),
    "a roller without a direction": (
        "connections: {r: {roller: {of: rod.end}}}",
        "connections: {r: {slot: {pin: rod.end, along: right}}}",
    ),
    "a load of so much per length and its direction": (
        "loads: {q: {distributed: {on: rod, up: 3 N/m}}}",
        "loads: {q: {distributed: {between: [rod.start, rod.end], along: up, intensity: 3 N/m}}}",
    ),
    "a force at what gives it its name": (
        "loads: {block: {Fx: 0, Fy: -2 N}}",
        "loads: {block: {force: {at: block, along: up, magnitude: -2 N}}}",
    ),
    "a force in words at what gives it its name": (
        "loads: {block: 2 N down}",
        "loads: {block: {force: {at: block, along: down, magnitude: 2 N}}}",
    ),
    "a torque in words": (
        "loads: {M: 3 N m clockwise on rod}",
        "loads: {M: {torque: {on: rod, magnitude: 3 N m, clockwise: true}}}",
    ),
    "what is driven as a name": (
        "connections: {p: {pin: [ground.A, rod.start]}}\ndrives: {rod: 30 rpm}",
        "connections: {p: {pin: [ground.A, rod.start]}, rod: {driver: {body: rod, speed: 30 rpm}}}",
    ),
    "the ground for its line": (
        "connections: {c: {contact: {between: [block, ground], smooth: true}}}",
        "connections: {c: {contact: {between: [block, floor]}}}",
    ),
    "a guide by its angle": (
        "connections: {g: {slider: {body: block, angle: 30 deg}}}",
        "connections: {g: {slider: {body: block, along: 30 deg}}}",
    ),
    "a slot that stands": (
        "connections: {g: {slot: {pin: block, along: senkrecht}}}",
        "connections: {g: {slot: {pin: block, along: up}}}",
    ),
    "contacts in German": (
        "Kontakte: {c: {zwischen: [rod.end, floor], reibung: mu}}",
        "connections: {c: {contact: {between: [rod.end, floor], friction: mu}}}",
    ),
    "a bearing of what is round": (
        "connections: {axle: {bearing: drum}}",
        "connections: {axle: {pin: [ground.axle, drum]}}",
    ),
    "what holds a body alone": (
        "connections: {A: {pin: rod.start}}",
        "connections: {A: {pin: [ground.A, rod.start]}}",
    ),
    "the ground in German": (
        "connections: {A: {pin: [boden, rod.start]}}",
        "connections: {A: {pin: [ground, rod.start]}}",
    ),
    "a contact as a pair": (
        "contacts: [{rod.end: floor, mu: mu}]",
        "connections: {contact: {contact: {between: [rod.end, floor], friction: mu}}}",
    ),
    "components inside a force": (
        "loads: {F: {force: {at: rod.end, Fx: 0, Fy: -3 N}}}",
        "loads: {F: {force: {at: rod.end, along: up, magnitude: -3 N}}}",
    ),
    "a way in German": (
        "loads: {F: {force: {an: rod.end, Richtung: oben, Betrag: 3 N}}}",
        "loads: {F: {force: {at: rod.end, along: oben, magnitude: 3 N}}}",
    ),
    "a guide in German": (
        "Führungen: {g: {Körper: block, Richtung: waagerecht}}",
        "connections: {g: {Führung: {body: block, along: right}}}",
    ),
    "bearings by what turns in them": (
        "bearings: {b: drum}",
        "connections: {b: {pin: [ground.b, drum]}}",
    ),
    "a torque that is called motor": (
        "torques: {motor: {on: rod, value: 3 N m}}",
        "loads: {motor: {torque: {on: rod, magnitude: 3 N m}}}",
    ),
    "guides of two kinds": (
        "guides: {g: {body: block, direction: horizontal}}",
        "connections: {g: {slider: {body: block, along: right}}}",
    ),
    "a load under a word for another": (
        "forces: {drag: {on: block, quadratic: 2 kg/m}}",
        "loads: {drag: {drag: {body: block, quadratic: 2 kg/m}}}",
    ),
    "braces for brackets": (
        "connections: {p: {pin: {ground.A, rod.start}}}",
        "connections: {p: {pin: [ground.A, rod.start]}}",
    ),
    "the law of a drive": (
        "connections: {p: {pin: [ground.A, rod.start]}, d: {driver: {measure: angle of rod, law: w*t}}}",
        "connections: {p: {pin: [ground.A, rod.start]}, d: {driver: {measure: angle of rod, follows: w*t}}}",
    ),
    "what is driven and how fast": (
        "connections: {p: {pin: [ground.A, rod.start]}, motor: {on: rod, rpm: 30}}",
        "connections: {p: {pin: [ground.A, rod.start]}, motor: {motor: {body: rod, speed: 30 rpm}}}",
    ),
}


@pytest.mark.parametrize("written", SAME)
def test_what_can_mean_one_thing_is_read_as_that(written: str) -> None:
    loose, strict = (fb.System.from_text(f"{BASE}{text}\n") for text in SAME[written])
    assert loose.connections == strict.connections
    assert loose.loads == strict.loads
    assert [q.text for q in loose.questions] == [q.text for q in strict.questions]


BODIES = {
    "a mass alone": ("p: {mass: 1 kg, x: 1 m, y: 2 m}", "p: {particle: {mass: 1 kg}, at: [1 m, 2 m]}"),
    "a mass that is called so": ("p: {type: mass, mass: 1 kg}", "p: {particle: {mass: 1 kg}}"),
    "fields of one shape": ("b: {mass: 1 kg, length: 2 m}", "b: {rod: {mass: 1 kg, length: 2 m}}"),
    "a speed along x": (
        "p: {mass: 1 kg, x: 1 m, v: 3 m/s}",
        "p: {particle: {mass: 1 kg}, at: [1 m, 0], velocity: [3 m/s, 0]}",
    ),
    "a middle": (
        "d: {disk: {mass: 1 kg, radius: R}, center: [0, 1 m]}",
        "d: {disk: {mass: 1 kg, radius: R}, at: [0, 1 m]}",
    ),
    "a throw without a shape": (
        "p: {mass: 1 kg, speed: 2 m/s, angle: 30 deg}",
        "p: {particle: {mass: 1 kg}, velocity: [(2 m/s)*cos(30 deg), (2 m/s)*sin(30 deg)]}",
    ),
    "a throw in German": (
        "p: {Masse: 1 kg, Anfangsgeschwindigkeit: 2 m/s, Winkel: 30 deg}",
        "p: {particle: {mass: 1 kg}, velocity: [(2 m/s)*cos(30 deg), (2 m/s)*sin(30 deg)]}",
    ),
    "what every body may have inside its shape": (
        "w: {disk: {mass: 1 kg, radius: R, at: [1 m, 0], angular_velocity: w}}",
        "w: {disk: {mass: 1 kg, radius: R}, at: [1 m, 0], angular_velocity: w}",
    ),
    "components by their axes": (
        "p: {particle: {mass: 1 kg}, at: {x: 1 m, y: 2 m}, velocity: {x: 3 m/s, y: 0}}",
        "p: {particle: {mass: 1 kg}, at: [1 m, 2 m], velocity: [3 m/s, 0]}",
    ),
    "a word for shapes with what every body may have among its fields": (
        "c: {block: {mass: 1 kg, width: 2 m, height: 1 m, at: [1 m, 0], velocity: [1 m/s, 0]}}",
        "c: {rectangle: {mass: 1 kg, width: 2 m, height: 1 m}, at: [1 m, 0], velocity: [1 m/s, 0]}",
    ),
    "the shape as a field": ("w: {type: disk, mass: 1 kg, radius: R}", "w: {disk: {mass: 1 kg, radius: R}}"),
    "the shape as the name": ("pulley: {radius: R, at: [1 m, 0]}", "pulley: {disk: {radius: R}, at: [1 m, 0]}"),
    "what belongs to a shape beside it": (
        "w: {mass: 1 kg, inertia: 2 kg m^2, disk: {radius: R}}",
        "w: {disk: {mass: 1 kg, inertia: 2 kg m^2, radius: R}}",
    ),
}


@pytest.mark.parametrize("written", BODIES)
def test_a_body_is_read_as_it_can_only_be_meant(written: str) -> None:
    head = "parameters: {R: 0.1 m, w: 3 rad/s}\nbodies: "
    loose, strict = (fb.System.from_text(f"{head}{{{text}}}") for text in BODIES[written])
    assert loose.bodies == strict.bodies
    listed = BODIES[written][0].partition(": ")
    as_list = fb.System.from_text(f"{head}[{{{listed[0]}: {listed[2]}}}]")
    assert as_list.bodies == strict.bodies


def test_a_problem_stands_where_it_is_written() -> None:
    text = """parameters: {g: 9.81 m/s^2}
bodies:
- name: crank
  type: rod
  lenth: 1 m
joints:
- pin: [ground.A, crank.strat]
loads:
  gravity: 9.81 m
"""
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(text)
    assert (5, "rod has no lenth. Did you mean length?") in [(p.line, p.message) for p in refused.value.problems]
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(text.replace("lenth", "length"))
    lines = [p.line for p in refused.value.problems]
    assert lines == [7, 9]


def test_what_is_said_twice_or_of_two_kinds_is_not_put_elsewhere() -> None:
    for written in (
        "c: {contact: {between: [b, f], friction: 0.1}, mu: 0.2}",
        "c: {pin: [b, ground], weld: [b, ground]}",
    ):
        with pytest.raises(fb.ModelError):
            fb.System.from_text(f"bodies: {{b: {{disk: {{mass: 1 kg, radius: 1 m}}}}}}\nconnections: {{{written}}}")


def test_a_truth_value_is_no_number() -> None:
    # it was a gravity of 1 m/s^2
    with pytest.raises(fb.ModelError, match=r"strength takes a value, not true, e.g. gravity: 9.81 m/s\^2"):
        fb.System.from_text("bodies: {b: {particle: {mass: 1 kg}}}\nloads: {weight: {gravity: true}}")
    with pytest.raises(TypeError):
        fb.Gravity(True)


def test_a_model_may_be_changed_and_written_in_the_form_in_which_it_is_read() -> None:
    system = fb.System.from_text(f"{BASE}loads: {{gravity: g}}\n")
    assert system.with_parameters(m="5 kg").to_yaml().splitlines()[-1].strip() == "gravity: {gravity: g}"
    assert "gravity: g" in system.to_yaml()


def test_letters_of_points_do_not_hang_on_the_order_of_the_entries() -> None:
    springs = ["a: {spring: {from: [2 m, 0], to: block, k: k}}", "b: {spring: {from: [-1 m, 0], to: block, k: k}}"]
    base = BASE.replace("points: {A: [0, 0], B: [2 m, 0]}, ", "")
    one, other = (fb.System.from_text(f"{base}loads: {{{', '.join(order)}}}\n") for order in (springs, springs[::-1]))
    assert one.bodies["ground"].points == other.bodies["ground"].points
    assert one.loads["b"].first == other.loads["b"].first == "ground.A"  # from left to right


def test_a_start_at_rest_gives_no_value() -> None:
    loose = fb.System.from_text(f"{BASE}start: at rest\n")
    assert not loose.start
    assert not loose.start_rates


def test_coordinates_that_are_given_twice_are_one_point() -> None:
    base = BASE.replace("points: {A: [0, 0], B: [2 m, 0]}, ", "")
    system = fb.System.from_text(
        f"{base}connections: {{p: {{pin: {{between: [[0, 0], rod.start]}}}}}}\n"
        "loads: {a: {spring: {from: [0, 0], to: block, k: k}}}\n"
    )
    assert set(system.bodies["ground"].points) == {"origin", "A"}


def test_a_rope_may_begin_at_coordinates(agrees: Callable[[fb.Solution, str, str], None]) -> None:
    text = """
parameters: {m: 10 kg, g: 9.81 m/s^2, a: 1 m}
bodies: {lamp: {particle: {mass: m}, at: [0, 0]}}
connections: {left: {rope: [[-a, a], lamp]}, right: {rope: [[a, a], lamp]}}
loads: {weight: g}
"""
    agrees(fb.System.from_text(text).solve("tension of left"), "q1", "m*g/sqrt(2)")


@pytest.mark.parametrize("floor", ["floor", "ground.floor"])
def test_a_floor_that_nobody_declares_is_level(floor: str) -> None:
    text = BASE.replace(", lines: {floor: {along: right}}", "")
    system = fb.System.from_text(f"{text}connections: {{c: {{contact: [rod.end, {floor}]}}}}\n")
    assert "floor is not declared: it is the horizontal line through the origin" in [str(a) for a in system.assumptions]


def test_what_does_not_move_is_a_point_of_the_ground() -> None:
    text = BASE.replace("points: {A: [0, 0], B: [2 m, 0]}, ", "")
    system = fb.System.from_text(f"{text}loads: {{s: {{spring: {{from: wall, to: block, k: k, length: L}}}}}}\n")
    assert system.bodies["ground"].points["wall"] == system.bodies["ground"].points["origin"]


def test_what_is_pinned_to_the_ground_is_pinned_where_it_stands() -> None:
    text = """
parameters: {r: 0.1 m, R: 0.3 m, n: 300 rpm}
bodies: {a: {disk: {radius: r}, at: [0, 0]}, b: {disk: {radius: R}, at: [1 m, 0]}}
connections: {p: {pin: [a, ground]}, q: {pin: [ground, b]}, belt: {belt: [a, b]}, motor: {drive: a, speed: n}}
"""
    system = fb.System.from_text(text)
    assert system.connections["q"].first == "ground.q"
    (answer,) = fb.solve(system, "angular velocity of b").answers
    assert answer.value == pytest.approx(10 * 3.141592653589793 / 3)


TRUSS = """
nodes: {A: [0, 0], B: [4 m, 0], C: [2 m, 3 m]}
MEMBERS
supports: {A: pin, B: roller}
loads: {F: 10 kN down at C}
"""


@pytest.mark.parametrize(
    "members",
    ["members: {AB: [A, B], AC: [A, C], BC: [B, C]}", "bars: [[A, B], [A, C], [B, C]]", "members: [AB, AC, BC]"],
)
def test_a_truss_is_read_as_its_nodes_members_and_supports(members: str) -> None:
    # node C: 2 S sin = -F with sin = 3/sqrt(13); node A: S_AB = -S cos
    system = fb.System.from_text(TRUSS.replace("MEMBERS", members))
    forces = [a.value for a in system.solve(["force in AC", "force in member AB", "reaction of A"]).answers]
    assert forces[0] == pytest.approx(-5000 * 13**0.5 / 3)
    assert forces[1] == pytest.approx(10000 / 3)
    assert forces[2] == pytest.approx((0, 5000))
    assert "the members are hinged at the nodes" in str(system.assumptions[0])


def test_a_tripod_is_a_truss_in_space() -> None:
    text = """
space: {up: z}
nodes: {D: [0, 0, 3], A: [2, 0, 0], B: [-1, 1.5, 0], C: [-1, -1.5, 0]}
members: [AD, BD, CD]
supports: {A: pin, B: pin, C: pin}
loads: {F: 12 kN down at D}
"""
    # x: 2 a = b + c with forces per length a, b, c; z: 3 (a + b + c) = -F
    (answer,) = fb.solve(fb.System.from_text(text), "force in AD").answers
    assert answer.value == pytest.approx(-4000 * 13**0.5 / 3)


def test_a_line_of_the_ground_may_stand_beside_its_points() -> None:
    text = "parameters: {beta: 30 deg}\nground: GROUND\nbodies: {b: {particle: {mass: 1 kg}}}\n"
    loose, strict = (
        fb.System.from_text(text.replace("GROUND", ground)).bodies["ground"].lines
        for ground in ("{slope: {angle: beta}}", "{lines: {slope: {along: beta}}}")
    )
    assert loose == strict


def test_a_line_with_friction_is_told_where_friction_stands() -> None:
    with pytest.raises(fb.ModelError, match=r"contact: \{between: \[BODY, slope\], friction: mu\}"):
        fb.System.from_text(
            "parameters: {mu: 0.2}\nground: {slope: {angle: 30 deg, friction: mu}}\n"
            "bodies: {b: {particle: {mass: 1 kg}}}\n"
        )


def test_a_wall_that_nobody_declares_is_told_upright() -> None:
    with pytest.raises(fb.ModelError, match=r"\{wall: \{along: up\}\}"):
        fb.System.from_text(f"{BASE}connections: {{c: {{contact: [rod.end, wall]}}}}\n")


def test_what_is_left_out_is_told_in_the_names_of_the_file() -> None:
    with pytest.raises(fb.ModelError, match=r"e.g. pin: \{first: rod, second: ground.hinge\}"):
        fb.System.from_text(f"{BASE}connections: {{hinge: {{pin: rod}}}}\n")
    with pytest.raises(fb.ModelError, match=r"Beside it write angular_velocity: 3 rad/s"):
        fb.System.from_text("bodies: {w: {disk: {mass: 1 kg, radius: 1 m, speed: 3 rad/s}}}")


def test_a_section_of_things_of_one_kind_says_the_kind() -> None:
    loose = fb.System.from_text(f"{BASE}springs: {{s: {{between: [ground.A, block], k: k}}}}\n")
    strict = fb.System.from_text(f"{BASE}loads: {{s: {{spring: {{first: ground.A, second: block, stiffness: k}}}}}}\n")
    assert loose.loads == strict.loads


def test_the_ring_gear_may_be_named_second() -> None:
    text = """
bodies:
  sun: {gear: {teeth: 20, module: 2 mm}}
  planet: {gear: {teeth: 20, module: 2 mm}}
  ring: {gear: {teeth: 60, module: 2 mm, internal: true}, fixed: true}
  carrier: {rod: {length: 40 mm}}
connections:
  s: {pin: [ground, sun]}
  c: {pin: [ground, carrier.start]}
  p: {pin: [carrier.end, planet]}
  m1: {gear_mesh: [sun, planet]}
  m2: {gear_mesh: ORDER}
"""
    for order in ("[planet, ring]", "[ring, planet]"):
        system = fb.System.from_text(text.replace("ORDER", order))
        (answer,) = fb.solve(system, "ratio of angular velocity of sun to angular velocity of carrier").answers
        assert answer.value == pytest.approx(4)


def test_german_words_stand_for_kinds_and_fields() -> None:
    text = """
Boden: {points: {A: [0, 0], B: [3 m, 0], C: [0, 2 m]}}
Körper: {Balken: {Stab: {von: A, nach: B}}, Zug: {Stab: {von: C, nach: B}}}
Verbindungen: {a: {Gelenk: [A, Balken.start]}, b: {Gelenk: [Balken.end, Zug.end]}, c: {Festlager: [C, Zug.start]}}
Lasten: {F: 6 kN nach unten an Balken.end}
Fragen: [Stabkraft in Zug]
"""
    (answer,) = fb.System.from_text(text).solve().answers
    assert answer.value == pytest.approx(3000 * 13**0.5)  # T 2/sqrt(13) = 6 kN


def test_german_prepositions_are_fields() -> None:
    text = """
parameter: {m_1: 4 kg, m_2: 2 kg, J: 0.02 kg m^2, R: 0.1 m, M: 1 N m, mu: 0.3, g: 9.81 m/s^2}
boden: {points: {A: [3 m, 2 m]}, lines: {Boden: {along: right}}}
körper:
  Rolle: {körper: {trägheitsmoment: J, radius: R}}
  m1: {massenpunkt: {masse: m_1}, bei: [3 m - R, 0.5 m]}
  m2: {massenpunkt: {masse: m_2}, bei: [3 m + R, 0.5 m]}
  Kiste: {rechteck: {masse: 5 kg, breite: 0.4 m, höhe: 0.4 m}, bei: [6 m, 0.2 m], auf: ground.Boden, reibbeiwert: mu}
verbindungen: {Achse: {gelenk: [ground.A, Rolle]}, Seil: {seil: {von: m1, über: Rolle, nach: m2}}}
lasten:
  Gewicht: {gravity: g}
  Motor: {moment: {auf: Rolle, betrag: M}}
  Zug: {kraft: {bei: Kiste, richtung: rechts, betrag: 20 N}}
fragen: [acceleration of m1 along down, friction force of Kiste_on_ground_Boden]
"""
    a, friction = fb.System.from_text(text).solve().answers
    # counter-clockwise lowers m1, on the left: (m_1 + m_2 + J/R^2) a = (m_1 - m_2) g + M/R; 20 N is more than 0.3 m g
    assert a.value == pytest.approx((2 * 9.81 + 1 / 0.1) / (6 + 0.02 / 0.1**2))
    assert abs(friction.value) == pytest.approx(0.3 * 5 * 9.81)


def test_words_may_be_spelt_as_people_spell_them() -> None:
    text = """
titel: Planetengetriebe
parameter: {z_S: 24, z_P: 18, z_H: 60, m_n: 2 mm, omega_S: 100 1/s}
koerper:
  sonne: {zahnrad: {zaehne: z_S, modul: m_n}}
  planet: {Zahnrad: {zaehnezahl: z_P, modul: m_n}}
  hohlrad: {zahnrad: {zaehne: z_H, modul: m_n}, fest: true}
  steg: {stab: {laenge: 42 mm}}
verbindungen:
  lager_sonne: {drehgelenk: [gestell.O, sonne]}
  lager_steg: {Revolute-Joint: [gestell.O, steg.anfang]}
  lager_planet: {typ: Drehgelenk, zwischen: [steg.ende, planet]}
  eingriff1: {zahneingriff: [sonne, planet]}
  eingriff2: {zahneingriff: [hohlrad, planet], innen: true}
  antrieb: {antrieb: {koerper: sonne, drehzahl: omega_S}}
fragen: [Winkelgeschwindigkeit des Stegs]
"""
    solution = fb.System.from_text(text).solve()
    (answer,) = solution.answers
    assert answer.value == pytest.approx(100 * 24 / 84)
    assert "gestell is no body of the model: it is the ground" in map(str, solution.assumptions)
    wrong = text.replace("laenge: 42 mm", "laenge: 42 kg")
    with pytest.raises(fb.ModelError, match=r"^8:16: .*42 kg"):
        fb.System.from_text(wrong)


def test_places_in_the_text_are_those_of_what_somebody_wrote() -> None:
    text = "bodies: {w: {disk: {mass: 1 kg, radius: 1 m, at: [2 m, 0]}}}\nloads: {gravity: 9.81 m/s^2}\n"
    document = fb.System.from_text(text).document
    for path, words in ((("bodies", "w", "at"), "[2 m, 0]"), (("loads", "gravity", "gravity"), "9.81 m/s^2")):
        span = document.span(path)
        assert span is not None
        assert text[slice(*span)] == words
    key = document.key_span(("bodies", "w", "at"))
    assert key is not None
    assert text[slice(*key)] == "at"


def test_a_list_of_things_of_one_kind_is_told_where_one_is_wrong() -> None:
    with pytest.raises(fb.ModelError, match="contact has no mass"):
        fb.System.from_text(BASE + "contacts:\n- {between: [rod.end, floor], mass: 2 kg}")


def test_a_speed_and_its_direction_are_a_velocity(agrees: Callable[[fb.Solution, str, str], None]) -> None:
    text = """
parameters: {v: 20 m/s, alpha: 35 deg, h: 2 m, u: -3 m/s}
bodies:
  ball:
    particle: {mass: 1 kg}
    position: (0, h)
    speed: v
    direction: alpha
  other: {particle: {mass: 1 kg}, speed: u, direction: left}
questions: [velocity of ball along up at start, height of ball at start, velocity of other along right at start]
"""
    solution = fb.System.from_text(text).solve()
    for question, formula in (("q1", "v*sin(alpha)"), ("q2", "h"), ("q3", "-u")):
        agrees(solution, question, formula)
    assert "u = -3 m/s is negative, so that formulas let it have either sign" in map(str, solution.assumptions)


def test_a_slider_of_two_bodies_is_one_for_each() -> None:
    system = fb.System.from_text(BASE + "connections: {track: {slider: {bodies: [rod, block], along: right}}}")
    assert [system.connections[name].body for name in ("track_rod", "track_block")] == ["rod", "block"]


def test_a_beam_is_read_as_its_length_supports_and_loads(agrees: Callable[[fb.Solution, str, str], None]) -> None:
    text = """
parameters: {a: 5 m, b: 1 m, q: 4 kN/m, F: 5 kN, M: 3 kN m}
beam: {length: a + b}
supports: {A: pin at 0 m, B: roller at a}
loads:
- {type: distributed, from: 0 m, to: a/2, value: q}
- {type: point, at: a + b, value: F}
- {type: moment, at: a/2, value: M}
questions: [reaction of B along up, reaction of A along up]
"""
    solution = fb.System.from_text(text).solve()
    agrees(solution, "q1", "(q*a**2/8 + F*(a + b) - M)/a")  # about A
    agrees(solution, "q2", "q*a/2 + F - (q*a**2/8 + F*(a + b) - M)/a")
    assert "loads without a direction act downwards" in str(solution.assumptions)
    named = "beam: 4 m\nsupports: {W: {fixed: 0}}\nloads: {P: {type: force, at: 4 m, value: 2 kN, direction: up}}\n"
    system = fb.System.from_text(named)
    assert system.solve("moment of W on beam").answers[0].value == pytest.approx(-8000)
    with pytest.raises(fb.ModelError, match=r"^3:\d+: .*2 kg"):
        fb.System.from_text(named.replace("2 kN", "2 kg"))


LINKAGE = """
points: {A: [0, 0], B: [30 mm, 52 mm], C: [120 mm, 85 mm], D: [110 mm, 0]}
links: {crank: [A, B], coupler: {from: B, to: C}, rocker: [C, D]}
motor: {on: crank, speed: 10 rad/s}
questions: [angular velocity of rocker at start, angular velocity of coupler at start]
"""


@pytest.mark.parametrize("held", ["ground: [A, D]", "joints: {A: pin to ground, B: pin, D: fixed}", "fixed: [A, D]"])
def test_a_linkage_is_read_as_its_points_and_links(held: str) -> None:
    rocker, coupler = (answer.value for answer in fb.System.from_text(LINKAGE + held).solve().answers)
    # 10 (-52, 30) + w_c (-33, 90) = w_r (-85, 10)
    assert -520 - 33 * coupler == pytest.approx(-85 * rocker)
    assert 300 + 90 * coupler == pytest.approx(10 * rocker)


def test_links_with_a_mass_are_bodies() -> None:
    text = (
        "links: [{name: upper, length: 1 m, mass: 2 kg}]\n"
        "joints: [{name: j, type: pin, parent: world, child: upper, friction: 0.1}]"
    )
    with pytest.raises(fb.ModelError) as told:
        fb.System.from_text(text)
    assert len(told.value.problems) == 1
    assert "it names the points that meet" in str(told.value)


def test_a_truss_may_be_given_by_lists() -> None:
    text = """
nodes: [{name: A, x: 0, y: 0}, {name: B, x: 0, y: 3 m}, {name: C, x: 4 m, y: 0}]
elements: [[A, C], [B, C]]
supports: {A: fixed, B: fixed}
loads: {F: 12 kN down at C}
questions: [force in AC, force in BC]
"""
    first, second = (answer.value for answer in fb.System.from_text(text).solve().answers)
    assert (first, second) == (pytest.approx(-16000), pytest.approx(20000))


def test_a_beam_may_be_given_in_german() -> None:
    text = """
balken: {länge: 3 m}
lager: {A: {typ: einspannung, x: 0}}
lasten: {F: {typ: kraft, x: 3 m, wert: 2 kN}, q: {typ: streckenlast, von: 0, bis: 3 m, wert: 1 kN/m}}
fragen: [Einspannmoment]
"""
    (answer,) = fb.System.from_text(text).solve().answers
    assert answer.value == pytest.approx(2000 * 3 + 1000 * 9 / 2)


def test_places_in_round_brackets_stand_in_braces_too() -> None:
    text = "bodies: {rod: {bar: {from: (1 m, 2 m), length: 3 m}, angle: 0}}"
    start = fb.System.from_text(text).bodies["rod"].start
    assert str(start) == str(fb.System.from_text(text.replace("(", "[").replace(")", "]")).bodies["rod"].start)
    assert start.at is not None
    assert start.at[0] == "start"


def test_the_ends_of_a_rod_may_stand_in_its_shape() -> None:
    loose, strict = (
        fb.System.from_text(f"bodies: {{ladder: {{rod: {{{each}}}}}}}").bodies["ladder"].start
        for each in ("start: [0, 0], end: [3 m, 4 m]", "from: [0, 0], to: [3 m, 4 m]")
    )
    assert str(loose) == str(strict)
    assert loose.at is not None


def test_one_point_without_a_place_is_the_origin_beside_coordinates() -> None:
    text = "bodies: {rod: {rod: {length: 1 m, mass: 1 kg}}}\nconnections: {p: {pin: [ground.O, rod.start]}}\n"
    system = fb.System.from_text(text + "loads: {s: {spring: {from: [2 m, 0], to: rod.end, k: 5 N/m}}}")
    points = system.bodies["ground"].points
    assert points["O"] == points["origin"]


def test_a_table_that_nobody_declares_is_a_level_plane_in_space() -> None:
    text = "space: true\nbodies: {b: {sphere: {mass: 1 kg, radius: 1 m}}}\nconnections: {c: {contact: [b, table]}}"
    system = fb.System.from_text(text)
    assert "table is not declared: it is the horizontal plane through the origin" in map(str, system.assumptions)


HELD = """
parameters: {m: 2 kg, R: 0.1 m, mu: 0.3}
bodies: {crate: {block: {mass: m}}, drum: {disk: {mass: m, radius: R}}}
ground: {lines: {slope: {angle: 30 deg}}}
connections: {}
"""
LIES = "{contact: {between: [crate, slope], friction: mu}}"


@pytest.mark.parametrize(
    ("loose", "strict"),
    [
        ({"block: {mass: m}": "block: {mass: m}, on: slope, mu: mu"}, f"{{crate_on_slope: {LIES}}}"),
        (
            {"{block: {mass: m}}": "{type: block, mass: m, on: slope}", "30 deg": "30 deg, friction: mu"},
            f"{{crate_on_slope: {LIES}}}",
        ),
        (
            {
                "{}": "{c: {contact: [crate, slope]}}",
                "{lines: {slope: {angle: 30 deg}}}": "{slope: {angle: 30 deg, mu: mu}}",
            },
            f"{{c: {LIES}}}",
        ),
        (
            {
                "{}": "{c: {contact: [crate, slope]}}",
                "ground: {lines: {slope: {angle: 30 deg}}}": "surfaces: {slope: {angle: 30 deg, mu: mu}}",
            },
            f"{{c: {LIES}}}",
        ),
        ({"radius: R}": "radius: R}, pivot: [0, 1 m]"}, "{drum_pivot: {pin: [[0, 1 m], drum]}}"),
        (
            {"{}": "{c: {contact: [crate, ground]}}", "{lines: {slope: {angle: 30 deg}}}": "{y: 1 m}"},
            "{c: {contact: [crate, floor]}}",
        ),
    ],
)
def test_bodies_and_lines_may_say_how_they_are_joined(loose: dict[str, str], strict: str) -> None:
    text = HELD
    for old, new in loose.items():
        text = text.replace(old, new)
    plain = HELD.replace("connections: {}", f"connections: {strict}")
    if "y: 1 m" in text:
        plain = plain.replace("slope: {angle: 30 deg}", "floor: {along: right, through: [0, 1 m]}")
    assert fb.System.from_text(text).connections == fb.System.from_text(plain).connections


def test_what_is_round_and_what_has_ends_is_asked_how_it_is_held() -> None:
    text = (
        "parameters: {m: 2 kg}\nbodies: {drum: {disk: {mass: m}, on: floor}, bar: {rod: {mass: m}, pivot: [0, 1 m]}}\n"
    )
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(text)
    told = [problem.message for problem in refused.value.problems]
    assert len(told) == 2
    assert "{drum_on_floor: {contact: {between: [drum, floor]}}}" in told[0]
    assert "{bar_pivot: {pivot: [[0, 1 m], bar.POINT]}}" in told[1]


def test_a_mass_with_points_or_another_name_is_no_particle() -> None:
    for body, more in (("b", "connections: {p: {pin: [ground.A, b.end]}}"), ("wheel", "")):
        with pytest.raises(fb.ModelError, match=f"{body} needs a shape"):
            fb.System.from_text(f"bodies: {{{body}: {{mass: 1 kg}}}}\n{more}")


def test_forces_of_a_truss_stand_at_its_nodes() -> None:
    text = """
Knoten: {A: [0 m, 0 m], B: [4 m, 0 m], C: [2 m, 2 m]}
rods: {1: [A, B], 2: [A, C], 3: [B, C]}
lager: {A: festlager, B: loslager}
loads: {C: {Fx: 0, Fy: -10 kN}}
questions: [tension of member_1, tension of member_2]
"""
    first, second = fb.System.from_text(text).solve().answers
    assert first.value == pytest.approx(5000.0)
    assert second.value == pytest.approx(-10e3 / 2**0.5)


def test_a_start_may_say_where_bodies_are() -> None:
    base = "parameters: {h: 3 m, v: 2 m/s, a: 30 deg}\nbodies: {p: {particle: {mass: 1 kg}%s}}\n"
    strict = fb.System.from_text(base % ", at: [0, h], velocity: [(v)*cos(a), (v)*sin(a)]")
    for start in (
        "{position of p: [0, h], velocity of p: {speed: v, angle: a}}",
        "{p: {at: [0, h], velocity: [(v)*cos(a), (v)*sin(a)]}}",
    ):
        assert fb.System.from_text(f"{base % ''}start: {start}\n").bodies == strict.bodies


def test_a_level_line_is_one_to_the_right() -> None:
    level, right = (
        fb.System.from_text(f"ground: {{lines: {{road: {way}}}}}\nbodies: {{p: {{particle: {{mass: 1 kg}}}}}}\n")
        for way in ("horizontal", "right")
    )
    assert level.bodies == right.bodies


def test_supports_of_a_truss_may_be_a_list() -> None:
    text = """
points: {A: [0, 0], B: [4 m, 0], C: [2 m, 2 m]}
bars: [[A, B], [A, C], [B, C]]
supports: [{at: A, type: pin}, {at: B, type: roller}]
forces: [{at: C, force: 10 kN, direction: down}]
questions: [tension of AB]
"""
    (answer,) = fb.System.from_text(text).solve().answers
    assert answer.value == pytest.approx(5000.0)


def test_shapes_may_have_sections_of_their_own() -> None:
    loose = fb.System.from_text("pulleys: {p: {radius: 1 m, inertia: 2 kg m^2, at: [0, 1 m]}}\nbearings: {b: p}\n")
    strict = fb.System.from_text(
        "bodies: {p: {pulley: {radius: 1 m, inertia: 2 kg m^2}, at: [0, 1 m]}}\n"
        "connections: {b: {pin: [ground.b, p]}}\n"
    )
    assert loose.bodies == strict.bodies
    assert loose.connections == strict.connections


def test_a_load_of_a_beam_that_cannot_be_read_is_told_alone() -> None:
    text = """
beam: {length: 6 m}
supports: {A: {type: pin, at: 0}, B: {type: roller, at: 4 m}}
loads: [{type: triangular, from: 0, to: 4 m, max: 6 kN/m}]
"""
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(text)
    (problem,) = refused.value.problems
    assert "a load that rises evenly is distributed with both values" in problem.message


def test_a_beam_may_hold_its_supports_and_loads() -> None:
    text = """
beam:
  length: 8 m
  supports: {A: {type: pin, position: 0 m}, B: {type: roller, position: 6 m}}
  loads: [{point load: 12 kN, position: 3 m}, {distributed load: 2 kN/m, from: 6 m, to: 8 m}]
questions: [normal force of B]
"""
    (answer,) = fb.System.from_text(text).solve().answers
    # moments about A: 6 B = 12 kN 3 + 4 kN 7
    assert answer.value == pytest.approx(64e3 / 6)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("car: {mass: 2 kg, wheelbase: 2 m}", "car is a body, which stands under bodies"),
        ("bodies: {b: {type: bal, mass: 2 kg}}", "there is no shape bal"),
        ("bodies: {b: {mass: 2 kg}}\nloads: {b: 3 N}", "say where it acts and which way, e.g. b: 3 N down at BODY"),
        (
            "bodies: {b: {mass: 2 kg}}\nloads: {F: {force: {on: b, towards: P, magnitude: 2 N}}}",
            "a force that keeps pointing to a place is that of a string",
        ),
        (
            "bodies: {b: {particle: {mass: 2 kg}}}\nloads: {s: {spring: [ground.A, b], k: 3 N/m}}\n"
            "ground: {A: [-1 m, 0]}\nmeasures: {x: x of b}\nstart: {x: 0.1 m}",
            "the spring has no length, and may be stretched where x starts",
        ),
        ("bodies: {b: {mass: 2 kg}}\nmeasures: {v: speed of b}", "'speed of b' is a rate: name what changes"),
        ("bodies: {d: {disk: {mass: 2 kg, radius: 2 m, inner_radius: 1 m}}}", "a smaller circle for a rope is its hub"),
        (
            "bodies: {d: {disk: {mass: 2 kg}}}\nconnections: {s: {string: {from: ground.A, to: d}, wound: true}}",
            "what it is wound on is one of its ends",
        ),
        ("bodies: {d: {disk: {mass: 2 kg}}}\nloads: [{drive torque: 2 N m, on: d}]", "say of which kind it is"),
    ],
)
def test_one_cause_is_one_message(text: str, told: str) -> None:
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(f"{text}\n")
    (problem,) = refused.value.problems
    assert told in problem.message


@pytest.mark.parametrize(
    "angle",
    [
        "angle of rod clockwise from up",
        "angle of rod from up clockwise",
        "clockwise angle of rod from up",
        "angle of line from rod.start to rod.end clockwise from up",
    ],
)
def test_an_angle_may_be_counted_clockwise_before_or_behind_its_direction(angle: str) -> None:
    """A rod 60 degrees above the horizontal stands 30 degrees clockwise of the vertical."""
    text = f"""
bodies: {{rod: {{rod: {{mass: 1 kg, length: 1 m}}, angle: 60 deg}}}}
connections: {{hinge: {{pin: [ground.O, rod.start]}}}}
measures: {{theta: {angle}}}
"""
    assert posed(text, "theta at start").value == pytest.approx(math.pi / 6)
