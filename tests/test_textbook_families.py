"""Problems in the style of textbook families: strings that come taut, movable pulleys, turning hoops, dry friction and
a spring, chains of collisions, precession. Beside each stands from what its formula follows by hand."""

from __future__ import annotations

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.errors import ModelError
from freebody.language.expression import Expr
from freebody.language.notation import to_python

PUCK_ON_A_SLACK_STRING = """
parameters: {m: 0.3 kg, L: 1 m, b: 0.6 m, v: 2 m/s}
ground: {points: {O: [0, 0]}}
bodies: {puck: {particle: {mass: m}, at: [b, 0], velocity: [0, v]}}
connections: {string: {stop: {measure: r, max: L}}}
measures: {r: distance from ground.O to puck}
"""
JERK_OVER_A_PULLEY = """
parameters: {m1: 2 kg, m2: 3 kg, h: 0.8 m, g: 9.81 m/s^2}
ground: {points: {P: [0, 3 m], Q: [1 m, 0]}, lines: {floor: {along: right}}}
bodies: {A: {particle: {mass: m1}, at: [0, 3 m]}, B: {particle: {mass: m2}, at: [1 m, 0]}}
connections:
  ga: {slot: {pin: A, along: up, through: ground.P}}
  gb: {slot: {pin: B, along: up, through: ground.Q}}
  floor: {contact: {between: [B, floor]}}
  rope: {stop: {measure: pulled, max: h}}
loads: {weight: {gravity: g}}
measures: {x: drop of A below ground.P, y: height of B above ground.Q, pulled: {expression: x - y}}
start: {x: 0, rate(x): 0, y: 0, rate(y): 0}
"""
LOAD_AT_A_MOVABLE_PULLEY = """
parameters: {m1: 3 kg, m2: 4 kg, r: 5 cm, h: 0.5 m, g: 9.81 m/s^2}
ground: {points: {A: [-3*r, 0], P: [0, 0]}}
bodies:
  top: {pulley: {radius: r}}
  low: {pulley: {mass: 0, radius: r}}
  load: {particle: {mass: m2}}
  other: {particle: {mass: m1}}
connections:
  axle: {pin: [ground.P, top]}
  hook: {pin: [low.center, load]}
  rope: {string: {path: [ground.A, under low, over top, other]}}
loads: {weight: {gravity: g}}
measures: {x: drop of other below ground.P, y: height of load above ground.P}
start: {x: 1 m, rate(x): 0}
"""
BEAD_ON_A_TURNING_RING = """
parameters: {m: 0.1 kg, R: 0.4 m, w: 5 rad/s, p0: 50 deg}
ground: {points: {O: [0, 0]}}
bodies: {ring: {ring: {radius: R}, points: {A: [-R, 0]}}, bead: {particle: {mass: m}}}
connections:
  pivot: {pin: [ground.O, ring.A]}
  motor: {driver: {measure: psi, follows: w*t}}
  wire: {link: [ring.center, bead, R]}
measures: {psi: angle of ring, phi: angle of line from ring.center to bead from ring.x}
start: {phi: p0, rate(phi): 0}
"""
SPRING_AND_DRY_FRICTION = """
parameters: {m: 1 kg, k: 100 N/m, mu: 0.2, A: 0.15 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], W: [-1 m, 0]}, lines: {table: {along: right}}}
bodies: {block: {particle: {mass: m}, at: [A, 0]}}
connections: {c: {contact: {between: [block, table], friction: mu}}}
loads: {weight: {gravity: g}, spring: {spring: {first: ground.W, second: block, stiffness: k, length: 1 m}}}
measures: {x: x of block}
start: {x: A, rate(x): 0}
"""
WHEEL_ON_A_LEVEL_AXLE = """
space: {up: z}
parameters: {m: 1 kg, l: 0.2 m, A: 0.05 kg m^2, C: 0.02 kg m^2, n: 100 rad/s, g: 9.81 m/s^2}
bodies:
  wheel:
    body: {mass: m, inertia: [A, A, C]}
    points: {tip: [0, 0, -l]}
    turned: [psi about z, theta about x, phi about z]
connections: {tip: {spherical: [ground.O, wheel.tip]}}
loads: {weight: {gravity: g}}
start: {psi: 0, theta: 90 deg, phi: 0, rate(psi): 0, rate(theta): 0, rate(phi): n}
"""
CYLINDER_ON_A_PLANK = """
parameters: {M: 5 kg, m: 2 kg, r: 0.1 m, b: 0.05 m, F: 20 N, mu: 0.5, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  plank:
    rectangle: {mass: M, width: 2 m, height: 2*b}
    at: [0, b]
    angle: 0
    lines: {top: {along: right, through: [0, b]}}
  roller: {cylinder: {mass: m, radius: r}, at: [0, 2*b + r]}
connections:
  floor: {slider: {body: plank, along: right}}
  c: {contact: {between: [roller, plank.top], friction: mu}}
loads: {weight: {gravity: g}, pull: {force: {at: plank, along: right, magnitude: F}}}
measures: {x: x of plank, y: x of roller}
start: {rate(x): 0, rate(y): 0}
"""
THREE_BALLS_IN_A_LINE = """
parameters: {m1: 1 kg, m2: 2 kg, m3: 4 kg, r: 5 cm, d: 1 m, v: 3 m/s, e: 0.8}
bodies:
  A: {disk: {mass: m1, radius: r}, at: [0, 0], velocity: [v, 0], angular_velocity: 0}
  B: {disk: {mass: m2, radius: r}, at: [d, 0], velocity: [0, 0], angular_velocity: 0}
  C: {disk: {mass: m3, radius: r}, at: [2*d, 0], velocity: [0, 0], angular_velocity: 0}
connections:
  ab: {contact: {between: [A, B], restitution: e}}
  bc: {contact: {between: [B, C], restitution: e}}
measures: {x: x of A, z: x of C}
"""
MAN_ON_A_TURNTABLE = """
parameters: {m: 70 kg, M: 200 kg, R: 2 m, u: 0.5 rad/s}
ground: {points: {O: [0, 0]}}
bodies: {table: {disk: {mass: M, radius: R}}, man: {particle: {mass: m}}}
connections:
  axle: {pin: [ground.O, table]}
  rim: {link: [table.center, man, R]}
  walk: {driver: {measure: phi, follows: u*t}}
measures: {psi: angle of table, phi: angle of line from table.center to man from table.x}
start: {psi: 0, rate(psi): -u*m*R^2/(m*R^2 + M*R^2/2)}
"""
BALL_IN_A_BOWL = """
parameters: {m: 1 kg, r: 0.05 m, R: 0.5 m, p0: 40 deg, mu: 0.4, g: 9.81 m/s^2}
bodies:
  bowl: {ring: {radius: R}, at: [0, 0], angle: 0, fixed: true}
  ball: {sphere: {mass: m, radius: r}, at: [(R - r)*sin(p0), -(R - r)*cos(p0)], velocity: [0, 0], angular_velocity: 0}
connections: {c: {contact: {between: [ball, inside bowl], friction: mu}}}
loads: {weight: {gravity: g}}
"""
PARTICLE_IN_A_MOVABLE_BOWL = """
parameters: {m: 1 kg, M: 4 kg, R: 0.5 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {bowl: {particle: {mass: M}}, p: {particle: {mass: m}}}
connections: {floor: {slider: {body: bowl, along: floor}}, surface: {link: [bowl, p, R]}}
loads: {weight: {gravity: g}}
measures: {x: x of bowl, th: angle of line from bowl to p from down}
start: {x: 0, rate(x): 0, th: 90 deg, rate(th): 0}
"""
ROD_IN_A_HOOP = """
parameters: {m: 1 kg, a: 0.3 m, R: 0.5 m, g: 9.81 m/s^2, p0: 10 deg}
ground: {points: {O: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: 2*a}, near: {at: [0, -0.4 m], angle: p0}}}
connections: {A: {link: [ground.O, rod.start, R]}, B: {link: [ground.O, rod.end, R]}}
loads: {weight: {gravity: g}}
measures: {phi: angle of rod}
start: {phi: p0, rate(phi): 0}
"""


