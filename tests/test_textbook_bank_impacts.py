"""Impulses and impacts: problems of textbook families, each with the formula that follows by hand."""

from __future__ import annotations

import pytest

from posed import is_formula

BALL_STRIKES_A_ROD = """
parameters: {m: 0.5 kg, M: 4 kg, L: 1.2 m, b: 0.9 m, e: 0.6, v: 5 m/s, g: 9.81 m/s^2}
ground: {points: {A: [0, 0]}}
bodies:
  rod: {rod: {mass: M, length: L}, angle: -90 deg}
  ball: {particle: {mass: m}, at: [0, -b], velocity: [v, 0]}
connections:
  A: {pin: [ground.A, rod.start]}
  hit: {contact: {between: [ball, rod], restitution: e}}
loads: {weight: {gravity: g}}
measures: {phi: angle of rod from down}
"""
OBLIQUE_CENTRAL_IMPACT = """
parameters: {mA: 2 kg, mB: 3 kg, r: 5 cm, beta: 30 deg, e: 0.5, v: 4 m/s}
bodies:
  A: {disk: {mass: mA, radius: r}, at: [0, 0], velocity: [v, 0]}
  B: {disk: {mass: mB, radius: r}, at: [2*r*cos(beta), 2*r*sin(beta)]}
connections: {hit: {contact: {between: [A, B], restitution: e}}}
"""
BALL_ON_A_SLOPE = """
parameters: {m: 0.2 kg, h: 1.5 m, alpha: 20 deg, e: 0.7, g: 9.81 m/s^2}
ground: {lines: {slope: {through: [0, 0], along: -alpha}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {hit: {contact: {between: [ball, slope], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {s: travel of ball along slope, y: height of ball, n: travel of ball along 90 deg - alpha}
"""
PLATE_SUDDENLY_PINNED = """
parameters: {m: 3 kg, a: 0.4 m, w0: 6 rad/s}
ground: {points: {P: [a/2, a/2]}}
bodies: {plate: {rectangle: {mass: m, width: a, height: a}, at: [0, 0], angle: 0, angular_velocity: w0}}
connections: {latch: {pin: [ground.P, plate.top_right], closes: at start}}
"""
SLACK_STRING = """
parameters: {mA: 1 kg, mB: 2 kg, a: 0.6 m, L: 1 m, v: 3 m/s}
bodies:
  B: {particle: {mass: mB}, at: [0, 0]}
  A: {particle: {mass: mA}, at: [a, 0], velocity: [0, v]}
measures: {apart: distance from A to B}
connections: {string: {stop: {measure: apart, max: L}}}
"""
BOUNCING_BALL = """
parameters: {m: 0.2 kg, h: 1 m, e: 0.8, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {ball: {particle: {mass: m}, at: [0, h]}}
connections: {contact: {contact: {between: [ball, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {y: {height of ball}}
start: {y: h}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Beer & Johnston, Dynamics, ch. 17: angular momentum about A, m v b = (M L^2/3) w + m b v', and w b - v' = e v
        (BALL_STRIKES_A_ROD, "angular velocity of rod after the impact", "m*v*b*(1+e)/(M*L^2/3+m*b^2)"),
        (BALL_STRIKES_A_ROD, "velocity of ball along right after the impact", "v*(m*b^2-e*M*L^2/3)/(M*L^2/3+m*b^2)"),
        (BALL_STRIKES_A_ROD, "value of b for which horizontal impulse of A = 0", "2*L/3"),
        (
            BALL_STRIKES_A_ROD,
            "value of e for which velocity of ball along right after the impact = 0",
            "3*m*b^2/(M*L^2)",
        ),
        (BALL_STRIKES_A_ROD, "energy lost in the impact", "(1-e^2)/2*v^2*m*M*L^2/3/(M*L^2/3+m*b^2)"),
        # Beer & Johnston, Dynamics, ch. 13: along the line of centres alone
        (OBLIQUE_CENTRAL_IMPACT, "speed of B after the impact", "(1+e)*mA*v*cos(beta)/(mA+mB)"),
        (OBLIQUE_CENTRAL_IMPACT, "energy lost in the impact", "(1-e^2)*mA*mB*v^2*cos(beta)^2/(2*(mA+mB))"),
        (OBLIQUE_CENTRAL_IMPACT, "velocity of A along beta after the impact", "(mA-e*mB)*v*cos(beta)/(mA+mB)"),
        (OBLIQUE_CENTRAL_IMPACT, "value of e for which velocity of A along beta after the impact = 0", "mA/mB"),
        (OBLIQUE_CENTRAL_IMPACT, "size of impulse of hit", "(1+e)*mA*mB*v*cos(beta)/(mA+mB)"),
        # Meriam & Kraige, Dynamics, ch. 3: the speed along the slope is kept; it flies for 2 e v/g
        (BALL_ON_A_SLOPE, "speed of ball after the impact", "sqrt(2*g*h*(sin(alpha)^2+e^2*cos(alpha)^2))"),
        (BALL_ON_A_SLOPE, "energy lost in the impact", "m*g*h*cos(alpha)^2*(1-e^2)"),
        (BALL_ON_A_SLOPE, "value of e for which velocity of y after the impact = 0", "tan(alpha)^2"),
        (BALL_ON_A_SLOPE, "time between the first impact and the second impact", "2*e*sqrt(2*h/g)"),
        (BALL_ON_A_SLOPE, "s at the second impact - s at the first impact", "4*e*(1+e)*h*sin(alpha)"),
        # Gross, Hauger et al., Technische Mechanik 3, ch. 3: about the corner, m a^2 w0/6 = 2 m a^2 w/3
        (PLATE_SUDDENLY_PINNED, "angular velocity of plate after the blow", "w0/4"),
        (PLATE_SUDDENLY_PINNED, "size of impulse of latch", "m*w0*a*sqrt(2)/8"),
        (PLATE_SUDDENLY_PINNED, "energy lost in the blow", "m*a^2*w0^2/16"),
        (PLATE_SUDDENLY_PINNED, "energy lost in the blow / kinetic energy before the blow", "3/4"),
        (PLATE_SUDDENLY_PINNED, "speed of plate.center after the blow", "w0*a*sqrt(2)/8"),
        # Kleppner & Kolenkow, ch. 4: the speeds along the string become equal
        (SLACK_STRING, "time when apart = L", "sqrt(L^2-a^2)/v"),
        (SLACK_STRING, "speed of B after the impact", "mA*v*sqrt(L^2-a^2)/(L*(mA+mB))"),
        (SLACK_STRING, "energy lost in the impact", "mA*mB*v^2*(1-a^2/L^2)/(2*(mA+mB))"),
        (SLACK_STRING, "size of impulse of string", "mA*mB*v*sqrt(1-a^2/L^2)/(mA+mB)"),
        # Beer & Johnston, Dynamics, ch. 13: each impact leaves e of the speed
        (BOUNCING_BALL, "greatest y after the second impact", "e^4*h"),
        (BOUNCING_BALL, "value of e for which greatest y after the second impact = h/4", "1/sqrt(2)"),
        (BOUNCING_BALL, "greatest y after impact 3", "e^6*h"),
        (BOUNCING_BALL, "speed of ball after the third impact", "e^3*sqrt(2*g*h)"),
        (BOUNCING_BALL, "time of the third impact", "sqrt(2*h/g)*(1+2*e+2*e^2)"),
        (BOUNCING_BALL, "value of e for which speed of ball after the second impact = sqrt(g*h/2)", "1/sqrt(2)"),
    ],
)
def test_an_impact_of_a_textbook_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


BOB_HITS_A_BLOCK = """
parameters: {m: 1.5 kg, M: 3 kg, L: 1.2 m, e: 0.8, beta: 70 deg, r: 0.05 m, mu: 0.3, g: 9.81 m/s^2}
ground: {points: {O: [-r, L]}}
bodies:
  bob: {disk: {mass: m, radius: r}, at: [-r - L*sin(beta), L - L*cos(beta)]}
  block: {rectangle: {mass: M, width: 4*r, height: 2*r}, at: [2*r, 0], angle: 0}
