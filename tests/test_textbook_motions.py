"""Motions in the style of textbook families: modes by their number, what escapes, what dies away, what drag and motors
take and give. Beside each stands from what its formula follows by hand."""

from __future__ import annotations

import math
from functools import cache

import pytest

import freebody as fb
from conftest import assert_same_function
from freebody.language.expression import Expr
from freebody.language.notation import to_python
from freebody.study.answering.answer import Answer

TWO_PENDULUMS = """
parameters: {m1: 1 kg, m2: 2 kg, L: 0.7 m, g: 9.81 m/s^2}
bodies: {A: {particle: {mass: m1}}, B: {particle: {mass: m2}}}
connections: {u: {link: [ground.O, A, L]}, l: {link: [A, B, L]}}
loads: {weight: {gravity: g}}
measures: {p1: angle of line from ground.O to A from down, p2: angle of line from A to B from down}
start: {p1: 0, p2: 0}
"""
ELASTIC_PENDULUM = """
parameters: {m: 1 kg, k: 60 N/m, l0: 0.5 m, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}, near: {at: [0, -0.6 m]}}}
loads: {weight: {gravity: g}, spring: {spring: {first: ground.O, second: bob, stiffness: k, length: l0}}}
measures: {r: distance from ground.O to bob, theta: angle of line from ground.O to bob from down}
start: {theta: 0}
"""
PENDULUM_ON_A_FREE_CART = """
parameters: {m: 1 kg, M: 3 kg, L: 1 m, p0: 60 deg, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}}}
connections: {rail: {slider: {body: cart, along: right}}, rod: {link: [cart, bob, L]}}
loads: {weight: {gravity: g}}
measures: {x: x of cart, theta: angle of line from cart to bob from down}
start: {x: 0, rate(x): 0, theta: p0, rate(theta): 0}
"""
SATELLITE = """
parameters: {m: 2 kg, mu: 30 m^3/s^2, r0: 4 m, v0: 3.2 m/s}
bodies: {sat: {particle: {mass: m}, at: [r0, 0]}}
loads: {gravity: {attraction: {center: ground.earth, strength: mu}}}
measures: {r: distance from ground.earth to sat, phi: angle of line from ground.earth to sat}
start: {r: r0, phi: 0, rate(r): 0, rate(phi): v0/r0}
"""
ATTRACTED_BY_THE_CUBE = """
parameters: {m: 1 kg, K: 5 N m^3, r0: 1 m, v0: 3 m/s}
bodies: {p: {particle: {mass: m}, at: [r0, 0]}}
loads: {pull: {law: {measure: r, force: -K/r^3}}}
measures: {r: distance from ground.O to p, phi: angle of line from ground.O to p}
start: {r: r0, rate(r): 0, phi: 0, rate(phi): v0/r0}
"""
SHOT_UP_AGAINST_THE_AIR = """
parameters: {m: 0.15 kg, k: 0.004 kg/m, v0: 25 m/s, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}, at: [0, 0]}}
connections: {line: {slider: {body: ball, along: up}}}
loads: {weight: {gravity: g}, air: {drag: {body: ball, quadratic: k}}}
measures: {y: y of ball}
start: {y: 0, rate(y): v0}
"""
CRATE_ON_A_BELT = """
parameters: {m: 8 kg, u: 2 m/s, mu: 0.3, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies:
  belt: {particle: {mass: 1 kg}, at: [0, 0], lines: {top: {along: right}}}
  crate: {particle: {mass: m}, at: [0, 0]}
connections:
  rail: {slider: {body: belt, along: right}}
  motor: {driver: {measure: z, follows: u*t}}
  c: {contact: {between: [crate, belt.top], friction: mu}}
loads: {weight: {gravity: g}}
measures: {z: x of belt, x: x of crate}
start: {x: 0, rate(x): 0, z: 0}
"""
CREEPS_BACK = """
parameters: {m: 1 kg, k: 8 N/m, c: 6 N s/m, x0: 0.2 m}
bodies: {b: {particle: {mass: m}}}
connections: {r: {slider: {body: b, along: right}}}
loads: {s: {law: {measure: x, force: -k*x}}, d: {law: {measure: x, force: -c*rate(x)}}}
measures: {x: x of b}
start: {x: x0, rate(x): 0}
"""
CRITICAL_AND_PUSHED_BACK = """
parameters: {m: 2 kg, k: 50 N/m, x0: 0.1 m, v0: {value: -1.5 m/s, sign: any}}
bodies: {b: {particle: {mass: m}}}
connections: {r: {slider: {body: b, along: right}}}
loads: {s: {law: {measure: x, force: -k*x}}, d: {law: {measure: x, force: -2*sqrt(k*m)*rate(x)}}}
measures: {x: x of b}
start: {x: x0, rate(x): v0}
"""
ROLLER_ON_A_DRUM = """
parameters: {M: 3 kg, R: 0.4 m, m: 1 kg, r: 0.1 m, p0: 10 deg, g: 9.81 m/s^2}
ground: {points: {O: [0, 0]}}
bodies: {drum: {disk: {mass: M, radius: R}}, roller: {disk: {mass: m, radius: r}}}
connections: {axle: {pin: [ground.O, drum]}, c: {rolling: {body: roller, on: drum}}}
loads: {weight: {gravity: g}}
measures: {phi: angle of line from ground.O to roller from up clockwise, psi: angle of drum}
start: {phi: p0, rate(phi): 0, psi: 0, rate(psi): 0}
"""
ROD_ON_A_TURNING_YOKE = """
space: {up: z}
parameters: {m: 1 kg, L: 0.6 m, Omega: 7 rad/s, p0: 40 deg, g: 9.81 m/s^2}
bodies:
  yoke: {body: {}, turned: [psi about z]}
  rod:
    body: {mass: m, inertia: [m*L^2/12, m*L^2/12, 0]}
    points: {top: [0, 0, L/2]}
    turned: [theta about y]
    frame: yoke
connections:
  swivel: {revolute: {first: ground.O, second: yoke, about: z}}
  hinge: {revolute: {first: yoke, second: rod.top, about: y}}
  motor: {driver: {measure: psi, follows: Omega*t}}
loads: {weight: {gravity: g}}
start: {psi: 0, theta: p0, rate(theta): 0}
"""
BOB_IN_ALL_DIRECTIONS = """
space: {up: z}
parameters: {m: 0.4 kg, L: 1.2 m, g: 9.81 m/s^2, p0: 40 deg, v0: 3.2 m/s}
bodies:
  yoke: {body: {}, turned: [psi about z]}
  bob: {body: {mass: m}, points: {top: [0, 0, L]}, turned: [theta about y], frame: yoke}
connections:
  swivel: {revolute: {first: ground.O, second: yoke, about: z}}
  hinge: {revolute: {first: yoke, second: bob.top, about: y}}
loads: {weight: {gravity: g}}
start: {psi: 0, theta: p0, rate(theta): 0, rate(psi): v0/(L*sin(p0))}
"""
BOUNCES = """
parameters: {m: 0.1 kg, h: 1 m, e: 0.8, v: 0.5 m/s, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {b: {particle: {mass: m}, at: [0, h], velocity: [v, 0]}}
connections: {c: {contact: {between: [b, floor], restitution: e}}}
loads: {weight: {gravity: g}}
measures: {x: x of b, y: y of b}
"""
CAR = """
parameters: {m: 1200 kg, a: 1.2 m, b: 1.5 m, h: 0.5 m, F: 3 kN, g: 9.81 m/s^2}
ground: {lines: {road: {along: right}}}
bodies:
  car:
    rectangle: {mass: m, width: 3 m, height: 1 m}
    at: [0, h]
    angle: 0
    points: {f: [a, -h], r: [-b, -h]}
connections:
  front: {contact: {between: [car.f, ground.road], touching: true}}
  rear: {contact: {between: [car.r, ground.road], touching: true}}
loads: {weight: {gravity: g}, drive: {force: {at: car.r, along: right, magnitude: F}}}
measures: {x: x of car}
"""

