"""Problems of textbook families that mix what is tested one by one elsewhere: wheels that are driven, masses that land,
balls that collide and roll on. Beside each stands the family, and from what its formula follows by hand."""

from __future__ import annotations

import math

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.language.expression import Expr, n_operations
from freebody.language.notation import to_python
from freebody.numeric.engine.course import Status

# Timoshenko & Young, Advanced Dynamics: a plank on two rollers without mass that turn towards each other
ROLLERS = """
parameters: {m: 20 kg, L: 3 m, a: 0.5 m, R: 0.1 m, mu: 0.3, W: 50 rad/s, x0: 0.1 m, g: 9.81 m/s^2}
ground: {points: {A: [-a, -R], B: [a, -R]}}
bodies:
  plank: {rod: {mass: m, length: L}, at: [x0, 0], angle: 0, velocity: [0, 0], angular_velocity: 0}
  left: {disk: {radius: R}}
  right: {disk: {radius: R}}
connections:
  A: {pin: [ground.A, left]}
  B: {pin: [ground.B, right]}
  dl: {driver: {measure: angle of left clockwise, follows: W*t}}
  dr: {driver: {measure: angle of right, follows: W*t}}
  cl: {contact: {between: [left, plank], friction: mu}}
  cr: {contact: {between: [right, plank], friction: mu}}
loads: {weight: {gravity: g}}
measures: {x: x of plank}
"""


@pytest.mark.parametrize(
    ("question", "expected"),
    [
        # N_r = m g (a + x)/(2 a), N_l = m g (a - x)/(2 a): m x'' = mu (N_l - N_r) = -mu m g x/a
        ("acceleration of x at start", "-mu*g*x0/a"),
        ("normal force of cr at start", "m*g*(a + x0)/(2*a)"),
    ],
)
def test_a_plank_swings_on_rollers_without_mass(question: str, expected: str) -> None:
    assert_same_function(expression(ROLLERS, question), expected, {"a": 0.5, "x0": 0.1, "mu": 0.3})


def test_friction_does_not_jam_on_a_roller_without_mass_however_rough_it_is() -> None:
    system = fb.System.from_text(ROLLERS.replace("mu: 0.3", "mu: 0.9"))
    run = system.simulate(until=1.0)
    assert run.status is Status.FINISHED
    assert run.series["x"][0][-1] == pytest.approx(0.1 * math.cos(math.sqrt(0.9 * 9.81 / 0.5)), abs=1e-7)


# Meriam & Kraige, Dynamics, ch. 3: a block on a rough table, a string over a pulley without mass, a hanging load. That
# the string is level follows from the places of the table and the pulley alone
TABLE = """
parameters: {m1: 2 kg, m2: 1.5 kg, mu: 0.2, g: 9.81 m/s^2}
ground: {points: {P: [0.9 m, -0.1 m]}, lines: {table: {along: right}}}
bodies:
  A: {particle: {mass: m1}}
  B: {particle: {mass: m2}, at: [1 m, -0.5 m]}
  pulley: {pulley: {radius: 0.1 m}, at: [0.9 m, -0.1 m]}
connections:
  contact: {contact: {between: [A, table], friction: mu}}
  axle: {pin: [ground.P, pulley]}
  rope: {string: [A, pulley, B]}
loads: {weight: {gravity: g}}
measures: {x: x of A}
start: {x: 0}
"""


def test_a_load_pulls_a_block_over_a_rough_table() -> None:
    """m2 g - S = m2 a and S - mu m1 g = m1 a."""
    found = fb.System.from_text(TABLE).solve("tension of rope").answers[0]
    assert isinstance(found.expression, Expr)
    assert_same_function(to_python(found.expression), "m1*m2*g*(1 + mu)/(m1 + m2)", {"g": 9.81})
    assert found.conditions == ("μ < m₂/m₁",)


def test_the_block_is_told_to_reach_the_pulley_also_where_a_measure_alone_puts_it() -> None:
    """x(0) = 0 and the pulley at 0.9 m: 0.9 = a t^2/2 with a = g (m2 - mu m1)/(m1 + m2)."""
    system = fb.System.from_text(TABLE)
    assert "A reaches pulley" in str(system.phases())
    found = system.solve("time when A reaches pulley")["q1"]
    assert isinstance(found.expression, Expr)
    assert_same_function(to_python(found.expression), "sqrt(1.8*(m1 + m2)/(g*(m2 - mu*m1)))", {"g": 9.81})
    assert "A has not reached pulley" in str(fb.System.from_text(SLIDER).solve("x at t = 5 s"))


