"""Problems of the textbooks that are not among the examples, solved in closed form.

BJ: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics; MK: Meriam & Kraige, Engineering Mechanics:
Dynamics; H: Hibbeler, Engineering Mechanics. What has no source is derived in its line.
"""

from __future__ import annotations

import functools
from collections.abc import Callable

import pytest

import freebody as fb

Agree = Callable[[fb.Solution, str, str | list[str]], None]
G = "g: 9.81 m/s^2"
WEIGHT = "loads: {weight: {gravity: g}}\n"

# name: model, formula by question
PROBLEMS: dict[str, tuple[str, dict[str, str | list[str]]]] = {
    # BJ ch. 16 (constrained plane motion): x = L/2 sin(phi), y = L/2 cos(phi), (1/12 + 1/4) m L^2 phi'' = m g L/2 s
    "ladder released between smooth floor and wall": (
        f"""
parameters: {{m: 10 kg, L: 4 m, beta: 30 deg, {G}}}
bodies: {{rod: {{rod: {{mass: m, length: L}}}}}}
connections:
  floor: {{slot: {{pin: rod.start, along: right, through: ground.O}}}}
  wall: {{slot: {{pin: rod.end, along: up, through: ground.O}}}}
{WEIGHT}
measures: {{phi: angle of rod from up}}
start: {{phi: beta, rate(phi): 0}}
""",
        {
            "acceleration of phi": "3*g*sin(phi)/(2*L)",
            "horizontal reaction of wall on rod at start": "3*m*g*sin(beta)*cos(beta)/4",
            "vertical reaction of floor on rod at start": "m*g*(1 - 3*sin(beta)**2/4)",
            # it leaves the wall at cos(phi) = 2/3 cos(beta); on the way (phi'^2) = 3 g (cos(beta) - cos(phi))/L
            "velocity of phi when phi = 40 deg": "sqrt(3*g*(cos(beta) - cos(2*pi/9))/L)",
        },
    ),
    # MK sample problem 6/2 type: about the cord's end the rod starts to turn at 3 g/(2 L); S = m (g - L/2 alpha)
    "rod on two cords, one is cut": (
        f"""
parameters: {{m: 10 kg, L: 2 m, l: 1 m, {G}}}
bodies: {{rod: {{rod: {{mass: m, length: L}}, at: {{start: [0, -l]}}, angle: 0}}}}
connections: {{cord: {{link: [ground.A, rod.start, l]}}}}
{WEIGHT}
""",
        {
            "tension of cord at start": "m*g/4",
            "angular acceleration of rod at start": "-3*g/(2*L)",
            "acceleration of rod.end along down at start": "3*g/2",
        },
    ),
    # the string runs along the table from where the block is put; a = m2 g/(m1 + m2), until the block is at the edge
    "block on a table, string over the edge to a weight that starts there": (
        f"""
parameters: {{m1: 4 kg, m2: 3 kg, h: 0.5 m, b: 1 m, {G}}}
bodies: {{block: {{particle: {{mass: m1}}, at: [-b, 0]}}, hanger: {{particle: {{mass: m2}}}}}}
connections:
  table: {{slider: {{body: block, along: right, through: ground.edge}}}}
  shaft: {{slider: {{body: hanger, along: down, through: ground.edge}}}}
  cord: {{string: {{from: block, over: [ground.edge], to: hanger}}}}
ground: {{points: {{edge: [0, 0]}}}}
{WEIGHT}
measures: {{y: drop of hanger below ground.edge}}
start: {{y: 0, rate(y): 0}}
""",
        {
            "acceleration of y": "m2*g/(m1 + m2)",
            "tension of cord": "m1*m2*g/(m1 + m2)",
            "speed of hanger when y = h": "sqrt(2*g*h*m2/(m1 + m2))",
            "time when y = h": "sqrt(2*h*(m1 + m2)/(g*m2))",
        },
    ),
    # isosceles loops close with an angle, phi = 2 theta - pi: y_G = L/2 sin(theta) - R sin(2 theta), and at rest
    # 4 R cos(2 theta) = L cos(theta)
    "rod in a smooth bowl, over its rim": (
        f"""
parameters: {{m: 2 kg, L: 1.2 m, R: 0.5 m, {G}}}
bodies: {{rod: {{rod: {{mass: m, length: L}}, near: {{at: {{start: [-0.4, -0.3]}}}}}}}}
ground: {{points: {{O: [0, 0], rim: [R, 0]}}}}
connections:
  bowl: {{link: {{first: ground.O, second: rod.start, length: R}}}}
  edge: {{slot: {{pin: ground.rim, along: rod.x, on: rod}}}}
{WEIGHT}
measures: {{th: angle of rod}}
start: {{th: 20 deg}}
""",
        {
            "equilibrium of th": "acos((L + sqrt(L**2 + 128*R**2))/(16*R))",
            "velocity of rod.center along down": "(2*R*cos(2*th) - L*cos(th)/2)*rate(th)",
        },
    ),
    # crank and rod of one length: x = 2 r cos(theta); T = m r^2 theta'^2 (1/3 + 3 sin^2), V = m g r sin(theta)
    "slider-crank with equal crank and rod": (
        f"""
parameters: {{r: 0.2 m, m: 1 kg, {G}}}
bodies:
  crank: {{rod: {{length: r, mass: m}}}}
  rod: {{rod: {{length: r, mass: m}}, near: {{angle: -50 deg}}}}
  piston: {{particle: {{mass: m}}}}
connections:
  main: {{pin: [ground.O, crank.start]}}
  crankpin: {{pin: [crank.end, rod.start]}}
  wristpin: {{pin: [rod.end, piston]}}
  cylinder: {{slider: {{body: piston, along: right, through: ground.O}}}}
{WEIGHT}
measures: {{th: angle of crank, x: x of piston}}
start: {{th: 50 deg, rate(th): 0}}
""",
        {
            "velocity of x": "-2*r*rate(th)*sin(th)",
            "acceleration of th": "-cos(th)*(g + 6*r*rate(th)**2*sin(th))/(2*r*(1/3 + 3*sin(th)**2))",
        },
    ),
    # BJ sample problem 16.8 type: cord from below the hub, P (R - r) = (J + M R^2) a/R, the weight sinks a (1 - r/R)
    "spool pulled by a cord on its hub": (
        f"""
parameters: {{M: 10 kg, J: 0.2 kg m^2, R: 0.2 m, r: 0.1 m, m: 3 kg, rp: 0.05 m, {G}}}
ground: {{lines: {{table: {{along: right}}}}, points: {{edge: [2 m, R - r - rp]}}}}
bodies:
  spool: {{body: {{mass: M, inertia: J, radius: R}}, at: [0, R]}}
  pulley: {{disk: {{radius: rp}}}}
  weight: {{particle: {{mass: m}}}}
connections:
  contact: {{rolling: {{body: spool, on: table}}}}
  axle: {{pin: [ground.edge, pulley]}}
  cord: {{string: {{path: [wound on spool radius r at bottom, over pulley, weight], leads: [right, down]}}}}
{WEIGHT.replace("weight", "gravity", 1)}
""",
        {
            "acceleration of spool along right": "m*g*R*(R - r)/(J + M*R**2 + m*(R - r)**2)",
            "tension of cord at weight": "m*g*(J + M*R**2)/(J + M*R**2 + m*(R - r)**2)",
            "friction force of contact": "M*m*g*R*(R - r)/(J + M*R**2 + m*(R - r)**2)"
            " - m*g*(J + M*R**2)/(J + M*R**2 + m*(R - r)**2)",
        },
    ),
    # MK art. 6/5: only friction acts, m a = F, m R^2/2 alpha = F R, a + R alpha = a0 on the plank
    "cylinder on an accelerated plank": (
        f"""
parameters: {{m: 4 kg, R: 0.1 m, M: 2 kg, h: 0.05 m, a0: 3 m/s^2, {G}}}
bodies:
  plank: {{rectangle: {{mass: M, width: 2 m, height: h}}, lines: {{top: {{through: [0, h/2], along: right}}}}}}
  roll: {{disk: {{mass: m, radius: R}}}}
connections:
  floor: {{slider: {{body: plank, along: right}}}}
  motor: {{driver: {{measure: x of plank, follows: a0*t^2/2}}}}
  contact: {{rolling: {{body: roll, on: plank.top}}}}
{WEIGHT}
""",
        {
            "acceleration of roll along right": "a0/3",
            "angular acceleration of roll": "2*a0/(3*R)",
            "friction force of contact": "m*a0/3",
            "driving force of motor": "(M + m/3)*a0",
            "normal force of contact": "m*g",
        },
    ),
    # Norton ch. 9 (Willis): (w_p - w)/(0 - w) = -r_s/r_p
    "epicyclic train with a driven arm": (
        """
parameters: {rs: 0.1 m, rp: 0.05 m, Ia: 0.02 kg m^2, Ip: 0.001 kg m^2, mp: 0.5 kg, T: 3 N m}
bodies:
  sun: {disk: {radius: rs}, fixed: true}
  arm: {body: {inertia: Ia}, points: {P: [rs + rp, 0]}}
  planet: {body: {mass: mp, inertia: Ip, radius: rp}}
connections:
  bearing: {pin: [ground.S, arm]}
  axle: {pin: [arm.P, planet]}
  teeth: {gear_mesh: [sun, planet]}
loads: {drive: {torque: {on: arm, magnitude: T}}}
""",
        {
            "ratio of angular velocity of planet to angular velocity of arm": "1 + rs/rp",
            "angular acceleration of arm": "T/(Ia + mp*(rs + rp)**2 + Ip*(1 + rs/rp)**2)",
        },
    ),
    # MK art. 6/4 problems: inertias reduced to the first shaft by the squares of the ratios
    "train of three gears": (
        """
parameters: {I1: 0.1 kg m^2, I2: 0.2 kg m^2, I3: 0.3 kg m^2, r1: 0.1 m, r2: 0.2 m, r3: 0.3 m, T: 3 N m}
ground: {points: {A: [0, 0], B: [r1 + r2, 0], C: [r1 + 2*r2 + r3, 0]}}
bodies:
  g1: {body: {inertia: I1, radius: r1}}
  g2: {body: {inertia: I2, radius: r2}}
  g3: {body: {inertia: I3, radius: r3}}
connections:
  a: {pin: [ground.A, g1]}
  b: {pin: [ground.B, g2]}
  c: {pin: [ground.C, g3]}
  first: {gear_mesh: [g1, g2]}
  second: {gear_mesh: [g2, g3]}
loads: {drive: {torque: {on: g1, magnitude: T}}}
""",
        {
            "angular acceleration of g1": "T/(I1 + I2*(r1/r2)**2 + I3*(r1/r3)**2)",
            "ratio of angular velocity of g3 to angular velocity of g1": "r1/r3",
            "tooth force of second": "-I3*r1/r3**2*T/(I1 + I2*(r1/r2)**2 + I3*(r1/r3)**2)",
        },
    ),
    # H ch. 16: two gears on the middle shaft, w3/w1 = (r1/R)(r/r3)
    "compound gear": (
        """
parameters: {I1: 0.1 kg m^2, I2: 0.2 kg m^2, I3: 0.3 kg m^2, r1: 0.05 m, R: 0.2 m, r: 0.06 m, r3: 0.3 m, T: 3 N m}
ground: {points: {A: [0, 0], B: [r1 + R, 0], C: [r1 + R + r + r3, 0]}}
bodies:
  g1: {body: {inertia: I1, radius: r1}}
  shaft: {body: {inertia: I2}}
  g3: {body: {inertia: I3, radius: r3}}
connections:
  a: {pin: [ground.A, g1]}
  b: {pin: [ground.B, shaft]}
  c: {pin: [ground.C, g3]}
  first: {gear_mesh: {first: g1, second: shaft, second_radius: R}}
  second: {gear_mesh: {first: shaft, second: g3, first_radius: r}}
loads: {drive: {torque: {on: g1, magnitude: T}}}
""",
        {
            "ratio of angular velocity of g3 to angular velocity of g1": "r1*r/(R*r3)",
            "angular acceleration of g1": "T/(I1 + I2*(r1/R)**2 + I3*(r1*r/(R*r3))**2)",
        },
    ),
    # Lagrange at theta = 0: 4/3 a1 + 1/2 a2 = 3/2 g/L, 1/2 a1 + 1/3 a2 = 1/2 g/L (BJ problem 16.137 type)
    "two hinged rods released from the horizontal": (
        f"""
parameters: {{m: 2 kg, L: 1 m, {G}}}
bodies: {{AB: {{rod: {{mass: m, length: L}}}}, BC: {{rod: {{mass: m, length: L}}}}}}
connections: {{A: {{pin: [ground.A, AB.start]}}, B: {{pin: [AB.end, BC.start]}}}}
{WEIGHT}
measures: {{theta1: angle of AB clockwise, theta2: angle of BC clockwise}}
start: {{theta1: 0, theta2: 0}}
""",
        {
            "acceleration of theta1 at start": "9*g/(7*L)",
            "acceleration of theta2 at start": "-3*g/(7*L)",
            # Newton for both rods: m (L/2 a1) + m (L a1 + L/2 a2) = 2 m g - A
            "vertical reaction of A on AB at start": "m*(2*g - 3*L/2*9*g/(7*L) + L/2*3*g/(7*L))",
        },
    ),
    # Norton eq. 11: at the outer dead centre x'' = -r w^2 (1 + r/l)
    "piston at the dead centre of a driven slider-crank": (
        """
parameters: {m: 2 kg, r: 0.1 m, l: 0.3 m, w: 100 rad/s}
bodies: {crank: {rod: {length: r}}, con: {rod: {length: l}}, piston: {particle: {mass: m}}}
connections:
  main: {pin: [ground.O, crank.start]}
  crankpin: {pin: [crank.end, con.start]}
  wristpin: {pin: [con.end, piston]}
  cylinder: {slider: {body: piston, along: right, through: ground.O}}
  motor: {driver: {measure: angle of crank, follows: w*t}}
start: {}
""",
        {"acceleration of piston along right at start": "-r*w**2*(1 + r/l)", "speed of piston at start": "0"},
    ),
    # Norton ch. 3 (crank shaper): tan(psi) = (d + r sin(theta))/(r cos(theta)), differentiated
    "crank shaper": (
        """
parameters: {r: 0.1 m, d: 0.25 m, J: 0.3 kg m^2, T: 2 N m}
ground: {points: {O: [0, 0], A: [0, -d]}}
bodies: {crank: {rod: {length: r}}, lever: {body: {inertia: J}}}
connections:
  main: {pin: [ground.O, crank.start]}
  pivot: {pin: [ground.A, lever]}
  block: {slot: {pin: crank.end, along: right, on: lever}}
loads: {drive: {torque: {on: crank, magnitude: T}}}
measures: {theta: angle of crank, psi: angle of lever}
start: {theta: 30 deg}
""",
        {
            "degrees of freedom": "1",
            "ratio of angular velocity of lever to angular velocity of crank": "r*(r + d*sin(theta))"
            "/(r**2 + d**2 + 2*r*d*sin(theta))",
        },
    ),
    # BJ sec. 19.3: m L^2/3 theta'' + (m g L/2 + k a^2) theta = 0
    "rod pendulum with a spring": (
        f"""
parameters: {{m: 2 kg, L: 1 m, a: 0.6 m, k: 30 N/m, l: 0.4 m, {G}}}
ground: {{points: {{O: [0, 0], W: [-l, -a]}}}}
bodies: {{rod: {{rod: {{mass: m, length: L}}, points: {{P: [a - L/2, 0]}}}}}}
connections: {{hinge: {{pin: [ground.O, rod.start]}}}}
loads: {{weight: {{gravity: g}}, spring: {{spring: {{first: ground.W, second: rod.P, stiffness: k, length: l}}}}}}
measures: {{theta: angle of rod from down}}
start: {{theta: 0}}
""",
        {"natural frequency": "sqrt((m*g*L/2 + k*a**2)/(m*L**2/3))"},
    ),
    # MK art. 8/5: m L^2/3 theta'' + (k - m g L/2) theta = 0
    "inverted pendulum on a torsional spring": (
        f"""
parameters: {{m: 2 kg, L: 1 m, k: 30 N m, {G}}}
bodies: {{rod: {{rod: {{mass: m, length: L}}}}}}
connections: {{hinge: {{pin: [ground.O, rod.start]}}}}
loads: {{weight: {{gravity: g}}, spring: {{torsional_spring: {{body: rod, stiffness: k, angle: 90 deg}}}}}}
measures: {{theta: angle of rod from up}}
start: {{theta: 0}}
""",
        {"natural frequency": "sqrt((k - m*g*L/2)/(m*L**2/3))"},
    ),
    # a bead at the bottom of a rolling hoop rests at the contact: 2 M R^2 theta'' + m g R theta = 0
    "hoop with a bead rocks": (
        f"""
parameters: {{m: 0.5 kg, M: 1 kg, R: 0.3 m, {G}}}
ground: {{lines: {{floor: {{along: right}}}}}}
bodies:
  hoop: {{ring: {{mass: M, radius: R}}, points: {{P: [0, -R]}}}}
  bead: {{particle: {{mass: m}}}}
connections: {{contact: {{rolling: {{body: hoop, on: floor}}}}, rivet: {{pin: [hoop.P, bead]}}}}
{WEIGHT}
measures: {{theta: angle of hoop}}
start: {{theta: 0}}
""",
        {"natural frequency": "sqrt(m*g/(2*M*R))", "normal force of contact at start": "(M + m)*g"},
    ),
    # MK art. 2/6: r'' = r w^2, r = r0 cosh(w t); N = 2 m w r'
    "bead on a rod that is turned": (
        """
parameters: {m: 0.2 kg, w: 3 rad/s, r0: 0.1 m}
bodies: {rod: {rod: {length: 2 m}}, bead: {particle: {mass: m}}}
connections:
  hinge: {pin: [ground.O, rod.start]}
  motor: {driver: {measure: angle of rod, follows: w*t}}
  sleeve: {slider: {body: bead, along: rod.right, on: rod, through: rod.start}}
measures: {r: travel of bead along rod.right from ground.O}
start: {r: r0, rate(r): 0}
""",
        {
            "acceleration of r": "w**2*r",
            "time when r = 2*r0": "log(2 + sqrt(3))/w",
            "velocity of r when r = 2*r0": "sqrt(3)*r0*w",
            "normal force of sleeve": "2*m*w*rate(r)",
        },
    ),
    # H Statics ch. 6, method of joints: 2 S h/sqrt(a^2 + h^2) = W
    "two bars carry a weight": (
        f"""
parameters: {{m: 10 kg, a: 0.6 m, h: 0.8 m, {G}}}
ground: {{points: {{A: [-a, 0], B: [a, 0]}}}}
bodies: {{C: {{particle: {{mass: m}}, at: [0, -h]}}}}
connections: {{AC: {{link: [ground.A, C]}}, BC: {{link: [ground.B, C]}}}}
{WEIGHT}
""",
        {
            "tension of AC": "m*g*sqrt(a**2 + h**2)/(2*h)",
            "tension of BC": "m*g*sqrt(a**2 + h**2)/(2*h)",
            "degrees of freedom": "0",
        },
    ),
    # H Statics ch. 6: bracket; joint C: S_BC sin = W, so BC pulls W L/h-wise and AC is pressed by W a/h
    "bracket of two bars": (
        f"""
parameters: {{m: 10 kg, a: 0.6 m, h: 0.8 m, {G}}}
ground: {{points: {{A: [0, 0], B: [0, h]}}}}
bodies: {{C: {{particle: {{mass: m}}, at: [a, 0]}}}}
connections: {{AC: {{link: [ground.A, C]}}, BC: {{link: [ground.B, C]}}}}
{WEIGHT}
""",
        {"tension of BC": "m*g*sqrt(a**2 + h**2)/h", "tension of AC": "-m*g*a/h"},
    ),
    # H Statics ch. 5: moments about A
    "beam on a pin and a roller": (
        """
parameters: {L: 4 m, a: 1 m, F: 100 N, Q: 30 N}
ground: {points: {A: [0, 0], B: [L, 0]}}
bodies: {beam: {rod: {length: L}, points: {P: [a - L/2, 0]}, angle: 0}}
connections:
  A: {pin: [ground.A, beam.start]}
  B: {slot: {pin: beam.end, along: right, through: ground.B}}
loads:
  load: {force: {at: beam.P, along: down, magnitude: F}}
  side: {force: {at: beam.end, along: right, magnitude: Q}}
""",
        {
            "reaction of A on beam": ["-Q", "F*(L - a)/L"],
            "vertical reaction of B on beam": "F*a/L",
            "degrees of freedom": "0",
        },
    ),
    # BJ sec. 11.4: x = 4 y; m g - S = m a, 4 S - M g = M a/4
    "block and tackle with four parts": (
        f"""
parameters: {{m: 6 kg, M: 20 kg, R: 0.1 m, {G}}}
ground: {{points: {{A: [0, 0], B: [4*R, 0], C: [7*R, 0]}}}}
bodies:
  weight: {{particle: {{mass: m}}}}
  block: {{rectangle: {{mass: M, width: 4*R, height: R}}, points: {{P: [-2*R, 0], Q: [2*R, 0]}}}}
  p1: {{disk: {{radius: R}}}}
  p2: {{disk: {{radius: R}}}}
  q1: {{disk: {{radius: R}}}}
  q2: {{disk: {{radius: R}}}}
connections:
  a: {{pin: [ground.A, p1]}}
  b: {{pin: [ground.B, p2]}}
  guide: {{slider: {{body: block, along: up}}}}
  p: {{pin: [block.P, q1]}}
  q: {{pin: [block.Q, q2]}}
  rope: {{string: {{path: [weight, over p1, under q1, over p2, under q2, ground.C], leads: [up, down, up, down, up]}}}}
{WEIGHT.replace("weight", "gravity", 1)}
""",
        {
            "acceleration of weight along down": "4*g*(4*m - M)/(16*m + M)",
            "tension of rope at weight": "m*(g - 4*g*(4*m - M)/(16*m + M))",
        },
    ),
    # MK art. 6/4 (stepped drum): (J + m1 R1^2 + m2 R2^2) alpha = (m1 R1 - m2 R2) g
    "stepped pulley": (
        f"""
parameters: {{m1: 6 kg, m2: 2 kg, J: 0.5 kg m^2, R1: 0.2 m, R2: 0.3 m, {G}}}
bodies: {{drum: {{body: {{inertia: J}}}}, a: {{particle: {{mass: m1}}}}, b: {{particle: {{mass: m2}}}}}}
connections:
  axle: {{pin: [ground.O, drum]}}
  left: {{string: {{from: wound on drum radius R1 at left, to: a}}}}
  right_cord: {{string: {{from: wound on drum radius R2 at right, to: b}}}}
{WEIGHT}
""",
        {
            "angular acceleration of drum": "g*(m1*R1 - m2*R2)/(J + m1*R1**2 + m2*R2**2)",
            "tension of left": "m1*(g - R1*g*(m1*R1 - m2*R2)/(J + m1*R1**2 + m2*R2**2))",
            "acceleration of b along up": "R2*g*(m1*R1 - m2*R2)/(J + m1*R1**2 + m2*R2**2)",
        },
    ),
    # MK art. 2/2: the smallest positive root; the ball passes h on the way up and -d on the way down only
    "ball thrown upwards": (
        f"""
parameters: {{m: 1 kg, v0: 10 m/s, h: 2 m, d: 3 m, {G}}}
bodies: {{ball: {{particle: {{mass: m}}}}}}
connections: {{line: {{slider: {{body: ball, along: up}}}}}}
{WEIGHT}
measures: {{y: height of ball}}
start: {{y: 0, rate(y): v0}}
""",
        {
            "time when y = h": "(v0 - sqrt(v0**2 - 2*g*h))/g",
            "time when y = -d": "(v0 + sqrt(v0**2 + 2*g*d))/g",
            "velocity of y when y = h": "sqrt(v0**2 - 2*g*h)",
            "velocity of y when y = -d": "-sqrt(v0**2 + 2*g*d)",
            "time when rate(y) = 0": "v0/g",
            "position of y when rate(y) = 0": "v0**2/(2*g)",
            "time when y = 0": "2*v0/g",
            "velocity of y when y = 0": "-v0",
        },
    ),
    # BJ sec. 19.2: 3/2 m x'' + k x = 0; released at x0, a quarter of the period to the middle
    "disk rolls against a spring": (
        """
parameters: {m: 2 kg, R: 0.1 m, k: 50 N/m, x0: 0.2 m}
ground: {lines: {floor: {along: right}}}
bodies: {roll: {disk: {mass: m, radius: R}}}
connections: {contact: {rolling: {body: roll, on: floor}}}
measures: {x: x of roll}
loads: {spring: {law: {measure: x, force: -k*x}}}
start: {x: x0, rate(x): 0}
""",
        {
            "natural frequency": "sqrt(2*k/(3*m))",
            "time when x = 0": "pi/2*sqrt(3*m/(2*k))",
            "time when x = x0/2": "pi/3*sqrt(3*m/(2*k))",
            "velocity of x when x = 0": "-x0*sqrt(2*k/(3*m))",
            "friction force of contact": "k*x/3",
        },
    ),
    # BJ sec. 16.2 (centre of percussion): the pin feels nothing for d = 2 L/3
    "blow at the centre of percussion": (
        """
parameters: {m: 2 kg, L: 1.2 m, d: 0.5 m, P: 20 N}
bodies: {rod: {rod: {mass: m, length: L}, points: {Q: [d - L/2, 0]}}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {push: {force: {at: rod.Q, along: right, magnitude: P}}}
measures: {theta: angle of rod from down}
start: {theta: 0}
""",
        {
            "horizontal reaction of hinge on rod at start": "P*(3*d/(2*L) - 1)",
            "acceleration of theta at start": "3*P*d/(m*L**2)",
        },
    ),
    # H ch. 13: (mA + mB + M/2) a = mB g
    "block on a table pulled by a weight": (
        f"""
parameters: {{mA: 4 kg, mB: 2 kg, M: 1 kg, R: 0.1 m, {G}}}
bodies: {{A: {{particle: {{mass: mA}}}}, B: {{particle: {{mass: mB}}}}, pulley: {{disk: {{mass: M, radius: R}}}}}}
ground: {{points: {{edge: [1 m, -R]}}}}
connections:
  table: {{slider: {{body: A, along: right}}}}
  axle: {{pin: [ground.edge, pulley]}}
  rope: {{string: {{from: A, over: [pulley], to: B}}}}
{WEIGHT}
measures: {{x: x of A}}
start: {{x: 0}}
""",
        {
            "acceleration of x": "mB*g/(mA + mB + M/2)",
            "tension of rope at A": "mA*mB*g/(mA + mB + M/2)",
            "tension of rope at B": "(mA + M/2)*mB*g/(mA + mB + M/2)",
            "normal force of table": "mA*g",
        },
    ),
    # MK art. 6/5: two disk wheels count with 3/2 of their masses
    "cart on two heavy wheels": (
        """
parameters: {M: 20 kg, m: 3 kg, R: 0.2 m, F: 50 N, b: 1 m}
ground: {lines: {floor: {along: right}}}
bodies:
  cart: {rectangle: {mass: M, width: b, height: 0.1 m}, points: {P: [-b/2, 0], Q: [b/2, 0]}, at: [0, R]}
  w1: {disk: {mass: m, radius: R}}
  w2: {disk: {mass: m, radius: R}}
connections:
  p: {pin: [cart.P, w1]}
  q: {pin: [cart.Q, w2]}
  c1: {rolling: {body: w1, on: floor}}
  c2: {rolling: {body: w2, on: floor}}
loads: {push: {force: {at: cart, along: right, magnitude: F}}}
""",
        {
            "degrees of freedom": "1",
            "acceleration of cart along right": "F/(M + 3*m)",
            "friction force of c1": "-m/2*F/(M + 3*m)",
        },
    ),
    # BJ sample problem 17.4 type, from beta off the vertical: phi'^2 = 3 g (cos(beta) - cos(phi))/L
    "hinged rod falls from near the vertical": (
        f"""
parameters: {{m: 2 kg, L: 1 m, beta: 10 deg, {G}}}
bodies: {{rod: {{rod: {{mass: m, length: L}}}}}}
connections: {{hinge: {{pin: [ground.O, rod.start]}}}}
{WEIGHT}
measures: {{phi: angle of rod from up}}
start: {{phi: beta, rate(phi): 0}}
""",
        {
            "velocity of phi when phi = 90 deg": "sqrt(3*g*cos(beta)/L)",
            "horizontal reaction of hinge on rod when phi = 90 deg": "m*L/2*3*g*cos(beta)/L",
            "vertical reaction of hinge on rod when phi = 90 deg": "m*g/4",
            "kinetic energy when phi = 90 deg": "m*g*L/2*cos(beta)",
        },
    ),
    # BJ sample problem 17.5: v^2 = 2 g h/(1 + 2/5) for the sphere; time from s = h/sin
    "sphere rolls down": (
        f"""
parameters: {{m: 2 kg, R: 0.1 m, alpha: 25 deg, h: 1 m, {G}}}
ground: {{lines: {{slope: {{along: -alpha}}}}}}
bodies: {{ball: {{sphere: {{mass: m, radius: R}}}}}}
connections: {{contact: {{rolling: {{body: ball, on: slope}}}}}}
{WEIGHT}
measures: {{s: travel of ball along slope}}
start: {{s: 0, rate(s): 0}}
""",
        {
            "velocity of s when s = h/sin(alpha)": "sqrt(10*g*h/7)",
            "time when s = h/sin(alpha)": "sqrt(14*h/(5*g))/sin(alpha)",
            "friction force of contact": "-2*m*g*sin(alpha)/7",
        },
    ),
    # BJ sec. 15.2: top, centre and contact of a rolling wheel: 2 v, v, 0, and v^2/R upwards at the contact
    "points of a rolling wheel": (
        """
parameters: {m: 2 kg, R: 0.3 m, v: 2 m/s}
ground: {lines: {floor: {along: right}}}
bodies: {wheel: {disk: {mass: m, radius: R}, points: {top: [0, R], bottom: [0, -R], side: [R, 0]}}}
connections: {contact: {rolling: {body: wheel, on: floor}}}
measures: {x: x of wheel, phi: angle of wheel}
start: {x: 0, phi: 0, rate(x): v}
""",
        {
            "velocity of wheel.top at start": ["2*v", "0"],
            "velocity of wheel.bottom at start": ["0", "0"],
            "speed of wheel.side at start": "sqrt(2)*v",
            "acceleration of wheel.bottom at start": ["0", "v**2/R"],
            "acceleration of wheel.top at start": ["0", "-v**2/R"],
        },
    ),
    # H Statics ch. 3: tan(theta) = F/(m g)
    "pendulum held by a side force": (
        f"""
parameters: {{m: 2 kg, L: 1 m, F: 5 N, {G}}}
bodies: {{bob: {{particle: {{mass: m}}}}}}
connections: {{cord: {{link: [ground.O, bob, L]}}}}
loads: {{weight: {{gravity: g}}, wind: {{force: {{at: bob, along: right, magnitude: F}}}}}}
measures: {{theta: angle of line from ground.O to bob from down}}
start: {{theta: 0}}
""",
        {"equilibrium of theta": "atan(F/(m*g))"},
    ),
    # J w' = T0 (1 - w/w0): w = w0 (1 - exp(-T0 t/(J w0)))
    "motor with a falling characteristic": (
        """
parameters: {J: 0.5 kg m^2, T0: 4 N m, w0: 100 rad/s}
bodies: {rotor: {body: {mass: 1 kg, inertia: J}}}
connections: {axle: {pin: [ground.O, rotor]}}
measures: {theta: angle of rotor}
loads: {motor: {torque: {on: rotor, magnitude: T0*(1 - rate(theta)/w0)}}}
start: {theta: 0, rate(theta): 0}
""",
        {"time when rate(theta) = w0/2": "J*w0*log(2)/T0", "power of motor": "T0*(1 - rate(theta)/w0)*rate(theta)"},
    ),
    # Rao, Mechanical Vibrations, sec. 5.7 (semi-definite system): 0 and sqrt(k (m1 + m2)/(m1 m2))
    "two masses with a spring between them": (
        """
parameters: {m1: 1 kg, m2: 3 kg, k: 100 N/m}
bodies: {A: {particle: {mass: m1}}, B: {particle: {mass: m2}}}
connections: {a: {slider: {body: A, along: right}}, b: {slider: {body: B, along: right}}}
measures: {x1: x of A, x2: x of B}
loads: {spring: {law: {measure: {expression: x2 - x1}, force: -k*(x2 - x1)}}}
start: {x1: 0, x2: 0}
""",
        {
            "natural frequencies": ["0", "sqrt(k*(m1 + m2)/(m1*m2))"],
            "linear momentum along right": "m1*rate(x1) + m2*rate(x2)",
        },
    ),
    # MK art. 6/4 (elevator): (m1 + m2 + J/R^2) a = T/R + (m2 - m1) g
    "elevator with a counterweight": (
        f"""
parameters: {{m1: 500 kg, m2: 400 kg, J: 30 kg m^2, R: 0.5 m, T: 900 N m, h: 10 m, {G}}}
bodies:
  wheel: {{body: {{inertia: J, radius: R}}}}
  cabin: {{particle: {{mass: m1}}}}
  counter: {{particle: {{mass: m2}}}}
connections:
  axle: {{pin: [ground.O, wheel]}}
  rope: {{string: {{from: counter, over: [wheel], to: cabin}}}}
loads: {{weight: {{gravity: g}}, motor: {{torque: {{on: wheel, magnitude: T}}}}}}
measures: {{y: height of cabin}}
start: {{y: 0, rate(y): 0}}
""",
        {
            "acceleration of y": "(T/R + (m2 - m1)*g)/(m1 + m2 + J/R**2)",
            "tension of rope at cabin": "m1*(g + (T/R + (m2 - m1)*g)/(m1 + m2 + J/R**2))",
        },
    ),
    # MK art. 2/4: 2 v0 sin/g back to the ground
    "projectile": (
        f"""
parameters: {{m: 1 kg, v0: 20 m/s, alpha: 40 deg, {G}}}
bodies: {{ball: {{particle: {{mass: m}}}}}}
{WEIGHT}
measures: {{x: x of ball, y: y of ball}}
start: {{x: 0, y: 0, rate(x): v0*cos(alpha), rate(y): v0*sin(alpha)}}
""",
        {
            "time when y = 0": "2*v0*sin(alpha)/g",
            "time when rate(y) = 0": "v0*sin(alpha)/g",
            "time when x = 1 m": "1/(v0*cos(alpha))",
        },
    ),
    # MK art. 2/6: a crane drives its trolley; the load of mass m hangs still in the accelerated frame at tan = a/g
    "pendulum on a driven trolley": (
        f"""
parameters: {{m: 50 kg, L: 4 m, a0: 0.5 m/s^2, {G}}}
bodies: {{trolley: {{particle: {{mass: 10 kg}}}}, hook: {{particle: {{mass: m}}}}}}
connections:
  track: {{slider: {{body: trolley, along: right}}}}
  motor: {{driver: {{measure: x of trolley, follows: a0*t^2/2}}}}
  rope: {{link: [trolley, hook, L]}}
{WEIGHT}
measures: {{theta: angle of line from trolley to hook from down}}
start: {{theta: 0}}
""",
        {
            "acceleration of theta": "-(g*sin(theta) + a0*cos(theta))/L",
            "equilibrium of theta": "-atan(a0/g)",
            "natural frequency about equilibrium": "sqrt(sqrt(a0**2 + g**2)/L)",
        },
    ),
}


