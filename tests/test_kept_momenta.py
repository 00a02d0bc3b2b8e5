"""Energy together with momenta that stay: two freedoms of which one is cyclic, with the derivation.

Problem families: Meriam & Kraige, Dynamics, ch. 3 and 4 (bob on a sliding cart, bead in a turning tube, puck on a
string through a hole); Morin, Introduction to Classical Mechanics, ch. 5 and 7. Expected values are worked out here.
"""

from __future__ import annotations

import math

import pytest

import freebody as fb
from freebody.narrative.explain import explain

CART = """
parameters: {m: 1 kg, M: 3 kg, L: 0.5 m, theta0: 60 deg, g: 9.81 m/s^2}
ground: {lines: {floor: {along: right}}}
bodies: {cart: {particle: {mass: M}}, bob: {particle: {mass: m}}}
connections: {rail: {slider: {body: cart, along: floor}}, string: {link: [cart, bob, L]}}
loads: {weight: {gravity: g}}
measures: {x: x of cart, theta: angle of line from cart to bob from down}
start: {x: 0, theta: theta0, rate(x): 0, rate(theta): 0}
"""
TUBE = """
parameters: {m: 1 kg, J: 0.5 kg m^2, r0: 0.2 m, r1: 0.5 m, w0: 10 rad/s}
bodies: {tube: {body: {inertia: J}, points: {O: [0, 0]}}, bead: {particle: {mass: m}}}
connections: {axle: {pin: [ground.O, tube.O]}, guide: {slider: {body: bead, along: tube.x, through: tube.O}}}
measures: {r: distance from ground.O to bead, phi: angle of tube}
start: {r: r0, phi: 0, rate(r): 0, rate(phi): w0}
"""
PUCK = """
parameters: {m: 1 kg, M: 2 kg, r0: 0.5 m, v0: 5 m/s, g: 9.81 m/s^2}
bodies: {puck: {particle: {mass: m}, at: [r0, 0], velocity: [0, v0]}, weight: {particle: {mass: M}, at: [0, -1 m]}}
connections: {well: {slider: {body: weight, along: up}}, rope: {string: [puck, ground.O, weight]}}
loads: {weight: {force: {at: weight, along: down, magnitude: M*g}}}
measures: {r: distance from ground.O to puck}
"""
m, M, L, g = 1.0, 3.0, 0.5, 9.81
DROP = 2 * g * L * (1 - math.cos(math.radians(60)))  # v^2 of a bob on a fixed point
ALONG = math.sqrt((0.5 + 0.04) * (0.25 - 0.04) / (0.5 + 0.25)) * 10  # r' by J and energy
ROUND = 0.5 * 5 / 0.8  # v across at r = 0.8 m
TURN = (5 * (math.sqrt(25 + 8 * 2 * 0.5 * g) + 5)) / (4 * 2 * g)  # M g r^2 = m v0^2 (r + r0)/2
CASES = [
    # m (v - V) ... : M V = m u, m u^2 + M V^2 = m DROP
    (CART, "speed of cart when theta = 0", m * math.sqrt(DROP / (M * (m + M)))),
    (CART, "speed of bob when theta = 0", math.sqrt(M * DROP / (m + M))),
    (CART, "x when theta = 0", m * L * math.sin(math.radians(60)) / (m + M)),
    (CART, "distance travelled along x until theta = 0", m * L * math.sin(math.radians(60)) / (m + M)),
    # T - m g = m (relative speed)^2/L, the cart being unaccelerated there
    (CART, "tension of string when theta = 0", m * g + m * DROP * (m + M) / M / L),
    (CART, "greatest speed of cart", m * math.sqrt(DROP / (M * (m + M)))),
    (TUBE, "velocity of r when r = r1", ALONG),
    (TUBE, "angular velocity of tube when r = r1", 10 * 0.54 / 0.75),
    # J phi'' = -N r with phi'' = -2 m r r' phi'/(J + m r^2)
    (TUBE, "normal force of guide when r = r1", 2 * 0.5 * ALONG * 7.2 / 0.75),
    (PUCK, "velocity of r when r = 0.8 m", math.sqrt((25 - ROUND**2 - 2 * 2 * g * 0.3) / 3)),
    (PUCK, "r when rate(r) = 0", TURN),
    (PUCK, "greatest distance from ground.O to puck", TURN),
    # M (T/M - g) = -M r'', m r'' = m v^2/r - T
    (PUCK, "tension of rope when r = 0.8 m", 2 * (g + ROUND**2 / 0.8) / 3),
]


@pytest.mark.parametrize(("text", "question", "expected"), CASES, ids=[question for _t, question, _x in CASES])
def test_momentum_and_energy_give_it_and_both_are_derived(text: str, question: str, expected: float) -> None:
    found = explain(fb.System.from_text(text + f"questions: ['{question}']\n"))
    (derivation,) = found.derivations
    answer = derivation.answer
    assert answer.evidence is not None, answer.reason
    assert answer.value == pytest.approx(expected)
    assert not derivation.reason
    assert any(stage.title.key == "stage.momenta" for stage in derivation.stages)


def test_how_far_the_puck_gets_needs_room_for_the_weight() -> None:
    """Beyond r0 + 1 m the weight would be pulled through the hole."""
    answer = fb.System.from_text(PUCK).solve("greatest distance from ground.O to puck").answers[0]
    assert any("weight has not reached ground.O" in c for c in answer.conditions)


def test_momenta_are_derived_in_a_phase_of_a_motion() -> None:
    """On a floor that it may leave, with a string that may go slack."""
    text = CART.replace(
        "{slider: {body: cart, along: floor}}", "{contact: {between: [cart, floor], friction: 0}}"
    ).replace("cart: {particle: {mass: M}}", "cart: {particle: {mass: M}, at: [0, 0]}")
    text = (
        text.replace("{link: [cart, bob, L]}", "{string: {from: cart, to: bob, swings: true}}")
        .replace("start: {", "start: {d: L, ")
        .replace("measures: {", "measures: {d: distance from cart to bob, ")
    )
    found = explain(fb.System.from_text(text + "questions: ['speed of cart when theta = 0']\n"))
    (derivation,) = found.derivations
    assert derivation.answer.value == pytest.approx(m * math.sqrt(DROP / (M * (m + M)))), derivation.answer.reason
    assert not derivation.reason
