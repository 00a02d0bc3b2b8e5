"""Tangential and normal acceleration, and radius of curvature: a_t = dv/dt, a_n = v^2/rho.

A stone thrown at b with v0: rho = v0^2/(g cos b) at the start, (v0 cos b)^2/g at the top. A bob on a rod of the length
L goes round on the radius L with a_n = L w^2 and a_t = L w'.
Source: Meriam & Kraige, Dynamics, sec. 2/5; Hibbeler, Dynamics, sec. 12.7; Beer & Johnston, Dynamics, sec. 11.5.
"""

from __future__ import annotations

import math

import pytest

from posed import is_derived, is_formula, posed

STONE = """
parameters: {m: 2 kg, v0: 20 m/s, b: 50 deg, g: 9.81 m/s^2}
bodies: {stone: {particle: {mass: m}, at: [0, 0], velocity: [v0*cos(b), v0*sin(b)]}}
loads: {weight: {gravity: g}}
measures: {x: x of stone, y: y of stone}
"""
UNNAMED = STONE.replace("measures: {x: x of stone, y: y of stone}\n", "")
PENDULUM = """
parameters: {m: 2 kg, L: 1.5 m, a: 50 deg, g: 9.81 m/s^2}
bodies: {bob: {particle: {mass: m}}}
connections: {rope: {link: [ground.O, bob, L]}}
loads: {weight: {gravity: g}}
measures: {theta: angle of line from ground.O to bob from down}
start: {theta: a}
"""
CASES = {
    "at the start": (STONE, "radius of curvature of the path of stone at start", "v0^2/(g*cos(b))"),
    "at the top": (STONE, "radius of curvature of the path at the highest point", "(v0*cos(b))^2/g"),
    "in German": (STONE, "Krümmungsradius im höchsten Punkt", "(v0*cos(b))^2/g"),
    "where no height has a name": (UNNAMED, "radius of curvature at the highest point", "(v0*cos(b))^2/g"),
    "the speed there": (UNNAMED, "speed of stone at the highest point", "v0*cos(b)"),
    "how fast it slows down": (STONE, "tangential acceleration of stone at start", "-g*sin(b)"),
    "how fast it turns": (STONE, "normal acceleration of stone at start", "g*cos(b)"),
    "on a circle": (PENDULUM, "radius of curvature of the path of bob when theta = 0.2", "L"),
    "towards the centre": (PENDULUM, "normal acceleration of bob when theta = 0", "2*g*(1 - cos(a))"),
    "along the circle": (PENDULUM, "tangential acceleration of bob when theta = 30 deg", "g/2"),
}


@pytest.mark.parametrize("name", CASES)
def test_a_motion_along_its_path_is_that_of_a_textbook(name: str) -> None:
    model, question, formula = CASES[name]
    is_formula(model, question, formula, factors=(1.0, 1.02, 0.98))


def test_both_parts_make_the_acceleration() -> None:
    along, across = (
        posed(STONE, f"{part} acceleration of stone at t = 0.7 s").value for part in ("tangential", "normal")
    )
    assert isinstance(along, float)
    assert isinstance(across, float)
    assert math.hypot(along, across) == pytest.approx(9.81)


def test_what_stands_still_has_no_direction() -> None:
    assert posed(PENDULUM, "normal acceleration of bob at start").expression is None


def test_it_is_derived() -> None:
    told = is_derived(STONE, "radius of curvature of the path of stone at start")
    assert "Krümmungsradius der Bahn von stone" in told["de"]
