"""Laws and extremes that hold in one case of a motion: friction with the resistance of the air, the best angle to pull,
the impact of a rod on an edge, a string that winds round a pole.

Problem families: Gross, Hauger, Schröder & Wall, Technische Mechanik 1 (ch. 9) and 3 (ch. 1, 3, 5); Beer & Johnston,
Vector Mechanics for Engineers: Dynamics, ch. 13; Kleppner & Kolenkow, ch. 6; Morin, ch. 7.
"""

from __future__ import annotations

import math

import pytest

from freebody.api import System
from freebody.narrative.explain import explain

SKID = """
parameters: {m: 900 kg, k: 0.6 kg/m, mu: 0.05, v0: 40 m/s, g: 9.81 m/s^2, v1: 20 m/s}
ground: {lines: {road: {along: right}}}
bodies: {car: {particle: {mass: m}}}
connections: {c: {contact: {between: [car, ground.road], friction: mu}}}
loads: {w: {gravity: g}, air: {force: {at: car, along: left, magnitude: k*rate(x)^2}}}
measures: {x: x of car}
start: {x: 0, rate(x): v0}
"""
PULLED = """
parameters: {m: 30 kg, mu: 0.35, F: 150 N, theta: 10 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {box: {particle: {mass: m}}}
connections: {c: {contact: {between: [box, ground.floor], friction: mu}}}
loads: {w: {gravity: g}, pull: {force: {at: box, along: theta, magnitude: F}}}
measures: {x: x of box}
"""
DISKS = """
parameters: {m: 0.5 kg, M: 0.8 kg, r: 0.05 m, e: 0.7, v: 3 m/s, b: 0.06 m, a: 0.4 m}
bodies: {P: {disk: {mass: m, radius: r}, at: [-a, b], velocity: [v, 0]}, Q: {disk: {mass: M, radius: r}, at: [0, 0]}}
connections: {c: {contact: {between: [P, Q], restitution: e}}}
measures: {x: x of Q, y: y of Q, u: x of P, w: y of P}
"""
EDGE = """
parameters: {m: 4 kg, L: 1.5 m, a: 0.4 m, e: 0.5, v: 3 m/s}
ground: {points: {edge: [a, 0]}}
bodies: {rod: {rod: {mass: m, length: L}, at: [0, 0], velocity: [0, -v]}}
connections: {c: {contact: {between: [ground.edge, rod], restitution: e, touching: true}}}
measures: {y: y of rod, phi: angle of rod}
start: {rate(y): -v, phi: 0, rate(phi): 0}
"""
POLE = """
parameters: {m: 0.2 kg, R: 0.05 m, L: 1 m, v0: 2 m/s}
ground: {points: {T: [-1 m, R], origin: [0, 0]}}
bodies:
  pole: {disk: {radius: R}, fixed: true, at: [0, 0]}
  puck: {particle: {mass: m}, at: [R, -L], velocity: [-v0, 0]}
connections: {cord: {string: {from: ground.T, over: [pole], to: puck, swings: true}}}
measures: {l: distance from ground.origin to puck}
"""
MOTOR = """
parameters: {J: 0.2 kg m^2, T: 6 N m, c: 0.05 N m s}
bodies: {rotor: {body: {inertia: J}}}
connections: {O: {pin: [ground.O, rotor]}}
loads: {drive: {torque: {on: rotor, magnitude: T}}, fan: {law: {measure: phi, force: -c*rate(phi)}}}
measures: {phi: angle of rotor}
start: {phi: 0, rate(phi): 0}
"""


def asked(text: str, question: str):
    (answer,) = System.from_text(text + f"questions: [{{id: q, find: '{question}'}}]\n").solve().answers
    assert answer.expression is not None, answer.reason
    assert answer.evidence is not None
    return answer


def test_car_skids_against_friction_and_air():
    m, k, mu, v0, g, v1 = 900, 0.6, 0.05, 40, 9.81, 20
    V = math.sqrt(mu * m * g / k)
    assert asked(SKID, "x when rate(x) = 0").value == pytest.approx(m / (2 * k) * math.log(1 + (v0 / V) ** 2))
    assert asked(SKID, "time when slipping ends").value == pytest.approx(m / (k * V) * math.atan(v0 / V))
    between = m / (k * V) * (math.atan(v0 / V) - math.atan(v1 / V))
    assert asked(SKID, "time when rate(x) = v1").value == pytest.approx(between)


def test_best_angle_to_pull_is_the_angle_of_friction():
    """a = F (cos + mu sin)/m - mu g while it slides, which is largest at tan(theta) = mu; it may not lift off."""
    answer = asked(PULLED, "value of theta for which acceleration of x is largest")
    assert answer.value == pytest.approx(math.atan(0.35))
    assert any("c slips" in c for c in answer.conditions)


def test_disk_is_driven_aside_most_where_it_is_hit_at_half_a_right_angle():
    answer = asked(DISKS, "value of b for which velocity of y after the impact is least")
    assert answer.value == pytest.approx(0.05 * math.sqrt(2))


def test_rod_that_falls_on_an_edge_is_struck_only_within_its_length():
    L, a, e, v = 1.5, 0.4, 0.5, 3
    answer = asked(EDGE, "angular velocity of rod after the impact")
    assert answer.value == pytest.approx((1 + e) * v * a / (L * L / 12 + a * a))
    assert any("2·a" in c for c in answer.conditions)
    impulse = asked(EDGE, "impulse of c").value
    assert impulse == pytest.approx((0, 4 * (1 + e) * v * (L * L / 12) / (L * L / 12 + a * a)))


def test_puck_keeps_its_speed_while_its_string_winds_round_a_pole():
    answer = asked(POLE, "speed of puck when l = 2*R")
    assert answer.value == pytest.approx(2.0)
    assert any(c.startswith("L > R·√(3)") for c in answer.conditions)  # it is farther away at first


def test_limits_in_time_are_waited_for():
    answer = asked(MOTOR, "range of T for which angular velocity of rotor < 100 rad/s as t grows")
    assert answer.value == pytest.approx(100 * 0.05)


def test_of_a_moving_point_the_extra_term_is_named():
    """dH/dt = M - v x P about a cart that carries a rod."""
    text = """
parameters: {m: 2 kg, M: 3 kg, L: 0.8 m, g: 9.81 m/s^2}
bodies: {cart: {particle: {mass: M}}, rod: {rod: {mass: m, length: L}}}
connections: {rail: {slider: {body: cart, along: right}}, A: {pin: [cart, rod.start]}}
loads: {w: {gravity: g}}
measures: {x: x of cart, phi: angle of rod from down}
start: {x: 0, phi: 0}
"""
    answer = asked(text, "is angular momentum of rod about cart conserved")
    assert any("v × P = -m·L·x'·φ'·sin(φ)/2" in note for note in answer.notes)
    assert asked(text, "is linear momentum along right conserved").why_no_value == ""


def test_the_winding_of_the_string_is_derived():
    """Its free part has the angle of its line counted over several turns, which no pose tells."""
    (derivation,) = explain(System.from_text(POLE + "questions: [speed of puck when l = 2*R]\n")).derivations
    assert not derivation.reason