def expression(model: str, question: str) -> str:
    answer = fb.System.from_text(model).solve(question)["q1"]
    assert isinstance(answer.expression, Expr), answer
    return to_python(answer.expression)


@pytest.mark.parametrize(
    ("model", "question", "expected"),
    [
        # straight on until it is at L: there the part of v along the string is lost, sqrt(1 - b^2/L^2) of it
        (PUCK_ON_A_SLACK_STRING, "speed of puck after the impact", "v*b/L"),
        (PUCK_ON_A_SLACK_STRING, "size of impulse of string", "m*v*sqrt(1 - b**2/L**2)"),
        (PUCK_ON_A_SLACK_STRING, "time when the string becomes taut", "sqrt(L**2 - b**2)/v"),
        # m1 sqrt(2 g h) = (m1 + m2) v, and on with g (m2 - m1)/(m1 + m2) against it
        (JERK_OVER_A_PULLEY, "velocity of y after the impact", "m1*sqrt(2*g*h)/(m1 + m2)"),
        (JERK_OVER_A_PULLEY, "greatest y", "h*m1**2/(m2**2 - m1**2)"),
        # the load rises half as fast: (m1 + m2/4) x'' = (m1 - m2/2) g
        (LOAD_AT_A_MOVABLE_PULLEY, "acceleration of x", "(4*m1 - 2*m2)*g/(4*m1 + m2)"),
        (LOAD_AT_A_MOVABLE_PULLEY, "tension of rope at other", "3*m1*m2*g/(4*m1 + m2)"),
        # in the turning frame m w^2 r with the bead at 2 R cos(phi/2) from the pivot: phi'' = -w^2 sin(phi)
        (BEAD_ON_A_TURNING_RING, "velocity of phi when phi = 0", "-2*w*sin(p0/2)"),
        (BEAD_ON_A_TURNING_RING, "period of small oscillations of phi", "2*pi/w"),
        # it swings about mu m g/k, with the amplitude A - mu m g/k
        (SPRING_AND_DRY_FRICTION, "greatest speed of block", "(A - mu*m*g/k)*sqrt(k/m)"),
        (SPRING_AND_DRY_FRICTION, "energy lost until rate(x) = 0", "2*mu*m*g*(A - mu*m*g/k)"),
        # the middle stays level as it goes round, so the tip bears the weight; m g l = C n psi'
        (WHEEL_ON_A_LEVEL_AXLE, "vertical reaction of tip in steady motion", "m*g"),
        (WHEEL_ON_A_LEVEL_AXLE, "vertical reaction of tip at start", "m*g*A/(A + m*l**2)"),
        # m r^2/2 w' = r f and m y'' = f with y'' = x'' - r w': y'' = x''/3
        (CYLINDER_ON_A_PLANK, "acceleration of y", "F/(3*M + m)"),
        (CYLINDER_ON_A_PLANK, "least mu so that roller rolls without slipping", "F/(g*(3*M + m))"),
        # twice m (1 + e)/(m + m'): the best in the middle is the geometric mean
        (THREE_BALLS_IN_A_LINE, "velocity of z after the impact of bc", "m1*m2*(1+e)**2*v/((m1+m2)*(m2+m3))"),
        (
            THREE_BALLS_IN_A_LINE,
            "value of m2 for which velocity of z after the impact of bc is largest",
            "sqrt(m1*m3)",
        ),
        # friction needs 2/7 m g sin(phi), most of what presses at the start: what is let go rolls from there or never
        (BALL_IN_A_BOWL, "least mu so that it rolls", "2*tan(p0)/7"),
        # the mass centre stays: M x = m (2 R - x) where the particle is on the other edge
        (PARTICLE_IN_A_MOVABLE_BOWL, "greatest x", "2*m*R/(m + M)"),
        (PARTICLE_IN_A_MOVABLE_BOWL, "greatest speed of bowl", "m*sqrt(2*g*R/(M*(m + M)))"),
        # a triangle that turns about O: d = sqrt(R^2 - a^2) down to the middle, m (d^2 + a^2/3) about O
        (ROD_IN_A_HOOP, "period of small oscillations", "2*pi*sqrt((R**2 - 2*a**2/3)/(g*sqrt(R**2 - a**2)))"),
        # no moment of momentum: M/2 psi' + m (psi' + phi') = 0
        (MAN_ON_A_TURNTABLE, "psi when phi = 2*pi", "-2*pi*m/(m + M/2)"),
    ],
)
def test_a_problem_of_a_textbook_family_has_the_formula_of_its_derivation(
    model: str, question: str, expected: str
) -> None:
    near = {
        "R": 1.5,
        "m1": 2.0,
        "m2": 3.0,
        "m": 0.5,
        "L": 1.0,
        "b": 0.5,
        "k": 100.0,
        "A": 0.5,
        "a": 0.3,
        "mu": 0.3,
        "v": 2.0,
        "h": 0.8,
    }
    assert_same_function(expression(model, question), expected, near)