# exp(-a t) and exp(-b t) of what creeps back, a < b
ROOTS = {"a": "((c - sqrt(c**2 - 4*m*k))/(2*m))", "b": "((c + sqrt(c**2 - 4*m*k))/(2*m))"}
GREATEST_SPEED = "x0*k/m/(b - a)*(exp(-a*log(b/a)/(b - a)) - exp(-b*log(b/a)/(b - a)))"
OF_CRITICAL = "(x0 + (v0 + sqrt(k/m)*x0)*t)*exp(-sqrt(k/m)*t)"  # with t where x' = 0
TURNED = "v0/(sqrt(k/m)*(v0 + sqrt(k/m)*x0))"

NEAR = {"m1": 1.0, "m2": 2.0, "L": 0.7, "m": 1.0, "k": 60.0, "M": 3.0, "p0": 0.6, "K": 5.0, "R": 0.4, "r": 0.1}
OVERDAMPED = {"m": 1.0, "k": 8.0, "c": 6.0, "x0": 0.2}
CRITICAL = {"m": 2.0, "k": 50.0, "x0": 0.1, "v0": -1.5}


@cache
def system(model: str) -> fb.System:
    return fb.System.from_text(model)


def answer(model: str, question: str) -> Answer:
    return system(model).solve(question)["q1"]


