"""Small motion, steady motion and what is conserved. Ten problems in the style of textbooks, in words and numbers of
our own; from what the formula follows by hand stands beside it."""

from __future__ import annotations

import pytest

from freebody.language.notation import to_python
from posed import is_derived, is_formula, posed

# Den Hartog, Mechanical Vibrations, ch. 3: bounce and pitch of a car on two equal springs
BOUNCE_AND_PITCH = """
parameters: {m: 1200 kg, J: 1500 kg*m^2, a: 1.2 m, k: 30 kN/m, d: 0.1 m}
bodies: {car: {body: {mass: m, inertia: J}, points: {F: [a, 0], R: [-a, 0]}}}
connections: {g: {slot: {pin: car.mass_center, along: up}}}
loads: {r: {law: {measure: u, force: -k*u}}, f: {law: {measure: v, force: -k*v}}}
measures: {y: y of car, phi: angle of car, u: y of car.R, v: y of car.F}
start: {y: 0, rate(y): 0, phi: 0, rate(phi): 0}
"""
# French, Vibrations and Waves, ch. 5: a mass on a taut spring, along it and across
MASS_BETWEEN_TWO_SPRINGS = """
parameters: {m: 0.1 kg, k: 400 N/m, L: 0.5 m, l0: 0.4 m}
ground: {points: {A: [-L, 0], B: [L, 0]}}
bodies: {b: {particle: {mass: m}}}
loads:
  s1: {spring: {first: ground.A, second: b, stiffness: k, length: l0}}
  s2: {spring: {first: ground.B, second: b, stiffness: k, length: l0}}
measures: {x: x of b, y: y of b}
start: {x: 0, y: 0, rate(x): 0, rate(y): 0}
"""
# Rao & Dukkipati, Mechanism and Machine Theory, ch. on governors: balls between links of equal length, a heavy sleeve
SLEEVE_GOVERNOR = """
space: {up: z}
parameters: {m: 2 kg, M: 4 kg, l: 0.3 m, g: 9.81 m/s^2, beta: 40 deg, Omega: 12 rad/s, near: 50 deg}
bodies:
  spindle: {body: {}, turned: [psi about z]}
  upper: {rod: {length: l}, turned: [gamma about y], frame: spindle}
  lower: {rod: {length: l}, turned: [180 deg - near about y]}
  ball: {particle: {mass: m}}
  sleeve: {particle: {mass: M}}
connections:
  axle: {revolute: {first: ground.O, second: spindle, about: z}}
  top: {revolute: {first: spindle, second: upper.start, about: y}}
  hung: {spherical: [upper.end, ball]}
  knee: {revolute: {first: upper.end, second: lower.start, about: y}}
  foot: {spherical: [lower.end, sleeve]}
  guide: {point_on_line: {point: sleeve, through: ground.O, along: z}}
loads: {weight: {gravity: g}}
start: {psi: 0, rate(psi): Omega, gamma: 90 deg - beta}
"""
# the same with a link and a drive: the height of the sleeve follows through s (2 L cos(theta) - s) = 0
DRIVEN_GOVERNOR = """
space: {up: z}
parameters: {m: 1.2 kg, M: 3 kg, L: 0.25 m, Omega: 9 rad/s, g: 9.81 m/s^2}
bodies:
  spindle: {body: {}}
  arm_1: {body: {}, points: {end: [0, 0, -L]}, turned: [theta about y], frame: spindle}
  arm_2: {body: {}, points: {end: [0, 0, -L]}}
  ball_1: {particle: {mass: m}}
  ball_2: {particle: {mass: m}}
  sleeve: {particle: {mass: M}, near: {at: [0, 0, -0.4 m]}}
connections:
  axle: {revolute: {first: ground.O, second: spindle, about: z}}
  motor: {driver: {measure: psi, follows: Omega*t}}
  h1: {revolute: {first: spindle, second: arm_1, about: y}}
  h2: {revolute: {first: spindle, second: arm_2, about: y}}
  same: {constraint: th1 + th2}
  b1: {weld: [arm_1.end, ball_1]}
  b2: {weld: [arm_2.end, ball_2]}
  guide: {point_on_line: {point: sleeve, through: ground.O, along: z}}
  link_1: {link: [arm_1.end, sleeve, L]}
loads: {weight: {gravity: g}}
measures:
  psi: angle of spindle about z
  th1: angle of arm_1 about y relative to spindle
  th2: angle of arm_2 about y relative to spindle
  s: drop of sleeve below ground.O
start: {theta: 40 deg}
"""
# the sleeve sits at the hinges, where the link is an arm turned back: it has no part
SLEEVE_AT_THE_HINGE = DRIVEN_GOVERNOR.replace(", near: {at: [0, 0, -0.4 m]}", "")
# Hibbeler, Dynamics, ch. 22: a metronome
METRONOME = """
parameters: {M: 0.05 kg, m: 0.02 kg, a: 0.04 m, b: 0.07 m, g: 9.81 m/s^2, T: 1 s}
bodies:
  arm: {body: {mass: 0}, points: {O: [0, 0], A: [0, -a], B: [0, b]}}
  low: {particle: {mass: M}}
  high: {particle: {mass: m}}
connections: {O: {pin: [ground.O, arm.O]}, la: {pin: [arm.A, low]}, ha: {pin: [arm.B, high]}}
loads: {weight: {gravity: g}}
measures: {phi: angle of arm}
start: {phi: 0, rate(phi): 0}
"""
# Taylor, Classical Mechanics, ch. 7 and 8: a particle goes round in a cone
PARTICLE_IN_A_CONE = """
space: {up: z}
parameters: {m: 0.2 kg, a: 1.5, R: 0.4 m, g: 9.81 m/s^2, W: 4 rad/s}
bodies: {bead: {particle: {mass: m}, near: {at: [R, 0, a*R]}}}
connections: {cone: {point_on_surface: {point: bead, z: a*rho}}}
loads: {weight: {gravity: g}}
measures: {rho: distance of bead from the z axis, phi: angle of line from ground.O to bead}
start: {rho: R, phi: 0, rate(rho): 0, rate(phi): W}
"""
# Rao, Mechanical Vibrations, ch. 1: a weight on a movable pulley that a spring holds
PULLEY_ON_A_SPRING = """
parameters: {m: 5 kg, k: 800 N/m, r: 0.1 m, g: 9.81 m/s^2}
ground: {points: {A: [-3*r, 0], P: [0, 0], S: [-2*r, -3 m]}}
bodies:
  top: {pulley: {radius: r}}
  low: {pulley: {mass: 0, radius: r}, at: [-2*r, -2 m]}
  b: {particle: {mass: m}}
connections: {axle: {pin: [ground.P, top]}, rope: {string: {path: [ground.A, under low, over top, b]}}}
loads: {weight: {gravity: g}, s: {spring: {first: ground.S, second: low.center, stiffness: k, length: 1 m}}}
measures: {x: drop of b below ground.P}
start: {x: 1 m, rate(x): 0}
"""
# Meirovitch, Elements of Vibration Analysis, ch. 4: a pendulum on a cylinder that rolls
PENDULUM_ON_A_ROLLER = """
parameters: {M: 4 kg, R: 0.2 m, m: 1 kg, L: 0.5 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {c: {disk: {mass: M, radius: R}, at: [0, R]}, bob: {particle: {mass: m}}}
connections: {roll: {rolling: {body: c, on: ground.floor}}, rod: {link: [c.center, bob, L]}}
loads: {weight: {gravity: g}}
measures: {x: x of c, phi: angle of line from c.center to bob from down}
start: {x: 0, rate(x): 0, phi: 0, rate(phi): 0}
"""
# Gross, Hauger et al., Technische Mechanik 3, ch. 5: the tip of a shallow truss of two springs
SHALLOW_TRUSS = """
parameters: {b: 1 m, h: 0.3 m, k: 50 kN/m, m: 100 kg, F: 2 kN}
ground: {points: {A: [-b, 0], B: [b, 0]}, lines: {mid: {along: up}}}
bodies: {tip: {particle: {mass: m}}}
connections: {g: {slider: [tip, ground.mid]}}
loads:
  l: {spring: {first: ground.A, second: tip, stiffness: k, length: sqrt(b^2 + h^2)}}
  r: {spring: {first: ground.B, second: tip, stiffness: k, length: sqrt(b^2 + h^2)}}
measures: {y: y of tip}
start: {y: h, rate(y): 0}
"""
# Greenwood, Principles of Dynamics, ch. 6: an arm hinged off the axis of a turntable
ARM_ON_A_TURNTABLE = """
parameters: {m: 1 kg, L: 0.5 m, w: 4 rad/s, b: 0.3 m, kt: 20 N*m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  disk: {body: {mass: 1 kg, inertia: 1 kg*m^2}, points: {O: [0, 0], H: [b, 0]}, lines: {r: {along: right}}}
  arm: {rod: {mass: m, length: L}}
connections:
  axle: {pin: [ground.O, disk.O]}
  motor: {driver: {measure: psi, follows: w*t}}
  hinge: {pin: [disk.H, arm.start]}
loads: {t: {torsional_spring: {body: arm, on: disk, stiffness: kt, angle: 0}}}
measures: {psi: angle of disk, phi: angle of arm from disk.r}
start: {phi: 0, rate(phi): 0}
"""
# Morin, Introduction to Classical Mechanics, ch. 6: nearly a circle under a constant pull
PUCK_AND_HOLE = """
parameters: {m: 0.5 kg, F: 4 N, a: 0.6 m, b: 0.4 m, v0: 1 m/s}
ground: {points: {O: [0, 0]}}
bodies: {puck: {particle: {mass: m}}}
loads: {string: {law: {measure: r, force: -F}}}
measures: {r: distance from ground.O to puck, phi: angle of line from ground.O to puck}
start: {r: a, phi: 0, rate(r): 0, rate(phi): v0/a}
"""
# Landau & Lifshitz, Mechanics, sec. 23: a pendulum on a cart that a spring holds
PENDULUM_ON_A_SPRUNG_CART = """
parameters: {M: 3 kg, m: 1 kg, L: 0.5 m, k: 60 N/m, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}}}
connections: {rail: {slider: {body: cart, along: right}}, rod: {link: [cart, bob, L]}}
loads: {weight: {gravity: g}, s: {law: {measure: x, force: -k*x}}}
measures: {x: x of cart, phi: angle of line from cart to bob from down}
start: {x: 0, rate(x): 0, phi: 0, rate(phi): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # both springs against the mass
        (BOUNCE_AND_PITCH, "natural frequency of y", "sqrt(2*k/m)"),
        # both at the arm a against the inertia
        (BOUNCE_AND_PITCH, "natural frequency of phi", "sqrt(2*k*a**2/J)"),
        # two tensions k (L - l0), turned by y/L
        (MASS_BETWEEN_TWO_SPRINGS, "natural frequency of y", "sqrt(2*k*(L - l0)/(m*L))"),
        # two springs
        (MASS_BETWEEN_TWO_SPRINGS, "natural frequency of x", "sqrt(2*k/m)"),
        # both together
        (MASS_BETWEEN_TWO_SPRINGS, "ratio of natural frequency of x to natural frequency of y", "sqrt(L/(L - l0))"),
        # the springs must pull
        (MASS_BETWEEN_TWO_SPRINGS, "range of l0 for which the equilibrium is stable", "L"),
        # g (M a - m b) against M a^2 + m b^2
        (METRONOME, "natural frequency", "sqrt(g*(M*a - m*b)/(M*a**2 + m*b**2))"),
        # the mass centre must be below the pivot
        (METRONOME, "range of b for which the equilibrium is stable", "M*a/m"),
        # 4 pi^2 (M a^2 + m b^2) = g T^2 (M a - m b)
        (
            METRONOME,
            "value of m for which period of small oscillations = T",
            "M*a*(g*T**2 - 4*pi**2*a)/(b*(g*T**2 + 4*pi**2*b))",
        ),
        # R W^2 = g a along the slope
        (PARTICLE_IN_A_CONE, "rate of phi in steady motion when rho = R", "sqrt(a*g/R)"),
        # (1 + a^2) rho'' = h^2/rho^3 - a g, differentiated
        (
            PARTICLE_IN_A_CONE,
            "frequency of small oscillations about steady motion when rho = R",
            "sqrt(3*a*g/(R*(1 + a**2)))",
        ),
        # its vertical part carries the weight
        (PARTICLE_IN_A_CONE, "normal force of cone in steady motion when rho = R", "m*g*sqrt(1 + a**2)"),
        # the pulley goes half as far under twice the force
        (PULLEY_ON_A_SPRING, "natural frequency", "sqrt(k/(4*m))"),
        # the rope carries the weight
        (PULLEY_ON_A_SPRING, "tension of rope in equilibrium", "m*g"),
        # 3/2 M takes the place of the mass of a cart
        (PENDULUM_ON_A_ROLLER, "natural frequency of phi", "sqrt(g/L*(1 + 2*m/(3*M)))"),
        # each spring with the square of h/sqrt(b^2 + h^2)
        (SHALLOW_TRUSS, "natural frequency", "h*sqrt(2*k/(m*(b**2 + h**2)))"),
        # kt + m w^2 b L/2 against m L^2/3
        (
            ARM_ON_A_TURNTABLE,
            "frequency of small oscillations about steady motion",
            "sqrt(3*kt/(m*L**2) + 3*b*w**2/(2*L))",
        ),
        # m r'' = h^2/(m r^3) - F, differentiated
        (PUCK_AND_HOLE, "frequency of small oscillations about steady motion", "sqrt(3*F/(m*a))"),
        # M L w^4 - (k L + (M + m) g) w^2 + k g = 0
        (
            PENDULUM_ON_A_SPRUNG_CART,
            "natural frequency of mode 1",
            "sqrt((k/M + g/L*(M + m)/M - sqrt((k/M + g/L*(M + m)/M)**2 - 4*k*g/(M*L)))/2)",
        ),
        # the other root
        (
            PENDULUM_ON_A_SPRUNG_CART,
            "natural frequency of mode 2",
            "sqrt((k/M + g/L*(M + m)/M + sqrt((k/M + g/L*(M + m)/M)**2 - 4*k*g/(M*L)))/2)",
        ),
        # the lower link carries M g, the upper one (M + m) g, each pulls the ball inwards by tan(beta) of that
        (
            SLEEVE_GOVERNOR,
            "rate of psi in steady motion when gamma = 90 deg - beta",
            "sqrt((m + 2*M)*g/(m*l*cos(beta)))",
        ),
    ],
)
def test_a_small_or_steady_motion_has_the_formula_of_its_derivation(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # h = L cos(theta): m h Omega^2 = (m + M) g
        (
            DRIVEN_GOVERNOR,
            "value of Omega for which theta = 45 deg in steady motion",
            "sqrt((m + M)*g*sqrt(2)/(m*L))",
        ),
        (DRIVEN_GOVERNOR, "value of Omega for which s = L in steady motion", "sqrt(2*(m + M)*g/(m*L))"),
        (
            SLEEVE_AT_THE_HINGE,
            "value of Omega for which theta = 45 deg in steady motion",
            "sqrt(g*sqrt(2)/L)",
        ),
    ],
)
def test_what_a_loop_binds_goes_along_with_the_place(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_places_are_told_where_the_drive_is_too_slow_for_one_of_them() -> None:
    # upright, hanging, and Omega^2 L cos(theta) m = (m + M) g, where the drive is fast enough
    found = posed(DRIVEN_GOVERNOR, "theta in steady motion")
    assert found.evidence is not None
    assert isinstance(found.expression, tuple)
    assert to_python(found.expression[2]) == "acos(g*(m + M)/(m*L*Omega**2))"


def test_a_length_is_told_by_the_angle_that_is_steady() -> None:
    told = is_derived(DRIVEN_GOVERNOR.replace("9 rad", "16 rad"), "value of Omega for which s = L in steady motion")
    assert "2·L·cos(θ)" in told["en"]
    assert "Gesucht ist 2·L·cos(θ)" in told["de"]
