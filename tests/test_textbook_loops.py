"""Loops: linkages and frames that close. Ten problems in the style of textbooks, in words and numbers of our own; from
what the formula follows by hand stands beside it."""

from __future__ import annotations

import pytest

from posed import is_formula

# Hibbeler, Statics, ch. 11: virtual work on a scissor lift
SCISSOR_LIFT = """
parameters: {W: 2 kN, F: 3 kN, L: 2 m, phi0: 35 deg}
ground: {points: {O: [0, 0]}, lines: {floor: {along: right}}}
bodies:
  a: {rod: {mass: 0, length: L}}
  b: {rod: {mass: 0, length: L}, near: {angle: 145 deg}}
  top: {rod: {mass: 0, length: L}, near: {angle: 0}, lines: {under: {along: right}}}
connections:
  O: {pin: [ground.O, a.start]}
  roller: {slot: [b.start, ground.floor]}
  mid: {pin: [a.mass_center, b.mass_center]}
  T: {pin: [b.end, top.start]}
  S: {slot: [a.end, top.under]}
loads:
  w: {force: {at: top, along: down, magnitude: W}}
  ram: {force: {at: b.start, along: left, magnitude: F}}
measures: {phi: angle of a, y: y of top}
start: {phi: phi0}
"""
# Norton, Design of Machinery, ch. 2: a Geneva wheel while the pin is in its groove
GENEVA_WHEEL = """
parameters: {r: 0.1 m, d: 0.15 m, w: 4 rad/s}
ground: {points: {O: [0, 0], D: [d, 0]}}
bodies:
  crank: {rod: {mass: 0, length: r}}
  wheel:
    body: {mass: 1 kg}
    points: {O: [0, 0]}
    lines: {groove: {along: right}}
    near: {at: [0.15 m, 0], angle: 180 deg}
connections:
  O: {pin: [ground.O, crank.start]}
  D: {pin: [ground.D, wheel.O]}
  pin: {slot: [crank.end, wheel.groove]}
  motor: {driver: {measure: psi, follows: w*t}}
measures: {psi: angle of crank, phi: angle of wheel}
start: {psi: 0}
"""
# Meriam & Kraige, Dynamics, ch. 5: a bed that a ram lifts
DUMP_TRUCK = """
parameters: {a: 2.5 m, b: 1.8 m, v: 0.2 m/s, m: 3000 kg, c: 1.5 m, g: 9.81 m/s^2, p0: 20 deg}
ground: {points: {O: [0, 0], C: [b, 0]}}
bodies: {bed: {body: {mass: m, inertia: 1000 kg*m^2}, points: {O: [-c, 0], P: [a - c, 0]}}}
connections:
  hinge: {pin: [ground.O, bed.O]}
  ram: {driver: {measure: s, follows: sqrt(a^2 + b^2 - 2*a*b*cos(p0)) + v*t}}
loads: {weight: {gravity: g}}
measures: {phi: angle of bed, s: distance from ground.C to bed.P}
start: {phi: p0}
"""
# Artobolevsky, Mechanisms, vol. 1: the straight line of Scott Russell
SCOTT_RUSSELL = """
parameters: {L: 0.3 m, w: 2 rad/s, m: 1 kg}
ground: {points: {O: [0, 0]}, lines: {rail: {along: right}}}
bodies:
  crank: {rod: {mass: 0, length: L}}
  bar: {rod: {mass: 0, length: 2*L}, near: {angle: -40 deg}}
  slide: {particle: {mass: m}}
connections:
  O: {pin: [ground.O, crank.start]}
  mid: {pin: [crank.end, bar.center]}
  B: {pin: [bar.end, slide]}
  rail: {slider: [slide, ground.rail]}
  motor: {driver: {measure: psi, follows: w*t + 0.7 rad}}
measures: {psi: angle of crank, x: x of bar.start, y: y of bar.start, s: x of slide}
"""
# Beer & Johnston, Dynamics, ch. 15: a collar on a guide and a rod that turns
SWIVELLING_ROD = """
parameters: {d: 0.4 m, w: 3 rad/s}
ground: {points: {O: [0, 0]}, lines: {guide: {along: up, through: [d, 0]}}}
bodies: {rod: {rod: {mass: 0, length: 2 m}}, collar: {particle: {mass: 1 kg}}}
connections:
  O: {pin: [ground.O, rod.start]}
  guide: {slider: [collar, ground.guide]}
  on: {slot: {pin: collar, along: right, on: rod}}
  motor: {driver: {measure: theta, follows: w*t}}
measures: {theta: angle of rod, y: y of collar}
"""
# Hibbeler, Dynamics, ch. 16: crank and rocker both upright
FOUR_BAR_AT_RIGHT_ANGLES = """
parameters: {a: 0.1 m, b: 0.3 m, c: 0.2 m, w: 10 rad/s}
ground: {points: {O: [0, 0], D: [b, a - c]}}
bodies:
  crank: {rod: {mass: 0, length: a}}
  coupler: {rod: {mass: 1 kg, length: b}, near: {angle: 0}}
  rocker: {rod: {mass: 0, length: c}, near: {angle: 90 deg}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, coupler.start]}
  B: {pin: [coupler.end, rocker.end]}
  D: {pin: [ground.D, rocker.start]}
  motor: {driver: {measure: psi, follows: pi/2 - w*t}}
measures: {psi: angle of crank, phi: angle of rocker}
"""
# Hartenberg & Denavit, Kinematic Synthesis of Linkages, ch. 1: a pantograph
PANTOGRAPH = """
parameters: {a: 0.2 m, b: 0.3 m, v: 0.1 m/s}
ground: {points: {O: [0, 0]}, lines: {track: {along: right, through: [0, 0.1 m]}}}
bodies:
  one: {rod: {mass: 0, length: a + b}, points: {P: [a - (a + b)/2, 0]}, near: {angle: 70 deg}}
  two: {rod: {mass: 0, length: a + b}, points: {Q: [a - (a + b)/2, 0]}, near: {angle: -30 deg}}
  three: {rod: {mass: 0, length: a}, near: {angle: -30 deg}}
  four: {rod: {mass: 0, length: b}, near: {angle: 70 deg}}
connections:
  O: {pin: [ground.O, one.start]}
  A: {pin: [one.P, three.start]}
  B: {pin: [one.end, two.start]}
  C: {pin: [three.end, four.start]}
  D: {pin: [four.end, two.Q]}
  track: {slot: [three.end, ground.track]}
  hand: {driver: {measure: u, follows: 0.2 m + v*t}}
measures: {u: x of three.end, X: x of two.end}
"""
# Mabie & Reinholtz, Mechanisms and Dynamics of Machinery, ch. 1: a toggle press
TOGGLE_PRESS = """
parameters: {L: 0.4 m, P: 500 N, F: 1 kN, p0: 10 deg}
ground: {points: {O: [0, 0]}, lines: {guide: {along: up}}}
bodies:
  u: {rod: {mass: 0, length: L}, near: {angle: 80 deg}}
  v: {rod: {mass: 0, length: L}, near: {angle: 100 deg}}
  ram: {particle: {mass: 1 kg}}
connections:
  O: {pin: [ground.O, u.start]}
  K: {pin: [u.end, v.start]}
  R: {pin: [v.end, ram]}
  guide: {slider: [ram, ground.guide]}
loads:
  hand: {force: {at: u.end, along: left, magnitude: P}}
  work: {force: {at: ram, along: down, magnitude: F}}
measures: {theta: angle of u from up clockwise, y: y of ram}
start: {theta: p0}
"""
# Uicker, Pennock & Shigley, Theory of Machines and Mechanisms, ch. 14: a piston at its dead centres
PISTON = """
parameters: {r: 0.05 m, l: 0.2 m, w: 300 rad/s, m: 0.6 kg}
ground: {points: {O: [0, 0]}, lines: {bore: {along: right}}}
bodies:
  crank: {rod: {mass: 0, length: r}}
  rod: {rod: {mass: 0, length: l}, near: {angle: 0}}
  piston: {particle: {mass: m}}
connections:
  O: {pin: [ground.O, crank.start]}
  A: {pin: [crank.end, rod.start]}
  B: {pin: [rod.end, piston]}
  bore: {slider: [piston, ground.bore]}
  motor: {driver: {measure: psi, follows: w*t}}
measures: {psi: angle of crank, x: x of piston}
"""
# Gross, Hauger et al., Technische Mechanik 1, ch. 6: a parallelogram held by its diagonal
PARALLELOGRAM_WITH_A_STAY = """
parameters: {L: 1.5 m, b: 0.6 m, W: 800 N, p0: 40 deg}
ground: {points: {A: [0, 0], B: [0, b]}}
bodies:
  l: {rod: {mass: 0, length: L}, near: {angle: 40 deg}}
  u: {rod: {mass: 0, length: L}, near: {angle: 40 deg}}
  head: {body: {mass: 0}, points: {P: [0, 0], Q: [0, b], S: [b, 0]}, near: {angle: 0}}
connections:
  A: {pin: [ground.A, l.start]}
  B: {pin: [ground.B, u.start]}
  P: {pin: [l.end, head.P]}
  Q: {pin: [u.end, head.Q]}
  ram: {bar: [ground.B, l.end]}
loads: {w: {force: {at: head.S, along: down, magnitude: W}}}
measures: {phi: angle of l}
start: {phi: p0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # W dy = F dx with y = L sin and x = L cos
        (SCISSOR_LIFT, "value of F for which the lift is in equilibrium", "W/tan(phi0)"),
        # r/(d - r) in the middle
        (GENEVA_WHEEL, "angular velocity of wheel at start", "-w*r/(d - r)"),
        # tan(phi) = r sin/(r cos - d), differentiated
        (
            GENEVA_WHEEL,
            "angular velocity of wheel when psi = 20 deg",
            "w*r*(r - d*cos(pi/9))/(r**2 + d**2 - 2*r*d*cos(pi/9))",
        ),
        # s^2 = a^2 + b^2 - 2 a b cos: s s' = a b sin phi'
        (DUMP_TRUCK, "angular velocity of bed at start", "v*sqrt(a**2 + b**2 - 2*a*b*cos(p0))/(a*b*sin(p0))"),
        # y = 2 L sin(psi)
        (SCOTT_RUSSELL, "velocity of y when psi = 60 deg", "2*L*w*cos(pi/3)"),
        # s = 2 L cos(psi)
        (SCOTT_RUSSELL, "ratio of velocity of y to velocity of s when psi = 60 deg", "-1/tan(pi/3)"),
        # of the slide alone: m s' s''/w
        (SCOTT_RUSSELL, "torque of motor when psi = 60 deg", "4*m*L**2*w**2*sin(pi/3)*cos(pi/3)"),
        # y = d tan(w t)
        (SWIVELLING_ROD, "velocity of y at start", "w*d"),
        # the coupler does not turn: a w on both sides
        (FOUR_BAR_AT_RIGHT_ANGLES, "angular velocity of rocker at start", "-w*a/c"),
        # (c w_c^2 - a w^2)/b upwards
        (FOUR_BAR_AT_RIGHT_ANGLES, "angular acceleration of coupler at start", "(a*w**2 - (a*w)**2/c)/b"),
        # all of it moves alike
        (FOUR_BAR_AT_RIGHT_ANGLES, "speed of coupler.mass_center at start", "a*w"),
        # both points and the pivot stay on one line
        (PANTOGRAPH, "ratio of velocity of X to velocity of u", "(a + b)/a"),
        # P L cos = F 2 L sin
        (TOGGLE_PRESS, "value of F for equilibrium", "P/(2*tan(p0))"),
        # r w^2 (1 + r/l)
        (PISTON, "acceleration of x when psi = 0", "-r*w**2*(1 + r/l)"),
        # r w^2 (1 - r/l)
        (PISTON, "acceleration of x when psi = 180 deg", "r*w**2*(1 - r/l)"),
        # the rod does not turn
        (PISTON, "velocity of x when psi = 90 deg", "-r*w"),
        # x^2 + r^2 = l^2 to second order
        (PISTON, "acceleration of x when psi = 90 deg", "r**2*w**2/sqrt(l**2 - r**2)"),
        # S d(diagonal) = W dy with diagonal^2 = L^2 + b^2 - 2 L b sin
        (PARALLELOGRAM_WITH_A_STAY, "force in ram", "W*sqrt(L**2 + b**2 - 2*L*b*sin(p0))/b"),
    ],
)
def test_a_loop_has_the_formula_of_its_derivation(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)
