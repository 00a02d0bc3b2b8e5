"""First integrals: energy, momenta and laws that can be separated. Eleven problems in the style of textbooks, in words
and numbers of our own; from what the formula follows by hand stands beside it."""

from __future__ import annotations

import pytest

from posed import is_formula

# Goldstein, Classical Mechanics, ch. 3: a puck is drawn towards a hole by a constant force
PUCK_AND_HOLE = """
parameters: {m: 0.5 kg, F: 4 N, a: 0.6 m, b: 0.4 m, v0: 1 m/s}
ground: {points: {O: [0, 0]}}
bodies: {puck: {particle: {mass: m}}}
loads: {string: {law: {measure: r, force: -F}}}
measures: {r: distance from ground.O to puck, phi: angle of line from ground.O to puck}
start: {r: a, phi: 0, rate(r): 0, rate(phi): v0/a}
"""
# Meriam & Kraige, Dynamics, ch. 6: a sleeve slides out on a rod that turns freely
SLEEVE_ON_A_ROD = """
parameters: {I: 0.4 kg*m^2, m: 1 kg, a: 0.2 m, b: 0.6 m, w0: 10 rad/s}
bodies:
  rod: {body: {mass: 2 kg, inertia: I}, points: {O: [0, 0]}, lines: {axis: {along: right}}}
  sleeve: {particle: {mass: m}}
connections: {axle: {pin: [ground.O, rod.O]}, groove: {slider: {body: sleeve, along: rod.axis}}}
measures: {phi: angle of rod, r: travel of sleeve along rod.axis from rod.O}
start: {phi: 0, rate(phi): w0, r: a, rate(r): 0}
"""
# Morin, Introduction to Classical Mechanics, ch. 8: a chimney that topples
CHIMNEY = """
parameters: {m: 400 kg, L: 12 m, x: 4 m, th0: 2 deg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {rod: {rod: {mass: m, length: L}, points: {P: [x - L/2, 0]}}}
connections: {foot: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod from up clockwise}
start: {theta: th0, rate(theta): 0}
"""
# Beer & Johnston, Dynamics, ch. 17: a ball rolls down a wedge that slides
BALL_ROLLS_ON_A_WEDGE = """
parameters: {M: 6 kg, m: 3 kg, r: 0.1 m, alpha: 30 deg, d: 1 m, g: 9.81 m/s^2}
bodies:
  W: {body: {mass: M, inertia: 1 kg*m^2}, lines: {slope: {along: -alpha}}}
  ball: {sphere: {mass: m, radius: r}}
connections: {floor: {slider: {body: W, along: right}}, roll: {rolling: {body: ball, on: W.slope}}}
loads: {weight: {gravity: g}}
measures: {x: x of W, s: travel of ball along W.slope from W}
start: {x: 0, rate(x): 0, s: 0, rate(s): 0}
"""
# Meriam & Kraige, Dynamics, ch. 3: a car of constant power
CONSTANT_POWER = """
parameters: {m: 1200 kg, P: 40 kW, v0: 5 m/s, v1: 25 m/s, T: 6 s}
bodies: {car: {particle: {mass: m}}}
connections: {road: {slider: {body: car, along: right}}}
loads: {engine: {law: {measure: x, force: P/rate(x)}}}
measures: {x: x of car}
start: {x: 0, rate(x): v0}
"""
# Irodov, Problems in General Physics, part 1: shot straight at what repels by k/x^2
REPELLED = """
parameters: {m: 0.1 kg, k: 2 N*m^2, a: 5 m, v0: 3 m/s, b: 1 m}
ground: {points: {O: [0, 0]}}
bodies: {p: {particle: {mass: m}}}
connections: {g: {slider: {body: p, along: right}}}
loads: {push: {law: {measure: x, force: k/x^2}}}
measures: {x: x of p}
start: {x: a, rate(x): -v0}
"""
# Beer & Johnston, Dynamics, ch. 17: two hinged rods spread on a smooth floor
A_FRAME = """
parameters: {m: 3 kg, L: 1 m, p0: 60 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, mid: {along: up}}}
bodies:
  l: {rod: {mass: m, length: L}, near: {angle: 60 deg}}
  r: {rod: {mass: m, length: L}, near: {angle: 120 deg}}
connections:
  A: {slot: [l.start, ground.floor]}
  B: {slot: [r.start, ground.floor]}
  C: {pin: [l.end, r.end]}
  mid: {slot: [l.end, ground.mid]}
loads: {weight: {gravity: g}}
measures: {phi: angle of l, y: y of l.end}
start: {phi: p0, rate(phi): 0}
"""
# Timoshenko & Young, Engineering Mechanics, ch. 8: a weight on a drum with a torsional spring
WEIGHT_ON_A_DRUM = """
parameters: {M: 6 kg, R: 0.2 m, m: 3 kg, kt: 15 N*m, g: 9.81 m/s^2}
bodies: {drum: {disk: {mass: M, radius: R}, at: [0, 0]}, b: {particle: {mass: m}, at: [R, -1 m]}}
connections: {axle: {pin: [ground.O, drum.center]}, rope: {string: {path: [wound on drum at right, b]}}}
loads: {weight: {gravity: g}, t: {law: {measure: phi, force: -kt*phi}}}
measures: {phi: angle of drum clockwise, x: drop of b below ground.O}
start: {x: 1 m, rate(x): 0, phi: 0}
"""
# Goldstein, ch. 2: a hoop rolls off a cylinder
HOOP_ON_A_CYLINDER = """
parameters: {m: 1 kg, r: 0.1 m, R: 0.5 m, w0: 0.1 rad/s, g: 9.81 m/s^2}
bodies: {cyl: {disk: {mass: 0, radius: R}, at: [0, 0], fixed: true}, hoop: {hoop: {mass: m, radius: r}}}
connections: {roll: {rolling: {body: hoop, on: cyl}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from cyl.center to hoop.center from up clockwise}
start: {theta: 0, rate(theta): w0}
"""
# Kibble & Berkshire, Classical Mechanics, ch. 7: two masses on a spring, one of them struck
MASSES_ON_A_SPRING = """
parameters: {m1: 1 kg, m2: 2 kg, k: 90 N/m, L: 0.5 m, v: 1 m/s}
bodies: {A: {particle: {mass: m1}}, B: {particle: {mass: m2}}}
connections: {gA: {slider: {body: A, along: right}}, gB: {slider: {body: B, along: right}}}
loads: {s: {spring: {first: A, second: B, stiffness: k, length: L}}}
measures: {x: x of A, y: x of B}
start: {x: 0, rate(x): v, y: L, rate(y): 0}
"""

