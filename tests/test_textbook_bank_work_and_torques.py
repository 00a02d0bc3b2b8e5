"""Problems of the families of first courses in dynamics, formulas first: each with the formula that follows by hand."""

from __future__ import annotations

import pytest

from posed import is_formula

DOUBLE_INCLINE = """
parameters: {m1: 8 kg, m2: 3 kg, alpha: 40 deg, beta: 25 deg, a: 1 m, b: 2 m, d: 0.5 m, g: 9.81 m/s^2}
ground:
  points: {P: [0, 0]}
  lines: {left: {along: [-cos(alpha), -sin(alpha)], through: [0, 0]}}
bodies:
  A: {particle: {mass: m1}, at: [-a*cos(alpha), -a*sin(alpha)]}
  B: {particle: {mass: m2}, at: [b*cos(beta), -b*sin(beta)]}
connections:
  sl: {slider: {body: A, along: [-cos(alpha), -sin(alpha)], through: ground.P}}
  sr: {slider: {body: B, along: [cos(beta), -sin(beta)], through: ground.P}}
  rope: {string: {from: A, over: [ground.P], to: B}}
loads: {weight: {gravity: g}}
measures: {s: travel of A along ground.left}
"""
BAR_ON_ONE_STRING = """
parameters: {m: 4 kg, L: 1.2 m, h: 0.6 m, g: 9.81 m/s^2}
ground: {points: {A: [0, h]}}
bodies: {bar: {rod: {mass: m, length: L}, at: [L/2, 0], angle: 0}}
connections: {rope: {string: {from: ground.A, to: bar.start}}}
loads: {weight: {gravity: g}}
"""
RACK_UP_A_SLOPE = """
parameters: {m: 12 kg, I: 0.05 kg m^2, r: 0.08 m, M: 9 N m, alpha: 30 deg, d: 0.4 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}, lines: {slope: {along: alpha, through: [-r*sin(alpha), r*cos(alpha)]}}}
bodies:
  pinion: {body: {mass: 2 kg, inertia: I, radius: r}, at: [0, 0]}
  rack: {rectangle: {mass: m, width: 1 m, height: 0.04 m}, at: [-r*sin(alpha), r*cos(alpha)], angle: alpha}
connections:
  axle: {pin: [ground.O, pinion]}
  guide: {slider: {body: rack, along: alpha}}
  teeth: {rack_and_pinion: {pinion: pinion, rack: rack}}
loads: {weight: {gravity: g}, drive: {torque: {on: pinion, magnitude: -M}}}
measures: {s: travel of rack along ground.slope}
start: {s: 0, rate(s): 0}
"""
SPRUNG_BALANCE = """
parameters: {m: 3 kg, L: 1 m, k: 400 N/m, c: 12 N s/m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {bar: {rod: {mass: m, length: L}, at: [0, 0], angle: 0}}
connections: {O: {pin: [ground.O, bar.center]}}
measures: {phi: angle of bar, u: y of bar.start, w: y of bar.end}
loads:
  weight: {gravity: g}
  s1: {law: {measure: u, force: -k*u}}
  s2: {law: {measure: w, force: -k*w}}
  dash: {law: {measure: w, force: -c*rate(w)}}
start: {phi: 0, rate(phi): 0}
"""
ELEVATOR_WITH_COUNTERWEIGHT = """
parameters: {m: 900 kg, mc: 700 kg, I: 40 kg m^2, R: 0.4 m, M: 1.2 kN m, h: 3 m, h0: 8 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  sheave: {body: {mass: 50 kg, inertia: I, radius: R}, at: [0, 0]}
  cabin: {particle: {mass: m}, at: [R, -h0]}
  weight: {particle: {mass: mc}, at: [-R, -2 m]}
connections:
  O: {pin: [ground.O, sheave]}
  rope: {string: {from: cabin, over: [sheave], to: weight}}
  g1: {slider: {body: cabin, along: up}}
  g2: {slider: {body: weight, along: up}}
loads: {gravity: {gravity: g}, motor: {torque: {on: sheave, magnitude: M}}}
measures: {y: y of cabin}
"""
POLAR_ROBOT = """
parameters: {m: 6 kg, I: 2 kg m^2, r0: 0.4 m, u: 0.5 m/s, w: 2 rad/s, t1: 0.6 s}
ground: {points: {O: [0, 0]}}
bodies:
  arm: {body: {mass: 5 kg, inertia: I}, at: [0, 0], angle: 0}
  tool: {particle: {mass: m}, at: [r0, 0]}
connections:
  O: {pin: [ground.O, arm]}
  rail: {slot: {pin: tool, on: arm, along: arm.x}}
  turn: {driver: {measure: phi, follows: w*t}}
  push: {driver: {measure: s, follows: r0 + u*t}}
measures: {phi: angle of arm, s: travel of tool along arm.x from ground.O}
"""
TWO_LINK_ARM_HOLDS = """
parameters:
  {m1: 8 kg, m2: 5 kg, L1: 0.7 m, L2: 0.5 m, W: 60 N, a1: 50 deg, b1: {value: -30 deg, sign: any}, C: 40 N m,
  g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {upper: {rod: {mass: m1, length: L1}}, lower: {rod: {mass: m2, length: L2}}}
connections:
  O: {pin: [ground.O, upper.start]}
  E: {pin: [upper.end, lower.start]}
  shoulder: {driver: {measure: a, follows: a1}}
  elbow: {driver: {measure: e, follows: b1}}
loads: {weight: {gravity: g}, load: {force: {at: lower.end, along: down, magnitude: W}}}
measures: {a: angle of upper, b: angle of lower, e: {expression: b - a}}
"""
BLOCK_DOWN_ONTO_A_SPRING = """
parameters: {m: 5 kg, mu: 0.2, alpha: 35 deg, k: 900 N/m, d: 1.5 m, l0: 0.5 m, g: 9.81 m/s^2}
ground:
  points: {W: [(d+l0)*cos(alpha), -(d+l0)*sin(alpha)]}
  lines: {slope: {along: -alpha, through: [0, 0]}}
bodies: {block: {particle: {mass: m}, at: [0, 0]}}
connections: {bed: {contact: {between: [block, ground.slope], friction: mu}}}
loads:
  weight: {gravity: g}
  spring: {spring: {first: ground.W, second: block, stiffness: k, length: l0, only: compressed}}
measures: {s: travel of block along ground.slope}
start: {s: 0, rate(s): 0}
"""
SEISMOMETER = """
parameters: {m: 0.5 kg, k: 20 N/m, c: 1.5 N s/m, Y: 2 mm, Om: 12 rad/s}
bodies:
  frame: {particle: {mass: 2 kg}}
  mass: {particle: {mass: m}}
connections:
  g1: {slider: {body: frame, along: up}}
  g2: {slider: {body: mass, along: up}}
  quake: {driver: {measure: y, follows: Y*sin(Om*t)}}
measures: {x: y of mass, y: y of frame, z: {expression: x - y}}
loads: {spring: {law: {measure: z, force: -k*z}}, dash: {law: {measure: z, force: -c*rate(z)}}}
"""
GEARED_TORSION = """
parameters: {I1: 0.4 kg m^2, I2: 0.9 kg m^2, r1: 0.1 m, r2: 0.25 m, k: 600 N m, M: 5 N m}
ground: {points: {A: [0, 0], B: [r1+r2, 0]}}
bodies:
  rotor: {body: {mass: 3 kg, inertia: I1}, at: [0, 0]}
  gear1: {body: {mass: 0, radius: r1}, at: [0, 0]}
  gear2: {body: {mass: 6 kg, inertia: I2, radius: r2}, at: [r1+r2, 0]}
connections:
  a: {pin: [ground.A, rotor]}
  b: {pin: [ground.A, gear1]}
  c: {pin: [ground.B, gear2]}
  teeth: {gear_mesh: [gear1, gear2]}
measures: {p: angle of rotor, q: angle of gear1, e: {expression: p - q}}
loads: {shaft: {law: {measure: e, force: -k*e}}, drive: {torque: {on: rotor, magnitude: M}}}
start: {p: 0, q: 0, rate(p): 0, rate(q): 0}
"""
STACK_WITH_A_ROPE = """
parameters: {mA: 10 kg, mB: 4 kg, mu1: 0.2, mu2: 0.3, F: 90 N, d: 0.3 m, hA: 0.2 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right, through: [0, 0]}}}
bodies:
  A:
    rectangle: {mass: mA, width: 2 m, height: hA}
    at: [0, hA/2]
    angle: 0
    lines: {top: {along: right, through: [0, hA/2]}}
  B: {particle: {mass: mB}, at: [0, hA]}
connections:
  floor: {contact: {between: [A, ground.floor], friction: mu1}}
  top: {contact: {between: [B, A.top], friction: mu2}}
  rope: {constraint: xA + xB}
loads: {weight: {gravity: g}, pull: {force: {at: A, along: right, magnitude: F}}}
measures: {xA: x of A, xB: x of B}
"""
BEAD_ON_A_LEANING_ROD = """
space: {up: z}
parameters: {m: 0.2 kg, beta: 35 deg, w: 6 rad/s, h: 0.5 m, v0: 0.4 m/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0, 0]}}
bodies: {bead: {particle: {mass: m}}}
connections:
  rod: {constraint: rho - z*tan(beta)}
  motor: {driver: {measure: phi, follows: w*t}}
loads: {weight: {gravity: g}}
measures: {rho: distance of bead from the z axis, phi: angle of line from ground.O to bead, z: height of bead}
start: {z: h, rate(z): v0}
"""
ROLLER_ON_A_TRUCK = """
parameters: {m: 40 kg, R: 0.3 m, a0: 2 m/s^2, mu: 0.4, M: 2 Mg, g: 9.81 m/s^2}
bodies:
  truck:
    rectangle: {mass: M, width: 5 m, height: 0.4 m}
    at: [0, 0]
    angle: 0
    lines: {bed: {through: [0, 0.2 m], along: right}}
  roller: {disk: {mass: m, radius: R}, at: [1 m, 0.2 m + R]}
connections:
  track: {slider: {body: truck, along: right}}
  motor: {driver: {measure: x of truck, follows: a0*t^2/2}}
  bed: {contact: {between: [roller, truck.bed], friction: mu}}
loads: {weight: {gravity: g}}
"""
SPINNING_DISK_ON_A_SLOPE = """
parameters: {m: 3 kg, R: 0.2 m, mu: 0.5, alpha: 15 deg, w0: 40 rad/s, g: 9.81 m/s^2}
ground: {lines: {slope: {along: alpha, through: [0, 0]}}}
bodies: {disk: {disk: {mass: m, radius: R}, at: [-R*sin(alpha), R*cos(alpha)], angular_velocity: -w0}}
connections: {touch: {contact: {between: [disk, ground.slope], friction: mu}}}
loads: {weight: {gravity: g}}
measures: {s: travel of disk along ground.slope}
start: {s: 0, rate(s): 0}
"""
COLLAR_DOWN_A_ROD = """
parameters: {m: 4 kg, k: 150 N/m, l0: 0.2 m, b: 0.4 m, h: 0.3 m, v1: 1.5 m/s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], B: [b, 0]}}
bodies: {collar: {particle: {mass: m}, at: [b, 0]}}
connections: {guide: {slider: {body: collar, along: up, through: ground.B}}}
loads: {weight: {gravity: g}, spring: {spring: {first: ground.O, second: collar, stiffness: k, length: l0}}}
measures: {y: y of collar}
start: {y: 0, rate(y): 0}
"""
PENDULUM_IN_A_BRAKED_CAR = """
parameters: {m: 2 kg, L: 0.9 m, a: 4 m/s^2, v0: 20 m/s, g: 9.81 m/s^2}
bodies:
  car: {particle: {mass: 1 Mg}, at: [0, 0]}
  bob: {particle: {mass: m}}
connections:
  road: {slider: {body: car, along: right}}
  brakes: {driver: {measure: x of car, follows: v0*t - a*t^2/2}}
  rope: {link: [car, bob, L]}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from car to bob from down}
start: {theta: 0, rate(theta): 0}
"""
TRAILER = """
parameters: {m: 800 kg, I: 700 kg m^2, L: 3 m, b: 0.3 m, h: 0.9 m, k: 0.4 m, a: 1.5 m/s^2, g: 9.81 m/s^2}
bodies:
  trailer: {body: {mass: m, inertia: I}, at: [0, h], angle: 0, points: {hitch: [L-b, k-h], wheel: [-b, -h]}}
connections:
  hitch: {slot: {pin: trailer.hitch, along: right}}
  wheel: {slot: {pin: trailer.wheel, along: right}}
  car: {driver: {measure: x of trailer.hitch, follows: L - b + a*t^2/2}}
loads: {weight: {gravity: g}}
"""
STEPPED_PULLEY = """
parameters: {m1: 10 kg, m2: 15 kg, I: 0.3 kg m^2, R: 0.3 m, r: 0.15 m, h: 2 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  drum: {body: {mass: 8 kg, inertia: I}, at: [0, 0]}
  A: {particle: {mass: m1}, at: [-R, 0]}
  B: {particle: {mass: m2}, at: [r, 0]}
connections:
  O: {pin: [ground.O, drum]}
  ga: {slider: {body: A, along: up}}
  gb: {slider: {body: B, along: up}}
  ra: {constraint: y1 + R*phi}
  rb: {constraint: y2 - r*phi}
loads: {weight: {gravity: g}}
measures: {y1: y of A, y2: y of B, phi: angle of drum}
start: {phi: 0, rate(phi): 0}
"""
BELL_CRANK = """
parameters: {m: 2 kg, I: 0.01 kg m^2, a: 0.4 m, b: 0.25 m, k: 500 N/m, c: 10 N s/m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {crank: {body: {mass: m, inertia: I}, at: [a, 0], angle: 0, points: {O: [-a, 0], P: [-a, b]}}}
connections: {O: {pin: [ground.O, crank.O]}}
measures: {phi: angle of crank, u: x of crank.P}
loads:
  weight: {gravity: g}
  spring: {law: {measure: u, force: -k*u - m*g*a/b}}
  dash: {law: {measure: u, force: -c*rate(u)}}
start: {phi: 0, rate(phi): 0}
"""
MAN_HOISTS_HIMSELF = """
parameters: {m: 75 kg, M: 25 kg, T: 550 N, h: 2 m, g: 9.81 m/s^2}
bodies:
  seat:
    rectangle: {mass: M, width: 1 m, height: 0.2 m}
    at: [0, 0]
    angle: 0
    lines: {top: {along: right, through: [0, 0.1 m]}}
  man: {particle: {mass: m}, at: [0, 0.1 m]}
connections:
  g1: {slider: {body: seat, along: up}}
  g2: {slider: {body: man, along: up}}
  stand: {contact: {between: [man, seat.top]}}
loads:
  weight: {gravity: g}
  hands: {force: {at: man, along: up, magnitude: T}}
  rope: {force: {at: seat, along: up, magnitude: T}}
measures: {y: y of seat}
start: {y: 0, rate(y): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Hibbeler, Dynamics, ch. 13: m1 and m2 along their slopes, one tension
        (DOUBLE_INCLINE, "acceleration of s", "g*(m1*sin(alpha) - m2*sin(beta))/(m1+m2)"),
        (DOUBLE_INCLINE, "tension of rope", "m1*m2*g*(sin(alpha)+sin(beta))/(m1+m2)"),
        (DOUBLE_INCLINE, "value of m2 for which acceleration of s = 0", "m1*sin(alpha)/sin(beta)"),
        (DOUBLE_INCLINE, "speed of B when s has changed by d", "sqrt(2*d*g*(m1*sin(alpha) - m2*sin(beta))/(m1+m2))"),
        # Meriam & Kraige, Dynamics, ch. 6: the second string has been cut; T = m L w'/6
        (BAR_ON_ONE_STRING, "tension of rope at start", "m*g/4"),
        (BAR_ON_ONE_STRING, "angular acceleration of bar at start", "-3*g/(2*L)"),
        (BAR_ON_ONE_STRING, "acceleration of bar.end along down at start", "3*g/2"),
        (BAR_ON_ONE_STRING, "acceleration of bar along down at start", "3*g/4"),
        # Beer & Johnston, Dynamics, ch. 16: the inertia I/r^2 goes with the rack
        (RACK_UP_A_SLOPE, "acceleration of s", "(M/r - m*g*sin(alpha))/(m + I/r^2)"),
        (RACK_UP_A_SLOPE, "value of M for which acceleration of s = 0", "m*g*r*sin(alpha)"),
        (RACK_UP_A_SLOPE, "time when s = d", "sqrt(2*d/((M/r - m*g*sin(alpha))/(m + I/r^2)))"),
        (RACK_UP_A_SLOPE, "power of drive when s = d", "M/r*sqrt(2*d*(M/r - m*g*sin(alpha))/(m + I/r^2))"),
        # Rao, Mechanical Vibrations, ch. 2: I = m L^2/12, stiffness k L^2/2, damping c L^2/4
        (SPRUNG_BALANCE, "natural frequency", "sqrt(6*k/m)"),
        (SPRUNG_BALANCE, "damping ratio", "c*sqrt(6)/(4*sqrt(k*m))"),
        (SPRUNG_BALANCE, "value of c for which damping ratio = 1", "4*sqrt(k*m/6)"),
        (SPRUNG_BALANCE, "damped natural frequency", "sqrt(6*k/m - (3*c/(2*m))^2)"),
        # Hibbeler, Dynamics, ch. 17: what hangs on both sides and I/R^2 move together
        (ELEVATOR_WITH_COUNTERWEIGHT, "acceleration of y", "(M/R + (mc - m)*g)/(m + mc + I/R^2)"),
        (ELEVATOR_WITH_COUNTERWEIGHT, "tension of rope at cabin", "m*(g + (M/R + (mc - m)*g)/(m + mc + I/R^2))"),
        (ELEVATOR_WITH_COUNTERWEIGHT, "value of M for which acceleration of y = 0", "(m - mc)*g*R"),
        (
            ELEVATOR_WITH_COUNTERWEIGHT,
            "speed of cabin when y has changed by h",
            "sqrt(2*h*(M/R + (mc - m)*g)/(m + mc + I/R^2))",
        ),
        # Meriam & Kraige, Dynamics, ch. 2: a_r = -r w^2, a_phi = 2 u w
        (POLAR_ROBOT, "driving torque of turn at t = t1", "2*m*u*w*(r0+u*t1)"),
        (POLAR_ROBOT, "driving force of push at t = t1", "-m*w^2*(r0+u*t1)"),
        (POLAR_ROBOT, "speed of tool at t = t1", "sqrt(u^2+w^2*(r0+u*t1)^2)"),
        (POLAR_ROBOT, "size of acceleration of tool at t = t1", "sqrt(w^4*(r0+u*t1)^2+4*u^2*w^2)"),
        # Gross, Hauger et al., Technische Mechanik 1, ch. 5: moments about the elbow and about the shoulder
        (TWO_LINK_ARM_HOLDS, "driving torque of elbow", "(m2*g/2+W)*L2*cos(a1+b1)"),
        (TWO_LINK_ARM_HOLDS, "driving torque of shoulder", "(m1*g/2+m2*g+W)*L1*cos(a1) + (m2*g/2+W)*L2*cos(a1+b1)"),
        (TWO_LINK_ARM_HOLDS, "size of reaction of E", "m2*g+W"),
        (TWO_LINK_ARM_HOLDS, "value of W for which driving torque of elbow is C", "C/(L2*cos(a1+b1)) - m2*g/2"),
        # Hibbeler, Dynamics, ch. 14: with A = m g (sin - mu cos), A (d + x) = k x^2/2
        (
            BLOCK_DOWN_ONTO_A_SPRING,
            "greatest s",
            "d + (m*g*(sin(alpha)-mu*cos(alpha)) + sqrt((m*g*(sin(alpha)-mu*cos(alpha)))^2 +"
            " 2*k*d*m*g*(sin(alpha)-mu*cos(alpha))))/k",
        ),
        (BLOCK_DOWN_ONTO_A_SPRING, "speed of block when s = d", "sqrt(2*(m*g*(sin(alpha) - mu*cos(alpha)))*d/m)"),
        # Rao, Mechanical Vibrations, ch. 3 and 10: m z'' + c z' + k z = m Y Om^2 sin(Om t)
        (SEISMOMETER, "steady amplitude of z", "m*Om^2*Y/sqrt((k - m*Om^2)^2 + c^2*Om^2)"),
        (SEISMOMETER, "steady amplitude of x", "Y*sqrt(k^2+c^2*Om^2)/sqrt((k - m*Om^2)^2 + c^2*Om^2)"),
        (SEISMOMETER, "natural frequency", "sqrt(k/m)"),
        (SEISMOMETER, "damping ratio", "c/(2*sqrt(k*m))"),
        # Thomson & Dahleh, Theory of Vibration, ch. 5: behind the mesh there is I2 (r1/r2)^2
        (GEARED_TORSION, "second natural frequency", "sqrt(k*(1/I1 + r2^2/(I2*r1^2)))"),
        (GEARED_TORSION, "amplitude ratio of p to q in the second mode", "-I2*r1^2/(r2^2*I1)"),
        (GEARED_TORSION, "acceleration of p at start", "M/I1"),
        (GEARED_TORSION, "ratio of angular velocity of gear1 to angular velocity of gear2", "-r2/r1"),
        # Beer & Johnston, Dynamics, ch. 12: the rope moves both alike against each other
        (STACK_WITH_A_ROPE, "acceleration of xA at start", "(F - 2*mu2*mB*g - mu1*(mA+mB)*g)/(mA+mB)"),
        (STACK_WITH_A_ROPE, "largest F so that it stays at rest", "mu1*(mA+mB)*g+2*mu2*mB*g"),
        (STACK_WITH_A_ROPE, "normal force of floor at start", "(mA+mB)*g"),
        (STACK_WITH_A_ROPE, "speed of A when xA = d", "sqrt(2*d*(F - 2*mu2*mB*g - mu1*(mA+mB)*g)/(mA+mB))"),
        # Goldstein, Poole & Safko, Classical Mechanics, ch. 1: z'' = w^2 sin^2 z - g cos^2
        (BEAD_ON_A_LEANING_ROD, "acceleration of z at start", "w^2*sin(beta)^2*h - g*cos(beta)^2"),
        (BEAD_ON_A_LEANING_ROD, "value of w for which acceleration of z at start = 0", "sqrt(g/h)/tan(beta)"),
        # Meriam & Kraige, Dynamics, ch. 6: f R = m R^2/2 (a0 - a)/R, f = m a
        (ROLLER_ON_A_TRUCK, "acceleration of roller along right at start", "a0/3"),
        (ROLLER_ON_A_TRUCK, "angular acceleration of roller at start", "2*a0/(3*R)"),
        (ROLLER_ON_A_TRUCK, "friction force of bed at start", "m*a0/3"),
        (ROLLER_ON_A_TRUCK, "least mu so that roller rolls without slipping", "a0/(3*g)"),
        # Gross, Hauger et al., Technische Mechanik 3, ch. 3: a = g (mu cos - sin), w' = -2 mu g cos/R
        (SPINNING_DISK_ON_A_SLOPE, "acceleration of s at start", "(g*(mu*cos(alpha) - sin(alpha)))"),
        (SPINNING_DISK_ON_A_SLOPE, "time when rolling begins", "(R*w0/(g*(3*mu*cos(alpha) - sin(alpha))))"),
        (
            SPINNING_DISK_ON_A_SLOPE,
            "speed of disk when rolling begins",
            "(g*(mu*cos(alpha) - sin(alpha)))*(R*w0/(g*(3*mu*cos(alpha) - sin(alpha))))",
        ),
        (
            SPINNING_DISK_ON_A_SLOPE,
            "s when rolling begins",
            "(g*(mu*cos(alpha) - sin(alpha)))*(R*w0/(g*(3*mu*cos(alpha) - sin(alpha))))^2/2",
        ),
        # Hibbeler, Dynamics, ch. 14: energy; the spring is sqrt(b^2 + h^2) long
        (COLLAR_DOWN_A_ROD, "speed of collar when y = -h", "sqrt(2*g*h + k/m*((b-l0)^2 - (sqrt(b^2+h^2)-l0)^2))"),
        (COLLAR_DOWN_A_ROD, "size of reaction of guide when y = -h", "k*(sqrt(b^2+h^2)-l0)*b/sqrt(b^2+h^2)"),
        (COLLAR_DOWN_A_ROD, "acceleration of y when y = -h", "-g + k*(sqrt(b^2+h^2)-l0)*h/(sqrt(b^2+h^2)*m)"),
        (
            COLLAR_DOWN_A_ROD,
            "value of k for which speed of collar when y = -h is v1",
            "m*(2*g*h - v1^2)/((sqrt(b^2+h^2)-l0)^2 - (b-l0)^2)",
        ),
        # Morin, Introduction to Classical Mechanics, ch. 10: as with the weight sqrt(g^2 + a^2), aslant
        (PENDULUM_IN_A_BRAKED_CAR, "theta in equilibrium", "atan(a/g)"),
        (PENDULUM_IN_A_BRAKED_CAR, "period of small oscillations", "2*pi*sqrt(L/sqrt(a^2+g^2))"),
        (PENDULUM_IN_A_BRAKED_CAR, "greatest theta", "2*atan(a/g)"),
        (PENDULUM_IN_A_BRAKED_CAR, "tension of rope in equilibrium", "m*sqrt(a^2+g^2)"),
        # Meriam & Kraige, Dynamics, ch. 6: moments about the point on the road, with m a at the height h
        (TRAILER, "driving force of car", "m*a"),
        (TRAILER, "normal force of hitch", "(m*(g*b + a*(k - h))/L)"),
        (TRAILER, "normal force of wheel", "m*g - (m*(g*b + a*(k - h))/L)"),
        (TRAILER, "value of a for which normal force of hitch = 0", "g*b/(h-k)"),
        # Beer & Johnston, Dynamics, ch. 16: m1 R - m2 r turns I + m1 R^2 + m2 r^2
        (STEPPED_PULLEY, "angular acceleration of drum", "((m1*R - m2*r)*g/(I + m1*R^2 + m2*r^2))"),
        (STEPPED_PULLEY, "value of m2 for which angular acceleration of drum = 0", "m1*R/r"),
        (STEPPED_PULLEY, "speed of A when y1 = -h", "sqrt(2*R*h*((m1*R - m2*r)*g/(I + m1*R^2 + m2*r^2)))"),
        (STEPPED_PULLEY, "kinetic energy when y1 = -h", "(m1 - m2*r/R)*g*h"),
        # Den Hartog, Mechanical Vibrations, ch. 2: the weight on a level arm has no part in the stiffness k b^2
        (BELL_CRANK, "natural frequency", "b*sqrt(k/(I+m*a^2))"),
        (BELL_CRANK, "damping ratio", "(c*b/(2*sqrt(k*(I+m*a^2))))"),
        (BELL_CRANK, "size of reaction of O in equilibrium", "sqrt((m*g)^2+(m*g*a/b)^2)"),
        (BELL_CRANK, "logarithmic decrement", "2*pi*(c*b/(2*sqrt(k*(I+m*a^2))))/sqrt(1-(c*b/(2*sqrt(k*(I+m*a^2))))^2)"),
        # Hibbeler, Dynamics, ch. 13: the rope pulls twice, at the man and at the seat
        (MAN_HOISTS_HIMSELF, "acceleration of y", "2*T/(m+M) - g"),
        (MAN_HOISTS_HIMSELF, "value of T for which acceleration of y = 0", "(m+M)*g/2"),
        (MAN_HOISTS_HIMSELF, "time when y = h", "sqrt(2*h/(2*T/(m+M) - g))"),
        (MAN_HOISTS_HIMSELF, "normal force of stand", "m*(2*T/(m+M)) - T"),
    ],
)
def test_a_problem_of_a_textbook_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)
