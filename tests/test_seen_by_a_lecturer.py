"""Problems as lecturers set them, of families that no example has: what is expected stands beside the question, found
by hand from the balance in the comment."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.language.expression import Expr
from freebody.language.notation import to_python

PLATE_ABOUT_ITS_DIAGONAL = """
space: {up: z}
parameters: {m: 6 kg, a: 0.6 m, b: 0.3 m, w: 40 rad/s}
ground: {points: {A: [-sqrt(a^2+b^2)/2, 0, 0]}}
bodies:
  shaft: {body: {}, points: {A: [-sqrt(a^2+b^2)/2, 0, 0], B: [sqrt(a^2+b^2)/2, 0, 0]}}
  plate: {box: {mass: m, size: [a, b, 0]}}
connections:
  A: {spherical: [ground.A, shaft.A]}
  B: {point_on_line: {point: shaft.B, through: ground.A, along: x}}
  hub: {weld: {first: shaft, second: plate, turned: -atan(b/a) about z}}
  d: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of shaft about x}
"""
CHIMNEY = """
parameters: {m: 300 kg, L: 12 m, c: 5 m, th0: 30 deg, g: 9.81 m/s^2}
bodies:
  lower: {rod: {mass: m*c/L, length: c}, at: {start: [0, 0]}, angle: 90 deg - th0}
  upper: {rod: {mass: m*(L-c)/L, length: L - c}, at: {start: [c*sin(th0), c*cos(th0)]}, angle: 90 deg - th0}
connections: {foot: {pin: [ground.O, lower.start]}, joint: {weld: [lower.end, upper.start]}}
loads: {weight: {gravity: g}}
measures: {th: angle of lower from up clockwise}
start: {th: th0, rate(th): 0}
"""
HUNG_ON_A_THREAD = """
parameters: {m: 4 kg, L: 1.5 m, h: 0.8 m, g: 9.81 m/s^2}
ground: {points: {A: [0, h]}}
bodies: {bar: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: 0}}
connections: {thread: {string: {from: ground.A, to: bar.start}}}
loads: {weight: {gravity: g}}
"""
ON_PARALLEL_LINKS = """
parameters: {m: 20 kg, w: 0.6 m, h: 0.3 m, l: 0.9 m, beta: 25 deg, g: 9.81 m/s^2}
ground: {points: {A: [-w/2 - l*sin(beta), h/2 + l*cos(beta)], B: [w/2 - l*sin(beta), h/2 + l*cos(beta)]}}
bodies: {plate: {rectangle: {mass: m, width: w, height: h}, at: [0, 0], angle: 0}}
connections: {s1: {link: [ground.A, plate.top_left]}, s2: {link: [ground.B, plate.top_right]}}
loads: {weight: {gravity: g}}
"""
SPINS_IN_A_CORNER = """
parameters: {m: 7 kg, R: 0.15 m, mu: 0.25, w0: 40 rad/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: down, through: [0, 0]}}}
bodies: {drum: {disk: {mass: m, radius: R}, at: [R, R], angular_velocity: w0}}
connections:
  floor: {contact: {between: [drum, floor], friction: mu}}
  wall: {contact: {between: [drum, wall], friction: mu}}
loads: {weight: {gravity: g}}
measures: {phi: angle of drum}
"""
TWO_STRUCK_RODS = """
parameters: {m: 2 kg, L: 0.7 m, J: 3 N s}
bodies:
  a: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: 0}
  b: {rod: {mass: m, length: L}, at: {start: [L, 0]}, angle: 0}
connections: {P: {pin: [a.end, b.start]}}
loads: {blow: {impulse: {at: b.end, along: up, magnitude: J}}}
"""
TWO_CYLINDERS = """
parameters: {M1: 6 kg, M2: 4 kg, R: 0.2 m, g: 9.81 m/s^2}
bodies: {top: {disk: {mass: M1, radius: R}}, low: {disk: {mass: M2, radius: R}}}
connections:
  axle: {pin: [ground.O, top]}
  rope: {string: {path: [wound on top at right, wound on low at left]}}
loads: {weight: {gravity: g}}
measures: {y: drop of low}
"""
HEADED_ROD = """
parameters: {m: 6 kg, M: 4 kg, L: 1.2 m, R: 0.2 m, phi0: 35 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: up}}}
bodies:
  disk: {disk: {mass: M, radius: R}, near: {at: [L/2, R]}}
  rod: {rod: {mass: m, length: L}, near: {at: [L/4, L/2]}}
