"""Files that leave out what the figure of a textbook shows: axles, places, sizes and lengths that follow from it. What
is taken from there is told, and gives the same as the file that says it."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.language.expression import evaluate

BASE = """
parameters: {m: 2 kg, M: 3 kg, L: 6 m, R: 0.1 m, r: 0.04 m, k: 50 N/m, c: 2 N s/m, mu: 0.3, F: 5 kN, q: 2 kN/m, a: 1 m,
  alpha: 30 deg, v: 4 m/s, w: 30 rad/s, g: 9.81 m/s^2}
"""
SAME = {
    "the coefficient of friction in full": (
        "bodies: {b: {block: {mass: m}}}\nconnections: {c: {contact: [b, floor], coefficient of friction: mu}}",
        "bodies: {b: {block: {mass: m}}}\nconnections: {c: {contact: {between: [b, floor], friction: mu}}}",
    ),
    "what touches and how rough it is": (
        "bodies: {b: {rod: {length: L}, angle: alpha}}\nconnections: {c: {b.start, on: floor, mu: mu}}",
        "bodies: {b: {rod: {length: L}, angle: alpha}}\nconnections: {c: {contact: {between: [b.start, floor], "
        "friction: mu}}}",
    ),
    "what touches in words": (
        "bodies: {b: {block: {mass: m}}}\nconnections: {c: b on floor}",
        "bodies: {b: {block: {mass: m}}}\nconnections: {c: {contact: [b, floor]}}",
    ),
    "what rolls as far as friction lets it": (
        "bodies: {b: {disk: {mass: m, radius: R}}}\nconnections: {c: {rolls: b, on: floor, mu: mu}}",
        "bodies: {b: {disk: {mass: m, radius: R}}}\nconnections: {c: {contact: {between: [b, floor], friction: mu}}}",
    ),
    "commas between coordinates and names": (
        "ground: {points: {A: '0, -h'}}\nbodies: {b: {rod: {length: L}}}\nconnections: {p: {pin: 'ground.A, b.start'}}"
        "\nparameters: {h: 1 m, L: 6 m}",
        "ground: {points: {A: ['0', -h]}}\nbodies: {b: {rod: {length: L}}}\n"
        "connections: {p: {pin: [ground.A, b.start]}}\nparameters: {h: 1 m, L: 6 m}",
    ),
    "a body fastened to another one": (
        "bodies: {b: {rod: {length: L}}, tip: {mass: m, attached_to: b.end}}\nconnections: {p: {pin: b.start}}",
        "bodies: {b: {rod: {length: L}}, tip: {particle: {mass: m}}}\nconnections: {p: {pin: [ground.p, b.start]}, "
        "tip_attached: {weld: [b.end, tip]}}",
    ),
    "how fast a wheel turns": (
        "bodies: {b: {disk: {mass: m, radius: R}, speed: 1500 rpm}}\nconnections: {p: {pin: b}}",
        "bodies: {b: {disk: {mass: m, radius: R}, angular_velocity: 1500 rpm}}\nconnections: {p: {pin: [ground.p, b]}}",
    ),
    "places along the only beam": (
        "bodies: {beam: {length: L}}\nsupports: {A: {pin: beam.start}, B: {roller: beam.end}}\n"
        "loads: {F: {force: F, at: 5 m, direction: down}, q: {distributed: q, from: 0, to: 4 m, direction: down}}",
        "bodies: {beam: {rod: {length: L}, points: {F: [5 m - L/2, 0], q_to: [4 m - L/2, 0]}}}\n"
        "connections: {A: {pin: [ground.A, beam.start]}, B: {slot: {pin: beam.end, along: right}}}\n"
        "loads: {F: {force: {at: beam.F, along: down, magnitude: F}}, "
        "q: {distributed: {between: [beam.start, beam.q_to], intensity: q, along: down}}}",
    ),
    "a load by the unit of its value": (
        "bodies: {b: {rod: {length: L}}}\nconnections: {A: {clamped: b.start}}\n"
        "loads: {P: {at: b.end, value: F, direction: down}}",
        "bodies: {b: {rod: {length: L}}}\nconnections: {A: {weld: [ground.A, b.start]}}\n"
        "loads: {P: {force: {at: b.end, along: down, magnitude: F}}}",
    ),
    "a rope between two bodies over a pulley": (
        "bodies: {a1: {mass: m}, b1: {mass: M}, pulley: {disk: {radius: R}}}\n"
        "connections: {rope: {between: [a1, b1], pulley: pulley}}",
        "bodies: {a1: {particle: {mass: m}}, b1: {particle: {mass: M}}, pulley: {disk: {radius: R}}}\n"
        "connections: {rope: {string: {from: a1, over: [pulley], to: b1}}, "
        "axle_of_pulley: {pin: [ground.axle_of_pulley, pulley]}}",
    ),
    "a rope that pulls a block up a slope": (
        "ground: {slope: {angle: alpha}}\nbodies: {a1: {mass: m}, b1: {mass: M}, pulley: {disk: {radius: R}}}\n"
        "connections: {c: {contact: [a1, slope], mu: mu}, p: {pin: pulley}, rope: [a1, pulley, b1]}",
        "ground: {lines: {slope: {angle: alpha}}}\n"
        "bodies: {a1: {particle: {mass: m}}, b1: {particle: {mass: M}}, pulley: {disk: {radius: R}}}\n"
        "connections: {c: {slider: {body: a1, along: slope, friction: mu}}, p: {pin: [ground.p, pulley]}, "
        "rope: {string: {from: a1, over: [pulley], to: b1}}}",
    ),
    "a rope that begins at a drum": (
        "bodies: {drum: {disk: {mass: M, radius: R}}, load: {mass: m}}\n"
        "connections: {axle: {pin: drum}, rope: {from: drum, to: load}}",
        "bodies: {drum: {disk: {mass: M, radius: R}}, load: {particle: {mass: m}}}\n"
        "connections: {axle: {pin: [ground.axle, drum]}, rope: {string: {from: wound on drum, to: load}}}",
    ),
    "a rope on a smaller radius": (
        "bodies: {d: {disk: {mass: M, radius: R}}}\nconnections: {string: {from: ceiling, to: d, radius: r}}",
        "bodies: {d: {disk: {mass: M, radius: R}}}\n"
        "connections: {string: {string: {from: ceiling, to: wound on d radius r}}}",
    ),
    "point masses on each other": (
        "bodies: {top: {block: {mass: m}}, low: {block: {mass: M}}}\n"
        "connections: {c: {contact: [top, low], mu: mu}, d: {contact: [low, floor]}}",
        "bodies: {top: {particle: {mass: m}}, low: {particle: {mass: M}}}\n"
        "connections: {c: {slider: {body: top, 'on': low, along: right, friction: mu}}, d: {contact: [low, floor]}}",
    ),
    "a point mass on a block": (
        "bodies: {top: {mass: m}, low: {block: {mass: M, width: a, height: R}}}\n"
        "connections: {c: {contact: [low, top], mu: mu}, d: {contact: [low, floor]}}",
        "bodies: {top: {particle: {mass: m}}, low: {rectangle: {mass: M, width: a, height: R}}}\n"
        "connections: {c: {contact: {between: [top, low.top], friction: mu}}, d: {contact: [low, floor]}}",
    ),
    "a mass on a spring": (
        "bodies: {b: {mass: m}}\nsprings: {s: {between: [wall, b], k: k}}\nstart: {x: 5 cm, velocity: v}",
        "parameters: {m: 2 kg, k: 50 N/m, v: 4 m/s, l_s: m}\nground: {points: {wall: [-l_s, 0]}}\n"
        "bodies: {b: {particle: {mass: m}}}\nconnections: {guide_of_b: {slider: {body: b, along: right}}}\n"
        "loads: {s: {spring: {first: wall, second: b, stiffness: k, length: l_s}}}\nmeasures: {x: x of b}\n"
        "start: {x: 5 cm, rate(x): v}",
    ),
    "a driver that begins at an angle": (
        "bodies: {crank: {length: a}}\nconnections: {p: {pin: crank.start}}\ndrive: {crank: {angle: 60 deg, speed: w}}",
        "bodies: {crank: {rod: {length: a}, angle: 60 deg}}\n"
        "connections: {p: {pin: [ground.p, crank.start]}, crank: {driver: {body: crank, speed: w}}}",
    ),
    "a velocity along a guide": (
        "bodies: {b: {mass: m, velocity: v}}\nconnections: {s: {slider: b, along: alpha}}",
        "bodies: {b: {particle: {mass: m}, velocity: [v*cos(alpha), v*sin(alpha)]}}\n"
        "connections: {s: {slider: {body: b, along: alpha}}}",
    ),
    "two bodies on one guide": (
        "bodies: {b: {mass: m, velocity: v}, d: {mass: M, velocity: 0, position: 1 m}}\n"
        "connections: {s: {guide: [b, d], direction: horizontal}}",
        "bodies: {b: {particle: {mass: m}, velocity: [v, 0]}, "
        "d: {particle: {mass: M}, velocity: [0, 0], at: [1 m, 0]}}\n"
        "connections: {s_b: {slider: {body: b, along: horizontal}}, s_d: {slider: {body: d, along: horizontal}}}",
    ),
    "a hinge at a point of a rod": (
        "bodies: {b: {rod: {mass: m, length: L}}}\nconnections: {p: {type: hinge, at: b.start}}",
        "bodies: {b: {rod: {mass: m, length: L}}}\nconnections: {p: {pin: [ground.p, b.start]}}",
    ),
    "a bearing at a place": (
        "bodies: {b: {disk: {mass: m, radius: R}}}\nconnections: {p: {bearing: b, at: [0, a]}}",
        "bodies: {b: {disk: {mass: m, radius: R}}}\nconnections: {p: {pin: [[0, a], b]}}",
    ),
    "the end of a cable beside the wall": (
        "bodies: {b: {rod: {length: L}}}\n"
        "connections: {p: {pin: b.start}, c: {cable: {from: wall, at: [0, a], to: b.end}}}",
        "bodies: {b: {rod: {length: L}}}\n"
        "connections: {p: {pin: [ground.p, b.start]}, c: {string: {from: [0, a], to: b.end}}}",
    ),
    "a slot by its own name": (
        "bodies: {b: {rod: {length: L}}, yoke: {mass: m}}\nconnections: {p: {pin: b.start}, "
        "slot: {pin: b.end, slot_in: yoke, direction: vertical}}",
        "bodies: {b: {rod: {length: L}}, yoke: {particle: {mass: m}}}\nconnections: {p: {pin: [ground.p, b.start]}, "
        "slot: {slot: {pin: b.end, 'on': yoke, along: vertical}}}",
    ),
    "a slope that is rough under what rolls": (
        "ground: {slope: {angle: -alpha, friction: mu}}\nbodies: {b: {solid_cylinder: {mass: m, radius: R}}}\n"
        "connections: {c: {rolling: [b, slope]}}",
        "ground: {lines: {slope: {angle: -alpha}}}\nbodies: {b: {disk: {mass: m, radius: R}}}\n"
        "connections: {c: {contact: {between: [b, slope], friction: mu}}}",
    ),
    "a point mass on the slope of a wedge": (
        "bodies: {b: {mass: m, 'on': low.slope}, low: {wedge: {mass: M, angle: alpha, length: a}, 'on': floor}}",
        "bodies: {b: {particle: {mass: m}}, low: {wedge: {mass: M, angle: alpha, length: a}}}\n"
        "connections: {b_on_low_face: {slider: {body: b, along: low.face}}, low_on_floor: {contact: [low, floor]}}",
    ),
    "a force at a place of a body": (
        "bodies: {b: {disk: {mass: m, radius: R}}}\nloads: {P: {force: F, 'on': b, at: [0, -r], direction: right}}",
        "bodies: {b: {disk: {mass: m, radius: R}, points: {P: [0, -r]}}}\n"
        "loads: {P: {force: {at: b.P, along: right, magnitude: F}}}",
    ),
    "a free end that is pulled": (
        "bodies: {load: {mass: m}, pulley: {disk: {radius: R}}}\nconnections: {p: {pin: pulley}, "
        "rope: [load, pulley, hand]}\nloads: {P: {force: F, at: hand, direction: down}}",
        "bodies: {load: {particle: {mass: m}}, pulley: {disk: {radius: R}}, hand: {particle: {}}}\n"
        "connections: {p: {pin: [ground.p, pulley]}, rope: {string: {from: load, over: [pulley], to: hand}}}\n"
        "loads: {P: {force: {at: hand, along: down, magnitude: F}}}",
    ),
}


def _plain(text: str) -> tuple[object, ...]:
    system = fb.System.from_text(text if "parameters:" in text else BASE + text)
    loads = sorted(map(str, system.applied_loads))
    starts = {name: (body.start, body.points, body.mass) for name, body in system.bodies.items()}
    return system.constraint_rows, loads, starts, system.start, system.start_rates


@pytest.mark.parametrize("name", SAME)
def test_what_the_figure_shows_is_read(name: str) -> None:
    short, full = SAME[name]
    found, wanted = _plain(short), _plain(full)
    for one, other in zip(found, wanted, strict=True):
        assert one == other


def test_a_planetary_gear_by_its_teeth_follows_willis() -> None:
    # omega_C = omega_S z_S/(z_S + z_R) with the ring at rest
    system = fb.System.from_text(
        "planetary: {sun: 24, planet: 18, ring: {teeth: 60, fixed: true}}\nstart: {sun: 300 rpm}\n"
        "questions: [ratio of angular velocity of carrier to angular velocity of sun]\n"
    )
    assert float(system.solve()["q1"].value) == pytest.approx(24 / 84)


def test_teeth_of_the_planet_are_those_that_fit() -> None:
    system = fb.System.from_text("planetary: {sun: 24, ring: 60, fixed: ring, module: 2 mm}\n")
    radius = system.bodies["planet"].radius
    assert radius is not None
    assert evaluate(radius, {}) == pytest.approx(0.018)


@pytest.mark.parametrize(
    "gear",
    [
        "planetary: {N_sun: 24, N_ring: 72, fixed: ring, input: {sun: 1000 rpm}}",
        "planetary_gear: {sun_teeth: 24, planet_teeth: 24, ring_teeth: 72, fixed: ring}\ninput: {sun: 1000 rpm}",
        "epicyclic: {teeth: {sun: 24, ring: 72}, fixed_member: ring, number_of_planets: 3, drive: {sun: 1000 rpm}}",
    ],
)
def test_a_planetary_gear_may_have_its_teeth_by_the_parts(gear: str) -> None:
    # omega_C = omega_S z_S/(z_S + z_R) = n/4
    system = fb.System.from_text(gear + "\n")
    assert float(system.solve("angular velocity of carrier")["q1"].value) == pytest.approx(1000 * math.pi / 30 / 4)
    assert not system.warnings


@pytest.mark.parametrize(
    "linkage",
    [
        "four_bar: {a: 40 mm, b: 120 mm, c: 80 mm, d: 100 mm}\nstart: {crank: 60 deg, rate(angle of crank): 10 rad/s}",
        "linkage: {frame: 100 mm, crank: 40 mm, rocker: 80 mm, coupler: 120 mm, crank_angle: 60 deg, "
        "crank_speed: 10 rad/s}",
        "fourbar: {r1: 10 cm, r2: 4 cm, r3: 12 cm, r4: 8 cm, theta2: 60 deg, omega2: 10 rad/s}",
        "four_bar: {input: 40 mm, output: 80 mm, coupler: 120 mm, ground: 100 mm, input_angle: 60 deg, "
        "input_speed: 10 rad/s}",
    ],
)
def test_a_four_bar_may_have_its_lengths_by_the_parts(linkage: str) -> None:
    # omega_4 = (a omega_2/c) sin(theta_2 - theta_3)/sin(theta_4 - theta_3) (Norton, Design of Machinery, sec. 6.7)
    system = fb.System.from_text(linkage + "\n")
    last = [*system.bodies][-1]
    x, y = 0.1 - 0.04 * math.cos(math.pi / 3), -0.04 * math.sin(math.pi / 3)  # from the crankpin to the other pivot
    apart = math.hypot(x, y)
    coupler = math.atan2(y, x) + math.acos((0.12**2 + apart**2 - 0.08**2) / (2 * 0.12 * apart))
    rocker = math.atan2(-y + 0.12 * math.sin(coupler), -x + 0.12 * math.cos(coupler))
    speed = 0.5 * 10 * math.sin(math.pi / 3 - coupler) / math.sin(rocker - coupler)
    assert float(system.solve(f"angular velocity of {last}")["q1"].value) == pytest.approx(speed)


def test_axles_of_gears_stand_where_the_teeth_have_them() -> None:
    text = """