# Magnus & Müller, Grundlagen der Technischen Mechanik: a pendulum with a constant friction torque, first half swing
RUBBED_PENDULUM = """
parameters: {m: 1 kg, L: 1 m, M: 0.3 N*m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {pivot: {pin: [ground.O, rod.start]}, rub: {brake: {between: [rod, ground], torque: M}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of rod from down}
start: {phi: 60 deg, rate(phi): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # m L^2/6 phi'^2 = m g L/4 - M pi/3
        pytest.param(
            RUBBED_PENDULUM,
            "velocity of phi when phi = 0",
            "-sqrt(3*g/(2*L) - 2*pi*M/(m*L**2))",
            marks=pytest.mark.slow,
        ),
        # r'^2 + (v0 a/r)^2 = v0^2 + 2 F (a - r)/m
        (PUCK_AND_HOLE, "velocity of r when r = b", "-sqrt(v0**2*(1 - a**2/b**2) + 2*F*(a - b)/m)"),
        # r^2 phi' = a v0
        (PUCK_AND_HOLE, "angular velocity of phi when r = b", "v0*a/b**2"),
        # without the root r = a: 2 F r^2 = m v0^2 (a + r)
        (PUCK_AND_HOLE, "least r", "(m*v0**2 + sqrt(m**2*v0**4 + 8*F*a*m*v0**2))/(4*F)"),
        # (I + m r^2) phi' is kept
        (SLEEVE_ON_A_ROD, "angular velocity of rod when r = b", "(I + m*a**2)*w0/(I + m*b**2)"),
        # and the energy
        (SLEEVE_ON_A_ROD, "velocity of r when r = b", "w0*sqrt((I + m*a**2)*(b**2 - a**2)/(I + m*b**2))"),
        # weight and inertia of the part above: m g sin x (1 - x/L)^2/4
        (CHIMNEY, "bending moment of rod at P when theta = 45 deg", "m*g*sin(pi/4)*x*(1 - x/L)**2/4"),
        # the tilt at which 3 cos = 2 cos(th0)
        pytest.param(
            CHIMNEY,
            "value of theta for which x component of reaction of foot on rod = 0",
            "acos(2*cos(th0)/3)",
            marks=pytest.mark.slow,
        ),
        # (M + m) x' + m s' cos = 0 and 7/5 s'' + x'' cos = g sin
        (BALL_ROLLS_ON_A_WEDGE, "acceleration of s", "(M + m)*g*sin(alpha)/(7*(M + m)/5 - m*cos(alpha)**2)"),
        # s' = sqrt(2 d s''), of which the wedge has m cos/(M + m)
        (
            BALL_ROLLS_ON_A_WEDGE,
            "speed of W when s = d",
            "m*cos(alpha)/(M + m)*sqrt(2*d*(M + m)*g*sin(alpha)/(7*(M + m)/5 - m*cos(alpha)**2))",
        ),
        # m v^2 dv = P dx
        (CONSTANT_POWER, "x when rate(x) = v1", "m*(v1**3 - v0**3)/(3*P)"),
        # m v dv = P dt
        (CONSTANT_POWER, "speed of car at t = T", "sqrt(v0**2 + 2*P*T/m)"),
        # m v0^2/2 + k/a = k/x
        (REPELLED, "least x", "1/(m*v0**2/(2*k) + 1/a)"),
        # on the floor each turns about its foot: m L^2/3 w^2 = m g L sin(p0)
        (A_FRAME, "speed of l.end when phi = 0", "sqrt(3*g*L*sin(p0))"),
        # each rod L^2/3 of phi'^2 at every angle
        (A_FRAME, "angular velocity of l when phi = 30 deg", "-sqrt(3*g*(sin(p0) - sin(pi/6))/L)"),
        # m g R = kt phi in the middle, (m + M/2) R^2 the inertia
        (WEIGHT_ON_A_DRUM, "greatest speed of b", "m*g*R/sqrt(kt*(m + M/2))"),
        # (m + M/2) R^2 phi'' = m g R - kt phi
        (WEIGHT_ON_A_DRUM, "period of phi", "2*pi*sqrt((m + M/2)*R**2/kt)"),
        # m g cos - m v^2/(R + r) with v^2 = v0^2 + g (R + r) (1 - cos)
        (
            HOOP_ON_A_CYLINDER,
            "normal force of roll when theta = 30 deg",
            "m*g*cos(pi/6) - m*(g*(1 - cos(pi/6)) + (R + r)*w0**2)",
        ),
        # which vanishes there
        pytest.param(
            HOOP_ON_A_CYLINDER,
            "value of theta for which normal force of roll = 0",
            "acos((1 + (R + r)*w0**2/g)/2)",
            marks=pytest.mark.slow,
        ),
        # the reduced mass has m1 m2/(m1 + m2) v^2 = k s^2
        (MASSES_ON_A_SPRING, "least (y - x)", "L - v*sqrt(m1*m2/(k*(m1 + m2)))"),
        # twice the speed of the mass centre
        (MASSES_ON_A_SPRING, "greatest velocity of y", "2*m1*v/(m1 + m2)"),
        # and for the other one less its own
        (MASSES_ON_A_SPRING, "least velocity of x", "(m1 - m2)*v/(m1 + m2)"),
    ],
)
def test_a_first_integral_gives_the_formula_of_its_derivation(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)
