"""Closed loops and guides: problems of textbook families, each with the formula that follows by hand."""

from __future__ import annotations

import pytest

from posed import is_formula

SCOTCH_YOKE = """
parameters: {r: 0.1 m, omega: 10 rad/s, m: 2 kg, F: 50 N, beta: 30 deg}
ground: {points: {O: [0, 0]}}
bodies:
  crank: {rod: {length: r}}
  yoke: {body: {mass: m}, at: [r, 0]}
connections:
  bearing: {pin: [ground.O, crank.start]}
  rail: {slider: {body: yoke, along: right}}
  groove: {slot: {pin: crank.end, on: yoke, along: up}}
  motor: {driver: {measure: phi, follows: omega*t}}
loads: {resist: {force: {at: yoke, along: left, magnitude: F}}}
measures: {phi: angle of crank, x: x of yoke}
"""
QUICK_RETURN = """
parameters: {r: 0.1 m, d: 0.25 m, omega: 5 rad/s, phi1: 40 deg}
ground: {points: {O: [0, 0], A: [0, -d]}}
bodies:
  crank: {rod: {length: r}}
  arm: {rod: {length: 0.5 m}, near: {angle: 70 deg}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [ground.A, arm.start]}
  groove: {slot: {pin: crank.end, on: arm, along: arm.x, through: arm.start}}
  motor: {driver: {measure: phi, follows: omega*t}}
measures: {phi: angle of crank, psi: angle of arm}
"""
SHAPER = """
parameters: {r: 0.12 m, d: 0.3 m, l: 0.65 m, w: 4 rad/s}
ground: {points: {O: [0, d], Q: [0, 0], H: [0, l]}}
bodies:
  crank: {rod: {length: r}}
  lever: {body: {}, points: {tip: [l, 0]}}
  ram: {body: {}}
connections:
  O: {pin: [ground.O, crank.start]}
  Q: {pin: [ground.Q, lever.origin]}
  block: {slot: {pin: crank.end, along: lever.x}}
  yoke: {slot: {pin: lever.tip, along: ram.y}}
  way: {slider: {body: ram, along: right, through: ground.H}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: angle of crank, phi: angle of lever, x: x of ram}
"""
TOGGLE_PRESS = """
parameters: {L: 0.3 m, alpha: 20 deg, P: 200 N, Q: 250 N}
ground: {points: {A: [0, 0]}}
bodies:
  lower: {rod: {length: L}}
  upper: {rod: {length: L}, near: {angle: 110 deg}}
  ram: {particle: {mass: 0}, near: {at: [0, 0.5 m]}}
connections:
  A: {pin: [ground.A, lower.start]}
  knee: {pin: [lower.end, upper.start]}
  top: {pin: [upper.end, ram]}
  guide: {slider: {body: ram, along: up, through: ground.A}}
loads:
  push: {force: {at: lower.end, along: left, magnitude: P}}
  work: {force: {at: ram, along: down, magnitude: Q}}
measures: {theta: angle of lower from up clockwise}
start: {theta: alpha}
"""
PLATE_ON_TWO_LINKS = """
parameters: {m: 10 kg, b: 0.6 m, h: 0.4 m, L: 0.5 m, theta0: 30 deg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [b, 0]}}
bodies: {plate: {rectangle: {mass: m, width: b, height: h}, near: {at: [0.5 m, -0.6 m], angle: 0}}}
connections:
  left: {link: [ground.A, plate.top_left, L]}
  right: {link: [ground.B, plate.top_right, L]}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.A to plate.top_left from down}
start: {theta: theta0}
"""
OFFSET_SLIDER_CRANK = """
parameters: {r: 0.1 m, l: 0.35 m, e: 0.05 m, omega: 20 rad/s}
ground: {points: {O: [0, 0], G: [0, e]}}
bodies:
  crank: {rod: {length: r}, angle: 0}
  rod: {rod: {length: l}, near: {angle: 5 deg}}
  piston: {particle: {mass: 1 kg}, near: {at: [0.4 m, 0.05 m]}}
connections:
  O: {pin: [ground.O, crank.start]}
  B: {pin: [crank.end, rod.start]}
  C: {pin: [rod.end, piston]}
  guide: {slot: {pin: piston, along: right, through: ground.G}}
  motor: {driver: {measure: phi, follows: omega*t}}
measures: {phi: angle of crank, x: x of piston}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Meriam & Kraige, Dynamics, ch. 5: x = r cos(phi); the power of the drive moves the yoke
        (SCOTCH_YOKE, "velocity of x when phi = beta", "-r*omega*sin(beta)"),
        (SCOTCH_YOKE, "acceleration of x when phi = beta", "-r*omega^2*cos(beta)"),
        (SCOTCH_YOKE, "driving torque of motor when phi = beta", "r*sin(beta)*(m*r*omega^2*cos(beta)-F)"),
        (SCOTCH_YOKE, "stroke of x over a turn of phi", "2*r"),
        (SCOTCH_YOKE, "work of motor until phi = 180 deg", "-2*F*r"),
        # Beer & Johnston, Dynamics, ch. 15: tan(psi) = (d + r sin(phi))/(r cos(phi))
        (QUICK_RETURN, "velocity of psi when phi = phi1", "omega*r*(r+d*sin(phi1))/(r^2+d^2+2*r*d*sin(phi1))"),
        (QUICK_RETURN, "time ratio of psi over a turn of phi", "(pi+2*asin(r/d))/(pi-2*asin(r/d))"),
        (QUICK_RETURN, "stroke of psi over a turn of phi", "2*asin(r/d)"),
        (QUICK_RETURN, "least angular velocity of arm over a turn of phi", "-omega*r/(d-r)"),
        (QUICK_RETURN, "greatest angular velocity of arm over a turn of phi", "omega*r/(d+r)"),
        # Meriam & Kraige, Statics, ch. 7: virtual work, P L cos(theta) = 2 Q L sin(theta)
        (TOGGLE_PRESS, "value of Q for which it stays at rest", "P/(2*tan(alpha))"),
        (TOGGLE_PRESS, "equilibrium of theta", "atan(P/(2*Q))"),
        (TOGGLE_PRESS, "normal force of guide in equilibrium", "-P/2"),
        # Meriam & Kraige, Dynamics, ch. 6: the plate is translated; moments about its centre
        (PLATE_ON_TWO_LINKS, "tension of left at start", "m*g/2*(cos(theta0)+h/b*sin(theta0))"),
        (PLATE_ON_TWO_LINKS, "value of h for which tension of right = 0 at start", "b/tan(theta0)"),
        (PLATE_ON_TWO_LINKS, "tension of left when theta = 0", "m*g/2*(3-2*cos(theta0))"),
        (PLATE_ON_TWO_LINKS, "period of small oscillations", "2*pi*sqrt(L/g)"),
        (PLATE_ON_TWO_LINKS, "acceleration of theta at start", "-g*sin(theta0)/L"),
        # Dankert & Dankert, ch. 27: x = r cos(phi) + sqrt(l^2 - (e - r sin(phi))^2)
        (OFFSET_SLIDER_CRANK, "range of l for which the crank turns fully", "r+e"),
        (OFFSET_SLIDER_CRANK, "stroke of x over a turn of phi", "sqrt((l+r)^2-e^2)-sqrt((l-r)^2-e^2)"),
        (OFFSET_SLIDER_CRANK, "velocity of x when phi = 90 deg", "-r*omega"),
        (OFFSET_SLIDER_CRANK, "angular velocity of rod at start", "-r*omega/sqrt(l^2-e^2)"),
        (
            OFFSET_SLIDER_CRANK,
            "time ratio of x over a turn of phi",
            "(pi+asin(e/(l-r))-asin(e/(l+r)))/(pi-asin(e/(l-r))+asin(e/(l+r)))",
        ),
        # Norton, ch. 2 and 6: x = l cos(phi) of the lever; the ram is not turned, though its guide would let it be
        (SHAPER, "stroke of x over a turn of theta", "2*l*r/d"),
        (SHAPER, "greatest velocity of x over a turn of theta", "l*r*w/(d-r)"),
    ],
)
def test_a_loop_of_a_textbook_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_a_yoke_that_is_put_in_numbers_is_asked_about_as_one_that_is_put_by_the_crank() -> None:
    # x = r cos(phi); the place of the yoke fits the file's own r alone, at which the crank is at its dead point
    model = SCOTCH_YOKE.replace("at: [r, 0]", "at: [0.1 m, 0]")
    is_formula(model, "velocity of x when phi = beta", "-r*omega*sin(beta)")