SLIDER = TABLE.replace("mu: 0.2, ", "").replace(
    "contact: {contact: {between: [A, table], friction: mu}}", "guide: {slider: {body: A, along: right}}"
)


RAMP = """
parameters: {m: 20 kg, M: 30 kg, alpha: 30 deg, mu: 0.3, R: 5 cm, d: 2 m, g: 9.81 m/s^2}
ground:
  points: {P: [d*cos(alpha) + R*sin(alpha), d*sin(alpha) - R*cos(alpha)]}
  lines: {ramp: {along: alpha}}
bodies: {crate: {particle: {mass: m}}, load: {particle: {mass: M}}, pulley: {pulley: {radius: R}}}
connections:
  feet: {contact: {between: [crate, ramp], friction: mu}}
  axle: {pin: [ground.P, pulley]}
  rope: {string: [crate, pulley, load]}
loads: {weight: {gravity: g}}
measures: {s: travel of crate along alpha}
start: {s: 0}
"""


@pytest.mark.parametrize("place", ["crate", "crate.center"])
def test_a_crate_that_a_measure_puts_on_a_ramp_is_towed_up_to_the_pulley(place: str) -> None:
    """a = g (M - m (sin alpha + mu cos alpha))/(m + M), and d = a t^2/2; the rope runs along the ramp, whose direction
    is no axis of the ground."""
    system = fb.System.from_text(RAMP.replace("of crate", f"of {place}"))
    found = system.solve("time when crate reaches pulley")["q1"].expression
    assert isinstance(found, Expr)
    a = "(g*(M - m*(sin(alpha) + mu*cos(alpha)))/(m + M))"
    assert_same_function(
        to_python(found), f"sqrt(2*d/{a})", {"g": 9.81, "alpha": 0.5, "mu": 0.3, "m": 20, "M": 30, "d": 2}
    )


def test_roots_of_fractions_are_not_brought_over_one_denominator() -> None:
    """sqrt(2 (d/2)/a) - sqrt(2 (d/4)/a): two roots, not a wall of their products."""
    found = fb.System.from_text(RAMP).solve("time between s = d/4 and s = d/2")["q1"].expression
    assert isinstance(found, Expr)
    assert n_operations(found) < 50
    a = "(g*(M - m*(sin(alpha) + mu*cos(alpha)))/(m + M))"
    numbers = {"g": 9.81, "alpha": 0.5, "mu": 0.3, "m": 20.0, "M": 30.0, "d": 2.0}
    assert_same_function(to_python(found), f"(1 - 1/sqrt(2))*sqrt(d/{a})", numbers)


def expression(model: str, question: str) -> str:
    answer = fb.System.from_text(model).solve(question)["q1"]
    assert isinstance(answer.expression, Expr), answer
    return to_python(answer.expression)


# Hibbeler, Statics ch. 11: a toggle press; 2 Q sin(phi) = P cos(phi) by virtual work
TOGGLE = """
parameters: {L: 0.4 m, th: 15 deg, P: 200 N, Q: 100 N}
ground: {points: {O: [0, 0]}, lines: {rail: {along: right}}}
bodies:
  one: {rod: {length: L}, angle: th}
  two: {rod: {length: L}, near: {at: [0.6 m, 0.05 m], angle: -th}}
  ram: {particle: {mass: 1 kg}}
connections:
  O: {pin: [ground.O, one.start]}
  K: {pin: [one.end, two.start]}
  B: {pin: [two.end, ram]}
  guide: {slot: {pin: ram, along: rail}}
loads:
  P: {force: {at: one.end, along: down, magnitude: P}}
  Q: {force: {at: ram, along: left, magnitude: Q}}
measures: {phi: angle of one}
"""


@pytest.mark.parametrize(
    ("question", "expected"),
    [
        ("equilibrium of phi", "atan(P/(2*Q))"),
        ("value of Q for which acceleration of phi = 0 at start", "P/(2*tan(th))"),
        ("Which force Q keeps it in equilibrium?", "P/(2*tan(th))"),
    ],
)
def test_an_equilibrium_is_one_of_the_loop_as_it_is_assembled(question: str, expected: str) -> None:
    """The other one, folded back over the pin, is stable, but the press does not come there."""
    assert_same_function(expression(TOGGLE, question), expected, {})


