"""Problems of first courses: falls, lifts, ropes, impacts, small swings, each with the formula by hand."""

from __future__ import annotations

import pytest

from posed import is_formula

PARCEL_FROM_A_PLANE = """
parameters: {m: 5 kg, v: 60 m/s, h: 500 m, g: 9.81 m/s^2}
bodies: {parcel: {particle: {mass: m}, at: [0, h], velocity: [v, 0]}}
loads: {weight: {gravity: g}}
measures: {x: x of parcel, y: y of parcel}
"""
MAN_ON_A_SCALE = """
parameters: {m: 80 kg, M: 400 kg, a: 2 m/s^2, T: 3 s, g: 9.81 m/s^2}
bodies:
  cage: {rectangle: {mass: M, width: 2 m, height: 2 m}, at: [0, 0], lines: {deck: {through: [0, -1 m], along: right}}}
  man: {rectangle: {mass: m, width: 0.4 m, height: 1.8 m}, at: [0, -0.1 m]}
connections:
  shaft: {slider: {body: cage, along: up}}
  scale: {contact: {between: [man, cage.deck]}}
  hoist: {driver: {measure: y of cage, follows: a*t^2/2}}
loads: {weight: {gravity: g}}
measures: {y: y of cage}
"""
BLOCK_BETWEEN_TWO_WEIGHTS = """
parameters: {M: 4 kg, m1: 1 kg, m2: 3 kg, mu: 0.2, h: 0.5 m, g: 9.81 m/s^2}
ground: {points: {P: [-1 m, 0], Q: [1 m, 0]}}
bodies:
  block: {particle: {mass: M}, at: [0, 0]}
  left: {particle: {mass: m1}, at: [-1 m, -1 m]}
  right: {particle: {mass: m2}, at: [1 m, -1 m]}
connections:
  table: {slider: {body: block, along: right, friction: mu}}
  gl: {slider: {body: left, along: up}}
  gr: {slider: {body: right, along: up}}
  rl: {string: {path: [block, ground.P, left]}}
  rr: {string: {path: [block, ground.Q, right]}}
loads: {weight: {gravity: g}}
measures: {x: x of block}
start: {x: 0, rate(x): 0}
"""
BULLET_INTO_A_SPRUNG_BLOCK = """
parameters: {m: 0.02 kg, M: 2 kg, k: 500 N/m, v: 300 m/s}
ground: {points: {W: [1 m, 0]}}
bodies:
  bullet: {particle: {mass: m}, at: [-0.5 m, 0], velocity: [v, 0]}
  block: {rectangle: {mass: M, width: 0.2 m, height: 0.2 m}, at: [0, 0]}
connections:
  gk: {slider: {body: block, along: right}}
  hit: {contact: {between: [bullet, block], friction: 0, restitution: 0}}
measures: {x: x of block}
loads: {spring: {law: {measure: x, force: -k*x}}}
"""
ROLLER_PULLED_BY_A_WEIGHT = """
parameters: {M: 8 kg, m: 2 kg, R: 0.2 m, mu: 0.3, h: 0.5 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}, points: {Q: [2 m, R]}}
bodies:
  roller: {disk: {mass: M, radius: R}, at: [0, R]}
  load: {particle: {mass: m}, at: [2 m, -1 m]}
connections:
  floor: {contact: {between: [roller, ground.floor], friction: mu}}
  guide: {slider: {body: load, along: up}}
  rope: {string: {path: [roller.center, ground.Q, load]}}
loads: {weight: {gravity: g}}
measures: {x: x of roller}
start: {x: 0, rate(x): 0}
"""
PLATE_ON_TWO_STRINGS = """
parameters: {m: 6 kg, a: 0.5 m, s: 0.4 m, g: 9.81 m/s^2}
ground: {points: {P: [-a/2, a/2 + s]}}
bodies: {plate: {rectangle: {mass: m, width: a, height: a}, at: [0, 0], angle: 0}}
connections: {left: {link: [ground.P, plate.top_left, s]}}
loads: {weight: {gravity: g}}
"""
COMPOUND_PENDULUM = """
parameters: {m: 3 kg, k: 0.3 m, d: 0.5 m, g: 9.81 m/s^2}
bodies: {body: {body: {mass: m, inertia: m*k^2}, points: {A: [0, d]}}}
connections: {A: {pin: [ground.O, body.A]}}
loads: {weight: {gravity: g}}
measures: {phi: angle of body}
ground: {points: {O: [0, 0]}}
start: {phi: 0.1 rad}
"""
TWO_DISKS_ON_A_SHAFT = """
parameters: {I1: 2 kg m^2, I2: 5 kg m^2, c: 800 N m}
ground: {points: {A: [0, 0], B: [1 m, 0]}}
bodies: {one: {body: {mass: 1 kg, inertia: I1}}, two: {body: {mass: 1 kg, inertia: I2}, at: [1 m, 0]}}
connections: {a: {pin: [ground.A, one]}, b: {pin: [ground.B, two]}}
measures: {p1: angle of one, p2: angle of two}
loads: {shaft: {law: {measure: {expression: p2 - p1}, force: -c*(p2 - p1)}}}
start: {p1: 0, p2: 0}
"""
CAR_ON_A_WAVY_ROAD = """
parameters: {m: 300 kg, k: 30 kN/m, y0: 2 cm, H: 0.5 m, Lam: 5 m, v: 10 m/s}
bodies: {wheel: {particle: {mass: 0}}, car: {particle: {mass: m}, at: [0, 0.5 m]}}
connections:
  gw: {slider: {body: wheel, along: up}}
  gc: {slider: {body: car, along: up}}
  road: {driver: {measure: y of wheel, follows: y0*sin(2*pi*v*t/Lam)}}
measures: {y: y of car, w: y of wheel}
loads: {spring: {law: {measure: {expression: y - w - H}, force: -k*(y - w - H)}}}
start: {y: H}
"""
BOB_LET_GO = """
parameters: {m: 1 kg, L: 2 m, theta0: 50 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {string: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: {angle of line from ground.O to bob from down}}
ground: {points: {O: [0, 0]}}
start: {theta: theta0, rate(theta): 0}
"""
BLOCK_HAULED_UP_A_SLOPE = """
parameters: {m1: 4 kg, m2: 6 kg, I: 0.02 kg m^2, r: 0.1 m, alpha: 30 deg, mu: 0.2, h: 1 m, b: 2 m, g: 9.81 m/s^2}
ground: {points: {C: [0, 0]}, lines: {slope: {through: ["-r*sin(alpha)", "r*cos(alpha)"], along: alpha}}}
bodies:
  pulley: {disk: {mass: 1 kg, radius: r, inertia: I}}
  block: {particle: {mass: m1}, at: ["-r*sin(alpha)-b*cos(alpha)", "r*cos(alpha)-b*sin(alpha)"]}
  load: {particle: {mass: m2}, at: [r, -1 m]}
connections:
  axle: {pin: [ground.C, pulley]}
  bed: {slider: {body: block, along: slope, friction: mu}}
  guide: {slider: {body: load, along: up}}
  rope: {string: {from: block, over: [pulley], to: load, grips: [pulley]}}
loads: {weight: {gravity: g}}
measures: {y: drop of load below ground.C}
start: {y: 1 m, rate(y): 0}
"""
BEAM_ON_A_CABLE = """
parameters: {m: 20 kg, L: 2 m, beta: 35 deg, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], W: [0, "L*tan(beta)"]}}
bodies: {beam: {rod: {mass: m, length: L}, at: [L/2, 0], angle: 0}}
connections: {A: {pin: [ground.A, beam.start]}, cable: {link: [ground.W, beam.end, "L/cos(beta)"]}}
loads: {weight: {gravity: g}}
"""
WHEEL_AT_A_KERB = """
parameters: {m: 10 kg, R: 0.4 m, h: 0.1 m, F: 30 N, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}, points: {K: ["sqrt(2*R*h - h^2)", h]}}
bodies: {wheel: {disk: {mass: m, radius: R}, at: [0, R]}}
connections: {floor: {contact: {between: [wheel, ground.floor]}}, kerb: {contact: {between: [wheel, ground.K]}}}
loads: {weight: {gravity: g}, pull: {force: {at: wheel.center, along: right, magnitude: F}}}
"""
GLANCING_BALLS = """
parameters: {m: 2 kg, r: 5 cm, beta: 30 deg, e: 0.5, v: 4 m/s}
bodies:
  A: {disk: {mass: m, radius: r}, at: [0, 0], velocity: [v, 0]}
  B: {disk: {mass: m, radius: r}, at: [2*r*cos(beta), 2*r*sin(beta)]}
connections: {hit: {contact: {between: [A, B], restitution: e}}}
"""
MOTORBOAT = """
parameters: {m: 500 kg, c: 20 kg/m, v0: 8 m/s}
bodies: {boat: {particle: {mass: m}, at: [0, 0], velocity: [v0, 0]}}
connections: {lane: {slider: {body: boat, along: right}}}
measures: {x: x of boat}
loads: {drag: {law: {measure: x, force: -c*rate(x)^2}}}
"""
TUNNEL_THROUGH_A_PLANET = """
parameters: {m: 2 kg, g: 9.81 m/s^2, R: 6400 km}
bodies: {capsule: {particle: {mass: m}, at: [0, R]}}
connections: {tunnel: {slider: {body: capsule, along: up}}}
measures: {y: y of capsule}
loads: {pull: {law: {measure: y, force: -m*g*y/R}}}
start: {y: R, rate(y): 0}
"""
POINT_ON_A_ROLLING_WHEEL = """
parameters: {m: 3 kg, R: 0.3 m, v: 2 m/s}
ground: {lines: {floor: {along: right}}}
bodies:
  wheel:
    {disk: {mass: m, radius: R}, at: [0, R], angle: 0, angular_velocity: -v/R, velocity: [v, 0],
    points: {P: [R, 0], Q: [0, R]}}
connections: {rolls: {rolling: {body: wheel, on: floor}}}
"""
BALL_OFF_A_WALL = """
parameters: {m: 0.2 kg, v0: 12 m/s, theta: 40 deg, d: 9 m, e: 0.7, g: 9.81 m/s^2}
ground: {lines: {wall: {through: [d, 0], along: up}}}
bodies: {ball: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(theta), v0*sin(theta)]}}
connections: {wall: {contact: {between: [ball, wall], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
"""
BOARD_WITH_A_WALKER = """
parameters: {M: 40 kg, m: 30 kg, L: 4 m, b: 3 m, x: 0.5 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  beam:
    {rod: {mass: M, length: L}, at: [L/2, 0], angle: 0, points: {A: [-L/2, 0], B: [b-L/2, 0], P: [x-L/2, 0]}}
connections:
  left: {contact: {between: [beam.A, ground.floor]}}
  right: {contact: {between: [beam.B, ground.floor]}}
loads: {weight: {gravity: g}, man: {force: {at: beam.P, along: down, magnitude: m*g}}}
"""
GRINDSTONE_COASTS = """
parameters: {I: 2 kg m^2, w0: 30 rad/s, M: 4 N m, T: 3 s}
ground: {points: {O: [0, 0]}}
bodies: {stone: {body: {mass: 5 kg, inertia: I}, angular_velocity: w0}}
connections: {axle: {pin: [ground.O, stone]}}
measures: {p: angle of stone}
loads: {brake: {torque: {on: stone, magnitude: -M}}}
start: {p: 0, rate(p): w0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Hibbeler, Dynamics, ch. 12: x = v t, y = h - g t^2/2
        (PARCEL_FROM_A_PLANE, "x when y = 0", "v*sqrt(2*h/g)"),
        (PARCEL_FROM_A_PLANE, "angle of velocity of parcel below the horizontal when y = 0", "atan(sqrt(2*g*h)/v)"),
        (
            PARCEL_FROM_A_PLANE,
            "value of v for which angle of velocity of parcel below the horizontal when y = 0 is 45 deg",
            "sqrt(2*g*h)",
        ),
        (PARCEL_FROM_A_PLANE, "average velocity of y until y = 0", "-sqrt(g*h/2)"),
        # Halliday & Resnick, ch. 5: N - m g = m a
        (MAN_ON_A_SCALE, "normal force of scale", "m*(g+a)"),
        (MAN_ON_A_SCALE, "power of hoist at t = T", "(m+M)*(g+a)*a*T"),
        # Halliday & Resnick, ch. 6: (m2 - m1 - mu M) g = (M + m1 + m2) a
        (BLOCK_BETWEEN_TWO_WEIGHTS, "acceleration of x", "(m2-m1-mu*M)*g/(M+m1+m2)"),
        (BLOCK_BETWEEN_TWO_WEIGHTS, "least mu so that block does not slip", "(m2-m1)/M"),
        # Tipler, ch. 8: m v = (m + M) u
        (BULLET_INTO_A_SPRUNG_BLOCK, "energy lost in the impact", "m*M*v^2/(2*(m+M))"),
        (BULLET_INTO_A_SPRUNG_BLOCK, "speed of block after the impact", "m*v/(m+M)"),
        # Meriam & Kraige, Dynamics, ch. 6: m g - S = m a, S R = 3/2 M R a
        (ROLLER_PULLED_BY_A_WEIGHT, "acceleration of x", "m*g/(m+3*M/2)"),
        (ROLLER_PULLED_BY_A_WEIGHT, "least mu so that roller rolls without slipping", "m/(2*m+3*M)"),
        # Beer & Johnston, Dynamics, ch. 16: the corner moves across the string, T a/2 = m a^2/6 alpha
        (PLATE_ON_TWO_STRINGS, "angular acceleration of plate at start", "-6*g/(5*a)"),
        (PLATE_ON_TWO_STRINGS, "tension of left at start", "2*m*g/5"),
        (PLATE_ON_TWO_STRINGS, "acceleration of plate along down at start", "3*g/5"),
        (PLATE_ON_TWO_STRINGS, "direction of acceleration of plate at start", "-pi/2"),
        # Meriam & Kraige, Dynamics, ch. 8: (k^2 + d^2) phi'' = -g d phi
        (COMPOUND_PENDULUM, "period of small oscillations", "2*pi*sqrt((k^2+d^2)/(g*d))"),
        (COMPOUND_PENDULUM, "value of d for which period of small oscillations is least", "k"),
        (COMPOUND_PENDULUM, "least period of small oscillations over d", "2*pi*sqrt(2*k/g)"),
        # Thomson, Theory of Vibration, ch. 5: I1 p1 + I2 p2 = 0 in the mode that swings
        (TWO_DISKS_ON_A_SHAFT, "natural frequency of mode 2", "sqrt(c*(1/I1+1/I2))"),
        (TWO_DISKS_ON_A_SHAFT, "amplitude ratio of p1 to p2 in mode 2", "-I2/I1"),
        (TWO_DISKS_ON_A_SHAFT, "amplitude ratio of p1 to p2 in mode 1", "1"),
        # Rao, Mechanical Vibrations, ch. 3: k y0/(k - m w^2) with w = 2 pi v/Lam
        (CAR_ON_A_WAVY_ROAD, "amplitude of y", "abs(y0/(1-(2*pi*v/Lam)^2*m/k))"),
        (CAR_ON_A_WAVY_ROAD, "natural frequency", "sqrt(k/m)"),
        # Halliday & Resnick, ch. 8: m v^2/L = 2 m g (1 - cos theta0)
        (BOB_LET_GO, "tension of string when theta = 0", "m*g*(3-2*cos(theta0))"),
        (BOB_LET_GO, "value of theta0 for which tension of string when theta = 0 is 2*m*g", "pi/3"),
        (BOB_LET_GO, "tension of string at start", "m*g*cos(theta0)"),
        (BOB_LET_GO, "angle between acceleration of bob and down at start", "pi/2-theta0"),
        # Beer & Johnston, Dynamics, ch. 16
        (BLOCK_HAULED_UP_A_SLOPE, "acceleration of y", "(m2-m1*(sin(alpha)+mu*cos(alpha)))*g/(m1+m2+I/r^2)"),
        # Hibbeler, Statics, ch. 5: three forces meet in a point, so the pin's line mirrors the cable
        (BEAM_ON_A_CABLE, "tension of cable", "m*g/(2*sin(beta))"),
        (BEAM_ON_A_CABLE, "direction of reaction of A", "beta"),
        (BEAM_ON_A_CABLE, "size of reaction of A", "m*g/(2*sin(beta))"),
        (BEAM_ON_A_CABLE, "value of beta for which tension of cable = m*g", "pi/6"),
        # Hibbeler, Statics, ch. 5: moments about the kerb
        (WHEEL_AT_A_KERB, "normal force of kerb", "F*R/sqrt(2*R*h-h^2)"),
        (WHEEL_AT_A_KERB, "normal force of floor", "m*g-F*(R-h)/sqrt(2*R*h-h^2)"),
        (WHEEL_AT_A_KERB, "least F so that wheel leaves floor", "m*g*sqrt(2*R*h-h^2)/(R-h)"),
        # Beer & Johnston, Dynamics, ch. 13: the tangential part stays, the normal ones are (1 -+ e)/2
        (GLANCING_BALLS, "direction of velocity of B after the impact", "beta"),
        (GLANCING_BALLS, "angle between velocity of A and velocity of B after the impact", "atan(2*tan(beta)/(1-e))"),
        (GLANCING_BALLS, "speed of A after the impact", "v*sqrt(sin(beta)^2+((1-e)/2)^2*cos(beta)^2)"),
        (GLANCING_BALLS, "direction of velocity of A after the impact", "beta - atan(2*tan(beta)/(1-e))"),
        # Meriam & Kraige, Dynamics, ch. 3: dv/dt = -c v^2/m
        (MOTORBOAT, "time when velocity of x = v0/2", "m/(c*v0)"),
        (MOTORBOAT, "x when velocity of x = v0/2", "m*log(2)/c"),
        (MOTORBOAT, "impulse of drag until velocity of x = v0/2", "-m*v0/2"),
        (MOTORBOAT, "average velocity of x until velocity of x = v0/2", "v0*log(2)"),
        # Kleppner & Kolenkow, ch. 3
        (TUNNEL_THROUGH_A_PLANET, "time when y = 0", "pi/2*sqrt(R/g)"),
        (TUNNEL_THROUGH_A_PLANET, "speed of capsule when y = 0", "sqrt(g*R)"),
        (TUNNEL_THROUGH_A_PLANET, "period", "2*pi*sqrt(R/g)"),
        (TUNNEL_THROUGH_A_PLANET, "average velocity of y until y = 0", "-2/pi*sqrt(g*R)"),
        # Meriam & Kraige, Dynamics, ch. 5: omega = v/R, rho = |v|^3/|v x a| with a = v^2/R at the top
        (POINT_ON_A_ROLLING_WHEEL, "speed of wheel.P at start", "v*sqrt(2)"),
        (POINT_ON_A_ROLLING_WHEEL, "direction of velocity of wheel.P at start", "-pi/4"),
        (POINT_ON_A_ROLLING_WHEEL, "radius of curvature of the path of wheel.Q at start", "4*R"),
        (POINT_ON_A_ROLLING_WHEEL, "angle between velocity of wheel.P and acceleration of wheel.P at start", "3*pi/4"),
        # Hibbeler, Dynamics, ch. 15: beyond the wall the way is e times as long
        (BALL_OFF_A_WALL, "x when y = 0", "d - e*(v0^2*sin(2*theta)/g - d)"),
        (BALL_OFF_A_WALL, "y when ball hits wall", "d*tan(theta)-g*d^2/(2*v0^2*cos(theta)^2)"),
        (BALL_OFF_A_WALL, "time when y = 0", "2*v0*sin(theta)/g"),
        # Hibbeler, Statics, ch. 5: moments about the right support
        (BOARD_WITH_A_WALKER, "normal force of left", "M*g*(1-L/(2*b))+m*g*(b-x)/b"),
        (BOARD_WITH_A_WALKER, "largest x so that the beam does not tip", "b+M*(2*b-L)/(2*m)"),
        # Meriam & Kraige, Dynamics, ch. 6
        (GRINDSTONE_COASTS, "time when rate(p) = 0", "I*w0/M"),
        (GRINDSTONE_COASTS, "turns of stone until rate(p) = 0", "I*w0^2/(4*pi*M)"),
        (GRINDSTONE_COASTS, "average power of brake until rate(p) = 0", "-M*w0/2"),
        (GRINDSTONE_COASTS, "impulse of brake until rate(p) = 0", "-I*w0"),
    ],
)
def test_a_problem_of_a_first_course_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)