connections:
  roll: {rolling: {body: disk, on: floor}}
  axle: {pin: [disk, rod.start]}
  top: {slot: {pin: rod.end, along: wall}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from rod.start to rod.end from up}
start: {phi: phi0, rate(phi): 0}
"""
OBLIQUE = """
parameters: {m1: 2 kg, m2: 3 kg, r: 5 cm, v: 4 m/s, e: 0.7, al: 30 deg, d: 1 m}
bodies:
  a: {disk: {mass: m1, radius: r}, at: [-d, 0], velocity: [v, 0], angular_velocity: 0}
  b: {disk: {mass: m2, radius: r}, at: [0, 2*r*sin(al)], velocity: [0, 0], angular_velocity: 0}
connections: {hit: {contact: {between: [a, b], restitution: e}}}
"""
CLAMP_ON_A_POLE = """
parameters: {W: 200 N, h: 0.3 m, d: 0.1 m, x0: 0.9 m, mu: 0.25}
ground: {lines: {west: {along: up, through: [-d/2, 0]}, east: {along: down, through: [d/2, 0]}}}
bodies:
  arm: {body: {}, at: [0, 0], angle: 0, points: {U: [-d/2, h/2], B: [d/2, -h/2], load: [x0, 0]}}
connections:
  u: {contact: {between: [arm.U, west], friction: mu}}
  b: {contact: {between: [arm.B, east], friction: mu}}
loads: {W: {force: {at: arm.load, along: down, magnitude: W}}}
"""
ROLLER_UNDER_A_BAR = """
parameters: {P: 300 N, L: 1 m, r: 0.1 m, th: 30 deg, mu: 0.3}
ground: {points: {O: [0, 0]}, lines: {floor: {along: right}}}
bodies:
  bar: {rod: {length: L}, at: {start: [0, 0]}, angle: th}
  roller: {disk: {radius: r}, at: [r/tan(th/2), r]}
connections:
  O: {pin: [ground.O, bar.start]}
  f: {contact: {between: [roller, floor], friction: mu, touching: true}}
  b: {contact: {between: [roller, bar], friction: mu, touching: true}}
loads: {P: {force: {at: bar.end, along: down, magnitude: P}}}
"""
DRAWBRIDGE = """
parameters: {m: 100 kg, w: 40 kg, L: 4 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], T: [0, L]}}
bodies: {bridge: {rod: {mass: m, length: L}}, weight: {particle: {mass: w}}}
connections:
  O: {pin: [ground.O, bridge.start]}
  rope: {string: {from: bridge.end, over: [ground.T], to: weight}}
loads: {gravity: {gravity: g}}
measures: {phi: angle of bridge from up clockwise}
start: {phi: 60 deg}
"""
OVER_A_PEG = """
parameters: {m: 2 kg, L: 1.6 m, d: 0.4 m, g: 9.81 m/s^2}
ground: {points: {P: [d, 0]}, lines: {wall: {along: up}}}
bodies: {rod: {rod: {mass: m, length: L}, near: {at: [0.5 m, 0.1 m], angle: 40 deg}}}
connections:
  w: {slot: {pin: rod.start, along: wall}}
  p: {slot: {pin: ground.P, along: rod.x, on: rod}}
loads: {weight: {gravity: g}}
measures: {th: angle of rod}
start: {th: 30 deg, rate(th): 0}
"""
SCISSORS = """
parameters: {W: 100 kg, a: 0.8 m, th0: 35 deg, F: 1500 N, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}, lines: {floor: {along: right}}}
bodies:
  one: {rod: {length: 2*a}, at: {start: [0, 0]}, angle: th0}
  two: {rod: {length: 2*a}, near: {at: [a*cos(th0), a*sin(th0)], angle: 180 deg - th0}}
  table: {rectangle: {mass: W, width: 2*a, height: 0.1 m}, near: {at: [a, 2*a*sin(th0)]}}
connections:
  A: {pin: [ground.A, one.start]}
  M: {pin: [one.mass_center, two.mass_center]}
  B: {slot: {pin: two.start, along: floor}}
  D: {pin: [two.end, table.left]}
  C: {slot: {pin: one.end, along: table.x, on: table, through: table.left}}