def test_a_horizontal_force_in_space_is_asked_for_by_its_components() -> None:
    with pytest.raises(ModelError, match="two components"):
        fb.System.from_text(WHEEL_ON_A_LEVEL_AXLE).solve("horizontal reaction of tip")


def test_what_does_not_move_to_first_order_has_no_period_of_small_oscillations() -> None:
    pendulum = """
parameters: {m: 1 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down, y: height of bob above ground.O, x: x of bob}
start: {theta: 0}
"""
    asked = ("period of small oscillations of x", "period of small oscillations of y")
    along, across = (fb.System.from_text(pendulum).solve(q)["q1"] for q in asked)
    assert isinstance(along.expression, Expr)
    assert_same_function(to_python(along.expression), "2*pi*sqrt(L/g)", {})
    assert across.expression is None
    assert across.value is None
    assert "does not move" in across.reason


def test_a_load_pinned_to_the_rim_of_a_pulley_does_not_hang_with_it() -> None:
    """It swings about the axle: the pulley alone tells nothing of where it is."""
    aside = LOAD_AT_A_MOVABLE_PULLEY.replace("low.center", "low.P").replace(
        "low: {pulley: {mass: 0, radius: r}}", "low: {pulley: {mass: 1 kg, radius: r}, points: {P: [r, 0]}}"
    )
    with pytest.raises(fb.FreebodyError, match="circles overlap"):
        fb.System.from_text(aside).solve("acceleration of x")
