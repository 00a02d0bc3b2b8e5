"""Questions turned round: problems of textbook families, each with the formula that follows by hand."""

from __future__ import annotations

import pytest

from posed import is_formula

SPRING_GUN_ON_A_SLOPE = """
parameters: {m: 2 kg, k: 3 kN/m, d: 0.1 m, L: 0.3 m, alpha: 30 deg, mu: 0.2, s: 0.3 m, g: 9.81 m/s^2}
ground: {points: {W: ["-L*cos(alpha)", "-L*sin(alpha)"]}, lines: {slope: {along: alpha}}}
bodies: {block: {particle: {mass: m}, at: ["-d*cos(alpha)", "-d*sin(alpha)"]}}
connections: {bed: {slider: {body: block, along: slope, friction: mu}}}
loads:
  weight: {gravity: g}
  buffer: {spring: {between: [ground.W, block], stiffness: k, length: L, only: compressed}}
measures: {x: travel of block along slope}
"""
BLOCK_ON_A_BLOCK = """
parameters: {mA: 4 kg, mB: 8 kg, mu: 0.3, P: 20 N, T: 2 s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  B: {rectangle: {mass: mB, width: 2 m, height: 0.2 m}, at: [0, 0.1 m]}
  A: {rectangle: {mass: mA, width: 0.3 m, height: 0.2 m}, at: [0, 0.3 m]}
connections:
  rail: {slider: {body: B, along: right}}
  top: {contact: {between: [A, B], friction: mu}}
loads:
  weight: {gravity: g}
  pull: {force: {at: B, along: right, magnitude: P}}
measures: {x: x of B}
"""
SPOOL = """
parameters: {m: 5 kg, k: 0.12 m, R: 0.2 m, r: 0.1 m, mu: 0.25, P: 10 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {spool: {disk: {mass: m, radius: R, inertia: m*k^2}, at: [0, R]}}
connections: {floor: {contact: {between: [spool, ground.floor], friction: mu}}}
loads:
  weight: {gravity: g}
  pull: {force: {at: spool, along: right, magnitude: P}}
  turn: {torque: {on: spool, magnitude: P*r}}
measures: {x: x of spool}
"""
THROW_UP_A_SLOPE = """
parameters: {m: 1 kg, v0: 20 m/s, theta: 60 deg, alpha: 20 deg, s: 15 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}, lines: {slope: {through: [0, 0], along: alpha}}}
bodies: {ball: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(theta), v0*sin(theta)]}}
loads: {weight: {gravity: g}}
measures:
  u: travel of ball along slope
  w: travel of ball along alpha + 90 deg
"""
TWO_WEIGHTS_ON_A_ROPE = """
parameters: {m1: 2 kg, m2: 3 kg, T: 1 s, h: 0.7 m, g: 9.81 m/s^2}
ground: {points: {C: [0, 0]}}
bodies:
  pulley: {disk: {mass: 0, radius: 0.1 m}}
  one: {particle: {mass: m1}}
  two: {particle: {mass: m2}}
connections:
  axle: {pin: [ground.C, pulley]}
  rope: {string: {from: one, over: [pulley], to: two}}
loads: {weight: {gravity: g}}
measures: {y: drop of two below ground.C}
start: {y: 0.5 m, rate(y): 0}
"""
CRATE_HINGED_ON_A_TRUCK = """
parameters: {m: 50 kg, b: 0.6 m, h: 1 m, a: 2 m/s^2, g: 9.81 m/s^2}
bodies:
  truck:
    rectangle: {mass: 100 kg, width: 3 m, height: 0.4 m}
    at: [0, 0]
    points: {K: [-b/2, 0.2 m]}
    lines: {bed: {through: [0, 0.2 m], along: right}}
  crate: {rectangle: {mass: m, width: b, height: h}, at: [0, 0.2 m + h/2]}
connections:
  track: {slider: {body: truck, along: right}}
  motor: {driver: {measure: x of truck, follows: a*t^2/2}}
  hinge: {pin: [truck.K, crate.bottom_left]}
  bed: {contact: {between: [crate.bottom_right, truck.bed]}}
loads: {weight: {gravity: g}}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Beer & Johnston, Dynamics, ch. 13: energy, k d^2/2 = m g (sin + mu cos)(x + d)
        (SPRING_GUN_ON_A_SLOPE, "greatest x", "k*d^2/(2*m*g*(sin(alpha)+mu*cos(alpha))) - d"),
        (SPRING_GUN_ON_A_SLOPE, "speed of block when x = 0", "sqrt(k*d^2/m - 2*g*d*(sin(alpha)+mu*cos(alpha)))"),
        (
            SPRING_GUN_ON_A_SLOPE,
            "value of k for which x = s when rate(x) = 0",
            "2*m*g*(sin(alpha)+mu*cos(alpha))*(s+d)/d^2",
        ),
        # Hibbeler, Dynamics, ch. 13: both with a = P/(mA + mB) until friction needs mu mA g
        (BLOCK_ON_A_BLOCK, "acceleration of A along right", "P/(mA+mB)"),
        (BLOCK_ON_A_BLOCK, "least P so that A slips", "mu*(mA+mB)*g"),
        (BLOCK_ON_A_BLOCK, "friction force of top", "mA*P/(mA+mB)"),
        (BLOCK_ON_A_BLOCK, "value of P for which friction force of top = mu*mA*g/2", "mu*g*(mA+mB)/2"),
        (BLOCK_ON_A_BLOCK, "range of mu for which A does not slip", "P/((mA+mB)*g)"),
        # Meriam & Kraige, Dynamics, ch. 6: moments about the contact, m (k^2 + R^2) a/R = P (R - r)
        (SPOOL, "acceleration of x", "P*R*(R-r)/(m*(k^2+R^2))"),
        (SPOOL, "friction force of floor", "-P*(k^2 + R*r)/(k^2 + R^2)"),
        (SPOOL, "least P so that spool slips", "mu*m*g*(k^2+R^2)/(k^2+R*r)"),
        (SPOOL, "least mu so that spool rolls without slipping", "P*(k^2+R*r)/((k^2+R^2)*m*g)"),
        (SPOOL, "value of r for which acceleration of x = 0", "R"),
        # Beer & Johnston, Dynamics, ch. 11: w'' = -g cos(alpha), u'' = -g sin(alpha)
        (THROW_UP_A_SLOPE, "u when w = 0", "2*v0^2*sin(theta-alpha)*cos(theta)/(g*cos(alpha)^2)"),
        (THROW_UP_A_SLOPE, "time when w = 0", "2*v0*sin(theta-alpha)/(g*cos(alpha))"),
        (THROW_UP_A_SLOPE, "greatest w", "v0^2*sin(theta-alpha)^2/(2*g*cos(alpha))"),
        (THROW_UP_A_SLOPE, "value of theta for which u when w = 0 is largest", "pi/4+alpha/2"),
        (THROW_UP_A_SLOPE, "value of theta for which velocity of u = 0 when w = 0", "alpha + atan(1/(2*tan(alpha)))"),
        # Gross, Hauger et al., Technische Mechanik 3, ch. 1: a = (m2 - m1) g/(m1 + m2)
        (TWO_WEIGHTS_ON_A_ROPE, "change of y at t = T", "(m2-m1)/(m1+m2)*g*T^2/2"),
        (
            TWO_WEIGHTS_ON_A_ROPE,
            "value of m2 for which time when y has changed by h is T",
            "m1*(g*T^2+2*h)/(g*T^2-2*h)",
        ),
        (TWO_WEIGHTS_ON_A_ROPE, "vertical reaction of axle", "4*m1*m2*g/(m1+m2)"),
        (TWO_WEIGHTS_ON_A_ROPE, "value of m2 for which tension of rope at one = 3*m1*g/2", "3*m1"),
        (TWO_WEIGHTS_ON_A_ROPE, "tension of rope at one as m2 grows", "2*m1*g"),
        # Meriam & Kraige, Dynamics, ch. 6: moments about the hinge, N b + m a h/2 = m g b/2
        (CRATE_HINGED_ON_A_TRUCK, "largest a so that the crate does not tip", "b*g/h"),
        (CRATE_HINGED_ON_A_TRUCK, "normal force of bed", "m*(g/2 - a*h/(2*b))"),
        (CRATE_HINGED_ON_A_TRUCK, "range of a for which crate tips", "b*g/h"),
        (CRATE_HINGED_ON_A_TRUCK, "value of a for which normal force of bed = 0", "b*g/h"),
    ],
)
def test_a_question_turned_round_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)
