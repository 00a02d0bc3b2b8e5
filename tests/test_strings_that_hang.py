"""What hangs on strings: what goes straight up and down, and what turns about the point at which it is tied."""

from __future__ import annotations

import pytest
from tests.conftest import Agree

import freebody as fb

PLATE = """
parameters: {{m: 10 kg, a: 0.6 m, b: 0.4 m, L: 0.5 m, g: 9.81 m/s^2}}
ground: {{points: {{C: [-a/2, b/2 + L], D: [a/2, b/2 + L]}}}}
bodies: {{plate: {{rectangle: {{mass: m, width: a, height: b}}, {where}}}}}
connections: {{{strings}}}
loads: {{weight: {{gravity: g}}}}
"""
LEFT = "left: {string: {from: ground.C, to: plate.top_left}}"
RIGHT = "right: {string: {from: ground.D, to: plate.top_right}}"


def plate(strings: str, where: str = "at: [0, 0]") -> fb.System:
    return fb.System.from_text(PLATE.format(strings=strings, where=where))


def test_a_plate_on_one_string_turns_about_its_corner_which_goes_aside(agrees: Agree) -> None:
    """The other string was cut. The string pulls upwards, so G goes straight down with the acceleration c and the
    corner does not move along the string: c = alpha a/2, T a/2 = m (a^2 + b^2)/12 alpha, m g - T = m c.
    Source: Meriam & Kraige, Dynamics, ch. 6 (a plate released by cutting one of its two supports)."""
    found = plate(LEFT).solve(["tension of left at start", "angular acceleration of plate at start"])
    agrees(found, "q1", "m*g*(a**2 + b**2)/(4*a**2 + b**2)")
    agrees(found, "q2", "-6*a*g/(4*a**2 + b**2)")


def test_a_plate_on_two_strings_hangs_still_and_pulls_half_its_weight_in_each(agrees: Agree) -> None:
    found = plate(f"{LEFT}, {RIGHT}").solve(["tension of left at start", "acceleration of plate at start"])
    agrees(found, "q1", "m*g/2")
    assert found["q2"].value == pytest.approx((0.0, 0.0))


@pytest.mark.parametrize("point", ["top", "mass_center"])
def test_what_hangs_below_its_point_goes_straight_down(agrees: Agree, point: str) -> None:
    system = fb.System.from_text(
        "parameters: {m: 10 kg, M: 4 kg, a: 0.6 m, b: 0.4 m, g: 9.81 m/s^2}\n"
        "bodies: {plate: {rectangle: {mass: m, width: a, height: b}, angle: 0}, block: {particle: {mass: M}},"
        " pulley: {disk: {radius: 0.1 m}}}\n"
        "connections: {axle: {pin: [ground.A, pulley]},"
        f" rope: {{string: {{from: plate.{point}, over: [pulley], to: block}}}}}}\n"
        "loads: {weight: {gravity: g}}\nmeasures: {y: drop of block}"
    )
    agrees(system.solve(["acceleration of y at start"]), "q1", "g*(M - m)/(M + m)")


def test_a_beam_on_two_hoists_is_that_of_the_equations_by_hand(agrees: Agree) -> None:
    """Level ends: from rest they go straight up and down. With the drop z of G and the turn phi, blocks of equal masses
    M rise by z +- phi L/2: (m + 2 M) z" = (m - 2 M) g, so T = M (g + z")."""
    system = fb.System.from_text(
        "parameters: {m: 10 kg, M: 4 kg, L: 2 m, R: 0.1 m, g: 9.81 m/s^2}\n"
        "ground: {points: {P: [-L/2 - R, 3 m], Q: [L/2 + R, 3 m]}}\n"
        "bodies: {beam: {rod: {mass: m, length: L}}, a: {particle: {mass: M}}, b: {particle: {mass: M}},"
        " p: {disk: {radius: R}}, q: {disk: {radius: R}}}\n"
        "connections: {p: {pin: [ground.P, p]}, q: {pin: [ground.Q, q]},"
        " left: {string: {from: beam.start, over: [p], to: a}}, right: {string: {from: beam.end, over: [q], to: b}}}\n"
        "loads: {weight: {gravity: g}}"
    )
    agrees(system.solve(["tension of left at start"]), "q1", "2*M*m*g/(m + 2*M)")


@pytest.mark.parametrize(("along", "n"), [("right", 1), ("down", 0)])
def test_what_is_pushed_aside_where_it_hangs_straight_is_warned_of(along: str, n: int) -> None:
    """No string holds a bob against F = 5 N sideways, but one that pulls it down it does."""
    system = fb.System.from_text(
        "parameters: {m: 2 kg, F: 5 N, L: 1 m, g: 9.81 m/s^2}\nground: {points: {A: [0, L]}}\n"
        "bodies: {bob: {particle: {mass: m}}}\nconnections: {rope: {string: {from: ground.A, to: bob}}}\n"
        f"loads: {{weight: {{gravity: g}}, push: {{force: {{at: bob, along: {along}, magnitude: F}}}}}}"
    )
    said = [w.text() for w in system.warnings if w.kind == "held aside"]
    assert len(said) == n
    assert all("5 N sideways" in text for text in said)