def with_roots(text: str) -> str:
    """A formula in the two roots, in the parameters."""
    return "".join(ROOTS.get(piece, piece) for piece in _pieces(text))


def _pieces(text: str) -> list[str]:
    pieces, word = [], ""
    for letter in text:
        if letter.isalnum() or letter == "_":
            word += letter
        else:
            pieces += [word, letter]
            word = ""
    return [*pieces, word]


@pytest.mark.parametrize(
    ("model", "question", "expected", "near"),
    [
        # det(K - w^2 M) = 0 of two points on strings of one length: g/L (m1 + m2 -+ sqrt(m2 (m1 + m2)))/m1
        (
            TWO_PENDULUMS,
            "ratio of natural frequency of mode 2 to natural frequency of mode 1",
            "sqrt((m1 + m2 + sqrt(m2*(m1 + m2)))/(m1 + m2 - sqrt(m2*(m1 + m2))))",
            NEAR,
        ),
        (TWO_PENDULUMS, "lowest natural frequency", "sqrt(g/L*(m1 + m2 - sqrt(m2*(m1 + m2)))/m1)", NEAR),
        # g/(l0 + m g/k) and k/m: one to two where k l0 + m g = 4 m g, the resonance of the elastic pendulum
        (
            ELASTIC_PENDULUM,
            "value of k for which natural frequency of mode 2 = 2*natural frequency of mode 1",
            "3*m*g/l0",
            NEAR,
        ),
        # the cart's own motion is free, but leaves theta as it is; against the cart M/(M + m) of the mass swings
        (PENDULUM_ON_A_FREE_CART, "period of small oscillations of theta", "2*pi*sqrt(M*L/((M + m)*g))", NEAR),
        # with V -> 0 all of the energy at the start is kinetic
        (SATELLITE, "least v0 so that it escapes", "sqrt(2*mu/r0)", {"mu": 30.0}),
        # r'' = (r0^2 v0^2 - K/m)/r^3: outwards for ever or inwards for ever
        (ATTRACTED_BY_THE_CUBE, "least v0 so that it escapes", "sqrt(K/m)/r0", NEAR),
        # down again with v0/sqrt(1 + k v0^2/(m g))
        (SHOT_UP_AGAINST_THE_AIR, "energy lost until y = 0", "m*v0**2/2*(1 - 1/(1 + k*v0**2/(m*g)))", {}),
        # mu m g for u/(mu g): half of it is heat
        (CRATE_ON_A_BELT, "work of motor until slipping ends", "m*u**2", {}),
        # x' = -x0 w^2 (exp(-a t) - exp(-b t))/(b - a) is greatest at t = ln(b/a)/(b - a)
        (CREEPS_BACK, "greatest speed of b", with_roots(GREATEST_SPEED), OVERDAMPED),
        (CREEPS_BACK, "least velocity of x", "-" + with_roots(GREATEST_SPEED), OVERDAMPED),
        (CRITICAL_AND_PUSHED_BACK, "least x", OF_CRITICAL.replace("*t)", f"*({TURNED}))"), CRITICAL),
        (CRITICAL_AND_PUSHED_BACK, "greatest speed of b", "-v0", CRITICAL),
        # the drum turns with it: (R + r) phi'^2 (2 m + 3 M) = 4 g (m + M) (cos p0 - cos phi), and N = 0
        (ROLLER_ON_A_DRUM, "phi when normal force of c = 0", "acos(4*(m + M)*cos(p0)/(6*m + 7*M))", NEAR),
        # m L^2/3 Omega^2 sin cos = m g L/2 sin
        (
            ROD_ON_A_TURNING_YOKE,
            "value of Omega for which acceleration of theta = 0 at start",
            "sqrt(3*g/(2*L*cos(p0)))",
            {},
        ),
        # v sin keeps, so v0^2/2 (1 - sin^2 p0) = g L cos p0
        (BOB_IN_ALL_DIRECTIONS, "least v0 so that theta reaches 90 deg", "sqrt(2*g*L/cos(p0))", {}),
        # up with e times the speed
        (BOUNCES, "greatest y after the impact", "e**2*h", {}),
        # moments about the mass centre: N (a - b) = -F h of equal forces
        (CAR, "value of F for which normal force of front = normal force of rear", "m*g*(b - a)/(2*h)", {"b": 1.5}),
    ],
)
def test_a_motion_of_a_textbook_family_has_the_formula_of_its_derivation(
    model: str, question: str, expected: str, near: dict[str, float]
) -> None:
    found = answer(model, question)
    assert isinstance(found.expression, Expr), found
    assert_same_function(to_python(found.expression), expected, near)