connections:
  cord: {string: {from: ground.O, to: bob.center}}
  floor: {slider: {body: block, along: right, friction: mu}}
  hit: {contact: {between: [bob, block], restitution: e}}
loads: {weight: {gravity: g}}
"""
WEIGHT_ON_A_PAN = """
parameters: {m: 30 kg, M: 10 kg, k: 20 kN/m, h: 2 m, l: 1 m, g: 9.81 m/s^2}
ground: {points: {foot: [0, -l]}}
bodies: {weight: {particle: {mass: m}, at: [0, h]}, pan: {particle: {mass: M}, at: [0, 0]}}
connections:
  g1: {slider: {body: weight, along: up}}
  g2: {slider: {body: pan, along: up}}
  hit: {weld: [weight, pan], closes: when y = 0}
loads: {load: {gravity: g}, spring: {spring: {first: ground.foot, second: pan, stiffness: k, length: l + M*g/k}}}
measures: {y: y of weight, z: y of pan}
start: {y: h, z: 0, rate(y): 0, rate(z): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # energy down to the block, then the impact of two masses
        (BOB_HITS_A_BLOCK, "speed of block after the impact", "m*(1 + e)/(m + M)*sqrt(2*g*L*(1 - cos(beta)))"),
        # it is pressed all the time: its greatest force is no tension
        (
            WEIGHT_ON_A_PAN,
            "greatest force in spring",
            "(m + M)*g + m*sqrt(g**2 + 2*k*g*h/(m + M))",
        ),
    ],
)
def test_what_follows_an_impact_has_its_formula(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)