bodies: {a: {gear: {teeth: 20, m: 4 mm}}, b: {gear: {teeth: 60, m: 4 mm}}, c: {gear: {teeth: 40, m: 4 mm}}}
connections: {p: {pin: a}, q: {pin: b}, s: {pin: c}, one: {gears: [a, b]}, two: {gears: [b, c]}}
"""
    system = fb.System.from_text(text)
    assert not system.warnings
    assert "the axles p, q, s stand side by side, as far apart as the gears mesh" in map(str, system.assumptions)


def test_a_train_of_gears_turns_in_bearings_that_nobody_writes() -> None:
    system = fb.System.from_text(
        "bodies: {a: {gear: {teeth: 12}}, b: {gear: {teeth: 36}}, c: {gear: {teeth: 24}}}\nmeshes: [[a, b], [b, c]]\n"
        "drive: {a: 900 rpm}\nquestions: [ratio of angular velocity of c to angular velocity of a]\n"
    )
    assert float(system.solve()["q1"].value) == pytest.approx(12 / 24)
    assert "nothing holds a, b, c: each turns in a bearing that stands still" in map(str, system.assumptions)


GEARS = """
parameters: {M: 5 N m, I_A: 0.05 kg m^2, I_B: 0.8 kg m^2, r: 0.12 m, m: 50 kg, g: 9.81 m/s^2}
bodies:
  A: {gear: {inertia: I_A, teeth: 20, module: 5 mm}}
  B: {gear: {inertia: I_B, teeth: 60, module: 5 mm}}