@functools.cache
def solved(name: str) -> fb.Solution:
    model, known = PROBLEMS[name]
    return fb.solve(fb.System.from_text(model + "questions:\n" + "".join(f"  - {{find: '{q}'}}\n" for q in known)))


def problems() -> list[object]:
    return [pytest.param(name, question) for name, (_model, known) in PROBLEMS.items() for question in known]


@pytest.mark.parametrize(("name", "question"), problems())
def test_answer_is_the_formula_of_the_textbook(name: str, question: str, agrees: Agree) -> None:
    known = PROBLEMS[name][1]
    agrees(solved(name), f"q{list(known).index(question) + 1}", known[question])


# -- what has no closed form, or no answer ----------------------------------------------------
PENDULUM = f"""
parameters: {{m: 1 kg, L: 1 m, {G}}}
bodies: {{bob: {{particle: {{mass: m}}}}}}
connections: {{rod: {{link: [ground.O, bob, L]}}}}
{WEIGHT}
measures: {{theta: angle of line from ground.O to bob from down}}
start: {{theta: 60 deg, rate(theta): 0}}
"""


def unanswered(model: str, question: str) -> fb.Answer:
    answer = fb.solve(fb.System.from_text(model), question)["q1"]
    assert answer.expression is None
    assert answer.latex is None
    assert answer.evidence is None
    assert answer.reason
    return answer


