"""Impulses and impacts. Ten problems in the style of textbooks, in words and numbers of our own; from what the
formula follows by hand stands beside it."""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula

# Beer & Johnston, Dynamics, ch. 13: a block falls on a scale pan
SCALE_PAN = """
parameters: {M: 10 kg, m: 30 kg, h: 2 m, k: 20 kN/m, g: 9.81 m/s^2}
bodies: {pan: {particle: {mass: M}, at: [0, 0]}, block: {particle: {mass: m}, at: [0, h]}}
connections:
  g1: {slider: {body: pan, along: up}}
  g2: {slider: {body: block, along: up}}
  c: {stop: {measure: gap, min: 0, restitution: 0}}
loads: {weight: {gravity: g}, s: {law: {measure: y, force: M*g - k*y}}}
measures: {y: y of pan, z: y of block, gap: {expression: z - y}}
start: {y: 0, rate(y): 0, z: h, rate(z): 0}
"""
# Meriam & Kraige, Dynamics, ch. 3: one ball on a string hits another one
TWO_PENDULUMS = """
parameters: {mA: 1 kg, mB: 2 kg, L: 0.8 m, e: 0.8, p0: 60 deg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {A: {particle: {mass: mA}}, B: {particle: {mass: mB}}}
connections:
  l: {link: [ground.O, A, L]}
  r: {link: [ground.O, B, L]}
  hit: {stop: {measure: gap, min: 0, restitution: e}}
loads: {weight: {gravity: g}}
measures:
  phi: angle of line from ground.O to A from down
  psi: angle of line from ground.O to B from down
  gap: {expression: psi - phi}
start: {phi: -p0, rate(phi): 0, psi: 0, rate(psi): 0}
"""
# Kleppner & Kolenkow, An Introduction to Mechanics, ch. 4: a ball that bounces
BOUNCING_BALL = """
parameters: {m: 0.2 kg, h: 1.5 m, e: 0.7, n: 4, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h], velocity: [0, 0]}}
connections: {floor: {contact: {between: [ball, ground.floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: y of ball}
"""
# Meriam & Kraige, Dynamics, ch. 6: a level rod falls with its end on a table
ROD_ON_AN_EDGE = """
parameters: {m: 2 kg, L: 1.2 m, h: 0.8 m, e: 0.4, g: 9.81 m/s^2}
ground: {lines: {table: {along: right, through: [0, 0]}}}
bodies: {rod: {rod: {mass: m, length: L}, at: [L/2, h], angle: 0, velocity: [0, 0], angular_velocity: 0}}
connections: {edge: {contact: {between: [rod.start, ground.table], restitution: e}}}
loads: {weight: {gravity: g}}
"""
# Irodov, Problems in General Physics, part 1: a disk hits two equal ones at one instant
DISK_HITS_TWO = """
parameters: {m: 1 kg, r: 4 cm, v: 2 m/s, e: 1}
bodies:
  A: {disk: {mass: m, radius: r}, at: [-4*r, 0], velocity: [v, 0], angular_velocity: 0}
  B: {disk: {mass: m, radius: r}, at: [0, r], velocity: [0, 0], angular_velocity: 0}
  C: {disk: {mass: m, radius: r}, at: [0, -r], velocity: [0, 0], angular_velocity: 0}
connections:
  ab: {contact: {between: [A, B], restitution: e}}
  ac: {contact: {between: [A, C], restitution: e}}
"""
# Kleppner & Kolenkow, ch. 6: a puck sticks to the end of a rod on ice
PUCK_STICKS_TO_A_ROD = """
parameters: {m: 1 kg, M: 3 kg, L: 1.5 m, v: 4 m/s}
bodies:
  rod: {rod: {mass: M, length: L}, at: [0, 0], angle: 90 deg, velocity: [0, 0], angular_velocity: 0}
  puck: {particle: {mass: m}, velocity: [v, 0]}
connections: {stick: {pin: [puck, rod.end], closes: at start}}
"""
# Routh, Dynamics of a System of Rigid Bodies, ch. 4: two hinged rods, struck at an end
TWO_HINGED_RODS = """
parameters: {m: 1 kg, L: 0.6 m, J: 2 N*s}
bodies:
  one: {rod: {mass: m, length: L}, at: [0, 0], angle: 0}
  two: {rod: {mass: m, length: L}, at: [L, 0], angle: 0}
connections: {B: {pin: [one.end, two.start]}}
loads: {hit: {impulse: {at: one.start, along: up, magnitude: J}}}
"""
# Halliday & Resnick, ch. 11: a child jumps on a merry-go-round
MERRY_GO_ROUND = """
parameters: {M: 100 kg, R: 1.6 m, m: 25 kg, v: 3 m/s, w0: 0.5 rad/s}
bodies:
  table: {disk: {mass: M, radius: R}, points: {P: [0, -R]}, angular_velocity: w0}
  child: {particle: {mass: m}, velocity: [v, 0]}
connections: {axle: {pin: [ground.O, table.center]}, jump: {pin: [child, table.P], closes: at start}}
"""
# Halliday & Resnick, ch. 9: wagons of m, 2 m and 3 m couple one after the other
THREE_WAGONS = """
parameters: {m: 10 t, v: 2 m/s, d: 5 m}
bodies: {A: {particle: {mass: m}}, B: {particle: {mass: 2*m}}, C: {particle: {mass: 3*m}}}
connections:
  a: {slider: {body: A, along: right}}
  b: {slider: {body: B, along: right}}
  c: {slider: {body: C, along: right}}
  ab: {stop: {measure: u, min: 0, restitution: 0}}
  bc: {stop: {measure: v2, min: 0, restitution: 0}}
measures: {x: x of A, y: x of B, z: x of C, u: {expression: y - x}, v2: {expression: z - y}}
start: {x: 0, rate(x): v, y: d, rate(y): 0, z: 2*d, rate(z): 0}
"""
# Beer & Johnston, Dynamics, ch. 13: a ball falls on a wedge that can slide
BALL_ON_A_WEDGE = """
parameters: {m: 1 kg, M: 5 kg, alpha: 30 deg, v: 4 m/s, e: 0.8}
bodies:
  W: {particle: {mass: M}, lines: {slope: {along: alpha}}, at: [0, 0]}
  ball: {particle: {mass: m}, at: [0, 1 m], velocity: [0, -v]}
connections:
  floor: {slider: {body: W, along: right}}
  hit: {contact: {between: [ball, W.slope], restitution: e}}
measures: {x: x of W}
start: {x: 0, rate(x): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # m sqrt(2 g h) = (M + m) v
        (SCALE_PAN, "speed of pan after the impact", "m*sqrt(2*g*h)/(m + M)"),
        # from the old rest (M + m) v^2/2 + m g s = k s^2/2
        pytest.param(SCALE_PAN, "least y", "-(m*g + sqrt(m**2*g**2 + 2*k*m**2*g*h/(m + M)))/k", marks=pytest.mark.slow),
        # the reduced mass with the speed sqrt(2 g h)
        (SCALE_PAN, "energy lost in the impact", "m*M*g*h/(m + M)"),
        # (1 + e) mA/(mA + mB) of what the first one has
        pytest.param(
            TWO_PENDULUMS,
            "speed of B after the impact",
            "mA*(1 + e)*sqrt(2*g*L*(1 - cos(p0)))/(mA + mB)",
            marks=pytest.mark.slow,
        ),
        # m v^2/L more than the weight
        pytest.param(
            TWO_PENDULUMS,
            "tension of r after the impact",
            "mB*g + mB/L*(mA*(1 + e)/(mA + mB))**2*2*g*L*(1 - cos(p0))",
            marks=pytest.mark.slow,
        ),
        # (1 + e) times the reduced mass times the speed
        pytest.param(
            TWO_PENDULUMS,
            "size of impulse of hit",
            "mA*mB*(1 + e)*sqrt(2*g*L*(1 - cos(p0)))/(mA + mB)",
            marks=pytest.mark.slow,
        ),
        # e of the speed is left each time
        (BOUNCING_BALL, "speed of ball after the third impact", "e**3*sqrt(2*g*h)"),
        # e^2 of the height is left each time
        (BOUNCING_BALL, "greatest y after the second impact", "e**4*h"),
        # at the end 1/m + (L/2)^2/(m L^2/12) = 4/m: the impulse is m (1 + e) v/4
        (ROD_ON_AN_EDGE, "angular velocity of rod after the impact", "-3*(1 + e)*sqrt(2*g*h)/(2*L)"),
        # (1 - e^2) m/4 v^2/2
        (ROD_ON_AN_EDGE, "energy lost in the impact", "m*g*h*(1 - e**2)/4"),
        # along both lines of centres, at 30 deg, u - v' cos = e v cos and v - v' = 2 u cos
        (DISK_HITS_TWO, "velocity of A after the impact along right", "v*(2 - 3*e)/5"),
        # u = sqrt(3) (1 + e) v/5
        (DISK_HITS_TWO, "speed of B after the impact", "sqrt(3)*(1 + e)*v/5"),
        # m v^2/2 less what the three have then
        (DISK_HITS_TWO, "energy lost in the impact", "3*m*v**2*(1 - e**2)/10"),
        # m (v - u) = M V with V = w L/6 and u = V + w L/2
        (PUCK_STICKS_TO_A_ROD, "angular velocity of rod at start", "-6*m*v/((M + 4*m)*L)"),
        # the impulse m (v - u) times v/2
        (PUCK_STICKS_TO_A_ROD, "energy lost in the blow", "M*m*v**2/(2*(M + 4*m))"),
        # w1 L = -9/2, w2 L = 3/2 and -1 at the hinge, all times J/m
        (TWO_HINGED_RODS, "velocity of one.start at start along up", "7*J/(2*m)"),
        # -1 + 3/2 of J/m
        (TWO_HINGED_RODS, "velocity of two.end at start along up", "J/(2*m)"),
        # m times -1 + 3/4 of J/m
        (TWO_HINGED_RODS, "vertical impulse of B on two", "-J/4"),
        # J/2 times the velocity of the end that is struck
        (TWO_HINGED_RODS, "kinetic energy at start", "7*J**2/(4*m)"),
        # M R^2/2 w0 + m R v = (M/2 + m) R^2 w
        (MERRY_GO_ROUND, "angular velocity of table at start", "(M*R/2*w0 + m*v)/((M/2 + m)*R)"),
        # the reduced mass of m and M/2 with v - w0 R
        (MERRY_GO_ROUND, "energy lost in the blow", "M*m*(v - w0*R)**2/(2*(M + 2*m))"),
        # nothing slips where the rim is as fast
        (MERRY_GO_ROUND, "value of v for which energy lost in the blow = 0", "w0*R"),
        # m v = 6 m v'
        (THREE_WAGONS, "velocity of z after the impact of bc", "v/6"),
        # d/v, then d with a third of the speed
        (THREE_WAGONS, "time of the impact of bc", "4*d/v"),
        # 1 - m/(m + 2 m)
        (THREE_WAGONS, "ratio of energy lost in the impact of ab to kinetic energy at start", "2/3"),
        # P (1/m + sin^2/M) = (1 + e) v cos along the normal
        (BALL_ON_A_WEDGE, "speed of W after the impact", "(1 + e)*m*v*sin(alpha)*cos(alpha)/(M + m*sin(alpha)**2)"),
        # P cos
        (
            BALL_ON_A_WEDGE,
            "vertical impulse of floor in the impact",
            "(1 + e)*m*M*v*cos(alpha)**2/(M + m*sin(alpha)**2)",
        ),
    ],
)
def test_an_impact_has_the_formula_of_its_derivation(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


@pytest.mark.slow
def test_an_impact_on_two_at_once_is_derived() -> None:
    is_derived(DISK_HITS_TWO, "speed of B after the impact")
