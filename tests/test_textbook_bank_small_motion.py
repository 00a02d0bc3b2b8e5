"""Small and steady motion, conservation: problems of textbook families, each with the formula that follows by hand."""

from __future__ import annotations

import math

import pytest

from posed import is_formula, posed

COUPLED_PENDULUMS = """
parameters: {m: 1 kg, L: 1 m, a: 0.6 m, k: 20 N/m, d: 0.5 m, g: 9.81 m/s^2}
ground: {points: {A: [0, 0], B: [d, 0]}}
bodies:
  p: {body: {mass: m, inertia: 0, center_of_mass: [0, -L]}, points: {grip: [0, -a]}}
  q: {body: {mass: m, inertia: 0, center_of_mass: [0, -L]}, points: {grip: [0, -a]}}
connections:
  A: {pin: [ground.A, p.origin]}
  B: {pin: [ground.B, q.origin]}
loads:
  weight: {gravity: g}
  spring: {spring: {between: [p.grip, q.grip], stiffness: k, length: d}}
measures: {alpha: angle of p, beta: angle of q}
"""
DISK_WITH_A_LUMP = """
parameters: {M: 4 kg, m: 1 kg, R: 0.3 m, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies:
  disk: {disk: {mass: M, radius: R}, at: [0, R], points: {rim: [0, -R]}}
  lump: {particle: {mass: m}, at: [0, 0]}
connections:
  floor: {rolling: {body: disk, on: floor}}
  glue: {weld: [disk.rim, lump]}
loads: {weight: {gravity: g}}
measures: {phi: angle of disk}
"""
UPRIGHT_ROD_ON_A_SPRING = """
parameters: {m: 3 kg, L: 1 m, k: 40 N/m, l: 0.5 m, T: 2 s, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], W: [-l, L]}}
bodies: {rod: {rod: {mass: m, length: L}, angle: 90 deg}}
connections: {O: {pin: [ground.O, rod.start]}}
loads:
  weight: {gravity: g}
  spring: {spring: {between: [ground.W, rod.end], stiffness: k, length: l}}
measures: {phi: angle of rod from up}
"""
BEETLE_ON_A_TURNTABLE = """
parameters: {M: 0.5 kg, m: 0.05 kg, R: 0.2 m, w: 1 rad/s}
ground: {points: {O: [0, 0]}}
bodies:
  table: {disk: {mass: M, radius: R}, at: [0, 0]}
  bug: {particle: {mass: m}, at: [R, 0]}
connections:
  axle: {pin: [ground.O, table.center]}
  rim: {link: [table.center, bug, R]}
  walk: {driver: {measure: psi, follows: w*t}}
measures: {phi: angle of table, psi: angle of line from table.center to bug from table.x}
"""
THREE_MASSES_BETWEEN_WALLS = """
parameters: {m: 1 kg, k: 100 N/m, a: 0.2 m, w: 5 rad/s}
ground: {points: {L: [0, 0], R: [4*a, 0]}}
bodies:
  m1: {particle: {mass: m}, at: [a, 0]}
  m2: {particle: {mass: m}, at: [2*a, 0]}
  m3: {particle: {mass: m}, at: [3*a, 0]}
connections:
  g1: {slider: {body: m1, along: right}}
  g2: {slider: {body: m2, along: right}}
  g3: {slider: {body: m3, along: right}}
loads:
  s1: {spring: {between: [ground.L, m1], stiffness: k, length: a}}
  s2: {spring: {between: [m1, m2], stiffness: k, length: a}}
  s3: {spring: {between: [m2, m3], stiffness: k, length: a}}
  s4: {spring: {between: [m3, ground.R], stiffness: k, length: a}}
measures: {x1: x of m1, x2: x of m2, x3: x of m3}
"""
WATT_GOVERNOR = """
space: {up: z}
parameters: {m: 1 kg, M: 5 kg, L: 0.3 m, Omega: 20 rad/s, beta: 40 deg, g: 9.81 m/s^2}
bodies:
  spindle: {body: {}, turned: [psi about z]}
  right: {body: {mass: m}, points: {top: [0, 0, L]}, turned: [theta about y], frame: spindle}
  left: {body: {mass: m}, points: {top: [0, 0, L]}, turned: [phi about y], frame: spindle}
connections:
  bearing: {revolute: {first: ground.O, second: spindle, about: z}}
  a: {revolute: {first: spindle, second: right.top, about: y}}
  b: {revolute: {first: spindle, second: left.top, about: y}}
  motor: {driver: {measure: psi, follows: Omega*t}}
loads: {weight: {gravity: g}}
start: {theta: beta, phi: -beta}
"""
GOVERNOR_WITH_A_SLEEVE = """
parameters: {m: 1 kg, M: 5 kg, L: 0.3 m, Omega: 20 rad/s, beta: 40 deg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  right: {particle: {mass: m}, near: {at: [0.2 m, -0.2 m]}}
  left: {particle: {mass: m}, near: {at: [-0.2 m, -0.2 m]}}
  sleeve: {particle: {mass: M}, near: {at: [0, -0.4 m]}}
connections:
  a: {link: [ground.O, right, L]}
  b: {link: [ground.O, left, L]}
  c: {link: [right, sleeve, L]}
  d: {link: [left, sleeve, L]}
  guide: {slot: {pin: sleeve, along: up, through: ground.O}}
loads:
  weight: {gravity: g}
  cr: {law: {measure: xr, force: m*Omega^2*xr}}
  cl: {law: {measure: xl, force: m*Omega^2*xl}}
measures: {theta: angle of line from ground.O to right from down, xr: x of right, xl: x of left}
start: {theta: beta}
"""
SPRINGS_IN_SERIES = """
parameters: {m: 2 kg, k1: 100 N/m, k2: 300 N/m, a: 0.2 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  joint: {particle: {mass: 0}, at: [0, -a]}
  block: {particle: {mass: m}, at: [0, -2*a]}
connections:
  g1: {slider: {body: joint, along: up}}
  g2: {slider: {body: block, along: up}}
loads:
  weight: {gravity: g}
  s1: {spring: {between: [ground.O, joint], stiffness: k1, length: a}}
  s2: {spring: {between: [joint, block], stiffness: k2, length: a}}
measures: {y: drop of block below ground.O}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Taylor, ch. 11: in phase and in opposite phase
        (COUPLED_PENDULUMS, "lowest natural frequency", "sqrt(g/L)"),
        (COUPLED_PENDULUMS, "highest natural frequency", "sqrt(g/L+2*k*a^2/(m*L^2))"),
        (COUPLED_PENDULUMS, "value of k for which highest natural frequency = 2*sqrt(g/L)", "3*m*g*L/(2*a^2)"),
        # Beer & Johnston, Dynamics, ch. 19: about the contact, with the lump at it, 3 M R^2/2
        (DISK_WITH_A_LUMP, "natural frequency", "sqrt(2*m*g/(3*M*R))"),
        (DISK_WITH_A_LUMP, "period of small oscillations of phi", "2*pi*sqrt(3*M*R/(2*m*g))"),
        (DISK_WITH_A_LUMP, "normal force of floor at start", "(M+m)*g"),
        # Beer & Johnston, Dynamics, ch. 19: m L^2/3 phi'' = (m g L/2 - k L^2) phi
        (UPRIGHT_ROD_ON_A_SPRING, "range of k for which the equilibrium is stable", "m*g/(2*L)"),
        (UPRIGHT_ROD_ON_A_SPRING, "natural frequency", "sqrt(3*k/m-3*g/(2*L))"),
        (UPRIGHT_ROD_ON_A_SPRING, "largest m so that the equilibrium is stable", "2*k*L/g"),
        (
            UPRIGHT_ROD_ON_A_SPRING,
            "value of k for which period of small oscillations = T",
            "4*pi^2*m/(3*T^2) + m*g/(2*L)",
        ),
        # Kleppner & Kolenkow, ch. 6: the momentum about the axle stays zero
        (BEETLE_ON_A_TURNTABLE, "change of phi until psi = 360 deg", "-4*pi*m/(2*m+M)"),
        (BEETLE_ON_A_TURNTABLE, "angular velocity of table at start", "-2*m*w/(2*m+M)"),
        (BEETLE_ON_A_TURNTABLE, "driving torque of walk", "0"),
        (BEETLE_ON_A_TURNTABLE, "kinetic energy at start", "m*R^2*w^2*M/(2*(M+2*m))"),
        # Morin, ch. 4: w^2 = (2 - 2 cos(n pi/4)) k/m
        (THREE_MASSES_BETWEEN_WALLS, "lowest natural frequency", "sqrt((2-sqrt(2))*k/m)"),
        (THREE_MASSES_BETWEEN_WALLS, "natural frequency of mode 2", "sqrt(2*k/m)"),
        (THREE_MASSES_BETWEEN_WALLS, "highest natural frequency", "sqrt((2+sqrt(2))*k/m)"),
        (THREE_MASSES_BETWEEN_WALLS, "value of k for which lowest natural frequency = w", "w^2*m/(2 - sqrt(2))"),
        # Goldstein, ch. 1: beside the spindle, m L Omega^2 sin(theta) cos(theta) = m g sin(theta)
        (WATT_GOVERNOR, "equilibrium of theta", "acos(g/(L*Omega^2))"),
        # Thomson, Theory of Vibration, ch. 2: in the turning plane, m Omega^2 r against (m + M) g tan(theta)
        (GOVERNOR_WITH_A_SLEEVE, "equilibrium of theta", "acos((m+M)*g/(m*L*Omega^2))"),
        # den Hartog, Mechanical Vibrations, ch. 2: the joint has no mass, so both springs carry the same force
        (SPRINGS_IN_SERIES, "natural frequency", "sqrt(k1*k2/(m*(k1+k2)))"),
        (SPRINGS_IN_SERIES, "equilibrium of y", "2*a + m*g/k1 + m*g/k2"),
        # Goldstein, ch. 1: w^2 = Omega^2 sin(theta)^2 beside it; the model starts elsewhere
        (WATT_GOVERNOR, "frequency about steady motion", "Omega*sqrt(1-(g/(L*Omega^2))^2)"),
    ],
)
def test_a_small_motion_of_a_textbook_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)


def test_each_arm_of_a_governor_has_its_place_in_steady_motion() -> None:
    # m L sin(theta) (L Omega^2 cos(theta) - g) = 0 of each arm alone
    found = posed(WATT_GOVERNOR, "theta in steady motion")
    cosine = 9.81 / (0.3 * 20.0**2)
    assert found.value == pytest.approx((0.0, math.pi, math.acos(cosine)))
    assert found.evidence is not None