def test_time_of_a_large_swing_is_an_elliptic_integral() -> None:
    """A quarter of the period is sqrt(L/g) K(sin(theta0/2)), K by the arithmetic-geometric mean."""
    import math

    a, b = 1.0, math.cos(math.radians(30))
    for _ in range(6):
        a, b = (a + b) / 2, math.sqrt(a * b)
    answer = fb.solve(fb.System.from_text(PENDULUM), "time when theta = 0")["q1"]
    assert answer.evidence is not None
    assert answer.value == pytest.approx(math.sqrt(1 / 9.81) * math.pi / (2 * a), rel=1e-12)


def test_height_above_the_top_of_the_flight_is_never_reached() -> None:
    model = PROBLEMS["ball thrown upwards"][0]
    answer = fb.solve(fb.System.from_text(model), "time when y = 2*v0^2/g")["q1"]
    assert answer.expression is None
    assert answer.reason


def test_ball_falls_away_from_a_height_above() -> None:
    model = PROBLEMS["ball thrown upwards"][0].replace("rate(y): v0", "rate(y): -v0")
    assert "never" in unanswered(model, "time when y = h").reason


def test_a_double_pendulum_has_no_first_integral_for_one_angle() -> None:
    model = PROBLEMS["two hinged rods released from the horizontal"][0]
    assert "2 degrees of freedom" in unanswered(model, "velocity of theta1 when theta1 = 90 deg").reason