# Beer & Johnston ch. 13, Hibbeler ch. 14: a hanging mass lands, its rope goes slack, and the block slides on
LANDING = """
parameters: {m1: 4 kg, m2: 3 kg, M: 1 kg, mu: 0.25, h: 0.6 m, R: 5 cm, d: 2 m, H: 1.5 m, g: 9.81 m/s^2}
ground: {points: {edge: [d, -R]}, lines: {table: {along: right}, floor: {along: right, through: [0, -H]}}}
bodies:
  block: {particle: {mass: m1}, at: [0, 0]}
  load: {particle: {mass: m2}, at: [d + R, h - H]}
  pulley: {disk: {PULLEY}}
connections:
  table: {contact: {between: [block, ground.table], friction: mu}}
  floor: {contact: {between: [load, ground.floor]}}
  axle: {pin: [ground.edge, pulley]}
  rope: {string: {from: block, over: [pulley], to: load}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
start: {x: 0, rate(x): 0}
"""
LIGHT, HEAVY = (
    LANDING.replace("PULLEY", "radius: R").replace("M: 1 kg, ", ""),
    LANDING.replace("PULLEY", "mass: M, radius: R"),
)
FALL = "(m2 - mu*m1)/(m1 + m2 + M/2)"  # of the load, by g


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # v^2 = 2 h g (m2 - mu m1)/(m1 + m2), and on by v^2/(2 mu g)
        (LIGHT, "x when block stops", "h*m2*(1 + mu)/(mu*(m1 + m2))"),
        (LIGHT, "velocity of x when load hits the floor", "sqrt(2*h*g*(m2 - mu*m1)/(m1 + m2))"),
        (LIGHT, "energy lost in the impact", "m2*h*g*(m2 - mu*m1)/(m1 + m2)"),
        # in the end all that the load had is lost
        (LIGHT, "energy lost until block stops", "m2*g*h"),
        # a wheel with mass goes on with the block, and the rope between them stays taut: (m1 + M/2) a = mu m1 g
        (HEAVY, "x when block stops", f"h + h*{FALL}*(m1 + M/2)/(mu*m1)"),
        (HEAVY, "energy lost until block stops", "m2*g*h"),
    ],
)
def test_a_block_slides_on_when_the_load_that_pulled_it_has_landed(model: str, question: str, expected: str) -> None:
    near = {"m1": 4.0, "m2": 3.0, "M": 1.0, "mu": 0.25, "h": 0.6, "d": 2.0, "H": 1.5, "R": 0.05}
    assert_same_function(expression(model, question), expected, near)


# Routh, Advanced Rigid Dynamics; Beer & Johnston ch. 17: a ball that rolls hits an equal one, elastic and smooth
BALLS = """
parameters: {m: 170 g, r: 28 mm, v: 2 m/s, mu: 0.2, d: 0.5 m, g: 9.81 m/s^2}
ground: {lines: {cloth: {along: right}}}
bodies:
  a: {sphere: {mass: m, radius: r}, at: [0, r], velocity: [v, 0], angular_velocity: -v/r}
  b: {sphere: {mass: m, radius: r}, at: [2*r + d, r], velocity: [0, 0], angular_velocity: 0}
connections:
  ca: {contact: {between: [a, cloth], friction: mu}}
  cb: {contact: {between: [b, cloth], friction: mu}}
  hit: {contact: {between: [a, b], restitution: 1}}
loads: {weight: {gravity: g}}
measures: {x: x of a, y: x of b}
"""


@pytest.mark.parametrize(
    ("question", "expected"),
    [
        # the first keeps its spin and has no speed, the second has the speed and no spin; the moment of momentum about
        # a point of the cloth stays: 7/5 m r v' = 2/5 m r v and 7/5 m r v' = m r v, at the same instant
        ("velocity of x when ca rolls", "2*v/7"),
        ("velocity of y when cb rolls", "5*v/7"),
        ("velocity of y when ca rolls", "5*v/7"),
        ("velocity of x as t grows", "2*v/7"),
        ("velocity of y as t grows", "5*v/7"),
        ("time when cb rolls", "d/v + 2*v/(7*mu*g)"),
    ],
)
def test_balls_that_begin_to_roll_at_one_instant_are_each_told_of(question: str, expected: str) -> None:
    assert_same_function(expression(BALLS, question), expected, {})


