"""Which way vectors point: inverse functions of quantities, the direction of a vector, the angle between two."""

from __future__ import annotations

from math import atan2, cos, isclose, pi, radians, sin, sqrt

import pytest

from posed import is_derived, is_formula, posed

CLIFF = """
parameters: {m: 1 kg, v0: 20 m/s, theta: 60 deg, h: 5 m, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: m}, at: [0, h], velocity: [v0*cos(theta), v0*sin(theta)]}}
loads: {weight: {gravity: g}}
measures: {x: x of ball, y: y of ball}
"""
PULLED_ROD = """
parameters: {m: 2 kg, L: 1 m, F: 10 N, g: 9.81 m/s^2}
bodies: {rod: {rod: {mass: m, length: L}}}
connections: {A: {pin: [ground.O, rod.start]}}
loads: {weight: {gravity: g}, pull: {force: {at: rod.end, along: right, magnitude: F}}}
measures: {theta: angle of rod from down}
start: {theta: 0}
"""
IN_SPACE = """
space: {up: z}
parameters: {u: 3 m/s, v: 4 m/s, w: 5 m/s, g: 9.81 m/s^2}
bodies: {ball: {particle: {mass: 1 kg}, at: [0, 0, 0], velocity: [u, v, w]}}
loads: {weight: {gravity: g}}
measures: {z: z of ball}
"""
STEEP = "-atan(sqrt(v0^2*sin(theta)^2+2*g*h)/(v0*cos(theta)))"  # v_y^2 = (v0 sin theta)^2 + 2 g h at the ground
BY_ENERGY = "acos(v0*cos(theta)/sqrt(v0^2+2*g*h))"  # the speed there, and the part along the ground that stays


@pytest.mark.parametrize(
    ("model", "question", "formula"),
    [
        (CLIFF, "atan(velocity of y/velocity of x) when y = 0", STEEP),
        (CLIFF, "direction of velocity of ball when y = 0", STEEP),
        (CLIFF, "angle of velocity of ball below the horizontal when y = 0", BY_ENERGY),
        (CLIFF, "angle between velocity of ball and right when y = 0", BY_ENERGY),
        (CLIFF, "direction of velocity of ball at start", "theta"),
        (CLIFF, "angle between velocity of ball and acceleration of ball at start", "theta + pi/2"),
        # at rest the pin bears F and the weight
        (PULLED_ROD, "direction of reaction of A at equilibrium", "pi/2 + atan(F/(m*g))"),
        (PULLED_ROD, "angle of reaction of A from the vertical at equilibrium", "atan(F/(m*g))"),
        (IN_SPACE, "angle between velocity of ball and up when z = 0", "pi - acos(w/sqrt(u^2+v^2+w^2))"),
    ],
)
def test_an_angle_of_vectors_has_the_formula_by_hand(model: str, question: str, formula: str) -> None:
    assert is_formula(model, question, formula).unit == "rad"


def test_a_direction_in_any_quadrant_is_that_of_the_vector() -> None:
    for degrees in (-150, -90, -30, 45, 120, 170):
        velocity = f"[{cos(radians(degrees))} m/s, {sin(radians(degrees))} m/s]"
        model = f"bodies: {{ball: {{particle: {{mass: 1 kg}}, velocity: {velocity}}}}}\n"
        found = posed(model, "direction of velocity of ball at start").value
        assert isinstance(found, float)
        assert isclose(found, radians(degrees), rel_tol=1e-9)


def test_the_angle_of_impact_is_derived_and_its_degrees_are_told() -> None:
    told = is_derived(CLIFF, "angle of velocity of ball below the horizontal when y = 0")
    degrees = atan2(sqrt((20 * sin(pi / 3)) ** 2 + 2 * 9.81 * 5), 20 * cos(pi / 3)) * 180 / pi
    assert f"{degrees:.2f}" in told["en"]
    assert "unter der Waagerechten" in told["de"]


def test_a_body_at_rest_has_no_direction_of_its_velocity() -> None:
    still = CLIFF.replace("velocity: [v0*cos(theta), v0*sin(theta)]", "velocity: [0, 0]")
    assert "has no direction" in str(posed(still, "direction of velocity of ball at start").reason)
