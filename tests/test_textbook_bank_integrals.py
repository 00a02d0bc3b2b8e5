"""First integrals: problems of textbook families, each with the formula that follows by hand."""

from __future__ import annotations

import pytest

from posed import is_formula

PUCK_AND_WEIGHT_IN_SPACE = """
space: {up: z}
parameters: {m: 0.5 kg, M: 1 kg, r0: 0.4 m, r1: 0.3 m, v0: 1.5 m/s, g: 9.81 m/s^2}
bodies:
  puck: {particle: {mass: m}, at: [r0, 0, 0], velocity: [0, v0, 0]}
  load: {particle: {mass: M}, at: [0, 0, -1 m]}
ground: {points: {O: [0, 0, 0]}, planes: {table: {normal: z}}}
connections:
  table: {point_on_plane: {point: puck, on: ground.table}}
  guide: {point_on_line: {point: load, through: ground.O, along: z}}
  rope: {string: {path: [puck, ground.O, load]}}
loads: {weight: {gravity: g}}
measures: {r: distance from ground.O to puck}
"""
PUCK_AND_WEIGHT = """
parameters: {m: 0.5 kg, b: 1 m, M: 1 kg, r0: 0.4 m, r1: 0.3 m, v0: 1.5 m/s, g: 9.81 m/s^2}
bodies:
  puck: {particle: {mass: m}}
  load: {particle: {mass: M}, at: [0, -b]}
ground: {points: {O: [0, 0]}}
measures: {r: distance from ground.O to puck, phi: angle of line from ground.O to puck, y: y of load}
connections:
  guide: {slider: {body: load, along: up}}
  rope: {constraint: r - y - r0 - b}
loads: {weight: {force: {at: load, along: down, magnitude: M*g}}}
start: {r: r0, phi: 0, rate(r): 0, rate(phi): v0/r0}
"""
ROD_ON_A_SMOOTH_FLOOR = """
parameters: {m: 2 kg, L: 1 m, theta0: 10 deg, theta1: 60 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {floor: {slot: {pin: rod.start, along: floor}}}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod from up clockwise, x: x of rod}
start: {theta: theta0, x: 0}
"""
PENDULUM_ON_A_CART = """
parameters: {m: 1 kg, M: 3 kg, L: 0.8 m, g: 9.81 m/s^2}
bodies:
  cart: {particle: {mass: M}, at: [0, 0]}
  bob: {particle: {mass: m}, at: [L, 0]}
connections:
  rail: {slider: {body: cart, along: right}}
  rod: {link: [cart, bob, L]}
loads: {weight: {gravity: g}}
measures: {x: x of cart, theta: angle of line from cart to bob from down}
"""
THROWN_AGAINST_THE_AIR = """
parameters: {m: 0.6 kg, c: 0.01 kg/m, v0: 20 m/s, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}, at: [0, 0], velocity: [0, v0]}}
connections: {line: {slider: {body: ball, along: up}}}
loads: {weight: {gravity: g}, air: {drag: {body: ball, quadratic: c}}}
measures: {y: height of ball}
"""
SATELLITE = """
parameters: {m: 100 kg, mu: 3.986e14 m^3/s^2, r0: 7e6 m, v0: 8000 m/s}
ground: {points: {E: [0, 0]}}
bodies: {sat: {particle: {mass: m}, at: [r0, 0], velocity: [0, v0]}}
loads: {pull: {attraction: {center: ground.E, strength: mu}}}
measures: {r: distance from ground.E to sat, phi: angle of line from ground.E to sat}
"""
BEAD_IN_A_TURNING_GROOVE = """
parameters: {m: 0.1 kg, b: 0.2 m, omega: 3 rad/s, r0: 0.1 m}
bodies:
  plate: {disk: {mass: 1 kg, radius: 1 m}, at: [0, 0], points: {G: [0, b]}}
  bead: {particle: {mass: m}, near: {at: [0.1 m, 0.2 m]}}
ground: {points: {O: [0, 0]}}
connections:
  axle: {pin: [ground.O, plate.center]}
  groove: {slot: {pin: bead, on: plate, along: plate.x, through: plate.G}}
  motor: {driver: {measure: angle of plate, follows: omega*t}}
measures: {s: travel of bead along plate.x from plate.center}
start: {s: r0, rate(s): 0}
"""


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        # Goldstein, ch. 1: angular momentum and energy
        (PUCK_AND_WEIGHT_IN_SPACE, "value of v0 for which acceleration of r = 0 at start", "sqrt(M*g*r0/m)"),
        # Goldstein, ch. 1: (m + M) r''= m r phi'^2 - M g, r^2 phi' = r0 v0
        (PUCK_AND_WEIGHT, "velocity of r when r = r1", "-sqrt((m*v0^2*(1-r0^2/r1^2)-2*M*g*(r1-r0))/(m+M))"),
        (PUCK_AND_WEIGHT, "rate(phi) when r = r1", "r0*v0/r1^2"),
        (PUCK_AND_WEIGHT, "value of v0 for which acceleration of r = 0 at start", "sqrt(M*g*r0/m)"),
        (PUCK_AND_WEIGHT, "frequency of small oscillations about steady motion when r = r0", "sqrt(3*M*g/((m+M)*r0))"),
        # Meriam & Kraige, Dynamics, ch. 6: the centre falls straight down, y = L cos(theta)/2
        (
            ROD_ON_A_SMOOTH_FLOOR,
            "velocity of theta when theta = theta1",
            "sqrt(12*g*(cos(theta0)-cos(theta1))/(L*(1+3*sin(theta1)^2)))",
        ),
        (ROD_ON_A_SMOOTH_FLOOR, "speed of rod.center when theta = 90 deg", "sqrt(3*g*L*cos(theta0))/2"),
        (ROD_ON_A_SMOOTH_FLOOR, "normal force of floor when theta = 90 deg", "m*g/4"),
        (ROD_ON_A_SMOOTH_FLOOR, "x of rod.start when theta = 90 deg", "-L/2"),
        # Morin, ch. 6: m g L = (m u^2 + M V^2)/2, m u = M V
        (PENDULUM_ON_A_CART, "speed of cart when theta = 0", "m/M*sqrt(2*g*L*M/(M+m))"),
        (PENDULUM_ON_A_CART, "change of x until theta = 0", "m*L/(m+M)"),
        (PENDULUM_ON_A_CART, "tension of rod when theta = 0", "m*g*(3+2*m/M)"),
        (PENDULUM_ON_A_CART, "speed of bob relative to cart when theta = 0", "sqrt(2*g*L*(M+m)/M)"),
        (PENDULUM_ON_A_CART, "distance travelled along x until theta = -90 deg", "2*m*L/(m+M)"),
        # Taylor, ch. 2: v dv/dy = -g - c v^2/m up, g - c v^2/m down
        (THROWN_AGAINST_THE_AIR, "greatest y", "m/(2*c)*log(1+c*v0^2/(m*g))"),
        (THROWN_AGAINST_THE_AIR, "time when y turns back", "sqrt(m/(c*g))*atan(v0*sqrt(c/(m*g)))"),
        (THROWN_AGAINST_THE_AIR, "terminal velocity of y", "-sqrt(m*g/c)"),
        (THROWN_AGAINST_THE_AIR, "speed of ball when y = 0", "v0/sqrt(1+c*v0^2/(m*g))"),
        (THROWN_AGAINST_THE_AIR, "energy lost until y = 0", "m*v0^2/2*(1-1/(1+c*v0^2/(m*g)))"),
        # Goldstein, ch. 3: a = mu/(2 mu/r0 - v0^2), the momentum r v is kept
        (SATELLITE, "greatest r", "r0^2*v0^2/(2*mu-r0*v0^2)"),
        (SATELLITE, "period of r", "2*pi*sqrt((mu*r0/(2*mu-r0*v0^2))^3/mu)"),
        (SATELLITE, "value of v0 for which greatest r = 2*r0", "sqrt(4*mu/(3*r0))"),
        (SATELLITE, "least v0 so that sat escapes", "sqrt(2*mu/r0)"),
        (SATELLITE, "least speed of sat", "(2*mu-r0*v0^2)/(r0*v0)"),
        # Taylor, ch. 9: s'' = omega^2 s, whatever the distance of the groove from the axle
        (BEAD_IN_A_TURNING_GROOVE, "velocity of s when s = b", "omega*sqrt(b^2-r0^2)"),
        (BEAD_IN_A_TURNING_GROOVE, "time when s = b", "log(b/r0+sqrt(b^2/r0^2-1))/omega"),
    ],
)
def test_a_first_integral_of_a_textbook_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    is_formula(model, question, formula)