# Goldstein ch. 1; Greenwood, Principles of Dynamics: a tube turns in a vertical plane, r'' = W^2 r - g sin(W t)
TUBE = """
parameters: {m: 0.2 kg, W: 2 rad/s, b: 0.3 m, T: 0.8 s, g: 9.81 m/s^2}
bodies: {tube: {rod: {length: 4 m}}, ball: {particle: {mass: m}, near: {at: [b, 0]}}}
connections:
  axle: {pin: [ground.O, tube.center]}
  slot: {slot: {pin: ball, along: tube.x, on: tube}}
  motor: {driver: {measure: phi, follows: W*t}}
loads: {weight: {gravity: g}}
measures: {r: travel of ball along tube.x from tube.center, phi: angle of tube}
start: {r: b, rate(r): 0}
"""
# Meriam & Kraige ch. 8: an oscillator that is shaken from rest
SHAKEN = """
parameters: {m: 2 kg, k: 50 N/m, c: 3 kg/s, F: 4 N, W: 3 rad/s, T: 0.8 s}
ground: {points: {A: [-1 m, 0]}}
bodies: {block: {particle: {mass: m}, at: [0, 0]}}
connections: {rail: {slider: {body: block, along: right}}}
loads:
  spring: {law: {measure: x, force: -k*x}}
  shaker: {force: {at: block, along: right, magnitude: F*sin(W*t)}}
measures: {x: x of block}
start: {x: 0, rate(x): 0}
"""
DAMPED = SHAKEN.replace("-k*x", "-k*x - c*rate(x)")
# P C - Q D = A/m, Q C + P D = B/m with A = 0, B = F, P = k/m - W^2, Q = -c W/m
COSINE, SINE = "(-F*c*W/((k - m*W**2)**2 + c**2*W**2))", "(F*(k - m*W**2)/((k - m*W**2)**2 + c**2*W**2))"
DECAY, SWING = "(c/(2*m))", "sqrt(k/m - c**2/(4*m**2))"


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        (TUBE, "r at t = T", "(b*cosh(W*T) - g/(2*W**2)*sinh(W*T)) + g/(2*W**2)*sin(W*T)"),
        (TUBE, "velocity of r at t = T", "W*b*sinh(W*T) - g/(2*W)*cosh(W*T) + g/(2*W)*cos(W*T)"),
        (SHAKEN, "x at t = T", "F/(k - m*W**2)*(sin(W*T) - W*sqrt(m/k)*sin(sqrt(k/m)*T))"),
        (
            DAMPED,
            "x at t = T",
            f"{COSINE}*cos(W*T) + {SINE}*sin(W*T) - exp(-{DECAY}*T)*({COSINE}*cos({SWING}*T)"
            f" + ({SINE}*W + {DECAY}*{COSINE})/{SWING}*sin({SWING}*T))",
        ),
    ],
)
def test_what_is_driven_by_waves_is_followed_from_its_start(model: str, question: str, expected: str) -> None:
    near = {"m": 2.0, "k": 50.0, "c": 3.0, "W": 3.0 if model is not TUBE else 2.0}
    assert_same_function(expression(model, question), expected, near)


# Beer & Johnston ch. 17, Kasdin & Paley ch. 9: masses are pulled in along a bar that turns freely; (J + 2 m r^2) w
# stays
SKATER = """
parameters: {J: 2 kg m^2, m: 5 kg, b: 0.8 m, c: 0.3 m, v: 0.1 m/s, W: 4 rad/s}
ground: {points: {O: [0, 0]}}
bodies:
  bar: {body: {inertia: J}}
  one: {particle: {mass: m}, near: {at: [b, 0]}}
  two: {particle: {mass: m}, near: {at: [-b, 0]}}
connections:
  bearing: {pin: [ground.O, bar]}
  s1: {slot: {pin: one, along: bar.x, on: bar}}
  s2: {slot: {pin: two, along: bar.x, on: bar}}
  m1: {driver: {measure: r, follows: b - v*t}}
  m2: {driver: {measure: u, follows: v*t - b}}
measures:
  r: travel of one along bar.x from bar
  u: travel of two along bar.x from bar
  phi: angle of bar
start: {phi: 0, rate(phi): W}
"""
H = "((J + 2*m*b**2)*W)"


