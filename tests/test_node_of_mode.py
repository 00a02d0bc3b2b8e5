"""The node of a mode: the point of a rigid body that rests while it swings.

Source of the car: Rao, Mechanical Vibrations, example 5.7 (bounce and pitch), whose nodes are 2.6461 m and 0.3061 m
from the centre of mass.
"""

from __future__ import annotations

import pytest

from posed import is_derived, is_formula, posed

CAR = """
parameters: {m: 1000 kg, r: 0.9 m, a: 1 m, b: 1.5 m, kf: 18 kN/m, kr: 22 kN/m}
bodies: {car: {body: {mass: m, inertia: m*r^2, points: {front: [-a, 0], rear: [b, 0]}}}}
connections: {heaves: {slot: {pin: car, along: up}}}
measures: {y: y of car, phi: angle of car, yf: y of car.front, yr: y of car.rear}
loads: {f: {law: {measure: yf, force: -kf*yf}}, r: {law: {measure: yr, force: -kr*yr}}}
start: {y: 0, phi: 0}
"""
PENDULUM = """
parameters: {m: 2 kg, L: 1 m, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}, angle: -90 deg}}
connections: {hinge: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of rod from down}
start: {theta: 0}
"""
SLIDING = """
parameters: {m: 1 kg, k: 100 N/m}
bodies: {a: {body: {mass: m, inertia: 1 kg*m^2}}, b: {body: {mass: m, inertia: 1 kg*m^2}}}
connections: {ga: {slider: {body: a, along: right}}, gb: {slider: {body: b, along: right}}}
measures: {x1: x of a, x2: x of b}
loads: {l: {law: {measure: x1, force: -k*x1}}, m: {law: {measure: {expression: x2 - x1}, force: -k*(x2 - x1)}}}
start: {x1: 0, x2: 0}
"""
# of y'' m + (kf + kr) y + (kr b - kf a) phi = 0 with w^2 from m^2 r^2 w^4 - m (kf (a^2 + r^2) + kr (b^2 + r^2)) w^2
# + kf kr (a + b)^2 = 0: -y/phi = (kr b - kf a)/(kf + kr - m w^2)
_P = "(kf*(a^2+r^2)+kr*(b^2+r^2))"
SLOWER = f"(({_P})-sqrt(({_P})^2-4*r^2*kf*kr*(a+b)^2))/(2*m*r^2)"


def test_nodes_of_a_car_are_those_that_rao_has() -> None:
    slow, fast = (posed(CAR, f"node of mode {k} of car").value for k in (1, 2))
    assert slow == pytest.approx((2.6461, 0), abs=1e-4)
    assert fast == pytest.approx((-0.3061, 0), abs=1e-4)


def test_the_distance_of_a_node_has_the_formula_by_hand() -> None:
    is_formula(CAR, "distance of the node of mode 1 of car", f"(kr*b-kf*a)/(kf+kr-m*{SLOWER})", (1.0, 1.1))


def test_a_node_from_another_point_of_the_body_is_the_same_point() -> None:
    assert posed(CAR, "node of mode 1 from front").value == pytest.approx((2.6461 + 1, 0), abs=1e-4)


def test_what_hangs_in_a_bearing_rests_there() -> None:
    found = posed(PENDULUM, "node of mode 1 of rod")
    assert found.value == pytest.approx((0, 0.5))
    assert found.expression is not None


def test_a_body_that_does_not_turn_has_no_node() -> None:
    assert "does not turn in mode 2" in posed(SLIDING, "node of mode 2 of b").reason


def test_a_node_is_derived() -> None:
    told = is_derived(CAR, "node of mode 2 of car")
    assert "The node" in told["en"]
    assert "Der Knoten" in told["de"]
    is_derived(CAR, "distance of node of mode 1 of car")


@pytest.mark.parametrize(
    "words",
    [
        "place of the car that rests in mode 2",
        "where is the node of the second mode",
        "Wo liegt der Schwingungsknoten der zweiten Eigenform?",
        "Welcher Punkt des Wagens ruht in der zweiten Eigenform?",
    ],
)
def test_a_node_is_asked_for_in_words(words: str) -> None:
    assert posed(CAR, words).value == pytest.approx((-0.3061, 0), abs=1e-4)