def test_what_creeps_back_only_tends_to_its_centre() -> None:
    least, greatest = (answer(CREEPS_BACK, f"{end} x") for end in ("least", "greatest"))
    assert least.value is None
    assert "tends" in least.reason
    assert isinstance(greatest.expression, Expr)
    assert to_python(greatest.expression) == "x0"


def test_round_off_after_a_motion_has_died_away_is_no_turn() -> None:
    """A hardening spring has no closed form, so numbers are told: not those of what is left after a minute."""
    hardening = CREEPS_BACK.replace("force: -k*x}", "force: -k*x - 10*k*x^3}").replace("10*k*x^3", "k*x^3/(1 m)^2")
    assert answer(hardening, "least x").value is None
    assert answer(hardening, "greatest x").value == pytest.approx(0.2)
    assert answer(hardening, "greatest speed of b").value is None


def test_the_order_of_modes_is_a_condition_where_parameters_decide_it() -> None:
    """A pendulum beside a block on a spring is the slower or the faster one, as the parameters are."""
    beside = """
parameters: {m: 1 kg, k: 60 N/m, L: 0.5 m, g: 9.81 m/s^2}
ground: {points: {O: [0, 0], Q: [2 m, 0]}}
bodies: {bob: {particle: {mass: m}}, block: {particle: {mass: m}}}
connections: {rod: {link: [ground.O, bob, L]}, r: {slider: {body: block, along: right, through: ground.Q}}}
loads: {weight: {gravity: g}, s: {law: {measure: x, force: -k*(x - 2)}}}
measures: {x: x of block, theta: angle of line from ground.O to bob from down}
start: {x: 2 m, theta: 0}
""".replace("-k*(x - 2)", "-k*(x - 2 m)")
    found = answer(beside, "natural frequency of mode 1")
    assert isinstance(found.expression, Expr)
    assert_same_function(to_python(found.expression), "sqrt(g/L)", {})
    assert any("order" in condition for condition in found.conditions), found.conditions


def test_a_mode_that_is_not_there_is_told() -> None:
    assert "2 modes" in answer(TWO_PENDULUMS, "natural frequency of mode 3").reason


def test_what_is_thrown_slower_than_it_falls_in_does_not_escape() -> None:
    """By numbers: below the limit it meets the centre, above it is farther and farther away."""
    limit = answer(ATTRACTED_BY_THE_CUBE, "least v0 so that it escapes").value
    assert isinstance(limit, float)
    faster = system(ATTRACTED_BY_THE_CUBE).with_parameters(v0=1.1 * limit).simulate(3.0)
    assert float(faster.dataset["r"][-1]) > 1.2
    assert math.isclose(limit, math.sqrt(5.0))