loads: {weight: {gravity: g}, F: {force: {at: two.start, along: left, magnitude: F}}}
measures: {th: angle of one, y: y of table}
start: {th: th0, rate(th): 0}
"""
PIPE_IN_PIPE = """
parameters: {M: 5 kg, m: 3 kg, R: 0.5 m, r: 0.1 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {pipe: {ring: {mass: M, radius: R}, at: [0, R]}, roller: {disk: {mass: m, radius: r}, near: {at: [0, r]}}}
connections: {a: {rolling: {body: pipe, on: floor}}, b: {rolling: {body: roller, inside: pipe}}}
loads: {weight: {gravity: g}}
measures: {x: x of pipe, th: angle of line from pipe to roller from down}
start: {x: 0, th: 0}
"""
PLANK_ON_A_DRUM = """
parameters: {m: 8 kg, L: 1 m, h: 0.08 m, R: 0.3 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  drum: {disk: {mass: 1 kg, radius: R}}
  plank:
    rectangle: {mass: m, width: L, height: h}
    near: {at: [0, R + h/2]}
    lines: {under: {through: plank.bottom, along: right}}
connections:
  fix: {weld: [ground.O, drum]}
  roll: {rolling: {body: drum, on: plank.under, below: true}}
loads: {weight: {gravity: g}}
measures: {th: angle of plank}
start: {th: 0}
"""


def answer(model: str, question: str) -> fb.Answer:
    (found,) = fb.solve(fb.System.from_text(model), question).answers
    return found


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # H' = w x H, H = (m b^2 c, m a^2 s)/12 w along the sides, c, s of the diagonal; both bearings make the couple
        (PLATE_ABOUT_ITS_DIAGONAL, "size of reaction of A on shaft", "m*w^2*a*b*(a^2 - b^2)/(12*(a^2 + b^2)^(3/2))"),
        # dH/dt of the upper part about the cut, less the moment of its weight: M = m g sin(th) c (L - c)^2/(4 L^2)
        (CHIMNEY, "size of moment of joint on upper about lower.end at start", "m*g*sin(th0)*c*(L - c)^2/(4*L^2)"),
        # T L/2 = m L^2/12 alpha, and the end that is held does not fall: g - T/m = alpha L/2
        (HUNG_ON_A_THREAD, "tension of thread at start", "m*g/4"),
        (HUNG_ON_A_THREAD, "Beschleunigung von bar.end nach unten am Anfang", "3*g/2"),
        # it moves on circles without turning; moments about the mass centre part the sum m g cos(beta)
        (ON_PARALLEL_LINKS, "force in s1 at start", "m*g*(w*cos(beta) + h*sin(beta))/(2*w)"),
        (ON_PARALLEL_LINKS, "size of acceleration of plate at start", "g*sin(beta)"),
        # N_w = mu N_f and N_f + mu N_w = m g; both rub at R
        (SPINS_IN_A_CORNER, "time when rate(phi) = 0", "w0*R*(1 + mu^2)/(2*mu*(1 + mu)*g)"),
        # the pin hands on P: -4 P = -2 J + 4 P
        (TWO_STRUCK_RODS, "size of impulse of P", "J/4"),
        (TWO_STRUCK_RODS, "angular velocity of b at start", "9*J/(2*m*L)"),
        # T (2/M1 + 2/M2) = g - T/M2
        (TWO_CYLINDERS, "tension of rope", "M1*M2*g/(3*M1 + 2*M2)"),
        (TWO_CYLINDERS, "size of angular acceleration of low", "2*M1*g/((3*M1 + 2*M2)*R)"),
        # m L^2 phi'^2/6 + 3/4 M (L cos(phi) phi')^2 = m g L/2 (cos(phi0) - cos(phi))
        (HEADED_ROD, "velocity of phi when phi = 90 deg", "sqrt(3*g*cos(phi0)/L)"),
        (HEADED_ROD, "acceleration of phi at start", "m*g*sin(phi0)/(2*L*(m/3 + 3*M*cos(phi0)^2/2))"),
        # only the velocity along the line of centres changes
        (OBLIQUE, "speed of b after the impact", "(1 + e)*m1*v*cos(al)/(m1 + m2)"),
        (OBLIQUE, "energy lost in the impact", "m1*m2*(1 - e^2)*v^2*cos(al)^2/(2*(m1 + m2))"),
        (OBLIQUE, "size of impulse of hit on b in the impact", "m1*m2*(1 + e)*v*cos(al)/(m1 + m2)"),
        # N h = W x0 and W <= 2 mu N
        (CLAMP_ON_A_POLE, "least x0 so that it stays at rest", "h/(2*mu)"),
        # a roller without weight is pressed along one line, through both places of contact: at th/2 to their normals
        (ROLLER_UNDER_A_BAR, "least mu so that it stays at rest", "tan(th/2)"),
        # c (L - c)^2; beyond L the upper part would have no mass
        (CHIMNEY, "value of c for which size of moment of joint on upper about lower.end at start is largest", "L/3"),
        # virtual work: F d(2 a cos(th)) = -W g d(2 a sin(th))
        (SCISSORS, "value of F for which acceleration of th = 0 at start", "W*g*cos(th0)/sin(th0)"),
        # V'' = m g (R - h/2), inertia about the place of contact
        (PLANK_ON_A_DRUM, "natural frequency", "sqrt(g*(R - h/2)/((L^2 + h^2)/12 + h^2/4))"),
    ],
)
def test_what_a_lecturer_expects(model: str, question: str, expected: str) -> None:
    found = answer(model, question)
    assert isinstance(found.expression, Expr), found.reason
    assert_same_function(to_python(found.expression), expected.replace("^", "**"), {})


def test_a_sign_that_is_taken_from_the_file_is_a_condition_and_no_disagreement() -> None:
    """|a^2 - b^2| of a plate: half of all parameters have a < b, where the formula with a - b is the other one."""
    found = answer(PLATE_ABOUT_ITS_DIAGONAL, "size of reaction of A on shaft")
    assert any("a > b" in condition for condition in found.conditions)


def test_a_drawbridge_rests_where_half_its_weight_is_that_of_the_counterweight_along_the_rope() -> None:
    """m g (L/2) sin(phi) = w g L cos(phi/2), so sin(phi/2) = w/m; where the rope has no length there is no force."""
    notes = " ".join(str(note) for note in answer(DRAWBRIDGE, "equilibrium of phi").notes)
    assert "acos((m² - 2·w²)/m²)" in notes
    assert "it may rest at 0" not in notes
    assert pytest.approx(math.cos(2 * math.asin(0.4))) == 1 - 2 * 0.4**2


def test_a_rod_over_a_peg_rests_by_a_cube_root() -> None:
    """A rod that leans from a smooth wall over a peg: wall, peg and weight meet in one point, so L/2 cos^3(th) = d. Its
    potential falls away on both sides where it leans upwards, and rises where it hangs down."""
    found = answer(OVER_A_PEG, "equilibrium of th")
    assert found.value == pytest.approx(-math.acos(0.5 ** (1 / 3)))
    assert any("it may rest at acos((2·d/L)^(1/3)), too" in str(note) for note in found.notes)


def test_a_roller_in_a_rolling_pipe() -> None:
    """The pipe is 2 M, the roller 3/2 m (x' + d th')^2 with d = R - r; x is free, so 2 M + 3/2 m moves against it."""
    M, m, d, g = 5.0, 3.0, 0.4, 9.81
    reduced = 1.5 * m * d**2 * (1 - 1.5 * m / (2 * M + 1.5 * m))
    found = answer(PIPE_IN_PIPE, "natural frequencies").value
    assert isinstance(found, tuple)
    assert found == pytest.approx((0.0, math.sqrt(m * g * d / reduced)))


SHAPER = """
parameters: {a: 0.1 m, d: 0.25 m, b: 0.6 m, l: 0.3 m, w: 6 rad/s}
ground: {points: {O: [0, 0], A: [0, d], R: [0, b]}}
bodies:
  crank: {rod: {length: a}}
  lever: {rod: {length: b}, near: {angle: 80 deg}}
  con: {rod: {length: l}, near: {at: [0.3 m, b], angle: 0}}
  ram: {particle: {mass: 10 kg}, near: {at: [0.4 m, b]}}
connections:
  A: {pin: [ground.A, crank.start]}
  O: {pin: [ground.O, lever.start]}
  s: {slot: {pin: crank.end, along: lever.x, on: lever}}
  c: {pin: [lever.end, con.start]}
  r: {pin: [con.end, ram]}
  g: {slot: {pin: ram, along: right, through: ground.R}}
  drive: {driver: {measure: phi, follows: w*t}}
measures: {phi: angle of crank, x: x of ram}
"""


def test_the_stroke_of_a_shaper_is_that_of_its_lever() -> None:
    """In the extremes the crank is square to the lever, which leans by asin(a/d) to either side: the same height, so
    the rod between lever and ram leans alike, and the ram goes from -b a/d to b a/d. Only there is the ram at rest."""
    assert answer(SHAPER, "stroke of x over a turn of phi").value == pytest.approx(2 * 0.6 * 0.1 / 0.25)