"""


@pytest.mark.parametrize("ground", ["", "ground: {points: {O: [1 m, 2 m]}}\n"])
def test_the_gear_that_the_file_leaves_without_an_axle_turns_in_a_bearing(ground: str) -> None:
    # the torque M at A is 3 M at B, and the inertia of A counts 9 times there: phi'' = -3 M/(9 I_A + I_B)
    system = fb.System.from_text(
        GEARS + ground + "connections: {axle: {pin: [ground.O, A]}, mesh: {gear_mesh: [A, B]}}\n"
        "loads: {M: {torque: {on: A, magnitude: M}}, w: {gravity: g}}\nmeasures: {phi: angle of B}\n"
    )
    assert float(system.solve("acceleration of phi")["q1"].value) == pytest.approx(-15 / 1.25)
    told = [str(each) for each in system.assumptions]
    assert "nothing holds B: it turns in a bearing that stands still" in told
    assert {each.kind for each in system.warnings} <= {"unused"}


def test_gears_by_which_a_load_hangs_turn_in_bearings() -> None:
    # a load on a drum of the second gear: a rope carries no axle
    system = fb.System.from_text(
        GEARS
        + "connections: {mesh: {gear_mesh: [A, B]}, rope: {string: {path: [wound on B radius r at right, load]}}}\n"
        "loads: {M: {torque: {on: A, magnitude: -M}}, w: {gravity: g}}\nmeasures: {h: height of load}\n".replace(
            "connections:", "  load: {particle: {mass: m}}\nconnections:", 1
        )
    )
    lift = 0.12 * (3 * 5 - 50 * 0.12 * 9.81) / (50 * 0.12**2 + 9 * 0.05 + 0.8)
    assert float(system.solve("acceleration of h")["q1"].value) == pytest.approx(lift)
    assert "nothing holds A, B: each turns in a bearing that stands still" in map(str, system.assumptions)


def test_axles_whose_names_alone_are_given_stand_where_the_teeth_have_them() -> None:
    text = GEARS + (
        "ground: {points: [P, Q]}\n"
        "connections: {a: {pin: [ground.P, A.center]}, b: {pin: [ground.Q, B.center]}, mesh: {gear_mesh: [A, B]}}\n"
    )
    assert {each.kind for each in fb.System.from_text(text).warnings} <= {"unused"}


def test_a_gear_on_a_shaft_needs_no_bearing_of_its_own() -> None:
    # the second gear turns with the drum to which it is welded, whose axle the file gives
    system = fb.System.from_text(
        GEARS + "  drum: {disk: {mass: m, radius: r}}\nground: {points: {O: [0, 0], Q: [0.2 m, 0]}}\n"
        "connections: {a: {pin: [O, A]}, b: {pin: [Q, drum]}, shaft: {weld: [drum, B]}, mesh: {gear_mesh: [A, B]}}\n"
    )
    assert not [each for each in map(str, system.assumptions) if "bearing" in each]


def test_the_axle_of_a_planet_that_the_file_leaves_out_is_not_guessed() -> None:
    text = (
        "bodies: {s: {gear: {teeth: 24, module: 2 mm}}, p: {gear: {teeth: 18, module: 2 mm}},\n"
        "  r: {gear: {teeth: 60, module: 2 mm, internal: true}}}\nconnections: {a: {pin: [ground.O, s]},\n"
        "  b: {pin: [ground.O, r]}, one: {gear_mesh: [s, p]}, two: {gear_mesh: [r, p]}}\n"
    )
    assert not [each for each in map(str, fb.System.from_text(text).assumptions) if "bearing" in each]


def test_a_four_bar_by_its_lengths_is_that_of_its_pins() -> None:
    by_lengths = """