def test_what_cancels_in_decimals_is_zero() -> None:
    """4 kg 0.3 m = 6 kg 0.2 m, which binary numbers miss by 2e-16 kg m."""
    model = """
parameters: {m1: 4 kg, m2: 6 kg, I: 0.1 kg m^2, R: 0.3 m, r: 0.2 m, g: 9.81 m/s^2}
bodies: {drum: {body: {inertia: I, mass: 1 kg}}, a: {particle: {mass: m1}}, b: {particle: {mass: m2}}}
connections:
  axle: {pin: [ground.O, drum]}
  ra: {string: {path: [wound on drum radius R at left, a]}}
  rb: {string: {path: [wound on drum radius r at right, b]}}
loads: {w: {gravity: g}}
measures: {phi: angle of drum}
questions: [acceleration of phi, tension of ra]
"""
    solution = fb.System.from_text(model).solve()
    assert solution["q1"].value == 0.0
    assert solution["q2"].value == pytest.approx(4 * 9.81)


def test_unstable_position_does_not_oscillate() -> None:
    """The inverted pendulum on a soft spring, k < m g L/2."""
    model = PROBLEMS["inverted pendulum on a torsional spring"][0]
    stiff = fb.solve(fb.System.from_text(model), "natural frequency")["q1"]
    assert any("k" in condition and "g" in condition for condition in stiff.conditions)


