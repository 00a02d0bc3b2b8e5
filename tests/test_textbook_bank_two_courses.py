"""Problems from the whole of a first course and a second: each with the formula that follows by hand."""

from __future__ import annotations

import pytest

from posed import is_formula

PLANE_SEEN_FROM_THE_GROUND = """
parameters: {m: 2 Mg, h: 3 km, v: 200 m/s, theta1: 60 deg, b: 4 km}
ground: {points: {O: [0, 0]}}
bodies: {plane: {particle: {mass: m}, at: [-b, h], velocity: [v, 0]}}
measures: {theta: angle of line from ground.O to plane, r: distance from ground.O to plane}
"""
TWO_SHIPS = """
parameters: {m: 1 Mg, a: 3 km, b: 2 km, vA: 8 m/s, vB: 5 m/s}
bodies:
  A: {particle: {mass: m}, at: [-a, 0], velocity: [vA, 0]}
  B: {particle: {mass: m}, at: [0, -b], velocity: [0, vB]}
measures: {d: distance from A to B}
"""
GEARED_HOIST = """
parameters:
  {M: 30 N m, I1: 0.02 kg m^2, I2: 0.5 kg m^2, r1: 0.05 m, r2: 0.2 m, R: 0.1 m,
  m: 60 kg, g: 9.81 m/s^2, h: 4 m, y0: {value: -2 m, sign: any}}
ground: {points: {A: [0, 0], B: [r1+r2, 0]}}
bodies:
  pinion: {body: {mass: 2 kg, inertia: I1, radius: r1}, at: [0, 0]}
  drum: {body: {mass: 10 kg, inertia: I2, radius: r2}, at: [r1+r2, 0]}
  cage: {particle: {mass: m}, at: [r1+r2-R, -2 m]}
connections:
  a: {pin: [ground.A, pinion]}
  b: {pin: [ground.B, drum]}
  teeth: {gear_mesh: [pinion, drum]}
  guide: {slider: {body: cage, along: up}}
  rope: {constraint: y - y0 + R*phi}
measures: {y: y of cage, phi: angle of drum}
loads: {weight: {gravity: g}, motor: {torque: {on: pinion, magnitude: M}}}
start: {y: -2 m, rate(y): 0}
"""
CYLINDER_IN_A_CORNER = """
parameters: {m: 20 kg, r: 0.3 m, mu: 0.3, C: 10 N m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}, wall: {along: down, through: [0, 0]}}}
bodies: {drum: {disk: {mass: m, radius: r}, at: [r, r]}}
connections:
  floor: {contact: {between: [drum, ground.floor], friction: mu}}
  wall: {contact: {between: [drum, ground.wall], friction: mu}}
loads: {weight: {gravity: g}, couple: {torque: {on: drum, magnitude: C}}}
"""
TWO_HANGING_LINKS_PULLED = """
parameters: {m: 3 kg, L: 0.8 m, F: 20 N, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {up: {rod: {mass: m, length: L}}, low: {rod: {mass: m, length: L}}}
connections: {A: {pin: [ground.O, up.start]}, B: {pin: [up.end, low.start]}}
loads: {weight: {gravity: g}, pull: {force: {at: low.end, along: right, magnitude: F}}}
measures: {t1: angle of up from down, t2: angle of low from down}
start: {t1: 20 deg, t2: 40 deg}
"""
BEAD_ON_A_TIGHT_STRING = """
parameters: {m: 0.1 kg, T: 50 N, a: 0.3 m, b: 0.5 m, y0: 2 cm}
ground: {points: {A: [-a, 0], B: [b, 0]}}
bodies: {bead: {particle: {mass: m}}}
connections: {guide: {slider: {body: bead, along: up}}}
loads:
  left: {tensioned_string: {from: ground.A, to: bead, tension: T}}
  right: {tensioned_string: {from: ground.B, to: bead, tension: T}}
measures: {y: y of bead}
start: {y: y0, rate(y): 0}
"""
HOOP_WITH_TWO_BEADS = """
parameters: {m: 0.2 kg, M: 0.5 kg, R: 0.4 m, theta0: 5 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right, through: [0, 0]}}}
bodies:
  hoop: {ring: {mass: M, radius: R}, at: [0, R]}
  left: {particle: {mass: m}}
  right: {particle: {mass: m}}
connections:
  guide: {slider: {body: hoop, along: up}}
  floor: {contact: {between: [hoop, ground.floor]}}
  wl: {link: [hoop.center, left, R]}
  wr: {link: [hoop.center, right, R]}
  same: {constraint: theta - phi}
loads: {weight: {gravity: g}}
measures:
  theta: angle of line from hoop.center to right from up clockwise
  phi: angle of line from hoop.center to left from up
start: {theta: theta0, rate(theta): 0}
"""
BEAD_ON_A_HELIX = """
space: {up: z}
parameters: {m: 0.1 kg, R: 0.2 m, p: 0.1 m, n: 3, g: 9.81 m/s^2}
bodies: {bead: {particle: {mass: m}}}
ground: {points: {O: [0, 0, 0]}}
connections:
  tube: {constraint: rho - R}
  wire: {constraint: z + p*phi/(2*pi)}
loads: {weight: {gravity: g}}
measures: {rho: distance of bead from the z axis, phi: angle of line from ground.O to bead, z: height of bead}
start: {phi: 0, rate(phi): 0, rho: R}
"""
BOOM_ON_TWO_CABLES = """
space: {up: z}
parameters: {m: 12 kg, W: 400 N, L: 2 m, c: 1 m, h: 1.5 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0, 0], C: [0, c, h], D: [0, -c, h]}}
bodies: {boom: {rod: {mass: m, length: L}, at: [L/2, 0, 0]}}
connections:
  socket: {spherical: [ground.O, boom.start]}
  left: {link: [ground.C, boom.end, sqrt(L^2+c^2+h^2)]}
  right: {link: [ground.D, boom.end, sqrt(L^2+c^2+h^2)]}
loads: {weight: {gravity: g}, load: {force: {at: boom.end, along: down, magnitude: W}}}
"""
MASSES_DRIVEN_OUTWARDS = """
parameters: {m: 2 kg, I: 1.5 kg m^2, s0: 0.2 m, s1: 0.6 m, u: 0.3 m/s, w0: 10 rad/s}
ground: {points: {O: [0, 0]}}
bodies:
  bar: {body: {mass: 3 kg, inertia: I}, at: [0, 0], angle: 0, angular_velocity: w0}
  A: {particle: {mass: m}}
  B: {particle: {mass: m}}
connections:
  axle: {pin: [ground.O, bar]}
  ga: {slot: {pin: A, on: bar, along: bar.x}}
  gb: {slot: {pin: B, on: bar, along: bar.x}}
  da: {driver: {measure: s, follows: s0 + u*t}}
  db: {constraint: r + s}
measures: {s: travel of A along bar.x from ground.O, r: travel of B along bar.x from ground.O, phi: angle of bar}
"""
FRICTION_WHEELS = """
parameters: {mA: 4 kg, mB: 6 kg, rA: 0.1 m, rB: 0.15 m, mu: 0.3, P: 80 N, w0: 50 rad/s}
ground: {points: {A: [0, 0]}}
bodies:
  A: {disk: {mass: mA, radius: rA}, at: [0, 0], angular_velocity: w0}
  B: {disk: {mass: mB, radius: rB}, at: [rA+rB, 0]}
connections:
  axle: {pin: [ground.A, A]}
  guide: {slot: {pin: B.center, along: right}}
  touch: {contact: {between: [A, B], friction: mu}}
loads: {press: {force: {at: B.center, along: left, magnitude: P}}}
"""
BALL_IN_A_LIFT = """
parameters: {m: 0.2 kg, M: 500 kg, a: 1.5 m/s^2, v: 3 m/s, u: 5 m/s, g: 9.81 m/s^2}
bodies:
  lift: {particle: {mass: M}}
  ball: {particle: {mass: m}, at: [0, 0], velocity: [0, v+u]}
connections:
  shaft: {slider: {body: lift, along: up}}
  motor: {driver: {measure: z, follows: v*t+a*t^2/2}}
  line: {slider: {body: ball, along: up}}
loads: {weight: {gravity: g}}
measures: {z: y of lift, y: y of ball, h: {expression: y - z}}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Hibbeler, Dynamics, ch. 12: h = r sin(theta), h theta' = -v sin(theta)^2
        (PLANE_SEEN_FROM_THE_GROUND, "velocity of theta when theta = theta1", "-v*sin(theta1)^2/h"),
        (
            PLANE_SEEN_FROM_THE_GROUND,
            "acceleration of theta when theta = theta1",
            "2*v^2*sin(theta1)^3*cos(theta1)/h^2",
        ),
        (PLANE_SEEN_FROM_THE_GROUND, "acceleration of r when theta = theta1", "v^2*sin(theta1)^3/h"),
        (PLANE_SEEN_FROM_THE_GROUND, "time when theta = theta1", "(b + h*cos(theta1)/sin(theta1))/v"),
        # Meriam & Kraige, Dynamics, ch. 2: B moves past A on a straight line
        (TWO_SHIPS, "least d", "abs(a*vB - b*vA)/sqrt(vA^2+vB^2)"),
        (TWO_SHIPS, "time when d is least", "(a*vA+b*vB)/(vA^2+vB^2)"),
        (TWO_SHIPS, "value of vB for which least d = 0", "b*vA/a"),
        # Beer & Johnston, Dynamics, ch. 16: the pinion turns r2/r1 times as fast as the drum
        (GEARED_HOIST, "acceleration of y", "(M*r2/(r1*R) - m*g)/(m + (I2 + I1*r2^2/r1^2)/R^2)"),
        (GEARED_HOIST, "value of M for which acceleration of y = 0", "m*g*R*r1/r2"),
        (
            GEARED_HOIST,
            "speed of cage when y has changed by h",
            "sqrt(2*h*(M*r2/(r1*R) - m*g)/(m + (I2 + I1*r2^2/r1^2)/R^2))",
        ),
        (
            GEARED_HOIST,
            "value of M for which time when y has changed by h is 5 s",
            "(2*h/25*(m + (I2 + I1*r2^2/r1^2)/R^2) + m*g)*R*r1/r2",
        ),
        # Hibbeler, Statics, ch. 8: it slips at both at once, N (1 + mu^2) = m g at the floor
        (CYLINDER_IN_A_CORNER, "largest C so that it stays at rest", "mu*m*g*r*(1+mu)/(1+mu^2)"),
        (
            CYLINDER_IN_A_CORNER,
            "least mu so that it stays at rest",
            "(-1+sqrt(1+4*C/(m*g*r)*(1-C/(m*g*r))))/(2*(1-C/(m*g*r)))",
        ),
        # Gross, Hauger et al., Technische Mechanik 1, ch. 8: virtual work of both angles
        (TWO_HANGING_LINKS_PULLED, "t1 in equilibrium", "atan(2*F/(3*m*g))"),
        (TWO_HANGING_LINKS_PULLED, "t2 in equilibrium", "atan(2*F/(m*g))"),
        (TWO_HANGING_LINKS_PULLED, "value of F for which t1 in equilibrium is 45 deg", "3*m*g/2"),
        (TWO_HANGING_LINKS_PULLED, "size of reaction of B in equilibrium", "sqrt(F^2+m^2*g^2)"),
        # Rao, Mechanical Vibrations, ch. 2: T (1/a + 1/b) y for a small way y
        (BEAD_ON_A_TIGHT_STRING, "natural frequency", "sqrt(T*(a+b)/(m*a*b))"),
        (BEAD_ON_A_TIGHT_STRING, "speed of bead when y = 0", "sqrt(2*T/m*(sqrt(a^2+y0^2)-a+sqrt(b^2+y0^2)-b))"),
        (BEAD_ON_A_TIGHT_STRING, "acceleration of y at start", "-T/m*y0*(1/sqrt(a^2+y0^2)+1/sqrt(b^2+y0^2))"),
        (BEAD_ON_A_TIGHT_STRING, "value of T for which natural frequency = 100 rad/s", "10000*m*a*b/(a+b)"),
        # Morin, Introduction to Classical Mechanics, ch. 5: R theta'^2 = 2 g (cos(theta0) - cos(theta))
        (HOOP_WITH_TWO_BEADS, "normal force of floor when theta = 180 deg", "M*g+2*m*g*(3+2*cos(theta0))"),
        (HOOP_WITH_TWO_BEADS, "least normal force of floor", "M*g-2*m*g*cos(theta0)^2/3"),
        (HOOP_WITH_TWO_BEADS, "least m so that hoop leaves floor", "3*M/(2*cos(theta0)^2)"),
        # Beer & Johnston, Dynamics, ch. 13: (R^2 + b^2) phi'^2/2 = g b phi with b = p/(2 pi)
        (BEAD_ON_A_HELIX, "acceleration of phi", "g*p/(2*pi)/(R^2+p^2/(4*pi^2))"),
        (BEAD_ON_A_HELIX, "speed of bead when phi = 2*pi*n", "sqrt(2*g*p*n)"),
        (BEAD_ON_A_HELIX, "time when phi = 2*pi*n", "sqrt(2*(2*pi*n)*(R^2+p^2/(4*pi^2))/(g*p/(2*pi)))"),
        (BEAD_ON_A_HELIX, "velocity of z when phi = 2*pi*n", "-p/(2*pi)*sqrt(2*g*p*n/(R^2+p^2/(4*pi^2)))"),
        # Hibbeler, Statics, ch. 5: moments about the socket; the roll of the thin boom moves nothing
        (BOOM_ON_TWO_CABLES, "tension of left", "(W+m*g/2)*sqrt(L^2+c^2+h^2)/(2*h)"),
        (BOOM_ON_TWO_CABLES, "reaction of socket along x", "(W+m*g/2)*L/h"),
        (BOOM_ON_TWO_CABLES, "reaction of socket along up", "m*g/2"),
        (BOOM_ON_TWO_CABLES, "value of W for which tension of left = 1 kN", "2000*h/sqrt(L^2+c^2+h^2)-m*g/2"),
        # Meriam & Kraige, Dynamics, ch. 3: (I + 2 m s^2) omega is kept
        (MASSES_DRIVEN_OUTWARDS, "angular velocity of bar when s = s1", "w0*(I+2*m*s0^2)/(I+2*m*s1^2)"),
        (
            MASSES_DRIVEN_OUTWARDS,
            "change of phi until s = s1",
            "w0*(I+2*m*s0^2)/(u*sqrt(2*m*I))*(atan(s1*sqrt(2*m/I))-atan(s0*sqrt(2*m/I)))",
        ),
        (MASSES_DRIVEN_OUTWARDS, "angular acceleration of bar when s = s1", "-4*m*s1*u*w0*(I+2*m*s0^2)/(I+2*m*s1^2)^2"),
        (
            MASSES_DRIVEN_OUTWARDS,
            "value of s1 for which angular velocity of bar when s = s1 is w0/2",
            "sqrt((I+4*m*s0^2)/(2*m))",
        ),
        # Gross, Hauger et al., Technische Mechanik 3, ch. 3: I omega' = mu P r of each
        (FRICTION_WHEELS, "time when rolling begins", "rA*w0/(2*mu*P*(1/mA+1/mB))"),
        (FRICTION_WHEELS, "angular velocity of A when rolling begins", "w0*mA/(mA+mB)"),
        (FRICTION_WHEELS, "energy lost until rolling begins", "mA*mB*rA^2*w0^2/(4*(mA+mB))"),
        (FRICTION_WHEELS, "turns of B until rolling begins", "mu*P/(mB*rB)*(rA*w0/(2*mu*P*(1/mA+1/mB)))^2/(2*pi)"),
        # Hibbeler, Dynamics, ch. 12: seen from the cage it falls with g + a
        (BALL_IN_A_LIFT, "greatest h", "u^2/(2*(g+a))"),
        (BALL_IN_A_LIFT, "time when h = 0", "2*u/(g+a)"),
        (BALL_IN_A_LIFT, "velocity of ball relative to lift along up when h = 0", "-u"),
        (BALL_IN_A_LIFT, "y when h = 0", "v*2*u/(g+a)+a/2*(2*u/(g+a))^2"),
    ],
)
def test_a_problem_of_a_textbook_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)