links: {ground: 10 cm, crank: 3 cm, coupler: 9 cm, rocker: 7 cm}
start: {crank_angle: 60 deg}
"""
    by_pins = """
ground: {points: {A: [0, 0], D: [10 cm, 0]}}
bodies: {crank: {rod: {length: 3 cm}}, coupler: {rod: {length: 9 cm}}, rocker: {rod: {length: 7 cm}}}
connections:
  A: {pin: [ground.A, crank.start]}
  B: {pin: [crank.end, coupler.start]}
  C: {pin: [coupler.end, rocker.end]}
  D: {pin: [ground.D, rocker.start]}
start: {angle of crank: 60 deg}
"""
    one, other = (fb.System.from_text(text) for text in (by_lengths, by_pins))
    assert one.constraint_rows == other.constraint_rows
    assert one.start == other.start


def test_two_point_masses_that_collide_stay_on_their_line() -> None:
    # with e = 1 and equal masses they change their velocities
    system = fb.System.from_text(
        "bodies: {a: {mass: 1 kg, position: [0, 0], velocity: [3 m/s, 0]}, b: {mass: 1 kg, position: [1 m, 0]}}\n"
        "collisions: [{between: [a, b], restitution: 1}]\nquestions: [velocity of b after the impact]\n"
    )
    assert "a, b strike each other on one line, on which they stay" in map(str, system.assumptions)
    assert float(system.solve()["q1"].value[0]) == pytest.approx(3.0)


def test_masses_in_a_row_on_springs_have_the_frequencies_of_the_chain() -> None:
    # k(2 -1; -1 1)/m: omega^2 = (3 -+ sqrt 5)/2 k/m
    system = fb.System.from_text(
        "parameters: {m: 2 kg, k: 50 N/m}\nbodies: {a: {mass: m}, b: {mass: m}}\n"
        "springs: {s: {between: [wall, a], k: k}, t: {between: [a, b], k: k}}\nquestions: [natural frequencies]\n"
    )
    first, second = system.solve()["q1"].value
    assert (first * second) == pytest.approx(25.0)
    assert first**2 + second**2 == pytest.approx(75.0)


def test_a_block_pulled_along_a_slope_over_a_loose_pulley_accelerates_as_on_a_guide() -> None:
    text = BASE + (
        "ground: {slope: {angle: alpha}}\nbodies: {block: {mass: m}, weight: {mass: M}, pulley: {disk: {radius: R}}}\n"
        "connections: {c: {contact: [block, slope], mu: 0.1}, rope: {from: block, over: pulley, to: weight}}\n"
        "gravity: g\nquestions: [acceleration of weight along down]\n"
    )
    system = fb.System.from_text(text)
    # (M - m (sin a + mu cos a)) g/(m + M)
    expected = (3 - 2 * (0.5 + 0.1 * 3**0.5 / 2)) * 9.81 / 5
    assert float(system.solve()["q1"].value) == pytest.approx(expected)
    told = [str(a) for a in system.assumptions]
    assert "nothing but rope holds pulley: it turns about an axle that stands still" in told
    assert "rope pulls block parallel to slope, on which it stays" in told


def test_a_boom_without_an_angle_is_told_to_lie_level() -> None:
    text = (
        BASE
        + "bodies: {boom: {length: L}}\nconnections: {A: {pin: boom.start}, c: {cable: {from: [0, a], to: boom.end}}}"
    )
    told = [str(a) for a in fb.System.from_text(text).assumptions]
    assert any(
        each.startswith("nothing says how boom is turned: it lies level, boom.start to the left") for each in told
    )
    with_angle = text.replace("{length: L}", "{length: L, angle: 10 deg}")
    assert not any("lies level" in str(a) for a in fb.System.from_text(with_angle).assumptions)


def test_a_ladder_without_an_angle_asks_for_it() -> None:
    text = BASE + (
        "ground: {lines: {wall: {along: up}}}\nbodies: {ladder: {mass: m, length: L}}\n"
        "connections: {f: {contact: [ladder.start, floor], mu: mu}, t: {contact: [ladder.end, wall]}}\n"
    )
    with pytest.raises(
        fb.ModelError, match=r"nothing says how steep ladder stands: write e\.g\. ladder: \{angle: 60 deg\}"
    ):
        fb.System.from_text(text)
    fb.System.from_text(text.replace("length: L", "length: L, angle: 60 deg"))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("bodies: {b: {disk: {mass: m, radius: R}}}\nstart: {velocity: v}", "start: {rate(x of b): v}"),
        ("bodies: {b: {mass: m}}\nconnections: {c: {bullet sticks to b}}", "weld: [bullet, rod.end], closes: at start"),
        ("bodies: {b: {mass: m}}\nconnections: {c: {bead_on: b}}", "link: [ring, bead, R]"),
        (
            "bodies: {t: {mass: m, acceleration: a}}",
            "guide_of_t: {slider: {body: t, along: right}}, drive_of_t: {driver: {measure: x of t, follows: (a)*t^2/2",
        ),
        (
            "bodies: {b: {rod: {length: L}}, p: {mass: m, position: b.end}}",
            "where b.end is follows from what joins both, a weld or a pin",
        ),
    ],
)
def test_the_cure_stands_in_the_names_of_the_file(text: str, told: str) -> None:
    with pytest.raises(fb.ModelError) as refused:
        fb.System.from_text(BASE + text)
    assert any(told in problem.message for problem in refused.value.problems)