@pytest.mark.parametrize(
    ("question", "expected"),
    [
        ("angular velocity of bar when r = c", f"{H}/(J + 2*m*c**2)"),
        ("kinetic energy when r = c", f"{H}**2/(J + 2*m*c**2)/2 + m*v**2"),
        # int w dt with dr = -v dt
        ("phi when r = c", f"{H}/(v*sqrt(2*J*m))*(atan(b*sqrt(2*m/J)) - atan(c*sqrt(2*m/J)))"),
    ],
)
def test_who_pulls_in_the_arms_turns_faster(question: str, expected: str) -> None:
    assert_same_function(expression(SKATER, question), expected, {"b": 0.8, "c": 0.3, "m": 5.0, "J": 2.0})


# Lamb, Higher Mechanics; Routh: four hinged rods in a square are struck at a corner along the diagonal. With X of the
# middle and the half angle th of the corner T = 2 m X'^2 + 2/3 m L^2 th'^2, so that 4 m X' = J and
# 4/3 m L^2 th' = J L sin(th); the opposite corner has the velocity X' - L th' sin(th)
SQUARE = """
parameters: {m: 1 kg, L: 0.5 m, J: 3 N s}
bodies:
  ab: {rod: {mass: m, length: L}, at: {start: [0, 0]}, angle: 45 deg}
  bc: {rod: {mass: m, length: L}, at: {start: [L/sqrt(2), L/sqrt(2)]}, angle: -45 deg}
  cd: {rod: {mass: m, length: L}, at: {start: [sqrt(2)*L, 0]}, angle: -135 deg}
  da: {rod: {mass: m, length: L}, at: {start: [L/sqrt(2), -L/sqrt(2)]}, angle: 135 deg}
connections:
  B: {pin: [ab.end, bc.start]}
  C: {pin: [bc.end, cd.start]}
  D: {pin: [cd.end, da.start]}
  A: {pin: [da.end, ab.start]}
loads: {blow: {impulse: {at: ab.start, along: right, magnitude: J}}}
"""
# Beer & Johnston ch. 16: a wheel on a light hinged arm is let down on a turning one: N = mB g, and the rims come to one
# speed, rA (w0 - 2 mu mB g t/(mA rA)) = 2 mu g t
WHEELS = """
parameters: {mA: 8 kg, mB: 3 kg, rA: 0.2 m, rB: 0.1 m, b: 0.4 m, mu: 0.2, w0: 60 rad/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], P: [-b, rA + rB]}}
bodies:
  A: {disk: {mass: mA, radius: rA}, at: [0, 0], angular_velocity: w0}
  B: {disk: {mass: mB, radius: rB}, at: [0, rA + rB], angular_velocity: 0}
  arm: {rod: {length: b}, near: {at: [-b/2, rA + rB]}}
connections:
  O: {pin: [ground.O, A]}
  P: {pin: [ground.P, arm.start]}
  Q: {pin: [arm.end, B]}
  rim: {contact: {between: [A, B], friction: mu}}
loads: {weight: {gravity: g}}
"""
# Routh; Ginsberg: a cylinder rolls inside a pipe that rolls. x' = -3 m s'/(4 M + 3 m), reduced mass 6 M m/(4 M + 3 m)
PIPE = """
parameters: {M: 4 kg, m: 3 kg, R: 0.5 m, r: 0.1 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  pipe: {ring: {mass: M, radius: R}, at: [0, R]}
  cyl: {disk: {mass: m, radius: r}, at: [0, r]}
connections:
  outer: {rolling: {body: pipe, on: floor}}
  inner: {rolling: {body: cyl, inside: pipe}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from pipe to cyl from down, x: x of pipe}
start: {x: 0, rate(x): 0, rate(phi): 0, phi: 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        (SQUARE, "velocity of bc.end along right after the blow", "-J/(8*m)"),
        (SQUARE, "kinetic energy after the blow", "5*J**2/(16*m)"),
        (WHEELS, "time when slipping ends", "w0*rA/(2*mu*g*(1 + mB/mA))"),
        (WHEELS, "angular velocity of B when slipping ends", "-w0*rA/(rB*(1 + mB/mA))"),
        (WHEELS, "energy lost until rolling begins", "mA*mB/(mA + mB)*rA**2*w0**2/4"),
        (PIPE, "period of small oscillations", "2*pi*sqrt(6*M*(R - r)/(g*(4*M + 3*m)))"),
    ],
)
def test_blows_wheels_and_pipes(model: str, question: str, expected: str) -> None:
    assert_same_function(expression(model, question), expected, {"R": 0.5, "r": 0.1})
