"""Gerber beams, slider-cranks and hoists by their numbers, beside hand calculations."""

from __future__ import annotations

from math import asin, cos, radians, sin, sqrt, tan

import pytest

import freebody as fb
from freebody.errors import ModelError


def _value(text: str, question: str) -> float:
    answer = fb.System.from_text(text).solve(question)["q1"]
    assert isinstance(answer.value, float)
    return answer.value


GERBER = """
beam: {length: 8 m, hinges: {G: 5 m}}
supports: {A: {type: fixed, at: 0}, B: {type: roller, at: 8 m}}
loads: [{q: 5 kN/m, from: 3 m, to: 6 m}, {P: 10 kN, x: 6.5 m}]
"""


def test_reactions_of_a_gerber_beam() -> None:
    """The part behind the hinge is a beam on two supports; what it leaves on the hinge loads the cantilever."""
    on_right, force = 5e3 * 1, 10e3
    support = (on_right * 0.5 + force * 1.5) / 3
    hinge = on_right + force - support
    assert _value(GERBER, "vertical reaction of B") == pytest.approx(support)
    assert abs(_value(GERBER, "moment of A")) == pytest.approx(5e3 * 2 * 4 + hinge * 5)
    assert _value(GERBER, "vertical reaction of A") == pytest.approx(5e3 * 2 + hinge)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("{G: 5 m}", "{G: 9 m}", "between the ends"),
        ("{G: 5 m}", "{G: 5 kg}", "must be a length"),
        ("q: 5 kN/m", "q: [0, 5 kN/m]", "runs over a hinge"),
        ("{P: 10 kN, x: 6.5 m}", "{M: 10 kN m, x: 5 m}", "side of its hinges"),
    ],
)
def test_gerber_beams_that_cannot_be_read(old: str, new: str, said: str) -> None:
    with pytest.raises(ModelError, match=said):
        fb.System.from_text(GERBER.replace(old, new))


def test_speed_of_a_piston() -> None:
    """x = r cos(phi) + sqrt(l^2 - r^2 sin^2(phi))."""
    r, n, phi = 0.05, 1000 * 2 * 3.141592653589793 / 60, radians(30)
    text = "slider_crank: {crank: 50 mm, rod: {length: 20 cm}, rpm: 1000, angle: 30 deg, piston: 0.5 kg}"
    root = sqrt(0.2**2 - (r * sin(phi)) ** 2)
    wanted = -r * sin(phi) * n * (1 + r * cos(phi) / root)
    assert _value(text, "velocity of x") == pytest.approx(wanted)


def test_static_torque_of_a_slider_crank_with_an_offset() -> None:
    """A force on the piston to the left, without masses: by virtual power M phi' - F x' = 0."""
    r, rod, e, phi = 0.05, 0.2, 0.02, radians(40)
    theta = asin((e - r * sin(phi)) / rod)
    slope = -r * sin(phi) + r * cos(phi) * tan(theta)
    text = "slider_crank: {crank: 5 cm, rod: 20 cm, offset: 2 cm, angle: 40 deg, force: 800 N, speed: 1 rad/s}"
    assert _value(text, "driving torque of drive") == pytest.approx(800 * slope)


def test_hoists() -> None:
    """J a/R = M - R S, m a = S - m g; on the slope with the weight and the friction along it."""
    J, R, m, M, g = 2.0, 0.2, 50.0, 150.0, 9.81
    hoist = "hoist: {radius: 0.2 m, inertia: 2 kg m^2, torque: 150 N m, load: 50 kg}"
    assert _value(hoist, "acceleration of s") == pytest.approx((M / R - m * g) / (m + J / R**2))
    winch = "winch: {radius: 0.2 m, inertia: 2 kg m^2, torque: 150 N m, load: 50 kg, angle: 30 deg, mu: 0.1}"
    down = m * g * (sin(radians(30)) + 0.1 * cos(radians(30)))
    assert _value(winch, "acceleration of s") == pytest.approx((M / R - down) / (m + J / R**2))
    two = "hoist: {radius: 0.2 m, inertia: 2 kg m^2, load: {mass: 50 kg}, counterweight: {mass: 40 kg, radius: 0.3 m}}"
    alpha = (40 * 0.3 - 50 * 0.2) * g / (J + 50 * 0.04 + 40 * 0.09)
    assert _value(two, "acceleration of s") == pytest.approx(0.2 * alpha)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("slider_crank: {crank: 5 cm, rod: 20 cm, rpm: 100, torque: 3 N m}", "both drive the crank"),
        ("slider_crank: {crank: 5 cm, speed: 100 rpm}", "needs the lengths of rod"),
        ("slider_crank: {crank: 5 cm, rod: 20 cm, gear: 3}", "a slider-crank has no gear"),
        ("hoist: {radius: 0.2 kg, load: 50 kg}", "radius must be a length"),
        ("hoist: {radius: 0.2 m}", "a hoist needs a load"),
        ("hoist: {radius: 0.2 m, load: 5 kg, mu: 0.2}", "without angle"),
    ],
)
def test_machines_that_cannot_be_read(text: str, said: str) -> None:
    with pytest.raises(ModelError, match=said):
        fb.System.from_text(text)


def test_a_load_of_a_gerber_beam_that_is_told_from_the_right() -> None:
    """The same load as the one that is told from the left, an even one and one that rises."""
    told = (
        ("q: 5 kN/m, from: 3 m, to: 6 m", "q: 5 kN/m, from: 6 m, to: 3 m"),
        ("q: [5 kN/m, 2 kN/m], from: 1 m, to: 4 m", "q: [2 kN/m, 5 kN/m], from: 4 m, to: 1 m"),
    )
    for both in told:
        left, right = (_value(GERBER.replace(told[0][0], load), "moment of A") for load in both)
        assert left == pytest.approx(right, rel=1e-12)


def test_a_slider_crank_at_its_dead_centre() -> None:
    """x'' = -r w^2 (1 + r/l) where crank and rod are in line."""
    text = "slider_crank: {crank: 50 mm, rod: 200 mm, speed: 100 rad/s, angle: 0 deg}\n"
    assert _value(text, "acceleration of x at start") == pytest.approx(-0.05 * 100**2 * (1 + 50 / 200))