def test_tensions_of_a_redundant_hanging_are_said_to_be_not_unique() -> None:
    """Three vertical cords carry one rod in the plane: two equations for the loads, three tensions."""
    model = f"""
parameters: {{m: 1 kg, {G}}}
ground: {{points: {{A: [-1 m, 1 m], B: [0, 1 m], C: [1 m, 1 m]}}}}
bodies: {{rod: {{rod: {{mass: m, length: 2 m}}, at: [0, 0], angle: 0}}}}
connections:
  a: {{link: [ground.A, rod.start]}}
  b: {{link: [ground.B, rod.center]}}
  c: {{link: [ground.C, rod.end]}}
{WEIGHT}
"""
    assert "unique" in unanswered(model, "tension of b at start").reason


def test_a_line_between_places_welded_together_has_no_direction() -> None:
    """0/0 in every pose: no angle, and no velocity of one."""
    text = """
ground: {points: {A: [0, 0]}}
bodies:
  a: {rod: {length: 1 m, mass: 1 kg}, at: {start: [0, 0]}}
  b: {rod: {length: 2 m, mass: 1 kg}, at: {start: [1 m, 0]}}
connections: {O: {pin: [ground.A, a.start]}, W: {weld: [a.end, b.start]}}
measures: {th: angle of a, w: angle of line from a.end to b.start}
questions: [velocity of w]
"""
    (answer,) = fb.System.from_text(text).solve().answers
    assert answer.reason == "two points coincide, so the line between them has no direction"


def test_a_stop_that_is_passed_at_the_start_is_told_without_an_event() -> None:
    """The angle between two directions of the ground is 180 deg - 180 deg = 0, below the least that the stop allows."""
    text = """
ground: {lines: {floor: {along: 180 deg}}}
bodies: {p: {particle: {mass: 10 kg}, near: {at: [-1 m, 2 m]}}}
connections: {c0: {stop: {measure: angle between left and floor, min: 1e-12, restitution: 0.5}}}
loads: {weight: {gravity: 9.81 m/s^2}}
questions: [kinetic energy]
"""
    (answer,) = fb.System.from_text(text).solve().answers
    assert "''" not in answer.reason
    assert answer.reason
